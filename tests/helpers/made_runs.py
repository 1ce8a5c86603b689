"""Runs built without machine and controller, so that their errors are known."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.feed import Reference, uniform
from contourlab.geometry import Path, contour
from contourlab.result import Result, Signal

Array = NDArray[np.float64]
PERIOD = 1e-3


def made_run(reference: Reference, tool: Array, **more: Array) -> Result:
    """Return an unjudged result in which the tool was at `tool` (n_sample, n_axis) [m]."""
    asked = reference.block(0, reference.n_sample)
    both, one = ("sample", "axis"), ("sample",)
    signals = {
        "tool_position": Signal(tool, both, "m"),
        "reference": Signal(asked.position, both, "m"),
        "reference_velocity": Signal(asked.velocity, both, "m/s"),
        "arc_length": Signal(asked.arc_length, one, "m"),
        "feedrate": Signal(asked.feedrate, one, "m/s"),
        **{name: Signal(data, both if data.ndim == 2 else one, "m") for name, data in more.items()},
    }
    return Result("made", tuple("xyz"[: reference.n_axis]), reference.servo_period, signals)


def with_error(result: Result, contour_error: Array, **more: Any) -> Result:
    """Return a result whose judge's signals are given, not computed."""
    one = Signal(contour_error, ("sample",), "m")
    tracking = Signal(np.zeros((len(contour_error), len(result.axes))), ("sample", "axis"), "m")
    foot = result.signals["arc_length"]
    judged = {"contour_error": one, "part_error": one, "planning_deviation": one, "tracking_error": tracking, "foot_arc_length": foot}
    return result.with_signals(**(judged | more))


def samples_on(path: Path, arc_length: Array, programmed: Path | None = None) -> Reference:
    """Return a reference at the given arc lengths of a path, one per sample."""
    return Reference.from_samples(path.position(arc_length), PERIOD, path, arc_length=arc_length, programmed=programmed)


def circle_laps(n: int = 1000, laps: int = 1, radius: float = 0.02, clockwise: float = 0.0) -> Reference:
    """Return `laps` laps of a circle around the origin, n samples each."""
    return uniform(contour("circle", radius=radius, clockwise=clockwise), 1.0 / (n * PERIOD), laps, PERIOD)
