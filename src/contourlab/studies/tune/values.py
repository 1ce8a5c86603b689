"""A machine and its controller with numbers in place of theirs, by dotted names."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from contourlab.errors import ParameterError
from contourlab.loop import Axis, AxisController, Controller, Machine

__all__ = ["axes_of", "with_values"]


def with_values(machine: Machine, controller: Controller, values: Mapping[str, float]) -> tuple[Machine, Controller]:
    """Return machine and controller with values [SI] by the names of `contourlab.loop.parameter_names`.

    Raises
    ------
    ParameterError
        If there is no such number, or a value is out of range.
    """
    axes: dict[str, Axis] = {axis.name: axis for axis in machine.axes}
    mine: dict[str, AxisController] = dict(controller.axes)
    for name, value in values.items():
        head, _, word = name.rpartition(".")
        match head.split("."):
            case ["axes", axis, slot] if axis in axes:
                axes[axis] = _changed(axes[axis], slot, word, value)
            case ["controller", "axes", axis, "others", label] if axis in mine:
                others = tuple((known, part.replace(**{word: value}) if known == label else part) for known, part in mine[axis].others)
                mine[axis] = replace(mine[axis], others=others)
            case ["controller", "axes", axis, slot] if axis in mine:
                mine[axis] = _changed(mine[axis], slot, word, value)
            case ["controller", slot]:
                controller = _changed(controller, slot, word, value)
            case _:
                raise ParameterError("parameter", repr(name), "a number of the machine or its controller")
    return replace(machine, axes=tuple(axes.values())), replace(controller, axes=mine)


def _changed(owner: Any, slot: str, word: str, value: float) -> Any:
    part = getattr(owner, slot, None)
    if part is None or word not in part.parameters:
        raise ParameterError("parameter", repr(f"{slot}.{word}"), "a number of the machine or its controller")
    if getattr(part, word) == value:
        return owner  # where the number is from stays said
    return replace(owner, **{slot: part.replace(**{word: value})})


def axes_of(name: str, machine: Machine) -> tuple[str, ...]:
    """Return the axes that a number has to do with: its own, or all where it belongs to what couples them."""
    words = name.split(".")
    return (words[words.index("axes") + 1],) if "axes" in words[:-1] else machine.axis_names
