"""The graph of one step: parameters, states, inputs and time go in, the next states and the outputs come out.

The graph of one tick of a whole schedule: wires become values, states and late signals are carried from tick to tick.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import accumulate
from typing import Any

from contourlab.engine.step import Bank, Port, Schedule, Step, misfit, pack, record, rows, unpack
from contourlab.engine.translate.evaluate import Evaluator
from contourlab.engine.translate.graph import TABLE, Block, Graph, MismatchError, Op, fuse_products, prune
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


_UNROLLED = 2
"""Most sub-steps that are written out; more are a loop."""


@dataclass(frozen=True)
class Rows:
    """Rows of memory: the first of each node's states, parameters and ring, and the length of each ring.

    Without rings a graph serves rings of any length, and names them by number.
    """

    states: Sequence[int]
    parameters: Sequence[int]
    rings: Sequence[int] = ()
    ring_lengths: Sequence[int] = ()


@dataclass
class TickGraph:
    """A tick.

    Attributes
    ----------
    graph : Graph
        Its top holds what is the same in every tick.
    body : Block
        The operations of a tick.
    carried : list of (Op, int, Op)
        A value before the tick, its row of memory, and the value after the tick.
    signals : list of (int, Op)
        Rows of signals and their values after the tick.
    log : list of Op
        Values to record.
    rings : list of int or (int, int)
        The number of each ring, which begins where those of the tables end; or its first row and its length.
    """

    graph: Graph
    body: Block
    carried: list[tuple[Op, int, Op]] = field(default_factory=list)
    signals: list[tuple[int, Op]] = field(default_factory=list)
    log: list[Op] = field(default_factory=list)
    rings: list[Any] = field(default_factory=list)


class _Builder:
    """Builds the graph of a tick, node by node."""

    def __init__(self, schedule: Schedule, places: Rows, primitives: Mapping[Any, Any], contract: bool, reads: Reads | None) -> None:
        self.schedule, self.places = schedule, places
        graph = Graph(contract)
        self.made = TickGraph(graph, Block(graph.top))
        self.graph, self.run = graph, Evaluator(graph, primitives, reads)
        graph.block = self.made.body
        self.n_external = rows(schedule.externals)
        self.now: dict[int, Op] = {}
        self.late: dict[int, Op] = {}
        self.tables = 0
        self.borders: list[Op] = []

    def signal(self, row: int) -> Op:
        """Return the value of a row: of this tick if it is there already, else of the last one."""
        if row < self.n_external:
            return self.graph.op("external", extra=row)
        if row in self.now:
            return self.now[row]
        if row not in self.late:
            self.late[row] = Op("before", (), "f", row)
        return self.late[row]

    def nodes(self, group: Sequence[int]) -> None:
        """Add nodes of which none reads another: they take their sub-steps in turn, so that a processor works on all of them at once."""
        begun, count = [self._begun(i) for i in group], self.schedule.nodes[group[0]].repeat
        edges = [*accumulate((len(states) + len(own) for states, own, _ in begun), initial=0)]

        def turn(part: Any, before: Sequence[Any]) -> list[Op]:
            parts = zip(edges, begun, strict=False)
            return [op for first, (states, _, substep) in parts for op in substep(part, before[first : first + len(states)])]

        after: list[Any] = [op for states, own, _ in begun for op in (*states, *(map(self.signal, own) if count > _UNROLLED else own))]
        if count > _UNROLLED:
            after = self.graph.repeat(count, after, turn)
        for r in range(count) if count <= _UNROLLED else ():
            after = turn(float(r), after)
        for first, (states, own, _) in zip(edges, begun, strict=False):
            self.made.carried += [(op, op.extra, value) for op, value in zip(states, after[first:], strict=False)]
            self.now |= dict(zip(own, after[first + len(states) :], strict=False))

    def _begun(self, i: int) -> tuple[list[Op], range, Callable[[Any, Sequence[Op]], list[Op]]]:
        """Return the states of a node, the rows of its outputs, and the function from states to both after a sub-step."""
        graph, node = self.graph, self.schedule.nodes[i]
        step, first, own = node.step, self.places.parameters[i], self.schedule.first_row[i]
        values: list[Any] = [graph.op("parameter", extra=first + r) for r in range(len(step.parameters))]
        values += [graph.op("table", (), TABLE, self.tables + n) for n in range(len(step.tables))]
        self.tables += len(step.tables)
        taken = [graph.constant(s) if isinstance(s, float) else self.signal(s) for s in self.schedule.sources[i]]
        if step.ring:
            places, number = self.places, len(self.made.rings) + sum(len(node.step.tables) for node in self.schedule.nodes)
            self.made.rings.append((places.rings[i], places.ring_lengths[i]) if places.rings else number)
            values.append(Op("ring", (), TABLE, self.made.rings[-1]))
            graph.effect("store_ring", [taken[ring_row(step)]], values[-1].extra)
        par, inputs = step.par_type(*values), record_of(step.inputs, taken)
        states = [Op("before", (), "f", self.places.states[i] + r) for r in range(rows(step.own_states))]
        members = self.places.states[i] + len(states)
        period = graph.op("period")
        held = graph.arithmetic("fdiv", period, float(node.repeat)) if node.repeat > 1 else period
        tick, time = graph.op("tick"), graph.op("time")

        def substep(part: Any, before: Sequence[Op]) -> list[Op]:
            graph.scope = i, part
            passed = graph.arithmetic("fmul", part, held)
            at = graph.arithmetic("fadd", time, passed) if node.repeat > 1 else time
            following, after = once(self.run, step, par, before, members, inputs, Clock(tick, at, held))  # type: ignore[arg-type]
            self.borders += (passed, *following, *after)
            return [*following, *after]

        return states, range(own, own + rows(step.outputs)), substep


def ring_row(step: Step) -> int:
    """Return the row of the inputs whose past the step keeps."""
    return [port.name for port in step.inputs for _ in range(port.rows)].index(step.ring)


def tick_graph(
    schedule: Schedule,
    places: Rows,
    log_rows: Sequence[int],
    primitives: Mapping[Any, Any],
    *,
    contract: bool = True,
    reads: Reads | None = None,
) -> TickGraph:
    """Return one tick of a schedule as a graph.

    Parameters
    ----------
    schedule : Schedule
    places : Rows
        Where the memory of a group has everything.
    log_rows : sequence of int
        Rows of signals to record, at the record point.
    primitives : mapping
        Functions that become operations.
    contract : bool
        Whether to make fused multiply-adds within each node.
    reads : Reads, optional
        Records what the steps read from outside; it begins at their functions.

    Raises
    ------
    EngineError
        If a step uses what cannot be translated.
    """
    builder = _Builder(schedule, places, primitives, contract, reads)
    made = builder.made
    nodes, rows_of, groups = schedule.nodes, schedule.first_row, list[list[int]]()
    for i, node in enumerate(nodes):
        first = groups[-1][0] if groups else 0
        read = any(isinstance(row, int) and rows_of[first] <= row < rows_of[i] for row in schedule.sources[i])
        if read or i in (0, schedule.record_point) or not nodes[first].repeat == node.repeat > 1:
            groups.append([])
        groups[-1].append(i)
    for group in (*groups, [len(nodes)]):
        if group[0] == schedule.record_point:
            made.log = [builder.signal(row) for row in log_rows]
        if group[0] < len(nodes):
            builder.nodes(group)
    made.carried += [(op, row, builder.now.get(row, op)) for row, op in builder.late.items()]
    fed = {row: made.graph.op("external", extra=row) for row in range(builder.n_external)}
    made.signals = [(row, op) for row, op in (fed | builder.now).items() if row not in builder.late]
    wanted = [*(op for _, _, op in made.carried), *(op for _, op in made.signals), *made.log]
    blocks = (made.graph.top, made.body)
    if contract:
        fuse_products(blocks, [*wanted, *builder.borders])
    prune(blocks, wanted)
    return made
