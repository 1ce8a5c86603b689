"""Base of plants whose motor and load can differ in position."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import LinearModel
from contourlab.components.mechanics.two_mass_mechanics import two_mass_bristle_step, two_mass_step
from contourlab.components.plant.plant import Plant
from contourlab.engine.step import ports
from contourlab.errors import ComponentError

COARSEST = 0.5
"""Largest phase of the shaft's oscillation in a sub-step [rad]; there the fourth-order method damps it by 1e-4 per sub-step."""


class TwoSided(Plant):
    """Base of two masses joined by a spring and a damper, with or without a gap; all states are lengths at the load.

    A subclass derives `contourlab.components.families.TWO_SIDED`. `bonded` is 1 without a gap. `two_mass_mechanics` integrates the motion.
    """

    two_sided = True
    physical: ClassVar[bool] = True
    states = ports("motor_position", "motor_velocity", "position", "velocity", "side", "twist")
    outputs = ports("position", "velocity", "acceleration", "motor_position", "motor_velocity", "gap_state", "shaft_force")

    def gap_function(self) -> Any:
        """Return ``gap(par, position)``: half the gap at the load's position, and its slope."""
        return even_gap

    def joined(self, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Any:
        """Return the step with a friction on either side."""
        laws = {motor.law, load.law}
        if laws > {"bristle"} and laws != {"bristle", "smooth"}:
            # A held body and one with bending bristles would need a joint solution at every stop.
            raise ComponentError(
                f"a {self.kind} cannot combine a bristle friction with one of law {(laws - {'bristle'}).pop()!r} (motor {motor.kind}, load "
                f"{load.kind}): use bristles on both sides, or a smooth friction or none on the other side"
            )
        join = two_mass_bristle_step if "bristle" in laws else two_mass_step
        return join(self.gap_function(), self.physical, motor, load, motor_view, load_view)

    def linearize(self) -> LinearModel:
        """Return the model in contact: the drive without its gap."""
        d = self.constants()
        k, c, motor, load = d.stiffness_value, d.damper_value, d.motor_mobility, d.load_mobility
        a = np.array(
            [
                [0.0, 1.0, 0.0, 0.0],
                [-k * motor, -c * motor - d.motor_decay, k * motor, c * motor],
                [0.0, 0.0, 0.0, 1.0],
                [k * load, c * load, -k * load, -c * load - d.load_decay],
            ]
        )
        b = np.array([[0.0, 0.0], [d.force_value * motor, 0.0], [0.0, 0.0], [0.0, load]])
        names = ("position", "velocity", "motor_position", "motor_velocity")
        return LinearModel(a, b, np.eye(4)[[2, 3, 0, 1]], np.zeros((4, 2)), ("command", "load"), names)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        places = {"position": position, "motor_position": position}
        return places, places

    @property
    def force_per_command(self) -> float:
        return float(self.constants().force_value)

    def rigid_model(self) -> tuple[float, float]:
        d = self.constants()
        motor, load = 1.0 / d.motor_mobility, 1.0 / d.load_mobility
        return float(d.force_value / (motor + load)), float((motor * d.motor_decay + load * d.load_decay) / (motor + load))

    def mobilities(self) -> tuple[float, ...]:
        d = self.constants()
        return float(d.load_mobility), float(d.motor_mobility)

    def stiffened(self, resonance: float) -> Any:
        """Return the plant with a well damped (0.7) resonance [Hz] of its shaft in contact; itself if it is as stiff already."""
        raise NotImplementedError

    @property
    def shaft_rate(self) -> float:
        """Angular frequency [rad/s] of the undamped shaft in contact."""
        d = self.constants()
        return np.sqrt(d.stiffness_value * (d.motor_mobility + d.load_mobility))  # type: ignore[no-any-return]

    def fewest_substeps(self, dt: float) -> tuple[int, str]:
        d = self.constants()
        fast = float(np.max(self.shaft_rate))
        damped = float(np.max(d.damper_value * (d.motor_mobility + d.load_mobility) + np.maximum(d.motor_decay, d.load_decay)))
        wanted = max(fast * dt / COARSEST, damped * dt / 1.0)
        return max(1, math.ceil(wanted - 1e-9)), f"a shaft that oscillates at {fast / (2.0 * math.pi):.4g} Hz"


def even_gap(par: Any, position: float) -> tuple[float, float]:
    """Return half of a gap that is the same everywhere, and its slope."""
    return par.half_gap, 0.0
