"""The page of ports and methods of each family of components, for people who write one."""

from __future__ import annotations

import inspect

from markup import plain

from contourlab import primitives
from contourlab.components.families import FAMILY, PORTS, Family, Form, size_of

HEAD = """\
# Ports and methods of components

What a component must declare and define, family by family. The loader of plug-ins and `contourlab.check_component` check a class against
the same table. [CONTRIBUTING](../../CONTRIBUTING.md#add-a-component-in-ten-minutes) shows how to write one.

## What a step may use

`if`, `for`, `while`, tuples, functions of your own, and the functions below, from `contourlab.primitives`. `range`, `len`, `zip`,
`enumerate`, `reversed`, `tuple` and `float` shape tuples and loops. Everything else is refused with file and line: `max` and `math.exp`,
lists, `**`, `%`, `//`, `try`, `print`, and whatever keeps something outside the states. So plain Python and machine code compute the same.

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


def ports_page() -> str:
    """Return the page of all families: ports and methods."""
    rows = []
    for name in primitives.__all__:
        function = getattr(primitives, name)
        if inspect.isfunction(function):
            call = f"{name}({', '.join(inspect.signature(function).parameters)})"
            summary = (inspect.getdoc(function) or "").splitlines()[0].removeprefix("Return ").rstrip(".")
            rows.append(f"| `{call}` | {plain(summary)} |")
    parts = [HEAD + "\n".join(rows), ARGUMENTS]
    parts += [_family(name, family) for name, family in FAMILY.items()]
    ports = [f"| `{name}` | {unit or '1'} | {meaning} |" for name, (unit, meaning) in PORTS.items()]
    return "\n".join([*parts, PORT_TABLE + "\n".join(ports)]) + "\n"


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
