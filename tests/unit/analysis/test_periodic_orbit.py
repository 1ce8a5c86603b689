"""Exact periodic orbits: closed forms, Liouville's formula, differences, and an integrator without knowledge of modes."""

from __future__ import annotations

import math

import numpy as np
import pytest
from backlash_loops import FREE, HALF_GAP, J_L, J_M, K_S, PAPER, SCHEME_II, drive, integrated
from exact_run import simulate_exact

from contourlab.analysis.backlash.lure import BacklashLoop, axis_backlash_loop
from contourlab.analysis.backlash.periodic_orbit import PeriodicOrbit, Shooter, close_orbit, find_orbits
from contourlab.papers.shahin.two_inertia_loop import p_pi_cascade, two_inertia_loop
from contourlab.scenario import load_scenario


def stable_orbits(loop: BacklashLoop, **choices: tuple[float, ...]) -> list[PeriodicOrbit]:
    return [orbit for orbit in find_orbits(loop, **choices) if orbit.stable]


def test_the_orbit_of_two_free_inertias() -> None:
    """They bounce back and forth at any speed: period 2 (pi/w + 2 h/v), and every multiplier is 1."""
    loop, v = two_inertia_loop(PAPER, FREE), 0.7
    w = math.sqrt(K_S * (1.0 / J_M + 1.0 / J_L))
    share = np.array([0.0, J_L, 0.0, -J_M]) / (J_M + J_L)
    period = 2.0 * (math.pi / w + 2.0 * HALF_GAP / v)
    found = close_orbit(loop, share * v, period)
    assert found is not None
    assert found.period == pytest.approx(period, rel=1e-10)
    assert found.ratio == pytest.approx(1.0 + v / w / HALF_GAP, rel=1e-6)
    # Two are pairs in one block each, so rounding moves them by its root.
    assert np.abs(found.multipliers) == pytest.approx(np.ones(3), abs=1e-4)


CASES = {
    "dead zone": ({}, p_pi_cascade(120.0, 5.0)),
    "load damped, PI": ({"load_damping": 0.01}, p_pi_cascade(60.0, 5.0, 200.0)),
    "motor side": ({}, p_pi_cascade(300.0, 4.0, 1950.0, "motor")),
}


@pytest.mark.parametrize("name", CASES)
def test_product_of_multipliers(name: str) -> None:
    """Liouville: volumes change by exp(trace times period) in all modes, because the torque does not enter the trace."""
    changes, feedback = CASES[name]
    loop = two_inertia_loop(drive(**changes), feedback)
    orbit = stable_orbits(loop, kicks=(30.0,))[0]
    product = float(np.prod(orbit.multipliers).real)
    assert product == pytest.approx(math.exp(float(np.trace(loop.a)) * orbit.period), rel=1e-4, abs=1e-12)


@pytest.mark.slow
def test_a_motion_that_never_rests_is_closed_too() -> None:
    """A loop that switches its controller has no prediction; its kicked motion goes on for thousands of mode changes."""
    case = load_scenario("builtin:backlash/part").case("scheme III")
    loop = axis_backlash_loop(case.machine.axes[0], case.controller.axes["x"], case.machine.servo_period, case.machine.carried_mass("x"))
    (orbit,) = stable_orbits(loop)
    rounds = simulate_exact(loop, orbit.start, 40.0 * orbit.period)
    late = rounds.difference(np.linspace(39.0, 40.0, 2001) * orbit.period)
    assert 0.5 * float(np.ptp(late)) == pytest.approx(orbit.amplitude, rel=1e-4)


@pytest.mark.parametrize("damping", [0.0, 0.2])
def test_jacobian_against_differences(damping: float) -> None:
    """Central differences over some modes, for a shaft that jumps into contact and one that does not."""
    loop = two_inertia_loop(drive(shaft_damping=damping, load_damping=0.01), p_pi_cascade(60.0, 2.0))
    shooter = Shooter(loop)
    start = simulate_exact(loop, [0.0, 0.0, -30.0 * HALF_GAP, 0.0], 0.503).spans[-1].end[: shooter.n]
    shot = shooter.shot(start, 0.11)
    assert len(shot.motion) > 4
    columns = []
    for direction in np.eye(shooter.n):
        if damping and shot.motion[0].mode != 0 and direction[-1]:
            continue
        step = 1e-7 * direction * max(float(np.abs(start @ direction)), 1e-2)
        columns.append((shooter.shot(start + step, 0.11).end - shooter.shot(start - step, 0.11).end) / (2.0 * np.abs(step).sum()))
    wanted = np.array(columns).T
    found = shot.jacobian[:, : wanted.shape[1]]
    assert found == pytest.approx(wanted, rel=2e-4, abs=2e-5 * np.abs(wanted).max())


def test_an_orbit_closes_under_another_integrator() -> None:
    loop = two_inertia_loop(PAPER, p_pi_cascade(120.0, 5.0))
    orbit = stable_orbits(loop, kicks=(30.0,))[0]
    path = integrated(loop, orbit.start, np.linspace(0.0, orbit.period, 201))
    assert path[-1] == pytest.approx(path[0], abs=1e-8 * np.abs(path).max())
    assert 0.5 * np.ptp(path @ loop.c) == pytest.approx(orbit.amplitude, rel=1e-3)


def test_multipliers_describe_how_neighbours_return() -> None:
    """A motion near the orbit approaches it by the largest multiplier, period after period."""
    loop = two_inertia_loop(PAPER, p_pi_cascade(180.0, 5.0))
    orbit = stable_orbits(loop, kicks=(30.0,))[0]
    run = simulate_exact(loop, 1.01 * orbit.start, 21.0 * orbit.period)
    sizes = [np.ptp(run.difference(np.linspace(k * orbit.period, (k + 1) * orbit.period, 2001))) / 2.0 - orbit.amplitude for k in (10, 20)]
    assert (sizes[1] / sizes[0]) ** 0.1 == pytest.approx(abs(orbit.multipliers[0]), rel=2e-3)


def test_several_periods_are_one_orbit() -> None:
    loop = two_inertia_loop(PAPER, p_pi_cascade(120.0, 5.0))
    orbit = stable_orbits(loop, kicks=(30.0,))[0]
    again = close_orbit(loop, orbit.start, 3.0 * orbit.period)
    assert again is not None
    assert again.period == pytest.approx(orbit.period, rel=1e-9)


def test_an_unstable_orbit_is_found_and_called_unstable() -> None:
    """No simulation shows it: a motion displaced along the unstable direction grows by the multiplier in one period."""
    loop = two_inertia_loop(PAPER, p_pi_cascade(60.0, 0.2, 200.0, "motor"))
    found = find_orbits(loop, kicks=(30.0,))
    assert [orbit.stable for orbit in found] == [False]
    orbit = found[0]
    values, vectors = np.linalg.eig(Shooter(loop).shot(orbit.start, orbit.period).jacobian)
    worst = int(np.argmax(np.abs(values)))
    size = 1e-6 * np.abs(orbit.start).max()
    away = simulate_exact(loop, orbit.start + size * vectors[:, worst].real, orbit.period).state(orbit.period)[0] - orbit.start
    wanted = size * (values[worst] * vectors[:, worst]).real
    assert away == pytest.approx(wanted, abs=1e-3 * np.abs(wanted).max())
    assert abs(values[worst]) == pytest.approx(abs(orbit.multipliers[0]), rel=1e-9)
    assert abs(values[worst]) > 2.0


@pytest.mark.slow
def test_no_orbit_is_found_where_none_exists() -> None:
    """The paper's own scheme ends at rest (its energy proves it); so does a slow cascade on a damped load."""
    for loop in (two_inertia_loop(drive(load_damping=0.05), SCHEME_II), two_inertia_loop(drive(load_damping=0.02), p_pi_cascade(5.0, 2.0))):
        found = find_orbits(loop, kicks=(3.0, 30.0))
        assert found == ()
