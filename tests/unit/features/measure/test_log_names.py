"""Names of logs: the shortest part of their path that distinguishes them."""

from __future__ import annotations

from pathlib import Path

import pytest

from contourlab.errors import LogError
from contourlab.features.measure.command import _names
from contourlab.features.measure.log_choice import distinct_names


@pytest.mark.parametrize(
    ("files", "names"),
    [
        (["a/run.csv"], ["run.csv"]),
        (["a/run.csv", "a/other.csv"], ["run.csv", "other.csv"]),
        (["a/run.csv", "b/run.csv", "b/other.csv"], ["a/run.csv", "b/run.csv", "other.csv"]),
        (["a/x/run.csv", "b/x/run.csv"], ["a/x/run.csv", "b/x/run.csv"]),
        (["run.csv", "a/run.csv"], ["run.csv", "a/run.csv"]),
        (["/a/run.csv", "/b/run.csv"], ["a/run.csv", "b/run.csv"]),
        (["a/run.csv", "./a/run.csv"], ["run.csv", "run.csv"]),  # the same file
    ],
)
def test_names_are_as_short_as_they_can_be(files: list[str], names: list[str]) -> None:
    assert distinct_names(files) == names


def test_endings_are_dropped_where_names_stay_distinct() -> None:
    assert _names([Path("a/run.csv"), Path("b/run.csv")]) == ["a/run", "b/run"]
    assert _names([Path("a/run.csv"), Path("a/run.mat")]) == ["run.csv", "run.mat"]
    with pytest.raises(LogError, match="given twice"):
        _names([Path("a/run.csv"), Path("a/run.csv")])
