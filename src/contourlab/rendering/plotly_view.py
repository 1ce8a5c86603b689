"""Charts as plain dictionaries for plotly.js: panels of lines, polar plots; paths are in `plotly_path`."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.rendering.charts import Chart, Panel, PathChart, PolarChart, SpaceChart
from contourlab.rendering.plotly_parts import BOTTOM, Figure, axis_look, layout_look, line_look, packed, plain
from contourlab.rendering.plotly_path import path_figure, space_figure
from contourlab.rendering.style import BAND, GRID, INK, LIMIT, MUTED

HEIGHT, GAP = 190, 26
BUTTONS, ROW, LABEL = 21, 29, 16
"""Heights above a picture [px]: buttons, a row of the legend, a label of the first panel."""
LEGEND_WIDTH, ENTRY, LETTER = 910.0, 45.0, 6.1
"""Widths [px]: a row of the legend, an entry without its text, a letter."""


TICKS = (("reversal", "triangle-up"), ("corner", "diamond"), ("first zero", "circle"), ("curvature step", "triangle-down"))
"""Symbols of marks on the x axis."""


def figure_of(chart: Chart | PolarChart | PathChart | SpaceChart) -> Figure:
    """Return a chart as a figure of plotly.js."""
    if isinstance(chart, PathChart):
        return path_figure(chart)
    if isinstance(chart, SpaceChart):
        return space_figure(chart)
    return _polar_figure(chart) if isinstance(chart, PolarChart) else _line_figure(chart)


def _line_figure(chart: Chart) -> Figure:
    """Return panels under one another; they zoom together along x."""
    count = len(chart.panels)
    one_high = chart.panel_height or (330 if count == 1 else HEIGHT)
    inner = one_high * count + GAP * (count - 1)
    label = LABEL if _labelled(chart.panels[0]) else 0
    top = BUTTONS + ROW * _legend_rows(chart) + label
    height = top + inner + BOTTOM
    layout = layout_look(height, shapes=[], annotations=[], hovermode="closest" if chart.loops else "x unified")
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
        x_axis |= {"type": "log", "dtick": 1} if panel.log_x else {}
        x_axis |= {"matches": "x"} if number else {}
        x_axis |= {} if panel.log_x else {"range": _x_span(chart)}
        layout[f"xaxis{tail}"] = x_axis
        layout[f"yaxis{tail}"] = axis_look(panel.y_label, anchor=f"x{tail}", domain=[max(high - one, 0.0), high])
        if panel.y_ticks:
            values = [value for value, _ in panel.y_ticks]
            layout[f"yaxis{tail}"] |= {"tickvals": values, "ticktext": [plain(text) for _, text in panel.y_ticks], "fixedrange": True}
        elif panel.log_y:
            values = _decades(panel)
            layout[f"yaxis{tail}"] |= {"type": "log", "tickvals": values, "ticktext": [f"{value:g}" for value in values]}
        if panel.y_range is not None:
            layout[f"yaxis{tail}"]["range"] = [math.log10(edge) for edge in panel.y_range] if panel.log_y else list(panel.y_range)
        data += _panel_curves(panel, tail, seen)
        _decorate(layout, panel, tail)
    return {"data": data, "layout": layout}


def _labelled(panel: Panel) -> bool:
    """Return whether a panel has a label above it."""
    return bool(panel.band_label or panel.span_label or any(level.label for level in panel.levels))


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
    for kind, symbol in TICKS:
        ticks = [tick for tick in panel.ticks if tick.kind == kind]
        if ticks:
            traces.append(_marks(panel, ticks, kind, symbol, tail))
    return traces


def _marks(panel: Panel, ticks: list[Any], kind: str, symbol: str, tail: str) -> Figure:
    """Return the marks of one kind, in a row at the foot of the panel."""
    low, high = _span(panel)
    floor = low - 0.06 * (high - low)
    return {
        "type": "scatter",
        "mode": "markers",
        "name": kind,
        "x": packed(np.array([tick.x for tick in ticks])),
        "y": [floor] * len(ticks),
        "text": [plain(tick.label) for tick in ticks],
        "hovertemplate": "%{text}",
        "marker": {"symbol": symbol, "size": 7, "color": MUTED},
        "cliponaxis": False,
        "xaxis": f"x{tail}",
        "yaxis": f"y{tail}",
    }


def _span(panel: Panel) -> tuple[float, float]:
    """Return the lowest and highest value that a panel shows."""
    if panel.y_range is not None:
        return panel.y_range
    values = [curve.y[np.isfinite(curve.y)] for curve in panel.curves]
    ends = [float(end) for part in values if part.size for end in (part.min(), part.max())] + list(panel.band or ())
    return (min(ends), max(ends)) if ends else (0.0, 1.0)


def _decorate(layout: Figure, panel: Panel, tail: str) -> None:
    """Add the tolerance band, span and limits of a panel, with their labels above it."""
    x, y = f"x{tail} domain", f"y{tail}"
    span = {"type": "rect", "xref": x, "x0": 0, "x1": 1, "yref": y, "layer": "below"}
    if panel.band is not None:
        low, high = panel.band
        fill = {"fillcolor": BAND, "opacity": 0.09, "line": {"width": 0}}
        layout["shapes"].append({**span, **fill, "y0": low, "y1": high})
        for edge in sorted({low, high} - {0.0}):
            line = {"color": BAND, "width": 1, "dash": "dot"}
            layout["shapes"].append({**span, "type": "line", "y0": edge, "y1": edge, "line": line})
        outside = panel.y_range is not None and high > panel.y_range[1]
        layout["annotations"].append(_note(panel.band_label + (", off scale" if outside else ""), BAND, tail))
    if panel.span is not None:
        across: Figure = {"type": "rect", "xref": f"x{tail}", "yref": f"y{tail} domain", "y0": 0, "y1": 1, "layer": "below"}
        fill = {"fillcolor": BAND, "opacity": 0.09, "line": {"width": 0}}
        layout["shapes"].append({**across, **fill, "x0": panel.span[0], "x1": panel.span[1]})
        layout["annotations"].append(_note(panel.span_label, BAND, tail))
    for level in panel.levels:
        line = {"color": LIMIT, "width": 1.1, "dash": "dash"}
        if not panel.far:
            shape = {"type": "line", "layer": "above", "y0": level.value, "y1": level.value, "line": line}
            layout["shapes"].append({**span, **shape})
        if level.label:
            text = level.label + (", off scale" if panel.far else "")
            layout["annotations"].append(_note(text, LIMIT, tail))


def _note(text: str, colour: str, tail: str) -> Figure:
    """Return a small text above the right end of a panel."""
    font = {"size": 11, "color": colour}
    place = {"xref": f"x{tail} domain", "yref": f"y{tail} domain", "x": 1, "y": 1, "yshift": 2}
    return {"text": text, "showarrow": False, "font": font, **place, "xanchor": "right", "yanchor": "bottom"}


def _polar_figure(chart: PolarChart) -> Figure:
    """Return a ball-bar plot: the ring at 0 is the nominal circle."""
    data: list[Figure] = [
        {**line_look(curve), "type": "scatterpolar", "r": packed(curve.y), "theta": packed(curve.x)} for curve in chart.curves
    ]
    for trace in data:
        trace["hovertemplate"] = "%{r:.3g} um at %{theta:.1f}°"
    for mark in chart.marks:
        points = {"r": packed(mark.y), "theta": packed(mark.x), "name": plain(mark.name), "legendgroup": plain(mark.name)}
        ring = {"symbol": "circle-open", "size": 9, "color": mark.colour, "line": {"width": 1.6}}
        hover = "reversal spike, %{r:.3g} um at %{theta:.1f}°"
        data.append({"type": "scatterpolar", "mode": "markers", "marker": ring, **points, "hovertemplate": hover, "showlegend": False})
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
