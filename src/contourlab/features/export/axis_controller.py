"""The controller of one axis, cut out of the servo loop: measured positions and the reference go in, the command comes out."""

from __future__ import annotations

import hashlib
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from contourlab.app.results import SAFETY
from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.components.ideal import IdealSensor
from contourlab.engine.runner import InterpretedGroup
from contourlab.engine.schedule import Late, Schedule
from contourlab.engine.step import Port, rows
from contourlab.engine.translate.control import Control, Field, control_of
from contourlab.errors import ParameterError
from contourlab.geometry import Line, Path
from contourlab.loop import Axis, Controller, Machine
from contourlab.loop.builder import accepted_output
from contourlab.loop.template import EXTERNALS, build

MEASURED = ("position", "velocity", "motor_position", "motor_velocity")
INPUTS = {
    "reference": Field("reference", "m", "reference position"),
    "reference_velocity": Field("reference_velocity", "m/s", "velocity of the reference"),
    "reference_acceleration": Field("reference_acceleration", "m/s^2", "acceleration of the reference"),
    "position": Field("position", "m", "measured position of the axis, at the load"),
    "velocity": Field("velocity", "m/s", "measured velocity of the axis, at the load"),
    "motor_position": Field("motor_position", "m", "position measured by the encoder of the motor, in units of the load"),
    "motor_velocity": Field("motor_velocity", "m/s", "velocity measured at the motor, in units of the load"),
}
"""Inputs of a controller; only those that it uses are exported."""
_REASONS = {
    "reference_ahead": "it needs the reference some periods ahead, which a control does not give to an axis",
    "arc_length": "it needs the arc length on the path, which a control does not give to an axis",
    "source_line": "it needs the line of the program, which a control does not give to an axis",
}


@dataclass(frozen=True)
class AxisControl:
    """The controller of one axis.

    Attributes
    ----------
    axis : str
    number : int
        Of the axis on its machine, from 0.
    schedule : Schedule
        The controller alone, at rest at position 0: run in plain Python it is the reference.
    machine : Machine
        The machine with this axis alone.
    controller : Controller
    control : Control
        For the printers.
    parts : tuple of str
        The components, in the order of a tick, such as ``observer: disturbance-observer``.
    signal : str
        Signal of the command, here and in the servo loop of the axis.
    measured : dict of str to str
        Signal of the servo loop for each measured input.
    rest, slope : ndarray (n_row,)
        Memory of the controller at rest at position 0, and its change for each metre of position.
    digest : str
        SHA-256 of machine and controller as TOML.
    limit : float
        Largest command, infinite for none.
    """

    axis: str
    number: int
    schedule: Schedule
    machine: Machine
    controller: Controller
    control: Control
    parts: tuple[str, ...]
    signal: str
    measured: dict[str, str]
    rest: Array
    slope: Array
    digest: str
    limit: float

    def at_rest(self, position: float) -> InterpretedGroup:
        """Return the controller in plain Python, at rest at a position [m]."""
        group = InterpretedGroup(self.schedule, 1, slice(0, 1))
        group.memory[:, 0] = self.rest + self.slope * position
        return group


def axis_control(machine: Machine, controller: Controller, axis: str) -> AxisControl:
    """Return the controller of one axis of a machine.

    Raises
    ------
    ParameterError
        If a part of the controller cannot run in the axis alone; says which and why.
    EngineError
        If a step cannot be translated.
    """
    from contourlab.scenario.dump import dump

    _check(controller, axis)
    alone = replace(machine, axes=(replace(machine.axis(axis), mounted_on="", alignment=0.0),), squareness={}, correlations=())
    steered = Controller({axis: controller.axes[axis]})
    places = 0.0, 1.0, -2.5
    loops = [loop_of(alone, steered, at) for at in places]
    outside = (f"{axis}.sensor", f"{axis}.motor_sensor", "watch")
    names = tuple(node.name for node in loops[0].nodes[: loops[0].record_point] if node.name not in outside)
    measured: dict[str, str] = {}
    velocity = controller.axes[axis].velocity
    cuts = [_cut(loop, names, axis, measured, velocity.at_rest(at)) for loop, at in zip(loops, places, strict=True)]
    groups = [InterpretedGroup(cut, 1, slice(0, 1)) for cut in cuts]
    rest, at_1, further_on = (group.memory[:, 0] for group in groups)
    slope = np.subtract(at_1, rest, out=np.zeros(rest.size), where=at_1 != rest)  # parameters may be infinite
    if not np.array_equal(further_on, rest - 2.5 * slope):
        raise ParameterError(f"controller.axes.{axis}", "a state", "linear in the position where the axis rests")
    digest = hashlib.sha256((dump(machine) + dump(controller, machine)).encode()).hexdigest()
    drive, unit = machine.axis(axis).drive, machine.axis(axis).plant.command_unit
    used = {slot: part for slot, part in steered.axes[axis].parts.items() if slot != "velocity" or part.kind != "true"}
    parts = {slot.replace("filters.", "filter_").replace("others.", "other_"): part for slot, part in used.items()} | {"drive": drive}
    signal, limit = f"{axis}.drive.{accepted_output(drive)}", float(getattr(drive, "limit", math.inf))
    kinds = tuple(f"{slot}: {part.kind}" for slot, part in parts.items())
    adjustable, fixed = _described(parts, axis, machine)
    command = Field("command", unit, "command to the drive, within its limit")
    made = control_of(
        *(cuts[0], groups[0].places, rest, slope),
        output=signal,
        command=command,
        inputs=INPUTS,
        parameters=adjustable,
        constants=fixed,
        name="axis_" + re.sub(r"\W", "_", axis, flags=re.ASCII),
        notes=_notes(machine, axis, kinds, digest, limit, unit),
    )
    number = machine.axis_names.index(axis)
    return AxisControl(axis, number, cuts[0], alone, steered, made, kinds, signal, measured, rest, slope, digest, limit)


def _check(controller: Controller, axis: str) -> None:
    """Refuse what does not belong to one axis."""
    if axis not in controller.axes:
        raise ParameterError("--axis", axis, "one of " + ", ".join(controller.axes))
    if controller.coupling is not None:
        bound = '"none": it sees all axes and the path, which the controller of one axis does not'
        raise ParameterError("controller.coupling", f'"{controller.coupling.kind}"', bound)
    for slot, part in controller.axes[axis].parts.items():
        for port in part.inputs:
            if port.name in _REASONS:
                raise ParameterError(f"controller.axes.{axis}.{slot}", f'"{part.kind}"', f"left out: {_REASONS[port.name]}")
    if controller.axes[axis].link is not None:
        raise ParameterError(f"controller.axes.{axis}.link", "a link", "left out: the controller is exported in one piece")


def loop_of(machine: Machine, controller: Controller, at: float) -> Schedule:
    """Return the servo loop of a machine with one axis, at rest at a position."""
    return build(machine, controller, Path([Line((0.0,), (1.0,))]), np.array([at])).schedule


def _cut(loop: Schedule, names: tuple[str, ...], axis: str, measured: dict[str, str], velocity: tuple[Any, Any]) -> Schedule:
    """Return the schedule of some nodes; what they take from elsewhere becomes an input, noted in `measured` if it is measured.

    The states of a velocity at rest are given: in the loop those of the motor depend on the gap where the axis rests.
    """
    nodes = [node for node in loop.nodes if node.name in names]
    needed: dict[str, None] = dict.fromkeys(EXTERNALS)
    ports = {f"{axis}.plant.{port}": port for port in MEASURED}
    ports |= {f"{axis}.sensor.position": "position", f"{axis}.motor_sensor.position": "motor_position"}

    def wire(old: Any, node: str) -> Any:
        if isinstance(old, tuple):
            return tuple(wire(item, node) for item in old)
        signal = old.signal if isinstance(old, Late) else old
        if not isinstance(signal, str) or signal.rpartition(".")[0] in names:
            return old
        port = ports.get(signal) or re.sub(r"\[\d+\]$", "", signal.removeprefix("in."))
        if port not in INPUTS:
            slot = node.partition(".")[2]
            raise ParameterError(f"controller.axes.{axis}.{slot}", slot, f"left out: it needs {port}")
        needed[port] = None
        if port not in EXTERNALS:
            measured[port] = signal
        return f"in.{port}"

    made = [replace(node, wires={port: wire(old, node.name) for port, old in node.wires.items()}) for node in nodes]
    speeds = [f"{axis}.{name}velocity" for name in ("", "motor_", "load_")]
    made = [replace(node, initial=velocity[0], start=velocity[1]) if node.name in speeds else node for node in made]
    return Schedule(tuple(made), tuple(Port(name) for name in needed), loop.period, len(made))


def _described(parts: Mapping[str, Component], axis: str, machine: Machine) -> tuple[dict[str, Field], dict[str, Field]]:
    """Return the parameters that may change while the controller runs, and those that may not, by ``node.parameter``.

    A parameter may change if no derived constant depends on it.
    """
    plant = machine.axis(axis).plant
    free: dict[str, Field] = {}
    fixed: dict[str, Field] = {}
    for slot, part in parts.items():
        base = part.block(machine.servo_period)
        for name in part.numeric():
            known = part.parameters[name].for_plant(plant.command_unit, plant.force_unit)
            value = base[name]
            changed = part.block(machine.servo_period, {name: np.asarray(value * 1.01 + 1e-9)}) if math.isfinite(value) else base
            same = all(np.array_equal(changed[row], base[row]) for row in part.derived)
            for node in (slot, "motor_velocity", "load_velocity") if slot == "velocity" else (slot,):
                (free if same else fixed)[f"{axis}.{node}.{name}"] = Field(name, known.unit, _line(known.doc))
        for name in part.derived:
            fixed[f"{axis}.{slot}.{name}"] = Field(name, "", "computed from parameters and period")
    return free, fixed


def _notes(machine: Machine, axis: str, parts: tuple[str, ...], digest: str, limit: float, unit: str) -> tuple[str, ...]:
    from importlib.metadata import version

    own = machine.axis(axis)
    bounds = {name: (getattr(own.limits, name), what) for name, what in (("velocity", "m/s"), ("acceleration", "m/s^2"), ("jerk", "m/s^3"))}
    bounds["command"] = limit, unit
    known = [f"{name} {value:g} {what}" for name, (value, what) in bounds.items() if math.isfinite(value)]
    counted = ", ".join(part.kind for part in (own.sensor, own.motor_sensor) if not isinstance(part, IdealSensor))
    return (
        f"Controller of axis {axis} of {_line(machine.name)}, written by contourlab {version('contourlab')}.",
        f"SHA-256 of machine and controller: {digest}",
        f"Call it once every {machine.servo_period * 1e6:g} us: the period is fixed.",
        "Parts, in the order of a call: " + ", ".join(map(_line, parts)),
        "Limits: " + (", ".join(known) or "none"),
        *([f"Simulated with the sensor {counted}: feed its measured position in."] if counted else []),
        "Units are SI; the command is in " + unit,
        SAFETY,
    )


def _line(text: str) -> str:
    """Return text that fits into a comment of any language."""
    return re.sub(r"[^\x20-\x7e]|\*/|/\*|\(\*|\*\)|[<>&\"\\\\]", "?", text)


SAMPLES = 2000
"""Most samples of a recorded run."""


@dataclass(frozen=True)
class Recorded:
    """A run of the servo loop of one axis.

    Attributes
    ----------
    names : tuple of str
        Inputs of the controller, as in its `Control`.
    inputs : ndarray (n_sample, n_input)
    command : ndarray (n_sample,)
        Of the controller alone, in plain Python.
    in_loop : ndarray (n_sample,)
        Of the whole servo loop: the same numbers.
    """

    names: tuple[str, ...]
    inputs: Array
    command: Array
    in_loop: Array

    @property
    def text(self) -> str:
        """The run as CSV; all numbers read back identical."""
        head = ",".join((*self.names, "command"))
        lines = (",".join(map(repr, row)) for row in np.column_stack([self.inputs, self.command]).tolist())
        return "\n".join([head, *lines, ""])


def there_and_back(axis: Axis, period: float, n_sample: int = SAMPLES) -> Array:
    """Return two smooth strokes within the limits of an axis: position, velocity and acceleration (n_sample, 3)."""
    w = 4.0 * math.pi / (n_sample * period)
    speed, rate = (value if math.isfinite(value) else 0.1 for value in (axis.limits.velocity, axis.limits.acceleration))
    stroke = 0.5 * min(speed / w, rate / w**2)
    angle = w * period * np.arange(n_sample)
    return np.column_stack([stroke * (1.0 - np.cos(angle)), stroke * w * np.sin(angle), stroke * w**2 * np.cos(angle)])


def record(found: AxisControl, motion: Array) -> Recorded:
    """Run the servo loop of an axis, and its controller alone on what the loop measured.

    Parameters
    ----------
    found : AxisControl
    motion : ndarray (n_sample, 3)
        Position, velocity and acceleration of the reference.
    """
    loop = loop_of(found.machine, found.controller, float(motion[0, 0]))
    ports = [port.name for port in found.schedule.externals]
    fed = np.zeros((len(motion), rows(loop.externals)))
    fed[:, :3] = motion
    wanted = [loop.row(f"in.{name}" if name in EXTERNALS else found.measured[name]) for name in ports]
    log = InterpretedGroup(loop, 1, slice(0, 1)).run(fed, [*wanted, loop.row(found.signal)])[:, :, 0]
    return replayed(found, log[:, :-1], log[:, -1])


def replayed(found: AxisControl, inputs: Array, in_loop: Array) -> Recorded:
    """Run the controller of an axis alone, in plain Python.

    Parameters
    ----------
    found : AxisControl
    inputs : ndarray (n_sample, n_port)
        All inputs of its schedule.
    in_loop : ndarray (n_sample,)
        Commands of the servo loop.
    """
    columns = {port.name: inputs[:, k] for k, port in enumerate(found.schedule.externals)}
    names = tuple(field.name for field in found.control.inputs.values())
    group = found.at_rest(float(columns[found.control.feedback][0]))
    command = group.run(inputs, [found.schedule.row(found.signal)])[:, 0, 0]
    return Recorded(names, np.column_stack([columns[name] for name in names]), command, in_loop)
