"""The ``pid`` of each axis of a LinuxCNC, what it closes its loop on, and what is missing or unusual in its files."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.controls.linuxcnc.files import LENGTHS, REFERENCE, Entry, HalGraph, Ini, graph_of, read_ini, units_of
from contourlab.controls.linuxcnc.loops import LoopClass, classified, joints
from contourlab.errors import ScenarioError, refuse
from contourlab.features.commission.loop import GAINS, SETTINGS
from contourlab.findings import Finding, finding

UNUSUAL = ("maxerror", "maxerrorI", "maxerrorD", "maxcmdD", "maxcmdDD", "maxcmdDDD")
"""Parameters of ``pid`` that the model of the loop leaves out."""
HEADROOM = 1.25
"""Limits of a step generator over those of its joint, at least: a correction needs the rest."""


@dataclass(frozen=True, eq=False)
class AxisSetup:
    """An axis, its joint, and the ``pid`` that controls it.

    Attributes
    ----------
    name : str
        Lower-case letter.
    joint : int
    pid : str
        Name of the channel, as ``pid.0``.
    gains : dict of str to float
        In machine units, under HAL's names; with dead band and bias where a file sets them.
    places : dict of str to Entry
        Where each gain is set: the ``setp`` line of the HAL file, or the key of the INI file that it refers to.
    last : int
        Line of the last ``setp`` of this pid in the HAL file; 0 if there is none.
    signals : dict of str to str
        HAL signals of ``command``, ``feedback`` and ``output``; pins where there is no signal.
    limits : dict of str to float
        ``velocity``, ``acceleration``, ``low``, ``high`` in machine units.
    loop : LoopClass
        What the pid closes its loop on, as the files say.
    previous_target : bool or None
        ``error-previous-target``, if set.
    maxoutput, backlash : float
    always_enabled : bool
        Whether ``enable`` is set, not connected.
    """

    name: str
    joint: int
    pid: str
    gains: dict[str, float]
    places: dict[str, Entry]
    last: int
    signals: dict[str, str]
    limits: dict[str, float]
    loop: LoopClass
    previous_target: bool | None = None
    maxoutput: float = 0.0
    backlash: float = 0.0
    always_enabled: bool = False

    @property
    def idle(self) -> bool:
        """Whether the pid has neither proportional gain nor velocity feedforward."""
        return not self.gains["Pgain"] and not self.gains["FF1"]


def row_of(gains: Mapping[str, float], unit: float) -> Array:
    """Return gains (7,) per metre, in the order of `loop.GAINS`, from those in machine units [m]."""
    return np.array([gains[name] / unit for name in GAINS])


@dataclass(frozen=True, eq=False)
class Setup:
    """What INI and HAL say of a machine.

    Attributes
    ----------
    ini : Ini
    hal : Path
    unit : float [m]
        Length of a machine unit.
    unit_name : str
        "mm" or "inch".
    period : float [s]
    axes : tuple of AxisSetup
        Those with a pid.
    findings : tuple of Finding
    """

    ini: Ini
    hal: Path
    unit: float
    unit_name: str
    period: float
    axes: tuple[AxisSetup, ...]
    findings: tuple[Finding, ...] = field(default=())

    @property
    def closed(self) -> tuple[AxisSetup, ...]:
        """The axes with something of the machine in their loop."""
        return tuple(axis for axis in self.axes if axis.loop.loop != "step generator")


def read_setup(ini_file: str | Path, hal_file: str | Path) -> Setup:
    """Read INI and HAL, with the further HAL files of an INI file that names this one, and find the pid of each axis.

    Raises
    ------
    ScenarioError
        If a file cannot be read, a number is faulty, or no axis has a pid.
    """
    ini, given = read_ini(ini_file), Path(hal_file)
    refuse(given.suffix == ".tcl", ScenarioError, "is a Tcl script, which is not read: give a HAL file with the pid components", file=given)
    graph, _ = graph_of(ini, given)
    unit, period, findings = units_of(ini, graph)
    axes = tuple(_Wiring(ini, given, graph, findings).axes())
    refuse(not axes, ScenarioError, "no linear joint has a pid on its motor-pos-cmd: a servo loop in HAL is needed", file=given.name)
    findings += [doubt for axis in axes for doubt in _doubtful(axis, unit, period)]
    name = "inch" if unit == LENGTHS["inch"] else "mm"
    return Setup(ini, given, unit, name, period, axes, tuple(findings))


def _doubtful(axis: AxisSetup, unit: float, period: float) -> Iterator[Finding]:
    """Yield why an axis cannot be commissioned."""
    place, speed = f"axis {axis.name}", axis.limits["velocity"] * unit
    if axis.loop.loop == "step generator":
        wanted = {"maxvel": HEADROOM * speed, "maxaccel": HEADROOM * axis.limits["acceleration"] * unit, "age": speed * period}
        yield finding("CL864", place, p=axis.gains["Pgain"], ff1=axis.gains["FF1"], most=1.0 / period, **wanted)
    if axis.idle:
        yield finding("CL865", place, pid=axis.pid)


@dataclass(frozen=True, eq=False)
class _Wiring:
    """The pid of each axis in the graph, and what is unusual about it."""

    ini: Ini
    file: Path
    graph: HalGraph
    findings: list[Finding]

    def axes(self) -> Iterator[AxisSetup]:
        """Yield the axes with a pid; note those without."""
        used = set()
        for joint in joints(self.ini, self.graph):
            kind = self.ini.first(f"JOINT_{joint.number}", "TYPE")
            if not joint.pid:
                self.findings.append(finding("CL852", f"axis {joint.axis}", joint=joint.number))
            elif kind is not None and kind.value.upper() == "ANGULAR":
                self.findings.append(finding("CL863", f"axis {joint.axis}", joint=joint.number))
            elif joint.axis in used:
                self.findings.append(finding("CL853", f"joint {joint.number}", axis=joint.axis))
            else:
                used.add(joint.axis)
                yield self._axis(joint.axis, joint.number, joint.pid)

    def _axis(self, letter: str, joint: int, name: str) -> AxisSetup:
        graph, places = self.graph, {}
        gains = dict.fromkeys(GAINS, 0.0) | {"Pgain": 1.0}  # as pid starts
        for gain in SETTINGS:
            if statement := graph.settings.get(f"{name}.{gain}"):
                places[gain] = self.ini.referred(REFERENCE.fullmatch(statement.written[2])) or statement.entry(2)
                gains[gain] = graph.number(f"{name}.{gain}")
        loop, previous = classified(graph, name), f"{name}.error-previous-target"
        self._check(letter, joint, name, loop)
        mine = [line.line for pin, line in graph.settings.items() if pin.startswith(f"{name}.") and line.file == self.file]
        return AxisSetup(
            letter,
            joint,
            name,
            gains,
            places,
            max(mine, default=0),
            {pin: graph.signal_of.get(f"{name}.{pin}", f"{name}.{pin}") for pin in ("command", "feedback", "output")},
            self._limits(letter, joint),
            loop,
            graph.true(previous) if previous in graph.settings else None,
            graph.number(f"{name}.maxoutput"),
            self.ini.number(f"JOINT_{joint}", "BACKLASH") or 0.0,
            graph.true(f"{name}.enable"),
        )

    def _limits(self, letter: str, joint: int) -> dict[str, float]:
        sections, limits = (f"AXIS_{letter.upper()}", f"JOINT_{joint}"), {}
        for name, key in (("velocity", "MAX_VELOCITY"), ("acceleration", "MAX_ACCELERATION"), ("low", "MIN_LIMIT"), ("high", "MAX_LIMIT")):
            positive = name in ("velocity", "acceleration")
            values = [value for section in sections if (value := self.ini.number(section, key, positive=positive)) is not None]
            refuse(not values, ScenarioError, f"[JOINT_{joint}]{key} sets no limit: the excitation needs one", file=self.ini.file.name)
            limits[name] = max(values) if name == "low" else min(values)
        if not limits["low"] < limits["high"]:
            raise ScenarioError(f"[JOINT_{joint}]MAX_LIMIT = {limits['high']:g}: must be above MIN_LIMIT", file=self.ini.file.name)
        return limits

    def _check(self, letter: str, joint: int, name: str, loop: LoopClass) -> None:
        """Note what is missing or unusual in the wiring of a pid."""
        graph, wired, enable = self.graph, self.graph.signal_of, f"{name}.enable"

        def note(code: str, place: str = self.file.name, **values: Any) -> None:
            self.findings.append(finding(code, place, **values))

        if absent := [pin for pin in (f"{name}.feedback", f"{name}.output") if pin not in wired]:
            note("CL854", pin=absent[0])
        elif not any(pin.endswith(f".{joint}.motor-pos-fb") for pin in graph.pins[wired[f"{name}.feedback"]]):
            note("CL855", f"axis {letter}", signal=wired[f"{name}.feedback"], joint=joint)
        if enable not in wired and enable not in graph.settings:
            note("CL856", pin=enable)
        if graph.true(enable):
            note("CL861", graph.settings[enable].place, pin=enable)
        calculation, functions = f"{name}.do-pid-calcs", graph.functions
        if calculation not in functions:
            note("CL857", function=calculation)
        elif "motion-controller" in functions and functions.index(calculation) < functions.index("motion-controller"):
            at = next(statement for statement in graph.statements if statement.words[:2] == ("addf", calculation))
            note("CL858", at.place, function=calculation)
        if loop.loop == "step generator":
            return  # nothing is predicted for it
        for parameter in (f"{name}.{parameter}" for parameter in UNUSUAL):
            if graph.number(parameter) != 0.0:
                note("CL859", graph.settings[parameter].place, parameter=parameter)
        for pin in (f"{name}.command-deriv", f"{name}.feedback-deriv"):
            if pin in wired:
                note("CL860", pin=pin)
