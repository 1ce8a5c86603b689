"""Global indices: Sobol's by the sampling of Saltelli, and Morris' elementary effects; both by SALib."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.errors import ParameterError
from contourlab.features.sensitivity.runs import Array

LEVELS = 4
RESAMPLES = 200
CONFIDENCE = 0.95


@dataclass(frozen=True, eq=False)
class SobolIndices:
    """Shares of the variance.

    Attributes
    ----------
    first, first_interval : ndarray (n,)
        What each number explains by itself, and half the width of the interval in which it lies with 95 % confidence.
    total, total_interval : ndarray (n,)
        The same with all that it does together with others.
    second, second_interval : ndarray (n, n) or None
        What two numbers explain together beyond each by itself: above the diagonal, else NaN; None where it was not asked for.
    deviation : float
        Standard deviation of what was explained.
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
    """Elementary effects: what a step over two thirds of the range does, divided by its length.

    Attributes
    ----------
    mu_star, mu_star_interval : ndarray (n,)
        Mean of their magnitudes, and half the width of its 95 % interval.
    mu : ndarray (n,)
        Their mean.
    sigma : ndarray (n,)
        Their standard deviation: large where the effect depends on the place, by a bend or an interaction.
    """

    mu_star: Array
    mu_star_interval: Array
    mu: Array
    sigma: Array


def _problem(n: int) -> dict[str, Any]:
    return {"num_vars": n, "names": [f"p{j}" for j in range(n)], "bounds": [[0.0, 1.0]] * n}


def check_saltelli(n: int, base: int) -> None:
    """See that points can be sampled.

    Raises
    ------
    ParameterError
        If there are fewer than two numbers, or the base is no power of two from 16.
    """
    if n < 2:
        raise ParameterError("--parameter", f"{n}", "two or more for shares of a variance; of one, take --parts curves,local")
    if base < 16 or base & (base - 1):
        near = [2**k for k in range(4, 25) if 2**k <= max(2 * base, 16)][-2:]
        raise ParameterError("--base", f"{base}", f"a power of two from 16, such as {' or '.join(map(str, near))}")


def check_morris(trajectories: int) -> None:
    """See that there are trajectories enough.

    Raises
    ------
    ParameterError
        If there are fewer than four.
    """
    if trajectories < 4:
        raise ParameterError("--trajectories", f"{trajectories}", "4 or more")


def saltelli_points(n: int, base: int, second: bool = False, seed: int = 0) -> Array:
    """Return the points of Saltelli's sampling in the unit cube: base (n + 2) of them, or base (2 n + 2) for second order.

    Parameters
    ----------
    n : int, >= 2
        Numbers.
    base : int
        A power of two, which a Sobol sequence is balanced at. The points of a smaller base are the first of those of a larger one.
    second : bool
        Whether indices of pairs are wanted.
    seed : int

    Raises
    ------
    ParameterError
        As of `check_saltelli`.

    References
    ----------
    A. Saltelli et al., "Variance based sensitivity analysis of model output", Computer Physics Communications 181 (2010), 259-270.
    """
    check_saltelli(n, base)
    from SALib.sample import sobol

    return np.asarray(sobol.sample(_problem(n), base, calc_second_order=second, seed=seed), dtype=float)


def sobol_indices(values: Array, n: int, second: bool = False, seed: int = 0) -> SobolIndices:
    """Return Sobol's indices of the values at `saltelli_points`; the intervals are of 200 bootstrap samples.

    Notes
    -----
    Where the values do not vary, all indices are 0. An index may come out a little below 0: its interval then holds 0.
    """
    zero = np.zeros(n)
    if np.ptp(values) == 0.0:
        pairs = np.where(np.triu(np.ones((n, n)), 1) > 0, 0.0, np.nan) if second else None
        return SobolIndices(zero, zero, zero, zero, pairs, pairs, 0.0)
    from SALib.analyze import sobol

    # A generator, not a number: of SALib's seeds 0 is none, and its intervals would come out otherwise each time.
    draw = np.random.default_rng(seed)
    found = sobol.analyze(
        _problem(n), values, calc_second_order=second, num_resamples=RESAMPLES, conf_level=CONFIDENCE, print_to_console=False, seed=draw
    )
    plain = {key: np.asarray(value, dtype=float) for key, value in found.items()}
    pair, pair_interval = (plain["S2"], plain["S2_conf"]) if second else (None, None)
    return SobolIndices(plain["S1"], plain["S1_conf"], plain["ST"], plain["ST_conf"], pair, pair_interval, float(values.std()))


def morris_points(n: int, trajectories: int, seed: int = 0) -> Array:
    """Return the points of Morris' design in the unit cube: trajectories (n + 1) of them, on four levels.

    Raises
    ------
    ParameterError
        If there are fewer than four trajectories.

    References
    ----------
    M. D. Morris, "Factorial sampling plans for preliminary computational experiments", Technometrics 33 (1991), 161-174.
    """
    check_morris(trajectories)
    from SALib.sample import morris

    return np.asarray(morris.sample(_problem(n), trajectories, num_levels=LEVELS, seed=seed), dtype=float)


def morris_indices(points: Array, values: Array, seed: int = 0) -> MorrisIndices:
    """Return the elementary effects of the values at `morris_points`, for each whole range of a number."""
    from SALib.analyze import morris

    found = morris.analyze(
        _problem(points.shape[1]), points, values, num_resamples=RESAMPLES, conf_level=CONFIDENCE, num_levels=LEVELS, seed=seed
    )
    mu_star, interval, mu, sigma = (
        np.asarray(np.ma.getdata(found[key]), dtype=float) for key in ("mu_star", "mu_star_conf", "mu", "sigma")
    )
    return MorrisIndices(mu_star, interval, mu, sigma)
