"""``contourlab new machine``: files to start from."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from contourlab.app.command_line import as_typed
from contourlab.app.session import Session
from contourlab.cli.look_up import Entry
from contourlab.errors import ScenarioError, refuse
from contourlab.features.machines.options import NewMachine

if TYPE_CHECKING:
    from contourlab.features.machines.answers import Question


def machine(settings: NewMachine, session: Session) -> Entry:
    """Ask for data-sheet values; write a machine and a controller that fits it."""
    from contourlab.controls import control_file
    from contourlab.features.machines.answers import BLANK, answers_text, axis_names, interview, of_control, preset_answers, read_answers
    from contourlab.features.machines.new_machine import check_folder, new_machine, write_machine
    from contourlab.units import show

    out, answers = settings.out, settings.answers
    refuse(settings.from_ is not None and not settings.from_.is_file(), ScenarioError, "no such file", file=settings.from_)
    control = None if settings.from_ is None else control_file(settings.from_)
    if control is None and settings.from_ is not None:
        raise ScenarioError("is not the file of a control that is known: name the INI file of LinuxCNC, for example", file=settings.from_)
    known = {} if control is None else of_control(control)
    preset = {} if settings.preset is None else preset_answers(settings.preset, known)
    if settings.template:
        blank = {key: text for key, text in BLANK.items() if not known or key.partition(".")[0] in axis_names(known)} | known
        text = (answers_text(preset or blank) if answers is None else answers.read_text(encoding="utf-8")).rstrip()
        return Entry(text, text)
    check_folder(out, force=settings.force)
    asks = answers is None and not preset
    if asks:
        hint = "Press Enter for the value in brackets. Type back for the question before. A bare number has the unit shown."
        print(hint, file=sys.stderr)
    try:
        given = interview(_ask, _remark, new_machine, known) if asks else read_answers(answers) if answers else preset
        for key, text in known.items() if answers is not None else ():
            if given.get(key, text) != text:
                raise ScenarioError(f"{given[key]!r}, but the control's file has {text}: leave it out", key=key)
        given = {**given, **known}
        made = new_machine(given, out.resolve().name, control)
    except ScenarioError as error:
        # Answers from a file are checked here: name the file.
        raise ScenarioError(error.message, file=answers or error.file, key=error.key) from None
    written = write_machine(made, out, force=settings.force, inputs=[read for read in (answers, settings.from_) if read is not None])
    lines = [made.summary(), *(f"wrote {target}" for target in written)]
    has_scenario = "scenario.toml" in made.files()
    lines += [f"next: contourlab run {as_typed([str(out)])}"] if has_scenario else []
    what, tolerance = "your part" if has_scenario else "next", show(made.tolerance, "um")
    lines.append(f'{what}: contourlab run part.ngc --machine {as_typed([str(out)])} --tolerance "{tolerance}"')
    return Entry(written, "\n".join(lines))


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
        if question.key == "backlash":  # scripts of answers from before this question end here
            print("not answered, none is simulated", file=sys.stderr)
            return ""
        raise ScenarioError("the input ends before this question: answer it too", file="standard input", key=question.key) from None


def _remark(error: ScenarioError) -> None:
    """Print what is wrong with a typed answer; through a pipe nobody could correct it."""
    if not sys.stdin.isatty():
        raise error
    print(f"{error.key}: {error.message}", file=sys.stderr)
