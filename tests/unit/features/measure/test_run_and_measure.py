"""A result that is saved and measured has the figures of its run: where the tool leads or lags at the ends, too."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path as File

import numpy as np
import pytest

import contourlab as cl
from contourlab.arrays import Array
from contourlab.features.measure.study import Measured, measure
from contourlab.feed import AxisLimits, blended, plan, route_from_program, uniform
from contourlab.feed.reference import Reference
from contourlab.geometry import Line, Path
from contourlab.metrics.figures import Metrics, summarise
from contourlab.metrics.judge import judge
from contourlab.program import parse_program
from contourlab.result import Result, Signal, Status

PERIOD = 1e-3
SQUARE = np.array([[0.0, 0.0], [0.02, 0.0], [0.02, 0.02], [0.0, 0.02], [0.0, 0.0]])
CONTOURS = {
    "square": Path(Line.many(SQUARE[:-1], SQUARE[1:]), closed=True),
    "circle": cl.contour("circle", radius=0.01),
    "lemniscate": cl.contour("lemniscate", a=0.02),
}
PROGRAMS = {
    "square": "G61\nF2000\nG0 X0 Y0\nG1 X20\nY20\nX0\nY0\nM2\n",
    "rounded": "G64 P0.05\nF4000\nG0 X0 Y0\nG1 X30 Y10\nX40 Y-5\nM2\n",
    "circle": "F3000\nG0 X0 Y0\nG2 X0 Y0 I10\nM2\n",
}


def figures(reference: Reference, tool: Array, folder: File) -> tuple[Metrics, Measured]:
    """Return the figures of a run whose tool is at some positions, and those of its file."""
    block = reference.block(0, reference.n_sample)
    of_axes = {
        "reference": (block.position, "m"),
        "reference_velocity": (block.velocity, "m/s"),
        "reference_acceleration": (block.acceleration, "m/s^2"),
        "position": (tool, "m"),
        "tool_position": (tool, "m"),
    }
    signals = {name: Signal(data, ("sample", "axis"), unit) for name, (data, unit) in of_axes.items()}
    signals["arc_length"] = Signal(block.arc_length, ("sample",), "m")
    signals["feedrate"] = Signal(block.feedrate, ("sample",), "m/s")
    run = judge(Result("base", ("x", "y"), PERIOD, signals, Status(True, -1, "", "")), reference)
    replace(run, attributes={"judged": reference.judged.text}).save(folder / "run.nc")
    return summarise(run, reference), measure(Result.load(folder / "run.nc"))


def assert_alike(wanted: Metrics, found: Metrics, chord: float) -> None:
    """The path through the samples cuts corners by no more than `chord` [m]."""
    for figure in ("max", "rms"):
        assert getattr(found.contour_error, figure) == pytest.approx(getattr(wanted.contour_error, figure), abs=chord)
    assert found.judged_time == wanted.judged_time and found.basis == wanted.basis


@pytest.mark.parametrize("lead", [3e-4, 0.0, -3e-4])
@pytest.mark.parametrize("laps", [1, 2])
@pytest.mark.parametrize("name", CONTOURS)
def test_laps_that_begin_and_end_in_motion(name: str, laps: int, lead: float, tmp_path: File) -> None:
    """A tool that leads is beyond the last sample of the reference, and one that lags before the first: on a lap, on the path."""
    path = CONTOURS[name]
    reference = uniform(path, 1.0, laps, PERIOD)
    place = np.mod(reference.block(0, reference.n_sample).arc_length + lead, path.length)
    wanted, found = figures(reference, 1.001 * path.position(place), tmp_path)
    step = path.length * PERIOD
    assert_alike(wanted, found.metrics, 1e-12 if name == "square" else step**2 * np.abs(path.curvature(place)).max() / 8.0)
    assert "CL408" not in {note.code for note in found.findings}


@pytest.mark.parametrize("name", PROGRAMS)
def test_part_programs(name: str, tmp_path: File) -> None:
    route = blended(route_from_program(parse_program("G21 G17 G90\n" + PROGRAMS[name]), ("x", "y")))
    limits = AxisLimits([0.2] * 2, [2.0] * 2, [100.0] * 2)
    reference = plan(route, limits, PERIOD)
    asked = reference.block(0, reference.n_sample).position
    tool, state = np.empty_like(asked), asked[0]
    for k, wanted in enumerate(asked):  # lags by 5 ms
        state = state + (wanted - state) * PERIOD / 5e-3
        tool[k] = state
    of_run, found = figures(reference, tool, tmp_path)
    assert of_run.contour_error.max > 1e-6
    fastest = np.linalg.norm(reference.block(0, reference.n_sample).acceleration, axis=1).max()
    assert_alike(of_run, found.metrics, fastest * PERIOD**2 / 8.0)


def test_samples_off_the_ends_of_an_open_path_do_not_count(tmp_path: File) -> None:
    """The path of such a log ends at its last sample: a finding says how many are left out, and no figure has them."""
    reference = uniform(CONTOURS["circle"], 1.0, 1, PERIOD)
    cut = slice(100, 400)
    block = reference.block(0, reference.n_sample)
    lead = CONTOURS["circle"].position(np.mod(block.arc_length + 3e-4, CONTOURS["circle"].length))
    signals = {"reference": Signal(block.position[cut], ("sample", "axis"), "m"), "position": Signal(lead[cut], ("sample", "axis"), "m")}
    found = measure(Result("log", ("x", "y"), PERIOD, signals, Status(True, -1, "", ""), {"judged": "whole motion: 0-300"}))
    (left_out,) = [note for note in found.findings if note.code == "CL408"]
    assert found.metrics.contour_error.max < 1e-7
    assert found.metrics.judged_time == pytest.approx((300 - left_out.values["samples"]) * PERIOD, abs=1.5 * PERIOD)


def test_a_log_that_begins_and_ends_in_motion_has_the_same_contour_error_with_its_program() -> None:
    """Where the tool is before the first command, its distance is lag, whatever the path is known from."""
    route = route_from_program(parse_program("G21 G17 G90\n" + PROGRAMS["circle"]), ("x", "y"))
    reference = plan(route, AxisLimits([0.2] * 2, [2.0] * 2, [100.0] * 2), PERIOD)
    asked = reference.block(0, reference.n_sample).position[400:900]
    late = reference.block(0, reference.n_sample).position[395:895]
    signals = {name: Signal(data, ("sample", "axis"), "m") for name, data in (("reference", asked), ("position", late))}
    log = Result("log", ("x", "y"), PERIOD, signals)
    alone, along = measure(log), measure(log, route)
    assert along.metrics.contour_error.max == alone.metrics.contour_error.max < 1e-7
    assert [note.values for note in along.findings] == [note.values for note in alone.findings] == [{"samples": 5}]
