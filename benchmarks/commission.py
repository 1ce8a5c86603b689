"""Random machines under LinuxCNC: from one log to gains, and what the control then does.

    python benchmarks/commission.py --machines 3 --seed 1 [--drive velocity]

Each machine has two axes of random gain, damping, friction, play and encoder noise; a velocity drive has a loop of 50 to 500 1/s, mostly
with an integral. `contourlab commission` sees the excitation's log and
the files only. Its gains then run the excitation again, and with the gain of the axes 25 % smaller and larger. Needs the rig of the
tests (`tests/helpers/linuxcnc_rig.py`: LinuxCNC and root); about five minutes per machine.
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

COLUMNS = ("machine", "axis", "gain", "damping", "friction", "play mm", "noise um", "loop 1/s", "integral 1/s", "before um")
COLUMNS += ("after um", "predicted um", "load um", "predicted um")
HEADS = f"| {' | '.join((*COLUMNS, 'before/after', 'gain -25 %', 'gain +25 %'))} |"


def machine(generator: np.random.Generator, drive: str) -> dict[str, Plant]:
    """Return two random axes."""

    def between(low: float, high: float) -> float:
        return float(np.exp(generator.uniform(np.log(low), np.log(high))))

    ranges = ((800, 6000), (5, 80), (5, 60), (0.005, 0.05), (5e-5, 1e-3))
    if drive == "torque":
        return {a: Plant(*(between(*ends) for ends in ranges), substeps=int(generator.choice([1, 20]))) for a in "xy"}
    plants = {}
    for a in "xy":
        loop, scale = between(50, 500), float(generator.choice([1.0, 20.0]))
        reset = between(3, 0.2 * loop) if generator.random() < 0.7 else 0.0
        numbers = (scale * loop, loop + between(3, 30), *(between(*ends) for ends in ranges[2:]))
        plants[a] = Plant(*numbers, regulated=loop, reset=reset)
    return plants


def scaled(plant: Plant, share: float) -> Plant:
    """Return an axis with another gain, which is that of the velocity loop in its drive, if it has one."""
    loop = share * plant.regulated
    return replace(plant, gain=share * plant.gain, damping=plant.damping - plant.regulated + loop, regulated=loop)


def slow(plant: Plant) -> dict[str, float]:
    """Return the gains of a velocity drive before: a loop gain of 12 1/s, and four fifths of the feedforward."""
    return {"Pgain": 12.0 * plant.regulated / plant.gain, "Igain": 0.0, "FF1": 0.8 * plant.regulated / plant.gain}


def largest(log: Path, like: Path | None = None, first: int = 3) -> dict[str, float]:
    """Return the largest |command - position| [um] of each axis, of a log whose commands reach as far as those of another.

    The first column of the positions is 3 for the motors and 5 for the loads.
    """
    rows = np.loadtxt(log, delimiter=",", skiprows=1)
    if like is not None:
        wanted = np.ptp(np.loadtxt(like, delimiter=",", skiprows=1)[:, 1:3], axis=0)
        if not np.allclose(np.ptp(rows[:, 1:3], axis=0), wanted, rtol=0.01):
            raise RigError("the program ended early: is the machine too busy for LinuxCNC?")
    return {a: 1e3 * float(np.abs(rows[:, 1 + k] - rows[:, first + k]).max()) for k, a in enumerate("xy")}


def answer(plants: dict[str, Plant], folder: Path) -> list[str]:
    """Commission a machine and run it with the new gains; return its rows without the machine's number."""
    rig = Rig(plants, {a: slow(plant) for a, plant in plants.items() if plant.regulated})
    ini, hal = rig.write(folder)
    commission(ini, hal).save(folder / "out")
    program = (folder / "out" / "excite.ngc").read_text()
    before = largest(rig.run(program, folder / "log.csv"))
    begun = time.perf_counter()
    result = commission(ini, hal, log=[folder / "log.csv"]).save(folder / "out")
    print(f"gains after {time.perf_counter() - begun:.0f} s; {', '.join(one.code for one in result.findings)}", file=sys.stderr)
    runs = {}
    for share in (1.0, 0.75, 1.25):
        others = {a: scaled(plant, share) for a, plant in plants.items()}
        try:
            runs[share] = largest(Rig(others, result.pid).run(program, folder / f"{share}.csv"), folder / "log.csv")
        except RigError as error:
            runs[share] = dict.fromkeys("xy", float("nan"))
            print(f"gain x {share}: {error}", file=sys.stderr)
    loads, rows = largest(folder / "1.0.csv", first=5), []
    for a, plant in plants.items():
        numbers = [plant.gain, plant.damping, plant.friction, plant.play, 1e3 * plant.noise, plant.regulated, plant.reset]
        known = result.predicted.get(a)
        after, load = (known.after, known.load) if known else (float("nan"), float("nan"))
        numbers += [before[a], runs[1.0][a], after, loads[a], load, before[a] / runs[1.0][a], runs[0.75][a], runs[1.25][a]]
        rows.append(" | ".join([a, *(f"{number:.3g}" for number in numbers)]))
    return rows


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--machines", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--drive", choices=("torque", "velocity"), default="torque")
    options = parser.parse_args()
    if missing():
        sys.exit(missing())
    before = PID if options.drive == "torque" else "a loop gain of 12 1/s, four fifths of the feedforward"
    print(f"Before: {before}\n\n{HEADS}\n|{'---|' * (HEADS.count('|') - 1)}")
    generator = np.random.default_rng(options.seed)
    for number in range(1, options.machines + 1):
        with tempfile.TemporaryDirectory(dir=Path.home()) as name:
            for row in answer(machine(generator, options.drive), Path(name)):
                print(f"| {number} | {row} |", flush=True)


if __name__ == "__main__":
    main()
