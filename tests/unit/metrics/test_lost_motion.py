"""Gap and windup from motor and load, on records with a known gap."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from contourlab.errors import ContourlabError, ParameterError, ResultError
from contourlab.metrics.lost_motion import LostMotion, lost_motion_from_pair

Array = NDArray[np.float64]

COUNT = 1e-7


def strokes(n: int = 6, length: float = 0.02, samples: int = 800) -> Array:
    """Return the position of a motor that goes there and back n times, with a different speed for each stroke."""
    forth = length * 0.5 * (1.0 - np.cos(np.linspace(0.0, math.pi, samples, endpoint=False)))
    return np.concatenate([forth, length - forth] * n)


def behind(motor: Array, half: Any) -> Array:
    """Return the load behind a play whose half width may depend on position."""
    at, load = float(motor[0]), np.empty_like(motor)
    for k, (m, b) in enumerate(zip(motor, np.broadcast_to(half, motor.shape), strict=True)):
        at = min(max(at, m - b), m + b)
        load[k] = at
    return load


def counted(position: Array, count: float = COUNT) -> Array:
    return count * np.round(position / count)


@pytest.mark.parametrize("gap", [0.0, 2e-6, 20e-6, 200e-6])
def test_the_gap_of_a_play(gap: float) -> None:
    """Counts of 0.1 um on both sides, scales 0.3 m apart, noise of half a count: averaging gives a tenth of a count."""
    rng = np.random.default_rng(1)
    motor = strokes()
    load = behind(motor, 0.5 * gap)
    noisy = [counted(x + 0.5 * COUNT * rng.normal(size=x.size)) for x in (motor, load + 0.3)]
    found = lost_motion_from_pair(*noisy)
    assert found.lost_motion == pytest.approx(gap, abs=0.1 * COUNT)
    assert found.offset == pytest.approx(-0.3, abs=0.1 * COUNT)
    assert (found.passes_forward, found.passes_backward) == (6, 6)
    assert found.lost_motion_at == pytest.approx(np.full(10, gap), abs=0.3 * COUNT)
    assert math.isnan(found.gap) and math.isnan(found.windup) and math.isnan(found.stiffness)
    assert found.lost_motion_deviation < 0.1 * COUNT


def test_standstill_and_crossing_do_not_count() -> None:
    """The axis rests for most of the record with the load anywhere in the gap, and crosses it slowly."""
    motor, gap = strokes(2), 30e-6
    load = behind(motor, 0.5 * gap)
    still = np.full(20_000, motor[-1])
    away = motor[-1] + 0.5 * gap * np.random.default_rng(2).uniform(-1.0, 1.0, still.size)
    found = lost_motion_from_pair(np.concatenate([motor, still, motor]), np.concatenate([load, away, load]))
    assert found.lost_motion == pytest.approx(gap, abs=1e-12)


def test_a_load_free_in_the_gap_at_the_start_does_not_count_as_contact() -> None:
    """It lies at the front. If the motion before the first full crossing counted, the first pass would be wrong by the whole gap."""
    motor, gap = strokes(1), 100e-6
    load, at = np.empty_like(motor), motor[0] + 0.5 * gap
    for k, m in enumerate(motor):
        load[k] = at = min(max(at, m - 0.5 * gap), m + 0.5 * gap)
    assert lost_motion_from_pair(motor, load, bins=100).lost_motion == pytest.approx(gap, abs=1e-12)


def test_scale_errors_along_the_axis_cancel() -> None:
    """A pitch error of 8 um and 50 um per metre, equal in both directions."""
    motor, gap = strokes(), 25e-6
    wrong = 8e-6 * np.sin(2.0 * math.pi * motor / 5e-3) + 5e-5 * motor
    found = lost_motion_from_pair(motor, behind(motor, 0.5 * gap) + wrong, bins=20)
    # At different speeds the two directions sample a bin at different positions: this difference times the error's slope of 1e-2.
    assert found.lost_motion == pytest.approx(gap, abs=2e-8)


def test_a_gap_that_varies_along_the_axis() -> None:
    """b(x) = 20 um + 1 um per millimetre: each bin gives its middle, all together the mean."""
    motor = strokes(samples=4000)
    found = lost_motion_from_pair(motor, motor - (motor - behind(motor, 0.5 * (20e-6 + 1e-3 * motor))), bins=8)
    assert len(found.place) == 8
    assert found.lost_motion_at == pytest.approx(20e-6 + 1e-3 * found.place, abs=2e-8)
    assert found.lost_motion == pytest.approx(20e-6 + 1e-3 * 0.01, abs=1e-7)


def windup_record(gap: float, stiffness: float, speeds: tuple[float, ...]) -> tuple[Array, Array, Array]:
    """Return motor, load and transmitted force: friction of 40 N and 2000 N s/m on strokes at several speeds, 1 ms between samples."""
    motor, force = [np.zeros(1)], [np.zeros(1)]
    for speed in speeds:
        for sense in (1.0, -1.0):
            n = int(0.02 / (speed * 1e-3))
            motor.append(motor[-1][-1] + sense * speed * 1e-3 * np.arange(1, n + 1))
            force.append(np.full(n, sense * (40.0 + 2000.0 * speed)))
    m, f = np.concatenate(motor), np.concatenate(force)
    return m, behind(m, 0.5 * gap + np.abs(f) / stiffness), f


def test_force_separates_windup_from_gap() -> None:
    """2 F/k of some 4.5 um on a gap of 12 um, with counts of 0.1 um: by force, by force and stiffness, by friction and stiffness."""
    gap, stiffness = 12e-6, 2.5e7
    motor, load, force = windup_record(gap, stiffness, (2e-3, 5e-3, 10e-3, 20e-3))
    rng = np.random.default_rng(7)
    record = [counted(x + 0.5 * COUNT * rng.normal(size=x.size)) for x in (motor, load)]
    mean = 40.0 + 2000.0 * (2e-3 + 5e-3 + 10e-3 + 20e-3) / 4.0
    whole = lost_motion_from_pair(*record)
    assert whole.lost_motion == pytest.approx(gap + 2.0 * mean / stiffness, abs=COUNT)
    found = lost_motion_from_pair(*record, force=force)
    assert found.gap == pytest.approx(gap, abs=COUNT)
    assert found.stiffness == pytest.approx(stiffness, rel=0.03)
    assert found.windup == pytest.approx(2.0 * mean / stiffness, abs=COUNT)
    known = lost_motion_from_pair(*record, force=force, stiffness=stiffness)
    assert known.gap == pytest.approx(gap, abs=0.3 * COUNT)
    assert known.gap_deviation < found.gap_deviation
    rubbed = lost_motion_from_pair(*record, friction=mean, stiffness=stiffness)
    assert rubbed.gap == pytest.approx(gap, abs=COUNT)
    assert rubbed.windup == pytest.approx(2.0 * mean / stiffness, rel=1e-12)


def test_a_constant_force_cannot_separate_stiffness_from_gap() -> None:
    motor, load, force = windup_record(12e-6, 2.5e7, (5e-3, 5e-3, 5e-3))
    with pytest.raises(ResultError, match="stiffness"):
        lost_motion_from_pair(motor, load, force=force)
    assert lost_motion_from_pair(motor, load, force=force, stiffness=2.5e7).gap == pytest.approx(12e-6, abs=1e-10)


def test_the_stated_deviation_matches_the_scatter() -> None:
    """Over 60 records with different noise the estimates scatter by their stated deviation."""
    motor, rng = strokes(3, samples=300), np.random.default_rng(6)
    load, z = behind(motor, 5e-6), []
    for _ in range(60):
        passes = np.repeat(rng.normal(size=6), 300) * 2e-7
        found = lost_motion_from_pair(motor, load + passes + 2e-7 * rng.normal(size=load.size), bins=1)
        z.append((found.lost_motion - 10e-6) / found.lost_motion_deviation)
    # Student's t with 4 degrees of freedom has the standard deviation sqrt(2).
    assert np.median(np.abs(z)) == pytest.approx(0.741, abs=0.25)


@given(
    scale=st.floats(1e-3, 1e3),
    shift=st.floats(-0.2, 0.2),
    apart=st.floats(-0.2, 0.2),
    mirrored=st.booleans(),
    repeated=st.integers(1, 4),
)
def test_units_position_direction_and_pace_do_not_matter(scale: float, shift: float, apart: float, mirrored: bool, repeated: int) -> None:
    # No sample lies on the edge of a bin, where rounding would decide.
    motor = strokes(2, samples=150)
    motor += 1e-5 * np.sin(1.7 * np.arange(motor.size))
    load = behind(motor, 15e-6) + 1e-7 * np.sin(np.arange(motor.size))
    one = lost_motion_from_pair(motor, load, bins=3)
    factor = -scale if mirrored else scale
    moved = [np.repeat(factor * x, repeated) + at for x, at in ((motor, shift), (load, shift + apart))]
    other = lost_motion_from_pair(*moved, bins=3)
    assert other.lost_motion == pytest.approx(scale * one.lost_motion, rel=1e-6, abs=1e-12)
    assert np.sort(other.lost_motion_at) == pytest.approx(scale * np.sort(one.lost_motion_at), rel=1e-6, abs=1e-12)


GOOD = strokes(1, samples=100)


@pytest.mark.parametrize(
    ("motor", "load", "said"),
    [
        (GOOD, GOOD[1:], "shapes"),
        (GOOD, np.where(np.arange(GOOD.size) == 7, np.nan, GOOD), "not finite"),
        (np.zeros(50), np.zeros(50), "not move"),
        (GOOD[:100], behind(GOOD, 1e-5)[:100], "backwards"),
        (np.arange(50) * -1e-4, np.arange(50) * -1e-4 + 1e-9 * np.sin(np.arange(50)), "forwards"),
        (GOOD, 0.0 * GOOD, "never goes"),
        (np.zeros(1), np.zeros(1), "not move"),
    ],
)
def test_a_record_without_information_is_refused(motor: Array, load: Array, said: str) -> None:
    with pytest.raises(ResultError, match=said):
        lost_motion_from_pair(motor, load)


@pytest.mark.parametrize(
    "options",
    [{"bins": 0}, {"bins": 1.5}, {"stiffness": 0.0}, {"friction": 5.0}, {"friction": -1.0, "stiffness": 1e7}, {"stiffness": math.inf}],
)
def test_options_out_of_range_are_refused(options: dict[str, Any]) -> None:
    with pytest.raises(ParameterError):
        lost_motion_from_pair(GOOD, behind(GOOD, 1e-5), **options)


def test_a_force_with_the_wrong_sign_is_refused() -> None:
    motor, load, force = windup_record(12e-6, 2.5e7, (2e-3, 20e-3))
    with pytest.raises(ContourlabError, match=r"m/N.*positive"):
        lost_motion_from_pair(motor, load, force=-force)


def test_a_real_length_takes_a_moment() -> None:
    """Ten minutes at 1 kHz."""
    motor = strokes(150, samples=2000)
    found: LostMotion = lost_motion_from_pair(motor, motor - 5e-6 * np.sign(np.diff(motor, prepend=-1.0)))
    assert found.passes_forward == 150 and found.lost_motion == pytest.approx(10e-6, rel=1e-9)
