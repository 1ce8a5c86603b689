"""Where the stepper motors of a machine lose steps in a run."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import BLOCK
from contourlab.components.plant.stepper import Stepper
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.loop import Machine
from contourlab.result import Result


def lost_steps(machine: Machine, reference: Reference, result: Result) -> tuple[Finding, ...]:
    """Return a finding for each axis whose motor was more than two full steps from its count: there its torque pulls it away.

    The result needs the signals ``applied_command``, ``axis_position``, ``arc_length``, and ``position`` where there is a play.
    """
    findings = []
    for i, axis in enumerate(machine.axes):
        if not isinstance(axis.plant, Stepper):
            continue
        # A command is reached at the next sample; behind a play the table is off without a step lost.
        reached, last, most, sample = "position" if axis.error.backlash else "axis_position", result.n_sample - 1, 0.0, 0
        for first in range(0, last, BLOCK):
            stop = min(first + BLOCK, last)
            off = result["applied_command"][first:stop, i] - result[reached][first + 1 : stop + 1, i]
            beyond = np.flatnonzero(np.abs(off) > 2.0 * axis.plant.full_step)
            sample = sample or (first + int(beyond[0]) + 1 if beyond.size else 0)
            most = max(most, float(np.abs(off).max()))
        if sample:
            line = int(reference.source_line(result["arc_length"][sample : sample + 1])[0])
            steps = 4 * abs(round(float(off[-1]) / (4.0 * axis.plant.full_step)))
            place = f"axis {axis.name}, line {line}" if line else f"axis {axis.name}"
            where = {"time": sample * result.servo_period, "line": line}
            findings.append(finding("CL209", place=place, **where, most=most, steps=steps))
    return tuple(findings)
