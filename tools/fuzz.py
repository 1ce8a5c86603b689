"""Try damaged input files on the commands that read them: ``python tools/fuzz.py --minutes 10``.

Every input must end with one of the exit codes 0, 1, 2, 3 and 130, within 60 s and 1 GB of memory. Inputs that do not are kept in
``results/fuzz``, and their commands are printed. Input number i depends only on the seed and i.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import multiprocessing
import os
import random
import resource
import string
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))
from typed_commands import DRAG, ON_XYZ

CODES = {0, 1, 2, 3, 130}
SECONDS, BYTES = 60.0, 1 << 30
KEPT = Path("results/fuzz")
ODD = (
    b"nan inf -inf 1e308 1e-308 -1 0 -0.0 99999999999 1e400 [ ] { } \" ' # ( ) % ; , = . \\ / ../ \0 \xff \r\n [[]] true none um 1/s"
).split(b" ")
FEW = ("--most-moves", "500")  # endless loops are frequent
PROGRAM = b"""%
o<pocket> sub
#<depth> = #1
o1 while [#<depth> GT -2]
G0 X0 Y0
G1 Z[#<depth>] F200
G2 X5 Y5 I5 J0
G64 P0.02
G5.1 X2 Y3 I1 J1
#<depth> = [#<depth> - 1]
o1 endwhile
o<pocket> endsub
G21 G90 G17 G54
o<pocket> call [0]
G81 X1 Y1 Z-1 R2 F100
G80
G20 G91
G1 X[SIN[30] * 2] F10
M30
%
"""
SHAPE = (
    b'<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100"><g transform="rotate(10)">'
    b'<path d="M 10 10 L 30 10 A 10 10 0 0 1 30 30 C 20 40 15 40 10 30 Z"/></g></svg>'
)
AROUND_SHAPE = """machine = "builtin:xyz"
controller = "builtin:xyz-controller"
contour = "{}"
[feed]
law = "planned"
feedrate = "1000 mm/min"
"""


@dataclass(frozen=True)
class Kind:
    """One kind of input: file name, texts to damage, and the words of its command, where FILE stands for the file."""

    file: str
    seeds: tuple[bytes, ...]
    words: tuple[str, ...]
    beside: tuple[tuple[str, str], ...] = ()


def kinds() -> list[Kind]:
    """Return all kinds of inputs; frequent ones several times."""
    import numpy as np
    from scipy.io import savemat

    from contourlab.result import Result, Signal
    from contourlab.scenario import load_scenario
    from contourlab.scenario.dump import dump

    shipped = files("contourlab") / "machines"
    program = (shipped / "programs" / "circle_diamond_square.ngc").read_bytes()
    whole = tuple(
        dump(load_scenario(f"builtin:{name}")).encode() for name in ("demo-part", "gecer-ulu/contour", "emps/circle")
    )
    t = 1e-3 * np.arange(200)
    x, y = 10.0 * np.sin(3.0 * t), 10.0 * np.cos(3.0 * t)
    names = ("time [s]", "x ref [mm]", "x pos [mm]", "y ref [mm]", "y pos [mm]")
    rows = np.column_stack([t, x, x + 1e-3, y, y - 1e-3])
    table = "\n".join([",".join(names), *(",".join(f"{v:.9g}" for v in row) for row in rows)]).encode()
    stream = io.BytesIO()
    savemat(stream, {"time": t, "x_ref": x, "x_pos": x, "y_ref": y, "y_pos": y})
    mat = b"MATLAB 5.0 MAT-file".ljust(116) + stream.getvalue()[116:]  # without the present time
    with tempfile.TemporaryDirectory() as folder:
        Result("base", ("x",), 1e-3, {"position": Signal(x[:, None], ("sample", "axis"), "m")}).save(f"{folder}/run.nc")
        result = Path(folder, "run.nc").read_bytes()
    measure = ("measure", "FILE", "--out", "out", "--json")
    return [
        *[Kind("part.ngc", (PROGRAM, program[:3000]), ("canon", "FILE", *FEW))] * 24,
        Kind("part.ngc", (PROGRAM, program[:800]), ("check", "FILE", *FEW)),
        Kind("part.ngc", (PROGRAM, program[:800]), ("run", "FILE", *ON_XYZ, *FEW, "--check")),
        *[Kind("scenario.toml", whole, ("run", "FILE", "--check"))] * 10,
        Kind("shape.svg", (SHAPE,), ("run", "scenario.toml", "--check"), (("scenario.toml", AROUND_SHAPE.format("shape.svg")),)),
        Kind("shape.csv", (table,), ("run", "scenario.toml", "--check"), (("scenario.toml", AROUND_SHAPE.format("shape.csv")),)),
        *[Kind("log.csv", (table,), measure)] * 4,
        Kind("log.mat", (mat,), measure),
        Kind("run.nc", (result,), measure),
        Kind("plugin.py", (DRAG.encode(),), ("components", "--plugin", "FILE")),
    ]


def damaged(seed: bytes, draw: random.Random) -> bytes:
    """Return a text after one to six changes: of bytes, tokens, numbers or lines."""
    text = bytearray(seed)
    for _ in range(draw.choice((1, 1, 2, 3, 6))):
        at = draw.randrange(len(text) + 1)
        how = draw.randrange(7)
        if how == 0 and text:
            text[min(at, len(text) - 1)] ^= 1 << draw.randrange(8)
        elif how == 1:
            del text[at : at + draw.choice((1, 2, 8, 64))]
        elif how == 2:
            text[at:at] = draw.choice(ODD)
        elif how == 3:
            text[at:at] = draw.choice(string.printable).encode() * draw.choice((1, 1, 1, 50))
        elif how == 4:
            end = at
            while end < len(text) and chr(text[end]) in string.digits + ".-e":
                end += 1
            text[at:end] = draw.choice(ODD)
        else:
            lines = bytes(text).split(b"\n")
            one, other = draw.randrange(len(lines)), draw.randrange(len(lines))
            if how == 5:
                lines[one], lines[other] = lines[other], lines[one]
            else:
                lines[one:one] = lines[other : other + 1] * draw.choice((1, 1, 3))
            text = bytearray(b"\n".join(lines))
    return bytes(text)


def made(number: int, seed: int, known: list[Kind]) -> tuple[Kind, bytes]:
    """Return the kind and the text of an input."""
    draw = random.Random(f"{seed}/{number}")
    kind = draw.choice(known)
    return kind, damaged(draw.choice(kind.seeds), draw)


def tried(kind: Kind, text: bytes) -> str:
    """Run the command on one input, in the present folder; return what is wrong, or nothing."""
    from contourlab.cli.main import main

    Path(kind.file).write_bytes(text)
    for name, content in kind.beside:
        Path(name).write_text(content, encoding="utf-8")
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = main([kind.file if word == "FILE" else word for word in kind.words])
    if code not in CODES:
        return f"exit code {code}: {err.getvalue().strip()[-300:]}"
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)  # bytes on macOS, else kB
    if peak > BYTES:
        return f"{peak >> 20} MB of memory"
    return ""


def work(known: list[Kind], first: int, step: int, seed: int, current: Any, begun: Any, faults: Any) -> None:
    """Try the inputs first, first + step, ... until killed; leave after a fault that may have damaged the process."""
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        number = first
        while True:
            current.value, begun.value = number, time.monotonic()
            kind, text = made(number, seed, known)
            fault = tried(kind, text)
            if fault:
                faults.put((number, fault))
                return
            number += step


@dataclass
class Worker:
    """A process with the number of its present input and when that began."""

    known: list[Kind]
    step: int
    seed: int
    faults: Any
    process: Any = None
    current: Any = None
    begun: Any = None

    def start(self, first: int) -> None:
        self.current, self.begun = multiprocessing.Value("q", first), multiprocessing.Value("d", time.monotonic())
        given = (self.known, first, self.step, self.seed, self.current, self.begun, self.faults)
        self.process = multiprocessing.Process(target=work, args=given, daemon=True)
        self.process.start()


def fuzz(known: list[Kind], minutes: float, seed: int, first: int, n_worker: int) -> Iterator[tuple[int, str]]:
    """Yield the number and the fault of inputs until the time is up; print the number of inputs tried."""
    faults: Any = multiprocessing.Queue()
    workers = [Worker(known, n_worker, seed, faults) for _ in range(n_worker)]
    for k, worker in enumerate(workers):
        worker.start(first + k)
    end, shown = time.monotonic() + 60.0 * minutes, 0.0
    while time.monotonic() < end:
        time.sleep(0.2)
        for worker in workers:
            late, code = time.monotonic() - worker.begun.value > SECONDS, worker.process.exitcode
            if late:
                worker.process.kill()
                yield worker.current.value, f"more than {SECONDS:g} s"
            elif code:  # 0: it has reported a fault
                yield worker.current.value, f"the process ended with {code}"
            if late or code is not None:
                worker.start(worker.current.value + n_worker)
        while not faults.empty():
            yield faults.get()
        if time.monotonic() - shown > 10.0:
            shown = time.monotonic()
            print(f"{max(worker.current.value for worker in workers) - first} inputs, {(end - shown) / 60:.1f} min left", flush=True)
    for worker in workers:
        worker.process.kill()
    print(f"{max(worker.current.value for worker in workers) - first} inputs tried, seed {seed}, from number {first}")


def main() -> int:
    """Fuzz; return 1 if there was a fault."""
    options = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    options.add_argument("--minutes", type=float, default=10.0)
    options.add_argument("--seed", type=int, default=0)
    options.add_argument("--first", type=int, default=0, help="number of the first input")
    options.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    given = options.parse_args()
    known, count = kinds(), 0
    for number, fault in fuzz(known, given.minutes, given.seed, given.first, given.workers):
        kind, text = made(number, given.seed, known)
        kept = KEPT / f"{number}-{kind.file}"
        KEPT.mkdir(parents=True, exist_ok=True)
        kept.write_bytes(text)
        words = " ".join(str(kept) if word == "FILE" else word for word in kind.words)
        print(f"input {number}: {fault}\n  contourlab {words}", flush=True)
        count += 1
    print(f"{count} faults")
    return int(count > 0)


if __name__ == "__main__":
    sys.exit(main())
