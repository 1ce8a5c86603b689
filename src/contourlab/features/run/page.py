"""Turn the outcomes of a session into the data of a report."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from contourlab.features.run.summary import Outcome
from contourlab.feed.binding import Binding, limiting
from contourlab.figures import listing
from contourlab.rendering.data import FeedRun, Provenance, ReportData

FEED_POINTS = 4000
PER_SPAN = 3
MOST_POINTS = 200_000
"""Above, only the start of each span is evaluated."""
_HELD_BY = {
    Binding.REST: "at rest",
    Binding.FEEDRATE: "programmed feed",
    Binding.VELOCITY: "axis velocity",
    Binding.ACCELERATION: "axis acceleration",
    Binding.JERK: "axis jerk",
    Binding.CURVATURE_STEP: "curvature step",
    Binding.PLANNER: "near a slow section",
}


def report_data(title: str, outcomes: Sequence[Outcome], *, scenario: str, command: str) -> ReportData:
    """Return the data of a report on outcomes (at least one) along one path; `scenario` is TOML, `command` as typed."""
    first = outcomes[0]
    again = "save the scenario below as scenario.toml, then: contourlab run scenario.toml"
    provenance = Provenance(command, again, scenario, first.case.seed)
    notes = [*first.case.notes]
    others = [outcome.name for outcome in outcomes if outcome.reference.digest != first.reference.digest]
    if others:
        notes.append(f"The planned feed shown is that of {first.name}. {listing(others)}: planned differently.")
    return ReportData(title, outcomes, provenance, first.case.lines, first.case.tolerance, notes, _feed(first))


def _feed(outcome: Outcome) -> FeedRun | None:
    """Return the planned motion at even times and within each of its spans; None where it was not planned within limits."""
    reference, profile, route = outcome.reference, outcome.reference.profile, outcome.case.route()
    if profile is None or route is None:
        return None
    # Evenly over time, and within the ramps, which a rapid passes between two even places.
    ends = np.append(profile.t0[1:], profile.duration)
    per_span = PER_SPAN if PER_SPAN * ends.size <= MOST_POINTS else 1
    ramps = np.linspace(profile.t0, ends, per_span, endpoint=False).ravel()
    time = np.unique(np.concatenate([np.linspace(0.0, profile.duration, FEED_POINTS), ramps]))
    motion = profile.motion(time)
    codes = limiting(route, outcome.case.limits, profile, motion.arc_length, curvature_step=outcome.case.curvature_step)
    asked = route.feedrate[reference.path.curve_index(motion.arc_length)]
    return FeedRun(motion.arc_length, motion.speed, asked, time, codes, [_HELD_BY[code] for code in Binding])
