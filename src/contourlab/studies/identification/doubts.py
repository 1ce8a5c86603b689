"""Signals of an axis that no machine has, which ask whether units and scales are right."""

from __future__ import annotations

import numpy as np

from contourlab.studies.identification.signals import AxisRecord
from contourlab.units import show

__all__ = ["doubts"]

LARGEST = {"N": 1e5, "V": 1e3, "A": 1e3, "full_scale": 1.01}
"""Commands, by their unit, beyond which none of a feed drive goes."""
SHORT, SLOW = 1e-3, 1e-3
"""Way [m] and speed [m/s] of a whole run, both of which have to be passed for it to count as a run of a machine."""
PERIODS = (1e-7, 0.1)
"""Times between samples [s] that servo drives are logged at."""


def doubts(record: AxisRecord) -> list[str]:
    """Return what is doubtful about a record's signals, in words; nothing for a likely one.

    Parameters
    ----------
    record : AxisRecord
    """
    said = []
    if not PERIODS[0] <= record.period <= PERIODS[1]:
        said.append(f"{record.source} has a sample every {record.period:.4g} s: is the unit of the time right?")
    way = float(np.ptp(record.position))
    stride = max(1, round(0.002 / record.period))
    speed = np.abs(np.diff(record.position[::stride])) / (stride * record.period)
    fastest = float(speed.max()) if speed.size else 0.0
    if 0.0 < way < SHORT and fastest < SLOW:
        moved = f"{show(way, 'um', 3)} in all, at {show(fastest, 'mm/s', 3)} at most"
        said.append(f"{record.axis} moves by {moved} in {record.source}: is the unit of the position right?")
    if record.reference is not None and fastest and np.array_equal(record.position, record.reference):
        said.append(f"position and reference of {record.axis} in {record.source} are equal in all samples: are they the same column?")
    return said if record.command is None else [*said, *_on_command(record)]


def _on_command(record: AxisRecord) -> list[str]:
    largest, logged = record.largest(), record.largest() / abs(record.gain)
    named = f"the command of {record.axis} in {record.source} reaches"
    if record.unit == "full_scale" and largest > LARGEST["full_scale"]:
        return [f"{named} {largest:.4g} of its full scale: are its unit and --full-scale right?"]
    if record.unit == "N" and record.logged not in ("", "N") and logged > LARGEST.get(record.logged, np.inf):
        return [f"{named} {logged:.4g} {record.logged}: is its unit right?"]
    if largest > LARGEST.get(record.unit, np.inf):
        return [f"{named} {largest:.4g} {record.unit}: are its unit and --gain right?"]
    return []
