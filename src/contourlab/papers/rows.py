"""Rows of a reproduction: what a paper or a log gives, what we get, and whether the two agree."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass
from typing import Any

PRINTED, DERIVED, MEASURED, ASKED, OURS = "printed", "derived", "measured", "asked", "ours"
KINDS = {
    PRINTED: ("paper", "printed in the paper agree"),
    DERIVED: ("paper", "derived from its equations agree"),
    MEASURED: ("measured", "beside measured ones agree"),
    ASKED: ("asked for", "that are asked for are reached"),
}
"""Sources of a figure that ours is held against: what it is called above its column, and in the tally."""
AGREES, DIFFERS, FAILS = "agrees", "differs", "fails"
Stage = Callable[[str], object]
"""Told in words what a reproduction is busy with."""
Part = tuple[str, Callable[[], Iterable["Row"]]]
"""A part of a reproduction: what it is busy with, and its rows."""


@dataclass(frozen=True, slots=True)
class Row:
    """A figure from elsewhere beside ours.

    Attributes
    ----------
    name, case : str
        What is compared, and for which axis or configuration.
    paper : float or None
        The figure that ours is held against: the paper's, or as `source` says; None where there is none.
    here : float
        Ours, in the same unit.
    unit : str
    tolerance : float or None
        Largest difference that counts as agreement, in the same unit; None where there is nothing to compare.
    note : str
        How it is read; where it differs, why.
    source : str
        "printed" where the paper's figure stands in the paper; "derived" where it follows from the paper's equations and numbers;
        "measured" where it is of a log; "asked" where it is the least that has to be reached; "ours" where there is none.
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


def measured(
    name: str, case: str, there: float, here: float, unit: str, tolerance: float | None, note: str = "", *, reason: str = ""
) -> Row:
    """Return a row whose figure was measured; without a tolerance the two stand side by side only. Arguments as of `printed`."""
    if tolerance is None:
        return Row(name, case, float(there), float(here), unit, None, note, MEASURED, "")
    return _compared(MEASURED, name, case, there, here, unit, tolerance, note, reason, False)


def asked(name: str, case: str, least: float, here: float, unit: str, most: float, note: str = "") -> Row:
    """Return a row whose figure is the least that has to be reached; `most` is the largest that there can be."""
    return _compared(ASKED, name, case, least, here, unit, most - least, note, "", True)


def ours(name: str, case: str, here: float, unit: str, note: str = "") -> Row:
    """Return a row for which there is no figure elsewhere."""
    return Row(name, case, None, float(here), unit, None, note, OURS, "")


def _compared(
    source: str, name: str, case: str, paper: float, here: float, unit: str, tolerance: float, note: str, reason: str, at_least: bool
) -> Row:
    within = abs(here - paper) <= tolerance and not (at_least and here < paper)
    verdict = AGREES if within else DIFFERS if reason else FAILS
    told = reason if verdict == DIFFERS else note
    return Row(name, case, float(paper), float(here), unit, float(tolerance), told, source, verdict)


def tally(rows: Iterable[Mapping[str, Any]]) -> str:
    """Return in words how many figures agree, one kind of source after another; kinds that there are none of are left out."""
    known = [(row["source"], row["verdict"]) for row in rows]
    parts = []
    for source, (_, words) in KINDS.items():
        verdicts = [verdict for its, verdict in known if its == source and verdict]
        if not verdicts:
            continue
        said = [f"{verdicts.count(AGREES)} of {len(verdicts)} figures {words}"]
        if DIFFERS in verdicts:
            said.append(f"{verdicts.count(DIFFERS)} differ for the reason beside them")
        if FAILS in verdicts:
            said.append(f"{verdicts.count(FAILS)} fail without one" if source in (PRINTED, DERIVED) else f"{verdicts.count(FAILS)} do not")
        parts.append(", ".join(said))
    alone = f"{sum(source == OURS for source, _ in known)} are ours alone."
    return f"{'; '.join(parts)}. {alone}" if parts else alone


def in_parts(parts: Iterable[Part], stage: Stage | None = None) -> Iterator[dict[str, Any]]:
    """Yield the rows of all parts fit for JSON; `stage` is told what each is busy with."""
    for words, rows_of in parts:
        if stage is not None:
            stage(words)
        for row in rows_of():
            yield row.as_dict()
