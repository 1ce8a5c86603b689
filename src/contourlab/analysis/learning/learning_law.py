"""A learning law in the frequency domain, by what it makes of impulses: any law that is linear in the table and the trial."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.analysis.linear.coupled_loop import CoupledLoop, impulse_responses
from contourlab.components.learning.filters import q_response
from contourlab.components.learning.law import LearningLaw, LearningProblem, TrialRecord
from contourlab.components.learning.least_squares import NormOptimal, PlantInversion
from contourlab.errors import ComponentError

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

HEARD = ("table", "tracking_error", "contour_error", "feedback_command")
SHORTEST, LONGEST = 1 << 9, 1 << 15
SETTLED = 1e-7
"""Part of an impulse response that may lie in the outer eighths of the record."""


@dataclass(frozen=True, eq=False)
class LawKernels:
    """What a law adds to the next table for an impulse in the middle of a long trial.

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

    @cached_property
    def support(self) -> tuple[int, int]:
        """First and last sample that are not zero but for rounding, over all kernels, from the impulse."""
        size = np.max([np.abs(kernel).max(axis=(1, 2)) / max(np.abs(kernel).max(), 1e-300) for kernel in self.kernels.values()], axis=0)
        at = np.flatnonzero(size > 1e-12)
        return int(at[0]) - self.centre, int(at[-1]) - self.centre

    @property
    def directed(self) -> bool:
        """Whether the law itself asks for the direction of the path."""
        return False

    def response(self, frequency: ArrayLike, across: Array) -> dict[str, Complex]:
        """Return the frequency responses (n, n_axis, n_axis) at frequencies (n,) [rad/s]; the same on any path."""
        w = np.atleast_1d(np.asarray(frequency, dtype=float))
        first, last = self.support
        sample = np.arange(first, last + 1)
        found = {name: np.zeros((w.size, *kernel.shape[1:]), dtype=complex) for name, kernel in self.kernels.items()}
        # In slices, so that long records at many frequencies take no more memory than short ones.
        for part in np.array_split(np.arange(w.size), max(1, w.size * sample.size // 2_000_000)):
            turn = np.exp(-1j * np.outer(w[part], sample * self.servo_period))
            for name, kernel in self.kernels.items():
                if kernel.any():
                    found[name][part] = np.tensordot(turn, kernel[sample + self.centre], axes=1)
        return found


@dataclass(frozen=True, eq=False)
class LawModel:
    """A law that learns through a model of the axes, by its formula: norm-optimal learning, or the inverse of the model.

    Attributes
    ----------
    law : NormOptimal or PlantInversion
    loop : CoupledLoop
    largest : ndarray (n_axis,)
        Largest |G|^2 of each axis over frequency.
    """

    law: Any
    loop: CoupledLoop
    largest: Array

    @property
    def support(self) -> tuple[int, int]:
        """As of a law without side lobes."""
        return 0, 0

    @property
    def directed(self) -> bool:
        """Whether the law itself asks for the direction of the path."""
        return bool(self.law.values().get("contour_weight", 0.0))

    def response(self, frequency: ArrayLike, across: Array) -> dict[str, Complex]:
        """Return the frequency responses (n, n_axis, n_axis) at frequencies (n,) [rad/s], with the projection across the path at rest."""
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
    """Return a law that learns through a model by its formula; None for any other law."""
    if not isinstance(law, NormOptimal | PlantInversion):
        return None
    w = np.unique(np.concatenate([np.geomspace(1e-5 * loop.nyquist, loop.nyquist, 600), np.linspace(1e-5, 1.0, 600) * loop.nyquist]))
    return LawModel(law, loop, (np.abs(_models(loop, law.target, w)) ** 2).max(axis=0))


def _models(loop: CoupledLoop, target: str, w: Array) -> Complex:
    """Return the responses (n, n_axis) of the axes, each alone, from what is learned to the position."""
    return np.stack([axis.form(w)[:, 0, 0 if target == "command" else 1] for axis in loop.axes], axis=1)


def law_kernels(law: LearningLaw, loop: CoupledLoop) -> LawKernels:
    """Return what a law does with impulses, on a path that is straight, as laws without a model do on any path.

    Parameters
    ----------
    law : LearningLaw
    loop : CoupledLoop

    Raises
    ------
    ComponentError
        If the law is not linear, or its answer to an impulse is longer than `LONGEST` samples.
    """
    t, size = np.eye(len(loop.axes))[0], SHORTEST
    while True:
        problem = lifted_problem(law, loop, np.tile(t, (size, 1)))
        kernels = {name: _answers(law, problem, name) for name in HEARD}
        if all(_settled(kernel) for kernel in kernels.values()):
            break
        size *= 4
        if size > LONGEST:
            raise ComponentError(f"learning {law.kind} answers to an impulse for more than {LONGEST} samples: that is beyond its analysis")
    _check_linear(law, problem, kernels)
    return LawKernels(kernels, size // 2, loop.servo_period)


def lifted_problem(law: LearningLaw, loop: CoupledLoop, tangent: Array) -> LearningProblem:
    """Return what a law knows before the first trial: a path with tangents (n_sample, n_axis), and the axes each alone."""
    return LearningProblem(loop.servo_period, tangent, lambda: impulse_responses(loop.axes, len(tangent), law.target))


def _answers(law: LearningLaw, problem: LearningProblem, heard: str) -> Array:
    """Return the next tables (n_sample, n_axis, n_axis) for an impulse on each axis of one of the things that a law hears."""
    shape = problem.tangent.shape
    found = np.zeros((*shape, shape[1]))
    for j in range(shape[1]):
        given = {name: np.zeros(shape) for name in HEARD}
        given[heard][shape[0] // 2, j] = 1.0
        found[:, :, j] = _next(law, problem, given)
    return found


def _next(law: LearningLaw, problem: LearningProblem, given: dict[str, Array]) -> Array:
    none = np.zeros(problem.tangent.shape)
    record = TrialRecord(given["tracking_error"], given["feedback_command"], none, given["contour_error"])
    return np.asarray(law.update(given["table"], record, problem))


def _settled(kernel: Array) -> bool:
    n, total = len(kernel), float(np.abs(kernel).sum())
    return float(np.abs(kernel[: n // 8]).sum() + np.abs(kernel[-(n // 8) :]).sum()) <= SETTLED * total


def _check_linear(law: LearningLaw, problem: LearningProblem, kernels: dict[str, Array]) -> None:
    """The answer to impulses on all axes at once, of any size, is the sum of the answers."""
    shape = problem.tangent.shape
    rng = np.random.default_rng(1)
    given, wanted = {}, np.zeros(shape)
    for name in HEARD:
        sizes = rng.normal(size=shape[1]) / max(float(np.abs(kernels[name]).max()), 1e-12)
        given[name] = np.zeros(shape)
        given[name][shape[0] // 2] = sizes
        wanted += kernels[name] @ sizes
    apart = float(np.abs(_next(law, problem, given) - wanted).max())
    # A law that solves an equation by steps does so to a tolerance of its own.
    if not apart <= max(1e-6, 100.0 * float(law.values().get("tolerance", 0.0))) * max(float(np.abs(wanted).max()), math.ulp(1.0)):
        raise ComponentError(f"learning {law.kind} is not linear in the table and the trial, so it has no frequency response")
