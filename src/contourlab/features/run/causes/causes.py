"""What the error at one place is made of: take away one imperfection after another.

The same reference is run again with ever fewer imperfections. The contribution of a cause is the change of the error at that place, along
the direction of the error, when the cause is taken away:

1. *network*: no links between base and axes; 2. *geometry*: no error map; 3. *quantisation*: ideal encoders; 4. *saturation*: drives
without limit; 5. *disturbance*: no external load; 6. *backlash*: no free travel, and controllers that assume none; 7. *compliance*: stiff
shafts, which friction does not wind up, and no notch filters; 8. *friction*: no friction; 9. *servo mismatch*: every axis a copy of one
of them, averaged over the choice; 10. *lag*: a tool that is at the reference, so that overshoot counts as lag; 11. *planning*: the rest,
the distance of the planned path from the programmed one.

The error that friction causes is called *reversal* after an axis has reversed, *breakaway* after it has started from rest, else *friction*.

The contributions add up to the error. A step after which the loop diverges is left out and named; its part stays in the next step. The
order matters where effects interact, and is therefore fixed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np

from contourlab.arrays import Array
from contourlab.features.run.causes import idealise
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine, simulate
from contourlab.metrics import judge
from contourlab.rendering.judgement import Cause
from contourlab.result import Result, Signal

Rerun: TypeAlias = Callable[..., Result]
Step: TypeAlias = Callable[[Machine, Controller], tuple[Machine, Controller]]


def _of_machine(take_away: Callable[[Machine], Machine]) -> Step:
    return lambda machine, controller: (take_away(machine), controller)


FRICTION = "friction"
SOON = 0.25
"""Longest time from a reversal or a start to the error that friction then causes [s]."""
_STEPS: tuple[tuple[str, Step], ...] = (
    ("network", idealise.without_links),
    ("geometry", _of_machine(idealise.perfect_geometry)),
    ("quantisation", _of_machine(idealise.perfect_sensing)),
    ("saturation", _of_machine(idealise.unlimited)),
    ("disturbance", _of_machine(idealise.undisturbed)),
    ("backlash", idealise.without_backlash),
    ("compliance", idealise.without_compliance),
    (FRICTION, idealise.without_friction),
)
WOULD_HELP = {
    "network": "a faster link between base and axes",
    "geometry": "compensation of the error map",
    "quantisation": "a finer encoder",
    "saturation": "a stronger drive, or lower acceleration",
    "disturbance": "a stiffer loop, or a smaller load",
    "backlash": "less free travel, or feedback from the load",
    "reversal": "less friction, or a stiffer loop",
    "breakaway": "less friction, or a stiffer loop",
    FRICTION: "less friction, or a stiffer loop",
    "compliance": "a stiffer axis, feedback from the load, or lower jerk",
    "servo mismatch": "equal gains on all axes",
    "lag": "feedforward, or a lower feed",
    "planning": "a smaller corner tolerance",
}
"""What reduces each cause."""


@dataclass
class _Place:
    """A sample of a run, and the direction of the error there."""

    reference: Reference
    judged: Result
    sample: int
    rerun: Rerun
    size: float = field(init=False)
    direction: Array = field(init=False)

    def __post_init__(self) -> None:
        foot = self.reference.programmed.position(self.judged["foot_arc_length"][self.sample : self.sample + 1])[0]
        off = self.judged["tool_position"][self.sample] - foot
        self.size = float(np.linalg.norm(off))
        self.direction = off / self.size if self.size > 0.0 else off

    def after(self, machine: Machine, controller: Controller) -> float:
        """Return the error of another machine's run along this direction; NaN if the run ends before."""
        signals = ("tool_position", "reference", "arc_length")
        run = self.rerun(machine, controller, self.reference, on_failure="return", signals=signals)
        return self.of(run.window(self.sample, self.sample + 1)) if run.n_sample > self.sample else float("nan")

    def followed_perfectly(self) -> float:
        """Return the error of a tool that is where it was asked to be."""
        here = self.judged.window(self.sample, self.sample + 1)
        return self.of(here.with_signals(tool_position=Signal(here["reference"], ("sample", "axis"), "m")))

    def of(self, here: Result) -> float:
        judged = judge(here, self.reference)
        return float((judged["tool_position"][0] - self.reference.programmed.position(judged["foot_arc_length"])[0]) @ self.direction)


def _at_start(judged: Result, sample: int) -> str:
    """Return whether an axis has lately reversed or started from rest."""
    first = max(sample - round(SOON / judged.servo_period), 0)
    if "reference_velocity" not in judged:
        return FRICTION
    latest, name = -1, FRICTION
    for velocity in judged["reference_velocity"].T:
        moving = np.flatnonzero(velocity[: sample + 1])
        sign = np.sign(velocity[moving])
        fresh = np.flatnonzero(np.concatenate([[True], (sign[1:] != sign[:-1]) | (np.diff(moving) > 1)])[: moving.size])
        if fresh.size and moving[fresh[-1]] > max(latest, first - 1):
            latest, last = int(moving[fresh[-1]]), int(fresh[-1])
            name = "reversal" if last and sign[last] != sign[last - 1] else "breakaway"
    return name


def causes(
    machine: Machine, controller: Controller, reference: Reference, judged: Result, sample: int, rerun: Rerun = simulate
) -> tuple[tuple[Cause, ...], tuple[str, ...]]:
    """Return the causes of the part error at a sample, largest first, and the names of those after which the loop diverges.

    `judged` is the run with the judge's signals, `rerun` is `simulate` with its options. The contributions add up to the error.
    """
    place = _Place(reference, judged, sample, rerun)
    contributions: list[tuple[str, float]] = []
    diverging: list[str] = []
    left, kept = place.size, machine
    for name, take_away in _STEPS:
        better, driven = take_away(kept, controller)
        same = better is kept and driven is controller
        if same and name in ("network", "backlash", "compliance"):
            continue  # few machines have any
        now = left if same else place.after(better, driven)
        if np.isnan(now):
            diverging.append(name)
            continue
        contributions.append((_at_start(judged, sample) if name == FRICTION and not same else name, left - now))
        left, kept, controller = now, better, driven
    copies = np.array([place.after(*idealise.same_axes(kept, controller, axis.name)) for axis in machine.axes])
    if np.isfinite(copies).any():
        contributions.append(("servo mismatch", left - float(np.nanmean(copies))))
        left = float(np.nanmean(copies))
    else:
        diverging.append("servo mismatch")
    planning = place.followed_perfectly()
    contributions += [("lag", left - planning), ("planning", planning)]
    total = sum(abs(value) for _, value in contributions) or 1.0
    ranked = (Cause(name, float(value), float(abs(value) / total)) for name, value in contributions)
    return tuple(sorted(ranked, key=lambda cause: -cause.share)), tuple(diverging)
