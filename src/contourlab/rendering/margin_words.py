"""Margins in the units that people read."""

from __future__ import annotations

import math

from contourlab.analysis.linear.margins import Margins

NOTHING = "-"


def decibel(margins: Margins | None) -> str:
    """Return a gain margin in dB; `NOTHING` where it is not known."""
    if margins is None or not margins.stable:
        return "unstable" if margins is not None else NOTHING
    return gain_words(margins.gain)


def degrees(margins: Margins | None) -> str:
    """Return a phase margin in degrees; `NOTHING` where there is none."""
    if margins is None or not margins.stable:
        return NOTHING
    return phase_words(margins.phase)


def gain_words(factor: float) -> str:
    """Return the gain margin of a stable loop, a factor, in dB."""
    return f"{20.0 * math.log10(factor):.3g} dB" if math.isfinite(factor) else "no bound"


def phase_words(angle: float) -> str:
    """Return the phase margin [rad] of a stable loop in degrees; negative: added phase lead makes the loop unstable.

    >>> phase_words(-0.25)
    '14.3 deg of lead'
    """
    if not math.isfinite(angle):
        return "no bound"
    return f"{math.degrees(abs(angle)):.3g} deg{' of lead' if angle < 0.0 else ''}"
