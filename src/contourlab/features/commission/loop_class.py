"""What a ``pid`` closes its loop on: a servo, a step generator, a velocity drive; from the wiring, and where that cannot say from a log."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from contourlab.arrays import Array
from contourlab.features.commission.hal_graph import HalGraph
from contourlab.figures import figure

Loop = Literal["servo", "step generator", "velocity drive", "unknown"]
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
SPAN, LATEST = 0.02, 0.02
"""Time [s] over which positions are differenced where a log decides, and longest delay of the motion behind the output."""
EXPLAINED = 0.8
"""Least part of the output that velocity, acceleration and friction must explain."""
QUICK, SLOW = 100.0, 20.0
"""Rates [1/s] at which a velocity settles: above the first one it follows the output; above the second where the output is the speed."""
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
    pins, goes = graph.sinks(f"{pid}.output"), f"{pid}.output goes to"
    forms = [(pin, loop, words) for pin in pins for form, loop, words in _SINKS if form.search(f"{graph.kind(pin)} {pin}")]
    taken = {words: (pin, loop) for pin, loop, words in reversed(forms)}
    if not taken:
        return LoopClass("unknown", f"{goes} {_elsewhere(graph, pins)}")
    if len(taken) > 1:
        return LoopClass("unknown", f"{goes} {' and '.join(pin for pin, _ in taken.values())}, which are not of one kind")
    ((words, (sink, loop)),) = taken.items()
    return _stepping(graph, pid, sink) if loop == "step generator" else LoopClass(loop, f"{goes} {sink}, {words}")


def _elsewhere(graph: HalGraph, pins: Sequence[str]) -> str:
    """Return where an output goes that reaches nothing known."""
    unread = ", ".join(entry.value for entry in graph.unread)
    others = [pin for pin in pins if not _READERS.search(pin)]
    where = f"{', '.join(others)}: whether that takes torque or velocity is not known" if others else "no pin in the files that were read"
    return f"{where}; not read: {unread}" if unread else where


def _feedback(graph: HalGraph, pid: str) -> tuple[str, str]:
    """Return what a feedback is, one of steps, encoder and unseen, and its pin."""
    found = dict[str, str]()
    for group in graph.sources(f"{pid}.feedback"):
        others = [pin for pin in group if not _READERS.search(pin) and not pin.endswith("-cmd")]
        encoders = [pin for pin in others if _ENCODERS.search(f"{graph.kind(pin)} {pin}")]
        steps = [pin for pin in others if _STEPS.search(pin) and pin not in encoders]
        for kind, some in (("steps", steps), ("encoder", encoders), ("unseen", others)):
            if some:
                found[kind] = some[0]
                break
    if len(found) == 1:
        return next(iter(found.items()))
    return "unseen", " and ".join(found.values()) or "no pin in the files that were read"


def _stepping(graph: HalGraph, pid: str, sink: str) -> LoopClass:
    """Return the class of a pid that drives a step generator."""
    feedback, source = _feedback(graph, pid)
    ways = f"{pid}.output goes to {sink}, a step generator, and {pid}.feedback comes from {source}"
    if feedback == "steps":
        return LoopClass("step generator", f"{ways}, the count of its own steps: nothing of the machine is in the loop")
    if feedback == "unseen" or sink.startswith("ppmc."):
        return LoopClass("unknown", f"{ways}, which {'is not known here' if feedback == 'unseen' else 'may count these steps'}")
    return LoopClass("velocity drive", ways)


def decided(records: Sequence[tuple[Array, Array]], period: float, unit: float) -> LoopClass | None:
    """Return the class that logs show, or None if they show none.

    Parameters
    ----------
    records : sequence of (ndarray (n,), ndarray (n,) [m])
        Output and measured position.
    period : float [s]
    unit : float [m]
        Machine unit.

    Notes
    -----
    The output is explained by the motion, u = (v' + d v + f sign v)/g + o, both averaged over a triangle of twice `SPAN`. A velocity
    drive with one lag T has d = 1/T and no more than that: it differs from a torque by how soon its velocity settles, and by an output
    in machine units per second.
    """
    s = max(round(SPAN / period), 2)
    records = [(output, measured) for output, measured in records if measured.size > 20 * s]
    fits = [_explained(records, s, period, late) for late in range(max(round(LATEST / period), 1))] if records else []
    explained, late, (inertia, damping, *_) = max(fits, key=lambda fit: fit[0], default=(0.0, 0, (0.0, 0.0)))
    if not explained > EXPLAINED or not max(inertia, damping) > 0.0:
        return None
    rate = damping / inertia if inertia > 0.0 else np.inf
    as_speed = 0.8 * unit < 1.0 / max(damping, 1e-30) < 1.25 * unit
    if rate > QUICK or (rate > SLOW and as_speed):
        lag, delay = figure(1.0 / rate, "ms"), figure(late * period, "ms")
        return LoopClass("velocity drive", f"in the log its velocity follows the output, with a lag of {lag} and a delay of {delay}")
    slowing = figure(max(rate, 0.0), "1/s")
    return LoopClass("servo", f"in the log the output accelerates it; left alone its velocity decays with {slowing}")


def _explained(records: Sequence[tuple[Array, Array]], s: int, period: float, late: int) -> tuple[float, int, Array]:
    """Return the part of the output that the motion explains, its delay in samples, and output per acceleration and per velocity."""
    rows, targets = list[Array](), list[Array]()
    for output, measured in records:
        ends = np.array([measured[2 * s :], measured[s:-s], measured[: -2 * s]])[:, late:]
        place, held = np.cumsum(measured) - 0.5 * measured, np.cumsum(output) - 0.5 * output
        force = np.cumsum(held) - held  # the output is held from each sample to the next
        speed = (place[2 * s :] - 2.0 * place[s:-s] + place[: -2 * s])[late:] / (s * s * period)
        acceleration = (ends[0] - 2.0 * ends[1] + ends[2]) / (s * period) ** 2
        targets.append(((force[2 * s :] - 2.0 * force[s:-s] + force[: -2 * s]) / (s * s))[: acceleration.size])
        rows.append(np.column_stack([acceleration, speed, np.sign(ends[0] - ends[2]), np.ones(speed.size)]))
    left, right = np.concatenate(rows), np.concatenate(targets)
    numbers = np.asarray(np.linalg.lstsq(left, right, rcond=None)[0], dtype=float)
    return 1.0 - float(np.var(left @ numbers - right)) / max(float(np.var(right)), 1e-30), late, numbers
