"""Margins against textbook loops and python-control."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable

import control
import numpy as np
import pytest

from contourlab.analysis.linear.margins import margins
from contourlab.components.contract import LinearModel
from contourlab.papers.ghaffari.axis_response import transfer

W = np.logspace(-3, 3, 601)
# Crossings are found to rounding, even between the points of the grid.
EXACT = 1e-9
Loop = Callable[[np.ndarray], np.ndarray]


def third_order(gain: float) -> Loop:
    return lambda w: gain / (1j * w * (1j * w + 1.0) * (1j * w + 2.0))


def test_an_unstable_loop_has_no_margins() -> None:
    """Its curve still has crossings: K = 12 is twice the stable gain."""
    found = margins(third_order(12.0), W, stable=False)
    assert not found.stable
    assert all(math.isnan(value) for value in (found.gain, found.phase, found.crossover, found.modulus, found.phase_crossover))


def test_a_lead_that_would_reach_minus_one_is_negative() -> None:
    """A resonance delayed past -180 deg: where its peak falls to 1 the phase is -325 deg, a lag of 145 or a lead of 215."""

    def loop(w: np.ndarray) -> np.ndarray:
        s = 1j * w
        return np.asarray(2.0 * np.exp(-0.5 * s * math.pi) / (s * s + 0.4 * s + 4.0))

    found = margins(loop, W, stable=True)
    at = 1j * found.crossover
    value = complex(loop(np.array([found.crossover]))[0])
    assert abs(value) == pytest.approx(1.0, rel=EXACT)
    # Rotated by the margin (a lag if it is positive), the loop is at -1.
    assert value * np.exp(-1j * found.phase) == pytest.approx(-1.0, abs=1e-8), at


def test_integrator_with_delay() -> None:
    """L = w_c e^(-s T)/s: phase margin pi/2 - w_c T at w_c, gain margin pi/(2 w_c T)."""
    for crossover, delay in ((10.0, 0.02), (50.0, 0.01), (3.0, 0.1)):
        grid = np.linspace(0.01, 20.0 / delay, 2000)
        found = margins(lambda w, c=crossover, d=delay: c * np.exp(-1j * w * d) / (1j * w), grid, stable=True)
        assert found.crossover == pytest.approx(crossover, rel=EXACT)
        assert found.phase == pytest.approx(math.pi / 2 - crossover * delay, rel=EXACT)
        assert found.gain == pytest.approx(math.pi / (2.0 * crossover * delay), rel=EXACT)


def test_modulus_margin() -> None:
    """1/s keeps a distance of 1 from -1, reached at infinite frequency; for another loop python-control gives the value."""
    assert margins(lambda w: 1.0 / (1j * w), W, stable=True).modulus == pytest.approx(1.0, abs=1e-6)
    loop = control.tf([4.0], [1.0, 3.0, 2.0, 0.0])
    assert margins(lambda w: loop(1j * w), W, stable=True).modulus == pytest.approx(control.stability_margins(loop)[2], rel=1e-5)


def test_modulus_margin_between_the_points_of_the_grid() -> None:
    """|1 + L|^2 = (1 - K w^-2)^2 + w^2 c^2 of L = -K/w^2 + j c w: a grid of 40 points per decade misses its minimum."""
    k, c = 4.0, 0.05
    w = np.linspace(1.5, 2.5, 2_000_001)
    least = np.sqrt((1.0 - k / w**2) ** 2 + (c * w) ** 2).min()
    grid = np.logspace(-1, 1, 80)
    assert np.sqrt((1.0 - k / grid**2) ** 2 + (c * grid) ** 2).min() > 1.01 * least
    found = margins(lambda w: -k / w**2 + 1j * c * w, grid, stable=True)
    assert found.modulus == pytest.approx(least, rel=1e-9)


@pytest.mark.parametrize(
    ("numerator", "denominator"),
    [
        ([8.0], [1.0, 3.0, 3.0, 1.0, 0.0]),
        ([10.0, 10.0], [1.0, 10.0, 0.0, 0.0]),
        ([0.3, 1.5, 2.0], [1.0, 1.2, 3.0, 0.4]),
        ([200.0], [1.0, 35.0, 250.0, 0.0]),
        # A resonance has three crossings of 1; the last one has a large negative phase margin.
        ([0.3], [0.3, 1.006, 0.32, 1.0, 0.0]),
        # Conditionally stable: unstable with less gain.
        ([30.0, 60.0, 30.0], [1.0, 0.0, 0.0, 0.0]),
    ],
)
def test_agrees_with_python_control(numerator: list[float], denominator: list[float]) -> None:
    loop = control.tf(numerator, denominator)
    found = margins(lambda w: loop(1j * w), W, stable=True)
    factors, phases, _, turns, crossovers, _ = control.stability_margins(loop, returnall=True)
    larger = [(float(g), float(w)) for g, w in zip(factors, turns, strict=True) if g > 1.0]
    assert found.gain == pytest.approx(min(larger, default=(math.inf, math.nan))[0], rel=1e-6)
    if larger:
        assert found.phase_crossover == pytest.approx(min(larger)[1], rel=1e-6)
    least = int(np.argmin(np.abs(phases)))
    assert found.phase == pytest.approx(math.radians(phases[least]), rel=1e-6)
    assert found.crossover == pytest.approx(float(crossovers[least]), rel=1e-6)


def test_the_positive_real_axis_is_no_limit() -> None:
    """0.8 e^(j (1 - w))/(1 + w/10): real and positive at 1, first negative at 1 + pi."""
    found = margins(lambda w: 0.8 * np.exp(1j * (1.0 - w)) / (1.0 + w / 10.0), np.linspace(0.1, 30.0, 400), stable=True)
    assert found.phase_crossover == pytest.approx(1.0 + math.pi, rel=EXACT)
    assert found.gain == pytest.approx((1.0 + (1.0 + math.pi) / 10.0) / 0.8, rel=EXACT)


def test_the_end_of_the_grid_counts_where_the_loop_is_real() -> None:
    """A sampled loop is real at half the sampling frequency: here it meets the axis there and nowhere else."""
    grid = np.linspace(0.01, math.pi, 300)
    # 0.4/(z - 0.2): at z = -1 it is -1/3, so three times the gain puts the pole 0.2 - 1.2 on -1.
    found = margins(lambda w: 0.4 / (np.exp(1j * w) - 0.2), grid, stable=True)
    assert found.gain == pytest.approx(3.0, rel=EXACT)
    assert found.phase_crossover == pytest.approx(math.pi)


def test_a_loop_that_never_reaches_one() -> None:
    found = margins(lambda w: 0.01 / (1j * w + 1.0), W, stable=True)
    assert (found.gain, found.phase) == (math.inf, math.inf)
    assert math.isnan(found.crossover)


def test_transfer_against_python_control() -> None:
    rng = np.random.default_rng(2)
    a, b, c, d = rng.normal(size=(5, 5)) - 3.0 * np.eye(5), rng.normal(size=(5, 2)), rng.normal(size=(3, 5)), rng.normal(size=(3, 2))
    model = LinearModel(a, b, c, d, ("u", "w"), ("x", "y", "z"))
    points = 1j * W[::50]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        theirs = np.moveaxis(control.ss(a, b, c, d)(points), 2, 0)
    assert transfer(model, points) == pytest.approx(theirs, rel=1e-10)


def test_transfer_of_a_gain() -> None:
    """Without states there is nothing to solve."""
    model = LinearModel(np.zeros((0, 0)), np.zeros((0, 1)), np.zeros((2, 0)), np.array([[2.0], [3.0]]), ("u",), ("x", "y"))
    assert transfer(model, [1j, 5.0]).tolist() == [[[2.0], [3.0]]] * 2
