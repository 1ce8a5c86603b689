"""Answers to the questions: read from a file or asked on a terminal, resolved for each axis, written as a file."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from difflib import get_close_matches
from importlib.resources import files
from pathlib import Path
from typing import Any

from contourlab.errors import ParameterError, ScenarioError
from contourlab.features.machines.questions import AXIS, KEYS, MACHINE, PLACE, SAME, Question, fault, read_value
from contourlab.features.machines.sizing import SizedAxis
from contourlab.file_kinds import mistaken

BLANK = {f"{name}.{SAME.key}": "x except moved_mass" for name in "yz"}
"""Answers of a template."""
PRESETS = ("router", "mill", "stage")
NAME = re.compile(r"[A-Za-z0-9_]{1,32}\Z")
MOST_AXES = 9
_SAME = re.compile(r"(?:same as\s+)?(?P<axis>\w+)(?:\s+(?:except|but)\b\s*(?P<keys>.*))?\Z", re.IGNORECASE)
_ON = re.compile(r"(\w+)\s+on\s+(\w+)\Z")


def axis_names(answers: Mapping[str, str]) -> tuple[str, ...]:
    """Return the names of the axes.

    Raises
    ------
    ScenarioError
        If there is no name, a name is repeated, or a name is invalid.

    >>> axis_names({"axes": "x, y"})
    ('x', 'y')
    """
    names = tuple((answers.get("axes") or MACHINE[1].guess()).replace(",", " ").split())
    if not 1 <= len(names) <= MOST_AXES:
        raise fault("axes", f"{len(names)} axes: give 1 to {MOST_AXES}, as in x, y, z")
    for name in names:
        if not NAME.match(name):
            raise fault("axes", f"{name!r} is not a valid axis name: use letters, digits and _")
        # The axis files must differ also on file systems that ignore case.
        if [other.lower() for other in names].count(name.lower()) > 1:
            raise fault("axes", f"axis {name!r} is given twice")
    return names


def machine_values(answers: Mapping[str, str]) -> dict[str, Any]:
    """Return the answers about the machine, in SI or as text."""
    return {question.key: read_value(question, question.key, answers.get(question.key, ""), SizedAxis("", 0.0)) for question in MACHINE}


def mounting(answers: Mapping[str, str]) -> dict[str, str]:
    """Return the axis below each axis that has one.

    Raises
    ------
    ScenarioError
        If an axis is unknown, or axes are mounted on each other in a circle.
    """
    names, below = axis_names(answers), {}
    for pair in filter(None, (part.strip() for part in answers.get("mounting", "").split(","))):
        match = _ON.match(pair)
        if match is None:
            raise fault("mounting", f"{pair!r}: write for example z on y, y on x")
        below[match[1]] = ("mounting", match[2])
    below |= {name: (f"{name}.mounted_on", answers[f"{name}.mounted_on"]) for name in names if answers.get(f"{name}.mounted_on")}
    for name, (key, under) in below.items():
        if name not in names or under not in names or under == name:
            raise fault(key, f"{name} on {under}: name two axes of {', '.join(names)}")
        trail = [name]
        while trail[-1] in below:
            trail.append(below[trail[-1]][1])
            if trail[-1] in trail[:-1]:
                raise fault(key, "the axes are mounted on each other in a circle")
    return {name: under for name, (_, under) in below.items()}


def travels(answers: Mapping[str, str]) -> dict[str, str]:
    """Return the answers about the travel of each axis, empty for none.

    Raises
    ------
    ScenarioError
        If they are not one for each axis, or one is not a travel.
    """
    names, text = axis_names(answers), answers.get("travel", "")
    parts = [part.strip() for part in text.split(",")] if text else [""] * len(names)
    if len(parts) != len(names):
        raise fault("travel", f"{len(parts)} for the axes {', '.join(names)}: write one for each, with commas")
    question = next(question for question in AXIS if question.key == "travel")
    for part in parts:
        read_value(question, "travel", part, SizedAxis("", 0.0))
    return dict(zip(names, parts, strict=True))


def same_as(answers: Mapping[str, str], name: str) -> tuple[str, tuple[str, ...]]:
    """Return the axis that an axis repeats, and the keys that it does not repeat; empty where it repeats none.

    Raises
    ------
    ScenarioError
        If the answer is not ``AXIS except KEY, KEY``.
    """
    key, text = f"{name}.{SAME.key}", answers.get(f"{name}.{SAME.key}", "")
    if text.lower() in ("", "no", "none"):
        return "", ()
    match, names = _SAME.match(text), [other for other in axis_names(answers) if other != name]
    if match is None or match["axis"] not in names:
        raise fault(key, f"{text!r}: write one of {', '.join(names)}, then except and what differs")
    kept = tuple(word for word in re.split(r"[,\s]+|\band\b", match["keys"] or "") if word)
    for word in kept:
        if word not in KEYS:
            raise fault(key, _unknown(word, KEYS))
    return match["axis"], kept


def answers_of(answers: Mapping[str, str], name: str, trail: tuple[str, ...] = ()) -> dict[str, str]:
    """Return the answers about an axis, with those that it repeats from another."""
    if name in trail:
        raise fault(f"{name}.{SAME.key}", "the axes repeat each other in a circle")
    other, kept = same_as(answers, name)
    repeated = answers_of(answers, other, (*trail, name)) if other else {}
    own = {"travel": travels(answers)[name]} | {key: answers[f"{name}.{key}"] for key in KEYS if f"{name}.{key}" in answers}
    return {key: text for key, text in repeated.items() if key not in (*kept, *PLACE)} | own


def sized(answers: Mapping[str, str], name: str, period: float, until: str = "") -> SizedAxis:
    """Return an axis with the values of its questions up to `until`, or of all.

    Raises
    ------
    ScenarioError
        If an answer is missing or implausible; has the key of its question.
    """
    axis, given = SizedAxis(name, period), answers_of(answers, name)
    for question in AXIS:
        if question.key == until:
            break
        text = given.get(question.key, "")
        if not question.drive or question.drive == axis.values["drive"]:
            axis.values[question.key] = read_value(question, f"{name}.{question.key}", text, axis)
            if not text and question.default:
                axis.guesses.add(question.key)
        elif text:
            raise fault(f"{name}.{question.key}", f"a {axis.values['drive']} drive has no such value")
    return axis


def check_keys(answers: Mapping[str, str]) -> None:
    """Raise ScenarioError if a key is no question."""
    names, general = axis_names(answers), [question.key for question in MACHINE]
    for key in answers:
        name, dot, inner = key.partition(".")
        if not dot and key not in general:
            raise fault(key, _unknown(key, (*general, *names)))
        if dot and name not in names:
            raise fault(key, f"{name!r} is not an axis: axes names {', '.join(names)}")
        if dot and inner not in (SAME.key, *KEYS):
            raise fault(key, _unknown(inner, (SAME.key, *KEYS)))


def _unknown(word: str, known: tuple[str, ...]) -> str:
    near = get_close_matches(word, known, n=1, cutoff=0.0)[0]
    return f"no question {word!r}: the nearest is {near!r}; there are {', '.join(known)}"


def questions(answers: Mapping[str, str], also: frozenset[str] = frozenset()) -> Iterator[Question]:
    """Yield the questions that a terminal asks, after the answers so far; `also` are further keys to ask.

    The keys are full, and the defaults are those of the answers before. To be continued only while each question yielded is answered.
    """
    yield from (question for question in MACHINE if question.asked or question.key in also)
    period = machine_values(answers)["servo_period"]
    names = axis_names(answers)
    for i, name in enumerate(names):
        if i:
            yield replace(SAME, key=f"{name}.{SAME.key}", default=f"{names[0]} except moved_mass")
        for question in AXIS:
            other, kept = same_as(answers, name)
            wanted = question.key in kept or f"{name}.{question.key}" in also
            if not other or (question.key in PLACE):
                wanted = wanted or question.asked
            if question.key == "unbalanced_mass" and not name.lower().startswith("z") and f"{name}.{question.key}" not in also:
                continue
            if wanted and question.drive in ("", sized(answers, name, period, "rated_torque").values["drive"]):
                guess = question.guess(sized(answers, name, period, question.key)) if callable(question.default) else question.default
                yield replace(question, key=f"{name}.{question.key}", default=guess)
    yield MACHINE[-1]  # the travel


def interview(
    ask: Callable[[Question], str], remark: Callable[[ScenarioError], None], check: Callable[[Mapping[str, str]], object]
) -> dict[str, str]:
    """Ask until all answers are valid and fit together.

    Parameters
    ----------
    ask : callable
        Returns the typed answer of a question; ``back`` returns to the question before.
    remark : callable
        Called with what is wrong with an answer, before it is asked again; may raise it.
    check : callable
        Raises ScenarioError with the key of the answer that does not fit.
    """
    answers: dict[str, str] = {}
    order: list[str] = []
    also: set[str] = set()
    while True:
        question = next((q for q in questions(answers, frozenset(also)) if q.key not in answers), None)
        given = {key: text for key, text in answers.items() if text}
        try:
            if question is None:
                check(given)
                return given
            text = ask(question).strip()
            if text.lower() == "back":
                answers.pop(order.pop() if order else "", None)
                continue
            _check_answer(question, text, answers)
            # The default of this question is an answer of its own.
            answers[question.key] = text or (question.guess() if question.key.endswith(f".{SAME.key}") else "")
            order.append(question.key)
        except ScenarioError as error:
            if question is None and error.key in also and error.key not in answers:
                raise  # no question changes this
            remark(error)
            also.add(error.key)
            answers.pop(error.key, None)


def _check_answer(question: Question, text: str, answers: Mapping[str, str]) -> None:
    """Raise ScenarioError if an answer is not valid after those before it."""
    name, dot, key = question.key.partition(".")
    tried = {**answers, question.key: text}
    if dot and key == SAME.key:
        answers_of({**answers, question.key: text or question.guess()}, name)
    elif dot:
        own = next(own for own in AXIS if own.key == key)
        axis = sized(answers, name, machine_values(answers)["servo_period"], key)
        read_value(own, question.key, text, axis)
    else:
        machine_values(tried)
        mounting(tried)
        travels(tried)


def read_answers(file: str | Path) -> dict[str, str]:
    """Return the answers of a TOML file: about the machine, and one table for each axis.

    Raises
    ------
    ScenarioError
        If the file cannot be read, or a value is not an answer.
    """
    path = Path(file)
    if words := mistaken(path, "a file of answers"):
        raise ScenarioError(words, file=path)
    try:
        content = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise ScenarioError(f"cannot be read: {error.strerror or error}", file=path) from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ScenarioError(f"is not valid TOML: {error}", file=path) from error
    return dict(_flat(content, "", path))


def _flat(content: Mapping[str, Any], prefix: str, file: Path) -> Iterator[tuple[str, str]]:
    for name, value in content.items():
        key = prefix + name
        if isinstance(value, dict) and not prefix:
            yield from _flat(value, f"{name}.", file)
        elif isinstance(value, list) and all(isinstance(item, str) for item in value):
            yield key, ", ".join(value)
        elif isinstance(value, str | int | float) and not isinstance(value, bool):
            yield key, str(value).strip()
        else:
            raise ScenarioError(f"{value!r} is not an answer: write text, or a number with its unit", file=file, key=key)


def preset_file(name: str) -> Path:
    """Return the file of answers of a class of machines: one of `PRESETS`."""
    if name not in PRESETS:
        raise ParameterError("--preset", repr(name), f"one of {', '.join(PRESETS)}")
    return Path(str(files("contourlab.features.machines"))) / "presets" / f"{name}.toml"


def answers_text(answers: Mapping[str, str]) -> str:
    """Return answers as a file; what was not answered is a comment with its default."""
    lines = ["# Answers for contourlab new machine --answers FILE. A line that begins with # takes its default.", ""]
    lines += [_line(question, answers.get(question.key, "")) for question in MACHINE]
    for name in axis_names(answers):
        own = {key: answers.get(f"{name}.{key}", "") for key in KEYS}
        other, kept = same_as(answers, name)
        drive = "linear" if own["drive"].startswith("linear") else "screw"
        lines += ["", f"[{name}]"]
        lines += [_line(SAME, answers[f"{name}.{SAME.key}"])] if other else []
        shown = [q for q in AXIS if own[q.key] or (q.key in kept if other else q.drive in ("", drive))]
        lines += [_line(question, own[question.key]) for question in shown]
    return "\n".join(lines) + "\n"


def _line(question: Question, text: str) -> str:
    open_ = "" if text or question.default is None else "# "
    value = json.dumps(text or question.guess(), ensure_ascii=False)
    return f"{open_}{question.key} = {value}" + ("" if question is SAME else f"  # {question.about}")
