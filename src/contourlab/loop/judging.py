"""What judges a batch while it runs: nodes behind the loop that nothing in it reads, and the figures they leave."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.engine.runner import Group
from contourlab.engine.schedule import Late, Node
from contourlab.feed import Reference
from contourlab.geometry.view import PathView
from contourlab.loop.builder import accepted_output
from contourlab.loop.machine import Axis, Machine
from contourlab.metrics.effort import EFFORT_SUMS, effort_step
from contourlab.metrics.streaming import SUMS, corner_parts, judge_step

Array = NDArray[np.float64]
Window = tuple[int, int]


def counted(reference: Reference, window: Window | None) -> Window:
    """Return the samples [start, stop) that count: those asked for, the last whole lap, or all."""
    return window or (reference.laps[-1] if reference.laps else (0, reference.n_sample))


def judge_node(machine: Machine, reference: Reference, view: PathView, window: Window | None) -> Node:
    """Return the node that works out the contour error of each lane."""
    start, stop = counted(reference, window)
    n = len(machine.axes)
    wires: dict[str, Any] = {
        "position": tuple(Late(f"{axis.name}.plant.position") for axis in machine.axes),
        "reference": "in.reference",
        "arc_length": "in.arc_length",
    }
    reach = min(0.25 * reference.path.length, 4.0 * max(axis.limits.following_error for axis in machine.axes))
    corner_numbers, corner_tables = corner_parts(reference.path)
    parameters = {"window": reach, "first": float(start), "last": float(stop - 1), **view.parameters, **corner_numbers}
    foot = float(reference.block(0, 1).arc_length[0])
    step = judge_step(view, n, bool(corner_numbers))
    return Node("judge", step, wires, parameters, {**view.tables, **corner_tables}, {"foot": foot})


def effort_node(machine: Machine, commands: Sequence[str], columns: Mapping[str, Array], window: Window) -> Node:
    """Return the node that adds up what each lane asks of its drives; `commands` are the signals that come to them, one for each axis."""
    rates = {f"rate_{i}": _rate(axis, columns) for i, axis in enumerate(machine.axes)}
    wires: dict[str, Any] = {
        "command": tuple(commands),
        "accepted": tuple(f"{axis.name}.drive.{accepted_output(axis.drive)}" for axis in machine.axes),
    }
    return Node("effort", effort_step(len(machine.axes)), wires, {**rates, "first": float(window[0]), "last": float(window[1] - 1)})


def _rate(axis: Axis, columns: Mapping[str, Array]) -> float | Array:
    """Return one over the limit of a drive, an array where it differs between variants; 1 where it has none."""
    limit = columns.get(f"axes.{axis.name}.drive.limit", getattr(axis.drive, "limit", math.inf))
    if isinstance(limit, np.ndarray):
        return np.where(np.isfinite(limit), 1.0 / limit, 1.0)
    return 1.0 / limit if math.isfinite(limit) else 1.0


def sums_of(groups: list[Group], node: str, n: int) -> Array:
    """Return the states of a judging node in all lanes: (n_state, n)."""
    return np.concatenate([group.state_of(node) for group in groups], axis=1)[:, :n]


def error_figures(sums: Array, failed: NDArray[np.int64], period: float) -> dict[str, Array]:
    """Return the figures of the judge's sums (rows as of `SUMS`); NaN for a lane that failed."""
    one = dict(zip(SUMS, sums, strict=True))
    count = np.maximum(one["count"], 1.0)
    figures = {
        "contour_error_rms": np.sqrt(one["sum_square"] / count),
        "contour_error_mean": one["sum_magnitude"] / count,
        "contour_error_max": one["largest"],
        "contour_error_max_time": one["largest_at"] * period,
        "contour_error_signed_mean": one["sum_signed"] / count,
        "contour_error_integral": one["sum_magnitude"] * period,
        "tracking_error_rms": np.sqrt(one["sum_tracking"] / count),
        "tracking_error_max": np.sqrt(one["largest_tracking"]),
    }
    return {name: np.where(failed < 0, values, np.nan) for name, values in figures.items()}


def effort_figures(sums: Array, failed: NDArray[np.int64], period: float) -> dict[str, Array]:
    """Return the figures of the drives' sums (rows as of `EFFORT_SUMS`); NaN for a lane that failed."""
    one = dict(zip(EFFORT_SUMS, sums, strict=True))
    figures = {
        "command_energy": one["sum_square"] * period,
        "command_largest": one["largest"],
        "limited_share": one["limited"] / np.maximum(one["count"], 1.0),
    }
    return {name: np.where(failed < 0, values, np.nan) for name, values in figures.items()}
