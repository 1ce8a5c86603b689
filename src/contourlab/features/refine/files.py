"""Files of machines and controllers that were refined against logs, with where each number is from behind it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations
from typing import Any

from contourlab.features.refine.remarks import shown
from contourlab.features.refine.study import Refined
from contourlab.loop import Axis
from contourlab.scenario.dump import controller_table, machine_tables
from contourlab.scenario.toml_text import Noted, toml

DIGITS = 6


def machine_text(found: Refined, sources: Sequence[str]) -> str:
    """Return the machine's file.

    Parameters
    ----------
    found : Refined
    sources : sequence of str
        Names of the logs.
    """
    tables = machine_tables(found.runs[0].machine)
    _note(found, sources, {"axes": tables["axes"]}, "axes.")
    for axis in found.runs[0].machine.axes:
        _correlate(found, axis, tables["axes"])
    _correlate_axes(found, tables["machine"])
    return _head(found, sources) + toml(tables)


def controller_text(found: Refined, run: int, sources: Sequence[str]) -> str:
    """Return the file of the controller of one of the runs.

    Parameters
    ----------
    found : Refined
    run : int
        Which.
    sources : sequence of str
        Names of the logs.
    """
    tables = {"controller": controller_table(found.runs[run].controller, found.runs[run].machine)}
    _note(found, sources, tables, "controller.", run)
    return _head(found, sources) + toml(tables)


def _head(found: Refined, sources: Sequence[str]) -> str:
    lines = [f"Refined against {', '.join(dict.fromkeys(sources))}: simulated against measured along the logs' own references."]
    for one in found.after:
        lines.append(f"{one.run}, {one.signal} of {one.axis}: {100.0 * one.explained:.5g} % of the variance explained, fit {one.fit:.4g} %")
    lines += list(found.remarks)
    return "".join(f"# {line}\n" for line in lines) + "\n"


def _correlate(found: Refined, axis: Axis, tables: dict[str, Any]) -> None:
    """Put the correlations of an axis' refined numbers into its table; those with numbers that were refined anew are no longer so."""
    head = f"axes.{axis.name}."
    told = {name.removeprefix(head): row for name, row in _told(found).items() if name.startswith(head)}
    anew = {name.removeprefix(head) for name in _anew(found)}
    kept = [list(one) for one in axis.correlations if not anew & set(one[:2])]
    rest = {key: value for key, value in tables[axis.name].items() if key != "correlations"}
    tables[axis.name] = _together([*kept, *_pairs(found, told)]) | rest


def _correlate_axes(found: Refined, table: dict[str, Any]) -> None:
    """Put the correlations between numbers of two axes into the table of the machine, alike."""
    head = "axes."
    told = {name.removeprefix(head): row for name, row in _told(found).items() if name.startswith(head)}
    anew = {name.removeprefix(head) for name in _anew(found)}
    kept = [list(one) for one in found.runs[0].machine.correlations if not anew & set(one[:2])]
    across = [pair for pair in _pairs(found, told) if pair[0].partition(".")[0] != pair[1].partition(".")[0]]
    table.pop("correlations", None)
    table |= _together([*kept, *across])


def _anew(found: Refined) -> set[str]:
    """Return the names of the numbers that were refined, of the first run: its machine is the one that is written."""
    return {one.name for one in found.sought if 0 in one.runs}


def _told(found: Refined) -> dict[str, int]:
    """Return the refined numbers that the logs tell, with their rows in what is known."""
    free = [i for i, bound in enumerate(found.at_bound.tolist()) if not bound]
    return {found.sought[i].name: row for row, i in enumerate(free) if 0 in found.sought[i].runs and math.isfinite(found.deviations[i])}


def _pairs(found: Refined, told: dict[str, int]) -> list[list[Any]]:
    pairs = [[one, other, round(float(found.knowledge.correlation[i, j]), 4)] for (one, i), (other, j) in combinations(told.items(), 2)]
    return [pair for pair in pairs if pair[2]]


def _together(pairs: list[list[Any]]) -> dict[str, Any]:
    return {"correlations": Noted(pairs, "of what was fitted together")} if pairs else {}


def _note(found: Refined, sources: Sequence[str], tables: dict[str, Any], head: str, run: int = 0) -> None:
    """Put where a refined number is from and what it is worth beside it, in digits that are worth having."""
    figures = zip(found.sought, found.values.tolist(), found.deviations.tolist(), found.at_bound.tolist(), strict=True)
    for one, value, deviation, bound in figures:
        if not one.name.startswith(head) or run not in one.runs:
            continue
        table = tables
        *words, last = one.name.split(".")
        for word in words:
            table = table[word]
        logs = ", ".join(dict.fromkeys(sources[i] for i in one.runs))
        known = not bound and math.isfinite(deviation)
        said = "at the bound of its range" if bound else "not told by the logs"
        number = shown(one, value, DIGITS) if one.number.unit else float(f"{value:.{DIGITS}g}")
        worth = {"deviation": shown(one, deviation, 2) if one.number.unit else float(f"{deviation:.2g}")} if known else {"note": said}
        table[last] = Noted({"value": number, "source": "fitted", **worth, "from": logs})
