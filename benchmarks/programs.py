"""Run every part program of a folder on the three-axis machine and list the errors of the tool.

    python benchmarks/programs.py [FOLDER ...] [--out results/programs] [--only WORD]

Each program is read (without an end, it ends with its last line), scaled into the travel of the machine if it is too large, planned,
simulated and judged. Its report goes to its own folder. A table follows at the end; programs that cannot run are listed with their error.
"""

from __future__ import annotations

import argparse
import json
import shlex
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table
from rich.text import Text

from contourlab.app.session import Session
from contourlab.errors import ContourlabError
from contourlab.features.run.command import run_schemes
from contourlab.scenario import Scenario, scenario_from_parts

DEFAULT = Path(__file__).resolve().parents[2] / "shared" / "gcode"
SUFFIXES = {".ngc", ".nc", ".gcode", ".tap", ".cnc"}
MACHINE, CONTROLLER = "xyz", "xyz-controller"
INTERRUPTED = 130
SIGNALS = ("reference", "position", "contour_error", "part_error")


def programs(folders: Sequence[Path], only: str) -> list[Path]:
    """Return the part programs of folders or files, sorted by name within each folder."""
    found = [file for folder in folders for file in (sorted(folder.rglob("*")) if folder.is_dir() else [folder])]
    return [file for file in found if file.suffix.lower() in SUFFIXES and only.lower() in file.name.lower()]


def scenario_of(file: Path) -> Scenario:
    """Return the scenario of a program on the machine."""
    return scenario_from_parts(file, MACHINE, CONTROLLER, options={"fit": True, "require_end": False}, name=file.stem)


def command_of(file: Path) -> str:
    """Return the command that repeats the run of a program."""
    words = ["contourlab", "run", str(file), "--machine", MACHINE, "--controller", CONTROLLER, "--fit", "--no-require-end"]
    return shlex.join(words + [word for signal in SIGNALS for word in ("--signals", signal)])


def run(file: Path, out: Path) -> dict[str, Any]:
    """Run one program; return its row."""
    begin = time.perf_counter()
    row: dict[str, Any] = {"program": file.name}
    try:
        scenario = scenario_of(file)
        done = run_schemes(scenario, Session(command=command_of(file))).save(out / file.stem, signals=SIGNALS)
    except ContourlabError as error:
        return row | {"error": str(error).removeprefix(f"{file}:"), "seconds": time.perf_counter() - begin}
    found = done.summary["schemes"]["base"]
    metrics = found["metrics"]
    return row | {
        "lines": len(scenario.base.lines),
        "moves": len(scenario.motion.program.moves),  # type: ignore[union-attr]
        "notes": done.summary["notes"],
        "cycle_time": metrics["cycle_time"],
        "part_error_max": metrics["part_error"]["max"],
        "part_error_rms": metrics["part_error"]["rms"],
        "contour_error_max": metrics["contour_error"]["max"],
        "planning_deviation_max": metrics["planning_deviation"]["max"],
        "line": metrics["part_error"]["worst"]["line"],
        "seconds": time.perf_counter() - begin,
    }


def rows(files: Sequence[Path], out: Path) -> Iterator[dict[str, Any]]:
    """Run the programs one after another, with a bar on a terminal."""
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), disable=not sys.stderr.isatty(), transient=True) as bar:
        task = bar.add_task("", total=len(files))
        for file in files:
            bar.update(task, description=file.name)
            yield run(file, out)
            bar.advance(task)


def table(found: Sequence[dict[str, Any]]) -> Table:
    """Return the rows as one table."""
    shown = Table(title=f"Part programs on the machine {MACHINE} under {CONTROLLER}; errors in um")
    heads = ("program", "lines", "moves", "cycle s", "part max", "at line", "part rms", "contour max", "planning max", "scaled", "took s")
    for head in heads:
        shown.add_column(head, justify="left" if head == "program" else "right", overflow="fold")
    for row in found:
        if "error" in row:
            shown.add_row(row["program"], *["-"] * (len(heads) - 2), f"{row['seconds']:.1f}")
            continue
        errors = (row["part_error_max"], row["line"], row["part_error_rms"], row["contour_error_max"], row["planning_deviation_max"])
        cells = [str(value) if isinstance(value, int) else f"{value * 1e6:.3g}" for value in errors]
        scaled = next((note.split("scaled by ")[1].split(",")[0] for note in row["notes"] if "scaled by" in note), "")
        shown.add_row(
            row["program"], str(row["lines"]), str(row["moves"]), f"{row['cycle_time']:.1f}", *cells, scaled, f"{row['seconds']:.1f}"
        )
    wrong = [f"{row['program']}: {row['error']}" for row in found if "error" in row]
    shown.caption = Text("\n".join(["not run:", *wrong]) if wrong else "", justify="left")
    shown.caption_justify = "left"
    return shown


def main() -> int:
    """Run the programs, print the table, write the JSON."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("folders", nargs="*", type=Path, default=[DEFAULT], help="folders of part programs, or programs")
    parser.add_argument("--out", type=Path, default=Path("results/programs"))
    parser.add_argument("--only", default="", help="only programs with this in their name")
    chosen = parser.parse_args()
    files = programs(chosen.folders, chosen.only)
    if not files:
        print(f"no part programs in {', '.join(map(str, chosen.folders))}: name a folder, make programs PROGRAMS=<folder>", file=sys.stderr)
        return 2
    found: list[dict[str, Any]] = []
    stopped = False
    try:
        for row in rows(files, chosen.out):
            found.append(row)  # an interruption keeps the rows before it
    except KeyboardInterrupt:
        stopped = True
    chosen.out.mkdir(parents=True, exist_ok=True)
    (chosen.out / "programs.json").write_text(json.dumps(found, indent=2) + "\n", encoding="utf-8")
    Console(width=None if sys.stdout.isatty() else 200).print(table(found))
    if stopped:
        print(f"interrupted: {len(found)} of {len(files)} programs were run", file=sys.stderr)
    return INTERRUPTED if stopped else 0


if __name__ == "__main__":
    sys.exit(main())
