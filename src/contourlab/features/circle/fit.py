"""Fit the causes to measured circles: least squares away from the reversals, spikes from what is left there.

The columns of the fit are the signatures of the causes in the radial deviation.

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

from contourlab.analysis.identification.least_squares import fit_records
from contourlab.arrays import Array
from contourlab.errors import ParameterError, ResultError
from contourlab.features.circle.runs import CircleRun
from contourlab.metrics.circles import AFTER, BEFORE, check_cover, correlated_variance, crossing, is_crossed, outside, past, play_columns

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


@dataclass(frozen=True, eq=False)
class Runs:
    """Runs around one circle, of two axes.

    Attributes
    ----------
    runs : tuple of CircleRun
    axes : (str, str)
    """

    runs: tuple[CircleRun, ...]
    axes: tuple[str, str]

    @property
    def both(self) -> bool:
        """Whether there are runs in both senses."""
        return len({run.clockwise for run in self.runs}) == 2

    @property
    def deviation(self) -> Array:
        """The radial deviation of all runs [m]."""
        return np.concatenate([run.deviation for run in self.runs])

    @property
    def fastest(self) -> float:
        """Least number of samples per radian of a run."""
        return min(len(run.turned) / abs(float(run.turned[-1] - run.turned[0])) for run in self.runs)

    def columns_at(self, term: Term, run: CircleRun, k: int) -> Array:
        """Return the columns (n_sample, term.columns) of a term in a part of run `k`, for unit coefficients in m."""
        c, s, sense = np.cos(run.turned), np.sin(run.turned), run.sense
        first = term.axis == self.axes[0]
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
            columns = np.zeros((len(c), 4 * len(self.runs)))
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

    def columns(self, term: Term) -> list[Array]:
        """Return the columns of a term in each run."""
        return [self.columns_at(term, run, k) for k, run in enumerate(self.runs)]

    def designs(self, terms: Sequence[Term]) -> list[Array]:
        """Return the columns of all terms in each run."""
        return [np.column_stack(parts) for parts in zip(*map(self.columns, terms), strict=True)]

    def basis(self, terms: Sequence[Term]) -> Array:
        """Return an orthonormal basis of the columns of all terms, over all runs."""
        return np.asarray(np.linalg.qr(np.concatenate(self.designs(terms)))[0])

    def solved(self, terms: Sequence[Term]) -> tuple[Array, Array, list[Array]]:
        """Return coefficients, their covariance, and the residual of each run."""
        solution, covariance, residuals = fit_records(self.designs(terms), [run.deviation for run in self.runs])
        deviations = np.where(np.isfinite(covariance.deviations), covariance.deviations, 0.0)
        return solution, covariance.correlation * np.outer(deviations, deviations), residuals


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
class CircleFit(Runs):
    """Causes fitted to the runs around one circle.

    Attributes
    ----------
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

    terms: tuple[Term, ...]
    coefficients: Array
    covariance: Array
    spikes: tuple[ReversalSpike, ...]
    shapes: dict[str, tuple[Array, Array]]
    residual: float
    crossed: tuple[str, ...] = ()

    def place(self, term: Term) -> slice:
        """Return the columns of a term."""
        start = sum(other.columns for other in self.terms[: self.terms.index(term)])
        return slice(start, start + term.columns)

    def curves(self, term: Term) -> list[Array]:
        """Return the radial deviation [m] that a term causes in each run."""
        part = self.coefficients[self.place(term)]
        curves = [columns @ part for columns in self.columns(term)]
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
    Spikes do not bias the fit, because samples near reversals are left out.
    Then the cyclic error or vibration that removes most of the residual is added, as long as its amplitude exceeds `CERTAIN` deviations.
    The covariance allows for the autocorrelation of the residual (`contourlab.analysis.identification.least_squares.fit_covariance`).
    """
    radii, feeds = [run.radius for run in runs], [run.feedrate for run in runs if math.isfinite(run.feedrate)]
    if max(radii) - min(radii) > 1e-9:
        raise ResultError(f"circles of {1e3 * min(radii):.6g} and {1e3 * max(radii):.6g} mm radius: give runs around one circle")
    if feeds and max(feeds) > 1.1 * min(feeds):
        raise ResultError(f"feeds of {6e4 * min(feeds):.4g} and {6e4 * max(feeds):.4g} mm/min: lag depends on it, give runs at one feed")
    uses = [outside(run.turned, run.clockwise, BEFORE, AFTER) for run in runs]
    thinned = [replace(run, turned=run.turned[use], deviation=run.deviation[use]) for run, use in zip(runs, uses, strict=True)]
    for run in thinned:
        check_cover(run.turned, BEFORE + AFTER)
    kept = Runs(tuple(thinned), axes)
    terms = usual_terms(axes, kept.both)
    coefficients, covariance, residuals = kept.solved(terms)
    for _ in range(MOST_PERIODIC):
        term = _strongest(kept, residuals, terms, pitch)
        if term is None or any(_alike(term, other) for other in terms):
            break
        more = _refined_together(kept, [*terms, term], pitch)
        solved = kept.solved(more)
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


def _alike(term: Term, other: Term) -> bool:
    """Return whether two terms differ by less than the fit resolves."""
    if (term.cause, term.axis) != (other.cause, other.axis):
        return False
    return 0.8 < term.length / other.length < 1.25 if term.cause == "cyclic error" else abs(term.order - other.order) < 8.0


# --- what repeats with the position (cyclic error) or with time (vibration) ---------------------------------------------------------

FEWEST_PITCHES = 1.5
"""Least number of pitches in a radius; longer ones look like backlash, scale and lateral play."""
LOWEST_ORDER = 12.0
"""Least number of vibration cycles per turn."""
PER_CYCLE = 6.0
"""Least number of samples per cycle."""
BINS = 4096
"""Places per radius or turn of the search grid, before it is capped by the samples."""


def _strongest(kept: Runs, residuals: Sequence[Array], terms: Sequence[Term], pitch: float | None) -> Term | None:
    """Return the cyclic error or vibration that removes most of the residuals of some terms; None for too few samples."""
    candidates, basis = [*_cyclic(kept, residuals, pitch), *_vibrations(kept, residuals)], kept.basis(terms)
    pairs = (_refined(kept, np.concatenate(residuals), basis, term, pitch is not None) for term in candidates)
    return max(pairs, key=lambda pair: pair[0], default=(0.0, None))[1]


def _cyclic(kept: Runs, residuals: Sequence[Array], pitch: float | None) -> Iterator[Term]:
    """Yield the best pitch of each axis, by the spectrum of the residual over the position."""
    # The axis is fastest at the middle of its travel.
    radius, most = kept.runs[0].radius, kept.fastest / PER_CYCLE
    if pitch is not None:
        if not FEWEST_PITCHES <= radius / pitch <= most:
            shown = f"from {1e3 * radius / most:.4g} to {1e3 * radius / FEWEST_PITCHES:.4g} mm on this circle"
            raise ParameterError("--pitch", f"{1e3 * pitch:.6g} mm", shown)
        yield from (Term("cyclic error", axis, 2, length=pitch) for axis in kept.axes)
        return
    for axis, along in zip(kept.axes, (np.cos, np.sin), strict=True):
        places = np.concatenate([along(run.turned) for run in kept.runs])
        wave = _peak(*_spectrum(0.5 * (places + 1.0), np.concatenate(residuals) * places, 2.0), FEWEST_PITCHES, most)
        if wave is not None:
            yield Term("cyclic error", axis, 2, length=radius / wave)


def _vibrations(kept: Runs, residuals: Sequence[Array]) -> Iterator[Term]:
    """Yield the best order of a vibration, by the spectrum of the residual over the angle travelled."""
    most, longest = kept.fastest * 2.0 * math.pi / PER_CYCLE, max(abs(float(run.turned[-1] - run.turned[0])) for run in kept.runs)
    spectra = [
        _spectrum(np.abs(run.turned - run.turned[0]) / longest, residual * along(run.turned), longest / (2.0 * math.pi))
        for run, residual in zip(kept.runs, residuals, strict=True)
        for along in (np.cos, np.sin)
    ]
    order = _peak(spectra[0][0], np.sum([power for _, power in spectra], axis=0), LOWEST_ORDER, most)
    if order is not None:
        yield Term("vibration", "", 4 * len(kept.runs), order=order)


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


def _refined(kept: Runs, residual: Array, basis: Array, term: Term, is_fixed: bool) -> tuple[float, Term]:
    """Return the squares that a term removes from the residual, and the term with the best pitch or order near its own.

    Parameters
    ----------
    residual : ndarray (n,) [m]
        Of all runs.
    basis : ndarray (n, p)
        Of the columns that the residual was fitted with.
    is_fixed : bool
        Whether the pitch is given.
    """
    from scipy.optimize import minimize_scalar

    def removed(candidate: Term) -> float:
        design = np.concatenate(kept.columns(candidate))
        design -= basis @ (basis.T @ design)
        projected = design.T @ residual
        return float(projected @ np.linalg.lstsq(design.T @ design, projected, rcond=None)[0])

    is_cyclic, radius = term.cause == "cyclic error", kept.runs[0].radius
    if is_fixed and is_cyclic:
        return removed(term), term
    if is_cyclic:
        start, width = radius / term.length, 0.25
    else:
        start, width = term.order, math.pi / min(abs(float(run.turned[-1] - run.turned[0])) for run in kept.runs)

    def at(frequency: float) -> Term:
        return replace(term, length=radius / frequency) if is_cyclic else replace(term, order=frequency)

    bounds = start - width, start + width
    best = minimize_scalar(lambda frequency: -removed(at(frequency)), bounds=bounds, method="bounded", options={"xatol": 1e-4})
    return -float(best.fun), at(float(best.x))


def _refined_together(kept: Runs, terms: Sequence[Term], pitch: float | None) -> list[Term]:
    """Return the terms with the pitch or order of each periodic one fitted beside the others."""
    terms = [*terms]
    for i, term in enumerate(terms):
        if term.cause in ("cyclic error", "vibration"):
            basis = kept.basis([*terms[:i], *terms[i + 1 :]])
            terms[i] = _refined(kept, kept.deviation - basis @ (basis.T @ kept.deviation), basis, term, pitch is not None)[1]
    return terms


# --- spikes --------------------------------------------------------------------------------------------------------------------------

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
    rows = np.column_stack([fit.columns_at(term, part, k) for term in fit.terms])
    base = np.array([np.bincount(bins, column, n) / count for column in rows.T]).T
    variance = correlated_variance(residual, len(residual)) / count + np.einsum("ij,jk,ik->i", base, fit.covariance, base)
    return k, angle, np.bincount(bins, left[near], n) / count, np.maximum(variance, 0.0)
