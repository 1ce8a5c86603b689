"""Rows of a reproduction: a figure from a paper or a log, our figure, and whether they agree."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import ClassVar

PRINTED, DERIVED, MEASURED, ASKED, OURS = "printed", "derived", "measured", "asked", "ours"
KINDS = {
    PRINTED: ("paper", "printed in the paper agree"),
    DERIVED: ("paper", "derived from its equations agree"),
    MEASURED: ("measured", "compared with a measurement agree"),
    ASKED: ("required", "required as a minimum are reached"),
}
"""Sources of the figure to compare with: head of its column, and words of the tally."""
AGREES, DIFFERS, FAILS = "agrees", "differs", "fails"
Part = tuple[str, Callable[[], Iterable["Row"]]]
"""Part of a reproduction: its name and the function that computes its rows."""


@dataclass(frozen=True, slots=True)
class Row:
    """Our figure and the figure to compare it with.

    Attributes
    ----------
    name, case : str
        What is compared, and for which axis or configuration.
    paper : float or None
        The figure to compare with, from `source`.
    here : float
        Our figure, in the same unit.
    unit : str
    tolerance : float or None
        Largest difference that counts as agreement, in the same unit; None if nothing is compared.
    note : str
        Explanation of the row; if the figures differ, the reason.
    source : str
        "printed" in the paper, "derived" from the paper's equations and numbers, "measured" in a log, "asked" as a required minimum, or
        "ours" (nothing to compare with).
    verdict : str
        "agrees"; "differs", with the reason in the note; "fails", without a reason; empty if nothing is compared.
    """

    json_derived: ClassVar = {"pass": "passed"}

    name: str
    case: str
    paper: float | None
    here: float
    unit: str
    tolerance: float | None
    note: str
    source: str
    verdict: str

    @property
    def passed(self) -> bool | None:
        """True for a row that agrees, false for one that fails, null if agreement is not claimed."""
        return {AGREES: True, FAILS: False}.get(self.verdict)


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
    source: str = PRINTED,
) -> Row:
    """Return a row that compares our figure with a figure printed in the paper.

    Parameters
    ----------
    name, case, paper, here, unit, tolerance, note, source
        See `Row`.
    reason : str
        Why the figures differ; without a reason, a difference is a failure.
    at_least : bool
        Whether the paper's figure is a lower limit.
    """
    within = abs(here - paper) <= tolerance and not (at_least and here < paper)
    verdict = AGREES if within else DIFFERS if reason else FAILS
    note = reason if verdict == DIFFERS else note
    return Row(name, case, float(paper), float(here), unit, float(tolerance), note, source, verdict)


def derived(name: str, case: str, paper: float, here: float, unit: str, tolerance: float, note: str = "", *, reason: str = "") -> Row:
    """Return a row that compares our figure with one from the paper's equations; arguments as in `printed`."""
    return printed(name, case, paper, here, unit, tolerance, note, reason=reason, source=DERIVED)


def measured(name: str, case: str, there: float, here: float, unit: str, tolerance: float | None, note: str = "") -> Row:
    """Return a row that compares our figure with a measured one; without a tolerance nothing is compared."""
    if tolerance is None:
        return Row(name, case, float(there), float(here), unit, None, note, MEASURED, "")
    return printed(name, case, there, here, unit, tolerance, note, source=MEASURED)


def asked(name: str, case: str, least: float, here: float, unit: str, most: float, note: str = "") -> Row:
    """Return a row whose figure must reach at least `least`; `most` is the largest possible value."""
    return printed(name, case, least, here, unit, most - least, note, at_least=True, source=ASKED)


def ours(name: str, case: str, here: float, unit: str, note: str = "") -> Row:
    """Return a row without a figure to compare with."""
    return Row(name, case, None, float(here), unit, None, note, OURS, "")


def tally(rows: Iterable[Row]) -> str:
    """Return a text on how many figures agree, by kind of source."""
    known = [(row.source, row.verdict) for row in rows]
    parts = []
    for source, (_, agreement) in KINDS.items():
        verdicts = [verdict for its, verdict in known if its == source and verdict]
        if not verdicts:
            continue
        counts = [f"{verdicts.count(AGREES)} of {len(verdicts)} figures {agreement}"]
        if DIFFERS in verdicts:
            counts.append(f"{verdicts.count(DIFFERS)} differ for the reason given")
        if FAILS in verdicts:
            counts.append(f"{verdicts.count(FAILS)} {'fail' if source in (PRINTED, DERIVED) else 'do not'}")
        parts.append(", ".join(counts))
    alone = f"{sum(source == OURS for source, _ in known)} have nothing to compare with."
    return f"{'; '.join(parts)}. {alone}" if parts else alone
