"""A machine and its controller with numbers in place of theirs, by the names of `contourlab.loop.parameter_names`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from contourlab.components.contract import Component
from contourlab.errors import ParameterError
from contourlab.loop import Axis, AxisController, Controller, Machine


def with_values(machine: Machine, controller: Controller, values: Mapping[str, float]) -> tuple[Machine, Controller]:
    """Return machine and controller with values [SI] in place of theirs.

    Numbers of one part are changed together, so that what holds between them holds all the way; a number that stays as it is keeps what is
    said of where it is from.

    Raises
    ------
    ParameterError
        If there is no such number, or a value is out of range.
    """
    mine = {name: value for name, value in values.items() if name.startswith("axes.")}
    others = {name: value for name, value in values.items() if name not in mine}
    return machine_with(machine, mine), controller_with(controller, others)


def machine_with(machine: Machine, values: Mapping[str, float]) -> Machine:
    """Return a machine with values of numbers such as ``axes.x.plant.gain``; see `with_values`."""
    axes: dict[str, Axis] = {axis.name: axis for axis in machine.axes}
    for head, numbers in _by_part(values).items():
        match head.split("."):
            case ["axes", axis, slot] if axis in axes:
                axes[axis] = _changed(axes[axis], slot, numbers)
            case _:
                raise _unknown(f"{head}.{next(iter(numbers))}")
    return replace(machine, axes=tuple(axes.values()))


def controller_with(controller: Controller, values: Mapping[str, float]) -> Controller:
    """Return a controller with values of numbers such as ``controller.axes.x.controller.position_gain``; see `with_values`."""
    mine: dict[str, AxisController] = dict(controller.axes)
    for head, numbers in _by_part(values).items():
        match head.split("."):
            case ["controller", "axes", axis, "others", label] if axis in mine and label in dict(mine[axis].others):
                others = tuple((known, _with(part, numbers) if known == label else part) for known, part in mine[axis].others)
                mine[axis] = replace(mine[axis], others=others)
            case ["controller", "axes", axis, slot] if axis in mine:
                mine[axis] = _changed(mine[axis], slot, numbers)
            case ["controller", slot]:
                controller = _changed(controller, slot, numbers)
            case _:
                raise _unknown(f"{head}.{next(iter(numbers))}")
    return replace(controller, axes=mine)


def _by_part(values: Mapping[str, float]) -> dict[str, dict[str, float]]:
    found: dict[str, dict[str, float]] = {}
    for name, value in values.items():
        head, _, word = name.rpartition(".")
        found.setdefault(head, {})[word] = value
    return found


def _changed(owner: Any, slot: str, numbers: Mapping[str, float]) -> Any:
    part = getattr(owner, slot, None)
    if not isinstance(part, Component):
        raise _unknown(f"{slot}.{next(iter(numbers))}")
    made = _with(part, numbers)
    return owner if made is part else replace(owner, **{slot: made})


def _with(part: Component, numbers: Mapping[str, float]) -> Component:
    for word in numbers:
        if word not in part.parameters:
            raise _unknown(f"{part.kind}.{word}")
    new = {word: value for word, value in numbers.items() if getattr(part, word) != value}
    made: Component = part.replace(**new) if new else part
    return made


def _unknown(name: str) -> ParameterError:
    return ParameterError("parameter", repr(name), "a number of the machine or its controller")
