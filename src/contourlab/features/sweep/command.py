"""``contourlab sweep``: run a study into a store; show, merge and export stores; rerun single variants."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, ExitStack
from dataclasses import dataclass, field, replace
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from contourlab.app.json_values import json_values, write_json
from contourlab.app.results import proposed
from contourlab.engine.gpu import LANES as GPU_LANES
from contourlab.errors import DivergenceError, ParameterError, ResultError
from contourlab.extras import extra_module
from contourlab.features.run.command import RunOptions, RunOutcome, run_session
from contourlab.features.sweep.chunk import Chunk, chunk_elsewhere, run_chunks
from contourlab.features.sweep.cost import agree, cost_of
from contourlab.features.sweep.query import variant
from contourlab.features.sweep.store import Store, check_folder, numbers_in, read_store, writing
from contourlab.features.sweep.structures import Structure, Structured
from contourlab.features.sweep.study import Study, study_of
from contourlab.features.sweep.summary import SweepSummary, display, remarks, summary
from contourlab.figures import number as number_text
from contourlab.findings import Finding, finding
from contourlab.rendering.stages import shown
from contourlab.result import write_text_atomic
from contourlab.scenario import Case, Scenario, dump, parse_scenario
from contourlab.study.checkpoint import noted
from contourlab.study.design import Design
from contourlab.study.executors import Executor, Workers
from contourlab.study.space import Distribution
from contourlab.study.values import with_values

AGAIN = "Repeat the command with --resume to continue"
SAME = 1e-6
"""Largest relative difference between the stored figure of a variant and a new run; on the same processor they are equal."""


@dataclass(frozen=True)
class SweepOptions:
    """Options of the command.

    Attributes
    ----------
    executor : Executor
    resume : bool
        Whether to continue a store.
    chunks : str
        Chunks to run, as ``0:50``, the end excluded; empty for all.
    yes : bool
        Whether to begin whatever it costs; a store that goes on does.
    """

    executor: Executor = field(default_factory=Executor)
    resume: bool = False
    chunks: str = ""
    yes: bool = False

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
            raise ParameterError("--chunks", repr(self.chunks), f"FIRST:END, from 0:{count} for all; the end is not included")
        return range(first, min(last, count))


def sweep_study(
    file: str | Path, out: str | Path, options: SweepOptions, *, plugins: Sequence[str | Path] = (), progress: bool = False
) -> SweepSummary:
    """Run the variants of a study that are not in its store yet.

    Parameters
    ----------
    file : str or Path
        A study.
    out : str or Path
        Folder of the store.
    options : SweepOptions
    plugins : sequence of str or Path
        Python files with components.
    progress : bool
        Whether to show a bar.

    Raises
    ------
    ContourlabError
        If the study, an option or the folder is invalid, the disk is full, or a cluster is lost. Finished chunks stay.
    """
    for package in ("duckdb", "pyarrow.parquet"):
        extra_module(package)
    check_folder(out, resume=options.resume)
    made = 0
    with ExitStack() as stack:
        with shown(progress) as stages:
            stages.begin("planning the motions")
            study, structured = study_of(file, plugins, stages.advance)
            wanted = options.chosen(study.design.chunks)
            pool = stack.enter_context(options.executor.started(study.plugins, AGAIN))
            cost = cost_of(study, wanted, numbers_in(out), options.executor, pool)
        agree(cost, yes=options.yes or options.resume)
        stages = stack.enter_context(shown(progress))
        with writing(out, study, lambda: structures_of(structured), resume=options.resume) as store, kept_note(store):
            todo = [number for number in wanted if number not in store.parts]
            total = sum(len(study.design.numbers(number)) for number in todo)
            done, last = 0, perf_counter()
            stages.begin("running variants")
            tell = lambda more: stages.advance(done + more, total)  # noqa: E731
            for chunk in _chunks(study, todo, pool, options.executor, tell):
                store.write(chunk)
                now = perf_counter()
                store.log(chunk, now - last)
                last, made, done = now, made + 1, done + len(chunk.columns["status"])
                stages.advance(done, total)
        damaged = (finding("CL930", count=len(store.damaged)),) if store.damaged else ()
        stages.begin("reading the store")
        return summary(store, made, (*study.findings, *damaged))


def _chunks(study: Study, numbers: Sequence[int], pool: Workers | None, executor: Executor, tell: Callable[[int], None]) -> Iterator[Chunk]:
    """Yield finished chunks, in any order. They do not depend on the executor; only threads and a GPU tell the variants done in between."""
    if pool is not None:
        yield from (chunk for _, chunk in pool.run(chunk_elsewhere, pool.shared(study), numbers))
        return
    together = max(GPU_LANES // study.design.chunk, 1) if executor.gpu and not study.signals else 1
    for first in range(0, len(numbers), together):
        chosen = numbers[first : first + together]
        count = sum(len(study.design.numbers(number)) for number in chosen)
        part = lambda share, count=count: tell(int(share * count))  # noqa: E731
        yield from run_chunks(study, chosen, executor.workers, part, gpu=executor.gpu)


def kept_note(store: Store) -> AbstractContextManager[None]:
    """If the block is interrupted, add to the interrupt what is kept."""
    return noted(
        lambda: f"{len(store.parts)} of {store.chunks} chunks are kept in {store.folder}. Repeat the command with --resume to continue."
    )


def structures_of(made: Structured) -> list[dict[str, Any]]:
    """Return choices and scenario of each structure, for the manifest."""
    found = []
    for combo, case in made.cases.items():
        choices = {choice.key: choice.labels[code] for choice, code in zip(made.choices, combo, strict=True)}
        text = dump(Scenario(case.name, Path(), replace(case, learning=None)))
        found.append({"choices": choices, "scenario": text})
    return found


def rerun(folder: str | Path, number: int, options: RunOptions) -> RunOutcome:
    """Write the scenario of a variant into a folder, run it, and write its report.

    Parameters
    ----------
    folder : str or Path
        A store.
    number : int
        Number of the variant.
    options : RunOptions
        With the folder of the results.

    Raises
    ------
    ContourlabError
        If the variant is not in the store, cannot be built or diverges, or the folder cannot be written.
    """
    store = read_store(folder)
    row = variant(store, number)
    fits = (one for one in store.manifest["structures"] if all(row.get(key) == label for key, label in one["choices"].items()))
    if (structure := next(fits, None)) is None:
        raise ResultError(f"{store.folder}: has no scenario for variant {number}: restore its manifest.json")
    base = parse_scenario(structure["scenario"], f"{folder}: variant {number}", options.plugins).base
    values = {name: row[name] for name in store.columns if name not in structure["choices"] and row[name] is not None}
    findings = (*remarks(store, {}), *_differences(store, row, base, values))
    machine, controller = with_values(base.machine, base.controller, values)
    run = base.run if store.manifest["tolerance"] is None else replace(base.run, tolerance=store.manifest["tolerance"])
    case = replace(base, machine=machine, controller=controller, run=run)
    scenario = Scenario(f"variant {number}", Path(f"variant-{number}.toml"), case)
    file = options.out / f"variant-{number}.toml"
    write_text_atomic(file, proposed(f"Variant {number} of {folder}.", dump(scenario)))
    try:
        outcome = run_session(scenario, options, command=options.command("run", file, {}))
    except DivergenceError as error:
        for one in findings:
            error.add_note(str(one))
        raise
    for scheme in outcome.summary["schemes"].values():
        scheme["findings"] += json_values(findings)
        scheme["warnings"] += [one.text for one in findings if one.entry.severity == "warning"]
    write_json(options.out / "summary.json", outcome.summary)
    return replace(outcome, table="\n\n".join([*map(str, findings), outcome.table]))


def _differences(store: Store, row: Mapping[str, Any], case: Case, values: Mapping[str, float]) -> Iterator[Finding]:
    """Run a variant again as the study did; yield the first figure that is not that of its row."""
    numbers = tuple((name, i, Distribution("values", (value,))) for i, (name, value) in enumerate(values.items()))
    structure = Structure(case.machine, case.controller, case.reference(), case.seed, case.moving, numbers)
    design = Design("list", 1, 1, (1,) * len(numbers))
    (chunk,) = run_chunks(Study("", "", design, (), {(): structure}, dict.fromkeys(values, ""), tuple(store.figures)), [0])
    for name, unit in store.figures.items():
        stored, now = math.nan if row[name] is None else row[name], float(chunk.columns[name][0])
        if not np.isclose(now, stored, rtol=SAME, atol=0.0, equal_nan=True):
            unit, factor = display(unit)
            texts = {key: f"{number_text(value * factor, 9)} {unit}" for key, value in (("stored", stored), ("now", now))}
            yield finding("CL934", variant=row["variant"], figure=name, **texts)
            return
