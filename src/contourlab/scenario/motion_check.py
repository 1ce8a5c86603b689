"""Check a motion against a machine: number of samples, travel, and velocity and acceleration without a planner."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.feed import Reference
from contourlab.feed.reference import ReferenceBlock
from contourlab.loop import Machine
from contourlab.loop.simulate import BLOCK, jit_enabled, sampler

MOST_SAMPLES = 100_000_000
"""More than a day at 1 kHz; all of a run's signals then take some 30 GB."""

ROUNDING = 1e-9
"""Rounding [m] that does not count as leaving the travel."""

Fault = Callable[[str, int], Exception]


def check_motion(reference: Reference, machine: Machine, fault: Fault, *, bounded: bool, cure: str = "move the part") -> None:
    """Refuse a motion that is too long or beyond the limits of the machine.

    Parameters
    ----------
    fault : callable
        Returns the error to raise, from a message and a program line (0 for none).
    bounded : bool
        Whether a planner kept to the limits of velocity and acceleration.
    cure : str
        What to do if the motion leaves the travel.
    """
    if reference.n_sample > MOST_SAMPLES:
        raise fault(
            f"the motion takes {reference.duration:.3g} s or {reference.n_sample:.3g} samples of {reference.servo_period:g} s, but at most "
            f"{MOST_SAMPLES:.0e} are allowed: check the feed",
            0,
        )
    if any(axis.limits.bounded for axis in machine.axes):
        _check_travel(reference, machine, fault, cure)
    if not bounded:
        _check_speeds(reference, machine, fault)


def _blocks(reference: Reference, stop: int) -> Iterator[ReferenceBlock]:
    # A run asks for the same blocks, which the reference caches.
    fill = sampler(jit_enabled())
    for start in range(0, stop, BLOCK):
        yield reference.block(start, min(start + BLOCK, stop), fill)


class TravelCheck:
    """Where a motion, given piece by piece, first leaves the travel of each axis.

    Attributes
    ----------
    low, high : ndarray (n_axis,) [m]
        Ends of the motion so far.
    cut_low, cut_high : ndarray (n_axis,) [m]
        Those of its feed moves, for axes whose travel is a length: rapids to a tool change are not in the coordinates of the part.
    left : dict of str to int
        Program line on which an axis first leaves its travel, in the order of the motion.
    """

    def __init__(self, machine: Machine) -> None:
        self.axes = machine.axes
        self.low, self.cut_low = np.full((2, len(machine.axes)), np.inf)
        self.high, self.cut_high = np.full((2, len(machine.axes)), -np.inf)
        self.left: dict[str, int] = {}

    def add(self, low: Array, high: Array, feed: Flags, lines: Index) -> None:
        """Add points or boxes (n, n_axis), n > 0, with their program lines (n,); `feed` tells which belong to feed moves."""
        left = []
        for j, axis in enumerate(self.axes):
            start, stop = axis.limits.ends
            outside = np.maximum(high[:, j] - stop, start - low[:, j]) > ROUNDING
            if math.isfinite(axis.limits.extent):
                cut_low = np.minimum.accumulate(np.append(self.cut_low[j], np.where(feed, low[:, j], np.inf)))
                cut_high = np.maximum.accumulate(np.append(self.cut_high[j], np.where(feed, high[:, j], -np.inf)))
                outside |= (cut_high - cut_low)[1:] > axis.limits.extent + ROUNDING
                self.cut_low[j], self.cut_high[j] = cut_low[-1], cut_high[-1]
            left += [(int(np.argmax(outside)), axis.name)] if outside.any() else []
        for k, name in sorted(left):
            self.left.setdefault(name, int(lines[k]))
        self.low, self.high = np.minimum(self.low, low.min(axis=0)), np.maximum(self.high, high.max(axis=0))


def _check_travel(reference: Reference, machine: Machine, fault: Fault, cure: str) -> None:
    """Refuse the first sample outside the travel, with the full range of that axis."""
    check = TravelCheck(machine)
    rapid = np.zeros(len(reference.source_lines), dtype=bool) if reference.rapid is None else reference.rapid
    for block in _blocks(reference, reference.n_sample):
        curve = reference.path.curve_index(block.arc_length)
        check.add(block.position, block.position, ~rapid[curve], reference.source_lines[curve])
    for name, line in check.left.items():
        j, limits = machine.axis_names.index(name), machine.axis(name).limits
        if math.isfinite(limits.extent):
            way, travel = f"cut over {_mm(check.cut_high[j] - check.cut_low[j])} mm", f"{_mm(limits.extent)} mm: shorten the part"
        else:
            low, high = (_mm(end) for end in limits.ends)
            way, travel = f"move from {_mm(check.low[j])} to {_mm(check.high[j])} mm", f"{low} to {high} mm: {cure}"
        raise fault(f"axis {name} would {way}, but its travel is {travel}, or correct limits.travel", line)


def _mm(value: float) -> str:
    """Write a position in mm to 0.1 um, so that rounding errors show as 0.

    >>> _mm(-9.5e-18), _mm(0.22)
    ('0', '220')
    """
    return f"{round(value * 1e3, 4) + 0.0:.10g}"


def _check_speeds(reference: Reference, machine: Machine, fault: Fault) -> None:
    """Check velocity and acceleration over the first lap; all laps are alike."""
    worst = {"velocity": np.zeros(len(machine.axes)), "acceleration": np.zeros(len(machine.axes))}
    for block in _blocks(reference, reference.laps[0][1] if reference.laps else reference.n_sample):
        for name, largest in worst.items():
            np.maximum(largest, np.abs(getattr(block, name)).max(axis=0), out=largest)
    for power, (name, unit, scale) in enumerate((("velocity", "mm/s", 1e3), ("acceleration", "m/s^2", 1.0)), 1):
        for axis, asked in zip(machine.axes, worst[name], strict=True):
            limit = getattr(axis.limits, name)
            if asked > limit * (1.0 + 1e-9):
                what = f"{'an' if name[0] == 'a' else 'a'} {name} of {asked * scale:.4g} {unit}"
                raise fault(
                    f"axis {axis.name} reaches {what}, but its limit is {limit * scale:.4g} {unit}: "
                    f"use at most {(limit / asked) ** (1.0 / power):.3g} times this frequency",
                    0,
                )
