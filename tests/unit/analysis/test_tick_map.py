"""Poles of the sampled loop against hand-made loops from exact discretisations, and against Jury's conditions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.signal import cont2discrete

from contourlab.analysis.linear.tick_map import spectral_radius, tick_map, tick_matrix
from contourlab.components.contract import Component
from contourlab.components.controller.position import PositionController
from contourlab.components.drive.saturation import DelayedSaturation, Saturation
from contourlab.components.ideal import TrueVelocity
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.rigid_axis import RigidAxis
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.engine.schedule import Late, Node, Schedule
from contourlab.engine.step import Port, Step
from contourlab.errors import ComponentError
from contourlab.geometry import Line, Path
from contourlab.loop.machine import Axis, AxisController, Controller, Machine
from contourlab.loop.template import build

PERIOD, A, B = 1e-3, 0.9, 6.0


def loop(
    velocity_gain: float = 0.0,
    position_gain: float = 0.0,
    integral_gain: float = 0.0,
    velocity: Component | None = None,
    observer: Component | None = None,
    drive: Component | None = None,
    structure: str = "feedforward",
    period: float = PERIOD,
) -> Schedule:
    gains = {"velocity_gain": velocity_gain, "position_gain": position_gain, "integral_gain": integral_gain}
    made = AxisController(PositionController(**gains, structure=structure, anti_windup="none"), velocity or TrueVelocity(), observer)
    machine = Machine("one", (Axis("x", RigidAxis(gain=A, damping=B), drive=drive or Saturation()),), period)
    return build(machine, Controller({"x": made}), Path([Line((0.0,), (1.0,))]), np.zeros(1)).schedule


def held_plant() -> tuple[np.ndarray, np.ndarray]:
    """Return the axis under a command held over the period, exactly: (2, 2) and (2, 1)."""
    a, b, *_ = cont2discrete((np.array([[0.0, 1.0], [0.0, -B]]), np.array([[0.0], [A]]), np.eye(2), np.zeros((2, 1))), PERIOD)
    return a, b


def poles(matrix: np.ndarray) -> np.ndarray:
    """Return the sorted eigenvalues without those at 0 (signals) and at 1 (memory)."""
    values = np.linalg.eigvals(matrix)
    # Where a pair is nearly double, rounding costs half of its digits.
    moving = values[(np.abs(values) > 1e-5) & (np.abs(values - 1.0) > 1e-9)]
    return np.sort_complex(moving)


def assert_poles(schedule: Schedule, by_hand: np.ndarray) -> None:
    wanted = np.sort_complex(np.linalg.eigvals(by_hand))
    wanted = wanted[np.abs(wanted) > 1e-5]
    found = poles(tick_matrix(schedule))
    assert found.shape == wanted.shape
    # The plant is integrated by Runge-Kutta, which at b T = 0.006 is exact to (b T)^5/120 = 6e-14.
    assert np.abs(found - wanted).max() < 1e-10
    assert spectral_radius(schedule) == pytest.approx(np.abs(wanted).max(), abs=1e-10)


def by_hand_pid(kv: float, kp: float, ki: float) -> np.ndarray:
    """Position, velocity, integral: the integral includes this tick's error before the command is formed."""
    plant, push = held_plant()
    row = np.array([[-kp - kp * ki * PERIOD, -kv, kp * ki]])
    top = np.hstack([plant, np.zeros((2, 1))]) + push @ row
    return np.vstack([top, [[-PERIOD, 0.0, 1.0]]])


@pytest.mark.parametrize("structure", ["feedforward", "ipv"])
@pytest.mark.parametrize("gains", [(60.0, 2200.0, 12.0), (0.0, 300.0, 3.0), (900.0, 5e4, 40.0)])
def test_pid_loop(gains: tuple[float, float, float], structure: str) -> None:
    assert_poles(loop(*gains, structure=structure), by_hand_pid(*gains))


@pytest.mark.parametrize("n", [1, 2, 3, 7])
@pytest.mark.parametrize("fraction", [0.0, 0.4])
def test_delay_is_a_chain_of_states(n: int, fraction: float) -> None:
    """u(k) acts n periods and a fraction late: n + 1 more states; the last two act, weighted."""
    kv, kp = 20.0, 600.0
    plant, push = held_plant()
    matrix = np.zeros((n + 3, n + 3))
    matrix[:2, :2] = plant
    matrix[:2, n + 1 : n + 2], matrix[:2, n + 2 : n + 3] = (1.0 - fraction) * push, fraction * push
    matrix[2, :2] = [-kp, -kv]
    for i in range(3, n + 3):
        matrix[i, i - 1] = 1.0
    assert_poles(loop(kv, kp, drive=DelayedSaturation(delay=(n + fraction) * PERIOD)), matrix)


def test_velocity_from_differences() -> None:
    """States: position, velocity, previous position, filtered velocity; backward Euler with weight w T/(1 + w T)."""
    kv, kp, w = 40.0, 1500.0, 300.0
    plant, push = held_plant()
    weight = w * PERIOD / (1.0 + w * PERIOD)
    seen = np.array([[weight / PERIOD, 0.0, -weight / PERIOD, 1.0 - weight]])
    row = -kp * np.array([[1.0, 0.0, 0.0, 0.0]]) - kv * seen
    top = np.hstack([plant, np.zeros((2, 2))]) + push @ row
    matrix = np.vstack([top, [[1.0, 0.0, 0.0, 0.0]], seen])
    assert_poles(loop(kv, kp, velocity=FilteredDifference(bandwidth=w)), matrix)


def test_observer_of_the_applied_command() -> None:
    """States: position, velocity, filtered velocity, estimate, and the previous command, which the observer reads."""
    kv, kp, w_d, w_z, a_hat, b_hat = 50.0, 1500.0, 120.0, 400.0, 0.7, 15.0
    plant, push = held_plant()
    z, d = (w * PERIOD / (1.0 + w * PERIOD) for w in (w_z, w_d))
    x = np.eye(5)  # p, v, f, e, u
    filtered = x[2] + z * (x[1] - x[2])
    residual = (w_z * (x[1] - filtered) + b_hat * x[1]) / a_hat - x[4]
    estimate = x[3] + d * (residual - x[3])
    command = -kp * x[0] - kv * x[1] - estimate
    moved = np.hstack([plant, np.zeros((2, 3))]) + push @ command[None, :]
    matrix = np.vstack([moved, filtered, estimate, command])
    made = DisturbanceObserver(bandwidth=w_d, filter_bandwidth=w_z, model_gain=a_hat, model_damping=b_hat)
    assert_poles(loop(kv, kp, observer=made), matrix)


def limit_of(name: str, low: float, high: float, **fixed: float) -> float:
    """Return the gain at which the sampled loop becomes unstable."""
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if spectral_radius(loop(**{name: middle}, **fixed)) < 1.0 else (low, middle)
    return low


def held_gains() -> tuple[float, float, float]:
    """G(z) = (g1 z + g0)/((z - 1)(z - e)) of a/(s (s + b)) behind a hold (Astrom & Wittenmark, table of pulse transfer functions)."""
    e = math.exp(-B * PERIOD)
    return A / B**2 * (B * PERIOD - 1.0 + e), A / B**2 * (1.0 - e - B * PERIOD * e), e


def test_largest_position_gain_by_jury() -> None:
    """z^2 + (K g1 - 1 - e) z + e + K g0: stable while e + K g0 < 1 and K (g1 - g0) < 2 (1 + e)."""
    g1, g0, e = held_gains()
    law = min((1.0 - e) / g0, 2.0 * (1.0 + e) / (g1 - g0))
    assert limit_of("position_gain", 1.0, 1e6) == pytest.approx(law, rel=1e-6)


def test_largest_velocity_gain() -> None:
    """Velocity loop alone: its pole e - K a (1 - e)/b reaches -1 at K = (1 + e) b/(a (1 - e)). The position integrates, at 1."""
    e = math.exp(-B * PERIOD)
    law = (1.0 + e) * B / (A * (1.0 - e))
    tiny = 1e-3  # keeps the position's own pole just inside the circle
    assert limit_of("velocity_gain", 1.0, 1e6, position_gain=tiny) == pytest.approx(law, rel=1e-6)


def test_largest_integral_gain_converges_to_routh() -> None:
    """Routh on eq (16): K_I < b + a K_V. The sampled loop converges to it to first order in the period."""
    kv, kp = 60.0, 500.0
    law = B + A * kv
    gaps = [limit_of("integral_gain", 1.0, 1e3, velocity_gain=kv, position_gain=kp, period=period) - law for period in (4e-4, 2e-4)]
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
