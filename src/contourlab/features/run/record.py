"""Write a run to a file block by block, so that memory does not grow with its length; and its switches as CSV."""

from __future__ import annotations

import csv
import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.errors import DivergenceError
from contourlab.feed import Reference
from contourlab.loop import Change, Controller, Machine, result_of, simulate_blocks
from contourlab.loop.switches import RECORDED, Switches, SwitchLog
from contourlab.metrics.judge import furthest, judge, planning_deviation
from contourlab.result import ResultWriter, Status
from contourlab.result.atomic import replacing

SWITCH_COLUMNS = ("time_s", "sample", "axis", "from", "to", "reason", "arc_length_m", "line")
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
    machine : Machine
    controller : Controller
    reference : Reference
        All three as for `simulate`.
    file : str or Path
        Written whole when the run ends well, else not at all.
    signals : sequence of str
        Signals to write besides the judge's own and its inputs; all by default.
    scheme : str
        Name of the result.
    seed : int
        Of all noise.
    block : int, >= 1
        Samples in memory at a time.
    progress : callable, optional
        Called with the number of samples done.
    changes : sequence of Change
        Controllers that take over during the run.
    switches : str or Path, optional
        CSV file for every switch of controllers, with its reason.

    Returns
    -------
    Status

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
        given: dict[str, Any] = {"seed": seed, "block": block, "changes": changes}
        errors = _largest(machine, controller, reference, given)
        for signals_of_block, status in simulate_blocks(machine, controller, reference, signals=wanted, **given):
            made = result_of(machine, reference, signals_of_block, status, scheme=scheme, seed=seed, start=start)
            part = judge(made, reference, **errors)
            writer.append(part.signals)
            if listed is not None:
                listed(log.add(part))
            start += part.n_sample
            if progress is not None:
                progress(start)
    return Status()


def _largest(machine: Machine, controller: Controller, reference: Reference, given: dict[str, Any]) -> dict[str, float]:
    """Run once without a file; return the largest tracking error and planning deviation [m], on which the judge's search depends."""
    error = planning = 0.0
    for block, status in simulate_blocks(machine, controller, reference, signals=_JUDGED, **given):
        if not status.ok:
            raise DivergenceError(status.reason, sample=status.sample, time=status.sample * machine.servo_period, axis=status.axis)
        error = max(error, furthest(block["reference"] - block["tool_position"]))
        if reference.programmed is not reference.path:
            deviation, _ = planning_deviation(reference, block["reference"], block["arc_length"])
            planning = max(planning, float(np.abs(deviation).max()))
    return {"error": error, "planning": planning}


@contextmanager
def switch_file(file: str | Path) -> Iterator[Callable[[Switches], None]]:
    """Yield what writes the switches of the next block to a CSV file, written whole when the block ends well, else not at all.

    Raises
    ------
    OutputError
        If it cannot be written.
    """
    with replacing(file) as temporary, temporary.open("w", encoding="utf-8", errors="replace", newline="") as stream:
        rows = csv.writer(stream, lineterminator="\n")
        rows.writerow(SWITCH_COLUMNS)

        def write(switches: Switches) -> None:
            for each in switches.rows():
                place = f"{each.arc_length:.12g}" if math.isfinite(each.arc_length) else ""
                rows.writerow((f"{each.time:.12g}", each.sample, each.axis, each.before, each.after, each.reason, place, each.line or ""))

        yield write
