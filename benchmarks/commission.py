"""Random machines under LinuxCNC: from one log to gains, and what the control then does.

    python benchmarks/commission.py --machines 3 --seed 1

Each machine has two axes of random gain, damping, friction, play and encoder noise. `contourlab commission` sees the excitation's log and
the files only. Its gains then run the excitation again, and with the gain of the axes 25 % smaller and larger. Needs the rig of the
tests (`tests/helpers/linuxcnc_rig.py`: LinuxCNC and root); about four minutes per machine.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))
from linuxcnc_rig import PID, Plant, Rig, RigError, missing

from contourlab.features.commission.command import commission

COLUMNS = ("machine", "axis", "gain", "damping", "friction", "play mm", "noise um", "before um", "after um", "predicted um")
HEADS = f"| {' | '.join((*COLUMNS, 'before/after', 'gain -25 %', 'gain +25 %'))} |"


def machine(generator: np.random.Generator) -> dict[str, Plant]:
    """Return two random axes."""

    def between(low: float, high: float) -> float:
        return float(np.exp(generator.uniform(np.log(low), np.log(high))))

    ranges = ((800, 6000), (5, 80), (5, 60), (0.005, 0.05), (5e-5, 1e-3))
    return {a: Plant(*(between(*ends) for ends in ranges), int(generator.choice([1, 20]))) for a in "xy"}


def largest(log: Path, like: Path | None = None) -> dict[str, float]:
    """Return the largest |command - motor position| [um] of each axis, of a log whose commands reach as far as those of another."""
    rows = np.loadtxt(log, delimiter=",", skiprows=1)
    if like is not None:
        wanted = np.ptp(np.loadtxt(like, delimiter=",", skiprows=1)[:, 1:3], axis=0)
        if not np.allclose(np.ptp(rows[:, 1:3], axis=0), wanted, rtol=0.01):
            raise RigError("the program ended early: is the machine too busy for LinuxCNC?")
    return {a: 1e3 * float(np.abs(rows[:, 1 + k] - rows[:, 3 + k]).max()) for k, a in enumerate("xy")}


def answer(plants: dict[str, Plant], folder: Path) -> list[str]:
    """Commission a machine and run it with the new gains; return its rows without the machine's number."""
    rig = Rig(plants)
    ini, hal = rig.write(folder)
    commission(ini, hal).save(folder / "out")
    program = (folder / "out" / "excite.ngc").read_text()
    before = largest(rig.run(program, folder / "log.csv"))
    begun = time.perf_counter()
    result = commission(ini, hal, log=[folder / "log.csv"]).save(folder / "out")
    print(f"gains after {time.perf_counter() - begun:.0f} s; {', '.join(one.code for one in result.findings)}", file=sys.stderr)
    runs = {}
    for share in (1.0, 0.75, 1.25):
        scaled = {a: replace(plant, gain=share * plant.gain) for a, plant in plants.items()}
        try:
            runs[share] = largest(Rig(scaled, result.pid).run(program, folder / f"{share}.csv"), folder / "log.csv")
        except RigError as error:
            runs[share] = dict.fromkeys("xy", float("nan"))
            print(f"gain x {share}: {error}", file=sys.stderr)
    rows = []
    for a, plant in plants.items():
        numbers = [plant.gain, plant.damping, plant.friction, plant.play, 1e3 * plant.noise]
        predicted = result.predicted[a].after if a in result.predicted else float("nan")
        numbers += [before[a], runs[1.0][a], predicted, before[a] / runs[1.0][a], runs[0.75][a], runs[1.25][a]]
        rows.append(" | ".join([a, *(f"{number:.3g}" for number in numbers)]))
    return rows


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--machines", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if missing():
        sys.exit(missing())
    print(f"Before: {PID}\n\n{HEADS}\n|{'---|' * (HEADS.count('|') - 1)}")
    generator = np.random.default_rng(options.seed)
    for number in range(1, options.machines + 1):
        with tempfile.TemporaryDirectory(dir=Path.home()) as name:
            for row in answer(machine(generator), Path(name)):
                print(f"| {number} | {row} |", flush=True)


if __name__ == "__main__":
    main()
