"""Fit the causes to measured circles: least squares away from the reversals, spikes from what is left there."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from contourlab.analysis.identification.least_squares import fit_covariance
from contourlab.arrays import Array
from contourlab.errors import ResultError
from contourlab.features.circle.runs import CircleRun
from contourlab.features.circle.signatures import AFTER, BEFORE, Term, columns_of, refined, strongest, usual_terms
from contourlab.metrics.circles import check_cover, correlated_variance, crossing, is_crossed, outside, past

MOST_PERIODIC = 4
"""Cyclic errors and vibrations together."""
CERTAIN = 5.0
"""Deviations that the amplitude of a cyclic error or vibration must exceed: it is the largest of about a thousand candidates."""
LEAST_GAIN = 0.02
"""Share of the residual's squares that a cyclic error or vibration must remove."""
LEAST_IN_BIN = 6
"""Least number of samples whose mean gives the height of a spike."""
BIN = (math.radians(0.2), math.radians(1.0))
"""Narrowest and widest angle of such a mean."""


@dataclass(frozen=True)
class ReversalSpike:
    """The spike at one reversal.

    Attributes
    ----------
    axis : str
    clockwise : bool
    angle : float [rad]
        0, pi/2, pi or 3 pi/2.
    height, deviation : float [m]
        Positive outwards.
    """

    axis: str
    clockwise: bool
    angle: float
    height: float
    deviation: float


@dataclass(frozen=True, eq=False)
class CircleFit:
    """Causes fitted to the runs around one circle.

    Attributes
    ----------
    runs : tuple of CircleRun
    axes : (str, str)
    terms : tuple of Term
    coefficients : ndarray (p,) [m]
        Of the columns of all terms, one after the other.
    covariance : ndarray (p, p) [m^2]
    spikes : tuple of ReversalSpike
    shapes : dict of str to (ndarray, ndarray) [rad, m]
        Mean spike of each axis over the angle past the reversal.
    residual : float [m]
        Root mean square of what no cause explains, away from the reversals.
    crossed : tuple of str
        Axes whose load stays at a reversal until the motor has crossed the play.
    """

    runs: tuple[CircleRun, ...]
    axes: tuple[str, str]
    terms: tuple[Term, ...]
    coefficients: Array
    covariance: Array
    spikes: tuple[ReversalSpike, ...]
    shapes: dict[str, tuple[Array, Array]]
    residual: float
    crossed: tuple[str, ...] = ()

    @property
    def both(self) -> bool:
        """Whether there are runs in both senses."""
        return len({run.clockwise for run in self.runs}) == 2

    def place(self, term: Term) -> slice:
        """Return the columns of a term."""
        start = sum(other.columns for other in self.terms[: self.terms.index(term)])
        return slice(start, start + term.columns)

    def curves(self, term: Term) -> list[Array]:
        """Return the radial deviation [m] that a term causes in each run."""
        part = self.coefficients[self.place(term)]
        curves = [columns_of(term, run, k, len(self.runs), self.axes) @ part for k, run in enumerate(self.runs)]
        if term.cause == "backlash" and term.axis in self.crossed:
            for curve, run in zip(curves, self.runs, strict=True):
                for angle, end in zip(self.reversals(term.axis), (1.0, -1.0), strict=True):
                    curve += crossing(past(run.turned, run.clockwise, angle), float(part @ (1.0, end)), run.radius)
        return curves

    def reversals(self, axis: str) -> tuple[float, float]:
        """Return where an axis reverses [rad]: at its positive and at its negative end."""
        first = 0.5 * math.pi * self.axes.index(axis)
        return first, first + math.pi

    def spike_curves(self, axis: str) -> list[Array]:
        """Return the radial deviation [m] of the mean spike of an axis in each run."""
        place, shape = self.shapes[axis]
        curves = [np.zeros(run.turned.shape) for run in self.runs]
        for curve, run in zip(curves, self.runs, strict=True):
            for angle in self.reversals(axis):
                curve += np.interp(past(run.turned, run.clockwise, angle), place, shape, left=0.0, right=0.0)
        return curves


def fit_circle(runs: Sequence[CircleRun], axes: tuple[str, str], pitch: float | None = None) -> CircleFit:
    """Fit all causes to runs around one circle.

    Parameters
    ----------
    runs : sequence of CircleRun
        One feed, one circle; one sense or both.
    axes : (str, str)
    pitch : float [m], optional
        Lead pitch of the axes; by default it is searched.

    Raises
    ------
    ResultError
        If radii or feeds differ, or a part of the circle has no samples.

    Notes
    -----
    The columns are in `contourlab.features.circle.signatures`. Spikes do not bias the fit, because samples near reversals are left out.
    Then the cyclic error or vibration that removes most of the residual is added, as long as its amplitude exceeds `CERTAIN` deviations.
    The covariance allows for the autocorrelation of the residual (`contourlab.analysis.identification.least_squares.fit_covariance`).
    """
    radii, feeds = [run.radius for run in runs], [run.feedrate for run in runs if math.isfinite(run.feedrate)]
    if max(radii) - min(radii) > 1e-9:
        raise ResultError(f"circles of {1e3 * min(radii):.6g} and {1e3 * max(radii):.6g} mm radius: give runs around one circle")
    if feeds and max(feeds) > 1.1 * min(feeds):
        raise ResultError(f"feeds of {6e4 * min(feeds):.4g} and {6e4 * max(feeds):.4g} mm/min: lag depends on it, give runs at one feed")
    uses = [outside(run.turned, run.clockwise, BEFORE, AFTER) for run in runs]
    kept = [replace(run, turned=run.turned[use], deviation=run.deviation[use]) for run, use in zip(runs, uses, strict=True)]
    for run in kept:
        check_cover(run.turned, BEFORE + AFTER)
    terms = usual_terms(axes, len({run.clockwise for run in runs}) == 2)
    coefficients, covariance, residuals = _solved(kept, terms, axes)
    for _ in range(MOST_PERIODIC):
        term = strongest(kept, residuals, _basis(kept, terms, axes), axes, pitch)
        if term is None or any(_alike(term, other) for other in terms):
            break
        more = _refined_together(kept, [*terms, term], axes, pitch)
        solved = _solved(kept, more, axes)
        size, block = solved[0][-term.columns :], solved[1][-term.columns :, -term.columns :]
        gained = 1.0 - _squares(solved[2]) / max(_squares(residuals), 1e-300)
        if gained < LEAST_GAIN or not float(size @ np.linalg.pinv(block) @ size) > CERTAIN**2 + term.columns:
            break
        terms, (coefficients, covariance, residuals) = more, solved
    residual = float(np.sqrt(np.mean(np.concatenate(residuals) ** 2)))
    fit = CircleFit(tuple(runs), axes, tuple(terms), coefficients, covariance, (), {}, residual)
    return _with_spikes(fit, residuals)


def _squares(residuals: Sequence[Array]) -> float:
    return sum(float(residual @ residual) for residual in residuals)


def _design(kept: Sequence[CircleRun], terms: Sequence[Term], axes: tuple[str, str]) -> list[Array]:
    """Return the columns of all terms in each run."""
    return [np.column_stack([columns_of(term, run, k, len(kept), axes) for term in terms]) for k, run in enumerate(kept)]


def _basis(kept: Sequence[CircleRun], terms: Sequence[Term], axes: tuple[str, str]) -> Array:
    return np.asarray(np.linalg.qr(np.concatenate(_design(kept, terms, axes)))[0])


def _solved(kept: Sequence[CircleRun], terms: Sequence[Term], axes: tuple[str, str]) -> tuple[Array, Array, list[Array]]:
    """Return coefficients, their covariance, and the residual of each run."""
    designs = _design(kept, terms, axes)
    solution = np.linalg.lstsq(np.concatenate(designs), np.concatenate([run.deviation for run in kept]), rcond=None)[0]
    residuals = [run.deviation - design @ solution for run, design in zip(kept, designs, strict=True)]
    covariance = fit_covariance([design[:, None, :] for design in designs], [residual[:, None] for residual in residuals])
    deviations = np.where(np.isfinite(covariance.deviations), covariance.deviations, 0.0)
    return np.asarray(solution), covariance.correlation * np.outer(deviations, deviations), residuals


def _alike(term: Term, other: Term) -> bool:
    """Return whether two terms differ by less than the fit resolves."""
    if (term.cause, term.axis) != (other.cause, other.axis):
        return False
    return 0.8 < term.length / other.length < 1.25 if term.cause == "cyclic error" else abs(term.order - other.order) < 8.0


def _refined_together(kept: Sequence[CircleRun], terms: list[Term], axes: tuple[str, str], pitch: float | None) -> list[Term]:
    """Return the terms with the pitch or order of each periodic one fitted beside the others."""
    for i, term in enumerate(terms):
        if term.cause in ("cyclic error", "vibration"):
            others = [*terms[:i], *terms[i + 1 :]]
            basis = _basis(kept, others, axes)
            values = np.concatenate([run.deviation for run in kept])
            left = np.split(values - basis @ (basis.T @ values), np.cumsum([len(run.turned) for run in kept])[:-1])
            terms = [*terms[:i], refined(kept, left, basis, term, axes, pitch is not None)[1], *terms[i + 1 :]]
    return terms


_Window = tuple[int, float, Array, Array]
"""Reversal of a run: number of the run, angle, mean residual in each bin past it, and the variance of this mean."""


def _with_spikes(fit: CircleFit, residuals: Sequence[Array]) -> CircleFit:
    """Add the spikes: means of the residual over small angles past each reversal.

    The step of the play comes at once, or after the time that the motor needs to cross it.

    The height of a spike is read where the other spikes of the axis are highest, so that noise does not look like a spike. A mean cuts
    off a sharp peak: a parabola through three means gives its top, and how much it adds counts as deviation.
    """
    per_angle = min(len(run.turned) / abs(float(run.turned[-1] - run.turned[0])) for run in fit.runs)
    width = float(np.clip(LEAST_IN_BIN / per_angle, *BIN))
    edges = np.linspace(-BEFORE, AFTER, round((BEFORE + AFTER) / width) + 1)
    middle = 0.5 * (edges[1:] + edges[:-1])
    spikes: list[ReversalSpike] = []
    shapes = {}
    for axis in fit.axes:
        windows = _windows(fit, axis, residuals, edges)
        gap = next(float(fit.coefficients[fit.place(term)][0]) for term in fit.terms if (term.cause, term.axis) == ("backlash", axis))
        if is_crossed(middle, np.mean([mean for _, _, mean, _ in windows], axis=0), gap, fit.runs[0].radius):
            fit = replace(fit, crossed=(*fit.crossed, axis))
            windows = _windows(fit, axis, residuals, edges)
        table = np.array([mean for _, _, mean, _ in windows])
        shapes[axis] = middle, table.mean(axis=0)
        for i, (k, angle, mean, variance) in enumerate(windows):
            at, weights = _top(np.delete(table, i, axis=0).mean(axis=0))
            height = float(weights @ mean[at])
            deviation = math.sqrt(float(weights**2 @ variance[at]) + (height - float(mean[at][1])) ** 2)
            spikes.append(ReversalSpike(axis, fit.runs[k].clockwise, angle, height, deviation))
    return replace(fit, spikes=tuple(spikes), shapes=shapes)


def _top(shape: Array) -> tuple[slice, Array]:
    """Return the three bins around the peak of a shape, and their weights in the top of the parabola with these means."""
    at = int(np.argmax(np.abs(shape[1:-1]))) + 1
    slope, bend = 0.5 * (shape[at + 1] - shape[at - 1]), shape[at + 1] + shape[at - 1] - 2.0 * shape[at]
    top = float(np.clip(-slope / bend, -0.5, 0.5)) if bend * shape[at] < 0.0 else 0.0
    outer = 0.5 * (top * top - 1.0 / 12.0)
    return slice(at - 1, at + 2), np.array([outer - 0.5 * top, 1.0 - 2.0 * outer, outer + 0.5 * top])


def _windows(fit: CircleFit, axis: str, residuals: Sequence[Array], edges: Array) -> list[_Window]:
    """Return what the causes leave at each reversal of an axis."""
    left = [run.deviation.copy() for run in fit.runs]
    for term in fit.terms:
        for rest, curve in zip(left, fit.curves(term), strict=True):
            rest -= curve
    return [_window(fit, k, angle, left[k], residuals[k], edges) for k in range(len(fit.runs)) for angle in fit.reversals(axis)]


def _window(fit: CircleFit, k: int, angle: float, left: Array, residual: Array, edges: Array) -> _Window:
    run, n = fit.runs[k], len(edges) - 1
    gone = past(run.turned, run.clockwise, angle)
    near = np.flatnonzero((gone >= edges[0]) & (gone < edges[-1]))
    bins = np.clip(np.searchsorted(edges, gone[near], side="right") - 1, 0, n - 1)
    count = np.maximum(np.bincount(bins, minlength=n), 1)
    part = replace(run, turned=run.turned[near], deviation=run.deviation[near])
    rows = np.column_stack([columns_of(term, part, k, len(fit.runs), fit.axes) for term in fit.terms])
    base = np.array([np.bincount(bins, column, n) / count for column in rows.T]).T
    variance = correlated_variance(residual, len(residual)) / count + np.einsum("ij,jk,ik->i", base, fit.covariance, base)
    return k, angle, np.bincount(bins, left[near], n) / count, np.maximum(variance, 0.0)
