"""The picture of an interpolated encoder."""

from __future__ import annotations

import numpy as np
import pytest

from contourlab.features.interpolate.command import error_chart, lissajous_png


def picture(gap: bool = False) -> bytes:
    turn = np.linspace(0.0, 40.0, 20_000)
    circle = np.column_stack([np.cos(turn), np.sin(turn)])
    phase = np.arange(0.5, 360.0)
    error = 100.0 * np.sin(np.radians(phase))
    before = np.where(phase < 90.0, np.nan, error) if gap else error
    errors = error_chart("$1_a$.csv", phase, {"a": before, "b": 0.01 * error})
    return lissajous_png("$1_a$.csv", (0.9 * circle + 0.1, circle), errors)


@pytest.mark.slow
def test_the_same_data_give_the_same_bytes() -> None:
    one, other = picture(), picture()
    assert one == other
    assert one.startswith(b"\x89PNG") and len(one) > 20_000


def test_phases_without_samples_leave_a_gap() -> None:
    assert picture(gap=True) != picture()
