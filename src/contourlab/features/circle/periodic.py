"""Search for what repeats with the position (cyclic error) or with time (vibration) in the residual of a circle."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.features.circle.runs import CircleRun
from contourlab.features.circle.signatures import Term, columns_of

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
        waves, power = _spectrum(0.5 * (places + 1.0), weights, 2.0)
        asked = (waves >= FEWEST_PITCHES) & (waves <= most)
        if asked.any():
            best = int(np.argmax(np.where(asked, power, -1.0)))
            yield Term("cyclic error", axis, 2, length=radius / float(waves[best]))


def _vibrations(runs: Sequence[CircleRun], residuals: Sequence[Array]) -> Iterator[Term]:
    """Yield the best order of a vibration, by the spectrum of the residual over the angle travelled."""
    most = min(len(run.turned) / abs(run.turned[-1] - run.turned[0]) for run in runs) * 2.0 * math.pi / PER_CYCLE
    longest = max(abs(float(run.turned[-1] - run.turned[0])) for run in runs)
    total: Array | None = None
    orders = np.zeros(0)
    for run, residual in zip(runs, residuals, strict=True):
        gone = np.abs(run.turned - run.turned[0]) / longest
        for along in (np.cos, np.sin):
            orders, power = _spectrum(gone, residual * along(run.turned), longest / (2.0 * math.pi))
            total = power if total is None else total + power
    asked = (orders >= LOWEST_ORDER) & (orders <= most)
    if total is not None and asked.any():
        best = int(np.argmax(np.where(asked, total, -1.0)))
        yield Term("vibration", "", 4 * len(runs), order=float(orders[best]))


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
