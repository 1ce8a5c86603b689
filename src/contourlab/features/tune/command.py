"""``contourlab tune``: the gains of a scenario calibrated, checked, and written as a controller file."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.app.results import check_file, staged
from contourlab.app.stages import shown
from contourlab.errors import ParameterError, ScenarioError
from contourlab.features.tune import FIGURES, Tuned, TuneSettings, tune
from contourlab.features.tune.text import summary_of, text_of
from contourlab.result import write_text_atomic

if TYPE_CHECKING:
    from contourlab.report.charts import Chart
    from contourlab.scenario import Case


@dataclass(frozen=True)
class Calibration:
    """What the command prints: whether bounds and tolerance are kept, the summary, and the text."""

    passed: bool
    summary: dict[str, Any]
    text: str


def tune_scenario(
    file: str | Path,
    settings: TuneSettings,
    *,
    scheme: str | None = None,
    machine: str | Path | None = None,
    controller: str | Path | None = None,
    tolerance: str | None = None,
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
        ``.toml``: a scenario; anything else is a part program.
    settings : TuneSettings
    scheme : str, optional
        Which scheme of the scenario; by default the scenario without any.
    machine, controller, tolerance
        With a part program, as of `contourlab.features.run.command.run_scenario`.
    out : str or Path, optional
        The controller file; none is written by default, nor where bounds are not kept.
    plots : sequence of str
        png, svg or pdf, into ``plots`` in `folder`; what else is there stays.
    folder : str or Path
    plugins : sequence of str or Path
        Python files with components.
    progress : bool
        Whether to show a bar.

    Raises
    ------
    ScenarioError, ProgramError, ParameterError
        If the scenario cannot be read, has no such scheme, or an option is out of range.
    OutputError
        If `out` or `folder` cannot be written; found before anything is simulated.
    """
    from contourlab.features.run.command import check_plots

    check_plots(plots)
    if out is not None and Path(out).suffix.lower() != ".toml":
        raise ParameterError("--out", repr(str(out)), "a controller file, which ends in .toml")
    name, case, inputs = _case(file, scheme, machine, controller, tolerance, plugins)
    if out is not None:
        check_file(out, inputs)
    with staged(folder, inputs=inputs, option="--folder") if plots else nullcontext() as stage:
        found = _calibrated(case, settings, progress)
        passed = not found.after.broken and not _beyond(case, found)
        summary = summary_of(name, case, settings, found, passed)
        text = text_of(name, case, settings, found) + _write(found, case, out, name, plugins)
        summary["controller_file"] = str(out) if out is not None and not found.after.broken else None
        if stage is not None:
            from contourlab.report.plots import write_charts

            files = write_charts(_charts(settings, found), stage / "plots", tuple(plots))
            text += "".join(f"\nplot: {Path(folder) / one.relative_to(stage)}" for one in files)
    return Calibration(passed, summary, text)


def _calibrated(case: Case, settings: TuneSettings, progress: bool) -> Tuned:
    with shown(progress) as stages:
        stages.begin("planning")
        reference = case.reference()
        told: dict[str, Any] = {"begin": stages.begin, "tell": stages.advance}
        found = tune(case.machine, case.controller, reference, settings, moving=case.moving, seed=case.seed, **told)
    if case.learning is None:
        return found
    return replace(found, notes=(*found.notes, "what it learns from trial to trial is left out: gains are calibrated for one run"))


def _case(
    file: str | Path,
    scheme: str | None,
    machine: str | Path | None,
    controller: str | Path | None,
    tolerance: str | None,
    plugins: Sequence[str | Path],
) -> tuple[str, Case, tuple[Path, ...]]:
    """Return the name of a scenario, the case that is calibrated, and the files that were read."""
    from contourlab.features.run.command import refuse_drawing
    from contourlab.scenario import BUILTIN, load_scenario, scenario_from_parts

    if (str(file).startswith(BUILTIN) and Path(file).suffix != ".ngc") or Path(file).suffix.lower() == ".toml":
        given = {"--machine": machine, "--controller": controller, "--tolerance": tolerance}
        for option, value in given.items():
            if value is not None:
                raise ScenarioError(f"a scenario names its own: leave {option} out", file=file)
        scenario = load_scenario(file, plugins=plugins)
    else:
        refuse_drawing(file, machine, controller)
        if machine is None or controller is None:
            raise ScenarioError("a part program needs --machine and --controller; a scenario ends in .toml", file=file)
        run = {} if tolerance is None else {"tolerance": tolerance}
        scenario = scenario_from_parts(file, machine, controller, run=run, plugins=plugins)
    case = scenario.base if scheme is None else scenario.case(scheme)
    if case.changes:
        raise ScenarioError("controllers take over on the way: calibrate each in a scenario of its own", file=file)
    return scenario.name, case, scenario.inputs


def _beyond(case: Case, found: Tuned) -> bool:
    """Tell whether the part error in the end is beyond the tolerance of the scenario."""
    largest = found.after.figures["part_error_max"]
    return case.tolerance is not None and not largest <= case.tolerance


def _write(found: Tuned, case: Case, out: str | Path | None, name: str, plugins: Sequence[str | Path]) -> str:
    """Write the controller file, once it has been read back and found to be the same controller; return what there is to say."""
    if out is None:
        return ""
    if found.after.broken:
        return f"\n{out} is not written: what was found does not keep the bounds"
    from contourlab.scenario.dump import dump
    from contourlab.scenario.load import load_controller

    before, after = (1e6 * one.figures["contour_error_integral"] for one in (found.before, found.after))
    head = f"# Calibrated for {name}, scheme {case.name}: integral of the contour error {before:.4g} um s, then {after:.4g} um s.\n\n"
    text = head.replace("\r", " ") + dump(found.controller, case.machine)
    with tempfile.TemporaryDirectory() as folder:
        trial = Path(folder) / "controller.toml"
        write_text_atomic(trial, text)
        again = load_controller(trial, case.machine, plugins=plugins)
    if dump(again, case.machine) != dump(found.controller, case.machine):
        raise ScenarioError("the controller does not read back as it was written: this is a fault in contourlab", file=out)
    write_text_atomic(Path(out), text)
    return f"\ncontroller file: {out}"


def _charts(settings: TuneSettings, found: Tuned) -> tuple[Chart, ...]:
    import numpy as np

    from contourlab.features.tune.pictures import Line, tuning_charts
    from contourlab.units import from_si

    single = settings.goal.single
    factor = from_si(1.0, FIGURES[single][2]) / from_si(1.0, FIGURES[single][1]) if single else 1.0
    label = f"{settings.goal.words} [{FIGURES[single][2]}]" if single else settings.goal.words
    course, errors = {}, {}
    if found.steps:
        runs = np.cumsum([0, *(len(step.values) for step in found.steps)]).astype(float)
        reached = np.array([found.start, *(step.objective_after for step in found.steps)])
        course["one number at a time"] = (runs, factor * reached)
    if found.searched is not None:
        course["all numbers at once"] = (found.searched.found.course[:, 0], factor * found.searched.found.course[:, 1])
    lines = []
    for step in found.steps:
        axis, _, word = step.number.short.partition(".")
        if step.stage != "repair" and step.before:
            lines.append(Line(word, axis, step.values / step.before, factor * step.objectives))
    for words, one in (("before", found.before), ("after", found.after)):
        if one.run is not None:
            error = one.run["contour_error"]
            errors[words] = (one.run.time[len(error) // 2 :], 1e6 * error[len(error) // 2 :])
    return tuning_charts(label, course, lines, errors)
