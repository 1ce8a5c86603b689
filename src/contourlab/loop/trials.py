"""Repeated trials of one motion; everything they share is built once.

A trial equals `simulate` with the same table, seed and trial number, bit by bit.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.drive.saturation import Saturation
from contourlab.components.ideal import IdealSensor
from contourlab.engine.runner import make_group
from contourlab.engine.step import Late, Schedule
from contourlab.feed import Reference
from contourlab.geometry.foot_point import FootPoint
from contourlab.geometry.view import PathView, check_view
from contourlab.loop.feeding import LEARNED_COMMAND, LEARNED_REFERENCE, Feed, Learned
from contourlab.loop.judging import all_finite, watched
from contourlab.loop.machine import AxisController, Controller, Machine
from contourlab.loop.simulate import ToolPosition, jit_enabled, sampler
from contourlab.loop.template import Wiring, build
from contourlab.metrics.judge import furthest, reach
from contourlab.result import Status


@dataclass(frozen=True, eq=False)
class Trial:
    """Result of one trial: arrays (n_sample, n_axis) unless stated otherwise, each signal one row of memory.

    Attributes
    ----------
    status : Status
        The arrays of a failed trial are meaningless from the failing sample on.
    position, measured, tool : ndarray [m]
        Of the axes, their encoders, and the tool.
    command, excess : ndarray [command unit]
        Of the controllers, including the learned table, before filters; and the part beyond the limit of the drive.
    estimate : ndarray [command unit]
        Disturbance estimate that was subtracted from the command; zero without an observer.
    contour_vector : ndarray [m] or None
        From the measured tool to the path; if requested.
    contour_error : ndarray (n_sample,) [m]
        Exact, of the tool.
    contour_rms, contour_max, contour_mean : float [m]
        Over the samples that count; NaN for a trial that failed.
    """

    status: Status
    position: Array
    measured: Array
    tool: Array
    command: Array
    excess: Array
    estimate: Array
    contour_vector: Array | None
    contour_error: Array
    contour_rms: float
    contour_max: float
    contour_mean: float


class Trials:
    """Runs trials of one motion.

    Parameters
    ----------
    machine, controller, reference
        What runs.
    target : {"command", "reference"}
        Signal to which the learned table is added.
    vector : bool
        Whether to compute the contour-error vector of the measured position.
    seed : int
        Of all noise.
    jit, view
        As of `simulate`.

    Attributes
    ----------
    judged : ndarray of int
        The judged samples.
    position, arc_length : ndarray (n_sample, n_axis) and (n_sample,) [m]
        Of the reference.
    engine_seconds, judge_seconds : float [s]
        Run time of the machine and the judge so far.

    Raises
    ------
    ParameterError
        If a controller has no port for the learned table.

    Notes
    -----
    Memory: some 150 bytes per sample and axis.
    """

    def __init__(
        self,
        machine: Machine,
        controller: Controller,
        reference: Reference,
        *,
        target: str = "command",
        vector: bool = False,
        seed: int = 0,
        jit: bool | None = None,
        view: PathView | None = None,
    ) -> None:
        self.machine, self.controller, self.reference, self.seed = machine, controller, reference, seed
        check_view(view, reference.path)
        compiled = jit_enabled(jit)
        self.judged, n = reference.judged.samples, reference.n_sample
        self._feed = Feed(machine, controller, reference, Learned(**{target: np.zeros((n, reference.n_axis))}), sampler(compiled))
        self._fed = LEARNED_COMMAND if target == "command" else LEARNED_REFERENCE
        blocks = [self._feed.block(*samples) for samples in reference.blocks()]
        self._blocks = [fed for _, fed in blocks]
        self.position = np.concatenate([asked.position.T for asked, _ in blocks], axis=1).T
        self.arc_length = np.concatenate([asked.arc_length for asked, _ in blocks])
        self._view = view
        loop = self._built(0)
        self._schedule, self._signals = loop.schedule, loop.signals
        self._group = make_group(self._schedule, 1, slice(0, 1), compiled)
        self._fresh = self._group.snapshot()
        self._noisy = any("stream" in node.step.parameters for node in loop.schedule.nodes)
        self._column = self._wanted()
        self._log = np.empty((n, len(self._column), 1))
        self._drive_limit = np.array([float(getattr(axis.drive, "limit", np.inf)) for axis in machine.axes])
        own = (controller.axes[name].controller for name in machine.axis_names)
        self._own_limit = np.array([float(getattr(part, "command_limit", np.inf)) for part in own])
        self._vector = vector
        self.engine_seconds = self.judge_seconds = 0.0

    def _built(self, trial: int) -> Wiring:
        start, progress = self.position[0], float(self.arc_length[0])
        given: dict[str, Any] = {"view": self._view, "seed": self.seed, "trial": trial, "fed": self._feed.names}
        return build(self.machine, self.controller, self.reference.path, start, progress, **given)

    def _wanted(self) -> dict[str, int]:
        """Return the logged signals, and the column of each."""
        kinds = ["axis_position", "position", "command", self._asked]
        if not ToolPosition(self.machine, self.seed).exact:
            kinds.append("axis_velocity")
        names = [signal for kind in kinds for signal in self._signals[kind]]
        names += [self._estimate_of(name) for name in self.machine.axis_names if self.controller.axes[name].observer is not None]
        return {name: i for i, name in enumerate(dict.fromkeys(names))}

    @property
    def _asked(self) -> str:
        """Signal with the commands of the controllers."""
        return "unfiltered_command" if "unfiltered_command" in self._signals else "command"

    @staticmethod
    def _estimate_of(axis: str) -> str:
        return f"{axis}.observer.disturbance_estimate"

    def run(self, table: Array | None, trial: int, progress: Callable[[int], None] | None = None) -> Trial:
        """Run one trial with a learned table (n_sample, n_axis), or none; stop at the end of the block in which it fails."""
        group, began = self._group, time.perf_counter()
        group.restore(self._fresh)
        if self._noisy and trial:
            self._draw(trial)
        first = self._schedule.row(f"in.{self._fed}")
        rows = [self._schedule.row(name) for name in self._column]
        status, k = Status(ok=True), 0
        for external in self._blocks:
            stop = k + len(external)
            external[:, first : first + self.reference.n_axis] = 0.0 if table is None else table[k:stop]
            group.run(external, rows, self._log[k:stop])
            status, k = watched(group, self.machine), stop
            status = all_finite(group, stop - 1) if status.ok else status
            if progress is not None:
                progress(k)
            if not status.ok:
                break
        self._log[k:] = np.nan
        self.engine_seconds += time.perf_counter() - began
        return self._trial(status, trial)

    def _draw(self, trial: int) -> None:
        """Set every noise source to this trial."""
        drawn = self._built(trial).schedule.nodes
        for node, memory in zip(drawn, self._group.parameters, strict=True):
            if "stream" in node.step.parameters:
                memory[:, 0] = [float(node.parameters[name]) for name in node.step.parameters]
        self._group.refresh()

    def _trial(self, status: Status, trial: int) -> Trial:
        # Transposed once, so that what follows runs along memory.
        rows = np.ascontiguousarray(self._log[:, :, 0].T)

        def signal(names: Iterable[str]) -> Array:
            return rows[[self._column[name] for name in names]].T

        position, measured, command = (signal(self._signals[name]) for name in ("axis_position", "position", self._asked))
        estimate = np.zeros(command.T.shape).T
        for j, name in enumerate(self.machine.axis_names):
            if self._estimate_of(name) in self._column:
                estimate[:, j] = rows[self._column[self._estimate_of(name)]]
        if not status.ok:
            unknown = np.full(len(position), np.nan)
            return Trial(status, position, measured, position, command, np.zeros_like(command), estimate, None, unknown, *[np.nan] * 3)
        beyond = _excess(signal(self._signals["command"]), self._drive_limit)
        excess = np.where(beyond == 0.0, _excess(command, self._own_limit), beyond)
        velocity = signal(self._signals["axis_velocity"]) if self._signals["axis_velocity"][0] in self._column else position
        began = time.perf_counter()
        tool, vector, contour, figures = self._judged(trial, position, measured, velocity)
        self.judge_seconds += time.perf_counter() - began
        return Trial(status, position, measured, tool, command, excess, estimate, vector, contour, *figures)

    def _judged(
        self, trial: int, position: Array, measured: Array, velocity: Array
    ) -> tuple[Array, Array | None, Array, tuple[float, float, float]]:
        """Return tool position, error vector, contour error and its rms, maximum and mean."""
        made = ToolPosition(self.machine, self.seed, trial)
        tool = position if made.exact else made.of(position, velocity)
        feet, path = self._feet(tool), self.reference.path
        contour = feet.signed if path.is_planar else feet.distance
        vector = self._feet(measured).position - measured if self._vector else None
        size = np.abs(contour[self.judged])
        return tool, vector, contour, (float(np.sqrt(np.mean(size**2))), float(size.max()), float(size.mean()))

    def _feet(self, points: Array) -> FootPoint:
        path = self.reference.path
        return path.foot_point(points, self.arc_length, reach(path, furthest(self.position - points)))


def _excess(command: Array, limit: Array) -> Array:
    """Return the part of commands beyond a limit; for commands limited by the controller itself, only the direction."""
    beyond = np.abs(command) - limit
    with np.errstate(invalid="ignore"):
        held = np.isfinite(limit) & (beyond >= -1e-12 * limit)
    return np.where(held, np.copysign(np.maximum(beyond, np.finfo(float).tiny), command), 0.0)


def _undisturbed(parts: AxisController) -> AxisController:
    """Return an axis' controller without the parts that react to errors besides its own law."""
    bare: dict[str, Any] = dict.fromkeys(("observer", "predictor", "gap_observer", "compensation", "supervisor", "link"))
    return replace(parts, controller=parts.controller.linear(), others=(), filters=(), **bare)


def _followed(wire: Any, names: tuple[str, ...]) -> Any:
    """Return the reference's wire in place of a plant's, as if the plant followed exactly."""
    axis, _, signal = (wire.signal if isinstance(wire, Late) else "").partition(".plant.")
    what = "reference_velocity" if signal.endswith("velocity") else "reference"
    return wire if not signal else f"in.{what}[{names.index(axis)}]"


def feedforward_command(machine: Machine, controller: Controller, reference: Reference, *, jit: bool | None = None) -> Array:
    """Return the commands on a machine without errors: the feedforward of the reference (n_sample, n_axis) [command unit].

    Feedforward, velocity and controller run with the reference in place of all measurements, without observers, coupling, compensation and
    filters.
    Of several controllers the first runs, without a known gap.
    """
    compiled = jit_enabled(jit)
    feed = Feed(machine, controller, reference, None, sampler(compiled))
    alone = Controller({name: _undisturbed(controller.axes[name]) for name in machine.axis_names})
    ideal: dict[str, Any] = {"drive": Saturation(), "sensor": IdealSensor(), "motor_sensor": IdealSensor()}
    plain = replace(machine, axes=tuple(replace(axis, **ideal) for axis in machine.axes))
    loop = build(plain, alone, reference.path, **feed.first(), fed=feed.names)
    nodes = tuple(
        replace(node, wires={port: _followed(wire, machine.axis_names) for port, wire in node.wires.items()})
        for node in loop.schedule.nodes[: loop.schedule.record_point - 1]
    )
    schedule = Schedule(nodes, loop.schedule.externals, machine.servo_period, len(nodes))
    group = make_group(schedule, 1, slice(0, 1), compiled)
    rows = [schedule.row(signal) for signal in loop.signals["command"]]
    return np.concatenate([group.run(feed.block(*samples)[1], rows)[:, :, 0] for samples in reference.blocks()])
