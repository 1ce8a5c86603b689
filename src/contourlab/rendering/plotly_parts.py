"""What all figures of plotly.js share: packed numbers, axes, layout, lines. Numbers travel as base64 of little-endian floats."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.rendering.charts import Curve, Magnified
from contourlab.rendering.style import FONT, GRID, INK, MUTED

Figure = dict[str, Any]

SINGLE = 64.0
"""Largest magnitude over spread for float32: rounding to 2^-24 of the value is then 2^-18 of the spread, far below a pixel."""
TOP, BOTTOM = 50, 56
"""Heights above and below a picture [px]."""


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
