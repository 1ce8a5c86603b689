"""Where every number of a machine and its controller is from."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from contourlab.components.contract import Component, Parameter
from contourlab.components.origin import Origin
from contourlab.loop import Axis, Controller, Machine
from contourlab.loop.machine import AXIS_SLOTS, CONTROLLER_SLOTS

NOT_STATED = "not stated"


@dataclass(frozen=True)
class Number:
    """A number, and where it is from.

    Attributes
    ----------
    name : str
        Dotted, as ``axes.x.plant.mass``.
    value : float or tuple of float
        In SI.
    unit, display : str
        In SI, and as people write it.
    origin : Origin or None
        None where nothing is stated.
    drawn : bool
        Whether it can differ from sample to sample: a number of the machine that is simulated. What a controller computes with is exactly
        what it was given, whatever that was worked out from.
    """

    name: str
    value: float | tuple[float, ...]
    unit: str
    display: str
    origin: Origin | None
    drawn: bool = False

    @property
    def source(self) -> str:
        """Where it is from, in a word."""
        return NOT_STATED if self.origin is None else self.origin.source


def numbers_of(machine: Machine, controller: Controller) -> tuple[Number, ...]:
    """Return every number with where it is from; those left at their defaults only where something is stated of them.

    Parameters
    ----------
    machine : Machine
    controller : Controller

    Returns
    -------
    tuple of Number
        Those of the machine first, then those of the controller.
    """
    found = [*numbers_of_machine(machine)]
    units = {axis.name: (axis.plant.command_unit, axis.plant.force_unit) for axis in machine.axes}
    first = units[machine.axis_names[0]]
    for name in machine.axis_names:
        mine = controller.axes[name]
        parts = {slot: getattr(mine, slot) for slot in CONTROLLER_SLOTS} | {f"others.{label}": part for label, part in mine.others}
        for slot, part in parts.items():
            found += _component(f"controller.axes.{name}.{slot}", part, units[name])
    for slot in ("estimator", "coupling"):
        found += _component(f"controller.{slot}", getattr(controller, slot), first)
    return tuple(found)


def numbers_of_machine(machine: Machine) -> tuple[Number, ...]:
    """Return the numbers of a machine, as `numbers_of` does."""
    return (*_machine(machine), *(number for axis in machine.axes for number in _axis(axis, f"axes.{axis.name}.")))


def numbers_of_axis(axis: Axis) -> tuple[Number, ...]:
    """Return the numbers of an axis by themselves, named as in its own file."""
    return tuple(_axis(axis, ""))


def _machine(machine: Machine) -> Iterator[Number]:
    yield Number("machine.servo_period", machine.servo_period, "s", "ms", machine.origins.get("servo_period"))
    for pair, angle in machine.squareness.items():
        key = "squareness." + "-".join(pair)
        yield Number(f"machine.{key}", angle, "rad", "um/m", machine.origins.get(key))


def _axis(axis: Axis, head: str) -> Iterator[Number]:
    units = (axis.plant.command_unit, axis.plant.force_unit)
    if axis.stage_mass:
        yield Number(f"{head}stage_mass", axis.stage_mass, "kg", "kg", axis.origins.get("stage_mass"))
    for slot in AXIS_SLOTS:
        yield from _component(f"{head}{slot}", getattr(axis, slot), units, drawn=True)
    # What is planned with and held against: told where something is stated.
    shown = {"velocity": ("m/s", "mm/min"), "acceleration": ("m/s^2", "m/s^2"), "jerk": ("m/s^3", "m/s^3")}
    for name, origin in axis.limits.origins.items():
        unit, display = shown.get(name, ("m", "mm"))
        yield Number(f"{head}limits.{name}", getattr(axis.limits, name), unit, display, origin)
    for name, origin in axis.error.origins.items():
        value = getattr(axis.error, name)
        yield Number(f"{head}error.{name}", value if isinstance(value, float) else tuple(value.tolist()), "m", "um", origin)


def _component(head: str, part: Component | None, units: tuple[str, str], *, drawn: bool = False) -> Iterator[Number]:
    if part is None:
        return
    for name, value in part.values().items():
        parameter: Parameter = part.parameters[name].for_plant(*units)
        origin = part.origins.get(name)
        if parameter.choices or (origin is None and value == parameter.default):
            continue
        varied = drawn and name in part.numeric() and not parameter.whole
        yield Number(f"{head}.{name}", value, parameter.unit, parameter.display, origin, varied)
