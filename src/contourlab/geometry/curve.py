"""Curves as smooth functions of arc length: the interface, many at once, and curves end to end."""

from __future__ import annotations

from abc import ABC
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import GeometryError, refuse


class CurveBatch:
    """Many curves of one kind, evaluated at once; this class evaluates curve by curve, subclasses whole arrays.

    Parameters
    ----------
    curves : sequence of Curve
        At least one, all of one kind.

    Attributes
    ----------
    sixth : ndarray (n_curve,) [1/m^5] or None
        Bound of the sixth derivative by arc length of each curve; None if unknown.
    columns, axis
        Names of the arrays that define the curves, and the axis of the curves in them.
    """

    sixth: Array | None = None
    columns: ClassVar[tuple[str, ...]] = ("curves",)
    axis: ClassVar[int] = 0

    def __init__(self, curves: Sequence[Any]) -> None:
        self._fill(np.fromiter(curves, dtype=object, count=len(curves)))

    def _fill(self, *arrays: Any) -> None:
        """Take the arrays of `columns`."""
        (self.curves,) = arrays
        self.n_axis: int = self.curves[0].n_axis
        self.length = np.array([curve.length for curve in self.curves])

    @classmethod
    def made(cls, *arrays: Any) -> Self:
        """Return the batch with the arrays of `columns`."""
        batch = cls.__new__(cls)
        batch._fill(*arrays)
        return batch

    @classmethod
    def merged(cls, batches: Sequence[Any], order: Index) -> Self:
        """Return curves of successive batches of one kind, in the `order` (n,) of their numbers."""
        parts = (np.concatenate([getattr(batch, name) for batch in batches], axis=cls.axis) for name in cls.columns)
        return cls.made(*(np.take(part, order, axis=cls.axis) for part in parts))

    def curve(self, slot: int) -> Any:
        """Return one of the curves; batches that keep numbers alone create it."""
        return self.curves[slot]

    def derivatives(self, slot: Index, along: Array, order: int) -> Array:
        """Return position and derivatives by arc length: ndarray (order + 1, n_axis, n), each coordinate in one row.

        Parameters
        ----------
        slot : ndarray (n,) of int
            Number of the curve.
        along : ndarray (n,) [m]
            Arc length on it.
        order : int, 0 to 3
        """
        result = np.empty((order + 1, self.n_axis, along.size))
        # Sort once: the cost is linear in the samples, not in samples times curves.
        ranked = np.argsort(slot, kind="stable")
        begins = np.flatnonzero(np.append(True, np.diff(slot[ranked]) > 0)) if slot.size else np.zeros(0, dtype=np.int64)
        for chosen in np.split(ranked, begins[1:]) if slot.size else ():
            result[:, :, chosen] = self.curves[int(slot[chosen[0]])].derivatives(along[chosen], order).transpose(0, 2, 1)
        return result

    def marks(self) -> tuple[Array, Index]:
        """Return the arc lengths (n_mark,) [m] at which a table must cut the curves, with their ends, and their number (n,) for each."""
        if not hasattr(self.curve(0), "marks"):
            return np.column_stack([np.zeros_like(self.length), self.length]).ravel(), np.full(self.length.size, 2)
        marks = [curve.marks for curve in self.curves]
        return np.concatenate(marks), np.array([len(of_curve) for of_curve in marks])

    def smallest_radii(self) -> Array:
        """Return the smallest radius of curvature (n_curve,) [m] of each curve."""
        return np.array([curve.smallest_radius() for curve in self.curves])


class Curve(ABC):
    """A smooth curve as a function of its arc length, from 0 to `length`.

    Attributes
    ----------
    n_axis : int
        Number of coordinates.
    length : float [m], > 0
    digest_parts : tuple of str
        Name of the kind, and the attributes that define the curve.
    """

    n_axis: int
    length: float
    digest_parts: ClassVar[tuple[str, ...]]
    _batch: ClassVar[type[CurveBatch]] = CurveBatch
    """Evaluator for many curves of this kind; frequent kinds have a faster one, which evaluates a single curve too."""

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        """Return position and derivatives by arc length; unless a kind says otherwise, those of a batch of one.

        Parameters
        ----------
        s : array_like (n,) [m]
            Within the curve.
        order : int, 0 to 3
            Highest derivative.

        Returns
        -------
        ndarray (order + 1, n, n_axis)
        """
        along = np.atleast_1d(np.asarray(s, dtype=float))
        return self._batch([self]).derivatives(np.zeros(along.size, dtype=np.int64), along, order).transpose(0, 2, 1)

    def describe(self) -> bytes:
        """Return the kind and all numbers that define the curve, for its digest."""
        kind, *attributes = self.digest_parts
        return kind.encode() + b"".join(np.asarray(getattr(self, name), dtype="<f8").tobytes() for name in attributes)

    def position(self, s: ArrayLike) -> Array:
        """Return positions (n, n_axis) [m]."""
        return np.asarray(self.derivatives(s, 0)[0])

    def smallest_radius(self) -> float:
        """Return an estimate of the smallest radius of curvature [m], from samples; inf for a line."""
        bend = np.linalg.norm(self.derivatives(np.linspace(0.0, self.length, 257), 2)[2], axis=1).max()
        return float(1.0 / bend) if bend > 0.0 else float("inf")


def rows(curves: Sequence[Any], name: str) -> Array:
    """Return a vector attribute of each curve as (n_axis, n_curve), each coordinate a contiguous row."""
    return np.ascontiguousarray(np.concatenate([getattr(curve, name) for curve in curves]).reshape(len(curves), -1).T)


def of_each(values: Array, slot: Index) -> Array:
    """Return values (..., n_curve) of the curves in `slot`; values of a single curve are broadcast, which is faster."""
    return values if values.shape[-1] == 1 else values[..., slot]


def vector(values: ArrayLike, name: str) -> Array:
    """Return a finite vector of one or more coordinates.

    Raises
    ------
    GeometryError
        If `values` is no such vector.
    """
    try:
        coordinates = np.array(values, dtype=float)
    except (TypeError, ValueError):
        coordinates = np.empty(0)
    if coordinates.ndim != 1 or coordinates.size < 1 or not np.isfinite(coordinates).all():
        raise GeometryError(f"{name} = {values!r}: must be a vector of finite coordinates")
    return coordinates


def by_arc_length(raw: Array, order: int) -> Array:
    """Convert derivatives by any parameter to derivatives by arc length, by the chain rule.

    Parameters
    ----------
    raw : ndarray (order + 1, n, n_axis)
        r and its derivatives by the parameter u.
    order : int, 0 to 3
    """
    by_length = np.empty_like(raw[: order + 1])
    by_length[0] = raw[0]
    if order > 0:
        first = raw[1]
        square = np.einsum("ij,ij->i", first, first)
        p = (1.0 / np.sqrt(square))[:, None]  # du/ds
        by_length[1] = first * p
    if order > 1:
        along = np.einsum("ij,ij->i", first, raw[2])
        q = (-along / square**2)[:, None]  # d2u/ds2
        by_length[2] = raw[2] * p**2 + first * q
    if order > 2:
        change = np.einsum("ij,ij->i", raw[2], raw[2]) + np.einsum("ij,ij->i", first, raw[3])
        w = ((4.0 * along**2 / square**3 - change / square**2)[:, None]) * p  # d3u/ds3
        by_length[3] = raw[3] * p**3 + 3.0 * raw[2] * p * q + first * w
    return by_length


def clenshaw(c: Array, x: Array) -> Array:
    """Evaluate Chebyshev series with coefficients c (terms, ...) at x by Clenshaw's recursion; c[k] and x broadcast."""
    b1, b2 = np.zeros(np.broadcast_shapes(x.shape, c.shape[1:])), np.zeros(1)
    twice = 2.0 * x
    for row in c[:0:-1]:
        b1, b2 = twice * b1 - b2 + row, b1
    return np.asarray(x * b1 - b2 + c[0])


def interval(breaks, s, hint):  # type: ignore[no-untyped-def]
    """Return the number of the last of rising intervals that starts at or before s, or of the first; `hint` is one that may be near."""
    low, high = 0, breaks.size - 2
    if breaks[hint] <= s:
        low = hint
        for _ in range(4):
            low += 1 if low < high and breaks[low + 1] <= s else 0
        high = low if low == high or s < breaks[low + 1] else high
    else:
        high = hint
    while low < high:
        middle = (low + high + 1) // 2
        if breaks[middle] <= s:
            low = middle
        else:
            high = middle - 1
    return low


def angle_between(a: Array, b: Array) -> Array:
    """Return the angles (n,) [rad] between unit vectors (n, n_axis), accurate for small and large angles."""
    return np.asarray(2.0 * np.arctan2(np.linalg.norm(b - a, axis=1), np.linalg.norm(a + b, axis=1)))


def positive(**values: float) -> None:
    """Raise a GeometryError for the first value that is not finite and > 0."""
    for name, value in values.items():
        if not 0.0 < value < float("inf"):
            raise GeometryError(f"{name} = {value!r}: must be > 0 and finite")


class Curves(Sequence[Curve]):
    """Curves in succession, stored by kind.

    Parameters
    ----------
    parts : sequence of tuples
        Batches, and for each of their curves a number of its own (n,); the curves come in the order of these.

    Attributes
    ----------
    batches : list of CurveBatch
        One for each kind, its curves in order.
    kind, slot : ndarray (n_curve,) of int
        Batch of each curve, and its number there.
    """

    def __init__(self, parts: Sequence[tuple[CurveBatch, Array | Index]]) -> None:
        place = np.concatenate([numbers for _, numbers in parts])
        rank, done = np.argsort(np.argsort(place, kind="stable")), 0
        kinds: dict[Any, list[tuple[CurveBatch, Index]]] = {}
        for batch, numbers in parts:
            done += numbers.size
            if numbers.size:
                kinds.setdefault((type(batch), type(batch.curve(0))), []).append((batch, rank[done - numbers.size : done]))
        self.batches: list[CurveBatch] = []
        self.kind, self.slot = np.zeros((2, place.size), dtype=np.int64)
        for batches, ranks in (zip(*members, strict=True) for members in kinds.values()):
            at = np.concatenate(ranks)
            order = np.argsort(at)
            self.kind[at[order]], self.slot[at[order]] = len(self.batches), np.arange(at.size)
            self.batches.append(batches[0].merged(batches, order))

    @classmethod
    def of(cls, curves: Iterable[Curve]) -> Curves:
        """Return given curves, or these themselves."""
        if isinstance(curves, Curves):
            return curves
        kinds: dict[type[Curve], tuple[list[int], list[Curve]]] = {}
        for i, curve in enumerate(curves):
            numbers, members = kinds.setdefault(type(curve), ([], []))
            numbers.append(i)
            members.append(curve)
        refuse(not kinds, GeometryError, "a path needs at least one curve")
        axes = {curve.n_axis for _, members in kinds.values() for curve in members}
        refuse(len(axes) > 1, GeometryError, "the curves of a path must all have the same number of coordinates")
        return cls([(kind._batch(members), np.array(numbers)) for kind, (numbers, members) in kinds.items()])

    def parts(self, number: Array | Index) -> list[tuple[CurveBatch, Array | Index]]:
        """Return the curves with a `number` (n,) that is not negative, as parts of other curves."""
        given = [(batch, number[self.kind == k]) for k, batch in enumerate(self.batches)]
        return [(batch.merged([batch], np.flatnonzero(of >= 0)), of[of >= 0]) for batch, of in given if np.any(of >= 0)]

    def __len__(self) -> int:
        return int(self.kind.size)

    def __getitem__(self, which: Any) -> Any:
        if isinstance(which, slice):
            return tuple(self[i] for i in range(len(self))[which])
        return self.batches[self.kind[which]].curve(int(self.slot[which]))


class CurveSequence:
    """Curves in succession, stored by kind, so that the cost of n samples over m curves is proportional to n + m.

    Attributes
    ----------
    breaks : ndarray (n_curve + 1,) [m]
        Arc length at which each curve starts, and the total length.
    length : float [m]
    """

    def __init__(self, curves: Sequence[Curve], closed: bool = False) -> None:
        self.curves = Curves.of(curves)
        self._kind, self._slot, self._sets = self.curves.kind, self.curves.slot, self.curves.batches
        self.n_axis, self.closed, length = self._sets[0].n_axis, closed, np.empty(len(self.curves))
        for batch, numbers in self.kinds:
            length[numbers] = batch.length
        self.breaks = np.concatenate([[0.0], np.cumsum(length)])
        self.length = float(self.breaks[-1])
        self.ends, self.starts = (self.at(np.arange(length.size), along, 1) for along in (length, np.zeros_like(length)))

    @property
    def is_planar(self) -> bool:
        """Whether there are two coordinates, so that errors are signed."""
        return self.n_axis == 2

    @property
    def kinds(self) -> list[tuple[CurveBatch, Index]]:
        """The batch of each kind, and the rising numbers of its curves."""
        return [(batch, np.flatnonzero(self._kind == k)) for k, batch in enumerate(self._sets)]

    def of_kind(self, *kinds: type[CurveBatch]) -> Flags:
        """Return which curves are of some kinds (n_curve,)."""
        return np.array([isinstance(batch, kinds) for batch in self._sets])[self._kind]

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
