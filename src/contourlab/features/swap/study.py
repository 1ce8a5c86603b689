"""The study of a swap: each variant's optimum, the shared design, and the smallest set of local parameters that is modular."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ContourlabError
from contourlab.features.swap.search import Design, Optimum, SwapSearch, SwapSettings
from contourlab.features.swap.variants import Variants
from contourlab.findings import Finding, finding
from contourlab.study.checkpoint import Checkpoint

SCATTER = 0.01
"""By how much the losses of two searches differ that have ended."""


class NoDesignError(ContourlabError):
    """No design of a variant keeps the guards."""


@dataclass(frozen=True, eq=False)
class SwapStudy:
    """The result of a study.

    Attributes
    ----------
    variants : Variants
        Holds J* and the designs that reached it.
    settings : SwapSettings
    optima : tuple of Optimum
        Result of the searches for each variant alone.
    given : Design
        The scenario's own parameters on all variants.
    choices : tuple of Design
        The first has nothing local; one with all candidates local is last.
    crossed : ndarray (n_variant, n_variant)
        J of the best design of variant i on variant j; infinite where it breaks a guard.
    given_breaks : tuple of str
        Variants on which the scenario's own parameters break a guard.
    uncertainty : float or None
        By how much the loss of the shared design may still change; known from a quick study only.
    """

    variants: Variants
    settings: SwapSettings
    optima: tuple[Optimum, ...]
    given: Design
    choices: tuple[Design, ...]
    crossed: Array
    given_breaks: tuple[str, ...] = ()
    uncertainty: float | None = None

    @property
    def base(self) -> Design:
        """The shared design, nothing local."""
        return self.choices[0]

    @property
    def shortfalls(self) -> Array:
        """Loss of the best search for each variant alone against J* (n_variant,)."""
        return self.variants.losses(np.array([optimum.reached for optimum in self.optima]))

    @property
    def inconclusive(self) -> tuple[str, ...]:
        """Variants whose J* may be lower still: no search for the variant alone came within the loss limit of J*."""
        return tuple(name for name, lost in zip(self.variants.names, self.shortfalls, strict=True) if not lost < self.settings.full)

    @property
    def full(self) -> bool:
        """Whether one controller serves all variants."""
        return self.base.swap_loss < self.settings.full

    @property
    def recommended(self) -> Design | None:
        """The modular choice with the fewest local parameters; None if there is none."""
        good = [choice for choice in self.choices if choice.swap_loss < self.settings.full]
        return min(good, key=lambda choice: (len(choice.local), choice.swap_loss), default=None)

    @property
    def shown(self) -> Design:
        """The recommended design, or the shared one if none is recommended."""
        return self.recommended or self.base

    @property
    def unsure(self) -> bool:
        """Whether the limit lies within the uncertainty of a quick study."""
        return self.uncertainty is not None and not abs(self.base.swap_loss - self.settings.full) > self.uncertainty

    @property
    def verdict(self) -> Finding:
        """The verdict on the swap, without a network."""
        shared, limit, best = self.base.swap_loss, self.settings.full, self.recommended
        if self.unsure:
            return finding("CL704", loss=shared, uncertainty=self.uncertainty, limit=limit)
        if best is None:
            least = min(self.choices, key=lambda choice: choice.swap_loss)
            return finding("CL702", loss=least.swap_loss, names=least.name, limit=limit)
        if self.inconclusive:
            gap = float(self.shortfalls.max())
            ended = f"ended {100.0 * gap:.3g} % above the best value known"
            ended = ended if math.isfinite(gap) else "found no design that keeps the margins"
            return finding("CL703", names=self.inconclusive, ended=ended, loss=shared, limit=limit)
        if self.full:
            return finding("CL700", loss=shared, limit=limit)
        return finding("CL701", names=best.name, loss=best.swap_loss, shared=shared, limit=limit)


def swap_study(
    variants: Variants,
    candidates: tuple[str, ...],
    settings: SwapSettings,
    stage: Callable[[str, int], None] = lambda name, most: None,
    checkpoint: Checkpoint | None = None,
) -> SwapStudy:
    """Find out whether one controller serves all variants, and if not, which parameters must be local.

    J* of each variant comes from a restarted search for that variant alone. Each set of local parameters has one restarted search of the
    shared design. It starts from the best known designs: the variants' optima and designs with other sets. Backward elimination drops the
    least important local parameter. Any search that finds a better value for a variant updates its J*. A loss below the limit is modular.

    Parameters
    ----------
    variants : Variants
    candidates : tuple of str
        Parameters of the swapped axes that may be local.
    settings : SwapSettings
    stage : callable
        Called before each search with its name and its largest number of runs.
    checkpoint : Checkpoint, optional
        Stores finished searches.

    Raises
    ------
    NoDesignError
        If no design of a variant keeps the guards.
    """
    search = SwapSearch(variants, settings, stage, checkpoint)
    uncertainty, start = None, variants.everywhere(variants.space.start)
    values, broken = variants.values(start[:, None], whole=True)
    for points in search.known:
        variants.values(points[:, None])
    if settings.quick:
        uncertainty = _search_quickly(search, candidates)
    else:
        search.optima = [search.variant_optimum(i) for i in range(len(variants))]
    for name, best in zip(variants.names, variants.best, strict=True):
        if not math.isfinite(best):
            raise NoDesignError(f"{name}: no design within the bounds keeps the guards: ask for smaller margins, or give wider bounds")
    if not settings.quick:
        _search_sets(search, candidates)
        search.search_set(())
        _settle(search)
    # Nothing local first, everything local last.
    sets = sorted(search.designs, key=lambda local: (len(local) == len(candidates) and len(local) > 0, len(local) > 0))
    return SwapStudy(
        variants,
        settings,
        tuple(search.optima),
        Design(variants, frozenset(), start, values[:, 0], "as given"),
        tuple(search.designs[local] for local in sets),
        np.array([variants.kept(variants.everywhere(point)[:, None])[:, 0] for point in variants.best_points]),
        tuple(name for name, worst in zip(variants.names, broken[:, 0], strict=True) if worst > 0.0),
        uncertainty,
    )


def _search_sets(search: SwapSearch, candidates: tuple[str, ...]) -> None:
    """Search the requested sets, or all sets by size up to the first size that suffices, or by backward elimination."""
    if search.settings.local is not None:
        for given in search.settings.local:
            search.search_set(given)
    elif search.settings.exhaustive:
        search.search_set(())
        for size in range(1, len(candidates)):
            if search.fewest() is not None:
                break
            for names in combinations(candidates, size):
                search.search_set(names)
        search.search_set(candidates)
    elif candidates:
        search.backward_elimination(candidates)


def _search_quickly(search: SwapSearch, candidates: tuple[str, ...]) -> float:
    """Search twice from the beginning, keep the better, and find local parameters if the shared design is not enough.

    Return the uncertainty of its loss: `SCATTER`, and the largest of the distances of either search's own loss from that of both together,
    and of what the searches for one variant alone miss of J*.
    """
    variants, settings = search.variants, search.settings
    best, best_points = variants.best, variants.best_points
    alone, points, designs, own = [], [], [], []
    for _ in range(2):
        variants.best, variants.best_points = best.copy(), best_points.copy()
        search.designs.clear()
        alone.append(search.all_optima())
        design = search.search_set(())
        designs.append(design)
        points.append(variants.best_points)
        own.append(design.swap_loss)
    for one in points:
        variants.values(one[:, None])
    search.optima = [Optimum(float(values.min()), values) for values in np.transpose(alone)]
    design = search.designs[design.local] = min(designs, key=lambda design: design.swap_loss)
    loss = design.swap_loss
    short = variants.losses(np.min(alone, axis=0))
    uncertainty: float = SCATTER + max(*short.tolist(), *(abs(one - loss) if one != loss else 0.0 for one in own))  # both may be infinite
    if loss > settings.full + uncertainty and candidates:
        # The budget of one search serves all sets: they start from designs that are nearly optimal.
        search.settings = replace(settings, budget=max(settings.budget // len(settings.local or candidates), 1))
        _search_sets(search, candidates)
    search.propagate_best()
    return uncertainty


def _settle(search: SwapSearch) -> None:
    """Re-run the single-variant searches that another design has beaten, then refine the recommended design against the new J*."""
    search.propagate_best()
    variants, beaten = search.variants, search.variants.losses(np.array([optimum.value for optimum in search.optima]))
    for i in range(len(variants)):
        if not beaten[i] <= 0.0:
            search.optima[i] = replace(search.optima[i], again=search.variant_optimum(i, again=True).value)
    recommended = search.fewest()
    if recommended is not None:
        search.search_set(recommended.local)
    search.propagate_best()
