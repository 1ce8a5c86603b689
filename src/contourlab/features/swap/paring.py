"""The smallest set of local numbers from above: all of them, less whatever can do with one value."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from contourlab.features.swap.course import ALL, BASE, Course
from contourlab.features.swap.design import Design
from contourlab.features.swap.sensitivity import groups_of


def pare(course: Course, candidates: tuple[str, ...], weights: Mapping[str, float]) -> None:
    """Search the design with all candidates local, drop what is not missed, then search the shared design from what is left.

    Parameters
    ----------
    course : Course
        After the search for each variant's own best.
    candidates : tuple of str
    weights : mapping of str to float
        How much each matters.

    Notes
    -----
    Groups of the structure go first, then single numbers, in the order of weight times how far the values of the variants are apart. No set
    within one that failed is tried, as it has less freedom. A last number is not dropped here: that is the shared design. Where a design
    that was found already holds on all variants, nothing has to be dropped.
    """
    course.look(ALL, candidates)
    held = course.of(frozenset(candidates))
    assert held is not None
    restored = course.good(course.loss(held))
    if restored and len(candidates) > 1 and not course.good(course.loss(course.handed_on(frozenset()))):
        held = course.refine(_pared(course, held, candidates, weights))
    course.look("none", (), share=BASE)
    if not course.good(course.loss(course.handed_on(frozenset()))):
        course.again()
    if restored and not course.good(course.loss(held)):
        # J* has fallen meanwhile.
        course.refine(held, turn=1)


def _pared(course: Course, held: Design, candidates: tuple[str, ...], weights: Mapping[str, float]) -> Design:
    """Return the design with the fewest local numbers that dropping comes to."""
    failed: list[frozenset[str]] = []

    def missed(design: Design, names: frozenset[str]) -> float:
        places = dict(zip(course.fleet.space.names, np.ptp(design.points, axis=0).tolist(), strict=True))
        return float(sum(weights[name] * places[name] for name in names))

    groups, single = list(groups_of(course.fleet, candidates).values()), [frozenset({name}) for name in candidates]
    for waiting in (groups, single):
        while waiting:
            names = min(waiting, key=lambda one: missed(held, one))
            waiting.remove(names)
            left = held.local - names
            if not left or left == held.local or any(left <= one for one in failed):
                continue
            done = course.drop(held, names)
            if course.good(course.loss(done)):
                held = done
            else:
                failed.append(left)
    return held
