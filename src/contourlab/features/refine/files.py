"""Files of refined machines and controllers: each refined value with source, deviation and correlations."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations
from typing import Any

from contourlab.features.refine.study import Refined, Sought
from contourlab.loop import Axis, Machine
from contourlab.scenario.dump import controller_table, machine_tables
from contourlab.scenario.toml_text import Noted, toml

DIGITS = 6


def machine_text(refined: Refined, sources: Sequence[str]) -> str:
    """Return the text of the machine file; `sources` are the names of the logs."""
    machine = refined.runs[0].machine
    tables = machine_tables(machine)
    _note(refined, sources, {"axes": tables["axes"]}, "axes.")
    for axis in machine.axes:
        tables["axes"][axis.name] = _correlations(refined, f"axes.{axis.name}.", axis) | _without(tables["axes"][axis.name])
    tables["machine"] = _without(tables["machine"]) | _correlations(refined, "axes.", machine)
    return _head(refined, sources) + toml(tables)


def controller_text(refined: Refined, run: int, sources: Sequence[str]) -> str:
    """Return the text of the controller file of a run; `sources` are the names of the logs."""
    tables = {"controller": controller_table(refined.runs[run].controller, refined.runs[run].machine)}
    _note(refined, sources, tables, "controller.", run)
    return _head(refined, sources) + toml(tables)


def _head(refined: Refined, sources: Sequence[str]) -> str:
    lines = [f"Refined against {', '.join(dict.fromkeys(sources))}, simulated along the references of the logs."]
    lines += [f"{one.place}: {100.0 * one.explained:.5g} % of the variance explained, fit {one.fit:.4g} %" for one in refined.after]
    lines += [str(finding) for finding in refined.findings]
    return "".join(f"# {line}\n" for line in lines) + "\n"


def _without(table: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in table.items() if key != "correlations"}


def _correlations(refined: Refined, head: str, owner: Axis | Machine) -> dict[str, Any]:
    """Return the correlations of the refined parameters under a dotted head, and the earlier ones that still hold.

    All are from the first run, whose machine is written. An earlier correlation with a refined parameter no longer holds.
    """
    names = {parameter.sought.label: parameter.sought.name for parameter in refined.parameters if 0 in parameter.sought.runs}
    anew = {name.removeprefix(head) for name in names.values()}
    pairs: list[list[Any]] = [list(pair) for pair in owner.correlations if not anew & set(pair[:2])]
    finite = {parameter.sought.label for parameter in refined.parameters if math.isfinite(parameter.deviation)}
    rows = {
        names[label].removeprefix(head): i
        for i, label in enumerate(refined.correlation_of)
        if label in names and label in finite and names[label].startswith(head)
    }
    for (one, i), (other, j) in combinations(rows.items(), 2):
        value = round(float(refined.correlation[i, j]), 4)
        # The table of an axis has the correlations within that axis.
        within = isinstance(owner, Machine) and one.partition(".")[0] == other.partition(".")[0]
        if value and not within:
            pairs.append([one, other, value])
    return {"correlations": Noted(pairs, "of parameters fitted together")} if pairs else {}


def _note(refined: Refined, sources: Sequence[str], tables: dict[str, Any], head: str, run: int = 0) -> None:
    """Add source and deviation to each refined value of a run, with significant digits only."""
    for parameter in refined.parameters:
        sought = parameter.sought
        if not sought.name.startswith(head) or run not in sought.runs:
            continue
        *words, last = sought.name.split(".")
        table = tables
        for word in words:
            table = table[word]
        if parameter.at_bound:
            worth: dict[str, Any] = {"note": "at the bound of its range"}
        elif not math.isfinite(parameter.deviation):
            worth = {"note": "not determined by the logs"}
        else:
            worth = {"deviation": _written(sought, parameter.deviation, 2)}
        logs = ", ".join(dict.fromkeys(sources[i] for i in sought.runs))
        table[last] = Noted({"value": _written(sought, parameter.value, DIGITS), "source": "fitted", **worth, "from": logs})


def _written(sought: Sought, value: float, digits: int) -> str | float:
    return sought.shown(value, digits) if sought.variable.unit else float(f"{value:.{digits}g}")
