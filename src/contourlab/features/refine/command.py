"""``contourlab refine``: fit machines and controllers of scenarios to measured logs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.app.results import check_file, spared, staged
from contourlab.errors import ParameterError, UnitError
from contourlab.features.measure.log_choice import LogChoice, distinct_names, open_log
from contourlab.features.measure.plausibility import motion_findings, same_column_findings
from contourlab.features.refine.cross_validation import CrossValidation, cross_validated
from contourlab.features.refine.log_run import Agreement, LogRun, log_run
from contourlab.features.refine.study import Refined, RefineSettings, Window, refine, unseen_findings
from contourlab.features.run.command import check_plots
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.logs.load import about
from contourlab.rendering import plots
from contourlab.rendering.charts import traces_chart
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import write_text_atomic
from contourlab.units import to_si

if TYPE_CHECKING:
    from contourlab.scenario import Scenario


@dataclass(frozen=True, eq=False)
class Refinement:
    """Output of the command; as JSON field by field.

    Attributes
    ----------
    validation_before, validation : tuple of Agreement
        Agreement with a log that was not fitted, with the first run's machine and controller at the start and refined.
    cross_validation : CrossValidation or None
        Prediction of each run from the others; None for one log.
    machine_file : Path or None
        The file that was written, if any.
    """

    logs: tuple[str, ...]
    result: Refined
    validation_before: tuple[Agreement, ...]
    validation: tuple[Agreement, ...]
    cross_validation: CrossValidation | None
    findings: tuple[Finding, ...]
    machine_file: Path | None
    controller_files: tuple[Path, ...]
    plots: tuple[Path, ...]

    def text(self) -> str:
        """Return the tables, the findings, and the files written."""
        parts = [self._parameters().text(), self._agreements().text(), self._held_out(), paragraphs(map(str, self.findings))]
        files = [f"machine: {self.machine_file}"] if self.machine_file is not None else []
        if not files and all(one.code != "CL565" for one in self.findings):
            files = ["no machine file: name one with --write"]
        files += [f"controller: {file}" for file in self.controller_files] + [f"plot: {file}" for file in self.plots]
        return "\n\n".join(filter(None, [*parts, "\n".join(files)]))

    def _parameters(self) -> Table:
        heads = ("start", "refined", "deviation", "deviation for a white residual")
        table = Table([Column("parameter", left=True), *map(Column, heads)])
        for parameter in self.result.parameters:
            sought = parameter.sought
            values = (sought.shown(sought.variable.value), sought.shown(parameter.value))
            table.add(sought.label, *values, sought.shown(parameter.deviation, 2), sought.shown(parameter.white_deviation, 2))
        return table

    def _agreements(self) -> Table:
        """Return the table of how well the simulation follows the logs."""
        result = self.result
        groups = {"before": result.before, "fitted": result.after, "unseen before": result.unseen_before, "unseen": result.unseen}
        groups |= {"validation before": self.validation_before, "validation": self.validation}
        left = ("samples", "run", "axis", "signal")
        table = Table([*(Column(head, left=True) for head in left), *map(Column, ("explained", "fit", "residual rms"))])
        for name, agreements in groups.items():
            for one in agreements:
                rms = figure(one.rms, "um" if one.signal == "position" else "")
                table.add(name, one.run, one.axis, one.signal, figure(one.explained, "%", 5), figure(one.fit / 100.0, "%", 4), rms)
        return table

    def _held_out(self) -> str:
        """Return the table of the runs that were left out in turn; empty if there is none."""
        if self.cross_validation is None:
            return ""
        heads = ("error rms measured", "simulated", "maximum measured", "simulated")
        table = Table([Column("left out", left=True), *map(Column, heads)])
        for one in self.cross_validation.held_out:
            values = (one.measured_rms, one.simulated_rms, one.measured_max, one.simulated_max)
            table.add(one.run + (", second half" if one.second_half else ""), *(figure(value, "um") for value in values))
        return table.text()


def refine_logs(
    scenarios: Sequence[str | Path],
    choices: Sequence[LogChoice],
    parameters: Sequence[str],
    *,
    windows: Sequence[str] = (),
    validation: LogChoice | None = None,
    starts: int = 3,
    plugins: Sequence[str | Path] = (),
    out: str | Path | None = None,
    plots: Sequence[str] = (),
    folder: str | Path = "results",
    progress: Callable[[str], None] = lambda line: None,
) -> Refinement:
    """Refine the parameters of scenarios against logs; write the machine and the refined controllers.

    Parameters
    ----------
    scenarios : sequence of str or Path
        One for all logs, or one for each.
    parameters : sequence of str
        Dotted names or their ends, ``*`` for anything; with a range as ``"axes.x.friction.coulomb=50 N..200 N"``.
    windows : sequence of str
        Times to fit, as ``"0.8 s..1.6 s"``: one window for all logs, or one for each. Motion outside the windows tests the fit.
    validation : LogChoice, optional
        A log that is not fitted, simulated with the first scenario.
    starts : int
        Number of descents.
    out : str or Path, optional
        Machine file; controllers get files in the same folder. Nothing is written if the result is not usable.
    plots : sequence of str
        Formats: png, svg or pdf. Plots go to ``plots`` in `folder`; other files there stay.
    progress : callable, optional
        Called with a line after each descent.

    Raises
    ------
    LogError, ResultError, ScenarioError
        If a file cannot be read or is incomplete.
    ParameterError
        If an option is out of range, or the run at the start diverges.
    OutputError
        If `out` or `folder` cannot be written; raised before anything is simulated.
    """
    check_plots(plots)
    if len(scenarios) not in (1, len(choices)):
        raise ParameterError("--also", f"{len(scenarios)} scenarios for {len(choices)} logs", "one scenario, or one for each log")
    read = _read(scenarios, plugins)
    several = len(scenarios) > 1
    labels = _labels(scenarios if several else [choice.file for choice in choices])
    runs = [_run(read[i if several else 0], choice, label) for i, (choice, label) in enumerate(zip(choices, labels, strict=True))]
    spans = _windows(windows, len(runs))
    # Read first, so that an unreadable log fails before the work.
    held_out = None if validation is None else _run(read[0], validation, *_labels([validation.file]))
    inputs = [file for scenario in read for file in scenario.inputs] + [file for choice in choices for file in choice.files]
    inputs += [*(() if validation is None else validation.files), *map(Path, plugins)]
    if out is not None:
        check_file(out, inputs)
        for run in runs:
            spared(_beside(Path(out), run), inputs)
    drawn: list[Path] = []
    with staged(folder, inputs=inputs) if plots else nullcontext() as stage:
        result = refine(runs, parameters, windows=spans, settings=RefineSettings(starts=starts), progress=progress)
        result, crossed = cross_validated(result, progress=progress)
        validated: list[tuple[Agreement, ...]] = [(), ()]
        findings = [*result.findings]
        if held_out is not None:
            placed = (replace(held_out, machine=run.machine, controller=run.controller) for run in (runs[0], result.runs[0]))
            validated = [run.agreement(run.once()) for run in placed]
            findings += [*held_out.findings, *unseen_findings(validated[0], validated[1], validation=True)]
            if any(np.array_equal(held_out.measured, run.measured) for run in runs):
                findings.append(finding("CL564", held_out.label))
        if stage is not None:
            drawn = [Path(folder) / file.relative_to(stage) for file in draw(result, stage / "plots", plots)]
    sources = tuple(distinct_names([choice.file for choice in choices]))
    result = replace(result, findings=tuple(findings))
    controllers = _write(result, sources, Path(out)) if out is not None and result.usable else ()
    if out is not None and not result.usable:
        findings.append(finding("CL565"))
    machine_file = Path(out) if out is not None and result.usable else None
    return Refinement(sources, result, validated[0], validated[1], crossed, tuple(findings), machine_file, controllers, tuple(drawn))


def _read(files: Sequence[str | Path], plugins: Sequence[str | Path]) -> list[Scenario]:
    from contourlab.scenario import load_scenario

    return [load_scenario(file, plugins=plugins) for file in files]


def _labels(files: Sequence[str | Path]) -> list[str]:
    """Return unique labels of runs, valid in file names: names of the files, with folders where the names are equal."""
    names = [Path(name).with_suffix("").as_posix().replace("/", "-") for name in distinct_names(files)]
    return names if len(set(names)) == len(names) else [f"{name} {i + 1}" for i, name in enumerate(names)]


def _run(scenario: Scenario, choice: LogChoice, label: str) -> LogRun:
    log = open_log(choice)
    with about(choice.file):
        run = log_run(scenario.machine, scenario.controller, log.result, label)
    doubts = [replace(clock, place=": ".join(filter(None, (label, clock.place)))) for clock in log.clock_findings()]
    doubts += motion_findings(run.position, run.machine.servo_period, label)
    doubts += same_column_findings(run.machine.axis_names, run.asked, run.position, label)
    return replace(run, findings=(*run.findings, *doubts))


def _windows(texts: Sequence[str], count: int) -> list[Window | None]:
    if len(texts) not in (0, 1, count):
        raise ParameterError("--window", f"{len(texts)} windows", f"one for all logs, or one for each of the {count}")
    spans: list[Window | None] = []
    for text in texts:
        low, dots, high = text.partition("..")
        try:
            span = to_si(low.strip(), "s"), to_si(high.strip(), "s")
        except UnitError as error:
            raise ParameterError("--window", repr(text), 'two times, as "0.8 s..1.6 s"') from error
        if not dots or not span[0] < span[1]:
            raise ParameterError("--window", repr(text), 'two times, the earlier one first, as "0.8 s..1.6 s"')
        spans.append(span)
    return spans * count if len(spans) == 1 else spans


def _beside(machine: Path, run: LogRun) -> Path:
    """Return the file for the controller of a run."""
    return machine.with_name(f"{machine.stem}-{run.label}-controller.toml".replace(" ", "-"))


def _write(result: Refined, sources: Sequence[str], out: Path) -> tuple[Path, ...]:
    """Write the machine and the refined controllers; return the files of the controllers."""
    from contourlab.features.refine.files import controller_text, machine_text

    files = {out: machine_text(result, sources)}
    for i, run in enumerate(result.runs):
        if any(parameter.sought.name.startswith("controller.") and i in parameter.sought.runs for parameter in result.parameters):
            files[_beside(out, run)] = controller_text(result, i, sources)
    for file, text in files.items():
        write_text_atomic(file, text)
    return tuple(files)[1:]


def draw(refined: Refined, folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Draw each signal of each run, measured and simulated, and the residual, with the fitted window shaded; return the files."""
    charts = []
    for run, simulated, window in zip(refined.runs, refined.simulated, refined.windows, strict=True):
        time = run.times()
        # A window may reach beyond the log.
        within = None if window is None else (max(window[0], float(time[0])), min(window[1], float(time[-1])))
        marked: dict[str, Any] = {"span": within, "span_label": "fitted in the shaded window" if within else ""}
        for j, (signal, axis) in enumerate(run.channels):
            size, unit = (1e6, "um") if signal == "position" else (1.0, "")
            name = f"{'tracking error' if signal == 'position' else signal} of {axis}"
            labels = "time [s]", name + (f" [{unit}]" if unit else "")
            key = f"{run.label}-{signal}-{axis}".replace(" ", "-")
            both = {"measured": (time, size * run.measured[:, j]), "simulated": (time, size * simulated[:, j])}
            left = {"measured minus simulated": (time, size * (run.measured[:, j] - simulated[:, j]))}
            charts.append(traces_chart(key, f"{run.label}: {name}", labels, both, **marked))
            charts.append(traces_chart(f"{key}-left", f"{run.label}: residual of {name}", labels, left, **marked))
    return plots.write_charts(charts, folder, formats)
