"""A machine and its controller driven along a log's own reference, tick by tick on its clock, to be held against what was measured."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import ResultError
from contourlab.features.measure.sample_path import moving
from contourlab.features.measure.study import Measured, measure
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine, simulate_batch
from contourlab.result import Result, Signal

Array = NDArray[np.float64]

LEAD = 50
"""Samples at rest that are simulated ahead of the first move."""
PERIODS_APART = 1e-6
"""Share by which the clocks of a log and of a controller may differ."""


@dataclass(frozen=True)
class Agreement:
    """How well a simulated signal of one axis follows the measured one.

    Attributes
    ----------
    run, axis, signal : str
    explained : float
        Share of the variance that is explained, 1 - var(measured - simulated)/var(measured); of a position, of its tracking error.
    fit : float [percent]
        100 (1 - |measured - simulated|/|measured - its mean|), the same signals.
    rms : float [m or units of the command]
        Of measured less simulated.
    """

    run: str
    axis: str
    signal: str
    explained: float
    fit: float
    rms: float


@dataclass(frozen=True, eq=False)
class LogRun:
    """A log, and the machine and controller that are to follow it.

    Attributes
    ----------
    label : str
        What the run is called.
    machine : Machine
    controller : Controller
    reference : Reference
        The log's, from shortly before the first move on.
    position : ndarray (n_sample, n_axis) [m]
        Measured, at the same samples.
    command : ndarray (n_sample, n_axis) or None
        Measured too, where the log has it in the unit of the plants' commands.
    start : float [s]
        Time of the first sample on the log's clock.
    moves : (int, int)
        Samples [start, stop) over which something is asked to move.
    steady : bool
        Whether the axes move at the first sample already: then they start with the reference's velocity.
    notes : tuple of str
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
    notes: tuple[str, ...] = ()

    @property
    def signals(self) -> tuple[str, ...]:
        """What is compared."""
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

    def times(self) -> Array:
        """Return the times of the samples (n_sample,) [s], on the log's clock."""
        return self.start + self.machine.servo_period * np.arange(self.reference.n_sample, dtype=np.float64)

    def simulated(self, variants: Mapping[str, ArrayLike], rows: slice | NDArray[np.bool_] = slice(None)) -> Array:
        """Return the simulated signals (n_row, n_channel, n_variant), as `measured` has them; NaN throughout where a variant diverges.

        Parameters
        ----------
        variants : mapping of str to array_like (n_variant,)
            Parameters that differ, by their dotted names.
        rows : slice or ndarray of bool
            Samples that are wanted.
        """
        found = simulate_batch(self.machine, self.controller, self.reference, variants, keep=self.signals, judge=False, moving=self.steady)
        parts = [self.asked[rows][:, :, None] - found.signals["position"][rows]]
        joined = np.concatenate(parts if self.command is None else [*parts, found.signals["command"][rows]], axis=1)
        joined[:, :, (found.failed_at >= 0) | ~np.isfinite(joined).all(axis=(0, 1))] = np.nan
        return joined

    def once(self) -> Array:
        """Return the simulated signals (n_sample, n_channel) of machine and controller as they stand.

        Raises
        ------
        ResultError
            If the run diverges.
        """
        name = self.machine.axis_names[0]
        plant = self.machine.axis(name).plant
        parameter = plant.numeric()[0]
        found = self.simulated({f"axes.{name}.plant.{parameter}": [plant.values()[parameter]]})[:, :, 0]
        if not np.isfinite(found).all():
            raise ResultError(f"{self.label}: the simulated run diverges along the log's reference")
        return found

    def agreement(self, simulated: Array, rows: slice | NDArray[np.bool_] | None = None) -> tuple[Agreement, ...]:
        """Return how well simulated signals (n_sample, n_channel) follow the measured ones.

        Parameters
        ----------
        simulated : ndarray
        rows : slice or ndarray of bool, optional
            Samples that count; by default those at which something is asked to move.
        """
        part = slice(*self.moves) if rows is None else rows
        seen, here = self.measured[part], simulated[part]
        found = []
        for (signal, axis), one, other in zip(self.channels, seen.T, here.T, strict=True):
            left, spread = one - other, one - one.mean()
            size = float(np.linalg.norm(spread)) or np.inf
            explained = 1.0 - float(np.var(left)) / (float(np.var(one)) or np.inf)
            fit = 100.0 * (1.0 - float(np.linalg.norm(left)) / size)
            found.append(Agreement(self.label, axis, signal, explained, fit, float(np.sqrt(np.mean(left**2)))))
        return tuple(found)

    def judged(self, simulated: Array | None = None) -> Measured:
        """Return the contour figures of simulated signals (n_sample, n_channel), or of the measured ones, over the move."""
        signals = self.measured if simulated is None else simulated
        position = self.asked - signals[:, : len(self.machine.axes)]
        held = {name: Signal(data, ("sample", "axis"), "m") for name, data in (("reference", self.asked), ("position", position))}
        return measure(Result(self.label, self.machine.axis_names, self.machine.servo_period, held))


def log_run(machine: Machine, controller: Controller, result: Result, label: str, *, settling: float = 0.2, lead: int = LEAD) -> LogRun:
    """Make ready what is simulated along a log.

    Parameters
    ----------
    machine : Machine
    controller : Controller
    result : Result
        Of the log: ``reference`` and ``position`` of every axis, ``command`` where there is one.
    label : str
    settling : float [s], >= 0
        How long behind the last move still counts, as far as the log has it.
    lead : int
        Samples ahead of the first move.

    Raises
    ------
    ResultError
        If the log lacks an axis or a signal, is not finite, asks for no move, or has another clock than the machine.
    """
    period = machine.servo_period
    if abs(result.servo_period - period) > PERIODS_APART * period:
        raise ResultError(
            f"{label} has a sample every {result.servo_period * 1e3:.6g} ms, {machine.name} a servo period of {period * 1e3:.6g} ms: a "
            "sampled controller is another one on another clock; record at the servo period"
        )
    lacking = [axis for axis in machine.axis_names if axis not in result.axes]
    if lacking:
        raise ResultError(f"no axis {lacking[0]} in {label}, which has {', '.join(result.axes)}; {machine.name} has it")
    columns = [result.axes.index(axis) for axis in machine.axis_names]
    for name in ("reference", "position"):
        if name not in result:
            raise ResultError(f"no {name} in {label}: say which column it is, such as --column '{name}.{machine.axis_names[0]}=NAME [mm]'")
        if not np.isfinite(result[name][:, columns]).all():
            raise ResultError(f"{name} in {label} is not finite for every axis and sample")
    judged = measure(result, axes=machine.axis_names)
    wanted, along = result["reference"][:, columns], judged.result["arc_length"]
    first, last = moving(wanted)
    begin, end = max(first - lead, 0), min(last + round(settling / period), len(wanted))
    part = slice(begin, end)
    reference = Reference.from_samples(wanted[part], period, judged.reference.path, arc_length=along[part])
    command, notes = _command(machine, result, columns, part)
    moves = first - begin, last - begin
    steady = first == 0
    if steady:
        notes += (f"{label} begins in motion: the axes start with the velocity of the reference, and what came before is not known",)
    position = np.array(result["position"][part][:, columns])
    start = float(result.time[begin])
    return LogRun(label, machine, controller, reference, position, command, start, moves, steady, notes)


def _command(machine: Machine, result: Result, columns: list[int], part: slice) -> tuple[Array | None, tuple[str, ...]]:
    """Return the measured command where it can be compared with the simulated one, and what is to be said of it."""
    if "command" not in result:
        return None, ()
    unit, wanted = result.signals["command"].unit, {axis.plant.command_unit for axis in machine.axes}
    if wanted != {unit}:
        said = (
            f"the command in {result.scheme} is in {unit or 'no unit'} and the model's in {', '.join(sorted(wanted))}: it is not compared"
        )
        return None, (said,)
    values = result["command"][part][:, columns]
    return (np.array(values), ()) if np.isfinite(values).all() else (None, (f"the command in {result.scheme} is not finite: not compared",))
