"""Carrying a vector along a path: what is normal to the path before a tick is turned with it, and stays normal to it."""

from __future__ import annotations

from typing import Any

from contourlab.primitives import dot, lincomb, select

REVERSAL = 1e-6
"""1 + t0.t1 below which the path turns back on itself and no least rotation is defined."""


def turning(last: Any, tangent: Any) -> Any:
    """Return h of the least rotation from one unit tangent to the next: v -> v - (t1.v) h for a vector v at right angles to t0.

    h = (t0 + t1)/(1 + t0.t1). Where the path turns back on itself h = t1: what is normal to it stays as it is. It does so too where
    there is no last tangent yet (a vector of zeros).

    References
    ----------
    Bishop, "There is more than one way to frame a curve", American Mathematical Monthly 82 (1975).
    """
    sum_one = 1.0 + dot(last, tangent)
    back = sum_one < REVERSAL
    share = 1.0 / select(back, 1.0, sum_one)
    return lincomb(select(back, 0.0, share), last, share, tangent)


def carried(vector: Any, tangent: Any, turn: Any) -> Any:
    """Return a vector that was normal to the last tangent, turned by the rotation that `turning` gave; it is normal to the new one."""
    return lincomb(1.0, vector, -dot(tangent, vector), turn)
