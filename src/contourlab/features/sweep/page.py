"""The page of ``contourlab sweep report``: one HTML file that needs no network."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import astuple
from pathlib import Path
from typing import Any

import numpy as np

from contourlab import __version__
from contourlab.app.command_line import as_typed
from contourlab.features.sweep.answers import Answers
from contourlab.features.sweep.matrices import matrices
from contourlab.features.sweep.rows import Rows
from contourlab.features.sweep.summary import display
from contourlab.features.sweep.words import Words, kind_of, range_text, share_text, shown, title_of, value_text
from contourlab.rendering.charts import Chart, Curve, Panel
from contourlab.rendering.html import embedded, entry_of, page_template
from contourlab.rendering.style import REFERENCE, scheme_style
from contourlab.result import write_text_atomic

BARS, POINTS = 60, 2000
"""Bars of a histogram, and most points of a cloud."""
MOST_CURVES, WORTH_CURVES = 6, 0.02
"""Most curves of a distribution, and the least index of the column that divides it."""
TABLE_FRONT = 12
"""Most rows of the table of the Pareto front."""


def write_page(answers: Answers, rows: Rows, words: Words, file: Path) -> None:
    """Write the page.

    Raises
    ------
    OutputError
        If it cannot be written.
    """
    groups = {
        "distribution": [entry_of(_distribution(answers, rows))],
        "convergence": [entry_of(chart) for chart in _convergence(answers)],
        "front": list(_fronts(answers, rows)),
        "modules": list(matrices(answers, rows)),
    }
    unit, factor = display(answers.unit)
    text = page_template("sweep.html.j2").render(
        title=answers.question or Path(answers.store).name,
        kind=kind_of(answers),
        answers=answers,
        words=Words(*(text.replace(" %", "\N{NO-BREAK SPACE}%") for text in astuple(words))),
        groups=groups,
        unit=unit,
        factor=factor,
        front=_front_table(answers),
        titles=[title_of(name) for name in answers.objectives],
        next=as_typed(["contourlab", "sweep", "worst", answers.store]),
        version=__version__,
        study=rows.store.manifest["study"],
        figure_title=title_of(answers.figure),
        share=share_text,
        between=range_text,
        value=value_text,
        shown=shown,
        **embedded(groups),
    )
    write_text_atomic(file, str(text))


def _distribution(answers: Answers, rows: Rows) -> Chart:
    """Return histogram and cumulative curve, divided by the column of few values that decides most."""
    unit, factor = display(answers.unit)
    values = rows.values * factor
    ended = values[np.isfinite(values)]
    tolerance = None if answers.tolerance is None else answers.tolerance * factor
    low, high = (float(ended.min()), float(np.quantile(ended, 0.999))) if ended.size else (0.0, 1.0)
    if tolerance is not None:
        low, high = min(low, 0.98 * tolerance), max(high, 1.02 * tolerance)
    edges = np.linspace(low, high if high > low else low + 1.0, BARS + 1)
    heights, sums = [], []
    parts = _parts(answers, rows)
    for i, (name, chosen) in enumerate(parts):
        part = values if chosen is None else values[chosen]
        counts, _ = np.histogram(part[np.isfinite(part)], edges)
        x, y = np.repeat(edges, 2), np.concatenate([[0.0], np.repeat(100.0 * counts / len(part), 2), [0.0]])
        below = np.count_nonzero(part < edges[0]) + np.concatenate([[0], np.cumsum(counts)])
        look = scheme_style(i, len(parts))
        heights.append(Curve(x, y, name, *look))
        sums.append(Curve(edges, 100.0 * below / len(part), name, *look))
    title = title_of(answers.figure)
    label, span = f"{title} [{unit}]", None if tolerance is None else (float(edges[0]), tolerance)
    within = "" if tolerance is None else f"within {shown(answers.tolerance, 'm', 6)}"
    beyond = np.count_nonzero(values > edges[-1])
    kind = kind_of(answers)
    note = f" {beyond:,} {kind} lie beyond the right end." if beyond else ""
    return Chart(
        "distribution",
        f"Distribution of the {title}",
        f"Above: share of the {kind} in each of {BARS} intervals. Below: share with at most this {title}.{note}",
        (
            Panel(label, "share [%]", tuple(heights), span=span, span_label=within),
            Panel(label, "up to here [%]", tuple(sums), span=span, y_range=(0.0, 103.0)),
        ),
        panel_height=210,
    )


def _parts(answers: Answers, rows: Rows) -> list[tuple[str, Any]]:
    """Return names and rows of the parts of the distribution; None for all rows."""
    index = {one.column: one.index for one in answers.effects}
    columns = [name for name in dict.fromkeys(one.column for one in answers.subsets) if index.get(name, 0.0) >= WORTH_CURVES]
    for name in sorted(columns, key=lambda name: -index[name]):
        subsets = [one for one in answers.subsets if one.column == name]
        if len(subsets) <= MOST_CURVES:
            codes, labels = rows.column(rows.first(name))
            wanted = [labels.index(one.value) if isinstance(one.value, str) else one.value for one in subsets]
            return [(f"{name} {value_text(one)}", codes == code) for one, code in zip(subsets, wanted, strict=True)]
    return [(f"all {kind_of(answers)}", None)]


def _convergence(answers: Answers) -> Iterable[Chart]:
    """Return yield and quantile over the number of variants."""
    known = [one for one in answers.convergence if one.p95 is not None and one.p95_low is not None and one.p95_high is not None]
    if len(answers.convergence) < 2 or (answers.tolerance is None and len(known) < 2):
        return
    unit, factor = display(answers.unit)
    panels, kind = [], kind_of(answers)
    if answers.tolerance is not None:
        shares = [(one.share, one.share_low, one.share_high) for one in answers.convergence]
        curves = _banded([one.variants for one in answers.convergence], shares, 100.0)
        panels.append(Panel(f"number of {kind}", "yield [%]", curves, log_x=True))
    if len(known) > 1:
        curves = _banded([one.variants for one in known], [(one.p95, one.p95_low, one.p95_high) for one in known], factor)
        panels.append(Panel(f"number of {kind}", f"95 % quantile [{unit}]", curves, log_x=True))
    caption = f"Estimates from the first {kind} up to each number; dashed: their intervals of 95 %."
    yield Chart("convergence", "Convergence", caption, tuple(panels))


def _banded(variants: list[int], triples: list[Any], factor: float) -> tuple[Curve, ...]:
    x, y = np.array(variants, dtype=float), np.array(triples, dtype=float) * factor
    colour, _ = scheme_style(0, 1)
    ends = [Curve(x, y[:, k], "95 % interval", colour, "dash", 1.0) for k in (1, 2)]
    return (Curve(x, y[:, 0], "estimate", colour, width=2.0), *ends)


def _fronts(answers: Answers, rows: Rows) -> Iterable[dict[str, Any]]:
    """Return a picture of the first objective over each other one; a point tells its variant."""
    if not answers.objectives:
        return
    n, kind = len(rows.values), kind_of(answers)
    some = np.sort(np.random.default_rng(0).choice(n, min(n, POINTS), replace=False))
    cloud = {name: rows.column(name)[0][some] for name in ("variant", *answers.objectives)}
    front = {name: np.array([row[name] for row in answers.front], dtype=float) for name in cloud}
    clouds = ((kind, REFERENCE, 4, cloud), ("best compromises", scheme_style(0, 2)[0], 8, front))
    first, *others = ((name, *display(unit)) for name, unit in answers.objectives.items())
    thinned = f" {POINTS:,} of {n:,} are drawn." if n > POINTS else ""
    for other in others:
        labels = [f"{title_of(name)} [{unit}]" if unit else title_of(name) for name, unit, _ in (other, first)]
        curves = [
            Curve(of[other[0]] * other[2], of[first[0]] * first[2], name, colour, half=np.zeros(len(of["variant"])))
            for name, colour, _, of in clouds
        ]
        panel = Panel(labels[0], labels[1], tuple(curves))
        title = f"{title_of(first[0])} and {title_of(other[0])}"
        caption = f"The least is best on both axes. Hover over a point to see its number.{thinned}"
        entry = entry_of(Chart(f"front-{other[0]}", title[0].upper() + title[1:], caption, (panel,), 380, loops=True))
        for trace, (_, _, size, of) in zip(entry["spec"]["data"], clouds, strict=True):
            trace["text"] = [f"variant {number:.0f}" for number in of["variant"]]
            trace["hovertemplate"] = "%{text}<br>%{x:.4g}, %{y:.4g}<extra></extra>"
            trace["marker"]["size"] = size
            trace.pop("error_y")
        yield entry


def _front_table(answers: Answers) -> list[list[str]]:
    """Return rows of the front: variant and objectives."""
    if not answers.front:
        return []
    chosen = answers.front[:: max(-(-len(answers.front) // TABLE_FRONT), 1)]
    return [[str(row["variant"]), *(shown(row[name], unit, 4) for name, unit in answers.objectives.items())] for row in chosen]
