"""Write a run to a file block by block, so that memory does not grow with its length; and its switches as CSV."""

from __future__ import annotations

import csv
import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from contourlab.feed import Reference
from contourlab.loop import Change, Controller, Machine, result_of, simulate_blocks
from contourlab.loop.feeding import DECIDED, PLANNED_TIME
from contourlab.loop.progress import followed, most_samples
from contourlab.loop.simulate import diverged
from contourlab.loop.switches import RECORDED, Switches, SwitchLog
from contourlab.metrics.judge import judge
from contourlab.result import Result
from contourlab.result.atomic import replacing
from contourlab.result.stored import Stored

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
) -> None:
    """Run a machine along a reference, judge it, and write it to a NetCDF file block by block, by way of a temporary file.

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

    Raises
    ------
    DivergenceError
        If the loop runs away.
    OutputError
        If the file cannot be written. With the first samples, if the space for temporary files (``TMPDIR``) is too small for all signals:
        some 320 bytes a sample of three axes.
    """
    log = SwitchLog(controller, machine.servo_period, reference, changes)
    kept = tuple(name for name in RECORDED if log.led) if switches is not None else ()
    wanted = tuple(dict.fromkeys((*_JUDGED, *kept, *signals))) if signals else None
    result = simulate_stored(
        machine, controller, reference, scheme=scheme, seed=seed, signals=wanted, block=block, progress=progress, changes=changes
    )
    if not result.status.ok:
        raise diverged(result)
    judged = judge(result, result.motion or reference)
    judged.save(file)
    if switches is not None:
        write_switches(switches, log.add(judged))


def simulate_stored(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    *,
    scheme: str = "base",
    progress: Callable[[int], None] | None = None,
    **given: Any,
) -> Result:
    """Run block by block, and keep the signals in a temporary file: up to the failure, if the run fails.

    `given` are options of `contourlab.loop.simulate_blocks`.
    """
    # The judge will add five signals, and the tracking error of each axis.
    stored = Stored(given.get("stop") or most_samples(controller, reference), spare=8 * (5 + reference.n_axis))
    for signals, status in simulate_blocks(machine, controller, reference, **given):
        part = result_of(machine, reference, signals, status, scheme=scheme, seed=given.get("seed", 0))
        stored.append(part.signals)
        if progress is not None:
            progress(stored.stop)
    made_by = machine, controller
    if PLANNED_TIME not in stored:
        return replace(part, signals=stored, made_by=made_by)
    motion = followed(reference, {name: stored[name].data for name in DECIDED})
    attributes = {**part.attributes, "reference_digest": motion.digest}
    return replace(part, signals=stored, motion=motion, attributes=attributes, made_by=made_by)


def write_switches(file: str | Path, switches: Switches) -> None:
    """Write switches as a CSV file, whole or not at all.

    Raises
    ------
    OutputError
        If it cannot be written.
    """
    with replacing(file) as temporary, temporary.open("w", encoding="utf-8", errors="replace", newline="") as stream:
        rows = csv.writer(stream, lineterminator="\n")
        rows.writerow(SWITCH_COLUMNS)
        for each in switches.rows():
            place = f"{each.arc_length:.12g}" if math.isfinite(each.arc_length) else ""
            rows.writerow((f"{each.time:.12g}", each.sample, each.axis, each.before, each.after, each.reason, place, each.line or ""))
