"""``contourlab components``: the components of machines and controllers."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import emit_json, say, suggest


def components(
    name: Annotated[
        str | None,
        typer.Argument(metavar="KIND", help="A family (plant), a kind (rigid-axis) or both (plant/rigid-axis).", show_default=False),
    ] = None,
    as_json: shared.Json = False,
    plugin: Annotated[list[Path] | None, typer.Option(help="Load and check the components of a Python file; repeatable.")] = None,
) -> int:
    """List the components; show a family or one component with all parameters."""
    from contourlab.components.conformance import check_component
    from contourlab.components.registry import components as known
    from contourlab.components.registry import load_plugin
    from contourlab.features.components.description import chosen, describe, details, overview

    for file in {file.resolve(): file for file in plugin or ()}.values():
        for kind in load_plugin(file):
            checks = check_component(kind)
            if not as_json:
                say("\n".join([f"{kind.family}/{kind.kind} keeps the contract:", *(f"  {words}" for words in checks), ""]))
    kinds = chosen(name, known())
    if as_json:
        emit_json([describe(kind) for kind in kinds])
    elif name is None:
        say(overview(kinds).text())
        suggest(as_json, "components", kinds[0].kind)
    else:
        say("\n".join(part for kind in kinds for part in details(kind)))
        suggest(as_json, "machines")
    return 0
