"""The search of a swap: the optimum of each variant, and shared designs for sets of local parameters."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import ClassVar

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import ParameterError
from contourlab.features.swap.variants import BROKEN, Variant, Variants, losses
from contourlab.study import Found, Space
from contourlab.study.checkpoint import Checkpoint
from contourlab.study.search import restarted
from contourlab.threads import in_threads

WarmStart = tuple[Mapping[str, float], ...]
"""A given design: values [SI] by dotted names, for each variant or one for all."""
STARTS = 5
"""Points from which a search starts."""
ALONE, SHARED = 0.2, 0.1
"""First step of a search as a share of the box: for one variant, and for a shared design, which starts near known ones."""
EVENNESS = 0.01
"""Weight of the mean loss relative to the largest: breaks ties between designs that are equal for the worst variant."""


@dataclass(frozen=True)
class SwapSettings:
    """Settings of a study.

    Attributes
    ----------
    budget : int
        Candidates of each search; a candidate of a shared design runs on all variants.
    seed : int
    full : float
        Full modularity requires a swap loss below this limit.
    exhaustive : bool
        Whether to try all sets of local parameters by size, instead of backward elimination.
    local : tuple of frozenset of str, optional
        The only sets to test.
    known : tuple of WarmStart
        Additional starts of every search. Missing parameters keep the scenario's values.
    quick : bool
        Whether each search starts from the best known design only, and the searches for one variant run side by side.
    """

    budget: int = 8000
    seed: int = 0
    full: float = 0.03
    exhaustive: bool = False
    local: tuple[frozenset[str], ...] | None = None
    known: tuple[WarmStart, ...] = ()
    quick: bool = False


# --- designs -----------------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Optimum:
    """Result of the search for one variant alone; J* may be lower, because it covers every search.

    Attributes
    ----------
    value : float
        J; infinite if no candidate keeps the guards.
    per_start : ndarray (n_start,)
        J from each start before the restarts.
    again : float
        J of a second, independent search; nan if none was needed.
    """

    value: float
    per_start: Array
    again: float = math.nan

    @property
    def reached(self) -> float:
        """The smaller J of the two searches for the variant alone."""
        return float(np.fmin(self.value, self.again))


@dataclass(frozen=True, eq=False)
class Design:
    """A shared design.

    Attributes
    ----------
    variants : Variants
    local : frozenset of str
        Parameters, by dotted name, with a value for each module; all others are base.
    points : ndarray (n_variant, n_parameter)
        The point of each variant.
    values : ndarray (n_variant,) [SI]
        J of each variant; infinite where a guard is broken.
    called : str
        Its name, if it is not that of its local parameters.
    """

    variants: Variants = field(repr=False)
    local: frozenset[str]
    points: Array
    values: Array
    called: str = ""

    json_form: ClassVar = {name: name for name in ("name", "local", "values", "losses", "parameters", "swap_loss")}

    @property
    def name(self) -> str:
        """Short names of the local parameters, in the order of the space."""
        return self.called or ", ".join(self.variants.short(self.local)) or "none"

    @property
    def losses(self) -> Array:
        """The loss of each variant (n_variant,), against the present J*."""
        return self.variants.losses(self.values)

    @property
    def parameters(self) -> tuple[dict[str, float], ...]:
        """Values [SI] by dotted names, for each variant."""
        return tuple(self.variants.space.values(point) for point in self.points)

    @property
    def swap_loss(self) -> float:
        """The largest loss."""
        return float(self.losses.max())

    @property
    def holds(self) -> bool:
        """Whether it keeps the guards on all variants."""
        return bool(np.isfinite(self.values).all())


@dataclass(frozen=True)
class SharedSpace:
    """The search space of a shared design: base parameters once, local ones once for each module.

    Attributes
    ----------
    space : Space
    variants : sequence of Variant
    local : frozenset of str
        Dotted names of parameters of swapped axes.

    Raises
    ------
    ParameterError
        If a local name is unknown, or its axis is not swapped.
    """

    space: Space
    variants: Sequence[Variant]
    local: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        for name in sorted(self.local):
            if name not in self.space.names or not self.variants[0].module(name):
                raise ParameterError("local", name, "a calibrated parameter of a swapped axis; those of other axes are base")

    @cached_property
    def _columns(self) -> Index:
        """Column in a row of each parameter of each variant (n_variant, n_parameter)."""
        known: dict[tuple[str, str], int] = {}
        return np.array(
            [
                [known.setdefault((name, variant.module(name) if name in self.local else ""), len(known)) for name in self.space.names]
                for variant in self.variants
            ]
        )

    @property
    def size(self) -> int:
        """Length of a row."""
        return int(self._columns.max()) + 1

    def spread(self, rows: Array) -> Array:
        """Return the points (n_variant, n, n_parameter) of rows (n, size)."""
        return np.stack([rows[:, columns] for columns in self._columns])

    def gathered(self, points: Array) -> Array:
        """Return the row (size,) of one point per variant (n_variant, n_parameter); average a shared parameter whose values differ."""
        flat, low, high = self._columns.ravel(), np.full(self.size, np.inf), np.full(self.size, -np.inf)
        np.minimum.at(low, flat, points.ravel())
        np.maximum.at(high, flat, points.ravel())
        return np.where(low == high, low, np.bincount(flat, points.ravel()) / np.bincount(flat))


def merged(points: Array, columns: Flags) -> list[Array]:
    """Return copies of the points in which some parameters are equal: average, averages weighted to one variant, one variant's values.

    Parameters
    ----------
    points : ndarray (n_variant, n_parameter)
    columns : ndarray (n_parameter,) of bool
    """
    n = len(points)
    even = np.full(n, 1.0 / n)
    weights = (even, *(0.5 * (even + alone) for alone in np.eye(n)), *np.eye(n))
    return [np.where(columns, weight @ points, points) for weight in weights]


# --- the search --------------------------------------------------------------------------------------------------------------------------


@dataclass(eq=False)
class SwapSearch:
    """The searches of a study and their results so far.

    Attributes
    ----------
    variants : Variants
        Holds J* so far; any search that finds a better value updates it.
    settings : SwapSettings
    stage : callable
        Called before each search with its name and its largest number of runs.
    checkpoint : Checkpoint, optional
        Stores finished searches.
    optima : list of Optimum
        Optimum of each variant alone.
    designs : dict
        The best shared design found for each set of local parameters.
    """

    variants: Variants
    settings: SwapSettings
    stage: Callable[[str, int], None] = lambda name, most: None
    checkpoint: Checkpoint | None = None
    optima: list[Optimum] = field(default_factory=list)
    designs: dict[frozenset[str], Design] = field(default_factory=dict)
    searches: int = 0

    def variant_optimum(self, i: int, *, again: bool = False) -> Optimum:
        """Search the best design of variant `i` alone; `again` starts around J* but not at it, to confirm it independently."""
        variants, settings = self.variants, self.settings
        centre = variants.best_points[i] if again else variants.space.start
        seed = settings.seed + i + (100 if again else 0)
        around = centre + 0.15 * np.random.default_rng([seed, STARTS]).standard_normal((STARTS - 1, centre.size))
        given = [] if again else [variants.space.start, *(points[i] for points in self.known)]
        starts = np.clip(np.vstack([*given, around]), 0.0, 1.0)[: max(STARTS, len(given))]

        def made(budget: int) -> dict[str, Array]:
            found = restarted(variants.objective_of(i), starts, budget, seed)
            return {"values": variants.in_si(np.append(found.per_start, found.value))}

        name = f"{variants.names[i]} alone{', again' if again else ''}"
        values = self._searched(name, settings.budget, 1, made)["values"]
        return Optimum(float(values[-1]), values[:-1])

    def all_optima(self) -> Array:
        """Search the best design of each variant, all at once; return its J (n_variant,)."""
        variants, seed = self.variants, self.settings.seed + 10 * self.searches

        def made(budget: int) -> dict[str, Array]:
            def alone(i: int) -> Found:
                return restarted(variants.objective_of(i), variants.best_points[i][None], budget, seed + i, SHARED, quick=True)

            found = in_threads(alone, range(len(variants)), variants.threads)
            return {"values": variants.in_si(np.array([one.value for one in found]))}

        return self._searched("each variant alone", self.settings.budget, len(variants), made)["values"]

    def search_set(self, local: Iterable[str], target: float = -math.inf) -> Design:
        """Search the shared design for a set of local parameters; keep and return the best.

        The search starts from the best design derived from known ones, from the variants' optima, and from the scenario's own parameters.
        With nothing local, it has twice the budget: one design must suit all variants. It ends early once the loss is below `target`.
        """
        variants, chosen = self.variants, frozenset(local)
        shared = SharedSpace(variants.space, variants.members, chosen)
        best = variants.best.copy()  # fixed, so that all candidates of a generation are ranked against the same J*

        def objective(rows: Array) -> Array:
            values, broken = variants.values(shared.spread(rows))
            lost = losses(np.where(np.isfinite(values), values, 0.0).T, best, variants.floor)
            whole = (lost.max(axis=1) + EVENNESS * lost.mean(axis=1)) / (1.0 + EVENNESS)
            return np.asarray(np.where((broken > 0.0).any(axis=0), BROKEN * (1.0 + broken.sum(axis=0)), whole))

        def made(budget: int) -> dict[str, Array]:
            optima, own = variants.best_points, np.array([name in chosen for name in variants.space.names])
            starts = [self.inherit_best(chosen).points, *(np.where(own, optima, point) for point in optima[: STARTS - 3]), optima]
            rows = np.array([shared.gathered(start) for start in (*starts, variants.everywhere(variants.space.start))])
            quick, seed = self.settings.quick, self.settings.seed + 10 * self.searches + 5
            found = restarted(objective, rows[:1] if quick else rows, budget, seed, SHARED, target, quick=quick)
            points = shared.spread(found.point[None])
            return {"points": points[:, 0], "values": variants.kept(points)[:, 0]}

        name = f"local: {', '.join(variants.short(chosen)) or 'none'}"
        arrays = self._searched(name, self.settings.budget * (1 if chosen else 2), len(variants), made)
        design = Design(variants, chosen, arrays["points"], arrays["values"])
        known = self.designs.setdefault(chosen, design)
        if design.swap_loss < known.swap_loss:
            self.designs[chosen] = design
        return self.designs[chosen]

    def inherit_best(self, local: frozenset[str]) -> Design:
        """Return the best design for a set of local parameters among those derived from all known designs."""
        fitting = self._fitting(local)
        values = self.variants.kept(fitting)
        at = int(np.argmin(self.variants.losses(values.T).max(axis=1)))
        return Design(self.variants, local, fitting[:, at], values[:, at])

    def propagate_best(self) -> None:
        """Replace the design of each set of local parameters wherever one derived from another set is better."""
        changed = True
        while changed:
            changed = False
            for local in sorted(self.designs, key=len):
                inherited = self.inherit_best(local)
                if inherited.swap_loss < self.designs[local].swap_loss:
                    self.designs[local], changed = inherited, True

    def backward_elimination(self, names: Iterable[str]) -> Design | None:
        """Drop local parameters one by one, the least important first, while the loss stays below the limit.

        Start with all of `names` local. Keep the last one: without it the design is the shared one, which has its own search. Return
        the design with the fewest local parameters, or None if all of them together do not suffice. A parameter that could not be
        dropped is not tried again: with fewer local parameters it matters even more.
        """
        held = self.search_set(names)
        if not self.good(held):
            return None
        needed: set[str] = set()
        while len(held.local) > 1 and held.local - needed:
            name = min(sorted(held.local - needed), key=lambda name: self.inherit_best(held.local - {name}).swap_loss)
            tried = self.search_set(held.local - {name}, target=0.5 * self.settings.full)
            if self.good(tried):
                held = tried
            else:
                needed.add(name)
        return held

    @property
    def known(self) -> list[Array]:
        """The designs of `SwapSettings.known`, each (n_variant, n_parameter)."""
        space, n = self.variants.space, len(self.variants)
        rows = [np.vstack([space.points(values) for values in design]) for design in self.settings.known]
        return [np.broadcast_to(points, (n, len(space.names))) for points in rows]

    def _fitting(self, local: frozenset[str]) -> Array:
        """Return all known designs (n_variant, n, n_parameter), fitted to a set of local parameters: each other one has a single value."""
        variants, base = self.variants, np.array([name not in local for name in self.variants.space.names])
        tiled = [variants.everywhere(point) for point in (variants.space.start, *variants.best_points)]
        for points in (variants.best_points, *self.known, *(design.points for design in self.designs.values())):
            tiled += [points] if not np.ptp(points, axis=0)[base].any() else merged(points, base)
        shared = SharedSpace(variants.space, variants.members, local)
        return shared.spread(np.array([shared.gathered(points) for points in tiled]))

    def good(self, design: Design) -> bool:
        """Return whether the loss of a design is below the limit."""
        return design.swap_loss < self.settings.full

    def fewest(self) -> Design | None:
        """Return the good design with the fewest local parameters; None if there is none."""
        return min(filter(self.good, self.designs.values()), key=lambda design: (len(design.local), design.swap_loss), default=None)

    def _searched(self, name: str, budget: int, sides: int, make: Callable[[int], dict[str, Array]]) -> dict[str, Array]:
        """Run a search, or restore its result and the state of the variants from the checkpoint."""
        self.stage(name, budget * sides)
        self.searches += 1
        if self.checkpoint is None:
            return make(budget)
        state = (array.tobytes() for array in self.variants.state().values())
        file = self.checkpoint.path(f"{self.searches} {name} {budget}\n".encode(), *state)
        arrays = self.checkpoint.load(file)
        if arrays is None:
            arrays = make(budget)
            self.checkpoint.store(file, arrays | self.variants.state())
        else:
            self.variants.restore(arrays)
        return arrays
