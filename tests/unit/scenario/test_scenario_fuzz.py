"""Reading any file gives a scenario or a readable error."""

from __future__ import annotations

import copy
import datetime
import math
import random
import re
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from texts_of_scenarios import CONTROLLER, SCENARIO

from contourlab.components.drive.saturation import Saturation
from contourlab.components.friction.laws import Coulomb
from contourlab.components.plant.plant import RigidAxis
from contourlab.components.sensor.encoder import Encoder
from contourlab.errors import ContourlabError
from contourlab.loop import Axis, AxisError, Machine
from contourlab.scenario import builtin_file, builtin_names, dump, load_axis, load_machine, parse_scenario
from contourlab.scenario.build import build_axis, build_machine
from contourlab.scenario.files import Reader
from contourlab.scenario.load import _scenario
from contourlab.scenario.tree import from_mapping, parse_tree, settle

RICH = (
    (
        SCENARIO
        + '[schemes.a]\ncontroller.axes."*".observer = "none"\naxes.y.friction = "none"\n[schemes."b c".feed]\nfrequency = "1 Hz"\n'
        + '[machine.squareness]\n"x-y" = "20 um/m"\n[axes.x.error]\nposition = ["0 mm", "5 mm"]\n'
        + 'lead_error = {unit = "um", values = [0, 1]}\n'
    )
    .replace('position_gain = "4 full_scale/mm"', 'gains = {natural_frequency = "25 rad/s", damping = 0.7, pole = "35 rad/s"}')
    .replace('velocity_gain = "0.1 full_scale*s/mm"\n', "")
)
WORDS = [
    *sorted(set(re.findall(r"[\w.*/^%-]+", RICH))),
    *(
        '""',
        "''",
        "[]",
        "{}",
        "[[1]]",
        "{a = 1}",
        "nan",
        "-inf",
        "1e400",
        "9" * 400,
        "true",
        "1979-05-27",
        '"default"',
        '"none"',
        "\\u0000",
        "é",
        "\x00",
    ),
    *(
        '"file"',
        "file = 3",
        '"builtin:xyz"',
        "machine = 1",
        "axes = 2",
        "[axes]",
        "[[axes]]",
        "[controller]",
        "kind = 5",
        '"*" = 1',
        "-1",
        '"1 mm"',
        "0",
    ),
]


def mutated(text: str, dice: random.Random) -> str:
    """Return text with a few faults: lines lost, doubled or swapped, words exchanged, characters changed."""
    lines = text.splitlines()
    for _ in range(dice.randint(1, 3)):
        i, j = dice.randrange(len(lines)), dice.randrange(len(lines))
        what = dice.choice([0, 1, 2, 3, 3, 4, 4, 4, 4, 5])
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
        elif what == 4:
            lines[i] = lines[i].split("=")[0] + "= " + dice.choice(WORDS)
        else:
            at = dice.randrange(len(lines[i]) + 1)
            lines[i] = lines[i][:at] + chr(dice.choice([*range(32, 127), 0, 9, 233, 8364])) + lines[i][at + 1 :]
    return "\n".join(lines)


def outcome(text: str) -> str:
    try:
        scenario = parse_scenario(text)
    except ContourlabError as error:
        assert str(error)
        return "refused"
    assert all(case.machine.axes for case in scenario.cases())
    return "read"


ODD = [
    *(
        None,
        True,
        0,
        -1,
        3,
        10**400,
        0.5,
        -2.5,
        math.nan,
        math.inf,
        "",
        " ",
        "x",
        "y",
        "*",
        "none",
        "default",
        "builtin:xyz",
        "a\x00b",
        "../x.toml",
    ),
    *(
        "1 mm",
        "-1 mm",
        "0 1/s",
        "nan mm",
        "1 (",
        "5 N",
        "1 full_scale",
        "1e308 km",
        "position",
        "planned",
        "circle",
        "coulomb",
        "disturbance-observer",
    ),
    *(
        [],
        [[]],
        ["x"],
        ["x", "x"],
        ["x", "y", "z"],
        [1, 2],
        ["1 mm", "2 mm"],
        {},
        {"kind": "none"},
        {"kind": 3},
        {"file": "no.toml"},
        {"file": {}},
    ),
    *({"x": {}}, {"*": 3}, {"a": {"b": {"c": {}}}}, {"unit": "mm", "values": [0, 1]}, datetime.date(2000, 1, 1)),
]


def places(tree: dict[str, Any]) -> list[tuple[dict[str, Any], str]]:
    """Return every entry of a tree as table and name."""
    found = [(tree, name) for name in tree]
    return found + [place for value in tree.values() if isinstance(value, dict) for place in places(value)]


def shaken(tree: dict[str, Any], dice: random.Random) -> dict[str, Any]:
    """Return a copy of a tree with a few faults: values exchanged, lost, moved or renamed."""
    tree = copy.deepcopy(tree)
    for _ in range(dice.randint(1, 3)):
        (table, name), (other, another) = dice.choice(places(tree)), dice.choice(places(tree))
        what = dice.randrange(6)
        if what <= 2:
            table[name] = copy.deepcopy(dice.choice(ODD))
        elif what == 3:
            del table[name]
        elif what == 4:
            table[name] = copy.deepcopy(other[another])
        else:
            table[dice.choice([another, name + "s", "kind", "file", "*", "gains", "a.b", "\x00"])] = table[name]
        if not tree:
            break
    return tree


def outcome_of_tree(tree: dict[str, Any]) -> str:
    try:
        scenario = _scenario(Reader(), from_mapping(tree, "<tree>"), Path("<tree>"))
    except ContourlabError as error:
        assert str(error)
        return "refused"
    again = parse_scenario(dump(scenario))
    assert dump(again) == dump(scenario)
    return "read"


def test_mutated_texts_are_read_or_refused() -> None:
    dice = random.Random(1)
    found = [outcome(mutated(RICH, dice)) for _ in range(600)]
    assert found.count("read") > 5 and found.count("refused") > 100
    assert outcome(RICH) == "read"


@pytest.mark.parametrize("seed", range(4))
def test_shaken_trees_are_read_or_refused(seed: int) -> None:
    dice, tree = random.Random(seed), tomllib.loads(RICH)
    found = [outcome_of_tree(shaken(tree, dice)) for _ in range(150)]
    assert found.count("read") >= 3 and found.count("refused") > 50


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(100, 102))
def test_many_more_mutations(seed: int) -> None:
    dice, tree = random.Random(seed), tomllib.loads(RICH)
    for _ in range(2000):
        outcome(mutated(RICH, dice))
        outcome_of_tree(shaken(tree, dice))


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
    """Read text as if its file were in the folder of the shipped ones, without writing it."""
    content = parse_tree(text, str(place))
    if reader is load_machine:
        build_machine(settle(Reader().machine_file(content)))
    else:
        build_axis(settle(Reader().axis_file(content)), "x")


@given(
    st.dictionaries(
        st.sampled_from(["gain", "damping", "coulomb", "limit", "resolution"]), st.floats(min_value=1e-9, max_value=1e9), min_size=5
    )
)
def test_any_machine_is_written_and_read_back(values: dict[str, float]) -> None:

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
    read = build_machine(settle(parse_tree(text, "m")))
    assert read.axes[0].plant == axis.plant and read.axes[0].sensor == axis.sensor
    assert read.axes[0].friction == axis.friction and read.axes[0].drive == axis.drive
    assert np.array_equal(read.axes[0].error.position, error.position) and np.array_equal(read.axes[0].error.lead_error, error.lead_error)
    assert dump(read) == text


@given(st.text(max_size=200))
def test_any_text_is_refused_in_words(text: str) -> None:
    assert outcome(text) == "refused"
    assert outcome(CONTROLLER + text) == "refused"
