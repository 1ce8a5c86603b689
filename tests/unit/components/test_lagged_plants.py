"""Plants whose force lags the command: against eqs (3) and (4) of Gecer Ulu et al., and in a machine."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, make, run_alone
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from refusals import refuses

from contourlab.components.controller.position import PositionController
from contourlab.components.friction.laws import Coulomb, SmoothCoulomb
from contourlab.components.plant.lagged_mass import LinearMotor, SecondOrderIntegrator
from contourlab.components.plant.plant import BallScrew, RigidAxis
from contourlab.errors import ParameterError
from contourlab.geometry import Line, Path
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.loop.template import build
from contourlab.papers.ghaffari.axis_response import transfer
from contourlab.scenario import builtin_file, load_machine, parse_scenario

Array = NDArray[np.float64]
W = np.geomspace(1e-2, 1e6, 61)
POSITIVE = st.floats(0.1, 10.0)
MOTORS = st.builds(
    LinearMotor,
    resistance=POSITIVE,
    inductance=st.floats(1e-4, 0.1),
    back_emf=st.floats(0.0, 100.0),
    force_constant=st.floats(1.0, 100.0),
    mass=POSITIVE,
    carried_mass=st.floats(0.0, 5.0),
    viscous_friction=st.floats(0.0, 50.0),
    amplifier_gain=POSITIVE,
)


def response(plant: Any) -> Array:
    """Return position per command and per load at the frequencies W: (n, 2)."""
    return np.asarray(transfer(plant.linearize(), 1j * W)[:, 0, :])


@given(motor=MOTORS)
def test_a_linear_motor_has_the_transfer_function_of_equation_3(motor: LinearMotor) -> None:
    s = 1j * W
    r, inductance, b, m = motor.resistance, motor.inductance, motor.viscous_friction, motor.mass + motor.carried_mass
    stiffness = r * b + motor.back_emf * motor.force_constant
    bottom = s * (inductance * m * s**2 + (r * m + b * inductance) * s + stiffness)
    found = response(motor)
    assert found[:, 0] == pytest.approx(motor.amplifier_gain * motor.force_constant / bottom, rel=1e-8)
    # A load meets the impedance of the winding: (L s + R)/(...), from eqs (1) and (2) with the load added to K_force i.
    assert found[:, 1] == pytest.approx((inductance * s + r) / bottom, rel=1e-8)


@given(gain=st.floats(1e-3, 10.0), zeta=st.floats(0.01, 10.0), wn=st.floats(1.0, 1e3))
def test_a_second_order_integrator_has_the_transfer_function_of_equation_4(gain: float, zeta: float, wn: float) -> None:
    s = 1j * W
    bottom = s * (s * s + 2.0 * zeta * wn * s + wn * wn)
    found = response(SecondOrderIntegrator(dc_gain=gain, damping_ratio=zeta, natural_frequency=wn))
    assert found[:, 0] == pytest.approx(gain * wn**2 / bottom, rel=1e-8)
    assert found[:, 1] == pytest.approx(gain * wn / (2.0 * zeta) * (s + 2.0 * zeta * wn) / bottom, rel=1e-8)


@given(motor=MOTORS, carried=st.floats(0.0, 20.0))
@pytest.mark.slow
def test_extra_mass_on_an_identified_response_acts_as_on_the_motor(motor: LinearMotor, carried: float) -> None:
    """Eq (3) with b = 0 is eq (4): wn^2 = K_b K_f/(L m), 2 zeta wn = R/L, G = K_amp/K_b. Both carry an extra mass here."""
    motor = motor.replace(viscous_friction=0.0, carried_mass=0.0, back_emf=motor.back_emf + 1.0)
    wn = math.sqrt(motor.back_emf * motor.force_constant / (motor.inductance * motor.mass))
    zeta = motor.resistance / motor.inductance / (2.0 * wn)
    same = SecondOrderIntegrator(dc_gain=motor.amplifier_gain / motor.back_emf, damping_ratio=zeta, natural_frequency=wn, mass=motor.mass)
    loaded, likewise = response(motor.loaded(carried)), response(same.loaded(carried))
    assert likewise[:, 0] == pytest.approx(loaded[:, 0], rel=1e-8)
    # Its forces are in volts: R/(K_f K_amp) of the motor's newtons.
    volts = motor.resistance / (motor.force_constant * motor.amplifier_gain)
    assert likewise[:, 1] * volts == pytest.approx(loaded[:, 1], rel=1e-8)


@pytest.mark.parametrize("zeta", [0.3, 1.0, 1.1, 5.0])
def test_a_steady_load_is_balanced_by_an_equal_command(zeta: float) -> None:
    plant = SecondOrderIntegrator(dc_gain=0.05, damping_ratio=zeta, natural_frequency=150.0)
    out = run_alone(plant, {"command": np.full(2000, 0.7), "load": np.full(2000, -0.7)}, jit=True)
    assert abs(out["velocity"][-1]) < 1e-12
    pushed = run_alone(plant, {"load": np.full(2000, 0.7)}, jit=True)
    assert pushed["velocity"][-1] == pytest.approx(0.05 * 0.7, rel=1e-9)


def test_force_of_a_blocked_motor_is_force_constant_times_current() -> None:
    motor = LinearMotor(resistance=2.0, inductance=0.01, back_emf=20.0, force_constant=30.0, mass=1.0, amplifier_gain=3.0)
    # Held by dry friction up to 90 N; i = K_amp e/R = 1.5 A per volt at rest, 45 N.
    for volts, moves in ((1.99, False), (2.01, True)):
        out = run_alone(motor, {"command": np.full(400, volts)}, friction=Coulomb(coulomb=90.0))
        assert bool(out["velocity"].any()) is moves


@given(motor=MOTORS)
def test_the_rigid_model_follows_slow_motions(motor: LinearMotor) -> None:
    """Both responses agree to second order in frequency: same velocity at rest, same sum of time constants."""
    gain, damping = motor.rigid_model()
    numbers = motor.linearize().a[1:, 1:]
    slowest = float(np.abs(np.linalg.eigvals(numbers)).min())
    s = 1e-3j * max(slowest, 1e-3)
    exact = complex(transfer(motor.linearize(), s)[0, 1, 0])
    assert gain / (s + damping) == pytest.approx(exact, rel=1e-4)


def test_a_rigid_plant_is_its_own_rigid_model() -> None:
    assert RigidAxis(gain=2.0, damping=3.0).rigid_model() == (2.0, 3.0)
    screw = BallScrew(mass=20.0, inertia=2e-4, lead=0.01, torque_constant=0.5, damping=100.0)
    linear = screw.linearize()
    assert screw.rigid_model() == pytest.approx((linear.b[1, 0], -linear.a[1, 1]), rel=1e-14)


# --- in a machine --------------------------------------------------------------------------------------------------------------------

MOTOR = LinearMotor(resistance=2.0, inductance=2e-4, back_emf=20.0, force_constant=30.0, mass=2.0)
KNOWN = SecondOrderIntegrator(dc_gain=0.05, damping_ratio=1.1, natural_frequency=150.0)


@pytest.mark.parametrize("substeps", [1, 3, 10])
def test_substeps_do_not_change_a_linear_motion(substeps: int) -> None:
    """R/L is 1e4 1/s: the propagator belongs to the substep, at any servo period."""
    machine = Machine("m", (Axis("x", MOTOR, substeps=substeps),), PERIOD)
    controller = Controller({"x": AxisController(make("controller", "position", velocity_gain=30.0, position_gain=600.0))})
    schedule = build(machine, controller, Path([Line((0.0,), (0.1,))]), np.zeros(1)).schedule
    node = next(node for node in schedule.nodes if node.name == "x.plant")
    alone = MOTOR.block(PERIOD / substeps)
    assert {name: node.parameters[name] for name in alone} == alone
    one = run_alone(MOTOR, {"command": np.sin(np.arange(50.0))})["position"]
    assert run_alone(MOTOR, {"command": np.sin(np.arange(50.0))}, substeps=substeps)["position"] == pytest.approx(one, rel=1e-11)


def test_a_lag_too_fast_for_a_step_recommends_substeps() -> None:
    stiff = MOTOR.replace(inductance=1e-6)
    with refuses(ParameterError, r"\b3 .*linear-motor", name="axes.x.substeps", value="1"):
        Machine("m", (Axis("x", stiff),), PERIOD)
    assert Machine("m", (Axis("x", stiff, substeps=3),), PERIOD)


def test_a_steep_friction_recommends_substeps_on_a_lagged_plant_too() -> None:
    steep = SmoothCoulomb(coulomb=10.0, breakaway=10.0, smoothing_velocity=1e-4)
    with refuses(ParameterError, r"\b20\b", name="axes.x.substeps", value="1"):
        Machine("m", (Axis("x", MOTOR, friction=steep),), PERIOD)


def test_extra_mass_needs_a_plant_of_known_mass() -> None:
    upper = Axis("x", KNOWN, mounted_on="y", stage_mass=3.0)
    with refuses(ParameterError, "3 kg", name="axes.y.plant"):
        Machine("m", (upper, Axis("y", KNOWN)), PERIOD)
    machine = Machine("m", (upper, Axis("y", KNOWN.replace(mass=1.5))), PERIOD)
    assert machine.loaded_plant("y").carried_mass == 3.0
    mobility = [type(p).mobility(p.constants()) for p in (machine.loaded_plant("y"), KNOWN)]
    assert mobility[0] / mobility[1] == pytest.approx(1.5 / 4.5, rel=1e-14)
    # Its forces are not in newtons, so the push of a module that moves along it is unknown.
    along = replace(upper, plant=MOTOR, alignment=0.5)
    with refuses(ParameterError, name="axes.x.alignment", value="0.5"):
        Machine("m", (along, Axis("y", KNOWN.replace(mass=1.5))), PERIOD)
    assert Machine("m", (along, Axis("y", MOTOR)), PERIOD)


def test_gains_are_placed_for_the_rigid_model() -> None:
    text = """
[machine]
name = "m"
servo_period = "1 ms"
axes = ["x"]
[axes.x.plant]
kind = "linear-motor"
resistance = "2 ohm"
inductance = "1.5 mH"
back_emf = "20 V*s/m"
force_constant = "30 N/A"
mass = "2 kg"
viscous_friction = "5 N*s/m"
[controller.axes.x.controller]
kind = "position"
gains = {natural_frequency = "100 rad/s", damping = 0.7, pole = "120 rad/s"}
[contour]
name = "line"
[feed]
feedrate = "1 m/min"
"""
    text = text.replace('name = "line"', 'name = "star"').replace('axes = ["x"]', 'axes = ["x", "y"]')
    text = text.replace("[axes.x.plant]", '[axes]\ny.file = "builtin:gecer-ulu/stage"\n[axes.x.plant]').replace(
        "axes.x.controller", 'axes."*".controller'
    )
    case = parse_scenario(text + '[axes.x.limits]\nvelocity = "1 m/s"\n').base
    for name in ("x", "y"):
        plant = case.machine.axis(name).plant
        placed = PositionController.place(100.0, 0.7, 120.0, *plant.rigid_model())
        found = case.controller.axes[name].controller
        assert {key: getattr(found, key) for key in placed} == pytest.approx(placed)


def test_the_shipped_stage_is_the_one_of_the_paper() -> None:
    machine = load_machine(builtin_file("gecer-ulu/xy-stage"))
    assert machine.axis_names == ("x", "y") and machine.servo_period == 30e-3
    for axis in machine.axes:
        plant: Any = axis.plant
        assert (plant.damping_ratio, plant.natural_frequency, plant.dc_gain) == (1.1, 150.0, 1.0)
        assert axis.sensor.resolution == 25e-9  # type: ignore[attr-defined]
    assert machine.axis("x").mounted_on == "y"
