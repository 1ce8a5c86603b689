"""Runs in chunks, each stored on disk when done, so that an interrupted study continues where it stopped."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple, TypeAlias

import numpy as np

from contourlab.arrays import Array
from contourlab.study.checkpoint import Checkpoint

Columns: TypeAlias = Mapping[str, Array]
"""Values [SI] by parameter name, each (n,)."""
Model: TypeAlias = Callable[[Columns], Mapping[str, Array]]
"""Figures of runs: `contourlab.study.Evaluator` or a replacement."""
Judge: TypeAlias = Callable[[Columns], Array]
"""One figure [SI] of runs, nan where a run failed."""
CHUNK = 1024
"""Runs that are simulated and stored together."""


class Figure(NamedTuple):
    """A figure of a run: its key in `contourlab.loop.BatchResult`, its printed name, and its display unit."""

    key: str
    label: str
    unit: str


FIGURES = {
    "integral": Figure("contour_error_integral", "integral of the contour error", "um s"),
    "rms": Figure("contour_error_rms", "contour error, rms", "um"),
    "max": Figure("contour_error_max", "largest contour error", "um"),
}
KEYS = tuple(figure.key for figure in FIGURES.values())


class Kept(Checkpoint):
    """Figures of runs in a folder: a file for each chunk."""

    def file(self, columns: Columns) -> Path:
        """Return the file of a chunk; its name is a digest of the names and values of the columns."""
        rows = {name: np.ascontiguousarray(values, dtype="<f8") for name, values in columns.items()}
        return self.path(*(f"\n{name}\n".encode() + values.tobytes() for name, values in rows.items()))

    def read(self, columns: Columns) -> dict[str, Array] | None:
        """Return the stored figures of a chunk; None if there are none."""
        return self.load(self.file(columns))

    def write(self, columns: Columns, figures: Mapping[str, Array]) -> Path:
        """Store the figures of a chunk; return its file."""
        file = self.file(columns)
        self.store(file, {key: figures[key] for key in KEYS})
        return file


@dataclass(eq=False)
class Runs:
    """Runs of a model, a chunk at a time.

    Parameters
    ----------
    model : callable
    kept : Kept, optional
        Store of chunks; none by default.
    progress : callable, optional
        Called with the runs done and in all, for each call.
    made, reused : int
        Number of new runs, and of runs reused from an earlier study.
    """

    model: Model
    kept: Kept | None = None
    progress: Callable[[int, int], None] | None = None
    made: int = field(default=0, init=False)
    reused: int = field(default=0, init=False)
    _seen: set[Path] = field(default_factory=set, init=False, repr=False)

    def judge(self, key: str) -> Judge:
        """Return the function that computes one figure of runs, by its key."""
        return lambda columns: self(columns)[key]

    def __call__(self, columns: Columns) -> dict[str, Array]:
        """Return the figures of `FIGURES`, each (n,)."""
        n = len(next(iter(columns.values())))
        figures = {key: np.empty(n) for key in KEYS}
        for first in range(0, n, CHUNK):
            part = {name: np.asarray(values, dtype=float)[first : first + CHUNK] for name, values in columns.items()}
            chunk = self._chunk(part)
            for key in KEYS:
                figures[key][first : first + CHUNK] = chunk[key]
            if self.progress is not None:
                self.progress(min(first + CHUNK, n), n)
        return figures

    def _chunk(self, columns: Columns) -> dict[str, Array]:
        n = len(next(iter(columns.values())))
        figures = None if self.kept is None else self.kept.read(columns)
        if figures is not None and self.kept is not None:
            file = self.kept.file(columns)
            # Several parts of a study need the run with the present values: count it once.
            self.reused += n * (file not in self._seen)
            self._seen.add(file)
            return figures
        new = self.model(columns)
        figures = {key: np.asarray(new[key], dtype=float) for key in KEYS}
        self.made += n
        if self.kept is not None:
            self._seen.add(self.kept.write(columns, figures))
        return figures
