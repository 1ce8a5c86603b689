"""Which numbers were fitted together: correlations within an axis, and between the axes of a machine."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.components.contract import Component
from contourlab.loop import Machine
from contourlab.loop.machine import AXIS_SLOTS
from contourlab.scenario.tree import Leaf, Table, hint


def read_correlations(table: Table, parts: Mapping[str, Component]) -> tuple[tuple[str, str, float], ...]:
    """Return the correlations of an axis' numbers: ``correlations = [["plant.mass", "friction.coulomb", -0.3]]``.

    Those of numbers that have lost their deviation, because something else was put in their place, are left out.

    Parameters
    ----------
    table : Table
        Of the axis.
    parts : mapping of str to Component
        By slot.

    Raises
    ------
    ScenarioError
        If an item is no correlation of two numbers of the axis, or together they contradict each other.
    """

    def replaced(slot: str, node: Leaf) -> bool:
        part = table.get(slot)
        return part is not None and (part.file, part.key.rpartition(".")[0]) != (node.file, node.key.rpartition(".")[0])

    return _read_pairs(table, _Known(parts, ("plant.mass", "friction.coulomb"), replaced))


def read_machine_correlations(table: Table, axes: Table, machine: Machine) -> tuple[tuple[str, str, float], ...]:
    """Return the correlations between axes: ``correlations = [["x.plant.damping", "y.plant.damping", 0.4]]`` of ``[machine]``.

    Parameters
    ----------
    table : Table
        Of the machine.
    axes : Table
        Of its axes.
    machine : Machine
        With their parts and their own correlations.

    Raises
    ------
    ScenarioError
        If an item is no correlation of numbers of two axes, or together with those of the axes they contradict each other.
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
    """Numbers that correlations may be of.

    `parts` are components by slot, `example` two numbers for messages, `replaced` tells of a slot and the list whether something else was
    put in the place of what the list speaks of. `own` are correlations that hold besides; `between` asks for numbers of two axes.
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
        raise table.error(f"a list is wanted: [{known.shown}, ...]", "correlations")
    kept = []
    for i, item in enumerate(node.value):
        fault = _fault(item, node, known)
        if fault:
            raise node.error(f"item {i + 1}: {fault}")
        if all(known.deviates(name) for name in item[:2]):
            kept.append((item[0], item[1], float(item[2])))
    if len({frozenset(item[:2]) for item in kept}) < len(kept):
        raise node.error("a pair is listed twice")
    names = sorted({name for item in (*kept, *known.own) for name in item[:2]})
    matrix = np.eye(len(names))
    for one, other, value in (*known.own, *kept):
        i, j = names.index(one), names.index(other)
        matrix[i, j] = matrix[j, i] = value
    if kept and float(np.linalg.eigvalsh(matrix).min()) < -1e-3:
        raise node.error("these contradict each other: no set of numbers has all of these correlations")
    return tuple(kept)


def _fault(item: Any, node: Leaf, known: _Known) -> str:
    if not isinstance(item, list) or len(item) != 3 or not all(isinstance(name, str) for name in item[:2]) or item[0] == item[1]:
        return f"{item!r:.80}: two different numbers and a coefficient are wanted, {known.shown}"
    if isinstance(item[2], bool) or not isinstance(item[2], int | float) or not -1.0 <= item[2] <= 1.0:
        return f"{item[2]!r:.40} is no coefficient: between -1 and 1"
    for name in item[:2]:
        numbers = [f"{label}.{key}" for label, part in known.parts.items() for key in part.numeric()]
        if name not in numbers and not known.replaced(name.rpartition(".")[0], node):
            return f"no number {name!r}: {hint(name, numbers)}"
    axis = item[0].partition(".")[0]
    if known.between and axis == item[1].partition(".")[0]:
        return f"both are of axis {axis}: correlations within an axis stand at the top of the axis"
    return ""
