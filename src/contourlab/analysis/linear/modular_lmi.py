"""Base and local gains by linear matrix inequalities, for all axes at once."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.backlash.lyapunov_lmi import solved
from contourlab.analysis.linear.modular_lq import GAINS, LinearAxis, LqWeights, ModularDesign, judged, optimum
from contourlab.errors import ParameterError

Array = NDArray[np.float64]


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
