"""The line-circle runs of the UBC XY table: logs, the library's machine along them, and fits that leave something out."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.identification.gauss_newton import DescentSettings
from contourlab.design.values import with_values
from contourlab.errors import LogError
from contourlab.features.refine.log_run import Agreement, LogRun, log_run
from contourlab.features.refine.study import RefineSettings, Window, refine
from contourlab.logs import load_log
from contourlab.loop import Machine
from contourlab.papers.rows import Stage
from contourlab.scenario import load_scenario

Array = NDArray[np.float64]

FILES = {"lead-lag": "line_circle_lli.mat", "pole-placement": "line_circle_pp.mat"}
WANTED = (
    "wanted is a folder with line_circle_lli.mat and line_circle_pp.mat, the line-circle runs of November 2020 of the course MECH 467 of "
    "the University of British Columbia (Gigahawk/mech467, Labs). They are not part of contourlab"
)
LINES = 0.07
"""Metres along the path at which the circle begins, behind lines of 50 and 20 mm."""
PHYSICS = (
    "axes.*.plant.damping",
    "axes.*.friction.coulomb",
    "axes.*.friction.breakaway",
    "axes.*.friction.stiffness",
    "axes.*.disturbance.offset=-100 N..100 N",
    *(f"axes.*.disturbance.{name}=-60 N..60 N" for name in ("sine", "cosine", "order_sine", "order_cosine")),
)
CONTROLLERS = {
    "lead-lag": tuple(f"controller.axes.*.controller.{name}" for name in ("gain", "lead_time", "lag_time", "integral_rate")),
    "pole-placement": tuple(f"controller.axes.*.controller.{name}" for name in ("position_gain", "velocity_gain")),
}
QUICK = RefineSettings(starts=1, rounds=1, descent=DescentSettings(least_gain=1e-3))
"""Of fits whose parameters nobody keeps: they say what such a fit is worth elsewhere."""


@dataclass(frozen=True)
class Unseen:
    """What a fit is worth on something that it was not made with.

    Attributes
    ----------
    case : str
        What was fitted, and what was not.
    agreement : tuple of Agreement
        Tracking errors of both axes, over what was not fitted.
    rms, largest : float [m]
        Contour error that the model says there.
    measured_rms, measured_largest : float [m]
        And that was measured there.
    """

    case: str
    agreement: tuple[Agreement, ...]
    rms: float
    largest: float
    measured_rms: float
    measured_largest: float


def read_runs(folder: str | Path | None) -> dict[str, LogRun]:
    """Return the library's machine along both logs, by the name of the controller.

    Parameters
    ----------
    folder : str or Path, or None
        Where the logs are; None is refused with what is wanted.

    Raises
    ------
    LogError
        If there is none, or a log is not there or cannot be read.
    """
    if folder is None:
        raise LogError(f"no folder given: {WANTED}", file="--log-folder")
    missing = [name for name in FILES.values() if not (Path(folder) / name).is_file()]
    if missing:
        raise LogError(f"holds no {' and no '.join(missing)}: {WANTED}", file=folder)
    found = {}
    for name, file in FILES.items():
        scenario = load_scenario(f"builtin:ubc/{name}")
        found[name] = log_run(scenario.machine, scenario.controller, load_log(Path(folder) / file).result, name)
    return found


def unseen(runs: dict[str, LogRun], stage: Stage | None = None) -> list[Unseen]:
    """Return what fits that leave something out are worth on what they leave out.

    Halves: physics and gains from the lines of both runs, held against both circles, and the other way round. Other runs: physics from one
    run alone; of the other run only the gains, which nobody has recorded, from its lines, and its circle is what was not seen. Friction and
    ripple begin as if these logs were not known; the gains begin at the library's, and which orders of ripple there are is taken from it.
    `stage` is told what each fit is.
    """
    begun = {name: _forgotten(run) for name, run in runs.items()}
    tell = stage or (lambda words: None)
    found = []
    for words, take in (("lines fitted, circle unseen", _lines), ("circle fitted, lines unseen", _circle)):
        tell(words)
        wanted = [*PHYSICS, *CONTROLLERS["lead-lag"], *CONTROLLERS["pole-placement"]]
        fit = refine(list(begun.values()), wanted, windows=[take(run) for run in runs.values()], settings=QUICK)
        found += [_judged(f"{run.label}, {words}", run, _other(run, take(run))) for run in fit.runs]
    for one, other in (("pole-placement", "lead-lag"), ("lead-lag", "pole-placement")):
        tell(f"physics of the {one} run, held against the other")
        physics = refine([begun[one]], [*PHYSICS, *CONTROLLERS[one]], settings=QUICK).runs[0].machine
        gains = refine([replace(runs[other], machine=physics)], CONTROLLERS[other], windows=[_lines(runs[other])], settings=QUICK)
        words = f"{other}, physics of the {one} run, gains of its lines, circle unseen"
        found.append(_judged(words, gains.runs[0], _circle(runs[other])))
    return found


def _forgotten(run: LogRun) -> LogRun:
    """Return the run with friction as the course's jog test has it, and no ripple: what was known before these logs."""
    jog = {"plant.damping": 1630.0, "friction.coulomb": 103.0, "friction.breakaway": 103.0, "friction.stiffness": 3e7}
    none = dict.fromkeys((f"disturbance.{name}" for name in ("offset", "sine", "cosine", "order_sine", "order_cosine")), 0.0)
    values = {f"axes.{axis}.{name}": value for axis in run.machine.axis_names for name, value in (jog | none).items()}
    machine: Machine = with_values(run.machine, run.controller, values)[0]
    return replace(run, machine=machine)


def _border(run: LogRun) -> float:
    """Return the time [s] at which the circle begins."""
    along = run.reference.block(0, run.reference.n_sample).arc_length
    return float(run.times()[int(np.searchsorted(along, LINES + 1e-6))])


def _lines(run: LogRun) -> Window:
    return float(run.times()[0]), _border(run)


def _circle(run: LogRun) -> Window:
    return _border(run), float(run.times()[-1]) + 1.0


def _other(run: LogRun, window: Window) -> Window:
    return _circle(run) if window == _lines(run) else _lines(run)


def _judged(case: str, run: LogRun, window: Window) -> Unseen:
    times, simulated = run.times(), run.once()
    first, last = (int(np.searchsorted(times, t)) for t in window)
    rows = slice(max(first, run.moves[0]), min(last, run.moves[1]))
    figures = []
    for signals in (simulated, None):
        error = run.judged(signals).result["contour_error"][rows]
        figures += [float(np.sqrt(np.mean(error**2))), float(np.abs(error).max())]
    return Unseen(case, run.agreement(simulated, rows), *figures)


def tracking_errors(run: LogRun) -> dict[str, dict[str, tuple[Array, Array]]]:
    """Return for each axis, over time [s], its tracking error [um] as measured and as simulated."""
    times, simulated = run.times(), run.once()
    return {
        axis: {"measured": (times, 1e6 * run.measured[:, j]), "simulated": (times, 1e6 * simulated[:, j])}
        for j, axis in enumerate(run.machine.axis_names)
    }


def contour_errors(run: LogRun) -> dict[str, tuple[Array, Array]]:
    """Return over the place along the path [mm] the contour error [um] as measured and as simulated."""
    found = {}
    for name, signals in (("measured", None), ("simulated", run.once())):
        judged = run.judged(signals).result
        found[name] = 1e3 * judged["foot_arc_length"], 1e6 * judged["contour_error"]
    return found
