"""Look for wrong answers: ``python tools/fuzz --minutes 10``.

A damaged file must end with one of the exit codes 0, 1, 2, 3 and 130; a file with a digest also with the answer of the intact one. Two
sound inputs that belong together, such as a program in mm and in inch, must have the same figures. Each input has 60 s and 1 GB. Those that
fail are written whole into ``results/fuzz``, with the command that repeats them. Input number i depends on the seed and i only.
"""

from __future__ import annotations

import os

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # a process that forks must have no threads

import argparse
import contextlib
import io
import random
import resource
import shutil
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from damage import Damaged, Kind, damaged, kinds, programs
from pool import Pool
from relations import RELATIONS, Related, related, warm

KEPT = Path("results/fuzz")
SHARE = 0.25
"""Share of the odd inputs that are two sound ones."""


def made(number: int, seed: int, known: list[Kind], only: str = "") -> Damaged | Related:
    """Return an input: for an even number a damaged program, else another file or a relation; ``only`` names a relation or file."""
    draw = random.Random(f"{seed}/{number}")
    if only in RELATIONS or (not only and number % 2 and draw.random() < SHARE):
        return related(draw, only)
    chosen = [kind for kind in known if only in kind.file]
    kind = draw.choices(chosen, [kind.weight for kind in chosen])[0]
    return Damaged(kind, damaged(draw.choice(kind.seeds), draw))


def keep(number: int, fault: str, given: Damaged | Related, repeat: str) -> None:
    """Write an input, what is wrong, and how to repeat it; print both."""
    folder = KEPT / str(number)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    given.write(folder)
    lines = [f"input {number}: {fault}", *(f"  cd {folder}; contourlab {words}" for words in given.commands), f"  again: {repeat}"]
    (folder / "fault.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(*lines, sep="\n", flush=True)


@dataclass
class Tally:
    """Inputs, faults and time [s] by name."""

    tried: Counter[str] = field(default_factory=Counter)
    faults: Counter[str] = field(default_factory=Counter)
    seconds: dict[str, float] = field(default_factory=dict)
    begun: float = field(default_factory=time.monotonic)

    def add(self, name: str, fault: str, seconds: float) -> None:
        self.tried[name] += 1
        self.faults[name] += bool(fault)
        self.seconds[name] = self.seconds.get(name, 0.0) + seconds

    @property
    def line(self) -> str:
        """Inputs, their rate, faults; at the end the time of a processor, which says what an idle machine could do."""
        count, used = max(self.tried.total(), 1), resource.getrusage(resource.RUSAGE_CHILDREN)
        rate, each = count / (time.monotonic() - self.begun), 1e3 * (used.ru_utime + used.ru_stime) / count
        cost = f", {each:.0f} ms of a processor each" if each else ""  # known when the workers have ended
        return f"{self.tried.total()} inputs, {rate:.1f} a second{cost}, {self.faults.total()} faults"

    @property
    def table(self) -> str:
        rows = ((name, count, self.faults[name], 1e3 * self.seconds[name] / count) for name, count in sorted(self.tried.items()))
        return "\n".join(f"{count:8d} {name}: {faults} faults, {each:.0f} ms each" for name, count, faults, each in rows)


def main() -> int:
    """Fuzz; return 1 if there was a fault."""
    options = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    options.add_argument("--minutes", type=float, default=10.0)
    options.add_argument("--seed", type=int, default=0)
    options.add_argument("--first", type=int, default=0, help="number of the first input")
    options.add_argument("--count", type=int, default=10**9, help="most inputs")
    options.add_argument("--only", default="", help=f"one relation ({', '.join(RELATIONS)}), or part of the name of a damaged file")
    options.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    given = options.parse_args()
    pool, numbers, known = Pool(60.0 * given.minutes), range(given.first, given.first + given.count), programs()

    def crew(known: list[Kind]) -> Callable[[int, Path], str]:
        return lambda number, folder: made(number, given.seed, known, given.only).fault(folder)

    few, others = (range(0), numbers) if given.only else (numbers[given.first % 2 :: 2], numbers[1 - given.first % 2 :: 2])
    pool.hire(few, crew(known))  # one worker suffices: it reads programs, and its process is small
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()):
        warm(Path(folder))
        many = kinds() + (known if given.only else [])
    if given.only not in RELATIONS and not any(given.only in kind.file for kind in many):
        options.error(f"--only {given.only}: no such relation or file")
    for k in range(given.workers):
        pool.hire(others[k :: given.workers], crew(many))
    tally, shown = Tally(), time.monotonic()
    for number, fault, seconds in pool.results():
        one = made(number, given.seed, many if given.only or number % 2 else known, given.only)
        tally.add(one.name, fault, seconds)
        if fault:
            only = f" --only '{given.only}'" if given.only else ""
            keep(number, fault, one, f"python tools/fuzz --seed {given.seed} --first {number} --count 1{only}")
        if time.monotonic() - shown > 10.0:
            shown = time.monotonic()
            print(tally.line, flush=True)
    print(tally.table, f"{tally.line}, seed {given.seed}", sep="\n")
    return int(tally.faults.total() > 0)


if __name__ == "__main__":
    sys.exit(main())
