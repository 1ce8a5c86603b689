"""Margins in the units that people read."""

from __future__ import annotations

import math

from contourlab.analysis import Margins

__all__ = ["NOTHING", "decibel", "degrees"]

NOTHING = "-"


def decibel(margins: Margins | None) -> str:
    """Return a gain margin in dB; `NOTHING` where it is not known."""
    if margins is None or not margins.stable:
        return "unstable" if margins is not None else NOTHING
    return f"{20.0 * math.log10(margins.gain):.3g} dB" if math.isfinite(margins.gain) else "no bound"


def degrees(margins: Margins | None) -> str:
    """Return a phase margin in degrees; `NOTHING` where there is none."""
    if margins is None or not margins.stable:
        return NOTHING
    return f"{math.degrees(margins.phase):.3g} deg" if math.isfinite(margins.phase) else "no bound"
