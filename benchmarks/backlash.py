"""Drives with backlash: cost of the loop compared with rigid axes, and results of all schemes on real part programs.

    python benchmarks/backlash.py [--rounds N] [--only cost,parts] [--json FILE]

Cost: time per servo tick at 1 and 4 sub-steps, single and in lanes. Both loops have the same parts (encoder, filtered difference, observer,
cascade, Stribeck friction, a contour-error estimator) and differ only in their plants; they run in turn. Parts: the schemes of
builtin:backlash/part.toml on programs of the reference data next to the repository. README.md explains the columns.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Callable
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

from contourlab.components.registry import component
from contourlab.engine.runner import make_group
from contourlab.features.run.outcome import run_case
from contourlab.feed import Reference, uniform
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Limits, Machine
from contourlab.loop.template import build
from contourlab.scenario import builtin_file
from contourlab.scenario.load import parse_scenario

PERIOD, SECONDS = 1e-4, 4.0
TURN = 2.0 * np.pi / 0.016
MASS = 9.6e-3 * TURN * TURN
FRICTION: dict[str, Any] = {"coulomb": 40.0, "breakaway": 60.0, "stribeck_velocity": 2e-3}
LANES = 32
SHARED = Path(__file__).resolve().parents[2] / "shared" / "gcode"
PROGRAMS = ("linuxcnc__nc_files_3dtest.ngc", "linuxcnc__nc_files_cds.ngc", "linuxcnc__nc_files_tort.ngc")


def machine(kind: str, law: str, substeps: int) -> Machine:
    """Return two axes, rigid or with motor, load and 25 um of backlash, with friction."""
    if kind == "rigid":
        plant = component("plant", "mass-damper")(mass=MASS, force_constant=TURN)
    else:
        values = {"motor_inertia": 5.2e-3, "load_inertia": 4.4e-3, "lead": 0.016, "stiffness": 950.0, "shaft_damping": 0.1}
        plant = component("plant", "two-inertia")(**values, backlash_gap=25e-6)
    sensor = component("sensor", "encoder")(resolution=1e-7)
    axis = Axis("x", plant, component("friction", law)(**FRICTION), sensor=sensor, limits=Limits(following_error=1.0), substeps=substeps)
    return Machine(kind, (axis, replace(axis, name="y")), PERIOD)


def controller() -> Controller:
    """Return the controller of both machines."""
    cascade = component("controller", "cascade")
    gains = cascade.tune(150.0, 0.9, TURN / MASS, 0.0, 30.0)
    parts = {
        "velocity": component("velocity", "filtered-difference")(bandwidth=3000.0),
        "observer": component("observer", "disturbance-observer")(bandwidth=100.0, model_gain=TURN / MASS),
    }
    one = AxisController(cascade(**gains), **parts)
    return Controller({"x": one, "y": one}, component("estimator", "newton")(), component("coupling", "modified-reference")(weight=0.5))


def timer(kind: str, law: str, substeps: int, width: int, reference: Reference) -> Callable[[], float]:
    """Return a function that runs a loop once and returns the time per step, axis pair and variant [ns]."""
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


def cost(console: Console, rounds: int) -> list[dict[str, Any]]:
    """Time both loops in turn; return the rows."""
    reference = uniform(contour("circle", radius=0.025), 1.0, int(SECONDS), PERIOD)
    table = Table("friction", "substeps", "lanes", "rigid [ns]", "two-inertia [ns]", "ratio", "ratio min, max")
    rows = []
    for law, substeps, width in product(("coulomb", "smooth-coulomb"), (1, 4), (1, LANES)):
        pair = [timer(kind, law, substeps, width, reference) for kind in ("rigid", "two-inertia")]
        found = [tuple(run() for run in pair) for _ in range(rounds)]
        ratios = sorted(loose / rigid for rigid, loose in found)
        rigid, loose = (statistics.median(column) for column in zip(*found, strict=True))
        ratio = statistics.median(ratios)
        rows.append({"friction": law, "substeps": substeps, "lanes": width, "rigid_ns": rigid, "two_inertia_ns": loose, "ratio": ratio})
        spread = f"{ratios[0]:.2f}, {ratios[-1]:.2f}"
        table.add_row(law, str(substeps), str(width), f"{rigid:.0f}", f"{loose:.0f}", f"{ratio:.2f}", spread)
    console.print(table)
    return rows


def scenario_of(program: Path) -> str:
    """Return the shipped scenario with another program, fitted into the machine's travel."""
    text = builtin_file("backlash/part.toml").read_text().replace('"scheme-three.toml"', '"builtin:backlash/scheme-three"')
    lines = [line for line in text.splitlines() if not line.startswith(("program =", "machine ="))]
    at = lines.index("[run]")
    motion = ["[program]", f"file = {json.dumps(str(program))}", "fit = true", "require_end = false", ""]
    motion += ["[feed]", 'path_control = "blend"', 'corner_tolerance = "5 um"', ""]
    return "\n".join(['machine = "builtin:backlash/xyz-twin"', *lines[:at], *motion, *lines[at:]])


def parts(console: Console) -> list[dict[str, Any]]:
    """Run every scheme on every program; return the rows."""
    table = Table("program", "scheme", "part error, rms [um]", "largest [um]", "largest spike at a reversal [um]", "switches")
    rows = []
    for name in PROGRAMS:
        program = SHARED / name
        if not program.is_file():
            console.print(f"{name}: not found, skipped")
            continue
        for case in parse_scenario(scenario_of(program), str(program.with_suffix(".toml"))).cases():
            found = run_case(case, explain=False)
            switched = found.result.signals.get("switch_reason")
            row = {
                "program": name,
                "scheme": case.name,
                "rms": found.metrics.part_error.rms * 1e6,
                "max": found.metrics.part_error.max * 1e6,
                "spike": max((abs(spike.height) for spike in found.spikes), default=0.0) * 1e6,
                "switches": 0 if switched is None else int(np.count_nonzero(switched.data)),
            }
            rows.append(row)
            table.add_row(name, case.name, f"{row['rms']:.1f}", f"{row['max']:.0f}", f"{row['spike']:.0f}", str(row["switches"]))
    console.print(table)
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--only", default="cost,parts")
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    console, chosen = Console(), given.only.split(",")
    found = {
        "cost": cost(console, given.rounds) if "cost" in chosen else [],
        "parts": parts(console) if "parts" in chosen else [],
    }
    if given.json:
        given.json.write_text(json.dumps(found, indent=2) + "\n")


if __name__ == "__main__":
    main()
