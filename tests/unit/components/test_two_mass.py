"""Axes with one structural resonance: closed forms, python-control, other plants, friction on either side."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from component_rig import make
from numpy.typing import NDArray
from refusals import refuses
from scipy.linalg import expm
from scipy.signal import find_peaks
from two_mass_rig import NONE, Drive

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.friction.laws import Coulomb, LuGre
from contourlab.components.plant.two_sided import ElasticBallScrew, TwoMass
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
F, D, M, SHARE, K_F = 60.0, 0.03, 40.0, 0.6, 55.0
W = 2.0 * math.pi * F
AXIS = TwoMass(mass=M, load_share=SHARE, resonance=F, damping_ratio=D, force_constant=K_F)
STIFFNESS = SHARE * (1.0 - SHARE) * M * W**2
RAMP = np.interp(np.arange(4000), [0, 3000], [0.0, 50.0 / K_F])


def test_a_free_axis_rings_at_its_resonance_and_decays_with_its_damping_ratio() -> None:
    run = Drive(AXIS, period=2e-4).run(np.zeros(5000), motor_velocity=0.01)
    twist = run["motor_position"] - run["position"]
    peaks = find_peaks(twist)[0]
    damped = F * math.sqrt(1.0 - D**2)
    assert np.diff(peaks).mean() * 2e-4 == pytest.approx(1.0 / damped, rel=2e-3)
    decay = math.log(twist[peaks[0]] / twist[peaks[8]]) / 8.0
    assert decay == pytest.approx(2.0 * math.pi * D / math.sqrt(1.0 - D**2), rel=5e-3)
    # Momentum: both masses keep the mean velocity.
    assert run["velocity"][-1] == pytest.approx(0.01 * (1.0 - SHARE), rel=1e-3)


def test_a_static_force_twists_it_by_its_stiffness() -> None:
    force = 200.0
    run = Drive(AXIS.replace(damping_ratio=0.5)).run(np.full(4000, force / K_F), load=-force)
    assert run["motor_position"][-1] - run["position"][-1] == pytest.approx(force / STIFFNESS, rel=1e-6)


def test_the_response_is_that_of_python_control() -> None:
    control = pytest.importorskip("control")
    c = 80.0
    s = control.tf("s")
    slow, fast = 1.0 / (s**2 + s * c / M), 1.0 / (s**2 + (2.0 * D * W + c / M) * s + W**2)
    model = AXIS.replace(damping=c).linearize()
    own = control.ss(model.a, model.b[:, :1], model.c, np.zeros((4, 1)))
    w = np.geomspace(1.0, 5e3, 60)
    for row, sum_of in ((0, slow - fast), (2, slow + SHARE / (1.0 - SHARE) * fast)):
        assert own(1j * w)[row, 0] == pytest.approx(K_F / M * sum_of(1j * w), rel=1e-6)


def test_resonance_and_antiresonance_of_the_motor_side() -> None:
    """w_a = w_r sqrt(m_m/m): the load absorbs the motion of the motor."""
    plant = AXIS.replace(damping_ratio=1e-5)
    model = plant.linearize()
    anti = W * math.sqrt(1.0 - SHARE)

    def motor(w: float) -> float:
        return float(abs((model.c @ np.linalg.solve(1j * w * np.eye(4) - model.a, model.b))[3, 0]))

    assert motor(anti) < 1e-3 * motor(0.9 * anti) and motor(W) > 1e3 * motor(1.1 * W)
    loaded = plant.loaded(20.0)
    moved = math.sqrt(loaded.linearize().a[1, 2] + loaded.linearize().a[3, 0])
    assert moved == pytest.approx(math.sqrt(STIFFNESS * (1.0 / ((1.0 - SHARE) * M) + 1.0 / (SHARE * M + 20.0))))


def test_the_order_is_four_against_matrix_exponentials() -> None:
    plant = AXIS.replace(damping=80.0)
    model = plant.linearize()
    command = np.random.default_rng(3).normal(size=80)
    whole = np.zeros((5, 5))
    whole[:4, :4], whole[:4, 4] = model.a, model.b[:, 0]
    step, x, exact = expm(2e-3 * whole), np.zeros(4), []
    for u in command:
        x = (step @ np.r_[x, u])[:4]
        exact.append(x[[0, 2]])
    errors = []
    for n in (2, 4, 8):
        run = Drive(plant, period=2e-3, substeps=n).run(command)
        errors.append(np.abs(np.column_stack([run["motor_position"], run["position"]]) - exact).max())
    assert 3.7 < math.log2(errors[0] / errors[1]) < 4.3 and 3.7 < math.log2(errors[1] / errors[2]) < 4.3


def test_a_ball_screw_has_its_rotor_and_screw_on_the_motor_side() -> None:
    screw = ElasticBallScrew(mass=30.0, inertia=2e-4, lead=0.01, torque_constant=0.5, efficiency=0.9, damping=90.0, resonance=F)
    rotor = 2e-4 * (200.0 * math.pi) ** 2
    whole = rotor + 30.0
    same = TwoMass(mass=whole, load_share=30.0 / whole, damping=90.0, force_constant=0.45 * 200.0 * math.pi, resonance=F)
    reduced = rotor * 30.0 / whole / (200.0 * math.pi) ** 2
    shaft = make(
        "plant",
        "two-inertia",
        motor_inertia=2e-4,
        mass=30.0,
        lead=0.01,
        stiffness=reduced * W**2,
        shaft_damping=2.0 * 0.02 * W * reduced,
        load_damping=90.0 * 30.0 / whole / (200.0 * math.pi) ** 2,
        motor_damping=90.0 * rotor / whole / (200.0 * math.pi) ** 2,
        torque_gain=0.45,
    )
    command = np.random.default_rng(1).normal(size=300)
    runs = [Drive(part).run(command) for part in (screw, same, shaft)]
    for run in runs[1:]:
        assert run["position"] == pytest.approx(runs[0]["position"], rel=1e-9, abs=1e-15)
    rigid = make("plant", "ball-screw", mass=30.0, inertia=2e-4, lead=0.01, torque_constant=0.5, efficiency=0.9, damping=90.0)
    assert screw.rigid_model() == pytest.approx(rigid.rigid_model())
    assert ElasticBallScrew.moved_mass(screw.loaded(5.0)) == 35.0


def test_a_stiff_axis_is_a_mass() -> None:
    command = np.repeat([2.0, -1.0, 0.5], 100)
    rigid = Drive(make("plant", "mass-damper", mass=M, damping=80.0, force_constant=K_F)).run(command)["position"]
    for resonance in (300.0, 1200.0):
        plant = AXIS.replace(resonance=resonance, damping=80.0, damping_ratio=0.1)
        gap = np.abs(Drive(plant, substeps=plant.fewest_substeps(1e-3)[0]).run(command)["position"] - rigid).max()
        # The load lags behind the centre of mass by F/(m w_r^2), a step of F by up to twice that.
        most = 2.0 * 3.0 * K_F / M / (2.0 * math.pi * resonance) ** 2
        assert 0.1 * most < gap < most


@pytest.mark.parametrize(("load", "motor"), [(Coulomb(coulomb=60.0), NONE), (NONE, Coulomb(coulomb=60.0, breakaway=70.0))])
def test_friction_holds_either_side(load: Any, motor: Any) -> None:
    drive = Drive(AXIS, load, motor)
    held = drive.run(RAMP)
    side, other = ("velocity", "motor_velocity") if load is not NONE else ("motor_velocity", "velocity")
    assert not held[side].any() and abs(held[other][-1]) < 1e-5
    moved = drive.run(np.full(2000, 100.0 / K_F))
    # Momentum: (F - F_c) t on both masses together.
    assert M * ((1.0 - SHARE) * moved["motor_velocity"] + SHARE * moved["velocity"])[-1] == pytest.approx(40.0 * 2.0, rel=0.05)


def test_bristles_run_too() -> None:
    run = Drive(AXIS, LuGre(coulomb=60.0, breakaway=70.0, stiffness=1e7, bristle_damping=1e3)).run(RAMP)
    assert abs(run["position"][-1]) < 2.0 * 60.0 / 1e7


def test_the_sampled_loop_is_the_zero_order_hold_of_the_model() -> None:
    control = pytest.importorskip("control")
    axis = cl.Axis("x", AXIS, substeps=8)
    law = make("controller", "cascade", position_gain=1e-6, velocity_gain=10.0)
    loop = sampled_loop(axis, cl.AxisController(law, feedback="motor"), 1e-3)
    model = AXIS.linearize()
    discrete = control.c2d(control.ss(model.a, model.b[:, :1], model.c[3:], 0.0), 1e-3)
    w = np.array([10.0, 100.0, 300.0, W, 500.0, 2000.0])
    # The velocity is measured at the tick, and the position loop adds nothing at these frequencies.
    assert loop.loop_gain(w) == pytest.approx(10.0 * discrete(np.exp(1j * w * 1e-3)), rel=1e-5)


def test_too_few_substeps_are_refused_with_the_number_needed() -> None:
    machine = cl.Machine("one", (cl.Axis("x", AXIS),), 1e-3)
    assert AXIS.fewest_substeps(1e-3)[0] == 1
    with refuses(ParameterError, "at least 4", name="axes.x.substeps"):
        replace(machine, axes=(cl.Axis("x", AXIS.replace(resonance=300.0)),))
