"""Pictures of a calibration: the objective over the runs, the line search of each parameter, the contour error before and after."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from contourlab.arrays import Array
from contourlab.features.tune.line_search import Step
from contourlab.features.tune.objective import Goal
from contourlab.features.tune.study import Tuned
from contourlab.rendering.charts import Chart, Curve, Panel
from contourlab.rendering.style import scheme_style

SMALLEST = 1e-12


def tuning_charts(goal: Goal, tuned: Tuned) -> tuple[Chart, ...]:
    """Return the pictures of a calibration."""
    scale = 1e6 if goal.unit.startswith("um") else 1.0
    label = f"{goal.label} [{goal.unit}]" if goal.unit else goal.label
    charts = []
    progress = _progress(tuned, scale)
    if progress:
        panel = Panel("runs", label, _curves(progress), log_y=True)
        caption = "Objective over runs: after each step of the sequential procedure; for the global search, the best so far."
        charts.append(Chart("tune-course", "Progress of the calibration", caption, (panel,), panel_height=320))
    lines = [step for step in tuned.path.steps if step.stage != "repair" and step.before]
    if lines:
        charts.append(_lines(label, lines, scale))
    errors = {}
    for name, evaluation in (("before", tuned.before), ("after", tuned.after)):
        if evaluation.run is not None:
            error = evaluation.run["contour_error"]
            half = len(error) // 2
            errors[name] = (evaluation.run.time[half:], 1e6 * error[half:])
    if errors:
        panel = Panel("time [s]", "contour error [um]", _curves(errors, positive=False))
        charts.append(Chart("tune-error", "Contour error before and after", "Second half of the run.", (panel,)))
    return tuple(charts)


def _progress(tuned: Tuned, scale: float) -> dict[str, tuple[Array, Array]]:
    """Return the objective over runs, by method."""
    progress = {}
    steps = tuned.path.steps
    if steps:
        runs = np.cumsum([0, *(len(step.values) for step in steps)]).astype(float)
        objective = np.array([tuned.start_objective, *(step.objective_after for step in steps)])
        progress["one parameter at a time"] = (runs, scale * objective)
    if tuned.global_result is not None:
        course = tuned.global_result.search.course
        progress["all parameters at once"] = (course[:, 0], scale * course[:, 1])
    return progress


def _lines(label: str, steps: Sequence[Step], scale: float) -> Chart:
    axes: dict[str, list[tuple[str, Step]]] = {}
    for step in steps:
        axis, _, name = step.variable.short.partition(".")
        axes.setdefault(axis, []).append((name, step))
    panels = []
    for axis, lines in axes.items():
        styles = [scheme_style(i, max(len(lines), 2)) for i in range(len(lines))]
        curves = tuple(
            Curve(*_positive(step.values / step.before, scale * step.objectives), name, *style)
            for (name, step), style in zip(lines, styles, strict=True)
        )
        log_x = all((curve.x > 0.0).all() for curve in curves)
        panels.append(Panel("value / previous value", f"{axis}: {label}", curves, log_x=log_x, log_y=True))
    caption = "Each curve varies one parameter, with all others at their values of that step. A flat curve: the parameter hardly matters."
    return Chart("tune-lines", "One parameter at a time", caption, tuple(panels), panel_height=320)


def _curves(traces: Mapping[str, tuple[Array, Array]], positive: bool = True) -> tuple[Curve, ...]:
    drawn = {name: _positive(*trace) if positive else trace for name, trace in traces.items()}
    return tuple(Curve(x, y, name, *scheme_style(i, len(drawn))) for i, (name, (x, y)) in enumerate(drawn.items()))


def _positive(x: Array, y: Array) -> tuple[Array, Array]:
    """Return the points that a logarithmic scale can show."""
    kept = np.isfinite(x) & np.isfinite(y) & (y > SMALLEST)
    return x[kept], y[kept]
