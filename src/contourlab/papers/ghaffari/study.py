"""Parts of Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring"."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from contourlab.papers.ghaffari.bench import bench_rows
from contourlab.papers.ghaffari.calibration import calibration_rows
from contourlab.papers.ghaffari.identified import identified_rows
from contourlab.papers.ghaffari.linear import linear_rows
from contourlab.papers.ghaffari.observer import observer_rows
from contourlab.papers.ghaffari.reference_6 import reference_6_rows
from contourlab.papers.ghaffari.runs import run_rows
from contourlab.papers.ghaffari.sensitivity import sensitivity_rows
from contourlab.papers.ghaffari.setup import READING
from contourlab.papers.ghaffari.swap import swap_rows
from contourlab.papers.rows import COMPUTED, Part, Row


def _stated(rows_of: Callable[[], Iterable[Row]]) -> Callable[[], list[Row]]:
    """Name the stated reading in the computed rows that rest on it."""

    def rows() -> list[Row]:
        return [replace(row, reading=READING) if row.main and row.kind == COMPUTED else row for row in rows_of()]

    return rows


_PARTS: tuple[Part, ...] = (
    ("gains and poles", linear_rows),
    ("the disturbance observer", observer_rows),
    ("the drive in open loop and behind its observer", bench_rows),
    ("identification behind the observer", identified_rows),
    ("the circle, Fig 9", run_rows),
    ("beside reference 6", reference_6_rows),
    ("sensitivity, Figs 6 and 7", sensitivity_rows),
    ("Table III from Table II", calibration_rows),
    ("the swap", swap_rows),
)
PARTS: tuple[Part, ...] = tuple((name, _stated(rows_of)) for name, rows_of in _PARTS)
