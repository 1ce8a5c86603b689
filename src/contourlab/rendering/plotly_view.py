"""Charts as plain dictionaries for plotly.js. Numbers travel as base64 of little-endian floats.

The page draws the errors of a path at the foot points, with the magnification that the reader sets: ``magnify`` holds the initial
magnification, the length of the scale bar [mm], and the index, foot points [mm] and errors [um] of each magnified trace as packed columns.
``numbered`` holds the program lines of the traces, the path itself first; the last trace is the part that the chosen line programs.
"""

from __future__ import annotations

import base64
import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.rendering.charts import Chart, Curve, Magnified, Panel, PathChart, Picture, PolarChart, SpaceChart
from contourlab.rendering.style import BAND, FONT, GRID, INK, LIMIT, MUTED, round_down

Figure = dict[str, Any]

SINGLE = 64.0
"""Largest magnitude over spread for float32: rounding to 2^-24 of the value is then 2^-18 of the spread, far below a pixel."""
TOP, BOTTOM = 50, 56
"""Heights above and below a picture [px]."""
HEIGHT, GAP = 190, 26
BUTTONS, ROW, LABEL = 21, 29, 16
"""Heights above a picture [px]: buttons, a row of the legend, a label of the first panel."""
LEGEND_WIDTH, ENTRY, LETTER = 910.0, 45.0, 6.1
"""Widths [px]: a row of the legend, an entry without its text, a letter."""
PICKED: Figure = {"mode": "lines", "hoverinfo": "skip", "showlegend": False, "line": {"color": "#f0a202", "width": 6}, "opacity": 0.7}
"""The part of the path that the chosen line programs."""


def figure_of(chart: Picture) -> Figure:
    """Return a chart as a figure of plotly.js."""
    draw: dict[type, Callable[[Any], Figure]] = {
        Chart: _line_figure,
        PolarChart: _polar_figure,
        PathChart: _path_figure,
        SpaceChart: _space_figure,
    }
    return draw[type(chart)](chart)


def _line_figure(chart: Chart) -> Figure:
    """Return panels under one another; they zoom together along x."""
    count = len(chart.panels)
    one_high = chart.panel_height or (330 if count == 1 else HEIGHT)
    inner = one_high * count + GAP * (count - 1)
    label = LABEL if any(text for text, _ in chart.panels[0].notes) else 0
    top = BUTTONS + ROW * _legend_rows(chart) + label
    layout = layout_look(top + inner + BOTTOM, shapes=[], annotations=[], hovermode="closest" if chart.loops else "x unified")
    layout["margin"]["t"] = top
    layout["legend"]["y"] = 1.0 + label / inner
    one = (inner - GAP * (count - 1)) / count / inner
    data: list[Figure] = []
    seen: set[str] = set()
    for number, panel in enumerate(chart.panels):
        tail = "" if number == 0 else str(number + 1)
        high = 1.0 - number * (one + GAP / inner)
        last = number == count - 1
        x_axis = axis_look(panel.x_label if last else "", anchor=f"y{tail}", showticklabels=last)
        x_axis |= {"matches": "x"} if number else {}
        x_axis |= {"type": "log", "dtick": 1} if panel.log_x else {"range": _x_span(chart)}
        y_axis = axis_look(panel.y_label, anchor=f"x{tail}", domain=[max(high - one, 0.0), high])
        if panel.y_ticks:
            values, texts = zip(*panel.y_ticks, strict=True)
            y_axis |= {"tickvals": list(values), "ticktext": [plain(text) for text in texts], "fixedrange": True}
        elif panel.log_y:
            decades = _decades(panel)
            y_axis |= {"type": "log", "tickvals": decades, "ticktext": [f"{value:g}" for value in decades]}
        if panel.y_range is not None:
            y_axis["range"] = [math.log10(edge) for edge in panel.y_range] if panel.log_y else list(panel.y_range)
        layout |= {f"xaxis{tail}": x_axis, f"yaxis{tail}": y_axis}
        data += _panel_curves(panel, tail, seen)
        layout["shapes"] += _shapes(panel, tail)
        layout["annotations"] += [_note(text, colour, tail) for text, colour in panel.notes]
    return {"data": data, "layout": layout}


def _legend_rows(chart: Chart) -> int:
    """Return the rows of the legend on a wide screen."""
    curves = [curve.name for panel in chart.panels for curve in panel.curves]
    marks = [tick.kind for panel in chart.panels for tick in panel.ticks]
    rows, used = 1, 0.0
    for name in dict.fromkeys(curves + marks):
        width = ENTRY + LETTER * len(name)
        if used and used + width > LEGEND_WIDTH:
            rows, used = rows + 1, 0.0
        used += width
    return rows


def _decades(panel: Panel) -> list[float]:
    """Return ticks at 1, 2 and 5 of each decade around the curves; plotly would leave out the decade itself."""
    values = np.concatenate([curve.y for curve in panel.curves] or [np.ones(1)])
    values = values[np.isfinite(values) & (values > 0.0)]
    low, high = (float(values.min()), float(values.max())) if values.size else (1.0, 1.0)
    return [digit * 10.0**n for n in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1) for digit in (1.0, 2.0, 5.0)]


def _x_span(chart: Chart) -> list[float]:
    """Return the range of the curves, with margins beside loops and error bars."""
    curves = [curve.x for panel in chart.panels for curve in panel.curves if curve.x.size]
    low, high = min(float(np.nanmin(x)) for x in curves), max(float(np.nanmax(x)) for x in curves)
    points = any(curve.half is not None for panel in chart.panels for curve in panel.curves)
    room = 0.015 * (high - low) if chart.loops or points else 0.0
    return [low - room, high + room if high > low else low + 1.0]


def _panel_curves(panel: Panel, tail: str, seen: set[str]) -> list[Figure]:
    """Return the traces of a panel: curves and marks. Each name appears in the legend once."""
    unit = panel.y_label.partition("[")[2].rstrip("]")
    traces = []
    for curve in panel.curves:
        trace = line_look(curve, x=packed(curve.x), y=packed(curve.y), xaxis=f"x{tail}", yaxis=f"y{tail}")
        if curve.half is not None:
            trace |= {"mode": "markers", "marker": {"color": curve.colour, "size": 6}, "error_y": {"array": packed(curve.half), "width": 0}}
        trace |= {"showlegend": curve.name not in seen, "hovertemplate": f"%{{y:.4g}} {plain(unit)}"}
        if panel.y_ticks:  # the height of a bar means nothing
            trace["hovertemplate"] = f"%{{x:.6g}}<extra>{plain(curve.name)}</extra>"
        seen.add(curve.name)
        traces.append(trace)
    for kind, symbol, _, ticks in panel.marks:
        # In a row at the foot of the panel.
        low, high = _span(panel)
        mark = {"type": "scatter", "mode": "markers", "name": kind, "marker": {"symbol": symbol, "size": 7, "color": MUTED}}
        places = {"x": packed(np.array([tick.x for tick in ticks])), "y": [low - 0.06 * (high - low)] * len(ticks)}
        hover = {"text": [plain(tick.label) for tick in ticks], "hovertemplate": "%{text}", "cliponaxis": False}
        traces.append({**mark, **places, **hover, "xaxis": f"x{tail}", "yaxis": f"y{tail}"})
    return traces


def _span(panel: Panel) -> tuple[float, float]:
    """Return the lowest and highest value that a panel shows."""
    if panel.y_range is not None:
        return panel.y_range
    values = [curve.y[np.isfinite(curve.y)] for curve in panel.curves]
    ends = [float(end) for part in values if part.size for end in (part.min(), part.max())] + list(panel.band or ())
    return (min(ends), max(ends)) if ends else (0.0, 1.0)


def _shapes(panel: Panel, tail: str) -> Iterator[Figure]:
    """Yield the tolerance band, span and limits of a panel."""
    across = {"xref": f"x{tail} domain", "x0": 0, "x1": 1, "yref": f"y{tail}"}
    fill = {"type": "rect", "layer": "below", "fillcolor": BAND, "opacity": 0.09, "line": {"width": 0}}
    if panel.band is not None:
        low, high = panel.band
        yield {**across, **fill, "y0": low, "y1": high}
        for edge in sorted({low, high} - {0.0}):
            line = {"color": BAND, "width": 1, "dash": "dot"}
            yield {**across, "type": "line", "layer": "below", "y0": edge, "y1": edge, "line": line}
    if panel.span is not None:
        yield {**fill, "xref": f"x{tail}", "x0": panel.span[0], "x1": panel.span[1], "yref": f"y{tail} domain", "y0": 0, "y1": 1}
    for level in panel.levels if not panel.far else ():
        line = {"color": LIMIT, "width": 1.1, "dash": "dash"}
        yield {**across, "type": "line", "layer": "above", "y0": level.value, "y1": level.value, "line": line}


def _note(text: str, colour: str, tail: str) -> Figure:
    """Return a small text above the right end of a panel."""
    font = {"size": 11, "color": colour}
    place = {"xref": f"x{tail} domain", "yref": f"y{tail} domain", "x": 1, "y": 1, "yshift": 2}
    return {"text": text, "showarrow": False, "font": font, **place, "xanchor": "right", "yanchor": "bottom"}


def _polar_figure(chart: PolarChart) -> Figure:
    """Return a ball-bar plot: the ring at 0 is the nominal circle."""
    hover = "%{r:.3g} um at %{theta:.1f}°"
    ring: Figure = {"type": "scatterpolar", "hovertemplate": hover}
    data = [line_look(curve, **ring, r=packed(curve.y), theta=packed(curve.x)) for curve in chart.curves]
    for mark in chart.marks:
        points = {"r": packed(mark.y), "theta": packed(mark.x), "name": plain(mark.name), "legendgroup": plain(mark.name)}
        look = {"symbol": "circle-open", "size": 9, "color": mark.colour, "line": {"width": 1.6}}
        spike = {"mode": "markers", "marker": look, "hovertemplate": f"reversal spike, {hover}", "showlegend": False}
        data.append({"type": "scatterpolar", **spike, **points})
    nominal = {"color": INK, "width": 1.1}
    round_ = {"type": "scatterpolar", "mode": "lines", "name": "nominal", "line": nominal, "hoverinfo": "skip"}
    data.append({**round_, "theta": list(range(0, 361, 3)), "r": [0] * 121})
    low, high = chart.reach
    rings, texts = zip(*chart.rings(), strict=True)
    look = {"gridcolor": GRID, "linecolor": "#b9c1c9", "tickfont": {"size": 11, "color": MUTED}}
    radial: Figure = {**look, "tickvals": list(rings), "ticktext": list(texts), "ticks": ""}
    radial |= {"range": [low, high], "angle": 67.5, "tickangle": 67.5}
    angular = {**look, "ticksuffix": "°", "dtick": 45}
    polar = {"radialaxis": radial, "angularaxis": angular, "bgcolor": "#ffffff", "domain": {"x": [0.0, 0.72]}}
    legend = {"x": 0.76, "y": 0.98, "xanchor": "left", "yanchor": "top", "font": {"size": 12}}
    layout = layout_look(600, polar=polar, legend=legend, hovermode="closest")
    layout["margin"] = {"l": 40, "r": 16, "t": 44, "b": 44}
    return {"data": data, "layout": layout}


def _path_figure(chart: PathChart) -> Figure:
    """Return the path, seen along one axis."""
    moved = (*chart.tolerance, *chart.runs)
    data = [line_look(line, x=packed(line.x), y=packed(line.y), hoverinfo="none") for line in chart.lines]
    curves, numbered = [], _numbered(0, chart.asked_at)
    names: set[str] = set()
    for run in moved:
        size = np.hypot(run.error[:, 0], run.error[:, 1])
        trace = line_look(run, hovertemplate="%{customdata:.3g} um", showlegend=run.name not in names)
        names.add(run.name)
        if run in chart.runs:
            trace["customdata"] = packed(size)
            numbered += _numbered(len(data), run.lines)
        else:
            trace |= {"hoverinfo": "skip", "hovertemplate": None}
            trace["line"]["width"] = 1
        curves.append({"trace": len(data), **_columns(run)})
        data.append(trace)
    for worst in chart.worst:
        mark = {"symbol": "circle-open", "size": 15, "color": worst.colour, "line": {"width": 2}}
        curves.append({"trace": len(data), **_columns(worst)})
        more = {"name": plain(worst.name), "hoverinfo": "name"}
        data.append({"type": "scatter", "mode": "markers", "marker": mark, **more})
    wide, high = float(np.ptp(chart.lines[0].x)), float(np.ptp(chart.lines[0].y))
    # For a drawing 760 px wide.
    height = round(min(max(760.0 * high / wide + 110.0, 340.0), 680.0)) if wide > 0.0 else 680
    layout = layout_look(height, hovermode="closest", dragmode="pan")
    layout["legend"] |= {"orientation": "v", "x": 1.01, "y": 1, "yanchor": "top"}
    layout["margin"] |= {"t": 24}
    layout["xaxis"] = axis_look(chart.labels[0])
    layout["yaxis"] = axis_look(chart.labels[1], scaleanchor="x")
    data.append({**PICKED, "type": "scatter", "x": [], "y": []})
    magnify = {"start": chart.magnification, "curves": curves, "bar": _bar(max(wide, high))}
    return {"data": data, "layout": layout, "magnify": magnify, "numbered": numbered}


def _numbered(trace: int, lines: Index | None) -> list[Figure]:
    """Return the program lines of a trace for the page; nothing without any."""
    if lines is None or not lines.any():
        return []
    text = base64.b64encode(lines.astype("<i4").tobytes()).decode("ascii")
    return [{"trace": trace, "line": {"dtype": "i4", "bdata": text}}]


def _space_figure(chart: SpaceChart) -> Figure:
    """Return the path in space."""
    x, y, z = (packed(column) for column in chart.asked.T)
    style = {"color": INK, "width": 2}
    named: Figure = {"type": "scatter3d", "mode": "lines"}
    path = {**named, "name": "programmed path", "x": x, "y": y, "z": z, "line": style, "hoverinfo": "none"}
    data, curves, numbered = [path], [], _numbered(0, chart.asked_at)
    tops = [float(size.max(initial=0.0)) for size in chart.sizes]
    worst = int(np.argmax(tops))
    for i, (run, size) in enumerate(zip(chart.runs, chart.sizes, strict=True)):
        colour = {"color": packed(size), "coloraxis": "coloraxis", "width": 5}
        # All runs at once would hide each other: the one with the largest error is shown, the legend shows the others.
        shown = True if i == worst else "legendonly"
        numbered += _numbered(len(data), run.lines)
        curves.append({"trace": len(data), **_columns(run)})
        hover = {"customdata": packed(size), "hovertemplate": "%{customdata:.3g} um<extra></extra>"}
        group: Figure = {**named, "name": plain(run.name), "legendgroup": str(i), "visible": shown}
        # A legend cannot draw a line of many colours.
        data.append({**group, "line": colour, "showlegend": False, **hover})
        data.append({**group, "line": {"color": run.colour, "width": 5}, "x": [None], "y": [None], "z": [None]})
    data.append({**PICKED, "type": "scatter3d", "x": [], "y": [], "z": [], "line": {"color": "#f0a202", "width": 10}})
    ranges = _box(chart.asked)
    size = np.ptp(ranges, axis=1) / np.ptp(ranges, axis=1).max()
    named_spans = zip("xyz", chart.labels, ranges, strict=True)
    axes: Figure = {f"{name}axis": {"title": {"text": plain(label)}, "range": span.tolist()} for name, label, span in named_spans}
    if not np.any(chart.asked[:, 2]):
        axes["zaxis"] |= {"showticklabels": False}
    bar = {"title": {"text": "error [um]"}, "thickness": 12, "len": 0.7}
    camera = {"eye": {"x": 0.8, "y": -1.3, "z": 0.8}, "center": {"x": 0, "y": 0, "z": -0.1}}
    scene = {**axes, "aspectmode": "manual", "aspectratio": dict(zip("xyz", size.tolist(), strict=True)), "camera": camera}
    colours = {"colorscale": "Viridis", "cmin": 0.0, "cmax": max(tops), "colorbar": bar}
    layout = layout_look(560, hovermode="closest", scene=scene, coloraxis=colours)
    layout["margin"] = {"l": 0, "r": 0, "t": 30, "b": 0}
    del layout["dragmode"]
    magnify = {"start": chart.magnification, "curves": curves, "bar": _bar(float(np.ptp(chart.asked, axis=0).max()))}
    return {"data": data, "layout": layout, "magnify": magnify, "numbered": numbered}


def _columns(run: Magnified) -> Figure:
    """Return foot points [mm] and errors [um] for the page."""
    return {key: [packed(column) for column in part.T] for key, part in (("foot", run.foot), ("error", run.error))}


def _box(points: Array) -> Array:
    """Return the range (3, 2) [mm] of each axis in space: the path with room for errors, above a flat path the height of a third."""
    low, high = points.min(axis=0), points.max(axis=0)
    room = 0.12 * float((high - low).max())
    below, above = (np.array([1.0, 1.0, 0.0]), np.array([1.0, 1.0, 3.0])) if low[2] == high[2] else (np.ones(3), np.ones(3))
    return np.column_stack([low - room * below, high + room * above])


def _bar(extent: float) -> float:
    """Return the length of the scale bar [mm] for a path of an extent [mm]: a round number, at most an eighth of the drawing."""
    return round_down(extent / 8.0) if extent > 0.0 else 1.0


def packed(values: Array) -> dict[str, str]:
    """Pack numbers for plotly.js, as float32 if that is precise enough for a picture.

    >>> packed(np.array([1.0, 2.0]))
    {'dtype': 'f4', 'bdata': 'AACAPwAAAEA='}
    """
    values = np.asarray(values, dtype=np.float64)
    kind = "f4" if _fits_single(values) else "f8"
    return {"dtype": kind, "bdata": base64.b64encode(values.astype("<" + kind).tobytes()).decode("ascii")}


def _fits_single(values: Array) -> bool:
    """Return whether rounding to float32 is invisible, even at a hundredfold zoom."""
    good = values[np.isfinite(values)]
    if good.size == 0:
        return True
    largest, spread = float(np.max(np.abs(good))), float(np.ptp(good))
    return largest < 1e37 and (spread == 0.0 or largest <= SINGLE * spread)


def axis_look(title: str, **more: Any) -> Figure:
    """Return the style shared by all axes."""
    return {
        "title": {"text": plain(title), "font": {"size": 12, "color": MUTED}, "standoff": 8},
        "gridcolor": GRID,
        "zeroline": False,
        "linecolor": "#b9c1c9",
        "showline": True,
        "ticks": "outside",
        "ticklen": 4,
        "tickcolor": "#b9c1c9",
        "tickfont": {"size": 11, "color": MUTED},
        "automargin": True,
        **more,
    }


def layout_look(height: int, **more: Any) -> Figure:
    """Return the style shared by all figures."""
    return {
        "height": height,
        "margin": {"l": 74, "r": 22, "t": TOP, "b": BOTTOM},
        "paper_bgcolor": "rgba(0,0,0,0)",
        "plot_bgcolor": "#ffffff",
        "font": {"family": FONT, "size": 12, "color": INK},
        "legend": {"orientation": "h", "x": 0, "y": 1, "yanchor": "bottom", "xanchor": "left", "font": {"size": 12}},
        "hoverlabel": {"font": {"family": FONT, "size": 12}},
        "modebar": {"bgcolor": "rgba(255,255,255,0.8)", "color": "#9aa5b0", "activecolor": INK},
        "hovermode": "x unified",
        "dragmode": "zoom",
        **more,
    }


def plain(text: str) -> str:
    """Escape text for plotly.js, which interprets tags and links."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def line_look(curve: Curve | Magnified, **more: Any) -> Figure:
    """Return the style of one line."""
    width = curve.width if isinstance(curve, Curve) else 1.4
    style = {"color": curve.colour, "dash": curve.dash, "width": width}
    name = plain(curve.name)
    return {"type": "scatter", "mode": "lines", "name": name, "line": style, "legendgroup": name, **more}
