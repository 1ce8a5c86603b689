"""Learning and cross-coupling: speed of trials, cost and benefit of each scheme, and a real part program in three axes.

    python benchmarks/learning.py [--quick] [--json FILE] [--out FOLDER] [--only trials,schemes,part]

One run measures everything; README.md explains the tables.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import sys
import tempfile
import time
import tracemalloc
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table
from schemes import TRIALS, compared

from contourlab.components.registry import component
from contourlab.features.learn import LearningRun, Stopping, learn
from contourlab.features.run.command import learn_schemes
from contourlab.feed import Reference, uniform
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Limits, Machine

HERE = Path(__file__).resolve().parent
PROGRAMS = HERE.parents[1] / "shared" / "gcode"
PROGRAM = "linuxcnc__nc_files_3dtest.ngc"
PERIOD, SECONDS = 1e-3, 30.0
PARTS = ("trials", "schemes", "part")
STAGE = {"damping_ratio": 1.1, "natural_frequency": 150.0}
SCENARIO = """\
name = "{name}: cross-coupled control and learning, three axes"
machine = "builtin:{machine}"

[program]
file = {file}
fit = true
require_end = false

[feed]
path_control = "blend"
corner_tolerance = "5 um"

[controller]
file = "builtin:xyz-controller"
estimator = "newton"
coupling = {{kind = "cross-coupled", gain = "5 A/mm"}}

[learning]
# Values from the rule that `contourlab analyse` prints for this loop; the lead compensates drive, hold and filters.
law = {{kind = "zero-phase", gain = 0.68, half_width = 3, passes = 2, lead = "2.5 ms"}}
trials = {trials}

[run]
tolerance = "25 um"
"""


def stages(n_axis: int, coupled: bool = True) -> tuple[Machine, Controller]:
    """Return identical stages but for their steady speeds, under the controller of Gecer Ulu et al., with or without coupling."""
    names = "xyzuvwabc"[:n_axis]
    sensor, limits = component("sensor", "encoder")(resolution=25e-9), Limits(following_error=0.1)
    plant: Any = component("plant", "second-order-integrator")
    control = component("controller", "speed-pid")
    axes = tuple(Axis(name, plant(dc_gain=1.0 - 0.05 * j, **STAGE), sensor=sensor, limits=limits) for j, name in enumerate(names))
    one = AxisController(control(dc_gain=1.0, time_constant=0.01, **STAGE), component("velocity", "filtered-difference")(bandwidth=2000.0))
    coupling = component("coupling", "cross-coupled")(gain=30.0) if coupled else None
    estimator = component("estimator", "tangent")() if coupled else None
    return Machine(f"{n_axis} stages", axes, PERIOD), Controller(dict.fromkeys(names, one), estimator, coupling)


def motion(n_axis: int, samples: int) -> Reference:
    """Return laps of 30 s along the Lissajous figure; it is 200 mm long for any number of axes, so that speed and errors are comparable."""
    size = 0.2 / contour("lissajous", axes=n_axis, amplitude=1.0).length
    return uniform(contour("lissajous", axes=n_axis, amplitude=size), 1.0 / SECONDS, round(samples * PERIOD / SECONDS), PERIOD)


def law(kind: str = "zero-phase") -> Any:
    """Return a law of learning."""
    values = {"zero-phase": {"gain": 0.2, "half_width": 40, "passes": 2}, "norm-optimal": {"change_weight": 0.01}}
    return component("learning", kind)(**values[kind])


def learned(n_axis: int, samples: int, trials: int, coupled: bool, kind: str = "zero-phase") -> LearningRun:
    """Learn a number of trials after the first, without early stopping."""
    machine, controller = stages(n_axis, coupled)
    settings = Stopping(improvement=0.0, divergence=1e9, growth=10**6)
    return learn(machine, controller, motion(n_axis, samples), law(kind), trials=trials, part="none", stopping=settings)


def shortest(work: Callable[[], LearningRun], repeat: int) -> LearningRun:
    """Return the fastest run of `repeat` and one more that compiles."""
    return min((work() for _ in range(repeat + 1)), key=lambda run: run.seconds)


def row_of(run: LearningRun, n_axis: int, samples: int, coupled: bool, **more: Any) -> dict[str, Any]:
    """Return the times of a learning run, in total and per sample."""
    n_trial = len(run.trials)
    times = {"engine": run.engine_seconds, "judge": run.judge_seconds, "all": run.seconds}
    each = {f"{name}_ns": 1e9 * seconds / n_trial / samples for name, seconds in times.items()}
    return {"axes": n_axis, "samples": samples, "trials": n_trial, "coupled": coupled} | times | each | {"gain": run.gain} | more


def trials_table(quick: bool) -> dict[str, list[dict[str, Any]]]:
    """Return the times of trials: 100 trials, growth with axes and samples, and norm-optimal learning."""
    repeat, n = 1 if quick else 3, round(SECONDS / PERIOD)
    found: dict[str, list[dict[str, Any]]] = {"hundred": [], "growth": [], "norm_optimal": []}
    for coupled in (False, True):
        found["hundred"].append(row_of(shortest(partial(learned, 2, n, 99, coupled), repeat), 2, n, coupled))
    sizes = [(2, n), (3, n), (5, n), *(() if quick else ((9, n),)), (2, 2 * n), (2, 4 * n)]
    for n_axis, samples in sizes:
        run = shortest(partial(learned, n_axis, samples, 19, True), repeat)
        found["growth"].append(row_of(run, n_axis, samples, True))
    for n_axis in (2, 3):
        run = shortest(partial(learned, n_axis, n, 5, True, "norm-optimal"), repeat)
        tracemalloc.start()
        learned(n_axis, n, 2, True, "norm-optimal")
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        found["norm_optimal"].append(row_of(run, n_axis, n, True, peak=peak, dense=8.0 * n_axis * float(n) ** 2))
    return found


def part_table(out: Path, quick: bool) -> list[dict[str, Any]]:
    """Run the part program as `contourlab learn SCENARIO` does, on the machine without and with geometric errors; reports go to `out`."""
    rows = []
    for machine in ("xyz",) if quick else ("xyz", "xyz-with-errors"):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "part.toml"
            text = SCENARIO.format(name=PROGRAM, machine=machine, file=json.dumps(str(PROGRAMS / PROGRAM)), trials=10)
            file.write_text(text, encoding="utf-8")
            plots = () if quick else ("png",)
            begun = time.perf_counter()
            done = learn_schemes(file).save(out / machine, plots=plots, signals=("reference", "position", "part_error"))
            seconds = time.perf_counter() - begun
        before, after = (done.summary["schemes"][name] for name in ("before learning", "after learning"))
        row: dict[str, Any] = {"machine": machine, "seconds": seconds, "duration": before["metrics"]["cycle_time"]}
        row |= {"status": after["learning"]["status"], "trial": after["learning"]["best_trial"]}
        row["floor"] = (after["learning"]["split"] or {}).get("floor")
        for name, figure in (("part_max", ("part_error", "max")), ("part_rms", ("part_error", "rms"))):
            row[name] = [one["metrics"][figure[0]][figure[1]] for one in (before, after)]
        row["planning"] = before["metrics"]["planning_deviation"]["max"]
        row["tracking"] = [trial["tracking_rms"] for trial in after["learning"]["trials"]]
        rows.append(row)
    return rows


def table(title: str, heads: Sequence[str], rows: Sequence[Sequence[str]], left: int = 1) -> Table:
    """Return a table; the first `left` columns are left-aligned."""
    made = Table(title=title, title_justify="left")
    for number, head in enumerate(heads):
        made.add_column(head, justify="right" if number >= left else "left")
    for row in rows:
        made.add_row(*row)
    return made


def trials_shown(found: dict[str, list[dict[str, Any]]]) -> Iterator[Table]:
    """Yield the tables of times."""
    heads = ["", "axes", "samples", "trials", "engine s", "judge s", "all s", "engine ns", "judge ns", "all ns", "error divided by"]

    def cells(name: str, r: dict[str, Any]) -> list[str]:
        times = [f"{r[key]:.3f}" for key in ("engine", "judge", "all")] + [f"{r[key]:.0f}" for key in ("engine_ns", "judge_ns", "all_ns")]
        return [name, str(r["axes"]), str(r["samples"]), str(r["trials"]), *times, f"{r['gain']:.3g}"]

    yield table(
        "100 trials of 30 s at 1 kHz; ns per sample and trial",
        heads,
        [cells("cross-coupled" if r["coupled"] else "feedback alone", r) for r in found["hundred"]],
    )
    first = found["growth"][0]
    rows = [[*cells("", r), f"{r['engine'] / first['engine']:.2f}", f"{r['all'] / first['all']:.2f}"] for r in found["growth"]]
    yield table("Growth with axes and samples, cross-coupled", [*heads, "engine to first", "all to first"], rows)
    rows = []
    for r in found["norm_optimal"]:
        update = (r["all"] - r["engine"] - r["judge"]) / (r["trials"] - 1)
        rows.append([*cells("", r), f"{update:.3f}", f"{r['peak'] / 2**20:.0f}", f"{r['dense'] / 2**20:.0f}"])
    yield table("Norm-optimal learning, without matrices", [*heads, "s per update", "peak MiB", "dense MiB"], rows)


def schemes_shown(rows: list[dict[str, Any]]) -> Table:
    """Return the table of schemes."""
    shown: list[list[str]] = []
    for r in rows:
        law_cost = f"{r['per_sample'] * 1e6:.2f}" if "per_sample" in r else "-"
        errors = [f"{r['rms'] * 1e6:.2f}", f"{r['max'] * 1e6:.1f}", f"{rows[0]['rms'] / r['rms']:.2f}"]
        shown.append([r["group"], r["name"], *errors, f"{r['tick'] * 1e9:.0f}", f"{r['over_base'] * 1e9:+.0f}", law_cost])
    heads = ["group", "scheme", "contour rms um", "max um", "better than first", "tick ns", "over first", "us per sample and trial"]
    return table(f"Every scheme: accuracy and cost; learning after {TRIALS} trials", heads, shown, left=2)


def part_shown(rows: list[dict[str, Any]]) -> Table:
    """Return the table of the part program."""
    um = 1e6
    heads = [
        "machine",
        "motion s",
        "run time s",
        "part max um",
        "after",
        "part rms um",
        "after",
        "planning max um",
        "floor rms um",
        "trial",
        "status",
    ]
    shown = [
        [
            r["machine"],
            f"{r['duration']:.1f}",
            f"{r['seconds']:.1f}",
            *(f"{x * um:.2f}" for x in (*r["part_max"], *r["part_rms"], r["planning"])),
            "-" if r["floor"] is None else f"{r['floor'] * um:.2f}",
            str(r["trial"]),
            r["status"],
        ]
        for r in rows
    ]
    made = table(f"{PROGRAM} on three axes, cross-coupled, before and after ten trials", heads, shown)
    tracked = [np.sqrt(np.square(r["tracking"]).sum(axis=1)) * um for r in rows]
    made.caption = "\n".join(
        f"{r['machine']}: tracking rms by trial {', '.join(f'{x:.2f}' for x in one)} um" for r, one in zip(rows, tracked, strict=True)
    )
    return made


def main() -> int:
    """Run the benchmark, print the tables, write the JSON."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="fewer repeats, one machine for the part program, no pictures")
    parser.add_argument("--json", type=Path, default=HERE / "out" / "learning.json", help="file for the figures")
    parser.add_argument("--out", type=Path, default=Path("results/learning"), help="folder for the reports of the part program")
    parser.add_argument("--only", default=",".join(PARTS), help="any of trials, schemes, part, separated by commas")
    options = parser.parse_args()
    wanted, console = options.only.split(","), Console(width=None if sys.stdout.isatty() else 200)
    if not set(wanted) <= set(PARTS):
        parser.error(f"--only {options.only}: choose from {', '.join(PARTS)}")
    console.print(f"{platform.platform()}, Python {platform.python_version()}, {os.cpu_count()} processors", highlight=False)
    found: dict[str, Any] = {"platform": platform.platform()}
    if "trials" in wanted:
        found["trials"] = trials_table(options.quick)
        for one in trials_shown(found["trials"]):
            console.print(one)
    if "schemes" in wanted:
        found["schemes"] = compared(options.quick)
        console.print(schemes_shown(found["schemes"]))
    if "part" in wanted and not (PROGRAMS / PROGRAM).is_file():
        console.print(f"part program skipped: {PROGRAMS / PROGRAM} not found")
    elif "part" in wanted:
        found["part"] = part_table(options.out, options.quick)
        console.print(part_shown(found["part"]))
        console.print(f"reports: {', '.join(str(options.out / r['machine'] / 'report.html') for r in found['part'])}", highlight=False)
    options.json.parent.mkdir(parents=True, exist_ok=True)
    options.json.write_text(json.dumps(found, indent=2) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
