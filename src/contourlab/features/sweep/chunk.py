"""The variants of one chunk, simulated: the unit of work of every executor; and what a study will cost, measured on a few of them."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate, cycle
from time import perf_counter, process_time
from typing import Any

import numpy as np

from contourlab.app.quick import beginning
from contourlab.arrays import BLOCK, Array, Flags
from contourlab.engine.gpu import LANES as GPU_LANES
from contourlab.errors import ContourlabError, EngineError, ParameterError
from contourlab.features.sweep.study import Structure, Study
from contourlab.figures import number
from contourlab.loop.batch import LANES, checked_variants
from contourlab.rendering.stages import asked, told
from contourlab.study.executors import Executor, Workers
from contourlab.study.space import chosen

OK, DIVERGED, REFUSED = STATUSES = ("ok", "diverged", "refused")
"""Status of a variant: judged; left its following-error limit or became non-finite; a combination that a component refuses."""


@dataclass(frozen=True, eq=False)
class Chunk:
    """Results of a chunk.

    Attributes
    ----------
    number : int
    columns : mapping of str to ndarray (n_variant,)
        Modules, choices, parameters and figures in SI, ``status``, ``failed_at`` [s] and ``unsure``; nan where there is no value.
    signals : mapping of str to ndarray (n_variant, n_sample, n_axis)
        nan beyond the end of a run.
    seconds, cpu_seconds : float [s]
        Time and processor time of the work.
    """

    number: int
    columns: Mapping[str, Any]
    signals: Mapping[str, Array]
    seconds: float
    cpu_seconds: float


def run_chunks(
    study: Study,
    numbers: Sequence[int],
    threads: int | None = None,
    progress: Callable[[float], None] | None = None,
    *,
    gpu: bool = False,
    asked: Array | None = None,
) -> list[Chunk]:
    """Simulate the variants of chunks together. The results depend on the study and the number of each chunk alone.

    Parameters
    ----------
    study : Study
    numbers : sequence of int
    threads : int, optional
        By default one per processor.
    progress : callable, optional
        Called with the share done.
    gpu : bool
        Whether a GPU runs the variants.
    asked : ndarray (n_variant, n_dimension), optional
        Places of the variants of a single chunk, instead of those of the design.
    """
    began, cpu = perf_counter(), process_time()
    parts = [study.design.places(number) if asked is None else asked for number in numbers]
    places = np.concatenate(parts)
    n = len(places)
    codes = [np.asarray(choice.codes)[chosen(places[:, choice.dimension], len(choice.codes), choice.weights)] for choice in study.choices]
    columns: dict[str, Any] = {name: np.full(n, np.nan) for name in (*study.columns, *study.figures, "failed_at", "unsure")}
    members = [study.design.members(number) for number in numbers]
    columns |= {name: np.concatenate([of_chunk[name] for of_chunk in members]) for name in members[0]}
    columns["status"] = np.full(n, STATUSES.index(REFUSED))
    longest = max(structure.reference.n_sample for structure in study.structures.values())
    signals: dict[str, Array] = {}
    done = 0
    for combo, structure in study.structures.items():
        rows = np.flatnonzero(np.all([code == label for code, label in zip(codes, combo, strict=True)], axis=0)) if combo else np.arange(n)
        if not rows.size:
            continue
        given = {name: drawn.values(places[rows, i]) for name, i, drawn in structure.numbers}
        for name, values in given.items():
            columns[name][rows] = values
        accepted = _accepted(structure, given, len(rows))
        first, samples = done, n * structure.reference.n_sample / len(rows)
        done += len(rows)
        rows = rows[accepted]
        if not rows.size:
            continue
        batch = structure.batch(
            {name: values[accepted] for name, values in given.items()} or structure.as_it_is(len(rows)),
            study.figures,
            keep=study.signals,
            threads=threads,
            progress=None if progress is None else (lambda sample, first=first, samples=samples: progress(first / n + sample / samples)),
            gpu=gpu,
        )
        for name in study.figures:
            columns[name][rows] = structure.reference.duration if name == "cycle_time" else batch.figures[name]
        failed = batch.failed_at >= 0
        columns["status"][rows] = np.where(failed, STATUSES.index(DIVERGED), STATUSES.index(OK))
        columns["failed_at"][rows] = np.where(failed, batch.failed_at * structure.machine.servo_period, np.nan)
        columns["unsure"][rows] = batch.unsure
        for name, values in batch.signals.items():
            if failed.any():  # processors write nan differently
                values = np.where(np.isnan(values), np.nan, values)
            whole = signals.setdefault(name, np.full((n, longest, values.shape[1]), np.nan))
            whole[rows, : values.shape[0]] = np.moveaxis(values, 2, 0)
    for choice, code in zip(study.choices, codes, strict=True):
        columns[choice.key] = np.array(choice.labels, dtype=object if isinstance(choice.labels[0], str) else float)[code]
    share = (perf_counter() - began) / n, (process_time() - cpu) / n
    chunks = []
    for chunk, size, end in zip(numbers, map(len, parts), accumulate(map(len, parts)), strict=True):
        figures, kept = ({name: values[end - size : end] for name, values in table.items()} for table in (columns, signals))
        chunks.append(Chunk(chunk, figures, kept, *(size * time for time in share)))
    return chunks


def chunk_elsewhere(study: Study, item: tuple[int, Array | None]) -> Chunk:
    """Run a chunk, by its number, or places of it, in one thread; raise errors of a kind that can be sent."""
    number, asked = item
    try:
        return run_chunks(study, [number], 1, asked=asked)[0]
    except ContourlabError as error:
        raise EngineError(f"chunk {number}: {error}") from None


def joined(parts: Sequence[Chunk]) -> Chunk:
    """Return one chunk of parts of its variants, in order."""
    sizes = [len(part.columns["status"]) for part in parts]
    shapes = {name: values.shape[1:] for part in parts for name, values in part.signals.items()}
    columns = {name: np.concatenate([part.columns[name] for part in parts]) for name in parts[0].columns}
    signals = {
        name: np.concatenate([part.signals.get(name, np.full((n, *shape), np.nan)) for part, n in zip(parts, sizes, strict=True)])
        for name, shape in shapes.items()
    }
    return Chunk(parts[0].number, columns, signals, sum(part.seconds for part in parts), sum(part.cpu_seconds for part in parts))


def _accepted(structure: Structure, given: Mapping[str, Array], n: int) -> Flags:
    """Return which variants all components accept, by halves: combinations that a component refuses are rare."""
    accepted = np.ones(n, dtype=bool)
    if not given:
        return accepted

    def check(start: int, stop: int) -> None:
        try:
            checked_variants(structure.machine, structure.controller, {name: values[start:stop] for name, values in given.items()})
        except ParameterError:
            if stop - start == 1:
                accepted[start] = False
                return
            middle = (start + stop) // 2
            check(start, middle)
            check(middle, stop)

    check(0, n)
    return accepted


LONGEST, LARGEST = 3600.0, 10e9
"""Time [s] and disk [B] beyond which a study asks."""
PROBE, AGAIN = 0.3, 3.0
"""Times [s] of a measurement that is long beside the start of a batch, and beside groups that run side by side."""


@dataclass(frozen=True)
class Cost:
    """What variants will cost.

    Attributes
    ----------
    variants : int
    seconds : float [s]
    workers : str
    disk : float [B]
        At most: compression is not counted.
    """

    variants: int
    seconds: float
    workers: str
    disk: float

    @property
    def text(self) -> str:
        """One line for the terminal."""
        size, unit = (3600.0, "h") if self.seconds >= LONGEST else (60.0, "min") if self.seconds >= 120.0 else (1.0, "s")
        time, disk = f"{number(self.seconds / size, 2)} {unit}", f"{number(self.disk / 1e6, 2)} MB"
        return f"{self.variants} variants: about {time} on {self.workers}, up to {disk} of disk"


def cost_of(study: Study, chunks: range, made: Collection[int], executor: Executor, pool: Workers | None) -> Cost:
    """Return what chunks of a study will cost, without those made; workers elsewhere count as fast as this machine."""
    size, every = study.design.chunk, study.design.variants
    variants = min(chunks.stop * size, every) - chunks.start * size - sum(len(study.design.numbers(n)) for n in made if n in chunks)
    count = 1 if executor.gpu else pool.count if pool is not None else executor.workers or os.cpu_count() or 1
    name = "a GPU" if executor.gpu else f"{count} {'threads' if pool is None else 'workers'}"
    structures = list(study.structures.values())
    samples = [one.reference.n_sample for one in structures]
    mean, longest = sum(samples) / len(samples), samples.index(max(samples))
    first = beginning(structures[longest].reference, BLOCK)  # a GPU tells of it once
    probe = replace(study, choices=(), structures={(): replace(structures[longest], reference=first)}, signals=())
    threads = 1 if pool is not None else count
    each = _seconds_each(probe, GPU_LANES if executor.gpu else LANES * threads, threads, executor.gpu) if variants else 0.0
    row = len(study.columns) + len(study.figures) + len(study.signals) * mean * structures[0].reference.n_axis
    return Cost(variants, each * variants * mean / first.n_sample * threads / count, name, 8.0 * row * variants)


def agree(cost: Cost, *, yes: bool) -> None:
    """Tell what a study will cost; if that is much, ask at a terminal.

    Raises
    ------
    ParameterError
        If it is much, and nobody says yes.
    """
    told(cost.text)
    if (cost.seconds > LONGEST or cost.disk > LARGEST) and not yes and not asked(f"{cost.text}. Begin?"):
        raise ParameterError("study", cost.text, "an hour and 10 GB at most: add --yes, or make the study smaller")


def _seconds_each(study: Study, count: int, threads: int, gpu: bool) -> float:
    """Return the time of a variant [s], where `count` or more run together; the first measurement compiles."""
    first = True
    while True:
        count = min(count, study.design.variants)
        some = replace(study, design=replace(study.design, variants=count, chunk=max(count, 1)))
        began, groups = perf_counter(), 1 if gpu else -(-count // LANES)
        left, since = cycle(range(groups - 1, -1, -1)), [began]

        def stop(share: float, left: Iterator[int] = left, since: list[float] = since) -> None:
            now = perf_counter()
            if gpu and len(since) == 1:
                since.append(now)  # all is done, or the processor begins to run the variants in doubt
            elif share and next(left) == 0 and now - since[-1] > (AGAIN if gpu else PROBE):
                # Groups run side by side: the share is true after the last one.
                raise TimeoutError(since[-1] - since[0] + (now - since[-1]) / share)

        try:
            run_chunks(some, [0], threads, stop, gpu=gpu)
            seconds = perf_counter() - began
        except TimeoutError as enough:
            (seconds,) = enough.args
        if not first and (gpu or seconds > PROBE or count >= min(study.design.variants, study.design.chunk)):
            return float(seconds) / count
        count, first = count if first else min(4 * count, study.design.chunk), False
