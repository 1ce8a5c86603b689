"""Text files of angle and radius, as ball bars and their software write them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import LogError, ParameterError
from contourlab.features.circle.runs import CircleRun, runs_of_angles
from contourlab.logs.reading import name_and_unit
from contourlab.logs.record import Channel, Record
from contourlab.units import to_si

ANGLE, RADIUS, DEVIATION = "angle", "radius", "deviation"
_NAMES = {
    ANGLE: ("angle", "phi", "theta", "winkel"),
    RADIUS: ("radius", "r", "length"),
    DEVIATION: ("deviation", "dev", "radial deviation", "error", "dr"),
}
_EXAMPLE = "--column 'angle=NAME [deg]' --column 'deviation=NAME [um]'"


def own_columns(columns: Sequence[str]) -> tuple[dict[str, str], tuple[str, ...]]:
    """Split the columns of the command line into those of a ball bar, ``angle=NAME [deg]``, and those of a log."""
    mine, others = {}, []
    for text in columns:
        target, _, name = text.partition("=")
        if target.strip() in _NAMES and name.strip():
            mine[target.strip()] = name.strip()
        else:
            others.append(text)
    return mine, tuple(others)


def is_polar(record: Record, named: dict[str, str]) -> bool:
    """Tell whether a record holds angles and radii, or radial deviations."""
    present = {target for target in _NAMES if _channel(record, target, named) is not None}
    return ANGLE in present and bool(present & {RADIUS, DEVIATION})


def polar_runs(record: Record, named: dict[str, str], radius: float | None, feedrate: float) -> tuple[CircleRun, ...]:
    """Return the runs of a ball-bar file.

    Parameters
    ----------
    record : Record
    named : dict of str to str
        Columns as typed; angle, radius and deviation.
    radius : float [m] or None
        Nominal.
    feedrate : float [m/s]
        nan if unknown.

    Raises
    ------
    LogError
        If a length has no unit.
    ParameterError
        If a file of deviations has no nominal radius.
    """
    angle = _values(record, ANGLE, named, "rad")
    if _channel(record, DEVIATION, named) is not None:
        if radius is None:
            raise ParameterError("--radius", "None", 'the radius of the circle, such as "100 mm": the file holds deviations only')
        deviation = _values(record, DEVIATION, named, "m")
    else:
        lengths = _values(record, RADIUS, named, "m")
        radius = float(np.mean(lengths)) if radius is None else radius
        deviation = lengths - radius
    known = np.isfinite(angle) & np.isfinite(deviation)
    if float(np.abs(deviation[known]).max(initial=0.0)) > 0.2 * radius:
        raise LogError(f"deviations reach more than a fifth of the radius of {1e3 * radius:.6g} mm: check the units", file=record.file)
    return runs_of_angles(record.file.name, angle[known], deviation[known], radius, feedrate)


def _channel(record: Record, target: str, named: dict[str, str]) -> Channel | None:
    if target in named:
        return record.channel(name_and_unit(named[target])[0])
    names = _NAMES[target]
    return next((channel for channel in record.channels if channel.name.strip().casefold() in names), None)


def _values(record: Record, target: str, named: dict[str, str], si: str) -> Array:
    channel = _channel(record, target, named)
    if channel is None:
        raise LogError(f"has no column of the {target}: name it, as {_EXAMPLE}", file=record.file)
    if channel.fault is not None:
        raise channel.fault
    unit = (name_and_unit(named[target])[1] if target in named else "") or channel.unit or ("deg" if target == ANGLE else "")
    if not unit:
        raise LogError(f"column {channel.name!r} has no unit: write --column '{target}={channel.name} [um]'", file=record.file)
    scale = math.radians(1.0) if unit in ("deg", "°") else to_si(f"1 {unit}", si)
    return np.asarray(channel.values * scale)
