"""A friction curve through points of constant speed: Coulomb, viscous, Stribeck, for both directions or by direction.

Each point has its own deviation; all share a scatter between runs, fitted with the curve by maximum likelihood. The simplest model within 2
of the smallest corrected Akaike criterion is chosen (the plain criterion if three or four points are too few for the correction). Curves
with friction below zero are rejected.

References
----------
Armstrong-Helouvry, Dupont & Canudas de Wit, "A survey of models, analysis tools and compensation methods for the control of machines with
friction", Automatica 30 (1994), section 2; Burnham & Anderson, "Model Selection and Multimodel Inference", 2nd ed., section 2.4, for AICc.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.identification.output_error import fit_percent
from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.findings import Finding, finding

FEWEST = 3
"""Smallest number of points of a curve."""
WITHIN = 2.0
"""Difference of AICc within which a simpler model is chosen."""
SPEEDS = 30
"""Stribeck velocities to try; the best is then refined."""
WELL_KNOWN = 10.0
"""Relative deviation [percent] above which a parameter is poorly known."""
EXPLAINED = 75.0
"""Smallest usable fit [percent] of a curve through both directions; real axes have 95 and more."""


@dataclass(frozen=True)
class FrictionModel:
    """A friction model."""

    name: str
    viscous: bool
    stribeck: bool
    directed: bool
    coulomb: bool = True


MODELS = (
    FrictionModel("Coulomb", False, False, False),
    FrictionModel("viscous", True, False, False, coulomb=False),
    FrictionModel("Coulomb and viscous", True, False, False),
    FrictionModel("Coulomb and viscous by direction", True, False, True),
    FrictionModel("Coulomb, viscous and Stribeck", True, True, False),
    FrictionModel("Coulomb, viscous and Stribeck by direction", True, True, True),
)
"""From simple to complex."""


@dataclass(frozen=True, eq=False)
class FrictionCurve:
    """A curve through the points.

    Attributes
    ----------
    names : tuple of str
        Fc, Fv, offset; by direction Fc+, Fv+, Fc-, Fv-; with Stribeck drop (level at rest minus F_c; by direction drop+ and drop-) and
        vs [m/s].
    values, deviations : ndarray (p,)
    correlation : ndarray (p, p)
    scatter : float
        Between runs, beyond the deviations of the points.
    fit : float [percent]
    criterion : float
        AICc; infinite if there are too few points for it.
    plain_criterion : float
        AIC.
    predicted : ndarray (n,)
    """

    model: FrictionModel
    names: tuple[str, ...]
    values: Array
    deviations: Array
    correlation: Array
    scatter: float
    fit: float
    criterion: float
    plain_criterion: float
    predicted: Array

    def __getitem__(self, name: str) -> float:
        """Return a parameter by name; 0 if the model lacks it."""
        return float(self.values[self.names.index(name)]) if name in self.names else 0.0

    @property
    def rises(self) -> bool:
        """Whether friction is smallest at rest, the opposite of a Stribeck dip."""
        return sum(self.drops) < 0.0

    @property
    def name(self) -> str:
        """Name of the model, with "a rise" for "Stribeck" if friction rises from rest."""
        return self.model.name.replace("Stribeck", "a rise") if self.rises else self.model.name

    @property
    def drops(self) -> list[float]:
        """The drop from rest, or one for each direction; below 0 where friction rises."""
        return [float(value) for name, value in zip(self.names, self.values, strict=True) if name.startswith("drop")]

    def deviation(self, name: str) -> float:
        """Return the deviation of a parameter by name; 0 if the model lacks it."""
        return float(self.deviations[self.names.index(name)]) if name in self.names else 0.0

    def at(self, speed: ArrayLike) -> Array:
        """Return the command that holds a speed [m/s]."""
        v = np.atleast_1d(np.asarray(speed, dtype=float))
        linear = [i for i, name in enumerate(self.names) if name != "vs"]
        _, columns = _columns(self.model, v, self["vs"], "offset" in self.names)
        return np.asarray(columns @ self.values[linear])


@dataclass(frozen=True, eq=False)
class FrictionFit:
    """The chosen curve, all curves tried, and findings."""

    chosen: FrictionCurve
    tried: tuple[FrictionCurve, ...]
    findings: tuple[Finding, ...]
    usable: bool


def fit_friction(speed: ArrayLike, command: ArrayLike, deviation: ArrayLike) -> FrictionFit:
    """Fit all friction models and choose one.

    Parameters
    ----------
    speed : array_like (n,) [m/s]
        Signed.
    command : array_like (n,)
        Mean force or command at each speed.
    deviation : array_like (n,)
        Standard deviation of each mean.

    Raises
    ------
    ParameterError
        If there are fewer than 3 points, one is not finite or at rest, or the command helps the motion in both directions.
    """
    v, u, s = (np.asarray(values, dtype=float) for values in (speed, command, deviation))
    if v.size < FEWEST:
        raise ParameterError("speed", f"{v.size} stretches of constant speed", f"at least {FEWEST}: more runs, or longer ones")
    if not (np.isfinite(v).all() and np.isfinite(u).all() and np.isfinite(s).all() and (v != 0.0).all() and (s >= 0.0).all()):
        raise ParameterError("speed", "points", "finite, and none at rest")
    if not np.ptp(u) > 0.0:
        raise ParameterError("command", f"{u[0]:g} at every speed", "one that differs with speed or direction: is it what drives the axis?")
    ways = {float(way) for way in np.sign(v)}
    both = len(ways) == 2
    floor = 1e-6 * float(np.abs(u).max()) + 1e-300
    tried = [curve for model in MODELS if (curve := _fitted(model, v, u, np.maximum(s, floor), both)) is not None]
    sound = [curve for curve in tried if _is_friction(curve)]
    if not sound:
        raise ParameterError("command", "points", "against the motion: it helps it, so one of the two is counted the other way round")
    name, criteria = "AICc", [curve.criterion for curve in sound]
    if not all(map(math.isfinite, criteria)):
        name, criteria = "AIC", [curve.plain_criterion for curve in sound]
    at = next(i for i, value in enumerate(criteria) if value <= min(criteria) + WITHIN)
    chosen = sound[at]
    others = [f"{curve.name} {value - criteria[at]:+.1f}" for curve, value in zip(sound, criteria, strict=True) if curve is not chosen]
    choice = finding("CL543", points=v.size, model=chosen.name, criterion=name, others="; ".join(others) or "none")
    findings, usable = _curve_findings(chosen, v, both)
    return FrictionFit(chosen, tuple(tried), (choice, *findings), usable)


def _columns(model: FrictionModel, v: Array, vs: float, offset: bool) -> tuple[list[str], Array]:
    """Return names and columns of the linear parameters of a model."""
    way, bend = np.sign(v), np.exp(-((v / vs) ** 2)) if vs > 0.0 else np.zeros_like(v)
    parts: list[tuple[str, Array]] = []
    if model.directed:
        for sign, mark in ((1.0, "+"), (-1.0, "-")):
            here = (way == sign).astype(float)
            parts += [(f"Fc{mark}", way * here), (f"Fv{mark}", v * here)]
            parts += [(f"drop{mark}", way * here * bend)] if model.stribeck else []
    else:
        parts = [("Fc", way)] if model.coulomb else []
        parts += [("Fv", v)] if model.viscous else []
        parts += [("drop", way * bend)] if model.stribeck else []
        parts += [("offset", np.ones_like(v))] if offset else []
    return [name for name, _ in parts], np.column_stack([column for _, column in parts])


def _weighted(columns: Array, u: Array, s: Array, precision: float = 1e-3) -> tuple[Array, float, float]:
    """Return parameters, scatter between runs, and twice the negative log-likelihood, minimised over the scatter."""
    from scipy.optimize import minimize_scalar

    def solved(tau: float) -> tuple[Array, float]:
        variance = s**2 + tau**2
        w = 1.0 / np.sqrt(variance)
        x = np.asarray(np.linalg.lstsq(columns * w[:, None], u * w, rcond=None)[0], dtype=float)
        left = u - columns @ x
        return x, float(np.sum(np.log(2.0 * math.pi * variance) + left**2 / variance))

    top = math.log(max(float(np.abs(u).max()), 1e-300))
    scatter = minimize_scalar(lambda z: solved(math.exp(z))[1], bounds=(top - 20.0, top), method="bounded", options={"xatol": precision})
    best = math.exp(float(scatter.x))
    x, likelihood = solved(best)
    nothing = solved(0.0)
    return (nothing[0], 0.0, nothing[1]) if nothing[1] <= likelihood else (x, best, likelihood)


def _fitted(model: FrictionModel, v: Array, u: Array, s: Array, both: bool) -> FrictionCurve | None:
    """Return the curve of a model; None if it needs more points, speeds or directions."""
    if model.directed and not both:
        return None
    count = _columns(model, v, 1.0, both)[1].shape[1] + model.stribeck
    speeds = np.unique(np.round(np.abs(v) / np.abs(v).max(), 2))
    if (v.size < count + 3 and not (count <= 2 and v.size >= count + 1)) or speeds.size < 1 + model.viscous + 2 * model.stribeck:
        return None
    vs = _stribeck_velocity(model, v, u, s, both) if model.stribeck else 0.0
    names, columns = _columns(model, v, vs, both)
    x, tau, likelihood = _weighted(columns, u, s)
    slopes = columns
    if model.stribeck:
        step = 1e-4 * vs
        bend = (_columns(model, v, vs + step, both)[1] - _columns(model, v, vs - step, both)[1]) @ x / (2.0 * step)
        names, x, slopes = [*names, "vs"], np.append(x, vs), np.column_stack([columns, bend])
    covariance = np.linalg.pinv(slopes.T @ (slopes / (s**2 + tau**2)[:, None]))
    k = count + 1  # the scatter is a parameter too
    slack = v.size - k - 1
    plain = likelihood + 2.0 * k
    criterion = plain + (2.0 * k * (k + 1) / slack if slack > 0 else math.inf)
    predicted = columns @ x[: columns.shape[1]]
    # Maximum likelihood underestimates the scatter by the number of fitted parameters.
    lost = math.sqrt(v.size / max(v.size - count, 1)) if tau > 0.0 else 1.0
    deviations = lost * np.sqrt(np.maximum(np.diag(covariance), 0.0))
    size = np.sqrt(np.where(np.diag(covariance) > 0.0, np.diag(covariance), 1.0))
    correlation = covariance / np.outer(size, size)
    return FrictionCurve(model, tuple(names), x, deviations, correlation, tau, fit_percent(u, predicted), criterion, plain, predicted)


def _stribeck_velocity(model: FrictionModel, v: Array, u: Array, s: Array, both: bool) -> float:
    """Return the most likely Stribeck velocity between the slowest and the fastest points."""
    from scipy.optimize import minimize_scalar

    w = np.abs(v)

    def cost(z: float) -> float:
        return _weighted(_columns(model, v, math.exp(z), both)[1], u, s, 0.1)[2]

    places = np.linspace(math.log(0.8 * w.min()), math.log(0.7 * w.max()), SPEEDS)
    costs = [cost(float(z)) for z in places]
    i = int(np.argmin(costs))
    low, high = places[max(i - 1, 0)], places[min(i + 1, SPEEDS - 1)]
    return math.exp(float(minimize_scalar(cost, bounds=(low, high), method="bounded", options={"xatol": 1e-3}).x))


def _is_friction(curve: FrictionCurve) -> bool:
    """Return whether no Coulomb or viscous friction is below zero by more than two deviations."""
    for name in curve.names:
        if name in ("offset", "vs") or name.startswith("drop"):
            continue
        if name.startswith("Fc") and name != "Fc":  # by direction these include the offset
            continue
        if curve[name] < -2.0 * curve.deviation(name):
            return False
    return _level(curve)[0] > 0.0


def _level(curve: FrictionCurve) -> tuple[float, float]:
    """Return the mean Coulomb friction of both directions and its deviation; for a model without it, the viscous friction."""
    for name in ("Fc", "Fv"):
        if name in curve.names:
            return curve[name], curve.deviation(name)
    return 0.5 * (curve["Fc+"] + curve["Fc-"]), 0.5 * math.hypot(curve.deviation("Fc+"), curve.deviation("Fc-"))


def _curve_findings(chosen: FrictionCurve, v: Array, both: bool) -> tuple[list[Finding], bool]:
    findings, usable = [] if both else [finding("CL544")], True
    slowest = float(np.abs(v).min())
    if not chosen.model.stribeck:
        findings.append(finding("CL548", speed=slowest))
    elif len({drop < 0.0 for drop in chosen.drops}) > 1:  # one direction dips, the other rises
        findings.append(finding("CL545"))
    elif chosen.rises:
        findings.append(finding("CL546", speed=slowest))
    elif chosen["vs"] < 1.2 * slowest:
        findings.append(finding("CL547", speed=slowest))
        usable = False
    level, deviation = _level(chosen)
    if both and chosen.fit < EXPLAINED:
        findings.append(finding("CL533", fit=chosen.fit / 100.0, output="command"))
        usable = False
    if chosen.fit < EXPLAINED and level < 2.0 * deviation:
        findings.append(finding("CL549", level=level, deviation=deviation))
        usable = False
    if not chosen.model.coulomb:
        findings.append(finding("CL528", "Coulomb friction"))
    for name in chosen.names:
        value, deviation = chosen[name], chosen.deviation(name)
        if name.startswith("Fv") and value < 0.0:
            findings.append(finding("CL530", name, value=value))
        if name != "offset" and deviation > 0.01 * WELL_KNOWN * abs(value):
            share = deviation / abs(value) if value else math.inf
            findings.append(finding("CL526", name, value=value, deviation=deviation, share=share))
    return findings, usable
