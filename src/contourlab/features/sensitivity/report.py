"""Tables and pictures of a sensitivity study, in display units."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from contourlab.arrays import Array, Flags
from contourlab.features.sensitivity.curves import CHANGE, Curve, Interval
from contourlab.features.sensitivity.options import PARTS
from contourlab.features.sensitivity.study import Drawn, Sample, Study
from contourlab.figures import figure
from contourlab.rendering.charts import Bars, Matrix, Multiples, Series, Tile
from contourlab.rendering.charts import Curve as Line
from contourlab.rendering.style import MUTED, scheme_style
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.study import DesignVariable

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
    for part in (_curves, _local, _interactions, _morris, _sobol):
        yield from (table.text() for table in part(study))


def _overview(study: Study) -> Table:
    assert study.curves is not None and study.sobol is not None
    title = "Share of the variance (total Sobol index); best value of this parameter alone, and the part of the error that it leaves:"
    table = _table(title, ("share [%]", "present", "best", "unit", "leaves [%]"), left=("unit",))
    indices = study.sobol
    for j in np.argsort(-indices.total, kind="stable"):
        variable, lowest = study.space.numbers[j], study.curves[j].minimum
        best = ("-", "-") if lowest is None else (*_shown(variable, lowest.value), figure(100.0 * lowest.figure / study.present))
        share = " +-".join(figure(100.0 * float(values[j]), digits=2) for values in (indices.total, indices.total_interval))
        table.add(variable.short, share, *_shown(variable, variable.value), best[0], variable.display_unit, best[1])
    return table


def _table(title: str, heads: Sequence[str], left: Sequence[str] = (), prose: Sequence[str] = ()) -> Table:
    return Table([Column("parameter", left=True), *(Column(head, left=head in left, prose=head in prose) for head in heads)], title)


def _shown(variable: DesignVariable, *values: float) -> Iterator[str]:
    return (figure(variable.display_value(value), digits=4) for value in values)


def _curves(study: Study) -> Iterator[Table]:
    if study.curves is None:
        return
    unit = study.plan.judged.display
    title = f"One parameter at a time, {study.plan.values} values each, the others at their present values:"
    flat = f"changes by less than {100.0 * CHANGE:.0f} %"
    heads = ("present", "from", "to", "unit", "minimum at", "+-", "figure at minimum", "bound", flat, "runs fail")
    table = _table(title, heads, left=("unit", "bound", flat, "runs fail"))
    for curve in study.curves:
        variable, lowest = curve.variable, curve.minimum
        minimum = ["-"] * 3 + [""]
        if lowest is not None:
            within = figure(variable.display_value(lowest.within), digits=1)
            minimum = [*_shown(variable, lowest.value), within, figure(lowest.figure, unit, 4), lowest.bound]
        failed = ", ".join(_range(variable, interval) for interval in curve.failed)
        table.add(
            variable.short,
            *_shown(variable, variable.value, variable.low, variable.high),
            variable.display_unit,
            *minimum,
            "" if curve.flat is None else _range(variable, curve.flat),
            failed,
        )
    yield table


def _range(variable: DesignVariable, interval: Interval) -> str:
    return f"{figure(variable.display_value(interval.low))} to {figure(variable.display_value(interval.high))}"


def _local(study: Study) -> Iterator[Table]:
    if study.local is None:
        return
    heads = ("sensitivity [%/%]", "step", "change with twice the step", "below", "above", "doubt")
    table = _table("Small changes: percent of the figure per percent of the parameter:", heads, left=("doubt",))
    for slope in study.local.slopes:
        slopes = (figure(value) for value in (slope.difference, slope.below, slope.above))
        doubt = slope.doubt.entry.name if slope.doubt else ""
        table.add(slope.variable.short, figure(slope.sensitivity), figure(slope.step, "%"), *slopes, doubt)
    yield table


def _interactions(study: Study) -> Iterator[Table]:
    if study.local is None or not 1 < len(study.space.numbers) <= FEW:
        return
    matrix, doubtful = study.local.interactions, study.local.doubtful
    step = figure(float(study.local.interaction_steps.max()), "%", 2)
    title = f"Interactions: second differences relative to the figure (step {step}); ?: changes by half or more with half the step:"
    table = _table(title, [str(j + 1) for j in range(len(matrix))])
    for j, (variable, values) in enumerate(zip(study.space.numbers, matrix, strict=True)):
        cells = (figure(value, digits=2) + "?" * int(doubtful[j, k]) for k, value in enumerate(values))
        table.add(f"{j + 1} {variable.short}", *cells)
    yield table


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
    table = _table(title, [*heads, "distribution"], prose=("distribution",))
    for j in np.argsort(-by, kind="stable"):
        cells = (figure(float(values[j])) for values in columns)
        table.add(study.space.numbers[j].short, *cells, _distribution(study.distributions[j]))
    return table


def _morris(study: Study) -> Iterator[Table]:
    if study.morris is None:
        return
    indices, plan = study.morris, study.plan
    scale, unit = (1.0, "decades") if plan.transform == "log" else (plan.judged.factor, plan.judged.display)
    title = f"Elementary effects (Morris) over the whole range [{unit}] {_sampled(study.morris_sample)}:"
    columns = [scale * values for values in (indices.mu_star, indices.mu_star_interval, indices.mu, indices.sigma)]
    yield _estimates(study, title, ("mu*", *ESTIMATE, "mu", "sigma"), columns, indices.mu_star)


def _sobol(study: Study) -> Iterator[Table]:
    if study.sobol is None:
        return
    indices, names = study.sobol, [variable.short for variable in study.space.numbers]
    title = f"Shares of the variance (Sobol, Saltelli N = {study.plan.base}) {_sampled(study.sobol_sample)}:"
    columns = (indices.first, indices.first_interval, indices.total, indices.total_interval)
    yield _estimates(study, title, ("first", *ESTIMATE, "total", *ESTIMATE), columns, indices.total)
    if indices.second is not None and indices.second_interval is not None:
        table = Table([Column("pair", left=True), Column("share of the interaction"), *map(Column, ESTIMATE)])
        pairs = sorted(np.argwhere(np.isfinite(indices.second)).tolist(), key=lambda pair: -indices.second[tuple(pair)])  # type: ignore[index]
        for j, k in pairs[:MOST_PAIRS]:
            table.add(f"{names[j]} with {names[k]}", figure(indices.second[j, k]), figure(indices.second_interval[j, k]))
        yield table


def charts_of(study: Study) -> list[Multiples | Bars | Matrix]:
    """Return a chart for each part of a study: curves, Morris and Sobol indices, interactions."""
    figure, names = study.plan.judged, [variable.short for variable in study.space.numbers]
    charts: list[Multiples | Bars | Matrix] = []
    if study.curves is not None:
        tiles = tuple(curve_tile(curve, figure.factor) for curve in study.curves)
        charts.append(Multiples("curves", f"One parameter at a time: {figure.label}", "", f"{figure.label} [{figure.display}]", tiles))
    charts += _indices(study, names)
    if study.local is not None and len(names) > 1:
        title = f"Interactions near the present values: {figure.label}"
        charts.append(interactions_chart(title, names, study.local.interactions, study.local.doubtful))
    return charts


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


def _indices(study: Study, names: list[str]) -> Iterator[Bars]:
    figure, logarithmic = study.plan.judged, study.plan.transform == "log"
    if study.sobol is not None:
        s = study.sobol
        shares = (("first order", s.first, s.first_interval), ("total", s.total, s.total_interval))
        title = f"Sobol indices of {'log10 of the' if logarithmic else 'the'} {figure.label}"
        yield indices_chart("sobol", title, "share of the variance, with 95 % intervals", names, shares)
    if study.morris is not None:
        scale, unit = (1.0, "decades") if logarithmic else (figure.factor, figure.display)
        m = study.morris
        effects = (("sigma", m.sigma * scale, 0.0 * m.sigma), ("mu*", m.mu_star * scale, m.mu_star_interval * scale))
        label = f"mean magnitude of the elementary effects [{unit}]"
        yield indices_chart("morris", f"Elementary effects (Morris) on the {figure.label}", label, names, effects)


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
