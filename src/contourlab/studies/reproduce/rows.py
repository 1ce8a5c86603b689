"""Rows of a reproduction: what a paper prints, what we get, and whether the two agree."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import Any

__all__ = ["Row", "row"]


@dataclass(frozen=True, slots=True)
class Row:
    """One figure of a paper beside ours.

    Attributes
    ----------
    name, case : str
        What is compared, and for which axis or configuration.
    paper : float or None
        The printed figure; None where the paper gives none.
    here : float
        Ours, in the same unit.
    unit : str
    tolerance : float or None
        Largest difference that counts as agreement, in the same unit; None where nothing is claimed.
    agrees : bool or None
        Whether the difference is within the tolerance; None where there is nothing to compare.
    note : str
        Why it differs, or how it is read.
    """

    name: str
    case: str
    paper: float | None
    here: float
    unit: str
    tolerance: float | None
    agrees: bool | None
    note: str

    def as_dict(self) -> dict[str, Any]:
        """Return the row with the key ``pass`` in place of ``agrees``, fit for JSON."""
        found = asdict(self)
        found["pass"] = found.pop("agrees")
        found["here"] = found["here"] if math.isfinite(found["here"]) else None
        return {key: found[key] for key in ("name", "case", "paper", "here", "unit", "tolerance", "pass", "note")}

    @property
    def difference(self) -> float | None:
        """Ours minus the paper's."""
        return None if self.paper is None else self.here - self.paper


def row(name: str, case: str, paper: float | None, here: float, unit: str, tolerance: float | None = None, note: str = "") -> Row:
    """Return a row; it agrees where both figures and a tolerance are there and the difference is within it."""
    agrees = None if paper is None or tolerance is None else bool(abs(here - paper) <= tolerance)
    return Row(name, case, paper, float(here), unit, tolerance, agrees, note)
