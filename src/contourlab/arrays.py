"""Array types by type of element, and what arrays need of the machine: short rows, cache lines, blocks of memory."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import fields
from functools import reduce
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Index = NDArray[np.int64]
Flags = NDArray[np.bool_]

_CACHE_LINE = 64
BLOCK = 1 << 16
"""Samples in memory at a time: a multiple of the chunks in which foot points are searched, so blocks and whole runs give the same bits."""


class ByValue:
    """Equality of a dataclass with arrays, which has ``eq=False``: type and compared fields are equal, arrays in shape and values."""

    def __eq__(self, other: object) -> bool:
        names = [part.name for part in fields(self) if part.compare]  # type: ignore[arg-type]  # a dataclass inherits it
        return type(self) is type(other) and all(np.array_equal(getattr(self, name), getattr(other, name)) for name in names)


def across(combine: Callable[[Array, Array], Array], rows: Array) -> Array:
    """Combine the columns of short rows (n, m) to (n,), for example by np.minimum; NumPy's own reduction takes ten times as long."""
    return reduce(combine, rows.T)


def true_spans(mask: Flags | Array) -> list[tuple[int, int]]:
    """Return the spans [start, stop) of samples at which a mask (n,) is true, or values (n,) are equal and not 0."""
    edges = [0, *(np.flatnonzero(np.diff(mask)) + 1).tolist(), mask.size]
    return [(start, stop) for start, stop in pairwise(edges) if start < stop and mask[start]]


def ranges(first: Index, count: Index) -> Index:
    """Return `count` successive numbers from each `first`, one range after another.

    >>> ranges(np.array([10, 20]), np.array([2, 3])).tolist()
    [10, 11, 20, 21, 22]
    """
    return np.repeat(first - (np.cumsum(count) - count), count) + np.arange(int(count.sum()))


def aligned(shape: tuple[int, ...]) -> Array:
    """Return an uninitialised array that begins at a cache line: storing vectors across two lines takes twice as long."""
    n = math.prod(shape)
    raw = np.empty(n + _CACHE_LINE // 8)
    first = -raw.ctypes.data % _CACHE_LINE // 8
    return raw[first : first + n].reshape(shape)
