"""The page of ports and methods of each family of components, for people who write one."""

from __future__ import annotations

import builtins
import inspect
import math
from collections.abc import Iterator

import numpy as np
from markup import plain

from contourlab import primitives
from contourlab.components.families import FAMILY, Family, Form, size_of
from contourlab.engine.translate.pythons import PYTHONS

HEAD = """\
# Ports and methods of components

What a component must declare and define, family by family. The loader of plug-ins and `contourlab.check_component` check a class against
the same table. [CONTRIBUTING](../../CONTRIBUTING.md#add-a-component-in-ten-minutes) shows how to write one.

## What a step may use

`if`, `for`, `while` with `break`, `continue`, `else` and `return`, tuples and named tuples, `tuple(... for ...)`, `:=`, functions of your
own, the operators of numbers, comparisons and conditions, and the functions below. Constants of your module or class may be used. What
`range`, `len`, `zip`, `enumerate`, `reversed` and `tuple` take must be known before the run, as must an index: `lookup` takes any.
Everything else is refused with file and line: lists, `try`, `print`, and whatever keeps something outside the states; `sum`, `math.hypot`
and `np.sin` too, whose last digit depends on Python or the processor. So plain Python and machine code compute the same.

Python's own operators and functions give Python's own values, where these are real numbers. Where Python raises, as for `1 / 0`, a number
is infinite or NaN; with `jit=False` it raises. Whole numbers beyond `2**53` are NaN, and so is what takes its sign from NaN. Where either
reaches the loop, the run stops and names axis and time. `in` compares by `==`. In lanes polynomials take the place of the mathematical
library: `a**b` loses about as many digits as its exponent of ten has, and `%` is NaN where the quotient exceeds `2**53`.

| function | returns |
|---|---|
"""
ARGUMENTS = """
## Methods

Methods without `self` are static: `@staticmethod`. `step(par, x, inp, clock)` returns `x_next, out`, tuples in the order of `states` and
`outputs`. Its arguments are named tuples: `par` holds the parameters that are numbers and the constants of `derive`, `x` the states, `inp`
the inputs; `clock` has the tick `k`, the time `t` and the period `dt`. `derive` gets numbers or arrays, one number for each variant of a
batch: use the functions of numpy there.

A component needs what its family lists; further outputs are allowed. Ports marked * have a number for each axis: `Port("tangent", -1)`.
The [table of ports](#ports) has units and meanings.
"""
PORT_TABLE = """\
## Ports

*command* and *force* are the units of the plant, such as A and N; a parameter writes them `{command}` and `{force}`.

| port | unit | meaning |
|---|---|---|
"""
PORTS = {
    "position": ("m", "position of the axis: true for sensor and disturbance, predicted after a predictor, else measured"),
    "velocity": ("m/s", "velocity of the axis, as the velocity part computes it"),
    "acceleration": ("m/s^2", "mean acceleration over the tick"),
    "motor_position": ("m", "position measured on the motor side, in load units"),
    "motor_velocity": ("m/s", "velocity on the motor side"),
    "load_position": ("m", "position on the load side, measured or estimated by the gap observer"),
    "load_velocity": ("m/s", "velocity on the load side, measured or estimated by the gap observer"),
    "reference": ("m", "reference position; for controller and supervisor with all that is added to it"),
    "reference_velocity": ("m/s", "velocity of the reference"),
    "reference_acceleration": ("m/s^2", "acceleration of the reference"),
    "reference_ahead": ("m", "reference position `ahead(dt)` ticks later, at the present rate"),
    "reference_shift": ("m", "is added to the reference of the controller"),
    "modified_reference": ("m", "replaces the reference of all axes"),
    "command": ("command", "command to the drive; of a feedforward or compensation, is added to it"),
    "correction": ("command", "is added to the commands of all axes"),
    "feedforward": ("command", "sum of feedforward, compensation, cross-coupling and learned table"),
    "applied": ("command", "command that leaves the drive, after limit and delay; to a controller or an observer one tick late"),
    "accepted": ("command", "last command that the drive accepted, before its delay"),
    "disturbance_estimate": ("command", "estimate of the observer; the controller subtracts it"),
    "load": ("force", "sum of all outer forces on the axis"),
    "force": ("force", "force on the axis, positive in its direction"),
    "gap_state": ("", "place of the motor in the gap: -1 and 1 in contact, 0 between"),
    "gap": ("m", "estimated size of the gap"),
    "gap_estimate": ("m", "size of the gap where the gap observer is confident, else 0"),
    "gap_deviation": ("m", "standard deviation of the estimated size"),
    "confidence": ("", "probability of the estimated state, 0 to 1"),
    "active": ("", "number of the active controller: 0 for `controller`, 1, 2 ... for `others`"),
    "reason": ("", "number of the reason in `reasons`, from 1, at the tick of a switch; else 0"),
    "feedrate": ("m/s", "speed of the reference along the path"),
    "curvature": ("1/m", "curvature of the path at the reference: in the plane signed, positive to the left"),
    "rate": ("", "planned time per time: 1 as planned, 0 at rest"),
    "arc_length": ("m", "arc length of the reference on the path; it grows over laps"),
    "source_line": ("", "line of the part program"),
    "foot_position": ("m", "point of the path nearest to the tool"),
    "error_vector": ("m", "from the tool to the path"),
    "contour_error_estimate": ("m", "signed distance from the path, positive left of travel; in space the distance"),
    "tangent": ("", "unit tangent of the path at the foot point"),
    "sent": ("any", "signal at the sender"),
    "received": ("any", "signal at the receiver"),
}
"""Unit and meaning of each port. ``command`` and ``force`` are the units of the plant."""


def ports_page() -> str:
    """Return the page of all families: ports and methods."""
    rows = []
    for name in primitives.__all__:
        function = getattr(primitives, name)
        if inspect.isfunction(function):
            call = f"{name}({', '.join(inspect.signature(function).parameters)})"
            summary = (inspect.getdoc(function) or "").splitlines()[0].removeprefix("Return ").rstrip(".")
            rows.append(f"| `{call}` | {plain(summary)} |")
    rows += [f"| `{names}` | as in {place} |" for place, names in _pythons()]
    parts = [HEAD + "\n".join(rows), ARGUMENTS]
    parts += [_family(name, family) for name, family in FAMILY.items()]
    ports = [f"| `{name}` | {unit or '1'} | {meaning} |" for name, (unit, meaning) in PORTS.items()]
    return "\n".join([*parts, PORT_TABLE + "\n".join(ports)]) + "\n"


def _pythons() -> Iterator[tuple[str, str]]:
    """Yield where functions of Python that a step may use come from, and their names."""
    for place, module in (("Python", builtins), ("`math`", math), ("numpy", np)):
        found = {name: value for name, value in vars(module).items() if name[0] != "_" and callable(value)}
        yield place, "`, `".join(sorted(name for name, value in found.items() if value in PYTHONS or value is float))


def _family(name: str, family: Family) -> str:
    """Return the section of a family."""
    lines = [f"## {name}\n", f"{family.doc[0].upper()}{family.doc[1:]}. Slot: `{family.slot}`.\n"]
    inputs, outputs = "Inputs, any of" if family.chooses else "Inputs", "Outputs, one or both of" if family.either else "Outputs"
    for what, ports in ((inputs, family.inputs), (outputs, family.outputs)):
        if ports:
            lines.append(f"- {what}: {', '.join(_port(name, port) for port in ports)}")
    if len(family.forms) > 1:
        lines.append(f"- One of these {'laws' if family.forms[0].law else 'base classes'}:")
    indent = "  " if len(family.forms) > 1 else ""
    lines += [f"{indent}- {_needs(form)}" for form in family.forms]
    return "\n".join([*lines, ""])


def _port(family: str, name: str) -> str:
    return f"`{name}`{'*' if size_of(family, name) else ''}"


def _needs(form: Form) -> str:
    """Return what a class of a form must have, in words."""
    base = f"`{form.base}`" if form.base else f'`law = "{form.law}"`' if form.law else ""
    methods = [f"`{method.call}`" + (f": {method.doc}" if method.name != "step" else "") for method in form.methods]
    states = [f"state `{name}`" for name in form.states]
    constants = [f"`{name}`{f' or a method `{other}(par)`' if other else ''}" for name, other in form.constants.items()]
    held = [f"in `par`: {', '.join(constants)}"] if constants else []
    attributes = [f"`{name}`, such as `{value}`" for name, value in form.attributes.items()]
    return "; ".join(filter(None, [base, *methods, *states, *held, *attributes]))
