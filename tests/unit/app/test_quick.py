"""How much of a study fits into a minute."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest

from contourlab.app import quick
from contourlab.feed import Reference, uniform
from contourlab.geometry import contour
from contourlab.loop.batch import LANES


class Clock:
    """A processor whose time passes in runs only: a fixed time and a time for each sample."""

    def __init__(self, fixed: float, each: float) -> None:
        self.now, self.fixed, self.each = 0.0, fixed, each
        self.runs: list[int] = []

    def run(self, reference: Reference) -> None:
        self.runs.append(reference.n_sample)
        self.now += self.fixed + self.each * reference.n_sample

    def time(self) -> float:
        return self.now


@pytest.mark.parametrize(("fixed", "each", "timed"), [(0.02, 1e-6, [4096, 4096, 20000]), (0.0, 1e-3, [4096, 4096])])
def test_a_short_run_is_timed_whole_and_a_long_one_from_its_beginning(
    fixed: float, each: float, timed: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = Clock(fixed, each)
    monkeypatch.setattr(quick, "process_time", clock.time)
    circle = uniform(contour("circle", radius=0.01), 0.1, 2, 1e-3)
    assert circle.n_sample == 20000
    assert quick.affordable(clock.run, circle, threads=1) == pytest.approx(quick.PLANNED / (fixed + 20000 * each), rel=0.01)
    assert clock.runs == timed
    assert quick.affordable(clock.run, circle, threads=64) == pytest.approx(2.0 * quick.PLANNED / (fixed + 20000 * each), rel=0.01)


@dataclass(frozen=True)
class Batches:
    """A setting that notes the variants of its batches."""

    clock: Clock
    reference: Reference
    widths: list[int] = field(default_factory=list)

    def batch(self, columns: Mapping[str, Any], figures: tuple[str, ...], threads: int) -> None:
        assert (columns["gain"] == 3.0).all() and figures == ("contour_error_max",) and threads == 1
        self.widths.append(len(columns["gain"]))
        self.clock.run(self.reference)


def test_candidates_are_timed_in_batches_without_an_empty_lane(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock(0.02, 1e-6)
    monkeypatch.setattr(quick, "process_time", clock.time)
    setting: Any = Batches(clock, uniform(contour("circle", radius=0.01), 0.1, 2, 1e-3))
    fits = quick.affordable_candidates(setting, {"gain": np.array([3.0])}, ("contour_error_max",), 1)
    assert fits == pytest.approx(LANES * quick.PLANNED / 0.04) and set(setting.widths) == {LANES}


def test_the_beginning_of_a_motion_has_its_samples() -> None:
    circle = uniform(contour("circle", radius=0.01), 1.0, 2, 1e-3)
    part = quick.beginning(circle, 700)
    assert part.n_sample == 700 and part.judged.ranges == ((0, 700),) and part.laps == ()
    assert (part.block(0, 700).position == circle.block(0, 700).position).all()
    assert quick.beginning(circle, 10**6) is circle
