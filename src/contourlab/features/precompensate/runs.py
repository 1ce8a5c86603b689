"""Runs of a pass: from a log, or simulated."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.app.shared_options import LogAxes
from contourlab.arrays import Array
from contourlab.errors import LogError, ResultError
from contourlab.features.measure.log_choice import open_log
from contourlab.features.measure.measured_path import moving, progress_along
from contourlab.features.measure.plausibility import known_signal
from contourlab.features.precompensate.law import Run
from contourlab.features.precompensate.reading import Contour
from contourlab.features.precompensate.writing import Written
from contourlab.feed import AxisLimits, Route, blended, plan
from contourlab.logs import Column, Log, Record
from contourlab.logs.load import LONG_GAP, about
from contourlab.loop import Controller, Machine, simulate
from contourlab.program import Program
from contourlab.scenario.values import program_motion

AFTER = 0.3
"""Time after the last motion of the command that is looked at [s]."""
WINDOW = 1e-3
"""Distance along the path around a command's progress in which its place is searched [m]."""
ALIKE = 1e-6
"""Distance, rms, of a command from the path it was meant to follow, up to which it did [m]."""
FOLLOWED = 1.25
"""Largest movement of an axis over that of its command, and the inverse of the least."""
ROUNDING = 1e-8
"""Distance by which a command may pass its end in a log [m]."""
AT_END = 1e-9
"""Distance of a foot point from the end of a corrected part at which it is that end [m]."""


@dataclass(frozen=True, eq=False)
class Measured:
    """The signals of a run.

    Attributes
    ----------
    period : float [s]
    command, motor, load : ndarray (n, n_axis) [m]
        Load: the position that counts.
    source : str
        ``"load"``, ``"motor and model"``, ``"motor"`` or ``"model"``: where `load` is from.
    """

    period: float
    command: Array
    motor: Array
    load: Array
    source: str


def open_run(file: Path, options: LogAxes, machine: Machine | None = None) -> tuple[Measured, tuple[str, ...], Log]:
    """Read a log with commanded and measured positions.

    Parameters
    ----------
    file : Path
    options : LogAxes
        How to read it.
    machine : Machine, optional
        Its play applies where the log has the position of the motor only.

    Returns
    -------
    Measured
    axes : tuple of str
    Log

    Raises
    ------
    LogError
        If it cannot be read, has a long gap, or an axis has no commanded or measured position.
    """
    with about(file):
        log = open_log(file, options, guess=_of_hal)
    result = log.result

    def of(axes: Sequence[str], *signals: str) -> Array | None:
        known = known_signal(result, axes, signals)
        return None if known is None else known[1]

    axes = options.axes or tuple(axis for axis in result.axes if axis in "xyz" and of([axis], "reference") is not None)
    command, motor = of(axes, "reference"), of(axes, "motor_position", "position")
    load = of(axes, "tool_position", "axis_position") if motor is not None else of(axes, "tool_position", "axis_position", "position")
    if not axes or command is None or (motor is None and load is None):
        missing = "commanded" if not axes or command is None else "measured"
        cure = "name it, as --column 'reference.x=NAME [mm]' or 'position.x=NAME [mm]'"
        raise LogError(f"has no {missing} position: {cure}", file=file)
    if any(len(log.stretches(axis)) > 1 for axis in axes):
        raise LogError(f"has a gap of more than {LONG_GAP} samples: record the run again", file=file)
    if len(axes) < 2:
        raise LogError(f"has axis {axes[0]} only: a contour error needs two axes or more", file=file)
    for position in (motor, load):
        if position is not None:
            _check_followed(axes, command, position, file)
    if load is not None:
        return Measured(result.servo_period, command, load if motor is None else motor, load, "load"), axes, log
    assert motor is not None
    gaps = [0.0 if machine is None or axis not in machine.axis_names else _gap(machine.axis(axis).plant) for axis in axes]
    load = np.column_stack([behind_play(column, gap) for column, gap in zip(motor.T, gaps, strict=True)])
    return Measured(result.servo_period, command, motor, load, "motor and model" if any(gaps) else "motor"), axes, log


def _of_hal(record: Record) -> Iterator[Column]:
    """Yield the columns of a log of HAL whose names mean something else in other logs."""
    signals = {"load": "axis_position", "command": "reference"}
    names = ((channel.name, re.fullmatch("([xyz])[-_](load|command)", channel.name.lower())) for channel in record.channels)
    yield from (Column(signals[own[2]], own[1], name) for name, own in names if own)


def _check_followed(axes: Sequence[str], command: Array, position: Array, file: str | Path) -> None:
    """Refuse positions (n, n_axis) [m] that do not follow their commands at all."""
    for axis, wanted, measured in zip(axes, command.T, position.T, strict=True):
        moved = wanted - wanted.mean()
        square = float(moved @ moved)
        share = float(moved @ measured) / square if square else 1.0
        if not 1.0 / FOLLOWED < share < FOLLOWED:
            cure = "is a column reversed, exchanged, or in another unit?"
            raise LogError(f"axis {axis} moves {share:.3g} times as far as its command: {cure}", file=file)


def _gap(plant: Any) -> float:
    """Return the play of a plant [m]."""
    turn = 2.0 * math.pi / plant.lead if getattr(plant, "lead", 0.0) else math.inf
    return float(getattr(plant, "backlash_gap", 0.0) + getattr(plant, "backlash_angle", 0.0) / turn)


def behind_play(motor: Array, gap: float) -> Array:
    """Return the load's position (n,) [m] behind a play [m], from the middle of the gap.

    >>> behind_play(np.array([0.0, 3.0, 2.0, 0.0]), 2.0)
    array([0., 2., 2., 1.])
    """
    if not gap:
        return motor.copy()
    half = gap / 2.0
    return np.array(list(accumulate(motor.tolist(), lambda at, position: min(max(at, position - half), position + half))))


def run_of(contour: Contour, measured: Measured, driven: Contour | None = None, written: Written | None = None) -> Run:
    """Return what a run shows.

    Parameters
    ----------
    contour : Contour
        As programmed.
    measured : Measured
    driven, written : Contour and Written, optional
        The corrected program that was run; by default the program itself.

    Raises
    ------
    ResultError
        If the command does not follow the path.
    """
    period = measured.period
    first, last = moving(measured.command)
    stop = min(last + round(AFTER / period), len(measured.command))
    command, load = measured.command[first : last + 1], measured.load[first:stop]
    path = contour.path if driven is None else driven.path
    progress, _ = progress_along(path, command)
    at = path.foot_point(command, progress, WINDOW)
    place = np.maximum.accumulate(np.asarray(at.arc_length))
    if written is not None:
        place = np.interp(place, written.corrected_arc, written.programmed_arc)
        away = float(np.sqrt(((at.position - command) ** 2).sum(axis=1).mean()))
        from_first = contour.path.foot_point(command, place, WINDOW).position - command
        if away > ALIKE and float(np.sqrt((from_first**2).sum(axis=1).mean())) < 0.5 * away:
            raise ResultError("the log is of the program before any correction.")
    after = stop - first - len(place)
    place, rounded = np.append(place, np.full(after, place[-1])), np.pad(at.position - command, ((0, after), (0, 0)))
    farthest = float(np.linalg.norm(measured.command[first:stop] - load, axis=1).max())
    foot = contour.path.foot_point(load, place, min(4.0 * farthest + 1e-4, 0.25 * contour.path.length))
    off = foot.position - load
    ends = contour.path.breaks[sorted({end for part in contour.chunks for end in part})]
    nearest = ends[np.clip(np.searchsorted(0.5 * (ends[1:] + ends[:-1]), foot.arc_length), 0, len(ends) - 1)]
    at_end = np.abs(np.asarray(foot.arc_length) - nearest) < AT_END
    tangent = np.asarray(contour.path.tangent(foot.arc_length))
    # Before its start and beyond its end, what a part lacks along its own direction is a matter of time, not of the path.
    off -= np.where(at_end, (off * tangent).sum(axis=1), 0.0)[:, None] * tangent
    on = contour.is_corrected(place) & contour.is_corrected(np.asarray(foot.arc_length))
    # A step belongs to the curve at its middle: the last one of a rapid ends where the cut begins, up to rounding.
    on_step = contour.is_corrected(np.maximum(0.5 * (place + np.append(place[:1], place[:-1])) - ROUNDING, 0.0))
    steps = np.diff(measured.command[first : stop + 1], axis=0, prepend=command[:1])[: stop - first]
    return Run(
        period=period,
        place=place,
        error=np.where(on[:, None], off, 0.0),
        moves=on & on_step & (steps != 0.0).any(axis=1),
        speed=np.linalg.norm(steps, axis=1) / period,
        duration=(last - first) * period,
        velocity=np.abs(steps).max(axis=0) / period,
        acceleration=np.abs(np.diff(steps, axis=0)).max(axis=0) / period**2,
        rounded=np.where(on[:, None], rounded, 0.0),
    )


def simulated(program: Program, machine: Machine, controller: Controller, seed: int, trial: int) -> Measured:
    """Simulate a run of a program.

    Raises
    ------
    ProgramError, FeedError
        If it cannot be planned.
    """
    reference = program_motion(program, machine.axis_names, machine.planner_limits(), machine.servo_period)
    result = simulate(machine, controller, reference, seed=seed, trial=trial)
    columns = [k for k, axis in enumerate(machine.axis_names) if axis in "xyz"]
    command, motor, load = (np.asarray(result[name][:, columns]) for name in ("reference", "position", "tool_position"))
    return Measured(machine.servo_period, command, motor, load, "model")


def cycle_time(route: Route, velocity: Sequence[float], acceleration: Sequence[float], period: float) -> float:
    """Return the time [s] of a route, planned with the largest speeds [m/s] and accelerations [m/s^2] that a control used."""
    limits = AxisLimits(np.maximum(velocity, 1e-3), np.maximum(acceleration, 1e-2))
    return plan(blended(route, limits), limits, period).duration
