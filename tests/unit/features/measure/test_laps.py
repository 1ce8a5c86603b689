"""The last lap is found, or none if the path does not repeat itself to its end."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from contourlab.features.measure.measured_path import last_lap, path_of_samples
from contourlab.features.measure.study import measure
from contourlab.result import Result, Signal

Array = NDArray[np.float64]


def round_trips(laps: float, n: int = 1000) -> Array:
    angle = np.linspace(0.0, 2.0 * np.pi * laps, round(n * laps) + 1)
    return 0.02 * np.column_stack([np.cos(angle), np.sin(angle)])


@pytest.mark.parametrize("laps", [2.0, 2.5, 4.0])
def test_the_last_lap_begins_where_the_last_but_one_ends(laps: float) -> None:
    place = round_trips(laps)
    assert last_lap(*path_of_samples(place)) == pytest.approx(len(place) - 1 - 1000, abs=2)


def test_a_line_there_and_back_is_one_lap() -> None:
    there = np.column_stack([np.linspace(0.0, 0.1, 500), np.zeros(500)])
    one = np.vstack([there, there[-2::-1]])
    assert last_lap(*path_of_samples(one)) is None
    assert last_lap(*path_of_samples(np.vstack([one, one[1:]]))) == pytest.approx(len(one), abs=2)


@pytest.mark.parametrize("place", [round_trips(1.0), round_trips(1.7), round_trips(3.0) * np.linspace(1.0, 1.2, 3001)[:, None]])
def test_a_path_without_repetition_has_no_lap(place: Array) -> None:
    assert last_lap(*path_of_samples(place)) is None


def test_figures_of_the_last_lap_are_reported_next_to_those_of_the_whole_run() -> None:
    """A tool 10 um outside that begins a lap 100 um inside: the whole run gives 100 um, its last lap 10 um."""
    wanted = round_trips(2.0)
    off = np.where(np.arange(len(wanted)) < 200, -100e-6, 10e-6)
    held = {"position": wanted * (1.0 + off / 0.02)[:, None], "reference": wanted}
    signals = {name: Signal(data, ("sample", "axis"), "m") for name, data in held.items()}
    found = measure(Result("bench", ("x", "y"), 1e-3, signals))
    assert found.metrics.contour_error.max == pytest.approx(100e-6, rel=0.02)
    (lap,) = (one.values for one in found.findings if one.code == "CL409")
    assert lap == {"time": pytest.approx(1.0, abs=0.01), "rms": pytest.approx(10e-6, rel=0.02), "largest": pytest.approx(10e-6, rel=0.02)}
