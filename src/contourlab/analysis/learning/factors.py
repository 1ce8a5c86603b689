"""Factors of a trial of learning over frequency, and the impulse responses of learning laws.

Over frequency, a trial multiplies the remaining error by a factor: for one axis and zero-phase learning 1 - gamma H T, for a law of the
tracking error Q (1 - L G). With coupling it is a matrix at each frequency and direction of the path: its spectral radius shows whether
learning converges, its largest singular value whether every trial improves on the last. A law enters by its impulse responses, or by its
formula if it learns through a model.

References
----------
Bristow, Tharayil & Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (2006), eq (17).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.linear.coupled_loop import CoupledLoop, impulse_responses
from contourlab.arrays import Array, Complex
from contourlab.components.learning.law import LearningLaw, LearningProblem, NormOptimal, PlantInversion, TrialRecord, q_response
from contourlab.errors import ComponentError

HEARD = ("table", "tracking_error", "contour_error", "feedback_command")
SHORTEST, LONGEST = 1 << 9, 1 << 15
SETTLED = 1e-7
"""Largest share of an impulse response in the first and last eighth of the record."""


@dataclass(frozen=True, eq=False)
class LawKernels:
    """Impulse responses of a law: the next table after an impulse in the middle of a long trial.

    Attributes
    ----------
    kernels : dict of str to ndarray (n_sample, n_axis, n_axis)
        For the table, the tracking error, the contour error and the feedback: sample, axis of the table, axis of the impulse.
    centre : int
        Sample of the impulse.
    servo_period : float [s]
    """

    kernels: dict[str, Array]
    centre: int
    servo_period: float
    directed: ClassVar[bool] = False
    """Whether the law itself depends on the direction of the path."""

    @cached_property
    def support(self) -> tuple[int, int]:
        """First and last sample, counted from the impulse, above rounding in any kernel."""
        size = np.max([np.abs(kernel).max(axis=(1, 2)) / max(np.abs(kernel).max(), 1e-300) for kernel in self.kernels.values()], axis=0)
        at = np.flatnonzero(size > 1e-12)
        return int(at[0]) - self.centre, int(at[-1]) - self.centre

    def response(self, frequency: ArrayLike, across: Array) -> dict[str, Complex]:
        """Return the frequency responses (n, n_axis, n_axis) at frequencies (n,) [rad/s]; the same on any path."""
        w = np.atleast_1d(np.asarray(frequency, dtype=float))
        first, last = self.support
        sample = np.arange(first, last + 1)
        responses = {name: np.zeros((w.size, *kernel.shape[1:]), dtype=complex) for name, kernel in self.kernels.items()}
        # In slices, to limit the memory for long records.
        for part in np.array_split(np.arange(w.size), max(1, w.size * sample.size // 2_000_000)):
            turn = np.exp(-1j * np.outer(w[part], sample * self.servo_period))
            for name, kernel in self.kernels.items():
                if kernel.any():
                    responses[name][part] = np.tensordot(turn, kernel[sample + self.centre], axes=1)
        return responses


@dataclass(frozen=True, eq=False)
class LawModel:
    """A law that learns through a model of the axes, by its formula: norm-optimal learning, or plant inversion.

    Attributes
    ----------
    largest : ndarray (n_axis,)
        Largest |G|^2 of each axis over frequency.
    """

    law: Any
    loop: CoupledLoop
    largest: Array
    support: ClassVar[tuple[int, int]] = (0, 0)
    """This law has no side lobes."""

    @property
    def directed(self) -> bool:
        """Whether the law itself depends on the direction of the path."""
        return bool(self.law.values().get("contour_weight", 0.0))

    def response(self, frequency: ArrayLike, across: Array) -> dict[str, Complex]:
        """Return the frequency responses (n, n_axis, n_axis) at frequencies (n,) [rad/s], with a constant projection across the path."""
        w = np.atleast_1d(np.asarray(frequency, dtype=float))
        eye = np.eye(len(across))
        g = _models(self.loop, self.law.target, w)
        none = np.zeros((w.size, *eye.shape), dtype=complex)
        if isinstance(self.law, PlantInversion):
            q = q_response(w, self.law.bandwidth, self.law.order, self.loop.servo_period)
            inverse = self.law.gain * g.conj() / (np.abs(g) ** 2 + self.law.regularisation * self.largest)
            table, error = q[:, None, None] * eye, q[:, None, None] * inverse[:, :, None] * eye
        else:
            weights = self.law.tracking_weight * eye + self.law.contour_weight * across
            on_input, on_change = np.diag(self.law.input_weight * self.largest), np.diag(self.law.change_weight * self.largest)
            adjoint = g.conj()[:, :, None] * weights
            solved = np.linalg.inv(adjoint * g[:, None, :] + on_input + on_change)
            table, error = eye - solved @ on_input, solved @ adjoint
        return {"table": table + none, "tracking_error": error, "contour_error": none, "feedback_command": none}


def law_model(law: LearningLaw, loop: CoupledLoop) -> LawModel | None:
    """Return the formula of a law that learns through a model; None for any other law."""
    if not isinstance(law, NormOptimal | PlantInversion):
        return None
    w = np.unique(np.concatenate([np.geomspace(1e-5 * loop.nyquist, loop.nyquist, 600), np.linspace(1e-5, 1.0, 600) * loop.nyquist]))
    return LawModel(law, loop, (np.abs(_models(loop, law.target, w)) ** 2).max(axis=0))


def _models(loop: CoupledLoop, target: str, w: Array) -> Complex:
    """Return the responses (n, n_axis) of the axes, each alone, from the learned signal to the position."""
    return np.stack([axis.form(w)[:, 0, 0 if target == "command" else 1] for axis in loop.axes], axis=1)


def law_kernels(law: LearningLaw, loop: CoupledLoop) -> LawKernels:
    """Return a law's impulse responses on a straight path; for a law without a model they are the same on any path.

    Raises
    ------
    ComponentError
        If the law is not linear, or its impulse response is longer than `LONGEST` samples.
    """
    t, size = np.eye(len(loop.axes))[0], SHORTEST
    while True:
        problem = lifted_problem(law, loop, np.tile(t, (size, 1)))
        kernels = {name: _answers(law, problem, name) for name in HEARD}
        if all(_settled(kernel) for kernel in kernels.values()):
            break
        size *= 4
        if size > LONGEST:
            raise ComponentError(f"learning {law.kind} answers to an impulse for more than {LONGEST} samples: too long for the analysis")
    _check_linear(law, problem, kernels)
    return LawKernels(kernels, size // 2, loop.servo_period)


def lifted_problem(law: LearningLaw, loop: CoupledLoop, tangent: Array) -> LearningProblem:
    """Return the problem of a law before the first trial: tangents (n_sample, n_axis), and the impulse response of each axis alone."""
    return LearningProblem(loop.servo_period, tangent, lambda: impulse_responses(loop.axes, len(tangent), law.target))


def _answers(law: LearningLaw, problem: LearningProblem, heard: str) -> Array:
    """Return the next tables (n_sample, n_axis, n_axis) for an impulse on each axis of one input of the law."""
    n_sample, n_axis = problem.tangent.shape
    impulses = np.zeros((n_axis, n_sample, n_axis))
    impulses[np.arange(n_axis), n_sample // 2, np.arange(n_axis)] = 1.0
    return np.stack([next_table(law, problem, {heard: impulse}) for impulse in impulses], axis=2)


def next_table(law: LearningLaw, problem: LearningProblem, given: Mapping[str, Array]) -> Array:
    """Return the next table of a law from some of its inputs `HEARD`, (n_sample, n_axis) each; the others are zero."""
    none = np.zeros(problem.tangent.shape)
    table, error, contour, feedback = (given.get(name, none) for name in HEARD)
    return np.asarray(law.update(table, TrialRecord(error, feedback, none, contour), problem))


def _settled(kernel: Array) -> bool:
    n, total = len(kernel), float(np.abs(kernel).sum())
    return float(np.abs(kernel[: n // 8]).sum() + np.abs(kernel[-(n // 8) :]).sum()) <= SETTLED * total


def _check_linear(law: LearningLaw, problem: LearningProblem, kernels: dict[str, Array]) -> None:
    """Raise `ComponentError` unless the response to impulses on all axes at once is the sum of the single responses."""
    shape = problem.tangent.shape
    rng = np.random.default_rng(1)
    given, wanted = {}, np.zeros(shape)
    for name in HEARD:
        sizes = rng.normal(size=shape[1]) / max(float(np.abs(kernels[name]).max()), 1e-12)
        given[name] = np.zeros(shape)
        given[name][shape[0] // 2] = sizes
        wanted += kernels[name] @ sizes
    apart = float(np.abs(next_table(law, problem, given) - wanted).max())
    # A law that iterates has a tolerance of its own.
    if not apart <= max(1e-6, 100.0 * float(law.values().get("tolerance", 0.0))) * max(float(np.abs(wanted).max()), math.ulp(1.0)):
        raise ComponentError(f"learning {law.kind} is not linear in the table and the trial, so it has no frequency response")


def averaging(frequency: ArrayLike, servo_period: float, half_width: int, passes: int = 1, lead: float = 0.0) -> Complex:
    """Return H_M(w) of the average over 2 M + 1 samples, taken `passes` times, with a lead [s] of whole servo periods.

    H_M = sin((2 M + 1) w T_s/2)/((2 M + 1) sin(w T_s/2)): 1 at w = 0, 0 at multiples of 2 pi/((2 M + 1) T_s), down to -0.217 between them.

    >>> bool(abs(averaging([2 * np.pi / (23 * 1e-3)], 1e-3, 11)[0]) < 1e-15)
    True
    """
    w = np.atleast_1d(np.asarray(frequency, dtype=float))
    n, half = 2 * half_width + 1, 0.5 * w * servo_period
    below = n * np.sin(half)
    mean = np.where(np.abs(below) > 1e-12, np.sin(n * half) / np.where(below == 0.0, 1.0, below), 1.0)
    return np.asarray(mean**passes * np.exp(1j * w * servo_period * round(lead / servo_period)))


@dataclass(frozen=True, eq=False)
class FrequencyLearning:
    """Factors of a trial over frequency, the worst over all directions of the path.

    Attributes
    ----------
    frequency : ndarray (n,) [rad/s]
    radius : ndarray (n,)
        Spectral radius of the factor: asymptotic growth per trial.
    norm : ndarray (n,)
        Its largest singular value: growth in one trial. Without coupling the two are equal.
    worst_radius, worst_norm : (frequency [rad/s], factor)
        The peaks, refined between the frequencies.
    """

    frequency: Array
    radius: Array
    norm: Array
    worst_radius: tuple[float, float]
    worst_norm: tuple[float, float]


def frequency_learning(loop: CoupledLoop, law: LearningLaw) -> FrequencyLearning:
    """Return the factor of a trial over frequency, the worst over all constant directions of the path.

    Parameters
    ----------
    law : LearningLaw
        Linear in its inputs.

    Raises
    ------
    ComponentError
        If the law is not linear.
    """
    coupled = loop.coupling.d != 0.0 or len(loop.coupling.f) > 0 or loop.coupling.weight != 0.0
    spread = directions(len(loop.axes))
    known = law_model(law, loop) or law_kernels(law, loop)
    if not (coupled or law.needs_contour_error or known.directed):
        spread = spread[:1]
    w = learning_grid(loop, *known.support)

    def worst(at: Array) -> tuple[Array, Array]:
        radius, norm = np.zeros(at.size), np.zeros(at.size)
        for matrix in _factors(loop, law, known, at, spread):
            radius = np.maximum(radius, np.abs(np.linalg.eigvals(matrix)).max(axis=1))
            norm = np.maximum(norm, np.linalg.norm(matrix, 2, axis=(1, 2)))
        return radius, norm

    radius, norm = worst(w)
    by_radius, by_norm = peak(lambda at: worst(at)[0], w, radius), peak(lambda at: worst(at)[1], w, norm)
    return FrequencyLearning(w, radius, norm, by_radius, by_norm)


def _factors(
    loop: CoupledLoop, law: LearningLaw, known: LawKernels | LawModel, frequency: Array, tangents: Iterable[Array]
) -> Iterator[Complex]:
    """Yield for each direction the matrices (n, n_axis, n_axis) by which a trial multiplies the remaining error at some frequencies."""
    eye, on_command = np.eye(len(loop.axes)), law.target == "command"
    forms = np.stack([axis.form(frequency) for axis in loop.axes], axis=1)
    pushed, shifted, back, asked = (forms[:, :, i, j, None] * eye for i in (0, 1) for j in (0, 1))
    gain, heard = loop.coupling(frequency)[:, None, None], known.response(frequency, eye)
    for tangent in tangents:
        along = np.outer(tangent, tangent) / (tangent @ tangent)
        across = eye - along
        coupling, weighted = gain * across, loop.coupling.weight * along
        # Position and feedback command over the learned signal, with axes and coupling closed.
        position = np.linalg.solve(eye + pushed @ coupling - shifted @ weighted, pushed if on_command else shifted)
        correction, shift = -coupling @ position, weighted @ position
        # The learned command is no part of the feedback.
        feedback = back @ (eye + correction) + asked @ shift - eye if on_command else back @ correction + asked @ (eye + shift)
        if known.directed:
            heard = known.response(frequency, across)
        from_error = heard["tracking_error"] + heard["contour_error"] @ across
        yield np.asarray(heard["table"] - from_error @ position + heard["feedback_command"] @ feedback)


def directions(n_axis: int) -> Array:
    """Return unit vectors (n, n_axis) spread over the directions of a path, up to the signs of their entries, which change no factor.

    Their squares are a lattice on the simplex: along each axis, along the diagonals of each pair and group, and between.
    """
    if n_axis == 1:
        return np.ones((1, 1))
    degree = 16 if n_axis == 2 else 6 if n_axis == 3 else 3
    return np.sqrt(np.array(_compositions(degree, n_axis)) / degree)


def _compositions(total: int, parts: int) -> list[tuple[int, ...]]:
    if parts == 1:
        return [(total,)]
    return [(first, *rest) for first in range(total + 1) for rest in _compositions(total - first, parts - 1)]


def learning_grid(loop: CoupledLoop, first: int, last: int) -> Array:
    """Return frequencies (n,) [rad/s] that resolve the side lobes of an average from sample `first` to `last`."""
    top = loop.nyquist
    # Side lobes fall with frequency: a fine grid for the first ones, decades for the rest.
    lobe = 2.0 * top / max(last - first, 8)
    poles = np.concatenate([axis.loop.poles for axis in loop.axes])
    angle = np.abs(np.angle(poles[np.abs(poles) > 1e-6])) / loop.servo_period
    w = np.unique(np.concatenate([np.geomspace(1e-4 * top, top, 240), np.arange(320) * lobe / 8.0, angle]))
    return np.asarray(w[(w >= 1e-4 * top) & (w <= top)])


def peak(function: Callable[[Array], Array], w: Array, values: Array) -> tuple[float, float]:
    """Return frequency and value of the maximum of a function, refined on ever finer grids."""
    for _ in range(4):
        i = int(np.argmax(values))
        w = np.linspace(w[max(i - 1, 0)], w[min(i + 1, w.size - 1)], 17)
        values = function(w)
    return float(w[np.argmax(values)]), float(values.max())
