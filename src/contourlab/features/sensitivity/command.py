"""``contourlab sensitivity``: find the parameters that the contour error of a scenario depends on."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.app.json_values import HIDDEN, write_json
from contourlab.app.quick import affordable
from contourlab.app.results import staged
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.errors import ParameterError
from contourlab.features.run.source import Source, case_asked
from contourlab.features.sensitivity.options import SensitivityOptions
from contourlab.features.sensitivity.report import charts_of, tables
from contourlab.features.sensitivity.study import (
    PARTS,
    Drawn,
    Plan,
    Study,
    distributions,
    holds,
    present_values,
    sensitivity_study,
)
from contourlab.features.sensitivity.verdict import Ranking, ranking, verdict
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.loop import parameters_of
from contourlab.loop.batch import LANES
from contourlab.metrics.run_figures import CONTOUR
from contourlab.rendering.stages import Stages
from contourlab.rendering.table import paragraphs
from contourlab.study import Runner, Setting, Space
from contourlab.study.checkpoint import Checkpoint, resumable, run_identity
from contourlab.study.executors import Executor, Workers

if TYPE_CHECKING:
    from contourlab.scenario import Case

KEPT = "runs"
"""Folder of stored runs, inside the folder of the results."""


@dataclass(frozen=True)
class Request:
    """Options of the command.

    Attributes
    ----------
    plan : Plan
    scheme : str
        Scheme of the scenario; empty for the scenario without schemes.
    parameters : sequence of str
        See `contourlab.study.Space.chosen`; by default all calibrated parameters.
    width : float
        Factor by which a parameter without bounds may become smaller or larger.
    distribution : str
        One of `contourlab.features.sensitivity.study.KINDS`.
    deviations : sequence of str
        See `contourlab.features.sensitivity.study.distributions`.
    servo_period : str
        Replaces that of the machine, with its unit; empty to keep it.
    executor : Executor
    judge : str, optional
        Moves to judge; by default as in the scenario.
    quick : bool
        Whether to run only as much of the plan as fits into a minute.
    """

    plan: Plan = field(default_factory=Plan)
    scheme: str = ""
    parameters: Sequence[str] = ()
    width: float = 2.0
    distribution: str = "uniform"
    deviations: Sequence[str] = ()
    servo_period: str = ""
    executor: Executor = field(default_factory=Executor)
    judge: str | None = None
    quick: bool = False


@dataclass(frozen=True, eq=False)
class Sensitivity(Answer):
    """What the contour error of a scenario depends on.

    Attributes
    ----------
    scenario : str
        The file as given.
    request : Request
    scheme, machine : str
    servo_period : float [s]
    runs_made, runs_reused : int
    study : Study
    ranking : Ranking
    findings : tuple of Finding
    """

    scenario: str
    request: Request
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
    request = request_of(settings)
    scenario, case = case_asked(source, settings)
    if settings.servo_period is not None:
        case = replace(case, machine=replace(case.machine, servo_period=settings.si("servo_period")))
    if case.changes:
        raise ParameterError("scenario", "one that changes its controller", "a scheme with the same controller throughout")
    space = Space.chosen(case.machine, case.controller, request.parameters, request.width)
    drawn = distributions(space, request.distribution, request.deviations)
    request.plan.check(len(drawn))
    left_out = () if request.scheme else tuple(repr(other.name) for other in scenario.all_cases)
    session.will_write(scenario.inputs, "summary.json")
    session.hold(resumable(session.folder / KEPT, "runs"))
    stages = session.stages()
    with request.executor.started(settings.plugin) as pool:
        study, runs = _studied(case, request, (space, drawn), session.folder / KEPT if session.saving else None, stages, pool)
    kept = () if runs.store is None else runs.store.findings("runs", runs.reused)
    findings = (*_on_case(case, left_out), *kept, *_on_quick(request, study), *verdict(study))
    request = replace(request, plan=study.plan)
    name, period = case.machine.name, case.machine.servo_period
    of = str(source[0]) if isinstance(source[0], str | Path) else scenario.name
    ended = (runs.runs, runs.reused, study, ranking(study), findings)
    return Sensitivity(of, request, case.name, name, period, *ended, scenario.inputs)


def request_of(settings: SensitivityOptions) -> Request:
    """Return the options as they stand in the answer."""
    plan = Plan(
        settings.parts or PARTS,
        settings.figure,
        settings.values,
        settings.base,
        settings.second_order,
        settings.trajectories,
        settings.transform,
        settings.seed,
    )
    chosen = (settings.parameter, settings.width, settings.distribution, settings.deviation, settings.servo_period or "")
    return Request(plan, settings.scheme, *chosen, settings.pool, settings.judge, settings.quick)


def _studied(
    case: Case, request: Request, varied: tuple[Space, tuple[Drawn, ...]], folder: Path | None, stages: Stages, pool: Workers | None
) -> tuple[Study, Runner]:
    plan, (space, drawn) = request.plan, varied
    stages.begin("planning the motion")
    setting, executor = Setting.of(case), request.executor
    kept = None if folder is None else Checkpoint(folder, run_identity([setting]))
    # Contour and tracking error are stored in any case.
    figures = (plan.judged.name,) if plan.judged.source != CONTOUR else ()
    runs = Runner(setting, figures, executor.workers, executor.gpu, pool, kept, stages.advance)
    if not holds(space, runs):
        setting.single()
    if request.quick:
        stages.begin("timing a run")
        one = present_values(space)
        fits = affordable(lambda motion: replace(setting, reference=motion).batch(one, figures), setting.reference, executor.workers)
        plan = plan.quick(len(space.numbers), LANES * fits)
    stages.expect(plan.work(len(space.numbers)))
    known = parameters_of(setting.machine, setting.controller)
    accepted = {name: known[name][0].parameters[known[name][1]] for name in space.names}
    limits = {name: (parameter.minimum, parameter.maximum) for name, parameter in accepted.items()}
    level = _failure_level(setting, plan)
    return sensitivity_study(space, runs, plan, drawn, level, limits=limits, stage=stages.begin), runs


def _failure_level(setting: Setting, plan: Plan) -> float:
    """Return the figure [SI] of a run whose following error is always at its limit; infinite if an axis has no limit, or for no error."""
    limit = max(axis.limits.following_error for axis in setting.machine.axes)
    time = setting.reference.judged.samples.size * setting.machine.servo_period
    return {"m": limit, "m s": float(limit * time)}.get(plan.judged.unit, math.inf)


def _on_quick(request: Request, study: Study) -> Iterator[Finding]:
    plan = study.plan
    if request.quick and plan != request.plan:
        wider = round(math.sqrt(request.plan.base / plan.base), 1)
        yield finding("CL653", values=plan.values, base=plan.base, trajectories=plan.trajectories, wider=wider)
        if plan.parts != tuple(request.plan.parts):
            yield finding("CL654")


def _on_case(case: Case, left_out: tuple[str, ...]) -> Iterator[Finding]:
    if left_out:
        yield finding("CL650", schemes=left_out)
    if case.learning is not None:
        yield finding("CL651")
    if case.machine.squareness or any(axis.error.position.size or axis.error.repeatability for axis in case.machine.axes):
        yield finding("CL652")
