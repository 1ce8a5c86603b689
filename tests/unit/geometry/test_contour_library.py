"""The contours by name: shapes, parameters, and the message for a wrong name."""

from __future__ import annotations

import math

import numpy as np
import pytest
from each import each
from scipy.special import ellipe

from contourlab.errors import GeometryError
from contourlab.geometry import contour, contour_names, contour_parameters


def area(name: str, **parameters: float) -> float:
    """Return the enclosed area, by Green's theorem over the path: the integral of (x dy - y dx) / 2."""
    path = contour(name, **parameters)
    n = 4000
    # A midpoint rule over a period is exact to rounding for a smooth closed curve, and over whole lines.
    s = (np.arange(n) + 0.5) / n * path.length
    r, t = path.derivatives(s, 1)
    return float(np.mean(r[:, 0] * t[:, 1] - r[:, 1] * t[:, 0]) * path.length / 2.0)


def test_all_names_are_there_with_defaults_and_units() -> None:
    old = ("circle", "ellipse", "lemniscate", "diamond", "star", "butterfly", "line-line-circle")
    assert contour_names() == (*old, "square", "rectangle", "racetrack", "polygon", "spiral", "helix", "lissajous")
    for name in contour_names():
        defaults = {key: value for key, (value, _) in contour_parameters(name).items()}
        assert contour(name, **defaults).digest == contour(name).digest
        assert contour(name).closed == (name not in ("line-line-circle", "spiral", "helix"))
        assert contour(name).is_planar == (name not in ("helix", "lissajous"))
    assert contour_parameters("circle") == {"radius": (0.02, "m"), "start_angle": (0.0, "rad"), "clockwise": (0.0, "")}
    assert contour_parameters("star") == {"radius": (0.03, "m"), "lobes": (5.0, ""), "depth": (0.3, "")}


def test_sizes_match_the_parameters() -> None:
    assert contour("circle", radius=0.025).length == pytest.approx(2.0 * math.pi * 0.025, rel=1e-15)
    assert contour("ellipse", a=0.04, b=0.02).length == pytest.approx(0.16 * ellipe(0.75), rel=1e-13)
    assert contour("diamond", side=0.05).length == pytest.approx(0.2, rel=1e-15)
    assert contour("butterfly", scale=0.5).length == pytest.approx(0.5 * contour("butterfly").length, rel=1e-13)
    assert contour("lemniscate", a=0.08).length == pytest.approx(2.0 * contour("lemniscate").length, rel=1e-13)
    assert contour("square", side=0.03).length == pytest.approx(0.12, rel=1e-15)
    assert contour("rectangle", width=0.05, height=0.03).length == pytest.approx(0.16, rel=1e-15)
    assert contour("rectangle", width=0.05, height=0.03, corner_radius=0.01).length == pytest.approx(0.08 + 0.02 * math.pi, rel=1e-14)
    assert contour("racetrack", length=0.05, radius=0.01).length == pytest.approx(0.1 + 0.02 * math.pi, rel=1e-15)
    assert contour("polygon", sides=5, radius=0.02).length == pytest.approx(0.2 * math.sin(math.pi / 5), rel=1e-14)
    assert contour("helix", radius=0.02, pitch=0.01, turns=2.5).length == pytest.approx(2.5 * math.hypot(0.04 * math.pi, 0.01), rel=1e-14)
    # The spiral r = b t from t = 0: b / 2 (t sqrt(1 + t^2) + asinh t).
    b, t = 0.006 / (2.0 * math.pi), 2.0 * math.pi * 3.5
    spiral = contour("spiral", inner_radius=0, pitch=0.006, turns=3.5)
    assert spiral.length == pytest.approx(0.5 * b * (t * math.hypot(1.0, t) + math.asinh(t)), rel=1e-13)
    assert contour("line-line-circle").length == pytest.approx(0.05 + 0.02 + 0.06 * math.pi, rel=1e-15)


def test_areas_match_the_parameters() -> None:
    assert area("circle", radius=0.02) == pytest.approx(math.pi * 0.02**2, rel=1e-13)
    assert area("circle", radius=0.02, clockwise=1) == pytest.approx(-math.pi * 0.02**2, rel=1e-13)
    assert area("ellipse", a=0.04, b=0.02) == pytest.approx(math.pi * 0.04 * 0.02, rel=1e-12)
    assert area("diamond", side=0.04) == pytest.approx(0.04**2, rel=1e-13)
    assert area("square", side=0.03) == pytest.approx(0.03**2, rel=1e-12)
    assert area("polygon", sides=8, radius=0.02) == pytest.approx(4.0 * 0.02**2 * math.sqrt(0.5), rel=1e-12)
    # Where arcs meet lines the midpoint rule has an error of its own.
    assert area("rectangle", width=0.05, height=0.03, corner_radius=0.01) == pytest.approx(0.0015 - (4 - math.pi) * 1e-4, rel=1e-6)
    assert area("racetrack", length=0.05, radius=0.01) == pytest.approx(0.001 + math.pi * 1e-4, rel=1e-6)
    # r = R (1 + d cos n u) encloses pi R^2 (1 + d^2 / 2); the two lobes of the eight cancel.
    assert area("star", radius=0.03, lobes=5, depth=0.3) == pytest.approx(math.pi * 0.03**2 * (1.0 + 0.045), rel=1e-11)
    assert area("lemniscate", a=0.04) == pytest.approx(0.0, abs=1e-16)


def test_turns_of_the_spiral_and_the_helix_are_a_pitch_apart() -> None:
    for name, axis in (("spiral", 0), ("helix", 2)):
        ends = [contour(name, radius=0.02, pitch=0.004, turns=k) if axis else contour(name, pitch=0.004, turns=k) for k in (1, 2, 3)]
        found = np.array([path.position(path.length)[0] for path in ends])
        np.testing.assert_allclose(np.diff(found[:, axis]), 0.004, rtol=0, atol=1e-14)
    for name in ("rectangle", "racetrack"):
        assert contour(name, **({"corner_radius": 0.005} if name == "rectangle" else {})).corners.size == 0
    assert contour("rectangle").corners.size == contour("square").corners.size == 4
    assert contour("polygon", sides=7).corners.size == 7


def test_starts_and_senses() -> None:
    np.testing.assert_allclose(contour("circle", start_angle=math.pi / 2).position(0.0), [(0.0, 0.02)], atol=1e-17)
    np.testing.assert_allclose(contour("circle", clockwise=1).tangent(0.0), [(0.0, -1.0)], atol=1e-15)
    np.testing.assert_allclose(contour("ellipse").tangent(0.0), [(0.0, 1.0)], atol=1e-12)
    np.testing.assert_allclose(contour("lemniscate").tangent(0.0), [(math.sqrt(0.5),) * 2], atol=1e-12)


def test_the_diamond_has_four_right_corners_on_the_axes() -> None:
    path = contour("diamond", side=0.04)
    half = 0.04 / math.sqrt(2.0)
    np.testing.assert_allclose(path.position(path.corners), [(half, 0.0), (0.0, half), (-half, 0.0), (0.0, -half)], atol=1e-16)
    legs = path.tangent((path.breaks[:-1] + path.breaks[1:]) / 2)
    np.testing.assert_allclose(np.einsum("ij,ij->i", legs, np.roll(legs, 1, axis=0)), 0.0, atol=1e-15)


@pytest.mark.parametrize(("lobes", "depth"), [(5, 0.3), (3, 0.1), (8, 0.0)])
def test_the_star_has_its_lobes(lobes: int, depth: float) -> None:
    path = contour("star", radius=0.03, lobes=lobes, depth=depth)
    part = path.length / lobes
    s = np.linspace(0.0, part, 50)
    turn = 2.0 * math.pi / lobes
    rotation = np.array([(math.cos(turn), math.sin(turn)), (-math.sin(turn), math.cos(turn))])
    np.testing.assert_allclose(path.position(s + part), path.position(s) @ rotation, rtol=0, atol=1e-14)
    radius = np.linalg.norm(path.position(np.array([0.0, 0.5]) * part), axis=1)
    np.testing.assert_allclose(radius, [0.03 * (1 + depth), 0.03 * (1 - depth)], rtol=1e-12)


def test_the_line_line_circle_of_the_course() -> None:
    path = contour("line-line-circle")
    np.testing.assert_allclose(path.breaks, [0.0, 0.05, 0.07, 0.07 + 0.06 * math.pi], rtol=1e-15)
    np.testing.assert_allclose(path.position(path.breaks), [(0, 0), (0.04, 0.03), (0.06, 0.03), (0.06, 0.03)], atol=1e-16)
    np.testing.assert_allclose(path.position(0.07 + 0.015 * math.pi), [(0.09, 0.0)], atol=1e-16)
    np.testing.assert_allclose(path.corners, [0.05, 0.07], rtol=1e-15)


def test_a_wrong_name_suggests_the_nearest_or_lists_the_valid_ones() -> None:
    with pytest.raises(GeometryError, match=r"'circel'.*'circle'"):
        contour("circel")
    with pytest.raises(GeometryError, match=rf"'bow'.* {', '.join(contour_names())}$"):
        contour("bow")
    with pytest.raises(GeometryError, match=r"circle.*'diameter'.* radius, start_angle, clockwise$"):
        contour("circle", diameter=0.04)
    with pytest.raises(GeometryError, match="contour ''"):
        contour_parameters("")


@each(
    "name, parameters, message",
    [
        ("circle", {"radius": 0.0}, "radius = 0.0: must be > 0"),
        ("circle", {"radius": math.nan}, "radius = nan"),
        ("circle", {"start_angle": math.nan}, "start_angle = nan"),
        ("ellipse", {"b": -0.02}, "b = -0.02: must be > 0"),
        ("lemniscate", {"a": math.inf}, "a = inf: must be > 0"),
        ("diamond", {"side": -1.0}, "side = -1.0: must be > 0"),
        ("square", {"side": 0.0}, "side = 0.0: must be > 0"),
        ("rectangle", {"corner_radius": 0.02}, "corner_radius = 0.02 m"),
        ("rectangle", {"corner_radius": math.nan}, "corner_radius = nan"),
        ("racetrack", {"length": -1.0}, "length = -1.0: must be > 0"),
        ("polygon", {"sides": 2}, "sides = 2: "),
        ("polygon", {"sides": 5.5}, "sides = 5.5: must be"),
        ("spiral", {"inner_radius": -1e-3}, "inner_radius = -0.001: must be >= 0"),
        ("spiral", {"turns": 1e9}, "turns = .*at most 1000"),
        ("helix", {"pitch": math.inf}, "pitch = inf m: "),
        ("lissajous", {"axes": 1}, "axes = 1: .*2 to 9"),
        ("lissajous", {"axes": 2.5}, "axes = 2.5: must be"),
        ("lissajous", {"lowest": 0}, "lowest = 0: .*1 to 20"),
        ("lissajous", {"amplitude": 0.0}, "amplitude = 0.0: must be > 0"),
        ("lissajous", {"phase": math.inf}, "phase = inf rad: "),
        ("lissajous", {"phase": 0.5 * math.pi}, "cusp"),
        ("lissajous", {"lowest": 3, "phase": math.pi / 6}, "lowest = 3 "),
        ("star", {"lobes": 5.5}, "5.5 lobes.*whole number"),
        ("star", {"lobes": 1}, "whole number >= 2"),
        ("star", {"depth": 1.0}, "depth from 0 to below 1"),
        ("star", {"radius": 0.0}, "radius = 0.0"),
        ("butterfly", {"scale": 0.0}, "scale = 0.0: must be > 0"),
        ("line-line-circle", {"scale": math.nan}, "scale = nan: must be > 0"),
    ],
)
def test_a_value_out_of_range_is_refused(name: str, parameters: dict[str, float], message: str) -> None:
    with pytest.raises(GeometryError, match=message):
        contour(name, **parameters)


def test_an_array_of_one_number_is_a_parameter() -> None:
    assert contour("circle", radius=np.array(0.02)).length == contour("circle", radius=0.02).length
