"""The table of families against the servo loop and the components."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest
from component_rig import make
from each import each

import contourlab as cl
from contourlab.components.contract import Component
from contourlab.components.declaration import check_class
from contourlab.components.families import FAMILY, size_of
from contourlab.components.registry import components
from contourlab.components.supervisor.switching import Supervisor
from contourlab.engine.step import Port
from contourlab.units import same_dimension

sys.path.append(str(Path(__file__).parents[3] / "docs"))
from ports import PORTS

CHOOSING = [name for name, family in FAMILY.items() if family.chooses]


def test_every_port_has_a_unit_and_a_meaning_and_none_is_left_over() -> None:
    used = {port for family in FAMILY.values() for port in (*family.inputs, *family.outputs)}
    assert used == set(PORTS)
    for unit, meaning in PORTS.values():
        assert meaning and (unit in ("command", "force", "any") or same_dimension(unit, unit))


@each("kind", components())
def test_a_component_has_the_form_of_its_family(kind: type[Component]) -> None:
    check_class(kind)


def nothing(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    return (), (0.0,)


def two_numbers(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    return (), (0.0, 0.0)


def six_numbers(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    return (), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def two_vectors(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    return (), (inp.reference, (0.0, 0.0), 1.0)


STEPS = {1: nothing, 2: two_numbers, 6: six_numbers}


def greedy(name: str) -> Component:
    """Return a component that takes all that its slot offers and gives all that it can."""
    family = FAMILY[name]
    inputs, outputs = (tuple(Port(port, size_of(name, port)) for port in names) for names in (family.inputs, family.outputs))
    step = two_vectors if name == "coupling" else STEPS[len(outputs)]
    body: dict[str, Any] = {"family": name, "kind": "greedy", "inputs": inputs, "outputs": outputs, "states": ()}
    body["step"] = staticmethod(step)
    if name == "supervisor":
        body |= {"reasons": ("no reason",), "n_controller": 2}
    kind = type("Greedy", (Supervisor if name == "supervisor" else Component,), body)
    check_class(kind)
    made: Component = kind()
    return made


@pytest.mark.parametrize("name", CHOOSING)
def test_the_loop_offers_every_port_of_the_table(name: str) -> None:
    geared = make("plant", "two-inertia", motor_inertia=4e-3, mass=10.0, lead=0.02, stiffness=50.0, backlash_gap=2e-5)
    machine = cl.Machine("geared", tuple(cl.Axis(axis, plant=geared, substeps=4) for axis in "xy"), 1e-3)
    parts: dict[str, Any] = {"controller": make("controller", "position", velocity_gain=70.0, position_gain=2800.0, integral_gain=12.0)}
    parts["observer"] = make("observer", "disturbance-observer", model_gain=1.0, model_damping=6.0)
    parts["gap_observer"] = greedy("gap_observer")
    if name == "supervisor":
        parts["others"] = (("other", parts["controller"]),)
    contour = {"estimator": make("estimator", "newton"), "coupling": make("coupling", "modified-reference", weight=0.5)}
    (contour if name == "coupling" else parts)[name] = greedy(name)
    controller = cl.Controller({axis: cl.AxisController(**parts) for axis in "xy"}, **contour)
    reference = cl.uniform(cl.contour("circle", radius=0.02), 1.0, 1, 1e-3)
    result = cl.simulate(machine, controller, reference, on_failure="return")
    assert result.n_sample > 1
