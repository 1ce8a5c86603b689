"""What a log shows of the causes of its error, against tools that follow a known law."""

from __future__ import annotations

import numpy as np
import pytest

from contourlab.arrays import Array
from contourlab.features.measure.study import Measured, measure
from contourlab.feed import AxisLimits, blended, plan, route_from_program
from contourlab.feed.reference import Reference
from contourlab.program import parse_program
from contourlab.result import Result, Signal

PERIOD = 1e-3
ROUTE = route_from_program(parse_program("G21 G17 G90 G64 P0.02\nF3000\nG0 X0 Y0\nG1 X30\nG3 X30 Y40 J20\nG1 X0 Y20\nM2\n"), ("x", "y"))
LIMITS = AxisLimits([0.2] * 2, [2.0] * 2, [100.0] * 2)


@pytest.fixture(scope="module")
def planned() -> Reference:
    return plan(blended(ROUTE, LIMITS), LIMITS, PERIOD)


def late(asked: Array, lags: tuple[float, ...]) -> Array:
    """Return positions (n, n_axis) that follow with a lag [s] each, integrated exactly over straight pieces of the command."""
    tool = asked.copy()
    for axis, lag in enumerate(lags):
        kept = np.exp(-PERIOD / lag)
        for k in range(1, len(asked)):
            rise = (asked[k, axis] - asked[k - 1, axis]) / PERIOD
            start = asked[k - 1, axis] - rise * lag
            tool[k, axis] = start + rise * PERIOD + (tool[k - 1, axis] - start) * kept
    return tool


def measured(reference: Reference, tool: Array) -> Measured:
    of_axes = {"reference": reference.block(0, reference.n_sample).position, "position": tool}
    signals = {name: Signal(data, ("sample", "axis"), "m") for name, data in of_axes.items()}
    return measure(Result("log", ("x", "y"), PERIOD, signals), ROUTE, tolerance=1e-6)


def causes_of(run: Measured) -> dict[str, float]:
    assert run.verdict is not None
    assert sum(cause.contribution for cause in run.verdict.causes) == pytest.approx(run.verdict.worst.value, rel=1e-9)
    assert sum(cause.share for cause in run.verdict.causes) == pytest.approx(1.0)
    return {cause.name: cause.contribution for cause in run.verdict.causes}


@pytest.mark.parametrize("lags", [(4e-3, 4e-3), (4e-3, 5e-3)])
def test_lag_and_mismatch_are_those_of_copies_of_the_axes(planned: Reference, lags: tuple[float, float]) -> None:
    """Against a simulation in which both axes are copies of one of them, as the causes of a simulated run are found."""
    asked = planned.block(0, planned.n_sample).position
    run = measured(planned, late(asked, lags))
    found, sample = causes_of(run), run.verdict.worst.sample  # type: ignore[union-attr]
    path, at = run.reference.programmed, run.result["foot_arc_length"][sample]
    off = run.result["tool_position"][sample] - path.position([at])[0]

    def along_it(place: Array) -> float:
        foot = path.foot_point(place[None], np.array([at]), 1e-3)
        return float((place - foot.position[0]) @ off / np.linalg.norm(off))

    alike = np.mean([along_it(late(asked, (lag, lag))[sample]) for lag in lags])
    planning = along_it(asked[sample])
    assert found["planning"] == pytest.approx(planning, abs=1e-9)
    size = np.linalg.norm(off)
    assert found["lag"] == pytest.approx(alike - planning, abs=0.05 * size)
    assert found["servo mismatch"] == pytest.approx(size - alike, abs=0.05 * size)
    rest = [value for name, value in found.items() if name not in ("planning", "lag", "servo mismatch")]
    assert len(rest) == 1 and abs(rest[0]) < 0.05 * size


def test_what_no_lag_explains_is_named_by_what_came_before(planned: Reference) -> None:
    """A bump of 30 um on y: soon after x has reversed on the arc, and in the middle of the first line."""
    asked = planned.block(0, planned.n_sample).position
    tool, x = late(asked, (4e-3, 4e-3)), asked[:, 0]
    turn, middle = int(np.argmax(x)), int(np.argmax(x > 0.015))
    for sample, way, name in ((turn + 40, 0, "reversal"), (middle, 1, "rest")):
        bump = np.zeros_like(tool)
        bump[:, way] = 30e-6 * np.exp(-(((np.arange(len(tool)) - sample) / 10.0) ** 2))
        found = causes_of(measured(planned, tool + bump))
        assert max(found, key=lambda cause: found[cause]) == name
        assert found[name] == pytest.approx(30e-6, rel=0.1)


def test_axes_that_are_no_loop_lag_alike_at_one_speed(planned: Reference) -> None:
    """At one speed friction and lag look alike: the log is taken for a lag, and an axis at rest for none."""
    way = np.linspace(0.0, 0.03, 1000)
    asked = np.column_stack([way, 0.0 * way])
    tool = asked - [1e-4, 0.0]
    tool[500:520, 1] += 20e-6
    signals = {name: Signal(data, ("sample", "axis"), "m") for name, data in (("reference", asked), ("position", tool))}
    run = measure(Result("log", ("x", "y"), PERIOD, signals), tolerance=1e-6)
    found = causes_of(run)
    assert found.pop("rest") == pytest.approx(20e-6, rel=0.05)
    assert all(abs(value) < 1e-6 for value in found.values())
