"""One axis of a log: its signals, their units, and what an axis file says of every measured axis."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ResultError
from contourlab.features.identify.finding import Row, reached
from contourlab.logs import Log
from contourlab.result import Result

Array = NDArray[np.float64]
POSITIONS = ("position", "motor_position", "axis_position")


@dataclass(frozen=True, eq=False)
class AxisRecord:
    """The signals of one axis of a log.

    Attributes
    ----------
    source, axis : str
    period : float [s]
    position : ndarray (n,) [m]
    command : ndarray (n,)
        Force [N] where the log has it or a gain was given; else the command in its own unit, or None without one.
    unit : str
        Of the command.
    reference : ndarray (n,) or None [m]
    estimate : ndarray (n,) or None
        Disturbance that an observer took off the command.
    gain : float [N per unit of the log's command]
        That was given, or that a lead makes of a torque; 1 without one.
    logged : str
        Unit of the command in the log; ``"N*m"`` where its torque stands for it.
    start : float [s]
        Time of the first sample behind that of the log.
    notes : tuple of str
        What there is to know of the record.
    """

    source: str
    axis: str
    period: float
    position: Array
    command: Array | None
    unit: str
    reference: Array | None
    estimate: Array | None
    gain: float = 1.0
    logged: str = ""
    start: float = 0.0
    notes: tuple[str, ...] = ()

    @property
    def time(self) -> Array:
        """Times of the samples [s], from 0."""
        return np.asarray(self.period * np.arange(self.position.size))

    def driven(self) -> Array:
        """Return the command.

        Raises
        ------
        ResultError
            If the log has none.
        """
        if self.command is None:
            wanted = f"say --column 'command.{self.axis}=NAME [V]', or with force or torque for command, in N or N*m"
            raise ResultError(f"no force, torque or command of {self.axis} in {self.source}: {wanted}")
        return self.command

    def largest(self) -> float:
        """Return the largest command, or force, either way; as `driven`."""
        return float(np.abs(self.driven()).max())

    def asked(self) -> Array:
        """Return the reference.

        Raises
        ------
        ResultError
            If the log has none.
        """
        if self.reference is None:
            raise ResultError(f"no reference of {self.axis} in {self.source}: say --column 'reference.{self.axis}=NAME [mm]'")
        return self.reference

    def part(self, start: int, stop: int) -> AxisRecord:
        """Return the record of the samples [start, stop) alone."""

        def of(values: Array | None) -> Array | None:
            return None if values is None else values[start:stop]

        signals: dict[str, Any] = {name: of(getattr(self, name)) for name in ("command", "reference", "estimate")}
        return replace(self, position=self.position[start:stop], start=self.start + start * self.period, **signals)


TRAVEL = '--lead, the travel per turn, as "10 mm"'
"""The option that two inertias take, and that makes newtons of torques."""


def in_newtons(unit: str) -> str:
    """Return the option, with an example, that makes newtons of commands in a unit.

    >>> in_newtons("V")
    '--gain, as "35.15 N/V"'
    """
    return TRAVEL if unit == "N*m" else f'--gain, as "35.15 {newtons_per(unit)}"'


def newtons_per(unit: str) -> str:
    """Return the unit of a gain that makes newtons of commands in a unit.

    >>> newtons_per("V"), newtons_per("N*m"), newtons_per("")
    ('N/V', 'N/(N*m)', 'N')
    """
    return f"N/({unit})" if "*" in unit else f"N/{unit}".removesuffix("/")


def no_plant(unit: str) -> str:
    """Return what is said where a friction is in the command's own unit."""
    return f"friction in {unit} fits no plant of an axis file: give {in_newtons(unit)}, or --full-scale, the same for every log of the axis"


def fits_a_plant(unit: str) -> bool:
    """Tell whether forces in the unit of a command can stand in an axis file: newtons, or parts of full scale."""
    return unit in ("", "N", "full_scale")


def one_unit(records: Sequence[AxisRecord], what: str) -> str:
    """Return the unit that the commands of all records have.

    Parameters
    ----------
    records : sequence of AxisRecord
    what : str
        That the logs are of, for the message.

    Raises
    ------
    ResultError
        If they have several.
    """
    units = sorted({record.unit for record in records})
    if len(units) > 1:
        raise ResultError(f"commands in {' and '.join(units)}: logs of {what} have one unit")
    return units[0]


def sources_of(records: Sequence[AxisRecord]) -> tuple[str, ...]:
    """Return the names of the logs that records are of, each once."""
    return tuple(dict.fromkeys(record.source for record in records))


def chosen_axis(result: Result, axis: str | None) -> str:
    """Return the axis that is meant: the one that is named, or the only one.

    Raises
    ------
    ResultError
        If there are several and none is named, or there is none of that name.
    """
    if axis is None and len(result.axes) == 1:
        return result.axes[0]
    if axis not in result.axes:
        said = "which axis?" if axis is None else f"no axis {axis} in {result.source}:"
        raise ResultError(f"{said} There are {', '.join(result.axes)}: name one with --axis")
    return axis


def axis_pieces(
    log: Log,
    axis: str | None = None,
    gain: float | None = None,
    full_scale: float | None = None,
    source: str | None = None,
    lead: float | None = None,
) -> tuple[AxisRecord, ...]:
    """Return the signals of an axis of a log, one record for each stretch without a long gap.

    Parameters
    ----------
    log : Log
    axis : str, optional
        By default the only one that the log has.
    gain : float [N per unit of command], optional
    full_scale : float [unit of the command], optional
        What counts as full scale of the command, which is told in parts of it then.
    source : str, optional
        What the log is called; by default by the name of its file.
    lead : float [m], optional
        Travel per turn, which makes a force of a command in newton metres.

    Raises
    ------
    ResultError
        If the log has several axes and none is named, or no position; or a gain is given for a log of forces alone,
        or beside the lead for one of torques.
    """
    name = chosen_axis(log.result, axis)
    whole = _whole(log, name, gain, full_scale, source or log.record.file.name, lead)
    spans = log.stretches(name)
    if spans == [(0, whole.position.size)]:
        return (whole,)
    if not spans:
        raise ResultError(f"{whole.source} has no stretch without a long gap in it")
    return tuple(whole.part(*span) for span in spans)


def longest_piece(log: Log, pieces: Sequence[AxisRecord]) -> AxisRecord:
    """Return the longest of the stretches of a log, as of `axis_pieces`; it says so where it is not all of the log."""
    longest = max(pieces, key=lambda piece: piece.position.size)
    if len(pieces) == 1 and longest.position.size == log.result.n_sample:
        return longest
    end = longest.start + longest.position.size * longest.period
    words = f"{longest.source}: only {longest.start:.4g} s to {end:.4g} s is fitted, the longest stretch without a long gap"
    return replace(longest, notes=(words,))


def _whole(log: Log, axis: str, gain: float | None, full_scale: float | None, source: str, lead: float | None) -> AxisRecord:
    """Return the signals of an axis, gaps and all."""
    result = log.result
    column = result.axes.index(axis)

    def of(name: str) -> Array | None:
        values = result[name][:, column] if name in result else None
        return None if values is None or not np.isfinite(values).any() else values

    position = next((values for name in POSITIONS if (values := of(name)) is not None), None)
    if position is None:
        said = f"no position of {axis} in {result.source}: say --column 'position.{axis}=NAME [mm]'"
        raise ResultError("; ".join([said, *log.doubtful]))
    command, force = of("command"), of("force")
    logged = result.signals["command"].unit if command is not None else ""
    if command is None and force is None and (command := of("torque")) is not None:
        logged = "N*m"
    if command is None and gain is not None and force is not None:
        raise ResultError(f"{source} has the force of {axis} and no command: leave --gain out")
    if lead is not None and logged == "N*m" and full_scale is None:
        if gain is not None:
            raise ResultError(f"{source} has the torque of {axis}, of which --lead makes a force: leave --gain out")
        gain = 2.0 * np.pi / lead
    unit = logged
    if gain is not None and command is not None:
        command, unit = gain * command, "N"
    elif full_scale is not None and command is not None:
        command, unit = command / full_scale, "full_scale"
    elif gain is None and force is not None:
        command, unit = force, "N"
    signals = position, command, unit, of("reference"), of("disturbance_estimate")
    return AxisRecord(source, axis, result.servo_period, *signals, gain=1.0 if gain is None else gain, logged=logged)


def samples_digest(pieces: Sequence[AxisRecord]) -> str:
    """Return a digest of the samples of position and command of a log, piece by piece: logs of one digest are the same record."""
    digest = sha256()
    for piece in pieces:
        command = np.zeros(0) if piece.command is None else piece.command
        digest.update(np.array([piece.position.size, command.size]).tobytes())
        digest.update(piece.position.tobytes() + command.tobytes())
    return digest.hexdigest()


def source_of(records: Sequence[AxisRecord]) -> str:
    """Return what an axis file says a number is from that several logs tell: the first, and how many more there are."""
    named = sources_of(records)
    return named[0] if len(named) == 1 else f"{named[0]} and {len(named) - 1} more"


def sensor_table(records: Sequence[AxisRecord]) -> dict[str, dict[str, Row]]:
    """Return the encoder of an axis file, as far as the records of one axis tell its steps."""
    steps = np.concatenate([np.abs(np.diff(record.position)) for record in records])
    seen = steps[steps > 1e-12]
    if not seen.size:
        return {}
    told = reached(source_of(records), "the smallest step in the log")
    return {"sensor": {"kind": ("encoder", "", None), "resolution": (float(seen.min()), "m", told)}}
