"""A calibrated controller in the terms of drives: Kv, bandwidth of the velocity loop, LinuxCNC's gains."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.delay_form import DelayForm
from contourlab.analysis.linear.sampled_loop import SampledLoop, sampled_loop
from contourlab.errors import ComponentError
from contourlab.features.tune.linuxcnc import LinuxCNCGains, linuxcnc_gains, linuxcnc_law
from contourlab.features.tune.placed import model_of
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.result import Result

Array = NDArray[np.float64]
GRID = 2000


@dataclass(frozen=True)
class DriveTerms:
    """One axis.

    Attributes
    ----------
    axis : str
    kv : float [1/s]
        Velocity per position error with the reference's velocity and the integral left out: what the axis would lag by at a steady speed
        is that speed over Kv. In a cascade it is the position gain; nan where it cannot be told.
    velocity_bandwidth : float [Hz]
        At which the velocity loop, the position loop open, gives 3 dB less than at standstill, sampled as it runs; nan where there is no
        velocity loop.
    command_unit : str
    linuxcnc : LinuxCNCGains or None
    difference, difference_rms : float
        Largest, and root mean square, difference of LinuxCNC's law from the law that was simulated, over a run, in parts of the largest
        command; nan where it is not compared. Where a planned acceleration steps, its difference comes a tick late.
    """

    axis: str
    kv: float
    velocity_bandwidth: float
    command_unit: str
    linuxcnc: LinuxCNCGains | None
    difference: float = math.nan
    difference_rms: float = math.nan


def drive_terms(machine: Machine, controller: Controller, run: Result | None = None) -> tuple[DriveTerms, ...]:
    """Return the terms of every axis.

    Parameters
    ----------
    machine, controller
    run : Result, optional
        A run of these, against which LinuxCNC's law is held.
    """
    found = []
    for i, axis in enumerate(machine.axes):
        mine = controller.axes[axis.name]
        gains = linuxcnc_gains(mine, controller)
        terms = DriveTerms(
            axis.name, _kv(machine, axis, mine, gains), _velocity_bandwidth(machine, axis, mine), axis.plant.command_unit, gains
        )
        if run is not None and gains is not None and run.status.ok and _comparable(axis, mine):
            largest, rms = law_difference(gains, mine, run, i)
            terms = replace(terms, difference=largest, difference_rms=rms)
        found.append(terms)
    return tuple(found)


def _comparable(axis: Axis, mine: AxisController) -> bool:
    """Tell whether a command is made of nothing but the law, the observer's estimate and what LinuxCNC feeds forward, too."""
    others = (mine.compensation, mine.gap_observer, mine.supervisor, mine.predictor)
    ahead = mine.feedforward is None or mine.feedforward.kind == "inverse-dynamics"
    return ahead and not axis.plant.two_sided and all(part is None for part in others)


def _kv(machine: Machine, axis: Axis, mine: AxisController, gains: LinuxCNCGains | None) -> float:
    values = mine.controller.values()
    if mine.controller.kind in ("cascade", "load-side-cascade"):
        return float(values["position_gain"])
    if gains is None:
        return math.nan
    gain, damping = model_of(machine, axis, mine)
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
"""What leaves of a controller its velocity loop, led by the reference's velocity."""


def _velocity_bandwidth(machine: Machine, axis: Axis, mine: AxisController) -> float:
    changes = VELOCITY_ONLY.get(mine.controller.kind)
    if changes is None:
        return math.nan
    bare = replace(mine, controller=mine.controller.replace(**changes), feedforward=None)
    try:
        loop = sampled_loop(axis, bare, machine.servo_period, machine.carried_mass(axis.name))
    except ComponentError:
        return math.nan
    return _bandwidth(loop)


def _bandwidth(loop: SampledLoop) -> float:
    """Return the frequency [Hz] at which velocity over the reference's velocity has fallen by 3 dB; nan where it never does."""
    w = np.geomspace(1e-5 * loop.nyquist, loop.nyquist, GRID)
    response = DelayForm(*loop.closed, loop.state[1:2])(np.exp(1j * w * loop.servo_period))[:, 0, 1]
    size = np.abs(response) / abs(response[0]) if response[0] else np.zeros(GRID)
    below = np.flatnonzero(size < math.sqrt(0.5))
    if not below.size or below[0] == 0:
        return math.nan
    k = int(below[0])
    part = (size[k - 1] - math.sqrt(0.5)) / (size[k - 1] - size[k])
    return float(w[k - 1] + part * (w[k] - w[k - 1])) / (2.0 * math.pi)


def law_difference(gains: LinuxCNCGains, mine: AxisController, run: Result, axis: int) -> tuple[float, float]:
    """Return how far LinuxCNC's law is from what a run was commanded, fed with what the controller saw: largest and root mean square.

    Both in parts of the largest command.

    The disturbance estimate, which has no counterpart, is added to what was commanded; the first half of the run is left out.
    """
    known = run.signals
    target = "modified_reference" if "modified_reference" in known else "reference"
    to, at = run[target][:, axis], run["position"][:, axis]
    told = run["command"][:, axis]
    if mine.observer is not None:
        if "disturbance_estimate" not in known:
            return math.nan, math.nan
        told = told + run["disturbance_estimate"][:, axis]
    if "coupling_command" in known:
        told = told - run["coupling_command"][:, axis]
    ports = {port.name for port in mine.controller.inputs}
    seen = run["velocity"][:, axis] if "velocity" in ports else None
    planned = "reference_velocity" in ports or mine.feedforward is not None
    law = linuxcnc_law(gains, to, at, run.servo_period, run["reference_velocity"][:, axis] if planned else None, seen)
    # A constant is what the integral was before, at the start or at a limit of the drive; it is none of the gains.
    off = (law - told)[len(told) // 2 :]
    off, scale = off - np.median(off), float(np.abs(told).max())
    if not scale:
        return math.nan, math.nan  # an axis that stands still
    return float(np.abs(off).max()) / scale, float(np.sqrt(np.mean(off**2))) / scale
