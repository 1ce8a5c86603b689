"""Simulation of many candidates in parallel lanes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Protocol

import numpy as np

from contourlab.arrays import Array
from contourlab.engine.gpu import LANES as GPU_LANES
from contourlab.feed import Reference
from contourlab.geometry.view import PathView, view_of
from contourlab.loop import Controller, Machine, simulate_batch
from contourlab.loop.batch import checked_variants, lanes_each

CHUNK = 1024
"""Largest number of candidates in memory."""


class Pool(Protocol):
    """Workers elsewhere, see `contourlab.study.executors.Workers`."""

    @property
    def count(self) -> int:
        """Number of workers."""

    def shared(self, value: object) -> str:
        """Send a value to all workers; return its key."""

    def map(self, work: Callable[[Any, Any], Any], key: str, items: Iterable[Any]) -> list[Any]:
        """Return the result of each item, in order."""


@dataclass(eq=False)
class Evaluator:
    """Run a machine and its controller along a reference with many sets of parameters, and return the figures of each run.

    The same values give the same figures bit for bit, independent of the other candidates and of the number of threads.

    Attributes
    ----------
    machine, controller, reference
        As in `contourlab.loop.simulate_batch`.
    moving : bool
        Whether the axes start with the velocity of the reference.
    seed : int
        Of all noise, the same for all candidates.
    threads : int, optional
        One per processor by default.
    part : bool
        Whether to compute the part error as well.
    effort : bool
        Whether to compute figures of the drives as well.
    gpu : bool
        Whether a GPU runs the candidates.
    pool : Pool, optional
        Where to run; by default in threads of this process.
    """

    machine: Machine
    controller: Controller
    reference: Reference
    moving: bool = False
    seed: int = 0
    threads: int | None = None
    part: bool = False
    effort: bool = True
    gpu: bool = False
    pool: Pool | None = None
    runs: int = 0
    view: PathView = field(init=False, repr=False)
    _key: str = field(init=False, repr=False, default="")

    def __post_init__(self) -> None:
        self.view = view_of(self.reference.path)

    def __call__(self, columns: Mapping[str, Array], threads: int | None = None) -> dict[str, Array]:
        """Return figures and ``failed_at`` of `contourlab.loop.BatchResult`, each (n,); figures of a failed run are nan.

        Parameters
        ----------
        columns : mapping of str to ndarray (n,)
            Values [SI] by dotted names.
        threads : int, optional
            By default `threads` of the evaluator.

        Raises
        ------
        ParameterError
            If a name is unknown or a value out of range.
        """
        n = len(next(iter(columns.values())))
        size = GPU_LANES if self.gpu else CHUNK
        if self.pool is not None:
            size = min(size, lanes_each(n, self.pool.count))
        pieces = [{name: np.asarray(values)[first : first + size] for name, values in columns.items()} for first in range(0, n, size)]
        if self.pool is None:
            parts = [self.run(piece, self.part, threads or self.threads) for piece in pieces]
        else:
            checked_variants(self.machine, self.controller, columns)
            self._key = self._key or self.pool.shared(replace(self, pool=None))
            parts = self.pool.map(_run_elsewhere, self._key, [(piece, self.part) for piece in pieces])
        self.runs += n
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}

    def run(self, columns: Mapping[str, Array], part: bool, threads: int | None) -> dict[str, Array]:
        """Run candidates in this process; `part` replaces that of the evaluator."""
        batch = simulate_batch(
            self.machine,
            self.controller,
            self.reference,
            columns,
            part=part,
            effort=self.effort,
            view=self.view,
            seed=self.seed,
            threads=threads,
            moving=self.moving,
            gpu=self.gpu,
        )
        return {**batch.figures, "failed_at": batch.failed_at.astype(float)}


def _run_elsewhere(evaluator: Evaluator, item: tuple[Mapping[str, Array], bool]) -> dict[str, Array]:
    return evaluator.run(*item, threads=1)
