"""Checks of the rows of a reproduction: each can fail, and a page shows what the command prints."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from unittest.mock import patch

from contourlab.papers.rows import Row
from contourlab.papers.run import text_of

DOCS = Path(__file__).resolve().parents[2] / "docs"


def check_each_row_can_fail(rows: Sequence[Row]) -> None:
    """Check that every row lies in its band, and fails with a figure ten times off; where there is no figure, any figure fails."""
    for row in rows:
        assert row.band is not None and row.passed is not False, (row.name, row.case, row.here, row.band)
        off = 10.0 * max(abs(row.here), *map(abs, row.band))
        assert replace(row, here=off if math.isfinite(off) else 1.0).passed is False, (row.name, row.case)


def check_page(name: str, rows: Sequence[Row]) -> None:
    """Check that a page under docs has the table of computed figures and the conclusion, as the command prints them."""
    page = (DOCS / name).read_text(encoding="utf-8")
    with patch.dict(os.environ, COLUMNS="80"):
        table, *_, conclusion = text_of(rows).split("\n\n")
    assert table in page and conclusion in page
