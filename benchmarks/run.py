"""`make bench`: time the same work, done in several ways; see README.md."""

from __future__ import annotations

import argparse
import importlib.util
import itertools
import math
import os
import platform
import sys
import tempfile
import textwrap
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import backlash
import figures_file
import numpy as np
import references

import contourlab as cl
from contourlab.components.controller.position import PositionController
from contourlab.components.coupling.laws import ModifiedReference
from contourlab.components.drive.saturation import Saturation
from contourlab.components.estimator.newton import Newton
from contourlab.components.friction.laws import SmoothCoulomb
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.plant import RigidAxis
from contourlab.errors import EngineError
from contourlab.feed import Route, blended, plan, route_from_program
from contourlab.geometry.view import view_of
from contourlab.program.reader import parse_program
from contourlab.scenario.load import load_machine

PERIOD, STEPS, RADIUS, FREQUENCY, WEIGHT = 1e-4, 40_000, 20.0, 0.5, 0.75
PATH = cl.contour("circle", radius=1e-3 * RADIUS)
RATE = 2.0 * math.pi * FREQUENCY
WIDE = 65_536
SIGNALS = ("position", "applied_command", "contour_error_estimate")
NAMES = [
    "gain",
    "damping",
    "coulomb",
    "breakaway",
    "stribeck",
    "smoothing",
    "limit",
    "bandwidth",
    "filter",
    "model_gain",
    "model_damping",
    "kv",
    "kp",
    "ki",
    "forward_gain",
    "forward_damping",
]


def axis_numbers(gain: float, damping: float, coulomb: float, model_gain: float, model_damping: float) -> list[float]:
    """Return the parameters of an axis with lengths in mm, in the order of reference.c."""
    plant = [gain, damping, coulomb, 1.3 * coulomb, 1.0, 0.05, 10.0]
    return [*plant, 200.0, 2000.0, model_gain, model_damping, 0.1, 4.0, 11.8, 900.0, 25.0]


AXES = (axis_numbers(1116.0, 5.8, 0.077, 1000.0, 25.0), axis_numbers(648.0, 6.5, 0.088, 600.0, 20.0))


def machine_and_controller(names: str = "xy") -> tuple[cl.Machine, cl.Controller]:
    """Return the benchmark's machine and controller in SI; its two axes take turns under more names."""
    axes, controllers = [], {}
    for name, numbers in zip(names, itertools.cycle(AXES)):
        n = dict(zip(NAMES, numbers, strict=True))
        friction = SmoothCoulomb(
            coulomb=n["coulomb"],
            breakaway=n["breakaway"],
            stribeck_velocity=1e-3 * n["stribeck"],
            smoothing_velocity=1e-3 * n["smoothing"],
        )
        plant = RigidAxis(gain=1e-3 * n["gain"], damping=n["damping"])
        axes.append(cl.Axis(name, plant, friction, Saturation(limit=n["limit"]), limits=cl.Limits(following_error=1.0)))
        position = PositionController(
            velocity_gain=1e3 * n["kv"],
            position_gain=1e3 * n["kp"],
            integral_gain=n["ki"],
            model_gain=1e-3 * n["forward_gain"],
            model_damping=n["forward_damping"],
            anti_windup="none",
        )
        observer = DisturbanceObserver(
            bandwidth=n["bandwidth"], filter_bandwidth=n["filter"], model_gain=1e-3 * n["model_gain"], model_damping=n["model_damping"]
        )
        controllers[name] = cl.AxisController(position, observer=observer)
    coupling = ModifiedReference(weight=WEIGHT)
    return cl.Machine("bench", tuple(axes), PERIOD), cl.Controller(controllers, Newton(iterations=1, start="warm", window=1.0), coupling)


def rms(error: np.ndarray) -> float:
    """Return the root mean square over the second half, on a circle the second lap [mm]."""
    return float(np.sqrt(np.mean(np.square(error[len(error) // 2 :]))))


@dataclass
class Contender:
    """One way to do the work: `work` runs once and returns the error signal of the nominal variant [mm]; `reference` is another's name."""

    name: str
    work: Callable[[], np.ndarray]
    variants: int = 1
    reference: str | None = None
    note: str = ""


@dataclass
class Bench:
    """Collects rows; a row has ratios to those before it."""

    rows: list[dict[str, object]] = field(default_factory=list)
    ns: dict[str, float] = field(default_factory=dict)

    def add(self, name: str, seconds: float, error: float, steps: int = 0, reference: str | None = None, note: str = "") -> None:
        """Keep and print one row: `seconds` for `steps` of all variants together."""
        ns = self.ns[name] = seconds / (steps or STEPS) * 1e9
        to_c, ratio = (ns / self.ns[other] if other in self.ns else None for other in ("c", reference))
        row = {"name": name, "ns_per_step_variant": ns, "ratio_to_c": to_c, "reference": reference, "ratio": ratio, "rms": error}
        self.rows.append({**row, "note": note})
        ratios = "".join(f"{f'{value:#.3g}'.rstrip('.') if value else '':>9s}" for value in (to_c, ratio))
        print(f"{name:35s}{ns:9.1f}{ratios}  {error:<17.12g}{reference or ''}".rstrip(), flush=True)

    def rounds(self, contenders: list[Contender], repeat: int) -> None:
        """Run all in turns, so that other load on the machine affects all alike; the shortest processor time counts.

        Each is timed right after an untimed run of its own, so that the others do not affect its processor caches.
        """
        found = [math.inf] * len(contenders)
        errors = [contender.work().copy() for contender in contenders]
        for _ in range(repeat):
            for i, contender in enumerate(contenders):
                contender.work()
                start = time.process_time()
                contender.work()
                found[i] = min(found[i], time.process_time() - start)
        for one, seconds, error in zip(contenders, found, errors, strict=True):
            self.add(one.name, seconds, rms(error), len(error) * one.variants, one.reference, one.note)

    def notes(self) -> None:
        """Print the remarks on the rows."""
        for row in self.rows:
            if row["note"]:
                print(textwrap.fill(f"{row['name']}: {row['note']}", 110, subsequent_indent="  "))


def in_c(name: str, make: Callable[[], references.Work], variants: int = 1, note: str = "") -> list[Contender]:
    """Return a row in hand-written C; nothing without a compiler."""
    return [Contender(name, make(), variants, note=note)] if references.compiler() else []


def circle() -> cl.Reference:
    """Return two laps; a new reference has no samples yet, so each run computes them."""
    return cl.uniform(PATH, FREQUENCY, 2, PERIOD)


Subject = tuple[cl.Machine, cl.Controller]


def stage_with_backlash() -> Subject:
    """Return two axes with motor, load, shaft, a gap of 25 um and sticking friction, each in four sub-steps, under a cascade."""
    return backlash.machine("two-inertia", "coulomb", 4), backlash.controller()


def single(name: str, reference: Callable[[], cl.Reference], against: str, note: str = "", subject: Subject | None = None) -> Contender:
    """Return one variant through `simulate`."""
    machine, controller = subject or machine_and_controller()

    def work() -> np.ndarray:
        return 1e3 * cl.simulate(machine, controller, reference(), signals=SIGNALS)["contour_error_estimate"]

    return Contender(name, work, 1, against, note)


def spread(n: int) -> dict[str, np.ndarray]:
    """Return n variants whose gains and plants differ by a few per cent; the first is nominal."""
    i = np.arange(n)
    machine, controller = machine_and_controller()
    found = {"controller.coupling.weight": WEIGHT * (1.0 - 0.2 * np.sin(0.3 * i) ** 2)}
    for k, (axis, number) in enumerate((a, p) for a in "xy" for p in ("gain", "damping")):
        value = getattr(machine.axis(axis).plant, number)
        found[f"axes.{axis}.plant.{number}"] = value * (1.0 + 0.05 * np.sin(i * (k + 1.0)))
    for k, (axis, number) in enumerate((a, p) for a in "xy" for p in ("velocity_gain", "position_gain", "integral_gain")):
        value = getattr(controller.axes[axis].controller, number)
        found[f"controller.axes.{axis}.controller.{number}"] = value * (1.0 + 0.1 * np.sin(i * (k + 7.0)))
    return found


IN_C = {"gain": ("gain", 1e3), "damping": ("damping", 1.0)}
IN_C |= {"velocity_gain": ("kv", 1e-3), "position_gain": ("kp", 1e-3), "integral_gain": ("ki", 1.0)}
"""Name and factor in the C of a parameter that varies."""


def numbers_in_c(variants: dict[str, np.ndarray], names: str = "xy") -> tuple[np.ndarray, np.ndarray]:
    """Return variants as the C takes them: the numbers (n_axis, 16, n) of the axes, and the weight (n,)."""
    n = len(next(iter(variants.values())))
    axes = np.repeat(np.array([numbers for _, numbers in zip(names, itertools.cycle(AXES))])[:, :, None], n, axis=2)
    for key, values in variants.items():
        *_, axis, _part, parameter = key.split(".")
        if axis in names:
            name, factor = IN_C[parameter]
            axes[names.index(axis), NAMES.index(name)] = factor * values
    return axes, variants.get("controller.coupling.weight", np.full(n, WEIGHT))


def batch(
    name: str,
    against: str,
    variants: dict[str, np.ndarray],
    note: str = "",
    *,
    pieces: int | None = None,
    subject: Subject | None = None,
    reference: Callable[[], cl.Reference] = circle,
) -> Contender:
    """Return variants in lanes through `simulate_batch`, on one thread."""
    machine, controller = subject or machine_and_controller()
    view = view_of(reference().path, pieces=pieces, analytic=pieces is None)
    held: list[cl.BatchResult] = []

    def work() -> np.ndarray:
        given = {"keep": SIGNALS, "threads": 1, "judge": False, "view": view}
        given["reuse"] = held[0] if held else None  # its memory, as the C does
        held[:] = [cl.simulate_batch(machine, controller, reference(), variants, **given)]
        return 1e3 * held[0].signals["contour_error_estimate"][:, 0, 0]

    return Contender(name, work, len(next(iter(variants.values()))), against, note)


def on_circle() -> list[Contender]:
    """Return the rows of two axes on a circle, evaluated in closed form or as a table."""
    sampled, variants = circle(), spread(32)
    numbers = np.array([*AXES[0], *AXES[1], RADIUS, RATE, WEIGHT])
    rows = [
        *in_c("c", lambda: references.circle(numbers, STEPS, PERIOD), 1, " ".join(references.FLAGS)),
        single("contourlab single", circle, "c", "samples a new reference in each run, as the C and the batches below do"),
        single("contourlab single, sampled before", lambda: sampled, "c", "reuses the samples of one reference"),
        batch("contourlab batch 1", "contourlab single", spread(1)),
    ]
    for table, pieces in (("", None), (" table 4k", 4_000), (" table 200k", 200_000)):
        path = RADIUS if pieces is None else PATH.table(1e-10, pieces=pieces)
        reference, flags = f"c lanes 32{table}", "" if table else f"also {' '.join(references.VECTORS)}"
        rows += in_c(reference, lambda path=path: references.lanes(*numbers_in_c(variants), STEPS, PERIOD, path, (RADIUS, RATE)), 32, flags)
        rows.append(batch(f"contourlab batch 32{table}", reference, variants, pieces=pieces))
        if pieces is None:
            rows.append(batch("contourlab batch 33", "contourlab batch 32", spread(33)))
    return rows


def with_backlash() -> list[Contender]:
    """Return the rows of a stage with backlash."""
    stage = stage_with_backlash()
    gap = {"axes.x.plant.backlash_gap": 25e-6 * (1.0 + 0.05 * np.sin(np.arange(32)))}
    one = "its reference is one variant, not lanes"
    return [
        *in_c("c backlash", lambda: references.backlash(*stage, 1e-3 * RADIUS, RATE, STEPS)),
        single("contourlab backlash single", circle, "c backlash", "two inertias, a gap, true sticking; four sub-steps", stage),
        batch("contourlab backlash batch 32", "c backlash", gap, one, subject=stage),
    ]


def with_five_axes() -> list[Contender]:
    """Return the rows of five axes, which reuse the samples of one reference."""
    five = machine_and_controller("xyzac")
    sampled = cl.uniform(cl.contour("lissajous", axes=5), FREQUENCY, 2, PERIOD)
    samples, table = references.samples_of(sampled), sampled.path.table(1e-10)
    factors = 1.0 + 0.05 * np.sin(np.arange(32))
    gains = {f"axes.{axis.name}.plant.gain": axis.plant.gain * factors for axis in five[0].axes}

    def c(name: str, variants: dict[str, np.ndarray], n: int) -> list[Contender]:
        return in_c(name, lambda: references.lanes(*numbers_in_c(variants, "xyzac"), STEPS, PERIOD, table, samples), n)

    return [
        *c("c five axes", {name: values[:1] for name, values in gains.items()}, 1),
        single("contourlab five axes single", lambda: sampled, "c five axes", "", five),
        *c("c five axes lanes 32", gains, 32),
        batch("contourlab five axes batch 32", "c five axes lanes 32", gains, subject=five, reference=lambda: sampled),
    ]


def relief(lines: int, merge: str = "") -> str:
    """Return a program that mills a relief in lines of 0.25 mm, 160 in a row, blended within 5 um; `merge` Q0: no curves are fitted."""
    text, x, y = [f"G21 G90 G17 G64 P0.005 {merge}", "F3000", "G0 X0 Y0 Z5", "G1 Z0"], 0.0, 0.0
    for i in range(lines):
        y = 0.25 * (i // 160)
        x += -0.25 if i // 160 % 2 else 0.25
        z = -1.0 + 0.6 * math.sin(0.35 * x) * math.cos(0.27 * y) + 0.25 * math.sin(0.9 * x + 0.4 * y)
        text.append(f"G1 X{x:.4f} Y{y:.4f} Z{z:.4f}")
    return "\n".join([*text, "G0 Z5", "M2", ""])


def judging(folder: Path) -> list[Contender]:
    """Return the rows of the judge: a run of a relief on three axes, with the part error of all samples [mm]."""
    (folder / "relief.ngc").write_text(relief(1_600), encoding="utf-8")
    machine = 'machine = {file = "builtin:xyz", servo_period = "0.5 ms"}\ncontroller = "builtin:xyz-controller"\n'
    (folder / "relief.toml").write_text(f'{machine}program = "relief.ngc"\n', encoding="utf-8")
    case = cl.load_scenario(folder / "relief.toml").base
    reference = case.reference()
    run = cl.simulate(case.machine, case.controller, reference)
    judged = cl.judge(run, reference)
    less = (
        "part error alone, on lines; contourlab also finds contour error and planning deviation on lines and blends, and checks its input"
    )
    return [
        *in_c("c nearest point", lambda: references.nearest(judged, reference), 1, less),
        Contender(
            "contourlab judge", lambda: 1e3 * cl.judge(run, reference)["part_error"], 1, "c nearest point", "of a path judged before"
        ),
    ]


def bench_run(bench: Bench, folder: Path) -> None:
    """Time `run` of a relief of 40,000 lines with its report, against its kernels called by hand; once, after one untimed run."""
    (folder / "relief.ngc").write_text(relief(40_000), encoding="utf-8")
    (folder / "relief.toml").write_text('machine = "builtin:xyz"\ncontroller = "builtin:xyz-controller"\nprogram = "relief.ngc"\n')

    def by_hand() -> np.ndarray:
        reference = case.reference()
        return cl.judge(cl.simulate(case.machine, case.controller, reference), reference)["part_error"]

    def run() -> np.ndarray:
        return cl.run(folder / "relief.toml").save(folder / "results").outcomes[0].result["part_error"]

    run()
    case, name = cl.load_scenario(folder / "relief.toml").base, "plan, loop, judge of 40k lines"
    for row, work, against, note in (
        (name, by_hand, None, "called by hand, in memory; the program was read before"),
        (
            "contourlab run 40k",
            run,
            name,
            "reads, plans, runs, judges, sums up, writes; per sample, with all of planning",
        ),
    ):
        start = time.process_time()
        error = 1e3 * work()
        bench.add(row, time.process_time() - start, rms(error), len(error), against, note)


def planning(lines: int = 1_600) -> list[Contender]:
    """Return the rows of the planner, whose steps are lines of a relief; in place of an error the cycle time [s]."""
    from planning import least_time

    limits = load_machine("builtin:xyz").planner_limits()
    corners, smooth = (route_from_program(parse_program(relief(lines, merge))) for merge in ("Q0", ""))
    rounded = blended(corners, limits)

    def row(name: str, work: Callable[[], float], against: str | None, note: str) -> Contender:
        return Contender(name, lambda: np.full(lines, work()), 1, against, f"per line, cycle time in s: {note}")

    def ours(route: Route) -> float:
        return plan(blended(route, limits), limits, PERIOD).duration

    less = "velocity and acceleration alone, at the ends of the curves that contourlab blended; contourlab blends, and keeps the jerk"
    found = [row("toppra", lambda: least_time(rounded, limits, 2), None, less)] if importlib.util.find_spec("toppra") else []
    return [
        *found,
        row("contourlab plan", lambda: ours(corners), "toppra", "every line ends in a corner (Q0)"),
        row("contourlab plan, fitted", lambda: ours(smooth), "toppra", "the same relief, its lines fitted by curves"),
    ]


def timed(repeat: int, n: int, **given: object) -> tuple[float, float]:
    """Return the shortest wall time of n variants judged during the run, and the contour error of the first [mm]."""
    machine, controller = machine_and_controller()
    reference, variants, found = circle(), spread(n), []
    for _ in range(repeat + 1):
        start = time.perf_counter()
        held = cl.simulate_batch(machine, controller, reference, variants, **given)
        found.append(time.perf_counter() - start)
    return min(found[1:]), 1e3 * held.figures["contour_error_rms"][0]


def bench_judged(bench: Bench, repeat: int) -> None:
    """Time a judged batch on one and on two threads, and on a GPU, in wall time."""
    name = "contourlab batch, judged, 2 threads"
    (one, _), (two, error) = (timed(repeat, 128, threads=threads) for threads in (1, 2))
    note = f"128 variants, judged over both laps, which the C is not; wall time; two threads: {one / two:.2f} times one; "
    bench.add(name, two, error, STEPS * 128, "c lanes 32", note + f"{os.cpu_count()} processors")
    try:
        seconds, error = timed(min(repeat, 2), WIDE, gpu=True)
    except EngineError as reason:
        print(f"contourlab gpu: left out: {reason}")
    else:
        bench.add("contourlab gpu", seconds, error, STEPS * WIDE, name, f"{WIDE} variants, as its reference; wall time")


def bench_plain(bench: Bench) -> None:
    """Time the same steps without a compiler."""
    machine, controller = machine_and_controller()
    reference = circle()
    start = time.process_time()
    held = cl.simulate(machine, controller, reference, jit=False, signals=SIGNALS)
    error = 1e3 * rms(held["contour_error_estimate"])
    bench.add("plain python", time.process_time() - start, error, reference="c", note="the components as written")


def bench_others(bench: Bench) -> None:
    """Time other tools, with the whole loop in one function."""
    from others import Work, python_control, scipy_ivp

    work = Work(AXES, RADIUS, FREQUENCY, WEIGHT, PERIOD)
    for name, tool, note in (
        ("python-control", python_control, "one discrete nonlinear system, input_output_response"),
        ("solve_ivp", scipy_ivp, "one call per tick, RK45 at rtol 1e-8 instead of one Runge-Kutta step"),
    ):
        bench.add(name, *tool(work, STEPS), reference="c", note=note)


def main() -> int:
    """Run the benchmark and write benchmarks/out/bench.json."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeat", type=int, default=15, help="rounds; the shortest time of each row counts")
    parser.add_argument("--quick", action="store_true", help="leave out the slow rows")
    options = parser.parse_args()
    bench = Bench()
    print(f"{platform.platform()}, Python {platform.python_version()}, {os.cpu_count()} processors; {STEPS} steps of {PERIOD * 1e3:g} ms")
    if not references.compiler():
        print("No C compiler found: the rows in C are left out, and ratios to them are empty")
    print("Nanoseconds per step (planner: line) and variant; rms contour error of the second lap in mm")
    print("(judge: part error, second half; planner: cycle time in s)")
    print(f"{'':35s}{'ns':>9s}{'to C':>9s}{'ratio':>9s}  {'rms':17s}ratio to")
    with tempfile.TemporaryDirectory() as folder:
        bench.rounds([*on_circle(), *with_backlash(), *with_five_axes(), *judging(Path(folder)), *planning()], options.repeat)
        if not options.quick:
            bench_run(bench, Path(folder))
    bench_judged(bench, min(options.repeat, 7))
    if not options.quick:
        bench_plain(bench)
        bench_others(bench)
    bench.notes()
    figures_file.write("bench.json", bench.rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
