"""``contourlab measure`` and ``contourlab compare A B``: judge and report measured runs like simulated runs."""

from __future__ import annotations

import math
import shlex
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, ClassVar, Literal

import numpy as np

from contourlab import __version__
from contourlab.app.command_line import as_typed
from contourlab.app.results import staged
from contourlab.app.session import QUIET, Session, question
from contourlab.arrays import Array, Index
from contourlab.errors import LogError, ParameterError, ResultError, refuse, refused
from contourlab.features.check.program_check import origin_of
from contourlab.features.check.reading import read_once
from contourlab.features.measure.log_choice import (
    distinct_names,
    is_program,
    open_log,
    program_of,
    read_again,
    reference_columns,
)
from contourlab.features.measure.options import Measure
from contourlab.features.measure.study import Measured, gap_findings, move_findings
from contourlab.features.measure.study import measure as judged_log
from contourlab.features.run.command import SCHEMA, JudgedRuns, Runs, compare_schemes, ending, file_names
from contourlab.features.run.options import Compare
from contourlab.feed.reference import RAPIDS
from contourlab.feed.route import Route
from contourlab.figures import figure, limit_to_propose
from contourlab.findings import finding
from contourlab.logs.load import Log, about
from contourlab.program import Reading
from contourlab.rendering.data import Provenance, ReportData
from contourlab.rendering.table import paragraphs
from contourlab.result import Result
from contourlab.scenario.load import machine_of, reading_on
from contourlab.scenario.placing import zero_known
from contourlab.units import to_si


@dataclass(frozen=True, eq=False, kw_only=True)
class MeasuredRun(Measured):
    """One measured run.

    Listed are the keys of its JSON, see `json_form`; its Python attributes are those of `JudgedRun`.

    Attributes
    ----------
    file : Path
        The log.
    format : str
        Format of the log.
    servo_period : float [s]
    shift : mapping of str to float [m], or None
        Shift of the path in the coordinates of the log, by axis; null without one.
    verdict : Verdict or None
        Null without a tolerance. Its causes are what a log shows of them.
    circles : tuple of CircleFigures
        Each full circle of the path, with the figures of ISO 230-4.
    clock : mapping of str to ClockReport
        Clock by column.
    columns : tuple of Column
        Columns used.
    notes : tuple of str
        Texts of the findings.
    """

    json_form: ClassVar = {
        "file": "log.record.file",
        "format": "log.record.format",
        "axes": "result.axes",
        "servo_period": "result.servo_period",
        "n_sample": "result.n_sample",
        "shift": "shift",
        "metrics": "metrics",
        "verdict": "verdict",
        "circles": "circles",
        "reversals": "spikes",
        "reversal_figures": "reversal_figures",
        "clock": "log.clocks",
        "columns": "log.columns",
        "notes": "notes",
        "findings": "findings",
    }

    log: Log
    inputs: tuple[str | Path, ...]
    program: tuple[str, ...] = ()

    @property
    def notes(self) -> tuple[str, ...]:
        """Texts of the findings."""
        return tuple(finding.text for finding in self.findings)


@dataclass(frozen=True, eq=False)
class MeasuredRuns(JudgedRuns):
    """Judged measured runs.

    Attributes
    ----------
    runs : tuple of MeasuredRun
    machine : dict of str to object, or None
        Of --machine: name, and of a control's own file the control and the origin of each number.
    tolerance : float or None [m]
    command : str
        The command that does the same.
    files : dict of str to str
        What was saved, and where.
    version : str
        Version of contourlab.
    """

    ROW = "run"
    json_form: ClassVar = {"name": "title"} | {
        name: name for name in ("command", "machine", "tolerance", "passed", "schemes", "schema", "version")
    }

    title: str
    runs: tuple[MeasuredRun, ...]
    tolerance: float | None
    command: str
    machine: Mapping[str, Any] | None = None
    files: Mapping[str, str] = field(default_factory=dict)
    schema: str = SCHEMA
    version: str = __version__

    @property
    def passed(self) -> bool | None:
        """Whether each run is within the tolerance; None without one."""
        verdicts = [run.verdict.passed for run in self.runs if run.verdict is not None]
        return all(verdicts) if verdicts else None

    @property
    def schemes(self) -> dict[str, MeasuredRun]:
        """The runs by name."""
        return {run.name: run for run in self.runs}

    @property
    def data(self) -> Any:
        """The data of the report."""
        about_runs: dict[str, Any] = {"tolerance": self.tolerance, "is_measured": True, "next_steps": self._steps}
        return ReportData(self.title, self.runs, Provenance(self.command, self.command), self.runs[0].program, **about_runs)

    @property
    def text(self) -> str:
        """Verdict, tables, and findings; files and the next command once it is saved."""
        from contourlab.rendering.comparison import comparison_text
        from contourlab.rendering.lead import answer
        from contourlab.rendering.page_tables import reversal_text

        data = self.data
        answers = paragraphs([f"{run.name}: {answer(run)}" for run in self.runs if run.verdict is not None])
        ends = paragraphs([line for run in self.runs for line in (*_read(run), *ending(run))])
        files = [f"{what}: {file}" for what, file in self.files.items()]
        written = "\n".join([*files, *(f"\nnext: {typed}" for _, typed in self._steps if files)])
        return "\n\n".join(filter(None, [answers, comparison_text(data).rstrip(), reversal_text(data), ends, written]))

    @property
    def _steps(self) -> list[tuple[str, str]]:
        """What to do next, and the command for it: judge the worst run against a tolerance, or identify its worst axis if it fails."""
        worst = max(self.runs, key=lambda run: run.metrics.part_error.max)
        if self.passed or not self.command or worst.metrics.judged.basis == RAPIDS:
            return []
        typed = shlex.split(self.command) if len(self.runs) == 1 else ["contourlab", "measure", str(worst.log.record.file)]
        if self.tolerance is None:
            limit = limit_to_propose(2.0 * worst.metrics.part_error.max)
            return [("Judge it against a tolerance:", as_typed([*typed, "--tolerance", limit]))]
        errors = [math.inf if math.isnan(one.rms) else one.rms for one in worst.metrics.tracking_error]
        axis = worst.result.axes[errors.index(max(errors))]
        known = worst.log.result
        driven = "command" in known and known.signals["command"].unit != "m"
        model = "rigid" if "force" in known else "first-order" if driven else "position-loop"
        words = ["contourlab", "identify", typed[2], "--model", model, "--axis", axis, *read_again(typed)]
        return [("Identify the axis that strays most:", as_typed(words))]

    def save(self, folder: str | Path = "results", *, plots: Sequence[str] = (), **_: Any) -> MeasuredRuns:
        """Write signals, summary.json, report.html and plots into a folder.

        Parameters
        ----------
        folder : str or Path
        plots : sequence of str
            Formats: png, svg or pdf.

        Returns
        -------
        MeasuredRuns
            With the names of its files.

        Raises
        ------
        OutputError
            If the folder cannot be written to.
        """
        files = file_names([run.name for run in self.runs])
        with staged(folder, *_outputs(self.runs), inputs=[file for run in self.runs for file in run.inputs]) as stage:
            for run in self.runs:
                attributes = {**run.result.attributes, "judged": run.metrics.judged.text}
                replace(run.result, attributes=attributes).save(stage / "signals" / f"{files[run.name]}.nc")
            self._write(stage, plots)
        return replace(self, files={"report": str(Path(folder) / "report.html")})


def _outputs(runs: Sequence[MeasuredRun]) -> list[str]:
    """Return the files of a saved answer, the summary first."""
    names = file_names([run.name for run in runs])
    return ["summary.json", "report.html", *(f"signals/{name}.nc" for name in names.values())]


@question(Measure)
def measure(log: str | Path | Log, *, settings: Measure, session: Session = QUIET) -> MeasuredRuns:
    """Judge a measured run with the figures of a simulated one.

    Parameters
    ----------
    log : str, Path or Log
        A log of a machine, or a result.

    Returns
    -------
    MeasuredRuns

    Raises
    ------
    LogError
        If the log cannot be read or lacks a signal.
    """
    run = _judged(log, settings)
    session.will_write(run.inputs, *_outputs([run]))
    machine = None if run.machine is None else {"name": run.machine.name, **origin_of(run.machine)}
    return MeasuredRuns(run.log.record.file.name, (run,), settings.si("tolerance"), session.command, machine)


@question(Compare)
def compare(*files: Any, settings: Compare, session: Session = QUIET) -> Runs | MeasuredRuns:
    """Run the schemes of a scenario side by side, and time the servo tick of each; or compare finished runs with the first.

    Parameters
    ----------
    *files : str, Path or Scenario
        A scenario, as a file or read; or at least two finished runs: logs, results (.nc), or folders of results with one scheme.

    Returns
    -------
    Runs or MeasuredRuns

    Raises
    ------
    ScenarioError, LogError, ParameterError
        If a file cannot be read, the axes of the runs differ, or an option is for a scenario only.
    """
    only = "finished runs" if len(files) == 1 else "a scenario"
    for name, part in Compare.PARTS.items():
        if getattr(settings, name) != part.default and (name in ("program", "tolerance")) == (len(files) == 1):
            raise ParameterError(part.typed, "given", f"omitted: it applies to {only} only")
    if len(files) == 1:
        return compare_schemes(files, settings, session)
    judged = [_judged(_signals_of(file), Measure(program=settings.program, tolerance=settings.tolerance)) for file in files]
    names = _names([Path(file) for file in files])
    runs = [replace(run, name=name) for name, run in zip(names, judged, strict=True)]
    axes, path = runs[0].result.axes, runs[0].reference.path
    for i, run in enumerate(runs[1:], 1):
        if run.result.axes != axes:
            message = f"has axes {', '.join(run.result.axes)}, but {runs[0].name} has {', '.join(axes)}"
            raise LogError(message, file=run.log.record.file)
        if run.reference.path.digest != path.digest:
            runs[i] = replace(run, findings=(*run.findings, finding("CL413", first=runs[0].name)))
    session.will_write([file for run in runs for file in run.inputs], *_outputs(runs))
    return MeasuredRuns(" and ".join(names), tuple(runs), settings.si("tolerance"), session.command)


def _judged(file: str | Path | Log, settings: Measure) -> MeasuredRun:
    settings = read_once(settings)
    reference, axes, program = settings.reference, settings.axes, settings.program
    if reference is not None and is_program(reference):
        if program is not None:
            raise ParameterError("--reference", reference, f"columns of the log: --program {program} is the part program")
        program, reference = Path(reference), None
    machine = None if settings.machine is None else machine_of(settings.machine)
    log = open_log(file, settings, () if reference is None else reference_columns(reference, settings.column, axes))
    axes, text, route, floating = axes or log.result.axes, None, None, False
    reading = Reading(require_end=False) if machine is None else reading_on(machine, {"require_end": False})
    if program is not None:
        text, route = program_of(program, axes, reading)
        floating = machine is not None and log.record.format != "contourlab" and not zero_known(machine, reading)
    lines, fixed = () if text is None else text.lines, [] if text is None else [line for line, _ in text.machine_points]
    shift, known, fit = _shift(settings.shift or ("fit" if floating else None), axes), None, None
    with about(file):
        try:
            if isinstance(shift, str) and route is not None and fixed and log.lines is not None:
                fit = _fitted(log.result, route, axes, log.lines, fixed)
                shift = np.array([(fit.shift or {})[axis] for axis in axes])
            if isinstance(shift, np.ndarray) and program is not None and fixed and reading.parameters is None:
                known, shift = dict(zip(axes, shift.tolist(), strict=True)), None
                _, route = program_of(program, axes, _with_zero(reading, known))
            given: dict[str, Any] = {"lines": log.lines, "rapid": log.rapid, "tolerance": settings.si("tolerance"), "program": lines}
            measured = judged_log(log.result, route, axes, shift=shift, **given)
        except ResultError as error:
            hints = [f"line {line} moves in machine coordinates: give the zero of the part with --shift" for line in fixed[:1]]
            hints = hints if known is None and log.lines is None else []
            raise ResultError("; ".join([str(error), *hints, *(doubt.text for doubt in log.doubtful)])) from error
    findings = (*log.findings, *measured.findings, *gap_findings(log, measured, of_samples=route is None), *move_findings(log, measured))
    findings += tuple(one for one in fit.findings if one.code == "CL406") if fit is not None else ()
    steps = [axis.name for axis in machine.axes if axis.drive.kind == "step-generator"] if machine is not None else []
    if steps and "axis_position" not in log.result:
        findings = (finding("CL415", axes=steps), *findings)
    given = vars(measured) | {"name": log.result.scheme, "findings": findings, "machine": machine}
    given |= {} if known is None else {"shift": known}
    return MeasuredRun(**given, log=log, inputs=settings.files(file, *([program] if program else [])), program=lines)


def _fitted(result: Result, route: Route, axes: tuple[str, ...], lines: Index, fixed: Sequence[int]) -> Measured:
    """Fit the zero of a program to the log up to its first move in machine coordinates, in lines `fixed`, after the first cut."""
    cut = int(np.argmax(lines == route.source_line[int(np.argmin(route.rapid))]))
    stop = cut + next(iter(np.flatnonzero(np.isin(lines[cut:], fixed)).tolist()), len(lines) - cut)
    return judged_log(result.window(0, stop), route, axes, shift="fit", lines=lines[:stop])


def _with_zero(reading: Reading, zero: Mapping[str, float]) -> Reading:
    """Return how to read a program whose zero [m] is known: unlike the part, moves in machine coordinates stay where they are."""
    unit = to_si(f"1 {reading.unit}", "m")
    return replace(reading, zero=",".join(f"{zero.get(letter, 0.0) / unit:.17g}" for letter in "xyz"))


def _shift(text: str | None, axes: tuple[str, ...]) -> Array | Literal["fit"] | None:
    if text is None or text == "fit":
        return text  # type: ignore[return-value]  # the literal
    wanted = f'"fit", or a length for each of {", ".join(axes)}, such as "{", ".join("10 mm" for _ in axes)}"'
    lengths = text.split(",")
    refuse(len(lengths) != len(axes), ParameterError, "--shift", repr(text), wanted)
    with refused("--shift", text, wanted):
        shift = [to_si(length.strip(), "m") for length in lengths]
    return np.array(shift)


def _signals_of(source: str | Path) -> str | Path:
    """Return the file of signals in a folder of results, or the source itself."""
    path = Path(source)
    if not path.is_dir():
        return source
    files = sorted((path / "signals").glob("*.nc"))
    if len(files) != 1:
        names = f": give one of {', '.join(str(file) for file in files)}" if files else ": it has no signals/*.nc"
        raise LogError(f"is a folder with {len(files)} runs{names}", file=path)
    return files[0]


def _names(files: Sequence[Path]) -> list[str]:
    """Return distinct names of files, without their endings where possible."""
    for candidates in ([file if file.is_dir() else file.with_suffix("") for file in files], files):
        names = distinct_names(candidates)
        if len(set(names)) == len(names):
            return names
    raise LogError("is given twice: give two different runs", file=files[0])


def _read(run: MeasuredRun) -> Iterator[str]:
    """Yield how a log was read."""
    result = run.result
    yield f"{run.name}: read as {run.log.record.format}, {result.n_sample} samples every {figure(result.servo_period, 'us', 6)}"
    if run.shift is not None:
        shifts = (f"{axis} {figure(value, 'mm', 6)}" for axis, value in run.shift.items())
        yield f"path shifted by {', '.join(shifts)}"
