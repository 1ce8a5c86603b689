"""Model ``first-order``: gain and damping of an axis in open loop."""

from __future__ import annotations

from contourlab.session.identification.request import Request
from contourlab.studies.identification.finding import Finding
from contourlab.studies.identification.first_order import identify_open_loop

__all__ = ["study"]


def study(request: Request) -> Finding:
    """Identify a, b, friction, offset and delay of an axis from its command and position."""
    return identify_open_loop(request.record())
