"""Ultimate gain and period of a loop from a relay experiment, and the gains that stated rules make of them.

A relay on the position error commands one of two levels +-d; the loop then oscillates where its phase is near -180 degrees. Fundamental
of the position over fundamental of the command is the response of the axis there, whatever the waveforms. The describing function
4 d/(pi a) takes the amplitude a instead, as if the position were a sine.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from scipy.optimize import brentq
from scipy.special import stdtrit

from contourlab.analysis.identification.first_order import identify_first_order
from contourlab.analysis.identification.least_squares import Bounds
from contourlab.arrays import Array, Complex, true_spans
from contourlab.errors import ParameterError, ResultError, refuse
from contourlab.findings import Finding, finding

LEAST = 8
"""Fewest steady cycles."""
STEADY = 0.3
"""Largest difference of the length and of the travel of a steady cycle from the median."""
DRIFT = 0.03
"""Largest change between the halves of the steady cycles, beside what their scatter explains."""
SAMPLES = 10
"""Fewest samples of a cycle."""
COUNTS = 10.0
"""Least travel of a cycle [counts]."""
FAR = 60.0
"""Farthest phase [deg] of an oscillation from -180 degrees."""
BENT = 1.2
"""Half of the interval for a bent phase, over the difference of a phase linear in the frequency from one linear in its logarithm."""
FELT = 0.05
"""Share from which friction and a steady load are reported."""
MISFIT = 0.3
"""Part of a friction's effect that its fit may miss."""
PHASE_MARGIN = math.radians(60.0)
_LEAD = (math.tan(PHASE_MARGIN) + math.sqrt(1.0 + math.tan(PHASE_MARGIN) ** 2)) / (4.0 * math.pi)
RULES = {
    "Ziegler-Nichols P": (0.5, math.inf, 0.0),
    "Ziegler-Nichols PI": (0.45, 1.0 / 1.2, 0.0),
    "Tyreus-Luyben PI": (1.0 / 3.2, 2.2, 0.0),
    "Ziegler-Nichols PID": (0.6, 0.5, 0.125),
    "Tyreus-Luyben PID": (1.0 / 2.2, 2.2, 1.0 / 6.3),
    "Astrom-Hagglund PID": (math.cos(PHASE_MARGIN), 4.0 * _LEAD, _LEAD),
}
"""Gain, integral and derivative time of each rule, over ultimate gain and period.

Ziegler & Nichols, Trans. ASME 64 (1942); Tyreus & Luyben, Ind. Eng. Chem. Res. 31 (1992), with derivative in Luyben & Luyben,
"Essentials of Process Control", 1997; Astrom & Hagglund, Automatica 20 (1984): at the ultimate period the loop has a gain of 1 and a
phase margin of 60 degrees, with T_i = 4 T_d.
"""


@dataclass(frozen=True)
class PID:
    """Gains of u = P e + I int e + D e', in units of the command per metre."""

    proportional: float
    integral: float
    derivative: float


@dataclass(frozen=True)
class RelayTest:
    """The outcome of a relay experiment.

    Attributes
    ----------
    gain : Bounds [command/m]
        Ultimate gain.
    period : Bounds [s]
        Ultimate period.
    frequency, response : float [rad/s], complex [m/command]
        The oscillation, and the response of the axis there.
    cycles : int
    level, travel : float [command, m]
        Half the difference of the levels of the relay, and the travel of a cycle.
    bias : float
        Mean command over `level`: a steady load, or friction that differs by direction.
    friction : float
        Coulomb friction over `level`, from a fit of v' = a (u - f sign v) - b v behind a dead time; nan if the dead time hides it.
    gain_without_friction : float [command/m]
        Ultimate gain of that fit without its friction; nan if unknown.
    """

    gain: Bounds
    period: Bounds
    frequency: float
    response: complex = field(metadata={"json": False})
    cycles: int
    level: float
    travel: float
    bias: float
    friction: float
    gain_without_friction: float

    def gains(self, rule: str) -> PID:
        """Return the gains of one of `RULES`."""
        share, integral_time, derivative_time = RULES[rule]
        p = share * self.gain.value
        return PID(p, p / (integral_time * self.period.value), p * derivative_time * self.period.value)


def relay_test(command: Array, position: Array, period: float) -> RelayTest:
    """Find ultimate gain and period.

    Parameters
    ----------
    command : ndarray (n,)
        Of the relay, behind all limits.
    position : ndarray (n,) [m]
        At the same instants.
    period : float [s]
        Between samples.

    Raises
    ------
    ResultError
        If the command is not that of a relay, or there are too few cycles, they are not steady, or the axis hardly moves.

    Notes
    -----
    The oscillation is a little slower than the ultimate one, because of hysteresis and sampling. First and third harmonic bracket a phase
    of -180 degrees; gain and phase between them are taken as linear in the logarithm of the frequency. The interval contains the phase of
    a dead time, linear in the frequency, and as much to the other side; the scatter from cycle to cycle; half a count; and what a fit with
    Coulomb friction gives without its friction. The gains of 576 of 589 simulated axes (delays of 0.5 to 10 ms, friction up to 20 % of the
    relay, loads, 50 to 1000 counts in a cycle) lay within it, and 582 periods.

    References
    ----------
    Astrom & Hagglund, "Automatic tuning of simple regulators with specifications on phase and amplitude margins", Automatica 20 (1984).
    """
    middle = 0.5 * float(command.max() + command.min())
    above = command > middle
    starts = np.flatnonzero(above[1:] & ~above[:-1]) + 1
    refuse(starts.size <= LEAST, ResultError, f"{max(starts.size - 1, 0)} cycles of a relay: {LEAST} are needed")
    lengths, travels = np.diff(starts), np.array([float(np.ptp(position[a : b + 1])) for a, b in pairwise(starts)])
    short = float(np.median(lengths))
    refuse(short < SAMPLES, ResultError, f"a cycle has only {short:g} samples, {SAMPLES} are needed: sample faster")
    last = slice(lengths.size // 2, None)
    alike = [np.abs(x / max(float(np.median(x[last])), 1e-30) - 1.0) for x in (lengths, travels)]
    near = (alike[0] < STEADY + 1.0 / short) & (alike[1] < STEADY)
    first, stop = max(true_spans(near), key=lambda span: span[1] - span[0], default=(0, 0))
    cycles, half = stop - first, (stop - first) // 2
    refuse(cycles < LEAST, ResultError, f"no steady oscillation: only {cycles} cycles in a row are alike, {LEAST} are needed")
    for x in (lengths[first:stop], travels[first:stop]):
        growth = float(x[-half:].mean() / x[:half].mean())
        drift = DRIFT + 4.0 * float(np.std(x)) / math.sqrt(cycles) / float(x.mean())
        refuse(abs(growth - 1.0) > drift, ResultError, f"no steady oscillation: it still changes by a factor of {growth:.3g}")
    edges = starts[first : stop + 1]
    whole, travel = slice(edges[0], edges[-1]), float(travels[first:stop].mean())
    u, y = command[whole], position[whole]
    levels = [float(np.median(u[side])) for side in (u > middle, u <= middle)]
    level = 0.5 * (levels[0] - levels[1])
    off = np.minimum(np.abs(u - levels[0]), np.abs(u - levels[1])) > 0.05 * level
    refuse(float(off.mean()) > 0.05, ResultError, "the command is not that of a relay: it has more than two levels")
    steps = np.diff(np.unique(y))
    count = float(steps.min(initial=math.inf))
    refuse(not travel > COUNTS * count, ResultError, f"the axis moves by {travel / count:.2g} counts: {COUNTS:g} are needed")
    harmonics = _harmonics(u, cycles), _harmonics(y, cycles)
    response, third = (complex(harmonics[1][k] / harmonics[0][k]) for k in (0, 1))
    each = np.array([abs(_harmonics(position[a:b], 1)[0] / _harmonics(command[a:b], 1)[0]) for a, b in pairwise(edges)])
    sure = float(stdtrit(cycles - 1, 0.975)) / math.sqrt(cycles)
    scatter = sure * np.array([np.std(np.log(each), ddof=1), np.std(np.log(lengths[first:stop]), ddof=1)])
    scatter += [0.5 * count / travel, 0.0]
    frequency = 2.0 * math.pi * cycles / (u.size * period)
    ahead = float(np.angle(-response))
    far = math.degrees(abs(ahead))
    refuse(
        far > FAR, ResultError, f"the phase is {far:.0f} deg from -180: the position counts the other way, or the hysteresis is too large"
    )
    behind = ahead - float(np.angle(response / third)) % (2.0 * math.pi)
    part = ahead / (ahead - behind)
    rise = part * math.log(3.0)
    between = BENT * abs(math.log1p(2.0 * part) - rise)
    slope = math.log(abs(third / response)) / math.log(3.0)
    gain = math.exp(-slope * rise) / abs(response)
    ultimate = 2.0 * math.pi / (frequency * math.exp(rise))
    spread = scatter + np.array([abs(slope) * between, between])
    quarter = u.size // cycles // 4  # before it, commands from before the first sample still act
    friction, *free = _friction(u[quarter:], y[quarter:], period)
    inside = [_within(*each) for each in zip((gain, ultimate), spread.tolist(), free, strict=True)]
    bias = float(u.mean()) / level
    return RelayTest(inside[0], inside[1], frequency, response, cycles, level, travel, bias, friction / level, free[0])


def _within(value: float, half: float, without: float) -> Bounds:
    """Return a value with its interval: half its width as a logarithm, and the value without friction."""
    ends = [value * math.exp(-half), value * math.exp(half)]
    if without > 0.0:
        ends.append(without * (without / value) ** MISFIT)
    return Bounds(value, min(ends), max(ends))


def _harmonics(values: Array, cycles: int) -> Complex:
    """Return the first and third harmonic (2,) of whole cycles."""
    turns = np.exp(-2j * math.pi * cycles / values.size * np.outer((1.0, 3.0), np.arange(values.size)))
    return np.asarray(turns @ (values - values.mean()) * (2.0 / values.size))


def _friction(command: Array, position: Array, period: float) -> tuple[float, float, float]:
    """Return Coulomb friction [command], and ultimate gain and period without it; nan if the fit fails."""
    try:
        fit = identify_first_order(period * np.arange(command.size), command, position).parameters
    except ParameterError:
        return math.nan, math.nan, math.nan
    late, a, b = fit.get("delay", 0.0) + 0.5 * period, fit["a"], fit["b"]
    if b * period > 0.5:  # the velocity follows at once: friction looks like a smaller gain
        return math.nan, math.nan, math.nan
    w = float(brentq(lambda w: math.atan2(w, b) + w * late - 0.5 * math.pi, 0.0, 0.5 * math.pi / late))
    return fit.get("friction", 0.0), w * math.hypot(w, b) / a, 2.0 * math.pi / w


def relay_findings(tests: Mapping[str, RelayTest], units: Mapping[str, str]) -> Iterator[Finding]:
    """Yield what relay experiments by axis say besides gain and period; `units` are those of the commands."""
    for axis, test in tests.items():
        place, without = f"axis {axis}", test.gain_without_friction / test.gain.value
        yield finding("CL612", place, cycles=test.cycles, level=test.level, unit=units[axis], travel=test.travel)
        if test.friction > FELT or without < 1.0 - FELT:
            yield finding("CL613", place, friction=test.friction, without=without)
        if abs(test.bias) > FELT:
            yield finding("CL614", place, bias=test.bias)
