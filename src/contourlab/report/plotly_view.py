"""Charts as plain dictionaries for plotly.js; numbers travel as base64 of little-endian floats."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.report.charts import Chart, Curve, Magnified, Panel, PathChart, PolarChart
from contourlab.report.style import BAND, FONT, GRID, INK, LIMIT, MUTED, POOR
from contourlab.report.text import round_down

__all__ = ["Figure", "line_figure", "packed", "path_figure", "polar_figure"]

Figure = dict[str, Any]
Array = NDArray[np.float64]

SINGLE = 64.0  # float32 rounds to 2^-24 of the value: up to 64 spreads off zero that is 2^-18 of the spread, far below a pixel
HEIGHT, GAP, TOP, BOTTOM = 190, 26, 38, 56


def packed(values: Array) -> dict[str, str]:
    """Pack numbers as plotly.js reads them; float32 where that is fine enough for a picture.

    >>> packed(np.array([1.0, 2.0]))
    {'dtype': 'f4', 'bdata': 'AACAPwAAAEA='}
    """
    values = np.asarray(values, dtype=np.float64)
    kind = "f4" if _fits_single(values) else "f8"
    return {"dtype": kind, "bdata": base64.b64encode(values.astype("<" + kind).tobytes()).decode("ascii")}


def _fits_single(values: Array) -> bool:
    """Tell whether rounding to float32 is invisible, even when zoomed in a hundred times."""
    good = values[np.isfinite(values)]
    if good.size == 0:
        return True
    largest, spread = float(np.max(np.abs(good))), float(np.ptp(good))
    return largest < 1e37 and (spread == 0.0 or largest <= SINGLE * spread)


def _axis(title: str, **more: Any) -> Figure:
    """Return the looks that all axes share."""
    return {
        "title": {"text": title, "font": {"size": 12, "color": MUTED}, "standoff": 8},
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


def _layout(height: int, **more: Any) -> Figure:
    """Return the looks that all figures share."""
    return {
        "height": height,
        "margin": {"l": 74, "r": 22, "t": TOP, "b": BOTTOM},
        "paper_bgcolor": "rgba(0,0,0,0)",
        "plot_bgcolor": "#ffffff",
        "font": {"family": FONT, "size": 12, "color": INK},
        "legend": {"orientation": "h", "x": 0, "y": 1, "yanchor": "bottom", "xanchor": "left", "font": {"size": 12}},
        "hoverlabel": {"font": {"family": FONT, "size": 12}},
        "hovermode": "x unified",
        "dragmode": "zoom",
        **more,
    }


def _line(curve: Curve | Magnified, **more: Any) -> Figure:
    """Return the looks of one line."""
    width = curve.width if isinstance(curve, Curve) else 1.4
    style = {"color": curve.colour, "dash": curve.dash, "width": width}
    return {"type": "scatter", "mode": "lines", "name": curve.name, "line": style, "legendgroup": curve.name, **more}


def line_figure(chart: Chart) -> Figure:
    """Return panels under one another; they zoom together along x."""
    count = len(chart.panels)
    height = (330 if count == 1 else HEIGHT * count) + GAP * (count - 1) + TOP + BOTTOM
    layout = _layout(height, shapes=[], annotations=[])
    inner = height - TOP - BOTTOM
    one = (inner - GAP * (count - 1)) / count / inner
    data: list[Figure] = []
    seen: set[str] = set()
    for number, panel in enumerate(chart.panels):
        tail = "" if number == 0 else str(number + 1)
        high = 1.0 - number * (one + GAP / inner)
        last = number == count - 1
        x_axis = _axis(panel.x_label if last else "", anchor=f"y{tail}", showticklabels=last)
        x_axis |= {"type": "log", "dtick": 1} if panel.log_x else {}
        x_axis |= {"matches": "x"} if number else {}
        layout[f"xaxis{tail}"] = x_axis
        layout[f"yaxis{tail}"] = _axis(panel.y_label, anchor=f"x{tail}", domain=[max(high - one, 0.0), high])
        if panel.y_range is not None:
            layout[f"yaxis{tail}"]["range"] = list(panel.y_range)
        data += _panel_curves(panel, tail, seen)
        _decorate(layout, panel, tail)
    return {"data": data, "layout": layout}


def _panel_curves(panel: Panel, tail: str, seen: set[str]) -> list[Figure]:
    """Return the curves and marks of a panel; a name is in the legend once."""
    unit = panel.y_label.partition("[")[2].rstrip("]")
    traces = []
    for curve in panel.curves:
        trace = _line(curve, x=packed(curve.x), y=packed(curve.y), xaxis=f"x{tail}", yaxis=f"y{tail}")
        trace |= {"showlegend": curve.name not in seen, "hovertemplate": f"%{{y:.4g}} {unit}"}
        seen.add(curve.name)
        traces.append(trace)
    for kind, symbol in (("reversal", "triangle-up"), ("corner", "diamond")):
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
        "text": [tick.label for tick in ticks],
        "hovertemplate": "%{text}",
        "marker": {"symbol": symbol, "size": 7, "color": MUTED},
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
    """Add the tolerance band and the limit lines of a panel."""
    x, y = f"x{tail} domain", f"y{tail}"
    note = {"xref": x, "yref": y, "showarrow": False, "xanchor": "right", "x": 1.0, "font": {"size": 11}}
    span = {"type": "rect", "xref": x, "x0": 0, "x1": 1, "yref": y, "layer": "below"}
    if panel.band is not None:
        low, high = panel.band
        layout["shapes"].append({**span, "y0": low, "y1": high, "fillcolor": BAND, "opacity": 0.09, "line": {"width": 0}})
        for edge in {low, high} - {0.0}:
            line = {"color": BAND, "width": 1, "dash": "dot"}
            layout["shapes"].append({**span, "type": "line", "y0": edge, "y1": edge, "line": line})
        if panel.y_range is None or high <= panel.y_range[1]:
            text = {"text": panel.band_label, "y": high, "yanchor": "bottom", "font": {"size": 11, "color": BAND}}
        else:  # the band is wider than the picture: say so inside it
            text = {"text": panel.band_label + " is outside the picture", "y": panel.y_range[1], "yanchor": "top"}
            text["font"] = {"size": 11, "color": BAND}
        layout["annotations"].append({**note, **text})
    for level in panel.levels:
        line = {"color": LIMIT, "width": 1.1, "dash": "dash"}
        layout["shapes"].append({**span, "type": "line", "y0": level.value, "y1": level.value, "line": line})
        if level.label:
            text = {"text": level.label, "y": level.value, "yanchor": "bottom", "font": {"size": 11, "color": LIMIT}}
            layout["annotations"].append({**note, **text})


def polar_figure(chart: PolarChart) -> Figure:
    """Return a ball-bar plot: the ring at 0 is the nominal circle."""
    data: list[Figure] = [
        {**_line(curve), "type": "scatterpolar", "r": packed(curve.y), "theta": packed(curve.x)} for curve in chart.curves
    ]
    for trace in data:
        trace["hovertemplate"] = "%{r:.3g} µm at %{theta:.1f}°"
    nominal = {"color": INK, "width": 1.1}
    ring = {"type": "scatterpolar", "mode": "lines", "name": "nominal", "line": nominal, "hoverinfo": "skip"}
    data.append({**ring, "theta": list(range(0, 361, 3)), "r": [0] * 121})
    low, high = chart.reach
    rings = np.arange(np.ceil(-high / chart.division), np.floor(high / chart.division) + 1) * chart.division
    look = {"gridcolor": GRID, "linecolor": "#b9c1c9", "tickfont": {"size": 11, "color": MUTED}}
    marks = {"tickvals": rings.tolist(), "ticktext": [f"{ring:+g} µm" if ring else "0" for ring in rings.tolist()]}
    radial = {**look, **marks, "range": [low, high], "angle": 90, "tickangle": 90, "showline": False}
    angular = {**look, "ticksuffix": "°", "dtick": 45}
    polar = {"radialaxis": radial, "angularaxis": angular, "bgcolor": "#ffffff"}
    legend = {"orientation": "h", "x": 0.5, "y": -0.08, "xanchor": "center", "yanchor": "top", "font": {"size": 12}}
    layout = _layout(520, polar=polar, legend=legend, hovermode="closest")
    layout["margin"] = {"l": 50, "r": 50, "t": 30, "b": 50}
    return {"data": data, "layout": layout}


def path_figure(chart: PathChart) -> Figure:
    """Return the path; the page itself adds the errors to the foot points, so that the reader can change the magnification.

    Notes
    -----
    Besides `data` and `layout` the figure has ``magnify``: the magnification to begin with, and for every magnified trace its number, foot
    points [mm] and errors [um] as packed columns.
    """
    moved = (*chart.tolerance, *chart.runs)
    data = [_line(line, x=packed(line.x), y=packed(line.y), hoverinfo="skip") for line in chart.lines]
    curves = []
    names: set[str] = set()
    for run in moved:
        size = np.hypot(run.error[:, 0], run.error[:, 1])
        trace = _line(run, hovertemplate="%{customdata:.3g} µm", showlegend=run.name not in names)
        names.add(run.name)
        if run in chart.runs:
            trace["customdata"] = packed(size)
        else:
            trace |= {"hoverinfo": "skip", "hovertemplate": None}
            trace["line"]["width"] = 1
        columns = {key: [packed(part[:, 0]), packed(part[:, 1])] for key, part in (("foot", run.foot), ("error", run.error))}
        curves.append({"trace": len(data), **columns})
        data.append(trace)
    if chart.worst is not None:
        mark = {"symbol": "circle-open", "size": 15, "color": POOR, "line": {"width": 2.2}}
        place = {"x": packed(chart.worst.x), "y": packed(chart.worst.y)}
        data.append({"type": "scatter", "mode": "markers", "name": chart.worst.name, "marker": mark, **place, "hoverinfo": "name"})
    layout = _layout(620, hovermode="closest", dragmode="pan")
    layout["xaxis"] = _axis(chart.labels[0], constrain="domain")
    layout["yaxis"] = _axis(chart.labels[1], scaleanchor="x", constrain="domain")
    return {"data": data, "layout": layout, "magnify": {"start": chart.magnification, "curves": curves, "bar": _bar(chart)}}


def _bar(chart: PathChart) -> float:
    """Return a round length on the drawing [mm], about an eighth of its width, to tell what it is worth in error."""
    extent = max(float(np.ptp(chart.lines[0].x)), float(np.ptp(chart.lines[0].y)))
    return round_down(extent / 8.0) if extent > 0.0 else 1.0
