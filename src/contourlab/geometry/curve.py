"""What a curve is: a smooth map from arc length to position."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import GeometryError

__all__ = ["Curve", "by_arc_length"]

Array = NDArray[np.float64]


class Curve(ABC):
    """A smooth curve by its arc length, from 0 to `length`.

    Attributes
    ----------
    n_axis : int
        Number of coordinates.
    length : float [m], > 0
    """

    n_axis: int
    length: float

    @abstractmethod
    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        """Return position and derivatives by arc length.

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

    @abstractmethod
    def describe(self) -> tuple[object, ...]:
        """Return all the numbers that make the curve, for its digest."""

    def position(self, s: ArrayLike) -> Array:
        """Return positions (n, n_axis) [m]."""
        return np.asarray(self.derivatives(s, 0)[0])

    def smallest_radius(self) -> float:
        """Return an estimate of the smallest curvature radius [m], from samples; infinite for a line."""
        bend = np.linalg.norm(self.derivatives(np.linspace(0.0, self.length, 257), 2)[2], axis=1).max()
        return float(1.0 / bend) if bend > 0.0 else float("inf")


def vector(values: ArrayLike, name: str) -> Array:
    """Return a finite vector of one or more coordinates.

    Raises
    ------
    GeometryError
        If it is not.
    """
    try:
        found = np.array(values, dtype=float)
    except (TypeError, ValueError):
        found = np.empty(0)
    if found.ndim != 1 or found.size < 1 or not np.isfinite(found).all():
        raise GeometryError(f"{name} = {values!r}: a vector of finite coordinates is wanted")
    return found


def by_arc_length(raw: Array, order: int) -> Array:
    """Turn derivatives by any parameter into derivatives by arc length, by the chain rule.

    Parameters
    ----------
    raw : ndarray (order + 1, n, n_axis)
        r and its derivatives by the parameter u.
    order : int, 0 to 3
    """
    found = np.empty_like(raw[: order + 1])
    found[0] = raw[0]
    if order == 0:
        return found
    first = raw[1]
    square = np.einsum("ij,ij->i", first, first)
    p = (1.0 / np.sqrt(square))[:, None]  # du/ds
    found[1] = first * p
    if order == 1:
        return found
    along = np.einsum("ij,ij->i", first, raw[2])
    q = (-along / square**2)[:, None]  # d2u/ds2
    found[2] = raw[2] * p**2 + first * q
    if order == 2:
        return found
    change = np.einsum("ij,ij->i", raw[2], raw[2]) + np.einsum("ij,ij->i", first, raw[3])
    w = ((4.0 * along**2 / square**3 - change / square**2)[:, None]) * p  # d3u/ds3
    found[3] = raw[3] * p**3 + 3.0 * raw[2] * p * q + first * w
    return found
