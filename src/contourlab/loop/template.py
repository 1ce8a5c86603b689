"""The servo loop: slots in the order of a tick, turned into a schedule of nodes.

At each tick, for every axis,

1. the **sensor** measures the position that the plant has reached; a **predictor** says where the axis will be once a delay has
   passed; the **velocity** is worked out from what it says;
2. the **estimator** sees all axes as measured and the path, the **coupling** turns its contour error into a modified reference, or into a
   correction of the commands;
3. the **observer** estimates what disturbs the axis, from its velocity and the command that reached it (one tick late);
4. the **feedforward** acts on the reference, the **controller** computes a command, which takes in the correction and what earlier trials
   have taught; the **drive** delays and limits it;

signals are recorded here, and then

5. the **disturbance** and the reaction of axes mounted on top act on the **plant**, which moves to the next tick with its command held.

Ideal parts have no node: their wires lead to what they would have passed on.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.components.contract import Component
from contourlab.components.mechanics import link
from contourlab.components.sensor.ideal import IdealSensor
from contourlab.components.velocity.true import TrueVelocity
from contourlab.engine.schedule import Late, Node, Schedule
from contourlab.engine.step import Port, Step
from contourlab.errors import ParameterError
from contourlab.geometry import Path
from contourlab.geometry.view import PathView, view_of
from contourlab.loop.feeding import AHEAD, LEARNED_COMMAND, LEARNED_REFERENCE
from contourlab.loop.machine import Axis, Controller, Machine
from contourlab.loop.mixing import sum_step
from contourlab.loop.tool import stream_of
from contourlab.loop.watch import watch_node

__all__ = ["Loop", "build"]

Array = NDArray[np.float64]
Overrides = Mapping[str, Array]


@dataclass(frozen=True)
class Loop:
    """A schedule, and where the signals of a result stand in it: name -> one signal per axis, or one for the machine."""

    schedule: Schedule
    signals: Mapping[str, tuple[str, ...]]


EXTERNALS = ("reference", "reference_velocity", "reference_acceleration")


class _Builder:
    def __init__(
        self,
        machine: Machine,
        controller: Controller,
        path: Path,
        start: Array,
        progress: float,
        overrides: Overrides,
        seed: int,
        trial: int,
        fed: frozenset[str],
    ) -> None:
        missing = [name for name in machine.axis_names if name not in controller.axes]
        if missing:
            raise ParameterError("controller.axes", ", ".join(controller.axes) or "none", f"given for axis {missing[0]} too")
        if path.n_axis != len(machine.axes):
            raise ParameterError(
                "path",
                f"{path.n_axis} coordinates",
                f"one for each axis of {machine.name}: {', '.join(machine.axis_names)}",
            )
        units = [axis.plant.command_unit for axis in machine.axes]
        coupling = controller.coupling
        if len(set(units)) > 1 and coupling is not None and any(port.name == "correction" for port in coupling.outputs):
            raise ParameterError(
                "controller.coupling",
                f'"{coupling.kind}"',
                f"one that acts on the reference, as the axes of {machine.name} take commands in {', '.join(units)}",
            )
        self.machine, self.controller, self.path = machine, controller, path
        self.start, self.progress, self.overrides = start, progress, overrides
        self.seed, self.trial, self.fed = seed, trial, fed
        self.period = machine.servo_period
        self.nodes: list[Node] = []
        self.names = machine.axis_names

    # --- helpers -----------------------------------------------------------------------------------------------------------------

    def changed(self, prefix: str) -> dict[str, Array]:
        """Return the overrides of one component: parameter -> values over the variants."""
        head = prefix + "."
        return {name[len(head) :]: values for name, values in self.overrides.items() if name.startswith(head)}

    def add(self, name: str, part: Component, prefix: str, wires: Mapping[str, Any], at: float = 0.0) -> None:
        """Add the node of a component of one axis."""
        initial, start = part.at_rest(at)
        changed = self.changed(prefix)
        step, values = part.make_step(len(self.names)), part.block(self.period, changed)
        self.nodes.append(Node(name, step, wires, values, part.table_values(), initial, start, self.ring_length(part, changed)))

    def ring_length(self, part: Component, changed: Mapping[str, Array]) -> int:
        """Return how much of its past a component keeps, so that it is enough for every variant."""
        lengths = [part.ring_length(self.period)]
        for name, values in changed.items() if part.ring else ():
            lengths += [part.replace(**{name: float(extreme)}).ring_length(self.period) for extreme in (values.min(), values.max())]
        return max(lengths)

    # --- slots -------------------------------------------------------------------------------------------------------------------

    def measured(self, axis: str) -> Any:
        """Return the wire of an axis' measured position."""
        ideal = isinstance(self.machine.axis(axis).sensor, IdealSensor)
        return Late(f"{axis}.plant.position") if ideal else f"{axis}.sensor.position"

    def seen(self, axis: str) -> Any:
        """Return the wire of the position that an axis' controller sees."""
        return self.measured(axis) if self.controller.axes[axis].predictor is None else f"{axis}.predictor.position"

    def accepted(self, axis: str) -> Late:
        """Return the wire of the last command that the drive took, behind its limit and ahead of its delay."""
        late = any(port.name == "accepted" for port in self.machine.axis(axis).drive.outputs)
        return Late(f"{axis}.drive.{'accepted' if late else 'applied'}")

    def noisy(self, part: Any, axis: str, slot: str) -> Any:
        """Return a component with the noise of this axis, seed and trial, if it makes any."""
        if not part.parameters.get("stream") or part.stream:
            return part
        return part.replace(stream=stream_of(self.seed, axis, slot, *((self.trial,) if self.trial else ())))

    def velocity(self, axis: str) -> Any:
        """Return the wire of the velocity that an axis' controller sees."""
        true = isinstance(self.controller.axes[axis].velocity, TrueVelocity)
        return Late(f"{axis}.plant.velocity") if true else f"{axis}.velocity.velocity"

    def sense(self) -> None:
        for axis, at in zip(self.machine.axes, self.start, strict=True):
            if not isinstance(axis.sensor, IdealSensor):
                wires = {"position": Late(f"{axis.name}.plant.position")}
                sensor = self.noisy(axis.sensor, axis.name, "sensor")
                self.add(f"{axis.name}.sensor", sensor, f"axes.{axis.name}.sensor", wires, float(at))
            mine, prefix = self.controller.axes[axis.name], f"controller.axes.{axis.name}"
            if mine.predictor is not None:
                wires = {"position": self.measured(axis.name), "applied": self.accepted(axis.name)}
                self.add(f"{axis.name}.predictor", mine.predictor, f"{prefix}.predictor", wires, float(at))
            if not isinstance(mine.velocity, TrueVelocity):
                wires = {"position": self.seen(axis.name)}
                self.add(f"{axis.name}.velocity", mine.velocity, f"{prefix}.velocity", wires, float(at))

    def contour(self, view: PathView | None) -> None:
        estimator, coupling = self.controller.estimator, self.controller.coupling
        if estimator is None:
            return
        positions = tuple(self.measured(name) for name in self.names)
        seen = view or view_of(self.path)
        step = estimator.path_step(seen, len(self.names))  # type: ignore[attr-defined]
        parameters = {**estimator.block(self.period, self.changed("controller.estimator")), **seen.parameters}
        wires: dict[str, Any] = {"position": positions, "arc_length": "in.arc_length"}
        self.nodes.append(Node("estimator", step, wires, parameters, seen.tables, {"foot": self.progress}))
        if coupling is not None:
            offered = {"reference": "in.reference", "position": positions}
            offered |= {port.name: f"estimator.{port.name}" for port in step.outputs}
            offered["command"] = tuple(Late(f"{name}.controller.command") for name in self.names)
            offered["accepted"] = tuple(self.accepted(name) for name in self.names)
            self.add("coupling", coupling, "controller.coupling", {port.name: offered[port.name] for port in coupling.inputs})

    def coupled(self, output: str) -> bool:
        """Tell whether the coupling gives this."""
        coupling = self.controller.coupling
        return coupling is not None and any(port.name == output for port in coupling.outputs)

    def control(self) -> None:
        for j, (axis, at) in enumerate(zip(self.machine.axes, self.start, strict=True)):
            name, mine, prefix = axis.name, self.controller.axes[axis.name], f"controller.axes.{axis.name}"
            applied = Late(f"{name}.drive.applied")
            if mine.observer is not None:
                # A predicted velocity is that of the commands ahead of their delay.
                wires = {"velocity": self.velocity(name), "applied": applied if mine.predictor is None else self.accepted(name)}
                self.add(f"{name}.observer", mine.observer, f"{prefix}.observer", wires)
            asked = {signal: f"in.{signal}[{j}]" for signal in EXTERNALS}
            if mine.feedforward is not None:
                ahead = {**asked, AHEAD: f"in.{AHEAD}[{j}]"}
                wires = {port.name: ahead[port.name] for port in mine.feedforward.inputs}
                self.add(f"{name}.feedforward", mine.feedforward, f"{prefix}.feedforward", wires, float(at))
            offered = {
                **asked,
                "reference": self.followed(name, j, float(at)),
                "position": self.seen(name),
                "velocity": self.velocity(name),
                "disturbance_estimate": f"{name}.observer.disturbance_estimate" if mine.observer is not None else 0.0,
                "feedforward": self.added(name, j),
                "applied": applied,
                "accepted": self.accepted(name),
            }
            wires = {port.name: offered[port.name] for port in mine.controller.inputs}
            self.add(f"{name}.controller", mine.controller, f"{prefix}.controller", wires, float(at))
            self.add(f"{name}.drive", axis.drive, f"axes.{name}.drive", {"command": f"{name}.controller.command"})

    def followed(self, name: str, j: int, at: float) -> Any:
        """Return the wire of the position that an axis' controller is asked for."""
        terms = [f"coupling.modified_reference[{j}]" if self.coupled("modified_reference") else f"in.reference[{j}]"]
        terms += self.fed_forward(name, "reference_shift")
        if LEARNED_REFERENCE in self.fed:
            terms.append(f"in.{LEARNED_REFERENCE}[{j}]")
        return self.sum_of(f"{name}.reference", terms)

    def added(self, name: str, j: int) -> Any:
        """Return the wire of what is added to an axis' command: cross-coupling, feedforward, and what earlier trials have taught."""
        terms = [f"coupling.correction[{j}]"] if self.coupled("correction") else []
        terms += self.fed_forward(name, "command")
        if LEARNED_COMMAND in self.fed:
            terms.append(f"in.{LEARNED_COMMAND}[{j}]")
        controller = self.controller.axes[name].controller
        if terms and not any(port.name == "feedforward" for port in controller.inputs):
            raise ParameterError(
                f"controller.axes.{name}.controller",
                f'"{controller.kind}"',
                "one with a port feedforward: cross-coupling, learning and feedforward add to its command",
            )
        return self.sum_of(f"{name}.added", terms) if terms else 0.0

    def fed_forward(self, name: str, output: str) -> list[str]:
        part = self.controller.axes[name].feedforward
        return [f"{name}.feedforward.{output}"] if part is not None and any(port.name == output for port in part.outputs) else []

    def sum_of(self, node: str, terms: list[str]) -> str:
        """Return the wire of a sum; of a single term it is that term's own."""
        if len(terms) == 1:
            return terms[0]
        self.nodes.append(Node(node, sum_step(len(terms)), {"terms": tuple(terms)}))
        return f"{node}.total"

    def move(self) -> None:
        for axis, at in zip(self.machine.axes, self.start, strict=True):
            name, prefix = axis.name, f"axes.{axis.name}"
            load: Any = 0.0
            if axis.disturbance is not None:
                wires = {"position": Late(f"{name}.plant.position")}
                self.add(f"{name}.disturbance", self.noisy(axis.disturbance, name, "disturbance"), f"{prefix}.disturbance", wires)
                load = f"{name}.disturbance.force"
            # Two modules that move along each other push on each other with the mass that the upper one moves.
            partners = {a.name: a.alignment * self.moved_mass(a) for a in self.machine.axes if a.mounted_on == name and a.alignment}
            if axis.mounted_on and axis.alignment:
                partners[axis.mounted_on] = axis.alignment * self.moved_mass(axis)
            if partners:
                load = self.reaction(name, load, partners)
            values = self.carrying(axis) | axis.friction.block(self.period, self.changed(f"{prefix}.friction"))
            initial, start = axis.plant.at_rest(float(at))
            pushed: dict[str, Any] = {"command": f"{name}.drive.applied", "load": load}
            step = link(axis.plant, axis.friction)
            self.nodes.append(Node(f"{name}.plant", step, pushed, values, {}, initial, start, repeat=axis.substeps))

    def carrying(self, axis: Axis) -> dict[str, Any]:
        """Return the parameters of an axis' plant, with the modules that stand on it."""
        changed, carried = self.changed(f"axes.{axis.name}.plant"), self.machine.carried_mass(axis.name)
        if carried:
            own = np.asarray(axis.plant.values()["carried_mass"])
            changed["carried_mass"] = changed.get("carried_mass", own) + carried
        return axis.plant.block(self.period / axis.substeps, changed)

    def moved_mass(self, axis: Axis) -> Any:
        """Return the mass [kg] that an axis moves in a straight line: a number, or one for each variant."""
        return type(axis.plant).moved_mass(SimpleNamespace(**self.carrying(axis)))

    def reaction(self, name: str, load: Any, partners: Mapping[str, Any]) -> str:
        """Add the node that sums what acts on an axis: its disturbance, and the inertia of those that move along it."""
        step = _reaction_step(tuple(partners))
        forces: dict[str, Any] = {f"acceleration_{other}": Late(f"{other}.plant.acceleration") for other in partners}
        self.nodes.append(Node(f"{name}.load", step, {"load": load, **forces}, {f"mass_{other}": mass for other, mass in partners.items()}))
        return f"{name}.load.force"

    def signals(self) -> dict[str, tuple[str, ...]]:
        def plain(wire: Any) -> str:
            return str(wire.signal if isinstance(wire, Late) else wire)

        found = {
            "position": tuple(plain(self.measured(name)) for name in self.names),
            "axis_position": tuple(f"{name}.plant.position" for name in self.names),
            "axis_velocity": tuple(f"{name}.plant.velocity" for name in self.names),
            "velocity": tuple(plain(self.velocity(name)) for name in self.names),
            "command": tuple(f"{name}.controller.command" for name in self.names),
            "applied_command": tuple(f"{name}.drive.applied" for name in self.names),
        }
        if all(self.controller.axes[name].observer is not None for name in self.names):
            found["disturbance_estimate"] = tuple(f"{name}.observer.disturbance_estimate" for name in self.names)
        if self.controller.estimator is not None:
            found["contour_error_estimate"] = ("estimator.contour_error_estimate",)
        for output, signal in (("modified_reference", "modified_reference"), ("correction", "coupling_command")):
            if self.coupled(output):
                found[signal] = tuple(f"coupling.{output}[{j}]" for j in range(len(self.names)))
        return found


@cache
def _reaction_step(partners: tuple[str, ...]) -> Step:
    ports = (Port("load"), *(Port(f"acceleration_{name}") for name in partners))
    terms = "".join(f" - par.mass_{name} * inp.acceleration_{name}" for name in partners)
    scope: dict[str, Any] = {"__name__": __name__}
    exec(f"def step(par, x, inp, clock):\n    return (), (inp.load{terms},)\n", scope)
    return Step("load", scope["step"], tuple(f"mass_{name}" for name in partners), (), "", (), ports, (Port("force"),))


def build(
    machine: Machine,
    controller: Controller,
    path: Path,
    start: Array,
    progress: float = 0.0,
    overrides: Overrides | None = None,
    view: PathView | None = None,
    extra: tuple[Node, ...] = (),
    seed: int = 0,
    trial: int = 0,
    fed: tuple[str, ...] = (),
) -> Loop:
    """Return the schedule of a machine under its controller.

    Parameters
    ----------
    machine, controller
        What runs.
    path : Path
        What the estimator sees.
    start : ndarray (n_axis,) [m]
        Where the axes stand at the first tick, at rest.
    progress : float [m]
        Arc length of the reference at the first tick.
    overrides : mapping of str to ndarray (n_variant,)
        Parameters that differ between variants, by their dotted names.
    view : PathView, optional
        Another view of the path than the default.
    extra : tuple of Node
        Nodes that run at the end of the controllers, before the record point: the judge of a batch.
    seed, trial : int
        Of all noise: each trial has its own.
    fed : tuple of str
        What is fed besides the reference, a row per axis: see `contourlab.loop.feeding`.
    """
    builder = _Builder(machine, controller, path, start, progress, overrides or {}, seed, trial, frozenset(fed))
    builder.sense()
    builder.contour(view)
    builder.control()
    builder.nodes += (*extra, watch_node(machine))
    record_point = len(builder.nodes)
    builder.move()
    n = len(builder.names)
    externals = (*(Port(name, n) for name in EXTERNALS), Port("arc_length"), Port("feedrate"), *(Port(name, n) for name in fed))
    return Loop(Schedule(tuple(builder.nodes), externals, machine.servo_period, record_point), builder.signals())
