"""Size an axis from catalogue data: reflected inertia, forces, guessed friction and damping, model for the controller."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

# Shares and ratios for guesses; the written files name each.
FRICTION_SHARE = 0.1
"""Coulomb friction over the force at rated torque: stiction of ball screws needs up to a tenth of the command (Ghaffari & Ulsoy)."""
DAMPING_SHARE = 0.1
"""Viscous force at the velocity limit over the force at rated torque: a typical share of rail guides and a greased nut."""
BREAKAWAY_RATIO = 1.25
EFFICIENCY = 0.95
GRAVITY = 9.81
OBSERVER_RATIO, FILTER_RATIO, VELOCITY_RATIO = 2.5, 10.0, 30.0
"""Ratios of bandwidths: observer to Kv, observer filter to observer, velocity low-pass to Kv."""
FASTEST = 0.1
"""Largest product of Kv and servo period; above it the hold uses up the phase margin of the placed poles."""
DAMPING = 0.8


def rounded(value: float) -> float:
    """Return a value with four digits, enough for a guess."""
    return float(f"{value:.4g}")


@dataclass(frozen=True)
class SizedAxis:
    """Answers about an axis in SI, as attributes, and values computed from them; `defaults` are the questions answered by default."""

    name: str
    answers: Mapping[str, Any]
    carried: float
    defaults: frozenset[str] = frozenset()

    def __getattr__(self, key: str) -> Any:
        try:
            return self.answers[key]
        except KeyError:
            raise AttributeError(key) from None

    @property
    def inertia(self) -> float:
        # Drop the rounding digits of the sum of two typed numbers.
        return float(f"{self.answers['rotor_inertia'] + self.answers['screw_inertia']:.12g}")

    @property
    def reflected(self) -> float:
        """Mass of the rotating parts as seen at the table [kg]."""
        return float(self.inertia * (2.0 * math.pi / self.answers["lead"]) ** 2)

    @property
    def mass(self) -> float:
        """Accelerated mass [kg]."""
        return float(self.answers["moved_mass"] + self.carried + self.reflected)

    def force(self, torque: float) -> float:
        """Return the force at the table [N] of a torque."""
        return float(2.0 * math.pi * EFFICIENCY / self.answers["lead"] * torque)

    @property
    def friction(self) -> float:
        return rounded(FRICTION_SHARE * self.force(self.answers["rated_torque"]))

    @property
    def damping(self) -> float:
        return rounded(DAMPING_SHARE * self.force(self.answers["rated_torque"]) / self.answers["velocity"])

    @property
    def weight(self) -> float:
        """Weight along the axis [N]."""
        return rounded(GRAVITY * (self.answers["unbalanced_mass"] or 0.0))

    @property
    def standing_force(self) -> float:
        """Force at the velocity limit without acceleration [N]."""
        return float(self.weight + self.friction + self.damping * self.answers["velocity"])

    @property
    def wanted_force(self) -> float:
        """Force at the limits of velocity and acceleration [N]."""
        return float(self.mass * self.answers["acceleration"] + self.standing_force)

    @property
    def model(self) -> tuple[float, float]:
        """Acceleration per ampere [m/s^2/A] and decay rate [1/s]."""
        return rounded(self.force(self.answers["torque_constant"]) / self.mass), rounded(self.damping / self.mass)
