"""The judge of a trial that has run: the step that judges a batch, over stretches of the trial at once."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.components.estimator.newton import Newton
from contourlab.engine.runner import Group, make_group
from contourlab.engine.schedule import Node, Schedule
from contourlab.engine.step import Port
from contourlab.feed import Reference
from contourlab.geometry.view import PathView
from contourlab.loop.judging import judge_node
from contourlab.loop.machine import Machine

Array = NDArray[np.float64]
STRETCHES = 8
"""Always as many, so that the foot points are the same on any number of processors."""
FEWEST = 1000
"""Samples of a stretch: a new start costs more than the samples of a shorter one."""


class TrialJudge:
    """Works out the contour error of a trial, and the contour-error vector of what was measured.

    Parameters
    ----------
    machine, reference
        What runs.
    view : PathView
        How the judge sees the path.
    position : ndarray (n_sample, n_axis) [m]
        Of the reference.
    arc_length : ndarray (n_sample,) [m]
        Of the reference.
    window : (int, int)
        Samples [start, stop) that count.
    vector : bool
        Whether the vector is worked out.
    compiled : bool
    """

    def __init__(
        self,
        machine: Machine,
        reference: Reference,
        view: PathView,
        position: Array,
        arc_length: Array,
        window: tuple[int, int],
        vector: bool,
        compiled: bool,
    ) -> None:
        n_sample, n = position.shape
        node = judge_node(machine, reference, view, window)
        wires: dict[str, Any] = {name: f"in.{name}" for name in ("position", "reference", "arc_length")}
        nodes = [replace(node, wires=wires)]
        if vector:
            part = Newton(window=float(node.parameters["window"]), iterations=3.0)
            step, values = part.path_step(view, n), {**part.block(machine.servo_period), **view.parameters}
            measured = {"position": "in.measured", "arc_length": "in.arc_length"}
            nodes.append(Node("vector", step, measured, values, view.tables))
        ports = (Port("position", n), Port("measured", n), Port("reference", n), Port("arc_length"))
        schedule = Schedule(tuple(nodes), ports, machine.servo_period, len(nodes))
        self._external = np.empty((3 * n + 1, n_sample))
        self._external[2 * n : 3 * n], self._external[3 * n] = position.T, arc_length
        self._rows = [schedule.row("judge.contour_error"), schedule.row("judge.doubt")]
        self._rows += [schedule.row(f"vector.error_vector[{j}]") for j in range(n)] if vector else []
        self._log = np.empty((n_sample, len(self._rows), 1))
        count = max(min(STRETCHES, n_sample // FEWEST), 1)
        self._borders = np.linspace(0, n_sample, count + 1).astype(int).tolist()
        self._groups: list[tuple[Group, Any]] = []
        for first in self._borders[:-1]:
            group = make_group(schedule, 1, slice(0, 1), compiled)
            group.tick = first
            for name in ("judge", "vector") if vector else ("judge",):
                group.state_of(name)[0] = arc_length[first]
            self._groups.append((group, group.snapshot()))
        # The machine code runs without the interpreter's lock; plain Python would only wait for it.
        self._workers = min(os.cpu_count() or 1, count) if compiled else 1

    def __call__(self, position: Array, measured: Array) -> tuple[Array, NDArray[np.intp], Array | None]:
        """Judge a trial.

        Parameters
        ----------
        position, measured : ndarray (n_sample, n_axis) [m]
            Of the tool, and what the encoders say.

        Returns
        -------
        contour_error : ndarray (n_sample,) [m]
        doubtful : ndarray of int
            Samples at which it may not be exact.
        vector : ndarray (n_sample, n_axis) [m] or None
            From the measured position to the path.
        """
        n = position.shape[1]
        self._external[:n], self._external[n : 2 * n] = position.T, measured.T
        if self._workers > 1:
            with ThreadPoolExecutor(self._workers) as pool:
                list(pool.map(self._stretch, range(len(self._groups))))
        else:
            for i in range(len(self._groups)):
                self._stretch(i)
        rows = self._log[:, :, 0].T.copy()  # the next trial writes over the log
        return rows[0], np.flatnonzero(rows[1]), (rows[2:].T if len(rows) > 2 else None)

    def _stretch(self, i: int) -> None:
        group, fresh = self._groups[i]
        group.restore(fresh)
        cut = slice(self._borders[i], self._borders[i + 1])
        group.run(self._external.T[cut], self._rows, self._log[cut])
