"""A run that goes to a file as it is made, so that memory does not grow with its length."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from contourlab.errors import DivergenceError
from contourlab.features.run.switch_file import switch_file
from contourlab.feed import Reference
from contourlab.loop import Change, Controller, Machine, result_of, simulate_blocks
from contourlab.loop.switches import RECORDED, SwitchLog
from contourlab.metrics import judge
from contourlab.result import ResultWriter, Status

_JUDGED = ("tool_position", "reference", "arc_length")


def simulate_to_file(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    file: str | Path,
    *,
    signals: Sequence[str] = (),
    scheme: str = "base",
    seed: int = 0,
    block: int = 1 << 15,
    progress: Callable[[int], None] | None = None,
    changes: Sequence[Change] = (),
    switches: str | Path | None = None,
) -> Status:
    """Run a machine along a reference, judge it, and write it to a NetCDF file block by block.

    Parameters
    ----------
    machine, controller, reference
        As for `simulate`.
    file : str or Path
        Appears whole when the run has ended well, and not at all otherwise.
    signals : sequence of str
        Signals to write besides those of the judge and what it looks at; all if none is named.
    scheme : str
        Name of the result.
    seed : int
        Of all noise.
    block : int, >= 1
        Samples that are in memory at a time.
    progress : callable, optional
        Told the number of samples done.
    changes : sequence of Change
        Controllers that take over while it runs.
    switches : str or Path, optional
        File for every switch from one controller to another, with its reason (CSV); it appears as `file` does.

    Raises
    ------
    DivergenceError
        If the loop runs away.
    OutputError
        If the file cannot be written.
    """
    log = SwitchLog(controller, machine.servo_period, reference, changes)
    kept = tuple(name for name in RECORDED if log.led) if switches is not None else ()
    wanted = tuple(dict.fromkeys((*_JUDGED, *kept, *signals))) if signals else None
    empty = result_of(machine, reference, {}, Status(), scheme=scheme, seed=seed)
    start = 0
    with ExitStack() as stack:
        listed = stack.enter_context(switch_file(switches)) if switches is not None else None
        writer = stack.enter_context(ResultWriter(file, empty.header(), empty.axes, reference.n_sample))
        given: dict[str, Any] = {"seed": seed, "signals": wanted, "block": block, "changes": changes}
        for found, status in simulate_blocks(machine, controller, reference, **given):
            if not status.ok:
                raise DivergenceError(status.reason, sample=status.sample, time=status.sample * machine.servo_period, axis=status.axis)
            part = judge(result_of(machine, reference, found, status, scheme=scheme, seed=seed, start=start), reference)
            writer.append(part.signals)
            if listed is not None:
                listed.append(log.add(part))
            start += part.n_sample
            if progress is not None:
                progress(start)
    return Status()
