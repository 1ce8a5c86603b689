"""Figures of ISO 230-4 on circles with known errors, and against a search for the minimum zone."""

from __future__ import annotations

import math

import numpy as np
import pytest
from made_runs import PERIOD, Array, circle_laps, made_run, samples_on

import contourlab as cl
from contourlab.errors import ResultError
from contourlab.feed import Reference
from contourlab.geometry import Arc, Line, Path
from contourlab.metrics.circles import CircleFigures, bidirectional, circle_figures, circles_of, least_squares_centre, minimum_zone, pairs

R = 0.05
ORIGIN = np.zeros(2)


def ring(deviation: Array | float, n: int = 720, centre: tuple[float, float] = (0.0, 0.0)) -> Array:
    """Return points at radius R + deviation around a centre."""
    angle = 2.0 * np.pi * np.arange(n) / n
    spoke = np.column_stack([np.cos(angle), np.sin(angle)])
    return np.asarray(centre) + (R + np.broadcast_to(deviation, n))[:, None] * spoke


def searched_zone(points: Array) -> float:
    """Return the minimum zone from a refined grid of centres; assumes only convexity over a few refinements."""
    middle, reach = points.mean(axis=0), 2.0 * float(np.ptp(np.linalg.norm(points - points.mean(axis=0), axis=1)))
    steps = np.linspace(-1.0, 1.0, 21)
    best = math.inf
    for _ in range(14):
        grid = middle + reach * np.array([(x, y) for x in steps for y in steps])
        zone = [float(np.ptp(np.linalg.norm(points - centre, axis=1))) for centre in grid]
        best, middle = min(zone), grid[int(np.argmin(zone))]
        reach *= 0.35
    return best


def figures(points: Array, clockwise: bool = False) -> CircleFigures:
    return circle_figures(points, ORIGIN, R, clockwise, "ring")


def test_circle_off_centre() -> None:
    """An eccentric circle is round: G = 0, while F_max and F_min show its eccentricity."""
    e = 30e-6
    found = figures(ring(0.0, centre=(e * 0.6, e * 0.8)))
    assert found.circular_deviation < 1e-15
    assert found.circular_deviation_least_squares < 1e-15
    # The extremes |R +- e| lie at the angle of the shift; the samples reach them to e (pi/720)^2.
    assert found.radial_max == pytest.approx(e, rel=1e-4)
    assert found.radial_min == pytest.approx(-e, rel=1e-4)
    # Mean radius of a circle seen from e off its centre: R + e^2/(4 R).
    assert found.mean_radial == pytest.approx(e * e / (4.0 * R), rel=1e-4)


def test_circle_too_large() -> None:
    found = figures(ring(12e-6))
    assert found.circular_deviation < 1e-15
    assert (found.radial_max, found.radial_min, found.mean_radial) == pytest.approx((12e-6,) * 3, rel=1e-9)


def test_ellipse() -> None:
    """Servo mismatch: an ellipse at 45 degrees, a - b wide; both definitions have the same centre."""
    a, b, turn = R + 8e-6, R - 5e-6, math.pi / 4
    u = 2.0 * np.pi * np.arange(720) / 720
    flat = np.column_stack([a * np.cos(u), b * np.sin(u)])
    points = flat @ np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]])
    found = figures(points)
    assert found.circular_deviation == pytest.approx(13e-6, rel=1e-9)
    assert found.circular_deviation_least_squares == pytest.approx(13e-6, rel=1e-9)
    assert (found.radial_max, found.radial_min) == pytest.approx((8e-6, -5e-6), rel=1e-9)


@pytest.mark.parametrize("lobes", [2, 3, 5])
def test_lobes(lobes: int) -> None:
    """r = R + h cos(n a): G = 2 h around the centre; no shift improves it."""
    h = 4e-6
    found = figures(ring(h * np.cos(lobes * 2.0 * np.pi * np.arange(720) / 720)))
    for value in (found.circular_deviation, found.circular_deviation_least_squares):
        assert value == pytest.approx(2.0 * h, rel=1e-9)


def test_minimum_zone_is_less_than_least_squares() -> None:
    """A bulge in one quadrant: least squares weights all samples, the minimum zone only the outermost ones."""
    angle = 2.0 * np.pi * np.arange(720) / 720
    points = ring(10e-6 * np.exp(-((angle - math.pi / 4) ** 2) / 0.02))
    found = figures(points)
    assert found.circular_deviation < found.circular_deviation_least_squares - 1e-7
    assert found.circular_deviation == pytest.approx(searched_zone(points), rel=1e-4)


@pytest.mark.parametrize("seed", range(3))
def test_minimum_zone_against_a_search(seed: int) -> None:
    rng = np.random.default_rng(seed)
    angle = 2.0 * np.pi * np.arange(400) / 400
    shape = sum(rng.normal(0.0, 5e-6) * np.cos(k * angle + rng.uniform(0.0, 6.0)) for k in range(1, 8))
    points = ring(shape + rng.normal(0.0, 2e-6, 400), 400, (1e-5, -4e-5))
    zone, centre = minimum_zone(points)
    sought = searched_zone(points)
    assert zone <= sought * (1.0 + 1e-12)
    assert zone == pytest.approx(sought, rel=1e-4)
    # Check the zone at the returned centre.
    assert float(np.ptp(np.linalg.norm(points - centre, axis=1))) == pytest.approx(zone, rel=1e-12)


def test_minimum_zone_touches_alternately() -> None:
    """A minimum zone has outer and inner contacts that alternate around it, at least four."""
    rng = np.random.default_rng(11)
    angle = 2.0 * np.pi * np.arange(500) / 500
    points = ring(sum(rng.normal(0.0, 5e-6) * np.cos(k * angle + k) for k in range(2, 7)), 500)
    zone, centre = minimum_zone(points)
    radius = np.linalg.norm(points - centre, axis=1)
    outer, inner = radius > radius.max() - 1e-6 * zone, radius < radius.min() + 1e-6 * zone
    order = np.argsort(np.arctan2(*(points - centre).T[::-1]))
    touching = [bool(outer[i]) for i in order if outer[i] or inner[i]]
    assert sum(a != b for a, b in zip(touching, touching[1:] + touching[:1], strict=True)) >= 4


def test_minimum_zone_of_an_arc_with_known_answer() -> None:
    """Corners and side middles of a square: sqrt 2 - 1 of the half side, by symmetry."""
    corners = [(1, 1), (-1, 1), (-1, -1), (1, -1), (1, 0), (0, 1), (-1, 0), (0, -1)]
    zone, centre = minimum_zone(np.array(corners, dtype=float) + np.array([3.0, 2.0]))
    assert zone == pytest.approx(math.sqrt(2.0) - 1.0, rel=1e-9)
    assert centre == pytest.approx((3.0, 2.0), abs=1e-6)


def test_least_squares_centre_is_stationary() -> None:
    """At the least-squares centre the gradient is zero: sum (r - mean r) spoke = 0."""
    rng = np.random.default_rng(3)
    points = ring(rng.normal(0.0, 1e-4, 300), 300, (2e-3, -1e-3))[:200]
    out = points - least_squares_centre(points)
    radius = np.linalg.norm(out, axis=1)
    gradient = ((radius - radius.mean())[:, None] * out / radius[:, None]).sum(axis=0)
    assert np.abs(gradient).max() < 1e-14


def test_two_senses_with_a_lag_between_them() -> None:
    """Larger by a one way and smaller by a the other: G(b) = 2 a, H = 2 a, D = 0; each run alone is round."""
    a = 6e-6
    found = bidirectional(figures(ring(a)), figures(ring(-a), clockwise=True))
    assert found.circular_deviation == pytest.approx(2.0 * a, rel=1e-9)
    assert found.hysteresis == pytest.approx(2.0 * a, rel=1e-9)
    assert abs(found.mean_radial) < 1e-15


def test_both_senses_with_the_same_eccentricity() -> None:
    """The centre takes up an offset common to both runs; a common radius error is D."""
    points = ring(5e-6, centre=(2e-5, -1e-5))
    found = bidirectional(figures(points), figures(points[::-1], clockwise=True))
    assert found.circular_deviation < 1e-14
    assert found.hysteresis < 1e-14
    assert found.mean_radial == pytest.approx(5e-6 + 5e-10 / (4.0 * R), rel=1e-4)


def test_backlash_in_opposite_senses() -> None:
    """Backlash b of x shifts the half circles: at every angle the two runs differ by b |cos|."""
    b = 8e-6
    angle = 2.0 * np.pi * np.arange(720) / 720
    points, back = ring(0.0), ring(0.0)
    points[:, 0] += np.where(np.sin(angle) > 0.0, -b / 2, b / 2)
    back[:, 0] += np.where(np.sin(angle) > 0.0, b / 2, -b / 2)
    found = bidirectional(figures(points), figures(back, clockwise=True))
    assert found.hysteresis == pytest.approx(b, rel=2e-2)
    assert found.circular_deviation == pytest.approx(b, rel=2e-2)


def test_runs_that_do_not_form_a_pair() -> None:
    one, larger = figures(ring(0.0)), circle_figures(ring(0.0), ORIGIN, 2 * R, True, "larger")
    for other in (one, larger):
        with pytest.raises(ResultError, match="opposite senses"):
            bidirectional(one, other)


def test_too_few_samples() -> None:
    with pytest.raises(ResultError, match=r"ring: .*7 samples"):
        figures(ring(0.0, 7))


# --- circles found in a run -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("clockwise", [0.0, 1.0])
def test_circle_of_a_run_in_laps(clockwise: float) -> None:
    """The last lap counts: the first one is too wide."""
    reference = circle_laps(360, laps=2, clockwise=clockwise)
    factor = np.where(np.arange(720) < 360, 1.02, 1.0 + 1e-3)
    tool = reference.block(0, 720).position * factor[:, None]
    (found,) = circles_of(made_run(reference, tool), reference)
    assert found.clockwise == bool(clockwise)
    assert len(found.deviation) == 360
    assert found.mean_radial == pytest.approx(2e-5, rel=1e-9)
    assert found.circular_deviation < 1e-15
    assert found.name == "XY, radius 20 mm"


def programme() -> tuple[Path, Reference]:
    """Return a program: approach, a circle to the left, a circle to the right, a half circle, departure."""
    curves = [
        Line((-0.01, 0.0), (0.0, 0.0)),
        Arc((0.0, 0.03), 0.03, -math.pi / 2, 2.0 * math.pi),
        Arc((0.0, 0.03), 0.03, -math.pi / 2, -2.0 * math.pi),
        Arc((0.0, 0.03), 0.03, -math.pi / 2, math.pi),
        Line((0.0, 0.06), (0.01, 0.06)),
    ]
    path = Path(curves)
    return path, samples_on(path, np.linspace(0.0, path.length, 4001))


def test_circles_of_a_programme() -> None:
    """Only full circles are found, each with its own sense and error; opposite senses form a pair."""
    path, reference = programme()
    along = reference.block(0, 4001).arc_length
    wide = np.where(along < path.breaks[2], 3e-6, -2e-6)
    # Wider means away from the centre: to the right in a left turn.
    side = np.where(along < path.breaks[2], -1.0, 1.0)
    tool = path.position(along) + (side * wide)[:, None] * path.normal(along)
    left, right = circles_of(made_run(reference, tool), reference)
    assert (left.clockwise, right.clockwise) == (False, True)
    assert (left.mean_radial, right.mean_radial) == pytest.approx((3e-6, -2e-6), rel=1e-3)
    (both,) = pairs((left, right)).values()
    assert both.hysteresis == pytest.approx(5e-6, rel=1e-6)
    assert both.mean_radial == pytest.approx(0.5e-6, rel=1e-2)


def test_a_dwell_does_not_count() -> None:
    """A dwell at the end of the circle would weight one place with a thousand samples."""
    path = Path([Arc((0.0, 0.0), 0.02, 0.0, 2.0 * math.pi)])
    along = np.concatenate([np.linspace(0.0, path.length, 500), np.full(1000, path.length)])
    reference = Reference.from_samples(path.position(along), PERIOD, path, arc_length=along)
    (found,) = circles_of(made_run(reference, reference.block(0, 1500).position), reference)
    assert len(found.deviation) == 500


@pytest.mark.parametrize(("u", "v", "left"), [((-1, 0), (0, -1), True), ((1, 0), (0, -1), False), ((0, 1), (1, 0), False)])
def test_sense_does_not_depend_on_the_frame(u: tuple[int, int], v: tuple[int, int], left: bool) -> None:
    path = Path([Arc((0.0, 0.0), 0.02, 0.0, 2.0 * math.pi, u, v)])
    reference = samples_on(path, np.linspace(0.0, path.length, 100))
    points = reference.block(0, 100).position
    area = 0.5 * float(np.sum(points[:-1, 0] * points[1:, 1] - points[1:, 0] * points[:-1, 1]))
    assert (area > 0.0) == left
    (found,) = circles_of(made_run(reference, points), reference)
    assert found.clockwise != left


def test_circle_in_a_plane_of_space() -> None:
    """A circle in ZX with the tool off along Y: the error out of the plane is not radial."""
    path = Path([Arc((0.0, 0.01, 0.0), 0.02, 0.3, -2.0 * math.pi, (0, 0, 1), (1, 0, 0))])
    reference = samples_on(path, np.linspace(0.0, path.length, 300))
    tool = reference.block(0, 300).position * (1.0 + 1e-4) + (0.0, 5e-5, 0.0)
    (found,) = circles_of(made_run(reference, tool), reference)
    assert (found.name, found.clockwise) == ("ZX, radius 20 mm", True)
    assert found.mean_radial == pytest.approx(2e-6, rel=1e-9)


def test_equal_circles_at_two_places_are_not_one() -> None:
    """Each is run once, in opposite senses: neither has a bidirectional figure."""
    here, there = (Arc((x, 0.0), 0.01, 0.0, turn) for x, turn in ((0.0, 2.0 * math.pi), (0.02, -2.0 * math.pi)))
    path = cl.Path([here, Line((0.01, 0.0), (0.03, 0.0)), there])
    reference = cl.plan(cl.route_from_path(path, 0.05), cl.AxisLimits(0.2, 1.0, 20.0), 1e-3)
    samples = reference.block(0, reference.n_sample)
    two = ("sample", "axis")
    signals = {"tool_position": cl.Signal(samples.position, two, "m"), "arc_length": cl.Signal(samples.arc_length, ("sample",), "m")}
    found = cl.circles_of(cl.Result("base", ("x", "y"), 1e-3, signals), reference)
    assert [circle.name for circle in found] == ["XY, radius 10 mm", "XY, radius 10 mm at (20, 0) mm"]
    assert pairs(found) == {}
