"""Two inertias with a gap, and linear controllers around them, as matrices.

States: motor position, motor velocity, load position, load velocity, then the controller's integrals::

    J_m w_m' = u - c_m w_m - T,      J_l w_l' = T - c_l w_l

after eqs (1)-(4) of Shahin, ElMaraghy & ElBeheiry. Units are neutral: (rad, N m, kg m^2) or (m, N, kg).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from contourlab.analysis.backlash.lure import N_REFERENCE, BacklashLoop
from contourlab.arrays import Array
from contourlab.errors import ParameterError

MECHANICAL = ("motor position", "motor velocity", "load position", "load velocity")


@dataclass(frozen=True)
class TwoInertias:
    """A motor and a load, joined by a spring with a gap.

    Attributes
    ----------
    motor_inertia, load_inertia : float, > 0
        J_m, J_l [kg m^2] (or masses [kg]).
    stiffness : float, > 0
        k_s [N m/rad] (or [N/m]).
    half_gap : float, > 0
        Half of the total gap, beta of eq (4) [rad] (or [m]).
    motor_damping, load_damping, shaft_damping : float, >= 0
        Viscous friction c_m and c_l, and damping of the shaft [N m s/rad] (or [N s/m]).
    """

    motor_inertia: float
    load_inertia: float
    stiffness: float
    half_gap: float
    motor_damping: float = 0.0
    load_damping: float = 0.0
    shaft_damping: float = 0.0

    @property
    def a(self) -> Array:
        """Dynamics (4, 4) without command and torque."""
        return np.array(
            [
                [0.0, 1.0, 0.0, 0.0],
                [0.0, -self.motor_damping / self.motor_inertia, 0.0, 0.0],
                [0.0, 0.0, 0.0, 1.0],
                [0.0, 0.0, 0.0, -self.load_damping / self.load_inertia],
            ]
        )

    @property
    def command(self) -> Array:
        """Input vector of the command (4,)."""
        return np.array([0.0, 1.0 / self.motor_inertia, 0.0, 0.0])

    @property
    def torque(self) -> Array:
        """Input vector (4,) of the transmitted torque, with inverted sign."""
        return np.array([0.0, 1.0 / self.motor_inertia, 0.0, -1.0 / self.load_inertia])

    @property
    def difference(self) -> Array:
        """Output row (4,) of the motor-load difference."""
        return np.array([1.0, 0.0, -1.0, 0.0])

    @property
    def contact_a(self) -> Array:
        """Dynamics (4, 4) in contact without command, about the point of rest."""
        rate = np.array([0.0, 1.0, 0.0, -1.0])
        return self.a - np.outer(self.torque, self.stiffness * self.difference + self.shaft_damping * rate)


@dataclass(frozen=True)
class Feedback:
    """A linear controller: u = -gain (x, z) + reference (r, r', r''), z' = integral (x, z) + integral_reference (r, r', r'').

    Attributes
    ----------
    gain : tuple (4 + n_z,) of float
        Gains on motor position, motor velocity, load position, load velocity, and the integrals.
    reference : tuple (3,) of float
        Gains on the reference, its velocity and its acceleration.
    integral : tuple (n_z,) of tuples (4 + n_z,) of float
        Rows of the integrands.
    integral_reference : tuple (n_z,) of tuples (3,) of float
    """

    gain: tuple[float, ...]
    reference: tuple[float, ...] = (0.0, 0.0, 0.0)
    integral: tuple[tuple[float, ...], ...] = ()
    integral_reference: tuple[tuple[float, ...], ...] = ()

    @property
    def n_integral(self) -> int:
        """Number of integrals."""
        return len(self.integral)


def motor_pid(proportional: float, derivative: float, integral: float = 0.0, acceleration: float = 0.0) -> Feedback:
    """Return u = acceleration r'' - derivative (w_m - r') - proportional (theta_m - r) - integral times the integral of (theta_m - r).

    Eqs (12), (13), (15) and (16) of the paper about a target r that includes the shift by beta: `derivative` is K_1' or K_4',
    `proportional` K_2' or K_5', `integral` K_3 or K_6, `acceleration` J_m.
    """
    gain, reference = (proportional, derivative, 0.0, 0.0), (proportional, derivative, acceleration)
    if integral == 0.0:
        return Feedback(gain, reference)
    return Feedback((*gain, integral), reference, ((1.0, 0.0, 0.0, 0.0, 0.0),), ((-1.0, 0.0, 0.0),))


def p_pi_cascade(
    position_gain: float,
    velocity_gain: float,
    integral_gain: float = 0.0,
    position_from: Literal["motor", "load"] = "load",
    velocity_feedforward: float = 0.0,
) -> Feedback:
    """Return a position loop around a velocity loop on the motor: v = K_v (r - position) + ff r', u = K_p (v - w_m) + K_i z, z' = v - w_m.

    Parameters
    ----------
    position_gain : float [1/s]
        K_v.
    velocity_gain : float [N m s/rad]
        K_p of the velocity loop.
    integral_gain : float [N m/rad]
        K_i of the velocity loop; 0 leaves out the integral state.
    position_from : "motor" or "load"
        Side whose position the loop measures.
    velocity_feedforward : float
        Share of the reference velocity added to the commanded velocity.
    """
    at = (position_gain, 0.0) if position_from == "motor" else (0.0, position_gain)
    wanted, follow = (at[0], 1.0, at[1], 0.0), (position_gain, velocity_feedforward, 0.0)
    gain, reference = tuple(velocity_gain * x for x in wanted), tuple(velocity_gain * x for x in follow)
    if integral_gain == 0.0:
        return Feedback(gain, reference)
    row = (*(-x for x in wanted), 0.0)
    return Feedback((*gain, -integral_gain), reference, (row,), (follow,))


def two_inertia_loop(drive: TwoInertias, feedback: Feedback, contact_feedback: Feedback | None = None) -> BacklashLoop:
    """Join two inertias and a linear controller into a loop around a gap.

    Parameters
    ----------
    feedback : Feedback
        Controller in the gap, and by default in contact.
    contact_feedback : Feedback, optional
        Controller in contact, for a scheme that switches; with the same number of integrals.

    Raises
    ------
    ParameterError
        If the controllers integrate different numbers of states.
    """
    a, e = _closed(drive, feedback)
    n = len(a)
    b, c = np.zeros(n), np.zeros(n)
    b[:4], c[:4] = drive.torque, drive.difference
    names = (*MECHANICAL, *(f"integral {i + 1}" for i in range(feedback.n_integral)))
    loop = BacklashLoop(a, b, c, drive.stiffness, drive.half_gap, drive.shaft_damping, e, states=names)
    if contact_feedback is None:
        return loop
    if contact_feedback.n_integral != feedback.n_integral:
        raise ParameterError("contact_feedback", f"{contact_feedback.n_integral} integrals", f"with {feedback.n_integral}, as in the gap")
    contact_a, contact_e = _closed(drive, contact_feedback)
    return replace(loop, contact_a=contact_a, contact_e=contact_e)


def _closed(drive: TwoInertias, feedback: Feedback) -> tuple[Array, Array]:
    """Return dynamics (n, n) and reference input (n, 3) without torque."""
    n = len(feedback.gain)
    a, e, command = np.zeros((n, n)), np.zeros((n, N_REFERENCE)), np.zeros(n)
    a[:4, :4], command[:4] = drive.a, drive.command
    a -= np.outer(command, feedback.gain)
    e += np.outer(command, feedback.reference)
    if feedback.integral:
        a[4:], e[4:] = np.array(feedback.integral), np.array(feedback.integral_reference)
    return a, e
