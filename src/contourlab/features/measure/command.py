"""``contourlab measure`` and ``contourlab compare A B``: runs from files, judged and reported as simulated ones are."""

from __future__ import annotations

import json
import platform
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from contourlab import __version__
from contourlab.app.folder import staged
from contourlab.app.json_values import json_values
from contourlab.errors import LogError, ParameterError, ResultError, UnitError
from contourlab.features.measure.gap_words import gap_words
from contourlab.features.measure.log_choice import LogChoice, is_program, open_log, positive, program_path, reference_columns, told_apart
from contourlab.features.measure.study import Measured, measure
from contourlab.features.run.command import RunOutcome, check_plots, file_names
from contourlab.features.run.summary import SCHEMA
from contourlab.logs import Log
from contourlab.logs.error_context import about
from contourlab.metrics import reversal_figures
from contourlab.metrics.circles import pairs
from contourlab.result import write_text_atomic
from contourlab.units import to_si

if TYPE_CHECKING:
    from contourlab.report.data import ReportData, SchemeReport


@dataclass(frozen=True, eq=False)
class _Judged:
    """A run from a file, under the name that people know it by."""

    name: str
    log: Log
    found: Measured
    inputs: tuple[str | Path, ...]


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
    """Judge a measured log; write signals, summary.json, report.html and plots into a folder.

    Parameters
    ----------
    choice : LogChoice
    out : str or Path
    reference : str, optional
        Columns of the reference with commas between, in the order of the axes; or a part program. By default columns whose names say so.
    shift : str, optional
        Where the zero of the part program lies in the log's coordinates: ``"fit"``, or a length for each axis with commas between.
    tolerance : str, optional
        Largest contour error that passes, as ``"25 um"``.
    plots : sequence of str
        png, svg or pdf.
    command : str
        As typed.

    Raises
    ------
    LogError
        If the log cannot be read, or says too little.
    OutputError
        If the folder cannot be written to.
    """
    check_plots(plots)
    limit = None if tolerance is None else positive("--tolerance", tolerance, "m", 'a length with its unit, such as "25 um"')
    run = _judged(choice, reference, shift)
    return _written([run], run.log.record.file.name, out, limit, command, plots)


def compare_runs(files: Sequence[str | Path], out: str | Path, *, plots: Sequence[str] = (), command: str = "") -> RunOutcome:
    """Judge runs from files and lay them side by side: what changed from the first to the others.

    Parameters
    ----------
    files : sequence of str or Path
        Logs, results (.nc), or folders of results with one scheme.
    out, plots, command
        As of `measure_log`.

    Raises
    ------
    LogError
        If one cannot be read, or they have unlike axes.
    """
    check_plots(plots)
    opened = [_judged(LogChoice(_signals_of(Path(file)))) for file in files]
    names = _names([Path(file) for file in files])
    runs = [replace(run, name=name) for name, run in zip(names, opened, strict=True)]
    for run in runs[1:]:
        if run.found.result.axes != runs[0].found.result.axes:
            axes = ", ".join(runs[0].found.result.axes)
            raise LogError(f"has the axes {', '.join(run.found.result.axes)}, {runs[0].name} has {axes}", file=run.log.record.file)
    return _written(runs, " and ".join(names), out, None, command, plots)


def _judged(choice: LogChoice, reference: str | None = None, shift: str | None = None) -> _Judged:
    program = reference if reference is not None and is_program(reference) else None
    more = reference_columns(reference, choice) if reference is not None and program is None else ()
    log = open_log(choice, more)
    axes = tuple(choice.axes)
    path = program_path(program, axes or log.result.axes) if program else None
    with about(choice.file):
        try:
            found = measure(log.result, path, axes or None, shift=_shift(shift, axes or log.result.axes))
        except ResultError as error:
            raise ResultError("; ".join([str(error), *log.doubtful])) from error
    found = replace(found, notes=(*found.notes, *gap_words(log, found, of_samples=path is None)))
    inputs = (*choice.files, *([program] if program else []))
    return _Judged(log.result.scheme, log, found, inputs)


def _shift(text: str | None, axes: tuple[str, ...]) -> NDArray[np.float64] | Literal["fit"] | None:
    """Return what ``--shift`` says."""
    if text is None or text == "fit":
        return text  # type: ignore[return-value]  # nothing else is left of a text
    wanted = f'"fit", or a length for each of {", ".join(axes)}, such as "{", ".join("10 mm" for _ in axes)}"'
    words = text.split(",")
    if len(words) != len(axes):
        raise ParameterError("--shift", repr(text), wanted)
    try:
        return np.array([to_si(word.strip(), "m") for word in words])
    except UnitError as error:
        raise ParameterError("--shift", repr(text), wanted) from error


def _signals_of(path: Path) -> Path:
    """Return the signals in a folder of results, or the file itself."""
    if not path.is_dir():
        return path
    found = sorted((path / "signals").glob("*.nc"))
    if len(found) != 1:
        names = f": name one of {', '.join(str(file) for file in found)}" if found else ": it has no signals/*.nc"
        raise LogError(f"is a folder with {len(found)} runs{names}", file=path)
    return found[0]


def _names(files: Sequence[Path]) -> list[str]:
    """Return names for files: without their endings, where that tells them apart."""
    for named in ([file if file.is_dir() else file.with_suffix("") for file in files], files):
        names = told_apart(named)
        if len(set(names)) == len(names):
            return names
    raise LogError("is given twice: name two runs", file=files[0])


def _written(runs: Sequence[_Judged], title: str, out: str | Path, limit: float | None, command: str, plots: Sequence[str]) -> RunOutcome:
    files = file_names([run.name for run in runs])
    sure = ("summary.json", "report.html", *(f"signals/{name}.nc" for name in files.values()))
    with staged(out, *sure, inputs=[file for run in runs for file in run.inputs]) as folder:
        for run in runs:
            run.found.result.save(folder / "signals" / f"{files[run.name]}.nc")
        summary = _summary(runs, title, limit, command)
        write_text_atomic(folder / "summary.json", json.dumps(summary, indent=2, allow_nan=False) + "\n")
        table = _report(runs, title, limit, folder, command, plots)
    return RunOutcome(summary["passed"] is not False, summary, f"{table}\nreport: {Path(out) / 'report.html'}")


def _summary(runs: Sequence[_Judged], title: str, limit: float | None, command: str) -> dict[str, Any]:
    whole = {
        "schema": SCHEMA,
        "version": __version__,
        "name": title,
        "command": command,
        "tolerance": limit,
        "passed": None if limit is None else all(run.found.metrics.contour_error.max <= limit for run in runs),
        "schemes": {run.name: _scheme(run) for run in runs},
    }
    told: dict[str, Any] = json_values(whole)
    return told


def _scheme(run: _Judged) -> dict[str, Any]:
    log, found = run.log, run.found
    return {
        "file": str(log.record.file),
        "format": log.record.format,
        "axes": list(found.result.axes),
        "servo_period": found.result.servo_period,
        "n_sample": found.result.n_sample,
        "metrics": found.metrics.as_dict(),
        "circles": [{"name": c.name, "clockwise": c.clockwise, "radius": c.radius, **c.figures()} for c in found.circles],
        "reversal_figures": [asdict(figures) for figures in reversal_figures(found.spikes)],
        "reversals": [asdict(spike) for spike in found.spikes],
        "clock": {name: {**asdict(report), "missing": report.missing} for name, report in log.clocks.items()},
        "columns": [asdict(column) for column in log.columns],
        "notes": [*log.notes, *found.notes],
    }


def _report(runs: Sequence[_Judged], title: str, limit: float | None, folder: Path, command: str, plots: Sequence[str]) -> str:
    from contourlab.report.html import write_html
    from contourlab.report.page_tables import reversal_text
    from contourlab.report.tables import comparison_text

    data = _report_data(runs, title, limit, command)
    write_html(data, folder / "report.html")
    if plots:
        from contourlab.report.plots import write_plots

        write_plots(data, folder / "plots", tuple(plots))
    turns = reversal_text(data)
    lines = [comparison_text(data).rstrip(), *([f"\n{turns}"] if turns else [])]
    for run in runs:
        result = run.found.result
        lines.append(f"{run.name}: read as {run.log.record.format}, {result.n_sample} samples every {result.servo_period * 1e6:.6g} us")
        if limit is not None:
            error = run.found.metrics.contour_error
            verdict, largest = "PASS" if error.max <= limit else "FAIL", f"{error.max * 1e6:.3g} um against {limit * 1e6:.3g} um"
            lines.append(f"{verdict}, largest contour error {largest}, at t = {error.worst.time:.4g} s")
    return "\n".join(lines)


def _notes(runs: Sequence[_Judged]) -> list[str]:
    """Return what there is to say of how runs were read and judged; with the run's name ahead where there are several."""
    alone = len(runs) == 1
    return [note if alone else f"{run.name}: {note}" for run in runs for note in (*run.log.notes, *run.found.notes)]


def _report_data(runs: Sequence[_Judged], title: str, limit: float | None, command: str) -> ReportData:
    from contourlab.report.data import Provenance, ReportData

    system = f"{platform.system()} {platform.machine()}, Python {platform.python_version()}"
    provenance = Provenance(__version__, command, command, "", None, system)
    notes = _notes(runs)
    first = runs[0].found.reference
    notes += [f"{run.name} follows another path" for run in runs[1:] if run.found.reference.path.digest != first.path.digest]
    return ReportData(title, [_scheme_report(run) for run in runs], first.path, provenance, tolerance=limit, notes=notes, is_measured=True)


def _scheme_report(run: _Judged) -> SchemeReport:
    from contourlab.report.data import SchemeReport

    found = run.found
    return SchemeReport(
        run.name, found.result, found.metrics, circles=found.circles, spikes=found.spikes, bidirectional=pairs(found.circles)
    )
