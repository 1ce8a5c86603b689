"""One machine, one controller, one reference: the run that keeps its signals."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from contourlab.engine.runner import Group, make_group
from contourlab.errors import DivergenceError
from contourlab.feed import Reference, ReferenceBlock
from contourlab.geometry.view import PathView
from contourlab.loop.machine import Controller, Machine
from contourlab.loop.template import Loop, build
from contourlab.loop.tool import ToolPosition
from contourlab.result import Result, Signal, Status

__all__ = ["UNITS", "jit_enabled", "simulate", "simulate_blocks"]

Array = NDArray[np.float64]
BLOCK = 1 << 16

UNITS = {
    "reference": "m",
    "reference_velocity": "m/s",
    "reference_acceleration": "m/s^2",
    "arc_length": "m",
    "feedrate": "m/s",
    "position": "m",
    "axis_position": "m",
    "axis_velocity": "m/s",
    "tool_position": "m",
    "velocity": "m/s",
    "command": "command",
    "applied_command": "command",
    "modified_reference": "m",
    "disturbance_estimate": "command",
    "contour_error_estimate": "m",
}
"""Unit of each signal; "command" stands for the unit of the plants' commands."""


def jit_enabled() -> bool:
    """Tell whether steps are compiled: unless ``CONTOURLAB_JIT`` is 0."""
    return os.environ.get("CONTOURLAB_JIT", "1") != "0"


def external_rows(block: ReferenceBlock) -> Array:
    """Return what the schedule is fed with at each tick."""
    return np.column_stack([block.position, block.velocity, block.acceleration, block.arc_length])


def simulate(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    *,
    scheme: str = "base",
    seed: int = 0,
    on_failure: Literal["raise", "return"] = "raise",
    jit: bool | None = None,
    view: PathView | None = None,
    progress: Callable[[int], None] | None = None,
) -> Result:
    """Run a machine along a reference and return every signal.

    Parameters
    ----------
    machine : Machine
    controller : Controller
    reference : Reference
        Sampled at the machine's servo period.
    scheme : str
        Name of the result.
    seed : int
        Of all noise; the same seed gives the same run.
    on_failure : {"raise", "return"}
        What to do when the loop runs away.
    jit : bool, optional
        Compiled, or plain Python; by default as `jit_enabled` says.
    view : PathView, optional
        How the estimator sees the path.
    progress : callable, optional
        Told the number of samples done.

    Returns
    -------
    Result
        Signals of the samples up to the failure, if there was one.

    Raises
    ------
    DivergenceError
        If a state is not finite, or a tracking error passes the axis' following-error limit, and `on_failure` is "raise".
    """
    blocks: list[dict[str, Array]] = []
    status = Status(ok=True)
    for signals, now in simulate_blocks(machine, controller, reference, seed=seed, jit=jit, view=view):
        blocks.append(signals)
        status = now
        if progress is not None:
            progress(sum(len(b["arc_length"]) for b in blocks))
    if not status.ok and on_failure == "raise":
        raise DivergenceError(status.reason, sample=status.sample, time=status.sample * machine.servo_period, axis=status.axis)
    command_unit = machine.axes[0].plant.command_unit
    joined = {name: np.concatenate([block[name] for block in blocks]) for name in blocks[0]}
    return Result(
        scheme=scheme,
        axes=machine.axis_names,
        servo_period=machine.servo_period,
        signals={name: make_signal(name, data, command_unit) for name, data in joined.items()},
        status=status,
        attributes={"machine": machine.name, "seed": seed, "path": reference.path.digest},
    )


def make_signal(name: str, data: Array, command_unit: str) -> Signal:
    """Return an array as a labelled signal."""
    unit = UNITS[name]
    dims = ("sample", "axis") if data.ndim == 2 else ("sample",)
    return Signal(data, dims, command_unit if unit == "command" else unit)


def simulate_blocks(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    *,
    seed: int = 0,
    jit: bool | None = None,
    view: PathView | None = None,
    block: int = BLOCK,
) -> Iterator[tuple[dict[str, Array], Status]]:
    """Run block by block, so that memory does not grow with the run; yields signals and the status so far.

    The last block ends with the sample of a failure.
    """
    first = reference.block(0, 1)
    loop = build(machine, controller, reference.path, first.position[0], float(first.arc_length[0]), view=view, seed=seed)
    group = make_group(loop.schedule, 1, slice(0, 1), jit_enabled() if jit is None else jit)
    tool = ToolPosition(machine, seed)
    for start in range(0, reference.n_sample, block):
        asked = reference.block(start, min(start + block, reference.n_sample))
        saved = group.snapshot()
        signals = _run(group, loop, asked)
        status = _verdict(machine, signals, start)
        if status.ok and not group.finite().all():
            status = _first_non_finite(group, saved, loop, asked, start)
        if not status.ok:
            signals = {name: data[: status.sample - start + 1] for name, data in signals.items()}
        signals["tool_position"] = tool.of(signals["axis_position"], signals["axis_velocity"])
        yield signals, status
        if not status.ok:
            return


def _run(group: Group, loop: Loop, asked: ReferenceBlock) -> dict[str, Array]:
    """Run one block; return its signals."""
    names = [signal for signals in loop.signals.values() for signal in signals]
    log = group.run(external_rows(asked), [loop.schedule.row(name) for name in names])[:, :, 0]
    found: dict[str, Any] = {
        "reference": asked.position,
        "reference_velocity": asked.velocity,
        "reference_acceleration": asked.acceleration,
        "arc_length": asked.arc_length,
        "feedrate": asked.feedrate,
    }
    column = 0
    for name, signals in loop.signals.items():
        part = log[:, column : column + len(signals)]
        found[name] = part[:, 0] if name == "contour_error_estimate" else part
        column += len(signals)
    return {name: np.ascontiguousarray(data) for name, data in found.items()}


def _verdict(machine: Machine, signals: dict[str, Array], start: int) -> Status:
    """Return the first sample at which an axis is not finite or beyond its following-error limit."""
    limit = np.array([axis.limits.following_error for axis in machine.axes])
    error = np.abs(signals["reference"] - signals["axis_position"])
    bad = ~(error <= limit) | ~np.isfinite(signals["command"])
    if not bad.any():
        return Status(ok=True)
    sample, axis = (int(i) for i in np.argwhere(bad)[0])
    worst = error[sample, axis]
    reason = "the loop gave a number that is not finite"
    if np.isfinite(worst) and worst > limit[axis]:
        reason = f"following error {worst * 1e3:.4g} mm passes the limit of {limit[axis] * 1e3:.4g} mm"
    return Status(ok=False, sample=start + sample, axis=machine.axis_names[axis], reason=reason)


def _first_non_finite(group: Group, saved: Any, loop: Loop, asked: ReferenceBlock, start: int) -> Status:
    """Run the block again tick by tick to find where a state stopped being finite."""
    group.restore(saved)
    for k, row in enumerate(external_rows(asked)):
        group.run(row[None, :], [])
        if not group.finite().all():
            node = group.first_bad_node()
            return Status(ok=False, sample=start + k, axis=node.split(".")[0], reason=f"{node} gave a number that is not finite")
    return Status(ok=True)
