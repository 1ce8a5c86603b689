"""Charts drawn by matplotlib, for papers and slides, without pyplot or a window."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.errors import ParameterError
from contourlab.figures import number
from contourlab.rendering.charts import MARKS, Bars, Chart, Matrix, Multiples, Panel, PathChart, PolarChart, Tile
from contourlab.rendering.style import BAND, INK, LIMIT, MUTED

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LOOKS = Path(__file__).parent / "templates" / "print.mplstyle"
WIDTH = 7.2
"""Width of two columns of a journal [in]."""
TILES = 3
"""Tiles in a row."""
NUMBERED = 16
"""A larger matrix has no numbers in its cells."""
SMALLEST, LETTERS = 3.4, 38
"""Least height of a matrix [in], and letters that fit beside it."""
_DASH = {"solid": "-", "dash": "--", "dot": ":"}


def drawing(chart: Chart | PolarChart | PathChart | Multiples | Bars | Matrix) -> Figure:
    """Draw a chart."""
    draw: dict[type, Callable[[Any], Figure]] = {
        Chart: _line_drawing,
        PolarChart: _polar_drawing,
        PathChart: _path_drawing,
        Multiples: _multiples_drawing,
        Bars: _bars_drawing,
        Matrix: _matrix_drawing,
    }
    return draw[type(chart)](chart)


def draw_chart(charts: Iterable[Any], key: str = "", place: Axes | None = None) -> Axes:
    """Draw the first of some charts, or the one of a key, on given axes or a new figure; return the axes.

    Raises
    ------
    ParameterError
        If there is no such chart, or it cannot be drawn on given axes.
    """
    known = list(charts)
    chart = next((chart for chart in known if key in ("", chart.key)), None)
    if chart is None:
        raise ParameterError("key", repr(key), f"one of {', '.join(chart.key for chart in known) or 'none: the answer has no picture'}")
    if place is None:
        return drawing(chart).axes[0]
    if isinstance(chart, Chart):
        draw_panel(place, chart.panels[0])
    elif isinstance(chart, PathChart):
        draw_path(place, chart)
    else:
        raise ParameterError("ax", "given", f"left out: {chart.key} needs a figure of its own")
    return place


def new_figure(height: float) -> Figure:
    """Return an empty figure over the width of two columns."""
    from matplotlib.figure import Figure

    return Figure(figsize=(WIDTH, height), layout="constrained")


def _curve_look(curve: Any) -> dict[str, Any]:
    """Return colour and dash of a line."""
    return {"color": curve.colour, "linestyle": _DASH[curve.dash], "linewidth": 0.75 * getattr(curve, "width", 1.4)}


def escaped(text: str) -> str:
    """Escape text for matplotlib: ``$`` begins a formula, a leading ``_`` hides a legend entry."""
    text = text.replace("$", "\\$")
    return f" {text}" if text.startswith("_") else text


def _line_drawing(chart: Chart) -> Figure:
    """Return panels under one another with one x axis."""
    count = len(chart.panels)
    figure = new_figure(0.9 + chart.panel_height / 130.0 * count if chart.panel_height else 2.9 if count == 1 else 0.7 + 1.45 * count)
    axes = figure.subplots(count, 1, sharex=True, squeeze=False)[:, 0]
    for place, panel in zip(axes, chart.panels, strict=True):
        draw_panel(place, panel)
        if chart.loops:
            place.margins(x=0.015)
    axes[0].set_title(escaped(chart.title), pad=6)
    axes[-1].set_xlabel(chart.panels[-1].x_label)
    figure.align_ylabels(list(axes))
    legend(figure, 3)
    return figure


def legend(figure: Figure, columns: int) -> None:
    """Add a legend with one entry for each name of all panels."""
    entries: dict[str, Any] = {}
    for place in figure.axes:
        for handle, name in zip(*place.get_legend_handles_labels(), strict=True):
            entries.setdefault(name, handle)
    if entries:
        figure.legend(list(entries.values()), list(entries), loc="outside lower left", ncols=min(len(entries), columns))


def draw_panel(place: Axes, panel: Panel) -> None:
    """Draw one panel on given axes."""
    for curve in panel.curves:
        if curve.half is not None:
            look: dict[str, Any] = {"color": curve.colour, "markersize": 3.2, "elinewidth": 1.0}
            place.errorbar(curve.x, curve.y, curve.half, fmt="o", label=escaped(curve.name), **look)
            continue
        # Projecting caps would lengthen bars.
        cap = "butt" if panel.y_ticks else "projecting"
        place.plot(curve.x, curve.y, label=escaped(curve.name), solid_capstyle=cap, **_curve_look(curve))
    if panel.log_x:
        place.set_xscale("log")
        if _decades(panel) < 2.0:
            _plain_numbers(place.xaxis)
    else:
        place.margins(x=0.03 if any(curve.half is not None for curve in panel.curves) else 0.0)
    if panel.log_y:
        _logarithmic(place)
    place.set_ylabel(escaped(panel.y_label))
    if panel.y_ticks:
        place.set_yticks([value for value, _ in panel.y_ticks], [escaped(text) for _, text in panel.y_ticks])
    texts = []
    if panel.y_range is not None:
        place.set_ylim(*panel.y_range)
    if panel.band is not None:
        low, high = panel.band
        texts.append((panel.band_label, BAND))
        place.axhspan(low, high, color=BAND, alpha=0.09, linewidth=0)
        for edge in sorted({low, high} - {0.0}):
            place.axhline(edge, color=BAND, linewidth=0.8, linestyle=":")
        if panel.y_range is not None:
            place.set_ylim(*panel.y_range)  # the band would widen the range
    if panel.span is not None:
        texts.append((panel.span_label, BAND))
        place.axvspan(*panel.span, color=BAND, alpha=0.09, linewidth=0)
    for level in panel.levels:
        if not panel.far:
            place.axhline(level.value, color=LIMIT, linewidth=0.8, linestyle="--")
        texts += [(level.label + (", off scale" if panel.far else ""), LIMIT)] * bool(level.label)
    for text, colour in texts:
        style: dict[str, Any] = {"ha": "right", "va": "bottom", "color": colour, "size": 7.5}
        place.annotate(text, (1, 1), (0, 2), "axes fraction", "offset points", **style)
    _ticks(place, panel)


def _logarithmic(place: Axes) -> None:
    """Give a panel a logarithmic y axis with plain numbers."""
    place.set_yscale("log")
    _plain_numbers(place.yaxis)


def _plain_numbers(axis: Any) -> None:
    """Give a logarithmic axis plain numbers."""
    from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axis.set_minor_formatter(NullFormatter())


def _decades(panel: Panel) -> float:
    """Return how many decades of x the curves span."""
    x = np.concatenate([curve.x for curve in panel.curves])
    x = x[np.isfinite(x) & (x > 0.0)]
    return float(np.log10(x.max() / x.min())) if x.size else 0.0


def _ticks(place: Axes, panel: Panel) -> None:
    """Draw the marks along the foot of a panel."""
    transform = place.get_xaxis_transform()
    for kind, (_, symbol) in MARKS.items():
        x = [tick.x for tick in panel.ticks if tick.kind == kind]
        if x:
            style: dict[str, Any] = {"linestyle": "none", "marker": symbol, "markersize": 3.2, "color": MUTED}
            place.plot(x, np.full(len(x), 0.03), transform=transform, clip_on=False, label=kind, **style)


def _polar_drawing(chart: PolarChart) -> Figure:
    """Return a ball-bar plot: the ring at 0 is the nominal circle."""
    figure = new_figure(5.4)
    place: Any = figure.add_subplot(projection="polar")
    place.spines["polar"].set_visible(True)
    for curve in chart.curves:
        place.plot(np.radians(curve.x), curve.y, label=escaped(curve.name), **_curve_look(curve))
    for mark in chart.marks:
        place.plot(np.radians(mark.x), mark.y, "o", markersize=5, markerfacecolor="none", color=mark.colour)
    round_ = np.linspace(0.0, 2.0 * np.pi, 361)
    place.plot(round_, np.zeros_like(round_), color=INK, linewidth=0.9, label="nominal")
    low, high = chart.reach
    place.set_rlim(low, high)
    rings, texts = zip(*chart.rings()[1:], strict=True)
    place.set_rgrids(list(rings), list(texts), angle=67.5, size=7)
    place.set_title(escaped(chart.title), pad=14)
    place.annotate(f"ring spacing {number(chart.division, 6)} um", (0, 0), xycoords="axes fraction", size=7.5, color=MUTED)
    figure.legend(loc="outside lower left", ncols=2)
    return figure


def _path_drawing(chart: PathChart) -> Figure:
    """Return the path with magnified errors; the magnification is in the title."""
    figure = new_figure(5.6)
    draw_path(figure.add_subplot(), chart)
    figure.legend(loc="outside lower left", ncols=2)
    return figure


def draw_path(place: Axes, chart: PathChart) -> None:
    """Draw the path on given axes."""
    for line in chart.lines:
        place.plot(line.x, line.y, label=escaped(line.name), **_curve_look(line))
    named: set[str] = set()
    for run in (*chart.tolerance, *chart.runs):
        points = run.drawn(chart.magnification)
        label = "_nolegend_" if run.name in named else escaped(run.name)
        named.add(run.name)
        place.plot(points[:, 0], points[:, 1], label=label, **_curve_look(run))
    ring: dict[str, Any] = {"marker": "o", "markersize": 9, "markerfacecolor": "none", "linestyle": "none", "markeredgewidth": 1.4}
    for worst in chart.worst:
        x, y = worst.drawn(chart.magnification).T
        place.plot(x, y, color=worst.colour, label=escaped(worst.name), **ring)
    place.set_aspect("equal", adjustable="datalim")
    place.set_xlabel(escaped(chart.labels[0]))
    place.set_ylabel(escaped(chart.labels[1]))
    place.set_title(f"{escaped(chart.title)}, {escaped(chart.view)}: errors × {number(chart.magnification, 6)}")


def _multiples_drawing(chart: Multiples) -> Figure:
    """Return small pictures side by side, all with one y axis."""
    columns = min(TILES, len(chart.tiles))
    rows = -(-len(chart.tiles) // columns)
    figure = new_figure(0.9 + 1.75 * rows)
    axes = figure.subplots(rows, columns, sharey=True, squeeze=False)
    for place, tile in zip(axes.ravel(), chart.tiles, strict=False):
        _tile(place, tile)
    for place in axes.ravel()[len(chart.tiles) :]:
        place.set_visible(False)
    _logarithmic(axes[0, 0])
    figure.suptitle(escaped(chart.title), fontsize=9.5, fontweight="bold", x=0.01, ha="left")
    figure.supylabel(escaped(chart.y_label), fontsize=8.5)
    legend(figure, 5)
    return figure


def _tile(place: Axes, tile: Tile) -> None:
    for low, high in tile.shaded:
        place.axvspan(low, high, color=LIMIT, alpha=0.18, linewidth=0, label="runs fail")
    for x, colour in tile.here:
        place.axvline(x, color=colour, linewidth=0.8, linestyle=":", label="present value")
    for curve in tile.curves:
        place.plot(curve.x, curve.y, label=escaped(curve.name), **_curve_look(curve))
    for x, y, colour in tile.marks:
        ring: dict[str, Any] = {"marker": "o", "markersize": 4.5, "markerfacecolor": "none", "linestyle": "none", "color": colour}
        place.plot([x], [y], label="minimum", **ring)
    if tile.log_x:
        place.set_xscale("log")
        _plain_numbers(place.xaxis)
    place.margins(x=0.02)
    place.tick_params(labelsize=7)
    place.set_title(escaped(tile.title), fontsize=8, fontweight="normal")
    place.set_xlabel(escaped(tile.x_label), fontsize=7)


def _bars_drawing(chart: Bars) -> Figure:
    """Return bars beside their names, with their intervals."""
    n, m = len(chart.names), len(chart.series)
    figure = new_figure(1.2 + 0.28 * n)
    place = figure.add_subplot()
    height = 0.8 / m
    for i, series in enumerate(chart.series):
        at = np.arange(n) - 0.4 + height * (i + 0.5)
        style: dict[str, Any] = {"error_kw": {"ecolor": INK, "elinewidth": 0.8}, "capsize": 2}
        place.barh(at, series.values, height=0.92 * height, xerr=series.intervals, color=series.colour, label=escaped(series.name), **style)
    place.set_yticks(np.arange(n), [escaped(name) for name in chart.names])
    place.invert_yaxis()
    place.axvline(0.0, color=MUTED, linewidth=0.8)
    place.grid(visible=False, axis="y")
    place.set_xlabel(escaped(chart.x_label))
    place.set_title(escaped(chart.title), pad=6)
    figure.legend(loc="outside lower left", ncols=m)
    return figure


def _matrix_drawing(chart: Matrix) -> Figure:
    """Return a matrix in colours, with numbers if there is room."""
    n = len(chart.names)
    figure = new_figure(max(SMALLEST, 1.6 + 0.36 * n))
    place = figure.add_subplot()
    # Outliers would leave the other cells without colour.
    top = float(np.nanpercentile(np.abs(chart.values), 95.0)) if np.isfinite(chart.values).any() else 1.0
    image = place.imshow(chart.values, cmap="RdBu_r", vmin=-(top or 1.0), vmax=top or 1.0, aspect="auto")
    place.set_xticks(np.arange(n), [escaped(name) for name in chart.names], rotation=60, ha="right", rotation_mode="anchor")
    place.set_yticks(np.arange(n), [escaped(name) for name in chart.names])
    place.grid(visible=False)
    for (row, column), value in np.ndenumerate(chart.values):
        text = f"{value:.2g}" if n <= NUMBERED else ""
        text += "?" if chart.doubtful[row, column] else ""
        if np.isfinite(value) and text:
            dark = abs(value) > 0.6 * top
            place.text(column, row, text, ha="center", va="center", size=6, color="white" if dark else INK)
    bar = figure.colorbar(image, ax=place, extend="both")
    bar.set_label(escaped(fill(chart.label, LETTERS)))
    place.set_title(escaped(chart.title), pad=6)
    return figure
