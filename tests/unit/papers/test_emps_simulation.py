"""The simulated EMPS against closed forms, and against the compiled engine with the shipped plant, friction and drive."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from contourlab.analysis.identification.filtered_motion import filtered_motion
from contourlab.components.drive.saturation import Saturation
from contourlab.components.friction.laws import Coulomb
from contourlab.components.mechanics.core import link
from contourlab.components.plant.plant import MassDamper
from contourlab.engine.runner import make_group
from contourlab.engine.step import Late, Node, Port, Schedule, Step
from contourlab.papers.emps.log import EmpsLog
from contourlab.papers.emps.simulation import LIMIT, EmpsAxis, advance, percent_errors, simulate_as_published, simulate_emps

Array = NDArray[np.float64]
PERIOD = 1e-3
AXIS = EmpsAxis(95.0, (200.0, 200.0), (20.0, 20.0), -3.0)
KP, KV, GAIN = 160.0, 243.0, 35.0


def there_and_back(n: int = 3000, amplitude: float = 0.01) -> EmpsLog:
    """Return a log of an axis at rest with a reference that moves from tick 20 on."""
    t = PERIOD * np.arange(n, dtype=np.float64)
    reference = amplitude * np.where(t > 0.02, 1.0 - np.cos(2.0 * math.pi * (t - 0.02)), 0.0)
    return EmpsLog(t, np.zeros(n), reference, np.zeros(n), np.zeros(n), KP, KV, GAIN)


def control(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    velocity = (inp.position - x.earlier) / (2.0 * clock.dt)
    command = 243.0 * (160.0 * (inp.reference - inp.position) - velocity)
    return (x.last, inp.position, command), (command, x.waiting)


def in_the_engine(reference: Array, delay: int) -> tuple[Array, Array]:
    """Return position and velocity of the same loop from components, except for its controller."""
    plant, friction, drive = MassDamper(mass=95.0, damping=200.0, force_constant=GAIN), Coulomb(coulomb=20.0), Saturation(limit=LIMIT)
    inputs, states = (Port("reference"), Port("position")), (Port("earlier"), Port("last"), Port("waiting"))
    law = Step("control", control, (), (), "", states, inputs, (Port("now"), Port("late")))
    block = plant.block(PERIOD) | friction.block(PERIOD)
    nodes = (
        Node("control", law, {"reference": "in.reference", "position": Late("plant.position")}),
        Node("drive", drive.make_step(), {"command": "control.late" if delay else "control.now"}, drive.block(PERIOD)),
        Node("plant", link(plant, friction), {"command": "drive.applied", "load": 3.0}, block),
    )
    schedule = Schedule(nodes, (Port("reference"),), PERIOD, 2)
    rows = [schedule.row(name) for name in ("plant.position", "plant.velocity")]
    found = make_group(schedule, 1, slice(0, 1), True).run(reference[:, None], rows)
    return found[:, 0, 0], found[:, 1, 0]


@pytest.mark.parametrize("delay", [0, 1])
def test_the_engine_runs_the_same_loop(delay: int) -> None:
    log = there_and_back()
    run = simulate_emps(log, AXIS, delay=delay)
    position, velocity = in_the_engine(log.reference, delay)
    assert np.ptp(position) > 0.018 and np.count_nonzero(velocity == 0.0) > 10
    # Runge-Kutta with a rate of 2/s, and a reversal on a cubic: far below one encoder count.
    np.testing.assert_allclose(run.position, position, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(run.velocity, velocity, rtol=0.0, atol=1e-6)


def test_a_constant_force_slides_the_axis_exponentially() -> None:
    force, t = 60.0, 0.5
    p, v = advance(AXIS, 0.1, 0.02, force, 0.0, t)
    end, tau = (60.0 + 3.0 - 20.0) / 200.0, 95.0 / 200.0
    assert v == pytest.approx(end + (0.02 - end) * math.exp(-t / tau), rel=1e-12)
    assert p == pytest.approx(0.1 + end * t + (0.02 - end) * tau * (1.0 - math.exp(-t / tau)), rel=1e-12)
    frictionless = EmpsAxis(2.0, (0.0, 0.0), (0.0, 0.0))
    assert advance(frictionless, 0.0, 1.0, -6.0, 0.0, 1.0) == pytest.approx((1.0 - 1.5, 1.0 - 3.0))


def test_coulomb_friction_stops_a_coasting_axis_and_holds_it() -> None:
    p, v = advance(AXIS, 0.0, 1e-3, -10.0, 0.0, 1.0)
    assert v == 0.0 and 0.0 < p < 1e-4
    assert advance(AXIS, p, 0.0, 16.999, 0.0, 1.0) == (p, 0.0)
    assert advance(AXIS, p, 0.0, 17.001, 0.0, 1.0)[1] > 0.0
    assert advance(AXIS, p, 0.0, -23.001, 0.0, 1.0)[1] < 0.0
    assert AXIS.acceleration(-22.9, 0.0) == 0.0
    assert AXIS.acceleration(-33.0, 0.0) == pytest.approx(-10.0 / 95.0)
    assert AXIS.acceleration(-3.0, 0.1) == pytest.approx(-40.0 / 95.0)


@given(v=st.floats(-0.3, 0.3), force=st.floats(-300.0, 300.0), share=st.floats(0.05, 0.95))
def test_two_parts_of_a_tick_equal_the_tick_and_friction_adds_no_energy(v: float, force: float, share: float) -> None:
    axis = EmpsAxis(95.0, (166.0, 240.0), (21.0, 19.0))
    whole = advance(axis, 0.0, v, force, 0.0, PERIOD)
    first = advance(axis, 0.0, v, force, 0.0, share * PERIOD)
    assert advance(axis, *first, force, 0.0, (1.0 - share) * PERIOD) == pytest.approx(whole, abs=1e-12)
    gained = 0.5 * 95.0 * (whole[1] ** 2 - v**2)
    assert gained <= force * whole[0] + 1e-12


def test_a_run_starts_from_the_initial_state_in_the_log() -> None:
    """A log cut from the middle of a run reproduces the rest: it contains position, speed and the controller's memory."""
    full = there_and_back()
    run = simulate_emps(full, AXIS)
    logged = replace(full, position=run.position, voltage=run.force / GAIN)
    cut = slice(400, None)
    signals = {name: getattr(logged, name)[cut] for name in ("position", "reference", "voltage", "pulses")}
    later = replace(logged, time=full.time[: full.time.size - 400], **signals)
    again = simulate_emps(later, AXIS)
    np.testing.assert_allclose(again.position, run.position[cut], rtol=0.0, atol=1e-7)
    assert again.position[0] == run.position[400]


def test_saturation_and_pulses() -> None:
    """The drive limits the controller to 10 V and adds the pulses."""
    log = there_and_back(amplitude=0.3)
    pulsed = replace(log, pulses=np.where(log.time > 0.3, 2.0, 0.0))
    assert np.abs(simulate_emps(log, AXIS).force).max() == pytest.approx(LIMIT * GAIN)
    assert simulate_emps(pulsed, AXIS).force.max() == pytest.approx((LIMIT + 2.0) * GAIN)


def test_the_published_solver_differs_only_by_its_clock_delay_and_chatter() -> None:
    log = there_and_back()
    published, ours = simulate_as_published(log, AXIS), simulate_emps(log, AXIS, delay=1)
    assert np.abs(published.position - ours.position).max() < 2e-6
    assert np.count_nonzero(ours.velocity[1000:] == 0.0) > np.count_nonzero(published.velocity[1000:] == 0.0)
    jittered = log.time.copy()
    jittered[9] += 2e-8
    drifting = simulate_as_published(replace(log, time=jittered), AXIS)
    assert drifting.time[-1] - log.time[-1] == pytest.approx(2e-8 * (log.time.size - 1))


def test_pulses_of_the_published_model_start_with_a_ramp_of_one_tick() -> None:
    """A free axis: each of 100 ticks of 2 V adds its momentum, the initial ramp half that of one tick."""
    n = 300
    t, none = PERIOD * np.arange(n, dtype=np.float64), np.zeros(n)
    pulses = np.where((t > 0.0995) & (t < 0.1995), 2.0, 0.0)
    log = EmpsLog(t, none, none, none, pulses, 1e-9, 1e-9, GAIN)
    free = EmpsAxis(95.0, (0.0, 0.0), (0.0, 0.0))
    published, held = simulate_as_published(log, free).velocity, simulate_emps(log, free).velocity
    gain = 2.0 * GAIN * PERIOD / 95.0
    assert (published[99], held[99], held[101]) == pytest.approx((0.0, 0.0, gain))
    assert published[101] == pytest.approx(1.5 * gain)
    assert (published[-1], held[-1]) == pytest.approx((100.0 * gain, 100.0 * gain))


def test_errors_in_percent_exclude_the_start() -> None:
    log = there_and_back()
    run = simulate_emps(log, AXIS)
    logged = replace(log, position=1.01 * run.position, voltage=run.force / GAIN)
    told = percent_errors(logged, filtered_motion(logged.position, PERIOD, cutoff=100.0), run, 500)
    assert told["position"] == pytest.approx(100.0 * 0.01 / 1.01, rel=1e-2)
    assert told["force"] == pytest.approx(0.0, abs=1e-9)
