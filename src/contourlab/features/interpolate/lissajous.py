"""Picture of an interpolated encoder: the two signals against each other before and after correction, and the error over a period."""

from __future__ import annotations

import io
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array
from contourlab.rendering.style import scheme_style

POINTS = 6000


@dataclass(frozen=True, eq=False)
class LissajousData:
    """Data of the picture.

    Parameters
    ----------
    before, after : ndarray (n, 2)
        Signals as measured, and corrected; both divided by the amplitude.
    phase : ndarray (m,) [deg]
    error_before, error_after : ndarray (m,) [nm]
        Errors over the phase.
    names : (str, str)
        Names of the two errors, for the legend.
    """

    title: str
    before: Array
    after: Array
    phase: Array
    error_before: Array
    error_after: Array
    names: tuple[str, str]


def lissajous_png(data: LissajousData) -> bytes:
    """Return the picture as a PNG of 200 dpi; equal data give equal bytes."""
    import matplotlib
    from matplotlib.figure import Figure

    from contourlab.rendering.matplotlib_view import LOOKS, WIDTH

    with matplotlib.rc_context(fname=LOOKS):
        figure = Figure(figsize=(WIDTH, 3.6), layout="constrained")
        left, right = figure.subplots(1, 2, width_ratios=(1.0, 1.25))
        every = max(1, len(data.before) // POINTS)
        turn = np.linspace(0.0, 2.0 * np.pi, 361)
        left.plot(np.cos(turn), np.sin(turn), color="#8a949e", linewidth=0.8)
        for i, points in enumerate((data.before, data.after)):
            style = {"linestyle": "none", "marker": ".", "markersize": 1.6, "color": scheme_style(i, 2)[0]}
            left.plot(points[::every, 0], points[::every, 1], **style)
        left.set_aspect("equal", adjustable="datalim")
        left.set(xlabel="u1 / amplitude", ylabel="u2 / amplitude", title=data.title.replace("$", "\\$"))
        for i, (name, error) in enumerate(zip(data.names, (data.error_before, data.error_after), strict=True)):
            right.plot(data.phase, error, color=scheme_style(i, 2)[0], linewidth=1.1, label=name)
        right.set(xlabel="phase [deg]", ylabel="error within a pitch [nm]", xlim=(0.0, 360.0), xticks=range(0, 361, 90))
        handles, names = right.get_legend_handles_labels()
        figure.legend(handles, names, loc="outside lower left", ncols=2)
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png")
    return buffer.getvalue()
