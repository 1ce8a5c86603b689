"""An axis out of a measured log: mass, friction and offset, and the file of an axis that they make."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.inverse_dynamics import (
    InverseDynamicsFit,
    InverseDynamicsSettings,
    Validation,
    cross_validate,
    identify_inverse_dynamics,
)
from contourlab.components.origin import Origin
from contourlab.errors import ResultError
from contourlab.logs import Log
from contourlab.result import Result
from contourlab.studies.identification.signals import POSITIONS, chosen_axis

__all__ = ["AxisFit", "axis_tables", "correlations", "identify_rigid", "units_of"]

Array = NDArray[np.float64]
UNITS = {"M": "kg", "Fv": "N*s/m", "Fc": "N", "offset": "N"}
"""Of the parameters, without the signs of a direction."""


@dataclass(frozen=True, eq=False)
class AxisFit:
    """An axis found from a log.

    Attributes
    ----------
    axis : str
    source : str
        Name of the log.
    fit : InverseDynamicsFit
    gain : float [N per unit of command]
        1 where the log has the force itself.
    command : ndarray (n,)
    position : ndarray (n,) [m]
    period : float [s]
    validation : Validation or None
        On a second log, with the parameters of the first.
    """

    axis: str
    source: str
    fit: InverseDynamicsFit
    gain: float
    command: Array
    position: Array
    period: float
    validation: Validation | None = None


def identify_rigid(
    log: Log, axis: str | None = None, gain: float | None = None, settings: InverseDynamicsSettings | None = None, second: Log | None = None
) -> AxisFit:
    """Find mass, friction and offset of one axis of a log.

    Parameters
    ----------
    log : Log
        With the position, and the force or the command.
    axis : str, optional
        By default the only one that the log has.
    gain : float [N per unit of command], optional
        Force of the drive per command; wanted where the log has no force.
    settings : InverseDynamicsSettings, optional
    second : Log, optional
        Another record of the same axis, to see what the parameters are worth there.

    Raises
    ------
    ResultError
        If the log has several axes and none is named, or lacks a signal.
    ParameterError
        As of `contourlab.analysis.inverse_dynamics.identify_inverse_dynamics`.
    """
    result = log.result
    name = chosen_axis(result, axis)
    position, command, force = _signals(result, name, gain)
    fit = identify_inverse_dynamics(result.time, position, force, settings)
    checked = None
    if second is not None:
        there, _, pushed = _signals(second.result, name if name in second.result.axes else chosen_axis(second.result, None), gain)
        checked = cross_validate(fit, second.result.time, there, pushed)
    return AxisFit(name, log.record.file.name, fit, gain if gain is not None else 1.0, command, position, result.servo_period, checked)


def _signals(result: Result, axis: str, gain: float | None) -> tuple[Array, Array, Array]:
    """Return position [m], command and force [N] of an axis."""
    j = result.axes.index(axis)
    position = next((result[name][:, j] for name in POSITIONS if name in result), None)
    if position is None:
        raise ResultError(f"no position of {axis} in {result.scheme}: say --column 'position.{axis}=NAME [mm]'")
    if "force" in result and gain is None:
        return position, result["force"][:, j], result["force"][:, j]
    if "command" not in result:
        raise ResultError(f"no force and no command of {axis} in {result.scheme}: say --column 'force.{axis}=NAME [N]'")
    if gain is None:
        raise ResultError('how much force is a command? Give --gain, as "35.15 N/V"')
    command = result["command"][:, j]
    return position, command, gain * command


def axis_tables(found: AxisFit) -> Mapping[str, Mapping[str, tuple[float | str, str, Origin | None]]]:
    """Return the tables of an axis file: for each key its value in SI, its unit there, and where it is from.

    Parameters
    ----------
    found : AxisFit

    Notes
    -----
    Friction that differs by direction is given as its mean: a component has one for both. The deviations are those that allow for the
    residual's colour, where they are the larger ones. What the axis cannot do is not in a log: limits are what was reached in it, and are
    called so.
    """
    value, deviation = _estimates(found)
    motion = np.gradient(found.position, found.period)
    steps = np.abs(np.diff(found.position))
    given = Origin("assumed", note="as given; a command counts as so many amperes")

    def fitted(name: str) -> Origin:
        return Origin("fitted", deviation=deviation[name] if deviation[name] > 0.0 else None, reference=found.source)

    def reached(note: str = "the largest in the log, no limit of the axis") -> Origin:
        return Origin("measured", reference=found.source, note=note)

    tables: dict[str, dict[str, tuple[float | str, str, Origin | None]]] = {
        "plant": {
            "kind": ("mass-damper", "", None),
            "mass": (value["M"], "kg", fitted("M")),
            "damping": (max(value["Fv"], 0.0), "N*s/m", fitted("Fv")),
            "force_constant": (found.gain, "N/A", given),
        },
        "friction": {"kind": ("coulomb", "", None), "coulomb": (max(value["Fc"], 0.0), "N", fitted("Fc"))},
        "disturbance": {"kind": ("constant", "", None), "force": (-value["offset"], "N", fitted("offset"))},
        "drive": {"kind": ("saturation", "", None), "limit": (float(np.abs(found.command).max()), "A", reached())},
        "limits": {
            "velocity": (float(np.abs(motion).max()), "m/s", reached()),
            "acceleration": (_fastest(found), "m/s^2", reached()),
            "jerk": (100.0 * _fastest(found), "m/s^3", Origin("assumed", note="the acceleration in 10 ms")),
        },
    }
    step = float(steps[steps > 0.0].min()) if steps.any() else 0.0
    if step > 0.0:
        tables["sensor"] = {"kind": ("encoder", "", None), "resolution": (step, "m", reached("the smallest step in the log"))}
    return tables


NUMBERS = {"M": "plant.mass", "Fv": "plant.damping", "Fc": "friction.coulomb", "offset": "disturbance.force"}
"""Where the figures of a fit stand in an axis file."""


def _combined(found: AxisFit) -> Array:
    """Return the matrix that makes M, Fv, Fc and the offset of the figures of the fit."""
    if found.fit.settings.friction == "symmetric":
        return np.eye(4)
    return np.array([[1.0, 0, 0, 0, 0], [0, 0.5, 0, 0.5, 0], [0, 0, 0.5, 0, 0.5], [0, 0, 0.5, 0, -0.5]])


def _covariance(found: AxisFit) -> Array:
    """Return the covariance of M, Fv, Fc and the offset: the larger deviations, and the correlation of a white residual."""
    fit, combined = found.fit, _combined(found)
    deviations = np.maximum(fit.deviations, fit.robust_deviations)
    found_together: Array = combined @ (fit.correlation * np.outer(deviations, deviations)) @ combined.T
    return found_together


def _estimates(found: AxisFit) -> tuple[dict[str, float], dict[str, float]]:
    values = _combined(found) @ found.fit.values
    deviations = np.sqrt(np.diag(_covariance(found)))
    return dict(zip(NUMBERS, values.tolist(), strict=True)), dict(zip(NUMBERS, deviations.tolist(), strict=True))


def correlations(found: AxisFit) -> list[tuple[str, str, float]]:
    """Return the correlations of the numbers of the axis file, two by two; the force of the disturbance is the offset's opposite."""
    covariance = _covariance(found)
    scale = np.sqrt(np.diag(covariance))
    if not scale.all():
        return []
    matrix, names = covariance / np.outer(scale, scale), list(NUMBERS.values())
    sign = [-1.0 if name == "disturbance.force" else 1.0 for name in names]
    pairs = [(i, j) for i in range(len(names)) for j in range(i)]
    return [(names[j], names[i], round(sign[i] * sign[j] * float(matrix[i, j]), 4)) for i, j in pairs]


def _fastest(found: AxisFit) -> float:
    """Return the largest acceleration [m/s^2] of the rows that were fitted: force less friction, over the mass."""
    fit = found.fit
    value = fit.parameters()
    signed = fit.settings.friction == "asymmetric"
    v = fit.velocity
    if signed:
        friction = np.where(v > 0.0, value["Fv+"] * v + value["Fc+"], value["Fv-"] * v - value["Fc-"])
    else:
        friction = value["Fv"] * v + value["Fc"] * np.sign(v) + value["offset"]
    return float(np.abs(fit.predicted - friction).max() / value["M"])


def units_of(names: tuple[str, ...]) -> tuple[str, ...]:
    """Return the unit of each parameter."""
    return tuple(UNITS[name.rstrip("+-")] for name in names)
