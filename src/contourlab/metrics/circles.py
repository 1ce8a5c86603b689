"""Circles by ISO 230-4: circular deviation, radial deviation, two runs in opposite senses; and the backlash behind them.

The standard uses a ball bar or grid encoder; its annex permits the machine's own feedback. Formulas as commonly given for ISO 230-4:2005
(the 2022 edition calls the deviations errors):

- G: least radial distance between two concentric circles that enclose the run (minimum zone), and the same around the least-squares centre;
- F_max, F_min: largest and smallest radius around the nominal centre less the nominal radius;
- G(b): as G for both runs together, around the least-squares centre of both; D: mean radius of both runs less nominal; H: largest
  difference of radius between the runs at one angle (1996 edition).

Backlash of both axes from a circular test: the steps at the quadrants, separated from other errors.

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
from dataclasses import dataclass, field, fields, replace

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import ParameterError, ResultError, refuse
from contourlab.feed import Reference
from contourlab.geometry import Arc
from contourlab.geometry.line_and_arc import Arcs
from contourlab.metrics.figures import judged_part
from contourlab.result import Result


@dataclass(frozen=True, eq=False)
class CircleFigures:
    """One run around a circle.

    Attributes
    ----------
    name : str
    clockwise : bool
    radius : float [m]
        Nominal.
    angle : ndarray (n,) [rad]
    deviation : ndarray (n,) [m]
        Distance from the nominal centre less the nominal radius.
    circular_deviation : float [m]
        G, minimum zone.
    circular_deviation_least_squares : float [m]
        G around the least-squares centre.
    radial_max, radial_min : float [m]
        F_max and F_min.
    mean_radial : float [m]
        Mean deviation of the run.
    samples : ndarray of int
        Sample of the result for each angle; empty if unknown.
    """

    name: str
    clockwise: bool
    radius: float
    angle: Array = field(metadata={"json": False})
    deviation: Array = field(metadata={"json": False})
    circular_deviation: float = field(metadata={"json": "circular deviation G, minimum zone"})
    circular_deviation_least_squares: float = field(metadata={"json": "circular deviation G, least squares"})
    radial_max: float = field(metadata={"json": "radial deviation F_max"})
    radial_min: float = field(metadata={"json": "radial deviation F_min"})
    mean_radial: float = field(metadata={"json": "mean radial deviation"})
    samples: Index = field(default_factory=lambda: np.zeros(0, dtype=np.int64), metadata={"json": False})

    def figures(self) -> dict[str, float]:
        """Return the figures [m] by their names in the standard."""
        return {part.metadata["json"]: getattr(self, part.name) for part in fields(self) if part.metadata.get("json")}


@dataclass(frozen=True, slots=True)
class Bidirectional:
    """G(b), D and H [m] of a clockwise and a counter-clockwise run."""

    circular_deviation: float
    mean_radial: float
    hysteresis: float


def least_squares_centre(points: Array) -> Array:
    """Return the centre (2,) of the circle of least squared radial distances (Gauss-Newton from the mean)."""
    centre = points.mean(axis=0)
    for _ in range(50):
        out = points - centre
        radius = np.linalg.norm(out, axis=1)
        design = np.column_stack([-out / radius[:, None], -np.ones(len(points))])
        step = np.linalg.lstsq(design, -(radius - radius.mean()), rcond=None)[0][:2]
        centre = centre + step
        if np.linalg.norm(step) <= 1e-15 * radius.mean():
            break
    return np.asarray(centre)


def minimum_zone(points: Array) -> tuple[float, Array]:
    """Return the least distance between two concentric circles that enclose all points, and their centre.

    Each round linearises the radii in the shift of the centre and solves a linear programme for the best shift; for deviations much
    smaller than the radius a few rounds suffice. The programme starts with some points and adds those that turn out to touch the circles.
    """
    centre = least_squares_centre(points)
    best, best_centre = math.inf, centre
    active = np.unique(np.linspace(0, len(points) - 1, 24).astype(int))
    for _ in range(100):
        radius = np.linalg.norm(points - centre, axis=1)
        low, high = int(np.argmin(radius)), int(np.argmax(radius))
        zone = float(radius[high] - radius[low])
        known = low in active and high in active
        if zone < best * (1.0 - 1e-12):
            best, best_centre = zone, centre
        elif known:
            break
        active = np.union1d(active, [low, high])
        shift = _best_shift(points[active], centre, zone)
        if shift is None:
            break
        centre = centre + shift
    return best, np.asarray(best_centre)


def _best_shift(points: Array, centre: Array, zone: float) -> Array | None:
    """Return the shift of the centre that minimises the linearised zone of some points; None if the solver fails."""
    from scipy.optimize import linprog

    out = points - centre
    radius = np.linalg.norm(out, axis=1)
    size = max(zone, 1e-15)
    spoke = out / radius[:, None]
    ones = np.ones((len(points), 1))
    zeros = np.zeros_like(ones)
    # radius - spoke.shift lies between low and high, in units of the zone, so that the solver sees numbers near 1.
    level = ((radius - radius.mean()) / size)[:, None]
    above = np.hstack([-spoke, -ones, zeros])
    below = np.hstack([spoke, zeros, ones])
    solved = linprog([0.0, 0.0, 1.0, -1.0], np.vstack([above, below]), np.concatenate([-level, level])[:, 0], bounds=[(None, None)] * 4)
    return size * np.asarray(solved.x)[:2] if solved.success else None


def circle_figures(points: Array, centre: Array, radius: float, clockwise: bool, name: str) -> CircleFigures:
    """Return the figures of one run of points (n, 2) around a nominal circle.

    Raises
    ------
    ResultError
        If there are fewer than 8 points.
    """
    refuse(len(points) < 8, ResultError, f"{name}: a circle of {len(points)} samples: give at least 8")
    run = _radial(points - centre, radius, name)
    around = np.linalg.norm(points - least_squares_centre(points), axis=1)
    zone, _ = minimum_zone(points)
    return replace(run, clockwise=clockwise, circular_deviation=zone, circular_deviation_least_squares=float(np.ptp(around)))


def _radial(out: Array, radius: float, name: str = "") -> CircleFigures:
    """Return a counter-clockwise run of points (n, 2) around zero, without its circular deviation."""
    angle, deviation = np.arctan2(out[:, 1], out[:, 0]), np.linalg.norm(out, axis=1) - radius
    figures = math.nan, math.nan, float(deviation.max()), float(deviation.min()), float(deviation.mean())
    return CircleFigures(name, False, radius, angle, deviation, *figures)


def bidirectional(one: CircleFigures, other: CircleFigures) -> Bidirectional:
    """Return the joint figures of two runs around one circle, with one nominal centre, in opposite senses.

    Raises
    ------
    ResultError
        If they run in the same sense, or around circles of different radii.
    """
    if one.clockwise == other.clockwise or abs(one.radius - other.radius) > 1e-9:
        raise ResultError("give two runs around one circle in opposite senses")

    spokes = [np.column_stack([np.cos(run.angle), np.sin(run.angle)]) for run in (one, other)]
    both = np.concatenate([(run.radius + run.deviation)[:, None] * spoke for run, spoke in zip((one, other), spokes, strict=True)])
    around = np.linalg.norm(both - least_squares_centre(both), axis=1)
    grid = np.linspace(-np.pi, np.pi, 720, endpoint=False)
    orders = [(run, np.argsort(run.angle)) for run in (one, other)]
    at_grid = [np.interp(grid, run.angle[order], run.deviation[order], period=2.0 * np.pi) for run, order in orders]
    mean = 0.5 * (one.mean_radial + other.mean_radial)
    return Bidirectional(float(np.ptp(around)), mean, float(np.abs(at_grid[0] - at_grid[1]).max()))


def circles_of(result: Result, reference: Reference) -> tuple[CircleFigures, ...]:
    """Return the figures of every full circle of the programmed path, each over its last complete pass.

    Parameters
    ----------
    result : Result
        With ``tool_position`` and ``arc_length``.
    reference : Reference

    Returns
    -------
    tuple of CircleFigures
        In the order of the path.
    """
    path = reference.programmed
    runs = []
    for i in np.flatnonzero(path.of_kind(Arcs)).tolist():
        curve = path.curves[i]
        if abs(curve.sweep) < 2.0 * math.pi - 1e-6 or np.any(curve.rise != 0.0):
            continue
        samples = _pass(result, reference, path.breaks[i], path.breaks[i + 1])
        if len(samples) >= 8:
            runs.append(_run_of(result, samples, curve, path.n_axis))
    return tuple(runs)


def _pass(result: Result, reference: Reference, low: float, high: float) -> Index:
    along = reference.programmed_arc_length(result["arc_length"])
    counted = judged_part(result, reference).samples
    path = reference.programmed
    inside = along[counted] - path.length * np.floor(along[counted] / path.length) if path.closed else along[counted]
    moving = np.concatenate([[True], np.diff(along[counted]) > 0.0])
    return np.asarray(counted[(inside >= low) & (inside <= high) & moving])


def _run_of(result: Result, samples: Index, curve: Arc, n_axis: int) -> CircleFigures:
    frame = np.array([curve.u, curve.v])
    flat = (result["tool_position"][samples] - curve.centre) @ frame.T
    main = [int(np.argmax(np.abs(axis))) for axis in frame]
    plane = "".join("XYZ"[i] if n_axis <= 3 else "?" for i in main)
    # In the plane the first two axes define the sense, not the frame of the arc.
    turn = curve.sweep * float(np.linalg.det(frame)) if n_axis == 2 else curve.sweep
    middle = [round(1e3 * float(curve.centre[i]), 6) for i in main]
    place = f" at ({middle[0]:.6g}, {middle[1]:.6g}) mm" if any(middle) else ""
    name = f"{plane}, radius {curve.radius * 1e3:.6g} mm{place}"
    return replace(circle_figures(flat, np.zeros(2), curve.radius, turn < 0.0, name), samples=samples)


def pairs(runs: Sequence[CircleFigures]) -> dict[str, Bidirectional]:
    """Return the bidirectional figures of all circles that were run in both senses, by name."""
    clockwise = {run.name: run for run in runs if run.clockwise}
    return {run.name: bidirectional(run, clockwise[run.name]) for run in runs if not run.clockwise and run.name in clockwise}


# --- backlash of both axes ------------------------------------------------------------------------------------------------------------

X, Y, DIAGONAL = 4, 6, 8
"""Columns of the design: radius, centre (x, y), scale; backlash of x and its slope, of y and its slope; squareness and servo mismatch."""
BEFORE, AFTER = math.radians(2.0), math.radians(15.0)
"""A fit leaves out samples from `BEFORE` a reversal to `AFTER` it, where the spike is."""
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
    before: float = BEFORE,
    after: float = AFTER,
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
    runs: Sequence[CircleFigures], *, axes: tuple[str, str] = ("x", "y"), before: float = BEFORE, after: float = AFTER
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
        check_cover(run.angle[use], before + after)
    fit, covariance = _fit(
        np.concatenate([design[use] for design, use in zip(designs, used, strict=True)]),
        np.concatenate([run.deviation[use] for run, use in zip(runs, used, strict=True)]),
    )
    quadrants, squares, count = [], 0.0, 0
    for run, design, use in zip(runs, designs, used, strict=True):
        diagonal = fit[DIAGONAL] + (-1.0 if run.clockwise else 1.0) * fit[DIAGONAL + 1] if both else fit[DIAGONAL]
        rest = run.deviation - design[:, :DIAGONAL] @ fit[:DIAGONAL] - design[:, DIAGONAL] * diagonal
        squares, count = squares + float(rest[use] @ rest[use]), count + int(use.sum())
        quadrants += _quadrants(run, rest, before, after, axes, fit, covariance)
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
    refuse(not 0.0 < radius < math.inf, ParameterError, "radius", radius, "finite and > 0", "m")
    refuse(len(points) < LEAST_SAMPLES, ResultError, f"a circle of {len(points)} samples: give at least {LEAST_SAMPLES}")
    refuse(not (np.isfinite(points).all() and np.isfinite(middle).all()), ResultError, "points or centre hold values that are not finite")
    run = _radial(points - middle, radius)
    if np.abs(run.deviation).max() > 0.2 * radius:
        low, high = radius + run.radial_min, radius + run.radial_max
        raise ResultError(f"points between {low:.6g} m and {high:.6g} m from the centre: no circle of {radius:.6g} m")
    turned = float(np.unwrap(run.angle)[-1] - run.angle[0])
    if abs(turned) < 2.0 * math.pi - WIDEST_HOLE:
        raise ResultError(f"points over {math.degrees(turned):.4g} degrees: give a full circle in one sense")
    return replace(run, clockwise=turned < 0.0)


def _signatures(run: CircleFigures, both: bool) -> Array:
    """Return the columns of the design (n, 9), or (n, 10) for runs in both senses, which separate the last two causes."""
    c, s, wave = np.cos(run.angle), np.sin(run.angle), np.sin(2.0 * run.angle)
    play = [play_columns(c, s, run.clockwise, first) for first in (True, False)]
    mirrored = [-wave if run.clockwise else wave] if both else []
    return np.column_stack([np.ones(c.shape), c, s, c * c - s * s, *play, wave, *mirrored])


def play_columns(c: Array, s: Array, clockwise: bool, first: bool) -> Array:
    """Return the signatures (n, 2) of backlash of the first or second axis and of its slope, at angles of cosine c and sine s (n,)."""
    half = (-0.5 if clockwise else 0.5) * (np.sign(s) * c if first else -np.sign(c) * s)
    return np.column_stack([half, half * (c if first else s)])


def _fit(design: Array, values: Array) -> tuple[Array, Array]:
    """Return the coefficients and their covariance."""
    inverse = np.linalg.pinv(design)
    fit = inverse @ values
    rest = values - design @ fit
    return fit, correlated_variance(rest, len(values) - design.shape[1]) * (inverse @ inverse.T)


def correlated_variance(rest: Array, free: int) -> float:
    """Return the variance of a residual (n,) with some degrees of freedom, times the samples over which it is correlated (first order)."""
    square = float(rest @ rest)
    if square <= 0.0:
        return 0.0
    correlation = min(max(float(rest[1:] @ rest[:-1]) / square, 0.0), 1.0 - 1.0 / len(rest))
    return square / free * (1.0 + correlation) / (1.0 - correlation)


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


def check_cover(angles: Array, left_out: float) -> None:
    """Raise ResultError if samples outside the reversals are few or leave a hole, besides what is left out at each reversal [rad]."""
    if len(angles) < LEAST_SAMPLES // 2:
        raise ResultError(f"{len(angles)} samples outside the reversals: give at least {LEAST_SAMPLES // 2}")
    angles = np.sort(np.mod(angles, 2.0 * math.pi))
    holes = np.diff(angles, append=angles[0] + 2.0 * math.pi)
    over = np.diff(np.floor(angles / (0.5 * math.pi)), append=4.0) > 0.0
    if (hole := float((holes - left_out * over).max())) > WIDEST_HOLE:
        raise ResultError(f"{math.degrees(hole):.3g} degrees without a sample outside the reversals: measure the whole circle")


def _quadrants(
    run: CircleFigures, rest: Array, before: float, after: float, axes: tuple[str, str], fit: Array, covariance: Array
) -> list[QuadrantStep]:
    """Return the reversals of a run, from what the fit leaves of its radial deviation."""
    quadrants = []
    for i in range(4):
        gone = past(run.angle, run.clockwise, 0.5 * math.pi * i)
        near = np.flatnonzero((gone >= -before) & (gone <= after))
        near = near[np.argsort(gone[near], kind="stable")]
        # The step is b + d at the positive end of an axis, and b - d at the negative end.
        of_axis, end = slice(X, Y) if i % 2 == 0 else slice(Y, DIAGONAL), np.array([1.0, 1.0 if i < 2 else -1.0])
        step, deviation = float(end @ fit[of_axis]), math.sqrt(float(end @ covariance[of_axis, of_axis] @ end))
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
