"""How far a tool may be from a path while a foot point that was found is certainly the nearest.

A ball that touches the path at a foot point and holds nothing else of the path proves that no point is nearer. `clearance` tabulates a
lower bound of the radius of the largest such ball, for cells of equal arc length, and for the corners. Straight stretches on both sides
of a corner, and curved ones as far as they hardly turn, are left out: beside a corner, `contourlab.metrics.streaming` tries both.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

from functools import lru_cache

import numpy as np

from contourlab.arrays import Array
from contourlab.geometry.path import Path
from contourlab.native.kernel import kernel

MOST_CELLS = 1 << 18
PARAMETERS, TABLES = ("cell_scale", "cell_last", "cell_lap", "cell_rate"), ("cell_clearance", "cell_corner", "corner_row")
CORNER_ROW = 4.0
"""Numbers of a corner before its position and both tangents: place, length before and after it that is tried, squared clearance."""
_TURN = 0.5
"""Largest turn [rad] of a curved stretch beside a corner that is tried from there."""
_NEAR = 2
"""Cells on each side of a cell in which the radius of curvature bounds the ball."""
_NOISE = 1e-10
"""Stretches that leave the tangent by less [m] do not count: a path that returns on itself is as near, not nearer."""


@lru_cache(maxsize=8)
def clearance(path: Path, window: float) -> tuple[dict[str, float], dict[str, Array]]:
    """Return parameters and tables of a path for a step: the corner of each cell and the squared clearance, and the rows of corners.

    Parameters
    ----------
    window : float [m]
        Points of the path further than this along it from a foot point do not matter.

    Notes
    -----
    ``cell_corner`` numbers the corner, or end of an open path, on whose stretches a cell lies; 0 for none.
    """
    legs, curves = np.diff(path.breaks), len(path.curves)
    radius = path.smallest_radii
    finest = min(float(legs.min()), float(radius.min()))
    n = int(np.clip(np.ceil(8.0 * path.length / finest), 64, MOST_CELLS))
    h = path.length / n
    border = np.linspace(0.0, path.length, n + 1)
    corner = path.corners if path.closed else np.unique(np.concatenate([[0.0], path.corners, [path.length]]))
    after = np.searchsorted(path.breaks[:-1], corner - 1e-12 * path.length)  # the curve that starts at each corner
    first, last = after % curves, after - 1  # on an open path one of them does not exist at an end
    starts, ends = path.closed | (after < curves), path.closed | (after > 0)
    tightest = np.minimum(np.where(starts, radius[first], np.inf), np.where(ends, radius[last], np.inf))
    ahead = np.where(starts, np.minimum(legs[first], _TURN * tightest), 0.0)
    behind = np.where(ends, np.minimum(legs[last], _TURN * tightest), 0.0)
    came = np.where(ends[:, None], path.ends[1][last], 0.0)
    goes = np.where(starts[:, None], path.starts[1][first], 0.0)
    # Smallest radius of the curves in each cell, then around it.
    bend = radius[np.clip(np.searchsorted(path.breaks, border[:-1], side="right") - 1, 0, curves - 1)]
    np.minimum.at(bend, np.minimum((path.breaks[:-1] / h).astype(int), n - 1), radius)
    wide = np.pad(bend, _NEAR, mode="wrap" if path.closed else "edge")
    around = np.lib.stride_tricks.sliding_window_view(wide, 2 * _NEAR + 1).min(axis=1)
    cell = np.arange(n)
    middle = (cell + 0.5) * h
    lap = np.array([-path.length, 0.0, path.length]) if path.closed else np.zeros(1)
    every = (corner[None, :] + lap[:, None]).ravel()
    left, right = middle - (_NEAR + 0.5) * h, middle + (_NEAR + 0.5) * h
    number = np.zeros(n, dtype=int)
    low, high = left.copy(), right.copy()
    if corner.size:
        at = np.clip(np.searchsorted(every, middle), 1, every.size - 1)
        at = np.where((middle - every[at - 1] <= every[at] - middle), at - 1, at)
        which, place = at % corner.size, every[at]
        on = (middle - 0.499 * h >= place - behind[which]) & (middle + 0.499 * h <= place + ahead[which])
        number[on] = which[on] + 1
        around = np.where(on, np.minimum(around, tightest[which]), around)
        before = middle < place
        # Beyond its corner, nothing of the near cells is left out but the stretch that is tried.
        low = np.where(on, np.where(before, np.minimum(left, place - behind[which]), place - behind[which]), left)
        high = np.where(on, np.where(before, place + ahead[which], np.maximum(right, place + ahead[which])), right)
        left, right = np.where(on & ~before, np.maximum(left, place), left), np.where(on & before, np.minimum(right, place), right)
        inside = np.searchsorted(every, right, side="left") - np.searchsorted(every, left, side="right")
        around = np.where(inside > (on & (left < place) & (place < right)), 0.0, around)
    position = path.position(border)
    turn = np.clip(np.einsum("ij,ij->i", came, goes), -1.0, 1.0)
    cone = np.where(starts & ends, np.sqrt(2.0 / np.maximum(1.0 + turn, 1e-30)), 1e30)  # at an end, any direction
    m = corner.size
    room = np.minimum(np.concatenate([around, tightest]), min(window, path.length))
    shape = np.concatenate(
        [
            np.column_stack([np.full(n, 0.5 * h), h / bend, np.ones(n)]),
            np.column_stack([np.zeros(m), np.zeros(m), cone]),
        ]
    )
    lower, upper = np.concatenate([low, corner - behind]), np.concatenate([high, corner + ahead])
    limits = np.ceil(lower / h - 1e-9).astype(int), np.floor(upper / h + 1e-9).astype(int)
    _march(
        np.ascontiguousarray(position),
        int(path.closed),
        h,
        path.position(np.concatenate([middle, corner])).copy(),
        np.concatenate([path.tangent(border[:-1]), came]),
        np.concatenate([path.tangent(np.nextafter(border[1:], 0.0)), goes]),
        shape,
        *limits,
        int(np.ceil(window / h)) + 1,
        room,
    )
    rows = np.column_stack([corner, behind, ahead, room[n:] ** 2, path.position(corner), came, goes])
    rows = np.concatenate([np.repeat([[0.0, 1e9, 0.0]], [4, path.n_axis, 2 * path.n_axis], axis=1), rows])  # 0: no corner is near
    numbers = (n / path.length, n - 1.0, path.length if path.closed else 0.0, 1.0 / path.length)
    return dict(zip(PARAMETERS, numbers, strict=True)), dict(zip(TABLES, (room[:n] ** 2, number.astype(float), rows.ravel()), strict=True))


def _away(position, closed, centre, i, k):
    """Return the distance of border k from the centre of row i."""
    n = position.shape[0] - 1
    at = k % n if closed else k
    square = 0.0
    for j in range(centre.shape[1]):
        square += (position[at, j] - centre[i, j]) ** 2
    return square**0.5


def _across(position, closed, centre, tangent, i, k):
    """Return the distance of border k from the tangent line of row i."""
    n = position.shape[0] - 1
    at = k % n if closed else k
    along, square = 0.0, 0.0
    for j in range(centre.shape[1]):
        along += tangent[i, j] * (position[at, j] - centre[i, j])
    for j in range(centre.shape[1]):
        square += (position[at, j] - centre[i, j] - along * tangent[i, j]) ** 2
    return square**0.5


@kernel("f8[:,:] i8 f8 f8[:,:] f8[:,:] f8[:,:] f8[:,:] i8[:] i8[:] i8 f8[:]")
def _march(position, closed, h, centre, first, last, shape, low, high, most, room):
    """Lower the clearance of each row (cells, then corners) by what lies before and after what it leaves out.

    A point q of the path lies in the ball of radius d that touches it at r with the normal n if |q - r|^2 < 2 d n.(q - r). A stretch of the
    length l between points the chord c apart leaves that chord by at most sqrt(l^2 - c^2)/2.
    """
    n, axes = position.shape[0] - 1, position.shape[1]
    for i in range(centre.shape[0]):
        half, bend, cone = shape[i, 0], shape[i, 1], shape[i, 2]
        split = 0.0
        for j in range(axes):
            split += (first[i, j] - last[i, j]) ** 2
        split = split**0.5
        for side in range(2):
            step = 1 - 2 * side
            k = high[i] if side == 0 else low[i]
            stop = min(most, (low[i] + n - k) if side == 0 else (k - high[i] + n)) if closed else min(most, n - k if side == 0 else k)
            done = 0
            away = _away(position, closed, centre, i, k) if stop > 0 else 0.0
            across = 0.0
            if stop > 0:
                across = max(_across(position, closed, centre, first, i, k), _across(position, closed, centre, last, i, k))
            while done < stop and room[i] > 0.0:
                jump = min(max(int(max(0.25 * away, away - half - 2.0 * room[i]) / h), 1), stop - done)
                k += step * jump
                done += jump
                length, chord = jump * h, 0.0
                a, b = (k - step * jump) % n if closed else k - step * jump, k % n if closed else k
                for j in range(axes):
                    chord += (position[a, j] - position[b, j]) ** 2
                noise = 1e-15 * (away + length + 1.0) * length
                bulge = 0.5 * max(length * length - chord - noise, 0.0) ** 0.5
                away_next = _away(position, closed, centre, i, k)
                across_next = max(_across(position, closed, centre, first, i, k), _across(position, closed, centre, last, i, k))
                nearest = max(max(0.5 * (away + away_next - length), away - length) - half, 0.0)
                furthest = max(away, away_next) + length + half
                off = cone * (max(across, across_next) + bulge) + bend * furthest + half * split
                if off > 1e-10:
                    room[i] = min(room[i], 0.5 * nearest * max(nearest / off, 1.0))
                away, across = away_next, across_next
