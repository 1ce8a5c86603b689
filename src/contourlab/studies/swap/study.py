"""The study of a swap: each variant's own optimum, the shared design, and the smallest set of local numbers that restores modularity."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from contourlab.studies.swap.design import Design, Own, best_of_its_own, evaluated, shared, starts_around
from contourlab.studies.swap.fleet import Fleet
from contourlab.studies.swap.loss import FULL, losses, swap_loss
from contourlab.studies.swap.sensitivity import Ranked, groups_of, ranked

__all__ = ["BASE", "GROWN", "SHARED", "Choice", "SwapSettings", "SwapStudy", "swap_study", "words"]

Array = NDArray[np.float64]
STARTS = 5
BASE, GROWN = 2.0, 0.5
"""Budget of the shared design, which has to please all variants, and of each set that is tried on the way, over that of a variant's own."""
ALL = "all of the axis"
SHARED = "shared design"
AGAIN = 0.1
"""First step of the second search of the shared design."""
Stage = Callable[[str], None]
Known = tuple[Mapping[str, float], ...]


@dataclass(frozen=True)
class SwapSettings:
    """How thorough the study is.

    Attributes
    ----------
    budget : int
        Candidates of each search; a shared one is run on all variants.
    seed : int
    full : float
        Largest swap loss that counts as full modularity.
    exhaustive : bool
        Whether all sets of local numbers are tried in the order of their size, in place of growing one.
    largest : int, optional
        Size up to which a set grows; by default until only one number is left.
    local : tuple of frozenset of str, or None
        Sets of local numbers to look at in place of searching for one.
    known : tuple of Known
        Designs from elsewhere that every search starts from too: for each variant its values [SI] by dotted names, or once for all; what is
        not given stays as it is.
    """

    budget: int = 8000
    seed: int = 0
    full: float = FULL
    exhaustive: bool = False
    largest: int | None = None
    local: tuple[frozenset[str], ...] | None = None
    known: tuple[Known, ...] = ()


@dataclass(frozen=True, eq=False)
class Choice:
    """A choice of local numbers and what it leaves.

    Attributes
    ----------
    name : str
        In words.
    design : Design
    losses : ndarray (n_variant,)
    """

    name: str
    design: Design
    losses: Array

    @property
    def loss(self) -> float:
        """The swap loss."""
        return float(self.losses.max())

    @property
    def effort(self) -> int:
        """How many numbers are local."""
        return len(self.design.local)


@dataclass(frozen=True, eq=False)
class SwapStudy:
    """What a study of a swap found.

    Attributes
    ----------
    fleet : Fleet
        With J* and where it was found.
    settings : SwapSettings
    owns : tuple of Own
        What the searches for each variant alone came to; J* may be better, as it counts every search.
    given : Choice
        The scenario's own numbers on all variants.
    choices : tuple of Choice
        The first has nothing local, the last all that may be; between them in the order in which they were tried.
    crossed : ndarray (n_variant, n_variant)
        J of the design that gave J* of variant i, run on variant j; infinite where it breaks a guard there.
    ranking : tuple of Ranked
    given_breaks : tuple of str
        Variants on which the scenario's own numbers break a guard.
    """

    fleet: Fleet
    settings: SwapSettings
    owns: tuple[Own, ...]
    given: Choice
    choices: tuple[Choice, ...]
    crossed: Array
    ranking: tuple[Ranked, ...] = ()
    given_breaks: tuple[str, ...] = ()

    @property
    def base(self) -> Choice:
        """Nothing local."""
        return self.choices[0]

    @property
    def full(self) -> bool:
        """Whether one controller serves all variants."""
        return self.base.loss < self.settings.full

    @property
    def recommended(self) -> Choice | None:
        """The choice with the fewest local numbers that is modular; None where none is."""
        good = [choice for choice in self.choices if choice.loss < self.settings.full]
        return min(good, key=lambda choice: (choice.effort, choice.loss), default=None)


@dataclass(eq=False)
class _Search:
    """The state of a study while it goes on."""

    fleet: Fleet
    settings: SwapSettings
    stage: Stage
    designs: list[tuple[str, Design]] = field(default_factory=list)

    @property
    def known(self) -> Array:
        """Designs from elsewhere (n, n_variant, n_number)."""
        space, n = self.fleet.space, self.fleet.n_variant
        found = [np.vstack([space.points(values) for values in design]) for design in self.settings.known]
        return np.array([np.broadcast_to(points, (n, len(space.numbers))) for points in found]).reshape(-1, n, len(space.numbers))

    def own(self) -> tuple[Own, ...]:
        fleet, settings = self.fleet, self.settings
        found = []
        for i, variant in enumerate(fleet.variants):
            self.stage(f"best of {variant.name}")
            starts = np.vstack([self.known[:, i], starts_around(fleet.space.start, STARTS, settings.seed)])[:STARTS]
            found.append(best_of_its_own(fleet, i, budget=settings.budget, seed=settings.seed + i, starts=starts))
        return tuple(found)

    def starts(self, local: frozenset[str]) -> list[Array]:
        """Designs to start from: the best with fewer local numbers, each variant's own for all, and those with each its own local part."""
        fleet, n = self.fleet, self.fleet.n_variant
        fewer = [design for _, design in self.designs if design.local <= local and design.holds]
        fewer.sort(key=lambda design: swap_loss(design.values, fleet.best, fleet.floor))
        mine = np.array([name in local for name in fleet.space.names])
        found = [design.points for design in fewer[:1]] or [*self.known, np.tile(fleet.space.start, (n, 1))]
        if local:
            found += list(self.known)
        found += [np.where(mine, fleet.best_points, point) for point in fleet.best_points[: STARTS - 1]]
        if len(found) < STARTS:
            found.append(fleet.best_points)  # base numbers: the average of the variants' own
        extra = starts_around(fleet.space.start, STARTS + 1, self.settings.seed + 1)
        found += [np.tile(point, (n, 1)) for point in extra[1 : STARTS - len(found) + 1]]
        return found

    def look(self, name: str, local: Iterable[str], *, share: float = 1.0) -> float:
        """Search one choice; return its loss as J* stands."""
        chosen = frozenset(local)
        done = next((design for _, design in self.designs if design.local == chosen), None)
        if done is None:
            self.stage(f"local: {name}" if chosen else SHARED)
            budget = max(int(share * self.settings.budget), 1)
            done = shared(self.fleet, chosen, self.starts(chosen), budget=budget, seed=self.settings.seed + 10 * len(self.designs) + 5)
            self.designs.append((name, done))
        return self.loss(done)

    def again(self) -> None:
        """Search the shared design once more, from the average of what designs with local numbers came to: one that stuck is no verdict."""
        name, before = self.designs[0]
        others = sorted((design for _, design in self.designs[1:] if design.local and design.holds), key=self.loss)
        if not others:
            return
        self.stage(f"{SHARED}, once more")
        starts = [before.points, *(design.points for design in others[:4])]
        more = shared(self.fleet, frozenset(), starts, budget=self.settings.budget, seed=self.settings.seed + 4, spread=AGAIN)
        better = more if self.loss(more) < self.loss(before) else before
        self.designs[0] = (name, replace(better, per_start=before.per_start, runs=before.runs + more.runs))

    def loss(self, design: Design) -> float:
        """Return the loss of a choice as J* stands: that of the best design that has no more local numbers."""
        fewer = [design, *(one for _, one in self.designs if one.local < design.local)]
        return min(swap_loss(one.values, self.fleet.best, self.fleet.floor) for one in fewer)

    def good(self, loss: float) -> bool:
        return loss < self.settings.full

    def choices(self) -> tuple[Choice, ...]:
        """Return what was looked at, each with the best design that it allows: more local numbers never lose more."""
        fleet, found = self.fleet, []
        for name, design in self.designs:
            allowed = [one for _, one in self.designs if one.local <= design.local]
            best = min(allowed, key=lambda one: swap_loss(one.values, fleet.best, fleet.floor))
            points = best.points
            merged = Design(design.local, points, best.values, design.per_start, design.runs)
            found.append(Choice(name, merged, losses(best.values, fleet.best, fleet.floor)))
        return tuple(found)


def swap_study(fleet: Fleet, candidates: tuple[str, ...], settings: SwapSettings, stage: Stage = lambda _: None) -> SwapStudy:
    """Find out whether one controller serves all variants, and if not, which numbers have to be local.

    Parameters
    ----------
    fleet : Fleet
    candidates : tuple of str
        Numbers of the swapped axes, all of which may be local.
    settings : SwapSettings
    stage : callable
        Told what is done next.

    Raises
    ------
    ParameterError
        If no design of a variant keeps the guards.
    """
    going = _Search(fleet, settings, stage)
    start = np.tile(fleet.space.start, (fleet.n_variant, 1))
    values, broken = fleet.values(start[:, None], whole=True)
    for points in going.known:
        fleet.values(points[:, None])
    owns = going.own()
    base = going.look("none", (), share=BASE)
    order: tuple[Ranked, ...] = ()
    if settings.local is not None:
        for names in settings.local:
            going.look(words(fleet, names), names)
    elif candidates:
        order = tuple(ranked(fleet, candidates))
        if not going.good(base):
            _restore(going, candidates, [one.name for one in order])
        going.look(ALL, candidates, share=1.0 if len(going.designs) == 1 else GROWN)
    if not going.good(going.loss(going.designs[0][1])):
        going.again()
    stage("each design on each variant")
    crossed = np.array([evaluated(fleet, frozenset(), np.tile(point, (fleet.n_variant, 1))).values for point in fleet.best_points])
    given = Choice("as given", Design(frozenset(), start, values[:, 0], np.zeros(0), 1), losses(values[:, 0], fleet.best, fleet.floor))
    choices = sorted(going.choices(), key=lambda choice: (choice.effort == len(candidates) and choice.effort > 0, choice.effort > 0))
    breaks = tuple(variant.name for variant, worst in zip(fleet.variants, broken[:, 0], strict=True) if worst > 0.0)
    return SwapStudy(fleet, settings, owns, given, tuple(choices), crossed, order, breaks)


def words(fleet: Fleet, names: Iterable[str]) -> str:
    """Return names as people say them, in the order of the space."""
    wanted = set(names)
    return ", ".join(number.short for number in fleet.space.numbers if number.name in wanted) or "none"


def _restore(going: _Search, candidates: tuple[str, ...], order: list[str]) -> None:
    """Look for the smallest set of local numbers that restores modularity: all of them by size, or one that grows."""
    if going.settings.exhaustive:
        for size in range(1, len(candidates)):
            found = [going.look(words(going.fleet, names), names) for names in combinations(order, size)]
            if any(going.good(loss) for loss in found):
                return
        return
    for names in _growing(going, order):
        if going.good(going.look(words(going.fleet, names), names, share=GROWN)):
            return


def _growing(going: _Search, order: list[str]) -> Iterator[frozenset[str]]:
    """Yield sets to try: single numbers, then groups of the structure, then the best so far with one number more, each in its rank."""
    groups = groups_of(going.fleet, tuple(order))
    held: frozenset[str] = frozenset()
    largest = going.settings.largest
    while len(held) < (len(order) - 1 if largest is None else min(largest, len(order) - 1)):
        size = len(held) + 1
        yield from (held | {name} for name in order if name not in held)
        if largest is None or size < largest:
            yield from (names for names in groups.values() if len(names) == size + 1)
        tried = [design for _, design in going.designs if len(design.local) == size]
        held = min(tried, key=going.loss).local
