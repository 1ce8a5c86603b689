"""Common quadratic Lyapunov functions of switched linear systems: found and proved, or refuted with a certificate.

P > 0 with A_i' P + P A_i < 0 for all i exists if and only if there are no Z_i >= 0, not all zero, with sum(A_i Z_i + Z_i A_i') >= 0
(theorem of alternatives). A solver proposes P or the Z_i; whether they are what they claim is then decided in rational arithmetic, on the
floats as they were given, so that no verdict rests on a solver's status or on rounding.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import ParameterError
from contourlab.papers.shahin import lyapunov_lmi
from contourlab.papers.shahin.exact_arithmetic import Rational, add, is_hurwitz, is_positive_definite, kernel, lyapunov, rational, transpose

Array = NDArray[np.float64]

LARGEST = 24
"""States beyond which the proofs would take longer than anyone waits."""


@dataclass(frozen=True, eq=False)
class CommonLyapunov:
    """The answer.

    Attributes
    ----------
    verdict : "feasible", "infeasible" or "undecided"
    p : ndarray (n, n) or None
        V = x' P x, in the states as given, scaled to a largest eigenvalue of 1.
    overshoot, rate : float
        alpha_1 and alpha_2 [1/s] of |x(t)| <= alpha_1 exp(-alpha_2 t) |x(0)|, eq (17) of Shahin, ElMaraghy & ElBeheiry, under any
        switching; nan unless feasible. The norm is that of the states as given, so alpha_1 depends on their units.
    certificate : tuple of ndarray (n, n)
        Z_i, one for each matrix, if infeasible.
    explanation : str
        What is proved, in words.
    """

    verdict: str
    p: Array | None
    overshoot: float
    rate: float
    certificate: tuple[Array, ...]
    explanation: str

    def __str__(self) -> str:
        return f"{self.verdict}: {self.explanation}"


def common_quadratic(matrices: Sequence[ArrayLike], names: Sequence[str] = (), states: Sequence[str] = ()) -> CommonLyapunov:
    """Decide whether switched linear systems x' = A_i x have a common quadratic Lyapunov function.

    Parameters
    ----------
    matrices : sequence of array_like (n, n)
        A_i [1/s]; their floats are taken for exact.
    names : sequence of str, optional
        Of the matrices, as "gap" and "contact".
    states : sequence of str, optional
        Names of the states.

    Returns
    -------
    CommonLyapunov
        "undecided" where neither answer could be proved: at the border between the two.

    Raises
    ------
    ParameterError
        For matrices of different shapes, with inf or nan, or with more than 24 states.
    """
    given = _checked(matrices)
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


def _checked(matrices: Sequence[ArrayLike]) -> list[Array]:
    given = [np.asarray(matrix, dtype=float) for matrix in matrices]
    if not given:
        raise ParameterError("matrices", "none", "at least one")
    n = len(np.atleast_1d(given[0]))
    for i, a in enumerate(given):
        if a.shape != (n, n) or not np.isfinite(a).all():
            raise ParameterError(f"matrices[{i}]", f"an array of shape {a.shape}", f"finite and of shape {(n, n)}, as the first")
    if n > LARGEST:
        raise ParameterError("matrices", f"{n} states", f"{LARGEST} states at most")
    return given


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
    """Return P, made better for a fast rate as long as it stays proved, with the constants of eq (17)."""
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
    """Return the largest alpha with A' P + P A <= -2 alpha P for all A, a little on the safe side of rounding."""
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
    """Return the certificate Z = Re(v v*) of a matrix that does not decay by itself."""
    zero = np.zeros_like(given[i])
    resting = kernel(exact)
    if resting:
        v = np.array([float(x) for x in resting[0]])
        words = _named(v, states)
        text = (
            f"the {name} matrix takes the vector {words} to zero exactly (eigenvalue 0): along it nothing moves, so x'Px cannot fall "
            f"there, whatever P. No strict common quadratic Lyapunov function exists"
        )
        z = np.outer(v, v)
    else:
        values, vectors = np.linalg.eig(given[i])
        at = int(np.argmax(values.real))
        vector, value = vectors[:, at], complex(values[at])
        z = np.outer(vector, vector.conj()).real
        text = (
            f"the {name} matrix is not Hurwitz (Routh's table in rational arithmetic; eigenvalue {value.real:.4g} {value.imag:+.4g}j): its "
            f"motion along that eigenvector does not decay, so x'Px cannot fall there. No strict common quadratic Lyapunov function exists"
        )
    certificate = tuple(z if j == i else zero for j in range(len(given)))
    return CommonLyapunov("infeasible", None, math.nan, math.nan, certificate, text)


def _named(v: Array, states: Sequence[str]) -> str:
    names = tuple(states) or tuple(f"state {i + 1}" for i in range(v.size))
    parts = [f"{value:g} {name}" for value, name in zip(v / np.abs(v).max(), names, strict=True) if value != 0.0]
    return "(" + ", ".join(parts) + ")"


def _refuted(exact: list[Rational], proposed: list[Array], scale: Array, labels: tuple[str, ...]) -> CommonLyapunov:
    """Return the solver's certificate if it is one; a verdict of "undecided" if not."""
    certificate = tuple(0.5 * (z + z.T) for z in (z * scale[:, None] * scale for z in proposed))
    if certificate and _refutes(exact, certificate):
        text = (
            f"there are Z_i > 0 with sum(A_i Z_i + Z_i A_i') > 0 over {_joined(labels)} (proved in rational arithmetic): for any P > 0 the "
            "traces of (A_i'P + PA_i) Z_i add up to more than 0, so they cannot all be negative. No common quadratic Lyapunov function "
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
