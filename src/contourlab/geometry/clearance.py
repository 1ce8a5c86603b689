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

CELLS, CELLS_OF_CURVE = (64, 1 << 14, 1 << 20), 32
"""Fewest cells; most of a path of few curves, and of any; and what each curve adds to the former."""
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
    legs, radius, m = np.diff(path.breaks), path.smallest_radii, len(path.curves)
    n = int(np.clip(np.ceil(8.0 * path.length / min(legs.min(), radius.min())), CELLS[0], min(CELLS[1] + CELLS_OF_CURVE * m, CELLS[2])))
    h, laps = path.length / n, path.length * np.arange(-1, 2) if path.closed else np.zeros(1)
    corner = np.append(0.0, path.corners if path.closed else np.unique([0.0, *path.corners, path.length]))
    after = np.searchsorted(path.breaks[:-1], corner - 1e-12 * path.length)  # the curve that starts at each corner
    sides = ((after - 1, path.closed | (after > 0), path.ends), (after % m, path.closed | (after < m), path.starts))
    tightest = np.min([np.where(there, radius[curve], np.inf) for curve, there, _ in sides], axis=0)
    behind, ahead = (np.where(there, np.minimum(legs[curve], _TURN * tightest), 0.0) for curve, there, _ in sides)
    came, goes = (np.where(there[:, None], edge[1][curve], 0.0) for curve, there, edge in sides)
    border, middle = h * np.arange(n + 1), h * (np.arange(n) + 0.5)
    room = radius[path.curve_index(border[:-1])]
    np.minimum.at(room, np.minimum((path.breaks[:-1] / h).astype(int), n - 1), radius)
    room = np.min([np.roll(room, k) for k in range(-_NEAR, _NEAR + 1)], axis=0)
    every = np.concatenate([[-1e9], (corner[1:] + laps[:, None]).ravel(), [1e9]])
    owner = np.concatenate([[0], np.tile(np.arange(1, corner.size), laps.size), [0]])
    at = np.searchsorted(0.5 * (every[1:] + every[:-1]), middle)
    number, place = owner[at], every[at]
    on = (middle - 0.499 * h >= place - behind[number]) & (middle + 0.499 * h <= place + ahead[number]) & (number > 0)
    number, before = np.where(on, number, 0), middle < place
    left, right = middle - (_NEAR + 0.5) * h, middle + (_NEAR + 0.5) * h
    # Beyond its corner, nothing of the near cells is left out but the stretch that is tried.
    low, high = np.where(on, place - behind[number], left), np.where(on, place + ahead[number], right)
    low, high = np.where(before, np.minimum(low, left), low), np.where(before, high, np.maximum(high, right))
    left, right = np.where(on & ~before, np.maximum(left, place), left), np.where(on & before, np.minimum(right, place), right)
    alone = np.searchsorted(every, right) <= np.searchsorted(every, left, side="right")
    room = np.concatenate([np.where(alone, np.minimum(room, np.where(on, tightest[number], np.inf)), 0.0), tightest])
    room = np.minimum(room, min(window, path.length))
    _march(
        path.position(h * np.arange(-n * path.closed, n + n * path.closed + 1)).copy(),
        n * int(path.closed),
        h,
        n,
        path.position(np.concatenate([middle, corner])).copy(),
        np.concatenate([path.tangent(border[:-1]), came]).copy(),
        np.concatenate([path.tangent(np.nextafter(border[1:], 0.0)), goes]).copy(),
        np.ceil(np.concatenate([low, corner - behind]) / h - 1e-9).astype(int),
        np.floor(np.concatenate([high, corner + ahead]) / h + 1e-9).astype(int),
        int(np.ceil(window / h)) + 1,
        room,
    )
    rows = np.column_stack([corner, behind, ahead, room[n:] ** 2, path.position(corner), came, goes])
    rows[0] = np.repeat([0.0, 1e9, 0.0], [4, path.n_axis, 2 * path.n_axis])
    numbers = (n / path.length, n - 1.0, path.length if path.closed else 0.0, 1.0 / path.length)
    return dict(zip(PARAMETERS, numbers, strict=True)), dict(zip(TABLES, (room[:n] ** 2, number.astype(float), rows.ravel()), strict=True))


def _seen(position, centre, first, last, k, i):
    """Return the distances of border k from the centre of row i and, at most, from its tangent lines."""
    square, on_first, on_last, off_first, off_last = 0.0, 0.0, 0.0, 0.0, 0.0
    for j in range(centre.shape[1]):
        gap = position[k, j] - centre[i, j]
        square, on_first, on_last = square + gap * gap, on_first + first[i, j] * gap, on_last + last[i, j] * gap
    for j in range(centre.shape[1]):
        gap = position[k, j] - centre[i, j]
        off_first += (gap - on_first * first[i, j]) ** 2
        off_last += (gap - on_last * last[i, j]) ** 2
    return square**0.5, max(off_first, off_last) ** 0.5


@kernel("f8[:,:] i8 f8 i8 f8[:,:] f8[:,:] f8[:,:] i8[:] i8[:] i8 f8[:]")
def _march(position, lap, h, n, centre, first, last, low, high, most, room):
    """Lower the clearance of each row (cells, then corners) by what lies before and after what it leaves out.

    A point q of the path lies in the ball of radius d that touches it at r with the normal n if |q - r|^2 < 2 d n.(q - r). A stretch of the
    length l between points the chord c apart leaves that chord by at most sqrt(l^2 - c^2)/2.
    """
    for i in range(centre.shape[0]):
        half, cosine = 0.5 * h if i < n else 0.0, 0.0
        bend = 2.0 * half / max(room[i], 1e-30)
        for j in range(centre.shape[1]):
            cosine += first[i, j] * last[i, j]
        # Normals between those of both tangents.
        cone, split = (2.0 / max(1.0 + cosine, 1e-15)) ** 0.5, max(2.0 - 2.0 * cosine, 0.0) ** 0.5
        for side in range(2):
            step, k = 1 - 2 * side, lap + (high[i] if side == 0 else low[i])
            left = min(most, (low[i] + n + lap if lap else n) - k if side == 0 else k - (high[i] - n + lap if lap else 0))
            if left > 0:
                away, across = _seen(position, centre, first, last, k, i)
            while left > 0 and room[i] > 0.0:
                jump = min(max(int(max(0.25 * away, away - half - 2.0 * room[i]) / h), 1), left)
                length, chord = jump * h, 0.0
                for j in range(centre.shape[1]):
                    chord += (position[k, j] - position[k + step * jump, j]) ** 2
                k, left = k + step * jump, left - jump
                bulge = 0.5 * max(length * length - chord - 1e-15 * (away + length + 1.0) * length, 0.0) ** 0.5
                away_next, across_next = _seen(position, centre, first, last, k, i)
                nearest = max(max(0.5 * (away + away_next - length), away - length) - half, 0.0)
                off = cone * (max(across, across_next) + bulge) + bend * (max(away, away_next) + length + half) + half * split
                if off > _NOISE:
                    room[i] = min(room[i], 0.5 * nearest * max(nearest / off, 1.0))
                away, across = away_next, across_next
