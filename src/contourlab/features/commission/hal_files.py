"""INI and HAL files of LinuxCNC: statements with their lines, and the ``pid`` of each axis with what it is wired to."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from contourlab.errors import ScenarioError
from contourlab.features.commission.loop import GAINS
from contourlab.file_kinds import mistaken
from contourlab.findings import Finding, finding

LENGTHS = {"mm": 1e-3, "metric": 1e-3, "inch": 0.0254, "in": 0.0254, "imperial": 0.0254}
"""LINEAR_UNITS in metres."""
UNUSUAL = ("deadband", "maxerror", "maxerrorI", "maxerrorD", "maxcmdD", "maxcmdDD", "maxcmdDDD")
"""Parameters of ``pid`` that the model of the loop leaves out."""
LARGEST = 1e9
"""Limit of what an INI file may say: beyond it a number stands for no limit."""
_REFERENCE = re.compile(r"\[(\w+)\](?:\((\w+)\)|(\w+))")


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
    previous_target: bool | None = None
    maxoutput: float = 0.0
    backlash: float = 0.0
    always_enabled: bool = False


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
    if words := mistaken(path, "a file of LinuxCNC"):
        raise ScenarioError(words, file=path)
    try:
        return path.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise ScenarioError(error.strerror or "cannot be read", file=path) from error


def read_hal(file: str | Path, ini: Ini) -> tuple[Statement, ...]:
    """Read the statements of a HAL file.

    Raises
    ------
    ScenarioError
        If it cannot be read.
    """
    path, statements, held = Path(file), [], ""
    for number, line in enumerate(_text(path).splitlines(), start=1):
        bare = held + line.split("#", 1)[0].strip()
        held = ""
        if bare.endswith("\\"):
            held = bare[:-1] + " "
            continue
        written = tuple(word for word in bare.replace("=>", " ").replace("<=", " ").split() if word != "<=>")
        if written:
            words = tuple(_REFERENCE.sub(lambda match: _value(ini, match), word) for word in written)
            statements.append(Statement(path, number, written, words))
    return tuple(statements)


def _value(ini: Ini, match: re.Match[str]) -> str:
    entry = ini.first(match[1], match[2] or match[3])
    return match[0] if entry is None else entry.value


def read_setup(ini_file: str | Path, hal_file: str | Path) -> Setup:
    """Read INI and HAL, with the further HAL files of an INI file that names this one, and find the pid of each axis.

    Raises
    ------
    ScenarioError
        If a file cannot be read, a number is faulty, or no axis has a pid.
    """
    ini = read_ini(ini_file)
    given, named = Path(hal_file), [ini.file.parent / entry.value for entry in ini.values.get(("HAL", "HALFILE"), [])]
    others = [file for file in named if file.is_file() and file.resolve() != given.resolve()]
    # A file that the INI file does not name is a copy: it holds in place of those that it does.
    files = [given, *others] if len(others) < sum(file.is_file() for file in named) else [given]
    statements = tuple(one for file in files for one in read_hal(file, ini))
    findings: list[Finding] = []
    unit_entry = ini.first("TRAJ", "LINEAR_UNITS")
    unit_name = unit_entry.value.lower() if unit_entry else "mm"
    if unit_entry is None or unit_name not in LENGTHS:
        findings.append(finding("CL850", unit_entry.place if unit_entry else ini.file.name))
        unit_name = "mm"
    unit = LENGTHS[unit_name]
    period_ns = ini.number("EMCMOT", "SERVO_PERIOD", 0.0)
    if period_ns is None:
        findings.append(finding("CL851", ini.file.name))
    wiring = _Wiring(ini, Path(hal_file), statements, findings)
    axes = tuple(wiring.axes())
    if not axes:
        raise ScenarioError("no linear joint has a pid on its motor-pos-cmd: a servo loop in HAL is needed", file=Path(hal_file).name)
    name = "inch" if unit == LENGTHS["inch"] else "mm"
    return Setup(ini, Path(hal_file), unit, name, (period_ns or 1e6) * 1e-9, axes, tuple(findings))


class _Wiring:
    """Signals, parameters and functions of the HAL file."""

    def __init__(self, ini: Ini, file: Path, statements: tuple[Statement, ...], findings: list[Finding]) -> None:
        self.ini, self.file, self.statements, self.findings = ini, file, statements, findings
        self.signal_of: dict[str, str] = {}
        self.pins: dict[str, list[str]] = {}
        self.set: dict[str, Statement] = {}
        self.functions: list[str] = []
        for one in statements:
            command, words = one.words[0], one.words[1:]
            if command == "net" and len(words) > 1:
                self._connect(words[0], words[1:])
            elif command in ("linksp", "linkps") and len(words) == 2:
                signal, pin = words if command == "linksp" else words[::-1]
                self._connect(signal, (pin,))
            elif command == "setp" and len(words) == 2:
                self.set[words[0]] = one
            elif command == "addf" and words:
                self.functions.append(words[0])

    def _connect(self, signal: str, pins: tuple[str, ...]) -> None:
        for pin in pins:
            self.signal_of[pin] = signal
            self.pins.setdefault(signal, []).append(pin)

    def channels(self) -> list[str]:
        """Return the names of the loaded channels of pid."""
        names: list[str] = []
        for one in self.statements:
            if one.words[:2] == ("loadrt", "pid"):
                options = dict(word.partition("=")[::2] for word in one.words[2:])
                count = options.get("num_chan", options.get("count", "3"))
                if not count.isdigit():
                    raise ScenarioError(f"loadrt pid num_chan={count}: must be a whole number", file=one.place)
                names += options["names"].split(",") if "names" in options else [f"pid.{n}" for n in range(int(count))]
        return names

    def letters(self) -> list[str]:
        """Return the axis letter of each joint."""
        kinematics = self.ini.first("KINS", "KINEMATICS")
        given = re.search(r"coordinates=([A-Za-z]+)", kinematics.value) if kinematics else None
        traj = self.ini.first("TRAJ", "COORDINATES")
        return list((given[1] if given else traj.value.replace(" ", "") if traj else "XYZABCUVW").lower())

    def axes(self) -> Iterator[AxisSetup]:
        """Yield the axes with a pid; note those without."""
        channels = self.channels()
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
        gains, places = dict.fromkeys(GAINS, 0.0), {}
        mine = [one.line for pin, one in self.set.items() if pin.startswith(f"{name}.") and one.file == self.file]
        for gain in GAINS:
            one = self.set.get(f"{name}.{gain}")
            if one is not None:
                gains[gain], places[gain] = self._number(one), self._place(one)
        self._check(letter, joint, name)
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
        reference = _REFERENCE.fullmatch(one.written[2])
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

    def _check(self, letter: str, joint: int, name: str) -> None:
        """Note what is missing or unusual in the wiring of a pid."""
        place = f"axis {letter}"
        fed = self.signal_of.get(f"{name}.feedback")
        if fed is None or self.signal_of.get(f"{name}.output") is None:
            pin = "feedback" if fed is None else "output"
            self.findings.append(finding("CL854", self.file.name, pin=f"{name}.{pin}"))
        elif not any(pin.endswith(f".{joint}.motor-pos-fb") for pin in self.pins[fed]):
            self.findings.append(finding("CL855", place, signal=fed, joint=joint))
        if f"{name}.enable" not in self.signal_of and f"{name}.enable" not in self.set:
            self.findings.append(finding("CL856", self.file.name, pin=f"{name}.enable"))
        if self._true(f"{name}.enable"):
            self.findings.append(finding("CL861", self.set[f"{name}.enable"].place, pin=f"{name}.enable"))
        calculation, controller = f"{name}.do-pid-calcs", "motion-controller"
        if calculation not in self.functions:
            self.findings.append(finding("CL857", self.file.name, function=calculation))
        elif controller in self.functions and self.functions.index(calculation) < self.functions.index(controller):
            at = next(one for one in self.statements if one.words[:2] == ("addf", calculation))
            self.findings.append(finding("CL858", at.place, function=calculation))
        for parameter in UNUSUAL:
            one = self.set.get(f"{name}.{parameter}")
            if one is not None and self._number(one) != 0.0:
                self.findings.append(finding("CL859", one.place, parameter=f"{name}.{parameter}"))
        for pin in ("command-deriv", "feedback-deriv"):
            if f"{name}.{pin}" in self.signal_of:
                self.findings.append(finding("CL860", self.file.name, pin=f"{name}.{pin}"))
