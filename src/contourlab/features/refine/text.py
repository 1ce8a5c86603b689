"""Tables of a refinement."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from contourlab.features.refine.log_run import Agreement
from contourlab.features.refine.study import Refined
from contourlab.figures import figure
from contourlab.report.table import Column, Table


def parameter_table(refined: Refined) -> Table:
    """Return the refined parameters with their deviations."""
    heads = ("start", "refined", "deviation", "deviation if white")
    table = Table([Column("parameter", left=True), *map(Column, heads)])
    for parameter in refined.parameters:
        sought = parameter.sought
        values = (sought.shown(sought.variable.value), sought.shown(parameter.value))
        table.add(sought.label, *values, sought.shown(parameter.deviation, 2), sought.shown(parameter.white_deviation, 2))
    return table


def agreement_table(groups: Mapping[str, Sequence[Agreement]]) -> Table:
    """Return how well the simulation follows the logs, a group of rows for each key."""
    left = ("samples", "run", "axis", "signal")
    table = Table([*(Column(head, left=True) for head in left), *map(Column, ("explained", "fit", "left, rms"))])
    for name, agreements in groups.items():
        for one in agreements:
            rms = figure(one.rms, "um" if one.signal == "position" else "")
            table.add(name, one.run, one.axis, one.signal, figure(one.explained, "%", 5), figure(one.fit / 100.0, "%", 4), rms)
    return table
