"""Every error in a file names file, key and remedy."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from refusals import refuses
from texts_of_scenarios import CONTROLLER, MACHINE, SCENARIO

from contourlab.errors import ContourlabError, ProgramError, ScenarioError
from contourlab.scenario import load_axis, load_controller, load_machine, load_scenario, parse_scenario, scenario_from_parts

Write = Callable[..., Path]

FAULTS = [
    ('kind = "rigid-axis"\ngain = "1695', 'kind = "rigid-axes"\ngain = "1695', "axes.x.plant.kind", "'rigid-axis'"),
    ('damping = "10 1/s"', 'dampng = "10 1/s"', "axes.x.plant.dampng", "'damping'"),
    ('damping = "10 1/s"', 'backlash_gap = "20 um"', "axes.x.plant.backlash_gap", '"two-inertia", and add motor_inertia'),
    ('damping = "10 1/s"', 'resonance = "50 Hz"', "axes.x.plant.resonance", '"two-mass"'),
    ('damping = "10 1/s"', "damping = 10", "axes.x.plant.damping", "no unit"),
    ('damping = "10 1/s"', 'damping = "10 mm"', "axes.x.plant.damping", "converted"),
    ('damping = "10 1/s"', 'damping = "-1 1/s"', "axes.x.plant.damping", ">= 0 1/s"),
    ('damping = "10 1/s"', 'damping = "10 Hz"', "axes.x.plant.damping", "62.8319"),
    ('damping = "10 1/s"', "damping = nan", "axes.x.plant.damping", "finite"),
    ('gain = "1695 mm/s^2/full_scale"', 'gain = "0 mm/s^2/full_scale"', "axes.x.plant.gain", "> 0 mm/s^2/full_scale"),
    ('gain = "1695 mm/s^2/full_scale"\n', "", "axes.x.plant", "gain [mm/s^2/full_scale]"),
    ('friction = "none"', 'friction = "coulom"', "axes.x.friction", "'coulomb'"),
    ('friction = "none"', "friction = 3", "axes.x.friction", "kind"),
    ('friction = "none"', 'frction = "none"', "axes.x.frction", "'friction'"),
    ('axes = ["x", "y"]', 'axes = ["x", "x"]', "machine.axes", "twice"),
    ('axes = ["x", "y"]', "axes = []", "machine.axes", "empty"),
    ('axes = ["x", "y"]', 'axes = ["x", "z"]', "axes.y", "not listed"),
    ('axes = ["x", "y"]', 'axes = ["x", "y", "z"]', "machine.axes", "[axes.z]"),
    ('axes = ["x", "y"]', 'axes = ["x", "a b"]', "machine.axes", "letters"),
    ('axes = ["x", "y"]', 'axes = "xy"', "machine.axes", "list"),
    ('servo_period = "1 ms"', 'servo_period = "0 ms"', "machine.servo_period", "> 0"),
    ('servo_period = "1 ms"\n', "", "machine", "servo_period"),
    ('mounted_on = "x"', 'mounted_on = "q"', "axes.y.mounted_on", "no axis 'q'"),
    ('mounted_on = "x"', 'mounted_on = "y"', "axes.y.mounted_on", "itself"),
    ('mounted_on = "x"', 'stage_mass = "-3 kg"', "axes.y.stage_mass", ">= 0 kg"),
    ('mounted_on = "x"', 'mounted_on = "x"\nstage_mass = "3 kg"', "machine", "3 kg"),
    ('mounted_on = "x"', 'mounted_on = "x"\nalignment = 0.5', "machine", 'axes.y.alignment = 0.5: must be 0 with a "rigid-axis" plant'),
    ('mounted_on = "x"', "substeps = 0", "axes.y.substeps", "greater"),
    ('mounted_on = "x"', "substeps = 2.5", "axes.y.substeps", "whole number"),
    ('velocity = "150 mm/s"\nacceleration = "1 m/s^2"\n[axes.y]', 'travel = ["1 mm"]\n[axes.y]', "axes.x.limits.travel", "two positions"),
    (
        'velocity = "150 mm/s"\nacceleration = "1 m/s^2"\n[axes.y]',
        'travel = ["1 mm", "-1 mm"]\n[axes.y]',
        "axes.x.limits",
        "first",
    ),
    ('acceleration = "1 m/s^2"\n[axes.y]', 'acceleration = "1e160 m/s^2"\n[axes.y]', "axes.x.limits.acceleration", "<= 1e"),
    ('acceleration = "1 m/s^2"\n[axes.y]', 'jerk = "1e-200 m/s^3"\n[axes.y]', "axes.x.limits.jerk", ">= 1e-06"),
    ('velocity = "150 mm/s"\nacceleration = "1 m/s^2"\n[axes.y]', 'velocity = "1e300 m/s"\n[axes.y]', "axes.x.limits.velocity", "<= 6e"),
    ("weight = 0.5", "weight = 1.5", "controller.coupling.weight", "<= 0.99"),
    ("weight = 0.5", "weight = true", "controller.coupling.weight", "number"),
    ('kind = "newton"', 'kind = "newton"\niterations = 2.5', "controller.estimator.iterations", "whole number"),
    ('kind = "newton"', 'kind = "newton"\nstart = "cold"', "controller.estimator.start", "both, warm"),
    ('[controller.estimator]\nkind = "newton"\n', "", "controller.coupling", "estimator"),
    ('kind = "disturbance-observer"\n', "", "controller.axes.y.observer", "kind"),
    ("[controller.axes.y.observer]", "[controller.axes.z.observer]", "controller.axes.z", "no axis 'z'"),
    ('name = "circle"', 'name = "circel"', "contour.name", "'circle'"),
    ('radius = "20 mm"', 'radios = "20 mm"', "contour.radios", "'radius'"),
    ('radius = "20 mm"', 'radius = "0 mm"', "contour", "> 0"),
    ('radius = "20 mm"', "radius = 20", "contour.radius", "no unit"),
    ('radius = "20 mm"', 'radius = "1e30 mm"', "contour.radius", "100 m"),
    ('radius = "20 mm"', 'radius = "0.9 um"', "contour.radius", "100 m"),
    ('radius = "20 mm"', 'radius = "20 mm"\nclockwise = 3', "contour.clockwise", "counter-clockwise"),
    ('radius = "20 mm"', 'radius = "20 mm"\noffset = ["1 mm"]', "contour.offset", "axes x, y"),
    ('radius = "20 mm"', 'radius = "20 mm"\noffset = [1, 2]', "contour.offset", "no unit"),
    ('law = "uniform"', 'law = "unifrom"', "feed.law", "planned"),
    ('frequency = "0.5 Hz"', 'feedrate = "1 m/min"', "feed.feedrate", "frequency"),
    ('frequency = "0.5 Hz"\n', "", "feed", "frequency"),
    ("laps = 2", 'laps = 2\ncorner_tolerance = "5 um"', "feed.corner_tolerance", "blends"),
    ("laps = 2", 'laps = 2\nmerge_tolerance = "5 um"', "feed.merge_tolerance", "blends"),
    ("laps = 2", "laps = 0", "feed.laps", "greater"),
    ('tolerance = "20 um"', 'tolerance = "0 um"', "run.tolerance", "> 0 and"),
    ('tolerance = "20 um"', 'signals = ["positon"]', "run.signals", "'position'"),
    ('tolerance = "20 um"', "seed = -1", "run.seed", "greater"),
    ('name = "test"', "name = 3", "name", "text"),
    ('name = "test"', 'title = "test"', "title", "unknown key"),
    ('name = "test"', 'program = "part.ngc"', "", "delete one"),
    ("[run]", '[schemes."a".contour]\nname = "circle"\n[run]', "schemes.a.contour", "cannot change"),
    ("[run]", "[schemes.a.controller.couplin]\n[run]", "schemes.a.controller.couplin", "'coupling'"),
    ("[run]", '[schemes.a]\naxes.x.plant.gain = "1 kg"\n[run]', "schemes.a.axes.x.plant.gain", "converted"),
    ("[run]", "[schemes.a]\ncontroller = 3\n[run]", "schemes.a.controller", "file"),
    ("[run]", '[schemes.a]\nmachine = "no.toml"\n[run]', "schemes.a.machine", "no file"),
    ("[run]", '[schemes.a]\nmachine = "builtin:xyzz"\n[run]', "schemes.a.machine", "'xyz'"),
]


@pytest.mark.parametrize(("before", "after", "key", "word"), FAULTS)
def test_an_error_names_its_file_and_key(written: Write, before: str, after: str, key: str, word: str) -> None:
    assert before in SCENARIO
    file = written(part=SCENARIO.replace(before, after, 1))
    with pytest.raises(ScenarioError) as caught:
        load_scenario(file)
    assert caught.value.file == str(file)
    assert caught.value.key == key
    assert word in caught.value.message
    assert caught.value.exit_code == 2


def test_missing_keys_are_listed_together() -> None:
    with pytest.raises(ScenarioError, match=r"2 .*machine, controller$"):
        parse_scenario('[contour]\nname = "circle"')


def test_malformed_toml_names_its_line(written: Write) -> None:
    with pytest.raises(ScenarioError, match="line 3"):
        load_scenario(written(bad='name = "a"\n[machine]\naxes = ["x",,]\n'))


@pytest.mark.parametrize("content", [b"\xff\xfe", b"a = " + b"[" * 5000, b"a." * 5000 + b"b = 1", b"a = 1\na = 2", b"x" * 100_000, b""])
def test_a_file_of_another_format_is_a_scenario_error(tmp_path: Path, content: bytes) -> None:
    file = tmp_path / "odd.toml"
    file.write_bytes(content)
    with pytest.raises(ScenarioError):
        load_scenario(file)


def test_missing_files(tmp_path: Path) -> None:
    for reader in (load_scenario, load_machine, load_axis):
        for name in (tmp_path / "no.toml", tmp_path, "builtin:no-such", "builtin:../errors", "a\x00b"):
            with pytest.raises(ScenarioError):
                reader(name)


def test_a_shipped_scenario_without_its_prefix_is_suggested() -> None:
    with refuses(ScenarioError, "builtin:demo-part", file="demo-part"):
        load_scenario("demo-part")


def test_circular_includes_are_named(written: Write) -> None:
    written(a='machine = "b.toml"', b='machine = "a.toml"')
    with pytest.raises(ScenarioError, match=r"other, a\.toml -> b\.toml -> a\.toml"):
        load_machine(written(a='machine = "b.toml"'))
    itself = '[machine]\nname = "m"\nservo_period = "1 ms"\naxes = ["x"]\n[axes.x]\nfile = "m.toml"\n'
    with pytest.raises(ScenarioError, match=r"other, m\.toml -> m\.toml"):
        load_machine(written(m=itself))


def test_an_error_in_an_included_part_names_that_file(written: Write) -> None:
    written(machine=MACHINE.replace('coulomb = "0.05 full_scale"', 'coulomb = "5 N"'))
    rest = SCENARIO.replace(MACHINE, "").replace('name = "test"', 'name = "test"\nmachine = "machine.toml"')
    with pytest.raises(ScenarioError) as caught:
        load_scenario(written(part=rest))
    assert caught.value.file.endswith("machine.toml") and caught.value.key == "axes.y.friction.coulomb"


def test_a_file_of_the_wrong_kind_is_recognised(written: Write) -> None:
    controller = written(controller=CONTROLLER)
    with refuses(ScenarioError, "is a controller, not a machine", file=controller, key=""):
        load_machine(controller)
    machine = load_machine(written(machine=MACHINE))
    with refuses(ScenarioError, "is a machine, not a controller", key=""):
        load_controller(written(machine=MACHINE), machine)
    with refuses(ScenarioError, r"\[controller\.axes\.x\]", key=""):
        load_controller(written(none="# to do\n"), machine)
    with refuses(ScenarioError, "is a machine, not an axis", key=""):
        load_axis(written(machine=MACHINE))


def test_programs_are_checked_against_the_machine(written: Write, tmp_path: Path) -> None:
    machine, controller = written(m=MACHINE), written(c=CONTROLLER)
    part = tmp_path / "part.ngc"
    part.write_text("G1 X10 F600\nM2\n", encoding="ascii")
    ok = scenario_from_parts(part, machine, controller)
    assert ok.name == "part" and ok.cases()[0].lines == ("G1 X10 F600", "M2")
    for words, message in (
        ({"feed": {"feedrate": "1 m/min"}}, "override"),
        ({"feed": {"laps": 2}}, "once"),
        ({"feed": {"law": "uniform"}}, "planned"),
        ({"feed": {"override": 3.0}}, "<= 2"),
        ({"run": {"tolerance": 20}}, "no unit"),
    ):
        with pytest.raises(ScenarioError, match=message):
            scenario_from_parts(part, machine, controller, **words)  # type: ignore[arg-type]
    with refuses(ScenarioError, "No such file", file=tmp_path / "no.ngc"):
        scenario_from_parts(tmp_path / "no.ngc", machine, controller)
    part.write_text("G1 X10 F600 Q\nM2\n", encoding="ascii")
    with refuses(ProgramError, file=part, line=1):
        scenario_from_parts(part, machine, controller)
    part.write_text("G1 Z10 F600\nM2\n", encoding="ascii")
    with pytest.raises(ContourlabError, match="Z"):
        scenario_from_parts(part, machine, controller).cases()[0].reference()


def test_letters_can_map_to_axes_of_other_names() -> None:
    text = 'machine = "builtin:ghaffari/a3a1"\ncontroller = "builtin:ghaffari/calibrated"\n'
    program = 'file = "builtin:programs/circle_diamond_square.ngc"'
    with pytest.raises(ScenarioError, match="letters"):
        parse_scenario(text + f"[program]\n{program}")
    assert parse_scenario(text + f'[program]\n{program}\nletters = ["x", "y"]').motion.n_axis == 2
    for wrong in ('["x"]', '["x", "x"]', '["x", "w"]'):
        with pytest.raises(ScenarioError, match=r"letter|input"):
            parse_scenario(text + f"[program]\n{program}\nletters = {wrong}")


def test_the_path_cannot_have_more_axes_than_the_machine() -> None:
    with refuses(ScenarioError, "helix.* 3 .*stage.*x, y", key="contour.name"):
        parse_scenario(SCENARIO.replace('name = "circle"\nradius', 'name = "helix"\nradius'))
