"""What closes the loop of each axis of LinuxCNC, by its HAL files."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from contourlab.controls.linuxcnc.files import HalGraph, Ini
from contourlab.errors import ScenarioError

Loop = Literal["servo", "step generator", "velocity drive", "position drive", "simulated", "unknown"]
_STEPS = re.compile(r"step[-_]?(gen|dir|per)|pluto.step|freqgen|(remora|rio)\.joint\.")
_SINKS: tuple[tuple[re.Pattern[str], Loop, str], ...] = (
    (_STEPS, "step generator", ""),
    (
        re.compile(r"pwm|dac|dcmotor|analog|aout|7i77|7i83", re.IGNORECASE),
        "unknown",
        "an analogue or PWM output: the drive behind it may take torque or velocity",
    ),
    (re.compile(r"8i20.*current|(lcec|cia402|ethercat).*(torque|current)"), "servo", "a torque or current"),
    (re.compile(r"(lcec|cia402|ethercat).*[._-](velo?|velocity|speed|rpm)\b|sim.encoder.*speed"), "velocity drive", "a velocity"),
)
"""What takes the output, by module and pin, and what that says of the loop."""
_ENCODERS = re.compile(r"enc|resolver|\b(ssi|biss|fabs|lcec|cia402|ethercat)\b")
_READERS = re.compile(r"^(sampler|pyvcp|gladevcp|qtvcp|halui|axisui|ddt|wcomp|joint\.\d+|axis\.\d+)\.")
"""Pins that watch a signal."""


_POSITIONS = re.compile(r"(lcec|cia402|ethercat).*[._-](pos|position|target)")


@dataclass(frozen=True)
class LoopClass:
    """What an axis closes its loop on, and why it is thought so.

    Attributes
    ----------
    loop : str
        With a pid "servo" for torque or current, or "velocity drive"; "step generator" where only its own counter is in the loop. Without
        one also "position drive", which takes the commanded position, and "simulated" where that is the position; or "unknown".
    why : str
    """

    loop: Loop
    why: str


def classified(graph: HalGraph, pid: str) -> LoopClass:
    """Return the class of a pid, from its output to what takes it and from its feedback to where it comes from."""
    pins, goes = graph.sinks(f"{pid}.output"), f"{pid}.output goes to"
    forms = [(pin, loop, words) for pin in pins for form, loop, words in _SINKS if form.search(f"{graph.kind(pin)} {pin}")]
    taken = {words: (pin, loop) for pin, loop, words in reversed(forms)}
    if not taken:
        unread, others = ", ".join(entry.value for entry in graph.unread), [pin for pin in pins if not _READERS.search(pin)]
        unsure = f"{', '.join(others)}: whether that takes torque or velocity is not known"
        where = unsure if others else "no pin in the files that were read"
        return LoopClass("unknown", f"{goes} {where}; not read: {unread}" if unread else f"{goes} {where}")
    if len(taken) > 1:
        return LoopClass("unknown", f"{goes} {' and '.join(pin for pin, _ in taken.values())}, which are not of one kind")
    ((words, (sink, loop)),) = taken.items()
    if loop != "step generator":
        return LoopClass(loop, f"{goes} {sink}, {words}")
    kind, source = feedback(graph, f"{pid}.feedback")
    ways = f"{goes} {sink}, a step generator, and {pid}.feedback comes from {source}"
    if kind == "steps":
        return LoopClass("step generator", f"{ways}, the count of its own steps: nothing of the machine is in the loop")
    if kind == "unseen" or sink.startswith("ppmc."):
        return LoopClass("unknown", f"{ways}, which {'is not known here' if kind == 'unseen' else 'may count these steps'}")
    return LoopClass("velocity drive", ways)


@dataclass(frozen=True)
class Joint:
    """A joint of LinuxCNC.

    Attributes
    ----------
    number : int
    axis : str
        Lower-case letter.
    pid : str
        Name of the channel on its commanded position, as ``pid.0``; empty without one.
    """

    number: int
    axis: str
    pid: str


def kinematics_of(ini: Ini, graph: HalGraph) -> list[tuple[str, str]]:
    """Return place and words of each kinematics that the INI file names, or HAL loads."""
    entry = ini.first("KINS", "KINEMATICS")
    loaded = [(line.place, " ".join(line.words[1:])) for line in graph.statements if line.words[0] == "loadrt" and len(line.words) > 1]
    return ([(entry.place, entry.value)] if entry else []) + [one for one in loaded if re.match(r"\w*kins\b", one[1])]


def refuse_coupled(ini: Ini, graph: HalGraph) -> None:
    """Raise ScenarioError if a joint may be no axis."""
    for place, kind in kinematics_of(ini, graph):
        if kind.partition(" ")[0] != "trivkins":
            raise ScenarioError(f"kinematics {kind.partition(' ')[0]}: joints are no axes; only trivkins is read", file=place)


def joints(ini: Ini, graph: HalGraph) -> list[Joint]:
    """Return the joints in order, with the pid of each."""
    traj = ini.first("TRAJ", "COORDINATES")
    named = (re.search(r"coordinates=([A-Za-z]+)", kind) for _, kind in kinematics_of(ini, graph))
    given = next((match[1] for match in named if match), "") or (traj.value.replace(" ", "") if traj else "XYZABCUVW")
    letters = dict(enumerate(given.lower()))
    if not any(section.startswith("JOINT_") for section, _ in ini.values):  # before LinuxCNC 2.8 an axis had the number of its letter
        letters = {"xyzabcuvw".find(letter): letter for letter in letters.values()}
    channels = [name for name, kind in graph.kinds.items() if kind in ("pid", "at_pid")]
    by_signal = {graph.signal_of[pin]: name for name in channels if (pin := f"{name}.command") in graph.signal_of}
    return [Joint(n, letter, by_signal.get(graph.signal_of.get(commanded(graph, n), ""), "")) for n, letter in letters.items()]


def commanded(graph: HalGraph, joint: int) -> str:
    """Return the pin of a joint's commanded position; empty if nothing reads it."""
    return next((pin for pin in (f"joint.{joint}.motor-pos-cmd", f"axis.{joint}.motor-pos-cmd") if pin in graph.signal_of), "")


def without_pid(graph: HalGraph, joint: int) -> LoopClass:
    """Return the class of a joint that has no pid, from what takes its commanded position."""
    pin = commanded(graph, joint)
    if not pin:
        unread = ", ".join(entry.value for entry in graph.unread)
        return LoopClass("unknown", f"nothing reads joint.{joint}.motor-pos-cmd" + (f"; not read: {unread}" if unread else ""))
    sinks, goes = graph.sinks(pin), f"{pin} goes to"
    forms: tuple[tuple[re.Pattern[str], Loop, str], ...] = (
        (_STEPS, "step generator", "a step generator"),
        (_POSITIONS, "position drive", "a drive that takes positions"),
        (re.compile(rf"\.{joint}\.motor-pos-fb$"), "simulated", "its own feedback: there is no machine behind it"),
    )
    for form, loop, words in forms:
        if taken := next((sink for sink in sinks if form.search(sink)), ""):
            return LoopClass(loop, f"{goes} {taken}, {words}")
    others = ", ".join(sink for sink in sinks if not _READERS.search(sink))
    return LoopClass("unknown", f"{goes} {others or 'no pin in the files that were read'}")


def feedback(graph: HalGraph, pin: str) -> tuple[str, str]:
    """Return what a feedback is, one of steps, encoder and unseen, and the pin that it comes from."""
    sources = dict[str, str]()
    for group in graph.sources(pin):
        others = [other for other in group if not _READERS.search(other) and not other.endswith("-cmd")]
        encoders = [other for other in others if _ENCODERS.search(f"{graph.kind(other)} {other}")]
        steps = [other for other in others if _STEPS.search(other) and other not in encoders]
        by_kind = {"steps": steps, "encoder": encoders, "unseen": others}
        sources |= dict([(kind, pins[0]) for kind, pins in by_kind.items() if pins][:1])
    if len(sources) == 1:
        return next(iter(sources.items()))
    return "unseen", " and ".join(sources.values()) or "no pin in the files that were read"
