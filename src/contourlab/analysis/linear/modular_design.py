"""Linear-quadratic state feedback for swapped servo axes: cost, optimum, and gains split into base and local ones.

An axis a/(s (s + b)) has feedback u = -K x of the integral of its position, its position and its velocity. The cost of K is J = tr P, the
sum of the quadratic costs from each unit initial state.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.arrays import Array, Flags
from contourlab.errors import ParameterError, refuse
from contourlab.extras import extra_module

GAINS = ("integral", "position", "velocity")
"""Entries of K."""


@dataclass(frozen=True)
class LinearAxis:
    """An axis a/(s (s + b)): acceleration per command [mm/s^2/unit] and damping [1/s]."""

    gain: float
    damping: float

    def __post_init__(self) -> None:
        refuse(not (self.gain > 0.0 and math.isfinite(self.gain)), ParameterError, "gain", f"{self.gain:g}", "> 0 and finite")
        refuse(not math.isfinite(self.damping), ParameterError, "damping", f"{self.damping:g}", "finite")


@dataclass(frozen=True)
class LqWeights:
    """Weights of the states in scaled time, integral [mm times the unit], position [mm], velocity [mm per unit], and of the command.

    Attributes
    ----------
    time_unit : float [s], > 0
        Unit of scaled time, about the loop's time constant, so that the states are of similar size.
    integral, position, velocity : float, >= 0
    command : float, > 0

    Notes
    -----
    No weights are published for these axes. The defaults give loops of about 2 Hz, and losses similar to those in the technical brief, for
    drives with and without the observer.
    """

    time_unit: float = 0.1
    integral: float = 1.0
    position: float = 1.0
    velocity: float = 0.0
    command: float = 20.0

    def matrices(self, axis: LinearAxis) -> tuple[Array, Array, Array, Array]:
        """Return A (3, 3), B (3, 1), Q (3, 3), R (1, 1) of an axis in scaled time."""
        unit = self.time_unit
        a = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -axis.damping * unit]])
        b = np.array([[0.0], [0.0], [axis.gain * unit**2]])
        return a, b, np.diag([self.integral, self.position, self.velocity]), np.array([[self.command]])


@dataclass(frozen=True, eq=False)
class ModularDesign:
    """Base and local gains, and their cost.

    Attributes
    ----------
    local : tuple of str
        Names from `GAINS` with a separate value for each axis.
    gains : ndarray (n_axis, 3)
        K of each axis, base and local entries together.
    ratio : ndarray (n_axis,)
        J/J*; infinite for an unstable loop.
    """

    method: str
    local: tuple[str, ...]
    gains: Array
    ratio: Array

    @property
    def loss(self) -> float:
        """Largest J/J* - 1."""
        return float(self.ratio.max() - 1.0)


def optimum(axis: LinearAxis, weights: LqWeights) -> tuple[Array, float]:
    """Return the optimal gains (3,) and J* of an axis alone."""
    from scipy.linalg import solve_continuous_are

    a, b, q, r = weights.matrices(axis)
    p = solve_continuous_are(a, b, q, r)
    return np.asarray(np.linalg.solve(r, b.T @ p)[0]), float(np.trace(p))


def cost(axis: LinearAxis, gains: Array, weights: LqWeights) -> float:
    """Return J of an axis under gains (3,); infinite for an unstable loop."""
    from scipy.linalg import solve_continuous_lyapunov

    a, b, q, r = weights.matrices(axis)
    k = np.asarray(gains, dtype=float)[None, :]
    closed = a - b @ k
    if not np.isfinite(closed).all() or np.linalg.eigvals(closed).real.max() >= 0.0:
        return math.inf
    return float(np.trace(solve_continuous_lyapunov(closed.T, -(q + k.T @ r @ k))))


def blind_swaps(axes: Sequence[LinearAxis], weights: LqWeights) -> Array:
    """Return J/J* (n, n) of the optimal gains of axis i on axis j."""
    known = [optimum(axis, weights) for axis in axes]
    return np.array([[cost(axis, k, weights) / best for axis, (_, best) in zip(axes, known, strict=True)] for k, _ in known])


def direct_design(axes: Sequence[LinearAxis], local: Sequence[str] = (), weights: LqWeights | None = None) -> ModularDesign:
    """Return base and local gains by the direct, bi-level method: the best base if each axis optimises its local gains.

    Parameters
    ----------
    local : sequence of str
        Names from `GAINS`.

    Notes
    -----
    Both levels are one problem: min over base and local gains of sum_i (J_i/J_i* - 1), where each axis minimises its own term. With the
    sum, axes other than the worst count too.

    References
    ----------
    Li, Kolmanovsky & Ulsoy, "Direct optimal design for component swapping modularity in control systems", IEEE/ASME Trans. Mechatronics 18
    (2013): the idea; the formula is ours.
    """
    from scipy.optimize import minimize

    weights = weights or LqWeights()
    known = [optimum(axis, weights) for axis in axes]
    mask = checked_local(local)
    size = np.abs(np.mean([k for k, _ in known], axis=0))

    def gains(z: Array) -> Array:
        return np.asarray(assembled(z, mask, len(axes)) * size)

    def total(z: Array) -> float:
        terms = [cost(axis, k, weights) / best - 1.0 for axis, k, (_, best) in zip(axes, gains(z), known, strict=True)]
        return float(min(sum(terms), 1e6))

    start = np.concatenate([(np.mean([k for k, _ in known], axis=0) / size)[~mask], *(k[mask] / size[mask] for k, _ in known)])
    optimum_gains = minimize(total, start, method="Nelder-Mead", options={"xatol": 1e-7, "fatol": 1e-12, "maxiter": 4000, "adaptive": True})
    return judged("direct", local, gains(optimum_gains.x), axes, weights)


def checked_local(local: Sequence[str]) -> Flags:
    """Return which entries of K are local.

    Raises
    ------
    ParameterError
        If a name is none of `GAINS`.
    """
    for name in set(local) - set(GAINS):
        raise ParameterError("local", repr(name), "of " + ", ".join(GAINS))
    return np.array([name in local for name in GAINS])


def assembled(z: Array, mask: Flags, n_axis: int) -> Array:
    """Return the gains (n_axis, 3) from a vector: base entries, then the local ones axis by axis."""
    n_base = int((~mask).sum())
    gains = np.empty((n_axis, mask.size))
    gains[:, ~mask] = z[:n_base]
    gains[:, mask] = z[n_base:].reshape(n_axis, -1)
    return gains


def judged(method: str, local: Sequence[str], gains: Array, axes: Sequence[LinearAxis], weights: LqWeights) -> ModularDesign:
    """Return a design with its cost on each axis."""
    ratio = [cost(axis, k, weights) / optimum(axis, weights)[1] for axis, k in zip(axes, gains, strict=True)]
    return ModularDesign(method, tuple(local), np.asarray(gains), np.array(ratio))


DECADES = 2.0
"""Decades of the grid below the slowest and above the fastest pole."""


def three_step_design(axes: Sequence[LinearAxis], local: Sequence[str] = (), weights: LqWeights | None = None) -> ModularDesign:
    """Return base and local gains by the 3-step method, in parallel: K_i = K_base + K_local,i.

    Parameters
    ----------
    local : sequence of str
        Names from `GAINS`.

    Notes
    -----
    Step 1 is `optimum` for each axis. Step 2 is the least-squares problem min sum_i,w |W_i (K_i* - K_base - K_local,i)|^2 over a grid of
    frequencies, where K(jw) = k_I/jw + k_P + k_V jw. W_i = G_i/(1 + G_i K_i*) weighs an error of the controller by its effect on the closed
    loop. The problem is linear in the gains. Step 3 is the exact cost of the result.

    References
    ----------
    Cakmakci & Ulsoy, IEEE/ASME Trans. Mechatronics 14 (2009) 307-316: the idea; weight and norm are ours.
    """
    weights = weights or LqWeights()
    mask = checked_local(local)
    best = np.array([optimum(axis, weights)[0] for axis in axes])
    closed = [a - b @ k[None, :] for (a, b, _, _), k in zip(map(weights.matrices, axes), best, strict=True)]
    poles = np.concatenate([np.linalg.eigvals(matrix) for matrix in closed])
    w = np.geomspace(np.abs(poles).min() / 10**DECADES, np.abs(poles).max() * 10**DECADES, 200)
    s = 1j * w
    basis = np.stack([1.0 / s, np.ones_like(s), s], axis=1)
    n_unknown = int((~mask).sum() + mask.sum() * len(axes))
    rows, right = [], []
    for i, (axis, k) in enumerate(zip(axes, best, strict=True)):
        a, b, _, _ = weights.matrices(axis)
        plant = b[2, 0] / (s * (s - a[2, 2]))
        weighed = (plant / (1.0 + plant * (basis @ k)))[:, None] * basis
        rows.append(weighed @ np.stack([assembled(row, mask, len(axes))[i] for row in np.eye(n_unknown)], axis=1))
        right.append(weighed @ k)
    matrix, target = np.concatenate(rows), np.concatenate(right)
    scale = np.abs(matrix).max(axis=0)
    real = np.vstack([matrix.real, matrix.imag]) / scale
    solution, *_ = np.linalg.lstsq(real, np.concatenate([target.real, target.imag]), rcond=None)
    return judged("three-step", local, assembled(solution / scale, mask, len(axes)), axes, weights)


def lmi_design(axes: Sequence[LinearAxis], weights: LqWeights | None = None) -> tuple[ModularDesign, Array]:
    """Return one set of gains for all axes by linear matrix inequalities, and the bounds on J/J* (n_axis,) that it proves.

    Parameters
    ----------
    weights : LqWeights, optional
        The time unit scales states and time; with 1 s the solvers fail on gains of about 1000.

    Raises
    ------
    ParameterError
        If the solvers fail.

    Notes
    -----
    With X > 0 common to all, K = Y X^-1 and gamma_i > 0::

        [[A_i X + X A_i' - B_i Y - Y' B_i', X Q^.5, Y' R^.5], [., -gamma_i I, 0], [., 0, -gamma_i I]] <= 0,
        [[Z, I], [I, X]] >= 0,  tr Z <= 1,  min sum_i gamma_i / J_i*,

    so that J_i <= gamma_i. The sum of the bounds is minimised: with their maximum, axes other than the worst would suffer.

    References
    ----------
    Ghaffari & Ulsoy, AIM 2016, for the idea; the inequality is the usual one of the linear quadratic problem with a common Lyapunov matrix.
    """
    cvxpy = extra_module("cvxpy")
    weights = weights or LqWeights()
    n, best = len(GAINS), np.array([optimum(axis, weights)[1] for axis in axes])
    x: Any = cvxpy.Variable((n, n), symmetric=True)
    z: Any = cvxpy.Variable((n, n), symmetric=True)
    y: Any = cvxpy.Variable((1, n))
    gamma: Any = cvxpy.Variable(len(axes))
    eye = np.eye(n)
    rules: list[Any] = [cvxpy.bmat([[z, eye], [eye, x]]) >> 0.0, cvxpy.trace(z) <= 1.0]
    for i, axis in enumerate(axes):
        a, b, q, r = weights.matrices(axis)
        first = a @ x + x @ a.T - b @ y - y.T @ b.T
        weighed, asked = x @ np.sqrt(q), y.T @ np.sqrt(r)
        bound = gamma[i] * best[i]
        whole = cvxpy.bmat(
            [[first, weighed, asked], [weighed.T, -bound * eye, np.zeros((n, 1))], [asked.T, np.zeros((1, n)), -bound * np.eye(1)]]
        )
        rules.append(0.5 * (whole + whole.T) << 0.0)
    problem = cvxpy.Problem(cvxpy.Minimize(cvxpy.sum(gamma)), rules)
    if not solved(problem):
        raise ParameterError("axes", f"{len(axes)} of them", "such that one Lyapunov matrix serves them all: take another time_unit")
    gains = np.asarray(y.value) @ np.linalg.inv(np.asarray(x.value))
    return judged("lmi", (), np.repeat(gains, len(axes), axis=0), axes, weights), np.asarray(gamma.value)


def solved(problem: Any) -> bool:
    """Run the solver; return whether it found a solution, possibly an inaccurate one."""
    import warnings

    cvxpy = extra_module("cvxpy")
    try:
        with warnings.catch_warnings():
            # "Solution may be inaccurate": the caller checks every solution.
            warnings.simplefilter("ignore")
            problem.solve(solver="CLARABEL")
    except (cvxpy.error.SolverError, ArithmeticError, ValueError):
        return False
    return problem.status in ("optimal", "optimal_inaccurate") and all(variable.value is not None for variable in problem.variables())
