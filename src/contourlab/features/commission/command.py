"""``contourlab commission linuxcnc``: first the program and the sampler, then from logs to the gains of each ``pid``."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.app.results import check_file
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.features.commission.control_terms import Term, cascade_of, check_control, term_table, terms_of
from contourlab.features.commission.excitation import excitation, sampler_lines, steps
from contourlab.features.commission.hal_files import AxisSetup, LoopClass, Setup, read_setup
from contourlab.features.commission.identification import IdentifiedAxis, identify_axis
from contourlab.features.commission.loop import GAINS, robustly_stable
from contourlab.features.commission.options import LinuxCNC
from contourlab.features.commission.records import AxisLog, decided, doubts, law_of, moving, read_log
from contourlab.features.commission.report import changes, circle_errors, circle_png, gain_table, page, text_of
from contourlab.features.commission.tuning import AxisTask, Moves, TunedAxis, largest_error, shared_delay, tune_axis
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.rendering.table import Table, paragraphs
from contourlab.result.atomic import replacing
from contourlab.threads import in_threads

FIRST, SECOND = ("excite.ngc", "sampler.hal", "steps.md"), ("report.html", "gains.diff", "safe.diff", "circle.png")
OFF_RUNS = 8
"""Runs that begin with LinuxCNC off, where the log shows it."""


@dataclass(frozen=True)
class Prediction:
    """Largest |command - motor position| [um], with the present and the proposed gains; `spread` with the axis' gain a quarter off.

    A delay that all axes share is left out: it bends no path.
    """

    before: float
    after: float
    spread: float


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
    terms : tuple of Term
        The proposed gains as parameters of another control.
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
    files: tuple[Path, ...]
    terms: tuple[Term, ...] = ()
    answer: tuple[str, ...] = ()
    tables: tuple[Table, ...] = field(default=(), metadata=HIDDEN)
    contents: Mapping[str, str | bytes] = field(default_factory=dict, metadata=HIDDEN, repr=False)
    inputs: tuple[str | Path, ...] = field(default=(), metadata=HIDDEN, repr=False)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The proposed gains, one axis a row."""
        return [{"axis": axis, **gains} for axis, gains in self.pid.items()]

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
        with ExitStack() as stack:
            for file, content in files.items():
                data = content if isinstance(content, bytes) else content.encode("utf-8", "replace")
                check_file(file, self.inputs, "--out")
                stack.enter_context(replacing(file)).write_bytes(data)
        for name in SECOND[1:3] if SECOND[0] in self.contents else ():
            if name not in self.contents:
                (Path(folder) / name).unlink(missing_ok=True)  # of an earlier answer
        return replace(self, files=tuple(files))

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Log a run: of the excitation, or of the safe gains."""
        if not (self.pid or (self.files and not asked.settings.log)):
            return None
        log = "log2.txt" if asked.settings.log else "log1.txt"
        return ["commission", "linuxcnc", *asked.inputs, "--log", log, "--out", asked.files.out]

    @property
    def passed(self) -> bool:
        """Whether no finding is an error."""
        return all(one.entry.severity != "error" for one in self.findings)

    @property
    def text(self) -> str:
        """Answer, tables, findings and files."""
        files = "\n".join(f"written: {file}" for file in self.files)
        tables = (table.text() for table in self.tables)
        return "\n\n".join(filter(None, [paragraphs(self.answer), *tables, paragraphs(map(str, self.findings)), files]))


@question(LinuxCNC)
def commission(
    ini: str | Path, hal: str | Path, *, control: str = "linuxcnc", settings: LinuxCNC, session: Session = QUIET
) -> Commissioned:
    """Find the gains of each servo loop of a control from its files and logs; without logs, what to run.

    Parameters
    ----------
    ini, hal : str or Path
        Files of LinuxCNC, with the gains in use.
    control : str
        The control: ``"linuxcnc"``.

    Returns
    -------
    Commissioned

    Raises
    ------
    ScenarioError, LogError, ProgramError, FeedError
        If a file cannot be read, no axis has a pid, a travel is too short, or the program cannot be planned.
    ParameterError
        If an option or the control is unknown.
    """
    if control != "linuxcnc":
        raise ParameterError("control", repr(control), "'linuxcnc'")
    if settings.for_ is not None:
        check_control(settings.for_)
    setup, program = read_setup(ini, hal), settings.program
    inputs = (ini, hal, *settings.log, *([] if program is None else [program]))
    for name in (SECOND if settings.log else FIRST) if session.saving else ():
        check_file(session.folder / name, inputs, "--out")
    if not settings.log:
        return _prepared(setup, inputs, session)
    findings, records = list(setup.findings), list[dict[str, AxisLog]]()
    for log in settings.log:
        record, more = read_log(log, setup)
        record = {axis.name: record[axis.name] for axis in setup.closed if axis.name in record}
        findings += more
        wrong = list(doubts(record))
        findings += wrong
        bad = {one.place.removeprefix("axis ") for one in wrong}
        records.append({name: moving(one) for name, one in record.items() if name not in bad})
    planned = {} if program is None else planned_commands(program, setup)
    work = _Work(setup, records, planned, (settings.gain_margin, settings.phase_margin), settings.seed)
    if all(one.code != "CL871" for one in findings):
        session.stages().begin("identifying and tuning the axes")
        findings += chain.from_iterable(in_threads(work.axis, setup.closed))
        findings += work.compared()
    return _answered(work, findings, inputs, program, settings.for_)


def _prepared(setup: Setup, inputs: tuple[str | Path, ...], session: Session) -> Commissioned:
    """Return the excitation, the lines of the sampler, and the steps, if an axis can be commissioned and none has a pid without gains."""
    axes = {axis.name: axis.loop for axis in setup.axes}
    answer = tuple(f"{name}: {axis.loop}: {axis.why}." for name, axis in axes.items())
    contents: dict[str, str | bytes] = {}
    if setup.closed and not any(axis.idle for axis in setup.axes):
        folder = session.folder if session.saving else Path("commissioning")
        contents = dict(zip(FIRST, (excitation(setup), sampler_lines(setup), steps(setup, folder)), strict=True))
    return Commissioned(axes, {}, {}, {}, {}, setup.findings, (), answer=answer, contents=contents, inputs=inputs)


@dataclass(eq=False)
class _Work:
    """What is known of the axes so far."""

    setup: Setup
    records: Sequence[Mapping[str, AxisLog]]
    planned: Mapping[str, Array]
    margins: tuple[float, float]
    seed: int
    models: dict[str, IdentifiedAxis] = field(default_factory=dict)
    tasks: dict[str, AxisTask] = field(default_factory=dict)
    tuned: dict[str, TunedAxis] = field(default_factory=dict)
    predicted: dict[str, Prediction] = field(default_factory=dict)
    before: dict[str, Moves] = field(default_factory=dict)
    loops: dict[str, LoopClass] = field(default_factory=dict)

    def present(self, axis: AxisSetup) -> Array:
        """Return the gains in use, per metre."""
        return np.array([axis.gains[name] / self.setup.unit for name in GAINS])

    def axis(self, axis: AxisSetup) -> list[Finding]:
        """Identify and tune an axis; return the findings."""
        place = f"axis {axis.name}"
        logs = [record[axis.name] for record in self.records if axis.name in record]
        if not logs:
            return []
        checked = [law_of(log, axis, self.setup.unit) for log in logs]
        findings = list({str(one): one for _, more in checked for one in more}.values())
        if axis.backlash:
            findings.append(finding("CL899", place, backlash=axis.backlash * self.setup.unit))
        if any(one.entry.severity == "error" for one in findings):
            return findings
        loop = axis.loop
        if loop.loop == "unknown":
            loop = decided([(log.output, log.measured) for log in logs], self.setup.period, self.setup.unit) or loop
            self.loops[axis.name] = loop
            findings += [finding("CL868", place, why=loop.why)] if loop.loop == "velocity drive" else []
        if loop.loop == "velocity drive":
            return findings
        identified = identify_axis(logs, self.present(axis), checked[0][0])
        if isinstance(identified, Finding):
            return [*findings, identified]
        self.models[axis.name] = identified
        findings += identified.findings
        return findings if not identified.usable else [*findings, *self._tune(axis, logs, identified)]

    def _tune(self, axis: AxisSetup, logs: Sequence[AxisLog], identified: IdentifiedAxis) -> list[Finding]:
        place, law = f"axis {axis.name}", identified.law
        commands = [self.planned[axis.name]] if axis.name in self.planned else [log.command for log in logs]
        if not any(np.ptp(command) > 0.0 for command in commands):
            commands = [log.command for log in logs]  # the program does not move this axis
        noises = [identified.noise_like(command, self.seed + k) for k, command in enumerate(commands)]
        free = max(log.free for log in logs) if axis.always_enabled else 0
        off = [identified.noise_like(np.zeros(free + 300), self.seed + 100 + k) for k in range(OFF_RUNS if free else 0)]
        task = AxisTask(identified.model, law, commands, noises, off, free, axis.always_enabled, *self.margins)
        self.tasks[axis.name] = task
        measured = [(log.command, log.measured) for log in logs]
        self.before[axis.name] = task.runs(self.present(axis)) if self.planned else measured
        try:
            tuned = tune_axis(task, unit=self.setup.unit, seed=self.seed)
        except ParameterError:
            return [finding("CL897", place)]
        before = task.largest(self.present(axis)) if self.planned else largest_error(measured, 0.0, law.period)
        if not tuned.largest < before:
            return [finding("CL897", place)]
        self.tuned[axis.name] = tuned
        return []

    def compared(self) -> list[Finding]:
        """Predict all errors without the delay that the axes share; new gains hold only if they shrink the sum."""
        before, after, findings = self._errors({}), self._errors(self.tuned), list[Finding]()
        if self.tuned and not sum(after.values()) < sum(before.values()):
            findings, after = [finding("CL897", f"axis {name}") for name in self.tuned], before
            self.tuned.clear()
        for name, error in before.items():
            spread = self.tuned[name].spread if name in self.tuned else math.nan
            self.predicted[name] = Prediction(1e6 * error, 1e6 * after[name], 1e6 * spread)
            noise = 3.0 * self.models[name].noise
            findings += [finding("CL891", f"axis {name}", noise=noise)] if name in self.tuned and noise > 0.3 * after[name] else []
            findings += [finding("CL898", f"axis {name}", error=spread)] if spread > 0.5 * error else []
        return findings

    def _errors(self, tuned: Mapping[str, TunedAxis]) -> dict[str, float]:
        """Return the largest error [m] of each axis without the delay that all share, with tuned gains or else those in use."""
        moves = self.before | {name: self.tasks[name].runs(one.gains) for name, one in tuned.items()}
        period = self.setup.period
        delay = shared_delay(list(moves.values()), period) if len(moves) == len(self.setup.axes) else 0.0
        errors = {name: largest_error(one, delay, period) for name, one in moves.items()}
        for name, one in tuned.items():
            started = float(self.tasks[name].switched_on(one.gains[None], self.models[name].model)[0])
            errors[name] = max(errors[name], started) if delay else one.largest
        return errors

    def gains(self, share: float = 1.0) -> dict[str, dict[str, float]]:
        """Return the gains in machine units by axis: the present ones, and a share of the way from there to the tuned ones."""
        result = {name: dict(axis.gains) for axis in self.setup.axes if (name := axis.name) in self.models and self.models[name].usable}
        for axis in (axis for axis in self.setup.axes if axis.name in self.tuned):
            present = self.present(axis)
            mixed = (present + share * (self.tuned[axis.name].gains - present)) * self.setup.unit
            result[axis.name] = {name: float(f"{value:.6g}") for name, value in zip(GAINS, mixed.tolist(), strict=True)}
        return result

    def safe(self) -> dict[str, dict[str, float]]:
        """Return the first gains to type in: half the way, or less where the loop would not be stable there."""
        chosen = {}
        for share in (0.5, 0.25, 0.1):
            for name, gains in self.gains(share).items():
                row, model = np.array(list(gains.values())) / self.setup.unit, self.models[name]
                if name not in chosen and robustly_stable(row[None], model.model, model.law.period)[0]:
                    chosen[name] = gains
        return chosen


def _answered(
    work: _Work, findings: Sequence[Finding], inputs: tuple[str | Path, ...], program: Path | None, control: str | None
) -> Commissioned:
    """Return the answer, with the contents of its files."""
    setup, gains, safe = work.setup, work.gains(), work.safe()
    axes = {axis.name: work.loops.get(axis.name, axis.loop) for axis in setup.axes}
    answer = tuple(_line(axis, work, gains) for axis in setup.axes)
    silent = [axis.name for axis in setup.axes if axis.name not in gains]
    findings = [*findings, finding("CL867", setup.ini.file.name, axes=silent)] if silent else findings
    present = {axis.name: axis.gains for axis in setup.axes if axis.name in gains}
    tables = {"Gains": gain_table(setup.axes, {"present": present, "safe first": safe, "proposed": gains})}
    terms = tuple[Term, ...]()
    if control is not None:
        rows = {name: np.array(list(values.values())) / setup.unit for name, values in gains.items()}
        terms = terms_of(control, {name: cascade_of(row, work.models[name]) for name, row in rows.items()})
        tables |= {f"The proposed gains in other terms: {control}": term_table(terms)} if terms else {}
    tables = {head: table for head, table in tables.items() if table.rows}
    diff, picture = "" if silent else changes(setup, gains), _circle(work, gains)
    report, gain_diff, safe_diff, image = SECOND
    title = f"Commissioning of {setup.ini.file.name}" + ("" if program is None else f" for {program.name}")
    text = page(title, answer, tables, diff, picture, findings)
    contents: dict[str, str | bytes] = {report: text}
    contents |= {} if silent else {gain_diff: diff, safe_diff: changes(setup, safe)}
    contents |= {} if picture is None else {image: picture}
    models = {axis.name: work.models[axis.name] for axis in setup.axes if axis.name in work.models}
    predicted = {name: work.predicted[name] for name in models if name in work.predicted}
    found = (axes, gains, safe, predicted, models, tuple(findings), (), terms, answer, tuple(tables.values()))
    return Commissioned(*found, contents=contents, inputs=inputs)


def _line(axis: AxisSetup, work: _Work, gains: Mapping[str, Mapping[str, float]]) -> str:
    """Return the answer for an axis in one line."""
    if axis.name not in work.predicted:
        return f"No gains for {axis.name}, {work.loops.get(axis.name, axis.loop).loop}: the findings say why."
    predicted, model = work.predicted[axis.name], work.models[axis.name]
    short = {"Pgain": "P", "Igain": "I", "Dgain": "D"}
    listed = ", ".join(f"{short.get(name, name)} {text_of(float(f'{value:.3g}'))}" for name, value in gains[axis.name].items() if value)
    before, after = (figure(1e-6 * value, "um") for value in (predicted.before, predicted.after))
    change = f"largest error {before} -> about {after}" if axis.name in work.tuned else f"these gains stay, largest error {before}"
    line = f"{listed} for {axis.name}: {change}"
    if math.isfinite(model.play):
        play, deviation = figure(model.play, "um", 2), figure(model.play_deviation, "um", 1)
        line += f"; play of {play.removesuffix(' um')} +-{deviation} remains"
    return line


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
    letters = [letter for letter in "xyz" if _limits(setup, letter) is not None]
    pairs = np.array([_limits(setup, letter) for letter in letters]) * setup.unit
    # LinuxCNC speeds up along an arc with half the acceleration.
    straight = [any(not isinstance(move, Arc | Dwell) and move.start[k] != move.end[k] for move in made.moves) for k in range(3)]
    pairs[:, 1] *= [1.0 if straight["xyz".index(letter)] else 0.5 for letter in letters]
    limits = AxisLimits(pairs[:, 0], pairs[:, 1])
    reference = program_motion(made, letters, limits, setup.period)
    position = reference.block(0, reference.n_sample).position
    rest = round(0.2 / setup.period)
    return {letter: np.pad(position[:, k], rest, mode="edge") for k, letter in enumerate(letters)}


def _limits(setup: Setup, letter: str) -> tuple[float, float] | None:
    """Return velocity and acceleration of an axis in machine units; None if the INI file has none."""
    axis = next((axis for axis in setup.axes if axis.name == letter), None)
    if axis is not None:
        return axis.limits["velocity"], axis.limits["acceleration"]
    values = [setup.ini.number(f"AXIS_{letter.upper()}", key) for key in ("MAX_VELOCITY", "MAX_ACCELERATION")]
    return None if None in values else (float(values[0] or 0.0), float(values[1] or 0.0))


def _circle(work: _Work, gains: Mapping[str, Mapping[str, float]]) -> bytes | None:
    """Return the picture of a circle before and after, if both x and y are known."""
    if not {"x", "y"} <= work.tasks.keys():
        return None
    axes = [axis for axis in work.setup.axes if axis.name in "xy"]
    strongest = min(axis.limits["acceleration"] for axis in axes) * work.setup.unit
    after = {axis.name: np.array(list(gains[axis.name].values())) / work.setup.unit for axis in axes}
    rows = {"before": {axis.name: work.present(axis) for axis in axes}, "after": after}
    return circle_png(circle_errors(work.tasks, work.models, rows, strongest))
