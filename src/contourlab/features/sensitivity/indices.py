"""All parameters at once: their distributions, the sample of runs, and the global indices of Sobol and Morris (computed by SALib)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array
from contourlab.errors import ParameterError, UnitError
from contourlab.loop.parameters import fits
from contourlab.scenario.quantities import read_number
from contourlab.study import DesignVariable, Space

UNIFORM, LOG_UNIFORM, NORMAL = KINDS = ("uniform", "log-uniform", "normal")
LEVELS = 4
ANALYSIS: dict[str, Any] = {"num_resamples": 200, "conf_level": 0.95}
REFUSED = 0.25
"""Largest share of failed runs; with more, indices are refused."""
BEYOND = 10.0
"""Without a following-error limit, a failed run counts as this multiple of the worst successful one."""


@dataclass(frozen=True)
class Distribution:
    """The distribution of one parameter within its bounds.

    Attributes
    ----------
    variable : DesignVariable
    kind : str
        One of `KINDS`; ``"normal"`` is centred on the present value and truncated at the bounds.
    deviation : float [SI], > 0
        Standard deviation of a normal distribution before truncation.
    """

    variable: DesignVariable = field(metadata=HIDDEN)
    kind: str = UNIFORM
    deviation: float = 0.0

    def __post_init__(self) -> None:
        variable = self.variable
        if self.kind not in KINDS:
            raise ParameterError("--distribution", repr(self.kind), f"one of {', '.join(KINDS)}")
        if self.kind == LOG_UNIFORM and variable.low <= 0.0:
            raise ParameterError(variable.name, f"bounds {variable.low:g} to {variable.high:g}", "above 0 for a log-uniform distribution")
        if self.kind == NORMAL and not 0.0 < self.deviation < math.inf:
            given = f"{self.deviation:g}" if self.deviation else "no deviation"
            raise ParameterError(variable.name, given, f'given a deviation, as --deviation "{variable.short}=5 %"')
        if self.kind == NORMAL and not variable.low <= variable.value <= variable.high:
            raise ParameterError(variable.name, f"{variable.value:g}", "within its bounds for a normal distribution", variable.unit)

    def values(self, places: Array) -> Array:
        """Return the values [SI] at cumulative probabilities from 0 to 1."""
        low, high, centre = self.variable.low, self.variable.high, self.variable.value
        if self.kind == UNIFORM:
            values = low + (high - low) * places
        elif self.kind == LOG_UNIFORM:
            values = low * (high / low) ** places
        else:
            from scipy.special import ndtr, ndtri

            first, last = ndtr((np.array([low, high]) - centre) / self.deviation)
            values = centre + self.deviation * ndtri(first + (last - first) * places)
        return np.asarray(np.clip(values, low, high))


def distributions(space: Space, kind: str = UNIFORM, deviations: Sequence[str] = ()) -> tuple[Distribution, ...]:
    """Return a distribution for each parameter of a space.

    Parameters
    ----------
    space : Space
    kind : str
        Distribution of the parameters without a deviation.
    deviations : sequence of str
        ``NAME=DEVIATION`` in ``%`` of the value or in the parameter's unit, or one deviation for all. These parameters are normal.

    Raises
    ------
    ParameterError
        If a name is not in the space, or a deviation cannot be read.
    """
    given: dict[str, float] = {}
    for text in deviations:
        name, equals, wanted = (part.strip() for part in text.rpartition("="))
        chosen = [variable for variable in space.numbers if not equals or fits(variable.name, name)]
        if not chosen:
            known = ", ".join(variable.short for variable in space.numbers[:4])
            raise ParameterError("--deviation", repr(text), f"NAME=DEVIATION with a varied parameter, such as {known}")
        given |= {variable.name: _deviation(variable, wanted) for variable in chosen}
    return tuple(
        Distribution(variable, NORMAL, given[variable.name]) if variable.name in given else Distribution(variable, kind)
        for variable in space.numbers
    )


def _deviation(variable: DesignVariable, text: str) -> float:
    unit = variable.display_unit
    wanted = f"a deviation of {variable.short} above 0, such as 5 %{f' or 2 {unit}' if unit else ''}"
    try:
        if text.endswith("%"):
            deviation = abs(variable.value) * float(text[:-1]) / 100.0
        else:
            deviation = float(read_number(text if variable.unit else float(text), variable.unit, variable.display))
    except (UnitError, ValueError) as error:
        raise ParameterError("--deviation", repr(text), wanted) from error
    if not 0.0 < deviation < math.inf:
        raise ParameterError("--deviation", repr(text), wanted)
    return deviation


@dataclass(frozen=True, eq=False)
class Sample:
    """Figures of runs, prepared for an estimator.

    Attributes
    ----------
    values : ndarray (n,)
        Decimal logarithm of the figure [SI] if `logarithmic`, else the figure [SI].
    logarithmic : bool
    runs, failed : int
    cap : float [SI]
        Upper limit of the figures, and the value of a failed run.
    """

    values: Array = field(metadata=HIDDEN)
    logarithmic: bool
    runs: int
    failed: int
    cap: float


def sample(figures: Array, level: float, logarithmic: bool, space: Space, points: Array) -> Sample:
    """Return figures prepared for an estimator.

    Parameters
    ----------
    figures : ndarray (n,) [SI]
        nan where a run failed.
    level : float [SI]
        Figure of a run that is always at the failure limit; infinite without a limit.
    logarithmic : bool
    space : Space
    points : ndarray (n, n_parameter)
        Points of the runs, 0 to 1, to report where runs fail.

    Raises
    ------
    ParameterError
        If more than `REFUSED` of the runs failed, or `logarithmic` is set and a figure is not above 0.
    """
    bad = np.isnan(figures)
    share = float(bad.mean())
    if share > REFUSED:
        right = f"at most {100.0 * REFUSED:.0f} %: the indices would show what makes the loop fail, not what makes it accurate"
        raise ParameterError(
            "runs", f"{100.0 * share:.0f} % failed", f"{right}. Narrow the bounds, beginning with {_strayed(space, points[bad])}"
        )
    cap = level if math.isfinite(level) else BEYOND * float(figures[~bad].max())
    values = np.minimum(np.where(bad, cap, figures), cap)
    if logarithmic:
        flat = values <= 0.0
        if flat.any():
            where = f"a figure of {values.min():g} in {int(flat.sum())} of {flat.size} runs, mainly {_strayed(space, points[flat])}"
            raise ParameterError("--transform log", where, "above 0 in all runs; use --transform none, which reuses these runs")
        values = np.log10(values)
    return Sample(values, logarithmic, values.size, int(bad.sum()), cap)


def _strayed(space: Space, points: Array) -> str:
    """Name the parameter whose mean over points (n, n_parameter) is farthest from the middle of its range, and the nearer end."""
    off = points.mean(axis=0) - 0.5
    at = int(np.argmax(np.abs(off)))
    return f"{space.numbers[at].short} at the {'upper' if off[at] > 0.0 else 'lower'} end"


@dataclass(frozen=True, eq=False)
class SobolIndices:
    """Shares of the variance.

    Attributes
    ----------
    first, first_interval : ndarray (n,)
        First-order indices: the share of each parameter alone; and half the width of the 95 % confidence interval.
    total, total_interval : ndarray (n,)
        Total indices: the share of each parameter with all its interactions; and the same interval.
    second, second_interval : ndarray (n, n) or None
        Second-order indices: the share of an interaction of two parameters. Above the diagonal, else nan; None if not requested.
    deviation : float
        Standard deviation of the sample.
    """

    first: Array
    first_interval: Array
    total: Array
    total_interval: Array
    second: Array | None
    second_interval: Array | None
    deviation: float


@dataclass(frozen=True, eq=False)
class MorrisIndices:
    """Elementary effects: the effect of a step over two thirds of the range, divided by its length.

    Attributes
    ----------
    mu_star, mu_star_interval : ndarray (n,)
        Mean magnitude of the effects, and half the width of its 95 % confidence interval.
    mu : ndarray (n,)
        Mean of the effects.
    sigma : ndarray (n,)
        Standard deviation of the effects: large if the effect is nonlinear or depends on other parameters.
    """

    mu_star: Array
    mu_star_interval: Array
    mu: Array
    sigma: Array


def _problem(n: int) -> dict[str, Any]:
    return {"num_vars": n, "names": [f"p{j}" for j in range(n)], "bounds": [[0.0, 1.0]] * n}


def saltelli_points(n: int, base: int, second: bool = False, seed: int = 0) -> Array:
    """Return the points of Saltelli's sampling in the unit cube: base (n + 2) points, or base (2 n + 2) for second order.

    Parameters
    ----------
    n : int, >= 2
        Number of parameters.
    base : int
        A power of two, which balances a Sobol sequence. The points of a smaller base are the first points of a larger one.
    second : bool
        Whether to sample for second-order indices.
    seed : int

    References
    ----------
    A. Saltelli et al., "Variance based sensitivity analysis of model output", Computer Physics Communications 181 (2010), 259-270.
    """
    from SALib.sample import sobol

    return np.asarray(sobol.sample(_problem(n), base, calc_second_order=second, seed=seed), dtype=float)


def sobol_indices(values: Array, n: int, second: bool = False, seed: int = 0) -> SobolIndices:
    """Return the Sobol indices of the values at `saltelli_points`, with bootstrap intervals.

    Notes
    -----
    If the values do not vary, all indices are 0. An estimate may lie a little below 0; its interval then includes 0.
    """
    zero = np.zeros(n)
    if np.ptp(values) == 0.0:
        pairs = np.where(np.triu(np.ones((n, n)), 1) > 0, 0.0, np.nan) if second else None
        return SobolIndices(zero, zero, zero, zero, pairs, pairs, 0.0)
    from SALib.analyze import sobol

    # A generator, because SALib treats the seed 0 as no seed: its intervals would differ each time.
    draw = np.random.default_rng(seed)
    found = sobol.analyze(_problem(n), values, calc_second_order=second, print_to_console=False, seed=draw, **ANALYSIS)
    arrays = {key: np.asarray(value, dtype=float) for key, value in found.items()}
    names = ("S1", "S1_conf", "ST", "ST_conf", "S2", "S2_conf")
    return SobolIndices(*(arrays.get(name) for name in names), float(values.std()))  # type: ignore[arg-type, call-arg]


def morris_points(n: int, trajectories: int, seed: int = 0) -> Array:
    """Return the points of Morris' design in the unit cube: trajectories (n + 1) points, on four levels.

    References
    ----------
    M. D. Morris, "Factorial sampling plans for preliminary computational experiments", Technometrics 33 (1991), 161-174.
    """
    from SALib.sample import morris

    return np.asarray(morris.sample(_problem(n), trajectories, num_levels=LEVELS, seed=seed), dtype=float)


def morris_indices(points: Array, values: Array, seed: int = 0) -> MorrisIndices:
    """Return the elementary effects of the values at `morris_points`, over the whole range of each parameter."""
    from SALib.analyze import morris

    found = morris.analyze(_problem(points.shape[1]), points, values, num_levels=LEVELS, seed=seed, **ANALYSIS)
    return MorrisIndices(*(np.asarray(np.ma.getdata(found[key]), dtype=float) for key in ("mu_star", "mu_star_conf", "mu", "sigma")))
