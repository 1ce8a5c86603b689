"""How near the planned motion comes to the limits of the axes, as its independent verifier finds it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from contourlab.feed.verify import LimitReport, Worst
from contourlab.figures import NONE, figure, shown_unit
from contourlab.report.data import ReportData

TITLE = "Planned motion against the limits of the axes"
_ROWS = (
    ("velocity", "velocity", "m/s"),
    ("acceleration", "acceleration", "m/s^2"),
    ("jerk", "jerk", "m/s^3"),
    ("step of curvature", "curvature_step", "m/s^2"),
    ("kink", "kink", "m/s"),
)


@dataclass(frozen=True)
class LimitTable:
    """One planned motion: a row per kind of limit, with the cells worst axis, value, limit, part of it, time, line."""

    title: str
    rows: tuple[tuple[str, tuple[str, ...]], ...]


def nearest(entries: Sequence[Worst]) -> Worst | None:
    """Return the entry of the axis that comes nearest to its limit, or goes furthest beyond; None where no axis had any.

    Without a limit on any axis it is the one with the largest value.
    """
    seen = [entry for entry in entries if entry.sample >= 0]
    return max(seen, key=lambda entry: (entry.ratio, entry.value), default=None)


def limit_tables(data: ReportData) -> tuple[LimitTable, ...]:
    """Return one table for each motion that was planned within limits; schemes whose figures are the same share it."""
    found: list[tuple[LimitReport, list[str]]] = []
    for scheme in data.schemes:
        if scheme.limits is None:
            continue
        names = next((names for report, names in found if report == scheme.limits), None)
        if names is None:
            found.append((scheme.limits, [scheme.name]))
        else:
            names.append(scheme.name)
    return tuple(_table(report, names if len(names) < len(data.schemes) else [], data.axes) for report, names in found)


def _table(report: LimitReport, names: Sequence[str], axes: Sequence[str]) -> LimitTable:
    title = f"{TITLE}: {', '.join(names)}" if names else TITLE
    return LimitTable(title, tuple((label, _cells(nearest(getattr(report, kind)), unit, axes)) for label, kind, unit in _ROWS))


def _cells(worst: Worst | None, unit: str, axes: Sequence[str]) -> tuple[str, ...]:
    """Return the cells of one row; dashes where there was nothing of the kind."""
    if worst is None:
        return (NONE,) * 6
    shown = shown_unit(unit)[1]
    bounded = math.isfinite(worst.limit)
    return (
        axes[worst.axis],
        figure(worst.value, shown, 4),
        figure(worst.limit, shown, 4) if bounded else "none",
        f"{100.0 * worst.ratio:.1f} %" if bounded else NONE,
        figure(worst.time, "s", 5),
        str(worst.source_line) if worst.source_line else NONE,
    )
