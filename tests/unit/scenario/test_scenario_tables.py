"""The fields of a class are the keys of its table: one declaration serves reader, writer and documentation."""

from __future__ import annotations

import sys
from dataclasses import dataclass, field, fields
from pathlib import Path

import pytest

from contourlab.contours.reader import ContourOptions
from contourlab.errors import ScenarioError
from contourlab.loop import Axis, AxisController, AxisError, Change, Division, Limits, Machine
from contourlab.program import Reading
from contourlab.scenario import PartProgram
from contourlab.scenario.tables import keys_of, read_values, table_of
from contourlab.scenario.toml_text import toml
from contourlab.scenario.tree import Table, parse_tree
from contourlab.scenario.values import Contour, FeedSettings, LearningSettings, RunSettings
from contourlab.units import setting

sys.path.append(str(Path(__file__).parents[3] / "docs"))
import keys

KINDS = (
    FeedSettings, RunSettings, LearningSettings, Change, PartProgram, Reading, Contour, ContourOptions, Machine, Axis, Limits, AxisError,
    AxisController, Division,
)  # fmt: skip


@dataclass(frozen=True)
class Longer(FeedSettings):
    """Feed with one more key.

    Attributes
    ----------
    dwell : float [s] or None
        Rest at each corner.
    """

    dwell: float | None = field(default=None, metadata=setting("s", "ms", minimum=0.0, maximum=1.0))


def read(text: str) -> Longer:
    return Longer(**read_values(parse_tree(text, "feed.toml"), Longer))


def test_a_new_key_is_one_field(monkeypatch: pytest.MonkeyPatch) -> None:
    assert read('dwell = "20 ms"\nlaps = 3') == Longer(laps=3, dwell=0.02)
    assert table_of(Longer(dwell=0.02))["dwell"] == "20 ms"
    assert read(toml(table_of(Longer(dwell=0.1 / 3.0)))) == Longer(dwell=0.1 / 3.0)
    monkeypatch.setitem(keys.TABLES, "`[feed]`", ((Longer, Longer),))
    assert "| `dwell` | a quantity >= 0 and &lt;= 1000 ms |  | Rest at each corner. |" in keys.keys_page().splitlines()


@pytest.mark.parametrize(
    ("text", "key", "word"),
    [
        ('dwell = "2 s"', "dwell", "<= 1000 ms"), ("dwell = 20", "dwell", "no unit"), ("dwel = 20", "dwel", "'dwell'"),
        ("laps = 2.0", "laps", "whole number"), ("laps = true", "laps", "whole number"), ("law = 1", "law", '"planned" or "uniform"'),
        ('path_control = "blnd"', "path_control", '"exact_stop" or "blend"'), ("[laps]", "laps", "this table"),
    ],
)  # fmt: skip
def test_a_wrong_value_names_file_key_and_cure(text: str, key: str, word: str) -> None:
    with pytest.raises(ScenarioError) as refused:
        read(text)
    assert (refused.value.file, refused.value.key) == ("feed.toml", key)
    assert word in refused.value.message


def test_all_missing_keys_are_named_at_once_but_an_unknown_one_first() -> None:
    needed = ("at", "controller")
    with pytest.raises(ScenarioError, match="at, controller"):
        read_values(Table(), Change, needed=needed)
    with pytest.raises(ScenarioError, match="'controller'"):
        read_values(parse_tree('controler = "c.toml"', "t"), Change, needed=needed)


def test_a_file_is_relative_to_the_file_that_names_it_and_written_whole() -> None:
    assert read_values(parse_tree('tools = "tool.tbl"', "parts/job.toml"), Reading) == {"tools": Path("parts/tool.tbl")}
    assert table_of(Reading(tools="tool.tbl"))["tools"] == Path("tool.tbl").resolve().as_posix()


def test_every_class_with_keys_is_documented() -> None:
    assert {kind for kinds in keys.TABLES.values() for kind, _ in kinds} == set(KINDS)
    page = keys.keys_page()
    for kind in KINDS:
        for name in keys_of(kind):
            assert f"| `{name}` |" in page
    assert not set(keys_of(Limits)) - {own.name for own in fields(Limits)}
