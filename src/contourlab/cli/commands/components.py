"""``contourlab components``: the components of machines and controllers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from contourlab.cli.output import emit_json, say
from contourlab.errors import ComponentError

if TYPE_CHECKING:
    from contourlab.components.contract import Component, Parameter
    from contourlab.report.table import Table

STAND_IN = ("full_scale", "full_scale")
"""Units in place of ``{command}`` and ``{force}`` while a number is converted; they cancel."""


def components(
    name: Annotated[
        str | None,
        typer.Argument(metavar="KIND", help="A family (plant), a kind (rigid-axis) or both (plant/rigid-axis).", show_default=False),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON alone on standard output.")] = False,
    plugin: Annotated[list[Path] | None, typer.Option(help="Load components from a Python file; may be given again.")] = None,
) -> int:
    """List the components; show a family or one component with all parameters."""
    from contourlab.components.registry import components as known
    from contourlab.components.registry import load_plugin

    for file in {file.resolve(): file for file in plugin or ()}.values():
        load_plugin(file)
    chosen = _chosen(name, known())
    if as_json:
        emit_json([describe(kind) for kind in chosen])
    elif name is None:
        say(f"{_overview(chosen).text()}\n\ncontourlab components KIND shows a family or one component, in the units of files.")
    else:
        say("\n".join(part for kind in chosen for part in _details(kind)))
    return 0


def _chosen(name: str | None, known: list[type[Component]]) -> list[type[Component]]:
    """Return the components of a name, a family or a kind."""
    if name is None:
        return known
    chosen = [kind for kind in known if name in (kind.family, kind.kind, f"{kind.family}/{kind.kind}")]
    if not chosen:
        families = ", ".join(dict.fromkeys(kind.family for kind in known))
        kinds = ", ".join(dict.fromkeys(kind.kind for kind in known))
        raise ComponentError(f"no family or kind {name!r}; families: {families}; kinds: {kinds}")
    return chosen


def describe(kind: type[Component]) -> dict[str, Any]:
    """Return a component as JSON; numbers in SI, with their units."""
    return {
        "family": kind.family,
        "kind": kind.kind,
        "doc": _summary(kind),
        "reference": kind.reference,
        "states": [port.name for port in kind.states],
        "inputs": [port.name for port in kind.inputs],
        "outputs": [port.name for port in kind.outputs],
        "parameters": [_parameter(parameter) for parameter in kind.parameters.values()],
        "gains": [_parameter(replace(parameter, name=name)) for name, parameter in kind.wishes.items()],
    }


def _parameter(parameter: Parameter) -> dict[str, Any]:
    return {
        "name": parameter.name,
        "unit": parameter.unit,
        "display_unit": parameter.display,
        "default": parameter.default,
        "minimum": parameter.minimum if math.isfinite(parameter.minimum) else None,
        "maximum": parameter.maximum if math.isfinite(parameter.maximum) else None,
        "exclusive": parameter.exclusive,
        "choices": list(parameter.choices),
        "whole": parameter.whole,
        "list": parameter.vector,
        "doc": parameter.doc,
        "source": parameter.source,
    }


def _summary(kind: type[Component]) -> str:
    """Return the first paragraph of the docstring on one line."""
    import inspect

    return " ".join((inspect.getdoc(kind) or "").split("\n\n")[0].split())


def _overview(kinds: list[type[Component]]) -> Table:
    """Return one row for each component."""
    from contourlab.report.table import Column, Table

    prose = (Column(head, prose=True) for head in ("what it is", "parameters", "reference"))
    table = Table([Column("family", left=True), Column("kind", left=True), *prose])
    for kind in kinds:
        table.add(kind.family, kind.kind, _summary(kind), ", ".join(kind.parameters), kind.reference)
    return table


def _details(kind: type[Component]) -> list[str]:
    """Return name, summary and the tables of parameters and gains of a component."""
    head = [f"{kind.family}/{kind.kind}  {_summary(kind)}", *([f"Reference: {kind.reference}"] if kind.reference else [])]
    from contourlab.report.table import paragraphs

    lines = [paragraphs(head), _parameter_table("parameter", kind.parameters).text() if kind.parameters else "no parameters"]
    return [*lines, *([_parameter_table("gains = {...}", kind.wishes).text()] if kind.wishes else []), ""]


def _parameter_table(head: str, parameters: Mapping[str, Parameter]) -> Table:
    from contourlab.report.table import Column, Table

    names = (Column(name, left=True) for name in (head, "unit", "bounds", "default"))
    table = Table([*names, Column("meaning", prose=True), Column("source", prose=True)])
    for name, parameter in parameters.items():
        table.add(name, _unit(parameter), _range(parameter), _default(parameter), parameter.doc, parameter.source)
    return table


def _unit(parameter: Parameter) -> str:
    """Return the unit of files, with words for units that depend on the plant."""
    return parameter.display.replace("{command}", "command").replace("{force}", "force")


def _shown(parameter: Parameter, value: float) -> str:
    """Return an SI number in the unit of files."""
    if parameter.unit == parameter.display or value == 0.0 or not math.isfinite(value):
        return f"{value:g}"
    from contourlab.units import from_si

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
