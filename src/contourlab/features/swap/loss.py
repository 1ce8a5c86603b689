"""What a swap loses."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
FULL = 0.03
"""Largest swap loss that counts as full modularity."""


def losses(values: ArrayLike, best: ArrayLike, floor: float) -> Array:
    """Return what each variant loses, (J - J*) / max(J*, J_tol).

    Parameters
    ----------
    values, best : array_like (..., n_variant)
        J under a shared design, and J*, the best that any search found for the variant.
    floor : float, > 0
        J_tol: below it a ratio says nothing.

    >>> losses([3.0, 12.0], [1.0, 10.0], 2.0).tolist()
    [1.0, 0.2]
    """
    known = np.asarray(best, dtype=float)
    return np.asarray((np.asarray(values, dtype=float) - known) / np.maximum(known, floor))


def swap_loss(values: ArrayLike, best: ArrayLike, floor: float) -> float:
    """Return the largest loss over the variants."""
    return float(losses(values, best, floor).max())
