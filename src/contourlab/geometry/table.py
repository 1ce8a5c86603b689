"""A path as quintic pieces in arc length, for the engine, with a branch-free look-up.

Each piece matches position, tangent and curvature vector of the path at both ends and lies on one curve. The error of quintic Hermite
interpolation over a length h is at most h^6 max|r^(6)| / 46080. For lines (|r^(6)| = 0), arcs and helices (|r^(6)| = R rate^6) this gives
the number of pieces. Other curves are halved until twice the error at points inside is below the tolerance. All curves of a kind are
divided at once.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index, ranges
from contourlab.errors import GeometryError, refuse
from contourlab.geometry.curve import CurveBatch, CurveSequence
from contourlab.native.kernel import kernel

MOST_CELLS = 8_000_000
_FREE_CELLS = 1 << 20
"""Number of cells always permitted; larger tables need enough pieces to justify their memory."""
_PROBES = np.array([0.14, 0.3, 0.5, 0.7, 0.86])


@dataclass(frozen=True, eq=False)
class PathTable:
    """Quintic pieces of a path.

    Attributes
    ----------
    start : ndarray (n_piece + 1,) [m]
        Arc length at which each piece starts; the last is the length of the path.
    coefficients : ndarray (n_piece, n_axis, 6) [m, 1, 1/m ...]
        Of powers of the arc length from the start of the piece.
    cell : ndarray (n_cell + 1,)
        First piece that touches each of n_cell equal cells of arc length, and the last piece. If at most one piece starts inside each
        cell, a look-up is ``i = cell[int(s * inverse_cell)]; i += s >= start[i + 1]``.
    inverse_cell : float [1/m]
    halvings : int
        0 for this look-up; else the number of bisections between the pieces ``cell[i]`` and ``cell[i + 1]``, for paths whose shortest
        pieces would need too many cells.
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
    halvings: int = 0

    def evaluate(self, s: ArrayLike, order: int = 2) -> Array:
        """Return position and derivatives up to `order`, 0 to 2: ndarray (order + 1, n, n_axis)."""
        along = np.atleast_1d(np.asarray(s, dtype=float))
        along = along - self.length * np.floor(along * (1.0 / self.length)) if self.closed else along
        along = np.clip(along, 0.0, self.length)
        found = np.empty((order + 1, along.size, self.coefficients.shape[1]))
        look_up(along, self.inverse_cell, self.halvings, self.start, self.coefficients, self.cell, order, found)
        return found


@kernel("f8[:] f8 i8 f8[:] f8[:,:,:] f8[:] i8 f8[:,:,:]")
def look_up(along, inverse_cell, halvings, start, coefficients, cell, order, found):  # type: ignore[no-untyped-def]
    """Evaluate pieces at arc lengths (n,), with the steps of the engine's look-up: derivatives into `found` (order + 1, n, n_axis)."""
    n_piece, axes = coefficients.shape[0], coefficients.shape[1]
    for i in range(along.size):
        s = along[i]
        number = min(int(s * inverse_cell), cell.size - 2)
        piece = int(cell[number])
        if halvings == 0:
            piece = min(piece + 1 if s >= start[piece + 1] else piece, n_piece - 1)
        else:
            last = int(cell[number + 1])
            for _ in range(halvings):
                middle = (piece + last + 1) // 2
                if s >= start[middle]:
                    piece = middle
                else:
                    last = max(middle - 1, piece)
        h = s - start[piece]
        for j in range(axes):
            c1, c2, c3 = coefficients[piece, j, 1], coefficients[piece, j, 2], coefficients[piece, j, 3]
            c4, c5 = coefficients[piece, j, 4], coefficients[piece, j, 5]
            found[0, i, j] = coefficients[piece, j, 0] + h * (c1 + h * (c2 + h * (c3 + h * (c4 + h * c5))))
            if order > 0:
                found[1, i, j] = c1 + h * (2.0 * c2 + h * (3.0 * c3 + h * (4.0 * c4 + h * 5.0 * c5)))
            if order > 1:
                found[2, i, j] = 2.0 * c2 + h * (6.0 * c3 + h * (12.0 * c4 + h * 20.0 * c5))


def path_table(path: CurveSequence, tolerance: float, pieces: int = 1, arcs: float = 1.0) -> PathTable:
    """Return the table of a path.

    Parameters
    ----------
    tolerance : float [m], > 0
    pieces : int
        Least number of pieces, evenly spread.
    arcs : float, > 0
        Share of the tolerance for arcs: a hundredth takes twice their pieces.

    Raises
    ------
    GeometryError
        If the tolerance is not positive, or below the rounding of a curve.
    """
    _, start, coefficients, bound = table_pieces(path, tolerance, pieces, arcs)
    cell, inverse, halvings = _cells(start, path.length)
    return PathTable(start, coefficients, cell, inverse, bound, path.length, path.closed, halvings)


def table_pieces(path: CurveSequence, tolerance: float, pieces: int = 1, arcs: float = 1.0) -> tuple[Index, Array, Array, float]:
    """Return curve, start and coefficients of the pieces of a table, and the bound of its error; arguments as of `path_table`."""
    refuse(not tolerance > 0.0, GeometryError, f"tolerance = {tolerance!r}: must be > 0 m")
    longest = path.length / max(pieces, 1) * (1.0 + 1e-12)
    parts, bound = [], 0.0
    for batch, numbers in path.kinds:
        slot, left, right, worst = _bisect(batch, tolerance, longest) if batch.sixth is None else _evenly(batch, arcs * tolerance, longest)
        parts.append((numbers[slot], left, right))
        bound = max(bound, worst)
    index, a, b = (np.concatenate(column) for column in zip(*parts, strict=True))
    if len(parts) > 1:
        order = np.lexsort([a, index])
        index, a, b = index[order], a[order], b[order]
    coefficients = _hermite(path.at(index, a, 2), path.at(index, b, 2), b - a)
    return index, np.concatenate([path.breaks[index] + a, [path.length]]), coefficients, bound


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


def _spread(n: Index) -> tuple[Index, Index]:
    """Number the n pieces of each curve: return the curve of each piece, and its number within the curve."""
    return np.repeat(np.arange(n.size), n), ranges(np.zeros_like(n), n)


def _evenly(curves: CurveBatch, tolerance: float, longest: float) -> tuple[Index, Array, Array, float]:
    """Return pieces of curves with a known sixth derivative: curve, both ends, and a bound of the error."""
    assert curves.sixth is not None  # the caller checks
    least = np.maximum(np.ceil(curves.length / longest - 1e-9), 1.0)
    n = np.maximum(least, np.ceil(curves.length * (curves.sixth / (46080.0 * tolerance)) ** (1.0 / 6.0)))
    width = curves.length / n
    slot, part = _spread(n.astype(np.int64))
    right = np.where(part + 1 == n[slot], curves.length[slot], (part + 1) * width[slot])
    return slot, part * width[slot], right, float((curves.sixth * width**6).max() / 46080.0)


def _first_pieces(curves: CurveBatch, tolerance: float, longest: float) -> tuple[Index, Array, Array]:
    marks, count = curves.marks()
    owner = np.repeat(np.arange(count.size), count)
    inner = owner[1:] == owner[:-1]
    slot, low, high = owner[:-1][inner], marks[:-1][inner], marks[1:][inner]
    # Divide each interval separately: two overlaid sets of marks would leave slivers.
    n = np.maximum(np.ceil((high - low) / longest - 1e-9), 1.0)
    interval, part = _spread(n.astype(np.int64))
    step = ((high - low) / n)[interval]
    left = low[interval] + part * step
    right = np.where(part + 1 == n[interval], high[interval], low[interval] + (part + 1) * step)
    # Below the rounding of the curve, halving would never end.
    digits = 1e-13 * curves.length[owner] + 16.0 * np.finfo(float).eps * np.abs(curves.derivatives(owner, marks, 0)[0]).max(axis=0)
    if tolerance < digits.max():
        name = type(curves.curve(int(owner[int(np.argmax(digits))]))).__name__
        raise GeometryError(f"{name}: no table of quintic pieces reaches {tolerance:g} m; {digits.max():.2g} m is possible")
    return slot[interval], left, right


def _bisect(curves: CurveBatch, tolerance: float, longest: float) -> tuple[Index, Array, Array, float]:
    """Return pieces of other curves, halved until each is good: curve, both ends, and the largest error."""
    slot, left, right = _first_pieces(curves, tolerance, longest)
    done: list[tuple[Index, Array, Array]] = []
    worst = 0.0
    for _ in range(40):
        error = _errors(curves, slot, left, right)
        good = error <= tolerance
        worst = max(worst, float(error[good].max(initial=0.0)))
        done.append((slot[good], left[good], right[good]))
        slot, low, high = slot[~good], left[~good], right[~good]
        if slot.size == 0:
            index, a, b = (np.concatenate(column) for column in zip(*done, strict=True))
            order = np.lexsort([a, index])
            return index[order], a[order], b[order], worst
        middle = 0.5 * (low + high)
        slot, left, right = np.concatenate([slot, slot]), np.concatenate([low, middle]), np.concatenate([middle, high])
    raise GeometryError(f"{type(curves.curve(int(slot[0]))).__name__}: no table of quintic pieces reaches {tolerance:g} m")


def _errors(curves: CurveBatch, slot: Index, left: Array, right: Array) -> Array:
    """Return twice the largest difference (n,) [m] between pieces and their curves at places inside."""
    low, high = (curves.derivatives(slot, at, 2).transpose(0, 2, 1) for at in (left, right))
    c = _hermite(low, high, right - left)
    probe = (right - left)[:, None] * _PROBES
    exact = curves.derivatives(np.repeat(slot, _PROBES.size), (left[:, None] + probe).ravel(), 0)[0].reshape(-1, *probe.shape)
    square = np.zeros(probe.shape)
    for j, places in enumerate(exact):
        table = np.zeros(probe.shape)
        for k in range(5, -1, -1):
            table = table * probe + c[:, j, k, None]
        square += (table - places) ** 2
    return np.asarray(2.0 * np.sqrt(square.max(axis=1)))


def _cells(start: Array, length: float) -> tuple[Array, float, int]:
    """Return the first piece of each cell and the last piece, the inverse length of a cell, and the halvings of a look-up."""
    pieces = len(start) - 1
    wanted = np.ceil(length / float(np.diff(start).min())) + 1.0
    plain = wanted <= min(MOST_CELLS, max(_FREE_CELLS, 64 * pieces))
    n = int(wanted) if plain else min(max(8 * pieces, 4096), MOST_CELLS)
    inverse = n / length
    # Find the piece at the left edge of each cell with the rounding of a look-up.
    cell = np.maximum(np.searchsorted(start[:-1] * inverse, np.arange(n), side="right") - 1, 0)
    cell = np.append(cell, pieces - 1)
    return cell.astype(float), inverse, 0 if plain else int(np.diff(cell).max()).bit_length()
