"""The encoder from its analogue signals: its errors before and after correction, against first-order theory."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from component_rig import make, run_alone
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import kstest

from contourlab.analysis.encoder import QuadratureConstants, Subdivisional, subdivisional_error
from contourlab.components.sensor.encoder import arctangents, constants, ellipse, in_turns
from contourlab.errors import ParameterError
from contourlab.feed import uniform
from contourlab.geometry import contour
from contourlab.loop import simulate
from contourlab.scenario import load_controller, load_machine

PITCH, FINE = 20e-6, 20e-6 / 40_000
AMPLITUDE = 0.5
RADIAN = PITCH / (2.0 * math.pi)


def encoder(**parameters: Any) -> Any:
    return make("sensor", "quadrature-encoder", **{"pitch": PITCH, "resolution": FINE, "amplitude": AMPLITUDE, **parameters})


def travel(pitches: float = 100.0, n: int = 20_000) -> np.ndarray:
    """Return uneven steps, so that quantisation does not repeat with the pitch: a harmonic of it is 0.29 counts times sqrt(2/n)."""
    return PITCH * pitches * (np.arange(n) + np.random.default_rng(0).uniform(0.0, 1.0, n)) / n


def seen(part: Any, position: np.ndarray) -> np.ndarray:
    return run_alone(part, {"position": position}, jit=True)["position"]


def errors(part: Any, position: np.ndarray | None = None, after: int = 0) -> Subdivisional:
    """Return the error that repeats with the pitch, from sample `after` on."""
    x = travel() if position is None else position
    return subdivisional_error((seen(part, x) - x)[after:], x[after:] / RADIAN)


@given(radius=st.floats(1e-12, 1e12), angle=st.floats(-math.pi, math.pi))
def test_the_angle_is_the_arctangent(radius: float, angle: float) -> None:
    u1, u2 = radius * math.cos(angle), radius * math.sin(angle)
    found = in_turns(arctangents(), u1, u2) - math.atan2(u2, u1) / (2.0 * math.pi)
    assert abs(found - round(found)) < 4e-16


def test_a_zero_signal_has_an_angle_too() -> None:
    assert in_turns(arctangents(), 0.0, 0.0) == 0.0


@given(p=st.floats(-0.4, 0.4), q=st.floats(-0.4, 0.4), r=st.floats(0.7, 1.4), al=st.floats(-0.6, 0.6))
def test_constants_are_recovered_from_the_coefficients(p: float, q: float, r: float, al: float) -> None:
    theta = ellipse(p, q, r, math.sin(al), 1.0)
    assert constants(theta) == pytest.approx((p, q, r, math.sin(al), math.cos(al)), abs=1e-11)


@given(theta=st.tuples(*[st.floats(-1e6, 1e6)] * 5))
def test_constants_from_any_coefficients_are_finite_and_plausible(theta: tuple[float, ...]) -> None:
    p, q, r, sine, cosine = constants(theta)
    assert max(abs(p), abs(q), abs(sine)) <= 0.9
    assert 0.009 <= r <= 101.0 and cosine > 0.4


# --- the errors of uncorrected signals -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "order", "radians"),
    [
        ({"offset_1": 0.02 * AMPLITUDE}, 1, 0.02),
        ({"offset_2": 0.02 * AMPLITUDE}, 1, 0.02),
        ({"amplitude_ratio": 1.02}, 2, 0.01),
        ({"phase_error": 0.02}, 2, 0.01),
        ({"third_harmonic": 0.02}, 4, 0.02),
    ],
    ids=["offset 1", "offset 2", "ratio", "phase", "harmonic"],
)
def test_each_error_of_the_signals_has_its_harmonic(change: dict[str, float], order: int, radians: float) -> None:
    """Once a pitch p/R, twice (r - 1)/2 and al/2, four times h; 64, 32 and 64 nm here, within second order."""
    found = errors(encoder(correction="none", **change))
    assert found.orders[order - 1] == pytest.approx(radians * RADIAN, rel=0.03)
    others = [size for k, size in enumerate(found.orders, 1) if k != order]
    assert max(others) < 1.5 * radians**2 * RADIAN + 0.1 * FINE


BAD = {"offset_1": 0.06 * AMPLITUDE, "offset_2": -0.04 * AMPLITUDE, "amplitude_ratio": 1.08, "phase_error": 0.06}
KNOWN = {f"known_{name}".replace("amplitude_", ""): value for name, value in BAD.items()}


def test_known_constants_remove_the_errors() -> None:
    assert errors(encoder(correction="none", **BAD)).peak > 300e-9
    assert errors(encoder(correction="fixed", **BAD, **KNOWN)).peak < 0.05 * FINE


def test_the_adaptive_correction_learns_the_errors() -> None:
    """Without noise only quantisation is left; a third harmonic stays, because it is no ellipse."""
    x = travel(200.0, 40_000)
    half = x.size // 2
    assert errors(encoder(correction="adaptive", **BAD), x, half).peak < 0.05 * FINE
    found = errors(encoder(correction="adaptive", third_harmonic=0.01, **BAD), x, half)
    assert found.orders[3] == pytest.approx(0.01 * RADIAN, rel=0.1)
    assert max(found.orders[:2]) < 0.02 * 0.01 * RADIAN + 0.1 * 0.01 * RADIAN


def test_the_adaptive_correction_under_noise_and_a_converter() -> None:
    """Noise of 0.2 % and 12 bits: a hundredth of 365 nm is left; single samples scatter by the noise alone."""
    x = travel(400.0, 40_000)
    part = encoder(correction="adaptive", noise=0.002 * AMPLITUDE, bits=12.0, stream=3.0, **BAD)
    found = errors(part, x, x.size // 2)
    assert errors(encoder(correction="none", **BAD)).peak > 300e-9
    assert found.peak < 3.65e-9
    assert found.rest == pytest.approx(0.002 * RADIAN, rel=0.15)


# --- counts --------------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("jit", [False, True])
@pytest.mark.parametrize("correction", ["none", "fixed", "adaptive"])
@pytest.mark.parametrize("resolution", [25e-9, 10e-9, 1e-6])
def test_clean_signals_are_counted_as_by_an_ideal_encoder(correction: str, resolution: float, jit: bool) -> None:
    """Pitch 4 um: 1 um becomes 25 and 10 nm."""
    x = 40e-6 * np.sin(np.linspace(0.0, 9.0, 700)) + 0.123e-6
    part = make("sensor", "quadrature-encoder", pitch=4e-6, resolution=resolution, correction=correction)
    found = run_alone(part, {"position": x}, jit=jit)
    exact = x / resolution
    sure = np.abs(exact - np.floor(exact) - 0.5) > 1e-6
    assert np.array_equal(np.rint(found["position"] / resolution)[sure], np.rint(exact[sure]))
    assert not found["missed_periods"].any()


def test_with_its_own_counter_counts_are_right_far_out_and_at_any_speed() -> None:
    x = np.array([0.0, 0.3, 0.95, -0.7, 2.0, -2.0]) + 1.3e-6
    found = run_alone(encoder(correction="none", resolution=25e-9), {"position": x}, jit=True)
    assert found["position"] == pytest.approx(x, abs=12.6e-9)
    assert not found["missed_periods"].any()


@pytest.mark.parametrize("speed", [0.49, -0.49, 0.51, -0.51, 0.7])
def test_sampled_counting_loses_periods_beyond_half_a_pitch(speed: float) -> None:
    x = PITCH * speed * np.arange(200)
    found = run_alone(encoder(correction="none", counting="sampled"), {"position": x}, jit=True)
    lost = round(speed) * np.arange(200)
    assert np.array_equal(found["missed_periods"], lost)
    assert found["position"] == pytest.approx(x - PITCH * lost, abs=FINE)


def test_it_begins_at_the_position_of_the_axis() -> None:
    for counting in ("hardware", "sampled"):
        found = run_alone(encoder(counting=counting), {"position": np.full(3, 0.4321)}, jit=True)
        assert found["position"] == pytest.approx(np.full(3, 0.4321), abs=FINE)


# --- noise and converter -------------------------------------------------------------------------------------------------------------


def test_noise_is_normal_and_comes_from_its_stream() -> None:
    part = encoder(correction="none", noise=0.005 * AMPLITUDE, stream=11.0)
    x = np.zeros(20_000)
    found = seen(part, x)
    assert kstest(found / (0.005 * RADIAN), "norm").pvalue > 1e-3
    assert np.array_equal(found, seen(part, x))
    assert not np.array_equal(found, seen(part.replace(stream=12.0), x))
    assert abs(np.corrcoef(found[1:], found[:-1])[0, 1]) < 4.0 / math.sqrt(x.size)


def test_a_coarse_converter_shifts_the_angle_by_half_a_step_at_most() -> None:
    """8 bits over +-1 V: a step of 7.8 mV; each of two signals is off by up to half of it."""
    x = travel(7.0)
    off = np.abs(seen(encoder(correction="none", bits=8.0), x) - x)
    step = 2.0 / 2**8 / AMPLITUDE
    assert 0.4 * step * RADIAN < float(off.max()) < 0.5 * math.sqrt(2.0) * step * RADIAN * 1.02 + FINE


def test_a_converter_clips() -> None:
    x = travel(7.0)
    assert errors(encoder(correction="none", bits=16.0, converter_range=1.0), x).peak < FINE
    assert errors(encoder(correction="none", bits=16.0, converter_range=0.4), x).peak > 100.0 * FINE


# --- in the loop -----------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("correction", ["none", "fixed", "adaptive"])
def test_a_loop_measures_its_position_through_the_encoder(correction: str) -> None:
    """Measured less true position on a circle: half a count of 25 nm with correction, otherwise the error of the angle."""
    machine = load_machine("builtin:ghaffari/a3a1")
    known = KNOWN if correction == "fixed" else {}
    sensor = make("sensor", "quadrature-encoder", pitch=4e-6, resolution=25e-9, correction=correction, **BAD, **known)
    axes = tuple(replace(axis, sensor=sensor) for axis in machine.axes)
    controller = load_controller("builtin:ghaffari/calibrated", machine)
    result = simulate(replace(machine, axes=axes), controller, uniform(contour("circle", radius=0.02), 0.5, 1, 1e-3))
    assert result.status.ok
    off = np.abs(result["position"] - result["tool_position"])
    model = QuadratureConstants(0.03, -0.02, 1.08, 0.06, AMPLITUDE)
    worst = 4e-6 / (2.0 * math.pi) * float(np.abs(model.error_without(np.linspace(0.0, 7.0, 1000))).max())
    half = 12.5e-9 + 1e-11
    assert float(off.max()) <= (half if correction == "fixed" else worst + half)
    if correction == "none":
        assert float(off[1000:].max()) > worst - half > 4.0 * half
    else:
        assert float(off[1000:].max()) <= half


@pytest.mark.parametrize(
    ("bad", "words"),
    [
        ({"resolution": 30e-9}, "resolution.*four times"),
        ({"resolution": 21e-6}, "resolution"),
        ({"known_offset_1": 0.46}, "offsets"),
        ({"forgetting": 0.9, "initial_covariance": 1.0}, "initial_covariance"),
        ({"bits": 40.0}, "bits"),
    ],
)
def test_invalid_settings_are_refused(bad: dict[str, float], words: str) -> None:
    with pytest.raises(ParameterError, match=words):
        encoder(**bad)
