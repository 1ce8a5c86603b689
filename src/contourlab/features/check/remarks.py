"""What `run` and `check` both say about a program on a machine."""

from __future__ import annotations

from collections.abc import Iterator

from contourlab.findings import Finding, finding
from contourlab.loop import Machine


def travel_unknown(machine: Machine) -> Iterator[Finding]:
    """Yield a finding that names the axes without a travel, if there are any."""
    if unknown := [axis.name for axis in machine.axes if not axis.limits.bounded]:
        yield finding("CL479", axes=unknown, machine=machine.name)
