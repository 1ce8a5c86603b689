"""What the search takes on trust of a design is worked out for the one that is recommended: exact margins, and the coupling."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.margins import Margins
from contourlab.design.guards import Guards
from contourlab.features.swap.fleet import Fleet
from contourlab.features.swap.numbers import divided_controller


@dataclass(frozen=True)
class Final:
    """The exact margins of a design.

    Attributes
    ----------
    margins : tuple of mapping of str to Margins
        For each variant, by axis; none for an axis without a linear model.
    broken : tuple of tuple of str
        For each variant the bounds that are not kept, in words: a margin, or the stability of axes that are coupled by the contour.
    """

    margins: tuple[Mapping[str, Margins], ...]
    broken: tuple[tuple[str, ...], ...]

    @property
    def holds(self) -> bool:
        """Whether all of them are kept."""
        return not any(self.broken)


def final(fleet: Fleet, points: NDArray[np.float64]) -> Final:
    """Return the exact margins of a design, one point (n_variant, n_number) for each variant."""
    found = []
    for variant, point in zip(fleet.variants, points, strict=True):
        guards = Guards([(variant.machine, divided_controller(fleet.controller, fleet.space.values(point)))], fleet.bounds)
        exact = guards.exact({})
        # What the drives give was counted in the runs.
        found.append((exact, guards.broken({}, 0.0, 0.0, exact)))
    margins, broken = zip(*found, strict=True)
    return Final(margins, broken)
