"""Model ``stiction``: breakaway levels out of slow ramps of the command."""

from __future__ import annotations

from contourlab.features.identify.finding import Finding
from contourlab.features.identify.requests.request import Request
from contourlab.features.identify.stiction import identify_stiction


def study(request: Request) -> Finding:
    """Find the breakaway of an axis each way, with its spread over repeats."""
    return identify_stiction(request.records(pieces=True))
