"""Questions about small matrices answered in rational arithmetic: every float is a fraction, so that the answers are proofs, not estimates.

Definiteness by elimination, stability by Routh's table of the exact characteristic polynomial, kernels by row reduction.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Rational = tuple[tuple[Fraction, ...], ...]


def rational(matrix: Array) -> Rational:
    """Return the same matrix in fractions, exactly."""
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
    return tuple(tuple(x + y for x, y in zip(one, other, strict=True)) for one, other in zip(left, right, strict=True))


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
    """Whether all eigenvalues have negative real parts: Routh's criterion on the exact characteristic polynomial.

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
