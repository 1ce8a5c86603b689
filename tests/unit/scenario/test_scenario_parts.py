"""Parts in separate files, overrides, schemes, and writing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from refusals import refuses
from texts_of_scenarios import CONTROLLER, MACHINE, SCENARIO

from contourlab.components.controller.position import PositionController
from contourlab.components.friction.laws import Coulomb, NoFriction
from contourlab.components.registry import component, components
from contourlab.errors import ScenarioError
from contourlab.loop import Axis, AxisController, AxisError, Controller, Limits, Machine
from contourlab.loop.machine import CONTROLLER_SLOTS
from contourlab.scenario import (
    dump,
    load_axis,
    load_controller,
    load_machine,
    load_scenario,
    parse_scenario,
    scenario_from_parts,
)

Write = Callable[..., Path]
AXIS = '[plant]\nkind = "rigid-axis"\ngain = "2 m/s^2/full_scale"\n[friction]\nkind = "coulomb"\ncoulomb = "0.1 full_scale"\n'


def test_values_come_out_in_si() -> None:
    scenario = parse_scenario(SCENARIO)
    x, y = scenario.machine.axes
    assert x.plant.values() == {"gain": 1.695, "damping": 10.0}
    assert isinstance(x.friction, NoFriction) and y.friction == Coulomb(coulomb=0.05)
    assert (y.mounted_on, scenario.machine.servo_period) == ("x", 1e-3)
    assert x.limits == Limits(velocity=0.15, acceleration=1.0)
    gains = PositionController(position_gain=4000.0, velocity_gain=100.0)
    assert scenario.controller.axes["x"] == AxisController(gains)
    assert scenario.controller.axes["y"].observer is not None
    assert (scenario.base.run.tolerance, scenario.base.feed.frequency, scenario.base.feed.laps) == (2e-5, 0.5, 2)


def test_a_reference_follows_from_a_case() -> None:
    case = parse_scenario(SCENARIO).cases()[0]
    reference = case.reference()
    assert (reference.n_sample, reference.servo_period) == (4000, 1e-3)
    t = np.arange(4000) * 1e-3
    circle = 0.02 * np.column_stack([np.cos(np.pi * t), np.sin(np.pi * t)])
    np.testing.assert_allclose(reference.block(0, 4000).position, circle, atol=1e-12)
    assert case.reference(0.5).n_sample == 8000
    assert reference.laps == ((0, 2000), (2000, 4000))
    assert replace(case, run=replace(case.run, judge="all")).reference().judged.basis == "whole motion"


def test_a_planned_contour_respects_the_limits() -> None:
    text = SCENARIO.replace('law = "uniform"\nfrequency = "0.5 Hz"', 'feedrate = "3 m/min"')
    reference = parse_scenario(text).cases()[0].reference()
    block = reference.block(0, reference.n_sample)
    assert block.feedrate.max() == pytest.approx(0.05, rel=1e-9)
    assert np.abs(block.acceleration).max() <= 1.0 + 1e-9
    slower = parse_scenario(text.replace("laps = 2", "laps = 2\noverride = 0.5")).cases()[0].reference()
    assert slower.block(0, slower.n_sample).feedrate.max() == pytest.approx(0.025, rel=1e-9)


def test_several_machines_may_include_and_override_one_axis_file(written: Write) -> None:
    written(axis=AXIS)
    head = '[machine]\nname = "m"\nservo_period = "1 ms"\naxes = ["a", "b"]\n'
    file = written(m=head + '[axes]\na = "axis.toml"\n[axes.b]\nfile = "axis.toml"\nplant.damping = "3 1/s"\nfriction = "none"\n')
    a, b = load_machine(file).axes
    assert replace(load_axis(file.parent / "axis.toml", "a"), error=a.error) == a
    assert b.plant == a.plant.replace(damping=3.0) and isinstance(b.friction, NoFriction)


def test_file_names_are_relative_to_the_file_that_contains_them(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "axis.toml").write_text(AXIS)
    (tmp_path / "parts" / "m.toml").write_text('[machine]\nname = "m"\nservo_period = "1 ms"\naxes = ["x"]\n[axes]\nx = "axis.toml"\n')
    (tmp_path / "top.toml").write_text('machine = "parts/m.toml"\n')
    assert load_machine(tmp_path / "top.toml").axes[0].plant.values()["gain"] == 2.0


def test_an_axis_overrides_the_shared_table_and_the_shared_table_an_included_file(written: Write) -> None:
    own = '[controller.axes.x.controller]\nposition_gain = "9 full_scale/mm"\n'
    file = written(c=CONTROLLER.replace("[controller.axes.y.observer]", own + "[controller.axes.y.observer]"))
    machine = load_machine(written(m=MACHINE))
    gains = {name: part.controller.values()["position_gain"] for name, part in load_controller(file, machine).axes.items()}
    assert gains == {"x": 9000.0, "y": 4000.0}
    top = '[controller]\nfile = "c.toml"\n[controller.axes."*".controller]\nposition_gain = "1 full_scale/mm"\n'
    over = load_controller(written(over=top), machine)
    assert {a.controller.values()["position_gain"] for a in over.axes.values()} == {1000.0}
    assert {a.controller.values()["velocity_gain"] for a in over.axes.values()} == {100.0}


def test_schemes_change_only_what_they_name() -> None:
    text = (
        SCENARIO
        + """
    [schemes.base]
    [schemes."no observer"]
    controller.axes.y.observer = "none"
    [schemes.coupled]
    controller.coupling.weight = 0.9
    [schemes.alone]
    controller.coupling = "none"
    controller.estimator = "none"
    [schemes.lugre]
    axes.y.friction = {kind = "smooth-coulomb", coulomb = "0.05 full_scale", breakaway = "0.06 full_scale", smoothing_velocity = "0.1 mm/s"}
    [schemes.slow]
    feed.frequency = "0.25 Hz"
    run.tolerance = "default"
    [schemes.every]
    axes."*".sensor = "ideal"
    controller.axes."*".controller.position_gain = "2 full_scale/mm"
    """
    )
    scenario = parse_scenario(text)
    assert [case.name for case in scenario.cases()] == ["base", "no observer", "coupled", "alone", "lugre", "slow", "every"]
    base = scenario.case("base")
    assert dump(scenario.machine) == dump(base.machine) and base.controller == scenario.controller
    assert scenario.case("no observer").controller == replace(
        base.controller, axes={**base.controller.axes, "y": replace(base.controller.axes["y"], observer=None)}
    )
    assert scenario.case("coupled").controller.coupling == base.controller.coupling.replace(weight=0.9)  # type: ignore[union-attr]
    assert scenario.case("alone").controller == replace(base.controller, estimator=None, coupling=None)
    assert scenario.case("lugre").machine.axes[1].friction.kind == "smooth-coulomb"
    assert scenario.case("slow").reference().n_sample == 8000 and scenario.case("slow").tolerance is None
    assert {axis.sensor.kind for axis in scenario.case("every").machine.axes} == {"ideal"}
    assert {c.controller.values()["position_gain"] for c in scenario.case("every").controller.axes.values()} == {2000.0}
    with pytest.raises(ScenarioError, match="'best'"):
        scenario.case("best")


def test_a_scheme_can_swap_a_file(written: Write) -> None:
    written(m=MACHINE, c=CONTROLLER, axis=AXIS, c2=CONTROLLER.replace("weight = 0.5", "weight = 0.1"))
    head = 'machine = "m.toml"\ncontroller = "c.toml"\ncontour = "circle"\nfeed = {law = "uniform", frequency = "1 Hz"}\n'
    file = written(
        s=head
        + '[schemes.other]\ncontroller = "c2.toml"\n[schemes.swapped]\naxes.y.file = "axis.toml"\n'
        + '[schemes.stage]\nmachine = "builtin:ghaffari/a3a1"\n'
        'controller = "builtin:ghaffari/calibrated"\n'
    )
    scenario = load_scenario(file)
    assert scenario.case("other").controller.coupling.values() == {"weight": 0.1}  # type: ignore[union-attr]
    swapped = scenario.case("swapped").machine.axes[1]
    assert swapped.plant.values()["gain"] == 2.0 and swapped.mounted_on == ""
    assert scenario.case("stage").machine.axis_names == ("1", "3")
    again = parse_scenario(dump(scenario))
    assert [dump(c.machine) for c in again.cases()] == [dump(c.machine) for c in scenario.cases()]
    assert [c.controller for c in again.cases()] == [c.controller for c in scenario.cases()]


def test_poles_are_placed_for_the_model_that_the_loop_sees() -> None:
    poles = 'gains = {natural_frequency = "25 rad/s", damping = 0.7, pole = "35 rad/s"}'
    text = SCENARIO.replace('position_gain = "4 full_scale/mm"\nvelocity_gain = "0.1 full_scale*s/mm"', poles)
    found = parse_scenario(text).controller
    # x has no observer: its plant; y has one: the observer's model.
    assert found.axes["x"].controller.values() == PositionController(**PositionController.place(25.0, 0.7, 35.0, 1.695, 10.0)).values()
    assert found.axes["y"].controller.values() == PositionController(**PositionController.place(25.0, 0.7, 35.0, 1.0, 0.0)).values()
    told = text.replace(poles, poles + '\nmodel_gain = "0.5 m/s^2/full_scale"\nmodel_damping = "7 1/s"')
    wanted = PositionController(**PositionController.place(25.0, 0.7, 35.0, 0.5, 7.0))
    assert {a.controller for a in parse_scenario(told).controller.axes.values()} == {wanted}
    both = text.replace(poles, poles + '\nposition_gain = "4 full_scale/mm"')
    with refuses(ScenarioError, "gains = ", key='controller.axes."*".controller.position_gain'):
        parse_scenario(both)
    with pytest.raises(ScenarioError, match="pole"):
        parse_scenario(text.replace(', pole = "35 rad/s"', ""))
    with pytest.raises(ScenarioError, match="model_damping = 500"):
        parse_scenario(told.replace("7 1/s", "500 1/s"))
    changed = parse_scenario(text + '[schemes.a]\ncontroller.axes.x.controller.position_gain = "4 full_scale/mm"\n').cases()[0]
    assert changed.controller.axes["x"].controller == found.axes["x"].controller.replace(position_gain=4000.0)


def test_carried_mass_counts_in_pole_placement() -> None:
    text = (
        '[machine]\nname = "m"\nservo_period = "1 ms"\naxes = ["x", "y"]\n'
        '[axes."*".plant]\nkind = "mass-damper"\nmass = "10 kg"\nforce_constant = "20 N/A"\n'
        '[axes.y]\nmounted_on = "x"\nstage_mass = "30 kg"\n'
        '[controller.axes."*".controller]\nkind = "position"\n'
        'gains = {natural_frequency = "50 rad/s", damping = 0.7, pole = "50 rad/s"}\n'
        '[contour]\nname = "circle"\n[feed]\nlaw = "uniform"\nfrequency = "0.5 Hz"\n'
    )
    axes = parse_scenario(text).controller.axes
    assert axes["x"].controller.values()["model_gain"] == pytest.approx(20.0 / 40.0, rel=1e-15)
    assert axes["y"].controller.values()["model_gain"] == pytest.approx(20.0 / 10.0, rel=1e-15)


def test_parts_need_no_scenario_file(written: Write, tmp_path: Path) -> None:
    machine, controller = written(m=MACHINE), written(c=CONTROLLER)
    feed = {"law": "uniform", "frequency": "0.5 Hz"}
    found = scenario_from_parts(None, machine, controller, contour={"name": "circle"}, feed=feed, run={"tolerance": "1 um"}, name="n")
    assert (found.name, found.base.run.tolerance, found.cases()[0].name) == ("n", 1e-6, "base")
    shipped = scenario_from_parts("builtin:programs/circle_diamond_square.ngc", "xyz", "xyz-controller")
    assert shipped.machine.axis_names == ("x", "y", "z")
    assert load_machine(written(s=SCENARIO)).name == "stage"


@pytest.mark.parametrize("kind", components(), ids=lambda k: f"{k.family}-{k.kind}")
def test_every_component_is_written_and_read_back(kind: type, written: Write) -> None:
    part = kind(**kind.example)
    usual = component("plant", "step-drive" if kind.command_unit == "m" else "ball-screw")
    plant = part if kind.family == "plant" else usual(**usual.example)
    slots = {"friction", "drive", "sensor", "disturbance"} & {kind.family}
    machine = Machine("m", (Axis("x", plant, **dict.fromkeys(slots, part), substeps=8), Axis("y", plant, substeps=8)), 1e-3)
    mine = {kind.family: part} if kind.family in CONTROLLER_SLOTS else {}
    if kind.family == "predictor":  # with it the velocity must come from the predicted position
        mine["velocity"] = component("velocity", "filtered-difference")(bandwidth=800.0)
    if kind.family == "supervisor":
        mine["others"] = tuple((f"number_{i}", AxisController().controller) for i in range(1, part.n_controller))
    top = {"estimator": component("estimator", "newton")()} if kind.family == "coupling" else {}
    top |= {kind.family: part} if kind.family in ("estimator", "coupling") else {}
    controller = Controller({"x": AxisController(**mine), "y": AxisController()}, **top)
    read = load_machine(written(m=dump(machine)))
    assert [a.plant for a in read.axes] == [a.plant for a in machine.axes]
    for slot in ("friction", "drive", "sensor", "disturbance"):
        assert getattr(read.axes[0], slot) == getattr(machine.axes[0], slot)
    assert load_controller(written(c=dump(controller, machine)), read) == controller


def test_everything_about_a_machine_is_written(written: Write) -> None:
    axis = replace(load_axis("builtin:ghaffari/axis1"), plant=component("plant", "mass-damper")(mass=7.0, force_constant=55.0 / 3.0))
    error = AxisError(np.array([-0.1, 0.0, 0.1 / 3.0]), np.array([1e-6, 0.0, -2e-6 / 3.0]), 2e-6)
    limits = Limits(0.15, 1.0 / 3.0, 40.0, 1e-3, (-0.1, 0.1 / 7.0))
    first = replace(axis, name="a", error=error, limits=limits, substeps=3, stage_mass=1.0 / 3.0)
    second = replace(axis, name="b", mounted_on="a", alignment=0.25, stage_mass=2.0)
    machine = Machine('odd "name" \\ \t\x7f ü', (first, second), 1e-3 / 3.0, {("a", "b"): 2e-5 / 3.0})
    read = load_machine(written(m=dump(machine)))
    assert (read.name, read.servo_period, read.squareness) == (machine.name, machine.servo_period, machine.squareness)
    for one, other in zip(read.axes, machine.axes, strict=True):
        assert np.array_equal(one.error.position, other.error.position) and np.array_equal(one.error.lead_error, other.error.lead_error)
        assert one.error.repeatability == other.error.repeatability
        assert replace(one, error=other.error) == other
    alone = load_axis(written(axis=dump(first)), "a")
    assert replace(alone, error=first.error) == first
    with pytest.raises(TypeError):
        dump(Controller({}))
    with pytest.raises(TypeError):
        dump(3)  # type: ignore[arg-type]


def test_local_names_parameters_of_the_axis_controller() -> None:
    text = SCENARIO.replace(
        "[controller.axes.y.observer]", '[controller.axes.y]\nlocal = ["observer.model_gain"]\n[controller.axes.y.observer]'
    )
    scenario = parse_scenario(text)
    assert scenario.controller.axes["y"].local == ("observer.model_gain",)
    assert parse_scenario(dump(scenario)).controller == scenario.controller
    with pytest.raises(ScenarioError, match=r"observer\.model_gain"):
        parse_scenario(text.replace("observer.model_gain", "observer.model_gian"))


def test_a_plug_in_may_be_loaded_twice(written: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # Other tests must not see what is registered here.
    monkeypatch.setattr("contourlab.components.registry._plugins", {})
    monkeypatch.setattr("contourlab.scenario.load._loaded", set())
    plugin = tmp_path / "gentle_friction.py"
    plugin.write_text(
        "from contourlab.components.contract import Component, param\n\n\nclass Gentle(Component):\n"
        '    family = "friction"\n    kind = "gentle-for-tests"\n    law = "smooth"\n'
        '    slope: float = param(unit="{force}*s/m", minimum=0.0, doc="slope")\n\n'
        "    @staticmethod\n    def force(par, v):\n        return par.slope * v\n"
    )
    text = MACHINE.replace('friction = "none"', 'friction = {kind = "gentle-for-tests", slope = "2 full_scale*s/m"}')
    file = written(m=text)
    with pytest.raises(ScenarioError, match="no friction"):
        load_machine(file)
    for _ in range(2):
        assert load_machine(file, plugins=[plugin]).axes[0].friction.values() == {"slope": 2.0}


def test_the_curvature_step_is_optional() -> None:
    """At 0 the motion stops wherever a line meets an arc, and takes longer."""

    def duration(step: str) -> float:
        text = f"""
        machine = "builtin:xyz"
        controller = "builtin:xyz-controller"
        contour = {{name = "racetrack", radius = "1 mm"}}
        feed = {{feedrate = "2000 mm/min"{step}}}
        """
        return parse_scenario(text).cases()[0].reference().duration

    assert duration(", curvature_step = 1.0") == duration("")
    assert duration("") < duration(", curvature_step = 0.25") < duration(", curvature_step = 0.0")
