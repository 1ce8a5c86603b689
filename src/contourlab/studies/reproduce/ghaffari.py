"""Reproduction of Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring"."""

from __future__ import annotations

from typing import Any

from contourlab.studies.reproduce.ghaffari_linear import linear_rows
from contourlab.studies.reproduce.ghaffari_runs import run_rows

__all__ = ["reproduce"]


def reproduce() -> list[dict[str, Any]]:
    """Return every figure of the paper beside ours: rows of name, case, paper, here, unit, tolerance, pass, note."""
    return [found.as_dict() for found in (*linear_rows(), *run_rows())]
