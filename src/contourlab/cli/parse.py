"""Commands made from the options of their questions: each is built when it is called."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from typing import Annotated, Any

import typer
from typer.core import TyperCommand, TyperGroup

from contourlab.app.options import REQUIRED, Part
from contourlab.app.session import Command, execute
from contourlab.cli import output
from contourlab.cli.output import say, suggest, wants_progress
from contourlab.errors import ContourlabError

PANELS = {
    "Start": "demo new check run measure circle limits tune commission precompensate",
    "Simulate": "compare learn analyse backlash link sweep",
    "Measure": "record identify refine interpolate",
    "Tune": "notch sensitivity swap export",
    "Papers": "reproduce",
    "Look up": "components machines explain schema canon",
}
"""Commands by the panel of the help that lists them."""
HOMES = {
    **dict.fromkeys(("compare", "demo", "learn"), "contourlab.features.run.options"),
    **dict.fromkeys(("machines", "components", "explain", "schema"), "contourlab.cli.look_up"),
    "canon": "contourlab.features.check.options",
    "new": "contourlab.features.machines.options",
    "reproduce": "contourlab.papers.options",
}
"""Modules of commands that are not in ``contourlab.features.NAME.options``: each has `COMMANDS`."""
HELP = {"help_option_names": ["-h", "--help"]}


PANEL_OF = {name: panel for panel, names in PANELS.items() for name in names.split()}


class Group(TyperGroup):
    """A group of commands that are built when they are called."""

    builder: Callable[[str], Any]
    default = ""

    def hold(self, lines: Mapping[str, str], builder: Callable[[str], Any], default: str = "") -> None:
        """Take commands by their lines of help, with what builds one, and the one that may be left out."""
        panels = {} if self.name in PANEL_OF else PANEL_OF
        self.commands = {name: TyperCommand(name, help=line, rich_help_panel=panels.get(name)) for name, line in lines.items()}
        self.builder, self.default = builder, default

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Put the default command in front of anything that is neither a command nor help."""
        if self.default and args and args[0] not in (*self.commands, "--help", "-h"):
            args = [self.default, *args]
        return super().parse_args(ctx, args)

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Build the command that is called."""
        name, _, rest = super().resolve_command(ctx, args)
        return name, self.builder(name or ""), rest

    def whole(self) -> dict[str, Any]:
        """Return all commands, with their options."""
        return {name: self.builder(name) for name in self.commands}


def home_of(name: str) -> str:
    """Return the module of the options of a command."""
    return HOMES.get(name, f"contourlab.features.{name}.options")


@cache
def command_of(name: str) -> Any:
    """Return a command, or the group of commands of that name."""
    found = import_module(home_of(name)).COMMANDS[name]
    if isinstance(found, Command):
        return _command(name, name, found)
    made = Group(name=name, help=found.help, context_settings=HELP, rich_markup_mode="rich", no_args_is_help=True)
    members = found.members
    lines = {each: line_of(one) for each, one in members.items()}
    made.hold(lines, cache(lambda each: _command(each, f"{name} {each}", members[each])), found.default)
    return made


def line_of(found: Any) -> str:
    """Return the line of help of a command or a group."""
    return str(found.help.split("\n\n")[0])


def _command(name: str, place: str, command: Command) -> Any:
    """Return a command with its options, arguments first."""
    files, settings = (kind.PARTS.values() for kind in (command.files, command.settings))
    every = sorted((*settings, *files), key=lambda part: not part.option.argument)

    def call(**values: Any) -> int:
        return _answered(command, place, values)

    call.__signature__ = inspect.Signature([_parameter(part) for part in every])  # type: ignore[attr-defined]
    app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, context_settings=HELP)
    app.command(name, help=_escaped(command.help))(call)
    return typer.main.get_command(app)


def _parameter(part: Part) -> inspect.Parameter:
    says = part.option
    kind: Any = list[part.kind] if part.many and not says.listed else str if part.many else part.kind  # type: ignore[name-defined]
    default = inspect.Parameter.empty if part.default is REQUIRED else None if part.many or part.default == "" else part.default
    look: dict[str, Any] = {"help": _escaped(says.help), "metavar": says.metavar or None, "show_default": default is not None}
    look |= {"rich_help_panel": "Advanced"} if says.advanced else {}
    about = typer.Argument(**look) if says.argument else typer.Option("/".join(filter(None, (part.typed, part.negative))), **look)
    annotation: Any = Annotated[kind if default is not None else kind | None, about]
    return inspect.Parameter(part.name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)


def _escaped(text: str) -> str:
    """Escape brackets, which are markup in a help."""
    return text.replace("[", r"\[")


def _answered(command: Command, place: str, values: dict[str, Any]) -> int:
    """Ask a question, print the answer and the next command; return the exit code."""
    as_json = bool(values.get("as_json"))
    try:
        answer, asked = execute(command, place, values, output.TYPED, wants_progress(as_json))
    except ContourlabError as error:
        if as_json:
            from contourlab.app.json_values import json_text
            from contourlab.features.check.program_check import Message, Refused

            say(json_text(Refused((Message.of(error),))))
        raise
    if answer.SILENT and isinstance(answer.stopped, KeyboardInterrupt):
        raise answer.stopped
    if hasattr(answer, "write"):  # too long for one text
        sys.stderr.writelines(f"{line}\n" for line in answer.write(sys.stdout, as_json))
    elif as_json:
        say(answer.to_json())
    elif text := answer.text:
        say(text)
    for aside in answer.asides:
        print(aside, file=sys.stderr)
    if words := answer._next(asked):
        suggest(as_json, *words)
    if answer.stopped is not None:
        raise answer.stopped
    return int(answer.exit_code)
