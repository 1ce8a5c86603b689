"""Answers of a store: yield, distribution, subsets by value, effects of parameters, what modules decide in pairings, when to stop."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.features.sweep.query import Rows, counts, display, objectives, remarks
from contourlab.figures import grouped
from contourlab.findings import Finding
from contourlab.metrics.run_figures import title_of
from contourlab.study.design import DRAWN
from contourlab.study.statistics import (
    LEAST,
    Estimate,
    Z,
    best_split,
    binned,
    convergence,
    estimate,
    first_order,
    pareto_front,
    quantile,
    rank_correlation,
    ranks,
    share_of,
    total_indices,
    variants_needed,
)
from contourlab.threads import in_threads

FEW = 12
"""Most values of a column whose subsets are listed."""
Made = TypeVar("Made")
CHANCE = 15.0
"""Chi-square of the best of 63 cuts that chance exceeds in about 1 % of parameters without effect."""


@dataclass(frozen=True)
class Subset:
    """Variants with one value of a choice or parameter.

    Attributes
    ----------
    column : str
        With ``*`` where several columns vary together.
    unit : str
    value : str or float
    judged : int
    passed : int or None
        None without a tolerance.
    share, low, high : float or None
        Yield, and its Wilson interval of 95 %.
    median, p95 : float or None
        Of the figure; None where the variant there diverged.
    """

    column: str
    unit: str
    value: str | float
    judged: int
    passed: int | None
    share: float | None
    low: float | None
    high: float | None
    median: float | None
    p95: float | None


@dataclass(frozen=True)
class Effect:
    """What a choice or parameter does to the figure.

    Attributes
    ----------
    column : str
        With ``*`` where several columns vary together.
    unit : str
    correlation, correlation_low, correlation_high : float or None
        Rank correlation, and its interval of 95 %; None for texts. A variant that diverged has the largest rank.
    index, index_low, index_high : float
        First-order index: share of the variance that the column explains alone, and its interval of 95 %; of the variants that ended. Where
        the column is empty it explains nothing.
    cut, below, above : float or None
        Value at which the yields up to it and above it differ most, and these yields; None if chance may explain the difference.
    gain : float
        Part of the variance of passing that the cut explains.
    total, total_low, total_high : float or None
        Total index: share of the variance that needs the column, alone or with others, and its interval of 95 %; of a Saltelli design.
    """

    column: str
    unit: str
    correlation: float | None
    correlation_low: float | None
    correlation_high: float | None
    index: float
    index_low: float
    index_high: float
    cut: float | None = None
    below: float | None = None
    above: float | None = None
    gain: float = 0.0
    total: float | None = None
    total_low: float | None = None
    total_high: float | None = None


def finite(value: float) -> float | None:
    """Return a value; None if it is not finite."""
    return value if math.isfinite(value) else None


def subsets(rows: Rows) -> tuple[Subset, ...]:
    """Return the subsets of each column with few values; columns that vary together count once."""
    found: list[tuple[bytes, list[Subset], str]] = []
    for name, unit in {**dict.fromkeys(rows.store.manifest.modules, ""), **rows.store.manifest.columns}.items():
        codes, labels = rows.column(name)
        if len(np.unique(codes[: 1 << 12])) > FEW:
            continue
        kept, place = np.unique(codes, return_inverse=True)
        is_own = (kind := rows.kind(name)) is not None and len(kept) == rows.store.manifest.modules[kind]  # each module has its own value
        if not 1 < len(kept) <= FEW or is_own:
            continue
        names = [labels[int(code)] if labels else float(code) for code in kept]
        others = [member for kind, member in zip([*rows.members, ""], rows.clusters, strict=False) if kind != name]
        of_column = []
        for value, i in sorted((value, i) for i, value in enumerate(names) if value == value):  # nan: the column is empty there
            values = rows.values[place == i]
            tolerance, members = rows.tolerance, [member[place == i] for member in others]
            passing = (None, None, None, None) if tolerance is None else share_of(values <= tolerance, members)
            ends = (finite(quantile(values, share)[0]) for share in (0.5, 0.95))
            of_column.append(Subset(name, unit, value, len(values), *passing, *ends))
        found.append((hashlib.sha256(place.tobytes()).digest(), of_column, name))
    return tuple(replace(one, column=name) for of_column, name in _together(found) for one in of_column)


def _together(found: Iterable[tuple[bytes, Made, str]]) -> list[tuple[Made, str]]:
    """Return what was found of columns, once for those that vary together, which have the same key, with one name for them."""
    groups = grouped((key, (one, name)) for key, one, name in found).values()
    return [(group[0][0], common([name for _, name in group])) for group in groups]


@dataclass(frozen=True, eq=False)
class Means:
    """The figure for each module of a kind, over its pairings.

    Attributes
    ----------
    first : ndarray (n_module,)
        A row of each module.
    member : ndarray (n,)
        Module of each row, counted from 0 without gaps.
    mean, inner : ndarray (n_module,)
        Mean and variance of the pairings that ended; inf without one.
    pairings : ndarray (n_module,)
        Those that ended.
    """

    first: Index
    member: Index
    mean: Array
    inner: Array
    pairings: Array


def means_of(member: Index, values: Array) -> Means:
    """Return the mean of values (n,) for each module; inf for what diverged."""
    _, first, member = np.unique(member, return_index=True, return_inverse=True)
    ended, count = np.isfinite(values), len(first)
    there, known = member[ended], values[ended]
    n = np.bincount(there, minlength=count).astype(np.float64)
    mean = np.bincount(there, known, count) / np.maximum(n, 1.0)
    inner = np.bincount(there, (known - mean[there]) ** 2, count) / np.maximum(n, 1.0)
    return Means(first, member, np.where(n > 0, mean, np.inf), inner, n)


def effects(rows: Rows) -> tuple[Effect, ...]:
    """Return the effects of all columns that vary; those that vary together are one."""
    order = ranks(rows.values)
    found = [one for one in in_threads(lambda name: _effect(rows, name, order), rows.store.manifest.columns) if one is not None]
    totals = _totals(rows) if rows.store.manifest.group > 1 else {}
    named = [(replace(effect, column=name), totals.get(effect.column, (None, None, None))) for effect, name in _together(found)]
    whole = [replace(effect, total=total, total_low=low, total_high=high) for effect, (total, low, high) in named]
    return tuple(sorted(whole, key=lambda one: -one.index))


def _effect(rows: Rows, name: str, order: Array) -> tuple[bytes, Effect, str] | None:
    """Return the effect of a column, with a key for those that vary together; None if it does not vary.

    The parameters of modules are judged by the mean of each module over its pairings: a module counts once, however often it is paired.
    """
    x, labels = rows.column(name)
    known, kind = np.isfinite(x), rows.kind(name)
    is_whole = bool(known.all())
    x, y = (x, rows.values) if is_whole else (x[known], rows.values[known])
    rank_y = order if is_whole else ranks(y)
    passed = None if rows.tolerance is None or labels else y <= rows.tolerance
    units: list[Index] = []
    inner: Array | None = None
    row: Index | slice = slice(None)
    if kind is not None:
        means = means_of(rows.members[kind][known], y)
        rank_y = ranks(np.bincount(means.member, rank_y) / np.bincount(means.member))
        x, y, inner, row = x[means.first], means.mean, means.inner, means.member
    else:
        units = [member[known] for member in rows.clusters]
    ended = np.isfinite(y)
    if len(x) < 2 or x.min() == x.max() or np.count_nonzero(ended) < 2:
        return None
    rank = ranks(x)
    bins = binned(rank)
    there = first_order(bins[ended], y[ended], None if inner is None else inner[ended], [unit[ended] for unit in units])
    index = [share * rows.share_of_variance(known) for share in there]
    found = Effect(name, rows.store.manifest.columns[name], None, None, None, *index)
    independent = min([len(x), *(len(np.unique(unit)) for unit in units)])
    if not labels:
        middle, low, high = rank_correlation(rank, rank_y, independent)
        found = replace(found, correlation=middle, correlation_low=low, correlation_high=high)
    if passed is not None:
        last, below, above, gain = best_split(bins[row], passed)
        if gain * independent > CHANCE:
            found = replace(found, cut=float(x[bins == last].max()), below=below, above=above, gain=gain)
    return hashlib.sha256(f"{kind}".encode() + rank.tobytes() + known.tobytes()).digest(), found, name


def _totals(rows: Rows) -> dict[str, tuple[float, float, float]]:
    """Return the total index of each column, from the groups of a Saltelli design that ended as a whole."""
    size = rows.store.manifest.group
    group, which = np.divmod(rows.table["variant"].to_numpy(), size)

    def grouped(values: Array) -> Array:
        table = np.full((int(group.max()) + 1, size), np.nan)
        table[group, which] = values
        return table

    figure = grouped(rows.values)
    whole = np.isfinite(figure).all(axis=1)
    found: dict[str, tuple[float, float, float]] = {}
    if np.count_nonzero(whole) < 2:
        return found
    indices = total_indices(figure[whole])
    for name in rows.store.manifest.columns:
        x = grouped(rows.column(name)[0])[whole]
        changes = np.any(np.abs(x[:, 2:] - x[:, :1]) > 0.0, axis=0)  # nan, where a column is empty, is no change
        if changes.any():
            found[name] = indices[int(np.argmax(changes))]
    return found


def common(names: Sequence[str]) -> str:
    """Return one name for columns that vary together.

    >>> common(["axes.x.drive.delay", "axes.y.drive.delay"])
    'axes.*.drive.delay'
    """
    words = [name.split(".") for name in names]
    if len(set(map(len, words))) > 1:
        return ", ".join(names)
    return ".".join(place[0] if len(set(place)) == 1 else "*" for place in zip(*words, strict=True))


MOST_BAD = 200
"""Most modules to sort out."""


@dataclass(frozen=True)
class Kind:
    """The modules of one kind.

    Attributes
    ----------
    column : str
        Column of their numbers.
    modules : int
    index, index_low, index_high : float
        Share of the variance of the figure that the choice of the module explains alone, and its interval of 95 %.
    lowest, median : float or None
        Of the yields of the modules, each over its pairings; None without a tolerance.
    """

    column: str
    modules: int
    index: float
    index_low: float
    index_high: float
    lowest: float | None
    median: float | None


@dataclass(frozen=True)
class BadModule:
    """A module to sort out.

    Attributes
    ----------
    column : str
    module : int
    judged, passed : int
        Its pairings.
    share : float
        Its yield.
    left : float
        Yield of all pairings without this module and those before it.
    """

    column: str
    module: int
    judged: int
    passed: int
    share: float
    left: float


@dataclass(frozen=True)
class Pairings:
    """What the modules decide, under the best combination of the other choices.

    Attributes
    ----------
    choices : dict of str to str or float
        The combination with the highest yield, or else the lowest mean of the figure; empty if nothing else varies.
    judged, passed : int
        Its pairings; 0 passed without a tolerance.
    share, low, high : float or None
        Their yield and its interval of 95 %.
    kinds : tuple of Kind
    bad : tuple of BadModule
        Those that raise the yield, in the order in which they raise it most, up to a yield of 100 %, half of the modules of a kind, or 200.
    """

    choices: dict[str, Any]
    judged: int
    passed: int
    share: float | None
    low: float | None
    high: float | None
    kinds: tuple[Kind, ...]
    bad: tuple[BadModule, ...]


def best_choice(rows: Rows) -> tuple[dict[str, Any], Rows]:
    """Return the combination of all that belongs to no module with the highest yield or else the lowest mean, and its rows."""
    names = [name for name in rows.store.manifest.columns if rows.kind(name) is None]
    if not names:
        return {}, rows
    columns = [rows.column(name) for name in names]
    combos, place = np.unique(np.column_stack([codes for codes, _ in columns]), axis=0, return_inverse=True)
    place = place.reshape(-1)
    score = -rows.values if rows.tolerance is None else rows.values <= rows.tolerance
    best = int(np.argmax(np.bincount(place, score) / np.bincount(place)))
    values = [labels[int(code)] if labels else float(code) for (_, labels), code in zip(columns, combos[best], strict=True)]
    return dict(zip(names, values, strict=True)), rows.where(place == best)


def pairings_of(choices: dict[str, Any], rows: Rows) -> Pairings:
    """Return what the modules decide in some rows."""
    passed = None if rows.tolerance is None else rows.values <= rows.tolerance
    members = rows.members
    within, share, low, high = (0, None, None, None) if passed is None else share_of(passed, list(members.values()))
    kinds = tuple(_kind(name, member, rows.values, passed) for name, member in members.items())
    numbers = {name: np.unique(rows.table[name].to_numpy()) for name in members}
    bad = () if passed is None else tuple(_sorted_out(passed, members, numbers))
    return Pairings(choices, len(rows.values), within, share, low, high, kinds, bad)


def _kind(name: str, member: Index, values: Array, passed: Flags | None) -> Kind:
    ends: tuple[float | None, float | None] = None, None
    if passed is not None:
        yields = np.bincount(member, passed) / np.bincount(member)
        ends = float(yields.min()), float(np.median(yields))
    return Kind(name, int(member.max()) + 1, *_explained(member, values), *ends)


def _explained(member: Index, values: Array) -> tuple[float, float, float]:
    """Return the share of the variance between the modules, and its interval by a jackknife over them; of pairings that ended.

    Notes
    -----
    Analysis of variance with one random factor: what the mean of a module owes to its partners is taken off.
    """
    found = means_of(member, values)
    ended = (found.pairings > 1) & np.isfinite(found.mean)
    mean, pairings = found.mean[ended], found.pairings[ended]
    if len(mean) < 3:
        return 0.0, 0.0, 1.0
    inner = found.inner[ended] * pairings / (pairings - 1.0)
    mean = mean - mean.mean()

    def share(n: Any, sums: Any, squares: Any, within: Any, noise: Any) -> Any:
        between = np.maximum((squares - sums**2 / n) / (n - 1.0) - noise / n, 0.0)
        return between / np.maximum(between + within / n, np.finfo(float).tiny)

    terms = [np.ones_like(mean), mean, mean**2, inner, inner / pairings]
    sums = [term.sum() for term in terms]
    middle = float(share(*sums))
    without = share(*(total - term for total, term in zip(sums, terms, strict=True)))
    half = Z * math.sqrt((1.0 - 1.0 / len(mean)) * float(np.sum((without - without.mean()) ** 2)))
    return middle, max(middle - half, 0.0), min(middle + half, 1.0)


def _sorted_out(passed: Flags, members: dict[str, Index], numbers: dict[str, Index]) -> list[BadModule]:
    """Return the modules to sort out: always the one with the lowest yield with the modules that are left."""
    names, kinds = list(members), list(members.values())
    judged = [np.bincount(member) for member in kinds]
    good = [np.bincount(member, passed).astype(np.int64) for member in kinds]
    own = [(n.copy(), ok.copy()) for n, ok in zip(judged, good, strict=True)]
    rows = [np.split(np.argsort(member, kind="stable"), np.cumsum(n)[:-1]) for member, n in zip(kinds, judged, strict=True)]
    left = np.ones(len(passed), dtype=bool)
    total, ok, most = len(passed), int(np.count_nonzero(passed)), [len(n) // 2 for n in judged]
    found: list[BadModule] = []
    while ok < total and len(found) < MOST_BAD:
        yields = [np.where(n > 0, ok_there / np.maximum(n, 1), np.inf) for n, ok_there in zip(judged, good, strict=True)]
        kind = min(range(len(kinds)), key=lambda k: float(yields[k].min()))
        if not most[kind] or yields[kind].min() >= ok / total:  # then all modules are alike
            break
        most[kind] -= 1
        worst = int(np.argmin(yields[kind]))
        gone = rows[kind][worst][left[rows[kind][worst]]]
        left[gone] = False
        for member, n, ok_there in zip(kinds, judged, good, strict=True):
            n -= np.bincount(member[gone], minlength=len(n))
            ok_there -= np.bincount(member[gone], passed[gone], len(n)).astype(np.int64)
        total, ok = total - len(gone), ok - int(np.count_nonzero(passed[gone]))
        of, well = int(own[kind][0][worst]), int(own[kind][1][worst])
        found.append(BadModule(names[kind], int(numbers[names[kind]][worst]), of, well, well / of, ok / total if total else 1.0))
    return found


# --- all answers ---

SHOWN_FRONT = 200
"""Most members of a Pareto front in the answers."""
GOAL = 0.01
"""Half width of an interval that is good enough to stop: of the yield, and of the quantile in relation to its value."""


@dataclass(frozen=True)
class Answers:
    """Answers of a store.

    Attributes
    ----------
    store : str
    question : str
        First line of the study, if it is a comment.
    figure, unit : str
    tolerance : float [m] or None
        None of a search, which has no yield, effects or subsets.
    design : str
    variants, judged : int
        Variants of the study, and those in the store that were not refused.
    passed : int or None
    share, low, high : float or None
        Yield, and its Wilson interval of 95 %.
    smallest, median, p95, p95_low, p95_high : float or None
        Quantiles of the figure, and the interval of 95 % of the last; variants that diverged count as largest.
    subsets : tuple of Subset
    effects : tuple of Effect
        The largest index first.
    pairings : Pairings or None
        Of a study with modules.
    convergence : tuple of Estimate
    needed_for_yield, needed_for_p95 : int or None
        Variants that give intervals of half width 1 %, if the rest of the variants is like these; of a study with modules, with more of
        each kind.
    objectives : mapping of str to str
        Figures of the Pareto front, with their units; empty if fewer than two vary.
    front_size : int
    front : tuple of dict
        Members of the front, the most accurate first; at most 200, evenly spaced.
    findings : tuple of Finding
    """

    store: str
    question: str
    figure: str
    unit: str
    tolerance: float | None
    design: str
    variants: int
    judged: int
    passed: int | None
    share: float | None
    low: float | None
    high: float | None
    smallest: float | None
    median: float | None
    p95: float | None
    p95_low: float | None
    p95_high: float | None
    subsets: tuple[Subset, ...]
    effects: tuple[Effect, ...]
    pairings: Pairings | None
    convergence: tuple[Estimate, ...]
    needed_for_yield: int | None
    needed_for_p95: int | None
    objectives: dict[str, str]
    front_size: int
    front: tuple[dict[str, Any], ...]
    findings: tuple[Finding, ...]

    @property
    def is_sample(self) -> bool:
        """Whether the variants are drawn, so that more of them would tell more."""
        return self.design in DRAWN

    @property
    def title(self) -> str:
        """The figure in words."""
        return title_of(self.figure)

    @property
    def display(self) -> tuple[str, float]:
        """Display unit of the figure, and the factor from SI."""
        return display(self.unit)

    @property
    def kind(self) -> str:
        """What the variants are: pairings of modules, or machines, if only these vary."""
        if self.pairings is not None:
            return "pairings"
        return "machines" if self.effects and all(one.column.startswith("axes.") for one in self.effects) else "variants"


def answers_of(rows: Rows) -> Answers:
    """Compute the answers of a store."""
    store, values, tolerance, members = rows.store, rows.values, rows.tolerance, rows.clusters
    about, found = store.manifest, estimate(values, tolerance, members)
    is_drawn, is_search = about.design in DRAWN, about.design == "search"
    needed = _needed(found, len(members)) if is_drawn else (None, None)
    names, front = _front(rows)
    thinned = front[np.unique(np.linspace(0, len(front) - 1, SHOWN_FRONT).astype(int))] if len(front) else front
    first = about.study.lstrip().partition("\n")[0].strip()
    return Answers(
        store=str(store.home),
        question=first.lstrip("# ") if first.startswith("#") else "",
        figure=rows.figure,
        unit=about.figures[rows.figure],
        tolerance=tolerance,
        design=about.design,
        variants=about.variants,
        judged=len(values),
        passed=None if tolerance is None else int(np.count_nonzero(values <= tolerance)),
        share=found.share,
        low=found.share_low,
        high=found.share_high,
        smallest=finite(float(values.min())),
        median=finite(quantile(values, 0.5)[0]),
        p95=found.p95,
        p95_low=found.p95_low,
        p95_high=found.p95_high,
        subsets=() if is_search else subsets(rows),
        effects=() if is_search else effects(rows),
        pairings=pairings_of(*best_choice(rows)) if rows.members else None,
        convergence=convergence(values, tolerance, members) if is_drawn else (),
        needed_for_yield=needed[0],
        needed_for_p95=needed[1],
        objectives=names,
        front_size=len(front),
        front=tuple(rows.table.take(thinned).to_pylist()) if len(front) else (),
        findings=remarks(store, counts(store)),
    )


def _needed(found: Estimate, kinds: int) -> tuple[int | None, int | None]:
    """Return the variants whose intervals of the yield and the quantile have the half width `GOAL`; None where that is not known.

    That of the quantile is in relation to its value. An interval shrinks with the root of the number of variants; of modules, the variance
    of the yield shrinks with the number of each kind.
    """
    of_yield, of_p95 = None, None
    if found.share is not None and found.share_low is not None and found.share_high is not None:
        half = (found.share_high - found.share_low) / 2.0
        of_yield = math.ceil(found.variants * (half / GOAL) ** (2 * kinds)) if kinds else variants_needed(found.share, GOAL)
    if found.p95 is not None and found.p95_low is not None and found.p95_high is not None and found.p95 > 0.0:
        ratio = (found.p95_high - found.p95_low) / 2.0 / (GOAL * found.p95)
        of_p95 = max(LEAST, math.ceil(found.variants * ratio ** (2 * max(kinds, 1))))
    return of_yield, of_p95


def _front(rows: Rows) -> tuple[dict[str, str], Any]:
    """Return the objectives that vary, and the rows of their Pareto front."""
    names = list(dict.fromkeys([rows.figure, *objectives(rows.store)]))
    columns = {name: rows.column(name)[0] for name in names}
    ended = np.flatnonzero(np.isfinite(np.sum(list(columns.values()), axis=0)))
    columns = {name: column[ended] for name, column in columns.items() if len(ended) and np.ptp(column[ended]) > 0.0}
    if len(columns) < 2:
        return {}, np.zeros(0, dtype=np.int64)
    front = pareto_front(np.column_stack(list(columns.values())))
    return {name: rows.store.manifest.figures[name] for name in columns}, ended[front]
