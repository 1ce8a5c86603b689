"""Cuts splines, above all where their curvature jumps.

Where a knot stands m times, a spline of degree p has p - m continuous derivatives: with m >= p - 1 the curvature may jump there. A planner
has to know of such places, so they become joints of a path.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.geometry.curve import Curve, by_arc_length
from contourlab.geometry.nurbs import BSpline, Nurbs

Array = NDArray[np.float64]
JUMP = 1e-7
"""Of the curvature, or of one over the curve's length: smaller jumps are rounding."""


def inner_knots(degree: int, t: Array) -> tuple[Array, NDArray[np.int64]]:
    """Return the knots inside the curve, and how often each stands."""
    inner, count = np.unique(t[(t > t[degree]) & (t < t[-degree - 1])], return_counts=True)
    return inner, count


def cut_where_curvature_jumps(curve: BSpline | Nurbs) -> list[Curve]:
    """Return a spline in pieces in which the curvature is continuous; the spline itself where it is so throughout.

    Parameters
    ----------
    curve : BSpline or Nurbs

    Returns
    -------
    list of Curve
        End to end.
    """
    degree, t = curve.degree, curve.knots
    inner, count = inner_knots(degree, t)
    inner = inner[count >= max(degree - 1, 1)]
    if not inner.size:
        return [curve]
    before, after = (by_arc_length(curve.raw(u, 2), 2)[2] for u in (np.nextafter(inner, -np.inf), inner))
    size = np.maximum(np.maximum(np.linalg.norm(before, axis=1), np.linalg.norm(after, axis=1)), 1.0 / curve.length)
    places = inner[np.linalg.norm(after - before, axis=1) > JUMP * size]
    if not places.size:
        return [curve]
    if isinstance(curve, BSpline):
        return [BSpline(degree, points, knots) for points, knots in split_at(degree, curve.points, t, places)]
    lifted = np.column_stack([curve.points * curve.weights[:, None], curve.weights])
    pieces = split_at(degree, lifted, t, places)
    return [Nurbs(degree, points[:, :-1] / points[:, -1:], knots, points[:, -1]) for points, knots in pieces]


def _insert(degree: int, points: Array, t: Array, u: float) -> tuple[Array, Array]:
    """Insert a knot once: Boehm's algorithm; The NURBS Book, 2nd ed., eq. (5.15)."""
    k, stands = int(np.searchsorted(t, u, side="right")) - 1, int(np.count_nonzero(t == u))
    i = np.arange(k - degree + 1, k - stands + 1)
    alpha = ((u - t[i]) / (t[i + degree] - t[i]))[:, None]
    between = alpha * points[i] + (1.0 - alpha) * points[i - 1]
    fresh = np.concatenate([points[: k - degree + 1], between, points[k - stands :]])
    return fresh, np.concatenate([t[: k + 1], [u], t[k + 1 :]])


def split_at(degree: int, points: Array, t: Array, places: Array) -> list[tuple[Array, Array]]:
    """Cut a spline at parameters inside it.

    Parameters
    ----------
    degree : int
    points : ndarray (n, m)
        Control points; of a rational spline times their weights, with the weights beside them.
    t : ndarray (n + degree + 1,)
    places : ndarray of float
        Rising.

    Returns
    -------
    list of (points, knots)
    """
    found: list[tuple[Array, Array]] = []
    for u in places:
        while np.count_nonzero(t == u) < degree:
            points, t = _insert(degree, points, t, float(u))
        k = int(np.searchsorted(t, u))  # the first of `degree` equal knots; the curve passes through point k - 1
        found.append((points[:k], np.append(t[: k + degree], u)))
        points, t = points[k - 1 :], np.concatenate([[u], t[k:]])
    return [*found, (points, t)]
