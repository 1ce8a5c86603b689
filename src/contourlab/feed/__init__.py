"""Feed planning: turn a path with feedrates, and the axis limits, into a sampled reference.

`limits` and `route` are the inputs. `merging` joins short lines, `blending` rounds corners. `segments` divides the route at its stops.
`bounds`, `pieces` and `scurve` plan straight segments; `smooth`, `kernels` and `speed_profile` plan the others. `planner` combines both.
`profile` and `reference` are the outputs, `judged` the samples that count. `uniform` moves at constant speed. `binding` finds what limits
the speed. `verify` is an independent check.
"""

from contourlab.feed.binding import Binding, limiting
from contourlab.feed.blending import blended
from contourlab.feed.correspondence import Correspondence
from contourlab.feed.judged import Judged
from contourlab.feed.limits import AxisLimits
from contourlab.feed.planner import plan
from contourlab.feed.profile import Profile
from contourlab.feed.reference import Reference, ReferenceBlock
from contourlab.feed.route import Route, route_from_path, route_from_program
from contourlab.feed.uniform import uniform
from contourlab.feed.verify import LimitReport, limit_report

__all__ = [
    "AxisLimits",
    "Binding",
    "Correspondence",
    "Judged",
    "LimitReport",
    "Profile",
    "Reference",
    "ReferenceBlock",
    "Route",
    "blended",
    "limit_report",
    "limiting",
    "plan",
    "route_from_path",
    "route_from_program",
    "uniform",
]
