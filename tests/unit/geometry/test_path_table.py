"""The table of quintic pieces: error bound, look-up at the borders, cost; and the compilable view."""

from __future__ import annotations

import math
import pickle
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
from each import each
from numpy.typing import NDArray

from contourlab.errors import GeometryError
from contourlab.geometry import Arc, Line, Path, contour, contour_names
from contourlab.geometry.table import PathTable
from contourlab.geometry.view import PathView, view_of

Array = NDArray[np.float64]
HELIX = Path([Arc((0.0, 0.0, 0.0), 0.02, 0.3, 6.0 * math.pi, rise=(0.0, 0.0, 0.015))])
ROUNDING = 4e-16


def spread(table: PathTable) -> Array:
    """Return arc lengths inside every piece, at its borders, and one bit to either side of them."""
    inside = table.start[:-1, None] + np.diff(table.start)[:, None] * np.linspace(0.0, 1.0, 14)
    borders = table.start
    return np.clip(np.concatenate([inside.ravel(), borders, np.nextafter(borders, -1.0), np.nextafter(borders, 1e9)]), 0.0, table.length)


@pytest.mark.parametrize("name", contour_names())
@pytest.mark.parametrize("tolerance", [1e-12, 1e-9, 1e-6, 1e-3])
def test_no_point_of_the_table_exceeds_its_error_bound(name: str, tolerance: float) -> None:
    path = contour(name)
    table = path.table(tolerance)
    assert table.error_bound <= tolerance
    s = spread(table)
    off = np.linalg.norm(table.evaluate(s, 0)[0] - path.position(s), axis=1)
    assert off.max() <= table.error_bound + ROUNDING * (path.length + 0.1)


def test_the_bound_of_arcs_is_proven_and_nearly_reached() -> None:
    for path in (contour("circle"), HELIX):
        table = path.table(1e-8)
        arc = path.curves[0]
        assert isinstance(arc, Arc)
        h = np.diff(table.start)
        np.testing.assert_allclose(h, h[0], rtol=1e-12)
        # The remainder of two-point Hermite interpolation of order five: h^6 / (2^6 6!) times the greatest sixth derivative.
        assert table.error_bound == pytest.approx(h[0] ** 6 * arc.radius * abs(arc.rate) ** 6 / (64.0 * math.factorial(6)), rel=1e-12)
        middle = table.start[:-1] + 0.5 * h
        off = np.linalg.norm(table.evaluate(middle, 0)[0] - path.position(middle), axis=1)
        assert 0.95 * table.error_bound < off.max() <= table.error_bound + 1e-16


@each("name", contour_names())
def test_pieces_meet_the_path_at_their_borders_up_to_curvature(name: str) -> None:
    path = contour(name)
    table = path.table(1e-8)
    inside = table.start[:-1]
    # Arc length is accurate to 1e-14 of the path, and the tangent changes by that times the curvature.
    sharpest = max(np.abs(path.curvature(inside)).max(), 1.0)
    digits = 1e-13 + 3e-14 * path.length * sharpest
    np.testing.assert_allclose(table.evaluate(inside, 0), path.derivatives(inside, 0), rtol=0, atol=1e-13)
    np.testing.assert_allclose(table.evaluate(inside, 1)[1], path.tangent(inside), rtol=0, atol=digits)
    # Limits from the left: the piece that ends there, evaluated a few bits before its end, so that rounding cannot select the next one.
    before = table.start[1:] * (1.0 - 1e-15)
    at = path.derivatives(before, 2)
    found = table.evaluate(before, 2)
    np.testing.assert_allclose(found[0], at[0], rtol=0, atol=1e-13)
    np.testing.assert_allclose(found[1], at[1], rtol=0, atol=10 * digits)
    np.testing.assert_allclose(found[2], at[2], rtol=0, atol=1e-8 * sharpest)


def test_no_piece_crosses_a_joint() -> None:
    for name in ("diamond", "line-line-circle"):
        path = contour(name)
        table = path.table(1e-9)
        for at in path.breaks:
            assert np.abs(table.start - at).min() <= 1e-16
        corner = path.breaks[1]
        before, after = table.evaluate([np.nextafter(corner, 0.0), corner], 1)[1]
        np.testing.assert_allclose([before, after], path.tangent([np.nextafter(corner, 0.0), corner]), rtol=0, atol=1e-14)


@each("name", contour_names())
def test_the_look_up_with_one_comparison_agrees_with_a_search(name: str) -> None:
    table = contour(name).table(1e-9)
    s = spread(table)
    s = s[s < table.length]
    i = table.cell[(s * table.inverse_cell).astype(int)].astype(int)
    i = i + (s >= table.start[i + 1])
    expected = np.searchsorted(table.start, s, side="right") - 1
    # One bit before a border the division may round into the next cell: the next piece then starts one bit early.
    early = (i == expected + 1) & (s >= np.nextafter(table.start[expected + 1], -1.0) * (1.0 - 4e-16))
    assert ((i == expected) | early).all()
    assert np.diff(table.start).min() > 1.0 / table.inverse_cell


def test_a_closed_table_continues_in_laps_and_an_open_one_stops() -> None:
    closed, opened = contour("star").table(1e-9), contour("line-line-circle").table(1e-9)
    s = np.linspace(0.01, 0.99, 50) * closed.length
    np.testing.assert_allclose(closed.evaluate(s - 3.0 * closed.length), closed.evaluate(s), rtol=1e-9, atol=1e-9)
    ends = opened.evaluate([-1.0, 0.0, opened.length, 99.0], 0)[0]
    np.testing.assert_allclose(ends, [(0.0, 0.0), (0.0, 0.0), (0.06, 0.03), (0.06, 0.03)], atol=1e-15)


def test_the_cost_is_proportional_to_the_length() -> None:
    counts = [len(Path([Arc((0.0, 0.0), 0.02, 0.0, turns * 2.0 * math.pi)]).table(1e-10).coefficients) for turns in (10, 20, 40, 80)]
    np.testing.assert_allclose(np.diff(counts), counts[0] * np.array([1, 2, 4]), atol=2)
    assert [len(Path([Line((0.0, 0.0), (x, 0.0))]).table(1e-10).coefficients) for x in (1e-6, 1.0, 1e6)] == [1, 1, 1]
    zigzag = [(0.001 * k, 0.001 * (k % 2)) for k in range(2001)]
    table = Path([Line(a, b) for a, b in pairwise(zigzag)]).table(1e-10)
    assert len(table.coefficients) == 2000
    assert len(table.cell) <= 2003
    # A whole contour at a tenth of a nanometre has a few thousand pieces, not a million.
    assert len(contour("butterfly").table(1e-10).coefficients) < 5000


@pytest.mark.parametrize("name", contour_names())
@pytest.mark.parametrize("pieces", [7, 100, 999])
def test_the_requested_number_of_pieces_is_given_without_slivers(name: str, pieces: int) -> None:
    path = contour(name)
    plain, table = path.table(1e-6), path.table(1e-6, pieces=pieces)
    h = np.diff(table.start)
    assert len(h) >= pieces
    assert h.max() <= path.length / pieces * (1.0 + 1e-9)
    assert h.min() >= 0.5 * min(np.diff(plain.start).min(), path.length / pieces) * (1.0 - 1e-9)
    assert table.error_bound <= 1e-6


def test_invalid_settings_are_refused() -> None:
    for tolerance in (0.0, -1.0, math.nan):
        with pytest.raises(GeometryError, match=rf"tolerance = {tolerance}: .*> 0 m"):
            contour("circle").table(tolerance)
    with pytest.raises(GeometryError, match=r"Ellipse: .*1e-30 m"):
        contour("ellipse").table(1e-30)


def seen(view: PathView, s: float) -> Array:
    """Evaluate a view in plain Python."""
    tables = {name: np.ravel(values) for name, values in view.tables.items()}
    return np.array(view.evaluate(SimpleNamespace(**view.parameters, **tables), s))


@pytest.mark.parametrize("clockwise", [0, 1])
def test_the_closed_form_circle_equals_its_table(clockwise: int) -> None:
    path = contour("circle", radius=0.025, start_angle=0.7, clockwise=clockwise)
    analytic, table = view_of(path), view_of(path, 1e-12, analytic=False)
    assert not analytic.tables
    assert table.tables
    for s in [0.0, 0.01, 0.1, path.length, 1.7 * path.length, -0.3 * path.length, 40.2 * path.length]:
        exact = path.derivatives(s, 2)[:, 0]
        np.testing.assert_allclose(seen(analytic, s), exact, rtol=0, atol=2e-12)
        np.testing.assert_allclose(seen(table, s)[:2], exact[:2], rtol=0, atol=1e-8)
        np.testing.assert_allclose(seen(table, s)[0], exact[0], rtol=0, atol=1.1e-12)


def test_a_circle_anywhere_is_recognised() -> None:
    u, v = np.array([math.sin(1.1), math.cos(1.1)]), np.array([math.cos(1.1), -math.sin(1.1)])
    for frame in ((u, v), (v, u)):
        path = Path([Arc((0.3, -0.2), 0.05, 2.0, -2.0 * math.pi, *frame)], closed=True)
        view = view_of(path)
        for s in (0.0, 0.05, 0.2, 0.31):
            np.testing.assert_allclose(seen(view, s), path.derivatives(s, 2)[:, 0], rtol=0, atol=2e-14 / 0.05)


@each("path", [*map(contour, contour_names()[1:]), HELIX])
def test_a_view_equals_its_table(path: Path) -> None:
    view, table = view_of(path, 1e-9), path.table(1e-9)
    laps = (-0.4, 1.0, 2.3) if path.closed else (-0.4, 1.0, 1.3)
    picks = np.concatenate(
        [table.start[:: max(len(table.start) // 40, 1)], np.array(laps) * path.length, np.linspace(0.0, path.length, 41)]
    )
    for s in picks:
        np.testing.assert_allclose(seen(view, float(s)), table.evaluate(s)[:, 0], rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("short", [1e-6, 1e-8, 3e-10])
def test_very_short_pieces_between_long_ones_cost_halvings_and_no_memory(short: float) -> None:
    # A straight line cut into pieces of different height: the position is the arc length if the right piece is found.
    marks = np.unique(np.concatenate([[0.0], 1.0 + short * np.arange(20), np.linspace(1.5, 2.0, 5)]))
    tops = np.arange(len(marks)) % 2
    path = Path([Line(a, b) for a, b in pairwise(np.column_stack([marks, short * tops]).tolist())])
    table, view = path.table(1e-10), view_of(path, 1e-10)
    assert table.halvings > 0
    assert len(table.cell) <= 4097
    s = np.concatenate([spread(table), np.linspace(0.0, path.length, 997)])
    np.testing.assert_allclose(table.evaluate(s, 0)[0], path.position(s), rtol=0, atol=1e-15)
    inside = s[np.abs(s[:, None] - path.breaks).min(axis=1) > 1e-14]
    np.testing.assert_array_equal(table.evaluate(inside, 1)[1], path.tangent(inside))
    for x in inside[:: max(len(inside) // 200, 1)]:
        np.testing.assert_array_equal(seen(view, float(x)), table.evaluate(x)[:, 0])


def test_the_cells_of_a_table_are_proportional_to_its_pieces() -> None:
    for n in (100, 1000, 10000):
        ends = np.cumsum(np.where(np.arange(n) % 2, 1e-9, 1e-2))
        table = Path(Line.many(np.column_stack([ends[:-1], 0.0 * ends[1:]]), np.column_stack([ends[1:], 0.0 * ends[1:]]))).table(1e-10)
        assert len(table.cell) <= max(4096, 8 * n) + 1
        assert table.halvings <= 3


@pytest.mark.parametrize("name", ["circle", "ellipse"])
def test_a_view_travels_to_another_process(name: str) -> None:
    view = view_of(contour(name), tolerance=1e-8)
    again = pickle.loads(pickle.dumps(view))
    par = SimpleNamespace(**view.parameters, **{key: np.ravel(table).tolist() for key, table in view.tables.items()})
    assert again.path.digest == view.path.digest and again.parameters == view.parameters
    for s in np.linspace(0.0, view.path.length, 7):
        assert again.evaluate(par, float(s)) == view.evaluate(par, float(s))
