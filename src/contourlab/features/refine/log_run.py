"""Simulate a machine and its controller along the reference of a log, tick by tick on its clock, to compare with the measurement."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags
from contourlab.errors import ResultError, refuse
from contourlab.features.measure.measured_path import moving
from contourlab.features.measure.study import Measured, measure
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.loop import Controller, Machine
from contourlab.loop.parameters import with_values
from contourlab.result import Result, Signal
from contourlab.study import Setting

LEAD = 50
"""Samples at rest that are simulated before the first move."""
SETTLING = 0.2
"""Time after the last move that still counts [s]."""
PERIODS_APART = 1e-6
"""Share by which the periods of a log and of a controller may differ."""


@dataclass(frozen=True)
class Agreement:
    """How well a simulated signal of one axis follows the measured one.

    Attributes
    ----------
    explained : float
        Explained share of the variance, 1 - var(measured - simulated)/var(measured); for a position, of the tracking error.
    fit : float [percent]
        100 (1 - |measured - simulated|/|measured - its mean|), for the same signals.
    rms : float [m or units of the command]
        Rms of measured minus simulated.
    """

    run: str
    axis: str
    signal: str
    explained: float
    fit: float
    rms: float

    @property
    def place(self) -> str:
        """Run, signal and axis."""
        return f"{self.run}, {self.signal} of {self.axis}"


@dataclass(frozen=True, eq=False)
class LogRun:
    """A log, and the machine and controller that should reproduce it.

    Attributes
    ----------
    reference : Reference
        From the log, from shortly before the first move.
    position : ndarray (n_sample, n_axis) [m]
        Measured, at the same samples.
    command : ndarray (n_sample, n_axis) or None
        Measured, if the log has it in the unit of the plants' commands.
    start : float [s]
        Time of the first sample on the log's clock.
    moves : (int, int)
        Samples [start, stop) over which the reference moves.
    steady : bool
        Whether the log begins in motion; then the axes start with the velocity of the reference.
    """

    label: str
    machine: Machine
    controller: Controller
    reference: Reference
    position: Array
    command: Array | None
    start: float
    moves: tuple[int, int]
    steady: bool
    findings: tuple[Finding, ...] = ()

    @property
    def signals(self) -> tuple[str, ...]:
        """Signals that are compared."""
        return ("position",) if self.command is None else ("position", "command")

    @cached_property
    def asked(self) -> Array:
        """Positions of the reference (n_sample, n_axis) [m]."""
        return self.reference.block(0, self.reference.n_sample).position

    @cached_property
    def measured(self) -> Array:
        """Measured signals side by side (n_sample, n_channel), in the order of `channels`; positions as tracking errors [m]."""
        late = self.asked - self.position
        return late if self.command is None else np.hstack([late, self.command])

    @property
    def channels(self) -> tuple[tuple[str, str], ...]:
        """Signal and axis of each column of `measured`."""
        return tuple((signal, axis) for signal in self.signals for axis in self.machine.axis_names)

    def placed(self, values: Mapping[str, float]) -> LogRun:
        """Return the run of a machine and controller with other values of parameters, by dotted name."""
        machine, controller = with_values(self.machine, self.controller, values)
        return replace(self, machine=machine, controller=controller)

    def times(self) -> Array:
        """Return the times of the samples (n_sample,) [s], on the log's clock."""
        return self.start + self.machine.servo_period * np.arange(self.reference.n_sample, dtype=np.float64)

    def simulated(self, variants: Mapping[str, ArrayLike], rows: slice | Flags = slice(None)) -> Array:
        """Return the simulated signals (n_row, n_channel, n_variant) as in `measured`; all nan for a variant that diverges.

        Parameters
        ----------
        variants : mapping of str to array_like (n_variant,)
            Parameter values by dotted name.
        rows : slice or ndarray of bool
            Samples to return.
        """
        setting = Setting(self.machine, self.controller, self.reference, moving=self.steady)
        batch = setting.batch(variants, keep=self.signals, judge=False)
        parts = [self.asked[rows][:, :, None] - batch.signals["position"][rows]]
        joined = np.concatenate(parts if self.command is None else [*parts, batch.signals["command"][rows]], axis=1)
        joined[:, :, (batch.failed_at >= 0) | ~np.isfinite(joined).all(axis=(0, 1))] = np.nan
        return joined

    def once(self) -> Array:
        """Return the simulated signals (n_sample, n_channel) of the machine and controller.

        Raises
        ------
        ResultError
            If the run diverges.
        """
        axis = self.machine.axes[0]
        slot, part = next((slot, part) for slot in ("plant", "drive") if (part := getattr(axis, slot)).numeric())
        parameter = part.numeric()[0]
        signals = self.simulated({f"axes.{axis.name}.{slot}.{parameter}": [part.values()[parameter]]})[:, :, 0]
        refuse(not np.isfinite(signals).all(), ResultError, f"{self.label}: the simulated run diverges along the log's reference")
        return signals

    def agreement(self, simulated: Array, rows: slice | Flags | None = None) -> tuple[Agreement, ...]:
        """Return how well simulated signals (n_sample, n_channel) follow the measured ones.

        Parameters
        ----------
        rows : slice or ndarray of bool, optional
            Samples that count; by default those at which the reference moves.
        """
        part = slice(*self.moves) if rows is None else rows
        agreements = []
        for (signal, axis), wanted, got in zip(self.channels, self.measured[part].T, simulated[part].T, strict=True):
            left, spread = wanted - got, wanted - wanted.mean()
            size = float(np.linalg.norm(spread)) or np.inf
            explained = 1.0 - float(np.var(left)) / (float(np.var(wanted)) or np.inf)
            fit = 100.0 * (1.0 - float(np.linalg.norm(left)) / size)
            agreements.append(Agreement(self.label, axis, signal, explained, fit, float(np.sqrt(np.mean(left**2)))))
        return tuple(agreements)

    def judged(self, simulated: Array | None = None) -> Measured:
        """Judge the contour of simulated signals (n_sample, n_channel), or of the measured signals, over the move."""
        signals = self.measured if simulated is None else simulated
        position = self.asked - signals[:, : len(self.machine.axes)]
        held = {name: Signal(data, ("sample", "axis"), "m") for name, data in (("reference", self.asked), ("position", position))}
        return measure(Result(self.label, self.machine.axis_names, self.machine.servo_period, held))

    def contour(self, simulated: Array | None = None, rows: slice | None = None) -> tuple[float, float]:
        """Return rms and largest contour error [m] of simulated signals (n_sample, n_channel), or of the measured signals.

        A machine with one axis has no contour: there it is the tracking error.

        Parameters
        ----------
        rows : slice, optional
            Samples that count; by default those at which the reference moves.
        """
        alone = len(self.machine.axes) == 1
        tracking = self.measured if simulated is None else simulated
        error = (tracking[:, 0] if alone else self.judged(simulated).result["contour_error"])[rows or slice(*self.moves)]
        return float(np.sqrt(np.mean(error**2))), float(np.abs(error).max())


def log_run(machine: Machine, controller: Controller, result: Result, label: str) -> LogRun:
    """Prepare the simulation along a log.

    Parameters
    ----------
    result : Result
        The log: ``reference`` and ``position`` of every axis, ``command`` if there is one.

    Raises
    ------
    ResultError
        If the log lacks an axis or a signal, is not finite, does not move, or has a different period from the machine.
    """
    period = machine.servo_period
    if abs(result.servo_period - period) > PERIODS_APART * period:
        raise ResultError(
            f"{label} has a sample every {result.servo_period * 1e3:.6g} ms, but {machine.name} has a servo period of "
            f"{period * 1e3:.6g} ms: record the log at the servo period"
        )
    missing = [axis for axis in machine.axis_names if axis not in result.axes]
    if missing:
        raise ResultError(f"no axis {missing[0]} in {label}, which has {', '.join(result.axes)}; {machine.name} has axis {missing[0]}")
    columns = [result.axes.index(axis) for axis in machine.axis_names]
    for name in ("reference", "position"):
        if name not in result:
            raise ResultError(f"no {name} in {label}: name its column, such as --column '{name}.{machine.axis_names[0]}=NAME [mm]'")
        refuse(not np.isfinite(result[name][:, columns]).all(), ResultError, f"{name} in {label} is not finite for every axis and sample")
    judged = measure(result, axes=machine.axis_names)
    wanted, along = result["reference"][:, columns], judged.result["arc_length"]
    first, last = moving(wanted)
    begin, end = max(first - LEAD, 0), min(last + round(SETTLING / period), len(wanted))
    part = slice(begin, end)
    reference = Reference.from_samples(wanted[part], period, judged.reference.path, arc_length=along[part])
    command, findings = _command(machine, result, columns, part, label)
    if first == 0:
        findings.append(finding("CL561", label))
    position = np.array(result["position"][part][:, columns])
    moves = first - begin, last - begin
    return LogRun(label, machine, controller, reference, position, command, float(result.time[begin]), moves, first == 0, tuple(findings))


def _command(machine: Machine, result: Result, columns: list[int], part: slice, label: str) -> tuple[Array | None, list[Finding]]:
    """Return the measured command, or None and a finding if it cannot be compared with the simulated one."""
    if "command" not in result:
        return None, []
    unit, wanted = result.signals["command"].unit, {axis.plant.command_unit for axis in machine.axes}
    if wanted != {unit}:
        return None, [finding("CL562", label, unit=unit or "1", model=tuple(sorted(wanted)))]
    values = np.array(result["command"][part][:, columns])
    return (values, []) if np.isfinite(values).all() else (None, [finding("CL563", label)])
