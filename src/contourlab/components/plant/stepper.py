"""Plants whose command is a position: a stepper motor, which follows its step count like a spring, and a drive with loops of its own."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import LinearModel, param
from contourlab.components.plant.plant import BallScrew, SingleMass
from contourlab.engine.step import ports
from contourlab.errors import ComponentError
from contourlab.primitives import rint, sin, sqrt

COARSEST = 0.25
"""Largest phase of the oscillation about the count in a sub-step [rad]; there its frequency is 0.3 % too high."""


class Follower(SingleMass):
    """Base of plants that a step count pulls along: v' = mobility (pull + load - friction) - decay v.

    The command is the position that the count stands for at the end of the servo period. A subclass derives ``mobility_value``,
    ``decay_value``, ``stiffness_value`` and ``damper_value`` (pull per distance from the count, and per difference in speed),
    ``feed_value`` (pull per speed of the count) and ``step_value`` (travel of a step; 0 for a count without steps), and writes `pull`.
    `contourlab.components.mechanics.following` integrates it with a friction.
    """

    command_unit = "m"
    states = ports("position", "velocity", "count", "change")
    derived: ClassVar[tuple[str, ...]] = (
        *("mobility_value", "decay_value", "stiffness_value", "damper_value", "feed_value", "step_value"),
    )

    @staticmethod
    def pull(par: Any, count: float, rate: float, position: float, velocity: float) -> float:
        """Return the force of a count that moves at a rate [m/s], on an axis at a position and a velocity."""
        raise NotImplementedError

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        """Return a pull as it is."""
        return command

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        """Return the rest at the whole step nearest to a position."""
        step = float(self.constants().step_value)
        rest = step * rint(position / step) if step else position
        return {"position": rest, "count": position}, {"position": rest}

    def rigid_model(self) -> tuple[float, float]:
        raise ComponentError(f"a {self.kind} takes positions and closes no loop in the control: there are no gains to find")

    @property
    def force_per_command(self) -> float:
        raise ComponentError(f"a {self.kind} takes positions, not forces")

    def fewest_substeps(self, dt: float) -> tuple[int, str]:
        d = self.constants()
        fast = np.max(np.sqrt(d.stiffness_value * d.mobility_value))
        wanted = max(fast / COARSEST, np.max(d.decay_value + 2.0 * d.damper_value * d.mobility_value)) * dt
        return max(1, math.ceil(wanted - 1e-9)), f"a {self.kind} that oscillates about its count at {fast / (2.0 * math.pi):.4g} Hz"

    def linearize(self) -> LinearModel:
        """Return the model about a count at rest, without steps. Its second state is the velocity less what the count's speed adds."""
        d = self.constants()
        spring, decay = d.mobility_value * d.stiffness_value, d.decay_value + d.mobility_value * d.damper_value
        fed = d.mobility_value * (d.damper_value + d.feed_value)
        a = np.array([[0.0, 1.0], [-spring, -decay]])
        b = np.array([[fed, 0.0], [spring - decay * fed, d.mobility_value]])
        direct = np.array([[0.0, 0.0], [fed, 0.0]])
        return LinearModel(a, b, np.eye(2), direct, ("command", "load"), ("position", "velocity"))


class Stepper(Follower):
    """Stepper motor on a screw, rack or belt, in open loop: its torque is a sine of the angle between step count and rotor.

    F = F_h sin(pi/(2 s) (c - p + t (c' - p'))) with the count c, the travel of a full step s = l/n and F_h = 2 pi eta T_h/l acts on the
    mass m + m_c + J (2 pi/l)^2. At rest a load F moves the axis by (2 s/pi) asin(F/F_h). Beyond two full steps the motor pulls away from
    the count: the rotor falls behind by four full steps or a multiple. A run reports this, and its verdict fails.

    Where the drive's voltage no longer drives the full current, F_h falls as 1/sqrt(1 + (v/v_c)^2) with the speed v of the count: the
    current of a winding with resistance and inductance at a constant voltage. Choose the corner speed v_c by the pull-out torque of the
    data sheet. The voltage that oscillations about the count induce damps them: t gives small ones the damping ratio. A damper besides the
    sine would drag a rotor that is out of step along. Drag of the guides is a friction, or `damping`.

    References
    ----------
    Acarnley, "Stepping Motors: A Guide to Theory and Practice", 4th ed., IET 2002, chapters 3 (torque over angle, static error), 4
    (pull-out torque) and 5 (high speed).
    """

    kind = "stepper"
    reference = "Acarnley 2002, chapters 3 to 5"
    example = {
        "mass": 15.0,
        "carried_mass": 5.0,
        "inertia": 3e-3,
        "lead": 0.4,
        "holding_torque": 1.9,
        "full_steps": 200.0,
        "microsteps": 8.0,
        "efficiency": 0.95,
        "damping_ratio": 0.15,
        "damping": 20.0,
        "corner_speed": 5.0,
    }
    rest_depends = ("lead", "full_steps", "microsteps")
    derived = (*Follower.derived, "force_value", "wave_value", "lead_time", "slowness")

    mass = BallScrew.parameters["mass"]
    carried_mass = BallScrew.parameters["carried_mass"]
    inertia = BallScrew.parameters["inertia"]
    lead: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel per turn of the motor, l")
    holding_torque: float = param(unit="N*m", minimum=0.0, exclusive=True, doc="of the motor at the current of its drive, T_h")
    full_steps: float = param(default=200.0, minimum=4.0, whole=True, doc="full steps per turn, n: 200 for 1.8 deg")
    microsteps: float = param(default=16.0, minimum=0.0, whole=True, doc="pulses per full step; 0: a count without steps")
    efficiency: float = param(default=0.9, minimum=0.0, maximum=1.0, exclusive=True, doc="eta; belt, ball screw: 0.9, trapezoidal: 0.4")
    damping_ratio: float = param(default=0.1, minimum=0.0, maximum=2.0, doc="of oscillations about the count; usually 0.05 to 0.2")
    damping: float = param(default=0.0, unit="N*s/m", minimum=0.0, doc="viscous damping of guides and screw")
    corner_speed: float = param(
        default=math.inf,
        unit="m/s",
        minimum=0.0,
        exclusive=True,
        display="mm/min",
        doc="speed of the axis at which 71 % of the holding torque is left, v_c; inf: all of it at any speed",
    )

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        per_metre = 2.0 * math.pi / par.lead
        mass = par.mass + par.carried_mass + par.inertia * per_metre * per_metre
        force, wave = par.holding_torque * par.efficiency * per_metre, 0.25 * par.full_steps * per_metre
        stiffness = force * wave
        damper = 2.0 * par.damping_ratio * np.sqrt(stiffness * mass)
        pulses = par.full_steps * par.microsteps
        step = np.where(pulses > 0.0, par.lead / np.where(pulses > 0.0, pulses, 1.0), 0.0)
        fixed = 1.0 / mass, par.damping / mass, stiffness, damper, 0.0 * mass, step
        return (*fixed, force, wave, damper / stiffness, 1.0 / par.corner_speed)

    @staticmethod
    def pull(par: Any, count: float, rate: float, position: float, velocity: float) -> float:
        beyond = rate * par.slowness
        force = par.force_value / sqrt(1.0 + beyond * beyond)
        return force * sin(par.wave_value * (count - position + par.lead_time * (rate - velocity)))  # type: ignore[no-any-return]

    def linear(self) -> Any:
        """Return the motor without steps; its torque remains a sine."""
        return self.replace(microsteps=0.0)

    @property
    def full_step(self) -> float:
        """Travel of a full step [m]."""
        return float(self.lead / self.full_steps)


class StepDrive(Follower):
    """Stepper or servo drive by step and direction that closes its own loop: a lag of second order from count to position.

    p'' = w^2 (c - p) + 2 D w (a c' - p') + (w^2/k) (load - friction). These are the numbers that a log of count and position shows; at a
    constant speed the axis lags by the time 2 D (1 - a)/w. How such a drive counters loads its makers do not publish. Here a load moves the
    axis at rest by F/k, with the default by 1 um for 1 kN, whatever the masses. The drive loses no steps: it trips, as `following_error` of
    the axis says.

    References
    ----------
    Ellis, "Control System Design Guide", 4th ed., 2012, chapter 17 (position loops with velocity feedforward).
    """

    kind = "step-drive"
    rest_depends = ("pulse",)
    reference = "closed loop of second order: Ellis 2012"
    example = {"natural_frequency": 30.0, "damping_ratio": 0.8, "velocity_feedforward": 0.4, "load_stiffness": 2e5, "pulse": 1e-4}

    natural_frequency: float = param(unit="Hz", minimum=0.0, exclusive=True, doc="of the closed loop, w/2 pi")
    damping_ratio: float = param(default=1.0, minimum=0.0, maximum=1e3, exclusive=True, doc="of the closed loop, D")
    velocity_feedforward: float = param(default=0.0, minimum=0.0, maximum=1.0, doc="share of the count's speed fed forward, a")
    load_stiffness: float = param(default=1e9, unit="N/m", minimum=0.0, exclusive=True, display="N/um", doc="load per deflection, k")
    pulse: float = param(default=0.0, unit="m", minimum=0.0, display="um", doc="travel per pulse; 0: a count without steps")

    @property
    def knows_mass(self) -> bool:
        return False

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        w = 2.0 * math.pi * par.natural_frequency
        decay, mobility = 2.0 * par.damping_ratio * w, w * w / par.load_stiffness
        return mobility, decay, par.load_stiffness, 0.0 * w, par.velocity_feedforward * decay / mobility, par.pulse

    @staticmethod
    def pull(par: Any, count: float, rate: float, position: float, velocity: float) -> float:
        return par.stiffness_value * (count - position) + par.feed_value * rate  # type: ignore[no-any-return]

    def linear(self) -> Any:
        """Return the drive without steps."""
        return self.replace(pulse=0.0)
