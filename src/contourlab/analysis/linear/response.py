"""What is said of an axis in the frequency domain."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class AxisResponse:
    """Complex responses (n_frequency,) of one axis; of a sampled loop, from samples to samples.

    Attributes
    ----------
    frequency : ndarray [rad/s]
    closed_loop : ndarray
        Position over reference, feedforward included.
    modified : ndarray
        Position over modified reference alone: what acts on position and integral, without feedforward of its derivatives.
    loop_gain : ndarray
        The loop opened at the drive, sign such that -1 is the critical point.
    compliance : ndarray [m per force unit]
        Position over load; in a sampled loop the load is held over the servo period.
    compensated : ndarray [m/s per command unit]
        Velocity over the command ahead of the observer: what the position loop sees.
    """

    frequency: Array
    closed_loop: Complex
    modified: Complex
    loop_gain: Complex
    compliance: Complex
    compensated: Complex
