"""What ``contourlab link`` says of the divisions that it looked at: as text, and as JSON."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.features.link.division import DivisionCost
from contourlab.features.link.sweep import CHUNK, GROWN, QUANTITIES, LinkSweep
from contourlab.features.link.values import EACH, FARTHER

SHOWN = {
    "rms": ("contour_error_rms", "um", 1e6),
    "max": ("contour_error_max", "um", 1e6),
    "integral": ("contour_error_integral", "um s", 1e6),
}
"""Figures as they are asked for, with the unit in which they are printed."""
TIMED = ("message_period", "delay")
"""What limits of stability are told of."""


@dataclass(frozen=True)
class Costs:
    """What the divisions of one scheme cost.

    Attributes
    ----------
    name : str
        Of the scheme.
    figure : str
        Of `SHOWN`.
    whole, allowed : float [m, or m s]
        The undivided loop's error, and what is let pass.
    divisions : tuple of DivisionCost
    """

    name: str
    figure: str
    whole: float
    allowed: float
    divisions: tuple[DivisionCost, ...]

    def shown(self, value: float) -> str:
        """Return an error as it is printed."""
        _, unit, scale = SHOWN[self.figure]
        return f"{value * scale:.4g} {unit}"


# --- text --------------------------------------------------------------------------------------------------------------------------------


def link_lines(costs: Costs) -> Iterator[str]:
    """Yield the lines that say what the divisions cost, and where and why the looking ended."""
    heads = [head for head in QUANTITIES if any(head in cost.sweeps for cost in costs.divisions)]
    yield costs.name
    yield f"  contour error, {costs.figure}: {costs.shown(costs.whole)} undivided, {costs.shown(costs.allowed)} allowed"
    yield "  the most of each that holds, with the others as they are given (times are those of one direction):"
    rows = [["in the axis", "messages", "error", *(_words(head) for head in heads)]]
    for cost in costs.divisions:
        error = "runs away" if math.isnan(cost.error) else costs.shown(cost.error)
        rows.append([cost.division, f"{cost.ways} way{'s' * (cost.ways == 'both')}", error, *(_most(cost.sweeps[head]) for head in heads)])
    yield from _table(rows)
    timed = [head for head in TIMED if head in heads]
    if timed:
        yield "  the most at which the loop is stable: linear model / simulated without friction, counting and limits (- is not told)"
        stable = [["in the axis", "messages", *(_words(head) for head in timed)]]
        stable += [[*row[:2], *(_stable(cost.sweeps[head]) for head in timed)] for row, cost in zip(rows[1:], costs.divisions, strict=True)]
        yield from _table(stable)
    yield from (f"  {line}" for line in (*_looked_at(costs, heads), *_ended(costs, heads), *_of_each(costs)))


def _words(quantity: str) -> str:
    return quantity.replace("_", " ")


def _amount(quantity: str, value: float) -> str:
    if quantity == "loss":
        return f"{100.0 * value:.3g} %"
    return f"{value * 1e3:.4g} ms" if value < 9.9995 else f"{value:.4g} s"


def _most(sweep: LinkSweep) -> str:
    if math.isnan(sweep.most):
        return "none"
    words = _amount(sweep.quantity, sweep.most)
    if sweep.quantity == "message_period":
        words += f" ({1.0 / sweep.most:.4g} Hz)"
    return words if sweep.seen else f"all seen, to {words}"


def _stable(sweep: LinkSweep) -> str:
    def words(value: float, known: bool) -> str:
        if math.isnan(value):
            return "none" if known else "-"
        return "all seen" if math.isinf(value) else _amount(sweep.quantity, value)

    # A limit that is not a number where something is known: the first value that is known is unstable already.
    linear = bool((sweep.growth >= 1.0).any())
    simulated = bool((sweep.repeats > 1.0 + GROWN).any())
    return f"{words(sweep.stable_linear, linear)} / {words(sweep.stable_simulated, simulated)}"


def _table(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        yield "    " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()


def _looked_at(costs: Costs, heads: Sequence[str]) -> Iterator[str]:
    """Yield the values that were to be looked at."""
    grids: dict[str, list[str]] = {}
    for head in heads:
        grids.setdefault(_grid(costs.divisions[0].sweeps[head]), []).append(_words(head))
    yield "looked at: " + "; ".join(f"{', '.join(named)} {grid}" for grid, named in grids.items())


def _grid(sweep: LinkSweep) -> str:
    if sweep.values.size == 1:
        return f"at {_amount(sweep.quantity, float(sweep.values[0]))} alone"
    least = float(np.diff(sweep.values).min())
    each, near, to = (_amount(sweep.quantity, value) for value in (least, EACH * least, sweep.asked))
    if round(sweep.asked / least) > EACH:
        return f"every {each} up to {near}, beyond in steps of {100.0 / FARTHER:.2g} % at most up to {to}, and each ahead of a limit"
    return f"every {each} up to {to}"


def _ended(costs: Costs, heads: Sequence[str]) -> Iterator[str]:
    """Yield where sweeps ended ahead of that."""
    for head in heads:
        ends: dict[str, list[str]] = {}
        for cost in costs.divisions:
            sweep = cost.sweeps[head]
            if sweep.ended:
                ends.setdefault(_amount(head, float(sweep.values[-1])), []).append(f"{cost.division} {cost.ways}")
        for end, named in ends.items():
            of = "" if len(named) == len(costs.divisions) else f" ({', '.join(named)})"
            yield f"{_words(head)} ended at {end}{of}: none of the last {CHUNK} values holds"


def _of_each(costs: Costs) -> Iterator[str]:
    """Yield why nothing holds where nothing does, and remarks; what is said of all divisions once."""
    of_all = [remark for remark in costs.divisions[0].remarks if all(remark in cost.remarks for cost in costs.divisions)]
    yield from of_all
    for cost in costs.divisions:
        own = [remark for remark in cost.remarks if remark not in of_all]
        yield from (f"{cost.division}, {cost.ways}: {remark}" for remark in (*_none(costs, cost.sweeps.values()), *own))


def _none(costs: Costs, sweeps: Iterable[LinkSweep]) -> Iterator[str]:
    for sweep in sweeps:
        if not math.isnan(sweep.most) or sweep.limited_by is None:
            continue
        value, cause = sweep.limited_by
        why = {
            "runs away": "a run leaves its limits",
            "error": f"the contour error is {costs.shown(float(sweep.error[0]))}, and {costs.shown(costs.allowed)} are allowed",
            "unstable": "the linear model is unstable",
        }[cause]
        yield f"no {_words(sweep.quantity)} holds: at {_amount(sweep.quantity, value)}, the least, {why}"


# --- JSON --------------------------------------------------------------------------------------------------------------------------------


def link_summary(costs: Costs) -> dict[str, Any]:
    """Return the same in SI, with the curves."""
    divisions = []
    for cost in costs.divisions:
        head = {"division": cost.division, "ways": cost.ways, "error": cost.error, "local_parameters": dict(cost.local)}
        divisions.append({**head, "sweeps": _sweeps(cost.sweeps), "remarks": list(cost.remarks)})
    return {"figure": SHOWN[costs.figure][0], "undivided": costs.whole, "allowed": costs.allowed, "divisions": divisions}


def _sweeps(sweeps: Mapping[str, LinkSweep]) -> dict[str, Any]:
    return {
        name: {
            "most": sweep.most,
            "rate": 1.0 / sweep.most if name == "message_period" else None,
            "limited": sweep.seen,
            "limited_by": None if sweep.limited_by is None else sweep.limited_by[1],
            "asked": sweep.asked,
            "ended_early": sweep.ended,
            "stable_linear": sweep.stable_linear,
            "stable_simulated": sweep.stable_simulated,
            "values": sweep.values,
            "error": sweep.error,
            "median": sweep.median,
            "growth": sweep.growth,
        }
        for name, sweep in sweeps.items()
    }
