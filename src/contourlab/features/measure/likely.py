"""Signals that no machine tool has, which ask whether the units of a log are right: for whoever reads one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.units import show

Array = NDArray[np.float64]
SHORT, SLOW = 1e-3, 1e-3
"""Way [m] and speed [m/s] of a whole run, both of which have to be passed for it to count as a run of a machine."""
LONG, FAST = 10.0, 5.0
"""Way [m] and speed [m/s] of one axis that next to no feed drive goes: the quickest rapids are at 4 m/s."""
PERIODS = (1e-7, 0.1)
"""Times between samples [s] that servo drives are logged at."""
APART = 2e-3
"""Seconds over which a speed is taken, at least: between samples a position's resolution would be one."""
MOSTLY = 0.99
"""Share of the samples that a run's speed is not passed at: a glitch is no speed."""


def unlikely_period(period: float, source: str) -> list[str]:
    """Return what is doubtful about the time between samples [s] of a run that is called so, in words.

    >>> unlikely_period(10.0, "the log")
    ['the log has a sample every 10 s: is the unit of the time right?']
    >>> unlikely_period(1e-3, "the log")
    []
    """
    if PERIODS[0] <= period <= PERIODS[1]:
        return []
    return [f"{source} has a sample every {period:.4g} s: is the unit of the time right?"]


def unlikely_motion(position: Array, period: float, who: str) -> list[str]:
    """Return what is doubtful about the way and the speed of a whole run, in words; nothing for a likely one.

    Parameters
    ----------
    position : ndarray (n, n_axis) [m]
        Of axes whose unit is one: the farthest and the fastest of them count.
    period : float [s]
    who : str
        What moves, such as ``"x in bench.csv"``.
    """
    way, top = float(np.ptp(position, axis=0).max()), fastest(position, period)
    if 0.0 < way < SHORT and top < SLOW:
        return [f"{who} moves by {show(way, 'um', 3)} in all, at {show(top, 'mm/s', 3)} at most: is the unit of the position right?"]
    usual = fastest(position, period, MOSTLY)
    if way > LONG or usual > FAST:
        moved = f"{show(way, 'm', 3)} in all, at {show(usual, 'm/s', 3)}"
        return [f"{who} moves by {moved}, as next to no machine tool does: are the units of position and time right?"]
    return []


def fastest(position: Array, period: float, share: float = 1.0) -> float:
    """Return the speed [m/s] of the fastest axis of positions (n, n_axis) [m], the one that a share of the samples does not pass."""
    stride = max(1, round(APART / period))
    speed = np.abs(np.diff(position[::stride], axis=0)) / (stride * period)
    return float(np.quantile(speed, share, axis=0).max()) if speed.size else 0.0


def same_column(axes: tuple[str, ...], reference: Array, position: Array, where: str = "") -> list[str]:
    """Ask about axes that move and are at their reference (n, n_axis) in every sample; `where` is said behind their names."""
    equal = (np.ptp(reference, axis=0) > 0.0) & (reference == position).all(axis=0)
    same = ", ".join(axis for axis, is_equal in zip(axes, equal, strict=True) if is_equal)
    return [f"position and reference of {same}{where} are equal in all samples: are they the same column?"] if same else []
