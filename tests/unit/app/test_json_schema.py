"""JSON Schemas from types, checked against values of the same types."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Literal, NamedTuple

import numpy as np
import pytest
from jsonschema import Draft202012Validator
from numpy.typing import NDArray

from contourlab.app.json_schema import json_schema
from contourlab.app.json_values import json_values
from contourlab.cli.look_up import results
from contourlab.cli.main import main, root
from contourlab.findings import Finding, finding


class Pair(NamedTuple):
    low: float
    high: float


@dataclass(frozen=True)
class Point:
    """A point.

    Attributes
    ----------
    before : float [m]
        Ahead of
        the turn.
    """

    json_derived: ClassVar = {"pass": "passed"}

    before: float = field(metadata={"json": "from"})
    hidden: object = field(metadata={"json": False})
    child: Point | None = None

    @property
    def passed(self) -> bool:
        """Whether it is ahead."""
        return self.before > 0.0


@dataclass(frozen=True)
class Everything:
    """All forms."""

    points: tuple[Point, ...]
    pair: Pair
    way: Literal["up", "down"]
    named: Mapping[str, float | str]
    values: NDArray[np.float64]
    file: Path
    findings: tuple[Finding, ...]
    rest: Any = None


MADE = Everything(
    (Point(math.nan, object(), Point(1.0, object())),),
    Pair(-math.inf, 1.0),
    "up",
    {"x": 1.0, "y": "free"},
    np.zeros(3),
    Path("a.toml"),
    (finding("CL102", place="axis x"),),
)


def test_the_values_of_a_type_follow_its_schema() -> None:
    schema = json_schema(Everything)
    Draft202012Validator.check_schema(schema)
    assert not list(Draft202012Validator(schema).iter_errors(json_values(MADE)))


@pytest.mark.parametrize(
    ("key", "value"),
    [("points", [{"from": 1.0}]), ("pair", [1.0]), ("way", "left"), ("named", {"x": None, "y": []}), ("values", 1.0), ("file", None),
     ("findings", ["words"])],
)  # fmt: skip
def test_other_values_violate_the_schema(key: str, value: object) -> None:
    values = json_values(MADE) | {key: value}
    assert list(Draft202012Validator(json_schema(Everything)).iter_errors(values))


def test_keys_have_their_names_and_meaning_from_the_class() -> None:
    point = json_schema(Point)["$defs"]["Point"]
    assert list(point["properties"]) == ["from", "child", "pass"]
    assert point["properties"]["from"]["description"] == "Ahead of the turn. [m]"
    assert point["properties"]["pass"] == {"type": "boolean", "description": "Whether it is ahead."}


def test_a_type_without_a_json_form_is_refused() -> None:
    with pytest.raises(TypeError):
        json_schema(complex)


@pytest.mark.slow
def test_every_command_with_json_has_a_schema(capsys: pytest.CaptureFixture[str]) -> None:
    commands = root().whole()
    members = {name: command.whole() if hasattr(command, "whole") else {} for name, command in commands.items()}
    with_json = {
        name for name, command in commands.items() for inner in [command, *members[name].values()]
        if any("--json" in parameter.opts for parameter in inner.params)
    }  # fmt: skip
    assert with_json == set(results())
    for name in with_json:
        assert main(["schema", name]) == 0
        Draft202012Validator.check_schema(json.loads(capsys.readouterr().out))
    assert main(["schema", "no-such-command"]) == 2
