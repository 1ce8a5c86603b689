"""How far to trust the figures: where the numbers are from, and the interval of contour error that their deviations imply."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from contourlab.figures import NONE, number
from contourlab.report.data import ReportData


@dataclass(frozen=True)
class StatedNumber:
    """A number in print: its name, value, unit and source; deviation or range, log or table, and note, empty where not stated."""

    name: str
    value: str
    unit: str
    source: str
    deviation: str = ""
    reference: str = ""
    note: str = ""


@dataclass(frozen=True)
class Contribution:
    """A number that was drawn, and its rank correlation with rms and maximum of the contour error."""

    name: str
    rms: float
    max: float


@dataclass(frozen=True)
class IntervalFigures:
    """Median, 5 % and 95 % of a contour error [m] over the samples, and the figure of the run itself.

    Parameters
    ----------
    rms, max : (float, float, float) [m]
        Median, low, high; infinite where too many samples failed.
    n, failed : int
    beyond : int or None
        Samples beyond the tolerance.
    contributions : sequence of Contribution
        The strongest first.
    noticeable : float
        Size of a rank correlation that is more than chance.
    """

    rms: tuple[float, float, float]
    max: tuple[float, float, float]
    n: int
    failed: int
    beyond: int | None
    contributions: Sequence[Contribution]
    noticeable: float

    @property
    def main(self) -> str:
        """The number that contributes most; empty where none stands out."""
        first = self.contributions[0] if self.contributions else None
        return first.name if first is not None and max(abs(first.rms), abs(first.max)) >= self.noticeable else ""


@dataclass(frozen=True)
class Trust:
    """Of one scheme: its numbers, the names of those of which nothing is stated, and the interval, or why there is none."""

    numbers: Sequence[StatedNumber]
    not_stated: Sequence[str]
    interval: IntervalFigures | None
    reason: str = ""


@dataclass(frozen=True)
class OriginTable:
    """Numbers of one scheme: all of them for the first, those that differ from the first for the others."""

    title: str
    rows: tuple[StatedNumber, ...]
    not_stated: tuple[str, ...]


def origin_tables(data: ReportData) -> tuple[OriginTable, ...]:
    """Return where the numbers are from, for the page; empty where nothing is known of it."""
    found: list[OriginTable] = []
    seen: set[StatedNumber] = set()
    blank: set[str] = set()
    for scheme in data.schemes:
        if scheme.trust is None:
            continue
        rows = tuple(one for one in scheme.trust.numbers if one not in seen)
        shown = tuple(replace(one, unit=_signs(one.unit)) for one in rows)
        names = tuple(name for name in scheme.trust.not_stated if name not in blank)
        seen |= set(rows)
        blank |= set(names)
        if rows or names:
            title = "Stated numbers" if not found else f"{scheme.name}: what differs from the schemes before"
            found.append(OriginTable(title, shown, names))
    return tuple(found)


def _signs(unit: str) -> str:
    """Return a unit in print."""
    for plain, sign in (("*", "·"), ("^2", "²"), ("^3", "³")):
        unit = unit.replace(plain, sign)
    return "µm" if unit == "um" else unit


def interval_rows(data: ReportData) -> tuple[tuple[str, ...], ...]:
    """Return for each scheme with an interval: name, then run, median and interval of rms and maximum [um], failed, beyond, main."""
    rows = []
    for scheme in data.schemes:
        if scheme.trust is None or scheme.trust.interval is None:
            continue
        found, error = scheme.trust.interval, scheme.metrics.contour_error
        cells = [cell for value, spread in ((error.rms, found.rms), (error.max, found.max)) for cell in (_um(value), *_cells(spread))]
        beyond = NONE if found.beyond is None else f"{found.beyond} of {found.n}"
        rows.append((scheme.name, *cells, f"{found.failed} of {found.n}", beyond, found.main or "none stands out"))
    return tuple(rows)


def _um(value: float) -> str:
    return number(value * 1e6)


def _cells(spread: tuple[float, float, float]) -> tuple[str, str]:
    return _um(spread[0]), f"{_um(spread[1])} to {_um(spread[2])}"


def trust_lines(data: ReportData) -> list[str]:
    """Return in words what the deviations make of each scheme's contour error; once where the same reason holds for all."""
    told = [(scheme.name, scheme.trust) for scheme in data.schemes if scheme.trust is not None]
    reasons = {trust.reason for _, trust in told}
    if len(reasons) == 1 and "" not in reasons:
        return [f"interval of the contour error {reasons.pop()}"]
    return [f"{name}: {_in_words(trust)}" for name, trust in told]


def _in_words(trust: Trust) -> str:
    found = trust.interval
    if found is None:
        return f"interval of the contour error {trust.reason}"
    rms, largest = (f"{_plain(s[1])} to {_plain(s[2])} um (median {_plain(s[0])})" for s in (found.rms, found.max))
    words = f"by the stated deviations the contour error is {rms} rms, {largest} at most, in 90 of 100 machines"
    if found.failed:
        words += f"; {found.failed} of {found.n} samples fail"
    if found.beyond is not None:
        words += f"; {found.beyond} of {found.n} beyond the tolerance"
    return words + (f"; most comes from {found.main}" if found.main else "; no single number stands out")


def _plain(value: float) -> str:
    return "any" if math.isinf(value) else number(value * 1e6)
