"""Line-circle runs of the UBC XY table: logs, simulations along them, and fits validated on unseen data."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from contourlab.analysis.identification.descent import DescentSettings
from contourlab.errors import LogError
from contourlab.features.refine.log_run import Agreement, LogRun, log_run
from contourlab.features.refine.study import CrossValidation, RefineSettings, Window, cross_validated, refine
from contourlab.logs import load_log
from contourlab.loop import Machine
from contourlab.loop.parameters import with_values
from contourlab.scenario import load_scenario

FILES = {"lead-lag": "line_circle_lli.mat", "pole-placement": "line_circle_pp.mat"}
WANTED = (
    "give a folder with line_circle_lli.mat and line_circle_pp.mat, the line-circle runs of November 2020 of the course MECH 467 of "
    "the University of British Columbia (Gigahawk/mech467, Labs). They are not part of contourlab"
)
LINES = 0.07
"""Arc length at which the circle begins [m], after lines of 50 and 20 mm."""
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
"""Settings of fits for validation only."""


@dataclass(frozen=True)
class Unseen:
    """Agreement of a fit with unseen data.

    Attributes
    ----------
    case : str
        Which data is fitted, and which is unseen.
    agreement : tuple of Agreement
        Tracking errors of both axes over the unseen part.
    rms, largest : float [m]
        Simulated contour error of the unseen part.
    measured_rms, measured_largest : float [m]
        Measured contour error of the unseen part.
    """

    case: str
    agreement: tuple[Agreement, ...]
    rms: float
    largest: float
    measured_rms: float
    measured_largest: float


def read_runs(folder: str | Path | None) -> dict[str, LogRun]:
    """Return the shipped machine along both logs, by name of the controller.

    Raises
    ------
    LogError
        If no folder is given, or a log is missing or cannot be read.
    """
    if folder is None:
        raise LogError(f"no folder given: {WANTED}", file="--log-folder")
    missing = [name for name in FILES.values() if not (Path(folder) / name).is_file()]
    if missing:
        raise LogError(f"has no {' and no '.join(missing)}: {WANTED}", file=folder)
    runs = {}
    for name, file in FILES.items():
        scenario = load_scenario(f"builtin:ubc/{name}")
        runs[name] = log_run(scenario.machine, scenario.controller, load_log(Path(folder) / file).result, name)
    return runs


def unseen(runs: dict[str, LogRun], stage: Callable[[str], object] | None = None) -> list[Unseen]:
    """Fit parts of the runs and validate on the rest.

    By halves: physics and gains from the lines of both runs, validated on both circles, and vice versa. By runs: physics from one run,
    gains of the other run (not recorded) from its lines, validated on its circle. Friction and ripple start as if these logs were unknown.
    Gains and ripple orders start from the shipped files. `stage` is called with the name of each fit.
    """
    begun = {name: _forgotten(run) for name, run in runs.items()}
    begin = stage or (lambda name: None)
    found = []
    for words, take in (("lines fitted, circle unseen", _lines), ("circle fitted, lines unseen", _circle)):
        begin(words)
        wanted = [*PHYSICS, *CONTROLLERS["lead-lag"], *CONTROLLERS["pole-placement"]]
        fit = refine(list(begun.values()), wanted, windows=[take(run) for run in runs.values()], settings=QUICK)
        found += [_judged(f"{run.label}, {words}", run, _other(run, take(run))) for run in fit.runs]
    for fitted, other in (("pole-placement", "lead-lag"), ("lead-lag", "pole-placement")):
        begin(f"physics of the {fitted} run, validated on the other")
        physics = refine([begun[fitted]], [*PHYSICS, *CONTROLLERS[fitted]], settings=QUICK).runs[0].machine
        gains = refine([replace(runs[other], machine=physics)], CONTROLLERS[other], windows=[_lines(runs[other])], settings=QUICK)
        words = f"{other}, physics of the {fitted} run, gains of its lines, circle unseen"
        found.append(_judged(words, gains.runs[0], _circle(runs[other])))
    return found


def left_out(runs: dict[str, LogRun]) -> CrossValidation:
    """Leave out each run in turn: physics from the other run, gains from the first half of its motion, its second half predicted."""
    wanted = [*PHYSICS, *CONTROLLERS["lead-lag"], *CONTROLLERS["pole-placement"]]
    found = cross_validated(refine([_forgotten(run) for run in runs.values()], wanted, settings=QUICK), QUICK)[1]
    assert found is not None  # two runs that share physics
    return found


def _forgotten(run: LogRun) -> LogRun:
    """Return the run with the friction of the course's jog test and no ripple, as known before these logs."""
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
    return Unseen(case, run.agreement(simulated, rows), *run.contour(simulated, rows), *run.contour(None, rows))
