"""How a part program is read: the options of the reader, and no drawing in its place."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.app.shared_options import Dialect
from contourlab.controls import reader_of
from contourlab.errors import ScenarioError
from contourlab.file_kinds import kind_of
from contourlab.program import Reading

if TYPE_CHECKING:
    from contourlab.loop import Machine

DEFAULT_MACHINE = "builtin:xyz"


def refuse_drawing(file: str | Path, machine: str | Path | None = None, controller: str | Path | None = None) -> None:
    """Refuse a drawing or points in place of a part program; show the scenario to write, with this machine and controller.

    Raises
    ------
    ScenarioError
        If the file name ends as that of a drawing or of points.
    """
    path = Path(file)
    what = {".dxf": "a drawing", ".svg": "a drawing", ".csv": "a list of points"}.get(path.suffix.lower())
    if what is None or not path.exists() or (path.suffix.lower() == ".csv" and kind_of(path) not in ("a log", "")):
        return
    from contourlab.scenario.load import named_file

    lines = [
        f"machine = {json.dumps(named_file(machine or 'xyz'))}",
        f"controller = {json.dumps(named_file(controller or 'xyz-controller'))}",
        "[contour]",
        f"file = {json.dumps(str(path), ensure_ascii=False)}",
        "[feed]",
        'feedrate = "1000 mm/min"',
    ]
    raise ScenarioError(
        f"{what}, not a part program: write a scenario, say {path.stem}.toml, and run that:\n\n" + "\n".join(lines) + "\n",
        file=path,
    )


def of_control(machine: str | Path | Machine) -> bool:
    """Return whether a machine is a control's own file."""
    return reader_of(Path(machine)) is not None if isinstance(machine, str | Path) else machine.control is not None


def read_once(options: Any) -> Any:
    """Return options with the machine itself in place of a control's own file, so that nothing reads that again."""
    if options.machine is None or not of_control(options.machine):
        return options
    from contourlab.scenario.load import machine_of

    return replace(options, machine=machine_of(options.machine))


def machine_for(options: Any, reading: Reading) -> Machine:
    """Return the machine and the planner of options, by default of a shipped machine; `reading` tells where its zero is."""
    from contourlab.scenario.load import machine_of
    from contourlab.scenario.placing import anchored

    return anchored(machine_of(options.machine or DEFAULT_MACHINE), reading).planned_as(options.planner)


def reading_of(file: str | Path, options: Dialect) -> Reading:
    """Return how a part program is read, with the options, and as the file of the machine's control says; refuse a drawing.

    A missing end is a notice only.
    """
    refuse_drawing(file)
    given = {key: getattr(options, key) for key in ("dialect", "block_delete", "tools", "zero", "most_moves")}
    chosen: dict[str, Any] = {key: value for key, value in given.items() if value is not None} | {"require_end": False}
    machine = getattr(options, "machine", None)
    if machine is None:
        return Reading(**chosen)
    from contourlab.scenario.load import machine_of, reading_on

    return reading_on(machine_of(machine), chosen)
