"""Velocity drives: their models from logs, their gains, and what is known of the load."""

from dataclasses import replace

import numpy as np
import pytest
from made_circles import behind

from contourlab.features.commission.identification import IdentifiedAxis, count_of, identify_axis, lost_motion_at_motor
from contourlab.features.commission.loop import AxisModel, Law, run_lanes
from contourlab.features.commission.records import AxisLog, decided
from contourlab.features.commission.tuning import AxisTask, tune_axis

PERIOD = 1e-3
DRIVES = {
    "50": AxisModel(gain=2.5, damping=55.0, friction=0.02, delay=1e-3, regulated=50.0, reset=8.0),
    "250": AxisModel(gain=0.25, damping=262.0, friction=0.03, offset=0.02, delay=0.4e-3, regulated=250.0, reset=25.0),
    "500": AxisModel(gain=25.0, damping=500.0, friction=0.03, regulated=500.0),
}
"""Inner loops [1/s]: with an integral, but for the last one."""


def command() -> np.ndarray:
    """Return strokes [m] at several speeds and accelerations, with rests."""
    time, speed = PERIOD * np.arange(12_000), np.zeros(12_000)
    for k, (fastest, change) in enumerate(((0.004, 0.02), (0.05, 0.05), (0.2, 0.2), (0.1, 0.1), (0.2, 0.2), (0.05, 0.06))):
        for way, first in ((1.0, 2.0 * k + 0.1), (-1.0, 2.0 * k + 1.0)):
            speed += way * fastest * np.clip(np.minimum(time - first, first + 0.8 - time) / change, 0.0, 1.0)
    return PERIOD * np.cumsum(speed)


def present(model: AxisModel) -> np.ndarray:
    """Return modest gains (7,): Kv 12 1/s and four fifths of the feedforward."""
    return np.array([12.0, 0.0, 0.0, 0.0, 0.8, 0.0, 0.0]) * model.per_speed


def log_of(model: AxisModel, count: float = 0.0) -> AxisLog:
    """Return the log of an axis with counts or noise."""
    noise = np.random.default_rng(3).uniform(-1e-7, 1e-7, command().size)
    run = run_lanes(command(), noise, present(model)[None], [model], Law(PERIOD), trace=True)
    measured = count * np.round(run.position / count) if count else run.position
    return AxisLog("made", "x", PERIOD, command(), measured, run.command_output)


def identified(model: AxisModel) -> IdentifiedAxis:
    """Return the model of the log of an axis."""
    axis = identify_axis([log_of(model)], present(model), Law(PERIOD), velocity=True)
    assert isinstance(axis, IdentifiedAxis) and axis.usable
    return axis


@pytest.mark.slow
@pytest.mark.parametrize("name", DRIVES)
def test_a_log_gives_speed_lag_delay_and_integral(name: str) -> None:
    model, axis = DRIVES[name], identified(DRIVES[name])
    assert axis.model.per_speed == pytest.approx(model.per_speed, rel=1e-4)
    assert 1.0 / axis.model.damping == pytest.approx(1.0 / model.damping, abs=3.0 * axis.deviations["lag"])
    assert axis.model.delay == pytest.approx(model.delay, abs=3.0 * axis.deviations["delay"])
    assert axis.deviations["lag"] < 0.02 / model.damping
    assert axis.model.friction == pytest.approx(model.friction, rel=0.05)
    assert axis.model.reset == pytest.approx(model.reset, rel=0.02)
    assert axis.deviations["speed"] < 1e-3 * axis.model.gain / axis.model.regulated
    assert axis.simulated == pytest.approx(axis.measured, rel=0.02)


@pytest.mark.slow
def test_tuned_gains_do_what_they_predict_on_the_drive_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("contourlab.features.commission.tuning.BUDGET", 200)
    model, axis = DRIVES["250"], identified(DRIVES["250"])
    task = AxisTask(axis.model, axis.law, [(command(), axis.noise_like(command()))])
    tuned = tune_axis(task)
    noise = np.random.default_rng(5).uniform(-1e-7, 1e-7, command().size)
    before, after = (run_lanes(command(), noise, gains[None], [model], Law(PERIOD)).largest[0] for gains in (present(model), tuned.gains))
    assert after == pytest.approx(tuned.largest, rel=0.1) and after < 0.05 * before
    for factor in (0.75, 1.25):
        assert run_lanes(command(), noise, tuned.gains[None], [model.scaled(factor)], Law(PERIOD)).largest[0] < 1.1 * tuned.spread


@pytest.mark.parametrize(("swing", "told"), [(0.0, True), (4e-5, False)])
def test_nothing_is_predicted_of_a_load_that_swings(monkeypatch: pytest.MonkeyPatch, swing: float, told: bool) -> None:
    monkeypatch.setattr("contourlab.features.commission.identification._explains", lambda *_: False)  # no resonance is found
    model, log = DRIVES["500"], log_of(DRIVES["500"])
    ringing = swing * np.gradient(np.gradient(command())) / (PERIOD**2 * 4.0)
    log = replace(log, load=behind(log.measured, 3e-5) - ringing)
    axis = identify_axis([log], present(model), Law(PERIOD), velocity=True)
    assert isinstance(axis, IdentifiedAxis)
    run = run_lanes(command(), np.zeros(command().size), present(model)[None], [axis.model], Law(PERIOD), trace=True)
    assert bool(np.isfinite(axis.load(run)).all()) is told


def test_the_loop_of_the_drive_may_be_another_but_not_its_speed() -> None:
    for model in DRIVES.values():
        other = model.scaled(0.75)
        assert (other.gain, other.regulated) == pytest.approx((0.75 * model.gain, 0.75 * model.regulated))
        assert other.damping - other.regulated == pytest.approx(model.damping - model.regulated)
    torque = AxisModel(gain=2.0, damping=30.0)
    assert torque.scaled(0.75) == replace(torque, gain=1.5)


def test_a_slow_drive_is_what_the_user_says_it_is() -> None:
    log = log_of(DRIVES["50"])
    answers = {given: decided([(log.output, log.measured)], PERIOD, 1e-3, given) for given in ("unknown", "servo", "velocity drive")}
    assert {given: answer and answer.loop for given, answer in answers.items()} == {
        "unknown": "servo",
        "servo": "servo",
        "velocity drive": "velocity drive",
    }


@pytest.mark.parametrize(("reset", "behind_play"), [(0.0, False), (10.0, True)])
def test_the_loop_of_a_drive_is_no_play(reset: float, behind_play: bool) -> None:
    """At slow reversals speed and force rise together; with play, friction behind it comes back after 30 um."""
    time = PERIOD * np.arange(10_000)
    slow = 2e-4 * np.abs((time + 0.5) % 2.0 - 1.0)  # at 0.2 mm/s
    model = AxisModel(0.4, 440.0, friction=0.15, offset=0.03, delay=3e-3, regulated=400.0, reset=reset)
    if behind_play:
        model = replace(model, resonance=60.0, damping_ratio=0.03, share=0.7, behind=0.4, play=3e-5)
    run = run_lanes(slow, np.zeros(time.size), present(model)[None], [model], Law(PERIOD), trace=True)
    log = AxisLog("made", "x", PERIOD, slow, 1e-6 * np.round(1e6 * run.position), run.command_output)
    play, deviation = lost_motion_at_motor([log], model, 3e-7)
    assert np.isnan(play) != behind_play
    if behind_play:
        assert abs(play - 3e-5) < max(2.0 * deviation, 1e-6)


@pytest.mark.parametrize(("count", "expected"), [(0.0, 0.0), (1e-6, 1e-6), (25.4e-3 / 8192, 25.4e-3 / 8192)])
def test_counts_of_the_encoder_are_seen(count: float, expected: float) -> None:
    log = log_of(DRIVES["250"], count)
    written = replace(log, measured=1e-9 * np.round(1e9 * log.measured)) if count else log  # the digits of a log
    assert count_of([written]) == pytest.approx(expected, rel=1e-3)


def test_the_load_follows_within_the_play() -> None:
    model = DRIVES["500"]
    run = run_lanes(command(), np.zeros(command().size), present(model)[None], [model], Law(PERIOD), trace=True)
    axis = IdentifiedAxis(model, {}, 99.0, Law(PERIOD), np.zeros(0), 0.0, 3e-5, 0.0, 0.0, 0.0)
    assert axis.load(run) == pytest.approx(behind(run.position, 3e-5), abs=1e-12)
    for unknown in ({"play": float("nan")}, {"swings": True}):
        assert np.isnan(replace(axis, **unknown).load(run)).all()
    shaft = replace(model, resonance=40.0, damping_ratio=0.05, share=0.5, play=3e-5, behind=0.5)
    swung = run_lanes(command(), np.zeros(command().size), present(model)[None], [shaft], Law(PERIOD), trace=True)
    assert np.abs(replace(axis, model=shaft).load(swung) - swung.position).max() > 1.5e-5  # half the play, and the twist
