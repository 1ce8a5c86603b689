"""``contourlab export``: the controllers of the axes as code for a control."""

from __future__ import annotations

import io
import math
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from contourlab import geometry
from contourlab.app.json_values import HIDDEN, json_values, write_json
from contourlab.app.results import SAFETY, staged
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.components.ideal import IdealSensor
from contourlab.engine.runner import InterpretedGroup
from contourlab.engine.step import Late, Port, Schedule, rows
from contourlab.engine.translate import fmi, hal, structured_text
from contourlab.engine.translate.control import Control, Field, bench_of, control_of, header_of, source_of
from contourlab.engine.translate.graph import LIBRARY
from contourlab.errors import ParameterError, ScenarioError, refuse
from contourlab.features.export.options import Export
from contourlab.features.run.source import Source, case_asked
from contourlab.file_kinds import kind_of
from contourlab.findings import Finding, finding
from contourlab.loop import Axis, Controller, Machine
from contourlab.loop.builder import accepted_output
from contourlab.loop.feeding import EXTERNALS
from contourlab.loop.template import build
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result.atomic import write_bytes_atomic
from contourlab.result.stamp import identity, stamp

Motion = Callable[[str], Array]


@dataclass(frozen=True)
class ExportedAxis:
    """The code of one axis.

    Attributes
    ----------
    name : str
        Of functions and files.
    period : float
        Time between two calls [s].
    parts : tuple of str
        Slots and kinds of its components, in the order of a call.
    inputs, outputs, parameters, constants : tuple of Field
        Parameters may be changed while the controller runs, constants may not.
    """

    name: str
    period: float
    parts: tuple[str, ...]
    inputs: tuple[Field, ...]
    outputs: tuple[Field, ...]
    parameters: tuple[Field, ...]
    constants: tuple[Field, ...]

    @classmethod
    def of(cls, axis: AxisControl) -> ExportedAxis:
        """Return what an axis exports."""
        made = axis.control
        groups = (made.inputs.values(), (made.output,), made.parameters.values(), made.constants.values())
        return cls(made.name, made.period, axis.parts, *map(tuple, groups))


@dataclass(frozen=True)
class Exported(Answer):
    """The controllers of axes as code.

    Attributes
    ----------
    to : str
        The language.
    hash : str
        Digests of machine and controller, as they are in every file.
    files : tuple of Path
    axes : dict of str to ExportedAxis
    findings : tuple of Finding
    """

    to: str
    hash: str
    files: tuple[Path, ...]
    axes: dict[str, ExportedAxis]
    findings: tuple[Finding, ...]
    contents: Mapping[str, str | bytes] = field(default_factory=dict, metadata=HIDDEN, repr=False)
    inputs: tuple[Any, ...] = field(default=(), metadata=HIDDEN, repr=False)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The axes, one a row."""
        return [{"axis": name, **json_values(axis)} for name, axis in self.axes.items()]

    def save(self, folder: str | Path = "export") -> Exported:
        """Write the code and a summary into a folder.

        Parameters
        ----------
        folder : str or Path

        Returns
        -------
        Exported
            With the names of its files.

        Raises
        ------
        OutputError
            If the folder cannot be written, or a file there is not ours.
        """
        summary = f"export-{self.to}.json"
        saved = replace(self, files=tuple(Path(folder) / name for name in (*self.contents, summary)))
        with staged(folder, summary, *self.contents, inputs=self.inputs) as stage:
            for name, content in self.contents.items():
                write_bytes_atomic(stage / name, content if isinstance(content, bytes) else content.encode("ascii", "replace"))
            write_json(stage / summary, saved)
        return saved

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Read the first finding, or analyse the scenario."""
        if self.findings:
            return ["explain", self.findings[0].code]
        return ["analyse", *asked.inputs] if asked.settings.machine is None else None

    @property
    def text(self) -> str:
        """Table of the axes, findings, and the files written."""
        columns = [Column("axis", left=True), *(Column(head, prose=True, left=True) for head in ("inputs", "command", "parameters"))]
        rows = (
            (axis, _names(made.inputs), f"{made.outputs[0].name} [{made.outputs[0].unit}]", _names(made.parameters))
            for axis, made in self.axes.items()
        )
        table = Table(columns, rows=rows)
        files = "\n".join(map(str, self.files))
        return "\n\n".join(filter(None, [table.text(), paragraphs(map(str, self.findings)), f"hash: {self.hash}\n{files}"]))


def _names(fields: Sequence[Field]) -> str:
    return ", ".join(field.name + (f" [{field.unit}]" if field.unit else "") for field in fields) or "none"


def files_of(to: str, axis: AxisControl, motion: Motion) -> dict[str, str | bytes]:
    """Return the files of an axis by name, in a language of `contourlab.features.export.options.LANGUAGES`."""
    made, name = axis.control, axis.control.name
    match to:
        case "c99":
            code = {f"{name}.h": header_of(made), f"{name}.c": source_of(made)}
            return {**code, f"{name}_bench.c": bench_of(made), f"{name}_run.csv": record(axis, motion(axis.axis)).text}
        case "hal":
            return {f"{name}.comp": hal.component_of(made), f"{name}.hal": hal.lines_of(made, axis.number)}
        case "st":
            return {f"{name}.st": structured_text.plain(made), f"{name}.TcPOU": structured_text.twincat(made)}
        case _:
            return {f"{name}_fmi{version[0]}.fmu": unit_of(made, version) for version in fmi.VERSIONS}


@question(Export)
def export(*source: Source, settings: Export, session: Session = QUIET) -> Exported:
    """Translate the controllers of the axes of a machine into code for a control.

    Parameters
    ----------
    *source : str, Path, Scenario, Case, or a Machine, its Controller and a Reference
        A controller file with ``machine``; or a scenario, as a file or read, or what it consists of.

    Returns
    -------
    Exported

    Raises
    ------
    ScenarioError, ParameterError
        If the files cannot be read, or a part of a controller cannot run in its axis alone.
    EngineError
        If a component cannot be translated.
    """
    to = settings.to
    loaded, steered, motion, inputs = _read(source, settings)
    found = {name: axis_control(loaded, steered, name) for name in settings.axis or loaded.axis_names}
    if len({control.control.name for control in found.values()}) != len(found):
        raise ParameterError("axes", ", ".join(found), "named with letters of ASCII, so that their code has different names")
    made: dict[str, str | bytes] = {}
    for control in found.values():
        made |= files_of(to, control, motion)
    digest = next(iter(found.values())).digest
    described = {name: ExportedAxis.of(control) for name, control in found.items()}
    return Exported(to, digest, (), described, tuple(_findings(steered, found, to)), made, inputs)


def _read(source: Sequence[Source], settings: Export) -> tuple[Machine, Controller, Motion, tuple[Any, ...]]:
    """Return machine, controller, the motion of each axis, and the files read."""
    from contourlab.scenario import BUILTIN, builtin_file, load_controller, load_machine
    from contourlab.scenario.load import named_file

    file, machine, scheme, plugins = source[0], settings.machine, settings.scheme, settings.plugin
    if machine is not None:
        refuse(scheme is not None, ParameterError, "--scheme", scheme, "left out with --machine: only a scenario has schemes")
        if not isinstance(file, str | Path):
            raise ParameterError("machine", repr(machine), "left out: only the file of a controller lacks its machine")
        stated = named_file(machine)
        loaded = load_machine(stated, plugins)
        steered = load_controller(named_file(file, "controller"), loaded, plugins)
        return loaded, steered, lambda name: there_and_back(loaded.axis(name), loaded.servo_period), (file, stated)
    if isinstance(file, str | Path) and kind_of(builtin_file(str(file)) if str(file).startswith(BUILTIN) else Path(file)) == "a controller":
        raise ScenarioError("a controller needs its machine: name it with --machine", file=file)
    scenario, case = case_asked(source, settings)
    planned = cache(case.reference)

    def motion(name: str) -> Array:
        block, j = planned().block(0, min(SAMPLES, planned().n_sample)), case.machine.axis_names.index(name)
        return np.column_stack([block.position[:, j], block.velocity[:, j], block.acceleration[:, j]])

    return case.machine, case.controller, motion, scenario.inputs


def _findings(controller: Controller, found: dict[str, AxisControl], to: str) -> list[Finding]:
    findings = [finding("CL952")] if controller.estimator is not None else []
    findings += [finding("CL955")] if to == "fmu" and compiler() is None else []
    for name, control in found.items():
        place, made = f"axis {name}", control.control
        if any(field.name.endswith("velocity") and not field.name.startswith("reference") for field in made.inputs.values()):
            findings.append(finding("CL950", place))
        if math.isinf(control.limit):
            findings.append(finding("CL951", place))
        if control.signal.endswith(".accepted"):
            findings.append(finding("CL954", place))
        called = sorted({op.kind for op in made.operations} & set(LIBRARY))
        if called:
            findings.append(finding("CL953", place, functions=", ".join(called)))
    return findings


# --- the controller of one axis, cut out of the servo loop: measured positions and the reference go in, the command comes out ---


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


@dataclass(frozen=True, eq=False)
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
    digest = f"machine={identity(machine)} controller={identity(controller)}"
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
        if part.command_unit == "m":
            bound = "one that closes a loop: this one passes positions on, so there is nothing to export"
            raise ParameterError(f"controller.axes.{axis}.{slot}", f'"{part.kind}"', bound)
        for port in part.inputs:
            if port.name in _REASONS:
                raise ParameterError(f"controller.axes.{axis}.{slot}", f'"{part.kind}"', f"left out: {_REASONS[port.name]}")
    if controller.axes[axis].link is not None:
        raise ParameterError(f"controller.axes.{axis}.link", "a link", "left out: the controller is exported in one piece")


def loop_of(machine: Machine, controller: Controller, at: float) -> Schedule:
    """Return the servo loop of a machine with one axis, at rest at a position."""
    return build(machine, controller, geometry.Path([geometry.Line((0.0,), (1.0,))]), np.array([at])).schedule


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
    own = machine.axis(axis)
    bounds = {name: (getattr(own.limits, name), what) for name, what in (("velocity", "m/s"), ("acceleration", "m/s^2"), ("jerk", "m/s^3"))}
    bounds["command"] = limit, unit
    known = [f"{name} {value:g} {what}" for name, (value, what) in bounds.items() if math.isfinite(value)]
    counted = ", ".join(part.kind for part in (own.sensor, own.motor_sensor) if not isinstance(part, IdealSensor))
    return (
        f"Controller of axis {axis} of {_line(machine.name)}.",
        stamp(**dict(word.split("=") for word in digest.split())),
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


@dataclass(frozen=True, eq=False)
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


# --- functional mock-up units: zip archives with description, sources, and a library for this machine if it has a compiler ---


_SYSTEMS = {"linux": ("linux", ".so"), "darwin": ("darwin", ".dylib"), "win32": ("win", ".dll")}
_PROCESSORS = {"x86_64": "x86_64", "amd64": "x86_64", "aarch64": "aarch64", "arm64": "aarch64"}


def compiler() -> str | None:
    """Return the C compiler: that of ``CC``, else gcc, clang or cc; None if there is none."""
    return next(filter(None, map(shutil.which, filter(None, (os.environ.get("CC"), "gcc", "clang", "cc")))), None)


def unit_of(made: Control, version: str) -> bytes:
    """Return a mock-up unit as a zip archive.

    Parameters
    ----------
    made : Control
    version : str
        One of `fmi.VERSIONS`.

    Raises
    ------
    ParameterError
        If the compiler fails.
    """
    library, interface = fmi.source_files(made)
    sources = {
        f"{made.name}.h": header_of(made),
        library: source_of(made),
        interface: fmi.wrapper_of(made, version),
    }
    files: dict[str, bytes] = {"modelDescription.xml": fmi.description_of(made, version).encode()}
    files |= {f"sources/{name}": text.encode("ascii", "replace") for name, text in sources.items()}
    if version == "3.0":
        files["sources/buildDescription.xml"] = fmi.build_description_of(made).encode()
    place = _binary_place(made.name, version)
    command = compiler()
    if place and command:
        files[place] = _compiled(command, sources, (library, interface))
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name), content)  # not compressed, so that what made it can be read
    return buffer.getvalue()


def _binary_place(name: str, version: str) -> str:
    """Return where the library of this machine belongs; empty if the standard names no place."""
    system, suffix = _SYSTEMS.get(sys.platform, ("", ""))
    processor = _PROCESSORS.get(platform.machine().lower(), "")
    if not system or not processor or (version == "2.0" and processor != "x86_64"):
        return ""
    folder = f"{system}64" if version == "2.0" else f"{processor}-{'windows' if system == 'win' else system}"
    return f"binaries/{folder}/{name}{suffix}"


def _compiled(command: str, sources: dict[str, str], units: tuple[str, ...]) -> bytes:
    """Return a shared library."""
    with tempfile.TemporaryDirectory(prefix="contourlab-") as folder:
        for name, text in sources.items():
            (Path(folder) / name).write_text(text, encoding="ascii", errors="replace")
        flags = ["-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC", "-fvisibility=hidden"]
        done = subprocess.run([command, *flags, *units, "-o", "library", "-lm"], cwd=folder, capture_output=True, text=True)
        if done.returncode:
            raise ParameterError("CC", command, f"a C compiler: {done.stderr[-300:]}")
        return (Path(folder) / "library").read_bytes()
