"""``contourlab sensitivity``: find the parameters that the contour error of a scenario depends on; its tables and pictures."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.app.quick import affordable_candidates
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.arrays import Array, Flags
from contourlab.errors import ParameterError, refuse
from contourlab.features.check.program_check import about_planner
from contourlab.features.run.source import Source, case_asked
from contourlab.features.sensitivity.curves import CHANGE, Curve, Interval, Local, present_values
from contourlab.features.sensitivity.options import PARTS, Plan, SensitivityOptions
from contourlab.features.sensitivity.study import (
    Drawn,
    Ranking,
    Sample,
    Study,
    distributions,
    ranking,
    sensitivity_study,
    verdict,
)
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.loop.simulate import ToolPosition
from contourlab.metrics.run_figures import CONTOUR
from contourlab.rendering.charts import Bars, Matrix, Multiples, Series, Tile
from contourlab.rendering.charts import Curve as Line
from contourlab.rendering.style import MUTED, scheme_style
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.study import DesignVariable, Runner, Setting, Space
from contourlab.study.checkpoint import Checkpoint, resumable
from contourlab.study.runner import run_identity
from contourlab.study.statistics import MorrisIndices, SobolIndices

if TYPE_CHECKING:
    from contourlab.scenario import Case

FEW = 24
"""Largest number of parameters of a printed matrix; a larger one is in JSON and the picture only."""
MOST_PAIRS = 8
ESTIMATE = ("+- (95 %)",)


def tables(study: Study) -> Iterator[str]:
    """Yield one table of all parameters for a study with all its parts, else every table of its parts."""
    if study.plan.chosen == PARTS:
        yield _overview(study).text()
        yield paragraphs([f"Details: the same command with --parts {', '.join(PARTS[:-1])} or {PARTS[-1]} prints them from the kept runs."])
        return
    if study.curves is not None:
        yield _curves(study, study.curves).text()
    if study.local is not None:
        yield _local(study.local).text()
        if 1 < len(study.space.numbers) <= FEW:
            yield _interactions(study.space, study.local).text()
    if study.morris is not None:
        yield _morris(study, study.morris).text()
    if study.sobol is not None:
        yield from (table.text() for table in _sobol(study, study.sobol))


def _overview(study: Study) -> Table:
    assert study.curves is not None and study.sobol is not None
    title = "Share of the variance (total Sobol index); best value of this parameter alone, and the part of the error that it leaves:"
    rows, indices = [], study.sobol
    for j in np.argsort(-indices.total, kind="stable"):
        variable, lowest = study.space.numbers[j], study.curves[j].minimum
        best = ("-", "-") if lowest is None else (*_shown(variable, lowest.value), figure(100.0 * lowest.figure / study.present))
        share = " +-".join(figure(100.0 * float(values[j]), digits=2) for values in (indices.total, indices.total_interval))
        rows.append((variable.short, share, *_shown(variable, variable.value), best[0], variable.display_unit, best[1]))
    return _table(title, ("share [%]", "present", "best", "unit", "leaves [%]"), rows, left=("unit",))


def _table(title: str, heads: Sequence[str], rows: Iterable[Sequence[str]], left: Sequence[str] = (), prose: Sequence[str] = ()) -> Table:
    return Table([Column("parameter", left=True), *(Column(head, head in left, head in prose) for head in heads)], title, rows=rows)


def _shown(variable: DesignVariable, *values: float) -> Iterator[str]:
    return (figure(variable.display_value(value), digits=4) for value in values)


def _curves(study: Study, curves: Sequence[Curve]) -> Table:
    unit = study.plan.judged.display
    title = f"One parameter at a time, {study.plan.values} values each, the others at their present values:"
    flat = f"changes by less than {100.0 * CHANGE:.0f} %"
    heads = ("present", "from", "to", "unit", "minimum at", "+-", "figure at minimum", "bound", flat, "runs fail")
    rows = []
    for curve in curves:
        variable, lowest = curve.variable, curve.minimum
        minimum = ["-"] * 3 + [""]
        if lowest is not None:
            within = figure(variable.display_value(lowest.within), digits=1)
            minimum = [*_shown(variable, lowest.value), within, figure(lowest.figure, unit, 4), lowest.bound]
        present = (*_shown(variable, variable.value, variable.low, variable.high), variable.display_unit)
        failed = ", ".join(_range(variable, interval) for interval in curve.failed)
        rows.append((variable.short, *present, *minimum, "" if curve.flat is None else _range(variable, curve.flat), failed))
    return _table(title, heads, rows, left=("unit", "bound", flat, "runs fail"))


def _range(variable: DesignVariable, interval: Interval) -> str:
    return f"{figure(variable.display_value(interval.low))} to {figure(variable.display_value(interval.high))}"


def _local(near: Local) -> Table:
    heads = ("sensitivity [%/%]", "step", "change with twice the step", "below", "above", "doubt")
    rows = (
        (
            *(slope.variable.short, figure(slope.sensitivity), figure(slope.step, "%")),
            *map(figure, (slope.difference, slope.below, slope.above)),
            slope.doubt.entry.name if slope.doubt else "",
        )
        for slope in near.slopes
    )
    return _table("Small changes: percent of the figure per percent of the parameter:", heads, rows, left=("doubt",))


def _interactions(space: Space, near: Local) -> Table:
    step = figure(float(near.interaction_steps.max()), "%", 2)
    title = f"Interactions: second differences relative to the figure (step {step}); ?: changes by half or more with half the step:"
    numbers = [str(j + 1) for j in range(len(near.interactions))]
    rows = (
        (f"{j} {variable.short}", *(figure(value, digits=2) + "?" * int(doubt) for value, doubt in zip(values, doubtful, strict=True)))
        for j, variable, values, doubtful in zip(numbers, space.numbers, near.interactions, near.doubtful, strict=True)
    )
    return _table(title, numbers, rows)


def _sampled(sample: Sample | None) -> str:
    assert sample is not None
    return f"of the {'logarithm of the figure' if sample.logarithmic else 'figure'}; {sample.runs} runs, {sample.failed} failed"


def _distribution(one: Drawn) -> str:
    low, high, centre, deviation = _shown(one.variable, one.variable.low, one.variable.high, one.variable.value, one.deviation)
    if one.kind == "normal":
        return f"normal around {centre}, deviation {deviation}, {low} to {high}"
    return f"{one.kind}, {low} to {high}"


def _estimates(study: Study, title: str, heads: Sequence[str], columns: Sequence[Array], by: Array) -> Table:
    """Return a table of indices, largest first, with the distribution of each parameter."""
    rows = (
        (study.space.numbers[j].short, *(figure(float(values[j])) for values in columns), _distribution(study.distributions[j]))
        for j in np.argsort(-by, kind="stable")
    )
    return _table(title, [*heads, "distribution"], rows, prose=("distribution",))


def _morris(study: Study, indices: MorrisIndices) -> Table:
    scale, unit = _effect_unit(study)
    title = f"Elementary effects (Morris) over the whole range [{unit}] {_sampled(study.morris_sample)}:"
    columns = [scale * values for values in (indices.mu_star, indices.mu_star_interval, indices.mu, indices.sigma)]
    return _estimates(study, title, ("mu*", *ESTIMATE, "mu", "sigma"), columns, indices.mu_star)


def _effect_unit(study: Study) -> tuple[float, str]:
    """Return factor and unit of elementary effects."""
    return (1.0, "decades") if study.plan.transform == "log" else (study.plan.judged.factor, study.plan.judged.display)


def _sobol(study: Study, indices: SobolIndices) -> Iterator[Table]:
    names = [variable.short for variable in study.space.numbers]
    title = f"Shares of the variance (Sobol, Saltelli N = {study.plan.base}) {_sampled(study.sobol_sample)}:"
    columns = (indices.first, indices.first_interval, indices.total, indices.total_interval)
    yield _estimates(study, title, ("first", *ESTIMATE, "total", *ESTIMATE), columns, indices.total)
    if (second := indices.second) is not None and indices.second_interval is not None:
        largest = sorted(np.argwhere(np.isfinite(second)).tolist(), key=lambda pair: -second[tuple(pair)])[:MOST_PAIRS]
        rows = ((f"{names[j]} with {names[k]}", figure(second[j, k]), figure(indices.second_interval[j, k])) for j, k in largest)
        yield Table([Column("pair", left=True), Column("share of the interaction"), *map(Column, ESTIMATE)], rows=rows)


def charts_of(study: Study) -> Iterator[Multiples | Bars | Matrix]:
    """Yield a chart for each part of a study: curves, Sobol and Morris indices, interactions."""
    figure, names = study.plan.judged, [variable.short for variable in study.space.numbers]
    if study.curves is not None:
        tiles = tuple(curve_tile(curve, figure.factor) for curve in study.curves)
        yield Multiples("curves", f"One parameter at a time: {figure.label}", "", f"{figure.label} [{figure.display}]", tiles)
    if (s := study.sobol) is not None:
        shares = (("first order", s.first, s.first_interval), ("total", s.total, s.total_interval))
        title = f"Sobol indices of {'log10 of the' if study.plan.transform == 'log' else 'the'} {figure.label}"
        yield indices_chart("sobol", title, "share of the variance, with 95 % intervals", names, shares)
    if (m := study.morris) is not None:
        scale, unit = _effect_unit(study)
        effects = (("sigma", m.sigma * scale, 0.0 * m.sigma), ("mu*", m.mu_star * scale, m.mu_star_interval * scale))
        label = f"mean magnitude of the elementary effects [{unit}]"
        yield indices_chart("morris", f"Elementary effects (Morris) on the {figure.label}", label, names, effects)
    if study.local is not None and len(names) > 1:
        title = f"Interactions near the present values: {figure.label}"
        yield interactions_chart(title, names, study.local.interactions, study.local.doubtful)


def curve_tile(curve: Curve, factor: float) -> Tile:
    """Return the small chart of one parameter, with its minimum and present value; failed runs are shaded. `factor` scales the figure."""
    variable, lowest = curve.variable, curve.minimum
    colour, dash = scheme_style(0, 1)
    x = np.array([variable.display_value(value) for value in curve.values])
    return Tile(
        variable.short,
        variable.display_unit or "value",
        (Line(x, factor * curve.figures, "other parameters unchanged", colour, dash),),
        () if lowest is None else ((variable.display_value(lowest.value), factor * lowest.figure, scheme_style(0, 2)[0]),),
        ((variable.display_value(variable.value), MUTED),),
        tuple((variable.display_value(interval.low), variable.display_value(interval.high)) for interval in curve.failed),
        variable.logarithmic,
    )


def indices_chart(key: str, title: str, x_label: str, names: Sequence[str], series: Sequence[tuple[str, Array, Array]]) -> Bars:
    """Return bars of indices with their intervals, sorted by the last series, largest first."""
    order = np.argsort(-series[-1][1], kind="stable")
    bars = tuple(Series(name, v[order], half[order], scheme_style(i, 2)[0]) for i, (name, v, half) in enumerate(series))
    return Bars(key, title, "", x_label, tuple(names[j] for j in order), bars)


def interactions_chart(title: str, names: Sequence[str], values: Array, doubtful: Flags) -> Matrix:
    """Return the matrix of interactions without its diagonal; doubtful ones get a question mark."""
    shown = values.copy()
    np.fill_diagonal(shown, np.nan)
    label = "second difference relative to the figure" + ("; ?: changes by half or more with half the step" if doubtful.any() else "")
    return Matrix("interactions", title, "", label, tuple(names), shown, doubtful)


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
        self._put(folder, plots, self.inputs, "summary.json")
        return replace(self, folder=str(folder))

    def _next(self, asked: Asked) -> Sequence[object]:
        """Calibrate the scenario; where the machine alone was studied, which may have no gains, run it."""
        gains = any(name.startswith("controller.") for name in self.study.space.names)
        return ["tune" if gains else "run", *asked.given, "--scheme" if gains else "--schemes", self.request.scheme or None]


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
    refuse(case.changes, ParameterError, "scenario", "one that changes its controller", "a scheme with the same controller throughout")
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
            plan = settings.quickly(len(drawn), affordable_candidates(setting, present, figures, executor.workers))
        stages.expect(plan.work(len(drawn)))
        study = sensitivity_study(space, runs, plan, drawn, _failure_level(setting, plan), stages.begin)
    reused = () if kept is None else kept.findings("runs", runs.reused)
    findings = (*_remarks(case, left_out, reused, settings, plan), *verdict(study))
    of = str(source[0]) if isinstance(source[0], str | Path) else scenario.name
    about = (of, plan, case.name, case.machine.name, case.machine.servo_period)
    return Sensitivity(*about, runs.runs, runs.reused, study, ranking(study), findings, scenario.inputs)


def _failure_level(setting: Setting, plan: Plan) -> float:
    """Return the figure [SI] of a run whose following error is always at its limit; infinite if an axis has no limit, or for no error."""
    limit = max(axis.limits.following_error for axis in setting.machine.axes)
    time = setting.reference.judged.samples.size * setting.machine.servo_period
    return {"m": limit, "m s": float(limit * time)}.get(plan.judged.unit, math.inf)


def _remarks(case: Case, left_out: tuple[str, ...], kept: Sequence[Finding], asked: Plan, done: Plan) -> Iterator[Finding]:
    """Yield how the machine plans, what the study leaves out, what it reused, and what a quick one made smaller."""
    yield from about_planner(case.machine)
    if left_out:
        yield finding("CL650", schemes=left_out)
    if case.learning is not None:
        yield finding("CL651")
    if not ToolPosition(case.machine, 0).exact:
        yield finding("CL652")
    yield from kept
    if done != asked:
        wider = round(math.sqrt(asked.base / done.base), 1)
        yield finding("CL653", values=done.values, base=done.base, trajectories=done.trajectories, wider=wider)
        if done.chosen != asked.chosen:
            yield finding("CL654")
