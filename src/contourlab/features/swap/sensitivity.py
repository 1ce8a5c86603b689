"""Which numbers are likely to have to move with the axis: how much each matters, and how far its best value moves between variants."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.components.contract import Component
from contourlab.features.swap.fleet import Fleet
from contourlab.loop import parameter_names

Array = NDArray[np.float64]
STEP = 0.05
"""Part by which a number is changed: more than what an encoder's count makes of the figure, less than its optimum is wide."""


@dataclass(frozen=True)
class Ranked:
    """A number that could be local.

    Attributes
    ----------
    name : str
        Dotted.
    sensitivity : float
        Largest of the variants' mean change of J for a change of the number by 5 % either way, over 0.05 max(J, J_tol).
    movement : float
        Largest ratio of its best values over the variants, less 1.
    """

    name: str
    sensitivity: float
    movement: float

    @property
    def score(self) -> float:
        """What is lost by giving it one value, to first order."""
        return self.sensitivity * self.movement


def ranked(fleet: Fleet, names: tuple[str, ...]) -> list[Ranked]:
    """Return the numbers, those first that matter most and whose best values lie farthest apart.

    Notes
    -----
    S_j = |dJ/dp_j p_j/J| vanishes at an optimum, so it is taken over finite steps.
    """
    space, columns = fleet.space, [fleet.space.names.index(name) for name in names]
    rows = []
    for point in fleet.best_points:
        at = space.values(point)
        changed = [{**at, name: at[name] * factor} for name in names for factor in (1.0 - STEP, 1.0 + STEP)]
        rows.append(np.vstack([point, *(space.points(one) for one in changed)]))
    values, _ = fleet.values(np.array(rows), whole=True)
    centre = values[:, :1]
    moved = np.abs(values[:, 1:] - centre).reshape(fleet.n_variant, len(names), 2).mean(axis=2)
    moved = np.where(np.isfinite(moved), moved, 0.0)
    weight = (moved / (STEP * np.maximum(centre, fleet.floor))).max(axis=0)
    best = np.column_stack([space.numbers[j].physical(fleet.best_points[:, j]) for j in columns])
    apart = best.max(axis=0) / np.where(best.min(axis=0) != 0.0, best.min(axis=0), 1.0) - 1.0
    found = [Ranked(name, float(s), float(m)) for name, s, m in zip(names, weight, apart, strict=True)]
    return sorted(found, key=lambda one: -one.score)


def groups_of(fleet: Fleet, names: tuple[str, ...]) -> dict[str, frozenset[str]]:
    """Return the numbers by what they are for: the model of an observer, gains, feedforward."""
    known: dict[str, tuple[Component, str]] = parameter_names(fleet.variants[0].machine, fleet.controller)
    found: dict[str, set[str]] = {}
    for name in names:
        part, word = known[name]
        slot = name.rpartition(".")[0].rpartition(".")[2]
        kind = "feedforward" if slot == "feedforward" or word in part.calibrated_ahead else "gains" if slot == "controller" else slot
        found.setdefault(kind, set()).add(name)
    return {kind: frozenset(mine) for kind, mine in found.items() if len(mine) > 1 and len(mine) < len(names)}
