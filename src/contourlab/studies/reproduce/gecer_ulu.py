"""Reproduction of Gecer Ulu, Ulu & Cakmakci, "Design and analysis of a modular learning based cross-coupled control algorithm for
multi-axis precision positioning systems"."""

from __future__ import annotations

from typing import Any

from contourlab.studies.reproduce.gecer_ulu_axis import axis_rows
from contourlab.studies.reproduce.gecer_ulu_learning import learning_rows
from contourlab.studies.reproduce.gecer_ulu_pictures import convergence_rows
from contourlab.studies.reproduce.gecer_ulu_tables import table_rows

__all__ = ["reproduce"]


def reproduce() -> list[dict[str, Any]]:
    """Return every figure of the paper beside ours: rows with the keys of `contourlab.studies.reproduce.rows.Row.as_dict`."""
    return [found.as_dict() for found in (*table_rows(), *axis_rows(), *convergence_rows(), *learning_rows())]
