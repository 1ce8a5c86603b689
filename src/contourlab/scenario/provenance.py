"""Read sources and correlations of numbers: ``mass = {value = "33 kg", source = "datasheet", from = "catalogue, page 12"}``.

A number and its source share a table, so that an override replaces both.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np

from contourlab.components.contract import Component, Parameter
from contourlab.components.origin import SOURCES, Origin
from contourlab.errors import ParameterError, UnitError, hint, refuse
from contourlab.scenario.quantities import read_number
from contourlab.scenario.toml_text import Noted
from contourlab.scenario.tree import STATED, Leaf, Node, Table, located

_KEYS = (STATED, "source", "deviation", "range", "from", "note")
_EXAMPLE = '{value = "33 kg", source = "fitted", deviation = "1 %", from = "log.mat"}'


def bare(node: Node) -> Node:
    """Return the value of a number with a source; any other node unchanged. A value of a control's own file has its place there.

    Raises
    ------
    ScenarioError
        If value or source is missing.
    """
    if isinstance(node, Leaf) or not set(_KEYS) & set(node.entries):
        return node
    for name in node.entries:
        if name not in _KEYS:
            raise node.error(f"unknown key of a number: {hint(name, _KEYS)}", name)
    for name in (STATED, "source"):
        refuse(name not in node.entries, node.error, f"key {name} is missing: write for example {_EXAMPLE}")
    value, of_control = node.entries[STATED], node.entries["source"].plain() == "control" and not node.file.endswith(".toml")
    return replace(value, file=str(node.entries["from"].plain()), key="") if of_control and "from" in node.entries else value


def read_origins(declared: Mapping[str, Parameter], table: Table, values: Mapping[str, Any]) -> dict[str, Origin]:
    """Return the sources of a component's numbers, where given.

    Parameters
    ----------
    declared : mapping of str to Parameter
        With the units of the plant.
    values : mapping of str to value in SI

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    """
    origins = {}
    for name, node in table.entries.items():
        if isinstance(node, Table) and bare(node) is not node:
            parameter = declared[name]
            refuse(parameter.choices, node.error, "is a choice, not a number: delete its source")
            exact = "a list" if parameter.vector else "a whole number" if parameter.whole else ""
            exact = exact or ("part of the model's structure" if parameter.structural else "")
            origins[name] = _origin(node, None if exact else (parameter, float(values[name])), exact)
    return origins


def without_origins(table: Table, names: Collection[str] | None = None) -> tuple[Table, dict[str, Origin]]:
    """Split a table into bare values and the sources of its numbers, or of some of them; not simulated, they have no deviation."""
    own = table.entries if names is None else table.only(*names).entries
    given = {name: node for name, node in own.items() if isinstance(node, Table) and bare(node) is not node}
    origins = {name: _origin(node, None, "not simulated") for name, node in given.items()}
    return table.having(**{name: bare(node) for name, node in given.items()}), origins


def _origin(table: Table, of: tuple[Parameter, float] | None, exact: str) -> Origin:
    """Read the source of a number; `of` is the parameter and its value, None where `exact` says why it has no deviation."""
    texts = {name: _text(table, name) for name in ("source", "from", "note")}
    if texts["source"] not in SOURCES:
        known = ", ".join(f"{name} ({meaning})" for name, meaning in SOURCES.items())
        raise table.error(f"{texts['source']!r} is not a source: write one of {known}", "source")
    given: dict[str, Any] = {}
    for name in ("deviation", "range"):
        if name in table.entries:
            if of is None:
                raise table.error(f"is not allowed here, because the value is {exact}: delete it", name)
            with located(table, name):
                value = table.entries[name].plain()
                given |= {"span": _span(value, *of)} if name == "range" else {"deviation": _deviation(value, *of)}
    try:
        return Origin(texts["source"], reference=texts["from"], note=texts["note"], **given)
    except ParameterError as error:
        raise table.error(str(error), error.name) from error


def _text(table: Table, name: str) -> str:
    text = table.entries[name].plain() if name in table.entries else ""
    if name in table.entries and (not isinstance(text, str) or not 0 < len(text) <= 400 or not text.isprintable()):
        raise table.error("write text in quotes, one line of up to 400 characters", name)
    return str(text)


def _deviation(given: Any, parameter: Parameter, value: float) -> float:
    """Return one standard deviation in SI, from a quantity or a percentage of the value."""
    if isinstance(given, str) and given.strip().endswith("%"):
        try:
            share = 0.01 * read_number(given.strip()[:-1].strip() + " count", "")
        except UnitError:
            raise ParameterError("deviation", repr(given)[:60], 'a number and %, such as "1 %"') from None
        if value == 0.0 or not math.isfinite(value):
            raise ParameterError("deviation", repr(given), f"in {parameter.display or 'bare numbers'}, because the value is {value:g}")
        deviation = share * abs(value)
    else:
        deviation = read_number(given, parameter.unit, parameter.display)
    refuse(not 0.0 < deviation < math.inf, ParameterError, "deviation", repr(given), "> 0")
    return deviation


def _span(given: Any, parameter: Parameter, value: float) -> tuple[float, float]:
    if not isinstance(given, list) or len(given) != 2:
        raise ParameterError("range", repr(given)[:60], "the lowest and the highest value, in a list")
    low, high = (float(parameter.check(read_number(item, parameter.unit, parameter.display))) for item in given)
    refuse(not low <= value <= high or low == high, ParameterError, "range", repr(given), "the lower one first, the value between them")
    return low, high


Correlation = tuple[str, str, float]
"""Two numbers by name, and their coefficient."""


def read_correlations(
    table: Table, parts: Mapping[str, Component], nodes: Mapping[str, Node], within: Sequence[Correlation] | None = None
) -> tuple[Correlation, ...]:
    """Return the correlations of an axis' numbers: ``correlations = [["plant.mass", "friction.coulomb", -0.3]]``.

    Numbers that were overridden without a deviation are left out.

    Parameters
    ----------
    table : Table
        Table of the axis or the machine.
    parts, nodes : mapping of str to Component, to Node
        Components by slot, and the tables that they come from; slots of a machine are ``x.plant``.
    within : sequence, optional
        All correlations within the axes. Then the table is that of a machine, whose correlations are between axes.

    Raises
    ------
    ScenarioError
        If an item is not a correlation of two known numbers, or the correlations contradict each other.
    """
    node = table.get("correlations")
    if node is None:
        return ()
    shown, prefix = '["plant.mass", "friction.coulomb", -0.3]', node.key.removesuffix("correlations")
    if within is not None:
        shown, prefix = '["x.plant.damping", "y.plant.damping", -0.3]', node.key.removesuffix("machine.correlations") + "axes."
    if not isinstance(node, Leaf) or not isinstance(node.value, list):
        raise table.error(f"write a list: [{shown}, ...]", "correlations")
    replaced = {slot for slot, part in nodes.items() if part.file != node.file or not part.key.startswith(prefix)}
    origins = {f"{slot}.{name}": part.origins.get(name) for slot, part in parts.items() for name in part.numeric()}
    kept = []
    for i, item in enumerate(node.value):
        if fault := _fault(item, shown, origins, replaced, within is not None):
            raise node.error(f"item {i + 1}: {fault}")
        if all((origin := origins.get(name)) and origin.deviation is not None for name in item[:2]):
            kept.append((item[0], item[1], float(item[2])))
    refuse(len({frozenset(item[:2]) for item in kept}) < len(kept), node.error, "a pair is listed twice: delete one")
    pairs = (*(within or ()), *kept)
    names = sorted({name for item in pairs for name in item[:2]})
    matrix = np.eye(len(names))
    for first, second, value in pairs:
        i, j = names.index(first), names.index(second)
        matrix[i, j] = matrix[j, i] = value
    if kept and float(np.linalg.eigvalsh(matrix).min()) < -1e-3:
        raise node.error("these correlations contradict each other, their matrix has a negative eigenvalue: correct them")
    return tuple(kept)


def _fault(item: Any, shown: str, known: Collection[str], replaced: Collection[str], between: bool) -> str:
    """Return what is wrong with a correlation; of a replaced slot, any number may be named."""
    if not isinstance(item, list) or len(item) != 3 or not all(isinstance(name, str) for name in item[:2]) or item[0] == item[1]:
        return f"{item!r:.80}: write two different numbers and a coefficient, {shown}"
    if isinstance(item[2], bool) or not isinstance(item[2], int | float) or not -1.0 <= item[2] <= 1.0:
        return f"{item[2]!r:.40} is not a coefficient: write a number from -1 to 1"
    for name in item[:2]:
        if name not in known and name.rpartition(".")[0] not in replaced:
            return f"no number {name!r}: {hint(name, known)}"
    axis = item[0].partition(".")[0]
    if between and axis == item[1].partition(".")[0]:
        return f"both belong to axis {axis}: write correlations within an axis under [axes.{axis}]"
    return ""


# --- writing -------------------------------------------------------------------------------------------------------------------------


def origin_table(value: Any, origin: Origin, quantity: Callable[[float], Any]) -> dict[str, Any]:
    """Return the table of a number and its source.

    Parameters
    ----------
    value : object
        As in a file.
    quantity : callable
        Writes a number of the same unit.
    """
    table: dict[str, Any] = {STATED: value, "source": origin.source}
    if origin.deviation is not None:
        table["deviation"] = quantity(origin.deviation)
    if origin.span is not None:
        table["range"] = [quantity(end) for end in origin.span]
    return table | {key: text for key, text in (("from", origin.reference), ("note", origin.note)) if text}


def with_origins(table: dict[str, Any], origins: Mapping[str, Origin]) -> dict[str, Any]:
    """Return a fixed table with the sources of its numbers, which have no deviation."""
    return {name: Noted(origin_table(value, origins[name], float)) if name in origins else value for name, value in table.items()}


def unstated(value: Any) -> Any:
    """Return a machine or a controller without sources and correlations, for comparisons.

    Parameters
    ----------
    value : Machine, Controller, or any part of them
    """
    if isinstance(value, Component):
        return value.traced({})
    if isinstance(value, tuple):
        return tuple(unstated(item) for item in value)
    if isinstance(value, Mapping):
        return {name: unstated(item) for name, item in value.items()}
    if is_dataclass(value) and not isinstance(value, type):
        bare_parts = {f.name: unstated(getattr(value, f.name)) for f in fields(value) if f.name not in ("origins", "correlations")}
        empty: dict[str, Any] = {name: kind() for name, kind in (("origins", dict), ("correlations", tuple)) if hasattr(value, name)}
        return replace(value, **bare_parts, **empty)
    return value
