"""Exact judgement of the samples at which the judge of a batch is in doubt: these variants run once more."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from itertools import product
from typing import Any

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.engine.runner import Group, make_group
from contourlab.loop.feeding import Feed
from contourlab.loop.judging import JUDGE, PART, PLACE, most_error, room_for, sums_of
from contourlab.loop.machine import Machine
from contourlab.loop.simulate import BLOCK
from contourlab.loop.template import Loop
from contourlab.metrics.judge import reach
from contourlab.metrics.streaming import SUMS
from contourlab.threads import in_threads

_AT_ONCE = 1 << 13
"""Samples of a lane that are judged exactly at once."""
_ROW = {name: 1 + i for i, name in enumerate(SUMS)}


def judge_doubtful(
    loop: Loop, machine: Machine, feed: Feed, sums: Mapping[str, Array], failed: Index, jit: bool, threads: int, lanes: int
) -> Array:
    """Run all variants with doubtful samples again, unless they failed, and judge these samples exactly.

    Parameters
    ----------
    loop : Loop
        With the judges.
    sums : mapping of str to ndarray (n_state, n)
        The states of each judge in all variants: those of variants with doubtful samples are replaced.
    failed : ndarray (n,) of int
        -1 for a variant that did not fail.

    Returns
    -------
    ndarray (n,)
        Samples that nobody has judged exactly, of variants that failed.
    """
    unsure: Array = sum((total[_ROW["unsure"]] for total in sums.values()), np.zeros(failed.size))
    doubtful = np.flatnonzero((unsure > 0.0) & (failed < 0))
    if not doubtful.size:
        return unsure
    reference, n = feed.reference, feed.reference.n_axis
    rows = [loop.schedule.row(signal) for signal in (*loop.signals["axis_position"], *(f"{name}.doubt" for name in sums))]
    paths = {JUDGE: reference.path, PART: reference.programmed}
    nodes = {node.name: node for node in loop.schedule.nodes}
    for name in sums:
        numbers, cells = room_for(paths[name], most_error(machine), float(nodes[name].parameters["planning"]))
        wide: dict[str, Any] = {"parameters": {**nodes[name].parameters, **numbers}, "tables": {**nodes[name].tables, **cells}}
        nodes[name] = replace(nodes[name], **wide)
    schedule = replace(loop.schedule, nodes=tuple(nodes.values()))
    groups = [make_group(schedule, lanes, doubtful[i : i + lanes], jit) for i in range(0, doubtful.size, lanes)]

    def again(group: Group, k: int, external: Array, arc_length: Array) -> None:
        log, samples = group.run(external, rows), slice(k, k + len(external))
        for (j, name), (lane, variant) in product(enumerate(sums, n), enumerate(np.asarray(group.lanes).tolist())):
            here = np.flatnonzero(nodes[name].tables["counts"][samples] * log[:, j, lane])
            if here.size:
                path, around = paths[name], nodes[PLACE].tables["place"][samples] if name == PART else arc_length
                window = reach(path, float(np.sqrt(sums[name][-1, variant]))) + float(nodes[name].parameters["planning"])
                # Each lane on its own: the last digits of a foot point depend on what is searched together.
                feet = path.foot_point(log[here, :n, lane], around[here], window)
                _add(group.state_of(name)[:, lane], feet.signed if path.is_planar else feet.distance, k + here)

    for first in range(0, reference.n_sample, BLOCK):
        asked, external = feed.block(first, min(first + BLOCK, reference.n_sample))
        for k in range(0, len(external), _AT_ONCE):
            cut = slice(k, k + _AT_ONCE)
            in_threads(partial(again, k=first + k, external=external[cut], arc_length=asked.arc_length[cut]), groups, threads)
    for name, total in sums.items():
        total[:, doubtful] = sums_of(groups, name, doubtful.size)
    unsure[doubtful] = 0.0
    return unsure


def _add(states: Array, error: Array, samples: Index) -> None:
    """Add the exact errors (n,) of some samples to the states of a judge in one lane."""
    size = np.abs(error)
    for name, values in (("sum_magnitude", size), ("sum_square", size**2), ("sum_signed", error)):
        states[_ROW[name]] += values.sum()
    worst, largest = int(np.argmax(size)), [_ROW["largest"], _ROW["largest_at"]]
    if (size[worst], -samples[worst]) > (states[largest[0]], -states[largest[1]]):
        states[largest] = size[worst], samples[worst]
