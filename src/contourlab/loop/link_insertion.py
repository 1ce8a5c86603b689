"""Put a link into every wire between the base and the axes.

The loop is first built without links. Then each node gets a side, and a wire that crosses to the other side goes through a node of the link
of that axis and direction. All signals that cross at a tick are one message: the nodes of a direction share their noise stream, so that
their signals arrive late or are lost together. The machine, the judge and the recorder have no side.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

from contourlab.components.ideal import IdealLink
from contourlab.engine.schedule import Late, Node
from contourlab.engine.step import Step, ports
from contourlab.errors import ParameterError
from contourlab.loop.builder import Builder
from contourlab.primitives import select

BASE = "base"
_IN_AXIS = ("plant", "drive", "sensor", "motor_sensor", "kept", "compensated", "unfiltered")
_STANDING = re.compile(r"(^|_)(position|reference|reference_total|reference_ahead)$")
"""Signals that equal the axis' initial position before the first message."""


_COMPENSATED = Step(
    "compensated",
    lambda par, x, inp, clock: ((), (inp.command - inp.estimate,)),
    inputs=ports("command", "estimate"),
    outputs=ports("command"),
)


def subtract_node(axis: str, command: str) -> Node:
    """Return the node in the axis that subtracts its observer's estimate from the base's command."""
    return Node(f"{axis}.compensated", _COMPENSATED, {"command": command, "estimate": f"{axis}.observer.disturbance_estimate"})


def _keep(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    whole = inp.accepted == inp.command
    return (), (select(whole, inp.received, inp.accepted + inp.estimate), select(whole, 0.0, 1.0))


def _take(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    # Commands under way count as accepted: an integral must not mistake the network for a limit.
    return (), (select(inp.short > 0.5, inp.taken, inp.own),)


_KEPT = Step("kept", _keep, (), (), "", (), ports("received", "command", "accepted", "estimate"), ports("taken", "short"))
_ECHO = Step("echo", lambda par, x, inp, clock: ((), (inp.own,)), inputs=ports("own"), outputs=ports("accepted"))
_TAKEN = Step("taken", _take, (), (), "", (), ports("own", "taken", "short"), ports("accepted"))


def add_taken(builder: Builder, axis: str) -> None:
    """Report to a controller in the base how much of its command the drive accepted.

    The axis reports the accepted command, its own estimate added back. The base regards its last command as accepted until a message says
    that the drive limited it.
    """
    if not builder.controlled_from_base(axis):
        return
    own = {"own": Late(builder.wanted(axis))}
    if not builder.may_limit(axis):
        builder.nodes.append(Node(f"{axis}.taken", _ECHO, own))
        return
    estimate = Late(f"{axis}.observer.disturbance_estimate") if builder.compensated_in_axis(axis) else 0.0
    wires = {"command": Late(builder.command(axis)), "accepted": builder.unfiltered_accepted(axis), "estimate": estimate}
    builder.nodes.append(Node(f"{axis}.kept", _KEPT, {**wires, "received": Late(builder.wanted(axis))}))
    builder.nodes.append(Node(f"{axis}.taken", _TAKEN, {**own, "taken": f"{axis}.kept.taken", "short": f"{axis}.kept.short"}))


def insert_links(builder: Builder) -> None:
    """Route the wires that cross a division through the links."""
    if any(builder.controller.axes[name].link is not None for name in builder.names):
        builder.nodes = _LinkInsertion(builder).nodes()


class _LinkInsertion:
    def __init__(self, builder: Builder) -> None:
        self.builder = builder
        self.order = {node.name: n for n, node in enumerate(builder.nodes)}
        self.known: dict[tuple[str, Any], Any] = {}
        self.before: dict[int, list[Node]] = {}

    def nodes(self) -> list[Node]:
        wired = [
            replace(node, wires={port: self.led(wire, self.side(node.name), n) for port, wire in node.wires.items()})
            for n, node in enumerate(self.builder.nodes)
        ]
        return [node for n in range(len(wired) + 1) for node in (*self.before.get(n, ()), *wired[n : n + 1])]

    def side(self, node: str) -> str:
        """Return the axis that holds a node, or `BASE`."""
        axis, _, part = node.partition(".")
        parts = self.builder.controller.axes.get(axis)
        if not part or parts is None or parts.link is None or axis not in self.builder.names:
            return BASE
        if part.startswith("filter_"):
            local = True
        elif part == "observer":
            local = parts.link.is_local("observer")
        elif part.endswith("velocity"):
            # After a predictor it is computed where the predictor is.
            local = parts.link.is_local("velocity" if parts.predictor is None or part != "velocity" else "predictor")
        else:
            local = part in _IN_AXIS or parts.link.is_local("controller")
        return axis if local else BASE

    def led(self, wire: Any, side: str, n: int) -> Any:
        """Return a wire to node `n` on a side, through a link if it comes from the other side."""
        if isinstance(wire, tuple):
            return tuple(self.led(one, side, n) for one in wire)
        signal = wire.signal if isinstance(wire, Late) else wire
        if not isinstance(signal, str):
            return wire
        source = self.side(signal.rpartition(".")[0])
        if source == side:
            return wire
        axis, direction = (source, "up") if side == BASE else (side, "down")
        key = (direction, wire)
        if key not in self.known:
            self.known[key] = self.link(axis, direction, wire, signal, n)
        return self.known[key]

    def link(self, axis: str, direction: str, wire: Any, signal: str, n: int) -> Any:
        """Add a node of a link and return the wire after it."""
        builder = self.builder
        part = getattr(builder.controller.axes[axis].link, direction)
        if part is None:
            raise ParameterError(f"controller.axes.{axis}.link.up", '"none"', f"a link, because the base needs {signal} of the axis")
        if isinstance(part, IdealLink):
            return wire
        label = re.sub(r"\[\d+\]", "", signal.partition(".")[2]).replace(".", "_")
        name, producer = f"{axis}.{direction}_{label}", self.order.get(signal.rpartition(".")[0], -1)
        sent, place, received = wire, n, f"{name}.received"
        if direction == "down" and isinstance(wire, Late):
            # The command that the axis received a tick ago, in the same message.
            sent, place = signal, producer + 1
        if name not in self.order:
            made = builder.node(name, part, f"controller.axes.{axis}.link.{direction}", {"sent": sent}, self.at(axis, label))
            self.before.setdefault(place, []).append(made)
            self.order[name] = place
            if signal == builder.command(axis) and direction == "down":
                builder.arrived[axis] = received
        return Late(received) if direction == "down" and isinstance(wire, Late) else received

    def at(self, axis: str, label: str) -> float:
        """Return the value of a signal on the other side before the first message."""
        if label.endswith("motor_position") or label == "motor_sensor_position":
            return self.builder.motor_start(axis)
        if label == "arc_length":
            return self.builder.progress
        return float(self.builder.start[self.builder.names.index(axis)]) if _STANDING.search(label) else 0.0
