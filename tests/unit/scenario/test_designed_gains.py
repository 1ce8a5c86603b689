"""Gains from design specifications: ``gains = {...}`` of every controller with a design method."""

from __future__ import annotations

import math

import numpy as np
import pytest

from contourlab.analysis.linear.sampled_loop import SampledLoop, sampled_loop
from contourlab.components.registry import component, components
from contourlab.errors import ScenarioError
from contourlab.scenario import Case, dump, parse_scenario
from contourlab.scenario.tree import DESIGNED

PERIOD = 1e-4
SCENARIO = """\
[machine]
name = "m"
servo_period = "0.1 ms"
axes = ["x", "y"]
[axes."*"]
plant = {{kind = "rigid-axis", gain = "2 m/s^2/full_scale", damping = "5 1/s"}}
[controller.axes."*"]
controller = {controller}
[contour]
name = "circle"
[feed]
law = "uniform"
frequency = "1 Hz"
{more}
"""


def case(controller: str, more: str = "") -> Case:
    return parse_scenario(SCENARIO.format(controller=controller, more=more)).cases()[-1]


def loop(found: Case) -> SampledLoop:
    return sampled_loop(found.machine.axis("x"), found.controller.axes["x"], PERIOD)


def slowest(found: Case, n: int) -> np.ndarray:
    """Return the n slowest poles of the sampled loop, in s."""
    poles = np.log(loop(found).poles.astype(complex)) / PERIOD
    return np.sort_complex(poles[np.argsort(np.abs(poles))][:n])


@pytest.mark.parametrize("kind", ["position", "state-feedback"])
def test_poles_are_at_the_specified_places(kind: str) -> None:
    found = case(f'{{kind = "{kind}", gains = {{natural_frequency = "60 rad/s", damping = 0.5, pole = "40 rad/s"}}}}')
    wanted = np.sort_complex([-40.0, -30.0 + 1j * 60.0 * math.sqrt(0.75), -30.0 - 1j * 60.0 * math.sqrt(0.75)])
    assert np.abs(slowest(found, 3) - wanted).max() < 0.5  # sampling moves them by about w^2 T


def test_state_feedback_without_an_integral() -> None:
    found = case('{kind = "state-feedback", gains = {natural_frequency = "60 rad/s", damping = 1.25}}')
    assert found.controller.axes["x"].controller.values()["integral_gain"] == 0.0
    assert np.abs(slowest(found, 2) - np.sort_complex([-120.0, -30.0])).max() < 1.5


def test_the_lead_gives_the_margin_at_the_crossover() -> None:
    found = case('{kind = "lead-lag", gains = {phase_margin = "60 deg", crossover = "100 rad/s", delay = "0.05 ms"}}')
    margins = loop(found).margins()
    assert math.degrees(margins.phase) == pytest.approx(60.0, abs=0.1)
    assert margins.crossover == pytest.approx(100.0, rel=1e-3)


def test_a_cascade_by_its_bandwidth() -> None:
    found = case('{kind = "cascade", gains = {bandwidth = "200 rad/s"}, velocity_feedforward = 0}').controller.axes["x"].controller
    wanted = component("controller", "cascade").tune(200.0, 1.0, 2.0, 5.0)  # type: ignore[attr-defined]
    assert found.values() | {"velocity_feedforward": 1.0} == found.values() | wanted
    assert found.values()["position_gain"] == pytest.approx(40.0)
    other = case('{kind = "cascade", gains = {bandwidth = "200 rad/s", damping = 0.8, position_gain = "30 1/s"}}')
    assert other.controller.axes["x"].controller.values()["position_gain"] == 30.0


def test_specifications_of_a_scheme_replace_inherited_gains() -> None:
    scheme = '[schemes.wished]\ncontroller.axes."*".controller.gains = {bandwidth = "100 rad/s"}'
    found = case('{kind = "cascade", position_gain = "90 1/s", velocity_gain = "1 full_scale*s/m", integral_time = "1 s"}', scheme)
    assert found.controller.axes["x"].controller.values()["position_gain"] == pytest.approx(20.0)
    assert parse_scenario(dump(parse_scenario(SCENARIO.format(controller='"position"', more="")))).machine.axis_names == ("x", "y")


def test_a_scheme_can_remove_every_designed_gain() -> None:
    wishes = {"phase_margin": 1.0, "crossover": 100.0, "integral_rate": math.inf, "delay": 0.0, "bandwidth": 100.0, "damping": 1.0}
    wishes |= {"position_gain": 20.0, "natural_frequency": 50.0, "pole": 40.0, "inertia": 1e-3}
    kinds = [kind for kind in components("controller") if kind.wishes]
    zones = {f"{zone}-zone-{number}" for zone in ("contact", "gap") for number in (2, 3)}
    assert {kind.kind for kind in kinds} == {"position", "cascade", "load-side-cascade", "lead-lag", "state-feedback", *zones}
    for kind in kinds:
        made = kind.designed({name: wishes[name] for name in kind.wishes}, 2.0, 5.0)
        assert not set(made) - set(kind.parameters)
        gains = {name for name in made if not name.endswith("feedforward") and not name.startswith("model_") and name not in kind.wishes}
        assert gains <= set(DESIGNED), kind.kind


@pytest.mark.parametrize(
    ("controller", "message"),
    [
        ('{kind = "pid", gains = {bandwidth = "1 rad/s"}}', "pid .*gains"),
        ('{kind = "cascade", gains = {damping = 1}}', r"cascade.* bandwidth \[rad/s\]"),
        ('{kind = "cascade", gains = {bandwidth = "1 mm"}}', "bandwidth"),
        ('{kind = "cascade", gains = {bandwidth = "0 rad/s"}}', "range"),
        ('{kind = "cascade", gains = {bandwith = "100 rad/s"}}', "cascade.*'bandwith'.*bandwidth"),
        ('{kind = "cascade", gains = {bandwidth = "100 rad/s"}, velocity_gain = "1 full_scale*s/m"}', "velocity_gain.*gains"),
        ('{kind = "cascade", gains = {bandwidth = "2 rad/s"}}', "model_damping = 5 1/s: must be >= 0 and < 2 damping bandwidth"),
    ],
)
def test_impossible_specifications_are_refused(controller: str, message: str) -> None:
    with pytest.raises(ScenarioError, match=message):
        case(controller)
