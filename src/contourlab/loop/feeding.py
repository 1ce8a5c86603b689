"""Inputs of the loop at each tick: the reference, what earlier trials have learned, and the reference of later ticks."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.arrays import BLOCK, Array
from contourlab.errors import ParameterError
from contourlab.feed import Reference, ReferenceBlock
from contourlab.loop.machine import Controller, Machine

EXTERNALS, ALONG = ("reference", "reference_velocity", "reference_acceleration"), ("arc_length", "feedrate")
"""Inputs of every loop, in the order of the table of a reference: one number for each axis, and one."""
RATE, PLANNED_TIME = "rate", "planned_time"
DECIDED = (*EXTERNALS, *ALONG, PLANNED_TIME)
"""Signals of a loop that decides the progress."""
LEARNED_COMMAND, LEARNED_REFERENCE, AHEAD = "learned_command", "learned_reference", "reference_ahead"
SOURCE_LINE, CURVATURE = "source_line", "curvature"


@dataclass(frozen=True, eq=False)
class Learned:
    """Tables that earlier trials have learned, added at each sample.

    Parameters
    ----------
    command : ndarray (n_sample, n_axis) [command unit], optional
        Added to the commands of the controllers.
    reference : ndarray (n_sample, n_axis) [m], optional
        Added to the reference positions of the controllers.

    Raises
    ------
    ParameterError
        If an array is not a matrix, or holds anything but finite real numbers.
    """

    command: Array | None = None
    reference: Array | None = None

    def __post_init__(self) -> None:
        for name in ("command", "reference"):
            if getattr(self, name) is None:
                continue
            values = np.asarray(getattr(self, name))
            if values.dtype.kind not in "fiu" or values.ndim != 2 or not np.isfinite(values).all():
                raise ParameterError(f"learned.{name}", f"{values.dtype} {values.shape}", "finite real numbers, (n_sample, n_axis)")
            object.__setattr__(self, name, values)

    def check(self, n_sample: int, n_axis: int) -> None:
        """Check that the arrays fit a motion with this number of samples and axes.

        Raises
        ------
        ParameterError
            If they do not.
        """
        for name in ("command", "reference"):
            values = getattr(self, name)
            if values is not None and values.shape != (n_sample, n_axis):
                raise ParameterError(f"learned.{name}", f"of shape {values.shape}", f"({n_sample}, {n_axis}), as the reference")


def decides(controller: Controller, reference: Reference) -> bool:
    """Return whether the coupling of a controller decides the progress along a reference; not along one that a loop has decided."""
    return controller.coupling is not None and controller.coupling.gives(RATE) and not reference.decided


class Feed:
    """The externals of a run, block by block.

    Parameters
    ----------
    machine, controller, reference
        What runs.
    fill : callable, optional
        How planned samples are computed; as of `Reference.block`.
    deciding : bool
        Whether the caller can run a loop that decides its progress.

    Attributes
    ----------
    decides : bool
        Whether the coupling decides the progress.

    Raises
    ------
    ParameterError
        If the reference is sampled at another period, learned tables do not fit, or the coupling decides and the caller is not `deciding`.
    """

    def __init__(
        self, machine: Machine, controller: Controller, reference: Reference, learned: Learned | None, fill: Any, deciding: bool = False
    ) -> None:
        if not math.isclose(reference.servo_period, machine.servo_period, rel_tol=1e-9):
            asked = f"{machine.servo_period:g} s, the servo period of the machine"
            raise ParameterError("reference", f"sampled at {reference.servo_period:g} s", asked)
        if learned is not None:
            learned.check(reference.n_sample, reference.n_axis)
        self.reference, self.learned, self._fill = reference, learned, fill
        coupling = controller.coupling
        self.decides = decides(controller, reference)
        if coupling is not None and self.decides and (learned is not None or not deciding):
            bound = "one without the output rate: here the motion must be known; take simulate(...).motion as the reference"
            raise ParameterError("controller.coupling", f'"{coupling.kind}"', bound)
        axes = [controller.axes[name] for name in machine.axis_names if name in controller.axes]
        ahead = [axis.feedforward for axis in axes]
        self.ahead = tuple(0 if part is None else part.ahead(machine.servo_period) for part in ahead)
        fed = {
            LEARNED_COMMAND: learned is not None and learned.command is not None,
            LEARNED_REFERENCE: learned is not None and learned.reference is not None,
            AHEAD: any(part is not None and part.takes(AHEAD) for part in ahead),
            SOURCE_LINE: any(axis.supervisor is not None and axis.supervisor.takes(SOURCE_LINE) for axis in axes),
            CURVATURE: coupling is not None and coupling.takes(CURVATURE),
        }
        self.names = tuple(name for name, wanted in fed.items() if wanted)

    def size(self, name: str) -> int:
        """Return the size of the port of an input."""
        return 0 if name == CURVATURE else self.reference.n_axis

    def first(self, size: int = BLOCK, *, moving: bool = False) -> dict[str, Any]:
        """Return what the first block tells `contourlab.loop.template.build`; axes that are `moving` start at the reference's velocity."""
        first, _ = self.block(0, min(size, self.reference.n_sample))
        speed = first.velocity[0] if moving else None
        return {"start": first.position[0], "progress": float(first.arc_length[0]), "velocity": speed}

    def block(self, start: int, stop: int) -> tuple[ReferenceBlock, Array]:
        """Return all inputs of a block: (n, n_external), each signal contiguous."""
        asked = self.reference.block(start, stop, self._fill)
        if not self.names:
            return asked, asked.table
        rows = [asked.table.T]
        for name in self.names:
            if name == AHEAD:
                rows.append(self._coming(start, stop).T)
            elif name == SOURCE_LINE:
                rows.append(np.tile(self.reference.source_line(asked.arc_length).astype(float), (self.reference.n_axis, 1)))
            elif name == CURVATURE:
                rows.append(self.reference.path.curvature(asked.arc_length)[None, :])
            else:
                rows.append(getattr(self.learned, name.removeprefix("learned_"))[start:stop].T)
        return asked, np.concatenate(rows).T

    def _coming(self, start: int, stop: int) -> Array:
        """Return the reference positions of later ticks; the last position holds beyond the end."""
        far = min(stop + max(self.ahead), self.reference.n_sample)
        position = self.reference.block(start, far, self._fill).position
        index = np.arange(stop - start)
        return np.column_stack([position[np.minimum(index + ticks, far - start - 1), j] for j, ticks in enumerate(self.ahead)])
