"""Convergence and divergence of learning, compared with predictions from the frequency response of the loop."""

from __future__ import annotations

import time
import tracemalloc
from itertools import pairwise

import numpy as np
import pytest
from learning_stages import PERIOD, TIME_CONSTANT, control, eased, make, proportional, rough, stage, there_and_rest
from numpy.typing import NDArray

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.features.learn import Stopping, learn, learning_problem
from contourlab.features.learn.trial import record_of
from contourlab.geometry import Line, Path
from contourlab.loop.trials import Trials, feedforward_command

Array = NDArray[np.float64]
ON = Stopping(improvement=0.0)
LONG = Stopping(improvement=0.0, growth=10**6, divergence=100.0)
FAR = Stopping(improvement=0.0, growth=10**6, divergence=1e4)
"""Continue until the growing part dominates."""


def errors_of(machine: cl.Machine, controller: cl.Controller, reference: cl.Reference, law: object, trials: int) -> list[Array]:
    """Return the tracking error of the first axis in each trial, without stopping."""
    runner = Trials(machine, controller, reference, target=law.target)  # type: ignore[attr-defined]
    problem = learning_problem(machine, controller, reference, law.target, runner.arc_length)  # type: ignore[attr-defined]
    beforehand = feedforward_command(machine, controller, reference)
    table, found = np.zeros((reference.n_sample, reference.n_axis)), []
    for i in range(trials):
        record = record_of(runner.run(table, i), runner, table, beforehand)
        found.append(record.tracking_error[:, 0])
        table = law.update(table, record, problem)  # type: ignore[attr-defined]
    return found


def plant_response(machine: cl.Machine, controller: cl.Controller, w: Array) -> NDArray[np.complex128]:
    """Return G, position over the command added by learning, from the loop gain: P/(1 + P C) = T/C for a proportional controller C."""
    axis = machine.axes[0]
    response = sampled_loop(axis, controller.axes[axis.name], machine.servo_period).response(w)
    gain = controller.axes[axis.name].controller.position_gain  # type: ignore[attr-defined]
    return np.asarray(response.closed_loop / gain)


@pytest.mark.parametrize("delay", [0.0, 15e-3])
def test_p_type_multiplies_the_error_by_q_times_one_less_l_g(delay: float) -> None:
    """Within 2 % at five frequencies, for the increments: the error itself has a limit that Q leaves."""
    drive = {"drive": make("drive", "delayed-saturation", delay=delay)} if delay else {}
    machine, controller, reference = stage(1, **drive), proportional(1), rough()
    gain, bandwidth = 100.0, 2.0 * np.pi * 2.5
    law = make("learning", "p-type", gain=gain, bandwidth=bandwidth, order=2)
    errors = errors_of(machine, controller, reference, law, 4)
    spectra = [np.fft.rfft(b - a) for a, b in pairwise(errors)]
    hertz = np.fft.rfftfreq(reference.n_sample, PERIOD)
    for f in (0.5, 1.0, 1.75, 2.5, 4.0):
        k = int(np.argmin(np.abs(hertz - f)))
        near = slice(k - 2, k + 3)  # neighbours share a frequency that falls between two bins
        measured = np.linalg.norm(spectra[1][near]) / np.linalg.norm(spectra[0][near])
        w = 2.0 * np.pi * hertz[near]
        q = 1.0 / (1.0 + (np.tan(w * PERIOD / 2.0) / np.tan(bandwidth * PERIOD / 2.0)) ** 4)
        factor = q * np.abs(1.0 - gain * plant_response(machine, controller, w))
        predicted = np.linalg.norm(factor * spectra[0][near]) / np.linalg.norm(spectra[0][near])
        assert measured == pytest.approx(predicted, rel=0.02)


def test_p_type_without_q_diverges_as_predicted_and_is_rolled_back() -> None:
    machine, controller, reference = stage(1), proportional(1), rough()
    gain = 300.0
    w = 2.0 * np.pi * np.linspace(0.2, 100.0, 4000)
    factor = np.abs(1.0 - gain * plant_response(machine, controller, w))
    passes_one = w[np.argmax(factor > 1.0)] / (2.0 * np.pi)
    run = learn(machine, controller, reference, make("learning", "p-type", gain=gain), trials=400, stopping=FAR)
    assert run.diverged
    assert run.status.endswith(f" {run.best}")
    assert run.growth is not None
    assert run.growth.low > 0.9 * passes_one
    # The factor is flat around its maximum, so frequencies with more initial error dominate a little longer.
    at_peak = float(np.interp(2.0 * np.pi * run.growth.peak, w, factor))
    assert at_peak > 1.0 + 0.8 * (factor.max() - 1.0)
    assert run.growth.factor == pytest.approx(at_peak, rel=0.01)
    assert run.findings[-1].code == "CL309"
    assert run.findings[-1].values["peak"] == run.growth.peak
    assert run.findings[-1].values["growth"] == run.growth.factor - 1.0
    merits = [trial.merit for trial in run.trials]
    assert run.trials[run.best].merit == min(merits)
    # The returned table reproduces the best trial.
    again = learn(machine, controller, reference, make("learning", "p-type", gain=gain), trials=0, start=run.table)
    assert again.trials[0].merit == run.trials[run.best].merit
    # With Q below that frequency it converges.
    quiet = make("learning", "p-type", gain=gain, bandwidth=2.0 * np.pi * 0.3 * passes_one)
    assert not learn(machine, controller, reference, quiet, trials=60, stopping=ON).diverged


@pytest.mark.slow
def test_the_average_of_the_paper_amplifies_its_side_lobe() -> None:
    """M = 11 at 30 ms, gamma = 0.2, T = 1/(1 + 0.1 s): |1 - gamma H T| is 1.017 at 2 Hz, and a long run grows by this factor there."""
    period = 0.03
    w = 2.0 * np.pi * np.linspace(0.05, 16.0, 20000)
    average = np.sin(23.0 * w * period / 2.0) / (23.0 * np.sin(w * period / 2.0))
    ideal = np.abs(1.0 - 0.2 * average / (1.0 + 0.1j * w))
    assert ideal.max() == pytest.approx(1.017, abs=5e-4)
    assert w[ideal.argmax()] / (2.0 * np.pi) == pytest.approx(2.0, abs=0.05)

    machine, controller = stage(1, period), proportional(1)
    reference = rough(period, seconds=300.0, rest=15.0, top=8.0)
    closed = controller.axes["x"].controller.position_gain * plant_response(machine, controller, w)  # type: ignore[attr-defined]
    factor = np.abs(1.0 - 0.2 * average * closed)
    once = learn(machine, controller, reference, make("learning", "zero-phase", gain=0.2, half_width=11), trials=400, stopping=ON)
    assert once.diverged
    assert once.growth is not None
    assert once.growth.factor == pytest.approx(factor.max(), abs=2e-3)
    assert once.growth.peak == pytest.approx(w[factor.argmax()] / (2.0 * np.pi), rel=0.1)
    # The repeated average is never negative: learning does not diverge in as many trials.
    twice = make("learning", "zero-phase", gain=0.2, half_width=11, passes=2)
    assert not learn(machine, controller, reference, twice, trials=len(once.trials), stopping=ON).diverged


@pytest.mark.slow
def test_with_its_delay_at_one_millisecond_the_average_of_the_paper_diverges() -> None:
    """Brief figures for T_s = 1 ms, T_a = 0.1 s, delay 15 ms: 1.025 at 9.3 Hz, by first-order T."""
    w = 2.0 * np.pi * np.linspace(0.1, 100.0, 50000)
    average = np.sin(23.0 * w * PERIOD / 2.0) / (23.0 * np.sin(w * PERIOD / 2.0))
    closed = 1.0 / (1.0 + 0.1j * w * np.exp(15e-3j * w))
    factor = np.abs(1.0 - 0.2 * average * closed)
    assert factor.max() == pytest.approx(1.025, abs=1.5e-3)
    assert w[factor.argmax()] / (2.0 * np.pi) == pytest.approx(9.3, abs=0.3)
    machine = stage(1, drive=make("drive", "delayed-saturation", delay=15e-3))
    needed = 0
    for parameters, diverges in (({}, True), ({"passes": 2}, True), ({"lead": 30e-3, "half_width": 40, "passes": 2}, False)):
        law = make("learning", "zero-phase", gain=0.2, **{"half_width": 11, **parameters})
        run = learn(machine, control(1), rough(), law, trials=400 if diverges else needed, stopping=LONG if diverges else ON)
        assert run.diverged == diverges
        if diverges:
            assert run.growth is not None
            assert 5.0 < run.growth.peak < 15.0
            needed = max(needed, len(run.trials))


@pytest.mark.parametrize("coupled", [0.0, 1.0])
def test_learning_reduces_the_contour_error_of_the_paper_eightfold(coupled: float) -> None:
    reference = eased()
    law = make("learning", "zero-phase", gain=0.2, half_width=11)
    run = learn(stage(2), control(2, TIME_CONSTANT, coupled), reference, law, trials=30, stopping=ON)
    bare = learn(stage(2), control(2), reference, law, trials=0)
    assert run.trials[30].contour_rms < bare.trials[0].contour_rms / 8.0
    assert "CL300" in {one.code for one in run.findings}


@pytest.mark.slow
def test_every_law_learns() -> None:
    """Each law, with sensible settings, removes most of the error within 25 trials."""
    stiffness = 1.0 / (0.05 * TIME_CONSTANT)
    laws = (
        ("zero-phase", {"gain": 0.4, "half_width": 11, "passes": 2}, ("command", "reference")),
        ("p-type", {"gain": 0.4 * stiffness, "bandwidth": 20.0, "lead": 60e-3, "stiffness": stiffness}, ("command", "reference")),
        (
            "pd-type",
            {"gain": 0.4 * stiffness, "derivative_gain": 0.03 * stiffness, "bandwidth": 40.0, "stiffness": stiffness},
            ("command",),
        ),
        ("plant-inversion", {"gain": 0.8, "bandwidth": 60.0}, ("command",)),
        ("norm-optimal", {"contour_weight": 2.0, "change_weight": 1e-3}, ("command", "reference")),
        (
            "cross-coupled",
            {"gain": 0.3 * stiffness, "contour_gain": 0.3 * stiffness, "bandwidth": 20.0, "lead": 60e-3, "stiffness": stiffness},
            ("command",),
        ),
    )
    reference = eased(4.0)
    for kind, numbers, targets in laws:
        for target in targets:
            run = learn(stage(2), control(2), reference, make("learning", kind, target=target, **numbers), trials=25, stopping=ON)
            assert not run.diverged, (kind, target, run.reason)
            assert run.trials[-1].tracking < 0.15 * run.trials[0].tracking, (kind, target)
            assert run.gain > 4.0, (kind, target)


@pytest.mark.slow
def test_norm_optimal_on_thirty_thousand_samples_needs_no_matrix() -> None:
    """A matrix of 60 000 by 60 000 would take 29 GB; every trial improves."""
    reference = eased(28.0)
    assert reference.n_sample == 30000
    law = make("learning", "norm-optimal", contour_weight=2.0, change_weight=1e-2)
    trials = Trials(stage(2), control(2), reference)
    problem = learning_problem(stage(2), control(2), reference, "command", trials.arc_length)
    table = np.zeros((30000, 2))
    record = record_of(trials.run(table, 0), trials, table, table)
    law.update(table, record, problem)
    tracemalloc.start()
    began = time.process_time()
    law.update(table, record, problem)
    took, (_, peak) = time.process_time() - began, tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 40e6
    assert took < 3.0
    run = learn(stage(2), control(2), reference, law, trials=8, stopping=ON)
    errors = [np.hypot(trial.tracking, np.sqrt(2.0) * trial.contour_rms) for trial in run.trials]
    assert all(b < a for a, b in pairwise(errors))
    assert errors[-1] < 0.02 * errors[0]


def test_with_a_low_q_a_wrong_model_still_converges() -> None:
    """The model's delay is 15 ms too short: the inverse diverges above the frequency where this is 60 degrees; with Q below, it learns."""
    machine = stage(1, drive=make("drive", "delayed-saturation", delay=15e-3))
    believed = learning_problem(stage(1), control(1), rough(), "command", np.zeros(rough().n_sample))
    reference, nothing = rough(), np.zeros((rough().n_sample, 1))

    def course(bandwidth: float) -> list[float]:
        law, table, sizes = make("learning", "plant-inversion", bandwidth=bandwidth), nothing, []
        trials = Trials(machine, control(1), reference)
        for i in range(12):
            record = record_of(trials.run(table, i), trials, table, nothing)
            sizes.append(float(np.sqrt(np.mean(record.tracking_error**2))))
            table = law.update(table, record, believed)
        return sizes

    steady, astray = course(2.0 * np.pi * 2.0), course(2.0 * np.pi * 30.0)
    assert steady[-1] == pytest.approx(steady[-2], rel=1e-6)
    assert steady[-1] < 0.7 * steady[0]
    assert all(b > 1.1 * a for a, b in pairwise(astray[2:]))


@pytest.mark.slow
def test_a_drive_at_its_limit_does_not_wind_the_table_up() -> None:
    """The move needs 1.3 times the drive's limit: over a hundred trials the table stays within the drive's range."""
    reference = there_and_rest(move=1.0)
    free = learn(stage(1), control(1), reference, make("learning", "zero-phase"), trials=60, stopping=ON)
    limit = free.trials[-1].command_peak[0] / 1.3
    machine = stage(1, drive=make("drive", "saturation", limit=limit))
    go_on = Stopping(improvement=0.0, growth=10**6, divergence=1e9)
    for kind, numbers in (("zero-phase", {"gain": 0.4}), ("plant-inversion", {"bandwidth": 30.0, "gain": 0.5})):
        run = learn(machine, control(1), reference, make("learning", kind, **numbers), trials=120, stopping=go_on)
        assert np.abs(run.table.values).max() < 2.0 * limit, kind


@pytest.mark.slow
def test_the_cost_grows_no_faster_than_axes_and_samples() -> None:
    """Processor time of a trial, the minimum of three: five axes against two, and four times the samples."""

    def cost(n_axis: int, seconds: float) -> float:
        t = np.arange(0.0, seconds, PERIOD) / seconds
        s = t**4 * (35.0 - 84.0 * t + 70.0 * t**2 - 20.0 * t**3)
        line = np.array([0.2 / (j + 1.0) for j in range(n_axis)])
        path = Path([Line((0.0,) * n_axis, tuple(line.tolist()))])
        reference = cl.Reference.from_samples(s[:, None] * line, PERIOD, path)
        found = []
        for _ in range(4):
            began = time.process_time()
            learn(stage(n_axis), control(n_axis), reference, make("learning", "zero-phase"), trials=9, stopping=ON)
            found.append(time.process_time() - began)
        return min(found[1:])

    base = cost(2, 15.0)
    assert cost(5, 15.0) < 1.3 * 2.5 * base
    assert cost(2, 60.0) < 1.3 * 4.0 * base
