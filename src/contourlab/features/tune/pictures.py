"""The way that a calibration took: the objective from step to step, the line of each number, and the error before and after."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.report.charts import Chart, Curve, Panel
from contourlab.report.style import scheme_style

Array = NDArray[np.float64]
SMALLEST = 1e-12


@dataclass(frozen=True, eq=False)
class Line:
    """What was tried of one number: values over the one it had, and the objective of each; `axis` is the axis, or part, it belongs to."""

    name: str
    axis: str
    factor: Array
    objective: Array


def tuning_charts(
    label: str, course: Mapping[str, tuple[Array, Array]], lines: Sequence[Line], errors: Mapping[str, tuple[Array, Array]]
) -> tuple[Chart, ...]:
    """Return the pictures of a calibration.

    Parameters
    ----------
    label : str
        The objective with its unit.
    course : mapping of str to (ndarray (n,), ndarray (n,))
        By method: runs so far, and the objective by then.
    lines : sequence of Line
        Of the sequential procedure, in its order.
    errors : mapping of str to (ndarray (n,) [s], ndarray (n,) [um])
        Contour error over time, before and after.
    """
    found = []
    curves = [Curve(*_drawn(*of), name, *scheme_style(i, len(course))) for i, (name, of) in enumerate(course.items())]
    if curves:
        panel = Panel("runs", label, tuple(curves), log_y=True)
        caption = "The objective over runs: after each number of the sequential procedure; of the global search the best so far."
        found.append(Chart("tune-course", "Course of the calibration", caption, (panel,), panel_height=320))
    if lines:
        found.append(_lines(label, lines))
    traces = [Curve(x, y, name, *scheme_style(i, len(errors))) for i, (name, (x, y)) in enumerate(errors.items())]
    if traces:
        panel = Panel("time [s]", "contour error [um]", tuple(traces))
        found.append(Chart("tune-error", "Contour error before and after", "Over the time that counts, by the exact judge.", (panel,)))
    return tuple(found)


def _lines(label: str, lines: Sequence[Line]) -> Chart:
    axes = dict.fromkeys(line.axis for line in lines)
    panels = []
    for axis in axes:
        mine = [line for line in lines if line.axis == axis]
        curves = tuple(
            Curve(*_drawn(line.factor, line.objective), line.name, *scheme_style(i, max(len(mine), 2))) for i, line in enumerate(mine)
        )
        panels.append(
            Panel("value over the one it had", f"{axis}: {label}", curves, log_x=all((c.x > 0.0).all() for c in curves), log_y=True)
        )
    caption = "Each curve is one number, all others fixed at what they were then: where it is flat, the number hardly matters."
    return Chart("tune-lines", "One number at a time", caption, tuple(panels), panel_height=320)


def _drawn(x: Array, y: Array) -> tuple[Array, Array]:
    """Return what a logarithmic scale can show."""
    kept = np.isfinite(x) & np.isfinite(y) & (y > SMALLEST)
    return x[kept], y[kept]
