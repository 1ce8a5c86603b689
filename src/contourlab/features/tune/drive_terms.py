"""A controller in drive terms: Kv, bandwidth of the velocity loop, and the gains of LinuxCNC's component ``pid`` with its law.

The law, from LinuxCNC's manual page pid(9) and source (``src/hal/components/pid.c``): error = command - feedback. The integral includes
the error of the same period. The derivative is the pin ``command-deriv`` minus ``feedback-deriv``; an unconnected pin is replaced by the
difference over a period. output = bias + Pgain error + Igain integral + Dgain derivative + FF0 command + FF1 command' + FF2 command'' +
FF3 command'''; command'' and command''' are differences of command'.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.linear.sampled_loop import SampledLoop, sampled_loop
from contourlab.analysis.linear.tick_map import DelayForm
from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.errors import ComponentError
from contourlab.figures import listing
from contourlab.findings import Finding, finding
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.result import Result
from contourlab.study.guards import model_of

GRID = 2000
"""Frequencies at which the velocity loop is evaluated."""


@dataclass(frozen=True)
class LinuxCNCGains:
    """Gains of LinuxCNC's ``pid`` in SI: command per metre, per metre and second, and so on.

    Attributes
    ----------
    p, i, d, ff0, ff1, ff2, ff3 : float
        Pgain, Igain, Dgain, FF0 to FF3.
    findings : tuple of Finding
        Additions that LinuxCNC's configuration needs, and parts that have no counterpart there.
    """

    p: float
    i: float = 0.0
    d: float = 0.0
    ff0: float = 0.0
    ff1: float = 0.0
    ff2: float = 0.0
    ff3: float = 0.0
    findings: tuple[Finding, ...] = field(default=(), metadata=HIDDEN)

    def per_millimetre(self) -> dict[str, float]:
        """Return the gains for an INI file with machine units of mm, by pin name."""
        names = {"Pgain": self.p, "Igain": self.i, "Dgain": self.d, "FF0": self.ff0, "FF1": self.ff1, "FF2": self.ff2, "FF3": self.ff3}
        return {name: 1e-3 * value for name, value in names.items()}


@dataclass(frozen=True)
class DriveTerms:
    """One axis in drive terms.

    Attributes
    ----------
    kv : float [1/s]
        Steady speed over position error, without velocity feedforward and integral. In a cascade: the position gain. nan if unknown.
    velocity_bandwidth : float [Hz]
        The -3 dB frequency of the sampled velocity loop, position loop open; nan without a velocity loop.
    difference, difference_rms : float
        Difference of LinuxCNC's law from the simulated command over a run, largest and rms, relative to the largest command; nan if not
        compared. At a step of the planned acceleration, LinuxCNC's FF2 acts one tick later.
    """

    axis: str
    kv: float
    velocity_bandwidth: float
    command_unit: str
    linuxcnc: LinuxCNCGains | None
    difference: float = math.nan
    difference_rms: float = math.nan


def drive_terms(machine: Machine, controller: Controller, run: Result | None = None) -> tuple[DriveTerms, ...]:
    """Return the drive terms of every axis; compare LinuxCNC's law with `run` if given."""
    terms = []
    for i, axis in enumerate(machine.axes):
        slots = controller.axes[axis.name]
        gains = linuxcnc_gains(slots, controller)
        difference = difference_rms = math.nan
        if run is not None and gains is not None and run.status.ok and _comparable(axis, slots):
            difference, difference_rms = law_difference(gains, slots, run, i)
        kv, bandwidth = _kv(machine, axis, slots, gains), _velocity_bandwidth(machine, axis, slots)
        terms.append(DriveTerms(axis.name, kv, bandwidth, axis.plant.command_unit, gains, difference, difference_rms))
    return tuple(terms)


def linuxcnc_findings(terms: Sequence[DriveTerms]) -> list[Finding]:
    """Return the findings on LinuxCNC's gains, each once with its axes."""
    axes: dict[str, tuple[Finding, list[str]]] = {}
    for one in terms:
        for remark in (finding("CL620"),) if one.linuxcnc is None else one.linuxcnc.findings:
            axes.setdefault(str(remark), (remark, []))[1].append(one.axis)
    return [replace(remark, place=f"{'axis' if len(names) == 1 else 'axes'} {listing(names)}") for remark, names in axes.values()]


def _comparable(axis: Axis, slots: AxisController) -> bool:
    """Return whether the command consists of the law, the observer's estimate and a feedforward that LinuxCNC also has."""
    others = (slots.compensation, slots.gap_observer, slots.supervisor, slots.predictor)
    ahead = slots.feedforward is None or slots.feedforward.kind == "inverse-dynamics"
    return ahead and not axis.plant.two_sided and not slots.filters and all(part is None for part in others)


def _kv(machine: Machine, axis: Axis, slots: AxisController, gains: LinuxCNCGains | None) -> float:
    if slots.controller.kind in ("cascade", "load-side-cascade"):
        return float(slots.controller.values()["position_gain"])
    if gains is None:
        return math.nan
    gain, damping = model_of(machine, axis, slots)
    below = gains.d + damping / gain
    return gains.p / below if below > 0.0 else math.inf


VELOCITY_ONLY: dict[str, dict[str, Any]] = {
    "position": {"position_gain": 0.0, "integral_gain": 0.0, "structure": "feedforward", "model_gain": math.inf},
    "state-feedback": {
        "position_gain": 0.0,
        "integral_gain": 0.0,
        "following": "model",
        "velocity_feedforward": 0.0,
        "acceleration_feedforward": 0.0,
        "jerk_feedforward": 0.0,
    },
    "cascade": {"position_gain": 0.0, "velocity_feedforward": 1.0, "acceleration_feedforward": 0.0},
}
"""Changes that reduce a controller to its velocity loop, driven by the reference velocity."""


def _velocity_bandwidth(machine: Machine, axis: Axis, slots: AxisController) -> float:
    changes = VELOCITY_ONLY.get(slots.controller.kind)
    if changes is None:
        return math.nan
    bare = replace(slots, controller=slots.controller.replace(**changes), feedforward=None)
    try:
        loop = sampled_loop(axis, bare, machine.servo_period, machine.carried_mass(axis.name))
    except ComponentError:
        return math.nan
    return _bandwidth(loop)


def _bandwidth(loop: SampledLoop) -> float:
    """Return the frequency [Hz] at which velocity over reference velocity has fallen by 3 dB; nan if it never does."""
    w = np.geomspace(1e-5 * loop.nyquist, loop.nyquist, GRID)
    response = DelayForm(*loop.closed, loop.state[1:2])(np.exp(1j * w * loop.servo_period))[:, 0, 1]
    size = np.abs(response) / abs(response[0]) if response[0] else np.zeros(GRID)
    below = np.flatnonzero(size < math.sqrt(0.5))
    if not below.size or below[0] == 0:
        return math.nan
    k = int(below[0])
    part = (size[k - 1] - math.sqrt(0.5)) / (size[k - 1] - size[k])
    return float(w[k - 1] + part * (w[k] - w[k - 1])) / (2.0 * math.pi)


def law_difference(gains: LinuxCNCGains, slots: AxisController, run: Result, axis: int) -> tuple[float, float]:
    """Return the difference of LinuxCNC's law from the command of a run, largest and rms, relative to the largest command.

    The disturbance estimate has no counterpart and is added to the command. The first half of the run is ignored.
    """
    target = "modified_reference" if "modified_reference" in run.signals else "reference"
    command = run["command"][:, axis]
    if slots.observer is not None:
        if "disturbance_estimate" not in run.signals:
            return math.nan, math.nan
        command = command + run["disturbance_estimate"][:, axis]
    if "coupling_command" in run.signals:
        command = command - run["coupling_command"][:, axis]
    ports = {port.name for port in slots.controller.inputs}
    measured = run["velocity"][:, axis] if "velocity" in ports else None
    planned = run["reference_velocity"][:, axis] if "reference_velocity" in ports or slots.feedforward is not None else None
    law = linuxcnc_law(gains, run[target][:, axis], run["position"][:, axis], run.servo_period, planned, measured)
    # Remove a constant: it is the earlier state of the integral, at the start or at a drive limit, and no effect of the gains.
    off = (law - command)[len(command) // 2 :]
    off, scale = off - np.median(off), float(np.abs(command).max())
    if not scale:
        return math.nan, math.nan  # an axis that stands still
    return float(np.abs(off).max()) / scale, float(np.sqrt(np.mean(off**2))) / scale


def linuxcnc_law(
    gains: LinuxCNCGains,
    command: ArrayLike,
    feedback: ArrayLike,
    period: float,
    command_derivative: ArrayLike | None = None,
    feedback_derivative: ArrayLike | None = None,
) -> Array:
    """Return the output (n,) of ``pid`` without limits, deadband and bias, enabled at the first sample.

    Parameters
    ----------
    command, feedback : array_like (n,) [m]
    period : float [s]
    command_derivative, feedback_derivative : array_like (n,) [m/s], optional
        Signals at ``command-deriv`` and ``feedback-deriv``; by default differences over a period.

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
    """Return the LinuxCNC gains of an axis controller; None for a kind without an equivalent ``pid``."""
    if axis.controller.kind not in MAPS:
        return None
    gains, missing = MAPS[axis.controller.kind](axis.controller)
    if axis.feedforward is not None and axis.feedforward.kind == "inverse-dynamics":
        values = axis.feedforward.values()
        gains = replace(gains, ff1=gains.ff1 + values["velocity_gain"], ff2=gains.ff2 + values["acceleration_gain"])
        missing += ["friction of the feedforward"] if values["friction"] else []
    elif axis.feedforward is not None:
        missing.append(f"feedforward {axis.feedforward.kind}")
    for slot in ("observer", "predictor", "compensation", "gap_observer", "supervisor"):
        part = getattr(axis, slot)
        missing += [] if part is None else [f"{slot.replace('_', ' ')} {part.kind}"]
    missing += [f"filter {part.kind}" for _, part in axis.filters]
    if controller.coupling is not None:
        missing.append(f"coupling {controller.coupling.kind}")
    findings = [*gains.findings]
    if missing:
        findings.append(finding("CL621", parts=tuple(missing)))
    if gains.ff0:
        findings.append(finding("CL622"))
    if gains.d and any(port.name == "velocity" for port in axis.controller.inputs):
        findings.append(finding("CL623"))
    return replace(gains, findings=tuple(findings))


Mapped = tuple[LinuxCNCGains, list[str]]
"""Gains, and the parts of the controller without a counterpart."""


def _position(part: Component) -> Mapped:
    v = part.values()
    p, i, d = v["position_gain"], v["position_gain"] * v["integral_gain"], v["velocity_gain"]
    if v["structure"] == "ipv":
        # The reference enters only through the integral: FF0 and FF1 cancel its P and D terms, except at the start.
        return LinuxCNCGains(p, i, d, -p, -d), []
    return LinuxCNCGains(p, i, d, ff1=v["model_damping"] / v["model_gain"], ff2=1.0 / v["model_gain"]), []


def _state_feedback(part: Component) -> Mapped:
    v = part.values()
    missing = ["feedback of acceleration"] if v["acceleration_gain"] else []
    base = LinuxCNCGains(v["position_gain"], v["integral_gain"], v["velocity_gain"])
    if v["following"] == "position":
        return replace(base, ff1=-v["velocity_gain"]), missing
    return replace(base, ff1=v["velocity_feedforward"], ff2=v["acceleration_feedforward"], ff3=v["jerk_feedforward"]), missing


def _pid(part: Component) -> Mapped:
    v = part.values()
    missing = [f"derivative filter of {v['derivative_bandwidth']:g} rad/s"] if v["derivative_gain"] else []
    ff1 = -v["derivative_gain"] if v["derivative_on"] == "measurement" else 0.0
    p = v["proportional_gain"]
    return LinuxCNCGains(p, v["integral_gain"], v["derivative_gain"], p * (v["reference_weight"] - 1.0), ff1), missing


def _cascade(part: Component) -> Mapped:
    v = part.values()
    kv, k, w = v["position_gain"], v["velocity_gain"], v["velocity_feedforward"]
    rate = k / v["integral_time"]
    # The integral of the velocity error is Kv times that of the position error, plus the position error itself.
    return LinuxCNCGains(k * kv + rate, rate * kv, k, rate * (w - 1.0), k * (w - 1.0), v["acceleration_feedforward"]), []


def _lead_lag(part: Component) -> Mapped:
    v = part.values()
    k, lead, ki = v["gain"], v["lead_time"] - v["lag_time"], v["integral_rate"]
    # K (a s + 1)/(b s + 1) (s + k_i)/s = K (k_i/s + 1 + k_i (a - b) + s (a - b)(1 - k_i b) + ...)
    slow = (finding("CL624", frequency=1.0 / v["lag_time"]),)
    return LinuxCNCGains(k * (1.0 + ki * lead), k * ki, k * lead * (1.0 - ki * v["lag_time"]), findings=slow), []


MAPS: dict[str, Callable[[Component], Mapped]] = {
    "position": _position,
    "state-feedback": _state_feedback,
    "pid": _pid,
    "cascade": _cascade,
    "lead-lag": _lead_lag,
}
