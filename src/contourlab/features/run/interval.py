"""How far a simulated contour error can be trusted: the interval that the stated deviations of the machine's numbers imply.

Sixty-four machines are drawn from the deviations, run in lanes and judged there. The points are those of a scrambled Sobol sequence, which
fill the space evenly; they depend on the seed and on nothing else, so that the figures are the same for any number of threads.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from contourlab.components.contract import Component
from contourlab.errors import ContourlabError
from contourlab.features.run.provenance import Number, numbers_of
from contourlab.feed import Reference
from contourlab.loop import Controller, Learned, Machine, parameter_names, simulate_batch

Array = NDArray[np.float64]

SAMPLES = 64
"""Machines that are drawn: two groups of 32 lanes."""
LEVELS = (0.05, 0.95)
"""Shares of the samples below the ends of an interval."""
FIGURES = {"rms": "contour_error_rms", "max": "contour_error_max"}
UNKNOWN = "not known: no number of the machine has a deviation"
EXACT = "of no width: every number of the machine is said to be exactly what it is"
NO_CHANGES = "not known: the run changes controllers on the way, which the lanes cannot"
TOO_LONG = "not known: with a gap observer, a bank of filters, it takes as long as 64 runs one by one; ask for it with --interval"


@dataclass(frozen=True)
class Spread:
    """Median and 5 to 95 % of a figure; infinite where so many samples failed.

    Attributes
    ----------
    median, low, high : float [m]
    """

    median: float
    low: float
    high: float


@dataclass(frozen=True, eq=False)
class Interval:
    """What the stated deviations make of the contour error.

    Attributes
    ----------
    reason : str
        Why it is not known; empty where it is.
    n : int
        Samples.
    rms, max : Spread or None [m]
    failed : int
        Samples that left a following-error limit, or gave a command that is not finite.
    beyond : int or None
        Samples that failed or whose largest contour error is beyond the tolerance; None without one.
    ranks : mapping of str to (float, float)
        Of each number that was drawn: rank correlation with rms and maximum, over the samples that did not fail; the strongest first.
    samples : mapping of str to ndarray (n,)
        The numbers that were drawn, in SI.
    figures : mapping of str to ndarray (n,) [m]
        ``rms`` and ``max`` of each sample; NaN where it failed.
    """

    reason: str = ""
    n: int = 0
    rms: Spread | None = None
    max: Spread | None = None
    failed: int = 0
    beyond: int | None = None
    ranks: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    samples: Mapping[str, Array] = field(default_factory=dict)
    figures: Mapping[str, Array] = field(default_factory=dict)

    @property
    def noticeable(self) -> float:
        """Size from which the largest of so many numbers' rank correlations is more than chance, at 5 % for all together (Bonferroni).

        Those of a number with rms and maximum count as one: the two go together.
        """
        from scipy.stats import t

        left = max(self.n - self.failed - 2, 1)
        quantile = float(t.ppf(1.0 - 0.025 / max(len(self.ranks), 1), left))
        return quantile / float(np.hypot(quantile, np.sqrt(left)))

    @property
    def main(self) -> str:
        """The number that contributes most; empty where none stands out from chance."""
        name = next(iter(self.ranks), "")
        return name if name and max(map(abs, self.ranks[name])) >= self.noticeable else ""


def contour_interval(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    *,
    seed: int = 0,
    tolerance: float | None = None,
    moving: bool = False,
    changes: Sequence[object] = (),
    learned: Learned | None = None,
    threads: int | None = None,
    n: int = SAMPLES,
    patient: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> Interval:
    """Return the interval of the contour error that the stated deviations imply.

    Parameters
    ----------
    machine, controller, reference
        As they are run.
    seed : int
        Of the run: all samples see its noise, and the points depend on it.
    tolerance : float [m], optional
        That the largest contour error is held against.
    moving : bool
        As of `contourlab.loop.simulate_batch`.
    changes : sequence
        Controllers that take over on the way, which lanes cannot.
    learned : Learned, optional
        What the machine as it is has learned, fed to each sample.
    threads : int, optional
    n : int
        Samples, a power of two.
    patient : bool
        Whether machines whose observer is a bank of filters are drawn too, which takes as long as that many runs one by one.
    progress : callable, optional
        Told samples done and samples in all.

    Returns
    -------
    Interval
        With a reason in words where there is none: no deviation, nothing but exact numbers, or a machine that cannot run in lanes.

    Notes
    -----
    Contour error here is that of the axes' true positions: the error map of the machine is not in it.
    """
    of_machine = [number for number in numbers_of(machine, controller) if number.drawn]
    uncertain = [number for number in of_machine if number.origin and number.origin.uncertain]
    if not uncertain:
        return Interval(EXACT if all(number.source == "design" for number in of_machine) else UNKNOWN)
    if changes:
        return Interval(NO_CHANGES)
    if not patient and any(controller.axes[name].gap_observer is not None for name in machine.axis_names):
        return Interval(TOO_LONG)
    columns = draw(uncertain, machine, controller, seed, n)

    def told(done: int) -> None:
        if progress is not None:
            progress(done, reference.n_sample)

    given = {"seed": seed, "threads": threads, "moving": moving, "learned": learned}
    try:
        found = simulate_batch(machine, controller, reference, columns, progress=told, **given)  # type: ignore[arg-type]
    except ContourlabError as error:
        return Interval(f"not known: the samples cannot run in lanes: {error}")
    figures = {name: found.figures[key] for name, key in FIGURES.items()}
    bad = ~np.isfinite(figures["max"])
    beyond = None if tolerance is None else int(np.count_nonzero(bad | (figures["max"] > tolerance)))
    spreads = {name: _spread(values) for name, values in figures.items()}
    return Interval("", n, spreads["rms"], spreads["max"], int(bad.sum()), beyond, _ranks(columns, figures, ~bad), columns, figures)


def _spread(values: Array) -> Spread:
    """Return median and ends; a sample that failed counts as infinitely far off."""
    with np.errstate(invalid="ignore"):
        found = np.quantile(np.where(np.isfinite(values), values, np.inf), (0.5, *LEVELS))
    return Spread(*np.where(np.isnan(found), np.inf, found).tolist())


def _ranks(columns: Mapping[str, Array], figures: Mapping[str, Array], kept: NDArray[np.bool_]) -> dict[str, tuple[float, float]]:
    from scipy.stats import rankdata

    def correlation(one: Array, other: Array) -> float:
        a, b = (rankdata(values[kept]) for values in (one, other))
        if a.size < 3 or np.ptp(a) == 0.0 or np.ptp(b) == 0.0:
            return 0.0
        return float(np.corrcoef(a, b)[0, 1])

    found = {name: (correlation(values, figures["rms"]), correlation(values, figures["max"])) for name, values in columns.items()}
    return dict(sorted(found.items(), key=lambda item: -max(map(abs, item[1]))))


# --- points --------------------------------------------------------------------------------------------------------------------------


def draw(uncertain: Sequence[Number], machine: Machine, controller: Controller, seed: int, n: int = SAMPLES) -> dict[str, Array]:
    """Return samples of uncertain numbers, within the bounds of their components.

    Parameters
    ----------
    uncertain : sequence of Number
    machine : Machine
        Has the correlations.
    controller : Controller
    seed : int
    n : int
        A power of two.

    Returns
    -------
    dict of str to ndarray (n,)

    Notes
    -----
    A normal distribution that reaches past a bound is cut off there. Correlations are those of the normal numbers behind it (a Gaussian
    copula), which without a bound are those of the numbers themselves.
    """
    from scipy.special import ndtr, ndtri
    from scipy.stats import qmc

    share = qmc.Sobol(len(uncertain), scramble=True, rng=np.random.default_rng([seed, len(uncertain)])).random(n)
    share = np.clip(share, 0.5**31, 1.0 - 0.5**31)
    mixed = ndtr(ndtri(share) @ _root(uncertain, machine).T)
    known = parameter_names(machine, controller)
    return {number.name: _placed(number, known[number.name], mixed[:, i]) for i, number in enumerate(uncertain)}


def _placed(number: Number, place: tuple[Component, str], share: Array) -> Array:
    """Return values of a number at shares of its distribution."""
    from scipy.special import ndtr, ndtri

    part, name = place
    parameter, origin = part.parameters[name], number.origin
    assert origin is not None  # the caller's choice
    if origin.span is not None:
        low, high = origin.span
        return low + share * (high - low)
    assert origin.deviation is not None and isinstance(number.value, float)
    least, most = (float(ndtr((bound - number.value) / origin.deviation)) for bound in (parameter.minimum, parameter.maximum))
    values: Array = number.value + origin.deviation * ndtri(least + share * (most - least))
    lowest = np.nextafter(parameter.minimum, np.inf) if parameter.exclusive else parameter.minimum
    return np.clip(values, lowest, parameter.maximum)


def _root(uncertain: Sequence[Number], machine: Machine) -> Array:
    """Return a root of the correlation matrix."""
    place = {number.name: i for i, number in enumerate(uncertain)}
    matrix = np.eye(len(uncertain))
    within = [(f"axes.{axis.name}.", *pair) for axis in machine.axes for pair in axis.correlations]
    for head, one, other, value in (*within, *(("axes.", *pair) for pair in machine.correlations)):
        i, j = (place.get(f"{head}{name}") for name in (one, other))
        if i is not None and j is not None:
            matrix[i, j] = matrix[j, i] = value
    if np.array_equal(matrix, np.eye(len(uncertain))):
        return matrix
    sizes, directions = np.linalg.eigh(matrix)
    root = directions * np.sqrt(np.maximum(sizes, 0.0))
    # Rounded coefficients may leave a size just below zero: each number keeps its own deviation.
    scaled: Array = root / np.linalg.norm(root, axis=1, keepdims=True)
    return scaled
