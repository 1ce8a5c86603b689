"""Learning from trial to trial, as pictures: the error of each trial."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ParameterError
from contourlab.figures import figure
from contourlab.report.charts import Chart, Curve, Panel
from contourlab.report.learning_pictures import learning_charts
from contourlab.report.style import scheme_style

if TYPE_CHECKING:
    from contourlab.report.data import ReportData

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class TrialCourse:
    """How the error went from trial to trial.

    Parameters
    ----------
    contour_rms : ndarray (n_trial,) [m]
        NaN for a trial that did not come to its end.
    tracking_rms : ndarray (n_trial, n_axis) [m]
    best : int
        The trial that the scheme's figures are of.
    status : str
        How it ended.
    """

    contour_rms: Array
    tracking_rms: Array
    best: int
    status: str

    def __post_init__(self) -> None:
        n = len(self.contour_rms)
        if n == 0 or self.tracking_rms.ndim != 2 or len(self.tracking_rms) != n or not 0 <= self.best < n:
            raise ParameterError("trials", f"{n} contour errors, tracking errors {self.tracking_rms.shape}", "one row for each trial")

    @property
    def in_words(self) -> str:
        """The end of learning in a few words."""
        trials = len(self.contour_rms) - 1
        return self.status if self.status.startswith("diverged") else f"{self.status}, trial {self.best} of {trials}"


def trial_charts(data: ReportData) -> tuple[Chart, ...]:
    """Return the errors of each trial, those of schemes that do not learn as level lines, and what was foretold; nothing where none learns.

    Parameters
    ----------
    data : ReportData
    """
    learning = [(i, scheme) for i, scheme in enumerate(data.schemes) if scheme.trials is not None]
    if not learning:
        return ()
    last = max(len(scheme.trials.contour_rms) for _, scheme in learning if scheme.trials) - 1
    contour, tracking, ends = [], [], []
    for i, scheme in enumerate(data.schemes):
        colour, dash = scheme_style(i, len(data.schemes))
        course = scheme.trials
        if course is None:
            level = np.full(2, scheme.metrics.contour_error.rms * 1e6)
            contour.append(Curve(np.array([0.0, max(last, 1)]), level, scheme.name, colour, "dot"))
            continue
        trial = np.arange(len(course.contour_rms), dtype=float)
        contour.append(Curve(trial, _drawn(course.contour_rms), scheme.name, colour, dash))
        whole = np.sqrt(np.square(course.tracking_rms).sum(axis=1))
        tracking.append(Curve(trial, _drawn(whole), scheme.name, colour, dash))
        first, best = course.contour_rms[0], course.contour_rms[course.best]
        ends.append(f"{scheme.name}: {figure(first, 'um')} to {figure(best, 'um')}; {course.in_words}")
    panels = (
        Panel("trial", "contour rms [um]", tuple(contour), log_y=True),
        Panel("trial", "tracking rms [um]", tuple(tracking), log_y=True),
    )
    caption = f"Errors of each trial; trial 0 has learned nothing. {'. '.join(ends)}. Schemes that do not learn are drawn dotted."
    foretold = {scheme.name: scheme.foretold for scheme in data.schemes if scheme.foretold is not None}
    return (Chart("trials", "Error of each trial", caption, panels), *(learning_charts(foretold) if foretold else ()))


def trial_rows(course: TrialCourse) -> list[tuple[int, float, float]]:
    """Return trial, contour rms [m] and tracking rms [m] of the trials worth printing: the first ones, some between, the best, the last.

    >>> [row[0] for row in trial_rows(TrialCourse(np.ones(31), np.ones((31, 2)), 17, "converged"))]
    [0, 1, 2, 3, 4, 5, 10, 15, 17, 20, 25, 30]
    """
    last = len(course.contour_rms) - 1
    step = max(5, -(-last // 10))
    shown = sorted({*range(min(last, 5) + 1), *range(0, last + 1, step), course.best, last})
    whole = np.sqrt(np.square(course.tracking_rms).sum(axis=1))
    return [(i, float(course.contour_rms[i]), float(whole[i])) for i in shown]


def _drawn(rms: Array) -> Array:
    """Return an error in um for a logarithmic axis, which has no zero."""
    return np.asarray(np.where(rms > 0.0, rms * 1e6, np.nan))
