"""Where the stepper motors of a machine lose steps in a run."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from contourlab.components.plant.stepper import Stepper
from contourlab.errors import DivergenceError
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
        off = result["applied_command"][:-1, i] - result["position" if axis.error.backlash else "axis_position"][1:, i]
        beyond = np.flatnonzero(np.abs(off) > 2.0 * axis.plant.full_step)
        if beyond.size:
            sample = int(beyond[0]) + 1
            line = int(reference.source_line(result["arc_length"][sample : sample + 1])[0])
            steps = 4 * abs(round(float(off[-1]) / (4.0 * axis.plant.full_step)))
            place = f"axis {axis.name}, line {line}" if line else f"axis {axis.name}"
            where = {"time": sample * result.servo_period, "line": line}
            findings.append(finding("CL209", place=place, **where, most=float(np.abs(off).max()), steps=steps))
    return tuple(findings)


def with_lost_steps(error: DivergenceError, machine: Machine, reference: Reference, again: Callable[..., Result]) -> DivergenceError:
    """Return the error of a run, with what `lost_steps` finds before; `again` repeats the run, with options of `simulate`."""
    if not any(isinstance(axis.plant, Stepper) for axis in machine.axes):
        return error
    cut = again(on_failure="return")
    reason = "; ".join((cut.status.reason, *(each.text for each in lost_steps(machine, reference, cut))))
    return DivergenceError(reason, sample=error.sample, time=error.time, axis=error.axis)
