"""What a controller comes to, found without the lanes: a single run, the exact judge, and the exact margins."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.design.guards import Guards
from contourlab.errors import DivergenceError
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine, simulate
from contourlab.metrics import judge, summarise
from contourlab.result import Result


@dataclass(frozen=True, eq=False)
class Checked:
    """One controller.

    Attributes
    ----------
    figures : dict of str to float [SI]
        ``contour_error_integral``, ``contour_error_rms``, ``contour_error_max``, ``contour_error_signed_mean``, ``part_error_max``,
        ``tracking_error_rms``, ``command_energy`` [s], ``command_largest``, ``limited_share``; nan where the run failed.
    margins : dict of str to Margins
        By axis; none for an axis without a linear model.
    broken : tuple of str
        Bounds that are not kept, in words.
    run : Result or None
        Judged; None where it ran away.
    """

    figures: dict[str, float]
    margins: dict[str, Margins]
    broken: tuple[str, ...]
    run: Result | None


def checked(
    machine: Machine, controller: Controller, reference: Reference, guards: Guards, *, seed: int = 0, moving: bool = False
) -> Checked:
    """Run a controller once, judge it exactly, and hold it against the bounds.

    Parameters
    ----------
    machine, controller, reference
        As of `contourlab.loop.simulate`.
    guards : Guards
        Whose bounds are asked for, on this machine under this controller.
    seed : int
        Of all noise.
    moving : bool
        Whether the axes start with the velocity of the reference.
    """
    here = Guards([(machine, controller)], guards.bounds)
    try:
        run: Result | None = simulate(machine, controller, reference, seed=seed, moving=moving)
    except DivergenceError as error:
        nothing = dict.fromkeys(FIGURES, math.nan)
        return Checked(nothing, here.exact({}), (f"runs away: {error}",), None)
    assert run is not None
    judged = judge(run, reference)
    found = _figures(judged, machine, controller, reference)
    margins = here.exact({})
    return Checked(found, margins, here.broken({}, found["limited_share"], found["command_largest"], margins), judged)


FIGURES = (
    "contour_error_integral",
    "contour_error_rms",
    "contour_error_max",
    "contour_error_signed_mean",
    "part_error_max",
    "tracking_error_rms",
    "command_energy",
    "command_largest",
    "limited_share",
)


def _figures(judged: Result, machine: Machine, controller: Controller, reference: Reference) -> dict[str, float]:
    metrics = summarise(judged, reference)
    error = metrics.contour_error
    window = slice(*metrics.window)
    tracking = np.linalg.norm((judged["reference"] - judged["position"])[window], axis=1)
    return {
        "contour_error_integral": error.integral,
        "contour_error_rms": error.rms,
        "contour_error_max": error.max,
        "contour_error_signed_mean": error.signed_mean,
        "part_error_max": metrics.part_error.max,
        "tracking_error_rms": float(np.sqrt(np.mean(tracking**2))),
        **_effort(judged, machine, window),
    }


def _effort(judged: Result, machine: Machine, window: slice) -> dict[str, float]:
    """Return what is asked of the drives, as `contourlab.loop.BatchResult` has it: in parts of their limits, or by itself without one."""
    limits = np.array([getattr(axis.drive, "limit", math.inf) for axis in machine.axes], dtype=float)
    scales = np.where(np.isfinite(limits), limits, 1.0)
    asked, taken = judged["command"][window], judged["applied_command"][window]
    return {
        "command_energy": float(((taken / scales) ** 2).sum() * judged.servo_period),
        "command_largest": float((np.abs(asked) / scales).max()),
        "limited_share": float((np.abs(asked) > limits).any(axis=1).mean()),
    }
