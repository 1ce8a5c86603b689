"""A divided controller in files."""

from __future__ import annotations

import pytest
from refusals import refuses

import contourlab as cl
from contourlab.components.ideal import IdealLink
from contourlab.components.link.network import Network
from contourlab.errors import ScenarioError
from contourlab.loop import Division
from contourlab.scenario import dump, parse_scenario

TOP = """
name = "circle in two"
machine = "builtin:ghaffari/a3a1"
controller = {file = "builtin:ghaffari/calibrated", axes = {"*" = {link = LINK}}}
[contour]
name = "circle"
radius = "20 mm"
[feed]
law = "uniform"
frequency = "0.5 Hz"
laps = 2
"""
NETWORK = (
    '{division = "observer", down = {kind = "network", message_period = "2 ms", loss = 0.01}, up = {kind = "network", delay = "0.5 ms"}}'
)


def test_a_link_is_read_and_written() -> None:
    scenario = parse_scenario(TOP.replace("LINK", NETWORK))
    expected = Division("observer", Network(message_period=2e-3, loss=0.01), Network(delay=0.5e-3))
    assert {mine.link for mine in scenario.controller.axes.values()} == {expected}
    assert parse_scenario(dump(scenario)).controller == scenario.controller


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('{division = "drive"}', Division("drive", IdealLink(), IdealLink())),
        ('{division = "controller", down = "network", up = "ideal"}', Division("controller", Network(), IdealLink())),
        ('"none"', None),
    ],
)
def test_short_forms(text: str, expected: Division | None) -> None:
    scenario = parse_scenario(TOP.replace("LINK", text))
    assert scenario.controller.axes["1"].link == expected
    assert parse_scenario(dump(scenario)).controller == scenario.controller


def test_a_one_way_link_needs_no_estimator() -> None:
    one_way = TOP.replace("LINK", '{division = "controller", down = "network", up = "none"}')
    with refuses(ScenarioError, 'estimator = "newton"', key="controller.coupling"):
        parse_scenario(one_way)
    without = one_way.replace("axes =", 'estimator = "none", coupling = "none", axes =')
    link = parse_scenario(without).controller.axes["3"].link
    assert link == Division("controller", Network(), None)
    assert parse_scenario(dump(parse_scenario(without))).controller.axes["3"].link == link


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{}", "division"),
        ('{division = "half"}', "observer"),
        ('"network"', "table"),
        ('{division = "observer", sideways = "network"}', "sideways"),
        ('{division = "observer", down = "none"}', "none"),
        ('{division = "observer", up = "none"}', "link.up"),
        ('{division = "observer", down = "netwrok"}', "network"),
        ('{division = "observer", down = {kind = "network", delay = "3 mm"}}', "delay"),
        ('{division = "observer", down = {kind = "network", loss = 1.5}}', "loss"),
        ('{division = "observer", down = {kind = "network", delay = "-1 ms"}}', "delay"),
    ],
)
def test_errors_name_their_key(text: str, words: str) -> None:
    with pytest.raises(ScenarioError, match=words) as refusal:
        parse_scenario(TOP.replace("LINK", text))
    assert "controller.axes" in str(refusal.value)


@pytest.mark.slow
def test_local_parameters_are_those_of_the_part_in_the_axis() -> None:
    text = TOP.replace("link = LINK", f'local = ["observer.model_gain"], link = {NETWORK}')
    assert parse_scenario(text).controller.axes["1"].local_parameters == ("observer.model_gain",)
    with refuses(ScenarioError, r"local = .*controller\.position_gain", key="controller.axes.1"):
        parse_scenario(text.replace("observer.model_gain", "controller.position_gain"))


def test_a_scheme_may_change_or_remove_a_link() -> None:
    schemes = '[schemes.whole]\ncontroller.axes."*".link = "none"\n[schemes.late]\ncontroller.axes."*".link.up.delay = "3 ms"\n'
    scenario = parse_scenario(TOP.replace("LINK", NETWORK) + schemes)
    assert scenario.case("whole").controller.axes["1"].link is None
    late = scenario.case("late").controller.axes["1"].link
    assert late is not None and late.up == Network(delay=3e-3) and late.down == Network(message_period=2e-3, loss=0.01)
    again = parse_scenario(dump(scenario))
    assert [case.controller for case in again.cases()] == [case.controller for case in scenario.cases()]


def test_a_run_with_a_link() -> None:
    case = parse_scenario(TOP.replace("LINK", NETWORK)).cases()[0]
    reference = case.reference()
    one, again = (cl.simulate(case.machine, case.controller, reference, seed=case.run.seed) for _ in range(2))
    assert one.status.ok and (one["position"] == again["position"]).all()
