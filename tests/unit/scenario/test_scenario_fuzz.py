"""Whatever a file holds, reading it gives a scenario or an error that is meant for people."""

from __future__ import annotations

import random
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from contourlab.errors import ContourlabError
from contourlab.scenario import builtin_file, builtin_names, dump, load_axis, load_machine, parse_scenario
from contourlab.scenario.tree import parse_tree, settle
from texts_of_scenarios import CONTROLLER, SCENARIO

RICH = (
    SCENARIO
    + '[schemes.a]\ncontroller.axes."*".observer = "none"\naxes.y.friction = "none"\n[schemes."b c".feed]\nfrequency = "1 Hz"\n'
    + '[machine.squareness]\n"x-y" = "20 um/m"\n[axes.x.error]\nposition = ["0 mm", "5 mm"]\nlead_error = {unit = "um", values = [0, 1]}\n'
).replace('position_gain = "4 full_scale/mm"', 'gains = {natural_frequency = "25 rad/s", damping = 0.7, pole = "35 rad/s"}').replace(
    'velocity_gain = "0.1 full_scale*s/mm"\n', ""
)
WORDS = [
    *sorted(set(re.findall(r"[\w.*/^%-]+", RICH))),
    *('""', "''", "[]", "{}", "[[1]]", "{a = 1}", "nan", "-inf", "1e400", "9" * 400, "true", "1979-05-27", '"default"', '"none"', "\\u0000", "é", "\x00"),
    *('"file"', "file = 3", '"builtin:xyz"', "machine = 1", "axes = 2", "[axes]", "[[axes]]", "[controller]", "kind = 5", '"*" = 1', "-1", '"1 mm"', "0"),
]


def mutated(text: str, dice: random.Random) -> str:
    """Return text with a few faults: lines lost, doubled or swapped, words exchanged, characters changed."""
    lines = text.splitlines()
    for _ in range(dice.randint(1, 4)):
        i, j = dice.randrange(len(lines)), dice.randrange(len(lines))
        what = dice.randrange(6)
        if what == 0 and len(lines) > 2:
            del lines[i]
        elif what == 1:
            lines.insert(j, lines[i])
        elif what == 2:
            lines[i], lines[j] = lines[j], lines[i]
        elif what == 3:
            words = re.split(r'(\s+|[=\[\]{}",])', lines[i])
            words[dice.randrange(len(words))] = dice.choice(WORDS)
            lines[i] = "".join(words)
        elif what == 4 and "=" in lines[i]:
            lines[i] = lines[i].split("=")[0] + "= " + dice.choice(WORDS)
        else:
            at = dice.randrange(len(lines[i]) + 1)
            lines[i] = lines[i][:at] + chr(dice.choice([*range(32, 127), 0, 9, 233, 8364])) + lines[i][at + 1 :]
    return "\n".join(lines)


def outcome(text: str) -> str:
    try:
        scenario = parse_scenario(text)
    except ContourlabError as error:
        assert str(error) and "Error" not in str(error).split(": ", 1)[-1][:12], str(error)
        return "refused"
    assert all(case.machine.axes for case in scenario.cases())
    return "read"


@pytest.mark.parametrize("seed", range(8))
def test_mutated_scenarios_are_read_or_refused(seed: int) -> None:
    dice = random.Random(seed)
    found = [outcome(mutated(RICH, dice)) for _ in range(60)]
    # Both happen, or the mutations try nothing.
    assert 0 < found.count("refused") < 60
    assert outcome(RICH) == "read"


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(100, 140))
def test_many_more_mutated_scenarios(seed: int) -> None:
    dice = random.Random(seed)
    for _ in range(250):
        outcome(mutated(RICH, dice))


@given(st.integers(min_value=0), st.sampled_from([name for name in builtin_names() if not name.endswith(".ngc")]))
def test_mutated_shipped_files_are_read_or_refused(seed: int, name: str) -> None:
    file = builtin_file(name)
    text = mutated(file.read_text(encoding="utf-8"), random.Random(seed))
    place = Path("mutated.toml")
    for reader in (load_machine, load_axis):
        try:
            _read(reader, text, file.with_name(place.name))
        except ContourlabError as error:
            assert str(error)


def _read(reader: object, text: str, place: Path) -> None:
    """Read text as if it were a file beside the shipped ones, without writing it there."""
    from contourlab.scenario.build import build_axis, build_machine
    from contourlab.scenario.files import Reader

    content = parse_tree(text, str(place))
    if reader is load_machine:
        build_machine(settle(Reader().machine_file(content)))
    else:
        build_axis(settle(Reader().axis_file(content)), "x")


@given(st.dictionaries(st.sampled_from(["gain", "damping", "coulomb", "limit", "resolution"]), st.floats(min_value=1e-9, max_value=1e9), min_size=5))
def test_any_machine_is_written_and_read_back(values: dict[str, float]) -> None:
    from contourlab.components.drive.saturation import Saturation
    from contourlab.components.friction.coulomb import Coulomb
    from contourlab.components.plant.rigid_axis import RigidAxis
    from contourlab.components.sensor.encoder import Encoder
    from contourlab.loop import Axis, AxisError, Machine

    error = AxisError(np.array([0.0, values["gain"]]), np.array([values["limit"], -values["damping"]]))
    axis = Axis(
        "x",
        RigidAxis(gain=values["gain"], damping=values["damping"]),
        Coulomb(coulomb=values["coulomb"]),
        Saturation(limit=values["limit"]),
        Encoder(resolution=values["resolution"]),
        error=error,
    )
    text = dump(Machine("m", (axis,), 1e-3))
    from contourlab.scenario.build import build_machine

    read = build_machine(settle(parse_tree(text, "m")))
    assert read.axes[0].plant == axis.plant and read.axes[0].sensor == axis.sensor
    assert read.axes[0].friction == axis.friction and read.axes[0].drive == axis.drive
    assert np.array_equal(read.axes[0].error.position, error.position) and np.array_equal(read.axes[0].error.lead_error, error.lead_error)
    assert dump(read) == text


@given(st.text(max_size=200))
def test_any_text_is_refused_in_words(text: str) -> None:
    assert outcome(text) == "refused"
    assert outcome(CONTROLLER + text) == "refused"
