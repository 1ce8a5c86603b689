"""``contourlab new``: files to start from."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from contourlab.cli.output import say
from contourlab.errors import ScenarioError

if TYPE_CHECKING:
    from contourlab.features.machines.new_machine import Question

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
    force: Annotated[bool, typer.Option("--force", help="Overwrite existing files.")] = False,
) -> int:
    """Ask for data-sheet values; write a machine and a controller that fits it."""
    from contourlab.features.machines.new_machine import build_machine, explain, write_machine

    given = _asked() if answers is None else read_answers(answers)
    try:
        files, text = build_machine(given), explain(given)
    except ScenarioError as error:
        # Answers from a file are checked here: name the file.
        raise ScenarioError(error.message, file=answers or error.file, key=error.key) from None
    written = write_machine(files, out, force=force, inputs=() if answers is None else (answers,))
    say("\n".join([text, *(f"wrote {file}" for file in written)]))
    if "scenario.toml" in files:
        say(f"next: contourlab run {out / 'scenario.toml'}")
    return 0


def read_answers(file: Path) -> dict[str, str]:
    """Return the answers of a TOML file: ``name``, ``axes`` and one table for each axis.

    Raises
    ------
    ScenarioError
        If the file cannot be read, or a value is not an answer.
    """
    import tomllib

    try:
        content = tomllib.loads(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise ScenarioError(f"cannot be read: {error.strerror or error}", file=file) from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ScenarioError(f"is not valid TOML: {error}", file=file) from error
    return dict(_flat(content, "", file))


def _flat(content: Mapping[str, Any], prefix: str, file: Path) -> list[tuple[str, str]]:
    answers: list[tuple[str, str]] = []
    for name, value in content.items():
        key = prefix + name
        if isinstance(value, dict) and not prefix:
            answers += _flat(value, f"{name}.", file)
        elif isinstance(value, list) and all(isinstance(item, str) for item in value):
            answers.append((key, ", ".join(value)))
        elif isinstance(value, str | int | float) and not isinstance(value, bool):
            answers.append((key, str(value)))
        else:
            raise ScenarioError(f"{value!r} is not an answer: write text, or a number with its unit", file=file, key=key)
    return answers


def _asked() -> dict[str, str]:
    """Ask on the terminal: about the machine first, then about each of its axes."""
    from contourlab.features.machines.new_machine import axis_names, questions

    print("Press Enter for the value in brackets. A number without a unit has the unit shown.", file=sys.stderr)
    answers: dict[str, str] = {}
    _ask_all(questions(), answers)
    _ask_all(questions(axis_names(answers["axes"])), answers)
    return answers


def _ask_all(asked: Sequence[Question], answers: dict[str, str]) -> None:
    """Ask each question until the answer is valid; through a pipe, once."""
    from contourlab.features.machines.new_machine import axis_names, read_answer

    for question in asked:
        while True:
            answer = _ask(question)
            try:
                read_answer(question, answer)
                if question.key == "axes":
                    axis_names(answer or question.default)
            except ScenarioError as error:
                if not sys.stdin.isatty():
                    raise
                print(error.message, file=sys.stderr)
                continue
            answers[question.key] = answer or question.default
            break


def _ask(question: Question) -> str:
    """Return the typed answer; the question goes to standard error."""
    unit = f" ({question.unit})" if question.unit else ""
    default = f" [{question.default}]" if question.default else ""
    print(f"{question.text}{unit}{default}: ", end="", file=sys.stderr, flush=True)
    try:
        return input().strip()
    except EOFError:
        if sys.stdin.isatty():
            raise KeyboardInterrupt from None
        raise ScenarioError("the input ends before this question: answer it too", file="standard input", key=question.key) from None
