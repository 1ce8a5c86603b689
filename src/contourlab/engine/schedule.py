"""The schedule: an ordered list of nodes over one table of signals.

A node is a step with its wires, parameters and memory. Within a tick the nodes run in order. A wire from a later node is a feedback edge:
it is one tick late and must be marked as `Late`, so that no delay is hidden. Nodes before the record point see the state of the machine at
the tick; the plants come after it and advance the machine to the next tick.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from contourlab.arrays import Array
from contourlab.engine.step import Port, Step
from contourlab.errors import EngineError

_NUMBER = (float, int)


@dataclass(frozen=True, slots=True)
class Late:
    """A feedback edge: a wire from a signal of the previous tick."""

    signal: str


Wire = str | Late | float
"""A signal (``"node.port"``, or ``"node.port[i]"`` of a vector), a feedback edge, or a constant."""


@dataclass(frozen=True)
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


def _spread(wire: Wire | tuple[Wire, ...], port: Port) -> tuple[Wire, ...]:
    """Return one wire for each row of an input port."""
    if isinstance(wire, tuple):
        return wire
    if not port.size:
        return (wire,)
    if isinstance(wire, Late):
        return tuple(Late(f"{wire.signal}[{i}]") for i in range(port.size))
    return (float(wire),) * port.size if isinstance(wire, _NUMBER) else tuple(f"{wire}[{i}]" for i in range(port.size))
