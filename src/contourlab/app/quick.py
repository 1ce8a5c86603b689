"""A quick answer: as much of a study as fits into a minute on two cores, planned from one timed run."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from time import process_time
from typing import TYPE_CHECKING

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.feed import Reference
from contourlab.feed.reference import CHUNK, WHOLE, Judged
from contourlab.loop.batch import LANES

if TYPE_CHECKING:
    from contourlab.study import Setting

PLANNED = 40.0
"""Time planned for a quick answer on two cores [s]: a minute, less a third for reading, planning, compiling and writing."""
CORES = 2


def affordable(run: Callable[[Reference], object], reference: Reference, threads: int | None = None) -> float:
    """Return how many times a run along a reference fits into the time of a quick answer.

    More than two cores give the same answer sooner. Processor time is measured, so other work on the machine hardly counts.

    Parameters
    ----------
    run : callable
        Runs once along the reference that it is given, on one thread.
    reference : Reference
    threads : int, optional
        Threads of the study; by default one for each processor.
    """
    few = min(CHUNK, reference.n_sample)
    short = beginning(reference, few)
    run(short)  # compiles
    total = PLANNED * min(threads or os.cpu_count() or 1, CORES)
    cost = _timed(run, short) * reference.n_sample / few
    return total / (_timed(run, reference) if cost < 0.01 * total else cost)


def affordable_candidates(setting: Setting, one: Mapping[str, Array], figures: Iterable[str], threads: int | None = None) -> float:
    """Return how many candidates fit into the time of a quick answer, in batches whose lanes are all filled.

    Parameters
    ----------
    setting : Setting
    one : mapping of str to ndarray (1,)
        Values [SI] of one candidate: those that the study varies.
    figures : iterable of str
        See `contourlab.study.Runner`.
    threads : int, optional
        See `affordable`.
    """
    columns = {name: np.repeat(values, LANES) for name, values in one.items()}
    run = lambda motion: replace(setting, reference=motion).batch(columns, figures, threads=1)  # noqa: E731
    return LANES * affordable(run, setting.reference, threads)


def beginning(reference: Reference, n_sample: int) -> Reference:
    """Return the first samples of a reference."""
    if n_sample >= reference.n_sample:
        return reference
    return replace(reference, n_sample=n_sample, laps=(), chosen=Judged(((0, n_sample),), WHOLE))


def too_slow(needed: float, fits: float) -> ParameterError:
    """Return the error of a study whose smallest quick form needs `needed` runs where only `fits` fit."""
    wanted = "left out, or given with a shorter motion, fewer parameters or another scheme"
    return ParameterError("--quick", f"{PLANNED / 60.0 * needed / fits:.0f} minutes at least", wanted)


def _timed(run: Callable[[Reference], object], reference: Reference) -> float:
    began = process_time()
    run(reference)
    return max(process_time() - began, 1e-4)
