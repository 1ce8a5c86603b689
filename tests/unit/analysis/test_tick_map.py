"""Poles of the sampled loop against hand-made loops from exact discretisations."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import cont2discrete

from contourlab.analysis.linear.tick_map import spectral_radius, tick_map, tick_matrix
from contourlab.components.controller.position import PositionController
from contourlab.components.plant.plant import RigidAxis
from contourlab.engine.step import Late, Node, Port, Schedule, Step
from contourlab.errors import ComponentError
from contourlab.geometry import Line, Path
from contourlab.loop.machine import Axis, AxisController, Controller, Machine
from contourlab.loop.template import build

PERIOD, A, B = 1e-3, 0.9, 6.0


def loop(kv: float = 0.0, kp: float = 0.0, ki: float = 0.0, structure: str = "feedforward", period: float = PERIOD) -> Schedule:
    law = PositionController(velocity_gain=kv, position_gain=kp, integral_gain=ki, structure=structure, anti_windup="none")
    made = AxisController(law)
    machine = Machine("one", (Axis("x", RigidAxis(gain=A, damping=B)),), period)
    return build(machine, Controller({"x": made}), Path([Line((0.0,), (1.0,))]), np.zeros(1)).schedule


def by_hand_pid(kv: float, kp: float, ki: float) -> np.ndarray:
    """Position, velocity, integral: the plant held exactly; the integral includes this tick's error before the command is formed."""
    plant, push, *_ = cont2discrete((np.array([[0.0, 1.0], [0.0, -B]]), np.array([[0.0], [A]]), np.eye(2), np.zeros((2, 1))), PERIOD)
    row = np.array([[-kp - kp * ki * PERIOD, -kv, kp * ki]])
    top = np.hstack([plant, np.zeros((2, 1))]) + push @ row
    return np.vstack([top, [[-PERIOD, 0.0, 1.0]]])


@pytest.mark.parametrize("structure", ["feedforward", "ipv"])
@pytest.mark.parametrize("gains", [(60.0, 2200.0, 12.0), (0.0, 300.0, 3.0), (900.0, 5e4, 40.0)])
def test_pid_loop(gains: tuple[float, float, float], structure: str) -> None:
    schedule, wanted = loop(*gains, structure=structure), np.sort_complex(np.linalg.eigvals(by_hand_pid(*gains)))
    found = np.linalg.eigvals(tick_matrix(schedule))
    # Signals add poles at 0, memory at 1. Where a pair is nearly double, rounding costs half of its digits.
    found = np.sort_complex(found[(np.abs(found) > 1e-5) & (np.abs(found - 1.0) > 1e-9)])
    # The plant is integrated by Runge-Kutta, which at b T = 0.006 is exact to (b T)^5/120 = 6e-14.
    assert found == pytest.approx(wanted, abs=1e-10)
    assert spectral_radius(schedule) == pytest.approx(np.abs(wanted).max(), abs=1e-10)


def test_largest_integral_gain_converges_to_routh() -> None:
    """Routh on eq (16): K_I < b + a K_V. The sampled loop converges to it to first order in the period."""
    kv, kp = 60.0, 500.0
    law = B + A * kv

    def limit(period: float) -> float:
        low, high = 1.0, 1e3
        for _ in range(50):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if spectral_radius(loop(kv, kp, middle, period=period)) < 1.0 else (low, middle)
        return low

    gaps = [limit(period) - law for period in (4e-4, 2e-4)]
    assert abs(gaps[1]) < 0.02 * law
    assert gaps[0] / gaps[1] == pytest.approx(2.0, rel=0.05)


def test_memory_is_no_pole() -> None:
    """The start position and the records of the watch stay for ever; a stable loop is still stable."""
    schedule = loop(60.0, 2200.0, 12.0, structure="ipv")
    assert np.abs(np.linalg.eigvals(tick_matrix(schedule))).max() == pytest.approx(1.0)
    assert spectral_radius(schedule) < 0.999


def test_an_unread_integral_is_no_pole() -> None:
    """With K_I = 0 the integral still sums, outside the loop."""
    assert spectral_radius(loop(60.0, 2200.0)) == pytest.approx(np.abs(np.linalg.eigvals(by_hand_pid(60.0, 2200.0, 0.0)[:2, :2])).max())


def test_an_axis_without_feedback_is_no_stable_loop() -> None:
    """The position integrates: a pole at 1 that is not memory."""
    assert spectral_radius(loop()) == pytest.approx(1.0, abs=1e-12)


def test_matrix_of_a_schedule_by_hand() -> None:
    """y = 2 x + 3 with the old x, then x' = 0.5 y: constants are removed; the delayed wire is a column."""

    def half(par, x, inp, clock):  # type: ignore[no-untyped-def]
        return (0.5 * inp.u,), (2.0 * x.x + 3.0,)

    def pass_on(par, x, inp, clock):  # type: ignore[no-untyped-def]
        return (), (inp.u,)

    one = Step("half", half, states=(Port("x"),), inputs=(Port("u"),), outputs=(Port("y"),))
    two = Step("pass", pass_on, inputs=(Port("u"),), outputs=(Port("y"),))
    schedule = Schedule((Node("a", one, {"u": Late("b.y")}), Node("b", two, {"u": "a.y"})), (), 1.0, 2)
    matrix = tick_matrix(schedule)
    # In the order state x, signals a.y, b.y: x' = 0.5 b, a' = 2 x, b' = a'.
    assert matrix.tolist() == [[0.0, 0.0, 0.5], [2.0, 0.0, 0.0], [2.0, 0.0, 0.0]]
    assert spectral_radius(schedule) == pytest.approx(1.0)  # eigenvalues +-1: z^2 = 0.5 * 2


def summed(gain: float, bend: float = 0.0) -> Schedule:
    """y = gain u + x + bend x^2, x' = 0.5 x + y, with an external u from a vector w."""

    def step(par, x, inp, clock):  # type: ignore[no-untyped-def]
        y = par.gain * inp.u + x.x + par.bend * x.x * x.x + 2.0
        return (0.5 * x.x + y - 2.0,), (y,)

    made = Step("sum", step, ("gain", "bend"), states=(Port("x"),), inputs=(Port("u"),), outputs=(Port("y"),))
    return Schedule((Node("s", made, {"u": "in.u"}, {"gain": gain, "bend": bend}),), (Port("w", 2), Port("u")), 1.0, 1)


def test_map_of_externals() -> None:
    """Matrices written by hand; row and column find the named signals."""
    found = tick_map(summed(3.0))
    x, y, u = 0, found.row("s.y"), found.column("in.u")
    assert (y, u) == (len(found.a) - 1, 2)
    assert found.b[:, u].tolist() == [3.0, 0.0, 0.0, 1.0, 3.0]  # x, placeholder for the externals, y
    assert found.b[[x, y], :2].tolist() == [[0.0, 0.0], [0.0, 0.0]]
    assert found.a[[x, y], x].tolist() == [1.5, 1.0]
    assert not found.a[:, 1:].any()


def test_a_nonlinear_schedule_has_no_map() -> None:
    with pytest.raises(ComponentError, match=r"^s .*linear"):
        tick_map(summed(3.0, bend=1e-6))


def test_a_failing_step_has_no_map() -> None:
    def step(par, x, inp, clock):  # type: ignore[no-untyped-def]
        return (), (1.0 / (inp.u - 1.0),)

    made = Step("break", step, inputs=(Port("u"),), outputs=(Port("y"),))
    with pytest.raises(ComponentError, match="division by zero"):
        tick_map(Schedule((Node("s", made, {"u": "in.u"}),), (Port("u"),), 1.0, 1))


def test_undamped_axis_without_feedback_is_no_stable_loop() -> None:
    """Velocity stays and position grows: the pole of the position at 1 counts, although the velocity is pure memory."""
    machine = Machine("one", (Axis("x", RigidAxis(gain=A, damping=0.0)),), PERIOD)
    free = AxisController(PositionController(anti_windup="none"))
    schedule = build(machine, Controller({"x": free}), Path([Line((0.0,), (1.0,))]), np.zeros(1)).schedule
    assert spectral_radius(schedule) == pytest.approx(1.0, abs=1e-12)
