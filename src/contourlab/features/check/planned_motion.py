"""Cycle time and extent of a part program of any length, planned part by part."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from contourlab.errors import ContourlabError, ProgramError
from contourlab.features.check.remarks import path_mode_assumed, travel_unknown
from contourlab.findings import Finding, finding
from contourlab.program import Dwell, Move, Program, Reader, Traverse

DEFAULT_MACHINE = "builtin:xyz"
PART = 2_500
"""Moves after which a part ends at the next stop, or at twice as many without one."""


class Part(NamedTuple):
    """Moves and events of a part; whether the stop at its end is an added one."""

    program: Program
    cut: bool


def parts(reader: Reader, problems: list[ProgramError]) -> Iterator[Part]:
    """Yield a program in parts that end where the motion stops, or at `2 * PART` moves; a fatal fault goes to `problems`."""
    moves: list[Move] = []
    first = 0
    try:
        for move in reader.moves():
            if len(moves) >= PART:
                stops = _stops(moves[-1], move)
                if stops or len(moves) >= 2 * PART:
                    yield _part(reader, moves, first, cut=not stops)
                    first, moves = first + len(moves), []
            moves.append(move)
    except ProgramError as error:
        problems.append(error)
    yield _part(reader, moves, first, cut=False)


def _stops(before: Move, after: Move) -> bool:
    """Return whether the motion certainly stops between two moves."""
    if isinstance(before, Dwell):
        return True
    if isinstance(after, Dwell):  # it belongs to the motion before it
        return False
    return before.mode.control == "exact_stop" or isinstance(before, Traverse) != isinstance(after, Traverse)


def _part(reader: Reader, moves: list[Move], first: int, *, cut: bool) -> Part:
    """Take moves and their events out of a reader; the moves before it are `first`."""
    events = reader.state.events
    mine = tuple(replace(event, after=event.after - first) for event in events)
    events.clear()
    return Part(Program(Path(reader.name).name, tuple(moves), (), mine), cut)


class PlannedMotion:
    """Lengths, extent and times of the motion on a machine, summed over the parts of a program.

    Parameters
    ----------
    machine : str or Path, optional
        As for `contourlab.check`.
    """

    def __init__(self, machine: str | Path | None) -> None:
        self._chosen = machine
        self.problems: list[ContourlabError] = []
        self._sums = np.zeros(5)  # feed and rapid length, cycle time, dwells, time of the feed moves at their feedrates
        self._stops = 0
        self._machine: Any = None
        self._assumed: dict[str, Finding] = {}

    def add(self, part: Part) -> None:
        """Plan a part; after a fault nothing more is planned."""
        if self.problems:
            return
        if all(isinstance(move, Dwell) for move in part.program.moves):
            self._sums[2:4] += sum(move.seconds for move in part.program.moves if isinstance(move, Dwell))
            return
        self._load()
        try:
            self._plan(part.program)
        except ContourlabError as error:
            self.problems.append(error)
        self._stops += part.cut

    def _load(self) -> None:
        from contourlab.scenario import load_machine
        from contourlab.scenario.load import named_file
        from contourlab.scenario.placing import TravelCheck

        if self._machine is None:
            self._file = DEFAULT_MACHINE if self._chosen is None else named_file(self._chosen)
            self._machine = load_machine(self._file)
            self._travel = TravelCheck(self._machine)

    def _plan(self, program: Program) -> None:
        from contourlab.feed import blended
        from contourlab.feed.planner import plan_profile
        from contourlab.geometry.path import boxes
        from contourlab.scenario.values import DEFAULT_CORNER_TOLERANCE, program_route

        route = program_route(program, self._machine.axis_names)
        low, high = boxes(route.path)
        limits = self._machine.planner_limits()
        cycle_time = plan_profile(blended(route, limits), limits).duration
        self._assumed = {found.code: found for found in path_mode_assumed(program.moves, DEFAULT_CORNER_TOLERANCE)} | self._assumed
        self._travel.add(low, high, ~route.rapid, route.source_line)
        lengths, feed = np.diff(route.path.breaks), ~route.rapid
        dwell = float(route.dwell.sum()) + route.dwell_before
        at_feedrate = (lengths[feed] / route.feedrate[feed]).sum()
        self._sums += [lengths[feed].sum(), lengths[~feed].sum(), cycle_time, dwell, at_feedrate]

    @property
    def complete(self) -> bool:
        """Whether something moves, and all of it has been planned."""
        return self._machine is not None and not self.problems

    def results(self) -> dict[str, Any]:
        """Return the fields of `Checked` that describe the motion."""
        feed, rapid, cycle_time, dwell, at_feedrate = self._sums.tolist()
        extent = zip(self._travel.low.tolist(), self._travel.high.tolist(), strict=True)
        return {
            "findings": (*self._outside(), *self._assumed.values()),
            "length": {"feed": feed, "rapid": rapid},
            "box": dict(zip(self._machine.axis_names, extent, strict=True)),
            "cycle_time": cycle_time,
            "dwell": dwell,
            "feed_time_without_acceleration": at_feedrate,
            "machine": {"name": self._machine.name, "file": str(self._file)},
            "added_stops": self._stops,
        }

    def _outside(self) -> Iterator[Finding]:
        """Yield a finding for each axis that leaves the machine's travel, and one if a travel is unknown."""
        travel, machine = self._travel, self._machine
        for name, line in travel.left.items():
            j, limits = machine.axis_names.index(name), machine.axis(name).limits
            values = {"line": line, "machine": machine.name}
            if math.isfinite(limits.extent):
                yield finding("CL478", f"axis {name}", length=travel.cut_high[j] - travel.cut_low[j], travel=limits.extent, **values)
                continue
            values |= dict(zip(("low", "high", "start", "stop"), (travel.low[j], travel.high[j], *limits.ends), strict=True))
            yield finding("CL471" if self._chosen is None else "CL470", f"axis {name}", **values)
        yield from travel_unknown(machine)
