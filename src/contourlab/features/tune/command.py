"""``contourlab tune``: calibrate the controller of a scenario, check it, and write a controller file."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.app.results import check_file, proposed, staged
from contourlab.errors import ParameterError, ScenarioError
from contourlab.features.run.command import check_plots
from contourlab.features.run.inputs import scenario_of
from contourlab.features.tune.report import tables
from contourlab.features.tune.search import REFINEMENTS
from contourlab.features.tune.study import Tuned, TuneSettings, tune
from contourlab.findings import Finding, finding
from contourlab.rendering.stages import shown
from contourlab.rendering.table import paragraphs
from contourlab.result import write_text_atomic
from contourlab.study import Setting, Space

if TYPE_CHECKING:
    from contourlab.scenario import Case


KEPT = "tuned.toml"
"""File of the controller in the folder of results."""


@dataclass(frozen=True, eq=False)
class Calibration:
    """The result of the command; its fields are the JSON output.

    Attributes
    ----------
    name, scheme : str
        Name of the scenario and of its scheme.
    passed : bool
        Whether the controller keeps bounds and tolerance.
    tolerance : float [m] or None
    controller_file : Path or None
        The file written; None if the controller breaks a bound.
    """

    name: str
    scheme: str
    passed: bool
    tolerance: float | None
    settings: TuneSettings
    result: Tuned
    findings: tuple[Finding, ...]
    controller_file: Path | None
    plots: tuple[Path, ...]

    def text(self) -> str:
        """Return the tables, the findings, and the files written."""
        goal, bounds = self.settings.goal, self.settings.bounds
        head = paragraphs([f"{self.name}, {self.scheme}", f"objective: {goal.label}", f"bounds: {bounds.words}"])
        parts = [head, *tables(goal, self.result)]
        parts.append(paragraphs(map(str, self.findings)))
        written = self.controller_file
        files = ["no controller file: the gains break a bound" if written is None else f"controller file: {written}"]
        files += [f"plot: {file}" for file in self.plots]
        return "\n\n".join([*parts, "\n".join(files)])


def tune_scenario(
    file: str | Path,
    settings: TuneSettings,
    *,
    scheme: str | None = None,
    machine: str | Path | None = None,
    controller: str | Path | None = None,
    tolerance: str | None = None,
    judge: str | None = None,
    program: Mapping[str, Any] | None = None,
    out: str | Path | None = None,
    plots: Sequence[str] = (),
    folder: str | Path = "results",
    plugins: Sequence[str | Path] = (),
    progress: bool = False,
) -> Calibration:
    """Calibrate the controller of a scenario, or of a part program on a machine.

    Parameters
    ----------
    file : str or Path
        A scenario (``.toml``); anything else is a part program.
    scheme : str, optional
        Scheme of the scenario; by default the scenario without schemes.
    machine, controller, tolerance, program
        See `contourlab.features.run.inputs.scenario_of`.
    judge : str, optional
        Moves to judge; by default as in the scenario.
    out : str or Path, optional
        Controller file to write, by default ``tuned.toml`` in `folder`; not written if the controller breaks a bound.
    plots : sequence of str
        png, svg or pdf, into ``plots`` in `folder`; other files there are kept.
    plugins : sequence of str or Path
        Python files with components.
    progress : bool
        Whether to show a bar.

    Raises
    ------
    ScenarioError, ProgramError, ParameterError
        If the scenario cannot be read or has no such scheme, or an option is out of range.
    OutputError
        If `out` or `folder` cannot be written; raised before anything is simulated.
    """
    check_plots(plots)
    if out is not None and Path(out).suffix.lower() != ".toml":
        raise ParameterError("--write", repr(str(out)), "a controller file, which ends in .toml")
    parts: dict[str, Any] = {"machine": machine, "controller": controller, "tolerance": tolerance}
    scenario = scenario_of(file, **parts, program=program, plugins=plugins).judging(judge)
    case = scenario.base if scheme is None else scenario.case(scheme)
    if case.changes:
        raise ScenarioError("the controller changes during the run: calibrate each controller in its own scenario", file=file)
    if out is not None:
        check_file(out, scenario.inputs)
    with staged(folder, *([KEPT] if out is None else []), inputs=scenario.inputs) as stage:
        with shown(progress) as stages, settings.executor.started(plugins, "Repeat the command") as pool:
            stages.expect(_work(case, settings))
            stages.begin("planning")
            tuned = tune(Setting.of(case), settings, pool=pool, begin=stages.begin, progress=stages.advance)
        written = None if tuned.after.violations else Path(folder) / KEPT if out is None else Path(out)
        if written is not None:
            _write(tuned, case, stage / KEPT if out is None else written, scenario.name, plugins)
        drawn: list[Path] = []
        if plots:
            from contourlab.features.tune.report import tuning_charts
            from contourlab.rendering.plots import write_charts

            charts = write_charts(tuning_charts(settings.goal, tuned), stage / "plots", tuple(plots))
            drawn = [Path(folder) / chart.relative_to(stage) for chart in charts]
    verdict = _verdict(case, tuned)
    passed = not any(one.entry.severity == "error" for one in verdict)
    findings = (*tuned.findings, *verdict)
    return Calibration(scenario.name, case.name, passed, case.tolerance, settings, tuned, findings, written, tuple(drawn))


def _work(case: Case, settings: TuneSettings) -> list[tuple[str, float]]:
    """Return first word and work of each stage of a calibration, in runs; see `contourlab.rendering.stages.Stages.expect`."""
    lines = settings.passes * len(Space.chosen(case.machine, case.controller, settings.parameters, settings.width).numbers)
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


def _write(tuned: Tuned, case: Case, out: Path, name: str, plugins: Sequence[str | Path]) -> None:
    """Write the controller file, after a check that it reads back as the same controller."""
    from contourlab.scenario.dump import dump
    from contourlab.scenario.load import load_controller

    before, after = (1e6 * one.figures["part_error_max"] for one in (tuned.before, tuned.after))
    head = f"Calibrated for {name}, scheme {case.name}: largest part error {before:.4g} um before, {after:.4g} um after."
    text = proposed(head, dump(tuned.controller, case.machine))
    with tempfile.TemporaryDirectory() as folder:
        trial = Path(folder) / "controller.toml"
        write_text_atomic(trial, text)
        again = load_controller(trial, case.machine, plugins=plugins)
    if dump(again, case.machine) != dump(tuned.controller, case.machine):
        raise ScenarioError("the written controller does not read back unchanged: this is a fault in contourlab", file=out)
    write_text_atomic(out, text)
