"""The recursive fit against its least-squares problem, and its behaviour without excitation."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from contourlab.analysis.encoder import QuadratureConstants, fit_ellipse, track_ellipse
from contourlab.errors import ParameterError

TURN = 2.0 * math.pi
TRUE = QuadratureConstants(0.06, -0.04, 1.1, 0.08)
NAMES = ("offset_1", "offset_2", "ratio", "phase_error", "amplitude")
CIRCLE = QuadratureConstants()


def gaps(found: QuadratureConstants, true: QuadratureConstants = TRUE) -> float:
    return max(abs(getattr(found, name) - getattr(true, name)) for name in NAMES)


@given(seed=st.integers(0, 1000), forgetting=st.floats(0.97, 1.0), start=st.floats(2.0, 100.0))
def test_it_solves_the_weighted_problem(seed: int, forgetting: float, start: float) -> None:
    """min sum lambda^(N-i) (1 - w_i theta)^2 + lambda^N |theta - theta_0|^2/P_0, solved here in one step."""
    rng = np.random.default_rng(seed)
    n = 150
    turns = np.cumsum(rng.uniform(0.05, 0.2, n))
    x, y = TRUE.distorted(TURN * turns)
    x, y = x + 0.01 * rng.normal(size=n), y + 0.01 * rng.normal(size=n)
    tracked = track_ellipse(x, y, CIRCLE, forgetting=forgetting, initial_covariance=start, update_travel=1e-4)
    used = np.flatnonzero(tracked.updated)
    weight = np.sqrt(forgetting ** np.arange(used.size - 1, -1, -1.0))
    rows = np.stack([x * x, y * y, x * y, x, y], axis=1)[used]
    prior = math.sqrt(forgetting**used.size / start)
    nominal = np.array([1.0, 1.0, 0.0, 0.0, 0.0])
    a = np.concatenate([rows * weight[:, None], prior * np.eye(5)])
    b = np.concatenate([weight, prior * nominal])
    wanted = np.linalg.lstsq(a, b, rcond=None)[0]
    assert tracked.coefficients[-1] == pytest.approx(wanted, abs=1e-8)
    assert used.size > 130  # all but the first half pitch
    assert used[0] == 0


def test_without_noise_the_initial_guess_is_forgotten_geometrically() -> None:
    """In m updates the error falls by lambda^m, the weight of the initial guess."""
    found = []
    for n in (400, 600, 800):
        turns = 0.0317 * np.arange(n)
        tracked = track_ellipse(*TRUE.distorted(TURN * turns), CIRCLE, forgetting=0.98, update_travel=0.03)
        found.append((int(tracked.updated.sum()), gaps(tracked.constants())))
    for (n, before), (m, after) in pairwise(found):
        assert math.log(after / before) / (m - n) == pytest.approx(math.log(0.98), rel=0.1)


def test_it_follows_constants_that_drift() -> None:
    """It lags by its memory: 1/(1 - lambda) updates times the drift per update."""
    turns = np.arange(0.0, 6000.0, 0.05)
    offset = 0.02 + 0.1 * turns / turns[-1]
    x, y = TRUE.distorted(TURN * turns)
    x = x - TRUE.offset_1 + offset
    tracked = track_ellipse(x, y, CIRCLE, forgetting=0.998, update_travel=1.0 / 32.0)
    told = np.array([tracked.constants(i).offset_1 for i in range(200, len(tracked.sample))])
    lag = offset[tracked.sample[200:]] - told
    memory = 500.0 * np.diff(np.flatnonzero(tracked.updated)).mean() * (offset[1] - offset[0])
    assert np.abs(lag - memory).max() < 0.3 * memory
    assert gaps(fit_ellipse(x, y).constants, TRUE) > 20.0 * memory


def test_an_axis_at_rest_or_dithering_within_a_pitch_keeps_its_constants() -> None:
    rng = np.random.default_rng(2)
    moving = np.cumsum(np.full(4000, 0.04))
    still = moving[-1] - 0.4 + 0.4 * np.cos(np.arange(100_000) * 0.001)  # half the play to either side
    turns = np.concatenate([moving, still])
    x, y = TRUE.distorted(TURN * turns)
    x, y = x + 0.003 * rng.normal(size=x.size), y + 0.003 * rng.normal(size=y.size)
    tracked = track_ellipse(x, y, CIRCLE)
    assert not tracked.updated[4000:].any()
    assert np.array_equal(tracked.coefficients[-1], tracked.coefficients[tracked.sample > 4000][0])
    assert gaps(tracked.constants()) < 2e-3


def test_rest_with_noise_from_the_start_teaches_nothing() -> None:
    rng = np.random.default_rng(3)
    x, y = TRUE.distorted(np.full(50_000, 1.0))
    tracked = track_ellipse(x + 0.01 * rng.normal(size=x.size), y + 0.01 * rng.normal(size=y.size), TRUE)
    assert tracked.updated.sum() < 5
    assert gaps(tracked.constants()) < 0.02


def test_samples_at_the_same_few_phases_do_no_harm() -> None:
    """At a quarter of a pitch per sample, four points do not determine an ellipse. The covariance is reset and stays bounded."""
    rng = np.random.default_rng(4)
    turns = np.concatenate(
        [np.cumsum(np.full(3000, 0.0371)), 111.3 + 0.25 * np.arange(200_000), 50111.3 + np.cumsum(np.full(6000, 0.0371))]
    )
    x, y = TRUE.distorted(TURN * turns)
    x, y = x + 0.002 * rng.normal(size=x.size), y + 0.002 * rng.normal(size=y.size)
    tracked = track_ellipse(x, y, CIRCLE)
    assert np.isfinite(tracked.coefficients).all()
    assert np.isfinite(tracked.u1).all() and np.isfinite(tracked.u2).all()
    assert gaps(tracked.constants()) < 2e-3
    off, uncorrected = (
        np.abs(turn - np.rint(turn)) for turn in (np.arctan2(v, u) / TURN - turns for u, v in ((tracked.u1, tracked.u2), (x, y)))
    )
    assert float(off[3000:].max()) < 2.0 * float(uncorrected.max())


def test_blocks_join_seamlessly() -> None:
    """A record longer than a block of the engine begins like its first part alone."""
    turns = 0.013 * np.arange(140_000)
    x, y = TRUE.distorted(TURN * turns)
    whole, part = track_ellipse(x, y, CIRCLE), track_ellipse(x[:70_000], y[:70_000], CIRCLE)
    assert np.array_equal(whole.u2[:70_000], part.u2)
    assert np.array_equal(whole.updated[:70_000], part.updated)


def test_the_nominal_amplitude_is_only_a_scale() -> None:
    turns = 0.0317 * np.arange(5000)
    x, y = TRUE.distorted(TURN * turns)
    one = track_ellipse(x, y, CIRCLE)
    other = track_ellipse(0.25 * x, 0.25 * y, QuadratureConstants(amplitude=0.25))
    assert np.array_equal(one.coefficients, other.coefficients)
    assert other.constants().offset_1 == pytest.approx(0.25 * one.constants().offset_1, rel=1e-12)
    assert other.constants().amplitude == pytest.approx(0.25 * one.constants().amplitude, rel=1e-12)


@pytest.mark.parametrize("bad", [{"forgetting": 1.1}, {"forgetting": 0.5}, {"forgetting": math.nan}, {"update_travel": 0.0}, {"n_kept": 1}])
def test_numbers_out_of_range_are_refused(bad: dict[str, float]) -> None:
    with pytest.raises(ParameterError, match=next(iter(bad))):
        track_ellipse(np.ones(3), np.ones(3), CIRCLE, **bad)  # type: ignore[arg-type]
