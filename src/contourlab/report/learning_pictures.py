"""What learning does to each frequency, before the first trial; and what a whole trial does at most."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from contourlab.analysis.learning.learning_analysis import LearningAnalysis
from contourlab.report.charts import Chart, Curve, Level, Panel, Tick
from contourlab.report.style import scheme_style


def learning_charts(analyses: Mapping[str, LearningAnalysis]) -> tuple[Chart, ...]:
    """Return the factor of a trial over frequency, and a closer view of where it exceeds 1.

    Parameters
    ----------
    analyses : mapping of str to LearningAnalysis
        By the names of the schemes; the first zero of each average is marked.
    """
    count = len(analyses)
    curves, excess, ticks, notes = [], [], [], []
    for i, (name, found) in enumerate(analyses.items()):
        look, hertz = (name, *scheme_style(i, count)), found.response.frequency / (2.0 * np.pi)
        curves.append(Curve(hertz, found.response.radius, *look))
        excess.append(Curve(hertz, 100.0 * np.maximum(found.response.radius - 1.0, 0.0), *look))
        if np.isfinite(found.zero):
            ticks.append(Tick(found.zero / (2.0 * np.pi), f"first zero of the average, {name}", "first zero"))
        notes += [f"{name}: {text}." for text in found.warnings]
    top = 1.1 * max(1.0, min(2.0, max(float(curve.y.max()) for curve in curves)))
    one = (Level(1.0, "1: nothing is learned"),)
    factor = Panel("frequency [Hz]", "factor of a trial", tuple(curves), one, log_x=True, y_range=(0.0, top))
    beyond = Panel("frequency [Hz]", "growth per trial [%]", tuple(excess), ticks=tuple(ticks), log_x=True)
    caption = " ".join(["What a trial leaves of each frequency, in the worst direction of the path.", *notes])
    return (Chart("learning-factor", "Convergence of learning", caption, (factor, beyond)),)


def singular_value_chart(values: Mapping[str, np.ndarray]) -> Chart:
    """Return the singular values of the operator from trial to trial, in falling order.

    Parameters
    ----------
    values : mapping of str to ndarray (n,)
        By the names of the schemes; all of a short trial, or the largest of a long one.
    """
    count = len(values)
    curves = tuple(
        Curve(np.arange(1.0, len(found) + 1.0), np.sort(np.asarray(found, dtype=float))[::-1], name, *scheme_style(i, count))
        for i, (name, found) in enumerate(values.items())
    )
    panel = Panel("number", "singular value", curves, (Level(1.0, "1: no smaller than before"),))
    caption = "Each is what a trial leaves of one pattern over the trial; where all are below 1, every trial is better than the last."
    return Chart("learning-singular-values", "What a trial leaves", caption, (panel,))
