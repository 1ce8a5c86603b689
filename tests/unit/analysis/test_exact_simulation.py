"""Exact simulation of loops with a gap: closed forms, conservation, and an integrator without knowledge of modes."""

from __future__ import annotations

import math

import numpy as np
import pytest
from backlash_loops import FREE, HALF_GAP, J_L, J_M, K_S, PAPER, drive, integrated, paper_loop
from exact_run import simulate_exact
from hypothesis import example, given, settings
from hypothesis import strategies as st
from refusals import refuses
from scipy.linalg import expm

from contourlab.analysis.backlash.periodic_orbit import exponentials
from contourlab.errors import ParameterError
from contourlab.papers.shahin.two_inertia_loop import TwoInertias, motor_pid, p_pi_cascade, two_inertia_loop


def test_bounce_of_two_free_inertias() -> None:
    """Contact lasts half a period of the spring and reverses the relative velocity: all instants are closed forms."""
    loop, v = two_inertia_loop(PAPER, FREE), 0.7
    w = math.sqrt(K_S * (1.0 / J_M + 1.0 / J_L))
    run = simulate_exact(loop, [0.0, v, 0.0, 0.0], 0.2)
    first, crossing = HALF_GAP / v, 2.0 * HALF_GAP / v
    wanted = [0.0]
    while wanted[-1] < 0.2:
        wanted += [first + len(wanted) // 2 * (crossing + math.pi / w)]
        wanted += [wanted[-1] + math.pi / w]
    assert run.times == pytest.approx([t for t in wanted if t < 0.2], rel=1e-12, abs=1e-14)
    assert run.modes[:4].tolist() == [0, 1, 0, -1]
    deepest = run.difference(first + 0.5 * math.pi / w)[0]
    assert deepest == pytest.approx(HALF_GAP + v / w, rel=1e-12)


@settings(max_examples=10, deadline=None)
@given(start=st.tuples(*[st.floats(-1.0, 1.0)] * 4), spring=st.floats(1.0, 500.0), ratio=st.floats(0.05, 20.0), gap=st.floats(1e-4, 0.1))
@pytest.mark.slow
def test_energy_is_conserved(start: tuple[float, ...], spring: float, ratio: float, gap: float) -> None:
    """Two inertias, a spring to the reference and a spring behind a gap: every sample has the initial energy."""
    drive_ = drive(load_inertia=ratio * J_M, half_gap=gap)
    loop = two_inertia_loop(drive_, motor_pid(spring, 0.0))
    x0 = np.array(start) * [0.1, 5.0, 0.1, 5.0]
    x = simulate_exact(loop, x0, 0.5).state(np.linspace(0.0, 0.5, 101))
    d = x @ loop.c
    deflection = d - np.clip(d, -gap, gap)
    energy = 0.5 * (spring * x[:, 0] ** 2 + J_M * x[:, 1] ** 2 + ratio * J_M * x[:, 3] ** 2 + K_S * deflection**2)
    assert energy == pytest.approx(energy[0], rel=1e-10, abs=1e-14)


@pytest.mark.parametrize("feedback", [p_pi_cascade(100.0, 5.0), p_pi_cascade(60.0, 5.0, 200.0), p_pi_cascade(60.0, 1.0, 1400.0, "motor")])
def test_agrees_with_an_integrator(feedback: object) -> None:
    """DOP853 at 1e-12 over dozens of contacts."""
    loop = two_inertia_loop(drive(load_damping=0.01), feedback)  # type: ignore[arg-type]
    start = np.zeros(loop.n)
    start[2] = 0.03
    times = np.linspace(0.0, 0.5, 51)
    run = simulate_exact(loop, start, 0.5)
    assert run.times.size > 20
    other = integrated(loop, start, times)
    assert np.abs(run.state(times) - other).max(axis=0) == pytest.approx(np.zeros(loop.n), abs=1e-7 * np.abs(other).max())


def test_stiff_and_slow_modes_together() -> None:
    """The paper's loop: rates of 1.9e5 1/s and 0.2 1/s. In the gap the motor's slow mode keeps its digits."""
    loop = paper_loop()
    rate = np.linalg.eigvals(loop.gap_matrix[:2, :2]).real.max()
    start = np.array([1e-3, 1e-3 * rate, 0.0, 0.0])
    run = simulate_exact(loop, start, 10.0)
    assert run.modes.tolist() == [0]
    assert run.state(10.0)[0, 0] == pytest.approx(1e-3 * math.exp(10.0 * rate), rel=1e-9)


@pytest.mark.parametrize("damping", [0.02, 0.2, 2.0])
def test_a_damped_shaft_never_pulls(damping: float) -> None:
    """Nordin, Galic & Gutman: the torque has the sign of the flank in contact; the energy (kinetic plus twist of the shaft) only falls."""
    loop = two_inertia_loop(drive(shaft_damping=damping), FREE)
    run = simulate_exact(loop, [0.0, 2.0, 0.0, -1.0], 0.3)
    times = np.linspace(0.0, 0.3, 4001)
    torque, difference = run.torque(times), run.difference(times)
    assert run.times.size > 4
    # A dead zone with the same damper in contact would pull just before release.
    assert (torque * np.sign(difference) >= -1e-12 * np.abs(torque).max()).all()
    x = run.state(times)
    assert J_M * x[:, 1] + J_L * x[:, 3] == pytest.approx(2.0 * J_M - J_L, rel=1e-11)
    kinetic = 0.5 * (J_M * x[:, 1] ** 2 + J_L * x[:, 3] ** 2)
    free = np.abs(torque) == 0.0
    assert (np.diff(kinetic[free]) <= 1e-12 * kinetic[0]).all()


def test_first_contact_of_a_damped_shaft() -> None:
    """One contact with a damped spring is a closed form: it ends where k z + d z' = 0, z = v/w exp(-s t) sin(w t)."""
    d, v = 0.3, 0.9
    loop = two_inertia_loop(drive(shaft_damping=d), FREE)
    run = simulate_exact(loop, [HALF_GAP, v, 0.0, 0.0], 0.05)
    m = 1.0 / (1.0 / J_M + 1.0 / J_L)
    s = d / (2.0 * m)
    w = math.sqrt(K_S / m - s * s)
    end = (math.pi - math.atan2(d * w, K_S - d * s)) / w
    assert run.modes[:2].tolist() == [1, 0]
    assert run.times[1] == pytest.approx(end, rel=1e-11)
    # In the gap the shaft relaxes at k/d from its twist at release.
    twist = v / w * math.exp(-s * end) * math.sin(w * end)
    later = run.spans[1].start[-2], run.flow.exponential(0, 1e-3) @ run.spans[1].start
    assert later[0] == pytest.approx(twist, rel=1e-10)
    assert later[1][-2] == pytest.approx(twist * math.exp(-1e-3 * K_S / d), rel=1e-10)


def test_little_shaft_damping_is_the_dead_zone() -> None:
    """The difference falls in proportion to the damping: order 1."""
    start, times = [0.0, 2.0, 0.0, -1.0], np.linspace(0.0, 0.05, 101)
    plain = simulate_exact(two_inertia_loop(PAPER, FREE), start, 0.05).state(times)
    gaps = [
        np.abs(simulate_exact(two_inertia_loop(drive(shaft_damping=d), FREE), start, 0.05).state(times) - plain).max()
        for d in (4e-4, 2e-4, 1e-4)
    ]
    orders = np.log2(np.array(gaps[:-1]) / gaps[1:])
    assert orders == pytest.approx([1.0, 1.0], abs=0.05)


def test_references() -> None:
    """Inside the gap, a motor at its reference stays there."""
    loop = two_inertia_loop(PAPER, motor_pid(400.0, 3.0, 0.0, J_M))
    assert simulate_exact(loop, [0.001, 0.0, 0.0, 0.0], 1.0, 0.001).state(1.0)[0, 0] == pytest.approx(0.001, rel=1e-12)


def test_a_divergence_is_reported() -> None:
    run = simulate_exact(two_inertia_loop(PAPER, motor_pid(-100.0, 0.0)), [1e-3, 0.0, 0.0, 0.0], 10.0)
    assert run.diverged
    assert run.duration < 2.0


@settings(max_examples=40, deadline=None)
@given(entries=st.lists(st.floats(-3.0, 3.0), min_size=16, max_size=16), time=st.floats(0.0, 10.0))
def test_exponentials_agree_with_another_algorithm(entries: list[float], time: float) -> None:
    matrix = np.array(entries).reshape(4, 4)
    wanted = expm(matrix * time)
    # It starts from one, so it rounds to 1e-16 even where it has decayed to 1e-8.
    assert exponentials(matrix, time) == pytest.approx(wanted, rel=1e-9, abs=1e-10 * np.abs(wanted).max() + 1e-15)


def test_exponential_of_slow_and_fast_rates() -> None:
    """Upper triangular, rates of 2e5 and 0.2: the slow one keeps all its digits."""
    found = exponentials(np.array([[-2e5, 1e3], [0.0, -0.2]]), [0.0, 1.0, 10.0])
    assert found[:, 1, 1] == pytest.approx([1.0, math.exp(-0.2), math.exp(-2.0)], rel=1e-14)
    assert found[2, 0, 1] == pytest.approx(1e3 / (2e5 - 0.2) * math.exp(-2.0), rel=1e-11)


def test_a_run_with_too_many_changes_of_mode_is_refused() -> None:
    with refuses(ParameterError, "10 s", value=10):
        simulate_exact(two_inertia_loop(PAPER, FREE), [0.0, 1.0, 0.0, 0.0], 10.0, most=10)


@example(gap=-3.515196630758031, stiffness=3.850096982282033, shaft=0.07, gains=(1.40625, 0.0), speeds=(0.0, 2.3563541902681315))
@settings(max_examples=10, deadline=None)
@given(
    gap=st.floats(-4.0, -1.0),
    stiffness=st.floats(1.0, 5.0),
    shaft=st.one_of(st.just(0.0), st.floats(1e-4, 1.0)),
    gains=st.tuples(st.floats(0.0, 2.5), st.floats(-1.0, 1.5)),
    speeds=st.tuples(st.floats(-3.0, 3.0), st.floats(-3.0, 3.0)),
)
def test_no_event_is_missed(gap: float, stiffness: float, shaft: float, gains: tuple[float, float], speeds: tuple[float, float]) -> None:
    """At every sample in the gap the load is between the flanks, and in contact no torque pulls."""
    plant = drive(half_gap=10.0**gap, stiffness=10.0**stiffness, shaft_damping=shaft, load_damping=0.01)
    loop = two_inertia_loop(plant, p_pi_cascade(10.0 ** gains[0], 10.0 ** gains[1]))
    run = simulate_exact(loop, [0.0, speeds[0], 0.0, speeds[1]], 0.3)
    times = np.linspace(0.0, run.duration, 2001)
    torque, twist, difference = run.torque(times), run.twist(times), run.difference(times)
    mode = run.modes[np.searchsorted(run.times, times, side="right") - 1]
    assert np.abs(difference - twist)[mode == 0].max(initial=0.0) <= plant.half_gap * (1.0 + 1e-8)
    assert (torque * mode >= -1e-8 * np.abs(torque).max(initial=1e-300)).all()


def test_each_controller_has_its_own_reference() -> None:
    """Up to the first loss of contact a switched loop equals that of its contact controller, reference included."""
    from scipy.integrate import solve_ivp

    plant = TwoInertias(5.2e-3, 4.4e-3, 950.0, 0.005, load_damping=0.05)
    in_gap, in_contact = motor_pid(20.0, 2.0), motor_pid(200.0, 4.0)
    switched = two_inertia_loop(plant, in_gap, in_contact)
    start = np.array([0.02, 0.0, 0.0, 0.0])  # the shaft is wound up by 0.015 rad

    def rates(_: float, x: np.ndarray) -> list[float]:
        torque = 950.0 * (x[0] - x[2] - 0.005)
        command = 200.0 * (0.5 - x[0]) - 4.0 * x[1]
        return [x[1], (command - torque) / 5.2e-3, x[3], (torque - 0.05 * x[3]) / 4.4e-3]

    run = simulate_exact(switched, start, 0.004, 0.5)
    assert set(np.asarray(run.modes).tolist()) == {1}
    known = solve_ivp(rates, (0.0, 0.004), start, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    assert run.state([0.004])[0] == pytest.approx(known, rel=1e-8)
