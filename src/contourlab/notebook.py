"""What a notebook shows: small tables and pictures, and tables for pandas."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from html import escape
from io import StringIO
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from contourlab.arrays import Array
from contourlab.thinning import keep_extremes

if TYPE_CHECKING:
    import matplotlib.figure
    import pandas

Figure: TypeAlias = "matplotlib.figure.Figure"
Frame: TypeAlias = "pandas.DataFrame"
Panel: TypeAlias = tuple[str, str, Sequence[tuple[str, Array, Array]]]
"""Labels of x and y, and curves: name, x and y."""
WIDTH, HEIGHT = 7.0, 2.8
"""Size of a picture [in]."""
MOST_POINTS = 4000
"""Most points of a curve."""
LIGHT, DARK = "#9cc3e0", "#0072b2"


def facts_line(kind: str, facts: Mapping[str, object]) -> str:
    """Return the short ``repr`` of an object: its facts in one line."""
    return f"{kind}({'; '.join(f'{name}: {value}' for name, value in facts.items())})"


def facts_table(facts: Mapping[str, object]) -> str:
    """Return names and values as an HTML table."""
    return _table("".join(f"<tr>{_cell(name, 'th')}{_cell(value)}</tr>" for name, value in facts.items()))


def grid(heads: Sequence[str], rows: Mapping[str, Sequence[str]]) -> str:
    """Return rows of figures as an HTML table; the first head is that of the rows' names."""
    head = "".join(_cell(name, "th", "left" if i == 0 else "right") for i, name in enumerate(heads))
    body = (f"<tr>{_cell(name, 'th')}{''.join(_cell(text, align='right') for text in row)}</tr>" for name, row in rows.items())
    return _table(f"<tr>{head}</tr>{''.join(body)}")


def _table(rows: str) -> str:
    return f"<table>{rows}</table>"


def _cell(content: object, tag: str = "td", align: str = "left") -> str:
    style = f"text-align:{align};padding:1px 10px 1px 0" + ";white-space:nowrap" * (tag == "th")
    return f"<{tag} style='{style}'>{escape(str(content))}</{tag}>"


def frame(columns: Mapping[str, Any], index: Any = None, name: str | None = None, units: Mapping[str, str] | None = None) -> Frame:
    """Return columns as a table for pandas, with an index of a name if given; printed, it shows all columns, with their `units`."""
    import pandas

    made = _frame_class()(dict(columns), index=None if index is None else pandas.Index(index, name=name))
    made.attrs = {"units": dict(units)} if units else {}
    return made


@cache
def _frame_class() -> Any:
    import pandas

    class Wide(pandas.DataFrame):  # type: ignore[misc]
        """A table that is printed in panels where pandas would leave columns out; what is computed from it is a plain one."""

        _constructor = pandas.DataFrame

        def __repr__(self) -> str:
            heads = {name: f"{name} [{unit}]" for name, unit in self.attrs.get("units", {}).items() if unit}
            with pandas.option_context("display.max_columns", None, "display.float_format", "{:.4g}".format):
                return repr(self.rename(columns=heads))

        def __reduce_ex__(self, protocol: Any) -> Any:
            return pandas.DataFrame, (pandas.DataFrame(self),)

    return Wide


def svg(figure: Figure) -> str:
    """Return a figure as SVG."""
    buffer = StringIO()
    figure.savefig(buffer, format="svg", metadata={"Date": None})
    text = buffer.getvalue()
    return text[text.index("<svg") :]


def curves(panels: Sequence[Panel], to_scale: bool = False) -> Figure:
    """Draw panels side by side, the first to scale if wanted; long curves are thinned, peaks kept."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH, HEIGHT), layout="constrained")
    for i, (across, up, drawn) in enumerate(panels):
        axes = figure.add_subplot(1, len(panels), i + 1)
        for name, x, y in drawn:
            kept = keep_extremes(np.column_stack([x, y]), MOST_POINTS)
            axes.plot(x[kept], y[kept], label=name, linewidth=1.0)
        axes.set(xlabel=across, ylabel=up)
        if to_scale and i == 0:
            axes.set_aspect("equal", "datalim")
        if len(drawn) > 1:
            axes.legend(fontsize="small")
    return figure


def bars(label: str, values: Mapping[str, tuple[float, float]], names: tuple[str, str]) -> Figure:
    """Draw a wide and a narrow horizontal bar of each row: two values of one unit, with the names in the legend."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH, 0.9 + 0.3 * len(values)), layout="constrained")
    axes = figure.add_subplot()
    for name, height, colour, i in zip(names, (0.7, 0.35), (LIGHT, DARK), (0, 1), strict=True):
        axes.barh(list(values), [pair[i] for pair in values.values()], height=height, color=colour, label=name)
    axes.invert_yaxis()
    axes.set_xlabel(label)
    figure.legend(loc="outside right upper", fontsize="small")
    return figure
