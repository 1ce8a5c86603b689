"""Frequency response of one axis in closed loop, from the linear models that its components give of themselves.

The blocks are joined at each frequency, so that transport delay and the hold of the servo period are exact, not approximated by a
rational function.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.components.contract import Component, LinearModel
from contourlab.components.velocity.true import TrueVelocity
from contourlab.errors import ComponentError, ParameterError
from contourlab.loop.machine import Axis, AxisController

__all__ = ["AxisResponse", "Margins", "axis_response", "margins", "transfer"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class AxisResponse:
    """Complex responses (n_frequency,) of one axis.

    Attributes
    ----------
    frequency : ndarray [rad/s]
    closed_loop : ndarray
        Position over reference, feedforward included.
    modified : ndarray
        Position over modified reference alone: what acts on position and integral, without feedforward of its derivatives.
    loop_gain : ndarray
        The loop opened at the drive, sign such that -1 is the critical point.
    compliance : ndarray [m per force unit]
        Position over load.
    compensated : ndarray [m/s per command unit]
        Velocity over the command ahead of the observer: what the position loop sees.
    """

    frequency: Array
    closed_loop: Complex
    modified: Complex
    loop_gain: Complex
    compliance: Complex
    compensated: Complex


@dataclass(frozen=True)
class Margins:
    """Stability margins of a loop gain.

    Attributes
    ----------
    gain : float
        Smallest factor > 1 at which the loop would reach -1; infinite if none in the range looked at.
    phase : float [rad]
        Smallest phase lag at a gain of 1 that would reach -1.
    crossover : float [rad/s]
        Frequency of that phase margin.
    modulus : float
        Smallest distance of the loop gain from -1.
    """

    gain: float
    phase: float
    crossover: float
    modulus: float


def transfer(model: LinearModel, s: ArrayLike) -> Complex:
    """Return C (s I - A)^-1 B + D for each s: (n, n_output, n_input)."""
    points = np.atleast_1d(np.asarray(s, dtype=complex))
    if model.a.shape[0] == 0:
        return np.broadcast_to(model.d.astype(complex), (points.size, *model.d.shape))
    eye = np.eye(model.a.shape[0])
    inner = np.linalg.solve(points[:, None, None] * eye - model.a, np.broadcast_to(model.b.astype(complex), (points.size, *model.b.shape)))
    return np.asarray(model.c @ inner + model.d)


def _model(part: Component) -> LinearModel:
    model = part.linearize()
    if model is None:
        raise ComponentError(f"{part.family} {part.kind} has no linear model, so the loop has no frequency response")
    return model


def axis_response(
    axis: Axis, controller: AxisController, servo_period: float, frequency: ArrayLike, carried_mass: float = 0.0
) -> AxisResponse:
    """Return the frequency responses of an axis under its controller, friction, quantisation and limits left out.

    Parameters
    ----------
    axis : Axis
    controller : AxisController
    servo_period : float [s], >= 0
        Of the hold; 0 for continuous time.
    frequency : array_like (n,) [rad/s], > 0
    carried_mass : float [kg]
        What other axes put on this one.

    Raises
    ------
    ComponentError
        If a component has no linear model.
    ParameterError
        If a frequency is not positive.
    """
    w = np.atleast_1d(np.asarray(frequency, dtype=float))
    if not (np.isfinite(w).all() and (w > 0.0).all()):
        raise ParameterError("frequency", "an array", "> 0 and finite", "rad/s")
    s = 1j * w
    plant = axis.plant
    if carried_mass and "carried_mass" in plant.parameters:
        plant = plant.replace(carried_mass=plant.carried_mass + carried_mass)  # type: ignore[attr-defined]
    moved = transfer(_model(plant), s)
    position, velocity, position_load, velocity_load = moved[:, 0, 0], moved[:, 1, 0], moved[:, 0, 1], moved[:, 1, 1]
    seen = _velocity_row(controller, s)
    measured = velocity if seen is None else seen * position
    measured_load = velocity_load if seen is None else seen * position_load
    of_velocity, of_applied = _observer_rows(controller, s)
    gains = {name: transfer(_model(controller.controller), s)[:, 0, i] for i, name in enumerate(_model(controller.controller).inputs)}
    drive = _drive(axis.drive, s, servo_period)

    # Command per applied command with the reference at rest.
    estimate = of_velocity * measured + of_applied
    back = gains["position"] * position + gains["velocity"] * measured + gains["disturbance_estimate"] * estimate
    inside = 1.0 - drive * gains["disturbance_estimate"] * of_applied
    # Zero for a single mass, whose load acts where its drive does. Put together like this nothing large cancels at low frequencies.
    apart = (gains["velocity"] + gains["disturbance_estimate"] * of_velocity) * (measured_load * position - measured * position_load)
    forward = gains["reference"] + s * gains["reference_velocity"] + s * s * gains["reference_acceleration"]
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


def _velocity_row(controller: AxisController, s: Complex) -> Complex | None:
    if isinstance(controller.velocity, TrueVelocity):
        return None
    return transfer(_model(controller.velocity), s)[:, 0, 0]


def _observer_rows(controller: AxisController, s: Complex) -> tuple[Complex, Complex]:
    if controller.observer is None:
        return np.zeros_like(s), np.zeros_like(s)
    rows = transfer(_model(controller.observer), s)
    return rows[:, 0, 0], rows[:, 0, 1]


def _drive(drive: Component, s: Complex, period: float) -> Complex:
    """Hold over the servo period, and the drive's own delay."""
    late = np.exp(-s * float(getattr(drive, "delay", 0.0)))
    if period <= 0.0:
        return np.asarray(late)
    return np.asarray(late * (1.0 - np.exp(-s * period)) / (s * period))


def margins(frequency: ArrayLike, loop_gain: ArrayLike) -> Margins:
    """Return the margins of a loop gain sampled over rising frequencies, crossings interpolated linearly in log frequency.

    Parameters
    ----------
    frequency : array_like (n,) [rad/s]
    loop_gain : array_like (n,)
    """
    w, gain = np.asarray(frequency, dtype=float), np.asarray(loop_gain, dtype=complex)
    size, phase = np.log(np.abs(gain)), np.unwrap(np.angle(gain))
    log_w = np.log(w)
    unity = _crossings(size, 0.0)
    phases = [(float(np.angle(-np.exp(1j * _at(phase, i, u)))), float(np.exp(_at(log_w, i, u)))) for i, u in unity]
    worst = min(phases, key=lambda item: abs(item[0]), default=(np.inf, np.nan))
    turns = []
    low, high = np.floor(phase.min() / (2 * np.pi)) - 1, np.ceil(phase.max() / (2 * np.pi)) + 1
    for n in np.arange(low, high + 1):
        turns += [float(np.exp(-_at(size, i, u))) for i, u in _crossings(phase, (2 * n + 1) * np.pi)]
    larger = [factor for factor in turns if factor > 1.0]
    return Margins(min(larger, default=np.inf), worst[0], worst[1], float(np.abs(1.0 + gain).min()))


def _crossings(values: Array, level: float) -> list[tuple[int, float]]:
    above = values > level
    found = np.flatnonzero(above[1:] != above[:-1])
    return [(int(i), float((level - values[i]) / (values[i + 1] - values[i]))) for i in found]


def _at(values: Array, i: int, u: float) -> float:
    return float(values[i] + u * (values[i + 1] - values[i]))
