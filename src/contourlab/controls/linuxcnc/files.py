"""INI and HAL files of LinuxCNC: what they set, load and connect."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from contourlab.controls.contract import LARGEST
from contourlab.errors import ScenarioError
from contourlab.file_kinds import mistaken
from contourlab.findings import Finding, finding

LENGTHS = {"mm": 1e-3, "metric": 1e-3, "inch": 0.0254, "in": 0.0254, "imperial": 0.0254}
"""LINEAR_UNITS in metres."""
LIBRARY = Path("/usr/share/linuxcnc/hallib")
"""Where LinuxCNC finds HAL files that are not beside the INI file."""
PASSING = re.compile(
    r"abs|biquad|blend|conv_(float|s32|u32)_(float|s32|u32)|deadzone|feedcomp|i?lowpass|invert|limit[123]|lincurve|mult2"
    r"|mux(2|4|8|16|_gen|_generic)|offset|sample_hold|scale|sum2|tristate_float|weighted_sum"
)
"""Components whose outputs follow their inputs."""
DEEPEST = 16
"""Most files that ``#INCLUDE`` nests, as in LinuxCNC."""
REFERENCE = re.compile(r"\[(\w+)\](?:\((\w+)\)|(\w+))")
"""A key of the INI file in a HAL file."""
_OWN = re.compile(r"^\s*(\[\w+\]|(net|setp|addf|loadrt|loadusr|source)\s)", re.MULTILINE)
_NOTHING = re.compile(r"[-+]?(0+\.?0*|\.0+)([eE].*)?")
_UNREADABLE = re.compile(r"[\0-\x08\x0e-\x19]")
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

    def number(self, section: str, key: str, *, positive: bool = False) -> float | None:
        """Return the first value as a number; None where there is none, and for one that stands for no limit."""
        entry = self.first(section, key)
        if entry is None:
            return None
        try:
            value = float(entry.value)
        except ValueError:
            value = math.nan
        if math.isnan(value) or (positive and value <= 0.0):
            raise ScenarioError(f"[{section}]{key} = {entry.value!r}: must be a number" + " above 0" * positive, file=entry.place)
        return value if abs(value) < LARGEST else None


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


def beside(file: Path, name: str) -> Path:
    """Return the path that a file names."""
    return file.parent / os.path.expanduser(name)  # noqa: PTH111  # that of Path raises where there is no such user


def read_ini(file: str | Path) -> Ini:
    """Read an INI file, in place of ``#INCLUDE`` the file that it names.

    Raises
    ------
    ScenarioError
        If one cannot be read, or they include each other.
    """
    path = Path(file)
    values: dict[tuple[str, str], list[Entry]] = {}
    section = ""
    for at, line in _ini_lines(path, 0):
        bare = line.strip()
        if bare.startswith("[") and "]" in bare:
            section = bare[1 : bare.index("]")]
        elif "=" in bare and not bare.startswith(("#", ";")):
            key, _, value = bare.partition("=")
            values.setdefault((section, key.strip()), []).append(Entry(at.file, at.line, re.split(r"\s[#;]", value)[0].strip()))
    return Ini(path, values)


def _ini_lines(path: Path, depth: int) -> Iterator[tuple[Line, str]]:
    for number, line in enumerate(_text(path).splitlines(), start=1):
        place = Line(path, number)
        if not (included := re.match(r"#INCLUDE\s+(\S+)", line)):
            yield place, line
        elif depth == DEEPEST:
            raise ScenarioError(f"#INCLUDE {included[1]}: files include each other, or more than {DEEPEST} deep", file=place.place)
        elif not (file := beside(path, included[1])).is_file():
            raise ScenarioError(f"#INCLUDE {included[1]}: there is no such file", file=place.place)
        else:
            yield from _ini_lines(file, depth + 1)


def _text(path: Path) -> str:
    kinds = ["a file of LinuxCNC"]
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise ScenarioError(mistaken(path, *kinds) or error.strerror or "cannot be read", file=path) from error
    # Lines of G-code may stand in an INI file, and a pin may be named as a word of it.
    if words := mistaken(path, *kinds, *(["a part program"] if _OWN.search(text) else [])):
        raise ScenarioError(words, file=path)
    if _UNREADABLE.search(text):
        raise ScenarioError("is no text", file=path)
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


def graph_of(ini: Ini, copy: Path | None = None) -> tuple[HalGraph, list[Path]]:
    """Return what all HAL files that an INI file names load, set and connect, and the files; raises as `read_graph`.

    A copy, a file that the INI file does not name, holds in place of those that it does.
    """
    entries = [entry for key in ("HALFILE", "POSTGUI_HALFILE") for entry in ini.values.get(("HAL", key), []) if entry.value]
    located = [(entry, _located(entry, ini)) for entry in entries]
    files = [path for _, path in located if path is not None]
    if copy is not None and copy.resolve() not in [path.resolve() for path in files]:
        return read_graph(ini, [copy]), [copy]
    return read_graph(ini, files, [entry for entry, path in located if path is None]), files


def sampler_lines(sources: Sequence[str], kinds: str) -> list[str]:
    """Return HAL lines that record signals, or new signals and their pins, at each servo period; `kinds` are f, s and b, as in its cfg."""
    nets = (f"net {source} => sampler.0.pin.{k}" for k, source in enumerate(sources))
    return [f"loadrt sampler depth=16000 cfg={kinds}", "addf sampler.0 servo-thread", *nets]


def units_of(ini: Ini, graph: HalGraph) -> tuple[float, float, list[Finding]]:
    """Return the length of a machine unit [m], the servo period [s], and a finding for each file not read and each figure assumed."""
    entry, period = ini.first("TRAJ", "LINEAR_UNITS"), ini.number("EMCMOT", "SERVO_PERIOD", positive=True)
    if period is None and (given := ini.first("EMCMOT", "SERVO_PERIOD")):
        raise ScenarioError(f"SERVO_PERIOD = {given.value}: write it in ns, such as 1000000", file=given.place)
    for (section, key), (given, *_) in ini.values.items():
        if key.endswith("SCALE") and section.startswith(("JOINT_", "AXIS_")) and _NOTHING.fullmatch(given.value):
            raise ScenarioError(f"[{section}]{key} = {given.value}: must not be 0", file=given.place)
    unit = LENGTHS.get(entry.value.lower()) if entry else None
    findings = [finding("CL866", other.place, file=other.value) for other in graph.unread]
    findings += [finding("CL850", entry.place if entry else ini.file.name)] if unit is None else []
    findings += [finding("CL851", ini.file.name)] if period is None else []
    return unit or LENGTHS["mm"], (period or 1e6) * 1e-9, findings


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
    absent, read = list(unread), {file.resolve() for file in files}

    def sourced(lines: Iterable[Statement], *above: Path) -> Iterator[Statement]:
        for statement in lines:
            if statement.words[0] != "source" or len(statement.words) < 2:
                yield statement
                continue
            entry = statement.entry(1)
            path = _located(entry, ini)
            if path is None:
                absent.append(entry)
            elif (file := path.resolve()) in above:
                raise ScenarioError(f"source {entry.value}: files source each other", file=entry.place)
            elif file not in read:
                read.add(file)
                yield from sourced(read_hal(path, ini), *above, file)

    commands = (statement for entry in ini.values.get(("HAL", "HALCMD"), []) for statement in _statement(entry, ini))
    statements = [statement for file in files for statement in sourced(read_hal(file, ini), file.resolve())]
    graph = HalGraph((*statements, *sourced(commands)), unread=tuple(absent))
    for statement in graph.statements:
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
