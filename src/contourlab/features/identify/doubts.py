"""Signals of an axis that no machine has, which ask whether units and scales are right."""

from __future__ import annotations

import numpy as np

from contourlab.features.identify.signals import AxisRecord
from contourlab.features.measure.likely import same_column, unlikely_motion, unlikely_period

LARGEST = {"N": 1e5, "V": 1e3, "A": 1e3, "full_scale": 1.01}
"""Commands, by their unit, beyond which none of a feed drive goes."""


def doubts(record: AxisRecord) -> list[str]:
    """Return what is doubtful about a record's signals, in words; nothing for a likely one.

    Parameters
    ----------
    record : AxisRecord
    """
    said = unlikely_period(record.period, record.source)
    position = record.position[:, None]
    said += unlikely_motion(position, record.period, f"{record.axis} in {record.source}")
    if record.reference is not None:
        said += same_column((record.axis,), record.reference[:, None], position, f" in {record.source}")
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
