"""Common quadratic Lyapunov functions of switched linear systems: found and proved, or refuted with a certificate.

P > 0 with A_i' P + P A_i < 0 for all i exists if and only if there are no Z_i >= 0, not all zero, with sum(A_i Z_i + Z_i A_i') >= 0
(theorem of alternatives). A solver proposes P or the Z_i. Rational arithmetic on the given floats then proves or rejects the proposal, so
that no verdict depends on a solver's status or on rounding.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.backlash import lyapunov_lmi

Array = NDArray[np.float64]
Rational = tuple[tuple[Fraction, ...], ...]


@dataclass(frozen=True, eq=False)
class CommonLyapunov:
    """Verdict of `common_quadratic`.

    Attributes
    ----------
    verdict : "feasible", "infeasible" or "undecided"
    p : ndarray (n, n) or None
        V = x' P x, in the states as given, scaled to a largest eigenvalue of 1.
    overshoot, rate : float
        alpha_1 and alpha_2 [1/s] of |x(t)| <= alpha_1 exp(-alpha_2 t) |x(0)|, eq (17) of the paper, under any switching; nan unless
        feasible. The norm is that of the states as given, so alpha_1 depends on their units.
    certificate : tuple of ndarray (n, n)
        Z_i, one for each matrix, if infeasible.
    explanation : str
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
    names : sequence of str, optional
        Of the matrices, for example "gap" and "contact".
    states : sequence of str, optional
        Names of the states.

    Returns
    -------
    CommonLyapunov
        "undecided" if neither answer could be proved: close to the border between the two.
    """
    given = list(matrices)
    labels = tuple(names) or tuple(f"matrix {i + 1}" for i in range(len(given)))
    exact = [rational(a) for a in given]
    for i, (name, matrix) in enumerate(zip(labels, exact, strict=True)):
        if not is_hurwitz(matrix):
            return _not_hurwitz(given, i, name, matrix, states)
    scaled, scale = lyapunov_lmi.balanced(given)
    for candidate in lyapunov_lmi.candidates(scaled):
        p = candidate / scale[:, None] / scale
        if _proves(exact, p):
            return _feasible(given, exact, scaled, scale, p, labels)
    return _refuted(exact, lyapunov_lmi.alternatives(scaled), scale, labels)


def _proves(exact: list[Rational], p: Array) -> bool:
    """Whether P > 0 and all -(A' P + P A) > 0, in rational arithmetic."""
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
    for candidate in lyapunov_lmi.faster(scaled):
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
    """Return the largest alpha with A' P + P A <= -2 alpha P for all A, rounded to the safe side."""
    from scipy.linalg import solve_triangular

    balanced = p * scale * scale[:, None]
    try:
        factor = np.linalg.cholesky(0.5 * (balanced + balanced.T))
    except np.linalg.LinAlgError:
        return 0.0
    worst = math.inf
    for a in given:
        # In coordinates in which V is the squared length, the rate is that of the symmetric part.
        inside = factor.T @ (a * scale / scale[:, None])
        moved = solve_triangular(factor, inside.T, lower=True).T
        growth = float(np.linalg.eigvalsh(0.5 * (moved + moved.T))[-1])
        worst = min(worst, -growth - 1e-13 * float(np.linalg.norm(moved)))
    return max(worst, 0.0)


def _not_hurwitz(given: list[Array], i: int, name: str, exact: Rational, states: Sequence[str]) -> CommonLyapunov:
    """Return the certificate Z = Re(v v*) for a matrix that does not decay by itself."""
    zero = np.zeros_like(given[i])
    resting = kernel(exact)
    if resting:
        v = np.array([float(x) for x in resting[0]])
        words = _named(v, states)
        text = (
            f"the {name} matrix maps {words} to zero exactly (eigenvalue 0): nothing moves along it, so x'Px cannot fall there for any P. "
            "No strict common quadratic Lyapunov function exists"
        )
        z = np.outer(v, v)
    else:
        values, vectors = np.linalg.eig(given[i])
        at = int(np.argmax(values.real))
        vector, value = vectors[:, at], complex(values[at])
        z = np.outer(vector, vector.conj()).real
        text = (
            f"the {name} matrix is not Hurwitz (Routh's table in rational arithmetic; eigenvalue {value.real:.4g} {value.imag:+.4g}j): "
            "motion along that eigenvector does not decay, so x'Px cannot fall there. No strict common quadratic Lyapunov function exists"
        )
    certificate = tuple(z if j == i else zero for j in range(len(given)))
    return CommonLyapunov("infeasible", None, math.nan, math.nan, certificate, text)


def _named(v: Array, states: Sequence[str]) -> str:
    names = tuple(states) or tuple(f"state {i + 1}" for i in range(v.size))
    parts = [f"{value:g} {name}" for value, name in zip(v / np.abs(v).max(), names, strict=True) if value != 0.0]
    return "(" + ", ".join(parts) + ")"


def _refuted(exact: list[Rational], proposed: list[Array], scale: Array, labels: tuple[str, ...]) -> CommonLyapunov:
    """Return "infeasible" if the solver's certificate is proved, "undecided" if not."""
    certificate = tuple(0.5 * (z + z.T) for z in (z * scale[:, None] * scale for z in proposed))
    if certificate and _refutes(exact, certificate):
        text = (
            f"there are Z_i > 0 with sum(A_i Z_i + Z_i A_i') > 0 over {_joined(labels)} (proved in rational arithmetic): for any P > 0 the "
            "traces of (A_i'P + PA_i) Z_i sum to more than 0, so they cannot all be negative. No common quadratic Lyapunov function "
            "exists, though each matrix decays by itself"
        )
        return CommonLyapunov("infeasible", None, math.nan, math.nan, certificate, text)
    text = f"neither a common P nor a certificate against one could be proved for {_joined(labels)}: too close to the border"
    return CommonLyapunov("undecided", None, math.nan, math.nan, (), text)


def _refutes(exact: list[Rational], certificate: tuple[Array, ...]) -> bool:
    """Whether all Z_i > 0 and sum(A_i Z_i + Z_i A_i') > 0, in rational arithmetic."""
    if not all(np.isfinite(z).all() for z in certificate):
        return False
    fractions = [rational(z) for z in certificate]
    if not all(is_positive_definite(z) for z in fractions):
        return False
    total = lyapunov(transpose(exact[0]), fractions[0])
    for a, z in zip(exact[1:], fractions[1:], strict=True):
        total = add(total, lyapunov(transpose(a), z))
    return is_positive_definite(total)


def _joined(labels: tuple[str, ...]) -> str:
    return labels[0] if len(labels) == 1 else ", ".join(labels[:-1]) + " and " + labels[-1]


def rational(matrix: Array) -> Rational:
    """Return a matrix in exact fractions, so that all that follows is proof and not estimate."""
    return tuple(tuple(Fraction(float(value)) for value in row) for row in matrix)


def product(left: Rational, right: Rational) -> Rational:
    """Return the matrix product."""
    columns = tuple(zip(*right, strict=True))
    return tuple(tuple(sum((x * y for x, y in zip(row, column, strict=True)), Fraction(0)) for column in columns) for row in left)


def transpose(matrix: Rational) -> Rational:
    """Return the transpose."""
    return tuple(zip(*matrix, strict=True))


def add(left: Rational, right: Rational) -> Rational:
    """Return the sum."""
    return tuple(tuple(x + y for x, y in zip(*rows, strict=True)) for rows in zip(left, right, strict=True))


def lyapunov(a: Rational, p: Rational) -> Rational:
    """Return a' p + p a for a symmetric p."""
    half = product(p, a)
    return add(half, transpose(half))


def is_positive_definite(matrix: Rational) -> bool:
    """Whether a symmetric matrix is positive definite: all pivots of its elimination are above 0.

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


def is_hurwitz(matrix: Rational) -> bool:
    """Whether all eigenvalues have negative real parts, by Routh's criterion on the exact characteristic polynomial.

    >>> is_hurwitz(rational(np.array([[0.0, 1.0], [-1.0, -1e-300]])))
    True
    >>> is_hurwitz(rational(np.array([[0.0, 1.0], [-1.0, 0.0]])))
    False
    """
    return has_hurwitz_roots(characteristic(matrix))


def has_hurwitz_roots(polynomial: tuple[Fraction, ...]) -> bool:
    """Whether all roots of a polynomial, highest power first and 1, have negative real parts: Routh's table."""
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
    """Return the characteristic polynomial, highest power first: Faddeev and LeVerrier."""
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
    """Return a basis of the vectors that a matrix takes to 0, by row reduction; empty for a regular matrix.

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
