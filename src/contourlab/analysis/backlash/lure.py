"""A loop with backlash as matrices: linear except for the torque, which acts through a gap and a spring.

::

    x' = a x + e (r, r', r'') - b T,      theta_d = c x,      T = k dz(theta_d, h)

with h half of the gap and dz the dead zone. With shaft damping the torque is that of Nordin, Galic & Gutman: k (theta_d -+ h) + d theta_d'
in contact, which ends where this torque would change its sign; in the gap the twist of the shaft relaxes at the rate k/d. Units are
angles and torques, or lengths and forces.

The loop of a machine's axis joins the linear models of its components in continuous time. The hold of the servo loop and the delay of the
drive become one rational delay of second order (Pade): half a servo period plus the delay of the drive. A filtered difference gets the
bandwidth that gives it the delay of its sampled form. Friction, limits and quantisation are left out.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Complex
from contourlab.components.contract import Component, LinearModel
from contourlab.components.ideal import TrueVelocity
from contourlab.components.mechanics.discretise import low_pass_weight
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.errors import ComponentError, ParameterError
from contourlab.loop.machine import Axis, AxisController

N_REFERENCE = 3
"""Reference, its velocity and its acceleration."""


def dead_zone(difference: ArrayLike, half_gap: float) -> Array:
    """Return how far a motor-load difference lies beyond the gap, with its sign: eq (4) of Shahin, ElMaraghy & ElBeheiry.

    >>> [float(value) for value in dead_zone([-3.0, 0.5, 1.5], 1.0)]
    [-2.0, 0.0, 0.5]
    """
    d = np.asarray(difference, dtype=float)
    return np.asarray(d - np.clip(d, -half_gap, half_gap))


@dataclass(frozen=True, eq=False)
class BacklashLoop:
    """A closed loop around a gap.

    Attributes
    ----------
    a : ndarray (n, n)
        Dynamics without torque: the gap mode.
    b : ndarray (n,)
        Input of the transmitted torque: x' = a x - b T.
    c : ndarray (n,)
        Motor-load difference theta_d = c x. c b = 0: a torque moves no position at once.
    stiffness : float, > 0
        Of the transmission, k.
    half_gap : float, > 0
        Half of the total gap, h.
    shaft_damping : float, >= 0
        d; 0 is the dead-zone model.
    e : ndarray (n, 3), optional
        Input of the reference, its velocity and its acceleration; zero by default.
    contact_a : ndarray (n, n), optional
        Dynamics without torque in contact, if the controller changes in the gap; `a` by default.
    contact_e : ndarray (n, 3), optional
        Input of the reference in contact; `e` by default.
    """

    a: Array
    b: Array
    c: Array
    stiffness: float
    half_gap: float
    shaft_damping: float = 0.0
    e: Array | None = None
    contact_a: Array | None = None
    contact_e: Array | None = None
    states: tuple[str, ...] = ()

    @property
    def n(self) -> int:
        """Number of states."""
        return len(self.b)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the states."""
        return self.states or tuple(f"state {i + 1}" for i in range(self.n))

    @property
    def reference_input(self) -> Array:
        """`e`, or zeros (n, 3)."""
        return np.zeros((self.n, N_REFERENCE)) if self.e is None else self.e

    def reference_input_in(self, gap: bool) -> Array:
        """Input of the reference in the gap, or in contact (n, 3)."""
        return self.reference_input if gap or self.contact_e is None else self.contact_e

    @property
    def rate(self) -> Array:
        """Row of the velocity of the motor-load difference, theta_d' = c a x (n,)."""
        return np.asarray(self.c @ self.a)

    @property
    def torque_row(self) -> Array:
        """Row of the torque in contact, T = (k c + d c a) x -+ k h, without its constant (n,)."""
        return self.stiffness * self.c + self.shaft_damping * self.rate

    @property
    def gap_matrix(self) -> Array:
        """Dynamics in the gap (n, n)."""
        return self.a

    @property
    def contact_matrix(self) -> Array:
        """Dynamics in contact (n, n), about its point of rest."""
        return (self.a if self.contact_a is None else self.contact_a) - np.outer(self.b, self.torque_row)

    @cached_property
    def balance(self) -> Array:
        """Powers of 2 (n,), exact in floating point: divide the states by them to scale `a` and the contact matrix well."""
        from scipy.linalg import matrix_balance

        _, (scale, _) = matrix_balance(np.abs(self.gap_matrix) + np.abs(self.contact_matrix), permute=False, separate=True)
        return np.asarray(scale, dtype=float)

    def transfer(self, frequency: ArrayLike) -> Complex:
        """Return G(j w) = c (j w - a)^-1 b (n,), from the negative torque to the motor-load difference, at w (n,) [rad/s].

        Raises
        ------
        ParameterError
            If the controller changes with the mode: there is no single linear part.
        """
        self.require_one_controller("a transfer function")
        scale, w = self.balance, np.asarray(frequency, dtype=float)
        a, b, c = self.a * scale / scale[:, None], self.b / scale, self.c * scale
        matrix = 1j * w.reshape(-1, 1, 1) * np.eye(self.n) - a
        response = np.linalg.solve(matrix, np.broadcast_to(b[:, None], (w.size, self.n, 1)).astype(complex))
        return np.asarray((response[..., 0] @ c).reshape(w.shape))

    def require_one_controller(self, what: str) -> None:
        """Raise `ParameterError` if the controller changes with the mode."""
        if self.contact_a is not None and not np.array_equal(self.contact_a, self.a):
            raise ParameterError("contact_a", "another matrix than a", f"left out for {what}: it needs one linear part for gap and contact")


REFERENCE = ("reference", "reference_velocity", "reference_acceleration")
FREE = (*REFERENCE, "shaft")
"""Inputs of the loop: the reference, and the force of the shaft."""
PLANT_STATES = ("motor position", "motor velocity", "load position", "load velocity")


@dataclass(frozen=True)
class _Block:
    """A linear model, and the source of each input: ``"block.output"`` or a name of `FREE`; other inputs are zero."""

    name: str
    model: LinearModel
    wires: Mapping[str, str]


def axis_backlash_loop(axis: Axis, controller: AxisController, servo_period: float, carried_mass: float = 0.0) -> BacklashLoop:
    """Return the loop around the gap of an axis, with lengths and forces at the table.

    Under a supervisor, `controller.controller` is the controller in contact, and the first of `controller.others` that in the gap.

    Parameters
    ----------
    axis : Axis
        Its plant is a two-inertia drive with backlash.
    servo_period : float [s], > 0
    carried_mass : float [kg]
        Mass of the axes that this one carries.

    Raises
    ------
    ComponentError
        If there is no gap, or a component has no linear model.
    """
    plant = axis.plant.loaded(carried_mass)
    if not isinstance(plant, TwoInertia) or not plant.widest_gap > 0.0:
        raise ComponentError(f"axis {axis.name}: there is no gap to analyse: its plant is not a two-inertia drive with backlash")
    if controller.predictor is not None:
        raise ComponentError(f"axis {axis.name}: predictor {controller.predictor.kind} has no linear model in continuous time")
    controller = replace(controller, velocity=_as_sampled(controller.velocity, servo_period))
    delay = 0.5 * servo_period + float(getattr(axis.drive, "delay", 0.0))
    in_contact = _closed(plant, controller, controller.controller, delay)
    in_gap = _closed(plant, controller, controller.others[0][1], delay) if controller.others else in_contact
    if in_gap[0].shape != in_contact[0].shape:
        raise ComponentError(f"axis {axis.name}: its controllers for contact and gap have different states: give both the same kind")
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
    from scipy.linalg import block_diag

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
    a, b, c, d = (np.asarray(block_diag(*(getattr(block.model, part) for block in blocks))) for part in "abcd")
    # Solve for outputs that depend on each other without delay.
    reach = np.linalg.solve(np.eye(len(place)) - d @ inside, np.hstack([c, d @ outside]))
    n = len(a)
    names = (*PLANT_STATES, *(f"{block.name} {i + 1}" for block in blocks[1:] for i in range(len(block.model.a))))
    return a + b @ inside @ reach[:, :n], b @ (inside @ reach[:, n:] + outside), names


def _blocks(plant: TwoInertia, controller: AxisController, law: Component, delay: float) -> list[_Block]:
    sent = "controller.command"
    filters = []
    for label, part in controller.filters:
        filters.append(_Block(f"filter {label}", _linear(part), {"command": sent}))
        sent = f"filter {label}.command"
    command = "drive.applied" if delay > 0.0 else sent
    blocks = [_Block("plant", _split(plant), {"command": command, "shaft": "shaft"})]
    if delay > 0.0:
        blocks.append(_Block("drive", _delayed(delay), {"command": sent}))
    blocks += filters
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
        raise ComponentError(f"{part.family} {part.kind} has no linear model, which the analysis of the gap needs")
    return model


def _split(plant: TwoInertia) -> LinearModel:
    """Return motor and load as separate masses, with the force of the shaft as an input."""
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
