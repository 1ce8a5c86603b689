"""The study of a swap: each variant's own optimum, the shared design, and the smallest set of local numbers that restores modularity."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from contourlab.features.swap.course import ALL, BASE, Course, Stage, words
from contourlab.features.swap.design import Choice, Design, evaluated
from contourlab.features.swap.fleet import Fleet
from contourlab.features.swap.kept import Kept
from contourlab.features.swap.loss import losses
from contourlab.features.swap.own import Own, shortfalls
from contourlab.features.swap.paring import pare
from contourlab.features.swap.sensitivity import Ranked, ranked
from contourlab.features.swap.settings import SwapSettings

Array = NDArray[np.float64]
TURNS = 3
"""How often J* is searched on at most."""


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
    def fell_short(self) -> tuple[str, ...]:
        """Variants whose J* may lie lower: no search for them alone came within the limit of it by itself, or it still fell by as much."""
        short = shortfalls(self.fleet, self.owns, by_themselves=True)
        return tuple(variant.name for variant, lost in zip(self.fleet.variants, short, strict=True) if lost >= self.settings.full)

    @property
    def full(self) -> bool:
        """Whether one controller serves all variants."""
        return self.base.loss < self.settings.full

    @property
    def recommended(self) -> Choice | None:
        """The choice with the fewest local numbers that is modular; None where none is."""
        good = [choice for choice in self.choices if choice.loss < self.settings.full]
        return min(good, key=lambda choice: (choice.effort, choice.loss), default=None)


def swap_study(
    fleet: Fleet, candidates: tuple[str, ...], settings: SwapSettings, stage: Stage = lambda said, most: None, kept: Kept | None = None
) -> SwapStudy:
    """Find out whether one controller serves all variants, and if not, which numbers have to be local.

    Parameters
    ----------
    fleet : Fleet
    candidates : tuple of str
        Numbers of the swapped axes, all of which may be local.
    settings : SwapSettings
    stage : callable
        Told what is done next, and how many candidates of variants it takes at most.
    kept : Kept, optional
        Where searches are kept, and looked for.

    Raises
    ------
    ParameterError
        If no design of a variant keeps the guards.
    """
    going = Course(fleet, settings, stage, kept)
    start = np.tile(fleet.space.start, (fleet.n_variant, 1))
    values, broken = fleet.values(start[:, None], whole=True)
    for points in going.known:
        fleet.values(points[:, None])
    owns = going.own()
    order = tuple(ranked(fleet, candidates)) if candidates and settings.local is None else ()
    if settings.local is not None:
        _given(going, settings.local)
    elif settings.exhaustive:
        _exhausted(going, candidates, [one.name for one in order])
    elif candidates:
        pare(going, candidates, {one.name: one.sensitivity for one in order})
    else:
        going.look("none", (), share=BASE)
    owns = _in_step(going, owns)
    crossed = np.array([evaluated(fleet, frozenset(), np.tile(point, (fleet.n_variant, 1))).values for point in fleet.best_points])
    given = Choice("as given", Design(frozenset(), start, values[:, 0], np.zeros(0), 1), losses(values[:, 0], fleet.best, fleet.floor))
    # Nothing local first, all of it last.
    choices = sorted(going.choices(), key=lambda choice: (choice.effort == len(candidates) and choice.effort > 0, choice.effort > 0))
    breaks = tuple(variant.name for variant, worst in zip(fleet.variants, broken[:, 0], strict=True) if worst > 0.0)
    return SwapStudy(fleet, settings, owns, given, tuple(choices), crossed, order, breaks)


def _in_step(going: Course, owns: tuple[Own, ...]) -> tuple[Own, ...]:
    """Let searches for a variant alone catch up where another one found better, and the design that held until then follow, in turns."""
    for turn in range(TURNS):
        going.stage("each design on each variant", 0)
        going.settle()
        held, more = going.fewest(), going.afresh(going.on(owns, turn))
        if more == owns:
            return owns
        owns = more
        if held is not None and not going.good(going.loss(held)):
            going.refine(held, turn=2 + turn)
    going.settle()
    return owns


def _given(going: Course, sets: tuple[frozenset[str], ...]) -> None:
    """Look at the sets that were asked for."""
    going.look("none", (), share=BASE)
    for names in sets:
        going.look(words(going.fleet, names), names)
    _no_verdict_on_one_search(going)


def _exhausted(going: Course, candidates: tuple[str, ...], order: list[str]) -> None:
    """Look at all sets by their size, up to the first size at which one restores modularity."""
    good = going.good(going.look("none", (), share=BASE))
    for size in range(1, len(candidates)):
        if good:
            break
        found = [going.look(words(going.fleet, names), names) for names in combinations(order, size)]
        good = any(going.good(loss) for loss in found)
    if candidates:
        going.look(ALL, candidates)
    _no_verdict_on_one_search(going)


def _no_verdict_on_one_search(going: Course) -> None:
    if not going.good(going.loss(going.designs[0][1])):
        going.again()
