"""How far the figures can be trusted: the sources of all numbers, and the interval of part error that their stated deviations imply.

For the interval 64 machines are drawn from the deviations, run in lanes and judged there. The points are a scrambled Sobol sequence that
depends on the seed only: the figures are the same for any number of threads.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from contourlab.arrays import Array, Flags
from contourlab.components.contract import Component
from contourlab.errors import ContourlabError
from contourlab.findings import Finding, finding
from contourlab.loop import Controller, Learned, Machine, parameters_of
from contourlab.loop.simulate import ToolPosition
from contourlab.rendering.judgement import Cause, Interval, Number, Rank, Spread
from contourlab.rendering.origins import numbers_of
from contourlab.study import Setting
from contourlab.study.space import Distribution

SAMPLES = 64
"""Machines that are drawn: two groups of 32 lanes."""
NOTABLE = 0.02
"""Causes of a smaller share are not mentioned."""
LEVELS = (0.05, 0.95)
"""Shares of the samples below the ends of an interval."""


_RESTS_ON = {
    "friction": {"reversal", "breakaway", "friction"},
    "motor_friction": {"reversal", "breakaway", "friction"},
    "plant": {"lag", "compliance", "servo mismatch"},
    "sensor": {"quantisation"},
    "motor_sensor": {"quantisation"},
    "drive": {"saturation"},
    "disturbance": {"disturbance"},
    "plant.backlash_gap": {"backlash"},
    "error.backlash": {"backlash"},
    "error.lead_error": {"geometry"},
    "error.repeatability": {"geometry"},
    r"limits\.(acceleration|jerk)": {"lag", "compliance", "servo mismatch", "saturation"},
}
"""Slots of an axis, or single numbers, and the causes of the error that depend on their numbers; limits of velocity bound rapid moves."""


def about_guesses(causes: Sequence[Cause], numbers: Sequence[Number], off: Mapping[str, float]) -> list[Finding]:
    """Return a finding on the share of the error at the worst place that depends on guessed numbers, if any does.

    `off` is the error there by axis [m]: an axis across which the error is does not make it.
    """
    acting = {axis for axis, part in off.items() if abs(part) >= math.sqrt(NOTABLE) * math.hypot(*off.values())}
    axes, guesses, resting = set[str](), dict[str, set[str]](), set[str]()
    for slot, names in _RESTS_ON.items():
        of_slot = [number for number in numbers if re.match(rf"axes\.\w+\.{slot}(\.|$)", number.name)]
        axes |= {number.name.split(".")[1] for number in of_slot}
        guessed = [number.name.split(".", 2)[1:] for number in of_slot if number.source == "assumed"]
        if any(axis in acting for axis, _ in guessed) and sum(cause.share for cause in causes if cause.name in names) >= NOTABLE:
            resting |= names
            for axis, name in guessed:
                guesses.setdefault(name, set()).add(axis)
    told = [f"axes.{axis}.{name}" for name, of in guesses.items() for axis in (["*"] if of == axes else sorted(of & acting))]
    share = sum(cause.share for cause in causes if cause.name in resting)
    return [finding("CL229", share=share, numbers=told)] if told else []


def part_interval(
    setting: Setting,
    *,
    tolerance: float | None = None,
    changes: Sequence[object] = (),
    learned: Learned | None = None,
    threads: int | None = None,
    n: int = SAMPLES,
    progress: Callable[[int, int], None] | None = None,
) -> Interval:
    """Return the interval of the part error that the stated deviations imply.

    Parameters
    ----------
    setting : Setting
        What is run. All samples see its noise, and the points depend on its seed.
    tolerance : float [m], optional
        Limit for the largest part error.
    changes : sequence
        Controllers that take over during the run; lanes cannot run them.
    learned : Learned, optional
        What the nominal machine has learned, fed to each sample.
    threads : int, optional
    n : int
        Samples, a power of two.
    progress : callable, optional
        Called with samples done and samples in all.

    Returns
    -------
    Interval
        Without samples, and with a finding, where there is no interval.

    Notes
    -----
    The part error is that of the true axis positions, without the machine's error map.
    """
    machine, controller = setting.machine, setting.controller
    simulated = [number for number in numbers_of(machine, controller) if number.simulated]
    uncertain = [number for number in simulated if number.drawn]
    if not uncertain:
        exact = all(number.source == "design" for number in simulated)
        return Interval(findings=(finding("CL221") if exact else finding("CL220"),))
    if changes:
        return Interval(findings=(finding("CL222"),))
    columns = draw(uncertain, machine, controller, setting.seed, n)

    report = None if progress is None else lambda done: progress(done, setting.reference.n_sample)
    try:
        batch = setting.batch(columns, ["part_error_max"], progress=report, threads=threads, learned=learned)
    except ContourlabError as error:
        return Interval(findings=(finding("CL224", reason=str(error)),))
    figures = {name: batch.figures[f"part_error_{name}"] for name in ("rms", "max")}
    bad = ~np.isfinite(figures["max"])
    failed = int(bad.sum())
    beyond = None if tolerance is None else int(np.count_nonzero(bad | (figures["max"] > tolerance)))
    rms, largest = _spread(figures["rms"]), _spread(figures["max"])
    ranks = _ranks(columns, figures, ~bad)
    chance = noticeable(len(ranks), n - failed)
    main = main_contributor(ranks, chance)
    findings = [finding("CL225", rms_low=rms.low, rms_high=rms.high, max_low=largest.low, max_high=largest.high, samples=n)]
    findings += [finding("CL226", failed=failed, samples=n)] if failed else []
    findings += [] if ToolPosition(machine, setting.seed).exact else [finding("CL230")]
    findings += [finding("CL227", beyond=beyond, samples=n)] if beyond else []
    findings += [finding("CL228", number=main)] if main else []
    return Interval(n, rms, largest, failed, beyond, ranks, chance, main, tuple(findings), columns, figures)


def noticeable(numbers: int, samples: int) -> float:
    """Return the smallest rank correlation that is significant at 5 % when so many numbers are tested (Bonferroni).

    The correlations of a number with rms and with maximum count as one test, as they go together.
    """
    from scipy.stats import t

    left = max(samples - 2, 1)
    quantile = float(t.ppf(1.0 - 0.025 / max(numbers, 1), left))
    return quantile / float(np.hypot(quantile, np.sqrt(left)))


def main_contributor(ranks: Sequence[Rank], chance: float) -> str:
    """Return the name of the first number if its rank correlation is significant; else an empty string."""
    return ranks[0].name if ranks and max(abs(ranks[0].rms), abs(ranks[0].max)) >= chance else ""


def _spread(values: Array) -> Spread:
    """Return median and ends; a failed sample counts as infinite."""
    with np.errstate(invalid="ignore"):
        levels = np.quantile(np.where(np.isfinite(values), values, np.inf), (0.5, *LEVELS))
    return Spread(*np.where(np.isnan(levels), np.inf, levels).tolist())


def _ranks(columns: Mapping[str, Array], figures: Mapping[str, Array], kept: Flags) -> tuple[Rank, ...]:
    from scipy.stats import rankdata

    def correlation(*pair: Array) -> float:
        a, b = (rankdata(values[kept]) for values in pair)
        if a.size < 3 or np.ptp(a) == 0.0 or np.ptp(b) == 0.0:
            return 0.0
        return float(np.corrcoef(a, b)[0, 1])

    ranks = [Rank(name, correlation(values, figures["rms"]), correlation(values, figures["max"])) for name, values in columns.items()]
    return tuple(sorted(ranks, key=lambda rank: -max(abs(rank.rms), abs(rank.max))))


def draw(uncertain: Sequence[Number], machine: Machine, controller: Controller, seed: int, n: int = SAMPLES) -> dict[str, Array]:
    """Return `n` samples (a power of two) of uncertain numbers, within the bounds of their components.

    Notes
    -----
    A normal distribution is cut off at a bound. The machine's correlations are those of the normal numbers behind it (a Gaussian copula);
    without a bound these are the correlations of the numbers themselves.
    """
    from scipy.special import ndtr, ndtri
    from scipy.stats import qmc

    share = qmc.Sobol(len(uncertain), scramble=True, rng=np.random.default_rng([seed, len(uncertain)])).random(n)
    share = np.clip(share, 0.5**31, 1.0 - 0.5**31)
    mixed = ndtr(ndtri(share) @ _root(uncertain, machine).T)
    known = parameters_of(machine, controller)
    return {number.name: _distribution(number, *known[number.name]).values(mixed[:, i]) for i, number in enumerate(uncertain)}


def _distribution(number: Number, part: Component, name: str) -> Distribution:
    """Return the distribution of a number."""
    parameter = part.parameters[name]
    if number.range is not None:
        return Distribution("uniform", number.range)
    assert number.deviation is not None and isinstance(number.value, float)
    lowest = np.nextafter(parameter.minimum, np.inf) if parameter.exclusive else parameter.minimum
    return Distribution("normal", (number.value, number.deviation), lowest, parameter.maximum)


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
    # Rounded coefficients may leave an eigenvalue just below zero; each number keeps its own deviation.
    scaled: Array = root / np.linalg.norm(root, axis=1, keepdims=True)
    return scaled
