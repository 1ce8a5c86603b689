"""Populations of modules in pairings: what the modules of each kind decide, and which to sort out."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.features.sweep.effects import means_of
from contourlab.features.sweep.rows import Rows
from contourlab.study.statistics import Z, share_of

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
    names = [name for name in rows.store.columns if rows.kind(name) is None]
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
    yields = None if passed is None else np.bincount(member, passed) / np.bincount(member)
    ends = (None, None) if yields is None else (float(yields.min()), float(np.median(yields)))
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


def enough(bad: Sequence[BadModule], share: float) -> int:
    """Return how many modules must be sorted out for a yield, at most all that are listed."""
    return next((i for i, one in enumerate(bad, 1) if one.left >= share), len(bad))
