"""Nodes that judge and watch a run without acting on it, their figures, and the exact judge of doubtful samples."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache, partial
from itertools import product
from typing import Any

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.engine.runner import Group, groups_of
from contourlab.engine.step import Late, Node, Schedule, Step, ports
from contourlab.feed import Reference
from contourlab.geometry import Path
from contourlab.geometry.clearance import clearance
from contourlab.geometry.view import PathView, view_of
from contourlab.loop.builder import accepted_output
from contourlab.loop.feeding import BLOCK, Feed
from contourlab.loop.machine import Axis, Machine
from contourlab.metrics.judge import MARGIN, planning_deviation, reach
from contourlab.metrics.run_figures import CONTOUR, EFFORT, figures_from
from contourlab.metrics.streaming import EFFORT_SUMS, SUMS, effort_step, judge_step
from contourlab.primitives import fabs, lookup, select
from contourlab.result import Status
from contourlab.threads import in_threads

JUDGE, PART, PLACE = "judge", "part", "programmed"
LAG = 0.05
"""Time [s] by which a loop usually follows its reference at most: a batch looks for foot points as far as this needs, then further."""


def _counts(reference: Reference) -> Array:
    """Return 1 for each judged sample, else 0."""
    return reference.judged.mask(reference.n_sample).astype(float)


def judge_node(machine: Machine, reference: Reference, view: PathView) -> Node:
    """Return the node that computes the contour error of each lane."""
    return _judge_node(machine, reference, reference.path, view, JUDGE, "in.arc_length", float(reference.block(0, 1).arc_length[0]))


def part_nodes(machine: Machine, reference: Reference) -> tuple[Node, Node]:
    """Return the nodes that compute the part error of each lane: the place on the programmed path, and its judge."""
    planning, place = _planned(reference)
    path, arc_length = reference.programmed, f"{PLACE}.arc_length"
    judge = _judge_node(machine, reference, path, view_of(path), PART, arc_length, place[0], planning)
    return Node(PLACE, _PLACE_STEP, {}, {}, {"place": place}), judge


@lru_cache(maxsize=4)
def _planned(reference: Reference) -> tuple[float, Array]:
    """Return the largest planning deviation [m], and the place (n_sample,) [m] of the reference on the programmed path."""
    blocks = (reference.block(*samples) for samples in reference.blocks(BLOCK))
    planning, place = zip(*(planning_deviation(reference, block.position, block.arc_length) for block in blocks), strict=True)
    return max(float(np.abs(part).max()) for part in planning), np.concatenate(place)


_PLACE_STEP = Step(PLACE, lambda par, x, inp, clock: ((), (lookup(par.place, clock.k),)), tables=("place",), outputs=ports("arc_length"))


def _judge_node(
    machine: Machine, reference: Reference, path: Path, view: PathView, name: str, arc_length: str, foot: float, planning: float = 0.0
) -> Node:
    n = len(machine.axes)
    position = tuple(Late(f"{axis.name}.plant.position") for axis in machine.axes)
    wires: dict[str, Any] = {"position": position, "reference": "in.reference", "arc_length": arc_length}
    parameters, cells = room_for(path, min(most_error(machine), LAG * reference.largest_feedrate + MARGIN), planning)
    step = judge_step(view, n, bool(path.corners.size) or not path.closed)
    tables = {**view.tables, **cells, "counts": _counts(reference)}
    return Node(name, step, wires, {**view.parameters, **parameters}, tables, {"foot": foot})


def most_error(machine: Machine) -> float:
    """Return the largest tracking error [m] of a machine that has not failed."""
    return math.hypot(*(axis.limits.following_error for axis in machine.axes))


def room_for(path: Path, error: float, planning: float) -> tuple[dict[str, float], dict[str, Array]]:
    """Return parameters and tables of a judge for runs whose largest tracking error [m] does not exceed `error`."""
    window = min(reach(path, min(error, path.length)) + planning, path.length)
    numbers, cells = clearance(path, 2.0 * window)
    return {"error": error, "planning": planning, "window": window, **numbers}, cells


def effort_node(machine: Machine, reference: Reference, commands: Sequence[str], columns: Mapping[str, Array]) -> Node:
    """Return the node that sums up the commands of each lane; `commands` are the signals at the drives, one for each axis."""
    rates = {f"rate_{i}": _rate(axis, columns) for i, axis in enumerate(machine.axes)}
    wires: dict[str, Any] = {
        "command": tuple(commands),
        "accepted": tuple(f"{axis.name}.drive.{accepted_output(axis.drive)}" for axis in machine.axes),
    }
    return Node("effort", effort_step(len(machine.axes)), wires, rates, {"counts": _counts(reference)})


def _rate(axis: Axis, columns: Mapping[str, Array]) -> float | Array:
    """Return one over the limit of a drive, an array if it differs between variants; 1 without a limit."""
    limit = np.asarray(columns.get(f"axes.{axis.name}.drive.limit", getattr(axis.drive, "limit", math.inf)))
    rate = np.where(np.isfinite(limit), 1.0 / limit, 1.0)
    return rate if rate.ndim else float(rate)


def sums_of(groups: list[Group], node: str, n: int) -> Array:
    """Return the states of a judging node in all lanes: (n_state, n)."""
    return np.concatenate([group.state_of(node) for group in groups], axis=1)[:, :n]


def error_figures(sums: Array, failed: Index, period: float, source: str = CONTOUR) -> dict[str, Array]:
    """Return the figures of a source from its node's states in all lanes (n_state, n); NaN for a lane that failed."""
    figures = figures_from(source, dict(zip(EFFORT_SUMS if source == EFFORT else ("foot", *SUMS), sums, strict=True)), period)
    return {name: np.where(failed < 0, values, np.nan) for name, values in figures.items()}


WATCH = "watch"


def _watch(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    first, axis, largest = x
    for i in range(len(par)):
        gap = fabs(inp.reference[i] - inp.position[i])
        # A number that is not finite fails both comparisons.
        sound = select(gap <= par[i], select(inp.command[i] - inp.command[i] == 0.0, 1.0, 0.0), 0.0)
        fresh = select(first < 0.0, 1.0 - sound, 0.0) > 0.5
        first, axis, largest = select(fresh, clock.k, first), select(fresh, float(i), axis), select(fresh, gap, largest)
    return (first, axis, largest), ()


def watch_node(machine: Machine, commands: tuple[str, ...]) -> Node:
    """Return the node that watches a machine and its commands, placed after the drives.

    It records the first sample at which an axis leaves its following-error limit or a command is not finite: exactly in every lane, and
    without keeping a signal.
    """
    wires: dict[str, Any] = {
        "reference": "in.reference",
        "position": tuple(Late(f"{name}.plant.position") for name in machine.axis_names),
        "command": commands,
    }
    limits = {f"limit_{i}": axis.limits.following_error for i, axis in enumerate(machine.axes)}
    inputs = ports("reference", "position", "command", size=len(limits))
    step = Step(WATCH, _watch, tuple(limits), (), "", ports("first", "axis", "gap"), inputs, ())
    return Node(WATCH, step, wires, limits, initial={"first": -1.0, "axis": -1.0})


def watched(group: Group, machine: Machine, lane: int = 0) -> Status:
    """Return the failure that the watch recorded in one lane."""
    first, axis, gap = (float(value) for value in group.state_of(WATCH)[:, lane])
    if first < 0.0:
        return Status(ok=True)
    limit = machine.axes[int(axis)].limits.following_error
    reason = "the loop produced a value that is not finite"
    if limit < gap < float("inf"):
        reason = f"following error {gap * 1e3:.4g} mm exceeds the limit of {limit * 1e3:.4g} mm"
    return Status(ok=False, sample=int(first), axis=machine.axis_names[int(axis)], reason=reason)


def all_finite(group: Group, sample: int) -> Status:
    """Return the failure of a group with a signal or state that is not finite after a sample."""
    if group.finite().all():
        return Status(ok=True)
    node = group.first_bad_node()
    return Status(ok=False, sample=sample, axis=node.split(".")[0], reason=f"{node} produced a value that is not finite")


_AT_ONCE = 1 << 13
"""Samples of a lane that are judged exactly at once."""
_ROW = {name: 1 + i for i, name in enumerate(SUMS)}


def judge_doubtful(
    schedule: Schedule,
    positions: Sequence[str],
    machine: Machine,
    feed: Feed,
    sums: Mapping[str, Array],
    failed: Index,
    jit: bool,
    threads: int,
) -> Array:
    """Run all variants with doubtful samples again, unless they failed, and judge these samples exactly.

    Parameters
    ----------
    schedule : Schedule
        With the judges.
    positions : sequence of str
        Signals of the axes' true positions.
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
    rows = [schedule.row(signal) for signal in (*positions, *(f"{name}.doubt" for name in sums))]
    paths = {JUDGE: reference.path, PART: reference.programmed}
    nodes = {node.name: node for node in schedule.nodes}
    for name in sums:
        numbers, cells = room_for(paths[name], most_error(machine), float(nodes[name].parameters["planning"]))
        wide: dict[str, Any] = {"parameters": {**nodes[name].parameters, **numbers}, "tables": {**nodes[name].tables, **cells}}
        nodes[name] = replace(nodes[name], **wide)
    schedule = replace(schedule, nodes=tuple(nodes.values()))
    groups = groups_of(schedule, doubtful, jit)

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

    for first, stop in reference.blocks(BLOCK):
        asked, external = feed.block(first, stop)
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
