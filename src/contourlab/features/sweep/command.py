"""``contourlab sweep``: run a study into a store; show, merge and export stores; rerun single variants."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from contourlab.app.command_line import as_typed
from contourlab.app.results import proposed
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.app.shared_options import Plugins
from contourlab.engine.gpu import LANES as GPU_LANES
from contourlab.errors import DivergenceError, ResultError
from contourlab.extras import extra_module
from contourlab.features.run.command import Runs, run_schemes
from contourlab.features.sweep.chunk import Chunk, chunk_elsewhere, run_chunks
from contourlab.features.sweep.cost import agree, cost_of
from contourlab.features.sweep.optimise import AGAIN, Search, kept_note
from contourlab.features.sweep.optimise import optimise as optimised
from contourlab.features.sweep.options import Export, Merge, Optimise, Query, Report, Show, Sweep, Worst
from contourlab.features.sweep.query import Export as ExportedRows
from contourlab.features.sweep.query import export as exported
from contourlab.features.sweep.query import rows, variant
from contourlab.features.sweep.query import worst as worst_of
from contourlab.features.sweep.report import SweepReport
from contourlab.features.sweep.report import report as reported
from contourlab.features.sweep.store import Store, numbers_in, read_store, writing
from contourlab.features.sweep.store import check_folder as check_store
from contourlab.features.sweep.store import merge as merged
from contourlab.features.sweep.study import Structure, Study, load_study
from contourlab.features.sweep.summary import SweepSummary, display, remarks, rows_text, summary
from contourlab.figures import number as number_text
from contourlab.findings import Finding, finding
from contourlab.result import write_text_atomic
from contourlab.scenario import Case, Scenario, dump, parse_scenario
from contourlab.study.design import Design
from contourlab.study.executors import Executor, Workers
from contourlab.study.space import Distribution
from contourlab.study.values import with_values

SAME = 1e-6
"""Largest relative difference between the stored figure of a variant and a new run; on the same processor they are equal."""


@question(Sweep)
def sweep(study: str | Path, *, settings: Sweep, session: Session = QUIET) -> SweepSummary:
    """Run the variants of a study that are not in its store yet.

    Parameters
    ----------
    study : str or Path
        A study.

    Returns
    -------
    SweepSummary

    Raises
    ------
    ContourlabError
        If the study, an option or the folder is invalid, the disk is full, or a cluster is lost. Finished chunks stay.
    """
    for package in ("duckdb", "pyarrow.parquet"):
        extra_module(package)
    check_store(settings.out, resume=settings.resume)
    made, executor = 0, settings.pool
    with ExitStack() as stack:
        stages = session.stages()
        stages.begin("planning the motions")
        planned = load_study(study, settings.plugin, stages.advance)
        wanted = settings.chosen(planned.design.chunks)
        pool = stack.enter_context(executor.started(planned.plugins, AGAIN))
        cost = cost_of(planned, wanted, numbers_in(settings.out), executor, pool)
        session.close()  # a bar would hide the question
        agree(cost, yes=settings.yes or settings.resume)
        stages = session.stages()
        with writing(settings.out, planned, resume=settings.resume) as store, kept_note(store):
            todo = [number for number in wanted if number not in store.parts]
            total = sum(len(planned.design.numbers(number)) for number in todo)
            done, last = 0, perf_counter()
            stages.begin("running variants")
            tell = lambda more: stages.advance(done + more, total)  # noqa: E731
            for chunk in _chunks(planned, todo, pool, executor, tell):
                store.write(chunk)
                now = perf_counter()
                store.log(chunk, now - last)
                last, made, done = now, made + 1, done + len(chunk.columns["status"])
                stages.advance(done, total)
        damaged = (finding("CL930", count=len(store.damaged)),) if store.damaged else ()
        stages.begin("reading the store")
        return replace(summary(store, made, (*planned.findings, *damaged)), fresh=True)


@question(Optimise)
def optimise(study: str | Path, *, settings: Optimise, session: Session = QUIET) -> Search:
    """Search the space of a study; its distributions give the range of each parameter.

    Parameters
    ----------
    study : str or Path
        A study. Its design, number of variants and correlations do not matter.

    Returns
    -------
    Search

    Raises
    ------
    ContourlabError
        If the study, an option or the folder is invalid, or the disk is full. Finished batches stay.
    """
    return optimised(study, settings, session.stages())


@question(Show)
def show(store: str | Path, *, settings: Show, session: Session = QUIET) -> SweepSummary:
    """Return what a store holds."""
    return summary(read_store(store))


@question(Query)
def query(store: str | Path, sql: str, *, settings: Query, session: Session = QUIET) -> Rows:
    """Return the rows of a query in SQL over the view ``results``, in SI."""
    opened = read_store(store)
    names, values = rows(opened, sql, settings.memory, settings.time)
    return Rows(tuple(names), tuple(map(tuple, values)), {}, remarks(opened, {}))


@question(Worst)
def worst(store: str | Path, count: int = 10, *, settings: Worst, session: Session = QUIET) -> Rows | Runs:
    """Return the worst variants with their parameters; with ``rerun``, the runs of one."""
    if settings.rerun is not None:
        return rerun(store, settings.rerun, settings, session)
    opened = read_store(store)
    names = ("variant", *opened.manifest.modules, settings.figure, *opened.manifest.columns, "status")
    found = worst_of(opened, count, settings.figure)
    units = {**opened.manifest.columns, **opened.manifest.figures}
    return Rows(names, tuple(tuple(row[name] for name in names) for row in found), units, remarks(opened, {}), tuple(found), str(store))


@question(Report)
def report(store: str | Path, *, settings: Report, session: Session = QUIET) -> SweepReport:
    """Answer in one page: yield, distribution, what decides it, best compromises, when to stop."""
    return reported(store, settings.out, settings.figure)


@question(Merge)
def merge(*stores: str | Path, settings: Merge, session: Session = QUIET) -> SweepSummary:
    """Join the stores of one study that several machines have filled."""
    return summary(merged(stores, settings.out))


@question(Export)
def export(store: str | Path, *, settings: Export, session: Session = QUIET) -> ExportedRows:
    """Write one row per variant, in their order, in SI."""
    return exported(read_store(store), settings.to)


for _member in (optimise, show, query, worst, report, merge, export):
    setattr(sweep, _member.__name__, _member)


@dataclass(frozen=True, eq=False)
class Rows(Answer):
    """Rows of a store, in SI.

    Attributes
    ----------
    names : tuple of str
        Of the columns.
    values : tuple of tuple
    units : mapping of str to str
        Units of the text, by column.
    findings : tuple of Finding
        On what the store lacks.
    """

    names: tuple[str, ...]
    values: tuple[tuple[Any, ...], ...]
    units: Mapping[str, str]
    findings: tuple[Finding, ...]
    whole: tuple[dict[str, Any], ...] = ()
    store: str = ""

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The rows, each by column."""
        return list(self.whole) or [dict(zip(self.names, row, strict=True)) for row in self.values]

    @property
    def json(self) -> list[dict[str, Any]]:
        """The rows."""
        return self.rows

    @property
    def text(self) -> str:
        """The rows as a table."""
        return rows_text(list(self.names), [list(row) for row in self.values], self.units)

    @property
    def asides(self) -> tuple[Finding, ...]:
        """What the store lacks."""
        return self.findings

    def save(self, folder: str | Path = "results", **_: Any) -> Rows:
        """Write nothing."""
        return self

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Run the worst variant again."""
        if not (self.whole and self.store):
            return None
        number = self.whole[0]["variant"]
        return ["sweep", "worst", self.store, "--rerun", number, "--out", f"variant-{number}"]


def _chunks(study: Study, numbers: Sequence[int], pool: Workers | None, executor: Executor, tell: Callable[[int], None]) -> Iterator[Chunk]:
    """Yield finished chunks, in any order. They do not depend on the executor; only threads and a GPU tell the variants done in between."""
    if pool is not None:
        yield from (chunk for _, chunk in pool.run(chunk_elsewhere, pool.shared(replace(study, cases={})), numbers))
        return
    together = max(GPU_LANES // study.design.chunk, 1) if executor.gpu and not study.signals else 1
    for first in range(0, len(numbers), together):
        chosen = numbers[first : first + together]
        count = sum(len(study.design.numbers(number)) for number in chosen)
        part = lambda share, count=count: tell(int(share * count))  # noqa: E731
        yield from run_chunks(study, chosen, executor.workers, part, gpu=executor.gpu)


def rerun(folder: str | Path, number: int, settings: Worst, session: Session) -> Runs:
    """Run a variant of a store again; write its scenario into the folder of the answer, if there is one.

    Raises
    ------
    ContourlabError
        If the variant is not in the store, cannot be built or diverges, or the folder cannot be written.
    """
    store = read_store(folder)
    row = variant(store, number)
    fits = (one for one in store.manifest.structures if all(row.get(key) == label for key, label in one.choices.items()))
    if (structure := next(fits, None)) is None:
        raise ResultError(f"{store.home}: has no scenario for variant {number}: restore its manifest.json")
    base = parse_scenario(structure.scenario, f"{folder}: variant {number}", settings.plugin).base
    values = {name: row[name] for name in store.manifest.columns if name not in structure.choices and row[name] is not None}
    findings = (*remarks(store, {}), *_differences(store, row, base, values))
    machine, controller = with_values(base.machine, base.controller, values)
    run = base.run if store.manifest.tolerance is None else replace(base.run, tolerance=store.manifest.tolerance)
    case = replace(base, machine=machine, controller=controller, run=run)
    scenario = Scenario(f"variant {number}", Path(f"variant-{number}.toml"), case)
    file = session.folder / f"variant-{number}.toml" if session.saving else scenario.file
    if session.saving:
        write_text_atomic(file, proposed(f"Variant {number} of {folder}.", dump(scenario)))
    words = ["contourlab", "run", str(file), *settings.words_of(Plugins)]
    try:
        runs = run_schemes(scenario, replace(session, command=as_typed(words)))
    except DivergenceError as error:
        for one in findings:
            error.add_note(str(one))
        raise
    return replace(runs, outcomes=tuple(replace(each, findings=(*findings, *each.findings)) for each in runs.outcomes))


def _differences(store: Store, row: Mapping[str, Any], case: Case, values: Mapping[str, float]) -> Iterator[Finding]:
    """Run a variant again as the study did; yield the first figure that is not that of its row."""
    numbers = tuple((name, i, Distribution("values", (value,))) for i, (name, value) in enumerate(values.items()))
    structure = Structure(case.machine, case.controller, case.reference(), case.seed, case.moving, numbers)
    design = Design("list", 1, 1, (1,) * len(numbers))
    (chunk,) = run_chunks(Study({(): structure}, dict.fromkeys(values, ""), design=design, figures=tuple(store.manifest.figures)), [0])
    for name, unit in store.manifest.figures.items():
        stored, now = math.nan if row[name] is None else row[name], float(chunk.columns[name][0])
        if not np.isclose(now, stored, rtol=SAME, atol=0.0, equal_nan=True):
            unit, factor = display(unit)
            texts = {key: f"{number_text(value * factor, 9)} {unit}" for key, value in (("stored", stored), ("now", now))}
            yield finding("CL934", variant=row["variant"], figure=name, **texts)
            return
