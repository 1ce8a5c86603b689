"""Read scenario, machine, controller and axis files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from contourlab.components.registry import load_plugin
from contourlab.contours import SUFFIXES, unit_size
from contourlab.contours.reader import ContourOptions
from contourlab.controls import control_file
from contourlab.errors import ParameterError, ProgramError, ScenarioError, hint, refuse
from contourlab.file_kinds import kind_of
from contourlab.geometry import contour_names, contour_parameters
from contourlab.loop import Axis, Change, Controller, Machine
from contourlab.program import Reading, read_program
from contourlab.result.stamp import tell
from contourlab.scenario.build import build_axis, build_controller, build_machine, in_place, read_component, units_of
from contourlab.scenario.files import BUILTIN, EVERY, Reader, builtin_file, builtin_names, join, listed, shipped_hint, spread
from contourlab.scenario.placing import anchored, fitted
from contourlab.scenario.quantities import read_number
from contourlab.scenario.tables import read_values
from contourlab.scenario.tree import Leaf, Node, Table, from_mapping, located, merge, parse_tree, same_table, settle
from contourlab.scenario.values import Case, Contour, FeedSettings, LearningSettings, Motion, PartProgram, RunSettings, Scenario

SIZES = (1e-6, 100.0)
"""Smallest and largest length in a test contour [m]."""


_Rules = list[tuple[str, bool, str]]
"""Keys, whether they are wrong, and the messages."""


def _refuse(table: Table, rules: _Rules) -> None:
    """Raise the first error of a list."""
    for key, wrong, message in rules:
        refuse(wrong, table.error, message, key)


def read_feed(table: Table, motion: Motion, machine: Machine) -> FeedSettings:
    """Return the settings of ``[feed]``, checked against the motion and the machine's planner."""
    plain = FeedSettings(**read_values(table, FeedSettings))
    is_program = isinstance(motion, PartProgram)
    if plain.law == "uniform":
        is_open = isinstance(motion, Contour) and not motion.path.closed
        rules: _Rules = [
            ("law", is_program, 'the uniform law applies to a contour only: for a program write law = "planned"'),
            ("law", is_open, 'the uniform law needs a closed contour: close it, or write law = "planned"'),
            *_one_rate(table, "frequency", '"0.5 Hz"', "feedrate", "the uniform law"),
            ("path_control", plain.path_control in ("exact_stop", "blend"), "the uniform law follows the contour exactly: leave this out"),
            ("curvature_step", plain.curvature_step != 1.0, "does not apply to the uniform law: leave this out"),
        ]
    elif is_program:
        why = "the program sets the feedrate: leave this out, or scale it with override = 0.8"
        rules = [(name, name in table.entries, why) for name in ("feedrate", "frequency")]
        rules += [("laps", plain.laps != 1, "a program runs once: leave this out")]
    else:
        rules = _one_rate(table, "feedrate", '"8000 mm/min"', "frequency", "a planned contour")
    sharp = (plain.planner or machine.planner) == "grbl" and plain.path_control == "blend"
    rules += [("path_control", sharp, 'planner = "grbl" rounds no corner: leave this out, or write planner = "jerk"')]
    _refuse(table, rules + _idle_corners(table, plain, is_program))
    return plain


def _one_rate(table: Table, wanted: str, example: str, other: str, who: str) -> _Rules:
    return [
        (other, other in table.entries, f"{who} has no {other}: write {wanted} = {example}"),
        ("", wanted not in table.entries, f"key {wanted} is missing: {who} needs {wanted} = {example}"),
    ]


def _idle_corners(table: Table, plain: FeedSettings, is_program: bool) -> _Rules:
    """Refuse corner tolerances where nothing is blended; inherited ones may be idle."""
    control, stated = plain.path_control, table.get("path_control")
    # G64 without P takes the tolerance of corners; Q is the program's own.
    names = ["merge_tolerance"] if control == "program" and is_program else ["corner_tolerance", "merge_tolerance"]
    given = [name for name in names if (node := table.get(name)) and (stated is None or same_table(node, stated))]
    if plain.law == "uniform":
        why = "the uniform law blends nothing: leave this out"
    elif control != "program":
        why = f'path_control = "{control}" blends nothing: leave this out, or write path_control = "blend"'
    else:
        why = "the program's own (Q of G64) applies" if is_program else "corners of a contour are met exactly"
        why = f'has no effect without path_control = "blend", because {why}: add that, or leave this out'
    return [(name, control != "blend", why) for name in given]


def read_motion(content: Table, machine: Machine) -> Motion:
    """Return the contour or the part program of a scenario."""
    if "contour" in content.entries:
        return _contour(content.entries["contour"], machine)
    node = content.entries["program"]
    if isinstance(node, Leaf):
        node = Table({"file": node}, node.file, node.key)
    given = read_values(node, PartProgram, Reading, needed=("file",))
    file, fit, own = given.pop("file"), given.pop("fit", False), given.pop("letters", None)
    letters = tuple(name.lower() for name in machine.axis_names) if own is None else own
    try:
        names, reading = ", ".join(machine.axis_names), reading_on(machine, given)
    except ParameterError as error:
        if error.name not in node.entries or node.entries[error.name].file.startswith("<"):  # given as an option
            raise
        raise node.error(f"must be {error.bound}", error.name) from error
    strange = own is None and not set(letters) <= set("xyz")
    rules: _Rules = [
        ("letters", len(letters) != len(machine.axes), f"{len(letters)} letters for the axes {names}: write one for each"),
        ("letters", len(set(letters)) != len(letters), "a letter is listed twice: write different letters"),
        ("file", strange, f'the axes {names} are not called x, y, z: write their letters in the program, as in letters = ["x", "y"]'),
    ]
    _refuse(node, rules)
    try:
        program = read_program(file, reading=reading)
    except ProgramError as error:
        if error.line:
            raise
        if node.entries["file"].file.startswith("<"):  # given as an argument: there is no key to name
            raise ScenarioError(error.message, file=error.file) from error
        raise node.error(str(error), "file") from error
    program, note = fitted(program, letters, anchored(machine)) if fit else (program, "")
    return PartProgram(file, program, letters, reading, fit, note)


def reading_on(machine: Machine, given: Mapping[str, Any]) -> Reading:
    """Return how a machine reads a part program: as its control's own file says, with what is given."""
    control = machine.control
    own = {} if control is None else read_values(from_mapping(control.tables.get("program", {}), str(control.file), "program"), Reading)
    return Reading(**{**own, **({"startup_place": ""} if "startup" in given else {}), **given})


def _contour(node: Node, machine: Machine) -> Contour:
    """Return a contour on a machine; read a file now, to report faults before a run. Axes beyond the contour's own hold still."""
    if isinstance(node, Leaf):
        is_file = isinstance(node.value, str) and Path(node.value).suffix.lower() in SUFFIXES
        node = Table({"file" if is_file else "name": node}, node.file, node.key)
    key = "file" if "file" in node.entries else "name"
    contour = _from_file(node) if key == "file" else Contour(*_shape(node), **read_values(node.only("offset"), Contour))
    with located(node, "file" if key == "file" else ""):
        n = contour.reading.path.n_axis
    names, n_offset = ", ".join(machine.axis_names), len(contour.offset)
    rules: _Rules = [
        (key, n > len(machine.axes), f"{contour.name} has {n} coordinates, but {machine.name} has only the axes {names}"),
        ("offset", n_offset not in (0, n, len(machine.axes)), f"{n_offset} values for the axes {names}: write one for each"),
    ]
    _refuse(node, rules)
    return replace(contour, axes=machine.axis_names)


def _shape(node: Table) -> tuple[str, dict[str, float]]:
    """Return name and parameters of a test contour; refuse sizes beyond the resolution of doubles, and switches that are not 0 or 1."""
    leaf = node.get("name")
    if not isinstance(leaf, Leaf) or not isinstance(name := leaf.value, str):
        raise node.error(f"key name is missing: write one of {', '.join(contour_names())}, or the key file with the name of a drawing")
    if name not in contour_names():
        raise leaf.error(f"no contour {name!r}: {hint(name, contour_names())}")
    known = contour_parameters(name)
    values: dict[str, float] = {}
    for key, given in node.without("name", "offset").entries.items():
        if key not in known:
            raise node.error(f"contour {name} has no parameter {key!r}: {hint(key, known)}", key)
        with located(node, key):
            unit = known[key][1]
            value = values[key] = read_number(given.plain(), unit, "mm" if unit == "m" else unit)
        if unit == "m" and value != 0.0 and not SIZES[0] <= abs(value) <= SIZES[1]:
            raise node.error(f"{value * 1e3:.6g} mm is out of range: must be between 1 um and 100 m", key)
        if key == "clockwise" and value not in (0.0, 1.0):
            raise node.error(f"{value:g}: write 0 for counter-clockwise or 1 for clockwise", key)
    return name, values


def _from_file(node: Table) -> Contour:
    """Return the contour of a drawing or of points."""
    refuse("name" in node.entries, node.error, "name and file are both given: write name for a test contour, or file for a drawing", "name")
    given = read_values(node, ContourOptions, Contour, needed=("file",))
    file, offset = given.pop("file"), given.pop("offset", ())
    with located(node, "unit"):
        unit_size(given.get("unit", "mm"))
    options = {name: given[name] for name in node.entries if name in given}
    return Contour(file.name, file=file.absolute(), options=options, offset=offset)  # absolute: the working folder may change


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
        leaf: Any = table.entries["controller"]
        content = replace(reader, names=machine.axis_names).include(leaf, Reader.controller_file)
        plain |= {"controller": build_controller(settle(spread(content, machine.axis_names)), machine), "file": content.file}
        with located(table):
            changes.append(Change(**plain))
    return tuple(changes)


SCHEME_KEYS = ("machine", "axes", "controller", "feed", "run", "learning")
COMMAND_LINE = "<arguments>"
"""File name shown for values given as arguments; relative names start at the working folder."""
_loaded: set[Path] = set()


def _load_plugins(plugins: Sequence[str | Path]) -> None:
    for plugin in plugins:
        file = Path(plugin).resolve()
        if file not in _loaded:
            load_plugin(plugin)
            _loaded.add(file)


def _open(file: str | Path, plugins: Sequence[str | Path], *wanted: str) -> tuple[Reader, Table]:
    """Load plugins; return the content of a file of a kind wanted, own or shipped, and the reader for the files it names."""
    _load_plugins(plugins)
    text = str(file)
    path = builtin_file(text) if text.startswith(BUILTIN) else Path(file)
    try:
        resolved = path.resolve()
    except (OSError, ValueError, RuntimeError) as error:
        raise ScenarioError(f"is not a file name: {error}", file=text) from error
    if not path.exists() and (shipped := shipped_hint(text)):
        raise ScenarioError(f"no such file{shipped}", file=text)
    reader = Reader(open_files=(resolved,))
    return reader, reader.file(path, *wanted)


# --- parts ---------------------------------------------------------------------------------------------------------------------------


def load_axis(file: str | Path, name: str = "x", plugins: Sequence[str | Path] = ()) -> Axis:
    """Read an axis from its own file.

    Parameters
    ----------
    file : str or Path
        Or ``builtin:`` and the name of a shipped one.
    plugins : sequence of str or Path
        Python files with further components.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.

    >>> load_axis("builtin:ghaffari/axis1").plant.gain
    1.695
    """
    reader, content = _open(file, plugins, "an axis")
    return build_axis(settle(reader.axis_file(content)), name)


def load_module(file: str | Path, place: Axis, plugins: Sequence[str | Path] = ()) -> tuple[Axis, str]:
    """Read a module that replaces an axis; return it, and a note on the values taken over from that axis.

    Parameters
    ----------
    file, plugins
        As in `load_axis`.
    place : Axis
        The replaced axis: its stage mass, limits and substeps apply where the file has none.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    """
    reader, content = _open(file, plugins, "an axis")
    table = settle(reader.axis_file(content))
    return in_place(table, build_axis(table, place.name), place)


def load_machine(file: str | Path, plugins: Sequence[str | Path] = ()) -> Machine:
    """Read a machine from its own file, or from a scenario.

    Parameters
    ----------
    file, plugins
        As in `load_axis`.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.

    >>> load_machine("builtin:xyz").axis_names
    ('x', 'y', 'z')
    """
    reader, content = _open(file, plugins, "a machine", "a scenario")
    if {"machine", "controller"} <= set(content.entries):
        _name(content)
        content = content.only("machine", "axes")
    return build_machine(settle(reader.machine_file(content)), reader.controls)


def controller_axes(file: str | Path, plugins: Sequence[str | Path] = ()) -> tuple[str, ...]:
    """Return the axes that a controller file names, without ``"*"``.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    """
    reader, content = _open(file, plugins, "a controller")
    axes = reader.controller_file(content).get("axes")
    return tuple(name for name in axes.entries if name != EVERY) if isinstance(axes, Table) else ()


def load_controller(
    file: str | Path, machine: Machine, plugins: Sequence[str | Path] = (), *, called: Mapping[str, str] | None = None
) -> Controller:
    """Read a controller from its own file; the machine's commands set the units of the gains.

    Parameters
    ----------
    file, plugins
        As in `load_axis`.
    called : mapping of str to str, optional
        Name in the file of each axis that has another name on the machine.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    """
    reader, content = _open(file, plugins, "a controller")
    machine_name = {(called or {}).get(name, name): name for name in machine.axis_names}
    table = spread(replace(reader, names=tuple(machine_name)).controller_file(content), tuple(machine_name))
    axes = table.get("axes")
    if called and isinstance(axes, Table):
        table = table.having(axes=replace(axes, entries={machine_name.get(name, name): node for name, node in axes.entries.items()}))
    return build_controller(settle(table), machine)


# --- scenarios -----------------------------------------------------------------------------------------------------------------------


def _in_folder(given: str | Path) -> str | Path:
    """Return the scenario of a folder; a file as it is.

    Raises
    ------
    ScenarioError
        If the folder has no ``scenario.toml``; with what to name instead.
    """
    folder = Path(given)
    if not folder.is_dir():
        return given
    file = folder / "scenario.toml"
    if file.exists():
        return file
    if (folder / "machine.toml").exists():
        raise ScenarioError(f"no scenario.toml in this folder: run a part program on its machine, with --machine {folder}", file=folder)
    others = ", ".join([str(path) for path in sorted(folder.glob("*.toml")) if kind_of(path) == "a scenario"][:5])
    raise ScenarioError(f"is a folder without scenario.toml: name a scenario{others and f', such as {others}'}", file=folder)


def _on(content: Table, machine: str | Path | None) -> Table:
    """Return a scenario on another machine, if one is given; the file of a control brings its controller, if it has one."""
    if machine is None:
        return content
    name = named_file(machine)
    control = control_file(Path(name))
    own = () if control is None or "controller" not in control.tables else ("controller",)
    return content.without("axes", *own).having(**from_mapping({"machine": name}, COMMAND_LINE).entries)


def load_scenario(
    file: str | Path,
    plugins: Sequence[str | Path] = (),
    machine: str | Path | None = None,
    *,
    changes: Mapping[str, Any] | None = None,
) -> Scenario:
    """Read a scenario.

    Parameters
    ----------
    file : str or Path
        Or ``builtin:`` and the name of a shipped one; of a folder, its ``scenario.toml``.
    plugins : sequence of str or Path
        Python files with further components.
    machine : str or Path, optional
        In place of the machine of the scenario: a file, or the name of a shipped one. The file of a control has a controller, too.
    changes : mapping, optional
        Tables and keys as in a scheme, for the base and every scheme: ``{"feed": {"override": 0.8}}``.

    Returns
    -------
    Scenario
        With every scheme read and checked.

    Raises
    ------
    ScenarioError
        If the content is invalid; gives file and key.
    ProgramError
        If the part program is invalid; gives the line.

    >>> [case.name for case in load_scenario("builtin:ghaffari/demo-stage").cases()][0]
    'position loop'
    """
    reader, content = _open(_in_folder(file), plugins, "a scenario")
    return _scenario(reader, _on(content, machine), Path(content.file), changes)


def changed_case(
    file: str | Path, scheme: str, changes: Table, plugins: Sequence[str | Path] = (), machine: str | Path | None = None
) -> Case:
    """Return the case of a scenario, or of one of its schemes, with other tables and keys.

    Parameters
    ----------
    file, plugins, machine
        As in `load_scenario`.
    scheme : str
        Empty for the base.
    changes : Table
        As in a scheme, and ``contour`` or ``program``, which replaces the motion.

    Raises
    ------
    ScenarioError, ProgramError
        As `load_scenario`; or if there is no such scheme.
    """
    reader, content = _open(_in_folder(file), plugins)
    content = _on(content, machine)
    schemes = content.table("schemes")
    if scheme and scheme not in schemes.entries:
        raise content.error(f"no scheme {scheme!r}: {hint(scheme, schemes.entries)}", "schemes")
    motion = changes.only("contour", "program").entries
    if motion:
        content = replace(content, entries={**content.without("contour", "program").entries, **motion})
    table = merge(schemes.table(scheme) if scheme else Table(), changes.without(*motion))
    name = scheme or "base"
    return _scenario(reader, content.having(schemes=Table({name: table}, content.file, "schemes")), Path(content.file)).cases()[0]


def scenario_from_parts(
    program: str | Path | None,
    machine: str | Path,
    controller: str | Path | None = None,
    *,
    contour: Mapping[str, Any] | None = None,
    feed: Mapping[str, Any] | None = None,
    run: Mapping[str, Any] | None = None,
    options: Mapping[str, Any] | None = None,
    changes: Mapping[str, Any] | None = None,
    name: str = "",
    plugins: Sequence[str | Path] = (),
) -> Scenario:
    """Return the scenario of a part program, or contour, on a machine under a controller.

    Parameters
    ----------
    program : str, Path or None
        Part program; None with a contour.
    machine, controller : str or Path
        Files, or names of shipped ones with or without ``builtin:``. The machine may be a control's own file, which has a controller.
    contour, feed, run : mapping, optional
        As the tables of a scenario file: ``feed={"override": 0.8}``, ``run={"tolerance": "20 um"}``.
    options : mapping, optional
        Further keys of the table ``program``: ``{"fit": True}``.
    changes : mapping, optional
        See `load_scenario`.
    name : str
        By default the name of the program.
    plugins : sequence of str or Path
        Python files with further components.

    Raises
    ------
    ScenarioError, ProgramError
        As `load_scenario`.
    """
    _load_plugins(plugins)
    values: dict[str, Any] = {"machine": named_file(machine)}
    values |= {} if controller is None else {"controller": named_file(controller, "controller")}
    part = None if program is None else {"file": str(program), **(options or {})}
    given = {"program": part, "contour": contour, "feed": feed, "run": run, "name": name or None}
    values |= {key: value for key, value in given.items() if value is not None}
    if program is not None and not name:
        values["name"] = _title(Path(program))
    return _scenario(Reader(), from_mapping(values, COMMAND_LINE), Path(COMMAND_LINE), changes)


def _title(file: Path) -> str:
    """Return a valid scenario name for any file name."""
    return file.stem.encode("utf-8", "replace").decode()[:200]


def named_file(reference: str | Path, part: str = "machine") -> str:
    """Return a file name as a scenario writes it; a folder means its machine or controller, a bare name that is no file a shipped one."""
    text = str(reference)
    inside = Path(text) / f"{part}.toml"
    if inside.is_file() or (Path(text).is_dir() and text not in builtin_names()):
        return str(inside)
    if not text.startswith(BUILTIN) and not Path(text).suffix and not Path(text).is_file():
        return BUILTIN + text
    return text


def machine_of(given: str | Path | Machine, plugins: Sequence[str | Path] = ()) -> Machine:
    """Return a machine that is given as its file, the name of a shipped one, or itself; raises as `load_machine`."""
    return tell(given if isinstance(given, Machine) else load_machine(named_file(given), plugins))


def parse_scenario(text: str, name: str = "<text>", plugins: Sequence[str | Path] = ()) -> Scenario:
    """Read a scenario from TOML text; relative file names start at the working folder.

    Raises
    ------
    ScenarioError, ProgramError
        As `load_scenario`.
    """
    _load_plugins(plugins)
    return _scenario(Reader(), parse_tree(text, name), Path(name))


def _name(content: Table) -> str:
    """Check the keys of a scenario, and return its name."""
    parts = ("axes", "contour", "program", "feed", "run", "learning", "schemes")
    needed = ("machine",) if "machine" in content.entries else ("machine", "controller")
    name: str = read_values(content, Scenario, needed=needed, parts=(*parts, "controller")).get("name", "")
    return name


def _scenario(reader: Reader, content: Table, path: Path, changes: Mapping[str, Any] | None = None) -> Scenario:
    name = _name(content)
    if ("contour" in content.entries) == ("program" in content.entries):
        both = "contour" in content.entries
        raise content.error("contour and program are both given: delete one" if both else "contour or program is missing: write one")
    machine = reader.machine(content.only("machine", "axes"))
    reader = replace(reader, names=listed(machine))
    content = _under_control(content, machine, reader)
    layers = content.only("feed", "run", "learning").having(machine=machine, controller=reader.controller(content.entries["controller"]))
    motion = read_motion(content, build_machine(settle(machine), reader.controls))
    schemes, over = content.table("schemes"), from_mapping(changes or {}, COMMAND_LINE)

    def case(called: str, tables: Table, place: Table) -> Case:
        return _case(called, _over(reader, tables, over) if over.entries else tables, motion, place, reader)

    base, own = case("base", layers, content), {name: schemes.table(name) for name in schemes.entries}
    cases = tuple(case(name, _over(reader, layers, table), table) for name, table in own.items())
    return Scenario(name or _title(path), path, base, cases, tuple(dict.fromkeys(reader.seen)))


def _under_control(content: Table, machine: Table, reader: Reader) -> Table:
    """Return a scenario with the controller of the control whose own file its machine is, where it has none itself."""
    control = next((control for control in reader.controls if str(control.file) == machine.table("machine").file), None)
    if control is not None and "controller" in control.tables:
        own = from_mapping({"controller": control.tables["controller"]}, str(control.file))
        content = Table({**own.entries, **content.entries}, content.file, content.key)
    refuse("controller" not in content.entries, content.error, "1 key is missing: controller")
    return content


def _over(reader: Reader, base: Table, scheme: Table) -> Table:
    """Return the tables of a case overridden by a scheme."""
    for name in scheme.entries:
        if name not in SCHEME_KEYS:
            raise scheme.error(f"a scheme cannot change this: {hint(name, SCHEME_KEYS)}", name)
    machine, controller = base.table("machine"), base.entries["controller"]
    own = reader.machine(scheme.only("machine", "axes"))
    if own.entries:
        machine = own if own.afresh else join(machine, own, listed(own) or listed(machine))
    if "controller" in scheme.entries:
        reader = replace(reader, names=listed(machine))
        over = reader.controller(scheme.entries["controller"])
        _check_axes(scheme.entries["controller"], reader.names, controller)
        fresh = isinstance(over, Leaf) or isinstance(controller, Leaf) or over.afresh
        controller = over if fresh else join(controller, over, reader.names)  # type: ignore[arg-type]
    settings = {name: merge(base.table(name), scheme.table(name)) for name in ("feed", "run", "learning")}
    return base.having(machine=machine, controller=controller, **settings)


def _check_axes(over: Node, names: tuple[str, ...], base: Node) -> None:
    """Refuse axes that neither the machine nor the base controller has; a controller file may serve further machines."""
    axes = over.entries.get("axes") if isinstance(over, Table) else None
    if not isinstance(axes, Table):
        return
    shared = base.entries.get("axes") if isinstance(base, Table) else None
    known = {*names, EVERY, *(shared.entries if isinstance(shared, Table) else ())}
    for name in axes.entries:
        if name not in known:
            raise axes.error(f"the machine has no axis {name!r}: {hint(name, names)}", name)


def _case(name: str, layers: Table, motion: Motion, place: Table, reader: Reader) -> Case:
    if not name.strip() or len(name) > 80 or not name.isprintable():
        raise place.error("name the scheme with up to 80 letters, digits and spaces")
    machine, node = build_machine(settle(layers.table("machine")), reader.controls), layers.entries["controller"]
    if isinstance(motion, PartProgram) or machine.control:  # a contour is in machine coordinates
        machine = anchored(machine, motion.reading if isinstance(motion, PartProgram) else None)
    if isinstance(node, Leaf):
        raise node.error("write a table [controller], or the name of its file")
    controller = build_controller(settle(spread(node, machine.axis_names)), machine)
    feed = read_feed(settle(layers.table("feed")), motion, machine)
    machine = machine.planned_as(feed.planner)
    run_table = settle(layers.table("run"))
    run, changes = RunSettings(**read_values(run_table, RunSettings, parts=("changes",))), read_changes(run_table, machine, reader)
    if motion.n_axis != len(machine.axes):
        what = motion.name if isinstance(motion, Contour) else motion.file.name
        cure = "a scheme's machine must have as many axes as the base's"
        raise place.error(f"{what} has {motion.n_axis} coordinates, {machine.name} has the axes {', '.join(machine.axis_names)}: {cure}")
    learning, table = None, settle(layers.table("learning"))
    if table.entries:
        given = read_values(table, LearningSettings, needed=("law",))
        if law := read_component(table.entries["law"], "learning", units_of(machine.axes[0].plant), optional=True):
            learning = LearningSettings(law, **given)
    if learning is not None and (changes or run.start == "moving"):
        key, why = ("changes", "all trials run under one controller") if changes else ("start", "a trial starts from rest")
        raise run_table.error(f"cannot be combined with [learning]: {why}", key)
    return Case(name, machine, controller, motion, feed, run, learning, changes)
