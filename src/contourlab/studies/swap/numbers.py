"""Machines and controllers with other numbers in place of theirs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from contourlab.components.contract import Component
from contourlab.loop import Controller, Machine
from contourlab.loop.machine import AxisController

__all__ = ["controller_with", "machine_with"]


def machine_with(machine: Machine, values: Mapping[str, float]) -> Machine:
    """Return a machine with values [SI] of its own numbers, by dotted names such as ``axes.x.plant.gain``; others are left alone."""
    made = []
    for axis in machine.axes:
        parts = _slots(f"axes.{axis.name}.", values)
        made.append(replace(axis, **{slot: _changed(getattr(axis, slot), mine) for slot, mine in parts.items()}))
    return replace(machine, axes=tuple(made))


def controller_with(controller: Controller, values: Mapping[str, float], local: Sequence[str] = ()) -> Controller:
    """Return a controller with values [SI] in place of its own, by dotted names; `local` are those that move with their axis."""
    axes = {}
    for name, axis in controller.axes.items():
        parts = _slots(f"controller.axes.{name}.", values)
        changes: dict[str, Any] = {slot: _changed(getattr(axis, slot), mine) for slot, mine in parts.items() if slot != "others"}
        if "others" in parts:
            named = _slots("", parts["others"])
            changes["others"] = tuple((label, _changed(part, named.get(label, {}))) for label, part in axis.others)
        head = f"controller.axes.{name}."
        mine = tuple(dotted.removeprefix(head) for dotted in local if dotted.startswith(head))
        axes[name] = replace(axis, **changes, local=mine) if changes or mine else _plain(axis)
    shared = _slots("controller.", {name: value for name, value in values.items() if not name.startswith("controller.axes.")})
    return replace(controller, axes=axes, **{slot: _changed(getattr(controller, slot), mine) for slot, mine in shared.items()})


def _plain(axis: AxisController) -> AxisController:
    return replace(axis, local=())


def _slots(head: str, values: Mapping[str, float]) -> dict[str, dict[str, float]]:
    """Return values by slot and by what is left of their names."""
    found: dict[str, dict[str, float]] = {}
    for name, value in values.items():
        if name.startswith(head):
            slot, _, word = name.removeprefix(head).partition(".")
            found.setdefault(slot, {})[word] = value
    return found


def _changed(part: Component | None, values: Mapping[str, float]) -> Any:
    return part.replace(**values) if part is not None and values else part
