"""Linear servo axes that are swapped: what each costs under a state feedback, its own optimum, and one made of base and local gains.

An axis a/(s (s + b)) is fed back from the integral of its position, its position and its velocity, u = -K x. What a gain costs is
J = tr P, the sum of the quadratic costs from unit initial states, each state in turn.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.backlash.lyapunov_lmi import solved
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

GAINS = ("integral", "position", "velocity")
"""Entries of K."""


@dataclass(frozen=True)
class LinearAxis:
    """An axis a/(s (s + b)): acceleration per command [mm/s^2/unit] and damping [1/s]."""

    gain: float
    damping: float

    def __post_init__(self) -> None:
        if not (self.gain > 0.0 and math.isfinite(self.gain)):
            raise ParameterError("gain", f"{self.gain:g}", "> 0 and finite")
        if not math.isfinite(self.damping):
            raise ParameterError("damping", f"{self.damping:g}", "finite")


@dataclass(frozen=True)
class LqWeights:
    """What is weighed, over states in scaled time: integral [mm times the unit], position [mm], velocity [mm per unit], command.

    Attributes
    ----------
    time_unit : float [s], > 0
        Time is counted in it: of the order of the loop's own time, so that the states are alike in size.
    integral, position, velocity : float, >= 0
    command : float, > 0

    Notes
    -----
    No published weights are known for these axes. These put the loops at about 2 Hz and give the losses of the raw drives and of those
    behind the observer that are of the size of the technical brief's.
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
    """Base and local gains, and what they cost.

    Attributes
    ----------
    method : str
    local : tuple of str
        Of `GAINS`: those that each axis has its own value of.
    gains : ndarray (n_axis, 3)
        K of each, base and local together.
    ratio : ndarray (n_axis,)
        J/J*; infinite where the loop does not hold.
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
    """Return J of an axis under gains (3,); infinite where the loop does not hold."""
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
    """Return base and local gains by the direct method, bi-level: the base that is best when each axis does its best with its local gains.

    Parameters
    ----------
    axes : sequence of LinearAxis
    local : sequence of str
        Of `GAINS`.
    weights : LqWeights, optional

    Notes
    -----
    Both levels are one problem here, min over base and local gains of sum_i (J_i/J_i* - 1): the inner minimum of each axis is that of its
    own term. The sum is taken, so that axes that are not the worst count, too.

    References
    ----------
    Li, Kolmanovsky & Ulsoy, "Direct optimal design for component swapping modularity in control systems", IEEE/ASME Trans. Mechatronics 18
    (2013): the method by name; the formula is ours.
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

    mean = np.mean([k for k, _ in known], axis=0) / size
    start = np.concatenate([mean[~mask], *(k[mask] / size[mask] for k, _ in known)])
    found = minimize(total, start, method="Nelder-Mead", options={"xatol": 1e-7, "fatol": 1e-12, "maxiter": 4000, "adaptive": True})
    return judged("direct", local, gains(found.x), axes, weights)


def checked_local(local: Sequence[str]) -> NDArray[np.bool_]:
    """Return which entries of K are local.

    Raises
    ------
    ParameterError
        If a name is none of `GAINS`.
    """
    for name in local:
        if name not in GAINS:
            raise ParameterError("local", repr(name), "of " + ", ".join(GAINS))
    return np.array([name in local for name in GAINS])


def assembled(z: Array, mask: NDArray[np.bool_], n_axis: int) -> Array:
    """Return the gains (n_axis, 3) of a row: base entries, then the local ones axis by axis."""
    n_base = int((~mask).sum())
    found = np.empty((n_axis, mask.size))
    found[:, ~mask] = z[:n_base]
    found[:, mask] = z[n_base:].reshape(n_axis, -1)
    return found


def judged(method: str, local: Sequence[str], gains: Array, axes: Sequence[LinearAxis], weights: LqWeights) -> ModularDesign:
    """Return a design with what it costs on each axis."""
    ratio = [cost(axis, k, weights) / optimum(axis, weights)[1] for axis, k in zip(axes, gains, strict=True)]
    return ModularDesign(method, tuple(local), np.asarray(gains), np.array(ratio))


DECADES = 2.0
"""The grid reaches so far below and above the fastest and slowest of the loops."""


def three_step_design(axes: Sequence[LinearAxis], local: Sequence[str] = (), weights: LqWeights | None = None) -> ModularDesign:
    """Return base and local gains by the 3-step method, the two side by side: K_i = K_base + K_local,i.

    Parameters
    ----------
    axes : sequence of LinearAxis
    local : sequence of str
        Of `contourlab.analysis.linear.modular_design.GAINS`.
    weights : LqWeights, optional

    Notes
    -----
    Step 1 is `optimum` for each axis. Step 2 is the least-squares problem min sum_i,w |W_i (K_i* - K_base - K_local,i)|^2 over a grid of
    frequencies, where K(jw) = k_I/jw + k_P + k_V jw and W_i = G_i/(1 + G_i K_i*), so that an error of the controller counts by what it does
    to the closed loop; gains are its unknowns, so it is linear. Step 3 is the exact cost of what came out.

    References
    ----------
    Cakmakci & Ulsoy, IEEE/ASME Trans. Mechatronics 14 (2009) 307-316: the method by name; weight and norm are ours.
    """
    weights = weights or LqWeights()
    mask = checked_local(local)
    best = np.array([optimum(axis, weights)[0] for axis in axes])
    poles = np.concatenate([_poles(axis, k, weights) for axis, k in zip(axes, best, strict=True)])
    w = np.geomspace(np.abs(poles).min() / 10**DECADES, np.abs(poles).max() * 10**DECADES, 200)
    s = 1j * w
    basis = np.stack([1.0 / s, np.ones_like(s), s], axis=1)
    n_unknown = int((~mask).sum() + mask.sum() * len(axes))
    rows, right = [], []
    for i, (axis, k) in enumerate(zip(axes, best, strict=True)):
        a, b, _, _ = weights.matrices(axis)
        plant = b[2, 0] / (s * (s - a[2, 2]))
        weighed = (plant / (1.0 + plant * (basis @ k)))[:, None] * basis
        unit = np.eye(n_unknown)
        picks = np.stack([assembled(row, mask, len(axes))[i] for row in unit], axis=1)
        rows.append(weighed @ picks)
        right.append(weighed @ k)
    matrix, target = np.concatenate(rows), np.concatenate(right)
    scale = np.abs(matrix).max(axis=0)
    real = np.vstack([matrix.real, matrix.imag]) / scale
    found, *_ = np.linalg.lstsq(real, np.concatenate([target.real, target.imag]), rcond=None)
    return judged("three-step", local, assembled(found / scale, mask, len(axes)), axes, weights)


def _poles(axis: LinearAxis, k: Array, weights: LqWeights) -> Complex:
    a, b, _, _ = weights.matrices(axis)
    return np.asarray(np.linalg.eigvals(a - b @ k[None, :]), dtype=complex)


def lead(frequency: Array, time_constant: float, fast: float) -> Complex:
    """Return (tau s + 1)/(tau_f s + 1) at frequencies [rad/s]: what a swapped lag needs in front of it to look like a faster one.

    Parameters
    ----------
    frequency : ndarray (n,) [rad/s]
    time_constant, fast : float [s], >= 0
    """
    s = 1j * np.asarray(frequency, dtype=float)
    return np.asarray((time_constant * s + 1.0) / (fast * s + 1.0))


def series_allocation(controllers: Complex, local: Callable[[float], Complex], bounds: tuple[float, float]) -> tuple[Complex, Array, float]:
    """Divide controllers into a base one and local ones of one parameter in series, K_i = K_base L(p_i): step 2 for swapped lags.

    Parameters
    ----------
    controllers : ndarray (n_variant, n_frequency)
        Optimal controllers of the variants at the frequencies of a grid.
    local : callable
        Responses (n_frequency,) of the local controller for its parameter.
    bounds : (float, float)
        Of the parameter.

    Returns
    -------
    base : ndarray (n_frequency,)
    parameters : ndarray (n_variant,)
    residual : float
        Largest |K_i/(K_base L_i) - 1| over all variants and frequencies: 0 where one local parameter gives full modularity.

    Notes
    -----
    The parameter of the first variant is found with the rest: the base is the geometric mean of K_i/L_i, and the parameters make the spread
    of log(K_i/L_i) over the variants smallest. A factor that all of them share belongs to the base, so parameters are determined as far as
    the family tells variants apart.
    """
    from scipy.optimize import minimize

    low, high = np.log(bounds)

    def left(z: Array) -> Complex:
        return np.array([k / local(float(p)) for k, p in zip(controllers, np.exp(np.clip(z, low, high)), strict=True)])

    def log_of(rest: Complex) -> Complex:
        return np.asarray(np.log(np.abs(rest)) + 1j * np.unwrap(np.angle(rest), axis=1))

    def spread(z: Array) -> float:
        known = log_of(left(z))
        return float((np.abs(known - known.mean(axis=0)) ** 2).mean())

    start = np.full(len(controllers), 0.5 * (low + high)) + np.linspace(-0.1, 0.1, len(controllers))
    found = minimize(spread, start, method="Nelder-Mead", options={"xatol": 1e-10, "fatol": 1e-20, "maxiter": 20_000, "maxfev": 20_000})
    rest = left(found.x)
    base = np.exp(log_of(rest).mean(axis=0))
    return base, np.exp(np.clip(found.x, low, high)), float(np.abs(rest / base - 1.0).max())


def lmi_design(
    axes: Sequence[LinearAxis], *, local: bool = False, sparsity: float = 0.0, weights: LqWeights | None = None
) -> tuple[ModularDesign, Array]:
    """Return base and local gains by LMI, and the bounds on J/J* (n_axis,) that go with them.

    Parameters
    ----------
    axes : sequence of LinearAxis
    local : bool
        Whether each axis has a local controller, which then is a full one.
    sparsity : float, >= 0
        Weight of sum_i ||Y_i||, which leaves axes without a local controller that gain little by one.
    weights : LqWeights, optional
        Their time unit is what scales states and time; in seconds the solvers fail on gains of some 1000.

    Raises
    ------
    ParameterError
        If the solver finds nothing.

    Notes
    -----
    With X > 0 common to all, K_i = (Y_0 + Y_i) X^-1 and gamma_i > 0::

        [[A_i X + X A_i' - B_i Y - Y' B_i', X Q^.5, Y' R^.5], [., -gamma_i I, 0], [., 0, -gamma_i I]] <= 0,
        [[Z, I], [I, X]] >= 0,  tr Z <= 1,  min sum_i gamma_i / J_i*,

    so that J_i <= gamma_i: the sum of the bounds, as with their maximum axes that are not the worst would suffer. A mask on entries of Y_i
    would be none on those of K_i, as X^-1 mixes them; so the choice here is which axes have a local controller.

    References
    ----------
    Ghaffari & Ulsoy, AIM 2016, for the idea; the inequality is the usual one of the linear quadratic problem with a common Lyapunov matrix.
    """
    import cvxpy as solver_of

    cvxpy: Any = solver_of  # its functions are not typed

    weights = weights or LqWeights()
    n, best = len(GAINS), np.array([optimum(axis, weights)[1] for axis in axes])
    x: Any = cvxpy.Variable((n, n), symmetric=True)
    z: Any = cvxpy.Variable((n, n), symmetric=True)
    base: Any = cvxpy.Variable((1, n))
    own: list[Any] = [cvxpy.Variable((1, n)) if local else np.zeros((1, n)) for _ in axes]
    gamma: Any = cvxpy.Variable(len(axes))
    eye = np.eye(n)
    rules: list[Any] = [cvxpy.bmat([[z, eye], [eye, x]]) >> 0.0, cvxpy.trace(z) <= 1.0]
    for i, axis in enumerate(axes):
        a, b, q, r = weights.matrices(axis)
        y = base + own[i]
        first = a @ x + x @ a.T - b @ y - y.T @ b.T
        weighed, asked = x @ np.sqrt(q), y.T @ np.sqrt(r)
        bound = gamma[i] * best[i]
        whole = cvxpy.bmat(
            [
                [first, weighed, asked],
                [weighed.T, -bound * eye, np.zeros((n, 1))],
                [asked.T, np.zeros((1, n)), -bound * np.eye(1)],
            ]
        )
        rules.append(0.5 * (whole + whole.T) << 0.0)
    price = cvxpy.sum(gamma)
    if local and sparsity > 0.0:
        price = price + sparsity * sum(cvxpy.norm(each) for each in own)
    if not any(solved(cvxpy.Problem(cvxpy.Minimize(price), rules), solver) for solver in ("CLARABEL", "SCS")):
        raise ParameterError("axes", f"{len(axes)} of them", "such that one Lyapunov matrix serves them all: take another time_unit")
    inverse = np.linalg.inv(np.asarray(x.value))
    gains = np.array([(np.asarray(base.value) + (np.asarray(each.value) if local else each)) @ inverse for each in own])[:, 0]
    return judged("lmi", GAINS if local else (), gains, axes, weights), np.asarray(gamma.value)
