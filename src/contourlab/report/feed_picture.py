"""The planned feed along the path, with what holds it at each place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ParameterError
from contourlab.figures import figure, number
from contourlab.report.charts import Chart, Curve, Panel
from contourlab.report.decimate import keep_extremes
from contourlab.report.style import REFERENCE

Array = NDArray[np.float64]
_COLOURS = ("#8a949e", "#0072b2", "#009e73", "#d55e00", "#cc79a7", "#e69f00", "#56b4e9")
_WIDTH = 2.2
BUDGET = 10_000


@dataclass(frozen=True, eq=False)
class FeedRun:
    """A planned motion along its path.

    Parameters
    ----------
    arc_length : ndarray (n,) [m]
        Not falling.
    feedrate : ndarray (n,) [m/s]
    programmed : ndarray (n,) [m/s]
        What the program asks for; inf on rapids.
    time : ndarray (n,) [s]
        Not falling.
    binding : ndarray (n,) of int
        What holds the speed from each place to the next: an index into `names`.
    names : sequence of str
    """

    arc_length: Array
    feedrate: Array
    programmed: Array
    time: Array
    binding: NDArray[np.int8]
    names: Sequence[str]

    def __post_init__(self) -> None:
        sizes = {part.shape for part in (self.arc_length, self.feedrate, self.programmed, self.time, self.binding)}
        if len(sizes) != 1 or self.arc_length.ndim != 1 or self.arc_length.size < 2:
            raise ParameterError("arrays of a feed run", sorted(sizes), "of one length, at least 2")
        if int(self.binding.min()) < 0 or int(self.binding.max()) >= len(self.names):
            raise ParameterError("binding", int(self.binding.max()), f"indices into {len(self.names)} names")

    def shares(self) -> dict[str, float]:
        """Return the part of the time for which each thing holds the speed, the largest first."""
        lasting = np.diff(self.time)
        total = float(lasting.sum()) or 1.0
        held = {name: float(lasting[self.binding[:-1] == code].sum()) / total for code, name in enumerate(self.names)}
        return dict(sorted(((name, part) for name, part in held.items() if part > 0.0), key=lambda item: -item[1]))


def feed_charts(run: FeedRun | None, unit: str = "mm/min") -> tuple[Chart, ...]:
    """Return the feed over arc length, coloured by what holds it; nothing where the motion was not planned.

    Parameters
    ----------
    run : FeedRun or None
    unit : str
        Of the picture.
    """
    if run is None:
        return ()
    kept = keep_extremes(run.feedrate, BUDGET)  # no stop is lost
    x, feed, programmed, binding = run.arc_length[kept] * 1e3, run.feedrate[kept] * 6e4, run.programmed[kept] * 6e4, run.binding[kept]
    top = float(feed.max())
    asked = np.where(programmed <= 1.5 * top, programmed, np.nan)
    curves = [Curve(x, asked, "programmed", REFERENCE, "dot")] if np.isfinite(asked).any() else []
    for code, name in enumerate(run.names):
        held = binding == code
        if not held.any():
            continue
        # A stretch goes on to the place where the next begins, so that the line has no gaps.
        drawn = held | np.append(False, held[:-1])
        curves.append(Curve(x, np.where(drawn, feed, np.nan), name, _COLOURS[code % len(_COLOURS)], "solid", _WIDTH))
    panel = Panel("arc length [mm]", f"feedrate [{unit}]", tuple(curves))
    shares = ", ".join(f"{name} {number(100.0 * part)} %" for name, part in run.shares().items() if part >= 5e-4)
    caption = (
        f"Planned speed along the path; the colour says what holds it. By time: {shares}. Cycle time {figure(float(run.time[-1]), 's')}."
        ' "Step of curvature": where a line meets an arc the acceleration steps, at a speed that keeps the step within the axes\' limits;'
        ' no jerk limit can hold there short of a stop. "Planner\'s distance": no limit is nearly used up, before or behind a slower place.'
    )
    return (Chart("feed", "Feed along the path", caption, (panel,)),)
