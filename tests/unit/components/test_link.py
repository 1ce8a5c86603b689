"""Messages on a link: lag, loss, order, and equal chance for all signals of one message."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, make, run_alone
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy import stats

from contourlab.primitives import uniform

Array = NDArray[np.float64]
TICKS = np.arange(400.0)


def received(sent: Any, jit: bool = False, **parameters: Any) -> Array:
    """Return the output of a network."""
    found = run_alone(make("link", "network", **parameters), {"sent": np.asarray(sent, dtype=float)}, jit=jit)["received"]
    return np.asarray(found, dtype=float).ravel()


def stamps(n: int = 400, **parameters: Any) -> Array:
    """Return, per tick, the sending tick of the held message; 0 as well before the first arrival."""
    return received(np.arange(float(n)), **parameters)


def expected(sent: Array, spacing: int, delay: float, jitter: float, loss: float, stream: float) -> Array:
    """Return what arrives, message by message: an oracle that uses times and no ring buffer."""
    arrivals = []
    for number in range(-(-len(sent) // spacing)):
        if uniform(stream, float(number), 1.0) > loss:
            time = number * spacing + delay + jitter * uniform(stream, float(number), 0.0)
            arrivals.append((math.ceil(time - 1e-9), number))
    out = np.zeros(len(sent))
    for k in range(len(sent)):
        there = [number for tick, number in arrivals if tick <= k]
        out[k] = sent[max(there) * spacing] if there else 0.0
    return out


@pytest.mark.parametrize("ticks", [0, 1, 7, 40])
def test_constant_velocity_lags_by_velocity_times_delay(ticks: int) -> None:
    ramp = 0.3 * PERIOD * TICKS
    lag = ramp - received(ramp, delay=ticks * PERIOD)
    assert np.allclose(lag[ticks:], 0.3 * ticks * PERIOD, rtol=0, atol=1e-15)


def test_a_message_period_adds_half_its_length_on_average() -> None:
    age = TICKS - stamps(message_period=5 * PERIOD, delay=2 * PERIOD)
    assert set(age[2:].tolist()) == {2.0, 3.0, 4.0, 5.0, 6.0}
    assert age[2:397].mean() == pytest.approx(2.0 + (5 - 1) / 2)


@pytest.mark.parametrize("spacing", [48, 49, 98, 103, 107])
def test_a_message_leaves_at_each_multiple_of_its_period(spacing: int) -> None:
    """Also in machine code, which divides by multiplying: 49 (1/49) is below 1 in doubles."""
    sent = np.arange(20.0 * spacing)
    assert np.array_equal(received(sent, jit=True, message_period=spacing * PERIOD), spacing * np.floor(sent / spacing))


@pytest.mark.parametrize(("given", "ticks"), [(0.0, 1), (0.4, 1), (1.0, 1), (1.0 + 1e-12, 1), (1.01, 2), (2.5, 3)])
def test_times_are_rounded_up_to_servo_periods(given: float, ticks: int) -> None:
    steps = np.unique(np.diff(np.unique(stamps(message_period=given * PERIOD))))
    assert steps.tolist() == [ticks]
    late = TICKS - stamps(delay=given * PERIOD)
    assert late[-1] == (0 if given == 0.0 else ticks)


def test_nothing_is_lost_at_a_loss_of_0_and_all_at_1() -> None:
    assert np.array_equal(stamps(loss=0.0), TICKS)
    assert not stamps(loss=1.0).any()


@pytest.mark.parametrize("loss", [0.05, 0.3, 0.8])
def test_the_share_of_lost_messages_is_the_requested_one(loss: float) -> None:
    n = 20_000
    held = stamps(n, jit=True, loss=loss, stream=5.0)
    arrived = len(np.unique(held)) - 1
    assert stats.binomtest(arrived, n - 1, 1.0 - loss).pvalue > 1e-3
    # Independent: as many messages arrive after a lost one as after any other.
    fresh = np.diff(held) > 0
    behind = fresh[1:][~fresh[:-1]]
    assert stats.binomtest(int(behind.sum()), len(behind), 1.0 - loss).pvalue > 1e-3


def test_jitter_is_uniform() -> None:
    n, spacing = 40_000, 20
    held = stamps(n, jit=True, message_period=spacing * PERIOD, delay=3 * PERIOD, jitter=10 * PERIOD, stream=11.0)
    first = np.flatnonzero(np.diff(held) > 0) + 1
    taken = first - held[first]
    counts = np.bincount(taken.astype(int), minlength=14)
    assert counts[:4].sum() == 0 and counts[14:].sum() == 0  # rounded up: 4 to 13 ticks, equally often
    assert stats.chisquare(counts[4:14]).pvalue > 1e-3


@given(
    spacing=st.integers(1, 6),
    delay=st.floats(0.0, 9.0),
    jitter=st.floats(0.0, 12.0),
    loss=st.floats(0.0, 1.0),
    stream=st.integers(1, 2**40),
)
@settings(max_examples=60, deadline=None)
def test_the_newest_arrived_message_is_held(spacing: int, delay: float, jitter: float, loss: float, stream: int) -> None:
    sent = np.sin(0.7 * np.arange(80.0)) + np.arange(80.0)
    times = {"message_period": spacing * PERIOD, "delay": delay * PERIOD, "jitter": jitter * PERIOD}
    found = received(sent, **times, loss=loss, stream=float(stream))
    ticks = [float(times[name]) / PERIOD for name in ("delay", "jitter")]
    assert np.array_equal(found, expected(sent, spacing, *ticks, loss, float(stream)))


@given(jitter=st.floats(0.0, 30.0), loss=st.floats(0.0, 0.9), stream=st.integers(1, 2**40))
@settings(max_examples=30, deadline=None)
def test_time_stamps_never_go_back(jitter: float, loss: float, stream: int) -> None:
    held = stamps(150, jitter=jitter * PERIOD, loss=loss, stream=float(stream))
    assert (np.diff(held) >= 0.0).all()
    assert (held <= np.arange(150.0)).all()


def test_messages_do_overtake_each_other() -> None:
    """Keeping the order is a real test only if messages lose it on the way."""
    taken = [uniform(3.0, float(number), 0.0) * 30.0 + number for number in range(150)]
    assert (np.diff(taken) < 0.0).sum() > 20


def test_extrapolation_removes_a_delay_at_constant_velocity() -> None:
    ramp = 0.3 * PERIOD * TICKS + 0.01
    slow = {"message_period": 4 * PERIOD, "delay": 3 * PERIOD, "between": "extrapolate", "horizon": 1.0}
    found = received(ramp, **slow)
    assert np.allclose(found[7:], ramp[7:], rtol=0, atol=1e-13)
    lossy = received(ramp, **slow, loss=0.5, stream=9.0)
    assert np.allclose(lossy[60:], ramp[60:], rtol=0, atol=1e-13)


def test_extrapolation_ends_at_its_horizon() -> None:
    found = received(PERIOD * TICKS, message_period=50 * PERIOD, between="extrapolate", horizon=10 * PERIOD)
    assert np.allclose(found[350:], PERIOD * np.minimum(TICKS[350:], 360.0), rtol=0, atol=1e-13)


def test_signals_of_one_stream_share_the_fate_of_their_message() -> None:
    chance = {"jitter": 8 * PERIOD, "loss": 0.3}
    one, other = (received(sent, **chance, stream=21.0) for sent in (TICKS, 5.0 - 2.0 * TICKS))
    begun = one > 0
    assert np.array_equal(other[begun], 5.0 - 2.0 * one[begun])
    assert not np.array_equal(one, received(TICKS, **chance, stream=22.0))


def test_with_zero_delay_it_is_a_wire() -> None:
    noise = np.random.default_rng(1).normal(size=300)
    for between in ("hold", "extrapolate"):
        for jit in (False, True):
            assert np.array_equal(received(noise, jit, message_period=PERIOD, between=between), noise)
