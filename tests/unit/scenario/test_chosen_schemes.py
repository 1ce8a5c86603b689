"""Schemes that are asked for by name."""

from __future__ import annotations

import pytest

from contourlab.errors import ScenarioError
from contourlab.scenario import chosen, load_scenario


def test_a_name_with_commas_may_come_in_pieces() -> None:
    scenario = load_scenario("builtin:ghaffari/demo-stage")
    text = "position loop,with modified reference, initial gains,with modified reference, calibrated gains"
    found = chosen(scenario, text.split(",")).cases()
    assert [case.name for case in found] == [
        "position loop",
        "with modified reference, initial gains",
        "with modified reference, calibrated gains",
    ]


def test_names_are_told_apart_where_one_is_unknown() -> None:
    scenario = load_scenario("builtin:ghaffari/demo-stage")
    with pytest.raises(ScenarioError, match="'with modified reference, initial gains', 'with modified"):
        chosen(scenario, ["with modified reference"])
