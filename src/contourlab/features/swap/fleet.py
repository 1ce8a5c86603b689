"""All variants under candidates of a controller, run in lanes; it remembers the best that was ever found for each variant."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.design import Evaluator, Space
from contourlab.design.guards import Bounds
from contourlab.errors import ParameterError
from contourlab.features.swap.guard import Guard, holds
from contourlab.features.swap.variants import Variant
from contourlab.feed import Reference
from contourlab.loop import Controller

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
OBJECTIVES = {"contour_error_integral": ("m*s", 2e-6), "contour_error_rms": ("m", 1e-6), "contour_error_max": ("m", 1e-6)}
"""Figures that can be made small: their unit, and J_tol. The integral's is a mean of 1 um over a lap of 2 s."""
BROKEN = 1e6
"""Losses that count for a design that breaks a guard, or whose run failed: above any that keeps them."""


@dataclass(eq=False)
class Fleet:
    """Variants of a machine, and what a controller of theirs is worth.

    Attributes
    ----------
    variants : tuple of Variant
    controller : Controller
    reference : Reference
    space : Space
        Numbers of the controller that are moved; its points are run with values as files have them, so that what is written is what was
        judged.
    objective : str
        Of `OBJECTIVES`.
    floor : float [SI]
        J_tol.
    bounds : Bounds
    moving : bool
        As of `contourlab.design.Evaluator`, as are `seed` and `threads`.
    progress : callable, optional
        Told how many candidates were looked at so far, those that broke a margin and were not run included.
    best : ndarray (n_variant,)
        J* so far; infinite where nothing has held yet.
    best_points : ndarray (n_variant, n_number)
    """

    variants: tuple[Variant, ...]
    controller: Controller
    reference: Reference
    space: Space
    objective: str = "contour_error_integral"
    floor: float = 2e-6
    bounds: Bounds = field(default_factory=Bounds)
    moving: bool = False
    seed: int = 0
    threads: int | None = None
    progress: Callable[[int], None] | None = None
    best: Array = field(init=False)
    best_points: Array = field(init=False)
    tried: int = field(init=False, default=0)

    def __post_init__(self) -> None:
        if self.objective not in OBJECTIVES:
            raise ParameterError("objective", repr(self.objective), "one of " + ", ".join(OBJECTIVES))
        if not self.floor > 0.0:
            raise ParameterError("floor", f"{self.floor:g}", "> 0", OBJECTIVES[self.objective][0])
        outside = [name for name in self.space.names if not name.startswith("controller.")]
        if outside:
            raise ParameterError("parameters", outside[0], "a number of the controller: the machine's own are what the variants differ in")
        self.space = replace(self.space, written=True)
        self.evaluators = tuple(
            Evaluator(v.machine, self.controller, self.reference, moving=self.moving, seed=self.seed, threads=self.threads)
            for v in self.variants
        )
        self.keepers = tuple(Guard(v.machine, self.controller, self.bounds) for v in self.variants)
        self.best = np.full(self.n_variant, np.inf)
        self.best_points = np.tile(self.space.start, (self.n_variant, 1))

    @property
    def n_variant(self) -> int:
        """How many variants there are."""
        return len(self.variants)

    @property
    def runs(self) -> int:
        """Runs that were made so far."""
        return sum(evaluator.runs for evaluator in self.evaluators)

    def values(self, points: Array, only: Sequence[int] | None = None, *, whole: bool = False) -> tuple[Array, Array]:
        """Return J and by how much a guard is broken (0 where none is) of points for each variant.

        Parameters
        ----------
        points : ndarray (n_variant, n, n_number)
            Of the variants in `only`, or of all.
        only : sequence of int, optional
        whole : bool
            Whether points that break a margin are run, too: a search has no use for their J.

        Returns
        -------
        values, broken : ndarray (n_variant, n)
            J is infinite where the run failed, or was not made.
        """
        which = range(self.n_variant) if only is None else only
        known: dict[tuple[object, ...], Array] = {}
        columns = [self.space.columns(mine) for mine in points]
        excess = [np.broadcast_to(self.keepers[i].excess(mine, known), len(points[0])) for mine, i in zip(columns, which, strict=True)]
        run = [np.full(len(over), True) if whole else over < 0.0 for over in excess]
        figures = self._figures(which, [{name: column[r] for name, column in mine.items()} for mine, r in zip(columns, run, strict=True)])
        both = [self._judged(*one) for one in zip(which, points, excess, run, figures, strict=True)]
        self.tried += sum(map(len, points))
        if self.progress is not None:
            self.progress(self.tried)
        return np.array([values for values, _ in both]), np.array([broken for _, broken in both])

    def _figures(self, which: Sequence[int], columns: Sequence[dict[str, Array]]) -> list[dict[str, Array]]:
        """Return the figures of runs for each variant, variants side by side: one alone leaves processors idle, as it has few lanes."""
        threads = self.threads or os.cpu_count() or 1
        sides = min(threads, len(which))

        def figures(at: int, mine: int) -> dict[str, Array]:
            return self.evaluators[which[at]](columns[at], threads=mine) if next(iter(columns[at].values())).size else {}

        # A machine's first runs compile its components, one after another.
        if sides < 2 or any(self.evaluators[i].runs == 0 for i in which):
            return [figures(at, threads) for at in range(len(which))]
        with ThreadPoolExecutor(sides) as pool:
            return list(pool.map(figures, range(len(which)), [-(-threads // sides)] * len(which)))

    def _judged(self, i: int, points: Array, excess: Array, run: Mask, figures: dict[str, Array]) -> tuple[Array, Array]:
        """Return J, and by how much a guard is broken, of points whose runs were made; remember the best."""
        values, limited = np.full(len(points), np.inf), np.zeros(len(points))
        if figures:
            found = figures[self.objective]
            values[run] = np.where(np.isfinite(found), found, np.inf)
            limited[run] = np.nan_to_num(self.keepers[i].limited(figures), nan=1.0)
        good = holds(excess, limited) & np.isfinite(values)
        self._remember(i, points, np.where(good, values, np.inf))
        # What runs away is worse than what breaks a margin, and that than a drive at its limit.
        failed = 10.0 * (run & ~np.isfinite(values))
        return values, np.where(good, 0.0, np.clip(excess, 0.0, 10.0) + np.maximum(limited, 0.0) + failed + 1e-9)

    def _remember(self, i: int, points: Array, values: Array) -> None:
        at = int(np.argmin(values))
        if values[at] < self.best[i]:
            self.best[i], self.best_points[i] = values[at], points[at]

    def own(self, i: int) -> Callable[[Array], Array]:
        """Return what is made small to find J* of a variant: J over J_tol, of points (n, n_number)."""

        def objective(points: Array) -> Array:
            values, broken = self.values(points[None], (i,))
            return np.asarray(np.where(broken[0] > 0.0, BROKEN * (1.0 + broken[0]), values[0] / self.floor))

        return objective
