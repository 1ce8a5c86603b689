"""Margins against textbook loops and python-control."""

from __future__ import annotations

import math
import warnings

import control
import numpy as np
import pytest

from contourlab.analysis import margins, transfer
from contourlab.components.contract import LinearModel

W = np.logspace(-3, 3, 6001)
S = 1j * W
# Crossings are interpolated on the grid: second order in its step, ln(10)/1000.
GRID = 1e-5


def test_third_order_loop() -> None:
    """L = K/(s (s + 1) (s + 2)): the phase is -180 deg at sqrt 2, where |L| = K/6."""
    for gain in (0.5, 2.0, 5.0):
        found = margins(W, gain / (S * (S + 1.0) * (S + 2.0)))
        assert found.gain == pytest.approx(6.0 / gain, rel=GRID)
        w = found.crossover
        assert gain == pytest.approx(w * math.hypot(w, 1.0) * math.hypot(w, 2.0), rel=GRID)
        assert found.phase == pytest.approx(math.pi / 2 - math.atan(w) - math.atan(w / 2.0), rel=GRID)


def test_past_the_limit_the_phase_margin_is_negative() -> None:
    found = margins(W, 12.0 / (S * (S + 1.0) * (S + 2.0)))
    assert found.phase < 0.0
    assert found.gain == math.inf  # no larger gain brings it to -1


def test_integrator_with_delay() -> None:
    """L = w_c e^(-s T)/s: phase margin pi/2 - w_c T at w_c, gain margin pi/(2 w_c T)."""
    for crossover, delay in ((10.0, 0.02), (50.0, 0.01), (3.0, 0.1)):
        found = margins(W, crossover * np.exp(-S * delay) / S)
        assert found.crossover == pytest.approx(crossover, rel=GRID)
        assert found.phase == pytest.approx(math.pi / 2 - crossover * delay, rel=1e-4)
        assert found.gain == pytest.approx(math.pi / (2.0 * crossover * delay), rel=1e-4)


def test_second_order_phase_margin() -> None:
    """w_n^2/(s (s + 2 zeta w_n)): PM = atan(2 zeta/sqrt(sqrt(1 + 4 zeta^4) - 2 zeta^2)), and an infinite gain margin."""
    for zeta in (0.2, 0.5, 0.7, 1.0):
        found = margins(W, 1.0 / (S * (S + 2.0 * zeta)))
        law = math.atan(2.0 * zeta / math.sqrt(math.sqrt(1.0 + 4.0 * zeta**4) - 2.0 * zeta**2))
        assert found.phase == pytest.approx(law, rel=GRID)
        assert found.gain == math.inf


def test_modulus_margin() -> None:
    """1/s keeps a distance of 1 from -1, met at infinite frequency; another loop as python-control finds it."""
    assert margins(W, 1.0 / S).modulus == pytest.approx(1.0, abs=1e-6)
    loop = control.tf([4.0], [1.0, 3.0, 2.0, 0.0])
    assert margins(W, loop(S)).modulus == pytest.approx(control.stability_margins(loop)[2], rel=1e-5)


@pytest.mark.parametrize(
    ("numerator", "denominator"),
    [
        ([8.0], [1.0, 3.0, 3.0, 1.0, 0.0]),
        ([10.0, 10.0], [1.0, 10.0, 0.0, 0.0]),
        ([0.3, 1.5, 2.0], [1.0, 1.2, 3.0, 0.4]),
        ([200.0], [1.0, 35.0, 250.0, 0.0]),
        # A resonance: three crossings of 1, of which the last has a large negative phase margin.
        ([0.3], [0.3, 1.006, 0.32, 1.0, 0.0]),
        # Conditionally stable: with less gain it is not.
        ([30.0, 60.0, 30.0], [1.0, 0.0, 0.0, 0.0]),
    ],
)
def test_as_python_control(numerator: list[float], denominator: list[float]) -> None:
    loop = control.tf(numerator, denominator)
    found = margins(W, loop(S))
    factors, phases, _, _, crossovers, _ = control.stability_margins(loop, returnall=True)
    larger = [float(g) for g in factors if g > 1.0]
    assert found.gain == pytest.approx(min(larger, default=math.inf), rel=1e-4)
    least = int(np.argmin(np.abs(phases)))
    assert found.phase == pytest.approx(math.radians(phases[least]), rel=1e-4)
    assert found.crossover == pytest.approx(float(crossovers[least]), rel=1e-4)


def test_margins_mean_what_they_say() -> None:
    """A delay of exactly the phase margin, or a gain of exactly the gain margin, puts a pole on the axis: 1 + L = 0 somewhere."""
    loop = 200.0 / (S * (S + 10.0) * (S + 25.0))
    found = margins(W, loop)
    late = loop * np.exp(-S * found.phase / found.crossover)
    # From one frequency of the grid to the next the loop changes by its slope, less than 3 decades a decade, times the step.
    step = math.log(10.0) / 1000.0
    assert np.abs(1.0 + late).min() < 3.0 * step
    assert np.abs(1.0 + found.gain * loop).min() < 3.0 * step
    assert np.abs(1.0 + loop).min() > 30.0 * step


def test_a_loop_that_never_reaches_one() -> None:
    found = margins(W, 0.01 / (S + 1.0))
    assert (found.gain, found.phase) == (math.inf, math.inf)
    assert math.isnan(found.crossover)


def test_transfer_against_python_control() -> None:
    rng = np.random.default_rng(2)
    a, b, c, d = rng.normal(size=(5, 5)) - 3.0 * np.eye(5), rng.normal(size=(5, 2)), rng.normal(size=(3, 5)), rng.normal(size=(3, 2))
    model = LinearModel(a, b, c, d, ("u", "w"), ("x", "y", "z"))
    points = S[::500]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        theirs = np.moveaxis(control.ss(a, b, c, d)(points), 2, 0)
    assert transfer(model, points) == pytest.approx(theirs, rel=1e-10)


def test_transfer_of_a_gain() -> None:
    """Without states there is nothing to solve."""
    model = LinearModel(np.zeros((0, 0)), np.zeros((0, 1)), np.zeros((2, 0)), np.array([[2.0], [3.0]]), ("u",), ("x", "y"))
    assert transfer(model, [1j, 5.0]).tolist() == [[[2.0], [3.0]]] * 2
