"""How corners are met: as the program says (G61, G61.1, G64), or one way throughout."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal, TypeAlias

import numpy as np

from contourlab.errors import FeedError
from contourlab.feed.route import Route

PathControl: TypeAlias = Literal["program", "exact_path", "exact_stop", "blend"]


def controlled(route: Route, control: PathControl, corner_tolerance: float, merge_tolerance: float | None = None) -> Route:
    """Return a route with its corners met one way throughout.

    Parameters
    ----------
    route : Route
    control : {"program", "exact_path", "exact_stop", "blend"}
        ``"program"`` leaves the route as it is; ``"exact_path"`` (G61) meets every corner exactly and stops where the direction jumps;
        ``"exact_stop"`` (G61.1) stops at the end of every curve; ``"blend"`` (G64) rounds every corner.
    corner_tolerance : float [m], >= 0
        How far a blend may leave its corner.
    merge_tolerance : float [m], >= 0, optional
        How far points of merged lines may lie off; as `corner_tolerance` where it is not given.

    Raises
    ------
    FeedError
        If the control is unknown.

    Notes
    -----
    `contourlab.feed.blended` does the rounding and the merging.
    """
    if control == "program":
        return route
    none = np.zeros(route.n_curve)
    if control == "exact_path":
        return replace(route, corner_tolerance=none, merge_tolerance=none, exact_stop=none.astype(bool))
    if control == "exact_stop":
        return replace(route, corner_tolerance=none, merge_tolerance=none, exact_stop=np.ones(route.n_curve, dtype=bool))
    if control == "blend":
        merge = corner_tolerance if merge_tolerance is None else merge_tolerance
        return replace(route, corner_tolerance=none + corner_tolerance, merge_tolerance=none + merge, exact_stop=none.astype(bool))
    raise FeedError(f"path control {control!r}: one of program, exact_path, exact_stop, blend")
