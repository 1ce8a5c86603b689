"""Refinement: fit parameters of machines and controllers so that simulations along logs follow the measurements."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from contourlab.analysis.identification.descent import Descent, DescentSettings, descend, spread_starts
from contourlab.analysis.identification.least_squares import FitCovariance, fit_covariance
from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array, Flags
from contourlab.errors import ParameterError, ResultError, refuse
from contourlab.features.refine.log_run import Agreement, LogRun
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.loop import parameters_of
from contourlab.study.space import DesignVariable, Space

SPAN = 10.0
"""Factor by which a parameter without a range may become smaller or larger."""


@dataclass(frozen=True)
class Sought:
    """A parameter to refine.

    Attributes
    ----------
    variable : DesignVariable
        Its name, start, range and unit.
    runs : tuple of int
        The runs that share it.
    label : str
        The name, preceded by the label of the run if only this run has the parameter.
    signed : bool
        Whether the parameter may be below zero.
    """

    variable: DesignVariable
    runs: tuple[int, ...]
    label: str
    signed: bool

    @property
    def name(self) -> str:
        """Dotted name."""
        return self.variable.name

    @property
    def scale(self) -> float:
        """Size of the parameter, used to scale steps."""
        return max(abs(self.variable.value), 0.1 * (self.variable.high - self.variable.low))

    def shown(self, value: float, digits: int = 5) -> str:
        """Return a value [SI] in the display unit."""
        return f"{figure(self.variable.display_value(value), digits=digits)} {self.variable.display_unit}".strip()


@dataclass(frozen=True)
class RefinedParameter:
    """A refined parameter.

    Attributes
    ----------
    value, deviation, white_deviation : float [SI]
        Standard deviations for a coloured and for a white residual: nan at a bound, infinite if the logs do not determine the parameter.
        With several logs, `deviation` includes the scatter between them.
    """

    sought: Sought
    value: float
    deviation: float
    white_deviation: float
    at_bound: bool


def seek(runs: Sequence[LogRun], wanted: Iterable[str]) -> tuple[Sought, ...]:
    """Return the parameters that the texts name, each once.

    Parameters
    ----------
    wanted : iterable of str
        ``NAME`` or ``NAME=LOW..HIGH``, see `contourlab.study.Space.chosen`; ``LABEL:NAME`` selects one run.

    Raises
    ------
    ParameterError
        If a name matches nothing, a parameter is named twice or starts at different values in different runs, or a range is wrong.
    """
    sought: dict[tuple[str, tuple[int, ...]], Sought] = {}
    for text in wanted:
        label, _, rest = text.rpartition(":")
        among = [i for i, run in enumerate(runs) if label in ("", run.label)]
        if not among:
            raise ParameterError("--parameter", text, f"preceded by the label of a run: {', '.join(run.label for run in runs)}")
        chosen = _chosen(runs, among, rest)
        for name in dict.fromkeys(name for variables in chosen.values() for name in variables):
            held = tuple(i for i in among if name in chosen[i])
            if any(name == other and set(held) & set(places) for other, places in sought):
                raise ParameterError("--parameter", name, "given once")
            sought[name, held] = _sought(runs, [chosen[i][name] for i in held], held, label)
    refuse(not sought, ParameterError, "--parameter", "none", "one or more, such as axes.x.plant.damping")
    return tuple(sought.values())


def _chosen(runs: Sequence[LogRun], among: Sequence[int], text: str) -> dict[int, dict[str, DesignVariable]]:
    """Return the parameters that a text selects in each run; raise only if it selects none in any run."""
    chosen: dict[int, dict[str, DesignVariable]] = {}
    for i in among:
        try:
            space = Space.chosen(runs[i].machine, runs[i].controller, [text], SPAN)
        except ParameterError as error:
            fits_nothing = error.name == "parameter"
            if not fits_nothing or (i == among[-1] and not any(chosen.values())):
                raise
            chosen[i] = {}
        else:
            chosen[i] = {variable.name: variable for variable in space.numbers}
    return chosen


def _sought(runs: Sequence[LogRun], variables: Sequence[DesignVariable], held: tuple[int, ...], label: str) -> Sought:
    variable = variables[0]
    part, name = parameters_of(runs[held[0]].machine, runs[held[0]].controller)[variable.name]
    sought = Sought(variable, held, f"{label}:{variable.name}" if label else variable.name, part.parameters[name].minimum < 0.0)
    starts = sorted({one.value for one in variables})
    if len(starts) > 1:
        bound = f"equal in all runs, or selected in one run as {runs[held[0]].label}:{variable.name}"
        raise ParameterError("--parameter", variable.name, f"{bound}; it starts at {' and '.join(map(sought.shown, starts))}")
    if part.parameters[name].whole or not math.isfinite(variable.value):
        raise ParameterError("--parameter", variable.name, f"a continuous parameter with a finite value; it is {variable.value:g}")
    if not variable.low <= variable.value <= variable.high:
        ends = f"{sought.shown(variable.low)}..{sought.shown(variable.high)}"
        raise ParameterError("--parameter", f"{variable.name}={ends}", f"a range that includes the start, {sought.shown(variable.value)}")
    return sought


TOGETHER = 0.95
"""Correlation from which two parameters cannot be distinguished."""
UNKNOWN = 0.5
"""Relative deviation from which a parameter is hardly known."""
EXPLAINED = 0.5
"""Explained share of a signal's variance below which there is a finding."""
WORSE = 0.01
"""Share by which the residual of data that was not fitted may grow."""
COLOURED = 1.5
"""Ratio of deviations for a coloured and a white residual from which there is a finding."""


def fit_findings(
    parameters: Sequence[RefinedParameter],
    descent: Descent,
    knowledge: FitCovariance,
    after: Sequence[Agreement],
    descents: tuple[int, int],
) -> Iterator[Finding]:
    """Yield findings that question the parameters.

    Parameters
    ----------
    knowledge : FitCovariance
        Covariance of the parameters that are not at a bound.
    descents : (int, int)
        Number of descents, and of those that reached the same minimum as the best one.
    """
    for parameter in parameters:
        value, deviation, place = parameter.value, parameter.deviation, parameter.sought.label
        if parameter.at_bound:
            yield finding("CL550", place, value=value)
        elif not np.isfinite(deviation):
            yield finding("CL551", place)
        elif deviation > UNKNOWN * abs(value) and not parameter.sought.signed:
            yield finding("CL552", place, ratio=deviation / abs(value) if value else np.inf)
    labels = [parameter.sought.label for parameter in parameters if not parameter.at_bound]
    for i, j in np.argwhere(np.triu(np.abs(knowledge.correlation), 1) > TOGETHER).tolist():
        if not (knowledge.untold[i] or knowledge.untold[j]):
            yield finding("CL553", f"{labels[i]} and {labels[j]}", correlation=float(knowledge.correlation[i, j]))
    if not descent.converged:
        yield finding("CL554", steps=descent.iterations)
    made, same = descents
    if made > 1 and same < made:
        yield finding("CL555", made=made, same=same)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratios = np.array([parameter.deviation for parameter in parameters]) / [parameter.white_deviation for parameter in parameters]
    ratio = float(np.nan_to_num(ratios, nan=1.0, posinf=1.0).max())
    if ratio > COLOURED:
        yield finding("CL556", ratio=ratio)
    for one in after:
        if one.explained <= 0.0:
            yield finding("CL558", one.place)
        elif one.explained < EXPLAINED:
            yield finding("CL557", one.place, explained=one.explained)


def unseen_findings(before: Sequence[Agreement], after: Sequence[Agreement], validation: bool = False) -> Iterator[Finding]:
    """Yield findings where the refined model fits unseen data worse than the model at the start.

    Parameters
    ----------
    before, after : sequence of Agreement
        For the same signals in the same order.
    validation : bool
        Whether the data is a log for validation, or the part of a fitted log outside `--window`.
    """
    for one, other in zip(before, after, strict=True):
        if other.rms > (1.0 + WORSE) * one.rms:
            values = {"ratio": other.rms / one.rms, "before": one.rms, "after": other.rms}
            yield finding("CL560", other.place, **values) if validation else finding("CL559", other.place, **values)


Window = tuple[float, float]
"""Start and end [s] on the clock of a log."""

SAME, ROUGH = 0.02, 2e-3
"""Share by which the sums of squares of two descents at the same minimum may differ, and gain below which a first descent ends."""
COUNTS = 4.0
"""Least change of the residual [encoder counts, rms] for a finite difference."""
FEWEST = 10
"""Least number of rows per parameter."""
ROW_PERIOD = 1e-3
"""Time between rows of residuals [s]; rounded to whole servo periods."""


@dataclass(frozen=True)
class RefineSettings:
    """How to refine.

    Attributes
    ----------
    starts : int, 1 to 32
        Number of descents: from the start, and from the best of many points around it.
    rounds : int, >= 1
        Number of times the channels are reweighted, each by the size of its residual.
    """

    starts: int = 3
    rounds: int = 2
    descent: DescentSettings = field(default_factory=DescentSettings)

    def __post_init__(self) -> None:
        refuse(not 1 <= self.starts <= 32, ParameterError, "settings", f"{self}", "starts from 1 to 32")


USUAL = RefineSettings()


@dataclass(frozen=True, eq=False)
class Refined:
    """Refined parameters, and how well the simulation follows the logs.

    Attributes
    ----------
    runs : tuple of LogRun
        With the refined parameters.
    windows : tuple of (float, float) or None
        Fitted times [s] of each run; None for all.
    simulated : tuple of ndarray (n_sample, n_channel)
    before, after : tuple of Agreement
        Over the fitted samples, with the parameters at the start and refined.
    unseen_before, unseen : tuple of Agreement
        Over the samples in motion that were not fitted.
    correlation : ndarray (p, p)
        Correlation of the parameters that are not at a bound.
    correlation_of : tuple of str
        Labels of these parameters.
    descents, agreeing : int
        Number of descents, and of those that reached the same sum of squares as the best.
    usable : bool
        False if the model explains nothing of a signal, or the descent has not converged.
    """

    parameters: tuple[RefinedParameter, ...]
    runs: tuple[LogRun, ...] = field(metadata=HIDDEN)
    windows: tuple[Window | None, ...]
    simulated: tuple[Array, ...] = field(metadata=HIDDEN)
    before: tuple[Agreement, ...]
    after: tuple[Agreement, ...]
    unseen_before: tuple[Agreement, ...]
    unseen: tuple[Agreement, ...]
    correlation: Array
    correlation_of: tuple[str, ...]
    descents: int
    agreeing: int
    usable: bool
    findings: tuple[Finding, ...] = field(metadata=HIDDEN)


def refine(runs: Sequence[LogRun], wanted: Iterable[str], **options: Any) -> Refined:
    """Refine the parameters that texts name, see `seek`; `options` are the keywords of `refine_sought`."""
    return refine_sought(runs, seek(runs, wanted), **options)


def refine_sought(
    runs: Sequence[LogRun],
    sought: Sequence[Sought],
    *,
    windows: Sequence[Window | None] = (),
    settings: RefineSettings = USUAL,
    progress: Callable[[str], None] = lambda line: None,
) -> Refined:
    """Refine parameters so that the simulation along logs comes closest to the measurements.

    Parameters
    ----------
    runs : sequence of LogRun
        Runs that have a parameter of the same name share it.
    sought : sequence of Sought
    windows : sequence of (float, float) or None
        Times [s] to fit in each log; by default all. Motion outside the windows is unseen.
    progress : callable, optional
        Called with a line after each descent.

    Raises
    ------
    ParameterError
        If a window is wrong, there are fewer than ten rows per parameter, or the run at the start diverges.

    Notes
    -----
    Positions, and commands if the logs have them, are compared every `ROW_PERIOD`. Each channel is weighted by its residual, so that a run
    with large errors does not dominate one with small errors. With normal residuals this is maximum likelihood.
    """
    given = (*windows, *(None for _ in runs[len(windows) :]))
    problem = _Problem(runs, sought, [_rows(run, window) for run, window in zip(runs, given, strict=True)])
    total = sum(int(np.count_nonzero(rows)) for rows in problem.kept)
    if total < FEWEST * len(sought):
        raise ParameterError("--window", f"{total} rows for {len(sought)} parameters", f"{FEWEST} rows per parameter or more")
    first = problem.left(problem.start)
    if not all(np.isfinite(part).all() for part in first):
        raise ParameterError("--parameter", "the start", "parameters with which the run does not diverge: check the scenario first")
    problem.weigh(first)
    chosen = problem.settings(settings.descent)
    starts = spread_starts(problem.residuals, problem.start, *problem.bounds, settings.starts)
    rough, ends = replace(chosen, least_gain=max(ROUGH, chosen.least_gain)), list[Descent]()
    for i, start in enumerate(starts):
        ends.append(descend(problem.residuals, start, *problem.bounds, problem.scale, rough if len(starts) > 1 else chosen))
        progress(f"descent {i + 1} of {len(starts)}: {ends[-1].iterations} steps, sum of squares {ends[-1].cost:.6g}")
    best = min(ends, key=lambda end: end.cost)
    agreeing = sum(end.cost <= best.cost * (1.0 + SAME) for end in ends)
    for _ in range(settings.rounds):
        problem.weigh(problem.left(best.values))
        best = descend(problem.residuals, best.values, *problem.bounds, problem.scale, problem.settings(chosen))
        progress(f"weights of the channels updated: {best.iterations} steps")
    return _refined(problem, best, given, (len(ends), agreeing))


def _counts(run: LogRun) -> Array:
    """Return the size of a count of each axis' encoder [m]; 0 for none."""
    return np.array([getattr(axis.sensor, "resolution", 0.0) for axis in run.machine.axes])


class _Problem:
    """Weighted residuals of all runs at points (k, p)."""

    def __init__(self, runs: Sequence[LogRun], sought: Sequence[Sought], kept: Sequence[Flags]) -> None:
        self.runs, self.sought, self.kept = runs, sought, kept
        self.sizes = [np.ones(run.measured.shape[1]) for run in runs]
        columns = [(one.variable.value, one.variable.low, one.variable.high, one.scale) for one in sought]
        self.start, low, high, self.scale = np.array(columns).T
        self.bounds = low, high

    def left(self, points: Array) -> list[Array]:
        """Return measured minus simulated of each run (n_row, n_channel, k), at points (k, p) or one (p,)."""
        left, points = [], np.atleast_2d(points)
        for i, (run, rows) in enumerate(zip(self.runs, self.kept, strict=True)):
            columns = {sought.name: points[:, j] for j, sought in enumerate(self.sought) if i in sought.runs}
            # A run without a parameter to refine is a constant.
            simulated = run.simulated(columns, rows) if columns else np.repeat(run.once()[rows][:, :, None], len(points), axis=2)
            left.append(run.measured[rows][:, :, None] - simulated)
        return left

    def weigh(self, left: Sequence[Array]) -> None:
        """Set the size of each channel to the rms of its residual at the first point; an encoder is not better known than its count."""
        for i, (run, part) in enumerate(zip(self.runs, left, strict=True)):
            rms = np.sqrt(np.mean(part[:, :, 0] ** 2, axis=0))
            floor = np.maximum(1e-6 * np.sqrt(np.mean(run.measured**2, axis=0)), 1e-12)
            counts = _counts(run)[: rms.size]
            floor[: counts.size] = np.maximum(floor[: counts.size], counts / math.sqrt(12.0))
            self.sizes[i] = np.maximum(rms, floor)

    def grains(self) -> Array:
        """Return the size of each encoder's count relative to the residual of its channel."""
        by_run = zip(self.runs, self.sizes, strict=True)
        return np.array([count / size for run, sizes in by_run for count, size in zip(_counts(run), sizes, strict=False)])

    def settings(self, given: DescentSettings) -> DescentSettings:
        """Return the settings of a descent whose finite differences exceed the encoder counts."""
        return replace(given, visible=max(given.visible, COUNTS * float(self.grains().max())))

    def residuals(self, points: Array) -> Array:
        """Return the weighted residuals (k, n)."""
        parts = [(part / size[:, None]).reshape(-1, len(points)) for part, size in zip(self.left(points), self.sizes, strict=True)]
        return np.ascontiguousarray(np.concatenate(parts).T)

    def split(self, flat: Array) -> list[Array]:
        """Split rows (n, ...) into one array (n_row, n_channel, ...) per run."""
        shapes = [(int(np.count_nonzero(rows)), run.measured.shape[1]) for run, rows in zip(self.runs, self.kept, strict=True)]
        parts = np.split(flat, np.cumsum([rows * channels for rows, channels in shapes])[:-1])
        return [part.reshape(*shape, *flat.shape[1:]) for part, shape in zip(parts, shapes, strict=True)]


def rows_within(run: LogRun, window: Window | None) -> Flags:
    """Return which samples (n_sample,) of a run lie within a time window."""
    times = run.times()
    return np.ones(times.size, dtype=bool) if window is None else (times >= window[0]) & (times < window[1])


def _rows(run: LogRun, window: Window | None) -> Flags:
    """Return the samples of a run that enter the residuals."""
    kept = np.zeros(run.reference.n_sample, dtype=bool)
    kept[run.moves[0] :: max(round(ROW_PERIOD / run.machine.servo_period), 1)] = True
    kept &= rows_within(run, window)
    if not kept.any():
        low, high = window or (0.0, 0.0)
        begin, end = run.times()[[run.moves[0], -1]]
        bound = f"times at which {run.label} moves, {begin:.4g} s to {end:.4g} s on its clock"
        raise ParameterError("--window", f"{low:g} s..{high:g} s", bound)
    return kept


def _refined(problem: _Problem, descent: Descent, windows: tuple[Window | None, ...], descents: tuple[int, int]) -> Refined:
    runs, free = problem.runs, ~descent.at_bound
    floor = float(np.sqrt(np.mean(problem.grains() ** 2) / 12.0))  # of whole counts
    knowledge = fit_covariance(problem.split(descent.jacobian[:, free]), problem.split(descent.residual), floor)
    deviations, white = np.full((2, free.size), math.nan)
    deviations[free], white[free] = knowledge.deviations, knowledge.white_deviations
    columns = (descent.values.tolist(), deviations.tolist(), white.tolist(), descent.at_bound.tolist())
    parameters = tuple(RefinedParameter(*row) for row in zip(problem.sought, *columns, strict=True))
    ends = [run.placed({one.sought.name: one.value for one in parameters if i in one.sought.runs}) for i, run in enumerate(runs)]
    simulated = [run.once() for run in ends]
    before, after, unseen_before, unseen = (list[Agreement]() for _ in range(4))
    for run, end, signals, window in zip(runs, ends, simulated, windows, strict=True):
        within, at_start = rows_within(run, window), run.once()
        moves = np.zeros_like(within)
        moves[slice(*run.moves)] = True
        fitted = within & moves if (within & moves).any() else within
        for rows, first, last in ((fitted, before, after), (moves & ~within, unseen_before, unseen)):
            if rows.any():
                first += run.agreement(at_start, rows)
                last += end.agreement(signals, rows)
    findings = [*fit_findings(parameters, descent, knowledge, after, descents), *unseen_findings(unseen_before, unseen)]
    findings += [one for run in runs for one in run.findings]
    return Refined(
        parameters,
        tuple(ends),
        windows,
        tuple(simulated),
        tuple(before),
        tuple(after),
        tuple(unseen_before),
        tuple(unseen),
        knowledge.correlation,
        tuple(parameter.sought.label for parameter in parameters if not parameter.at_bound),
        *descents,
        descent.converged and all(one.explained > 0.0 for one in after),
        tuple(findings),
    )


LEAST = 1e-12
"""Smallest contour error [m] that counts, so that an exact run has a logarithm."""


@dataclass(frozen=True)
class HeldOut:
    """A run, simulated with parameters that were refined against the other runs.

    Attributes
    ----------
    second_half : bool
        Whether only the second half of its motion counts, because parameters of this run alone were fitted to the first half.
    measured_rms, simulated_rms, measured_max, simulated_max : float [m]
        Contour error; of a machine with one axis, the tracking error.
    """

    run: str
    second_half: bool
    measured_rms: float
    simulated_rms: float
    measured_max: float
    simulated_max: float


@dataclass(frozen=True)
class CrossValidation:
    """Prediction of each run from the others.

    Attributes
    ----------
    level : float
        Share of new runs of the same kind whose measured contour error should lie within the factors: n/(n + 1) for n runs.
    rms_factor, max_factor : float, >= 1
        The measured contour error lies between the simulated one divided by the factor, and multiplied by it.
    """

    held_out: tuple[HeldOut, ...]
    level: float
    rms_factor: float
    max_factor: float


def new_run_factor(measured: Sequence[float], simulated: Sequence[float]) -> float:
    """Return the factor within which a new run's measured figure lies around its simulated one, in n of n + 1 cases.

    Parameters
    ----------
    measured, simulated : sequence of float (n,), n > 1
        Figures of runs that were left out.

    Notes
    -----
    With e = ln(measured/simulated), the factor is exp(t rms(e) sqrt(n^2 - 1)/n), where t is the quantile of Student's distribution with
    n - 1 degrees of freedom. It is exact if each run has its own normal value of e, and the mean of the others predicts it: the errors of n
    runs left out then share these n values and sum to zero. If the errors are independent, it contains up to 6 % more of the new runs
    (n = 2). A higher share needs more runs: for two, 90 % would take 5.5 times the rms in place of 1.5.
    """
    from scipy.stats import t

    n = len(measured)
    errors = np.log(np.maximum(measured, LEAST)) - np.log(np.maximum(simulated, LEAST))
    quantile = float(t.ppf(0.5 + 0.5 * n / (n + 1), n - 1))
    return math.exp(quantile * math.sqrt(n * n - 1) / n * float(np.sqrt(np.mean(errors**2))))


def cross_validated(
    refined: Refined, settings: RefineSettings = USUAL, progress: Callable[[str], None] = lambda line: None
) -> tuple[Refined, CrossValidation | None]:
    """Leave out each run in turn; return deviations that include the scatter between runs, and the prediction of the runs, if possible.

    Parameters
    ----------
    settings : RefineSettings, optional
        Each fit starts from the refined parameters, with one descent.
    progress : callable, optional
        Called with a line after each run.

    Notes
    -----
    The deviation of a shared parameter becomes that of the jackknife over runs, sqrt((n - 1)/n sum (value_i - mean)^2), if this is larger.
    Parameters of one run alone cannot come from the others: they are fitted to the first half of its motion, and the second half counts.
    """
    if len(refined.runs) < 2:
        return _unknown(refined, "there is one log only; the deviations come from within it and are likely too small")
    settings = replace(settings, starts=1, rounds=1)
    held: list[HeldOut] = []
    folds: list[dict[Sought, RefinedParameter]] = []
    try:
        for i in range(len(refined.runs)):
            folds.append(_fold(refined, i, settings))
            held.append(_held_out(refined, i, folds[i], settings))
            progress(f"left out {held[i].run}: {1e6 * held[i].measured_rms:.4g} um rms, {1e6 * held[i].simulated_rms:.4g} um predicted")
    except (ParameterError, ResultError) as error:
        return _unknown(refined, str(error))
    rms = new_run_factor([one.measured_rms for one in held], [one.simulated_rms for one in held])
    most = new_run_factor([one.measured_max for one in held], [one.simulated_max for one in held])
    level = len(held) / (len(held) + 1)
    stated = finding("CL566", level=level, rms_low=1.0 / rms, rms_high=rms, max_low=1.0 / most, max_high=most)
    parameters = tuple(_scattered(parameter, folds) for parameter in refined.parameters)
    return replace(refined, parameters=parameters, findings=(*refined.findings, stated)), CrossValidation(tuple(held), level, rms, most)


def _unknown(refined: Refined, reason: str) -> tuple[Refined, None]:
    return replace(refined, findings=(*refined.findings, finding("CL567", reason=reason))), None


def _again(parameter: RefinedParameter, runs: Sequence[int]) -> Sought:
    """Return a parameter to refine again from its refined value, in some of the runs, numbered anew."""
    sought = parameter.sought
    held = tuple(runs.index(i) for i in sought.runs if i in runs)
    return replace(sought, variable=replace(sought.variable, value=parameter.value), runs=held)


def _fold(refined: Refined, left_out: int, settings: RefineSettings) -> dict[Sought, RefinedParameter]:
    """Return the parameters refined without a run, by those refined with it."""
    others = [i for i in range(len(refined.runs)) if i != left_out]
    among = [parameter for parameter in refined.parameters if set(parameter.sought.runs) & set(others)]
    if not any(left_out in parameter.sought.runs for parameter in among):
        raise ParameterError("--parameter", f"none for {refined.runs[left_out].label} and another log", "one that two logs share")
    runs, windows = [refined.runs[i] for i in others], [refined.windows[i] for i in others]
    fit = refine_sought(runs, [_again(parameter, others) for parameter in among], windows=windows, settings=settings)
    return {parameter.sought: refitted for parameter, refitted in zip(among, fit.parameters, strict=True)}


def _held_out(refined: Refined, which: int, fold: dict[Sought, RefinedParameter], settings: RefineSettings) -> HeldOut:
    """Simulate a run with the parameters of the others."""
    run = refined.runs[which]
    run = run.placed({sought.name: refitted.value for sought, refitted in fold.items() if which in sought.runs})
    own = [_again(parameter, [which]) for parameter in refined.parameters if parameter.sought.runs == (which,)]
    begin, end = run.moves
    if own:
        middle = (begin + end) // 2
        times = run.times()
        (run,) = refine_sought([run], own, windows=[(float(times[begin]), float(times[middle]))], settings=settings).runs
        begin = middle
    (rms, most), (simulated_rms, simulated_max) = (run.contour(signals, slice(begin, end)) for signals in (None, run.once()))
    return HeldOut(run.label, bool(own), rms, simulated_rms, most, simulated_max)


def _scattered(parameter: RefinedParameter, folds: Sequence[dict[Sought, RefinedParameter]]) -> RefinedParameter:
    """Return a parameter with the deviation of the jackknife over its runs, if this is larger."""
    refitted = [folds[i][parameter.sought] for i in parameter.sought.runs if parameter.sought in folds[i]]
    # A fold that cannot determine the parameter keeps the start: it says nothing about scatter.
    if len(refitted) < 2 or not all(math.isfinite(one.deviation) for one in (parameter, *refitted)):
        return parameter
    scatter = math.sqrt(len(refitted) - 1) * float(np.std([one.value for one in refitted]))
    return replace(parameter, deviation=max(parameter.deviation, scatter))
