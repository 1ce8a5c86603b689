"""What every reader of a control's own file does: each on a file of its kind, whole and damaged."""

import random
from pathlib import Path

import pytest
from made_controls import FILES, made_control

from contourlab.controls import control_file, readers
from contourlab.errors import ContourlabError, ScenarioError
from contourlab.features.machines.command import shipped_one
from contourlab.file_kinds import kind_of
from contourlab.loop import Machine
from contourlab.rendering.origins import numbers_of_machine, stated
from contourlab.scenario import load_machine
from contourlab.scenario.load import reading_on


def loaded(file: Path) -> Machine:
    machine = load_machine(file)
    assert machine.control is not None
    return machine


def test_every_reader_has_a_file_here() -> None:
    assert readers().keys() == FILES.keys()


@pytest.mark.parametrize("reader", FILES)
def test_limits_travel_and_their_sources(tmp_path: Path, reader: str) -> None:
    """The three files describe axes of the same speeds, to 1e-12."""
    machine = loaded(made_control(tmp_path, reader))
    assert machine.axis_names == ("x", "y")
    for axis, velocity, length in zip(machine.axes, (0.0508, 0.0762), (0.254, 0.127), strict=True):
        assert axis.limits.velocity == pytest.approx(velocity, rel=1e-12)
        assert axis.limits.acceleration == pytest.approx(0.508, rel=1e-12)
        low, high = axis.limits.travel
        assert high - low == pytest.approx(length, rel=1e-12)
    sources = {number.name: number.source for number in stated(numbers_of_machine(machine))}
    assert sources["axes.x.limits.velocity"] == sources["axes.y.limits.travel"] == "control"
    assert sources["axes.x.plant.pulse"] == "computed"
    guesses = [number for number in stated(numbers_of_machine(machine)) if ".plant." in number.name and number.source == "assumed"]
    assert len(guesses) == 6 and all(" to " in number.deviation_text for number in guesses)
    assert [one.code for one in shipped_one(str(made_control(tmp_path, reader))).findings] == ["CL984"]


@pytest.mark.parametrize("reader", FILES)
def test_a_damaged_file_is_refused_with_its_place_or_read(tmp_path: Path, reader: str) -> None:
    """Cut, doubled and exchanged bytes and lines: an error of ours, or a machine; nothing else."""
    name, text = FILES[reader]
    rng, refused = random.Random(1), 0
    for k in range(150):
        i, j = sorted(rng.randrange(len(text)) for _ in range(2))
        damaged = [text[:i] + text[j:], text[:i] + rng.choice("\0:=[]-e9$#\n\u00e9") + text[i + 1 :], text[:j] + text[i:]][k % 3]
        file = tmp_path / name
        file.write_text(damaged, encoding="utf-8")
        try:
            machine = load_machine(file)
        except ContourlabError as error:
            refused += 1
            assert isinstance(error, ScenarioError) and str(error.file), error
        else:
            assert machine.axes
    assert 0 < refused < 150


@pytest.mark.parametrize(
    ("reader", "old", "new"),
    [
        ("linuxcnc", "MAX_VELOCITY = 2", "MAX_VELOCITY = fast"),
        ("linuxcnc", "MAX_VELOCITY = 2", "MAX_VELOCITY = -2"),
        ("linuxcnc", "trivkins", "genhexkins"),
        ("grbl", "$110=3048.000", "$110=0"),
        ("grbl", "$120=508.000", "$120=nan"),
        ("grbl", "$100=250.000", "$100=314,961"),
        ("grbl", "$11=0.010", "$22=on"),
        ("grbl", "$11=0.010", "$23=inf"),
        ("grbl", "$11=0.010", "$800=fast"),
        ("fluidnc", "3048", "[1, 2]"),
        ("fluidnc", "positive_direction: false", "positive_direction: 'false'"),
        ("fluidnc", "name: a router", "kinematics:\n  corexy:"),
        ("fluidnc", "  x:", "  x: {"),
    ],
)
def test_a_faulty_value_is_refused(tmp_path: Path, reader: str, old: str, new: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        load_machine(made_control(tmp_path, reader, (old, new)))
    assert FILES[reader][0] in str(caught.value)


def test_a_file_of_no_control_is_none(tmp_path: Path) -> None:
    for name, text in (("part.ngc", "G21\nG1 X1 F100\nM2\n"), ("settings.ini", "[editor]\ntab = 4\n"), ("plan.yaml", "jobs: [a]\n")):
        (tmp_path / name).write_text(text)
        assert control_file(tmp_path / name) is None
    assert control_file(tmp_path / "absent.ini") is None


@pytest.mark.parametrize(("more", "low"), [("", -0.254), ("$22=15\n$23=1\n", 0.0), ("$22=7\n$23=1\n", -0.254)])
def test_grblhal_may_have_its_zero_where_an_axis_homes(tmp_path: Path, more: str, low: float) -> None:
    machine = loaded(made_control(tmp_path, "grbl", ("ok\n", f"{more}ok\n")))
    assert machine.axes[0].limits.travel == pytest.approx((low, low + 0.254))


def test_a_part_program_with_settings_is_one(tmp_path: Path) -> None:
    (tmp_path / "part.nc").write_text("$H\n$110=500\nG21\nG1 X10 F100\n")
    assert kind_of(tmp_path / "part.nc") == "a part program"


def test_grbl_settings_in_other_dress(tmp_path: Path) -> None:
    """A dump with spaces, prompts of a sender, and grblHAL's backlash and jerk."""
    more = [("$100=250.000 (x, step/mm)", "  < $100 = 250.000 (x-axis travel resolution, step/mm)"), ("ok\n", "$160=0.05\n$800=5000\nok\n")]
    machine = loaded(made_control(tmp_path, "grbl", *more))
    assert machine.control is not None
    assert machine.control.control == "grblHAL"
    assert machine.axes[0].limits.jerk == pytest.approx(5.0)
    assert [found.code for found in machine.control.findings] == ["CL984", "CL986"]
    assert reading_on(machine, {}).dialect == "grblhal"
    assert reading_on(loaded(made_control(tmp_path, "grbl")), {}).dialect == "grbl"
