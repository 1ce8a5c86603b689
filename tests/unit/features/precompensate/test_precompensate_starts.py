"""Cuts that begin while the axes still settle."""

import numpy as np
import pytest

from contourlab.features.precompensate.law import Learned, Run, forgotten
from contourlab.features.precompensate.reading import Contour, contour_of, parse_blocks
from contourlab.features.precompensate.runs import Measured, run_of
from contourlab.features.precompensate.starts import LONGEST, UNKNOWN, Start, lag_of, settling_time, starts_of, without
from contourlab.program import Reading

PERIOD = 1e-3
PART = "G21 G90 G64 P0.002\nG0 X10 Y0\nG1 X10 Y10 F1200\nG0 X0 Y0\nM2\n"


def contour(text: str = PART) -> Contour:
    return contour_of(parse_blocks(text, "part", Reading(require_end=False), ("x", "y")), ("x", "y"), PERIOD)


def commands(rest: int) -> np.ndarray:
    """Return the command of the part: a rapid of 10 mm, a rest, a cut of 10 mm, and a rapid back."""
    rapid, cut = np.linspace(0.0, 0.01, 101), np.linspace(0.0, 0.01, 501)[1:]
    first = np.column_stack([rapid, 0.0 * rapid])
    second = np.column_stack([np.full(500, 0.01), cut])
    back = np.column_stack([rapid[::-1], rapid[::-1]])[1:]
    return np.vstack([first, np.repeat(first[-1:], rest, axis=0), second, back, np.zeros((50, 2))])


@pytest.mark.parametrize(
    ("rest", "offset", "rises", "found"),
    [(30, 40e-6, False, True), (0, 40e-6, False, True), (30, 40e-6, True, False), (30, 1e-6, False, False)],
)
def test_a_cut_that_begins_off_the_path_is_found_by_what_is_off_before_it(rest: int, offset: float, rises: bool, found: bool) -> None:
    command = commands(rest)
    off = np.zeros(len(command))
    begin = 101 + rest
    off[:begin] = 0.0 if rises else offset
    off[begin:] = offset * np.exp(-np.arange(len(command) - begin) / 50.0)
    measured = Measured(PERIOD, command, command, command - np.column_stack([off, 0.0 * off]), "load")
    part = contour()
    run = run_of(part, measured)
    starts = starts_of(part, run, measured, 2e-6)
    assert bool(starts) == found
    for start in starts:
        assert (start.block, start.line) == (1, 3)
        assert start.rest == pytest.approx(rest * PERIOD)
        assert start.error == pytest.approx(offset, rel=0.05)
        assert lag_of(measured)[start.begin - 1] == pytest.approx(offset, rel=0.05)


def test_a_dwell_stands_before_plunge_and_dwell_and_not_before_a_cut_that_goes_on() -> None:
    assert contour("G21 G90\nG0 X10 Z5\nG1 Z-1 F100\nG1 Y10 F1200\nG0 X0\nM2\n").starts == [(1, 1)]
    assert contour("G21 G90\nG1 X10 F1200\nG1 Z1\nG1 Y10\nM2\n").starts == []
    assert contour("G21 G90\nG0 X10\nG4 P0.1\nG1 Y10 F1200\nG81 X20 Z-1 R1\nG80\nG1 X30\nM2\n").starts == [(1, 1), (3, 7)]


def settles(lag: np.ndarray, moves_on: int = 1000) -> float | None:
    """Return the settling time of axes that come to rest with a lag, and move on after some samples."""
    command = np.zeros((1001, 2))
    command[0], command[1 + moves_on :, 1] = -0.1, np.arange(1000 - moves_on) + 1.0
    off = np.column_stack([np.append(0.0, lag), np.zeros(1001)])
    return settling_time(Measured(PERIOD, command, command, command - off, "load"), 2e-6)


def test_the_settling_time_is_the_longest_of_the_rests_that_show_it() -> None:
    lag = 40e-6 * np.exp(-np.arange(1000) / 50.0)
    late = 1.1e-3 + PERIOD  # the first sample of a rest is that of the last step
    assert settles(lag) == pytest.approx(50e-3 * np.log(20.0), abs=late)
    tenth = 0.1 * (lag[1] + 3e-6)
    assert settles(lag + 3e-6) == pytest.approx(50e-3 * np.log(40e-6 / (tenth - 3e-6)), abs=late)
    assert settles(lag + 40e-6) is None  # friction holds half of it
    assert settles(lag, 60) is None  # the rest is too short


@pytest.mark.parametrize(
    ("rest", "settles", "dwell"),
    [(0.03, 0.43, 0.40), (0.03, 0.4333, 0.41), (0.0, None, UNKNOWN), (0.5, 0.43, 0.5), (0.7, None, LONGEST - 0.7), (LONGEST, None, 0.0)],
)
def test_a_dwell_lasts_until_the_axes_have_settled(rest: float, settles: float | None, dwell: float) -> None:
    assert Start(3, 7, 100, rest, 1e-5).dwell(settles) == pytest.approx(dwell)


def test_what_remains_without_the_starts() -> None:
    error = np.full((1000, 1), 3e-6)
    error[100:200] = 50e-6
    moves = np.ones(1000, dtype=bool)
    run = Run(PERIOD, np.linspace(0.0, 1.0, 1000), error, moves, np.ones(1000), 1.0, np.ones(1), np.ones(1), np.zeros_like(error))
    start = Start(0, 1, 100, 0.0, 50e-6)
    assert without(run, [start], 0.1) == (pytest.approx(3e-6), pytest.approx(3e-6))
    assert without(run, [start], 0.05)[1] == pytest.approx(50e-6)
    assert without(run, [Start(0, 1, 0, 0.0, 0.0)], 1.0) == (0.0, 0.0)


def test_what_was_learned_of_a_start_is_forgotten_without_a_jump() -> None:
    nodes, ones = np.linspace(0.0, 1.0, 101), np.ones((101, 2))
    learned = Learned(ones, 2.0 * ones, np.full(101, 1e-12), np.ones(101), ones, np.ones(101), 1e-6)
    left = forgotten(learned, nodes, 0.2, 0.4, 0.6)
    np.testing.assert_allclose(left.kept[:, 0], np.interp(nodes, [0.199, 0.2, 0.4, 0.6], [1.0, 0.0, 0.0, 1.0]), atol=1e-9)
    np.testing.assert_allclose(left.step, 2.0 * left.kept)
    assert (left.error[left.kept[:, 0] < 1.0 - 1e-9] > 1e-9).all()
    assert (left.error[nodes < 0.195] == 1e-12).all()
