"""The sequential procedure of Ghaffari & Ulsoy: innermost loop to outermost, one number at a time, all others fixed."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from contourlab.design import Space
from contourlab.design.guards import Guards
from contourlab.features.tune.line import LineRule, Step, line_search
from contourlab.features.tune.objective import Objective

SETTLED = 1e-3
"""A pass that takes off less than this part of the objective is the last one."""


@dataclass(frozen=True)
class Path:
    """The steps in their order, and where they led.

    Attributes
    ----------
    values : dict of str to float [SI]
    steps : tuple of Step
    """

    values: dict[str, float]
    steps: tuple[Step, ...] = field(default=())


def sequential(
    objective: Objective,
    guards: Guards,
    space: Space,
    values: Mapping[str, float],
    rule: LineRule,
    *,
    passes: int = 1,
    tell: Callable[[int, int], None] | None = None,
) -> Path:
    """Calibrate the numbers of a space in its order, one at a time.

    Parameters
    ----------
    objective : Objective
    guards : Guards
    space : Space
        Its order is that of the procedure: by default `contourlab.design.calibration_order`.
    values : mapping of str to float [SI]
        Where it starts.
    rule : LineRule
    passes : int, >= 1
        How often it goes through all numbers, at most: it ends when a pass has hardly made a difference.
    tell : callable, optional
        Told how many steps are done, and how many there are at most.

    References
    ----------
    Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring", section IV.
    """
    now, steps = dict(values), list[Step]()
    total = passes * len(space.numbers)
    for turn in range(1, passes + 1):
        begun = steps[-1].objective_after if steps else math.inf
        for number in space.numbers:
            step = line_search(objective, guards, number, now, rule, f"pass {turn}")
            now[number.name] = step.after
            steps.append(step)
            if tell is not None:
                tell(len(steps), total)
        if steps[-1].objective_after > begun * (1.0 - SETTLED):
            break
    return Path(now, tuple(steps))
