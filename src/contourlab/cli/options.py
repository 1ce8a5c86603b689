"""Options shared by several commands."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

import typer

from contourlab.errors import ParameterError

if TYPE_CHECKING:
    pass

ScenarioFile: TypeAlias = Annotated[
    str, typer.Argument(metavar="SCENARIO", help="A scenario (.toml), or the name of a shipped one.", show_default=False)
]
Schemes: TypeAlias = Annotated[
    str | None,
    typer.Option(
        help="Schemes of the scenario, separated by commas; or fb, ccc, mr, me, ilc, joined by +, as in fb,ccc,ilc,ccc+ilc.",
        show_default=False,
    ),
]
Trials: TypeAlias = Annotated[int | None, typer.Option(help="Largest number of trials after the first; by default as in the scenario.")]


def _folder(out: Path) -> Path:
    """Refuse a file where a folder is meant."""
    if out.suffix.lower() == ".toml":
        raise ParameterError("--out", repr(str(out)), "a folder for results; --write names a file, where a command writes one")
    return out


Out: TypeAlias = Annotated[Path, typer.Option(help="Folder for the results; created if missing.", callback=_folder)]
Write: TypeAlias = Annotated[Path | None, typer.Option(help="TOML file to write; creates missing folders.", show_default=False)]
Json: TypeAlias = Annotated[bool, typer.Option("--json", help="Print only JSON on standard output.")]
Judge: TypeAlias = Annotated[
    str | None,
    typer.Option(help='Moves to judge: cutting (the default), all, or "lines 10-40": cutting moves of these lines.', show_default=False),
]
Plots: TypeAlias = Annotated[list[str] | None, typer.Option(help="Also write plots as png, svg or pdf; repeatable.")]
Pdf: TypeAlias = Annotated[bool, typer.Option("--pdf", help="Also write report.pdf, one page to print.")]
Signals: TypeAlias = Annotated[list[str] | None, typer.Option(help="Write only this signal; repeatable; by default all.")]
Plugins: TypeAlias = Annotated[list[Path] | None, typer.Option("--plugin", help="Load components from a Python file; repeatable.")]


def listed(schemes: str | None) -> tuple[str, ...]:
    """Return the names in a comma-separated list."""
    return tuple(name.strip() for name in schemes.split(",")) if schemes else ()


Parameters: TypeAlias = Annotated[
    list[str] | None,
    typer.Option(
        "--parameter",
        metavar="NAME[=LOW..HIGH]",
        help='Parameter to vary, e.g. "3.position_gain=2 full_scale/mm..8 full_scale/mm"; repeatable; by default all calibrated.',
        show_default=False,
    ),
]
Width: TypeAlias = Annotated[float, typer.Option(help="Range of a parameter without bounds: from value / WIDTH to value * WIDTH.")]
GainMargin: TypeAlias = Annotated[float, typer.Option(help="Smallest allowed gain margin of an axis, in dB.")]
PhaseMargin: TypeAlias = Annotated[float, typer.Option(help="Smallest allowed phase margin of an axis, in degrees.")]
Seed: TypeAlias = Annotated[int, typer.Option(help="Seed of sampling and search; the same seed gives the same result.")]
ExecutorKind: TypeAlias = Annotated[
    str, typer.Option(help="threads, gpu, processes, dask-local, dask://HOST:PORT or slurm; the results are the same.")
]
Workers: TypeAlias = Annotated[
    int | None, typer.Option(help="Threads, processes or jobs; by default one per processor.", show_default=False)
]

ColumnTexts: TypeAlias = Annotated[
    list[str] | None,
    typer.Option("--column", help="Signal of a column, e.g. position.x='NAME \\[mm]'; repeatable.", show_default=False),
]
ColumnFile: TypeAlias = Annotated[
    Path | None, typer.Option("--columns", help="A TOML file with the signals of the columns.", show_default=False)
]
LogFormat: TypeAlias = Annotated[
    str | None, typer.Option("--format", help="Format of the file, if it is not recognised.", show_default=False)
]
SamplePeriod: TypeAlias = Annotated[
    str | None, typer.Option("--period", help='Time between samples, e.g. "1 ms", if the log has no times.', show_default=False)
]

Part: TypeAlias = Annotated[Path, typer.Argument(metavar="PART", help="A part program in G-code.", show_default=False)]
Dialect: TypeAlias = Annotated[str, typer.Option(help="linuxcnc, or grbl, which is more lenient and reports each deviation.")]
BlockDelete: TypeAlias = Annotated[bool, typer.Option("--block-delete", help="Skip lines that begin with /.")]
ToolTable: TypeAlias = Annotated[Path | None, typer.Option(help="LinuxCNC tool table, for G43; without it, tools have length 0.")]

MostMoves: TypeAlias = Annotated[
    int | None, typer.Option(min=1, help="Most lines and moves of loops, subprograms and cycles.", show_default=False)
]


Fit: TypeAlias = Annotated[bool, typer.Option("--fit", help="Scale and move a part program into the machine's travel.")]
NoRequireEnd: TypeAlias = Annotated[
    bool, typer.Option("--no-require-end", help="Accept a part program without M2, M30 or %: its last line ends it.")
]
AnyDialect: TypeAlias = Annotated[
    str | None, typer.Option("--dialect", help="Dialect of a part program: linuxcnc (the default), or grbl.", show_default=False)
]


def program_keys(
    fit: bool, block_delete: bool, tools: Path | None, no_require_end: bool, most_moves: int | None, dialect: str | None
) -> dict[str, Any]:
    """Return the keys of the table ``program`` that options set."""
    keys = {
        "fit": fit or None,
        "block_delete": block_delete or None,
        "tools": None if tools is None else str(tools),
        "require_end": False if no_require_end else None,
        "dialect": dialect,
        "most_moves": most_moves,
    }
    return {name: value for name, value in keys.items() if value is not None}
