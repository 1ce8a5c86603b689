"""The model of each axis from its logs: parameters with deviations, noise, play, and a check on the part that was not fitted."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import astuple, dataclass, field, replace
from itertools import accumulate, pairwise
from typing import TypeAlias

import numpy as np

from contourlab.analysis.identification.descent import DescentSettings, spread_starts
from contourlab.analysis.identification.first_order import first_order_start
from contourlab.analysis.identification.least_squares import Free, Model, OutputFit, arrays_of, descended
from contourlab.analysis.identification.left_over import left_over_findings
from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array, true_spans
from contourlab.errors import ParameterError
from contourlab.features.commission.loop import MOST_DELAY, AxisModel, Law, Runs, driven, run_lanes
from contourlab.features.commission.records import AxisLog
from contourlab.figures import figure
from contourlab.findings import Finding, finding

FITTED = 0.7
"""Part of the motion that is fitted; the rest checks the model."""
WELL_KNOWN = 0.1
"""Largest deviation of gain, relative to itself, with which the gains can be trusted."""
USABLE, POOR = 60.0, 95.0
"""Fit [percent] below which the model is unusable, or gets a warning."""
SHAFT = {
    "resonance": Free(60.0, 15.0, 400.0, 10.0),
    "damping_ratio": Free(0.03, 3e-3, 0.3, 0.02),
    "share": Free(0.5, 0.05, 5.0, 0.3),
    "play": Free(1e-5, 0.0, 1e-4, 1e-5),
    "behind": Free(0.5, 0.0, 1.0, 0.3),
    "damped": Free(0.5, 0.0, 1.0, 0.3),
}
"""What a second mass adds to the model."""
RESET = {"reset": Free(10.0, 0.0, 300.0, 10.0), "outside": Free(0.05, 0.0, 0.5, 0.05)}
"""What an integral in the velocity loop of a drive adds: its rate, and the part of the damping that is not of that loop."""
SEARCHES = ((4, 1.0, DescentSettings(most_iterations=20)), (2, 0.2, DescentSettings(least_gain=1e-5)))
"""Searches for a second mass: number of starts, reach, and descent from each; the later one around the end of the former."""
LIVELY, LEAST_LIVELY, NEAR = 0.2, 2000, 5
"""Part of a log, and samples at the least, that tell whether there is a second mass at all; samples around an instant for its velocity."""
SWING = 1.5
"""Range of motor minus load over the play above which the load swings."""
ALIKE = 0.25
"""Part of what a second mass explains that an end of a search may miss, and still tell how well its parameters are known."""
SURE = 0.05
"""Largest deviation of a resonance, relative to its frequency, with which it enters the model."""
SLOW = 5e-4
"""Speed [m/s] below which inertia does not matter at a reversal: the load stops, and the motor crosses the play alone."""
LEAST = 1e-7
"""Smallest deviation of play [m]: it depends on load and temperature."""
STRAIGHT = 1e-7
"""Change of the command's way in 5 ms [m] up to which its speed is constant: digits of the log."""
RUN_ON = 0.125
"""Part of the play that a load may run on behind a slow reversal: beyond it the force tells nothing."""
RAMP = 1000
"""Samples of the noise of an encoder whose noise is its counts."""
NEARLY = 0.05
"""Part of a count that a step may be off, and part of the steps that may be off by more."""
STEP = 0.05
"""Smallest part of the friction that has to return behind the play to be seen."""
Values: TypeAlias = Mapping[str, float]


def axis_of(values: Values) -> AxisModel:
    """Return the model of fitted parameters: of a velocity drive by speed, lag and lost speeds."""
    if "lag" not in values:
        return AxisModel(**values)
    rest = {name: value for name, value in values.items() if name not in ("speed", "lag", "friction", "offset", "outside")}
    damping, loop = 1.0 / values["lag"], (1.0 - values.get("outside", 0.0)) / values["lag"]
    forces = {name: damping * values[name] for name in ("friction", "offset")}
    return AxisModel(values["speed"] * loop, damping, **forces, **rest, regulated=loop)


@dataclass(frozen=True, eq=False)
class IdentifiedAxis:
    """A model with its quality.

    Attributes
    ----------
    model : AxisModel
    deviations : dict of str to float
        Of the attributes of the model.
    fit : float [percent]
    law : Law
    rest_noise : ndarray (n,) [m]
        Samples of the encoder's noise at rest; empty if none was found.
    noise : float [m]
        Its standard deviation.
    play, play_deviation : float [m]
        nan if the log has no load.
    measured, simulated : float [m]
        Largest error on the part that was not fitted.
    findings : tuple of Finding
    swings : bool
        Whether a load swings that the model leaves out: nothing is predicted of it.
    """

    model: AxisModel
    deviations: dict[str, float]
    fit: float
    law: Law
    rest_noise: Array = field(metadata=HIDDEN)
    noise: float
    play: float
    play_deviation: float
    measured: float
    simulated: float
    findings: tuple[Finding, ...] = ()
    swings: bool = False

    @property
    def usable(self) -> bool:
        """Whether no finding is an error."""
        return all(doubt.entry.severity != "error" for doubt in self.findings)

    def answers(self, unit: float) -> str:
        """Return how a velocity drive answers its output, in machine units [m]."""
        model, off = self.model, self.deviations
        lag, delay = figure(1.0 / model.damping, "ms"), figure(max(model.delay, 0.0), "ms", 2)
        reset = f" and an integral of {figure(model.reset, '1/s', 2)}" if model.reset else ""
        lag += f" +-{figure(off['lag'], 'ms', 2)}{reset} in its loop"
        return f"1 machine unit per second takes an output of {figure(model.per_speed * unit)}, with a lag of {lag} and a delay of {delay}"

    def load(self, run: Runs) -> Array:
        """Return the position of the load (n,) [m] in a traced run; nan if nothing is known of it."""
        if self.model.share or self.swings or math.isnan(self.play):
            return run.load + (0.0 if self.model.share else math.nan)
        half = 0.5 * self.play
        return np.array(list(accumulate(run.position.tolist(), lambda at, place: min(max(at, place - half), place + half))))

    def noise_like(self, command: Array, seed: int = 0) -> Array:
        """Return noise for a command (n,), drawn from the samples at rest."""
        generator = np.random.default_rng(seed)
        if self.rest_noise.size:
            return np.asarray(generator.choice(self.rest_noise, command.size))
        return np.asarray(self.noise * generator.standard_normal(command.size))


def identify_axis(logs: Sequence[AxisLog], gains: Array, law: Law, *, velocity: bool = False) -> IdentifiedAxis | Finding:
    """Identify an axis from the logs that move it; return a finding if nothing can be fitted.

    Parameters
    ----------
    logs : sequence of AxisLog
        Trimmed to the motion.
    gains : ndarray (7,)
        Gains in use, per metre.
    law : Law
    velocity : bool
        Whether the drive takes a velocity.
    """
    place, moves = f"axis {logs[0].axis}", [np.cumsum(np.abs(np.diff(log.command, prepend=log.command[:1])) > 0.0) for log in logs]
    split = [int(np.searchsorted(count, FITTED * count[-1])) + 1 for count in moves]  # samples to fit
    longest = max(range(len(logs)), key=lambda i: split[i])
    first = logs[longest]
    part = slice(0, split[longest])
    try:
        smoothing, start = first_order_start(law.period * np.arange(split[longest]), first.output[part], first.measured[part])
        fit = _refined(logs, split, law, smoothing, start, velocity=velocity)
    except ParameterError as error:
        return finding("CL887" if "counted the other way" in str(error) else "CL886", place, reason=str(error), parameters=("the axis",))
    model, count = axis_of(fit.parameters), count_of(logs)
    deviations = {name: fit.deviation(name) for name in fit.names}
    rest = np.concatenate([_noise_at_rest(log) for log in logs])
    # In motion, third differences: they nearly vanish where it is smooth.
    in_motion = float(np.median(np.abs(np.diff(first.measured, 3)))) / 0.6745 / math.sqrt(20.0)
    noise = float(rest.std()) if rest.size else in_motion
    if noise < count:  # in motion the counts are the noise
        rest, noise = count * (np.arange(RAMP) / RAMP - 0.5), count / math.sqrt(12.0)
    play, play_deviation, seen = *play_at_load(logs, model), "CL892"
    if math.isnan(play):
        play, play_deviation, seen = *lost_motion_at_motor(logs, model, noise), "CL862"
    apart = [float(np.ptp(log.measured - log.load)) for log in logs if log.load is not None]
    swings = not model.share and max(apart, default=0.0) > SWING * play + 8.0 * noise
    measured, simulated = _validated(logs, split, gains, model, law)
    findings = _quality(fit, deviations, place, law.period)
    if model.share:
        ringing = {name: fit[name] for name in ("damping_ratio", "share")}
        findings.append(finding("CL895", place, frequency=model.resonance, deviation=deviations["resonance"], **ringing))
    else:
        (position,) = driven(first.output, [model], law.period, first.measured[0], 0.0)
        speeds = [np.diff(values) / law.period for values in (first.measured - position, position)]
        findings += left_over_findings(
            place, speeds[0], first.output[1:], speeds[1], law.period, counts=count / law.period / math.sqrt(6.0)
        )
    agrees = simulated < 2.0 * measured and measured < 2.0 * simulated
    findings.append(finding("CL890" if agrees else "CL889", place, simulated=simulated, measured=measured))
    findings.append(finding("CL893", place) if math.isnan(play) else finding(seen, place, play=play, deviation=play_deviation))
    share = model.friction / model.gain / max(float(np.abs(log.output).max()) for log in logs)
    findings += [finding("CL894", place, share=share)] if share > 0.15 else []
    findings += [finding("CL896", place, delay=model.delay)] if model.delay > 1.5 * law.period else []
    return IdentifiedAxis(model, deviations, fit.fit, law, rest, noise, play, play_deviation, measured, simulated, tuple(findings), swings)


def _refined(logs: Sequence[AxisLog], split: Sequence[int], law: Law, s: int, first: Mapping[str, float], *, velocity: bool) -> OutputFit:
    """Fit the sampled axis to the velocities of all logs, differenced over s samples, from rough parameters."""

    def problem(parts: Iterable[slice]) -> tuple[Model, Array]:
        pairs = [(log.output[part], log.measured[part], _speed(log, part.start)) for log, part in zip(logs, parts, strict=True)]

        def differenced(position: Array) -> Array:
            return np.asarray(np.diff(position[..., ::s]) / (s * law.period))

        def model(points: Sequence[Values]) -> Array:
            axes = [axis_of(values) for values in points]
            return np.concatenate([differenced(driven(u, axes, law.period, x[0], speed)) for u, x, speed in pairs], axis=1)

        return model, np.concatenate([differenced(position) for _, position, _ in pairs])

    model, measured = problem(slice(0, n) for n in split)
    a = first["a"]
    size = a * float(np.sqrt(np.mean(np.concatenate([log.output[:n] for log, n in zip(logs, split, strict=True)]) ** 2)))
    free = {
        "gain": Free(a, 1e-3 * a, 1e3 * a, a),
        "damping": Free(first["b"], 0.0, 1.0 / law.period, max(first["b"], 1.0)),
        "friction": Free(max(a * first["friction"], 1e-3 * size), 0.0, 10.0 * size, 0.1 * size),
        "offset": Free(a * first["offset"], -10.0 * size, 10.0 * size, 0.1 * size),
    }
    if velocity:
        free = _as_speeds(free, law.period)
    free["delay"] = Free(0.0, -0.75 * law.period, (MOST_DELAY - 1) * law.period, law.period)
    rigid, _ = descended(model, measured, free, arrays_of(free)[:1])
    if velocity:
        regulated, _ = descended(model, measured, {**free, **RESET}, np.append(rigid.values, arrays_of(RESET)[0])[None])
        rigid, free = (regulated, {**free, **RESET}) if _explains(regulated, rigid, RESET) else (rigid, free)
    # Most axes show no second mass: the liveliest part of the log tells that in a fraction of the time.
    lively = problem(_liveliest(log, n) for log, n in zip(logs, split, strict=True))
    alone, _ = descended(*lively, free, rigid.values[None])
    part = _with_shaft(*lively, free, alone, 1)
    if not _explains(part, alone):
        return rigid
    two = _with_shaft(model, measured, free, rigid, len(SEARCHES), part.values[None, -len(SHAFT) :])
    sure = two.deviation("resonance") < SURE * two["resonance"] and 4.0 * two.deviation("share") < two["share"]
    return two if sure and _explains(two, rigid) and not {"resonance", "share"} & {*two.at_bound} else rigid


def _speed(log: AxisLog, k: int) -> float:
    """Return the velocity [m/s] at sample k; a log begins at rest."""
    return float(log.measured[k + NEAR] - log.measured[k - NEAR]) / (2 * NEAR * log.period) if k else 0.0


def _liveliest(log: AxisLog, n: int) -> slice:
    """Return the part of the first n samples, from the beginning of a motion on, in which the output changes most."""
    rests = true_spans(np.diff(log.command[:n], prepend=log.command[:1]) == 0.0)
    starts = np.array([0, *(last - NEAR for first, last in rests if first + NEAR < last < n - NEAR)])
    changes = np.cumsum(np.diff(log.output[:n], prepend=log.output[:1]) ** 2)
    ends = np.minimum(starts + max(int(LIVELY * n), LEAST_LIVELY), n - 1)
    best = int(np.argmax(changes[ends] - changes[starts]))
    return slice(int(starts[best]), int(ends[best]) + 1)


def _as_speeds(free: Mapping[str, Free], period: float) -> dict[str, Free]:
    """Return the parameters of a velocity drive to fit, from those of an axis that its output accelerates."""
    lag = 1.0 / max(free["damping"].start, 1.0)
    speed = free["gain"].start * lag
    lost = {name: Free(*(lag * value for value in astuple(free[name]))) for name in ("friction", "offset")}
    return {"speed": Free(speed, 1e-3 * speed, 1e3 * speed, speed), "lag": Free(lag, 0.1 * period, 1.0, lag), **lost}


def _explains(more: OutputFit, less: OutputFit, added: Mapping[str, Free] = SHAFT) -> bool:
    """Return whether added parameters leave a residual smaller than by chance: the criterion of Schwarz."""
    n = less.measured.size
    return 2.0 * n * math.log((100.0 - less.fit) / max(100.0 - more.fit, 1e-9)) > len(added) * math.log(n)


def _with_shaft(
    model: Model, measured: Array, free: Mapping[str, Free], rigid: OutputFit, searches: int, more: Array | None = None
) -> OutputFit:
    """Fit two masses with a shaft between them from several starts, in the first few searches; the first one has more starts if given."""
    start, low, high, _ = arrays_of(SHAFT)
    best, found = rigid, list[OutputFit]()
    for count, reach, settings in SEARCHES[:searches]:
        known = {name: best[name] for name in free}

        def left(points: Array, known: Values = known) -> Array:
            return model([{**known, **dict(zip(SHAFT, x.tolist(), strict=True))} for x in points]) - measured

        shafts = spread_starts(left, start, low, high, count, 256, reach)
        if more is not None and not found:
            shafts = np.vstack([shafts, more])
        points = np.column_stack([np.tile(list(known.values()), (len(shafts), 1)), shafts])
        end, values = descended(model, measured, {**free, **SHAFT}, points, settings)
        ends = [*(fit.values for fit in found), *values]
        found.append(end)
        best = max(found, key=lambda fit: fit.fit)
        start = best.values[-len(SHAFT) :]
        if not _explains(best, rigid):
            return best
    # Behind play a search does not always end at the same point: how far ends differ that explain nearly as much is not known better.
    off = model([dict(zip(best.names, x.tolist(), strict=True)) for x in ends]) - measured
    squares = (off**2).sum(axis=1)
    most = squares.min() * (1.0 + ALIKE * (((100.0 - rigid.fit) / (100.0 - best.fit)) ** 2 - 1.0))
    return replace(best, robust_deviations=np.hypot(best.robust_deviations, np.std(np.array(ends)[squares <= most], axis=0)))


def count_of(logs: Sequence[AxisLog]) -> float:
    """Return the least step [m] of which all positions are multiples; 0 if there is none."""
    steps = np.diff(np.unique(np.concatenate([log.measured for log in logs])))
    counts = steps / max(float(steps.min(initial=math.inf)), 1e-30)
    whole = np.abs(counts - np.round(counts)) < NEARLY
    return float(steps.sum() / np.round(counts).sum()) if whole.mean() > 1.0 - NEARLY else 0.0


def _noise_at_rest(log: AxisLog) -> Array:
    """Return the positions around their mean where the command rests, from 0.1 s after it stopped."""
    settle = round(0.1 / log.period)
    still = np.append(True, np.diff(log.command) == 0.0)
    parts = [log.measured[a + settle : b] for a, b in true_spans(still) if b - a > 2 * settle]
    window = 25

    def around(values: Array) -> Array:
        # A slow creep under the integral is no noise.
        mean = np.convolve(values, np.ones(window) / window, "valid")
        return np.asarray(values[window // 2 : window // 2 + mean.size] - mean) * math.sqrt(window / (window - 1))

    samples = np.concatenate([np.zeros(0), *(around(part) for part in parts)])
    # An axis that slips at rest leaves steps, which are no noise.
    return samples[np.abs(samples) <= 4.0 * float(np.median(np.abs(samples)))] if samples.size else samples


def _windup(model: AxisModel, friction: float) -> float:
    """Return the twist of the shaft there and back [m] under a friction behind it [m/s^2]; 0 for a rigid axis."""
    stiffness = model.share * (2.0 * math.pi * model.resonance / (1.0 + model.share)) ** 2
    return 2.0 * friction / stiffness if stiffness else 0.0


def play_at_load(logs: Sequence[AxisLog], model: AxisModel) -> tuple[float, float]:
    """Return play and deviation from motor minus load at constant speed, extrapolated to standstill; nan if the load shows none.

    There friction holds the load against the flank that pushes it; while the axis slows down, the load may lean on the other one. Where
    the load still swings, what it is off counts as deviation. Friction also winds up the shaft: by how much, depends on its part behind it.
    """
    rows, gaps, swings = list[list[float]](), list[float](), list[float]()
    for log in logs:
        if log.load is None or np.ptp(log.load) < 0.05 * np.ptp(log.measured):
            continue
        m = max(round(0.005 / log.period), 1)
        before, at, after = log.command[: -2 * m], log.command[m:-m], log.command[2 * m :]
        speed, apart = (after - before) / (2.0 * m * log.period), (log.measured - log.load)[m:-m]
        way = np.where((np.abs(after - 2.0 * at + before) < STRAIGHT) & (np.abs(speed) > 1e-6), np.sign(speed), 0.0)
        for a, b in true_spans(way):
            if b - a > 0.1 / log.period:
                part = apart[(a + b) // 2 : b]
                noise = 0.5 * float(np.mean(np.diff(part) ** 2))
                rows.append([1.0, 0.5 * way[a], float(speed[a:b].mean())])
                gaps.append(float(part.mean()))
                swings.append(math.hypot(LEAST, math.sqrt(max(float(part.var()) - noise, 0.0) + noise / part.size)))
    sides = [row[1] for row in rows]
    if min(sides.count(0.5), sides.count(-0.5)) < 2:
        return math.nan, math.nan
    swing = np.array(swings)
    inverse = np.linalg.pinv(np.array(rows) / swing[:, None]) / swing
    values = inverse @ gaps
    scatter = math.sqrt(float(np.sum(((np.array(gaps) - np.array(rows) @ values) / swing) ** 2)) / len(rows))
    windup = 0.5 * _windup(model, model.friction)
    play, deviation = values[1] - windup, math.hypot(max(scatter, 1.0) * float(np.abs(inverse[1]) @ swing), windup)
    return max(float(play), 0.0), deviation


def lost_motion_at_motor(logs: Sequence[AxisLog], model: AxisModel, noise: float) -> tuple[float, float]:
    """Return the travel after slow reversals over which the motor needs less force, and its deviation; nan if the force shows none."""
    travels, steps, turns, least, fastest = list[float](), list[float](), list[float](), 4.0 * noise, 0.0
    for log in logs:
        force, speed = _motor_force(log, model), np.diff(log.command) / log.period
        way = np.where(np.abs(speed) > 1e-6, np.sign(speed), 0.0)
        for (first, turn), (start, last) in pairwise(true_spans(way)):
            most = float(np.abs(speed[first:last]).max())
            if turn < start or not most < SLOW or not way[first] * way[turn] < 0.0 or last - turn < 0.2 / log.period:
                continue
            fastest = max(fastest, most)
            travel = way[turn] * (log.measured[turn:last] - log.measured[turn])
            moved = travel > least
            place, step = _step(travel[moved], way[turn] * force[turn:last][moved])
            travels.append(place)
            turns.append(-float(np.quantile(travel, 0.01)))
            steps.append(step / max(model.friction, 1e-12))
    if len(travels) < 4:
        return math.nan, math.nan
    place, spread, step = float(np.mean(travels)), float(np.std(travels, ddof=1)), float(np.mean(steps))
    if step < max(STEP, 4.0 * float(np.std(steps, ddof=1)) / math.sqrt(len(steps))) or spread > 0.2 * place or place < 2.0 * least:
        return math.nan, math.nan
    # Each between nothing and this: the load runs on by v^2/2 over its friction before it stops; the motor turns late, but then its force
    # rises late; friction winds up the shaft there and back.
    onward, late, windup = 0.5 * fastest**2 / (step * model.friction), float(np.mean(turns)), _windup(model, step * model.friction)
    if onward > RUN_ON * place:
        return math.nan, math.nan
    return place + 0.5 * (onward + late - windup), math.hypot(spread / math.sqrt(len(travels)), 0.5 * onward, 0.5 * late, 0.5 * windup)


def _motor_force(log: AxisLog, model: AxisModel) -> Array:
    """Return the force (n,) [m/s^2] of the motor: that of the output, less what the velocity loop of the drive takes off."""
    whole = round(max(model.delay, 0.0) / log.period)
    asked = model.gain * np.concatenate([np.full(whole, log.output[0]), log.output])[: log.output.size] - model.offset
    held = model.reset * (log.period * np.cumsum(asked) - model.regulated * (log.measured - log.measured[0]))
    padded = np.pad(log.measured, NEAR, mode="edge")
    return np.asarray(asked + held - model.regulated * (padded[2 * NEAR :] - padded[: -2 * NEAR]) / (2 * NEAR * log.period))


def _step(travel: Array, force: Array) -> tuple[float, float]:
    """Return place and height of the step of a force over the travel, by least squares."""
    order = np.argsort(travel)
    travel, force = travel[order], force[order]
    if travel.size < 50:
        return math.nan, 0.0
    k = np.arange(20, travel.size - 20)
    below = np.cumsum(force)
    total = below[-1]
    explained = below[k - 1] ** 2 / k + (total - below[k - 1]) ** 2 / (travel.size - k)
    best = int(k[np.argmax(explained)])
    return float(travel[best]), float((total - below[best - 1]) / (travel.size - best) - below[best - 1] / best)


def _validated(logs: Sequence[AxisLog], split: Sequence[int], gains: Array, model: AxisModel, law: Law) -> tuple[float, float]:
    """Return the largest error after the fitted part, measured and simulated with the gains in use."""
    measured = simulated = 0.0
    for log, n in zip(logs, split, strict=True):
        run = run_lanes(log.command, np.zeros(log.command.size), gains[None], [model], law, trace=True)
        measured = max(measured, float(np.abs(log.error[n:]).max(initial=0.0)))
        simulated = max(simulated, float(np.abs(log.command - run.position)[n:].max(initial=0.0)))
    return measured, simulated


def _quality(fit: OutputFit, deviations: Mapping[str, float], place: str, period: float) -> list[Finding]:
    gain, rate, least = ("speed", "lag", 2.0 * period) if "lag" in deviations else ("gain", "damping", 2.0)
    poor = [gain] if gain in fit.at_bound or not deviations[gain] < WELL_KNOWN * fit[gain] else []
    # Damping may be small beside the feedback; it matters as far as it changes the feedforward. A short lag is no other than a delay.
    if not deviations[rate] < max(WELL_KNOWN * fit[rate], least):
        poor.append(rate)
    findings = [finding("CL886", place, parameters=tuple(poor))] if poor else []
    if fit.fit < USABLE:
        return [*findings, finding("CL886", place, parameters=(f"the motion, of which it explains {max(fit.fit, 0.0):.3g} %",))]
    return [*findings, finding("CL888", place, fit=fit.fit / 100.0)] if fit.fit < POOR else findings
