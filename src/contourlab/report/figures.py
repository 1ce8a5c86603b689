"""How the report reads metrics: each figure by its name, with factor and unit for print."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from contourlab.report.data import SchemeReport

__all__ = ["Figure", "error_figures", "figures_of"]

_ERRORS = (
    ("max", "largest", 1e6, "µm"),
    ("rms", "rms", 1e6, "µm"),
    ("p95", "95 %", 1e6, "µm"),
    ("mean", "mean", 1e6, "µm"),
    ("integral", "integral", 1e6, "µm·s"),
)


@dataclass(frozen=True)
class Figure:
    """One number of one run: SI value, and how to print it."""

    label: str
    value: float
    factor: float
    unit: str
    strong: bool = False
    lower_is_better: bool = True


def error_figures(scheme: SchemeReport) -> dict[str, float]:
    """Return the figures of the error that the tolerance is held against, by name [m, m s]."""
    metrics = scheme.metrics
    found: Any = getattr(metrics, "part_error", None) or metrics.contour_error
    return {name: float(getattr(found, name, math.nan)) for name, *_ in _ERRORS}


def figures_of(scheme: SchemeReport, axes: Sequence[str]) -> dict[str, Figure]:
    """Return the figures of a run in the order of print, by label."""
    metrics = scheme.metrics
    found: list[Figure] = []
    for kind in ("part_error", "contour_error"):
        error: Any = getattr(metrics, kind, None)
        if error is None:
            continue
        for name, label, factor, unit in _ERRORS:
            value = float(getattr(error, name, math.nan))
            strong = name == "max" and not found
            found.append(Figure(f"{kind.replace('_', ' ')}, {label}", value, factor, unit, strong))
    for axis, error in zip(axes, getattr(metrics, "tracking_error", ()), strict=False):
        found.append(Figure(f"tracking error {axis}, rms", float(error.rms), 1e6, "µm"))
    for axis, share in zip(axes, getattr(metrics, "saturation", ()), strict=False):
        found.append(Figure(f"command {axis} saturated", float(share), 100.0, "% of time"))
    found.append(Figure("cycle time", float(getattr(metrics, "cycle_time", math.nan)), 1.0, "s"))
    return {figure.label: figure for figure in found}
