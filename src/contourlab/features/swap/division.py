"""Which numbers of a controller are base, one value for all variants, and which are local, one for each module that is swapped in."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from contourlab.design import Space
from contourlab.errors import ParameterError
from contourlab.features.swap.variants import Variant

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Division:
    """A division of the numbers of a space between a base controller and local ones.

    Attributes
    ----------
    space : Space
    variants : sequence of Variant
    local : frozenset of str
        Dotted names, of swapped axes, that each module has its own value of. A module keeps it in whatever company it runs.

    Raises
    ------
    ParameterError
        If a local name is none of the space, or belongs to an axis that is not swapped.
    """

    space: Space
    variants: Sequence[Variant]
    local: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        for name in sorted(self.local):
            if name not in self.space.names or not self.variants[0].module(name):
                raise ParameterError("local", name, "a number of a swapped axis that is calibrated; those of other axes are base")

    @cached_property
    def _places(self) -> NDArray[np.int64]:
        """Where in a row each number of each variant stands (n_variant, n_number)."""
        known: dict[tuple[str, str], int] = {}
        places = [
            [known.setdefault((name, variant.module(name) if name in self.local else ""), len(known)) for name in self.space.names]
            for variant in self.variants
        ]
        return np.array(places)

    @property
    def size(self) -> int:
        """Numbers that a search moves: base ones, and a copy of the local ones for each module."""
        return int(self._places.max()) + 1

    def spread(self, rows: Array) -> Array:
        """Return the points (n_variant, n, n_number) of rows (n, size)."""
        return np.stack([rows[:, places] for places in self._places])

    def gathered(self, points: Array) -> Array:
        """Return the row (size,) of one point a variant (n_variant, n_number); what variants share is the average of what they have."""
        flat = self._places.ravel()
        return np.bincount(flat, points.ravel()) / np.bincount(flat)

    def contains(self, other: Iterable[str]) -> bool:
        """Tell whether what is local in another division is local here too, so that its designs are designs of this one."""
        return set(other) <= self.local
