"""What ``contourlab swap`` prints, its summary, and its picture's cells."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from textwrap import wrap
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.features.run.margin_words import decibel, degrees
from contourlab.features.swap.coverage import Coverage
from contourlab.features.swap.design import Choice
from contourlab.features.swap.fleet import OBJECTIVES
from contourlab.features.swap.linear import LinearSwap
from contourlab.features.swap.loss import losses
from contourlab.features.swap.network import NetworkCost
from contourlab.features.swap.picture import LossMatrix
from contourlab.features.swap.report import UNITS, WORDS, SwapReport
from contourlab.features.swap.study import SwapStudy
from contourlab.features.swap.verdict import at_least, on_bounds, search_words

Array = NDArray[np.float64]
_MICRO = 1e6
ROW_WIDTH = 44
"""Characters of a line beside a row of the picture."""


def text_of(report: SwapReport) -> str:
    """Return the report as text."""
    study = report.study
    variants = [variant.name for variant in study.fleet.variants]
    table = [("local numbers", "", *variants, "loss %")]
    table.append(("best of its own, J*", "", *(_number(value) for value in study.fleet.best * _MICRO), ""))
    for choice in (study.given, *study.choices):
        effort = "" if choice is study.given else str(choice.effort)
        named = "the scenario's own numbers" if choice is study.given else choice.name
        table.append((named, effort, *(_number(v) for v in choice.design.values * _MICRO), _at_least(study, choice.loss)))
    lines = [f"J in {report.unit}, of each variant; the column behind the names counts the local numbers", *_columns(table)]
    lines += ["", report.verdict]
    best = study.recommended
    if best is not None:
        lines += ["", "recommended division", *_division(study, best)]
    which = "recommended division" if best is not None else "shared design, nothing local"
    lines += ["", f"exact margins of the {which}", *_margins(report)]
    if report.networks:
        lines += ["", *_networks(report, which)]
    lines += ["", *_notes(study), *(f"note: {words}" for words in report.notes)]
    if report.over is not None:
        lines += ["", *_coverage(study, report.over)]
    for found in report.linear:
        lines += ["", *_linear(found)]
    return "\n".join(lines)


def _notes(study: SwapStudy) -> Iterator[str]:
    yield from (f"note: {words}" for words in search_words(study))
    edges = on_bounds(study, study.recommended or study.base)
    if edges:
        yield f"note: on a bound, where a wider one might do better: {', '.join(edges)}"
    if study.given_breaks:
        yield f"note: the scenario's own numbers break a guard with {'; '.join(study.given_breaks)}"


def _margins(report: SwapReport) -> Iterator[str]:
    rows, broken = [("  variant", "axis", "gain margin", "phase margin")], []
    for variant, mine, short in zip(report.study.fleet.variants, report.final.margins, report.final.broken, strict=True):
        rows += [(f"  {variant.name}", axis, decibel(one), degrees(one)) for axis, one in mine.items()]
        broken += [f"  not kept with {variant.name}: {words}" for words in short]
    yield from [*_columns(rows), *broken]


def _networks(report: SwapReport, which: str) -> Iterator[str]:
    """Yield what divisions between base and axes cost, and how few messages hold."""
    unit, variants = report.unit, report.study.fleet.variants
    yield f"{which} over a network: J in {unit}, largest that is let pass, and the longest message period that holds"
    rows = [("  in the axis, messages", "variant", "wired", "let pass", "as given", "period that holds", "J at that of all")]
    for cost in report.networks:
        columns = zip(variants, cost.whole, cost.allowed, cost.given, cost.sweeps, cost.at_limit, strict=True)
        for variant, whole, allowed, given, sweep, at_limit in columns:
            shown = [f"{value * _MICRO:.4g}" if math.isfinite(value) else "runs away" for value in (whole, allowed, given)]
            most = "none" if math.isnan(sweep.most) else f"{'' if sweep.seen else 'all, to '}{sweep.most * 1e3:.4g} ms"
            last = f"{at_limit * _MICRO:.4g}" if math.isfinite(at_limit) else "-"
            rows.append((f"  {cost.division}, {WORDS[cost.ways]}", variant.name, *shown, most, last))
    yield from _columns(rows)
    apart = {cost.division: report.apart(cost) for cost in report.networks if cost.apart}
    yield from (f"  {division}: {names} would have to be set in the base for each axis" for division, names in apart.items())
    for cost in report.networks:
        if not all(cost.stable):
            yield f"  {cost.division}, {WORDS[cost.ways]}: the linear model with the network as given is unstable"


def _division(study: SwapStudy, choice: Choice) -> Iterator[str]:
    """Yield the numbers of a division: base, then local with a value for each variant."""
    space, rows = study.fleet.space, []
    values = space.columns(choice.design.points)
    for number in space.numbers:
        shown = [number.shown(value) for value in values[number.name].tolist()]
        unit = number.written_in
        local = number.name in choice.design.local
        rows.append((f"  {number.short}", "local" if local else "base", *(f"{v:.6g}" for v in (shown if local else shown[:1])), unit))
    widest = max(len(row) for row in rows)
    yield from _columns([(*row[:-1], *[""] * (widest - len(row)), row[-1]) for row in rows])


def _coverage(study: SwapStudy, over: Coverage) -> Iterator[str]:
    low, high = over.bounds
    span = ", ".join(
        f"{number.short} {number.shown(number.low):g} to {number.shown(number.high):g} {number.written_in}".rstrip()
        for number in over.region.numbers
    )
    good = (
        f"J up to {over.tolerance * _MICRO:g} {_unit(study)}"
        if over.tolerance is not None
        else f"a loss under {100.0 * study.settings.full:g} %"
    )
    yield f"coverage of {span}: {100.0 * over.share:.3g} % ({100.0 * low:.3g} to {100.0 * high:.3g} % with 95 % confidence)"
    held = int(np.isfinite(over.values).sum())
    searched = "" if over.tolerance is not None else "; J* from a search at each of them"
    yield f"  {good}, guards kept, nothing local: {over.covered} of {over.judged} Sobol points{searched}; the guards hold at {held}"
    if over.without:
        counts = "it counts" if over.without == 1 else "they count"
        yield f"  at {over.without} of them no search found a design that keeps the guards, so that there is no J*: {counts} as not covered"


def _linear(found: LinearSwap) -> Iterator[str]:
    models = ", ".join(
        f"{name} a = {model.gain:.4g}, b = {model.damping:.3g}" for name, model in zip(found.modules, found.models, strict=True)
    )
    yield f"linear, axis {found.axis}, {found.case}: {models} (a per mm/s^2, b per 1/s)"
    yield f"  blind swap: J/J* up to {found.blind.max():.4g}"
    for design in found.designs:
        local = ", ".join(design.local) or "nothing"
        ratios = ", ".join(f"{ratio:.4g}" for ratio in design.ratio)
        yield f"  {design.method}, {local} local: J/J* {ratios}"
    yield from (f"  note: {words}" for words in linear_remarks(found))


def linear_remarks(found: LinearSwap) -> Iterator[str]:
    """Yield which designs lose more than one that they contain, and why that is no contradiction."""
    for design, fewer in found.not_optimal:
        more, less = (", ".join(one.local) or "nothing" for one in (design, fewer))
        yield (
            f"{design.method} is not optimal: with {more} local it loses more than with {less} local, whose gains it could have; its steps "
            "are taken in sequence, and fit gains to the optimal ones over frequency, not to the least J/J* as direct does"
        )


def _columns(rows: Sequence[tuple[str, ...]]) -> list[str]:
    """Return rows with their columns under one another: names to the left, figures to the right."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return [
        "  ".join(cell.ljust(w) if i == 0 else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths, strict=True))).rstrip()
        for row in rows
    ]


def _number(value: float) -> str:
    return f"{value:.4g}" if math.isfinite(value) else "breaks a guard"


def _percent(loss: float) -> str:
    return "-" if not math.isfinite(loss) else f"{100.0 * loss:.0f}" if loss >= 1.0 else f"{100.0 * loss:.3g}"


def _at_least(study: SwapStudy, loss: float) -> str:
    """Return a loss, which is no more than a lower bound where J* was still falling."""
    return f"{at_least(study, loss)}{_percent(loss)}"


def _unit(study: SwapStudy) -> str:
    return UNITS[OBJECTIVES[study.fleet.objective][0]]


def summary_of(report: SwapReport) -> dict[str, Any]:
    """Return everything as JSON has it, in SI."""
    study, over = report.study, report.over
    fleet, best, settings = study.fleet, study.recommended, study.settings
    numbers = {
        number.name: {"low": number.low, "high": number.high, "unit": number.unit, "scenario": number.value}
        for number in fleet.space.numbers
    }
    return {
        "verdict": report.verdict,
        "passed": report.passed,
        "full_modularity": study.full,
        "restorable": best is not None,
        "local": sorted(best.design.local) if best is not None else None,
        "swap_loss": study.base.loss,
        "limit": settings.full,
        "objective": fleet.objective,
        "floor": fleet.floor,
        "guards": {
            "gain_margin": fleet.bounds.gain_margin,
            "phase_margin": fleet.bounds.phase_margin,
            "limited_share": fleet.bounds.limited,
        },
        "search": {
            "budget": settings.budget,
            "seed": settings.seed,
            "runs": fleet.runs,
            "exhaustive": settings.exhaustive,
            "from": list(report.origins),
            "fell_short": list(study.fell_short),
        },
        "bounds": numbers,
        "variants": {
            variant.name: {
                "best": float(value),
                "per_start": own.per_start.tolist(),
                "searched_on": own.on.tolist(),
                "searched_afresh": own.afresh,
                "numbers": fleet.space.values(point),
            }
            for variant, value, own, point in zip(fleet.variants, fleet.best, study.owns, fleet.best_points, strict=True)
        },
        "as_given": _choice(study, study.given),
        "choices": [_choice(study, choice) for choice in study.choices],
        "designs_on_variants": study.crossed.tolist(),
        "ranking": [{"name": r.name, "sensitivity": r.sensitivity, "movement": r.movement} for r in study.ranking],
        "coverage": None if over is None else _coverage_summary(over),
        "margins": {
            variant.name: {"axes": {axis: asdict(one) for axis, one in mine.items()}, "broken": list(short)}
            for variant, mine, short in zip(fleet.variants, report.final.margins, report.final.broken, strict=True)
        },
        "networks": [_network_summary(cost, [variant.name for variant in fleet.variants]) for cost in report.networks],
        "linear": [_linear_summary(one) for one in report.linear],
    }


def _linear_summary(one: LinearSwap) -> dict[str, Any]:
    return {
        "axis": one.axis,
        "case": one.case,
        "models": {name: {"a": m.gain, "b": m.damping} for name, m in zip(one.modules, one.models, strict=True)},
        "blind": one.blind.tolist(),
        "designs": [{"method": d.method, "local": list(d.local), "ratio": d.ratio.tolist()} for d in one.designs],
        "remarks": list(linear_remarks(one)),
    }


def _network_summary(cost: NetworkCost, names: Sequence[str]) -> dict[str, Any]:
    columns = zip(names, cost.whole, cost.allowed, cost.given, cost.stable, cost.sweeps, cost.at_limit, strict=True)
    return {
        "division": cost.division,
        "ways": cost.ways,
        "holds": cost.holds,
        "loss": cost.loss,
        "message_period": cost.period,
        "rate": cost.rate,
        "limited": cost.limited,
        "local_in_base": list(cost.apart),
        "variants": {
            name: {
                "undivided": float(whole),
                "allowed": float(allowed),
                "as_given": float(given),
                "stable": stable,
                "message_period": sweep.most,
                "at_message_period_of_all": float(last),
            }
            for name, whole, allowed, given, stable, sweep, last in columns
        },
    }


def _coverage_summary(over: Coverage) -> dict[str, Any]:
    low, high = over.bounds
    return {
        "share": over.share,
        "low": low,
        "high": high,
        "points": over.judged,
        "tolerance": over.tolerance,
        "values": over.values.tolist(),
        "best": over.best.tolist(),
        "without_design": over.without,
    }


def _choice(study: SwapStudy, choice: Choice) -> dict[str, Any]:
    return {
        "name": choice.name,
        "local": sorted(choice.design.local),
        "values": choice.design.values.tolist(),
        "losses": choice.losses.tolist(),
        "swap_loss": choice.loss,
        "per_start": choice.design.per_start.tolist(),
        "numbers": [study.fleet.space.values(point) for point in choice.design.points],
    }


def matrices(study: SwapStudy) -> list[LossMatrix]:
    """Return the picture's matrices: variants under choices of local numbers, and variants under designs for each other."""
    fleet, unit = study.fleet, _unit(study)
    names = tuple(variant.name for variant in fleet.variants)
    falling = np.array([name in study.fell_short for name in names])

    def cell(lost: float, value: float, still: bool) -> str:
        if not math.isfinite(lost):
            return "breaks a guard"
        return f"{'at least ' if still else ''}{_percent(lost)} %  ({value * _MICRO:.3g} {unit})"

    def cells(values: Array) -> tuple[Array, tuple[tuple[str, ...], ...], NDArray[np.bool_]]:
        lost = losses(np.where(np.isfinite(values), values, np.nan), fleet.best, fleet.floor)
        texts = [tuple(map(cell, *row, falling.tolist())) for row in zip(lost.tolist(), values.tolist(), strict=True)]
        # What is over the limit stays so, however far J* may fall.
        return lost, tuple(texts), falling & (lost < study.settings.full)

    shown = _distinct(study)
    rows = tuple(_broken_up(choice.name if choice.effort else "nothing") for choice in shown)
    first = LossMatrix("local numbers, and the swap loss of each variant", rows, names, *cells(np.array([c.design.values for c in shown])))
    crossed = np.vstack([study.crossed, study.given.design.values])
    second = LossMatrix(
        "numbers found for one, run on the other", (*(f"for {n}" for n in names), "the scenario's own"), names, *cells(crossed)
    )
    return [first, second]


def _distinct(study: SwapStudy) -> list[Choice]:
    """Return for each number of local numbers the choice that loses least; the last is all."""
    best: dict[int, Choice] = {}
    for choice in sorted(study.choices, key=lambda choice: (choice.effort, choice.loss)):
        best.setdefault(choice.effort, choice)
    return list(best.values())


def _broken_up(name: str) -> str:
    return "\n".join(wrap(name, ROW_WIDTH))
