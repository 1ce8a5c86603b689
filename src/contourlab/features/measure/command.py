"""``contourlab measure`` and ``contourlab compare A B``: judge and report measured runs like simulated runs."""

from __future__ import annotations

import math
import shlex
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

from contourlab.app.command_line import as_typed, chosen_options
from contourlab.app.json_values import json_values, write_json
from contourlab.app.results import staged
from contourlab.arrays import Array
from contourlab.errors import LogError, ParameterError, ResultError, UnitError
from contourlab.features.measure.log_choice import (
    LogChoice,
    distinct_names,
    is_program,
    open_log,
    positive,
    program_path,
    reference_columns,
)
from contourlab.features.measure.study import gap_findings, measure
from contourlab.features.measure.summary import MeasuredRun, MeasuredSummary
from contourlab.features.run.command import RunOutcome, check_plots, file_names
from contourlab.figures import figure
from contourlab.findings import finding
from contourlab.logs.load import about
from contourlab.units import to_si

_OF_COLUMNS = ("--column", "--columns", "--format", "--period")
"""Options that say how to read a log."""


def measure_log(
    choice: LogChoice,
    out: str | Path,
    *,
    reference: str | None = None,
    shift: str | None = None,
    tolerance: str | None = None,
    plots: Sequence[str] = (),
    command: str = "",
) -> RunOutcome:
    """Judge a log; write signals, summary.json, report.html and plots into a folder.

    Parameters
    ----------
    reference : str, optional
        Columns of the reference separated by commas, in the order of the axes; or a part program. By default the columns of that name.
    shift : str, optional
        Zero of the part program in the coordinates of the log: ``"fit"``, or lengths separated by commas.
    tolerance : str, optional
        Largest contour error that passes, as ``"25 um"``.
    plots : sequence of str
        Formats: png, svg or pdf.

    Raises
    ------
    LogError
        If the log cannot be read or lacks a signal.
    OutputError
        If the folder cannot be written to.
    """
    check_plots(plots)
    limit = None if tolerance is None else positive("--tolerance", tolerance, "m", 'a length with its unit, such as "25 um"')
    run = _judged(choice, reference, shift)
    return _written([run], run.log.record.file.name, out, limit, command, plots)


def compare_runs(files: Sequence[str | Path], out: str | Path, *, plots: Sequence[str] = (), command: str = "") -> RunOutcome:
    """Judge several runs and compare them with the first.

    Parameters
    ----------
    files : sequence of str or Path
        Logs, results (.nc), or folders of results with one scheme.
    out, plots, command
        See `measure_log`.

    Raises
    ------
    LogError
        If a file cannot be read, or the axes differ.
    """
    check_plots(plots)
    judged = [_judged(LogChoice(_signals_of(Path(file)))) for file in files]
    names = _names([Path(file) for file in files])
    runs = [replace(run, name=name) for name, run in zip(names, judged, strict=True)]
    axes, path = runs[0].result.axes, runs[0].reference.path
    for i, run in enumerate(runs[1:], 1):
        if run.result.axes != axes:
            message = f"has axes {', '.join(run.result.axes)}, but {runs[0].name} has {', '.join(axes)}"
            raise LogError(message, file=run.log.record.file)
        if run.reference.path.digest != path.digest:
            runs[i] = replace(run, findings=(*run.findings, finding("CL413", first=runs[0].name)))
    return _written(runs, " and ".join(names), out, None, command, plots)


def _judged(choice: LogChoice, reference: str | None = None, shift: str | None = None) -> MeasuredRun:
    program = reference if reference is not None and is_program(reference) else None
    more = reference_columns(reference, choice) if reference is not None and program is None else ()
    log = open_log(choice, more)
    axes = tuple(choice.axes)
    path = program_path(program, axes or log.result.axes) if program else None
    with about(choice.file):
        try:
            measured = measure(log.result, path, axes or None, shift=_shift(shift, axes or log.result.axes))
        except ResultError as error:
            raise ResultError("; ".join([str(error), *(doubt.text for doubt in log.doubtful)])) from error
    findings = (*log.findings, *measured.findings, *gap_findings(log, measured, of_samples=path is None))
    given: dict[str, Any] = vars(measured) | {"name": log.result.scheme, "findings": findings}
    return MeasuredRun(**given, log=log, inputs=(*choice.files, *([program] if program else [])))


def _shift(text: str | None, axes: tuple[str, ...]) -> Array | Literal["fit"] | None:
    if text is None or text == "fit":
        return text  # type: ignore[return-value]  # the literal
    wanted = f'"fit", or a length for each of {", ".join(axes)}, such as "{", ".join("10 mm" for _ in axes)}"'
    lengths = text.split(",")
    if len(lengths) != len(axes):
        raise ParameterError("--shift", repr(text), wanted)
    try:
        return np.array([to_si(length.strip(), "m") for length in lengths])
    except UnitError as error:
        raise ParameterError("--shift", repr(text), wanted) from error


def _signals_of(path: Path) -> Path:
    """Return the file of signals in a folder of results, or the file itself."""
    if not path.is_dir():
        return path
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


def _written(
    runs: Sequence[MeasuredRun], title: str, out: str | Path, limit: float | None, command: str, plots: Sequence[str]
) -> RunOutcome:
    files = file_names([run.name for run in runs])
    outputs = ("summary.json", "report.html", *(f"signals/{name}.nc" for name in files.values()))
    passed = None if limit is None else all(run.metrics.contour_error.max <= limit for run in runs)
    with staged(out, *outputs, inputs=[file for run in runs for file in run.inputs]) as folder:
        for run in runs:
            run.result.save(folder / "signals" / f"{files[run.name]}.nc")
        summary: dict[str, Any] = json_values(MeasuredSummary(title, command, limit, passed, {run.name: run for run in runs}))
        write_json(folder / "summary.json", summary)
        step = _next_step(runs, limit, command)
        table = _report(runs, title, limit, folder, command, plots, step)
    return RunOutcome(passed is not False, summary, f"{table}\nreport: {Path(out) / 'report.html'}\n\nnext: {step[1]}")


def _next_step(runs: Sequence[MeasuredRun], limit: float | None, command: str) -> tuple[str, str]:
    """Return what to do next, and the command for it: judge the worst run against a tolerance, or identify its worst axis."""
    worst = max(runs, key=lambda run: run.metrics.contour_error.max)
    typed = shlex.split(command) if len(runs) == 1 else ["contourlab", "measure", str(worst.log.record.file)]
    if limit is None:
        twice = 2e6 * worst.metrics.contour_error.max
        return "Judge it against a tolerance:", as_typed([*typed, "--tolerance", f"{float(f'{twice:.1g}'):g} um"])
    errors = [math.inf if math.isnan(one.rms) else one.rms for one in worst.metrics.tracking_error]
    axis = worst.result.axes[errors.index(max(errors))]
    model = "rigid" if "force" in worst.log.result else "first-order"
    words = ["contourlab", "identify", typed[2], "--model", model, "--axis", axis, *chosen_options(typed, *_OF_COLUMNS)]
    return "Identify the axis that strays most:", as_typed(words)


def _report(
    runs: Sequence[MeasuredRun], title: str, limit: float | None, folder: Path, command: str, plots: Sequence[str], step: tuple[str, str]
) -> str:
    """Write report and plots; return the text for the terminal."""
    from contourlab.rendering.data import Provenance, ReportData
    from contourlab.rendering.html import write_html
    from contourlab.rendering.page_tables import reversal_text
    from contourlab.rendering.tables import comparison_text

    notes = [str(note) if len(runs) == 1 else f"{run.name}: {note}" for run in runs for note in run.findings]
    about_runs: dict[str, Any] = {"tolerance": limit, "notes": notes, "is_measured": True, "next_steps": [step]}
    data = ReportData(title, runs, Provenance(command, command), **about_runs)
    write_html(data, folder / "report.html")
    if plots:
        from contourlab.rendering.plots import write_plots

        write_plots(data, folder / "plots", tuple(plots))
    reversals = reversal_text(data)
    lines = [comparison_text(data).rstrip(), *([f"\n{reversals}"] if reversals else [])]
    return "\n".join([*lines, *(line for run in runs for line in _lines(run, limit))])


def _lines(run: MeasuredRun, limit: float | None) -> list[str]:
    result, error = run.result, run.metrics.contour_error
    lines = [f"{run.name}: read as {run.log.record.format}, {result.n_sample} samples every {figure(result.servo_period, 'us', 6)}"]
    if run.shift is not None:
        shifts = (f"{axis} {figure(value, 'mm', 6)}" for axis, value in run.shift.items())
        lines.append(f"path shifted by {', '.join(shifts)}")
    if limit is not None:
        verdict = "PASS" if error.max <= limit else "FAIL"
        where = f"at t = {error.worst.time:.4g} s"
        lines.append(f"{verdict}, largest contour error {figure(error.max, 'um')}, tolerance {figure(limit, 'um')}, {where}")
    return lines
