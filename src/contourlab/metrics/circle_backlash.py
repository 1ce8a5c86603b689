"""Backlash of both axes from a circular test: the steps at the quadrants, separated from other errors.

With the angle phi, s = 1 counter-clockwise and -1 clockwise, and the axes x and y, the radial deviation of a circle is, to first order, the
sum of these signatures:

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

Backlash that varies along an axis, b(x) = b + d x/R, adds signatures of d with one more cosine or sine. Only runs in both senses separate
squareness from servo mismatch.

A friction-induced deflection of equal size in both directions looks like backlash. A motor encoder shows only this deflection; a load
scale shows it in addition to the gap.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags
from contourlab.errors import ParameterError, ResultError
from contourlab.metrics.circles import CircleFigures
from contourlab.metrics.records import check_positive

X, Y, DIAGONAL = 4, 6, 8
"""Columns of the design: radius, centre (x, y), scale; backlash of x and its slope, of y and its slope; squareness and servo mismatch."""
LEAST_SAMPLES = 60
WIDEST_HOLE = math.radians(12.0)
"""Widest permitted gap between counted samples."""


@dataclass(frozen=True, slots=True)
class QuadrantStep:
    """A reversal of an axis in one run.

    Attributes
    ----------
    axis : str
    clockwise : bool
        Sense of the run.
    angle : float [rad]
        0, pi/2, pi or 3 pi/2.
    step, deviation : float [m]
        Backlash of the axis there, from the fit over all runs, and its standard deviation.
    spike_height : float [m]
        Largest difference between the radial deviation and the fit near the reversal, positive outwards, beside `crossing` if the load
        stays while the motor crosses the gap.
    spike_width : float [rad]
        Angle over which the difference stays above half the height.
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
    """Components of the radial deviation of a circle, run in one sense or both.

    Attributes
    ----------
    axes : (str, str)
    backlash, deviation : (float, float) [m]
        Mean backlash of each axis, positive where the measured side lags behind its motor; and its standard deviation.
    quadrants : tuple of QuadrantStep
        Each reversal of each run, by angle.
    mean_radial : float [m]
        Mean radial deviation.
    centre : (float, float) [m]
        Centre of the circle, from the nominal centre.
    scale_mismatch : float
        c: scale error of the first axis less that of the second.
    squareness : float [rad]
        q: right angle less the angle between the positive axes; nan for a single sense.
    servo_mismatch : float [m]
        (T_x - T_y) v: lag of the first axis less that of the second; nan for a single sense.
    diagonal : float [m]
        (q R + s (T_x - T_y) v)/2 of a single run; nan for both senses.
    residual : float [m]
        Root mean square of the residual outside the reversals.
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
    """Return the backlash of both axes from measured positions on a full circle.

    Parameters
    ----------
    position : array_like (n, 2) [m]
        At least one turn, in one sense.
    centre : array_like (2,) [m]
    radius : float [m]
        Nominal, > 0.
    opposite : array_like (n, 2) [m], optional
        The same circle in the other sense.
    axes : (str, str)
        Names.
    before, after : float [rad], >= 0
        The fit omits samples from `before` a reversal to `after` it, where the spike is; together at most 60 degrees.

    Returns
    -------
    CircleBacklash

    Raises
    ------
    ResultError
        If the points are not a full circle around the centre in one sense, are too few or not finite, or `opposite` has the same sense.
    ParameterError
        If radius or angles are out of range.
    """
    runs = [_run(points, centre, radius) for points in (position, opposite) if points is not None]
    return backlash_of_runs(runs, axes=axes, before=before, after=after)


def backlash_of_runs(
    runs: Sequence[CircleFigures],
    *,
    axes: tuple[str, str] = ("x", "y"),
    before: float = math.radians(2.0),
    after: float = math.radians(15.0),
) -> CircleBacklash:
    """Return the backlash from runs around one circle, from `circle_figures` or `circles_of`: at most one in each sense.

    The standard deviations are those of least squares, corrected for first-order autocorrelation of the residual.

    Parameters
    ----------
    runs : sequence of CircleFigures
    axes : (str, str)
        Names.
    before, after : float [rad], >= 0
        The fit omits samples from `before` a reversal to `after` it, where the spike is; together at most 60 degrees.

    Returns
    -------
    CircleBacklash

    Raises
    ------
    ResultError
        If there are two runs in one sense, the radii differ, or samples outside the reversals are missing.
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
    both = len(runs) == 2
    designs = [_signatures(run, both) for run in runs]
    used = [outside(run.angle, run.clockwise, before, after) for run in runs]
    for run, use in zip(runs, used, strict=True):
        _check_cover(run, use, before + after)
    fit, covariance = _fit(
        np.concatenate([design[use] for design, use in zip(designs, used, strict=True)]),
        np.concatenate([run.deviation[use] for run, use in zip(runs, used, strict=True)]),
    )
    steps = [_steps_at(fit, covariance, column) for column in (X, Y)]
    quadrants, squares, count = [], 0.0, 0
    for run, design, use in zip(runs, designs, used, strict=True):
        diagonal = fit[DIAGONAL] + (-1.0 if run.clockwise else 1.0) * fit[DIAGONAL + 1] if both else fit[DIAGONAL]
        rest = run.deviation - design[:, :DIAGONAL] @ fit[:DIAGONAL] - design[:, DIAGONAL] * diagonal
        squares, count = squares + float(rest[use] @ rest[use]), count + int(use.sum())
        quadrants += _quadrants(run, rest, before, after, axes, steps)
    deviation = np.sqrt(np.diag(covariance))
    return CircleBacklash(
        axes=axes,
        backlash=(float(fit[X]), float(fit[Y])),
        deviation=(float(deviation[X]), float(deviation[Y])),
        quadrants=tuple(sorted(quadrants, key=lambda q: (q.clockwise, q.angle))),
        mean_radial=float(fit[0]),
        centre=(float(fit[1]), float(fit[2])),
        scale_mismatch=2.0 * float(fit[3]) / radius,
        squareness=2.0 * float(fit[DIAGONAL]) / radius if both else math.nan,
        servo_mismatch=2.0 * float(fit[DIAGONAL + 1]) if both else math.nan,
        diagonal=math.nan if both else float(fit[DIAGONAL]),
        residual=math.sqrt(squares / count),
    )


def _run(position: ArrayLike, centre: ArrayLike, radius: float) -> CircleFigures:
    """Return a run with angles and radial deviations, without its other figures."""
    points, middle = np.asarray(position, dtype=float), np.asarray(centre, dtype=float)
    if points.ndim != 2 or points.shape[1] != 2 or middle.shape != (2,):
        raise ResultError(f"points of shape {points.shape} around a centre of shape {middle.shape}: must be (n, 2) and (2,)")
    check_positive("radius", radius, "m")
    if len(points) < LEAST_SAMPLES:
        raise ResultError(f"a circle of {len(points)} samples: give at least {LEAST_SAMPLES}")
    if not (np.isfinite(points).all() and np.isfinite(middle).all()):
        raise ResultError("points or centre hold values that are not finite")
    out = points - middle
    distance = np.linalg.norm(out, axis=1)
    if np.abs(distance - radius).max() > 0.2 * radius:
        raise ResultError(f"points between {distance.min():.6g} m and {distance.max():.6g} m from the centre: no circle of {radius:.6g} m")
    angle = np.arctan2(out[:, 1], out[:, 0])
    turned = float(np.unwrap(angle)[-1] - angle[0])
    if abs(turned) < 2.0 * math.pi - WIDEST_HOLE:
        raise ResultError(f"points over {math.degrees(turned):.4g} degrees: give a full circle in one sense")
    away = distance - radius
    figures = (math.nan, math.nan, float(away.max()), float(away.min()), float(away.mean()))
    return CircleFigures("", turned < 0.0, radius, angle, away, *figures)


def _signatures(run: CircleFigures, both: bool) -> Array:
    """Return the columns of the design (n, 9), or (n, 10) for runs in both senses, which separate the last two causes."""
    c, s = np.cos(run.angle), np.sin(run.angle)
    sense = -1.0 if run.clockwise else 1.0
    x, y = 0.5 * sense * np.sign(s) * c, -0.5 * sense * np.sign(c) * s
    wave = np.sin(2.0 * run.angle)
    return np.column_stack([np.ones(c.shape), c, s, c * c - s * s, x, x * c, y, y * s, wave, *([sense * wave] if both else [])])


def _fit(design: Array, values: Array) -> tuple[Array, Array]:
    """Return the coefficients and their covariance."""
    inverse = np.linalg.pinv(design)
    fit = inverse @ values
    rest = values - design @ fit
    square = float(rest @ rest)
    correlation = float(rest[1:] @ rest[:-1]) / square if square > 0.0 else 0.0
    correlation = min(max(correlation, 0.0), 1.0 - 1.0 / len(values))
    variance = square / (len(values) - design.shape[1]) * (1.0 + correlation) / (1.0 - correlation)
    return fit, variance * (inverse @ inverse.T)


def _steps_at(fit: Array, covariance: Array, i: int) -> dict[float, tuple[float, float]]:
    """Return the step and its deviation at the positive and the negative end of an axis: b + d and b - d."""
    steps = {}
    for end in (1.0, -1.0):
        row = np.array([1.0, end])
        steps[end] = float(row @ fit[i : i + 2]), math.sqrt(float(row @ covariance[i : i + 2, i : i + 2] @ row))
    return steps


def past(angles: Array, clockwise: bool, angle: float) -> Array:
    """Return the angle of each sample (n,) past a given angle, in the sense of the run, from -pi to pi."""
    gone = (angles - angle) * (-1.0 if clockwise else 1.0)
    return np.asarray(gone - 2.0 * math.pi * np.rint(gone / (2.0 * math.pi)))


def crossing(past: Array, gap: float, radius: float) -> Array:
    """Return what a step at a reversal has too much, as radial deviation (n,) [m]: the load stays until the motor has crossed the gap.

    Parameters
    ----------
    past : ndarray (n,) [rad]
        Angle past the reversal.
    gap, radius : float [m]
    """
    travel = radius * (1.0 - np.cos(past))
    return np.asarray(np.where((past >= 0.0) & (travel < gap), (travel - gap) * np.cos(past), 0.0))


def is_crossed(past: Array, rest: Array, gap: float, radius: float) -> bool:
    """Return whether the residual (n,) of a step near a reversal is for the most part `crossing`, where that acts."""
    late = crossing(past, gap, radius)
    acts = late != 0.0
    return bool(np.abs(rest - late)[acts].max(initial=0.0) < 0.5 * np.abs(rest)[acts].max(initial=0.0))


def outside(angles: Array, clockwise: bool, before: float, after: float) -> Flags:
    """Return which samples (n,) are away from all reversals."""
    use = np.ones(angles.shape, dtype=bool)
    for i in range(4):
        gone = past(angles, clockwise, 0.5 * math.pi * i)
        # At the reversal itself the signature is undefined.
        use &= ~((gone >= -before) & (gone <= after)) & (gone != 0.0)
    return use


def widest_hole(angles: Array, left_out: float) -> float:
    """Return the widest part of the circle without a sample, besides what is left out at each reversal [rad]."""
    angles = np.sort(np.mod(angles, 2.0 * math.pi))
    holes = np.diff(angles, append=angles[0] + 2.0 * math.pi)
    over = np.diff(np.floor(angles / (0.5 * math.pi)), append=4.0) > 0.0
    return float((holes - left_out * over).max())


def _check_cover(run: CircleFigures, use: Flags, left_out: float) -> None:
    """Raise an error for a run that omits a part of the circle."""
    angles = run.angle[use]
    if len(angles) < LEAST_SAMPLES // 2:
        raise ResultError(f"{len(angles)} samples outside the reversals: give at least {LEAST_SAMPLES // 2}")
    if (hole := widest_hole(angles, left_out)) > WIDEST_HOLE:
        raise ResultError(f"{math.degrees(hole):.3g} degrees without a sample outside the reversals: give samples all around the circle")


def _quadrants(
    run: CircleFigures, rest: Array, before: float, after: float, axes: tuple[str, str], steps: list[dict[float, tuple[float, float]]]
) -> list[QuadrantStep]:
    quadrants = []
    for i in range(4):
        gone = past(run.angle, run.clockwise, 0.5 * math.pi * i)
        near = np.flatnonzero((gone >= -before) & (gone <= after))
        near = near[np.argsort(gone[near], kind="stable")]
        step, deviation = steps[i % 2][1.0 if i < 2 else -1.0]
        late = crossing(gone[near], step, run.radius) if is_crossed(gone[near], rest[near], step, run.radius) else 0.0
        height, width = _spike(gone[near], rest[near] - late)
        quadrants.append(QuadrantStep(axes[i % 2], run.clockwise, 0.5 * math.pi * i, step, deviation, height, width))
    return quadrants


def _spike(past: Array, rest: Array) -> tuple[float, float]:
    """Return the largest residual, and its width at half this height."""
    if not rest.any():
        return 0.0, 0.0
    peak = int(np.argmax(np.abs(rest)))
    below = np.flatnonzero(rest / rest[peak] < 0.5)
    left, right = below[below < peak], below[below > peak]
    first = int(left[-1]) + 1 if len(left) else 0
    last = int(right[0]) - 1 if len(right) else len(rest) - 1
    spacing = float(past[-1] - past[0]) / max(len(past) - 1, 1)
    return float(rest[peak]), float(past[last] - past[first]) + spacing
