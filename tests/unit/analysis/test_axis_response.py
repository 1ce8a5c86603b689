"""The frequency response of an axis in continuous time, against transfer functions by hand, connected by python-control."""

from __future__ import annotations

from typing import Any

import control
import numpy as np
import pytest

from contourlab.analysis.linear.sampled_loop import AxisResponse
from contourlab.components.contract import Component, LinearModel
from contourlab.components.controller.position import PositionController
from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.components.ideal import TrueVelocity
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.plant import RigidAxis, SingleMass
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.errors import ComponentError
from contourlab.loop.machine import Axis, AxisController
from contourlab.papers.ghaffari.axis_response import axis_response

W = np.logspace(-1, 3.5, 120)
S = 1j * W
A, B, KV, KP, KI = 0.9, 20.0, 60.0, 2200.0, 12.0
MODEL_A, MODEL_B, W_D, W_Z = 0.8, 15.0, 150.0, 900.0
s = control.tf("s")
PLANT = A / (s * (s + B))
PID = KV * s + KP + KP * KI / s
AHEAD = (s * s + MODEL_B * s) / MODEL_A


def respond(
    structure: str = "feedforward",
    observer: Component | None = None,
    velocity: Component | None = None,
    axis: Axis | None = None,
    **changed: float,
) -> AxisResponse:
    gains = {"velocity_gain": KV, "position_gain": KP, "integral_gain": KI, "model_gain": MODEL_A, "model_damping": MODEL_B, **changed}
    controller = AxisController(PositionController(structure=structure, **gains), velocity or TrueVelocity(), observer)
    return axis_response(axis or Axis("x", RigidAxis(gain=A, damping=B)), controller, W)


def same(found: Any, law: Any, rel: float = 1e-9) -> None:
    assert np.abs(found / law(S) - 1.0).max() < rel


def test_structure_without_feedforward_is_eq_16() -> None:
    """P/R' = a K_P K_I/(s^3 + (b + a K_V) s^2 + a K_P s + a K_P K_I)."""
    found = respond("ipv")
    law = A * KP * KI / (s**3 + (B + A * KV) * s**2 + A * KP * s + A * KP * KI)
    same(found.closed_loop, law)
    same(found.modified, law)
    same(found.loop_gain, PID * PLANT)


def test_structure_with_feedforward() -> None:
    found = respond()
    closed = control.feedback(PLANT, PID)
    same(found.loop_gain, PID * PLANT)
    same(found.closed_loop, (PID + AHEAD) * closed)
    same(found.modified, (KP + KP * KI / s) * closed)
    same(found.compliance, closed)
    same(found.compensated, s * PLANT)


def test_feedforward_of_the_true_model_leaves_no_error() -> None:
    found = respond(model_gain=A, model_damping=B)
    assert np.abs(found.closed_loop - 1.0).max() < 1e-12


def test_velocity_from_differences() -> None:
    """K_V acts on s w/(s + w) P, and so does the observer."""
    corner = 800.0
    found = respond(velocity=FilteredDifference(bandwidth=corner))
    back = KP + KP * KI / s + KV * s * corner / (s + corner)
    same(found.loop_gain, back * PLANT)
    same(found.compliance, control.feedback(PLANT, back))


def observer(**changed: float) -> DisturbanceObserver:
    values = {"bandwidth": W_D, "filter_bandwidth": W_Z, "model_gain": MODEL_A, "model_damping": MODEL_B, **changed}
    return DisturbanceObserver(**values)


def test_loop_with_observer() -> None:
    """d_hat = Q ((s w_z/(s + w_z) + b_hat) v/a_hat - u), parallel to the controller."""
    found = respond(observer=observer())
    q = W_D / (s + W_D)
    seen = (s * W_Z / (s + W_Z) + MODEL_B) / MODEL_A
    # Solved for the applied command: u (1 - Q) = C e - Q F v, so the loop is C G + Q (F s G - 1).
    loop = PID * PLANT + q * (seen * s * PLANT - 1.0)
    same(found.loop_gain, loop)
    same(found.closed_loop, (PID + AHEAD) * PLANT / (1.0 + loop))
    # A load is an input of the same unit here: it is not in u, so the observer counts it as disturbance.
    same(found.compliance, PLANT * (1.0 - q) / (1.0 + loop))


def test_stiffness_at_very_low_frequency() -> None:
    """With integral and observer the compliance falls with the square of the frequency, without loss of digits."""
    controller = AxisController(PositionController(velocity_gain=KV, position_gain=KP, integral_gain=KI), observer=observer())
    low = np.array([1e-4, 1e-5])
    found = axis_response(Axis("x", RigidAxis(gain=A, damping=B)), controller, low).compliance
    # s -> 0: G (1 - Q)/(1 + L) with 1 - Q = s/w_d and L = K_P K_I a/(b s^2).
    assert np.abs(found / ((1j * low) ** 2 / (W_D * KP * KI)) - 1.0).max() < 1e-5


def test_compensated_axis_is_eqs_10_to_13() -> None:
    """V/U_c = a (s + w_z)(s + w_d)/(s^3 + (w_z + b) s^2 + ((w_z + b_hat) w_d a/a_hat + w_z b) s + w_d w_z b_hat a/a_hat)."""
    below = S**3 + (W_Z + B) * S**2 + ((W_Z + MODEL_B) * W_D * A / MODEL_A + W_Z * B) * S + W_D * W_Z * MODEL_B * A / MODEL_A
    found = respond(observer=observer(), velocity_gain=0.0, position_gain=0.0)
    assert np.abs(found.compensated / (A * (S + W_Z) * (S + W_D) / below) - 1.0).max() < 1e-9
    # With no controller V/D = a s (s + w_z)/(the same).
    assert np.abs(S * found.compliance / (A * S * (S + W_Z) / below) - 1.0).max() < 1e-9
    # The controller does not affect the inner loop of the observer.
    assert np.abs(respond(observer=observer()).compensated / found.compensated - 1.0).max() < 1e-12


def test_delay_changes_the_phase_only() -> None:
    delay = 3.7e-3
    late = respond(axis=Axis("x", RigidAxis(gain=A, damping=B), drive=DelayedSaturation(delay=delay))).loop_gain
    assert np.abs(late / respond().loop_gain - np.exp(-S * delay)).max() < 1e-12


class TwoMasses(SingleMass):
    """Motor and table on a spring: the command pushes the motor, the load the table; tachometer on the motor, scale on the table."""

    kind = "two-masses"

    def linearize(self) -> LinearModel:
        a = np.array([[0.0, 1.0, 0.0, 0.0], [-SPRING / MOTOR, 0.0, SPRING / MOTOR, 0.0], [0.0, 0.0, 0.0, 1.0]])
        a = np.vstack([a, [SPRING / TABLE, 0.0, -SPRING / TABLE, -4.0]])
        b = np.array([[0.0, 0.0], [1.0 / MOTOR, 0.0], [0.0, 0.0], [0.0, 1.0 / TABLE]])
        c = np.array([[0.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 0.0]])
        return LinearModel(a, b, c, np.zeros((2, 2)), ("command", "load"), ("position", "velocity"))


MOTOR, TABLE, SPRING = 2.0, 3.0, 4e4


def test_a_load_that_acts_elsewhere_than_the_drive() -> None:
    """Solved as one linear system per frequency: both masses, the controller, and a unit load on the table."""
    found = respond(axis=Axis("x", TwoMasses())).compliance
    for w, value in zip(W, found, strict=True):
        z = 1j * w
        # Unknowns: position of the motor, of the table, command.
        matrix = np.array(
            [
                [MOTOR * z * z + SPRING, -SPRING, -1.0],
                [-SPRING, TABLE * (z * z + 4.0 * z) + SPRING, 0.0],
                [KV * z, KP + KP * KI / z, 1.0],
            ]
        )
        assert value == pytest.approx(np.linalg.solve(matrix, [0.0, 1.0, 0.0])[1], rel=1e-8)


def test_a_component_without_a_linear_model_is_named() -> None:
    class Bang(Component):
        family = "controller"
        kind = "bang"

    with pytest.raises(ComponentError, match="bang"):
        axis_response(Axis("x", RigidAxis(gain=A, damping=B)), AxisController(Bang()), W)
