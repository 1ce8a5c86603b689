"""The judge of a batch on hand-made positions."""

from __future__ import annotations

from typing import Any

import numpy as np
from made_runs import PERIOD, Array

from contourlab.engine.runner import make_group
from contourlab.engine.step import Node, Port, Schedule
from contourlab.geometry import Path
from contourlab.geometry.view import view_of
from contourlab.loop.judging import room_for
from contourlab.metrics.judge import MARGIN
from contourlab.metrics.streaming import SUMS, judge_step

ERROR = (2e-2 - MARGIN) / 3.0
"""Largest tracking error [m] that the judge expects: foot points lie within 20 mm of the reference."""
TABLE = 1e-11
"""Largest distance [m] of the path's table from the path, where no closed form exists."""


def streamed(
    path: Path,
    along: Array,
    tool: Array,
    counted: tuple[int, int] | None = None,
    analytic: bool = True,
    error: float = ERROR,
    jit: bool = False,
) -> Any:
    """Return the sums of the streaming judge by name, its contour error (n_sample,), and the samples in doubt."""
    view = view_of(path, tolerance=TABLE, analytic=analytic)
    n = path.n_axis
    counts = np.zeros(len(along))
    counts[slice(*(counted or (0, None)))] = 1.0
    numbers, cells = room_for(path, error, 0.0)
    step = judge_step(view, n, bool(path.corners.size) or not path.closed)
    wires = {"position": "in.position", "reference": "in.reference", "arc_length": "in.arc_length"}
    tables = {**view.tables, **cells, "counts": counts}
    node = Node("judge", step, wires, {**view.parameters, **numbers}, tables, {"foot": float(along[0])})
    ports = (Port("position", n), Port("reference", n), Port("arc_length"))
    group = make_group(Schedule((node,), ports, PERIOD, 1), 1, slice(0, 1), jit)
    rows = [group.schedule.row(f"judge.{name}") for name in ("contour_error", "doubt")]
    log = group.run(np.column_stack([tool, path.position(along), along]), rows)[:, :, 0]
    return dict(zip(SUMS, group.state_of("judge")[1:, 0], strict=True)), log[:, 0], log[:, 1] > 0.0
