"""Parameters of a machine and its controller by dotted name: set and order them, and find the axes they affect."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from contourlab.components.contract import Component
from contourlab.errors import ParameterError
from contourlab.loop import Axis, AxisController, Controller, Machine


def with_values(machine: Machine, controller: Controller, values: Mapping[str, float]) -> tuple[Machine, Controller]:
    """Set parameters of a machine and its controller to values [SI].

    Parameters of one component are set together, so that its checks see all of them. A parameter whose value does not change keeps its
    source.

    Raises
    ------
    ParameterError
        If a parameter is unknown, or a value out of range.
    """
    mine = {name: value for name, value in values.items() if name.startswith("axes.")}
    others = {name: value for name, value in values.items() if name not in mine}
    return machine_with(machine, mine), controller_with(controller, others)


def machine_with(machine: Machine, values: Mapping[str, float]) -> Machine:
    """Set parameters of a machine, such as ``axes.x.plant.gain``; see `with_values`."""
    axes: dict[str, Axis] = {axis.name: axis for axis in machine.axes}
    for head, numbers in _by_part(values).items():
        match head.split("."):
            case ["axes", axis, slot] if axis in axes:
                axes[axis] = _changed(axes[axis], slot, numbers)
            case _:
                raise _unknown(f"{head}.{next(iter(numbers))}")
    return replace(machine, axes=tuple(axes.values()))


def controller_with(controller: Controller, values: Mapping[str, float]) -> Controller:
    """Set parameters of a controller, such as ``controller.axes.x.controller.position_gain``; see `with_values`."""
    mine: dict[str, AxisController] = dict(controller.axes)
    for head, numbers in _by_part(values).items():
        match head.split("."):
            case ["controller", "axes", axis, slot, label] if axis in mine and f"{slot}.{label}" in mine[axis].parts:
                named = tuple((known, _with(part, numbers) if known == label else part) for known, part in getattr(mine[axis], slot))
                changed: dict[str, Any] = {slot: named}
                mine[axis] = replace(mine[axis], **changed)
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
    return ParameterError("parameter", repr(name), "a parameter of the machine or its controller")


def axes_of(name: str, machine: Machine) -> tuple[str, ...]:
    """Return the axes that a parameter affects: its own axis, or all axes for a parameter of the coupling."""
    words = name.split(".")
    return (words[words.index("axes") + 1],) if "axes" in words[:-1] else machine.axis_names


def calibration_order(machine: Machine, controller: Controller) -> tuple[str, ...]:
    """Return the dotted names of all parameters to calibrate, from the innermost loop to the outermost, feedforward last.

    Notes
    -----
    First the disturbance observers, then the position controllers, then a coupling that corrects commands, then feedforward; in each group
    the last axis comes first. For the paper's stage this is the paper's order (section IV): b_hat_3, a_hat_3, b_hat_2, a_hat_2, K_V3, K_P3,
    K_I3, K_V2, K_P2, K_I2, b'_3, a'_3, b'_2, a'_2. Its lambda, a choice between contour and tracking error, is not calibrated.

    A component names its parameters to calibrate in `calibrated` and `calibrated_ahead`.
    """
    axes = [(name, controller.axes[name]) for name in reversed(machine.axis_names)]
    names: list[str] = []

    def collect(prefix: str, part: Component | None, ahead: bool) -> None:
        if part is not None:
            names.extend(f"{prefix}.{name}" for name in (part.calibrated_ahead if ahead else part.calibrated))

    for slot in ("observer", "controller"):
        for name, axis in axes:
            collect(f"controller.axes.{name}.{slot}", getattr(axis, slot), False)
    if controller.coupling is not None and any(port.name == "correction" for port in controller.coupling.outputs):
        collect("controller.coupling", controller.coupling, False)
    for name, axis in axes:
        for slot in ("controller", "feedforward"):
            collect(f"controller.axes.{name}.{slot}", getattr(axis, slot), True)
    return tuple(names)
