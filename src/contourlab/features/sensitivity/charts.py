"""The pictures of a sensitivity study: its values handed to the report in the units of print."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from contourlab.features.sensitivity.pictures import DrawnCurve, curves_chart, indices_chart, interactions_chart
from contourlab.features.sensitivity.text import SHOWN
from contourlab.report.charts import Bars, Matrix, Multiples

if TYPE_CHECKING:
    from contourlab.features.sensitivity import Curve, Study


def charts_of(study: Study) -> list[Multiples | Bars | Matrix]:
    """Return a picture of each part of a study: curves, Sobol's and Morris' indices, interactions."""
    found: list[Multiples | Bars | Matrix] = []
    factor, unit = SHOWN[study.plan.figure.name]
    words, names = study.plan.figure.words, [number.short for number in study.space.numbers]
    if study.curves is not None:
        drawn = [_drawn(curve, factor) for curve in study.curves]
        found.append(curves_chart(f"One number at a time: {words}", f"{words} [{unit}]", drawn))
    found += _indices(study, names)
    if study.local is not None and len(names) > 1:
        title, near = f"Interactions near the present values: {words}", study.local
        found.append(interactions_chart(title, names, near.interactions, near.doubtful))
    return found


def _drawn(curve: Curve, factor: float) -> DrawnCurve:
    number, lowest = curve.number, curve.minimum
    return DrawnCurve(
        number.short,
        number.written_in or "value",
        np.array([number.shown(value) for value in curve.values]),
        curve.figures * factor,
        number.shown(number.value),
        None if lowest is None else (number.shown(lowest.value), lowest.figure * factor),
        tuple((number.shown(part.low), number.shown(part.high)) for part in curve.failed),
        number.logarithmic,
    )


def _indices(study: Study, names: list[str]) -> Iterator[Bars]:
    words = study.plan.figure.words
    if study.sobol is not None:
        s = study.sobol
        shares = (("first order", s.first, s.first_interval), ("total", s.total, s.total_interval))
        what = f"log10 of the {words}" if study.plan.logarithmic else f"the {words}"
        yield indices_chart("sobol", f"Sobol's indices of {what}", "share of the variance, with 95 % intervals", names, shares)
    if study.morris is not None:
        scale, unit = (1.0, "decades") if study.plan.logarithmic else SHOWN[study.plan.figure.name]
        m = study.morris
        effects = (("sigma", m.sigma * scale, 0.0 * m.sigma), ("mu*", m.mu_star * scale, m.mu_star_interval * scale))
        label = f"mean of the elementary effects' magnitude [{unit}]"
        yield indices_chart("morris", f"Elementary effects (Morris) over the {words}", label, names, effects)
