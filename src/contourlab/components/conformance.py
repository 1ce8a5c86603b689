"""Conformance test of components, built-in and third-party."""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import FAMILIES, Component, Parameter
from contourlab.components.learning_check import learning_fault
from contourlab.components.linear_check import linear_fault
from contourlab.engine.runner import Group, make_group
from contourlab.engine.schedule import Node, Schedule
from contourlab.engine.step import Bank, Step, rows
from contourlab.errors import ComponentError, ContourlabError, EngineError, error_text
from contourlab.primitives import Table

PERIOD = 1e-3
TICKS = 160
SCALES = (1.0, 1e-3)
AGREEMENT = 1e-9

ASKED = ("reference", "reference_velocity", "reference_acceleration")
BOTH_SIDES = ("motor_position", "motor_velocity", "load_position", "load_velocity")
SLOTS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "plant": (("command", "load"), ("position", "velocity", "acceleration")),
    "friction": ((), ()),
    "drive": (("command",), ("applied",)),
    "sensor": (("position",), ("position",)),
    "predictor": (("position", "applied"), ("position",)),
    "velocity": (("position",), ("velocity",)),
    "disturbance": (("position",), ("force",)),
    "observer": (("velocity", "applied"), ("disturbance_estimate",)),
    "gap_observer": (
        ("motor_position", "motor_velocity", "reference_velocity", "applied"),
        ("gap_state", "gap", "gap_deviation", "confidence", "load_position", "load_velocity"),
    ),
    "supervisor": (
        (*ASKED, *BOTH_SIDES, "position", "velocity", "gap_state", "gap_estimate", "confidence", "arc_length", "source_line", "accepted"),
        ("active", "reason"),
    ),
    "controller": (
        (*ASKED, *BOTH_SIDES, "position", "velocity", "gap_estimate", "disturbance_estimate", "feedforward", "applied", "accepted"),
        ("command",),
    ),
    "filter": (("command",), ("command",)),
    "feedforward": ((*ASKED, "reference_ahead"), ("reference_shift", "command")),
    "compensation": ((*ASKED, *BOTH_SIDES, "gap_estimate"), ("reference_shift", "command")),
    "estimator": (("position", "arc_length"), ("foot_position", "error_vector", "contour_error_estimate", "tangent")),
    "coupling": (
        ("reference", "position", "foot_position", "error_vector", "contour_error_estimate", "tangent", "command", "accepted"),
        ("modified_reference", "correction"),
    ),
    "link": (("sent",), ("received",)),
    "learning": ((), ()),
}
"""Ports of each family: inputs that its slot offers, outputs that it needs."""

CHOOSING = ("gap_observer", "feedforward", "compensation", "supervisor", "controller", "coupling")
"""Families that may leave inputs out."""
EITHER = ("feedforward", "compensation", "coupling")
"""Families that need only one of their outputs."""

UNWIRED = {("velocity", "true")}
"""Ideal parts with ports of their own; the loop runs no node for them."""


DECLARED = "declarations and example"
TYPED = ("reference", "example", "ring", "states", "inputs", "outputs", "derived", "tables", "unbounded", "without_effect", "calibrated")
"""Attributes of a class that must have the type that `Component` gives them."""


def check_component(kind: type[Component], *, jit: bool = True) -> tuple[str, ...]:
    """Check that a component keeps the contract, and return what was checked.

    Runs the `example` and checks: declarations (family, ports, bounds, documentation), sizes, finite outputs and states, determinism, save
    and restore in mid-run, agreement of lanes, compiled scalar and plain Python to 1e-9, the linear model against the step, that friction
    dissipates energy, and that every parameter has an effect. Plants and frictions are linked to each other, estimators run on an ellipse,
    learning laws on a trial.

    Parameters
    ----------
    kind : subclass of Component
    jit : bool
        Whether to check the compiled forms too.

    Returns
    -------
    tuple of str
        The checks, in words; a component without a linear model, say, has one less.

    Raises
    ------
    ComponentError
        At the first broken clause.

    >>> from contourlab.components.drive.saturation import Saturation
    >>> check_component(Saturation, jit=False)[0]
    'declarations and example'
    """
    _check_declaration(kind)
    try:
        part = kind(**kind.example)
    except ContourlabError as error:
        raise _fault(kind, f"its example is not valid: {error}") from error
    if kind.family == "learning":  # it has no step: it runs between trials
        fault = learning_fault(part, _others)
        if fault:
            raise _fault(kind, fault)
        return DECLARED, "corrections of a trial"
    for scale in SCALES:
        _check_running(kind, part, scale, jit)
    linear, passive = _check_linear(kind, part), _check_passive(kind, part)
    _check_effects(kind, part)
    checks = {
        DECLARED: True,
        f"{TICKS} ticks at {len(SCALES)} sizes: finite, repeatable, saved and restored": True,
        "compiled form and lanes agree with plain Python": jit,
        "linear model agrees with the step": linear,
        "takes energy at every speed": passive,
        f"every parameter has an effect ({len(kind.parameters)})": bool(kind.parameters),
    }
    return tuple(words for words, done in checks.items() if done)


def _fault(kind: type[Component], message: str) -> ComponentError:
    file = getattr(sys.modules.get(kind.__module__), "__file__", kind.__module__)
    return ComponentError(f"{file}: {kind.__name__}: {message}")


def _check_declaration(kind: type[Component]) -> None:
    if not (isinstance(kind, type) and issubclass(kind, Component) and kind.kind):
        raise ComponentError(f"{kind!r} is not a component: write a class with family and kind")
    if kind.family not in FAMILIES:
        raise _fault(kind, f"family {kind.family!r} is not one of {', '.join(FAMILIES)}")
    for name in TYPED:
        wanted = type(getattr(Component, name))
        if not isinstance(getattr(kind, name), wanted):
            raise _fault(kind, f"{name} = {getattr(kind, name)!r} is not a {wanted.__name__}")
    # Not inspect.getdoc, which would find the docstring of a parent.
    if not (kind.__doc__ or "").strip():
        raise _fault(kind, "has no docstring: write one")
    _check_ports(kind)
    for name, parameter in kind.parameters.items():
        if not parameter.doc:
            raise _fault(kind, f"parameter {name} has no doc: write one")
        _check_bounds(kind, name, parameter)
    for name in (*kind.calibrated, *kind.calibrated_ahead):
        if name not in kind.numeric():
            raise _fault(kind, f"the calibrated parameter {name} is not one of its numbers: {', '.join(kind.numeric())}")


def _check_ports(kind: type[Component]) -> None:
    """Check the ports against the slot of the family."""
    if (kind.family, kind.kind) in UNWIRED:
        return
    offered, wanted = SLOTS[kind.family]
    takes, gives = ([port.name for port in ports] for ports in (kind.inputs, kind.outputs))
    for name in takes:
        if name not in offered:
            raise _fault(kind, f"a {kind.family} cannot have the input {name!r}; its inputs are: {', '.join(offered) or 'none'}")
    if kind.family in EITHER and any(name in gives for name in wanted):
        wanted = tuple(name for name in wanted if name in gives)
    for what, names, needed in (("inputs", takes, () if kind.family in CHOOSING else offered), ("outputs", gives, wanted)):
        missing = [name for name in needed if name not in names]
        if missing:
            raise _fault(kind, f"a {kind.family} must declare {missing[0]!r} in its {what}")


def _check_bounds(kind: type[Component], name: str, parameter: Parameter) -> None:
    bounded = parameter.choices or parameter.minimum > -math.inf or parameter.maximum < math.inf
    if not bounded and name not in kind.unbounded:
        raise _fault(kind, f"parameter {name} has no bound: give minimum or maximum, or name it in `unbounded`")
    if parameter.default is not None:
        try:
            parameter.check(parameter.default)
        except ContourlabError as error:
            raise _fault(kind, f"the default of {name} is out of range: {error}") from error


def subject(part: Component) -> tuple[Step, dict[str, Any], dict[str, Any]]:
    """Return step, parameter values and tables of a component; a plant gets a friction, and a friction a plant."""
    if part.family in ("plant", "friction"):
        return _linked(part)
    if part.family == "estimator":
        from contourlab.geometry import contour
        from contourlab.geometry.view import view_of

        view = view_of(contour("ellipse"), pieces=64)
        return part.path_step(view, 2), {**part.block(PERIOD), **view.parameters}, dict(view.tables)  # type: ignore[attr-defined]
    return part.make_step(2), part.block(PERIOD), part.table_values()


def _linked(part: Component) -> tuple[Step, dict[str, Any], dict[str, Any]]:
    from contourlab.components.mechanics.core import friction_prefix, link
    from contourlab.components.registry import component

    plant: Component = part if part.family == "plant" else component("plant", "mass-damper")(mass=2.0, force_constant=3.0)
    friction: Component = part if part.family == "friction" else component("friction", "smooth-coulomb")(coulomb=0.1, breakaway=0.2)
    rubbing = {f"{friction_prefix(plant)}{row}": value for row, value in friction.block(PERIOD).items()}
    return link(plant, friction), {**plant.block(PERIOD), **rubbing}, plant.table_values()


def _sized(step: Step) -> Step:
    """Return the step with a check of tuple lengths against ports: a wrong length would shift numbers silently."""

    def function(*given: Any) -> Any:
        returned = step.function(*given)
        for what, ports, values in (("state", step.own_states, returned[0]), ("output", step.outputs, returned[1])):
            if len(values) != len(ports):
                raise ValueError(f"the step returns {len(values)} {what}s, but declares {len(ports)}")
            for port, value in zip(ports, values, strict=True):
                if port.size and len(value) != port.size:
                    raise ValueError(f"the step returns {len(value)} numbers for {what} {port.name}, which has {port.size}")
        return returned

    return replace(step, function=function, bank=_sized_bank(step.bank) if step.bank else None)


def _sized_bank(bank: Bank) -> Bank:
    def member(*given: Any) -> Any:
        kept, found = bank.function(*given)
        for what, values, wanted in (("kept", kept, bank.size), ("found", found, bank.n_found)):
            if len(values) != wanted:
                raise ValueError(f"a member has {len(values)} numbers {what}, but {wanted} are declared")
        return kept, found

    return replace(bank, function=member)


def _group(part: Component, jit: bool, width: int = 1) -> Group:
    step, values, tables = subject(part)
    if not jit:
        step = _sized(step)
    wires = {port.name: f"in.{port.name}" for port in step.inputs}
    node = Node("part", step, wires, values, tables, ring_length=part.ring_length(PERIOD))
    schedule = Schedule((node,), step.inputs, PERIOD, 1)
    return make_group(schedule, width, slice(0, width), jit)


def _outputs(group: Group) -> list[int]:
    step = group.schedule.nodes[0].step
    return [group.schedule.row(f"part.{port.name}") + i for port in step.outputs for i in range(port.rows)]


def _excitation(group: Group, scale: float) -> Array:
    """Return test inputs: sums of two sines, with different frequencies for each row."""
    n = rows(group.schedule.externals)
    t = np.arange(TICKS)[:, None] * 0.05
    channel = np.arange(n)[None, :]
    return np.asarray(scale * (np.sin((1.0 + 0.37 * channel) * t + channel) + 0.4 * np.sin((3.1 + 0.23 * channel) * t + 2.0 * channel)))


def _run(part: Component, scale: float, jit: bool, width: int = 1) -> Array:
    """Return all outputs, then the final states: (n_number, width)."""
    group = _group(part, jit, width)
    log = group.run(_excitation(group, scale), _outputs(group))
    return np.concatenate([log.reshape(-1, width), group.state[0]])


def _gap(one: Array, other: Array) -> float:
    """Return the largest difference over the largest magnitude (at least 1); NaN if either array has one."""
    return float(np.abs(one - other).max(initial=0.0)) / max(1.0, float(np.abs(other).max(initial=0.0)))


def _check_running(kind: type[Component], part: Component, scale: float, jit: bool) -> None:
    try:
        plain = _run(part, scale, False)
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # third-party code may raise anything
        raise _fault(kind, f"its step fails in plain Python: {error_text(error)}") from error
    if not np.isfinite(plain).all():
        raise _fault(kind, "an output or a state is not finite")
    if not np.array_equal(plain, _run(part, scale, False)):
        raise _fault(kind, "two runs differ: a step must depend on its arguments alone")
    _check_resume(kind, part, scale, False)
    for name, width in (("the compiled form", 1), ("the lanes", 32)) if jit else ():
        try:
            fast = _run(part, scale, True, width)
        except EngineError as error:
            raise _fault(kind, str(error)) from error
        except Exception as error:  # the compiler has exceptions of its own
            raise _fault(kind, f"its step cannot be compiled: {error_text(error)}") from error
        gap = _gap(fast, plain)
        if not gap <= AGREEMENT:
            raise _fault(kind, f"{name} and plain Python differ by {gap:.3g}")
    if jit:
        _check_resume(kind, part, scale, True)


def _check_resume(kind: type[Component], part: Component, scale: float, jit: bool) -> None:
    group = _group(part, jit)
    inputs, half = _excitation(group, scale), TICKS // 2
    whole = _group(part, jit).run(inputs, _outputs(group))
    first = group.run(inputs[:half], _outputs(group))
    saved = group.snapshot()
    rest = group.run(inputs[half:], _outputs(group))
    group.restore(saved)
    again = group.run(inputs[half:], _outputs(group))
    if not np.array_equal(rest, again):
        raise _fault(kind, "a restored run differs from the original: keep all memory in its states or its ring")
    if not np.array_equal(np.concatenate([first, rest]), whole):
        raise _fault(kind, "a run in two halves differs from one run: keep all memory in its states or its ring")


def _check_linear(kind: type[Component], part: Component) -> bool:
    """Check the linear model; return whether there is one."""
    model = part.linearize()
    # A ring is not part of the states, so the model of a delay cannot be checked.
    if model is None or kind.ring or kind.family not in SLOTS:
        return False
    step = part.make_step(2)
    if kind.family == "plant":
        from contourlab.components.mechanics.core import link
        from contourlab.components.registry import component

        part = part.linear()
        step = link(part, component("friction", "none")())
    tables = {name: Table(values) for name, values in part.table_values().items()}
    fault = linear_fault(model, step, lambda dt: {**part.block(dt), **tables})
    if fault:
        raise _fault(kind, f"its linear model differs from its step: {fault}")
    return True


def _check_passive(kind: type[Component], part: Component) -> bool:
    """Check that friction dissipates energy at every speed; return False for bristles, whose force depends on their past."""
    law = getattr(kind, "law", "")
    force: Any = getattr(kind, {"smooth": "force", "sticking": "sliding"}.get(law, ""), None)
    if kind.family != "friction" or force is None:
        return False
    par = part.constants()
    for speed in np.geomspace(1e-7, 10.0, 33):
        if not force(par, float(speed)) >= 0.0 or (law == "smooth" and not force(par, -float(speed)) <= 0.0):
            raise _fault(kind, f"adds energy at {speed:.3g} m/s: a friction force must oppose the motion")
    return True


def _check_effects(kind: type[Component], part: Component) -> None:
    before = [_run(part, scale, False) for scale in SCALES]
    for name, parameter in kind.parameters.items():
        if name in kind.without_effect:
            continue
        for value in _others(parameter, getattr(part, name)):
            try:
                changed = part.replace(**{name: value})
            except ContourlabError:
                continue
            if any(not np.array_equal(_run(changed, scale, False), old) for scale, old in zip(SCALES, before, strict=True)):
                break
        else:
            raise _fault(kind, f"parameter {name} has no effect on its outputs in the example")


def _others(parameter: Parameter, value: Any) -> list[Any]:
    """Return other values that a parameter might take."""
    if parameter.choices:
        return [choice for choice in parameter.choices if choice != value]
    if parameter.vector:
        return [tuple(v + 1.0 if parameter.whole else 0.5 * v + 0.1 for v in value)]
    if parameter.whole:
        return [value + 1.0, value - 1.0]
    return [0.6 * value + 0.01, 1.7 * value, 0.01 * value, 1.0]
