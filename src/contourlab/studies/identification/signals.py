"""One axis of a log: its signals, their units, and what an axis file says of every measured axis."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ResultError
from contourlab.logs import Log
from contourlab.result import Result
from contourlab.studies.identification.finding import Row, reached

__all__ = ["NO_PLANT", "AxisRecord", "axis_record", "chosen_axis", "fits_a_plant", "measured_tables"]

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
    """

    source: str
    axis: str
    period: float
    position: Array
    command: Array | None
    unit: str
    reference: Array | None
    estimate: Array | None

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
            raise ResultError(f"no force and no command of {self.axis} in {self.source}: say --column 'command.{self.axis}=NAME [V]'")
        return self.command

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


NO_PLANT = "friction in {unit} fits no plant of an axis file: give --gain, or --full-scale, the same for every log of the axis"
"""What is said where a friction is in the command's own unit."""


def fits_a_plant(unit: str) -> bool:
    """Tell whether forces in the unit of a command can stand in an axis file: newtons, or parts of full scale."""
    return unit in ("", "N", "full_scale")


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
        said = "which axis?" if axis is None else f"no axis {axis} in {result.scheme}:"
        raise ResultError(f"{said} There are {', '.join(result.axes)}: name one with --axis")
    return axis


def axis_record(log: Log, axis: str | None = None, gain: float | None = None, full_scale: float | None = None) -> AxisRecord:
    """Return the signals of an axis of a log.

    Parameters
    ----------
    log : Log
    axis : str, optional
        By default the only one that the log has.
    gain : float [N per unit of command], optional
    full_scale : float [unit of the command], optional
        What counts as full scale of the command, which is told in parts of it then.

    Raises
    ------
    ResultError
        If the log has several axes and none is named, or no position.
    """
    result = log.result
    axis = chosen_axis(result, axis)
    column = result.axes.index(axis)

    def of(name: str) -> Array | None:
        values = result[name][:, column] if name in result else None
        return None if values is None or not np.isfinite(values).any() else values

    position = next((values for name in POSITIONS if (values := of(name)) is not None), None)
    if position is None:
        raise ResultError(f"no position of {axis} in {result.scheme}: say --column 'position.{axis}=NAME [mm]'")
    command, unit = of("command"), _unit(result, "command")
    if gain is not None and command is not None:
        command, unit = gain * command, "N"
    elif full_scale is not None and command is not None:
        command, unit = command / full_scale, "full_scale"
    elif gain is None and of("force") is not None:
        command, unit = of("force"), "N"
    return AxisRecord(log.record.file.name, axis, result.servo_period, position, command, unit, of("reference"), of("disturbance_estimate"))


def _unit(result: Result, name: str) -> str:
    return result.signals[name].unit if name in result else ""


def measured_tables(record: AxisRecord) -> dict[str, dict[str, Row]]:
    """Return the tables of an axis file that any log tells: encoder and limits; these are what was reached, and are called so."""
    steps = np.abs(np.diff(record.position))
    stride = max(1, round(0.002 / record.period))
    speed = np.abs(np.diff(record.position[::stride])) / (stride * record.period)
    tables: dict[str, dict[str, Row]] = {
        "limits": {"velocity": (float(speed.max()) if speed.size else 0.0, "m/s", reached(record.source))},
    }
    if steps.any():
        tables["sensor"] = {
            "kind": ("encoder", "", None),
            "resolution": (float(steps[steps > 1e-12].min()), "m", reached(record.source, "the smallest step in the log")),
        }
    return tables
