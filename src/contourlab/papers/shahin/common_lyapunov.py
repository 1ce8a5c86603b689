"""Common quadratic Lyapunov functions of switched linear systems: found and proved, or refuted with a certificate.

P > 0 with A_i' P + P A_i < 0 for all i exists only if there are no Z_i >= 0, not all zero, with sum(A_i Z_i + Z_i A_i') >= 0. A vector v
with A_i v = 0 gives such a certificate, Z_i = v v'. Otherwise a solver proposes P, and rational arithmetic on the given floats proves or
rejects it. So the verdict depends neither on the status of a solver nor on rounding.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from contourlab.analysis.linear.modular_design import solved
from contourlab.arrays import Array
from contourlab.extras import extra_module

Rational = tuple[tuple[Fraction, ...], ...]


@dataclass(frozen=True, eq=False)
class CommonLyapunov:
    """Verdict of `common_quadratic`.

    Attributes
    ----------
    verdict : "feasible", "infeasible" or "undecided"
    p : ndarray (n, n) or None
        V = x' P x, in the given states, scaled to a largest eigenvalue of 1.
    overshoot, rate : float
        alpha_1 and alpha_2 [1/s] of |x(t)| <= alpha_1 exp(-alpha_2 t) |x(0)|, eq (17) of the paper, under any switching; nan unless
        feasible. The norm is that of the given states, so alpha_1 depends on their units.
    certificate : tuple of ndarray (n, n)
        Z_i, one for each matrix, if infeasible.
    """

    verdict: str
    p: Array | None
    overshoot: float
    rate: float
    certificate: tuple[Array, ...]
    explanation: str

    def __str__(self) -> str:
        return f"{self.verdict}: {self.explanation}"


def common_quadratic(matrices: Sequence[Array], names: Sequence[str] = (), states: Sequence[str] = ()) -> CommonLyapunov:
    """Decide whether switched linear systems x' = A_i x have a common quadratic Lyapunov function.

    Parameters
    ----------
    matrices : sequence of ndarray (n, n)
        A_i [1/s], taken as exact.

    Returns
    -------
    CommonLyapunov
        "undecided" if neither "feasible" nor "infeasible" can be proved.
    """
    given = list(matrices)
    labels = tuple(names) or tuple(f"matrix {i + 1}" for i in range(len(given)))
    exact = [rational(a) for a in given]
    for i, (name, matrix) in enumerate(zip(labels, exact, strict=True)):
        resting = kernel(matrix)
        if resting:
            return _with_zero(given, i, name, np.array([float(x) for x in resting[0]]), states)
    scaled, scale = _balanced(given)
    for candidate in _candidates(scaled):
        p = candidate / scale[:, None] / scale
        if _proves(exact, p):
            return _feasible(given, exact, scaled, scale, p, labels)
    text = f"no common P is proved for {_joined(labels)}"
    return CommonLyapunov("undecided", None, math.nan, math.nan, (), text)


def _proves(exact: list[Rational], p: Array) -> bool:
    """Return whether P > 0 and all -(A' P + P A) > 0, in rational arithmetic."""
    if not np.isfinite(p).all():
        return False
    fractions = rational(0.5 * (p + p.T))
    if not is_positive_definite(fractions):
        return False
    return all(is_positive_definite(_negative(lyapunov(a, fractions))) for a in exact)


def _negative(matrix: Rational) -> Rational:
    return tuple(tuple(-x for x in row) for row in matrix)


def _feasible(
    given: list[Array], exact: list[Rational], scaled: list[Array], scale: Array, p: Array, labels: tuple[str, ...]
) -> CommonLyapunov:
    """Return the proved P with the fastest rate found, and the constants of eq (17)."""
    for candidate in _faster(scaled):
        tried = candidate / scale[:, None] / scale
        if _proves(exact, tried) and _rate(given, tried, scale) > _rate(given, p, scale):
            p = tried
    p = 0.5 * (p + p.T)
    p = p / float(np.linalg.eigvalsh(p)[-1])
    rate, values = _rate(given, p, scale), np.linalg.eigvalsh(p)
    overshoot = math.sqrt(float(values[-1] / values[0])) if values[0] > 0.0 else math.inf
    switching = " under any switching between them" if len(labels) > 1 else ""
    bound = f"|x(t)| <= {overshoot:.4g} exp(-{rate:.4g} t) |x(0)|"
    text = f"V = x'Px falls along {_joined(labels)} (proved in rational arithmetic), so{switching} {bound}"
    return CommonLyapunov("feasible", p, overshoot, rate, (), text)


def _rate(given: list[Array], p: Array, scale: Array) -> float:
    """Return the largest alpha with A' P + P A <= -2 alpha P for all A, rounded down."""
    from scipy.linalg import solve_triangular

    balanced = p * scale * scale[:, None]
    try:
        factor = np.linalg.cholesky(0.5 * (balanced + balanced.T))
    except np.linalg.LinAlgError:
        return 0.0
    worst = math.inf
    for a in given:
        # In coordinates in which V is the squared norm, the symmetric part gives the rate.
        inside = factor.T @ (a * scale / scale[:, None])
        moved = solve_triangular(factor, inside.T, lower=True).T
        growth = float(np.linalg.eigvalsh(0.5 * (moved + moved.T))[-1])
        worst = min(worst, -growth - 1e-13 * float(np.linalg.norm(moved)))
    return max(worst, 0.0)


def _with_zero(given: list[Array], i: int, name: str, v: Array, states: Sequence[str]) -> CommonLyapunov:
    """Return the certificate Z = v v' of a matrix that maps v to zero."""
    text = (
        f"the {name} matrix maps {_named(v, states)} to exactly zero (eigenvalue 0): nothing moves in this direction, so x'Px cannot fall "
        "there for any P. No strict common quadratic Lyapunov function exists"
    )
    certificate = tuple(np.outer(v, v) if j == i else np.zeros_like(a) for j, a in enumerate(given))
    return CommonLyapunov("infeasible", None, math.nan, math.nan, certificate, text)


def _named(v: Array, states: Sequence[str]) -> str:
    names = tuple(states) or tuple(f"state {i + 1}" for i in range(v.size))
    parts = [f"{value:g} {name}" for value, name in zip(v / np.abs(v).max(), names, strict=True) if value != 0.0]
    return "(" + ", ".join(parts) + ")"


def _joined(labels: tuple[str, ...]) -> str:
    return labels[0] if len(labels) == 1 else ", ".join(labels[:-1]) + " and " + labels[-1]


def _balanced(matrices: list[Array]) -> tuple[list[Array], Array]:
    """Return the matrices with states scaled by powers of 2 (n,) that balance rows and columns, and these powers."""
    from scipy.linalg import matrix_balance

    sizes = np.sum([np.abs(a) / max(float(np.abs(a).max()), 1e-300) for a in matrices], axis=0)
    _, (scale, _) = matrix_balance(sizes, permute=False, separate=True)
    return [a * scale / scale[:, None] for a in matrices], np.asarray(scale, dtype=float)


def _candidates(matrices: list[Array]) -> Iterator[Array]:
    """Yield proposals for P: closed forms first, then those of the solver in the coordinates of each closed form."""
    coordinates = list(_frames(matrices))
    for frame in coordinates:
        yield frame.T @ frame
    for frame in coordinates:
        inverse = np.linalg.inv(frame)
        p = _margin([_unit(frame @ a @ inverse) for a in matrices])
        if p is not None:
            yield frame.T @ p @ frame


def _faster(matrices: list[Array]) -> Iterator[Array]:
    """Yield proposals for P with increasing rates, up to that of the slowest eigenvalue."""
    bound = min(float(-np.linalg.eigvals(a).real.max()) for a in matrices)
    for share in (0.1, 0.5, 0.75, 0.9, 0.97):
        shifted = [a + share * bound * np.eye(len(a)) for a in matrices]
        for frame in _frames(shifted):
            yield frame.T @ frame
            inverse = np.linalg.inv(frame)
            p = _margin([_unit(frame @ a @ inverse) for a in shifted])
            if p is not None:
                yield frame.T @ p @ frame
                break


def _unit(matrix: Array) -> Array:
    """Divide a matrix by its largest entry, which does not change the inequalities."""
    return np.asarray(matrix / max(float(np.abs(matrix).max()), 1e-300))


def _frames(matrices: list[Array]) -> Iterator[Array]:
    """Yield coordinates in which a matrix, or the sum, contracts: factors of solutions of its Lyapunov equation."""
    from scipy.linalg import LinAlgError, solve_continuous_lyapunov

    units = [_unit(a) for a in matrices]
    yield np.eye(len(units[0]))
    for a in (np.sum(units, axis=0), np.sum(matrices, axis=0), *units):
        values, vectors = np.linalg.eig(a)
        if values.real.max() >= 0.0:
            continue
        rights = [np.eye(len(a))]
        if np.linalg.cond(vectors) < 1e12:
            # Weighted by each mode's rate, so that slow and fast modes count equally.
            weights = np.linalg.inv(vectors)
            rights.insert(0, ((weights.conj().T * np.abs(values.real)) @ weights).real)
        for q in rights:
            try:
                p = solve_continuous_lyapunov(a.T, -q)
                yield np.asarray(np.linalg.cholesky(0.5 * (p + p.T)).T, dtype=np.float64)
            except (LinAlgError, np.linalg.LinAlgError):
                continue


def _margin(matrices: list[Array]) -> Array | None:
    """Return the P between 0 and the identity with the largest contraction margin."""
    cvxpy = extra_module("cvxpy")

    n = len(matrices[0])
    p: Any = cvxpy.Variable((n, n), symmetric=True)
    margin: Any = cvxpy.Variable()
    floor = margin * np.eye(n)
    rules = [p >> floor, p << np.eye(n)] + [a.T @ p + p @ a << -floor for a in matrices]
    if not solved(cvxpy.Problem(cvxpy.Maximize(margin), rules)):
        return None
    return np.asarray(p.value, dtype=float) if float(margin.value) > 0.0 else None


def rational(matrix: Array) -> Rational:
    """Return a matrix as exact fractions."""
    return tuple(tuple(Fraction(float(value)) for value in row) for row in matrix)


def product(left: Rational, right: Rational) -> Rational:
    """Return the matrix product."""
    columns = tuple(zip(*right, strict=True))
    return tuple(tuple(sum((x * y for x, y in zip(row, column, strict=True)), Fraction(0)) for column in columns) for row in left)


def transpose(matrix: Rational) -> Rational:
    """Return the transpose."""
    return tuple(zip(*matrix, strict=True))


def lyapunov(a: Rational, p: Rational) -> Rational:
    """Return a' p + p a for a symmetric p."""
    half = product(p, a)
    return tuple(tuple(x + y for x, y in zip(*rows, strict=True)) for rows in zip(half, transpose(half), strict=True))


def is_positive_definite(matrix: Rational) -> bool:
    """Return whether a symmetric matrix is positive definite: all pivots of its elimination are above 0.

    >>> is_positive_definite(rational(np.array([[2.0, 1.0], [1.0, 1.0]])))
    True
    """
    if matrix != transpose(matrix):
        return False
    rows = [list(row) for row in matrix]
    for k, pivot_row in enumerate(rows):
        pivot = pivot_row[k]
        if pivot <= 0:
            return False
        for row in rows[k + 1 :]:
            share = row[k] / pivot
            if share:
                row[k:] = [x - share * y for x, y in zip(row[k:], pivot_row[k:], strict=True)]
    return True


def has_hurwitz_roots(polynomial: tuple[Fraction, ...]) -> bool:
    """Return whether all roots of a monic polynomial, highest power first, have negative real parts (Routh's table).

    >>> has_hurwitz_roots(characteristic(rational(np.array([[0.0, 1.0], [-1.0, -1e-300]]))))
    True
    >>> has_hurwitz_roots(characteristic(rational(np.array([[0.0, 1.0], [-1.0, 0.0]]))))
    False
    """
    upper, lower = polynomial[0::2], polynomial[1::2]
    if any(value <= 0 for value in polynomial):
        return False
    while lower:
        if lower[0] <= 0:
            return False
        share = upper[0] / lower[0]
        padded = (*lower[1:], *[Fraction(0)] * (len(upper) - len(lower)))
        upper, lower = lower, tuple(x - share * y for x, y in zip(upper[1:], padded, strict=False))
    return True


def characteristic(matrix: Rational) -> tuple[Fraction, ...]:
    """Return the characteristic polynomial, highest power first (Faddeev-LeVerrier)."""
    n = len(matrix)
    coefficients = [Fraction(1)]
    m: Rational = tuple(tuple(Fraction(0) for _ in range(n)) for _ in range(n))
    for k in range(1, n + 1):
        m = product(matrix, m)
        m = tuple(tuple(value + (coefficients[-1] if i == j else 0) for j, value in enumerate(row)) for i, row in enumerate(m))
        trace = sum((row[i] for i, row in enumerate(product(matrix, m))), Fraction(0))
        coefficients.append(-trace / k)
    return tuple(coefficients)


def kernel(matrix: Rational) -> tuple[tuple[Fraction, ...], ...]:
    """Return a basis of the kernel of a matrix, by row reduction; empty for a regular matrix.

    >>> [[float(x) for x in v] for v in kernel(rational(np.array([[0.0, 1.0], [0.0, 0.0]])))]
    [[1.0, 0.0]]
    """
    rows, n = [list(row) for row in matrix], len(matrix[0])
    pivots: list[int] = []
    for column in range(n):
        at = next((i for i in range(len(pivots), len(rows)) if rows[i][column] != 0), None)
        if at is None:
            continue
        here = len(pivots)
        rows[here], rows[at] = rows[at], rows[here]
        lead = rows[here][column]
        rows[here] = [value / lead for value in rows[here]]
        for i, row in enumerate(rows):
            if i != here and row[column] != 0:
                rows[i] = [x - row[column] * y for x, y in zip(row, rows[here], strict=True)]
        pivots.append(column)
    free = [column for column in range(n) if column not in pivots]
    return tuple(_vector(rows, pivots, column, n) for column in free)


def _vector(rows: list[list[Fraction]], pivots: list[int], free: int, n: int) -> tuple[Fraction, ...]:
    vector = [Fraction(0)] * n
    vector[free] = Fraction(1)
    for row, pivot in zip(rows, pivots, strict=False):
        vector[pivot] = -row[free]
    return tuple(vector)
