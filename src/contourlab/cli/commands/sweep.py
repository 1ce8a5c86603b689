"""``contourlab sweep``: studies of thousands to millions of variants, and questions to their stores."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperGroup

from contourlab.cli import options as shared
from contourlab.cli.output import conclude, emit_json, say, show_result, suggest, wants_progress

if TYPE_CHECKING:
    from contourlab.features.sweep.store import Store


class StudyFirst(TyperGroup):
    """A group whose command ``run`` may be left out: ``sweep study.toml`` runs a study."""

    default = "run"

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Put the default command in front of anything that is neither a command nor help."""
        if args and args[0] not in self.commands and args[0] not in ("--help", "-h"):
            args = [self.default, *args]
        return super().parse_args(ctx, args)


sweep = typer.Typer(
    cls=StudyFirst, help="Run studies of thousands to millions of variants; ask their stores. `run` may be left out.", no_args_is_help=True
)
Yes = Annotated[bool, typer.Option("--yes", help="Begin without a question, also beyond an hour or 10 GB.")]
Resume = Annotated[bool, typer.Option("--resume", help="Continue a store; starts an empty one.")]
StoreFolder = Annotated[Path, typer.Argument(metavar="STORE", help="Folder of a store.", show_default=False)]


@sweep.callback()
def _sweep() -> None:
    """Run studies of thousands to millions of variants; ask their stores. `run` may be left out."""


@sweep.command("run")
def run(
    study: Annotated[Path, typer.Argument(metavar="STUDY", help="A study (.toml).", show_default=False)],
    out: shared.Out = Path("store"),
    resume: Resume = False,
    executor: shared.ExecutorKind = "threads",
    workers: shared.Workers = None,
    chunks: Annotated[
        str,
        typer.Option(metavar="FIRST:END", help="Run only these chunks, to share a study between machines; then merge.", show_default=False),
    ] = "",
    yes: Yes = False,
    as_json: shared.Json = False,
    plugin: shared.Plugins = None,
) -> int:
    """Run a study into a store. Finished chunks stay, whatever happens."""
    from contourlab.features.sweep.command import SweepOptions, sweep_study
    from contourlab.study.executors import Executor

    options = SweepOptions(Executor(executor, workers), resume, chunks, yes)
    result = sweep_study(study, out, options, plugins=tuple(plugin or ()), progress=wants_progress(as_json))
    show_result(result, as_json)
    suggest(as_json, "sweep", "report", out)
    return 0


@sweep.command("optimise")
def optimise(
    study: Annotated[Path, typer.Argument(metavar="STUDY", help="A study (.toml).", show_default=False)],
    out: shared.Out = Path("store"),
    minimise: Annotated[
        list[str] | None,
        typer.Option(metavar="FIGURE", help="Figure; part_error_max by default. Several: their Pareto front.", show_default=False),
    ] = None,
    sampler: Annotated[str, typer.Option(help="tpe, nsga2 or cma-es; by default tpe, or nsga2 for several.", show_default=False)] = "",
    trials: Annotated[int, typer.Option(min=1, max=1_000_000, help="Variants in all.")] = 1024,
    batch: Annotated[int, typer.Option(min=8, max=4096, help="Variants that are simulated together.")] = 64,
    resume: Resume = False,
    executor: shared.ExecutorKind = "threads",
    workers: shared.Workers = None,
    as_json: shared.Json = False,
    plugin: shared.Plugins = None,
) -> int:
    """Search the space of a study for the smallest figures. Finished batches stay, whatever happens."""
    from contourlab.features.sweep.optimise import SearchOptions
    from contourlab.features.sweep.optimise import optimise as optimised
    from contourlab.study.executors import Executor

    options = SearchOptions(tuple(minimise or ("part_error_max",)), sampler, trials, batch, resume, Executor(executor, workers))
    found = optimised(study, out, options, plugins=tuple(plugin or ()), progress=wants_progress(as_json))
    show_result(found, as_json)
    if found.best:
        number = found.best[0]["variant"]
        suggest(as_json, "sweep", "worst", out, "--rerun", number, "--out", f"variant-{number}")
    return 0


@sweep.command("show")
def show(store: StoreFolder, as_json: shared.Json = False) -> int:
    """Show what a store holds: yield, distribution of each figure, time."""
    from contourlab.features.sweep.store import read_store
    from contourlab.features.sweep.summary import summary

    show_result(summary(read_store(store)), as_json)
    return 0


@sweep.command("query")
def query(
    store: StoreFolder,
    sql: Annotated[str, typer.Argument(metavar="SQL", help="DuckDB SQL over the view results, in SI.", show_default=False)],
    memory: Annotated[str, typer.Option(help="Most memory of the query.")] = "2 GB",
    time: Annotated[str, typer.Option(help="Longest time of the query.")] = "60 s",
    as_json: shared.Json = False,
) -> int:
    """Ask a store in SQL, such as "SELECT scheme, avg(part_error_max) FROM results GROUP BY scheme"."""
    from contourlab.features.sweep.query import rows
    from contourlab.features.sweep.store import read_store
    from contourlab.features.sweep.summary import rows_text

    opened = read_store(store)
    names, found = rows(opened, sql, memory, time)
    if as_json:
        emit_json([dict(zip(names, row, strict=True)) for row in found])
    else:
        say(rows_text(names, found))
    _tell_missing(opened)
    return 0


def _tell_missing(store: Store) -> None:
    """Say on standard error, apart from the rows, if a store is incomplete."""
    from contourlab.features.sweep.summary import remarks

    for found in remarks(store, {}):
        print(found, file=sys.stderr)


@sweep.command("worst")
def worst(
    store: StoreFolder,
    count: Annotated[int, typer.Argument(metavar="[COUNT]", min=1, help="Number of variants.")] = 10,
    figure: Annotated[str, typer.Option(help="Figure that decides.")] = "part_error_max",
    number: Annotated[
        int | None, typer.Option("--rerun", metavar="VARIANT", help="Run this variant into a full report.", show_default=False)
    ] = None,
    out: shared.Out = Path("results"),
    as_json: shared.Json = False,
    plugin: shared.Plugins = None,
) -> int:
    """List the worst variants with their parameters; with --rerun, write the report of one."""
    from contourlab.features.sweep.query import worst as worst_of
    from contourlab.features.sweep.store import read_store
    from contourlab.features.sweep.summary import rows_text

    if number is not None:
        from contourlab.features.run.command import RunOptions
        from contourlab.features.sweep.command import rerun

        return conclude(rerun(store, number, RunOptions(out, tuple(plugin or ()), progress=wants_progress(as_json))), as_json)
    opened = read_store(store)
    found = worst_of(opened, count, figure)
    if as_json:
        emit_json(found)
    else:
        names = ["variant", *opened.modules, figure, *opened.columns, "status"]
        units = {**opened.columns, **opened.figures}
        say(rows_text(names, [[row[name] for name in names] for row in found], units))
    _tell_missing(opened)
    if found:
        number = found[0]["variant"]
        suggest(as_json, "sweep", "worst", store, "--rerun", number, "--out", f"variant-{number}")
    return 0


@sweep.command("report")
def report(
    store: StoreFolder,
    out: Annotated[Path | None, typer.Option(metavar="FILE", help="Page; by default report.html in the store.", show_default=False)] = None,
    figure: Annotated[str | None, typer.Option(help="Figure to explain; by default part_error_max.", show_default=False)] = None,
    as_json: shared.Json = False,
) -> int:
    """Answer in one page: yield, distribution, what decides it, best compromises, when to stop."""
    from contourlab.features.sweep.report import report as reported

    show_result(reported(store, out, figure), as_json)
    suggest(as_json, "sweep", "worst", store)
    return 0


@sweep.command("merge")
def merge(
    stores: Annotated[list[Path], typer.Argument(metavar="STORE...", help="Stores of one study.", show_default=False)],
    out: Annotated[Path, typer.Option(help="New folder for the store.", show_default=False)],
    as_json: shared.Json = False,
) -> int:
    """Join the stores of one study that several machines have filled."""
    from contourlab.features.sweep.store import merge as merged
    from contourlab.features.sweep.summary import summary

    show_result(summary(merged(stores, out)), as_json)
    return 0


@sweep.command("export")
def export(
    store: StoreFolder,
    to: Annotated[Path, typer.Option("--to", metavar="FILE", help="File that ends in .csv or .parquet.", show_default=False)],
    as_json: shared.Json = False,
) -> int:
    """Write one row per variant, in their order, in SI."""
    from contourlab.features.sweep.query import export as exported
    from contourlab.features.sweep.store import read_store

    show_result(exported(read_store(store), to), as_json)
    return 0
