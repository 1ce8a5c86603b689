"""A diverging loop ends at the right sample and names it, in single runs and in lanes."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from stages import PERIOD, control, make, stage, with_axis

import contourlab as cl
from contourlab.geometry import Line
from contourlab.loop import simulate_blocks


def runaway(following_error: float = 1e-3, velocity_gain: float = 6e3) -> tuple[cl.Machine, cl.Controller]:
    """Return a loop whose y axis is unstable."""
    machine = stage(drive=make("drive", "saturation"), friction=make("friction", "none"), sensor=make("sensor", "ideal"))
    controller = control(coupled=False)
    wild = controller.axes["y"].controller.replace(velocity_gain=velocity_gain)
    axes = {**controller.axes, "y": cl.AxisController(wild, controller.axes["y"].velocity)}
    limited = with_axis(machine, "y", limits=cl.Limits(following_error=following_error))
    return limited, cl.Controller(axes)


def test_sample_time_and_axis_are_named(circle: cl.Reference) -> None:
    machine, controller = runaway()
    with pytest.raises(cl.DivergenceError) as caught:
        cl.simulate(machine, controller, circle)
    found = caught.value
    # A run without the limit shows independently when 1 mm is first exceeded.
    free, _ = runaway(math.inf)
    status: Any = cl.simulate(free, controller, circle, on_failure="return")
    gap = np.abs(status["reference"][:, 1] - status["axis_position"][:, 1])
    assert found.sample == int(np.argmax(gap > 1e-3))
    assert found.axis == "y"
    assert found.time == pytest.approx(found.sample * PERIOD)
    assert "1 mm" in str(found) and "following error" in str(found)


def test_the_result_up_to_the_failure_is_available(circle: cl.Reference) -> None:
    machine, controller = runaway()
    result = cl.simulate(machine, controller, circle, on_failure="return")
    assert not result.status.ok
    assert result.n_sample == result.status.sample + 1
    gap = np.abs(result["reference"] - result["axis_position"])[:, 1]
    assert gap[-1] > 1e-3 >= gap[:-1].max()


def test_non_finite_values_end_the_run(circle: cl.Reference) -> None:
    machine, controller = runaway(1e308, 1e9)
    result = cl.simulate(machine, controller, circle, on_failure="return")
    assert not result.status.ok
    assert "not finite" in result.status.reason
    assert np.isfinite(result["axis_position"][:-1]).all()


@pytest.mark.parametrize("block", [1, 10, 4096])
def test_the_sample_does_not_depend_on_the_block(block: int, circle: cl.Reference) -> None:
    machine, controller = runaway()
    sample = cl.simulate(machine, controller, circle, on_failure="return").status.sample
    *_, (last, status) = simulate_blocks(machine, controller, circle, block=block)
    assert (status.sample, status.axis) == (sample, "y")
    assert len(last["axis_position"]) == sample % block + 1


def test_lanes_fail_independently_and_at_the_same_sample(circle: cl.Reference) -> None:
    machine, controller = runaway()
    gains = np.array([60.0, 6000.0, 5000.0, 70.0])
    name = "controller.axes.y.controller.velocity_gain"
    batch = cl.simulate_batch(machine, controller, circle, {name: gains})
    assert (batch.failed_at >= 0).tolist() == [False, True, True, False]
    assert np.isfinite(batch.figures["contour_error_rms"][[0, 3]]).all()
    assert np.isnan(batch.figures["contour_error_rms"][[1, 2]]).all()
    assert batch.failed_at[1] == cl.simulate(machine, controller, circle, on_failure="return").status.sample


def test_plain_python_fails_at_the_same_sample(circle: cl.Reference) -> None:
    machine, controller = runaway()
    runs = [cl.simulate(machine, controller, circle, jit=jit, on_failure="return").status for jit in (True, False)]
    assert runs[0].sample == runs[1].sample and runs[0].axis == runs[1].axis


def test_invalid_settings_are_refused(machine: cl.Machine, controller: cl.Controller, circle: cl.Reference) -> None:
    with pytest.raises(cl.ContourlabError, match=r"axes\.x\.plant\.grain"):
        cl.simulate_batch(machine, controller, circle, {"axes.x.plant.grain": [1.0]})
    with pytest.raises(cl.ContourlabError, match="lengths"):
        cl.simulate_batch(machine, controller, circle, {"axes.x.plant.gain": [1.0, 2.0], "axes.y.plant.gain": [1.0]})
    for bad in (-1.0, math.nan):
        with pytest.raises(cl.ContourlabError, match="gain"):
            cl.simulate_batch(machine, controller, circle, {"axes.x.plant.gain": [1.0, bad]})
    with pytest.raises(cl.ContourlabError, match="keep"):
        cl.simulate_batch(machine, controller, circle, {"axes.x.plant.gain": [1.0]}, keep=("postion",))
    with pytest.raises(cl.ContourlabError, match="coordinates"):
        cl.simulate(machine, controller, cl.uniform(_circle_in_space(), 1.0, 1, PERIOD))
    with pytest.raises(cl.ContourlabError, match="axis y"):
        cl.simulate(machine, cl.Controller({"x": controller.axes["x"]}), circle)
    with pytest.raises(cl.ContourlabError, match="signals"):
        cl.simulate(machine, controller, circle, signals=("postion",))


def _circle_in_space() -> cl.Path:
    corners = [(0.0, 0.0, 0.0), (0.01, 0.0, 0.0), (0.01, 0.01, 0.01), (0.0, 0.0, 0.0)]
    return cl.Path([Line(a, b) for a, b in pairwise(corners)], closed=True)
