"""The graph of one step: parameters, states, inputs and time go in, the next states and the outputs come out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from contourlab.engine.step import Port, Step, pack, record, rows, unpack
from contourlab.engine.translate.evaluate import Evaluator
from contourlab.engine.translate.graph import TABLE, Graph, MismatchError, Op
from contourlab.engine.translate.maths import EXACT
from contourlab.errors import EngineError
from contourlab.primitives import Clock


@dataclass(frozen=True)
class StepGraph:
    """A step as a graph.

    Attributes
    ----------
    step : Step
    graph : Graph
        Its leaves are ``parameter``, ``state``, ``input`` (``extra`` is the row), ``table``, and ``k``, ``t``, ``dt``.
    states : tuple of Op
        Next states, one for each row.
    outputs : tuple of Op
    """

    step: Step
    graph: Graph
    states: tuple[Op, ...]
    outputs: tuple[Op, ...]


def graph_of(step: Step, *, contract: bool = False, primitives: Mapping[Any, Any] = EXACT) -> StepGraph:
    """Return the graph of a step.

    Parameters
    ----------
    step : Step
    contract : bool
        Whether to make fused multiply-adds; without them the graph computes what plain Python computes, bit for bit.
    primitives : mapping
        Functions that become operations.

    Raises
    ------
    EngineError
        If the step uses what cannot be translated; names file and line.
    """
    graph = Graph(contract)
    run = Evaluator(graph, primitives)

    def leaves(kind: str, n: int) -> list[Op]:
        return [graph.op(kind, extra=row) for row in range(n)]

    values: list[Any] = leaves("parameter", len(step.parameters))
    values += [graph.op("table", (), TABLE, i) for i in range(len(step.tables))]
    values += [graph.op("ring", (), TABLE, 0)] if step.ring else []
    par = step.par_type(*values)
    states = leaves("state", rows(step.states))
    inputs = record_of(step.inputs, leaves("input", rows(step.inputs)))
    clock = Clock(*(graph.op(name) for name in Clock._fields))  # type: ignore[arg-type]
    following, out = once(run, step, par, states, inputs, clock)
    if contract:
        graph.fuse_products([*following, *out])
    graph.prune([*following, *out])
    return StepGraph(step, graph, following, out)


def once(run: Evaluator, step: Step, par: Any, states: Sequence[Op], inputs: Any, clock: Any) -> tuple[tuple[Op, ...], tuple[Op, ...]]:
    """Return next states and outputs of a step, its bank included, one value for each row.

    Raises
    ------
    EngineError
        If the step uses what cannot be translated; names file and line.
    """
    n_own, size = rows(step.own_states), step.bank.size if step.bank else 0
    own = record_of(step.own_states, list(states[:n_own]))
    found: tuple[Any, ...] = ()
    kept: list[Any] = []
    if step.bank:
        member: Any = (0.0,) * step.bank.n_found
        for m in range(step.bank.count):
            before = tuple(states[n_own + m * size : n_own + (m + 1) * size])
            after, member = run.call(step.bank.function, [par, own, before, member, float(m), inputs, clock])
            kept += after
        found = (member,)
    result = run.call(step.function, [par, own, inputs, clock, *found])
    try:
        following, out = result
        ended = [*pack(step.own_states, following), *kept], pack(step.outputs, out)
        first, second = (tuple(run.graph.number(value) for value in values) for values in ended)
    except (MismatchError, TypeError, ValueError) as error:
        code = step.function.__code__
        where = f"{code.co_filename}:{code.co_firstlineno}"
        raise EngineError(f"{where}: {step.name} must return its next states and its outputs as numbers: {error}") from error
    return first, second


def record_of(ports: tuple[Port, ...], values: list[Any]) -> Any:
    """Return the values of some ports as a named tuple; an empty tuple without ports."""
    return record(tuple(port.name for port in ports))(*unpack(ports, values)) if ports else ()
