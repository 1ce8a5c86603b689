"""Every component keeps the contract, compiled and in plain Python."""

from __future__ import annotations

import pytest
from each import each

from contourlab.components.conformance import check_component
from contourlab.components.contract import FAMILIES, Component
from contourlab.components.registry import component, components
from contourlab.loop.machine import Axis, AxisController, Controller


def named(kind: type[Component]) -> str:
    return f"{kind.family}/{kind.kind}"


@pytest.mark.parametrize("kind", components(), ids=named)
@pytest.mark.slow
def test_a_component_keeps_the_contract(kind: type[Component]) -> None:
    checks = check_component(kind)
    assert len(checks) >= 2 and len(set(checks)) == len(checks)


STRIBECK = {"coulomb": 80.0, "breakaway": 120.0, "viscous": 500.0}


@pytest.mark.parametrize(
    ("kind", "values"),
    [
        ("coulomb", STRIBECK),
        ("smooth-coulomb", STRIBECK),
        ("rising", {"coulomb": 400.0, "breakaway": 60.0, "rise_velocity": 2e-2, "viscous": 300.0}),
        ("lugre", {**STRIBECK, "stiffness": 3e7, "bristle_damping": 2e4}),
    ],
)
def test_a_friction_of_a_real_machine_keeps_the_contract(monkeypatch, kind: str, values: dict[str, float]) -> None:
    friction = component("friction", kind)
    monkeypatch.setattr(friction, "example", values)
    assert f"every parameter has an effect ({len(friction.parameters)})" in check_component(friction)


def test_every_family_has_a_component() -> None:
    assert {kind.family for kind in components()} == set(FAMILIES)


@each("kind", components(), named)
def test_a_component_names_its_source(kind: type[Component]) -> None:
    ideal = {("sensor", "ideal"), ("velocity", "true"), ("friction", "none"), ("disturbance", "constant"), ("disturbance", "sine")}
    assert kind.reference or (kind.family, kind.kind) in ideal | {("disturbance", "table")}


@each("kind", components(), named)
def test_an_example_survives_a_round_trip_through_its_values(kind: type[Component]) -> None:
    part = kind(**kind.example)
    again = kind(**part.values())
    assert again == part and hash(again) == hash(part)
    assert eval(repr(part), {kind.__name__: kind, "inf": float("inf")}) == part
    assert part.replace() == part and part.replace() is not part


def test_each_family_has_its_place_in_a_machine_or_its_controller() -> None:
    slots = {name for holder in (Axis, AxisController, Controller) for name in holder.__dataclass_fields__}
    assert set(FAMILIES) - {"learning"} <= {*slots, "filter"}  # learning acts between runs; the slot of filters is in the plural
