"""INI and HAL files of LinuxCNC: what they set, load and connect; the ``pid`` of each axis, and what it closes its loop on."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ScenarioError
from contourlab.features.commission.loop import GAINS
from contourlab.file_kinds import mistaken
from contourlab.findings import Finding, finding

LARGEST = 1e9
"""Limit of what an INI file may say: beyond it a number stands for no limit."""
LIBRARY = Path("/usr/share/linuxcnc/hallib")
"""Where LinuxCNC finds HAL files that are not beside the INI file."""
PASSING = re.compile(
    r"abs|biquad|blend|conv_(float|s32|u32)_(float|s32|u32)|deadzone|feedcomp|i?lowpass|invert|limit[123]|lincurve|mult2"
    r"|mux(2|4|8|16|_gen|_generic)|offset|sample_hold|scale|sum2|tristate_float|weighted_sum"
)
"""Components whose outputs follow their inputs."""
REFERENCE = re.compile(r"\[(\w+)\](?:\((\w+)\)|(\w+))")
"""A key of the INI file in a HAL file."""
_OWN = re.compile(r"^\s*(\[\w+\]|(net|setp|addf|loadrt|loadusr|source)\s)", re.MULTILINE)
_PORT = re.compile(r"(fb-)?(in|out)(?![a-z])")


@dataclass(frozen=True)
class Line:
    """A line of a file, counted from 1."""

    file: Path
    line: int

    @property
    def place(self) -> str:
        """File and line, as ``machine.hal:12``."""
        return f"{self.file.name}:{self.line}"


@dataclass(frozen=True)
class Entry(Line):
    """A value."""

    value: str


@dataclass(frozen=True, eq=False)
class Ini:
    """An INI file: values by section and key, in order."""

    file: Path
    values: Mapping[tuple[str, str], list[Entry]]

    def first(self, section: str, *keys: str) -> Entry | None:
        """Return the first value of the first key that the section has."""
        return next((self.values[section, key][0] for key in keys if (section, key) in self.values), None)

    def referred(self, match: re.Match[str] | None) -> Entry | None:
        """Return the value that a match of `REFERENCE` refers to."""
        return None if match is None else self.first(match[1], match[2] or match[3])

    def number(self, section: str, key: str, above: float = -LARGEST) -> float | None:
        """Return the first value as a number above a limit; None if there is none."""
        entry = self.first(section, key)
        if entry is None:
            return None
        try:
            value = float(entry.value)
        except ValueError:
            value = math.nan
        if not above < value < LARGEST:
            wanted = "a number" if above else "a number above 0"
            raise ScenarioError(f"[{section}]{key} = {entry.value!r}: must be {wanted}, below {LARGEST:g}", file=entry.place)
        return value


@dataclass(frozen=True)
class Statement(Line):
    """The words of a HAL statement; in `words` references to the INI file are replaced."""

    written: tuple[str, ...]
    words: tuple[str, ...]

    def entry(self, number: int) -> Entry:
        """Return a word as a value of the file."""
        return Entry(self.file, self.line, self.words[number])


@dataclass(frozen=True, eq=False)
class HalGraph:
    """What HAL files load, set and connect.

    Attributes
    ----------
    statements : tuple of Statement
        In LinuxCNC's order.
    kinds : dict of str to str
        Components by name, as ``pid.x`` or ``scale.0``, and the module each is of.
    signal_of : dict of str to str
        Signal of each connected pin.
    pins : dict of str to list of str
        Pins of each signal.
    settings : dict of str to Statement
        Last ``setp`` of each pin and parameter.
    functions : list of str
        In the order in which they were added to threads.
    unread : tuple of Entry
        Files that were named but not read: Tcl scripts, and those that are absent.
    """

    statements: tuple[Statement, ...]
    kinds: dict[str, str] = field(default_factory=dict)
    signal_of: dict[str, str] = field(default_factory=dict)
    pins: dict[str, list[str]] = field(default_factory=dict)
    settings: dict[str, Statement] = field(default_factory=dict)
    functions: list[str] = field(default_factory=list)
    unread: tuple[Entry, ...] = ()

    def number(self, pin: str) -> float:
        """Return what a pin or parameter is set to; 0 if it is not set.

        Raises
        ------
        ScenarioError
            If it is no number.
        """
        if pin not in self.settings:
            return 0.0
        statement = self.settings[pin]
        try:
            return float(statement.words[2])
        except ValueError as error:
            missing = ": the INI file does not have it" if statement.words[2].startswith("[") else ""
            raise ScenarioError(f"{' '.join(statement.words[:3])}{missing}: must be a number", file=statement.place) from error

    def true(self, pin: str) -> bool:
        """Return whether a pin is set to true."""
        return pin in self.settings and self.settings[pin].words[2].lower() in ("1", "true", "yes")

    def kind(self, pin: str) -> str:
        """Return the module of a pin's component; by its usual name where its ``loadrt`` was not read."""
        owner = self.owner(pin)
        return self.kinds.get(owner) or re.sub(r"[.-]?\d+$", "", owner).replace("-", "_")

    def owner(self, pin: str) -> str:
        """Return the component of a pin."""
        parts = pin.split(".")[:-1]
        names = (".".join(parts[:n]) for n in range(len(parts), 0, -1))
        return next((name for name in names if name in self.kinds), ".".join(parts))

    def sinks(self, pin: str) -> list[str]:
        """Return the pins that read an output, through components that pass it on."""
        return [other for group in self._reached(pin, "in", "out") for other in group]

    def sources(self, pin: str) -> list[list[str]]:
        """Return for each signal that an input comes from, through components that pass it on, its pins: one of them writes it."""
        return self._reached(pin, "out", "in")

    def _reached(self, pin: str, enters: str, leaves: str) -> list[list[str]]:
        groups, seen, left = list[list[str]](), {pin}, [pin]
        while left:
            signal = self.signal_of.get(left.pop(), "")
            others = [other for other in self.pins.get(signal, ()) if other not in seen]
            ports = {other: port for other in others if (port := self._port(other))}
            entered = [(self.owner(other), port[1] or "") for other, port in ports.items() if port[2] == enters]
            through = [other for owner, side in entered for other in self.signal_of if other.startswith(f"{owner}.{side}{leaves}")]
            left += [other for other in through if other not in seen]
            seen.update(others, through)
            ends = [other for other in others if other not in ports]
            # A signal has one writer: where that passes a value on, the other pins read.
            if ends and (enters == "in" or not through):
                groups.append(ends)
        return groups

    def _port(self, pin: str) -> re.Match[str] | None:
        """Return side and way of an input or output of a component that passes a value on."""
        return _PORT.match(pin[len(self.owner(pin)) + 1 :]) if PASSING.fullmatch(self.kind(pin)) else None


def read_ini(file: str | Path) -> Ini:
    """Read an INI file.

    Raises
    ------
    ScenarioError
        If it cannot be read.
    """
    path = Path(file)
    values: dict[tuple[str, str], list[Entry]] = {}
    section = ""
    for number, line in enumerate(_text(path).splitlines(), start=1):
        bare = line.strip()
        if bare.startswith("[") and "]" in bare:
            section = bare[1 : bare.index("]")]
        elif "=" in bare and not bare.startswith(("#", ";")):
            key, _, value = bare.partition("=")
            values.setdefault((section, key.strip()), []).append(Entry(path, number, re.split(r"\s[#;]", value)[0].strip()))
    return Ini(path, values)


def _text(path: Path) -> str:
    kinds = ["a file of LinuxCNC"]
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise ScenarioError(mistaken(path, *kinds) or error.strerror or "cannot be read", file=path) from error
    # Lines of G-code may stand in an INI file, and a pin may be named as a word of it.
    if words := mistaken(path, *kinds, *(["a part program"] if _OWN.search(text) else [])):
        raise ScenarioError(words, file=path)
    return text


def read_hal(file: str | Path, ini: Ini) -> Iterator[Statement]:
    """Yield the statements of a HAL file, in place of ``source`` those of the file that it names.

    Raises
    ------
    ScenarioError
        If it cannot be read.
    """
    path, held = Path(file), ""
    text = "" if path.is_file() and not path.stat().st_size else _text(path)
    for number, line in enumerate(text.splitlines(), start=1):
        bare = held + line.split("#", 1)[0].strip()
        held = ""
        if bare.endswith("\\"):
            held = bare[:-1] + " "
            continue
        yield from _statement(Entry(path, number, bare), ini)


def _statement(entry: Entry, ini: Ini) -> Iterator[Statement]:
    def value(match: re.Match[str]) -> str:
        referred = ini.referred(match)
        return match[0] if referred is None else referred.value

    if written := tuple(re.sub("<=>|=>|<=", " ", entry.value).split()):
        yield Statement(entry.file, entry.line, written, tuple(REFERENCE.sub(value, word) for word in written))


def _located(entry: Entry, ini: Ini) -> Path | None:
    name = entry.value.partition(" ")[0].removeprefix("LIB:")  # a Tcl script may have arguments
    places = (folder / name for folder in (ini.file.parent, LIBRARY))
    return None if name.endswith(".tcl") else next((place for place in places if place.is_file()), None)


def read_graph(ini: Ini, files: Sequence[Path], unread: Sequence[Entry] = ()) -> HalGraph:
    """Return what HAL files and the ``HALCMD`` lines of an INI file load, set and connect.

    Raises
    ------
    ScenarioError
        If a file cannot be read, or a number of channels is none.
    """
    absent, statements = list(unread), list[Statement]()
    open_ = [statement for file in files for statement in read_hal(file, ini)]
    open_ += [statement for entry in ini.values.get(("HAL", "HALCMD"), []) for statement in _statement(entry, ini)]
    read = {file.resolve() for file in files}
    while open_:
        statement = open_.pop(0)
        if statement.words[0] != "source" or len(statement.words) < 2:
            statements.append(statement)
            continue
        entry = statement.entry(1)
        path = _located(entry, ini)
        if path is None:
            absent.append(entry)
        elif path.resolve() not in read:
            read.add(path.resolve())
            open_ = [*read_hal(path, ini), *open_]
    graph = HalGraph(tuple(statements), unread=tuple(absent))
    for statement in statements:
        _add(graph, statement)
    return graph


def _add(graph: HalGraph, statement: Statement) -> None:
    """Add what a statement loads, sets or connects."""
    command, words = statement.words[0], statement.words[1:]
    if command in ("net", "linksp", "linkps", "linkpp") and len(words) > 1:
        signal, pins = (words[1], words[:1]) if command == "linkps" else (words[0], words if command == "linkpp" else words[1:])
        for pin in pins:
            graph.signal_of[pin] = signal
            graph.pins.setdefault(signal, []).append(pin)
    elif command == "unlinkp" and words and words[0] in graph.signal_of:
        signal = graph.signal_of.pop(words[0])
        graph.pins[signal] = [pin for pin in graph.pins[signal] if pin != words[0]]
    elif command == "setp" and len(words) == 2:
        graph.settings[words[0]] = statement
    elif command == "addf" and words:
        graph.functions.append(words[0])
    elif command == "loadrt" and words:
        before = sum(kind == words[0] for kind in graph.kinds.values())
        graph.kinds.update(dict.fromkeys(_channels(statement, words, before), words[0]))


def _channels(statement: Statement, words: tuple[str, ...], before: int) -> list[str]:
    """Return the names of the components that a ``loadrt`` adds to those before."""
    options = dict(word.partition("=")[::2] for word in words[1:])
    if "names" in options:
        return options["names"].split(",")
    base = words[0].removeprefix("at_").replace("_", "-")
    count = options.get("num_chan", options.get("count", "3" if base == "pid" else "1"))
    size = int(count) if re.fullmatch(r"[0-9]{1,3}", count) else 0
    if not size and base == "pid":
        raise ScenarioError(f"loadrt pid num_chan={count}: must be a whole number from 1 to 999", file=statement.place)
    return [f"{base}.{n}" for n in range(before, before + size)]


# --- what a pid closes its loop on ------------------------------------------------------------------------------------------------

Loop = Literal["servo", "step generator", "velocity drive", "unknown"]
_STEPS = re.compile(r"step[-_]?(gen|dir|per)|pluto.step|freqgen|(remora|rio)\.joint\.")
_SINKS: tuple[tuple[re.Pattern[str], Loop, str], ...] = (
    (_STEPS, "step generator", ""),
    (
        re.compile(r"pwm|dac|dcmotor|analog|aout|7i77|7i83", re.IGNORECASE),
        "unknown",
        "an analogue or PWM output: the drive behind it may take torque or velocity",
    ),
    (re.compile(r"8i20.*current|(lcec|cia402|ethercat).*(torque|current)"), "servo", "a torque or current"),
    (re.compile(r"(lcec|cia402|ethercat).*[._-](velo?|velocity|speed|rpm)\b|sim.encoder.*speed"), "velocity drive", "a velocity"),
)
"""What takes the output, by module and pin, and what that says of the loop."""
_ENCODERS = re.compile(r"enc|resolver|\b(ssi|biss|fabs|lcec|cia402|ethercat)\b")
_READERS = re.compile(r"^(sampler|pyvcp|gladevcp|qtvcp|halui|axisui|ddt|wcomp|joint\.\d+|axis\.\d+)\.")
"""Pins that watch a signal."""


@dataclass(frozen=True)
class LoopClass:
    """What an axis' pid closes its loop on, and why it is thought so.

    Attributes
    ----------
    loop : str
        "servo" for torque or current; "step generator" where only its own counter is in the loop; "velocity drive"; or "unknown".
    why : str
    """

    loop: Loop
    why: str


def classified(graph: HalGraph, pid: str) -> LoopClass:
    """Return the class of a pid, from its output to what takes it and from its feedback to where it comes from."""
    pins, goes = graph.sinks(f"{pid}.output"), f"{pid}.output goes to"
    forms = [(pin, loop, words) for pin in pins for form, loop, words in _SINKS if form.search(f"{graph.kind(pin)} {pin}")]
    taken = {words: (pin, loop) for pin, loop, words in reversed(forms)}
    if not taken:
        unread, others = ", ".join(entry.value for entry in graph.unread), [pin for pin in pins if not _READERS.search(pin)]
        unsure = f"{', '.join(others)}: whether that takes torque or velocity is not known"
        where = unsure if others else "no pin in the files that were read"
        return LoopClass("unknown", f"{goes} {where}; not read: {unread}" if unread else f"{goes} {where}")
    if len(taken) > 1:
        return LoopClass("unknown", f"{goes} {' and '.join(pin for pin, _ in taken.values())}, which are not of one kind")
    ((words, (sink, loop)),) = taken.items()
    if loop != "step generator":
        return LoopClass(loop, f"{goes} {sink}, {words}")
    feedback, source = _feedback(graph, pid)
    ways = f"{goes} {sink}, a step generator, and {pid}.feedback comes from {source}"
    if feedback == "steps":
        return LoopClass("step generator", f"{ways}, the count of its own steps: nothing of the machine is in the loop")
    if feedback == "unseen" or sink.startswith("ppmc."):
        return LoopClass("unknown", f"{ways}, which {'is not known here' if feedback == 'unseen' else 'may count these steps'}")
    return LoopClass("velocity drive", ways)


def _feedback(graph: HalGraph, pid: str) -> tuple[str, str]:
    """Return what a feedback is, one of steps, encoder and unseen, and its pin."""
    sources = dict[str, str]()
    for group in graph.sources(f"{pid}.feedback"):
        others = [pin for pin in group if not _READERS.search(pin) and not pin.endswith("-cmd")]
        encoders = [pin for pin in others if _ENCODERS.search(f"{graph.kind(pin)} {pin}")]
        steps = [pin for pin in others if _STEPS.search(pin) and pin not in encoders]
        by_kind = {"steps": steps, "encoder": encoders, "unseen": others}
        sources |= dict([(kind, pins[0]) for kind, pins in by_kind.items() if pins][:1])
    if len(sources) == 1:
        return next(iter(sources.items()))
    return "unseen", " and ".join(sources.values()) or "no pin in the files that were read"


# --- the axes of a machine --------------------------------------------------------------------------------------------------------

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

    def row(self, unit: float) -> Array:
        """Return the gains (7,) per metre, in the order of `loop.GAINS`."""
        return np.array([self.gains[name] / unit for name in GAINS])

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
    entries = [entry for key in ("HALFILE", "POSTGUI_HALFILE") for entry in ini.values.get(("HAL", key), []) if entry.value]
    named = [(entry, _located(entry, ini)) for entry in entries]  # in LinuxCNC's order
    paths = [path for _, path in named if path is not None]
    # A file that the INI file does not name is a copy: it holds in place of those that it does.
    if given.resolve() in [path.resolve() for path in paths]:
        graph = read_graph(ini, paths, [entry for entry, path in named if path is None])
    else:
        graph = read_graph(ini, [given])
    findings = [finding("CL866", entry.place, file=entry.value) for entry in graph.unread]
    unit_entry = ini.first("TRAJ", "LINEAR_UNITS")
    unit = LENGTHS.get(unit_entry.value.lower()) if unit_entry else None
    if unit is None:
        findings.append(finding("CL850", unit_entry.place if unit_entry else ini.file.name))
        unit = LENGTHS["mm"]
    period_ns = ini.number("EMCMOT", "SERVO_PERIOD", 0.0)
    findings += [finding("CL851", ini.file.name)] if period_ns is None else []
    period = (period_ns or 1e6) * 1e-9
    axes = tuple(_Wiring(ini, given, graph, findings).axes())
    if not axes:
        raise ScenarioError("no linear joint has a pid on its motor-pos-cmd: a servo loop in HAL is needed", file=given.name)
    findings += [doubt for axis in axes for doubt in _doubtful(axis, unit, period)]
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


@dataclass(frozen=True, eq=False)
class _Wiring:
    """The pid of each axis in the graph, and what is unusual about it."""

    ini: Ini
    file: Path
    graph: HalGraph
    findings: list[Finding]

    def letters(self) -> list[str]:
        """Return the axis letter of each joint."""
        kinematics = self.ini.first("KINS", "KINEMATICS")
        given = re.search(r"coordinates=([A-Za-z]+)", kinematics.value) if kinematics else None
        traj = self.ini.first("TRAJ", "COORDINATES")
        return list((given[1] if given else traj.value.replace(" ", "") if traj else "XYZABCUVW").lower())

    def axes(self) -> Iterator[AxisSetup]:
        """Yield the axes with a pid; note those without."""
        signal_of, used = self.graph.signal_of, set()
        channels = [name for name, kind in self.graph.kinds.items() if kind in ("pid", "at_pid")]
        by_signal = {signal_of[pin]: name for name in channels if (pin := f"{name}.command") in signal_of}
        for joint, letter in enumerate(self.letters()):
            pin = next((pin for pin in (f"joint.{joint}.motor-pos-cmd", f"axis.{joint}.motor-pos-cmd") if pin in signal_of), "")
            name, kind = by_signal.get(signal_of.get(pin, "")), self.ini.first(f"JOINT_{joint}", "TYPE")
            if name is None:
                self.findings.append(finding("CL852", f"axis {letter}", joint=joint))
            elif kind is not None and kind.value.upper() == "ANGULAR":
                self.findings.append(finding("CL863", f"axis {letter}", joint=joint))
            elif letter in used:
                self.findings.append(finding("CL853", f"joint {joint}", axis=letter))
            else:
                used.add(letter)
                yield self._axis(letter, joint, name)

    def _axis(self, letter: str, joint: int, name: str) -> AxisSetup:
        graph, places = self.graph, {}
        gains = dict.fromkeys(GAINS, 0.0) | {"Pgain": 1.0}  # as pid starts
        for gain in GAINS:
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
