"""Runs around a circle: angle and radial deviation of each sample, cut out of measured positions, or as ball bars write them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from contourlab.arrays import Array, Flags, true_spans
from contourlab.errors import LogError, ParameterError, ResultError, refuse
from contourlab.logs.reading import Channel, Record, name_and_unit
from contourlab.metrics.circles import LEAST_SAMPLES
from contourlab.units import to_si

NEAR = 0.02
"""Share of the radius by which a sample of the command may be off the circle."""
FAR = 6.0
"""Largest distance of a sample on the circle, in median distances."""
WHOLE = math.radians(340.0)
"""Least angle of a run: what is missing of a turn is short enough for the fit."""
STEADY = 0.05
"""Share by which the feed of a used sample may differ from the run's median."""
SETTLING = math.pi / 2.0
"""Angle at the start of a run of more than a turn in which the axes may still swing from the line before; a whole turn remains."""
TRIPLES = 400
"""Circles tried through three samples."""
LEAST_SHARE = 0.3
"""Least share of the samples in motion that lie on the circle."""
MOST_SAMPLES = 20_000
"""Samples of a run that the fit uses; more are thinned evenly."""


@dataclass(frozen=True, eq=False)
class CircleRun:
    """A run around a circle in one sense, one turn or more.

    Attributes
    ----------
    name : str
        The file.
    clockwise : bool
    radius : float [m]
        Nominal.
    turned : ndarray (n,) [rad]
        Angle of each sample from the first axis, unwrapped; it grows counter-clockwise.
    deviation : ndarray (n,) [m]
        Distance from the nominal centre less the nominal radius.
    feedrate : float [m/s]
        nan if unknown.
    lag : ndarray (n, 2) [m], optional
        Command less position of both axes.
    """

    name: str
    clockwise: bool
    radius: float
    turned: Array
    deviation: Array
    feedrate: float = math.nan
    lag: Array | None = None

    @property
    def sense(self) -> float:
        """1 counter-clockwise, -1 clockwise."""
        return -1.0 if self.clockwise else 1.0

    @property
    def angle(self) -> Array:
        """Angle of each sample, from 0 to 2 pi [rad]."""
        return np.asarray(np.mod(self.turned, 2.0 * math.pi))

    @property
    def points(self) -> Array:
        """The samples (n, 2) around the nominal centre [m]."""
        return np.asarray((self.radius + self.deviation)[:, None] * np.column_stack([np.cos(self.turned), np.sin(self.turned)]))


@dataclass(frozen=True, eq=False)
class Circle:
    """A nominal circle in the plane: centre (2,) and radius [m]."""

    centre: Array
    radius: float


def find_circle(points: Array) -> Circle:
    """Return the circle that most of the points (n, 2) [m] lie on; lines to and from it do not count.

    Raises
    ------
    ResultError
        If no circle passes near enough of the points.

    Notes
    -----
    Circles through three points drawn at random, the same ones each time, are counted by the points within `NEAR` of their radius
    (Fischler & Bolles, "Random sample consensus", Comm. ACM 24(6), 1981); least squares through these points gives the circle.
    """
    moving = points[np.append(True, np.any(np.diff(points, axis=0) != 0.0, axis=1))]
    refuse(len(moving) < LEAST_SAMPLES, ResultError, f"{len(moving)} samples in motion: a circle needs at least {LEAST_SAMPLES}")
    few = moving[np.linspace(0, len(moving) - 1, min(len(moving), 2000)).astype(int)]
    random, size = np.random.default_rng(0), float(np.ptp(few, axis=0).max())
    best, most = None, 0
    for _ in range(TRIPLES):
        circle = _through(few[random.choice(len(few), 3, replace=False)])
        # A circle that the motion covers: not a straight line's huge one, nor a tiny one.
        if circle is None or not 0.2 * size < circle.radius < size:
            continue
        count = int(np.count_nonzero(on_circle(few, circle)))
        if count > most:
            best, most = circle, count
    if best is None or most < LEAST_SHARE * len(few):
        raise ResultError("the motion is no circle: give the axes of the plane with --axes, and a log of a circle in one plane")
    best = _least_squares(few[on_circle(few, best)])
    for _ in range(5):
        away = np.abs(np.linalg.norm(moving - best.centre, axis=1) - best.radius)
        # Lines to the circle come near it, so what counts is how far most samples are off.
        usual = float(np.median(away[away < NEAR * best.radius]))
        best = _least_squares(moving[away <= max(FAR * usual, 1e-12)])
    return best


def on_circle(points: Array, circle: Circle) -> Flags:
    """Return which points lie within `NEAR` of the radius."""
    return np.asarray(np.abs(np.linalg.norm(points - circle.centre, axis=1) - circle.radius) < NEAR * circle.radius)


def _through(three: Array) -> Circle | None:
    """Return the circle through three points, None on a line."""
    edges = three[1:] - three[0]
    return None if abs(np.linalg.det(edges)) <= 1e-9 * np.abs(edges).max() ** 2 else _least_squares(three)


def _least_squares(points: Array) -> Circle:
    """Return the circle of least squared distances of the squares; its first-order error vanishes over whole turns."""
    middle = points.mean(axis=0)
    out = points - middle
    a, b, c = np.linalg.lstsq(np.column_stack([2.0 * out, np.ones(len(out))]), np.sum(out**2, axis=1), rcond=None)[0]
    return Circle(middle + np.array([a, b]), math.sqrt(c + a * a + b * b))


def runs_of(name: str, position: Array, period: float, circle: Circle, reference: Array | None = None) -> tuple[CircleRun, ...]:
    """Return the runs of at least nearly one turn around a circle, in the order of the log.

    Parameters
    ----------
    name : str
    position : ndarray (n, 2) [m]
        Measured.
    period : float [s]
    circle : Circle
        Nominal.
    reference : ndarray (n, 2) [m], optional
        Commanded; it decides where the runs are and where the feed is steady.

    Notes
    -----
    Samples whose feed is off the run's median by more than `STEADY` are left out: ramps from and to rest have another lag; so is up to
    `SETTLING` of a run of more than a turn.
    """
    guide = position if reference is None else reference
    out = guide - circle.centre
    angle = np.unwrap(np.arctan2(out[:, 1], out[:, 0]))
    # Over a degree or more, counts and noise do not reverse the motion.
    speed = _smooth_rate(angle, period)
    sense = np.where(on_circle(guide, circle) & (np.abs(speed) > 0.2 * np.percentile(np.abs(speed), 90)), np.sign(speed), 0.0)
    runs = []
    for start, stop in true_spans(sense):
        if abs(angle[stop - 1] - angle[start]) < WHOLE or stop - start < LEAST_SAMPLES:
            continue
        rate = speed[start:stop]
        usual = float(np.median(rate))
        gone = np.abs(angle[start:stop] - angle[start])
        settled = gone >= min(SETTLING, gone[-1] - 2.0 * math.pi)
        kept = np.flatnonzero((np.abs(rate - usual) <= STEADY * abs(usual)) & settled) + start
        if abs(angle[kept[-1]] - angle[kept[0]]) < WHOLE:
            kept = np.arange(start, stop)
        kept = kept[:: max(len(kept) // MOST_SAMPLES, 1)]
        place = position[kept] - circle.centre
        turned = np.unwrap(np.arctan2(place[:, 1], place[:, 0]))
        deviation = np.linalg.norm(place, axis=1) - circle.radius
        run = CircleRun(name, usual < 0.0, circle.radius, turned, deviation, abs(usual) * circle.radius)
        runs.append(run if reference is None else replace(run, lag=reference[kept] - position[kept]))
    refuse(not runs, ResultError, f"no run of a whole turn around the circle of radius {1e3 * circle.radius:.6g} mm")
    return tuple(runs)


def _smooth_rate(angle: Array, period: float) -> Array:
    """Return the rate of an angle [rad/s], over at least 20 samples and about a degree of the motion."""
    total = float(np.abs(np.diff(angle)).sum())
    half = int(np.clip(math.radians(0.5) / max(total / len(angle), 1e-12), 10, max(len(angle) // 20, 1)))
    index = np.arange(len(angle))
    low, high = np.maximum(index - half, 0), np.minimum(index + half, len(angle) - 1)
    return np.asarray((angle[high] - angle[low]) / ((high - low) * period))


def runs_of_angles(name: str, angle: Array, deviation: Array, radius: float, feedrate: float) -> tuple[CircleRun, ...]:
    """Return the runs of at least nearly one turn in a list of angles [rad] and deviations [m], as a ball bar writes them."""
    turned = np.unwrap(angle)
    steps = np.sign(np.diff(turned))
    # A step against both neighbours is noise of the angle, not a new sense.
    lone = np.flatnonzero((steps[1:-1] != steps[:-2]) & (steps[1:-1] != steps[2:])) + 1
    steps[lone] = steps[lone - 1]
    edges = np.flatnonzero(np.diff(steps)) + 1
    runs = []
    for start, stop in pairwise([0, *edges.tolist(), len(turned)]):
        part = turned[start:stop]
        if stop - start >= LEAST_SAMPLES and abs(part[-1] - part[0]) >= WHOLE:
            runs.append(CircleRun(name, bool(part[-1] < part[0]), radius, part, deviation[start:stop], feedrate))
    if not runs:
        covered = math.degrees(float(np.ptp(turned)))
        raise ResultError(f"{len(turned)} samples over {covered:.4g} degrees: a circle needs {LEAST_SAMPLES} or more over one whole turn")
    return tuple(runs)


# --- text files of angle and radius --------------------------------------------------------------------------------------------------

ANGLE, RADIUS, DEVIATION = "angle", "radius", "deviation"
_NAMES = {
    ANGLE: ("angle", "phi", "theta", "winkel"),
    RADIUS: ("radius", "r", "length"),
    DEVIATION: ("deviation", "dev", "radial deviation", "error", "dr"),
}
_EXAMPLE = "--column 'angle=NAME [deg]' --column 'deviation=NAME [um]'"


def own_columns(columns: Sequence[str]) -> tuple[dict[str, str], tuple[str, ...]]:
    """Split the columns of the command line into those of a ball bar, ``angle=NAME [deg]``, and those of a log."""
    mine, others = {}, []
    for text in columns:
        target, _, name = text.partition("=")
        if target.strip() in _NAMES and name.strip():
            mine[target.strip()] = name.strip()
        else:
            others.append(text)
    return mine, tuple(others)


def is_polar(record: Record, named: dict[str, str]) -> bool:
    """Tell whether a record holds angles and radii, or radial deviations."""
    present = {target for target in _NAMES if _channel(record, target, named) is not None}
    return ANGLE in present and bool(present & {RADIUS, DEVIATION})


def polar_runs(record: Record, named: dict[str, str], radius: float | None, feedrate: float) -> tuple[CircleRun, ...]:
    """Return the runs of a ball-bar file.

    Parameters
    ----------
    record : Record
    named : dict of str to str
        Columns as typed; angle, radius and deviation.
    radius : float [m] or None
        Nominal.
    feedrate : float [m/s]
        nan if unknown.

    Raises
    ------
    LogError
        If a length has no unit.
    ParameterError
        If a file of deviations has no nominal radius.
    """
    angle = _values(record, ANGLE, named, "rad")
    if _channel(record, DEVIATION, named) is not None:
        if radius is None:
            raise ParameterError("--radius", "None", 'the radius of the circle, such as "100 mm": the file holds deviations only')
        deviation = _values(record, DEVIATION, named, "m")
    else:
        lengths = _values(record, RADIUS, named, "m")
        radius = float(np.mean(lengths)) if radius is None else radius
        deviation = lengths - radius
    known = np.isfinite(angle) & np.isfinite(deviation)
    if float(np.abs(deviation[known]).max(initial=0.0)) > 0.2 * radius:
        raise LogError(f"deviations reach more than a fifth of the radius of {1e3 * radius:.6g} mm: check the units", file=record.file)
    return runs_of_angles(record.file.name, angle[known], deviation[known], radius, feedrate)


def _channel(record: Record, target: str, named: dict[str, str]) -> Channel | None:
    if target in named:
        return record.channel(name_and_unit(named[target])[0])
    names = _NAMES[target]
    return next((channel for channel in record.channels if channel.name.strip().casefold() in names), None)


def _values(record: Record, target: str, named: dict[str, str], si: str) -> Array:
    channel = _channel(record, target, named)
    if channel is None:
        raise LogError(f"has no column of the {target}: name it, as {_EXAMPLE}", file=record.file)
    if channel.fault is not None:
        raise channel.fault
    unit = (name_and_unit(named[target])[1] if target in named else "") or channel.unit or ("deg" if target == ANGLE else "")
    refuse(not unit, LogError, f"column {channel.name!r} has no unit: write --column '{target}={channel.name} [um]'", file=record.file)
    scale = math.radians(1.0) if unit in ("deg", "°") else to_si(f"1 {unit}", si)
    return np.asarray(channel.values * scale)
