"""Cost of each estimator and coupling in a servo tick, in 2, 3 and 5 axes, and of each observer, relative to Newton's with two iterations.

Each one is a compiled schedule of one node, for one variant and in 32 lanes. All get the same ticks along a smooth closed figure, a path of
quintic pieces in a table. A row with a node that does nothing shows the cost of the tick itself. All rows run in turns; the shortest
processor time counts.
"""

from __future__ import annotations

import argparse
import math
import os
import platform
import sys
import time
from dataclasses import dataclass, field, replace
from typing import Any

import figures_file
import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import make_interp_spline

from contourlab.components.registry import component
from contourlab.engine.runner import Group, make_group
from contourlab.engine.step import Node, Port, Schedule, Step
from contourlab.geometry import BSpline, Path
from contourlab.geometry.view import view_of

Array = NDArray[np.float64]
TICKS, PERIOD, LAG, AXES, LANES = 20_000, 1e-3, 2e-4, (2, 3, 5), 32
AGAINST = "newton, 2 iterations"
NOTHING = "a node that does nothing"
ESTIMATORS: dict[str, tuple[str, dict[str, Any]]] = {
    AGAINST: ("newton", {"iterations": 2}),
    "newton, 1 iteration, warm": ("newton", {"iterations": 1, "start": "warm"}),
    "newton, 3 iterations": ("newton", {"iterations": 3}),
    "tangent": ("tangent", {}),
    "constant-gain": ("constant-gain", {}),
    "koren-lo": ("koren-lo", {}),
    "osculating-circle": ("osculating-circle", {}),
    "taylor": ("taylor", {}),
}
COUPLINGS: dict[str, tuple[str, dict[str, Any]]] = {
    "modified-reference": ("modified-reference", {}),
    "modified-error": ("modified-error", {}),
    "cross-coupled, PID": ("cross-coupled", {"gain": 1.0, "integral_rate": 5.0, "derivative_time": 2e-3, "limit": 1.0}),
    **{
        f"cross-coupled-filter, order {n}": ("cross-coupled-filter", {"numerator": [1.0] * (n + 1), "denominator": np.poly([-9.0] * n)})
        for n in (1, 2, 4)
    },
}

MODEL = {"model_gain": 0.8, "model_damping": 12.0}
OBSERVERS: dict[str, dict[str, Any]] = {
    "disturbance-observer": MODEL,
    "load-observer": MODEL,
    "integral-sliding": {**MODEL, "limit": 1.0},
    "super-twisting": {**MODEL, "disturbance_rate": 3.0},
}
"""Each for one axis, in the column of 2 axes."""


def figure(n_axis: int) -> Path:
    """Return a closed figure with a sine of its own frequency in each axis."""
    u = np.linspace(0.0, 2.0 * math.pi, 121)
    points = 0.03 * np.column_stack([np.sin((1.0 + j) * u + 0.6 * j) / (1.0 + 0.5 * j) for j in range(n_axis)])
    points[-1] = points[0]
    spline = make_interp_spline(u, points, 5, bc_type="periodic")
    return Path([BSpline(5, spline.c, spline.t)], closed=True)


def signals(path: Path) -> dict[str, Array]:
    """Return the signals of a lap: the tool is late by a lag and off the path by some micrometres; drives accept each command."""
    s = np.linspace(0.0, path.length, TICKS, endpoint=False)
    rng = np.random.default_rng(1)
    reference, tangent = path.position(s), path.tangent(s)
    position = path.position(s - LAG) + 5e-6 * rng.standard_normal(reference.shape)
    lag = reference - position
    error = lag - (lag * tangent).sum(axis=1)[:, None] * tangent
    return {
        "reference": reference,
        "position": position,
        "foot_position": position + error,
        "error_vector": error,
        "contour_error_estimate": np.linalg.norm(error, axis=1)[:, None],
        "tangent": tangent,
        "arc_length": s[:, None],
        "command": lag,
        "accepted": lag,
        "velocity": np.gradient(position, PERIOD, axis=0)[:, :1],
        "applied": lag[:, :1],
    }


def empty(n_axis: int) -> Step:
    """Return a step that does nothing, with the same kind of inputs."""

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (inp.arc_length,)

    return Step("nothing", step, inputs=(Port("position", n_axis), Port("arc_length")), outputs=(Port("same"),))


@dataclass
class Row:
    """One node alone."""

    name: str
    n_axis: int
    group: Group
    fed: Array
    lanes: int
    best: float = math.inf
    start: Any = field(init=False)

    def __post_init__(self) -> None:
        self.start = self.group.snapshot()

    def once(self) -> None:
        """Run all ticks; keep the time per tick and lane if it is the shortest [ns]."""
        self.group.restore(self.start)
        begun = time.process_time()
        self.group.run(self.fed, [])
        self.best = min(self.best, (time.process_time() - begun) / len(self.fed) / self.lanes * 1e9)


def row(name: str, step: Step, values: dict[str, Any], tables: dict[str, Array], flowing: dict[str, Array], lanes: int) -> Row:
    """Return the row of a step."""
    n_axis = flowing["position"].shape[1]
    node = Node("part", step, {port.name: f"in.{port.name}" for port in step.inputs}, values, tables)
    fed = np.ascontiguousarray(np.concatenate([flowing[port.name] for port in step.inputs], axis=1))
    return Row(name, n_axis, make_group(Schedule((node,), step.inputs, PERIOD, 1), lanes, slice(0, lanes), True), fed, lanes)


def rows_for(n_axis: int, lanes: int) -> list[Row]:
    """Return all rows for a number of axes; the empty one first."""
    path = figure(n_axis)
    view, flowing = view_of(path), signals(path)
    found = [row(NOTHING, empty(n_axis), {}, {}, flowing, lanes)]
    for name, (kind, values) in ESTIMATORS.items():
        if kind == "koren-lo" and n_axis != 2:
            continue
        part: Any = component("estimator", kind)(**(values | ({"direction": [1.0] * n_axis} if kind == "constant-gain" else {})))
        step, numbers = part.path_step(view, n_axis), {**part.block(PERIOD), **view.parameters}
        found.append(row(name, step, numbers, dict(view.tables), flowing, lanes))
    for name, (kind, values) in COUPLINGS.items():
        part = component("coupling", kind)(**values)
        found.append(row(name, part.make_step(n_axis), part.block(PERIOD), {}, flowing, lanes))
    for name, values in OBSERVERS.items() if n_axis == AXES[0] else ():
        part, seen = component("observer", name)(**values), {**flowing, "position": flowing["position"][:, :1]}
        found.append(replace(row(name, part.make_step(), part.block(PERIOD), {}, seen, lanes), n_axis=n_axis))
    return found


def shown(rows: list[Row]) -> list[dict[str, Any]]:
    """Print the table; return its rows."""
    table: list[dict[str, Any]] = []
    spent = {(r.name, r.n_axis, r.lanes): r.best for r in rows}
    columns = [(n, lanes) for lanes in (1, LANES) for n in AXES]
    print(
        f"{'ns per tick (ratio to ' + AGAINST + ')':46s}"
        + "".join(f"{f'{n} axes' + (f', {w} lanes' if w > 1 else ''):>18s}" for n, w in columns)
    )
    for name in (NOTHING, *ESTIMATORS, *COUPLINGS, *OBSERVERS):
        cells = []
        for n, lanes in columns:
            ns = spent.get((name, n, lanes))
            ratio = None if ns is None else ns / spent[AGAINST, n, lanes]
            cells.append("-" if ns is None else f"{ns:8.1f} ({ratio:5.3f})")
            table.append({"name": name, "axes": n, "lanes": lanes, "ns_per_tick": ns, "ratio_to_newton_2": ratio})
        print(f"{name:46s}" + "".join(f"{cell:>18s}" for cell in cells))
    return table


def main() -> int:
    """Run the benchmark and write benchmarks/out/couplings.json."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeat", type=int, default=15, help="rounds; the shortest time of each row counts")
    options = parser.parse_args()
    rows = [found for lanes in (1, LANES) for n in AXES for found in rows_for(n, lanes)]
    for _ in range(options.repeat):
        for one in rows:
            one.once()
    print(f"{platform.platform()}, Python {platform.python_version()}, {os.cpu_count()} processors; {TICKS} ticks")
    table = shown(rows)
    figures_file.write("couplings.json", table)
    return 0


if __name__ == "__main__":
    sys.exit(main())
