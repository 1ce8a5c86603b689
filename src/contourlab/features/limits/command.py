"""``contourlab limits``: what a control commanded, or our planner would, against the limits of a machine."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import zip_longest
from pathlib import Path

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.app.options import positive
from contourlab.app.results import check_file
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.app.shared_options import Dialect, LogAxes, Planned
from contourlab.arrays import Array, Flags, Index
from contourlab.errors import LogError, ParameterError, ProgramError, ResultError, refuse
from contourlab.features.check.canon import Listed
from contourlab.features.check.program_check import FAULTY, OUTSIDE, Remarks
from contourlab.features.check.reading import machine_for, read_once, reading_of, refuse_drawing
from contourlab.features.limits.log_limits import KINDS, AxisPeak, control_samples, course, moving_part
from contourlab.features.limits.options import Limits
from contourlab.features.measure.log_choice import PROGRAMS, open_log, program_of
from contourlab.features.measure.measured_path import progress_along
from contourlab.features.measure.plausibility import known_signal
from contourlab.features.measure.study import ACTUAL
from contourlab.feed import AxisLimits, blended, plan
from contourlab.feed.verify import KINDS as ALL_KINDS
from contourlab.feed.verify import LineUse, Worst, limit_report_by_line
from contourlab.figures import NONE, figure, listing, number
from contourlab.file_kinds import kind_of
from contourlab.findings import Finding, finding
from contourlab.logs import Log, parse_columns
from contourlab.logs.load import about
from contourlab.loop import Machine
from contourlab.program import Reading, read_program
from contourlab.rendering.charts import Bars, Series
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import write_bytes_atomic
from contourlab.result.stamp import tell
from contourlab.scenario.load import machine_of
from contourlab.scenario.values import program_route

_UNITS = {"velocity": ("m/s", "200 mm/s"), "acceleration": ("m/s^2", "2 m/s^2"), "jerk": ("m/s^3", "50 m/s^3")}
"""Unit of each kind of limits, and an example."""
HELD = 0.005
"""Part by which a limit may be exceeded, by default."""


@question(Limits)
def limits(file: str | Path | Log, *, settings: Limits, session: Session = QUIET) -> LimitTest:
    """Compare what a control commanded, or our planner would, with the limits of a machine.

    Parameters
    ----------
    file : str, Path or Log
        A log, or a part program by its suffix.

    Returns
    -------
    LimitTest

    Raises
    ------
    LogError, ProgramError, ScenarioError
        If a file cannot be read.
    ParameterError
        If an option is out of range, or has no effect.
    """
    settings = read_once(settings)
    reading = reading_of(settings.program or Path("log"), settings)
    share = settings.tolerance
    tolerance = HELD if share is None else positive("--tolerance", share, "", 'a share such as "1 %"', zero=True)
    refuse(tolerance >= 1.0, ParameterError, "--tolerance", str(share), "between 0 and 100 %")
    is_program = Path(file).suffix.lower() in PROGRAMS and kind_of(file) != "a log"  # .nc: G-code or NetCDF
    planned = is_program and not settings.format and not settings.column
    program = Path(file) if planned else settings.program
    if planned and (settings.program or settings.line_column):
        raise ParameterError("--program", str(settings.program or settings.line_column), "left out: the file is itself a program")
    annotate = session.saving.get("annotate")
    if annotate is not None:
        if program is None:
            raise ParameterError("--annotate", repr(str(annotate)), "with the program of the log: add --program PART.ngc")
        check_file(annotate, [Path(file), program], "--annotate")
    test = _planned(Path(file), settings, tolerance, reading) if planned else _logged(file, settings, tolerance, reading)
    return replace(test, program=program, reading=reading)


def _limits(options: Limits, axes: Sequence[str], machine: Machine | None) -> dict[str, list[float]]:
    """Return the limits of each kind by axis, inf for none."""
    limits: dict[str, list[float]] = {}
    for kind, (unit, example) in _UNITS.items():
        known = {} if machine is None else dict(zip(machine.axis_names, getattr(machine.planner_limits(), kind).tolist(), strict=True))
        option, text = f"--{kind}", getattr(options, kind)
        for part in () if text is None else text.split(","):  # one for all axes, or x=..., y=...
            name, quantity = (word.strip() for word in part.rpartition("=")[::2])
            if name and name not in axes:
                raise ParameterError(option, repr(text), f"limits of {', '.join(axes)}, such as {axes[0]}={example}")
            wanted = f'a limit with its unit, such as "{example}" or "{axes[0]}={example}"'
            known |= dict.fromkeys([name] if name else axes, positive(option, quantity, unit, wanted))
        limits[kind] = [known.get(axis, math.inf) for axis in axes]
    return limits


def _planned(file: Path, options: Limits, tolerance: float, reading: Reading) -> LimitTest:
    """Check what the planner would command."""
    refuse_drawing(file)
    named, machine = options.machine is not None, machine_for(options, reading)
    asked = _limits(options, machine.axis_names, machine)
    limits = AxisLimits(*(asked[kind] for kind in KINDS), planner=machine.own_planner)
    given = tuple(kind for kind in KINDS if getattr(options, kind) is not None)
    within = limits if not named else machine.planner_limits()
    program = tell(read_program(file, reading=reading))
    route, remarks = program_route(program, machine.axis_names, planner=machine.own_planner), Remarks(machine, reading, named=named)
    remarks.add(program, route)
    reference = plan(blended(route, within), within, machine.servo_period)
    report, use = limit_report_by_line(reference, limits)
    orders = {"velocity": 1, "kink": 1, "acceleration": 2, "curvature step": 2, "jerk": 3}
    peaks = [
        AxisPeak(machine.axis_names[worst.axis], kind, worst, orders[kind] * machine.servo_period)
        for of_axis in zip(*report.kinds, strict=True)
        for kind, worst in zip(ALL_KINDS, of_axis, strict=True)
        if worst.sample >= 0 and (worst.value > 0.0 or kind in KINDS)
    ]
    blocks = (reference.block(*samples) for samples in reference.blocks())
    lines = np.concatenate([reference.source_line(block.arc_length) for block in blocks])
    rows = _rows(lines, reference.servo_period, use, machine.axis_names)
    findings = (*_exceeded(peaks, tolerance), *remarks.findings(program.machine_points))
    passed = not any(found.entry.severity == "error" for found in findings)
    kept = "given" if given and not named else "machine"
    head = (file.name, "plan", machine.axis_names, machine.servo_period, reference.duration, machine.name, tolerance, passed)
    return LimitTest(*head, tuple(peaks), rows, findings, given, kept)


def _rows(lines: Index, period: float, use: LineUse, axes: Sequence[str], errors: Array | None = None) -> tuple[ProgramLine, ...]:
    """Return what each program line does, from the line of each sample."""
    rows = []
    present, first, count = np.unique(lines, return_index=True, return_counts=True)
    largest = np.zeros(int(present.max(initial=0)) + 1)
    if errors is not None:
        np.maximum.at(largest, lines, errors)
    for line, at, n in zip(present.tolist(), first.tolist(), count.tolist(), strict=True):
        if line > 0:
            known = line < len(use.ratio) and use.kind[line] >= 0
            share: tuple[float | None, str, str] = (
                (float(use.ratio[line]), ALL_KINDS[use.kind[line]], axes[use.axis[line]]) if known else (None, "", "")
            )
            error = None if errors is None else float(largest[line])
            rows.append(ProgramLine(line, at * period, n * period, *share, error))
    return tuple(rows)


def _logged(file: str | Path | Log, options: Limits, tolerance: float, reading: Reading) -> LimitTest:
    """Check what a log holds: its reference, or without one its position."""
    if options.planner is not None:
        raise ParameterError("--planner", repr(options.planner), "left out: nothing of a log is planned")
    log = open_log(file, options, [] if options.line_column is None else parse_columns([f"line={options.line_column}"]))
    result, axes = log.result, options.axes or log.result.axes
    with about(file):
        known = known_signal(result, axes, ("reference", *ACTUAL, "motor_position"))
        if known is None:
            raise ResultError(f"no reference or position of {', '.join(axes)} in {result.source}: name the columns with --column")
        position = known[1]
        moves = moving_part(position)
    refuse(not moves.any(), LogError, "nothing moves: position or reference is the same at all samples", file=log.record.file)
    machine = None if options.machine is None else machine_of(options.machine)
    if machine is not None and (unlike := [axis for axis in axes if axis not in machine.axis_names]):
        raise ParameterError("--axes", ", ".join(unlike), f"axes of {machine.name}: {', '.join(machine.axis_names)}")
    limits = _limits(options, axes, machine)
    lines, errors = _lines_of(log, options, axes, position, reading)
    use = LineUse(int(lines.max(initial=0)) + 1)
    first, commanded = control_samples(position, result.servo_period)
    peaks, findings = _log_peaks(position[first], commanded, axes, limits, lines[first], moves[first], use)
    rows = _rows(np.where(moves, lines, 0), result.servo_period, use, axes, errors) if lines.any() else ()
    uses = [peak.use for peak in peaks if peak.use is not None]
    passed = max(uses) <= 1.0 + tolerance if uses else None
    source = "reference" if known[0] == "reference" else "position"
    cycle, name = float(np.count_nonzero(moves) - 1) * result.servo_period, "" if machine is None else machine.name
    head = (Path(file).name, source, axes, commanded, cycle, name, tolerance, passed)
    return LimitTest(*head, tuple(peaks), rows, (*_exceeded(peaks, tolerance), *findings, *log.findings))


def _lines_of(log: Log, options: Limits, axes: Sequence[str], position: Array, reading: Reading) -> tuple[Index, Array | None]:
    """Return the program line of each sample, 0 for none, and the distance from the program's path [m]."""
    lines, errors = np.zeros(len(position), dtype=np.int64), None
    if options.program is not None:
        _, route = program_of(options.program, axes, reading)
        with about(log):
            along, _ = progress_along(route.path, position)
        lines = np.asarray(route.source_line[route.path.curve_index(along)], dtype=np.int64)
        if (measured := known_signal(log.result, axes, ACTUAL)) is not None:
            errors = np.asarray(route.path.foot_point(measured[1], along, 0.02 * route.path.length + 1e-3).distance)
    return lines if log.lines is None else log.lines, errors


def _log_peaks(
    position: Array, period: float, axes: Sequence[str], limits: Mapping[str, list[float]], lines: Index, moves: Flags, use: LineUse
) -> tuple[list[AxisPeak], list[Finding]]:
    """Return the largest values, and what limits their resolution; add the use of each program line."""
    peaks, findings = [], []
    for j, axis in enumerate(axes):
        for order, kind in enumerate(KINDS, 1):
            limit = limits[kind][j]
            found = course(position[:, j], period, order, limit)
            magnitude = np.where(moves & np.isfinite(found.magnitude), found.magnitude, 0.0)
            at = int(np.argmax(magnitude))
            worst = Worst(j, float(magnitude[at]), limit, found.resolution, at, at * period, source_line=int(lines[at]))
            peaks.append(AxisPeak(axis, kind, worst, order * found.stride * period))
            if math.isfinite(limit):
                ratios = np.zeros((len(magnitude), len(axes)))
                ratios[:, j] = np.maximum(magnitude - found.resolution, 0.0) / limit
                use.add(order - 1, ratios, np.arange(len(ratios)), lines)
                if found.resolution > 0.5 * limit:
                    findings.append(finding("CL474", f"axis {axis}", kind=kind, resolution=found.resolution, limit=limit))
    filtered = [f"{peak.kind} of {peak.axis} over {1e3 * peak.window:.3g} ms" for peak in peaks if peak.window > 3.5 * period]
    return peaks, [*findings, *([finding("CL473", figures=filtered)] if filtered else [])]


def _exceeded(peaks: Sequence[AxisPeak], tolerance: float) -> tuple[Finding, ...]:
    """Return a finding for each limit that is exceeded."""
    over = sorted((peak for peak in peaks if (peak.use or 0.0) > 1.0 + tolerance), key=lambda peak: -peak.worst.ratio)
    places = [f"line {peak.line}" if peak.line else f"axis {peak.axis}" for peak in over]
    return tuple(
        finding("CL472", place, kind=peak.kind, axis=peak.axis, use=peak.use, time=peak.worst.time)
        for place, peak in zip(places, over, strict=True)
    )


# --- the result as JSON, as text, and as comments in the program ---


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

    ROWS = "peaks"

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
    def exit_code(self) -> int:
        """Exit code of the command: 2 for a program that leaves the travel, 1 if a limit is exceeded."""
        return FAULTY if any(found.code in OUTSIDE for found in self.findings) else super().exit_code

    def _charts(self) -> Iterator[Bars]:
        limited = [peak for peak in self.peaks if peak.use is not None]
        use = Series("use", 100.0 * np.array([peak.use for peak in limited]), np.zeros(len(limited)), scheme_style(0, 1)[0])
        yield Bars("use", self.name, "", "use of the limit [%]", tuple(f"{peak.axis}, {peak.kind}" for peak in limited), (use,))

    def save(self, folder: str | Path = "results", *, annotate: str | Path | None = None) -> LimitTest:
        """Write the program with times, limits and errors as comments.

        Parameters
        ----------
        folder : str or Path
            Gets nothing.
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

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Give limits, write the annotated program, run it, or judge the log."""
        file, settings = asked.inputs[0], asked.settings
        if self.exit_code == FAULTY:
            return None
        read, how = settings.words_of(LogAxes), [*settings.words_of(Planned), *settings.words_of(Dialect)]
        if self.passed is None:
            return ["limits", file, *read, "--machine", "xyz"]
        if self.program is not None and not self.annotated:
            out = f"{self.program.stem}-annotated{self.program.suffix}"
            of_log = [] if self.source == "plan" else ["--program", self.program, *read]
            limits = [word for name in ("machine", *KINDS) for word in settings.PARTS[name].words(getattr(settings, name))]
            return ["limits", file, *of_log, *how, *limits, "--annotate", out]
        if self.source == "plan":
            return ["check", file, *how, "--machine", settings.machine]
        return ["measure", file, *read, *settings.PARTS["machine"].words(settings.machine)]

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
        codes, faults = {found.code for found in self.findings}, {"a limit is exceeded": {"CL472"}, "the travel is left": {*OUTSIDE}}
        failed = " and ".join(fault for fault, of_fault in faults.items() if of_fault & codes)
        verdict = {True: "PASS, all limits hold", False: f"FAIL, {failed}", None: "no limits given"}[self.passed]
        at = f" of {self.machine}" if self.machine else ""
        if self.planned_within:
            given, own = f"the given {listing(self.given)}", f"the limits of {self.machine}"
            at = f"; planned within {own}" + (f", compared with {given}" if self.given else "")
            at = f"; planned within {given}, else {own}" if self.planned_within == "given" else at
        return f"{self.name}: {verdict}{at}; cycle time {number(self.cycle_time, 5)} s, {of} every {figure(self.servo_period, 'ms', 4)}."

    def _peaks(self) -> Table:
        heads = [Column("axis", left=True), Column("", left=True), *map(Column, ("largest", "limit", "use", "at", "line"))]
        rows = []
        for peak in self.peaks:
            unit, worst = UNITS[peak.kind], peak.worst
            limit = figure(worst.limit, unit) if math.isfinite(worst.limit) else NONE
            largest = figure(worst.value, unit)
            if 0.0 < 1e-3 * worst.value < worst.allowance:
                largest = f"{largest.split()[0]} +- {figure(worst.allowance, unit, 2)}"
            rows.append((peak.axis, peak.kind, largest, limit, _percent(peak.use), f"{number(worst.time, 5)} s", str(peak.line or NONE)))
        return Table(heads, keys=2, rows=rows)

    def _lines(self) -> Table:
        heads = ("line", "use", "limit", "at [s]", "takes [s]", "largest error [um]")
        shown = heads if any(line.error is not None for line in self.worst) else heads[:-1]
        rows = []
        for row in self.worst:
            error = NONE if row.error is None else number(1e6 * row.error)
            cells = (str(row.line), _percent(row.use), f"{row.kind} {row.axis}", number(row.start, 5), number(row.duration), error)
            rows.append(cells[: len(shown)])
        return Table([Column(head, left=head == "limit") for head in shown], "Worst lines of the program", rows=rows)


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
        if any(one != other for one, other in zip_longest(Listed(trial, beside), Listed(program, beside))):
            raise ProgramError("comments would change its moves: it is not annotated", file=program)
    write_bytes_atomic(out, content)
    return skipped
