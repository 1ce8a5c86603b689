"""Several controllers on one axis: bumpless hand-over, feedback from both sides of a drive, controller changes during a run."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from refusals import refuses

import contourlab as cl
from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.zone_law import ContactZone3, GapZone3
from contourlab.components.friction.laws import Coulomb
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.components.sensor.encoder import Encoder
from contourlab.components.supervisor.switching import EstimatorBased, Performance, PreRouted
from contourlab.errors import ParameterError
from contourlab.loop import Change

PERIOD, GAP = 1e-3, 20e-6
DRIVE = TwoInertia(motor_inertia=5.2e-3, load_inertia=4.4e-3, lead=0.016, stiffness=950.0, shaft_damping=0.05, backlash_gap=GAP)
RIGID = DRIVE.replace(backlash_gap=0.0)
GAINS = Cascade.tune(80.0, 0.9, *DRIVE.rigid_model(), 20.0)
SLOW = Cascade.tune(40.0, 0.9, *DRIVE.rigid_model(), 10.0)
SETUP: Any = {"feedback": "motor"}


def machine(plant: TwoInertia = DRIVE, **parts: Any) -> cl.Machine:
    axis = cl.Axis("x", plant, friction=Coulomb(coulomb=40.0), substeps=4, **parts)
    return cl.Machine("stage", (axis, replace(axis, name="y")), PERIOD)


def both(**parts: Any) -> cl.Controller:
    return cl.Controller(dict.fromkeys("xy", cl.AxisController(**{**SETUP, **parts})))


@pytest.fixture(scope="module")
def circle() -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=0.02), 1.0, 2, PERIOD)


def zones(handover_time: float = 0.0, **supervised: Any) -> cl.Controller:
    law: dict[str, Any] = {"lead": 0.016, "backlash_gap": GAP, "direction": "velocity", "integral_of": "flank"}
    wishes = {"natural_frequency": 60.0, "damping": 0.9, "pole": 15.0}
    parts = []
    for kind, inertia in ((ContactZone3, 9.6e-3), (GapZone3, 5.2e-3)):
        parts.append(kind(motor_inertia=inertia, **law, **kind.designed({**wishes, "inertia": inertia}, 1.0, 0.0)))
    supervisor = Performance(thresholds=(0.5 * GAP,), hysteresis=1e-6, handover_time=handover_time, **supervised)
    return both(controller=parts[0], others=(("gap", parts[1]),), supervisor=supervisor)


def test_a_supervised_controller_with_a_copy_runs_like_the_controller_alone(circle: cl.Reference) -> None:
    alone = cl.simulate(machine(), both(controller=Cascade(**GAINS)), circle)
    supervisor = Performance(thresholds=(0.5 * GAP,), handover_time=0.0)
    beside = cl.simulate(machine(), both(controller=Cascade(**GAINS), others=(("copy", Cascade(**GAINS)),), supervisor=supervisor), circle)
    assert np.count_nonzero(beside["switch_reason"]) > 4
    assert np.array_equal(alone["axis_position"], beside["axis_position"])


def test_a_command_does_not_jump_at_a_switch_with_hand_over(circle: cl.Reference) -> None:
    at, first = 0.02 * np.pi, Cascade(**GAINS)  # half of the circle
    slow = Cascade(**{**SLOW, "velocity_feedforward": 0.0})
    alone = cl.simulate(machine(), both(controller=first), circle)

    def jump(handover_time: float) -> float:
        """Return the difference at the switch between the command and that of the replaced controller."""
        supervisor = PreRouted(places=(at,), numbers=(1.0,), handover_time=handover_time)
        run = cl.simulate(machine(), both(controller=first, others=(("slow", slow),), supervisor=supervisor), circle)
        k = int(np.flatnonzero(run["switch_reason"][:, 0])[0])
        assert run["arc_length"][k - 1] < at <= run["arc_length"][k]
        return float(np.abs(run["command"][k] - alone["command"][k]).max())

    assert jump(0.02) < 1e-14
    assert jump(0.0) > 0.1


@pytest.mark.parametrize("handover_time", [0.0, 5e-3, 0.05])
def test_switching_to_a_copy_changes_nothing(handover_time: float, circle: cl.Reference) -> None:
    """With any anti-windup: the copy's integral has followed, and the hand-over correction does not count as a limit of the drive."""
    for words in ("hold", "back-calculation"):
        cascade = Cascade(**GAINS, anti_windup=words)
        supervisor = PreRouted(places=(0.01, 0.1, 0.2), numbers=(1.0, 0.0, 1.0), handover_time=handover_time)
        switched = both(controller=cascade, others=(("copy", cascade),), supervisor=supervisor)
        alone, beside = (cl.simulate(machine(), made, circle) for made in (both(controller=cascade), switched))
        assert np.count_nonzero(beside["switch_reason"][:, 0]) == 3
        # An inactive copy tracks the accepted command one tick late.
        np.testing.assert_allclose(beside["axis_position"], alone["axis_position"], rtol=0.0, atol=2e-6)


def test_contact_and_gap_controllers_switch_at_the_state_of_the_drive(circle: cl.Reference) -> None:
    run = cl.simulate(machine(), zones(), circle)
    assert run.status.ok
    apart = np.abs(run["motor_position"] - run["axis_position"])
    active = run["active_controller"]
    # The record holds what the supervisor saw in the same tick.
    assert (apart[active == 1] <= 0.5 * GAP + 1.0001e-6).all()
    assert (apart[active == 0] >= 0.5 * GAP - 1.0001e-6).all()
    assert 0.02 < active.mean() < 0.6


def test_plain_python_and_the_compiled_loop_agree_under_a_supervisor() -> None:
    short = cl.uniform(cl.contour("circle", radius=0.02), 2.0, 1, PERIOD)
    fast, plain = (cl.simulate(machine(), zones(2e-3), short, jit=jit) for jit in (True, False))
    for name in ("axis_position", "command", "active_controller", "gap_state"):
        assert fast[name] == pytest.approx(plain[name], rel=1e-9, abs=1e-11), name


def test_lanes_with_gaps_equal_single_runs(circle: cl.Reference) -> None:
    gaps = np.linspace(0.0, 60e-6, 7)
    names = [f"axes.{axis}.plant.backlash_gap" for axis in "xy"]
    found = cl.simulate_batch(machine(), zones(), circle, dict.fromkeys(names, gaps), keep=("axis_position",))
    assert (found.failed_at < 0).all()
    for i, gap in enumerate(gaps):
        alone = cl.simulate(machine(DRIVE.replace(backlash_gap=float(gap))), zones(), circle)
        np.testing.assert_allclose(found.signals["axis_position"][:, :, i], alone["axis_position"], rtol=0.0, atol=1e-8)


@pytest.mark.parametrize("feedback", ["motor", "load"])
def test_the_loop_uses_the_selected_side(feedback: str, circle: cl.Reference) -> None:
    sensors = {"sensor": Encoder(resolution=1e-6), "motor_sensor": Encoder(resolution=3e-6)}
    run = cl.simulate(machine(**sensors), both(controller=Cascade(**GAINS), feedback=feedback), circle)
    side, count = ("motor_position", 3e-6) if feedback == "motor" else ("axis_position", 1e-6)
    assert run["position"] == pytest.approx(count * np.rint(run[side] / count), abs=1e-12)
    assert np.array_equal(run["velocity"], run["motor_velocity"])


def test_without_a_gap_both_sides_of_a_stiff_drive_give_the_same_run(circle: cl.Reference) -> None:
    stiff = RIGID.replace(stiffness=9500.0, shaft_damping=1.0)
    made = [
        cl.simulate(
            cl.Machine("m", tuple(replace(a, substeps=16) for a in machine(stiff).axes), PERIOD),
            both(controller=Cascade(**GAINS), feedback=f),
            circle,
        )
        for f in ("motor", "load")
    ]
    assert made[0]["axis_position"] == pytest.approx(made[1]["axis_position"], abs=2e-6)


def test_a_moving_start_avoids_the_initial_transient(circle: cl.Reference) -> None:
    controller = both(controller=Cascade(**GAINS))
    still, moving = (cl.simulate(machine(RIGID), controller, circle, moving=m) for m in (False, True))
    error = {name: np.abs(run["reference"] - run["axis_position"])[:300].max() for name, run in (("still", still), ("moving", moving))}
    assert error["moving"] < 0.1 * error["still"]
    assert moving["axis_velocity"][0] == pytest.approx(circle.block(0, 1).velocity[0])


def test_a_supervisor_needs_matching_controllers() -> None:
    supervisor = Performance(thresholds=(1e-6,))
    with pytest.raises(ParameterError, match="supervisor"):
        cl.AxisController(others=(("gap", Cascade(**GAINS)),))
    with pytest.raises(ParameterError, match="supervisor"):
        cl.AxisController(supervisor=supervisor)
    with pytest.raises(ParameterError, match="chooses from 3"):
        cl.AxisController(supervisor=Performance(thresholds=(1e-6, 2e-6)), others=(("gap", Cascade(**GAINS)),))
    with pytest.raises(ParameterError, match="feedback"):
        cl.AxisController(feedback="table")


def test_an_estimator_based_supervisor_needs_a_gap_observer(circle: cl.Reference) -> None:
    controller = both(controller=Cascade(**GAINS), others=(("gap", Cascade(**GAINS)),), supervisor=EstimatorBased())
    with pytest.raises(ParameterError, match="gap_observer"):
        cl.simulate(machine(), controller, circle)


def test_a_motor_sensor_needs_a_drive_with_a_motor_side() -> None:
    from contourlab.components.plant.plant import RigidAxis

    axis = cl.Axis("x", RigidAxis(gain=1.0), motor_sensor=Encoder(resolution=1e-6))
    with pytest.raises(ParameterError, match="motor_sensor"):
        cl.Machine("m", (axis,), PERIOD)


# --- controller changes during a run -------------------------------------------------------------------------------------------------


def test_a_change_to_a_copy_changes_nothing(circle: cl.Reference) -> None:
    for controller in (both(controller=Cascade(**GAINS)), zones(2e-3)):
        alone = cl.simulate(machine(), controller, circle)
        changes = [Change(0.3, controller, 0.0), Change(0.3005, controller, 0.0), Change(1.2, controller, 0.0)]
        again = cl.simulate(machine(), controller, circle, changes=changes)
        assert again.n_sample == alone.n_sample == circle.n_sample
        for name in ("axis_position", "command"):
            assert np.array_equal(alone[name], again[name])


def test_a_change_of_controller_acts_at_its_sample_without_a_jump(circle: cl.Reference) -> None:
    first, second = both(controller=Cascade(**GAINS)), both(controller=Cascade(**{**SLOW, "velocity_feedforward": 0.0}))
    alone, k = cl.simulate(machine(), first, circle), 700
    made = {time: cl.simulate(machine(), first, circle, changes=[Change(0.6995, second, time)]) for time in (0.0, 0.02)}
    for run in made.values():
        assert run.n_sample == circle.n_sample
        assert np.array_equal(run["axis_position"][: k + 1], alone["axis_position"][: k + 1])
        assert not np.array_equal(run["command"][k + 20], alone["command"][k + 20])
    jumps = {time: np.abs(run["command"][k] - run["command"][k - 1]).max() for time, run in made.items()}
    assert jumps[0.02] < 1e-14 and jumps[0.0] > 0.1
    # The command against friction is carried over: slightly different gains give a slightly different motion.
    hair = both(controller=Cascade(**{**GAINS, "position_gain": 1.0001 * GAINS["position_gain"]}))
    near = cl.simulate(machine(), first, circle, changes=[Change(0.6995, hair, 0.01)])
    assert near["axis_position"] == pytest.approx(alone["axis_position"], abs=1e-6)
    # Finally both follow with the lag of the slow one: v/K_v.
    speed = 2.0 * np.pi * 0.02
    for run in made.values():
        lag = np.linalg.norm(run["reference"] - run["axis_position"], axis=1)[-200:]
        assert lag.mean() == pytest.approx(speed / 10.0, rel=0.25)


def test_a_change_after_the_end_is_ignored_and_two_at_one_sample_are_refused(circle: cl.Reference) -> None:
    controller = both(controller=Cascade(**GAINS))
    late = cl.simulate(machine(), controller, circle, changes=[Change(1e3, controller)])
    assert np.array_equal(late["command"], cl.simulate(machine(), controller, circle)["command"])
    with pytest.raises(ParameterError, match="changes"):
        cl.simulate(machine(), controller, circle, changes=[Change(0.5, controller), Change(0.4999, controller)])
    for time, handover in ((0.0, 0.0), (np.inf, 0.0), (1.0, -1.0)):
        with pytest.raises(ParameterError):
            Change(time, controller, handover)


def test_the_feedforward_from_both_sides_is_that_of_a_following_drive(circle: cl.Reference) -> None:
    """K_1 r_v' and similar terms cancel when the motor follows its reference: J r_a is left, for any sensor."""
    from contourlab.loop.trials import feedforward_command

    sensed = machine(motor_sensor=Encoder(resolution=1e-5), sensor=Encoder(resolution=1e-5))
    made = feedforward_command(sensed, zones(), circle)
    block = circle.block(0, circle.n_sample)
    assert made == pytest.approx(9.6e-3 * 2.0 * np.pi / 0.016 * block.acceleration, abs=1e-9)


def test_a_batch_refuses_a_shaft_that_its_substeps_cannot_follow(circle: cl.Reference) -> None:
    with refuses(ParameterError, r"\d+ .*variants", name="axes.x.substeps", value="4"):
        cl.simulate_batch(machine(), both(controller=Cascade(**GAINS)), circle, {"axes.x.plant.stiffness": [950.0, 1e6]})
