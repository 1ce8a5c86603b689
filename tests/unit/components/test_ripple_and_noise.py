"""Force ripple against its Fourier series; noise against its specified statistics."""

from __future__ import annotations

import math

import numpy as np
import pytest
from component_rig import make, run_alone
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.errors import ParameterError

HARMONICS = st.lists(st.tuples(st.floats(0.0, 10.0), st.floats(-7.0, 7.0)), min_size=1, max_size=12)


@settings(deadline=None)
@given(harmonics=HARMONICS, pitch=st.floats(1e-3, 0.1), seed=st.integers(0, 99))
def test_ripple_is_the_sum_of_its_harmonics(harmonics: list[tuple[float, float]], pitch: float, seed: int) -> None:
    amplitudes, phases = zip(*harmonics, strict=True)
    ripple = make("disturbance", "force-ripple", pitch=pitch, amplitudes=amplitudes, phases=phases)
    position = np.random.default_rng(seed).uniform(-0.5, 0.5, 50)
    exact = sum(a * np.sin(2.0 * math.pi * (k + 1) * position / pitch + phi) for k, (a, phi) in enumerate(harmonics))
    assert run_alone(ripple, {"position": position})["force"] == pytest.approx(exact, abs=1e-10 * (1.0 + sum(amplitudes)))


def test_ripple_repeats_over_the_pitch_and_in_every_trial() -> None:
    values = {"pitch": 0.032, "amplitudes": (2.0, 0.5), "phases": (0.1, -0.4)}
    position = np.linspace(0.0, 0.032, 40)
    one, other = (make("disturbance", "force-ripple", **values, stream=stream) for stream in (1.0, 2.0))
    first = run_alone(one, {"position": position}, jit=True)["force"]
    assert run_alone(one, {"position": position - 17 * 0.032}, jit=True)["force"] == pytest.approx(first, abs=1e-12)
    assert np.array_equal(run_alone(other, {"position": position}, jit=True)["force"], first)


def test_noise_with_ripple_equals_the_noise_alone() -> None:
    position = np.linspace(0.0, 0.3, 500)
    values = {"pitch": 0.032, "amplitudes": (2.0,), "phases": (0.1,)}
    pure = run_alone(make("disturbance", "force-ripple", **values), {"position": position})["force"]
    both = make("disturbance", "force-ripple", **values, noise=0.3, noise_bandwidth=50.0, stream=9.0)
    noise = make("disturbance", "low-passed-noise", rms=0.3, bandwidth=50.0, stream=9.0)
    left = run_alone(both, {"position": position})["force"] - pure
    assert left == pytest.approx(run_alone(noise, {"position": position})["force"], abs=1e-13)


def test_phases_must_match_amplitudes_in_number() -> None:
    with pytest.raises(ParameterError, match="phases"):
        make("disturbance", "force-ripple", pitch=0.03, amplitudes=(1.0, 2.0), phases=(0.0,))


@pytest.mark.parametrize("bandwidth", [5.0, 100.0, 5000.0])
@pytest.mark.parametrize("period", [1e-3, 1e-4])
def test_noise_has_its_rms_and_its_correlation_at_any_period(bandwidth: float, period: float) -> None:
    n = 1_000_000
    noise = make("disturbance", "low-passed-noise", rms=0.7, bandwidth=bandwidth, stream=5.0)
    force = run_alone(noise, {"position": np.zeros(n)}, period=period, jit=True)["force"]
    keep = math.exp(-bandwidth * period)
    # Of n correlated samples, n (1 - keep^2)/(1 + keep^2) count for a variance: four standard deviations of it.
    counting = n * (1.0 - keep**2) / (1.0 + keep**2)
    assert float(np.mean(force**2)) == pytest.approx(0.49, rel=4.0 * math.sqrt(2.0 / counting))
    innovation = force[1:] - keep * force[:-1]
    assert float(np.std(innovation)) == pytest.approx(0.7 * math.sqrt(1.0 - keep**2), rel=4.0 / math.sqrt(2.0 * n))
    # White innovations: the correlation is exactly exp(-w T).
    assert abs(float(np.mean(innovation[1:] * innovation[:-1]))) < 5.0 * float(np.var(innovation)) / math.sqrt(n)
    assert np.mean((force > -0.7) & (force < 0.7)) == pytest.approx(math.erf(math.sqrt(0.5)), abs=3.0 / math.sqrt(counting))


def test_noise_starts_at_the_first_tick_and_differs_between_streams() -> None:
    first = [
        run_alone(make("disturbance", "low-passed-noise", rms=2.0, bandwidth=1.0, stream=float(k)), {"position": np.zeros(3)})["force"]
        for k in range(1, 1001)
    ]
    spread = np.std(first, axis=0)
    assert spread == pytest.approx([2.0, 2.0, 2.0], rel=4.0 / math.sqrt(2000.0))
    assert len({row[0] for row in first}) == 1000


@settings(deadline=None)
@given(parts=st.lists(st.floats(-10.0, 10.0), min_size=5, max_size=5), lead=st.floats(1e-3, 0.1), order=st.integers(1, 12))
def test_the_ripple_of_a_screw_is_its_fourier_series(parts: list[float], lead: float, order: int) -> None:
    offset, sine, cosine, order_sine, order_cosine = parts
    values = {"offset": offset, "sine": sine, "cosine": cosine, "order_sine": order_sine, "order_cosine": order_cosine}
    screw = make("disturbance", "screw-ripple", lead=lead, order=float(order), **values)
    position = np.random.default_rng(order).uniform(-0.5, 0.5, 50)
    angle = 2.0 * math.pi * position / lead
    exact = (
        offset + sine * np.sin(angle) + cosine * np.cos(angle) + order_sine * np.sin(order * angle) + order_cosine * np.cos(order * angle)
    )
    assert run_alone(screw, {"position": position})["force"] == pytest.approx(exact, abs=1e-8)
