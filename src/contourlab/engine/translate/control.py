"""One tick of a controller for printing: named inputs, states, parameters and constants around the graph of the tick."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from contourlab.arrays import Array
from contourlab.engine.schedule import Schedule
from contourlab.engine.step import rows
from contourlab.engine.translate.graph import Op, prune
from contourlab.engine.translate.maths import EXACT
from contourlab.engine.translate.step_graph import Rows, TickGraph, tick_graph

LIBRARY = ("exp", "log", "tanh", "sin", "cos")
"""Operations that a mathematical library computes, each within about 1 ulp; all others are exact everywhere."""
IN_PLACE = ("constant", "parameter", "external", "before", "table", "size", "ring", "tick", "time", "period")
"""Kinds of operations that are printed without a variable of their own."""


@dataclass(frozen=True)
class Field:
    """A named number.

    Attributes
    ----------
    name, unit, doc : str
        The unit is empty for a plain number.
    value : float
        Of a parameter or constant; of a state at rest at position 0.
    slope : float
        Of a state: change of the value at rest for each metre of position.
    """

    name: str
    unit: str = ""
    doc: str = ""
    value: float = 0.0
    slope: float = field(default=0.0, metadata={"json": ""})

    def at_rest(self, position: str, literal: Callable[[float], str]) -> str:
        """Return the text of a state at rest at a position."""
        if self.slope == 0.0:
            return literal(self.value)
        moved = position if self.slope == 1.0 else f"({literal(self.slope)} * {position})"
        return moved if self.value == 0.0 else f"{literal(self.value)} + {moved}"


@dataclass(frozen=True)
class Memory:
    """An array of the controller: the members of a bank, a ring of past values, or a read-only table.

    Attributes
    ----------
    name : str
    first : int
        Row of memory where it begins; of a table its number.
    fields : tuple of Field
    """

    name: str
    first: int
    fields: tuple[Field, ...]


@dataclass(frozen=True)
class Control:
    """A controller to print.

    Attributes
    ----------
    name : str
        An identifier in every language.
    notes : tuple of str
        Lines of the head of every file: origin, hash, limits.
    period : float [s]
    tick : TickGraph
    result : Op
        The command.
    output : Field
    inputs, parameters, constants, states : dict of int to Field
        By row, those that are used. Parameters may be changed while it runs. Constants may not: others were computed from them.
    banks, rings, tables : tuple of Memory
    """

    name: str
    notes: tuple[str, ...]
    period: float
    tick: TickGraph
    result: Op
    output: Field
    inputs: dict[int, Field] = field(default_factory=dict)
    parameters: dict[int, Field] = field(default_factory=dict)
    constants: dict[int, Field] = field(default_factory=dict)
    states: dict[int, Field] = field(default_factory=dict)
    banks: tuple[Memory, ...] = ()
    rings: tuple[Memory, ...] = ()
    tables: tuple[Memory, ...] = ()

    @property
    def operations(self) -> list[Op]:
        """All operations of a tick, those of inner blocks included."""
        return [*self.tick.graph.top.every(), *self.tick.body.every()]

    @property
    def counts_ticks(self) -> bool:
        """Whether it uses the number of the tick."""
        return bool(self.rings) or any(op.kind in ("tick", "time") for op in self.operations)

    @property
    def calls_library(self) -> bool:
        """Whether it calls a function that is not exact everywhere: see `LIBRARY`."""
        return any(op.kind in LIBRARY for op in self.operations)

    @property
    def feedback(self) -> str:
        """The input that says where the axis is when the controller is switched on."""
        names = [field.name for field in self.inputs.values()]
        return next((name for name in ("position", "motor_position") if name in names), "reference")

    def array(self, op: Op) -> Memory:
        """Return the table, ring or bank that an operation takes or stores in."""
        if op.kind in ("table", "size"):
            return next(table for table in self.tables if table.first == (op.extra if op.kind == "table" else op.extra[1]))
        return next(memory for memory in (*self.rings, *self.banks) if 0 <= op.extra[0] - memory.first < len(memory.fields))

    def carried(self) -> list[tuple[int, Op]]:
        """Return the row of each state and its value after the tick."""
        return [(row, after) for _, row, after in self.tick.carried]


def control_of(
    schedule: Schedule,
    places: Rows,
    rest: Array,
    slope: Array,
    *,
    output: str,
    command: Field,
    inputs: Mapping[str, Field],
    parameters: Mapping[str, Field],
    constants: Mapping[str, Field],
    name: str,
    notes: tuple[str, ...],
) -> Control:
    """Return the controller that a schedule computes.

    Parameters
    ----------
    schedule : Schedule
    places : Rows
        Where memory has everything.
    rest, slope : ndarray (n_row,)
        Memory at rest at position 0, and its change for each metre of position.
    output : str
        Signal of the command.
    command : Field
        Its description.
    inputs, parameters, constants : mapping of str to Field
        Descriptions: of inputs by port, of the others by ``node.parameter``. A parameter in neither is a constant without a unit.
    name, notes : str, tuple of str
        As in `Control`.

    Raises
    ------
    EngineError
        If a step uses what cannot be translated; names file and line.
    """
    made = tick_graph(schedule, places, [schedule.row(output)], EXACT, contract=False)
    (result,) = made.log
    prune([made.graph.top, made.body], [*(op for _, _, op in made.carried), result])
    used = (*made.graph.top.every(), *made.body.every())
    reached = {(op.kind, op.extra) for op in used if op.kind in ("parameter", "external", "table")}
    free: dict[int, Field] = {}
    fixed: dict[int, Field] = {}
    states: dict[int, Field] = {}
    banks: list[Memory] = []
    rings: list[Memory] = []
    tables: list[Memory] = []

    def at(name: str, row: int) -> Field:
        return Field(name, "", "", float(rest[row]), float(slope[row]))

    def memory(name: str, first: int, size: int) -> Memory:
        return Memory(name, first, tuple(at("", first + k) for k in range(size)))

    for i, node in enumerate(schedule.nodes):
        label = _plain(node.name)
        for r, parameter in enumerate(node.step.parameters):
            row, key = places.parameters[i] + r, f"{node.name}.{parameter}"
            if ("parameter", row) in reached:
                known = parameters.get(key) or constants.get(key) or Field("")
                (free if key in parameters else fixed)[row] = Field(f"{label}_{parameter}", known.unit, known.doc, float(rest[row]))
        own = [f"{label}_{row}" for port in node.step.own_states for row in _rows_of(port.name, port.size)]
        states |= {places.states[i] + r: at(state, places.states[i] + r) for r, state in enumerate(own)}
        if node.step.bank:
            first = places.states[i] + len(own)
            banks.append(memory(f"{label}_members", first, rows((node.step.bank.port,))))
        if node.step.ring:
            rings.append(memory(f"{label}_past", places.rings[i], places.ring_lengths[i]))
        for table in node.step.tables:
            values = tuple(Field("", value=float(v)) for v in node.tables[table].ravel())
            tables.append(Memory(f"{label}_{table}", len(tables), values))
    late = {row: signal for signal, row in reversed(schedule.row_of.items())}
    for _, row, _ in made.carried:
        if row not in states:
            states[row] = at("last_" + _plain(late[row]), row)
    fed = [row for port in schedule.externals for row in _rows_of(port.name, port.size)]
    taken = {row: inputs[port] for row, port in enumerate(fed) if ("external", row) in reached}
    arrays = (tuple(banks), tuple(rings), tuple(table for table in tables if ("table", table.first) in reached))
    return Control(name, notes, schedule.period, made, result, command, taken, free, fixed, states, *arrays)


def _rows_of(name: str, size: int) -> Sequence[str]:
    return [f"{name}_{k}" for k in range(size)] if size else [name]


def _plain(signal: str) -> str:
    """Return an identifier for the signal of an axis, without the name of the axis."""
    return "".join(c if c.isalnum() else "_" for c in signal.partition(".")[2]).rstrip("_")
