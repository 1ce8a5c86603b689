"""Circle criterion: absolute stability of a loop with a gap, for any torque in the sector between 0 and the stiffness.

It requires Re G(j w) > -1/k at all frequencies. The minimum comes from eigenvalues of a Hamiltonian matrix; a grid would miss a resonance
narrower than its steps. In the gap nothing fixes the load position, so G(s) = g/s + G1(s). The pole at zero is removed exactly, the rest
must be Hurwitz, and motions end at rest somewhere in the gap.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.analysis.backlash.lure import BacklashLoop
from contourlab.arrays import Array
from contourlab.papers.shahin.common_lyapunov import characteristic, has_hurwitz_roots, kernel, rational, transpose

NEAR_END = 1e-3
"""At infinity the locus is 1/k from the line. Minima within this share of 1/k are not resolved (ill-conditioned Hamiltonian)."""
LEAST = 1e-9
"""Margin relative to 1/k below which rounding could decide."""


@dataclass(frozen=True)
class AbsoluteStability:
    """Verdict of the circle criterion.

    Attributes
    ----------
    verdict : "stable" or "undecided"
        The criterion is sufficient only: it never says "unstable".
    margin : float
        Distance of the locus G from the line at -1/k, times k; at most 0.999; nan if the criterion does not apply.
    frequency : float [rad/s]
        Frequency at which the locus is closest.
    largest_stiffness : float
        Stiffness up to which the criterion holds; 1000 times the loop's stiffness means at least that.
    """

    verdict: str
    margin: float
    frequency: float
    largest_stiffness: float
    explanation: str

    def __str__(self) -> str:
        return f"{self.verdict}: {self.explanation}"


def circle_criterion(loop: BacklashLoop) -> AbsoluteStability:
    """Apply the circle criterion Re G(j w) > -1/k; it also covers gaps and stiffnesses that vary in time.

    With little load damping the verdict is "undecided".

    Raises
    ------
    ParameterError
        For a loop that switches its controller.

    References
    ----------
    Khalil, Nonlinear Systems, 3rd ed., theorem 7.1; Aizerman & Gantmacher for a pole at zero.
    """
    loop.require_one_controller("a frequency criterion")
    linear = _linear_part(loop)
    if isinstance(linear, str):
        return AbsoluteStability("undecided", math.nan, math.nan, math.nan, f"the criterion does not apply: {linear}")
    margin, frequency = linear.minimum()
    largest = loop.stiffness / (1.0 - margin)
    where = f"closest at {frequency:.4g} rad/s, {abs(margin):.3g}/k {'right' if margin > 0.0 else 'left'} of the line at -1/k"
    if margin > LEAST and linear.is_clear():
        end = "every motion ends at rest with the gap unloaded" if linear.residue else "every motion ends at rest"
        text = f"by the circle criterion {end}, for any torque in the sector up to a stiffness of {largest:.4g}; {where}"
        return AbsoluteStability("stable", margin, frequency, largest, text)
    text = f"the circle criterion does not hold: {where}; it is only sufficient, so the loop may still be stable"
    return AbsoluteStability("undecided", margin, frequency, largest, text)


@dataclass(frozen=True, eq=False)
class _Linear:
    """k G(s) + 1 = k (g/s + c (s - a)^-1 b) + 1 with a Hurwitz, in balanced states; the pole at zero is imaginary and adds nothing."""

    a: Array
    b: Array
    row: Array
    residue: float

    def minimum(self) -> tuple[float, float]:
        """Return the minimum of 1 + k Re G over all frequencies, and its frequency."""
        rates = np.abs(np.linalg.eigvals(self.a))
        tested = (0.0, *rates, *np.geomspace(1e-3 * rates.min(), 1e3 * rates.max(), 40))
        least, at = min([*((self._value(float(w)), float(w)) for w in tested), (1.0 - NEAR_END, math.inf)])
        for _ in range(50):
            crossings = self._crossings(least)
            edges = np.concatenate([[0.0], crossings, [2.0 * crossings[-1]]]) if crossings.size else np.zeros(1)
            between = np.concatenate([crossings, 0.5 * (edges[1:] + edges[:-1])])
            value, w = min(((self._value(float(w)), float(w)) for w in between), default=(least, at))
            if value >= least - 1e-12 * (1.0 + abs(least)):
                break
            least, at = value, w
        return least, at

    def is_clear(self) -> bool:
        """Return whether 1 + k Re G reaches 0 at no frequency: the Hamiltonian has no eigenvalue on the imaginary axis."""
        values = np.linalg.eigvals(self._hamiltonian(0.0))
        return bool((np.abs(values.real) > 1e-10 * np.abs(values).max() * np.finfo(float).eps ** 0.25).all())

    def _value(self, w: float) -> float:
        response = np.linalg.solve(1j * w * np.eye(len(self.b)) - self.a, self.b.astype(complex))
        return 1.0 + float((self.row @ response).real)

    def _crossings(self, level: float) -> Array:
        """Return the frequencies near which 1 + k Re G may reach a level, ascending."""
        values = np.linalg.eigvals(self._hamiltonian(level))
        near = np.abs(values.real) <= 1e-4 * np.abs(values)
        return np.unique(np.abs(values.imag[near & (np.abs(values) > 0.0)]))

    def _hamiltonian(self, level: float) -> Array:
        weight = 2.0 * (1.0 - level)
        inner = self.a - np.outer(self.b, self.row) / weight
        return np.block([[inner, -np.outer(self.b, self.b) / weight], [np.outer(self.row, self.row) / weight, -inner.T]])


def _linear_part(loop: BacklashLoop) -> _Linear | str:
    """Return the linear part without its pole at zero, or why the criterion does not apply; decided in rational arithmetic.

    With v in the kernel of a, u in that of a', u'v = 1: x = y + v xi, xi = u'x, xi' = -(u'b) T. The rest y must decay.
    """
    if loop.shaft_damping > 0.0:
        return "the torque of a damped shaft depends on its history, not only on the motor-load difference"
    exact = rational(loop.a)
    right, left = kernel(exact), kernel(transpose(exact))
    if not right:
        if not has_hurwitz_roots(characteristic(exact)):
            return "the linear part is not Hurwitz"
        return _balanced(loop, np.eye(loop.n), np.eye(loop.n), 0.0)
    overlap = sum(x * y for x, y in zip(right[0], left[0], strict=True))
    if len(right) > 1 or overlap == 0:
        return "the linear part has a double pole at zero: nothing slows the load in the gap, or the motor moves on while the load rests"
    if not has_hurwitz_roots(characteristic(exact)[:-1]):
        return "the linear part without its pole at zero is not Hurwitz"
    v, u = np.array([float(x) for x in right[0]]), np.array([float(x / overlap) for x in left[0]])
    residue = float(loop.c @ v) * float(u @ loop.b)
    if residue <= 0.0:
        return "the pole at zero has the wrong sign: a constant difference does not pull motor and load together"
    from scipy.linalg import null_space

    scale = loop.balance
    basis = null_space((u * scale)[None, :])
    return _balanced(loop, (basis.T / scale) @ (np.eye(loop.n) - np.outer(v, u)), scale[:, None] * basis, residue)


def _balanced(loop: BacklashLoop, project: Array, back: Array, residue: float) -> _Linear:
    """Return the linear part over states y = project x, x = back y, divided by powers of 2."""
    from scipy.linalg import matrix_balance

    _, (scale, _) = matrix_balance(project @ loop.a @ back, permute=False, separate=True)
    project, back = project / scale[:, None], back * scale
    b, c = project @ loop.b, loop.c @ back
    # Input and output of similar size keep the Hamiltonian well scaled.
    ratio = math.sqrt(float(np.linalg.norm(c)) * loop.stiffness / max(float(np.linalg.norm(b)), 1e-300))
    return _Linear(project @ loop.a @ back, b * ratio, loop.stiffness * (c / ratio), residue)
