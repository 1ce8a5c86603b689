"""Curves end to end, evaluated by arc length: all that a search or a table needs of a path."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import ArrayLike

from contourlab.errors import GeometryError
from contourlab.geometry.curve import Array, Curve, CurveBatch, Index


class CurveSequence:
    """Curves one after another; those of one kind are held together, so that n samples over m curves cost n + m.

    Attributes
    ----------
    curves : tuple of Curve
    closed : bool
    n_axis : int
    breaks : ndarray (n_curve + 1,) [m]
        Arc length at which each curve begins, and the length of all.
    length : float [m]
    """

    def __init__(self, curves: Sequence[Curve], closed: bool = False) -> None:
        self.curves = tuple(curves)
        if not self.curves:
            raise GeometryError("a path needs at least one curve")
        self.n_axis = self.curves[0].n_axis
        self.closed = closed
        if any(curve.n_axis != self.n_axis for curve in self.curves):
            raise GeometryError("the curves of a path must all have the same number of coordinates")
        self.breaks = np.concatenate([[0.0], np.cumsum([curve.length for curve in self.curves])])
        self.length = float(self.breaks[-1])
        self._gather()
        self.ends = self.at(np.arange(len(self.curves)), np.array([c.length for c in self.curves]), 1)
        self.starts = self.at(np.arange(len(self.curves)), np.zeros(len(self.curves)), 1)

    @property
    def is_planar(self) -> bool:
        """Whether there are two coordinates, so that errors have a side."""
        return self.n_axis == 2

    def _gather(self) -> None:
        """Put the curves of each kind together: a curve is then a kind and a slot."""
        kinds: dict[type[Curve], list[int]] = {}
        for i, curve in enumerate(self.curves):
            kinds.setdefault(type(curve), []).append(i)
        self._kind = np.zeros(len(self.curves), dtype=np.int64)
        self._slot = np.zeros(len(self.curves), dtype=np.int64)
        self._sets: list[CurveBatch] = []
        for number, (kind, members) in enumerate(kinds.items()):
            self._kind[members], self._slot[members] = number, np.arange(len(members))
            self._sets.append(kind.batch([self.curves[i] for i in members]))

    @property
    def kinds(self) -> list[tuple[CurveBatch, Index]]:
        """The curves by kind: what evaluates them at once, and their numbers along the path in its order."""
        return [(each, np.flatnonzero(self._kind == k)) for k, each in enumerate(self._sets)]

    def kind_of(self, curve: Index) -> Iterator[tuple[CurveBatch, Index, Index]]:
        """Yield, for numbers of curves (n,), by kind: what evaluates them, which of the n are meant, and their slots."""
        if len(self._sets) == 1:
            yield self._sets[0], np.arange(curve.size), self._slot[curve]
            return
        kind, slot = self._kind[curve], self._slot[curve]
        for k, each in enumerate(self._sets):
            on = np.flatnonzero(kind == k)
            if on.size:
                yield each, on, slot[on]

    def local(self, s: ArrayLike) -> tuple[Index, Array]:
        """Return, for arc lengths (n,), the curve each lies on and the arc length along that curve."""
        along = np.atleast_1d(np.asarray(s, dtype=float))
        along = along - self.length * np.floor(along / self.length) if self.closed else np.clip(along, 0.0, self.length)
        index = np.clip(np.searchsorted(self.breaks, along, side="right") - 1, 0, len(self.curves) - 1)
        return index, along - self.breaks[index]

    def curve_index(self, s: ArrayLike) -> Index:
        """Return on which curve each arc length (n,) lies; a joint belongs to the curve that begins there."""
        return self.local(s)[0]

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        """Return position and derivatives by arc length: ndarray (order + 1, n, n_axis), order 0 to 3.

        On a closed path `s` wraps around; on an open one it is held to the ends.
        """
        index, along = self.local(s)
        return self.at(index, along, order)

    def at(self, index: Index, along: Array, order: int) -> Array:
        """Evaluate at places `along` the curves `index`: a view (order + 1, n, n_axis) of memory that holds each coordinate in one row."""
        if len(self._sets) == 1:
            return self._sets[0].derivatives(self._slot[index], along, order).transpose(0, 2, 1)
        found = np.empty((order + 1, self.n_axis, along.size))
        for each, on, slot in self.kind_of(index):
            found[:, :, on] = each.derivatives(slot, along[on], order)
        return found.transpose(0, 2, 1)

    def position(self, s: ArrayLike) -> Array:
        """Return positions (n, n_axis) [m]."""
        return np.asarray(self.derivatives(s, 0)[0])
