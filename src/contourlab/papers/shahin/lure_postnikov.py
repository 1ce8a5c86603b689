"""Lur'e-Postnikov function: energy plus the integral of the gap's torque, for loops without a quadratic Lyapunov function.

While the load is free in its gap, x'Px cannot fall. But V = x'Px/2 + k dz(theta_d)^2/2 never rises if P b = a'c' (the torque moves energy
from the quadratic part to the spring) and a'P + P a <= 0. With shaft damping, the spring energy is that of the twist, which the damper only
lowers. V bounds every state that it contains; LaSalle's principle shows where motions end.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.backlash.lure import BacklashLoop, dead_zone
from contourlab.arrays import Array
from contourlab.errors import ParameterError

ROUNDING = 1e-11
"""Relative residual up to which an equation of floats counts as satisfied."""


@dataclass(frozen=True, eq=False)
class EnergyFunction:
    """V = x'Px/2 + the spring's energy, about the point of rest of a constant reference.

    Attributes
    ----------
    p : ndarray (n, n) or None
        None if the energy is not such a function; the verdict is then "undecided".
    dissipation : ndarray (n, n) or None
        -(a'P + P a): in the gap V' is -x' dissipation x / 2, minus the loss in the shaft's damper.
    settles : bool
        Whether every motion ends at rest with the gap unloaded (LaSalle).
    """

    loop: BacklashLoop
    p: Array | None
    dissipation: Array | None
    settles: bool
    explanation: str

    @property
    def verdict(self) -> str:
        """ "stable" or "undecided"."""
        return "stable" if self.p is not None else "undecided"

    def __str__(self) -> str:
        return f"{self.verdict}: {self.explanation}"

    def value(self, x: ArrayLike, twist: ArrayLike | None = None) -> Array:
        """Return V (m,) at states (m, n), with the twist (m,) of a damped shaft (default: the dead zone's).

        Raises
        ------
        ParameterError
            If there is no function.
        """
        if self.p is None:
            raise ParameterError("energy function", "none", "a loop that has one")
        states = np.atleast_2d(np.asarray(x, dtype=float))
        wound = dead_zone(states @ self.loop.c, self.loop.half_gap) if twist is None else np.asarray(twist, dtype=float)
        return np.asarray(0.5 * np.einsum("mi,ij,mj->m", states, self.p, states) + 0.5 * self.loop.stiffness * wound**2)

    def difference_bound(self, start: ArrayLike) -> float:
        """Return the largest motor-load difference reachable from a start: half the gap plus sqrt(2 V(start)/k) (dead-zone model)."""
        return self.loop.half_gap + math.sqrt(2.0 * float(self.value(start)[0]) / self.loop.stiffness)


def energy_function(loop: BacklashLoop) -> EnergyFunction:
    """Check whether the mechanical energy of two inertias with a controller on the motor is a Lur'e-Postnikov function.

    Returns
    -------
    EnergyFunction
        "stable" if P >= 0, P b = a'c' and a'P + P a <= 0 hold up to rounding; else "undecided".

    Raises
    ------
    ParameterError
        For a loop that switches its controller.

    References
    ----------
    Khalil, Nonlinear Systems, 3rd ed., section 7.1.2 and theorem 4.4 (LaSalle).
    """
    loop.require_one_controller("a Lur'e-Postnikov function")
    p = _mechanical_energy(loop)
    if p is None:
        return EnergyFunction(loop, None, None, False, "the controller does not act on the motor alone, so its energy is unknown")
    failure = _failure(loop, p)
    if failure:
        return EnergyFunction(loop, None, None, False, failure)
    dissipation = _cleared(loop, p, -(loop.a.T @ p + p @ loop.a))
    text = (
        "V = x'Px/2 + k dz(theta_d)^2/2 never rises, so from any start |dz(theta_d)| <= sqrt(2 V(0)/k) and every state in V stays bounded, "
        "which no quadratic function can show"
    )
    settles = bool(dissipation.any() and _settles(loop, dissipation))
    if settles:
        text += "; V is constant only at rest with the gap unloaded, so every motion ends there (LaSalle) and no limit cycle exists"
    return EnergyFunction(loop, p, dissipation, settles, text)


def _mechanical_energy(loop: BacklashLoop) -> Array | None:
    """Return diag(K_p, J_m, 0, J_l) of two inertias whose controller sees the motor only; None for another structure."""
    if loop.n != 4 or not np.array_equal(loop.c, [1.0, 0.0, -1.0, 0.0]) or loop.b[0] != 0.0 or loop.b[2] != 0.0:
        return None
    a, b = loop.a, loop.b
    kinematic = np.array_equal(a[0], [0.0, 1.0, 0.0, 0.0]) and np.array_equal(a[2], [0.0, 0.0, 0.0, 1.0])
    if not kinematic or b[1] <= 0.0 or b[3] >= 0.0 or a[1, 2:].any() or a[3, :3].any():
        return None
    return np.diag([-a[1, 0] / b[1], 1.0 / b[1], 0.0, -1.0 / b[3]])


def _failure(loop: BacklashLoop, p: Array) -> str:
    """Return which condition P violates; an empty text if none."""
    scale = loop.balance
    a, c, b = loop.a * scale / scale[:, None], loop.c * scale, loop.b / scale
    q = p * scale * scale[:, None]
    if np.abs(q - q.T).max() > ROUNDING * np.abs(q).max() or np.linalg.eigvalsh(q)[0] < -ROUNDING * np.abs(q).max():
        return "P is not positive semidefinite"
    if np.abs(q @ b - a.T @ c).max() > ROUNDING * (np.abs(q) @ np.abs(b) + np.abs(a.T) @ np.abs(c)).max():
        return "P b = a'c' does not hold: the torque adds energy"
    flow = a.T @ q + q @ a
    if np.linalg.eigvalsh(flow)[-1] > ROUNDING * (np.abs(a.T) @ np.abs(q)).max():
        return "a'P + P a has an eigenvalue above 0: the linear part adds energy"
    if np.linalg.matrix_rank(q + np.outer(c, c) * np.abs(q).max(), tol=1e-13 * np.abs(q).max()) < loop.n:
        return "V does not bound all states: neither P nor the spring contains them"
    return ""


def _cleared(loop: BacklashLoop, p: Array, dissipation: Array) -> Array:
    """Return the dissipation with rounding set to zero."""
    sizes = np.abs(loop.a).T @ np.abs(p) + np.abs(p) @ np.abs(loop.a)
    return np.where(np.abs(dissipation) > ROUNDING * sizes, dissipation, 0.0)


def _settles(loop: BacklashLoop, dissipation: Array) -> bool:
    """Return whether V' = 0 allows only rest without torque, both for motions in contact and for motions in the gap."""
    scale = loop.balance
    contact, gap = loop.contact_matrix * scale / scale[:, None], loop.a * scale / scale[:, None]
    taken, c = dissipation * scale * scale[:, None], loop.c * scale
    resting = _kernel(gap)
    # In contact the only rest is at the edge of the gap: the one rest vector of the gap, moved there. V' sees all else.
    if resting.shape[1] != 1 or abs(float(c @ resting[:, 0])) < 1e-9 * float(np.linalg.norm(c)):
        return False
    if np.linalg.cond(contact) > 1e14 or _unseen(taken, contact).shape[1] > 0:
        return False
    # In the gap: bounded motions that do not change V and do not oscillate have a constant difference; they must be at rest.
    quiet = _unseen(taken, gap)
    inside = quiet.T @ gap @ quiet
    if np.abs(np.linalg.eigvals(inside)).max(initial=0.0) > 1e-6 * np.abs(gap).max():
        return False
    still = _unseen(np.vstack([taken / max(np.abs(taken).max(), 1e-300), (c @ gap)[None, :] / np.abs(c @ gap).max()]), gap)
    return bool(np.abs(gap @ still).max(initial=0.0) <= 1e-9 * np.abs(gap).max())


def _kernel(matrix: Array) -> Array:
    """Return an orthonormal basis (n, m) of the kernel of a matrix, its rows scaled to similar size."""
    from scipy.linalg import null_space

    sizes = np.abs(matrix).max(axis=1, keepdims=True)
    return np.asarray(null_space(matrix / np.where(sizes > 0.0, sizes, 1.0), rcond=1e-12), dtype=np.float64)


def _unseen(rows: Array, a: Array) -> Array:
    """Return an orthonormal basis (n, m) of the unobservable subspace of (rows, a)."""
    unit, basis = a / np.abs(a).max(), _kernel(rows)
    # Invariant part of the kernel under a, by iteration.
    while basis.shape[1]:
        outside = unit @ basis - basis @ (basis.T @ unit @ basis)
        kept = _kernel(outside) if np.abs(outside).max() > 1e-12 else np.eye(basis.shape[1])
        if kept.shape[1] == basis.shape[1]:
            return basis
        basis = np.linalg.qr(basis @ kept)[0] if kept.shape[1] else basis[:, :0]
    return basis
