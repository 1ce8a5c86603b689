"""What a notebook shows of results: small tables and pictures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from io import StringIO
from typing import TYPE_CHECKING, TypeAlias

from contourlab.arrays import Array

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Panel: TypeAlias = tuple[str, str, Sequence[tuple[str, Array, Array]]]
"""Labels of x and y, and curves: name, x and y."""
SIZE = (7.0, 2.8)
"""Width and height of a picture [in]."""


def table(rows: Mapping[str, object]) -> str:
    """Return names and values as an HTML table."""
    lines = (f"<tr><th style='text-align:left'>{escape(name)}</th><td>{escape(str(value))}</td></tr>" for name, value in rows.items())
    return f"<table>{''.join(lines)}</table>"


def svg(figure: Figure) -> str:
    """Return a figure as SVG."""
    buffer = StringIO()
    figure.savefig(buffer, format="svg", metadata={"Date": None})
    text = buffer.getvalue()
    return text[text.index("<svg") :]


def curves(panels: Sequence[Panel], to_scale: bool = False) -> Figure:
    """Draw panels side by side, the first to scale if wanted."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=SIZE, layout="constrained")
    for i, (across, up, drawn) in enumerate(panels):
        axes = figure.add_subplot(1, len(panels), i + 1)
        for name, x, y in drawn:
            axes.plot(x, y, label=name, linewidth=1.0)
        axes.set(xlabel=across, ylabel=up)
        if to_scale and i == 0:
            axes.set_aspect("equal", "datalim")
        if len(drawn) > 1:
            axes.legend(fontsize="small")
    return figure
