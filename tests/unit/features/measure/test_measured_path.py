"""The place of a measured tool on its path: closed paths, crossings, laps, ways back, and partial runs."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from contourlab.errors import ResultError
from contourlab.features.measure.measured_path import fitted_shift, progress_along
from contourlab.geometry import Arc, Line, Path


def lines(*corners: tuple[float, float]) -> Path:
    return Path([Line(a, b) for a, b in itertools.pairwise(corners)])


def turn(centre: tuple[float, float], sweep: float, begin: float) -> Arc:
    return Arc(np.array(centre), 0.02, begin, sweep)


PATHS = {
    "closed": lines((0.0, 0.0), (0.04, 0.0), (0.04, 0.03), (0.0, 0.03), (0.0, 0.0)),
    "three laps": Path([turn((0.0, 0.0), 2.0 * np.pi, 0.0)] * 3),
    "there and back": lines((0.0, 0.0), (0.04, 0.0), (0.0, 0.0), (0.0, 0.03)),
    "eight": Path([turn((0.02, 0.0), 2.0 * np.pi, np.pi), turn((-0.02, 0.0), -2.0 * np.pi, 0.0)]),
    "rows": lines(*[(0.04 * ((k + 1) // 2 % 2), 2e-4 * (k // 2)) for k in range(40)]),
}


def tool_on(path: Path, part: tuple[float, float], late: float) -> tuple[np.ndarray, np.ndarray]:
    """Return arc lengths of a part of the path, with rests at both ends, and a tool 10 um off the path that lags along the tangent."""
    along = np.linspace(part[0] * path.length, part[1] * path.length, 6000)
    along = np.concatenate([np.full(500, along[0]), along, np.full(500, along[-1])])
    noise = np.random.default_rng(3).normal(0.0, 0.3e-6, (along.size, 2))
    return along, path.position(along) + 10e-6 * path.normal(along) - late * path.tangent(along) + noise


@pytest.mark.slow
@pytest.mark.parametrize("late", [0.0, 50e-6, -80e-6])
@pytest.mark.parametrize("part", [(0.0, 1.0), (0.0, 0.55), (0.3, 1.0)])
@pytest.mark.parametrize("name", PATHS)
def test_progress_stays_on_its_branch(name: str, part: tuple[float, float], late: float) -> None:
    """Nearness is ambiguous: the end of a closed path is as near to the first sample as its start; so are laps, crossings and ways back."""
    along, tool = tool_on(PATHS[name], part, late)
    found, _ = progress_along(PATHS[name], tool)
    assert np.abs(found - along).max() < abs(late) + 100e-6
    assert (np.diff(found) >= 0.0).all()


@pytest.mark.parametrize("part", [(0.0, 1.0), (0.0, 0.6)])
@pytest.mark.parametrize("name", ["three laps", "eight", "rows"])
def test_a_shift_is_found_from_a_partial_run_too(name: str, part: tuple[float, float]) -> None:
    """On these paths 10 um to the left is no shift, except for the part that the normals do not average out; rests have no weight."""
    _, tool = tool_on(PATHS[name], part, 20e-6)
    rest = np.repeat(tool[-1:], 5000, axis=0)
    assert fitted_shift(PATHS[name], np.vstack([tool, rest]) + np.array([0.1, -0.05])) == pytest.approx([0.1, -0.05], abs=11e-6)


def test_a_shift_is_found_where_the_log_begins_with_the_cut() -> None:
    closed = PATHS["closed"]
    path = Path([Line((-0.3, 0.2), (0.0, 0.0)), *closed.curves])
    tool = closed.position(np.linspace(0.0, closed.length, 4000)) + np.array([0.1, -0.05])
    assert fitted_shift(path, tool, is_commanded=True, cut=float(path.breaks[1])) == pytest.approx([0.1, -0.05], abs=1e-9)
    with pytest.raises(ResultError):
        fitted_shift(path, tool, is_commanded=True)


def test_a_tool_far_from_the_path() -> None:
    path = PATHS["closed"]
    _, tool = tool_on(path, (0.0, 1.0), 0.0)
    for wrong in (tool + 0.01, tool * 1e3, tool[:, ::-1]):
        with pytest.raises(ResultError, match=r"coordinates.*units"):
            progress_along(path, wrong)


def test_a_straight_partial_run_does_not_determine_the_shift_along_it() -> None:
    _, tool = tool_on(PATHS["there and back"], (0.0, 0.5), 0.0)
    with pytest.raises(ResultError, match="straight"):
        fitted_shift(PATHS["there and back"], tool + 0.3)


@pytest.mark.parametrize("cut", [1e-4, 4e-4])
def test_a_tool_that_turns_before_the_end_of_a_spike_is_followed(cut: float) -> None:
    """As a control does that blends a way back: it is never near the last part of the spike."""
    path = lines((0.0, 0.0), (0.01, 0.0), (0.002, 0.0), (0.002, 0.008))
    along = np.linspace(0.0, path.length, 4000)
    along = along[np.abs(along - 0.01) > cut]
    progress, _ = progress_along(path, path.position(along))
    assert np.abs(progress - along)[np.abs(along - 0.01) > 4.0 * cut].max() < 1e-4
