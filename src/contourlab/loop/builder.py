"""Collect the nodes of a servo loop, and name the signals that its parts share: commands, and measurements on both sides of a drive.

Links are put into every wire between the base and the axes. The loop is first built without them. Then each node gets a side, and a wire
that crosses to the other side goes through a node of the link of that axis and direction. All signals that cross at a tick are one message:
the nodes of a direction share their noise stream, so that their signals arrive late or are lost together. The machine, the judge and the
recorder have no side.
"""

from __future__ import annotations

import hashlib
import math
import re
from collections.abc import Mapping
from copy import copy
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.components.ideal import IdealLink, IdealSensor, TrueVelocity
from contourlab.engine.step import Late, Node, Step, ports
from contourlab.engine.translate.tracing import Traced
from contourlab.errors import ParameterError, refuse
from contourlab.geometry import Path
from contourlab.loop.machine import SIDES, Axis, Controller, Machine
from contourlab.primitives import select

Overrides = Mapping[str, Any]
Signals = Mapping[str, tuple[str, ...]]
"""Signals of a result by name: one for each axis, or one for the machine."""


def check_seed(seed: object, name: str = "seed") -> None:
    """Raise ParameterError unless a seed, or the number of a trial, is a whole number >= 0."""
    refuse(not isinstance(seed, int | np.integer) or seed < 0, ParameterError, name, repr(seed), "a whole number >= 0")


def stream_of(seed: int, *words: object) -> float:
    """Return the number of a noise stream, below 2**48, from a seed and its use (variant, trial, axis, signal)."""
    return float(int.from_bytes(hashlib.sha256("/".join(map(str, (seed, *words))).encode()).digest()[:6], "big"))


def with_arrays(part: Any, values: Mapping[str, ArrayLike]) -> Any:
    """Return a copy of a component whose parameters have other values, unchecked: arrays of all variants."""
    other = copy(part)
    for name, value in values.items():
        object.__setattr__(other, name, value)
    return other


def _side_by_side(values: list[Any]) -> Any:
    """Return the values of all variants as an array; for a vector, a tuple of arrays."""
    return tuple(np.array(column) for column in zip(*values, strict=True)) if isinstance(values[0], tuple) else np.array(values)


@dataclass(eq=False)
class Builder:
    """Collect the nodes of a machine and its controller, in the order of a tick; arguments as of `contourlab.loop.template.build`."""

    machine: Machine
    controller: Controller
    path: Path
    start: Array
    progress: float
    overrides: Overrides
    seed: int | tuple[int, ...]
    trial: int
    fed: frozenset[str]
    velocity: Array | None = None
    handover_time: float | None = None

    def __post_init__(self) -> None:
        self.names, self.period = self.machine.axis_names, self.machine.servo_period
        self._check()
        self.speed = np.zeros(len(self.names)) if self.velocity is None else self.velocity
        for i, axis in enumerate(self.machine.axes):
            if axis.plant.takes_position and self.speed[i]:  # a moving count is a period behind its command
                late = 1.0 + getattr(self.controller.axes[axis.name].controller, "age", 0.0)
                self.start = self.start - late * self.period * self.speed * (np.arange(self.start.size) == i)
        self.nodes: list[Node] = []
        # For commands through a link: the signal that has arrived.
        self.arrived: dict[str, str] = {}

    def _check(self) -> None:
        given, coupling = self.controller.axes, self.controller.coupling
        missing = [name for name in self.names if name not in given]
        if missing:
            raise ParameterError("controller.axes", ", ".join(given) or "none", f"given for each axis; axis {missing[0]} is missing")
        if self.path.n_axis != len(self.names):
            bound = f"one for each axis of {self.machine.name}: {', '.join(self.names)}"
            raise ParameterError("path", f"{self.path.n_axis} coordinates", bound)
        for axis in self.machine.axes:
            for slot, law in given[axis.name].controllers.items():
                if axis.plant.takes_position != (law.command_unit == "m"):
                    fitting = '"steps"' if axis.plant.takes_position else "one that closes a loop"
                    bound = f"{fitting}: the commands of a {axis.plant.kind} are in {axis.plant.command_unit}"
                    raise ParameterError(f"controller.axes.{axis.name}.{slot}", f'"{law.kind}"', bound)
            for label, part in given[axis.name].filters if axis.plant.takes_position else ():
                gain = getattr(part, "rest_gain", 1.0)
                if abs(gain - 1.0) > 1e-9:
                    place = f"controller.axes.{axis.name}.filters.{label}"
                    raise ParameterError(place, f"with the gain {gain:g} at rest", "one with 1: the commands are positions")
        units = [axis.plant.command_unit for axis in self.machine.axes]
        if len(set(units)) > 1 and coupling is not None and coupling.gives("correction"):
            bound = f"one that acts on the reference, because the axes take commands in {', '.join(units)}"
            raise ParameterError("controller.coupling", f'"{coupling.kind}"', bound)

    def changed(self, prefix: str) -> dict[str, Any]:
        """Return the overrides of one component: parameter -> values over the variants."""
        head = prefix + "."
        return {name[len(head) :]: values for name, values in self.overrides.items() if name.startswith(head)}

    def add(self, name: str, part: Component, prefix: str, wires: Mapping[str, Any], at: float = 0.0) -> None:
        """Add the node of a component of one axis."""
        self.nodes.append(self.node(name, part, prefix, wires, at))

    def node(self, name: str, part: Component, prefix: str, wires: Mapping[str, Any], at: float = 0.0) -> Node:
        """Return the node of a component of one axis."""
        initial, start = part.at_rest(at)
        changed = self.changed(prefix)
        step, values = part.make_step(len(self.names)), self.values_of(part, prefix)
        return Node(name, step, wires, values, part.table_values(), initial, start, self.ring_length(part, changed))

    def ring_length(self, part: Component, changed: Overrides) -> int:
        """Return the length of a component's ring buffer, enough for every variant."""
        lengths = [part.ring_length(self.period)]
        traced = {name: values for name, values in changed.items() if isinstance(values, Traced)}
        if part.ring and traced:
            return with_arrays(part, traced).ring_length(self.period)  # type: ignore[no-any-return]
        for name, values in changed.items() if part.ring else ():
            lengths += [part.replace(**{name: float(extreme)}).ring_length(self.period) for extreme in (values.min(), values.max())]
        if part.ring and len(changed) > 1:  # two parameters may lengthen it together
            lengths.append(part.replace(**{name: float(values.max()) for name, values in changed.items()}).ring_length(self.period))
        return max(lengths)

    def accepted(self, axis: str) -> Any:
        """Return the wire of the last accepted command, as the axis' controller knows it: before its filters."""
        return f"{axis}.taken.accepted" if self.controlled_from_base(axis) else self.unfiltered_accepted(axis)

    def unfiltered_accepted(self, axis: str) -> Late:
        """Return the wire of the last command before the filters, less what the drive did not accept."""
        return Late(f"{axis}.unfiltered.accepted") if self.controller.axes[axis].filters else self.drive_accepted(axis)

    def drive_accepted(self, axis: str) -> Late:
        """Return the wire of the drive's last accepted command, after its limit and before its delay."""
        return Late(f"{axis}.drive.{accepted_output(self.machine.axis(axis).drive)}")

    def values_of(self, part: Component, prefix: str) -> dict[str, Any]:
        """Return the values of a component's parameters; noise depends on seed, axis, slot, trial and the stream that is given."""
        values = part.block(self.period, self.changed(prefix))
        if "stream" in part.parameters:
            axis, _, slot = prefix.removeprefix("controller.").removeprefix("axes.").partition(".")
            trial = (self.trial,) if self.trial else ()

            def mixed(seed: int, stream: float) -> float:
                return stream_of(seed, axis, slot, *trial, *((f"stream {stream:.0f}",) if stream else ()))

            drawn = np.vectorize(mixed)(self.seed, values["stream"])
            values["stream"] = drawn if drawn.ndim else float(drawn)
        return values

    def coupled(self, output: str) -> bool:
        """Return whether the coupling has this output."""
        return self.controller.coupling is not None and self.controller.coupling.gives(output)

    def command(self, axis: str) -> str:
        """Return the signal of the command to an axis' filters and drive, before any link."""
        return f"{axis}.compensated.command" if self.compensated_in_axis(axis) else self.wanted(axis)

    def filtered(self, axis: str) -> str:
        """Return the signal of the command to an axis' drive."""
        filters = self.controller.axes[axis].filters
        return f"{axis}.filter_{filters[-1][0]}.command" if filters else self.arrived.get(axis, self.command(axis))

    def wanted(self, axis: str) -> str:
        """Return the signal of the command from an axis' controller."""
        handed = self.controller.axes[axis].supervisor is not None or self.handover_time is not None
        return f"{axis}.{'handover' if handed else 'controller'}.command"

    def command_start(self, axis: str) -> float:
        """Return the command to an axis before the first tick: for a plant that takes positions its initial position."""
        return float(self.start[self.names.index(axis)]) if self.machine.axis(axis).plant.takes_position else 0.0

    def resting(self, axis: str) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return states and outputs of an axis' plant at rest, for each variant if they depend on a varied parameter."""
        plant, at = self.machine.axis(axis).plant, float(self.start[self.names.index(axis)])
        varied = {name: values for name, values in self.changed(f"axes.{axis}.plant").items() if name in plant.rest_depends}
        if all(isinstance(values, Traced) for values in varied.values()):
            return with_arrays(plant, varied).at_rest(at)  # type: ignore[no-any-return]
        rows = np.column_stack([*varied.values()]).tolist()
        resting = [plant.replace(**dict(zip(varied, row, strict=True))).at_rest(at) for row in rows]
        together = [{name: _side_by_side([rest[part][name] for rest in resting]) for name in resting[0][part]} for part in (0, 1)]
        return together[0], together[1]

    def motor_start(self, axis: str) -> Any:
        """Return the initial position of an axis' motor [m], for each variant if it depends on a varied parameter."""
        return self.resting(axis)[1].get("motor_position", float(self.start[self.names.index(axis)]))

    def controlled_from_base(self, axis: str) -> bool:
        """Return whether the commands of an axis go down its link."""
        link = self.controller.axes[axis].link
        return link is not None and not link.is_local("controller")

    def compensated_in_axis(self, axis: str) -> bool:
        """Return whether an axis subtracts its observer's estimate from the command that comes down to it."""
        parts = self.controller.axes[axis]
        if parts.link is None or parts.observer is None or not self.controlled_from_base(axis):
            return False
        return parts.link.is_local("observer") and any(part.takes("disturbance_estimate") for part in parts.controllers.values())


def accepted_output(drive: Component) -> str:
    """Return the output of a drive with the accepted command: after its limit, before its delay."""
    return "accepted" if drive.gives("accepted") else "applied"


def sum_step(n: int) -> Step:
    """Return the step that adds `n` signals, two or more."""
    return Step("sum", _total, inputs=ports("terms", size=n), outputs=ports("total"))


def _total(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    total = inp.terms[0]
    for i in range(1, len(inp.terms)):
        total = total + inp.terms[i]
    return (), (total,)


ZERO = Step("zero", lambda par, x, inp, clock: ((), (0.0,)), outputs=ports("value"))


class Sensing:
    """Sensors, predictor and velocity of one axis: adds the nodes and returns the wires.

    For a single-mass plant both sides are the same.

    Parameters
    ----------
    builder : Builder
        Collects the nodes.
    at : float [m]
        Initial position of the axis.
    """

    def __init__(self, builder: Builder, axis: Axis, at: float) -> None:
        self.builder, self.axis, self.name, self.at = builder, axis, axis.name, at
        self.parts = builder.controller.axes[axis.name]
        self._velocities: dict[str, str] = {}
        for side, slot in zip(SIDES, ("sensor", "motor_sensor"), strict=True):
            sensor = getattr(axis, slot)
            if not isinstance(sensor, IdealSensor):
                start = at if slot == "sensor" else builder.motor_start(axis.name)
                wires = {"position": Late(self._signal(side, "position"))}
                builder.add(f"{axis.name}.{slot}", sensor, f"axes.{axis.name}.{slot}", wires, start)
        if self.parts.predictor is not None:
            seen = {"position": self.measured, "applied": self.sent}
            builder.add(f"{self.name}.predictor", self.parts.predictor, f"controller.axes.{self.name}.predictor", seen, at)
        # Computed before every part that may need it.
        self.velocity_on(self.parts.velocity_feedback)

    def _signal(self, side: str, what: str) -> str:
        if side == "motor" and self.axis.plant.two_sided:
            return f"{self.name}.plant.motor_{what}"
        return f"{self.name}.plant.{self.axis.plant.measured if what == 'position' else what}"

    def position_on(self, side: str) -> Any:
        """Return the wire of the position measured on a side."""
        slot = "motor_sensor" if side == "motor" and self.axis.plant.two_sided else "sensor"
        ideal = isinstance(getattr(self.axis, slot), IdealSensor)
        return Late(self._signal(side, "position")) if ideal else f"{self.name}.{slot}.position"

    def velocity_on(self, side: str) -> Any:
        """Return the wire of the velocity on a side, computed from the position measured there."""
        if isinstance(self.parts.velocity, TrueVelocity):
            return Late(self._signal(side, "velocity"))
        if not self.axis.plant.two_sided:
            side = self.parts.velocity_feedback
        if side not in self._velocities:
            predicted = self.parts.predictor is not None and side == self.parts.velocity_feedback
            node = f"{self.name}.velocity" if side == self.parts.velocity_feedback else f"{self.name}.{side}_velocity"
            wires = {"position": self.position if predicted else self.position_on(side)}
            start = self.builder.motor_start(self.name) if side == "motor" else self.at
            self.builder.add(node, self.parts.velocity, f"controller.axes.{self.name}.velocity", wires, start)
            self._velocities[side] = f"{node}.velocity"
        return self._velocities[side]

    @property
    def measured(self) -> Any:
        """Wire of the position that the position loop uses."""
        return self.position_on(self.parts.feedback)

    @property
    def sent(self) -> Any:
        """Wire of the last command that the drive accepted, as a predictor knows it; in the base it does not know the filters."""
        return self.builder.accepted(self.name) if self.builder.controlled_from_base(self.name) else self.builder.drive_accepted(self.name)

    @property
    def position(self) -> Any:
        """Wire of the position that the controller sees: measured, or predicted."""
        return self.measured if self.parts.predictor is None else f"{self.name}.predictor.position"

    @property
    def velocity(self) -> Any:
        """Wire of the velocity that the controller sees."""
        return self.velocity_on(self.parts.velocity_feedback)

    def both_sides(self, port: str) -> Any:
        """Return the wire of a measured signal, such as ``motor_position`` or ``load_velocity``.

        With feedback from the motor side and a gap observer, the observer's estimates replace the measurements of the load.
        """
        side, _, what = port.partition("_")
        if side == "load" and self.parts.gap_observer is not None and self.parts.feedback == "motor":
            return f"{self.name}.gap_observer.{port}"
        return self.position_on(side) if what == "position" else self.velocity_on(side)

    def observed_gap(self, port: str) -> Any:
        """Return the wire of an output of the gap observer; the gap estimate is zero without an observer or below `SURE`.

        Raises
        ------
        ParameterError
            If a part needs the state of the gap and there is no gap observer.
        """
        if self.parts.gap_observer is None:
            if port == "gap_estimate":
                return 0.0
            raise ParameterError(f"controller.axes.{self.name}.gap_observer", '"none"', "given: the supervisor needs its outputs")
        observer, node = f"{self.name}.gap_observer", f"{self.name}.trusted_gap"
        if port != "gap_estimate":
            return f"{observer}.{port}"
        if all(known.name != node for known in self.builder.nodes):
            wires = {"gap": f"{observer}.gap", "confidence": f"{observer}.confidence"}
            self.builder.nodes.append(Node(node, _TRUSTED, wires, {}))
        return f"{node}.gap"


SURE = 0.9
"""Confidence from which the size of an observed gap replaces the controllers' own `backlash_gap`."""


_TRUSTED = Step(
    "trusted gap",
    lambda par, x, inp, clock: ((), (select(inp.confidence >= SURE, inp.gap, 0.0),)),
    inputs=ports("gap", "confidence"),
    outputs=ports("gap"),
)


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
    if getattr(builder.machine.axis(axis).drive, "limit", 0.0) == math.inf and "limit" not in builder.changed(f"axes.{axis}.drive"):
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

    def at(self, axis: str, label: str) -> Any:
        """Return the value of a signal on the other side before the first message."""
        if label.endswith("motor_position") or label == "motor_sensor_position":
            return self.builder.motor_start(axis)
        if label == "arc_length":
            return self.builder.progress
        if self.builder.command(axis) == f"{axis}.{label.replace('_', '.')}":
            return self.builder.command_start(axis)
        return float(self.builder.start[self.builder.names.index(axis)]) if _STANDING.search(label) else 0.0
