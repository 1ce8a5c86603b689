"""What the values of a column do to the figure: subsets by value, and effects of parameters."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.features.sweep.rows import Rows
from contourlab.study.statistics import best_split, binned, first_order, quantile, rank_correlation, ranks, share_of, total_indices
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
    for name, unit in {**dict.fromkeys(rows.store.modules, ""), **rows.store.columns}.items():
        codes, labels = rows.column(name)
        if len(np.unique(codes[: 1 << 12])) > FEW:
            continue
        kept, place = np.unique(codes, return_inverse=True)
        is_own = (kind := rows.kind(name)) is not None and len(kept) == rows.store.modules[kind]  # each module has its own value
        if not 1 < len(kept) <= FEW or is_own:
            continue
        names = [labels[int(code)] if labels else float(code) for code in kept]
        listed = sorted((value, i) for i, value in enumerate(names) if value == value)  # nan: the column is empty there
        made = [_subset(name, unit, value, rows, place == i) for value, i in listed]
        found.append((hashlib.sha256(place.tobytes()).digest(), made, name))
    return tuple(replace(one, column=name) for made, name in _together(found) for one in made)


def _subset(name: str, unit: str, value: str | float, rows: Rows, chosen: Flags) -> Subset:
    values = rows.values[chosen]
    middle, tail = finite(quantile(values, 0.5)[0]), finite(quantile(values, 0.95)[0])
    if rows.tolerance is None:
        return Subset(name, unit, value, len(values), None, None, None, None, middle, tail)
    members = [member[chosen] for kind, member in zip([*rows.members, ""], rows.clusters, strict=False) if kind != name]
    return Subset(name, unit, value, len(values), *share_of(values <= rows.tolerance, members), middle, tail)


def _together(found: Iterable[tuple[bytes, Made, str]]) -> list[tuple[Made, str]]:
    """Return what was found of columns, once for those that vary together, which have the same key, with one name for them."""
    made: dict[bytes, tuple[Made, list[str]]] = {}
    for key, one, name in found:
        made.setdefault(key, (one, []))[1].append(name)
    return [(one, common(names)) for one, names in made.values()]


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
    found = (one for one in in_threads(lambda name: _effect(rows, name, order), rows.store.columns) if one is not None)
    totals = _totals(rows) if rows.store.manifest["group"] > 1 else {}
    made = []
    for effect, name in _together(found):
        total, low, high = totals.get(effect.column, (None, None, None))
        made.append(replace(effect, column=name, total=total, total_low=low, total_high=high))
    return tuple(sorted(made, key=lambda one: -one.index))


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
    found = Effect(name, rows.store.columns[name], None, None, None, *index)
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
    size = rows.store.manifest["group"]
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
    for name in rows.store.columns:
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
