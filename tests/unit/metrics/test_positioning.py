"""Bidirectional positioning against figures worked out by hand, and from records in time."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from contourlab.errors import ParameterError, ResultError
from contourlab.metrics.positioning import bidirectional_positioning, reversal_test

Array = NDArray[np.float64]


def test_figures_by_hand() -> None:
    """Two targets, two approaches each way, in um: up 1 and 3, down 6 and 8; up 0 and 0, down 4 and 4."""
    targets = np.array([0.1] * 4 + [0.2] * 4)
    deviation = 1e-6 * np.array([1, 3, 6, 8, 0, 0, 4, 4.0])
    found = bidirectional_positioning(targets, deviation, [1, 1, -1, -1, 1, 1, -1, -1])
    s = math.sqrt(2.0)
    assert found.reversal_value == pytest.approx([-5e-6, -4e-6])
    assert found.mean_reversal_value == pytest.approx(-4.5e-6) and found.lost_motion == pytest.approx(4.5e-6)
    assert found.largest_reversal_value == pytest.approx(5e-6)
    assert found.forward_scatter == pytest.approx([s * 1e-6, 0.0]) and found.backward_scatter == pytest.approx([s * 1e-6, 0.0])
    assert found.repeatability == pytest.approx((2.0 * s + 2.0 * s + 5.0) * 1e-6)
    assert found.systematic_deviation == pytest.approx((7.0 - 0.0) * 1e-6)
    # Pooled variance (2 + 2 + 0 + 0)/4 = 1 um^2; each of four means has half of it, and the mean B is half the sum of two differences.
    assert found.deviation == pytest.approx(0.5 * math.sqrt(4 * 0.5) * 1e-6)


def pilgrimage(targets: list[float], rounds: int, dwell: int, move: int, over: float) -> Array:
    """A reference that goes up the targets and down again, beyond both ends, and stands at each."""
    stops = [targets[0] - over, *targets, targets[-1] + over, *targets[::-1]]
    parts, at = [np.full(dwell, stops[-1])], stops[-1]
    for stop in stops * rounds:
        parts += [np.linspace(at, stop, move + 1)[1:], np.full(dwell, stop)]
        at = stop
    return np.concatenate(parts)


def behind(motor: Array, gap: float) -> Array:
    at, load = float(motor[0]), np.empty_like(motor)
    for k, m in enumerate(motor):
        at = min(max(at, m - 0.5 * gap), m + 0.5 * gap)
        load[k] = at
    return load


TARGETS = [0.0113, 0.0521, 0.0998, 0.1504, 0.2007]


@pytest.mark.parametrize("gap", [0.0, 3e-6, 40e-6])
def test_a_record_of_a_play(gap: float) -> None:
    """ISO's five approaches each way, with pitch errors, noise of 0.1 um and counts of 0.1 um."""
    rng = np.random.default_rng(2)
    reference = pilgrimage(TARGETS, 5, 60, 40, 0.01)
    position = behind(reference, gap) + 6e-6 * np.sin(60.0 * reference)
    position += 1e-7 * rng.normal(size=position.size)
    position = 1e-7 * np.round(position / 1e-7)
    found = reversal_test(reference, position, dwell=50)
    assert found.target == pytest.approx(TARGETS)
    assert (found.forward_count == 5).all() and (found.backward_count == 5).all()
    assert found.reversal_value == pytest.approx(np.full(5, -gap), abs=5e-8)
    assert found.lost_motion == pytest.approx(gap, abs=2e-8)
    assert 0.0 < found.deviation < 2e-8
    assert 0.5 * (found.forward + found.backward) == pytest.approx(6e-6 * np.sin(60.0 * np.array(TARGETS)), abs=5e-8)


def test_an_encoder_as_reference_that_swings_into_its_targets() -> None:
    """The motor's own position: 3 um of overshoot and counts of 0.2 um; its direction is that from 10 um away."""
    reference = pilgrimage(TARGETS, 3, 400, 60, 0.01)
    error = np.zeros_like(reference)
    for k in np.flatnonzero((np.diff(reference) != 0.0) & (np.diff(reference, append=0.0)[1:] == 0.0)) + 1:
        t = np.arange(400)
        error[k : k + 400] += (3e-6 * np.sign(reference[k] - reference[k - 1]) * np.exp(-t / 30.0) * np.cos(t / 15.0))[
            : error[k : k + 400].size
        ]
    motor = 2e-7 * np.round((reference + error) / 2e-7)
    way, last = np.empty_like(motor), -1.0
    for k in range(motor.size):
        last = float(np.sign(reference[k] - reference[k - 1])) or last if k else last
        way[k] = last
    load = motor - 8e-6 * way
    found = reversal_test(motor, load, dwell=100, standstill=4e-7, least_approach=1e-5, tolerance=1e-5)
    assert found.lost_motion == pytest.approx(16e-6, abs=1e-12)
    assert len(found.target) == 5


@given(scale=st.floats(1e-2, 1e2), shift=st.floats(-1.0, 1.0), mirrored=st.booleans())
def test_units_places_and_direction_do_not_matter(scale: float, shift: float, mirrored: bool) -> None:
    reference = pilgrimage([0.01, 0.02], 2, 12, 8, 0.005)
    position = behind(reference, 2e-5) + 1e-6 * np.sin(np.arange(reference.size))
    one = reversal_test(reference, position, dwell=10)
    factor = -scale if mirrored else scale
    other = reversal_test(factor * reference + shift, factor * position + shift, dwell=10, standstill=1e-12, tolerance=1e-4 * scale)
    assert other.lost_motion == pytest.approx(scale * one.lost_motion, rel=1e-6)
    assert np.sort(other.reversal_value) == pytest.approx(scale * np.sort(one.reversal_value), rel=1e-6)


RAMP = np.arange(100) * 1e-3


@pytest.mark.parametrize(
    ("reference", "position", "said"),
    [
        (RAMP, RAMP[1:], "shapes"),
        (RAMP, np.full(100, np.inf), "not finite"),
        (RAMP, RAMP, "no approach"),
        (np.zeros(100), np.zeros(100), "no approach"),
        (np.concatenate([RAMP, np.full(60, RAMP[-1])]), np.zeros(160), "both sides"),
        (np.zeros(3), np.zeros(3), "no approach"),
    ],
)
def test_a_record_that_is_no_such_test_is_refused(reference: Array, position: Array, said: str) -> None:
    with pytest.raises(ResultError, match=said):
        reversal_test(reference, position)


@pytest.mark.parametrize("options", [{"dwell": 1}, {"standstill": -1.0}, {"least_approach": math.nan}, {"tolerance": 0.0}])
def test_options_out_of_range_are_refused(options: dict[str, Any]) -> None:
    reference = pilgrimage([0.01, 0.02], 1, 60, 8, 0.005)
    with pytest.raises(ParameterError):
        reversal_test(reference, reference, **options)


def test_single_approaches_have_no_scatter() -> None:
    found = bidirectional_positioning([0.1, 0.1], [0.0, 5e-6], [1.0, -1.0])
    assert found.lost_motion == pytest.approx(5e-6)
    assert math.isnan(found.deviation) and math.isnan(found.repeatability)
