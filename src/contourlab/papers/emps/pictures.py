"""The EMPS: what its pictures are drawn from."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.identification.filtered_motion import decimate, filtered_motion, kept_samples
from contourlab.papers.emps.simulation import axis_of, simulate_emps
from contourlab.papers.emps.study import SETTINGS, Identified

Array = NDArray[np.float64]
Traces = dict[str, tuple[Array, Array]]
PERIOD = 6.24
"""Of the reference [s]: what is drawn where more would hide the rest."""
BINS = 60
"""Classes of velocity in which measured friction is averaged."""
FEWEST = 4
"""Rows that make a mean."""


def predicted_force(found: Identified) -> Traces:
    """Return over time [s], one period: measured and predicted force [N]."""
    fit = found.symmetric
    part = fit.time <= PERIOD
    return {name: (fit.time[part], force[part]) for name, force in (("measured", fit.force), ("predicted", fit.predicted))}


def force_left_over(found: Identified) -> Traces:
    """Return over time [s]: what both models of friction leave of the force [N]."""
    fits = {"friction alike in both directions": found.symmetric, "friction by direction": found.asymmetric}
    return {name: (fit.time, fit.force - fit.predicted) for name, fit in fits.items()}


def friction_curves(found: Identified) -> Traces:
    """Return over velocity [mm/s]: friction with the offset [N], measured, as means over classes of velocity, and from both models."""
    velocity, friction = _measured_friction(found)
    edges = np.linspace(velocity.min(), velocity.max(), BINS + 1)
    place = np.clip(np.digitize(velocity, edges) - 1, 0, BINS - 1)
    filled = [i for i in range(BINS) if np.count_nonzero(place == i) >= FEWEST]
    means = np.array([(velocity[place == i].mean(), friction[place == i].mean()) for i in filled])
    v = np.sort(np.r_[np.linspace(edges[0], edges[-1], 200), -1e-9, 1e-9])
    forward = v > 0.0
    alike, directed = found.symmetric, found.asymmetric
    curves = {
        "measured, less M a": (means[:, 0], means[:, 1]),
        "alike in both directions": (v, alike["Fv"] * v + alike["Fc"] * np.sign(v) + alike["offset"]),
        "by direction": (v, np.where(forward, directed["Fv+"] * v + directed["Fc+"], directed["Fv-"] * v - directed["Fc-"])),
    }
    return {name: (1e3 * x, y) for name, (x, y) in curves.items()}


def _measured_friction(found: Identified) -> tuple[Array, Array]:
    """Return the force less that of the mass, at the rows of the identification."""
    log = found.log
    motion = filtered_motion(log.position, log.period, cutoff=SETTINGS.cutoff, order=SETTINGS.order)
    part = slice(SETTINGS.dropped[0], None)
    rows = kept_samples(log.time[part].size, SETTINGS.decimation)
    friction = log.force[part] - found.symmetric["M"] * motion.acceleration[part]
    return motion.velocity[part][rows], decimate(friction, SETTINGS.decimation)


def position_errors(found: Identified) -> Traces:
    """Return over time [s], one period: reference less position [mm], measured and simulated."""
    log = found.log
    part = log.time <= PERIOD
    runs = {"measured": log.position, "simulated": simulate_emps(log, axis_of(found.symmetric)).position}
    return {name: (log.time[part], 1e3 * (log.reference - position)[part]) for name, position in runs.items()}


def error_left_over(found: Identified) -> Traces:
    """Return over time [s]: measured less simulated position [um], for both models of friction."""
    log = found.log
    fits = {"friction alike in both directions": found.symmetric, "friction by direction": found.asymmetric}
    every = slice(None, None, SETTINGS.decimation)
    return {name: (log.time[every], 1e6 * (log.position - simulate_emps(log, axis_of(fit)).position)[every]) for name, fit in fits.items()}
