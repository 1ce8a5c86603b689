"""The fit of causes to circles, against errors in closed form."""

from __future__ import annotations

import math

import made_circles
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.errors import ResultError
from contourlab.features.circle.command import HELD, Cause, _fit_findings, causes_of, correlations_of, lags_of, plus_minus, value_text
from contourlab.features.circle.fit import fit_circle
from contourlab.features.circle.runs import CircleRun, find_circle, runs_of, runs_of_angles

AXES = ("x", "y")


def causes(*, pitch: float | None = None, **made: object) -> dict[str, Cause]:
    listed = causes_of(fit_circle(made_circles.runs(**made), AXES, pitch))  # type: ignore[arg-type]
    return {cause.name: cause for cause in reversed(listed)}  # the larger of two vibrations


@pytest.mark.parametrize(
    ("sizes", "name", "value", "adds"),
    [
        ({"x": 8e-6}, "backlash x", 8e-6, 8e-6),
        ({"y": -5e-6}, "backlash y", -5e-6, 5e-6),
        ({"play": 4e-6}, "lateral play x", 4e-6, 4e-6),
        ({"square": 1e-4}, "squareness", 1e-4, 5e-6),
        ({"scale": 2e-4}, "scaling mismatch", 2e-4, 1e-5),
        ({"lag": 2e-4}, "servo mismatch", 2e-4, 1e-5),
        ({"cyclic": 3e-6}, "cyclic error x", 3e-6, 6e-6),
        ({"shake": 3e-6}, "vibration", 3e-6, 6e-6),
        ({"spike": 6e-6}, "reversal spikes x", 6e-6, 6e-6),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
@pytest.mark.slow
def test_each_cause_comes_back(sizes: dict[str, float], name: str, value: float, adds: float) -> None:
    found = causes(**sizes)
    largest = max(found.values(), key=lambda cause: cause.contribution)
    assert largest.name == name and largest.is_sure
    assert largest.value == pytest.approx(value, rel=0.02)
    assert largest.contribution == pytest.approx(adds, rel=0.02)
    # Plus a thousandth: the signatures are of first order.
    assert abs(largest.value - value) < 3.0 * largest.value_deviation + 1e-3 * abs(value)
    others = [cause for cause in found.values() if cause.name != name and "spikes" not in cause.name]
    assert max(cause.contribution for cause in others) < 0.02 * adds


@pytest.mark.slow
def test_all_causes_at_once() -> None:
    made = {"x": 8e-6, "play": 3e-6, "square": 5e-5, "scale": 2e-5, "lag": 1e-4, "cyclic": 1e-6, "shake": 5e-7}
    found = causes(**made)
    values = {"backlash x": 8e-6, "lateral play x": 3e-6, "squareness": 5e-5, "scaling mismatch": 2e-5, "servo mismatch": 1e-4}
    for name, value in values.items():
        assert found[name].value == pytest.approx(value, rel=0.02), name
    assert found["cyclic error x"].pitch == pytest.approx(0.01, rel=1e-3)
    assert found["vibration"].frequency == pytest.approx(60.0, rel=1e-3)
    assert found["cyclic error x"].value == pytest.approx(1e-6, rel=0.02)
    assert found["vibration"].value == pytest.approx(5e-7, rel=0.02)


@pytest.mark.parametrize("gaps", [(20e-6, 8e-6), pytest.param((60e-6, 4e-6), marks=pytest.mark.slow)])
@pytest.mark.parametrize("spike", [0.0, 1.3e-6, -1.3e-6, 2.7e-6])
def test_the_time_that_play_needs_to_be_crossed_is_no_spike(gaps: tuple[float, float], spike: float) -> None:
    listed = causes_of(fit_circle(made_circles.runs_behind(gaps, spike=spike), AXES))
    assert [cause.name for cause in listed[:2]] == ["backlash x", "backlash y"]
    assert [cause.value for cause in listed[:2]] == pytest.approx(gaps, rel=0.02)
    # The motor's own spikes remain, except for what they do while the load stays.
    spikes = {cause.axis: cause for cause in listed if cause.cause == "reversal spikes"}
    assert spikes["x"].contribution < abs(spike) + 4e-7
    assert spikes["y"].contribution < 4e-7


def test_a_spike_beside_play_is_still_seen() -> None:
    spikes = {
        cause.axis: cause
        for cause in causes_of(fit_circle(made_circles.runs_behind((4e-6, 0.0), spike=6e-6), AXES))
        if "spike" in cause.name
    }
    assert spikes["x"].is_sure
    assert spikes["x"].value == pytest.approx(6e-6, rel=0.35)


@pytest.mark.slow
def test_a_given_pitch_is_used() -> None:
    assert causes(cyclic=3e-6, pitch=0.01)["cyclic error x"].pitch == 0.01


@settings(max_examples=8)
@given(start=st.floats(-3.0, 3.0), first=st.booleans())
@pytest.mark.slow
def test_start_angle_and_order_of_senses_do_not_matter(start: float, first: bool) -> None:
    found = causes(start=start, senses=(first, not first), x=8e-6, square=1e-4, lag=1e-4)
    assert found["backlash x"].value == pytest.approx(8e-6, rel=0.01)
    assert found["squareness"].value == pytest.approx(1e-4, rel=0.01)
    assert found["servo mismatch"].value == pytest.approx(1e-4, rel=0.01)


def test_one_sense_does_not_separate_squareness_from_servo_mismatch() -> None:
    found = causes(senses=(False,), square=1e-4, lag=1e-4)
    assert "squareness" not in found and "servo mismatch" not in found
    # q R + T v counter-clockwise, q R - T v clockwise
    assert found["squareness or servo mismatch"].value == pytest.approx(1e-5, rel=0.01)
    clockwise = causes(senses=(True,), square=1e-4, lag=1e-4)
    assert clockwise["squareness or servo mismatch"].contribution < 1e-7


@pytest.mark.slow
def test_deviations_are_those_of_repeated_measurements() -> None:
    turned, values, stated = np.arange(0.0, 2.0 * math.pi, 2e-3), [], []
    for seed in range(24):
        random = np.random.default_rng(seed)
        pair = [
            CircleRun("made", cw, 0.05, -turned if cw else turned, 1e-7 * random.standard_normal(turned.size), 0.05) for cw in (False, True)
        ]
        square = {cause.name: cause for cause in causes_of(fit_circle(pair, AXES))}["squareness"]
        values.append(square.value)
        stated.append(square.value_deviation)
    assert np.std(values) == pytest.approx(np.mean(stated), rel=0.5)


def test_correlated_estimates_are_named() -> None:
    pairs = correlations_of(fit_circle(made_circles.runs(senses=(False,), x=8e-6), AXES))
    assert pairs and all(0.9 < abs(pair.correlation) <= 1.0 for pair in pairs)
    assert not correlations_of(fit_circle(made_circles.runs(x=8e-6), AXES))


def test_lag_of_each_axis() -> None:
    x, y = lags_of(fit_circle(made_circles.runs(lag=2e-4), AXES))
    assert (x.time, y.time) == (pytest.approx(2e-4, rel=0.01), pytest.approx(0.0, abs=2e-6))


def test_lines_to_the_circle_do_not_move_it() -> None:
    command, _ = made_circles.positions(False)
    points = np.concatenate([np.linspace([0.0, 0.0], command[0], 3000), command])
    circle = find_circle(points)
    assert circle.radius == pytest.approx(0.05, abs=1e-9) and np.linalg.norm(circle.centre) < 1e-9


def test_a_line_is_no_circle() -> None:
    with pytest.raises(ResultError, match="no circle"):
        find_circle(np.linspace([0.0, 0.0], [0.1, 0.05], 500))


def test_half_a_turn_is_refused() -> None:
    with pytest.raises(ResultError, match="whole turn"):
        runs_of_angles("made", np.linspace(0.0, math.pi, 500), np.zeros(500), 0.1, math.nan)


def test_different_feeds_are_refused() -> None:
    one, other = made_circles.runs()
    with pytest.raises(ResultError, match="one feed"):
        fit_circle([one, CircleRun(other.name, other.clockwise, other.radius, other.turned, other.deviation, 0.1)], AXES)


def test_values_have_as_many_digits_as_they_are_sure_of() -> None:
    assert plus_minus(8.0049e-6, 2.3e-8) == "8.005 +- 0.023"
    assert value_text(Cause("vibration", "", 1e-6, 1e-8, 5e-7, 1e-8, "m", order=60.0)).endswith("at 60 per turn")


@pytest.mark.parametrize("turns", [1.0, 2.0])
def test_a_swing_from_the_line_before_is_no_circle_if_a_turn_remains(turns: float) -> None:
    time = np.arange(0.0, 2.0 * turns, 1e-3)
    turned = np.pi * time
    command = 0.015 * np.column_stack([np.cos(turned), np.sin(turned)])
    position = (1.0 + 0.02 * np.exp(-time / 0.03))[:, None] * command
    (run,) = runs_of("made", position, 1e-3, find_circle(command), command)
    assert (np.abs(run.deviation).max() < 1e-8) == (turns > 1.0)


@pytest.mark.parametrize("feed", [*(pytest.param(feed, marks=pytest.mark.slow) for feed in (0.01, 0.1)), 0.03, 0.05])
@pytest.mark.parametrize("gaps", [(20e-6, 8e-6), pytest.param((5e-6, 5e-6), marks=pytest.mark.slow)])
def test_a_circle_too_fast_for_a_load_is_named(feed: float, gaps: tuple[float, float], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(made_circles, "FEED", feed)
    fit = fit_circle(made_circles.runs_behind(gaps, held=HELD), AXES)
    found = {cause.name: cause.value for cause in causes_of(fit)}
    wrong = max(abs(found[f"backlash {axis}"] / gap - 1.0) for axis, gap in zip(AXES, gaps, strict=True))
    named = any(one.code == "CL494" for one in _fit_findings(fit, (), ()))
    assert named is (feed**2 / made_circles.RADIUS > HELD)
    assert wrong > 0.3 if named else wrong < 0.05
