"""Curves end to end, evaluated by arc length: the base of a path, used by searches and tables."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index
from contourlab.errors import GeometryError
from contourlab.geometry.curve import Curve, CurveBatch


class CurveSequence:
    """Curves in succession, stored by kind, so that the cost of n samples over m curves is proportional to n + m.

    Attributes
    ----------
    breaks : ndarray (n_curve + 1,) [m]
        Arc length at which each curve starts, and the total length.
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
        """Whether there are two coordinates, so that errors are signed."""
        return self.n_axis == 2

    def _gather(self) -> None:
        """Group the curves by kind: a kind and a slot then identify a curve."""
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
        """The batch of each kind, and the rising numbers of its curves."""
        return [(batch, np.flatnonzero(self._kind == k)) for k, batch in enumerate(self._sets)]

    @cached_property
    def smallest_radii(self) -> Array:
        """Smallest radius of curvature (n_curve,) [m] of each curve."""
        radii = np.empty(len(self.curves))
        for batch, numbers in self.kinds:
            radii[numbers] = batch.smallest_radii()
        return radii

    @cached_property
    def junctions(self) -> tuple[Array, Array]:
        """Where curves meet (m + 1, n_axis), and the length of the path up to there (m + 1,), including gaps."""
        starts, ends = self.starts[0], self.ends[0]
        gap = np.linalg.norm(np.roll(starts, -1, axis=0) - ends, axis=1)
        if not self.closed:
            gap[-1] = 0.0
        last = starts[:1] if self.closed else ends[-1:]
        along = np.concatenate([[0.0], np.cumsum(np.diff(self.breaks) + gap)])
        return np.ascontiguousarray(np.concatenate([starts, last])), along

    def kind_of(self, curve: Index) -> Iterator[tuple[CurveBatch, Index, Index]]:
        """Yield for each kind among curves (n,): its batch, which of the n belong to it, and their slots."""
        if len(self._sets) == 1:
            yield self._sets[0], np.arange(curve.size), self._slot[curve]
            return
        kind, slot = self._kind[curve], self._slot[curve]
        for k, batch in enumerate(self._sets):
            on = np.flatnonzero(kind == k)
            if on.size:
                yield batch, on, slot[on]

    def local(self, s: ArrayLike) -> tuple[Index, Array]:
        """Return the curve of each arc length (n,), and the arc length along that curve."""
        along = np.atleast_1d(np.asarray(s, dtype=float))
        along = along - self.length * np.floor(along / self.length) if self.closed else np.clip(along, 0.0, self.length)
        index = np.clip(np.searchsorted(self.breaks, along, side="right") - 1, 0, len(self.curves) - 1)
        return index, along - self.breaks[index]

    def curve_index(self, s: ArrayLike) -> Index:
        """Return the curve of each arc length (n,); a junction belongs to the curve that starts there."""
        return self.local(s)[0]

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        """Return position and derivatives by arc length: ndarray (order + 1, n, n_axis), order 0 to 3.

        On a closed path `s` wraps around; on an open one it is clipped.
        """
        index, along = self.local(s)
        return self.at(index, along, order)

    def at(self, index: Index, along: Array, order: int) -> Array:
        """Evaluate curves `index` at arc lengths `along`: (order + 1, n, n_axis), a view of memory with each coordinate in one row."""
        if len(self._sets) == 1:
            return self._sets[0].derivatives(self._slot[index], along, order).transpose(0, 2, 1)
        result = np.empty((order + 1, self.n_axis, along.size))
        for batch, on, slot in self.kind_of(index):
            result[:, :, on] = batch.derivatives(slot, along[on], order)
        return result.transpose(0, 2, 1)

    def position(self, s: ArrayLike) -> Array:
        """Return positions (n, n_axis) [m]."""
        return np.asarray(self.derivatives(s, 0)[0])
