"""The loop of an axis as matrices for other programs, and systems of python-control and scipy.signal as components."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.analysis.linear.sampled_loop import SampledLoop, sampled_loop
from contourlab.arrays import Array, ByValue
from contourlab.components.contract import Component
from contourlab.components.registry import component
from contourlab.errors import ParameterError, hint, refuse
from contourlab.extras import extra_module
from contourlab.loop.machine import Controller, Machine


@dataclass(frozen=True, eq=False)
class LinearSystem(ByValue):
    """A sampled system x(k + 1) = A x(k) + B u(k), y(k) = C x(k) + D u(k).

    Attributes
    ----------
    a, b, c, d : ndarray (n_state, n_state), (n_state, n_input), (n_output, n_state), (n_output, n_input)
        In the units of inputs and outputs [SI].
    dt : float [s]
        Servo period.
    inputs, outputs : tuple of str
    """

    a: Array
    b: Array
    c: Array
    d: Array
    dt: float
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]

    def to_control(self) -> Any:
        """Return the system as a `control.StateSpace` with named signals; needs python-control."""
        return extra_module("control").ss(self.a, self.b, self.c, self.d, self.dt, inputs=list(self.inputs), outputs=list(self.outputs))

    def to_scipy(self) -> Any:
        """Return the system as a `scipy.signal.StateSpace` in discrete time."""
        from scipy.signal import StateSpace

        return StateSpace(self.a, self.b, self.c, self.d, dt=self.dt)


@dataclass(frozen=True, eq=False)
class LinearAxis(ByValue):
    """The linear loop of an axis.

    Attributes
    ----------
    plant : LinearSystem
        From command (before filters and drive) and load to position and velocity, with the controller left out.
    loop : LinearSystem
        The loop gain, opened at the command; -1 is the critical point.
    sensitivity : LinearSystem
        1/(1 + loop).
    closed_loop : LinearSystem
        From the reference, its velocity and acceleration, and the load to position and velocity.
    """

    plant: LinearSystem
    loop: LinearSystem
    sensitivity: LinearSystem
    closed_loop: LinearSystem


def linear(machine: Machine, controller: Controller, axis: str) -> LinearAxis:
    """Return the linear loop of an axis as numbers: that of the margins of `analyse`, with sampling, hold and delays.

    Friction, disturbance, quantisation, limits, couplings, links and reactions of other axes are left out.

    Parameters
    ----------
    machine : Machine
    controller : Controller
    axis : str
        Its name.

    Returns
    -------
    LinearAxis

    Raises
    ------
    ParameterError
        If machine or controller have no such axis.
    ComponentError
        If a component is not linear, or the plant takes positions.

    >>> import contourlab as cl
    >>> plant = cl.component("plant", "rigid-axis")(gain=2.0, damping=5.0)
    >>> machine = cl.Machine("one", (cl.Axis("x", plant),), 1e-3)
    >>> law = cl.component("controller", "pid")(proportional_gain=40.0)
    >>> cl.linear(machine, cl.Controller({"x": cl.AxisController(law)}), "x").plant.a.round(6).tolist()
    [[1.0, 0.000998], [0.0, 0.995012]]
    """
    names = [name for name in machine.axis_names if name in controller.axes]
    refuse(axis not in names, ParameterError, "axis", repr(axis), f"an axis of machine and controller: {hint(axis, names)}")
    return systems_of(sampled_loop(machine.axis(axis), controller.axes[axis], machine.servo_period, machine.carried_mass(axis)))


def systems_of(loop: SampledLoop) -> LinearAxis:
    """Return the systems of a sampled loop."""
    moved, none = ("position", "velocity"), np.zeros((2, 6))
    reference = ("reference", "reference_velocity", "reference_acceleration")
    plant = _lean(loop.a, loop.b[:, [0, 5]], loop.state, none[:, :2], loop, ("command", "load"), moved)
    closed = _lean(*loop.closed, loop.state, none[:, :4], loop, (*reference, "load"), moved)
    # The observer's estimate is fed back at once; what remains is opened at the command.
    sent, told = loop.c
    fed = np.outer(loop.b[:, 1], told) / (1.0 - told @ loop.b[:, 1])
    a, b = loop.a + fed @ loop.a, loop.b[:, :1] + fed @ loop.b[:, :1]
    c, d = -sent[None, :] @ a, -sent[None, :] @ b
    back = 1.0 / (1.0 + d[0, 0])
    opened = _lean(a, b, c, d, loop, ("command",), ("returned",))
    sensitivity = _lean(a - back * b @ c, back * b, -back * c, np.array([[back]]), loop, ("disturbance",), ("command",))
    return LinearAxis(plant, opened, sensitivity, closed)


def _lean(a: Array, b: Array, c: Array, d: Array, loop: SampledLoop, inputs: tuple[str, ...], outputs: tuple[str, ...]) -> LinearSystem:
    """Return a system with states that are equal merged, and without those that no input reaches or no output reads."""
    while True:
        _, first, same = np.unique(np.hstack([a, b]), axis=0, return_index=True, return_inverse=True)
        merged = np.zeros((len(a), first.size))
        merged[np.arange(len(a)), same.ravel()] = 1.0
        a, b, c = a[first] @ merged, b[first], c @ merged
        links = a != 0.0
        kept = np.flatnonzero(_reached(links, (b != 0.0).any(axis=1)) & _reached(links.T, (c != 0.0).any(axis=0)))
        if kept.size == len(merged):
            break
        a, b, c = a[np.ix_(kept, kept)], b[kept], c[:, kept]
    return LinearSystem(a, b, c, d, loop.servo_period, inputs, outputs)


def _reached(links: Any, at: Any) -> Any:
    for _ in range(len(links)):
        at = at | (links & at).any(axis=1)
    return at


def from_system(system: Any, family: str = "controller", **values: Any) -> Component:
    """Return a system of another program as a component of the kind "state-space" or "transfer-function".

    Parameters
    ----------
    system : control.StateSpace, control.TransferFunction, a system of scipy.signal, or LinearSystem
        In continuous time, or sampled at the servo period; inputs as the kind says, such as the position error of a controller.
    family : str
        "plant", "controller" or "filter".
    **values
        Further parameters, such as ``method="zero-order-hold"``; not the period, which is the system's own.

    Returns
    -------
    Component

    Raises
    ------
    ParameterError
        If it has no matrices, the wrong size, a sampled system without a period, or what the kind refuses.

    >>> from scipy.signal import TransferFunction
    >>> from_system(TransferFunction([40.0, 800.0], [0.001, 1.0])).kind
    'transfer-function'
    """
    families = ("plant", "controller", "filter")
    refuse(family not in families, ParameterError, "family", repr(family), f"one of {', '.join(families)}")
    if not hasattr(system, "num") and hasattr(system, "poles") and hasattr(system, "to_ss"):  # not a frequency response
        system = system.to_ss()
    period = getattr(system, "dt", None)
    refuse(period is True, ParameterError, "dt", "True", "the servo period in s")
    refuse("period" in values, ParameterError, "period", "given", "left out: the system has its own, dt")
    rational = hasattr(system, "num")
    kind: Callable[..., Component] = component(family, "transfer-function" if rational else "state-space")
    given: dict[str, Any] = {"period": float(period or 0.0), **values}
    if rational:
        return kind(numerator=_only(system.num), denominator=_only(system.den), **given)
    found = {name: getattr(system, name.upper(), getattr(system, name, None)) for name in "abcd"}
    usable = all(value is not None and np.isrealobj(value) for value in found.values())
    refuse(not usable, ParameterError, "system", type(system).__name__, "one with A, B, C and D, all real")
    numbers = {name: np.atleast_2d(np.asarray(value, dtype=float)) for name, value in found.items()}
    (outputs, inputs), direct = numbers["d"].shape, numbers["d"].any()
    several = family == "controller"  # may have several inputs
    bound = f"one output{'' if several else ' and one input'}: choose, as system[0, {':' if several else '0'}] of python-control"
    wrong = outputs != 1 or (inputs != 1 and not several)
    refuse(wrong, ParameterError, "system", f"with {outputs} outputs, {inputs} inputs", bound)
    if family == "plant":
        refuse(direct, ParameterError, "system", f"with D = {numbers.pop('d').tolist()}", "D = 0: a position cannot jump with the command")
    return kind(**{name: matrix.ravel() for name, matrix in numbers.items()}, **given)


def _only(polynomials: Any) -> Array:
    """Return the polynomial of a system with one input and one output."""
    outer = polynomials
    while len(outer) == 1 and np.ndim(outer[0]):
        outer = outer[0]
    refuse(np.ndim(outer) != 1, ParameterError, "system", "with several inputs or outputs", "one input and one output, or matrices")
    return np.asarray(outer, dtype=float)
