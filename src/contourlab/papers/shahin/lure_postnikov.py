"""Lur'e-Postnikov functions: energy plus the integral of the gap's torque, for loops that have no quadratic Lyapunov function.

A load that is free in its gap leaves x'Px no room to fall. But V = x'Px/2 + k dz(theta_d)^2/2 falls wherever P b = a'c' (what the torque
takes from the quadratic part it puts into the spring) and a'P + P a <= 0. With shaft damping the spring's energy is that of its twist,
which the damper only lowers. What V says is an explicit bound on everything it holds; LaSalle's principle says where motions end.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.analysis.backlash.lure import BacklashLoop, dead_zone
from contourlab.errors import ParameterError
from contourlab.papers.shahin.circle_criterion import popov_criterion
from contourlab.papers.shahin.lure_inequality import quadratic_part
from contourlab.papers.shahin.pole_at_zero import without_pole_at_zero

Array = NDArray[np.float64]

MULTIPLES = (1.0, 1.25, 2.0, 5.0, 0.5)
"""Of Popov's multiplier, tried in turn: the largest margin is not always the easiest inequality."""
ROUNDING = 1e-11
"""Relative residual up to which an equation of floats is called held."""


@dataclass(frozen=True, eq=False)
class EnergyFunction:
    """V = x'Px/2 + the spring's energy, for a constant reference about which x is counted.

    Attributes
    ----------
    loop : BacklashLoop
    p : ndarray (n, n) or None
        None if no such function was found: `verdict` is then "undecided".
    dissipation : ndarray (n, n) or None
        -(a'P + P a): V' in the gap is -x' dissipation x / 2, less what the shaft's damper takes.
    settles : bool
        Whether every motion ends at rest with the gap unloaded (LaSalle), for the given reference.
    explanation : str
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
        """Return V (m,) at states (m, n), with the shaft's twist (m,) where it is damped (the dead zone's if left out)."""
        p = self._held()
        states = np.atleast_2d(np.asarray(x, dtype=float))
        wound = dead_zone(states @ self.loop.c, self.loop.half_gap) if twist is None else np.asarray(twist, dtype=float)
        return np.asarray(0.5 * np.einsum("mi,ij,mj->m", states, p, states) + 0.5 * self.loop.stiffness * wound**2)

    def compression_bound(self, start: ArrayLike) -> float:
        """Return how far beyond the gap the motor-load difference can ever get from a start: sqrt(2 V(start)/k)."""
        return math.sqrt(2.0 * float(self.value(start)[0]) / self.loop.stiffness)

    def difference_bound(self, start: ArrayLike) -> float:
        """Return the largest motor-load difference that can ever be reached from a start (dead-zone model)."""
        return self.loop.half_gap + self.compression_bound(start)

    def bound(self, row: ArrayLike, start: ArrayLike) -> float:
        """Return the largest |row x| that can ever be reached from a start; inf for what the energy does not hold."""
        p, r = self._held(), np.asarray(row, dtype=float)
        energy = 2.0 * float(self.value(start)[0])
        values, vectors = np.linalg.eigh(p)
        inside = values > 1e-12 * values[-1]
        parts = vectors.T @ r
        if np.abs(parts[~inside]).max(initial=0.0) <= 1e-9 * float(np.linalg.norm(r)):
            return math.sqrt(energy * float((parts[inside] ** 2 / values[inside]).sum()))
        return self._over_difference(r, start, p, energy)

    def _over_difference(self, r: Array, start: ArrayLike, p: Array, energy: float) -> float:
        """Bound what only the difference holds: row = share c + a part that the quadratic form holds."""
        values, vectors = np.linalg.eigh(p)
        loose = vectors[:, values <= 1e-12 * values[-1]]
        held, wanted = loose.T @ self.loop.c, loose.T @ r
        share = float(held @ wanted) / max(float(held @ held), 1e-300)
        if np.abs(wanted - share * held).max() > 1e-9 * float(np.linalg.norm(r)):
            return math.inf
        return abs(share) * self.difference_bound(start) + self.bound(r - share * self.loop.c, start)

    def _held(self) -> Array:
        if self.p is None:
            raise ParameterError("energy function", "none", "one that was found, for a bound")
        return self.p


def energy_function(loop: BacklashLoop, p: ArrayLike | None = None) -> EnergyFunction:
    """Return a Lur'e-Postnikov function of a loop.

    Parameters
    ----------
    loop : BacklashLoop
        With one controller in gap and contact.
    p : array_like (n, n), optional
        A quadratic part to be checked. Left out, the mechanical energy of two inertias under a controller on the motor side is tried
        (controller's spring and both inertias), then a linear matrix inequality with Popov's multiplier.

    Returns
    -------
    EnergyFunction
        "stable" if P >= 0, P b = a'c' and a'P + P a <= 0 hold to the rounding of the matrices, or if the inequality holds clear of
        rounding; "undecided" if not.

    Raises
    ------
    ParameterError
        For a loop that switches its controller, or a P of another shape.

    References
    ----------
    Khalil, Nonlinear Systems, 3rd ed., section 7.1.2 and theorem 4.4 (LaSalle).
    """
    loop.require_one_controller("a Lur'e-Postnikov function")
    if p is None:
        tried = _mechanical_energy(loop)
        return _checked(loop, tried) if tried is not None and not _failure(loop, tried) else _by_inequality(loop)
    given = np.asarray(p, dtype=float)
    if given.shape != (loop.n, loop.n):
        raise ParameterError("p", f"an array of shape {given.shape}", f"of shape {(loop.n, loop.n)}")
    return _checked(loop, given)


def _checked(loop: BacklashLoop, p: Array) -> EnergyFunction:
    """Return the function of a P if it fulfils what it has to."""
    failure = _failure(loop, p)
    if failure:
        return EnergyFunction(loop, None, None, False, failure)
    return _concluded(loop, p, _cleared(loop, p, -(loop.a.T @ p + p @ loop.a)))


def _by_inequality(loop: BacklashLoop) -> EnergyFunction:
    """Return the function that Popov's criterion promises, by a linear matrix inequality."""
    popov, split = popov_criterion(loop), without_pole_at_zero(loop)
    if isinstance(split, str):
        return EnergyFunction(loop, None, None, False, f"no energy is known for this loop, and none can be sought: {split}")
    if popov.verdict == "stable":
        for q in (share * popov.multiplier for share in MULTIPLES):
            p = quadratic_part(split, loop.stiffness, q) if q > 0.0 else None
            if p is not None:
                text = (
                    f"V = x'Px/2 + k dz(theta_d)^2/2, found by a linear matrix inequality (q = {q:.4g} s), falls along every motion: "
                    "all end at rest with the gap unloaded, there is no limit cycle"
                )
                return EnergyFunction(loop, p, -(loop.a.T @ p + p @ loop.a), True, text)
        return EnergyFunction(loop, None, None, False, f"no solver found the numbers of a function for a bound, though {popov.explanation}")
    return EnergyFunction(loop, None, None, False, f"no energy is known for this loop, and none was found: {popov.explanation}")


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
    """Return what a P does not fulfil, in words; empty if it does all."""
    scale = loop.balance
    a, c, b = loop.a * scale / scale[:, None], loop.c * scale, loop.b / scale
    q = p * scale * scale[:, None]
    if np.abs(q - q.T).max() > ROUNDING * np.abs(q).max() or np.linalg.eigvalsh(q)[0] < -ROUNDING * np.abs(q).max():
        return "P is not positive semidefinite"
    if np.abs(q @ b - a.T @ c).max() > ROUNDING * (np.abs(q) @ np.abs(b) + np.abs(a.T) @ np.abs(c)).max():
        return "P b = a'c' does not hold: the torque puts energy in"
    flow = a.T @ q + q @ a
    if np.linalg.eigvalsh(flow)[-1] > ROUNDING * (np.abs(a.T) @ np.abs(q)).max():
        return "a'P + P a has an eigenvalue above 0: the linear part puts energy in"
    if np.linalg.matrix_rank(q + np.outer(c, c) * np.abs(q).max(), tol=1e-13 * np.abs(q).max()) < loop.n:
        return "some states are held by neither P nor the spring: V does not bound them"
    return ""


def _cleared(loop: BacklashLoop, p: Array, dissipation: Array) -> Array:
    """Return the dissipation with what is rounding set to zero."""
    sizes = np.abs(loop.a).T @ np.abs(p) + np.abs(p) @ np.abs(loop.a)
    return np.where(np.abs(dissipation) > ROUNDING * sizes, dissipation, 0.0)


def _concluded(loop: BacklashLoop, p: Array, dissipation: Array) -> EnergyFunction:
    """Return the function with what LaSalle's principle says."""
    text = (
        "V = x'Px/2 + k dz(theta_d)^2/2 never rises, so from any start |dz(theta_d)| <= sqrt(2 V(0)/k) and every state that V holds stays "
        "bounded, although no quadratic function can show it"
    )
    settles = dissipation.any() and _settles(loop, dissipation)
    if settles:
        text += "; V stands still only at rest with the gap unloaded, so every motion ends there (LaSalle): there is no limit cycle"
    return EnergyFunction(loop, p, dissipation, bool(settles), text)


def _settles(loop: BacklashLoop, dissipation: Array) -> bool:
    """Whether V' = 0 leaves nothing but rest without torque: over motions that stay in contact, and those that stay in the gap."""
    scale = loop.balance
    contact, gap = loop.contact_matrix * scale / scale[:, None], loop.a * scale / scale[:, None]
    taken, c = dissipation * scale * scale[:, None], loop.c * scale
    resting = _kernel(gap)
    # In contact the only rest is the edge of the gap: the one vector at rest in the gap, moved there. All else is seen by V'.
    if resting.shape[1] != 1 or abs(float(c @ resting[:, 0])) < 1e-9 * float(np.linalg.norm(c)):
        return False
    if np.linalg.cond(contact) > 1e14 or _unseen(taken, contact).shape[1] > 0:
        return False
    # In the gap: bounded motions that V' does not see, if none of them swings, have a constant difference; they have to be at rest.
    quiet = _unseen(taken, gap)
    inside = quiet.T @ gap @ quiet
    if np.abs(np.linalg.eigvals(inside)).max(initial=0.0) > 1e-6 * np.abs(gap).max():
        return False
    still = _unseen(np.vstack([taken / max(np.abs(taken).max(), 1e-300), (c @ gap)[None, :] / np.abs(c @ gap).max()]), gap)
    return bool(np.abs(gap @ still).max(initial=0.0) <= 1e-9 * np.abs(gap).max())


def _kernel(matrix: Array) -> Array:
    """Return an orthonormal basis (n, m) of the vectors that a matrix takes to 0, its rows made alike in size."""
    from scipy.linalg import null_space

    sizes = np.abs(matrix).max(axis=1, keepdims=True)
    return np.asarray(null_space(matrix / np.where(sizes > 0.0, sizes, 1.0), rcond=1e-12), dtype=np.float64)


def _unseen(rows: Array, a: Array) -> Array:
    """Return an orthonormal basis (n, m) of the unobservable subspace of (rows, a)."""
    unit, basis = a / np.abs(a).max(), _kernel(rows)
    # Invariant part of the kernel: what a leaves inside it, again and again.
    while basis.shape[1]:
        outside = unit @ basis - basis @ (basis.T @ unit @ basis)
        kept = _kernel(outside) if np.abs(outside).max() > 1e-12 else np.eye(basis.shape[1])
        if kept.shape[1] == basis.shape[1]:
            return basis
        basis = np.linalg.qr(basis @ kept)[0] if kept.shape[1] else basis[:, :0]
    return basis
