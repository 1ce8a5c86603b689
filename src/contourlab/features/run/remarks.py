"""What a case asks for that has no effect, or not the one that is meant."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from contourlab.components.supervisor.pre_routed import PreRouted
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.loop import Change, Controller, Machine


def remarks(machine: Machine, controller: Controller, reference: Reference, changes: Sequence[Change] = ()) -> Iterator[Finding]:
    """Yield what a person should know before trusting a run.

    Parameters
    ----------
    machine, controller, reference
        Of the case.
    changes : sequence of Change
        Controllers that take over on the way.
    """
    for axis in machine.axes:
        mine = controller.axes[axis.name]
        shifts = mine.compensation is not None and any(port.name == "reference_shift" for port in mine.compensation.outputs)
        if shifts and mine.feedback == "load" and axis.plant.two_sided:
            yield finding("CL101", place=f"axis {axis.name}")
        if isinstance(mine.supervisor, PreRouted):
            yield from _unreached(axis.name, mine.supervisor, reference)
    last = reference.n_sample * reference.servo_period
    for change in changes:
        if change.sample(reference.servo_period) >= reference.n_sample:
            yield finding("CL104", time=change.time, end=last)


def _unreached(name: str, supervisor: PreRouted, reference: Reference) -> Iterator[Finding]:
    if supervisor.by == "line" and not reference.source_lines.any():
        yield finding("CL102", place=f"axis {name}")
    end = float(reference.block(reference.n_sample - 1, reference.n_sample).arc_length[0])
    beyond = [place for place in supervisor.places if place > end] if supervisor.by == "arc-length" else []
    if beyond:
        yield finding("CL103", place=f"axis {name}", place_at=beyond[0], end=end)
