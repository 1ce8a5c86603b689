"""``contourlab tune``: calibrate the controller of a scenario, check it, and write a controller file."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.app.results import proposed, staged
from contourlab.app.session import QUIET, Answer, Asked, Session, interrupt, question
from contourlab.app.shared_options import Motion
from contourlab.arrays import Array
from contourlab.errors import ScenarioError
from contourlab.features.check.program_check import about_planner
from contourlab.features.run.changes import of_machine
from contourlab.features.run.source import Source, case_asked
from contourlab.features.tune.objective import Goal
from contourlab.features.tune.options import Tune
from contourlab.features.tune.search import REFINEMENTS
from contourlab.features.tune.study import Tuned, TuneSettings
from contourlab.features.tune.study import tune as calibrated
from contourlab.figures import figure, grouped, listing
from contourlab.findings import Finding, finding
from contourlab.loop import Controller
from contourlab.metrics.run_figures import FIGURES
from contourlab.rendering.charts import Chart, Curve, Panel, traces_chart
from contourlab.rendering.margin_words import decibel, degrees
from contourlab.rendering.relay_table import relay_table
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import write_text_atomic
from contourlab.scenario import Case, Scenario
from contourlab.study import Setting, Space

KEPT = "tuned.toml"
"""File of the controller in the folder of results."""


@dataclass(frozen=True, eq=False)
class Calibration(Answer):
    """A calibrated controller.

    Attributes
    ----------
    settings : TuneSettings
    result : Tuned
    findings : tuple of Finding
    scenario : Scenario
    case : Case
        The calibrated scheme.
    controller_file : Path or None
        The file written; None before, or if the controller breaks a bound.
    plots : tuple of Path
        The pictures written.
    """

    settings: TuneSettings
    result: Tuned
    findings: tuple[Finding, ...]
    scenario: Scenario = field(repr=False)
    case: Case = field(repr=False)
    controller_file: Path | None = None
    plots: tuple[Path, ...] = ()

    json_form: ClassVar = {
        "name": "scenario.name",
        "scheme": "case.name",
        "passed": "passed",
        "tolerance": "case.tolerance",
        **{name: name for name in ("settings", "result", "findings", "controller_file", "plots")},
    }

    @property
    def passed(self) -> bool:
        """Whether the controller keeps bounds and tolerance."""
        return not any(one.entry.severity == "error" for one in self.findings)

    @property
    def controller(self) -> Controller:
        """The calibrated controller."""
        return self.result.controller

    @property
    def text(self) -> str:
        """The tables, the findings, and the files written."""
        goal, bounds = self.settings.goal, self.settings.bounds
        head = paragraphs([f"{self.scenario.name}, {self.case.name}", f"objective: {goal.label}", f"bounds: {bounds.words}"])
        parts = [head, *tables(goal, self.result)]
        parts.append(paragraphs(map(str, self.findings)))
        written = self.controller_file
        broken = "no controller file: the gains break a bound" if self.result.after.violations else "no controller file yet"
        files = [broken if written is None else f"controller file: {written}"]
        files += [f"plot: {file}" for file in self.plots]
        return "\n\n".join([*parts, "\n".join(files)])

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The parameters before and after, one a row [SI]."""
        start = zip(self.result.space.numbers, self.result.space.start, strict=True)
        return [
            {"parameter": one.name, "unit": one.unit, "before": float(value), "after": self.result.values.get(one.name, float(value))}
            for one, value in start
        ]

    def _charts(self) -> Iterator[Chart]:
        return tuning_charts(self.settings.goal, self.result)

    @property
    def stopped(self) -> BaseException | None:
        """The interrupt that ended the search, if one did."""
        kept = "" if self.controller_file is None else f"Kept the best gains so far: {self.controller_file}"
        return interrupt(kept) if self.result.interrupted else None

    def save(self, folder: str | Path = "results", *, write: str | Path | None = None, plots: Sequence[str] = ()) -> Calibration:
        """Write the controller, unless it breaks a bound, and pictures.

        Parameters
        ----------
        folder : str or Path
        write : str or Path, optional
            Controller file; by default ``tuned.toml`` in the folder.
        plots : sequence of str
            Formats: png, svg or pdf; into ``plots`` in the folder.

        Returns
        -------
        Calibration
            With the names of its files.

        Raises
        ------
        OutputError
            If a file cannot be written.
        """
        tuned = self.result
        written = None if tuned.after.violations else Path(folder) / KEPT if write is None else Path(write)
        with staged(folder, *([KEPT] if write is None else []), inputs=self.scenario.inputs) as stage:
            if written is not None:
                _write(self, stage / KEPT if write is None else written)
            drawn = self._draw(stage, folder, plots)
        return replace(self, controller_file=written, plots=drawn)

    def _cited(self) -> tuple[list[Any], set[str]]:
        found, words = super()._cited()
        return found, words | {"relay"} if self.result.relay else words

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Run the motion with the new controller; or start elsewhere."""
        if self.controller_file is not None:
            given = replace(asked.settings, controller=str(self.controller_file), set=of_machine(asked.settings.set, self.case))
            return ["run", *asked.inputs, *given.words_of(Motion)]
        return None if self.result.interrupted or self.result.relay else asked.again("--start", "placed")


@question(Tune)
def tune(*source: Source, settings: Tune, session: Session = QUIET) -> Calibration:
    """Calibrate the controller of a scenario, or of a part program on a machine.

    Parameters
    ----------
    *source : str, Path, Scenario, Case, or a Machine, its Controller and a Reference
        A scenario (``.toml``) or a part program, as a file or read; or what a scenario consists of.

    Returns
    -------
    Calibration

    Raises
    ------
    ScenarioError, ProgramError, ParameterError
        If the scenario cannot be read or has no such scheme, or an option is out of range.
    """
    study = TuneSettings(**vars(settings))
    scenario, case = case_asked(source, settings)
    if case.changes:
        message = "the controller changes during the run: calibrate each controller in its own scenario"
        raise ScenarioError(message, file=scenario.file)
    session.will_write(scenario.inputs, *([KEPT] if session.saving.get("write") is None else []))
    stages = session.stages()
    with settings.pool.started(settings.plugin, "Repeat the command") as pool:
        stages.expect(_work(case, study))
        stages.begin("planning")
        tuned = calibrated(Setting.of(case), study, pool=pool, begin=stages.begin, progress=stages.advance)
    return Calibration(study, tuned, (*about_planner(case.machine), *tuned.findings, *_verdict(case, tuned)), scenario, case)


def _work(case: Case, settings: TuneSettings) -> list[tuple[str, float]]:
    """Return first word and work of each stage of a calibration, in runs; see `contourlab.rendering.stages.Stages.expect`."""
    lines = len(Space.chosen(case.machine, case.controller, settings.parameter, settings.width).numbers)
    runs = settings.passes * lines * (1 + REFINEMENTS) * float(settings.line_rule(lines).lanes)
    one = [] if settings.method in ("global", "relay") else [("one", runs)]
    every = [] if settings.method in ("sequential", "relay") else [("all", float(settings.budget))]
    return [("planning", 32.0), ("first", 32.0), ("placing", 32.0), ("restoring", 32.0), *one, *every, ("checking", 32.0)]


def _verdict(case: Case, tuned: Tuned) -> list[Finding]:
    """Return findings on whether the calibrated controller keeps the bounds and the tolerance of the scenario."""
    findings = [] if case.learning is None else [finding("CL605")]
    if tuned.after.violations:
        findings.append(finding("CL606", bounds=tuned.after.violations))
    elif case.tolerance is not None:
        largest = tuned.after.figures["part_error_max"]
        code = "CL607" if largest <= case.tolerance else "CL608"
        findings.append(finding(code, largest=largest, tolerance=case.tolerance))
    return findings


def _write(calibration: Calibration, out: Path) -> None:
    """Write the controller file, after a check that it reads back as the same controller."""
    from contourlab.scenario.dump import dump
    from contourlab.scenario.load import load_controller

    case, tuned = calibration.case, calibration.result
    before, after = (1e6 * one.figures["part_error_max"] for one in (tuned.before, tuned.after))
    title = f"Calibrated for {calibration.scenario.name}, scheme {case.name}"
    body = dump(tuned.controller, case.machine)
    text = proposed(f"{title}: largest part error {before:.4g} um before, {after:.4g} um after.", body)
    with tempfile.TemporaryDirectory() as folder:
        trial = Path(folder) / "controller.toml"
        write_text_atomic(trial, text)
        again = load_controller(trial, case.machine, plugins=calibration.settings.plugin)
    if dump(again, case.machine) != body:
        raise ScenarioError("the written controller does not read back unchanged: this is a fault in contourlab", file=out)
    write_text_atomic(out, text)


# --- tables and pictures: steps, figures and margins before and after, parameters, and drive terms -------------------------------------


def tables(goal: Goal, tuned: Tuned) -> Iterator[str]:
    """Yield the figure that was minimised, before and after, and the tables of a calibration."""
    if goal.figure is not None:
        before, after = (figure(run.figures[goal.figure], goal.unit, 4) for run in (tuned.before, tuned.after))
        yield f"{FIGURES[goal.figure].label}: {before} before, {after} after"
    if tuned.path.steps:
        yield _steps(goal, tuned).text()
    if tuned.global_result is not None:
        search = tuned.global_result.search
        per_start = listing([figure(value, goal.unit, 4) for value in search.per_start])
        yield paragraphs([f"Global search: best of each start {per_start}; {search.runs} runs. Method of the result: {tuned.method}."])
    if tuned.rules:
        yield from (table.text() for table in _relay(tuned))
    yield _figures(tuned).text()
    if tuned.after.margins:
        yield _margins(tuned).text()
    yield _parameters(tuned).text()
    yield _drives(tuned).text()


def _steps(goal: Goal, tuned: Tuned) -> Table:
    left = {"step", "parameter", "unit"}
    heads = ("step", "parameter", "from", "to", "unit", "objective before", "after")
    rows = []
    for step in tuned.path.steps:
        variable = step.variable
        values = (figure(variable.display_value(value), digits=5) for value in (step.before, step.after))
        objectives = (figure(value, goal.unit, 4) for value in (step.objective_before, step.objective_after))
        rows.append((step.stage, variable.short, *values, variable.display_unit, *objectives, step.bound))
    columns = [Column(head, left=head in left) for head in heads]
    return Table([*columns, Column("limited by", prose=True)], keys=2, rows=rows)


def _relay(tuned: Tuned) -> Iterator[Table]:
    """Yield ultimate gain and period of each axis, and what each rule gives."""
    units = {terms.axis: terms.command_unit for terms in tuned.drive_terms}
    yield relay_table(tuned.relay, units)
    rows = []
    for rule, given in tuned.rules.items():
        worst = min(given.margins.values(), key=lambda margins: (margins.stable, margins.modulus), default=None)
        largest = figure(given.figures["part_error_max"], "um", 4)
        rows.append((rule, largest, decibel(worst), degrees(worst), _modulus(worst), "no" if given.violations else "yes"))
    heads = ("largest part error", "gain margin", "phase margin", "modulus margin", "keeps the bounds")
    yield Table([Column("rule, worst axis", left=True), *map(Column, heads)], rows=rows)


def _figures(tuned: Tuned) -> Table:
    rows: list[tuple[str, ...]] = []
    for name, one in FIGURES.items():
        before, after = tuned.before.figures[name], tuned.after.figures[name]
        ratio = after / before if before * after > 0.0 else math.nan
        rows.append((one.label, figure(before, one.display, 4), figure(after, one.display, 4), figure(ratio)))
    return Table([Column("figure", left=True), *map(Column, ("before", "after", "after/before"))], rows=rows)


def _margins(tuned: Tuned) -> Table:
    heads = ("gain margin before", "after", "phase margin before", "after", "modulus margin before", "after")
    both = {axis: (tuned.before.margins.get(axis), after) for axis, after in tuned.after.margins.items()}
    rows = [(axis, *(show(margins) for show in (decibel, degrees, _modulus) for margins in pair)) for axis, pair in both.items()]
    return Table([Column("axis", left=True), *map(Column, heads)], rows=rows)


def _modulus(margins: Margins | None) -> str:
    return figure(math.nan if margins is None else margins.modulus)


def _parameters(tuned: Tuned) -> Table:
    columns = [Column("parameter", left=True), Column("start"), Column("tuned"), Column("unit", left=True)]
    both = {variable: (variable.value, tuned.values[variable.name]) for variable in tuned.space.numbers}
    shown = {variable: [figure(variable.display_value(value), digits=6) for value in pair] for variable, pair in both.items()}
    return Table(columns, rows=[(variable.short, *texts, variable.display_unit) for variable, texts in shown.items()])


def _drives(tuned: Tuned) -> Table:
    """Return Kv, the velocity loop, and LinuxCNC's gains for machine units of mm, one axis per column."""
    terms = tuned.drive_terms
    gains = [{} if axis.linuxcnc is None else axis.linuxcnc.per_millimetre() for axis in terms]
    rows = {
        "Kv [1/s]": [figure(axis.kv, digits=4) for axis in terms],
        "Kv [(m/min)/mm]": [figure(0.06 * axis.kv, digits=4) for axis in terms],
        "velocity loop, -3 dB": [figure(axis.velocity_bandwidth, "Hz", 4) for axis in terms],
        "LinuxCNC output, machine units mm": [axis.command_unit for axis in terms],
        **{f"LinuxCNC {name}": [figure(axis.get(name, math.nan), digits=6) for axis in gains] for known in gains for name in known},
        "LinuxCNC command difference, rms": [figure(axis.difference_rms, "%", 2) for axis in terms],
        "LinuxCNC command difference, max": [figure(axis.difference, "%", 2) for axis in terms],
    }
    columns = [Column("drive terms", left=True), *(Column(f"axis {axis.axis}") for axis in terms)]
    return Table(columns, rows=[(head, *texts) for head, texts in rows.items()])


SMALLEST = 1e-12


def tuning_charts(goal: Goal, tuned: Tuned) -> Iterator[Chart]:
    """Yield the pictures of a calibration."""
    scale = 1e6 if goal.unit.startswith("um") else 1.0
    label = f"{goal.label} [{goal.unit}]" if goal.unit else goal.label
    steps, progress = tuned.path.steps, dict[str, tuple[Array, ...]]()
    if steps:
        runs = np.cumsum([0, *(len(step.values) for step in steps)]).astype(float)
        reached = scale * np.array([tuned.start_objective, *(step.objective_after for step in steps)])
        progress["one parameter at a time"] = _positive(runs, reached)
    if tuned.global_result is not None:
        runs, best = tuned.global_result.search.course.T
        progress["all parameters at once"] = _positive(runs, scale * best)
    if progress:
        caption = "Objective over runs: after each step of the sequential procedure; for the global search, the best so far."
        more: dict[str, Any] = {"caption": caption, "level": None, "panel_height": 320, "log_y": True}
        yield traces_chart("tune-course", "Progress of the calibration", ("runs", label), progress, **more)
    varied = ((step.variable.short.partition("."), step) for step in steps if step.stage != "repair" and step.before)
    axes = grouped((axis, (name, *_positive(step.values / step.before, scale * step.objectives))) for (axis, _, name), step in varied)
    if axes:
        panels = []
        for axis, lines in axes.items():
            curves = (Curve(x, y, name, *scheme_style(i, max(len(lines), 2))) for i, (name, x, y) in enumerate(lines))
            log_x = all((x > 0.0).all() for _, x, _ in lines)
            panels.append(Panel("value / previous value", f"{axis}: {label}", tuple(curves), log_x=log_x, log_y=True))
        caption = (
            "Each curve varies one parameter, with all others at their values of that step. A flat curve: the parameter hardly matters."
        )
        yield Chart("tune-lines", "One parameter at a time", caption, tuple(panels), panel_height=320)
    halves = (
        (name, run, slice(len(run.time) // 2, None)) for name, run in (("before", tuned.before.run), ("after", tuned.after.run)) if run
    )
    if errors := {name: (run.time[half], 1e6 * run["contour_error"][half]) for name, run, half in halves}:
        labels, caption = ("time [s]", "contour error [um]"), "Second half of the run."
        yield traces_chart("tune-error", "Contour error before and after", labels, errors, caption=caption, level=None)


def _positive(x: Array, y: Array) -> tuple[Array, Array]:
    """Return the points that a logarithmic scale can show."""
    kept = np.isfinite(x) & np.isfinite(y) & (y > SMALLEST)
    return x[kept], y[kept]
