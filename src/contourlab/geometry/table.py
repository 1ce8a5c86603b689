"""The engine's view of a path: quintic pieces in arc length, found without a branch.

Each piece matches position, tangent and curvature vector of the path at both its ends, and never crosses a joint of two curves. The
remainder of
quintic Hermite interpolation over a piece of length h is at most h^6 max|r^(6)| / 46080: proven in closed form for lines (0) and for arcs
and helices, r^(6) = R rate^6; for other curves pieces are halved until the difference from the curve at points inside, doubled, is
below the tolerance.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import GeometryError
from contourlab.geometry.arc import Arc
from contourlab.geometry.curve import Curve
from contourlab.geometry.line import Line
from contourlab.geometry.path import Path

__all__ = ["MOST_CELLS", "PathTable", "path_table"]

Array = NDArray[np.float64]
MOST_CELLS = 8_000_000
_PROBES = np.array([0.14, 0.3, 0.5, 0.7, 0.86])


@dataclass(frozen=True, eq=False)
class PathTable:
    """Quintic pieces of a path.

    Attributes
    ----------
    start : ndarray (n_piece + 1,) [m]
        Arc length at which each piece begins; the last is the path's length.
    coefficients : ndarray (n_piece, n_axis, 6)
        Of powers of the arc length from the piece's start.
    cell : ndarray (n_cell,)
        First piece that touches each of n_cell equal cells of arc length. No cell holds more than one beginning of a piece inside it, so a
        look-up is one division and one comparison: ``i = cell[int(s * inverse_cell)]; i += s >= start[i + 1]``.
    inverse_cell : float [1/m]
    error_bound : float [m]
        Largest distance of the table from the path.
    length : float [m]
    closed : bool
    """

    start: Array
    coefficients: Array
    cell: Array
    inverse_cell: float
    error_bound: float
    length: float
    closed: bool

    def evaluate(self, s: ArrayLike, order: int = 2) -> Array:
        """Return position and derivatives up to `order`, 0 to 2: ndarray (order + 1, n, n_axis)."""
        along = np.atleast_1d(np.asarray(s, dtype=float))
        along = along - self.length * np.floor(along / self.length) if self.closed else along
        along = np.clip(along, 0.0, self.length)
        cell = np.minimum((along * self.inverse_cell).astype(np.int64), len(self.cell) - 1)
        piece = self.cell[cell].astype(np.int64)
        piece = np.minimum(piece + (along >= self.start[piece + 1]), len(self.coefficients) - 1)
        h = (along - self.start[piece])[:, None]
        c = np.moveaxis(self.coefficients[piece], 2, 0)
        found = [c[0] + h * (c[1] + h * (c[2] + h * (c[3] + h * (c[4] + h * c[5]))))]
        if order > 0:
            found.append(c[1] + h * (2.0 * c[2] + h * (3.0 * c[3] + h * (4.0 * c[4] + h * 5.0 * c[5]))))
        if order > 1:
            found.append(2.0 * c[2] + h * (6.0 * c[3] + h * (12.0 * c[4] + h * 20.0 * c[5])))
        return np.array(found)


def path_table(path: Path, tolerance: float, pieces: int = 1) -> PathTable:
    """Return the table of a path.

    Parameters
    ----------
    path : Path
    tolerance : float [m], > 0
    pieces : int
        At least so many pieces, evenly spread.

    Raises
    ------
    GeometryError
        If the tolerance is not positive, or the shortest piece is too short for a table of 8 million cells.
    """
    if not tolerance > 0.0:
        raise GeometryError(f"tolerance = {tolerance!r}: must be > 0 m")
    longest = path.length / max(pieces, 1) * (1.0 + 1e-12)
    owner, left, right, bound = [], [], [], 0.0
    for i, curve in enumerate(path.curves):
        marks, worst = _divide(curve, tolerance, longest)
        owner.append(np.full(len(marks) - 1, i))
        left.append(marks[:-1])
        right.append(marks[1:])
        bound = max(bound, worst)
    index, a, b = np.concatenate(owner), np.concatenate(left), np.concatenate(right)
    coefficients = _hermite(path._at(index, a, 2), path._at(index, b, 2), b - a)
    start = np.concatenate([path.breaks[index] + a, [path.length]])
    cell, inverse = _cells(start, path.length)
    return PathTable(start, coefficients, cell, inverse, bound, path.length, path.closed)


def _hermite(low: Array, high: Array, h: Array) -> Array:
    """Return quintic coefficients (n, n_axis, 6) from value, slope and second derivative (3, n, n_axis) at both ends."""
    width = h[:, None]
    rise = high[0] - low[0] - width * low[1] - 0.5 * width**2 * low[2]
    slope = high[1] - low[1] - width * low[2]
    bend = high[2] - low[2]
    c3 = (10.0 * rise - 4.0 * width * slope + 0.5 * width**2 * bend) / width**3
    c4 = (-15.0 * rise + 7.0 * width * slope - width**2 * bend) / width**4
    c5 = (6.0 * rise - 3.0 * width * slope + 0.5 * width**2 * bend) / width**5
    return np.ascontiguousarray(np.stack([low[0], low[1], 0.5 * low[2], c3, c4, c5], axis=2))


def _divide(curve: Curve, tolerance: float, longest: float) -> tuple[Array, float]:
    """Return piece ends along a curve, and a bound of the error."""
    least = max(int(np.ceil(curve.length / longest - 1e-9)), 1)
    if isinstance(curve, Line):
        return np.linspace(0.0, curve.length, least + 1), 0.0
    if isinstance(curve, Arc):
        sixth = curve.radius * abs(curve.rate) ** 6
        n = max(least, int(np.ceil(curve.length * (sixth / (46080.0 * tolerance)) ** (1.0 / 6.0))))
        return np.linspace(0.0, curve.length, n + 1), sixth * (curve.length / n) ** 6 / 46080.0
    return _bisect(curve, tolerance, longest)


def _bisect(curve: Curve, tolerance: float, longest: float) -> tuple[Array, float]:
    marks = getattr(curve, "_marks", np.array([0.0, curve.length]))
    # Each stretch is divided by itself: marks of two kinds laid over each other would leave slivers between them.
    n = np.maximum(np.ceil(np.diff(marks) / longest - 1e-9), 1.0).astype(np.int64)
    part = np.arange(n.sum()) - np.repeat(np.cumsum(n) - n, n)
    marks = np.append(np.repeat(marks[:-1], n) + part * np.repeat(np.diff(marks) / n, n), curve.length)
    left, right = marks[:-1], marks[1:]
    # Below the digits of the curve itself, halving would go on for ever.
    digits = 1e-13 * curve.length + 16.0 * np.finfo(float).eps * float(np.abs(curve.position(marks)).max())
    if tolerance < digits:
        raise GeometryError(f"{type(curve).__name__}: no table of quintic pieces reaches {tolerance:g} m; {digits:.2g} m is within reach")
    done: list[Array] = []
    worst = 0.0
    for _ in range(40):
        c = _hermite(curve.derivatives(left, 2), curve.derivatives(right, 2), right - left)
        probe = (right - left)[:, None] * _PROBES
        exact = curve.derivatives((left[:, None] + probe).ravel(), 0)[0].reshape(*probe.shape, -1)
        table = sum(c[:, None, :, k] * probe[:, :, None] ** k for k in range(6))
        error = 2.0 * np.linalg.norm(table - exact, axis=2).max(axis=1)
        good = error <= tolerance
        worst = max(worst, float(error[good].max(initial=0.0)))
        done.append(left[good])
        middle = 0.5 * (left + right)
        left, right = np.concatenate([left[~good], middle[~good]]), np.concatenate([middle[~good], right[~good]])
        if left.size == 0:
            return np.append(np.sort(np.concatenate(done)), curve.length), worst
    raise GeometryError(f"{type(curve).__name__}: no table of quintic pieces reaches {tolerance:g} m")


def _cells(start: Array, length: float) -> tuple[Array, float]:
    shortest = float(np.diff(start).min())
    n = int(np.ceil(length / shortest)) + 1
    if n > MOST_CELLS:
        where = float(start[int(np.argmin(np.diff(start)))])
        raise GeometryError(
            f"a piece of {shortest:.3g} m at arc length {where:.6g} m is too short for a path of {length:.6g} m: "
            f"join what is shorter than {length / MOST_CELLS:.3g} m"
        )
    inverse = n / length
    # The piece of a cell's left edge, by the same rounding that a look-up makes.
    cell = np.searchsorted(start[:-1] * inverse, np.arange(n), side="right") - 1
    return np.maximum(cell, 0).astype(float), inverse
