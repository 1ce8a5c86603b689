"""Progress decided in the loop: a node in place of the inputs of a reference, and the motion that a run has followed.

A reference gives the set points of planned time. Where a coupling has the output ``rate``, or `contourlab.Loop` the input, planned time t
advances by rate times the servo period in each tick: at rate 1 the motion is the planned one, bit for bit, and at rate 0 it stands. Between
planned samples positions are cubic in t through position and velocity at both ends; velocities and accelerations are linear. With r(t) the
set points of the plan,

    reference velocity = rate r', reference acceleration = rate^2 r'' + (change of the rate) / (servo period) r'

What looks ahead sees where the motion will be if it goes on at the rate of this tick.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from itertools import accumulate
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.engine.step import Node, Port, Step, Wire, ports
from contourlab.feed import Reference
from contourlab.feed.reference import LAST_LAP, Judged, Recorded
from contourlab.loop.feeding import AHEAD, ALONG, EXTERNALS, PLANNED_TIME, RATE, SOURCE_LINE, Feed, decides
from contourlab.loop.machine import Controller
from contourlab.primitives import floor, lookup, maximum, minimum, select

MOST_SLOWER = 10
"""A run whose progress is decided in the loop ends after this many times its planned time."""


def motion_node(feed: Feed, rate: Wire) -> Node:
    """Return the node ``in`` with all inputs of a loop, at a planned time that advances by the rate of a wire.

    Memory: the whole motion, 8 (3 n_axis + 2) bytes a sample.
    """
    _, table = feed.block(0, feed.reference.n_sample)
    n = feed.reference.n_axis
    more = tuple(Port(name, feed.size(name)) for name in feed.names)
    outputs = (*ports(*EXTERNALS, size=n), *ports(*ALONG, PLANNED_TIME), *more)
    step = Step("motion", _moving(n, more, feed.ahead), ("count",), ("planned",), "", ports("at", "rate"), ports(RATE), outputs)
    count = float(len(table))
    return Node("in", step, {RATE: rate}, {"count": count}, {"planned": np.ascontiguousarray(table.T).ravel()}, {"at": -1.0})


@cache
def _moving(n: int, more: tuple[Port, ...], ahead: tuple[int, ...]) -> Callable[..., Any]:
    """Return the step for `n` axes, which look some ticks ahead; behind the motion the table has rows for `more` outputs."""
    firsts = accumulate((port.rows for port in more), initial=3 * n + 2)
    further = tuple((first, port.size, port.name == SOURCE_LINE, port.name == AHEAD) for first, port in zip(firsts, more, strict=False))

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        h, rate, last = clock.dt, maximum(inp.rate, 0.0), par.count - 1.0
        at = select(x.at < 0.0, 0.0, minimum(x.at + rate, last))  # the first tick is at time 0, whatever the rate
        bend = select(x.at < 0.0, 0.0, (rate - x.rate) / h)

        def start(row: int, at: Any) -> Any:
            return lookup(par.planned, row * par.count + floor(at))

        def end(row: int, at: Any) -> Any:
            return lookup(par.planned, row * par.count + minimum(floor(at) + 1.0, last))

        def between(row: int) -> Any:
            return start(row, at) + (at - floor(at)) * (end(row, at) - start(row, at))

        def through(row: int, slope: int, at: Any) -> Any:
            u, a, b, va, vb = at - floor(at), start(row, at), end(row, at), h * start(slope, at), h * end(slope, at)
            return a + u * (va + u * (3.0 * (b - a) - 2.0 * va - vb + u * (va + vb - 2.0 * (b - a))))

        velocity = tuple(between(n + j) for j in range(n))
        acceleration = tuple(rate * rate * between(2 * n + j) + bend * velocity[j] for j in range(n))
        others: tuple[Any, ...] = ()
        for row, size, held, later in further:
            if later:
                values = tuple(through(j, n + j, minimum(at + rate * float(ahead[j]), last)) for j in range(n))
            else:
                values = tuple(start(row + i, at) if held else between(row + i) for i in range(size or 1))
            others = (*others, values if size else values[0])
        position = tuple(through(j, n + j, at) for j in range(n))
        speeds = tuple(rate * velocity[j] for j in range(n))
        return (at, rate), (position, speeds, acceleration, through(3 * n, 3 * n + 1, at), rate * between(3 * n + 1), at * h, *others)

    return step


def followed(reference: Reference, signals: Mapping[str, Array]) -> Reference:
    """Return the motion that a run has followed, as a reference: its samples are in real time.

    Parameters
    ----------
    reference : Reference
        The plan.
    signals : mapping of str to ndarray (n_sample, ...)
        With `DECIDED`.
    """
    n, time = reference.n_axis, np.ascontiguousarray(signals[PLANNED_TIME])
    table = np.concatenate([*(signals[name].T for name in EXTERNALS), *(signals[name][None, :] for name in ALONG)]).T
    table.flags.writeable = False
    planned = np.rint(time / reference.servo_period * 1e6) / 1e6  # in samples, without the rounding of the product

    def reached(ranges: tuple[tuple[int, int], ...], before: float = 0.0) -> tuple[tuple[int, int], ...]:
        """Return the samples at which the planned samples of some ranges were reached, or what lies up to `before` samples before them."""
        ends = np.searchsorted(planned, np.array(ranges, dtype=float).reshape(-1, 2) - before)
        ends[np.array(ranges).reshape(-1, 2) >= reference.n_sample] = len(time)
        return tuple((int(start), int(stop)) for start, stop in ends if start < stop)

    return Reference(
        servo_period=reference.servo_period,
        n_sample=len(time),
        path=reference.path,
        programmed=reference.programmed,
        profile=None,
        line_breaks=reference.line_breaks,
        source_lines=reference.source_lines,
        laps=reached(reference.laps),
        recorded=Recorded(table[:, :n], table[:, 3 * n], table, time),
        correspondence=reference.correspondence,
        rapid=reference.rapid,
        # Laps begin on samples; a move begins after the last sample of the one before it, and so does a reversal between the two.
        chosen=Judged(reached(reference.judged.ranges, 0.0 if reference.judged.basis == LAST_LAP else 1.0 - 1e-6), reference.judged.basis),
    )


def most_samples(controller: Controller, reference: Reference) -> int:
    """Return the most samples of a run."""
    return reference.n_sample * (MOST_SLOWER if decides(controller, reference) else 1)
