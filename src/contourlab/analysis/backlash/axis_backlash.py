"""An axis with backlash under its controller as a loop around its gap, in continuous time: what limit cycles are looked for in.

The linear models that components give of themselves are joined. The hold of the servo loop and the delay of the drive become a rational
delay of second order (Pade), half a servo period and the drive's own; a filtered difference gets the bandwidth that has the delay of its
sampled form. Friction, limits and quantisation are left out.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.backlash.lure import BacklashLoop
from contourlab.components.contract import Component, LinearModel
from contourlab.components.ideal import TrueVelocity
from contourlab.components.mechanics.discretise import low_pass_weight
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.errors import ComponentError
from contourlab.loop.machine import Axis, AxisController

Array = NDArray[np.float64]
REFERENCE = ("reference", "reference_velocity", "reference_acceleration")
FREE = (*REFERENCE, "shaft")
"""What acts on the loop from outside: the reference, and what the shaft transmits."""
PLANT_STATES = ("motor position", "motor velocity", "load position", "load velocity")


@dataclass(frozen=True)
class _Block:
    """A linear model in the loop: where each of its inputs comes from, ``"block.output"`` or a name of `FREE`; others are at rest."""

    name: str
    model: LinearModel
    wires: Mapping[str, str]


def axis_backlash_loop(axis: Axis, controller: AxisController, servo_period: float, carried_mass: float = 0.0) -> BacklashLoop:
    """Return the loop around the gap of an axis, lengths at the table and forces there.

    Under a supervisor the first controller is that of contact, the first of the others that of the gap.

    Parameters
    ----------
    axis : Axis
        Whose plant is a two-inertia drive with backlash.
    controller : AxisController
    servo_period : float [s], > 0
    carried_mass : float [kg]
        What other axes put on this one.

    Raises
    ------
    ComponentError
        If there is no gap, or a component has no linear model.
    """
    plant = axis.plant.loaded(carried_mass)
    if not isinstance(plant, TwoInertia) or not plant.widest_gap > 0.0:
        raise ComponentError(f"axis {axis.name}: its plant is no two-inertia drive with backlash, so there is no gap to analyse")
    if controller.predictor is not None:
        raise ComponentError(f"axis {axis.name}: predictor {controller.predictor.kind} has no linear model in continuous time")
    controller = replace(controller, velocity=_as_sampled(controller.velocity, servo_period))
    delay = 0.5 * servo_period + float(getattr(axis.drive, "delay", 0.0))
    in_contact = _closed(plant, controller, controller.controller, delay)
    in_gap = _closed(plant, controller, controller.others[0][1], delay) if controller.others else in_contact
    if in_gap[0].shape != in_contact[0].shape:
        raise ComponentError(f"axis {axis.name}: its controllers for contact and gap have states of their own, which are no one loop")
    (a, b, names), values = in_gap, plant.constants()
    c = np.zeros(len(a))
    c[[0, 2]] = 1.0, -1.0
    return BacklashLoop(
        a=a,
        b=-b[:, 3],
        c=c,
        stiffness=float(values.stiffness_value),
        half_gap=0.5 * plant.widest_gap,
        shaft_damping=float(values.damper_value),
        e=b[:, :3],
        contact_a=in_contact[0] if controller.others else None,
        contact_e=in_contact[1][:, :3] if controller.others else None,
        states=names,
    )


def _as_sampled(velocity: Component, period: float) -> Component:
    """Return a filtered difference in continuous time with the delay that its sampled form has at low frequencies."""
    if not isinstance(velocity, FilteredDifference) or not period > 0.0:
        return velocity
    weight = float(low_pass_weight(velocity.bandwidth, period, velocity.discretisation))
    # The difference is half a period late, the low-pass (1 - W)/W periods.
    delayed: Component = velocity.replace(bandwidth=1.0 / (period * (0.5 + (1.0 - weight) / weight)))
    return delayed


def _closed(plant: TwoInertia, controller: AxisController, law: Component, delay: float) -> tuple[Array, Array, tuple[str, ...]]:
    """Return A and B of the loop over `FREE`, plant states first, and the names of the states."""
    blocks = _blocks(plant, controller, law, delay)
    place = {f"{block.name}.{port}": i for i, (block, port) in enumerate((block, port) for block in blocks for port in block.model.outputs)}
    takes = [(block, port) for block in blocks for port in block.model.inputs]
    inside, outside = np.zeros((len(takes), len(place))), np.zeros((len(takes), len(FREE)))
    for row, (block, port) in enumerate(takes):
        source = block.wires.get(port, "")
        if source in place:
            inside[row, place[source]] = 1.0
        elif source in FREE:
            outside[row, FREE.index(source)] = 1.0
    a, b, c, d = (_diagonal([getattr(block.model, part) for block in blocks]) for part in "abcd")
    # Outputs that depend on each other without delay are solved for.
    reach = np.linalg.solve(np.eye(len(place)) - d @ inside, np.hstack([c, d @ outside]))
    n = len(a)
    names = (*PLANT_STATES, *(f"{block.name} {i + 1}" for block in blocks[1:] for i in range(len(block.model.a))))
    return a + b @ inside @ reach[:, :n], b @ (inside @ reach[:, n:] + outside), names


def _diagonal(parts: list[Array]) -> Array:
    from scipy.linalg import block_diag

    return np.asarray(block_diag(*parts))


def _blocks(plant: TwoInertia, controller: AxisController, law: Component, delay: float) -> list[_Block]:
    command = "drive.applied" if delay > 0.0 else "controller.command"
    blocks = [_Block("plant", _split(plant), {"command": command, "shaft": "shaft"})]
    if delay > 0.0:
        blocks.append(_Block("drive", _delayed(delay), {"command": "controller.command"}))
    sides = {"motor_position": "plant.motor_position", "load_position": "plant.position"}
    sides |= {"motor_velocity": "plant.motor_velocity", "load_velocity": "plant.velocity"}
    if not isinstance(controller.velocity, TrueVelocity):
        model = _linear(controller.velocity)
        for side in ("motor", "load"):
            blocks.append(_Block(f"{side} velocity", model, {"position": sides[f"{side}_position"]}))
            sides[f"{side}_velocity"] = f"{side} velocity.velocity"
    seen = {"position": sides[f"{controller.feedback}_position"], "velocity": sides[f"{controller.velocity_feedback}_velocity"]}
    if controller.observer is not None:
        blocks.append(_Block("observer", _linear(controller.observer), {"velocity": seen["velocity"], "applied": command}))
        seen["disturbance_estimate"] = "observer.disturbance_estimate"
    blocks.append(_Block("controller", _linear(law.linear()), {**{name: name for name in REFERENCE}, **sides, **seen}))
    return blocks


def _linear(part: Component) -> LinearModel:
    model = part.linearize()
    if model is None:
        raise ComponentError(f"{part.family} {part.kind} has no linear model, so the loop around the gap is not known")
    return model


def _split(plant: TwoInertia) -> LinearModel:
    """Return motor and load apart, with the force of the shaft as an input."""
    d = plant.constants()
    a = np.zeros((4, 4))
    a[0, 1] = a[2, 3] = 1.0
    a[1, 1], a[3, 3] = -d.motor_decay, -d.load_decay
    b = np.zeros((4, 2))
    b[1] = d.force_value * d.motor_mobility, -d.motor_mobility
    b[3, 1] = d.load_mobility
    outputs = ("motor_position", "motor_velocity", "position", "velocity")
    return LinearModel(a, b, np.eye(4), np.zeros((4, 2)), ("command", "shaft"), outputs)


def _delayed(delay: float) -> LinearModel:
    """Return the rational delay of second order, (12 - 6 s T + s^2 T^2)/(12 + 6 s T + s^2 T^2)."""
    rate = 1.0 / delay
    a = np.array([[0.0, 1.0], [-12.0 * rate * rate, -6.0 * rate]])
    c = np.array([[0.0, -12.0 * rate]])
    return LinearModel(a, np.array([[0.0], [1.0]]), c, np.ones((1, 1)), ("command",), ("applied",))
