"""Rows of Janot, Gautier & Brunot, "Data set and reference models of EMPS", 2019 nonlinear benchmark, from its logs."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np

from contourlab.analysis.identification.filtered_motion import filtered_motion
from contourlab.analysis.identification.inverse_dynamics import (
    InverseDynamicsFit,
    InverseDynamicsSettings,
    Validation,
    cross_validate,
    identify_inverse_dynamics,
)
from contourlab.errors import LogError
from contourlab.papers.emps.log import WANTED, EmpsLog, read_emps
from contourlab.papers.emps.simulation import EmpsRun, axis_of, percent_errors, simulate_as_published, simulate_emps, simulate_in_engine
from contourlab.papers.rows import Part, Row, ours, printed

SETTINGS = InverseDynamicsSettings(cutoff=100.0, order=4, decimation=10, dropped=(49, 0), lost_degrees=1)
"""As published: samples are dropped at the start only, and the residual is taken relative to its mean."""
UNITS = {"M": "kg", "Fv": "N s/m", "Fc": "N", "offset": "N"}

SYMMETRIC = {"M": (95.1089, 0.1085), "Fv": (203.5034, 1.1460), "Fc": (20.3935, 0.1012), "offset": (-3.1648, 0.0444)}
ASYMMETRIC = {
    "M": (95.1540, 0.0827),
    "Fv+": (166.7061, 1.2326),
    "Fc+": (20.1440, 0.1088),
    "Fv-": (240.4236, 1.2346),
    "Fc-": (20.6277, 0.1091),
}
"""Published values and standard deviations."""
JUDGED = ("condition number", "residual norm", "relative error", "residual deviation")
JUDGED_UNITS = ("", "N", "%", "N")
ON_SYMMETRIC, ON_ASYMMETRIC = (25.9883, 108.7569, 4.0834, 2.1843), (26.0197, 82.8778, 3.1117, 1.6646)
ON_VALIDATION = (26.0217, 169.4876, 5.9824, 3.4039)
SIMULATED = {"position": 0.013752, "velocity": 0.22911, "acceleration": 8.6036, "force": 5.848}
SIMULATED_VALIDATION = {"position": 0.0080248, "velocity": 0.47888, "acceleration": 19.8152, "force": 8.9409}
"""Published errors of the simulated closed loop [percent]."""
LAST_DIGIT = 5e-5
"""Half a unit of the last printed digit, four decimals."""
SOLVER = 0.005
"""Relative tolerance of our fixed steps against the variable steps of the published solver."""
CLOCK = (
    "our simulation uses the clock of the log, and its axis sticks. The published run uses t_10 - t_9, which drifts against the log "
    "(0.4 ms over the 24.8 s for estimation), friction chatters at rest, and pulses rise as ramps"
)
FROM_REST = "axis and controller of builtin:emps from rest, while the log starts in motion; the rest of the run is the same"
LATE = "the published model delays the command by a tick, but the logged voltage obeys the control law without delay (see controller law)"


@dataclass(frozen=True, eq=False)
class Identified:
    """A log, and the axes identified from it: with equal friction in both directions, and with friction by direction."""

    log: EmpsLog
    symmetric: InverseDynamicsFit
    asymmetric: InverseDynamicsFit


def identified(log: str | Path | None) -> Identified:
    """Identify the axis from DATA_EMPS.mat.

    Raises
    ------
    LogError
        If no log is given, or it cannot be read.
    """
    if log is None:
        raise LogError(f"no log given: {WANTED}", file="--log")
    record = read_emps(log)
    signals = record.time, record.position, record.force
    fits = (identify_inverse_dynamics(*signals, replace(SETTINGS, friction=friction)) for friction in ("symmetric", "asymmetric"))
    return Identified(record, *fits)


def parts_of(log: str | Path | None, validation: str | Path | None = None) -> list[Part]:
    """Return the parts of the reproduction.

    Parameters
    ----------
    log : str or Path
        DATA_EMPS.mat.
    validation : str or Path, optional
        DATA_EMPS_PULSES.mat, a second record with pulses on the drive, to validate the parameters of the first.

    Raises
    ------
    LogError
        If a log is missing or cannot be read; for `log`, only when the first part runs.
    """
    second = None if validation is None else read_emps(validation)
    found = cache(lambda: identified(log))
    parts: list[Part] = [
        ("identifying", lambda: _parameters(found())),
        ("simulating the closed loop", lambda: _simulated(found(), found().log, SIMULATED, "")),
        ("tracking in the engine", lambda: _tracking(found())),
    ]
    if second is not None:
        parts += [
            ("the second record", lambda: _validated(found(), second)),
            ("simulating the second record", lambda: _simulated(found(), second, SIMULATED_VALIDATION, "validation: ")),
        ]
    return parts


def _parameters(found: Identified) -> Iterator[Row]:
    fit = found.symmetric
    alike, directed = "friction alike in both directions", "friction by direction"
    note = f"{len(fit.force)} rows; " + ("; ".join(finding.text for finding in fit.findings) or "no findings")
    for name, (value, _) in SYMMETRIC.items():
        yield printed(name, alike, value, fit[name], UNITS[name], LAST_DIGIT, note)
    yield from _judged(fit, ON_SYMMETRIC, "", alike)
    yield from _deviations(fit, SYMMETRIC, alike)
    fit = found.asymmetric
    for name, (value, _) in ASYMMETRIC.items():
        yield printed(f"asymmetric {name}", directed, value, fit[name], UNITS[name.rstrip("+-")], LAST_DIGIT)
    yield from _judged(fit, ON_ASYMMETRIC, "asymmetric ", directed)
    yield from _deviations(fit, ASYMMETRIC, directed)


def _judged(fit: Validation, published: tuple[float, ...], prefix: str, case: str) -> Iterator[Row]:
    here = (fit.condition_number, fit.residual_norm, fit.relative_error, fit.residual_deviation)
    for name, unit, paper, value in zip(JUDGED, JUDGED_UNITS, published, here, strict=True):
        yield printed(f"{prefix}{name}", case, paper, value, unit, LAST_DIGIT)
    yield ours(f"{prefix}fit", case, fit.fit, "%", "100 (1 - |residual|/|force - mean|)")


def _deviations(fit: InverseDynamicsFit, published: dict[str, tuple[float, float]], case: str) -> Iterator[Row]:
    note = "allows for the correlation of the residual; the printed figures, and our other ones, assume a white residual"
    for i, (name, (_, paper)) in enumerate(published.items()):
        unit, of = UNITS[name.rstrip("+-")], f"{name}, {case}"
        yield printed("standard deviation", of, paper, fit.deviations[i], unit, LAST_DIGIT)
        yield ours("relative standard deviation", of, fit.relative_deviations[i], "%")
        yield ours("standard deviation, residual as it is", of, fit.robust_deviations[i], unit, note)


def _simulated(found: Identified, log: EmpsLog, published: dict[str, float], prefix: str) -> Iterator[Row]:
    """Yield rows of the simulated closed loop against the log: as published, then with the clock of the log, with and without delay."""
    motion = filtered_motion(log.position, log.period, cutoff=SETTINGS.cutoff, order=SETTINGS.order)
    alike, directed = axis_of(found.symmetric), axis_of(found.asymmetric)

    def errors(run: EmpsRun) -> dict[str, float]:
        return percent_errors(log, motion, run, SETTINGS.dropped[0])

    def row(name: str, case: str, here: float, reason: str = "") -> Row:
        paper, note = published[name], "error against the log"
        return printed(
            f"simulated {name}", f"{prefix}{case}", paper, here, "%", SOLVER * paper, note, reason=reason, reading=case, main=not reason
        )

    for name, here in errors(simulate_as_published(log, alike)).items():
        yield row(name, "the published clock, delay and solver", here)
    for delay, case in ((1, "one tick of control delay"), (0, "no control delay")):
        for name, here in errors(simulate_emps(log, alike, delay=delay)).items():
            yield row(name, case, here, CLOCK if delay or name == "position" else LATE)
    for delay, case in ((1, "one tick of control delay"), (0, "no control delay")):
        for name, here in errors(simulate_in_engine(log, alike, delay=delay)).items():
            yield ours(f"simulated {name}", f"{prefix}contourlab's engine, {case}", here, "%", FROM_REST)
    for name, here in errors(simulate_emps(log, directed)).items():
        yield ours(f"simulated {name}", f"{prefix}no control delay, friction by direction", here, "%")


def _tracking(found: Identified) -> Iterator[Row]:
    log = found.log
    runs = {"measured": log.position}
    for delay, case in ((0, "simulated, no control delay"), (1, "simulated, one tick of control delay")):
        runs[case] = simulate_emps(log, axis_of(found.symmetric), delay=delay).position
    for case, position in runs.items():
        rms = 1e3 * float(np.sqrt(np.mean((log.reference - position) ** 2)))
        yield ours("tracking error rms", case, rms, "mm", "reference minus position")
    for case, position in runs.items():
        yield ours("tracking error peak", case, 1e3 * float(np.abs(log.reference - position).max()), "mm")
    velocity = (log.position[2:] - log.position[:-2]) / (2.0 * log.period)
    law = log.velocity_gain * (log.position_gain * (log.reference - log.position)[2:] - velocity) + log.pulses[2:]
    note = "rms of the logged voltage minus k_v (k_p (q_r - q) - v), with v over two ticks: the measured loop has no delay"
    for delay, case in ((0, "no control delay"), (1, "one tick of control delay")):
        left = log.voltage[2 + delay :] - law[: law.size - delay]
        yield ours("controller law", case, 1e3 * float(np.sqrt(np.mean(left**2))), "mV", note)


def _validated(found: Identified, second: EmpsLog) -> Iterator[Row]:
    record = second.time, second.position, second.force
    case = "friction alike in both directions"
    yield from _judged(cross_validate(found.symmetric, *record), ON_VALIDATION, "cross-validation ", case)
    error = cross_validate(found.asymmetric, *record).relative_error
    yield ours("cross-validation relative error", "friction by direction", error, "%", "parameters of the first log")
