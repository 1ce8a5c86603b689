"""Model ``friction``: the friction curve out of runs at constant speeds."""

from __future__ import annotations

from contourlab.features.identify.finding import Finding
from contourlab.features.identify.friction import identify_friction
from contourlab.features.identify.requests.request import Request


def study(request: Request) -> Finding:
    """Fit a friction curve to the constant speeds of one or several logs."""
    return identify_friction(request.records(pieces=True))
