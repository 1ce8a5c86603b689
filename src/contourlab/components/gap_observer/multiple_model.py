"""Backlash seen from the motor alone: a bank of Kalman filters, each with a guess of the gap of its own."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np

from contourlab.components.contract import Component, param
from contourlab.components.gap_observer.load_filter import (
    CORRELATION,
    N_COVARIANCE,
    N_STATE,
    advance,
    corrected,
    faded,
    flanks,
    normal_law,
    restarted,
    sane,
    started,
)
from contourlab.engine.step import Bank, Port, Step, ports
from contourlab.errors import ParameterError
from contourlab.primitives import clip, exp, lincomb, maximum, minimum, scale, select, sqrt

SCORE = N_STATE + N_COVARIANCE
"""Where a filter keeps the logarithm of its weight, behind mean and covariance."""
MODEL_ERROR = 0.01
"""Part of the gap that the deviation never falls below: sub-steps and linearisation are no better."""
MISFIT = SCORE + 1
"""Behind that, the mean of its squared deviations: 1 or less where the model holds."""
KEPT = MISFIT + 1
"""Numbers that a filter keeps."""
N_MOMENTS = 7
"""Sums of the mixture: weight, gap, its square, place and speed of the load, either flank."""
MISFITTING = 2.0
"""Mean of the leading filter's squared deviations at which nothing that was learnt is kept."""
JUDGED = 0.5
"""Seconds over which that mean is taken."""
DOUBTED = 5.0
"""Seconds for which nothing is believed once a gap was met that is none of those guessed."""
SETTLED = 0.03
"""Seconds of contact without a break after which a flank is known: a few periods of a shaft that rebounds."""
LOST = 50.0
"""Nats behind the best filter at which one has lost its way: e**-50 of its weight."""
SURE = 0.999
"""Probability of contact from which a flank is taken for certain."""


class MultipleModel(Component):
    """Gap state and gap size from motor position and command: a Gaussian sum of extended Kalman filters of the two-inertia drive.

    Each of the `hypotheses` starts from a gap of its own, spaced by one ratio from `smallest_gap` to `largest_gap`, and follows motor and
    load, the gap, and how far torque, load inertia and load friction are off (each by `uncertainty`, one standard deviation) in one state
    of eight with its covariance. The force of the shaft is K dz(p_m - p_l, gap/2) averaged over what the filter does not know of its twist
    (statistical linearisation), so that a motor that moves on without a load's resistance widens the gap, and a contact ends it; what the
    average leaves out is counted as noise. Guesses are weighed by how well they foretold each encoder reading; gap, deviation and the load
    are those of the mixture.

    Until contact has lasted without a break once, the gap is what it was guessed; from there all filters start from the flank that is
    touched. The deviation is wide until the other flank has been touched as well. Filters that have lost their way start again beside the
    leading one; where the leading one fails to foretell the encoder, all that was learnt is dropped. `confidence` is the probability that
    the gap state is what it says, times that of a gap within `tolerance` of the one it says; half of that where the gap is merely guessed.
    What was learnt fades over `memory`. When the leading filter is led above `largest_gap` or below `smallest_gap`, the guesses alone are
    told for a while, then all starts anew.

    Valid where the drive is the two-inertia one and moves across its gap. Choose `substeps` so that the shaft turns less than 0.25 rad of
    its oscillation in each, sqrt(K (1/M_m + 1/M_l)) T/substeps, and `hypotheses` so that guesses differ by 15 % at most: a filter that is
    led far beyond its guess before it meets the flank trusts itself too early.

    References
    ----------
    Alspach & Sorenson, "Nonlinear Bayesian estimation using Gaussian sum approximations", IEEE Trans. Automatic Control 17 (1972);
    Lagerberg & Egardt, "Backlash estimation with application to automotive powertrains", IEEE Trans. Control Systems Technology 15 (2007),
    for Kalman filters of gap size and state; here contact is a matter of probability, and the motor's side alone is measured.
    """

    family = "gap_observer"
    kind = "multiple-model"
    reference = "Alspach & Sorenson 1972; Lagerberg & Egardt 2007"
    inputs = (Port("motor_position"), Port("applied"))
    outputs = ports("gap_state", "gap", "gap_deviation", "confidence", "load_position", "load_velocity")
    states = (*ports("ticks", "last_position", "contact", "sound", "side", "settled", "again", "doubt"), Port("leader", KEPT))
    derived = (
        "force_value",
        "motor_mobility",
        "motor_drag",
        "load_mobility",
        "stiffness_value",
        "damper_value",
        "load_drag",
        "encoder_noise",
        "force_noise",
        "spread",
        "fading",
        "spacing",
        "judging",
        "first_gap",
        "first_deviation",
    )
    example = {
        "motor_inertia": 5.2e-3,
        "load_inertia": 4.4e-3,
        "mass": 30.0,
        "lead": 0.016,
        "stiffness": 950.0,
        "shaft_damping": 0.1,
        "motor_damping": 2e-3,
        "load_damping": 3e-3,
        "coulomb": 40.0,
        "motor_coulomb": 5.0,
        "torque_gain": 0.9,
        "resolution": 1e-3,
        "smallest_gap": 1e-3,
        "largest_gap": 10e-3,
        "unmodelled_force": 200.0,
        "memory": 1.0,
        "hypotheses": 3.0,
        "substeps": 1.0,
    }

    motor_inertia: float = param(unit="kg*m^2", minimum=0.0, exclusive=True, display="kg*cm^2", doc="of all that turns with the motor, J_m")
    load_inertia: float = param(
        default=0.0, unit="kg*m^2", minimum=0.0, display="kg*cm^2", doc="of the load at the shaft, J_l; `mass` comes on top"
    )
    mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="of the table and all that it carries")
    lead: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel per turn of the screw, l")
    stiffness: float = param(unit="N*m/rad", minimum=0.0, exclusive=True, doc="of shaft, coupling and nut, k_s")
    shaft_damping: float = param(default=0.0, unit="N*m*s/rad", minimum=0.0, doc="of the same, d_s")
    motor_damping: float = param(default=0.0, unit="N*m*s/rad", minimum=0.0, doc="viscous, on the motor's side, c_m")
    load_damping: float = param(default=0.0, unit="N*m*s/rad", minimum=0.0, doc="viscous, on the load's side, c_l")
    coulomb: float = param(default=0.0, unit="N", minimum=0.0, doc="friction of the guides, whatever the speed")
    motor_coulomb: float = param(default=0.0, unit="N", minimum=0.0, doc="the same on the motor's side, at the table")
    torque_gain: float = param(default=1.0, minimum=0.0, exclusive=True, doc="torque that comes per torque that was asked for, g")
    uncertainty: float = param(
        default=0.03, minimum=1e-4, maximum=0.15, doc="relative standard deviation of torque, load inertia and friction"
    )
    resolution: float = param(default=0.125e-6, unit="m", minimum=0.0, exclusive=True, display="um", doc="of the encoder, at the table")
    unmodelled_force: float = param(default=1.0, unit="N", minimum=0.0, exclusive=True, doc="standard deviation over 1 ms, either side")
    smallest_gap: float = param(default=5e-6, unit="m", minimum=0.0, exclusive=True, display="um", doc="of the first guess")
    largest_gap: float = param(default=150e-6, unit="m", minimum=0.0, exclusive=True, display="um", doc="of the last guess")
    tolerance: float = param(default=0.25, minimum=0.0, maximum=1.0, exclusive=True, doc="error of the gap that `confidence` allows for")
    memory: float = param(default=60.0, unit="s", minimum=0.0, exclusive=True, doc="over which what was learnt fades")
    hypotheses: float = param(default=32.0, minimum=2.0, maximum=64.0, whole=True, structural=True, doc="guesses of the gap")
    substeps: float = param(default=2.0, minimum=1.0, maximum=32.0, whole=True, structural=True, doc="of the model in a servo period")

    def __init__(self, **values: Any) -> None:
        super().__init__(**values)
        if not self.load_inertia + self.mass > 0.0:
            raise ParameterError("load_inertia", "0", "> 0, or a mass given", "kg*m^2")
        if not self.largest_gap > self.smallest_gap:
            raise ParameterError("largest_gap", f"{self.largest_gap:g}", f"> smallest_gap = {self.smallest_gap:g}", "m")

    def make_step(self, n_axis: int = 1) -> Step:
        """Return the step, whose bank has as many filters as there are hypotheses."""
        follow = _follower(int(self.substeps))
        bank = Bank(follow, int(self.hypotheses), KEPT, KEPT + N_MOMENTS)
        parameters = (*self.numeric(), *self.derived)
        states = (*self.states, bank.port)
        return Step(f"{self.family}/{self.kind}", _judge, parameters, (), "", states, self.inputs, self.outputs, bank)

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        turn = 2.0 * math.pi / par.lead
        square = turn * turn
        motor, load = par.motor_inertia * square, par.load_inertia * square + par.mass
        n = int(self.hypotheses)
        spread = np.log(par.largest_gap / par.smallest_gap) / (n - 1)
        ratio = np.exp(spread)
        # Half the way to the next guess.
        spacing = 0.5 * (ratio - 1.0)
        first = sum(par.smallest_gap * ratio**i for i in range(n)) / n
        square_of_first = (1.0 + spacing * spacing) * sum((par.smallest_gap * ratio**i) ** 2 for i in range(n)) / n
        return (
            par.torque_gain * turn,
            1.0 / motor,
            par.motor_damping * square,
            1.0 / load,
            par.stiffness * square,
            par.shaft_damping * square,
            par.load_damping * square,
            # Twice that of even rounding: at low speed successive errors are alike.
            par.resolution * par.resolution / 6.0,
            2.0 * CORRELATION * par.unmodelled_force * par.unmodelled_force,
            spread,
            np.minimum(dt / par.memory, 0.5),
            spacing,
            min(dt / JUDGED, 0.5),
            first,
            np.sqrt(square_of_first - first * first),
        )


@cache
def _follower(substeps: int) -> Any:
    def follow(par: Any, x: Any, kept: Any, found: Any, index: float, inp: Any, clock: Any) -> Any:
        """Return a filter a tick later, and with it the leading one and the moments of those up to it."""
        guess = par.smallest_gap * exp(index * par.spread)
        begun = _renewed(par, _counted(kept, x.leader), x, guess)
        # Two readings tell where the motor is and how fast; the filters run from the third.
        running, speed = maximum(x.ticks - 1.0, 0.0), minimum(x.ticks, 1.0) * (inp.motor_position - x.last_position) / clock.dt
        fresh, wide = started(inp.motor_position, speed, guess, par.spacing * guess, par.encoder_noise, clock.dt)
        mean = _mixed(running, begun[:N_STATE], fresh)
        c = _mixed(running, begun[N_STATE:SCORE], wide)
        for _ in range(substeps):
            mean, c = advance(par, mean, c, inp.applied, clock.dt / substeps)
        mean, c, likeliness, surprise = corrected(par, mean, faded(par, mean, c), inp.motor_position)
        misfit = begun[MISFIT] + par.judging * (surprise - begun[MISFIT])
        going = sane(mean, c)
        score = (1.0 - par.fading) * begun[SCORE] + likeliness - 10.0 * LOST * (1.0 - going)
        now = _whole(_mixed(going, mean, fresh), _mixed(going, c, wide), score, misfit)
        return now, _joined(now, found, index)

    return follow


def _mixed(part: float, one: Any, other: Any) -> Any:
    return lincomb(part, one, 1.0 - part, other)


def _whole(mean: Any, c: Any, score: float, misfit: float) -> Any:
    return *mean, *c, score, misfit


def _counted(kept: Any, leader: Any) -> Any:
    """Return a filter with its score counted from the leading one's; far enough behind, it is no matter how far."""
    return *kept[:SCORE], maximum(kept[SCORE] - leader[SCORE], -10.0 * LOST), kept[MISFIT]


def _joined(kept: Any, found: Any, index: float) -> Any:
    """Return the leading one of the filters so far, and the sums of the mixture by weights that count from its score."""
    leader, total = found[:KEPT], found[KEPT:]
    behind = select(index > 0.0, leader[SCORE] - kept[SCORE], -10.0 * LOST)
    better = select(behind < 0.0, 1.0, 0.0)
    weights = exp(minimum(behind, 0.0)), exp(minimum(-behind, 0.0))
    return *_mixed(better, kept, leader), *lincomb(weights[0], total, weights[1], _moments(kept))


def _judge(par: Any, x: Any, inp: Any, clock: Any, found: Any) -> Any:
    """Return states and outputs once all filters have followed."""
    leader, total = found[:KEPT], found[KEPT:]
    side = _side(leader)
    contact, sound, settled, again = _waited(x, side, leader, clock.dt)
    doubt = _doubt(par, x, leader[4], settled, clock.dt)
    # Once doubt is over, what was learnt meanwhile is dropped.
    again = maximum(again, select(x.doubt > 0.0, 1.0, 0.0) * select(doubt > 0.0, 0.0, 1.0))
    states = minimum(x.ticks + 1.0, 2.0), inp.motor_position, contact * (1.0 - again), sound, side, settled, again, doubt, leader
    return states, _told(par, total, select(doubt > 0.0, 0.0, x.sound))


def _side(leader: Any) -> float:
    """Return the flank at which a filter surely is, or 0."""
    ahead, behind = flanks(leader[:N_STATE], leader[N_STATE:SCORE])
    return select(ahead > SURE, 1.0, select(behind > SURE, -1.0, 0.0))


def _doubt(par: Any, x: Any, gap: float, settled: float, dt: float) -> float:
    """Return for how long [s] nothing is to be believed, as the leading filter's gap is none that was guessed; over at a flank only."""
    left = select(x.doubt > 0.0, maximum(x.doubt - dt, dt * (1.0 - settled)), 0.0)
    low, high = par.smallest_gap * (1.0 - par.spacing), par.largest_gap * (1.0 + par.spacing)
    return select(gap > high, DOUBTED, select(gap < low, DOUBTED, left))


def _waited(x: Any, side: float, leader: Any, dt: float) -> tuple[float, float, float, float]:
    """Return how long contact has lasted, whether a flank has been known, whether one is now, and whether to start all over from it."""
    contact = select(side == 0.0, 0.0, minimum(x.contact + dt, SETTLED))
    settled = select(contact >= SETTLED, 1.0, 0.0)
    again = settled * select(leader[MISFIT] > MISFITTING, 1.0, 1.0 - x.sound)
    return contact * (1.0 - again), maximum(again, x.sound), settled, again


def _renewed(par: Any, kept: Any, x: Any, guess: float) -> Any:
    """Return a filter; started again beside the leading one where it has lost its way, or with all the others."""
    lost = select(kept[SCORE] < -LOST, x.settled, 0.0)
    mean, c = x.leader[:N_STATE], x.leader[N_STATE:SCORE]
    mean, c = restarted(mean, c, x.side, guess, par.spacing * guess, par.uncertainty, 1.0 - x.again)
    misfit = x.again + (1.0 - x.again) * x.leader[MISFIT]
    return _mixed(maximum(lost, x.again), (*mean, *c, -0.5 * LOST * (1.0 - x.again), misfit), kept)


def _moments(kept: Any) -> Any:
    """Return what a filter adds to the sums of the mixture, per weight."""
    mean, c = kept[:N_STATE], kept[N_STATE:SCORE]
    ahead, behind = flanks(mean, c)
    return 1.0, mean[4], mean[4] * mean[4] + maximum(c[26], 0.0), mean[2], mean[3], ahead, behind


def _told(par: Any, total: Any, sound: float) -> Any:
    """Return the outputs from the sums of the mixture."""
    _, gap, square, position, velocity, ahead, behind = scale(1.0 / total[0], total)
    deviation = sqrt(maximum(square - gap * gap, 0.0) + (MODEL_ERROR * gap) * (MODEL_ERROR * gap))
    gap, deviation = select(sound > 0.0, gap, par.first_gap), select(sound > 0.0, deviation, par.first_deviation)
    state = select(ahead > 0.5, 1.0, select(behind > 0.5, -1.0, 0.0))
    sure = select(state > 0.0, ahead, select(state < 0.0, behind, 1.0 - ahead - behind))
    # A picometre, as a gap that is known to be none is no division by zero.
    _, within = normal_law(par.tolerance * gap / (deviation + 1e-12))
    # A gap that is merely guessed is never to be trusted, however close the guesses lie together.
    confidence = (0.5 + 0.5 * sound) * clip(sure, 0.0, 1.0) * clip(2.0 * within - 1.0, 0.0, 1.0)
    return state, gap, deviation, confidence, position, velocity
