"""``contourlab commission linuxcnc``: first the program and the sampler, then from logs to the gains of each ``pid``."""

from __future__ import annotations

import base64
import difflib
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain, product
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from contourlab.app.json_values import HIDDEN, json_values
from contourlab.app.results import SAFETY, check_file, write_together
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.arrays import Array
from contourlab.controls.linuxcnc.loops import LoopClass
from contourlab.errors import ParameterError
from contourlab.features.commission.excitation import excitation, sampler, steps
from contourlab.features.commission.identification import IdentifiedAxis, identify_axis
from contourlab.features.commission.log_command import log as of_any_log
from contourlab.features.commission.loop import GAINS, robustly_stable, run_lanes
from contourlab.features.commission.options import LinuxCNC
from contourlab.features.commission.records import AxisLog, decided, doubts, law_of, moving, read_log
from contourlab.features.commission.relay_command import relay
from contourlab.features.commission.setup import AxisSetup, Setup, read_setup, row_of
from contourlab.features.commission.tuning import AxisTask, Moves, TunedAxis, largest_error, shared_delay, tune_axis
from contourlab.features.measure.log_choice import window_of
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.rendering.charts import Curve, PolarChart
from contourlab.rendering.matplotlib_view import drawing_of, picture_bytes
from contourlab.rendering.style import scheme_style
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.threads import in_threads

FIRST, SECOND = ("excite.ngc", "sampler.hal", "steps.md"), ("report.html", "gains.diff", "safe.diff", "circle.png")
OFF_RUNS = 8
"""Runs that begin with LinuxCNC off, where the log shows it."""
CIRCLE = 0.01
"""Radius of the circle in the report [m]."""
Curves: TypeAlias = Mapping[str, tuple[Array, Array]]


@dataclass(frozen=True)
class Prediction:
    """Largest |command - motor position| [um], with the present and the proposed gains; `spread` with the axis' gain a quarter off.

    A delay that all axes share is left out: it bends no path. `load` is |command - load| with the gains to use; nan if play is unknown.
    """

    before: float
    after: float
    spread: float
    load: float


@dataclass(frozen=True, eq=False)
class Commissioned(Answer):
    """What to run, or the gains of each servo loop.

    Attributes
    ----------
    axes : dict of str to LoopClass
        What each axis' pid closes its loop on, and why.
    pid, safe : dict of str to dict of str to float
        Proposed gains by axis under HAL's names, in machine units, and the first values to type in.
    predicted : dict of str to Prediction
    models : dict of str to IdentifiedAxis
    findings : tuple of Finding
    files : tuple of Path
    circle : dict of str to float [um]
        Largest radial error on the simulated circle, at the motors before and after, and at the load; empty unless x and y are known.
    answer : tuple of str
        One line for each axis.
    tables : tuple of Table
    """

    axes: dict[str, LoopClass]
    pid: dict[str, dict[str, float]]
    safe: dict[str, dict[str, float]]
    predicted: dict[str, Prediction]
    models: dict[str, IdentifiedAxis]
    findings: tuple[Finding, ...]
    files: tuple[Path, ...] = ()
    circle: dict[str, float] = field(default_factory=dict)
    answer: tuple[str, ...] = ()
    tables: tuple[Table, ...] = field(default=(), metadata=HIDDEN)
    charts: tuple[PolarChart, ...] = field(default=(), metadata=HIDDEN, repr=False)
    contents: Mapping[str, str | bytes] = field(default_factory=dict, metadata=HIDDEN, repr=False)
    inputs: tuple[str | Path, ...] = field(default=(), metadata=HIDDEN, repr=False)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """What each axis is, and its proposed gains, one axis a row."""
        return [{"axis": axis, **json_values(kind), **self.pid.get(axis, {})} for axis, kind in self.axes.items()]

    def save(self, folder: str | Path = "commissioning") -> Commissioned:
        """Write excitation, sampler and steps; or report, diffs and picture; all or none.

        Parameters
        ----------
        folder : str or Path

        Returns
        -------
        Commissioned
            With the names of its files.

        Raises
        ------
        OutputError, ParameterError
            If a file cannot be written, or would replace an input.
        """
        files = {Path(folder) / name: content for name, content in self.contents.items()}
        write_together(files, self.inputs)
        for name in SECOND[1:3] if SECOND[0] in self.contents else ():
            if name not in self.contents:
                (Path(folder) / name).unlink(missing_ok=True)  # of an earlier answer
        return replace(self, files=tuple(files))

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Log a run: of the excitation, or of the safe gains."""
        logged = bool(asked.settings.log)
        if SECOND[1] not in self.contents if logged else not self.files:
            return None
        log = "log2.txt" if logged else "log1.txt"
        return ["commission", "linuxcnc", *asked.inputs, "--log", log, "--out", asked.files.out]

    @property
    def passed(self) -> bool:
        """Whether no finding is an error."""
        return all(doubt.entry.severity != "error" for doubt in self.findings)

    @property
    def text(self) -> str:
        """Answer, tables, findings and files."""
        found, files = paragraphs(map(str, self.findings)), "\n".join(f"written: {file}" for file in self.files)
        return "\n\n".join(filter(None, [paragraphs(self.answer), *(table.text() for table in self.tables), found, files]))


@question(LinuxCNC)
def commission(ini: str | Path, hal: str | Path, *, settings: LinuxCNC, session: Session = QUIET) -> Commissioned:
    """Find the gains of each servo loop of a LinuxCNC from its files and logs; without logs, what to run.

    Parameters
    ----------
    ini, hal : str or Path
        Files of LinuxCNC, with the gains in use.

    Returns
    -------
    Commissioned

    Raises
    ------
    ScenarioError, LogError, ProgramError, FeedError
        If a file cannot be read, no axis has a pid, a travel is too short, or the program cannot be planned.
    ParameterError
        If an option is unknown.
    """
    setup, program = read_setup(ini, hal), settings.program
    inputs = (ini, hal, *settings.log, *([] if program is None else [program]))
    for name in (SECOND if settings.log else FIRST) if session.saving else ():
        check_file(session.folder / name, inputs, "--out")
    if not settings.log:
        return _prepared(setup, inputs, session)
    findings = list(setup.findings)
    records = list[dict[str, AxisLog]]()
    for number, log in enumerate(settings.log):
        record, more = read_log(log, setup, window_of(log, settings.of_log(number, len(settings.log))))
        record = {axis.name: record[axis.name] for axis in setup.closed if axis.name in record}
        findings += more
        wrong = list(doubts(record))
        findings += wrong
        bad = {doubt.place.removeprefix("axis ") for doubt in wrong}
        records.append({name: moving(axis) for name, axis in record.items() if name not in bad})
    planned = {} if program is None else planned_commands(program, setup)
    axes = {axis.name: _Axis(axis, axis.loop, row_of(axis.gains, setup.unit)) for axis in setup.axes}
    work = _Work(setup, records, planned, settings, axes)
    if all(doubt.code != "CL871" for doubt in findings):
        session.stages().begin("identifying and tuning the axes")
        findings += chain.from_iterable(in_threads(work.identify, [work.axes[axis.name] for axis in setup.closed]))
        findings += work.compared()
    return _answered(work, findings, inputs)


for _member in (of_any_log, relay):
    setattr(commission, _member.__name__, _member)


def _prepared(setup: Setup, inputs: tuple[str | Path, ...], session: Session) -> Commissioned:
    """Return the excitation, the lines of the sampler, and the steps, if an axis can be commissioned and none has a pid without gains."""
    axes = {axis.name: axis.loop for axis in setup.axes}
    answer = tuple(f"{name}: {axis.loop}: {axis.why}." for name, axis in axes.items())
    contents: dict[str, str | bytes] = {}
    if setup.closed and not any(axis.idle for axis in setup.axes):
        folder = session.folder if session.saving else Path("commissioning")
        contents = dict(zip(FIRST, (excitation(setup), sampler(setup), steps(setup, folder)), strict=True))
    return Commissioned(axes, {}, {}, {}, {}, setup.findings, answer=answer, contents=contents, inputs=inputs)


@dataclass(eq=False)
class _Axis:
    """What is known of an axis so far; gains in use are per metre."""

    setup: AxisSetup
    loop: LoopClass
    present: Array
    identified: IdentifiedAxis | None = None
    task: AxisTask | None = None
    before: Moves = ()
    tuned: TunedAxis | None = None
    predicted: Prediction | None = None

    def gains(self, unit: float, share: float = 1.0) -> dict[str, float]:
        """Return the gains in machine units: the present ones, or a share of the way from there to the tuned ones."""
        if self.tuned is None:
            return dict(self.setup.gains)
        mixed = (self.present + share * (self.tuned.gains - self.present)) * unit
        return self.setup.gains | {name: float(f"{value:.6g}") for name, value in zip(GAINS, mixed.tolist(), strict=True)}

    def load_error(self, delay: float, period: float) -> float:
        """Return the largest |command - load| [m] with the gains to use, without a delay; nan if nothing is known of the load."""
        if self.task is None or self.identified is None:
            return math.nan
        gains = self.present if self.tuned is None else self.tuned.gains
        loads = [(command, self.identified.load(run)) for command, run in self.task.traced(gains)]
        return largest_error(loads, delay, period)

    def line(self, gains: Mapping[str, float]) -> str:
        """Return the answer in one line."""
        name, predicted, model = self.setup.name, self.predicted, self.identified
        if predicted is None or model is None:
            return f"No gains for {name}, {self.loop.loop}: the findings say why."
        short = {"Pgain": "P", "Igain": "I", "Dgain": "D"}
        listed = ", ".join(f"{short.get(gain, gain)} {text_of(float(f'{value:.3g}'))}" for gain, value in gains.items() if value)
        before, after = (figure(1e-6 * value, "um") for value in (predicted.before, predicted.after))
        change = f"largest error {before} -> about {after}" if self.tuned else f"these gains stay, largest error {before}"
        play, deviation = figure(model.play, "um", 2).removesuffix(" um"), figure(model.play_deviation, "um", 1)
        remains = f"; play of {play} +-{deviation} remains" if math.isfinite(model.play) else ""
        remains += f", about {figure(1e-6 * predicted.load, 'um')} at the load" if math.isfinite(predicted.load) else ""
        return f"{listed} for {name}: {change}{remains}"


def _usable(found: IdentifiedAxis | Finding) -> bool:
    return isinstance(found, IdentifiedAxis) and found.usable


@dataclass(frozen=True, eq=False)
class _Work:
    """The axes, their logs, and the commands of a program, by axis."""

    setup: Setup
    records: Sequence[Mapping[str, AxisLog]]
    planned: Mapping[str, Array]
    settings: LinuxCNC
    axes: dict[str, _Axis]

    def identify(self, axis: _Axis) -> list[Finding]:
        """Identify and tune an axis; return the findings."""
        name, unit = axis.setup.name, self.setup.unit
        logs = [record[name] for record in self.records if name in record]
        if not logs:
            return []
        place, checked = f"axis {name}", [law_of(log, axis.setup, unit) for log in logs]
        findings = list({str(doubt): doubt for _, more in checked for doubt in more}.values())
        findings += [finding("CL899", place, backlash=axis.setup.backlash * unit)] if axis.setup.backlash else []
        if any(doubt.entry.severity == "error" for doubt in findings):
            return findings
        said = self.settings.drive
        given = LoopClass("velocity drive" if said == "velocity" else "servo", f"--drive {said} says so") if said else axis.loop
        signals = [(log.output, log.measured) for log in logs]
        shown = decided(signals, self.setup.period, unit, given.loop)
        axis.loop = (given.loop == "unknown" and shown) or given
        velocity = axis.loop.loop == "velocity drive"
        if shown and shown.loop != axis.loop.loop and (said or velocity):
            return [*findings, finding("CL869", place, given=given.why, why=shown.why)]
        identified = identify_axis(logs, axis.present, checked[0][0], velocity=velocity)
        if not velocity and not _usable(identified) and decided(signals, self.setup.period, unit, "velocity drive") != shown:
            other = identify_axis(logs, axis.present, checked[0][0], velocity=True)  # its loop may have what no torque explains
            if _usable(other):
                why = "the log fits no torque, but a velocity"
                if given.loop != "unknown":
                    return [*findings, finding("CL869", place, given=given.why, why=why)]
                identified, velocity, axis.loop = other, True, LoopClass("velocity drive", why)
        if isinstance(identified, Finding):
            return [*findings, identified]
        axis.identified = identified
        whys = dict.fromkeys(one.why for one in (axis.loop, shown) if one and one.loop == "velocity drive")
        findings += [finding("CL868", place, why="; ".join([*whys, identified.answers(unit)]))] if velocity else []
        tuned = not identified.usable or self._tune(axis, logs, identified)
        return [*findings, *identified.findings, *([] if tuned else [finding("CL897", place)])]

    def _tune(self, axis: _Axis, logs: Sequence[AxisLog], identified: IdentifiedAxis) -> bool:
        """Tune an axis; return whether that shrinks its largest error."""
        law, seed, setup = identified.law, self.settings.seed, axis.setup
        commands = [self.planned[setup.name]] if setup.name in self.planned else []
        if not any(np.ptp(command) > 0.0 for command in commands):  # no program, or it does not move this axis
            commands = [log.command for log in logs]
        pairs = [(command, identified.noise_like(command, seed + k)) for k, command in enumerate(commands)]
        free = max(log.free for log in logs) if setup.always_enabled else 0
        off = [identified.noise_like(np.zeros(free + 300), seed + 100 + k) for k in range(OFF_RUNS if free else 0)]
        margins = self.settings.gain_margin, self.settings.phase_margin
        axis.task = task = AxisTask(identified.model, law, pairs, off, free, setup.always_enabled, *margins)
        axis.before = task.runs(axis.present) if self.planned else [(log.command, log.measured) for log in logs]
        try:
            tuned = tune_axis(task, unit=self.setup.unit, seed=seed)
        except ParameterError:
            return False
        before = task.largest(axis.present) if self.planned else largest_error(axis.before, 0.0, law.period)
        axis.tuned = tuned if tuned.largest < before else None
        return axis.tuned is not None

    def compared(self) -> list[Finding]:
        """Predict all errors without the delay that the axes share; new gains hold only if they shrink the sum."""
        moved = {name: axis for name, axis in self.axes.items() if axis.task is not None}
        (_, before), (delay, after) = self._errors(moved, tuned=False), self._errors(moved, tuned=True)
        findings, tuned = list[Finding](), [axis for axis in moved.values() if axis.tuned]
        if tuned and not sum(after.values()) < sum(before.values()):
            findings, (delay, after) = [finding("CL897", f"axis {axis.setup.name}") for axis in tuned], self._errors(moved, tuned=False)
            for axis in tuned:
                axis.tuned = None
        for name, axis in moved.items():
            spread = axis.tuned.spread if axis.tuned else math.nan
            load = axis.load_error(delay, self.setup.period)
            axis.predicted = Prediction(1e6 * before[name], 1e6 * after[name], 1e6 * spread, 1e6 * load)
            noise = 3.0 * axis.identified.noise if axis.identified else 0.0
            findings += [finding("CL891", f"axis {name}", noise=noise)] if axis.tuned and noise > 0.3 * after[name] else []
            findings += [finding("CL898", f"axis {name}", error=spread)] if spread > 0.5 * before[name] else []
        return findings

    def _errors(self, moved: Mapping[str, _Axis], *, tuned: bool) -> tuple[float, dict[str, float]]:
        """Return the delay [s] that all axes share, and the largest error [m] of each without it, with tuned gains or else those in use."""
        chosen = {name: (axis.task, axis.tuned.gains) for name, axis in moved.items() if tuned and axis.task and axis.tuned}
        moves = {name: axis.before for name, axis in moved.items()} | {name: task.runs(gains) for name, (task, gains) in chosen.items()}
        period = self.setup.period
        delay = shared_delay(list(moves.values()), period) if len(moves) == len(self.setup.axes) else 0.0
        errors = {name: largest_error(runs, delay, period) for name, runs in moves.items()}
        for name, (task, gains) in chosen.items():
            errors[name] = max(errors[name], float(task.switched_on(gains[None], task.model)[0]))
        return delay, errors

    def safe(self, known: Mapping[str, IdentifiedAxis]) -> dict[str, dict[str, float]]:
        """Return the first gains to type in: half the way, or less where the loop would not be stable there."""
        chosen = {}
        for share, (name, model) in product((0.1, 0.25, 0.5), known.items()):
            gains = self.axes[name].gains(self.setup.unit, share)
            if robustly_stable(row_of(gains, self.setup.unit)[None], model.model, model.law.period)[0]:
                chosen[name] = gains
        return chosen


def _answered(work: _Work, findings: Sequence[Finding], inputs: tuple[str | Path, ...]) -> Commissioned:
    """Return the answer, with the contents of its files."""
    setup, program = work.setup, work.settings.program
    models = {name: axis.identified for name, axis in work.axes.items() if axis.identified is not None}
    known = {name: model for name, model in models.items() if model.usable}
    gains, safe = {name: work.axes[name].gains(setup.unit) for name in known}, work.safe(known)
    rows = {name: row_of(values, setup.unit) for name, values in gains.items()}
    answer = tuple(axis.line(gains.get(name, {})) for name, axis in work.axes.items())
    silent = [name for name in work.axes if name not in gains]
    findings = [*findings, finding("CL867", setup.ini.file.name, axes=silent)] if silent else findings
    present = {axis.name: axis.gains for axis in setup.axes if axis.name in gains}
    table = gain_table(setup.axes, {"present": present, "safe first": safe, "proposed": gains})
    diff, circle = "" if silent else changes(setup, gains), circle_errors(work, rows)
    charts = tuple(circle_charts(circle))
    picture = picture_bytes(lambda: drawing_of(charts, 4.2), "png") if charts else []
    report, gain_diff, safe_diff, image = SECOND
    title = f"Commissioning of {setup.ini.file.name}" + ("" if program is None else f" for {program.name}")
    contents: dict[str, str | bytes] = {report: page(title, answer, table, diff, picture, findings)}
    contents |= {} if silent else {gain_diff: diff, safe_diff: changes(setup, safe)}
    contents |= dict(zip([image], picture, strict=False))
    return Commissioned(
        {name: axis.loop for name, axis in work.axes.items()},
        gains,
        safe,
        {name: axis.predicted for name, axis in work.axes.items() if axis.predicted is not None},
        models,
        tuple(findings),
        circle={name: 1e6 * float(np.abs(error).max()) for name, (_, error) in circle.items()},
        answer=answer,
        tables=(table,) if table.rows else (),
        charts=charts,
        contents=contents,
        inputs=inputs,
    )


def planned_commands(program: Path, setup: Setup) -> dict[str, Array]:
    """Return the commands of each axis in a part program at the servo period, planned as LinuxCNC does: without a limit of jerk.

    Raises
    ------
    ProgramError, FeedError
        If the program cannot be read or planned.
    """
    from contourlab.feed import AxisLimits
    from contourlab.program import Arc, Dwell, Reading, read_program
    from contourlab.scenario.values import program_motion

    made = read_program(program, reading=Reading(require_end=False))
    keys = {"velocity": "MAX_VELOCITY", "acceleration": "MAX_ACCELERATION"}
    found: dict[str, Mapping[str, float | None]]
    found = {a: {name: setup.ini.number(f"AXIS_{a.upper()}", key) for name, key in keys.items()} for a in "xyz"}
    found |= {axis.name: axis.limits for axis in setup.axes if axis.name in found}
    known = {a: [values[name] for name in keys] for a, values in found.items() if None not in values.values()}
    letters, pairs = list(known), np.array(list(known.values()), dtype=float) * setup.unit
    # LinuxCNC speeds up along an arc with half the acceleration.
    straight = [any(not isinstance(move, Arc | Dwell) and move.start[k] != move.end[k] for move in made.moves) for k in range(3)]
    pairs[:, 1] *= [1.0 if straight["xyz".index(letter)] else 0.5 for letter in letters]
    fastest = setup.ini.number("TRAJ", "MAX_LINEAR_VELOCITY", positive=True)
    limits = AxisLimits(pairs[:, 0], pairs[:, 1], path_velocity=math.inf if fastest is None else fastest * setup.unit)
    reference = program_motion(made, letters, limits, setup.period)
    position = reference.block(0, reference.n_sample).position
    return {letter: np.pad(position[:, k], round(0.2 / setup.period), mode="edge") for k, letter in enumerate(letters)}


# --- what a person gets: the changes as a diff, the circle before and after, and a page --------------------------------------------


def text_of(value: float) -> str:
    """Return a gain as it is written into a file."""
    return f"{value:.6g}"


def changes(setup: Setup, gains: Mapping[str, Mapping[str, float]]) -> str:
    """Return the unified diff of INI and HAL that sets gains.

    Parameters
    ----------
    setup : Setup
    gains : mapping of str to mapping of str to float
        By axis and HAL's name, in machine units. A gain that the files do not set is added only if it changes.
    """
    lines = {file: _lines(file) or [""] for file in (setup.hal, *(place.file for axis in setup.axes for place in axis.places.values()))}
    for axis in setup.axes:
        for name, value in gains.get(axis.name, {}).items():
            entry = axis.places.get(name)
            if entry is not None and float(entry.value) != value:
                line = lines[entry.file][entry.line - 1]
                head, rest = re.match(r"([^=#]*=\s*|\s*setp\s+\S+\s+)(.*)", line, re.DOTALL).groups()  # type: ignore[union-attr]
                lines[entry.file][entry.line - 1] = head + rest.replace(entry.value, text_of(value), 1)
            elif entry is None and value != axis.gains[name]:
                lines[setup.hal][axis.last - 1] += f"setp {axis.pid}.{name} {text_of(value)}\n"  # without a setp in the last line
    changed = {file: "".join(new).splitlines(keepends=True) for file, new in lines.items()}
    diffs = (difflib.unified_diff(_lines(file), new, f"a/{file.name}", f"b/{file.name}") for file, new in changed.items())
    text = "".join(line for diff in diffs for line in diff)
    return f"{SAFETY}\n{text}" if text else ""


def _lines(file: Path) -> list[str]:
    """Return the lines of a file, each with its end."""
    return [f"{line}\n" for line in file.read_text(encoding="utf-8", errors="replace").splitlines()]


def circle_errors(work: _Work, after: Mapping[str, Array]) -> Curves:
    """Return angle [rad] and radial error [m] on a circle, simulated with the gains in use and others (7,), and at the load.

    Empty unless both x and y are known. An eighth of the acceleration is used.
    """
    axes = {name: (axis.task, axis.identified) for name, axis in work.axes.items() if name in ("x", "y") and axis.task and axis.identified}
    if len(axes) < 2:
        return {}
    fastest = min(work.axes[name].setup.limits["acceleration"] for name in axes) * work.setup.unit
    period, turn, start = work.setup.period, 0.5 * math.sqrt(0.5 * fastest / CIRCLE), 0.3
    time = period * np.arange(round((start + 4.0 * math.pi / turn) / period))
    phase = turn * np.where(time < start, time**2 / (2.0 * start), time - 0.5 * start)  # from rest, two turns
    commands, last = {"x": CIRCLE * np.cos(phase), "y": CIRCLE * np.sin(phase)}, phase > phase[-1] - 2.0 * math.pi
    curves: dict[str, tuple[Array, Array]] = {}
    for label, rows in {"before": {name: work.axes[name].present for name in axes}, "after": after}.items():
        places, loads = list[Array](), list[Array]()
        for name, command in commands.items():
            task, model = axes[name]
            run = run_lanes(command, model.noise_like(command), rows[name][None], [task.model], task.law, trace=True)
            places.append(run.position[last])
            loads.append(model.load(run)[last])
        curves |= {label: (np.arctan2(*places[::-1]), np.hypot(*places) - CIRCLE)}
    return curves if np.isnan(loads).any() else curves | {"load": (np.arctan2(*loads[::-1]), np.hypot(*loads) - CIRCLE)}


def circle_charts(errors: Curves) -> Iterator[PolarChart]:
    """Yield a ball-bar plot for each of some curves of angle [rad] and radial error [m], by name."""
    for i, (name, (angle, error)) in enumerate(errors.items()):
        title = f"{name}: at most {figure(float(np.abs(error).max()), 'um')}"
        curve = Curve(np.degrees(np.unwrap(angle)), 1e6 * error, name, scheme_style(i, len(errors))[0])
        yield PolarChart(f"circle-{name}", title, f"Radius {figure(CIRCLE, 'mm')}.", (curve,), CIRCLE)


def gain_table(axes: tuple[AxisSetup, ...], columns: Mapping[str, Mapping[str, Mapping[str, float]]]) -> Table:
    """Return a table of axis, gain, and its value in each column; gains that are zero everywhere are left out."""
    names = ((axis.name, name) for axis in axes for name in axis.gains)
    rows = ((axis, name, [gains[axis][name] for gains in columns.values() if axis in gains]) for axis, name in names)
    whole = ((f"{axis} {name}", *map(text_of, values)) for axis, name, values in rows if len(values) == len(columns) and any(values))
    return Table([Column("gain", left=True), *map(Column, columns)], rows=whole)


def page(title: str, answer: Sequence[str], table: Table, diff: str, picture: Sequence[bytes], findings: Sequence[Finding]) -> str:
    """Return the report as one HTML page."""
    from contourlab.rendering.html import page_template

    image = "".join(base64.b64encode(content).decode() for content in picture)
    worst_first = sorted(findings, key=lambda doubt: ("error", "warning", "info").index(doubt.entry.severity))
    template = page_template("commission.html.j2")
    return str(template.render(title=title, answer=answer, table=table, diff=diff, picture=image, findings=worst_first))
