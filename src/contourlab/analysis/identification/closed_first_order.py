"""Identification of a' and b' of an axis behind its disturbance observer, from its closed loop with proportional position and velocity
feedback (Ghaffari & Ulsoy, eq 18): P/R = a' K_P/(s^2 + (b' + a' K_V) s + a' K_P).

The reference comes from outside and is free of the axis' noise, so that an output-error fit of the closed loop is not biased by the
feedback, as a fit from the controller's command to the velocity may be.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.analysis.identification.even_record import even_record
from contourlab.analysis.identification.first_order import EXPLAINED, FirstOrderFit
from contourlab.analysis.identification.output_error import Free, fit_output
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
WELL_KNOWN = 10.0
"""Relative deviation [percent] up to which a' or b' counts as identified."""
DAMPING_GRID, BAND_GRID = (0.3, 0.7, 1.0, 1.5, 3.0), 16


def closed_loop_position(reference: Array, period: float, gain: float, damping: float, position_gain: float, velocity_gain: float) -> Array:
    """Return the position of eq (18) at the samples, the reference held from each to the next; it starts at rest at the first reference.

    Parameters
    ----------
    reference : ndarray (n,) [m]
    period : float [s]
    gain, damping : float [m/s^2 per command, 1/s]
        a' and b'.
    position_gain, velocity_gain : float [command/m, command s/m]
        K_P and K_V.
    """
    from scipy.linalg import expm
    from scipy.signal import lfilter

    stiffness, loss = gain * position_gain, damping + gain * velocity_gain
    whole = np.zeros((3, 3))
    whole[:2] = [[0.0, 1.0, 0.0], [-stiffness, -loss, stiffness]]
    a, b = (part := expm(whole * period))[:2, :2], part[:2, 2]
    trace, determinant = float(np.trace(a)), math.exp(-loss * period)
    # Position of x+ = A x + B r as one difference equation.
    top = [0.0, float(b[0]), float(a[0, 1] * b[1] - a[1, 1] * b[0])]
    return np.asarray(reference[0] + lfilter(top, [1.0, -trace, determinant], reference - reference[0]))


def identify_closed_loop(
    time: ArrayLike, reference: ArrayLike, position: ArrayLike, position_gain: float, velocity_gain: float
) -> FirstOrderFit:
    """Find a' and b' of an axis from reference and position of its closed loop.

    Parameters
    ----------
    time : array_like (n,) [s]
        Evenly spaced, at least 50 samples.
    reference, position : array_like (n,) [m]
        The axis starts at rest where the reference is.
    position_gain : float [command/m], > 0
        K_P of the loop as it ran.
    velocity_gain : float [command s/m], >= 0
        K_V.

    Returns
    -------
    FirstOrderFit
        With a [m/s^2 per command] and b [1/s]; its `velocity` and `predicted` are positions here, its `command` is the reference.

    Raises
    ------
    ParameterError
        If a gain is out of range, the record is too short, uneven, not finite or at rest, or does not tell a' and b'.
    """
    for name, value, lowest in (("position_gain", position_gain, 1e-12), ("velocity_gain", velocity_gain, 0.0)):
        if not (math.isfinite(value) and value >= lowest):
            raise ParameterError(name, f"{value:g}", "finite and " + ("> 0" if lowest else ">= 0"))
    period, (_, r, p) = even_record(time, {"reference": reference, "position": position})
    if not (np.ptp(r) > 0.0 and np.ptp(p) > 0.0):
        raise ParameterError("reference", f"{r[0]:g} throughout", "a record in which reference and axis move")

    def model(x: Mapping[str, float]) -> Array:
        return closed_loop_position(r, period, x["a"], x["b"], position_gain, velocity_gain)

    best, least = (0.0, 0.0), math.inf
    for band in np.geomspace(2.0 / (period * r.size), 0.5 / period, BAND_GRID):
        for ratio in DAMPING_GRID:
            a = float(band**2 / position_gain)
            b = max(float(2.0 * ratio * band - a * velocity_gain), 0.0)
            cost = float(np.sum((model({"a": a, "b": b}) - p) ** 2))
            if cost < least:
                best, least = (a, b), cost
    a, b = best
    scale = max(b, 0.1 * a * velocity_gain, 1e-3 / period)
    found = fit_output(model, p, {"a": Free(a, 1e-3 * a, 1e3 * a, a), "b": Free(b, 0.0, 10.0 / period, scale)})
    said, usable = [], True
    for name in ("a", "b"):
        value, deviation = found[name], found.deviation(name)
        if name in found.at_bound or deviation > 0.5 * value:
            said.append(f"{name}' = {value:.4g} is not told by this record")
            usable = False
        elif deviation > 0.01 * WELL_KNOWN * value:
            said.append(f"{name}' = {value:.4g} is known to {100.0 * deviation / value:.2g} % only: let the reference change faster")
    if found.fit < EXPLAINED:
        said.append(f"the model explains {found.fit:.3g} % of the position: the drive saturates, or the observer is not on")
        usable = usable and found.fit > 0.5 * EXPLAINED
    return FirstOrderFit(found, np.asarray(time, dtype=float), r, 1, usable, tuple(said))
