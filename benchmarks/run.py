"""`make bench`: time the same work, done in several ways; see README.md."""

from __future__ import annotations

import argparse
import ctypes
import itertools
import json
import math
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import backlash
import numpy as np

import contourlab as cl
from contourlab.components.controller.position import PositionController
from contourlab.components.coupling.laws import ModifiedReference
from contourlab.components.drive.saturation import Saturation
from contourlab.components.estimator.newton import Newton
from contourlab.components.friction.laws import SmoothCoulomb
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.plant import RigidAxis
from contourlab.geometry.view import view_of

HERE = Path(__file__).resolve().parent
PERIOD, STEPS, RADIUS, FREQUENCY, WEIGHT = 1e-4, 40_000, 20.0, 0.5, 0.75
PATH = cl.contour("circle", radius=1e-3 * RADIUS)
FLAGS = ("-O3", "-march=native", "-fPIC", "-shared")
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
    """Return the root mean square over the second lap [mm]."""
    return float(np.sqrt(np.mean(np.square(error[STEPS // 2 :]))))


def compiled_c(folder: Path) -> ctypes.CDLL | None:
    """Compile the reference, or return None without a compiler."""
    compiler = next((c for c in ("cc", "gcc", "clang") if shutil.which(c)), None)
    if compiler is None:
        return None
    library = folder / "reference.so"
    subprocess.run([compiler, *FLAGS, "-o", str(library), str(HERE / "reference.c"), "-lm"], check=True)
    return ctypes.CDLL(str(library))


@dataclass
class Contender:
    """One way to do the work: `work` runs once and returns the error signal of the nominal variant [mm]."""

    name: str
    work: Callable[[], np.ndarray]
    variants: int = 1
    note: str = ""


class Bench:
    """Collects rows."""

    def __init__(self) -> None:
        self.rows: list[dict[str, object]] = []
        self.reference: float | None = None

    def add(self, name: str, seconds: float, error: float, variants: int = 1, note: str = "") -> None:
        """Keep and print one row."""
        ns = seconds / STEPS / variants * 1e9
        if name == "c":
            self.reference = ns
        ratio = ns / self.reference if self.reference else None
        self.rows.append({"name": name, "ns_per_step_variant": ns, "ratio_to_c": ratio, "rms": error, "note": note})
        shown = f"{ratio:10.3f}" if ratio is not None else " " * 10
        print(f"{name:36s}{ns:14.1f}{shown}   {error:.12g}   {note}", flush=True)

    def rounds(self, contenders: list[Contender], repeat: int) -> None:
        """Run all in turns, so that other load on the machine affects all alike; the shortest processor time counts.

        Each is timed right after an untimed run of its own, so that the others do not affect its processor caches.
        """
        error = {contender.name: rms(contender.work()) for contender in contenders}
        found = dict.fromkeys(error, math.inf)
        for _ in range(repeat):
            for contender in contenders:
                contender.work()
                start = time.process_time()
                contender.work()
                found[contender.name] = min(found[contender.name], time.process_time() - start)
        for one in contenders:
            self.add(one.name, found[one.name], error[one.name], one.variants, one.note)


def in_c(folder: Path) -> list[Contender]:
    """Return the hand-written C; nothing without a compiler."""
    library = compiled_c(folder)
    if library is None:
        print("c: no compiler found, so no ratios")
        return []
    numbers = np.array([*AXES[0], *AXES[1], RADIUS, 2.0 * math.pi * FREQUENCY, WEIGHT])
    log = np.zeros((STEPS, 5))
    pointer = ctypes.POINTER(ctypes.c_double)
    function = library.simulate
    function.argtypes = [pointer, ctypes.c_ssize_t, ctypes.c_double, pointer]

    def work() -> np.ndarray:
        function(numbers.ctypes.data_as(pointer), STEPS, PERIOD, log.ctypes.data_as(pointer))
        return log[:, 4]

    return [Contender("c", work, note=" ".join(FLAGS))]


def circle() -> cl.Reference:
    """Return two laps; a new reference has no samples yet, so each run computes them."""
    return cl.uniform(PATH, FREQUENCY, 2, PERIOD)


Subject = tuple[cl.Machine, cl.Controller]


def stage_with_backlash() -> Subject:
    """Return two axes with motor, load, shaft, a gap of 25 um and sticking friction, each in four sub-steps, under a cascade."""
    return backlash.machine("two-inertia", "coulomb", 4), backlash.controller()


def single(name: str, reference: Callable[[], cl.Reference], note: str, subject: Subject | None = None) -> Contender:
    """Return one variant through `simulate`."""
    machine, controller = subject or machine_and_controller()

    def work() -> np.ndarray:
        return 1e3 * cl.simulate(machine, controller, reference(), signals=SIGNALS)["contour_error_estimate"]

    return Contender(name, work, note=note)


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


def batch(
    name: str,
    pieces: int | None = None,
    subject: Subject | None = None,
    reference: Callable[[], cl.Reference] = circle,
    variants: dict[str, np.ndarray] | None = None,
    note: str = "samples a new reference in each run",
) -> Contender:
    """Return 32 variants in lanes through `simulate_batch`, on one thread."""
    machine, controller = subject or machine_and_controller()
    view = view_of(reference().path, pieces=pieces, analytic=pieces is None)
    held: list[cl.BatchResult] = []

    def work() -> np.ndarray:
        given = {"keep": SIGNALS, "threads": 1, "judge": False, "view": view}
        given["reuse"] = held[0] if held else None  # its memory, as the C does
        held[:] = [cl.simulate_batch(machine, controller, reference(), variants or spread(32), **given)]
        return 1e3 * held[0].signals["contour_error_estimate"][:, 0, 0]

    return Contender(name, work, 32, note)


def more_machines() -> list[Contender]:
    """Return a stage with backlash and a machine of five axes, each single and in a batch whose first variant is nominal."""
    factors = 1.0 + 0.05 * np.sin(np.arange(32))
    loose, five = stage_with_backlash(), machine_and_controller("xyzac")
    sampled = cl.uniform(cl.contour("lissajous", axes=5), FREQUENCY, 2, PERIOD)
    gap = {"axes.x.plant.backlash_gap": 25e-6 * factors}
    gains = {f"axes.{axis.name}.plant.gain": axis.plant.gain * factors for axis in five[0].axes}
    return [
        single("contourlab backlash single", circle, "two inertias, a gap, true sticking; four sub-steps", loose),
        batch("contourlab backlash batch 32", None, loose, circle, gap),
        single("contourlab five axes single", lambda: sampled, "reuses the samples of one reference", five),
        batch("contourlab five axes batch 32", None, five, lambda: sampled, gains, "reuses the samples of one reference"),
    ]


def bench_threads(bench: Bench, repeat: int) -> None:
    """Time a batch on one and on two threads, in wall time."""
    machine, controller = machine_and_controller()
    reference = circle()
    variants = spread(128)
    times = {}
    for threads in (1, 2):
        cl.simulate_batch(machine, controller, reference, variants, threads=threads)
        found = []
        for _ in range(repeat):
            start = time.perf_counter()
            held = cl.simulate_batch(machine, controller, reference, variants, threads=threads)
            found.append(time.perf_counter() - start)
        times[threads] = min(found)
    note = f"128 variants, judged during the run; two threads: {times[1] / times[2]:.2f} times one; {os.cpu_count()} processors"
    bench.add("contourlab batch, judged, 2 threads", times[2], 1e3 * held.figures["contour_error_rms"][0], 128, note=note)


def bench_plain(bench: Bench) -> None:
    """Time the same steps without a compiler."""
    machine, controller = machine_and_controller()
    reference = circle()
    start = time.process_time()
    held = cl.simulate(machine, controller, reference, jit=False, signals=SIGNALS)
    bench.add("plain python", time.process_time() - start, 1e3 * rms(held["contour_error_estimate"]), note="the components as written")


def bench_others(bench: Bench) -> None:
    """Time other tools, with the whole loop in one function."""
    from others import Work, python_control, scipy_ivp

    work = Work(AXES, RADIUS, FREQUENCY, WEIGHT, PERIOD)
    for name, tool, note in (
        ("python-control", python_control, "one discrete nonlinear system, input_output_response"),
        ("solve_ivp", scipy_ivp, "one call per tick, RK45 at rtol 1e-8 instead of one Runge-Kutta step"),
    ):
        bench.add(name, *tool(work, STEPS), note=note)


def main() -> int:
    """Run the benchmark and write benchmarks/out/bench.json."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeat", type=int, default=15, help="rounds; the shortest time of each row counts")
    parser.add_argument("--quick", action="store_true", help="leave out the slow rows")
    options = parser.parse_args()
    bench = Bench()
    print(f"{platform.platform()}, Python {platform.python_version()}, {os.cpu_count()} processors; {STEPS} steps of {PERIOD * 1e3:g} ms")
    print(f"{'':36s}{'ns/step/variant':>14s}{'to C':>10s}   rms contour error, second lap [mm]")
    sampled = circle()
    with tempfile.TemporaryDirectory() as folder:
        contenders = [
            *in_c(Path(folder)),
            single("contourlab single", circle, "samples a new reference in each run"),
            single("contourlab single, sampled before", lambda: sampled, "reuses the samples of one reference"),
            batch("contourlab batch 32"),
            batch("contourlab batch 32 table 4k", 4_000),
            batch("contourlab batch 32 table 200k", 200_000),
            *more_machines(),
        ]
        bench.rounds(contenders, options.repeat)
    bench_threads(bench, min(options.repeat, 7))
    if not options.quick:
        bench_plain(bench)
        bench_others(bench)
    out = HERE / "out"
    out.mkdir(exist_ok=True)
    (out / "bench.json").write_text(json.dumps({"platform": platform.platform(), "rows": bench.rows}, indent=2), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
