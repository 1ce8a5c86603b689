"""Cost of a study: wall time, processor time, memory and disk of `contourlab sweep` on the circle of `run.py`.

    python benchmarks/sweep.py --variants 100000 --executor threads --executor dask-local --period "0.1 ms"

Two axes with friction, observer and modified reference run a circle of 20 mm for 4 s. Processor time includes workers and scheduler;
memory is that of the largest process. With more executors, each row has its processor time relative to the first one's. The last rows
ask the store for yield, worst cases, the report and a quantile.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

STUDY = """
scenario = "circle.toml"
variants = {variants}
tolerance = "10 um"

[vary]
"axes.*.friction.coulomb" = {{ normal = ["100 %", "20 %"] }}
"axes.*.plant.gain" = {{ normal = ["100 %", "5 %"] }}
"""
CIRCLE = """
machine = {{ file = "builtin:ghaffari/a3a1", servo_period = "{period}" }}
controller = "builtin:ghaffari/calibrated"
contour = {{ name = "circle", radius = "20 mm" }}
feed = {{ law = "uniform", frequency = "0.5 Hz", laps = 2 }}
"""


def cost(command: list[str], folder: str | None = None, allowed: tuple[int, ...] = (0,)) -> tuple[float, float, float]:
    """Run a command; return its wall time [s], processor time with all its children [s] and largest process [MB].

    It runs in a folder, by default this one. An exit code that is not allowed ends the benchmark.
    """
    begun = time.perf_counter()
    with tempfile.TemporaryFile() as errors:
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=errors, cwd=folder)
        _, status, usage = os.wait4(process.pid, 0)
        if os.waitstatus_to_exitcode(status) not in allowed:
            errors.seek(0)
            sys.exit(f"failed: {' '.join(command)}\n{errors.read().decode()}")
    return time.perf_counter() - begun, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main() -> None:
    """Print one row for each executor."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--variants", type=int, default=100_000)
    parser.add_argument("--period", default="1 ms")
    parser.add_argument("--executor", action="append")
    options = parser.parse_args()
    print(f"{'executor':<11} {'wall s':>8} {'cpu s':>8} {'ms each':>8} {'MB':>6} {'disk MB':>8} {'to first':>8}")
    first = None
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "circle.toml").write_text(CIRCLE.format(period=options.period), encoding="utf-8")
        (folder / "study.toml").write_text(STUDY.format(variants=options.variants), encoding="utf-8")
        for executor in options.executor or ["threads"]:
            store = Path(tempfile.mkdtemp(dir=folder)) / "store"
            where = ["--executor", executor, "--out", str(store)]
            wall, cpu, memory = cost([sys.executable, "-m", "contourlab", "sweep", str(folder / "study.toml"), "--yes", *where])
            first = first or cpu
            disk = sum(file.stat().st_size for file in store.iterdir()) / 1e6
            row = f"{executor:<11} {wall:8.1f} {cpu:8.1f} {1e3 * cpu / options.variants:8.3f} {memory:6.0f} {disk:8.1f}"
            print(f"{row} {cpu / first:8.3f}", flush=True)
        for words in (["show"], ["worst"], ["report"], ["query", "SELECT quantile_cont(part_error_max, 0.99) FROM results"]):
            wall, cpu, memory = cost([sys.executable, "-m", "contourlab", "sweep", words[0], str(store), *words[1:]])
            print(f"{words[0]:<11} {wall:8.1f} {cpu:8.1f} {'':8} {memory:6.0f}", flush=True)


if __name__ == "__main__":
    main()
