"""The servo loop: slots in the order of a tick, turned into a schedule of nodes.

At each tick, for every axis,

1. the **sensor** measures the plant's position; a **predictor** predicts it after a delay; the **velocity** is computed from that;
2. the **estimator** sees all axes as measured and the path, the **coupling** turns its contour error into a modified reference, or into a
   correction of the commands;
3. the **observer** estimates the disturbance of the axis, from its velocity and its last accepted command (one tick late); the **gap
   observer** estimates the motor's position in the gap;
4. the **feedforward** and the **compensation** of backlash act on the reference, the **controller** computes a command, to which the
   correction and the learned table are added; a **supervisor** chooses among several controllers; **filters** pass the command on to
   the **drive**, which delays and limits it;

signals are recorded here, and then

5. the **disturbance** and the reaction of axes mounted on top act on the **plant**, which moves to the next tick with its command held.

Ideal parts have no node: their wires bypass them. If the controller of an axis is divided between base and axis, the signals between the
two pass the nodes of a link: see `contourlab.loop.builder`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.components.mechanics.core import MOTOR_FRICTION, friction_prefix, link, moves_its_count
from contourlab.engine.step import Late, Node, Port, Schedule, Step, ports
from contourlab.errors import ParameterError
from contourlab.geometry import Path
from contourlab.geometry.view import PathView, view_of
from contourlab.loop.builder import ZERO, Builder, Overrides, Sensing, Signals, add_taken, check_seed, insert_links, subtract_node, sum_step
from contourlab.loop.feeding import (
    AHEAD,
    ALONG,
    CURVATURE,
    DECIDED,
    EXTERNALS,
    LEARNED_COMMAND,
    LEARNED_REFERENCE,
    RATE,
    SOURCE_LINE,
)
from contourlab.loop.judging import axis_positions, watch_node
from contourlab.loop.machine import Axis, Controller, Machine
from contourlab.primitives import maximum, minimum, select


def add_plants(builder: Builder) -> None:
    """Add the loads on the axes, and their plants with linked frictions."""
    for axis, speed in zip(builder.machine.axes, builder.speed, strict=True):
        name, prefix = axis.name, f"axes.{axis.name}"
        load: Any = 0.0
        if axis.disturbance is not None:
            builder.add(f"{name}.disturbance", axis.disturbance, f"{prefix}.disturbance", {"position": Late(f"{name}.plant.position")})
            load = f"{name}.disturbance.force"
        # Two modules that move along each other exchange the inertia force of the mass that the upper one moves.
        partners = {a.name: a.alignment * _moved_mass(builder, a) for a in builder.machine.axes if a.mounted_on == name and a.alignment}
        if axis.mounted_on and axis.alignment:
            partners[axis.mounted_on] = axis.alignment * _moved_mass(builder, axis)
        if partners:
            forces: dict[str, Any] = {f"acceleration_{other}": Late(f"{other}.plant.acceleration") for other in partners}
            masses = {f"mass_{other}": mass for other, mass in partners.items()}
            step = Step("load", _react, tuple(masses), inputs=ports("load", *forces), outputs=ports("force"))
            builder.nodes.append(Node(f"{name}.load", step, {"load": load, **forces}, masses))
            load = f"{name}.load.force"
        rubbing = axis.friction.block(builder.period, builder.changed(f"{prefix}.friction"))
        values = _carrying(builder, axis) | {f"{friction_prefix(axis.plant)}{row}": value for row, value in rubbing.items()}
        on_motor = axis.motor_friction.block(builder.period, builder.changed(f"{prefix}.motor_friction"))
        values |= {f"{MOTOR_FRICTION}{row}": value for row, value in on_motor.items()}
        initial, start = builder.resting(name)
        if speed and axis.plant.steps_itself and all(port.name != "velocity" for port in axis.plant.states):
            raise ParameterError("moving", "true", f"false: a {axis.plant.kind} names no state velocity")
        initial = {**initial, **_speeds(axis.plant.states, float(speed))}
        start = {**start, **_speeds(axis.plant.outputs, float(speed))}
        pushed: dict[str, Any] = {"command": f"{name}.drive.applied", "load": load}
        step, tables = link(axis.plant, axis.friction, axis.motor_friction, axis.substeps), axis.plant.table_values()
        repeat = 1 if moves_its_count(axis.plant) else axis.substeps
        builder.nodes.append(Node(f"{name}.plant", step, pushed, values, tables, initial, start, repeat=repeat))
        if axis.error.backlash:
            flanks, rest = {"half": 0.5 * axis.error.backlash}, start["position"]
            behind = Node(f"{name}.play", PLAY, {"at": f"{name}.plant.position"}, flanks, {}, {"left": rest}, {"position": rest})
            builder.nodes.append(behind)


def _speeds(ports: tuple[Port, ...], speed: float) -> dict[str, Any]:
    """Return the values of the velocity ports, with all masses of the axis at one speed."""
    moving = [port for port in ports if port.name in ("velocity", "motor_velocity", "inner_velocities")]
    return {port.name: (speed,) * port.size if port.size else speed for port in moving}


def _carrying(builder: Builder, axis: Axis) -> dict[str, Any]:
    """Return the parameters of an axis' plant, with the modules mounted on it."""
    changed, carried = builder.changed(f"axes.{axis.name}.plant"), builder.machine.carried_mass(axis.name)
    if carried:
        own = np.asarray(axis.plant.values()["carried_mass"])
        changed["carried_mass"] = changed.get("carried_mass", own) + carried
    return axis.plant.block(builder.period / axis.substeps, changed)


def _moved_mass(builder: Builder, axis: Axis) -> Any:
    """Return the mass [kg] in linear motion of an axis: a number, or an array (n_variant,)."""
    return type(axis.plant).moved_mass(SimpleNamespace(**_carrying(builder, axis)))


def _react(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    """Sum the loads on an axis: its disturbance, and the inertia of axes that move along it."""
    load = inp.load
    for i in range(len(par)):
        load = load - par[i] * inp[i + 1]
    return (), (load,)


def conditioned(part: Component) -> Component:
    """Return a controller that can run in parallel with others: with back-calculation, since a held integral would not follow."""
    held = "anti_windup" in part.parameters and part.values()["anti_windup"] == "hold"
    if held and "back-calculation" in part.parameters["anti_windup"].choices:
        part = part.replace(anti_windup="back-calculation")
    return part


def handover_step(n: int) -> Step:
    """Return the step that passes on the active one of `n` commands, and hands over without a bump.

    All controllers run all the time, on the same measurements. Each gets an accepted command. For the active one it is the accepted part of
    its own command, minus the hand-over offset. For the others it is the executed command, so that their integrals follow it. The remaining
    difference at a switch becomes an offset, which decays with the supervisor's `handover_time`.
    """
    inputs, outputs = (Port("commands", n), *ports("active", "accepted")), ports("command", "active", "offset")
    return Step("handover", _hand_over, ("kept", "blended"), (), "", ports("active", "offset"), inputs, outputs)


def _hand_over(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    # The next command of the previous controller; for one of another loop its last command.
    wanted, left = inp.commands[0], select(x.active < 0.0, inp.accepted, inp.commands[0] + x.offset)
    for i in range(1, len(inp.commands)):
        wanted = select(inp.active == float(i), inp.commands[i], wanted)
        left = select(x.active == float(i), inp.commands[i] + x.offset, left)
    offset = select(inp.active == x.active, x.offset, par.blended * (left - wanted))
    # A non-finite output of a supervisor must end the run, not leave the axis without a command.
    return (inp.active, par.kept * offset), (wanted + offset + 0.0 * inp.active, inp.active, offset)


def _behind_play(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    left = minimum(maximum(x.left, inp.at - par.half), inp.at + par.half)
    return (left,), (left,)


PLAY = Step("play", _behind_play, ("half",), states=ports("left"), inputs=ports("at"), outputs=ports("position"))
"""The position behind a play of twice `half`: friction holds it until a flank pushes."""

ACCEPTED = Step(
    "told",
    lambda par, x, inp, clock: ((), (inp.accepted - select(inp.active == inp.number, inp.offset, 0.0),)),
    inputs=ports("accepted", "active", "offset", "number"),
    outputs=ports("accepted"),
)
"""Accepted part of the command of the controller with this number."""


def handover_parameters(handover_time: Any, dt: float) -> dict[str, Any]:
    """Return the parameters of the step for a time constant [s]; with zero the command jumps."""
    blended = np.where(handover_time > 0.0, 1.0, 0.0)
    return {"kept": np.exp(-dt / np.where(handover_time > 0.0, handover_time, np.inf)) * blended, "blended": blended}


NOTHING = "none.value"
"""Signal, always zero, of an axis without a part that others have."""

_OBSERVED = {
    "gap_estimate": "gap",
    "gap_deviation": "gap_deviation",
    "gap_state_estimate": "gap_state",
    "gap_confidence": "confidence",
    "load_position_estimate": "load_position",
    "load_velocity_estimate": "load_velocity",
}


def signal_map(builder: Builder, sensing: Mapping[str, Sensing]) -> dict[str, tuple[str, ...]]:
    """Return the signals of a result by name: one per axis, or one for the machine."""

    def plain(wire: Any) -> str:
        return str(wire.signal if isinstance(wire, Late) else wire)

    signals = {
        "position": tuple(plain(sensing[name].measured) for name in builder.names),
        "axis_position": axis_positions(builder.machine),
        "axis_velocity": tuple(f"{name}.plant.velocity" for name in builder.names),
        "velocity": tuple(plain(sensing[name].velocity) for name in builder.names),
        "command": tuple(map(builder.filtered, builder.names)),
        "applied_command": tuple(f"{name}.drive.applied" for name in builder.names),
    }
    if any(builder.controller.axes[name].filters for name in builder.names):
        signals["unfiltered_command"] = tuple(builder.arrived.get(name, builder.command(name)) for name in builder.names)
    signals |= _inside(builder)
    if all(builder.controller.axes[name].observer is not None for name in builder.names):
        signals["disturbance_estimate"] = tuple(f"{name}.observer.disturbance_estimate" for name in builder.names)
    if builder.controller.estimator is not None:
        signals["contour_error_estimate"] = ("estimator.contour_error_estimate",)
    for output, signal in (("modified_reference", "modified_reference"), ("correction", "coupling_command")):
        if builder.coupled(output):
            signals[signal] = tuple(f"coupling.{output}[{j}]" for j in range(len(builder.names)))
    return signals


def _inside(builder: Builder) -> dict[str, tuple[str, ...]]:
    """Return the internal signals that only some axes have; zero, or the load's signal, for the others."""
    split = {axis.name: axis.plant.two_sided for axis in builder.machine.axes}
    gapped = {axis.name: axis.plant.gives("gap_state") for axis in builder.machine.axes}
    led = {name: builder.controller.axes[name].supervisor is not None for name in builder.names}
    watched = {name: builder.controller.axes[name].gap_observer is not None for name in builder.names}
    groups: tuple[tuple[dict[str, bool], dict[str, tuple[str, str]]], ...] = (
        (split, {f"motor_{what}": (f"plant.motor_{what}", f"plant.{what}") for what in ("position", "velocity")}),
        (gapped, {"gap_state": ("plant.gap_state", NOTHING), "shaft_force": ("plant.shaft_force", NOTHING)}),
        (led, {"active_controller": ("supervisor.active", NOTHING), "switch_reason": ("supervisor.reason", NOTHING)}),
        (watched, {signal: (f"gap_observer.{port}", NOTHING) for signal, port in _OBSERVED.items()}),
    )
    inside: dict[str, tuple[str, ...]] = {}
    for having, signals in groups:
        for signal, (there, otherwise) in signals.items() if any(having.values()) else ():
            inside[signal] = tuple(f"{name}.{there if having[name] else otherwise}" for name in builder.names)
    for name in {wire.partition(".")[0] for wires in inside.values() for wire in wires if wire.endswith(NOTHING)}:
        builder.nodes.append(Node(f"{name}.{NOTHING.partition('.')[0]}", ZERO))
    return inside


@dataclass(frozen=True)
class Wiring:
    """A schedule, and the signals of a result in it."""

    schedule: Schedule
    signals: Signals


UNFILTERED = Step(
    "unfiltered",
    # Exactly the command while the drive accepts everything: a filter must not look like a limit.
    lambda par, x, inp, clock: ((), (inp.command - (inp.filtered - inp.accepted),)),
    inputs=ports("command", "filtered", "accepted"),
    outputs=ports("accepted"),
)
"""A command before its filters, less what the drive did not accept of it after them."""
SINGLE = (*ALONG, CURVATURE, RATE)
"""Inputs with one number; all others have one for each axis."""


class _Slots(Builder):
    """Fill the slots of the loop, with one method for each part of a tick."""

    def __post_init__(self) -> None:
        super().__post_init__()
        self.sensing: dict[str, Sensing] = {}

    def sense(self) -> None:
        for axis, at in zip(self.machine.axes, self.start, strict=True):
            add_taken(self, axis.name)
            self.sensing[axis.name] = Sensing(self, axis, float(at))

    def contour(self, view: PathView | None) -> None:
        estimator, coupling = self.controller.estimator, self.controller.coupling
        offered: dict[str, Any] = {"position": tuple(self.sensing[name].measured for name in self.names)}
        if estimator is not None:
            seen = view or view_of(self.path)
            step = estimator.path_step(seen, len(self.names))  # type: ignore[attr-defined]
            parameters = {**self.values_of(estimator, "controller.estimator"), **seen.parameters}
            wires: dict[str, Any] = {"position": offered["position"], "arc_length": "in.arc_length"}
            self.nodes.append(Node("estimator", step, wires, parameters, seen.tables, {"foot": self.progress}))
            offered |= {port.name: f"estimator.{port.name}" for port in step.outputs}
        if coupling is None:
            return
        offered |= {name: f"in.{name}" for name in (*EXTERNALS, *ALONG, CURVATURE)}
        offered["velocity"] = tuple(self.sensing[name].velocity for name in self.names)
        offered["command"] = tuple(Late(self.wanted(name)) for name in self.names)
        offered["accepted"] = tuple(self.accepted(name) for name in self.names)
        if coupling.takes("disturbance_estimate"):
            offered["disturbance_estimate"] = tuple(self.estimate(name) for name in self.names)
        made = self.node("coupling", coupling, "controller.coupling", {port.name: offered[port.name] for port in coupling.inputs})
        # Before the first tick the motion advances as planned.
        self.nodes.append(replace(made, start={**made.start, RATE: 1.0}) if coupling.gives(RATE) else made)

    def estimate(self, name: str) -> Late:
        """Return the wire of the last estimate of an axis' observer."""
        if self.controller.axes[name].observer is None:
            raise ParameterError(f"controller.axes.{name}.observer", '"none"', "given: the coupling takes its disturbance_estimate")
        return Late(f"{name}.observer.disturbance_estimate")

    def control(self) -> None:
        for j, (axis, at) in enumerate(zip(self.machine.axes, self.start, strict=True)):
            name, parts, prefix = axis.name, self.controller.axes[axis.name], f"controller.axes.{axis.name}"
            applied, seen = Late(f"{name}.drive.applied"), self.sensing[name]
            if parts.observer is not None:
                # A predicted velocity belongs to the commands before their delay.
                wires = {"position": seen.position, "velocity": seen.velocity, "applied": applied if parts.predictor is None else seen.sent}
                wires = {port.name: wires[port.name] for port in parts.observer.inputs}
                self.add(f"{name}.observer", parts.observer, f"{prefix}.observer", wires, float(at))
            offered: dict[str, Any] = {signal: f"in.{signal}[{j}]" for signal in EXTERNALS}
            offered |= {AHEAD: f"in.{AHEAD}[{j}]", "arc_length": "in.arc_length", "applied": applied, "accepted": self.accepted(name)}
            offered[SOURCE_LINE] = f"in.{SOURCE_LINE}[{j}]"
            if parts.gap_observer is not None and not axis.plant.two_sided:
                bound = "left out: the drive of this axis is rigid, without a gap"
                raise ParameterError(f"controller.axes.{name}.gap_observer", repr(parts.gap_observer.kind), bound)
            for slot in ("gap_observer", "feedforward", "compensation"):
                part = getattr(parts, slot)
                if part is not None:
                    self.add(f"{name}.{slot}", part, f"{prefix}.{slot}", self.wires_of(part, name, offered), float(at))
            here = self.compensated_in_axis(name)
            offered |= {
                "reference": self.followed(name, j),
                "position": seen.position,
                "velocity": seen.velocity,
                "disturbance_estimate": f"{name}.observer.disturbance_estimate" if parts.observer is not None and not here else 0.0,
                "feedforward": self.added(name, j),
            }
            self.decide(name, float(at), offered)
            if here:
                self.nodes.append(subtract_node(name, self.wanted(name)))
            self.filter(name)
            drive = self.node(f"{name}.drive", axis.drive, f"axes.{name}.drive", {"command": self.filtered(name)}, float(at))
            moving = {"rate": float(self.speed[j])} if any(port.name == "rate" for port in axis.drive.states) else {}
            self.nodes.append(replace(drive, initial={**drive.initial, **moving}))
            if parts.filters:
                wires = {"command": self.command(name), "filtered": self.filtered(name), "accepted": self.drive_accepted(name).signal}
                self.nodes.append(Node(f"{name}.unfiltered", UNFILTERED, wires))

    def filter(self, name: str) -> None:
        """Add the filters of an axis, one after another."""
        wire = self.command(name)
        for label, part in self.controller.axes[name].filters:
            made = self.node(f"{name}.filter_{label}", part, f"controller.axes.{name}.filters.{label}", {"command": wire})
            self.nodes.append(replace(made, initial=dict.fromkeys((port.name for port in part.states), self.command_start(name))))
            wire = f"{name}.filter_{label}.command"

    def wires_of(self, part: Component, axis: str, offered: Mapping[str, Any]) -> dict[str, Any]:
        """Return the wires of a part's inputs: offered signals, measurements on both sides of the drive, outputs of the gap observer."""
        seen = self.sensing[axis]
        wires = {}
        for port in part.inputs:
            if port.name in offered:
                wires[port.name] = offered[port.name]
            else:
                measured = port.name.startswith(("motor_", "load_"))
                wires[port.name] = seen.both_sides(port.name) if measured else seen.observed_gap(port.name)
        return wires

    def decide(self, name: str, at: float, offered: Mapping[str, Any]) -> None:
        """Add the controllers of an axis and, if there are several, their supervisor and the hand-over."""
        parts, prefix = self.controller.axes[name], f"controller.axes.{name}"
        if parts.supervisor is not None:
            self.add(f"{name}.supervisor", parts.supervisor, f"{prefix}.supervisor", self.wires_of(parts.supervisor, name, offered), at)
        handed = self.wanted(name) == f"{name}.handover.command"
        for number, (label, part) in enumerate(parts.controllers.items()):
            node, key = (f"{name}.other_{label}", f"others.{label}") if number else (f"{name}.controller", "controller")
            if handed:
                offered = {**offered, "accepted": self.accepted_of(name, node, number)}
            made = conditioned(part) if parts.others else part
            self.add(node, made, f"{prefix}.{key}", self.wires_of(made, name, offered), at)
        if handed:
            self.hand_over(name)

    def accepted_of(self, name: str, node: str, number: int) -> str:
        """Add the node that gives a controller the accepted part of its command; return its wire."""
        late: dict[str, Any] = {port: Late(f"{name}.handover.{port}") for port in ("active", "offset")}
        self.nodes.append(Node(f"{node}_told", ACCEPTED, {**late, "accepted": self.accepted(name), "number": float(number)}))
        return f"{node}_told.accepted"

    def hand_over(self, name: str) -> None:
        """Add the node that passes on the command of the active controller."""
        parts = self.controller.axes[name]
        commands = (f"{name}.controller.command", *(f"{name}.other_{label}.command" for label, _ in parts.others))
        active: Any = 0.0
        time: Any = self.handover_time
        if parts.supervisor is not None:
            active = f"{name}.supervisor.active"
            changed = self.changed(f"controller.axes.{name}.supervisor")
            time = changed.get("handover_time", parts.supervisor.values()["handover_time"])
        wires = {"commands": commands, "active": active, "accepted": self.accepted(name)}
        # After a take-over from another loop, the active controller is none of this loop.
        before = {} if self.handover_time is None else {"active": -1.0}
        step, parameters = handover_step(len(commands)), handover_parameters(time, self.period)
        self.nodes.append(Node(f"{name}.handover", step, wires, parameters, initial=before))

    def followed(self, name: str, j: int) -> Any:
        """Return the wire of an axis' reference position."""
        terms = [f"coupling.modified_reference[{j}]" if self.coupled("modified_reference") else f"in.reference[{j}]"]
        terms += self.fed_forward(name, "reference_shift")
        if LEARNED_REFERENCE in self.fed:
            terms.append(f"in.{LEARNED_REFERENCE}[{j}]")
        return self.sum_of(f"{name}.reference", terms)

    def added(self, name: str, j: int) -> Any:
        """Return the wire of the sum added to an axis' command: cross-coupling, feedforward and learned table."""
        terms = [f"coupling.correction[{j}]"] if self.coupled("correction") else []
        terms += self.fed_forward(name, "command")
        if LEARNED_COMMAND in self.fed:
            terms.append(f"in.{LEARNED_COMMAND}[{j}]")
        for label, controller in self.controller.axes[name].controllers.items() if terms else ():
            if not controller.takes("feedforward"):
                bound = "one with an input feedforward, which cross-coupling, learning, feedforward and compensation need"
                raise ParameterError(f"controller.axes.{name}.{label}", f'"{controller.kind}"', bound)
        return self.sum_of(f"{name}.added", terms) if terms else 0.0

    def fed_forward(self, name: str, output: str) -> list[str]:
        axis = self.controller.axes[name]
        sources = {"feedforward": axis.feedforward, "compensation": axis.compensation}
        return [f"{name}.{slot}.{output}" for slot, part in sources.items() if part is not None and part.gives(output)]

    def sum_of(self, node: str, terms: list[str]) -> str:
        """Return the wire of a sum; for a single term, its own wire."""
        if len(terms) == 1:
            return terms[0]
        self.nodes.append(Node(node, sum_step(len(terms)), {"terms": tuple(terms)}))
        return f"{node}.total"


_MOST_KEPT = 4
_kept: dict[tuple[Any, ...], tuple[tuple[Any, ...], Wiring]] = {}


def build(
    machine: Machine,
    controller: Controller,
    path: Path,
    start: Array,
    progress: float = 0.0,
    overrides: Overrides | None = None,
    view: PathView | None = None,
    extra: tuple[Node | Callable[[Signals], Node], ...] = (),
    seed: int | tuple[int, ...] = 0,
    trial: int = 0,
    fed: tuple[str, ...] = (),
    velocity: Array | None = None,
    handover_time: float | None = None,
    motion: Node | None = None,
) -> Wiring:
    """Return the schedule of a machine under its controller.

    Parameters
    ----------
    machine, controller
        What runs.
    path : Path
        Path of the estimator.
    start : ndarray (n_axis,) [m]
        Initial positions of the axes.
    progress : float [m]
        Arc length of the reference at the first tick.
    overrides : mapping of str to ndarray (n_variant,)
        Parameters that differ between variants, by their dotted names.
    view : PathView, optional
        View of the path, instead of the default.
    extra : tuple of Node or callable
        Nodes that run at the end of the controllers, before the record point: the judge of a batch. A callable takes `Signals`.
    seed : int or tuple of int
        Of all noise; a tuple has one for each variant.
    trial : int
        Each trial has noise of its own.
    fed : tuple of str
        Inputs besides the reference, a row per axis: see `contourlab.loop.feeding`.
    velocity : ndarray (n_axis,) [m/s], optional
        Of the axes at the first tick, instead of rest; the states of controllers start at rest all the same.
    handover_time : float [s], optional
        Given if the controller takes over from another one at the first tick: time constant with which the jump of each command decays.
    motion : Node, optional
        In place of the inputs that it gives; see `contourlab.loop.progress`.

    Notes
    -----
    The last few loops are kept: a run of the same objects again starts at once.
    """
    for one in seed if isinstance(seed, tuple) else (seed,):
        check_seed(one)
    used = (machine, *controller.axes.values(), controller.estimator, controller.coupling, path, view, motion)
    moving = None if velocity is None else velocity.tobytes()
    key = (*map(id, used), *controller.axes, start.tobytes(), progress, seed, trial, fed, moving, handover_time)
    if key in _kept and not overrides and not extra:
        return _kept[key][1]
    builder = _Slots(machine, controller, path, start, progress, overrides or {}, seed, trial, frozenset(fed), velocity, handover_time)
    builder.nodes += [] if motion is None else [motion]
    builder.sense()
    builder.contour(view)
    builder.control()
    insert_links(builder)
    signals = signal_map(builder, builder.sensing)
    for port in () if motion is None else motion.step.outputs:
        if port.name in DECIDED:
            signals[port.name] = tuple(f"in.{port.name}[{j}]" for j in range(port.size)) or (f"in.{port.name}",)
    builder.nodes += (node if isinstance(node, Node) else node(signals) for node in extra)
    builder.nodes.append(watch_node(machine, tuple(map(builder.filtered, machine.axis_names))))
    record_point = len(builder.nodes)
    add_plants(builder)
    n = len(builder.names)
    inputs = (*EXTERNALS, *ALONG, *fed)
    given = () if motion is None else tuple(port.name for port in motion.step.outputs)
    externals = tuple(Port(name, 0 if name in SINGLE else n) for name in inputs if name not in given)
    loop = Wiring(Schedule(tuple(builder.nodes), externals, machine.servo_period, record_point), signals)
    if not overrides and not extra:
        _kept[key] = used, loop  # while `used` is kept, no other object has its ids
        for oldest in list(_kept)[:-_MOST_KEPT]:
            _kept.pop(oldest, None)
    return loop
