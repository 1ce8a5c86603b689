"""``contourlab sensitivity``: find the parameters that the contour error of a scenario depends on."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.app.json_values import HIDDEN, write_json
from contourlab.app.quick import affordable
from contourlab.app.results import staged
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.errors import ParameterError
from contourlab.features.run.source import Source, case_asked
from contourlab.features.sensitivity.options import Plan, SensitivityOptions
from contourlab.features.sensitivity.report import charts_of, tables
from contourlab.features.sensitivity.study import Study, distributions, present_values, sensitivity_study
from contourlab.features.sensitivity.verdict import Ranking, ranking, verdict
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.loop.batch import LANES
from contourlab.metrics.run_figures import CONTOUR
from contourlab.rendering.table import paragraphs
from contourlab.study import Runner, Setting, Space
from contourlab.study.checkpoint import Checkpoint, resumable, run_identity

if TYPE_CHECKING:
    from contourlab.scenario import Case

KEPT = "runs"
"""Folder of stored runs, inside the folder of the results."""


@dataclass(frozen=True, eq=False)
class Sensitivity(Answer):
    """What the contour error of a scenario depends on.

    Attributes
    ----------
    scenario : str
        The file as given.
    request : SensitivityOptions
        As they were done.
    scheme, machine : str
    servo_period : float [s]
    runs_made, runs_reused : int
    study : Study
    ranking : Ranking
    findings : tuple of Finding
    """

    scenario: str
    request: SensitivityOptions
    scheme: str
    machine: str
    servo_period: float
    runs_made: int
    runs_reused: int
    study: Study
    ranking: Ranking
    findings: tuple[Finding, ...]
    inputs: tuple[Path, ...] = field(default=(), metadata=HIDDEN, repr=False)
    folder: str = field(default="", metadata=HIDDEN, repr=False)

    @property
    def text(self) -> str:
        """The findings and the tables."""
        of, count, runs = self.study.plan.judged, len(self.study.space.numbers), self.runs_made + self.runs_reused
        given = f"servo period: {figure(self.servo_period, 'ms')}; parameters: {count}; runs: {runs}"
        head = f"{self.scheme}: {of.label} {figure(self.study.present, of.display, 4)}\n{given}"
        return "\n\n".join(
            [head, paragraphs(map(str, self.findings)), *tables(self.study), *([f"results: {self.folder}"] if self.folder else [])]
        )

    def _charts(self) -> Iterator[Any]:
        yield from charts_of(self.study)

    def save(self, folder: str | Path = "results", *, plots: Sequence[str] = ()) -> Sensitivity:
        """Write ``summary.json`` and pictures into a folder.

        Parameters
        ----------
        folder : str or Path
        plots : sequence of str
            Formats: png, svg or pdf.

        Returns
        -------
        Sensitivity
            With its folder.

        Raises
        ------
        OutputError
            If the folder cannot be written to.
        """
        with staged(folder, "summary.json", inputs=self.inputs) as stage:
            write_json(stage / "summary.json", self)
            self._draw(stage, folder, plots)
        return replace(self, folder=str(folder))

    def _next(self, asked: Asked) -> Sequence[object]:
        """Calibrate the scenario."""
        return ["tune", *asked.inputs, "--scheme", self.request.scheme or None]


@question(SensitivityOptions)
def sensitivity(*source: Source, settings: SensitivityOptions, session: Session = QUIET) -> Sensitivity:
    """Find the parameters that the contour error of a scenario depends on.

    Saved in a folder, its runs are kept in the folder ``runs`` there: after an interrupt the same command continues.

    Parameters
    ----------
    *source : str, Path, Scenario, Case, or a Machine, its Controller and a Reference
        A scenario, as a file or read; or what it consists of.

    Returns
    -------
    Sensitivity

    Raises
    ------
    ContourlabError
        If the scenario or an option is invalid, or the scenario's own run fails.
    """
    scenario, case = case_asked(source, settings)
    if settings.servo_period is not None:
        case = replace(case, machine=replace(case.machine, servo_period=settings.si("servo_period")))
    if case.changes:
        raise ParameterError("scenario", "one that changes its controller", "a scheme with the same controller throughout")
    space = Space.chosen(case.machine, case.controller, settings.parameter, settings.width)
    drawn = distributions(space, settings.distribution, settings.deviation)
    settings.work(len(drawn))
    left_out = () if settings.scheme else tuple(repr(other.name) for other in scenario.all_cases)
    session.will_write(scenario.inputs, "summary.json")
    session.hold(resumable(session.folder / KEPT, "runs"))
    stages, executor, plan = session.stages(), settings.pool, settings
    with executor.started(settings.plugin) as pool:
        stages.begin("planning the motion")
        setting = Setting.of(case)
        kept = Checkpoint(session.folder / KEPT, run_identity([setting])) if session.saving else None
        # Contour and tracking error are stored in any case.
        figures = (settings.judged.name,) if settings.judged.source != CONTOUR else ()
        runs = Runner(setting, figures, executor.workers, executor.gpu, pool, kept, stages.advance)
        present = present_values(space)
        if not all(np.isfinite(values[0]) for values in runs(present).values()):
            setting.single()
        if settings.quick:
            stages.begin("timing a run")
            batches = affordable(
                lambda motion: replace(setting, reference=motion).batch(present, figures), setting.reference, executor.workers
            )
            plan = settings.quickly(len(drawn), LANES * batches)
        stages.expect(plan.work(len(drawn)))
        study = sensitivity_study(space, runs, plan, drawn, _failure_level(setting, plan), stages.begin)
    reused = () if kept is None else kept.findings("runs", runs.reused)
    findings = (*_on_case(case, left_out), *reused, *_on_quick(settings, plan), *verdict(study))
    of = str(source[0]) if isinstance(source[0], str | Path) else scenario.name
    about = (of, plan, case.name, case.machine.name, case.machine.servo_period)
    return Sensitivity(*about, runs.runs, runs.reused, study, ranking(study), findings, scenario.inputs)


def _failure_level(setting: Setting, plan: Plan) -> float:
    """Return the figure [SI] of a run whose following error is always at its limit; infinite if an axis has no limit, or for no error."""
    limit = max(axis.limits.following_error for axis in setting.machine.axes)
    time = setting.reference.judged.samples.size * setting.machine.servo_period
    return {"m": limit, "m s": float(limit * time)}.get(plan.judged.unit, math.inf)


def _on_quick(asked: Plan, done: Plan) -> Iterator[Finding]:
    if done != asked:
        wider = round(math.sqrt(asked.base / done.base), 1)
        yield finding("CL653", values=done.values, base=done.base, trajectories=done.trajectories, wider=wider)
        if done.chosen != asked.chosen:
            yield finding("CL654")


def _on_case(case: Case, left_out: tuple[str, ...]) -> Iterator[Finding]:
    if left_out:
        yield finding("CL650", schemes=left_out)
    if case.learning is not None:
        yield finding("CL651")
    if case.machine.squareness or any(axis.error.position.size or axis.error.repeatability for axis in case.machine.axes):
        yield finding("CL652")
