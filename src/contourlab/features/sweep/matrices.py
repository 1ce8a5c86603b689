"""Pictures of pairings: the figure of each module with each other one, and under each choice."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import Any

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.features.sweep.answers import Answers
from contourlab.features.sweep.effects import FEW, means_of
from contourlab.features.sweep.pairings import best_choice
from contourlab.features.sweep.rows import Rows
from contourlab.features.sweep.summary import display
from contourlab.features.sweep.words import shown, title_of
from contourlab.rendering.plotly_view import axis_look, layout_look, packed, plain

CELLS = 200
"""Most modules of a kind in a picture."""
MOST = 6
"""Most pictures."""
WITHIN, BEYOND = ("#0b3c6f", "#dbe9f6"), ("#fde3cf", "#8c1c13")
"""Colours up to the tolerance, and above it."""
EVEN = ((0.0, "#0b3c6f"), (0.5, "#f2f2f2"), (1.0, "#8c1c13"))


def matrices(answers: Answers, rows: Rows) -> Iterator[dict[str, Any]]:
    """Yield a picture for each two kinds of modules, under the best choice, and for each kind and choice."""
    if answers.pairings is None:
        return
    best = best_choice(rows)[1]
    kinds = list(rows.store.modules)
    choices = [name for name in answers.pairings.choices if len(np.unique(rows.column(name)[0])) <= FEW]
    pairs = [(best, *pair) for pair in combinations(kinds, 2)] + [(rows, kind, name) for kind in kinds for name in choices]
    for some, first, second in pairs[:MOST]:
        yield _matrix(answers, some, first, second)


def _matrix(answers: Answers, rows: Rows, first: str, second: str) -> dict[str, Any]:
    """Return the picture of two columns: the mean figure of the pairings in each cell; nothing where one of them diverged."""
    unit, factor = display(answers.unit)
    (x, x_names), (y, y_names) = (_order(rows, name) for name in (first, second))
    drawn = (x >= 0) & (y >= 0)
    size = len(x_names) * len(y_names)
    cell = y[drawn] * len(x_names) + x[drawn]
    with np.errstate(invalid="ignore"):
        count = np.bincount(cell, minlength=size)
        z = np.bincount(cell, rows.values[drawn] * factor, size) / count
    z[~np.isfinite(z)] = np.nan
    names = first.removesuffix(".module"), second.removesuffix(".module")
    heat = {
        "type": "heatmap",
        "x": x_names,
        "y": y_names,
        "z": packed(z) | {"shape": f"{len(y_names)},{len(x_names)}"},
        "hovertemplate": f"{plain(names[0])} %{{x}}<br>{plain(names[1])} %{{y}}<br>%{{z:.4g}} {unit}<extra></extra>",
        "hoverongaps": False,
        "colorbar": {"title": {"text": unit}, "thickness": 14, "outlinewidth": 0},
        **_colours(z, None if answers.tolerance is None else answers.tolerance * factor),
    }
    axes = [axis_look(label, type="category", showgrid=False, constrain="domain") for label in names]
    height = min(max(16 * len(y_names) + 150, 220), 560)
    layout = layout_look(height, xaxis=axes[0], yaxis=axes[1], hovermode="closest", plot_bgcolor="#444444", showlegend=False)
    return {
        "id": f"matrix-{names[0]}-{names[1]}".replace(".", "-"),
        "title": f"{names[0]} and {names[1]}",
        "caption": _caption(answers, rows, bool(count.max() > 1), (first, second)),
        "view": "",
        "spec": {"data": [heat], "layout": layout},
        "height": height,
    }


def _order(rows: Rows, name: str) -> tuple[Index, list[str]]:
    """Return the place of each row along an axis, -1 if it is not drawn, and the labels; modules in the order of their mean figure."""
    if name not in rows.store.modules:
        codes, labels = rows.column(name)
        kept, place = np.unique(codes, return_inverse=True)
        unit = rows.store.columns[name]
        return place, [labels[int(code)] if labels else shown(float(code), unit, 4) for code in kept]
    member, numbers = rows.members[name], np.unique(rows.table[name].to_numpy())
    order = np.lexsort((means_of(member, rows.values).mean, np.bincount(member, np.isinf(rows.values))))
    order = order[np.unique(np.linspace(0, len(order) - 1, CELLS).round().astype(int))]
    place = np.full(len(numbers), -1)
    place[order] = np.arange(len(order))
    return place[member], [str(number) for number in numbers[order]]


def _colours(z: Array, tolerance: float | None) -> dict[str, Any]:
    """Return the colours: blue up to the tolerance, red above it."""
    known = z[np.isfinite(z)]
    low, high = (float(known.min()), float(np.quantile(known, 0.995))) if known.size else (0.0, 1.0)
    if tolerance is None:
        return {"zmin": low, "zmax": high, "colorscale": EVEN}
    low, high = min(low, tolerance), max(high, tolerance * (1.0 + 1e-6))
    middle = (tolerance - low) / (high - low)
    scale = [(0.0, WITHIN[0]), (middle, WITHIN[1]), (middle, BEYOND[0]), (1.0, BEYOND[1])]
    return {"zmin": low, "zmax": high, "colorscale": scale}


def _caption(answers: Answers, rows: Rows, is_mean: bool, names: tuple[str, str]) -> str:
    bound = "" if answers.tolerance is None else f" Blue: within {shown(answers.tolerance, 'm', 6)}; red: beyond."
    parts = [f"The {title_of(answers.figure)} of each pairing{', the mean over all else' if is_mean else ''}.{bound}"]
    parts.append("Modules are in the order of their mean, the best first; the ticks are their numbers.")
    if np.isinf(rows.values).any():
        parts.append("Dark: diverged.")
    if any(rows.store.modules.get(name, 0) > CELLS for name in names):
        parts.append(f"Of more than {CELLS} modules, {CELLS} are drawn, evenly along this order.")
    return " ".join(parts)
