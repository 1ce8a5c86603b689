"""Exponentials of small matrices at many times at once, exact also for fast rates next to slow ones.

The usual scaling and squaring rounds a slow mode once for every unit of the fastest. Here exp(M t) - 1 is squared, so that a slow mode
keeps its digits. No library call spreads six by six products over threads.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

DEGREE = 18
"""Degree of the Taylor polynomial, used up to a norm of 1: the remainder is 1/19! = 8e-18."""


def exponentials(matrix: Array, times: ArrayLike) -> Array:
    """Return exp(matrix t) at times t.

    Parameters
    ----------
    matrix : ndarray (n, n)
    times : array_like (...,)

    Returns
    -------
    ndarray (..., n, n)

    References
    ----------
    Moler & Van Loan, Nineteen dubious ways to compute the exponential of a matrix, 2003, method 3.

    >>> exponentials(np.array([[0.0, 1.0], [0.0, 0.0]]), 3.0).tolist()
    [[1.0, 3.0], [0.0, 1.0]]
    """
    t = np.asarray(times, dtype=float)
    scaled = matrix * t[..., None, None]
    norm = float(np.abs(scaled).sum(axis=-1).max(initial=0.0))
    halvings = max(0, int(np.ceil(np.log2(max(norm, 1e-300)))))
    scaled = scaled * 2.0**-halvings
    # Horner's rule for exp(X) - 1 = X (1 + X/2 (1 + X/3 (...))).
    eye = np.eye(len(matrix))
    inner = np.broadcast_to(eye, scaled.shape)
    for k in range(DEGREE, 1, -1):
        inner = eye + scaled @ inner / k
    less_one = scaled @ inner
    # Overflow gives inf or nan: the caller detects a motion that diverges.
    with np.errstate(over="ignore", invalid="ignore"):
        for _ in range(halvings):
            less_one = 2.0 * less_one + less_one @ less_one
    return np.asarray(eye + less_one)
