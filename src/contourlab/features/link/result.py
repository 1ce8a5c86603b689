"""The result of ``contourlab link``: as JSON, as text, and as pictures."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from contourlab.app.session import Answer, Asked, interrupt
from contourlab.features.link.cost import DivisionCost
from contourlab.features.link.sweep import GROWN, QUANTITIES, LinkSweep
from contourlab.figures import figure, grouped
from contourlab.findings import Finding, finding
from contourlab.metrics.run_figures import GOALS
from contourlab.rendering.charts import Chart, Curve, Level, Panel
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.scenario import Scenario

_TITLES = {
    "message_period": ("message period [ms]", 1e3, "Longer message period"),
    "delay": ("delay each way [ms]", 1e3, "More delay"),
    "jitter": ("jitter [ms]", 1e3, "More jitter"),
    "loss": ("messages lost [%]", 100.0, "More messages lost"),
}


@dataclass(frozen=True)
class SchemeCost:
    """The cost of the divisions of one scheme.

    Attributes
    ----------
    figure : str
        One of `contourlab.metrics.run_figures.GOALS`.
    undivided, allowed : float [m, or m s]
        Error of the undivided loop, and the largest allowed.
    divisions : tuple of DivisionCost
    """

    figure: str
    undivided: float
    allowed: float
    divisions: tuple[DivisionCost, ...]

    json_derived: ClassVar = ("findings",)

    @property
    def unit(self) -> str:
        """Display unit of the error."""
        return GOALS[self.figure].display

    @property
    def coarse(self) -> bool:
        """Whether the sweeps are coarse, all alike."""
        return any(sweep.coarse for sweep in self.divisions[0].sweeps.values())

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Range of each sweep, sweeps that end early, and why nothing holds."""
        sweeps = self.divisions[0].sweeps
        found = [finding("CL765")] if self.coarse else [*_ranges(sweeps)]
        for quantity in sweeps:
            early = ((cost.name, cost.sweeps[quantity]) for cost in self.divisions if cost.sweeps[quantity].ended_early)
            ended = grouped((amount(quantity, float(sweep.values[-1])), name) for name, sweep in early)
            found += [finding("CL761", words(quantity), last=last, names=names) for last, names in ended.items()]
        failed = ((cost.name, sweep) for cost in self.divisions for sweep in cost.sweeps.values() if math.isnan(sweep.most))
        return (*found, *(self._nothing_holds(f"{name}, {words(sweep.quantity)}", sweep) for name, sweep in failed))

    def _nothing_holds(self, place: str, sweep: LinkSweep) -> Finding:
        least = amount(sweep.quantity, float(sweep.values[0]))
        if sweep.limited_by == "error":
            error, allowed = (figure(value, self.unit, 4) for value in (float(sweep.error[0]), self.allowed))
            return finding("CL762", place, least=least, error=error, allowed=allowed)
        return finding("CL763" if sweep.limited_by == "unstable" else "CL764", place, least=least)


def _ranges(sweeps: Mapping[str, LinkSweep]) -> Iterator[Finding]:
    """Yield the ranges tested, once for all quantities with the same."""
    gaps = ((quantity, sweep, np.diff(sweep.values, prepend=0.0)) for quantity, sweep in sweeps.items())
    ranges = grouped(((amount(of, float(gap[gap > 0.0].min())), amount(of, sweep.asked)), words(of)) for of, sweep, gap in gaps)
    for (step, last), names in ranges.items():
        yield finding("CL759", ", ".join(names), step=step, last=last)


@dataclass(frozen=True, eq=False)
class LinkResult(Answer):
    """What dividing the controllers of some schemes costs.

    Attributes
    ----------
    scenario : Scenario
    schemes : dict of str to SchemeCost
    findings : tuple of Finding
    """

    SILENT = True

    scenario: Scenario = field(repr=False)
    schemes: dict[str, SchemeCost]
    findings: tuple[Finding, ...] = ()
    interrupted: bool = False
    plots: tuple[Path, ...] = ()
    folder: str = ""

    json_form: ClassVar = {"name": "scenario.name", "schemes": "schemes", "findings": "findings"}

    @property
    def text(self) -> str:
        """The cost of each scheme as tables, and its findings."""
        several = len(self.scenario.cases()) > 1
        texts = [scheme_text(name if several else self.scenario.name, of_scheme) for name, of_scheme in self.schemes.items()]
        texts += [paragraphs(map(str, self.findings))] if self.findings else []
        texts += ["\n".join(f"plot: {file}" for file in self.plots)] if self.plots else []
        return "\n\n".join([*texts, *([f"results: {self.folder}"] if self.folder else [])])

    @property
    def stopped(self) -> BaseException | None:
        """The interrupt that ended the work, if one did."""
        kept = Path(self.folder) / "summary.json"
        return interrupt(f"Finished before, and kept in {kept}:\n\n{self.text}") if self.interrupted else None

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The divisions, one a row [SI]."""
        return [
            {"scheme": name, "division": cost.name, "undivided": scheme.undivided, "allowed": scheme.allowed}
            | {quantity: sweep.most for quantity, sweep in cost.sweeps.items()}
            for name, scheme in self.schemes.items()
            for cost in scheme.divisions
        ]

    def _charts(self) -> Iterator[Chart]:
        for name, of_scheme in self.schemes.items():
            yield from link_charts(name if len(self.schemes) > 1 else "", of_scheme)

    def save(self, folder: str | Path = "results", *, plots: Sequence[str] = ()) -> LinkResult:
        """Write ``summary.json`` and pictures into a folder.

        Parameters
        ----------
        folder : str or Path
        plots : sequence of str
            Formats: png, svg or pdf; into ``plots`` in the folder.

        Returns
        -------
        LinkResult
            With the names of its files.

        Raises
        ------
        OutputError
            If the folder cannot be written to.
        """
        files = self._put(folder, plots, self.scenario.inputs, "summary.json")
        return replace(self, plots=files, folder=str(folder))

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Find what the error depends on."""
        return None if self.interrupted else ["sensitivity", *asked.given]


# --- text --------------------------------------------------------------------------------------------------------------------------------


def scheme_text(name: str, costs: SchemeCost) -> str:
    """Return the cost of the divisions of a scheme as tables, followed by the findings."""
    divisions, unit = costs.divisions, costs.unit
    quantities = [quantity for quantity in QUANTITIES if quantity in divisions[0].sweeps]
    undivided, allowed = (figure(value, unit, 4) for value in (costs.undivided, costs.allowed))
    head = f"{name}\n{costs.figure.replace('_', ' ')}: {undivided} undivided, {allowed} allowed"
    title = "Largest value that holds, all others as given; times are for one direction"
    left = Column("in the axis, messages", left=True)
    errors = ("diverges" if math.isnan(cost.error) else figure(cost.error, unit, 4).removesuffix(f" {unit}") for cost in divisions)
    rows = (
        (cost.name, error, *(largest_held(cost.sweeps[quantity]) for quantity in quantities))
        for cost, error in zip(divisions, errors, strict=True)
    )
    largest = Table([left, Column(f"error [{unit}]"), *(Column(words(quantity)) for quantity in quantities)], title, rows=rows)
    parts = [head + _slowest(costs), largest.text()]
    timed = [quantity for quantity in ("message_period", "delay") if quantity in quantities]
    if timed and not costs.coarse:
        title = "Largest value at which the loop is stable, by linear model / by simulation without friction (-: unknown)"
        rows = ((cost.name, *(_stable(cost.sweeps[quantity]) for quantity in timed)) for cost in divisions)
        parts.append(Table([left, *(Column(words(quantity)) for quantity in timed)], title, rows=rows).text())
    shared = [one for one in divisions[0].findings if all(one in cost.findings for cost in divisions)]
    lines = [str(one) for one in (*costs.findings, *shared)]
    lines += [f"{cost.name}: {one}" for cost in divisions for one in cost.findings if one not in shared]
    return "\n\n".join([*parts, paragraphs(lines)])


def _slowest(costs: SchemeCost) -> str:
    """Return a line with the slowest messages that hold; empty if their period was not varied."""
    swept = {cost.name: cost.sweeps["message_period"] for cost in costs.divisions if "message_period" in cost.sweeps}
    holding = {name: sweep.most for name, sweep in swept.items() if not math.isnan(sweep.most)}
    if not holding:
        return "\nno message period holds" if swept else ""
    best = max(holding, key=holding.__getitem__)
    return "\n" + paragraphs([f"slowest messages that hold: {largest_held(swept[best])}; in the axis: {best}"])


def largest_held(sweep: LinkSweep) -> str:
    """Return the largest value of a sweep that holds as text; of a coarse sweep the two values between which it lies."""
    if math.isnan(sweep.most):
        return "none"
    most = amount(sweep.quantity, sweep.most)
    if sweep.coarse and sweep.limited:
        low, high = most.split(), amount(sweep.quantity, sweep.fails)
        return f"{low[0]} to {high}" if high.endswith(low[1]) else f"{most} to {high}"
    text = most + (f" ({figure(sweep.rate, 'Hz', 4)})" if sweep.quantity == "message_period" else "")
    return text if sweep.limited else f"all up to {text}"


def _stable(sweep: LinkSweep) -> str:
    def limit(value: float, unstable: bool) -> str:
        if math.isnan(value):
            return "none" if unstable else "-"
        return "all" if math.isinf(value) else amount(sweep.quantity, value)

    # An unstable value without a limit means that the first known value is already unstable.
    linear, simulated = bool((sweep.growth >= 1.0).any()), bool((sweep.repeats > 1.0 + GROWN).any())
    return f"{limit(sweep.stable_linear, linear)} / {limit(sweep.stable_simulated, simulated)}"


def words(quantity: str) -> str:
    """Return the name of a quantity as text."""
    return quantity.replace("_", " ")


def amount(quantity: str, value: float) -> str:
    """Return a value of a quantity with its display unit."""
    return figure(value, "%") if quantity == "loss" else figure(value, "ms" if value < 9.9995 else "s", 4)


# --- pictures ----------------------------------------------------------------------------------------------------------------------------


def link_charts(name: str, costs: SchemeCost) -> Iterator[Chart]:
    """Yield a chart of the contour error over each quantity, one curve per division; `name` becomes part of the file names."""
    slug = re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")
    what, scale = f"{costs.figure.replace('_', ' ')} [{costs.unit}]", GOALS[costs.figure].factor
    level = Level(scale * costs.allowed, f"allowed (undivided: {scale * costs.undivided:.3g})")
    styles = [scheme_style(i, len(costs.divisions)) for i in range(len(costs.divisions))]
    for quantity in costs.divisions[0].sweeps:
        label, factor, title = _TITLES[quantity]
        swept = [(cost.name, cost.sweeps[quantity], style) for cost, style in zip(costs.divisions, styles, strict=True)]
        curves = tuple(Curve(sweep.values * factor, scale * sweep.error, division, *style) for division, sweep, style in swept)
        caption = "A curve ends early where none of its last values holds. With jitter or loss: the worst of several runs."
        key = "-".join(filter(None, ("link", slug, quantity.replace("_", "-"))))
        yield Chart(key, title, caption, (Panel(label, what, curves, (level,), log_y=True),))
