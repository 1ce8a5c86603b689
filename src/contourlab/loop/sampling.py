"""The samples of a reference for the compiled engine: the same numbers as `Reference.block` but for rounding, several times faster."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.engine.sampler import CURVE_FIELDS, along_curves, along_spans
from contourlab.feed import Reference
from contourlab.feed.profile import Profile

__all__ = ["sample_compiled"]

Array = NDArray[np.float64]


def sample_compiled(reference: Reference, start: int, stop: int, rows: Array) -> None:
    """Fill rows (3 n_axis + 2, stop - start) of a planned reference, as `Reference.block` lays them out."""
    assert reference.profile is not None  # recorded positions are not sampled
    path, n = reference.path, stop - start
    progress, speed, acceleration = rows[-2], rows[-1], np.empty(n)
    along_spans(
        _spans(reference.profile, reference.servo_period, start, stop), reference.servo_period, start, progress, speed, acceleration
    )
    first_lap, last_lap = (int(x // path.length) for x in (progress[0], progress[-1])) if path.closed else (0, 0)
    lap = np.repeat(np.arange(first_lap, last_lap + 1), len(path.curves))
    curve = np.tile(np.arange(len(path.curves)), last_lap + 1 - first_lap)
    offset = lap * path.length + path.breaks[curve]
    # A joint belongs to the curve that begins there; before the first and after the last one the end curves go on.
    border = np.concatenate([[0], np.searchsorted(progress, offset[1:], side="left"), [n]])
    used = np.flatnonzero(np.diff(border) > 0)
    table, plain = path.coefficients(curve[used])
    records = np.column_stack([border[used], border[used + 1], offset[used], table])
    assert records.shape[1] == len(CURVE_FIELDS) + 4 * path.n_axis
    along_curves(records[plain], progress, speed, acceleration, rows[:-2])
    for i in used[~plain]:
        cut = slice(border[i], border[i + 1])
        _on_curve(reference, progress[cut], speed[cut], acceleration[cut], rows[:-2, cut])


def _spans(profile: Profile, period: float, start: int, stop: int) -> Array:
    """Return the records of the spans that samples lie in; samples are counted from `start`. The motion stands still after its end."""
    t0 = np.append(profile.t0, profile.duration)
    first = np.ceil(t0 / period)
    first += first * period < t0
    first -= (first - 1.0) * period >= t0
    border = np.clip(np.append(first, stop), start, stop) - start
    border[0] = 0.0
    ends = np.append(profile.s0[1:], [profile.length] * 2)
    parts = (np.append(part, last) for part, last in ((profile.s0, profile.length), (profile.v0, 0.0), (profile.a0, 0.0), (profile.j, 0.0)))
    records = np.column_stack([border[:-1], border[1:], t0, *parts, ends])
    return np.asarray(records[np.diff(border) > 0])


def _on_curve(reference: Reference, progress: Array, speed: Array, acceleration: Array, rows: Array) -> None:
    """Splines and other curves, as `Reference.block` does them."""
    n = reference.n_axis
    position, first, second = reference.path.derivatives(progress, 2).transpose(0, 2, 1)
    rows[:n], rows[n : 2 * n] = position, first * speed
    rows[2 * n :] = second * speed**2 + first * acceleration
