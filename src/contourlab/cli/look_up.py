"""``contourlab components``, ``machines``, ``explain`` and ``schema``: what there is, and what it means."""

from __future__ import annotations

import inspect
from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from importlib import import_module
from operator import or_
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_type_hints

from contourlab.app.options import Options, argument, option, options
from contourlab.app.session import Answer, Asked, Command, Session
from contourlab.app.shared_options import Shown
from contourlab.errors import ParameterError, check_known, refuse

if TYPE_CHECKING:
    from contourlab.features.machines.command import Shipped

FOOT = (
    "contourlab machines NAME shows one; --copy FOLDER copies it with the files that it names. In a scenario write "
    'machine = "builtin:NAME"; contourlab run builtin:NAME runs a scenario.'
)
HERE = "contourlab.cli.look_up:"


@dataclass(frozen=True, eq=False)
class Entry(Answer):
    """What was looked up: as a value, as text, and the command to type next."""

    value: Any
    words: str
    then: Sequence[object] = ()

    @property
    def json(self) -> Any:
        """The value."""
        return self.value

    @property
    def text(self) -> str:
        """The text."""
        return self.words

    def _next(self, asked: Asked) -> Sequence[object]:
        """Look at an entry, or use it."""
        return self.then


@options
class Components(Options):
    """List the components; show a family or one component with all parameters."""

    plugin: tuple[Path, ...] = option((), "Load and check the components of a Python file; repeatable.")


@options
class OfKind(Shown):
    """The argument."""

    name: str | None = argument("KIND", "A family (plant), a kind (rigid-axis) or both (plant/rigid-axis).", None)


def components(name: str | None, settings: Components, session: Session) -> Entry:
    """List the components, or show some."""
    from contourlab.components.conformance import check_component
    from contourlab.components.registry import components as known
    from contourlab.components.registry import load_plugin
    from contourlab.features.components.description import chosen, describe, details, overview

    parts = []
    for file in {file.resolve(): file for file in settings.plugin}.values():
        for kind in load_plugin(file):
            checks = check_component(kind)
            parts.append("\n".join([f"{kind.family}/{kind.kind} keeps the contract:", *(f"  {words}" for words in checks), ""]))
    kinds = chosen(name, known())
    parts += [overview(kinds).text()] if name is None else [part for kind in kinds for part in details(kind)]
    value = [describe(kind) for kind in kinds]
    return Entry(value, "\n".join(parts), ("components", kinds[0].kind) if name is None else ("machines",))


@options
class Machines(Options):
    """List the shipped machines, axes, controllers and runs with the sources of their numbers; show or copy one."""

    copy: Path | None = option(None, "Copy it, and the files that it names, into this folder.", metavar="FOLDER")
    force: bool = option(False, "Overwrite existing files.")


@options
class OfMachine(Shown):
    """The argument."""

    name: str | None = argument("NAME", "A shipped file, or your own.", None)


def machines(name: str | None, settings: Machines, session: Session) -> Entry:
    """List the shipped files, show one, or copy one."""
    from contourlab.features.machines.command import copy_shipped, shipped, shipped_one

    if name is None:
        refuse(settings.copy is not None, ParameterError, "--copy", repr(str(settings.copy)), "given with the name of the file to copy")
        files = shipped()
        return Entry(files, _list(files), ("machines", "demo-part"))
    if settings.copy is not None:
        written = copy_shipped(name, settings.copy, force=settings.force)
        said = "\n".join(f"wrote {file}" for file in written)
        return Entry(written, said, ("run" if shipped_one(name).kind == "scenario" else "machines", written[0]))
    file = shipped_one(name)
    own = str(file.file) == name
    if file.kind == "scenario":
        return Entry(file, _details(file), ("run", name if own else f"builtin:{name}"))
    return Entry(file, _details(file), ("machines",) if own else ("machines", name, "--copy", "mine"))


def _list(files: list[Shipped]) -> str:
    from contourlab.rendering.table import Column, Table, paragraphs

    names, prose = ("kind", "name", "axes"), ("description", "sources")
    rows = ((file.kind, file.name, ", ".join(file.axes), file.about, "; ".join(file.references)) for file in files)
    table = Table([*(Column(head, left=True) for head in names), *(Column(head, prose=True) for head in prose)], rows=rows)
    return f"{table.text()}\n\n{paragraphs([FOOT])}"


def _details(file: Shipped) -> str:
    from contourlab.rendering.table import Column, Table, paragraphs

    axes = f" with the axes {', '.join(file.axes)}" if file.axes else ""
    shown = file.name if file.name == str(file.file) else f"builtin:{file.name}"
    head = [f"{shown}, {file.kind}{axes}", f"file: {file.file}"]
    if not file.numbers:
        return "\n".join([*head, "", file.text.rstrip()])
    sources = ", ".join(f"{count} {source}" for source, count in file.sources.items())
    plain = (Column("value"), *(Column(name, left=True) for name in ("unit", "source", "deviation")))
    rows = ((one.name, one.value_text, one.display, one.source, one.deviation_text, one.reference, one.note) for one in file.numbers)
    table = Table([Column("number", left=True), *plain, Column("from", prose=True), Column("note", prose=True)], rows=rows)
    findings = ["", paragraphs(map(str, file.findings))] if file.findings else []
    return "\n".join([*head, f"{file.about}.", f"numbers: {sources}", table.text(), *findings])


@options
class Explain(Options):
    """Explain a finding: what it means, and what to do about it. Or a file that contourlab wrote: what made it."""

    cite: bool = option(False, "Print BibTeX of the methods behind a file.")


@options
class OfCode(Shown):
    """The argument."""

    code: str | None = argument("[CODE]", "Code of a finding, such as CL104, or a file. Without it, list all findings.", None)


def explain(code: str | None, settings: Explain, session: Session) -> Entry:
    """List the findings, explain one, or say what made a file."""
    if code is not None and Path(code).is_file():
        from contourlab.app.cite import cite
        from contourlab.result.stamp import read_stamp

        text = cite(code) if settings.cite else ""
        made = {"bibtex": text} if text else read_stamp(code)
        return Entry(made, text or "\n".join(f"{key}: {value.replace(',', ', ')}" for key, value in made.items()))
    refuse(settings.cite, ParameterError, "--cite", "given", "left out: it is about a file that contourlab wrote")
    from contourlab.findings import catalogue
    from contourlab.rendering.table import Column, Table, page_width, paragraphs

    entries = catalogue()
    if code is None:
        columns = [Column("code", left=True), Column("severity", left=True), Column("name", left=True), Column("text", prose=True)]
        table = Table(columns, rows=((entry.code, entry.severity, entry.name, entry.outline) for entry in entries.values()))
        return Entry(list(entries.values()), table.text(), ("explain", next(iter(entries))))
    entry = entries.get(f"CL{code}" if code.isdigit() else code.upper())
    if entry is None:
        raise ParameterError("CODE", repr(code), "a code that `contourlab explain` lists, or a file that contourlab wrote")
    texts = [f"{entry.code} {entry.name} ({entry.severity})", entry.outline, entry.meaning, f"What to do: {entry.remedy}"]
    return Entry([entry], "\n\n".join(paragraphs([text], page_width(), indent="") for text in texts))


@options
class Schema(Options):
    """Print the JSON Schema of what a command prints with --json."""


@options
class OfCommand(Options):
    """The argument."""

    command: str = argument("COMMAND", "A command that has --json, such as run.")


def schema(command: str, settings: Schema, session: Session) -> Entry:
    """Return the JSON Schema of a command's result."""
    import json

    from contourlab.app.json_schema import json_schema

    known = results()
    check_known("COMMAND", command, known)
    value = json_schema(known[command], f"contourlab {command} --json")
    return Entry(value, json.dumps(value, indent=2))


def results() -> dict[str, Any]:
    """Return the type of what each command prints with ``--json``."""
    from contourlab.cli.parse import PANEL_OF, home_of
    from contourlab.features.check.canon import Canon
    from contourlab.features.check.program_check import Refused
    from contourlab.features.components.description import ComponentDescription
    from contourlab.features.machines.command import Shipped
    from contourlab.findings import Entry as Explained

    of_lists = {
        "canon": Canon,
        "components": tuple[ComponentDescription, ...],
        "explain": tuple[Explained, ...] | dict[str, str],
        "machines": Shipped | tuple[Shipped, ...] | tuple[Path, ...],
    }
    types = {name: of_lists.get(name) or _printed(import_module(home_of(name)).COMMANDS[name]) for name in PANEL_OF if name != "schema"}
    return {name: kind | Refused for name, kind in sorted(types.items()) if kind is not None}


def _printed(command: Any) -> Any:
    """Return the type that a command or group prints; None without ``--json``."""
    members = [command] if isinstance(command, Command) else command.members.values()
    kinds: list[Any] = []
    for member in members:
        if issubclass(member.files, Shown):
            module, _, function = member.ask.partition(":")
            home = import_module(module)
            ask = inspect.unwrap(getattr(home, function))
            ask = getattr(ask, "func", ask)  # the question of one paper is part of another
            kinds += [getattr(home, word) for word in ask.__annotations__["return"].split(" | ")]
    own = [get_type_hints(kind.json.fget)["return"] if "json" in vars(kind) else kind for kind in kinds]
    return reduce(or_, dict.fromkeys(own)) if own else None


COMMANDS = {
    "components": Command(f"{HERE}components", Components, OfKind),
    "machines": Command(f"{HERE}machines", Machines, OfMachine),
    "explain": Command(f"{HERE}explain", Explain, OfCode),
    "schema": Command(f"{HERE}schema", Schema, OfCommand),
}
