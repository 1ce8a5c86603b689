"""A controller in drive terms: Kv, bandwidth of the velocity loop, and the gains of LinuxCNC's component ``pid`` with its law.

The law, from LinuxCNC's manual page pid(9) and source (``src/hal/components/pid.c``): error = command - feedback. The integral includes
the error of the same period. The derivative is the pin ``command-deriv`` minus ``feedback-deriv``; an unconnected pin is replaced by the
difference over a period. output = bias + Pgain error + Igain integral + Dgain derivative + FF0 command + FF1 command' + FF2 command'' +
FF3 command'''; command'' and command''' are differences of command'.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.analysis.linear.tick_map import DelayForm
from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.errors import ComponentError
from contourlab.figures import listing
from contourlab.findings import Finding, finding
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.result import Result
from contourlab.scenario.build import model_of

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
        names = {"p": "Pgain", "i": "Igain", "d": "Dgain", "ff0": "FF0", "ff1": "FF1", "ff2": "FF2", "ff3": "FF3"}
        return {pin: 1e-3 * getattr(self, name) for name, pin in names.items()}


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
    """Return the drive terms of every axis with a loop; compare LinuxCNC's law with `run` if given."""
    terms = []
    for i, axis in enumerate(machine.axes):
        slots = controller.axes[axis.name]
        if axis.plant.takes_position:
            continue
        gains = linuxcnc_gains(slots, controller)
        comparable = run is not None and gains is not None and run.status.ok and _comparable(axis, slots)
        difference = law_difference(gains, slots, run, i) if comparable else ()  # type: ignore[arg-type]
        kv, bandwidth = _kv(machine, axis, slots, gains), _velocity_bandwidth(machine, axis, slots)
        terms.append(DriveTerms(axis.name, kv, bandwidth, axis.plant.command_unit, gains, *difference))
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
    gain, damping = model_of(machine, axis, slots.observer)
    below = gains.d + damping / gain
    return gains.p / below if below > 0.0 else math.inf


VELOCITY_ONLY: dict[str, dict[str, Any]] = {
    "position": {"position_gain": 0.0, "integral_gain": 0.0, "structure": "feedforward", "model_gain": math.inf},
    "state-feedback": {
        "following": "model",
        **dict.fromkeys(("position_gain", "integral_gain"), 0.0),
        **dict.fromkeys(("velocity_feedforward", "acceleration_feedforward", "jerk_feedforward"), 0.0),
    },
    "cascade": {"position_gain": 0.0, "velocity_feedforward": 1.0, "acceleration_feedforward": 0.0},
}
"""Changes that reduce a controller to its velocity loop, driven by the reference velocity."""


def _velocity_bandwidth(machine: Machine, axis: Axis, slots: AxisController) -> float:
    """Return the frequency [Hz] at which velocity over reference velocity has fallen by 3 dB; nan if it never does, or is unknown."""
    if slots.controller.kind not in VELOCITY_ONLY:
        return math.nan
    bare = replace(slots, controller=slots.controller.replace(**VELOCITY_ONLY[slots.controller.kind]), feedforward=None)
    try:
        loop = sampled_loop(axis, bare, machine.servo_period, machine.carried_mass(axis.name))
    except ComponentError:
        return math.nan
    w = np.geomspace(1e-5 * loop.nyquist, loop.nyquist, GRID)
    response = DelayForm(*loop.closed, loop.state[1:2])(np.exp(1j * w * loop.servo_period))[:, 0, 1]
    size = np.abs(response) / abs(response[0]) if response[0] else np.zeros(GRID)
    k = int(np.argmax(size < math.sqrt(0.5)))
    if k == 0:
        return math.nan
    part = (size[k - 1] - math.sqrt(0.5)) / (size[k - 1] - size[k])
    return float(w[k - 1] + part * (w[k] - w[k - 1])) / (2.0 * math.pi)


def law_difference(gains: LinuxCNCGains, slots: AxisController, run: Result, axis: int) -> tuple[float, float]:
    """Return the difference of LinuxCNC's law from the command of a run, largest and rms, relative to the largest command.

    The disturbance estimate has no counterpart and is added to the command. The first half of the run is ignored.
    """
    signals = {name: run[name][:, axis] for name in run.signals if run[name].ndim == 2}
    command = signals["command"]
    if slots.observer is not None:
        if "disturbance_estimate" not in signals:
            return math.nan, math.nan
        command = command + signals["disturbance_estimate"]
    if "coupling_command" in signals:
        command = command - signals["coupling_command"]
    ports = {port.name for port in slots.controller.inputs}
    measured = signals["velocity"] if "velocity" in ports else None
    planned = signals["reference_velocity"] if "reference_velocity" in ports or slots.feedforward is not None else None
    target = signals.get("modified_reference", signals["reference"])
    law = linuxcnc_law(gains, target, signals["position"], run.servo_period, planned, measured)
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
    law = _law(axis.controller)
    if law is None:
        return None
    gains, missing = law
    if axis.feedforward is not None and axis.feedforward.kind == "inverse-dynamics":
        values = axis.feedforward.values()
        gains = replace(gains, ff1=gains.ff1 + values["velocity_gain"], ff2=gains.ff2 + values["acceleration_gain"])
        missing += ["friction of the feedforward"] if values["friction"] else []
    elif axis.feedforward is not None:
        missing.append(f"feedforward {axis.feedforward.kind}")
    slots = ("observer", "predictor", "compensation", "gap_observer", "supervisor")
    others = [*((slot.replace("_", " "), getattr(axis, slot)) for slot in slots), *(("filter", part) for _, part in axis.filters)]
    missing += [f"{called} {part.kind}" for called, part in (*others, ("coupling", controller.coupling)) if part is not None]
    findings = [*gains.findings, *([finding("CL621", parts=tuple(missing))] if missing else []), *([finding("CL622")] if gains.ff0 else [])]
    if gains.d and any(port.name == "velocity" for port in axis.controller.inputs):
        findings.append(finding("CL623"))
    return replace(gains, findings=tuple(findings))


def _law(part: Component) -> tuple[LinuxCNCGains, list[str]] | None:
    """Return the gains of a control law, and its parts without a counterpart; None for another kind."""
    v = part.values()
    match part.kind:
        case "position":
            p, i, d = v["position_gain"], v["position_gain"] * v["integral_gain"], v["velocity_gain"]
            if v["structure"] == "ipv":
                # The reference enters only through the integral: FF0 and FF1 cancel its P and D terms, except at the start.
                return LinuxCNCGains(p, i, d, -p, -d), []
            return LinuxCNCGains(p, i, d, ff1=v["model_damping"] / v["model_gain"], ff2=1.0 / v["model_gain"]), []
        case "state-feedback":
            ahead = (v["velocity_feedforward"], v["acceleration_feedforward"], v["jerk_feedforward"])
            ahead = (-v["velocity_gain"], 0.0, 0.0) if v["following"] == "position" else ahead
            gains = LinuxCNCGains(v["position_gain"], v["integral_gain"], v["velocity_gain"], 0.0, *ahead)
            return gains, ["feedback of acceleration"] if v["acceleration_gain"] else []
        case "pid":
            missing = [f"derivative filter of {v['derivative_bandwidth']:g} rad/s"] if v["derivative_gain"] else []
            ff1 = -v["derivative_gain"] if v["derivative_on"] == "measurement" else 0.0
            p = v["proportional_gain"]
            return LinuxCNCGains(p, v["integral_gain"], v["derivative_gain"], p * (v["reference_weight"] - 1.0), ff1), missing
        case "cascade":
            kv, k, w = v["position_gain"], v["velocity_gain"], v["velocity_feedforward"]
            rate = k / v["integral_time"]
            # The integral of the velocity error is Kv times that of the position error, plus the position error itself.
            return LinuxCNCGains(k * kv + rate, rate * kv, k, rate * (w - 1.0), k * (w - 1.0), v["acceleration_feedforward"]), []
        case "lead-lag":
            k, lead, ki = v["gain"], v["lead_time"] - v["lag_time"], v["integral_rate"]
            # K (a s + 1)/(b s + 1) (s + k_i)/s = K (k_i/s + 1 + k_i (a - b) + s (a - b)(1 - k_i b) + ...)
            slow = (finding("CL624", frequency=1.0 / v["lag_time"]),)
            return LinuxCNCGains(k * (1.0 + ki * lead), k * ki, k * lead * (1.0 - ki * v["lag_time"]), findings=slow), []
    return None
