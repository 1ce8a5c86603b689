"""The stated limit cycles: shooting, exact simulation, an integrator, and the describing function."""

from __future__ import annotations

import math

import numpy as np
import pytest
from backlash_loops import integrated
from exact_run import ExactRun, simulate_exact

from contourlab.papers.shahin.limit_cycle_cases import CASES, CASES_WITHOUT, LimitCycleCase, compare

# Amplitude over half of the gap and frequency [rad/s] of the orbits, from shooting with residuals below 1e-10; DOP853 confirms them
# (below). They are properties of the piecewise linear loops, so they change only if a case or its builder changes.
MEASURED = {
    "load side, K_v 180, K_p 5": (24.1782, 452.22),
    "motor side, K_v 300, K_p 4, K_i 1950": (16.8307, 381.98),
    "load side, K_v 150, K_p 5": (5.9985, 411.74),
    "load side, K_v 120, K_p 5, shaft damped": (2.7812, 338.37),
    "load side, K_v 60, K_p 5, K_i 200, load damped": (1.6625, 227.26),
    "load side, K_v 20, K_p 5, load damped": (1.1320, 76.27),
}


LAST = 20
"""Number of periods measured at the end of a simulation."""


def settled(case: LimitCycleCase, frequency: float) -> tuple[float, float]:
    """Return amplitude over half of the gap and frequency after a kick, simulated until the amplitude is constant."""
    loop, slowest = case.loop, frequency
    state, twist, before = np.zeros(loop.n), None, math.inf
    state[2] = -case.kick * loop.half_gap
    for _ in range(60):
        run = simulate_exact(loop, state, 100 * 2.0 * math.pi / slowest, twist=twist)
        ratio, frequency = _last_periods(run)
        if ratio < 1.0 + 1e-4:
            return 0.0, math.nan
        if abs(ratio - before) <= 1e-4 * ratio:
            return ratio, frequency
        end, before = run.spans[-1].end, ratio
        state, twist = end[: loop.n], float(end[loop.n]) if run.flow.twisted else None
    return before, frequency


def _last_periods(run: ExactRun) -> tuple[float, float]:
    """Return amplitude over half of the gap, and frequency, of the last periods; zero if contact ends before the run."""
    begins = run.times[run.modes == 1]
    if begins.size <= LAST or begins[-1] < 0.5 * run.duration:
        return 0.0, math.nan
    difference = run.difference(np.linspace(begins[-1 - LAST], begins[-1], 200 * LAST))
    period = float(begins[-1] - begins[-1 - LAST]) / LAST
    return 0.5 * float(np.ptp(difference)) / run.loop.half_gap, 2.0 * math.pi / period


def named(case: LimitCycleCase) -> str:
    return case.name


def check(case: LimitCycleCase) -> None:
    """Check that shooting and simulation agree within 1 %, and the describing function within 5 % from two half-gaps on."""
    found = compare(case)
    assert found.orbit is not None
    assert found.predicted is not None
    ratio, frequency = MEASURED[case.name]
    assert found.orbit.ratio == pytest.approx(ratio, rel=1e-4)
    assert found.orbit.frequency == pytest.approx(frequency, rel=1e-4)
    assert settled(case, found.orbit.frequency) == pytest.approx((ratio, frequency), rel=0.01)
    off = abs(found.predicted.frequency / found.orbit.frequency - 1.0)
    if found.orbit.ratio >= 2.0:
        assert off < 0.05
        assert abs(found.amplitude_error) < 0.05
    else:
        # Elsewhere the prediction is off by as much as the validity says: it is never called good.
        assert off > 0.05
        assert not found.predicted.validity.startswith("good")


def test_cases_are_as_stated() -> None:
    """Six of them, from 1.1 to 24 half-gaps, one with a damped shaft, one on the motor side."""
    assert [case.name for case in CASES] == list(MEASURED)
    assert sum(case.drive.shaft_damping > 0.0 for case in CASES) == 1
    assert sum(case.feedback.gain[0] != 0.0 for case in CASES) == 1


def test_one_case() -> None:
    check(CASES[2])


@pytest.mark.slow
@pytest.mark.parametrize("case", [case for case in CASES if case is not CASES[2]], ids=named)
def test_every_other_case(case: LimitCycleCase) -> None:
    check(case)


@pytest.mark.parametrize(
    "case", [pytest.param(case, marks=[] if case is CASES_WITHOUT[1] else pytest.mark.slow, id=case.name) for case in CASES_WITHOUT]
)
def test_no_limit_cycle_where_none_exists(case: LimitCycleCase) -> None:
    """The describing function predicts one, but motions come to rest and no shooting closes."""
    found = compare(case)
    assert found.orbit is None
    slowest = math.sqrt(case.drive.stiffness / case.drive.load_inertia) if found.predicted is None else found.predicted.frequency
    assert settled(case, slowest)[0] == 0.0
    assert found.predicted is None or found.predicted.validity.startswith("poor")


@pytest.mark.slow
@pytest.mark.parametrize("case", [case for case in CASES if case.drive.shaft_damping == 0.0], ids=named)
def test_an_integrator_settles_on_the_same_orbit(case: LimitCycleCase) -> None:
    """From 20 % beyond the orbit, by DOP853 without knowledge of modes, until the largest Floquet multiplier leaves less than 0.4 %."""
    ratio, frequency = MEASURED[case.name]
    loop = case.loop
    start = np.zeros(loop.n)
    start[2] = -1.2 * ratio * loop.half_gap
    period = 2.0 * np.pi / frequency
    rounds = {CASES[0].name: 100, CASES[1].name: 240}.get(case.name, 60)
    times = np.linspace(0.0, rounds * period, rounds * 100 + 1)
    difference = integrated(loop, start, times, 1e-7) @ loop.c
    last = difference[-40 * 100 :]
    assert 0.5 * np.ptp(last) / loop.half_gap == pytest.approx(ratio, rel=0.01)
    rises = times[-40 * 100 + 1 :][(last[1:] > 0.0) & (last[:-1] <= 0.0)]
    assert 2.0 * np.pi / np.mean(np.diff(rises)) == pytest.approx(frequency, rel=0.01)
