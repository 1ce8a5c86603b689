"""The questions of ``contourlab new machine``: units, ranges and guesses."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from contourlab.errors import ScenarioError, UnitError
from contourlab.features.machines.sizing import KV_RATIO, SizedAxis, rounded
from contourlab.scenario.quantities import read_number
from contourlab.units import from_si, show, split

_PER_TURN = re.compile(r"\s*(?:/|per)\s*(?:rev(?:olution)?|turn)\b")
_COUNTS = re.compile(r"(?P<lines>\d+)\s*(?:lines?\s*)?[x×*]\s*(?P<steps>\d+)|(?P<bits>\d+)\s*bits?|(?P<counts>\d+)\s*counts?")
_PERIOD = re.compile(r"(?P<period>.*[^\d\s])\s*(?:/|x|×)\s*(?P<steps>\d+)")
_SPEED = re.compile(r"(\d+(?:\.\d*)?)\s*(?:rpm|1/min|U/min)")
_DRIVES = {"screw": ("screw", "ball-screw", "belt", "rack"), "linear": ("linear", "linear-motor")}


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
    drive : str
        Drive that has it; empty: both.
    """

    key: str
    text: str
    unit: str = ""
    least: float = 0.0
    most: float = math.inf
    default: str | Callable[[SizedAxis], float] | None = None
    rule: str = ""
    spread: tuple[float, float] | None = None
    asked: bool = True
    drive: str = ""

    @property
    def about(self) -> str:
        """Text, unit and range, for a comment."""
        span = f" [{self.unit}], {self.least:g} to {self.most:g}" if self.unit else ""
        return f"{self.text}{span}" + (f"; default: {self.rule}" if self.rule else "")

    def guess(self, axis: SizedAxis | None = None) -> str:
        """Return the answer taken without one, as text."""
        if callable(self.default) and axis is not None:
            return show(self.default(axis), self.unit, 4)
        return self.default if isinstance(self.default, str) else ""


MACHINE = (
    Question("name", "Name of the machine", default="", rule="the name of the folder", asked=False),
    Question("axes", "Names of the axes, in the order of the coordinates", default="x, y, z"),
    Question("servo_period", "Servo period", "ms", 0.02, 20.0, "1 ms"),
    Question("mounting", "Axes that stand on another axis, e.g. z on y, y on x (Enter: none)", default=""),
    Question("tolerance", "Tolerance of the first run", "um", 0.01, 5000.0, "50 um", asked=False),
    Question("travel", "Travel of each axis from end to end, e.g. 750 mm, 500 mm, 120 mm (Enter: unknown)", default="", asked=False),
)
SAME = Question("same_as", "Same as which axis? Name what differs, as in x except moved_mass, lead (no: ask everything)", default="")


def _share(axis: SizedAxis) -> float:
    """Return the force that is guessed for friction [N]: up to a tenth of the command with screws (Ghaffari & Ulsoy), less without."""
    return (0.05 if axis.linear else 0.1) * axis.force(axis.rated)


def _spare(axis: SizedAxis) -> float:
    """Return the acceleration that the rated force allows beside friction at speed."""
    rated = axis.force(axis.rated)
    return float(max(rated - axis.friction - axis.damping * axis.velocity, 0.1 * rated) / axis.mass)


AXIS = (
    Question("drive", "Drive: screw (also belt or rack) or linear (motor)", default="screw"),
    Question("rated_torque", "Rated torque of the motor", "N*m", 0.02, 500.0, drive="screw"),
    Question(
        "peak_torque", "Peak torque of the motor with its drive", "N*m", 0.02, 2000.0, lambda axis: 3.0 * axis.rated,
        "three times the rated torque", (0.6, 1.4), asked=False, drive="screw",
    ),
    Question("torque_constant", "Torque constant of the motor", "N*m/A", 0.005, 20.0, drive="screw"),
    Question("rotor_inertia", "Inertia of the rotor", "kg*cm^2", 1e-3, 5000.0, drive="screw"),
    Question(
        "screw_inertia", "Inertia of coupling and screw", "kg*cm^2", 0.0, 20000.0, lambda axis: axis.rotor_inertia,
        "as the rotor", (0.3, 1.7), asked=False, drive="screw",
    ),
    Question("lead", "Lead of the screw (travel per turn)", "mm", 0.2, 500.0, "10 mm", spread=(0.5, 1.5), drive="screw"),
    Question("rated_force", "Rated force of the motor", "N", 0.5, 50000.0, drive="linear"),
    Question(
        "peak_force", "Peak force of the motor with its drive", "N", 0.5, 200000.0, lambda axis: 3.0 * axis.rated,
        "three times the rated force", (0.6, 1.4), asked=False, drive="linear",
    ),
    Question("force_constant", "Force constant of the motor", "N/A", 0.2, 5000.0, drive="linear"),
    Question("moved_mass", "Moved mass, without other axes of this machine on it", "kg", 0.01, 50000.0),
    Question("efficiency", "Efficiency of the screw", "%", 20.0, 100.0, "90 %", spread=(0.9, 1.1), asked=False, drive="screw"),
    Question(
        "encoder_resolution",
        "Encoder: travel per count (1 um), lines x interpolation (2500 x 4), bits (17 bit), grating / interpolation (20 um / 400)",
        "um", 1e-5, 100.0, lambda axis: 1e-7 if axis.linear else axis.lead / 10000.0,
        "0.1 um, or 10000 counts per turn of a screw", (0.2, 1.8),
    ),
    Question(
        "velocity", "Velocity limit", "m/min", 0.05, 600.0, lambda axis: 1.0 if axis.linear else 50.0 * axis.lead,
        "60 m/min, or 3000 rpm of a screw",
    ),
    Question(
        "friction", "Sliding friction at the table", "N", 0.0, 20000.0, _share,
        "a tenth of the rated force, 5 % with a linear motor", (0.5, 1.5), asked=False,
    ),
    Question(
        "damping", "Viscous damping at the table", "N*s/m", 0.0, 1e6, lambda axis: _share(axis) / axis.velocity,
        "as much force as friction at the velocity limit", (0.5, 1.5), asked=False,
    ),
    Question("acceleration", "Acceleration limit", "m/s^2", 0.02, 300.0, _spare, "what the rated force allows"),
    Question(
        "jerk", "Jerk limit", "m/s^3", 0.5, 1e6, lambda axis: axis.acceleration / 0.05,
        "reaches the acceleration in 50 ms", asked=False,
    ),
    Question("unbalanced_mass", "Unbalanced mass, if the axis is vertical (Enter: balanced, or horizontal)", "kg", 0.01, 50000.0, ""),
    Question("resonance", "Lowest structural resonance, measured on the assembled machine", "Hz", 1.0, 2000.0, "", "none", asked=False),
    Question(
        "bandwidth", "Bandwidth of the velocity loop (its natural frequency)", "Hz", 0.5, 2000.0, lambda axis: axis.fastest,
        "the fastest that keeps 6 dB and 30 degrees, with a notch for a resonance",
    ),
    Question(
        "kv", "Kv, the gain of the position loop", "1/s", 0.5, 2000.0, lambda axis: KV_RATIO * axis.bandwidth_rate, "0.35 of it in rad/s",
    ),
    Question("travel", "Travel from end to end", "mm", 1.0, 100000.0, "", "unknown", asked=False),
    Question("mounted_on", "Axis below it", default="", rule="the bed", asked=False),
    Question("stage_mass", "Mass of the whole module, carried by the axis below", "kg", 0.01, 50000.0, lambda axis: axis.moved_mass,
             "the moved mass", asked=False),
)  # fmt: skip
KEYS = tuple(question.key for question in AXIS)
PLACE = ("unbalanced_mass", "travel", "mounted_on", "stage_mass")
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
        return rounded(question.default(axis))
    text = text or question.guess()
    if not text and question.default is None:
        raise fault(key, f"no answer: give {question.about}")
    if not text:
        return None
    if question.key == "drive":
        drives = [drive for drive, words in _DRIVES.items() if text.lower() in words]
        if not drives:
            raise fault(key, f"{text!r} is not a drive: write screw or linear")
        return drives[0]
    if not question.unit:
        return text
    if question.unit == "Hz" and "mm" in text:
        raise fault(key, f"{text!r} is a Kv: write a frequency, such as 30 Hz")
    try:
        number = _other_words(question.key, text, axis)
        number = _quantity(text, question.unit) if number is None else number
    except UnitError as error:
        raise fault(key, str(error)) from error
    shown = from_si(number, question.unit)
    if not question.least * (1.0 - 1e-9) <= shown <= question.most * (1.0 + 1e-9):
        value = "" if text == show(number, question.unit) else f", {shown:.4g} {question.unit},"
        raise fault(key, f"{text!r}{value} is not plausible: machines have {question.least:g} to {question.most:g} {question.unit}")
    return number


def _quantity(text: str, unit: str) -> float:
    try:
        bare = not split(text)[1]
    except UnitError:
        bare = False
    return read_number(f"{text} {unit}" if bare else text, unit, unit)


def _other_words(key: str, text: str, axis: SizedAxis) -> float | None:
    """Return an answer in other than its own unit; None if it is none: an encoder's counts, or the speed of a screw's motor."""
    if key == "encoder_resolution":
        return _encoder(text, axis)
    turns = _SPEED.fullmatch(text)
    return float(turns[1]) / 60.0 * float(axis.lead) if key == "velocity" and turns and not axis.linear else None


def _encoder(text: str, axis: SizedAxis) -> float | None:
    """Return the travel per count of an encoder in other words; None if the text is none of them."""
    turn = _COUNTS.fullmatch(_PER_TURN.sub("", text))
    if turn is None:
        grating = _PERIOD.fullmatch(text)
        return _quantity(grating["period"], "um") / int(grating["steps"]) if grating else None
    if axis.linear:
        raise UnitError(f'{text!r} is per turn, which a linear motor has not: write the travel per count, or for example "20 um / 400"')
    counts = 2 ** min(int(turn["bits"] or 0), 64) * int(turn["lines"] or 1) * int(turn["steps"] or turn["counts"] or 1)
    if counts == 0:
        raise UnitError(f"{text!r} gives no count")
    return float(axis.lead / counts)
