"""``contourlab export``: the controllers of the axes as code for a control."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.app.json_values import HIDDEN, json_values, write_json
from contourlab.app.results import staged
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.arrays import Array
from contourlab.engine.translate import fmi, hal, structured_text
from contourlab.engine.translate.control import LIBRARY, Field, bench_of, header_of, source_of
from contourlab.errors import ParameterError, ScenarioError
from contourlab.features.export.axis_controller import SAMPLES, AxisControl, axis_control, record, there_and_back
from contourlab.features.export.mock_up import compiler, unit_of
from contourlab.features.export.options import Export
from contourlab.file_kinds import kind_of
from contourlab.findings import Finding, finding
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result.atomic import write_bytes_atomic

if TYPE_CHECKING:
    from contourlab.loop import Controller, Machine

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


@dataclass(frozen=True)
class Exported(Answer):
    """The controllers of axes as code.

    Attributes
    ----------
    to : str
        The language.
    hash : str
        SHA-256 of machine and controller as TOML; it is in every file.
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
        table = Table([Column("axis", left=True), *(Column(head, prose=True, left=True) for head in ("inputs", "command", "parameters"))])
        for axis, made in self.axes.items():
            command = made.outputs[0]
            table.add(axis, _names(made.inputs), f"{command.name} [{command.unit}]", _names(made.parameters))
        files = "\n".join(map(str, self.files))
        return "\n\n".join(filter(None, [table.text(), paragraphs(map(str, self.findings)), f"hash: {self.hash}\n{files}"]))


def _names(fields: Sequence[Field]) -> str:
    return ", ".join(field.name + (f" [{field.unit}]" if field.unit else "") for field in fields) or "none"


def _c99(found: AxisControl, motion: Motion) -> dict[str, str | bytes]:
    name = found.control.name
    return {
        f"{name}.h": header_of(found.control),
        f"{name}.c": source_of(found.control),
        f"{name}_bench.c": bench_of(found.control),
        f"{name}_run.csv": record(found, motion(found.axis)).text,
    }


def _hal(found: AxisControl, motion: Motion) -> dict[str, str | bytes]:
    name = found.control.name
    return {f"{name}.comp": hal.component_of(found.control), f"{name}.hal": hal.lines_of(found.control, found.number)}


def _st(found: AxisControl, motion: Motion) -> dict[str, str | bytes]:
    name, made = found.control.name, found.control
    return {f"{name}.st": structured_text.plain(made), f"{name}.TcPOU": structured_text.twincat(made)}


def _fmu(found: AxisControl, motion: Motion) -> dict[str, str | bytes]:
    made = found.control
    return {f"{made.name}_fmi{version[0]}.fmu": unit_of(made, version) for version in fmi.VERSIONS}


TARGETS: dict[str, Callable[[AxisControl, Motion], dict[str, str | bytes]]] = {"c99": _c99, "hal": _hal, "st": _st, "fmu": _fmu}
"""The files of an axis by name, for each language."""


@question(Export)
def export(file: str | Path, *, settings: Export, session: Session = QUIET) -> Exported:
    """Translate the controllers of the axes of a machine into code for a control.

    Parameters
    ----------
    file : str or Path
        A controller with ``machine``, or a scenario without.

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
    loaded, steered, motion, inputs = _read(file, settings.machine, settings.scheme, settings.plugin)
    found = {name: axis_control(loaded, steered, name) for name in settings.axis or loaded.axis_names}
    if len({control.control.name for control in found.values()}) != len(found):
        raise ParameterError("axes", ", ".join(found), "named with letters of ASCII, so that their code has different names")
    made: dict[str, str | bytes] = {}
    for control in found.values():
        made |= TARGETS[to](control, motion)
    digest = next(iter(found.values())).digest
    described = {name: _described(control) for name, control in found.items()}
    return Exported(to, digest, (), described, tuple(_findings(steered, found, to)), made, inputs)


def _read(
    file: str | Path, machine: str | Path | None, scheme: str | None, plugins: Sequence[str | Path]
) -> tuple[Machine, Controller, Motion, tuple[Any, ...]]:
    """Return machine, controller, the motion of each axis, and the files read."""
    from contourlab.scenario import load_controller, load_machine, load_scenario
    from contourlab.scenario.load import named_file

    if machine is not None:
        if scheme is not None:
            raise ParameterError("--scheme", scheme, "left out with --machine: only a scenario has schemes")
        stated = named_file(machine)
        loaded = load_machine(stated, plugins)
        steered = load_controller(named_file(file, "controller"), loaded, plugins)
        return loaded, steered, lambda name: there_and_back(loaded.axis(name), loaded.servo_period), (file, stated)
    _check_scenario(file)
    scenario = load_scenario(file, plugins)
    case = scenario.base if scheme is None else scenario.case(scheme)

    planned = cache(case.reference)

    def motion(name: str) -> Array:
        block, j = planned().block(0, min(SAMPLES, planned().n_sample)), case.machine.axis_names.index(name)
        return np.column_stack([block.position[:, j], block.velocity[:, j], block.acceleration[:, j]])

    return case.machine, case.controller, motion, scenario.inputs


def _check_scenario(file: str | Path) -> None:
    """Refuse a controller without its machine."""
    from contourlab.scenario.files import BUILTIN, builtin_file

    path = builtin_file(str(file)) if str(file).startswith(BUILTIN) else Path(file)
    if kind_of(path) == "a controller":
        raise ScenarioError("a controller needs its machine: name it with --machine", file=file)


def _described(found: AxisControl) -> ExportedAxis:
    made = found.control
    groups = (made.inputs.values(), (made.output,), made.parameters.values(), made.constants.values())
    return ExportedAxis(made.name, made.period, found.parts, *map(tuple, groups))


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
