"""``contourlab new``: files to start from."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from contourlab.app.command_line import as_typed
from contourlab.cli.output import say
from contourlab.errors import ParameterError, ScenarioError

if TYPE_CHECKING:
    from contourlab.features.machines.answers import Question

new = typer.Typer(no_args_is_help=True, help="Write files to start from.")


@new.callback()
def _things() -> None:
    """Keep `machine` a subcommand while it is the only one."""


@new.command()
def machine(
    out: Annotated[Path, typer.Option(help="Folder for the files.")] = Path("machine"),
    answers: Annotated[
        Path | None, typer.Option(help="Take the answers from a TOML file and ask nothing.", metavar="FILE", show_default=False)
    ] = None,
    preset: Annotated[
        str | None, typer.Option(help="Take typical answers and ask nothing: router, mill or stage.", metavar="CLASS", show_default=False)
    ] = None,
    template: Annotated[bool, typer.Option("--template", help="Print a file of answers to fill in, and write nothing.")] = False,
    force: Annotated[bool, typer.Option("--force", help="Overwrite existing files.")] = False,
) -> int:
    """Ask for data-sheet values; write a machine and a controller that fits it."""
    from contourlab.features.machines.answers import BLANK, answers_text, interview, preset_file, read_answers
    from contourlab.features.machines.new_machine import check_folder, new_machine, write_machine
    from contourlab.units import show

    if answers is not None and preset is not None:
        raise ParameterError("--preset", repr(preset), "left out where --answers is given")
    file = answers if preset is None else preset_file(preset)
    if template:
        say((answers_text(BLANK) if file is None else file.read_text(encoding="utf-8")).rstrip())
        return 0
    check_folder(out, force=force)
    name = out.resolve().name
    if file is None:
        hint = "Press Enter for the value in brackets. Type back for the question before. A bare number has the unit shown."
        print(hint, file=sys.stderr)
    try:
        given = interview(_ask, _remark, new_machine) if file is None else read_answers(file)
        made = new_machine(given, name)
    except ScenarioError as error:
        # Answers from a file are checked here: name the file.
        raise ScenarioError(error.message, file=answers or error.file, key=error.key) from None
    written = write_machine(made, out, force=force, inputs=() if answers is None else (answers,))
    say("\n".join([made.summary(), *(f"wrote {target}" for target in written)]))
    if "scenario.toml" in made.files():
        say(f"next: contourlab run {as_typed([str(out)])}")
    what = "your part" if "scenario.toml" in made.files() else "next"
    say(f'{what}: contourlab run part.ngc --machine {as_typed([str(out)])} --tolerance "{show(made.tolerance, "um")}"')
    return 0


def _ask(question: Question) -> str:
    """Return the typed answer; the question goes to standard error."""
    unit = f" ({question.unit})" if question.unit else ""
    default = f" [{question.guess()}]" if question.guess() else ""
    print(f"{question.key}: {question.text}{unit}{default}: ", end="", file=sys.stderr, flush=True)
    try:
        return input()
    except EOFError:
        if sys.stdin.isatty():
            raise KeyboardInterrupt from None
        raise ScenarioError("the input ends before this question: answer it too", file="standard input", key=question.key) from None


def _remark(error: ScenarioError) -> None:
    """Print what is wrong with a typed answer; through a pipe nobody could correct it."""
    if not sys.stdin.isatty():
        raise error
    print(f"{error.key}: {error.message}", file=sys.stderr)
