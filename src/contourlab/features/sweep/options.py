"""Options of ``contourlab sweep``."""

from __future__ import annotations

import re
from pathlib import Path

from contourlab.app.options import REQUIRED, Options, argument, option, options
from contourlab.app.session import Command, Commands
from contourlab.app.shared_options import Plugins, Saved, Shown, Workers
from contourlab.errors import ParameterError


@options
class Stored(Workers, Plugins):
    """A store to write."""

    out: Path = option(Path("store"), "Folder for the results; created if missing.")
    machine: str | None = option(None, "In place of the scenario's machine: a file, or a shipped name.")
    resume: bool = option(False, "Continue a store; starts an empty one.")

    def __post_init__(self) -> None:
        super().__post_init__()
        Saved(out=self.out)


@options
class Sweep(Stored):
    """Run a study into a store. Finished chunks stay, whatever happens."""

    chunks: str = option("", "Run only these chunks, to share a study between machines; then merge.", metavar="FIRST:END", advanced=True)
    yes: bool = option(False, "Begin without a question, also beyond an hour or 10 GB.")

    def chosen(self, count: int) -> range:
        """Return the chunks to run, of `count`.

        Raises
        ------
        ParameterError
            If they are not a range of the study.
        """
        if not self.chunks:
            return range(count)
        match = re.fullmatch(r"(\d{0,12}):(\d{0,12})", self.chunks)
        first, last = (int(match[1] or 0), int(match[2] or count)) if match else (0, 0)
        if not first < last or first >= count:
            raise ParameterError("chunks", repr(self.chunks), f"FIRST:END, from 0:{count} for all; the end is not included")
        return range(first, min(last, count))


@options
class Optimise(Stored):
    """Search the space of a study for the smallest figures. Finished batches stay, whatever happens."""

    minimise: tuple[str, ...] = option(
        ("part_error_max",), "Figure; part_error_max by default. Several: their Pareto front.", metavar="FIGURE"
    )
    sampler: str = option("", "tpe, nsga2 or cma-es; by default tpe, or nsga2 for several.", choices=("", "tpe", "nsga2", "cma-es"))
    trials: int = option(1024, "Variants in all.", least=1, most=1_000_000)
    batch: int = option(64, "Variants that are simulated together.", least=8, most=4096, advanced=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        if not 1 <= len(self.minimise) <= 3 or len(set(self.minimise)) < len(self.minimise):
            raise ParameterError("minimise", ", ".join(self.minimise), "one to three figures, each once")
        if self.sampler == "cma-es" and len(self.minimise) > 1:
            raise ParameterError("sampler", "'cma-es'", "tpe or nsga2 for several figures")

    @property
    def chosen(self) -> str:
        """The sampler."""
        return self.sampler or ("tpe" if len(self.minimise) == 1 else "nsga2")


@options
class Show(Options):
    """Show what a store holds: yield, distribution of each figure, time."""


@options
class Query(Options):
    """Ask a store in SQL, such as "SELECT scheme, avg(part_error_max) FROM results GROUP BY scheme"."""

    memory: str = option("2 GB", "Most memory of the query.")
    time: str = option("60 s", "Longest time of the query.")


@options
class Worst(Plugins):
    """List the worst variants with their parameters; with --rerun, write the report of one."""

    figure: str = option("part_error_max", "Figure that decides.")
    rerun: int | None = option(None, "Run this variant into a full report.", metavar="VARIANT")


@options
class Report(Options):
    """Answer in one page: yield, distribution, what decides it, best compromises, when to stop."""

    figure: str | None = option(None, "Figure to explain; by default part_error_max.")


@options
class Merge(Options):
    """Join the stores of one study that several machines have filled."""

    out: Path = option(REQUIRED, "New folder for the store.")


@options
class Export(Options):
    """Write one row per variant, in their order, in SI."""

    to: Path = option(REQUIRED, "File that ends in .csv or .parquet.", metavar="FILE")


@options
class OfStudy(Shown):
    """An argument: a study."""

    study: Path = argument("STUDY", "A study (.toml).")


@options
class OfStore(Shown):
    """An argument: a store."""

    store: Path = argument("STORE", "Folder of a store.")


@options
class OfReport(OfStore):
    """The argument, and what is saved."""

    out: Path | None = option(None, "Page; by default report.html in the store.", metavar="FILE")


@options
class OfQuery(OfStore):
    """The arguments of a query."""

    sql: str = argument("SQL", "DuckDB SQL over the view results, in SI.")


@options
class OfWorst(OfStore, Saved):
    """The arguments, and what is saved."""

    count: int = argument("[COUNT]", "Number of variants.", 10, least=1)


@options
class OfStores(Shown):
    """An argument: stores."""

    stores: tuple[Path, ...] = argument("STORE...", "Stores of one study.")


HOME = "contourlab.features.sweep.command:"
COMMANDS = {
    "sweep": Commands(
        "Run studies of thousands to millions of variants; ask their stores. `run` may be left out.",
        {
            "run": Command(f"{HOME}sweep", Sweep, OfStudy),
            "optimise": Command(f"{HOME}optimise", Optimise, OfStudy),
            "show": Command(f"{HOME}show", Show, OfStore),
            "query": Command(f"{HOME}query", Query, OfQuery),
            "worst": Command(f"{HOME}worst", Worst, OfWorst),
            "report": Command(f"{HOME}report", Report, OfReport),
            "merge": Command(f"{HOME}merge", Merge, OfStores),
            "export": Command(f"{HOME}export", Export, OfStore),
        },
        default="run",
    )
}
