"""Gains in LinuxCNC's terms: its law, fed with the signals of our controller, gives the command of our controller."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from each import each
from tuned_axes import circle, position_control, rigid_stage

from contourlab.components.contract import Component
from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.lead_lag import LeadLag
from contourlab.components.controller.pid import PID, SpeedPID
from contourlab.components.controller.position import PositionController
from contourlab.components.controller.state_feedback import StateFeedback
from contourlab.components.feedforward.laws import InverseDynamics
from contourlab.features.tune.drive_terms import LinuxCNCGains, drive_terms, law_difference, linuxcnc_gains, linuxcnc_law
from contourlab.loop import AxisController, Controller, simulate


def made(part: Component, **slots: Any) -> Controller:
    return Controller({name: AxisController(part, **slots) for name in ("x", "y")})


def straight_from_the_manual(gains: LinuxCNCGains, command: list[float], feedback: list[float], period: float) -> list[float]:
    """Return the command by the equations of the manual page, sample by sample."""
    found, total = [], 0.0
    before = {"command": command[0], "feedback": feedback[0], "rate": 0.0, "second": 0.0}
    for to, at in zip(command, feedback, strict=True):
        error = to - at
        total += error * period
        rate, back = (to - before["command"]) / period, (at - before["feedback"]) / period
        second = (rate - before["rate"]) / period
        third = (second - before["second"]) / period
        found.append(
            gains.p * error
            + gains.i * total
            + gains.d * (rate - back)
            + gains.ff0 * to
            + gains.ff1 * rate
            + gains.ff2 * second
            + gains.ff3 * third
        )
        before = {"command": to, "feedback": at, "rate": rate, "second": second}
    return found


def test_the_law_is_that_of_the_manual() -> None:
    rng = np.random.default_rng(3)
    command, feedback = np.cumsum(rng.normal(size=50)) * 1e-3, np.cumsum(rng.normal(size=50)) * 1e-3
    gains = LinuxCNCGains(3.0, 20.0, 0.1, 0.5, 0.2, 0.01, 1e-4)
    law = linuxcnc_law(gains, command, feedback, 1e-3)
    np.testing.assert_allclose(law, straight_from_the_manual(gains, command.tolist(), feedback.tolist(), 1e-3), rtol=1e-9, atol=1e-12)


@each(
    "part, slots, apart",
    [
        # There accelerations are differences of the planner's velocity: half a tick late, or 0.3 % of a command at 1 Hz.
        (position_control(velocity_gain=30.0).axes["x"].controller, {}, 5e-3),
        (PositionController(position_gain=1500.0, velocity_gain=40.0, integral_gain=5.0, structure="ipv"), {}, 1e-6),
        (StateFeedback(position_gain=900.0, velocity_gain=40.0, integral_gain=3000.0, velocity_feedforward=7.0), {}, 1e-6),
        (StateFeedback(position_gain=900.0, velocity_gain=40.0, integral_gain=3000.0, following="position"), {}, 1e-6),
        (StateFeedback(position_gain=900.0, velocity_gain=40.0, acceleration_feedforward=0.8), {}, 5e-3),
        (PID(proportional_gain=1500.0, integral_gain=6000.0), {}, 1e-6),
        (PID(proportional_gain=1500.0, integral_gain=6000.0, reference_weight=0.8), {}, 1e-6),
        (PID(proportional_gain=1500.0, derivative_gain=40.0, derivative_bandwidth=20000.0), {}, 5e-3),
        (PID(proportional_gain=1500.0, derivative_gain=40.0, derivative_bandwidth=20000.0, derivative_on="measurement"), {}, 5e-3),
        (PID(proportional_gain=1500.0), {"feedforward": InverseDynamics(velocity_gain=7.0, acceleration_gain=0.8)}, 5e-3),
        (Cascade(position_gain=40.0, velocity_gain=60.0), {}, 1e-6),
        # The integral of the velocity error replaces that of the position; they are half a tick apart.
        (Cascade(position_gain=40.0, velocity_gain=60.0, integral_time=0.05, velocity_feedforward=0.9), {}, 1e-2),
        (LeadLag(gain=1200.0, lead_time=0.03, lag_time=0.003, integral_rate=5.0), {}, 0.05),
    ],
)
def test_mapped_gains_give_the_same_command(part: Component, slots: dict[str, Any], apart: float) -> None:
    stage, control = rigid_stage(), made(part, **slots)
    run = simulate(stage, control, circle(4))
    for i, axis in enumerate(stage.axes):
        gains = linuxcnc_gains(control.axes[axis.name], control)
        assert gains is not None
        assert law_difference(gains, control.axes[axis.name], run, i)[0] < apart
        # The test can fail: gains off by half are detected.
        names = ("p", "i", "d", "ff0", "ff1", "ff2", "ff3")
        off = replace(gains, **{name: 1.5 * getattr(gains, name) for name in names})
        assert law_difference(off, control.axes[axis.name], run, i)[0] > 0.07


def test_controllers_without_an_equivalent_pid_are_reported() -> None:
    speed = made(SpeedPID(dc_gain=1.0, damping_ratio=1.0, natural_frequency=100.0, time_constant=0.01))
    assert linuxcnc_gains(speed.axes["x"], speed) is None
    lag = made(LeadLag(gain=1200.0, lead_time=0.03, lag_time=0.003))
    found = linuxcnc_gains(lag.axes["x"], lag)
    assert found is not None
    assert [one.code for one in found.findings] == ["CL624"]


def test_friction_of_the_feedforward_is_reported() -> None:
    def codes(friction: float) -> list[str]:
        control = made(PID(proportional_gain=1500.0), feedforward=InverseDynamics(acceleration_gain=0.8, friction=friction))
        found = linuxcnc_gains(control.axes["x"], control)
        assert found is not None
        return [one.code for one in found.findings]

    assert set(codes(0.1)) - set(codes(0.0)) == {"CL621"}


def test_millimetres() -> None:
    control = position_control()
    gains = linuxcnc_gains(control.axes["x"], control)
    assert gains is not None
    shown = gains.per_millimetre()
    assert shown["Pgain"] == pytest.approx(1.5)
    assert shown["Igain"] == pytest.approx(7.5)
    assert shown["Dgain"] == pytest.approx(0.04)
    assert shown["FF2"] == pytest.approx(1e-3 / 1.2)
    assert shown["FF1"] == pytest.approx(1e-3 * 9.0 / 1.2)


def test_kv_and_the_velocity_loop_of_a_cascade() -> None:
    """A velocity loop a K/(s + b + a K), sampled at 1 kHz, of 81 rad/s; Kv is the position gain."""
    control = made(Cascade(position_gain=25.0, velocity_gain=60.0))
    terms = drive_terms(rigid_stage(), control)[0]
    assert terms.kv == 25.0
    assert terms.velocity_bandwidth == pytest.approx(81.0 / (2.0 * np.pi), rel=0.06)


def test_kv_is_speed_over_lag() -> None:
    """At a steady speed, without integral and velocity feedforward, the axis lags by v/Kv."""
    part = StateFeedback(position_gain=1500.0, velocity_gain=40.0, following="position")
    control = made(part)
    run = simulate(rigid_stage(), control, circle(6))
    kv = drive_terms(rigid_stage(), control)[0].kv
    assert kv == pytest.approx(1500.0 / (40.0 + 9.0 / 1.2))
    # At 1 Hz, well below Kv, the lag of a sine corresponds to its speed.
    lag = np.abs(run["reference"] - run["position"])[3000:, 0].max()
    assert 2.0 * np.pi * 0.01 / lag == pytest.approx(kv, rel=0.05)
