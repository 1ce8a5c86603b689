"""Schemes selected by name."""

from __future__ import annotations

import pytest

from contourlab.errors import ScenarioError
from contourlab.scenario import chosen, load_scenario

MODIFIED = [f"with modified reference, {gains} gains" for gains in ("initial", "calibrated")]


def test_a_name_with_commas_may_be_split() -> None:
    scenario = load_scenario("builtin:ghaffari/demo-stage")
    names = ["position loop", *MODIFIED]
    found = chosen(scenario, ",".join(names).split(",")).cases()
    assert [case.name for case in found] == names


def test_an_unknown_name_lists_the_valid_ones() -> None:
    scenario = load_scenario("builtin:ghaffari/demo-stage")
    with pytest.raises(ScenarioError, match=", ".join(f"'{name}'" for name in MODIFIED)):
        chosen(scenario, ["with modified reference"])
