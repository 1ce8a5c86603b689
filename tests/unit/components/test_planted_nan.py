"""A NaN planted into each slot of a running loop: the engine must notice it and say when and where."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from component_rig import make

import contourlab as cl
from contourlab.components.contract import FAMILIES, Component
from contourlab.components.controller.position import PositionController
from contourlab.components.coupling.laws import ModifiedReference
from contourlab.components.disturbance.loads import SineLoad
from contourlab.components.drive.saturation import Saturation
from contourlab.components.estimator.newton import Newton
from contourlab.components.filter.biquad import Notch
from contourlab.components.friction.laws import Coulomb, LuGre, SmoothCoulomb
from contourlab.components.link.network import Network
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.plant import RigidAxis
from contourlab.components.sensor.encoder import Encoder
from contourlab.components.supervisor.switching import EstimatorBased
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.engine.step import Port, Step
from contourlab.loop import Division
from contourlab.primitives import exp, fabs, select

PERIOD = 1e-3
TICK = 57
SPEED = 0.02
INFINITY = math.inf


def rotten(condition: bool) -> float:
    """Return 0, or inf - inf where the condition holds."""
    return select(condition, INFINITY - INFINITY, 0.0)


observe, sense, differ, stop = DisturbanceObserver.step, Encoder.step, FilteredDifference.step, Notch.step


class RottenSensor(Encoder):
    kind = "rotten"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        _, out = sense(par, x, inp, clock)
        return (), (out[0] + rotten(clock.k >= TICK),)


class RottenLink(Network):
    kind = "rotten"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (x.newest, x.value, x.slope), (inp.sent + rotten(clock.k >= TICK),)

    def step_function(self) -> Any:
        return RottenLink.step


class RottenVelocity(FilteredDifference):
    kind = "rotten"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        state, out = differ(par, x, inp, clock)
        return state, (out[0] + rotten(clock.k >= TICK),)


class RottenPredictor(Component):
    family, kind = "predictor", "rotten"
    inputs = (Port("position"), Port("applied"))
    outputs = (Port("position"),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.position + rotten(clock.k >= TICK),)


class RottenFilter(Notch):
    kind = "rotten"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        state, out = stop(par, x, inp, clock)
        return state, (out[0] + rotten(clock.k >= TICK),)


class RottenFeedforward(Component):
    family, kind = "feedforward", "rotten"
    inputs = (Port("reference"),)
    outputs = (Port("reference_shift"), Port("command"))

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (0.0, rotten(clock.k >= TICK))


class RottenCompensation(RottenFeedforward):
    family = "compensation"


class RottenGapObserver(Component):
    family, kind = "gap_observer", "rotten"
    inputs = (Port("motor_position"),)
    outputs = tuple(Port(name) for name in ("gap_state", "gap", "gap_deviation", "confidence", "load_position", "load_velocity"))

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (0.0, rotten(clock.k >= TICK), 0.0, 0.0, 0.0, 0.0)


class RottenSupervisor(EstimatorBased):
    kind = "rotten"
    inputs = (Port("position"),)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (x.active, x.since), (rotten(clock.k >= TICK), 0.0)


class RottenObserver(DisturbanceObserver):
    """The fault passes after one tick; its effect on the loop stays."""

    kind = "rotten"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        state, out = observe(par, x, inp, clock)
        return state, (out[0] + rotten(clock.k == TICK),)


class RottenController(PositionController):
    kind = "rotten"

    def step_function(self) -> Any:
        return RottenController.step

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        command = par.position_gain * (inp.reference - inp.position) + rotten(clock.k >= TICK)
        return (0.0, 0.0, command), (command,)


class RottenDrive(Saturation):
    kind = "rotten"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.command + rotten(clock.k >= TICK),)


class RottenLoad(SineLoad):
    kind = "rotten"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (rotten(clock.k >= TICK),)


class RottenCoupling(ModifiedReference):
    kind = "rotten"

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), ((inp.reference[0] + rotten(clock.k >= TICK), inp.reference[1]),)


class RottenEstimator(Newton):
    kind = "rotten"

    def path_step(self, view: Any, n_axis: int) -> Step:
        sound = super().path_step(view, n_axis)
        seek = sound.function

        def function(par: Any, x: Any, inp: Any, clock: Any) -> Any:
            state, out = seek(par, x, inp, clock)
            bad = rotten(clock.k >= TICK)
            return state, ((out[0][0] + bad, out[0][1]), out[1], out[2], out[3], out[4])

        return replace(sound, function=function)


class RottenPlant(RigidAxis):
    kind = "rotten"

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        return command + rotten(fabs(command) > 0.5)


class RottenSmooth(SmoothCoulomb):
    kind = "rotten-smooth"

    @staticmethod
    def force(par: Any, v: float) -> float:
        return par.coulomb * v + rotten(fabs(v) > SPEED)


class RottenSticking(Coulomb):
    kind = "rotten-sticking"

    @staticmethod
    def sliding(par: Any, speed: float) -> float:
        return par.coulomb + rotten(speed > SPEED)


class RottenBristle(LuGre):
    kind = "rotten-bristle"

    @staticmethod
    def level(par: Any, v: float) -> float:
        return par.coulomb + 0.0 * exp(v) + rotten(fabs(v) > SPEED)


LOAD, FRICTION = {"amplitude": 0.1, "frequency": 3.0}, {"coulomb": 0.05, "breakaway": 0.06}
PLANTED = [
    (RottenSensor(resolution=1e-7), 0),
    (RottenPredictor(), 0),
    (RottenVelocity(bandwidth=800.0), 0),
    (RottenFilter(frequency=200.0), 0),
    (RottenFeedforward(), 0),
    (RottenCompensation(), 0),
    (RottenGapObserver(), 0),
    (RottenSupervisor(), 0),
    (RottenObserver(model_gain=1.0, model_damping=6.0), 0),
    (RottenController(position_gain=100.0), 0),
    (RottenEstimator(), 0),
    (RottenCoupling(), 0),
    (RottenLink(), 0),
    # Faults after the commands reach the controllers and the position at the next tick.
    (RottenDrive(), 1),
    (RottenLoad(**LOAD), 1),
    (RottenPlant(gain=1.0, damping=6.0), None),
    (RottenSmooth(**FRICTION), None),
    (RottenSticking(**FRICTION), None),
    (RottenBristle(**FRICTION, stiffness=1e4), None),
]
NAMES = [type(part).__name__ for part, _ in PLANTED]


def loop_with(planted: Component | None) -> tuple[cl.Machine, cl.Controller]:
    """Return a machine with all slots filled, and the planted part in its slot of axis x."""
    family = planted.family if planted is not None else ""
    # A gap is observed only on a two-inertia drive.
    geared = make("plant", "two-inertia", motor_inertia=4e-3, mass=10.0, lead=0.02, stiffness=50.0, backlash_gap=2e-5)

    def axis(name: str) -> cl.Axis:
        parts: dict[str, Any] = {
            "plant": geared if family == "gap_observer" else make("plant", "rigid-axis", gain=1.0, damping=6.0),
            "friction": make("friction", "smooth-coulomb", **FRICTION),
            "drive": make("drive", "saturation"),
            "sensor": make("sensor", "encoder", resolution=1e-7),
            "disturbance": make("disturbance", "sine", **LOAD),
        }
        return cl.Axis(name, **{**parts, **({family: planted} if name == "x" and family in parts else {})}, substeps=4)

    def servo(name: str) -> cl.AxisController:
        parts: dict[str, Any] = {
            "controller": make("controller", "position", velocity_gain=70.0, position_gain=2800.0, integral_gain=12.0),
            "velocity": make("velocity", "filtered-difference", bandwidth=800.0),
            "observer": make("observer", "disturbance-observer", model_gain=1.0, model_damping=6.0),
        }
        parts |= dict.fromkeys(("predictor", "feedforward", "compensation", "gap_observer", "supervisor"))
        if name == "x" and family == "link":
            return cl.AxisController(**parts, link=Division("observer", planted, planted))
        if name == "x" and family == "filter":
            return cl.AxisController(**parts, filters=(("rotten", planted),))
        if name == "x" and family == "supervisor":
            parts["others"] = (("other", parts["controller"]),)
        return cl.AxisController(**{**parts, **({family: planted} if name == "x" and family in parts else {})})

    contour = {"estimator": make("estimator", "newton"), "coupling": make("coupling", "modified-reference", weight=0.5)}
    contour |= {family: planted} if family in contour else {}
    return cl.Machine("stage", (axis("x"), axis("y")), PERIOD), cl.Controller({"x": servo("x"), "y": servo("y")}, **contour)


@pytest.fixture(scope="module")
def circle() -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=0.02), 1.0, 1, PERIOD)


def test_every_family_is_planted() -> None:
    assert {part.family for part, _ in PLANTED} == set(FAMILIES) - {"learning"}


def test_without_a_planted_fault_the_loop_is_sound(circle: cl.Reference) -> None:
    result = cl.simulate(*loop_with(None), circle)
    assert result.status.ok
    assert all(np.isfinite(signal.data).all() for signal in result.signals.values())


@pytest.mark.parametrize(("planted", "late"), PLANTED, ids=NAMES)
def test_a_planted_nan_ends_the_run_at_its_place(planted: Component, late: int | None, circle: cl.Reference) -> None:
    result = cl.simulate(*loop_with(planted), circle, on_failure="return")
    assert not result.status.ok
    assert "not finite" in result.status.reason
    assert result.status.axis == "x"
    if late is not None:
        assert result.status.sample == TICK + late
    before = result.status.sample - 1
    assert result.n_sample == result.status.sample + 1
    assert all(np.isfinite(signal.data[:before]).all() for signal in result.signals.values())
    with pytest.raises(cl.DivergenceError, match="not finite"):
        cl.simulate(*loop_with(planted), circle)


@pytest.mark.parametrize("planted", [part for part, late in PLANTED if late is None], ids=NAMES[-4:])
def test_a_friction_that_turns_nan_ends_the_run_at_its_trigger(planted: Component, circle: cl.Reference) -> None:
    """A command or a speed triggers these; at the end the trigger must have been passed, and not before."""
    result = cl.simulate(*loop_with(planted), circle, on_failure="return")
    signal, limit = ("applied_command", 0.5) if planted.family == "plant" else ("axis_velocity", SPEED)
    seen = np.abs(result[signal][: result.status.sample, 0])
    # The velocity may become NaN one tick before the position.
    seen = seen[np.isfinite(seen)]
    assert result.status.sample - 1 <= seen.size <= result.status.sample
    assert not (seen[:-1] > limit).any()
    assert seen[-1] > (limit if planted.family == "plant" else 0.8 * limit)


LANES = (RottenController, RottenEstimator, RottenLoad, RottenPlant, RottenSticking)


@pytest.mark.parametrize("planted", [part for part, _ in PLANTED if isinstance(part, LANES)], ids=lambda part: part.kind)
def test_lanes_notice_a_nan_too(planted: Component, circle: cl.Reference) -> None:
    single = cl.simulate(*loop_with(planted), circle, on_failure="return").status
    batch = cl.simulate_batch(*loop_with(planted), circle, {"axes.y.plant.gain": np.linspace(0.9, 1.1, 3)})
    assert batch.failed_at.tolist() == [single.sample] * 3
    assert np.isnan(batch.figures["contour_error_rms"]).all()
