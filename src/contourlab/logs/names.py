"""Identify a column by its name alone, word by word, as controls and people name their signals."""

from __future__ import annotations

import itertools
import re

from contourlab.logs.record import AXIS_LETTERS

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
_PLAIN = {"axis", "axes", "joint", "channel", "ch", "signal", "value", "data", "raw", "machine", "the", "of"}
"""Words that do not change what the others say."""
_OF_MANY = {"motor", "servo", "drive", "main", "gvl", "nc", "to", "plc"}
"""Words of what has many signals: ``motor cmd`` may be a torque, ``MAIN.fbAxis1.Cmd`` anything."""
_LETTERS = frozenset(AXIS_LETTERS)
_KNOWN = _VELOCITY | _PLACE | _REFERENCE | _ASKED | _MEASURED | _PLAIN | _OF_MANY | _LETTERS
_KNOWN_BEFORE = {"current": {"position", "pos"} | _VELOCITY, "feed": {"reference"}, "st": {"axis"}, "lr": {"act", "set"}}
"""Words that are known before these alone: ``current`` may be that of a motor, ``feed act X`` is a speed."""
_SYMBOLS = frozenset("auv")
"""Letters that are axes, and what controls call acceleration, voltage and velocity: ``a actual``, ``V (NOM RPM)``."""
_RUN_TOGETHER = re.compile(
    r"(act|set|cmd|ref|des)(pos|velo?)|(pos|velo?)(cmd|fbk?|act|set|ref|des|err|diff)|(data|axis|ref|pos|enc)([xyz])"
)
_BESIDE = re.compile(
    r"\A(?:logs?|out|output|record|run|scope)\.|\(64 bit\)|#\d+\Z"
    r"|(?:[\s_]+|\s*[(\[])(?:in[\s_]+)?(?:[mu]?m|\u00b5m|inch)(?:(?:/|[\s_]per[\s_]|[\s_])(?:s|sec|min))?[)\]]?\Z"
)
"""What a name has beside its words: the structure it is in, the size of a number, which of several of the same name, a unit."""
_UNUSUAL = re.compile(r"\A\s*-|[^\w\s./:;,()\[\]-]")
"""A sign, or what is no part of a name, as in a formula."""
_TWINCAT = re.compile(r"ToPlc\.|(Act|Set)(Pos|Velo)\b")
_END_OF_MOVE = re.compile(r"ToPlc\.TargetPos\b")


def meant(name: str) -> tuple[str, str] | None:
    """Return the signal and axis that a name leaves no doubt of, None where it says none; the time has the axis "".

    Known are the words of LinuxCNC, of TwinCAT's axes (``Axes.Axis 1.ToPlc.ActPos``, ``SetVelo``), of Heidenhain's oscilloscope
    (``Noml. pos``), of Aerotech's (``PosCmd (X)``, ``PosFbk (X)``), and those that people use. Where an axis has a number it is that of a
    joint, from 0, or with TwinCAT's words that of an axis, from 1. A word that is not known
    leaves a doubt, for it may change what the others say.

    >>> meant("Encoder Feedback X"), meant("joint.0.motor-pos-cmd"), meant("SetPos Y"), meant("Zeit")
    (('position', 'x'), ('reference', 'x'), ('reference', 'y'), ('time', ''))
    >>> meant("Position Error X"), meant("a actual"), meant("x")
    (None, None, None)
    """
    if len(words := _words(name)) == 1 and words[0] in _TIME:
        return TIME, ""
    bare = _BESIDE.sub(" ", name)
    words = _words(bare)
    if _UNUSUAL.search(bare) or _END_OF_MOVE.search(name) or not _are_known(words):
        return None
    axis, signal = _axis(name, words), _signal(set(words))
    if axis is None or signal is None:
        return None
    return None if axis in _SYMBOLS and not set(words) & (_PLACE | _VELOCITY) else (signal, axis)


def _words(name: str) -> list[str]:
    """Return the words of a name in small letters; ``actpos`` is two."""
    found = [word.casefold() for word in re.findall(r"[^\W\d_]+|\d+", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name))]
    parted = [(word, _RUN_TOGETHER.fullmatch(word)) for word in found]
    return [part for word, two in parted for part in (filter(None, two.groups()) if two else [word])]


def _are_known(words: list[str]) -> bool:
    """Tell whether all words are known; an unknown one may change the meaning, as in ``x position window``."""
    for before, word, after in zip(["", *words], words, [*words[1:], ""], strict=False):
        if word.isdigit():
            # X1 is the first axis of its letter; X2 may be the second motor or encoder of the same axis.
            known = before in ("joint", "axis", "channel", "ch") or (word == "1" and before in _LETTERS)
        else:
            known = word in _KNOWN or after in _KNOWN_BEFORE.get(word, ())
        if not known:
            return False
    return True


def _signal(words: set[str]) -> str | None:
    quantities = words & (_PLACE | _VELOCITY)
    if words & _OF_MANY and not quantities:
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
    """Return the axis that words name, by its letter or as the number of a joint; None where they name more than one, or an element."""
    first = 1 if _TWINCAT.search(name) else 0
    found = {word for word in words if word in _LETTERS}
    for before, word in itertools.pairwise(words):
        if before in ("joint", "axis") and word.isdigit():
            # Whether elements of an array count from 0 or from 1 is up to the programmer.
            if not first <= int(word) < first + len(AXIS_LETTERS) or f"[{word}]" in name:
                return None
            found.add(AXIS_LETTERS[int(word) - first])
    return found.pop() if len(found) == 1 else None
