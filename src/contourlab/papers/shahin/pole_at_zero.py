"""The linear part of a loop with a gap without its pole at zero: a load without a position of its own is taken out exactly.

With v in the kernel of a, u in that of a', u'v = 1: x = y + v xi, xi = u'x, and xi' = -(u'b) T. What is left, y, has to decay by itself.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.backlash.lure import BacklashLoop
from contourlab.papers.shahin.exact_arithmetic import characteristic, has_hurwitz_roots, kernel, rational, transpose

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Split:
    """y' = a y - b T, theta_d = c y + share xi, xi' = -pull T; a is Hurwitz, proved in rational arithmetic on the loop's own matrix.

    Attributes
    ----------
    a : ndarray (m, m), b : ndarray (m,), c : ndarray (m,)
        In balanced states.
    project : ndarray (m, n)
        y = project x.
    along : ndarray (n,)
        u: xi = u'x; zero without a pole at zero.
    share, pull : float
        c v and u'b: G has the residue share pull at zero.
    """

    a: Array
    b: Array
    c: Array
    project: Array
    along: Array
    share: float
    pull: float

    @property
    def residue(self) -> float:
        """g of G(s) = g/s + ...; 0 without a pole at zero."""
        return self.share * self.pull


def without_pole_at_zero(loop: BacklashLoop) -> Split | str:
    """Return the linear part without its pole at zero; or, in words, why it has none that fits."""
    if loop.shaft_damping > 0.0:
        return "the torque of a damped shaft depends on its past, not on the motor-load difference alone"
    exact = rational(loop.a)
    right, left = kernel(exact), kernel(transpose(exact))
    if not right:
        if not has_hurwitz_roots(characteristic(exact)):
            return "the linear part is not Hurwitz"
        return _balanced(loop, np.eye(loop.n), np.eye(loop.n), np.zeros(loop.n), np.zeros(loop.n))
    overlap = sum(x * y for x, y in zip(right[0], left[0], strict=True))
    if len(right) > 1 or overlap == 0:
        return "the linear part has a double pole at zero: a load that nothing slows in the gap, or a motor that runs on while it rests"
    if not has_hurwitz_roots(characteristic(exact)[:-1]):
        return "the linear part, but for its pole at zero, is not Hurwitz"
    v, u = np.array([float(x) for x in right[0]]), np.array([float(x / overlap) for x in left[0]])
    if float(loop.c @ v) * float(u @ loop.b) <= 0.0:
        return "the pole at zero has the wrong sign: a constant difference does not draw motor and load together"
    from scipy.linalg import null_space

    scale = loop.balance
    basis = null_space((u * scale)[None, :])
    oblique = np.eye(loop.n) - np.outer(v, u)
    return _balanced(loop, (basis.T / scale) @ oblique, scale[:, None] * basis, v, u)


def _balanced(loop: BacklashLoop, project: Array, back: Array, v: Array, u: Array) -> Split:
    """Return the split over states y = project x, x = back y, divided by powers of 2."""
    from scipy.linalg import matrix_balance

    a = project @ loop.a @ back
    _, (scale, _) = matrix_balance(a, permute=False, separate=True)
    project, back = project / scale[:, None], back * scale
    return Split(project @ loop.a @ back, project @ loop.b, loop.c @ back, project, u, float(loop.c @ v), float(u @ loop.b))
