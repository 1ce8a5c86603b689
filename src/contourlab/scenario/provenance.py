"""Read sources and correlations of numbers: ``mass = {value = "33 kg", source = "datasheet", from = "catalogue, page 12"}``.

A number and its source share a table, so that an override replaces both.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

import numpy as np

from contourlab.components.contract import Component, Parameter
from contourlab.components.origin import SOURCES, Origin
from contourlab.errors import ParameterError, UnitError, hint
from contourlab.loop import Machine
from contourlab.loop.machine import AXIS_SLOTS
from contourlab.scenario.quantities import read_number
from contourlab.scenario.toml_text import Noted
from contourlab.scenario.tree import STATED, Leaf, Node, Table, located, same_table

_KEYS = (STATED, "source", "deviation", "range", "from", "note")
_EXAMPLE = '{value = "33 kg", source = "fitted", deviation = "1 %", from = "log.mat"}'


def bare(node: Node) -> Node:
    """Return the value of a number with a source; any other node unchanged.

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
        if name not in node.entries:
            raise node.error(f"key {name} is missing: write for example {_EXAMPLE}")
    return node.entries[STATED]


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
            if parameter.choices:
                raise node.error("is a choice, not a number: delete its source")
            exact = "a list" if parameter.vector else "a whole number" if parameter.whole else ""
            exact = exact or ("part of the model's structure" if parameter.structural else "")
            origins[name] = _origin(node, None if exact else (parameter, float(values[name])), exact)
    return origins


def without_origins(table: Table, names: tuple[str, ...] = ()) -> tuple[Table, dict[str, Origin]]:
    """Split a fixed table into bare values and their sources; `names` restricts the keys.

    These numbers are not simulated, so they have no deviation.
    """
    origins = {}
    entries = dict(table.entries)
    for name, node in table.entries.items():
        if isinstance(node, Table) and (not names or name in names) and bare(node) is not node:
            origins[name] = _origin(node, None, "not simulated")
            entries[name] = bare(node)
    return Table(entries, table.file, table.key, table.afresh), origins


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
    node = table.get(name)
    if node is None:
        return ""
    if not isinstance(node, Leaf) or not isinstance(node.value, str) or not 0 < len(node.value) <= 400 or not node.value.isprintable():
        raise table.error("write text in quotes, one line of up to 400 characters", name)
    return node.value


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
    if not 0.0 < deviation < math.inf:
        raise ParameterError("deviation", repr(given), "> 0")
    return deviation


def _span(given: Any, parameter: Parameter, value: float) -> tuple[float, float]:
    if not isinstance(given, list) or len(given) != 2:
        raise ParameterError("range", repr(given)[:60], "the lowest and the highest value, in a list")
    low, high = (float(parameter.check(read_number(item, parameter.unit, parameter.display))) for item in given)
    if not (low <= value <= high and low < high):
        raise ParameterError("range", repr(given), "the lower one first, with the value between them")
    return low, high


def read_correlations(table: Table, parts: Mapping[str, Component]) -> tuple[tuple[str, str, float], ...]:
    """Return the correlations of an axis' numbers: ``correlations = [["plant.mass", "friction.coulomb", -0.3]]``.

    Numbers that were overridden without a deviation are left out.

    Parameters
    ----------
    table : Table
        Table of the axis.
    parts : mapping of str to Component
        Components by slot.

    Raises
    ------
    ScenarioError
        If an item is not a correlation of two numbers of the axis, or the correlations contradict each other.
    """

    def replaced(slot: str, node: Leaf) -> bool:
        part = table.get(slot)
        return part is not None and not same_table(part, node)

    return _read_pairs(table, _Known(parts, ("plant.mass", "friction.coulomb"), replaced))


def read_machine_correlations(table: Table, axes: Table, machine: Machine) -> tuple[tuple[str, str, float], ...]:
    """Return the correlations between axes: ``correlations = [["x.plant.damping", "y.plant.damping", 0.4]]`` of ``[machine]``.

    Parameters
    ----------
    table : Table
        Table of the machine.
    axes : Table
        Tables of its axes.
    machine : Machine
        With their parts and their own correlations.

    Raises
    ------
    ScenarioError
        If an item is not a correlation of numbers of two axes, or all correlations together contradict each other.
    """
    parts = {
        f"{axis.name}.{slot}": part for axis in machine.axes for slot in AXIS_SLOTS if isinstance(part := getattr(axis, slot), Component)
    }

    def replaced(slot: str, node: Leaf) -> bool:
        axis, _, inner = slot.partition(".")
        part = axes.table(axis).get(inner) if axis in axes.entries else None
        return part is not None and (part.file, part.key) != (node.file, axes.at(slot))

    own = tuple((f"{axis.name}.{a}", f"{axis.name}.{b}", value) for axis in machine.axes for a, b, value in axis.correlations)
    return _read_pairs(table, _Known(parts, ("x.plant.damping", "y.plant.damping"), replaced, own, between=True))


@dataclass(frozen=True, eq=False)
class _Known:
    """Numbers that may correlate.

    `parts` are components by slot, `example` two numbers for messages. `replaced` tells whether a slot was overridden outside the table
    of the list. `own` are further correlations; `between` requires numbers of two axes.
    """

    parts: Mapping[str, Component]
    example: tuple[str, str]
    replaced: Callable[[str, Leaf], bool]
    own: tuple[tuple[str, str, float], ...] = ()
    between: bool = False

    @property
    def shown(self) -> str:
        return f'["{self.example[0]}", "{self.example[1]}", -0.3]'

    def deviates(self, name: str) -> bool:
        """Tell whether a number has a deviation."""
        slot, _, number = name.rpartition(".")
        origin = self.parts[slot].origins.get(number) if slot in self.parts else None
        return origin is not None and origin.deviation is not None


def _read_pairs(table: Table, known: _Known) -> tuple[tuple[str, str, float], ...]:
    node = table.get("correlations")
    if node is None:
        return ()
    if not isinstance(node, Leaf) or not isinstance(node.value, list):
        raise table.error(f"write a list: [{known.shown}, ...]", "correlations")
    kept = []
    for i, item in enumerate(node.value):
        fault = _fault(item, node, known)
        if fault:
            raise node.error(f"item {i + 1}: {fault}")
        if all(known.deviates(name) for name in item[:2]):
            kept.append((item[0], item[1], float(item[2])))
    if len({frozenset(item[:2]) for item in kept}) < len(kept):
        raise node.error("a pair is listed twice: delete one")
    names = sorted({name for item in (*kept, *known.own) for name in item[:2]})
    matrix = np.eye(len(names))
    for first, second, value in (*known.own, *kept):
        i, j = names.index(first), names.index(second)
        matrix[i, j] = matrix[j, i] = value
    if kept and float(np.linalg.eigvalsh(matrix).min()) < -1e-3:
        raise node.error("these correlations contradict each other, their matrix has a negative eigenvalue: correct them")
    return tuple(kept)


def _fault(item: Any, node: Leaf, known: _Known) -> str:
    if not isinstance(item, list) or len(item) != 3 or not all(isinstance(name, str) for name in item[:2]) or item[0] == item[1]:
        return f"{item!r:.80}: write two different numbers and a coefficient, {known.shown}"
    if isinstance(item[2], bool) or not isinstance(item[2], int | float) or not -1.0 <= item[2] <= 1.0:
        return f"{item[2]!r:.40} is not a coefficient: write a number from -1 to 1"
    for name in item[:2]:
        numbers = [f"{label}.{key}" for label, part in known.parts.items() for key in part.numeric()]
        if name not in numbers and not known.replaced(name.rpartition(".")[0], node):
            return f"no number {name!r}: {hint(name, numbers)}"
    axis = item[0].partition(".")[0]
    if known.between and axis == item[1].partition(".")[0]:
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
