"""DXF drawings: every kind of entity against closed forms and ezdxf's flattening."""

from __future__ import annotations

import gc
import math
import time
from collections.abc import Callable
from pathlib import Path as File
from typing import Any

import ezdxf
import numpy as np
import pytest
from drawings import MM, area, away, dxf
from scipy.special import ellipe, ellipeinc

from contourlab.contours import read_contour
from contourlab.contours.dxf import read_dxf
from contourlab.errors import GeometryError, UnitError
from contourlab.geometry import Arc, BSpline, EllipticalArc, Line, Nurbs

FIT = [(0, 0), (10, 5), (20, -3), (30, 8)]
CONTROL = [(0, 0, 0), (10, 20, 0), (20, -15, 0), (30, 10, 0), (45, 5, 0), (50, 0, 0)]
KNOTS = [0, 0, 0, 0, 1, 2.5, 4, 4, 4, 4]
WEIGHTS = [1, 2, 0.5, 1, 3, 1]


def open_entities() -> dict[str, Callable[[Any], Any]]:
    return {
        "line": lambda m: m.add_line((1, 2), (4, 6)),
        "arc": lambda m: m.add_arc((3, 4), 5, 300, 80),
        "arc seen from below": lambda m: m.add_arc((3, 4), 5, 20, 130, dxfattribs={"extrusion": (0, 0, -1)}),
        "ellipse": lambda m: m.add_ellipse((3, 4), (6, 3), 0.4, 0.5, 4.0),
        "ellipse over zero": lambda m: m.add_ellipse((3, 4), (6, 3), 0.4, 5.5, 1.0),
        "ellipse seen from below": lambda m: m.add_ellipse((3, 4), (6, 3), 0.4, 0.5, 4.0, dxfattribs={"extrusion": (0, 0, -1)}),
        "fit spline": lambda m: m.add_spline([(*p, 0) for p in FIT]),
        "spline": lambda m: m.add_open_spline(CONTROL, degree=3, knots=KNOTS),
        "rational spline": lambda m: m.add_rational_spline(CONTROL, WEIGHTS, degree=3, knots=KNOTS),
    }


@pytest.mark.parametrize("name", open_entities())
def test_an_entity_agrees_with_the_flattening_of_ezdxf(tmp_path: File, name: str) -> None:
    made: list[Any] = []
    path = read_contour(dxf(tmp_path, lambda m: made.append(open_entities()[name](m))))
    vertices = [made[0].dxf.start, made[0].dxf.end] if name == "line" else list(made[0].flattening(0.01))
    points = MM * np.array([(p[0], p[1]) for p in vertices])
    assert away(path, points) < 1e-12
    # The same ends in the same order; slightly longer than the polygon with a sagitta of 10 um.
    np.testing.assert_allclose(path.position([0.0, path.length]), points[[0, -1]], rtol=0, atol=1e-12)
    polygon = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    assert polygon <= path.length * (1 + 1e-12) < polygon * 1.002


def test_an_unclamped_spline_runs_between_its_inner_knots(tmp_path: File) -> None:
    """As closed splines are written. The oracle is scipy, because ezdxf's flattening begins before the curve does."""
    from scipy.interpolate import BSpline as Known

    knots = np.array([0, 1, 2.2, 3, 4, 5.5, 6, 7, 8, 9.0])
    path = read_contour(dxf(tmp_path, lambda m: m.add_open_spline(CONTROL, degree=3, knots=knots.tolist())))
    known = MM * Known(knots, np.array(CONTROL, dtype=float)[:, :2], 3)(np.linspace(3.0, 6.0, 20))
    assert away(path, known) < 1e-12
    np.testing.assert_allclose(path.position([0.0, path.length]), known[[0, -1]], rtol=0, atol=1e-12)


def test_entities_stay_analytic(tmp_path: File) -> None:
    kinds = {name: type(read_contour(dxf(tmp_path, draw)).curves[0]) for name, draw in open_entities().items()}
    assert kinds["arc"] is Arc
    assert kinds["ellipse"] is EllipticalArc
    assert kinds["spline"] is kinds["fit spline"] is BSpline
    assert kinds["rational spline"] is Nurbs


def test_lengths_of_conics_are_those_of_closed_forms(tmp_path: File) -> None:
    full = read_contour(dxf(tmp_path, lambda m: m.add_ellipse((1, 1), (0, 30), 0.5)))
    assert full.closed
    assert full.length == pytest.approx(4 * 0.030 * ellipe(0.75), rel=1e-13)
    # From the end of the minor axis, ds = a sqrt(1 - m sin^2) with the angle counted from there.
    part = read_contour(dxf(tmp_path, lambda m: m.add_ellipse((1, 1), (30, 0), 0.5, math.pi / 2, math.pi / 2 + 0.7)))
    assert part.length == pytest.approx(0.030 * ellipeinc(0.7, 0.75), rel=1e-13)
    circle = read_contour(dxf(tmp_path, lambda m: m.add_circle((7, 0), 12)))
    assert circle.length == pytest.approx(2 * math.pi * 0.012, rel=1e-15)
    assert area(circle) == pytest.approx(math.pi * 0.012**2, rel=1e-13)
    assert read_contour(dxf(tmp_path, lambda m: m.add_ellipse((1, 1), (30, 0), 1.0))).length == pytest.approx(0.06 * math.pi, rel=1e-15)


@pytest.mark.parametrize("extrusion", [(0, 0, 1), (0, 0, -1)])
def test_bulges_are_arcs(tmp_path: File, extrusion: tuple[int, int, int]) -> None:
    slot = [(-10, -4, 0.0), (10, -4, 1.0), (10, 4, 0.0), (-10, 4, 1.0)]
    file = dxf(tmp_path, lambda m: m.add_lwpolyline(slot, format="xyb", close=True, dxfattribs={"extrusion": extrusion}))
    path = read_contour(file)
    assert path.closed
    assert path.corners.size == 0
    assert path.length == pytest.approx(MM * (40 + 8 * math.pi), rel=1e-14)
    assert area(path) == pytest.approx(extrusion[2] * MM**2 * (160 + 16 * math.pi), rel=1e-12)
    assert [type(curve) for curve in path.curves] == [Line, Arc, Line, Arc]


def test_a_bulge_is_the_tangent_of_a_quarter_of_its_angle(tmp_path: File) -> None:
    for angle in (0.3, -1.0, 3.0, 4.5, -5.5):
        bulge = math.tan(angle / 4)
        path = read_contour(dxf(tmp_path, lambda m, b=bulge: m.add_lwpolyline([(0, 0, b), (10, 0, 0)], format="xyb")))
        radius = 5 * MM / math.sin(abs(angle) / 2)
        assert path.length == pytest.approx(radius * abs(angle), rel=1e-12)
        # Positive: counter-clockwise, so the arc leaves to the right of its chord.
        assert math.copysign(1, path.tangent(0.0)[0, 1]) == -math.copysign(1, math.sin(angle / 2))


def test_old_polylines(tmp_path: File) -> None:
    rows = [(0, 0, 0, 0, 0), (10, 0, 0, 0, 1), (10, 6, 0, 0, 0)]
    path = read_contour(dxf(tmp_path, lambda m: m.add_polyline2d(rows, format="xyseb")))
    assert path.length == pytest.approx(MM * (10 + 3 * math.pi), rel=1e-14)
    space = read_contour(dxf(tmp_path, lambda m: m.add_polyline3d([(0, 0, 0), (1, 2, 2), (1, 2, 5)])), axes=3)
    assert space.n_axis == 3
    assert space.length == pytest.approx(6 * MM, rel=1e-14)


def test_blocks_are_resolved(tmp_path: File) -> None:
    def draw(m: Any) -> None:
        inner = m.doc.blocks.new("INNER")
        inner.add_circle((1, 0), 1)
        outer = m.doc.blocks.new("OUTER")
        outer.add_blockref("INNER", (2, 0), dxfattribs={"xscale": 2, "yscale": 1})
        m.add_blockref("OUTER", (10, 0), dxfattribs={"rotation": 90, "layer": "cut"})

    path = read_contour(dxf(tmp_path, draw), layer="CUT")
    # In OUTER the circle becomes an ellipse of 2 by 1 around (4, 0), then turned around to (10, 4).
    assert path.length == pytest.approx(4 * 2 * MM * ellipe(0.75), rel=1e-12)
    assert area(path) == pytest.approx(2 * math.pi * MM**2, rel=1e-12)
    s = np.linspace(0.0, path.length, 400, endpoint=False)
    np.testing.assert_allclose(path.position(s).min(axis=0), [0.009, 0.002], atol=1e-6)


def test_tilted_circles_need_three_axes(tmp_path: File) -> None:
    file = dxf(tmp_path, lambda m: m.add_circle((0, 0, 5), 10, dxfattribs={"extrusion": (1, 0, 1)}))
    with pytest.raises(GeometryError, match=r"\bz\b.* axes = 3"):
        read_contour(file)
    path = read_contour(file, axes=3)
    assert path.length == pytest.approx(0.02 * math.pi, rel=1e-14)
    normal = np.array([1.0, 0.0, 1.0]) / math.sqrt(2.0)
    r = path.position(np.linspace(0.0, path.length, 9))
    np.testing.assert_allclose(r @ normal, 0.005, rtol=0, atol=1e-15)


def test_units(tmp_path: File) -> None:
    def draw(m: Any) -> None:
        m.add_line((0, 0), (3, 4))

    for code, size in ((1, 0.0254), (2, 0.3048), (4, 1e-3), (5, 1e-2), (6, 1.0), (13, 1e-6)):
        assert read_contour(dxf(tmp_path, draw, units=code), tolerance=1e-8).length == pytest.approx(5 * size, rel=1e-15)
    assert read_contour(dxf(tmp_path, draw, units=4), unit="inch", scale=2.0).length == pytest.approx(10 * 0.0254, rel=1e-15)
    with pytest.raises(GeometryError, match=r'part.dxf: .*unit = "mm"'):
        read_contour(dxf(tmp_path, draw, units=0))
    with pytest.raises(UnitError, match="kg"):
        read_contour(dxf(tmp_path, draw), unit="kg")
    with pytest.raises(UnitError, match="9\\*\\*9"):
        read_contour(dxf(tmp_path, draw), unit="9**9**9")


def test_a_written_path_reads_back(tmp_path: File) -> None:
    """Lines, arcs, an elliptical arc and a spline, written shuffled and partly reversed, give the same path."""

    def draw(m: Any) -> None:
        m.add_line((0, 0), (20, 0))
        m.add_ellipse((20, 30), (10, 0), 2.0 / 10, 0, math.pi / 2)
        m.add_arc((20, 10), 10, 270, 0)
        m.add_open_spline([(0, 0, 0), (-10, 8, 0), (5, 20, 0), (20, 32, 0)], degree=3)
        m.add_line((30, 30), (30, 10))

    path = read_contour(dxf(tmp_path, draw))
    assert path.closed
    assert [type(curve) for curve in path.curves] == [Line, Arc, Line, EllipticalArc, BSpline]
    np.testing.assert_allclose(path.position(path.breaks[:-1]), MM * np.array([(0, 0), (20, 0), (30, 10), (30, 30), (20, 32)]), atol=1e-12)
    turned = read_contour(tmp_path / "part.dxf", reverse=True)
    s = np.linspace(0.0, path.length, 50)
    np.testing.assert_allclose(turned.position(s), path.position(path.length - s), rtol=0, atol=1e-12)
    assert area(turned) == pytest.approx(-area(path), rel=1e-12)


def test_undrivable_entities_are_named(tmp_path: File) -> None:
    def draw(m: Any) -> None:
        m.add_circle((0, 0), 5, dxfattribs={"layer": "cut"})
        m.add_text("note", dxfattribs={"layer": "words"})
        m.add_hatch(dxfattribs={"layer": "cut"})
        m.add_point((0, 0), dxfattribs={"layer": "words"})

    file = dxf(tmp_path, draw)
    with pytest.raises(GeometryError, match=r'1 TEXT.*words; 1 HATCH.*cut; 1 POINT.*words.*ignore = \["TEXT", "HATCH", "POINT"\]'):
        read_contour(file)
    with pytest.raises(GeometryError, match=r": contains 1 HATCH[^;]*cut[^;]*$"):
        read_contour(file, layer="cut")
    assert read_contour(file, ignore=["text", "HATCH", "POINT"]).closed
    drawing = read_dxf(file)
    assert [(item.kind, item.layer) for item in drawing.left_out] == [("TEXT", "words"), ("HATCH", "cut"), ("POINT", "words")]
    with pytest.raises(GeometryError, match=r"'cuts' .*cut, words"):
        read_contour(file, layer="cuts")
    with pytest.raises(GeometryError, match="no contour;"):
        read_contour(file, layer="words", ignore=["TEXT", "POINT"])


def test_files_that_are_not_drawings(tmp_path: File) -> None:
    file = tmp_path / "part.dxf"
    with pytest.raises(GeometryError, match=r"no file .*part\.dxf"):
        read_contour(file)
    for content in (b"", b"hello\n", b"\x00\xff" * 50, b"0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nabc\n0\nENDSEC\n0\nEOF\n"):
        file.write_bytes(content)
        with pytest.raises(GeometryError, match=r"part\.dxf"):
            read_contour(file, unit="mm")
    for name in ("part.step", "part"):
        with pytest.raises(GeometryError, match=r"\.dxf, \.svg, \.csv"):
            read_contour(tmp_path / name)


def test_old_files_without_units_need_a_given_unit(tmp_path: File) -> None:
    document = ezdxf.new("R12")  # type: ignore[attr-defined]
    document.modelspace().add_line((0, 0), (1, 0))
    document.header["$INSUNITS"] = 0
    document.saveas(tmp_path / "old.dxf")
    with pytest.raises(GeometryError, match="no unit"):
        read_contour(tmp_path / "old.dxf")
    assert read_contour(tmp_path / "old.dxf", unit="mm").length == pytest.approx(1e-3)


@pytest.mark.slow
def test_two_thousand_splines_are_read_in_seconds(tmp_path: File) -> None:
    rng = np.random.default_rng(0)

    def draw(m: Any) -> None:
        begin = np.zeros(2)
        for _ in range(2000):
            points = np.concatenate([[begin], begin + np.cumsum(rng.uniform(0.1, 1.0, (7, 2)), axis=0)])
            m.add_open_spline([(x, y, 0.0) for x, y in points])
            begin = points[-1]

    file = dxf(tmp_path, draw)
    start = time.perf_counter()
    path = read_contour(file)
    assert len(path.curves) == 2000
    assert time.perf_counter() - start < 30.0  # about 4 s on an idle machine


@pytest.mark.slow
def test_ten_thousand_lines_are_read_in_a_moment(tmp_path: File) -> None:
    """Twice as many lines may take twice as long and some more, not four times."""
    took = []
    for n in (2500, 10_000):
        corners = [(i, (i * i) % 7) for i in range(n + 1)]
        order = np.random.default_rng(0).permutation(n)
        file = dxf(tmp_path, lambda m, c=corners, o=order: [m.add_line(c[i], c[i + 1]) for i in o])
        times = []
        for _ in range(2):  # the better of two: a busy machine must not fail the test
            gc.disable()  # garbage collection would also visit what other tests left
            start = time.process_time()
            path = read_contour(file, unit="mm")
            times.append(time.process_time() - start)
            gc.enable()
        took.append(min(times))
        assert len(path.curves) == n
        lengths = np.linalg.norm(np.diff(MM * np.array(corners), axis=0), axis=1)
        assert path.length == pytest.approx(lengths.sum(), rel=1e-12)
    assert took[1] < 10.0 * took[0]
