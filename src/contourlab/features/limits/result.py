"""Result of a check of limits: figures of each axis and the worst program lines, as JSON, as text, and as comments in the program."""

from __future__ import annotations

import io
import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.app.json_values import HIDDEN, json_values
from contourlab.app.session import Answer, Asked
from contourlab.errors import ParameterError, ProgramError
from contourlab.features.check.canon import Listed
from contourlab.features.limits.log_limits import KINDS, AxisPeak
from contourlab.figures import NONE, figure, listing, number
from contourlab.findings import Finding, finding
from contourlab.program import Reading
from contourlab.rendering.charts import Bars, Series
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import write_bytes_atomic

MOST_LINES = 8
"""Most program lines in the table."""
UNITS = {"velocity": "mm/s", "kink": "mm/s", "acceleration": "m/s^2", "curvature step": "m/s^2", "jerk": "m/s^3"}


@dataclass(frozen=True)
class ProgramLine:
    """What one program line does.

    Attributes
    ----------
    line : int
    start, duration : float [s]
        When it first begins, and how long it takes in all.
    use : float or None
        Largest part of a limit that it uses; above 1 the limit is exceeded. Null without limits.
    kind, axis : str
        Of this limit; empty without one.
    error : float or None [m]
        Largest distance of the position from the programmed path; null without a measured position.
    """

    line: int
    start: float
    duration: float
    use: float | None = None
    kind: str = ""
    axis: str = ""
    error: float | None = None


@dataclass(frozen=True)
class LimitTest(Answer):
    """The result of a check of limits.

    Attributes
    ----------
    name : str
    source : str
        "reference" or "position" of a log, or "plan".
    axes : tuple of str
    servo_period : float [s]
    cycle_time : float [s]
        From the first to the last motion; of a plan all of it.
    machine : str
        Whose limits hold where no option gives one; empty for none.
    tolerance : float
        Part by which a limit may be exceeded.
    passed : bool or None
        Whether all limits hold; null without limits.
    peaks : tuple of AxisPeak
    lines : tuple of ProgramLine
        In the order of the program; empty if unknown.
    given : tuple of str
        Kinds of limits that options give for a plan: "velocity", "acceleration", "jerk".
    planned_within : str
        Limits that the plan keeps: "given", with the machine's for the rest, or "machine"; empty for a log.
    annotated : str
        Program written with comments; empty for none.
    """

    name: str
    source: str
    axes: tuple[str, ...]
    servo_period: float
    cycle_time: float
    machine: str
    tolerance: float
    passed: bool | None
    peaks: tuple[AxisPeak, ...]
    lines: tuple[ProgramLine, ...]
    findings: tuple[Finding, ...]
    given: tuple[str, ...] = ()
    planned_within: str = ""
    annotated: str = ""
    program: Path | None = field(default=None, metadata=HIDDEN)
    reading: Reading | None = field(default=None, metadata=HIDDEN, repr=False)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The largest values, one a row [SI]."""
        return [json_values(peak) for peak in self.peaks]

    def _charts(self) -> Iterator[Bars]:
        limited = [peak for peak in self.peaks if peak.use is not None]
        use = Series("use", 100.0 * np.array([peak.use for peak in limited]), np.zeros(len(limited)), scheme_style(0, 1)[0])
        yield Bars("use", self.name, "", "use of the limit [%]", tuple(f"{peak.axis}, {peak.kind}" for peak in limited), (use,))

    def save(self, *, annotate: str | Path | None = None) -> LimitTest:  # type: ignore[override]
        """Write the program with times, limits and errors as comments.

        Parameters
        ----------
        annotate : str or Path, optional
            File to write; none by default.

        Returns
        -------
        LimitTest
            With the name of its file.

        Raises
        ------
        ParameterError
            If the program is not known.
        OutputError
            If the file cannot be written.
        """
        if annotate is None:
            return self
        if self.program is None or self.reading is None:
            raise ParameterError("annotate", repr(str(annotate)), "with the program of the log: add --program PART.ngc")
        skipped = write_annotated(self.program, Path(annotate), comments(self.lines), self.reading)
        more = (finding("CL475", lines=skipped),) if skipped else ()
        return replace(self, annotated=str(annotate), findings=(*self.findings, *more))

    def _next(self, asked: Asked) -> Sequence[object]:
        """Give limits, write the annotated program, run it, or judge the log."""
        file, settings = asked.inputs[0], asked.settings
        if self.passed is None:
            return ["limits", file, "--machine", "xyz"]
        if self.program is not None and not self.annotated:
            out = f"{self.program.stem}-annotated{self.program.suffix}"
            of_log = [] if self.source == "plan" else ["--program", self.program]
            limits = [word for name in ("machine", *KINDS) for word in settings.PARTS[name].words(getattr(settings, name))]
            return ["limits", file, *of_log, *limits, "--annotate", out]
        if self.source == "plan":
            return ["run", file, "--machine", settings.machine or "xyz"]
        return ["measure", file]

    @property
    def worst(self) -> tuple[ProgramLine, ...]:
        """The program lines that use most of a limit, the worst first."""
        known = [line for line in self.lines if line.use is not None]
        return tuple(sorted(known, key=lambda line: -(line.use or 0.0))[:MOST_LINES])

    @property
    def text(self) -> str:
        """The result for the terminal."""
        lines = self._lines().text() if self.worst else ""
        annotated = f"annotated program: {self.annotated}" if self.annotated else ""
        parts = (paragraphs([self._sentence()]), self._peaks().text(), lines, paragraphs(map(str, self.findings)), annotated)
        return "\n\n".join(filter(None, parts))

    def _sentence(self) -> str:
        of = {"plan": "planned", "reference": "commanded", "position": "measured"}[self.source]
        verdict = {True: "PASS, all limits hold", False: "FAIL, a limit is exceeded", None: "no limits given"}[self.passed]
        at = f" of {self.machine}" if self.machine else ""
        if self.planned_within:
            given, own = f"the given {listing(self.given)}", f"the limits of {self.machine}"
            at = f"; planned within {own}" + (f", compared with {given}" if self.given else "")
            at = f"; planned within {given}, else {own}" if self.planned_within == "given" else at
        return f"{self.name}: {verdict}{at}; cycle time {number(self.cycle_time, 5)} s, {of} every {figure(self.servo_period, 'ms', 4)}."

    def _peaks(self) -> Table:
        heads = [Column("axis", left=True), Column("", left=True), *map(Column, ("largest", "limit", "use", "at", "line"))]
        table = Table(heads, keys=2)
        for peak in self.peaks:
            unit, worst = UNITS[peak.kind], peak.worst
            limit = figure(worst.limit, unit) if math.isfinite(worst.limit) else NONE
            largest = figure(worst.value, unit)
            if 0.0 < 1e-3 * worst.value < worst.allowance:
                largest = f"{largest.split()[0]} +- {figure(worst.allowance, unit, 2)}"
            table.add(peak.axis, peak.kind, largest, limit, _percent(peak.use), f"{number(worst.time, 5)} s", str(peak.line or NONE))
        return table

    def _lines(self) -> Table:
        heads = ("line", "use", "limit", "at [s]", "takes [s]", "largest error [um]")
        shown = heads if any(line.error is not None for line in self.worst) else heads[:-1]
        table = Table([Column(head, left=head == "limit") for head in shown], "Worst lines of the program")
        for row in self.worst:
            error = NONE if row.error is None else number(1e6 * row.error)
            cells = (str(row.line), _percent(row.use), f"{row.kind} {row.axis}", number(row.start, 5), number(row.duration), error)
            table.add(*cells[: len(shown)])
        return table


def _percent(use: float | None) -> str:
    return NONE if use is None else f"{100.0 * use:.0f} %"


def comments(lines: tuple[ProgramLine, ...]) -> Iterator[tuple[int, str]]:
    """Yield each program line with the text of its comment."""
    for row in lines:
        words = [f"{row.start:.3f} s + {row.duration:.3f} s"]
        words += [f"{row.kind} {row.axis} {100.0 * row.use:.0f} %"] if row.use is not None and row.kind else []
        words += [f"error {number(1e6 * row.error)} um"] if row.error is not None else []
        yield row.line, ", ".join(words)


# --- comments in a part program, whose moves stay the same ---

LONGEST = 255
"""Characters in a line that LinuxCNC reads."""
_ACTIVE = re.compile(rb"[(;]\s*(msg|debug|print|log|probe|py|abort|hide)", re.IGNORECASE)
"""Comments that act: with another comment behind them they may not."""
_PLAIN = re.compile(rb"\s*([(/;%]|n\d|[a-z]\s*[-+.\d\[#]|#)", re.IGNORECASE)
_O_WORD = re.compile(rb"\s*(n\s*[\d.]+\s*)?o\s*[<\d#\[]", re.IGNORECASE)


def annotated(program: Path, texts: Iterable[tuple[int, str]]) -> tuple[bytes, int]:
    """Return a program with comments at the ends of its lines, and how many lines stay without.

    Parameters
    ----------
    program : Path
    texts : iterable of (int, str)
        Line, from 1, and its comment.

    Notes
    -----
    No line is inserted, so line numbers stay. A line that is an O-word, holds an active comment, has a comment without end, or would be
    longer than `LONGEST` stays as it is.
    """
    lines = program.read_bytes().splitlines(keepends=True)
    skipped = 0
    for place, text in texts:
        line = lines[place - 1] if 0 < place <= len(lines) else b""
        body = line.rstrip(b"\r\n")
        end, comment = line[len(body) :], f"({text})".encode("ascii")
        body = body.rstrip()
        is_open = body.count(b"(") != body.count(b")")
        longer = len(body) + 1 + len(comment) > LONGEST
        if not _PLAIN.match(body) or _O_WORD.match(body) or _ACTIVE.search(body) or is_open or longer:
            skipped += 1
            continue
        lines[place - 1] = body + b" " + comment + end
    return b"".join(lines), skipped


def write_annotated(program: Path, out: Path, texts: Iterable[tuple[int, str]], reading: Reading) -> int:
    """Write an annotated program; return how many lines stay without a comment.

    Raises
    ------
    ProgramError
        If the written program would not have the same moves; it is then not written.
    OutputError
        If the file cannot be written.
    """
    import tempfile

    content, skipped = annotated(program, texts)
    # Subprogram files lie beside the program.
    beside = replace(reading, folder=program.parent) if reading.folder is None else reading
    with tempfile.TemporaryDirectory() as folder:
        trial = Path(folder) / program.name
        trial.write_bytes(content)
        if moves_of(trial, beside) != moves_of(program, beside):
            raise ProgramError("comments would change its moves: it is not annotated", file=program)
    write_bytes_atomic(out, content)
    return skipped


def moves_of(program: Path, reading: Reading) -> str:
    """Return the moves of a program as canonical text."""
    text = io.StringIO()
    Listed(program, reading).write(text, as_json=True)
    return text.getvalue()
