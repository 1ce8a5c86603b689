"""A loop with backlash as matrices: linear but for the torque, which passes a gap before a spring takes it up.

::

    x' = a x + e (r, r', r'') - b T,      theta_d = c x,      T = k dz(theta_d, h)

with h half of the gap and dz the dead zone. With shaft damping the torque is that of Nordin, Galic & Gutman: k (theta_d -+ h) + d theta_d'
in contact, which ends where this torque would change its sign; in the gap the twist of the shaft relaxes at the rate k/d. Units are
neutral: angles and torques, or lengths and forces.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import ParameterError

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

N_REFERENCE = 3
"""Reference, its velocity and its acceleration."""


def dead_zone(difference: ArrayLike, half_gap: float) -> Array:
    """Return how far a motor-load difference lies beyond the gap, with its sign: eq (4) of Shahin, ElMaraghy & ElBeheiry.

    >>> [float(value) for value in dead_zone([-3.0, 0.5, 1.5], 1.0)]
    [-2.0, 0.0, 0.5]
    """
    d = np.asarray(difference, dtype=float)
    return np.asarray(d - np.clip(d, -half_gap, half_gap))


@dataclass(frozen=True, eq=False)
class BacklashLoop:
    """A closed loop around a gap.

    Attributes
    ----------
    a : ndarray (n, n)
        Dynamics without torque: the gap mode.
    b : ndarray (n,)
        What the transmitted torque does, with its sign taken out: x' = a x - b T.
    c : ndarray (n,)
        Motor-load difference theta_d = c x. c b = 0: a torque moves no position at once.
    stiffness : float, > 0
        Of the transmission, k.
    half_gap : float, > 0
        Half of the total gap, h.
    shaft_damping : float, >= 0
        d; 0 is the dead-zone model.
    e : ndarray (n, 3), optional
        What the reference, its velocity and its acceleration do; zero if left out.
    contact_a : ndarray (n, n), optional
        Dynamics without torque while in contact, of a scheme that switches controllers; `a` if left out.
    contact_e : ndarray (n, 3), optional
        What the reference does while in contact; `e` if left out.
    states : tuple of str, optional
        Names, for sentences.

    Raises
    ------
    ParameterError
        For shapes that do not fit, or numbers out of range.
    """

    a: Array
    b: Array
    c: Array
    stiffness: float
    half_gap: float
    shaft_damping: float = 0.0
    e: Array | None = None
    contact_a: Array | None = None
    contact_e: Array | None = None
    states: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        n = len(np.atleast_1d(self.b))
        for name, shape in {
            "a": (n, n),
            "b": (n,),
            "c": (n,),
            "e": (n, N_REFERENCE),
            "contact_a": (n, n),
            "contact_e": (n, N_REFERENCE),
        }.items():
            given = getattr(self, name)
            if given is not None:
                object.__setattr__(self, name, _checked(name, given, shape))
        if not self.stiffness > 0.0 or not np.isfinite(self.stiffness):
            raise ParameterError("stiffness", self.stiffness, "above 0")
        if not self.half_gap > 0.0 or not np.isfinite(self.half_gap):
            raise ParameterError("half_gap", self.half_gap, "above 0 (without a gap the loop is linear)")
        if not self.shaft_damping >= 0.0 or not np.isfinite(self.shaft_damping):
            raise ParameterError("shaft_damping", self.shaft_damping, "0 or more")
        size = float(np.abs(self.b).max() * np.abs(self.c).max())
        if abs(float(self.c @ self.b)) > 1e-12 * size:
            raise ParameterError("c b", float(self.c @ self.b), "0: a torque moves no position at once")
        if self.states and len(self.states) != n:
            raise ParameterError("states", self.states, f"{n} names")

    @property
    def n(self) -> int:
        """Number of states."""
        return len(self.b)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the states."""
        return self.states or tuple(f"state {i + 1}" for i in range(self.n))

    @property
    def reference_input(self) -> Array:
        """`e`, zeros where none was given (n, 3)."""
        return np.zeros((self.n, N_REFERENCE)) if self.e is None else self.e

    def reference_input_in(self, gap: bool) -> Array:
        """What the reference does in the gap, or in contact (n, 3)."""
        return self.reference_input if gap or self.contact_e is None else self.contact_e

    @property
    def rate(self) -> Array:
        """Row of the velocity of the motor-load difference, theta_d' = c a x (n,)."""
        return np.asarray(self.c @ self.a)

    @property
    def torque_row(self) -> Array:
        """Row of the torque in contact, but for the gap: T = (k c + d c a) x -+ k h (n,)."""
        return self.stiffness * self.c + self.shaft_damping * self.rate

    @property
    def gap_matrix(self) -> Array:
        """Dynamics in the gap (n, n)."""
        return self.a

    @property
    def contact_matrix(self) -> Array:
        """Dynamics in contact (n, n), about its point of rest."""
        return (self.a if self.contact_a is None else self.contact_a) - np.outer(self.b, self.torque_row)

    @cached_property
    def balance(self) -> Array:
        """Powers of 2 (n,) that the states are divided by to make `a` and the contact matrix well scaled; exact in floating point."""
        from scipy.linalg import matrix_balance

        sizes = np.abs(self.gap_matrix) + np.abs(self.contact_matrix)
        _, (scale, _) = matrix_balance(sizes, permute=False, separate=True)
        return np.asarray(scale, dtype=float)

    def transfer(self, frequency: ArrayLike) -> Complex:
        """Return G(j w) = c (j w - a)^-1 b (n,), from the torque, its sign turned, to the motor-load difference, at w (n,) [rad/s].

        Raises
        ------
        ParameterError
            Where the controller changes with the mode: then there is no one linear part.
        """
        self.require_one_controller("a transfer function")
        scale, w = self.balance, np.asarray(frequency, dtype=float)
        a, b, c = self.a * scale / scale[:, None], self.b / scale, self.c * scale
        matrix = 1j * w.reshape(-1, 1, 1) * np.eye(self.n) - a
        found = np.linalg.solve(matrix, np.broadcast_to(b[:, None], (w.size, self.n, 1)).astype(complex))
        return np.asarray((found[..., 0] @ c).reshape(w.shape))

    def require_one_controller(self, what: str) -> None:
        """Raise ParameterError where the controller changes with the mode."""
        if self.contact_a is not None and not np.array_equal(self.contact_a, self.a):
            raise ParameterError("contact_a", "another matrix than a", f"left out for {what}: it needs one linear part for gap and contact")


def _checked(name: str, given: ArrayLike, shape: tuple[int, ...]) -> Array:
    """Return a matrix of its own, which nobody can change."""
    value = np.array(given, dtype=float)
    if value.shape != shape:
        raise ParameterError(name, f"an array of shape {value.shape}", f"of shape {shape}, as b is")
    if not np.isfinite(value).all():
        raise ParameterError(name, "an array with inf or nan", "finite")
    value.setflags(write=False)
    return value
