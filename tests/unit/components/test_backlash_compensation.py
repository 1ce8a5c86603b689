"""Backlash and quadrant compensation: the shift over time, cancellation of the gap, and no chatter."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, make, run_alone
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from contourlab.components.compensation.backlash import BacklashInverse, BacklashOffset, CncBacklash, QuadrantPulses
from contourlab.errors import ParameterError

Array = NDArray[np.float64]

GAP = 20e-6
SHIFTING = [
    pytest.param(BacklashInverse(backlash_gap=GAP, dead_band=1e-4), id="inverse"),
    pytest.param(BacklashOffset(backlash_gap=GAP, reversal_velocity=1e-4), id="offset"),
    pytest.param(CncBacklash(backlash_gap=GAP, reversal_velocity=1e-4, first_amplitude=2.0), id="cnc"),
    pytest.param(
        make("compensation", "adaptive-backlash-inverse", backlash_gap=GAP, largest_gap=1e-4, dead_band=1e-4), id="adaptive inverse"
    ),
]


def play(motor: Array, gap: float, start: float) -> Array:
    """Return the position of a load with friction and no inertia: it moves once the gap is crossed."""
    load, at = np.empty_like(motor), start
    for k, m in enumerate(motor):
        at = min(max(at, m - 0.5 * gap), m + 0.5 * gap)
        load[k] = at
    return load


def shift_of(part: Any, velocity: Any, **more: Any) -> Array:
    return np.asarray(run_alone(part, {"reference_velocity": velocity, **more})["reference_shift"])


def legs(*ticks_and_speeds: tuple[int, float]) -> Array:
    """Return the velocity of the reference, leg by leg."""
    return np.concatenate([np.full(n, v) for n, v in ticks_and_speeds])


# --- the inverse --------------------------------------------------------------------------------------------------------------------


def test_the_shift_crosses_the_gap_in_its_time() -> None:
    """At 1 mm/s, 10 um take ten ticks from zero and 20 um take twenty after the reversal, as a straight ramp."""
    part = BacklashInverse(backlash_gap=GAP, jump_velocity=1e-3)
    shift = shift_of(part, legs((30, 0.1), (40, -0.1)))
    assert shift[:30] == pytest.approx(np.minimum(1e-6 * np.arange(1, 31), 0.5 * GAP), abs=1e-18)
    assert shift[30:] == pytest.approx(np.maximum(0.5 * GAP - 1e-6 * np.arange(1, 41), -0.5 * GAP), abs=1e-18)
    assert shift[29] == 0.5 * GAP and shift[-1] == -0.5 * GAP


@given(
    gap=st.floats(1e-6, 3e-4),
    speeds=st.lists(st.floats(2e-3, 0.5), min_size=1, max_size=6),
    lengths=st.lists(st.integers(40, 90), min_size=6, max_size=6),
    stands=st.lists(st.integers(0, 20), min_size=6, max_size=6),
    start=st.floats(-0.5, 0.0),
    jump=st.integers(2, 30),
)
def test_the_inverse_cancels_the_dead_zone(
    gap: float, speeds: list[float], lengths: list[int], stands: list[int], start: float, jump: int
) -> None:
    """For any motion whose legs outlast the ramp, the load is at its reference when the ramp is complete.

    The load starts behind the reference: if it lies ahead, the motor meets it on the way.
    """
    velocity = np.concatenate(
        [legs((n, v * (-1.0) ** i), (s, 0.0)) for i, (v, n, s) in enumerate(zip(speeds, lengths, stands, strict=False))]
    )
    reference = np.cumsum(velocity) * PERIOD
    part = BacklashInverse(backlash_gap=gap, jump_velocity=gap / (jump * PERIOD))
    motor = reference + shift_of(part, velocity)
    load = play(motor, gap, start * gap)
    turned = np.concatenate([np.full(n + s, np.arange(n + s)) for n, s in zip(lengths, stands, strict=False)])[: velocity.size]
    done = turned >= jump + 1
    assert done.any()
    assert load[done] == pytest.approx(reference[done], abs=1e-12)
    # While the motor crosses the gap, the load lags by at most the rest of the motor's way.
    assert np.abs(load - reference).max() <= gap + np.abs(velocity).max() * jump * PERIOD


def test_without_the_inverse_the_load_is_half_the_gap_off() -> None:
    velocity = legs((50, 0.1), (50, -0.1))
    reference = np.cumsum(velocity) * PERIOD
    load = play(reference, GAP, 0.0)
    assert load[45] - reference[45] == pytest.approx(-0.5 * GAP)
    assert load[95] - reference[95] == pytest.approx(0.5 * GAP)


def test_the_shift_grows_with_the_gap_and_uses_an_observed_one() -> None:
    velocity = legs((40, 0.1), (40, -0.1))
    one = shift_of(BacklashInverse(backlash_gap=GAP, jump_velocity=1e-3), velocity)
    three = shift_of(BacklashInverse(backlash_gap=3.0 * GAP, jump_velocity=3e-3), velocity)
    assert three == pytest.approx(3.0 * one, rel=1e-12)
    seen = shift_of(BacklashInverse(backlash_gap=GAP, jump_velocity=3e-3), velocity, gap_estimate=np.full(80, 3.0 * GAP))
    assert np.array_equal(seen, three)
    unseen = shift_of(BacklashInverse(backlash_gap=GAP, jump_velocity=1e-3), velocity, gap_estimate=np.zeros(80))
    assert np.array_equal(unseen, one)


@pytest.mark.parametrize("time_constant", [0.01, 0.1, 1.0])
def test_a_load_with_inertia_changes_sides_before_it_turns(time_constant: float) -> None:
    """For v = sin(w t), c v + m a changes sign at tan(w t) = -w T: at pi/2 for inertia alone, at pi for friction alone."""
    w, n = 2.0 * math.pi, 1000
    t = np.arange(n) * PERIOD
    part = BacklashInverse(backlash_gap=GAP, jump_velocity=1e3, load_time_constant=time_constant)
    shift = shift_of(part, np.sin(w * t), reference_acceleration=w * np.cos(w * t))
    changes = np.flatnonzero(np.diff(np.sign(shift)) != 0)
    wanted = np.array([math.pi, 2.0 * math.pi]) - math.atan(w * time_constant)
    assert t[changes] == pytest.approx(wanted / w, abs=1.5 * PERIOD)


def test_a_known_side_is_taken_up_before_the_first_motion() -> None:
    known = BacklashInverse(backlash_gap=GAP, initial_direction=-1.0, jump_velocity=1e-3)
    assert shift_of(known, np.zeros(20))[[0, 9, 19]] == pytest.approx([-1e-6, -10e-6, -10e-6])


# --- properties of all compensations -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("part", SHIFTING)
def test_nothing_is_shifted_before_the_first_motion_and_the_side_is_kept_at_standstill(part: Any) -> None:
    assert not shift_of(part, np.zeros(50)).any()
    shift = shift_of(part, legs((60, -0.1), (200, 0.0), (60, -0.1)))
    assert (shift[40:] == -0.5 * GAP).all()


@pytest.mark.parametrize("part", SHIFTING)
def test_noise_at_standstill_does_not_chatter(part: Any) -> None:
    """Velocity noise of the reference stays within the dead band, before and after the first motion."""
    noise = np.random.default_rng(3).uniform(-0.99e-4, 0.99e-4, 2000)
    assert not shift_of(part, noise).any()
    found = run_alone(part, {"reference_velocity": np.concatenate([legs((60, 0.1)), noise])})
    assert (found["reference_shift"][60:] == 0.5 * GAP).all()
    assert not found.get("command", np.zeros(1)).any()


@pytest.mark.parametrize("part", SHIFTING)
def test_backward_motion_mirrors_forward_motion(part: Any) -> None:
    velocity = np.random.default_rng(4).normal(size=12).repeat(25)
    assert np.array_equal(shift_of(part, -velocity), -shift_of(part, velocity))


# --- the offset of numerical controls ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("speed", "acceleration"),
    [pytest.param(2e-3, 2.0, id="trapezoid"), pytest.param(1.0, 2.0, id="triangle"), pytest.param(1e-3, 1e3, id="jump of speed")],
)
def test_the_offset_takes_the_time_of_its_limits(speed: float, acceleration: float) -> None:
    """b/v + v/a with a stretch at full speed, otherwise 2 sqrt(b/a); the first tick of motion already moves the offset."""
    gap = 50e-6
    part = BacklashOffset(backlash_gap=gap, backlash_velocity=speed, backlash_acceleration=acceleration)
    n = 300
    offset = shift_of(part, legs((n, 0.1), (n, -0.1)))
    reached = int(np.flatnonzero(offset[n:] == -0.5 * gap)[0]) + 1
    full = gap >= speed**2 / acceleration
    wanted = gap / speed + speed / acceleration if full else 2.0 * math.sqrt(gap / acceleration)
    assert reached * PERIOD == pytest.approx(wanted, abs=2.0 * PERIOD)
    assert (offset[n + reached :] == -0.5 * gap).all()


@given(
    gap=st.floats(1e-6, 1e-3),
    speed=st.floats(1e-4, 1.0),
    acceleration=st.floats(1e-2, 1e3),
    turns=st.lists(st.integers(1, 60), min_size=1, max_size=12),
)
def test_the_offset_keeps_its_limits_whenever_the_axis_turns(gap: float, speed: float, acceleration: float, turns: list[int]) -> None:
    velocity = np.concatenate([legs((n, (-1.0) ** i)) for i, n in enumerate(turns)])
    part = BacklashOffset(backlash_gap=gap, backlash_velocity=speed, backlash_acceleration=acceleration)
    offset = shift_of(part, velocity)
    rate = np.diff(offset, prepend=0.0) / PERIOD
    rise = np.diff(rate, prepend=0.0) / PERIOD
    assert np.abs(offset).max() <= 0.5 * gap * (1.0 + 1e-12)
    assert np.abs(rate).max() <= speed * (1.0 + 1e-9)
    # Second differences lose digits.
    assert np.abs(rise).max() <= acceleration * (1.0 + 1e-6) + 1e-15 * gap / PERIOD**2 * 10.0


def test_the_offset_ends_exactly_at_its_target_at_any_period() -> None:
    for period in (1e-5, 1e-4, 3.3e-4, 1e-3, 7e-3):
        part = BacklashOffset(backlash_gap=17.3e-6, backlash_velocity=3e-3, backlash_acceleration=1.7)
        n = int(0.05 / period)
        found = run_alone(part, {"reference_velocity": legs((n, 1.0), (n, -1.0))}, period=period)["reference_shift"]
        assert found[n - 1] == 0.5 * 17.3e-6 and found[-1] == -0.5 * 17.3e-6


# --- pulses -----------------------------------------------------------------------------------------------------------------------------


def test_the_two_stages_of_a_pulse() -> None:
    part = QuadrantPulses(
        first_amplitude=3.0,
        first_width=0.01,
        first_delay=0.002,
        second_amplitude=1.5,
        second_width=0.02,
        second_delay=0.008,
        position_pulse=1e-6,
    )
    found = run_alone(part, {"reference_velocity": legs((50, 1.0), (100, -1.0), (100, 0.0))})
    k = np.arange(200) * 1.0
    first, second = (k >= 2) & (k < 12), (k >= 8) & (k < 28)
    assert not found["command"][:50].any()
    assert found["command"][50:] == pytest.approx(-(3.0 * first + 1.5 * second), abs=1e-15)
    assert found["reference_shift"][50:] == pytest.approx(-1e-6 * first, abs=1e-20)


def test_a_decaying_pulse() -> None:
    part = QuadrantPulses(first_amplitude=2.0, first_width=0.015, first_delay=0.003, shape="decay")
    command = run_alone(part, {"reference_velocity": legs((20, -1.0), (200, 1.0))})["command"][20:]
    t = np.arange(200) * PERIOD - 0.003
    assert command == pytest.approx(np.where(t > -1e-9, 2.0 * np.exp(-t / 0.015), 0.0), rel=1e-12, abs=1e-15)


@pytest.mark.parametrize(
    ("acceleration", "size"),
    [(0.0, 0.0), (0.1, 0.5), (0.2, 1.0), (0.7, 1.0), (1.5, 1.0), (2.0, 0.7), (2.5, 0.4), (30.0, 0.4)],
)
def test_the_acceleration_at_the_reversal_sets_the_size_of_a_pulse(acceleration: float, size: float) -> None:
    part = QuadrantPulses(first_amplitude=3.0, acceleration_1=0.2, acceleration_2=1.5, acceleration_3=2.5, fast_ratio=0.4)
    for sign in (1.0, -1.0):
        velocity = sign * legs((20, 1.0), (20, -1.0))
        # Later accelerations do not matter.
        pull = np.where(np.arange(40) == 20, -sign * acceleration, 99.0)
        command = run_alone(part, {"reference_velocity": velocity, "reference_acceleration": pull})["command"]
        assert command[20:39] == pytest.approx(np.full(19, -sign * 3.0 * size), abs=1e-12)


def test_the_characteristic_may_be_a_step() -> None:
    part = QuadrantPulses(first_amplitude=1.0, acceleration_2=1.0, acceleration_3=1.0, fast_ratio=0.25)
    velocity = legs((5, 1.0), (5, -1.0))
    sizes = [
        run_alone(part, {"reference_velocity": velocity, "reference_acceleration": np.full(10, a)})["command"][6] for a in (0.99, 1.01)
    ]
    assert sizes == [-1.0, -0.25]


def test_pulses_begin_only_at_a_reversal_and_the_next_one_ends_them() -> None:
    part = QuadrantPulses(first_amplitude=1.0, first_width=0.05)
    velocity = legs((10, 0.0), (30, 1.0), (20, 0.0), (30, 1.0), (20, -1.0), (30, 1.0), (60, 1.0))
    command = run_alone(part, {"reference_velocity": velocity})["command"]
    assert not command[:90].any()
    assert (command[90:110] == -1.0).all()
    assert (command[110:160] == 1.0).all()
    assert not command[160:].any()


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"acceleration_1": 2.0, "acceleration_2": 1.0}, "acceleration_2 = 1 m/s\\^2: must be >= acceleration_1, 2"),
        ({"acceleration_2": 2.0, "acceleration_3": 1.0}, "acceleration_3 = 1"),
        ({"first_width": 0.0}, "first_width"),
    ],
)
@pytest.mark.parametrize("kind", [QuadrantPulses, CncBacklash])
def test_a_characteristic_with_decreasing_points_is_refused(kind: Any, changed: dict[str, float], said: str) -> None:
    with pytest.raises(ParameterError, match=said):
        kind(**{"first_amplitude": 1.0, **({"backlash_gap": GAP} if kind is CncBacklash else {}), **changed})


def test_offset_and_pulses_add_up() -> None:
    rng = np.random.default_rng(5)
    fed = {"reference_velocity": rng.normal(size=20).repeat(23), "reference_acceleration": rng.normal(size=460)}
    both = CncBacklash(**CncBacklash.example)
    found = run_alone(both, fed)
    offset = BacklashOffset(**{name: getattr(both, name) for name in BacklashOffset.parameters})
    pulses = run_alone(QuadrantPulses(**{name: getattr(both, name) for name in QuadrantPulses.parameters}), fed)
    assert found["reference_shift"] == pytest.approx(shift_of(offset, fed["reference_velocity"]) + pulses["reference_shift"], abs=1e-18)
    assert np.array_equal(found["command"], pulses["command"])
    assert pulses["command"].any() and pulses["reference_shift"].any()
