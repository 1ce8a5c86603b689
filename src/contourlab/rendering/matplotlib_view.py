"""Charts drawn by matplotlib, for papers and slides, without pyplot or a window."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any, ClassVar, cast

import numpy as np

from contourlab.errors import ParameterError, ResultError, refuse
from contourlab.figures import number
from contourlab.rendering.charts import Bars, Chart, Curve, Magnified, Matrix, Multiples, Panel, PathChart, Picture, PolarChart
from contourlab.rendering.style import BAND, INK, LIMIT, MUTED
from contourlab.result.stamp import current

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure, FigureBase
    from matplotlib.gridspec import GridSpecBase, SubplotSpec

LOOKS = Path(__file__).parent / "templates" / "print.mplstyle"
WIDTH = 7.2
"""Width of two columns of a journal [in]."""
WIDTHS = {"column": 88.9, "page": 181.0}
"""Widths of IEEE's journals [mm]."""
POINTS, LETTERS_PER_INCH = 8.0, 12
"""Size of the letters of a figure for print [pt], and how many of them a line has."""
DASHES = ("-", (0, (9, 1.5)), (0, (6, 1.5, 1, 1.5)), (0, (2, 0.8)), (0, (6, 1.2, 1, 1.2, 1, 1.2)), (0, (9, 1.5, 3, 1.5)))
"""Dashes that tell lines apart without colour, none like those of limits, which are dashed or dotted."""
TILES = 3
"""Tiles in a row."""
NUMBERED = 16
"""A larger matrix has no numbers in its cells."""
SMALLEST, LETTERS = 3.4, 38
"""Least height of a matrix [in], and letters that fit beside it."""
_DASH = {"solid": "-", "dash": "--", "dot": ":"}
_RING: dict[str, Any] = {"marker": "o", "markerfacecolor": "none", "linestyle": "none"}

# Without dates the same data give the same bytes.
STAMPED: dict[str, tuple[str, dict[str, None]]] = {
    "png": ("Description", {}), "svg": ("Description", {"Date": None}), "pdf": ("Subject", {"CreationDate": None})
}  # fmt: skip
"""Where each form holds what made it, and what it shall not hold."""


def drawing(chart: Picture, width: float | None = None) -> Figure:
    """Draw a chart on a figure of its own; of a `width` [in], for print."""
    draw, height, columns = _VIEWS[type(chart)]
    share = (width or WIDTH) / WIDTH
    figure = new_figure(height(chart) * share**0.5, width or WIDTH)
    if isinstance(chart, Chart):
        axes = figure.subplots(len(chart.panels), 1, sharex=True, squeeze=False)[:, 0]
        for place, panel in zip(axes, chart.panels, strict=True):
            draw_panel(place, panel)
            if chart.loops:
                place.margins(x=0.015)
        axes[0].set_title(escaped(chart.title), pad=6)
        axes[-1].set_xlabel(chart.panels[-1].x_label)
        figure.align_ylabels(list(axes))
    elif isinstance(chart, Multiples):
        _draw_tiles(figure.add_gridspec, chart)
        figure.suptitle(escaped(chart.title), fontsize=9.5, fontweight="bold", x=0.01, ha="left")
        figure.supylabel(escaped(chart.y_label), fontsize=8.5)
    else:
        draw(figure.add_subplot(), chart)
    if width is None:
        legend(figure, columns)
    else:
        _for_print(figure, width, max(round(columns * share), 1))
    return figure


def _for_print(figure: Any, width: float, columns: int) -> None:
    """Give all text one size, the lines of each colour a dash of their own, and the legend room below."""
    from matplotlib.text import Text

    lines = [line for place in figure.axes for line in place.lines if line.get_linestyle() == "-"]
    looks: dict[str, Any] = {}
    named = {line.get_label(): line.get_linestyle() for place in figure.axes for line in place.lines if line not in lines}
    for line in lines:
        own = looks.setdefault(str(line.get_color()), DASHES[len(looks) % len(DASHES)])
        line.set_linestyle(named.get(line.get_label(), own))
    letters = int(0.9 * width * LETTERS_PER_INCH)
    for place in figure.axes:
        place.set_ylabel(fill(place.get_ylabel(), 16).replace(" [", "\n[") if len(place.get_ylabel()) > 12 else place.get_ylabel())
        place.tick_params(labelsize=POINTS)
        for side in ("left", "center", "right"):
            place.set_title(fill(place.get_title(side), letters), loc=side)
    rows = legend(figure, columns)
    for text in [text for box in figure.legends for text in box.texts]:
        text.set_text(fill(text.get_text(), letters // columns))
        rows += text.get_text().count("\n")
    figure.set_figheight(figure.get_figheight() + 1.5 * POINTS / 72.0 * rows)
    for text in figure.findobj(Text):
        text.set_fontsize(POINTS)
    figure.looks = {"svg.fonttype": "path"}


def new_figure(height: float, width: float = WIDTH) -> Figure:
    """Return an empty figure, by default over the width of two columns. A file of it says what made it."""
    figure: Any = _figure_class()(figsize=(width, height), layout="constrained")
    figure.made = current()
    return cast("Figure", figure)


@cache
def _figure_class() -> Any:
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    class Printed(Figure):
        """A figure that is saved with the looks of print."""

        made = ""
        looks: ClassVar[Any] = {}

        def savefig(self, fname: Any, **given: Any) -> None:
            """Save it; parameters as of matplotlib."""
            form = str(given.get("format") or Path(str(fname)).suffix[1:] or "png").lower()
            place, without = STAMPED.get(form, ("", {}))
            about = {place: self.made, **without, **given.pop("metadata", {})} if place else given.pop("metadata", None)
            with rc_context(self.looks, LOOKS):
                super().savefig(fname, metadata=about, **given)

    return Printed


def drawing_of(charts: Sequence[Picture], height: float) -> Figure:
    """Draw charts side by side on a figure of a height [in]."""
    figure = new_figure(height)
    grid = figure.add_gridspec(1, len(charts))
    for column, chart in enumerate(charts):
        _VIEWS[type(chart)][0](figure.add_subplot(grid[0, column]), chart)
    legend(figure, 2)
    return figure


def legend(figure: Figure, columns: int) -> int:
    """Add a legend with one entry for each name of all panels; return its rows."""
    entries: dict[str, Any] = {}
    for place in figure.axes:
        for handle, name in zip(*place.get_legend_handles_labels(), strict=True):
            entries.setdefault(name, handle)
    if entries:
        figure.legend(list(entries.values()), list(entries), loc="outside lower left", ncols=min(len(entries), columns))
    return -(-len(entries) // columns)


def picture_bytes(draw: Callable[[], Figure], *forms: str) -> list[bytes]:
    """Return a figure, drawn with the looks of print, as files: png, svg or pdf. The same data give the same bytes."""
    import matplotlib

    with matplotlib.rc_context(fname=LOOKS):
        figure, files = draw(), []
        for form in forms:
            buffer = io.BytesIO()
            figure.savefig(buffer, format=form)
            files.append(buffer.getvalue())
    return files


def draw_chart(charts: Iterable[Picture], key: str = "", place: Axes | None = None, width: float | str | None = None) -> Axes:
    """Draw the first of some charts, or the one of a key, on given axes or a new figure; return the axes.

    Of several panels above one another, given axes get the first. A ball-bar plot needs polar axes, and tiles need axes of their own: where
    the given ones are plain, these take their place. A width [mm], or its name, is that of a new figure for print.

    Raises
    ------
    ResultError
        If there is no chart.
    ParameterError
        If none has this key.
    """
    known = list(charts)
    refuse(not known, ResultError, "this answer has no picture")
    chart = next((chart for chart in known if key in ("", chart.key)), None)
    if chart is None:
        raise ParameterError("key", repr(key), f"one of {', '.join(chart.key for chart in known)}")
    refuse(place is not None and width is not None, ParameterError, "width", repr(width), "left out where ax is given: its figure has one")
    if width is not None:
        size = WIDTHS.get(str(width), width)
        if isinstance(size, str) or not 20.0 <= size <= 2000.0:
            raise ParameterError("width", repr(width), f"from 20 to 2000, or one of {', '.join(WIDTHS)}", "mm")
        import matplotlib

        with matplotlib.rc_context(fname=LOOKS):
            return drawing(chart, size / 25.4).axes[0]
    return drawing(chart).axes[0] if place is None else _VIEWS[type(chart)][0](place, chart)


def escaped(text: str) -> str:
    """Escape text for matplotlib: ``$`` begins a formula, a leading ``_`` hides a legend entry."""
    text = text.replace("$", "\\$")
    return f" {text}" if text.startswith("_") else text


def _draw_line(place: Axes, curve: Curve | Magnified, x: Any, y: Any, **more: Any) -> None:
    width = 0.75 * (curve.width if isinstance(curve, Curve) else 1.4)
    look = {"color": curve.colour, "linestyle": _DASH[curve.dash], "linewidth": width, "label": escaped(curve.name)}
    place.plot(x, y, **{**look, **more})


def draw_panel(place: Axes, panel: Panel) -> None:
    """Draw one panel on given axes."""
    for curve in panel.curves:
        if curve.half is not None:
            look: dict[str, Any] = {"color": curve.colour, "markersize": 3.2, "elinewidth": 1.0}
            place.errorbar(curve.x, curve.y, curve.half, fmt="o", label=escaped(curve.name), **look)
        else:
            # Projecting caps would lengthen bars.
            _draw_line(place, curve, curve.x, curve.y, solid_capstyle="butt" if panel.y_ticks else "projecting")
    if panel.log_x:
        place.set_xscale("log")
        if _decades(panel) < 2.0:
            _plain_numbers(place.xaxis)
    else:
        place.margins(x=0.03 if any(curve.half is not None for curve in panel.curves) else 0.0)
    if panel.log_y:
        place.set_yscale("log")
        if panel.y_range is None or panel.y_range[1] < 1e3 * panel.y_range[0]:
            _plain_numbers(place.yaxis)
    place.set_ylabel(escaped(panel.y_label))
    if panel.y_ticks:
        place.set_yticks([value for value, _ in panel.y_ticks], [escaped(text) for _, text in panel.y_ticks])
    shade: dict[str, Any] = {"color": BAND, "alpha": 0.09, "linewidth": 0}
    if panel.band is not None:
        place.axhspan(*panel.band, **shade)
        for edge in sorted({*panel.band} - {0.0}):
            place.axhline(edge, color=BAND, linewidth=0.8, linestyle=":")
    if panel.y_range is not None:
        place.set_ylim(*panel.y_range)
    if panel.span is not None:
        place.axvspan(*panel.span, **shade)
    for level in panel.levels if not panel.far else ():
        place.axhline(level.value, color=LIMIT, linewidth=0.8, linestyle="--")
    for text, colour in panel.notes:
        style: dict[str, Any] = {"ha": "right", "va": "bottom", "color": colour, "size": 7.5}
        place.annotate(text, (1, 1), (0, 2), "axes fraction", "offset points", **style)
    for kind, symbol, ticks in panel.marks:
        style = {"linestyle": "none", "marker": symbol, "markersize": 3.2, "color": MUTED}
        foot = place.get_xaxis_transform()
        place.plot([tick.x for tick in ticks], np.full(len(ticks), 0.03), transform=foot, clip_on=False, label=kind, **style)


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


def _draw_first(place: Axes, chart: Chart) -> Axes:
    """Draw the first panel of a chart."""
    draw_panel(place, chart.panels[0])
    place.set_xlabel(chart.panels[0].x_label)
    return place


def _vacated(place: Axes) -> tuple[FigureBase, SubplotSpec]:
    """Remove axes; return their figure and their place in it."""
    from matplotlib.gridspec import GridSpec

    figure, edges = place.figure, place.get_position()
    cell = place.get_subplotspec() or GridSpec(1, 1, figure, edges.x0, edges.y0, edges.x1, edges.y1)[0]  # type: ignore[arg-type]
    place.remove()
    return figure, cell


def _draw_polar(given: Axes, chart: PolarChart) -> Axes:
    """Draw a ball-bar plot: the ring at 0 is the nominal circle."""
    place: Any = given
    if given.name != "polar":
        figure, cell = _vacated(given)
        place = figure.add_subplot(cell, projection="polar")
    place.spines["polar"].set_visible(True)
    for curve in chart.curves:
        _draw_line(place, curve, np.radians(curve.x), curve.y)
    for mark in chart.marks:
        place.plot(np.radians(mark.x), mark.y, markersize=5, color=mark.colour, **_RING)
    place.plot(np.linspace(0.0, 2.0 * np.pi, 361), np.zeros(361), color=INK, linewidth=0.9, label="nominal")
    place.set_rlim(*chart.reach)
    rings, texts = zip(*chart.rings()[1:], strict=True)
    place.set_rgrids(list(rings), list(texts), angle=67.5, size=7)
    place.set_title(escaped(chart.title), pad=14)
    place.annotate(f"ring spacing {number(chart.spacing[0], 6)} um", (0, 0), xycoords="axes fraction", size=7.5, color=MUTED)
    return cast("Axes", place)


def draw_path(place: Axes, chart: PathChart) -> Axes:
    """Draw the path with magnified errors; the magnification is in the title."""
    for line in chart.lines:
        _draw_line(place, line, line.x, line.y)
    named: set[str] = set()
    for run in (*chart.tolerance, *chart.runs):
        _draw_line(place, run, *run.drawn(chart.magnification).T, **({"label": "_nolegend_"} if run.name in named else {}))
        named.add(run.name)
    for worst in chart.worst:
        ring = {"color": worst.colour, "label": escaped(worst.name), "markersize": 9, "markeredgewidth": 1.4, **_RING}
        place.plot(*worst.drawn(chart.magnification).T, **ring)
    place.set_aspect("equal", adjustable="datalim")
    place.set_xlabel(escaped(chart.labels[0]))
    place.set_ylabel(escaped(chart.labels[1]))
    place.set_title(f"{escaped(chart.title)}, {escaped(chart.view)}: errors × {number(chart.magnification, 6)}")
    return place


def _divide(place: Axes, chart: Multiples) -> Axes:
    """Draw small pictures in the place of axes."""
    first = _draw_tiles(_vacated(place)[1].subgridspec, chart)
    first.set_ylabel(escaped(chart.y_label))
    return first


def _draw_tiles(grid: Callable[[int, int], GridSpecBase], chart: Multiples) -> Axes:
    """Draw small pictures side by side, all with one y axis."""
    columns = min(TILES, len(chart.tiles))
    places = grid(-(-len(chart.tiles) // columns), columns).subplots(sharey=True, squeeze=False).ravel()
    for place, tile in zip(places, chart.tiles, strict=False):
        for low, high in tile.shaded:
            place.axvspan(low, high, color=LIMIT, alpha=0.18, linewidth=0, label="runs fail")
        for x, colour in tile.here:
            place.axvline(x, color=colour, linewidth=0.8, linestyle=":", label="present value")
        for curve in tile.curves:
            _draw_line(place, curve, curve.x, curve.y)
        for x, y, colour in tile.marks:
            place.plot([x], [y], label="minimum", markersize=4.5, color=colour, **_RING)
        if tile.log_x:
            place.set_xscale("log")
            _plain_numbers(place.xaxis)
        place.margins(x=0.02)
        place.tick_params(labelsize=7)
        place.set_title(escaped(tile.title), fontsize=8, fontweight="normal")
        place.set_xlabel(escaped(tile.x_label), fontsize=7)
    for place in places[len(chart.tiles) :]:
        place.set_visible(False)
    places[0].set_yscale("log")
    _plain_numbers(places[0].yaxis)
    return cast("Axes", places[0])


def _draw_bars(place: Axes, chart: Bars) -> Axes:
    """Draw bars beside their names, with their intervals."""
    n, height = len(chart.names), 0.8 / len(chart.series)
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
    return place


def _draw_matrix(place: Axes, chart: Matrix) -> Axes:
    """Draw a matrix in colours, with numbers if there is room."""
    names = [escaped(name) for name in chart.names]
    n = len(names)
    # Outliers would leave the other cells without colour.
    top = float(np.nanpercentile(np.abs(chart.values), 95.0)) if np.isfinite(chart.values).any() else 1.0
    image = place.imshow(chart.values, cmap="RdBu_r", vmin=-(top or 1.0), vmax=top or 1.0, aspect="auto")
    place.set_xticks(np.arange(n), names, rotation=60, ha="right", rotation_mode="anchor")
    place.set_yticks(np.arange(n), names)
    place.grid(visible=False)
    for (row, column), value in np.ndenumerate(chart.values):
        text = (f"{value:.2g}" if n <= NUMBERED else "") + ("?" if chart.doubtful[row, column] else "")
        if np.isfinite(value) and text:
            dark = abs(value) > 0.6 * top
            place.text(column, row, text, ha="center", va="center", size=6, color="white" if dark else INK)
    bar = place.figure.colorbar(image, ax=place, extend="both")
    bar.set_label(escaped(fill(chart.label, LETTERS)))
    place.set_title(escaped(chart.title), pad=6)
    return place


def _panels_high(chart: Chart) -> float:
    count = len(chart.panels)
    return 0.9 + chart.panel_height / 130.0 * count if chart.panel_height else 2.9 if count == 1 else 0.7 + 1.45 * count


_VIEWS: dict[type, tuple[Callable[[Any, Any], Axes], Callable[[Any], float], int]] = {
    Chart: (_draw_first, _panels_high, 3),
    PolarChart: (_draw_polar, lambda _: 5.4, 2),
    PathChart: (draw_path, lambda _: 5.6, 2),
    Multiples: (_divide, lambda chart: 0.9 + 1.75 * -(-len(chart.tiles) // TILES), 5),
    Bars: (_draw_bars, lambda chart: 1.2 + 0.28 * len(chart.names), 9),
    Matrix: (_draw_matrix, lambda chart: max(SMALLEST, 1.6 + 0.36 * len(chart.names)), 1),
}
"""For each kind of chart: how to draw it on given axes, the height of a figure of its own [in], and columns of the legend there."""
