"""The pictures of a report as single files, for papers and slides."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from contourlab.errors import ParameterError
from contourlab.report.axis_pictures import axis_charts, bode_charts
from contourlab.report.charts import Chart, PathChart, PolarChart
from contourlab.report.data import ReportData
from contourlab.report.error_pictures import error_charts, polar_charts
from contourlab.report.feed_picture import feed_charts
from contourlab.report.hysteresis_picture import hysteresis_charts
from contourlab.report.path_picture import path_charts
from contourlab.report.study_charts import Bars, Matrix, Multiples
from contourlab.report.switching import strip_charts
from contourlab.report.trials import trial_charts
from contourlab.result.atomic import write_bytes_atomic

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMATS = ("png", "svg", "pdf")
POINTS = 8000  # of a curve; four for every dot across a printed page

# What a file would otherwise say of the moment it was made: the same data give the same bytes.
_TIMELESS: dict[str, dict[str, None]] = {"png": {}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}


def write_plots(data: ReportData, folder: str | Path, formats: Sequence[str] = ("png",)) -> tuple[Path, ...]:
    """Write each picture of a report as a file of its own.

    Parameters
    ----------
    data : ReportData
    folder : str or Path
        Made if it is not there.
    formats : sequence of str
        Of ``"png"`` (200 dpi), ``"svg"``, ``"pdf"``.

    Returns
    -------
    tuple of Path
        The files: ``path-0``, ``circle-0``, ``error-time``, ``error-arc``, ``axis-0``, ``bode-0`` and so on; ``backlash-0`` where an axis
        has backlash, ``active-time`` and ``active-arc`` where controllers are switched.

    Raises
    ------
    ParameterError
        If a format is unknown.
    OutputError
        If a file cannot be written.
    ResultError
        If a result has not been judged.
    """
    return _written(_drawings(data), folder, formats)


def write_charts(
    charts: Sequence[Chart | PolarChart | Bars | Matrix | Multiples], folder: str | Path, formats: Sequence[str] = ("png",)
) -> tuple[Path, ...]:
    """Write pictures that belong to no report, each as a file named by its key.

    Parameters
    ----------
    charts : sequence of Chart, PolarChart, Bars, Matrix or Multiples
    folder, formats
        As of `write_plots`, which says what may be raised, too.
    """
    return _written(((chart.key, _draw(chart)) for chart in charts), folder, formats)


def write_figures(drawings: Mapping[str, Callable[[], Figure]], folder: str | Path, formats: Sequence[str] = ("png",)) -> tuple[Path, ...]:
    """Write drawings that are of no kind of chart, each as a file named by its key.

    Parameters
    ----------
    drawings : mapping of str to callable
        What makes each; it is called when its turn comes.
    folder, formats
        As of `write_plots`, which says what may be raised, too.
    """
    return _written(((key, draw()) for key, draw in drawings.items()), folder, formats)


def _written(drawings: Iterator[tuple[str, Figure]], folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write each drawing in each format."""
    import matplotlib

    from contourlab.report.matplotlib_view import LOOKS

    for name in formats:
        if name not in FORMATS:
            raise ParameterError("formats", name, f"of {', '.join(FORMATS)}")
    with matplotlib.rc_context(rc=LOOKS):  # type: ignore[arg-type]
        return tuple(_write(figure, Path(folder) / f"{key}.{name}", name) for key, figure in drawings for name in formats)


def _write(figure: Figure, file: Path, name: str) -> Path:
    """Write one picture in one format, whole or not at all."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format=name, metadata=_TIMELESS[name])
    write_bytes_atomic(file, buffer.getvalue())
    return file


def _drawings(data: ReportData) -> Iterator[tuple[str, Figure]]:
    """Yield each picture with its name, one at a time, so that only one is held."""
    charts = (path_charts, polar_charts, error_charts, axis_charts, hysteresis_charts, bode_charts)
    for make in charts:
        for chart in make(data, POINTS):
            yield chart.key, _draw(chart)
    for chart in (*trial_charts(data), *feed_charts(data.feed), *strip_charts(data)):
        yield chart.key, _draw(chart)


def _draw(chart: Any) -> Figure:
    """Return the drawing of one chart."""
    from contourlab.report import matplotlib_view as view
    from contourlab.report import study_view

    if isinstance(chart, PathChart):
        return view.path_drawing(chart)
    if isinstance(chart, PolarChart):
        return view.polar_drawing(chart)
    if isinstance(chart, Multiples):
        return study_view.multiples_drawing(chart)
    if isinstance(chart, Bars):
        return study_view.bars_drawing(chart)
    if isinstance(chart, Matrix):
        return study_view.matrix_drawing(chart)
    assert isinstance(chart, Chart)
    return view.line_drawing(chart)
