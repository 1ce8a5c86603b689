"""Breakaway levels from slow ramps of the command: the smallest command that moves an axis at rest.

Encoder counts and noise hide the first micrometres of a motion, so the breakaway is earlier than the first visible motion. The fit over a
window from rest to clear motion is a line (rest, drift, bending of bristles) plus a parabola and a cubic that start at an instant. The best
instant is the breakaway.

If friction drops after the breakaway, the first motion grows faster than this model. On simulated axes, bristles included, the error of the
level is then up to 2.5 percent.

References
----------
Armstrong-Helouvry, Dupont & Canudas de Wit, Automatica 30 (1994), section 2.1, for breakaway and its dependence on the ramp; Ghaffari &
Ulsoy, section III, for stiction by a slow ramp.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.identification.filtered_motion import even_record
from contourlab.analysis.identification.output_error import fit_percent
from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.findings import Finding, finding

PLAINLY = 0.1
"""Share of the largest speed on a ramp at which the axis clearly moves."""
SHORTEST = 40
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
    if not spans:
        raise ParameterError("command", "a record", "one with slow ramps from about zero: up, back to zero, down, back to zero")
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
        if peak - start >= SHORTEST and steps.max() < 0.05 * size[peak]:
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
    if float(np.abs(early[-1] - early[0])) > 0.2 * moved[last] or last < SHORTEST:
        return "the axis moves at its start, or the ramp is too fast: no rest before it"
    y, t = np.asarray(moved[: last + 1], dtype=float), np.asarray(period * np.arange(last + 1), dtype=float)
    instant, deviation, model = _onset(t, y, noise)
    # The first micrometres determine the instant best: friction at speed does not affect them.
    bent = float(np.interp(instant, t, y))
    near = max(NEARBY * max(noise, count), BENT * bent)
    short = min(last, int(np.argmax(y > near)) if np.any(y > near) else last)
    if short >= SHORTEST:
        t, y = t[: short + 1], y[: short + 1]
        instant, deviation, model = _onset(t, y, noise)
    seen = t[int(np.argmax(y > bent + CLEAR * max(noise, count)))]
    deviation = max(deviation, UNSEEN * float(seen - instant))
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

    tried = np.linspace(0.0, t[-1], INSTANTS, endpoint=False)
    costs = np.array([fitted(float(instant))[0] for instant in tried])
    best = int(np.argmin(costs))
    low, high = tried[max(best - 1, 0)], tried[min(best + 1, INSTANTS - 1)]
    fine = np.linspace(low, high, 41)
    costs = np.array([fitted(float(instant))[0] for instant in fine])
    best = int(np.argmin(costs))
    instant = float(fine[best])
    # The instant may move until the residual grows by the noise of one more sample.
    variance = max(float(costs[best]) / max(t.size - 5, 1), noise**2)
    coarse = np.array([fitted(float(tau))[0] for tau in tried])
    beyond = np.abs(tried - instant)[coarse > costs[best] + variance]
    deviation = float(beyond.min()) if beyond.size else float(t[-1])
    step = t[1] - t[0]
    return instant, max(deviation, step / math.sqrt(12.0)), fitted(instant)[1]
