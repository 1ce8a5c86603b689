"""The entry of ``contourlab``: commands, exit codes, and errors as one short message.

Exit codes: 0 done, 1 verdict failed, 2 bad input or output, 3 diverged, 70 a fault in contourlab itself, 130 interrupted. Only Typer is
imported here; a command imports the rest when it runs, so ``--help`` answers at once.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from contextlib import nullcontext
from functools import cache
from pathlib import Path
from typing import Annotated

import typer

from contourlab.cli import output
from contourlab.cli.lines import LINES
from contourlab.cli.output import say, silence
from contourlab.cli.parse import HELP, Group, command_of
from contourlab.errors import ContourlabError, ParameterError, error_text
from contourlab.rendering.stages import heartbeat

NAME = "contourlab"
BAD_INPUT, INTERNAL, INTERRUPTED = 2, 70, 130

app = typer.Typer(name=NAME, cls=Group, add_completion=False, pretty_exceptions_enable=False, context_settings=HELP)


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        say(f"{NAME} {version(NAME)}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version.")] = False,
    debug: Annotated[bool, typer.Option("--debug", help="Show the traceback of an error; anywhere in the command line.")] = False,
) -> None:
    """Find how far a multi-axis machine strays from its programmed path, and which controller keeps it there.

    Start with: contourlab demo
    """


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command.

    Parameters
    ----------
    arguments : sequence of str, optional
        Words after ``contourlab``; by default those of the process.

    Returns
    -------
    int
        The exit code; see the module docstring.
    """
    given, debug = _take_debug(sys.argv[1:] if arguments is None else arguments)
    # A closed stream is None: discard its output, and keep its file descriptor from being reused for a file of ours.
    sys.stdout, sys.stderr = (stream or Path(os.devnull).open("w") for stream in (sys.stdout, sys.stderr))  # noqa: SIM115
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):  # unsupported characters become question marks instead of errors
            stream.reconfigure(errors="replace")
    try:
        if "" in given:  # would become the present folder, or a file of no name
            raise ParameterError(f"argument {given.index('') + 1}", "''", "a value, or left out with its option")
        with nullcontext() if "--json" in given else heartbeat(" ".join(given[:1])):
            code = _call(given or ["--help"])
        sys.stdout.flush()
        return code
    except BrokenPipeError:
        silence()
        return 0
    except BaseException as error:  # a plug-in may raise anything
        if isinstance(error, SystemExit) and isinstance(error.__context__, BrokenPipeError):  # the printer of help
            silence()
            return 0
        if debug:
            import traceback

            traceback.print_exc()
        return _explain(error, debug, given)


def _take_debug(arguments: Sequence[str]) -> tuple[list[str], bool]:
    """Return the arguments without ``--debug``, and whether it was given; arguments after ``--`` stay."""
    given = list(arguments)
    end = given.index("--") if "--" in given else len(given)
    options = [word for word in given[:end] if word != "--debug"]
    return options + given[end:], len(options) < end


@cache
def root() -> Group:
    """Return the command with its sub-commands, which are built when they are called."""
    group = typer.main.get_group(app)
    assert isinstance(group, Group)
    group.hold(LINES, command_of)
    return group


def _call(arguments: list[str]) -> int:
    """Parse and run; return the exit code of the command, 0 if it returns None."""
    output.TYPED[:] = arguments
    try:
        with root().make_context(NAME, arguments) as context:
            return int(root().invoke(context) or 0)
    except typer.Exit as done:
        return int(done.exit_code)


def _in_typed_words(error: BaseException, typed: Sequence[str]) -> str:
    """Return the message of an error; a parameter given as an option gets the name of that option."""
    text = str(error)
    if not isinstance(error, ParameterError) or not text.startswith(error.name):
        return text
    option = "--" + error.name.rstrip("_").replace("_", "-")
    given = any(word.partition("=")[0] == option for word in typed)
    return option + text.removeprefix(error.name) if given else text


def _fault_of_plugin(error: BaseException) -> str:
    """Return place and text of an error raised by the code of a plug-in, or an empty text."""
    place = sys.modules.get("contourlab.components.contract")  # absent: no plug-in was loaded
    return "" if place is None else str(place.raised_in_plugin(error))


def _explain(error: BaseException, debug: bool, typed: Sequence[str] = ()) -> int:
    """Print the error on standard error; return the exit code."""
    code = BAD_INPUT
    if isinstance(error, ContourlabError):
        known = f" [{error.code}]" if error.code else ""
        code, lines = error.exit_code, [f"{NAME}: {_in_typed_words(error, typed)}{known}"]
    elif isinstance(error, KeyboardInterrupt | typer.Abort):
        nothing = "" if getattr(error, "__notes__", ()) else ": no result is kept"
        code, lines = INTERRUPTED, [f"{NAME}: interrupted{nothing}"]
    elif said := _fault_of_plugin(error):
        lines = [f"{NAME}: {said}"]
    elif isinstance(error, typer.TyperException):
        context = getattr(error, "ctx", None)
        place = context.command_path if context is not None else NAME
        lines = [f"{NAME}: {error.format_message() or 'a command is missing'}", f"Try '{place} --help'."]
    elif isinstance(error, OSError):
        lines = [f"{NAME}: {error.filename or 'standard output'}: {error.strerror or error}"]
        if error.filename is None:
            silence()  # else flushing the buffer at exit would fail again
    elif isinstance(error, MemoryError):
        detail = f" ({error})" if str(error) else ""
        lines = [f"{NAME}: not enough memory{detail}: use fewer laps or schemes, or a longer servo period"]
    else:
        code, lines = INTERNAL, [f"{NAME}: internal error: {error_text(error)}"]
        if not debug:
            lines.append("This is a fault in contourlab. Run the same command with --debug and report what it prints.")
    print(*lines, *getattr(error, "__notes__", ()), sep="\n", file=sys.stderr)
    return code
