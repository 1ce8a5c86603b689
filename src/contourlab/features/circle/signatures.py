"""Signature of each cause in the radial deviation of a circle: the columns of the fit, and the search for causes that repeat.

With the angle phi from the first axis, s = 1 counter-clockwise and -1 clockwise, nominal radius R and feed v, an error (e_x, e_y) of the
axes shows as the radial deviation e_x cos phi + e_y sin phi, to first order. x reverses at phi = 0 and pi, y at pi/2 and 3 pi/2.

=======================  ====================================  ======================================================
cause                    error of the axes                     radial deviation
=======================  ====================================  ======================================================
radius, centre           r; (a, b)                             r + a cos phi + b sin phi
scaling mismatch c       e_x = c x/2, e_y = -c y/2             (c R/2) cos 2 phi
squareness q             e_x = q y                             (q R/2) sin 2 phi
servo mismatch T         e_x = -T_x v_x, e_y = -T_y v_y        s (T_x - T_y) (v/2) sin 2 phi
backlash b of x          e_x = -sgn(v_x) b/2                   s sgn(sin phi) cos phi b/2
backlash b of y          e_y = -sgn(v_y) b/2                   -s sgn(cos phi) sin phi b/2
lateral play l of x      e_y = -sgn(v_x) l/2                   s |sin phi| l/2
lateral play l of y      e_x = -sgn(v_y) l/2                   -s |cos phi| l/2
reversal spikes of x     a pulse after each reversal of x       the mean of what the others leave there
cyclic error of x        e_x = A cos(2 pi x/p + a)             A cos phi cos(2 pi R cos phi/p + a)
vibration of x           e_x = A cos(k u + a)                  A cos phi cos(k u + a), u the angle travelled
=======================  ====================================  ======================================================

Backlash may differ at both ends of an axis: b + d cos phi adds one column. At a reversal its step may take the time in which the motor
crosses the play (`contourlab.metrics.circles.crossing`): that is no spike. Cyclic error follows the position and is the same in
both senses; vibration follows time and is not. Only runs in both senses separate squareness from servo mismatch.

References
----------
ISO 230-4; Kakino, Ihara & Shinohara, "Accuracy inspection of NC machine tools by double ball bar method", Hanser, 1993. Names as in
Renishaw's ball-bar software.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.features.circle.runs import CircleRun
from contourlab.metrics.circles import play_columns

BEFORE, AFTER = math.radians(2.0), math.radians(15.0)
"""The fit leaves out samples from `BEFORE` a reversal to `AFTER` it, where the spike is."""


@dataclass(frozen=True)
class Term:
    """A cause in the fit and its columns.

    Attributes
    ----------
    cause : str
        As "backlash".
    axis : str
        Empty for a cause of both axes.
    columns : int
        Number of columns.
    length : float [m]
        Pitch of a cyclic error.
    order : float
        Cycles per turn of a vibration.
    """

    cause: str
    axis: str
    columns: int = 1
    length: float = math.nan
    order: float = math.nan


def usual_terms(axes: tuple[str, str], both: bool) -> list[Term]:
    """Return the terms of every fit; for runs in one sense squareness and servo mismatch share a column."""
    diagonal = [Term("squareness", ""), Term("servo mismatch", "")] if both else [Term("squareness or servo mismatch", "")]
    sides = [Term(cause, axis, n) for cause, n in (("backlash", 2), ("lateral play", 1)) for axis in axes]
    return [Term("radius", ""), Term("centre", "", 2), Term("scaling mismatch", ""), *diagonal, *sides]


def columns_of(term: Term, run: CircleRun, k: int, n: int, axes: tuple[str, str]) -> Array:
    """Return the columns (n_sample, term.columns) of a term in run `k` of `n`, for unit coefficients in m."""
    c, s, sense = np.cos(run.turned), np.sin(run.turned), run.sense
    first = term.axis == axes[0]
    if term.cause == "radius":
        return np.ones((len(c), 1))
    if term.cause == "centre":
        return np.column_stack([c, s])
    if term.cause == "backlash":
        return play_columns(c, s, run.clockwise, first)
    if term.cause == "cyclic error":
        along, wave = (c if first else s), 2.0 * math.pi * run.radius / term.length
        return np.column_stack([along * np.cos(wave * along), along * np.sin(wave * along)])
    if term.cause == "vibration":
        columns = np.zeros((len(c), 4 * n))
        phase = term.order * run.turned
        columns[:, 4 * k : 4 * k + 4] = np.column_stack([a * b for a in (c, s) for b in (np.cos(phase), np.sin(phase))])
        return columns
    single = {
        "scaling mismatch": 0.5 * (c * c - s * s),
        "squareness": s * c,
        "squareness or servo mismatch": s * c,
        "servo mismatch": sense * s * c,
        "lateral play": 0.5 * sense * (np.abs(s) if first else -np.abs(c)),
    }
    return np.asarray(single[term.cause][:, None])


# --- what repeats with the position (cyclic error) or with time (vibration) ---------------------------------------------------------

FEWEST_PITCHES = 1.5
"""Least number of pitches in a radius; longer ones look like backlash, scale and lateral play."""
LOWEST_ORDER = 12.0
"""Least number of vibration cycles per turn."""
PER_CYCLE = 6.0
"""Least number of samples per cycle."""
BINS = 4096
"""Places per radius or turn of the search grid, before it is capped by the samples."""


def strongest(
    runs: Sequence[CircleRun], residuals: Sequence[Array], basis: Array, axes: tuple[str, str], pitch: float | None
) -> Term | None:
    """Return the cyclic error or vibration that removes most of the residual; None for too few samples.

    Parameters
    ----------
    runs : sequence of CircleRun
        Without the samples near reversals.
    residuals : sequence of ndarray (n,) [m]
    basis : ndarray (n, p)
        Orthonormal basis of the columns that the residual was fitted with, over all runs.
    axes : (str, str)
    pitch : float [m], optional
        Lead pitch; by default it is searched.
    """
    candidates = [*_cyclic(runs, residuals, axes, pitch), *_vibrations(runs, residuals)]
    if not candidates:
        return None
    return max((refined(runs, residuals, basis, term, axes, pitch is not None) for term in candidates), key=lambda pair: pair[0])[1]


def _cyclic(runs: Sequence[CircleRun], residuals: Sequence[Array], axes: tuple[str, str], pitch: float | None) -> Iterator[Term]:
    """Yield the best pitch of each axis, by the spectrum of the residual over the position."""
    radius = runs[0].radius
    # The axis is fastest at the middle of its travel.
    most = min(len(run.turned) / abs(run.turned[-1] - run.turned[0]) for run in runs) / PER_CYCLE
    if pitch is not None:
        if not FEWEST_PITCHES <= radius / pitch <= most:
            shown = f"from {1e3 * radius / most:.4g} to {1e3 * radius / FEWEST_PITCHES:.4g} mm on this circle"
            raise ParameterError("--pitch", f"{1e3 * pitch:.6g} mm", shown)
        yield from (Term("cyclic error", axis, 2, length=pitch) for axis in axes)
        return
    for axis, along in zip(axes, (np.cos, np.sin), strict=True):
        places = np.concatenate([along(run.turned) for run in runs])
        weights = np.concatenate(residuals) * places
        wave = _peak(*_spectrum(0.5 * (places + 1.0), weights, 2.0), FEWEST_PITCHES, most)
        if wave is not None:
            yield Term("cyclic error", axis, 2, length=radius / wave)


def _vibrations(runs: Sequence[CircleRun], residuals: Sequence[Array]) -> Iterator[Term]:
    """Yield the best order of a vibration, by the spectrum of the residual over the angle travelled."""
    most = min(len(run.turned) / abs(run.turned[-1] - run.turned[0]) for run in runs) * 2.0 * math.pi / PER_CYCLE
    longest = max(abs(float(run.turned[-1] - run.turned[0])) for run in runs)
    spectra = [
        _spectrum(np.abs(run.turned - run.turned[0]) / longest, residual * along(run.turned), longest / (2.0 * math.pi))
        for run, residual in zip(runs, residuals, strict=True)
        for along in (np.cos, np.sin)
    ]
    order = _peak(spectra[0][0], np.sum([power for _, power in spectra], axis=0), LOWEST_ORDER, most)
    if order is not None:
        yield Term("vibration", "", 4 * len(runs), order=order)


def _peak(frequencies: Array, power: Array, low: float, high: float) -> float | None:
    """Return the frequency of the largest power from a low to a high one; None if no frequency lies there."""
    asked = (frequencies >= low) & (frequencies <= high)
    return float(frequencies[np.argmax(np.where(asked, power, -1.0))]) if asked.any() else None


def _spectrum(places: Array, weights: Array, span: float) -> tuple[Array, Array]:
    """Return frequencies [1/unit of span] and power of weights at places (n,) from 0 to 1, which stand for a length `span`."""
    bins = max(int(BINS * max(span, 1.0)), 16)
    table = np.bincount(np.minimum((places * bins).astype(int), bins - 1), weights, bins)
    size = 4 * (1 << (bins - 1).bit_length())
    return np.arange(size // 2 + 1) / size * bins / span, np.abs(np.fft.rfft(table, size)) ** 2


def refined(
    runs: Sequence[CircleRun], residuals: Sequence[Array], basis: Array, term: Term, axes: tuple[str, str], is_fixed: bool
) -> tuple[float, Term]:
    """Return the squares that a term removes from the residual, and the term with the best pitch or order near its own."""
    from scipy.optimize import minimize_scalar

    values = np.concatenate(residuals)

    def removed(candidate: Term) -> float:
        design = np.concatenate([columns_of(candidate, run, k, len(runs), axes) for k, run in enumerate(runs)])
        design -= basis @ (basis.T @ design)
        projected = design.T @ values
        return float(projected @ np.linalg.lstsq(design.T @ design, projected, rcond=None)[0])

    if is_fixed and term.cause == "cyclic error":
        return removed(term), term
    radius = runs[0].radius
    if term.cause == "cyclic error":
        start, width = radius / term.length, 0.25
    else:
        start, width = term.order, math.pi / min(abs(float(run.turned[-1] - run.turned[0])) for run in runs)

    def at(frequency: float) -> Term:
        return replace(term, length=radius / frequency) if term.cause == "cyclic error" else replace(term, order=frequency)

    low, high = start - width, start + width
    best = minimize_scalar(lambda frequency: -removed(at(frequency)), bounds=(low, high), method="bounded", options={"xatol": 1e-4})
    return -float(best.fun), at(float(best.x))
