"""Check a motion against a machine: number of samples, travel, and velocity and acceleration without a planner."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from contourlab.feed import Reference
from contourlab.feed.reference import ReferenceBlock
from contourlab.loop import Machine
from contourlab.loop.simulate import BLOCK, jit_enabled, sampler

MOST_SAMPLES = 100_000_000
"""More than a day at 1 kHz; all of a run's signals then take some 30 GB."""

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
    if any(np.isfinite(axis.limits.travel).any() for axis in machine.axes):
        _check_travel(reference, machine, fault, cure)
    if not bounded:
        _check_speeds(reference, machine, fault)


def _blocks(reference: Reference, stop: int) -> Iterator[ReferenceBlock]:
    # A run asks for the same blocks, which the reference caches.
    fill = sampler(jit_enabled())
    for start in range(0, stop, BLOCK):
        yield reference.block(start, min(start + BLOCK, stop), fill)


def _check_travel(reference: Reference, machine: Machine, fault: Fault, cure: str) -> None:
    """Refuse the first sample outside the travel, with the full range of that axis."""
    first: tuple[str, int] | None = None
    ends = [(np.inf, -np.inf)] * len(machine.axes)
    for block in _blocks(reference, reference.n_sample):
        ends = [(min(low, p.min()), max(high, p.max())) for (low, high), p in zip(ends, block.position.T, strict=True)]
        for axis, position in zip(machine.axes, block.position.T, strict=True):
            outside = np.maximum(position - axis.limits.travel[1], axis.limits.travel[0] - position) > 1e-9
            if first is None and outside.any():
                k = int(np.argmax(outside))
                first = axis.name, int(reference.source_line(block.arc_length[k : k + 1])[0])
    if first is not None:
        name, line = first
        (sent_low, sent_high), (low, high) = ends[machine.axis_names.index(name)], machine.axis(name).limits.travel
        travel = f"but its travel is {low * 1e3:g} to {high * 1e3:g} mm"
        raise fault(f"axis {name} would move from {_mm(sent_low)} to {_mm(sent_high)} mm, {travel}: {cure}, or correct limits.travel", line)


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
