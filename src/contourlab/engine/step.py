"""What the engine runs: steps, and the schedule of nodes over one table of signals.

A step is a component as the engine sees it: a function and its ports. A node is a step with its wires, parameters and memory. Within a
tick the nodes run in order. A wire from a later node is a feedback edge: it is one tick late and must be marked as `Late`, so that no
delay is hidden. Nodes before the record point see the state of the machine at the tick; the plants come after it and advance the machine
to the next tick.
"""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import EngineError

StepFunction = Callable[..., tuple[tuple[Any, ...], tuple[Any, ...]]]


@dataclass(frozen=True, slots=True)
class Port:
    """A named input, output or state.

    Parameters
    ----------
    name : str
    size : int
        0 for one number, n > 0 for a vector of n, -1 for one row per axis.
    """

    name: str
    size: int = 0

    @property
    def rows(self) -> int:
        """Number of rows of the signal table that it takes."""
        return self.size if self.size > 0 else 1


def ports(*names: str, size: int = 0) -> tuple[Port, ...]:
    """Return one port for each name, all of one size."""
    return tuple(Port(name, size) for name in names)


@dataclass(frozen=True)
class Bank:
    """Identical members of a step, run in order in each tick before the step; compiled once for any number of members.

    Parameters
    ----------
    function : callable
        ``function(par, x, kept, found, index, inp, clock) -> (kept_next, found_next)``, x the step's own states.
    count : int
        Number of members; `index` counts them from 0.0.
    size : int
        Length of `kept`, the states of a member: its part of the step's last state port.
    n_found : int
        Length of `found`, passed from member to member (zeros to the first) and from the last to the step.
    """

    function: StepFunction
    count: int
    size: int
    n_found: int

    @property
    def port(self) -> Port:
        """The state port of all members, in order."""
        return Port("members", self.count * self.size)


@dataclass(frozen=True)
class Step:
    """A step function with its ports: everything that is compiled, and the key of the compiled code.

    Parameters
    ----------
    name : str
        Name for messages and profiles.
    function : callable
        ``function(par, x, inp, clock) -> (x_next, out)`` over named tuples of floats (vectors are tuples inside).
    parameters : tuple of str
        Parameter rows, derived ones included, in the order of the parameter block.
    tables : tuple of str
        Read-only tables, seen in `par` and read with `lookup`.
    ring : str
        Input port whose past is kept and read with ``delayed(par.ring, ...)``; empty for none.
    states, inputs, outputs : tuple of Port
        In the order in which the function takes and returns them.
    bank : Bank
        Members that run before the function. It is then called as ``function(par, x, inp, clock, found)`` and neither takes nor returns the
        last state port, that of the members.
    """

    name: str
    function: StepFunction
    parameters: tuple[str, ...] = ()
    tables: tuple[str, ...] = ()
    ring: str = ""
    states: tuple[Port, ...] = ()
    inputs: tuple[Port, ...] = ()
    outputs: tuple[Port, ...] = ()
    bank: Bank | None = None
    par_type: Any = field(init=False, repr=False, compare=False)
    n_state: int = field(init=False, repr=False, compare=False)
    _hash: int = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "par_type", record((*self.parameters, *self.tables, *(("ring",) if self.ring else ()))))
        object.__setattr__(self, "n_state", rows(self.states))
        # A run looks up the compiled form of each of its steps: the deep hash is computed once.
        object.__setattr__(self, "_hash", hash((self.name, self.function, self.bank, self.layout)))

    def __hash__(self) -> int:
        return self._hash

    @property
    def functions(self) -> tuple[StepFunction, ...]:
        """The function, and that of the bank."""
        return (self.function, self.bank.function) if self.bank else (self.function,)

    @property
    def own_states(self) -> tuple[Port, ...]:
        """The states that the function itself takes and returns: all except those of a bank."""
        return self.states[:-1] if self.bank else self.states

    @property
    def layout(self) -> tuple[Any, ...]:
        """Everything besides the function that determines the compiled code."""
        bank = (self.bank.count, self.bank.size, self.bank.n_found) if self.bank else ()
        return (self.parameters, self.tables, self.ring, self.states, self.inputs, self.outputs, bank)


def rows(ports: Iterable[Port]) -> int:
    """Return how many rows a group of ports takes."""
    return sum(port.rows for port in ports)


def unpack(ports: Iterable[Port], values: list[float]) -> list[Any]:
    """Shape a flat list of numbers into one value per port, vectors as tuples."""
    shaped: list[Any] = []
    start = 0
    for port in ports:
        shaped.append(tuple(values[start : start + port.size]) if port.size else values[start])
        start += port.rows
    return shaped


def pack(ports: Iterable[Port], values: Iterable[Any]) -> list[float]:
    """Flatten one value per port into a list of numbers."""
    return [number for port, value in zip(ports, values, strict=True) for number in (value if port.size else (value,))]


def misfit(step: Step, returned: Any) -> str:
    """Return why the result of a step function does not fit its ports, as text; empty if it fits."""
    if not isinstance(returned, tuple) or len(returned) != 2:
        return f"returns {_what(returned)}: end with  return x_next, out"
    for what, wanted, values in zip(("state", "output"), (step.own_states, step.outputs), returned, strict=True):
        if not isinstance(values, tuple):
            return f"returns {_what(values)} as its {what}s: write a tuple, such as (value,)"
        if len(values) != len(wanted):
            return f"returns {len(values)} {what}s, but declares {len(wanted)}: {', '.join(port.name for port in wanted) or 'none'}"
        for port, value in zip(wanted, values, strict=True):
            if port.size and (not isinstance(value, tuple) or len(value) != port.size):
                return f"returns {_what(value)} for {what} {port.name}, which is a tuple of {port.size}"
            if not port.size and isinstance(value, tuple):
                return f"returns {_what(value)} for {what} {port.name}, which is a number"
    return ""


def _what(value: Any) -> str:
    """Describe a value that was returned."""
    if value is None:
        return "nothing"
    if isinstance(value, tuple):
        return f"a tuple of {len(value)}"
    return repr(value) if isinstance(value, str) else "a number"


@cache
def record(fields: tuple[str, ...]) -> Any:
    """Return the named-tuple type with these fields (one type per set of fields, so that compiled code is shared)."""
    return namedtuple("Record", fields)


_NUMBER = (float, int)


@dataclass(frozen=True, slots=True)
class Late:
    """A feedback edge: a wire from a signal of the previous tick."""

    signal: str


Wire = str | Late | float
"""A signal (``"node.port"``, or ``"node.port[i]"`` of a vector), a feedback edge, or a constant."""


@dataclass(frozen=True, eq=False)
class Node:
    """One step in the schedule.

    Parameters
    ----------
    name : str
        Unique name, such as ``"x.controller"``.
    step : Step
        What it computes.
    wires : mapping of str to Wire or tuple of Wire
        Where each input port comes from; a vector port takes one wire for the whole vector or one for each axis.
    parameters : mapping of str to float or ndarray (n_variant,)
        Value of every parameter row of the step.
    tables : mapping of str to ndarray
        Read-only tables, shared by all variants.
    initial : mapping of str to float or tuple of float
        State at the first tick; zero by default. Values may be arrays (n_variant,).
    start : mapping of str to float or tuple of float
        Outputs before the first tick, for feedback edges and plants.
    ring_length : int
        Ticks of the ring port to keep (rounded up to a power of two).
    repeat : int
        Sub-steps per tick, with the inputs held.
    """

    name: str
    step: Step
    wires: Mapping[str, Wire | tuple[Wire, ...]] = field(default_factory=dict)
    parameters: Mapping[str, float | Array] = field(default_factory=dict)
    tables: Mapping[str, Array] = field(default_factory=dict)
    initial: Mapping[str, Any] = field(default_factory=dict)
    start: Mapping[str, Any] = field(default_factory=dict)
    ring_length: int = 0
    repeat: int = 1

    def __post_init__(self) -> None:
        for what, given, wanted in (
            ("wires", set(self.wires), {port.name for port in self.step.inputs}),
            ("parameters", set(self.parameters), set(self.step.parameters)),
            ("tables", set(self.tables), set(self.step.tables)),
        ):
            if given != wanted:
                raise EngineError(f"node {self.name}: {what} {sorted(given)} given, {sorted(wanted)} wanted")


@dataclass(frozen=True)
class Schedule:
    """Nodes in order, external signals for each tick, and the record point.

    Parameters
    ----------
    nodes : tuple of Node
        In the order of a tick.
    externals : tuple of Port
        Signals fed from outside, seen as ``"in.<port>"``; the same for all variants.
    period : float [s], > 0
        Period of a tick.
    record_point : int
        Number of nodes that run before signals are recorded.
    """

    nodes: tuple[Node, ...]
    externals: tuple[Port, ...]
    period: float
    record_point: int
    row_of: dict[str, int] = field(init=False, repr=False, compare=False)
    n_row: int = field(init=False, repr=False, compare=False)
    first_row: tuple[int, ...] = field(init=False, repr=False, compare=False)
    """For each node, the row of its first output."""
    sources: tuple[tuple[int | float, ...], ...] = field(init=False, repr=False, compare=False)
    """For each node, and each row of its inputs, the signal row (int) or the constant (float) that it takes."""

    def __post_init__(self) -> None:
        names = [node.name for node in self.nodes]
        if len(set(names)) != len(names):
            raise EngineError(f"two nodes share a name: {sorted({n for n in names if names.count(n) > 1})}")
        table: dict[str, int] = {}
        owners: list[int] = []
        first_row: list[int] = []
        for n, (owner, ports) in enumerate([("in", self.externals), *((node.name, node.step.outputs) for node in self.nodes)]):
            first_row.append(len(owners))
            for port in ports:
                row = len(owners)
                table[f"{owner}.{port.name}"] = row
                for i in range(port.size):
                    table[f"{owner}.{port.name}[{i}]"] = row + i
                owners += [n - 1] * port.rows
        object.__setattr__(self, "row_of", table)
        object.__setattr__(self, "n_row", len(owners))
        object.__setattr__(self, "first_row", tuple(first_row[1:]))
        object.__setattr__(self, "sources", tuple(self._sources(n, node, owners) for n, node in enumerate(self.nodes)))

    def row(self, signal: str) -> int:
        """Return the first row of a signal.

        Raises
        ------
        EngineError
            If no node has such an output.
        """
        if signal not in self.row_of:
            raise EngineError(f"no signal {signal!r}; there are {', '.join(k for k in self.row_of if '[' not in k)}")
        return self.row_of[signal]

    @cached_property
    def begin(self) -> tuple[Array, dict[int, Array]]:
        """Values of the rows of signals, states and parameters at the start: those of all variants, and by row those of each variant."""
        given = [*((node.step.outputs, node.start) for node in self.nodes), *((node.step.states, node.initial) for node in self.nodes)]
        values = [value for table, known in ((self.externals, {}), *given) for value in _rows_of(table, known)]
        values += [node.parameters[name] for node in self.nodes for name in node.step.parameters]
        own = {row: value for row, value in enumerate(values) if not isinstance(value, _NUMBER)}
        return np.array([0.0 if row in own else value for row, value in enumerate(values)]), own

    def _sources(self, n: int, node: Node, owners: list[int]) -> tuple[int | float, ...]:
        found: list[int | float] = []
        for port in node.step.inputs:
            wires = _spread(node.wires[port.name], port)
            if len(wires) != port.rows:
                raise EngineError(f"node {node.name}: input {port.name} takes {port.rows} wires, {len(wires)} given")
            for wire in wires:
                if isinstance(wire, _NUMBER):
                    found.append(float(wire))
                    continue
                signal = wire.signal if isinstance(wire, Late) else wire
                row = self.row(signal)
                if owners[row] == n:
                    raise EngineError(f"node {node.name} reads its own output {signal}: keep it as a state")
                if owners[row] > n and not isinstance(wire, Late):
                    raise EngineError(f"node {node.name} reads {signal}, which is computed later: mark the wire as Late")
                found.append(row)
        return tuple(found)


def _rows_of(ports: tuple[Port, ...], values: Mapping[str, Any]) -> list[Any]:
    """Return the value of each row of some ports; zero where none is given."""
    given = ((port, values.get(port.name)) for port in ports)
    return [row for port, value in given for row in ((0.0,) * port.rows if value is None else value if port.size else (value,))]


def _spread(wire: Wire | tuple[Wire, ...], port: Port) -> tuple[Wire, ...]:
    """Return one wire for each row of an input port."""
    if isinstance(wire, tuple):
        return wire
    if not port.size:
        return (wire,)
    if isinstance(wire, Late):
        return tuple(Late(f"{wire.signal}[{i}]") for i in range(port.size))
    return (float(wire),) * port.size if isinstance(wire, _NUMBER) else tuple(f"{wire}[{i}]" for i in range(port.size))
