"""Write machines, controllers, axes and scenarios as TOML that reads back identical, in common units."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import partial
from pathlib import Path as File
from typing import Any

from contourlab.components.contract import Component
from contourlab.contours.reader import ContourOptions
from contourlab.errors import ParameterError, refuse
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.loop.machine import AXIS_SLOTS, CONTROLLER_SLOTS, NAMED_SLOTS
from contourlab.result.atomic import write_text_atomic
from contourlab.result.stamp import current, identity, stamp
from contourlab.scenario.build import SQUARENESS, parameters_of, units_of
from contourlab.scenario.files import BUILTIN, builtin_file, builtin_names
from contourlab.scenario.provenance import origin_table, with_origins
from contourlab.scenario.quantities import quantity
from contourlab.scenario.tables import keys_of, table_of, written
from contourlab.scenario.toml_text import Noted, toml
from contourlab.scenario.tree import DEFAULT
from contourlab.scenario.values import Case, Contour, Motion, Scenario


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
    ParameterError
        If an axis has only a stand-in for its plant, because the control's own file does not say how it answers.
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


def save(value: Machine | Controller | Axis | Scenario, file: str | File, machine: Machine | None = None) -> None:
    """Write a machine, a controller, an axis or a scenario that Python built as a file that the commands read.

    Parameters
    ----------
    value : Machine, Controller, Axis or Scenario
    file : str or Path
        A file that ends in ``.toml``; replaced if it exists.
    machine : Machine, optional
        Required with a controller: its commands set the units of the gains.

    Raises
    ------
    ParameterError
        If the value has no file of its own, a controller comes without its machine, or the file has another ending.
    OutputError
        If the file cannot be written.
    """
    refuse(File(file).suffix.lower() != ".toml", ParameterError, "file", repr(str(file)), "a file that ends in .toml")
    try:
        text = dump(value, machine)
    except TypeError as error:
        wanted = "a Machine, an Axis, a Scenario, or a Controller with its machine: save(controller, file, machine)"
        raise ParameterError("value", f"a {type(value).__name__}", wanted) from error
    parts = {type(value).__name__.lower(): identity(value)} if isinstance(value, Machine | Controller) else {}
    write_text_atomic(file, f"# {current(stamp(**parts))}\n\n{text}")


# --- tables --------------------------------------------------------------------------------------------------------------------------


def component_table(part: Component | None, units: tuple[str, str]) -> Any:
    """Return the table of a component; ``"none"`` for None."""
    if part is None:
        return {"kind": "none"}
    declared = parameters_of(type(part), units)
    table: dict[str, Any] = {"kind": Noted(part.kind, part.reference)}
    for name, value in part.values().items():
        if not (isinstance(value, float) and math.isinf(value)):  # only defaults are infinite; files leave them out
            shown = written(value, declared[name])
            if name in part.origins:
                shown = origin_table(shown, part.origins[name], partial(written, about=declared[name]))
            table[name] = Noted(shown, declared[name].source)
    return table


def axis_table(axis: Axis) -> dict[str, Any]:
    """Return the table of an axis."""
    units = units_of(axis.plant)
    placed = {"mounted_on": axis.mounted_on, "alignment": axis.alignment} if axis.mounted_on else {}
    table = with_origins(placed, axis.origins) | table_of(axis, defaults=False) | _correlations(axis)
    for slot in AXIS_SLOTS:
        part = getattr(axis, slot)
        if part is not None and (axis.plant.two_sided or not slot.startswith("motor_")):
            table[slot] = component_table(part, units)
    below = {"limits": table_of(axis.limits), "error": table_of(axis.error, defaults=False)}
    return table | {name: inner for name, inner in below.items() if inner}


def _correlations(part: Axis | Machine) -> dict[str, Any]:
    return {"correlations": [list(item) for item in part.correlations]} if part.correlations else {}


def machine_tables(machine: Machine) -> dict[str, Any]:
    """Return ``machine`` and ``axes``."""
    machine.check_modelled()
    table: dict[str, Any] = {**table_of(machine), "axes": list(machine.axis_names)}
    if machine.squareness:
        angles = {f"{a}-{b}": written(angle, SQUARENESS) for (a, b), angle in machine.squareness.items()}
        table["squareness"] = with_origins(angles, {k.removeprefix("squareness."): v for k, v in machine.origins.items()})
    return {"machine": table | _correlations(machine), "axes": {axis.name: axis_table(axis) for axis in machine.axes}}


def _axis_controller_table(part: AxisController, units: tuple[str, str]) -> dict[str, Any]:
    backlash = ("gap_observer", "compensation", "supervisor")
    kept = [slot for slot in reversed(CONTROLLER_SLOTS) if slot not in backlash or getattr(part, slot) is not None]
    table = {slot: component_table(getattr(part, slot), units) for slot in kept}
    for slot in NAMED_SLOTS:
        if named := getattr(part, slot):
            table[slot] = {label: component_table(other, units) for label, other in named}
    if part.link is not None:
        table["link"] = table_of(part.link) | {way: component_table(getattr(part.link, way), units) for way in ("down", "up")}
    return table_of(part, defaults=False) | table


def controller_table(controller: Controller, machine: Machine) -> dict[str, Any]:
    """Return ``controller``."""
    units = units_of(machine.axes[0].plant)
    table: dict[str, Any] = {slot: component_table(getattr(controller, slot), units) for slot in ("estimator", "coupling")}
    return table | {"axes": {axis.name: _axis_controller_table(controller.axes[axis.name], units_of(axis.plant)) for axis in machine.axes}}


def motion_table(motion: Motion) -> dict[str, Any]:
    """Return ``contour`` or ``program``."""
    if isinstance(motion, Contour):
        own = table_of(motion, defaults=False)
        if motion.file is not None:
            file = {"file": Noted(own.pop("file"), "; ".join(motion.reading.notes)[:200])}
            return {"contour": file | {k: written(v, keys_of(ContourOptions)[k].about) for k, v in motion.options.items()} | own}
        from contourlab.geometry import contour_parameters

        units = {key: unit for key, (_, unit) in contour_parameters(motion.name).items()}
        sizes = {k: quantity(v, units[k], "mm" if units[k] == "m" else units[k]) for k, v in motion.parameters.items()}
        return {"contour": {"name": motion.name, **sizes, **own}}
    table = table_of(motion) | table_of(motion.reading)
    return {"program": table | {"file": _file_name(motion.file), "fit": Noted(motion.fit, motion.note)}}


def _file_name(file: File) -> str:
    shipped = (BUILTIN + name for name in builtin_names() if builtin_file(name).resolve() == file.resolve())
    return next(shipped, file.resolve().as_posix())


def case_tables(case: Case) -> dict[str, Any]:
    """Return the tables of a case, without its motion."""
    run = table_of(case.run)
    if case.changes:
        run["changes"] = [table_of(change) for change in case.changes]
    tables = {
        **machine_tables(case.machine),
        "controller": controller_table(case.controller, case.machine),
        "feed": table_of(case.feed),
        "run": run,
    }
    if case.learning is not None:
        tables["learning"] = {"law": component_table(case.learning.law, units_of(case.machine.axes[0].plant)), **table_of(case.learning)}
    return tables


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
