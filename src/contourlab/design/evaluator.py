"""Runs that judge many points of a space, in lanes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from contourlab.feed import Reference
from contourlab.geometry.view import PathView, view_of
from contourlab.loop import Controller, Machine, simulate_batch

Array = NDArray[np.float64]
CHUNK = 1024
"""Variants that are in memory at once."""


@dataclass(eq=False)
class Evaluator:
    """A machine, its controller and what they follow: figures of the run for any numbers in place of theirs.

    The same numbers give the same figures bit by bit, in whatever company and on however many threads.

    Attributes
    ----------
    machine, controller, reference
        As of `contourlab.loop.simulate_batch`.
    window : (int, int), optional
        Samples that count; by default the last whole lap, or all.
    moving : bool
        Whether the axes start with the velocity of the reference.
    seed : int
        Of all noise: the same for all points, so that they are compared under the same noise.
    threads : int, optional
        One for each processor by default.
    effort : bool
        Whether the figures of the drives are worked out too.
    runs : int
        How many runs it has made.
    """

    machine: Machine
    controller: Controller
    reference: Reference
    window: tuple[int, int] | None = None
    moving: bool = False
    seed: int = 0
    threads: int | None = None
    effort: bool = True
    runs: int = 0
    view: PathView = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self.view = view_of(self.reference.path)

    def __call__(
        self, columns: Mapping[str, Array], progress: Callable[[int], None] | None = None, threads: int | None = None
    ) -> dict[str, Array]:
        """Return the figures of `contourlab.loop.BatchResult`, each (n,), and ``failed_at``; NaN where a run failed.

        Parameters
        ----------
        columns : mapping of str to ndarray (n,)
            Values [SI] by dotted names.
        progress : callable, optional
            Told the number of runs done, after each `CHUNK`.
        threads : int, optional
            In place of its own.

        Raises
        ------
        ParameterError
            If a name is unknown or a value out of range.
        """
        n = len(next(iter(columns.values())))
        parts: list[dict[str, Array]] = []
        for first in range(0, n, CHUNK):
            part = {name: np.asarray(values)[first : first + CHUNK] for name, values in columns.items()}
            batch = simulate_batch(
                self.machine,
                self.controller,
                self.reference,
                part,
                window=self.window,
                effort=self.effort,
                view=self.view,
                seed=self.seed,
                threads=threads or self.threads,
                moving=self.moving,
            )
            parts.append({**batch.figures, "failed_at": batch.failed_at.astype(float)})
            self.runs += len(batch.failed_at)
            if progress is not None:
                progress(min(first + CHUNK, n))
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
