"""Tables and pictures of a calibration: its steps, figures and margins before and after, parameters, and drive terms."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.arrays import Array
from contourlab.features.tune.objective import Goal
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
    rows = []
    for step in tuned.path.steps:
        variable = step.variable
        values = (figure(variable.display_value(value), digits=5) for value in (step.before, step.after))
        objectives = (figure(value, goal.unit, 4) for value in (step.objective_before, step.objective_after))
        rows.append((step.stage, variable.short, *values, variable.display_unit, *objectives, step.bound))
    columns = [Column(head, left=head in left) for head in heads]
    return Table([*columns, Column("limited by", prose=True)], keys=2, rows=rows)


def _figures(tuned: Tuned) -> Table:
    rows: list[tuple[str, ...]] = []
    for name, one in FIGURES.items():
        before, after = tuned.before.figures[name], tuned.after.figures[name]
        ratio = after / before if before * after > 0.0 else math.nan
        rows.append((one.label, figure(before, one.display, 4), figure(after, one.display, 4), figure(ratio)))
    return Table([Column("figure", left=True), *map(Column, ("before", "after", "after/before"))], rows=rows)


def _margins(tuned: Tuned) -> Table:
    heads = ("gain margin before", "after", "phase margin before", "after", "modulus margin before", "after")
    both = {axis: (tuned.before.margins.get(axis), after) for axis, after in tuned.after.margins.items()}
    rows = [(axis, *(show(margins) for show in (decibel, degrees, _modulus) for margins in pair)) for axis, pair in both.items()]
    return Table([Column("axis", left=True), *map(Column, heads)], rows=rows)


def _modulus(margins: Margins | None) -> str:
    return figure(math.nan if margins is None else margins.modulus)


def _parameters(tuned: Tuned) -> Table:
    columns = [Column("parameter", left=True), Column("start"), Column("tuned"), Column("unit", left=True)]
    both = {variable: (variable.value, tuned.values[variable.name]) for variable in tuned.space.numbers}
    shown = {variable: [figure(variable.display_value(value), digits=6) for value in pair] for variable, pair in both.items()}
    return Table(columns, rows=[(variable.short, *texts, variable.display_unit) for variable, texts in shown.items()])


def _drives(tuned: Tuned) -> Table:
    """Return Kv, the velocity loop, and LinuxCNC's gains for machine units of mm, one axis per column."""
    terms = tuned.drive_terms
    gains = [{} if axis.linuxcnc is None else axis.linuxcnc.per_millimetre() for axis in terms]
    rows = {
        "Kv [1/s]": [figure(axis.kv, digits=4) for axis in terms],
        "Kv [(m/min)/mm]": [figure(0.06 * axis.kv, digits=4) for axis in terms],
        "velocity loop, -3 dB": [figure(axis.velocity_bandwidth, "Hz", 4) for axis in terms],
        "LinuxCNC output, machine units mm": [axis.command_unit for axis in terms],
        **{f"LinuxCNC {name}": [figure(axis.get(name, math.nan), digits=6) for axis in gains] for known in gains for name in known},
        "LinuxCNC command difference, rms": [figure(axis.difference_rms, "%", 2) for axis in terms],
        "LinuxCNC command difference, max": [figure(axis.difference, "%", 2) for axis in terms],
    }
    columns = [Column("drive terms", left=True), *(Column(f"axis {axis.axis}") for axis in terms)]
    return Table(columns, rows=[(head, *texts) for head, texts in rows.items()])


SMALLEST = 1e-12
Trace = tuple[str, Array, Array]
"""Name, x and y of a curve."""


def tuning_charts(goal: Goal, tuned: Tuned) -> Iterator[Chart]:
    """Yield the pictures of a calibration."""
    scale = 1e6 if goal.unit.startswith("um") else 1.0
    label = f"{goal.label} [{goal.unit}]" if goal.unit else goal.label
    steps, progress = tuned.path.steps, list[Trace]()
    if steps:
        runs = np.cumsum([0, *(len(step.values) for step in steps)]).astype(float)
        reached = scale * np.array([tuned.start_objective, *(step.objective_after for step in steps)])
        progress.append(("one parameter at a time", *_positive(runs, reached)))
    if tuned.global_result is not None:
        runs, best = tuned.global_result.search.course.T
        progress.append(("all parameters at once", *_positive(runs, scale * best)))
    if progress:
        panel = Panel("runs", label, _curves(progress), log_y=True)
        caption = "Objective over runs: after each step of the sequential procedure; for the global search, the best so far."
        yield Chart("tune-course", "Progress of the calibration", caption, (panel,), panel_height=320)
    axes: dict[str, list[Trace]] = {}
    for step in steps:
        if step.stage != "repair" and step.before:
            axis, _, name = step.variable.short.partition(".")
            axes.setdefault(axis, []).append((name, *_positive(step.values / step.before, scale * step.objectives)))
    if axes:
        panels = []
        for axis, lines in axes.items():
            log_x = all((x > 0.0).all() for _, x, _ in lines)
            panels.append(Panel("value / previous value", f"{axis}: {label}", _curves(lines, 2), log_x=log_x, log_y=True))
        caption = (
            "Each curve varies one parameter, with all others at their values of that step. A flat curve: the parameter hardly matters."
        )
        yield Chart("tune-lines", "One parameter at a time", caption, tuple(panels), panel_height=320)
    errors = list[Trace]()
    for name, run in (("before", tuned.before.run), ("after", tuned.after.run)):
        if run is not None:
            half = len(run.time) // 2
            errors.append((name, run.time[half:], 1e6 * run["contour_error"][half:]))
    if errors:
        panel = Panel("time [s]", "contour error [um]", _curves(errors))
        yield Chart("tune-error", "Contour error before and after", "Second half of the run.", (panel,))


def _curves(traces: Sequence[Trace], least: int = 1) -> tuple[Curve, ...]:
    count = max(len(traces), least)
    return tuple(Curve(x, y, name, *scheme_style(i, count)) for i, (name, x, y) in enumerate(traces))


def _positive(x: Array, y: Array) -> tuple[Array, Array]:
    """Return the points that a logarithmic scale can show."""
    kept = np.isfinite(x) & np.isfinite(y) & (y > SMALLEST)
    return x[kept], y[kept]
