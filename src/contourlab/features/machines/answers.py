"""Answers to the questions: read from a file or asked on a terminal, resolved for each axis, written as a file."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from difflib import get_close_matches
from importlib.resources import files
from itertools import takewhile
from pathlib import Path
from typing import Any

from contourlab.controls import ControlFile
from contourlab.errors import ScenarioError, UnitError, check_known, refuse
from contourlab.features.machines.sizing import GRAVITY, KV_RATIO, SizedAxis, rounded
from contourlab.scenario.quantities import read_number
from contourlab.scenario.tree import Table, read_tree
from contourlab.units import from_si, show, split

_PER_TURN = re.compile(r"\s*(?:/|per)\s*(?:rev(?:olution)?|turn)\b")
_COUNTS = re.compile(r"(?P<lines>\d+)\s*(?:lines?\s*)?[x×*]\s*(?P<steps>\d+)|(?P<bits>\d+)\s*bits?|(?P<counts>\d+)\s*counts?")
_PERIOD = re.compile(r"(?P<period>.*[^\d\s])\s*(?:/|x|×)\s*(?P<steps>\d+)")
_SPEED = re.compile(r"(\d+(?:\.\d*)?)\s*(?:rpm|1/min|U/min)")
DRIVES = ("screw", "velocity", "linear", "step-drive", "stepper")
_OTHER_WORDS = {"ball-screw": "screw", "belt": "screw", "rack": "screw", "torque": "screw", "linear-motor": "linear"}
SERVO, TURNING = ("screw", "velocity"), ("screw", "velocity", "stepper")
"""Drives by a motor with a torque constant, and by any motor that turns."""
LOOPS = (*SERVO, "linear")
"""Drives whose position loop the control closes."""
_FASTEST = {"screw": 50.0, "velocity": 50.0, "stepper": 10.0, "linear": 1.0, "step-drive": 0.15}
"""Turns per second at which motors usually run; of others the speed [m/s]."""


@dataclass(frozen=True)
class Question:
    """One question.

    Attributes
    ----------
    key : str
        Key of the answer, within its axis.
    text : str
        Printed text.
    unit : str
        Unit of a bare number; empty for text.
    least, most : float
        What machines have, in `unit`.
    default : str, callable or None
        Value without an answer, or a function that guesses it in SI from the answers before; None: an answer is required.
    rule : str
        How the default is guessed.
    spread : (float, float) or None
        Lowest and highest value over the guess; None where a number is not drawn.
    asked : bool
        Whether the terminal asks; if not, only a file can answer.
    drives : tuple of str
        Drives that have it; empty: all.
    """

    key: str
    text: str
    unit: str = ""
    least: float = 0.0
    most: float = math.inf
    default: str | Callable[[SizedAxis], float | str] | None = None
    rule: str = ""
    spread: tuple[float, float] | None = None
    asked: bool = True
    drives: tuple[str, ...] = ()

    @property
    def about(self) -> str:
        """Text, unit and range, for a comment."""
        span = f" [{self.unit}], {self.least:g} to {self.most:g}" if self.unit else ""
        return f"{self.text}{span}" + (f"; default: {self.rule}" if self.rule else "")

    def guess(self, axis: SizedAxis | None = None) -> str:
        """Return the answer taken without one, as text."""
        if callable(self.default) and axis is not None:
            guess = self.default(axis)
            return guess if isinstance(guess, str) else show(guess, self.unit, 4)
        return self.default if isinstance(self.default, str) else ""


MACHINE = (
    Question("name", "Name of the machine", default="", rule="the name of the folder", asked=False),
    Question("axes", "Names of the axes, in the order of the coordinates", default="x, y, z"),
    Question("servo_period", "Servo period", "ms", 0.02, 20.0, "1 ms"),
    Question("mounting", "Axes that stand on another axis, e.g. z on y, y on x (Enter: none)", default=""),
    Question("tolerance", "Tolerance of the first run", "um", 0.01, 5000.0, "50 um", asked=False),
    Question("travel", "Travel of each axis from end to end, e.g. 750 mm, 500 mm, 120 mm (Enter: unknown)", default="", asked=False),
    Question("backlash", "Backlash of each axis, as measured at the table, e.g. 20 um, 20 um, 0 (Enter: none)", default="", asked=False),
)
EACH = MACHINE[-2:]
"""Questions with an answer for each axis."""
SAME = Question("same_as", "Same as which axis? Name what differs, as in x except moved_mass, lead (no: ask everything)", default="")


def _rubbing(axis: SizedAxis) -> float:
    """Return the friction of rails, seals and screw [N] that is guessed from the mass m [kg] on the rails and the lead l.

    Rails: 0.003 m g, and 4 N m'^(1/3) of seals and preload on each of four carriages, m' = m/10 kg. Thomson and Rollon state a coefficient
    of 0.002 to 0.003; seals take 2 to 5 N by Nippon Bearing, 0.2 to 1 N by Rollon (Mono Rail 15 to 55). Nut: the drag torque 0.05 (tan
    b)^-0.5 F l/(2 pi) of JIS B 1192 with the lead angle b, which is a force of 0.05 (tan b)^-0.5 F at the table. Its preload F is 3 % of
    the load rating: makers allow 10 %, and a nut with play has none. The rating is 31 N/mm^2 d^2, as in tables of ball screws, and the
    diameter d = 8 mm m^(1/4) that of machines of this mass. For 10 kg and a lead of 10 mm that is 36 N, with seals of 2 N and no preload
    8 N: hence the range.
    """
    mass = axis.moved_mass + axis.carried
    diameter = 8e-3 * mass**0.25
    rails = 0.003 * GRAVITY * mass + 16.0 * (0.1 * mass) ** (1.0 / 3.0)
    return float(rails if axis.linear else rails + 0.05 * 0.03 * 31e6 * diameter**2 * math.sqrt(math.pi * diameter / axis.lead))


def _spare(axis: SizedAxis) -> float:
    """Return the acceleration that the rated force allows beside friction at speed; of a step drive one to its velocity in 0.2 s."""
    if axis.drive == "step-drive":
        return float(5.0 * axis.velocity)
    rated = axis.force(axis.rated)
    return float(max(rated - axis.friction - axis.damping * axis.velocity, 0.1 * rated) / axis.mass)


AXIS = (
    Question("pulse", "Travel per step pulse", "um", 1e-3, 1000.0, "", "none, or 1600 pulses per turn of a stepper", asked=False),
    Question(
        "drive",
        "Drive: screw (servo by torque; also belt, rack), linear (motor), velocity (servo by velocity), step-drive (closed loop), stepper",
        default=lambda axis: "stepper" if axis.pulse else "screw", rule="screw, or stepper where steps are known",
    ),
    Question("holding_torque", "Holding torque of the stepper at the current of its drive", "N*m", 0.02, 100.0, drives=("stepper",)),
    Question("rated_torque", "Rated torque of the motor", "N*m", 0.02, 500.0, drives=SERVO),
    Question(
        "peak_torque", "Peak torque of the motor with its drive", "N*m", 0.02, 2000.0, lambda axis: 3.0 * axis.rated,
        "three times the rated torque", (0.6, 1.4), asked=False, drives=SERVO,
    ),
    Question("torque_constant", "Torque constant of the motor", "N*m/A", 0.005, 20.0, drives=SERVO),
    Question("rotor_inertia", "Inertia of the rotor", "kg*cm^2", 1e-3, 5000.0, drives=TURNING),
    Question(
        "screw_inertia", "Inertia of coupling and screw", "kg*cm^2", 0.0, 20000.0, lambda axis: axis.rotor_inertia,
        "as the rotor", (0.3, 1.7), asked=False, drives=TURNING,
    ),
    Question("lead", "Lead of the screw (travel per turn)", "mm", 0.2, 500.0, "10 mm", spread=(0.5, 1.5), drives=TURNING),
    Question(
        "corner_speed", "Speed of the axis at which the stepper has 71 % of its holding torque", "m/min", 0.05, 600.0,
        lambda axis: 400.0 / 60.0 * axis.lead, "400 rpm", (0.6, 1.4), asked=False, drives=("stepper",),
    ),
    Question("rated_force", "Rated force of the motor", "N", 0.5, 50000.0, drives=("linear",)),
    Question(
        "peak_force", "Peak force of the motor with its drive", "N", 0.5, 200000.0, lambda axis: 3.0 * axis.rated,
        "three times the rated force", (0.6, 1.4), asked=False, drives=("linear",),
    ),
    Question("force_constant", "Force constant of the motor", "N/A", 0.2, 5000.0, drives=("linear",)),
    Question("moved_mass", "Moved mass, without other axes of this machine on it", "kg", 0.01, 50000.0),
    Question("efficiency", "Efficiency of the screw", "%", 20.0, 100.0, "90 %", spread=(0.9, 1.1), asked=False, drives=TURNING),
    Question(
        "encoder_resolution",
        "Encoder: travel per count (1 um), lines x interpolation (2500 x 4), bits (17 bit), grating / interpolation (20 um / 400)",
        "um", 1e-5, 100.0, lambda axis: 1e-7 if axis.linear else axis.lead / 10000.0,
        "0.1 um, or 10000 counts per turn of a screw", (0.2, 1.8), drives=LOOPS,
    ),
    Question(
        "velocity", "Velocity limit", "m/min", 0.05, 600.0, lambda axis: _FASTEST[axis.drive] * (axis.lead or 1.0),
        "3000 rpm of a servo, 600 rpm of a stepper, 60 m/min of a linear motor, 9 m/min of a step drive",
    ),
    Question(
        "friction", "Sliding friction at the table", "N", 0.0, 20000.0, _rubbing,
        "rails and preloaded nut of usual size for the moved mass", (0.2, 1.8), asked=False, drives=(*LOOPS, "stepper"),
    ),
    Question(
        "damping", "Viscous damping at the table", "N*s/m", 0.0, 1e6, lambda axis: _rubbing(axis) / axis.velocity,
        "as much force as the guessed friction at the velocity limit", (0.4, 1.6), asked=False, drives=(*LOOPS, "stepper"),
    ),
    Question(
        "acceleration", "Acceleration limit", "m/s^2", 0.02, 300.0, _spare,
        "what the rated force allows, of a stepper half of the holding force; a step drive: to its velocity in 0.2 s",
    ),
    Question(
        "jerk", "Jerk limit", "m/s^3", 0.5, 1e6, lambda axis: axis.acceleration / 0.05,
        "reaches the acceleration in 50 ms", asked=False,
    ),
    Question("unbalanced_mass", "Unbalanced mass, if the axis is vertical (Enter: balanced, or horizontal)", "kg", 0.01, 50000.0, ""),
    Question("resonance", "Lowest structural resonance, measured on the assembled machine", "Hz", 1.0, 2000.0, "", "none", asked=False,
             drives=LOOPS),
    Question(
        "bandwidth", "Bandwidth of the velocity loop (its natural frequency)", "Hz", 0.5, 2000.0, lambda axis: axis.fastest,
        "the fastest that keeps 6 dB and 30 degrees, with a notch for a resonance", drives=LOOPS,
    ),
    Question(
        "kv", "Kv, the gain of the position loop", "1/s", 0.5, 2000.0, lambda axis: KV_RATIO * axis.bandwidth_rate, "0.35 of it in rad/s",
        drives=LOOPS,
    ),
    Question("travel", "Travel from end to end", "mm", 1.0, 100000.0, "", "unknown", asked=False),
    Question("backlash", "Backlash at the table", "um", 0.0, 5000.0, "", "none", asked=False),
    Question("mounted_on", "Axis below it", default="", rule="the bed", asked=False),
    Question("stage_mass", "Mass of the whole module, carried by the axis below", "kg", 0.01, 50000.0, lambda axis: axis.moved_mass,
             "the moved mass", asked=False),
)  # fmt: skip
QUESTIONS = {question.key: question for question in AXIS}
KEYS = tuple(QUESTIONS)
PLACE = ("unbalanced_mass", "travel", "backlash", "mounted_on", "stage_mass")
"""Keys that an axis does not repeat from another."""


def fault(key: str, message: str) -> ScenarioError:
    """Return the error of an answer."""
    return ScenarioError(message, file="answers", key=key)


def read_value(question: Question, key: str, text: str, axis: SizedAxis) -> Any:
    """Return an answer in SI, or as text; None for an optional question without an answer.

    Parameters
    ----------
    key : str
        Full key, for messages: ``x.lead``.
    text : str
        The answer; empty: the default.
    axis : SizedAxis
        With the values of the questions before.

    Raises
    ------
    ScenarioError
        If the answer is missing, not a quantity, or not what machines have.
    """
    if not text and callable(question.default):
        guess = question.default(axis)
        return guess if isinstance(guess, str) else rounded(guess)
    text = text or question.guess()
    if not text:
        if question.default is None:
            raise fault(key, f"no answer: give {question.about}")
        return None
    if question.key == "drive":
        drive = _OTHER_WORDS.get(text.lower(), text.lower())
        refuse(drive not in DRIVES, fault, key, f"{text!r} is not a drive: write {', '.join(DRIVES)}")
        refuse(axis.pulse and not drive.startswith("step"), fault, key, "the control makes steps: write stepper or step-drive")
        return drive
    if not question.unit:
        return text
    refuse(question.unit == "Hz" and "mm" in text, fault, key, f"{text!r} is a Kv: write a frequency, such as 30 Hz")
    try:
        number = _number(question.key, text, question.unit, axis)
    except UnitError as error:
        raise fault(key, str(error)) from error
    shown = from_si(number, question.unit)
    if not question.least * (1.0 - 1e-9) <= shown <= question.most * (1.0 + 1e-9):
        value = "" if text == show(number, question.unit) else f", {shown:.4g} {question.unit},"
        raise fault(key, f"{text!r}{value} is not plausible: machines have {question.least:g} to {question.most:g} {question.unit}")
    return number


def _number(key: str, text: str, unit: str, axis: SizedAxis) -> float:
    """Return a number in SI; an encoder may be given by its counts, and a velocity as the speed of a screw's motor."""
    if key == "velocity" and not axis.linear and (turns := _SPEED.fullmatch(text)):
        return float(turns[1]) / 60.0 * float(axis.lead)
    if key == "encoder_resolution" and (turn := _COUNTS.fullmatch(_PER_TURN.sub("", text))):
        if axis.linear:
            raise UnitError(f'{text!r} is per turn, which a linear motor has not: write the travel per count, or for example "20 um / 400"')
        counts = 2 ** min(int(turn["bits"] or 0), 64) * int(turn["lines"] or 1) * int(turn["steps"] or turn["counts"] or 1)
        refuse(counts == 0, UnitError, f"{text!r} gives no count")
        return float(axis.lead / counts)
    if key == "encoder_resolution" and (grating := _PERIOD.fullmatch(text)):
        return _number("", grating["period"], "um", axis) / int(grating["steps"])
    with suppress(UnitError):
        text = text if split(text)[1] else f"{text} {unit}"
    return read_number(text, unit, unit)


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
    refuse(not 1 <= len(names) <= MOST_AXES, fault, "axes", f"{len(names)} axes: give 1 to {MOST_AXES}, as in x, y, z")
    for name in names:
        refuse(not NAME.match(name), fault, "axes", f"{name!r} is not a valid axis name: use letters, digits and _")
        # The axis files must differ also on file systems that ignore case.
        refuse([other.lower() for other in names].count(name.lower()) > 1, fault, "axes", f"axis {name!r} is given twice")
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
            refuse(trail[-1] in trail[:-1], fault, key, "the axes are mounted on each other in a circle")
    return {name: under for name, (_, under) in below.items()}


def for_each(answers: Mapping[str, str], key: str) -> dict[str, str]:
    """Return the answers of each axis to one of the questions `EACH`, empty for none.

    Raises
    ------
    ScenarioError
        If they are not one for each axis, or one is not of its kind.
    """
    names, text = axis_names(answers), answers.get(key, "")
    parts = [part.strip() for part in text.split(",")] if text else [""] * len(names)
    refuse(len(parts) != len(names), fault, key, f"{len(parts)} for the axes {', '.join(names)}: write one for each, with commas")
    for part in parts:
        read_value(QUESTIONS[key], key, part, SizedAxis("", 0.0))
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
    kept = tuple(filter(None, re.split(r"[,\s]+|\band\b", match["keys"] or "")))
    for word in kept:
        refuse(word not in KEYS, _unknown, key, word, KEYS)
    return match["axis"], kept


def answers_of(answers: Mapping[str, str], name: str, trail: tuple[str, ...] = ()) -> dict[str, str]:
    """Return the answers about an axis, with those that it repeats from another."""
    refuse(name in trail, fault, f"{name}.{SAME.key}", "the axes repeat each other in a circle")
    other, kept = same_as(answers, name)
    repeated = answers_of(answers, other, (*trail, name)) if other else {}
    own = {question.key: for_each(answers, question.key)[name] for question in EACH} | {
        key: answers[f"{name}.{key}"] for key in KEYS if f"{name}.{key}" in answers
    }
    return {key: text for key, text in repeated.items() if key not in (*kept, *PLACE)} | own


def sized(answers: Mapping[str, str], name: str, period: float, until: str = "", carried: float = 0.0) -> SizedAxis:
    """Return an axis, which carries a mass [kg], with the values of its questions up to `until`, or of all.

    Raises
    ------
    ScenarioError
        If an answer is missing or implausible; has the key of its question.
    """
    axis, given = SizedAxis(name, period, carried=carried), answers_of(answers, name)
    for question in takewhile(lambda question: question.key != until, AXIS):
        text, axis.values[question.key] = given.get(question.key, ""), None
        if not question.drives or axis.drive in question.drives:
            axis.values[question.key] = read_value(question, f"{name}.{question.key}", text, axis)
            if not text and question.default:
                axis.guesses.add(question.key)
        elif text:
            raise fault(f"{name}.{question.key}", f"a drive of the kind {axis.drive} has no such value")
    return axis


def check_keys(answers: Mapping[str, str]) -> None:
    """Raise ScenarioError if a key is no question."""
    names, general = axis_names(answers), [question.key for question in MACHINE]
    for key in answers:
        name, dot, inner = key.partition(".")
        refuse(not dot and key not in general, _unknown, key, key, (*general, *names))
        refuse(dot and name not in names, fault, key, f"{name!r} is not an axis: axes names {', '.join(names)}")
        refuse(dot and inner not in (SAME.key, *KEYS), _unknown, key, inner, (SAME.key, *KEYS))


def _unknown(key: str, word: str, known: tuple[str, ...]) -> ScenarioError:
    near = get_close_matches(word, known, n=1, cutoff=0.0)[0]
    return fault(key, f"no question {word!r}: the nearest is {near!r}; there are {', '.join(known)}")


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
            required = f"{name}.{question.key}" in also
            if question.key == "unbalanced_mass" and not name.lower().startswith("z") and not required:
                continue
            wanted = required or question.key in kept or (question.asked and (not other or question.key in PLACE))
            if wanted and (not question.drives or sized(answers, name, period, "holding_torque").drive in question.drives):
                guess = question.guess(sized(answers, name, period, question.key)) if callable(question.default) else question.default
                yield replace(question, key=f"{name}.{question.key}", default=guess)
    yield from (question for question in EACH if not all(f"{name}.{question.key}" in answers for name in names))


def of_control(control: ControlFile) -> dict[str, str]:
    """Return the answers that a control's own file holds."""
    period = control.tables["machine"]["servo_period"]
    known = {"axes": ", ".join(control.tables["axes"]), "servo_period": period if isinstance(period, str) else period["value"]}
    for name, tables in control.tables["axes"].items():
        limits, pulse = tables["limits"], tables["plant"].get("pulse")
        known |= {f"{name}.{key}": limits[key]["value"] for key in ("velocity", "acceleration", "jerk") if key in limits}
        if "travel" in limits:
            low, high = (read_number(end, "m", "mm") for end in limits["travel"]["value"])
            known[f"{name}.travel"] = show(high - low, "mm", 12)
        if name not in control.unmodelled:  # without pulses its drive takes positions
            known |= {f"{name}.pulse": pulse["value"]} if pulse else {f"{name}.drive": "step-drive"}
    return known


def interview(
    ask: Callable[[Question], str],
    remark: Callable[[ScenarioError], None],
    check: Callable[[Mapping[str, str]], object],
    known: Mapping[str, str] | None = None,
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
    known : mapping of str to str, optional
        Answers that are not asked.
    """
    answers = dict(known or {})
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
                answers.pop(next(reversed(answers), ""), None)
                continue
            # The default of these questions is an answer of its own.
            text = text or (question.guess() if question.key.endswith((f".{SAME.key}", ".drive")) else "")
            _check_answer(question, text, answers)
            answers[question.key] = text
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
        answers_of(tried, name)
    elif dot:
        read_value(QUESTIONS[key], question.key, text, sized(answers, name, machine_values(answers)["servo_period"], key))
    else:
        machine_values(tried)
        mounting(tried)
        for question in EACH:
            for_each(tried, question.key)


def read_answers(file: str | Path) -> dict[str, str]:
    """Return the answers of a TOML file: about the machine, and one table for each axis.

    Raises
    ------
    ScenarioError
        If the file cannot be read, or a value is not an answer.
    """
    answers = {}
    for name, node in read_tree(Path(file), "a file of answers").entries.items():
        for inner, leaf in node.entries.items() if isinstance(node, Table) else [("", node)]:
            value = leaf.plain()
            if isinstance(value, list) and all(isinstance(item, str) for item in value):
                value = ", ".join(value)
            if isinstance(value, bool) or not isinstance(value, str | int | float):
                raise leaf.error(f"{value!r} is not an answer: write text, or a number with its unit")
            answers[f"{name}.{inner}".rstrip(".")] = str(value).strip()
    return answers


def preset_answers(name: str, known: Mapping[str, str]) -> dict[str, str]:
    """Return the answers of a class of machines, one of `PRESETS`, with those of a control's own file in their place.

    The table ``steps`` of a preset is for the axes for which such a control makes steps. Each axis keeps what its drive has.
    """
    check_known("--preset", name, PRESETS)
    given = read_answers(Path(str(files("contourlab.features.machines"))) / "presets" / f"{name}.toml")
    steps = {key: text for key in KEYS if (text := given.pop(f"steps.{key}", ""))}
    if not known:
        return given
    answers = {**{question.key: given[question.key] for question in MACHINE if question.key in given}, **known}
    for axis in axis_names(answers):
        own = answers_of(given, axis) if axis in axis_names(given) else {}
        own |= {"drive": "stepper", **steps} if f"{axis}.pulse" in known else {}
        drive = known.get(f"{axis}.drive", own.get("drive", "screw"))
        kept = [question.key for question in AXIS if own.get(question.key) and drive in (question.drives or DRIVES)]
        answers = {f"{axis}.{key}": own[key] for key in kept} | answers
    return answers


def answers_text(answers: Mapping[str, str]) -> str:
    """Return answers as a file; what was not answered is a comment with its default."""
    lines = ["# Answers for contourlab new machine --answers FILE. A line that begins with # takes its default.", ""]
    lines += [_line(question, answers.get(question.key, "")) for question in MACHINE]
    for name in axis_names(answers):
        own = {key: answers.get(f"{name}.{key}", "") for key in KEYS}
        other, kept = same_as(answers, name)
        drive = _OTHER_WORDS.get(own["drive"].lower(), own["drive"].lower()) or ("stepper" if own["pulse"] else "screw")
        lines += ["", f"[{name}]"]
        lines += [_line(SAME, answers[f"{name}.{SAME.key}"])] if other else []
        shown = [q for q in AXIS if own[q.key] or (q.key in kept if other else not q.drives or drive in q.drives)]
        lines += [_line(question, own[question.key]) for question in shown]
    return "\n".join(lines) + "\n"


def _line(question: Question, text: str) -> str:
    open_ = "" if text or question.default is None else "# "
    value = json.dumps(text or question.guess(), ensure_ascii=False)
    return f"{open_}{question.key} = {value}" + ("" if question is SAME else f"  # {question.about}")
