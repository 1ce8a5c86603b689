"""Pictures of a sensitivity study, in display units."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from contourlab.arrays import Array, Flags
from contourlab.features.sensitivity.curves import Curve
from contourlab.features.sensitivity.study import Study
from contourlab.rendering.charts import Bars, Matrix, Multiples, Series, Tile
from contourlab.rendering.charts import Curve as Line
from contourlab.rendering.style import MUTED, scheme_style


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
