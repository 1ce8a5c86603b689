"""``contourlab analyse``: stability of loops, coupling and learning, without a simulation."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.analysis.learning.learning_analysis import LearningAnalysis, learning_analysis
from contourlab.analysis.linear.contour_transfer import (
    ContourMargins,
    ContourTransfer,
    contour_transfer,
    internal_stability,
)
from contourlab.analysis.linear.divided_loop import link_growth
from contourlab.analysis.linear.margins import Margins, doubling
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.app.json_values import HIDDEN, json_values
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.arrays import Array, Complex
from contourlab.errors import ComponentError
from contourlab.features.analyse.options import Analyse
from contourlab.features.run.command import file_names
from contourlab.features.run.source import Source, scenario_asked
from contourlab.figures import NONE, listing, number
from contourlab.findings import Finding, finding
from contourlab.loop.machine import require_loops
from contourlab.rendering.charts import Chart, Curve, Level, Panel
from contourlab.rendering.margin_words import decibel, degrees, gain_words, phase_words
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import Column, Table, paragraphs

if TYPE_CHECKING:
    from contourlab.scenario import Case

NOTHING = 1e-6
"""Smallest share of an error that a trial must remove; with less, nothing is learned."""
SLOW = 1e-3
"""Largest growth per trial that is accepted: an error doubles in 693 trials."""


@dataclass(frozen=True)
class Coupling:
    """The coupling: stability and margins over all directions of the path, and the factor of an error per lap (nan without laps)."""

    stable: bool
    lap: float
    margins: ContourMargins


@dataclass(frozen=True)
class Learning:
    """Learning: largest factor per trial and its frequency [Hz]; radius and norm of a whole trial on the path (None if not analysed)."""

    converges: bool
    monotone: bool
    worst_factor: float
    worst_frequency: float
    path_radius: float | None
    path_norm: float | None

    @classmethod
    def of(cls, analysis: LearningAnalysis) -> Learning:
        """Return the figures of an analysis."""
        whole = (None, None) if analysis.lifted is None else (analysis.lifted.radius, analysis.lifted.norm)
        return cls(analysis.converges, analysis.monotone, analysis.worst_factor, analysis.worst_frequency / (2.0 * math.pi), *whole)


@dataclass(frozen=True, eq=False)
class SchemeAnalysis:
    """The analysis of one scheme; an entry is None if the scheme has no such part, or no linear model.

    Attributes
    ----------
    good : bool
        Whether all loops are stable and learning, if any, converges or grows negligibly slowly.
    margins : mapping of str to Margins
        By axis.
    link_growth : float or None
        Factor of an error per servo period, with the messages between base and axes.
    """

    good: bool
    margins: Mapping[str, Margins]
    coupling: Coupling | None
    link_growth: float | None
    learning: Learning | None
    findings: tuple[Finding, ...]
    transfer: ContourTransfer | None = field(metadata=HIDDEN)
    foretold: LearningAnalysis | None = field(metadata=HIDDEN)


@dataclass(frozen=True)
class Analysis(Answer):
    """The analysis of each scheme, and the pictures written."""

    name: str
    schemes: Mapping[str, SchemeAnalysis]
    files: tuple[Path, ...] = ()
    inputs: tuple[Path, ...] = field(default=(), metadata=HIDDEN, repr=False)

    @property
    def passed(self) -> bool:
        """Whether all schemes are good."""
        return all(scheme.good for scheme in self.schemes.values())

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The findings of all schemes."""
        return tuple(one for scheme in self.schemes.values() for one in scheme.findings)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The margins of the axes, one a row."""
        return [
            {"scheme": name, "axis": axis, **json_values(margins)}
            for name, scheme in self.schemes.items()
            for axis, margins in scheme.margins.items()
        ]

    def _charts(self) -> Iterator[Chart]:
        """Yield the charts of each coupling, and those of learning for all schemes together."""
        from contourlab.rendering.learning_pictures import learning_charts, singular_value_chart

        names = file_names(list(self.schemes))
        for name, scheme in self.schemes.items():
            for chart in () if scheme.transfer is None else contour_transfer_charts(scheme.transfer):
                yield replace(chart, key=f"{chart.key}-{names[name]}", title=f"{chart.title}, {name}")
        learning = {name: scheme.foretold for name, scheme in self.schemes.items() if scheme.foretold is not None}
        if learning:
            yield from learning_charts(learning)
        lifted = ((name, analysis.lifted) for name, analysis in learning.items())
        short = {name: whole.singular_values for name, whole in lifted if whole is not None and whole.singular_values is not None}
        if short:
            yield singular_value_chart(short)

    def save(self, folder: str | Path = "results", *, plots: Sequence[str] = ()) -> Analysis:
        """Write pictures into a folder.

        Parameters
        ----------
        folder : str or Path
        plots : sequence of str
            Formats: png, svg or pdf; none by default.

        Returns
        -------
        Analysis
            With the names of its files.

        Raises
        ------
        OutputError
            If the folder cannot be written to.
        """
        return replace(self, files=self._put(folder, plots, self.inputs))

    def _next(self, asked: Asked) -> Sequence[object]:
        """Run the schemes."""
        return ["compare", *asked.given, "--schemes", ",".join(asked.settings.schemes) or None]

    @property
    def text(self) -> str:
        """The result for the terminal."""
        parts = [text for name, scheme in self.schemes.items() for text in (_table(name, scheme), paragraphs(map(str, scheme.findings)))]
        bad = [name for name, scheme in self.schemes.items() if not scheme.good]
        learns = ", every law learns" if any(scheme.learning is not None for scheme in self.schemes.values()) else ""
        verdict = f"FAIL: {listing(bad)}." if bad else f"PASS: every loop is stable{learns}."
        return "\n\n".join(filter(None, [verdict, *parts, "\n".join(map(str, self.files))]))


@question(Analyse)
def analyse(*source: Source, settings: Analyse, session: Session = QUIET) -> Analysis:
    """Analyse the schemes of a scenario: margins of each axis and of the coupling in all path directions, convergence of learning.

    Parameters
    ----------
    *source : str, Path, Scenario, Case, or a Machine, its Controller and a Reference
        A scenario, as a file or read; or what it consists of.

    Returns
    -------
    Analysis

    Raises
    ------
    ScenarioError
        If the scenario cannot be read, or has no such scheme.
    """
    scenario = scenario_asked(source, settings)
    schemes = {case.name: _analyse(case, settings.whole) for case in scenario.cases()}
    return Analysis(scenario.name, schemes, inputs=scenario.inputs)


def _analyse(case: Case, whole: bool) -> SchemeAnalysis:
    machine, controller = case.machine, case.controller
    require_loops(machine)
    margins: dict[str, Margins] = {}
    unknown: list[Finding] = []
    for axis in machine.axes:
        try:
            loop = sampled_loop(axis, controller.axes[axis.name], machine.servo_period, machine.carried_mass(axis.name))
            margins[axis.name] = loop.margins()
        except ComponentError as error:
            unknown.append(finding("CL350", place=f"axis {axis.name}", reason=str(error)))
    findings = [finding("CL205", place=f"axis {axis}") for axis, of_axis in margins.items() if not of_axis.stable]
    transfer = coupling = growth = learning = foretold = None
    good = not findings
    try:
        reference = case.reference() if whole and not unknown else None
        if controller.coupling is not None and not unknown:
            transfer = contour_transfer(machine, controller)
            stability = internal_stability(machine, controller, reference if reference is not None and reference.laps else None)
            coupling, good = Coupling(stability.stable, stability.lap, transfer.margins()), good and stability.stable
            findings += stability.findings
            findings += [finding("CL351", left=stability.lap)] if stability.stable and not math.isnan(stability.lap) else []
        if any(loop.link is not None for loop in controller.axes.values()) and not unknown:
            growth = link_growth(machine, controller)
            good &= growth < 1.0
            period = machine.servo_period
            if growth >= 1.0:
                findings.append(finding("CL353", doubling=period * doubling(growth)))
            else:
                findings.append(finding("CL352", time=period / abs(math.log(growth)) if growth > 0.0 else 0.0))
        if case.learning is not None and not unknown:
            foretold = learning_analysis(machine, controller, case.learning.law, reference)
            learning, learns = Learning.of(foretold), bool(foretold.response.radius.min() < 1.0 - NOTHING)
            slow = max(learning.worst_factor, learning.path_radius or 0.0) <= 1.0 + SLOW
            good &= learns and (learning.converges or slow)
            if not learns:
                findings.append(finding("CL355"))
            elif learning.converges:
                findings.append(finding("CL354", left=learning.worst_factor, frequency=learning.worst_frequency))
            if foretold.lifted is not None:
                findings.append(finding("CL356", left=foretold.lifted.radius, most=foretold.lifted.norm))
            findings += foretold.findings
    except ComponentError as error:
        unknown.append(finding("CL350", reason=str(error)))
    return SchemeAnalysis(good, margins, coupling, growth, learning, (*findings, *unknown), transfer, foretold)


def _table(name: str, scheme: SchemeAnalysis) -> str:
    """Return the table of margins of loops and coupling."""
    rows = []
    for axis, margins in scheme.margins.items():
        ends = (number(margins.crossover / (2.0 * math.pi)), number(margins.modulus)) if margins.stable else (NONE, NONE)
        rows.append((f"axis {axis}", decibel(margins), degrees(margins), *ends))
    if scheme.coupling is not None:
        over, words = scheme.coupling.margins, ("unstable", NONE, NONE, NONE)
        if over.stable:
            at = number(over.modulus_frequency / (2.0 * math.pi))
            words = gain_words(over.gain), phase_words(over.phase), at, number(over.modulus)
        rows.append(("coupling, worst direction", *words))
    heads = ("gain margin", "phase margin", "at [Hz]", "modulus margin")
    return Table([Column("loop", left=True), *map(Column, heads)], name, rows=rows).text()


FAR = 3.0  # loop gains larger than this are not drawn


def contour_transfer_charts(transfer: ContourTransfer) -> tuple[Chart, ...]:
    """Return three charts: the loop gain (Nyquist), its distance from -1, and the contour error transfer function over frequency."""
    w = transfer.loop.frequencies(600)
    margins, names = transfer.margins(), transfer.loop.names
    directions = [(f"along {name}", np.eye(len(names))[i]) for i, name in enumerate(names)]
    if len(names) > 1:
        directions.append(("along the diagonal", np.ones(len(names))))
    if margins.stable and len(names) > 1:
        directions.append(("worst direction", np.array(margins.modulus_direction)))
    looks = [(name, *scheme_style(i, max(2, len(directions)))) for i, (name, _) in enumerate(directions)]
    gains = [transfer.loop_gain(w, direction) for _, direction in directions]
    nyquist = tuple(Curve(*_near(gain), *look) for gain, look in zip(gains, looks, strict=True))
    marked = Curve(np.array([-1.05, -0.95, np.nan, -1.0, -1.0]), np.array([0.0, 0.0, np.nan, -0.05, 0.05]), "−1", "#1d2733")
    said = f"smallest distance from −1: {margins.modulus:.3g}" if margins.stable else "unstable"
    hertz = w / (2.0 * np.pi)
    magnitude = tuple(Curve(hertz, 20.0 * np.log10(np.abs(1.0 / (1.0 + gain))), *look) for gain, look in zip(gains, looks, strict=True))
    distance = Curve(hertz, np.minimum(transfer.distance(w), FAR), "worst direction", "#1d2733")
    levels = (Level(margins.modulus, f"modulus margin {margins.modulus:.3g}"),) if margins.stable else ()
    kind = "tangent" if transfer.along else "normal"
    return (
        Chart(
            "coupling-nyquist",
            "Loop gain of the coupling",
            f"Each curve is for one fixed direction of the {kind}; {said}.",
            (Panel("real part", "imaginary part", (*nyquist, marked)),),
        ),
        Chart(
            "coupling-modulus",
            "Distance of the loop gain from −1",
            f"Smallest over all directions of the {kind}, drawn up to {FAR:g}.",
            (Panel("frequency [Hz]", "distance from −1", (distance,), levels, log_x=True),),
        ),
        Chart(
            "coupling-error",
            "Error with coupling / error without coupling",
            "Below 0 dB the coupling reduces the contour error.",
            (Panel("frequency [Hz]", "magnitude [dB]", magnitude, (Level(0.0, "no effect"),), log_x=True),),
        ),
    )


def _near(gain: Complex) -> tuple[Array, Array]:
    """Return real and imaginary part, with a gap where the gain exceeds `FAR`."""
    far = np.abs(gain) > FAR
    return np.where(far, np.nan, gain.real), np.where(far, np.nan, gain.imag)
