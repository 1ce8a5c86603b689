"""Simulation of many candidates in parallel lanes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from contourlab.arrays import Array
from contourlab.feed import Reference
from contourlab.geometry.view import PathView, view_of
from contourlab.loop import Controller, Machine, simulate_batch

CHUNK = 1024
"""Largest number of candidates in memory."""


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
    """

    machine: Machine
    controller: Controller
    reference: Reference
    moving: bool = False
    seed: int = 0
    threads: int | None = None
    part: bool = False
    effort: bool = True
    runs: int = 0
    view: PathView = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self.view = view_of(self.reference.path)

    def __call__(self, columns: Mapping[str, Array], threads: int | None = None) -> dict[str, Array]:
        """Return figures, ``failed_at`` and ``unsure`` of `contourlab.loop.BatchResult`, each (n,); figures of a failed run are nan.

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
        parts: list[dict[str, Array]] = []
        for first in range(0, n, CHUNK):
            part = {name: np.asarray(values)[first : first + CHUNK] for name, values in columns.items()}
            batch = simulate_batch(
                self.machine,
                self.controller,
                self.reference,
                part,
                part=self.part,
                effort=self.effort,
                view=self.view,
                seed=self.seed,
                threads=threads or self.threads,
                moving=self.moving,
            )
            parts.append({**batch.figures, "failed_at": batch.failed_at.astype(float), "unsure": batch.unsure})
            self.runs += len(batch.failed_at)
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
