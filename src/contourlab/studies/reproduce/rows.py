"""Rows of a reproduction: what a paper gives, what we get, and whether the two agree."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from typing import Any

__all__ = ["Row", "derived", "ours", "printed", "tally"]

PRINTED, DERIVED, OURS = "printed", "derived", "ours"
AGREES, DIFFERS, FAILS = "agrees", "differs", "fails"


@dataclass(frozen=True, slots=True)
class Row:
    """One figure of a paper beside ours.

    Attributes
    ----------
    name, case : str
        What is compared, and for which axis or configuration.
    paper : float or None
        The paper's figure; None where it gives none.
    here : float
        Ours, in the same unit.
    unit : str
    tolerance : float or None
        Largest difference that counts as agreement, in the same unit; None where there is nothing to compare.
    note : str
        How it is read; where it differs, why.
    source : str
        "printed" where the paper's figure stands in the paper; "derived" where it follows from the paper's equations and numbers; "ours"
        where the paper has none.
    verdict : str
        "agrees"; "differs" where it does not and the note says why; "fails" where it does not and nothing explains it; empty where there
        is nothing to compare.
    """

    name: str
    case: str
    paper: float | None
    here: float
    unit: str
    tolerance: float | None
    note: str
    source: str
    verdict: str

    def as_dict(self) -> dict[str, Any]:
        """Return the row fit for JSON, with the key ``pass``: true, false for a row that fails, null where agreement is not claimed."""
        found = asdict(self)
        found["pass"] = {AGREES: True, FAILS: False}.get(self.verdict)
        found["here"] = self.here if math.isfinite(self.here) else None
        order = ("name", "case", "paper", "here", "unit", "tolerance", "pass", "note", "source", "verdict")
        return {key: found[key] for key in order}


def printed(
    name: str,
    case: str,
    paper: float,
    here: float,
    unit: str,
    tolerance: float,
    note: str = "",
    *,
    reason: str = "",
    at_least: bool = False,
) -> Row:
    """Return a row whose figure stands in the paper.

    Parameters
    ----------
    name, case, paper, here, unit, tolerance, note
        As of `Row`.
    reason : str
        Why it differs, if it does; without one a difference is a failure.
    at_least : bool
        The paper's figure is a lower limit.
    """
    return _compared(PRINTED, name, case, paper, here, unit, tolerance, note, reason, at_least)


def derived(name: str, case: str, paper: float, here: float, unit: str, tolerance: float, note: str = "", *, reason: str = "") -> Row:
    """Return a row whose figure follows from the paper's equations; arguments as of `printed`."""
    return _compared(DERIVED, name, case, paper, here, unit, tolerance, note, reason, False)


def ours(name: str, case: str, here: float, unit: str, note: str = "") -> Row:
    """Return a row for which the paper has no figure."""
    return Row(name, case, None, float(here), unit, None, note, OURS, "")


def _compared(
    source: str, name: str, case: str, paper: float, here: float, unit: str, tolerance: float, note: str, reason: str, at_least: bool
) -> Row:
    within = abs(here - paper) <= tolerance and not (at_least and here < paper)
    verdict = AGREES if within else DIFFERS if reason else FAILS
    told = reason if verdict == DIFFERS else note
    return Row(name, case, float(paper), float(here), unit, float(tolerance), told, source, verdict)


def tally(rows: Iterable[Mapping[str, Any]]) -> str:
    """Return in words how many figures agree, those of the paper and those worked out from it told apart."""
    known = [(row["source"], row["verdict"]) for row in rows]
    parts = []
    for source, words in ((PRINTED, "printed in the paper"), (DERIVED, "derived from its equations")):
        verdicts = [verdict for its, verdict in known if its == source]
        said = [f"{verdicts.count(AGREES)} of {len(verdicts)} figures {words} agree"]
        if DIFFERS in verdicts:
            said.append(f"{verdicts.count(DIFFERS)} differ for the reason beside them")
        if FAILS in verdicts:
            said.append(f"{verdicts.count(FAILS)} fail without one")
        parts.append(", ".join(said))
    return "; ".join(parts) + f". {sum(source == OURS for source, _ in known)} are ours alone."
