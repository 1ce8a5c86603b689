"""Reproduction of Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring"."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from contourlab.studies.reproduce.ghaffari_bench import bench_rows
from contourlab.studies.reproduce.ghaffari_calibration import calibration_rows
from contourlab.studies.reproduce.ghaffari_identified import identified_rows
from contourlab.studies.reproduce.ghaffari_linear import linear_rows
from contourlab.studies.reproduce.ghaffari_observer import observer_rows
from contourlab.studies.reproduce.ghaffari_runs import run_rows
from contourlab.studies.reproduce.ghaffari_sensitivity import sensitivity_rows
from contourlab.studies.reproduce.ghaffari_swap import swap_rows
from contourlab.studies.reproduce.rows import Row

__all__ = ["reproduce"]

PARTS: tuple[Callable[[], list[Row]], ...] = (
    linear_rows,
    observer_rows,
    bench_rows,
    identified_rows,
    run_rows,
    sensitivity_rows,
    calibration_rows,
    swap_rows,
)


def reproduce() -> list[dict[str, Any]]:
    """Return every figure of the paper beside ours: rows with the keys of `contourlab.studies.reproduce.rows.Row.as_dict`."""
    return [row.as_dict() for part in PARTS for row in part()]
