"""Convergence of learning, predicted before the first trial, and rules for zero-phase learning: width, gain, passes and lead.

Factors over frequency are those of `contourlab.analysis.learning.factors`.

Over a whole trial, with the turning normal, an operator maps a table's deviation from its limit to the next trial's. Its largest singular
value bounds the growth of the error in one trial; its spectral radius decides convergence. Both are computed without a matrix, by applying
the trial and its transpose to tables.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.learning.factors import (
    HEARD,
    FrequencyLearning,
    LawKernels,
    averaging,
    frequency_learning,
    law_kernels,
    law_model,
    lifted_problem,
    next_table,
    peak,
)
from contourlab.analysis.linear.coupled_loop import CoupledLoop, TrialMap, coupled_loop
from contourlab.analysis.linear.margins import doubling
from contourlab.arrays import Array, Complex
from contourlab.components.learning.law import LearningLaw, LearningProblem, ZeroPhase
from contourlab.errors import ComponentError, refuse
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.loop.machine import Controller, Machine

WIDEST = 400
"""Longest kernel of a law [samples] that is exact at the ends of a trial; with a longer one the law sees zeros beyond the ends."""
TOLERANCE = 1e-4
TRIALS = 40
LONG = 4000
"""Entries of a table above which repeated trials give the radius better than Arnoldi's method."""


SHORT = 1000
"""Entries of a table up to which the whole matrix is formed for its singular values."""


@dataclass(frozen=True, eq=False)
class LiftedLearning:
    """Growth of the error from trial to trial on one path.

    Attributes
    ----------
    radius : float
        Spectral radius: below 1 learning converges.
    norm : float
        Largest singular value: below 1 every trial reduces any error; nan for a law that learns through a model, whose transpose is
        unknown.
    singular_values : ndarray (n,) or None
        In falling order; None for a table of more than `SHORT` entries.
    """

    radius: float
    norm: float
    singular_values: Array | None = None


class TrialOperator:
    """Map of a table's deviation u (n_sample, n_axis) from its limit to the deviation one trial later.

    Parameters
    ----------
    tangents : array_like (n_sample, n_axis)
        Direction of the path at each sample.
    """

    def __init__(self, loop: CoupledLoop, law: LearningLaw, tangents: ArrayLike) -> None:
        t = np.asarray(tangents, dtype=float)
        self.map, self.law, self.loop = TrialMap(loop, t, law.target), law, loop
        self.problem = lifted_problem(law, loop, t)
        self.shape = t.shape

    def __call__(self, u: Array) -> Array:
        """Return the deviation after a trial (n_sample, n_axis)."""
        error, feedback = self.map.forward(u)
        heard = u, error, self.problem.across(error), feedback
        if self._reach is None:
            return next_table(self.law, self.problem, dict(zip(HEARD, heard, strict=True)))
        return np.asarray(sum(part @ signal for part, signal in zip(self._reach, heard, strict=True) if part is not None))

    def transposed(self, v: Array) -> Array:
        """Return the transpose on v (n_sample, n_axis).

        Raises
        ------
        ComponentError
            If the law learns through a model.
        """
        if self._reach is None:
            raise ComponentError(f"learning {self.law.kind} learns through a model: its transpose is unknown")
        table, error, contour, feedback = (np.zeros_like(v) if part is None else np.asarray(part.T @ v) for part in self._reach)
        return table + self.map.transposed(error + self.problem.across(contour), feedback)

    @cached_property
    def _reach(self) -> list[Any] | None:
        """The law as a matrix over the samples for each of `HEARD`, None for zero; axes do not mix. None for a law with a model."""
        if law_model(self.law, self.loop) is not None:
            return None
        kernels = law_kernels(self.law, self.loop)
        matrix_of = _ring if max(-kernels.support[0], kernels.support[1]) > WIDEST else _band
        return [matrix_of(self.law, self.problem, kernels, name) if kernels.kernels[name].any() else None for name in HEARD]

    def matrix(self) -> Array:
        """Return the operator as a matrix (n, n), n = n_sample n_axis: for short trials."""
        return np.column_stack([self(unit.reshape(self.shape)).ravel() for unit in np.eye(self.shape[0] * self.shape[1])])

    def norm(self, steps: int = 20) -> float:
        """Return the largest singular value by Golub and Kahan's bidiagonalisation: a close lower bound after some tens of steps."""
        u = np.random.default_rng(1).normal(size=self.shape)
        u = u / np.linalg.norm(u)
        # Orthogonalised against all earlier vectors, or the largest value repeats.
        lefts: list[Array] = []
        rights: list[Array] = [u]
        columns: list[tuple[float, float]] = []
        for _ in range(min(steps, u.size)):
            left = _apart(self(rights[-1]), lefts)
            alpha = float(np.linalg.norm(left))
            if alpha < 1e-14:
                break
            lefts.append(left / alpha)
            right = _apart(self.transposed(lefts[-1]), rights)
            beta = float(np.linalg.norm(right))
            columns.append((alpha, beta))
            if beta < 1e-14:
                break
            rights.append(right / beta)
        if not columns:
            return 0.0
        return float(np.linalg.norm(np.diag([a for a, _ in columns]) + np.diag([b for _, b in columns[:-1]], 1), 2))

    def radius(self) -> float:
        """Return the spectral radius: by Arnoldi's method for short trials, by repeated trials of a random table for long ones."""
        from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigs

        n = self.shape[0] * self.shape[1]
        start = np.random.default_rng(1).normal(size=n)
        if n > LONG:
            return self.growth(start.reshape(self.shape))
        operator = LinearOperator((n, n), matvec=lambda x: self(np.asarray(x, dtype=float).reshape(self.shape)).ravel(), dtype=float)
        try:
            eigenvalues = eigs(operator, k=1, which="LM", v0=start, ncv=min(24, n), maxiter=12, tol=TOLERANCE, return_eigenvectors=False)
            return float(np.abs(eigenvalues).max())
        except ArpackNoConvergence:
            return self.growth(start.reshape(self.shape))

    def growth(self, start: Array, trials: int = TRIALS) -> float:
        """Return the mean growth factor per trial over the last third of `trials`."""
        u, sizes = start, []
        for _ in range(trials):
            u = self(u)
            sizes.append(float(np.linalg.norm(u)))
            if sizes[-1] == 0.0:
                return 0.0
            u = u / sizes[-1]
        return float(np.exp(np.mean(np.log(sizes[-trials // 3 :]))))


def _apart(vector: Array, others: list[Array]) -> Array:
    """Return the part of a vector that is orthogonal to unit vectors."""
    for other in others:
        vector = vector - float(np.vdot(other, vector)) * other
    return vector


def _band(law: LearningLaw, problem: LearningProblem, kernels: LawKernels, name: str) -> Any:
    """Return the matrix of one input of a law, exact at the ends, from combs of impulses whose responses do not overlap."""
    from scipy.sparse import coo_matrix

    n_sample, row = len(problem.tangent), np.arange(len(problem.tangent))
    step = kernels.support[1] - kernels.support[0] + 1
    entries = []
    for first in range(min(step, n_sample)):
        comb = np.zeros(problem.tangent.shape)
        comb[first::step] = 1.0
        answer = next_table(law, problem, {name: comb})[:, 0]
        # The impulse that reaches a sample lies within the support about it.
        column = first + step * np.ceil((row - kernels.support[1] - first) / step).astype(int)
        live = (answer != 0.0) & (column >= 0) & (column < n_sample)
        entries.append((answer[live], row[live], column[live]))
    values, rows, columns = map(np.concatenate, zip(*entries, strict=True))
    return coo_matrix((values, (rows, columns)), shape=(n_sample, n_sample)).tocsr()


def _ring(law: LearningLaw, problem: LearningProblem, kernels: LawKernels, name: str) -> Any:
    """Return the convolution with a long kernel of a law as a matrix, with zeros beyond the ends of a trial."""
    from scipy.fft import irfft, next_fast_len, rfft
    from scipy.sparse.linalg import LinearOperator

    n_sample, (first, last) = len(problem.tangent), kernels.support
    length = int(next_fast_len(n_sample + last - first + 1, real=True))
    ring, sample = np.zeros(length), np.arange(max(first, -n_sample), min(last, n_sample) + 1)
    ring[sample] = kernels.kernels[name][sample + kernels.centre, 0, 0]
    response = rfft(ring)

    def through(signal: Array, by: Complex) -> Array:
        return np.asarray(irfft(rfft(signal, length, axis=0) * by[:, None], length, axis=0)[:n_sample])

    forward, back = (lambda x: through(x, response)), (lambda x: through(x, response.conj()))
    return LinearOperator((n_sample, n_sample), matvec=forward, rmatvec=back, matmat=forward, rmatmat=back, dtype=float)


def lifted_learning(loop: CoupledLoop, law: LearningLaw, tangents: ArrayLike) -> LiftedLearning:
    """Return the growth of errors from trial to trial on a path, with its turning normal.

    Parameters
    ----------
    tangents : array_like (n_sample, n_axis)
        Direction of the path at each sample; 30 000 samples take seconds.
    """
    operator = TrialOperator(loop, law, tangents)
    norm = math.nan if law_model(law, loop) is not None else operator.norm()
    short = math.prod(operator.shape) <= SHORT
    values = np.asarray(np.linalg.svd(operator.matrix(), compute_uv=False), dtype=float) if short else None
    return LiftedLearning(operator.radius(), norm, values)


Closed = Callable[[Array], Complex]
GROWTH = 1e-6
"""Numerical tolerance of a factor of 1."""
RUNAWAY = 10.0
"""Learning runs away if an error doubles within this many trials."""


@dataclass(frozen=True)
class LearningDesign:
    """Parameters of zero-phase learning.

    Attributes
    ----------
    gain : float
        gamma.
    half_width : int
        M.
    passes : int
    lead : float [s]
    bandwidth : float [rad/s]
        First zero of the average: frequencies below it are learned.
    worst_frequency : float [rad/s]
    worst_factor : float
        Largest ``|1 - gamma H T|``. With a delay in the loop the sign is wrong at some frequencies above the first zero. Without a filter
        that cuts them off, a factor slightly above 1 is the best possible.
    """

    gain: float
    half_width: int
    passes: int
    lead: float
    bandwidth: float
    worst_frequency: float
    worst_factor: float


def first_zero(half_width: int, servo_period: float) -> float:
    """Return the frequency [rad/s] of the first zero of H_M, 2 pi/((2 M + 1) T_s); the Nyquist frequency for M = 0.

    >>> round(first_zero(11, 1e-3) / (2 * math.pi), 3)
    43.478
    """
    return 2.0 * math.pi / (max(2 * half_width + 1, 2) * servo_period)


def quarter_turn(closed: Closed, servo_period: float, lead: float = 0.0) -> float:
    """Return the lowest frequency [rad/s] at which the phase of T, with a lead [s], reaches a quarter turn; else the Nyquist frequency.

    Parameters
    ----------
    closed : callable
        Gives T (n,) at frequencies (n,) [rad/s].
    """
    from scipy.optimize import brentq

    top = math.pi / servo_period

    def real(w: Array) -> Array:
        return np.asarray((closed(w) * np.exp(1j * w * lead)).real)

    w = np.minimum(np.unique(np.concatenate([np.geomspace(1e-4 * top, top, 1500), np.linspace(1e-3 * top, top, 1500)])), top)
    wrong = np.flatnonzero(real(w) <= 0.0)
    if not wrong.size:
        return top
    i = int(wrong[0])
    # Pass all lower frequencies as well: `closed` may unwrap the phase.
    return float(w[0] if i == 0 else brentq(lambda x: float(real(np.append(w[:i], x))[-1]), w[i - 1], w[i]))


def largest_gain(closed: Closed, average: Callable[[Array], Complex], top: float) -> float:
    """Return the smallest 2 cos(arg H T)/|H T| up to a frequency [rad/s]: the gain at which |1 - gamma H T| reaches 1 below it."""
    w = np.linspace(1e-4 * top, top, 4001)[:-1]
    open_ = average(w) * closed(w)
    return float(np.min(2.0 * open_.real / np.maximum(np.abs(open_) ** 2, 1e-300)))


def worst_zero_phase(
    closed: Closed, servo_period: float, gain: float, half_width: int, passes: int = 1, lead: float = 0.0
) -> tuple[float, float]:
    """Return the frequency [rad/s] and value of the largest |1 - gamma H T| up to the Nyquist frequency."""
    top, n = math.pi / servo_period, 2 * half_width + 1
    lobe = 2.0 * top / n

    def factor(w: Array) -> Array:
        return np.abs(1.0 - gain * averaging(w, servo_period, half_width, passes, lead) * closed(w))

    w = np.unique(np.concatenate([np.geomspace(1e-4 * top, top, 600), np.arange(1, min(10 * n, 4000)) * lobe / 20.0]))
    w = w[w <= top]
    return peak(factor, w, factor(w))


def design_zero_phase(closed: Closed, servo_period: float) -> LearningDesign:
    """Return gain, half width, passes and lead by rule.

    The lead maximises the frequency at which the phase of T reaches a quarter turn; the first zero of the average lies below it. The gain
    is a share of the largest that converges below the zero. A second pass is used if the side lobes of a single one amplify. If that is not
    enough, the average is widened until no frequency grows by more than `SMALL` per trial.

    Parameters
    ----------
    closed : callable
        T = P C/(1 + P C), delay included, (n,) at frequencies (n,) [rad/s]; with several axes, T of the axis with the most lag.
    servo_period : float [s], > 0
    """
    leads = _leads(closed, servo_period)
    turns = [quarter_turn(closed, servo_period, lead) for lead in leads]
    # The smallest lead that is almost the best.
    best = next(i for i, turn in enumerate(turns) if turn >= 0.98 * max(turns))
    lead, turn = leads[best], turns[best]
    half_width = max(0, math.ceil(0.5 * (2.0 * math.pi / (turn * servo_period) - 1.0)))
    while True:
        made = [_design(closed, servo_period, half_width, passes, lead) for passes in (1, 2)]
        good = [design for design in made if design.worst_factor <= 1.0 + SMALL]
        if good or half_width > 100_000:
            # One pass learns more below its zero.
            return good[0] if good else min(made, key=lambda design: design.worst_factor)
        half_width = half_width + 1 + half_width // 10


def _leads(closed: Closed, servo_period: float) -> list[float]:
    """Return at most 24 leads of whole periods, from none to twice the delay of T at low frequencies."""
    w = np.array([1e-3, 2e-3]) * math.pi / servo_period
    phase = np.unwrap(np.angle(closed(w)))
    lag = max(0.0, -float(phase[1] - phase[0]) / float(w[1] - w[0]))
    most = math.ceil(2.0 * lag / servo_period)
    return [servo_period * int(n) for n in np.unique(np.linspace(0, most, min(most + 1, 24)).astype(int))]


def _design(closed: Closed, servo_period: float, half_width: int, passes: int, lead: float) -> LearningDesign:
    zero = min(first_zero(half_width, servo_period), math.pi / servo_period)
    gain = min(max(SHARE * largest_gain(closed, lambda w: averaging(w, servo_period, half_width, passes, lead), zero), 1e-3), 1.0)
    return LearningDesign(gain, half_width, passes, lead, zero, *worst_zero_phase(closed, servo_period, gain, half_width, passes, lead))


SMALL = 1e-3
"""Growth per trial that a rule accepts."""
MOST_WIDER = 10
"""Largest number of times that the average is widened for a coupling."""
SHARE = 0.4
"""Share of the largest converging gain that the rule uses."""


@dataclass(frozen=True, eq=False)
class LearningAnalysis:
    """Prediction of learning.

    Attributes
    ----------
    law : LearningLaw
    servo_period : float [s]
    response : FrequencyLearning
        Factors of a trial over frequency, the worst over all directions of the path.
    lifted : LiftedLearning or None
        Over a whole trial on a given path; None without a path.
    zero : float [rad/s]
        First zero of the law's average; nan for a law without one.
    design : LearningDesign or None
        Parameters by rule, if zero-phase learning amplifies and a rule finds any.
    """

    law: LearningLaw
    servo_period: float
    response: FrequencyLearning
    lifted: LiftedLearning | None
    zero: float
    design: LearningDesign | None

    @property
    def worst_frequency(self) -> float:
        """Frequency [rad/s] at which learning converges most slowly, or diverges fastest."""
        return self.response.worst_radius[0]

    @property
    def worst_factor(self) -> float:
        """Asymptotic factor per trial at `worst_frequency`."""
        return self.response.worst_radius[1]

    @property
    def converges(self) -> bool:
        """Whether no error grows over many trials, at any frequency or on the given path."""
        return self.worst_factor <= 1.0 + GROWTH and (self.lifted is None or self.lifted.radius <= 1.0 + 1e-4)

    @property
    def monotone(self) -> bool:
        """Whether no frequency grows in any trial. At the ends of a trial, and where the path turns, `lifted.norm` may still exceed 1."""
        return self.response.worst_norm[1] <= 1.0 + GROWTH

    @property
    def findings(self) -> Iterator[Finding]:
        """Predicted faults, and better settings from the design rule."""
        design, factor, (at, size) = self.design, self.worst_factor, self.response.worst_norm
        grows = factor > 1.0 + GROWTH
        if grows:
            code, hertz = "CL315" if doubling(factor) <= RUNAWAY else "CL310", self.worst_frequency / (2.0 * math.pi)
            yield finding(code, frequency=hertz, growth=factor - 1.0, doubling=doubling(factor))
        elif not self.monotone:
            yield finding("CL311", frequency=at / (2.0 * math.pi), growth=size - 1.0)
        if design is not None and design.worst_factor < factor:
            values = {name: getattr(design, name) for name in ("half_width", "gain", "passes", "lead")}
            values |= {"bandwidth": design.bandwidth / (2.0 * math.pi), "growth": max(design.worst_factor - 1.0, 0.0)}
            yield finding("CL312", **values)
        elif design is None and grows and isinstance(self.law, ZeroPhase):
            yield finding("CL313")
        if not self.converges and not grows and self.lifted is not None:
            yield finding("CL314", growth=self.lifted.radius - 1.0, doubling=doubling(self.lifted.radius))


def learning_analysis(machine: Machine, controller: Controller, law: LearningLaw, reference: Reference | None = None) -> LearningAnalysis:
    """Predict learning before the first trial.

    Parameters
    ----------
    machine : Machine
    controller : Controller
        Limits, friction and quantisation are left out; all else must be linear.
    law : LearningLaw
        Linear in the table and the trial.
    reference : Reference, optional
        Analyse a whole trial on its path as well; takes seconds for 30 000 samples.

    Returns
    -------
    LearningAnalysis

    Raises
    ------
    ComponentError
        If a component is not linear, or an axis is unstable without learning.
    """
    loop = coupled_loop(machine, controller)
    for name, axis in zip(loop.names, loop.axes, strict=True):
        refuse(not axis.loop.stable, ComponentError, f"axis {name} is unstable under its own controller: stabilise it before learning")
    response = frequency_learning(loop, law)
    lifted = None
    if reference is not None:
        lifted = lifted_learning(loop, law, reference.path.tangent(reference.block(0, reference.n_sample).arc_length))
    zero = first_zero(int(law.half_width), loop.servo_period) if isinstance(law, ZeroPhase) and law.half_width else math.nan
    design = design_for(loop, law) if response.worst_radius[1] > 1.0 + GROWTH and isinstance(law, ZeroPhase) else None
    return LearningAnalysis(law, loop.servo_period, response, lifted, zero, design)


def design_for(loop: CoupledLoop, law: ZeroPhase) -> LearningDesign | None:
    """Return zero-phase learning by rule for the axis with the most lag, widened for the coupling; None if no width is enough."""

    @lru_cache(8)  # the rule asks for the same frequencies under each lead, and for each number of passes
    def answered(frequencies: bytes) -> Complex:
        w = np.frombuffer(frequencies)
        forms = np.stack([axis.form(w) for axis in loop.axes], axis=1)
        answers = 1.0 - forms[:, :, 1, 0] if law.target == "command" else forms[:, :, 0, 1]
        # The axis with the most lag at each frequency.
        phase = np.unwrap(np.angle(answers), axis=0) if w.size > 1 else np.angle(answers)
        return np.asarray(answers[np.arange(w.size), np.argmin(phase, axis=1)])

    design = design_zero_phase(lambda w: answered(w.tobytes()), loop.servo_period)
    for _ in range(MOST_WIDER):
        # The rule ignores the coupling, which makes the loops steeper across the path.
        tried = law.replace(gain=design.gain, half_width=float(design.half_width), passes=float(design.passes), lead=design.lead)
        at, factor = frequency_learning(loop, tried).worst_radius
        if factor <= 1.0 + SMALL:
            return replace(design, worst_frequency=at, worst_factor=factor)
        width = 1 + design.half_width + design.half_width // 2
        design = replace(design, half_width=width, passes=2, bandwidth=first_zero(width, loop.servo_period))
    return None
