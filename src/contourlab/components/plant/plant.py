"""Base classes of plants, and the plants with a single mass."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import Component, LinearModel, param, response_of
from contourlab.components.plant.linearised import continuous_model, linearised
from contourlab.engine.step import Port
from contourlab.errors import ComponentError, ParameterError

SLOW, FREE = 1e-3, 1e-5
"""Frequency of slow motions, as a part of the slowest mode; modes below this part of the fastest are free motions."""


class Plant(Component):
    """Base of plants: one mass, or several in series; of a plant of any shape, with a `step` of its own.

    Such a plant has states of its own and moves to the end of the step, under the inputs `command` and `load`. Its outputs `position`,
    `velocity` and `acceleration` are those of the axis then; it may add a `motor_position` and `motor_velocity`, and what the sensor reads.
    The machine's friction acts on it if it has a constant ``mobility_value``: `load` then pushes the mass whose velocity it gives.

    Attributes
    ----------
    measured : str
        The output that the sensor of the axis reads; of a plant with two sides not that of the motor, which has a sensor of its own.
    command_unit, force_unit : str
        Units of the command that drives it and of the forces on it.
    two_sided : bool
        Whether motor and load can differ in position: then it has outputs ``motor_position`` and ``motor_velocity``.
    rest_depends : tuple of str
        Parameters that determine the states at rest.
    """

    family = "plant"
    command_unit = "N"
    force_unit: ClassVar[str] = "N"
    two_sided: ClassVar[bool] = False
    rest_depends: ClassVar[tuple[str, ...]] = ()
    measured: ClassVar[str] = "position"

    @property
    def steps_itself(self) -> bool:
        """Whether it has a step of its own, instead of one made from its constants."""
        return (type(self).step, type(self).step_function) != (Component.step, Component.step_function)

    def at_rest(self, position: float) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return states and outputs at rest: all whose name ends in position, and what is measured, are there; the others are zero."""
        there = [port for port in (*self.states, *self.outputs) if port.name.endswith("position") or port.name == self.measured]
        values = {port.name: (position,) * port.size or position for port in there}
        return values, values

    def linear(self) -> Any:
        """Return the plant without its nonlinear parts; with a step of its own its linear model about rest."""
        return linearised(self) if self.steps_itself and not self.ring else self

    def linearize(self) -> LinearModel | None:
        """Return the linear model about rest; None if it looks back in time."""
        return continuous_model(self) if self.steps_itself and not self.ring else None

    @staticmethod
    def moved_mass(par: Any) -> Any:
        """Return the mass in linear motion [kg], without rotary inertia: numbers or arrays (n_variant,)."""
        return par.mass + par.carried_mass

    def rigid_model(self) -> tuple[float, float]:
        """Return gain a [m/s^2 per command] and damping b [1/s] of v' = a u - b v, the plant for slow motions."""
        (to_command, _), s = self._slow()
        return float(s.imag / (1.0 / to_command).imag), float((1.0 / to_command).real * s.imag / (1.0 / to_command).imag)

    def _slow(self) -> tuple[Any, complex]:
        """Return the response of velocity to command and load at s, far below all modes, and s."""
        model = self.linearize()
        if model is None:
            raise ComponentError(f"a {self.kind} has no linear model, which the design of gains needs")
        rates = np.abs(np.linalg.eigvals(model.a))
        s = 1j * SLOW * float(min(rates[rates > FREE * rates.max(initial=0.0)], default=1.0))
        at = [model.inputs.index(name) for name in ("command", "load")]
        return response_of(model.a, model.b, model.c, model.d, s)[0, model.outputs.index("velocity"), at], s

    @property
    def takes_position(self) -> bool:
        """Whether its command is a position: then it closes its own loop, or needs none."""
        return self.command_unit == "m"

    @property
    def knows_mass(self) -> bool:
        """Whether mass can be added; if not, only the response is known."""
        return "carried_mass" in self.parameters

    def loaded(self, mass: float) -> Any:
        """Return the plant with `mass` [kg] added; unchanged if only its response is known."""
        if not mass or not self.knows_mass:
            return self
        return self.replace(carried_mass=self.values()["carried_mass"] + mass)

    def fewest_substeps(self, dt: float) -> tuple[int, str]:
        """Return the least number of sub-steps over the time dt [s], and the reason as text; for all variants if parameters are arrays."""
        return 1, ""

    @property
    def force_per_command(self) -> float:
        """Force of the drive on the axis per command."""
        to_command, to_load = self._slow()[0]
        return float((to_command / to_load).real)

    def mobilities(self) -> tuple[float, ...]:
        """Return the acceleration per force [m/s^2 per force unit] where a friction acts: at the load, and at the motor if it has one.

        Empty if it tells none: then it takes no friction.
        """
        known = self.block(1.0)
        return (float(known["mobility_value"]),) if "mobility_value" in known else ()


class SingleMass(Plant):
    """A mass with viscous damping, pushed by a drive: v' = mobility (drive force + load - friction) - decay v.

    A subclass derives ``mobility_value`` and ``decay_value``, or overrides `mobility` and `decay`, and defines `drive_force`. If its mass
    is known it has `mass` and `carried_mass`. `contourlab.components.mechanics.core` integrates it with a friction.
    """

    states: ClassVar[tuple[Port, ...]] = (Port("position"), Port("velocity"))

    @staticmethod
    def mobility(par: Any) -> float:
        """Return the acceleration per force [m/s^2 per force unit]."""
        return par.mobility_value  # type: ignore[no-any-return]

    @staticmethod
    def decay(par: Any) -> float:
        """Return the rate at which a free motion decays [1/s]."""
        return par.decay_value  # type: ignore[no-any-return]

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        """Return the force of the drive."""
        raise NotImplementedError

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"position": position}, {"position": position}

    def mobilities(self) -> tuple[float, ...]:
        return (float(type(self).mobility(self.constants())),)

    @property
    def force_per_command(self) -> float:
        return float(self.drive_force(self.constants(), 1.0))

    def rigid_model(self) -> tuple[float, float]:
        par = self.constants()
        kind = type(self)
        return float(kind.mobility(par) * kind.drive_force(par, 1.0)), float(kind.decay(par))

    def linearize(self) -> LinearModel:
        gain, damping = self.rigid_model()
        a = np.array([[0.0, 1.0], [0.0, -damping]])
        b = np.array([[0.0, 0.0], [gain, *self.mobilities()]])
        return LinearModel(a, b, np.eye(2), np.zeros((2, 2)), ("command", "load"), ("position", "velocity"))


class RigidAxis(SingleMass):
    """Rigid axis with a normalised drive: p' = v, v' = -b v + a (u + d).

    The command u and the disturbance d, friction included, are fractions of the drive's full scale. The steady velocity per command is a/b,
    the time constant 1/b. Valid below the first resonance of the drive train.

    References
    ----------
    Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring", eqs (1) and (2).
    """

    kind = "rigid-axis"
    example = {"gain": 1.695, "damping": 10.1}
    reference = "Ghaffari & Ulsoy 2017, eqs 1-2"
    command_unit = "full_scale"
    force_unit = "full_scale"

    gain: float = param(
        unit="m/s^2/full_scale",
        minimum=0.0,
        exclusive=True,
        display="mm/s^2/full_scale",
        doc="acceleration at full command, a",
        source="Ghaffari & Ulsoy, eq 2",
    )
    damping: float = param(default=0.0, unit="1/s", minimum=0.0, doc="decay rate of a free motion, b", source="Ghaffari & Ulsoy, eq 2")

    @staticmethod
    def mobility(par: Any) -> float:
        return par.gain  # type: ignore[no-any-return]

    @staticmethod
    def decay(par: Any) -> float:
        return par.damping  # type: ignore[no-any-return]

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        return command


class MassDamper(SingleMass):
    """Mass with viscous damping, pushed by a current-controlled motor: m v' = K_f i - c v + load - friction.

    `carried_mass` is the mass on the axis: a work piece, other axes. A machine adds the axes mounted on this one. All of `mass` counts as
    linear motion when another axis carries this one; if much of it is rotary inertia, use "ball-screw", which separates the two.
    """

    kind = "mass-damper"
    example = {"mass": 20.0, "damping": 100.0, "force_constant": 60.0}
    reference = "Newton's second law"
    command_unit = "A"
    derived = ("mobility_value", "decay_value")

    mass: float = param(unit="kg", minimum=0.0, exclusive=True, doc="moving mass of the axis; rotating parts as J (2 pi / lead)^2")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="additional mass on the axis")
    damping: float = param(default=0.0, unit="N*s/m", minimum=0.0, doc="viscous damping of guides, screw and motor")
    force_constant: float = param(unit="N/A", minimum=0.0, exclusive=True, doc="force of the drive per command")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        mass = par.mass + par.carried_mass
        return 1.0 / mass, par.damping / mass

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        return par.force_constant * command  # type: ignore[no-any-return]


class BallScrew(SingleMass):
    """Rigid ball-screw feed drive: (m + m_c + J (2 pi/l)^2) v' = (2 pi eta / l) K_t i - c v + load - friction.

    Motor current drives the screw; rotor, coupling and screw turn with it. Valid below the first torsional resonance, and without
    backlash.

    References
    ----------
    Altintas, "Manufacturing Automation", 2nd ed., chapter on feed drives: inertia and torque reflected over the lead.
    """

    kind = "ball-screw"
    example = {"mass": 20.0, "inertia": 2e-4, "lead": 0.01, "torque_constant": 0.5, "damping": 100.0}
    reference = "Altintas 2012, feed drives"
    command_unit = "A"
    derived = ("mobility_value", "decay_value", "force_constant_value")

    mass: float = param(unit="kg", minimum=0.0, exclusive=True, doc="mass of the table and everything fixed to it")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="additional mass on the axis")
    inertia: float = param(unit="kg*m^2", minimum=0.0, display="kg*cm^2", doc="inertia of rotor, coupling and screw, J")
    lead: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel per turn of the screw, l")
    torque_constant: float = param(unit="N*m/A", minimum=0.0, exclusive=True, doc="torque of the motor per command, K_t")
    efficiency: float = param(default=0.95, minimum=0.0, maximum=1.0, exclusive=True, doc="of the screw, eta; ground: 0.9 to 0.95")
    damping: float = param(default=0.0, unit="N*s/m", minimum=0.0, doc="viscous damping seen at the table, c")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        per_metre = 2.0 * math.pi / par.lead
        mass = par.mass + par.carried_mass + par.inertia * per_metre * per_metre
        return 1.0 / mass, par.damping / mass, par.torque_constant * par.efficiency * per_metre

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        return par.force_constant_value * command  # type: ignore[no-any-return]


def reflected_inertia(mass: float, lead: float) -> float:
    """Return the inertia of a mass reflected to a shaft, m (l/2 pi)^2.

    Parameters
    ----------
    mass : float [kg], >= 0
    lead : float [m], > 0
        Travel per turn of the shaft; for a rack, the circumference of its pinion.

    Returns
    -------
    float [kg*m^2]

    Raises
    ------
    ParameterError
        If a number is out of range.

    >>> f"{reflected_inertia(100.0, 0.01):.4g}"  # 100 kg on a screw of 10 mm
    '0.0002533'
    """
    _check("mass", mass, "kg", mass >= 0.0)
    _check("lead", lead, "m", lead > 0.0)
    return mass * (lead / (2.0 * math.pi)) ** 2


def reflected_mass(inertia: float, lead: float) -> float:
    """Return the mass of an inertia reflected to the table, J (2 pi/l)^2.

    Parameters
    ----------
    inertia : float [kg*m^2], >= 0
    lead : float [m], > 0
        Travel per turn of the shaft.

    Returns
    -------
    float [kg]

    Raises
    ------
    ParameterError
        If a number is out of range.

    >>> round(reflected_mass(reflected_inertia(100.0, 0.01), 0.01), 9)
    100.0
    """
    _check("inertia", inertia, "kg*m^2", inertia >= 0.0)
    _check("lead", lead, "m", lead > 0.0)
    return inertia * (2.0 * math.pi / lead) ** 2


def _check(name: str, value: float, unit: str, within: bool) -> None:
    if not (within and math.isfinite(value)):
        raise ParameterError(name, f"{value:g}", "finite and > 0" if name == "lead" else "finite and >= 0", unit)


MOST_DAMPED = 0.5
"""Largest damping ratio of poles that count as a resonance."""


def resonance_of(plant: Plant) -> tuple[float, float] | None:
    """Return frequency [Hz] and damping ratio of the lowest resonance of a plant; None if it has none."""
    model = plant.linear().linearize()
    poles = np.linalg.eigvals(model.a) if model is not None else np.zeros(0)
    # Rounding splits the double pole of a free mass.
    fast = [pole for pole in poles if pole.imag > 1e-4 * np.abs(poles).max()]
    ringing = sorted((abs(pole), -pole.real / abs(pole)) for pole in fast if -pole.real < MOST_DAMPED * abs(pole))
    return (float(ringing[0][0] / (2.0 * math.pi)), float(ringing[0][1])) if ringing else None
