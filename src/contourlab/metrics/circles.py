"""Circles by ISO 230-4: circular deviation, radial deviation, and the figures of two runs in opposite senses.

The standard uses a ball bar or grid encoder; its annex permits the machine's own feedback. Formulas as commonly given for ISO 230-4:2005
(the 2022 edition calls the deviations errors):

- G: least radial distance between two concentric circles that enclose the run (minimum zone), and the same around the least-squares centre;
- F_max, F_min: largest and smallest radius around the nominal centre less the nominal radius;
- G(b): as G for both runs together, around the least-squares centre of both; D: mean radius of both runs less nominal; H: largest
  difference of radius between the runs at one angle (1996 edition).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, fields, replace

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.errors import ResultError
from contourlab.feed import Reference
from contourlab.geometry import Arc
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
    if len(points) < 8:
        raise ResultError(f"{name}: a circle of {len(points)} samples: give at least 8")
    out = points - centre
    deviation = np.linalg.norm(out, axis=1) - radius
    around = np.linalg.norm(points - least_squares_centre(points), axis=1)
    zone, _ = minimum_zone(points)
    angle = np.arctan2(out[:, 1], out[:, 0])
    figures = (zone, float(np.ptp(around)), float(deviation.max()), float(deviation.min()), float(deviation.mean()))
    return CircleFigures(name, clockwise, radius, angle, deviation, *figures)


def bidirectional(one: CircleFigures, other: CircleFigures) -> Bidirectional:
    """Return the joint figures of two runs around one circle, with one nominal centre, in opposite senses.

    Raises
    ------
    ResultError
        If they run in the same sense, or around circles of different radii.
    """
    if one.clockwise == other.clockwise or abs(one.radius - other.radius) > 1e-9:
        raise ResultError("give two runs around one circle in opposite senses")

    def points(run: CircleFigures) -> Array:
        return np.asarray((run.radius + run.deviation)[:, None] * np.column_stack([np.cos(run.angle), np.sin(run.angle)]))

    both = np.concatenate([points(one), points(other)])
    around = np.linalg.norm(both - least_squares_centre(both), axis=1)
    grid = np.linspace(-np.pi, np.pi, 720, endpoint=False)
    gap = _at_angles(one, grid) - _at_angles(other, grid)
    mean = 0.5 * (one.mean_radial + other.mean_radial)
    return Bidirectional(float(np.ptp(around)), mean, float(np.abs(gap).max()))


def _at_angles(run: CircleFigures, grid: Array) -> Array:
    order = np.argsort(run.angle)
    return np.asarray(np.interp(grid, run.angle[order], run.deviation[order], period=2.0 * np.pi))


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
    for i, curve in enumerate(path.curves):
        if not isinstance(curve, Arc) or abs(curve.sweep) < 2.0 * math.pi - 1e-6 or np.any(curve.rise != 0.0):
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
