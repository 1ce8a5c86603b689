"""Sample a reference for the compiled engine: equal to `Reference.block` up to rounding, and several times faster."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.engine.sampler import CURVE_FIELDS, along_curves, along_spans
from contourlab.feed import Reference
from contourlab.feed.reference import Profile, along_path
from contourlab.geometry import Path


def sample_compiled(reference: Reference, start: int, stop: int, rows: Array) -> None:
    """Fill rows (3 n_axis + 2, stop - start) of a planned reference, as `Reference.block` lays them out."""
    assert reference.profile is not None  # recorded positions are not sampled
    path, n = reference.path, stop - start
    progress, speed, acceleration = rows[-2], rows[-1], np.empty(n)
    spans = _spans(reference.profile, reference.servo_period, start, stop)
    along_spans(spans, reference.servo_period, start, progress, speed, acceleration)
    curve, offset = _in_reach(path, progress)
    # A junction belongs to the curve that begins there; the end curves are extended beyond the first and last one.
    border = np.concatenate([[0], np.searchsorted(progress, offset[1:], side="left"), [n]])
    used = np.flatnonzero(np.diff(border) > 0)
    table, plain = path.coefficients(curve[used])
    records = np.column_stack([border[used], border[used + 1], offset[used], table])
    assert records.shape[1] == len(CURVE_FIELDS) + 4 * path.n_axis
    along_curves(records[plain], progress, speed, acceleration, rows[:-2])
    if not plain.all():
        # Sample all other curves at once: a blended path has thousands.
        others = np.zeros(n + 1, dtype=np.int64)
        np.add.at(others, border[used[~plain]], 1)
        np.add.at(others, border[used[~plain] + 1], -1)
        cut = np.flatnonzero(np.cumsum(others[:-1]))
        kinematics = np.empty((len(rows) - 2, cut.size))
        along_path(path, progress[cut], speed[cut], acceleration[cut], kinematics)
        rows[:-2, cut] = kinematics


def _in_reach(path: Path, progress: Array) -> tuple[Index, Array]:
    """Return the curves under samples of ascending progress, one more at each end, and the progress at which each begins."""
    m, ends = len(path.curves), progress[[0, -1]]
    lap = np.floor(ends / path.length).astype(np.int64) if path.closed else np.zeros(2, dtype=np.int64)
    first, last = lap * m + path.curve_index(ends) + (-1, 1)
    lap, curve = np.divmod(np.arange(first, last + 1) if path.closed else np.arange(max(first, 0), min(last, m - 1) + 1), m)
    return curve, lap * path.length + path.breaks[curve]


def _spans(profile: Profile, period: float, start: int, stop: int) -> Array:
    """Return the records of the spans under the samples, which count from `start`. After its end the motion is at rest."""
    low, high = np.searchsorted(profile.t0, [start * period, stop * period], side="right")
    part = slice(max(int(low) - 1, 0), int(high))
    t0 = np.append(profile.t0[part], profile.duration)
    first = np.ceil(t0 / period)
    first += first * period < t0
    first -= (first - 1.0) * period >= t0
    border = np.clip(np.append(first, stop), start, stop) - start
    border[0] = 0.0
    last = ((profile.s0, profile.length), (profile.v0, 0.0), (profile.a0, 0.0), (profile.j, 0.0), (profile.ends, profile.length))
    parts = [np.append(values[part], still) for values, still in last]
    return np.asarray(np.column_stack([border[:-1], border[1:], t0, *parts])[np.diff(border) > 0])
