"""The wizard: answers in other words, plausible ranges, guesses with ranges, questions on a terminal."""

from __future__ import annotations

import math
import tomllib
from dataclasses import replace

import pytest
from each import each
from made_controls import made_control

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.app.results import SAFETY
from contourlab.components.plant.plant import resonance_of
from contourlab.controls import control_file
from contourlab.errors import OutputError, ScenarioError
from contourlab.features.check.program_check import origin_of
from contourlab.features.machines.answers import BLANK, PRESETS, answers_text, interview, of_control, preset_answers, read_answers
from contourlab.features.machines.new_machine import new_machine, write_machine
from contourlab.rendering.origins import numbers_of_machine
from contourlab.scenario import load_controller, load_machine
from contourlab.units import to_si

ROUTER = """
name = "Router 3ax"
axes = ["x", "y", "z"]
servo_period = "1 ms"
[x]
rated_torque = "1.27 N*m"
peak_torque = "3.8 N*m"
torque_constant = "0.47 N*m/A"
rotor_inertia = "0.3 kg*cm^2"
screw_inertia = "0.3 kg*cm^2"
lead = "16 mm"
moved_mass = "40 kg"
encoder_resolution = "1.6 um"
velocity = "0.25 m/s"
acceleration = "3 m/s^2"
jerk = "40 m/s^3"
kv = "30 1/s"
[y]
same_as = "x"
moved_mass = "60 kg"
[z]
same_as = "x"
moved_mass = "5 kg"
mounted_on = "y"
"""
TYPED = [
    *("x y z", "", "z on y", "", "1.27 Nm", "0.47 Nm/A", "0.3 kg cm²", "16", "40", "2500 x 4", "15", "3", "", "30"),
    *("", "60", "", "5", "", "", ""),
]
"""Typed answers for the same machine: an empty line takes the default."""


def answers(text: str = ROUTER) -> dict[str, str]:
    tables = tomllib.loads(text)
    flat = {key: value if isinstance(value, str) else ", ".join(value) for key, value in tables.items() if not isinstance(value, dict)}
    return flat | {f"{axis}.{key}": value for axis in "xyz" for key, value in tables.get(axis, {}).items()}


def asked_with(typed):
    """Return the answers of an interview, the keys asked and the remarks."""
    lines, keys, remarks = iter(typed), [], []

    def ask(question):
        keys.append(question.key)
        return next(lines)

    return interview(ask, remarks.append, new_machine), keys, remarks


@pytest.mark.parametrize(
    ("words", "metres"),
    [
        ("1.6 um", 1.6e-6), ("1.6", 1.6e-6), ("2500 x 4", 1.6e-6), ("2500 lines x 4", 1.6e-6), ("2500 lines/rev x 4", 1.6e-6),
        ("10000 counts per revolution", 1.6e-6), ("17 bit", 0.016 / 2**17), ("0.1 µm", 1e-7),
    ],
)  # fmt: skip
def test_an_encoder_in_several_words(words, metres):
    axis = new_machine(answers() | {"x.encoder_resolution": words}).axes[0]
    assert axis.encoder_resolution == pytest.approx(metres, rel=1e-12)


def test_a_grating_is_interpolated():
    stage = preset_answers("stage", {})
    assert new_machine(stage).axes[0].encoder_resolution == pytest.approx(50e-9)
    with pytest.raises(ScenarioError) as refused:
        new_machine(stage | {"x.encoder_resolution": "2500 x 4"})
    assert refused.value.key == "x.encoder_resolution"


@each(
    "key, value",
    [
        ("x.encoder_resolution", "2.5 mm"), ("x.lead", "1 parsec"), ("x.lead", "16 m"), ("x.unbalanced_mass", "40 kg"),
        ("x.moved_mass", "-40 kg"), ("x.moved_mass", "nan kg"), ("x.moved_mass", "40 mm"), ("x.peak_torque", "1 Nm"), ("x.kv", "1500 1/s"),
        ("x.kv", "30 Hz"), ("x.bandwidth", "1 kHz"), ("x.acceleration", "60 m/s^2"), ("z.unbalanced_mass", "6 kg"), ("x.drive", "steam"),
        ("x.rated_force", "20 N"), ("x.led", "16 mm"), ("led", "16 mm"), ("w.lead", "16 mm"), ("y.same_as", "x except led"),
        ("x.same_as", "y"), ("z.mounted_on", "z"), ("z.mounted_on", "w"), ("axes", "x, X"), ("mounting", "y under z"),
        ("servo_period", "1 s"), ("y.same_as", "y"), ("mounting", "y on z"), ("tolerance", "3 kg"), ("x.rated_torque", ""),
    ],
)  # fmt: skip
def test_an_answer_that_no_machine_has_is_refused_by_its_key(key, value):
    with pytest.raises(ScenarioError) as refused:
        new_machine(answers() | {key: value})
    assert refused.value.key in (key, "y.same_as", "z.mounted_on")
    assert "\n" not in refused.value.message


def test_an_implausible_answer_is_named_with_its_range():
    with pytest.raises(ScenarioError) as refused:
        new_machine(answers() | {"x.encoder_resolution": "2.5 mm"})
    assert all(word in refused.value.message for word in ("2.5 mm", "1e-05", "100 um"))


def test_an_unknown_key_gets_the_nearest_and_all():
    with pytest.raises(ScenarioError) as refused:
        new_machine(answers() | {"x.led": "16 mm"})
    assert "'lead'" in refused.value.message
    assert "torque_constant" in refused.value.message


def test_only_one_axis_hangs():
    hanging = answers(ROUTER.replace('mounted_on = "y"', "")) | {"y.unbalanced_mass": "20 kg", "z.unbalanced_mass": "2 kg"}
    with pytest.raises(ScenarioError) as refused:
        new_machine(hanging)
    assert refused.value.key == "z.unbalanced_mass"


def test_every_guess_that_is_simulated_has_a_range(tmp_path):
    left_out = {"x.peak_torque", "x.screw_inertia", "x.lead", "x.encoder_resolution"}
    few = {key: text for key, text in answers().items() if key not in left_out}
    write_machine(new_machine(few), tmp_path)
    for axis in load_machine(tmp_path / "machine.toml").axes:
        parts = (axis.plant, axis.friction, axis.drive, axis.sensor)
        guesses = [name for part in parts for name, origin in part.origins.items() if origin.source == "assumed"]
        assert {"damping", "coulomb", "breakaway", "efficiency", "inertia", "lead", "limit", "resolution"} <= set(guesses)
        assert all(origin.span for part in parts for origin in part.origins.values() if origin.source == "assumed")


def test_a_repeated_axis_repeats_all_but_its_place():
    x, y, z = new_machine(answers() | {"z.unbalanced_mass": "5 kg"}).axes
    place = {"moved_mass", "stage_mass", "unbalanced_mass", "mounted_on", "friction", "damping"}  # guesses follow the mass
    same = {key: value for key, value in x.values.items() if key not in place}
    assert {key: value for key, value in z.values.items() if key not in place} == same
    assert (x.weight, y.weight, z.weight) == (0.0, 0.0, 49.05)
    assert (x.carried, y.carried, z.carried) == (0.0, 5.0, 0.0)


def test_a_router_takes_at_most_twenty_one_answers():
    given, keys, remarks = asked_with(TYPED)
    assert len(keys) == len(TYPED) <= 21
    assert not remarks
    by_file, by_hand = new_machine(answers()), new_machine(given)
    assert [axis.mass for axis in by_hand.axes] == [axis.mass for axis in by_file.axes]
    assert f"# {SAFETY}" in by_hand.files()["controller.toml"].splitlines()
    assert by_hand.files()["controller.toml"] == by_file.files()["controller.toml"].replace("Router 3ax", "My machine")


@pytest.mark.parametrize("typed", ["750, 60 cm, 120 mm", "750 mm, , 120"])
def test_the_travel_of_all_axes_is_one_question(typed):
    given, keys, _ = asked_with([*TYPED[:-2], typed, ""])
    made = new_machine(given)
    assert keys[-2] == "travel" and [axis.travel for axis in made.axes] == [0.75, 0.6 if "60" in typed else None, 0.12]
    assert new_machine(answers() | {"x.travel": "750 mm", "y.travel": "60 cm", "z.travel": "120"}).axes[1].travel == 0.6


@pytest.mark.parametrize("typed", ["750 mm", "750, 600, x", "750, 600, -1"])
def test_a_travel_that_does_not_fit_is_asked_again(typed):
    given, keys, remarks = asked_with([*TYPED[:-2], typed, "750, 600, 120", ""])
    assert [error.key for error in remarks] == ["travel"] and keys[-3:] == ["travel", "travel", "backlash"]
    assert [axis.travel for axis in new_machine(given).axes] == [0.75, 0.6, 0.12]


def test_back_returns_to_the_question_before():
    corrected = [*TYPED[:4], "12.7 Nm", "back", *TYPED[4:]]
    assert asked_with(corrected)[0] == asked_with(TYPED)[0]
    assert asked_with(["back", *TYPED])[0] == asked_with(TYPED)[0]


def test_what_does_not_fit_together_is_asked_again():
    fast = [*TYPED[:11], "20", *TYPED[12:]]  # 20 m/s^2 are too much for y, which repeats x
    given, keys, remarks = asked_with([*fast, "3"])
    assert [error.key for error in remarks] == ["y.acceleration"]
    assert keys[-1] == "y.acceleration"
    assert [axis.acceleration for axis in new_machine(given).axes] == [20.0, 3.0, 20.0]


def test_saved_answers_make_the_same_machine(tmp_path):
    for name in PRESETS:
        made = new_machine(preset_answers(name, {}))
        write_machine(made, tmp_path / name)
        again = new_machine(read_answers(tmp_path / name / "answers.toml"))
        assert again.files() == made.files()
        machine = load_machine(tmp_path / name / "machine.toml")
        assert all(axis.limits.extent == sized.travel > 0.0 for axis, sized in zip(machine.axes, made.axes, strict=True))


def test_a_template_misses_only_what_has_no_default(tmp_path):
    file = tmp_path / "answers.toml"
    file.write_text(answers_text(BLANK), encoding="utf-8")
    empty = [key for key, text in read_answers(file).items() if not text]
    motor = ("rated_torque", "torque_constant", "rotor_inertia")
    assert empty == [*(f"x.{key}" for key in motor), *(f"{axis}.moved_mass" for axis in "xyz")]
    filled = {**read_answers(file), **dict.fromkeys(empty, "1"), "x.torque_constant": "0.5"}
    assert new_machine(filled).axes[2].moved_mass == 1.0


def test_units_of_the_gains():
    x = new_machine(answers() | {"x.kv": "1.8 (m/min)/mm", "x.bandwidth": "40 Hz"}).axes[0]
    assert x.kv == pytest.approx(30.0)
    assert x.bandwidth_rate == pytest.approx(80.0 * math.pi, rel=2e-4)
    gains = tomllib.loads(new_machine(answers()).files()["controller.toml"])["controller"]["axes"]["x"]["controller"]["gains"]
    assert to_si(gains["bandwidth"], "rad/s") == pytest.approx(220.0)


def test_a_folder_is_no_toml_file(tmp_path):
    with pytest.raises(OutputError):
        write_machine(new_machine(answers()), tmp_path / "mill.toml")


@pytest.mark.slow
@pytest.mark.parametrize("drive", ["screw", "linear"])
def test_a_measured_resonance_gives_an_elastic_axis_with_a_notch(drive, tmp_path):
    """Measured on the assembled machine: the loaded axis rings at 60 Hz, and its proposed loop keeps 6 dB and 30 degrees."""
    given = answers() | {"x.resonance": "60 Hz"}
    if drive == "linear":
        given = {key: text for key, text in given.items() if not key.startswith("x.")} | {
            "x.drive": "linear", "x.rated_force": "300 N", "x.force_constant": "60 N/A", "x.moved_mass": "20 kg", "x.resonance": "60 Hz",
        }  # fmt: skip
    write_machine(new_machine(given), tmp_path / "made")
    machine = load_machine(tmp_path / "made" / "machine.toml")
    controller = load_controller(tmp_path / "made" / "controller.toml", machine)
    frequency, _ = resonance_of(machine.loaded_plant("x"))
    assert frequency == pytest.approx(60.0, rel=5e-3)
    part = controller.axes["x"]
    assert [notch.kind for _, notch in part.filters] == ["notch"]
    margins = sampled_loop(machine.axes[0], part, machine.servo_period, machine.carried_mass("x")).margins()
    assert 20.0 * math.log10(margins.gain) >= 5.9 and math.degrees(margins.phase) >= 29.5
    bare = replace(part, filters=())
    assert sampled_loop(machine.axes[0], bare, machine.servo_period, machine.carried_mass("x")).margins().gain < margins.gain


@pytest.mark.slow
@pytest.mark.parametrize("hertz", [20, 60])
def test_a_lower_resonance_gives_a_slower_loop(hertz):
    given = answers() | {"x.resonance": f"{hertz} Hz"}
    x = new_machine(given).axes[0]
    assert x.bandwidth <= 0.5 * hertz
    # A Kv that is given stays, where there are margins for it.
    assert new_machine(given | {"x.kv": "5 1/s"}).axes[0].kv == pytest.approx(5.0)


@pytest.mark.parametrize(
    ("key", "text"), [("x.resonance", "1900 Hz"), ("x.resonance", "500 Hz"), ("x.bandwidth", "1.8 (m/min)/mm"), ("x.resonance", "2 1/s/mm")]
)  # fmt: skip
def test_a_frequency_that_cannot_be_names_its_key(key, text):
    with pytest.raises(ScenarioError) as error:
        new_machine(answers() | {key: text})
    assert error.value.key == key


def test_other_words_for_speed_and_encoder():
    x = new_machine(answers() | {"x.velocity": "600 rpm", "x.encoder_resolution": "20 um / 400"}).axes[0]
    assert x.velocity == pytest.approx(10.0 * x.lead)
    assert x.encoder_resolution == pytest.approx(5e-8)


def test_a_guess_lies_in_the_middle_of_its_range(tmp_path):
    """Else the run of the guesses lies outside the interval of the machines that they permit."""
    write_machine(new_machine(answers()), tmp_path / "made")
    for number in numbers_of_machine(load_machine(tmp_path / "made" / "machine.toml")):
        if number.range is not None:
            assert number.value == pytest.approx(sum(number.range) / 2.0, rel=0.02), number.name


def test_the_guessed_friction_follows_rails_and_screw_not_the_motor():
    """A motor of three times the torque changes nothing; the measured table of a bench (93 kg, lead 10 mm, 103 N) is within the range."""
    weak, strong = (new_machine(answers() | {f"{axis}.rated_torque": f"{torque} N*m" for axis in "xyz"}) for torque in (1.0, 3.0))
    assert [axis.friction for axis in weak.axes] == [axis.friction for axis in strong.axes]
    heavy = new_machine(answers() | {"x.moved_mass": "93 kg", "x.lead": "10 mm", "x.acceleration": "1", "y.acceleration": "1"}).axes[0]
    stacked = new_machine(answers() | {"x.stage_mass": "200 kg", "z.stage_mass": "200 kg"}).axes  # the rails below bear them as well
    assert [after.friction > before.friction for after, before in zip(stacked, weak.axes, strict=True)] == [
        bool(axis.carried) for axis in stacked
    ]
    assert any(axis.carried for axis in stacked)
    low, high = heavy.span("friction", lambda axis: axis.friction, (0.2, 1.8))
    assert low < 103.0 < 154.0 < high


@each(
    "drive, more, kind, asked, not_asked",
    [
        ("stepper", {"holding_torque": "1.9"}, "stepper", "holding_torque", "kv"),
        ("step-drive", {}, "step-drive", "moved_mass", "kv"),
        ("velocity", {}, "ball-screw", "kv", "holding_torque"),
        ("linear", {"rated_force": "200"}, "mass-damper", "kv", "lead"),
    ],
)
def test_each_drive_has_its_questions_and_its_plant(drive, more, kind, asked, not_asked, tmp_path):
    typed = {
        "axes": "x", "x.drive": drive, "x.rated_torque": "1.3", "x.torque_constant": "0.5", "x.rotor_inertia": "0.5", "x.lead": "5",
        "x.moved_mass": "8", "x.force_constant": "60", "travel": "300 mm", "backlash": "20 um", **{f"x.{k}": v for k, v in more.items()},
    }  # fmt: skip
    keys = []

    def ask(question):
        keys.append(question.key)
        return typed.get(question.key, "")

    given = interview(ask, lambda error: pytest.fail(error.message), new_machine)
    assert f"x.{asked}" in keys and f"x.{not_asked}" not in keys and keys[-2:] == ["travel", "backlash"]
    folder = tmp_path / drive
    write_machine(new_machine(given), folder)
    machine = load_machine(folder / "machine.toml")
    (axis,) = machine.axes
    controller = load_controller(folder / "controller.toml", machine).axes["x"].controller
    assert (axis.plant.kind, axis.error.backlash, axis.limits.extent) == (kind, pytest.approx(20e-6), pytest.approx(0.3))
    assert controller.kind == ("steps" if drive.startswith("step") else "cascade")
    assert all(origin.span for origin in axis.plant.origins.values() if origin.source == "assumed")
    again = new_machine(read_answers(folder / "answers.toml"))
    assert again.files() == new_machine(given).files()


def test_what_stands_on_a_step_drive_loads_the_axis_below_it(tmp_path):
    servo = {"y.rated_torque": "1.3", "y.torque_constant": "0.5", "y.rotor_inertia": "0.5", "y.lead": "5", "y.moved_mass": "20"}
    drives = {"x.drive": "step-drive", "x.moved_mass": "3", "z.drive": "step-drive", "z.moved_mass": "4"}
    for y, mass in ((servo, 7.0), ({"y.drive": "step-drive", "y.moved_mass": "20"}, 0.0)):
        write_machine(new_machine({"mounting": "z on x, x on y", **drives, **y}), tmp_path, force=True)
        machine = load_machine(tmp_path / "machine.toml")
        assert [machine.carried_mass(name) for name in "xyz"] == [0.0, mass, 0.0]


@pytest.mark.parametrize("reader", ["linuxcnc", "grbl", "fluidnc"])
def test_from_a_control_only_what_its_file_lacks_is_asked(reader, tmp_path):
    file = made_control(tmp_path, reader)
    control = control_file(file)
    lead, keys = "5.08" if reader == "linuxcnc" else "8", []
    typed = {"x.holding_torque": "1.9", "x.rotor_inertia": "0.5", "x.lead": lead, "x.moved_mass": "8", "y.moved_mass": "20"}

    def ask(question):
        keys.append(question.key)
        return typed.get(question.key, "")

    known = of_control(control)
    given = interview(ask, lambda error: pytest.fail(error.message), new_machine, known)
    assert not set(keys) & set(known) and keys[1] == "x.drive" and not [key for key in keys if "velocity" in key or "travel" in key]
    write_machine(new_machine(given, "Made", control), tmp_path / "made", inputs=[file])
    machine, bare = load_machine(tmp_path / "made" / "machine.toml"), load_machine(file)
    for axis, read in zip(machine.axes, bare.axes, strict=True):
        assert (axis.limits, axis.drive) == (read.limits, read.drive) and axis.limits.origins == read.limits.origins
        assert axis.plant.kind == "stepper" and axis.plant.lead / (200.0 * axis.plant.microsteps) == pytest.approx(read.plant.pulse)
    assert not {"CL984", "CL988"} & {note.code for note in machine.control.findings}
    kinds = {name.partition(".")[2]: kind for name, kind in origin_of(machine)["origin"].items() if name.startswith("axes")}
    wanted = {"x.limits.velocity": "read", "x.plant.microsteps": "computed", "x.friction.coulomb": "guessed", "x.plant.mass": "datasheet"}
    assert wanted.items() <= kinds.items()


def test_a_servo_by_torque_does_not_fit_a_control_of_steps(tmp_path):
    known = of_control(control_file(made_control(tmp_path, "grbl")))
    with pytest.raises(ScenarioError) as refused:
        new_machine(known | {"x.drive": "screw", "x.moved_mass": "8"})
    assert refused.value.key == "x.drive"
    stepper = {"x.holding_torque": "1.9", "x.rotor_inertia": "0.5", "x.moved_mass": "8", "y.same_as": "x", "y.moved_mass": "8"}
    with pytest.raises(ScenarioError) as refused:  # 250 pulses per mm are 6.25 on a full step
        new_machine(known | stepper | {"x.lead": "5 mm"})
    assert refused.value.key == "x.lead"


def test_a_machine_from_a_control_reads_programs_as_the_control_does(tmp_path):
    """The start-up code blends and the unit is the inch, for the commands that plan and for those that read logs."""
    control = control_file(made_control(tmp_path, "linuxcnc"))
    given = of_control(control) | {
        "x.holding_torque": "1.9", "x.rotor_inertia": "0.5", "x.lead": "5.08", "x.moved_mass": "8", "y.same_as": "x", "y.moved_mass": "8",
    }  # fmt: skip
    write_machine(new_machine(given, "Made", control), tmp_path / "made")
    part = tmp_path / "part.ngc"
    part.write_text("G90 F30\nG1 X1\nG1 Y1\nM2\n", encoding="ascii")
    by_file, by_answers = (cl.check(part, machine=machine) for machine in (control.file, tmp_path / "made"))
    assert by_answers.box == by_file.box and by_answers.cycle_time == pytest.approx(by_file.cycle_time)
    assert not {"CL110", "CL984"} & {note.code for note in by_answers.findings}
