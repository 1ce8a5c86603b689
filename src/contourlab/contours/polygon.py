"""Properties of a curve from the polygon of its points: corners, straight stretches, tangents, largest bulge."""

from __future__ import annotations

import math
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from contourlab.arrays import Array, Flags
from contourlab.geometry.curve import angle_between

Kind = TypeVar("Kind", np.float64, np.bool_)
LONG = 4.0
"""Least ratio of a long chord to its neighbour."""
LONGER = 2.0
"""Least ratio of a chord that may be straight because the bend beside it clearly ends there."""
INLINE = 1e-3
"""Largest turn [rad] within a straight stretch of several chords."""
NOISE = 50.0
"""Least length of a straight stretch, in tolerances; shorter chords may be noise."""
TINY = 1e-300
NEIGHBOURS = 4
"""Points on the finer side whose turns give the bend there."""
MARGIN = 1.5
"""Largest bulge of a curve, relative to the arc with the same turns at its ends."""
STEEP = math.radians(45.0)
"""Where the polygon turns by less, the curve must not run against its chord."""


class Polygon:
    """Points and the chords between them.

    Parameters
    ----------
    points : ndarray (n, n_axis) [m]
        Neighbours differ; in a closed polygon the last is the first.
    corner_angle : float [rad]
        Larger turns are corners, whose two sides are independent.
    tolerance : float [m]
        Error of the points.

    Attributes
    ----------
    length, direction : ndarray (n - 1,), (n - 1, n_axis)
        Length and direction of the chords; chord i runs from point i to i + 1.
    turn : ndarray (n,) [rad]
        Turn of the polygon at each point; 0 at the ends of an open one and at corners.
    corners : list of int
        In a closed polygon 0 is its first and last point.
    """

    def __init__(self, points: Array, closed: bool, corner_angle: float, tolerance: float) -> None:
        self.points, self.closed, self.tolerance = points, closed, tolerance
        chords = np.diff(points, axis=0)
        self.length = np.linalg.norm(chords, axis=1)
        self.direction = chords / self.length[:, None]
        before, after = self._sides(self.direction)
        self.turn = angle_between(before, after)
        if not closed:
            self.turn[[0, -1]] = 0.0
        sharp = self.turn > corner_angle
        self.corners = [int(i) for i in np.flatnonzero(sharp[:-1])]
        self.turn[sharp] = 0.0
        self._shut = sharp
        if not closed:
            self._shut[[0, -1]] = True
        self._look()

    def _sides(self, of_chords: Array) -> tuple[Array, Array]:
        """Return values of the chords before and after each point; at the ends of an open polygon, that of the other end."""
        return np.concatenate([of_chords[-1:], of_chords]), np.concatenate([of_chords, of_chords[:1]])

    def _shifted(self, of_points: NDArray[Kind], by: int) -> NDArray[Kind]:
        """Return the values of the points `by` places on, around a closed polygon; 0 or False past the ends of an open one."""
        if self.closed:
            rolled = np.roll(of_points[:-1], -by, axis=0)
            return np.asarray(np.concatenate([rolled, rolled[:1]]))
        n, shifted = len(of_points), np.zeros_like(of_points)
        shifted[max(-by, 0) : max(n - by, 0)] = of_points[max(by, 0) : max(n + by, 0)]
        return shifted

    def _look(self) -> None:
        """Set the tangents at each point from the three points before it, and after it, and the bends of both sides."""
        before, after = self._sides(self.direction)
        h_before, h_after = self._sides(self.length)
        n, least = len(self.points), np.minimum(h_before, h_after)
        self._tangents: list[Array] = []
        self._bends: list[Array] = []
        for by, near, h in ((-1, before, h_before), (1, after, h_after)):
            far, h_far = self._shifted(near, by), self._shifted(h, by)
            angle = self._shifted(self.turn, by)
            known = ~self._shifted(self._shut, by) & (h_far > 0.0)
            share = np.divide(h, h + h_far, out=np.zeros(n), where=known)
            self._tangents.append(_turned_on(far, near, np.where(known, angle, 0.0), share))
            bend, open_ = np.where(known, 0.0, self.turn), np.ones(n, dtype=bool)
            for k in range(1, NEIGHBOURS + 1):
                open_ &= ~self._shifted(self._shut, k * by)
                turn = self._shifted(self.turn, k * by) * np.minimum(1.0, h / np.maximum(self._shifted(least, k * by), TINY))
                bend = np.where(open_, np.maximum(bend, turn), bend)
            self._bends.append(bend)
        # Angles between a chord and the tangents of the finer side at its start and end.
        self._off_start = angle_between(self._tangents[0][:-1], self.direction)
        self._off_end = angle_between(self._tangents[1][1:], self.direction)

    def _finer(self) -> tuple[Array, Array]:
        """Return the ratios of each chord to the ones before and after it; 0 across corners and ends."""
        before, after = self._sides(self.length)
        low = np.where(self._shut[:-1], 0.0, self.length / before[:-1])
        high = np.where(self._shut[1:], 0.0, self.length / after[1:])
        return low, high

    def straights(self) -> list[tuple[int, int]]:
        """Return the straight stretches as pairs of chords (first, last); across the start of a closed polygon last < first.

        A stretch is one long chord, or several in line, beside much shorter chords whose bend ends where it starts: their tangent there is
        that of the stretch, within the uncertainty of the bend. If their arc continued along the long chord, the tangent would differ by
        half the ratio of lengths times the turn between their points.
        """
        low, high = self._finer()
        start = (low >= LONGER) & (self._off_start <= _leeway(low) * self._bends[0][:-1] + 1e-6)
        end = (high >= LONGER) & (self._off_end <= _leeway(high) * self._bends[1][1:] + 1e-6)
        long = self.length >= NOISE * self.tolerance
        noisy = self.tolerance / np.minimum(*self._sides(self.length))
        inline = (self.turn <= INLINE + 4.0 * noisy) & (noisy * NOISE <= 1.0) & ~self._shut
        n = len(self.length)
        inline[1:] &= ~end
        # A stretch runs from its start over points in line to the first that is not, or where it ends.
        halts = np.flatnonzero(~inline)
        stretches: list[tuple[int, int]] = []
        reached = 0
        for i in np.flatnonzero((start | self._shut[:-1]) & long).tolist():
            k = int(np.searchsorted(halts, i + 1))
            if i < reached or not halts.size:
                continue
            last = int(halts[k]) if k < halts.size else int(halts[0]) + n
            chord = (last - 1) % n
            if (end[chord] or self._shut[chord + 1]) and (start[i] or end[chord]) and long[chord] and last - i <= n:
                stretches.append((i, chord))
                reached = last
        return stretches

    def jumps(self) -> list[tuple[int, int]]:
        """Return where a chord is much longer than its neighbour, as pairs (point, number of the long chord)."""
        low, high = self._finer()
        before, after = self._sides(self.length)
        sure = NOISE * self.tolerance
        starts = [(int(i), int(i)) for i in np.flatnonzero((low >= LONG) & (before[:-1] >= sure))]
        return starts + [(int(i) + 1, int(i)) for i in np.flatnonzero((high >= LONG) & (after[1:] >= sure))]

    def span(self, first: int, last: int) -> Array:
        """Return the points from `first` to `last`; past the start of a closed polygon the numbers continue."""
        points, n = self.points, len(self.length)
        return points[first : last + 1] if last <= n else np.concatenate([points[first:-1], points[: last - n + 1]])

    def tangent(self, i: int) -> Array:
        """Return the tangent at a point between chords: of a much finer side if there is one, else of an arc through three points."""
        n = len(self.length)
        before, after = (i - 1) % n, i % n
        ratio = self.length[after] / self.length[before]
        if ratio >= LONG and self._off_start[after] <= self.turn[i]:
            return np.asarray(self._tangents[0][i])
        if ratio <= 1.0 / LONG and self._off_end[before] <= self.turn[i]:
            return np.asarray(self._tangents[1][i])
        mean = self.length[after] * self.direction[before] + self.length[before] * self.direction[after]
        return np.asarray(mean / np.linalg.norm(mean))

    def bulges(self) -> tuple[Array, Flags]:
        """Return the largest distance [m] of a curve from each chord (n - 1,), and where it must not run against the chord.

        An arc that turns by a over a chord of length c leaves it by c a / 8. Half of a turn at a point belongs to the chord if its
        neighbour is equally long, all of it if the chord is much longer. The weight of turns halves with each point in between.
        """
        low, high = self._finer()
        start = np.where(low >= LONG, np.minimum(self.turn[:-1], self._off_start + 0.25 * self._bends[0][:-1]), self.turn[:-1])
        end = np.where(high >= LONG, np.minimum(self.turn[1:], self._off_end + 0.25 * self._bends[1][1:]), self.turn[1:])
        own = self.length * np.maximum(start, end)
        before, after = self._sides(self.length)
        turn = self._spread(self.turn)
        size = self._spread(self.turn * np.maximum(before, after))
        far = np.minimum(self.length * np.maximum(turn[:-1], turn[1:]), np.maximum(size[:-1], size[1:])) * 0.5
        # For a long chord `own` already holds the turns at its ends.
        far = np.where((low >= LONG) | (high >= LONG), 0.0, far)
        return 0.25 * MARGIN * np.maximum(own, far) + 1e-6 * self.length + 1e-10, np.maximum(turn[:-1], turn[1:]) < STEEP

    def _spread(self, of_points: Array) -> Array:
        """Return the largest value near each point; its weight halves with each point in between."""
        spread = of_points
        for step in (1, 2, 4, 8, 16):
            spread = np.maximum(spread, 0.5**step * np.maximum(self._shifted(spread, step), self._shifted(spread, -step)))
        return spread


def _leeway(ratio: Array) -> Array:
    """Return the permitted angle between a straight stretch and the tangent of the finer side, in turns of that side."""
    return np.where(ratio < LONG, 0.15 * ratio, np.minimum(ratio / 3.0, 3.0))


def _turned_on(a: Array, b: Array, angle: Array, share: Array) -> Array:
    """Return b rotated further from a, in their plane, by a fraction of the angle between them."""
    small = np.sin(angle) < 1e-9
    size = np.where(small, 1.0, np.sin(angle))
    back = np.where(small, 0.0, np.sin(share * angle) / size)
    on = np.where(small, 1.0, np.sin((1.0 + share) * angle) / size)
    return np.asarray(on[:, None] * b - back[:, None] * a)
