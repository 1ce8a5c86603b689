"""How far a run can be trusted, for the summary and the report: where its numbers are from, and the interval their deviations imply."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from contourlab.components.origin import Origin
from contourlab.features.run.compare import Outcome
from contourlab.features.run.interval import Interval, Spread
from contourlab.features.run.provenance import Number, numbers_of
from contourlab.report.run_data import Contribution, IntervalFigures, StatedNumber, Trust
from contourlab.units import from_si

MOST_ITEMS = 4
"""Items of a list that are printed."""


def told_of(outcome: Outcome) -> dict[str, Any]:
    """Return provenance and interval of an outcome for the summary, in SI."""
    numbers = numbers_of(outcome.case.machine, outcome.case.controller)
    return {
        "provenance": stated_of(numbers),
        "not_stated": [number.name for number in numbers if number.origin is None],
        "interval": None if outcome.interval is None else _interval(outcome.interval),
    }


def stated_of(numbers: Sequence[Number]) -> list[dict[str, Any]]:
    """Return those numbers of which something is stated, in SI."""
    return [_plain(number, number.origin) for number in numbers if number.origin is not None]


def _plain(number: Number, origin: Origin) -> dict[str, Any]:
    told = asdict(origin)
    span = told.pop("span")
    value = list(number.value) if isinstance(number.value, tuple) else number.value
    return {
        "name": number.name,
        "value": value,
        "unit": number.unit,
        "source": told["source"],
        "deviation": told["deviation"],
        "range": None if span is None else list(span),
        "from": told["reference"],
        "note": told["note"],
        "drawn": number.drawn and origin.uncertain,
    }


def _interval(found: Interval) -> dict[str, Any]:
    def spread(one: Spread | None) -> dict[str, float] | None:
        return None if one is None else asdict(one)

    return {
        "reason": found.reason,
        "samples": found.n,
        "rms": spread(found.rms),
        "max": spread(found.max),
        "failed": found.failed,
        "beyond_tolerance": found.beyond,
        "main": found.main,
        "ranks": [{"name": name, "rms": rms, "max": largest} for name, (rms, largest) in found.ranks.items()],
    }


def trust_of(outcome: Outcome) -> Trust | None:
    """Return the same in print form for the report; None where it was not asked for."""
    found = outcome.interval
    if found is None:
        return None
    numbers = numbers_of(outcome.case.machine, outcome.case.controller)
    stated = [printed(number) for number in numbers if number.origin is not None]
    silent = [number.name for number in numbers if number.origin is None]
    return Trust(stated, silent, _figures(found), found.reason)


def _figures(found: Interval) -> IntervalFigures | None:
    if found.rms is None or found.max is None:
        return None
    rms, largest = ((one.median, one.low, one.high) for one in (found.rms, found.max))
    parts = [Contribution(name, *pair) for name, pair in found.ranks.items()]
    return IntervalFigures(rms, largest, found.n, found.failed, found.beyond, parts, found.noticeable)


def printed(number: Number) -> StatedNumber:
    """Return a number in the unit that people use, with where it is from."""
    display, value, origin = number.display, number.value, number.origin

    def shown(value: float, digits: int = 6) -> str:
        return f"{from_si(value, display):.{digits}g}"

    text = shown(value) if not isinstance(value, tuple) else ", ".join(shown(item) for item in value[:MOST_ITEMS])
    if isinstance(value, tuple) and len(value) > MOST_ITEMS:
        text += f", ... ({len(value)})"
    deviation = ""
    if origin is not None and origin.deviation is not None:
        share = f" ({100.0 * origin.deviation / abs(value):.2g} %)" if isinstance(value, float) and value else ""
        deviation = f"± {shown(origin.deviation, 3)}{share}"
    elif origin is not None and origin.span is not None:
        deviation = f"{shown(origin.span[0])} to {shown(origin.span[1])}"
    reference, note = ("", "") if origin is None else (origin.reference, origin.note)
    return StatedNumber(number.name, text, display, number.source, deviation, reference, note)
