"""``contourlab refine``: fit machines and controllers of scenarios to measured logs."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.app.results import spared, write_together
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.errors import ParameterError
from contourlab.features.measure.log_choice import distinct_names, open_log
from contourlab.features.measure.plausibility import motion_findings, same_column_findings
from contourlab.features.refine.log_run import Agreement, LogRun, log_run
from contourlab.features.refine.options import Refine
from contourlab.features.refine.study import CrossValidation, Refined, RefineSettings, Sought, cross_validated, unseen_findings
from contourlab.features.refine.study import refine as refined
from contourlab.features.run.source import Source, scenario_asked
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.logs.load import Log, about
from contourlab.logs.window import parse_window
from contourlab.loop import Axis, Machine
from contourlab.rendering.charts import Chart, traces_chart
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result.stamp import current
from contourlab.scenario import Scenario, load_scenario
from contourlab.scenario.dump import controller_table, machine_tables
from contourlab.scenario.toml_text import Noted, toml


@dataclass(frozen=True, eq=False)
class Refinement(Answer):
    """A machine and controllers, refined by logs.

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
    inputs: tuple[str | Path, ...] = field(default=(), metadata=HIDDEN, repr=False)

    @property
    def passed(self) -> bool:
        """Whether the result is usable."""
        return self.result.usable

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The parameters, one a row [SI]."""
        return [
            {"parameter": one.sought.name, "start": one.sought.variable.value, "refined": one.value, "deviation": one.deviation}
            for one in self.result.parameters
        ]

    def _charts(self) -> Iterator[Chart]:
        """Yield each signal of each run, measured and simulated, and the residual, with the fitted window shaded."""
        for run, simulated, window in zip(self.result.runs, self.result.simulated, self.result.windows, strict=True):
            time = run.times()
            # A window may reach beyond the log.
            within = None if window is None else (max(window[0], float(time[0])), min(window[1], float(time[-1])))
            marked: dict[str, Any] = {"span": within, "span_label": "fitted in the shaded window" if within else ""}
            for (signal, axis), measured, got in zip(run.channels, run.measured.T, simulated.T, strict=True):
                size, unit = (1e6, "um") if signal == "position" else (1.0, "")
                name = f"{'tracking error' if signal == 'position' else signal} of {axis}"
                labels = "time [s]", name + (f" [{unit}]" if unit else "")
                key = f"{run.label}-{signal}-{axis}".replace(" ", "-")
                both = {"measured": (time, size * measured), "simulated": (time, size * got)}
                left = {"measured minus simulated": (time, size * (measured - got))}
                yield traces_chart(key, f"{run.label}: {name}", labels, both, **marked)
                yield traces_chart(f"{key}-left", f"{run.label}: residual of {name}", labels, left, **marked)

    def save(self, folder: str | Path = "results", *, write: str | Path | None = None, plots: Sequence[str] = ()) -> Refinement:
        """Write the machine and the refined controllers, if the result is usable, and pictures.

        Parameters
        ----------
        folder : str or Path
            Of the pictures, in ``plots``; other files there stay.
        write : str or Path, optional
            Machine file; controllers get files in the same folder.
        plots : sequence of str
            Formats: png, svg or pdf.

        Returns
        -------
        Refinement
            With the names of its files.

        Raises
        ------
        OutputError
            If a file cannot be written.
        """
        saved = replace(self, plots=self._put(folder, plots, self.inputs))
        if write is None:
            return saved
        if not self.result.usable:
            return replace(saved, findings=(*self.findings, finding("CL565")))
        return replace(saved, machine_file=Path(write), controller_files=_write(self.result, self.logs, Path(write)))

    def _next(self, asked: Asked) -> Sequence[object]:
        """Write the machine, or find what the error depends on."""
        return asked.again("--write", "machine.toml") if asked.files.write is None else ["sensitivity", *asked.given]

    @property
    def text(self) -> str:
        """The tables, the findings, and the files written."""
        parts = [self._parameters().text(), self._agreements().text(), self._held_out(), paragraphs(map(str, self.findings))]
        files = [f"machine: {self.machine_file}"] if self.machine_file is not None else []
        if not files and all(one.code != "CL565" for one in self.findings):
            files = ["no machine file: name one with --write"]
        files += [f"controller: {file}" for file in self.controller_files] + [f"plot: {file}" for file in self.plots]
        return "\n\n".join(filter(None, [*parts, "\n".join(files)]))

    def _parameters(self) -> Table:
        heads = ("start", "refined", "deviation", "deviation for a white residual")
        rows = []
        for parameter in self.result.parameters:
            shown, start = parameter.sought.shown, parameter.sought.variable.value
            deviations = shown(parameter.deviation, 2), shown(parameter.white_deviation, 2)
            rows.append((parameter.sought.label, shown(start), shown(parameter.value), *deviations))
        return Table([Column("parameter", left=True), *map(Column, heads)], rows=rows)

    def _agreements(self) -> Table:
        """Return the table of how well the simulation follows the logs."""
        result = self.result
        groups = {"before": result.before, "fitted": result.after, "unseen before": result.unseen_before, "unseen": result.unseen}
        groups |= {"validation before": self.validation_before, "validation": self.validation}
        left = ("samples", "run", "axis", "signal")
        rows = (
            (
                *(name, one.run, one.axis, one.signal, figure(one.explained, "%", 5), figure(one.fit / 100.0, "%", 4)),
                figure(one.rms, "um" if one.signal == "position" else ""),
            )
            for name, agreements in groups.items()
            for one in agreements
        )
        return Table([*(Column(head, left=True) for head in left), *map(Column, ("explained", "fit", "residual rms"))], rows=rows)

    def _held_out(self) -> str:
        """Return the table of the runs that were left out in turn; empty if there is none."""
        if self.cross_validation is None:
            return ""
        heads = ("error rms measured", "simulated", "maximum measured", "simulated")
        rows = []
        for one in self.cross_validation.held_out:
            values = (one.measured_rms, one.simulated_rms, one.measured_max, one.simulated_max)
            rows.append((one.run + (", second half" if one.second_half else ""), *(figure(value, "um") for value in values)))
        return Table([Column("left out", left=True), *map(Column, heads)], rows=rows).text()


@question(Refine)
def refine(*source: Source, settings: Refine, session: Session = QUIET) -> Refinement:
    """Fit parameters of a scenario's machine and controller until the simulation follows logs.

    Parameters
    ----------
    *source : str, Path, Scenario, Case, or a Machine, its Controller and a Reference
        A scenario, of all logs or of the first, as a file or read; or what it consists of.

    Returns
    -------
    Refinement

    Raises
    ------
    LogError, ResultError, ScenarioError
        If a file cannot be read or is incomplete.
    ParameterError
        If an option is out of range, or the run at the start diverges.
    """
    logs, several = settings.log, len(settings.also) > 0
    if several and len(settings.also) != len(logs) - 1:
        raise ParameterError("--also", f"{1 + len(settings.also)} scenarios for {len(logs)} logs", "one scenario, or one for each log")
    read = [scenario_asked(source, settings), *(load_scenario(file, plugins=settings.plugin) for file in settings.also)]
    labels = _labels([one.file for one in read] if several else logs)
    windows = [[parse_window(text) for text in settings.of_log(i, len(logs)).window] for i in range(len(logs))]
    opened = [_run(read[i if several else 0], log, settings, label) for i, (log, label) in enumerate(zip(logs, labels, strict=True))]
    runs = [run for run, _ in opened]
    spans = [log.span(window[0]) if window else None for window, (_, log) in zip(windows, opened, strict=True)]
    # Read first, so that an unreadable log fails before the work.
    validation = () if settings.validation is None else (settings.validation,)
    held_out = next((_run(read[0], log, settings, *_labels([log]))[0] for log in validation), None)
    inputs = (*(file for one in read for file in one.inputs), *settings.files(*logs, *validation), *settings.plugin)
    session.will_write(inputs, pictures_only=True)
    if session.saving.get("write") is not None:
        for run in runs:
            spared(_beside(session.saving["write"], run), inputs)
    result = refined(runs, settings.parameter, windows=spans, settings=RefineSettings(starts=settings.starts), progress=session.line)
    result, crossed = cross_validated(result, progress=session.line)
    validated: tuple[tuple[Agreement, ...], tuple[Agreement, ...]] = (), ()
    findings = [*result.findings]
    if held_out is not None:
        before, after = (replace(held_out, machine=run.machine, controller=run.controller) for run in (runs[0], result.runs[0]))
        validated = before.agreement(before.once()), after.agreement(after.once())
        findings += [*held_out.findings, *unseen_findings(*validated, validation=True)]
        if any(np.array_equal(held_out.measured, run.measured) for run in runs):
            findings.append(finding("CL564", held_out.label))
    sources = tuple(distinct_names(logs))
    result = replace(result, findings=tuple(findings))
    return Refinement(sources, result, *validated, crossed, tuple(findings), None, (), (), inputs)


def _labels(files: Sequence[str | Path]) -> list[str]:
    """Return unique labels of runs, valid in file names: names of the files, with folders where the names are equal."""
    names = [Path(name).with_suffix("").as_posix().replace("/", "-") for name in distinct_names(files)]
    return names if len(set(names)) == len(names) else [f"{name} {i + 1}" for i, name in enumerate(names)]


def _run(scenario: Scenario, file: Path, settings: Refine, label: str) -> tuple[LogRun, Log]:
    """Return a run of the whole log, and the log: what is not fitted is simulated, too."""
    log = open_log(file, replace(settings, window=()))
    with about(file):
        run = log_run(scenario.machine, scenario.controller, log.result, label)
    doubts = [replace(clock, place=": ".join(filter(None, (label, clock.place)))) for clock in log.clock_findings()]
    doubts += motion_findings(run.position, run.machine.servo_period, label)
    doubts += same_column_findings(run.machine.axis_names, run.asked, run.position, label)
    return replace(run, findings=(*run.findings, *doubts)), log


def _beside(machine: Path, run: LogRun) -> Path:
    """Return the file for the controller of a run."""
    return machine.with_name(f"{machine.stem}-{run.label}-controller.toml".replace(" ", "-"))


def _write(result: Refined, sources: Sequence[str], out: Path) -> tuple[Path, ...]:
    """Write the machine and the refined controllers; return the files of the controllers."""
    files = {out: machine_text(result, sources)}
    for i, run in enumerate(result.runs):
        if any(parameter.sought.name.startswith("controller.") and i in parameter.sought.runs for parameter in result.parameters):
            files[_beside(out, run)] = controller_text(result, i, sources)
    write_together(files, option="--write")
    return tuple(files)[1:]


DIGITS = 6


def machine_text(refined: Refined, sources: Sequence[str]) -> str:
    """Return the text of the machine file; `sources` are the names of the logs."""
    machine = refined.runs[0].machine
    tables = machine_tables(machine)
    _note(refined, sources, {"axes": tables["axes"]}, "axes.")
    for axis in machine.axes:
        tables["axes"][axis.name] = _correlations(refined, f"axes.{axis.name}.", axis) | _without(tables["axes"][axis.name])
    tables["machine"] = _without(tables["machine"]) | _correlations(refined, "axes.", machine)
    return _head(refined, sources) + toml(tables)


def controller_text(refined: Refined, run: int, sources: Sequence[str]) -> str:
    """Return the text of the controller file of a run; `sources` are the names of the logs."""
    tables = {"controller": controller_table(refined.runs[run].controller, refined.runs[run].machine)}
    _note(refined, sources, tables, "controller.", run)
    return _head(refined, sources) + toml(tables)


def _head(refined: Refined, sources: Sequence[str]) -> str:
    lines = [f"Refined against {', '.join(dict.fromkeys(sources))}, simulated along the references of the logs.", current()]
    lines += [f"{one.place}: {100.0 * one.explained:.5g} % of the variance explained, fit {one.fit:.4g} %" for one in refined.after]
    lines += [str(finding) for finding in refined.findings]
    return "".join(f"# {line}\n" for line in lines) + "\n"


def _without(table: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in table.items() if key != "correlations"}


def _correlations(refined: Refined, head: str, owner: Axis | Machine) -> dict[str, Any]:
    """Return the correlations of the refined parameters under a dotted head, and the earlier ones that still hold.

    All are from the first run, whose machine is written. An earlier correlation with a refined parameter no longer holds.
    """
    names = {parameter.sought.label: parameter.sought.name for parameter in refined.parameters if 0 in parameter.sought.runs}
    anew = {name.removeprefix(head) for name in names.values()}
    pairs: list[list[Any]] = [list(pair) for pair in owner.correlations if not anew & set(pair[:2])]
    finite = {parameter.sought.label for parameter in refined.parameters if math.isfinite(parameter.deviation)}
    rows = {
        names[label].removeprefix(head): i
        for i, label in enumerate(refined.correlation_of)
        if label in names and label in finite and names[label].startswith(head)
    }
    for (one, i), (other, j) in combinations(rows.items(), 2):
        value = round(float(refined.correlation[i, j]), 4)
        # The table of an axis has the correlations within that axis.
        within = isinstance(owner, Machine) and one.partition(".")[0] == other.partition(".")[0]
        if value and not within:
            pairs.append([one, other, value])
    return {"correlations": Noted(pairs, "of parameters fitted together")} if pairs else {}


def _note(refined: Refined, sources: Sequence[str], tables: dict[str, Any], head: str, run: int = 0) -> None:
    """Add source and deviation to each refined value of a run, with significant digits only."""
    for parameter in refined.parameters:
        sought = parameter.sought
        if not sought.name.startswith(head) or run not in sought.runs:
            continue
        *words, last = sought.name.split(".")
        table = tables
        for word in words:
            table = table[word]
        if parameter.at_bound:
            worth: dict[str, Any] = {"note": "at the bound of its range"}
        elif not math.isfinite(parameter.deviation):
            worth = {"note": "not determined by the logs"}
        else:
            worth = {"deviation": _written(sought, parameter.deviation, 2)}
        logs = ", ".join(dict.fromkeys(sources[i] for i in sought.runs))
        table[last] = Noted({"value": _written(sought, parameter.value, DIGITS), "source": "fitted", **worth, "from": logs})


def _written(sought: Sought, value: float, digits: int) -> str | float:
    return sought.shown(value, digits) if sought.variable.unit else float(f"{value:.{digits}g}")
