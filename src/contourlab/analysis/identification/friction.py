"""Friction of an axis: the command at constant speeds, breakaway levels from slow ramps, and a curve through the points.

At constant speed the mean force is friction; over whole turns ripple averages out.

Encoder counts and noise hide the first micrometres of a motion, so the breakaway is earlier than the first visible motion. The fit over a
window from rest to clear motion is a line (rest, drift, bending of bristles) plus a parabola and a cubic that start at an instant. The best
instant is the breakaway.

If friction drops after the breakaway, the first motion grows faster than this model. On simulated axes, bristles included, the error of the
level is then up to 2.5 percent.

Each point has its own deviation; all share a scatter between runs, fitted with the curve by maximum likelihood. The simplest model within 2
of the smallest corrected Akaike criterion is chosen (the plain criterion if three or four points are too few for the correction). Curves
with friction below zero are rejected.

References ---------- Armstrong-Helouvry, Dupont & Canudas de Wit, "A survey of models, analysis tools and compensation methods for the
control of machines with friction", Automatica 30 (1994), section 2; Burnham & Anderson, "Model Selection and Multimodel Inference", 2nd
ed., section 2.4, for AICc; Ghaffari & Ulsoy, section III, for stiction by a slow ramp.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.identification.filtered_motion import even_record, require_finite
from contourlab.analysis.identification.least_squares import Estimate, correlation_of, deviation_findings, fit_findings, fit_percent
from contourlab.arrays import Array, Index, true_spans
from contourlab.errors import ParameterError, refuse
from contourlab.findings import Finding, finding

BATCHES = 8
"""Parts of a stretch; the scatter of their means gives the deviation of the mean, ripple included."""
TURN = 0.08
"""Share at the end of a straight line that may belong to the following turn."""
CHANGED, OUTLYING = 0.003, 6.0
"""A part at an end is left out if its speed differs from the median by this share of the speed, and by this multiple of the median
difference: for normal scatter, four standard deviations."""
FEWEST_SAMPLES = 40
"""Smallest number of samples of a stretch."""
DROPPED = 0.25
"""Share of a stretch at its start, dropped because the axis settles."""
TOLERANCE = 0.15
"""Largest difference of speed between the halves of the remaining stretch, as a share of the speed."""
SHORTEST_STRETCH = 0.2
"""Shortest remaining stretch [s]."""
STRAIGHTNESS = 0.02
"""Without a reference: largest distance of the position from straight lines, as a share of the whole travel."""
LEAST_TRAVEL = 4.0 * STRAIGHTNESS
"""Shortest travel of a stretch found from the position alone, as a share of the whole travel."""


@dataclass(frozen=True)
class Stretch:
    """A stretch of constant speed.

    Attributes
    ----------
    start, stop : int
        Samples.
    speed : float [m/s]
        Signed, end to end.
    command : float
        Mean.
    scatter : float
        Standard deviation of the command: ripple, oscillation and noise.
    deviation : float
        Standard deviation of the mean, from the means of parts.
    unevenness : float
        Standard deviation of the speeds of parts, over their mean.
    count : int
        Samples.
    """

    start: int
    stop: int
    speed: float
    command: float
    scatter: float
    deviation: float
    unevenness: float
    count: int
    source: str = ""


def constant_speed_stretches(
    period: float, position: Array, command: Array, reference: Array | None = None, source: str = ""
) -> list[Stretch]:
    """Return the stretches of constant speed of a record.

    Parameters
    ----------
    period : float [s]
    position : ndarray (n,) [m]
    command : ndarray (n,)
    reference : ndarray (n,) [m], optional
        If given, a stretch is a span of one reference speed, less the time to settle; otherwise it follows from the position.

    Raises
    ------
    ParameterError
        If the record is not finite.
    """
    for name, values in (("position", position), ("command", command), ("reference", position if reference is None else reference)):
        require_finite(name, values)
    shortest = max(round(SHORTEST_STRETCH / period), FEWEST_SAMPLES)
    spans = _spans_of_position(position) if reference is None else _spans_of_reference(reference, shortest)
    stretches = []
    for start, stop in spans:
        settled = start + math.ceil(DROPPED * (stop - start))
        if reference is None:
            settled, stop = _without_turns(position, settled, stop)
        places = position[settled:stop]
        if places.size < shortest:
            continue
        half = places.size // 2
        # Both halves have the same speed, other than zero.
        first, second = places[half] - places[0], places[2 * half - 1] - places[half - 1]
        if first * second > 0.0 and abs(second - first) <= TOLERANCE * abs(first + second) / 2.0:
            stretches.append(_stretch(period, position, command, settled, stop, source))
    return stretches


def _spans_of_reference(reference: Array, shortest: int) -> list[tuple[int, int]]:
    """Return the spans in which the slope of the reference over a few samples stays the same."""
    step = max(1, shortest // 8)
    slope = (reference[step:] - reference[:-step]) / step
    n = slope.size - step
    if n <= 0:
        return []
    ahead, behind = slope[step:], slope[:n]
    fastest = float(np.abs(slope).max())
    steady = (np.abs(ahead - behind) <= 1e-2 * np.abs(behind)) & (np.abs(behind) > 1e-3 * fastest)
    return [(start, stop + 2 * step - 1) for start, stop in true_spans(steady) if stop - start + 2 * step > shortest]


def _spans_of_position(position: Array) -> list[tuple[int, int]]:
    """Return the spans in which the position is a straight line over time: sides of a polygon within a tolerance of it."""
    stride = max(1, position.size // 4000)
    places = position[::stride]
    whole = float(np.ptp(places))
    if whole == 0.0:
        return []
    spans, waiting = [], [(0, places.size - 1)]
    while waiting:
        first, last = waiting.pop()
        line = np.linspace(places[first], places[last], last - first + 1)
        apart = np.abs(places[first : last + 1] - line)
        worst = int(np.argmax(apart))
        if apart[worst] > STRAIGHTNESS * whole:
            waiting += [(first + worst, last), (first, first + worst)]
        elif abs(places[last] - places[first]) > LEAST_TRAVEL * whole:
            # A corner of the polygon may lie on either side of its turn.
            spans.append((first * stride, last * stride - round(TURN * (last - first) * stride)))
    return spans


def _without_turns(position: Array, start: int, stop: int) -> tuple[int, int]:
    """Return the span without the eighths at its ends whose speed lies outside the scatter of the others.

    If an axis slows down without stopping, the corner of the polygon lies within the change of speed, and comparing halves hardly shows it.
    """
    if stop - 1 - start < BATCHES:
        return start, stop
    edges, speeds = _part_speeds(position, start, stop)
    middle = float(np.median(speeds))
    apart = np.abs(speeds - middle)
    even = np.flatnonzero(apart <= max(CHANGED * abs(middle), OUTLYING * float(np.median(apart))))
    first = int(even[0]) + (even[0] > 0)  # after a change the axis settles
    return int(edges[first]), int(edges[even[-1] + 1]) + 1


def _part_speeds(position: Array, start: int, stop: int) -> tuple[Index, Array]:
    """Return the samples at the edges of the parts of a span, and the speeds of the parts [m per sample]."""
    edges = np.linspace(start, stop - 1, BATCHES + 1).astype(np.int64)
    return edges, np.diff(position[edges]) / np.diff(edges)


def _stretch(period: float, position: Array, command: Array, start: int, stop: int, source: str) -> Stretch:
    given = command[start:stop]
    parts = np.array([part.mean() for part in np.array_split(given, BATCHES)])
    speed = float(position[stop - 1] - position[start]) / (period * (stop - 1 - start))
    unevenness = float(np.std(_part_speeds(position, start, stop)[1])) / (period * abs(speed))
    deviation = float(parts.std(ddof=1)) / math.sqrt(BATCHES)
    return Stretch(start, stop, speed, float(given.mean()), float(given.std()), deviation, unevenness, stop - start, source)


PLAINLY = 0.1
"""Share of the largest speed on a ramp at which the axis clearly moves."""
SHORTEST_RAMP = 40
"""Smallest number of samples of a ramp up to that speed."""
INSTANTS = 200
"""Instants to try in a window before the best is refined."""
BENT = 30.0
"""The final fit covers a motion up to this multiple of the travel before the breakaway (the bending of bristles)."""
UNSEEN = 0.25
"""Smallest deviation of the instant, as a share of the time from breakaway to first visible motion: the law of that motion is unknown."""
NEARBY = 30.0
"""Counts, or deviations at rest, that the final fit covers at least."""
CLEAR = 4.0
"""Counts, or deviations at rest, that a motion has to exceed."""


@dataclass(frozen=True)
class Breakaway:
    """The breakaway of an axis on one ramp.

    Attributes
    ----------
    time : float [s]
    level : float
        Command at the breakaway, with its sign.
    deviation : float
        Of the level, from the fit of the instant.
    rate : float [command/s]
        Of the ramp.
    direction : int
        1 forwards, -1 backwards.
    fit : float [percent]
        Of the motion in the window.
    """

    time: float
    level: float
    deviation: float
    rate: float
    direction: int
    fit: float


def breakaways(time: ArrayLike, command: ArrayLike, position: ArrayLike) -> tuple[list[Breakaway], list[Finding]]:
    """Return the breakaway on each slow ramp of a command.

    Parameters
    ----------
    time : array_like (n,) [s]
        Evenly spaced.
    command : array_like (n,)
        Any number of ramps up or down from about zero; the command returns to about zero before the next.
    position : array_like (n,) [m]

    Returns
    -------
    levels : list of Breakaway
    findings : list of Finding
        Ramps without a breakaway, and why.

    Raises
    ------
    ParameterError
        If the record is too short, uneven or not finite, has no ramp, or the axis moves on none of them.
    """
    period, (_, u, p) = even_record(time, {"command": command, "position": position})
    spans = _ramps(u)
    refuse(not spans, ParameterError, "command", "a record", "one with slow ramps from about zero: up, back to zero, down, back to zero")
    levels, findings = [], []
    for start, stop in spans:
        result = _breakaway(period, u[start : stop + 1], p[start : stop + 1], period * start)
        if isinstance(result, str):
            findings.append(finding("CL517", time=period * start, top=float(u[stop]), cause=result))
        else:
            levels.append(result)
    if not levels:
        raise ParameterError("position", "a record", "one in which the axis leaves: " + "; ".join(note.text for note in findings))
    return levels, findings


def _ramps(u: Array) -> list[tuple[int, int]]:
    """Return the spans from about zero to a peak of the command's magnitude."""
    from scipy.signal import find_peaks

    size = np.abs(u)
    top = float(size.max())
    if top == 0.0:
        return []
    peaks, _ = find_peaks(np.r_[0.0, size, 0.0], prominence=0.3 * top)
    spans = []
    for peak in peaks - 1:
        # A flat top: the ramp ends where it begins.
        while peak > 0 and size[peak - 1] >= size[peak]:
            peak -= 1
        low = np.flatnonzero((size[:peak] <= 0.02 * size[peak]) | (u[:peak] * u[peak] < 0.0))
        if not low.size:
            continue
        start = int(low[-1])
        steps = np.diff(size[start : peak + 1])
        # Exclude steps: no sample may change by more than a twentieth of the peak.
        if peak - start >= SHORTEST_RAMP and steps.max() < 0.05 * size[peak]:
            spans.append((start, int(peak)))
    return spans


def _breakaway(period: float, u: Array, p: Array, since: float) -> Breakaway | str:
    """Return the breakaway of one ramp, or why there is none."""
    way = 1.0 if u[-1] > 0.0 else -1.0
    moved = way * (p - p[0])
    window = max(3, len(p) // 200)
    speed = (moved[window:] - moved[:-window]) / (window * period)
    early = moved[: max(10, len(p) // 20)]
    steps = np.abs(np.diff(p))
    count = float(steps[steps > 0.0].min()) if steps.any() else 0.0
    noise = max(float(early.std()), count / math.sqrt(12.0))
    if moved.max() <= CLEAR * max(noise, count):
        backwards = moved.min() < -CLEAR * max(noise, count)
        return "the axis goes against the command" if backwards else "the axis does not leave: its breakaway is higher"
    plainly = PLAINLY * float(speed.max())
    passed = (speed >= plainly) & (moved[window:] > CLEAR * max(noise, count))
    last = int(np.argmax(passed)) + window
    if float(np.abs(early[-1] - early[0])) > 0.2 * moved[last] or last < SHORTEST_RAMP:
        return "the axis moves at its start, or the ramp is too fast: no rest before it"
    y, t = np.asarray(moved[: last + 1], dtype=float), np.asarray(period * np.arange(last + 1), dtype=float)
    instant, deviation, model = _onset(t, y, noise)
    # The first micrometres determine the instant best: friction at speed does not affect them.
    bent = float(np.interp(instant, t, y))
    near = max(NEARBY * max(noise, count), BENT * bent)
    short = min(last, int(np.argmax(y > near)) if np.any(y > near) else last)
    if short >= SHORTEST_RAMP:
        t, y = t[: short + 1], y[: short + 1]
        instant, deviation, model = _onset(t, y, noise)
    deviation = max(deviation, UNSEEN * float(t[int(np.argmax(y > bent + CLEAR * max(noise, count)))] - instant))
    level = float(np.interp(instant, t, u[: t.size]))
    rate = float(u[last] - u[0]) / (period * last)
    return Breakaway(since + instant, level, abs(rate) * deviation, rate, int(way), fit_percent(y, model))


def _onset(t: Array, y: Array, noise: float) -> tuple[float, float, Array]:
    """Return the instant at which the motion begins, its deviation, and the fitted motion."""
    from scipy.optimize import nnls

    def fitted(instant: float) -> tuple[float, Array]:
        after = np.maximum(t - instant, 0.0) / t[-1]
        columns = np.column_stack([np.ones_like(t), -np.ones_like(t), t / t[-1], after**2, after**3])
        columns[:, :3] *= y[-1]
        solution, left = nnls(columns, y)
        return left**2, columns @ solution

    def costs(instants: Array) -> Array:
        return np.array([fitted(float(instant))[0] for instant in instants])

    tried = np.linspace(0.0, t[-1], INSTANTS, endpoint=False)
    coarse = costs(tried)
    nearest = int(np.argmin(coarse))
    fine = np.linspace(tried[max(nearest - 1, 0)], tried[min(nearest + 1, INSTANTS - 1)], 41)
    left = costs(fine)
    best = int(np.argmin(left))
    instant = float(fine[best])
    # The instant may move until the residual grows by the noise of one more sample.
    variance = max(float(left[best]) / max(t.size - 5, 1), noise**2)
    beyond = np.abs(tried - instant)[coarse > left[best] + variance]
    deviation = float(beyond.min()) if beyond.size else float(t[-1])
    return instant, max(deviation, (t[1] - t[0]) / math.sqrt(12.0)), fitted(instant)[1]


FEWEST = 3
"""Smallest number of points of a curve."""
WITHIN = 2.0
"""Difference of AICc within which a simpler model is chosen."""
SPEEDS = 30
"""Stribeck velocities to try; the best is then refined."""
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
class FrictionCurve(Estimate):
    """A curve through the points.

    Its parameters are Fc, Fv, offset; by direction Fc+, Fv+, Fc-, Fv-; with Stribeck drop (level at rest minus F_c; by direction drop+ and
    drop-) and vs [m/s].

    Attributes
    ----------
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
    scatter: float
    fit: float
    criterion: float
    plain_criterion: float
    predicted: Array

    @property
    def level(self) -> tuple[float, float]:
        """Mean Coulomb friction of both directions and its deviation; for a model without it, the viscous friction."""
        return self.mean("Fc" if self.model.coulomb else "Fv")

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
        return [value for name, value in self.parameters.items() if name.startswith("drop")]

    def at(self, speed: ArrayLike) -> Array:
        """Return the command that holds a speed [m/s]."""
        v = np.atleast_1d(np.asarray(speed, dtype=float))
        linear = [i for i, name in enumerate(self.names) if name != "vs"]
        _, columns = _columns(self.model, v, self.parameters.get("vs", 0.0), "offset" in self.names)
        return np.asarray(columns @ self.values[linear])


@dataclass(frozen=True, eq=False)
class FrictionFit:
    """The chosen curve, all curves tried, and findings."""

    chosen: FrictionCurve
    tried: tuple[FrictionCurve, ...]
    findings: tuple[Finding, ...]
    usable: bool

    @property
    def writable(self) -> FrictionCurve | None:
        """The curve for an axis file: the chosen one, or the best one without a bend if the chosen one is below zero at rest."""
        chosen = self.chosen
        if not chosen.model.stribeck or chosen.level[0] + chosen.mean("drop")[0] >= 0.0:
            return chosen
        return min((curve for curve in self.tried if not curve.model.stribeck), key=lambda curve: curve.criterion, default=None)


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
    both = len({float(way) for way in np.sign(v)}) == 2
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
    halves = {"+": way == 1.0, "-": way == -1.0} if model.directed else {"": way != 0.0}
    parts: list[tuple[str, Array]] = []
    for mark, here in halves.items():
        parts += [(f"Fc{mark}", way * here)] if model.coulomb else []
        parts += [(f"Fv{mark}", v * here)] if model.viscous else []
        parts += [(f"drop{mark}", way * here * bend)] if model.stribeck else []
    parts += [("offset", np.ones_like(v))] if offset and not model.directed else []
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
    estimate = tuple(names), x, deviations, deviations, correlation_of(covariance)
    return FrictionCurve(*estimate, model, tau, fit_percent(u, predicted), criterion, plain, predicted)


def _stribeck_velocity(model: FrictionModel, v: Array, u: Array, s: Array, both: bool) -> float:
    """Return the most likely Stribeck velocity between the slowest and the fastest points."""
    from scipy.optimize import minimize_scalar

    w = np.abs(v)

    def cost(z: float) -> float:
        return _weighted(_columns(model, v, math.exp(z), both)[1], u, s, 0.1)[2]

    places = np.linspace(math.log(0.8 * w.min()), math.log(0.7 * w.max()), SPEEDS)
    i = int(np.argmin([cost(float(z)) for z in places]))
    low, high = places[max(i - 1, 0)], places[min(i + 1, SPEEDS - 1)]
    return math.exp(float(minimize_scalar(cost, bounds=(low, high), method="bounded", options={"xatol": 1e-3}).x))


def _is_friction(curve: FrictionCurve) -> bool:
    """Return whether no Coulomb or viscous friction is below zero by more than two deviations."""
    # By direction, Fc+ and Fc- include the offset.
    tested = [name for name in curve.names if name == "Fc" or name.startswith("Fv")]
    return not any(curve[name] < -2.0 * curve.deviation(name) for name in tested) and curve.level[0] > 0.0


def _curve_findings(chosen: FrictionCurve, v: Array, both: bool) -> tuple[list[Finding], bool]:
    slowest, findings = float(np.abs(v).min()), [] if both else [finding("CL544")]
    unseen = False
    if not chosen.model.stribeck:
        findings.append(finding("CL548", speed=slowest))
    elif len({drop < 0.0 for drop in chosen.drops}) > 1:  # one direction dips, the other rises
        findings.append(finding("CL545"))
    elif chosen.rises or (unseen := chosen["vs"] < 1.2 * slowest):
        findings.append(finding("CL546" if chosen.rises else "CL547", speed=slowest))
    level, deviation = chosen.level
    poor = fit_findings(chosen.fit, EXPLAINED, "command")
    findings += poor if both else []
    within_noise = bool(poor) and level < 2.0 * deviation
    findings += [finding("CL549", level=level, deviation=deviation)] if within_noise else []
    findings += [] if chosen.model.coulomb else [finding("CL528", "Coulomb friction")]
    for name, value in chosen.parameters.items():
        findings += [finding("CL530", name, value=value)] if name.startswith("Fv") and value < 0.0 else []
        findings += deviation_findings(name, value, chosen.deviation(name)) if name != "offset" else []
    return findings, not (unseen or within_noise or (both and poor))
