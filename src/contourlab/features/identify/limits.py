"""Limits of an axis file out of the motion in its logs: as fast as the logs and a fifth more, as far as the drive's limit goes with it.

A plan may ask for the largest velocity and the largest acceleration at once. What mass, damping, friction and constant force then take has
to be less than the drive's limit, with something left to the controller, or the axis of the file cannot follow its own plans.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.components.origin import Origin
from contourlab.features.identify.finding import ROOM, Row, assumed
from contourlab.features.identify.plant_tables import Forces
from contourlab.features.identify.signals import AxisRecord, source_of
from contourlab.features.measure.likely import fastest

Array = NDArray[np.float64]
SPARE = 0.1
"""Share of the drive's limit that plans leave to the controller."""
MOST = 0.5
"""Share by which a drive's limit is assumed above the largest command in the logs at most, where limits of the motion ask for it."""
PLANNED, REACTED = 0.005, 0.05
"""Times [s] over which accelerations are told: of a reference, and of a position alone, where what is shorter is the controller's doing."""


@dataclass(frozen=True)
class Effort:
    """What the motion of an axis takes of its command.

    Attributes
    ----------
    forces : Forces
    a : float [m/s^2 per command], > 0
    b : float [1/s]
    held : float [command]
        Against friction and a constant force, whatever the motion.
    """

    forces: Forces
    a: float
    b: float
    held: float = 0.0

    def drive(self, velocity: float, acceleration: float) -> float:
        """Return the limit of the drive [command]: what both at once take, within what may be assumed of it; or full scale."""
        if self.forces.unit != "N":
            return self.forces.one
        taken = (self.held + (acceleration + self.b * velocity) / self.a) / (1.0 - SPARE)
        return min(max(taken, (1.0 + ROOM) * self.forces.largest), (1.0 + MOST) * self.forces.largest)

    def share(self, velocity: float, acceleration: float) -> float:
        """Return what share of both that drive gives at once, 1 at most."""
        limit = self.drive(velocity, acceleration)
        left = max((1.0 - SPARE) * limit - self.held, SPARE * limit)
        taken = (acceleration + self.b * velocity) / self.a
        return min(1.0, left / taken) if taken > 0.0 else 1.0


@dataclass(frozen=True)
class Peak:
    """The largest acceleration in logs [m/s^2], and of what it is, in words."""

    value: float
    words: str = ""


@dataclass(frozen=True)
class MotionLimits:
    """Limits of an axis file.

    Attributes
    ----------
    table : dict of str to Row
        Of velocity, acceleration and jerk.
    command : float [command]
        Of the drive.
    origin : Origin
        Where that is from.
    """

    table: dict[str, Row]
    command: float
    origin: Origin


def largest_acceleration(record: AxisRecord) -> Peak:
    """Return the largest acceleration of the motion that was asked for in a log: of its reference, or else of its position.

    A controller's reaction to friction and to corners of its reference is no motion that was asked for, and a corner of the reference
    none that was gone: of the two the smaller counts.
    """
    if record.reference is None or not np.ptp(record.reference) > 0.0:
        return Peak(_acceleration(record.position, record.period, REACTED), f" over {1e3 * REACTED:.0f} ms")
    asked, gone = (_acceleration(values, record.period, PLANNED) for values in (record.reference, record.position))
    return Peak(asked, " of the reference") if asked <= gone else Peak(gone)


def _acceleration(position: Array, period: float, over: float) -> float:
    """Return the largest second difference over a time [m/s^2]."""
    n = max(1, min(round(over / period), (position.size - 1) // 2))
    return float(np.abs(position[2 * n :] - 2.0 * position[n:-n] + position[: -2 * n]).max(initial=0.0)) / (n * period) ** 2


def motion_limits(records: Sequence[AxisRecord], effort: Effort, acceleration: Peak | None = None) -> MotionLimits:
    """Return the limits of an axis file.

    Parameters
    ----------
    records : sequence of AxisRecord
        Of one axis.
    effort : Effort
        What its motion takes.
    acceleration : Peak, optional
        The largest in them; by default as of `largest_acceleration`.

    Notes
    -----
    Velocity, acceleration and command are 20 % above the largest in the logs. Where velocity and acceleration at once take more of the
    command than that less a tenth for the controller, the drive's limit is that much higher, up to half above the largest in the logs;
    full scale is full scale. Where it is not enough, each of the two is first no more than the drive gives alone, then both are lowered
    by the same share.
    """
    source = source_of(records)
    peak = acceleration or max((largest_acceleration(record) for record in records), key=lambda one: one.value)
    top = max(fastest(record.position[:, None], record.period) for record in records)
    velocity, gain = (1.0 + ROOM) * top, (1.0 + ROOM) * peak.value
    velocity, gain = velocity * effort.share(velocity, 0.0), gain * effort.share(0.0, gain)
    share, command = effort.share(velocity, gain), effort.drive(velocity, gain)

    def origin(value: float, largest: float, words: str, why: str) -> Origin:
        return Origin("assumed", reference=source, note=_note(value, largest, words, why))

    less = "the drive's limit gives no more of velocity and acceleration at once"
    rows = (("velocity", share * velocity, top, "m/s", ""), ("acceleration", share * gain, peak.value, "m/s^2", peak.words))
    table: dict[str, Row] = {name: (value, unit, origin(value, largest, words, less)) for name, value, largest, unit, words in rows}
    table["jerk"] = (100.0 * share * gain, "m/s^3", assumed("the acceleration in 10 ms"))
    more = "velocity and acceleration take it at their limits"
    told = origin(command, effort.forces.largest, "", more) if effort.forces.unit == "N" else assumed("full scale")
    return MotionLimits(table, command, told)


def _note(value: float, largest: float, words: str, why: str) -> str:
    """Return how a limit lies to the largest in the log, and where it is not as usual why."""
    above = value / largest - 1.0 if largest else ROOM
    apart = f"{100.0 * abs(above):.0f} % {'above' if above >= 0.0 else 'below'} the largest{words} in the log"
    return f"{apart}{'' if math.isclose(above, ROOM) else f', as {why}'}: give the axis' own"
