"""The source of every number of a machine and its controller."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from contourlab.components.contract import Component
from contourlab.components.origin import Origin
from contourlab.loop import Axis, Controller, Machine
from contourlab.loop.machine import AXIS_SLOTS
from contourlab.rendering.judgement import Number


def stated(numbers: Iterable[Number]) -> tuple[Number, ...]:
    """Return the numbers whose source is stated."""
    return tuple(number for number in numbers if number.is_stated)


def numbers_of(machine: Machine, controller: Controller) -> tuple[Number, ...]:
    """Return the numbers of a machine, then those of its controller; a default only where its source is stated."""
    units = {axis.name: (axis.plant.command_unit, axis.plant.force_unit) for axis in machine.axes}
    first = units[machine.axis_names[0]]
    parts = [
        *((f"axes.{name}.{slot}", part, units[name]) for name in units for slot, part in controller.axes[name].parts.items()),
        *((slot, getattr(controller, slot), first) for slot in ("estimator", "coupling")),
    ]
    of_parts = (number for place, part, shown in parts for number in _component(f"controller.{place}", part, shown))
    return (*numbers_of_machine(machine), *of_parts)


def numbers_of_machine(machine: Machine) -> tuple[Number, ...]:
    """Return the numbers of a machine, as `numbers_of` does."""
    numbers = [_number("machine.servo_period", machine.servo_period, "s", "ms", machine.origins.get("servo_period"))]
    of_path = {"path_velocity": ("m/s", "mm/min"), "junction_deviation": ("m", "um"), "arc_tolerance": ("m", "um")}
    for name in filter(machine.origins.__contains__, of_path):
        numbers.append(_number(f"machine.{name}", getattr(machine, name), *of_path[name], machine.origins[name]))
    for pair, angle in machine.squareness.items():
        key = "squareness." + "-".join(pair)
        numbers.append(_number(f"machine.{key}", angle, "rad", "um/m", machine.origins.get(key)))
    return (*numbers, *(number for axis in machine.axes for number in _axis(axis, f"axes.{axis.name}.")))


def numbers_of_axis(axis: Axis) -> tuple[Number, ...]:
    """Return the numbers of one axis, named as in its own file."""
    return tuple(_axis(axis, ""))


def _axis(axis: Axis, head: str) -> Iterator[Number]:
    units = (axis.plant.command_unit, axis.plant.force_unit)
    if axis.stage_mass:
        yield _number(f"{head}stage_mass", axis.stage_mass, "kg", "kg", axis.origins.get("stage_mass"))
    for slot in AXIS_SLOTS:
        yield from _component(f"{head}{slot}", getattr(axis, slot), units, drawn=True)
    # Limits and error tables: only where a source is stated.
    shown = {"velocity": ("m/s", "mm/min"), "acceleration": ("m/s^2", "m/s^2"), "jerk": ("m/s^3", "m/s^3")}
    for name, origin in axis.limits.origins.items():
        unit, display = shown.get(name, ("m", "mm"))
        yield _number(f"{head}limits.{name}", getattr(axis.limits, name), unit, display, origin)
    for name, origin in axis.error.origins.items():
        value = getattr(axis.error, name)
        yield _number(f"{head}error.{name}", value if isinstance(value, float) else tuple(value.tolist()), "m", "um", origin)


def _component(head: str, part: Component | None, units: tuple[str, str], *, drawn: bool = False) -> Iterator[Number]:
    if part is None:
        return
    for name, value in part.values().items():
        parameter = part.parameters[name].for_plant(*units)
        origin = part.origins.get(name)
        if parameter.choices or (origin is None and value == parameter.default):
            continue
        varied = drawn and name in part.numeric() and not parameter.whole
        yield _number(f"{head}.{name}", value, parameter.unit, parameter.display, origin, varied)


def _number(name: str, value: float | tuple[float, ...], unit: str, display: str, origin: Origin | None, simulated: bool = False) -> Number:
    if origin is None:
        return Number(name, value, unit, display, simulated=simulated)
    drawn = simulated and origin.uncertain
    stated = (origin.source, origin.deviation, origin.span, origin.reference, origin.note)
    return Number(name, value, unit, display, *stated, drawn, simulated)
