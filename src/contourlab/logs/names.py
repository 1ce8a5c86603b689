"""What a column is by its name alone, word by word, as controls and people call their signals."""

from __future__ import annotations

import re

from contourlab.logs.record import AXIS_LETTERS

__all__ = ["TIME", "meant"]

TIME = "time"
_TIME = {"t", "time", "zeit", "timestamp", "seconds", "datetime"}
_VELOCITY = {"vel", "velo", "velocity", "speed", "geschwindigkeit"}
_PLACE = {"encoder", "position", "pos", "enc"}
_REFERENCE = {
    *("ref", "refcommand", "reference", "setpoint", "soll", "sollposition", "lagesollwert"),
    *("desired", "target", "cmd", "demand", "commanded", "nominal", "noml"),
}
_ASKED = {"set", "command", "des"}
"""Words of a reference beside a position or a velocity; alone they may be a force, or a set of data."""
_SEEN = {"feedback", "fbk", "actual", "act", "actl", "ist", "istposition", "lageistwert", "measured"}
_MEASURED = _SEEN | {"fb"}  # a function block too: "MAIN.fbAxis1.NcToPlc.SetPos"
_OTHER = {
    *("error", "err", "diff", "difference", "lag", "deviation", "limit", "offset", "correction", "modulo", "turns"),
    *("acc", "accel", "acceleration", "jerk", "torque", "force", "moment", "voltage", "volt", "power", "temperature", "rpm"),
}
"""Words of what is neither a position nor a velocity of an axis, whatever else the name says."""
_SYMBOLS = frozenset("auv")
"""Letters that are axes, and what controls call acceleration, voltage and velocity: ``a actual``, ``V (NOM RPM)``."""
_RUN_TOGETHER = re.compile(r"(act|set|cmd|ref|des)(pos|velo?)|(pos|velo?)(cmd|fbk?|act|set|ref|des|err|diff)")
_TWINCAT = re.compile(r"ToPlc\.|(Act|Set)(Pos|Velo)\b")
_END_OF_MOVE = re.compile(r"ToPlc\.TargetPos\b")


def meant(name: str) -> tuple[str, str] | None:
    """Return the signal and axis that a name leaves no doubt of, None where it says none; the time has the axis "".

    Known are the words of LinuxCNC, of TwinCAT's axes (``Axes.Axis 1.ToPlc.ActPos``, ``SetVelo``), of Heidenhain's oscilloscope
    (``Noml. pos``), of Aerotech's (``PosCmd (X)``, ``PosFbk (X)``), and those that people use. Where an axis has a number it is that of a
    joint, from 0, or with TwinCAT's words that of an axis, from 1.

    >>> meant("Encoder Feedback X"), meant("joint.0.motor-pos-cmd"), meant("SetPos Y"), meant("Zeit")
    (('position', 'x'), ('reference', 'x'), ('reference', 'y'), ('time', ''))
    >>> meant("Position Error X"), meant("a actual"), meant("x")
    (None, None, None)
    """
    words = _words(name)
    if len(words) == 1 and words[0] in _TIME:
        return TIME, ""
    axis, signal = _axis(name, words), _signal(set(words))
    if axis is None or signal is None or _END_OF_MOVE.search(name):
        return None
    return None if axis in _SYMBOLS and not set(words) & (_PLACE | _VELOCITY) else (signal, axis)


def _words(name: str) -> list[str]:
    """Return the words of a name in small letters: ``Encoder Feedback X`` is told from ``excitation``; ``actpos`` is two."""
    found = [word.casefold() for word in re.findall(r"[A-Za-z]+|\d+", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name))]
    parted = [(word, _RUN_TOGETHER.fullmatch(word)) for word in found]
    return [part for word, two in parted for part in (filter(None, two.groups()) if two else [word])]


def _signal(words: set[str]) -> str | None:
    quantities = words & (_PLACE | _VELOCITY)
    if words & _OTHER or ("current" in words and not quantities):
        return None
    is_asked = bool(words & _REFERENCE or (quantities and words & _ASKED))
    if is_asked and words & _SEEN:
        return None  # "REF ACTL" is where the axis is, from its reference mark
    if words & _VELOCITY:
        return "reference_velocity" if is_asked else "velocity"
    if is_asked:
        return "reference"
    return "position" if words & (_PLACE | _MEASURED) else None


def _axis(name: str, words: list[str]) -> str | None:
    """Return the axis that words name: a letter, a letter at the end of a word such as "datax", or the number of a joint."""
    first = 1 if _TWINCAT.search(name) else 0
    for before, word in zip(["", *words], words, strict=False):
        if before in ("joint", "axis") and word.isdigit():
            # Whether elements of an array count from 0 or from 1 is up to who wrote the program.
            known = first <= int(word) < first + len(AXIS_LETTERS) and not (first and f"[{word}]" in name)
            return AXIS_LETTERS[int(word) - first] if known else None
    letters = {word for word in words if len(word) == 1 and word in AXIS_LETTERS}
    if not letters:
        letters = {word[-1] for word in words if word[-1] in "xyz" and word[:-1] in ("data", "axis", "ref", "pos", "enc")}
    return letters.pop() if len(letters) == 1 else None
