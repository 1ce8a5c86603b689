"""What the error at one place of a log is made of, as far as commanded and measured positions show it.

A linear lag explains most of the following error of a servo loop, e = T v + A a + F sign(v) + c, with velocity v and acceleration a of the
command. Its terms are fitted to each axis over the judged samples, and taken away one after another, in the order of
`contourlab.features.run.causes`:

1. what T v + A a leaves: friction, play, shafts, disturbance and noise act together in it. It is called *reversal* after an axis has
reversed, *breakaway* after it has started from rest, else *rest*; 2. *servo mismatch*: every axis with the lag of one of them, averaged
over the choice; 3. *lag*: a tool that is where it was commanded; 4. *planning*: the distance of the command from the programmed path.
"""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array
from contourlab.features.run.causes import FRICTION, Place, at_start, ranked
from contourlab.feed import Reference
from contourlab.metrics.figures import judged_part
from contourlab.rendering.judgement import Cause
from contourlab.result import Result

DOUBTFUL, UNLIKE = 0.1, 1e-2
"""Weight of the terms of friction, which at one speed look like lag; share of the largest term below which a term counts as none."""


def measured_causes(reference: Reference, judged: Result, sample: int) -> tuple[Cause, ...]:
    """Return the causes of the part error at a sample, largest first; their contributions add up to the error."""
    wanted, velocity = judged["reference"], judged["reference_velocity"]
    acceleration = np.gradient(velocity, judged.servo_period, axis=0)
    samples = judged_part(judged, reference).samples
    late = wanted - judged["tool_position"]
    lags = [_lag(late[samples, k], velocity[samples, k], acceleration[samples, k]) for k in range(len(judged.axes))]
    moves = [k for k in range(len(judged.axes)) if velocity[samples, k].any()]
    place, at = Place(reference, judged, sample), wanted[sample]
    terms = np.array([velocity[sample], acceleration[sample]])
    own, copies = place.at(at - (np.array(lags).T * terms).sum(axis=0)), [place.at(at - lags[k] @ terms) for k in moves]
    alike, planning = float(np.mean(copies)), place.at(at)
    name = at_start(judged, sample)
    rest = ("rest" if name == FRICTION else name, place.size - own)
    return ranked([rest, ("servo mismatch", own - alike), ("lag", alike - planning), ("planning", planning)])


def _lag(late: Array, velocity: Array, acceleration: Array) -> Array:
    """Return T [s] and A [s^2] of an axis from its following error (n,) [m]."""
    rows = np.column_stack([velocity, acceleration, np.sign(velocity), np.ones(late.size)])
    weights = np.array([1.0, 1.0, DOUBTFUL, DOUBTFUL]) / np.maximum(np.sqrt(np.mean(rows**2, axis=0)), 1e-300)
    return np.asarray((np.linalg.lstsq(rows * weights, late, rcond=UNLIKE)[0] * weights)[:2])
