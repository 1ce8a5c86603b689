"""Cost of the studies that people wait for: wall time and processor time, children included, of commands as typed.

    python benchmarks/studies.py [--repeat N] [--only WORD]

Each command runs in a process and a folder of its own. The best of the repetitions counts: the first also compiles what is not yet in the
cache. The log of `commission` is simulated: a minute of two axes with friction, play and noise (`tests/helpers/made_commission.py`). The
figures go to benchmarks/out/studies.json too.
"""

from __future__ import annotations

import argparse
import json
import platform
import shlex
import sys
import tempfile
from pathlib import Path

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


def measure(command: str, files: Path, repeat: int) -> tuple[float, float]:
    """Return the shortest wall time and the least processor time [s] of a command in copies of a folder."""
    words = [sys.executable, "-m", *shlex.split(command)]
    found = []
    for _ in range(repeat):
        with tempfile.TemporaryDirectory() as name:
            for file in files.iterdir():
                (Path(name) / file.name).write_bytes(file.read_bytes())
            found.append(cost(words, name, (0, 1)))
    wall, processor, _ = zip(*found, strict=True)
    return min(wall), min(processor)


def main() -> int:
    """Print one row for each study, and write them to benchmarks/out/studies.json."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeat", type=int, default=3, help="runs of each; the best counts")
    parser.add_argument("--only", default="", metavar="WORD", help="the studies whose name contains a word")
    options = parser.parse_args()
    chosen = {name: command for name, command in STUDIES.items() if options.only in name}
    if not chosen:
        parser.error(f"--only: none of {', '.join(STUDIES)} contains {options.only!r}")
    rows = []
    print(f"{platform.platform()}, Python {platform.python_version()}; best of {options.repeat}")
    print(f"{'':12}{'wall s':>8}{'cpu s':>8}  command")
    with tempfile.TemporaryDirectory() as name:
        write_machine(Path(name))
        for study, command in chosen.items():
            wall, processor = measure(command, Path(name), options.repeat)
            print(f"{study:12}{wall:8.1f}{processor:8.1f}  {command}", flush=True)
            rows.append({"name": study, "command": command, "wall_s": wall, "processor_s": processor})
    out = HERE / "out"
    out.mkdir(exist_ok=True)
    (out / "studies.json").write_text(json.dumps({"platform": platform.platform(), "rows": rows}, indent=2), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
