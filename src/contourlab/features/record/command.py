"""``contourlab record``: what records a run of a part program on LinuxCNC, in columns that ``measure`` knows."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from contourlab.app.json_values import HIDDEN
from contourlab.app.results import filled, write_together
from contourlab.app.session import QUIET, Answer, Session, question
from contourlab.controls.linuxcnc.files import HalGraph, graph_of, read_ini, sampler_lines, units_of
from contourlab.controls.linuxcnc.loops import Joint, commanded, feedback, joints, refuse_coupled
from contourlab.controls.linuxcnc.machine import LETTERS, matches
from contourlab.errors import ScenarioError, refuse
from contourlab.features.record.options import Record
from contourlab.findings import Finding, finding
from contourlab.rendering.table import paragraphs

HAL, SCRIPT = "contourlab-record.hal", "contourlab-record.sh"
SOON = 0.5
"""Time [s] that is recorded before and after the program."""
_NAMES = re.compile(r"[\w.:-]+( [\w.:-]+)?", re.ASCII)


@dataclass(frozen=True)
class RecordedAxis:
    """What is recorded of an axis: pins or signals of HAL.

    Attributes
    ----------
    axis : str
    command, position : str
    source : {"encoder", "steps", "unseen"}
        Where the position comes from: "steps" is the count of a step generator.
    pin : str
        The pin that it comes from, as far as it is known.
    others : mapping of str to str
        Of an axis with several joints: the positions of the others, by their columns in the log, which are no signal unless named as one.
    """

    axis: str
    command: str
    position: str
    source: str
    pin: str
    others: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Recording(Answer):
    """What to load and to run to record a part program.

    Attributes
    ----------
    axes : tuple of RecordedAxis
    findings : tuple of Finding
    files : tuple of Path
    """

    ROWS = "axes"

    axes: tuple[RecordedAxis, ...]
    findings: tuple[Finding, ...]
    files: tuple[Path, ...] = ()
    contents: Mapping[str, str] = field(default_factory=dict, metadata=HIDDEN, repr=False)
    ini: Path = field(default=Path(), metadata=HIDDEN, repr=False)

    @property
    def text(self) -> str:
        """What is recorded, findings and files."""
        lines = [f"{axis.axis}: {axis.command} and {axis.position}, from {axis.pin or 'an unknown place'}" for axis in self.axes]
        files = [*(f"written: {file}" for file in self.files), *([f"The head of {SCRIPT} says what to do."] if self.files else [])]
        return "\n\n".join(filter(None, map(paragraphs, (lines, map(str, self.findings), files))))

    def save(self, folder: str | Path = "recording") -> Recording:
        """Write the HAL file and the script, both or none; the head of the script says what to do with them.

        Parameters
        ----------
        folder : str or Path

        Returns
        -------
        Recording
            With the names of its files.

        Raises
        ------
        OutputError, ParameterError
            If a file cannot be written, or would replace an input.
        """
        files: dict[Path, str | bytes] = {Path(folder) / name: content for name, content in self.contents.items()}
        write_together(files, [self.ini])
        return replace(self, files=tuple(files))


@question(Record)
def record(ini: str | Path, *, settings: Record, session: Session = QUIET) -> Recording:
    """Write what records a run of a part program on LinuxCNC: a HAL file for its sampler, and a script that waits for the program.

    Parameters
    ----------
    ini : str or Path
        The machine's INI file.

    Returns
    -------
    Recording

    Raises
    ------
    ScenarioError
        If a file cannot be read, the kinematics couple the axes, LinuxCNC loads a sampler already, or none of x, y and z moves.
    """
    files = read_ini(ini)
    refuse(not matches(files.file, files.file.read_bytes()), ScenarioError, "is no INI file of LinuxCNC", file=ini)
    graph, _ = graph_of(files)
    refuse_coupled(files, graph)
    if loaded := next((line for line in graph.statements if line.words[:2] == ("loadrt", "sampler")), None):
        raise ScenarioError("loads a sampler, and LinuxCNC loads only one: remove it to record with another", file=loaded.place)
    of_axes = [(joint, _recorded(graph, joint)) for joint in joints(files, graph) if joint.axis in LETTERS]
    moved = {own.axis: own for _, own in reversed(of_axes)}
    refuse(not moved, ScenarioError, "has none of the axes x, y and z", file=ini)
    others = [(own.axis, f"gantry_{own.axis}_{joint.number}", own.position) for joint, own in of_axes if own not in moved.values()]
    axes = tuple(replace(moved[a], others={name: pin for axis, name, pin in others if axis == a}) for a in sorted(moved))
    unit, period, findings = units_of(files, graph)
    steps, unseen = ([axis.axis for axis in axes if axis.source == source] for source in ("steps", "unseen"))
    findings += [finding(code, axes=names) for code, names in (("CL415", steps), ("CL992", unseen)) if names]
    findings += [finding("CL993", files.file.name)] if files.first("HAL", "HALUI") is None else []
    # A position that is no count of steps is that of the axis, also where the loop is closed on a count.
    name = "axis_position" if all(axis.source == "encoder" for axis in axes) else "position"
    length = "mm" if unit < 0.01 else "inch"
    heads = [f"{head} [{length}]" for axis in axes for head in (f"reference.{axis.axis}", f"{name}.{axis.axis}", *axis.others)]
    findings += [finding("CL994", axis=axis.axis, pin=axis.position, name=name, columns=axis.others) for axis in axes if axis.others]
    values = {"PERIOD": f"{period:.9g}", "KEPT": str(round(SOON / period)), "HEADER": ",".join(["time [s]", *heads, "line"])}
    contents = {HAL: _hal(graph, axes), SCRIPT: filled(Path(__file__).with_name("record.sh"), values)}
    return Recording(axes, tuple(findings), contents=contents, ini=Path(ini))


def _recorded(graph: HalGraph, joint: Joint) -> RecordedAxis:
    """Return what is recorded of a joint: command and position of motion, or those of its pid if only there an encoder is read."""
    old = commanded(graph, joint.number).startswith("axis.")
    own = f"axis.{joint.number}" if old else f"joint.{joint.number}"
    command, position = (f"{own}.{'joint-' * old}pos-{end}" for end in ("cmd", "fb"))
    source, pin = feedback(graph, f"{own}.motor-pos-fb")
    if source != "encoder" and joint.pid and (of_pid := feedback(graph, f"{joint.pid}.feedback"))[0] == "encoder":
        command, position, (source, pin) = f"{joint.pid}.command", f"{joint.pid}.feedback", of_pid
    return RecordedAxis(joint.axis, command, position, source, pin)


def _hal(graph: HalGraph, axes: tuple[RecordedAxis, ...]) -> str:
    """Return the HAL file. A pin keeps the signal that it has."""
    pins = [pin for axis in axes for pin in (axis.command, axis.position, *axis.others.values())]
    pins += ["motion.program-line", "halui.mode.is-auto", "halui.program.is-idle"]
    sources = [graph.signal_of.get(pin) or f"contourlab-{k} {pin}" for k, pin in enumerate(pins)]
    if strange := next((source for source in sources if not _NAMES.fullmatch(source)), None):
        raise ScenarioError(f"{strange!r} is no name of HAL", file="HAL")
    head = f"# Made by contourlab record. Load it as last HALFILE; the head of {SCRIPT} says how."
    return "\n".join([head, *sampler_lines(sources, "f" * (len(pins) - 3) + "sbb"), ""])
