"""Stepper and step drive: against data-sheet formulas, an independent solver, and pulses one by one."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from component_rig import make, run_alone
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from refusals import refuses
from scipy.integrate import solve_ivp
from stepper_rig import PERIOD, SCREW, force_of, march, mass_of, solved, stepper

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.controller.steps import Steps
from contourlab.components.drive.saturation import DelayedSaturation, Saturation
from contourlab.components.drive.step_generator import StepGenerator
from contourlab.components.friction.laws import Coulomb, LuGre, NoFriction
from contourlab.components.mechanics.following import mean_count
from contourlab.components.plant.plant import BallScrew
from contourlab.components.plant.stepper import StepDrive
from contourlab.errors import ComponentError, ParameterError
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.loop.simulate import simulate

Array = NDArray[np.float64]
FULL = SCREW["lead"] / 200.0
HOLDING = SCREW["holding_torque"] * SCREW["efficiency"] * 2.0 * math.pi / SCREW["lead"]
LIMITS = cl.Limits(velocity=0.1, acceleration=1.0, jerk=50.0)


# --- at rest ---


@pytest.mark.parametrize("share", [-0.9, -0.3, 0.1, 0.6, 0.97])
def test_a_load_moves_the_axis_along_the_sine_of_torque_over_angle(share: float) -> None:
    off = 2.0 * FULL / math.pi * math.asin(share)
    # A load that comes at once would carry the axis beyond.
    settled = march(stepper(damping_ratio=0.7), np.zeros(400), load=share * HOLDING, start=(0.9 * off, 0.0, 0.0, 0.0))[-1]
    assert settled[0] == pytest.approx(off, rel=1e-6)
    assert settled[1] == pytest.approx(0.0, abs=1e-9)


def test_it_holds_a_load_below_the_holding_torque_and_no_larger_one() -> None:
    slow = stepper(damping_ratio=1.0)
    start = (0.99 * FULL, 0.0, 0.0, 0.0)  # near the place of the largest torque, so that it does not overshoot
    assert march(slow, np.zeros(400), load=0.999 * HOLDING, start=start)[-1, 0] < FULL
    assert march(slow, np.zeros(400), load=1.001 * HOLDING, start=start)[-1, 0] > 4.0 * FULL


@pytest.mark.parametrize(("rotor", "torque", "teeth"), [(5.7e-5, 1.26, 50), (3e-6, 0.3, 100)])
def test_a_bare_motor_oscillates_at_the_frequency_of_its_data_sheet(rotor: float, torque: float, teeth: int) -> None:
    """w = sqrt(N T_h/J) with N teeth of the rotor: a step is a quarter of a tooth."""
    bare = stepper(mass=1e-6, inertia=rotor, holding_torque=torque, full_steps=4.0 * teeth, efficiency=1.0, damping_ratio=0.05)
    wanted, dt = math.sqrt(teeth * torque / rotor), 2e-5
    count = 1e-4 * bare.full_step
    p = march(bare, np.zeros(3000), start=(count, 0.0, 0.0, 0.0), substeps=4, period=dt)[:, 0]
    peaks = np.flatnonzero((p[1:-1] > p[:-2]) & (p[1:-1] >= p[2:])) + 1
    peaks = peaks[p[peaks] > 0.0]
    fine = peaks + 0.5 * (p[peaks - 1] - p[peaks + 1]) / (p[peaks - 1] - 2.0 * p[peaks] + p[peaks + 1])
    damped = 2.0 * math.pi / (np.diff(fine).mean() * dt)
    decrement = np.log(p[peaks[0]] / p[peaks[4]]) / 4.0
    assert damped == pytest.approx(wanted * math.sqrt(1.0 - 0.05**2), rel=1e-3)
    assert decrement / math.hypot(2.0 * math.pi, decrement) == pytest.approx(0.05, rel=1e-3)


# --- slip ---


@pytest.mark.parametrize(("steps", "lost"), [(1.9, 0), (2.1, 4), (5.9, 4), (6.1, 8), (-2.1, -4)])
def test_a_rotor_beyond_two_full_steps_settles_a_multiple_of_four_off(steps: float, lost: int) -> None:
    settled = march(stepper(damping_ratio=0.7), np.zeros(1500), start=(steps * FULL, 0.0, 0.0, 0.0))[-1, 0]
    assert settled == pytest.approx(lost * FULL, abs=1e-9)


@pytest.mark.parametrize(("share", "holds"), [(0.98, True), (1.02, False)])
def test_it_follows_an_acceleration_up_to_the_force_over_the_mass(share: float, holds: bool) -> None:
    motor = stepper(damping_ratio=0.7, mass=2000.0)  # with 1 m/s^2 the count, straight within a period, is 0.1 um from the motion
    t = np.arange(1, 801) * PERIOD
    most, ease = share * HOLDING / mass_of(motor), 0.2
    x = np.where(t < ease, most * t**3 / (6.0 * ease), most * ((t - ease) ** 2 / 2.0 + ease * (t - ease) / 2.0 + ease**2 / 6.0))
    off = x - march(motor, x)[1:, 0]
    assert (np.abs(off).max() < 1.1 * FULL) == holds
    assert (np.abs(off[-1]) > 4.0 * FULL) != holds


@pytest.mark.parametrize(("share", "holds"), [(0.99, True), (1.01, False)])
def test_beyond_its_corner_speed_it_pulls_out_at_the_current_that_the_winding_takes(share: float, holds: bool) -> None:
    motor, speed = stepper(damping_ratio=1.0, corner_speed=0.1), 0.3
    left = HOLDING / math.hypot(1.0, 3.0)
    t = np.arange(1, 1001) * PERIOD
    start = (-0.99 * FULL, speed, 0.0, 0.0)
    off = speed * t - march(motor, speed * t, load=-share * left, start=start)[1:, 0]
    assert (np.abs(off).max() < 1.1 * FULL) == holds


def out_and_back(motor: Any, coulomb: float, share: float, time: float = 0.04) -> tuple[Array, Any]:
    """Return positions at ticks of a motion there and back, near pull-out; and the count between them, with its speed."""
    w, most = 2.0 * math.pi / time, share * (HOLDING - coulomb) / mass_of(motor)
    t = np.arange(round(2.0 * time / PERIOD) + 21) * PERIOD
    phase = np.clip(t, 0.0, time), np.clip(t - time, 0.0, time)
    there, back = (most / w * s - most / w**2 * np.sin(w * s) for s in phase)
    x = there - back

    def count(t: float) -> tuple[float, float]:
        k = min(int(t / PERIOD + 1e-9), x.size - 2)
        rate = (x[k + 1] - x[k]) / PERIOD
        return x[k] + (t - k * PERIOD) * rate, rate

    return x, count


@pytest.mark.parametrize("corner_speed", [math.inf, 0.2])
def test_near_pull_out_it_moves_as_an_independent_solver_says(corner_speed: float) -> None:
    motor, coulomb = stepper(corner_speed=corner_speed, damping=40.0), 60.0
    x, count = out_and_back(motor, coulomb, 0.8 if corner_speed < 1.0 else 0.93)
    exact = solved(motor, count, coulomb, np.arange(x.size) * PERIOD)
    assert np.abs(x - exact[:, 0]).max() > 0.5 * FULL
    errors = [np.abs(march(motor, x[1:], friction=Coulomb(coulomb=coulomb), substeps=n)[:, 0] - exact[:, 0]).max() for n in (5, 10, 20, 40)]
    assert errors[0] < 0.01 * np.abs(x - exact[:, 0]).max()
    orders = -np.diff(np.log2(errors))
    assert (np.abs(orders - 2.0) < 0.3).all()


@pytest.mark.slow
def test_with_bristles_too_it_moves_as_an_independent_solver_says() -> None:
    motor, level, bristle, inner = stepper(), 60.0, 2e7, 1e3
    x, count = out_and_back(motor, level, 0.9)

    def right_side(t: float, y: Array) -> list[float]:
        c, rate = count(t)
        slip = y[1] - bristle * abs(y[1]) * y[2] / level
        push = force_of(motor, c - y[0], rate, y[1]) - bristle * y[2] - inner * slip
        return [y[1], push / mass_of(motor), slip]

    t, y, exact = 0.0, np.zeros(3), [0.0]
    for k in range(x.size - 1):  # the count bends at each tick
        run = solve_ivp(right_side, (t, t + PERIOD * (1.0 - 1e-12)), y, "Radau", rtol=1e-9, atol=1e-13)
        t, y = (k + 1) * PERIOD, run.y[:, -1]
        exact.append(y[0])
    law = LuGre(coulomb=level, breakaway=level, stiffness=bristle, bristle_damping=inner)
    errors = [np.abs(march(motor, x[1:], friction=law, substeps=n)[:, 0] - exact).max() for n in (5, 10, 20, 40)]
    assert errors[0] < 0.02 * np.abs(x - exact).max()
    assert (-np.diff(np.log2(errors)) > 1.5).all()


# --- pulses ---


@given(first=st.floats(-50.0, 50.0), length=st.floats(-20.0, 20.0), step=st.floats(0.1, 3.0))
def test_the_mean_count_is_that_of_a_staircase(first: float, length: float, step: float) -> None:
    n = 4000
    middles = first + length * (np.arange(n) + 0.5) / n
    brute = float((step * np.rint(middles / step)).mean())
    assert mean_count(step, first, first + length) == pytest.approx(brute, abs=step * 3.0 / n * (1.0 + abs(length) / step))


@given(first=st.floats(-1e6, 1e6), length=st.floats(-1e-9, 1e-9))
def test_the_mean_of_a_short_stretch_lies_between_its_ends(first: float, length: float) -> None:
    ends = np.rint(first), np.rint(first + length)
    assert min(ends) - 1e-6 <= mean_count(1.0, first, first + length) <= max(ends) + 1e-6


@pytest.mark.parametrize("speed", [0.47e-3, 2.7e-3, 12.2e-3])
def test_pulses_shake_the_rotor_as_they_do_one_by_one(speed: float) -> None:
    """At 0.47 mm/s a pulse comes with each oscillation of the rotor; at the other speeds a count rounded once in a period would beat."""
    motor = stepper(microsteps=8.0, damping_ratio=0.05)
    pulse, w, fine = FULL / 8.0, math.sqrt(HOLDING * math.pi / (2.0 * FULL) / mass_of(motor)), 100
    n, h = 500, PERIOD / fine
    p, v, each = 0.0, 0.0, np.empty(n + 1)
    each[0] = 0.0
    counts = pulse * np.rint(speed * (np.arange(n * fine) + 0.5) * h / pulse)
    for k, count in enumerate(counts.tolist()):
        middle = p + 0.5 * h * v
        v += h * (HOLDING * math.sin(math.pi / (2.0 * FULL) * (count - middle)) / mass_of(motor) + 0.1 * w * (speed - v))
        p = middle + 0.5 * h * v
        if k % fine == fine - 1:
            each[k // fine + 1] = p
    moved = march(motor, speed * np.arange(1, n + 1) * PERIOD, substeps=8)[:, 0]
    assert np.abs(moved - each).max() < 0.12 * pulse
    rounded = pulse * np.rint(speed * np.arange(1, n + 1) * PERIOD / pulse)
    assert speed < 1e-3 or np.abs(march(motor.linear(), rounded, substeps=8)[:, 0] - each).max() > 0.6 * pulse


def test_it_rests_at_a_whole_step() -> None:
    motor = stepper(microsteps=4.0)
    inside, outside = motor.at_rest(0.3 * FULL)
    assert inside == {"position": 0.25 * FULL, "count": 0.3 * FULL}
    assert outside == {"position": 0.25 * FULL}
    assert stepper().at_rest(0.3 * FULL)[1] == {"position": 0.3 * FULL}


# --- the drive with a loop of its own ---


def test_a_step_drive_lags_at_a_constant_speed_by_its_time_and_by_its_load() -> None:
    drive = StepDrive(natural_frequency=40.0, damping_ratio=0.7, velocity_feedforward=0.25, load_stiffness=2e7)
    t, speed, load = np.arange(1, 1001) * PERIOD, 0.05, 300.0
    off = speed * t[-1] - march(drive, speed * t, load=load)[-1, 0]
    assert off == pytest.approx(speed * 2.0 * 0.7 * 0.75 / (2.0 * math.pi * 40.0) - load / 2e7, rel=1e-6)


@pytest.mark.parametrize("feedforward", [0.0, 0.6, 1.0])
def test_a_step_drive_has_the_response_of_its_second_order_lag(feedforward: float) -> None:
    drive = StepDrive(natural_frequency=25.0, damping_ratio=0.6, velocity_feedforward=feedforward)
    w, s = 2.0 * math.pi * 25.0, 2j * math.pi * 20.0
    response = (2.0 * 0.6 * w * feedforward * s + w * w) / (s * s + 2.0 * 0.6 * w * s + w * w)
    t = np.arange(1, 2001) * 1e-4
    moved = march(drive, 1e-3 * np.sin(2.0 * math.pi * 20.0 * t), period=1e-4)[1:, 0]
    tail = t > 0.15
    basis = np.stack([np.sin(2.0 * math.pi * 20.0 * t[tail]), np.cos(2.0 * math.pi * 20.0 * t[tail])], axis=1)
    in_phase, quadrature = np.linalg.lstsq(basis, moved[tail], rcond=None)[0] / 1e-3
    assert complex(in_phase, quadrature) == pytest.approx(response, rel=2e-3)


# --- step generator and controller ---


def test_a_step_generator_without_limits_ends_each_period_at_the_command() -> None:
    t = np.arange(400) * PERIOD
    x = 1e-3 * (1.0 - np.cos(40.0 * t))
    count = run_alone(StepGenerator(), {"command": x})["applied"]
    assert np.abs(count - x).max() < 1e-15
    # Far from a limit it is ahead by half of a T^2: 0.8 um here.
    bend = np.gradient(np.gradient(x, PERIOD), PERIOD)
    count = run_alone(StepGenerator(acceleration_limit=20.0), {"command": x})["applied"]
    assert np.abs(count - x - 0.5 * bend * PERIOD**2)[20:-2].max() < 0.1e-6


@pytest.mark.parametrize(("velocity", "acceleration"), [(math.inf, 0.5), (0.02, math.inf), (0.02, 0.5)])
def test_a_step_generator_keeps_its_limits_lags_and_arrives(velocity: float, acceleration: float) -> None:
    t = np.arange(1500) * PERIOD
    x = np.where(t < 0.05, 0.5 * t**2, np.where(t < 0.15, 0.00125 + 0.05 * (t - 0.05), 0.00625))  # 1 m/s^2 to 50 mm/s, and a sudden stop
    count = run_alone(StepGenerator(velocity_limit=velocity, acceleration_limit=acceleration), {"command": x})["applied"]
    rate = np.diff(count) / PERIOD
    assert np.abs(rate).max() <= velocity * (1.0 + 1e-9)
    assert np.abs(np.diff(rate)).max() <= acceleration * PERIOD * (1.0 + 1e-9) + 1e-12
    assert np.abs(count - x).max() > 0.1e-3
    assert count[-200:] == pytest.approx(0.00625, abs=1e-6)


def test_limits_above_those_of_the_motion_change_nothing() -> None:
    t = np.arange(600) * PERIOD
    x = 5e-3 * (1.0 - np.cos(10.0 * t))  # up to 0.5 m/s^2, and 50 mm/s
    limits = {"acceleration_limit": 0.7, "velocity_limit": 0.06}
    free, limited = (run_alone(StepGenerator(**given), {"command": x})["applied"] for given in ({}, limits))
    assert np.abs(limited - free).max() < 0.5e-6  # a T^2/2


def test_an_age_is_a_time_that_the_command_is_late() -> None:
    t = np.arange(200) * PERIOD
    fed = {"reference": np.sin(5.0 * t), "reference_velocity": 5.0 * np.cos(5.0 * t)}
    assert run_alone(Steps(age=0.5), fed)["command"] == pytest.approx(np.sin(5.0 * (t - 0.5 * PERIOD)), abs=0.5 * (2.5 * PERIOD) ** 2)
    assert run_alone(Steps(), fed)["command"].tolist() == fed["reference"].tolist()


# --- in a machine ---


def machine(**changes: Any) -> Machine:
    axis = Axis("x", stepper(microsteps=8.0), Coulomb(coulomb=30.0, breakaway=40.0), StepGenerator(), limits=LIMITS, substeps=5)
    return Machine("router", (replace(axis, **changes), replace(axis, **changes, name="y")), PERIOD)


def steered(law: Any = None) -> Controller:
    return Controller(dict.fromkeys("xy", AxisController(controller=law or Steps())))


def circle(n_lap: int = 1) -> Any:
    return cl.uniform(contour("circle", radius=0.01), 1.0, n_lap, PERIOD)


def test_compiled_code_moves_it_as_plain_python_does() -> None:
    run = {jit: simulate(machine(), steered(), circle(), jit=jit) for jit in (True, False)}
    for name in ("axis_position", "axis_velocity", "applied_command"):
        assert np.abs(run[True][name] - run[False][name]).max() <= 1e-9 * np.abs(run[False][name]).max()


def test_lanes_move_it_as_a_run_of_its_own_does() -> None:
    torque = np.linspace(0.5, 1.9, 18)
    given = {"axes.x.plant.holding_torque": torque}
    together = cl.simulate_batch(machine(), steered(), circle(), given, keep=("axis_position",)).signals["axis_position"]
    for k in (0, 7, 17):
        alone = cl.simulate_batch(
            machine(), steered(), circle(), {"axes.x.plant.holding_torque": torque[k : k + 1]}, keep=("axis_position",)
        )
        assert np.array_equal(together[:, :, k], alone.signals["axis_position"][:, :, 0])
        single = simulate(machine(), steered(), circle(), {"axes.x.plant.holding_torque": float(torque[k])})
        assert np.abs(together[:, :, k] - single["axis_position"]).max() < 1e-12


def test_in_lanes_each_rests_at_its_own_whole_step() -> None:
    path = cl.uniform(contour("circle", radius=0.0100037), 0.1, 1, PERIOD)
    given = {"axes.x.plant.microsteps": np.array([1.0, 2.0, 8.0])}
    first = cl.simulate_batch(machine(), steered(), path, given, keep=("axis_position",)).signals["axis_position"][0, 0]
    assert first == pytest.approx([0.01, 0.01, 0.010003125], abs=1e-12)


def test_a_start_in_motion_goes_on_as_if_it_had_run_before() -> None:
    limited = {"drive": StepGenerator(acceleration_limit=2.0), "plant": stepper(microsteps=0.0), "friction": NoFriction()}
    before, moving = (simulate(machine(**limited), steered(Steps(age=0.5)), circle(2), moving=flag) for flag in (False, True))
    count = before["applied_command"]
    assert np.abs(moving["applied_command"][:1000] - count[1000:]).max() < 1e-6
    off = moving["applied_command"][:-1] - moving["axis_position"][1:]
    assert np.abs(off).max() < 0.1 * FULL


def test_it_begins_where_the_path_does_also_behind_a_filter() -> None:
    filtered = replace(AxisController(controller=Steps(age=0.5)), filters=(("shaper", make("filter", "notch", frequency=180.0)),))
    run = simulate(machine(), Controller(dict.fromkeys("xy", filtered)), circle())
    assert np.abs(run["axis_position"][0] - run["reference"][0]).max() <= 0.5 * FULL / 8.0
    assert np.abs(run["axis_position"][:5] - run["reference"][:5]).max() < 2e-3 * 2.0 * math.pi * 0.01 * 2.5


@pytest.mark.parametrize(
    ("name", "parts"),
    [
        ("axes.x.drive", {"drive": DelayedSaturation(delay=1e-3)}),
        ("axes.x.drive", {"drive": Saturation(limit=0.1)}),
        ("axes.x.drive", {"plant": BallScrew(mass=8.0, inertia=6e-5, lead=5e-3, torque_constant=0.5)}),
        ("axes.x.substeps", {"substeps": 4}),
    ],
)
def test_a_machine_refuses_what_does_not_fit(name: str, parts: dict[str, Any]) -> None:
    with refuses(ParameterError, name=name):
        machine(**parts)


def test_a_loop_over_positions_and_positions_to_a_loop_are_refused() -> None:
    screw = BallScrew(mass=8.0, inertia=6e-5, lead=5e-3, torque_constant=0.5)
    cascade = make("controller", "cascade", position_gain=40.0, velocity_gain=500.0)
    for made, law in ((machine(), cascade), (machine(plant=screw, drive=Saturation()), Steps())):
        with refuses(ParameterError, name="controller.axes.x.controller"):
            simulate(made, steered(law), circle())


def test_there_are_no_gains_to_find() -> None:
    with pytest.raises(ComponentError):
        stepper().rigid_model()
    with pytest.raises(ComponentError):
        sampled_loop(machine().axes[0], AxisController(controller=Steps()), PERIOD)


def test_the_linear_model_has_the_stiffness_of_the_motor() -> None:
    model = stepper().linearize()
    assert model is not None
    at_rest = -model.c[0] @ np.linalg.solve(model.a, model.b)
    assert at_rest == pytest.approx([1.0, 1e-9 / force_of(stepper(), 1e-9, 0.0)], rel=1e-6)
