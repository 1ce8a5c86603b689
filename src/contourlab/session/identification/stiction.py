"""Model ``stiction``: breakaway levels out of slow ramps of the command."""

from __future__ import annotations

from contourlab.session.identification.request import Request
from contourlab.studies.identification.finding import Finding
from contourlab.studies.identification.stiction import identify_stiction

__all__ = ["study"]


def study(request: Request) -> Finding:
    """Find the breakaway of an axis each way, with its spread over repeats."""
    return identify_stiction(request.records(pieces=True))
