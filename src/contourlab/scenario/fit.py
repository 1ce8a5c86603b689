"""Brings a part program into the travel of a machine, by scaling and moving it: only ever on request."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from contourlab.feed import route_from_program
from contourlab.geometry.box import box
from contourlab.loop import Machine
from contourlab.program import Program
from contourlab.program.moves import placed

MARGIN = 0.01
"""Of the travel, left free at either end."""


@dataclass(frozen=True)
class Fitted:
    """A program that has been brought into a machine's travel.

    Parameters
    ----------
    program : Program
    scale : float, in (0, 1]
    shift : (x, y, z) [m]
    """

    program: Program
    scale: float
    shift: tuple[float, float, float]

    @property
    def note(self) -> str:
        """What was done, in words; empty where nothing was."""
        if self.scale == 1.0 and not any(self.shift):
            return ""
        moved = ", ".join(f"{value * 1e3:+.6g}" for value in self.shift)
        size = "" if self.scale == 1.0 else f"scaled by {self.scale:.6g}, then "
        return f"fitted into the machine's travel: {size}moved by ({moved}) mm"


def fitted(program: Program, letters: Sequence[str], machine: Machine) -> Fitted:
    """Return a program that lies within the travel of a machine.

    Parameters
    ----------
    program : Program
    letters : sequence of str
        The address that each axis of the machine obeys.
    machine : Machine

    Returns
    -------
    Fitted
        Untouched where it fits as it is; else made smaller by one factor for all axes where it is too large, and moved no further than
        needed. Feedrates stay as they are.

    Raises
    ------
    ProgramError
        If the program moves an axis that the machine lacks.
    """
    low, high = box(route_from_program(program, letters).path)
    travel = np.array([axis.limits.travel for axis in machine.axes], dtype=np.float64)
    room = travel[:, 1] - travel[:, 0]
    least, most = travel[:, 0], travel[:, 1]
    if np.all(low >= least) and np.all(high <= most):
        return Fitted(program, 1.0, (0.0, 0.0, 0.0))
    margin = np.where(np.isfinite(room), MARGIN * room, 0.0)
    least, most = least + margin, most - margin
    size = high - low
    ratios = np.divide(most - least, size, out=np.full(size.shape, np.inf), where=size > 0.0)
    scale = float(min(1.0, ratios.min()))
    moved = np.maximum(least - scale * low, 0.0) + np.minimum(most - scale * high, 0.0)
    shift = dict(zip(letters, moved.tolist(), strict=True))
    x, y, z = (shift.get(letter, 0.0) for letter in "xyz")
    return Fitted(placed(program, scale, (x, y, z)), scale, (x, y, z))
