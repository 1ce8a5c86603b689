"""``contourlab precompensate``: correct a part program by the contour error that repeats, from logs or from a model."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.app.options import positive
from contourlab.app.results import check_file, spared
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.app.shared_options import Dialect, Planned
from contourlab.arrays import Array
from contourlab.errors import ParameterError, ProgramError, ResultError
from contourlab.features.check.program_check import about_planner
from contourlab.features.check.reading import reading_of
from contourlab.features.measure.log_choice import content_of
from contourlab.features.precompensate.law import CUTOFF, Learned, Run, fit_loop, forgotten, learn, proposed, spread
from contourlab.features.precompensate.options import Precompensate
from contourlab.features.precompensate.passes import AddedDwell, Passes, PassFigures, digest_of, load, save
from contourlab.features.precompensate.reading import Contour, contour_of, parse_blocks, read_blocks
from contourlab.features.precompensate.runs import Measured, cycle_time, open_run, run_of, simulated
from contourlab.features.precompensate.starts import LONGEST, UNKNOWN, Start, settling_time, starts_of, without
from contourlab.features.precompensate.writing import MARK, Written, marked, with_dwells, write_corrected
from contourlab.features.run import options
from contourlab.features.run.source import scenario_of
from contourlab.feed.route import controlled
from contourlab.figures import figure, grouped
from contourlab.findings import Finding, finding
from contourlab.loop import Machine
from contourlab.program import Reading
from contourlab.rendering.charts import Chart, traces_chart
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result.atomic import replacing
from contourlab.result.stamp import tell
from contourlab.scenario.load import machine_of
from contourlab.scenario.values import DEFAULT_CORNER_TOLERANCE

NODE_TIME = 1e-3
"""Least time between nodes at the programmed feed [s]."""
LOOSER = 4.0
"""Factor on how far the control may round and smooth the written lines, after each pass that took too long."""
SLOWED = 0.01
"""Share by which a pass may be slower than the program, up to which lines get feed words. They slow down a control that merges lines of one
feed, or whose acceleration is zero between lines."""
COVERED = 0.98
"""Share of the corrected path that a log must cover."""
HELPED = 0.5
"""Error at the start of a cut over that without a dwell, from which the dwell did not help."""
GAIN = 0.1
"""Least gain of dwells, as a share of the rms or of the largest error, from which CL917 offers them."""
SAID = 0.02
"""Share by which a program is longer, from which CL919 says so first."""
CORNER = 0.17
"""Least change of direction of a corner [rad]."""
ROUNDED = 0.2
"""Speed at a corner over the feed from which a control does not stop there; and at least that of three periods of acceleration."""


class Work:
    """A program, its passes so far, and the program of the pass that was run last."""

    def __init__(self, part: Path, axes: Sequence[str], settings: Precompensate, reading: Reading, period: float) -> None:
        self.part, self.reading = part, replace(reading, folder=reading.folder or part.parent)
        self.tolerance, self.cap, self.lead_in = settings.si("tolerance"), settings.si("cap"), settings.lead_in
        self.band = positive("--band", settings.band, "", 'a share, such as "2 %"')
        period = max(NODE_TIME, period)
        source = read_blocks(part, self.reading, axes)
        tell(source.program)
        if any(MARK in line for line in source.program.lines[:3]):
            raise ProgramError("is a corrected program: give the one before any correction, and the folder with --passes", file=part)
        self.contour = contour_of(source, axes, period)
        if not self.contour.corrected.any():
            raise ProgramError(f"no cutting move along {', '.join(axes)} can be corrected", file=part)
        known = repr((tuple(axes), period, self.tolerance))
        self.passes = Passes(digest_of("\n".join(source.program.lines).encode("utf-8", "replace"), known.encode()), tuple(axes))
        self.settles: float | None = None
        self.driven = self.contour

    def resume(self, folder: Path) -> None:
        """Go on with the passes of a folder, if it has some."""
        self.passes = load(folder, self.passes)
        if self.passes.written:
            self.driven = self.contour_again(self.passes.written[-1])

    def contour_again(self, written: Written) -> Contour:
        """Read a written program, and check that it is the corrected path and nothing else."""
        source = parse_blocks(written.text, f"corrected {self.part.name}", self.reading, self.contour.axes)
        contour = contour_of(source, self.contour.axes, self.contour.period)
        breaks = np.asarray(contour.path.breaks)
        if len(breaks) != len(written.corrected_arc) or np.abs(breaks - written.corrected_arc).max() > 1e-6 + 1e-6 * breaks[-1]:
            raise ProgramError("cannot be corrected: the written program would move differently elsewhere", file=self.part)
        if contour.events != self.contour.events:
            raise ProgramError("cannot be corrected: the written program would lose a code", file=self.part)
        return contour

    def run(self, measured: Measured) -> Run:
        """Return what a run of the last written program shows.

        Raises
        ------
        ResultError
            If it is a run of another program, or of a part of it, or if all passes were learned from.
        """
        written = self.passes.written[-1] if self.passes.written else None
        if written is not None and len(self.passes.figures) > len(self.passes.written):
            raise ResultError(f"all passes were learned from: keep pass {self.passes.best}, or use a new folder with --passes")
        try:
            run = run_of(self.contour, measured, self.driven, written)
        except ResultError as error:
            if written is None:
                raise
            number, best = len(self.passes.written), self.passes.best
            raise ResultError(f"pass {number} is to be run and logged, but {error} If it was, keep pass {best}, the best so far") from error
        on = self.contour.is_corrected(self.contour.nodes)
        covered = float(on[(self.contour.nodes >= run.place[0]) & (self.contour.nodes <= run.place[-1])].sum()) / float(on.sum())
        if covered < COVERED:
            raise ResultError(f"the log covers {covered:.0%} of the cuts: record from before the program's start to after its end")
        return run

    def learn(self, measured: Measured, runs: list[Run]) -> list[Finding]:
        """Learn from the runs of a pass; return the findings."""
        passes, number = self.passes, len(self.passes.figures)
        if not passes.loops:
            loops = tuple(fit_loop(*pair, measured.period) for pair in zip(measured.command.T, measured.motor.T, strict=True))
            cutoff = CUTOFF * min(loop.bandwidth for loop in loops)
            passes = replace(passes, loops=loops, cutoff=min(cutoff, 0.2 / measured.period))
        figures = self._figures(number, runs, passes.cutoff)
        learned = learn(passes.learned, runs, list(passes.loops), self.contour.nodes, passes.cutoff)
        self.passes = replace(passes, figures=(*passes.figures, figures), learned=learned)
        if figures.in_time:
            return []
        change = (figures.duration - figures.dwell) / passes.figures[0].duration - 1.0
        return [finding("CL911", number=number, change=change, band=self.band), *self._free_corners()]

    def _figures(self, number: int, runs: Sequence[Run], cutoff: float) -> PassFigures:
        """Return the figures of a pass."""
        run, worst = runs[0], max(runs, key=lambda one: one.largest)
        contour, square = self.contour, np.where(worst.moves, (worst.error**2).sum(axis=1), 0.0)
        at, around = int(np.argmax(square)), math.ceil(0.5 / (cutoff * worst.period))
        place, dwell = worst.place[at : at + 1], sum(self.dwells.values())
        block = contour.source.blocks[contour.route.source_line[contour.path.curve_index(place)[0]] - 1]
        first = self.passes.figures[0].duration if number else run.duration
        return PassFigures(
            number=number,
            rms=float(np.sqrt(np.mean([one.rms**2 for one in runs]))),
            largest=worst.largest,
            duration=run.duration,
            velocity=tuple(run.velocity.tolist()),
            acceleration=tuple(run.acceleration.tolist()),
            in_time=run.duration - dwell <= (1.0 + self.band) * first,
            dwell=dwell,
            line=contour.source.numbers[block.lines[0] - 1],
            place=tuple(contour.path.position(place)[0].tolist()),
            share=float(square[max(at - around, 0) : at + around + 1].sum() / max(square.sum(), 1e-300)),
        )

    @property
    def learned(self) -> Learned:
        """What all passes have taught."""
        assert self.passes.learned is not None
        return self.passes.learned

    @property
    def dwells(self) -> dict[int, float]:
        """The added dwells [s] by the number of the block after each."""
        return {one.block: one.seconds for one in self.passes.dwells if one.seconds}

    @property
    def _turns(self) -> Array:
        """The change of direction [rad] from each corrected curve to the next (n_curve - 1,); 0 where one is not corrected."""
        (_, after), (_, before) = self.contour.path.starts, self.contour.path.ends
        corrected = self.contour.corrected
        turn = 2.0 * np.arcsin(np.minimum(0.5 * np.linalg.norm(after[1:] - before[:-1], axis=1), 1.0))
        return np.asarray(np.where(corrected[:-1] & corrected[1:], turn, 0.0))

    @property
    def stops(self) -> bool:
        """Whether the control may stop at corners where the program sets no path control: the run of the program shows no other."""
        contour = self.contour
        speed = np.interp(contour.path.breaks[1:-1], contour.nodes, self.learned.speed)
        step = 3.0 * max(self.passes.figures[0].acceleration) * contour.period
        passed = speed > np.maximum(ROUNDED * np.minimum(contour.route.feedrate[1:], contour.route.feedrate[:-1]), step)
        # A control without G64, as grbl, stops at no short line.
        return contour.source.rules.blend is not None and not (passed & (self._turns > CORNER) & (self._controls == "None")[:-1]).any()

    @property
    def _controls(self) -> Array:
        """The path control of each curve (n_curve,) as text; that of G64 without P is "free"."""
        blocks = self.contour.source.blocks
        modes = [blocks[number - 1].move.mode for number in self.contour.route.source_line.tolist()]
        return np.array(["free" if mode.control == "blend" and mode.tolerance is None else str(mode.control) for mode in modes])

    def _free_corners(self) -> list[Finding]:
        """Name the sharpest corner that the control may round without a tolerance."""
        free = (self._controls == "free") | ((self._controls == "None") & (not self.stops))
        turn = self._turns * free[:-1]
        if not turn.size or turn.max() < CORNER:
            return []
        k = int(np.argmax(turn))
        line = self.contour.source.blocks[self.contour.route.source_line[k] - 1].lines[1]
        return [finding("CL918", angle=float(turn[k]), line=self.contour.source.numbers[line - 1])]

    def settle(self, run: Run, measured: Measured, probe: Callable[[str], Measured] | None = None) -> list[Finding]:
        """Say which cuts begin while the axes still settle; write dwells before them from the next program on, if they are asked for.

        Parameters
        ----------
        run : Run
        measured : Measured
        probe : callable, optional
            Runs a program; without it, the rests of `measured` show how long the axes settle.
        """
        starts = starts_of(self.contour, run, measured, self.learned.rests)
        if not starts or (self.lead_in and not self.passes.helps):
            return []
        if not self.lead_in and not self._gain(without(run, starts, LONGEST), run):
            return []
        values: dict[str, Any] = {"count": len(starts), "error": max(one.error for one in starts), "line": starts[0].line}
        if self.settles is None:
            shown = measured if probe is None else probe(with_dwells(self.contour, {one.block: LONGEST for one in starts}))
            self.settles = settling_time(shown, self.learned.rests)
        if probe is not None and self.settles is None:
            return [finding("CL927", dwell=LONGEST, **values)]
        added = {one.block: one.dwell(self.settles) for one in starts}
        if self.lead_in:
            return self._with_dwells(run, starts, added, values)
        if not any(added.values()):
            return [finding("CL927", dwell=LONGEST, **values)]
        rms, largest = without(run, starts, max(self.settles or UNKNOWN, 1.0 / self.passes.cutoff))
        if not self._gain((rms, largest), run):
            return []
        total, dwell = sum(added.values()), max(added.values())
        return [finding("CL917", total=total, dwell=dwell, rms=rms, largest=largest, **values)]

    def _with_dwells(self, run: Run, starts: list[Start], added: dict[int, float], values: dict[str, Any]) -> list[Finding]:
        """Add dwells [s] from the next program on; leave those out that did not help."""
        learned, known = self.learned, {one.block: one for one in self.passes.dwells}
        settles, tried = self.settles or UNKNOWN, 0.0
        for one in starts:
            old = known.get(one.block)
            if old is not None and one.error > HELPED * old.error:
                tried, added[one.block] = max(tried, old.seconds), -old.seconds
            if added[one.block]:
                before = old or AddedDwell(one.block, 0.0, one.error)
                known[one.block] = replace(before, seconds=before.seconds + added[one.block])
                lasts = np.rint(np.array([0.0, settles, settles + 1.0 / self.passes.cutoff]) / run.period).astype(int)
                begin, end, after = run.place[np.minimum(one.begin + lasts, len(run.place) - 1)].tolist()
                learned = forgotten(learned, self.contour.nodes, begin, end, after)
        self.passes = replace(self.passes, dwells=tuple(known.values()), learned=learned)
        longer = [seconds for seconds in added.values() if seconds > 0.0]
        findings = [finding("CL926", total=sum(longer), dwell=max(longer), **values)] if longer else []
        return findings + ([finding("CL927", dwell=tried, **values)] if tried else [])

    @staticmethod
    def _gain(left: tuple[float, float], run: Run) -> bool:
        """Return whether a rms and a largest error are worth dwells."""
        return min(left[0] / run.rms, left[1] / run.largest) <= 1.0 - GAIN

    def _blend(self, number: int) -> float:
        """Return by how much the control may round the lines of a pass [m]."""
        return float(2.0 * self.tolerance * LOOSER ** sum(not one.in_time for one in self.passes.figures[:number]))

    def propose(self) -> list[Finding]:
        """Write the program of the next pass; return the findings."""
        learned = self.learned
        tried, capped = proposed(learned, self.cap, self.contour.room)
        durations = [one.duration - one.dwell for one in self.passes.figures]
        slowed = max(durations) > (1.0 + SLOWED) * durations[0]
        fastest = np.inf if slowed else (1.0 + self.band) * learned.speed
        number = len(self.passes.written) + 1
        written = write_corrected(self.contour, tried, self.tolerance, fastest, self._blend(number), self.dwells, self.stops)
        written = replace(written, text=marked(written.text, number, self.part.name, self.contour.source.program.lines))
        self.passes = replace(self.passes, learned=replace(learned, tried=tried), written=(*self.passes.written, written))
        self.driven = self.contour_again(written)
        return [finding("CL910", cap=self.cap, share=float(capped.mean()))] if capped.any() else []

    def _longer(self, number: int) -> Iterator[Finding]:
        """Say by how much a written program is longer: as its run showed; if it has not run, as planned."""
        first, blend = self.passes.figures[0], DEFAULT_CORNER_TOLERANCE
        written = self.driven if number == len(self.passes.written) else self.contour_again(self.passes.written[number - 1])
        free = (self._controls == "None").all() and not self.stops
        routes = [controlled(one.route, "blend" if free else "program", blend) for one in (self.contour, written)]
        routes.append(controlled(written.route, "blend", blend))
        times = [cycle_time(route, first.velocity, first.acceleration, self.contour.period) for route in routes]
        scale = first.duration / times[0]
        dwell = sum(self.dwells.values())
        if number < len(self.passes.figures):
            scale, dwell = self.passes.figures[number].duration / times[1], self.passes.figures[number].dwell
        after, instead = scale * times[1], scale * times[2]
        if after > (1.0 + SAID) * first.duration:
            yield finding("CL919", before=first.duration, after=after, change=after / first.duration - 1.0, dwell=dwell)
            if "P" in (self.contour.source.rules.blend or "") and instead < (1.0 - SAID) * after:
                yield finding("CL929", tolerance=blend, instead=instead)

    def save(self, passes: Path | None, result: Precompensated) -> None:
        """Write the program that a result names, if a pass gains, and what was learned into a folder, if there is one; all or nothing."""
        with ExitStack() as files:
            if result.written:
                new = files.enter_context(replacing(result.out))
                new.write_bytes(self.passes.written[result.written - 1].text.encode("utf-8", "replace"))
            if passes is not None:
                save(self.passes, passes)

    def result(
        self, out: Path, position: str, rest: float | None, findings: Sequence[Finding], proceed: bool, folder: Path | None = None
    ) -> Precompensated:
        """Return the result; `folder` is that of the passes."""
        passes, learned = self.passes, self.learned
        number = len(passes.written) if proceed else passes.best
        written = passes.written[number - 1] if number else None
        source = self.contour.source
        left = grouped((b.reason, source.numbers[b.lines[0] - 1]) for b in source.blocks if b.reason not in ("", "-"))
        more = [finding("CL909", count=len(those), reason=reason, line=those[0]) for reason, those in left.items()]
        more += [] if passes.helps else [finding("CL915", best=passes.best)]
        first, best = passes.figures[0], passes.figures[passes.best]
        if (best.rms - first.rms) * (best.largest - first.largest) < 0.0:
            more.append(
                finding("CL925", best=best.number, rms=best.rms, before=first.rms, largest=best.largest, largest_before=first.largest)
            )
        uncontrolled = np.flatnonzero((self._controls == "None") & self.contour.corrected)
        if number and uncontrolled.size and self.stops:
            line = source.blocks[self.contour.route.source_line[uncontrolled[0]] - 1].lines[0]
            more.append(finding("CL928", line=source.numbers[line - 1], tolerance=self._blend(number)))
        more += self._longer(number) if number else []
        return Precompensated(
            program=self.part.name,
            out=str(out) if number else "",
            position=position,
            axes=passes.axes,
            not_repeating=rest,
            passes=passes.figures,
            best=passes.best,
            written=number,
            status="next pass" if proceed else "done" if number else "no gain",
            cutoff=passes.cutoff,
            correction=float(np.linalg.norm(learned.tried if proceed else learned.kept, axis=1).max()),
            lines=0 if written is None else written.n_line,
            left=left,
            findings=(*findings, *more),
            writer=partial(self.save, folder),
        )


# --- the answer ---


@dataclass(frozen=True, eq=False)
class Precompensated(Answer):
    """A corrected program, and what the passes before it showed.

    Attributes
    ----------
    program, out : str
        The given one, and the one written; empty if none was.
    position : str
        What counted as the tool's position: ``"load"``, ``"motor and model"``, ``"motor"`` or ``"model"``.
    axes : tuple of str
    not_repeating : float or None [m]
        Rms of what differs between runs of the last pass; None if one run cannot tell.
    passes : tuple of PassFigures
        All that were run.
    best : int
        The best of them.
    written : int
        The pass that `out` holds; 0 for none.
    status : str
        ``"next pass"``: run it; ``"done"``: no further pass helps, and it is the best one; ``"no gain"``: none is better than `program`.
    cutoff : float [Hz]
        Of the robustness filter.
    correction : float [m]
        Largest displacement of the path.
    lines : int
        Short lines in the written program.
    left : dict of str to list of int
        Lines of the cutting moves that stay as programmed, by the reason.
    findings : tuple of Finding
    """

    ROWS = "passes"
    json_derived: ClassVar = ("gain",)

    program: str
    out: str
    position: str
    axes: tuple[str, ...]
    not_repeating: float | None
    passes: tuple[PassFigures, ...]
    best: int
    written: int
    status: str
    cutoff: float
    correction: float
    lines: int
    left: dict[str, list[int]]
    findings: tuple[Finding, ...]
    writer: Callable[[Precompensated], None] | None = field(default=None, metadata=HIDDEN, repr=False)

    def _charts(self) -> Iterator[Chart]:
        numbers = np.array([each.number for each in self.passes], dtype=float)
        figures = {name: (numbers, 1e6 * np.array([getattr(each, name) for each in self.passes])) for name in ("largest", "rms")}
        yield traces_chart("passes", self.program, ("pass", "contour error [um]"), figures, level=None)

    def save(self, folder: str | Path = "corrected.ngc") -> Precompensated:
        """Write the program of the next pass, if it helps, and what was learned.

        Parameters
        ----------
        folder : str or Path
            File of the program.

        Returns
        -------
        Precompensated
            With the name of its file.

        Raises
        ------
        OutputError
            If a file cannot be written.
        """
        saved = replace(self, out=str(folder) if self.written else "")
        assert self.writer is not None
        self.writer(saved)
        return saved

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Check the program."""
        settings = asked.settings
        how = [*settings.words_of(Planned), *settings.words_of(Dialect)]
        return ["check", self.out, "--machine", settings.machine, *how] if self.written else None

    @property
    def gain(self) -> float | None:
        """Rms error of the program itself over that of the best pass."""
        best = self.passes[self.best].rms
        return self.passes[0].rms / best if best else None

    @property
    def passed(self) -> bool:
        """Whether a program was written and no finding is an error."""
        return self.written > 0 and all(one.entry.severity != "error" for one in self.findings)

    @property
    def text(self) -> str:
        """What does not repeat, the passes, and what was written; if nothing was, this first."""
        repeats = "unknown from one run" if self.not_repeating is None else f"{figure(self.not_repeating, 'um')} rms"
        heads = ("pass", "rms [um]", "largest [um]", "in line", "share", "cycle time [s]", "change")
        rows = (
            (
                *(str(one.number), f"{1e6 * one.rms:.2f}", f"{1e6 * one.largest:.1f}"),
                *(str(one.line), f"{100.0 * one.share:.1f} %", f"{one.duration:.3f}"),
                f"{100.0 * (one.duration / self.passes[0].duration - 1.0):+.2f} %",
                "best" if one.number == self.best else "" if one.in_time else "too slow",
            )
            for one in self.passes
        )
        table = Table([*map(Column, heads), Column("", left=True)], rows=rows)
        lines = [f"does not repeat: {repeats}", f"position: {self.position}, axes {', '.join(self.axes)}", "", table.text(), ""]
        place = self.passes[self.best].place
        at = ", ".join(f"{axis.upper()} {figure(round(value, 7), 'mm')}" for axis, value in zip(self.axes, place, strict=True))
        within = figure(1.0 / self.cutoff, "ms")
        rule = f"Share: of the squared error, from within {within} around it. Best: the least sum of rms and largest, each over pass 0."
        lines.append(paragraphs([f"The largest error of pass {self.best} lies at {at}. {rule}"]))
        if self.written:
            size, cutoff = figure(self.correction, "um"), figure(self.cutoff, "Hz")
            what = f"{self.lines} lines, path displaced by up to {size}, filtered at {cutoff}"
            lines += ["", paragraphs([f"written: {self.out}, pass {self.written}: {what}"])]
        else:
            lines.insert(0, "No pass is better than the program itself: nothing is written.\n")
        first, more = (
            paragraphs(str(one) for one in self.findings if (one.code in ("CL919", "CL929")) == at_top) for at_top in (True, False)
        )
        return "\n".join([*([first, ""] if first else []), *lines, *(["", more] if more else [])])


# --- the question ---


@question(Precompensate)
def precompensate(part: str | Path, *, settings: Precompensate, session: Session = QUIET) -> Precompensated:
    """Correct a part program by the contour error that repeats: from the logs of one pass, or by simulating pass after pass.

    Parameters
    ----------
    part : str or Path
        The program as it was before any correction.

    Returns
    -------
    Precompensated

    Raises
    ------
    ProgramError, LogError, ResultError, FeedError
        If a file cannot be read, a log does not follow the program, or the program cannot be planned.
    DivergenceError
        If a simulated loop diverges.
    ParameterError
        If an option is out of range.
    """
    reading = reading_of(part, settings)
    given = [Path(part), *settings.files(*settings.log)]
    if session.saving:
        check_file(session.folder, given, "--out")
    if not settings.log:
        return _simulated(Path(part), settings, reading, session)
    if settings.passes is not None:
        check_file(settings.passes / "passes", given, "--passes")
    machine = None if settings.machine is None else machine_of(settings.machine, settings.plugin)
    opened = [open_run(log, settings.of_log(k, len(settings.log)), machine) for k, log in enumerate(settings.log)]
    measured, axes, _ = opened[0]
    if any(other[1] != axes for other in opened):
        raise ParameterError("--log", "axes differ", f"logs of the axes {', '.join(axes)}")
    work = Work(Path(part), axes, settings, reading, measured.period)
    digests = tuple(digest_of(content_of(log)) for log in settings.log)
    if settings.passes is not None:
        work.resume(settings.passes)
        if used := [log for log, digest in zip(settings.log, digests, strict=True) if digest in work.passes.logs]:
            raise ParameterError("--log", str(used[0]), "the log of the last written pass: this one was used before")
    runs = [work.run(one) for one, _, _ in opened]
    rest = spread(runs)
    reading_findings = {str(one): one for _, _, log in opened for one in log.findings}
    findings = [*reading_findings.values(), *_log_findings(measured, runs[0], rest, machine)]
    findings += work.learn(measured, runs)
    findings += work.settle(runs[0], measured)
    work.passes = replace(work.passes, logs=(*work.passes.logs, *digests))
    proceed = work.passes.helps
    if proceed:
        findings += work.propose()
    if settings.passes is not None:
        spared(settings.passes / f"pass-{len(work.passes.written)}.ngc", given, "--passes")
    return work.result(session.folder, measured.source, rest, findings, proceed, settings.passes)


def _log_findings(measured: Measured, run: Run, rest: float | None, machine: Machine | None) -> list[Finding]:
    findings = []
    if rest is not None and rest > run.rms / 3.0:
        findings.append(finding("CL906", rest=rest, rms=run.rms))
    if measured.source == "motor":
        findings.append(finding("CL907"))
    elif measured.source == "motor and model" and machine is not None:
        findings.append(finding("CL908", machine=machine.name))
    return findings


def _simulated(part: Path, settings: Precompensate, reading: Reading, session: Session) -> Precompensated:
    """Simulate pass after pass."""
    parts = {name: getattr(settings, name) for name in ("machine", "controller", "dialect", "plugin", "planner")}
    scenario = scenario_of(part, options.Run(**parts, no_require_end=True))
    machine, controller = scenario.machine, scenario.controller
    axes = tuple(axis for axis in machine.axis_names if axis in "xyz")
    work = Work(part, axes, settings, reading, machine.servo_period)
    findings = list(about_planner(machine))
    rest: float | None = None
    stages = session.stages()
    stages.expect(settings.repeat + 1)

    def probe(text: str) -> Measured:
        return simulated(parse_blocks(text, part.name, work.reading, axes).program, machine, controller, settings.seed, 0)

    for k in range(settings.repeat + 1):
        stages.begin(f"pass {k}")
        numbers = (0, 1) if k == 0 else (k + 1,)
        trials = [simulated(work.driven.source.program, machine, controller, settings.seed, trial) for trial in numbers]
        runs = [work.run(one) for one in trials]
        rest = spread(runs) if k == 0 else rest
        more = work.learn(trials[0], runs)
        last = k == settings.repeat or not work.passes.helps
        if last != work.lead_in:  # dwells are offered after the last pass, and written before
            more += work.settle(runs[0], trials[0], probe)
        if last:
            findings += more
            break
        more += work.propose()
        findings += [one for one in more if str(one) not in map(str, findings)]
    return work.result(session.folder, "model", rest, findings, proceed=False)
