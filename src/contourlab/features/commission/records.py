"""The signals of each axis in a log of the control: whether they can be what they are called, and what loop they show."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from contourlab.analysis.identification.least_squares import fit_records
from contourlab.arrays import Array, Flags, true_spans
from contourlab.controls.linuxcnc.loops import LoopClass
from contourlab.errors import LogError
from contourlab.features.commission.excitation import SIGNALS, sampler_columns
from contourlab.features.commission.loop import GAINS, Law, law_output
from contourlab.features.commission.setup import AxisSetup, Setup, row_of
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.logs import Column, Columns, Log, read_record, result_of
from contourlab.logs.window import Window

LEAST_MOTION = 1e-4
"""Range of a command [m] below which an axis was not asked to move."""
AGREES = 0.02
"""Difference of the logged output from the law of pid, relative to its standard deviation, up to which they agree."""
INCH = 25.4
WORDS = {"command": "cmd", "feedback": "fb", "output": "out"}
"""How the columns of a log call the pins of a pid."""
SPAN, LATEST = 0.02, 0.02
"""Time [s] over which positions are differenced where a log decides, and longest delay of the motion behind the output."""
EXPLAINED = 0.8
"""Least part of the output that velocity, acceleration and friction must explain."""
QUICK, SLOW = 100.0, 20.0
"""Rates [1/s] at which a velocity settles: above the first one it follows the output; above the second where the output is the speed."""


@dataclass(frozen=True, eq=False)
class AxisLog:
    """One axis of a log, in SI, trimmed to its motion.

    Attributes
    ----------
    source, axis : str
    period : float [s]
    command, measured : ndarray (n,) [m]
    output : ndarray (n,)
    load : ndarray (n,) or None [m]
    free : int
        Samples at the start in which LinuxCNC was off and the command followed the position.
    """

    source: str
    axis: str
    period: float
    command: Array
    measured: Array
    output: Array
    load: Array | None = None
    free: int = 0

    @property
    def error(self) -> Array:
        """Command minus measured position (n,) [m]."""
        return self.command - self.measured


def read_log(file: str | Path | Log, setup: Setup, window: Window | None = None) -> tuple[dict[str, AxisLog], list[Finding]]:
    """Read the signals of each axis from a log; an axis without command or position is left out with a finding.

    Raises
    ------
    LogError
        If the file cannot be read or has no axis.
    """
    record = read_record(file)
    names = {channel.name.lower(): channel.name for channel in record.channels}
    numbered = {column: str(k + 1) for k, column in enumerate(sampler_columns(setup))} if record.format == "halsampler" else {}
    columns, findings, recorded = [], list[Finding](), list[AxisSetup]()
    kinds = {"command": "reference", "feedback": "position", "load": "axis_position", "output": "command"}
    for axis in setup.axes:
        chosen = {signal: name for signal in kinds if (name := _column(names, numbered, axis, signal)) is not None}
        if missing := [word for signal, word in (("command", "command"), ("feedback", "position")) if signal not in chosen]:
            findings.append(finding("CL870", f"axis {axis.name}", signal=missing[0], log=record.file.name))
            continue
        recorded.append(axis)
        for signal, name in chosen.items():
            unit = "" if signal == "output" or record.channel(name).unit else setup.unit_name
            columns.append(Column(kinds[signal], axis.name, name, unit))
    if not columns:
        wanted = ", ".join(sampler_columns(setup))
        raise LogError(f"has none of the columns {wanted}: name them so, or record with the lines of sampler.hal", file=record.file)
    timed = any(channel.time is not None or channel.name.lower().startswith("time") for channel in record.channels)
    log = result_of(record, Columns(tuple(columns), None if timed or record.period else setup.period, window=window))
    findings += [doubt for doubt in log.findings if doubt.code not in ("CL430", "CL433", "CL436", "CL441")]
    period = log.result.servo_period
    if abs(period / setup.period - 1.0) > 0.01:
        findings.append(finding("CL871", record.file.name, period=period, ini=setup.period))
    logs = {}
    for axis in recorded:
        command, measured = (log.result[name][:, log.result.axes.index(axis.name)] for name in ("reference", "position"))
        output, load = log.signal(axis.name, "command"), log.signal(axis.name, "axis_position")
        if output is None:  # it was not recorded
            findings.append(finding("CL872", f"axis {axis.name}"))
            law = Law(period, axis.previous_target is not False)
            output = law_output(command, measured, row_of(axis.gains, setup.unit).tolist(), law)
        logs[axis.name] = AxisLog(record.file.name, axis.name, period, command, measured, output, load)
    return logs, findings


def _column(names: Mapping[str, str], numbered: Mapping[str, str], axis: AxisSetup, signal: str) -> str | None:
    """Return the column of a signal of an axis, by its usual names, its pin, or its HAL signal."""
    a, end, word = axis.name, SIGNALS.get(signal, "_load"), WORDS.get(signal, signal)
    if numbered:
        return numbered.get(f"{a}{end}")
    usual = (f"{a}{end}", f"{a}_{word}", f"{a}-{word}", f"joint.{axis.joint}.motor-pos-{word}", f"{axis.pid}.{signal}")
    return next((names[name.lower()] for name in (*usual, axis.signals.get(signal, "")) if name.lower() in names), None)


REST = 0.5
"""Time [s] for which a command that does not move is of interest."""


def restless(command: Array, period: float) -> Flags:
    """Return which samples of a command (n,) move, or follow a motion within `REST`."""
    kept = np.ones(command.size, dtype=bool)
    for first, last in true_spans(np.append(True, np.diff(command) == 0.0)):
        kept[first + round(REST / period) : last] = False
    return kept


def moving(log: AxisLog) -> AxisLog:
    """Return a log from half a second before the first motion of the axis to half a second after its last, from rest."""
    # While LinuxCNC is off, the command repeats the noisy position.
    repeats = true_spans(np.abs(log.error) <= 2e-9)
    free = next((last for first, last in repeats if first < 100 and last - first > 20 and np.ptp(log.measured[first:last]) > 0.0), 0)
    moves = free + np.flatnonzero(np.diff(log.command[free:]))
    if not moves.size:
        return log
    margin = round(REST / log.period)
    first, last = max(int(moves[0]) - margin, free + min(margin, int(moves[0]) - free)), min(int(moves[-1]) + margin, log.command.size)
    part = slice(first, last)
    load = None if log.load is None else log.load[part]
    return replace(log, command=log.command[part], measured=log.measured[part], output=log.output[part], load=load, free=free)


# --- can the signals be what they are called? -----------------------------------------------------------------------------------------


def doubts(logs: Mapping[str, AxisLog]) -> Iterator[Finding]:
    """Yield what is wrong with the signals of each axis, from command and position alone."""
    for name, log in logs.items():
        place = f"axis {name}"
        asked, went = float(np.ptp(log.command)), float(np.ptp(log.measured))
        if asked < LEAST_MOTION:
            yield finding("CL873", place, range=asked)
            continue
        own, centred = _follows(log, log), log.command - log.command.mean()
        ratio = float(centred @ log.measured / (centred @ centred))
        other = next((rival for rival, its in logs.items() if rival != name and _follows(log, its) > max(0.98, own)), None)
        if other is not None:
            yield finding("CL874", place, other=other)
        elif went < 0.02 * asked:
            yield finding("CL875", place, asked=asked, went=went)
        elif own < -0.9:
            yield finding("CL876", place)
        elif any(abs(ratio / factor - 1.0) < 0.1 for factor in (INCH, 1.0 / INCH)):
            yield finding("CL877", place, ratio=ratio)
        elif own > 0.9 and not 0.8 < ratio < 1.25:
            yield finding("CL878", place, ratio=ratio)


def _follows(log: AxisLog, commanded: AxisLog) -> float:
    """Return the correlation of a position with a command; 0 where one of them stands still or they differ in length."""
    if log.measured.size != commanded.command.size or not np.ptp(log.measured) > 0.0 or not np.ptp(commanded.command) > 0.0:
        return 0.0
    return float(np.corrcoef(log.measured, commanded.command)[0, 1])


def saturation(log: AxisLog, limit: float) -> float:
    """Return the share of samples at a limit of the output: `limit`, or without it a plateau of five equal samples at the largest."""
    size = np.abs(log.output)
    if limit > 0.0:
        return float(np.mean(size >= 0.999 * limit))
    at = size >= float(size.max()) * (1.0 - 1e-9)
    runs = np.convolve(at, np.ones(5), "valid") == 5.0
    return float(np.mean(at)) if runs.any() and size.max() > 0.0 else 0.0


def law_of(log: AxisLog, axis: AxisSetup, unit: float) -> tuple[Law, list[Finding]]:
    """Return the law that the logged output obeys, and what is wrong if it is not that of the HAL file.

    Notes
    -----
    The output is compared with the gains of the HAL file, with either setting of ``error-previous-target``. If neither agrees, the gains
    are fitted: all of them scaled alike mean a sign or a unit; integral and feedforward scaled against Pgain mean another servo period.
    """
    gains = row_of(axis.gains, unit)
    choices = (True, False) if axis.previous_target is None else (axis.previous_target,)
    more = {"deadband": unit * axis.gains.get("deadband", 0.0), "bias": axis.gains.get("bias", 0.0)}
    laws = [Law(log.period, previous, axis.maxoutput, **more) for previous in choices]
    place, spread = f"axis {log.axis}", float(log.output.std())
    if not gains.any() or spread == 0.0:
        return laws[0], [finding("CL879", place)]
    left = [_left(law_output(log.command, log.measured, gains.tolist(), law) - log.output) / spread for law in laws]
    best = int(np.argmin(left))
    # Without maxoutput a plateau tells a limit behind the pid only where the output is not what the law asks for.
    limited = saturation(log, axis.maxoutput) if axis.maxoutput > 0.0 or left[best] >= AGREES else 0.0
    if limited > 0.0:
        law = laws[best] if axis.maxoutput > 0.0 else replace(laws[best], limit=float(np.abs(log.output).max()))
        return law, [finding("CL885", place, share=limited, limit=law.limit)]
    if left[best] < AGREES:
        return laws[best], []
    return laws[best], _diagnosis(log, gains, laws, place)


def _left(difference: Array) -> float:
    """Return the rms of a difference without its constant: the integral may have begun before the log."""
    return float(np.sqrt(np.mean((difference - np.median(difference)) ** 2)))


def _diagnosis(log: AxisLog, gains: Array, laws: Sequence[Law], place: str) -> list[Finding]:
    used = np.flatnonzero(gains)

    def scaled(law: Law) -> tuple[float, list[float]]:
        """Return what is left of the output after a fit of all gains, and their factors."""
        columns = [law_output(log.command, log.measured, np.where(np.arange(7) == k, gains, 0.0).tolist(), law) for k in used]
        rows = np.column_stack([*columns, np.ones(log.output.size)])
        shares = np.linalg.lstsq(rows, log.output, rcond=None)[0]
        return _left(rows @ shares - log.output) / float(log.output.std()), shares[:-1].tolist()

    left, factors = min(map(scaled, laws), key=lambda fit: fit[0])
    if left > 5.0 * AGREES:
        return [finding("CL880", place, share=min(left, 1.0))]
    names = [GAINS[k] for k in used]
    by_name = dict(zip(names, factors, strict=True))
    p = by_name.get("Pgain", factors[0])
    ahead = by_name.get("FF1", p)
    if p < 0.0:
        return [finding("CL881", place)]
    if abs(p - 1.0) < 0.05 and abs(ahead - 1.0) > 0.05 and ahead > 0.0:
        # Differences over the true period are larger than those computed here by the ratio of the periods.
        return [finding("CL882", place, factor=1.0 / ahead)]
    if max(factors) - min(factors) < 0.05 * abs(p):
        return [finding("CL883", place, factor=p)]
    return [finding("CL884", place, gains=[f"{name} {share:.3g} times" for name, share in zip(names, factors, strict=True)])]


# --- what a pid closes its loop on, where the wiring cannot say ---------------------------------------------------------------------


def decided(records: Sequence[tuple[Array, Array]], period: float, unit: float, given: str = "unknown") -> LoopClass | None:
    """Return the class that logs show, or None if they show none.

    Parameters
    ----------
    records : sequence of (ndarray (n,), ndarray (n,) [m])
        Output and measured position.
    period : float [s]
    unit : float [m]
        Machine unit.
    given : str
        Class that counts where both are possible.

    Notes
    -----
    The output is explained by the motion, u = (v' + d v + f sign v)/g + o. A velocity drive with one lag T has d = 1/T and no more than
    that: it differs from a torque by how soon its velocity settles, and by an output in machine units per second.
    """
    explained, (inertia, damping, *_), _ = explained_by_motion(records, period)
    if not explained > EXPLAINED or not max(inertia, damping) > 0.0:
        return None
    rate = damping / inertia if inertia > 0.0 else np.inf
    as_speed = 0.8 * unit < 1.0 / max(damping, 1e-30) < 1.25 * unit
    if rate > QUICK or (rate > SLOW and (given == "velocity drive" or (as_speed and given != "servo"))):
        also = "" if rate > QUICK else "; a torque fits the log as well, with nearly the same gains"
        return LoopClass("velocity drive", f"in the log its velocity follows the output{also}")
    slowing = figure(max(rate, 0.0), "1/s")
    return LoopClass("servo", f"in the log the output accelerates it; left alone its velocity decays with {slowing}")


def explained_by_motion(records: Sequence[tuple[Array, Array]], period: float) -> tuple[float, Array, Array]:
    """Return the part of outputs that the motion explains; output per acceleration, per velocity, against friction and offset; deviations.

    Output and motion are averaged over a triangle of twice `SPAN`, the motion up to `LATEST` later.
    """
    s = max(round(SPAN / period), 2)
    records = [(output, measured) for output, measured in records if measured.size > 20 * s]
    best = 0.0, np.zeros(4), np.zeros(4)
    for late in range(max(round(LATEST / period), 1) if records else 0):
        rows, targets = list[Array](), list[Array]()
        for output, measured in records:
            ends = np.array([measured[2 * s :], measured[s:-s], measured[: -2 * s]])[:, late:]
            place, held = np.cumsum(measured) - 0.5 * measured, np.cumsum(output) - 0.5 * output
            force = np.cumsum(held) - held  # the output is held from each sample to the next
            speed = (place[2 * s :] - 2.0 * place[s:-s] + place[: -2 * s])[late:] / (s * s * period)
            acceleration = (ends[0] - 2.0 * ends[1] + ends[2]) / (s * period) ** 2
            targets.append(((force[2 * s :] - 2.0 * force[s:-s] + force[: -2 * s]) / (s * s))[: acceleration.size])
            rows.append(np.column_stack([acceleration, speed, np.sign(ends[0] - ends[2]), np.ones(speed.size)]))
        numbers, covariance, rest = fit_records(rows, targets)
        share = 1.0 - float(np.var(np.concatenate(rest))) / max(float(np.var(np.concatenate(targets))), 1e-300)
        best = max(best, (share, numbers, covariance.deviations), key=lambda fit: fit[0])
    return best
