"""Backlash observed from the motor alone: a bank of extended Kalman filters of a two-inertia drive, each for another gap.

The state of a filter is (p, v, q, w, g, a, b, f): position and velocity of the motor and of the load, the total gap, and the relative
errors of the model's torque, load inertia and load friction. The covariance is the upper triangle, 36 numbers row by row. Lengths are at
the table.

The twist of the shaft has a standard deviation s. Its force is therefore the mean of the dead zone over a normal distribution,
K s (phi(z) + z Phi(z)) for each flank, with slope K Phi(z); the variance that the slope does not explain counts as correlated noise.
Friction stops a mass if it can take up its speed within a sub-step: the same dead zone, of speed.
"""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np

from contourlab.components.contract import Component, param
from contourlab.engine.step import Bank, Port, Step, ports
from contourlab.errors import ParameterError
from contourlab.primitives import clip, dot, exp, fabs, lincomb, log, maximum, minimum, scale, select, sqrt

N_STATE = 8
N_COVARIANCE = 36
ROWS = tuple(tuple(sum(range(8, 8 - min(i, j), -1)) + abs(i - j) for j in range(8)) for i in range(8))
"""Where the entries of each row of a covariance are in its upper triangle."""
CORRELATION = 1e-3
"""Correlation time of unmodelled forces [s]."""
TAIL = 2.5
"""Distance from a flank, in deviations, beyond which the flank is ignored: the gap's distribution reaches below zero there."""
SURPRISE = 25.0
"""Limit of the squared deviations of one reading: an outlier must not decide."""

Vector = tuple[float, ...]


def normal_law(z: float) -> tuple[float, float]:
    """Return density and distribution of the standard normal law (Abramowitz & Stegun 26.2.17, to 7.5e-8)."""
    density = 0.3989422804014327 * exp(-0.5 * z * z)
    t = 1.0 / (1.0 + 0.2316419 * fabs(z))
    tail = density * t * (0.319381530 + t * (-0.356563782 + t * (1.781477937 + t * (-1.821255978 + t * 1.330274429))))
    return density, select(z > 0.0, 1.0 - tail, tail)


def _flank(x: float, s: float, tail: float) -> tuple[float, float, float]:
    """Return mean of max(x + s n, 0) over the normal distribution, its slope, and the residual variance; zeros beyond `tail`."""
    z = x / s
    density, below = normal_law(z)
    mean = maximum(density + z * below, 0.0)
    square = (z * z + 1.0) * below + z * density
    # Far inside the contact the difference is rounding alone.
    rest = select(z < 6.0, maximum(square - mean * mean - below * below, 0.0), 0.0)
    near = select(z > -tail, 1.0, 0.0)
    return near * s * mean, near * below, near * s * s * rest


def _rubbed(speed: float, threshold: float, s: float) -> tuple[float, float, float, float]:
    """Return the mean speed after friction, its slopes in speed and threshold, and the residual variance.

    Friction stops speeds within `threshold`, so that sticking is exact.
    """
    ahead, in_ahead, rest_ahead = _flank(speed - threshold, s, 40.0)
    behind, in_behind, rest_behind = _flank(-speed - threshold, s, 40.0)
    # The two exclude each other, so they are not independent; without friction they cancel.
    both = 2.0 * (ahead * behind - s * s * in_ahead * in_behind)
    return ahead - behind, in_ahead + in_behind, in_behind - in_ahead, maximum(rest_ahead + rest_behind + both, 0.0)


def touching(x: Vector, c: Vector) -> tuple[float, float, float]:
    """Return twist p - q, and its standard deviation against the forward and the backward flank."""
    twist = c[0] + c[15] - 2.0 * c[2] + 0.25 * c[26]
    tilt = c[4] - c[17]
    # A picometre keeps the quotient finite when the covariance is zero.
    return x[0] - x[2], sqrt(maximum(twist - tilt, 0.0) + 1e-24), sqrt(maximum(twist + tilt, 0.0) + 1e-24)


def started(place: float, speed: float, gap: float, gap_deviation: float, noise: float, dt: float) -> tuple[Vector, Vector]:
    """Return mean and covariance from two encoder readings: load anywhere in the gap at the motor's speed, no model error."""
    slope, square = noise / dt, 2.0 * noise / (dt * dt)
    first = (noise, slope, 0.0, slope, 0.0, 0.0, 0.0, 0.0)
    motor = (square, 0.0, square, 0.0, 0.0, 0.0, 0.0)
    load = (0.25 * gap * gap, 0.0, 0.0, 0.0, 0.0, 0.0, square + 1e-10, 0.0, 0.0, 0.0, 0.0)
    others = (gap_deviation * gap_deviation, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    return (place, speed, place, speed, gap, 0.0, 0.0, 0.0), (*first, *motor, *load, *others)


def restarted(x: Vector, c: Vector, side: float, gap: float, gap_deviation: float, part: float, keep: float) -> tuple[Vector, Vector]:
    """Return mean and covariance of a filter for another gap, from a filter in contact at a flank (`side` 1 or -1).

    Both share the position of that flank, q + side g/2, and all motion. `keep` is 1 to share the model errors too, or 0 to reset them to
    zero with standard deviation `part`.
    """
    p, v, q, w, g, a, b, f = x
    pp, pv, pq, pw, pg, pa, pb, pf, vv, vq, vw, vg, va, vb, vf = c[:15]
    qq, qw, qg, qa, qb, qf, ww, wg, wa, wb, wf = c[15:26]
    gg, ga, gb, gf, aa, ab, af, bb, bf, ff = c[26:]
    h, spread, fresh = 0.5 * side, gap_deviation * gap_deviation, (1.0 - keep) * part * part
    flank = maximum(qq + 2.0 * h * qg + h * h * gg, 0.0)
    mean = (p, v, q + h * (g - gap), w, gap, keep * a, keep * b, keep * f)
    first = (pp, pv, pq + h * pg, pw, 0.0, keep * pa, keep * pb, keep * pf)
    motor = (vv, vq + h * vg, vw, 0.0, keep * va, keep * vb, keep * vf)
    load = (flank + h * h * spread, qw + h * wg, -h * spread, keep * (qa + h * ga), keep * (qb + h * gb), keep * (qf + h * gf))
    others = (keep * aa + fresh, keep * ab, keep * af, keep * bb + fresh, keep * bf, keep * ff + fresh)
    return mean, (*first, *motor, *load, ww, 0.0, keep * wa, keep * wb, keep * wf, spread, 0.0, 0.0, 0.0, *others)


def advance(par: Any, x: Vector, c: Vector, command: float, dt: float) -> tuple[Vector, Vector]:
    """Return mean and covariance a sub-step later: half a drift, a kick by the forces, half a drift (second order, symplectic)."""
    x, c = _drifted(x, 0.5 * dt), _drift(c, 0.5 * dt)
    p, v, q, w, g, a, b, f = x
    shaft, k, d, k_gap, rest = _shaft(par, x, c)
    m, n = dt * par.motor_mobility, dt * par.load_mobility / (1.0 + b)
    torque = par.force_value * command
    free = v + m * ((1.0 + a) * torque - par.motor_drag * v - shaft)
    v, keeps, _, rest_motor = _rubbed(free, m * par.motor_coulomb, sqrt(maximum(c[8], 0.0) + 1e-24))
    m = keeps * m
    of_motor = (-m * k, keeps - m * (d + par.motor_drag), m * k, m * d, -m * k_gap, m * torque, 0.0, 0.0)
    drag = (1.0 + f) * par.load_drag
    push, threshold = n * (shaft - drag * w), n * (1.0 + f) * par.coulomb
    left, keeps, stops, rest_load = _rubbed(w + push, threshold, sqrt(maximum(c[21], 0.0) + 1e-24))
    # Derivatives of the speed by inverse inertia and by friction.
    lighter, rubs = keeps * push + stops * threshold, n * (stops * par.coulomb - keeps * par.load_drag * w)
    n = keeps * n
    of_load = (n * k, n * d, -n * k, keeps - n * (d + drag), n * k_gap, 0.0, -lighter / (1.0 + b), rubs)
    # Friction also holds masses that stick against noise forces.
    shaken, other = rest * maximum(CORRELATION / dt, 1.0), par.force_noise / dt
    noise = (m * m * (shaken + other) + rest_motor, -m * n * shaken, n * n * (shaken + other) + rest_load)
    c = _kick(c, of_motor, of_load, noise)
    return _drifted((p, v, q, left, g, a, b, f), 0.5 * dt), _drift(c, 0.5 * dt)


def _shaft(par: Any, x: Vector, c: Vector) -> tuple[float, float, float, float, float]:
    """Return mean force of the shaft, its slopes in twist, twist rate and gap, and the residual variance."""
    twist, s_forward, s_backward = touching(x, c)
    ahead, in_ahead, rest_ahead = _flank(twist - 0.5 * x[4], s_forward, TAIL)
    behind, in_behind, rest_behind = _flank(-twist - 0.5 * x[4], s_backward, TAIL)
    # Contact at one flank excludes the other, even while the gap is hardly known.
    one, other = 1.0 - in_behind, 1.0 - in_ahead
    k, d = par.stiffness_value, par.damper_value * (one * in_ahead + other * in_behind)
    force = k * (one * ahead - other * behind) + d * (x[1] - x[3])
    slope, tilt = k * (one * in_ahead + other * in_behind), 0.5 * k * (other * in_behind - one * in_ahead)
    return force, slope, d, tilt, k * k * (one * rest_ahead + other * rest_behind)


def _drifted(x: Vector, dt: float) -> Vector:
    p, v, q, w, g, a, b, f = x
    return p + dt * v, v, q + dt * w, w, g, a, b, f


def _drift(c: Vector, dt: float) -> Vector:
    """Return the covariance after p += dt v, q += dt w."""
    pp, pv, pq, pw, _, _, _, _, vv, vq, vw, _, _, _, _, qq, qw, _, _, _, _, ww = c[:22]
    first = (pp + dt * (2.0 * pv + dt * vv), pv + dt * vv, pq + dt * (pw + vq + dt * vw), pw + dt * vw)
    load = (qq + dt * (2.0 * qw + dt * ww), qw + dt * ww)
    # The last four are covariances with gap and model errors.
    of_motor, of_load = (tuple(c[i] + dt * c[i + ahead] for i in range(start, start + 4)) for start, ahead in ((4, 7), (17, 5)))
    return (*first, *of_motor, vv, vq + dt * vw, *c[10:15], *load, *of_load, *c[21:])


def _kick(c: Vector, m: Vector, n: Vector, noise: Vector) -> Vector:
    """Return the covariance after v and w became the linear forms `m` and `n` of the state."""
    v, w = (tuple(dot(form, tuple(c[i] for i in row)) for row in ROWS) for form in (m, n))
    motor = (dot(m, v) + noise[0], v[2], dot(n, v) + noise[1], *v[4:])
    load = (c[15], w[2], *c[17:21], dot(n, w) + noise[2], *w[4:])
    return (c[0], v[0], c[2], w[0], *c[4:8], *motor, *load, *c[26:])


def corrected(par: Any, x: Vector, c: Vector, measured: float) -> tuple[Vector, Vector, float, float]:
    """Return mean and covariance after an encoder reading, its log-likelihood, and its squared deviations."""
    inverse = 1.0 / (maximum(c[0], 0.0) + par.encoder_noise)
    error = measured - x[0]
    gain = tuple(inverse * c[j] for j in range(N_STATE))
    moved = tuple(x[j] + gain[j] * error for j in range(N_STATE))
    # At most five deviations, so that no wrong gap makes an inertia negative.
    most = 5.0 * par.uncertainty
    mean = (*moved[:4], clip(moved[4], 0.0, 4.0 * par.largest_gap), *(clip(part, -most, most) for part in moved[5:]))
    left = tuple(tuple(c[ROWS[i][j]] - gain[i] * c[j] for j in range(i, N_STATE)) for i in range(N_STATE))
    covariance = tuple(entry for row in left for entry in (maximum(row[0], 0.0), *row[1:]))
    surprise = minimum(inverse * error * error, SURPRISE)
    return mean, covariance, 0.5 * (log(inverse) - surprise), surprise


def sane(x: Vector, c: Vector) -> float:
    """Return 1, or 0 for a filter that has diverged."""
    size = maximum(maximum(fabs(x[2] - x[0]), 1e-4 * fabs(x[1])), 1e-4 * fabs(x[3]))
    spread = maximum(maximum(c[0], c[15]), 1e-8 * maximum(c[8], c[21]))
    return select(maximum(size, spread) < 1.0, 1.0, 0.0)


def flanks(x: Vector, c: Vector) -> tuple[float, float]:
    """Return the probabilities of contact at the flank that drives forwards, and at the other."""
    twist, s_forward, s_backward = touching(x, c)
    _, ahead = normal_law((twist - 0.5 * x[4]) / s_forward)
    _, behind = normal_law((-twist - 0.5 * x[4]) / s_backward)
    return ahead, behind


def faded(par: Any, x: Vector, c: Vector) -> Vector:
    """Return the covariance after forgetting a little of gap and model errors; the position of the touched flank stays known."""
    qq, qw, qg, qa, qb, qf, ww, wg, wa, wb, wf, gg, ga, gb, gf, aa, ab, af, bb, bf, ff = c[15:]
    ahead, behind = flanks(x, c)
    rate, part, half = 2.0 * par.fading, par.uncertainty * par.uncertainty, 0.5 * (ahead - behind)
    first = par.spacing * x[4] + par.resolution
    more = rate * maximum(gg * (1.0 - gg / (first * first)), 0.0)
    load = (qq + half * half * more, qw, qg - half * more, qa, qb, qf, ww, wg, wa, wb, wf)
    gap = (gg + more, ga, gb, gf)
    torque, inertia = aa + rate * maximum(part - aa, 0.0), bb + rate * maximum(part - bb, 0.0)
    return (*c[:15], *load, *gap, torque, ab, af, inertia, bf, ff + rate * maximum(part - ff, 0.0))


SCORE = N_STATE + N_COVARIANCE
"""Index of a filter's log weight, after mean and covariance."""
MODEL_ERROR = 0.01
"""Least deviation as a share of the gap: the accuracy of sub-steps and linearisation."""
MISFIT = SCORE + 1
"""Index of its mean squared deviation: at most 1 while the model holds."""
KEPT = MISFIT + 1
"""Length of a filter's memory."""
N_MOMENTS = 7
"""Sums of the mixture: weight, gap, squared gap, position and velocity of the load, forward and backward flank."""
MISFITTING = 2.0
"""Mean squared deviation of the leading filter above which the observer starts over."""
JUDGED = 0.5
"""Averaging time of that mean [s]."""
DOUBTED = 5.0
"""Time without trust after a gap outside the initial range [s]."""
SETTLED = 0.03
"""Unbroken contact after which a flank is known [s]: a few periods of a rebounding shaft."""
LOST = 50.0
"""Log weight below the leading filter at which a filter restarts."""
SURE = 0.999
"""Probability from which contact is certain."""


class MultipleModel(Component):
    """Gap state and gap size from motor position and command: a Gaussian sum of extended Kalman filters of the two-inertia drive.

    The `hypotheses` start from gaps at equal ratios between `smallest_gap` and `largest_gap`. Each filter estimates motor, load, gap, and
    the relative errors of torque, load inertia and load friction (`uncertainty` is one standard deviation). The shaft force K dz(p_m - p_l,
    gap/2) is averaged over the unknown part of the twist (statistical linearisation); the residual counts as noise. A motor that moves on
    without resistance widens the estimated gap, a contact ends it. Weights follow how well a filter predicts the encoder; gap, deviation
    and load are those of the mixture.

    The gap is the initial guess until the first unbroken contact. Then all filters restart from the touched flank; the deviation stays wide
    until the other flank is touched. A filter that has lost almost all its weight restarts from the leading one. If the leading filter
    predicts the encoder badly, the observer starts over. If its gap leaves the range from `smallest_gap` to `largest_gap`, the output is
    the initial guess for a while, and then the observer starts over. Knowledge fades over `memory`.

    `confidence` is the probability of the reported gap state, times that of a gap within `tolerance` of the reported one; half of that
    while the gap is the initial guess.

    Valid for a two-inertia drive that moves across its gap. Choose `substeps` so that the shaft's oscillation advances by less than
    0.25 rad in each, sqrt(K (1/M_m + 1/M_l)) T/substeps, and `hypotheses` so that neighbouring gaps differ by at most 15 %: a filter that
    drifts far from its initial gap before it meets the flank becomes confident too early.

    References
    ----------
    Alspach & Sorenson, "Nonlinear Bayesian estimation using Gaussian sum approximations", IEEE Trans. Automatic Control 17 (1972);
    Lagerberg & Egardt, "Backlash estimation with application to automotive powertrains", IEEE Trans. Control Systems Technology 15 (2007),
    for Kalman filters of gap size and state; here contact has a probability, and only the motor is measured.
    """

    family = "gap_observer"
    kind = "multiple-model"
    reference = "Alspach & Sorenson 1972; Lagerberg & Egardt 2007"
    inputs = (Port("motor_position"), Port("applied"))
    states = (*ports("ticks", "last_position", "contact", "sound", "side", "settled", "again", "doubt"), Port("leader", KEPT))
    derived = (
        *("force_value", "motor_mobility", "motor_drag", "load_mobility", "stiffness_value", "damper_value", "load_drag"),
        *("encoder_noise", "force_noise", "spread", "fading", "spacing", "judging", "first_gap", "first_deviation"),
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

    motor_inertia: float = param(unit="kg*m^2", minimum=0.0, exclusive=True, display="kg*cm^2", doc="inertia of motor and coupling, J_m")
    load_inertia: float = param(
        default=0.0, unit="kg*m^2", minimum=0.0, display="kg*cm^2", doc="inertia of the load at the shaft, J_l, without `mass`"
    )
    mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="mass of the table and everything on it")
    lead: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel per turn of the screw, l")
    stiffness: float = param(unit="N*m/rad", minimum=0.0, exclusive=True, doc="stiffness of shaft, coupling and nut, k_s")
    shaft_damping: float = param(default=0.0, unit="N*m*s/rad", minimum=0.0, doc="damping of shaft, coupling and nut, d_s")
    motor_damping: float = param(default=0.0, unit="N*m*s/rad", minimum=0.0, doc="viscous damping on the motor side, c_m")
    load_damping: float = param(default=0.0, unit="N*m*s/rad", minimum=0.0, doc="viscous damping on the load side, c_l")
    coulomb: float = param(default=0.0, unit="N", minimum=0.0, doc="Coulomb friction of the guides")
    motor_coulomb: float = param(default=0.0, unit="N", minimum=0.0, doc="Coulomb friction of the motor, at the table")
    torque_gain: float = param(default=1.0, minimum=0.0, exclusive=True, doc="torque per commanded torque, g")
    uncertainty: float = param(default=0.03, minimum=1e-4, maximum=0.15, doc="relative deviation of torque, load inertia and friction")
    resolution: float = param(default=0.125e-6, unit="m", minimum=0.0, exclusive=True, display="um", doc="encoder resolution at the table")
    unmodelled_force: float = param(
        default=1.0, unit="N", minimum=0.0, exclusive=True, doc="standard deviation of the unmodelled force over 1 ms, on each side"
    )
    smallest_gap: float = param(default=5e-6, unit="m", minimum=0.0, exclusive=True, display="um", doc="smallest initial gap")
    largest_gap: float = param(default=150e-6, unit="m", minimum=0.0, exclusive=True, display="um", doc="largest initial gap")
    tolerance: float = param(default=0.25, minimum=0.0, maximum=1.0, exclusive=True, doc="relative gap error that `confidence` refers to")
    memory: float = param(default=60.0, unit="s", minimum=0.0, exclusive=True, doc="time constant of forgetting")
    hypotheses: float = param(default=32.0, minimum=2.0, maximum=64.0, whole=True, structural=True, doc="number of filters")
    substeps: float = param(default=2.0, minimum=1.0, maximum=32.0, whole=True, structural=True, doc="integration steps per servo period")

    def check_values(self) -> None:
        if np.any(self.load_inertia + self.mass <= 0.0):
            raise ParameterError("load_inertia", "0", "> 0 unless a mass is given", "kg*m^2")
        if np.any(self.largest_gap <= self.smallest_gap):
            raise ParameterError("largest_gap", f"{self.largest_gap:g}", f"> smallest_gap = {self.smallest_gap:g}", "m")

    def make_step(self, n_axis: int = 1) -> Step:
        """Return the step, with one filter for each hypothesis."""
        bank = Bank(_follower(int(self.substeps)), int(self.hypotheses), KEPT, KEPT + N_MOMENTS)
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
        # Half the distance to the next gap.
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
            # Twice the variance of rounding: at low speed successive errors are correlated.
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
        """Return the filter after a tick, the leading filter so far, and the sums of the mixture so far."""
        guess = par.smallest_gap * exp(index * par.spread)
        # The score counts from that of the leading filter, limited below.
        counted = (*kept[:SCORE], maximum(kept[SCORE] - x.leader[SCORE], -10.0 * LOST), kept[MISFIT])
        begun = _renewed(par, counted, x, guess)
        # Two readings give position and speed of the motor; the filters run from the third on.
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
        now = (*_mixed(going, mean, fresh), *_mixed(going, c, wide), score, misfit)
        return now, _joined(now, found, index)

    return follow


def _mixed(part: float, one: Any, other: Any) -> Any:
    return lincomb(part, one, 1.0 - part, other)


def _joined(kept: Any, found: Any, index: float) -> Any:
    """Return the leading filter so far, and the sums of the mixture with weights relative to it."""
    leader, total = found[:KEPT], found[KEPT:]
    behind = select(index > 0.0, leader[SCORE] - kept[SCORE], -10.0 * LOST)
    better = select(behind < 0.0, 1.0, 0.0)
    weights = exp(minimum(behind, 0.0)), exp(minimum(-behind, 0.0))
    return *_mixed(better, kept, leader), *lincomb(weights[0], total, weights[1], _moments(kept))


def _judge(par: Any, x: Any, inp: Any, clock: Any, found: Any) -> Any:
    """Return states and outputs after all filters have run."""
    leader, total = found[:KEPT], found[KEPT:]
    side = _side(leader)
    contact, sound, settled, again = _waited(x, side, leader, clock.dt)
    doubt = _doubt(par, x, leader[4], settled, clock.dt)
    # Start over when doubt ends.
    again = maximum(again, select(x.doubt > 0.0, 1.0, 0.0) * select(doubt > 0.0, 0.0, 1.0))
    states = minimum(x.ticks + 1.0, 2.0), inp.motor_position, contact * (1.0 - again), sound, side, settled, again, doubt, leader
    return states, _outputs(par, total, select(doubt > 0.0, 0.0, x.sound))


def _side(leader: Any) -> float:
    """Return the flank that a filter certainly touches, or 0."""
    ahead, behind = flanks(leader[:N_STATE], leader[N_STATE:SCORE])
    return select(ahead > SURE, 1.0, select(behind > SURE, -1.0, 0.0))


def _doubt(par: Any, x: Any, gap: float, settled: float, dt: float) -> float:
    """Return the remaining time without trust [s], started by a gap outside the initial range; it ends only at a flank."""
    left = select(x.doubt > 0.0, maximum(x.doubt - dt, dt * (1.0 - settled)), 0.0)
    low, high = par.smallest_gap * (1.0 - par.spacing), par.largest_gap * (1.0 + par.spacing)
    return select(gap > high, DOUBTED, select(gap < low, DOUBTED, left))


def _waited(x: Any, side: float, leader: Any, dt: float) -> tuple[float, float, float, float]:
    """Return duration of contact, whether a flank was ever known, whether one is known now, and whether to start over from it."""
    contact = select(side == 0.0, 0.0, minimum(x.contact + dt, SETTLED))
    settled = select(contact >= SETTLED, 1.0, 0.0)
    again = settled * select(leader[MISFIT] > MISFITTING, 1.0, 1.0 - x.sound)
    return contact * (1.0 - again), maximum(again, x.sound), settled, again


def _renewed(par: Any, kept: Any, x: Any, guess: float) -> Any:
    """Return a filter, restarted from the leading one if it has lost its weight or all start over."""
    lost = select(kept[SCORE] < -LOST, x.settled, 0.0)
    mean, c = x.leader[:N_STATE], x.leader[N_STATE:SCORE]
    mean, c = restarted(mean, c, x.side, guess, par.spacing * guess, par.uncertainty, 1.0 - x.again)
    misfit = x.again + (1.0 - x.again) * x.leader[MISFIT]
    return _mixed(maximum(lost, x.again), (*mean, *c, -0.5 * LOST * (1.0 - x.again), misfit), kept)


def _moments(kept: Any) -> Any:
    """Return the moments of a filter, for unit weight."""
    mean, c = kept[:N_STATE], kept[N_STATE:SCORE]
    ahead, behind = flanks(mean, c)
    return 1.0, mean[4], mean[4] * mean[4] + maximum(c[26], 0.0), mean[2], mean[3], ahead, behind


def _outputs(par: Any, total: Any, sound: float) -> Any:
    """Return the outputs from the sums of the mixture."""
    _, gap, square, position, velocity, ahead, behind = scale(1.0 / total[0], total)
    deviation = sqrt(maximum(square - gap * gap, 0.0) + (MODEL_ERROR * gap) * (MODEL_ERROR * gap))
    gap, deviation = select(sound > 0.0, gap, par.first_gap), select(sound > 0.0, deviation, par.first_deviation)
    state = select(ahead > 0.5, 1.0, select(behind > 0.5, -1.0, 0.0))
    sure = select(state > 0.0, ahead, select(state < 0.0, behind, 1.0 - ahead - behind))
    # A picometre avoids a division by zero for a gap known to be zero.
    _, within = normal_law(par.tolerance * gap / (deviation + 1e-12))
    # An initial guess is never trusted, however close the hypotheses are.
    confidence = (0.5 + 0.5 * sound) * clip(sure, 0.0, 1.0) * clip(2.0 * within - 1.0, 0.0, 1.0)
    return state, gap, deviation, confidence, position, velocity
