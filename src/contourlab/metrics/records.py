"""Checks of measured records and of options, shared by the metrics."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array
from contourlab.errors import ParameterError, ResultError


def records(**values: ArrayLike) -> list[Array]:
    """Return records (n,) as float arrays.

    Raises
    ------
    ResultError
        If they are not vectors of one length, are empty, or are not finite.
    """
    arrays, names = [np.asarray(value, dtype=float) for value in values.values()], " and ".join(values)
    if arrays[0].ndim != 1 or len({array.shape for array in arrays}) > 1:
        shapes = " and ".join(str(array.shape) for array in arrays)
        raise ResultError(f"{names} have shapes {shapes}: give one number per sample, the same number of samples")
    if not arrays[0].size:
        raise ResultError(f"{names} hold no samples")
    if not all(np.isfinite(array).all() for array in arrays):
        raise ResultError(f"{names} hold values that are not finite")
    return arrays


def check_positive(name: str, value: float, unit: str, *, or_zero: bool = False) -> None:
    """Raise a ParameterError unless a value is finite and > 0, or 0 if that is allowed."""
    if not (0.0 < value < math.inf or (or_zero and value == 0.0)):
        raise ParameterError(name, value, f"finite and {'>= 0' if or_zero else '> 0'}", unit)
