"""Answers of a store: yield, distribution, what decides it, when to stop, the best compromises."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from fnmatch import fnmatchcase
from functools import cached_property
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.extras import extra_module
from contourlab.features.sweep.query import JUDGED, check_figure, counts, wilson
from contourlab.features.sweep.statistics import (
    LEAST,
    Estimate,
    best_split,
    binned,
    convergence,
    first_order,
    pareto_front,
    quantile,
    rank_correlation,
    ranks,
    variants_needed,
)
from contourlab.features.sweep.store import Store
from contourlab.features.sweep.summary import remarks
from contourlab.findings import Finding
from contourlab.threads import in_threads

SAMPLES = ("random", "sobol", "latin-hypercube")
"""Designs that draw their variants."""
FEW = 12
"""Most values of a column whose subsets are listed."""
SHOWN_FRONT = 200
"""Most members of a Pareto front in the answers."""
GOAL = 0.01
"""Half width of an interval that is good enough to stop: of the yield, and of the quantile in relation to its value."""


@dataclass(frozen=True, eq=False)
class Rows:
    """The judged rows of a store.

    Attributes
    ----------
    store : Store
    figure : str
    table : pyarrow.Table
        Without refused variants.
    """

    store: Store
    figure: str
    table: Any = field(repr=False)

    @cached_property
    def values(self) -> Array:
        """The figure (n,); inf for a variant that diverged."""
        found, _ = self.column(self.figure)
        return np.where(np.isnan(found), np.inf, found)

    @property
    def tolerance(self) -> float | None:
        """Tolerance [m] of the figure, if it has one."""
        return self.store.manifest["tolerance"] if self.figure == JUDGED else None

    def first(self, shared: str) -> str:
        """Return the first column that an effect or subset is about."""
        return next(name for name in self.store.columns if name == shared or fnmatchcase(name, shared) or name in shared.split(", "))

    def column(self, name: str) -> tuple[Array, list[str]]:
        """Return a column (n,), nan where it is empty; of texts, their places in the list that comes with it."""
        column = self.table[name]
        if name in self._texts:
            coded = column.dictionary_encode().unify_dictionaries().combine_chunks()
            return coded.indices.to_numpy(zero_copy_only=False).astype(float), list(map(str, coded.dictionary.to_pylist()))
        return column.to_numpy().astype(float, copy=False), []

    @cached_property
    def _texts(self) -> set[str]:
        arrow = extra_module("pyarrow")
        return {name for name in self.store.columns if self.table.schema.field(name).type == arrow.string()}


def read_rows(store: Store, figure: str | None = None) -> Rows:
    """Read the columns of a store that the answers need.

    Parameters
    ----------
    store : Store
    figure : str, optional
        By default the largest part error, or else the first figure.

    Raises
    ------
    ParameterError
        If the store has no such figure, or no variant that was judged.
    """
    compute = extra_module("pyarrow.compute")
    chosen = figure or (JUDGED if JUDGED in store.figures else next(iter(store.figures)))
    check_figure(store, chosen)
    names = ["variant", *store.columns, *dict.fromkeys([chosen, *_objectives(store)]), "status"]
    table = store.dataset.to_table(columns=names)
    table = table.filter(compute.not_equal(table["status"], "refused")).drop_columns("status")
    if not table.num_rows:
        raise ParameterError("STORE", str(store.folder), "a store with variants that were judged")
    return Rows(store, chosen, table)


def _objectives(store: Store) -> list[str]:
    return [name for name in ("cycle_time", "command_energy") if name in store.figures]


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
        First-order index: share of the variance that the column explains alone, and its interval of 95 %; of the variants that ended.
    cut, below, above : float or None
        Value at which the yields up to it and above it differ most, and these yields.
    gain : float
        Part of the variance of passing that the cut explains.
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
    design : str
    variants, judged : int
        Variants of the study, and those in the store that were not refused.
    passed : int or None
    share, low, high : float or None
        Yield, and its Wilson interval of 95 %.
    median, p95, p95_low, p95_high : float or None
        Quantiles of the figure, and the interval of 95 % of the last; variants that diverged count as largest.
    subsets : tuple of Subset
    effects : tuple of Effect
        The largest index first.
    convergence : tuple of Estimate
    needed_for_yield, needed_for_p95 : int or None
        Variants that give intervals of half width 1 %, if the rest of the variants is like these.
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
    median: float | None
    p95: float | None
    p95_low: float | None
    p95_high: float | None
    subsets: tuple[Subset, ...]
    effects: tuple[Effect, ...]
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
        return self.design in SAMPLES


def answers_of(rows: Rows) -> Answers:
    """Compute the answers of a store."""
    store, values, tolerance = rows.store, rows.values, rows.tolerance
    n = len(values)
    passed = None if tolerance is None else int(np.count_nonzero(values <= tolerance))
    low, high = (None, None) if passed is None else wilson(passed, n)
    share = None if passed is None else passed / n
    tail = [_finite(value) for value in quantile(values, 0.95)] if n >= LEAST else [_finite(quantile(values, 0.95)[0]), None, None]
    drawn = store.manifest["design"] in SAMPLES
    objectives, front = _front(rows)
    thinned = front[np.unique(np.linspace(0, len(front) - 1, SHOWN_FRONT).astype(int))] if len(front) else front
    return Answers(
        store=str(store.folder),
        question=_question(store.manifest["study"]),
        figure=rows.figure,
        unit=store.figures[rows.figure],
        tolerance=tolerance,
        design=store.manifest["design"],
        variants=store.variants,
        judged=n,
        passed=passed,
        share=share,
        low=low,
        high=high,
        median=_finite(quantile(values, 0.5)[0]),
        p95=tail[0],
        p95_low=tail[1],
        p95_high=tail[2],
        subsets=_subsets(rows),
        effects=_effects(rows),
        convergence=convergence(values, tolerance) if drawn else (),
        needed_for_yield=None if share is None or not drawn else variants_needed(share, GOAL),
        needed_for_p95=_needed(n, *tail) if drawn else None,
        objectives=objectives,
        front_size=len(front),
        front=tuple(rows.table.take(thinned).to_pylist()) if len(front) else (),
        findings=remarks(store, counts(store)),
    )


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _question(study: str) -> str:
    first = study.lstrip().partition("\n")[0].strip()
    return first.lstrip("# ") if first.startswith("#") else ""


def _needed(n: int, found: float | None, low: float | None, high: float | None) -> int | None:
    """Return the variants for a quantile within `GOAL` of its value; its interval shrinks with the root of their number."""
    if found is None or low is None or high is None or found <= 0.0:
        return None
    return max(LEAST, math.ceil(n * ((high - low) / 2.0 / (GOAL * found)) ** 2))


def _subsets(rows: Rows) -> tuple[Subset, ...]:
    """Return the subsets of each column with few values; columns that vary together count once."""
    found: dict[bytes, tuple[list[Subset], list[str]]] = {}
    for name, unit in rows.store.columns.items():
        codes, labels = rows.column(name)
        if len(np.unique(codes[: 1 << 12])) > FEW:
            continue
        kept, place = np.unique(codes, return_inverse=True)
        if not 1 < len(kept) <= FEW:
            continue
        names = [labels[int(code)] if labels else float(code) for code in kept]
        listed = sorted((value, i) for i, value in enumerate(names) if value == value)  # nan: the column is empty there
        made = [_subset(name, unit, value, rows.values[place == i], rows.tolerance) for value, i in listed]
        found.setdefault(hashlib.sha256(place.tobytes()).digest(), (made, []))[1].append(name)
    return tuple(replace(one, column=common(names)) for made, names in found.values() for one in made)


def _subset(name: str, unit: str, value: str | float, values: Array, tolerance: float | None) -> Subset:
    n = len(values)
    middle, tail = _finite(quantile(values, 0.5)[0]), _finite(quantile(values, 0.95)[0])
    if tolerance is None:
        return Subset(name, unit, value, n, None, None, None, None, middle, tail)
    passed = int(np.count_nonzero(values <= tolerance))
    return Subset(name, unit, value, n, passed, passed / n, *wilson(passed, n), middle, tail)


def _effects(rows: Rows) -> tuple[Effect, ...]:
    """Return the effects of all columns that vary; those that vary together are one."""
    values, order = rows.values, ranks(rows.values)
    made: dict[bytes, tuple[Effect, list[str]]] = {}

    def effect(name: str) -> tuple[bytes, Effect] | None:
        x, labels = rows.column(name)
        known = np.isfinite(x)
        whole = bool(known.all())
        x, y, rank_y = (x, values, order) if whole else (x[known], values[known], ranks(values[known]))
        ended = np.isfinite(y)
        if len(x) < 2 or x.min() == x.max() or np.count_nonzero(ended) < 2:
            return None
        rank = ranks(x)
        bins = binned(rank)
        found = Effect(name, rows.store.columns[name], None, None, None, *first_order(bins[ended], y[ended]))
        if not labels:
            middle, low, high = rank_correlation(rank, rank_y)
            found = replace(found, correlation=middle, correlation_low=low, correlation_high=high)
        if rows.tolerance is not None and not labels:
            last, below, above, gain = best_split(bins, y <= rows.tolerance)
            if gain:
                found = replace(found, cut=float(x[bins == last].max()), below=below, above=above, gain=gain)
        return hashlib.sha256(rank.tobytes() + known.tobytes()).digest(), found

    for one in in_threads(effect, rows.store.columns):
        if one is not None:
            made.setdefault(one[0], (one[1], []))[1].append(one[1].column)
    effects = [replace(found, column=common(names)) for found, names in made.values()]
    return tuple(sorted(effects, key=lambda one: -one.index))


def common(names: Sequence[str]) -> str:
    """Return one name for columns that vary together.

    >>> common(["axes.x.drive.delay", "axes.y.drive.delay"])
    'axes.*.drive.delay'
    """
    words = [name.split(".") for name in names]
    if len(set(map(len, words))) > 1:
        return ", ".join(names)
    return ".".join(place[0] if len(set(place)) == 1 else "*" for place in zip(*words, strict=True))


def _front(rows: Rows) -> tuple[dict[str, str], Any]:
    """Return the objectives that vary, and the rows of their Pareto front."""
    names = list(dict.fromkeys([rows.figure, *_objectives(rows.store)]))
    columns = {name: rows.column(name)[0] for name in names}
    ended = np.flatnonzero(np.isfinite(np.sum(list(columns.values()), axis=0)))
    columns = {name: column[ended] for name, column in columns.items() if len(ended) and np.ptp(column[ended]) > 0.0}
    if len(columns) < 2:
        return {}, np.zeros(0, dtype=np.int64)
    front = pareto_front(np.column_stack(list(columns.values())))
    return {name: rows.store.figures[name] for name in columns}, ended[front]
