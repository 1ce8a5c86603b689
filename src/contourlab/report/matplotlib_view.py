"""Charts drawn by matplotlib, for papers and slides; neither pyplot nor a window is used."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.figures import number
from contourlab.report.charts import Chart, Magnified, Panel, PathChart, PolarChart
from contourlab.report.style import BAND, GRID, INK, LIMIT, MUTED

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LOOKS: dict[str, Any] = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 8.5,
    "axes.edgecolor": "#8a949e",
    "axes.labelcolor": INK,
    "axes.linewidth": 0.7,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": 9.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "grid.color": GRID,
    "grid.linewidth": 0.6,
    "xtick.color": MUTED,
    "ytick.color": MUTED,
    "text.color": INK,
    "legend.frameon": False,
    "legend.fontsize": 8,
    "savefig.dpi": 200,
    "svg.hashsalt": "contourlab",
    "svg.fonttype": "none",
    "pdf.fonttype": 42,
}
WIDTH = 7.2  # inches: two columns of a journal
_DASH = {"solid": "-", "dash": "--", "dot": ":"}


def _figure(height: float) -> Figure:
    """Return an empty figure."""
    from matplotlib.figure import Figure

    return Figure(figsize=(WIDTH, height), layout="constrained")


def curve_look(curve: Any) -> dict[str, Any]:
    """Return colour and dash of a line."""
    return {"color": curve.colour, "linestyle": _DASH[curve.dash], "linewidth": 0.75 * getattr(curve, "width", 1.4)}


def plain(text: str) -> str:
    """Return text that matplotlib prints as it is: ``$`` begins a formula, a leading ``_`` hides a legend entry."""
    text = text.replace("$", "\\$")
    return f" {text}" if text.startswith("_") else text


def line_drawing(chart: Chart) -> Figure:
    """Return panels under one another with one x axis."""
    count = len(chart.panels)
    figure = _figure(0.9 + chart.panel_height / 130.0 * count if chart.panel_height else 2.9 if count == 1 else 0.7 + 1.45 * count)
    axes = figure.subplots(count, 1, sharex=True, squeeze=False)[:, 0]
    for place, panel in zip(axes, chart.panels, strict=True):
        _panel(place, panel)
        if chart.loops:
            place.margins(x=0.015)
    axes[0].set_title(plain(chart.title), pad=6)
    axes[-1].set_xlabel(chart.panels[-1].x_label)
    figure.align_ylabels(list(axes))
    entries: dict[str, Any] = {}
    for place in axes:
        for handle, name in zip(*place.get_legend_handles_labels(), strict=True):
            entries.setdefault(name, handle)
    figure.legend(list(entries.values()), list(entries), loc="outside lower left", ncols=min(len(entries), 3))
    return figure


def _panel(place: Axes, panel: Panel) -> None:
    """Draw one panel."""
    for curve in panel.curves:
        if curve.half is not None:
            look: dict[str, Any] = {"color": curve.colour, "markersize": 3.2, "elinewidth": 1.0}
            place.errorbar(curve.x, curve.y, curve.half, fmt="o", label=plain(curve.name), **look)
            continue
        # Bars end where they end; a line's own caps would reach beyond.
        place.plot(curve.x, curve.y, label=plain(curve.name), solid_capstyle="butt" if panel.y_ticks else "projecting", **curve_look(curve))
    if panel.log_x:
        place.set_xscale("log")
        if _decades(panel) < 2.0:
            plain_numbers(place.xaxis)
    else:
        place.margins(x=0.03 if any(curve.half is not None for curve in panel.curves) else 0.0)
    if panel.log_y:
        logarithmic(place)
    place.set_ylabel(plain(panel.y_label))
    if panel.y_ticks:
        place.set_yticks([value for value, _ in panel.y_ticks], [plain(text) for _, text in panel.y_ticks])
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
        texts += [(level.label + (", outside the picture" if panel.far else ""), LIMIT)] * bool(level.label)
    for text, colour in texts:
        style: dict[str, Any] = {"ha": "right", "va": "bottom", "color": colour, "size": 7.5}
        place.annotate(text, (1, 1), (0, 2), "axes fraction", "offset points", **style)
    _ticks(place, panel)


def logarithmic(place: Axes) -> None:
    """Give a panel a logarithmic y axis with numbers as people write them."""
    place.set_yscale("log")
    plain_numbers(place.yaxis)


def plain_numbers(axis: Any) -> None:
    """Give a logarithmic axis numbers as people write them."""
    from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axis.set_minor_formatter(NullFormatter())


def _decades(panel: Panel) -> float:
    """Return over how many decades of x the curves go."""
    x = np.concatenate([curve.x for curve in panel.curves])
    x = x[np.isfinite(x) & (x > 0.0)]
    return float(np.log10(x.max() / x.min())) if x.size else 0.0


def _ticks(place: Axes, panel: Panel) -> None:
    """Draw the marks along the foot of a panel."""
    transform = place.get_xaxis_transform()
    for kind, symbol in (("reversal", "^"), ("corner", "D"), ("first zero", "o")):
        x = [tick.x for tick in panel.ticks if tick.kind == kind]
        if x:
            style: dict[str, Any] = {"linestyle": "none", "marker": symbol, "markersize": 3.2, "color": MUTED}
            place.plot(x, np.full(len(x), 0.03), transform=transform, clip_on=False, label=kind, **style)


def polar_drawing(chart: PolarChart) -> Figure:
    """Return a ball-bar plot: the ring at 0 is the nominal circle."""
    figure = _figure(5.4)
    place: Any = figure.add_subplot(projection="polar")
    place.spines["polar"].set_visible(True)
    for curve in chart.curves:
        place.plot(np.radians(curve.x), curve.y, label=plain(curve.name), **curve_look(curve))
    for mark in chart.marks:
        place.plot(np.radians(mark.x), mark.y, "o", markersize=5, markerfacecolor="none", color=mark.colour)
    round_ = np.linspace(0.0, 2.0 * np.pi, 361)
    place.plot(round_, np.zeros_like(round_), color=INK, linewidth=0.9, label="nominal")
    low, high = chart.reach
    place.set_rlim(low, high)
    rings, texts = zip(*chart.rings()[1:], strict=True)
    place.set_rgrids(list(rings), list(texts), angle=67.5, size=7)
    place.set_title(plain(chart.title), pad=14)
    place.annotate(f"one ring {number(chart.division, 6)} um", (0, 0), xycoords="axes fraction", size=7.5, color=MUTED)
    figure.legend(loc="outside lower left", ncols=2)
    return figure


def path_drawing(chart: PathChart) -> Figure:
    """Return the path with magnified errors; the magnification is in the title."""
    figure = _figure(5.6)
    place = figure.add_subplot()
    for line in chart.lines:
        place.plot(line.x, line.y, label=plain(line.name), **curve_look(line))
    named: set[str] = set()
    for run in (*chart.tolerance, *chart.runs):
        points = run.drawn(chart.magnification)
        label = "_nolegend_" if run.name in named else plain(run.name)
        named.add(run.name)
        place.plot(points[:, 0], points[:, 1], label=label, **curve_look(run))
    for worst in chart.worst:
        _ring(place, worst, chart.magnification)
    place.set_aspect("equal", adjustable="datalim")
    place.set_xlabel(plain(chart.labels[0]))
    place.set_ylabel(plain(chart.labels[1]))
    place.set_title(f"{plain(chart.title)}, {plain(chart.view)}: errors × {number(chart.magnification, 6)}")
    figure.legend(loc="outside lower left", ncols=2)
    return figure


def _ring(place: Axes, worst: Magnified, magnification: float) -> None:
    """Draw a ring round the worst error of a run."""
    style: dict[str, Any] = {"marker": "o", "markersize": 9, "markerfacecolor": "none", "linestyle": "none"}
    x, y = worst.drawn(magnification).T
    place.plot(x, y, color=worst.colour, markeredgewidth=1.4, label=plain(worst.name), **style)
