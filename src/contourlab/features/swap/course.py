"""A study of a swap while it goes on: what was searched so far, and where the next search starts from."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.design.guards import ROUNDING
from contourlab.features.swap.design import Choice, Design, shared, within
from contourlab.features.swap.fleet import Fleet
from contourlab.features.swap.kept import Kept, Result
from contourlab.features.swap.loss import losses, swap_loss
from contourlab.features.swap.own import Own, afresh, best_of_its_own, on_from, shortfalls, starts_around
from contourlab.features.swap.settings import SwapSettings

Array = NDArray[np.float64]
STARTS = 5
BASE, TRIAL = 2.0, 0.5
"""Budget of the shared design, which has to please all variants, and of each set that is tried on the way, over that of a variant's own."""
ENOUGH = 0.9
"""Part of the limit at which a set that is tried on the way is good enough: J* may fall yet."""
ALL = "all of the axis"
SHARED = "shared design"
AGAIN = 0.1
"""First step of the second search of the shared design."""
MERGED = 4
"""Designs with local numbers from which that one starts."""
ON = 0.25
"""Budget of a search on for one variant alone from where a shared design stands, over that of its own."""
SLIGHT = 0.1
"""Part of the limit from which J* is searched on once more."""
Stage = Callable[[str, int], None]
"""Told what is done next, and how many candidates of variants it takes at most."""


@dataclass(eq=False)
class Course:
    """The state of a study while it goes on.

    Attributes
    ----------
    fleet : Fleet
    settings : SwapSettings
    stage : Stage
    kept : Kept, optional
        Where searches are kept, and looked for; nowhere by default.
    designs : list of (str, Design)
        What was looked at, with its name, each set of local numbers once.
    """

    fleet: Fleet
    settings: SwapSettings
    stage: Stage
    kept: Kept | None = None
    designs: list[tuple[str, Design]] = field(default_factory=list)

    @property
    def known(self) -> Array:
        """Designs from elsewhere (n, n_variant, n_number)."""
        space, n = self.fleet.space, self.fleet.n_variant
        found = [np.vstack([space.points(values) for values in design]) for design in self.settings.known]
        return np.array([np.broadcast_to(points, (n, len(space.numbers))) for points in found]).reshape(-1, n, len(space.numbers))

    def _searched(self, said: str, candidates: float, kind: type[Result], make: Callable[[int], Result]) -> Result:
        """Return what a search of so many candidates comes to, which may be kept."""
        budget = max(int(candidates), 1)
        self.stage(said, budget * (self.fleet.n_variant if kind is Design else 1))
        if self.kept is None:
            return make(budget)
        return self.kept.search(self.fleet, said, kind, lambda: make(budget))

    def own(self) -> tuple[Own, ...]:
        """Search the best design of each variant alone."""
        fleet, settings, found = self.fleet, self.settings, []
        for i, variant in enumerate(fleet.variants):
            starts = np.vstack([self.known[:, i], starts_around(fleet.space.start, STARTS, settings.seed)])[:STARTS]

            def make(budget: int, i: int = i, starts: Array = starts) -> Own:
                return best_of_its_own(fleet, i, budget=budget, seed=settings.seed + i, starts=starts)

            found.append(self._searched(f"best of {variant.name}", settings.budget, Own, make))
        return tuple(found)

    def on(self, owns: Sequence[Own], turn: int) -> tuple[Own, ...]:
        """Search on for each variant alone whose searches a shared design has passed, or whose J* still falls."""
        short, found = shortfalls(self.fleet, owns, by_themselves=False), list(owns)
        for i, variant in enumerate(self.fleet.variants):
            if short[i] > (SLIGHT * self.settings.full if turn else ROUNDING):

                def make(budget: int, i: int = i) -> Own:
                    return on_from(self.fleet, i, owns[i], budget=budget, seed=self.settings.seed + i + 20 * (turn + 1))

                found[i] = self._searched(f"{variant.name} alone, from the best so far", ON * self.settings.budget, Own, make)
        return tuple(found)

    def afresh(self, owns: Sequence[Own]) -> tuple[Own, ...]:
        """Search once more for each variant alone whose own search ended farther above J* than a swap may lose."""
        short, found = shortfalls(self.fleet, owns, by_themselves=True), list(owns)
        for i, variant in enumerate(self.fleet.variants):
            if not self.good(short[i]) and math.isnan(owns[i].afresh):

                def make(budget: int, i: int = i) -> Own:
                    return afresh(self.fleet, i, owns[i], budget=budget, seed=self.settings.seed + i + 100)

                found[i] = self._searched(f"{variant.name} alone, once more", self.settings.budget, Own, make)
        return tuple(found)

    def _starts(self, local: frozenset[str]) -> list[Array]:
        """Designs to start from: the best with fewer local numbers, each variant's own for all, and those with each its own local part."""
        fleet, n = self.fleet, self.fleet.n_variant
        fewer = [design for _, design in self.designs if design.local <= local and design.holds]
        fewer.sort(key=lambda design: swap_loss(design.values, fleet.best, fleet.floor))
        mine = np.array([name in local for name in fleet.space.names])
        found = [design.points for design in fewer[:1]] or [np.tile(fleet.space.start, (n, 1))]
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
        done = self.of(chosen)
        if done is None:
            seed, starts = self._seed, self._starts(chosen)
            # More freedom seldom leads far away from what fewer local numbers came to; without that, from the variants' own.
            near = [] if not chosen else starts[:1] if self.designs else [self.fleet.best_points]

            def make(budget: int) -> Design:
                return shared(self.fleet, chosen, starts, budget=budget, seed=seed, near=near)

            done = self._searched(f"local: {name}" if chosen else SHARED, share * self.settings.budget, Design, make)
            self.designs.append((name, done))
        return self.loss(done)

    def drop(self, held: Design, names: frozenset[str]) -> Design:
        """Search on from a design with fewer of its numbers local, until that is good enough or `TRIAL` is spent."""
        local = held.local - names
        seed, starts = self._seed, [*made_one(self.fleet, held, names), *self.known]
        name = words(self.fleet, local)

        def make(budget: int) -> Design:
            return within(self.fleet, local, starts, budget=budget, seed=seed, limit=ENOUGH * self.settings.full)

        done = self._searched(f"local: {name}", TRIAL * self.settings.budget, Design, make)
        self.designs.append((name, done))
        return done

    def refine(self, design: Design, turn: int = 0) -> Design:
        """Search on from a design, with all of `TRIAL`; what comes out takes its place."""
        at = next(k for k, (_, one) in enumerate(self.designs) if one is design)
        name, seed = self.designs[at][0], self._seed + 3 + turn

        def make(budget: int) -> Design:
            return within(self.fleet, design.local, [design.points], budget=budget, seed=seed)

        more = self._searched(f"local: {name}, to the end", TRIAL * self.settings.budget, Design, make)
        better = min((more, design), key=lambda one: swap_loss(one.values, self.fleet.best, self.fleet.floor))
        made = replace(better, runs=design.runs + more.runs)
        self.designs[at] = (name, made)
        return made

    def again(self) -> None:
        """Search the shared design once more, from all that was found so far with its values made one: one that stuck is no verdict."""
        at, before = next((k, design) for k, (_, design) in enumerate(self.designs) if not design.local)
        others = sorted((design for _, design in self.designs if design.local and design.holds), key=self.loss)
        if not others:
            return
        starts = [before.points, *self._for_all()]
        for design in others[:MERGED]:
            starts += made_one(self.fleet, design, design.local)

        def make(budget: int) -> Design:
            return shared(self.fleet, frozenset(), starts, budget=budget, seed=self.settings.seed + 4, spread=AGAIN, most=STARTS)

        more = self._searched(f"{SHARED}, once more", self.settings.budget, Design, make)
        better = more if self.loss(more) < self.loss(before) else before
        self.designs[at] = ("none", replace(better, per_start=before.per_start, runs=before.runs + more.runs))

    def _for_all(self) -> list[Array]:
        """Return each variant's own best as a design for all of them."""
        return [np.tile(point, (self.fleet.n_variant, 1)) for point in self.fleet.best_points]

    def handed_on(self, local: frozenset[str]) -> Design:
        """Return the best design with such local numbers that follows from what was found for others: the rest have one value of theirs."""
        fleet, shared_names = self.fleet, [name for name in self.fleet.space.names if name not in local]
        found = [np.tile(fleet.space.start, (fleet.n_variant, 1)), *self._for_all()]
        for _, design in self.designs:
            found += [design.points] if design.local <= local else made_one(fleet, design, shared_names)
        values, broken = fleet.values(np.stack(found, axis=1))
        kept = np.where(broken > 0.0, np.inf, values)
        best = int(np.argmin(losses(kept.T, fleet.best, fleet.floor).max(axis=1)))
        return Design(local, found[best], kept[:, best], np.zeros(0), len(found))

    def settle(self) -> None:
        """Give each set of local numbers the better of what its search came to and what follows from the others'."""
        for at, (name, design) in enumerate(self.designs):
            other = self.handed_on(design.local)
            if self.loss(other) < self.loss(design):
                self.designs[at] = (name, replace(design, points=other.points, values=other.values))

    @property
    def _seed(self) -> int:
        return self.settings.seed + 10 * len(self.designs) + 5

    def of(self, local: frozenset[str]) -> Design | None:
        """Return the design with such local numbers, if it was looked at."""
        return next((design for _, design in self.designs if design.local == local), None)

    def loss(self, design: Design) -> float:
        """Return the loss of a choice as J* stands: that of the best design that has no more local numbers."""
        fewer = [design, *(one for _, one in self.designs if one.local < design.local)]
        return min(swap_loss(one.values, self.fleet.best, self.fleet.floor) for one in fewer)

    def fewest(self) -> Design | None:
        """Return the design with the fewest local numbers that is good; None where none is."""
        good = [design for _, design in self.designs if self.good(self.loss(design))]
        return min(good, key=lambda design: (len(design.local), self.loss(design)), default=None)

    def good(self, loss: float) -> bool:
        """Tell whether a loss is under the limit."""
        return loss < self.settings.full

    def choices(self) -> tuple[Choice, ...]:
        """Return what was looked at, each with the best design that it allows: more local numbers never lose more."""
        fleet, found = self.fleet, []
        for name, design in self.designs:
            allowed = [one for _, one in self.designs if one.local <= design.local]
            best = min(allowed, key=lambda one: swap_loss(one.values, fleet.best, fleet.floor))
            merged = Design(design.local, best.points, best.values, design.per_start, design.runs)
            found.append(Choice(name, merged, losses(best.values, fleet.best, fleet.floor)))
        return tuple(found)


def made_one(fleet: Fleet, design: Design, names: Iterable[str]) -> list[Array]:
    """Return designs (n_variant, n_number) in which numbers have one value: of all variants, leaning to one of them, or its own."""
    n, chosen = fleet.n_variant, set(names)
    columns = np.array([name in chosen for name in fleet.space.names])
    even, found = np.full(n, 1.0 / n), []
    for weights in (even, *(0.5 * (even + one) for one in np.eye(n)), *np.eye(n)):
        found.append(np.where(columns, weights @ design.points, design.points))
    return found


def words(fleet: Fleet, names: Iterable[str]) -> str:
    """Return names as people say them, in the order of the space."""
    wanted = set(names)
    return ", ".join(number.short for number in fleet.space.numbers if number.name in wanted) or "none"
