"""The outcome of relay experiments as a table."""

from __future__ import annotations

from collections.abc import Mapping

from contourlab.analysis.identification.least_squares import Bounds
from contourlab.analysis.identification.relay import RelayTest
from contourlab.figures import figure, number
from contourlab.rendering.table import Column, Table


def relay_table(tests: Mapping[str, RelayTest], units: Mapping[str, str]) -> Table:
    """Return ultimate gain and period of each axis, with intervals of 95 %; `units` are those of the commands."""
    rows = [
        (axis, *_cells(test.gain, 1e-3), f"{units[axis] or '1'}/mm", *_cells(test.period, 1e3), "ms", figure(test.travel, "mm"))
        for axis, test in tests.items()
    ]
    interval = [Column("95 %", left=True), Column("", left=True)]
    columns = [Column("axis", left=True), Column("ultimate gain"), *interval, Column("period"), *interval, Column("travel")]
    return Table(columns, "Relay experiment", rows=rows)


def _cells(x: Bounds, factor: float) -> tuple[str, str]:
    return number(factor * x.value), f"{number(factor * x.low)} .. {number(factor * x.high)}"
