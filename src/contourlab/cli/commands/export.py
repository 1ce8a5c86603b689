"""``contourlab export``: the controllers of the axes as code for a control."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import options as shared
from contourlab.cli.output import show_result, suggest


def export(
    file: Annotated[
        str, typer.Argument(metavar="SCENARIO|CONTROLLER", help="A scenario, or a controller with --machine.", show_default=False)
    ],
    to: Annotated[str, typer.Option(help="Language: c99, hal (LinuxCNC), st (IEC 61131-3) or fmu (FMI 2.0 and 3.0).", show_default=False)],
    machine: Annotated[str | None, typer.Option(help="Machine of the controller: a file, a folder, or the name of a shipped one.")] = None,
    scheme: Annotated[str | None, typer.Option(help="Scheme of the scenario; by default the scenario itself.", show_default=False)] = None,
    axis: Annotated[str | None, typer.Option(help="Axes, with commas; by default all.", show_default=False)] = None,
    out: shared.Out = Path("export"),
    as_json: shared.Json = False,
    plugin: shared.Plugins = None,
) -> None:
    """Write the controller of each axis as code for a control."""
    from contourlab.features.export.command import export_controller

    made = export_controller(file, to, out, machine=machine, scheme=scheme, axes=shared.listed(axis), plugins=tuple(plugin or ()))
    show_result(made, as_json)
    if made.findings:
        suggest(as_json, "explain", made.findings[0].code)
    elif machine is None:
        suggest(as_json, "analyse", file)
