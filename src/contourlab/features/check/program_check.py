"""``contourlab check``: faults, extent, feeds and cycle time of a part program, without simulating it."""

from __future__ import annotations

import math
from collections import Counter, deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np

from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.errors import ContourlabError, ProgramError
from contourlab.features.check.options import Check
from contourlab.features.check.reading import DEFAULT_MACHINE, machine_for, of_control, read_once, reading_of
from contourlab.findings import Finding, finding
from contourlab.program import Arc, Dwell, Feed, Move, Point, Program, Reader, Reading, Spline, Traverse, open_program
from contourlab.program.dialects import DIALECTS, named_in
from contourlab.program.reader import NO_END
from contourlab.rendering.table import paragraphs

if TYPE_CHECKING:
    from contourlab.feed import Route
    from contourlab.loop import Machine

PART = 2_500
"""Moves after which a part ends at the next stop, or at twice as many without one."""
FAULTY = 2
HEAD = 1 << 16
"""Characters in which a program names its dialect."""
NOT_PLANNED = "CL819"
"""Code of a fault that only planning finds."""
MOST_FEEDS = 12
"""Largest number of feedrates to print one by one."""
_KINDS = {Traverse: "traverse", Feed: "feed", Arc: "arc", Spline: "spline", Dwell: "dwell"}


@dataclass(frozen=True)
class Message:
    """A fault, or a notice of the reader; line and column are 0 if unknown. A fault has a code, for ``contourlab explain``."""

    message: str
    line: int = 0
    column: int = 0
    file: str = ""
    code: str = ""

    @classmethod
    def of(cls, fault: Any, code: str = "") -> Message:
        """Return what an error or a notice says; `code` is that of a fault without its own."""
        message, file = getattr(fault, "message", str(fault)), str(getattr(fault, "file", ""))
        return cls(message, getattr(fault, "line", 0), getattr(fault, "column", 0), file, getattr(fault, "code", "") or code)

    def text(self, program: str, note: str = "") -> str:
        """Return ``file:line:column: message [code]``."""
        place = "".join(f"{number}:" for number in (self.line, self.column) if self.line and number)
        return f"{self.file or program}:{place} {note}{self.message}" + (f" [{self.code}]" if self.code else "")


@dataclass(frozen=True)
class Refused:
    """Bad input: what any command prints with ``--json``, with exit code 2.

    Attributes
    ----------
    problems : tuple of Message
    """

    problems: tuple[Message, ...]


@dataclass(frozen=True)
class Checked(Answer):
    """The result of a check; as JSON field by field.

    Attributes
    ----------
    problems, notices : tuple of Message
        Faults, and places where the reader was lenient.
    moves : dict of str to int
        Number of moves by kind.
    proposed_dialect : str
        Dialect in which the program has fewer faults, or that it names; empty if it is that in which it was read, or none.
    length : dict of str to float [m]
        Length of feed and rapid moves. Without moves, or with a fault, this and all below is empty or None.
    box : dict of str to (float, float) [m]
        Extent by axis.
    cycle_time, dwell, feed_time_without_acceleration : float [s]
    machine : dict of str to object
        Name and file; of a control's own file also the control, as ``source``, and the ``origin`` of each number.
    added_stops : int
        Stops that only the check makes, because it plans long programs in parts.
    """

    program: str
    problems: tuple[Message, ...]
    notices: tuple[Message, ...]
    n_line: int
    moves: dict[str, int]
    feeds_mm_per_min: tuple[float, ...]
    spindle_speeds: tuple[float, ...]
    tools: tuple[int, ...]
    findings: tuple[Finding, ...] = ()
    proposed_dialect: str = ""
    length: dict[str, float] = field(default_factory=dict)
    box: dict[str, tuple[float, float]] = field(default_factory=dict)
    cycle_time: float | None = None
    dwell: float | None = None
    feed_time_without_acceleration: float | None = None
    machine: dict[str, Any] = field(default_factory=dict)
    added_stops: int = 0

    @property
    def exit_code(self) -> int:
        """Exit code of the command: 2 for a faulty program."""
        return FAULTY if self.faults else 0

    @property
    def rows(self) -> list[dict[str, Any]]:
        """Faults and notices, one a row."""
        return [{"fault": kind, **vars(one)} for kind, many in ((True, self.problems), (False, self.notices)) for one in many]

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Check in the dialect that the program seems to have, or run it, if how each axis answers is known."""
        if self.proposed_dialect:
            return ["check", *asked.inputs, "--dialect", self.proposed_dialect, *asked.settings.words("dialect")]
        if self.faults or any(found.code == "CL988" for found in self.findings):
            return None
        machine, has_end = asked.settings.machine or "xyz", not any(notice.message.startswith(NO_END) for notice in self.notices)
        shipped = machine in ("xyz", "builtin:xyz")
        if not shipped and not (isinstance(machine, str | Path) and (Path(machine).is_dir() or of_control(machine))):
            return None  # which controller it has is not known
        parts = ["--machine", machine, "--controller", "xyz-controller" if shipped else None]
        return ["run", *asked.inputs, *parts, *asked.settings.words("machine"), *([] if has_end else ["--no-require-end"])]

    @property
    def faults(self) -> int:
        """Number of faults."""
        return len(self.problems) + sum(found.entry.severity == "error" for found in self.findings)

    @property
    def text(self) -> str:
        """Return the result for the terminal."""
        lines = [fault.text(self.program) for fault in self.problems] + [notice.text(self.program, "note: ") for notice in self.notices]
        lines += [paragraphs(map(str, self.findings))] if self.findings else []
        lines.append(f"{self.faults} fault{'s' * (self.faults > 1)}" if self.faults else "no fault in the program")
        return "\n".join([*lines, paragraphs([f"{name:<12}{value}" for name, value in self._rows()], indent=" " * 12)])

    def _rows(self) -> Iterator[tuple[str, str]]:
        yield "lines", f"{self.n_line}"
        yield "moves", ", ".join(f"{n} {kind}" for kind, n in self.moves.items()) or "none"
        for name, (low, high) in self.box.items():
            yield f"box {name}", f"{low * 1e3:.6g} .. {high * 1e3:.6g} mm ({(high - low) * 1e3:.6g} mm)"
        if self.cycle_time is not None and self.feed_time_without_acceleration is not None:
            yield "path", f"{self.length['feed'] * 1e3:.6g} mm feed, {self.length['rapid'] * 1e3:.6g} mm rapid"
            ideal = _duration(self.feed_time_without_acceleration)
            detail = f"dwells {self.dwell:.3g} s; feed moves without acceleration {ideal}"
            detail += f"; planned in parts, with {self.added_stops} added stops" if self.added_stops else ""
            yield "cycle time", f"{_duration(self.cycle_time)} on {self.machine['name']} ({detail})"
        feeds = self.feeds_mm_per_min
        shown = [f"{feed:g}" for feed in feeds] if len(feeds) <= MOST_FEEDS else [f"{len(feeds)} from {feeds[0]:g} to {feeds[-1]:g}"]
        yield "feeds", (", ".join(shown) + " mm/min") if feeds else "none"
        if self.spindle_speeds:
            yield "spindle", ", ".join(f"{speed:g}" for speed in self.spindle_speeds) + " rpm"
        if self.tools:
            yield "tools", ", ".join(f"T{tool}" for tool in self.tools)


@question(Check)
def check(file: str | Path, *, settings: Check, session: Session = QUIET) -> Checked:
    """Read a part program to its end and collect its faults; compute its box, its feeds, and its cycle time on a machine.

    Parameters
    ----------
    file : str or Path
        A part program; it needs no end word.

    Returns
    -------
    Checked

    Raises
    ------
    ProgramError
        If the file cannot be read.
    ScenarioError
        If the machine cannot be read.
    """
    problems: list[ProgramError] = []
    seen, motion, stages = _Seen(), PlannedMotion(file, settings), session.stages()
    with open_program(file, motion.reading, problems=problems) as reader:
        stages.begin(f"reading {Path(file).name}")
        for part in parts(reader, problems):
            seen.add(part.program)
            if not problems:  # the motion of a faulty program means nothing, and may be endless
                motion.add(part)
            stages.begin(f"{sum(seen.moves.values())} moves of {Path(file).name}")
        motion.machine_points = reader.state.machine_points
        notices, n_line = reader.notices, reader.count_lines()
    checked = Checked(
        program=str(file),
        problems=tuple(Message.of(fault, NOT_PLANNED) for fault in (*problems, *motion.problems)),
        notices=tuple(map(Message.of, notices)),
        n_line=n_line,
        moves=dict(seen.moves),
        feeds_mm_per_min=tuple(sorted(seen.feeds)),
        spindle_speeds=tuple(sorted(seen.speeds)),
        tools=tuple(seen.tools),
        findings=tuple(about_reading(motion.reading)),
        proposed_dialect=proposed_dialect(file, motion.reading, len(problems)),
    )
    return replace(checked, **motion.results()) if motion.complete and not problems else checked


class _Seen:
    """Moves, feeds [mm/min], spindle speeds and tools of a program, without repetition."""

    def __init__(self) -> None:
        self.moves: Counter[str] = Counter()
        self.feeds: set[float] = set()
        self.speeds: set[float] = set()
        self.tools: dict[int, None] = {}
        self._selected = 0.0

    def add(self, program: Program) -> None:
        """Add a part of the program."""
        self.moves.update(_KINDS[type(move)] for move in program.moves)
        self.feeds |= {round(6e4 * m.feedrate, 6) for m in program.moves if not isinstance(m, Traverse | Dwell)}
        for event in program.events:
            value = event.value or 0.0
            if event.word == "S":
                self.speeds.add(value)
            elif event.word == "T":
                self._selected = value
            elif event.word in ("M6", "M61"):
                self.tools[int(value if event.word == "M61" and event.value is not None else self._selected)] = None


def _duration(seconds: float) -> str:
    """Write a time in hours, minutes and seconds.

    >>> _duration(4.25), _duration(3725.0)
    ('4.25 s', '1 h 2 min 5 s')
    """
    if seconds < 60.0:
        return f"{seconds:.4g} s"
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return (f"{hours} h " if hours else "") + f"{minutes} min {rest} s"


# --- cycle time and extent of a program of any length, planned part by part ---


class Part(NamedTuple):
    """Moves and events of a part; whether the stop at its end is an added one."""

    program: Program
    cut: bool


def parts(reader: Reader, problems: list[ProgramError]) -> Iterator[Part]:
    """Yield a program in parts that end where the motion stops, or at `2 * PART` moves; a fatal fault goes to `problems`."""
    moves: list[Move] = []
    first = 0

    def part(cut: bool) -> Part:
        events = tuple(replace(event, after=event.after - first) for event in reader.state.events)
        reader.state.events.clear()
        return Part(Program(Path(reader.name).name, tuple(moves), (), events), cut)

    try:
        for move in reader.moves():
            if len(moves) >= PART:
                stops = _stops(moves[-1], move)
                if stops or len(moves) >= 2 * PART:
                    yield part(not stops)
                    first, moves = first + len(moves), []
            moves.append(move)
    except ProgramError as error:
        problems.append(error)
    yield part(False)


def _stops(before: Move, after: Move) -> bool:
    """Return whether the motion certainly stops between two moves."""
    if isinstance(before, Dwell):
        return True
    if isinstance(after, Dwell):  # it belongs to the motion before it
        return False
    return before.mode.control == "exact_stop" or isinstance(before, Traverse) != isinstance(after, Traverse)


class PlannedMotion:
    """Lengths, extent and times of the motion on a machine, summed over the parts of a program.

    Parameters
    ----------
    file : str or Path
        The part program.
    settings : Check

    Attributes
    ----------
    reading : Reading
        How the program is read; the file of a control says that, too.
    """

    def __init__(self, file: str | Path, settings: Check) -> None:
        self._given: str | Path | Machine | None = settings.machine
        self._settings = read_once(settings)
        self.reading = reading_of(file, self._settings)
        self.machine_points: list[tuple[int, Point]] = []
        self.problems: list[ContourlabError] = []
        self._sums = np.zeros(5)  # feed and rapid length, cycle time, dwells, time of the feed moves at their feedrates
        self._stops = 0

    @cached_property
    def machine(self) -> Machine:
        """The machine; read when something moves."""
        return machine_for(self._settings, self.reading)

    @cached_property
    def remarks(self) -> Remarks:
        """The findings on this program and machine."""
        return Remarks(self.machine, self.reading, named=self._given is not None)

    def add(self, part: Part) -> None:
        """Plan a part; after a fault nothing more is planned."""
        if self.problems:
            return
        if all(isinstance(move, Dwell) for move in part.program.moves):
            self._sums[2:4] += sum(move.seconds for move in part.program.moves if isinstance(move, Dwell))
            return
        machine = self.machine
        try:
            self._plan(part.program, machine)
        except ContourlabError as error:
            self.problems.append(error)
        self._stops += part.cut

    def _plan(self, program: Program, machine: Machine) -> None:
        from contourlab.feed import blended
        from contourlab.feed.planner import plan_profile
        from contourlab.scenario.values import program_route

        limits = machine.planner_limits()
        route = program_route(program, machine.axis_names, planner=limits.planner)
        route = route.within(limits.path_velocity)
        cycle_time = plan_profile(blended(route, limits), limits).duration
        self.remarks.add(program, route)
        lengths, feed = np.diff(route.path.breaks), ~route.rapid
        dwell = float(route.dwell.sum()) + route.dwell_before
        at_feedrate = (lengths[feed] / route.feedrate[feed]).sum()
        self._sums += [lengths[feed].sum(), lengths[~feed].sum(), cycle_time, dwell, at_feedrate]

    @property
    def complete(self) -> bool:
        """Whether something moves, and all of it has been planned."""
        return "machine" in vars(self) and not self.problems

    def results(self) -> dict[str, Any]:
        """Return the fields of `Checked` that describe the motion."""
        from contourlab.scenario.load import named_file

        feed, rapid, cycle_time, dwell, at_feedrate = self._sums.tolist()
        extent = zip(self.remarks.travel.low.tolist(), self.remarks.travel.high.tolist(), strict=True)
        given = DEFAULT_MACHINE if self._given is None else self._given
        file = named_file(given) if isinstance(given, str | Path) else ""
        return {
            "findings": tuple(self.remarks.findings(self.machine_points)),
            "length": {"feed": feed, "rapid": rapid},
            "box": dict(zip(self.machine.axis_names, extent, strict=True)),
            "cycle_time": cycle_time,
            "dwell": dwell,
            "feed_time_without_acceleration": at_feedrate,
            "machine": {"name": self.machine.name, "file": file, **origin_of(self.machine)},
            "added_stops": self._stops,
        }


# --- what `limits` and `run` say too about a program on a machine ---

OUTSIDE = ("CL470", "CL478", "CL989")
"""Codes of a travel that is left: faults of the program."""


class Remarks:
    """Where a program, given part by part, leaves the travel of a machine, and what its plan assumes.

    Parameters
    ----------
    machine : Machine
    reading : Reading
        How the program is read.
    named : bool
        Whether somebody named the machine: the travel of another may be left.
    """

    def __init__(self, machine: Machine, reading: Reading, *, named: bool) -> None:
        from contourlab.scenario.placing import TravelCheck

        self.machine, self.reading, self.named = machine, reading, named
        self.travel, self.modes = TravelCheck(machine), PathModes()

    def add(self, program: Program, route: Route) -> None:
        """Add a part of the program, and its path."""
        from contourlab.geometry.path import boxes

        self.travel.add(*boxes(route.path), ~route.rapid, route.source_line)
        self.modes.add(program.moves)

    def findings(self, machine_points: Sequence[tuple[int, Point]]) -> Iterator[Finding]:
        """Yield the findings, once all parts and the points in machine coordinates are known."""
        from contourlab.scenario.placing import beyond_travel
        from contourlab.scenario.values import DEFAULT_CORNER_TOLERANCE

        travel, machine = self.travel, self.machine
        for name, (line, at) in beyond_travel(machine_points, machine.axis_names, machine).items():
            yield finding("CL989", f"axis {name}", line=line, at=at, machine=machine.name)
        for name, line in travel.left.items():
            j, limits = machine.axis_names.index(name), machine.axis(name).limits
            values = {"line": line, "machine": machine.name}
            if math.isfinite(limits.extent):
                yield finding("CL478", f"axis {name}", length=travel.cut_high[j] - travel.cut_low[j], travel=limits.extent, **values)
                continue
            values |= dict(zip(("low", "high", "start", "stop"), (travel.low[j], travel.high[j], *limits.ends), strict=True))
            yield finding("CL470" if self.named else "CL471", f"axis {name}", **values)
        yield from about_machine(machine, self.reading)
        if machine.own_planner is None:
            yield from self.modes.findings(DEFAULT_CORNER_TOLERANCE)


def about_machine(machine: Machine, reading: Reading | None) -> Iterator[Finding]:
    """Yield what its own file says of a machine, which axes have no travel, and whether the zero of a program read so is unknown."""
    from contourlab.scenario.placing import zero_known

    if machine.control:
        yield from machine.control.findings
        free = [axis.name for axis in machine.axes if math.isinf(axis.limits.jerk)]
        bounded = {axis.name: axis.limits.jerk for axis in machine.axes if axis.name not in free}
        if bounded and machine.own_planner is None:
            yield finding("CL990", axes=list(bounded), jerk=min(bounded.values()))
        if free and machine.own_planner is None:
            yield finding("CL991", axes=free, control=machine.control.control)
    yield from about_planner(machine)
    yield from about_reading(reading)
    if unknown := [axis.name for axis in machine.axes if not axis.limits.bounded]:
        yield finding("CL479", axes=unknown, machine=machine.name)
    if reading is not None and not zero_known(machine, reading):
        yield finding("CL985", machine=machine.name)


def about_planner(machine: Machine) -> Iterator[Finding]:
    """Yield how a machine plans, if its planner has no limits of jerk."""
    from contourlab.feed.bounds import Grbl
    from contourlab.loop.machine import GRBL

    own = machine.own_planner
    if isinstance(own, Grbl):
        yield finding("CL995", **{name: getattr(own, name) for name in GRBL})
    elif own is not None:
        yield finding("CL996", cycle=own.cycle, override=own.largest_override)


def about_reading(reading: Reading | None) -> Iterator[Finding]:
    """Yield that a program is read by rules that no control was compared with, if it is."""
    rules = DIALECTS[reading.dialect] if reading is not None else None
    if rules is not None and rules.manual:
        yield finding("CL477", title=rules.title, manual=rules.manual, assumed=rules.assumed)


def proposed_dialect(file: str | Path, reading: Reading, faults: int) -> str:
    """Return the dialect in which a program has fewer faults, or that it names; an empty text if it is that of `reading`, or none.

    Parameters
    ----------
    faults : int
        Number of faults in the dialect of `reading`.
    """
    path = Path(file)
    if reading.dialect != "linuxcnc" or not path.is_file():
        return ""
    with path.open(encoding="latin-1") as text:
        named = named_in(f"{path.name}\n{text.read(HEAD)}")
    best, least = "", faults
    for name in [*named, *(other for other in DIALECTS if faults and other not in named)]:
        problems: list[ProgramError] = []
        with open_program(file, replace(reading, dialect=cast(Any, name)), problems=problems) as reader:
            try:
                deque(reader.moves(), maxlen=0)
            except ProgramError as error:
                problems.append(error)
        if len(problems) < least or (name in named and not best and len(problems) == least):
            best, least = name, len(problems)
    return "" if best == "linuxcnc" else best


_KINDS_OF_ORIGIN = {"control": "read", "computed": "computed", "assumed": "guessed"}


def origin_of(machine: Machine) -> dict[str, Any]:
    """Return the control of a machine and where each number comes from, if it is read from a control's own file."""
    from contourlab.rendering.origins import numbers_of_machine, stated

    if machine.control is None:
        return {}
    kinds = {number.name: _KINDS_OF_ORIGIN.get(number.source, number.source) for number in stated(numbers_of_machine(machine))}
    return {"source": machine.control.control, "origin": kinds}


class PathModes:
    """Lines that are cut without G61 or G64, and those under a G64 without P, as stretches of a motion: code, first and last line."""

    def __init__(self) -> None:
        self._stretches = [("", 0, 0)]

    def add(self, moves: Iterable[Move]) -> None:
        """Add moves, in the order of execution; a jump back begins another stretch."""
        for move in moves:
            if isinstance(move, Dwell | Traverse):
                continue
            unbounded = move.mode.control == "blend" and move.mode.tolerance is None
            code = "CL110" if move.mode.control is None else "CL111" if unbounded else ""
            before, first, last = self._stretches[-1]
            if code == before and move.source_line >= last:
                self._stretches.pop()
            else:
                first = move.source_line
            self._stretches.append((code, first, move.source_line))

    def findings(self, tolerance: float) -> Iterator[Finding]:
        """Yield a finding with all lines of either kind; corners under a G64 without P are met within `tolerance` [m]."""
        more: dict[str, dict[str, Any]] = {"CL110": {}, "CL111": {"tolerance": tolerance}}
        for code, values in more.items():
            ranges: list[tuple[int, int]] = []
            for _, first, last in sorted({stretch for stretch in self._stretches if stretch[0] == code}):
                begin, end = ranges.pop() if ranges and first <= ranges[-1][1] else (first, last)
                ranges.append((begin, max(end, last)))
            if ranges:
                lines = [f"{first}-{last}" if first < last else f"{first}" for first, last in ranges]
                yield finding(code, line=ranges[0][0], lines=lines, **values)
