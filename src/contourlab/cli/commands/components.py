"""``contourlab components``: what a machine and its controller can be made of."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from contourlab.cli.output import emit_json, show
from contourlab.errors import ComponentError

if TYPE_CHECKING:
    from rich.console import RenderableType

    from contourlab.components.contract import Component, Parameter

STAND_IN = ("full_scale", "full_scale")
"""Units put for ``{command}`` and ``{force}`` while a number is converted; they cancel, whatever the plant's are."""


def components(
    name: Annotated[
        str | None,
        typer.Argument(metavar="KIND", help="A family (plant), a kind (rigid-axis) or both (plant/rigid-axis).", show_default=False),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON alone on standard output.")] = False,
    plugin: Annotated[list[Path] | None, typer.Option(help="Load components from a Python file; may be given again.")] = None,
) -> int:
    """List the components; those of a family, or a single one, with all that is known of their parameters."""
    from contourlab.components.registry import components as known
    from contourlab.components.registry import load_plugin

    for file in {file.resolve(): file for file in plugin or ()}.values():
        load_plugin(file)
    chosen = _chosen(name, known())
    if as_json:
        emit_json([describe(kind) for kind in chosen])
    elif name is None:
        show(_overview(chosen), "contourlab components KIND tells all of a family or of one component; units are those that files use.")
    else:
        show(*(part for kind in chosen for part in _details(kind)))
    return 0


def _chosen(name: str | None, known: list[type[Component]]) -> list[type[Component]]:
    """Return the components that a name means.

    Raises
    ------
    ComponentError
        If it means none; the message lists families and kinds.
    """
    if name is None:
        return known
    found = [kind for kind in known if name in (kind.family, kind.kind, f"{kind.family}/{kind.kind}")]
    if not found:
        families = ", ".join(dict.fromkeys(kind.family for kind in known))
        kinds = ", ".join(dict.fromkeys(kind.kind for kind in known))
        raise ComponentError(f"no family or kind {name!r}; families: {families}; kinds: {kinds}")
    return found


def describe(kind: type[Component]) -> dict[str, Any]:
    """Return all that is known of a component, fit for JSON; numbers are in SI, the unit beside them."""
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


def _overview(kinds: list[type[Component]]) -> RenderableType:
    """Return one line a component."""
    from rich.table import Table

    table = Table("family", "kind", "what it is", "parameters", "reference")
    last = ""
    for kind in kinds:
        if last and kind.family != last:
            table.add_section()
        family = kind.family if kind.family != last else ""
        table.add_row(family, kind.kind, _text(_summary(kind)), _text(", ".join(kind.parameters)), _text(kind.reference))
        last = kind.family
    return table


def _details(kind: type[Component]) -> list[RenderableType]:
    """Return the name, the summary and the table of parameters of a component."""
    from rich.table import Table
    from rich.text import Text

    head = Text.assemble((f"{kind.family}/{kind.kind}", "bold"), f"  {_summary(kind)}")
    if kind.reference:
        head.append(f"\nReference: {kind.reference}")
    if not kind.parameters:
        return [head, "no parameters", ""]
    table = Table("parameter", "unit", "bounds", "default", "meaning", "source")
    for parameter in kind.parameters.values():
        bounds, default = _range(parameter), _default(parameter)
        table.add_row(*(_text(word) for word in (parameter.name, _unit(parameter), bounds, default, parameter.doc, parameter.source)))
    if not kind.wishes:
        return [head, table, ""]
    wishes = Table("gains = {...}", "unit", "bounds", "default", "what they are worked out from")
    for name, parameter in kind.wishes.items():
        wishes.add_row(*(_text(word) for word in (name, _unit(parameter), _range(parameter), _default(parameter), parameter.doc)))
    return [head, table, wishes, ""]


def _text(words: str) -> RenderableType:
    """Return text in which square brackets are no markup."""
    from rich.text import Text

    return Text(words)


def _unit(parameter: Parameter) -> str:
    """Return the unit that files use, with plain words for those that depend on the plant."""
    return parameter.display.replace("{command}", "command").replace("{force}", "force")


def _shown(parameter: Parameter, value: float) -> str:
    """Return an SI number in the unit that files use."""
    if parameter.unit == parameter.display or value == 0.0 or not math.isfinite(value):
        return f"{value:g}"
    from contourlab.units import from_si

    return f"{from_si(value, parameter.for_plant(*STAND_IN).display):g}"


def _range(parameter: Parameter) -> str:
    """Return the bounds in words, in the unit that files use."""
    if parameter.choices:
        return " | ".join(parameter.choices)
    words = ["whole"] if parameter.whole else []
    if parameter.minimum > -math.inf:
        words.append(f"{'>' if parameter.exclusive else '>='} {_shown(parameter, parameter.minimum)}")
    if parameter.maximum < math.inf:
        words.append(f"<= {_shown(parameter, parameter.maximum)}")
    return ("each " if parameter.vector else "") + (", ".join(words) or "any")


def _default(parameter: Parameter) -> str:
    """Return the default, or the word for one that has to be given."""
    if parameter.default is None:
        return "required"
    if isinstance(parameter.default, str):
        return parameter.default
    if isinstance(parameter.default, tuple):
        return f"[{', '.join(_shown(parameter, value) for value in parameter.default)}]"
    return _shown(parameter, parameter.default)
