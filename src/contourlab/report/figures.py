"""How the report reads metrics: each figure by its name, with factor and unit for print."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from contourlab.metrics import ErrorFigures
from contourlab.report.data import ReportData, SchemeReport

UM = 1e6


@dataclass(frozen=True)
class Figure:
    """One number of one run: SI value, and how to print it.

    Parameters
    ----------
    label : str
    value : float
        SI.
    factor : float
        From SI to `unit`.
    unit : str
    strong : bool
        Whether the tolerance is held against it.
    lower_is_better : bool
    """

    label: str
    value: float
    factor: float
    unit: str
    strong: bool = False
    lower_is_better: bool = True


def figures_of(data: ReportData, scheme: SchemeReport) -> dict[str, Figure]:
    """Return the figures of a run in the order of print, by label.

    Notes
    -----
    Where the planned path is the programmed one, part error and contour error are the same thing and are printed once.
    """
    found = [*_errors(data, scheme), *_axes(data, scheme), *_motion(scheme), *_cost(scheme)]
    return {figure.label: figure for figure in found}


def _errors(data: ReportData, scheme: SchemeReport) -> Iterator[Figure]:
    """Yield the figures of the errors."""
    metrics = scheme.metrics
    if data.is_blended:
        yield Figure("part error, largest", metrics.part_error.max, UM, "um", strong=True)
        yield Figure("part error, rms", metrics.part_error.rms, UM, "um")
        yield Figure("planning deviation, largest", metrics.planning_deviation.max, UM, "um")
    yield from _contour(metrics.contour_error, strong=not data.is_blended, sided=len(data.axes) == 2)


def _contour(error: ErrorFigures, strong: bool, sided: bool) -> Iterator[Figure]:
    """Yield the figures of the contour error; in space it has no side, and so no signed mean."""
    yield Figure("contour error, largest", error.max, UM, "um", strong=strong)
    yield Figure("contour error, rms", error.rms, UM, "um")
    yield Figure("contour error, mean", error.mean, UM, "um")
    yield Figure("contour error, 95th percentile", error.p95, UM, "um")
    if sided:
        yield Figure("contour error, signed mean", error.signed_mean, UM, "um", lower_is_better=False)
    yield Figure("contour error, integral", error.integral, UM, "um s")


def _axes(data: ReportData, scheme: SchemeReport) -> Iterator[Figure]:
    """Yield the figures of each axis and its drive."""
    for axis, error in zip(data.axes, scheme.metrics.tracking_error, strict=True):
        yield Figure(f"tracking error {axis}, rms", error.rms, UM, "um")
    for axis, part in zip(data.axes, scheme.metrics.saturation, strict=True):
        yield Figure(f"drive {axis} saturated", part, 100.0, "% of time")


def _cost(scheme: SchemeReport) -> Iterator[Figure]:
    """Yield what the loop costs, where it was measured."""
    if scheme.tick is not None:
        yield Figure("servo tick, machine included", scheme.tick, 1e9, "ns", lower_is_better=False)


def _motion(scheme: SchemeReport) -> Iterator[Figure]:
    """Yield the figures of feed and time."""
    yield Figure("feedrate, mean", scheme.metrics.feedrate_mean, 6e4, "mm/min", lower_is_better=False)
    yield Figure("feedrate, ripple", scheme.metrics.feedrate_ripple, 100.0, "%")
    yield Figure("cycle time", scheme.metrics.cycle_time, 1.0, "s")
