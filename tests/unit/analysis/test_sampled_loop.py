"""The sampled loop against hand-made loops in z, analytic margins, runs of the engine, and gains scaled to the limit."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from one_axis import A_HAT, B_HAT, KI, KP, KV, W_D, W_V, W_Z, A, B, T, axis, controller, observer
from scipy.signal import cont2discrete

from contourlab.analysis.linear.margins import margins
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.analysis.linear.tick_map import spectral_radius
from contourlab.components.contract import Component, param
from contourlab.components.disturbance.loads import SineLoad
from contourlab.components.drive.saturation import DelayedSaturation, Saturation
from contourlab.components.friction.laws import Coulomb
from contourlab.components.plant.plant import MassDamper, RigidAxis
from contourlab.components.sensor.encoder import Encoder
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.engine.step import Port
from contourlab.errors import ComponentError, ParameterError
from contourlab.geometry import Line, Path
from contourlab.loop.machine import Axis, AxisController, Controller, Machine
from contourlab.loop.template import build

W = np.geomspace(1.0, math.pi / T, 60)


class Amplifier(Component):
    """A drive with a gain, for tests of the gain margin."""

    family = "drive"
    kind = "amplifier"
    inputs = (Port("command"),)
    outputs = (Port("applied"),)
    gain: float = param(default=1.0, unit="", doc="applied per command")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.gain * inp.command,)


def radius(part: Axis, made: AxisController, period: float = T) -> float:
    """Return the spectral radius of the whole closed schedule, independent of the code under test."""
    free = replace(made, controller=made.controller.replace(anti_windup="none"))
    whole = build(Machine("one", (part,), period), Controller({"x": free}), Path([Line((0.0,), (1.0,))]), np.zeros(1))
    return spectral_radius(whole.schedule)


# --- closed forms --------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("delay", [0, 1, 2, 5])
@pytest.mark.parametrize("gain", [0.05, 0.2])
def test_discrete_integrator_with_delay(gain: float, delay: int) -> None:
    """L = g z^-d/(z - 1): PM = pi/2 - (2 d + 1) asin(g/2) at 2 asin(g/2)/T, GM = 2 sin(pi/(2 (2 d + 1)))/g at pi/((2 d + 1) T).

    From the velocity of an undamped axis, v(k + 1) = v(k) + a T u(k).
    """
    drive = DelayedSaturation(delay=delay * T) if delay else Saturation()
    # The position loop is so weak that its pole is 1e-9 inside the circle.
    kv = gain / (A * T)
    found = sampled_loop(axis(drive, damping=0.0), controller(kv, 1e-6 * kv, 0.0), T).margins()
    cross = 2.0 * math.asin(gain / 2.0)
    assert found.stable
    # The position loop's part of L at w is K_P/(K_V w), at most 1e-6/50.
    assert found.crossover * T == pytest.approx(cross, rel=1e-7)
    assert found.phase == pytest.approx(math.pi / 2.0 - cross * (delay + 0.5), rel=1e-7)
    assert found.gain == pytest.approx(2.0 * math.sin(math.pi / (2.0 * (2 * delay + 1))) / gain, rel=1e-7)
    assert found.phase_crossover * T == pytest.approx(math.pi / (2 * delay + 1), rel=1e-7)
    theta = np.linspace(1e-4, math.pi, 500_001)
    distance = np.abs(1.0 + gain * np.exp(-1j * delay * theta) / (np.exp(1j * theta) - 1.0))
    assert found.modulus == pytest.approx(distance.min(), rel=1e-7)


@pytest.mark.parametrize("part", [0.01, 0.2, 0.7])
def test_gain_margin_of_a_position_loop_by_jury(part: float) -> None:
    """z^2 + (K g1 - 1 - e) z + e + K g0 of a/(s (s + b)) behind a hold is stable while e + K g0 < 1 and K (g1 - g0) < 2 (1 + e)."""
    e = math.exp(-B * T)
    g1, g0 = A / B**2 * (B * T - 1.0 + e), A / B**2 * (1.0 - e - B * T * e)
    limit = min((1.0 - e) / g0, 2.0 * (1.0 + e) / (g1 - g0))
    found = sampled_loop(axis(), controller(0.0, part * limit, 0.0), T).margins()
    # g0 and g1 are differences of numbers 1e5 times their size.
    assert found.gain == pytest.approx(1.0 / part, rel=1e-8)


def by_hand(z: np.ndarray, velocity: bool, seen: bool, delay: float, rule: str) -> np.ndarray:
    """-command/applied from the block diagram: exact held plant, filters as difference equations, integral, late observer, delay."""
    plant = cont2discrete((np.array([[0.0, 1.0], [0.0, -B]]), np.array([[0.0], [A]]), np.eye(2), np.zeros((2, 1))), T)
    p, v = (np.array([np.linalg.solve(x * np.eye(2) - plant[0], plant[1])[i, 0] for x in z]) for i in (0, 1))
    whole = math.floor(delay / T + 1e-9)
    part = max(delay / T - whole, 0.0)
    late = z**-whole * (1.0 - part + part / z)

    def low_pass(bandwidth: float) -> np.ndarray:
        weight = 1.0 - math.exp(-bandwidth * T) if rule == "pole-matched" else bandwidth * T / (1.0 + bandwidth * T)
        return np.asarray(weight / (1.0 - (1.0 - weight) / z))

    if velocity:
        v = low_pass(W_V) * (1.0 - 1.0 / z) / T * p
    command = -KP * p - KV * v - KP * KI * T / (1.0 - 1.0 / z) * p
    if seen:
        residual = (W_Z * (1.0 - low_pass(W_Z)) + B_HAT) * v / A_HAT - 1.0 / z
        command = command - low_pass(W_D) * residual
    return -command * late


@pytest.mark.parametrize("rule", ["backward-euler", "pole-matched"])
@pytest.mark.parametrize("delay", [0.0, 0.4e-3, 3.0e-3, 7.3e-3])
@pytest.mark.parametrize("velocity", [False, True])
@pytest.mark.parametrize("seen", [False, True])
def test_loop_gain_by_hand(seen: bool, velocity: bool, delay: float, rule: str) -> None:
    made = controller(
        velocity=FilteredDifference(bandwidth=W_V, discretisation=rule) if velocity else None,
        seen=observer(discretisation=rule) if seen else None,
    )
    drive = DelayedSaturation(delay=delay, limit=0.3) if delay else Saturation(limit=0.3)
    found = sampled_loop(axis(drive), made, T).loop_gain(W)
    # The plant is integrated by Runge-Kutta, exact to (b T)^5/120 = 6e-14 of its decay; sums over the past accumulate it.
    assert found == pytest.approx(by_hand(np.exp(1j * W * T), velocity, seen, delay, rule), rel=1e-9)


def test_substeps_are_those_of_the_plant() -> None:
    """Strong damping, b T = 0.8: sixteen Runge-Kutta steps per period reach the exact plant, one does not."""
    z, b = np.exp(1j * W * T), 800.0
    e = math.exp(-b * T)
    exact = KV * A / b * (1.0 - e) / (z - e)
    gaps = []
    for steps in (1, 16):
        part = replace(axis(damping=b), substeps=steps)
        gaps.append(np.abs(sampled_loop(part, controller(kp=0.0, ki=0.0), T).loop_gain(W) / exact - 1.0).max())
    # One Runge-Kutta step misses x^5/120 and higher terms of the exponential e^-0.8.
    assert gaps[0] > 1e-3
    assert gaps[1] < 16.0**-3 * gaps[0]


def test_the_response_behind_the_observer() -> None:
    """v over the command before the observer: v = V u with u = u_c - d_hat."""
    found = sampled_loop(axis(), controller(seen=observer()), T).response(W).compensated
    z = np.exp(1j * W * T)
    v = np.array([np.linalg.solve([[x - math.exp(-B * T)]], [A / B * (1.0 - math.exp(-B * T))])[0] for x in z])
    weight_z, weight_d = (w * T / (1.0 + w * T) for w in (W_Z, W_D))
    q, f = (weight / (1.0 - (1.0 - weight) / z) for weight in (weight_d, weight_z))
    estimate = q * ((W_Z * (1.0 - f) + B_HAT) * v / A_HAT - 1.0 / z)
    assert found == pytest.approx(v / (1.0 + estimate), rel=1e-9)


# --- margins are the limit of stability ------------------------------------------------------------------------------------------------


gains = st.fixed_dictionaries({"kv": st.floats(20.0, 120.0), "kp": st.floats(200.0, 4000.0), "ki": st.just(0.0) | st.floats(0.1, 15.0)})
filters = st.sampled_from(["backward-euler", "pole-matched"])


@settings(max_examples=40, deadline=None)
@given(gains, st.floats(50.0, 400.0), st.floats(400.0, 3000.0), filters, st.floats(0.0, 4.0), st.sampled_from([True, False]))
@pytest.mark.slow
def test_the_gain_margin_is_the_limit_of_stability(
    gain: dict[str, float], w_d: float, w_v: float, rule: str, periods: float, seen: bool
) -> None:
    """With the drive's gain raised by the margin the closed loop has a pole on the circle; with slightly less it has none."""
    made = controller(
        **gain,
        velocity=FilteredDifference(bandwidth=w_v, discretisation=rule),
        seen=observer(bandwidth=w_d, discretisation=rule) if seen else None,
    )

    class Late(Amplifier):
        kind = "late-amplifier"
        ring = "command"

        @staticmethod
        def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
            from contourlab.primitives import delayed

            return (), (par.gain * delayed(par.ring, clock, whole),)

        def ring_length(self, dt: float) -> int:
            return int(whole) + 1

    whole = float(round(periods))
    found = sampled_loop(axis(Late()), made, T).margins()
    assert found.stable == (radius(axis(Late()), made) < 1.0)
    if found.stable and math.isfinite(found.gain):
        assert radius(axis(Late(gain=found.gain)), made) == pytest.approx(1.0, abs=1e-6)
        assert radius(axis(Late(gain=1.0 + 0.99 * (found.gain - 1.0))), made) < 1.0
        assert radius(axis(Late(gain=1.01 * found.gain)), made) > 1.0


def test_a_delay_of_the_phase_margin_is_the_limit_of_stability() -> None:
    """A delay of whole periods at the crossover: with one more the loop is unstable, with one less it is not."""
    made = controller(velocity=FilteredDifference(bandwidth=W_V))
    found = sampled_loop(axis(), made, T).margins()
    periods = math.floor(found.phase / (found.crossover * T))
    assert periods >= 2
    assert radius(axis(DelayedSaturation(delay=periods * T)), made) < 1.0
    assert radius(axis(DelayedSaturation(delay=(periods + 1) * T)), made) > 1.0


@pytest.mark.parametrize("seen", [None, observer(), observer(bandwidth=500.0)])
@pytest.mark.parametrize("drive", [Saturation(), DelayedSaturation(delay=2.5e-3)])
def test_closing_the_opened_loop_gives_the_poles_of_the_whole(seen: Component | None, drive: Component) -> None:
    made = controller(velocity=FilteredDifference(bandwidth=W_V), seen=seen)
    found = sampled_loop(axis(drive), made, T)
    assert np.abs(found.poles).max() == pytest.approx(radius(axis(drive), made), abs=1e-9)


def test_the_nyquist_criterion_agrees_with_the_eigenvalues() -> None:
    """Turns of 1 + L around 0 as z circles once: with the loop gain's poles inside or at 1, one turn per unstable pole."""
    for kp, outside in ((1500.0, 0), (2e5, 2)):
        loop = sampled_loop(axis(), controller(kp=kp, velocity=FilteredDifference(bandwidth=W_V)), T)
        w = np.geomspace(1e-3, loop.nyquist, 20000)
        turn = np.unwrap(np.angle(1.0 + loop.loop_gain(w)))
        # Half of the circle. L has two poles at z = 1, passed on the outside, which add a turn of pi there.
        assert round((turn[-1] - turn[0] - math.pi) / math.pi) == -outside
        assert int((np.abs(loop.poles) > 1.0).sum()) == outside
        assert loop.stable == (outside == 0)


# --- edge cases ----------------------------------------------------------------------------------------------------------------------


def test_nonlinear_parts_and_disturbances_do_not_change_the_margins() -> None:
    """Friction, counts, a limit below the unit step of the linearisation, an integral that waits for it, a disturbance."""
    bare = sampled_loop(axis(), controller(anti_windup="none"), T)
    full = Axis("x", RigidAxis(gain=A, damping=B), Coulomb(coulomb=0.2), Saturation(limit=0.01), Encoder(resolution=1e-4))
    found = sampled_loop(replace(full, disturbance=SineLoad(amplitude=1.0, frequency=3.0)), controller(), T)
    assert found.margins() == bare.margins()


def test_carried_mass_is_mass() -> None:
    light, heavy = (Axis("x", MassDamper(mass=mass, damping=80.0, force_constant=22.0)) for mass in (20.0, 32.0))
    assert sampled_loop(light, controller(), T, 12.0).margins() == sampled_loop(heavy, controller(), T).margins()


@pytest.mark.parametrize("period", [1e-4, 1e-3, 4e-3, 20.0])
def test_frequencies_end_at_nyquist(period: float) -> None:
    loop = sampled_loop(axis(), controller(), period)
    w = loop.frequencies()
    assert w[-1] == pytest.approx(math.pi / period, rel=1e-12)
    assert (np.diff(w) > 0.0).all()
    assert np.isfinite(loop.response(w).closed_loop).all()


@pytest.mark.parametrize("frequency", [0.0, -1.0, 1.001 * math.pi / T, math.nan])
def test_frequencies_out_of_range(frequency: float) -> None:
    loop = sampled_loop(axis(), controller(), T)
    for ask in (loop.response, loop.loop_gain):
        with pytest.raises(ParameterError, match="Nyquist"):
            ask([1.0, frequency])


class DeadBand(Component):
    """A controller that does nothing within a micrometre."""

    family = "controller"
    kind = "dead-band"
    inputs = (Port("reference"), Port("position"), Port("velocity"))
    outputs = (Port("command"),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        error = inp.reference - inp.position
        return (), ((100.0 * error if abs(error) > 1e-6 else 0.0) * abs(error) - inp.velocity,)


def test_a_nonlinear_step_is_named() -> None:
    with pytest.raises(ComponentError, match=r"x\.controller .*linear"):
        sampled_loop(axis(), AxisController(DeadBand()), T)


def test_too_long_a_delay_is_refused() -> None:
    with pytest.raises(ComponentError, match=r"axis x: .*\b1000\b"):
        sampled_loop(axis(DelayedSaturation(delay=5.0)), controller(), T)


def test_a_long_delay_gets_a_fine_grid() -> None:
    """Between neighbouring frequencies the loop turns by less than a quarter turn, so no two crossings lie between them."""
    loop = sampled_loop(axis(DelayedSaturation(delay=60e-3)), controller(10.0, 60.0, 0.0), T)
    assert np.diff(loop._grid()).max() * 60e-3 < 0.25 * math.pi


def test_with_a_long_delay_no_crossing_is_missed() -> None:
    """Between 60 and 61 ms of delay the loop gain turns past -180 deg many times; the least factor agrees with the poles."""
    made, drive = controller(10.0, 60.0, 0.0), DelayedSaturation(delay=60e-3)
    found = sampled_loop(axis(drive), made, T)
    said = found.margins()
    dense = margins(found.loop_gain, np.linspace(1.0, math.pi / T, 20_000), stable=True)
    assert said.gain == pytest.approx(dense.gain, rel=1e-9)
    assert said.phase == pytest.approx(dense.phase, rel=1e-9)
    assert said.modulus == pytest.approx(dense.modulus, rel=1e-6)
