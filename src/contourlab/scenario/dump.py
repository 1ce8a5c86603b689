"""Write machines, controllers, axes and scenarios as TOML that reads back identical, in common units."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import fields
from functools import partial
from pathlib import Path as File
from typing import Any

from contourlab.components.contract import Component, Parameter
from contourlab.loop import Axis, AxisController, AxisError, Controller, Limits, Machine
from contourlab.loop.machine import AXIS_SLOTS, CONTROLLER_SLOTS, NAMED_SLOTS
from contourlab.scenario.case import Case, Scenario
from contourlab.scenario.components import parameters_of
from contourlab.scenario.files import BUILTIN, builtin_file, builtin_names
from contourlab.scenario.provenance import origin_table, written
from contourlab.scenario.toml_text import Noted, toml
from contourlab.scenario.tree import DEFAULT
from contourlab.scenario.values import Contour, LearningSettings, Motion
from contourlab.units import from_si, to_si

_LIMITS = {"velocity": ("m/s", "mm/min"), "acceleration": ("m/s^2", ""), "jerk": ("m/s^3", ""), "following_error": ("m", "mm")}
_UNITS = dict.fromkeys(("tolerance", "corner_tolerance", "merge_tolerance"), ("m", "um")) | {
    "feedrate": ("m/s", "mm/min"),
    "frequency": ("Hz", ""),
    "corner_angle": ("rad", "deg"),
}
"""Unit and display unit of the settings that have one."""


def quantity(value: float, unit: str, display: str = "") -> str | float:
    """Write an SI value in its display unit if that reads back exactly, else in SI.

    >>> quantity(0.02, "m", "mm")
    '20 mm'
    """
    if not unit:
        return value
    for shown in dict.fromkeys((display or unit, unit)):
        number = from_si(value, shown)
        for digits in (6, 9, 12, 15, 17):
            text = f"{number:.{digits}g} {shown}"
            if to_si(text, unit) == value:
                return text
    return f"{value!r} {unit}"


def dump(value: Machine | Controller | Axis | Scenario, machine: Machine | None = None) -> str:
    """Return a machine, a controller, an axis or a scenario as TOML.

    Parameters
    ----------
    value : Machine, Controller, Axis or Scenario
        The file of an axis does not hold its name.
    machine : Machine, optional
        Required with a controller: its commands set the units of the gains.

    Returns
    -------
    str
        All finite parameters, so that changed defaults have no effect. A scenario is one file: included files are merged in, gains are
        computed, and schemes hold their differences from the base. A part program is named by its path.

    Raises
    ------
    TypeError
        If the value is of another type, or a controller comes without its machine.
    """
    if isinstance(value, Controller):
        if machine is None:
            raise TypeError("dump(controller, machine): the machine sets the units of the gains")
        return toml({"controller": controller_table(value, machine)})
    if isinstance(value, Axis):
        return toml(axis_table(value))
    if isinstance(value, Machine):
        return toml(machine_tables(value))
    if not isinstance(value, Scenario):
        raise TypeError(f"{type(value).__name__} has no file of its own")
    base = case_tables(value.base)
    content: dict[str, Any] = {"name": value.name, **motion_table(value.motion), **base}
    schemes = {case.name: difference(base, case_tables(case)) for case in value.all_cases}
    return toml(content | ({"schemes": schemes} if schemes else {}))


# --- tables --------------------------------------------------------------------------------------------------------------------------


def _value(parameter: Parameter, value: Any) -> Any:
    if parameter.choices:
        return value
    if parameter.vector:
        return [quantity(item, parameter.unit, parameter.display) for item in value]
    if parameter.whole:
        return int(value)
    return quantity(value, parameter.unit, parameter.display)


def component_table(part: Component | None, units: tuple[str, str]) -> Any:
    """Return the table of a component; ``"none"`` for None."""
    if part is None:
        return {"kind": "none"}
    declared = parameters_of(type(part), units)
    table: dict[str, Any] = {"kind": Noted(part.kind, part.reference)}
    for name, value in part.values().items():
        if not (isinstance(value, float) and math.isinf(value)):  # only defaults are infinite; files leave them out
            shown = _value(declared[name], value)
            if name in part.origins:
                shown = origin_table(shown, part.origins[name], partial(_value, declared[name]))
            table[name] = Noted(shown, declared[name].source)
    return table


def _limits_table(limits: Limits) -> dict[str, Any]:
    table: dict[str, Any] = {
        name: quantity(getattr(limits, name), *units) for name, units in _LIMITS.items() if math.isfinite(getattr(limits, name))
    }
    if all(map(math.isfinite, limits.ends)):
        table["travel"] = [quantity(x, "m", "mm") for x in limits.ends]
    elif math.isfinite(limits.extent):
        table["travel"] = quantity(limits.extent, "m", "mm")
    return written(table, limits.origins)


def _error_table(error: AxisError) -> dict[str, Any]:
    table: dict[str, Any] = {}
    if error.position.size:
        table["position"] = [quantity(float(x), "m", "mm") for x in error.position]
        table["lead_error"] = [quantity(float(x), "m", "um") for x in error.lead_error]
    if error.repeatability:
        table["repeatability"] = quantity(error.repeatability, "m", "um")
    return written(table, error.origins)


def _units(axis: Axis) -> tuple[str, str]:
    return axis.plant.command_unit, axis.plant.force_unit


def axis_table(axis: Axis) -> dict[str, Any]:
    """Return the table of an axis."""
    units = _units(axis)
    table: dict[str, Any] = {}
    if axis.mounted_on:
        table |= {"mounted_on": axis.mounted_on, "alignment": axis.alignment}
    if axis.stage_mass:
        table["stage_mass"] = quantity(axis.stage_mass, "kg")
    if axis.substeps != 1:
        table["substeps"] = axis.substeps
    if axis.correlations:
        table["correlations"] = [list(item) for item in axis.correlations]
    table = written(table, axis.origins)
    for slot in AXIS_SLOTS:
        part = getattr(axis, slot)
        if part is not None and (axis.plant.two_sided or not slot.startswith("motor_")):
            table[slot] = component_table(part, units)
    below = {"limits": _limits_table(axis.limits), "error": _error_table(axis.error)}
    return table | {name: inner for name, inner in below.items() if inner}


def machine_tables(machine: Machine) -> dict[str, Any]:
    """Return ``machine`` and ``axes``."""
    table: dict[str, Any] = {
        "name": machine.name,
        "servo_period": quantity(machine.servo_period, "s", "ms"),
        "axes": list(machine.axis_names),
    }
    if machine.squareness:
        angles = {f"{a}-{b}": quantity(angle, "rad", "um/m") for (a, b), angle in machine.squareness.items()}
        table["squareness"] = written(angles, {k.removeprefix("squareness."): v for k, v in machine.origins.items()})
    if machine.correlations:
        table["correlations"] = [list(item) for item in machine.correlations]
    table = written(table, machine.origins)
    return {"machine": table, "axes": {axis.name: axis_table(axis) for axis in machine.axes}}


def _axis_controller_table(part: AxisController, units: tuple[str, str]) -> dict[str, Any]:
    backlash = ("gap_observer", "compensation", "supervisor")
    kept = [slot for slot in reversed(CONTROLLER_SLOTS) if slot not in backlash or getattr(part, slot) is not None]
    table = {slot: component_table(getattr(part, slot), units) for slot in kept}
    for slot in NAMED_SLOTS:
        if named := getattr(part, slot):
            table[slot] = {label: component_table(other, units) for label, other in named}
    encoders = {name: getattr(part, name) for name in ("feedback", "velocity_feedback")}
    plain = {name: value for name, value in encoders.items() if value != getattr(AxisController, name)}
    if part.link is not None:
        ways = {way: component_table(getattr(part.link, way), units) for way in ("down", "up")}
        table["link"] = {"division": part.link.division, **ways}
    return {**({"local": list(part.local)} if part.local else {}), **plain, **table}


def controller_table(controller: Controller, machine: Machine) -> dict[str, Any]:
    """Return ``controller``."""
    units = _units(machine.axes[0])
    table: dict[str, Any] = {slot: component_table(getattr(controller, slot), units) for slot in ("estimator", "coupling")}
    return table | {"axes": {axis.name: _axis_controller_table(controller.axes[axis.name], _units(axis)) for axis in machine.axes}}


def motion_table(motion: Motion) -> dict[str, Any]:
    """Return ``contour`` or ``program``."""
    if isinstance(motion, Contour):
        offset = {"offset": [quantity(v, "m", "mm") for v in motion.offset]} if motion.offset else {}
        if motion.file is not None:
            table: dict[str, Any] = {"file": Noted(motion.file.resolve().as_posix(), "; ".join(motion.reading.notes)[:200])}
            options = {k: quantity(v, *_UNITS[k]) if k in _UNITS else v for k, v in motion.options.items()}
            return {"contour": table | options | offset}
        from contourlab.geometry import contour_parameters

        units = {key: unit for key, (_, unit) in contour_parameters(motion.name).items()}
        sizes = {k: quantity(v, units[k], "mm" if units[k] == "m" else units[k]) for k, v in motion.parameters.items()}
        return {"contour": {"name": motion.name, **sizes, **offset}}
    reading = motion.reading
    table = {
        "file": _file_name(motion.file),
        "letters": list(motion.letters),
        "require_end": reading.require_end,
        "dialect": reading.dialect,
        "block_delete": reading.block_delete,
        "most_moves": reading.most_moves,
        "fit": Noted(motion.fit, motion.note),
    }
    if reading.tools is not None:
        table["tools"] = File(reading.tools).resolve().as_posix()
    return {"program": table}


def _file_name(file: File) -> str:
    shipped = (BUILTIN + name for name in builtin_names() if builtin_file(name).resolve() == file.resolve())
    return next(shipped, file.resolve().as_posix())


def case_tables(case: Case) -> dict[str, Any]:
    """Return the tables of a case, without its motion."""

    def settings(value: Any) -> dict[str, Any]:
        given = {f.name: getattr(value, f.name) for f in fields(value) if getattr(value, f.name) is not None}
        return {k: quantity(v, *_UNITS[k]) if k in _UNITS else list(v) if isinstance(v, tuple) else v for k, v in given.items()}

    run = settings(case.run)
    if case.changes:
        run["changes"] = [
            {"at": quantity(change.time, "s"), "controller": change.file, "handover_time": quantity(change.handover_time, "s", "ms")}
            for change in case.changes
        ]
    learning = {} if case.learning is None else {"learning": learning_table(case.learning, case.machine)}
    return {
        **machine_tables(case.machine),
        "controller": controller_table(case.controller, case.machine),
        "feed": settings(case.feed),
        "run": run,
        **learning,
    }


def learning_table(learning: LearningSettings, machine: Machine) -> dict[str, Any]:
    """Return ``learning``."""
    table: dict[str, Any] = {name: getattr(learning, name) for name in ("trials", "improvement", "patience")}
    if learning.table is not None:
        table["table"] = learning.table.resolve().as_posix()
    return {"law": component_table(learning.law, _units(machine.axes[0])), **table}


def difference(base: Mapping[str, Any], other: Mapping[str, Any]) -> dict[str, Any]:
    """Return the overrides that turn `base` into `other`; keys missing from `other` are reset, learning by its law."""
    changed: dict[str, Any] = {name: {"law": "none"} if name == "learning" else DEFAULT for name in base if name not in other}
    for name, value in other.items():
        old = base.get(name)
        if isinstance(value, Mapping) and isinstance(old, Mapping) and value.get("kind") == old.get("kind"):
            inner = difference(old, value)
            changed |= {name: inner} if inner else {}
        elif name not in base or value != old:
            changed[name] = value
    return changed
