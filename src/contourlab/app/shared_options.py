"""Options that several questions share."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from contourlab.app.options import Options, argument, option, options
from contourlab.errors import ParameterError

if TYPE_CHECKING:
    from contourlab.study.executors import Executor
    from contourlab.study.guards import Bounds

PICTURES = ("png", "svg", "pdf")


# --- where and how an answer is saved; the command line alone has these ---


@options
class Shown(Options):
    """An answer that is printed."""

    as_json: bool = option(False, "Print only JSON on standard output.", name="--json")


@options
class Saved(Shown):
    """An answer with a folder of files."""

    out: Path = option(Path("results"), "Folder for the results; created if missing.")

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.out.suffix.lower() == ".toml":
            wanted = "a folder for results; --write names a file, where a command writes one"
            raise ParameterError("out", repr(str(self.out)), wanted)


@options
class Drawn(Saved):
    """An answer with pictures."""

    plots: tuple[str, ...] = option((), "Also write plots as png, svg or pdf; repeatable.", choices=PICTURES)


@options
class Written(Options):
    """An answer with a TOML file."""

    write: Path | None = option(None, "TOML file to write; creates missing folders.")


@options
class WrittenController(Written):
    """An answer with a controller file."""

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.write is not None and self.write.suffix.lower() != ".toml":
            raise ParameterError("write", repr(str(self.write)), "a controller file, which ends in .toml")


@options
class OfScenario(Options):
    """An argument: a scenario."""

    file: str = argument("SCENARIO", "A scenario (.toml), or the name of a shipped one.")


@options
class OfPart(Options):
    """An argument: a part program."""

    file: Path = argument("PART", "A part program in G-code.")


# --- options of questions ---


@options
class Plugins(Options):
    """Components of other files."""

    plugin: tuple[Path, ...] = option((), "Load components from a Python file; repeatable.")


@options
class Changed(Plugins):
    """Changes to a scenario."""

    set: tuple[str, ...] = option(
        (),
        'Value in place of the scenario\'s, in all schemes that have it, e.g. "axes.*.plant.mass=90 kg"; repeatable.',
        metavar="NAME=VALUE",
    )


@options
class Schemes(Changed):
    """Schemes of a scenario."""

    schemes: tuple[str, ...] = option(
        (), "Schemes of the scenario, separated by commas; or fb, ccc, mr, me, ilc, joined by +, as in fb,ccc,ilc,ccc+ilc.", listed=True
    )


@options
class Judged(Changed):
    """Moves to judge, and the machine."""

    machine: str | None = option(None, "Machine of a part program, or in place of the scenario's: a file, or a shipped name.")
    judge: str | None = option(None, 'Moves to judge: cutting (the default), all, or "lines 10-40": cutting moves of these lines.')


@options
class ProgramReading(Options):
    """How to read a part program."""

    block_delete: bool = option(False, "Skip lines that begin with /.")
    tools: Path | None = option(None, "LinuxCNC tool table, for G43; without it, tools have length 0.")
    zero: str | None = option(None, 'Zero of the program in machine coordinates, e.g. "100,100,-20", in the unit of the machine.')
    most_moves: int | None = option(None, "Most lines and moves of loops, subprograms and cycles.", least=1, advanced=True)


@options
class Dialect(ProgramReading):
    """How to read a part program of a dialect."""

    dialect: str | None = option(None, "Control of the program: linuxcnc (the default, or the machine's), grbl, grblhal, fanuc or mach3.")


@options
class Planned(Options):
    """How a motion is planned."""

    planner: str | None = option(
        None, "How the control plans: jerk, grbl or linuxcnc; by default as its file says.", choices=("jerk", "grbl", "linuxcnc")
    )


@options
class Motion(Planned, Judged, ProgramReading):
    """A scenario, or a part program with a machine and a controller."""

    controller: str | None = option(None, "Controller: a file, or a shipped name; a scenario has its own.")
    tolerance: str | None = option(None, 'Largest part error of a program that passes, e.g. "25 um"; a scenario has its own.', unit="m")
    fit: bool = option(False, "Scale and move a part program into the machine's travel.")
    no_require_end: bool = option(False, "Accept a part program without M2, M30 or %: its last line ends it.")
    dialect: str | None = option(None, "Dialect of a part program: linuxcnc (the default), grbl, grblhal, fanuc or mach3.")

    @property
    def program(self) -> dict[str, Any]:
        """Keys of the table ``program`` that the options set."""
        keys = {
            "fit": self.fit or None,
            "block_delete": self.block_delete or None,
            "tools": None if self.tools is None else str(self.tools),
            "zero": self.zero,
            "require_end": False if self.no_require_end else None,
            "dialect": self.dialect,
            "most_moves": self.most_moves,
        }
        return {name: value for name, value in keys.items() if value is not None}


@options
class LogWindow(Options):
    """What to read of a log."""

    window: tuple[str, ...] = option((), 'Part to read: "2 s..3.5 s", "0..1493" (samples) or "line 20..line 40"; one, or one a log.')

    def of_log(self, number: int, count: int) -> Self:
        """Return the options for one of several logs: with its window."""
        if len(self.window) not in (0, 1, count):
            raise ParameterError("--window", f"{len(self.window)} windows", f"one for all logs, or one for each of the {count}")
        return self if len(self.window) < 2 else replace(self, window=self.window[number : number + 1])


@options
class LogColumns(LogWindow):
    """How to read a log."""

    column: tuple[str, ...] = option((), "Signal of a column, e.g. position.x='NAME [mm]'; repeatable.")
    columns: Path | None = option(None, "A TOML file with the signals of the columns.")
    format: str | None = option(None, "Format of the file, if it is not recognised.")
    period: str | None = option(None, 'Time between samples, e.g. "1 ms", if the log has no times.', unit="s")
    unit: str | None = option(None, "Unit of lengths in columns that have none, e.g. mm; speeds have it per second.")

    def files(self, *logs: Any) -> tuple[Any, ...]:
        """Return logs and the file of columns: what is read."""
        return logs if self.columns is None else (*logs, self.columns)


READING = tuple(part.typed for part in LogColumns.PARTS.values())
"""Options that say how a log is read: a next step on the same log takes them over."""


@options
class OnMachine(LogColumns):
    """A log of a machine."""

    machine: str | None = option(
        None, "Machine of the log; the file of its control has the unit of lengths, and says how it reads a program.", objects="Machine"
    )


@options
class LogAxes(LogColumns):
    """How to read a log, and which of its axes."""

    axes: tuple[str, ...] = option((), "Axes of the log, e.g. x,y; by default all.", listed=True)


@options
class Margins(Options):
    """Margins to keep."""

    gain_margin: float = option(6.0, "Smallest allowed gain margin of an axis, in dB.", unit="dB")
    phase_margin: float = option(30.0, "Smallest allowed phase margin of an axis, in degrees.", unit="deg")

    @property
    def margins(self) -> Bounds:
        """The margins."""
        from contourlab.study.guards import Bounds

        return Bounds(self.gain_margin, self.phase_margin)


@options
class Varied(Options):
    """Parameters to vary."""

    parameter: tuple[str, ...] = option(
        (),
        'Parameter to vary, e.g. "3.position_gain=2 full_scale/mm..8 full_scale/mm"; repeatable; by default all calibrated.',
        metavar="NAME[=LOW..HIGH]",
    )
    width: float = option(4.0, "Range of a parameter without bounds: from value / WIDTH to value * WIDTH.", advanced=True)


@options
class Seeded(Options):
    """A seed."""

    seed: int = option(0, "Seed of sampling and search; the same seed gives the same result.", advanced=True)


@options
class Workers(Options):
    """Where the work is done."""

    executor: str = option(
        "threads", "threads, gpu, processes, dask-local, dask://HOST:PORT or slurm; the results are the same.", advanced=True
    )
    workers: int | None = option(None, "Threads, processes or jobs; by default one per processor.", least=1, advanced=True)

    @property
    def pool(self) -> Executor:
        """Where the work is done."""
        from contourlab.study.executors import Executor

        return Executor(self.executor, self.workers)
