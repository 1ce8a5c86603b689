"""The machine that the files of LinuxCNC describe."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from contourlab.controls.contract import FLOATING, ControlFile, computed, driven_by_steps, position_drive, read_from, steps_controller
from contourlab.controls.linuxcnc.files import LENGTHS, HalGraph, Ini, beside, graph_of, read_ini, units_of
from contourlab.controls.linuxcnc.loops import Joint, LoopClass, classified, joints, refuse_coupled, without_pid
from contourlab.errors import ScenarioError, refuse
from contourlab.findings import Finding, finding

LETTERS = "xyz"
"""Axes that a part program moves."""
_OWN = re.compile(rb"^(\s*\[(EMC|DISPLAY|EMCMOT|KINS|TRAJ|RS274NGC)\]|#INCLUDE\s)", re.MULTILINE)


def matches(file: Path, head: bytes) -> bool:
    """Return whether a file is an INI file of LinuxCNC."""
    return file.suffix.lower() == ".ini" and _OWN.search(head) is not None


def read(file: Path) -> ControlFile:
    """Return the machine of an INI file.

    Raises
    ------
    ScenarioError
        If a file cannot be read, a number is faulty, the kinematics couple the axes, or none of x, y and z moves.
    """
    ini = read_ini(file)
    return _Machine(ini, *graph_of(ini)).control_file()


@dataclass(eq=False)
class _Machine:
    """A machine while it is read."""

    ini: Ini
    graph: HalGraph
    files: Sequence[Path]
    findings: list[Finding] = field(default_factory=list)
    unmodelled: dict[str, str] = field(default_factory=dict)
    guesses: dict[str, str] = field(default_factory=dict)
    seconds: dict[str, list[int]] = field(default_factory=dict)
    unit: float = LENGTHS["mm"]
    period: float = 1e-3

    def control_file(self) -> ControlFile:
        """Return what the files say."""
        refuse_coupled(self.ini, self.graph)
        self.unit, self.period, self.findings = units_of(self.ini, self.graph)
        if (given := self.ini.first("TRAJ", "LINEAR_UNITS")) and any(found.code == "CL850" for found in self.findings):
            raise ScenarioError(f"LINEAR_UNITS = {given.value}: write mm or inch", file=given.place)
        axes = dict(sorted(self._joints().items()))
        refuse(not axes, ScenarioError, "has none of the axes x, y and z", file=self.ini.file)
        name, period = self.ini.first("EMC", "MACHINE"), f"{self.period * 1e6:.12g} us"
        machine = {
            "name": (name.value if name else "")[:200] or self.ini.file.stem,
            "servo_period": self._read(period, "EMCMOT", "SERVO_PERIOD") or period,
            "axes": list(axes),
        }
        if path := self._least([("TRAJ", "MAX_LINEAR_VELOCITY")], "mm/s"):
            machine["path_velocity"] = path
        machine |= self._planner()
        tables: dict[str, Any] = {"machine": machine, "axes": {letter: self._axis(joint) for letter, joint in axes.items()}}
        for code, whys in (("CL984", self.guesses), ("CL988", self.unmodelled)):
            if whys:
                self.findings.append(finding(code, axes=list(whys), why=next(iter(whys.values()))))
        tables |= {"controller": steps_controller(axes), "program": self._program()}
        homes = [self._home(axes[letter]) if letter in axes else 0.0 for letter in LETTERS]
        if any(homes):
            tables["program"]["start"] = ", ".join(map(repr, homes))
        return ControlFile(self.ini.file, "LinuxCNC", tables, self.unmodelled, tuple(self.findings), tuple(self.files))

    @property
    def _jerk(self) -> bool:
        """Whether the planner keeps limits of jerk; below 1 it does not."""
        planner, least = self.ini.first("TRAJ", "PLANNER_TYPE"), self.ini.number("TRAJ", "MAX_LINEAR_JERK")
        return planner is not None and planner.value == "1" and (least is None or least >= 1.0)

    def _planner(self) -> dict[str, Any]:
        """Return how LinuxCNC plans: nothing where it keeps limits of jerk, or has its blend arcs switched off."""
        names = {"kink_ratio": "KINK_RATIO", "gap_cycles": "GAP_CYCLES", "enable": "ENABLE", "planner_blocks": "OPTIMIZATION_DEPTH"}
        keys = {name: ("TRAJ", f"ARC_BLEND_{key}") for name, key in names.items()} | {"largest_override": ("DISPLAY", "MAX_FEED_OVERRIDE")}
        given = {name: value for name, key in keys.items() if (value := self.ini.number(*key)) is not None}
        depth = int(given.pop("planner_blocks", 50.0))
        if self._jerk or given.pop("enable", 1.0) == 0.0 or depth < 2:
            return {}
        if "kink_ratio" in given:
            given["kink_ratio"] = min(max(given["kink_ratio"], 0.001), 0.7071)
        read = {name: self._read(value, *keys[name]) for name, value in given.items()}
        return {"planner": "linuxcnc", "planner_blocks": min(depth + 2, 1000), **read}

    def _joints(self) -> dict[str, Joint]:
        """Return the joint of each axis; note those that are left out."""
        axes: dict[str, Joint] = {}
        for joint in joints(self.ini, self.graph):
            sections = (f"JOINT_{joint.number}", f"AXIS_{joint.number}")
            if joint.axis not in LETTERS:
                self.findings.append(finding("CL981", self.ini.file.name, axis=joint.axis, why="only x, y and z are read"))
            elif not any(section in sections for section, _ in self.ini.values):
                self.findings.append(finding("CL981", self.ini.file.name, axis=joint.axis, why=f"there is no [{sections[0]}]"))
            elif joint.axis in axes:
                self.findings.append(finding("CL982", self.ini.file.name, axis=joint.axis, joint=joint.number))
                self.seconds.setdefault(joint.axis, []).append(joint.number)
            else:
                axes[joint.axis] = joint
        return axes

    def _read(self, value: Any, section: str, key: str) -> dict[str, Any] | None:
        entry = self.ini.first(section, key)
        return None if entry is None else read_from(value, f"{entry.place} [{section}]{key}")

    def _least(self, keys: Sequence[tuple[str, str]], unit: str, *, largest: bool = False) -> dict[str, Any] | None:
        """Return the least of several values of the file, or the largest; None if it has none."""
        values = [(value, key) for key in keys if (value := self.ini.number(*key)) is not None]
        if not values:
            return None
        value, key = max(values) if largest else min(values)
        if value <= 0.0 and "/" in unit:
            raise ScenarioError(f"[{key[0]}]{key[1]} = {value:g}: must be above 0", file=self.ini.values[key][0].place)
        return self._read(f"{value * self.unit * 1e3:.12g} {unit}", *key)

    def _home(self, joint: Joint) -> float:
        """Return where an axis stands after homing, in machine units: within its travel."""
        limits = [[self.ini.number(section, key) for section in self._sections(joint)] for key in ("MIN_LIMIT", "MAX_LIMIT", "HOME")]
        lows, highs, homes = ([value for value in values if value is not None] for values in limits)
        home = homes[0] if homes else 0.0
        return min([max([home, *lows]), *highs])

    def _sections(self, joint: Joint) -> tuple[str, ...]:
        """Return the sections of an axis and its joints; before LinuxCNC 2.8 the axes had numbers."""
        numbers = [joint.number, *self.seconds.get(joint.axis, ())]
        return (f"AXIS_{joint.axis.upper()}", *(f"{kind}_{number}" for number in numbers for kind in ("JOINT", "AXIS")))

    def _axis(self, joint: Joint) -> dict[str, Any]:
        """Return the tables of an axis."""
        own = self._sections(joint)
        limits: dict[str, Any] = {**FLOATING}
        for name, key, unit in (("velocity", "MAX_VELOCITY", "mm/s"), ("acceleration", "MAX_ACCELERATION", "mm/s^2")):
            path = [("TRAJ", "MAX_LINEAR_ACCELERATION")] if name == "acceleration" else []
            if value := self._least([*((section, key) for section in own), *path], unit):
                limits[name] = value
            else:
                self.findings.append(finding("CL983", self.ini.file.name, axis=joint.axis, key=key))
        if self._jerk:
            keys = [("TRAJ", "MAX_LINEAR_JERK"), *((section, "MAX_JERK") for section in own)]
            limits |= {"jerk": jerk} if (jerk := self._least(keys, "mm/s^3")) else {}
        ends = [self._least([(section, key) for section in own], "mm", largest=key == "MIN_LIMIT") for key in ("MIN_LIMIT", "MAX_LIMIT")]
        if ends[0] and ends[1]:
            limits["travel"] = read_from([end["value"] for end in ends if end], f"{ends[0]['from']} and {ends[1]['from']}")
        if gap := next((gap for section in own if (gap := self.ini.number(section, "BACKLASH"))), None):
            self.findings.append(finding("CL986", f"axis {joint.axis}", gap=abs(gap) * self.unit))
        if table := next((entry for section in own if (entry := self.ini.first(section, "COMP_FILE"))), None):
            self.findings.append(finding("CL987", f"axis {joint.axis}", file=table.value))
        loop = classified(self.graph, joint.pid) if joint.pid else without_pid(self.graph, joint.number)
        # With a step generator LinuxCNC compares the command with the count, not with the axis.
        follows = self._least([(section, "FERROR") for section in own], "mm")
        if follows and loop.loop not in ("step generator", "position drive"):
            limits["following_error"] = follows
        return {**self._answer(joint, loop), "limits": limits}

    def _answer(self, joint: Joint, loop: LoopClass) -> dict[str, Any]:
        """Return plant and drive of an axis, by what closes its loop."""
        own = self._sections(joint)[1:]
        if loop.loop == "step generator":
            self.guesses[joint.axis] = loop.why
            scale = next((scale for key in ("STEP_SCALE", "SCALE") for section in own if (scale := self.ini.number(section, key))), None)
            pulse = computed(f"{abs(self.unit * 1e6 / scale):.12g} um", "1/STEP_SCALE") if scale else None
            drive: dict[str, Any] = {"kind": "step-generator"}
            for name, key, unit in (("velocity_limit", "STEPGEN_MAXVEL", "mm/s"), ("acceleration_limit", "STEPGEN_MAXACCEL", "mm/s^2")):
                keys = [(section, key) for section in own if self.ini.number(section, key)]  # 0 is none
                drive |= {name: self._least(keys, unit)} if keys else {}
            return {**driven_by_steps(self.period, pulse), "drive": drive}
        if loop.loop == "position drive":
            self.guesses[joint.axis] = loop.why
            return position_drive(self.period)
        self.unmodelled[joint.axis] = loop.why
        return {"plant": {"kind": "step-drive", "natural_frequency": f"{0.02 / self.period:.3g} Hz"}}

    def _program(self) -> dict[str, Any]:
        """Return how LinuxCNC reads a part program."""
        startup = self.ini.first("RS274NGC", "RS274NGC_STARTUP_CODE") or self.ini.first("EMC", "RS274NGC_STARTUP_CODE")
        code, place = (f"G64\n{startup.value}", startup.place) if startup else ("G64", self.ini.file.name)
        # LinuxCNC starts in G64 without P.
        keys: dict[str, Any] = {"unit": "mm" if self.unit == LENGTHS["mm"] else "inch", "startup": code, "startup_place": place}
        for name, section, key in (("tools", "EMCIO", "TOOL_TABLE"), ("parameters", "RS274NGC", "PARAMETER_FILE")):
            entry = self.ini.first(section, key)
            if entry is None or not entry.value:
                continue
            path = beside(self.ini.file, entry.value)
            if path.is_file():
                keys[name] = str(path.absolute())
            else:
                self.findings.append(finding("CL980", entry.place, key=key, file=entry.value))
        # The control looks for subprograms in this order.
        paths = [self.ini.first("DISPLAY", "PROGRAM_PREFIX"), self.ini.first("RS274NGC", "SUBROUTINE_PATH")]
        folders = [path for entry in paths if entry for path in entry.value.split(":") if path]
        keys["subprograms"] = [str(beside(self.ini.file, path).absolute()) for path in folders]
        remaps = self.ini.values.get(("RS274NGC", "REMAP"), [])
        keys["remapped"] = [f"{entry.value.split()[0].upper()} {entry.place}" for entry in remaps if entry.value]
        return keys
