"""Nodes that judge and watch a run without acting on it, their figures, and the exact judge of doubtful samples."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.engine.runner import Group
from contourlab.engine.step import Late, Node, Schedule, Step, ports
from contourlab.engine.translate.graph import Op
from contourlab.engine.translate.tracing import Trace
from contourlab.feed import Reference
from contourlab.geometry import Path
from contourlab.geometry.clearance import clearance
from contourlab.geometry.view import PathView, view_of
from contourlab.loop.builder import accepted_output
from contourlab.loop.machine import Axis, Machine
from contourlab.metrics.judge import MARGIN, planning_deviation, reach
from contourlab.metrics.run_figures import CONTOUR, EFFORT, figures_from
from contourlab.metrics.run_figures import PART as OF_PART
from contourlab.metrics.streaming import EFFORT_SUMS, SUMS, effort_step, judge_step
from contourlab.primitives import fabs, lookup, select
from contourlab.result import Status

JUDGE, PART, PLACE = "judge", "part", "programmed"
LAG = 0.05
"""Time [s] by which a loop usually follows its reference at most: a batch looks for foot points as far as this needs, then further."""


def _counts(reference: Reference) -> Array:
    """Return 1 for each judged sample, else 0."""
    return reference.judged.mask(reference.n_sample).astype(float)


def axis_positions(machine: Machine) -> tuple[str, ...]:
    """Return the signals of the true positions of the axes; where there is a play, they are behind it."""
    return tuple(f"{axis.name}.{'play' if axis.error.backlash else 'plant'}.position" for axis in machine.axes)


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
    blocks = (reference.block(*samples) for samples in reference.blocks())
    planning, place = zip(*(planning_deviation(reference, block.position, block.arc_length) for block in blocks), strict=True)
    return max(float(np.abs(part).max()) for part in planning), np.concatenate(place)


_PLACE_STEP = Step(PLACE, lambda par, x, inp, clock: ((), (lookup(par.place, clock.k),)), tables=("place",), outputs=ports("arc_length"))


def _judge_node(
    machine: Machine, reference: Reference, path: Path, view: PathView, name: str, arc_length: str, foot: float, planning: float = 0.0
) -> Node:
    position = tuple(map(Late, axis_positions(machine)))
    wires: dict[str, Any] = {"position": position, "reference": "in.reference", "arc_length": arc_length}
    parameters, cells = room_for(path, min(most_error(machine), LAG * reference.largest_feedrate + MARGIN), planning)
    # Finer arcs bring the figures within 1 pm or 1e-6 of the exact judge's; halved pieces of other curves are closer than their bound.
    view = view_of(path, arcs=0.01) if any(np.any(batch.sixth) for batch, _ in path.kinds if batch.sixth is not None) else view
    step = judge_step(view, len(machine.axes), bool(path.corners.size) or not path.closed)
    tables = {**view.tables, **cells, "counts": _counts(reference)}
    return Node(name, step, wires, {**view.parameters, **parameters}, tables, {"foot": foot})


def most_error(machine: Machine) -> float:
    """Return the largest tracking error [m] of a machine that has not failed."""
    return math.hypot(*(axis.limits.following_error for axis in machine.axes))


def room_for(path: Path, error: float, planning: float) -> tuple[dict[str, float], dict[str, Array]]:
    """Return parameters and tables of a judge for runs whose largest tracking error [m] does not exceed `error`."""
    window = min(reach(path, min(error, path.length)) + planning, path.length)
    numbers, cells = clearance(path, 2.0 * window)
    return {"error": error, "planning": planning, "window": window, "doubtful": 0.0, **numbers}, cells


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
    limit = columns.get(f"axes.{axis.name}.drive.limit", getattr(axis.drive, "limit", math.inf))
    return np.where(np.isfinite(limit), 1.0 / limit, 1.0)


def sums_of(groups: list[Group], node: str, n: int) -> Array:
    """Return the states of a judging node in all lanes: (n_state, n)."""
    return np.concatenate([group.state_of(node) for group in groups], axis=1)[:, :n]


def error_figures(sums: Array, failed: Index, period: float, source: str = CONTOUR) -> dict[str, Array]:
    """Return the figures of a source from its node's states in all lanes (n_state, n); NaN for a lane that failed."""
    figures = figures_from(source, dict(zip(EFFORT_SUMS if source == EFFORT else ("foot", *SUMS), sums, strict=True)), period)
    return {name: np.where(failed < 0, values, np.nan) for name, values in figures.items()}


def traced_figures(states: Mapping[str, int], period: float) -> tuple[Trace, dict[str, Op]]:
    """Return how the figures, and the count of samples in doubt, follow from the states of the judging nodes, by the row of the first."""
    trace = Trace()

    def sums(node: str, names: Sequence[str]) -> dict[str, Any]:
        return {name: trace.leaf(states[node] + i, 1.0) for i, name in enumerate(names)}

    contour, part = (sums(node, ("foot", *SUMS)) for node in (JUDGE, PART if PART in states else JUDGE))
    made = {"unsure": contour["unsure"] + part["unsure"] if PART in states else contour["unsure"]}
    for source, of in ((CONTOUR, contour), (OF_PART, part), (EFFORT, sums("effort", EFFORT_SUMS))):
        made |= figures_from(source, of, period)
    return trace, {name: value.op for name, value in made.items()}


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


CUT = 1 << 12
"""Ticks after which doubtful samples are judged."""
MOST_WAITING = 512
"""Samples of a variant that may wait for the end of the run."""
_ROW = {name: 1 + i for i, name in enumerate(SUMS)}
UNSURE = _ROW["unsure"]
"""State of a judge that counts its doubtful samples."""


def _judged_paths(reference: Reference) -> dict[str, Path]:
    """Return the path of each judge."""
    return {JUDGE: reference.path, PART: reference.programmed}


class DoubtfulSamples:
    """The exact judge of a group's doubtful samples, while the group runs.

    The window of a foot point grows with the largest tracking error of the whole run, which is not known yet. A foot point in a large
    window is final if it lies in the window for the error so far, and the window of the whole run is not larger. Two large windows are
    tried: that of the node, and twice the window so far. The few samples that find no final foot point wait for the end of the run.

    Parameters
    ----------
    group : Group
    positions : sequence of str
        Signals of the axes' true positions.
    reference : Reference
    reach : mapping of str to ndarray (n_lane,) [m^2], optional
        The largest squared tracking error of each lane, by judge, if an earlier run has told it.

    Attributes
    ----------
    rows : list of int
        Signals that `take` needs.
    left_over : ndarray (n_lane,) of bool
        After `end`: lanes to run again with a wider window, since their error has grown too much or too many samples wait.
    """

    def __init__(self, group: Group, positions: Sequence[str], reference: Reference, reach: Mapping[str, Array] | None = None) -> None:
        paths, schedule = _judged_paths(reference), group.schedule
        self._nodes = {node.name: node for node in schedule.nodes if node.name in (*paths, PLACE)}
        self._paths = {name: path for name, path in paths.items() if name in self._nodes}
        self.rows = [schedule.row(signal) for signal in (*positions, *(f"{name}.doubt" for name in self._paths))]
        self._group, self._n_axis, self._reach, self._n = group, len(positions), reach, len(np.atleast_1d(np.asarray(group.lanes)))
        self.left_over: Flags = np.zeros(self._n, dtype=np.bool_)
        self._most = {name: np.full(self._n, np.inf) for name in self._paths}  # the largest window of the whole run that all samples allow
        self._unsure = dict.fromkeys(self._paths, 0.0)  # doubtful samples of all lanes so far
        self._waiting: dict[str, list[tuple[Index, Index, Array, Array]]] = {name: [] for name in self._paths}

    def _window(self, name: str) -> Array:
        """Return the window [m] of each lane for its largest tracking error so far, and note the lanes that need a wider node."""
        node = self._nodes[name]
        square = self._group.state_of(name)[-1, : self._n] if self._reach is None else self._reach[name]
        self.left_over |= square > node.parameters["error"] ** 2
        return np.array([reach(self._paths[name], math.sqrt(one)) for one in square]) + node.parameters["planning"]

    def take(self, log: Array, k: int, arc_length: Array) -> None:
        """Judge the doubtful samples from tick k on.

        Parameters
        ----------
        log : ndarray (n_tick, n_row, width)
            Of `rows`.
        arc_length : ndarray (n_tick,) [m]
            Of the reference.
        """
        ticks, lanes = slice(k, k + len(log)), slice(self._n)
        running = self._group.state_of(WATCH)[0, lanes] < 0.0
        for j, (name, path) in enumerate(self._paths.items(), self._n_axis):
            node, unsure = self._nodes[name], float(self._group.state_of(name)[UNSURE, lanes].sum())
            if unsure == self._unsure[name]:
                continue
            self._unsure[name] = unsure
            counted = (node.tables["counts"][ticks, None] * log[:, j, lanes] > 0.0) & running
            window = self._window(name)
            tick, lane = np.nonzero(counted & ~self.left_over)
            around = (self._nodes[PLACE].tables["place"][ticks] if name == PART else arc_length)[tick]
            points = log[tick, : self._n_axis, lane]
            for large in (np.full(self._n, node.parameters["window"]), 2.0 * window) if self._reach is None else (window,):
                if not tick.size:
                    break
                feet = path.foot_point(points, around, large[lane])
                # A foot point at the end of the window lies beyond it by rounding: where the window is known, all are final.
                final = (np.abs(feet.arc_length - around) <= window[lane]) | (self._reach is not None)
                self._add(name, (feet.signed if path.is_planar else feet.distance)[final], k + tick[final], lane[final])
                np.minimum.at(self._most[name], lane[final], large[lane[final]])
                tick, lane, around, points = tick[~final], lane[~final], around[~final], points[~final]
            if tick.size:
                self._waiting[name].append((k + tick, lane, around, points))
                count = sum(np.bincount(lanes, minlength=self._n) for _, lanes, *_ in self._waiting[name])
                self.left_over |= count > MOST_WAITING

    def end(self) -> None:
        """Judge the samples that wait for the end of the run."""
        for name, path in self._paths.items():
            window = self._window(name)
            self.left_over |= window > self._most[name]
            kept = ~self.left_over & (self._group.state_of(WATCH)[0, : self._n] < 0.0)
            for tick, lane, around, points in self._waiting[name]:
                own = kept[lane]
                if own.any():
                    feet = path.foot_point(points[own], around[own], window[lane[own]])
                    self._add(name, feet.signed if path.is_planar else feet.distance, tick[own], lane[own])

    def _add(self, name: str, error: Array, tick: Index, lane: Index) -> None:
        """Add exact errors (n,) to the states of a judge, in the order of the ticks."""
        states, n, size = self._group.state_of(name), self._n, np.abs(error)
        for sum_name, values in (("sum_magnitude", size), ("sum_square", size**2), ("sum_signed", error)):
            states[_ROW[sum_name], :n] += np.bincount(lane, values, n)
        largest, at = states[_ROW["largest"], :n], states[_ROW["largest_at"], :n]
        order = np.lexsort((tick, -size, lane))
        first = order[np.flatnonzero(np.diff(lane[order], prepend=-1))]
        of = lane[first]
        ahead = (size[first] > largest[of]) | ((size[first] == largest[of]) & (tick[first] < at[of]))
        largest[of[ahead]], at[of[ahead]] = size[first[ahead]], tick[first[ahead]]


def all_judged(schedule: Schedule) -> Schedule:
    """Return a schedule whose judges decide all samples themselves, those in doubt too."""
    summed = {"doubtful": 1.0}
    nodes = (replace(node, parameters={**node.parameters, **summed}) if node.name in (JUDGE, PART) else node for node in schedule.nodes)
    return replace(schedule, nodes=tuple(nodes))


def wider(schedule: Schedule, machine: Machine, reference: Reference) -> Schedule:
    """Return a schedule whose judges look for foot points as far as any variant that has not failed may need."""
    paths, nodes = _judged_paths(reference), []
    for node in schedule.nodes:
        if node.name in paths:
            numbers, cells = room_for(paths[node.name], most_error(machine), float(node.parameters["planning"]))
            wide: dict[str, Any] = {"parameters": {**node.parameters, **numbers}, "tables": {**node.tables, **cells}}
            node = replace(node, **wide)
        nodes.append(node)
    return replace(schedule, nodes=tuple(nodes))
