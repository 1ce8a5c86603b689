"""Answers of a store: yield, distribution, what decides it, when to stop, the best compromises."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.features.sweep.effects import Effect, Pairings, Subset, best_choice, effects, finite, pairings_of, subsets
from contourlab.features.sweep.query import Rows, counts, objectives
from contourlab.features.sweep.summary import remarks
from contourlab.findings import Finding
from contourlab.study.design import DRAWN
from contourlab.study.statistics import LEAST, Estimate, convergence, estimate, pareto_front, quantile, variants_needed

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


def answers_of(rows: Rows) -> Answers:
    """Compute the answers of a store."""
    store, values, tolerance = rows.store, rows.values, rows.tolerance
    n, members = len(values), rows.clusters
    found = estimate(values, tolerance, members)
    design = store.manifest.design
    drawn, is_search = design in DRAWN, design == "search"
    names, front = _front(rows)
    thinned = front[np.unique(np.linspace(0, len(front) - 1, SHOWN_FRONT).astype(int))] if len(front) else front
    return Answers(
        store=str(store.home),
        question=_question(store.manifest.study),
        figure=rows.figure,
        unit=store.manifest.figures[rows.figure],
        tolerance=tolerance,
        design=design,
        variants=store.manifest.variants,
        judged=n,
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
        convergence=convergence(values, tolerance, members) if drawn else (),
        needed_for_yield=_needed_for_yield(found, len(members)) if drawn else None,
        needed_for_p95=_needed_for_p95(found, len(members)) if drawn else None,
        objectives=names,
        front_size=len(front),
        front=tuple(rows.table.take(thinned).to_pylist()) if len(front) else (),
        findings=remarks(store, counts(store)),
    )


def _question(study: str) -> str:
    first = study.lstrip().partition("\n")[0].strip()
    return first.lstrip("# ") if first.startswith("#") else ""


def _needed_for_yield(found: Estimate, kinds: int) -> int | None:
    """Return the variants whose interval of the yield has the half width `GOAL`; of modules, its variance shrinks with their number."""
    if found.share is None or found.share_low is None or found.share_high is None:
        return None
    if not kinds:
        return variants_needed(found.share, GOAL)
    return math.ceil(found.variants * ((found.share_high - found.share_low) / 2.0 / GOAL) ** (2 * kinds))


def _needed_for_p95(found: Estimate, kinds: int) -> int | None:
    """Return the variants for a quantile within `GOAL` of its value; its interval shrinks with the root of their number."""
    if found.p95 is None or found.p95_low is None or found.p95_high is None or found.p95 <= 0.0:
        return None
    ratio = (found.p95_high - found.p95_low) / 2.0 / (GOAL * found.p95)
    return max(LEAST, math.ceil(found.variants * ratio ** (2 * max(kinds, 1))))


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
