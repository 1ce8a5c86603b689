"""Reproduction of Gecer Ulu, Ulu & Cakmakci, "Design and analysis of a modular learning based cross-coupled control algorithm for
multi-axis precision positioning systems"."""

from __future__ import annotations

from typing import Any

from contourlab.papers.gecer_ulu.axis import axis_rows
from contourlab.papers.gecer_ulu.learning import learning_rows
from contourlab.papers.gecer_ulu.pictures import convergence_rows
from contourlab.papers.gecer_ulu.tables import table_rows
from contourlab.papers.rows import Part, Stage, in_parts

PARTS: tuple[Part, ...] = (
    ("Tables 2 and 3", table_rows),
    ("one axis", axis_rows),
    ("convergence over trials, Figs 9 and 10", convergence_rows),
    ("learning and coupling", learning_rows),
)


def reproduce(stage: Stage | None = None) -> list[dict[str, Any]]:
    """Return every figure of the paper beside ours: rows with the keys of `contourlab.papers.rows.Row.as_dict`.

    Parameters
    ----------
    stage : callable, optional
        Told in words what is begun.
    """
    return list(in_parts(PARTS, stage))
