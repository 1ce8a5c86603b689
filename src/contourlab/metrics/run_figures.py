"""The figures of a run, each once: label, units and formula. Batches, studies, stores and reports read this table alone.

A figure is made from sums over the judged samples. The lanes of a batch keep them while they run (`contourlab.metrics.streaming`), and
`figures_of_run` takes them from the signals of a single run. A new entry of the table is a column of a sweep, an objective of a
calibration, a swap, a link and a sensitivity study, and a row of the report.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.errors import ParameterError
from contourlab.feed.reference import Judged
from contourlab.figures import FACTORS
from contourlab.metrics.figures import blocks_of, count_of, largest, total
from contourlab.metrics.judge import squares
from contourlab.metrics.streaming import SUMS
from contourlab.result import Result

CONTOUR, PART, EFFORT = "contour", "part", "effort"
"""Where sums come from: the contour error, the part error, the commands to the drives."""


FORMS = {"m": ("um", 1e-6), "m s": ("um s", 2e-6), "s": ("s", 1e-6), "": ("%", 1e-3)}
"""For each SI unit the unit in print, and the value [SI] below which all are equally good: of the integral a mean of 1 um over 2 s."""


@dataclass(frozen=True)
class RunFigure:
    """A figure of a run.

    Attributes
    ----------
    name, label : str
        Name in code, stores and JSON, and name in print.
    unit : str
        SI unit, one of `FORMS`.
    of : callable
        Returns the figure from the sums of its source and ``period``, the servo period [s]. They are numbers of a run, or arrays of many.
    source : str
        `CONTOUR`, `PART` or `EFFORT`.
    word : str
        Short name on the command line, if any.
    is_goal : bool
        Whether less of it is better, so that a study can minimise it.
    is_row : bool
        Whether the report has a row for it. Some have rows of their own there: the signed mean in the plane, the tracking error by axis.
    """

    name: str
    label: str
    unit: str
    of: Callable[[Mapping[str, Any]], Any]
    source: str = CONTOUR
    word: str = ""
    is_goal: bool = True
    is_row: bool = True

    @property
    def display(self) -> str:
        """The unit in print, one of `contourlab.figures.FACTORS`."""
        return FORMS[self.unit][0]

    @property
    def factor(self) -> float:
        """Factor from the SI unit to the unit in print."""
        return FACTORS[self.display]

    @property
    def floor(self) -> float:
        """Values [SI] below this are equally good: J_tol of a swap."""
        return FORMS[self.unit][1]

    @property
    def title(self) -> str:
        """The label within a sentence: ``largest part error``."""
        what, _, kind = self.label.partition(", ")
        return f"{kind} {what}" if kind in ("largest", "rms", "mean", "signed mean") else f"{what} {kind}".strip()

    @property
    def quantity(self) -> str:
        """The SI unit as `contourlab.units` reads it."""
        return self.unit.replace(" ", "*")

    def example(self, value: float) -> str:
        """Return a value as typed."""
        return f"{value:g} {self.display}".replace("m s", "m*s")


REMARK: Any = {"is_goal": False, "is_row": False}
_TABLE = (
    RunFigure("contour_error_integral", "contour error, integral", "m s", lambda s: s["sum_magnitude"] * s["period"], word="integral"),
    RunFigure("contour_error_rms", "contour error, rms", "m", lambda s: np.sqrt(s["sum_square"] / s["count"]), word="rms"),
    RunFigure("contour_error_max", "contour error, largest", "m", lambda s: s["largest"], word="max"),
    RunFigure("contour_error_mean", "contour error, mean", "m", lambda s: s["sum_magnitude"] / s["count"]),
    RunFigure("contour_error_max_time", "time of the largest contour error", "s", lambda s: s["largest_at"] * s["period"], **REMARK),
    RunFigure("contour_error_signed_mean", "contour error, signed mean", "m", lambda s: s["sum_signed"] / s["count"], **REMARK),
    RunFigure(
        "tracking_error_rms",
        "tracking error, rms",
        "m",
        lambda s: np.sqrt(s["sum_tracking"] / s["count"]),
        CONTOUR,
        "tracking",
        is_row=False,
    ),
    RunFigure("tracking_error_max", "tracking error, largest", "m", lambda s: np.sqrt(s["largest_tracking"]), is_row=False),
    RunFigure("part_error_max", "part error, largest", "m", lambda s: s["largest"], PART, "part"),
    RunFigure("part_error_rms", "part error, rms", "m", lambda s: np.sqrt(s["sum_square"] / s["count"]), PART),
    RunFigure("command_energy", "command energy", "s", lambda s: s["sum_square"] * s["period"], EFFORT, "energy"),
    RunFigure("command_largest", "largest command, share of the drive's limit", "", lambda s: s["largest"], EFFORT, **REMARK),
    RunFigure("limited_share", "time at a drive's limit", "", lambda s: s["limited"] / s["count"], EFFORT, **REMARK),
)
FIGURES = {figure.name: figure for figure in _TABLE}
GOALS = {figure.name: figure for figure in _TABLE if figure.is_goal}
"""Figures that a study can minimise."""


def goal_named(text: str, option: str, others: str = "") -> RunFigure:
    """Return the figure of `GOALS` that a text names, by its word or its name.

    Raises
    ------
    ParameterError
        If there is none. `option` is what the text was given for, and `others` what else it may be.
    """
    for figure in GOALS.values():
        if text in (figure.name, figure.word or figure.name):
            return figure
    words = ", ".join(filter(None, (figure.word for figure in GOALS.values())))
    raise ParameterError(option, repr(text), f"one of {words}, or the name of a figure, such as contour_error_rms{others}")


def title_of(name: str) -> str:
    """Return a figure of a run, or its ``cycle_time``, in words.

    >>> title_of("part_error_max"), title_of("cycle_time")
    ('largest part error', 'cycle time')
    """
    return FIGURES[name].title if name in FIGURES else name.replace("_", " ")


def needs(names: Iterable[str]) -> dict[str, bool]:
    """Return the options of `contourlab.loop.simulate_batch` that figures need; names that are none of `FIGURES` need nothing."""
    sources = {FIGURES[name].source for name in names if name in FIGURES}
    return {"part": PART in sources, "effort": EFFORT in sources}


def figures_from(source: str, sums: Mapping[str, Any], period: float) -> dict[str, Any]:
    """Return the figures of a source from its sums; `period` is the servo period [s]."""
    total = {**sums, "count": np.maximum(sums["count"], 1.0), "period": period}
    return {name: figure.of(total) for name, figure in FIGURES.items() if figure.source == source}


def figures_of_run(run: Result, judged: Judged) -> dict[str, float]:
    """Return the figures of contour error and part error of a judged run over some of its samples."""
    figures: dict[str, float] = {}
    tracking = [total(run, "tracking_error", judged, squares)[0]]
    tracking.append(max(squares(run["tracking_error"][cut]).max() for cut in blocks_of(judged)))
    for source in (CONTOUR, PART):
        name = f"{source}_error"
        size, sample = largest(run, name, judged)
        parts = (count_of(judged), *total(run, name, judged, np.abs, np.square, np.asarray), size, sample + run.start, *tracking)
        sums = dict(zip(SUMS, parts, strict=False))
        figures |= {name: float(value) for name, value in figures_from(source, sums, run.servo_period).items()}
    return figures
