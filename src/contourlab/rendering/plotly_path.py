"""The path with magnified errors as figures of plotly.js, in a plane and in space.

The page draws the errors at the foot points, with the magnification that the reader sets: ``magnify`` holds the initial magnification, the
length of the scale bar [mm], and the index, foot points [mm] and errors [um] of each magnified trace as packed columns. ``numbered`` holds
the program lines of the traces, the path itself first; the last trace is the part that the chosen line programs.
"""

from __future__ import annotations

import base64

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.rendering.charts import Magnified, PathChart, SpaceChart
from contourlab.rendering.plotly_parts import Figure, axis_look, layout_look, line_look, packed, plain
from contourlab.rendering.style import INK, round_down

PICKED: Figure = {"mode": "lines", "hoverinfo": "skip", "showlegend": False, "line": {"color": "#f0a202", "width": 6}, "opacity": 0.7}
"""The part of the path that the chosen line programs."""


def path_figure(chart: PathChart) -> Figure:
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
    layout = layout_look(_path_height(chart), hovermode="closest", dragmode="pan")
    layout["legend"] |= {"orientation": "v", "x": 1.01, "y": 1, "yanchor": "top"}
    layout["margin"] |= {"t": 24}
    layout["xaxis"] = axis_look(chart.labels[0])
    layout["yaxis"] = axis_look(chart.labels[1], scaleanchor="x")
    magnify = {"start": chart.magnification, "curves": curves, "bar": _bar(np.column_stack([chart.lines[0].x, chart.lines[0].y]))}
    data.append({**PICKED, "type": "scatter", "x": [], "y": []})
    return {"data": data, "layout": layout, "magnify": magnify, "numbered": numbered}


def _numbered(trace: int, lines: Index | None) -> list[Figure]:
    """Return the program lines of a trace for the page; nothing without any."""
    if lines is None or not lines.any():
        return []
    text = base64.b64encode(lines.astype("<i4").tobytes()).decode("ascii")
    return [{"trace": trace, "line": {"dtype": "i4", "bdata": text}}]


def space_figure(chart: SpaceChart) -> Figure:
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
    magnify = {"start": chart.magnification, "curves": curves, "bar": _bar(chart.asked)}
    return {"data": data, "layout": layout, "magnify": magnify, "numbered": numbered}


def _path_height(chart: PathChart) -> int:
    """Return the height [px] that suits the path's shape in a drawing 760 px wide."""
    wide, high = float(np.ptp(chart.lines[0].x)), float(np.ptp(chart.lines[0].y))
    return round(min(max(760.0 * high / wide + 110.0, 340.0), 680.0)) if wide > 0.0 else 680


def _columns(run: Magnified) -> Figure:
    """Return foot points [mm] and errors [um] for the page."""
    return {key: [packed(column) for column in part.T] for key, part in (("foot", run.foot), ("error", run.error))}


def _box(points: Array) -> Array:
    """Return the range (3, 2) [mm] of each axis in space: the path with room for errors, above a flat path the height of a third."""
    low, high = points.min(axis=0), points.max(axis=0)
    room = 0.12 * float((high - low).max())
    below, above = (np.array([1.0, 1.0, 0.0]), np.array([1.0, 1.0, 3.0])) if low[2] == high[2] else (np.ones(3), np.ones(3))
    return np.column_stack([low - room * below, high + room * above])


def _bar(points: Array) -> float:
    """Return the length of the scale bar [mm] for a path (n, n_axis) [mm]: a round number, at most an eighth of the drawing."""
    extent = float(np.ptp(points, axis=0).max())
    return round_down(extent / 8.0) if extent > 0.0 else 1.0
