"""Size an axis from catalogue data: forces, masses, model, proposed controller and its margins."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.controller.cascade import Cascade
from contourlab.components.plant.plant import BallScrew, MassDamper, Plant
from contourlab.components.plant.stepper import Stepper
from contourlab.components.plant.two_sided import ElasticBallScrew, TwoMass
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.errors import ParameterError
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.study.guards import Bounds
from contourlab.study.notch import notched

GRAVITY = 9.81
FASTEST, DAMPING = 0.22, 1.1
"""Proposed bandwidth times servo period, and damping ratio of the velocity loop."""
FILTER_RATIO, KV_RATIO = 10.0, 0.35
"""Velocity filter and proposed Kv, over the bandwidth."""
SLOWER = np.geomspace(1.0, 0.1, 15).tolist()
"""Bandwidths to try with a resonance, over the fastest."""
LOAD_SHARE = 0.5
"""Share of a linear axis' mass beyond the spring of its resonance."""


def rounded(value: float) -> float:
    """Return a value with four digits, enough for a guess."""
    return float(f"{value:.4g}")


@dataclass(frozen=True)
class SizedAxis:
    """An axis from its answers.

    Attributes
    ----------
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
    def stepping(self) -> bool:
        """Whether the control sends steps and closes no loop."""
        return self.drive in ("step-drive", "stepper")

    @property
    def rated(self) -> float:
        """Rated torque [N*m], or force of a linear motor [N]; half of the holding torque of a stepper."""
        return float(0.5 * self.holding_torque if self.drive == "stepper" else self.rated_force if self.linear else self.rated_torque)

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
        return 0.0 if self.drive in ("linear", "step-drive") else float(self.inertia * (2.0 * math.pi / self.lead) ** 2)

    @property
    def mass(self) -> float:
        """Accelerated mass [kg]."""
        return float(self.moved_mass + self.carried + self.reflected)

    def force(self, effort: float) -> float:
        """Return the force at the table [N] of a torque, or of a force of a linear motor."""
        return effort if self.linear else float(2.0 * math.pi * self.efficiency / self.lead * effort)

    @property
    def peak(self) -> float:
        """Peak force at the table [N]; the holding force of a stepper."""
        return self.force(2.0 * self.rated if self.drive == "stepper" else self.peak_force if self.linear else self.peak_torque)

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
    def filter_rate(self) -> float:
        """Bandwidth of the velocity filter [rad/s]."""
        return rounded(FILTER_RATIO * self.bandwidth_rate)

    @property
    def plant(self) -> Plant:
        """The plant, without what it carries."""
        own: dict[str, Any] = {"mass": self.moved_mass, "damping": self.damping}
        elastic = {"resonance": self.own_resonance} if self.resonance else {}
        if self.linear:
            return (TwoMass if elastic else MassDamper)(**own, force_constant=self.force_constant, **elastic)
        motor = ("holding_torque", "corner_speed") if self.stepping else ("torque_constant",)
        own |= {name: self.values[name] for name in ("lead", "efficiency", *motor)} | {"inertia": self.inertia}
        return (Stepper if self.stepping else ElasticBallScrew if elastic else BallScrew)(**own, **elastic)

    @property
    def own_resonance(self) -> float:
        """The resonance without carried mass [Hz]; it is measured on the assembled machine."""
        motor = LOAD_SHARE * self.moved_mass if self.linear else self.reflected
        own = (1.0 - LOAD_SHARE) * self.moved_mass if self.linear else self.moved_mass
        reduced, loaded = (motor * load / (motor + load) for load in (own, own + self.carried))
        return rounded(self.resonance * math.sqrt(loaded / reduced))

    @property
    def microsteps(self) -> float:
        """Pulses per full step of a stepper; 0 where the travel per pulse is unknown."""
        return float(self.lead / (200.0 * self.pulse)) if self.pulse else 0.0

    @property
    def substeps(self) -> int:
        """Sub-steps that the plant needs; of a stepper twice as many, since guesses may make it faster."""
        return int(self.plant.loaded(self.carried).fewest_substeps(self.period)[0]) * (2 if self.stepping else 1)

    @property
    def fastest(self) -> float:
        """Natural frequency of the velocity loop that servo period and resonance permit at most [Hz]."""
        return min(FASTEST / self.period / (2.0 * math.pi), 0.5 * (self.values.get("resonance") or math.inf))

    @property
    def below_half(self) -> bool:
        """Whether its resonance, if any, is below half of the servo frequency."""
        return 2.0 * (self.resonance or 0.0) * self.period < 1.0

    def slowed_down(self) -> SizedAxis:
        """Return the axis with the fastest guess of bandwidth, and of Kv, at which its resonance leaves 6 dB and 30 degrees."""
        if not self.resonance or "bandwidth" not in self.guesses or not self.below_half:
            return self
        rates = [2.0 * math.pi * factor * self.fastest for factor in SLOWER]
        slower = [{"bandwidth": rate / (2.0 * math.pi), "kv": KV_RATIO * rate if "kv" in self.guesses else self.kv} for rate in rates]
        trials = [replace(self, values={**self.values, **gains}) for gains in slower]

        def keeps(trial: SizedAxis) -> bool:
            with suppress(ParameterError):
                return not Bounds().broken(trial.margins())
            return False

        return trials[min(bisect_left(trials, True, key=keeps), len(trials) - 1)]

    @cached_property
    def controller(self) -> AxisController:
        """The proposed cascade, with a notch for a resonance.

        Raises
        ------
        ParameterError
            If the axis has more damping than the bandwidth allows, or a resonance above half of the servo frequency.
        """
        gain, decay = self.plant.loaded(self.carried).rigid_model()
        gains: dict[str, Any] = Cascade.tune(self.bandwidth_rate, DAMPING, gain, decay, self.kv)
        velocity = FilteredDifference(bandwidth=self.filter_rate)
        cascade = Cascade(**gains, balance_bandwidth=self.filter_rate)
        plain = AxisController(controller=cascade, velocity=velocity, feedback="motor" if self.resonance else "load")
        if not self.resonance:
            return plain
        return notched(self._alone, Controller({self.name: plain}), self.name).axes[self.name]

    @property
    def _alone(self) -> Machine:
        """A machine of this axis, with what it carries."""
        return Machine(self.name, (Axis(self.name, self.plant.loaded(self.carried), substeps=self.substeps),), self.period)

    def margins(self) -> Margins:
        """Return the margins of the proposed controller; raise as `controller` does."""
        return sampled_loop(self._alone.axes[0], self.controller, self.period).margins()
