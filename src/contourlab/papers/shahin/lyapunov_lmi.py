"""Linear matrix inequalities behind common quadratic Lyapunov functions: what a solver proposes, in coordinates that suit it.

Nothing here is a verdict: `common_lyapunov` proves or rejects every proposal.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.modular_design import solved

Array = NDArray[np.float64]

SOLVERS = ("CLARABEL", "SCS")


def balanced(matrices: list[Array]) -> tuple[list[Array], Array]:
    """Return the matrices over states divided by powers of 2 (n,), which make rows and columns alike in size, and those powers."""
    from scipy.linalg import matrix_balance

    sizes = np.sum([np.abs(a) / max(float(np.abs(a).max()), 1e-300) for a in matrices], axis=0)
    _, (scale, _) = matrix_balance(sizes, permute=False, separate=True)
    return [a * scale / scale[:, None] for a in matrices], np.asarray(scale, dtype=float)


def candidates(matrices: list[Array]) -> Iterator[Array]:
    """Yield proposals for P: closed forms first, then the solver's in the coordinates of each."""
    coordinates = list(frames(matrices))
    for frame in coordinates:
        yield frame.T @ frame
    for frame in coordinates:
        inverse = np.linalg.inv(frame)
        moved = [_unit(frame @ a @ inverse) for a in matrices]
        for solver in SOLVERS:
            p = _margin(moved, solver)
            if p is not None:
                yield frame.T @ p @ frame


def faster(matrices: list[Array]) -> Iterator[Array]:
    """Yield proposals for P with ever faster rates, up to what the slowest eigenvalue bears."""
    bound = min(float(-np.linalg.eigvals(a).real.max()) for a in matrices)
    for share in (0.1, 0.5, 0.75, 0.9, 0.97):
        shifted = [a + share * bound * np.eye(len(a)) for a in matrices]
        for frame in frames(shifted):
            yield frame.T @ frame
            inverse = np.linalg.inv(frame)
            p = _margin([_unit(frame @ a @ inverse) for a in shifted], SOLVERS[0])
            if p is not None:
                yield frame.T @ p @ frame
                break


def alternatives(matrices: list[Array]) -> list[Array]:
    """Return proposals for Z_i > 0 with sum(A_i Z_i + Z_i A_i') > 0; empty if the solver has none."""
    import cvxpy

    n = len(matrices[0])
    moved = [_unit(a) for a in matrices]
    z: Any = [cvxpy.Variable((n, n), symmetric=True) for _ in moved]
    margin: Any = cvxpy.Variable()
    total = sum(a @ each + each @ a.T for a, each in zip(moved, z, strict=True))
    floor = margin * np.eye(n)
    rules = [each >> floor for each in z] + [total >> floor, sum(sum(each[i, i] for i in range(n)) for each in z) == 1.0]
    if not solved(cvxpy.Problem(cvxpy.Maximize(margin), rules), SOLVERS[0]) or not float(margin.value) > 0.0:
        return []
    # The weights that made the matrices alike in size go back into their Z.
    return [np.asarray(each.value) * np.abs(m).max() / np.abs(a).max() for each, a, m in zip(z, matrices, moved, strict=True)]


def _unit(matrix: Array) -> Array:
    """Return a matrix over its largest entry: the inequalities do not mind."""
    return np.asarray(matrix / max(float(np.abs(matrix).max()), 1e-300))


def frames(matrices: list[Array]) -> Iterator[Array]:
    """Yield coordinates in which one of the matrices, or their mean, contracts: factors of solutions of its Lyapunov equation."""
    from scipy.linalg import LinAlgError, solve_continuous_lyapunov

    units = [_unit(a) for a in matrices]
    yield np.eye(len(units[0]))
    for a in (np.sum(units, axis=0), np.sum(matrices, axis=0), *units):
        values, vectors = np.linalg.eig(a)
        if values.real.max() >= 0.0:
            continue
        rights = [np.eye(len(a))]
        if np.linalg.cond(vectors) < 1e12:
            # Weighted by each mode's own rate, so that a slow mode counts as much as a fast one.
            weights = np.linalg.inv(vectors)
            rights.insert(0, ((weights.conj().T * np.abs(values.real)) @ weights).real)
        for q in rights:
            try:
                p = solve_continuous_lyapunov(a.T, -q)
                yield np.asarray(np.linalg.cholesky(0.5 * (p + p.T)).T, dtype=np.float64)
            except (LinAlgError, np.linalg.LinAlgError):
                continue


def _margin(matrices: list[Array], solver: str) -> Array | None:
    """Return the P between 0 and 1 along which all matrices contract by the largest margin."""
    import cvxpy

    n = len(matrices[0])
    p: Any = cvxpy.Variable((n, n), symmetric=True)
    margin: Any = cvxpy.Variable()
    floor = margin * np.eye(n)
    rules = [p >> floor, p << np.eye(n)] + [a.T @ p + p @ a << -floor for a in matrices]
    if not solved(cvxpy.Problem(cvxpy.Maximize(margin), rules), solver):
        return None
    return np.asarray(p.value, dtype=float) if float(margin.value) > 0.0 else None
