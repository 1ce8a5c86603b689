"""The servo loop: slots in the order of a tick, turned into a schedule of nodes.

At each tick, for every axis,

1. the **sensor** measures the position that the plant has reached, and the **velocity** is worked out from it;
2. the **estimator** sees all axes and the path, the **coupling** turns its contour error into a modified reference;
3. the **observer** estimates what disturbs the axis, from its velocity and the command that reached it (one tick late);
4. the **controller** computes a command; the **drive** delays and limits it;

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
from contourlab.loop.machine import Axis, Controller, Machine
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
        self.machine, self.controller, self.path = machine, controller, path
        self.start, self.progress, self.overrides, self.seed = start, progress, overrides, seed
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

    def velocity(self, axis: str) -> Any:
        """Return the wire of the velocity that an axis' controller sees."""
        true = isinstance(self.controller.axes[axis].velocity, TrueVelocity)
        return Late(f"{axis}.plant.velocity") if true else f"{axis}.velocity.velocity"

    def sense(self) -> None:
        for axis, at in zip(self.machine.axes, self.start, strict=True):
            if not isinstance(axis.sensor, IdealSensor):
                wires = {"position": Late(f"{axis.name}.plant.position")}
                sensor: Any = axis.sensor
                if sensor.parameters.get("stream") and not sensor.stream:
                    sensor = sensor.replace(stream=stream_of(self.seed, axis.name, "sensor"))
                self.add(f"{axis.name}.sensor", sensor, f"axes.{axis.name}.sensor", wires, float(at))
            part = self.controller.axes[axis.name].velocity
            if not isinstance(part, TrueVelocity):
                prefix = f"controller.axes.{axis.name}.velocity"
                self.add(f"{axis.name}.velocity", part, prefix, {"position": self.measured(axis.name)}, float(at))

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
            wires = {
                "reference": "in.reference",
                "position": positions,
                "foot_position": "estimator.foot_position",
                "error_vector": "estimator.error_vector",
            }
            self.add("coupling", coupling, "controller.coupling", wires)

    def control(self) -> None:
        for j, (axis, at) in enumerate(zip(self.machine.axes, self.start, strict=True)):
            name, mine = axis.name, self.controller.axes[axis.name]
            applied = Late(f"{name}.drive.applied")
            late = any(port.name == "accepted" for port in axis.drive.outputs)
            if mine.observer is not None:
                wires = {"velocity": self.velocity(name), "applied": applied}
                self.add(f"{name}.observer", mine.observer, f"controller.axes.{name}.observer", wires)
            offered = {
                "reference": f"coupling.modified_reference[{j}]" if self.controller.coupling is not None else f"in.reference[{j}]",
                "reference_velocity": f"in.reference_velocity[{j}]",
                "reference_acceleration": f"in.reference_acceleration[{j}]",
                "position": self.measured(name),
                "velocity": self.velocity(name),
                "disturbance_estimate": f"{name}.observer.disturbance_estimate" if mine.observer is not None else 0.0,
                "applied": applied,
                "accepted": Late(f"{name}.drive.accepted") if late else applied,
            }
            wires = {port.name: offered[port.name] for port in mine.controller.inputs}
            self.add(f"{name}.controller", mine.controller, f"controller.axes.{name}.controller", wires, float(at))
            self.add(f"{name}.drive", axis.drive, f"axes.{name}.drive", {"command": f"{name}.controller.command"})

    def move(self) -> None:
        for axis, at in zip(self.machine.axes, self.start, strict=True):
            name, prefix = axis.name, f"axes.{axis.name}"
            load: Any = 0.0
            if axis.disturbance is not None:
                wires = {"position": Late(f"{name}.plant.position")}
                self.add(f"{name}.disturbance", axis.disturbance, f"{prefix}.disturbance", wires)
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
        return axis.plant.block(self.period, changed)

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
        if self.controller.coupling is not None:
            found["modified_reference"] = tuple(f"coupling.modified_reference[{j}]" for j in range(len(self.names)))
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
    seed : int
        Of all noise.
    """
    builder = _Builder(machine, controller, path, start, progress, overrides or {}, seed)
    builder.sense()
    builder.contour(view)
    builder.control()
    builder.nodes += (*extra, watch_node(machine))
    record_point = len(builder.nodes)
    builder.move()
    n = len(builder.names)
    externals = (*(Port(name, n) for name in EXTERNALS), Port("arc_length"), Port("feedrate"))
    return Loop(Schedule(tuple(builder.nodes), externals, machine.servo_period, record_point), builder.signals())
