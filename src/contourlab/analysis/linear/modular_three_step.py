"""The 3-step method: optimal centralised controllers, allocated to base and local ones over frequency, verified in closed loop."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.modular_lq import LinearAxis, LqWeights, ModularDesign, assembled, checked_local, judged, optimum

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
DECADES = 2.0
"""The grid reaches so far below and above the fastest and slowest of the loops."""


def three_step_design(axes: Sequence[LinearAxis], local: Sequence[str] = (), weights: LqWeights | None = None) -> ModularDesign:
    """Return base and local gains by the 3-step method, the two side by side: K_i = K_base + K_local,i.

    Parameters
    ----------
    axes : sequence of LinearAxis
    local : sequence of str
        Of `contourlab.analysis.linear.modular_lq.GAINS`.
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
