"""Gains in the terms of LinuxCNC's component ``pid``, and its law, so that what was mapped can be run beside what was calibrated.

Its manual page pid(9) and source (``src/hal/components/pid.c``) say: error = command - feedback; the integral takes in the error of the
same period; the derivative is that of the pin ``command-deriv`` less that of ``feedback-deriv``, each the difference over a period where
nothing is connected; output = bias + Pgain error + Igain integral + Dgain derivative + FF0 command + FF1 command' + FF2 command'' + FF3
command''', of which the second and third are differences of command'.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.components.contract import Component
from contourlab.loop import AxisController, Controller

Array = NDArray[np.float64]


@dataclass(frozen=True)
class LinuxCNCGains:
    """Gains in SI: command per metre, per metre and second, and so on; `notes` says what has no counterpart.

    Attributes
    ----------
    p, i, d, ff0, ff1, ff2, ff3 : float
        Pgain, Igain, Dgain, FF0 to FF3.
    notes : tuple of str
    """

    p: float
    i: float = 0.0
    d: float = 0.0
    ff0: float = 0.0
    ff1: float = 0.0
    ff2: float = 0.0
    ff3: float = 0.0
    notes: tuple[str, ...] = ()

    def per_millimetre(self) -> dict[str, float]:
        """Return them as an INI file with machine units of mm has them, with the names of the pins."""
        names = {"Pgain": self.p, "Igain": self.i, "Dgain": self.d, "FF0": self.ff0, "FF1": self.ff1, "FF2": self.ff2, "FF3": self.ff3}
        return {name: 1e-3 * value for name, value in names.items()}


def linuxcnc_law(
    gains: LinuxCNCGains,
    command: ArrayLike,
    feedback: ArrayLike,
    period: float,
    command_derivative: ArrayLike | None = None,
    feedback_derivative: ArrayLike | None = None,
) -> Array:
    """Return the output (n,) of the component ``pid``, without limits, deadband and bias, enabled at the first sample.

    Parameters
    ----------
    gains : LinuxCNCGains
    command, feedback : array_like (n,) [m]
    period : float [s]
    command_derivative, feedback_derivative : array_like (n,) [m/s], optional
        What is connected to ``command-deriv`` and ``feedback-deriv``; differences over a period where nothing is.

    >>> linuxcnc_law(LinuxCNCGains(p=2.0, i=1.0), [1.0, 1.0], [0.0, 0.5], 0.1).tolist()
    [2.1, 1.15]
    """
    to, at = np.asarray(command, dtype=float), np.asarray(feedback, dtype=float)
    error = to - at

    def slope(values: Array) -> Array:
        return np.diff(values, prepend=values[:1]) / period

    rate = slope(to) if command_derivative is None else np.asarray(command_derivative, dtype=float)
    back = slope(at) if feedback_derivative is None else np.asarray(feedback_derivative, dtype=float)
    second = slope(rate)
    law = gains.p * error + gains.i * np.cumsum(error) * period + gains.d * (rate - back)
    return np.asarray(law + gains.ff0 * to + gains.ff1 * rate + gains.ff2 * second + gains.ff3 * slope(second))


def linuxcnc_gains(axis: AxisController, controller: Controller) -> LinuxCNCGains | None:
    """Return the gains of an axis' controller in LinuxCNC's terms; None for a kind that has no likeness there.

    Parameters
    ----------
    axis : AxisController
    controller : Controller
        Whose coupling has no counterpart.
    """
    made = MAPS.get(axis.controller.kind)
    found = None if made is None else made(axis.controller)
    if found is None:
        return None
    notes = list(found.notes)
    ahead = axis.feedforward
    if ahead is not None and ahead.kind == "inverse-dynamics":
        values = ahead.values()
        found = replace(found, ff1=found.ff1 + values["velocity_gain"], ff2=found.ff2 + values["acceleration_gain"])
    elif ahead is not None:
        notes.append(f"the feedforward {ahead.kind} has no counterpart")
    for slot in ("observer", "predictor", "compensation", "gap_observer", "supervisor"):
        part = getattr(axis, slot)
        if part is not None:
            named = f"the {slot.replace('_', ' ')} {part.kind}"
            notes.append(f"{named} has no counterpart: its output is to be added behind pid, by a component of its own")
    if controller.coupling is not None:
        notes.append(f"the coupling {controller.coupling.kind} has no counterpart: axes are on their own there")
    if any(port.name == "velocity" for port in axis.controller.inputs) and found.d:
        notes.append("connect a filtered velocity to feedback-deriv and the planner's to command-deriv: differences of counts are rougher")
    return replace(found, notes=tuple(notes))


def _position(part: Component) -> LinuxCNCGains:
    v = part.values()
    p, i, d = v["position_gain"], v["position_gain"] * v["integral_gain"], v["velocity_gain"]
    if v["structure"] == "ipv":
        # The reference enters by the integral alone: FF0 and FF1 take out what P and D make of it, but for the start.
        return LinuxCNCGains(p, i, d, -p, -d, notes=("bias is to be Pgain times the position at the start",))
    return LinuxCNCGains(p, i, d, ff1=v["model_damping"] / v["model_gain"], ff2=1.0 / v["model_gain"])


def _state_feedback(part: Component) -> LinuxCNCGains:
    v = part.values()
    notes = ("the feedback of acceleration has no counterpart",) if v["acceleration_gain"] else ()
    base = LinuxCNCGains(v["position_gain"], v["integral_gain"], v["velocity_gain"], notes=notes)
    if v["following"] == "position":
        return replace(base, ff1=-v["velocity_gain"])
    return replace(base, ff1=v["velocity_feedforward"], ff2=v["acceleration_feedforward"], ff3=v["jerk_feedforward"])


def _pid(part: Component) -> LinuxCNCGains:
    v = part.values()
    notes = [f"the filter of the derivative, {v['derivative_bandwidth']:g} rad/s, has no counterpart"] if v["derivative_gain"] else []
    weight = v["reference_weight"] - 1.0
    if weight:
        notes.append("bias is to be -FF0 times the position at the start")
    ff1 = -v["derivative_gain"] if v["derivative_on"] == "measurement" else 0.0
    p = v["proportional_gain"]
    return LinuxCNCGains(p, v["integral_gain"], v["derivative_gain"], p * weight, ff1, notes=tuple(notes))


def _cascade(part: Component) -> LinuxCNCGains:
    v = part.values()
    kv, k, w = v["position_gain"], v["velocity_gain"], v["velocity_feedforward"]
    rate = k / v["integral_time"]
    # The integral of the velocity's error is that of the position's error times Kv, and the error itself.
    notes = ("bias is to be -FF0 times the position at the start",) if rate and w != 1.0 else ()
    return LinuxCNCGains(k * kv + rate, rate * kv, k, rate * (w - 1.0), k * (w - 1.0), v["acceleration_feedforward"], notes=notes)


def _lead_lag(part: Component) -> LinuxCNCGains:
    v = part.values()
    k, lead, ki = v["gain"], v["lead_time"] - v["lag_time"], v["integral_rate"]
    # K (a s + 1)/(b s + 1) (s + k_i)/s = K (k_i/s + 1 + k_i (a - b) + s (a - b)(1 - k_i b) + ...)
    notes = (f"the same only well below {1.0 / v['lag_time']:.4g} rad/s: the lag has no counterpart",)
    return LinuxCNCGains(k * (1.0 + ki * lead), k * ki, k * lead * (1.0 - ki * v["lag_time"]), notes=notes)


MAPS: dict[str, Callable[[Component], LinuxCNCGains]] = {
    "position": _position,
    "state-feedback": _state_feedback,
    "pid": _pid,
    "cascade": _cascade,
    "lead-lag": _lead_lag,
}
