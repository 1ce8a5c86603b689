"""A shared design over a network."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from contourlab.components.controller.position import PositionController
from contourlab.components.link.network import Network
from contourlab.components.plant.rigid_axis import RigidAxis
from contourlab.design import Space
from contourlab.design.guards import Bounds
from contourlab.errors import ParameterError
from contourlab.features.link.division import message_rate
from contourlab.features.swap.final import final
from contourlab.features.swap.fleet import Fleet
from contourlab.features.swap.network import NetworkCost, least_division, network_cost
from contourlab.features.swap.numbers import divided_controller
from contourlab.features.swap.variants import variants_of
from contourlab.feed import uniform
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Limits, Machine

AHEAD = "controller.axes.x.controller.model_gain"


@pytest.fixture(scope="module")
def fleet() -> Fleet:
    def rigid(name: str, gain: float) -> Axis:
        return Axis(name, RigidAxis(gain=gain, damping=0.0), limits=Limits(velocity=1.0))

    machine = Machine("stage", (rigid("x", 1.0), rigid("y", 1.0)), 1e-3)
    law = PositionController(velocity_gain=60.0, position_gain=3000.0, integral_gain=10.0, model_gain=1.0, model_damping=0.0)
    controller = Controller({name: AxisController(law) for name in ("x", "y")})
    circle = uniform(contour("circle", radius=0.01), 1.0, 2, 1e-3)
    space = Space.chosen(machine, controller, ("model_gain=0.3 m/s^2/full_scale..4 m/s^2/full_scale",))
    return Fleet(
        variants_of(machine, {"x": [("strong", rigid("o", 2.0))]}), controller, circle, space, moving=True, bounds=Bounds(6.0, 30.0)
    )


def cost_of(fleet: Fleet, division: str = "drive", ways: str = "both", link: Network | None = None, **options: float) -> NetworkCost:
    return network_cost(fleet, np.tile(fleet.space.start, (2, 1)), frozenset({AHEAD}), division, ways, link, **options)  # type: ignore[arg-type]


def test_a_network_that_loses_no_time_costs_nothing(fleet: Fleet) -> None:
    cost = cost_of(fleet)
    alone, _ = fleet.values(np.tile(fleet.space.start, (2, 1, 1)), whole=True)
    assert cost.given.tolist() == cost.whole.tolist() == alone[:, 0].tolist()
    assert cost.loss == 0.0 and cost.holds and cost.apart == (AHEAD,)


def test_the_rate_that_holds_is_the_largest_of_the_variants(fleet: Fleet) -> None:
    cost = cost_of(fleet, within=0.5)
    each = []
    for variant, allowed in zip(fleet.variants, cost.allowed, strict=True):
        controller = divided_controller(fleet.controller, fleet.space.values(fleet.space.start))
        options = {"figure": fleet.objective, "allowed": allowed, "moving": True}
        each.append(message_rate(variant.machine, controller, fleet.reference, "drive", "both", **options).rate)
    assert cost.rate == max(each)
    assert (cost.at_limit <= cost.allowed).all()
    assert cost.allowed == pytest.approx(cost.whole + 0.5 * np.maximum(cost.whole, fleet.floor))


def test_what_is_late_does_not_hold(fleet: Fleet) -> None:
    cost = cost_of(fleet, link=Network(delay=0.05))
    assert not cost.holds and np.isnan(cost.rate) and np.isnan(cost.at_limit).all() and not all(cost.stable)


def test_the_least_division_has_all_that_is_local() -> None:
    assert least_division(frozenset()) == "drive"
    assert least_division(frozenset({"controller.axes.x.observer.model_gain"})) == "observer"
    assert least_division(frozenset({"controller.axes.x.observer.model_gain", AHEAD})) == "controller"


def test_an_unknown_division_is_refused(fleet: Fleet) -> None:
    with pytest.raises(ParameterError, match="drive, observer, controller"):
        cost_of(fleet, "half")


def test_exact_margins_of_each_variant(fleet: Fleet) -> None:
    points = np.tile(fleet.space.start, (2, 1))
    found = final(fleet, points)
    # The second axis is the same in both; twice the gain of the plant takes a factor of two off the gain margin.
    assert found.margins[0]["y"] == found.margins[1]["y"]
    assert found.margins[0]["x"].gain == pytest.approx(2.0 * found.margins[1]["x"].gain, rel=1e-6)
    strict = final(replace(fleet, bounds=Bounds(60.0, 0.0)), points)
    assert found.holds and not strict.holds and "axis x: gain margin" in strict.broken[1][0]
