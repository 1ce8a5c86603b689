"""The ellipse of two quadrature signals: recovery of its constants, and the errors that they cause."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from contourlab.analysis.encoder import QuadratureConstants, fit_ellipse, subdivisional_error
from contourlab.errors import ParameterError

TURN = 2.0 * math.pi
MODELS = st.builds(
    QuadratureConstants,
    offset_1=st.floats(-0.3, 0.3),
    offset_2=st.floats(-0.3, 0.3),
    ratio=st.floats(0.7, 1.4),
    phase_error=st.floats(-0.5, 0.5),
)


def signals(model: QuadratureConstants, phase: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the signals from their definition, written out independently."""
    u1, u2 = model.amplitude * np.cos(phase), model.amplitude * np.sin(phase)
    al = model.phase_error
    return u1 + model.offset_1, (u2 * math.cos(al) - u1 * math.sin(al)) / model.ratio + model.offset_2


def gap(found: QuadratureConstants, true: QuadratureConstants) -> float:
    """Return the largest difference of the constants, with lengths relative to the amplitude."""
    size = true.amplitude
    lengths = [abs(getattr(found, name) - getattr(true, name)) / size for name in ("offset_1", "offset_2", "amplitude")]
    return max(*lengths, abs(found.ratio - true.ratio), abs(found.phase_error - true.phase_error))


@given(model=MODELS, size=st.floats(1e-6, 1e6), seed=st.integers(0, 99))
def test_heydemanns_constants_are_recovered_to_rounding(model: QuadratureConstants, size: float, seed: int) -> None:
    true = QuadratureConstants(model.offset_1 * size, model.offset_2 * size, model.ratio, model.phase_error, size)
    phase = np.random.default_rng(seed).uniform(0.0, 40.0, 800)
    fit = fit_ellipse(*signals(true, phase))
    assert gap(fit.constants, true) < 1e-12
    assert fit.scatter < 1e-12


@given(model=MODELS, p=st.floats(-20.0, 20.0), q=st.floats(-20.0, 20.0))
def test_offsets_may_be_larger_than_the_amplitude(model: QuadratureConstants, p: float, q: float) -> None:
    true = QuadratureConstants(p, q, model.ratio, model.phase_error)
    found = fit_ellipse(*signals(true, np.linspace(0.0, 30.0, 500))).constants
    assert gap(found, true) < 1e-10


@given(model=MODELS)
def test_coefficients_are_those_of_the_ellipse_and_of_heydemanns_formulas(model: QuadratureConstants) -> None:
    a, b, c, d, e = model.coefficients()
    x, y = signals(model, np.linspace(0.0, TURN, 50))
    assert a * x * x + b * y * y + c * x * y + d * x + e * y == pytest.approx(np.ones(50), abs=1e-12)
    assert math.asin(c / math.sqrt(4.0 * a * b)) == pytest.approx(model.phase_error, abs=1e-12)
    assert math.sqrt(b / a) == pytest.approx(model.ratio, rel=1e-12)
    assert (2.0 * b * d - e * c) / (c * c - 4.0 * a * b) == pytest.approx(model.offset_1, abs=1e-12)
    assert (2.0 * a * e - d * c) / (c * c - 4.0 * a * b) == pytest.approx(model.offset_2, abs=1e-12)
    assert gap(QuadratureConstants.from_coefficients(a, b, c, d, e), model) < 1e-12


@given(model=MODELS)
def test_correction_removes_every_error(model: QuadratureConstants) -> None:
    phase = np.linspace(-3.0, 3.0, 200)
    assert np.array(model.distorted(phase)) == pytest.approx(np.array(signals(model, phase)), abs=1e-14)
    u1, u2 = model.corrected(*signals(model, phase))
    assert np.arctan2(u2, u1) == pytest.approx(phase, abs=1e-13)


@pytest.mark.parametrize(
    ("name", "order", "share"),
    [("offset_1", 1, 1.0), ("offset_2", 1, 1.0), ("ratio", 2, 0.5), ("phase_error", 2, 0.5)],
)
def test_each_constant_causes_its_own_harmonic(name: str, order: int, share: float) -> None:
    """Offset: once per pitch, p/R rad; ratio and phase: twice, (r - 1)/2 and al/2 rad. The rest is of second order."""
    phase = np.linspace(0.0, 6.0 * TURN, 6000, endpoint=False)
    rest = []
    for size in (0.02, 0.01):
        value = 1.0 + size if name == "ratio" else size
        x, y = signals(QuadratureConstants(**{name: value}), phase)
        off = np.angle((x + 1j * y) * np.exp(-1j * phase))
        found = subdivisional_error(off, phase)
        assert int(np.argmax(found.orders)) == order - 1
        assert found.orders[order - 1] == pytest.approx(share * size, rel=size)
        rest.append(abs(found.orders[order - 1] - share * size) + sum(found.orders) - found.orders[order - 1])
        np.testing.assert_allclose(QuadratureConstants(**{name: value}).error_without(phase), off, rtol=0.0, atol=1e-12)
    assert 3.0 < rest[0] / rest[1] < 9.0


def test_noise_moves_the_constants_by_its_size_over_the_root_of_the_samples() -> None:
    true, n, sigma = QuadratureConstants(0.05, -0.1, 1.1, 0.07), 40_000, 0.01
    rng = np.random.default_rng(5)
    found = []
    for _ in range(20):
        x, y = signals(true, rng.uniform(0.0, TURN, n))
        found.append(fit_ellipse(x + rng.normal(0.0, sigma, n), y + rng.normal(0.0, sigma, n)).constants)
    spread = [np.std([getattr(one, name) for one in found]) for name in ("offset_1", "offset_2", "ratio", "phase_error")]
    # Mean over n points of a circle: sqrt(2/n) sigma for the centre, twice that for second harmonics.
    assert max(spread) < 3.0 * math.sqrt(2.0 / n) * sigma
    assert min(spread) > 0.3 * math.sqrt(2.0 / n) * sigma
    # The bias of algebraic distances is of the order of sigma^2.
    bias = [
        np.mean([getattr(one, name) for one in found]) - getattr(true, name) for name in ("offset_1", "offset_2", "ratio", "phase_error")
    ]
    assert np.abs(bias).max() < 5.0 * sigma**2 + 3.0 * max(spread) / math.sqrt(20.0)


def a_line() -> tuple[np.ndarray, np.ndarray]:
    x = np.linspace(-1.0, 1.0, 100)
    return x, 0.5 * x


def an_arc() -> tuple[np.ndarray, np.ndarray]:
    phase = np.linspace(0.2, 2.5, 400)
    return np.cos(phase), np.sin(phase)


def a_cloud() -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(1)
    return 0.7 + 0.003 * rng.normal(size=3000), -0.2 + 0.003 * rng.normal(size=3000)


def a_square() -> tuple[np.ndarray, np.ndarray]:
    phase = np.linspace(0.0, 60.0, 4000)
    return np.cos(phase) + 0.5 * np.cos(3.0 * phase), np.sin(phase) + 0.5 * np.sin(3.0 * phase)


@pytest.mark.parametrize(
    ("points", "words"),
    [
        ((np.ones(50), np.ones(50)), "stands still"),
        ((np.cos(np.arange(50.0)), np.zeros(50)), "u2.*stands still"),
        (a_line(), "short arc|ellipse"),
        (an_arc(), "%.*pitch"),
        (a_cloud(), "no ellipse"),
        (a_square(), "no ellipse"),
        ((np.cos(np.arange(10.0)), np.sin(np.arange(10.0))), "at least 16"),
        ((np.cos(np.arange(50.0)), np.where(np.arange(50) == 7, np.nan, np.sin(np.arange(50.0)))), "u2.*sample 7"),
        ((np.cos(np.arange(50.0)), np.sin(np.arange(40.0))), "one length"),
    ],
    ids=["still", "one still", "line", "arc", "cloud", "square", "few", "nan", "lengths"],
)
def test_signals_without_an_ellipse_are_refused(points: tuple[np.ndarray, np.ndarray], words: str) -> None:
    with pytest.raises(ParameterError, match=words):
        fit_ellipse(*points)


@given(a=st.floats(-3.0, 3.0), b=st.floats(-3.0, 3.0), c=st.floats(-9.0, 9.0), d=st.floats(-3.0, 3.0), e=st.floats(-3.0, 3.0))
def test_coefficients_give_an_ellipse_or_an_error(a: float, b: float, c: float, d: float, e: float) -> None:
    assume(abs(4.0 * a * b - c * c) > 1e-3)
    try:
        found = QuadratureConstants.from_coefficients(a, b, c, d, e)
    except ParameterError:
        x, y = np.meshgrid(np.linspace(-50.0, 50.0, 201), np.linspace(-50.0, 50.0, 201))
        form = a * x * x + b * y * y + c * x * y + d * x + e * y
        assert 4.0 * a * b < c * c or form.max() < 1.0 + 1e-9
        return
    x, y = found.distorted(np.linspace(0.0, TURN, 9))
    terms = np.stack([a * x * x, b * y * y, c * x * y, d * x, e * y])
    assert terms.sum(axis=0) == pytest.approx(np.ones(9), abs=1e-9 * max(1.0, float(np.abs(terms).max())))


@given(
    amplitudes=st.lists(st.floats(0.0, 1e-7), min_size=4, max_size=4),
    slope=st.floats(-1e-9, 1e-9),
    constant=st.floats(-1e-3, 1e-3),
)
def test_periodic_errors_are_separated_from_slow_ones(amplitudes: list[float], slope: float, constant: float) -> None:
    phase = np.cumsum(np.random.default_rng(3).uniform(0.0, 0.4, 3000))
    waves = sum(size * np.cos((k + 1) * phase - k) for k, size in enumerate(amplitudes))
    found = subdivisional_error(waves + slope * phase + constant, phase)
    assert found.orders[:4] == pytest.approx(amplitudes, abs=1e-16)
    assert found.rest < 1e-15
    one = np.linspace(0.0, TURN, 20001)
    assert found.peak == pytest.approx(float(np.abs(sum(s * np.cos((k + 1) * one - k) for k, s in enumerate(amplitudes))).max()), rel=1e-4)


def test_too_short_a_travel_is_refused() -> None:
    phase = np.linspace(0.0, 1.9 * TURN, 500)
    with pytest.raises(ParameterError, match="travel"):
        subdivisional_error(np.sin(phase), phase)
    with pytest.raises(ParameterError, match="samples"):
        subdivisional_error(np.zeros(20), np.linspace(0.0, 100.0, 20))


@pytest.mark.parametrize("bad", [{"ratio": 0.0}, {"amplitude": -1.0}, {"phase_error": 1.6}, {"offset_1": math.nan}])
def test_constants_have_their_ranges(bad: dict[str, float]) -> None:
    with pytest.raises(ParameterError, match=next(iter(bad))):
        QuadratureConstants(**bad)
