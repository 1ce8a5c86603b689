"""Unevenly spaced points, as CAM and CAD write them: straight sides between fine curves; deviations from the polygon are reported."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path as File

import numpy as np
import pytest
from drawings import away
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from contourlab.contours import study_contour
from contourlab.contours.fit import PointFit, fit_points
from contourlab.contours.reader import read_points
from contourlab.errors import GeometryError
from contourlab.geometry import Arc, Curve, Line, Path

Array = NDArray[np.float64]
ANGLE = math.radians(30.0)
MM = 1e-3


def rounded(half: tuple[float, float], radius: float, per_corner: int, between: int = 0) -> Array:
    """Points [mm] of a rectangle with rounded corners: `per_corner` on each fillet, including its ends, and some on each side."""
    turns = np.linspace(0.0, 0.5 * math.pi, per_corner)
    rows: list[Array] = []
    for k, (x, y) in enumerate(((1, -1), (1, 1), (-1, 1), (-1, -1))):
        a = turns + (k - 1) * 0.5 * math.pi
        rows.append(np.array([x * (half[0] - radius), y * (half[1] - radius)]) + radius * np.column_stack([np.cos(a), np.sin(a)]))
    found: list[Array] = []
    for k, arc in enumerate(rows):
        begin, end = arc[-1], rows[(k + 1) % 4][0]
        found += [arc, begin + np.linspace(0.0, 1.0, between + 2)[1:-1, None] * (end - begin)]
    points = np.concatenate(found)
    keep = np.linalg.norm(points - np.roll(points, 1, axis=0), axis=1) > 1e-9  # a race track has no short sides
    return np.asarray(points[keep])


def off_rectangle(points: Array, half: tuple[float, float], radius: float) -> Array:
    """Distance of points [mm] from the rounded rectangle, in closed form."""
    q = np.abs(points) - (np.array(half) - radius)
    outside = np.linalg.norm(np.maximum(q, 0.0), axis=1)
    return np.asarray(np.abs(outside + np.minimum(q.max(axis=1), 0.0) - radius))


def perimeter(half: tuple[float, float], radius: float) -> float:
    return 4.0 * (half[0] + half[1] - 2.0 * radius) + 2.0 * math.pi * radius


SHAPES = [((30.0, 20.0), 3.0, 10), ((27.0, 2.0), 2.0, 19), ((100.0, 100.0), 0.5, 7), ((6.0, 5.0), 3.0, 30)]


@pytest.mark.parametrize(("half", "radius", "per_corner"), SHAPES)
@pytest.mark.parametrize(("start", "between", "decimals"), [(0, 0, 4), (3, 1, 4), (-1, 0, 12), (5, 1, 12)])
def test_rounded_rectangles_are_reproduced(
    half: tuple[float, float], radius: float, per_corner: int, start: int, between: int, decimals: int
) -> None:
    """From any first point, with or without a point in mid side, rounded to 0.1 um or not."""
    points = np.roll(rounded(half, radius, per_corner, between), start, axis=0).round(decimals)
    fit = fit_points(MM * np.concatenate([points, points[:1]]), None, ANGLE)
    path = fit.path
    assert path.closed
    assert fit.n_corner == 0
    assert path.corners.size == 0
    # A sixth-order spline along the fillets, and the rounding of the points.
    allowed = radius * (0.5 * math.pi / (per_corner - 1)) ** 6 + 3.0 * 10.0**-decimals
    s = np.linspace(0.0, path.length, 8001)
    seen = path.position(s)
    assert off_rectangle(seen / MM, half, radius).max() < allowed
    truth = MM * rounded(half, radius, 30, 30)
    nearest = s[cKDTree(seen).query(truth)[1]]
    assert path.foot_point(truth, nearest, 2.0 * s[1]).distance.max() < MM * allowed
    assert path.length / MM == pytest.approx(perimeter(half, radius), rel=1e-5)


def test_the_straight_sides_are_lines_and_the_note_says_so(tmp_path: File) -> None:
    points = rounded((30.0, 20.0), 3.0, 10)
    file = tmp_path / "rounded.csv"
    np.savetxt(file, np.concatenate([points, points[:1]]), fmt="%.4f", delimiter=",", header="x [mm],y [mm]", comments="")
    found = study_contour(file)
    lines = [curve for curve in found.path.curves if isinstance(curve, Line)]
    assert [round(line.length / MM, 3) for line in lines] == [34.0, 54.0, 34.0, 54.0]
    # The sagitta of a tenth of a quarter turn: r (1 - cos(pi / 36)).
    assert f"within {3e3 * (1.0 - math.cos(math.pi / 36.0)):.2g}" in found.notes[0]
    assert "4 straight" in found.notes[0]
    for tolerance in (1e-6, 1e-5, 1e-4):
        near = study_contour(file, tolerance=tolerance).path
        assert off_rectangle(near.position(np.linspace(0.0, near.length, 5001)) / MM, (30.0, 20.0), 3.0).max() * MM < tolerance
        assert near.corners.size == 0


@dataclass(frozen=True)
class Chain:
    """A tangent-continuous chain of lines and arcs, and points along it [m]."""

    path: Path
    points: Array
    sagitta: float


def chain(parts: list[tuple[float, float, int, int]], seed: int) -> Chain:
    """Join parts end to end: (line length or radius [mm], turn [rad] or 0 for a line, points, side)."""
    rng = np.random.default_rng(seed)
    at, heading, sagitta = np.zeros(2), 0.3, 0.0
    curves: list[Curve] = []
    points = [np.zeros((1, 2))]
    for size, turn, count, side in parts:
        along = np.array([math.cos(heading), math.sin(heading)])
        shares = np.cumsum(rng.uniform(0.75, 1.3, count))
        shares /= shares[-1]
        if turn == 0.0:
            end = at + MM * size * along
            curves.append(Line(at, end))
            points.append(end[None])
        else:
            left = np.array([-along[1], along[0]])
            centre = at + side * MM * size * left
            a = side * turn * shares[:, None]
            out = at - centre
            points.append(centre + np.cos(a) * out + np.sin(a) * np.array([-out[1], out[0]]))
            end = points[-1][-1]
            curves.append(Arc(centre, MM * size, math.atan2(out[1], out[0]), side * turn))
            heading += side * turn
            sagitta = max(sagitta, MM * size * float((turn * np.diff(shares, prepend=0.0)).max()) ** 2 / 8.0)
        at = end
    return Chain(Path(curves), np.concatenate(points), sagitta)


def apart(fit: PointFit, truth: Path) -> float:
    """Greatest distance [m] of either path from the other, by exact foot points."""
    found = []
    for one, other in ((fit.path, truth), (truth, fit.path)):
        s = np.linspace(0.0, one.length, 3001)
        found.append(other.foot_point(one.position(s), s * (other.length / one.length), 0.02 * other.length).distance.max())
    return float(max(found))


LINES = st.tuples(st.floats(1.0, 100.0), st.just(0.0), st.integers(1, 3), st.just(1))
ARCS = st.tuples(st.floats(1.0, 20.0), st.floats(0.5, 2.0), st.integers(20, 40), st.sampled_from([-1, 1]))


@given(pairs=st.lists(st.tuples(LINES, ARCS), min_size=1, max_size=3), first=st.booleans(), seed=st.integers(0, 2**16))
@example(pairs=[((50.0, 0.0, 1, 1), (2.0, 2.0, 36, 1)), ((50.0, 0.0, 1, 1), (2.0, 1.0, 20, -1))], first=True, seed=1)
@settings(max_examples=15, deadline=None)
def test_chains_of_lines_and_arcs(pairs: list[tuple[tuple[float, float, int, int], ...]], first: bool, seed: int) -> None:
    """The path is nearer to the shape than the polygon of its points, which is off by the largest sagitta."""
    parts = [part for pair in pairs for part in pair][0 if first else 1 :]
    # A line less than twice as long as its neighbouring chords does not count as straight; spacing varies by 1.75.
    for one, other in pairwise(parts):
        line, arc = (one, other) if one[1] == 0.0 else (other, one)
        assume(line[0] > 2.0 * 1.75 * arc[0] * arc[1] / arc[2])
    made = chain(parts, seed)
    fit = fit_points(made.points, None, ANGLE)
    assert fit.path.corners.size == 0
    assert apart(fit, made.path) < made.sagitta + 1e-9
    assert fit.path.length == pytest.approx(made.path.length, rel=1e-4)
    assert fit.bulge < 1.5 * made.sagitta


@given(seed=st.integers(0, 2**16), n=st.sampled_from([200, 400]))
@settings(max_examples=10, deadline=None)
def test_smooth_curves_accept_any_spacing(seed: int, n: int) -> None:
    """Points of an ellipse with steps that differ by a factor of a hundred: no significant part counts as straight."""
    steps = np.random.default_rng(seed).uniform(0.01, 1.0, n)
    u = np.concatenate([[0.0], np.cumsum(steps)])
    u *= 2.0 * math.pi / u[-1]
    points = MM * np.column_stack([40.0 * np.cos(u), 20.0 * np.sin(u)])
    points[-1] = points[0]
    fit = fit_points(points, None, ANGLE)
    seen = fit.path.position(np.linspace(0.0, fit.path.length, 5001)) / MM
    # Distance from the ellipse: implicit function over its slope. The polygon of the points is off by 10 um and more.
    f = (seen[:, 0] / 40.0) ** 2 + (seen[:, 1] / 20.0) ** 2 - 1.0
    slope = 2.0 * np.hypot(seen[:, 0] / 1600.0, seen[:, 1] / 400.0)
    assert np.abs(f / slope).max() < 1e-3


def test_noise_between_long_sides_stays_within_the_tolerance() -> None:
    rng = np.random.default_rng(5)
    exact = MM * rounded((60.0, 20.0), 8.0, 80)
    noisy = exact + rng.uniform(-2e-6, 2e-6, exact.shape)
    fit = fit_points(np.concatenate([noisy, noisy[:1]]), 4e-6, ANGLE)
    path = fit.path
    assert path.corners.size == 0
    assert away(path, noisy[::7]) <= fit.deviation * (1 + 1e-9) <= 4e-6
    # The tolerance plus the noise of the points.
    assert (
        MM * off_rectangle(path.position(np.linspace(0.0, path.length, 8001)) / MM, (60.0, 20.0), 8.0).max() < 4e-6 + math.sqrt(8.0) * 1e-6
    )


@pytest.mark.parametrize("n_axis", [2, 3])
@pytest.mark.parametrize("closed", [True, False])
def test_no_curve_leaves_its_polygon_further_than_its_turns_explain(n_axis: int, closed: bool) -> None:
    """Random walks with steps of 10 um and 50 mm that turn by less than a corner: every segment stays near its chord."""
    rng = np.random.default_rng(8)
    for _ in range(12):
        heading = np.cumsum(rng.choice([0.0, 0.1, 0.3, -0.2], size=40))
        way = np.column_stack([np.cos(heading), np.sin(heading), 0.2 * np.sin(heading)])[:, :n_axis]
        points = np.cumsum(way * rng.choice([1e-5, 1e-3, 5e-2], size=(40, 1)), axis=0)
        if closed:
            points = np.concatenate([points, points[:1]])
        fit = fit_points(points, None, ANGLE)
        chords = np.diff(points, axis=0)
        size = np.linalg.norm(chords, axis=1)
        turns = np.arccos(np.clip(np.einsum("ij,ij->i", chords[1:], chords[:-1]) / (size[1:] * size[:-1]), -1.0, 1.0))
        # A turn of 0.5 rad or less bends a chord by no more than an arc of twice that.
        assert fit.bulge < 1.5 * size.max() * min(ANGLE, float(turns.max())) / 4.0
        assert len(fit.path.corners) == fit.n_corner
        assert fit.path.length < 1.1 * size.sum()


def test_points_without_a_good_curve_are_refused_with_their_lines(tmp_path: File, monkeypatch: pytest.MonkeyPatch) -> None:
    from contourlab.contours.fit import Polygon

    def nowhere(polygon: Polygon) -> tuple[Array, NDArray[np.bool_]]:
        return np.zeros(len(polygon.length)), np.zeros(len(polygon.length), dtype=bool)

    monkeypatch.setattr(Polygon, "bulges", nowhere)
    file = tmp_path / "points.csv"
    file.write_text("x [mm],y [mm]\n0,0\n# a remark\n10,1\n20,0\n30,-4\n", encoding="utf-8")
    with pytest.raises(GeometryError, match=r"points\.csv: .*line 2.*line 4\b.* um"):
        read_points(file)
    with pytest.raises(GeometryError, match=r"line 6.*line 5\b"):
        read_points(file, reverse=True)


@pytest.mark.slow
def test_work_and_memory_grow_with_the_number_of_points(tmp_path: File) -> None:
    """A spline through all points, and a raster with many turns."""
    import tracemalloc

    peaks = []
    for n in (20_000, 80_000):
        u = np.linspace(0.0, 2.0 * math.pi, n)
        tracemalloc.start()
        fit_points(MM * np.column_stack([40.0 * np.cos(u), 20.0 * np.sin(3.0 * u)]), None, ANGLE)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 4.4 * peaks[0]
