"""What ``contourlab tune`` says: the way it took, figures and margins before and after, gains in the file's units and in drive terms."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from contourlab.analysis.linear.margins import Margins
from contourlab.features.run.margin_words import NOTHING, decibel, degrees
from contourlab.features.tune import FIGURES, Step, Tuned, TuneSettings
from contourlab.features.tune.drive_terms import DriveTerms
from contourlab.units import from_si

if TYPE_CHECKING:
    from contourlab.scenario import Case

SHOWN = {
    "contour_error_integral": ("integral of contour error", "um s", 1e6),
    "contour_error_rms": ("contour error, rms", "um", 1e6),
    "contour_error_max": ("contour error, largest", "um", 1e6),
    "contour_error_signed_mean": ("contour error, signed mean", "um", 1e6),
    "part_error_max": ("part error, largest", "um", 1e6),
    "tracking_error_rms": ("tracking error, rms", "um", 1e6),
    "command_energy": ("energy of the commands", "s", 1.0),
    "command_largest": ("largest command", "% of drive", 100.0),
    "limited_share": ("time at a limit of a drive", "%", 100.0),
}
NAMED = {
    "contour_error_integral": "integral of the contour error",
    "contour_error_rms": "rms of the contour error",
    "contour_error_max": "largest contour error",
    "tracking_error_rms": "rms of the tracking error",
    "command_energy": "energy of the commands",
}
"""What may be asked for, in a sentence."""


def text_of(name: str, case: Case, settings: TuneSettings, found: Tuned) -> str:
    """Return the text of a calibration."""
    lines = [f"{name}, {case.name}", f"objective: {settings.goal.words}; bounds: {settings.bounds.words}", ""]
    if found.steps:
        lines += [*_path(settings, found.steps), ""]
    if found.searched is not None:
        lines += [*_searched(settings, found), ""]
    lines += [*_figures(found), "", *_margins(found), "", *_gains(found), "", *_drives(found.terms), ""]
    lines += [f"note: {note}" for note in found.notes]
    lines.append(_verdict(case, settings, found))
    return "\n".join(lines)


def _table(rows: Sequence[Sequence[str]], left: int = 1) -> list[str]:
    """Return rows in columns, the first `left` of them and the last to the left."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    last = len(widths) - 1
    return [
        "  ".join(c.ljust(w) if i < left or i == last else c.rjust(w) for i, (c, w) in enumerate(zip(row, widths, strict=True))).rstrip()
        for row in rows
    ]


def _objective(settings: TuneSettings, value: float) -> str:
    single = settings.goal.single
    return _number(value * (from_si(1.0, FIGURES[single][2]) / from_si(1.0, FIGURES[single][1]) if single else 1.0))


def _number(value: float, digits: int = 4) -> str:
    return f"{value:.{digits}g}" if math.isfinite(value) else NOTHING


def _path(settings: TuneSettings, steps: Iterable[Step]) -> list[str]:
    single = settings.goal.single
    unit = FIGURES[single][2] if single else "sum"
    rows: list[tuple[str, ...]] = [("step", "number", "from", "to", "unit", f"before [{unit}]", "after", "what bounds it")]
    for step in steps:
        number = step.number
        shown = [_number(number.display_value(value), 5) for value in (step.before, step.after)]
        told = [_objective(settings, value) for value in (step.objective_before, step.objective_after)]
        rows.append((step.stage, number.short, *shown, number.display_unit, *told, step.bound))
    return _table(rows, 2)


def _searched(settings: TuneSettings, found: Tuned) -> list[str]:
    assert found.searched is not None
    search = found.searched.found
    each = ", ".join(_objective(settings, value) for value in search.per_start)
    best = _objective(settings, found.searched.value)
    return [f"all numbers at once: {best} after {search.runs} runs; the starts came to {each}; taken: {found.method}"]


def _figures(found: Tuned) -> list[str]:
    rows: list[tuple[str, ...]] = [("figure", "before", "after", "", "unit")]
    for key, (words, unit, factor) in SHOWN.items():
        before, after = found.before.figures[key], found.after.figures[key]
        rows.append((words, _number(factor * before), _number(factor * after), _ratio(before, after), unit))
    return _table(rows)


def _ratio(before: float, after: float) -> str:
    """Return how a figure became smaller or larger; nothing where it has no sign to keep."""
    if not (before * after > 0.0 and math.isfinite(before) and math.isfinite(after)):
        return ""
    return f"/ {before / after:.3g}" if abs(after) <= abs(before) else f"x {after / before:.3g}"


def _margins(found: Tuned) -> list[str]:
    rows: list[tuple[str, ...]] = [("margins", "gain before", "after", "phase before", "after", "modulus before", "after", "")]
    for axis, after in found.after.margins.items():
        both = (found.before.margins.get(axis), after)
        columns = [[decibel(one), degrees(one), _modulus(one)] for one in both]
        rows.append((f"axis {axis}", *(cell for pair in zip(*columns, strict=True) for cell in pair), ""))
    return _table(rows)


def _modulus(margins: Margins | None) -> str:
    return NOTHING if margins is None or not margins.stable else f"{margins.modulus:.3g}"


def _gains(found: Tuned) -> list[str]:
    rows: list[tuple[str, ...]] = [("number", "start", "in the end", "unit")]
    for number in found.space.numbers:
        shown = [_number(number.display_value(value), 6) for value in (number.value, found.values[number.name])]
        rows.append((number.short, *shown, number.display_unit))
    return _table(rows)


def _drives(terms: Iterable[DriveTerms]) -> list[str]:
    lines = []
    for one in terms:
        kv = f"Kv {one.kv:.4g} 1/s, {0.06 * one.kv:.4g} (m/min)/mm" if math.isfinite(one.kv) else "Kv unknown"
        loop = f"; velocity loop {one.velocity_bandwidth:.4g} Hz" if math.isfinite(one.velocity_bandwidth) else ""
        lines.append(f"axis {one.axis}: {kv}{loop}")
        if one.linuxcnc is None:
            lines.append("    LinuxCNC: its pid has no likeness of this controller")
            continue
        gains = ", ".join(f"{name} {value:.6g}" for name, value in one.linuxcnc.per_millimetre().items() if value or name == "FF0")
        lines.append(f"    LinuxCNC, machine units mm, output in {one.command_unit}: {gains}")
        if math.isfinite(one.difference):
            apart = f"{100.0 * one.difference_rms:.2g} % of the largest command, rms, at most {100.0 * one.difference:.2g} %"
            lines.append(f"    its law on this run differs from ours by {apart}")
        lines += [f"    {note}" for note in one.linuxcnc.notes]
    return lines


def _gained(settings: TuneSettings, found: Tuned) -> str:
    """Say what became of the integral, behind what was asked for where that is another figure."""
    asked = FIGURES[settings.goal.single][0] if settings.goal.single else "contour_error_integral"
    told = []
    for key in dict.fromkeys((asked, "contour_error_integral")):
        _, unit, factor = SHOWN[key]
        before, after = found.before.figures[key], found.after.figures[key]
        told.append(f"the {NAMED[key]} is {_times(before, after, f'{_number(factor * after)} {unit}')}")
    return ", ".join(told)


def _times(before: float, after: float, shown: str) -> str:
    if not (math.isfinite(before) and math.isfinite(after)):
        return f"{shown}, where the run did not come to its end before" if math.isfinite(after) else NOTHING
    if f"{before:.4g}" == f"{after:.4g}":
        return "what it was"
    return f"{before / after:.4g} times smaller" if after < before else f"{after / before:.4g} times larger"


def _verdict(case: Case, settings: TuneSettings, found: Tuned) -> str:
    if found.after.broken:
        return f"bounds are not kept: {'; '.join(found.after.broken)}"
    gained = f"{_gained(settings, found)}, after {found.runs} runs"
    if case.tolerance is None:
        return f"done: {gained}"
    largest, allowed = (1e6 * value for value in (found.after.figures["part_error_max"], case.tolerance))
    word = "PASS" if largest <= allowed else "FAIL"
    return f"{word}: {gained}; largest part error {largest:.3g} um against {allowed:.3g} um"


def summary_of(name: str, case: Case, settings: TuneSettings, found: Tuned, passed: bool) -> dict[str, Any]:
    """Return the summary of a calibration: plain values, SI where no unit is named."""
    search = None if found.searched is None else found.searched
    return {
        "name": name,
        "scheme": case.name,
        "passed": passed,
        "objective": dict(settings.goal.weights),
        "bounds": asdict(settings.bounds),
        "method": found.method,
        "start": settings.start,
        "runs": found.runs,
        "calibration_gain": found.gain,
        "tolerance": case.tolerance,
        "broken": list(found.after.broken),
        "before": _state(found.before.figures, found.before.margins),
        "after": _state(found.after.figures, found.after.margins),
        "parameters": {
            number.name: {
                "start": number.value,
                "after": found.values[number.name],
                "low": number.low,
                "high": number.high,
                "unit": number.unit,
                "end": number.end(found.values[number.name]),
            }
            for number in found.space.numbers
        },
        "path": [_step(step) for step in found.steps],
        "global": None
        if search is None
        else {
            "objective": search.value,
            "per_start": search.found.per_start,
            "spread": search.found.spread,
            "runs": search.found.runs,
            "parameters": search.values,
        },
        "drive_terms": {one.axis: _terms(one) for one in found.terms},
        "notes": list(found.notes),
    }


def _state(figures: dict[str, float], margins: dict[str, Margins]) -> dict[str, Any]:
    return {"figures": dict(figures), "margins": {axis: asdict(one) for axis, one in margins.items()}}


def _step(step: Step) -> dict[str, Any]:
    found = {"stage": step.stage, "parameter": step.number.name, "before": step.before, "after": step.after, "unit": step.number.unit}
    return found | {"objective_before": step.objective_before, "objective_after": step.objective_after, "bound": step.bound}


def _terms(one: DriveTerms) -> dict[str, Any]:
    gains = None if one.linuxcnc is None else one.linuxcnc.per_millimetre()
    return {
        "kv_per_second": one.kv,
        "kv_m_per_min_per_mm": 0.06 * one.kv,
        "velocity_bandwidth_hz": one.velocity_bandwidth,
        "command_unit": one.command_unit,
        "linuxcnc": gains,
        "linuxcnc_notes": [] if one.linuxcnc is None else list(one.linuxcnc.notes),
        "linuxcnc_difference": one.difference,
        "linuxcnc_difference_rms": one.difference_rms,
    }
