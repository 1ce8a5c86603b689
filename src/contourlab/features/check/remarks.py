"""What `run` and `check` both say about a program on a machine."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from contourlab.findings import Finding, finding
from contourlab.program import Dwell, Move, Traverse

if TYPE_CHECKING:
    from contourlab.loop import Machine


def travel_unknown(machine: Machine) -> Iterator[Finding]:
    """Yield a finding that names the axes without a travel, if there are any."""
    if unknown := [axis.name for axis in machine.axes if not axis.limits.bounded]:
        yield finding("CL479", axes=unknown, machine=machine.name)


def path_mode_assumed(moves: Iterable[Move], tolerance: float) -> Iterator[Finding]:
    """Yield a finding for the first cut without G61 or G64, and for the first under a G64 without P, met within `tolerance` [m]."""
    modes = [(move.mode, move.source_line) for move in moves if not isinstance(move, Dwell | Traverse)]
    if line := next((line for mode, line in modes if mode.control is None), 0):
        yield finding("CL110", line=line)
    if line := next((line for mode, line in modes if mode.control == "blend" and mode.tolerance is None), 0):
        yield finding("CL111", line=line, tolerance=tolerance)
