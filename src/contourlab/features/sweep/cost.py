"""What a study will cost: time, measured on a few of its variants, and disk."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from itertools import cycle
from time import perf_counter

from contourlab.engine.gpu import LANES as GPU_LANES
from contourlab.errors import ParameterError
from contourlab.features.sweep.chunk import run_chunks
from contourlab.features.sweep.study import Study
from contourlab.figures import number
from contourlab.loop.batch import LANES
from contourlab.rendering.stages import asked, told
from contourlab.study.executors import Executor, Workers

LONGEST, LARGEST = 3600.0, 10e9
"""Time [s] and disk [B] beyond which a study asks."""
PROBE = 0.3
"""Time of a measurement that is long beside the start of a batch [s]."""


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
    probe = replace(study, choices=(), structures={(): structures[longest]}, signals=())
    threads = 1 if pool is not None else count
    each = _seconds_each(probe, GPU_LANES if executor.gpu else LANES * threads, threads, executor.gpu) if variants else 0.0
    row = len(study.columns) + len(study.figures) + len(study.signals) * mean * structures[0].reference.n_axis
    return Cost(variants, each * variants * mean / max(samples) * threads / count, name, 8.0 * row * variants)


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
        left = cycle(range(groups - 1, -1, -1))

        def stop(share: float, began: float = began, left: Iterator[int] = left) -> None:
            if next(left) == 0 and perf_counter() - began > PROBE:  # groups run side by side: the share is true after the last one
                raise TimeoutError((perf_counter() - began) / share)  # the time that all of it would take

        try:
            run_chunks(some, [0], threads, stop, gpu=gpu)
            seconds = perf_counter() - began
        except TimeoutError as enough:
            (seconds,) = enough.args
        if not first and (gpu or seconds > PROBE or count >= min(study.design.variants, study.design.chunk)):
            return float(seconds) / count
        count, first = count if first else min(4 * count, study.design.chunk), False
