"""Drives at their limit: the integral of a coupling, a learned table, and the order of limit and delay."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from component_rig import make

import contourlab as cl
from contourlab.features.learn import learning_problem
from contourlab.features.learn.trial import record_of
from contourlab.loop.trials import Trials

PERIOD = 1e-3


def stage(
    limit: float = float("inf"), command_limit: float = float("inf"), delay: float = 0.0
) -> tuple[cl.Machine, dict[str, cl.AxisController]]:
    """Two equal axes with a limit in the drive or in the controller."""
    plant = make("plant", "second-order-integrator", dc_gain=0.05, damping_ratio=1.1, natural_frequency=150.0)
    drive = make("drive", "delayed-saturation", limit=limit, delay=delay) if delay else make("drive", "saturation", limit=limit)
    axes = tuple(cl.Axis(name, plant, drive=drive, limits=cl.Limits(following_error=1.0)) for name in "xy")
    part = cl.AxisController(make("controller", "pid", proportional_gain=600.0, command_limit=command_limit))
    return cl.Machine("stage", axes, PERIOD), dict.fromkeys("xy", part)


def coupled(axes: dict[str, cl.AxisController], **gains: float) -> cl.Controller:
    return cl.Controller(axes, make("estimator", "tangent"), make("coupling", "cross-coupled", **gains))


def fast_then_slow() -> cl.Reference:
    """Return one second of an ellipse too fast for the drives, then a slow one."""
    path = cl.contour("ellipse", a=0.02, b=0.01)
    rate = np.concatenate([np.full(1000, 0.4), np.full(1500, 0.01)])
    along = np.concatenate([[0.0], np.cumsum(rate * PERIOD)])
    return cl.Reference.from_samples(path.position(along), PERIOD, path, arc_length=along)


def test_the_integral_of_a_coupling_waits_while_drives_saturate() -> None:
    machine, axes = stage(limit=1.0)
    reference, errors = fast_then_slow(), {}
    for rate in (0.0, 30.0):
        run = cl.judge(cl.simulate(machine, coupled(axes, gain=1000.0, integral_rate=rate), reference), reference)
        errors[rate] = np.abs(run["contour_error"][1800:]).max()
    assert errors[30.0] < 1.5 * errors[0.0] + 1e-5


def test_below_the_limits_the_integral_is_unchanged() -> None:
    """A drive without limit, and one that never reaches its limit, give the same run."""
    path = cl.contour("ellipse", a=0.02, b=0.01)
    reference = cl.uniform(path, 0.2, 1, PERIOD)
    free, axes = stage()
    wide, _ = stage(limit=50.0)
    runs = [cl.simulate(machine, coupled(axes, gain=1000.0, integral_rate=30.0), reference)["axis_position"] for machine in (free, wide)]
    np.testing.assert_array_equal(*runs)


def test_the_limit_comes_before_the_delay() -> None:
    """A pulse of 30 V for two ticks, limited to 10 V and delayed by 2.5 periods, acts as 10 V for two periods."""
    machine, _ = stage(limit=10.0, delay=2.5e-3)
    drive: Any = machine.axis("x").drive

    from contourlab.engine.runner import make_group
    from contourlab.engine.step import Node, Schedule

    node = Node("drive", drive.make_step(), {"command": "in.command"}, drive.block(PERIOD), ring_length=drive.ring_length(PERIOD))
    schedule = Schedule((node,), node.step.inputs, PERIOD, 1)
    command = np.zeros((12, 1))
    command[3:5] = 30.0
    applied = make_group(schedule, 1, slice(0, 1), False).run(command, [schedule.row("drive.applied")])[:, 0, 0]
    np.testing.assert_allclose(applied, [0, 0, 0, 0, 0, 5, 10, 5, 0, 0, 0, 0])


@pytest.mark.slow
@pytest.mark.parametrize("where", ["drive", "controller"])
@pytest.mark.parametrize(
    ("kind", "gains"), [("p-type", {"gain": 200.0, "bandwidth": 120.0}), ("zero-phase", {"gain": 0.4, "half_width": 8})]
)
def test_a_table_does_not_wind_up_with_the_limit_in_drive_or_controller(where: str, kind: str, gains: dict[str, float]) -> None:
    machine, axes = stage(**{"limit" if where == "drive" else "command_limit": 0.8})
    reference, controller = cl.uniform(cl.contour("ellipse", a=0.02, b=0.01), 0.8, 1, PERIOD), cl.Controller(axes)
    law = make("learning", kind, **gains)
    trials = Trials(machine, controller, reference)
    problem = learning_problem(machine, controller, reference, "command", trials.arc_length)
    table = nothing = np.zeros((reference.n_sample, 2))
    for i in range(40):
        run = trials.run(table, i)
        assert run.excess.any()
        table = law.update(table, record_of(run, trials, table, nothing), problem)
    assert np.abs(table).max() < 2 * 0.8
