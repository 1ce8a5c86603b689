"""Map arc length on the planned path to arc length on the programmed path."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array
from contourlab.errors import FeedError
from contourlab.geometry import Path


@dataclass(frozen=True, eq=False)
class Correspondence:
    """A piecewise linear map from arc length on the planned path to arc length on the programmed path.

    Parameters
    ----------
    planned, programmed : array_like (n_node,) [m], strictly rising
        `planned` starts and ends with the planned path. On a closed path the map repeats lap by lap.

    Raises
    ------
    FeedError
        If there are fewer than two nodes, or they do not rise.
    """

    planned: Array
    programmed: Array

    def __post_init__(self) -> None:
        for name in ("planned", "programmed"):
            values = np.array(getattr(self, name), dtype=float)
            if values.ndim != 1 or values.size < 2 or not np.all(np.diff(values) > 0.0):
                raise FeedError(f"{name}: give two or more strictly rising nodes")
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        if self.planned.size != self.programmed.size:
            raise FeedError(f"{self.planned.size} planned and {self.programmed.size} programmed nodes: give the same number of each")

    def _laps(self, s: ArrayLike) -> tuple[Array, Array]:
        along, lap = np.atleast_1d(np.asarray(s, dtype=float)), self.planned[-1] - self.planned[0]
        number = np.floor((along - self.planned[0]) / lap)
        return along - number * lap, number * (self.programmed[-1] - self.programmed[0])

    def __call__(self, s: ArrayLike) -> Array:
        """Return the programmed arc lengths (n,) [m] of planned ones (n,) [m]."""
        along, lap = self._laps(s)
        return np.asarray(np.interp(along, self.planned, self.programmed) + lap)

    def span(self, s: ArrayLike) -> Array:
        """Return the length on the programmed path (n,) [m] of the node interval around each planned arc length (n,)."""
        along, _ = self._laps(s)
        i = np.clip(np.searchsorted(self.planned, along, side="right") - 1, 0, self.planned.size - 2)
        return np.asarray(np.diff(self.programmed)[i])

    def after(self, first: Correspondence) -> Correspondence:
        """Compose: apply `first`, then this map."""
        # A lap of `first` may start anywhere on a lap of this map, so it can span the nodes of two laps.
        inner = np.concatenate([self.planned, self.planned[1:] + (self.planned[-1] - self.planned[0])])
        inner = inner[(inner > first.programmed[0]) & (inner < first.programmed[-1])]
        nodes = np.unique(np.concatenate([first.planned, np.interp(inner, first.programmed, first.planned)]))
        values = self(first(nodes))
        # Merge nodes that differ by rounding alone.
        values = np.minimum(np.maximum.accumulate(values), values[-1])
        keep = np.append(True, np.diff(values) > 0.0)
        nodes, values = nodes[keep], values[keep]
        nodes[-1] = first.planned[-1]
        return Correspondence(nodes, values)


def place_on_programmed(correspondence: Correspondence | None, path: Path, programmed: Path, s: ArrayLike) -> Array:
    """Return programmed arc lengths (n,) of planned ones (n,); without a map, in proportion to the path lengths."""
    if correspondence is not None:
        return correspondence(s)
    return np.atleast_1d(np.asarray(s, dtype=float)) * (1.0 if programmed is path else programmed.length / path.length)
