"""``contourlab tune``: calibrate the controller of a scenario, check it, and write a controller file."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, ClassVar

from contourlab.app.results import proposed, staged
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.app.shared_options import Motion
from contourlab.errors import ScenarioError
from contourlab.features.run.source import Source, case_asked
from contourlab.features.tune.options import Tune
from contourlab.features.tune.report import tables
from contourlab.features.tune.search import REFINEMENTS
from contourlab.features.tune.study import Tuned, TuneSettings
from contourlab.features.tune.study import tune as calibrated
from contourlab.findings import Finding, finding
from contourlab.loop import Controller
from contourlab.rendering.charts import Chart
from contourlab.rendering.table import paragraphs
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
        from contourlab.features.tune.report import tuning_charts

        return tuning_charts(self.settings.goal, self.result)

    @property
    def stopped(self) -> BaseException | None:
        """The interrupt that ended the search, if one did."""
        if not self.result.interrupted:
            return None
        end = KeyboardInterrupt()
        if self.controller_file is not None:
            end.add_note(f"Kept the best gains so far: {self.controller_file}")
        return end

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

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Run the motion with the new controller; or start elsewhere."""
        if self.controller_file is not None:
            given = replace(asked.settings, controller=str(self.controller_file))
            return ["run", *asked.inputs, *given.words_of(Motion)]
        return None if self.result.interrupted else asked.again("--start", "placed")


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
    return Calibration(study, tuned, (*tuned.findings, *_verdict(case, tuned)), scenario, case)


def _work(case: Case, settings: TuneSettings) -> list[tuple[str, float]]:
    """Return first word and work of each stage of a calibration, in runs; see `contourlab.rendering.stages.Stages.expect`."""
    lines = settings.passes * len(Space.chosen(case.machine, case.controller, settings.parameter, settings.width).numbers)
    one = [] if settings.method == "global" else [("one", lines * (1 + REFINEMENTS) * float(settings.rule.lanes))]
    every = [] if settings.method == "sequential" else [("all", float(settings.budget))]
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
