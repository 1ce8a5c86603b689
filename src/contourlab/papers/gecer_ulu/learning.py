"""Gecer Ulu et al., learning beyond the tables: various kappa, 200 trials, servo period 30 ms, and the delay."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain, pairwise

import numpy as np

from contourlab.analysis.learning.learning_frequency import FrequencyLearning, frequency_learning
from contourlab.analysis.linear.coupled_loop import coupled_loop
from contourlab.arrays import Array
from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.features.learn import LearningRun, learn, learning_problem
from contourlab.features.learn.trial import record_of
from contourlab.loop import Controller, Machine
from contourlab.loop.trials import Trials, feedforward_command
from contourlab.papers.gecer_ulu.setup import (
    COUNTING,
    EXPERIMENT,
    KAPPA,
    PERIOD_30MS,
    SIMULATION,
    controller_of,
    course,
    law_of,
    machine_of,
    reference_of,
    rms,
)
from contourlab.papers.gecer_ulu.tables import LONG, TRIALS
from contourlab.papers.rows import Row, ours

KAPPAS = (0.1, 0.2, KAPPA, 1.0, 3.0)
SHOWN = (0, 10, TRIALS, 60, 100, LONG)
TRIALS_OF = {SIMULATION: LONG, EXPERIMENT: LONG, COUNTING: 60, PERIOD_30MS: LONG}
SLOWER = 15.0
"""T_a at 30 ms over T_a at 1 ms; with the feed divided by this ratio, FB again has the errors of Table 2."""
STEADY = (100, 200)
"""First and last trial for measuring the growth of the side lobe."""
RATIO = "contour rms of FB CCC ILC over FB ILC, over kappa"
DELAY, SLOW = 0.015, 0.02
"""Identified delay [s], and the T_a [s] at which feedback tolerates it but learning does not."""

WHY = {
    SIMULATION: "never: only the motion has to be learned, coupling reduces the error in every trial, and the side lobes hardly grow",
    EXPERIMENT: "never: a non-repeatable force remains, and coupling reduces its effect in each trial by the higher gain across the path",
    COUNTING: (
        "once the motion is learned, only counts of 25 nm remain. With coupling the gain across the path is 1 + kappa times as high, "
        "which amplifies them more and makes the side lobes grow faster"
    ),
    PERIOD_30MS: (
        "the average is 0.69 s wide: its side lobes lie at 1.4 Hz and above, where the turn of the path has content, and coupling makes "
        "them grow faster (see the largest factor of a trial). At 1 ms they lie above 43 Hz, where the contour has no content"
    ),
}


def learning_rows() -> Iterator[Row]:
    """Yield the rows on learning."""
    return chain(_over_kappa(), _over_trials(), _at_30_ms(), _forecasts(), side_lobe_rows(), delay_rows())


def _over_kappa() -> Iterator[Row]:
    alone = rms(course(SIMULATION, 0.0, LONG), TRIALS)[2]
    for kappa in KAPPAS:
        run = course(SIMULATION, kappa, LONG if kappa == KAPPA else TRIALS)
        case = f"simulation, kappa {kappa:g}"
        x, y, contour = rms(run, 0)
        note = f"x {x:.4g}, y {y:.4g} nm; 15.42 and 110.65 in Table 2"
        yield ours("FB CCC contour rms over kappa", case, contour, "nm", note)
        coupled = rms(run, TRIALS)[2]
        note = f"{coupled:.3g} nm against {alone:.3g} nm after 30 trials; 0.286 in the paper; 1/(1 + kappa) is {1 / (1 + kappa):.3g}"
        yield ours(RATIO, case, coupled / alone, "", note)


def order_turns(alone: LearningRun, coupled: LearningRun) -> tuple[int, float] | None:
    """Return the first trial in which coupling gives the larger contour error, and the share of later trials; None if there is none."""
    worse = [b.contour_rms > a.contour_rms for a, b in zip(alone.trials, coupled.trials, strict=True)]
    if not any(worse):
        return None
    first = worse.index(True)
    return first, sum(worse[first:]) / len(worse[first:])


def _over_trials() -> Iterator[Row]:
    for setting, trials in TRIALS_OF.items():
        runs = {"FB ILC": course(setting, 0.0, trials), "FB CCC ILC": course(setting, KAPPA, trials)}
        for scheme, run in runs.items():
            for trial in SHOWN:
                if trial <= trials:
                    yield ours(f"{scheme} contour rms over trials", f"{setting}, trial {trial}", rms(run, trial)[2], "nm")
        turn = order_turns(*runs.values())
        first, part = (math.nan, math.nan) if turn is None else turn
        case = f"{setting}, {trials} trials"
        yield ours("first trial in which FB CCC ILC is worse than FB ILC", case, first, "", WHY[setting])
        if turn is not None:
            yield ours("part of the trials since then in which it is", case, part, "")


def _at_30_ms() -> Iterator[Row]:
    """At 30 ms: the contour error after learning, at the same feed and at the feed with the same FB error."""
    for slower, words in ((1.0, "feed as at 1 ms"), (SLOWER, f"feed {SLOWER:g} times slower")):
        trials = LONG if slower == 1.0 else TRIALS
        for scheme, kappa in (("FB", 0.0), ("FB CCC", KAPPA)):
            run = course(PERIOD_30MS, kappa, trials, slower=slower)
            for trial, name in ((0, scheme), (TRIALS, f"{scheme} ILC")):
                x, y, contour = rms(run, trial)
                note = f"x {x:.4g}, y {y:.4g} nm; T_a 150 ms, delay 15 ms, noise-free"
                yield ours(f"{name} contour rms at 30 ms", words, contour, "nm", note)
            note = "Table 2: 10.6 without and 41.5 with coupling"
            gain = rms(run, 0)[2] / rms(run, TRIALS)[2]
            yield ours("contour rms over that after 30 trials, at 30 ms", f"{scheme}, {words}", gain, "", note)


def forecast(machine: Machine, controller: Controller) -> FrequencyLearning:
    """Return the factor per trial of eq (9) at each frequency, with gamma = 0.2 and M = 11."""
    return frequency_learning(coupled_loop(machine, controller), law_of(SIMULATION))


def _forecasts() -> Iterator[Row]:
    """Yield the largest |1 - gamma H T|, or with coupling the spectral radius, of the settings."""
    settings = [(SIMULATION, kappa) for kappa in (0.0, *KAPPAS)] + [(PERIOD_30MS, kappa) for kappa in (0.0, KAPPA)]
    for setting, kappa in settings:
        w, factor = forecast(machine_of(setting), controller_of(setting, kappa)).worst_radius
        note = f"at {w / (2.0 * math.pi):.3g} Hz, beyond the first zero of H: {factor**TRIALS:.2g} in 30 trials, {factor**LONG:.2g} in 200"
        yield ours("largest factor of a trial", f"{setting}, kappa {kappa:g}", factor, "", note)


def side_lobe_rows() -> Iterator[Row]:
    """Yield the growth of the side lobe at the worst frequency, long after the rest is learned."""
    low, high = STEADY
    w, factor = forecast(machine_of(PERIOD_30MS), controller_of(PERIOD_30MS, 0.0)).worst_radius
    before, after = (_amplitude(error, w) for error in _errors(STEADY))
    grown = (after / before) ** (1.0 / (high - low))
    note = f"predicted {factor:.5f}; from the amplitude of x at {w / (2.0 * math.pi):.3g} Hz"
    yield ours("growth in a trial, measured", f"{PERIOD_30MS}, FB ILC, trials {low} to {high}", grown, "", note)


def _errors(wanted: tuple[int, ...]) -> list[Array]:
    """Return the tracking error of x (n_sample,) [m] in some trials of FB ILC at 30 ms."""
    machine, controller, reference = machine_of(PERIOD_30MS), controller_of(PERIOD_30MS, 0.0), reference_of(PERIOD_30MS)
    law, runner = law_of(PERIOD_30MS), Trials(machine, controller, reference)
    problem = learning_problem(machine, controller, reference, law.target, runner.arc_length)
    beforehand = feedforward_command(machine, controller, reference)
    table, errors = np.zeros_like(beforehand), []
    for trial in range(wanted[-1] + 1):
        record = record_of(runner.run(table, trial), runner, table, beforehand)
        if trial in wanted:
            errors.append(record.tracking_error[:, 0].copy())
        table = law.update(table, record, problem)
    return errors


def _amplitude(signal: Array, frequency: float) -> float:
    """Return the amplitude of a signal (n,) at a frequency [rad/s], windowed because a trial is not periodic."""
    time = np.arange(len(signal)) * machine_of(PERIOD_30MS).servo_period
    return float(abs(np.sum(np.hanning(len(signal)) * signal * np.exp(-1j * frequency * time))))


def delay_rows() -> Iterator[Row]:
    """Yield rows for 1 ms, M = 11 and delay 15 ms: at T_a = 10 ms feedback is unstable, at 20 ms learning diverges."""
    for time_constant in (0.01, SLOW):
        machine, controller = _late(time_constant)
        loop = coupled_loop(machine, controller)
        largest = max(float(abs(axis.loop.poles).max()) for axis in loop.axes)
        case = f"1 ms, delay 15 ms, T_a {1e3 * time_constant:g} ms"
        yield ours("largest pole of feedback alone", case, largest, "", "unstable: above 1" if largest > 1.0 else "stable")
    w, factor = forecast(machine, controller).worst_radius
    note = f"at {w / (2.0 * math.pi):.3g} Hz, where T has the opposite sign: eq (9) acts in the wrong direction"
    yield ours("largest factor of a trial", case, factor, "", note)
    run = learn(machine, controller, reference_of(SIMULATION), law_of(SIMULATION), trials=TRIALS, part="none")
    merits = [trial.contour_rms for trial in run.trials]
    steepest = max(b / a for a, b in pairwise(merits))
    yield ours("best trial before it diverges", case, float(run.best), "", f"{run.status}: {run.reason}")
    yield ours("largest growth of contour rms in a trial", case, steepest, "", f"{1e9 * merits[run.best]:.3g} nm at best")


def _late(time_constant: float) -> tuple[Machine, Controller]:
    """Return machine and feedback at 1 ms with the identified delay and an encoder of 25 nm."""
    machine, controller = machine_of(COUNTING), controller_of(COUNTING, 0.0)
    late = tuple(replace(axis, drive=DelayedSaturation(delay=DELAY)) for axis in machine.axes)
    axes = {name: replace(part, controller=part.controller.replace(time_constant=time_constant)) for name, part in controller.axes.items()}
    return replace(machine, axes=late), replace(controller, axes=axes)
