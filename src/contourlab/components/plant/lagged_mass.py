"""Plants whose drive's force lags behind its command: what they share."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import LinearModel
from contourlab.components.mechanics.propagator import NAMES, STIFFEST, doublings_for, propagator
from contourlab.components.plant.plant import SingleMass
from contourlab.engine.step import Port


class LaggedMass(SingleMass):
    """A mass behind a lag of first order on which its motion acts back: v' = m (f + load - friction) - d v, f' = r (g u - f) - b v.

    m is the mobility, d the decay, r the rate of the lag, g the force per command at rest, b the back-action; f is in force units. A plant
    of this family gives the five as `rates`; its linear part is integrated exactly for any of them, so that r may be far above one over the
    servo period.
    """

    states = (Port("position"), Port("velocity"), Port("force"))
    derived = (
        "mobility_value",
        "decay_value",
        "rate_value",
        "gain_value",
        "back_value",
        *(f"{part}_{name}" for part in ("full", "half") for name in NAMES),
    )

    def rates(self, par: Any) -> tuple[Any, Any, Any, Any, Any]:
        """Return m [m/s^2 per force], d [1/s], r [1/s], g [force per command] and b [force/m]: numbers or arrays (n_variant,)."""
        # What tells one drive from another.
        raise NotImplementedError

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        m, d, r, g, b = self.rates(par)
        doublings = doublings_for(float(np.max((d + r + np.sqrt(m * b)) * dt)))
        full, half = (propagator(d, r, d * r + m * b, h, doublings) for h in (dt, 0.5 * dt))
        return (m, d, r, g, b, *full, *half)

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        """Return the force that a steady command gives at rest."""
        return par.gain_value * command  # type: ignore[no-any-return]

    def fewest_substeps(self, dt: float) -> tuple[int, str]:
        m, d, r, _, b = self.rates(self)
        # Its linear part is exact up to so many of its shortest time constants in a step.
        wanted = math.ceil(float((d + r + np.sqrt(m * b)) * dt) / STIFFEST)
        words = f"a {self.kind} whose time constants are so far below the servo period; or take a plant without them, such as mass-damper"
        return max(1, wanted), words

    def rigid_model(self) -> tuple[float, float]:
        """Return gain and damping of v' = a u - b v with the same steady velocity, b being one over the sum of the time constants."""
        m, d, r, g, b = (float(number) for number in self.rates(self))
        return m * r * g / (d + r), (d * r + m * b) / (d + r)

    def linearize(self) -> LinearModel:
        m, d, r, g, back = self.rates(self)
        a = np.array([[0.0, 1.0, 0.0], [0.0, -d, m], [0.0, -back, -r]])
        b = np.array([[0.0, 0.0], [0.0, m], [r * g, 0.0]])
        return LinearModel(a, b, np.eye(2, 3), np.zeros((2, 2)), ("command", "load"), ("position", "velocity"))
