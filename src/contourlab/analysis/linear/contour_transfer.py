"""Contour error transfer function (contour error with cross-coupling over that without, eq 22), its margins, and internal stability.

Cross-coupling multiplies the contour error by 1/(1 + L), with L = C_cc P_e and P_e = sum n_i^2 P_i/(1 + P_i C_i), a mean of the axes'
responses weighted by n_i^2 of the normal. Over all directions L fills, at each frequency, the convex hull of C_cc P_i/(1 + P_i C_i). The
distance of that polygon from -1 is the smallest over all directions. With three or more axes the loop is a matrix whose numerical range
lies in the same polygon: the distance then bounds the smallest singular value of 1 + L from below.

References
----------
Gecer Ulu, Ulu & Cakmakci, eq (22).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.linear.coupled_loop import CoupledLoop, TrialMap, coupled_loop, normal_basis
from contourlab.analysis.linear.margins import HullMargin, doubling, edge_margins, frequency_grid, hull_modulus, nearest_approach
from contourlab.analysis.linear.tick_map import poles_of
from contourlab.arrays import Array, Complex
from contourlab.errors import ComponentError, ParameterError, refuse
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.loop.machine import Controller, Machine

LEFT_STANDING = 1e-7
"""Distance from 1 within which a pole counts as a constant state."""
TOUCHING = 1e-6
"""Distance of the polygon from -1 that counts as zero: the accuracy of the search over frequency."""


@dataclass(frozen=True)
class ContourMargins:
    """Margins of the coupling over all constant directions of the path; nan for an unstable loop.

    A direction is a unit vector over the axes, up to the signs of its entries: the normal for cross-coupling, the tangent for a modified
    reference.

    Attributes
    ----------
    stable : bool
        Whether every axis, and the coupling in every direction, is stable.
    modulus : float
        Smallest distance of the loop gain from -1 over frequency and direction.
    modulus_frequency : float [rad/s]
        Of an unstable coupling: the frequency of the fastest growth.
    modulus_direction : tuple of float
        Of an unstable coupling: the direction of the fastest growth, among each axis, the diagonal, and where -1 is nearest.
    gain : float
        Smallest factor > 1 on the coupling at which some direction would reach -1; infinite if none.
    gain_direction : tuple of float
    phase : float [rad]
        Smallest change of phase that reaches -1 at a gain of 1, over all directions; infinite if the gain is never 1.
    phase_direction : tuple of float
    crossover : float [rad/s]
        Frequency of the phase margin; nan if there is none.
    doubling : float [s]
        Time in which an error doubles; only of an unstable coupling.
    """

    stable: bool
    modulus: float = math.nan
    modulus_frequency: float = math.nan
    modulus_direction: tuple[float, ...] = ()
    gain: float = math.nan
    gain_direction: tuple[float, ...] = ()
    phase: float = math.nan
    phase_direction: tuple[float, ...] = ()
    crossover: float = math.nan
    doubling: float = math.nan


@dataclass(frozen=True, eq=False)
class ContourTransfer:
    """The coupled machine in the frequency domain; frequencies in rad/s, above 0 and up to the Nyquist frequency.

    Attributes
    ----------
    strength : float
        |C|^2, length of the coupling gains squared: 1 for the unit normal. See `contour_transfer`.
    """

    loop: CoupledLoop
    strength: float = 1.0

    @property
    def along(self) -> bool:
        """Whether the coupling acts on the error along the path (modified reference) instead of across it."""
        return self.loop.coupling.weight != 0.0

    def vertices(self, frequency: ArrayLike) -> Complex:
        """Return the loop gain with the direction along each axis in turn: (n, n_axis)."""
        if self.along:
            weight = self.loop.coupling.weight
            return np.column_stack([-weight * axis.form(frequency)[:, 0, 1] for axis in self.loop.axes])
        pushed = np.column_stack([axis.form(frequency)[:, 0, 0] for axis in self.loop.axes])
        return np.asarray(self.strength * self.loop.coupling(frequency)[:, None] * pushed)

    def loop_gain(self, frequency: ArrayLike, direction: ArrayLike) -> Complex:
        """Return L (n,) for a constant direction (n_axis,): the normal of the path, or the tangent for a modified reference."""
        n = np.asarray(direction, dtype=float)
        if n.shape != (len(self.loop.axes),) or not np.linalg.norm(n) > 0.0:
            raise ParameterError("direction", f"{n.tolist()}", f"a vector of {len(self.loop.axes)} numbers, not all zero")
        return np.asarray(self.vertices(frequency) @ (n**2 / (n @ n)))

    def distance(self, frequency: ArrayLike) -> Array:
        """Return the distance (n,) of -1 from the loop gains of all directions; its inverse bounds the contour error transfer function."""
        return hull_modulus(self.vertices(frequency))

    @cached_property
    def grid(self) -> Array:
        """Frequencies fine enough for every crossing of the loop gains."""
        units = np.eye(len(self.loop.axes))
        poles = [*(axis.loop.poles for axis in self.loop.axes), poles_of(self.loop.coupling.f), *(self._poles(unit) for unit in units)]
        return frequency_grid(self.loop.servo_period, np.concatenate(poles), max(len(axis.a) for axis in self.loop.axes))

    def _poles(self, unit: Array) -> Complex:
        """Return the poles with a constant direction, a unit vector (n_axis,)."""
        if self.along:
            return self.loop.poles(normal_basis(unit) if len(unit) > 1 else np.zeros((1, 0)))
        return self.loop.poles((np.sqrt(self.strength) * unit)[:, None])

    @cached_property
    def _modulus(self) -> HullMargin:
        w = self.grid
        value, at = nearest_approach(self.distance, w, self.distance(w), n_dip=4, tolerance=1e-9)
        return HullMargin.nearest(value, at, self.vertices(at)[0])

    @cached_property
    def stable(self) -> bool:
        """Whether the machine is stable in every constant direction.

        If one direction is stable and no polygon contains -1, no pole can leave the unit circle on the way to any other direction.
        """
        axes = all(axis.loop.stable for axis in self.loop.axes)
        inside = all(abs(_moving(self._poles(unit))) < 1.0 for unit in np.eye(len(self.loop.axes)))
        return axes and inside and self._modulus.value > TOUCHING

    def margins(self) -> ContourMargins:
        """Return the margins over all directions."""
        worst = self._modulus
        direction = _direction(worst.weights)
        if not self.stable:
            return self._fastest(direction)
        phase, gain = edge_margins(self.vertices, self.grid, list(combinations(range(len(self.loop.axes)), 2)))
        of_gain, of_phase = (gain.value, _direction(gain.weights)), (phase.value, _direction(phase.weights))
        return ContourMargins(True, worst.value, worst.frequency, direction, *of_gain, *of_phase, phase.frequency)

    def _fastest(self, nearest: tuple[float, ...]) -> ContourMargins:
        """Return the fastest growth among a few directions: along each axis, along the diagonal, and where -1 is nearest."""
        n = len(self.loop.axes)
        units = [*np.eye(n), np.full(n, n**-0.5), np.array(nearest)]
        unit, pole = max(((unit, _moving(self._poles(unit))) for unit in units), key=lambda pair: abs(pair[1]))
        period = self.loop.servo_period
        direction = tuple(float(x) for x in unit)
        return ContourMargins(False, math.nan, abs(float(np.angle(pole))) / period, direction, doubling=period * doubling(abs(pole)))


def _moving(poles: Complex) -> complex:
    """Return the largest pole, without poles at 1: only the sum of the axes' and coupling's integrals acts."""
    moving = poles[np.abs(poles - 1.0) > LEFT_STANDING]
    return complex(moving[np.argmax(np.abs(moving))]) if moving.size else 0j


def _direction(weights: Array) -> tuple[float, ...]:
    return tuple(float(x) for x in np.sqrt(weights))


def contour_transfer(machine: Machine, controller: Controller, *, strength: float = 1.0) -> ContourTransfer:
    """Return the contour error transfer function of a machine under its controller, from the steps that run.

    Parameters
    ----------
    machine, controller
        Limits, friction and quantisation are left out; all else must be linear.
    strength : float, > 0
        |C|^2, squared length of the coupling gains, a factor on the loop gain: 1 for the unit normal. For Koren and Lo's variable gains,
        C = n + e/(2 rho), use their largest value, (1 + e_max/(2 rho_min))^2 for tracking errors up to e_max and curvature radii from
        rho_min.

    Raises
    ------
    ComponentError
        If the controller has no coupling, or a component is not linear.
    ParameterError
        If the strength is not positive.
    """
    if controller.coupling is None:
        raise ComponentError("the controller has no coupling, so there is no contour error transfer function: add one")
    refuse(not (strength > 0.0 and math.isfinite(strength)), ParameterError, "strength", f"{strength:g}", "> 0 and finite")
    return ContourTransfer(coupled_loop(machine, controller), strength)


def contour_margins(machine: Machine, controller: Controller, *, strength: float = 1.0) -> ContourMargins:
    """Return gain, phase and modulus margin of the coupling over all directions of the path; see `contour_transfer`.

    Each direction is constant; for a turning path see `internal_stability`.

    Parameters
    ----------
    machine : Machine
    controller : Controller
        Limits, friction and quantisation are left out; all else must be linear.
    strength : float, > 0
        Squared length of the coupling gains, a factor on the loop gain: 1 for the unit normal.

    Returns
    -------
    ContourMargins

    Raises
    ------
    ComponentError
        If the controller has no coupling, or a component is not linear.
    ParameterError
        If the strength is not positive.
    """
    return contour_transfer(machine, controller, strength=strength).margins()


@dataclass(frozen=True)
class InternalStability:
    """Internal stability of coupled axes, in three steps, each based on the one before.

    Attributes
    ----------
    axes : dict of str to bool
        Each axis alone under its own controller.
    directions : ContourMargins or None
        The coupling over all constant directions of the path; None without a coupling.
    lap : float
        Largest multiplier of a small error over one lap of a closed path, with the turning normal: below 1 it decays; nan without a
        closed path. Constant states are left out.
    """

    axes: dict[str, bool]
    directions: ContourMargins | None
    lap: float

    @property
    def stable(self) -> bool:
        """Whether every step shows stability."""
        return all(self.axes.values()) and (self.directions is None or self.directions.stable) and not self.lap >= 1.0

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Why the coupling of stable axes is unstable; nothing where it is stable."""
        if not all(self.axes.values()) or self.directions is None:
            return ()
        if not self.directions.stable:
            direction = [f"{axis} {part:.2f}" for axis, part in zip(self.axes, self.directions.modulus_direction, strict=True)]
            hertz = self.directions.modulus_frequency / (2.0 * math.pi)
            return (finding("CL206", frequency=hertz, direction=direction, doubling=self.directions.doubling),)
        return (finding("CL207", growth=self.lap - 1.0, doubling=doubling(self.lap)),) if self.lap >= 1.0 else ()


def internal_stability(machine: Machine, controller: Controller, reference: Reference | None = None) -> InternalStability:
    """Return whether coupled axes are internally stable.

    By the theorem of Yeh and Hsu the machine is internally stable if each axis is stable, and the loop (C_cc, P_e) for every normal. That
    holds for constant normals; for turning normals the product of the tick matrices of a lap decides.

    Parameters
    ----------
    machine : Machine
    controller : Controller
        Limits, friction and quantisation are left out; all else must be linear.
    reference : Reference, optional
        On a closed path with whole laps; the last lap is analysed.

    Returns
    -------
    InternalStability

    Raises
    ------
    ComponentError
        If a component is not linear.

    References
    ----------
    Yeh & Hsu, "Theory and applications of the robust cross-coupled control design", Proc. American Control Conference (1997); Gecer Ulu,
    Ulu & Cakmakci, section 4.
    """
    loop = coupled_loop(machine, controller)
    axes = {name: axis.loop.stable for name, axis in zip(loop.names, loop.axes, strict=True)}
    margins = None if controller.coupling is None else ContourTransfer(loop).margins()
    lap = math.nan
    if reference is not None and reference.laps and all(axes.values()):
        start, stop = reference.laps[-1]
        multipliers = poles_of(TrialMap(loop, reference.path.tangent(reference.block(start, stop).arc_length)).monodromy())
        lap = float(np.abs(multipliers[np.abs(multipliers - 1.0) > LEFT_STANDING]).max(initial=0.0))
    return InternalStability(axes, margins, lap)
