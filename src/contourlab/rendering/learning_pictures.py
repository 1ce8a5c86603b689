"""Learning in pictures: the error of each trial, and the factor of a trial at each frequency."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from contourlab.analysis.learning.learning_analysis import LearningAnalysis
from contourlab.arrays import Array
from contourlab.figures import figure, number
from contourlab.rendering.charts import Chart, Curve, Level, Panel, Tick, traces_chart
from contourlab.rendering.data import ReportData, TrialCourse
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import Column, Table


def trial_charts(data: ReportData) -> tuple[Chart, ...]:
    """Return the errors of each trial, with schemes that do not learn as levels, and the predictions; nothing if none learns."""
    counts = [len(scheme.trials.contour_rms) for scheme in data.schemes if scheme.trials is not None]
    if not counts:
        return ()
    contour, tracking, ends, courses = [], [], [], []
    for i, scheme in enumerate(data.schemes):
        look, course = data.looks[scheme.name], scheme.trials
        if course is None:
            level = np.full(2, scheme.metrics.contour_error.rms * 1e6)
            contour.append(Curve(np.array([0.0, max(*counts, 2) - 1.0]), level, *look[:2], "dot"))
            continue
        trial = np.arange(len(course.contour_rms), dtype=float)
        contour.append(Curve(trial, _drawn(course.contour_rms), *look))
        tracking.append(Curve(trial, _drawn(course.whole_rms), *look))
        first, best = course.contour_rms[0], course.contour_rms[course.best]
        ends.append(f"{scheme.name}: {figure(first, 'um')} to {figure(best, 'um')}; {course.in_words}")
        if course.errors and len(data.axes) > 1:
            courses.append(_course_chart(f"trials-{i}", scheme.name, course))
    panels = (
        Panel("trial", "contour rms [um]", tuple(contour), log_y=True),
        Panel("trial", "tracking rms [um]", tuple(tracking), log_y=True),
    )
    caption = f"Error of each trial. Trial 0 is the first run, before any learning. {'. '.join(ends)}. Dotted: schemes that do not learn."
    foretold = {scheme.name: scheme.foretold for scheme in data.schemes if scheme.foretold is not None}
    return (Chart("trials", "Error of each trial", caption, panels), *courses, *(learning_charts(foretold) if foretold else ()))


SHOWN = (0, 1, 2, 5, 10, 20, 50, 100, 200, 500)
"""Trials whose errors are drawn, besides the best and the last."""


def _course_chart(key: str, name: str, course: TrialCourse) -> Chart:
    """Return the contour error of some trials over time."""
    last = len(course.errors) - 1
    shown = sorted({trial for trial in SHOWN if trial < last} | {min(course.best, last), last})
    traces = {f"trial {k}" + ", the best" * (k == course.best): (course.errors[k][0], course.errors[k][1] * 1e6) for k in shown}
    title, caption = f"Contour error of the trials of {name}", "A click on a name hides or shows the curve of its trial."
    return traces_chart(key, title, ("time [s]", "contour error [um]"), traces, caption=caption, level=None)


def trial_rows(course: TrialCourse) -> list[tuple[int, float, float]]:
    """Return trial, contour rms [m] and tracking rms [m] of some trials: the first ones, some between, the best, the last.

    >>> [row[0] for row in trial_rows(TrialCourse(np.ones(31), np.ones((31, 2)), 17, "converged"))]
    [0, 1, 2, 3, 4, 5, 10, 15, 17, 20, 25, 30]
    """
    last = len(course.contour_rms) - 1
    step = max(5, -(-last // 10))
    shown = sorted({*range(min(last, 5) + 1), *range(0, last + 1, step), course.best, last})
    return [(i, float(course.contour_rms[i]), float(course.whole_rms[i])) for i in shown]


def trials_text(data: ReportData) -> str:
    """Return the trials of each scheme that learns; empty if none learns."""
    columns, tables = [*map(Column, ("trial", "contour rms [um]", "tracking rms [um]")), Column("", left=True)], []
    for scheme in data.schemes:
        if (course := scheme.trials) is not None:
            rows = (
                (str(trial), number(contour * 1e6, 4), number(tracking * 1e6, 4), "best" if trial == course.best else "")
                for trial, contour, tracking in trial_rows(course)
            )
            tables.append(Table(columns, scheme.name, rows=rows).text())
    return "\n\n".join(tables)


def _drawn(rms: Array) -> Array:
    """Return an error in um for a logarithmic axis: nan instead of 0."""
    return np.asarray(np.where(rms > 0.0, rms * 1e6, np.nan))


def learning_charts(analyses: Mapping[str, LearningAnalysis]) -> tuple[Chart, ...]:
    """Return the factor of a trial over frequency, and where it exceeds 1; `analyses` by scheme."""
    count = len(analyses)
    curves, excess, ticks = [], [], []
    for i, (name, analysis) in enumerate(analyses.items()):
        look, hertz = (name, *scheme_style(i, count)), analysis.response.frequency / (2.0 * np.pi)
        curves.append(Curve(hertz, analysis.response.radius, *look))
        excess.append(Curve(hertz, 100.0 * np.maximum(analysis.response.radius - 1.0, 0.0), *look))
        if np.isfinite(analysis.zero):
            ticks.append(Tick(analysis.zero / (2.0 * np.pi), f"first zero of the moving average, {name}", "first zero"))
    top = 1.1 * max(1.0, min(2.0, max(float(curve.y.max()) for curve in curves)))
    one = (Level(1.0, "1: no change"),)
    factor = Panel("frequency [Hz]", "error factor per trial", tuple(curves), one, log_x=True, y_range=(0.0, top))
    beyond = Panel("frequency [Hz]", "growth per trial [%]", tuple(excess), ticks=tuple(ticks), log_x=True)
    caption = "Factor by which one trial multiplies the error at each frequency, for the worst direction of the path."
    caption += " Dots mark the first zero of the moving average." if ticks else ""
    return (Chart("learning-factor", "Convergence of learning", caption, (factor, beyond)),)


def singular_value_chart(values: Mapping[str, np.ndarray]) -> Chart:
    """Return the singular values (n,) of the operator from trial to trial in descending order, by scheme."""
    traces = {name: (np.arange(1.0, len(each) + 1.0), np.sort(np.asarray(each, dtype=float))[::-1]) for name, each in values.items()}
    caption = "Factor by which one trial multiplies each error pattern. If all are below 1, every trial is better than the last."
    title, labels = "Singular values from trial to trial", ("number", "singular value")
    return traces_chart("learning-singular-values", title, labels, traces, caption=caption, level=Level(1.0, "1: no change"))
