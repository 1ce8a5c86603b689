"""``contourlab limits``: what a control commanded, or our planner would, against the limits of a machine."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from contourlab.app.results import check_file
from contourlab.app.session import QUIET, Session, question
from contourlab.arrays import Array, Flags, Index
from contourlab.errors import LogError, ParameterError, ResultError, UnitError
from contourlab.features.check.program_check import DEFAULT_MACHINE
from contourlab.features.check.reading import reading_of, refuse_drawing
from contourlab.features.limits.log_limits import KINDS, AxisPeak, control_samples, course, moving_part
from contourlab.features.limits.options import Limits
from contourlab.features.limits.result import LimitTest, ProgramLine
from contourlab.features.measure.log_choice import PROGRAMS, LogChoice, open_log, positive
from contourlab.features.measure.measured_path import progress_along
from contourlab.features.measure.plausibility import known_signal
from contourlab.features.measure.study import ACTUAL
from contourlab.feed import AxisLimits
from contourlab.feed.verify import KINDS as ALL_KINDS
from contourlab.feed.verify import LineUse, Worst, limit_report_by_line
from contourlab.file_kinds import kind_of
from contourlab.findings import Finding, finding
from contourlab.logs import Log
from contourlab.logs.load import about
from contourlab.loop import Machine
from contourlab.program import Reading, read_program
from contourlab.scenario.load import machine_of
from contourlab.scenario.values import program_motion, program_route
from contourlab.units import to_si

_UNITS = {"velocity": ("m/s", "200 mm/s"), "acceleration": ("m/s^2", "2 m/s^2"), "jerk": ("m/s^3", "50 m/s^3")}
"""Unit of each kind of limits, and an example."""
_LINES = ("line", "program-line", "program_line", "source_line", "motion.program-line", "motion-line", "block", "n")
HELD = 0.005
"""Part by which a limit may be exceeded, by default."""
BLOCK = 65536


@question(Limits)
def limits(file: str | Path, *, settings: Limits, session: Session = QUIET) -> LimitTest:
    """Compare what a control commanded, or our planner would, with the limits of a machine.

    Parameters
    ----------
    file : str or Path
        A log, or a part program by its suffix.

    Returns
    -------
    LimitTest

    Raises
    ------
    LogError, ProgramError, ScenarioError
        If a file cannot be read.
    ParameterError
        If an option is out of range, or has no effect.
    """
    choice, reading = LogChoice.of(file, settings), reading_of(settings.program or Path("log"), settings)
    tolerance = HELD if settings.tolerance is None else _share(settings.tolerance)
    is_program = Path(file).suffix.lower() in PROGRAMS and kind_of(file) != "a log"  # .nc: G-code or NetCDF
    planned = is_program and not choice.format and not choice.columns
    program = Path(file) if planned else settings.program
    if planned and (settings.program or settings.line_column):
        raise ParameterError("--program", str(settings.program or settings.line_column), "left out: the file is itself a program")
    annotate = session.saving.get("annotate")
    if annotate is not None:
        if program is None:
            raise ParameterError("--annotate", repr(str(annotate)), "with the program of the log: add --program PART.ngc")
        check_file(annotate, [file, program], "--annotate")
    test = _planned(Path(file), settings, tolerance, reading) if planned else _logged(choice, settings, tolerance, reading)
    return replace(test, program=program, reading=reading)


def _share(text: str) -> float:
    try:
        share = to_si(text, "")
    except UnitError as error:
        raise ParameterError("--tolerance", repr(text), 'a share such as "1 %"') from error
    if not 0.0 <= share < 1.0:
        raise ParameterError("--tolerance", text, "between 0 and 100 %")
    return share


def _limits(options: Limits, axes: Sequence[str], machine: Machine | None) -> dict[str, list[float]]:
    """Return the limits of each kind by axis, inf for none."""
    limits: dict[str, list[float]] = {}
    for kind, (unit, example) in _UNITS.items():
        known = {} if machine is None else dict(zip(machine.axis_names, getattr(machine.planner_limits(), kind).tolist(), strict=True))
        option, text = f"--{kind}", getattr(options, kind)
        for part in () if text is None else text.split(","):  # one for all axes, or x=..., y=...
            name, quantity = (word.strip() for word in part.rpartition("=")[::2])
            if name and name not in axes:
                raise ParameterError(option, repr(text), f"limits of {', '.join(axes)}, such as {axes[0]}={example}")
            value = positive(option, quantity, unit, f'a limit with its unit, such as "{example}" or "{axes[0]}={example}"')
            known |= dict.fromkeys([name] if name else axes, value)
        limits[kind] = [known.get(axis, math.inf) for axis in axes]
    return limits


def _planned(file: Path, options: Limits, tolerance: float, reading: Reading) -> LimitTest:
    """Check what the planner would command."""
    refuse_drawing(file)
    machine = machine_of(DEFAULT_MACHINE if options.machine is None else options.machine)
    asked = _limits(options, machine.axis_names, machine)
    limits = AxisLimits(*(asked[kind] for kind in KINDS))
    given = tuple(kind for kind in KINDS if getattr(options, kind) is not None)
    within = limits if options.machine is None else machine.planner_limits()
    reference = program_motion(read_program(file, reading=reading), machine.axis_names, within, machine.servo_period)
    report, use = limit_report_by_line(reference, limits)
    orders = {"velocity": 1, "kink": 1, "acceleration": 2, "curvature step": 2, "jerk": 3}
    peaks = [
        AxisPeak(machine.axis_names[worst.axis], kind, worst, orders[kind] * machine.servo_period)
        for of_axis in zip(*report.kinds, strict=True)
        for kind, worst in zip(ALL_KINDS, of_axis, strict=True)
        if worst.sample >= 0 and (worst.value > 0.0 or kind in KINDS)
    ]
    blocks = (reference.block(start, min(start + BLOCK, reference.n_sample)) for start in range(0, reference.n_sample, BLOCK))
    lines = np.concatenate([reference.source_line(block.arc_length) for block in blocks])
    rows = _rows(lines, reference.servo_period, use, machine.axis_names)
    passed = all(peak.use is None or peak.use <= 1.0 + tolerance for peak in peaks)
    kept = "given" if given and options.machine is None else "machine"
    head = (file.name, "plan", machine.axis_names, machine.servo_period, reference.duration, machine.name, tolerance, passed)
    return LimitTest(*head, tuple(peaks), rows, _exceeded(peaks, tolerance), given, kept)


def _rows(lines: Index, period: float, use: LineUse, axes: Sequence[str], errors: Array | None = None) -> tuple[ProgramLine, ...]:
    """Return what each program line does, from the line of each sample."""
    rows = []
    present, first, count = np.unique(lines, return_index=True, return_counts=True)
    largest = np.zeros(int(present.max(initial=0)) + 1)
    if errors is not None:
        np.maximum.at(largest, lines, errors)
    for line, at, n in zip(present.tolist(), first.tolist(), count.tolist(), strict=True):
        if line > 0:
            known = line < len(use.ratio) and use.kind[line] >= 0
            share: tuple[float | None, str, str] = (
                (float(use.ratio[line]), ALL_KINDS[use.kind[line]], axes[use.axis[line]]) if known else (None, "", "")
            )
            error = None if errors is None else float(largest[line])
            rows.append(ProgramLine(line, at * period, n * period, *share, error))
    return tuple(rows)


def _logged(choice: LogChoice, options: Limits, tolerance: float, reading: Reading) -> LimitTest:
    """Check what a log holds: its reference, or without one its position."""
    log = open_log(choice)
    result, axes = log.result, tuple(choice.axes) or log.result.axes
    with about(choice.file):
        known = known_signal(result, axes, ("reference", *ACTUAL, "motor_position"))
        if known is None:
            raise ResultError(f"no reference or position of {', '.join(axes)} in {result.source}: name the columns with --column")
        position = known[1]
        moves = moving_part(position)
    if not moves.any():
        raise LogError("nothing moves: position or reference is the same at all samples", file=log.record.file)
    machine = None if options.machine is None else machine_of(options.machine)
    if machine is not None and (unlike := [axis for axis in axes if axis not in machine.axis_names]):
        raise ParameterError("--axes", ", ".join(unlike), f"axes of {machine.name}: {', '.join(machine.axis_names)}")
    limits = _limits(options, axes, machine)
    lines, errors = _lines_of(log, choice, options, axes, position, reading)
    use = LineUse(int(lines.max(initial=0)) + 1)
    first, commanded = control_samples(position, result.servo_period)
    peaks, findings = _log_peaks(position[first], commanded, axes, limits, lines[first], moves[first], use)
    rows = _rows(np.where(moves, lines, 0), result.servo_period, use, axes, errors) if lines.any() else ()
    uses = [peak.use for peak in peaks if peak.use is not None]
    passed = max(uses) <= 1.0 + tolerance if uses else None
    source = "reference" if known[0] == "reference" else "position"
    cycle, name = float(np.count_nonzero(moves) - 1) * result.servo_period, "" if machine is None else machine.name
    head = (Path(choice.file).name, source, axes, commanded, cycle, name, tolerance, passed)
    return LimitTest(*head, tuple(peaks), rows, (*_exceeded(peaks, tolerance), *findings, *log.findings))


def _lines_of(
    log: Log, choice: LogChoice, options: Limits, axes: Sequence[str], position: Array, reading: Reading
) -> tuple[Index, Array | None]:
    """Return the program line of each sample, 0 for none, and the distance from the program's path [m]."""
    n = len(position)
    lines = np.zeros(n, dtype=np.int64)
    errors: Array | None = None
    if options.program is not None:
        route = program_route(read_program(Path(options.program), reading=reading), tuple(axes))
        with about(choice.file):
            along, _ = progress_along(route.path, position)
        lines = np.asarray(route.source_line[route.path.curve_index(along)], dtype=np.int64)
        if (measured := known_signal(log.result, axes, ACTUAL)) is not None:
            errors = np.asarray(route.path.foot_point(measured[1], along, 0.02 * route.path.length + 1e-3).distance)
    named = options.line_column or next((c.name for c in log.record.channels if c.name.casefold() in _LINES), None)
    if named is not None:
        values = log.record.channel(named).values
        if len(values) == n and np.isfinite(values).all() and float(np.abs(values).max()) < 1e7:
            lines = np.maximum(np.rint(values), 0).astype(np.int64)
        elif options.line_column:
            raise LogError(f"column {named!r} does not have a line number for each sample", file=log.record.file)
    return lines, errors


def _log_peaks(
    position: Array, period: float, axes: Sequence[str], limits: Mapping[str, list[float]], lines: Index, moves: Flags, use: LineUse
) -> tuple[list[AxisPeak], list[Finding]]:
    """Return the largest values, and what limits their resolution; add the use of each program line."""
    peaks, findings = [], []
    for j, axis in enumerate(axes):
        for order, kind in enumerate(KINDS, 1):
            limit = limits[kind][j]
            found = course(position[:, j], period, order, limit)
            magnitude = np.where(moves & np.isfinite(found.magnitude), found.magnitude, 0.0)
            at = int(np.argmax(magnitude))
            worst = Worst(j, float(magnitude[at]), limit, found.resolution, at, at * period, source_line=int(lines[at]))
            peaks.append(AxisPeak(axis, kind, worst, order * found.stride * period))
            if math.isfinite(limit):
                ratios = np.zeros((len(magnitude), len(axes)))
                ratios[:, j] = np.maximum(magnitude - found.resolution, 0.0) / limit
                use.add(order - 1, ratios, np.arange(len(ratios)), lines)
                if found.resolution > 0.5 * limit:
                    findings.append(finding("CL474", f"axis {axis}", kind=kind, resolution=found.resolution, limit=limit))
    filtered = [f"{peak.kind} of {peak.axis} over {1e3 * peak.window:.3g} ms" for peak in peaks if peak.window > 3.5 * period]
    return peaks, [*findings, *([finding("CL473", figures=filtered)] if filtered else [])]


def _exceeded(peaks: Sequence[AxisPeak], tolerance: float) -> tuple[Finding, ...]:
    """Return a finding for each limit that is exceeded."""
    over = sorted((peak for peak in peaks if (peak.use or 0.0) > 1.0 + tolerance), key=lambda peak: -peak.worst.ratio)
    places = [f"line {peak.line}" if peak.line else f"axis {peak.axis}" for peak in over]
    return tuple(
        finding("CL472", place, kind=peak.kind, axis=peak.axis, use=peak.use, time=peak.worst.time)
        for place, peak in zip(places, over, strict=True)
    )
