"""Zero-phase tracking without coefficients: the scenario designs them for the loop."""

from __future__ import annotations

import numpy as np
import pytest

from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.analysis.linear.zpetc import zpetc_design
from contourlab.errors import ScenarioError
from contourlab.loop import simulate
from contourlab.scenario import Scenario, dump, parse_scenario

SCENARIO = """\
[machine]
name = "stage"
servo_period = "1 ms"
axes = ["x", "y"]
[axes."*"]
plant = {{kind = "second-order-integrator", dc_gain = "10 mm/s/V", damping_ratio = 1.1, natural_frequency = "150 rad/s"}}
drive = {{kind = "delayed-saturation", delay = "4 ms"}}
[controller.axes."*"]
controller = {controller}
feedforward = {feedforward}
[contour]
name = "circle"
radius = "5 mm"
[feed]
law = "uniform"
frequency = "1 Hz"
laps = 2
"""
PID = '{kind = "pid", proportional_gain = "2 V/mm"}'


def scenario(feedforward: str = '"zpetc"', controller: str = PID) -> Scenario:
    return parse_scenario(SCENARIO.format(feedforward=feedforward, controller=controller))


def test_the_design_uses_the_loop_with_its_delay() -> None:
    case = scenario('{kind = "zpetc", radius = 0.8}').cases()[0]
    bare = scenario('"none"').cases()[0]
    loop = sampled_loop(bare.machine.axis("x"), bare.controller.axes["x"], 1e-3)
    assert case.controller.axes["x"].feedforward == zpetc_design(loop, radius=0.8)
    errors = {}
    for name, one in (("zpetc", case), ("none", bare)):
        run = simulate(one.machine, one.controller, one.reference())
        errors[name] = np.abs(run["reference"] - run["axis_position"])[1000:1900].max()
    assert errors["none"] > 1e-3
    assert errors["zpetc"] < 1e-6


def test_designed_coefficients_survive_a_round_trip() -> None:
    first = scenario()
    again = parse_scenario(dump(first))
    assert again.controller == first.controller


@pytest.mark.parametrize(
    ("feedforward", "controller", "message"),
    [
        ('{kind = "zpetc", radius = 1.5}', PID, r"feedforward\.radius: .*range"),
        ('{kind = "zpetc", lead = 3}', PID, "zpetc .*numerator, denominator"),
        (
            '"zpetc"',
            '{kind = "speed-pid", dc_gain = "10 mm/s/V", damping_ratio = 1.1, natural_frequency = "150 rad/s", time_constant = "50 ms"}',
            "velocity or acceleration",
        ),
        ('"zpetc"', '{kind = "pid", proportional_gain = "200 V/mm"}', "unstable"),
    ],
)
def test_an_impossible_design_is_refused_with_its_key(feedforward: str, controller: str, message: str) -> None:
    with pytest.raises(ScenarioError, match=message) as caught:
        scenario(feedforward, controller)
    assert "controller.axes" in str(caught.value)
