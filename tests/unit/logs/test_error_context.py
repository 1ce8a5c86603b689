"""Errors about samples contain the names of their logs, each name once."""

from __future__ import annotations

import pytest
from refusals import refuses

from contourlab.errors import ContourlabError, LogError, ParameterError, ResultError
from contourlab.logs.load import about


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (ResultError("the reference does not move"), "runs/a.csv: the reference does not move"),
        (ParameterError("speed", "2 stretches", "at least 3"), "runs/a.csv: speed = 2 stretches: must be at least 3"),
        (ResultError("no reference in a.csv: say which"), "no reference in a.csv: say which"),
        (ParameterError("--lead", "3", "left out"), "--lead = 3: must be left out"),
        (ParameterError("slowest", "3", "passed", "m/s"), "slowest = 3 m/s: must be passed"),
    ],
)
def test_an_error_gets_the_name_of_its_log(error: ContourlabError, said: str) -> None:
    with pytest.raises(ContourlabError) as found, about("runs/a.csv", options=("slowest",)):
        raise error
    assert str(found.value) == said


def test_of_several_logs_only_the_affected_ones_are_named() -> None:
    with refuses(LogError, "speed = 2", file="a.csv, b.csv"), about("a.csv", "b.csv"):
        raise ParameterError("speed", "2", "more")
    with refuses(LogError, "speed = 2", file="m, o and 2 more"), about("m", "o", "r", "e"):
        raise ParameterError("speed", "2", "more")
    with refuses(LogError, file="b.csv", message="nothing moves"), about("a.csv", "b.csv"), about("b.csv"):
        raise ResultError("nothing moves")
