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
from contourlab.errors import ResultError
from contourlab.logs import Log
from contourlab.result import Result

__all__ = ["AxisFit", "axis_tables", "identify_rigid", "units_of"]

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
    name = _axis(result, axis)
    position, command, force = _signals(result, name, gain)
    fit = identify_inverse_dynamics(result.time, position, force, settings)
    checked = None
    if second is not None:
        there, _, pushed = _signals(second.result, name if name in second.result.axes else _axis(second.result, None), gain)
        checked = cross_validate(fit, second.result.time, there, pushed)
    return AxisFit(name, log.record.file.name, fit, gain if gain is not None else 1.0, command, position, result.servo_period, checked)


def _axis(result: Result, axis: str | None) -> str:
    if axis is None and len(result.axes) == 1:
        return result.axes[0]
    if axis not in result.axes:
        said = "which axis?" if axis is None else f"no axis {axis} in {result.scheme}:"
        raise ResultError(f"{said} There are {', '.join(result.axes)}: name one with --axis")
    return axis


def _signals(result: Result, axis: str, gain: float | None) -> tuple[Array, Array, Array]:
    """Return position [m], command and force [N] of an axis."""
    j = result.axes.index(axis)
    position = next((result[name][:, j] for name in ("position", "motor_position", "axis_position") if name in result), None)
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


def axis_tables(found: AxisFit) -> Mapping[str, Mapping[str, tuple[float | str, str, str]]]:
    """Return the tables of an axis file: for each key its value in SI, its unit there, and where it is from.

    Parameters
    ----------
    found : AxisFit

    Notes
    -----
    Friction that differs by direction is given as its mean: a component has one for both. What the axis cannot do is not in a log: limits
    are what was reached in it, and are called so.
    """
    fit = found.fit
    value = fit.parameters()
    deviation = dict(zip(fit.names, np.maximum(fit.deviations, fit.robust_deviations).tolist(), strict=True))
    signed = fit.settings.friction == "asymmetric"

    def mean(name: str) -> tuple[float, float]:
        if not signed:
            return value[name], deviation[name]
        pair = (f"{name}+", f"{name}-")
        return 0.5 * sum(value[p] for p in pair), 0.5 * float(np.hypot(*(deviation[p] for p in pair)))

    offset = 0.5 * (value["Fc+"] - value["Fc-"]) if signed else value["offset"]
    motion = np.gradient(found.position, found.period)
    steps = np.abs(np.diff(found.position))
    fitted = f"fitted to {found.source}, +- {{:.3g}} {{}} (one standard deviation)"
    reached = f"the largest in {found.source}, no limit of the axis"
    tables: dict[str, dict[str, tuple[float | str, str, str]]] = {
        "plant": {
            "kind": ("mass-damper", "", ""),
            "mass": (value["M"], "kg", fitted.format(deviation["M"], "kg")),
            "damping": (max(mean("Fv")[0], 0.0), "N*s/m", fitted.format(mean("Fv")[1], "N s/m")),
            "force_constant": (found.gain, "N/A", "as given; a command counts as so many amperes"),
        },
        "friction": {"kind": ("coulomb", "", ""), "coulomb": (max(mean("Fc")[0], 0.0), "N", fitted.format(mean("Fc")[1], "N"))},
        "disturbance": {"kind": ("constant", "", ""), "force": (-offset, "N", f"offset of the force, fitted to {found.source}")},
        "drive": {"kind": ("saturation", "", ""), "limit": (float(np.abs(found.command).max()), "A", reached)},
        "limits": {
            "velocity": (float(np.abs(motion).max()), "m/s", reached),
            "acceleration": (_fastest(found), "m/s^2", reached),
            "jerk": (100.0 * _fastest(found), "m/s^3", "assumed: the acceleration in 10 ms"),
        },
    }
    step = float(steps[steps > 0.0].min()) if steps.any() else 0.0
    if step > 0.0:
        tables["sensor"] = {"kind": ("encoder", "", ""), "resolution": (step, "m", f"the smallest step in {found.source}")}
    return tables


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
