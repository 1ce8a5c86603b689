"""Descriptions of components as JSON and as tables, in the units of files."""

from __future__ import annotations

import inspect
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from contourlab.components.contract import Component, Parameter
from contourlab.components.registry import OTHER_NAMES, component
from contourlab.errors import ComponentError, hint
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.units import from_si

STAND_IN = ("full_scale", "full_scale")
"""Units that replace ``{command}`` and ``{force}`` while a value is converted; they cancel."""


@dataclass(frozen=True)
class ComponentDescription:
    """A component; values in SI.

    Attributes
    ----------
    family, kind : str
        Names as in files: ``plant/rigid-axis``.
    doc : str
        Description.
    reference : str
        Paper and equations.
    states, inputs, outputs : tuple of str
    parameters : tuple of Parameter
    gains : tuple of Parameter
        Specifications from which the parameters can be computed, for example by pole placement.
    """

    family: str
    kind: str
    doc: str
    reference: str
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    parameters: tuple[Parameter, ...]
    gains: tuple[Parameter, ...]


def chosen(name: str | None, known: list[type[Component]]) -> list[type[Component]]:
    """Return the components of a family, a kind or both (``plant/rigid-axis``); without a name all.

    Raises
    ------
    ComponentError
        If there is no such component.
    """
    if name is None:
        return known
    named = [kind for kind in known if name in (kind.family, kind.kind, f"{kind.family}/{kind.kind}")]
    if not named:
        families, kinds = (list(dict.fromkeys(getattr(kind, what) for kind in known)) for what in ("family", "kind"))
        family, slash, kind = name.partition("/")
        if slash and family in families:
            return [component(family, kind)]  # which raises
        meant = hint(name, [*families, *kinds], OTHER_NAMES)
        cure = meant if meant.startswith("did") else f"use a family: {', '.join(families)}; contourlab components lists all kinds"
        raise ComponentError(f"no family or kind {name!r}: {cure}")
    return named


def describe(kind: type[Component]) -> ComponentDescription:
    """Return the description of a component."""
    return ComponentDescription(
        kind.family,
        kind.kind,
        doc=_summary(kind),
        reference=kind.reference,
        states=tuple(port.name for port in kind.states),
        inputs=tuple(port.name for port in kind.inputs),
        outputs=tuple(port.name for port in kind.outputs),
        parameters=tuple(kind.parameters.values()),
        gains=tuple(replace(parameter, name=name) for name, parameter in kind.wishes.items()),
    )


def _summary(kind: type[Component]) -> str:
    """Return the first paragraph of the docstring on one line."""
    return " ".join((inspect.getdoc(kind) or "").split("\n\n")[0].split())


def overview(kinds: Sequence[type[Component]]) -> Table:
    """Return one row for each component."""
    prose = (Column(head, prose=True) for head in ("description", "parameters", "reference"))
    rows = ((kind.family, kind.kind, _summary(kind), ", ".join(kind.parameters), kind.reference) for kind in kinds)
    return Table([Column("family", left=True), Column("kind", left=True), *prose], rows=rows)


def details(kind: type[Component]) -> list[str]:
    """Return name, summary and the tables of parameters and gains of a component."""
    head = [f"{kind.family}/{kind.kind}  {_summary(kind)}", *([f"Reference: {kind.reference}"] if kind.reference else [])]
    lines = [paragraphs(head), _parameter_table("parameter", kind.parameters).text() if kind.parameters else "no parameters"]
    return [*lines, *([_parameter_table("gains = {...}", kind.wishes).text()] if kind.wishes else []), ""]


def _parameter_table(head: str, parameters: Mapping[str, Parameter]) -> Table:
    names = (Column(name, left=True) for name in (head, "unit", "bounds", "default"))
    rows = ((name, *parameter_cells(parameter)) for name, parameter in parameters.items())
    return Table([*names, Column("meaning", prose=True), Column("source", prose=True)], rows=rows)


def parameter_cells(parameter: Parameter) -> tuple[str, str, str, str, str]:
    """Return unit, bounds, default, meaning and source of a parameter as in files."""
    return _unit(parameter), _range(parameter), _default(parameter), parameter.doc, parameter.source


def _unit(parameter: Parameter) -> str:
    """Return the unit used in files, with words for units that depend on the plant."""
    return parameter.display.replace("{command}", "command").replace("{force}", "force")


def _shown(parameter: Parameter, value: float) -> str:
    """Return an SI value in the unit of files."""
    if parameter.unit == parameter.display or value == 0.0 or not math.isfinite(value):
        return f"{value:g}"
    return f"{from_si(value, parameter.for_plant(*STAND_IN).display):g}"


def _range(parameter: Parameter) -> str:
    """Return the bounds in the unit of files."""
    if parameter.choices:
        return " | ".join(parameter.choices)
    words = ["whole"] if parameter.whole else []
    if parameter.minimum > -math.inf:
        words.append(f"{'>' if parameter.exclusive else '>='} {_shown(parameter, parameter.minimum)}")
    if parameter.maximum < math.inf:
        words.append(f"<= {_shown(parameter, parameter.maximum)}")
    return ("each " if parameter.vector else "") + (", ".join(words) or "any")


def _default(parameter: Parameter) -> str:
    """Return the default, or ``required``."""
    if parameter.default is None:
        return "required"
    if isinstance(parameter.default, str):
        return parameter.default
    if isinstance(parameter.default, tuple):
        return f"[{', '.join(_shown(parameter, value) for value in parameter.default)}]"
    return _shown(parameter, parameter.default)
