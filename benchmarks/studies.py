"""Cost of the studies that people wait for: wall time and processor time, children included, of commands as typed.

    python benchmarks/studies.py [--repeat N] [--only WORD]

Each command runs in a process and a folder of its own: first with a cache that has only what `make install` compiles, then N times with
the machine code of the first run, of which the best counts. The log of `commission` is simulated: a minute of two axes with friction, play
and noise (`tests/helpers/made_commission.py`). The figures go to benchmarks/out/studies.json too.
"""

from __future__ import annotations

import argparse
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import figures_file
from sweep import cost

HERE = Path(__file__).resolve().parent
STUDIES = {
    "tune": 'contourlab tune builtin:ghaffari/demo-stage --scheme "with modified reference, initial gains"',
    "swap": "contourlab swap builtin:ghaffari/demo-stage --axis 1 --with builtin:ghaffari/axis2 --quick",
    "link": "contourlab link builtin:ghaffari/demo-stage --quick",
    "commission": "contourlab commission linuxcnc rig.ini rig.hal --log log.csv",
}


def write_machine(folder: Path) -> None:
    """Write the files of a machine under LinuxCNC, and the log of its excitation."""
    sys.path.insert(0, str(HERE.parent / "tests" / "helpers"))
    from made_commission import made

    made(folder).log(folder / "log.csv")


def measure(command: str, files: Path, cache: Path, repeat: int) -> dict[str, float]:
    """Return wall and processor time [s] of the first run of a command in copies of two folders, and the best of further ones."""
    words = [sys.executable, "-m", *shlex.split(command)]
    found = []
    with tempfile.TemporaryDirectory() as name:
        os.environ["CONTOURLAB_CACHE"] = str(shutil.copytree(cache, Path(name) / "cache"))
        for number in range(repeat + 1):
            folder = shutil.copytree(files, Path(name) / str(number))
            found.append(cost(words, str(folder), (0, 1))[:2])
    wall, processor = zip(*found, strict=True)
    first = {"first_wall_s": wall[0], "first_processor_s": processor[0]}
    return {**first, "wall_s": min(wall[1:]), "processor_s": min(processor[1:])}


def main() -> int:
    """Print one row for each study, and write them to benchmarks/out/studies.json."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeat", type=int, default=3, help="further runs of each; the best counts")
    parser.add_argument("--only", default="", metavar="WORD", help="the studies whose name contains a word")
    options = parser.parse_args()
    chosen = {name: command for name, command in STUDIES.items() if options.only in name}
    if not chosen:
        parser.error(f"--only: none of {', '.join(STUDIES)} contains {options.only!r}")
    if options.repeat < 1:
        parser.error("--repeat: 1 or more")
    rows = []
    print(f"{platform.platform()}, Python {platform.python_version()}; wall and processor time [s]")
    print(f"{'':12}{'first':>8}{'cpu':>8}{'again':>8}{'cpu':>8}  command")
    with tempfile.TemporaryDirectory() as name:
        files, cache = Path(name) / "files", Path(name) / "cache"
        write_machine(files)
        installed = {**os.environ, "CONTOURLAB_CACHE": str(cache)}
        subprocess.run([sys.executable, "-m", "contourlab.app.precompile"], env=installed, check=True)
        for study, command in chosen.items():
            times = measure(command, files, cache, options.repeat)
            print(f"{study:12}{''.join(f'{seconds:8.1f}' for seconds in times.values())}  {command}", flush=True)
            rows.append({"name": study, "command": command, **times})
    figures_file.write("studies.json", rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
