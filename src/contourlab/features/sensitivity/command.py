"""``contourlab sensitivity``: from a scenario to what its contour error depends on."""

from __future__ import annotations

import json
import shlex
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.app.component_sources import plugin_digests
from contourlab.app.folder import staged
from contourlab.app.json_values import json_values
from contourlab.app.kept_notes import kept_notes, taken_up_again
from contourlab.app.program_version import DECIDES_RUNS, program_version
from contourlab.app.stages import Stages, shown
from contourlab.errors import ParameterError
from contourlab.features.sensitivity.text import summary_of, text_of
from contourlab.result import write_text_atomic

if TYPE_CHECKING:
    from contourlab.features.sensitivity import Runs, Study
    from contourlab.feed import Reference
    from contourlab.scenario import Case

KEPT = "runs"
"""Folder of the runs that are kept, in that of the results."""


@dataclass(frozen=True)
class Request:
    """What is asked for: the options of the command.

    Attributes
    ----------
    scheme : str
        Of the scenario; the scenario without any if empty.
    parameters : sequence of str
        As of `contourlab.design.Space.chosen`; all that is calibrated by default.
    width : float
        Bounds are this factor either side of the value where a text gives none.
    figure : str
        Of `contourlab.features.sensitivity.FIGURES`.
    parts : sequence of str
        Of `contourlab.features.sensitivity.PARTS`; all by default.
    values, base, trajectories : int
        Of a curve, of Saltelli's sampling, of Morris' design.
    second : bool
        Whether Sobol's indices of pairs are wanted.
    distribution : str
        Of `contourlab.features.sensitivity.KINDS`.
    deviations : sequence of str
        As of `contourlab.features.sensitivity.distributions`.
    transform : str
        ``"log"`` or ``"none"``: of the figure, for global indices.
    servo_period : str
        In place of the machine's own, with its unit; empty for that.
    seed : int
        Of the samplings; noise has the scenario's.
    threads : int, optional
    """

    scheme: str = ""
    parameters: Sequence[str] = ()
    width: float = 2.0
    figure: str = "integral"
    parts: Sequence[str] = ()
    values: int = 41
    base: int = 512
    trajectories: int = 32
    second: bool = False
    distribution: str = "uniform"
    deviations: Sequence[str] = ()
    transform: str = "log"
    servo_period: str = ""
    seed: int = 0
    threads: int | None = None


@dataclass(frozen=True)
class SensitivityOutcome:
    """What the command prints: as JSON, and as text."""

    summary: dict[str, Any]
    text: str


def sensitivity_of(
    file: str | Path,
    out: str | Path,
    request: Request,
    *,
    plugins: Sequence[str | Path] = (),
    plots: Sequence[str] = (),
    progress: bool = False,
) -> SensitivityOutcome:
    """Study a scenario, write ``summary.json`` and pictures into a folder, and keep the runs in its folder ``runs``.

    Parameters
    ----------
    file : str or Path
        A scenario.
    out : str or Path
        Folder of the results. Runs kept there from an earlier time are not made again: after an interrupt the same command goes on.
    request : Request
    plugins : sequence of str or Path
        Python files with components.
    plots : sequence of str
        png, svg or pdf.
    progress : bool
        Whether to show a bar.

    Raises
    ------
    ContourlabError
        If the scenario, an option or the folder is at fault, or the scenario's own run fails.
    """
    from contourlab.features.run.command import check_plots

    check_plots(plots)
    case, notes, inputs = _case(file, request, plugins)
    with taken_up_again(Path(out) / KEPT, "runs"), staged(out, "summary.json", inputs=inputs) as stage:
        with shown(progress) as stages:
            study, runs = _studied(case, request, Path(out) / KEPT, stages)
        notes += _kept_notes(runs)
        command = _command(file, request, plugins)
        summary = json_values(summary_of(study, runs, case, notes, command))
        write_text_atomic(stage / "summary.json", json.dumps(summary, indent=2, allow_nan=False) + "\n")
        if plots:
            from contourlab.features.sensitivity.charts import charts_of
            from contourlab.report.plots import write_charts

            write_charts(charts_of(study), stage / "plots", plots)
    return SensitivityOutcome(summary, text_of(study, runs, case, notes))


def _case(file: str | Path, request: Request, plugins: Sequence[str | Path]) -> tuple[Case, list[str], tuple[Path, ...]]:
    """Return what is studied, what is to be known of it, and the files that were read."""
    from contourlab.features.measure.log_choice import positive
    from contourlab.features.run.schemes import loaded

    scenario = loaded(file, (request.scheme,) if request.scheme else (), plugins)
    case, notes = scenario.cases()[0] if request.scheme else scenario.base, []
    if not request.scheme and scenario.all_cases:
        names = ", ".join(repr(one.name) for one in scenario.all_cases)
        notes.append(f"the scenario is taken without its schemes {names}: --scheme takes one")
    if request.servo_period:
        period = positive("--servo-period", request.servo_period, "s", 'a time, such as "0.1 ms"')
        case = replace(case, machine=replace(case.machine, servo_period=period))
    if case.changes:
        raise ParameterError(
            "scenario", "controllers that change while it runs", "one controller from beginning to end: take a scheme without"
        )
    if case.learning is not None:
        notes.append("the runs are those before anything is learned")
    if case.machine.squareness or any(axis.error.position.size or axis.error.repeatability for axis in case.machine.axes):
        notes.append("the machine's lead errors and squareness are no part of these runs: they are the same under any controller")
    return case, notes, scenario.inputs


def _studied(case: Case, request: Request, folder: Path, stages: Stages) -> tuple[Study, Runs]:
    from contourlab.design import Evaluator, Space
    from contourlab.features import sensitivity as study
    from contourlab.loop import parameter_names, simulate

    machine, controller = case.machine, case.controller
    space = Space.chosen(machine, controller, request.parameters, request.width)
    drawn = study.distributions(space, request.distribution, request.deviations)
    if request.transform not in ("log", "none"):
        raise ParameterError("--transform", repr(request.transform), "log or none")
    figure = study.figure_called(request.figure)
    plan = study.Plan(
        tuple(request.parts) or study.PARTS,
        figure,
        request.values,
        request.base,
        request.second,
        request.trajectories,
        request.transform == "log",
        request.seed,
    )
    plan.check(len(space.numbers))
    if request.seed < 0:
        raise ParameterError("--seed", f"{request.seed}", "0 or more")
    stages.begin("planning the motion")
    reference = case.reference()
    evaluator = Evaluator(
        machine, controller, reference, moving=case.moving, seed=case.seed, threads=_threads(request.threads), effort=False
    )
    model = "\n".join([_model(case, reference), *plugin_digests([case.machine], case.controller)])
    runs = study.Runs(evaluator, study.Kept(folder, model), stages.advance)
    level = study.failure_level(machine, reference, figure)
    if not study.holds(space, runs):
        # One run by itself says where and when it fails.
        simulate(machine, controller, reference, seed=case.seed, moving=case.moving)
    known = parameter_names(machine, controller)
    limits = {name: _limits(*known[name]) for name in space.names}
    return study.sensitivity_study(space, runs, plan, drawn, level, limits=limits, stage=stages.begin), runs


def _threads(wanted: int | None) -> int | None:
    if wanted is not None and wanted < 1:
        raise ParameterError("--threads", f"{wanted}", "1 or more")
    return wanted


def _limits(part: Any, name: str) -> tuple[float, float]:
    """Return what a number may be at all."""
    parameter = part.parameters[name]
    return parameter.minimum, parameter.maximum


def _model(case: Case, reference: Reference) -> str:
    """Return all that decides a run, but the numbers that are moved: machine, controller, motion, noise, and the program that runs it."""
    from contourlab.scenario.dump import dump

    words = [dump(case.machine), dump(case.controller, case.machine), reference.digest, f"seed {case.seed}", f"moving {case.moving}"]
    return "\n".join([*words, program_version(DECIDES_RUNS)])


def _kept_notes(runs: Runs) -> list[str]:
    if runs.kept is None:
        return []
    return kept_notes(runs.kept, runs.found, "runs", "run", "scenario, motion, seed, plugin or version of contourlab")


def _command(file: str | Path, request: Request, plugins: Sequence[str | Path]) -> str:
    """Return what was typed, options at their defaults left out."""
    plain_request, words = Request(), ["contourlab", "sensitivity", str(file)]
    repeated = {"parameters": "--parameter", "deviations": "--deviation"}
    for name in Request.__dataclass_fields__:
        value = getattr(request, name)
        if value == getattr(plain_request, name) or name == "threads":
            continue
        if name in repeated:
            words += [word for text in value for word in (repeated[name], text)]
        elif name == "parts":
            words += ["--parts", ",".join(value)]
        elif name == "second":
            words.append("--second-order")
        else:
            words += [f"--{name.replace('_', '-')}", str(value)]
    return shlex.join([*words, *(word for plugin in plugins for word in ("--plugin", str(plugin)))])
