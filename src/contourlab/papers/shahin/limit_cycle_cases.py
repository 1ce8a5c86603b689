"""Limit cycles of test cases, by describing function and as exact periodic orbits.

The drive of Table 1 (half gap 4.91 mrad: 12.5 um on a 16 mm screw) under P-PI cascades. Six cases have a limit cycle, from 1.1 to 24
half-gaps. Three have none, though the describing function predicts one for two of them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from contourlab.analysis.backlash.lure import BacklashLoop, LimitCycle, predict_limit_cycles
from contourlab.analysis.backlash.periodic_orbit import PeriodicOrbit, find_orbits
from contourlab.papers.shahin.two_inertia_loop import Feedback, TwoInertias, motor_pid, p_pi_cascade, two_inertia_loop

DRIVE = TwoInertias(motor_inertia=5.2e-3, load_inertia=4.4e-3, stiffness=950.0, half_gap=2.0 * math.pi * 12.5e-6 / 0.016)


@dataclass(frozen=True)
class LimitCycleCase:
    """A drive and its controller.

    Attributes
    ----------
    kick : float
        Start of the search: motor-load difference in half-gaps.
    """

    name: str
    drive: TwoInertias
    feedback: Feedback
    kick: float = 30.0

    @property
    def loop(self) -> BacklashLoop:
        """The loop."""
        return two_inertia_loop(self.drive, self.feedback)


CASES = (
    LimitCycleCase("load side, K_v 180, K_p 5", DRIVE, p_pi_cascade(180.0, 5.0)),
    LimitCycleCase("motor side, K_v 300, K_p 4, K_i 1950", DRIVE, p_pi_cascade(300.0, 4.0, 1950.0, "motor")),
    LimitCycleCase("load side, K_v 150, K_p 5", DRIVE, p_pi_cascade(150.0, 5.0)),
    LimitCycleCase("load side, K_v 120, K_p 5, shaft damped", replace(DRIVE, shaft_damping=0.1), p_pi_cascade(120.0, 5.0)),
    LimitCycleCase("load side, K_v 60, K_p 5, K_i 200, load damped", replace(DRIVE, load_damping=0.01), p_pi_cascade(60.0, 5.0, 200.0)),
    LimitCycleCase("load side, K_v 20, K_p 5, load damped", replace(DRIVE, load_damping=0.02), p_pi_cascade(20.0, 5.0)),
)
"""Cases by falling amplitude."""

CASES_WITHOUT = (
    LimitCycleCase("motor side, K_v 60, K_p 1, K_i 1400", DRIVE, p_pi_cascade(60.0, 1.0, 1400.0, "motor")),
    LimitCycleCase("load side, K_v 5, K_p 2, load damped", replace(DRIVE, load_damping=0.02), p_pi_cascade(5.0, 2.0)),
    LimitCycleCase("motor side, PD of scheme II", DRIVE, motor_pid(1000.0, 200.0)),
)
"""Cases without a limit cycle; the describing function predicts one for all but the last."""


@dataclass(frozen=True, eq=False)
class Comparison:
    """One case by both methods.

    Attributes
    ----------
    predicted : LimitCycle or None
        Stable limit cycle of the describing function.
    orbit : PeriodicOrbit or None
        Stable periodic orbit.
    """

    case: LimitCycleCase
    predicted: LimitCycle | None
    orbit: PeriodicOrbit | None

    @property
    def amplitude_error(self) -> float:
        """Relative amplitude error of the describing function against the orbit; nan if one is missing."""
        return math.nan if self.predicted is None or self.orbit is None else self.predicted.ratio / self.orbit.ratio - 1.0


def compare(case: LimitCycleCase) -> Comparison:
    """Find the limit cycle of a case by describing function and by shooting."""
    loop = case.loop
    prediction = predict_limit_cycles(loop)
    orbits = [orbit for orbit in find_orbits(loop, prediction=prediction, kicks=(case.kick,)) if orbit.stable]
    predicted = next((cycle for cycle in prediction if cycle.stable), None)
    return Comparison(case, predicted, orbits[0] if orbits else None)
