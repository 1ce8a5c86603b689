"""``contourlab check``: faults, extent, feeds and cycle time of a part program, without simulating it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.errors import ContourlabError, ProgramError
from contourlab.features.check.options import Check
from contourlab.features.check.planned_motion import PlannedMotion, parts
from contourlab.features.check.reading import reading_of
from contourlab.findings import Finding
from contourlab.program import Arc, Dwell, Feed, Program, Spline, Traverse, open_program
from contourlab.program.reader import NO_END
from contourlab.rendering.table import paragraphs

FAULTY = 2
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

    def text(self, program: str, note: str = "") -> str:
        """Return ``file:line:column: message [code]``."""
        place = "".join(f"{number}:" for number in (self.line, self.column) if self.line and number)
        return f"{self.file or program}:{place} {note}{self.message}" + (f" [{self.code}]" if self.code else "")


@dataclass(frozen=True)
class Checked(Answer):
    """The result of a check; as JSON field by field.

    Attributes
    ----------
    problems, notices : tuple of Message
        Faults, and places where the reader was lenient.
    moves : dict of str to int
        Number of moves by kind.
    length : dict of str to float [m]
        Length of feed and rapid moves. Without moves, or with a fault, this and all below is empty or None.
    box : dict of str to (float, float) [m]
        Extent by axis.
    cycle_time, dwell, feed_time_without_acceleration : float [s]
    machine : dict of str to str
        Name and file.
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
    length: dict[str, float] = field(default_factory=dict)
    box: dict[str, tuple[float, float]] = field(default_factory=dict)
    cycle_time: float | None = None
    dwell: float | None = None
    feed_time_without_acceleration: float | None = None
    machine: dict[str, str] = field(default_factory=dict)
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
        """Run the program."""
        if self.faults:
            return None
        machine = asked.settings.machine
        parts = ["--machine", machine or "xyz", "--controller", None if machine else "xyz-controller"]
        end = [] if self.has_end else ["--no-require-end"]
        return ["run", *asked.inputs, *parts, *asked.settings.words("machine"), *end]

    @property
    def faults(self) -> int:
        """Number of faults."""
        return len(self.problems) + sum(found.entry.severity == "error" for found in self.findings)

    @property
    def has_end(self) -> bool:
        """Whether the program ends with M2, M30 or %."""
        return not any(notice.message.startswith(NO_END) for notice in self.notices)

    @property
    def text(self) -> str:
        """Return the result for the terminal."""
        lines = [message.text(self.program) for message in self.problems]
        lines += [message.text(self.program, "note: ") for message in self.notices]
        lines += [paragraphs(map(str, self.findings))] if self.findings else []
        lines.append(f"{self.faults} fault{'s' * (self.faults > 1)}" if self.faults else "no fault in the program")
        return "\n".join([*lines, paragraphs([f"{name:<12}{value}" for name, value in self._rows()], indent=" " * 12)])

    def _rows(self) -> list[tuple[str, str]]:
        rows = [("lines", f"{self.n_line}"), ("moves", ", ".join(f"{n} {kind}" for kind, n in self.moves.items()) or "none")]
        for name, (low, high) in self.box.items():
            rows.append((f"box {name}", f"{low * 1e3:.6g} .. {high * 1e3:.6g} mm ({(high - low) * 1e3:.6g} mm)"))
        if self.cycle_time is not None and self.feed_time_without_acceleration is not None:
            rows.append(("path", f"{self.length['feed'] * 1e3:.6g} mm feed, {self.length['rapid'] * 1e3:.6g} mm rapid"))
            ideal = _duration(self.feed_time_without_acceleration)
            detail = f"dwells {self.dwell:.3g} s; feed moves without acceleration {ideal}"
            detail += f"; planned in parts, with {self.added_stops} added stops" if self.added_stops else ""
            rows.append(("cycle time", f"{_duration(self.cycle_time)} on {self.machine['name']} ({detail})"))
        feeds = self.feeds_mm_per_min
        shown = [f"{feed:g}" for feed in feeds] if len(feeds) <= MOST_FEEDS else [f"{len(feeds)} from {feeds[0]:g} to {feeds[-1]:g}"]
        rows.append(("feeds", (", ".join(shown) + " mm/min") if feeds else "none"))
        if self.spindle_speeds:
            rows.append(("spindle", ", ".join(f"{speed:g}" for speed in self.spindle_speeds) + " rpm"))
        if self.tools:
            rows.append(("tools", ", ".join(f"T{tool}" for tool in self.tools)))
        return rows


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
    seen, motion = _Seen(), PlannedMotion(settings.machine)
    chosen, stages = reading_of(file, settings), session.stages()
    with open_program(file, chosen, problems=problems) as reader:
        stages.begin(f"reading {Path(file).name}")
        for part in parts(reader, problems):
            seen.add(part.program)
            if not problems:  # the motion of a faulty program means nothing, and may be endless
                motion.add(part)
            stages.begin(f"{sum(seen.moves.values())} moves of {Path(file).name}")
        notices, n_line = reader.notices, reader.count_lines()
    checked = Checked(
        program=str(file),
        problems=tuple(map(_problem, [*problems, *motion.problems])),
        notices=tuple(Message(notice.message, notice.line, notice.column) for notice in notices),
        n_line=n_line,
        moves=dict(seen.moves),
        feeds_mm_per_min=tuple(sorted(seen.feeds)),
        spindle_speeds=tuple(sorted(seen.speeds)),
        tools=tuple(seen.tools),
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


def _problem(error: ContourlabError) -> Message:
    message, file = getattr(error, "message", str(error)), getattr(error, "file", "")
    return Message(message, getattr(error, "line", 0), getattr(error, "column", 0), str(file), getattr(error, "code", "") or NOT_PLANNED)


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
