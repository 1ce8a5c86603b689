"""The parameters of a machine and its controller by dotted name: list them, find them, set them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from difflib import SequenceMatcher, get_close_matches
from typing import Any, TypeAlias

from contourlab.components.contract import Component, Parameter
from contourlab.errors import ParameterError
from contourlab.loop.machine import AXIS_SLOTS, Controller, Machine

Known: TypeAlias = dict[str, tuple[Component, str]]
"""Component and name of each parameter, by dotted name."""
MOST_NAMES = 8
"""Largest number of names suggested for an unknown name."""


def parameters_of(machine: Machine, controller: Controller) -> Known:
    """Return every parameter that a batch can vary.

    Names read ``axes.x.plant.gain``, ``controller.axes.x.observer.bandwidth``, ``controller.coupling.weight``.
    """
    parts: dict[str, Any] = {}
    for axis in machine.axes:
        own = controller.axes[axis.name]
        parts |= {f"axes.{axis.name}.{slot}": getattr(axis, slot) for slot in AXIS_SLOTS}
        parts |= {f"controller.axes.{axis.name}.{slot}": part for slot, part in own.parts.items()}
        parts |= {f"controller.axes.{axis.name}.link.{way}": getattr(own.link, way, None) for way in ("down", "up")}
    parts |= {"controller.estimator": controller.estimator, "controller.coupling": controller.coupling}
    return {f"{prefix}.{name}": (part, name) for prefix, part in parts.items() if part is not None for name in part.numeric()}


def parameter_names(machine: Machine, controller: Controller) -> dict[str, str]:
    """Return the SI unit of every parameter that a batch can vary, by dotted name; "" without a unit.

    Parameters
    ----------
    machine : Machine
    controller : Controller

    Returns
    -------
    dict of str to str
        Units such as ``"kg"``, by names such as ``axes.x.plant.mass`` and ``controller.axes.x.observer.bandwidth``.

    >>> from contourlab import load_scenario
    >>> case = load_scenario("builtin:demo-part").base
    >>> parameter_names(case.machine, case.controller)["axes.x.plant.mass"]
    'kg'
    """
    return {name: declared(machine, name, *known).unit for name, known in parameters_of(machine, controller).items()}


def declared(machine: Machine, name: str, part: Component, parameter: str) -> Parameter:
    """Return a parameter as declared; commands and forces have the units of the plant of its axis."""
    axis = next((axis for axis in machine.axes if f".axes.{axis.name}." in f".{name}"), machine.axes[0])
    return part.parameters[parameter].for_plant(axis.plant.command_unit, axis.plant.force_unit)


def fits(name: str, wanted: str) -> bool:
    """Tell whether a text means a parameter: its dotted name or the end of it, with ``*`` for anything.

    The slot ``controller`` may be left out: ``3.position_gain`` is ``controller.axes.3.controller.position_gain``. What begins with
    ``axes.`` is a parameter of the machine.
    """
    pattern = ("" if wanted.startswith("axes.") else r"(.*\.)?") + ".*".join(map(re.escape, wanted.split("*")))
    return any(re.fullmatch(pattern, written) for written in (name, name.replace(".controller.", ".")))


def meant(wanted: str, known: Mapping[str, Any]) -> list[str]:
    """Return the dotted names that a text means, as `fits` tells; a text that is one of them means that one."""
    return [wanted] if wanted in known else [name for name in known if fits(name, wanted)]


def matching(wanted: str, known: Mapping[str, Any], called: str, whose: str = "the machine or its controller") -> list[str]:
    """Return the dotted names that a text means, as `meant`.

    Raises
    ------
    ParameterError
        If it matches none; names the nearest.
    """
    found = meant(wanted, known)
    if not found:
        raise ParameterError(called, repr(wanted), f"a parameter of {whose}, such as {', '.join(_near(wanted, known))}")
    return found


def _near(wanted: str, known: Iterable[str]) -> list[str]:
    """Return the names most like an unknown name: with its last word, a similar one, or one that has it; or else the first few.

    For a pattern they are patterns, of all axes.
    """
    names = sorted(known, key=lambda name: name.startswith("axes."))  # gains first
    if "*" in wanted:
        names = list(dict.fromkeys(re.sub(r"\baxes\.[^.]+", "axes.*", name) for name in names))
    ends = {name: name.rpartition(".")[2] for name in names}
    word = wanted.rpartition(".")[2]
    alike = [word, *get_close_matches(word, dict.fromkeys(ends.values()), n=3)]
    found = [name for name in names if ends[name] in alike] or [name for name in names if word and word in ends[name]]
    return sorted(found, key=lambda name: SequenceMatcher(None, wanted, name).ratio(), reverse=True)[:MOST_NAMES] or names[:MOST_NAMES]


def with_values(machine: Machine, controller: Controller, values: Mapping[str, float]) -> tuple[Machine, Controller]:
    """Set parameters of a machine and its controller.

    Parameters
    ----------
    machine : Machine
    controller : Controller
    values : mapping of str to float
        Values [SI] by the names of `contourlab.loop.simulate_batch`. Parameters of one component are set together, so that its checks see
        all of them. A parameter whose value does not change keeps its source.

    Returns
    -------
    machine : Machine
    controller : Controller

    Raises
    ------
    ParameterError
        If a name is unknown, or a value out of range.

    >>> from contourlab import load_scenario
    >>> case = load_scenario("builtin:demo-part").base
    >>> machine, controller = with_values(case.machine, case.controller, {"axes.*.plant.mass": 90.0})
    >>> [axis.plant.mass for axis in machine.axes]
    [90.0, 90.0, 90.0]
    """
    known = parameters_of(machine, controller)
    changes: dict[str, dict[str, float]] = {}
    for wanted, value in values.items():
        for name in matching(wanted, known, "parameter"):
            part, word = known[name]
            if getattr(part, word) != value:
                changes.setdefault(name.removesuffix(f".{word}"), {})[word] = value
    for place, new in changes.items():
        part = known[f"{place}.{next(iter(new))}"][0].replace(**new)
        if place.startswith("axes."):
            machine = _put(machine, place.split("."), part)
        else:
            controller = _put(controller, place.split(".")[1:], part)
    return machine, controller


def _put(owner: Any, place: Sequence[str], part: Component) -> Any:
    """Return a copy of a value with a component put in its place in it."""
    if not place:
        return part
    word, *rest = place
    if isinstance(owner, Mapping):
        return {**owner, word: _put(owner[word], rest, part)}
    if isinstance(owner, tuple) and isinstance(owner[0], tuple):  # components by label
        return tuple((dict(owner) | {word: part}).items())
    if isinstance(owner, tuple):  # axes by name
        return tuple(_put(axis, rest, part) if axis.name == word else axis for axis in owner)
    return replace(owner, **{word: _put(getattr(owner, word), rest, part)})
