"""Array types by type of element, and arrays aligned for the processor."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import reduce

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Index = NDArray[np.int64]
Flags = NDArray[np.bool_]

_CACHE_LINE = 64


def across(combine: Callable[[Array, Array], Array], rows: Array) -> Array:
    """Combine the columns of short rows (n, m) to (n,), for example by np.minimum; NumPy's own reduction takes ten times as long."""
    return reduce(combine, rows.T)


def aligned(shape: tuple[int, ...]) -> Array:
    """Return an uninitialised array that begins at a cache line: storing vectors across two lines takes twice as long."""
    n = math.prod(shape)
    raw = np.empty(n + _CACHE_LINE // 8)
    first = -raw.ctypes.data % _CACHE_LINE // 8
    return raw[first : first + n].reshape(shape)
