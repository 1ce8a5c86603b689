"""Pictures of the EMPS: force, friction curve and position error."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from contourlab.analysis.identification.filtered_motion import decimate, filtered_motion, kept_samples
from contourlab.arrays import Array
from contourlab.papers.emps.simulation import axis_of, simulate_emps
from contourlab.papers.emps.study import SETTINGS, Identified, identified
from contourlab.rendering.charts import traces_chart
from contourlab.rendering.plots import write_charts

Traces = dict[str, tuple[Array, Array]]
PERIOD = 6.24
"""Period of the reference [s]; some pictures show one."""
BINS = 60
"""Number of velocity bins for averaging measured friction."""
FEWEST = 4
"""Fewest samples for a mean."""


def draw(log: str | Path | None, folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Identify from DATA_EMPS.mat and write the pictures into a folder; return the files."""
    found = identified(log)
    force, error = ("time [s]", "force [N]"), ("time [s]", "position error [mm]")
    charts = [
        traces_chart("emps-force", "EMPS: measured and predicted force", force, _predicted_force(found)),
        traces_chart("emps-force-left", "EMPS: measured minus predicted force", force, _force_residual(found)),
        traces_chart("emps-friction", "EMPS: friction and offset", ("velocity [mm/s]", "force [N]"), _friction_curves(found)),
        traces_chart("emps-error", "EMPS: reference minus position", error, _position_errors(found)),
        traces_chart("emps-error-left", "EMPS: measured minus simulated", ("time [s]", "position [um]"), _position_residual(found)),
    ]
    return write_charts(charts, folder, formats)


def _predicted_force(found: Identified) -> Traces:
    """Return measured and predicted force [N] over time [s], one period."""
    fit = found.symmetric
    part = fit.time <= PERIOD
    return {name: (fit.time[part], force[part]) for name, force in (("measured", fit.force), ("predicted", fit.predicted))}


def _force_residual(found: Identified) -> Traces:
    """Return measured minus predicted force [N] of both friction models over time [s]."""
    fits = {"friction alike in both directions": found.symmetric, "friction by direction": found.asymmetric}
    return {name: (fit.time, fit.force - fit.predicted) for name, fit in fits.items()}


def _friction_curves(found: Identified) -> Traces:
    """Return friction with offset [N] over velocity [mm/s]: measured (means of velocity bins) and from both models."""
    velocity, friction = _measured_friction(found)
    edges = np.linspace(velocity.min(), velocity.max(), BINS + 1)
    place = np.clip(np.digitize(velocity, edges) - 1, 0, BINS - 1)
    filled = [i for i in range(BINS) if np.count_nonzero(place == i) >= FEWEST]
    means = np.array([(velocity[place == i].mean(), friction[place == i].mean()) for i in filled])
    v = np.sort(np.r_[np.linspace(edges[0], edges[-1], 200), -1e-9, 1e-9])
    forward = v > 0.0
    alike, directed = found.symmetric, found.asymmetric
    curves = {
        "measured, minus M a": (means[:, 0], means[:, 1]),
        "equal in both directions": (v, alike["Fv"] * v + alike["Fc"] * np.sign(v) + alike["offset"]),
        "by direction": (v, np.where(forward, directed["Fv+"] * v + directed["Fc+"], directed["Fv-"] * v - directed["Fc-"])),
    }
    return {name: (1e3 * x, y) for name, (x, y) in curves.items()}


def _measured_friction(found: Identified) -> tuple[Array, Array]:
    """Return velocity, and force minus mass times acceleration, at the samples of the identification."""
    log = found.log
    motion = filtered_motion(log.position, log.period, cutoff=SETTINGS.cutoff, order=SETTINGS.order)
    part = slice(SETTINGS.dropped[0], None)
    rows = kept_samples(log.time[part].size, SETTINGS.decimation)
    friction = log.force[part] - found.symmetric["M"] * motion.acceleration[part]
    return motion.velocity[part][rows], decimate(friction, SETTINGS.decimation)


def _position_errors(found: Identified) -> Traces:
    """Return reference minus position [mm], measured and simulated, over time [s], one period."""
    log = found.log
    part = log.time <= PERIOD
    runs = {"measured": log.position, "simulated": simulate_emps(log, axis_of(found.symmetric)).position}
    return {name: (log.time[part], 1e3 * (log.reference - position)[part]) for name, position in runs.items()}


def _position_residual(found: Identified) -> Traces:
    """Return measured minus simulated position [um] for both friction models over time [s]."""
    log = found.log
    fits = {"friction alike in both directions": found.symmetric, "friction by direction": found.asymmetric}
    every = slice(None, None, SETTINGS.decimation)
    return {name: (log.time[every], 1e6 * (log.position - simulate_emps(log, axis_of(fit)).position)[every]) for name, fit in fits.items()}
