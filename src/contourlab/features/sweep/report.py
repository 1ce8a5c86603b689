"""``contourlab sweep report``: what a store answers, as text for the terminal and as one HTML page that needs no network."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain, combinations
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.app.command_line import as_typed
from contourlab.app.json_values import HIDDEN
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.arrays import Array, Index
from contourlab.features.sweep.answers import FEW, GOAL, Answers, Effect, Pairings, Subset, answers_of, best_choice, means_of
from contourlab.features.sweep.options import Report
from contourlab.features.sweep.query import Rows, display, read_rows
from contourlab.features.sweep.store import read_store
from contourlab.figures import figure, listing, number
from contourlab.metrics.run_figures import title_of
from contourlab.rendering.charts import Chart, Curve, Heat, Panel, Picture
from contourlab.rendering.html import page_text
from contourlab.rendering.style import REFERENCE, scheme_style
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import write_text_atomic

SHORT = 0.1
"""Time [s] below which milliseconds are shown."""
CLEAR = 0.02
"""Least difference of two yields that is worth a sentence."""
SORTED = (0.9, 0.99, 0.999)
"""Yields to reach by sorting out modules: the next one above the yield of all."""
MATTERS = 0.01
"""Least share of the variance of a parameter that matters."""
LITTLE = "less than 1 %, or may explain nothing (interval from 0 %)"
"""What a parameter explains that does not matter for certain."""


def said(answers: Answers) -> dict[str, str]:
    """Return the answers in sentences, empty where there is none.

    They are: the first answer; what decides the figure; whether more variants are needed; the Pareto front; what the modules decide, and
    which to sort out.
    """
    count, title = f"{answers.judged:,}", answers.title
    sure = " with 95 % confidence)"
    if answers.design == "search":
        first = f"The best of {count} variants of a search has a {title} of {shown(answers.smallest, answers.unit)}."
    elif answers.share is not None:
        interval = f" ({range_text(answers.low, answers.high)}{sure}" if answers.is_sample else ""
        passing = f"{answers.passed:,} of {count} {answers.kind} make the part within {shown(answers.tolerance, 'm', 6)}"
        first = f"{passing}: {share_text(answers.share)}{interval}."
    else:
        low, high, p95, median = (shown(value, answers.unit) for value in (answers.p95_low, answers.p95_high, answers.p95, answers.median))
        interval = f" ({low} to {high}{sure}" if answers.is_sample and answers.p95_low is not None else ""
        first = f"95 % of {count} {answers.kind} have a {title} up to {p95}{interval}; half of them up to {median}."
    front = ""
    if answers.objectives:
        names = listing([title_of(name) for name in answers.objectives])
        front = f"{answers.front_size:,} of {count} {answers.kind} are best compromises of {names}: no other is better in all."
    sentence = " ".join(filter(None, (first, _which(answers))))
    rest = {"decides": _decides(answers), "stop": _stop(answers), "front": front, "modules": _modules(answers)}
    return {"sentence": sentence, **rest}


def share_text(share: float | None, digits: int = 4) -> str:
    """Return a share in percent; close to 0 and 1 without needless digits."""
    return "-" if share is None else figure(round(share, digits), "%", digits)


def range_text(low: float | None, high: float | None, digits: int = 4) -> str:
    """Return an interval of shares in percent."""
    return "-" if low is None or high is None else f"{share_text(low, digits).removesuffix(' %')} to {share_text(high, digits)}"


def shown(value: float | None, unit: str, digits: int = 3) -> str:
    """Return a value in its display unit."""
    if unit == "s" and value is not None and abs(value) < SHORT:
        return figure(value, "ms", digits)
    name, factor = display(unit)
    return "-" if value is None else f"{number(value * factor, digits)} {name}".strip()


def value_text(subset: Subset) -> str:
    """Return the value of a subset."""
    return subset.value if isinstance(subset.value, str) else shown(subset.value, subset.unit, 4)


def _which(answers: Answers) -> str:
    """Return which variants pass: those on one side of the best cut."""
    best = max(answers.effects, key=lambda one: one.gain, default=None)
    if best is None or best.below is None or best.above is None or abs(best.below - best.above) < CLEAR:
        return ""
    low_is_better = best.below > best.above
    side, (good, bad) = ("up to" if low_is_better else "above"), sorted((best.below, best.above), reverse=True)
    return f"Of those with {best.column} {side} {shown(best.cut, best.unit)}, {share_text(good, 3)} do, of the others {share_text(bad, 3)}."


def _decides(answers: Answers) -> str:
    strong = [one for one in answers.effects if one.index_low > 0.0 and one.index >= MATTERS]
    rest = len(answers.effects) - len(strong)
    if not strong:
        return f"No parameter decides the {answers.title} alone: each explains {LITTLE}." if rest else ""
    named = listing([f"{one.column} ({share_text(one.index, 2)})" for one in strong])
    others = "The other one explains" if rest == 1 else f"Each of the other {rest} explains"
    tail = f" {others} {LITTLE}." if rest else ""
    twice = " They add up to more than 100 %, because some of them are correlated." if sum(one.index for one in strong) > 1.0 else ""
    what = f"What decides the {answers.title}, in order, with the share of its variance that each explains"
    return f"{what}: {named}.{twice}{tail}"


def _stop(answers: Answers) -> str:
    if not answers.is_sample:
        return f"A {answers.design} is no sample: more variants of it would not make these numbers surer."
    sentences = []
    if answers.low is not None and answers.high is not None:
        half = figure((answers.high - answers.low) / 2.0, "%", 2)
        sentences.append(f"The yield is known to +-{half}; {_enough(answers.needed_for_yield, answers)}.")
    if answers.p95 is not None and answers.p95_low is not None and answers.p95_high is not None:
        error = (answers.p95_high - answers.p95_low) / 2.0
        known = f"The 95 % quantile, {shown(answers.p95, answers.unit)}, is known to +-{shown(error, answers.unit, 2)}"
        share = f" ({figure(error / answers.p95, '%', 2)})" if answers.p95 > 0.0 else ""
        sentences.append(f"{known}{share}; {_enough(answers.needed_for_p95, answers)}.")
    return " ".join(sentences)


def _enough(needed: int | None, answers: Answers) -> str:
    if needed is None:
        return "how many more it needs cannot be told"
    goal = f"+-{figure(GOAL, '%')}"
    if answers.pairings is not None:
        kinds = answers.pairings.kinds
        times = (needed / answers.judged) ** (1.0 / len(kinds))
        modules = " and ".join(f"{_about(times * kind.modules)} {kind.column.removesuffix('.module')} modules" for kind in kinds)
        return f"{goal} needs about {modules}" if times > 1.0 else f"that is enough for {goal}"
    if needed <= answers.judged:
        return f"{_about(needed)} variants are enough for {goal}"
    return f"{goal} needs about {_about(needed - answers.judged)} more variants"


def _about(count: float) -> str:
    """Return a count in two digits.

    >>> _about(22_400), _about(87)
    ('22,000', '87')
    """
    return f"{float(f'{count:.2g}'):,.0f}"


def _modules(answers: Answers) -> str:
    """Return under which choices the modules are judged, what they explain, and how few spoil the yield."""
    found = answers.pairings
    if found is None:
        return ""
    names = {kind.column: kind.column.removesuffix(".module") for kind in found.kinds}
    sentences, passing = [], share_text(found.share)
    if found.choices:
        choices = listing([f"{name} {value if isinstance(value, str) else number(value)}" for name, value in found.choices.items()])
        yields = f", with which {passing} of {found.judged:,} pairings pass" if found.share is not None else ""
        sentences.append(f"Modules are judged under the best choice, {choices}{yields}.")
    explained = listing([f"{names[kind.column]} ({share_text(kind.index, 2)})" for kind in found.kinds])
    rest = max(1.0 - sum(kind.index for kind in found.kinds), 0.0)
    pairing = f"; the pairing itself: {share_text(rest, 2)}" if len(found.kinds) > 1 else ""
    what = f"Share of the variance of the {answers.title} that the module explains, whatever its partners"
    sentences.append(f"{what}: {explained}{pairing}.")
    if found.share is not None and found.bad:
        goal = next((goal for goal in SORTED if found.share < goal), 1.0)
        bad = found.bad[: next((i for i, one in enumerate(found.bad, 1) if one.left >= goal), len(found.bad))]
        gone = {kind: sum(one.column == kind.column for one in bad) for kind in found.kinds}
        which = listing([f"{count} of {kind.modules:,} {names[kind.column]}" for kind, count in gone.items() if count])
        if bad[-1].left < goal:
            sentences.append(f"Even without the worst {len(bad)} modules the yield stays below {share_text(goal)}.")
        else:
            sentences.append(f"Without the worst modules, {which}, the yield rises from {passing} to {share_text(bad[-1].left)}.")
    return " ".join(sentences)


CELLS = 200
"""Most modules of a kind in a picture."""
MOST = 6
"""Most pictures."""
WITHIN, BEYOND = ("#0b3c6f", "#dbe9f6"), ("#fde3cf", "#8c1c13")
"""Colours up to the tolerance, and above it."""
EVEN = ((0.0, "#0b3c6f"), (0.5, "#f2f2f2"), (1.0, "#8c1c13"))


def matrices(answers: Answers, rows: Rows) -> Iterator[Heat]:
    """Yield a picture for each two kinds of modules, under the best choice, and for each kind and choice."""
    if answers.pairings is not None:
        kinds = list(rows.store.manifest.modules)
        choices = [name for name in answers.pairings.choices if len(np.unique(rows.column(name)[0])) <= FEW]
        best = best_choice(rows)[1]
        pairs = [(best, *pair) for pair in combinations(kinds, 2)] + [(rows, kind, name) for kind in kinds for name in choices]
        yield from (_matrix(answers, *pair) for pair in pairs[:MOST])


def _matrix(answers: Answers, rows: Rows, first: str, second: str) -> Heat:
    """Return the picture of two columns: the mean figure of the pairings in each cell; nothing where one of them diverged."""
    unit, factor = answers.display
    (x, x_names), (y, y_names) = (_order(rows, name) for name in (first, second))
    drawn = (x >= 0) & (y >= 0)
    size = len(x_names) * len(y_names)
    cell = y[drawn] * len(x_names) + x[drawn]
    with np.errstate(invalid="ignore"):
        count = np.bincount(cell, minlength=size)
        z = np.bincount(cell, rows.values[drawn] * factor, size) / count
    z[~np.isfinite(z)] = np.nan
    names = first.removesuffix(".module"), second.removesuffix(".module")
    caption = _caption(answers, rows, bool(count.max() > 1), (first, second))
    key = f"matrix-{names[0]}-{names[1]}".replace(".", "-")
    low, high, colours = _colours(z, None if answers.tolerance is None else answers.tolerance * factor)
    grid = z.reshape(len(y_names), len(x_names))
    return Heat(key, f"{names[0]} and {names[1]}", caption, *names, unit, tuple(x_names), tuple(y_names), grid, low, high, colours)


def _order(rows: Rows, name: str) -> tuple[Index, list[str]]:
    """Return the place of each row along an axis, -1 if it is not drawn, and the labels; modules in the order of their mean figure."""
    if name not in rows.store.manifest.modules:
        codes, labels = rows.column(name)
        kept, place = np.unique(codes, return_inverse=True)
        return place, [labels[int(code)] if labels else shown(float(code), rows.store.manifest.columns[name], 4) for code in kept]
    member, numbers = rows.members[name], np.unique(rows.table[name].to_numpy())
    order = np.lexsort((means_of(member, rows.values).mean, np.bincount(member, np.isinf(rows.values))))
    order = order[np.unique(np.linspace(0, len(order) - 1, CELLS).round().astype(int))]
    place = np.full(len(numbers), -1)
    place[order] = np.arange(len(order))
    return place[member], [str(number) for number in numbers[order]]


def _colours(z: Array, tolerance: float | None) -> tuple[float, float, tuple[tuple[float, str], ...]]:
    """Return the ends of the scale and its colours: blue up to the tolerance, red above it."""
    known = z[np.isfinite(z)]
    low, high = (float(known.min()), float(np.quantile(known, 0.995))) if known.size else (0.0, 1.0)
    if tolerance is None:
        return low, high, EVEN
    low, high = min(low, tolerance), max(high, tolerance * (1.0 + 1e-6))
    middle = (tolerance - low) / (high - low)
    return low, high, ((0.0, WITHIN[0]), (middle, WITHIN[1]), (middle, BEYOND[0]), (1.0, BEYOND[1]))


def _caption(answers: Answers, rows: Rows, is_mean: bool, names: tuple[str, str]) -> str:
    bound = "" if answers.tolerance is None else f" Blue: within {shown(answers.tolerance, 'm', 6)}; red: beyond."
    parts = [f"The {answers.title} of each pairing{', the mean over all else' if is_mean else ''}.{bound}"]
    parts.append("Modules are in the order of their mean, the best first; the ticks are their numbers.")
    if np.isinf(rows.values).any():
        parts.append("Dark: diverged.")
    if any(rows.store.manifest.modules.get(name, 0) > CELLS for name in names):
        parts.append(f"Of more than {CELLS} modules, {CELLS} are drawn, evenly along this order.")
    return " ".join(parts)


BARS, POINTS = 60, 2000
"""Bars of a histogram, and most points of a cloud."""
MOST_CURVES, WORTH_CURVES = 6, 0.02
"""Most curves of a distribution, and the least index of the column that divides it."""
TABLE_FRONT = 12
"""Most rows of the table of the Pareto front."""


def write_page(answers: Answers, rows: Rows, words: dict[str, str], file: Path) -> None:
    """Write the page.

    Raises
    ------
    OutputError
        If it cannot be written.
    """
    front = answers.front[:: max(-(-len(answers.front) // TABLE_FRONT), 1)]
    text = page_text(
        "sweep.html.j2",
        _picture_groups(answers, rows),
        title=answers.question or Path(answers.store).name,
        answers=answers,
        words={name: text.replace(" %", "\N{NO-BREAK SPACE}%") for name, text in words.items()},
        front=[[str(row["variant"]), *(shown(row[name], unit, 4) for name, unit in answers.objectives.items())] for row in front],
        titles=[title_of(name) for name in answers.objectives],
        next=as_typed(["contourlab", "sweep", "worst", answers.store]),
        study=rows.store.manifest.study,
        share=share_text,
        between=range_text,
        value=value_text,
        shown=shown,
    )
    write_text_atomic(file, text)


def _picture_groups(answers: Answers, rows: Rows) -> dict[str, list[Picture]]:
    """Return the pictures of the page by section."""
    return {
        "distribution": [_distribution(answers, rows)],
        "convergence": list(_convergence(answers)),
        "front": list(_fronts(answers, rows)),
        "modules": list(matrices(answers, rows)),
    }


def _distribution(answers: Answers, rows: Rows) -> Chart:
    """Return histogram and cumulative curve, divided by the column of few values that decides most."""
    (unit, factor), title, kind = answers.display, answers.title, answers.kind
    values = rows.values * factor
    ended = values[np.isfinite(values)]
    low, high = (float(ended.min()), float(np.quantile(ended, 0.999))) if ended.size else (0.0, 1.0)
    tolerance, within = None, ""
    if answers.tolerance is not None:
        tolerance, within = answers.tolerance * factor, f"within {shown(answers.tolerance, 'm', 6)}"
        low, high = min(low, 0.98 * tolerance), max(high, 1.02 * tolerance)
    edges = np.linspace(low, high if high > low else low + 1.0, BARS + 1)
    heights, sums = [], []
    parts = _parts(answers, rows)
    for i, (name, chosen) in enumerate(parts):
        part = values if chosen is None else values[chosen]
        counts, _ = np.histogram(part[np.isfinite(part)], edges)
        x, y = np.repeat(edges, 2), np.concatenate([[0.0], np.repeat(100.0 * counts / len(part), 2), [0.0]])
        below = np.count_nonzero(part < edges[0]) + np.concatenate([[0], np.cumsum(counts)])
        style = scheme_style(i, len(parts))
        heights.append(Curve(x, y, name, *style))
        sums.append(Curve(edges, 100.0 * below / len(part), name, *style))
    label, span = f"{title} [{unit}]", None if tolerance is None else (float(edges[0]), tolerance)
    beyond = np.count_nonzero(values > edges[-1])
    note = f" {beyond:,} {kind} lie beyond the right end." if beyond else ""
    caption = f"Above: share of the {kind} in each of {BARS} intervals. Below: share with at most this {title}.{note}"
    panels = (
        Panel(label, "share [%]", tuple(heights), span=span, span_label=within),
        Panel(label, "up to here [%]", tuple(sums), span=span, y_range=(0.0, 103.0)),
    )
    return Chart("distribution", f"Distribution of the {title}", caption, panels, panel_height=210)


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
    return [(f"all {answers.kind}", None)]


def _convergence(answers: Answers) -> Iterable[Chart]:
    """Return yield and quantile over the number of variants."""
    known = [one for one in answers.convergence if one.p95 is not None and one.p95_low is not None and one.p95_high is not None]
    if len(answers.convergence) < 2 or (answers.tolerance is None and len(known) < 2):
        return
    unit, factor = answers.display
    panels, kind = [], answers.kind
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
    return (Curve(x, y[:, 0], "estimate", colour, width=2.0), *(Curve(x, y[:, k], "95 % interval", colour, "dash", 1.0) for k in (1, 2)))


def _fronts(answers: Answers, rows: Rows) -> Iterator[Chart]:
    """Return a picture of the first objective over each other one; a point tells its variant."""
    if not answers.objectives:
        return
    n, kind = len(rows.values), answers.kind
    some = np.sort(np.random.default_rng(0).choice(n, min(n, POINTS), replace=False))
    cloud = {name: rows.column(name)[0][some] for name in ("variant", *answers.objectives)}
    front = {name: np.array([row[name] for row in answers.front], dtype=float) for name in cloud}
    clouds = ((kind, REFERENCE, 0.7, cloud), ("best compromises", scheme_style(0, 2)[0], 2.4, front))
    first, *others = ((name, *display(unit)) for name, unit in answers.objectives.items())
    thinned = f" {POINTS:,} of {n:,} are drawn." if n > POINTS else ""
    for other in others:
        labels = [f"{title_of(name)} [{unit}]" if unit else title_of(name) for name, unit, _ in (other, first)]
        curves = []
        for name, colour, width, of in clouds:
            numbers = np.asarray(of["variant"], dtype=np.int64)
            x, y = of[other[0]] * other[2], of[first[0]] * first[2]
            curves.append(Curve(x, y, name, colour, width=width, half=np.zeros(len(numbers)), numbers=numbers))
        panel = Panel(labels[0], labels[1], tuple(curves))
        title = f"{title_of(first[0])} and {title_of(other[0])}"
        caption = f"The least is best on both axes. Hover over a point to see the number of its variant.{thinned}"
        yield Chart(f"front-{other[0]}", title[0].upper() + title[1:], caption, (panel,), 380, loops=True)


SHOWN = 12
"""Most rows of a table on the terminal."""


@dataclass(frozen=True)
class SweepReport(Answer):
    """The answers of a store, and their page.

    Attributes
    ----------
    page : Path or None
        None before it is saved.
    answers : Answers
    judged : Rows
        What they are about.
    """

    page: Path | None
    answers: Answers
    judged: Rows = field(repr=False, metadata=HIDDEN)

    def _charts(self) -> Iterator[Chart]:
        yield _distribution(self.answers, self.judged)
        yield from _convergence(self.answers)

    def _pictures(self) -> Iterator[Picture]:
        yield from chain.from_iterable(_picture_groups(self.answers, self.judged).values())

    def _next(self, asked: Asked) -> Sequence[object]:
        """List the worst variants."""
        return ["sweep", "worst", *asked.inputs]

    @property
    def text(self) -> str:
        """Text for the terminal."""
        answers = self.answers
        words = {name: paragraphs([text]) if text else "" for name, text in said(answers).items()}
        first = (words["sentence"], words["modules"], _module_text(answers.pairings), _subset_text(answers))
        second = (words["decides"], _effect_text(answers.effects), words["front"], words["stop"])
        last = (paragraphs(map(str, answers.findings)), f"page: {self.page}" if self.page else "")
        return "\n\n".join(filter(None, (*first, *second, *last)))

    def save(self, file: str | Path | None = None) -> SweepReport:
        """Write the page.

        Parameters
        ----------
        file : str or Path, optional
            By default ``report.html`` in the store.

        Returns
        -------
        SweepReport
            With the name of its page.

        Raises
        ------
        OutputError
            If it cannot be written.
        """
        page = self.judged.store.home / "report.html" if file is None else Path(file)
        write_page(self.answers, self.judged, said(self.answers), page)
        return replace(self, page=page)


@question(Report)
def report(store: str | Path, *, settings: Report, session: Session = QUIET) -> SweepReport:
    """Answer the questions to a store: yield, distribution, what decides it, best compromises, when to stop.

    Parameters
    ----------
    store : str or Path
        A store.

    Returns
    -------
    SweepReport

    Raises
    ------
    ResultError
        If it is no store, or damaged.
    ParameterError
        If it has no such figure, or no variant that was judged.
    """
    rows = read_rows(read_store(store), settings.figure)
    return SweepReport(None, answers_of(rows), rows)


def _subset_text(answers: Answers) -> str:
    if not answers.subsets:
        return ""
    (unit, factor), judged = answers.display, answers.tolerance is not None
    yields = ("yield", "95 % interval") if judged else ()
    heads = ("value", answers.kind, *yields, f"median [{unit}]", f"p95 [{unit}]")
    rows = (
        (
            *(one.column, value_text(one), str(one.judged)),
            *((share_text(one.share), range_text(one.low, one.high)) if judged else ()),
            *(number(value * factor, 4) if value is not None else "-" for value in (one.median, one.p95)),
        )
        for one in answers.subsets
    )
    return Table([Column("column", left=True), *map(Column, heads)], keys=2, rows=rows).text()


def _effect_text(effects: tuple[Effect, ...]) -> str:
    if not effects:
        return ""
    interval, has_totals = "95 % interval", any(one.total is not None for one in effects)
    heads = ("explains", interval, *(("with others", interval) if has_totals else ()), "rank correlation", interval)
    rows = []
    for one in effects[:SHOWN]:
        signed = ["-", "-"]
        if one.correlation is not None and one.correlation_low is not None and one.correlation_high is not None:
            signed = [f"{one.correlation:+.2f}", f"{one.correlation_low:+.2f} to {one.correlation_high:+.2f}"]
        total = [share_text(one.total, 2), range_text(one.total_low, one.total_high, 2)] if has_totals else []
        rows.append((one.column, share_text(one.index, 2), range_text(one.index_low, one.index_high, 2), *total, *signed))
    more = f"\n{len(effects) - SHOWN} more on the page" if len(effects) > SHOWN else ""
    return Table([Column("parameter", left=True), *map(Column, heads)], rows=rows).text() + more


def _module_text(found: Pairings | None) -> str:
    """Return the modules to sort out."""
    if found is None or not found.bad:
        return ""
    heads = ("module", "pairings", "yield", "yield without it and those above")
    rows = (
        (one.column.removesuffix(".module"), str(one.module), str(one.judged), share_text(one.share), share_text(one.left))
        for one in found.bad[:SHOWN]
    )
    more = len(found.bad) - SHOWN
    return Table([Column("modules", left=True), *map(Column, heads)], rows=rows).text() + (f"\n{more} more in --json" if more > 0 else "")
