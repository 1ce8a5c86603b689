"""Checks of the rows of a reproduction: each can fail, and a page shows what the command prints."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest

from contourlab.papers.rows import CLOSE, COMPUTED, Row

DOCS = Path(__file__).resolve().parents[2] / "docs"


def check_each_row_can_fail(rows: Sequence[Row]) -> None:
    """Check that every row lies in its band, and fails with a figure ten times off; where there is no figure, any figure fails."""
    for row in rows:
        assert row.band is not None and row.passed is not False, (row.name, row.case, row.here, row.band)
        off = 10.0 * max(abs(row.here), *map(abs, row.band))
        assert replace(row, here=off if math.isfinite(off) else 1.0).passed is False, (row.name, row.case)


def check_page(name: str, rows: Sequence[Row]) -> None:
    """Check that a page has the table of computed figures: counts as in the rows, the worst within a fifth."""
    shown = {}
    for line in (DOCS / name).read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 3 + len(CLOSE):
            shown[cells[0]] = cells[1:]
    found: dict[str, list[Row]] = {}
    for row in rows:
        if row.kind == COMPUTED and row.main and row.paper is not None:
            found.setdefault(f"{row.name} [{row.unit}]" if row.unit else row.name, []).append(row)
    assert set(found) <= set(shown)
    for figure, group in found.items():
        *counts, worst = shown[figure]
        edges = (-1.0, *CLOSE, math.inf)
        steps = [sum(low < abs(row.off) <= high for row in group) for low, high in itertools.pairwise(edges)]
        assert [int(count or 0) for count in counts] == steps, figure
        assert float(worst) == pytest.approx(100.0 * max((row.off for row in group), key=abs), rel=0.2, abs=0.05), figure
