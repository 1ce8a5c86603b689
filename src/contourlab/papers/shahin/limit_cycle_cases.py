"""Limit cycles of stated cases: what the describing function says, what the exact periodic orbit is, and what a simulation settles on.

The drive is that of Shahin, ElMaraghy & ElBeheiry (table 1, half of the gap 4.91 mrad: 12.5 um on a screw of 16 mm) under P-PI cascades.
Six cases have a limit cycle, from 1.1 to 24 half-gaps; three have none, though the describing function says so of two of them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.backlash.exact_simulation import ExactRun, simulate_exact
from contourlab.analysis.backlash.limit_cycle_prediction import LimitCycle, Prediction, predict_limit_cycles
from contourlab.analysis.backlash.lure import BacklashLoop
from contourlab.analysis.backlash.periodic_orbit import PeriodicOrbit, find_orbits
from contourlab.papers.shahin.two_inertia_loop import Feedback, TwoInertias, motor_pid, p_pi_cascade, two_inertia_loop

Array = NDArray[np.float64]

DRIVE = TwoInertias(motor_inertia=5.2e-3, load_inertia=4.4e-3, stiffness=950.0, half_gap=2.0 * math.pi * 12.5e-6 / 0.016)
STAGE, STAGES = 100, 60
"""Periods after which the amplitude is looked at again, and how often."""
SETTLED = 1e-4
"""Relative change of the amplitude over a stage at which a motion is called settled; and how close to the gap it is called at rest."""
MEASURED = 20


@dataclass(frozen=True)
class LimitCycleCase:
    """A drive and its controller.

    Attributes
    ----------
    name : str
    drive : TwoInertias
    feedback : Feedback
    kick : float
        Motor-load difference, in half-gaps, from which a simulation finds the limit cycle.
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
"""By falling amplitude."""

CASES_WITHOUT = (
    LimitCycleCase("motor side, K_v 60, K_p 1, K_i 1400", DRIVE, p_pi_cascade(60.0, 1.0, 1400.0, "motor")),
    LimitCycleCase("load side, K_v 5, K_p 2, load damped", replace(DRIVE, load_damping=0.02), p_pi_cascade(5.0, 2.0)),
    LimitCycleCase("motor side, PD of scheme II", DRIVE, motor_pid(200.0, 1000.0)),
)
"""Cases without a limit cycle; the describing function says of all but the last that there is one."""


@dataclass(frozen=True, eq=False)
class Comparison:
    """One case, three ways.

    Attributes
    ----------
    case : LimitCycleCase
    predicted : LimitCycle or None
        The stable one of the describing function, if it has one.
    orbit : PeriodicOrbit or None
        The stable periodic orbit, if there is one.
    simulated_ratio, simulated_frequency : float
        Amplitude over half of the gap and frequency [rad/s] of the motion a simulation settles on; 0 and nan if it comes to rest.
    """

    case: LimitCycleCase
    predicted: LimitCycle | None
    orbit: PeriodicOrbit | None
    simulated_ratio: float
    simulated_frequency: float

    @property
    def frequency_error(self) -> float:
        """Relative error of the describing function's frequency against the orbit; nan without either."""
        return math.nan if self.predicted is None or self.orbit is None else self.predicted.frequency / self.orbit.frequency - 1.0

    @property
    def amplitude_error(self) -> float:
        """Relative error of the describing function's amplitude against the orbit; nan without either."""
        return math.nan if self.predicted is None or self.orbit is None else self.predicted.ratio / self.orbit.ratio - 1.0


def compare(case: LimitCycleCase) -> Comparison:
    """Return the limit cycle of a case by the describing function, by shooting, and by following a motion until it has settled."""
    loop = case.loop
    prediction = predict_limit_cycles(loop)
    orbits = find_orbits(loop, prediction=prediction, kicks=(case.kick,)).stable
    ratio, frequency = _settled(loop, case, prediction)
    predicted = next((cycle for cycle in prediction.cycles if cycle.stable), None)
    return Comparison(case, predicted, orbits[0] if orbits else None, ratio, frequency)


def _settled(loop: BacklashLoop, case: LimitCycleCase, prediction: Prediction) -> tuple[float, float]:
    """Return amplitude over half of the gap and frequency of the motion that a kick ends in: followed until its amplitude stays."""
    slowest = min((cycle.frequency for cycle in prediction.cycles), default=math.sqrt(case.drive.stiffness / case.drive.load_inertia))
    state, twist, before = np.zeros(loop.n), None, math.inf
    state[2] = -case.kick * loop.half_gap
    for _ in range(STAGES):
        run = simulate_exact(loop, state, STAGE * 2.0 * math.pi / slowest, twist=twist)
        ratio, frequency = _last_periods(run)
        if ratio < 1.0 + SETTLED:
            return 0.0, math.nan
        if abs(ratio - before) <= SETTLED * ratio:
            return ratio, frequency
        end, before = run.spans[-1].end, ratio
        state, twist = end[: loop.n], float(end[loop.n]) if run.flow.twisted else None
    return before, frequency


def _last_periods(run: ExactRun) -> tuple[float, float]:
    """Return amplitude over half of the gap, and frequency, of the last periods; zero where contact ends before the run does."""
    begins = run.times[run.modes == 1]
    if begins.size <= MEASURED or begins[-1] < 0.5 * run.duration:
        return 0.0, math.nan
    difference = run.difference(np.linspace(begins[-1 - MEASURED], begins[-1], 200 * MEASURED))
    period = float(begins[-1] - begins[-1 - MEASURED]) / MEASURED
    return 0.5 * float(np.ptp(difference)) / run.loop.half_gap, 2.0 * math.pi / period


def comparison_table(comparisons: tuple[Comparison, ...]) -> str:
    """Return the cases as a table: amplitude over half of the gap and frequency, and the describing function's errors."""
    lines = [f"{'case':<48} {'shooting':>18} {'simulation':>18} {'describing function':>20} {'error':>16}  validity"]
    for row in comparisons:
        exact = f"{row.orbit.ratio:8.4f} {row.orbit.frequency:7.2f}/s" if row.orbit else "none"
        simulated = f"{row.simulated_ratio:8.4f} {row.simulated_frequency:7.2f}/s" if row.simulated_ratio else "at rest"
        predicted = f"{row.predicted.ratio:8.4f} {row.predicted.frequency:7.2f}/s" if row.predicted else "none"
        off = f"{100.0 * row.amplitude_error:+6.1f} {100.0 * row.frequency_error:+6.1f} %" if row.orbit and row.predicted else ""
        validity = row.predicted.validity.split(":")[0] if row.predicted else ""
        lines.append(f"{row.case.name:<48} {exact:>18} {simulated:>18} {predicted:>20} {off:>16}  {validity}")
    return "\n".join(lines)
