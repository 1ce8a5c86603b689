"""The graph of one step: parameters, states, inputs and time go in, the next states and the outputs come out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from contourlab.engine.step import Bank, Port, Step, misfit, pack, record, rows, unpack
from contourlab.engine.translate.evaluate import Evaluator
from contourlab.engine.translate.graph import TABLE, Graph, MismatchError, Op, fuse_products, prune
from contourlab.engine.translate.maths import EXACT
from contourlab.engine.translate.outer import Reads, file_of
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
        Next states, one for each row except those of a bank, which the graph itself reads (``member``) and stores (``store_member``).
    outputs : tuple of Op
    """

    step: Step
    graph: Graph
    states: tuple[Op, ...]
    outputs: tuple[Op, ...]


def graph_of(step: Step, *, contract: bool = False, primitives: Mapping[Any, Any] = EXACT, reads: Reads | None = None) -> StepGraph:
    """Return the graph of a step.

    Parameters
    ----------
    step : Step
    contract : bool
        Whether to make fused multiply-adds; without them the graph computes what plain Python computes, bit for bit.
    primitives : mapping
        Functions that become operations.
    reads : Reads, optional
        Records what the step reads from outside; it begins at the functions of the step.

    Raises
    ------
    EngineError
        If the step uses what cannot be translated; names file and line.
    """
    graph = Graph(contract)
    run = Evaluator(graph, primitives, reads)

    def leaves(kind: str, n: int) -> list[Op]:
        return [graph.op(kind, extra=row) for row in range(n)]

    values: list[Any] = leaves("parameter", len(step.parameters))
    values += [graph.op("table", (), TABLE, i) for i in range(len(step.tables))]
    values += [graph.op("ring", (), TABLE, 0)] if step.ring else []
    par = step.par_type(*values)
    states = leaves("state", rows(step.own_states))
    inputs = record_of(step.inputs, leaves("input", rows(step.inputs)))
    clock = Clock(*(graph.op(name) for name in Clock._fields))  # type: ignore[arg-type]
    following, out = once(run, step, par, states, len(states), inputs, clock)
    if contract:
        fuse_products([graph.top], [*following, *out])
    prune([graph.top], [*following, *out])
    return StepGraph(step, graph, following, out)


def once(
    run: Evaluator, step: Step, par: Any, states: Sequence[Op], members: int, inputs: Any, clock: Any
) -> tuple[tuple[Op, ...], tuple[Op, ...]]:
    """Return next states and outputs of a step, one value for each row; its bank advances in memory, from the row `members` on.

    Raises
    ------
    EngineError
        If the step uses what cannot be translated; names file and line.
    """
    own = record_of(step.own_states, list(states))
    found = (_bank(run, step.bank, par, own, members, inputs, clock),) if step.bank else ()
    result = run.call(step.function, [par, own, inputs, clock, *found])
    fault = misfit(step, result)
    try:
        if not fault:
            following, out = (pack(ports, values) for ports, values in zip((step.own_states, step.outputs), result, strict=True))
            return tuple(map(run.graph.number, following)), tuple(map(run.graph.number, out))
    except MismatchError as error:
        fault = str(error)
    function: Any = step.function
    raise EngineError(f"{function.__qualname__}: {fault}", file=file_of(function), line=function.__code__.co_firstlineno)


def _bank(run: Evaluator, bank: Bank, par: Any, own: Any, first: int, inputs: Any, clock: Any) -> tuple[Op, ...]:
    """Advance the members of a bank in memory; return what the last one found."""
    graph = run.graph

    def one(index: Op, found: list[Op]) -> Sequence[Any]:
        kept = tuple(graph.op("member", (index,), extra=(first + j, bank.size)) for j in range(bank.size))
        after, found_next = run.call(bank.function, [par, own, kept, tuple(found), index, inputs, clock])
        if len(after) != bank.size:
            raise EngineError(f"a member of the bank returns {len(after)} numbers, but declares {bank.size}")
        for j, value in enumerate(after):
            graph.effect("store_member", [graph.number(value), index], (first + j, bank.size))
        return found_next  # type: ignore[no-any-return]

    return tuple(graph.repeat(bank.count, (0.0,) * bank.n_found, one))


def record_of(ports: tuple[Port, ...], values: list[Any]) -> Any:
    """Return the values of some ports as a named tuple; an empty tuple without ports."""
    return record(tuple(port.name for port in ports))(*unpack(ports, values)) if ports else ()
