"""Backlash of both axes from a circular test: the steps at the quadrants, separated from all else that shapes a circle.

With the angle phi, s = 1 counter-clockwise and -1 clockwise, and the two axes x and y, the radial deviation of a circle is, to first order,
the sum of known signatures:

=====================  ==================================================  =========================================================
cause                  error of the axes                                   radial deviation
=====================  ==================================================  =========================================================
centre, radius         constant; feed and lag                              a cos phi + b sin phi + r
scale mismatch         e_x = c x/2, e_y = -c y/2                           (c R/2) cos 2 phi
squareness             e_x = q y                                           (q R/2) sin 2 phi
servo mismatch         e_x = -T_x v_x, e_y = -T_y v_y                      s (T_x - T_y) v/2 sin 2 phi
backlash of x          e_x = -sgn(v_x) b_x/2                               s sgn(sin phi) cos phi b_x/2
backlash of y          e_y = -sgn(v_y) b_y/2                               -s sgn(cos phi) sin phi b_y/2
=====================  ==================================================  =========================================================

Backlash that differs between the two ends of an axis, b(x) = b + d x/R, adds the signatures of d with one more cosine or sine. Squareness
and servo mismatch are one in a single run; runs in both senses tell them apart.

Friction that a controller gives way to by the same length in either direction looks like backlash, from whichever side it is measured. Seen
on the motor's own encoder it is all there is; on the load it comes on top of the gap.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import ParameterError, ResultError
from contourlab.metrics.circles import CircleFigures

Array = NDArray[np.float64]

SHARED = ("radius", "centre_x", "centre_y", "scale")
BACKLASH = ("x", "x_slope", "y", "y_slope")
LEAST_SAMPLES = 60
WIDEST_HOLE = math.radians(12.0)
"""Widest stretch without a sample that is counted."""


@dataclass(frozen=True, slots=True)
class QuadrantStep:
    """One place where an axis reverses, in one run.

    Attributes
    ----------
    axis : str
    clockwise : bool
        Sense of the run.
    angle : float [rad]
        Of the reversal: 0, pi/2, pi or 3 pi/2.
    step, deviation : float [m]
        Backlash of the axis there, positive outwards in the direction of the run, from the fit over all runs; and its standard deviation.
    spike_height : float [m]
        Largest distance of the radial deviation from the fit around the reversal, signed: positive outwards.
    spike_width : float [rad]
        Angle over which the distance keeps its sign and stays above half the height.
    """

    axis: str
    clockwise: bool
    angle: float
    step: float
    deviation: float
    spike_height: float
    spike_width: float


@dataclass(frozen=True, eq=False)
class CircleBacklash:
    """Parts of the radial deviation of a circle, run in one sense or both.

    Attributes
    ----------
    axes : (str, str)
    backlash, deviation : (float, float) [m]
        Mean backlash of each axis, positive where the measured side lags behind its motor; and its standard deviation.
    quadrants : tuple of QuadrantStep
        Each reversal of each run, by angle.
    mean_radial : float [m]
        Mean radial deviation without the other signatures.
    centre : (float, float) [m]
        Of the circle, from the nominal centre.
    scale_mismatch : float
        c: by how much more the first axis travels than the second, over the travel.
    squareness : float [rad]
        q: positive where the angle between the positive axes is less than a right one; nan in a single sense.
    servo_mismatch : float [m]
        (T_x - T_y) v: by how far the first axis lags behind more than the second; nan in a single sense.
    diagonal : float [m]
        (q R + s (T_x - T_y) v)/2 of a single run, whose parts it cannot tell apart; nan in both senses.
    residual : float [m]
        Root mean square of what is left outside the reversals.
    """

    axes: tuple[str, str]
    backlash: tuple[float, float]
    deviation: tuple[float, float]
    quadrants: tuple[QuadrantStep, ...]
    mean_radial: float
    centre: tuple[float, float]
    scale_mismatch: float
    squareness: float
    servo_mismatch: float
    diagonal: float
    residual: float


def backlash_from_circle(
    position: ArrayLike,
    centre: ArrayLike,
    radius: float,
    *,
    opposite: ArrayLike | None = None,
    axes: tuple[str, str] = ("x", "y"),
    before: float = math.radians(2.0),
    after: float = math.radians(15.0),
) -> CircleBacklash:
    """Return the backlash of both axes from the measured positions of a full circle.

    Parameters
    ----------
    position : array_like (n, 2) [m]
        One turn or more, in one sense.
    centre : array_like (2,) [m]
    radius : float [m]
        Nominal, > 0.
    opposite : array_like (m, 2) [m], optional
        The same circle in the other sense.
    axes : (str, str)
        Names.
    before, after : float [rad]
        Samples from `before` to `after` a reversal are left out of the fit, and searched for its spike; >= 0,
        together at most 60 degrees.

    Raises
    ------
    ResultError
        If the points are no full circle around the centre in one sense, are too few or not finite, or `opposite` has the same sense.
    ParameterError
        If radius or angles are out of range.
    """
    runs = [_run(position, centre, radius)]
    if opposite is not None:
        runs.append(_run(opposite, centre, radius))
    return backlash_of_runs(runs, axes=axes, before=before, after=after)


def backlash_of_runs(
    runs: Sequence[CircleFigures],
    *,
    axes: tuple[str, str] = ("x", "y"),
    before: float = math.radians(2.0),
    after: float = math.radians(15.0),
) -> CircleBacklash:
    """Return the backlash from runs around one circle, as `circle_figures` or `circles_of` give them: at most one in each sense.

    The standard deviations are those of least squares, widened for residuals that follow from one sample to the next (first-order
    autocorrelation).

    Raises
    ------
    ResultError
        If there are more runs than senses, the radii differ, or what is outside the reversals does not go round.
    ParameterError
        If the angles are out of range.
    """
    if not (0.0 <= before < math.inf and 0.0 <= after < math.inf and before + after <= math.pi / 3.0):
        raise ParameterError("before and after", f"{before:g} and {after:g}", "0 or more, and together 60 degrees at most", "rad")
    senses = {run.clockwise for run in runs}
    if not runs or len(senses) != len(runs):
        raise ResultError(f"{len(runs)} runs in {len(senses)} senses: give one run, or one in each sense")
    if max(run.radius for run in runs) - min(run.radius for run in runs) > 1e-9:
        raise ResultError("the runs have different radii: give runs around one circle")
    radius = runs[0].radius
    pieces = [_signatures(run) for run in runs]
    kept = [_outside(run, before, after) for run in runs]
    for run, use in zip(runs, kept, strict=True):
        _check_cover(run, use, before + after)
    found, covariance = _fit(runs, pieces, kept)
    slopes = [_steps_at(found, covariance, len(SHARED) + 2 * axis) for axis in (0, 1)]
    quadrants, squares, count = [], 0.0, 0
    for run, columns, use in zip(runs, pieces, kept, strict=True):
        rest = run.deviation - columns @ found[: columns.shape[1]] - _diagonal(run, found[columns.shape[1] :], len(runs))
        squares, count = squares + float(rest[use] @ rest[use]), count + int(use.sum())
        quadrants += _quadrants(run, rest, before, after, axes, slopes)
    tail = found[len(SHARED) + len(BACKLASH) :]
    both = len(runs) == 2
    spread = np.sqrt(np.diag(covariance))
    first = len(SHARED)
    return CircleBacklash(
        axes=axes,
        backlash=(float(found[first]), float(found[first + 2])),
        deviation=(float(spread[first]), float(spread[first + 2])),
        quadrants=tuple(sorted(quadrants, key=lambda q: (q.clockwise, q.angle))),
        mean_radial=float(found[0]),
        centre=(float(found[1]), float(found[2])),
        scale_mismatch=2.0 * float(found[3]) / radius,
        squareness=2.0 * float(tail[0]) / radius if both else math.nan,
        servo_mismatch=2.0 * float(tail[1]) if both else math.nan,
        diagonal=math.nan if both else float(tail[0]),
        residual=math.sqrt(squares / count),
    )


def _run(position: ArrayLike, centre: ArrayLike, radius: float) -> CircleFigures:
    """Return one run with its angles and radial deviations; without the other figures."""
    points, middle = np.asarray(position, dtype=float), np.asarray(centre, dtype=float)
    if points.ndim != 2 or points.shape[1] != 2 or middle.shape != (2,):
        raise ResultError(f"points of shape {points.shape} around a centre of shape {middle.shape}: must be (n, 2) and (2,)")
    if not 0.0 < radius < math.inf:
        raise ParameterError("radius", radius, "finite and > 0", "m")
    if len(points) < LEAST_SAMPLES:
        raise ResultError(f"a circle of {len(points)} samples: give at least {LEAST_SAMPLES}")
    if not (np.isfinite(points).all() and np.isfinite(middle).all()):
        raise ResultError("points or centre hold numbers that are not finite")
    out = points - middle
    distance = np.linalg.norm(out, axis=1)
    if np.abs(distance - radius).max() > 0.2 * radius:
        raise ResultError(f"points between {distance.min():.6g} m and {distance.max():.6g} m from the centre: no circle of {radius:.6g} m")
    angle = np.arctan2(out[:, 1], out[:, 0])
    turned = float(np.unwrap(angle)[-1] - angle[0])
    if abs(turned) < 2.0 * math.pi - WIDEST_HOLE:
        raise ResultError(f"points that go round by {math.degrees(turned):.4g} degrees: give a full circle in one sense")
    away = distance - radius
    figures = (math.nan, math.nan, float(away.max()), float(away.min()), float(away.mean()))
    return CircleFigures("", turned < 0.0, radius, angle, away, *figures)


def _signatures(run: CircleFigures) -> Array:
    """Return the columns of `SHARED` and `BACKLASH`, (n, 8)."""
    c, s = np.cos(run.angle), np.sin(run.angle)
    sense = -1.0 if run.clockwise else 1.0
    x, y = 0.5 * sense * np.sign(s) * c, -0.5 * sense * np.sign(c) * s
    return np.column_stack([np.ones(c.shape), c, s, c * c - s * s, x, x * c, y, y * s])


def _diagonal(run: CircleFigures, found: Array, n_run: int) -> Array:
    """Return what squareness and servo mismatch do; of a single run their sum."""
    wave = np.sin(2.0 * run.angle)
    return np.asarray(wave * found[0] if n_run == 1 else wave * (found[0] + (-1.0 if run.clockwise else 1.0) * found[1]))


def _fit(runs: Sequence[CircleFigures], pieces: list[Array], kept: list[NDArray[np.bool_]]) -> tuple[Array, Array]:
    """Return the coefficients and their covariance."""
    unit = np.eye(len(runs))
    rows = [np.column_stack([piece, *(_diagonal(run, one, len(runs)) for one in unit)]) for run, piece in zip(runs, pieces, strict=True)]
    design = np.concatenate([row[use] for row, use in zip(rows, kept, strict=True)])
    values = np.concatenate([run.deviation[use] for run, use in zip(runs, kept, strict=True)])
    inverse = np.linalg.pinv(design)
    found = inverse @ values
    rest = values - design @ found
    square = float(rest @ rest)
    follows = float(rest[1:] @ rest[:-1]) / square if square > 0.0 else 0.0
    follows = min(max(follows, 0.0), 1.0 - 1.0 / len(values))
    variance = square / (len(values) - design.shape[1]) * (1.0 + follows) / (1.0 - follows)
    return found, variance * (inverse @ inverse.T)


def _steps_at(found: Array, covariance: Array, i: int) -> dict[float, tuple[float, float]]:
    """Return the step and its deviation at the positive and the negative end of an axis: b + d and b - d."""
    steps = {}
    for end in (1.0, -1.0):
        row = np.array([1.0, end])
        steps[end] = float(row @ found[i : i + 2]), math.sqrt(float(row @ covariance[i : i + 2, i : i + 2] @ row))
    return steps


def _past(run: CircleFigures, angle: float) -> Array:
    """Return how far each sample is past an angle in the sense of the run, from -pi to pi."""
    past = (run.angle - angle) * (-1.0 if run.clockwise else 1.0)
    return np.asarray(past - 2.0 * math.pi * np.rint(past / (2.0 * math.pi)))


def _outside(run: CircleFigures, before: float, after: float) -> NDArray[np.bool_]:
    """Tell which samples are away from all reversals."""
    use = np.ones(run.angle.shape, dtype=bool)
    for i in range(4):
        past = _past(run, 0.5 * math.pi * i)
        # At the angle of a reversal itself the signature is undefined.
        use &= ~((past >= -before) & (past <= after)) & (past != 0.0)
    return use


def _check_cover(run: CircleFigures, use: NDArray[np.bool_], left_out: float) -> None:
    """Refuse a run that leaves a part of the circle out."""
    angles = np.sort(np.mod(run.angle[use], 2.0 * math.pi))
    if len(angles) < LEAST_SAMPLES // 2:
        raise ResultError(f"{len(angles)} samples outside the reversals: give at least {LEAST_SAMPLES // 2}")
    holes = np.diff(angles, append=angles[0] + 2.0 * math.pi)
    over = np.diff(np.floor(angles / (0.5 * math.pi)), append=4.0) > 0.0
    hole = float((holes - left_out * over).max())
    if hole > WIDEST_HOLE:
        raise ResultError(f"{math.degrees(hole):.3g} degrees without a sample that counts: give samples all around the circle")


def _quadrants(
    run: CircleFigures, rest: Array, before: float, after: float, axes: tuple[str, str], slopes: list[dict[float, tuple[float, float]]]
) -> list[QuadrantStep]:
    found = []
    for i in range(4):
        past = _past(run, 0.5 * math.pi * i)
        near = np.flatnonzero((past >= -before) & (past <= after))
        near = near[np.argsort(past[near], kind="stable")]
        step, deviation = slopes[i % 2][1.0 if i < 2 else -1.0]
        height, width = _spike(past[near], rest[near])
        found.append(QuadrantStep(axes[i % 2], run.clockwise, 0.5 * math.pi * i, step, deviation, height, width))
    return found


def _spike(past: Array, rest: Array) -> tuple[float, float]:
    """Return the height and the width at half the height of the largest departure."""
    if not len(rest):
        return 0.0, 0.0
    peak = int(np.argmax(np.abs(rest)))
    if rest[peak] == 0.0:
        return 0.0, 0.0
    below = np.flatnonzero(rest / rest[peak] < 0.5)
    left, right = below[below < peak], below[below > peak]
    first = int(left[-1]) + 1 if len(left) else 0
    last = int(right[0]) - 1 if len(right) else len(rest) - 1
    spacing = float(past[-1] - past[0]) / max(len(past) - 1, 1)
    return float(rest[peak]), float(past[last] - past[first]) + spacing
