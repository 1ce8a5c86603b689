"""Frequency response of one axis in closed loop, in continuous time.

The linear models of the components are joined at each frequency, so that a transport delay is exact, not a rational approximation.
Compare designs in a paper with this response; the machine runs the sampled loop.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.linear.sampled_loop import AxisResponse
from contourlab.arrays import Complex
from contourlab.components.contract import Component, LinearModel, response_of
from contourlab.components.families import FAMILY
from contourlab.components.ideal import TrueVelocity
from contourlab.errors import ComponentError
from contourlab.loop.machine import Axis, AxisController


def transfer(model: LinearModel, s: ArrayLike) -> Complex:
    """Return C (s I - A)^-1 B + D for each s: (n, n_output, n_input)."""
    return response_of(model.a, model.b, model.c, model.d, s)


def _model(part: Component) -> LinearModel:
    model = part.linearize()
    if model is None:
        raise ComponentError(f"{part.family} {part.kind} has no linear model, so the loop has no frequency response")
    return model


def axis_response(axis: Axis, controller: AxisController, frequency: ArrayLike) -> AxisResponse:
    """Return the frequency responses of an axis with its controller, without friction, quantisation and limits.

    Parameters
    ----------
    axis : Axis
        With a single mass.
    controller : AxisController
        Without a predictor.
    frequency : array_like (n,) [rad/s], > 0

    Raises
    ------
    ComponentError
        If a component has no linear model.
    """
    w = np.atleast_1d(np.asarray(frequency, dtype=float))
    s = np.asarray(1j * w, dtype=np.complex128)
    moved = transfer(_model(axis.plant), s)
    position, velocity, position_load, velocity_load = moved[:, 0, 0], moved[:, 1, 0], moved[:, 0, 1], moved[:, 1, 1]
    seen = _velocity_row(controller, s)
    measured = velocity if seen is None else seen * position
    measured_load = velocity_load if seen is None else seen * position_load
    of_velocity, of_applied = _observer_rows(controller, s)
    gains = _gains(_model(controller.controller), s)
    drive = np.exp(-s * float(getattr(axis.drive, "delay", 0.0)))

    # Command over applied command with the reference at rest.
    estimate = of_velocity * measured + of_applied
    back = gains["position"] * position + gains["velocity"] * measured + gains["disturbance_estimate"] * estimate
    inside = 1.0 - drive * gains["disturbance_estimate"] * of_applied
    # Zero for a single mass, whose load acts where its drive does. In this form no large terms cancel at low frequencies.
    apart = (gains["velocity"] + gains["disturbance_estimate"] * of_velocity) * (measured_load * position - measured * position_load)
    forward = gains["reference"] + s * gains["reference_velocity"] + s * s * gains["reference_acceleration"]
    forward = forward + gains["feedforward"] * _fed_forward(controller, s)
    applied = drive / (1.0 - drive * back)
    inner = drive / (1.0 - drive * gains["disturbance_estimate"] * estimate)
    return AxisResponse(
        frequency=w,
        closed_loop=position * applied * forward,
        modified=position * applied * gains["reference"],
        loop_gain=-drive * back,
        compliance=(position_load * inside + drive * apart) / (1.0 - drive * back),
        compensated=velocity * inner,
    )


def _gains(model: LinearModel, s: Complex) -> dict[str, Complex]:
    """Return the command over each possible input of a controller; zero for an input that it lacks."""
    rows = transfer(model, s)
    offered = FAMILY["controller"].inputs
    return {name: rows[:, 0, model.inputs.index(name)] if name in model.inputs else np.zeros_like(s) for name in offered}


def _fed_forward(controller: AxisController, s: Complex) -> Complex:
    """Return the command over the reference of the feedforward; zero without one or if it is not linear."""
    model = None if controller.feedforward is None else controller.feedforward.linearize()
    if model is None or "command" not in model.outputs:
        return np.zeros_like(s)
    rows = transfer(model, s)[:, model.outputs.index("command")]
    order = {"reference": 0, "reference_velocity": 1, "reference_acceleration": 2}
    return np.asarray(sum(rows[:, i] * s ** order[name] for i, name in enumerate(model.inputs)))


def _velocity_row(controller: AxisController, s: Complex) -> Complex | None:
    if isinstance(controller.velocity, TrueVelocity):
        return None
    return transfer(_model(controller.velocity), s)[:, 0, 0]


def _observer_rows(controller: AxisController, s: Complex) -> tuple[Complex, Complex]:
    if controller.observer is None:
        return np.zeros_like(s), np.zeros_like(s)
    rows = transfer(_model(controller.observer), s)
    return rows[:, 0, 0], rows[:, 0, 1]
