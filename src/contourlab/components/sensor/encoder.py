"""Encoders: a uniform quantiser; and two analogue sinusoids with errors, correction, and interpolation to counts.

The distorted signals lie on an ellipse A v1^2 + B v2^2 + C v1 v2 + D v1 + E v2 = 1 whose coefficients theta = (A, B, C, D, E) are linear in
the measured products; the constants of the correction follow from them.

References
----------
P. L. M. Heydemann, "Determination and correction of quadrature fringe measurement errors in interferometers", Applied Optics 20 (1981).
E. Ulu, N. Gecer Ulu, M. Cakmakci, "Development and validation of an adaptive method to generate high-resolution quadrature encoder
signals", Journal of Dynamic Systems, Measurement, and Control 136 (2014).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import NOISE_STREAM, Component, param, text_param
from contourlab.engine.step import Port
from contourlab.errors import ParameterError
from contourlab.primitives import clip, copysign, cos, dot, fabs, floor, lincomb, lookup, maximum, minimum, normal, rint, select, sin, sqrt


class Encoder(Component):
    """Position in whole counts: q = r round((p + noise)/r), r the resolution after interpolation.

    Noise is normal and white; the same seed gives the same noise.
    """

    family = "sensor"
    kind = "encoder"
    example = {"resolution": 1e-5, "noise": 1e-5, "stream": 7.0}
    reference = "uniform quantiser"

    resolution: float = param(unit="m", minimum=0.0, exclusive=True, display="um", doc="travel per count, interpolation included")
    noise: float = param(default=0.0, unit="m", minimum=0.0, display="um", doc="standard deviation before quantisation")
    stream: float = NOISE_STREAM

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.resolution * rint((inp.position + par.noise * normal(par.stream, clock.k)) / par.resolution),)


INTERVALS = 1024.0
TINY = 1e-300
PER_TURN = 1.0 / (2.0 * math.pi)
LEAST = 0.01
"""Lower bound of A and B: an amplitude ten times the nominal one. The upper bound is the inverse."""
STEEPEST = 0.9
"""Upper bound of the sine of the phase error."""
FURTHEST = 0.9
"""Upper bound of an offset over the nominal amplitude: the origin stays inside the ellipse."""
IDENTITY = (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0)
"""Upper triangle of the unit matrix, row by row, as covariances are stored."""
ROWS = ((0, 1, 2, 3, 4), (1, 5, 6, 7, 8), (2, 6, 9, 10, 11), (3, 7, 10, 12, 13), (4, 8, 11, 13, 14))
"""Where the entries of each row of a covariance are in its upper triangle."""
PLAY = 0.5
"""Half the travel, in pitches, within which an axis may dither without an update: more travel shows all phases."""
LEAST_COVARIANCE = 40.0
"""Least initial covariance over (1 - lambda): well above the steady trace, 18 (1 - lambda)."""
STATES = (Port("begun"), Port("turns"), Port("play"), Port("used"), Port("theta", 5), Port("covariance", 15))
DERIVED = ("theta_a", "theta_b", "theta_c", "theta_d", "theta_e")
TUNING = ("forgetting", "initial_covariance", "update_travel")
TABLES = ("arctangent",)
"""States, derived constants, parameters and tables of a step that calls `followed`."""


def arctangents() -> Array:
    """Return the table that `in_turns` reads: arctan(i/1024) [rad], i = 0 .. 1024."""
    return np.arctan(np.arange(INTERVALS + 1.0) / INTERVALS)


def in_turns(table: Any, u1: float, u2: float) -> float:
    """Return the angle of (u1, u2) in turns, -1/2 to 1/2, from quadrant and ratio; to rounding, and 0 at the origin.

    Between two entries the difference of angles is arctan((t - ti)/(1 + t ti)), below 1/2048: two terms of its series are exact.
    """
    across, along = fabs(u2), fabs(u1)
    t = minimum(across, along) / maximum(maximum(across, along), TINY)
    i = rint(INTERVALS * t)
    ti = i / INTERVALS
    d = (t - ti) / (1.0 + t * ti)
    angle = (lookup(table, i) + (d - d * d * d / 3.0)) * PER_TURN
    angle = select(across > along, 0.25 - angle, angle)
    angle = select(u1 < 0.0, 0.5 - angle, angle)
    return copysign(angle, u2)


def ellipse(offset_1: Any, offset_2: Any, ratio: Any, sine: Any, amplitude: Any) -> tuple[Any, ...]:
    """Return A .. E for the constants: offsets p and q, amplitude ratio r, sine of the phase error, amplitude R; numbers or arrays."""
    k = amplitude**2 * (1.0 - sine**2) - offset_1**2 - (ratio * offset_2) ** 2 - 2.0 * ratio * sine * offset_1 * offset_2
    a, b, c = 1.0 / k, ratio**2 / k, 2.0 * ratio * sine / k
    return a, b, c, -(2.0 * a * offset_1 + c * offset_2), -(2.0 * b * offset_2 + c * offset_1)


def constants(theta: Any) -> tuple[float, float, float, float, float]:
    """Return offsets p and q, ratio r, sine and cosine of the phase error from A .. E.

    Coefficients that do not describe an ellipse around the origin are clipped to their bounds, so that the result is always finite.
    """
    a, b = clip(theta[0], LEAST, 1.0 / LEAST), clip(theta[1], LEAST, 1.0 / LEAST)
    root = sqrt(a * b)
    sine = clip(theta[2] / (2.0 * root), -STEEPEST, STEEPEST)
    c = 2.0 * root * sine
    scale = 1.0 / (c * c - 4.0 * a * b)
    p = clip((2.0 * b * theta[3] - theta[4] * c) * scale, -FURTHEST, FURTHEST)
    q = clip((2.0 * a * theta[4] - theta[3] * c) * scale, -FURTHEST, FURTHEST)
    return p, q, sqrt(b / a), sine, sqrt(1.0 - sine * sine)


def corrected(errors: tuple[float, float, float, float, float], v1: float, v2: float) -> tuple[float, float]:
    """Return the signals without their errors: u1 = v1 - p, u2 = (u1 sin al + r (v2 - q))/cos al."""
    p, q, r, sine, cosine = errors
    u1 = v1 - p
    return u1, (u1 * sine + r * (v2 - q)) / cosine


def updated(theta: Any, covariance: Any, v1: float, v2: float, forgetting: float, start: float, gate: float) -> tuple[Any, Any]:
    """Return coefficients and covariance after one sample: recursive least squares with exponential forgetting and resetting.

    Parameters
    ----------
    theta : tuple of 5
    covariance : tuple of 15
        Upper triangle, row by row.
    v1, v2 : float
        Measured signals over the nominal amplitude.
    forgetting : float, 0 < lambda <= 1
    start : float, > 0
        The initial covariance is this times the unit matrix. If the trace grows beyond the initial one, the covariance is reset: forgetting
        lets it grow without bound in directions that are not excited.
    gate : float
        1 to use the sample, 0 to change nothing.
    """
    w = (v1 * v1, v2 * v2, v1 * v2, v1, v2)
    g = tuple(dot(tuple(covariance[i] for i in row), w) for row in ROWS)
    scale = gate / (forgetting + maximum(dot(w, g), 0.0))
    products = tuple(g[i] * g[j] for i in range(5) for j in range(i, 5))
    growth = 1.0 + gate * (1.0 / forgetting - 1.0)
    next_covariance = lincomb(growth, covariance, -growth * scale, products)
    trace = next_covariance[0] + next_covariance[5] + next_covariance[9] + next_covariance[12] + next_covariance[14]
    reset = select(trace > 5.0 * start, 1.0, 0.0)
    next_covariance = lincomb(1.0 - reset, next_covariance, reset * start, IDENTITY)
    return lincomb(1.0, theta, scale * (1.0 - dot(w, theta)), g), next_covariance


def followed(par: Any, x: Any, v1: float, v2: float, near: float) -> tuple[tuple[Any, ...], tuple[float, float]]:
    """Correct a sample and update the fit; return the next states and the corrected signals.

    The fit ignores dither within a pitch and takes one sample per `update_travel`. It thus forgets with travel, not with time.

    Parameters
    ----------
    par
        Has the names of DERIVED (initial knowledge), TUNING and TABLES.
    x
        Has the names of STATES; all zero at the start.
    v1, v2 : float
        Measured signals over the nominal amplitude.
    near : float
        Position of the axis in pitches, to within half a pitch.
    """
    theta = lincomb(x.begun, x.theta, 1.0 - x.begun, (par.theta_a, par.theta_b, par.theta_c, par.theta_d, par.theta_e))
    covariance = lincomb(x.begun, x.covariance, (1.0 - x.begun) * par.initial_covariance, IDENTITY)
    u1, u2 = corrected(constants(theta), v1, v2)
    angle = in_turns(par.arctangent, u1, u2)
    turns = angle + rint(near - angle)
    play = select(x.begun > 0.0, clip(x.play, turns - PLAY, turns + PLAY), turns)
    moved = select(x.begun > 0.0, play - x.used, par.update_travel)
    gate = select(fabs(moved) >= par.update_travel, 1.0, 0.0)
    theta, covariance = updated(theta, covariance, v1, v2, par.forgetting, par.initial_covariance, gate)
    return (1.0, turns, play, select(gate > 0.0, play, x.used), theta, covariance), (u1, u2)


MOST_COUNTS = 1e9
"""Most counts in a quarter of a period."""

TURN = 2.0 * math.pi


def waves(par: Any, position: float, k: float) -> tuple[float, float]:
    """Return the two signals after the converter, over the nominal amplitude."""
    turns = position / par.pitch
    phase = TURN * (turns - rint(turns))
    u1 = par.amplitude * (cos(phase) + par.third_harmonic * cos(3.0 * phase))
    u2 = par.amplitude * (sin(phase) - par.third_harmonic * sin(3.0 * phase))
    d1 = u1 + par.offset_1 + par.noise * normal(par.stream, 2.0 * k)
    d2 = (u2 * par.phase_cosine - u1 * par.phase_sine) / par.amplitude_ratio + par.offset_2 + par.noise * normal(par.stream, 2.0 * k + 1.0)
    return converted(par, d1) / par.amplitude, converted(par, d2) / par.amplitude


def converted(par: Any, voltage: float) -> float:
    """Return a voltage after the analogue-to-digital converter, if there is one."""
    held = clip(voltage, -par.converter_range, par.converter_range)
    return select(par.bits > 0.0, par.step_of_converter * rint(held / par.step_of_converter), voltage)


class QuadratureEncoder(Component):
    """Position from two analogue signals: u1 = a cos phi, u2 = a sin phi, phi = 2 pi x/pitch, as from a real scale.

    The signals have offsets p and q, an amplitude ratio r, a phase error al, a third harmonic, noise and the steps of a converter:
    u1d = u1 + p, u2d = (u2 cos al - u1 sin al)/r + q. Uncorrected, they cause errors that repeat with the pitch: an offset p/a rad once per
    pitch, ratio and phase (r - 1)/2 and al/2 rad twice, a third harmonic h rad four times (no ellipse removes it). The pitch is the travel
    of one period: a scale sold as "1 um" after fourfold counting has a pitch of 4 um.

    ``correction = "fixed"`` uses the known constants. ``"adaptive"`` starts from them and continues by recursive least squares with
    forgetting, one update per `update_travel`. While the axis is at rest or dithers within a pitch, the fit neither learns nor forgets.

    The corrected angle is interpolated to pitch/resolution = 4 n counts per pitch. The count changes half-way between two counts, where
    sin(n phi) + cos(n phi) or their difference crosses zero.

    With ``counting = "hardware"`` a fast counter counts the periods and never misses one. With ``"sampled"`` they are counted at the servo
    rate: an axis that moves more than half a pitch per tick loses whole pitches. `missed_periods` is the number lost.

    References
    ----------
    E. Ulu, N. Gecer Ulu, M. Cakmakci, "Development and validation of an adaptive method to generate high-resolution quadrature encoder
    signals", Journal of Dynamic Systems, Measurement, and Control 136 (2014). P. L. M. Heydemann, Applied Optics 20 (1981).
    """

    family = "sensor"
    kind = "quadrature-encoder"
    reference = "Ulu, Gecer Ulu & Cakmakci 2014; Heydemann 1981"
    example = {
        "pitch": 1e-3,
        "resolution": 1e-7,
        "offset_1": 0.05,
        "offset_2": -0.04,
        "amplitude_ratio": 1.1,
        "phase_error": 0.08,
        "third_harmonic": 0.01,
        "noise": 0.002,
        "bits": 12.0,
        "counting": "sampled",
        "correction": "adaptive",
        "known_offset_1": 0.03,
        "known_offset_2": -0.02,
        "known_ratio": 1.05,
        "known_phase_error": 0.03,
        "stream": 7.0,
    }
    states = STATES
    outputs = (Port("position"), Port("missed_periods"))
    derived = ("phase_sine", "phase_cosine", "step_of_converter", "counts_per_pitch", *DERIVED)
    tables = TABLES

    pitch: float = param(unit="m", minimum=0.0, exclusive=True, display="um", doc="travel of one period of the signals")
    resolution: float = param(unit="m", minimum=0.0, exclusive=True, display="nm", doc="travel per count: pitch / (4 n), n whole")
    amplitude: float = param(default=0.5, unit="V", minimum=0.0, exclusive=True, doc="amplitude of the first signal, a")
    offset_1: float = param(default=0.0, unit="V", minimum=-100.0, maximum=100.0, display="mV", doc="offset of the first signal, p")
    offset_2: float = param(default=0.0, unit="V", minimum=-100.0, maximum=100.0, display="mV", doc="offset of the second signal, q")
    amplitude_ratio: float = param(default=1.0, minimum=0.1, maximum=10.0, doc="amplitude of signal 1 over that of signal 2, r")
    phase_error: float = param(default=0.0, unit="rad", minimum=-1.0, maximum=1.0, display="deg", doc="phase error of signal 2, al")
    third_harmonic: float = param(default=0.0, minimum=-0.3, maximum=0.3, doc="amplitude of the third harmonic relative to the first")
    noise: float = param(default=0.0, unit="V", minimum=0.0, display="mV", doc="standard deviation of the white noise of each signal")
    bits: float = param(default=0.0, minimum=0.0, maximum=32.0, whole=True, doc="bits of the analogue-to-digital converter; 0: none")
    converter_range: float = param(default=1.0, unit="V", minimum=0.0, exclusive=True, doc="largest signal of the converter, either sign")
    counting: str = text_param(default="hardware", choices=("hardware", "sampled"), doc="where whole periods are counted")
    correction: str = text_param(default="adaptive", choices=("none", "fixed", "adaptive"), doc="correction of the errors")
    known_offset_1: float = param(default=0.0, unit="V", minimum=-100.0, maximum=100.0, display="mV", doc="known part of the first offset")
    known_offset_2: float = param(default=0.0, unit="V", minimum=-100.0, maximum=100.0, display="mV", doc="known part of the second offset")
    known_ratio: float = param(default=1.0, minimum=0.2, maximum=5.0, doc="known part of the amplitude ratio")
    known_phase_error: float = param(default=0.0, unit="rad", minimum=-1.0, maximum=1.0, display="deg", doc="known part of the phase error")
    forgetting: float = param(default=0.998, minimum=0.9, maximum=1.0, doc="forgetting factor lambda, per update")
    initial_covariance: float = param(
        default=10.0, minimum=0.0, exclusive=True, maximum=1e6, doc="initial covariance of a coefficient, divided by the squared noise"
    )
    update_travel: float = param(default=1.0 / 32.0, minimum=1e-4, maximum=10.0, doc="travel between updates of the fit, in pitches")
    stream: float = NOISE_STREAM

    def check_values(self) -> None:
        order = self.pitch / (4.0 * self.resolution)
        if not 0.75 <= order <= MOST_COUNTS or abs(order - round(order)) > 1e-6:
            shown = f"{self.resolution:g}"
            raise ParameterError("resolution", shown, f"the pitch, {self.pitch:g} m, divided by four times a whole number")
        least = LEAST_COVARIANCE * (1.0 - self.forgetting)
        if self.correction == "adaptive" and self.initial_covariance < least:
            raise ParameterError("initial_covariance", f"{self.initial_covariance:g}", f">= {least:g} with this forgetting factor")
        inside = max(abs(self.known_offset_1), abs(self.known_offset_2)) <= FURTHEST * self.amplitude
        start = self.block(1.0) if inside else {}
        if not (inside and all(LEAST <= start[name] <= 1.0 / LEAST for name in DERIVED[:2])):
            shown = f"{self.known_offset_1:g} and {self.known_offset_2:g}"
            raise ParameterError("known offsets", shown, "well inside the amplitudes of the signals", "V")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, correction: str, counting: str) -> Any:
        v1, v2 = waves(par, inp.position, clock.k)
        true = inp.position / par.pitch
        # At the first tick the axis is at its reference mark, so the period is known.
        near = true if counting == "hardware" else select(x.begun > 0.0, x.turns, true)
        if correction == "adaptive":
            states, _ = followed(par, x, v1, v2, near)
            turns = states[1]
        else:
            known = (par.theta_a, par.theta_b, par.theta_c, par.theta_d, par.theta_e)
            u1, u2 = (v1, v2) if correction == "none" else corrected(constants(known), v1, v2)
            angle = in_turns(par.arctangent, u1, u2)
            turns = angle + rint(near - angle)
            states = (1.0, turns, 0.0, 0.0, known, IDENTITY)
        return states, (par.resolution * floor(turns * par.counts_per_pitch + 0.5), rint(true - turns))

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        offsets = par.known_offset_1 / par.amplitude, par.known_offset_2 / par.amplitude
        start = ellipse(*offsets, par.known_ratio, np.sin(par.known_phase_error), 1.0)
        lsb = par.converter_range * 2.0 ** (1.0 - np.asarray(par.bits, dtype=float))
        return np.sin(par.phase_error), np.cos(par.phase_error), lsb, np.rint(par.pitch / par.resolution), *start

    def table_values(self) -> dict[str, Array]:
        return {"arctangent": arctangents()}
