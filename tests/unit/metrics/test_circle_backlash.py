"""Backlash from circular tests: circles with planted axis errors, judged by the true radial deviation and not that of a fit."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from made_circles import behind
from numpy.typing import NDArray

from contourlab.errors import ContourlabError, ParameterError, ResultError
from contourlab.metrics.circles import CircleBacklash, backlash_from_circle, backlash_of_runs, circle_figures

Array = NDArray[np.float64]

RADIUS = 0.05
CENTRE = np.array([0.3, -0.1])


def measured(sense: float, n: int = 3600, **causes: Any) -> Array:
    """Return positions (n, 2) of a circle with the given axis errors, run in one sense."""
    get = {"backlash": (0.0, 0.0), "slope": (0.0, 0.0), "centre": (0.0, 0.0), "spike": (0.0, 0.0), **causes}.get
    phi = sense * np.linspace(0.1, 0.1 + 2.0 * math.pi, n, endpoint=False)
    unit = np.column_stack([np.cos(phi), np.sin(phi)])
    direction = sense * np.column_stack([-np.sin(phi), np.cos(phi)])
    out = RADIUS * unit
    out[:, 0] *= 1.0 + 0.5 * get("scale", 0.0)
    out[:, 1] *= 1.0 - 0.5 * get("scale", 0.0)
    out[:, 0] += get("squareness", 0.0) * RADIUS * unit[:, 1]
    out[:, 0] -= get("servo", 0.0) * direction[:, 0]
    out -= 0.5 * np.sign(direction) * (np.array(get("backlash")) + np.array(get("slope")) * unit)
    out += get("centre")
    out *= 1.0 + get("mean", 0.0) / RADIUS
    for axis in (0, 1):
        # After each reversal the table lags for a while: outwards, because the axis is at its end.
        since = np.mod(sense * (phi - 0.5 * math.pi * axis), math.pi)
        out[:, axis] += get("spike")[axis] * np.sign(unit[:, axis]) * np.exp(-since / math.radians(2.0))
    return CENTRE + out


EVERYTHING = {"scale": 8e-5, "squareness": -6e-5, "servo": 9e-6, "centre": (7e-6, -4e-6), "mean": -12e-6, "backlash": (6e-6, 2.5e-6)}


def noisy(points: Array, rng: np.random.Generator) -> Array:
    """Return the points with noise of one count, rounded to counts of 0.1 um."""
    return 1e-7 * np.round((points + 1e-7 * rng.normal(size=points.shape)) / 1e-7)


def test_all_causes_together_are_separated() -> None:
    """The first order neglects (e/R)^2 R, some 0.02 um here."""
    rng = np.random.default_rng(1)
    found = backlash_from_circle(noisy(measured(1.0, **EVERYTHING), rng), CENTRE, RADIUS, opposite=noisy(measured(-1.0, **EVERYTHING), rng))
    assert found.backlash == pytest.approx((6e-6, 2.5e-6), abs=0.05e-6)
    assert found.scale_mismatch == pytest.approx(8e-5, abs=1e-6)
    assert found.squareness == pytest.approx(-6e-5, abs=1e-6)
    assert found.servo_mismatch == pytest.approx(9e-6, abs=0.05e-6)
    assert found.centre == pytest.approx((7e-6, -4e-6), abs=0.05e-6)
    assert found.mean_radial == pytest.approx(-12e-6, abs=0.05e-6)
    assert found.residual == pytest.approx(1e-7 * math.sqrt(1.0 + 1.0 / 12.0), rel=0.05)
    assert math.isnan(found.diagonal)
    assert [q.axis for q in found.quadrants] == ["x", "y", "x", "y"] * 2
    for q in found.quadrants:
        assert q.step == pytest.approx(6e-6 if q.axis == "x" else 2.5e-6, abs=0.1e-6)
        assert abs(q.spike_height) < 1e-6


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_one_sense_gives_backlash_too(sense: float) -> None:
    found = backlash_from_circle(measured(sense, **EVERYTHING), CENTRE, RADIUS)
    assert found.backlash == pytest.approx((6e-6, 2.5e-6), abs=0.05e-6)
    assert math.isnan(found.squareness) and math.isnan(found.servo_mismatch)
    assert found.diagonal == pytest.approx(0.5 * (-6e-5 * RADIUS + sense * 9e-6), abs=0.05e-6)
    assert all(q.clockwise == (sense < 0.0) for q in found.quadrants)


def test_no_backlash_is_found_without_backlash() -> None:
    runs = [measured(sense, **{**EVERYTHING, "backlash": (0.0, 0.0)}) for sense in (1.0, -1.0)]
    assert backlash_from_circle(runs[0], CENTRE, RADIUS, opposite=runs[1]).backlash == pytest.approx((0.0, 0.0), abs=0.02e-6)


def test_backlash_that_differs_between_the_ends() -> None:
    """10 um at +x and 4 um at -x; 3 um at +y and 5 um at -y."""
    causes = {**EVERYTHING, "backlash": (7e-6, 4e-6), "slope": (3e-6, -1e-6)}
    found = backlash_from_circle(measured(1.0, **causes), CENTRE, RADIUS, opposite=measured(-1.0, **causes))
    steps = {(q.angle, q.clockwise): q.step for q in found.quadrants}
    for clockwise in (False, True):
        wanted = [10e-6, 3e-6, 4e-6, 5e-6]
        assert [steps[0.5 * math.pi * i, clockwise] for i in range(4)] == pytest.approx(wanted, abs=0.1e-6)
    assert found.backlash == pytest.approx((7e-6, 4e-6), abs=0.05e-6)


@pytest.mark.parametrize("height", [8e-6, -5e-6])
def test_spikes_are_measured_and_do_not_affect_the_backlash(height: float) -> None:
    """exp(-phi/2 deg) falls to half its height at 2 ln 2 degrees, and to half a thousandth after 15 degrees."""
    causes = {**EVERYTHING, "spike": (height, 0.0)}
    found = backlash_from_circle(measured(1.0, **causes), CENTRE, RADIUS, opposite=measured(-1.0, **causes))
    assert found.backlash == pytest.approx((6e-6, 2.5e-6), abs=0.05e-6)
    for q in found.quadrants:
        if q.axis == "x":
            assert q.spike_height == pytest.approx(height, abs=0.2e-6)
            assert q.spike_width == pytest.approx(math.radians(2.0 * math.log(2.0)), abs=math.radians(0.15))
        else:
            assert abs(q.spike_height) < 0.2e-6


def test_the_stated_deviation_matches_the_scatter() -> None:
    """Over 60 circles the estimates scatter by their stated deviation, with white noise or noise correlated over ten samples."""
    clean = measured(1.0, n=1200, **EVERYTHING)
    truth = np.array(backlash_from_circle(clean, CENTRE, RADIUS).backlash)
    for lasting in (1, 10):
        rng, z = np.random.default_rng(lasting), []
        for _ in range(60):
            white = rng.normal(size=(1200 + lasting, 2))
            noise = sum(white[i : i + 1200] for i in range(lasting)) * 3e-7
            found = backlash_from_circle(clean + noise, CENTRE, RADIUS)
            z.append((np.array(found.backlash) - truth) / np.array(found.deviation))
        assert 0.7 < float(np.sqrt(np.mean(np.square(z)))) < 1.35


def figures(found: CircleBacklash) -> list[float]:
    return [*found.backlash, found.mean_radial, *found.centre, found.servo_mismatch]


@given(scale=st.floats(1e-2, 1e2), shift=st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0)), start=st.integers(0, 719))
@pytest.mark.slow
def test_units_position_and_start_do_not_matter(scale: float, shift: tuple[float, float], start: int) -> None:
    runs = [measured(sense, n=720, **EVERYTHING) for sense in (1.0, -1.0)]
    one = backlash_from_circle(runs[0], CENTRE, RADIUS, opposite=runs[1])
    moved = [np.roll(scale * run + np.array(shift), start, axis=0) for run in runs]
    other = backlash_from_circle(moved[1], scale * CENTRE + np.array(shift), scale * RADIUS, opposite=moved[0])
    # Differences of positions a metre away lose digits.
    assert figures(other) == pytest.approx([scale * f for f in figures(one)], rel=1e-6, abs=1e-12)
    assert other.squareness == pytest.approx(one.squareness, rel=1e-6)
    assert other.scale_mismatch == pytest.approx(one.scale_mismatch, rel=1e-6)


def test_both_axes_are_treated_alike() -> None:
    """Mirroring on the diagonal swaps x and y and reverses the sense."""
    one = backlash_from_circle(measured(1.0, **EVERYTHING), CENTRE, RADIUS, opposite=measured(-1.0, **EVERYTHING))
    swapped = backlash_from_circle(
        measured(1.0, **EVERYTHING)[:, ::-1], CENTRE[::-1], RADIUS, opposite=measured(-1.0, **EVERYTHING)[:, ::-1], axes=("u", "v")
    )
    assert swapped.axes == ("u", "v")
    assert swapped.backlash == pytest.approx(one.backlash[::-1], rel=1e-9)
    assert swapped.servo_mismatch == pytest.approx(-one.servo_mismatch, rel=1e-9)
    assert swapped.scale_mismatch == pytest.approx(-one.scale_mismatch, rel=1e-9)
    assert swapped.squareness == pytest.approx(one.squareness, rel=1e-9)


def test_circles_of_a_result_are_accepted_too() -> None:
    runs = [circle_figures(measured(s, **EVERYTHING) - CENTRE, np.zeros(2), RADIUS, s < 0.0, "circle") for s in (1.0, -1.0)]
    direct = backlash_from_circle(measured(1.0, **EVERYTHING), CENTRE, RADIUS, opposite=measured(-1.0, **EVERYTHING))
    assert figures(backlash_of_runs(runs)) == pytest.approx(figures(direct), rel=1e-9)


ROUND = measured(1.0, n=720)


@pytest.mark.parametrize(
    ("position", "options", "said"),
    [
        (ROUND[:50], {}, "50 samples"),
        (ROUND[:400], {}, "full circle"),
        (np.concatenate([ROUND[:360], ROUND[359::-1]]), {}, "full circle"),
        (np.where(np.arange(720)[:, None] == 3, np.nan, ROUND), {}, "not finite"),
        (ROUND[:, :1], {}, "shape"),
        (ROUND + 0.02, {}, "no circle"),
        (ROUND, {"opposite": ROUND}, "2 runs in 1 senses"),
        (np.delete(ROUND, range(100, 150), axis=0), {}, "without a"),
        (ROUND, {"after": math.radians(70.0)}, "60 degrees"),
        (ROUND, {"before": -0.1}, "60 degrees"),
        (ROUND, {"radius": 0.0}, "radius"),
    ],
)
def test_other_records_are_refused(position: Array, options: dict[str, Any], said: str) -> None:
    with pytest.raises(ContourlabError, match=said) as refused:
        backlash_from_circle(position, CENTRE, **{"radius": RADIUS, **options})
    assert isinstance(refused.value, ResultError | ParameterError)


def test_runs_of_different_radii_are_refused() -> None:
    runs = [
        circle_figures((1.0 + 0.1 * (s < 0)) * (measured(s) - CENTRE), np.zeros(2), RADIUS * (1.0 + 0.1 * (s < 0)), s < 0, "c")
        for s in (1, -1)
    ]
    with pytest.raises(ResultError, match="different radii"):
        backlash_of_runs(runs)


def test_the_time_that_play_needs_to_be_crossed_is_no_spike() -> None:
    phi = np.linspace(-0.3, 2.0 * math.pi + 0.2, 8000)
    loads = RADIUS * np.column_stack([behind(np.cos(phi) * RADIUS, 20e-6), behind(np.sin(phi) * RADIUS, 8e-6)]) / RADIUS
    found = backlash_from_circle(CENTRE + loads[300:], CENTRE, RADIUS)
    assert found.backlash == pytest.approx((20e-6, 8e-6), rel=0.01)
    assert max(abs(q.spike_height) for q in found.quadrants) < 0.3e-6
