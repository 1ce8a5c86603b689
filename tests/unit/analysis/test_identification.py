"""An axis is found again from records that the compiled engine made of it, within the deviations that are told."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from contourlab.analysis.identification import SecondOrderFit, identify_delay, identify_gain, identify_second_order
from contourlab.analysis.second_order import held_response
from contourlab.components.drive.delayed_saturation import DelayedSaturation
from contourlab.components.friction.none import NoFriction
from contourlab.components.mechanics import link
from contourlab.components.plant.linear_motor import LinearMotor
from contourlab.components.plant.second_order_integrator import SecondOrderIntegrator
from contourlab.components.sensor.encoder import Encoder
from contourlab.engine.runner import make_group
from contourlab.engine.schedule import Late, Node, Schedule
from contourlab.engine.step import Port
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
PERIOD = 1e-3
FINE = 20
PULSE = 30
"""10 V for 30 ms, one sample of the paper's."""
PAPER = SecondOrderIntegrator(dc_gain=0.01, damping_ratio=1.1, natural_frequency=150.0)


def record(
    plant: Any, command: Array, *, noise: float = 25e-9, late: int = 0, stream: float = 1.0, loop_gain: float = 0.0
) -> tuple[Array, Array, Array, Array]:
    """Return time, encoder position, true velocity and the command that went to the drive: in open loop, or under a P controller.

    The plant runs on ticks of a twentieth of the servo period, so that a delay of `late` of these is exact.
    """
    tick = PERIOD / FINE
    sensor, drive = Encoder(resolution=25e-9, noise=noise, stream=stream), DelayedSaturation(delay=late * tick)
    step, block = link(plant, NoFriction()), plant.block(tick) | NoFriction().block(tick)
    nodes = (
        Node("sensor", sensor.make_step(), {"position": Late("plant.position")}, sensor.block(tick), {}, every=FINE),
        Node("control", _proportional(loop_gain), {"reference": "in.command", "position": "sensor.position"}, {}, {}, every=FINE),
        Node("drive", drive.make_step(), {"command": "control.command"}, drive.block(tick), {}, ring_length=drive.ring_length(tick)),
        Node("plant", step, {"command": "drive.applied", "load": 0.0}, block, {}),
    )
    schedule = Schedule(nodes, (Port("command"),), tick, 3)
    rows = [schedule.row(name) for name in ("sensor.position", "plant.velocity", "control.command")]
    log = make_group(schedule, 1, slice(0, 1), True).run(np.repeat(command, FINE)[:, None], rows)[::FINE, :, 0]
    return PERIOD * np.arange(command.size), log[:, 0], log[:, 1], log[:, 2]


def _proportional(loop_gain: float) -> Any:
    from contourlab.engine.step import Step

    def open_loop(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.reference,)

    def closed(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (loop_gain * (inp.reference - inp.position),)

    return Step("control", closed if loop_gain else open_loop, (), (), "", (), (Port("reference"), Port("position")), (Port("command"),))


def pulse(n: int = 400, volts: float = 10.0) -> Array:
    command = np.zeros(n)
    command[20 : 20 + PULSE] = volts
    return command


def deviations(found: SecondOrderFit, **true: float) -> Array:
    """Return how many standard deviations each number is off."""
    return np.array([abs(getattr(found, name) - value) / getattr(found, f"{name}_deviation") for name, value in true.items()])


@settings(max_examples=25, deadline=None)
@given(stream=st.integers(1, 10**6), gain=st.floats(1e-3, 0.2), zeta=st.floats(1.02, 3.0), wn=st.floats(60.0, 400.0))
def test_zeta_and_omega_n_come_back_from_a_pulse(stream: int, gain: float, zeta: float, wn: float) -> None:
    plant = SecondOrderIntegrator(dc_gain=gain, damping_ratio=zeta, natural_frequency=wn)
    time, position, _, command = record(plant, pulse(), stream=float(stream))
    found = identify_second_order(time, position, command, of="position")
    # Of normal numbers one in 15 million is beyond 5.4 deviations.
    assert deviations(found, dc_gain=gain, damping_ratio=zeta, natural_frequency=wn).max() < 5.4
    # Normal noise of 25 nm and whole counts of 25 nm: variances add.
    assert found.noise == pytest.approx(25e-9 * np.sqrt(1.0 + 1.0 / 12.0), rel=0.2)


def test_the_deviations_are_those_of_repeated_trials() -> None:
    time, _, _, command = record(PAPER, pulse())
    clean = 0.01 * held_response(command, PERIOD, 1.1, 150.0, of="position")
    rng, off = np.random.default_rng(3), []
    for _ in range(60):
        found = identify_second_order(time, clean + rng.normal(0.0, 25e-9, clean.size), command, of="position")
        off.append(
            [
                (found.damping_ratio - 1.1) / found.damping_ratio_deviation,
                (found.natural_frequency - 150.0) / found.natural_frequency_deviation,
                (found.dc_gain - 0.01) / found.dc_gain_deviation,
            ]
        )
    spread = np.std(off, axis=0)
    # The standard deviation of 60 numbers is known to 1/sqrt(120) = 9 %: four of these.
    assert spread == pytest.approx(1.0, abs=0.37)


@pytest.mark.parametrize("zeta", [0.1, 0.7, 1.0, 1.1, 4.0])
@pytest.mark.parametrize("of", ["position", "velocity"])
def test_any_damping_is_found_from_any_record(zeta: float, of: str) -> None:
    plant = PAPER.replace(damping_ratio=zeta)
    time, position, velocity, command = record(plant, pulse(), noise=0.0)
    found = identify_second_order(time, position if of == "position" else velocity, command, of=of)
    assert found.damping_ratio == pytest.approx(zeta, rel=2e-3)
    assert found.natural_frequency == pytest.approx(150.0, rel=2e-3)
    assert found.dc_gain == pytest.approx(0.01, rel=2e-3)
    assert found.fit > 99.9


def test_a_linear_motor_is_seen_as_what_equation_3_makes_of_it() -> None:
    """Equations (3) and (4) side by side: wn^2 = (R b + K_b K_f)/(L m), 2 zeta wn = (R m + b L)/(L m), G = K_amp K_f/(R b + K_b K_f)."""
    r, inductance, back, force, mass, b, amp = 4.0, 0.015, 20.0, 22.0, 1.5, 30.0, 2.0
    motor = LinearMotor(
        resistance=r, inductance=inductance, back_emf=back, force_constant=force, mass=mass, viscous_friction=b, amplifier_gain=amp
    )
    time, position, _, command = record(motor, pulse(), noise=25e-9)
    found = identify_second_order(time, position, command, of="position")
    stiffness = r * b + back * force
    wn = np.sqrt(stiffness / (inductance * mass))
    true = {
        "dc_gain": amp * force / stiffness,
        "natural_frequency": float(wn),
        "damping_ratio": (r * mass + b * inductance) / (inductance * mass) / (2.0 * wn),
    }
    assert deviations(found, **true).max() < 5.0


@settings(max_examples=8, deadline=None)
@given(late=st.integers(0, 600), stream=st.integers(1, 10**6))
def test_a_delay_is_found_with_the_rest_to_a_fraction_of_a_sample(late: int, stream: int) -> None:
    time, position, _, command = record(PAPER, pulse(), stream=float(stream), late=late)
    found = identify_second_order(time, position, command, of="position", delay=None)
    # No delay is shorter than none, so that near zero the others are not spread normally.
    if late > 0:
        assert deviations(found, damping_ratio=1.1, natural_frequency=150.0, delay=late * PERIOD / FINE).max() < 5.4
    assert found.delay == pytest.approx(late * PERIOD / FINE, abs=0.005 * PERIOD)


@settings(max_examples=15, deadline=None)
@given(late=st.integers(0, 600), closed=st.booleans())
def test_the_delay_of_a_known_axis_in_open_and_closed_loop(late: int, closed: bool) -> None:
    step = np.where(np.arange(600) >= 20, 1e-3 if closed else 2.0, 0.0)
    time, position, _, command = record(PAPER, step, late=late, loop_gain=1000.0 if closed else 0.0)
    found = identify_delay(time, position, command, damping_ratio=1.1, natural_frequency=150.0, of="position")
    assert abs(found.value - late * PERIOD / FINE) < 5.4 * found.deviation < 0.01 * PERIOD
    assert found.fit > 99.0


@given(gain=st.floats(1e-3, 1.0), volts=st.floats(0.5, 10.0), way=st.sampled_from([-1.0, 1.0]), seed=st.integers(0, 99))
def test_the_gain_is_that_of_the_settled_part(gain: float, volts: float, way: float, seed: int) -> None:
    command = np.where(np.arange(600) >= 30, way * volts, 0.0)
    velocity = gain * held_response(command, PERIOD, 1.1, 150.0) + np.random.default_rng(seed).normal(0.0, 1e-5, 600)
    found = identify_gain(PERIOD * np.arange(600), velocity, command)
    assert abs(found.value - gain) < 5.4 * found.deviation
    # 285 samples settled.
    assert found.deviation == pytest.approx(1e-5 / np.sqrt(285.0) / volts, rel=0.25)


# --- records that tell nothing -------------------------------------------------------------------------------------------------------

N = 400
TIME = PERIOD * np.arange(N)
CLEAN = 0.01 * held_response(pulse(N), PERIOD, 1.1, 150.0)
STEP = np.where(np.arange(N) >= 20, 5.0, 0.0)


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"time": TIME[:8], "velocity": CLEAN[:8], "command": pulse(N)[:8]}, "8 samples: must be a record of at least 12"),
        ({"time": TIME**2}, "evenly spaced"),
        ({"time": TIME[::-1]}, "rising"),
        ({"velocity": CLEAN[:-1]}, "as long as time"),
        ({"velocity": np.where(np.arange(N) == 7, np.nan, CLEAN)}, "nan at sample 7: must be finite"),
        ({"command": np.where(np.arange(N) == 9, np.inf, pulse(N))}, "command = inf at sample 9"),
        ({"command": np.zeros(N)}, "in which the axis is moved"),
        ({"velocity": np.zeros(N)}, "in which the axis answers"),
        ({"velocity": np.random.default_rng(0).normal(size=N)}, "lost in the noise"),
        ({"velocity": -CLEAN}, "other direction"),
        ({"of": "current"}, "'velocity', 'position'"),
        ({"delay": -1.0}, ">= 0"),
        ({"delay": None, "longest_delay": 9.0}, "below the record's"),
    ],
)
def test_a_record_that_does_not_hold_an_axis_is_refused_in_words(changed: dict[str, Any], words: str) -> None:
    arguments: dict[str, Any] = {"time": TIME, "velocity": CLEAN, "command": pulse(N), **changed}
    with pytest.raises(ParameterError, match=words):
        identify_second_order(**arguments)


@pytest.mark.parametrize(
    ("velocity", "command", "words"),
    [
        (0.01 * held_response(STEP, PERIOD, 1.1, 4.0), STEP, "settled at its end"),
        (-0.01 * held_response(STEP, PERIOD, 1.1, 150.0), STEP, "rising with the command"),
        (np.random.default_rng(0).normal(size=N), STEP, "no response"),
        (CLEAN, pulse(N), "constant and not zero over the last half"),
        (CLEAN, np.where(np.arange(N) > 300, 1.0, 0.0), "constant and not zero over the last half"),
    ],
)
def test_a_step_that_tells_no_gain_is_refused_in_words(velocity: Array, command: Array, words: str) -> None:
    with pytest.raises(ParameterError, match=words):
        identify_gain(TIME, velocity, command)


def test_a_delay_beyond_where_it_is_looked_for_is_refused() -> None:
    late = 0.01 * held_response(STEP, PERIOD, 1.1, 150.0, 0.05)
    with pytest.raises(ParameterError, match="longest_delay"):
        identify_delay(TIME, late, STEP, damping_ratio=1.1, natural_frequency=150.0, longest_delay=0.02)
    with pytest.raises(ParameterError, match="damping_ratio"):
        identify_delay(TIME, late, STEP, damping_ratio=0.0, natural_frequency=150.0)


def test_an_axis_faster_than_the_samples_is_refused() -> None:
    """One sample after the step all is over: the record tells a gain and no dynamics."""
    with pytest.raises(ParameterError, match="no motion faster than its samples"):
        identify_second_order(TIME, 0.01 * held_response(STEP, PERIOD, 1.1, 1e5), STEP)
