"""What a ``pid`` closes its loop on: a servo, a step generator, a velocity drive; from the wiring, and where that cannot say from a log."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from contourlab.features.commission.hal_graph import HalGraph

Loop = Literal["servo", "step generator", "velocity drive", "unknown"]
_STEPS = re.compile(r"step[-_]?(gen|dir|per)|pluto.step|freqgen|(remora|rio)\.joint\.")
_SINKS: tuple[tuple[re.Pattern[str], str], ...] = (
    (_STEPS, "steps"),
    (re.compile(r"pwm|dac|dcmotor|analog|aout|7i77|7i83", re.IGNORECASE), "analogue"),
    (re.compile(r"8i20.*current|(lcec|cia402|ethercat).*(torque|current)"), "torque"),
    (re.compile(r"(lcec|cia402|ethercat).*[._-](velo?|velocity|speed|rpm)\b|sim.encoder.*speed"), "velocity"),
)
"""What takes the output, by module and pin."""
_ENCODERS = re.compile(r"enc|resolver|\b(ssi|biss|fabs|lcec|cia402|ethercat)\b")
_READERS = re.compile(r"^(sampler|pyvcp|gladevcp|qtvcp|halui|axisui|ddt|wcomp|joint\.\d+|axis\.\d+)\.")
"""Pins that watch a signal."""


@dataclass(frozen=True)
class LoopClass:
    """What an axis' pid closes its loop on, and why it is thought so.

    Attributes
    ----------
    loop : str
        "servo" for torque or current; "step generator" where only its own counter is in the loop; "velocity drive"; or "unknown".
    why : str
    """

    loop: Loop
    why: str


def classified(graph: HalGraph, pid: str) -> LoopClass:
    """Return the class of a pid, from its output to what takes it and from its feedback to where it comes from."""
    pins = graph.sinks(f"{pid}.output")
    by_kind: dict[str, str] = {}
    for pin in pins:
        known = next((kind for form, kind in _SINKS if form.search(f"{graph.kind(pin)} {pin}")), None)
        if known is not None:
            by_kind.setdefault(known, pin)
    if len(by_kind) != 1:
        where = "both " + " and ".join(by_kind.values()) if by_kind else _elsewhere(graph, pins)
        return LoopClass("unknown", f"{pid}.output goes to {where}")
    ((kind, sink),) = by_kind.items()
    return _class_of(kind, sink, *_feedback(graph, pid), pid)


def _elsewhere(graph: HalGraph, pins: Sequence[str]) -> str:
    """Return where an output goes that reaches nothing known."""
    unread = ", ".join(entry.value for entry in graph.unread)
    others = [pin for pin in pins if not _READERS.search(pin)]
    where = f"{', '.join(others)}: whether that takes torque or velocity is not known" if others else "no pin in the files that were read"
    return f"{where}; not read: {unread}" if unread else where


def _feedback(graph: HalGraph, pid: str) -> tuple[str, str]:
    """Return what a feedback is, one of steps, encoder, command and unseen, and its pin."""
    found = dict[str, str]()
    for group in graph.sources(f"{pid}.feedback"):
        commands = [pin for pin in group if pin.endswith(".motor-pos-cmd")]
        others = [pin for pin in group if not _READERS.search(pin) and not pin.endswith("-cmd")]
        encoders = [pin for pin in others if _ENCODERS.search(f"{graph.kind(pin)} {pin}")]
        steps = [pin for pin in others if _STEPS.search(pin) and pin not in encoders]
        for kind, some in (("command", commands), ("steps", steps), ("encoder", encoders), ("unseen", others)):
            if some:
                found[kind] = some[0]
                break
    if len(found) == 1:
        return next(iter(found.items()))
    return "unseen", " and ".join(found.values()) or "no pin in the files that were read"


def _class_of(kind: str, sink: str, feedback: str, source: str, pid: str) -> LoopClass:
    """Return the class for a kind of sink and of feedback."""
    goes = f"{pid}.output goes to {sink}"
    if feedback == "command":
        return LoopClass("unknown", f"{pid}.feedback is the command itself, {source}")
    if kind == "torque":
        return LoopClass("servo", f"{goes}, a torque or current")
    if kind == "velocity":
        return LoopClass("velocity drive", f"{goes}, a velocity")
    if kind == "analogue":
        return LoopClass("unknown", f"{goes}, an analogue or PWM output: the drive behind it may take torque or velocity")
    comes = f"{pid}.feedback comes from {source}"
    if feedback == "steps":
        return LoopClass("step generator", f"{goes} and {comes}, the count of its own steps: nothing of the machine is in the loop")
    if feedback == "unseen" or sink.startswith("ppmc."):
        reason = "which may count these steps" if feedback == "encoder" else "which is not known here"
        return LoopClass("unknown", f"{goes}, a step generator; {comes}, {reason}")
    return LoopClass("velocity drive", f"{goes}, the rate of a step generator, and {comes}")
