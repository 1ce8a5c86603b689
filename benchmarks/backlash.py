"""Drives with backlash: what their loop costs beside that of rigid axes, single and in lanes, per step and servo sub-step.

    python benchmarks/backlash.py [--rounds N] [--json FILE]

Both loops have the same parts (encoder, filtered difference, observer, cascade, Stribeck friction, a contour-error estimator) and differ in
their plants alone; they are measured by turns in one run. README.md beside this file says what each column means.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

from contourlab.components.registry import component
from contourlab.engine.runner import make_group
from contourlab.feed import Reference, uniform
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Limits, Machine
from contourlab.loop.template import build

PERIOD, SECONDS = 1e-4, 4.0
TURN = 2.0 * np.pi / 0.016
MASS = 9.6e-3 * TURN * TURN
FRICTION: dict[str, Any] = {"coulomb": 40.0, "breakaway": 60.0, "stribeck_velocity": 2e-3}
LANES = 32


def machine(kind: str, law: str, substeps: int) -> Machine:
    """Return two axes, rigid or with motor, load and 25 um of backlash, under a friction."""
    if kind == "rigid":
        plant = component("plant", "mass-damper")(mass=MASS, force_constant=TURN)
    else:
        values = {"motor_inertia": 5.2e-3, "load_inertia": 4.4e-3, "lead": 0.016, "stiffness": 950.0, "shaft_damping": 0.1}
        plant = component("plant", "two-inertia")(**values, backlash_gap=25e-6)
    sensor = component("sensor", "encoder")(resolution=1e-7)
    axis = Axis("x", plant, component("friction", law)(**FRICTION), sensor=sensor, limits=Limits(following_error=1.0), substeps=substeps)
    return Machine(
        kind,
        (axis, Axis("y", *(getattr(axis, n) for n in ("plant", "friction", "drive", "sensor")), limits=axis.limits, substeps=substeps)),
        PERIOD,
    )


def controller() -> Controller:
    """Return the same controller for both."""
    cascade = component("controller", "cascade")
    gains = cascade.tune(150.0, 0.9, TURN / MASS, 0.0, 30.0)
    parts = {
        "velocity": component("velocity", "filtered-difference")(bandwidth=3000.0),
        "observer": component("observer", "disturbance-observer")(bandwidth=100.0, model_gain=TURN / MASS),
    }
    one = AxisController(cascade(**gains), **parts)
    return Controller({"x": one, "y": one}, component("estimator", "newton")(), component("coupling", "modified-reference")(weight=0.5))


def timer(kind: str, law: str, substeps: int, width: int, reference: Reference) -> Callable[[], float]:
    """Return what runs a loop once and tells the time per step, axis pair and variant [ns]."""
    made = machine(kind, law, substeps)
    first = reference.block(0, 1)
    gaps = {"axes.x.plant.backlash_gap": np.linspace(5e-6, 100e-6, width)} if kind != "rigid" and width > 1 else {}
    loop = build(made, controller(), reference.path, first.position[0], float(first.arc_length[0]), gaps)
    group, fed = make_group(loop.schedule, width, slice(0, width), True), reference.block(0, reference.n_sample).table
    start = group.snapshot()

    def run() -> float:
        group.restore(start)
        begun = time.perf_counter()
        group.run(fed, [])
        taken = time.perf_counter() - begun
        assert group.finite().all()
        return taken / len(fed) / width * 1e9

    run()
    return run


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    reference = uniform(contour("circle", radius=0.025), 1.0, int(SECONDS), PERIOD)
    table = Table("friction", "substeps", "lanes", "rigid, ns", "two-inertia, ns", "ratio", "ratio, least and most")
    rows = []
    for law in ("coulomb", "smooth-coulomb"):
        for substeps in (1, 4):
            for width in (1, LANES):
                pair = [timer(kind, law, substeps, width, reference) for kind in ("rigid", "two-inertia")]
                found = [tuple(run() for run in pair) for _ in range(given.rounds)]
                ratios = sorted(loose / rigid for rigid, loose in found)
                rigid, loose = (statistics.median(column) for column in zip(*found, strict=True))
                ratio = statistics.median(ratios)
                rows.append(
                    {"friction": law, "substeps": substeps, "lanes": width, "rigid_ns": rigid, "two_inertia_ns": loose, "ratio": ratio}
                )
                spread = f"{ratios[0]:.2f} .. {ratios[-1]:.2f}"
                table.add_row(law, str(substeps), str(width), f"{rigid:.0f}", f"{loose:.0f}", f"{ratio:.2f}", spread)
    Console().print(table)
    if given.json:
        given.json.write_text(json.dumps(rows, indent=2) + "\n")


if __name__ == "__main__":
    main()
