"""The axes of a machine in LinuxCNC's files: the ``pid`` of each, its gains, limits and wiring, and what it closes its loop on."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from contourlab.errors import ScenarioError
from contourlab.features.commission.hal_graph import LARGEST, REFERENCE, Entry, HalGraph, Ini, Statement, hal_files, read_graph, read_ini
from contourlab.features.commission.loop import GAINS
from contourlab.features.commission.loop_class import LoopClass, classified
from contourlab.findings import Finding, finding

LENGTHS = {"mm": 1e-3, "metric": 1e-3, "inch": 0.0254, "in": 0.0254, "imperial": 0.0254}
"""LINEAR_UNITS in metres."""
UNUSUAL = ("deadband", "maxerror", "maxerrorI", "maxerrorD", "maxcmdD", "maxcmdDD", "maxcmdDDD")
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
        In machine units, under HAL's names.
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
    if given.suffix == ".tcl":
        raise ScenarioError("is a Tcl script, which is not read: give a HAL file with the pid components", file=given)
    named = hal_files(ini)
    paths = [path for _, path in named if path is not None]
    # A file that the INI file does not name is a copy: it holds in place of those that it does.
    if given.resolve() in [path.resolve() for path in paths]:
        graph = read_graph(ini, paths, [entry for entry, path in named if path is None])
    else:
        graph = read_graph(ini, [given])
    findings = [finding("CL866", entry.place, file=entry.value) for entry in graph.unread]
    unit_entry = ini.first("TRAJ", "LINEAR_UNITS")
    unit_name = unit_entry.value.lower() if unit_entry else "mm"
    if unit_entry is None or unit_name not in LENGTHS:
        findings.append(finding("CL850", unit_entry.place if unit_entry else ini.file.name))
        unit_name = "mm"
    unit = LENGTHS[unit_name]
    period_ns = ini.number("EMCMOT", "SERVO_PERIOD", 0.0)
    if period_ns is None:
        findings.append(finding("CL851", ini.file.name))
    period = (period_ns or 1e6) * 1e-9
    axes = tuple(_Wiring(ini, given, graph, findings).axes())
    if not axes:
        raise ScenarioError("no linear joint has a pid on its motor-pos-cmd: a servo loop in HAL is needed", file=given.name)
    findings += [one for axis in axes for one in _doubtful(axis, unit, period)]
    name = "inch" if unit == LENGTHS["inch"] else "mm"
    return Setup(ini, given, unit, name, period, axes, tuple(findings))


def _doubtful(axis: AxisSetup, unit: float, period: float) -> Iterator[Finding]:
    """Yield why an axis cannot be commissioned."""
    place, speed = f"axis {axis.name}", axis.limits["velocity"] * unit
    if axis.loop.loop == "step generator":
        wanted = {"maxvel": HEADROOM * speed, "maxaccel": HEADROOM * axis.limits["acceleration"] * unit, "age": speed * period}
        yield finding("CL864", place, p=axis.gains["Pgain"], ff1=axis.gains["FF1"], most=1.0 / period, **wanted)
    if axis.loop.loop == "velocity drive":
        yield finding("CL868", place, why=axis.loop.why)
    if axis.idle:
        yield finding("CL865", place, pid=axis.pid)


class _Wiring:
    """The pid of each axis in the graph, and what is unusual about it."""

    def __init__(self, ini: Ini, file: Path, graph: HalGraph, findings: list[Finding]) -> None:
        self.ini, self.file, self.graph, self.findings = ini, file, graph, findings
        self.signal_of, self.set = graph.signal_of, graph.settings

    def letters(self) -> list[str]:
        """Return the axis letter of each joint."""
        kinematics = self.ini.first("KINS", "KINEMATICS")
        given = re.search(r"coordinates=([A-Za-z]+)", kinematics.value) if kinematics else None
        traj = self.ini.first("TRAJ", "COORDINATES")
        return list((given[1] if given else traj.value.replace(" ", "") if traj else "XYZABCUVW").lower())

    def axes(self) -> Iterator[AxisSetup]:
        """Yield the axes with a pid; note those without."""
        channels = [name for name, kind in self.graph.kinds.items() if kind in ("pid", "at_pid")]
        by_signal = {self.signal_of.get(f"{name}.command"): name for name in channels}
        by_signal.pop(None, None)
        used = set()
        for joint, letter in enumerate(self.letters()):
            pin = next((pin for pin in (f"joint.{joint}.motor-pos-cmd", f"axis.{joint}.motor-pos-cmd") if pin in self.signal_of), "")
            name = by_signal.get(self.signal_of.get(pin, ""))
            if name is None:
                self.findings.append(finding("CL852", f"axis {letter}", joint=joint))
                continue
            kind = self.ini.first(f"JOINT_{joint}", "TYPE")
            if kind is not None and kind.value.upper() == "ANGULAR":
                self.findings.append(finding("CL863", f"axis {letter}", joint=joint))
                continue
            if letter in used:
                self.findings.append(finding("CL853", f"joint {joint}", axis=letter))
                continue
            used.add(letter)
            yield self._axis(letter, joint, name)

    def _axis(self, letter: str, joint: int, name: str) -> AxisSetup:
        gains, places = dict.fromkeys(GAINS, 0.0) | {"Pgain": 1.0}, {}  # as pid starts
        mine = [one.line for pin, one in self.set.items() if pin.startswith(f"{name}.") and one.file == self.file]
        for gain in GAINS:
            one = self.set.get(f"{name}.{gain}")
            if one is not None:
                gains[gain], places[gain] = self._number(one), self._place(one)
        loop = classified(self.graph, name)
        self._check(letter, joint, name, loop)
        previous = self.set.get(f"{name}.error-previous-target")
        limit = self.set.get(f"{name}.maxoutput")
        signals = {pin: self.signal_of.get(f"{name}.{pin}", f"{name}.{pin}") for pin in ("command", "feedback", "output")}
        return AxisSetup(
            letter,
            joint,
            name,
            gains,
            places,
            max(mine, default=0),
            signals,
            self._limits(letter, joint),
            loop,
            None if previous is None else self._true(f"{name}.error-previous-target"),
            self._number(limit) if limit else 0.0,
            self.ini.number(f"JOINT_{joint}", "BACKLASH") or 0.0,
            self._true(f"{name}.enable"),
        )

    def _true(self, pin: str) -> bool:
        """Return whether a pin is set to true."""
        return pin in self.set and self.set[pin].words[2].lower() in ("1", "true", "yes")

    def _number(self, one: Statement) -> float:
        try:
            return float(one.words[2])
        except ValueError as error:
            missing = ": the INI file does not have it" if one.words[2].startswith("[") else ""
            raise ScenarioError(f"setp {one.words[1]} {one.words[2]}{missing}: must be a number", file=one.place) from error

    def _place(self, one: Statement) -> Entry:
        reference = REFERENCE.fullmatch(one.written[2])
        entry = None if reference is None else self.ini.first(reference[1], reference[2] or reference[3])
        return entry or Entry(one.file, one.line, one.words[2])

    def _limits(self, letter: str, joint: int) -> dict[str, float]:
        sections, limits = (f"AXIS_{letter.upper()}", f"JOINT_{joint}"), {}
        for name, key in (("velocity", "MAX_VELOCITY"), ("acceleration", "MAX_ACCELERATION"), ("low", "MIN_LIMIT"), ("high", "MAX_LIMIT")):
            above = 0.0 if name in ("velocity", "acceleration") else -LARGEST
            values = [value for section in sections if (value := self.ini.number(section, key, above)) is not None]
            if not values:
                raise ScenarioError(f"[JOINT_{joint}]{key} is missing: the excitation needs it", file=self.ini.file.name)
            limits[name] = max(values) if name == "low" else min(values)
        if not limits["low"] < limits["high"]:
            raise ScenarioError(f"[JOINT_{joint}]MAX_LIMIT = {limits['high']:g}: must be above MIN_LIMIT", file=self.ini.file.name)
        return limits

    def _check(self, letter: str, joint: int, name: str, loop: LoopClass) -> None:
        """Note what is missing or unusual in the wiring of a pid."""
        place = f"axis {letter}"
        fed = self.signal_of.get(f"{name}.feedback")
        if fed is None or self.signal_of.get(f"{name}.output") is None:
            pin = "feedback" if fed is None else "output"
            self.findings.append(finding("CL854", self.file.name, pin=f"{name}.{pin}"))
        elif not any(pin.endswith(f".{joint}.motor-pos-fb") for pin in self.graph.pins[fed]):
            self.findings.append(finding("CL855", place, signal=fed, joint=joint))
        if f"{name}.enable" not in self.signal_of and f"{name}.enable" not in self.set:
            self.findings.append(finding("CL856", self.file.name, pin=f"{name}.enable"))
        if self._true(f"{name}.enable"):
            self.findings.append(finding("CL861", self.set[f"{name}.enable"].place, pin=f"{name}.enable"))
        calculation, controller = f"{name}.do-pid-calcs", "motion-controller"
        if calculation not in self.graph.functions:
            self.findings.append(finding("CL857", self.file.name, function=calculation))
        elif controller in self.graph.functions and self.graph.functions.index(calculation) < self.graph.functions.index(controller):
            at = next(one for one in self.graph.statements if one.words[:2] == ("addf", calculation))
            self.findings.append(finding("CL858", at.place, function=calculation))
        if loop.loop == "step generator":
            return  # nothing is predicted for it
        for parameter in UNUSUAL:
            one = self.set.get(f"{name}.{parameter}")
            if one is not None and self._number(one) != 0.0:
                self.findings.append(finding("CL859", one.place, parameter=f"{name}.{parameter}"))
        for pin in ("command-deriv", "feedback-deriv"):
            if f"{name}.{pin}" in self.signal_of:
                self.findings.append(finding("CL860", self.file.name, pin=f"{name}.{pin}"))
