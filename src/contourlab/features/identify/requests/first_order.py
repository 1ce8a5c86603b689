"""Model ``first-order``: gain and damping of an axis in open loop."""

from __future__ import annotations

from contourlab.features.identify.finding import Finding
from contourlab.features.identify.first_order import identify_open_loop
from contourlab.features.identify.requests.request import Request


def study(request: Request) -> Finding:
    """Identify a, b, friction, offset and delay of an axis from its command and position."""
    return identify_open_loop(request.record())
