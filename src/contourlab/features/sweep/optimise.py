"""``contourlab sweep optimise``: search the space of a study for the smallest figures, in batches; the store is that of any study."""

from __future__ import annotations

import hashlib
import json
import math
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from contourlab.app.session import Answer, Asked
from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.extras import extra_module
from contourlab.features.sweep.chunk import Chunk, chunk_elsewhere, joined, run_chunks
from contourlab.features.sweep.options import Optimise
from contourlab.features.sweep.query import counts, rows
from contourlab.features.sweep.store import Store, check_folder, writing
from contourlab.features.sweep.study import Study, load_study
from contourlab.features.sweep.summary import remarks, rows_text
from contourlab.figures import listing
from contourlab.findings import Finding
from contourlab.loop.batch import lanes_each
from contourlab.metrics.run_figures import title_of
from contourlab.rendering.stages import Stages
from contourlab.rendering.table import paragraphs
from contourlab.study.checkpoint import noted
from contourlab.study.design import Design
from contourlab.study.executors import Executor, Workers
from contourlab.study.statistics import pareto_front

JOURNAL = "optuna.log"
EDGE = 1e-6
"""Least distance of a cumulative probability from 0 and 1."""
SHOWN = 20
"""Most variants in the result."""


AGAIN = "Repeat the command with --resume to continue"


def kept_note(store: Store) -> AbstractContextManager[None]:
    """If the block is interrupted, add to the interrupt what is kept."""
    return noted(
        lambda: f"{len(store.parts)} of {store.chunks} chunks are kept in {store.home}. Repeat the command with --resume to continue."
    )


@dataclass(frozen=True)
class Search(Answer):
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
        if not self.best:
            return None
        number = self.best[0]["variant"]
        return ["sweep", "worst", self.store, "--rerun", number, "--out", f"variant-{number}"]

    @property
    def text(self) -> str:
        """Text for the terminal."""
        figures = listing([title_of(name) for name in self.minimise])
        what = "the smallest" if len(self.minimise) == 1 else f"{self.front_size} best compromises of"
        head = f"{self.done} of {self.trials} variants in {self.store}, sampler {self.sampler}: {what} {figures}"
        names = ["variant", *self.minimise, *self.columns]
        table = rows_text(names, [[row[name] for name in names] for row in self.best], {**self.columns, **self.minimise})
        return "\n\n".join(filter(None, (head, table, paragraphs(map(str, self.findings)))))


def optimise(file: str | Path, options: Optimise, stages: Stages) -> Search:
    """Search the space of a study; see `contourlab.features.sweep.command.optimise`."""
    for package in ("duckdb", "pyarrow.parquet", "optuna"):
        extra_module(package)
    if options.chosen == "cma-es":
        extra_module("cmaes")
    check_folder(options.out, resume=options.resume)
    stages.begin("planning the motions")
    study, levels = _space(load_study(file, options.plugin, stages.advance, variants=1), options)
    executor = options.pool
    with (
        executor.started(study.plugins, AGAIN) as pool,
        writing(options.out, study, resume=options.resume) as store,
        kept_note(store),
        _journal(store, options) as journal,
    ):
        stages.begin("searching")
        run = _simulated(study, executor, pool)
        for number in range(store.chunks):
            _batch(study, levels, store, journal, options, number, run)
            stages.advance(store.done, store.manifest.variants)
    return _result(store, options, study)


def _space(study: Study, options: Optimise) -> tuple[Study, list[Array]]:
    """Return the study with the design of the search, and the places of the values of each dimension; empty for a continuous one."""
    for name in options.minimise:
        if name not in study.figures:
            raise ParameterError("--minimise", repr(name), f"one of the figures of the study: {', '.join(study.figures)}")
    if study.design.kind == "list":
        raise ParameterError("design", "'list'", "a design whose entries vary independently")
    weights: dict[int, Sequence[float]] = {choice.dimension: choice.weights for choice in study.choices}
    weights |= {i: drawn.weights for one in study.structures.values() for _, i, drawn in one.numbers}
    levels = []
    for i, (_, count) in enumerate(study.dimensions):
        ends = np.concatenate([[0.0], np.cumsum(weights.get(i) or [1.0] * count)]) if count else np.zeros(1)
        middles = (ends[1:] + ends[:-1]) / 2.0 / max(ends[-1], 1e-300)
        levels.append(middles[np.diff(ends) > 0.0])
    if options.chosen == "cma-es" and any(len(places) for places in levels):
        raise ParameterError("--sampler", "'cma-es'", "tpe or nsga2 for a study with values = [...]")
    design = Design("search", options.trials, options.batch, study.design.levels, study.design.seed)
    samplers = [version(name) for name in ("optuna", *(["cmaes"] if options.chosen == "cma-es" else []))]  # another may ask for others
    said = json.dumps([study.identity["study"], options.minimise, options.chosen, options.trials, options.batch, samplers])
    identity = {**study.identity, "study": hashlib.sha256(said.encode()).hexdigest()}
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
        return joined(pool.map(_run_elsewhere, key, [(number, places[first : first + size]) for first in range(0, len(places), size)]))

    return run


def _run_elsewhere(study: Study, item: tuple[int, Array]) -> Chunk:
    return chunk_elsewhere(study, *item)


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
    names = ", ".join(f'"{name}"' for name in options.minimise)
    sql = f"SELECT {names} FROM results WHERE variant BETWEEN {numbers[0]} AND {numbers[-1]} ORDER BY variant"
    for trial, figures in zip(asked, rows(store, sql)[1], strict=True):
        journal.tell(trial, [math.inf if value is None else value for value in figures])


def _places(trial: Any, levels: Sequence[Array]) -> list[float]:
    """Return the cumulative probabilities of a trial, for each dimension of the study; a finished trial has its own."""
    found = []
    for i, places in enumerate(levels):
        if len(places):
            found.append(float(places[trial.suggest_categorical(f"u{i}", range(len(places)))]))
        else:
            found.append(float(trial.suggest_float(f"u{i}", EDGE, 1.0 - EDGE)))
    return found


def _result(store: Store, options: Optimise, study: Study) -> Search:
    names, found = rows(store, "SELECT * FROM results WHERE status = 'ok' ORDER BY variant")
    values = np.array([[row[names.index(name)] for name in options.minimise] for row in found], dtype=float)
    front = [] if not found else pareto_front(values).tolist() if len(options.minimise) > 1 else [int(np.argmin(values[:, 0]))]
    shown_rows = sorted({round(place) for place in np.linspace(0, len(front) - 1, SHOWN)}) if front else []
    best = tuple(dict(zip(names, found[front[i]], strict=True)) for i in shown_rows)
    about, findings = store.manifest, (*study.findings, *remarks(store, counts(store)))
    figures = {name: about.figures[name] for name in options.minimise}
    return Search(str(store.home), options.chosen, about.variants, store.done, figures, about.columns, len(front), best, findings)
