"""Models of a drive over frequency, one mass with damping and delay or two masses, and their fit to a measured response.

The command is held between samples and the position is sampled: a model's response is summed over its aliases, so that points near half
the sample frequency are usable too.

The fit is on log magnitude and phase [rad], each point weighted by its deviation.

References
----------
Altintas, Verl, Brecher, Uriarte & Pritschow, "Machine tool feed drives", CIRP Annals 60 (2011), for the two-inertia drive;
Pintelon & Schoukens, "System Identification: a frequency domain approach", 2nd ed., section 9.8 (logarithmic least squares).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from itertools import product

import numpy as np

from contourlab.analysis.identification.frequency_response import MeasuredResponse
from contourlab.analysis.identification.least_squares import Free, OutputFit, deviation_findings, fit_findings, fit_output, fit_percent
from contourlab.arrays import Array, Complex
from contourlab.errors import ParameterError, refuse
from contourlab.findings import Finding, finding

Parameters = Mapping[str, float]

ALIASES = 4
"""Aliases on either side; the rest is below 1e-3 of the response of a position."""


def linear_motor(x: Parameters, s: Complex) -> Complex:
    """Return position over force of a mass M with damping B and a delay."""
    return np.asarray(np.exp(-s * x.get("delay", 0.0)) / (s * (x["M"] * s + x["B"])))


def two_inertia(x: Parameters, s: Complex, side: str = "motor") -> Complex:
    """Return position over force of two masses with a shaft between them, with the position of motor or load."""
    shaft = x["shaft_damping"] * s + x["stiffness"]
    load = x["load_mass"] * s * s + shaft
    # motor load - shaft^2, without the terms that cancel at low frequencies.
    whole = (x["motor_mass"] * s + x["damping"]) * load + x["load_mass"] * s * shaft
    return np.asarray(np.exp(-s * x.get("delay", 0.0)) * (load if side == "motor" else shaft) / (s * whole))


def load_side(x: Parameters, s: Complex) -> Complex:
    """Return position over force at the load, from parameters visible there: total mass, resonance [Hz], damping ratio, damping, delay.

    Notes
    -----
    Seen from the load, a drive is (1 + s d/k)/(s (M s + c)) times one resonance; the division of the mass M into motor m and load l is not
    visible. The damping ratio of the resonance is, to first order,

        zeta = d/(2 w m l/M) + c l/(2 w m M),

    whose shaft and motor parts cannot be separated without m and l. The lead d/k is taken as 2 zeta/w, as if all damping were in the
    shaft; damping of the motor then makes the delay too large, by less than 2 zeta/w.
    """
    w = 2.0 * math.pi * x["resonance"]
    lead = 2.0 * x["damping_ratio"] / w
    rigid = s * (x["mass"] * s + x["damping"])
    return np.asarray(np.exp(-s * x["delay"]) * (1.0 + lead * s) / (rigid * (1.0 + lead * s + (s / w) ** 2)))


def two_mass(x: Parameters, s: Complex) -> Complex:
    """Return position over force of the plant "two-mass", whose two modes do not couple: at the motor, or at the load without `load_share`.

    Parameters
    ----------
    x : mapping of str to float
        mass, resonance [Hz], damping_ratio, damping, delay; at the motor also load_share.
    s : ndarray (n,)

    Notes
    -----
    At the load the share is not visible: (1/(s^2 + s c/m) - 1/(s^2 + s (2 D w + c/m) + w^2))/m.
    """
    w, decay = 2.0 * math.pi * x["resonance"], x["damping"] / x["mass"]
    part = x["load_share"] / (1.0 - x["load_share"]) if "load_share" in x else -1.0
    modes = 1.0 / (s * (s + decay)) + part / (s * s + (2.0 * x["damping_ratio"] * w + decay) * s + w * w)
    return np.asarray(np.exp(-s * x["delay"]) * modes / x["mass"])


def held_response(model: Callable[[Complex], Complex], frequency: Array, period: float) -> Complex:
    """Return the sampled response of a continuous model: command held, position sampled, aliases summed.

    Parameters
    ----------
    model : callable
        From s (n,) to the response.
    frequency : ndarray (n,) [Hz]
        Below half the sample frequency.
    period : float [s]
    """
    total = np.zeros(frequency.size, dtype=complex)
    for k in range(-ALIASES, ALIASES + 1):
        s = np.asarray(2j * np.pi * (frequency + k / period), dtype=complex)
        total += model(s) * -np.expm1(-s * period) / (s * period)
    return total


def resonances(x: Parameters) -> tuple[float, float]:
    """Return resonance and antiresonance [Hz] of two masses, without damping."""
    k, motor, load = x["stiffness"], x["motor_mass"], x["load_mass"]
    return math.sqrt(k * (1.0 / motor + 1.0 / load)) / (2.0 * math.pi), math.sqrt(k / load) / (2.0 * math.pi)


def damping_ratio(x: Parameters) -> float:
    """Return the damping ratio of the resonance of two masses, from the damping of shaft and motor."""
    motor, load, shaft, c = x["motor_mass"], x["load_mass"], x["shaft_damping"], x["damping"]
    powers = [motor * load, (motor + load) * shaft + load * c, (motor + load) * x["stiffness"] + c * shaft, c * x["stiffness"]]
    pole = max(np.roots(powers), key=lambda root: abs(root.imag))
    return float(-pole.real / abs(pole))


CLEAREST = 2e-3
"""Smallest relative deviation of a point."""
LEAST_COHERENCE = 0.5
"""Coherence below which a point is left out of a fit."""
LEAST_SURE = 0.3
"""Relative deviation above which the point of a sine is left out."""
USELESS = 0.5
"""Relative deviation above which a model cannot be used."""
EXPLAINED = 80.0
"""Fit [percent] below which a model is in doubt."""


@dataclass(frozen=True, eq=False)
class DriveFit:
    """A model of a drive.

    Attributes
    ----------
    estimate : OutputFit
        Of M, B, delay; or of motor_mass, load_mass, stiffness, shaft_damping, damping, delay; or, measured at the load without a known
        motor mass, of mass, resonance [Hz], damping_ratio, damping, delay as in `load_side`. Units are kg, N/m, N s/m and s if the command
        is a force in N; for another command, masses, stiffness and damping are divided by newtons per command.
    frequency : ndarray (n,) [Hz]
        Of the fitted points.
    measured, predicted : complex ndarray (n,) [m per command]
    fit : float [percent]
        Of the complex velocity response.
    transfer : callable
        The model: from s (n,) to position over command.
    given : mapping of str to float
        Parameters with given values.
    """

    estimate: OutputFit
    frequency: Array
    measured: Complex
    predicted: Complex
    fit: float
    usable: bool
    findings: tuple[Finding, ...]
    transfer: Callable[[Complex], Complex]
    given: Mapping[str, float] = field(default_factory=dict)

    @property
    def parameters(self) -> dict[str, float]:
        """All parameters of the model by name, fitted and given."""
        return {**self.given, **self.estimate.parameters}

    def __getitem__(self, name: str) -> float:
        """Return a parameter by name."""
        return self.parameters[name]

    @property
    def whole_mass(self) -> float:
        """Total moved mass [kg, or kg over newtons per command]."""
        return sum(self.parameters.get(name, 0.0) for name in ("M", "mass", "motor_mass", "load_mass"))


@dataclass(frozen=True, eq=False)
class _Points:
    frequency: Array
    response: Complex
    weight: Array
    period: float
    left_out: int

    def row(self, response: Complex) -> Array:
        """Return log magnitude and phase, weighted; the phase is unwrapped towards the measured phase."""
        turn = np.angle(self.response) + np.angle(response / self.response)
        return np.concatenate([np.log(np.abs(response)) * self.weight, turn * self.weight])

    def speed(self, response: Complex) -> Complex:
        return np.asarray(2j * np.pi * self.frequency * response)


def _points(measured: MeasuredResponse, fewest: int) -> _Points:
    # For a sine, least squares over many periods finds the response even at low coherence.
    trusted = np.where(np.isnan(measured.distortion), measured.coherence >= LEAST_COHERENCE, measured.deviation < LEAST_SURE)
    good = trusted & np.isfinite(measured.response) & (np.abs(measured.response) > 0.0)
    count = int(np.count_nonzero(good))
    if count < fewest:
        raise ParameterError("frequency", f"{count} points", f"at least {fewest} above the noise: excite the axis more, or longer")
    deviation = np.maximum(np.nan_to_num(measured.deviation[good], nan=1.0, posinf=1.0), CLEAREST)
    return _Points(measured.frequency[good], measured.response[good], 1.0 / deviation, measured.period, good.size - count)


def _rigid_start(points: _Points) -> dict[str, Free]:
    """Return the start of the fit: mass and damping from the inverse velocity response, at the best delay."""
    s = 2j * np.pi * points.frequency
    hold = held_response(lambda z: 1.0 / z, points.frequency, points.period) * s
    trials = []
    for delay in np.linspace(0.0, 0.25 / points.frequency.max(), 26).tolist():
        inverse = hold * np.exp(-s * delay) / points.speed(points.response)
        w = points.weight / np.abs(inverse)
        columns = np.concatenate([np.column_stack([0.0 * w, w]), np.column_stack([s.imag * w, 0.0 * w])])
        wanted = np.concatenate([inverse.real * w, inverse.imag * w])
        solution, *_ = np.linalg.lstsq(columns, wanted, rcond=None)
        trials.append((float(np.sum((columns @ solution - wanted) ** 2)), *solution.tolist(), delay))
    _, mass, damping, delay = min((trial for trial in trials if trial[1] > 0.0), default=(0.0, 0.0, 0.0, 0.0))
    refuse(mass <= 0.0, ParameterError, "M", "below zero", "> 0: the axis goes against its command; reverse the sign of one of the two")
    damping = max(damping, 1e-3 * mass)
    top = 2.0 * math.pi * float(points.frequency.max())
    return {
        "M": Free(mass, 1e-3 * mass, 1e3 * mass, mass),
        "B": Free(damping, 0.0, 10.0 * mass * top, max(damping, 1e-2 * mass * 2.0 * math.pi * float(points.frequency.min()))),
        "delay": _late(points, delay),
    }


def fit_linear_motor(measured: MeasuredResponse) -> DriveFit:
    """Fit mass, damping and delay to a frequency response.

    Raises
    ------
    ParameterError
        If there are fewer than 4 points, the mass is below zero, or the parameters cannot be separated.
    """
    points = _points(measured, 4)
    return _fitted(points, linear_motor, _rigid_start(points))


def fit_two_inertia(measured: MeasuredResponse, side: str = "motor") -> DriveFit:
    """Fit two masses, the shaft between them, damping and delay to a frequency response.

    Parameters
    ----------
    side : str
        Where the position is measured: ``"motor"`` or ``"load"``.

    Raises
    ------
    ParameterError
        If there are fewer than 8 points, a mass is below zero, or the parameters cannot be separated.
    """
    points, rigid, x = _two_masses(measured, side)
    if side == "load":
        return _with_resonance(points, _fitted(points, load_side, _resonant_start(points, x, False)), rigid)
    start = {name: _wide(x[name]) for name in MASSES} | {name: _loss(x[name], x[name]) for name in ("shaft_damping", "damping")}
    return _with_resonance(points, _fitted(points, two_inertia, start | {"delay": _late(points, x["delay"])}), rigid)


def fit_two_mass(measured: MeasuredResponse, side: str = "motor") -> DriveFit:
    """Fit the plant "two-mass" with a delay to a frequency response; the load's share is fitted at the motor only.

    Parameters
    ----------
    side : str
        Where the position is measured: ``"motor"`` or ``"load"``.

    Raises
    ------
    ParameterError
        If there are fewer than 8 points, the mass is below zero, or the parameters cannot be separated.
    """
    points, rigid, x = _two_masses(measured, side)
    return _with_resonance(points, _fitted(points, two_mass, _resonant_start(points, x, side == "motor")), rigid)


def fit_load_share(measured: MeasuredResponse, whole: DriveFit, motor_mass: float) -> DriveFit:
    """Fit load, shaft, damping and delay to a frequency response at the load, with a known mass of motor and screw.

    Parameters
    ----------
    whole : DriveFit
        Fit of the same response by `fit_two_inertia`, with side ``"load"``.
    motor_mass : float
        Above 0 and below the total mass, in the same unit.

    Raises
    ------
    ParameterError
        If the motor mass is out of range, or the parameters cannot be separated.
    """
    if not 0.0 < motor_mass < whole["mass"]:
        bound = f"above 0 and below the whole mass that the response tells, {whole['mass']:.4g}"
        raise ParameterError("motor_mass", f"{motor_mass:.4g}", bound)
    points = _points(measured, 8)
    given = {"motor_mass": motor_mass}
    shared = _fitted(points, lambda x, s: two_inertia({**given, **x}, s, "load"), _share_start(points, whole, motor_mass))
    return _with_resonance(points, replace(shared, given=given), _fitted(points, linear_motor, _rigid_start(points)))


def _share_start(points: _Points, whole: DriveFit, motor: float) -> dict[str, Free]:
    """Return the start of the fit with a known motor mass: the remaining mass, and the shaft that gives the resonance."""
    x = whole.parameters
    load, w = x["mass"] - motor, 2.0 * math.pi * x["resonance"]
    reduced = motor * load / x["mass"]
    stiffness, lossy = reduced * w * w, 2.0 * max(x["damping_ratio"], 1e-3) * reduced * w
    shaft = max(lossy - x["damping"] * (load / x["mass"]) ** 2, 0.1 * lossy)
    damping = max(x["damping"], 1e-3 * x["mass"])
    return {
        "load_mass": _wide(load),
        "stiffness": _wide(stiffness),
        "shaft_damping": _loss(shaft, lossy),
        "damping": _loss(damping, damping),
        "delay": _late(points, x["delay"]),
    }


def _wide(start: float) -> Free:
    return Free(start, 1e-4 * start, 1e4 * start, start)


def _loss(start: float, scale: float) -> Free:
    return Free(start, 0.0, 1e4 * scale, scale)


def _late(points: _Points, delay: float) -> Free:
    top = 1.0 / float(points.frequency.max()) + 20.0 * points.period
    return Free(min(delay, top), 0.0, top, points.period)


def _two_masses(measured: MeasuredResponse, side: str) -> tuple[_Points, DriveFit, dict[str, float]]:
    """Return the points, the fit of one mass, and the parameters from which a fit of two starts."""
    points = _points(measured, 8)
    rigid = _fitted(points, linear_motor, _rigid_start(points))
    return points, rigid, _two_inertia_start(points, side, rigid["delay"] + 0.5 * points.period)


def _two_inertia_start(points: _Points, side: str, delay: float) -> dict[str, float]:
    """Return the best of a grid over resonance, load share, losses and delay, each with its best mass."""
    low, high = float(points.frequency.min()), float(points.frequency.max())
    best: dict[str, float] = {}
    least, w2 = math.inf, points.weight**2
    s = np.asarray(2j * np.pi * points.frequency, dtype=complex)
    grid = product(np.geomspace(2.0 * low, 0.95 * high, 24), (0.15, 0.35, 0.6, 0.8), (0.02, 0.1), (1.0, 10.0), (0.0, delay))
    for resonance, share, loss, rate, waiting in grid:
        w, reduced = 2.0 * math.pi * float(resonance), share * (1.0 - share)
        x = {
            "motor_mass": 1.0 - share,
            "load_mass": share,
            "stiffness": reduced * w * w,
            "shaft_damping": 2.0 * loss * reduced * w,
            "damping": rate * low,
            "delay": waiting,
        }
        ratio = two_inertia(x, s, side) / points.response
        # Masses, stiffness and damping together only scale the response.
        log = np.log(np.abs(ratio))
        scale = float(np.sum(w2 * log) / np.sum(w2))
        cost = float(np.sum(w2 * ((log - scale) ** 2 + np.angle(ratio) ** 2)))
        if cost < least:
            best = {name: value * (1.0 if name == "delay" else math.exp(scale)) for name, value in x.items()}
            least = cost
    return best


def _resonant_start(points: _Points, x: Parameters, with_share: bool) -> dict[str, Free]:
    """Return the start of a fit of mass and resonance, with the load's share of the mass where it is visible."""
    low, high = float(points.frequency.min()), float(points.frequency.max())
    mass, resonance = x["motor_mass"] + x["load_mass"], resonances(x)[0]
    share = {"load_share": Free(x["load_mass"] / mass, 0.01, 0.99, 0.1)} if with_share else {}
    return {
        "mass": _wide(mass),
        **share,
        "resonance": Free(resonance, low, 3.0 * high, low),
        "damping_ratio": Free(x["shaft_damping"] * math.pi * resonance / x["stiffness"], 0.0, 1.0 if with_share else 2.0, 0.01),
        "damping": _loss(x["damping"], x["damping"]),
        "delay": _late(points, x["delay"]),
    }


MASSES = ("motor_mass", "load_mass", "stiffness")
VITAL = ("M", "mass", "resonance", "load_share", *MASSES)
"""Parameters that a usable model needs."""


def _fitted(points: _Points, model: Callable[[Parameters, Complex], Complex], free: dict[str, Free]) -> DriveFit:
    def response(x: Parameters) -> Complex:
        return held_response(lambda s: model(x, s), points.frequency, points.period)

    output_fit = fit_output(lambda x: points.row(response(x)), points.row(points.response), free)
    # Points over frequency are not a record in time, and often few: do not let the robust deviations be smaller.
    output_fit = replace(output_fit, robust_deviations=np.maximum(output_fit.deviations, output_fit.robust_deviations))
    best = output_fit.parameters
    predicted = response(best)
    fit = fit_percent(points.speed(points.response), points.speed(predicted))
    usable = fit > 0.5 * EXPLAINED
    findings = [finding("CL537", points=points.left_out)] if points.left_out else []
    for name, value in best.items():
        deviation = output_fit.deviation(name)
        if name == "delay" and value < 1e-3 * points.period:
            findings.append(finding("CL528", "delay"))
        elif name in output_fit.at_bound:
            findings.append(finding("CL527", name, value=value))
            usable = usable and name not in VITAL
        elif not (name == "delay" and deviation < points.period):
            findings += deviation_findings(name, value, deviation)
            usable = usable and (name not in VITAL or deviation < USELESS * value)
    findings += fit_findings(fit, EXPLAINED, "response")
    return DriveFit(output_fit, points.frequency, points.response, predicted, fit, usable, tuple(findings), lambda s: model(best, s))


def _with_resonance(points: _Points, fit: DriveFit, rigid: DriveFit) -> DriveFit:
    """Return the fit with findings on its resonance: whether it lies within the measured range, and whether one mass is enough."""
    x = fit.parameters
    resonance = x["resonance"] if "resonance" in x else resonances(x)[0]
    outside = not points.frequency.min() < resonance < 1.1 * points.frequency.max()
    hidden = "CL539" if "resonance" in x and "load_share" not in x else "CL540" if fit.given else ""
    n = 2 * points.frequency.size

    def criterion(fitted: DriveFit) -> float:
        left = float(np.sum((fitted.estimate.measured - fitted.estimate.predicted) ** 2))
        k = len(fitted.estimate.names) + 1
        return n * math.log(max(left / n, 1e-300)) + 2.0 * k + 2.0 * k * (k + 1) / max(n - k - 1, 1)

    needless = criterion(fit) > criterion(rigid) - 2.0
    findings = [finding("CL538", frequency=resonance)] if outside else []
    findings += [finding(code) for code in (hidden, "CL541" if needless else "") if code]
    return replace(fit, usable=fit.usable and not outside and not needless, findings=(*fit.findings, *findings))
