"""What a trial makes of each frequency: the factors by which learning multiplies what it has not learned yet.

For one axis and zero-phase learning the factor is 1 - gamma H T, for a law of the tracking error Q (1 - L G). With coupling the axes belong
together, and the factor is a matrix at each frequency and direction of the path: its spectral radius says whether learning converges in the
end, its largest singular value whether every trial is better than the last.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.analysis.learning.learning_law import LawKernels, LawModel, law_kernels, law_model
from contourlab.analysis.linear.coupled_loop import CoupledLoop
from contourlab.components.learning.law import LearningLaw

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


def averaging(frequency: ArrayLike, servo_period: float, half_width: int, passes: int = 1, lead: float = 0.0) -> Complex:
    """Return H_M(w) of the average over 2 M + 1 samples, taken `passes` times, with a lead [s] of whole servo periods.

    H_M = sin((2 M + 1) w T_s/2)/((2 M + 1) sin(w T_s/2)): 1 at w = 0, zero at multiples of 1/((2 M + 1) T_s), down to -0.217 between them.

    >>> bool(abs(averaging([2 * np.pi / (23 * 1e-3)], 1e-3, 11)[0]) < 1e-15)
    True
    """
    w = np.atleast_1d(np.asarray(frequency, dtype=float))
    n, half = 2 * half_width + 1, 0.5 * w * servo_period
    below = n * np.sin(half)
    mean = np.where(np.abs(below) > 1e-12, np.sin(n * half) / np.where(below == 0.0, 1.0, below), 1.0)
    return np.asarray(mean**passes * np.exp(1j * w * servo_period * round(lead / servo_period)))


def zero_phase_factor(gain: float, average: ArrayLike, closed: ArrayLike) -> Complex:
    """Return 1 - gamma H T, by which a trial of zero-phase learning multiplies what is left to learn (eq 9 on u_fb = T (u_d - u_ff)).

    Parameters
    ----------
    gain : float
        gamma.
    average : array_like (n,), complex
        H, with its lead.
    closed : array_like (n,), complex
        T = P C/(1 + P C), delay included.
    """
    return np.asarray(1.0 - gain * np.asarray(average) * np.asarray(closed))


def error_factor(q: ArrayLike, gain: ArrayLike, process: ArrayLike) -> Complex:
    """Return Q (1 - L G), by which a trial of learning from the tracking error multiplies what is left to learn.

    References
    ----------
    Bristow, Tharayil & Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (2006), eq (17).
    """
    return np.asarray(np.asarray(q) * (1.0 - np.asarray(gain) * np.asarray(process)), dtype=complex)


def robust_factor(q: ArrayLike, gain: ArrayLike, process: ArrayLike, uncertainty: ArrayLike) -> Array:
    """Return |Q| (|1 - L G| + |L G W|): the worst factor of all plants G (1 + W D), |D| <= 1; below 1 every one of them learns steadily.

    Parameters
    ----------
    uncertainty : array_like (n,)
        W, largest error of the model over the model.
    """
    open_ = np.asarray(gain) * np.asarray(process)
    return np.asarray(np.abs(q) * (np.abs(1.0 - open_) + np.abs(open_ * np.asarray(uncertainty))), dtype=float)


@dataclass(frozen=True, eq=False)
class FrequencyLearning:
    """Factors of a trial over frequency, the worst over all directions of the path.

    Attributes
    ----------
    frequency : ndarray (n,) [rad/s]
    radius : ndarray (n,)
        Spectral radius of the factor: what a trial does in the end.
    norm : ndarray (n,)
        Its largest singular value: what a trial may do at once. Without coupling the two are the same.
    worst_radius, worst_norm : (frequency [rad/s], factor)
        The peaks, found between the frequencies.
    """

    frequency: Array
    radius: Array
    norm: Array
    worst_radius: tuple[float, float]
    worst_norm: tuple[float, float]


def frequency_learning(loop: CoupledLoop, law: LearningLaw, tangents: ArrayLike | None = None) -> FrequencyLearning:
    """Return what a trial makes of each frequency, each direction of the path standing still.

    Parameters
    ----------
    loop : CoupledLoop
    law : LearningLaw
        Any law that is linear in what it hears.
    tangents : array_like (n, n_axis), optional
        Directions of the path to look at; else spread over all there are.

    Raises
    ------
    ComponentError
        If the law is not linear.
    """
    n_axis = len(loop.axes)
    coupled = loop.coupling.d != 0.0 or len(loop.coupling.f) > 0 or loop.coupling.weight != 0.0
    spread = directions(n_axis) if tangents is None else np.atleast_2d(np.asarray(tangents, dtype=float))
    known = law_model(law, loop) or law_kernels(law, loop)
    if not (coupled or law.needs_contour_error or known.directed):
        spread = spread[:1]
    w = learning_grid(loop, *known.support)

    def worst(at: Array) -> tuple[Array, Array]:
        radius, norm = np.zeros(at.size), np.zeros(at.size)
        trial = _Trial(loop, law, known, at)
        for t in spread:
            matrix = trial(t)
            radius = np.maximum(radius, np.abs(np.linalg.eigvals(matrix)).max(axis=1))
            norm = np.maximum(norm, np.linalg.norm(matrix, 2, axis=(1, 2)))
        return radius, norm

    radius, norm = worst(w)
    by_radius, by_norm = peak(lambda at: worst(at)[0], w, radius), peak(lambda at: worst(at)[1], w, norm)
    return FrequencyLearning(w, radius, norm, by_radius, by_norm)


def trial_matrices(loop: CoupledLoop, law: LearningLaw, frequency: ArrayLike, tangent: ArrayLike) -> Complex:
    """Return the factors (n, n_axis, n_axis) by which a trial multiplies what is left to learn, with a direction of the path at rest."""
    known = law_model(law, loop) or law_kernels(law, loop)
    return _Trial(loop, law, known, np.atleast_1d(np.asarray(frequency, dtype=float)))(np.asarray(tangent, dtype=float))


class _Trial:
    """A trial at some frequencies, ready to be asked for in any direction."""

    def __init__(self, loop: CoupledLoop, law: LearningLaw, known: LawKernels | LawModel, frequency: Array) -> None:
        self.target, self.weight, eye = law.target, loop.coupling.weight, np.eye(len(loop.axes))
        self.known, self.frequency = known, frequency
        self.same = None if known.directed else known.response(frequency, eye)
        forms = np.stack([axis.form(frequency) for axis in loop.axes], axis=1)
        self.pushed, self.shifted, self.back, self.asked = (forms[:, :, i, j, None] * eye for i in (0, 1) for j in (0, 1))
        self.coupling = loop.coupling(frequency)[:, None, None]

    def __call__(self, tangent: Array) -> Complex:
        along = np.outer(tangent, tangent) / (tangent @ tangent)
        across = np.eye(tangent.size) - along
        position, feedback = self._closed(along, across)
        heard = self.known.response(self.frequency, across) if self.same is None else self.same
        from_error = heard["tracking_error"] + heard["contour_error"] @ across
        return np.asarray(heard["table"] - from_error @ position + heard["feedback_command"] @ feedback)

    def _closed(self, along: Array, across: Array) -> tuple[Complex, Complex]:
        """Return position and feedback command over what is learned, the axes and their coupling closed."""
        eye, coupling, weighted = np.eye(len(along)), self.coupling * across, self.weight * along
        driven = self.pushed if self.target == "command" else self.shifted
        position = np.asarray(np.linalg.solve(eye + self.pushed @ coupling - self.shifted @ weighted, driven))
        correction, shift = -coupling @ position, weighted @ position
        if self.target == "command":
            # What is learned goes into the command and is no part of the feedback.
            return position, np.asarray(self.back @ (eye + correction) + self.asked @ shift - eye)
        return position, np.asarray(self.back @ correction + self.asked @ (eye + shift))


def directions(n_axis: int) -> Array:
    """Return unit vectors (n, n_axis) spread over the directions of a path, up to the signs of their entries, which change no factor.

    Their squares are a lattice on the simplex: along each axis, along the diagonals of each pair and group, and between.
    """
    if n_axis == 1:
        return np.ones((1, 1))
    degree = 16 if n_axis == 2 else 6 if n_axis == 3 else 3
    points = [np.array(point) for point in _compositions(degree, n_axis)]
    return np.sqrt(np.array(points) / degree)


def _compositions(total: int, parts: int) -> list[tuple[int, ...]]:
    if parts == 1:
        return [(total,)]
    return [(first, *rest) for first in range(total + 1) for rest in _compositions(total - first, parts - 1)]


def learning_grid(loop: CoupledLoop, first: int, last: int) -> Array:
    """Return frequencies (n,) [rad/s] at which no side lobe of an average from sample `first` to `last` slips through."""
    top = loop.nyquist
    # Side lobes fall with frequency: the first ones are looked at closely, the rest by the spread of the decades.
    lobe = 2.0 * top / max(last - first, 8)
    poles = np.concatenate([axis.loop.poles for axis in loop.axes])
    angle = np.abs(np.angle(poles[np.abs(poles) > 1e-6])) / loop.servo_period
    w = np.unique(np.concatenate([np.geomspace(1e-4 * top, top, 240), np.arange(320) * lobe / 8.0, angle]))
    return np.asarray(w[(w >= 1e-4 * top) & (w <= top)])


def peak(function: Callable[[Array], Array], w: Array, values: Array) -> tuple[float, float]:
    """Return where a function of frequency is largest, and its value there, looked for again about its largest value."""
    for _ in range(4):
        i = int(np.argmax(values))
        w = np.linspace(w[max(i - 1, 0)], w[min(i + 1, w.size - 1)], 17)
        values = function(w)
    i = int(np.argmax(values))
    return float(w[i]), float(values[i])
