"""Lur'e-Postnikov functions by a linear matrix inequality: what Popov's criterion promises, with the numbers for a bound.

For V = y'Py/2 + (share/pull) xi^2/2 + q times the spring's energy, V' <= 0 for every torque between 0 and k theta_d follows from

    [ a'P + Pa            -Pb + q a'c' + c' ]
    [ (...)'              -2/k              ]  < 0

in the states of `pole_at_zero`. A solver proposes P; its inequality is then checked by eigenvalues, far from rounding.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.modular_design import solved
from contourlab.papers.shahin.lyapunov_lmi import frames
from contourlab.papers.shahin.pole_at_zero import Split

Array = NDArray[np.float64]

CLEAR = 1e-11
"""How far below zero the largest eigenvalue has to be, over the size of what was added up: well beyond rounding."""


def quadratic_part(split: Split, stiffness: float, q: float) -> Array | None:
    """Return P (n, n) of V = x'Px/2 + the spring's energy over all states of the loop; None if no solver finds one that holds.

    Parameters
    ----------
    split : Split
    stiffness : float
    q : float, > 0 [s]
        Popov's multiplier.
    """
    # The torque over the stiffness lies in the sector up to 1; states of which torque and difference ask alike.
    size = math.sqrt(stiffness * float(np.linalg.norm(split.b)) / float(np.linalg.norm(split.c)))
    a, b, c = split.a, split.b * stiffness / size, split.c * size
    for frame in frames([a]):
        inverse = np.linalg.inv(frame)
        moved, entering, row = frame @ a @ inverse, frame @ b, c @ inverse
        p = _proposed(moved, entering, row, q)
        if p is not None and _holds(p, moved, entering, row, q):
            inner = frame.T @ p @ frame / size**2
            free = split.share / (stiffness * split.pull) if split.pull else 0.0
            whole = split.project.T @ inner @ split.project + free * np.outer(split.along, split.along)
            return np.asarray(whole * stiffness / q)
    return None


def _inequality(p: Any, a: Array, b: Array, c: Array, q: float) -> tuple[Any, Any]:
    """Return the first block and the column beside it."""
    return a.T @ p + p @ a, -p @ b + q * (a.T @ c) + c


def _holds(p: Array, a: Array, b: Array, c: Array, q: float) -> bool:
    """Whether P > 0 and the inequality holds, clear of rounding."""
    if np.linalg.eigvalsh(p)[0] <= CLEAR * np.abs(p).max():
        return False
    block, column = _inequality(p, a, b, c, q)
    whole = np.block([[block, column[:, None]], [column[None, :], np.array([[-2.0]])]])
    # A negative definite matrix stays so with its diagonal made -1, which makes its eigenvalues tell.
    if (np.diag(whole) >= 0.0).any():
        return False
    scale = 1.0 / np.sqrt(-np.diag(whole))
    products = np.abs(a).T @ np.abs(p) + np.abs(p) @ np.abs(a)
    beside = np.abs(p) @ np.abs(b) + q * np.abs(a).T @ np.abs(c) + np.abs(c)
    rounding = np.block([[products, beside[:, None]], [beside[None, :], np.array([[2.0]])]]) * scale * scale[:, None]
    return bool(np.linalg.eigvalsh(whole * scale * scale[:, None])[-1] < -CLEAR * max(1.0, float(np.linalg.norm(rounding))))


def _proposed(a: Array, b: Array, c: Array, q: float) -> Array | None:
    """Return a solver's P."""
    import cvxpy

    n = len(a)
    p: Any = cvxpy.Variable((n, n), symmetric=True)
    whole: Any = cvxpy.Variable((n + 1, n + 1), symmetric=True)
    margin: Any = cvxpy.Variable()
    block, column = _inequality(p, a, b, c, q)
    rates = np.maximum(np.abs(np.diag(a)), 1e-6 * np.abs(a).max())
    floor = np.diag(np.append(rates, 1.0))
    rules = [whole[:n, :n] == block, whole[:n, n] == column, whole[n, n] == -2.0, whole << -margin * floor, p >> margin * 1e-3 * np.eye(n)]
    if not solved(cvxpy.Problem(cvxpy.Maximize(margin), [*rules, margin <= 1.0]), "CLARABEL"):
        return None
    return np.asarray(0.5 * (p.value + p.value.T)) if float(margin.value) > 0.0 else None
