"""Rules for zero-phase learning: how wide the average, how large the gain, and whether a second pass or a lead is needed."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.learning.learning_frequency import averaging, peak, zero_phase_factor
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Closed = Callable[[Array], Complex]
GROWTH = 1e-6
"""How far above 1 a factor may be before it is said to amplify: what is left of computing it."""


@dataclass(frozen=True)
class LearningDesign:
    """Parameters of zero-phase learning.

    Attributes
    ----------
    gain : float
        gamma.
    half_width : int
        M.
    passes : int
    lead : float [s]
    bandwidth : float [rad/s]
        First zero of the average: what lies below it is learned.
    worst_frequency : float [rad/s]
    worst_factor : float
        Largest |1 - gamma H T|. Where the loop has a delay, what lies behind the first zero is never learned with the right sign at all
        frequencies: a factor of 1.000 and a little is as good as it gets without a filter that cuts it off.
    """

    gain: float
    half_width: int
    passes: int
    lead: float
    bandwidth: float
    worst_frequency: float
    worst_factor: float


def first_zero(half_width: int, servo_period: float) -> float:
    """Return the frequency [rad/s] of the first zero of H_M, 1/((2 M + 1) T_s); the Nyquist frequency for M = 0.

    >>> round(first_zero(11, 1e-3) / (2 * math.pi), 3)
    43.478
    """
    return 2.0 * math.pi / (max(2 * half_width + 1, 2) * servo_period)


def quarter_turn(closed: Closed, servo_period: float, lead: float = 0.0) -> float:
    """Return the lowest frequency [rad/s] at which the phase of T, with a lead [s], is a quarter turn off; else the Nyquist frequency.

    Parameters
    ----------
    closed : callable
        Gives T (n,) at frequencies (n,) [rad/s].
    """
    from scipy.optimize import brentq

    top = math.pi / servo_period

    def real(w: Array) -> Array:
        return np.asarray((closed(w) * np.exp(1j * w * lead)).real)

    w = np.unique(np.concatenate([np.geomspace(1e-4 * top, top, 1500), np.linspace(1e-3 * top, top, 1500)]))
    w = np.minimum(w, top)
    wrong = np.flatnonzero(real(w) <= 0.0)
    if not wrong.size:
        return top
    i = int(wrong[0])
    # With all frequencies below it: a T that is pieced together by its phase is known by where the phase has come from.
    return float(w[0] if i == 0 else brentq(lambda x: float(real(np.append(w[:i], x))[-1]), w[i - 1], w[i]))


def largest_gain(closed: Closed, average: Callable[[Array], Complex], top: float) -> float:
    """Return the smallest 2 cos(arg H T)/|H T| up to a frequency [rad/s]: the gain at which |1 - gamma H T| reaches 1 below it."""
    w = np.linspace(1e-4 * top, top, 4001)[:-1]
    open_ = average(w) * closed(w)
    return float(np.min(2.0 * open_.real / np.maximum(np.abs(open_) ** 2, 1e-300)))


def worst_zero_phase(
    closed: Closed, servo_period: float, gain: float, half_width: int, passes: int = 1, lead: float = 0.0
) -> tuple[float, float]:
    """Return the frequency [rad/s] and value of the largest |1 - gamma H T| up to the Nyquist frequency."""
    top, n = math.pi / servo_period, 2 * half_width + 1

    def factor(w: Array) -> Array:
        return np.abs(zero_phase_factor(gain, averaging(w, servo_period, half_width, passes, lead), closed(w)))

    lobe = 2.0 * top / n
    w = np.unique(np.concatenate([np.geomspace(1e-4 * top, top, 600), np.arange(1, min(10 * n, 4000)) * lobe / 20.0]))
    w = w[w <= top]
    return peak(factor, w, factor(w))


def design_zero_phase(closed: Closed, servo_period: float, *, share: float = 0.4, growth: float = 1e-3) -> LearningDesign:
    """Return gain, half width, passes and lead by rule.

    The lead makes the frequency at which the phase of T is a quarter turn off as high as it gets; the first zero of the average lies below
    it; the gain is a share of the largest that converges below the zero; a second pass is taken where the side lobes of a single one would
    amplify. Where that is not enough, the average is made wider until no frequency grows by more than `growth` in a trial.

    Parameters
    ----------
    closed : callable
        Gives T = P C/(1 + P C), delay included, (n,) at frequencies (n,) [rad/s]; for several axes give the one with the most lag, or
        check each with `worst_zero_phase`.
    servo_period : float [s], > 0
    share : float, 0 to 1
    growth : float, > 0

    Raises
    ------
    ParameterError
        If the share or the growth is out of range.
    """
    for name, value, top in (("share", share, 1.0), ("growth", growth, math.inf)):
        if not 0.0 < value < top:
            raise ParameterError(name, f"{value:g}", f"> 0 and below {top:g}")
    leads = _leads(closed, servo_period)
    turns = [quarter_turn(closed, servo_period, lead) for lead in leads]
    # The smallest lead that is nearly as good as the best.
    best = next(i for i, turn in enumerate(turns) if turn >= 0.98 * max(turns))
    lead, turn = leads[best], turns[best]
    half_width = max(0, math.ceil(0.5 * (2.0 * math.pi / (turn * servo_period) - 1.0)))
    while True:
        made = [_design(closed, servo_period, half_width, passes, lead, share) for passes in (1, 2)]
        good = [design for design in made if design.worst_factor <= 1.0 + growth]
        if good or half_width > 100_000:
            # One pass learns more of what lies below its zero.
            return good[0] if good else min(made, key=lambda design: design.worst_factor)
        half_width = half_width + 1 + half_width // 10


def _leads(closed: Closed, servo_period: float) -> list[float]:
    """Return leads of whole periods from none to twice the delay that T has at low frequencies, a few tens of them at most."""
    w = np.array([1e-3, 2e-3]) * math.pi / servo_period
    phase = np.unwrap(np.angle(closed(w)))
    lag = max(0.0, -float(phase[1] - phase[0]) / float(w[1] - w[0]))
    most = math.ceil(2.0 * lag / servo_period)
    return [servo_period * int(n) for n in np.unique(np.linspace(0, most, min(most + 1, 24)).astype(int))]


def _design(closed: Closed, servo_period: float, half_width: int, passes: int, lead: float, share: float) -> LearningDesign:
    zero = min(first_zero(half_width, servo_period), math.pi / servo_period)
    gain = share * largest_gain(closed, lambda w: averaging(w, servo_period, half_width, passes, lead), zero)
    gain = min(max(gain, 1e-3), 1.0)
    worst = worst_zero_phase(closed, servo_period, gain, half_width, passes, lead)
    return LearningDesign(gain, half_width, passes, lead, zero, *worst)
