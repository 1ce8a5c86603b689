"""Feed: from a path with its programmed feed and the limits of the axes to a sampled reference.

Inside: `limits`; `route` (path and feed data); `bounds` (limits of axes -> limits along the path), `pieces` (where one
set of them holds), `scurve` (speed changes in closed form), `profile` (spans of constant jerk), `stretches`
(from stop to stop), `smooth` with its `kernels` (stretches that are not straight), `planner`; `binding` (what holds the speed); `uniform`
(the constant-frequency law); `reference` (samples on demand); `verify` (the independent judge).
"""

from contourlab.feed.binding import Binding, limiting
from contourlab.feed.blending import blended
from contourlab.feed.correspondence import Correspondence
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
