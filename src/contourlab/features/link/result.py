"""The result of ``contourlab link``: as JSON, as text, and as pictures."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from contourlab.features.link.cost import DivisionCost
from contourlab.features.link.sweep import GROWN, QUANTITIES, LinkSweep
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.report.charts import Chart, Curve, Level, Panel
from contourlab.report.style import scheme_style
from contourlab.report.table import Column, Table, paragraphs

FIGURES = {"rms": "contour_error_rms", "max": "contour_error_max", "integral": "contour_error_integral"}
"""Figures of the contour error, by the names of the option."""
_TITLES = {
    "message_period": ("message period [ms]", 1e3, "Messages less often"),
    "delay": ("delay each way [ms]", 1e3, "Messages later"),
    "jitter": ("jitter [ms]", 1e3, "Messages with jitter"),
    "loss": ("messages lost [%]", 100.0, "Messages lost"),
}


@dataclass(frozen=True)
class SchemeCost:
    """What the divisions of one scheme cost.

    Attributes
    ----------
    figure : str
        Of `FIGURES`, its value.
    undivided, allowed : float [m, or m s]
        Error of the undivided loop, and the largest allowed.
    divisions : tuple of DivisionCost
    findings : tuple of Finding
        On single divisions, where they end and why nothing holds.
    """

    figure: str
    undivided: float
    allowed: float
    divisions: tuple[DivisionCost, ...]
    findings: tuple[Finding, ...] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "findings", tuple(self._found()))

    @property
    def unit(self) -> str:
        """Display unit of the error."""
        return "um s" if self.figure == "contour_error_integral" else "um"

    def _found(self) -> Iterator[Finding]:
        for quantity, sweep in self.divisions[0].sweeps.items():
            gaps = np.diff(sweep.values, prepend=0.0)
            step = amount(quantity, float(gaps[gaps > 0.0].min()))
            yield finding("CL759", words(quantity), step=step, last=amount(quantity, sweep.asked))
            ended: dict[str, list[str]] = {}
            for cost in self.divisions:
                if cost.sweeps[quantity].ended_early:
                    ended.setdefault(amount(quantity, float(cost.sweeps[quantity].values[-1])), []).append(cost.name)
            yield from (finding("CL761", words(quantity), last=last, names=names) for last, names in ended.items())
        for cost in self.divisions:
            for quantity, sweep in cost.sweeps.items():
                if math.isnan(sweep.most):
                    yield self._nothing_holds(f"{cost.name}, {words(quantity)}", sweep)

    def _nothing_holds(self, place: str, sweep: LinkSweep) -> Finding:
        least = amount(sweep.quantity, float(sweep.values[0]))
        if sweep.limited_by == "error":
            error, allowed = (figure(value, self.unit, 4) for value in (float(sweep.error[0]), self.allowed))
            return finding("CL762", place, least=least, error=error, allowed=allowed)
        return finding("CL763" if sweep.limited_by == "unstable" else "CL764", place, least=least)


@dataclass(frozen=True)
class LinkResult:
    """The result of the command; `text` is what it prints."""

    name: str
    schemes: dict[str, SchemeCost]
    text: str = field(default="", metadata={"json": False})


# --- text --------------------------------------------------------------------------------------------------------------------------------


def scheme_text(name: str, costs: SchemeCost) -> str:
    """Return what the divisions of a scheme cost, as tables, and what else there is to know."""
    quantities = [quantity for quantity in QUANTITIES if any(quantity in cost.sweeps for cost in costs.divisions)]
    limits = [figure(value, costs.unit, 4) for value in (costs.undivided, costs.allowed)]
    what = costs.figure.replace("_", " ")
    parts = [f"{name}\n{what}: {limits[0]} undivided, {limits[1]} allowed", _largest(costs, quantities).text()]
    timed = [quantity for quantity in ("message_period", "delay") if quantity in quantities]
    if timed:
        parts.append(_stable_limits(costs, timed).text())
    shared = [one for one in costs.divisions[0].findings if all(one in cost.findings for cost in costs.divisions)]
    lines = [str(one) for one in (*costs.findings, *shared)]
    for cost in costs.divisions:
        lines += [f"{cost.name}: {one}" for one in cost.findings if one not in shared]
    return "\n\n".join([*parts, paragraphs(lines)])


def _largest(costs: SchemeCost, quantities: Sequence[str]) -> Table:
    title = "Largest value that holds, all others as given; times are for one direction"
    columns = [Column("in the axis, messages", left=True), Column(f"error [{costs.unit}]")]
    table = Table([*columns, *(Column(words(quantity)) for quantity in quantities)], title)
    for cost in costs.divisions:
        error = "runs away" if math.isnan(cost.error) else figure(cost.error, costs.unit, 4).removesuffix(f" {costs.unit}")
        table.add(cost.name, error, *(_most(cost.sweeps[quantity]) for quantity in quantities))
    return table


def _most(sweep: LinkSweep) -> str:
    if math.isnan(sweep.most):
        return "none"
    text = amount(sweep.quantity, sweep.most) + (f" ({figure(sweep.rate, 'Hz', 4)})" if sweep.quantity == "message_period" else "")
    return text if sweep.limited else f"all, to {text}"


def _stable_limits(costs: SchemeCost, timed: Sequence[str]) -> Table:
    title = "Largest stable value: linear model / simulated without friction; - is unknown"
    table = Table([Column("in the axis, messages", left=True), *(Column(words(quantity)) for quantity in timed)], title)
    for cost in costs.divisions:
        table.add(cost.name, *(_stable(cost.sweeps[quantity]) for quantity in timed))
    return table


def _stable(sweep: LinkSweep) -> str:
    def limit(value: float, unstable: bool) -> str:
        if math.isnan(value):
            return "none" if unstable else "-"
        return "all" if math.isinf(value) else amount(sweep.quantity, value)

    # Without a limit, an unstable value means that the first known one is unstable already.
    linear, simulated = bool((sweep.growth >= 1.0).any()), bool((sweep.repeats > 1.0 + GROWN).any())
    return f"{limit(sweep.stable_linear, linear)} / {limit(sweep.stable_simulated, simulated)}"


def words(quantity: str) -> str:
    """Return a quantity in words."""
    return quantity.replace("_", " ")


def amount(quantity: str, value: float) -> str:
    """Return a value of a quantity with its display unit."""
    return figure(value, "%") if quantity == "loss" else figure(value, "ms" if value < 9.9995 else "s", 4)


# --- pictures ----------------------------------------------------------------------------------------------------------------------------


def link_charts(name: str, costs: SchemeCost) -> Iterator[Chart]:
    """Yield a picture for each quantity: the contour error over it, one curve a division; `name` is put into the file names."""
    slug = re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")
    what = f"{costs.figure.replace('_', ' ')} [{costs.unit}]"
    level = Level(1e6 * costs.allowed, f"allowed; undivided {1e6 * costs.undivided:.3g}")
    for quantity in costs.divisions[0].sweeps:
        label, factor, title = _TITLES[quantity]
        curves = []
        for i, cost in enumerate(costs.divisions):
            sweep = cost.sweeps[quantity]
            curves.append(Curve(sweep.values * factor, 1e6 * sweep.error, cost.name, *scheme_style(i, len(costs.divisions))))
        caption = "A curve that ends early: none of its last values held. With jitter or loss, the worst of several runs."
        key = "-".join(filter(None, ("link", slug, quantity.replace("_", "-"))))
        yield Chart(key, title, caption, (Panel(label, what, tuple(curves), (level,), log_y=True),))
