"""Tables of a calibration: its steps, figures and margins before and after, parameters, and drive terms."""

from __future__ import annotations

import math
from collections.abc import Iterator

from contourlab.analysis.linear.margins import Margins
from contourlab.features.tune.objective import FIGURES, Goal
from contourlab.features.tune.study import Tuned
from contourlab.figures import figure, listing
from contourlab.rendering.margin_words import decibel, degrees
from contourlab.rendering.table import Column, Table, paragraphs


def tables(goal: Goal, tuned: Tuned) -> Iterator[str]:
    """Yield the figure that was minimised, before and after, and the tables of a calibration."""
    if goal.figure is not None:
        name, unit = FIGURES[goal.figure]
        before, after = (figure(run.figures[goal.figure], unit, 4) for run in (tuned.before, tuned.after))
        yield f"{name}: {before} before, {after} after"
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
    for key, (name, unit) in FIGURES.items():
        before, after = tuned.before.figures[key], tuned.after.figures[key]
        ratio = after / before if before * after > 0.0 else math.nan
        table.add(name, figure(before, unit, 4), figure(after, unit, 4), figure(ratio))
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
