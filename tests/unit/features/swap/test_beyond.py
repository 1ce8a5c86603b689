"""A shared design over a network."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from contourlab.components.controller.position import PositionController
from contourlab.components.link.network import Network
from contourlab.components.plant.plant import RigidAxis
from contourlab.errors import ParameterError
from contourlab.features.link.cost import message_rate
from contourlab.features.swap.beyond import NetworkCost, least_division, network_cost
from contourlab.features.swap.search import Design
from contourlab.features.swap.variants import Variants, variants_of
from contourlab.feed import uniform
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Limits, Machine
from contourlab.study import Setting, Space
from contourlab.study.guards import Bounds

AHEAD = "controller.axes.x.controller.model_gain"


@pytest.fixture(scope="module")
def variants() -> Variants:
    def rigid(name: str, gain: float) -> Axis:
        return Axis(name, RigidAxis(gain=gain, damping=0.0), limits=Limits(velocity=1.0))

    machine = Machine("stage", (rigid("x", 1.0), rigid("y", 1.0)), 1e-3)
    law = PositionController(velocity_gain=60.0, position_gain=3000.0, integral_gain=10.0, model_gain=1.0, model_damping=0.0)
    controller = Controller({name: AxisController(law) for name in ("x", "y")})
    circle = uniform(contour("circle", radius=0.01), 1.0, 2, 1e-3)
    space = Space.chosen(machine, controller, ("model_gain=0.3 m/s^2/full_scale..4 m/s^2/full_scale",))
    return Variants(
        variants_of(machine, {"x": [("strong", rigid("o", 2.0))]}),
        Setting(machine, controller, circle, moving=True),
        space,
        bounds=Bounds(6.0, 30.0),
    )


def cost_of(variants: Variants, division: str = "drive", ways: str = "both", link: Network | None = None, **options: float) -> NetworkCost:
    points = variants.everywhere(variants.space.start)
    design = Design(variants, frozenset({AHEAD}), points, variants.kept(points[:, None])[:, 0])
    return network_cost(design, division, ways, link, **options)  # type: ignore[arg-type]


def test_a_perfect_network_costs_nothing(variants: Variants) -> None:
    cost = cost_of(variants)
    alone, _ = variants.values(np.tile(variants.space.start, (2, 1, 1)), whole=True)
    assert [(one.as_given, one.undivided) for one in cost.variants] == [(value, value) for value in alone[:, 0].tolist()]
    assert cost.loss == 0.0 and cost.holds and cost.local_in_base == (AHEAD,)


def test_the_required_rate_is_the_largest_of_the_variants(variants: Variants) -> None:
    cost = cost_of(variants, within=0.5)
    each = []
    for variant, one in zip(variants, cost.variants, strict=True):
        controller = variants.controller_at(variants.space.start)
        options = {"figure": variants.objective, "allowed": one.allowed, "moving": True}
        each.append(message_rate(variant.machine, controller, variants.setting.reference, "drive", "both", **options).rate)
    assert cost.rate == max(each)
    for one in cost.variants:
        assert one.allowed == pytest.approx(one.undivided + 0.5 * max(one.undivided, variants.floor))


@pytest.mark.slow
def test_too_long_a_delay_does_not_hold(variants: Variants) -> None:
    cost = cost_of(variants, link=Network(delay=0.05))
    assert not cost.holds and np.isnan(cost.rate) and any(one.unstable for one in cost.variants)


def test_the_smallest_division_contains_all_local_parameters() -> None:
    assert least_division(frozenset()) == "drive"
    assert least_division(frozenset({"controller.axes.x.observer.model_gain"})) == "observer"
    assert least_division(frozenset({"controller.axes.x.observer.model_gain", AHEAD})) == "controller"


def test_an_unknown_division_is_refused(variants: Variants) -> None:
    with pytest.raises(ParameterError, match="drive, observer, controller"):
        cost_of(variants, "half")


def test_exact_margins_of_each_variant(variants: Variants) -> None:
    values = variants.space.values(variants.space.start)
    first, second = (guards.exact(values) for guards in variants.guards)
    # The second axis is the same in both; twice the plant gain takes a factor of two off the gain margin.
    assert first["y"] == second["y"]
    assert first["x"].gain == pytest.approx(2.0 * second["x"].gain, rel=1e-6)
    strict = replace(variants, bounds=Bounds(60.0, 0.0))
    assert "axis x: gain margin" in strict.guards[1].broken(values, 0.0, 0.0)[0]
