"""What a controller costs at run time: the time of a servo tick, measured."""

from __future__ import annotations

from time import perf_counter

from contourlab.engine.runner import make_group
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine
from contourlab.loop.feeding import Feed
from contourlab.loop.simulate import sampler
from contourlab.loop.template import build

TICKS, SECONDS, FEWEST = 20_000, 0.3, 7
"""Ticks of a run at most; how long runs are timed, and how many of them at least."""


def tick_cost(machine: Machine, controller: Controller, reference: Reference) -> float:
    """Return the time of one tick of the compiled loop [s]: the shortest of some runs, on whatever this machine is.

    Parameters
    ----------
    machine, controller, reference
        As of `contourlab.loop.simulate`. The machine's own physics are in the figure: compare schemes, which share it.
    """
    feed = Feed(machine, controller, reference, None, sampler(True))
    first, fed = feed.block(0, min(TICKS, reference.n_sample))
    loop = build(machine, controller, reference.path, first.position[0], float(first.arc_length[0]), fed=feed.names)
    group = make_group(loop.schedule, 1, slice(0, 1), True)
    start = group.snapshot()
    times: list[float] = []
    while len(times) < FEWEST or sum(times) * len(fed) < SECONDS:
        group.restore(start)
        begun = perf_counter()
        group.run(fed, [])
        times.append((perf_counter() - begun) / len(fed))
    return min(times)
