"""Read the tables contour, program, feed, run and learning."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from contourlab.contours import SUFFIXES, unit_size
from contourlab.contours.reader import ContourOptions
from contourlab.errors import ProgramError, ScenarioError, hint
from contourlab.geometry import contour_names, contour_parameters
from contourlab.loop import Change, Machine
from contourlab.program import Reading, read_program
from contourlab.scenario.build import build_controller
from contourlab.scenario.components import read_component
from contourlab.scenario.files import Reader, named_in, spread
from contourlab.scenario.placing import fitted
from contourlab.scenario.quantities import read_list, read_number
from contourlab.scenario.tables import read_values
from contourlab.scenario.tree import Leaf, Node, Table, from_mapping, located, same_table, settle
from contourlab.scenario.values import Contour, FeedSettings, LearningSettings, Motion, PartProgram, RunSettings

SIZES = (1e-6, 100.0)
"""Smallest and largest length in a test contour [m]."""


def read_run(table: Table) -> RunSettings:
    """Return the settings of ``[run]``."""
    return RunSettings(**read_values(table, RunSettings, parts=("changes",)))


def read_feed(table: Table, motion: Motion) -> FeedSettings:
    """Return the settings of ``[feed]``, checked against the motion."""
    plain = FeedSettings(**read_values(table, FeedSettings))
    is_program = isinstance(motion, PartProgram)
    if plain.law == "uniform":
        if is_program:
            raise table.error('the uniform law applies to a contour only: for a program write law = "planned"', "law")
        if not motion.path.closed:  # type: ignore[union-attr]
            raise table.error('the uniform law needs a closed contour: close it, or write law = "planned"', "law")
        _needs(table, "frequency", '"0.5 Hz"', "feedrate", "the uniform law")
        if plain.path_control not in ("program", "exact_path"):
            raise table.error("the uniform law follows the contour exactly: leave this out", "path_control")
        if plain.curvature_step != 1.0:
            raise table.error("does not apply to the uniform law: leave this out", "curvature_step")
    elif is_program:
        for name in ("feedrate", "frequency"):
            if name in table.entries:
                raise table.error("the program sets the feedrate: leave this out, or scale it with override = 0.8", name)
        if plain.laps != 1:
            raise table.error("a program runs once: leave this out", "laps")
    else:
        _needs(table, "feedrate", '"8000 mm/min"', "frequency", "a planned contour")
    _check_corners(table, plain, is_program)
    return plain


def _check_corners(table: Table, plain: FeedSettings, is_program: bool) -> None:
    """Refuse corner tolerances where nothing is blended; inherited ones may be idle."""
    control = plain.path_control
    if control == "blend":
        return
    # G64 without P takes the tolerance of corners; Q is the program's own.
    idle = ("merge_tolerance",) if control == "program" and is_program else ("corner_tolerance", "merge_tolerance")
    for name in idle:
        node, other = table.get(name), table.get("path_control")
        if node is None or (other is not None and not same_table(node, other)):
            continue
        if plain.law == "uniform":
            raise table.error("the uniform law blends nothing: leave this out", name)
        if control in ("exact_path", "exact_stop"):
            raise table.error(f'path_control = "{control}" blends nothing: leave this out, or write path_control = "blend"', name)
        why = "the program's own (Q of G64) applies" if is_program else "corners of a contour are met exactly"
        raise table.error(f'has no effect without path_control = "blend", because {why}: add that, or leave this out', name)


def _needs(table: Table, wanted: str, example: str, other: str, who: str) -> None:
    if other in table.entries:
        raise table.error(f"{who} has no {other}: write {wanted} = {example}", other)
    if wanted not in table.entries:
        raise table.error(f"key {wanted} is missing: {who} needs {wanted} = {example}")


def read_motion(content: Table, machine: Machine) -> Motion:
    """Return the contour or the part program of a scenario."""
    if "contour" in content.entries:
        return _contour(content.entries["contour"], machine)
    node = content.entries["program"]
    if isinstance(node, Leaf):
        node = Table({"file": node}, node.file, node.key)
    given = read_values(node, PartProgram, Reading, needed=("file",))
    file, fit, own = named_in(node, "file"), given.pop("fit", False), given.pop("letters", None)
    letters = tuple(name.lower() for name in machine.axis_names) if own is None else own
    _check_letters(node, letters, machine, own is not None)
    del given["file"]
    reading = Reading(**given | ({"tools": named_in(node, "tools")} if "tools" in given else {}))
    try:
        program = read_program(file, reading=reading)
    except ProgramError as error:
        if error.line:
            raise
        if node.entries["file"].file.startswith("<"):  # given as an argument: there is no key to name
            raise ScenarioError(error.message, file=error.file) from error
        raise node.error(str(error), "file") from error
    if not fit:
        return PartProgram(file, program, letters, reading)
    program, note = fitted(program, letters, machine)
    return PartProgram(file, program, letters, reading, True, note)


def _check_letters(node: Table, letters: tuple[str, ...], machine: Machine, given: bool) -> None:
    names = ", ".join(machine.axis_names)
    if len(letters) != len(machine.axes):
        raise node.error(f"{len(letters)} letters for the axes {names}: write one for each", "letters")
    if len(set(letters)) != len(letters):
        raise node.error("a letter is listed twice: write different letters", "letters")
    if not given and not set(letters) <= set("xyz"):
        raise node.error(f'the axes {names} are not called x, y, z: write their letters in the program, as in letters = ["x", "y"]', "file")


def _contour(node: Node, machine: Machine) -> Contour:
    if isinstance(node, Leaf):
        is_file = isinstance(node.value, str) and Path(node.value).suffix.lower() in SUFFIXES
        node = Table({"file" if is_file else "name": node}, node.file, node.key)
    if "file" in node.entries:
        return _contour_file(node, machine)
    name = node.get("name")
    if not isinstance(name, Leaf) or not isinstance(name.value, str):
        raise node.error(f"key name is missing: write one of {', '.join(contour_names())}, or the key file with the name of a drawing")
    if name.value not in contour_names():
        raise name.error(f"no contour {name.value!r}: {hint(name.value, contour_names())}")
    known = contour_parameters(name.value)
    values: dict[str, float] = {}
    for key, value in node.entries.items():
        if key in ("name", "offset"):
            continue
        if key not in known:
            raise node.error(f"contour {name.value} has no parameter {key!r}: {hint(key, known)}", key)
        with located(node, key):
            unit = known[key][1]
            values[key] = read_number(value.plain(), unit, "mm" if unit == "m" else unit)
        _check_size(node, key, values[key], unit)
    offset: tuple[float, ...] = ()
    if "offset" in node.entries:
        with located(node, "offset"):
            offset = read_list(node.entries["offset"].plain(), "m", "mm")
    contour = Contour(name.value, values)
    with located(node):
        _ = contour.path
    return _on_machine(contour, offset, machine, node, "name")


def _check_size(table: Table, key: str, value: float, unit: str) -> None:
    """Refuse sizes beyond the resolution of doubles, and switches that are neither 0 nor 1."""
    if unit == "m" and value != 0.0 and not SIZES[0] <= abs(value) <= SIZES[1]:
        raise table.error(f"{value * 1e3:.6g} mm is out of range: must be between 1 um and 100 m", key)
    if key == "clockwise" and value not in (0.0, 1.0):
        raise table.error(f"{value:g}: write 0 for counter-clockwise or 1 for clockwise", key)


def _on_machine(contour: Contour, offset: tuple[float, ...], machine: Machine, node: Table, key: str) -> Contour:
    """Return a contour moved by its offset, for all axes of the machine; axes beyond its own hold still."""
    names, n = ", ".join(machine.axis_names), contour.path.n_axis
    if n > len(machine.axes):
        raise node.error(f"{contour.name} has {n} coordinates, but {machine.name} has only the axes {names}", key)
    if offset and len(offset) not in (n, len(machine.axes)):
        raise node.error(f"{len(offset)} values for the axes {names}: write one for each", "offset")
    return replace(contour, offset=offset, axes=machine.axis_names)


def _contour_file(node: Table, machine: Machine) -> Contour:
    """Return the contour of a drawing or of points; read the file now, to report faults before a run."""
    if "name" in node.entries:
        raise node.error("name and file are both given: write name for a test contour, or file for a drawing", "name")
    given = read_values(node, ContourOptions, Contour, needed=("file",))
    file = named_in(node, "file")
    if "unit" in given:
        with located(node, "unit"):
            unit_size(given["unit"])
    options = {name: given[name] for name in node.entries if name not in ("file", "offset")}
    contour = Contour(file.name, file=file.absolute(), options=options)  # absolute: the working folder may change
    with located(node, "file"):
        _ = contour.path
    return _on_machine(contour, given.get("offset", ()), machine, node, "file")


def read_learning(table: Table, machine: Machine) -> LearningSettings | None:
    """Return the settings of ``[learning]``; None without the table or with ``law = "none"``.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    """
    if not table.entries:
        return None
    plain = read_values(table, LearningSettings, needed=("law",))
    first = machine.axes[0].plant
    law: Any = read_component(table.entries["law"], "learning", (first.command_unit, first.force_unit), optional=True)
    if law is None:
        return None
    return LearningSettings(law, **plain | ({"table": named_in(table, "table")} if "table" in plain else {}))


def read_changes(run: Table, machine: Machine, reader: Reader) -> tuple[Change, ...]:
    """Return the controller changes of a table ``run``.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    """
    node = run.get("changes")
    if node is None:
        return ()
    if not isinstance(node, Leaf) or not isinstance(node.value, list):
        raise run.error('write a list: [{at = "2 s", controller = "other.toml"}]', "changes")
    changes = []
    for i, item in enumerate(node.value):
        if not isinstance(item, dict):
            raise node.error(f'{item!r}: write {{at = "2 s", controller = "other.toml"}}')
        table = from_mapping(item, node.file, f"{node.key}[{i}]")
        plain = read_values(table, Change, needed=("at", "controller"))
        leaf = table.entries["controller"]
        assert isinstance(leaf, Leaf)  # `read_values` has checked it
        content = replace(reader, names=machine.axis_names).include(leaf, Reader.controller_file)
        controller = build_controller(settle(spread(content, machine.axis_names)), machine)
        with located(table):
            changes.append(Change(**plain | {"controller": controller, "file": content.file}))
    return tuple(changes)
