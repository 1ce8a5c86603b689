"""Gecer Ulu et al., learning beyond the tables: various kappa, 200 trials, and the forecast of convergence."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import chain

from contourlab.analysis.learning.factors import FrequencyLearning, frequency_learning
from contourlab.analysis.linear.coupled_loop import coupled_loop
from contourlab.loop import Controller, Machine
from contourlab.papers.gecer_ulu.setup import COUNTING, EXPERIMENT, KAPPA, SIMULATION, TRIALS, controller_of, course, law_of, machine_of
from contourlab.papers.gecer_ulu.tables import LONG
from contourlab.papers.rows import Row, ours

KAPPAS = (0.3, 1.0, KAPPA, 3.0)
SHOWN = (0, 10, TRIALS, 60, 100, LONG)
RATIO = "contour rms of FB CCC ILC over FB ILC, over kappa"


def learning_rows() -> Iterator[Row]:
    """Yield the rows on learning."""
    return chain(_over_kappa(), _over_trials(), _forecasts())


def _over_kappa() -> Iterator[Row]:
    alone = course(SIMULATION, 0.0, LONG).rms(TRIALS)[2]
    for kappa in KAPPAS:
        run = course(SIMULATION, kappa, LONG if kappa == KAPPA else TRIALS)
        case = f"simulation, kappa {kappa:g}"
        x, y, contour = run.rms(0)
        yield ours("FB CCC contour rms over kappa", case, contour, "nm", f"x {x:.4g}, y {y:.4g} nm; 15.42 and 110.65 in Table 2")
        coupled = run.rms(TRIALS)[2]
        note = f"{coupled:.3g} nm against {alone:.3g} nm after 30 trials; 0.286 in the paper; 1/(1 + kappa) is {1 / (1 + kappa):.3g}"
        yield ours(RATIO, case, coupled / alone, "", note)


def order_turns(alone: list[float], coupled: list[float]) -> tuple[int, float] | None:
    """Return the first trial in which coupling gives the larger contour error, and the share of later trials; None if there is none."""
    worse = [b > a for a, b in zip(alone, coupled, strict=True)]
    if not any(worse):
        return None
    first = worse.index(True)
    return first, sum(worse[first:]) / len(worse[first:])


def _over_trials() -> Iterator[Row]:
    for setting in (SIMULATION, EXPERIMENT, COUNTING):
        runs = {"FB ILC": course(setting, 0.0, LONG), "FB CCC ILC": course(setting, KAPPA, LONG)}
        for scheme, run in runs.items():
            for trial in SHOWN:
                yield ours(f"{scheme} contour rms over trials", f"{setting}, trial {trial}", run.rms(trial)[2], "nm")
        turn = order_turns(*([run.true_rms(trial) for trial in range(LONG + 1)] for run in runs.values()))
        first, part = (math.nan, math.nan) if turn is None else turn
        case = f"{setting}, {LONG} trials"
        yield ours("first trial in which FB CCC ILC is worse than FB ILC", case, first, "", "by the true contour error")
        if turn is not None:
            yield ours("part of the trials since then in which it is", case, part, "")


def forecast(machine: Machine, controller: Controller) -> FrequencyLearning:
    """Return the factor per trial of eq (9) at each frequency, with gamma = 0.2 and M = 11."""
    return frequency_learning(coupled_loop(machine, controller), law_of(SIMULATION))


def _forecasts() -> Iterator[Row]:
    """Yield the largest |1 - gamma H T|, or with coupling the spectral radius."""
    for kappa in (0.0, *KAPPAS):
        w, factor = forecast(machine_of(SIMULATION), controller_of(SIMULATION, kappa)).worst_radius
        note = f"at {w / (2.0 * math.pi):.3g} Hz: {factor**TRIALS:.2g} in 30 trials, {factor**LONG:.2g} in 200"
        yield ours("largest factor of a trial", f"simulation, kappa {kappa:g}", factor, "", note)
