"""The pictures of a report as single files, for papers and slides."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.errors import ParameterError
from contourlab.rendering.charts import Picture
from contourlab.rendering.data import ReportData
from contourlab.rendering.learning_pictures import trial_charts
from contourlab.rendering.path_picture import path_charts
from contourlab.rendering.run_pictures import axis_charts, bode_charts, error_charts, feed_charts, hysteresis_charts, polar_charts
from contourlab.rendering.spectrum import spectrum_charts
from contourlab.rendering.switching import strip_charts
from contourlab.result.atomic import write_bytes_atomic

if TYPE_CHECKING:
    from matplotlib.figure import Figure

POINTS = 8000
"""Points of a curve: four for every dot across a printed page."""


def write_plots(data: ReportData, folder: str | Path, formats: Sequence[str] = ("png",)) -> tuple[Path, ...]:
    """Write each picture of a report as a file.

    Parameters
    ----------
    folder : str or Path
        Created if missing.
    formats : sequence of str
        Any of ``"png"`` (200 dpi), ``"svg"``, ``"pdf"``.

    Returns
    -------
    tuple of Path
        The files: ``path-0``, ``circle-0``, ``error-time``, ``error-arc``, ``axis-0``, ``bode-0`` and so on; ``backlash-0`` for an axis
        with backlash, ``active-time`` and ``active-arc`` for schemes with a supervisor.

    Raises
    ------
    ParameterError
        If a format is unknown.
    OutputError
        If a file cannot be written.
    ResultError
        If a result has not been judged.
    """
    return write_charts(charts_of(data), folder, formats)


def charts_of(data: ReportData) -> Iterator[Picture]:
    """Yield all charts for papers and slides, one at a time."""
    yield from path_charts(data, POINTS)
    for _, charts in sections(data, POINTS):
        yield from charts


def sections(data: ReportData, points: int) -> Iterator[tuple[str, Sequence[Picture]]]:
    """Yield each section of a report but the path, with its charts; curves have at most `points` points."""
    yield "circles", polar_charts(data, points)
    yield "errors", (*error_charts(data, points), *spectrum_charts(data, points))
    yield "axes", (*feed_charts(data.feed), *axis_charts(data, points))
    yield "backlash", hysteresis_charts(data, points)
    yield "switches", strip_charts(data)
    yield "trials", trial_charts(data)
    yield "bode", bode_charts(data, points)


def write_charts(charts: Iterable[Picture], folder: str | Path, formats: Sequence[str] = ("png",)) -> tuple[Path, ...]:
    """Write charts, each as a file named by its key; other parameters and errors as in `write_plots`."""
    from contourlab.rendering.matplotlib_view import drawing

    return write_figures(((chart.key, partial(drawing, chart)) for chart in charts), folder, formats)


def write_figures(drawings: Iterable[tuple[str, Callable[[], Figure]]], folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write drawings, each as a file named by its key; other parameters and errors as in `write_plots`.

    Each is written completely or not at all; only one is in memory at a time.
    """
    if not formats:
        return ()
    from contourlab.rendering.matplotlib_view import STAMPED, picture_bytes

    for name in formats:
        if name not in STAMPED:
            raise ParameterError("formats", name, f"of {', '.join(STAMPED)}")
    files = []
    for key, draw in drawings:
        for name, content in zip(formats, picture_bytes(draw, *formats), strict=True):
            files.append(Path(folder) / f"{key}.{name}")
            write_bytes_atomic(files[-1], content)
    return tuple(files)
