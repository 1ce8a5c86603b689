"""Orders of convergence in geometry: derivatives by arc length, the table's quintic pieces, chords against the length."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

from contourlab.geometry import Arc, BSpline, Curve, Nurbs, Path, contour
from contourlab.geometry.parametric import Ellipse, Lemniscate, Star

HELIX = Arc((0.0, 0.0, 0.0), 0.02, 0.3, 6.0 * math.pi, rise=(0.0, 0.0, 0.015))
SPLINE = BSpline(5, np.array([(0, 0), (1, 2), (3, 1), (4, -1), (6, 0), (7, 3)]) * 0.01, [0] * 6 + [1] * 6)
SPATIAL = Nurbs(3, np.array([(0, 0, 0), (1, 2, 1), (3, 1, -1), (4, -1, 0)]) * 0.01, [0] * 4 + [1] * 4, [1, 1.3, 0.8, 1.2])
CURVES = [Arc((0, 0), 0.02, 0.3, -3.0), HELIX, Ellipse(0.04, 0.02), Lemniscate(0.04), Star(0.03, 5, 0.3), SPLINE, SPATIAL]
NAMES = ["arc", "helix", "ellipse", "lemniscate", "star", "bspline", "nurbs in space"]


class Plain(Curve):
    """A curve without marks of its own, so that all pieces of its table have equal length."""

    def __init__(self, curve: Curve) -> None:
        self.curve, self.n_axis, self.length = curve, curve.n_axis, curve.length

    def derivatives(self, s: ArrayLike, order: int = 3) -> NDArray[np.float64]:
        return self.curve.derivatives(s, order)

    def describe(self) -> bytes:
        return self.curve.describe()


def fitted_order(steps: list[float], errors: list[float]) -> float:
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])


@pytest.mark.parametrize("curve", CURVES, ids=NAMES)
@pytest.mark.parametrize("order", [1, 2, 3])
def test_each_derivative_is_the_central_difference_of_the_one_before_to_second_order(curve: Curve, order: int) -> None:
    s = np.linspace(0.1, 0.9, 37) * curve.length
    exact = curve.derivatives(s)[order]
    steps = [curve.length / n for n in (2000, 4000, 8000)]
    errors = []
    for h in steps:
        slope = (curve.derivatives(s + h)[order - 1] - curve.derivatives(s - h)[order - 1]) / (2.0 * h)
        errors.append(float(np.linalg.norm(slope - exact, axis=1).max()))
    assert 1.97 < fitted_order(steps, errors) < 2.03


@pytest.mark.parametrize("curve", CURVES[2:6], ids=NAMES[2:6])
def test_the_change_of_curvature_is_its_central_difference_to_fourth_order(curve: Curve) -> None:
    path = Path([curve])
    s = np.linspace(0.1, 0.9, 37) * path.length
    steps, errors = [path.length / n for n in (800, 1200, 1800)], []
    for h in steps:
        near, far = (path.curvature(s + k * h) - path.curvature(s - k * h) for k in (1, 2))
        errors.append(float(np.abs((8.0 * near - far) / (12.0 * h) - path.curvature_derivative(s)).max()))
    assert 3.85 < fitted_order(steps, errors) < 4.15


@pytest.mark.parametrize(("curve", "first"), list(zip(CURVES, [0.2] * 6 + [0.1], strict=True)), ids=NAMES)
def test_quintic_pieces_are_of_sixth_order(curve: Curve, first: float) -> None:
    path = Path([Plain(curve)])
    steps, errors = [], []
    # Pieces are short against the smallest radius, so that the leading term dominates; the rational curve's higher terms fade late.
    for share in (first, 0.7 * first, 0.5 * first):
        pieces = math.ceil(path.length / (share * curve.smallest_radius()))
        table = path.table(1.0, pieces=pieces)
        s = np.linspace(0.0, path.length, 20011)
        errors.append(float(np.linalg.norm(table.evaluate(s, 0)[0] - path.position(s), axis=1).max()))
        steps.append(float(np.diff(table.start).max()))
    assert 5.8 < fitted_order(steps, errors) < 6.2


@pytest.mark.parametrize(("order", "expected"), [(1, 5.0), (2, 4.0)])
def test_slope_and_bend_of_the_pieces_lose_an_order_each(order: int, expected: float) -> None:
    path = Path([Plain(Ellipse(0.04, 0.02))])
    s = np.linspace(0.0, path.length, 20011)
    steps, errors = [], []
    for pieces in (100, 150, 220):
        table = path.table(1.0, pieces=pieces)
        errors.append(float(np.linalg.norm(table.evaluate(s, order)[order] - path.derivatives(s, order)[order], axis=1).max()))
        steps.append(float(np.diff(table.start).max()))
    assert expected - 0.2 < fitted_order(steps, errors) < expected + 0.2


@pytest.mark.parametrize("name", ["circle", "ellipse", "lemniscate", "star", "butterfly"])
def test_the_number_of_pieces_grows_with_the_sixth_root_of_the_tolerance(name: str) -> None:
    path = contour(name)
    tolerances = [1e-7, 1e-8, 1e-9, 1e-10, 1e-11]
    counts = [len(path.table(tolerance).coefficients) for tolerance in tolerances]
    order = fitted_order(tolerances, [float(n) for n in counts])
    # Halving changes the number of pieces by factors of two, so a fit over four decades is slightly off.
    assert -0.20 < order < -0.13


@pytest.mark.parametrize("curve", CURVES, ids=NAMES)
def test_chord_lengths_are_of_second_order(curve: Curve) -> None:
    counts, errors = [400, 800, 1600], []
    for n in counts:
        points = curve.position(np.linspace(0.0, curve.length, n + 1))
        errors.append(curve.length - float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum()))
    assert 1.97 < fitted_order([1.0 / n for n in counts], errors) < 2.03
