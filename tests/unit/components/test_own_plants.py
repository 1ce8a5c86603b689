"""A plant of any shape, with a step of its own: a flexible two-mass with an actuator of third order, against an exact discretisation."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from component_rig import run_alone
from numpy.typing import NDArray
from refusals import refuses
from scipy.linalg import expm

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import lane_loops, sampled_loop
from contourlab.components.controller.pid import PID
from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.components.friction.laws import Coulomb, LuGre, NoFriction, SmoothCoulomb
from contourlab.components.mechanics.core import link
from contourlab.components.plant.plant import MassDamper, resonance_of
from contourlab.components.plant.two_sided import TwoMass
from contourlab.engine.step import Port, ports
from contourlab.errors import ComponentError, ParameterError
from contourlab.geometry import Line, Path
from contourlab.primitives import fabs, select, sin, sqrt

Array = NDArray[np.float64]
PERIOD = 1e-3


def slopes(par: Any, y: Any, u: float, load: float) -> Any:
    f1, f2, f3, pm, vm, pl, vl = y
    w, shaft = par.bandwidth, par.stiffness * (pm - pl) + par.damper * (vm - vl)
    curve = par.ripple * sin(pm / 2e-3)
    return (
        f2,
        f3,
        w * w * w * (u - f1) - 2.0 * w * w * f2 - 2.0 * w * f3,
        vm,
        (par.force * f1 - shaft - par.drag * vm + curve) / par.motor,
        vl,
        (shaft + load) * par.mobility_value,
    )


def ahead(y: Any, k: Any, h: float) -> Any:
    return tuple(a + h * b for a, b in zip(y, k, strict=True))


class Flexible(cl.Plant):
    """Two masses and an actuator of third order, by Runge-Kutta."""

    kind = "flexible"
    example = {"motor": 8.0, "table": 12.0, "resonance": 40.0, "drag": 60.0, "force": 50.0, "bandwidth": 900.0, "ripple": 0.5}
    reference = "test"
    command_unit = "A"
    two_sided = True
    states = ports("force_1", "force_2", "force_3", "motor_position", "motor_velocity", "position", "velocity")
    outputs = ports("position", "velocity", "acceleration", "motor_position", "motor_velocity")
    derived = ("mobility_value", "stiffness", "damper")

    motor: float = cl.param(unit="kg", minimum=0.0, exclusive=True, doc="motor")
    table: float = cl.param(unit="kg", minimum=0.0, exclusive=True, doc="table")
    carried_mass: float = cl.param(default=0.0, unit="kg", minimum=0.0, doc="more on the table")
    resonance: float = cl.param(unit="Hz", minimum=0.0, exclusive=True, doc="of the shaft")
    drag: float = cl.param(unit="N*s/m", minimum=0.0, doc="of the motor")
    force: float = cl.param(unit="N/A", minimum=0.0, exclusive=True, doc="per command")
    bandwidth: float = cl.param(unit="rad/s", minimum=0.0, exclusive=True, doc="of the actuator")
    ripple: float = cl.param(default=0.0, unit="N", minimum=0.0, doc="cogging at the motor")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        w = 2.0 * np.pi * par.resonance
        reduced = 1.0 / (1.0 / par.motor + 1.0 / par.table)
        return 1.0 / (par.table + par.carried_mass), reduced * w * w, 0.04 * reduced * w

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        h, u, load = clock.dt, inp.command, inp.load
        k1 = slopes(par, x, u, load)
        k2 = slopes(par, ahead(x, k1, 0.5 * h), u, load)
        k3 = slopes(par, ahead(x, k2, 0.5 * h), u, load)
        k4 = slopes(par, ahead(x, k3, h), u, load)
        y = tuple(x[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]) for i in range(7))
        return y, (y[5], y[6], (y[6] - x.velocity) / h, y[3], y[4])


def matrices(plant: Flexible) -> tuple[Array, Array]:
    """Return A and B (command, load) of the plant without ripple, written here anew."""
    d, w = plant.constants(), plant.bandwidth
    a, b = np.zeros((7, 7)), np.zeros((7, 2))
    a[0, 1] = a[1, 2] = a[3, 4] = a[5, 6] = 1.0
    a[2, :3], b[2, 0] = (-(w**3), -2.0 * w**2, -2.0 * w), w**3
    a[4, [0, 3, 4, 5, 6]] = plant.force, -d.stiffness, -d.damper - plant.drag, d.stiffness, d.damper
    a[4] /= plant.motor
    a[6, 3:] = np.array([d.stiffness, d.damper, -d.stiffness, -d.damper]) * d.mobility_value
    b[6, 1] = d.mobility_value
    return a, b


def held(a: Array, b: Array, dt: float) -> tuple[Array, Array]:
    n, m = b.shape
    whole = expm(dt * np.block([[a, b], [np.zeros((m, n + m))]]))
    return whole[:n, :n], whole[:n, n:]


PLANT = Flexible(**{**Flexible.example, "ripple": 0.0})
LAW = PID(proportional_gain=100.0, derivative_gain=9.0)


MOVE = cl.plan(cl.route_from_path(Path([Line((0.0,), (0.05,))]), 0.05), cl.AxisLimits(1.0, 5.0, 100.0), PERIOD)


MOVING = cl.uniform(cl.contour("circle", radius=0.01), 1.0, 1, PERIOD)


def exact_motion(u: Array) -> Array:
    ad, bd = held(*matrices(PLANT), PERIOD)
    x, found = np.zeros(7), []
    for row in u:
        x = ad @ x + bd @ row
        found.append(x[[5, 6, 3, 4]])
    return np.array(found)


def test_the_contract() -> None:
    checks = cl.check_component(Flexible)
    assert "linear model agrees with the step" in checks and f"every parameter has an effect ({len(Flexible.parameters)})" in checks


@pytest.mark.parametrize("jit", [False, True])
def test_its_motion_is_the_exact_one(jit: bool) -> None:
    t = np.arange(100) * PERIOD
    u = np.column_stack([np.sin(40.0 * t), 20.0 * np.cos(90.0 * t)])
    found = run_alone(PLANT, {"command": u[:, 0], "load": u[:, 1]}, substeps=100, jit=jit)
    wanted = exact_motion(u)
    for j, name in enumerate(("position", "velocity", "motor_position", "motor_velocity")):
        assert np.abs(found[name] - wanted[:, j]).max() <= 1e-9 * np.abs(wanted[:, j]).max()


def test_the_model_and_the_margins_are_those_of_the_matrices() -> None:
    a, b = matrices(PLANT)
    model = PLANT.linearize()
    assert model is not None and model.outputs == ("position", "velocity", "motor_position", "motor_velocity")
    assert np.abs(model.a - a).max() <= 1e-9 * np.abs(a).max() and np.abs(model.b - b).max() <= 1e-9 * np.abs(b).max()
    gain, damping = PLANT.rigid_model()
    assert (gain, damping) == (pytest.approx(PLANT.force / 20.0, rel=0.05), pytest.approx(PLANT.drag / 20.0, rel=0.05))
    assert PLANT.force_per_command == pytest.approx(PLANT.force, rel=1e-6)
    assert resonance_of(PLANT) is not None
    loop = sampled_loop(cl.Axis("x", PLANT, substeps=40), cl.AxisController(LAW), PERIOD)
    ad, bd = held(a, b, PERIOD)
    w = np.geomspace(1.0, 0.9 * np.pi / PERIOD, 50)
    z = np.exp(1j * w * PERIOD)
    plant = np.array([np.linalg.solve(one * np.eye(7) - ad, bd[:, 0])[5] for one in z])
    assert loop.response(w).compensated == pytest.approx(
        np.array([np.linalg.solve(one * np.eye(7) - ad, bd[:, 0])[6] for one in z]), rel=1e-6
    )
    assert loop.margins().gain > 1.0 and plant.size


def test_a_smooth_plant_has_margins_about_rest() -> None:
    bent = Flexible(**Flexible.example)
    axis, controller = cl.Axis("x", bent, substeps=4), cl.AxisController(LAW)
    loop = sampled_loop(axis, controller, PERIOD)
    spring = PLANT.replace()
    a, b = matrices(spring)
    a[4, 3] += bent.ripple / 2e-3 / bent.motor
    wanted = held(a, b, PERIOD)[0]
    found = np.linalg.eigvals(bent.linearize().a)
    assert np.sort_complex(found) == pytest.approx(np.sort_complex(np.linalg.eigvals(a)), rel=1e-6, abs=1e-5)
    assert loop.stable and wanted.shape == (7, 7)
    assert bent.linear().linear().values() == bent.values() and bent.linear().mobilities() == bent.mobilities()


def test_variants_have_their_own_models() -> None:
    axis, controller = cl.Axis("x", Flexible(**Flexible.example), substeps=4), cl.AxisController(LAW)
    resonances = np.array([30.0, 40.0, 55.0])
    loops = lane_loops(axis, controller, PERIOD, 0.0, {"axes.x.plant.resonance": resonances})
    for radius, resonance in zip(loops.radius(1.0), resonances, strict=True):
        one = sampled_loop(replace(axis, plant=axis.plant.replace(resonance=resonance)), controller, PERIOD)
        assert radius == pytest.approx(np.abs(one.poles).max(), abs=1e-9)


class Kinked(Flexible):
    """A dead zone."""

    kind = "kinked"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        pushed = inp.command if inp.command > 0.0 else 0.0
        return Flexible.step(par, x, type(inp)(pushed, inp.load), clock)


def test_what_is_not_smooth_has_no_model() -> None:
    with pytest.raises(ComponentError, match="not smooth"):
        Kinked(**Kinked.example).linearize()


@pytest.mark.parametrize(
    ("force", "slope"),
    [
        (lambda v: v * fabs(v) * 1e3, 0.0),
        (lambda v: 5e3 * v * v, 0.0),
        (lambda v: 7.0 * v + 1e5 * v * v * v, 7.0),
        (lambda v: 7.0 * sin(1e3 * v), 7e3),
        (lambda v: select(v > 0.0, 1e-3, -1e-3), None),
        (lambda v: 1e-2 * fabs(v), None),
        (lambda v: sqrt(fabs(v)) * select(v > 0.0, 1.0, -1.0), None),
        (lambda v: select(v > 0.0, 3.0, 1.0) * v, None),
    ],
)
def test_smooth_forces_have_slopes_and_others_are_refused(force: Any, slope: float | None) -> None:
    class Pulled(Mass):
        """A mass under a force of velocity."""

        kind = "pulled"

        @staticmethod
        def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
            pull = (60.0 * inp.command + inp.load - force(x.velocity)) * par.mobility_value
            v = x.velocity + clock.dt * pull
            return (x.position + clock.dt * v, v), (x.position + clock.dt * v, v, pull)

    if slope is None:
        with pytest.raises(ComponentError, match="not smooth"):
            Pulled(mass=20.0).linearize()
    else:
        assert Pulled(mass=20.0).linearize().a[1, 1] == pytest.approx(-slope / 20.0, rel=1e-3, abs=1e-2)


class Mass(cl.Plant):
    """A mass that steps itself, exactly for constant forces."""

    kind = "own-mass"
    example = {"mass": 20.0}
    command_unit = "A"
    states = ports("position", "velocity")
    derived = ("mobility_value",)

    mass: float = cl.param(unit="kg", minimum=0.0, exclusive=True, doc="mass")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (1.0 / par.mass,)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        a = (60.0 * inp.command + inp.load) * par.mobility_value
        v = x.velocity + clock.dt * a
        p = x.position + clock.dt * (x.velocity + 0.5 * clock.dt * a)
        return (p, v), (p, v, a)


FRICTIONS = [
    Coulomb(coulomb=12.0, breakaway=20.0, viscous=30.0, stribeck_velocity=5e-3),
    SmoothCoulomb(coulomb=12.0, breakaway=20.0, viscous=30.0, smoothing_velocity=1e-3),
    LuGre(coulomb=12.0, breakaway=20.0, viscous=30.0, stiffness=1e6, bristle_damping=1e3),
]


@pytest.mark.parametrize("friction", FRICTIONS, ids=lambda part: part.kind)
def test_friction_converges_to_that_of_a_mass(friction: Any) -> None:
    u = 0.5 * np.sin(2.0 * np.pi * 4.0 * np.arange(500) * PERIOD)
    wanted = run_alone(MassDamper(mass=20.0, force_constant=60.0), {"command": u}, friction=friction, substeps=100, jit=True)["position"]
    errors = [
        np.abs(run_alone(Mass(mass=20.0), {"command": u}, friction=friction, substeps=n, jit=True)["position"] - wanted).max()
        for n in (4, 16, 64)
    ]
    assert errors[0] > 2.5 * errors[1] > 6.0 * errors[2] and errors[2] < 2e-3 * np.abs(wanted).max()


def test_a_friction_that_sticks_holds() -> None:
    u = np.where(np.arange(900) < 100, 1.0, 0.1)
    found = run_alone(Mass(mass=20.0), {"command": u}, friction=FRICTIONS[0])
    assert np.abs(found["velocity"][-50:]).max() < 1e-15 and found["velocity"][:100].max() > 0.05
    flexible = run_alone(PLANT, {"command": u}, friction=FRICTIONS[0], substeps=8)
    assert np.abs(flexible["velocity"][-50:]).max() < 1e-12


def machine(plant: Any, **parts: Any) -> cl.Machine:
    return cl.Machine("m", (cl.Axis("x", plant, substeps=8, **parts),), PERIOD)


def test_what_a_plant_does_not_declare_is_refused() -> None:
    class Closed(Mass):
        """A mass whose friction is its own."""

        kind = "closed"
        derived = ("weight",)

        @staticmethod
        def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
            a = (60.0 * inp.command + inp.load) * par.weight
            v = x.velocity + clock.dt * a
            return (x.position + clock.dt * v, v), (x.position + clock.dt * v, v, a)

    assert machine(Closed(mass=2.0))
    with refuses(ParameterError, "mobility_value", name="axes.x.friction"):
        machine(Closed(mass=2.0), friction=FRICTIONS[0])
    with refuses(ParameterError, "flexible", name="axes.x.motor_friction"):
        machine(PLANT, motor_friction=FRICTIONS[0])
    assert isinstance(machine(Closed(mass=2.0)).axes[0].friction, NoFriction)


def test_outputs_are_those_at_the_end_of_the_step() -> None:
    class Early(Mass):
        """A mass whose step gives what it was."""

        kind = "early"

        @staticmethod
        def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
            after, out = Mass.step(par, x, inp, clock)
            return after, (x.position, x.velocity, out[2])

    for use in (Early(mass=20.0).linearize, lambda: cl.check_component(Early)):
        with pytest.raises(ComponentError, match="at the begin of the step"):
            use()


def test_friction_acts_where_the_load_pushes() -> None:
    class Elsewhere(Flexible):
        """A plant whose load pushes the motor, while it tells the mobility of the table."""

        kind = "elsewhere"

        @staticmethod
        def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
            a = (par.force * inp.command + inp.load - par.stiffness * (x.motor_position - x.position)) / par.motor
            v = x.motor_velocity + clock.dt * a
            w = x.velocity + clock.dt * par.stiffness * (x.motor_position - x.position) * par.mobility_value
            p, q = x.motor_position + clock.dt * v, x.position + clock.dt * w
            return (x.force_1, x.force_2, x.force_3, p, v, q, w), (q, w, (w - x.velocity) / clock.dt, p, v)

    with pytest.raises(ComponentError, match="mobility_value"):
        cl.check_component(Elsewhere)


def test_a_state_that_counts_in_ticks_has_margins_but_no_model_in_time() -> None:
    class Late(Mass):
        """A mass under the command of the tick before."""

        kind = "late"
        states = ports("position", "velocity", "last")

        @staticmethod
        def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
            a = (60.0 * x.last + inp.load) * par.mobility_value
            v = x.velocity + clock.dt * a
            p = x.position + clock.dt * (x.velocity + 0.5 * clock.dt * a)
            return (p, v, inp.command), (p, v, a)

    assert Late(mass=20.0).linearize() is None and "linear model agrees with the step" not in cl.check_component(Late)
    late, controller = DelayedSaturation(delay=PERIOD), cl.AxisController(LAW)
    axes = cl.Axis("x", Late(mass=20.0)), cl.Axis("x", Mass(mass=20.0), drive=late)
    found, wanted = (sampled_loop(axis, controller, PERIOD).margins() for axis in axes)
    assert (found.gain, found.phase, found.modulus) == pytest.approx((wanted.gain, wanted.phase, wanted.modulus), rel=1e-9)


def test_it_is_checked_at_the_sub_steps_that_it_asks_for() -> None:
    class Stiff(Flexible):
        """An actuator too fast for one step."""

        kind = "stiff"
        example = {**Flexible.example, "bandwidth": 9000.0}

        def fewest_substeps(self, dt: float) -> tuple[int, str]:
            return int(np.ceil(np.max(dt * np.asarray(self.bandwidth)))), "the actuator"

    assert f"every parameter has an effect ({len(Stiff.parameters)})" in cl.check_component(Stiff)
    with refuses(ParameterError, "9", name="axes.x.substeps"):
        machine(Stiff(**Stiff.example))
    Stiff.fewest_substeps = lambda self, dt: 9  # type: ignore
    with pytest.raises(ComponentError, match="fewest_substeps returns 9"):
        machine(Stiff(**Stiff.example))


def test_the_load_has_the_sensor_of_a_plant_with_two_sides() -> None:
    class Turned(Flexible):
        """A plant whose table would have the scale of its motor."""

        kind = "turned"
        measured = "motor_position"

    with pytest.raises(ComponentError, match="leave out measured"):
        cl.check_component(Turned)


def test_axes_at_an_angle_need_the_moved_mass() -> None:
    lower, upper = cl.Axis("x", PLANT, substeps=4), cl.Axis("y", PLANT, mounted_on="x", stage_mass=9.0, substeps=4)
    assert cl.Machine("m", (lower, upper), PERIOD).loaded_plant("x").carried_mass == 9.0
    with refuses(ParameterError, "flexible", name="axes.y.alignment"):
        cl.Machine("m", (lower, replace(upper, alignment=0.1)), PERIOD)


def test_a_run_measures_what_the_plant_says() -> None:
    class Tilted(Mass):
        """A mass whose scale reads 1 % more."""

        kind = "tilted"
        measured = "scale"
        outputs = (*ports("position", "velocity", "acceleration", "scale"),)

        @staticmethod
        def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
            after, out = Mass.step(par, x, inp, clock)
            return after, (*out, 1.01 * out[0])

    controller = cl.Controller({"x": cl.AxisController(PID(proportional_gain=900.0, derivative_gain=30.0))})
    reached = [cl.simulate(machine(kind(mass=20.0)), controller, MOVE)["axis_position"][-1, 0] for kind in (Mass, Tilted)]
    assert reached[1] == pytest.approx(reached[0] / 1.01, rel=2e-3)


def test_feedback_from_the_motor_and_a_two_mass_agree() -> None:
    """With a fast actuator the plant is the shipped two-mass."""
    fast = PLANT.replace(bandwidth=2e4, drag=0.0)
    twin = TwoMass(mass=20.0, force_constant=50.0, resonance=40.0, load_share=0.6, damping_ratio=0.02)
    for side in ("load", "motor"):
        parts = replace(cl.AxisController(LAW), feedback=side, velocity_feedback=side)
        runs = [
            cl.simulate(cl.Machine("m", (cl.Axis("x", plant, substeps=50),), PERIOD), cl.Controller({"x": parts}), MOVE)
            for plant in (fast, twin)
        ]
        for name in ("position", "motor_position"):
            a, b = (run[name] for run in runs)
            assert np.abs(a - b).max() < 2e-3 * np.abs(b).max()
    assert link(fast, NoFriction()).outputs[-1].name == "motor_velocity"


class Chain(Mass):
    """Two masses as vectors, of a damping that is part of the structure."""

    kind = "chain"
    example = {"mass": 20.0, "damped": 3.0}
    states = (Port("places", 2), Port("speeds", 2))

    damped: float = cl.param(unit="1/s", minimum=0.0, structural=True, doc="of both")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, damped: float) -> Any:
        (p, q), (v, w), h = x.places, x.speeds, clock.dt
        pull = 900.0 * (q - p) + damped * (w - v)
        v, w = v + h * (60.0 * inp.command * par.mobility_value + pull), w + h * (inp.load * par.mobility_value - pull)
        return ((p + h * v, q + h * w), (v, w)), (q + h * w, w, (w - x.speeds[1]) / h)

    def at_rest(self, position: float) -> tuple[dict[str, Any], dict[str, Any]]:
        return {"places": (position, position)}, {"position": position}


def test_vectors_and_structure() -> None:
    assert len(cl.check_component(Chain)) == 6
    a = Chain(**Chain.example).linearize().a
    wanted = np.array([[0, 0, 1, 0], [0, 0, 0, 1], [-900, 900, -3, 3], [900, -900, 3, -3.0]])
    assert np.abs(a - wanted).max() < 1e-5 * 900.0  # its step is of first order
    found = run_alone(Chain(**Chain.example), {"command": np.full(300, 0.2)}, friction=FRICTIONS[0], substeps=4, jit=True)
    assert 0.0 < found["position"][-1] < 0.5 * 0.6 * 0.3**2


def test_a_run_is_the_exact_loop() -> None:
    """State feedback of the motor and a filter, around the matrices held over each period."""
    gains, keep = (90.0, 9.0), np.exp(-800.0 * PERIOD)
    law = cl.component("controller", "state-space")(d=(gains[0], -gains[0], gains[1], -gains[1]))
    smooth = cl.component("filter", "state-space")(a=(-800.0,), b=(800.0,), c=(1.0,), method="zero-order-hold")
    true = cl.component("velocity", "true")()
    parts = cl.AxisController(law, velocity=true, feedback="motor", velocity_feedback="motor", filters=(("smooth", smooth),))
    run = cl.simulate(cl.Machine("m", (cl.Axis("x", PLANT, substeps=100),), PERIOD), cl.Controller({"x": parts}), MOVE)
    ad, bd = held(*matrices(PLANT), PERIOD)
    block = MOVE.block(0, MOVE.n_sample)
    x, y, found = np.zeros(7), 0.0, []
    for r, rv in zip(block.position[:, 0], block.velocity[:, 0], strict=True):
        found.append(x[5])
        u = gains[0] * (r - x[3]) + gains[1] * (rv - x[4])
        x, y = ad @ x + bd[:, 0] * y, keep * y + (1.0 - keep) * u
    assert np.abs(run["axis_position"][:, 0] - found).max() < 1e-9 * 0.05


def test_a_load_that_pushes_nothing_ends_the_run() -> None:
    class Deaf(Mass):
        """A mass that no load reaches."""

        kind = "deaf"

        @staticmethod
        def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
            v = x.velocity + clock.dt * 60.0 * inp.command * par.mobility_value
            return (x.position + clock.dt * v, v), (x.position + clock.dt * v, v, 0.0)

    controller = cl.Controller({"x": cl.AxisController(LAW)})
    with pytest.raises(cl.DivergenceError, match="x"):
        cl.simulate(machine(Deaf(mass=20.0), friction=FRICTIONS[0]), controller, MOVE)
    with refuses(ParameterError, name="moving"):
        two = cl.Machine("m", tuple(cl.Axis(name, Chain(**Chain.example)) for name in "xy"), PERIOD)
        cl.simulate(two, cl.Controller(dict.fromkeys("xy", cl.AxisController(LAW))), MOVING, moving=True)
