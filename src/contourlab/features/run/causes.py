"""What the error at one place is made of, by taking one imperfection away after another.

The causes are worked out, not guessed. The same reference is run again with ever fewer imperfections, and the contribution of a cause is
what the error at that place changes by, along the direction in which the tool was off, when its own is taken away:

1. *network*: no links between base and axes; 2. *geometry*: the machine's error map; 3. *quantisation*: ideal encoders; 4.
*saturation*: drives without limit; 5. *disturbance*: no load from outside; 6. *backlash*: no free travel, and controllers that reckon with
none; 7. *reversal*: no friction; 8. *servo mismatch*: every axis a copy of one of them, averaged over the choice; 9. *lag*: a tool that is
where it was asked to be, so that overshoot counts as lag too; 10. *planning*: what is left then, the planned path's own distance from the
programmed one.

The contributions add up to the error itself. A loop that runs away once its friction is gone tells nothing: such a step is left out and
named, and what it stands for stays in the next one. The order matters where effects interact, and is therefore fixed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from contourlab.features.run import idealise
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine, simulate
from contourlab.metrics import judge
from contourlab.result import Result, Signal

Array = NDArray[np.float64]
Step: TypeAlias = Callable[[Machine, Controller], tuple[Machine, Controller]]


def _of_machine(take_away: Callable[[Machine], Machine]) -> Step:
    return lambda machine, controller: (take_away(machine), controller)


_STEPS: tuple[tuple[str, Step], ...] = (
    ("network", idealise.without_links),
    ("geometry", _of_machine(idealise.perfect_geometry)),
    ("quantisation", _of_machine(idealise.perfect_sensing)),
    ("saturation", _of_machine(idealise.unlimited)),
    ("disturbance", _of_machine(idealise.undisturbed)),
    ("backlash", idealise.without_backlash),
    ("reversal", _of_machine(idealise.without_friction)),
)


@dataclass(frozen=True, slots=True)
class Cause:
    """One cause of the error at the worst place.

    Attributes
    ----------
    name : str
    contribution : float [m]
        Along the direction in which the tool was off: negative where it made the error smaller.
    share : float
        Of the sum of all contributions' magnitudes, 0 to 1.
    """

    name: str
    contribution: float
    share: float


@dataclass
class _Place:
    """A sample of a run, and the direction in which the tool was off there."""

    reference: Reference
    judged: Result
    sample: int
    seed: int
    size: float = field(init=False)
    direction: Array = field(init=False)

    def __post_init__(self) -> None:
        foot = self.reference.programmed.position(self.judged["foot_arc_length"][self.sample : self.sample + 1])[0]
        off = self.judged["tool_position"][self.sample] - foot
        self.size = float(np.linalg.norm(off))
        self.direction = off / self.size if self.size > 0.0 else off

    def after(self, machine: Machine, controller: Controller) -> float:
        """Return the error of another machine's run, along this direction; NaN if it does not get there."""
        signals = ("tool_position", "reference", "arc_length")
        run = simulate(machine, controller, self.reference, seed=self.seed, on_failure="return", signals=signals)
        return self.of(run.window(self.sample, self.sample + 1)) if run.n_sample > self.sample else float("nan")

    def followed_perfectly(self) -> float:
        """Return the error of a tool that is where it was asked to be."""
        here = self.judged.window(self.sample, self.sample + 1)
        return self.of(here.with_signals(tool_position=Signal(here["reference"], ("sample", "axis"), "m")))

    def of(self, here: Result) -> float:
        one = judge(here, self.reference)
        return float((one["tool_position"][0] - self.reference.programmed.position(one["foot_arc_length"])[0]) @ self.direction)


def causes(
    machine: Machine, controller: Controller, reference: Reference, judged: Result, sample: int, seed: int = 0
) -> tuple[tuple[Cause, ...], tuple[str, ...]]:
    """Return what the part error at a sample is made of, and the names of the causes that could not be told apart.

    Parameters
    ----------
    machine, controller, reference
        What was run.
    judged : Result
        The run, with the judge's signals.
    sample : int
        Where.
    seed : int
        The seed of the run.

    Returns
    -------
    tuple of Cause
        Largest first; they add up to the error.
    tuple of str
        Steps at which the loop with less imperfections ran away.
    """
    place = _Place(reference, judged, sample, seed)
    found: list[tuple[str, float]] = []
    untold: list[str] = []
    left, kept = place.size, machine
    for name, take_away in _STEPS:
        better, driven = take_away(kept, controller)
        same = better is kept and driven is controller
        if same and name in ("network", "backlash"):
            continue  # few machines have any
        now = left if same else place.after(better, driven)
        if np.isnan(now):
            untold.append(name)
            continue
        found.append((name, left - now))
        left, kept, controller = now, better, driven
    copies = np.array([place.after(*idealise.same_axes(kept, controller, axis.name)) for axis in machine.axes])
    if np.isfinite(copies).any():
        found.append(("servo mismatch", left - float(np.nanmean(copies))))
        left = float(np.nanmean(copies))
    else:
        untold.append("servo mismatch")
    planning = place.followed_perfectly()
    found += [("lag", left - planning), ("planning", planning)]
    total = sum(abs(value) for _, value in found) or 1.0
    ranked = (Cause(name, float(value), float(abs(value) / total)) for name, value in found)
    return tuple(sorted(ranked, key=lambda cause: -cause.share)), tuple(untold)
