"""The curves of a path as arrays, so that samples on many lines and arcs are evaluated together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from contourlab.geometry.arc import Circular
from contourlab.geometry.checks import Array, Index
from contourlab.geometry.curve import Curve
from contourlab.geometry.line import Line

__all__ = ["CIRCULAR", "LINE", "OTHER", "Packed", "pack"]

LINE, CIRCULAR, OTHER = 0, 1, 2


@dataclass(frozen=True, eq=False)
class Packed:
    """Curves by kind; `row` says where among its kind a curve stands.

    Attributes
    ----------
    kind, row : ndarray (n_curve,)
    length : ndarray (n_curve,) [m]
    line_start, line_direction : ndarray (n_line, n_axis)
    centre, x_axis, y_axis, climb : ndarray (n_circular, n_axis)
    radius, start_angle, rate : ndarray (n_circular,)
    others : tuple of Curve
    """

    n_axis: int
    kind: Index
    row: Index
    length: Array
    line_start: Array
    line_direction: Array
    centre: Array
    x_axis: Array
    y_axis: Array
    climb: Array
    radius: Array
    start_angle: Array
    rate: Array
    others: tuple[Curve, ...]

    def derivatives(self, curve: Index, s: Array, order: int, left: bool = False) -> Array:
        """Evaluate curve `curve` (n,) at its own arc length `s` (n,), within the curve; (order + 1, n, n_axis)."""
        kind = self.kind[curve]
        result = np.empty((order + 1, s.size, self.n_axis))
        present = [k for k in (LINE, CIRCULAR, OTHER) if (kind == k).any()]
        for k in present:
            where = slice(None) if len(present) == 1 else np.flatnonzero(kind == k)
            if k == LINE:
                result[:, where] = self._lines(self.row[curve[where]], s[where], order)
            elif k == CIRCULAR:
                result[:, where] = self._circular(self.row[curve[where]], s[where], order)
            else:
                result[:, where] = self._others(self.row[curve[where]], s[where], order, left)
        return result

    def _lines(self, row: Index, s: Array, order: int) -> Array:
        direction = self.line_direction[row]
        result = np.zeros((order + 1, s.size, self.n_axis))
        np.multiply(direction, s[:, None], out=result[0])
        result[0] += self.line_start[row]
        if order > 0:
            result[1] = direction
        return result

    def _circular(self, row: Index, s: Array, order: int) -> Array:
        rate = self.rate[row]
        angle = self.start_angle[row] + rate * s
        x, y, climb = self.x_axis[row], self.y_axis[row], self.climb[row]
        size = self.radius[row]
        c, d = (size * np.cos(angle))[:, None], (size * np.sin(angle))[:, None]
        result = np.empty((order + 1, s.size, self.n_axis))
        turn = rate[:, None]
        for k in range(order + 1):
            result[k] = c * x + d * y
            c, d = -d * turn, c * turn
        result[0] += self.centre[row] + climb * s[:, None]
        if order > 0:
            result[1] += climb
        return result

    def _others(self, row: Index, s: Array, order: int, left: bool) -> Array:
        result = np.empty((order + 1, s.size, self.n_axis))
        if row[0] == row[-1] and (row == row[0]).all():
            result[...] = self.others[row[0]].derivatives(s, order, left=left)
            return result
        by_row = np.argsort(row, kind="stable")
        ordered = row[by_row]
        edges = np.flatnonzero(np.diff(ordered)) + 1
        for group in np.split(by_row, edges):
            result[:, group] = self.others[row[group[0]]].derivatives(s[group], order, left=left)
        return result


def _table(vectors: list[Array], n_axis: int) -> Array:
    return np.array(vectors) if vectors else np.empty((0, n_axis))


def pack(curves: Sequence[Curve], n_axis: int) -> Packed:
    """Return the curves as arrays."""
    lines: list[Line] = []
    circular: list[Circular] = []
    others: list[Curve] = []
    kinds, rows = [], []
    for curve in curves:
        if isinstance(curve, Line):
            kinds.append(LINE)
            rows.append(len(lines))
            lines.append(curve)
        elif isinstance(curve, Circular):
            kinds.append(CIRCULAR)
            rows.append(len(circular))
            circular.append(curve)
        else:
            kinds.append(OTHER)
            rows.append(len(others))
            others.append(curve)
    return Packed(
        n_axis,
        np.array(kinds, dtype=np.intp),
        np.array(rows, dtype=np.intp),
        np.array([curve.length for curve in curves]),
        _table([line.start for line in lines], n_axis),
        _table([line.direction for line in lines], n_axis),
        _table([arc.centre for arc in circular], n_axis),
        _table([arc.x_axis for arc in circular], n_axis),
        _table([arc.y_axis for arc in circular], n_axis),
        _table([arc.climb for arc in circular], n_axis),
        np.array([arc.radius for arc in circular]),
        np.array([arc.start_angle for arc in circular]),
        np.array([arc.rate for arc in circular]),
        tuple(others),
    )
