"""Conformance test of components, built-in and third-party."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import Component, LinearModel, fault, file_of_class, line_in, response_of
from contourlab.components.declaration import check_class, check_documents, form_of
from contourlab.components.learning.law import LearningLaw, LearningProblem, TrialRecord
from contourlab.engine.runner import Group, make_group
from contourlab.engine.step import Node, Schedule, Step, record, rows
from contourlab.engine.translate.step_graph import graph_of
from contourlab.errors import ComponentError, ContourlabError, EngineError, error_text, refuse
from contourlab.primitives import Clock, Table

PERIOD = 1e-3
TICKS = 160
SCALES = (1.0, 1e-3)
AGREEMENT = 1e-9
SLOW = (1e-5, 1e-4, 1e-3, 1e-2)
"""Speeds [m/s] at which a friction is sized."""

DECLARED = "declarations and example"


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
    check_class(kind)
    check_documents(kind)
    try:
        return _checked(kind, jit)
    except KeyboardInterrupt:
        raise
    except ComponentError as error:
        if str(error).startswith(file_of_class(kind)):
            raise
        raise fault(kind, str(error)) from error
    except EngineError as error:
        own = error.file == file_of_class(kind)
        message = error.message.removeprefix(f"{kind.__name__}.") if own else str(error)
        raise fault(kind, message, line=error.line if own else 0) from error
    except BaseException as error:  # third-party code may raise anything
        raise fault(kind, f"its code fails: {error_text(error)}", line=line_in(file_of_class(kind), error)) from error


def _checked(kind: type[Component], jit: bool) -> tuple[str, ...]:
    try:
        part = kind(**kind.example)
    except ContourlabError as error:
        raise ComponentError(f"its example is not valid: {error}") from error
    _check_numbers(kind, part)
    if isinstance(part, LearningLaw):  # it has no step: it runs between trials
        check_learning(part)
        return DECLARED, "corrections of a trial"
    graph_of(subject(part)[0])
    linear = _check_linear(kind, part)
    plain = [_check_running(part, scale, jit) for scale in SCALES]
    passive = _check_passive(kind, part)
    _check_effects(part, plain, jit)
    checks = {
        DECLARED: True,
        "language of steps": True,
        f"{TICKS} ticks at {len(SCALES)} sizes: finite, repeatable, saved and restored": True,
        "compiled form and lanes agree with plain Python": jit,
        "linear model agrees with the step": linear,
        "takes energy at every speed": passive,
        f"every parameter has an effect ({len(kind.parameters)})": bool(kind.parameters),
    }
    return tuple(words for words, done in checks.items() if done)


def subject(part: Any) -> tuple[Step, dict[str, Any], dict[str, Any]]:
    """Return step, parameter values and tables of a component; a plant gets a friction, and a friction a plant."""
    period = _period(part)
    values = part.block(period)
    if part.family in ("plant", "friction"):
        return _linked(part, values, period)
    if part.family == "estimator":
        from contourlab.geometry import contour
        from contourlab.geometry.view import view_of

        view = view_of(contour("ellipse"), pieces=64)
        return part.path_step(view, 2), {**values, **view.parameters}, dict(view.tables)
    return part.make_step(2), values, part.table_values()


def _period(part: Any) -> float:
    """Return the period: as short as a plant asks for, with the numbers of its example."""
    return PERIOD / (type(part)(**part.example).fewest_substeps(PERIOD)[0] if part.family == "plant" else 1)


def _linked(part: Any, values: dict[str, Any], period: float) -> tuple[Step, dict[str, Any], dict[str, Any]]:
    from contourlab.components.mechanics.core import friction_prefix, link
    from contourlab.components.registry import component

    if part.family == "plant":
        rubs = not part.steps_itself or part.mobilities()
        friction = component("friction", "smooth-coulomb")(coulomb=0.1, breakaway=0.2) if rubs else component("friction", "none")()
        rubbing = {f"{friction_prefix(part)}{row}": value for row, value in friction.block(period).items()}
        return link(part, friction), values | rubbing, part.table_values()
    # A plant that overcomes the largest force against a slow motion.
    par, resistance = part.constants(), part.level if part.law == "bristle" else getattr(part, "force", None)
    size = max(1.0, *(float(part.held(par) if resistance is None else resistance(par, speed)) for speed in SLOW))
    plant = component("plant", "mass-damper")(mass=2.0 * size, force_constant=3.0 * size)
    return link(plant, part), plant.block(period) | values, {}


def _group(part: Component, jit: bool, width: int = 1, step: Step | None = None) -> tuple[Group, list[int]]:
    """Return a group of a component alone, and the rows of its outputs."""
    (own, values, tables), period = subject(part), _period(part)
    step = step or own
    wires = {port.name: f"in.{port.name}" for port in step.inputs}
    schedule = Schedule((Node("part", step, wires, values, tables, ring_length=part.ring_length(period)),), step.inputs, period, 1)
    outputs = [schedule.row(f"part.{port.name}") + i for port in step.outputs for i in range(port.rows)]
    return make_group(schedule, width, slice(0, width), jit), outputs


def _excitation(group: Group, scale: float) -> Array:
    """Return test inputs: sums of two sines, with different frequencies for each row."""
    t, channel = np.arange(TICKS)[:, None] * 0.05, np.arange(rows(group.schedule.externals))[None, :]
    return np.asarray(scale * (np.sin((1.0 + 0.37 * channel) * t + channel) + 0.4 * np.sin((3.1 + 0.23 * channel) * t + 2.0 * channel)))


def _run(part: Component, scale: float, jit: bool, width: int = 1, step: Step | None = None) -> Array:
    """Return all outputs, then the final states: (n_number, width)."""
    group, outputs = _group(part, jit, width, step)
    return np.concatenate([group.run(_excitation(group, scale), outputs).reshape(-1, width), group.state[0]])


def _gap(one: Array, other: Array) -> float:
    """Return the largest difference over the largest magnitude (at least 1); NaN if either array has one."""
    return float(np.abs(one - other).max(initial=0.0)) / max(1.0, float(np.abs(other).max(initial=0.0)))


def _check_running(part: Component, scale: float, jit: bool) -> Array:
    """Check all forms of a component; return what plain Python computes."""
    plain = _run(part, scale, False)
    if not np.isfinite(plain).all():
        raise ComponentError("an output or a state is not finite")
    if not np.array_equal(plain, _run(part, scale, False)):
        raise ComponentError("two runs differ: a step must depend on its arguments alone")
    _check_resume(part, scale, False, plain)
    for name, width in (("the compiled form", 1), ("the lanes", 32)) if jit else ():
        compiled = _run(part, scale, True, width)
        gap = _gap(compiled, plain)
        if not gap <= AGREEMENT:
            raise ComponentError(f"{name} and plain Python differ by {gap:.3g}")
        _check_resume(part, scale, True, compiled)
    return plain


def _check_resume(part: Component, scale: float, jit: bool, whole: Array) -> None:
    """Check that a run in two halves, the second of them twice, is the `whole` run."""
    group, outputs = _group(part, jit, whole.shape[1])
    first, second = np.array_split(_excitation(group, scale), 2)
    log = group.run(first, outputs)
    saved, halves = group.snapshot(), []
    for _ in range(2):
        both = log, group.run(second, outputs)
        halves.append(np.concatenate([*(one.reshape(-1, group.width) for one in both), group.state[0]]))
        group.restore(saved)
    cure = "keep all memory in its states or its ring"
    refuse(not np.array_equal(halves[0], halves[1]), ComponentError, f"a restored run differs from the original: {cure}")
    refuse(not np.array_equal(halves[0], whole), ComponentError, f"a run in two halves differs from one run: {cure}")


def _check_numbers(kind: type[Component], part: Component) -> None:
    """Check constants, tables, and the functions of plant or friction with numbers, before a step calls them."""
    part.block(PERIOD)
    for name in kind.numeric() if kind.derived else ():
        # In a batch each variant has its own value: `derive` must not branch on it or use the functions of `math`.
        try:
            part.block(PERIOD, {name: np.repeat(getattr(part, name), 2)})
        except (TypeError, ValueError) as error:
            message = f"derive must take arrays, one number for each variant: use the functions of numpy ({error_text(error)})"
            raise fault(kind, message, kind.derive) from error
    if set(part.table_values()) != set(kind.tables):
        raise fault(kind, f"table_values returns {sorted(part.table_values())}, but tables names {sorted(kind.tables)}", kind.table_values)
    for method in form_of(kind).methods if kind.family in ("plant", "friction") else ():
        if method.static and method.name != "step":
            value = getattr(kind, method.name)(part.constants(), *[0.1] * (len(method.arguments) - 1))
            if not isinstance(value, float | int):
                raise fault(kind, f"{method.name} returns {value!r}, not a number", getattr(kind, method.name))


def _check_passive(kind: type[Component], part: Component) -> bool:
    """Check that friction dissipates energy at every speed; return False for bristles, whose force depends on their past."""
    law = getattr(kind, "law", "")
    force: Any = getattr(kind, {"smooth": "force", "sticking": "sliding"}.get(law, ""), None)
    if kind.family != "friction" or force is None:
        return False
    par = part.constants()
    for speed in np.geomspace(1e-7, 10.0, 33).tolist():
        if not force(par, speed) >= 0.0 or (law == "smooth" and not force(par, -speed) <= 0.0):
            raise ComponentError(f"adds energy at {speed:.3g} m/s: a friction force must oppose the motion")
    return True


def _check_effects(part: Component, before: list[Array], jit: bool) -> None:
    step = subject(part)[0]
    for name in (name for name in part.parameters if name not in part.without_effect):
        for changed in _changed(part, name):
            after = [_run(changed, scale, False) for scale in SCALES]
            if not all(map(np.array_equal, after, before)):
                break
        else:
            cure = "change the example, or name it in `without_effect`"
            raise ComponentError(f"parameter {name} has no effect on its outputs in the example: {cure}")
        if name in part.numeric():
            # In a batch it differs between variants, which share the step: another one must compute the same.
            same = subject(changed)[0] == step
            if not same and not all(map(np.array_equal, (_run(changed, scale, False, 1, step) for scale in SCALES), after)):
                raise ComponentError(f"its step does not read parameter {name} from par: write par.{name}, or declare it structural")
        elif jit and not all(_gap(_run(changed, scale, True), new) <= AGREEMENT for scale, new in zip(SCALES, after, strict=True)):
            raise ComponentError(f"the compiled form does not follow parameter {name}")


def _changed(part: Any, name: str) -> Iterator[Any]:
    """Yield copies of a component with other values of a parameter."""
    parameter, value = part.parameters[name], getattr(part, name)
    if parameter.choices:
        others: list[Any] = [choice for choice in parameter.choices if choice != value]
    elif parameter.vector:
        others = [tuple(v + 1.0 if parameter.whole else 0.5 * v + 0.1 for v in value)]
    elif parameter.whole:
        others = [value + 1.0, value - 1.0]
    else:
        others = [0.6 * value + 0.01, 1.7 * value, 0.01 * value, 1.0]
    for other in others:
        with suppress(ContourlabError):  # out of its range
            yield part.replace(**{name: other})


SAMPLES = 400
AXES = (1, 2, 3)


def _wave(n_axis: int, phase: float, scale: float) -> Array:
    t, j = np.arange(SAMPLES)[:, None] * PERIOD, np.arange(n_axis)[None, :]
    return np.asarray(scale * (np.sin((11.0 + 3.0 * j) * t + phase + j) + 0.3 * np.sin((90.0 + 17.0 * j) * t + 2.0 * phase)))


def _problem(n_axis: int) -> LearningProblem:
    """Return a test problem: a curved path, and axes with different settling times of some tens of milliseconds."""
    j = np.arange(n_axis)
    columns = np.cos(np.linspace(0.0, 4.0, SAMPLES)[:, None] + 1.3 * j)
    decay = 0.9 + 0.02 * j
    impulse = np.concatenate([np.zeros((1, n_axis)), (1.0 - decay) * decay ** np.arange(300)[:, None]])
    # Slow near zero: a friction function is neither zero nor a sign everywhere.
    velocity = _wave(n_axis, 2.2, 5e-3)
    motion = velocity, np.asarray(np.gradient(velocity, PERIOD, axis=0))
    return LearningProblem(PERIOD, columns / np.linalg.norm(columns, axis=1, keepdims=True), lambda: impulse, lambda: motion)


def _trial(n_axis: int, problem: LearningProblem, scale: float = 1.0) -> TrialRecord:
    error = _wave(n_axis, 0.4, 1e-3 * scale)
    excess = np.where(np.abs(_wave(n_axis, 2.0, 1.0)) > 1.1, _wave(n_axis, 2.0, 0.1 * scale), 0.0)
    return TrialRecord(error, _wave(n_axis, 1.1, 0.2 * scale), excess, problem.across(error) * 0.9)


def _next(law: LearningLaw, n_axis: int) -> Array:
    problem = _problem(n_axis)
    return law.update(_wave(n_axis, 0.7, 0.05), _trial(n_axis, problem), problem)


def check_learning(law: LearningLaw) -> None:
    """Check a learning law.

    With one, two and three axes: shape, finite numbers, determinism, unchanged arguments, a zero table after a zero table and a trial
    without errors, and no wind-up where the drive saturated. Every parameter must have an effect with at least one target.

    Parameters
    ----------
    law : LearningLaw
        With the parameters of its example.

    Raises
    ------
    ComponentError
        At the first broken clause.
    """
    for n_axis in AXES:
        wrong = _learning_fault(law, n_axis)
        if wrong:
            raise ComponentError(f"{wrong}, with {n_axis} {'axis' if n_axis == 1 else 'axes'}")
    for name in (name for name in law.parameters if name not in law.without_effect):
        laws = [law.replace(target=target) for target in law.parameters["target"].choices]
        if all(np.array_equal(_next(changed, 2), _next(base, 2)) for base in laws for changed in _changed(base, name)):
            cure = "change the example, or name it in `without_effect`"
            raise ComponentError(f"parameter {name} has no effect on the table in the example: {cure}")


def _learning_fault(law: LearningLaw, n_axis: int) -> str:
    """Return the first broken clause; empty if there is none."""
    problem = _problem(n_axis)
    table, trial, none = _wave(n_axis, 0.7, 0.05), _trial(n_axis, problem), np.zeros((SAMPLES, n_axis))
    given = (table, trial.tracking_error, trial.feedback_command, trial.excess)
    kept = [array.copy() for array in given]
    updated = law.update(table, trial, problem)
    rest = law.update(none, _trial(n_axis, problem, 0.0), problem)
    if not isinstance(updated, np.ndarray) or updated.shape != table.shape or updated.dtype != np.float64:
        return f"its table is not an array of numbers of shape {table.shape}"
    if not np.isfinite(updated).all():
        return "its table is not finite"
    if not all(map(np.array_equal, kept, given)) or updated is table:
        return "it writes into its arguments: return a new array"
    if not np.array_equal(updated, _next(law, n_axis)):
        return "two updates from the same trial differ"
    if rest.any():
        return "it learns something from a trial without errors"
    if (trial.excess * (updated - table) > 0.0).any():
        return "it drives a saturated drive further into its limit"
    return ""


NUDGE = 1e-9
"""Perturbation of states and inputs: small enough for a step to be linear around rest."""

TICKS_PER_RADIAN = 1e5
TOLERANCE = 1e-3
"""Relative tolerance: a hundred times the sampling error at the highest frequency."""


def _check_linear(kind: type[Component], part: Component) -> bool:
    """Check the linear model; return whether there is one."""
    model = part.linearize()
    if not isinstance(model, LinearModel | None):
        raise fault(kind, f"linearize returns {model!r}: write a LinearModel, or None", kind.linearize)
    # A ring is not part of the states, so the model of a delay cannot be checked.
    if model is None or kind.ring:
        return False
    step = part.make_step(2)
    if kind.family == "plant":
        from contourlab.components.mechanics.core import link
        from contourlab.components.registry import component

        plant: Any = part
        for mobility in plant.mobilities() if plant.steps_itself else ():
            pushed = float(model.c[model.outputs.index("velocity")] @ model.b[:, model.inputs.index("load")])
            if not abs(pushed - mobility) <= 0.01 * abs(mobility):
                message = (
                    f"its mobility_value is {mobility:.4g}, but a load accelerates the mass of its velocity by {pushed:.4g} m/s^2 per force"
                )
                raise fault(kind, message, kind.derive)
        part = plant.linear()
        step = link(part, component("friction", "none")())
    if wrong := _linear_fault(model, step, part):
        raise fault(kind, f"its linear model differs from its step: {wrong}", kind.linearize)
    return True


def _linear_fault(model: LinearModel, step: Step, part: Component) -> str:
    """Return where a model and a step, at a period far below the model's time constants, differ; empty if they agree.

    Steps with vector ports are not compared.
    """
    inputs, outputs = ([port.name for port in ports] for ports in (step.inputs, step.outputs))
    for what, named, known in (("input", model.inputs, inputs), ("output", model.outputs, outputs)):
        for name in named:
            if name not in known:
                return f"it has no {what} {name!r}; the {what}s are: {', '.join(known)}"
    n, m, p = len(model.a), len(model.inputs), len(model.outputs)
    matrices = (model.a, model.b, model.c, model.d)
    shapes = tuple(map(np.shape, matrices))
    if shapes != ((n, n), (n, m), (p, n), (p, m)):
        return f"its matrices have shapes {shapes}, which do not fit {m} inputs and {p} outputs"
    if any(port.size for port in (*step.states, *step.inputs, *step.outputs)):
        return ""
    rates = np.abs(np.linalg.eigvals(model.a))
    rates = rates[rates > 1e-9 * rates.max(initial=0.0)] if rates.any() else np.ones(1)
    period = 1.0 / (TICKS_PER_RADIAN * float(rates.max()))
    tables = {name: Table(values) for name, values in part.table_values().items()}
    sampled = _sampled(step, {**part.block(period), **tables}, period)
    chosen = np.ix_([outputs.index(name) for name in model.outputs], [inputs.index(name) for name in model.inputs])
    for w in np.geomspace(0.1 * rates.min(), rates.max(), 7):
        expected, actual = response_of(*matrices, 1j * w)[0], response_of(*sampled, np.exp(1j * w * period))[0][chosen]
        for i, j in np.argwhere(~(np.abs(actual - expected) <= TOLERANCE * np.abs(expected))):
            return f"from {model.inputs[j]} to {model.outputs[i]} at {w:.3g} rad/s {expected[i, j]:.4g}, but the step {actual[i, j]:.4g}"
    return ""


def _sampled(step: Step, values: dict[str, Any], period: float) -> tuple[Array, Array, Array, Array]:
    """Return the matrices of one tick, by finite differences at rest."""
    par, n, size = step.par_type(**values), len(step.states), len(step.states) + len(step.inputs)
    state_type, input_type = (record(tuple(port.name for port in ports)) for ports in (step.states, step.inputs))

    def tick(at: Array) -> Array:
        x_next, out = step.function(par, state_type(*at[:n].tolist()), input_type(*at[n:].tolist()), Clock(0.0, 0.0, period))
        return np.array([*x_next, *out], dtype=float)

    rest = tick(np.zeros(size))
    matrix = np.column_stack([(tick(NUDGE * row) - rest) / NUDGE for row in np.eye(size)])
    return matrix[:n, :n], matrix[:n, n:], matrix[n:, :n], matrix[n:, n:]
