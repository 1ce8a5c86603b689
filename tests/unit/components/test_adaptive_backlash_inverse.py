"""The backlash gap learnt during motion: its final value, its rate, and the conditions under which learning stops."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from refusals import refuses

from contourlab.components.compensation.backlash import AdaptiveBacklashInverse
from contourlab.engine.step import record
from contourlab.errors import ParameterError
from contourlab.primitives import Clock

PERIOD = 1e-3


class Stepped:
    """A component in plain Python, stepped tick by tick, with visible states."""

    def __init__(self, **parameters: float) -> None:
        self.part = AdaptiveBacklashInverse(**parameters)
        values = self.part.block(PERIOD)
        self.par = record(tuple(values))(*values.values())
        self.names = tuple(port.name for port in self.part.states)
        self.inputs = record(tuple(port.name for port in self.part.inputs))
        self.x: Any = record(self.names)(*(0.0,) * len(self.names))
        self.k = 0

    def tick(self, velocity: float, motor: float, load: float, acceleration: float = 0.0) -> float:
        clock = Clock(float(self.k), self.k * PERIOD, PERIOD)
        states, (shift,) = self.part.step(self.par, self.x, self.inputs(velocity, acceleration, motor, load), clock)
        self.x, self.k = record(self.names)(*states), self.k + 1
        return float(shift)

    @property
    def gap(self) -> float:
        return float(self.x.right - self.x.left) if self.x.known else float(self.part.backlash_gap)


@dataclass
class Drive:
    """Motor with position and velocity feedback, a spring with a gap, and a load with friction."""

    gap: float
    motor_mass: float = 30.0
    load_mass: float = 20.0
    stiffness: float = 2e7
    damping: float = 4e3
    coulomb: float = 25.0
    viscous: float = 150.0
    bandwidth: float = 2000.0
    state: list[float] = field(default_factory=lambda: [0.0] * 4)

    def windup(self, speed: float) -> float:
        return (self.coulomb + self.viscous * speed) / self.stiffness

    def move(self, asked: float, asked_speed: float, substeps: int = 25) -> None:
        xm, vm, xl, vl = self.state
        h, w = PERIOD / substeps, self.bandwidth
        for i in range(substeps):
            apart = xm - xl
            beyond = apart - min(max(apart, -0.5 * self.gap), 0.5 * self.gap)
            force = (self.stiffness * beyond + self.damping * (vm - vl)) if beyond != 0.0 else 0.0
            force = max(force, 0.0) if beyond > 0.0 else min(force, 0.0)
            drive = self.motor_mass * (w * w * (asked + i * h * asked_speed - xm) + 1.4 * w * (asked_speed - vm))
            rub = self.coulomb * math.tanh(vl / 1e-4) + self.viscous * vl
            vm += h * (drive - force) / self.motor_mass
            vl += h * (force - rub) / self.load_mass
            xm += h * vm
            xl += h * vl
        self.state = [xm, vm, xl, vl]


LEARNING = {"largest_gap": 150e-6, "adaptation_time": 0.2, "dead_zone": 1e-7, "learning_velocity": 5e-3, "jump_velocity": 5e-3}


def back_and_forth(k: int) -> tuple[float, float, float]:
    """Return position, velocity and acceleration of 5 mm at 0.5 Hz."""
    w, r = math.pi, 5e-3
    t = k * PERIOD
    return r * (1.0 - math.cos(w * t)), r * w * math.sin(w * t), r * w * w * math.cos(w * t)


@pytest.mark.parametrize(("gap", "guess"), [(40e-6, 0.0), (15e-6, 60e-6)])
def test_it_learns_the_gap_of_a_drive_with_inertia_and_friction_and_keeps_it_at_rest(gap: float, guess: float) -> None:
    """Encoder counts of 0.1 um; scales 3 mm apart. Finally the load follows the reference, then rests."""
    drive, learner = Drive(gap), Stepped(backlash_gap=guess, **LEARNING)
    shift, late, count = 0.0, [], 1e-7
    for k in range(10_000):
        position, velocity, acceleration = back_and_forth(k)
        drive.move(position + shift, velocity)
        motor, load = (count * round(x / count) for x in (drive.state[0], drive.state[2] - 3e-3))
        shift = learner.tick(velocity, motor, load, acceleration)
        # Far from the reversals: the ramp is complete and friction is steady.
        if k > 8000 and abs(velocity) > 8e-3:
            late.append(drive.state[2] - back_and_forth(k + 1)[0])
    lost = gap + 2.0 * drive.windup(0.7 * 5e-3 * math.pi)
    assert learner.gap == pytest.approx(lost, abs=2.0 * 1e-7 + count + 2.0 * drive.windup(0.3 * 5e-3 * math.pi) - 2.0 * drive.windup(0.0))
    # Both sides together: 0.5 um because the motor yields to friction, 0.3 um of dead zones and counts,
    # 0.2 um of windup that varies with speed and acceleration.
    assert np.ptp(late) < 1e-6
    learnt = learner.gap
    for k in range(3000):
        drift = 5e-6 * k / 3000.0
        learner.tick(0.0, motor, load + drift + 2e-7 * math.sin(7.0 * k))
    assert learner.gap == learnt


@given(gap=st.floats(2e-6, 140e-6), apart=st.floats(-1.0, 1.0), time=st.floats(0.02, 1.0), start=st.floats(-0.5, 0.5))
def test_each_side_converges_with_its_time_constant(gap: float, apart: float, time: float, start: float) -> None:
    """With a moving load in play, forwards sets the first reading; backwards follows e = (gap - guess) exp(-t/T) in learning ticks.

    The initial place in the gap does not matter: nothing is learnt before contact is certain.
    """
    learner = Stepped(**{**LEARNING, "adaptation_time": time, "dead_zone": 0.0, "backlash_gap": 70e-6, "settling_time": 0.01})
    motor, load, gaps = 0.0, start * gap, []
    for k in range(300):
        velocity = 0.02 if k < 150 else -0.02
        motor += velocity * PERIOD
        load = min(max(load, motor - 0.5 * gap), motor + 0.5 * gap)
        learner.tick(velocity, motor, load - apart)
        gaps.append(learner.gap)
    assert gaps[149] == pytest.approx(70e-6, abs=1e-15)
    # Backwards: 150 um at 20 um per tick take 8 ticks; contact counts as settled 10 ms later.
    first = 150 + 7 + 10
    assert gaps[first - 1] == pytest.approx(70e-6, abs=1e-15)
    assert gaps[-1] == pytest.approx(gap + (70e-6 - gap) * math.exp(-(300 - first) * PERIOD / time), abs=1e-13)


def test_an_error_within_the_dead_zone_teaches_nothing() -> None:
    learner = Stepped(**{**LEARNING, "dead_zone": 1e-6, "backlash_gap": 20e-6})
    motor, load = 0.0, 0.0
    for k in range(2000):
        velocity = 0.02 * (-1.0) ** (k // 250)
        motor += velocity * PERIOD
        load = min(max(load, motor - 10.4e-6), motor + 10.4e-6)
        learner.tick(velocity, motor, load)
        assert learner.gap == pytest.approx(20e-6, abs=1e-18)


@pytest.mark.parametrize(
    ("why", "speed", "load_follows", "reference"),
    [
        ("too slow", 4e-3, True, 4e-3),
        ("the reference stands", 0.02, True, 0.0),
        ("the motor goes the other way", 0.02, True, -0.02),
        ("the motor has not crossed the largest gap", 0.0, False, 0.02),
    ],
)
def test_nothing_is_learnt_without_excitation(why: str, speed: float, load_follows: bool, reference: float) -> None:
    learner = Stepped(**LEARNING)
    for k in range(500):
        motor = speed * PERIOD * k
        learner.tick(reference, motor, motor if load_follows else 5e-5 * math.sin(k))
    assert learner.x.known == 0.0 and learner.gap == 0.0, why


@given(st.lists(st.tuples(st.floats(-0.1, 0.1), st.floats(-1e-3, 1e-3)), min_size=5, max_size=30))
def test_the_estimate_stays_in_its_bounds_for_any_measurement(legs: list[tuple[float, float]]) -> None:
    learner = Stepped(**{**LEARNING, "adaptation_time": 1e-3, "settling_time": 0.0, "largest_gap": 50e-6})
    motor = 0.0
    for velocity, load in legs:
        for _ in range(10):
            motor += velocity * PERIOD
            shift = learner.tick(velocity, motor, load)
            assert -1e-15 <= learner.gap <= 50e-6 + 1e-15
            assert abs(shift) <= 25e-6 + 1e-15


def test_a_frictionless_load_needs_its_time_constant_for_the_right_gap() -> None:
    """A braked load presses against the opposite flank. Without the time constant the learner confuses the flanks and the gap shrinks."""
    found = {}
    for constant in (0.0, 100.0):
        learner = Stepped(**{**LEARNING, "load_time_constant": constant, "settling_time": 0.002})
        for k in range(8000):
            position, velocity, acceleration = back_and_forth(k)
            side = math.copysign(1.0, velocity + 100.0 * acceleration)
            learner.tick(velocity, position, position - side * 20e-6, acceleration)
        found[constant] = learner.gap
    assert found[100.0] == pytest.approx(40e-6, abs=2.1e-7)
    assert found[0.0] < 20e-6


def test_a_guess_beyond_the_largest_gap_is_refused() -> None:
    with refuses(ParameterError, name="backlash_gap", value="0.0002", bound="<= largest_gap, 0.0001", unit="m"):
        AdaptiveBacklashInverse(backlash_gap=2e-4, largest_gap=1e-4)
