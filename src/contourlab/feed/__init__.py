"""Feed: from a path with feedrates, and the limits of the axes, to a sampled reference.

`limits`, `route`: the inputs. `merging`, `blending`: short lines joined, corners rounded. `segments`: from stop to stop. Straight segments:
`bounds`, `pieces`, `scurve`. Others: `smooth`, `kernels`, `speed_profile`. `planner` combines both; `profile`, `reference` are the outputs.
`uniform`: constant speed. `binding`: what limits the speed. `verify`: an independent check.
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
