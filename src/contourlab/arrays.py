"""Array types by type of element, and arrays aligned for the processor."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Index = NDArray[np.int64]
Flags = NDArray[np.bool_]

_CACHE_LINE = 64


def aligned(shape: tuple[int, ...]) -> Array:
    """Return an uninitialised array that begins at a cache line: storing vectors across two lines takes twice as long."""
    n = math.prod(shape)
    raw = np.empty(n + _CACHE_LINE // 8)
    first = -raw.ctypes.data % _CACHE_LINE // 8
    return raw[first : first + n].reshape(shape)
