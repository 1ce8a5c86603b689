"""Build machines and controllers from checked tables."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import fields, replace
from functools import partial
from typing import Any

import numpy as np

from contourlab.components.contract import Component, Parameter
from contourlab.components.origin import Origin
from contourlab.components.plant.plant import Plant
from contourlab.components.registry import component, components
from contourlab.controls import ControlFile
from contourlab.errors import ComponentError, UnitError, hint, refuse
from contourlab.findings import finding
from contourlab.loop import Axis, AxisController, AxisError, Controller, Division, Limits, Machine
from contourlab.loop.machine import AXIS_SLOTS, CONTROLLER_SLOTS, NAMED_SLOTS
from contourlab.scenario.files import EVERY
from contourlab.scenario.provenance import bare, read_correlations, read_origins, without_origins
from contourlab.scenario.quantities import in_range, read_list, read_number
from contourlab.scenario.tables import keys_of, read_value, read_values, written
from contourlab.scenario.tree import DESIGNED, Leaf, Node, Table, located, same_table
from contourlab.units import Setting

WORKED_OUT = Origin("design", note="computed from gains = {...}")


def parameters_of(kind: type[Component], units: tuple[str, str]) -> dict[str, Parameter]:
    """Return the parameters of a component for a plant with these units of command and force."""
    return {name: parameter.for_plant(*units) for name, parameter in kind.parameters.items()}


def units_of(plant: Plant) -> tuple[str, str]:
    """Return the units of a plant's command and force."""
    return plant.command_unit, plant.force_unit


def _as_table(node: Node, family: str) -> Table:
    """Return the table of a component; ``drive = "saturation"`` is short for a table with that kind."""
    if isinstance(node, Table):
        return node
    if not isinstance(node.value, str):
        raise node.error(f'{node.value!r} is not a valid {family}: write a table with kind = "..." and parameters')
    return Table({"kind": node}, node.file, node.key)


def find_kind(table: Table, family: str) -> type[Component]:
    """Return the component that a table names."""
    node = table.get("kind")
    if not isinstance(node, Leaf) or not isinstance(node.value, str):
        names = ", ".join(kind.kind for kind in components(family))
        raise table.error(f"{'key kind is missing: ' if node is None else ''}write one of {names}", "" if node is None else "kind")
    try:
        return component(family, node.value)
    except ComponentError as error:
        raise node.error(str(error)) from None


def read_component(
    node: Node, family: str, units: tuple[str, str], *, optional: bool = False, given: Mapping[str, float] | None = None
) -> Any:
    """Read a component.

    Parameters
    ----------
    node : Node
        Table, or name of the kind.
    units : (str, str)
        Units of the plant's command and force.
    optional : bool
        Whether ``"none"`` is allowed.
    given : mapping, optional
        Computed values in SI; the table's own have priority.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    """
    table = _as_table(node, family)
    kind_node = table.get("kind")
    if optional and isinstance(kind_node, Leaf) and kind_node.value == "none":
        if extra := [name for name in table.entries if name != "kind"]:
            raise table.error('kind "none" has no parameters: delete this one', extra[0])
        return None
    kind = find_kind(table, family)
    own = table.without("kind")
    declared = parameters_of(kind, units)
    values = {**(given or {}), **read_parameters(kind.kind, declared, own, family)}
    origins = {name: WORKED_OUT for name in given or () if name not in own.entries} | read_origins(declared, own, values)
    _refuse_missing(kind.kind, declared, values, table)
    with located(table):
        return kind(**values).traced(origins)


def read_parameters(what: str, declared: Mapping[str, Parameter], table: Table, family: str = "") -> dict[str, Any]:
    """Read declared numbers and words in SI; the message about an unknown one names a component of `family` that has it.

    Raises
    ------
    ScenarioError
        If one is unknown, has the wrong unit, or is out of range.
    """
    values: dict[str, Any] = {}
    for name, node in table.entries.items():
        if name not in declared:
            raise table.error(f"{what} has no parameter {name!r}: {_elsewhere(family, name, table.entries) or hint(name, declared)}", name)
        with located(table, name):
            values[name] = _value(declared[name], bare(node).plain())
    return values


def _elsewhere(family: str, name: str, given: Collection[str]) -> str:
    """Return which component of a family has a parameter, and what to write for it; empty if there is none."""
    others = [kind for kind in components(family) if name in kind.parameters] if family else []
    if not others:
        return ""
    needed = {kind: [key for key, part in kind.parameters.items() if part.default is None and key not in given] for kind in others}
    kind = max(others, key=lambda kind: (len(kind.parameters.keys() & given), -len(needed[kind])))
    return f'{kind.kind} has it: write kind = "{kind.kind}"' + (f", and add {', '.join(needed[kind])}" if needed[kind] else "")


def _refuse_missing(what: str, declared: Mapping[str, Parameter], values: Mapping[str, Any], table: Table) -> None:
    missing = [name for name, parameter in declared.items() if parameter.default is None and name not in values]
    if missing:
        names = (f"{name} [{declared[name].display}]" if declared[name].display else name for name in missing)
        raise table.error(f"{what} needs values for {', '.join(names)}")


def _value(parameter: Parameter, given: Any) -> Any:
    if parameter.choices:
        refuse(not isinstance(given, str) or given not in parameter.choices, UnitError, f"{given!r}: must be {parameter.bound}")
        return given
    if parameter.vector:
        numbers = read_list(given, parameter.unit, parameter.display)
        refuse(not numbers and parameter.default != (), UnitError, "the list is empty: write at least one value")
        scalar = replace(parameter, vector=False)
        return tuple(in_range(number, scalar, f"item {i + 1}") for i, number in enumerate(numbers))
    return in_range(read_number(given, parameter.unit, parameter.display), parameter, repr(given))


SQUARENESS = Setting("rad", "um/m", -0.1, 0.1)
SUPERVISOR = "performance"
"""Default kind of a supervisor."""
_OPTIONAL = ("observer", "gap_observer", "compensation", "supervisor")


def build_axis(table: Table, name: str) -> Axis:
    """Return an axis from its table.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    """
    plain = read_values(table, Axis, needed=AXIS_SLOTS[:1], parts=(*AXIS_SLOTS[1:], "limits", "error", "correlations"))
    plant = read_component(table.entries["plant"], "plant", ("?", "?"))
    parts = _parts(table, AXIS_SLOTS[1:], units_of(plant), optional=("disturbance",))
    traced = {"plant": plant, **{slot: part for slot, part in parts.items() if part is not None}}
    return Axis(
        name=name,
        plant=plant,
        limits=_limits(table.table("limits")),
        error=_error(table.table("error")),
        correlations=read_correlations(table, traced, table.entries),
        **plain,
        **parts,
    )


def _parts(table: Table, slots: Sequence[str], units: tuple[str, str], optional: Sequence[str]) -> dict[str, Any]:
    """Return the components of a table by slot; None for ``"none"``."""
    return {
        slot: read_component(table.entries[slot], slot.removeprefix("motor_"), units, optional=slot in optional)
        for slot in slots
        if slot in table.entries
    }


def _limits(table: Table) -> Limits:
    limits = read_values(table, Limits)
    travel = limits.get("travel", 0.0)
    if isinstance(travel, tuple) and len(travel) != 2:
        raise table.error('write two positions, the lower one first: ["-100 mm", "100 mm"], or the length: "200 mm"', "travel")
    with located(table):
        return Limits(**limits, file=table.file)


def _error(table: Table) -> AxisError:
    plain = read_values(table, AxisError)
    position, lead_error = (np.array(plain.pop(name, ())) for name in ("position", "lead_error"))
    if lead_error.size != position.size:
        raise table.error(f"{lead_error.size} values for {position.size} positions: write one for each", "lead_error")
    refuse(np.any(np.diff(position) <= 0.0), table.error, "the positions must increase", "position")
    with located(table):
        return AxisError(position, lead_error, **plain)


def build_machine(part: Table, controls: Sequence[ControlFile] = ()) -> Machine:
    """Return a machine from its tables ``machine`` and ``axes``; `controls` are the files of a control from which a table may come.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    """
    table = part.table("machine")
    refuse("machine" not in part.entries, part.error, "key machine is missing: write [machine] with name, servo_period and axes")
    plain = read_values(table, Machine, needed=("name", "servo_period", "axes"), parts=("squareness", "correlations"))
    names = _axis_names(table)
    axes = part.table("axes")
    for name in axes.entries:
        if name not in names and name != EVERY:
            raise axes.error(f"axis {name!r} is not listed in machine.axes: {hint(name, names)}", name)
    if missing := [name for name in names if name not in axes.entries]:
        raise table.error("no table " + ", ".join(f"[{axes.at(name)}]" for name in missing) + ": write one for each axis", "axes")
    built = tuple(build_axis(axes.table(name), name) for name in names)
    for axis in built:
        if axis.mounted_on and axis.mounted_on not in names:
            raise axes.table(axis.name).error(f"no axis {axis.mounted_on!r}: {hint(axis.mounted_on, names)}", "mounted_on")
        refuse(axis.mounted_on == axis.name, axes.table(axis.name).error, "an axis cannot be mounted on itself", "mounted_on")
    angles, origins = without_origins(table.table("squareness"))
    plain["origins"] |= {f"squareness.{pair}": origin for pair, origin in origins.items()}
    with located(table):
        machine = Machine(**plain, axes=built, squareness=_squareness(angles, names), control=_control(part, controls))
    parts = {f"{axis.name}.{slot}": part for axis in built for slot in AXIS_SLOTS if isinstance(part := getattr(axis, slot), Component)}
    nodes = {f"{name}.{slot}": node for name in names for slot, node in axes.table(name).entries.items()}
    within = [(f"{axis.name}.{first}", f"{axis.name}.{second}", value) for axis in built for first, second, value in axis.correlations]
    return replace(machine, correlations=read_correlations(table, parts, nodes, within))


ANSWERS = ("CL984", "CL988")
"""Findings on how axes answer, of a control's own file."""


def _control(part: Table, controls: Sequence[ControlFile]) -> ControlFile | None:
    """Return the control's own file of a machine; an axis is modelled once it has a plant from elsewhere."""
    control = next((control for control in controls if str(control.file) == part.table("machine").file), None)
    if control is None:
        return None
    plants = {name: part.table("axes").table(name).table("plant").entries.values() for name in control.tables["axes"]}
    left = [name for name, nodes in plants.items() if all(node.file == str(control.file) for node in nodes)]
    unmodelled = {name: why for name, why in control.unmodelled.items() if name in left}
    findings = [
        finding(note.code, axes=axes, why=note.values["why"]) if note.code in ANSWERS else note
        for note in control.findings
        if (axes := [name for name in note.values.get("axes", ()) if name in left]) or note.code not in ANSWERS
    ]
    return replace(control, unmodelled=unmodelled, findings=tuple(findings))


def _axis_names(table: Table) -> list[str]:
    with located(table, "axes"):
        names = read_value(table.entries["axes"].plain(), (tuple[str, ...],), Setting(check=_axis_name))
    refuse(not 0 < len(names) <= 64, table.error, f"{len(names)} names: must not be empty, and have at most 64", "axes")
    if twice := [name for name in names if names.count(name) > 1]:
        raise table.error(f"axis {twice[0]!r} is listed twice: delete one", "axes")
    return list(names)


def _axis_name(text: str) -> str:
    refuse(not re.fullmatch(r"[A-Za-z0-9_]{1,32}", text), ValueError, f"{text!r:.80}: write a name of letters, digits and _")
    return text


def _squareness(table: Table, names: list[str]) -> dict[tuple[str, str], float]:
    squareness: dict[tuple[str, str], float] = {}
    for key, node in table.entries.items():
        pair = tuple(key.split("-"))
        if len(pair) != 2 or pair[0] == pair[1] or not set(pair) <= set(names):
            raise table.error('write two different axes of the machine, as in "x-y" = "20 um/m"', key)
        with located(table, key):
            angle = read_value(node.plain(), (float,), SQUARENESS)
        if (pair[1], pair[0]) in squareness:
            raise table.error(f'has the same axes as "{pair[1]}-{pair[0]}": delete one', key)
        squareness[pair[0], pair[1]] = angle
    return squareness


def build_controller(table: Table, machine: Machine) -> Controller:
    """Return a controller for a machine, whose commands set the units of the gains.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    """
    read_values(table, needed=("axes",), parts=("estimator", "coupling"))
    axes = table.table("axes")
    missing = [name for name in machine.axis_names if name not in axes.entries]
    others = [name for name in axes.entries if name not in machine.axis_names and name != EVERY]
    if missing and others:
        raise axes.error(f"the machine has no axis {others[0]!r}: {hint(others[0], missing)}", others[0])
    if missing:
        raise axes.error(f"no controller for axis {', '.join(missing)}: write [{axes.at(missing[0])}]")
    if others and any(getattr(axes.entries[name], "key", "").endswith(f'"{EVERY}"') for name in machine.axis_names):
        # Further axes belong to other machines. If an axis of this machine has no table of its own, a name is misspelt.
        raise axes.error(f"the machine has no axis {others[0]!r}: {hint(others[0], machine.axis_names)}", others[0])
    built = {name: _axis_controller(axes.table(name), machine, name) for name in machine.axis_names}
    parts = _parts(table, ("estimator", "coupling"), units_of(machine.axes[0].plant), ("estimator", "coupling"))
    if (check := getattr(parts.get("estimator"), "check_axes", None)) is not None:
        with located(table, "estimator"):
            check(len(machine.axes))
    with located(table, "coupling"):
        return Controller(built, **parts)


def _axis_controller(table: Table, machine: Machine, name: str) -> AxisController:
    slots = (*(slot for slot in CONTROLLER_SLOTS if slot != "controller"), *NAMED_SLOTS, "link")
    plain = read_values(table, AxisController, needed=("controller",), parts=slots)
    axis = machine.axis(name)
    units = units_of(axis.plant)
    supervisor = table.get("supervisor")
    if isinstance(supervisor, Table) and "kind" not in supervisor.entries:
        table = table.having(supervisor=supervisor.having(kind=Leaf(SUPERVISOR, supervisor.file, supervisor.at("kind"))))
    parts = _parts(table, ("predictor", "velocity", *_OPTIONAL), units, ("predictor", *_OPTIONAL))
    model = partial(model_of, machine, axis, parts.get("observer"))
    parts["controller"] = _position(table.entries["controller"], units, model)
    filters, others = table.table("filters"), table.table("others")
    parts["filters"] = _named(filters, lambda node: read_component(node, "filter", units, optional=True))
    for label, part in parts["filters"]:
        with located(filters, label):
            part.block(machine.servo_period)
    if "feedforward" in table.entries:
        parts["feedforward"] = _feedforward(table, units, parts, machine, axis)
    refuse("controller" in others.entries, others.error, "write another name: controller is the name of the first one", "controller")
    parts["others"] = _named(others, lambda node: _position(node, units, model))
    _check_local(plain.get("local", ()), parts, table)
    link = _link(table.entries["link"], units) if "link" in table.entries else None
    with located(table):
        return AxisController(link=link, **plain, **parts)


def _link(node: Node, units: tuple[str, str]) -> Division | None:
    """Return how an axis controller is divided between base and axis; None for ``link = "none"``."""
    if isinstance(node, Leaf):
        if node.value == "none":
            return None
        raise node.error(f'{node.value!r} is not a link: write a table with division = "...", and down and up')
    plain = read_values(node, Division, needed=("division",), parts=("down", "up"))
    ways = {way: read_component(node.entries[way], "link", units, optional=way == "up") for way in ("down", "up") if way in node.entries}
    with located(node):
        return Division(**plain, **ways)


def _named(table: Table, read: Callable[[Node], Component | None]) -> tuple[tuple[str, Component], ...]:
    """Return parts by name; ``NAME = "none"`` leaves one out."""
    for name in table.entries:
        refuse(not name.isidentifier(), table.error, "write a name of letters, digits and _", name)
    parts = {name: read(node) for name, node in table.entries.items()}
    return tuple((name, part) for name, part in parts.items() if part is not None)


def _feedforward(table: Table, units: tuple[str, str], parts: Mapping[str, Any], machine: Machine, axis: Axis) -> Component | None:
    """Return the feedforward of an axis; zero-phase tracking without coefficients is designed for the loop."""
    node = table.entries["feedforward"]
    plain = node.without("radius").plain() if isinstance(node, Table) else {"kind": node.value}
    if plain != {"kind": "zpetc"}:
        feedforward: Component | None = read_component(node, "feedforward", units, optional=True)
        return feedforward
    from contourlab.analysis.linear.sampled_loop import sampled_loop
    from contourlab.analysis.linear.zpetc import zpetc_design

    given = {}
    if isinstance(node, Table) and "radius" in node.entries:
        with located(node, "radius"):
            given["radius"] = read_value(node.entries["radius"].plain(), (float,), Setting(minimum=0.0, maximum=1.0, exclusive=True))
    with located(table, "feedforward"):
        loop = sampled_loop(axis, AxisController(**parts), machine.servo_period, machine.carried_mass(axis.name))
        return zpetc_design(loop, **given)


def _check_local(names: Sequence[str], parts: Mapping[str, Any], table: Table) -> None:
    """Check the names of parameters that move with an axis, such as ``observer.model_gain``."""
    slots = {**parts, **{f"{slot}.{label}": part for slot in NAMED_SLOTS for label, part in parts.get(slot, ())}}
    known = [f"{slot}.{name}" for slot, part in slots.items() if isinstance(part, Component) for name in part.numeric()]
    for name in names:
        if name not in known:
            raise table.error(f"no parameter {name!r} in this axis' controller: {hint(name, known)}", "local")


def model_of(machine: Machine, axis: Axis, observer: Component | None) -> tuple[float, float]:
    """Return gain and damping of the plant in the position loop, for pole placement: of the observer's model, else of the loaded plant."""
    values = {} if observer is None else observer.values()
    if {"model_gain", "model_damping"} <= set(values):
        return values["model_gain"], values["model_damping"]
    model: tuple[float, float] = machine.loaded_plant(axis.name).rigid_model()
    return model


def _position(node: Node, units: tuple[str, str], model: Callable[[], tuple[float, float]]) -> Any:
    if isinstance(node, Leaf) or "gains" not in node.entries:
        return read_component(node, "controller", units)
    kind = find_kind(node, "controller")
    refuse(not kind.wishes, node.error, f"{kind.kind} cannot compute its gains: write the gains themselves", "gains")
    gains = node.table("gains")
    if both := [name for name in DESIGNED if name in node.entries and same_table(node.entries[name], gains)]:
        raise node.error("gains = {...} computes this value: delete one of the two", both[0])
    wishes = {name: replace(parameter, name=name).for_plant(*units) for name, parameter in kind.wishes.items()}
    wanted = read_parameters(f"gains of {kind.kind}", wishes, gains)
    _refuse_missing(f"gains = {{...}} of {kind.kind}", wishes, wanted, gains)
    rest = node.without("gains")
    own = read_parameters(kind.kind, parameters_of(kind, units), rest.only(*{"model_gain", "model_damping"} & set(kind.parameters)))
    with located(gains):
        defaults = {name: parameter.default for name, parameter in wishes.items()}
        gain, damping = model()
        placed = kind.designed(defaults | wanted, float(own.get("model_gain", gain)), float(own.get("model_damping", damping)))
    return read_component(rest, "controller", units, given=placed)


def in_place(table: Table, module: Axis, place: Axis) -> tuple[Axis, str]:
    """Return a module in the place of an axis, and a note on what it takes over or lacks.

    Stage mass, limits and substeps missing from the module's file are taken over. Components and errors are not.

    Parameters
    ----------
    table : Table
        Content of the module's file.
    module : Axis
        Built from `table`.
    place : Axis
        The axis that it replaces.
    """
    kept, axis_names = _taken_over(table, module, place, ("stage_mass", "substeps"))
    limits, limit_names = _taken_over(table.table("limits"), module.limits, place.limits, keys_of(Limits))
    names = [f"{name}, {written(getattr(place, name), keys_of(Axis)[name].about)}" for name in axis_names]
    names += [f"limits.{name}" for name in limit_names]
    notes = ["; ".join(names) + " (kept from the replaced axis)"] if names else []
    lost = [slot for slot in AXIS_SLOTS[1:] if slot not in table.entries and getattr(module, slot) != getattr(place, slot)]
    if "error" not in table.entries and (place.error.position.size or place.error.repeatability or place.error.backlash):
        lost.append("error")
    if lost:
        notes.append(", ".join(lost) + " (absent; the replaced axis has it)")
    return replace(kept, limits=limits), "; ".join(notes)


def _taken_over(table: Table, own: Any, replaced: Any, names: Iterable[str]) -> tuple[Any, list[str]]:
    """Return a part with the values of a replaced one, and their origins, that its table leaves out; and the names of these."""
    defaults = {field.name: field.default for field in fields(own)}
    taken = [name for name in names if name not in table.entries and getattr(replaced, name) != defaults[name]]
    origins = {name: replaced.origins[name] for name in taken if name in replaced.origins}
    return replace(own, **{name: getattr(replaced, name) for name in taken}, origins={**own.origins, **origins}), taken
