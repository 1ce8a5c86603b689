"""Rows of a reproduction: a figure from a paper or a log, our figure, and the band in which ours has to stay."""

from __future__ import annotations

import csv
import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from importlib.resources import files
from typing import ClassVar

PRINTED, MEASURED, ASKED, OURS = "printed", "measured", "asked", "ours"
HEADS = {PRINTED: "paper", MEASURED: "measured", ASKED: "required"}
"""Sources of the figure to compare with, and the heads of its column."""
COMPUTED, DERIVED, INPUT, IDENTITY = "computed", "derived", "input", "identity"
LEAST, MOST = "least", "most"
AGREES, DIFFERS, OUTSIDE = "agrees", "differs", "outside its band"
CLOSE = (0.02, 0.05, 0.2)
"""Relative differences by which computed figures are counted."""
Band = tuple[float, float]
Bands = dict[tuple[str, str], Band]
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
    tolerance : float or None
        Largest difference that counts as agreement, in the same unit; None if nothing is compared.
    note : str
        Explanation of the row; if the figures differ, the reason.
    source : str
        "printed" in the paper, "measured" in a log, "asked" as a required minimum, or "ours" (nothing to compare with).
    kind : str
        "computed" by our model; "derived" from the paper's equations and numbers; "input", a figure that the model was given or fitted to;
        "identity", true whatever the model. Only computed figures are evidence.
    reading : str
        What the row assumes where the paper is open.
    main : bool
        Whether this is the stated reading, not one of the others.
    limit : str
        "least" or "most" if the figure to compare with is a limit, else empty.
    band : (float, float) or None
        Where our figure has to stay, in the same unit, whether it agrees or not.
    missing : str
        Why there is no figure: the package that it needs, and how to install it. Such a row has no verdict.
    """

    json_derived: ClassVar = {"pass": "passed", "verdict": "verdict"}

    name: str
    case: str
    paper: float | None
    here: float
    unit: str
    tolerance: float | None
    note: str
    source: str
    kind: str = COMPUTED
    reading: str = ""
    main: bool = True
    limit: str = ""
    band: Band | None = None
    missing: str = ""

    @property
    def verdict(self) -> str:
        """Whether the row "agrees", "differs" or is "outside its band"; empty if it is inside and nothing is compared."""
        if self.missing:
            return ""
        if self.band is not None and not _inside(self.here, self.band):
            return OUTSIDE
        if self.tolerance is None:
            return ""
        return AGREES if self.agrees else DIFFERS

    @property
    def agrees(self) -> bool:
        """Whether the figures differ by at most the tolerance."""
        if self.paper is None or self.tolerance is None or (self.limit and not self._keeps_limit):
            return False
        return abs(self.here - self.paper) <= self.tolerance

    @property
    def _keeps_limit(self) -> bool:
        return self.paper is not None and {LEAST: self.here >= self.paper, MOST: self.here <= self.paper}.get(self.limit, False)

    @property
    def off(self) -> float:
        """Our figure over the other one, minus 1; nan without one. 0 for a limit that is kept, and for agreement with a zero."""
        if self.paper is None:
            return math.nan
        if self._keeps_limit or (self.paper == 0.0 and self.agrees):
            return 0.0
        return self.here / self.paper - 1.0 if self.paper else math.inf

    @property
    def passed(self) -> bool | None:
        """True for a row that agrees, false for one outside its band, null if agreement is not claimed."""
        return {AGREES: True, OUTSIDE: False}.get(self.verdict)


def _inside(value: float, band: Band) -> bool:
    """Tell whether a value is in a band; that of a figure that does not exist, or grows without bound, is nan to nan."""
    return band[0] <= value <= band[1] or not (math.isfinite(value) or math.isfinite(band[0]))


def printed(
    name: str,
    case: str,
    paper: float,
    here: float,
    unit: str,
    tolerance: float | None,
    note: str = "",
    *,
    reason: str = "",
    at_least: bool = False,
    at_most: bool = False,
    source: str = PRINTED,
    kind: str = COMPUTED,
    reading: str = "",
    main: bool = True,
) -> Row:
    """Return a row that compares our figure with a figure printed in the paper.

    Parameters
    ----------
    name, case, paper, here, unit, tolerance, note, source, kind, reading, main
        See `Row`.
    reason : str
        Why the figures differ; replaces the note if they do.
    at_least, at_most : bool
        Whether `paper` is a limit.
    """
    width, limit = None if tolerance is None else float(tolerance), LEAST if at_least else MOST if at_most else ""
    row = Row(name, case, float(paper), float(here), unit, width, note, source, kind, reading, main, limit)
    return replace(row, note=reason) if reason and width is not None and not row.agrees else row


def derived(name: str, case: str, paper: float, here: float, unit: str, tolerance: float, note: str = "", *, reason: str = "") -> Row:
    """Return a row that compares our figure with one from the paper's equations and numbers; arguments as in `printed`."""
    return printed(name, case, paper, here, unit, tolerance, note, reason=reason, kind=DERIVED)


def identity(name: str, case: str, paper: float, here: float, unit: str, tolerance: float, note: str = "") -> Row:
    """Return a row that checks our code against an equation of the paper; arguments as in `printed`."""
    return printed(name, case, paper, here, unit, tolerance, note, kind=IDENTITY)


def measured(
    name: str, case: str, there: float, here: float, unit: str, tolerance: float | None, note: str = "", *, kind: str = COMPUTED
) -> Row:
    """Return a row that compares our figure with a measured one; without a tolerance nothing is compared."""
    return printed(name, case, there, here, unit, tolerance, note, source=MEASURED, kind=kind)


def asked(name: str, case: str, least: float, here: float, unit: str, most: float, note: str = "", *, kind: str = COMPUTED) -> Row:
    """Return a row whose figure must reach at least `least`; `most` is the largest possible value."""
    return printed(name, case, least, here, unit, most - least, note, at_least=True, source=ASKED, kind=kind)


def ours(name: str, case: str, here: float, unit: str, note: str = "", *, reading: str = "", main: bool = True, missing: str = "") -> Row:
    """Return a row without a figure to compare with; arguments as in `Row`."""
    return Row(name, case, None, float(here), unit, None, note, OURS, COMPUTED, reading, main, missing=missing)


def banded(rows: Iterable[Row], bands: Bands) -> list[Row]:
    """Return the rows with their bands; a row that has none, as of a log that is not always there, has to agree."""
    return [replace(row, band=bands.get((row.name, row.case), _agreement(row))) for row in rows]


def _agreement(row: Row) -> Band | None:
    if row.paper is None or row.tolerance is None:
        return None
    return row.paper - row.tolerance * (row.limit != LEAST), row.paper + row.tolerance * (row.limit != MOST)


def read_bands(paper: str) -> Bands:
    """Return the bands of a paper's rows by name and case, from ``bands.csv`` in its folder; ``tools/bands.py`` writes it."""
    text = (files("contourlab.papers") / paper / "bands.csv").read_text(encoding="utf-8")
    return {(line["name"], line["case"]): (float(line["low"]), float(line["high"])) for line in csv.DictReader(text.splitlines())}
