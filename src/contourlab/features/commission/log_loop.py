"""The closed position loop of an axis as its control counts it, from commanded and actual position.

The reference r of the log counts a delay D later. The loop is T v' + v = V(t - h), V = K_v (e + i integral of e) + w r', e = r - p, less
friction. In steady motion without an integral the following error is v (D + (1 - w)/K_v): this time F is what a control shows as velocity
over following error, and the log determines it best. An integral takes it away as full feedforward does: without dead time, w = 1 and
T = 1/K are the same as an integral K_v, gain K, w = 0 and no lag. Both are fitted. Dead time h in the loop and delay D before it hide
each other: the loop is fitted with several h, and all that explain the log count. With the speed that the drive was asked for, K_v
follows from that.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from contourlab.analysis.identification.least_squares import FADED, PARTS, Bounds, Free, OutputFit, fit_output, memory, parted
from contourlab.arrays import Array
from contourlab.errors import ParameterError, refuse
from contourlab.features.commission.identification import LEAST
from contourlab.features.identify.position_loop import counting, reverses, run_in
from contourlab.features.identify.records import AxisRecord
from contourlab.figures import grouped
from contourlab.native.kernel import kernel

STEP = 5e-4
"""Longest step of the simulated loop [s]."""
TICKS = (1e-3, 2e-3)
"""Usual ticks of controls [s]: the shortest and the longest; a log is no faster than its control."""
DEAD_TIMES = (0.0, 1.0, 2.0, 3.0, 4.0)
"""Dead times in the loop that are tried [ticks]."""
EARLY = (0, 1, -1, 0, 0)
"""How much earlier than the error the feedforward acts [ticks], for each kind of loop. All are tried: the same delay of the log hides
each of them."""
BALANCED, INTEGRAL = 3, 4
"""The last kinds: the position controller sees a delayed reference, which the feedforward is not; the position controller has an
integral."""
SHARES = (0.0, 0.5, 1.0)
"""Velocity feedforward at which the fit starts."""
AS_GOOD = 4.0
"""Rise of the sum of squares, in variances of independent samples, up to which a dead time explains the log as well."""
FLOOR = 0.002
"""Share of the following error that no simple loop explains: dead times that leave less count as well."""
TICK = 0.25
"""Deviation of the instants within a period at which a control reads, computes and acts [samples]."""
FAR = 1e6
"""No axis gets as far [m]."""
ROWS = 2000
"""Blocks of a log, at the least: each is a row of the fit."""
CLOCK = 1e-3
"""Deviation of the instants of a log [samples]."""
RESET = {"reset": Free(5.0, 0.0, 300.0, 5.0)}
"""Integral gain over proportional gain [1/s]."""
SURE = 2.0
"""Deviations in an interval of 95 %."""


@kernel("f8[:] f8[:] f8 f8 f8 f8 f8 f8 f8 i8 f8[:] f8[:]")
def _follow(
    r: Array,
    seen: Array,
    step: float,
    gain: float,
    reset: float,
    weight: float,
    lag: float,
    late: float,
    held: float,
    early: int,
    asked: Array,
    p: Array,
) -> None:
    """Follow a reference from its first velocity; the position controller has it as `seen`, `late` is the dead time in steps."""
    whole = int(late)
    part, fade = late - whole, math.exp(-step / lag)
    first = (r[1] - r[0]) / step
    v, summed = first, 0.0
    p[0] = seen[0] - (1.0 - weight) * first / gain
    for k in range(r.size - 1):
        ahead = min(max(k + early, 0), r.size - 2)
        summed += reset * step * (seen[k] - p[k])
        asked[k] = gain * (seen[k] - p[k] + summed) + weight * (r[ahead + 1] - r[ahead]) / step
        newer = asked[k - whole] if k >= whole else first
        older = asked[k - whole - 1] if k > whole else first
        wanted = (1.0 - part) * newer + part * older
        pull = v if v != 0.0 else wanted if abs(wanted) > held else 0.0
        way = 1.0 if pull > 0.0 else -1.0 if pull < 0.0 else 0.0
        target = wanted - held * way if way != 0.0 else 0.0
        later = target + (v - target) * fade
        if held > 0.0 and v * later < 0.0:
            later = 0.0
        p[k + 1] = p[k] + step * target + lag * (v - later)
        v = later


@dataclass(frozen=True, eq=False)
class _Loop:
    """The loop along the commanded positions of a log; `motion` are the samples that count."""

    record: AxisRecord
    motion: slice

    @cached_property
    def fine(self) -> tuple[int, Array]:
        """Steps in a sample, and the reference at each, from its run-in on."""
        asked = run_in(self.record.asked(), self.record.period)
        steps = math.ceil(self.record.period / STEP)
        return steps, np.interp(np.arange((asked.size - 1) * steps + 1) / steps, np.arange(asked.size), asked)

    @property
    def tick(self) -> float:
        """A usual tick [s] of the control."""
        return min(max(self.record.period, TICKS[0]), TICKS[1])

    def position(self, x: Mapping[str, float], dead: float, kind: int) -> Array:
        """Return the position (n,) [m] of a loop of one of the `KINDS`."""
        (steps, r), record, n = self.fine, self.record, self.record.position.size
        step, p = record.period / steps, np.zeros(r.size)
        held = x.get("friction_offset", 0.0) * x["Kv"]
        k = np.arange(r.size, dtype=float)
        late = k - delay_of(x) / step
        seen = np.interp(late, k, r) + (r[1] - r[0]) * np.minimum(late, 0.0) if kind == BALANCED else r
        law = x["Kv"], x.get("reset", 0.0), x["velocity_feedforward"], x["lag"]
        _follow(r, seen, step, *law, dead / step, held, EARLY[kind] * round(self.tick / step), np.zeros(r.size), p)
        p = np.nan_to_num(np.clip(p, -FAR, FAR), nan=FAR)  # of an unstable loop
        return np.asarray((p if kind == BALANCED else np.interp(late, k, p))[::steps][-n:])

    def counted(self, error: Array) -> Array:
        """Return what counts of an error (n,): the motion, in means over blocks, less its mean."""
        moved = error[self.motion]
        block = max(moved.size // ROWS, 1)
        means = moved[: moved.size // block * block].reshape(-1, block).mean(axis=1)
        return np.asarray(means - means.mean())


def delay_of(x: Mapping[str, Any]) -> Any:
    """Return the delay [s] before the loop."""
    return x["following_time"] - (1.0 - x["velocity_feedforward"]) / x["Kv"]


@dataclass(frozen=True, eq=False)
class FittedLoop:
    """A fitted loop: figures with intervals, those without an integral, the share of the following error that stays, and the position (n,)
    [m] of the best fit."""

    figures: dict[str, Bounds]
    proportional: dict[str, Bounds]
    stays: float
    position: Array


class Known(NamedTuple):
    """What is known of a position controller: gain [1/s] with its deviation, and integral gain over gain [1/s]."""

    gain: float
    deviation: float
    reset: float


def fit_servo(record: AxisRecord, balanced: bool, proportional: bool, known: Known | None = None) -> FittedLoop:
    """Fit the loop of an axis.

    Parameters
    ----------
    record : AxisRecord
    balanced : bool
        Whether the control may delay what the position controller sees, to match its feedforward.
    proportional : bool
        Whether the position controller has no integral, for certain.
    known : Known, optional

    Raises
    ------
    ParameterError
        If the log does not tell the parameters apart.
    """
    asked, loop = record.asked(), _Loop(record, counting(record))
    measured, speed = loop.counted(asked - record.position), loop.counted(np.gradient(asked, record.period))
    overall = float(speed @ measured / (speed @ speed))
    behind = "one whose position comes behind its reference: the columns may be exchanged"
    refuse(overall < -2.0 * record.period, ParameterError, "log", record.axis, behind)
    free = {
        "Kv": Free(20.0, 0.5, 0.5 / record.period, 10.0),
        "following_time": Free(overall, -2.0 * record.period, 2.0, 1e-3),
        "velocity_feedforward": Free(0.5, -0.5, 1.5, 0.5),
        "lag": Free(2e-3, 1e-5, 0.1, 1e-3),
    }
    free |= {"friction_offset": Free(1e-6, 0.0, 1e-3, 1e-6)} if reverses(record) else {}
    if known is not None:
        del free["Kv"]

    def fit(start: Mapping[str, float], dead: float, kind: int, least_gain: float = 1e-8) -> OutputFit:
        every = free | (RESET if kind == INTEGRAL else {})
        begin = {name: replace(part, start=min(max(start.get(name, part.start), part.low), part.high)) for name, part in every.items()}
        return fit_output(lambda x: output(x, dead, kind), measured, begin, least_gain)

    def output(x: Mapping[str, float], dead: float, kind: int) -> Array:
        return loop.counted(asked - loop.position(whole(x), dead, kind))

    def whole(x: Mapping[str, float]) -> Mapping[str, float]:
        return {"Kv": known.gain, "reset": known.reset, **x} if known else x

    def between_parts(one: OutputFit, dead: float, kind: int, unknown: Array) -> OutputFit:
        """Return a fit with the deviations that parts of the log show, where they are larger, and an unknown part of each."""
        x, slopes, every = one.parameters, list[Array](), free | RESET
        for name in one.names:
            step = 1e-3 * every[name].scale
            up, down = (output({**x, name: x[name] + sign * step}, dead, kind) for sign in (1.0, -1.0))
            slopes.append((up - down) / (2.0 * step))
        inside = one.robust_deviations > 0.0
        shown = [parted(np.column_stack(slopes)[:, inside], one.predicted - measured, n, equal_information=True)[0] for n in PARTS]
        spread = one.robust_deviations.copy()
        spread[inside] = np.hypot(np.maximum(spread[inside], np.max(shown, axis=0)), unknown[inside])
        return replace(one, robust_deviations=spread)

    plain = [{"velocity_feedforward": w, "Kv": min(max((1.0 - w) / max(overall, 1e-4), 10.0), 100.0)} for w in SHARES]
    fits, kinds, first = list[tuple[float, OutputFit]](), list[int](), dict[str, float]()
    for kind in (*range(BALANCED), *([BALANCED] if balanced else []), *([] if known or proportional else [INTEGRAL])):
        starts = plain if kind in (0, BALANCED) else [first] if kind < BALANCED else [first, _with_integral(first)]
        start = max((fit(start, loop.tick, kind, 1e-5) for start in starts), key=lambda one: one.fit).parameters
        first = first or start
        ends = [fit(start, dead * loop.tick, kind) for dead in DEAD_TIMES]
        moved = np.gradient([end.values for end in ends], axis=0) * TICK * record.period / loop.tick
        for dead, end, slope in zip(DEAD_TIMES, ends, moved, strict=True):
            fits.append((dead * loop.tick, between_parts(end, dead * loop.tick, kind, slope)))
            kinds.append(kind)
    sums = np.array([float(np.sum((one.measured - one.predicted) ** 2)) for _, one in fits])
    best = int(np.argmin(sums))
    residual = fits[best][1].measured - fits[best][1].predicted
    position = loop.position(whole(fits[best][1].parameters), fits[best][0], kinds[best])
    moved = float(np.sqrt(np.mean(speed**2))) / whole(fits[best][1].parameters)["Kv"]
    independent = residual.size / (1 + memory(residual, FADED, residual.size // 10))
    allowed = max(sums[best] * (1.0 + AS_GOOD / independent), (FLOOR * moved) ** 2 * residual.size)
    as_good = [i for i, total in enumerate(sums) if total <= allowed]
    good = [pair for i, pair in enumerate(fits) if any(abs(i - j) < 2 and kinds[i] == kinds[j] for j in as_good)]
    alone = [pair for pair in good if "reset" not in pair[1].names]
    return FittedLoop(
        _figures(good, record, known), _figures(alone, record, known), math.sqrt(sums[best] / float(measured @ measured)), position
    )


def _with_integral(x: Mapping[str, float]) -> dict[str, float]:
    """Return the loop with an integral that is the same as a loop with full feedforward."""
    gain = 1.0 / x["lag"]
    return {**x, "Kv": gain, "reset": x["Kv"], "velocity_feedforward": 0.0, "lag": 0.0, "following_time": delay_of(x) + 1.0 / gain}


def _figures(fits: list[tuple[float, OutputFit]], record: AxisRecord, known: Known | None) -> dict[str, Bounds]:
    """Return figures of all fits, each between the least and the largest that one of them allows."""
    columns = list[tuple[str, tuple[float, float]]]()
    for dead, fit in fits:
        x = {"reset": 0.0} | fit.parameters | ({"Kv": known.gain, "reset": known.reset} if known else {})
        spread = dict(zip(fit.names, fit.robust_deviations.tolist(), strict=True)) | ({"Kv": known.deviation} if known else {})
        ahead = 1.0 - x["velocity_feedforward"]
        slopes = {"Kv": ahead / x["Kv"] ** 2, "following_time": 1.0, "velocity_feedforward": 1.0 / x["Kv"]}
        late = np.array([slopes.get(name, 0.0) * deviation for name, deviation in spread.items()])
        mixed, own = late[: len(fit.names)], late[len(fit.names) :]  # what is known of the gain is not of this fit
        each = {"reset": (x["reset"], 0.0)} | {name: (x[name], deviation) for name, deviation in spread.items()}
        hold = 0.5 * record.period / math.ceil(record.period / STEP)
        each["equivalent_time"] = x["lag"] + dead + hold, math.hypot(each.pop("lag")[1], TICK * record.period)
        each["delay"] = delay_of(x), math.sqrt(max(float(mixed @ fit.correlation @ mixed + own @ own), 0.0) + (TICK * record.period) ** 2)
        each["following_time"] = x["following_time"], math.hypot(each["following_time"][1], CLOCK * record.period)
        if {"Kv", "velocity_feedforward"} & {*fit.at_bound}:
            each["Kv"] = x["Kv"], math.inf
        if "friction_offset" in each:
            each["friction_offset"] = x["friction_offset"], math.hypot(each["friction_offset"][1], LEAST)
        columns += each.items()
    bounds = {}
    for name, pairs in grouped(columns).items():
        low, high = min(v - SURE * d for v, d in pairs), max(v + SURE * d for v, d in pairs)
        bounds[name] = Bounds(0.5 * (low + high), low, high)
    return bounds
