"""``contourlab sweep``: run a study into a store, or search its space for the smallest figures; ask, merge and export stores."""

from __future__ import annotations

import hashlib
import math
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from importlib.metadata import version
from pathlib import Path
from threading import Event
from time import perf_counter
from typing import Any

import numpy as np

from contourlab.app.command_line import as_typed
from contourlab.app.json_values import HIDDEN
from contourlab.app.results import proposed
from contourlab.app.session import QUIET, Answer, Asked, Session, question
from contourlab.app.shared_options import Plugins
from contourlab.arrays import Array
from contourlab.engine.gpu import LANES as GPU_LANES
from contourlab.errors import DivergenceError, ParameterError, ResultError, check_known, refuse
from contourlab.extras import extra_module
from contourlab.features.run.command import Runs, run_schemes
from contourlab.features.sweep.chunk import Chunk, agree, chunk_elsewhere, cost_of, joined, run_chunks
from contourlab.features.sweep.options import Export, Merge, Optimise, Query, Show, Sweep, Worst
from contourlab.features.sweep.query import Export as ExportedRows
from contourlab.features.sweep.query import Spread, Yield, counts, display, quoted, records, remarks, rows, rows_text, spreads, yield_of
from contourlab.features.sweep.query import export as exported
from contourlab.features.sweep.report import SweepReport, report
from contourlab.features.sweep.store import AGAIN, Store, numbers_in, read_store, writing
from contourlab.features.sweep.store import check_folder as check_store
from contourlab.features.sweep.store import merge as merged
from contourlab.features.sweep.study import Structure, Study, load_study
from contourlab.figures import figure, listing, number
from contourlab.findings import Finding, finding
from contourlab.loop.batch import lanes_each
from contourlab.loop.parameters import with_values
from contourlab.metrics.run_figures import title_of
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import write_text_atomic
from contourlab.scenario import Case, Scenario, dump, parse_scenario
from contourlab.study.design import DRAWN, Design
from contourlab.study.executors import Executor, Workers
from contourlab.study.space import Distribution
from contourlab.study.statistics import pareto_front

JOURNAL = "optuna.log"
EDGE = 1e-6
"""Least distance of a cumulative probability from 0 and 1."""
SHOWN = 20
"""Most variants in the result."""


def _run_again(store: str, rows: Sequence[Mapping[str, Any]]) -> Sequence[object] | None:
    """Return the words that run the first of some variants again."""
    return ["sweep", "worst", store, "--rerun", rows[0]["variant"], "--out", f"variant-{rows[0]['variant']}"] if store and rows else None


class InStore(Answer):
    """An answer about a store, which can be asked further: each method is the question of the same name."""

    store: str

    def _pictures(self) -> Iterator[Any]:
        yield from self.report()._pictures()

    def query(self, sql: str, **options: Any) -> Rows:
        """Return the rows of a query in SQL over the view ``results``, in SI."""
        return query(self.store, sql, **options)

    def worst(self, count: int = 10, **options: Any) -> Rows | Runs:
        """Return the worst variants with their parameters; with ``rerun``, the runs of one."""
        return worst(self.store, count, **options)

    def report(self, file: str | Path | None = None, **options: Any) -> SweepReport:
        """Return what the study says; write its page, if a file is named."""
        said = report(self.store, **options)
        return said if file is None else said.save(file)

    def export(self, to: str | Path) -> ExportedRows:
        """Write one row per variant into a file, in SI."""
        return export(self.store, to=to)


@dataclass(frozen=True)
class SweepSummary(InStore):
    """What a store holds.

    Attributes
    ----------
    store : str
    design : str
    variants, done : int
        Variants of the study, and in the store.
    chunks, chunks_done, chunks_made : int
        Chunks of the study, in the store, and of this call.
    columns : mapping of str to str
        What varies, with SI units.
    statuses : mapping of str to int
        Number of variants that ended ``ok``, ``diverged`` or were ``refused``; ``unsure`` counts those whose error is an upper bound.
    within : Yield or None
        The yield.
    figures : mapping of str to Spread
    elapsed, cpu_seconds : float [s]
        Time of all calls that wrote into the store, and processor time of its workers.
    rate : float [1/s]
        Variants per elapsed second.
    findings : tuple of Finding
    """

    store: str
    design: str
    variants: int
    done: int
    chunks: int
    chunks_done: int
    chunks_made: int
    columns: Mapping[str, str]
    statuses: Mapping[str, int]
    within: Yield | None = field(metadata={"json": "yield"})
    figures: Mapping[str, Spread]
    elapsed: float
    cpu_seconds: float
    rate: float
    findings: tuple[Finding, ...]
    fresh: bool = field(default=False, metadata=HIDDEN)

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Read the report of a study that was run."""
        return ["sweep", "report", self.store] if self.fresh else None

    @property
    def text(self) -> str:
        """Text for the terminal."""
        head = f"{self.done} of {self.variants} variants in {self.store}"
        if self.chunks_made:
            head += f"; {self.chunks_made} of {self.chunks} chunks new"
        if self.rate:
            head += f"; {number(self.rate)} variants per second, {figure(self.elapsed, 's')} in all"
        ended = ", ".join(f"{count} {status}" for status, count in self.statuses.items() if status != "unsure" or count)
        lines = [paragraphs([head, f"status: {ended or 'no variant yet'}"])]
        within = self.within
        if within is not None:
            ends = f" ({figure(within.low, '%', 4)} to {figure(within.high, '%', 4)} with 95 % confidence)"
            ends = ends if self.design in DRAWN else ""  # a grid or list is no sample
            what = f"{within.figure} within {figure(within.tolerance, 'um')}"
            share = f"yield: {figure(within.share, '%', 4)}{ends}"
            lines.append(paragraphs([f"{share}: {within.passed} of {within.judged} have {what}"]))
        if self.figures:
            names = ("mean", "minimum", "p5", "median", "p95", "p99", "maximum")
            rows = []
            for name, spread in self.figures.items():
                unit, factor = display(spread.unit)
                values = (getattr(spread, word) for word in names)
                rows.append((name, unit, *("-" if value is None else number(value * factor, 4) for value in values)))
            lines.append(Table([Column("figure", left=True), Column("unit", left=True), *map(Column, names)], rows=rows).text())
        return "\n\n".join(filter(None, [*lines, paragraphs(map(str, self.findings))]))


def summary(store: Store, made: int = 0, findings: Sequence[Finding] = ()) -> SweepSummary:
    """Return what a store holds, after `made` new chunks."""
    has_rows = bool(store.parts)
    statuses = counts(store) if has_rows else {}
    times = store.times()
    return SweepSummary(
        store=str(store.home),
        design=store.manifest.design,
        variants=store.manifest.variants,
        done=store.done,
        chunks=store.manifest.chunks,
        chunks_done=len(store.parts),
        chunks_made=made,
        columns=store.manifest.columns,
        statuses=statuses,
        within=yield_of(store) if has_rows else None,
        figures=spreads(store) if has_rows else {},
        elapsed=times["elapsed"],
        cpu_seconds=times["cpu_seconds"],
        rate=times["variants"] / times["elapsed"] if times["elapsed"] else 0.0,
        findings=(*findings, *remarks(store, statuses)),
    )


@dataclass(frozen=True)
class Search(InStore):
    """The result of a search.

    Attributes
    ----------
    store : str
    sampler : str
    trials, done : int
        Variants of the search, and in the store.
    minimise : dict of str to str
        Figures, with SI units.
    columns : dict of str to str
        What varies, with SI units.
    front_size : int
    best : tuple of dict
        The best variant, or members of the Pareto front, by the first figure; at most 20, evenly spaced.
    findings : tuple of Finding
    """

    store: str
    sampler: str
    trials: int
    done: int
    minimise: dict[str, str]
    columns: dict[str, str]
    front_size: int
    best: tuple[dict[str, Any], ...]
    findings: tuple[Finding, ...]

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The best variants, one a row [SI]."""
        return list(self.best)

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Run the best variant again."""
        return _run_again(self.store, self.best)

    @property
    def text(self) -> str:
        """Text for the terminal."""
        figures = listing([title_of(name) for name in self.minimise])
        what = "the smallest" if len(self.minimise) == 1 else f"{self.front_size} best compromises of"
        head = f"{self.done} of {self.trials} variants in {self.store}, sampler {self.sampler}: {what} {figures}"
        names = ["variant", *self.minimise, *self.columns]
        table = rows_text(names, [[row[name] for name in names] for row in self.best], {**self.columns, **self.minimise})
        return "\n\n".join(filter(None, (head, table, paragraphs(map(str, self.findings)))))


def _space(study: Study, options: Optimise) -> tuple[Study, list[Array]]:
    """Return the study with the design of the search, and the places of the values of each dimension; empty for a continuous one."""
    for name in options.minimise:
        if name not in study.figures:
            raise ParameterError("--minimise", repr(name), f"one of the figures of the study: {', '.join(study.figures)}")
    refuse(study.design.kind == "list", ParameterError, "design", "'list'", "a design whose entries vary independently")
    weights: dict[int, Sequence[float]] = {choice.dimension: choice.weights for choice in study.choices}
    weights |= {i: drawn.weights for one in study.structures.values() for _, i, drawn in one.numbers}
    levels = []
    for i, (_, count) in enumerate(study.dimensions):
        ends = np.concatenate([[0.0], np.cumsum(weights.get(i) or [1.0] * count)]) if count else np.zeros(1)
        levels.append(((ends[1:] + ends[:-1]) / 2.0 / max(ends[-1], 1e-300))[np.diff(ends) > 0.0])
    if options.chosen == "cma-es" and any(len(places) for places in levels):
        raise ParameterError("--sampler", "'cma-es'", "tpe or nsga2 for a study with values = [...]")
    design = Design("search", options.trials, options.batch, study.design.levels, study.design.seed)
    samplers = [version(name) for name in ("optuna", *(["cmaes"] if options.chosen == "cma-es" else []))]  # another may ask for others
    about = repr((study.identity["study"], options.minimise, options.chosen, options.trials, options.batch, samplers))
    identity = {**study.identity, "study": hashlib.sha256(about.encode()).hexdigest()}
    return replace(study, design=design, identity=identity), levels


@contextmanager
def _journal(store: Store, options: Optimise) -> Iterator[Any]:
    """Yield an Optuna study with a new journal in a store, whose writer we are; one that is there is not read, as Optuna unpickles it."""
    import optuna
    from optuna.storages.journal import JournalFileBackend

    file = store.home / JOURNAL
    for name in (JOURNAL, JOURNAL + ".lock"):
        file.with_name(name).unlink(missing_ok=True)
    verbosity = optuna.logging.get_verbosity()
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)
            yield optuna.create_study(
                storage=optuna.storages.JournalStorage(JournalFileBackend(str(file))),
                study_name="contourlab",
                directions=["minimize"] * len(options.minimise),
            )
    finally:
        optuna.logging.set_verbosity(verbosity)


def _sampler(options: Optimise, seed: int) -> Any:
    from optuna.samplers import CmaEsSampler, NSGAIISampler, TPESampler

    if options.chosen == "tpe":
        return TPESampler(seed=seed, n_startup_trials=options.batch, constant_liar=True)
    if options.chosen == "nsga2":
        return NSGAIISampler(seed=seed, population_size=options.batch)
    return CmaEsSampler(seed=seed, popsize=options.batch)


def _simulated(study: Study, executor: Executor, pool: Workers | None) -> Callable[[Array, int], Chunk]:
    """Return the function that simulates the places of a batch, given its number."""
    if pool is None:
        return lambda places, number: run_chunks(study, [number], executor.workers, gpu=executor.gpu, asked=places)[0]
    key = pool.shared(replace(study, cases={}))

    def run(places: Array, number: int) -> Chunk:
        size = lanes_each(len(places), pool.count)
        return joined(pool.map(chunk_elsewhere, key, [(number, places[first : first + size]) for first in range(0, len(places), size)]))

    return run


def _batch(
    study: Study,
    levels: Sequence[Array],
    store: Store,
    journal: Any,
    options: Optimise,
    number: int,
    run: Callable[[Array, int], Chunk],
) -> None:
    """Ask for a batch, simulate and store it, and tell its figures; a batch in the store is not simulated again.

    The number of a trial is that of its variant. Each batch has a sampler of its own seed, so that a search that goes on asks for the same.
    """
    first = number * options.batch
    numbers = range(first, min(first + options.batch, options.trials))
    journal.sampler = _sampler(options, (study.design.seed + number) % 2**32)
    asked = [journal.ask() for _ in numbers]
    places = np.array([_places(trial, levels) for trial in asked])
    if number not in store.parts:
        began = perf_counter()
        chunk = run(places, number)
        store.write(chunk)
        store.log(chunk, perf_counter() - began)
    names = ", ".join(map(quoted, options.minimise))
    sql = f"SELECT {names} FROM results WHERE variant BETWEEN {numbers[0]} AND {numbers[-1]} ORDER BY variant"
    for trial, figures in zip(asked, rows(store, sql)[1], strict=True):
        journal.tell(trial, [math.inf if value is None else value for value in figures])


def _places(trial: Any, levels: Sequence[Array]) -> list[float]:
    """Return the cumulative probabilities of a trial, for each dimension of the study; a finished trial has its own."""
    most = 1.0 - EDGE
    return [
        float(places[trial.suggest_categorical(f"u{i}", range(len(places)))] if len(places) else trial.suggest_float(f"u{i}", EDGE, most))
        for i, places in enumerate(levels)
    ]


def _result(store: Store, options: Optimise, study: Study) -> Search:
    found = records(store, "WHERE status = 'ok' ORDER BY variant")
    values = np.array([[row[name] for name in options.minimise] for row in found], dtype=float)
    front = [] if not found else pareto_front(values).tolist() if len(options.minimise) > 1 else [int(np.argmin(values[:, 0]))]
    shown_rows = sorted({round(place) for place in np.linspace(0, len(front) - 1, SHOWN)}) if front else []
    best = tuple(found[front[i]] for i in shown_rows)
    about, findings = store.manifest, (*study.findings, *remarks(store, counts(store)))
    figures = {name: about.figures[name] for name in options.minimise}
    return Search(str(store.home), options.chosen, about.variants, store.done, figures, about.columns, len(front), best, findings)


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
    made, executor, stages = 0, settings.pool, session.stages()
    stages.begin("planning the motions")
    planned = load_study(study, settings.plugin, stages.advance, machine=settings.machine)
    wanted = settings.chosen(planned.design.chunks)
    with executor.started(planned.plugins, AGAIN) as pool:
        cost = cost_of(planned, wanted, numbers_in(settings.out), executor, pool)
        session.close()  # a bar would hide the question
        agree(cost, yes=settings.yes or settings.resume)
        stages = session.stages()
        with writing(settings.out, planned, resume=settings.resume) as store:
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
    for package in ("duckdb", "pyarrow.parquet", "optuna", *(["cmaes"] if settings.chosen == "cma-es" else [])):
        extra_module(package)
    check_store(settings.out, resume=settings.resume)
    stages, executor = session.stages(), settings.pool
    stages.begin("planning the motions")
    planned, levels = _space(load_study(study, settings.plugin, stages.advance, variants=1, machine=settings.machine), settings)
    with (
        executor.started(planned.plugins, AGAIN) as pool,
        writing(settings.out, planned, resume=settings.resume) as store,
        _journal(store, settings) as journal,
    ):
        stages.begin("searching")
        run = _simulated(planned, executor, pool)
        for number in range(store.manifest.chunks):
            _batch(planned, levels, store, journal, settings, number, run)
            stages.advance(store.done, store.manifest.variants)
    return _result(store, settings, planned)


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
    check_known("--figure", settings.figure, opened.manifest.figures)
    order = f"status = 'diverged' DESC, {quoted(settings.figure)} DESC, variant"
    found = records(opened, f"WHERE status <> 'refused' ORDER BY {order} LIMIT {count}")
    units = {**opened.manifest.columns, **opened.manifest.figures}
    return Rows(names, tuple(tuple(row[name] for name in names) for row in found), units, remarks(opened, {}), tuple(found), str(store))


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
    def json(self) -> tuple[dict[str, Any], ...]:
        """The rows."""
        return tuple(self.rows)

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
        return _run_again(self.store, self.whole)


def _chunks(study: Study, numbers: Sequence[int], pool: Workers | None, executor: Executor, tell: Callable[[int], None]) -> Iterator[Chunk]:
    """Yield finished chunks, in any order. They do not depend on the executor; only threads and a GPU tell the variants done in between."""
    if pool is not None:
        key = pool.shared(replace(study, cases={}))
        yield from (chunk for _, chunk in pool.run(chunk_elsewhere, key, ((number, None) for number in numbers)))
        return
    together = max(GPU_LANES // study.design.chunk, 1) if executor.gpu and not study.signals else 1

    ended = Event()

    def simulated(first: int) -> list[Chunk]:
        chosen = numbers[first : first + together]
        count = sum(len(study.design.numbers(number)) for number in chosen)

        def advance(share: float) -> None:
            if ended.is_set():
                raise KeyboardInterrupt
            tell(int(share * count))

        return run_chunks(study, chosen, executor.workers, advance, gpu=executor.gpu)

    firsts = range(0, len(numbers), together)
    if not executor.gpu:
        for first in firsts:
            yield from simulated(first)
        return
    with ThreadPoolExecutor(1) as ahead:  # the next chunks run while these are written
        running = [ahead.submit(simulated, first) for first in firsts[:1]]
        try:
            for first in firsts[1:]:
                ready = running.pop().result()
                running.append(ahead.submit(simulated, first))
                yield from ready
            for last in running:
                yield from last.result()
        finally:
            ended.set()


def rerun(folder: str | Path, number: int, settings: Worst, session: Session) -> Runs:
    """Run a variant of a store again; write its scenario into the folder of the answer, if there is one.

    Raises
    ------
    ContourlabError
        If the variant is not in the store, cannot be built or diverges, or the folder cannot be written.
    """
    store = read_store(folder)
    row = next(iter(records(store, f"WHERE variant = {number:d}")), None)
    if row is None:
        raise ParameterError("--rerun", f"{number}", "the number of a variant in the store")
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
    structure = Structure(case.machine, case.controller, case.reference(), case.run.seed, case.moving, numbers)
    design = Design("list", 1, 1, (1,) * len(numbers))
    (chunk,) = run_chunks(Study({(): structure}, dict.fromkeys(values, ""), design=design, figures=tuple(store.manifest.figures)), [0])
    for name, unit in store.manifest.figures.items():
        stored, now = math.nan if row[name] is None else row[name], float(chunk.columns[name][0])
        if not np.isclose(now, stored, rtol=SAME, atol=0.0, equal_nan=True):
            unit, factor = display(unit)
            texts = {key: f"{number(value * factor, 9)} {unit}" for key, value in (("stored", stored), ("now", now))}
            yield finding("CL934", variant=row["variant"], figure=name, **texts)
            return
