"""Size an axis from catalogue data: forces, masses, model, proposed controller and its margins."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from contourlab.components.controller.cascade import Cascade
from contourlab.components.plant.ball_screw import BallScrew
from contourlab.components.plant.mass_damper import MassDamper
from contourlab.components.velocity.filtered_difference import FilteredDifference

if TYPE_CHECKING:
    from contourlab.analysis.linear.margins import Margins

GRAVITY = 9.81
FASTEST, DAMPING = 0.22, 1.1
"""Proposed bandwidth times servo period, and damping ratio of the velocity loop."""
FILTER_RATIO, KV_RATIO = 10.0, 0.35
"""Velocity filter and proposed Kv, over the bandwidth."""


def rounded(value: float) -> float:
    """Return a value with four digits, enough for a guess."""
    return float(f"{value:.4g}")


@dataclass(frozen=True)
class SizedAxis:
    """An axis from its answers.

    Attributes
    ----------
    name : str
    period : float [s]
        Servo period.
    values : dict
        Answers in SI by key; those of questions without an answer are guessed.
    guesses : set of str
        Keys of the guessed values.
    carried : float [kg]
        Mass of the axes that it carries.
    """

    name: str
    period: float
    values: dict[str, Any] = field(default_factory=dict)
    guesses: set[str] = field(default_factory=set)
    carried: float = 0.0

    def __getattr__(self, key: str) -> Any:
        try:
            return self.values[key]
        except KeyError:
            raise AttributeError(key) from None

    def span(self, key: str, of: Callable[[SizedAxis], float], ends: tuple[float, float]) -> tuple[float, float]:
        """Return the values of a function of the axis with the answer `key` multiplied by two factors."""
        low, high = (of(replace(self, values={**self.values, key: factor * self.values[key]})) for factor in ends)
        return rounded(low), rounded(high)

    @property
    def linear(self) -> bool:
        """Whether a linear motor drives it."""
        return bool(self.values["drive"] == "linear")

    @property
    def rated(self) -> float:
        """Rated torque [N*m], or force of a linear motor [N]."""
        return float(self.values["rated_force" if self.linear else "rated_torque"])

    @property
    def current(self) -> float:
        """Peak current [A]."""
        return float(self.peak_force / self.force_constant if self.linear else self.peak_torque / self.torque_constant)

    @property
    def inertia(self) -> float:
        # Drop the rounding digits of the sum of two typed numbers.
        return float(f"{self.rotor_inertia + self.screw_inertia:.12g}")

    @property
    def reflected(self) -> float:
        """Mass of the rotating parts as seen at the table [kg]."""
        return 0.0 if self.linear else float(self.inertia * (2.0 * math.pi / self.lead) ** 2)

    @property
    def mass(self) -> float:
        """Accelerated mass [kg]."""
        return float(self.moved_mass + self.carried + self.reflected)

    def force(self, effort: float) -> float:
        """Return the force at the table [N] of a torque, or of a force of a linear motor."""
        return effort if self.linear else float(2.0 * math.pi * self.efficiency / self.lead * effort)

    @property
    def peak(self) -> float:
        """Peak force at the table [N]."""
        return self.force(self.peak_force if self.linear else self.peak_torque)

    @property
    def weight(self) -> float:
        """Weight along the axis [N]."""
        return rounded(GRAVITY * (self.unbalanced_mass or 0.0))

    @property
    def standing_force(self) -> float:
        """Force at the velocity limit without acceleration [N]."""
        return float(self.weight + self.friction + self.damping * self.velocity)

    @property
    def wanted_force(self) -> float:
        """Force at the limits of velocity and acceleration [N]."""
        return float(self.mass * self.acceleration + self.standing_force)

    @property
    def bandwidth_rate(self) -> float:
        """Natural frequency of the velocity loop [rad/s]."""
        return rounded(2.0 * math.pi * self.bandwidth)

    @property
    def plant(self) -> BallScrew | MassDamper:
        """The plant, without what it carries."""
        if self.linear:
            return MassDamper(mass=self.moved_mass, damping=self.damping, force_constant=self.force_constant)
        turning = {name: self.values[name] for name in ("lead", "torque_constant", "efficiency", "damping")}
        return BallScrew(mass=self.moved_mass, inertia=self.inertia, **turning)

    def margins(self) -> Margins:
        """Return the margins of the proposed cascade.

        Raises
        ------
        ParameterError
            If the axis has more damping than the bandwidth allows.
        """
        from contourlab.analysis.linear.sampled_loop import sampled_loop
        from contourlab.loop import Axis, AxisController

        gain, decay = self.plant.loaded(self.carried).rigid_model()
        gains: dict[str, Any] = Cascade.tune(self.bandwidth_rate, DAMPING, gain, decay, self.kv)
        velocity = FilteredDifference(bandwidth=FILTER_RATIO * self.bandwidth_rate)
        controller = AxisController(controller=Cascade(**gains), velocity=velocity)
        return sampled_loop(Axis(self.name, self.plant), controller, self.period, self.carried).margins()
