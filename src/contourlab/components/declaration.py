"""Check what a component class declares, against the table of its family, before anything of it runs."""

from __future__ import annotations

import dataclasses
import importlib
import inspect
import math
import re
from typing import Any

from contourlab.components.contract import Component, Parameter, fault
from contourlab.components.families import FAMILY, Form, size_of
from contourlab.engine.step import Port
from contourlab.errors import ComponentError, ContourlabError, UnitError
from contourlab.units import in_si, same_dimension

OF_A_TYPE = (
    *("reference", "example", "ring", "states", "inputs", "outputs", "derived", "tables"),
    *("unbounded", "without_effect", "calibrated", "calibrated_ahead"),
)
"""Attributes of a class that must have the type that `Component` gives them."""

UNWIRED = {("velocity", "true")}
"""Ideal parts with ports of their own; the loop runs no node for them."""


# --- what a run needs


def check_class(kind: type[Component]) -> None:
    """Check what a class needs for a run: family, kind, ports, base class, methods.

    Raises
    ------
    ComponentError
        With file, line and class.
    """
    if not (isinstance(kind, type) and issubclass(kind, Component) and kind.kind):
        raise ComponentError(f"{kind!r} is not a component: write a class with family and kind")
    if kind.family not in FAMILY:
        raise fault(kind, f"family {kind.family!r} is not one of {', '.join(FAMILY)}")
    if not isinstance(kind.kind, str) or not re.fullmatch(r"\w[\w.-]*", kind.kind):
        raise fault(kind, f"kind = {kind.kind!r} is not a name: write letters, digits and hyphens")
    if dataclasses.is_dataclass(kind):
        raise fault(kind, "is a dataclass: leave the decorator out, because Component makes the parameters")
    _check_attributes(kind)
    _check_names(kind)
    _check_form(kind, form_of(kind))
    _check_ports(kind)


def _check_attributes(kind: type[Component]) -> None:
    for name in OF_A_TYPE:
        value, wanted = getattr(kind, name), type(getattr(Component, name))
        if not isinstance(value, wanted):
            cure = ": write (one, two) or (one,)" if wanted is tuple else ""
            raise fault(kind, f"{name} = {value!r} is not a {wanted.__name__}{cure}")
    for name in ("states", "inputs", "outputs"):
        for port in getattr(kind, name):
            if not isinstance(port, Port):
                raise fault(kind, f"{port!r} in its {name} is not a Port: write Port({str(port)!r})")


def _check_names(kind: type[Component]) -> None:
    """Check that names can be names of Python, and that none is there twice."""
    ring = (kind.ring,) if kind.ring else ()
    groups = {name: [port.name for port in getattr(kind, name)] for name in ("states", "inputs", "outputs")}
    groups["parameters, derived, tables and ring"] = [*kind.numeric(), *kind.derived, *kind.tables, *ring]
    for what, names in groups.items():
        for i, name in enumerate(names):
            if not (isinstance(name, str) and name.isidentifier()) or name.startswith("_"):
                raise fault(kind, f"{name!r} in its {what} is not a name: write a letter, then letters, digits and _")
            if name in names[:i]:
                raise fault(kind, f"{name!r} is twice in its {what}: rename one")
    for name in kind.parameters:
        if hasattr(Component, name):
            raise fault(kind, f"parameter {name!r} has the name of an attribute of Component: rename it")
    if kind.ring and kind.ring not in groups["inputs"]:
        raise fault(kind, f"ring = {kind.ring!r} is not one of its inputs: {', '.join(groups['inputs']) or 'none'}")


def form_of(kind: type[Component]) -> Form:
    """Return the form of a class: by its law, or by its base class.

    Raises
    ------
    ComponentError
        If it has none.
    """
    forms = FAMILY[kind.family].forms
    if forms[0].law:
        law = getattr(kind, "law", "")
        laws = {form.law: form for form in forms}
        if law not in laws:
            calls = ", ".join(f'"{name}" ({", ".join(method.call for method in form.methods)})' for name, form in laws.items())
            raise fault(kind, f"law {law!r} is not one of {calls}" if law else f"has no law: write law = one of {calls}")
        return laws[law]
    for form in forms:
        if issubclass(kind, _base_of(form)):
            return form
    raise fault(kind, f"is not a subclass of {' or '.join(form.base for form in forms)}")


def _base_of(form: Form) -> type[Component]:
    module, _, name = form.base.rpartition(".")
    base: type[Component] = getattr(importlib.import_module(module), name) if module else Component
    return base


def _check_form(kind: type[Component], form: Form) -> None:
    base = _base_of(form)
    for method in form.methods:
        if method.name == "step" and _is_own(kind, base, "step_function", "make_step"):
            continue
        if not _is_own(kind, base, method.name):
            raise fault(kind, f"has no{' static' if method.static else ''} method {method.call}: write it; it returns {method.doc}")
        _check_method(kind, method.call, method.static)
    for name, instead in form.constants.items():
        if instead and _is_own(kind, base, instead):
            _check_method(kind, f"{instead}(par)", True)
        elif name not in (*kind.numeric(), *kind.derived):
            other = f", or a static method {instead}(par)" if instead else ""
            raise fault(kind, f"has no constant {name!r}: write a parameter of this name, or derive it{other}")
    for name in form.states:
        if name not in [port.name for port in kind.states]:
            raise fault(kind, f"has no state {name!r}: write states = (Port({name!r}),)")
    for name, example in form.attributes.items():
        if not getattr(kind, name, None):
            raise fault(kind, f"has no {name}: write for example {name} = {example}")


def _is_own(kind: type[Component], base: type[Component], *names: str) -> bool:
    """Tell whether a class or a parent below the base defines one of these methods."""
    return any(getattr(kind, name, None) is not getattr(base, name, None) for name in names)


def _check_method(kind: type[Component], call: str, static: bool) -> None:
    name, _, arguments = call.partition("(")
    function = getattr(kind, name)
    found = inspect.getattr_static(kind, name)
    if static and inspect.isfunction(found):
        raise fault(kind, f"{name} is not static: write @staticmethod above {call}", function)
    try:
        signature = inspect.signature(function)
        # A keyword-only argument takes a parameter or an attribute of the class.
        named = {n for n, taken in signature.parameters.items() if taken.kind is taken.KEYWORD_ONLY} & {*dir(kind), *kind.parameters}
        signature.bind(*arguments.rstrip(")").split(", "), **dict.fromkeys(named))
    except (TypeError, ValueError):
        written = f"{name}{inspect.signature(function)}" if callable(function) else f"{name} = {function!r}"
        raise fault(kind, f"{written} cannot be called as {call}: take these arguments", function) from None


def _check_ports(kind: type[Component]) -> None:
    """Check the ports against the slot of the family."""
    if (kind.family, kind.kind) in UNWIRED:
        return
    family = FAMILY[kind.family]
    takes, gives = ([port.name for port in ports] for ports in (kind.inputs, kind.outputs))
    for name in takes:
        if name not in family.inputs:
            offered = ", ".join(family.inputs) or "none"
            raise fault(kind, f"a {kind.family} cannot have the input {name!r}; its inputs are: {offered}")
    wanted = family.outputs
    if kind.family == "plant":
        plant: Any = kind
        wanted = (*wanted, *(("motor_position", "motor_velocity") if plant.two_sided else ()), plant.measured)
        if plant.two_sided and plant.measured == "motor_position":
            raise fault(kind, 'the sensor of a two-sided plant is at its load: leave out measured, and write feedback = "motor" in files')
    if family.either and any(name in gives for name in wanted):
        wanted = tuple(name for name in wanted if name in gives)
    for what, names, needed in (("inputs", takes, () if family.chooses else family.inputs), ("outputs", gives, wanted)):
        missing = [name for name in needed if name not in names]
        if missing:
            example = _written(kind.family, tuple(dict.fromkeys(needed)))
            raise fault(kind, f"a {kind.family} must declare {missing[0]!r} in its {what}: write {what} = {example}")
    for port in (*kind.inputs, *kind.outputs):
        if port.name in (*family.inputs, *family.outputs) and port.size != size_of(kind.family, port.name):
            raise fault(kind, f"port {port.name!r} has the size {port.size}: write {_port(kind.family, port.name)}")


def _port(family: str, name: str) -> str:
    return f'Port("{name}", -1)' if size_of(family, name) else f'Port("{name}")'


def _written(family: str, names: tuple[str, ...]) -> str:
    """Return a declaration of ports as it is written in Python."""
    listed = ", ".join(_port(family, name) for name in names)
    return f"({listed}{',' if len(names) == 1 else ''})"


# --- what everybody else needs


def check_documents(kind: type[Component]) -> None:
    """Check what makes a class usable by others: docstring, and units, bounds and texts of parameters.

    Raises
    ------
    ComponentError
        With file, line and class.
    """
    # Not inspect.getdoc, which would find the docstring of a parent.
    if not (kind.__doc__ or "").strip():
        raise fault(kind, "has no docstring: write one")
    for name, parameter in kind.parameters.items():
        _check_parameter(kind, name, parameter)
    for name in (*kind.calibrated, *kind.calibrated_ahead):
        if name not in kind.numeric():
            raise fault(kind, f"the calibrated parameter {name} is not one of its numbers: {', '.join(kind.numeric())}")


def _check_parameter(kind: type[Component], name: str, parameter: Parameter) -> None:
    if not parameter.doc:
        raise fault(kind, f"parameter {name} has no doc: write one")
    filled = parameter.for_plant("full_scale", "full_scale")
    try:
        # A turn and a radian have one dimension, and no factor between Hz and rad/s.
        if not same_dimension(filled.unit, filled.display) or ("Hz" in filled.unit) != ("Hz" in filled.display):
            raise fault(kind, f"parameter {name} has the unit {parameter.unit!r}, but the display unit {parameter.display!r}")
        if in_si(1.0, filled.unit) != 1.0:
            raise fault(kind, f"parameter {name} has the unit {parameter.unit!r}: write an SI unit, and the unit of files as `display`")
    except UnitError as error:
        raise fault(kind, f"parameter {name}: {error}") from error
    bounded = parameter.choices or parameter.minimum > -math.inf or parameter.maximum < math.inf
    if not bounded and name not in kind.unbounded:
        raise fault(kind, f"parameter {name} has no bound: give minimum or maximum, or name it in `unbounded`")
    if parameter.default is not None:
        try:
            parameter.check(parameter.default)
        except ContourlabError as error:
            raise fault(kind, f"the default of {name} is out of range: {error}") from error
