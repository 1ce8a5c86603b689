"""Model ``friction``: the friction curve out of runs at constant speeds."""

from __future__ import annotations

from contourlab.session.identification.request import Request
from contourlab.studies.identification.finding import Finding
from contourlab.studies.identification.friction import identify_friction

__all__ = ["study"]


def study(request: Request) -> Finding:
    """Fit a friction curve to the constant speeds of one or several logs."""
    return identify_friction(request.records(pieces=True))
