"""What no axis of a machine does in its frequency response: to go against its command, or to move the further the faster it is shaken.

At low frequencies the force per velocity of an axis is B + j (M w - K/w): damping, mass, and stiffness where a spring holds it, none
below zero. A command or a position counted the other way round turns the sign of the largest of them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.identification.frequency_response import MeasuredResponse

Array = NDArray[np.float64]
COHERENT = 0.5
"""Coherence from which a point counts."""
FEWEST = 4
"""Points from which on mass and spring are told apart."""
WIDE, RISING = 5.0, 0.5
"""Ratio of frequencies over which a slope is looked at, and the slope, in powers of the frequency, of what is no axis."""


def response_doubts(measured: MeasuredResponse) -> list[str]:
    """Return what a response has that no axis has, in words; nothing for a likely one.

    Parameters
    ----------
    measured : MeasuredResponse
        Points of a coherence below one half are passed over.
    """
    h = measured.response
    good = (measured.coherence >= COHERENT) & np.isfinite(h) & (np.abs(h) > 0.0)
    f, h = measured.frequency[good], h[good]
    if not f.size:
        return []
    said = []
    if f[-1] >= WIDE * f[0] and np.polyfit(np.log(f), np.log(np.abs(h)), 1)[0] > RISING:
        said.append("the response of the position grows with frequency, as that of no axis does: are command and position exchanged?")
    elif _goes_against(f, h, measured.period):
        said.append("the axis goes against its command: one of the two is counted the other way round")
    return said


def _goes_against(f: Array, h: NDArray[np.complex128], period: float) -> bool:
    """Tell whether the largest part of the force per velocity is below zero, over the lower half of the points."""
    low = slice(None) if f.size < 2 * FEWEST else slice(f.size // 2)
    w = 2.0 * np.pi * f[low]
    # Half a sample of the hold is no property of the axis.
    force = np.exp(-0.5j * w * period) / (1j * w * h[low])
    parts = [np.ones_like(force), 1j * w] + ([-1j / w] if w.size >= FEWEST else [])
    columns = np.column_stack(parts) / np.abs(force)[:, None]
    wanted = force / np.abs(force)
    found = np.linalg.lstsq(np.vstack([columns.real, columns.imag]), np.r_[wanted.real, wanted.imag], rcond=None)[0]
    sizes = np.linalg.norm(columns, axis=0) * np.abs(found)
    return bool(found[int(np.argmax(sizes))] < 0.0)
