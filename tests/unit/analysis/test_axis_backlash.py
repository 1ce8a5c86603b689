"""The loop around an axis's gap, from components and from matrices, and its limit cycles against the engine."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import contourlab as cl
from contourlab.analysis.backlash.lure import axis_backlash_loop
from contourlab.analysis.backlash.periodic_orbit import find_orbits
from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.zone_law import ContactZone2, GapZone2
from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.components.supervisor.switching import Performance
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.errors import ComponentError
from contourlab.geometry import Line, Path
from contourlab.papers.shahin.limit_cycle_cases import CASES, DRIVE, LimitCycleCase
from contourlab.papers.shahin.two_inertia_loop import p_pi_cascade, two_inertia_loop

LEAD = 2.0 * math.pi  # one metre at the table is one radian of the motor


def axis_of(case: LimitCycleCase) -> cl.Axis:
    drive = case.drive
    plant = TwoInertia(
        motor_inertia=drive.motor_inertia,
        load_inertia=drive.load_inertia,
        lead=LEAD,
        stiffness=drive.stiffness,
        shaft_damping=drive.shaft_damping,
        motor_damping=drive.motor_damping,
        load_damping=drive.load_damping,
        backlash_gap=2.0 * drive.half_gap,
    )
    return cl.Axis("x", plant, limits=cl.Limits(following_error=10.0))


def controller_of(position_gain: float, velocity_gain: float, integral_gain: float = 0.0, side: str = "load") -> cl.AxisController:
    time = velocity_gain / integral_gain if integral_gain else math.inf
    gains = Cascade(position_gain=position_gain, velocity_gain=velocity_gain, integral_time=time, velocity_feedforward=0.0)
    return cl.AxisController(controller=gains, feedback=side)


SERVOS = (
    controller_of(180.0, 5.0),
    controller_of(300.0, 4.0, 1950.0, "motor"),
    controller_of(150.0, 5.0),
    controller_of(120.0, 5.0),
    controller_of(60.0, 5.0, 200.0),
    controller_of(20.0, 5.0),
)
"""The controllers of `CASES`, as components."""
NAMES = [case.name for case in CASES]


def eigenvalues(matrix: np.ndarray) -> np.ndarray:
    found = np.linalg.eigvals(matrix)
    return np.asarray(found[np.lexsort((found.imag, found.real.round(6)))])


@pytest.mark.parametrize(("case", "servo"), list(zip(CASES, SERVOS, strict=True)), ids=NAMES)
def test_components_give_the_same_loop_as_matrices(case: LimitCycleCase, servo: cl.AxisController) -> None:
    made, known = axis_backlash_loop(axis_of(case), servo, 0.0), case.loop
    assert made.half_gap == pytest.approx(known.half_gap)
    for mode in ("gap_matrix", "contact_matrix"):
        kept = eigenvalues(getattr(made, mode))
        wanted = eigenvalues(getattr(known, mode))
        # An unread integral is a separate state that stays at zero.
        extra = len(kept) - len(wanted)
        assert np.sum(np.abs(kept) < 1e-6) == np.sum(np.abs(wanted) < 1e-6) + extra
        assert np.abs(np.poly(kept) - np.polymul(np.poly(wanted), [1.0] + [0.0] * extra)).max() <= 1e-7 * np.abs(np.poly(kept)).max()
    w = np.geomspace(1.0, 3e3, 40)
    assert made.transfer(w) == pytest.approx(known.transfer(w), rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(("case", "servo"), list(zip(CASES, SERVOS, strict=True)), ids=NAMES)
def test_the_engine_settles_on_the_orbit_found_by_shooting(case: LimitCycleCase, servo: cl.AxisController) -> None:
    """At a servo period of 1 us. At 5 us the hold already moves the second one by 1.2 %, because its phase hardly turns with frequency."""
    period, seconds, last = 1e-6, 3.0, 0.7
    orbit = next(orbit for orbit in find_orbits(axis_backlash_loop(axis_of(case), servo, 0.0)) if orbit.stable)
    position = np.full((round(seconds / period), 1), case.kick * case.drive.half_gap)
    position[0] = 0.0
    reference = cl.Reference.from_samples(position, period, Path([Line((0.0,), (1.0,))]))
    machine = cl.Machine("drive", (axis_of(case),), period)
    run = cl.simulate(machine, cl.Controller({"x": servo}), reference, signals=("motor_position", "axis_position"))
    apart = (run["motor_position"] - run["axis_position"])[-round(last / period) :, 0]
    assert 0.5 * (apart.max() - apart.min()) == pytest.approx(orbit.amplitude, rel=0.01)
    up = np.flatnonzero((apart[:-1] < 0.0) & (apart[1:] >= 0.0))
    assert 2.0 * math.pi * (len(up) - 1) / ((up[-1] - up[0]) * period) == pytest.approx(orbit.frequency, rel=0.01)


def test_hold_and_delay_are_a_rational_delay() -> None:
    axis, servo = axis_of(CASES[2]), SERVOS[2]
    late = replace(axis, drive=DelayedSaturation(delay=0.8e-3))
    made, prompt = axis_backlash_loop(late, servo, 0.4e-3), axis_backlash_loop(axis, servo, 0.0)
    assert made.n == prompt.n + 2
    w = np.array([50.0, 200.0, 400.0])
    # The response with a true delay of 1 ms on the command, from the matrices of the undelayed loop.
    known = two_inertia_loop(DRIVE, p_pi_cascade(150.0, 5.0))
    s = 1j * w
    free = np.array([np.linalg.solve(x * np.eye(4) - DRIVE.a, np.column_stack([DRIVE.command, DRIVE.torque])) for x in s])
    gain = np.array([0.0, 5.0, 750.0, 0.0])
    delay = np.exp(-s * 1e-3)
    closed = free[:, :, 1] - free[:, :, 0] * (delay * (free[:, :, 1] @ gain) / (1.0 + delay * (free[:, :, 0] @ gain)))[:, None]
    assert made.transfer(w) == pytest.approx(closed @ known.c, rel=2e-3)


def test_filters_and_an_observer_are_included() -> None:
    axis = axis_of(CASES[2])
    observer = DisturbanceObserver(model_gain=1.0 / 9.6e-3, bandwidth=50.0)
    parts = replace(SERVOS[0], velocity=FilteredDifference(bandwidth=2000.0), observer=observer)
    assert axis_backlash_loop(axis, parts, 0.0).n == 4 + 1 + 2 + 2
    fast = replace(SERVOS[0], velocity=FilteredDifference(bandwidth=1e7))
    w = np.geomspace(10.0, 1e3, 20)
    assert axis_backlash_loop(axis, fast, 0.0).transfer(w) == pytest.approx(axis_backlash_loop(axis, SERVOS[0], 0.0).transfer(w), rel=1e-3)


def test_switched_controllers_give_a_matrix_for_each_zone() -> None:
    axis, law = axis_of(CASES[0]), {"motor_inertia": 5.2e-3, "lead": LEAD, "backlash_gap": axis_of(CASES[0]).plant.gap_at(0.0)}
    contact, gap = ContactZone2(**law, rate_gain=8.0, position_gain=200.0), GapZone2(**law, rate_gain=2.0, position_gain=50.0)
    controller = cl.AxisController(controller=contact, others=(("gap", gap),), supervisor=Performance(thresholds=(1e-3,)))
    loop = axis_backlash_loop(axis, controller, 0.0)
    assert loop.contact_a is not None
    assert np.sort(np.linalg.eigvals(loop.gap_matrix).real) == pytest.approx(
        np.sort([*np.roots([5.2e-3, 2.0, 50.0]).real, 0.0, 0.0]), abs=1e-6
    )


def test_an_axis_without_gap_or_model_is_refused_in_words() -> None:
    axis = axis_of(CASES[0])
    with pytest.raises(ComponentError, match="no gap"):
        axis_backlash_loop(replace(axis, plant=axis.plant.replace(backlash_gap=0.0)), SERVOS[0], 1e-3)
