"""The picture of an interpolated encoder."""

from __future__ import annotations

import numpy as np

from contourlab.features.interpolate.text import LissajousData, lissajous_png


def data(gap: bool = False) -> LissajousData:
    turn = np.linspace(0.0, 40.0, 20_000)
    circle = np.column_stack([np.cos(turn), np.sin(turn)])
    phase = np.arange(0.5, 360.0)
    error = 100.0 * np.sin(np.radians(phase))
    return LissajousData(
        "$1_a$.csv", 0.9 * circle + 0.1, circle, phase, np.where(phase < 90.0, np.nan, error) if gap else error, 0.01 * error, ("a", "b")
    )


def test_the_same_data_give_the_same_bytes() -> None:
    one, other = lissajous_png(data()), lissajous_png(data())
    assert one == other
    assert one.startswith(b"\x89PNG") and len(one) > 20_000


def test_phases_without_samples_leave_a_gap() -> None:
    assert lissajous_png(data(gap=True)) != lissajous_png(data())
