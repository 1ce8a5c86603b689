"""Common quadratic Lyapunov functions: known limits, certificates checked without the solver, and the paper's matrices."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from backlash_loops import PAPER, SCHEME_III, paper_loop
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.linalg import expm

from contourlab.papers.shahin.common_lyapunov import (
    CommonLyapunov,
    characteristic,
    common_quadratic,
    has_hurwitz_roots,
    is_positive_definite,
    kernel,
    rational,
)
from contourlab.papers.shahin.two_inertia_loop import two_inertia_loop

Array = NDArray[np.float64]

ROTATION = np.array([[-1.0, -1.0], [1.0, -1.0]])


def squeezed(ratio: float) -> Array:
    """Return ROTATION with its circles squeezed to ellipses."""
    return np.array([[-1.0, -ratio], [1.0 / ratio, -1.0]])


def holds(matrices: list[Array], found: CommonLyapunov) -> None:
    """Check a feasible answer by eigenvalues: P > 0 and A'P + PA <= -2 rate P, all in P's own frame."""
    assert found.p is not None
    scale = 1.0 / np.sqrt(np.diag(found.p))
    p = found.p * scale * scale[:, None]
    assert np.linalg.eigvalsh(p)[0] > 0.0
    factor = np.linalg.cholesky(p)
    for a in matrices:
        moved = np.linalg.solve(factor, (factor.T @ (a * scale / scale[:, None])).T).T
        assert np.linalg.eigvalsh(0.5 * (moved + moved.T))[-1] <= -found.rate * (1.0 - 1e-6) + 1e-12 * np.linalg.norm(moved)


def refutes(matrices: list[Array], found: CommonLyapunov) -> None:
    """Check an infeasible answer: Z_i >= 0, not all zero, sum(A Z + Z A') >= 0, up to rounding."""
    total, size = np.zeros_like(matrices[0]), 0.0
    for a, z in zip(matrices, found.certificate, strict=True):
        assert np.linalg.eigvalsh(z)[0] >= -1e-14 * max(np.abs(z).max(), 1e-300)
        total = total + a @ z + z @ a.T
        size += np.abs(a).max() * np.abs(z).max()
    assert max(np.abs(z).max() for z in found.certificate) > 0.0
    assert np.linalg.eigvalsh(total)[0] >= -1e-12 * size


def test_the_scheme_of_the_paper_has_none() -> None:
    """The load is free in the gap: its own direction proves it, for schemes II and III."""
    for feedback in (None, SCHEME_III):
        loop = paper_loop() if feedback is None else two_inertia_loop(PAPER, feedback)
        matrices = [loop.gap_matrix, loop.contact_matrix]
        found = common_quadratic(matrices, ("gap", "contact"), loop.names)
        assert found.verdict == "infeasible"
        assert found.p is None
        assert "load position" in found.explanation
        assert "eigenvalue 0" in found.explanation
        refutes(matrices, found)
        assert np.array_equal(found.certificate[0], np.diag(np.eye(loop.n)[2]))


def test_contact_alone_has_one() -> None:
    """Rates from 0.2 to 1.9e5 1/s: P is found, its rate is near the slowest eigenvalue, and the bound holds along motions."""
    for loop in (paper_loop(), two_inertia_loop(PAPER, SCHEME_III)):
        found = common_quadratic([loop.contact_matrix], ("contact",))
        assert found.verdict == "feasible"
        holds([loop.contact_matrix], found)
        slowest = -np.linalg.eigvals(loop.contact_matrix).real.max()
        assert 0.9 * slowest < found.rate <= slowest * (1.0 + 1e-6)
        for direction in np.eye(loop.n):
            for t in (1e-4, 1e-2, 1.0):
                assert np.linalg.norm(expm(loop.contact_matrix * t) @ direction) <= found.overshoot * math.exp(-found.rate * t) * (
                    1.0 + 1e-9
                )


@pytest.mark.parametrize(
    ("ratio", "verdict"), [(2.0, "feasible"), (5.8, "feasible"), (5.828, "feasible"), (5.829, "undecided"), (7.0, "undecided")]
)
def test_a_known_limit(ratio: float, verdict: str) -> None:
    """Dayawansa & Martin's pair: a common function exists only for ratios below 3 + sqrt 8 = 5.8284."""
    matrices = [ROTATION, squeezed(ratio)]
    found = common_quadratic(matrices)
    assert found.verdict == verdict
    if verdict == "feasible":
        holds(matrices, found)


def test_at_the_limit_it_makes_no_false_statement() -> None:
    border = 3.0 + math.sqrt(8.0)
    assert common_quadratic([ROTATION, squeezed(border * (1.0 + 1e-13))]).verdict != "feasible"


@settings(max_examples=8, deadline=None)
@given(
    poles=st.lists(st.floats(-5.0, -0.05), min_size=3, max_size=3),
    others=st.lists(st.floats(-5.0, -0.05), min_size=3, max_size=3),
    frame=st.lists(st.floats(-1.0, 1.0), min_size=9, max_size=9),
    units=st.floats(-4.0, 4.0),
)
def test_commuting_matrices_have_a_common_function(poles: list[float], others: list[float], frame: list[float], units: float) -> None:
    """Narendra & Balakrishnan: Hurwitz matrices that commute always have one, in any units."""
    t = (np.eye(3) + 0.3 * np.array(frame).reshape(3, 3)) * np.array([1.0, 10.0**units, 1.0])[:, None]
    matrices = [t @ np.diag(row) @ np.linalg.inv(t) for row in (poles, others)]
    found = common_quadratic(matrices)
    assert found.verdict == "feasible"
    holds(matrices, found)


@settings(max_examples=60, deadline=None)
@given(entries=st.lists(st.floats(-3.0, 3.0), min_size=16, max_size=16), shift=st.floats(-6.0, 2.0))
def test_routh_agrees_with_eigenvalues(entries: list[float], shift: float) -> None:
    matrix = np.array(entries).reshape(4, 4) + shift * np.eye(4)
    largest = np.linalg.eigvals(matrix).real.max()
    if abs(largest) > 1e-6:
        assert has_hurwitz_roots(characteristic(rational(matrix))) == (largest < 0.0)
    assert [float(c) for c in characteristic(rational(matrix))] == pytest.approx(np.poly(matrix), rel=1e-8, abs=1e-8)


def test_rational_arithmetic_decides_what_floats_cannot() -> None:
    tiny = 2.0**-60
    assert is_positive_definite(rational(np.array([[1.0, 1.0], [1.0, 1.0 + 2.0**-52]])))
    assert not is_positive_definite(rational(np.ones((2, 2))))
    assert has_hurwitz_roots(characteristic(rational(np.array([[0.0, 1.0], [-1.0, -tiny]]))))
    assert not has_hurwitz_roots(characteristic(rational(np.array([[0.0, 1.0], [-1.0, 0.0]]))))
    assert kernel(rational(np.array([[1.0, 1.0], [1.0, 1.0 + 2.0**-52]]))) == ()
    assert kernel(rational(np.array([[1.0, 2.0], [0.5, 1.0]]))) == ((Fraction(-2), Fraction(1)),)
