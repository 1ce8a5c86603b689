"""Absolute stability of a loop with a gap: circle criterion and Popov's, whatever the torque in the sector between 0 and the stiffness.

Both ask that Re (1 + j q w) G(j w) > -1/k at all frequencies, the circle criterion with q = 0. The least value is found by eigenvalues of
a Hamiltonian matrix, not on a grid, which would miss a resonance narrower than its steps. A gap leaves the load without a position of its
own, G(s) = g/s + G1(s): the pole at zero is taken out exactly, the rest has to be Hurwitz, and motions end at rest somewhere in the gap.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.backlash.lure import BacklashLoop
from contourlab.papers.shahin.pole_at_zero import without_pole_at_zero

Array = NDArray[np.float64]

NEAR_END = 1e-3
"""At infinity the locus is 1/k from the line. A least value nearer to that than this part is not looked for: its Hamiltonian is bad."""
LEAST = 1e-9
"""Margin over 1/k below which rounding could decide."""


@dataclass(frozen=True)
class AbsoluteStability:
    """What a frequency criterion says.

    Attributes
    ----------
    verdict : "stable" or "undecided"
        A criterion is sufficient only: it never says "unstable".
    multiplier : float [s]
        q of Popov's criterion; 0 for the circle criterion.
    margin : float
        Distance of the locus (1 + j q w) G from the line at -1/k, times k; 0.999 if the locus never goes left of 0; nan if the criterion
        does not apply.
    frequency : float [rad/s]
        Where the locus comes closest.
    largest_stiffness : float
        Up to which the same multiplier would do; 1000 times the loop's own stands for at least that.
    explanation : str
    """

    verdict: str
    multiplier: float
    margin: float
    frequency: float
    largest_stiffness: float
    explanation: str

    def __str__(self) -> str:
        return f"{self.verdict}: {self.explanation}"


def circle_criterion(loop: BacklashLoop) -> AbsoluteStability:
    """Return what the circle criterion says of a loop: Re G(j w) > -1/k.

    It holds for gaps and stiffnesses that vary in time too. Without damping of the load, or with little, it says nothing.

    Raises
    ------
    ParameterError
        For a loop that switches its controller.

    References
    ----------
    Khalil, Nonlinear Systems, 3rd ed., theorem 7.1; Aizerman & Gantmacher for a pole at zero.
    """
    linear = _linear_part(loop)
    return _unfit(linear) if isinstance(linear, str) else _judged(loop, linear, 0.0)


def popov_criterion(loop: BacklashLoop) -> AbsoluteStability:
    """Return what Popov's criterion says of a loop, with the multiplier of the largest margin: Re (1 + j q w) G(j w) > -1/k, q >= 0.

    Raises
    ------
    ParameterError
        For a loop that switches its controller.

    References
    ----------
    Khalil, Nonlinear Systems, 3rd ed., theorem 7.3; Aizerman & Gantmacher for a pole at zero.
    """
    linear = _linear_part(loop)
    if isinstance(linear, str):
        return _unfit(linear)
    rates = np.abs(np.linalg.eigvals(loop.contact_matrix))
    rates = rates[rates > 0.0]
    tried = [0.0, *np.logspace(-math.log10(rates.max()) - 2.0, -math.log10(rates.min()) + 2.0, 60)]
    # Over 1 + q w0, so that a large multiplier is no margin of its own; the least value is concave in q then too.
    typical = float(np.exp(np.mean(np.log(rates))))
    values = [linear.least(q)[0] / (1.0 + q * typical) for q in tried]
    best = int(np.argmax(values))
    low, high = tried[max(best - 1, 0)], tried[min(best + 1, len(tried) - 1)]
    for _ in range(30):
        third = (high - low) / 3.0
        left, right = (linear.least(q)[0] / (1.0 + q * typical) for q in (low + third, high - third))
        low, high = (low + third, high) if left < right else (low, high - third)
    found = max((tried[best], 0.5 * (low + high)), key=lambda q: linear.least(q)[0] / (1.0 + q * typical))
    return _judged(loop, linear, float(found))


@dataclass(frozen=True, eq=False)
class _Linear:
    """G(s) = g/s + c (s - a)^-1 b with a Hurwitz, in balanced states; k for scale."""

    a: Array
    b: Array
    c: Array
    residue: float
    stiffness: float

    def least(self, q: float) -> tuple[float, float]:
        """Return the least of 1/k + Re (1 + j q w) G over all frequencies, times k, and where."""
        row, through = self._popov(q)
        rates = np.abs(np.linalg.eigvals(self.a))
        looked = (0.0, *rates, *np.geomspace(1e-3 * rates.min(), 1e3 * rates.max(), 40))
        found = [(self._value(row, through, float(w)), float(w)) for w in looked]
        least, at = min([*found, (1.0 - NEAR_END, math.inf)])
        for _ in range(50):
            crossings = self._crossings(row, through, least)
            edges = np.concatenate([[0.0], crossings, [2.0 * crossings[-1]]]) if crossings.size else np.zeros(1)
            between = np.concatenate([crossings, 0.5 * (edges[1:] + edges[:-1])])
            value, w = min(((self._value(row, through, float(w)), float(w)) for w in between), default=(least, at))
            if value >= least - 1e-12 * (1.0 + abs(least)):
                break
            least, at = value, w
        return least, at

    def clear(self, q: float, level: float) -> bool:
        """Whether no frequency reaches a level: the Hamiltonian has no eigenvalue on the imaginary axis."""
        row, through = self._popov(q)
        values = np.linalg.eigvals(self._hamiltonian(row, through, level))
        return bool((np.abs(values.real) > 1e-10 * np.abs(values).max() * np.finfo(float).eps ** 0.25).all())

    def _popov(self, q: float) -> tuple[Array, float]:
        """Return row and feedthrough of k (1 + q s) G + 1, its pole at zero left out, which is imaginary."""
        k = self.stiffness
        row = k * (self.c + q * (self.c @ self.a))
        # (1 + q s) g/s = g/s + q g, and s c (s - a)^-1 b = c b + c a (s - a)^-1 b; c b + g = 0.
        return row, 1.0 + k * q * (self.residue + float(self.c @ self.b))

    def _value(self, row: Array, through: float, w: float) -> float:
        response = np.linalg.solve(1j * w * np.eye(len(self.b)) - self.a, self.b.astype(complex))
        return through + float((row @ response).real)

    def _crossings(self, row: Array, through: float, level: float) -> Array:
        """Return the frequencies near which a level may be reached, rising."""
        values = np.linalg.eigvals(self._hamiltonian(row, through, level))
        near = np.abs(values.real) <= 1e-4 * np.abs(values)
        return np.unique(np.abs(values.imag[near & (np.abs(values) > 0.0)]))

    def _hamiltonian(self, row: Array, through: float, level: float) -> Array:
        weight = 2.0 * (through - level)
        inner = self.a - np.outer(self.b, row) / weight
        return np.block([[inner, -np.outer(self.b, self.b) / weight], [np.outer(row, row) / weight, -inner.T]])


def _linear_part(loop: BacklashLoop) -> _Linear | str:
    """Return the linear part without its pole at zero, or why there is none."""
    loop.require_one_controller("a frequency criterion")
    split = without_pole_at_zero(loop)
    if isinstance(split, str):
        return split
    # Input and output of like size keep the Hamiltonian well scaled.
    ratio = math.sqrt(float(np.linalg.norm(split.c)) * loop.stiffness / max(float(np.linalg.norm(split.b)), 1e-300))
    return _Linear(split.a, split.b * ratio, split.c / ratio, split.residue, loop.stiffness)


def _judged(loop: BacklashLoop, linear: _Linear, q: float) -> AbsoluteStability:
    """Return the verdict for one multiplier."""
    least, at = linear.least(q)
    name = "Popov's criterion" if q else "the circle criterion"
    stable = least > LEAST and linear.clear(q, 0.0)
    largest = loop.stiffness / (1.0 - least)
    where = f"closest at {at:.4g} rad/s, {abs(least):.3g}/k {'right' if least > 0.0 else 'left'} of the line at -1/k"
    if stable:
        end = "every motion ends at rest with the gap unloaded" if linear.residue else "every motion ends at rest"
        text = f"by {name} (q = {q:.4g} s) {end}, for any torque in the sector up to a stiffness of {largest:.4g}; {where}"
    else:
        text = f"{name} (q = {q:.4g} s) does not hold: {where}; it is sufficient only, so this says nothing against the loop"
    return AbsoluteStability("stable" if stable else "undecided", q, least, at, largest, text)


def _unfit(why: str) -> AbsoluteStability:
    return AbsoluteStability("undecided", math.nan, math.nan, math.nan, math.nan, f"the criterion does not apply: {why}")
