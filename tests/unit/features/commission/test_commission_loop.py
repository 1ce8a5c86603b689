"""The loop of HAL's pid and an axis against an independent law, closed forms, and its own margins."""

from dataclasses import replace

import numpy as np
import pytest

from contourlab.analysis.linear.margins import Margins, margins
from contourlab.engine.runner import groups_of
from contourlab.features.commission import loop
from contourlab.features.commission.loop import (
    GAINS,
    AxisModel,
    Law,
    driven,
    keep_margins,
    law_output,
    loop_gain,
    robustly_stable,
    run_lanes,
)
from contourlab.features.commission.tuning import AxisTask
from contourlab.features.tune.drive_terms import LinuxCNCGains, linuxcnc_law

PERIOD = 1e-3
AXIS = AxisModel(gain=2.0, damping=30.0)
ROW = np.array([20e3, 100.0, 150.0, 0.0, 35.0, 0.4, 0.0])


def swept(n: int = 4000) -> np.ndarray:
    time = PERIOD * np.arange(n)
    return 0.01 * (1.0 - np.cos(2.0 * np.pi * (0.5 + 0.5 * time) * time))


def test_law_is_that_of_tune() -> None:
    command, measured = swept(), 0.98 * swept()
    gains = LinuxCNCGains(*ROW[:3], ff1=ROW[4], ff2=ROW[5])
    theirs = linuxcnc_law(gains, command, measured, PERIOD)
    assert law_output(command, measured, ROW.tolist(), Law(PERIOD, previous_target=False)) == pytest.approx(theirs, abs=1e-9)


@pytest.mark.parametrize("previous", [False, True])
@pytest.mark.parametrize(("deadband", "bias"), [(0.0, 0.0), (2e-4, 0.01)])
def test_run_obeys_law_and_axis(previous: bool, deadband: float, bias: float) -> None:
    law, command = Law(PERIOD, previous, deadband=deadband, bias=bias), swept()
    model = replace(AXIS, friction=0.02, offset=0.01, delay=2.3e-3)
    run = run_lanes(command, np.zeros(command.size), ROW[None], [model], law, trace=True)
    assert run.command_output == pytest.approx(law_output(command, run.position, ROW.tolist(), law) + bias, abs=1e-6)
    delayed = np.concatenate([np.zeros(2), run.command_output])[: command.size]
    assert run.position == pytest.approx(driven(delayed, [replace(model, delay=0.3e-3)], PERIOD)[0], abs=1e-9)
    assert run.largest[0] == pytest.approx(np.abs(command - run.position).max())


def test_axis_has_its_closed_form() -> None:
    output, n = np.full(500, 0.1), np.arange(500)
    friction = 0.05
    steady = (AXIS.gain * 0.1 - friction) / AXIS.damping
    expected = steady * (PERIOD * n - (1.0 - np.exp(-AXIS.damping * PERIOD * n)) / AXIS.damping)
    assert driven(output, [replace(AXIS, friction=friction)], PERIOD)[0] == pytest.approx(expected, abs=1e-12)
    assert not driven(np.full(50, 0.02), [replace(AXIS, friction=friction)], PERIOD).any()


def test_an_axis_runs_on_from_a_velocity() -> None:
    output, k = np.full(500, 0.1), 200
    whole, steady = driven(output, [AXIS], PERIOD)[0], AXIS.gain * 0.1 / AXIS.damping
    speed = steady * (1.0 - np.exp(-AXIS.damping * PERIOD * k))
    assert driven(output[k:], [AXIS], PERIOD, whole[k], speed)[0] == pytest.approx(whole[k:], abs=1e-12)


DRIVE = AxisModel(gain=250.0, damping=280.0, friction=0.03, regulated=250.0, reset=30.0)
"""A velocity drive with an integral: a unit of output asks for 1 m/s."""


def test_a_velocity_drive_has_the_motion_of_its_equations() -> None:
    output, fine = 0.1 * np.sin(2.0 * np.pi * 3.0 * PERIOD * np.arange(700)) + 0.02, 400
    dt, x, v, held, places = PERIOD / fine, 0.0, 0.0, 0.0, []
    for u in output:
        places.append(x)
        for _ in range(fine):
            push = DRIVE.gain * u + held - DRIVE.damping * v
            held += dt * DRIVE.reset * (DRIVE.gain * u - DRIVE.regulated * v)
            if v == 0.0:
                push -= np.clip(push, -DRIVE.friction, DRIVE.friction)
            else:
                push -= np.copysign(DRIVE.friction, v)
            after = v + dt * push
            v = 0.0 if v * after < 0.0 else after
            x += dt * v
    assert driven(output, [DRIVE], PERIOD)[0] == pytest.approx(places, abs=2e-6)


@pytest.mark.parametrize("ahead", [0.0, 0.7, 1.0])
def test_following_error_of_a_velocity_drive_has_its_closed_form(ahead: float) -> None:
    model, speed, kv = AxisModel(gain=100.0, damping=250.0, regulated=250.0), 0.05, 20.0
    row = np.array([[kv * model.per_speed, 0.0, 0.0, 0.0, ahead * model.per_speed, 0.0, 0.0]])
    command = speed * PERIOD * np.arange(2000)
    run = run_lanes(command, np.zeros(2000), row, [model], Law(PERIOD, previous_target=False), trace=True)
    assert command[-1] - run.position[-1] == pytest.approx(speed * (1.0 - ahead) / kv, abs=1e-9)


@pytest.mark.parametrize("lag", [2e-3, 4e-3, 2e-2])
def test_gain_of_a_position_loop_around_a_lag_at_60_degrees(lag: float) -> None:
    """-90 deg of the integrator and -30 of the lag: w T = tan 30 deg, Kv = w sqrt(1 + (w T)^2)."""
    model, w = AxisModel(gain=0.3 / lag, damping=1.0 / lag, regulated=1.0 / lag), np.tan(np.radians(30.0)) / lag
    gains = np.array([[w * np.hypot(1.0, w * lag) * model.per_speed, *np.zeros(6)]])
    grid = w * np.geomspace(0.1, 10.0, 2000)
    found = margins(lambda w: loop_gain(gains, model, PERIOD, np.exp(1j * w * PERIOD))[0], grid, stable=True)
    assert np.degrees(found.phase + 0.5 * w * PERIOD) == pytest.approx(60.0, abs=0.3)  # the output is held


@pytest.mark.parametrize("share", [0.0, 0.5])
def test_margins_of_a_velocity_drive_are_where_its_runs_become_unstable(share: float) -> None:
    model = replace(DRIVE, friction=0.0, delay=1.4e-3, share=share, resonance=70.0 if share else 0.0, damping_ratio=0.03 if share else 0.0)
    row = np.array([[60.0, 300.0, 0.1, *np.zeros(4)]])
    limit = next(k for k in np.geomspace(0.2, 20.0, 300) if not robustly_stable(k * row, model, PERIOD))
    kick = np.r_[0.0, np.full(6000, 1e-3)]
    for factor, stays in ((0.94, True), (1.06, False)):
        ends = [
            run_lanes(kick, np.zeros(kick.size), factor * limit * row, [model.scaled(k)], Law(PERIOD, False)) for k in (0.75, 1.0, 1.25)
        ]
        assert bool(max(run.largest[0] for run in ends) < 0.02) is stays


def test_output_limit_holds() -> None:
    run = run_lanes(swept(), np.zeros(4000), ROW[None], [AXIS], Law(PERIOD, limit=0.05), trace=True)
    assert np.abs(run.command_output).max() == pytest.approx(0.05)
    assert run.limited[0] > 0.1


def loop_margins(model: AxisModel) -> Margins:
    w = np.geomspace(1e-3, 1.0, 4000) * np.pi / PERIOD
    return margins(lambda w: loop_gain(ROW[None], model, PERIOD, np.exp(1j * w * PERIOD))[0], w, stable=True)


def test_a_resonance_is_in_run_and_stability_alike() -> None:
    ringing = replace(AXIS, resonance=70.0, damping_ratio=0.01, share=0.5)
    limit = next(k for k in np.geomspace(0.05, 5.0, 200) if not robustly_stable(k * ROW[None], replace(ringing, gain=AXIS.gain), PERIOD))
    assert limit < 0.7 * next(k for k in np.geomspace(0.05, 5.0, 200) if not robustly_stable(k * ROW[None], AXIS, PERIOD))
    kick = np.r_[0.0, np.full(20000, 1e-3)]
    for share, stays in ((0.94, True), (1.06, False)):
        # Stable means stable with a quarter more gain.
        row = share * limit * np.where(np.arange(7) < 3, ROW, 0.0)
        worst = max(
            run_lanes(kick, np.zeros(kick.size), row[None], [replace(ringing, gain=k * AXIS.gain)], Law(PERIOD, False)).largest[0]
            for k in (0.75, 1.0, 1.25)
        )
        assert bool(worst < 0.02) is stays


def test_resonance_has_its_closed_form() -> None:
    ringing = replace(AXIS, damping=0.0, resonance=40.0, damping_ratio=0.05, share=0.7)
    n, u, w = np.arange(800), 0.1, 2.0 * np.pi * 40.0
    time, damped = PERIOD * n, w * np.sqrt(1.0 - 0.05**2)
    swing = 1.0 - np.exp(-0.05 * w * time) * (np.cos(damped * time) + 0.05 * w / damped * np.sin(damped * time))
    expected = AXIS.gain * u * (0.5 * time**2 + 0.7 / w**2 * swing)
    assert driven(np.full(n.size, u), [ringing], PERIOD)[0] == pytest.approx(expected, rel=1e-5, abs=1e-12)


def test_margins_are_where_the_loop_becomes_unstable() -> None:
    found = loop_margins(AXIS)
    unforced = np.where(np.arange(7) < 3, ROW, 0.0)
    for share, stays in ((0.97, True), (1.03, False)):
        model = replace(AXIS, gain=share * found.gain * AXIS.gain)
        run = run_lanes(np.r_[0.0, np.full(8000, 1e-3)], np.zeros(8001), unforced[None], [model], Law(PERIOD, False))
        assert bool(run.largest[0] < 0.1) is stays
    decibel, degrees = 20.0 * np.log10(found.gain), np.degrees(found.phase)
    rows = np.repeat(ROW[None], 3, axis=0)
    margins = [(decibel - 0.5, degrees - 2.0, True), (decibel + 0.5, degrees - 2.0, False), (decibel - 0.5, degrees + 2.0, False)]
    for gain_margin, phase_margin, kept in margins:
        assert keep_margins(rows, AXIS, PERIOD, gain_margin, phase_margin).tolist() == [kept] * 3


def test_stability_with_another_gain() -> None:
    limit = loop_margins(AXIS).gain
    assert robustly_stable(ROW[None], replace(AXIS, gain=0.79 * limit * AXIS.gain), PERIOD)
    assert not robustly_stable(ROW[None], replace(AXIS, gain=0.81 * limit * AXIS.gain), PERIOD)


def test_command_follows_the_position_while_the_control_is_off() -> None:
    noise = np.random.default_rng(1).uniform(-1e-6, 1e-6, 600)
    ahead = ROW.copy()
    ahead[GAINS.index("FF2")] = 1.3 / AXIS.gain
    runs = run_lanes(np.zeros(600), noise, np.array([ROW, ahead]), [AXIS], Law(PERIOD), free=300)
    assert runs.largest[0] < 1e-4
    assert runs.largest[1] > 100.0 * runs.largest[0]


def test_a_resonance_does_not_start_to_ring_while_the_control_is_off() -> None:
    pushed = replace(AXIS, resonance=45.0, damping_ratio=0.03, share=1.0, offset=-0.03)
    task = AxisTask(pushed, Law(PERIOD), [], always_enabled=True)
    points = np.random.default_rng(2).random((12, 5))
    points[:, 3:] = 0.5, 1.0  # nominal velocity feedforward, the most of acceleration
    for gains in task.gains(points):
        position = run_lanes(np.zeros(1000), np.zeros(1000), gains[None], [pushed], task.law, trace=True, free=1000).position
        assert np.abs(position).max() < 0.5 * 0.03 * 1.0**2  # one second of the push alone


def test_lanes_are_single_runs_and_one_that_diverges_is_infinite() -> None:
    gains = np.array([ROW, 0.5 * ROW, 1e3 * ROW])
    command = swept()
    together = run_lanes(command, np.zeros(command.size), gains, [AXIS], Law(PERIOD), trace=True)
    alone = [run_lanes(command, np.zeros(command.size), row[None], [AXIS], Law(PERIOD)).largest[0] for row in gains]
    assert together.largest == pytest.approx(alone) and np.isfinite(together.largest).tolist() == [True, True, False]
    assert np.isfinite(together.rough).all() and not np.isfinite(together.rms[2])


@pytest.mark.slow
@pytest.mark.parametrize("n", [1, 3])
@pytest.mark.parametrize("model", [AXIS, replace(AXIS, resonance=70.0, damping_ratio=0.05, share=0.5, behind=0.5, play=1e-5)])
def test_an_axis_sticks_as_in_plain_python(model: AxisModel, n: int, monkeypatch: pytest.MonkeyPatch) -> None:
    model = replace(model, gain=1.71, damping=7.43, friction=0.0292)
    output = 1.5 * model.friction / model.gain * np.sin(4.0 * np.pi * PERIOD * np.arange(2000))
    compiled = driven(output, [model] * n, PERIOD)
    monkeypatch.setattr(loop, "groups_of", lambda schedule, lanes, jit: groups_of(schedule, lanes, False))
    assert compiled == pytest.approx(driven(output, [model] * n, PERIOD), abs=1e-12)
