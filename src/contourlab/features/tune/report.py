"""Tables and pictures of a calibration: its steps, figures and margins before and after, parameters, and drive terms."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.arrays import Array
from contourlab.features.tune.objective import Goal
from contourlab.features.tune.search import Step
from contourlab.features.tune.study import Tuned
from contourlab.figures import figure, listing
from contourlab.metrics.run_figures import FIGURES
from contourlab.rendering.charts import Chart, Curve, Panel
from contourlab.rendering.margin_words import decibel, degrees
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import Column, Table, paragraphs


def tables(goal: Goal, tuned: Tuned) -> Iterator[str]:
    """Yield the figure that was minimised, before and after, and the tables of a calibration."""
    if goal.figure is not None:
        before, after = (figure(run.figures[goal.figure], goal.unit, 4) for run in (tuned.before, tuned.after))
        yield f"{FIGURES[goal.figure].label}: {before} before, {after} after"
    if tuned.path.steps:
        yield _steps(goal, tuned).text()
    if tuned.global_result is not None:
        search = tuned.global_result.search
        per_start = listing([figure(value, goal.unit, 4) for value in search.per_start])
        yield paragraphs([f"Global search: best of each start {per_start}; {search.runs} runs. Method of the result: {tuned.method}."])
    yield _figures(tuned).text()
    if tuned.after.margins:
        yield _margins(tuned).text()
    yield _parameters(tuned).text()
    yield _drives(tuned).text()


def _steps(goal: Goal, tuned: Tuned) -> Table:
    left = {"step", "parameter", "unit"}
    heads = ("step", "parameter", "from", "to", "unit", "objective before", "after")
    table = Table([*(Column(head, left=head in left) for head in heads), Column("limited by", prose=True)], keys=2)
    for step in tuned.path.steps:
        variable = step.variable
        values = (figure(variable.display_value(value), digits=5) for value in (step.before, step.after))
        objectives = (figure(value, goal.unit, 4) for value in (step.objective_before, step.objective_after))
        table.add(step.stage, variable.short, *values, variable.display_unit, *objectives, step.bound)
    return table


def _figures(tuned: Tuned) -> Table:
    table = Table([Column("figure", left=True), Column("before"), Column("after"), Column("after/before")])
    for name, one in FIGURES.items():
        before, after = tuned.before.figures[name], tuned.after.figures[name]
        ratio = after / before if before * after > 0.0 else math.nan
        table.add(one.label, figure(before, one.display, 4), figure(after, one.display, 4), figure(ratio))
    return table


def _margins(tuned: Tuned) -> Table:
    heads = ("gain margin before", "after", "phase margin before", "after", "modulus margin before", "after")
    table = Table([Column("axis", left=True), *map(Column, heads)])
    for axis, after in tuned.after.margins.items():
        both = (tuned.before.margins.get(axis), after)
        table.add(axis, *(show(margins) for show in (decibel, degrees, _modulus) for margins in both))
    return table


def _modulus(margins: Margins | None) -> str:
    return figure(math.nan if margins is None else margins.modulus)


def _parameters(tuned: Tuned) -> Table:
    table = Table([Column("parameter", left=True), Column("start"), Column("tuned"), Column("unit", left=True)])
    for variable in tuned.space.numbers:
        values = (figure(variable.display_value(value), digits=6) for value in (variable.value, tuned.values[variable.name]))
        table.add(variable.short, *values, variable.display_unit)
    return table


def _drives(tuned: Tuned) -> Table:
    """Return Kv, the velocity loop, and LinuxCNC's gains for machine units of mm, one axis per column."""
    terms = tuned.drive_terms
    gains = [{} if axis.linuxcnc is None else axis.linuxcnc.per_millimetre() for axis in terms]
    table = Table([Column("drive terms", left=True), *(Column(f"axis {axis.axis}") for axis in terms)])
    table.add("Kv [1/s]", *(figure(axis.kv, digits=4) for axis in terms))
    table.add("Kv [(m/min)/mm]", *(figure(0.06 * axis.kv, digits=4) for axis in terms))
    table.add("velocity loop, -3 dB", *(figure(axis.velocity_bandwidth, "Hz", 4) for axis in terms))
    table.add("LinuxCNC output, machine units mm", *(axis.command_unit for axis in terms))
    for name in dict.fromkeys(name for axis in gains for name in axis):
        table.add(f"LinuxCNC {name}", *(figure(axis.get(name, math.nan), digits=6) for axis in gains))
    table.add("LinuxCNC command difference, rms", *(figure(axis.difference_rms, "%", 2) for axis in terms))
    table.add("LinuxCNC command difference, max", *(figure(axis.difference, "%", 2) for axis in terms))
    return table


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
