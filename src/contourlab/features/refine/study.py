"""Refinement of machines and controllers: what is simulated along logs is brought to what was measured."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.identification.gauss_newton import Descent, DescentSettings, FitCovariance, descend, fit_covariance, spread_starts
from contourlab.design.values import with_values
from contourlab.errors import ParameterError
from contourlab.features.refine.log_run import Agreement, LogRun
from contourlab.features.refine.parameters import Sought, columns_of, seek
from contourlab.features.refine.remarks import remarks_on, worse_than_before

Array = NDArray[np.float64]
Rows = NDArray[np.bool_]
Window = tuple[float, float]
"""From, until [s] on a log's clock."""

SAME, ROUGH = 0.02, 2e-3
"""Share by which the sums of squares of two descents may differ and be one minimum, and gain at which a first descent ends."""
COUNTS = 4.0
"""Encoder counts, root mean square, that a difference changes the residual by at least."""
FEWEST = 10
"""Rows a parameter that a fit wants."""


@dataclass(frozen=True)
class RefineSettings:
    """How it is refined.

    Attributes
    ----------
    starts : int
        Descents: from what the files say, and from the best of many points around it.
    row_period : float [s]
        Between rows of residuals; a whole number of servo periods is taken.
    rounds : int
        How often channels are weighted anew, each by the size of what is left of it.
    descent : DescentSettings
    """

    starts: int = 3
    row_period: float = 1e-3
    rounds: int = 2
    descent: DescentSettings = field(default_factory=DescentSettings)

    def __post_init__(self) -> None:
        if not (1 <= self.starts <= 32 and self.rounds >= 1 and self.row_period > 0.0):
            raise ParameterError("settings", f"{self}", "starts from 1 to 32, rounds of 1 or more, row_period > 0")


@dataclass(frozen=True, eq=False)
class Refined:
    """What was found.

    Attributes
    ----------
    sought : tuple of Sought
    values, deviations, white_deviations : ndarray (p,)
        Deviations with the colour of the residual, and without; not a number for a parameter at a bound, infinite for one not told.
    at_bound : ndarray (p,) of bool
    knowledge : FitCovariance
        Of the parameters that are not at a bound.
    runs : tuple of LogRun
        With the refined parameters in place.
    windows : tuple of (float, float) or None
        Of each run what was fitted [s]; None for all of it.
    simulated : tuple of ndarray (n_sample, n_channel)
    before, after : tuple of Agreement
        As it began and as it is, over the samples that were fitted.
    unseen_before, unseen : tuple of Agreement
        The same over those that move and were not fitted.
    descents, agreeing : int
        Descents that were made, and those that ended at the same sum of squares as the best.
    remarks : tuple of str
    usable : bool
        False where the model explains less than nothing of a signal, or a descent has not converged.
    """

    sought: tuple[Sought, ...]
    values: Array
    deviations: Array
    white_deviations: Array
    at_bound: NDArray[np.bool_]
    knowledge: FitCovariance
    runs: tuple[LogRun, ...]
    windows: tuple[Window | None, ...]
    simulated: tuple[Array, ...]
    before: tuple[Agreement, ...]
    after: tuple[Agreement, ...]
    unseen_before: tuple[Agreement, ...]
    unseen: tuple[Agreement, ...]
    descents: int
    agreeing: int
    remarks: tuple[str, ...]
    usable: bool


def refine(
    runs: Sequence[LogRun],
    wanted: Iterable[str],
    *,
    windows: Sequence[Window | None] = (),
    settings: RefineSettings | None = None,
    progress: Callable[[str], None] | None = None,
) -> Refined:
    """Refine parameters until what is simulated along logs is as near as it gets to what was measured.

    Parameters
    ----------
    runs : sequence of LogRun
        A parameter of the machine is one for all runs that have it by name; a controller's too.
    wanted : iterable of str
        Names, and ranges where they are given, as of `contourlab.features.refine.parameters.seek`.
    windows : sequence of (float, float) or None
        Of each log the times [s] that are fitted; by default all of it. What moves outside of them is what was not seen.
    settings : RefineSettings, optional
    progress : callable, optional
        Told in words how far it is.

    Raises
    ------
    ParameterError
        If a parameter or a window is none, rows are fewer than ten a parameter, or the run diverges with the parameters as given.

    Notes
    -----
    Positions are compared, and commands where the log has them, every `row_period`. Channels are weighted by what is left of each, so that
    a run of large errors does not drown one of small errors: with normal residuals this is maximum likelihood.
    """
    chosen = settings or RefineSettings()
    sought = seek(runs, wanted)
    given = [windows[k] if k < len(windows) else None for k in range(len(runs))]
    kept = [_rows(run, window, chosen.row_period) for run, window in zip(runs, given, strict=True)]
    if sum(int(np.count_nonzero(rows)) for rows in kept) < FEWEST * len(sought):
        total = sum(int(np.count_nonzero(rows)) for rows in kept)
        raise ParameterError("--window", f"{total} rows for {len(sought)} parameters", f"{FEWEST} rows a parameter or more")
    problem = _Problem(runs, sought, kept)
    start = np.array([one.number.value for one in sought])
    first = problem.left(start[None])
    if not all(np.isfinite(part).all() for part in first):
        raise ParameterError("--parameter", "the start", "parameters with which the run does not diverge: look at the scenario first")
    problem.weigh(first, 0)
    found, agreeing, made = _descended(problem, chosen, progress)
    return _told(runs, sought, problem, found, given, (made, agreeing))


class _Problem:
    """Residuals of all runs at points (k, p), weighted."""

    def __init__(self, runs: Sequence[LogRun], sought: Sequence[Sought], kept: Sequence[Rows]) -> None:
        self.runs, self.sought, self.kept = runs, sought, kept
        self.sizes = [np.ones(run.measured.shape[1]) for run in runs]

    @property
    def start(self) -> Array:
        return np.array([one.number.value for one in self.sought])

    @property
    def low(self) -> Array:
        return np.array([one.number.low for one in self.sought])

    @property
    def high(self) -> Array:
        return np.array([one.number.high for one in self.sought])

    @property
    def scale(self) -> Array:
        return np.array([one.scale for one in self.sought])

    def left(self, points: Array) -> list[Array]:
        """Return measured less simulated of each run (n_row, n_channel, k)."""
        found = []
        for i, (run, rows) in enumerate(zip(self.runs, self.kept, strict=True)):
            columns = columns_of(self.sought, i, points)
            # Where none of its parameters is sought, a run is a constant.
            simulated = run.simulated(columns, rows) if columns else np.repeat(run.once()[rows][:, :, None], len(points), axis=2)
            found.append(run.measured[rows][:, :, None] - simulated)
        return found

    def weigh(self, left: Sequence[Array], which: int) -> None:
        """Take the rms of what is left of each channel, in one of the variants, as its size."""
        for i, part in enumerate(left):
            rms = np.sqrt(np.mean(part[:, :, which] ** 2, axis=0))
            floor = 1e-6 * np.sqrt(np.mean(self.runs[i].measured ** 2, axis=0))
            self.sizes[i] = np.maximum(np.maximum(rms, floor), 1e-12)

    def grains(self) -> Array:
        """Return the size of an encoder's count beside what is left of its channel."""
        found = []
        for run, sizes in zip(self.runs, self.sizes, strict=True):
            counts = [getattr(axis.sensor, "resolution", 0.0) for axis in run.machine.axes]
            found += [count / size for count, size in zip(counts, sizes, strict=False)]
        return np.array(found)

    def settings(self, given: DescentSettings) -> DescentSettings:
        """Return the settings of a descent whose differences show beside counts."""
        return replace(given, visible=max(given.visible, COUNTS * float(self.grains().max())))

    def residuals(self, points: Array) -> Array:
        """Return the weighted residuals (k, n)."""
        parts = [(part / size[:, None]).reshape(-1, len(points)) for part, size in zip(self.left(points), self.sizes, strict=True)]
        return np.ascontiguousarray(np.concatenate(parts).T)

    def split(self, flat: Array) -> list[Array]:
        """Return rows (n, ...) as one array (n_row, n_channel, ...) a run."""
        found, at = [], 0
        for run, rows in zip(self.runs, self.kept, strict=True):
            shape = int(np.count_nonzero(rows)), run.measured.shape[1]
            found.append(flat[at : at + shape[0] * shape[1]].reshape(*shape, *flat.shape[1:]))
            at += shape[0] * shape[1]
        return found


def _descended(problem: _Problem, chosen: RefineSettings, progress: Callable[[str], None] | None) -> tuple[Descent, int, int]:
    """Return the best descent, how many ended where it did, and how many were made."""
    say = progress or (lambda words: None)
    chosen = replace(chosen, descent=problem.settings(chosen.descent))
    bounds = problem.low, problem.high
    starts = spread_starts(problem.residuals, problem.start, *bounds, chosen.starts)
    rough, ends = replace(chosen.descent, least_gain=max(ROUGH, chosen.descent.least_gain)), []
    for i, start in enumerate(starts):
        ends.append(descend(problem.residuals, start, *bounds, problem.scale, rough if len(starts) > 1 else chosen.descent))
        say(f"descent {i + 1} of {len(starts)}: {ends[-1].iterations} steps, sum of squares {ends[-1].cost:.6g}")
    best = min(ends, key=lambda end: end.cost)
    agreeing = sum(end.cost <= best.cost * (1.0 + SAME) for end in ends)
    for _ in range(chosen.rounds):
        problem.weigh(problem.left(best.values[None]), 0)
        best = descend(problem.residuals, best.values, *bounds, problem.scale, problem.settings(chosen.descent))
        say(f"weighted anew: {best.iterations} steps")
    return best, agreeing, len(ends)


def rows_within(run: LogRun, window: Window | None) -> Rows:
    """Return which samples of a run lie within a window of times (n_sample,)."""
    times = run.times()
    return np.ones(times.size, dtype=bool) if window is None else (times >= window[0]) & (times < window[1])


def _rows(run: LogRun, window: Window | None, row_period: float) -> Rows:
    """Return the samples of a run that make residuals."""
    stride = max(round(row_period / run.machine.servo_period), 1)
    kept = np.zeros(run.reference.n_sample, dtype=bool)
    kept[run.moves[0] :: stride] = True
    kept &= rows_within(run, window)
    if not kept.any():
        low, high = window or (0.0, 0.0)
        begin, end = run.times()[[run.moves[0], -1]]
        bound = f"times at which {run.label} moves, {begin:.4g} s to {end:.4g} s on its clock"
        raise ParameterError("--window", f"{low:g} s..{high:g} s", bound)
    return kept


def _told(
    runs: Sequence[LogRun],
    sought: tuple[Sought, ...],
    problem: _Problem,
    found: Descent,
    windows: Sequence[Window | None],
    descents: tuple[int, int],
) -> Refined:
    free = ~found.at_bound
    floor = float(np.sqrt(np.mean(problem.grains() ** 2) / 12.0))  # of whole counts
    knowledge = fit_covariance(problem.split(found.jacobian[:, free]), problem.split(found.residual), floor)
    deviations, white = np.full(len(sought), math.nan), np.full(len(sought), math.nan)
    deviations[free], white[free] = knowledge.deviations, knowledge.white_deviations
    ends = tuple(_placed(run, sought, found.values, i) for i, run in enumerate(runs))
    simulated = tuple(run.once() for run in ends)
    before, after, unseen_before, unseen = _agreements(runs, ends, simulated, windows)
    said, usable = remarks_on(sought, found, deviations, white, knowledge, after, descents)
    said += worse_than_before("over what --window leaves out", unseen_before, unseen)
    said += tuple(note for run in runs for note in run.notes)
    known = found.values, deviations, white, found.at_bound, knowledge
    return Refined(sought, *known, ends, tuple(windows), simulated, before, after, unseen_before, unseen, *descents, said, usable)


def _placed(run: LogRun, sought: Sequence[Sought], values: Array, which: int) -> LogRun:
    """Return a run with the values of its parameters in their places."""
    mine = {one.name: float(value) for one, value in zip(sought, values, strict=True) if which in one.runs}
    machine, controller = with_values(run.machine, run.controller, mine)
    return replace(run, machine=machine, controller=controller)


def _agreements(
    runs: Sequence[LogRun], ends: Sequence[LogRun], simulated: Sequence[Array], windows: Sequence[Window | None]
) -> tuple[tuple[Agreement, ...], ...]:
    """Return the agreement before and after over what was fitted, and both over what moves outside of it."""
    before: list[Agreement] = []
    after: list[Agreement] = []
    unseen_before: list[Agreement] = []
    unseen: list[Agreement] = []
    for run, end, signals, window in zip(runs, ends, simulated, windows, strict=True):
        within = rows_within(run, window)
        moves = np.zeros_like(within)
        moves[slice(*run.moves)] = True
        fitted = within & moves if (within & moves).any() else within
        began = run.once()
        before += run.agreement(began, fitted)
        after += end.agreement(signals, fitted)
        if (moves & ~within).any():
            unseen_before += run.agreement(began, moves & ~within)
            unseen += end.agreement(signals, moves & ~within)
    return tuple(before), tuple(after), tuple(unseen_before), tuple(unseen)
