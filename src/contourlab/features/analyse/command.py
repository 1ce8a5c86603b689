"""``contourlab analyse``: what can be said of loops, coupling and learning before anything runs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.analysis.learning.learning_analysis import LearningAnalysis, learning_analysis
from contourlab.analysis.linear.contour_transfer import ContourTransfer, InternalStability, contour_transfer, internal_stability
from contourlab.analysis.linear.divided_loop import link_growth
from contourlab.analysis.linear.margins import Margins
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.app.folder import staged
from contourlab.errors import ComponentError
from contourlab.features.run.command import file_names
from contourlab.features.run.margin_words import gain_words, phase_words

if TYPE_CHECKING:
    from contourlab.report.charts import Chart
    from contourlab.scenario import Case

NOTHING = 1e-6
"""So much of an error has to go in a trial for anything to be learned."""
SLOW = 1e-3
"""Growth per trial that takes a thousand trials to be seen."""


@dataclass(frozen=True)
class Analysed:
    """What a command prints: the summary, the text, and whether everything is stable and all that learns converges."""

    good: bool
    summary: dict[str, Any]
    text: str


@dataclass(eq=False)
class _Found:
    """What was found of one case; an entry is None, with its reason, where there is no linear model."""

    name: str
    margins: dict[str, Margins] = field(default_factory=dict)
    transfer: ContourTransfer | None = None
    stability: InternalStability | None = None
    learning: LearningAnalysis | None = None
    divided: float | None = None
    period: float = 0.0
    unknown: list[str] = field(default_factory=list)

    @property
    def good(self) -> bool:
        loops = all(margins.stable for margins in self.margins.values())
        inside = self.stability is None or self.stability.stable
        idle = self.learning is not None and self.learning.response.radius.min() >= 1.0 - NOTHING
        linked = self.divided is None or self.divided < 1.0
        return loops and inside and linked and not idle and (self.learning is None or self.learning.converges or _slow(self.learning))


def _slow(learning: LearningAnalysis) -> bool:
    """Tell whether what grows does so over more trials than are ever run."""
    whole = 0.0 if learning.lifted is None else learning.lifted.radius
    return max(learning.worst_factor, whole) <= 1.0 + SLOW


def analyse_scenario(
    file: str | Path,
    *,
    schemes: Sequence[str] = (),
    plugins: Sequence[str | Path] = (),
    plots: Sequence[str] = (),
    out: str | Path = "results",
    whole: bool = False,
) -> Analysed:
    """Analyse the schemes of a scenario: margins of each axis, of the coupling in all directions of the path, convergence of learning.

    Parameters
    ----------
    file : str or Path
        A scenario.
    schemes : sequence of str
        As of `contourlab.features.run.schemes.compare_schemes`.
    plugins : sequence of str or Path
        Python files with components.
    plots : sequence of str
        Formats of the pictures: png, svg, pdf; none by default.
    out : str or Path
        Folder of the pictures.
    whole : bool
        Whether laps and trials are looked at as a whole as well, on the very path: that takes up to minutes.
    """
    from contourlab.features.run.schemes import loaded

    scenario = loaded(file, schemes, plugins)
    found = [_of(case, whole) for case in scenario.cases()]
    text = "\n\n".join("\n".join(_lines(one)) for one in found)
    if plots:
        from contourlab.report.plots import write_charts

        with staged(out, inputs=scenario.inputs) as stage:
            files = write_charts(_charts(found), stage / "plots", tuple(plots))
        text += "".join(f"\n{Path(out) / file.relative_to(stage)}" for file in files)
    summary = {"name": scenario.name, "schemes": {one.name: _summary(one) for one in found}}
    return Analysed(all(one.good for one in found), summary, text)


def _of(case: Case, whole: bool) -> _Found:
    machine, controller, found = case.machine, case.controller, _Found(case.name, period=case.machine.servo_period)
    for axis in machine.axes:
        try:
            loop = sampled_loop(axis, controller.axes[axis.name], machine.servo_period, machine.carried_mass(axis.name))
            found.margins[axis.name] = loop.margins()
        except ComponentError as error:
            found.unknown.append(str(error))
    if found.unknown:
        return found
    reference = case.reference() if whole else None
    try:
        if controller.coupling is not None:
            found.transfer = contour_transfer(machine, controller)
            found.stability = internal_stability(machine, controller, reference if reference is not None and reference.laps else None)
        if any(mine.link is not None for mine in controller.axes.values()):
            found.divided = link_growth(machine, controller)
        if case.learning is not None:
            found.learning = learning_analysis(machine, controller, case.learning.law, reference)
    except ComponentError as error:
        found.unknown.append(str(error))
    return found


def _lines(found: _Found) -> list[str]:
    lines = [found.name]
    for axis, margins in found.margins.items():
        lines.append(f"  axis {axis}: {_margins(margins)}")
    if found.transfer is not None and found.stability is not None:
        over = found.transfer.margins()
        lines.append(f"  coupling: {found.stability.verdict}")
        if over.stable:
            lines.append(f"  coupling, over all directions: gain margin {gain_words(over.gain)}, phase margin {phase_words(over.phase)}")
    if found.divided is not None:
        lines.append(f"  with the messages between base and axes: {_dies(found.divided, found.period)}; margins are those without")
    if found.learning is not None:
        learning = found.learning
        at = f"at {learning.worst_frequency / (2.0 * math.pi):.3g} Hz"
        rate = f"a trial leaves at most {learning.worst_factor:.4g} of an error, {at}"
        said = "converges"
        if learning.response.radius.min() >= 1.0 - NOTHING:
            said, rate = "learns nothing", "no frequency becomes smaller: gain, window and lead are to be looked at"
        elif not learning.converges:
            growth = 100.0 * (learning.worst_factor - 1.0)
            said, rate = ("grows slowly" if _slow(learning) else "diverges"), f"an error grows by {growth:.2g} % per trial, {at}"
        lines.append(f"  learning: {said}{', each trial better than the last' if learning.monotone else ''}; {rate}")
        if learning.lifted is not None:
            worst = f", at most {learning.lifted.norm:.6g} of it in any one trial" if math.isfinite(learning.lifted.norm) else ""
            lines.append(f"  learning, on this very path: a trial leaves {learning.lifted.radius:.6g} of an error in the end{worst}")
        lines += [f"  learning: {warning}" for warning in learning.warnings]
    return lines + [f"  not analysed: {reason}" for reason in found.unknown]


def _dies(growth: float, period: float) -> str:
    if growth == 1.0 or growth <= 0.0:
        return "at the brink of stability" if growth else "stable"
    time = f"{1e3 * period / abs(math.log(growth)):.3g} ms"
    if growth < 1.0:
        return f"stable, the slowest error dies with a time constant of {time}"
    return f"unstable, an error grows e-fold in {time}"


def _margins(margins: Margins) -> str:
    if not margins.stable:
        return "unstable"
    at = f" at {margins.crossover / (2.0 * math.pi):.3g} Hz" if math.isfinite(margins.crossover) else ""
    return f"gain margin {gain_words(margins.gain)}, phase margin {phase_words(margins.phase)}{at}, modulus margin {margins.modulus:.3g}"


def _summary(found: _Found) -> dict[str, Any]:
    learning, stability = found.learning, found.stability
    return {
        "good": found.good,
        "margins": {axis: asdict(margins) for axis, margins in found.margins.items()},
        "coupling": None
        if stability is None or found.transfer is None
        else {"stable": stability.stable, "lap": stability.lap, "verdict": stability.verdict, "margins": asdict(found.transfer.margins())},
        "links": None if found.divided is None else {"stable": found.divided < 1.0, "growth": found.divided},
        "learning": None
        if learning is None
        else {
            "converges": learning.converges,
            "monotone": learning.monotone,
            "worst_factor": learning.worst_factor,
            "worst_frequency": learning.worst_frequency / (2.0 * math.pi),
            "path_radius": None if learning.lifted is None else learning.lifted.radius,
            "path_norm": None if learning.lifted is None else learning.lifted.norm,
            "warnings": list(learning.warnings),
        },
        "not_analysed": found.unknown,
    }


def _charts(found: Sequence[_Found]) -> list[Chart]:
    """Return the pictures: those of each coupling, and learning of all schemes together."""
    from dataclasses import replace

    from contourlab.features.analyse.picture import contour_transfer_charts
    from contourlab.report.learning_pictures import learning_charts, singular_value_chart

    charts: list[Chart] = []
    names = file_names([one.name for one in found])
    for one in found:
        if one.transfer is not None:
            named = contour_transfer_charts(one.transfer)
            charts += [replace(c, key=f"{c.key}-{names[one.name]}", title=f"{c.title}, {one.name}") for c in named]
    learning = {one.name: one.learning for one in found if one.learning is not None}
    lifted = {name: analysis.lifted.singular_values for name, analysis in learning.items() if analysis.lifted is not None}
    short = {name: values for name, values in lifted.items() if values is not None}
    return [*charts, *(learning_charts(learning) if learning else ()), *([singular_value_chart(short)] if short else ())]
