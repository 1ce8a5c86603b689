"""Feed planning: turn a path with feedrates, and the axis limits, into a sampled reference.

`route` and the limits in `bounds` are the inputs. `fitting` finds the curves behind short lines and arcs, `blending` joins other lines and
rounds corners. `pieces` divides the route, at its stops too. `bounds` plans straight segments, `smooth` with `kernels` the others;
`planner` combines both, and finds what limits the speed.
`profile` and `reference` are the outputs; `profile` holds the samples that count. `verify` is an independent check.
"""

from contourlab.feed.blending import blended
from contourlab.feed.bounds import AxisLimits
from contourlab.feed.planner import plan
from contourlab.feed.reference import Reference, ReferenceBlock, uniform
from contourlab.feed.route import Route, route_from_path, route_from_program
from contourlab.feed.verify import LimitReport, limit_report

__all__ = [
    "AxisLimits",
    "LimitReport",
    "Reference",
    "ReferenceBlock",
    "Route",
    "blended",
    "limit_report",
    "plan",
    "route_from_path",
    "route_from_program",
    "uniform",
]
