"""Predictions for learning: published figures, the trial itself as oracle, and words."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable

import numpy as np
import pytest
from coupled_axes import circle, stages, unlike
from numpy.typing import NDArray

from contourlab.analysis.learning.factors import averaging, frequency_learning, law_kernels
from contourlab.analysis.learning.learning_analysis import (
    LiftedLearning,
    TrialOperator,
    design_zero_phase,
    first_zero,
    largest_gain,
    learning_analysis,
    lifted_learning,
    quarter_turn,
    worst_zero_phase,
)
from contourlab.analysis.linear.coupled_loop import coupled_loop
from contourlab.components.coupling.laws import CrossCoupled
from contourlab.components.learning.law import CrossCoupledLearning, LearningLaw, NormOptimal, PlantInversion, PType, TrialRecord, ZeroPhase
from contourlab.errors import ComponentError
from contourlab.feed import uniform
from contourlab.geometry import contour

TURN = 2.0 * math.pi
Closed = Callable[[NDArray[np.float64]], NDArray[np.complex128]]


def integrating(t_a: float, delay: float = 0.0) -> Closed:
    """T of the loop gain exp(-s tau)/(T_a s)."""

    def closed(w: NDArray[np.float64]) -> NDArray[np.complex128]:
        gain = np.exp(-1j * w * delay) / (1j * w * t_a)
        return np.asarray(gain / (1.0 + gain))

    return closed


def held(t_a: float, period: float) -> Closed:
    """The same without delay, sampled with a hold: (1 - a)/(z - a), a = exp(-T_s/T_a)."""
    a = math.exp(-period / t_a)
    return lambda w: np.asarray((1.0 - a) / (np.exp(1j * w * period) - a))


@pytest.mark.parametrize(
    ("closed", "period", "passes", "factor", "hertz"),
    [
        (held(0.1, 0.03), 0.03, 1, 1.013, None),
        (held(0.06, 0.03), 0.03, 1, 1.023, None),
        (held(5e-3, 1e-3), 1e-3, 1, 1.007, None),
        (integrating(0.1, 15e-3), 1e-3, 1, 1.025, 9.3),
        (integrating(0.1, 15e-3), 1e-3, 2, 1.023, None),
        (integrating(0.01, 15e-3), 1e-3, 1, 4.84, None),
        (integrating(0.1), 0.03, 1, 1.017, 2.0),
    ],
)
def test_an_average_over_23_samples_amplifies_as_published(
    closed: Closed, period: float, passes: int, factor: float, hertz: float | None
) -> None:
    at, found = worst_zero_phase(closed, period, 0.2, 11, passes)
    assert found == pytest.approx(factor, abs=5e-4 if factor < 2.0 else 5e-3)
    if hertz is not None:
        assert at / TURN == pytest.approx(hertz, abs=0.06)


@pytest.mark.parametrize(("t_a", "hertz"), [(0.1, 3.5), (0.01, 10.0)])
def test_p_type_learning_at_half_the_integral_gain_exceeds_one_where_published(t_a: float, hertz: float) -> None:
    w = TURN * np.linspace(0.5, 30.0, 30000)
    s = 1j * w
    plant = 150.0**2 / (s * (s * s + 330.0 * s + 150.0**2))
    factor = np.abs(1.0 - 0.5 / t_a * plant / (1.0 + 1.0 / (s * t_a)))
    assert w[np.argmax(factor > 1.0)] / TURN == pytest.approx(hertz, abs=0.06)
    machine, controller = stages(t_a, 0.0)
    response = frequency_learning(coupled_loop(machine, controller), PType(gain=0.5 / t_a))
    # The real loop also has the velocity and the hold of a servo period.
    assert response.frequency[np.argmax(response.radius > 1.0 + 1e-9)] / TURN == pytest.approx(hertz, rel=0.06)


@pytest.mark.parametrize("period", [1e-3, 0.03])
def test_the_average_equals_its_defining_sum(period: float) -> None:
    w = np.linspace(0.0, math.pi / period, 57)
    k = np.arange(-7, 8)
    wanted = np.exp(1j * np.outer(w, k * period)).mean(axis=1)
    np.testing.assert_allclose(averaging(w, period, 7), wanted, atol=1e-13)
    np.testing.assert_allclose(averaging(w, period, 7, 2, 3 * period), wanted**2 * np.exp(3j * w * period), atol=1e-13)


def test_the_rules_for_a_delayed_loop() -> None:
    w = quarter_turn(integrating(0.1, 15e-3), 1e-3)
    closed = integrating(0.1, 15e-3)(np.array([w]))[0]
    assert math.degrees(np.angle(closed)) == pytest.approx(-90.0, abs=1e-6)
    assert first_zero(11, 1e-3) == pytest.approx(TURN * 1000.0 / 23.0)
    # One real number: |1 - gamma| < 1 up to gamma = 2.
    assert largest_gain(lambda x: np.ones(x.size, dtype=complex), lambda x: np.ones(x.size, dtype=complex), 100.0) == pytest.approx(2.0)
    for t_a, delay, period in ((0.1, 15e-3, 1e-3), (0.06, 15e-3, 1e-3), (0.01, 0.0, 1e-3), (0.15, 15e-3, 0.03)):
        made = design_zero_phase(integrating(t_a, delay), period)
        assert made.worst_factor <= 1.001
        dense = np.linspace(1e-3, math.pi / period, 40000)
        factor = 1.0 - made.gain * averaging(dense, period, made.half_width, made.passes, made.lead) * integrating(t_a, delay)(dense)
        assert np.abs(factor).max() <= made.worst_factor + 1e-9


def test_the_kernels_of_a_law_follow_from_its_impulse_response() -> None:
    loop = coupled_loop(*stages(0.1, 15e-3))
    w = np.geomspace(1.0, 3000.0, 60)
    eye = np.eye(2)
    heard = law_kernels(ZeroPhase(gain=0.3, half_width=9, passes=2, lead=4e-3), loop).response(w, eye)
    np.testing.assert_allclose(heard["feedback_command"], 0.3 * averaging(w, 1e-3, 9, 2, 4e-3)[:, None, None] * eye, atol=1e-12)
    np.testing.assert_allclose(heard["table"], np.broadcast_to(eye, (60, 2, 2)), atol=1e-12)
    heard = law_kernels(PType(gain=30.0, bandwidth=120.0, order=2), loop).response(w, eye)
    q = 1.0 / (1.0 + (np.tan(0.5e-3 * w) / math.tan(0.06)) ** 4)
    np.testing.assert_allclose(heard["tracking_error"], 30.0 * q[:, None, None] * eye, atol=1e-6)


@pytest.mark.parametrize(
    "law",
    [
        ZeroPhase(half_width=5),
        ZeroPhase(half_width=4, passes=2, lead=2e-3, target="reference"),
        CrossCoupledLearning(gain=100.0, contour_gain=200.0, lead=3e-3),
    ],
)
def test_the_operator_and_its_transpose_equal_those_of_the_matrix(law: LearningLaw) -> None:
    loop = coupled_loop(*unlike(2, CrossCoupled(gain=900.0, integral_rate=10.0)))
    operator = TrialOperator(loop, law, circle(60))
    matrix, v = operator.matrix(), np.random.default_rng(0).normal(size=(60, 2))
    # As in the law itself, ends included.
    error, feedback = operator.map.forward(v)
    record = TrialRecord(error, feedback, np.zeros((60, 2)), operator.problem.across(error))
    np.testing.assert_allclose(matrix @ v.ravel(), law.update(v, record, operator.problem).ravel(), atol=1e-11)
    np.testing.assert_allclose(operator.transposed(v).ravel(), matrix.T @ v.ravel(), atol=1e-11)
    assert operator.norm() == pytest.approx(np.linalg.norm(matrix, 2), rel=1e-3)
    assert operator.radius() == pytest.approx(np.abs(np.linalg.eigvals(matrix)).max(), rel=1e-2)


@pytest.mark.slow
def test_a_short_trial_gives_all_its_singular_values() -> None:
    loop = coupled_loop(*unlike(2, CrossCoupled(gain=900.0)))
    found, law = lifted_learning(loop, ZeroPhase(half_width=5), circle(60)), ZeroPhase(half_width=5)
    assert found.singular_values is not None and found.singular_values.size == 120
    matrix = TrialOperator(loop, law, circle(60)).matrix()
    assert np.square(found.singular_values).sum() == pytest.approx(np.square(matrix).sum(), rel=1e-12)
    assert found.singular_values[0] == pytest.approx(found.norm, rel=1e-3)
    assert lifted_learning(loop, law, circle(600)).singular_values is None


def test_a_long_trial_agrees_with_the_frequency_response() -> None:
    loop = coupled_loop(*stages(0.1, 15e-3))
    law = ZeroPhase()
    straight = np.tile([0.6, 0.8], (3000, 1))
    _, factor = frequency_learning(loop, law).worst_norm
    assert lifted_learning(loop, law, straight).norm == pytest.approx(factor, abs=2e-3)


@pytest.mark.slow
def test_thirty_thousand_samples_need_no_matrix() -> None:
    loop = coupled_loop(*stages(0.1, 15e-3, coupling=CrossCoupled(gain=5.0)))
    norm = TrialOperator(loop, ZeroPhase(), circle(30_000)).norm(15)
    _, factor = frequency_learning(loop, ZeroPhase()).worst_norm
    assert norm == pytest.approx(factor, abs=3e-3)


def test_model_based_laws_learn_monotonically_where_the_model_is_right() -> None:
    loop = coupled_loop(*stages(0.1, 15e-3))
    for law in (NormOptimal(), NormOptimal(contour_weight=3.0), PlantInversion(gain=0.8, regularisation=1e-3)):
        assert frequency_learning(loop, law).worst_norm[1] <= 1.0 + 1e-9
    operator = TrialOperator(loop, NormOptimal(), circle(40))
    with pytest.raises(ComponentError, match="norm-optimal"):
        operator.transposed(np.zeros((40, 2)))


@pytest.mark.slow
def test_divergence_is_a_finding() -> None:
    found = learning_analysis(*stages(0.1, 15e-3), ZeroPhase())
    assert not found.converges
    assert not found.monotone
    assert found.worst_factor == pytest.approx(1.025, abs=2e-3)
    assert found.worst_frequency / TURN == pytest.approx(9.3, abs=0.3)
    assert [one.code for one in found.findings] == ["CL310", "CL312"]
    assert found.design is not None
    better = ZeroPhase(gain=found.design.gain, half_width=found.design.half_width, passes=found.design.passes, lead=found.design.lead)
    assert learning_analysis(*stages(0.1, 15e-3), better).worst_factor <= 1.001
    bare = learning_analysis(*stages(0.1, 0.0), PType(gain=5.0))
    assert [one.code for one in bare.findings] == ["CL310"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("factor", "code", "trials"),
    [(1.003, "CL310", 231.4), (1.00001, "CL310", 69315.0), (1.07, "CL310", 10.24), (1.08, "CL315", 9.006), (2.0, "CL315", 1.0)],
)
def test_slow_growth_is_told_from_a_runaway(factor: float, code: str, trials: float) -> None:
    found = learning_analysis(*stages(0.1, 15e-3), ZeroPhase())
    response = dataclasses.replace(found.response, worst_radius=(118.0 * TURN, factor))
    (first, *_) = dataclasses.replace(found, response=response, design=None).findings
    assert first.code == code
    assert dict(first.values) == pytest.approx({"frequency": 118.0, "growth": factor - 1.0, "doubling": trials}, rel=1e-3)
    # The error has doubled after so many factors.
    assert factor ** first.values["doubling"] == pytest.approx(2.0)


def test_growth_along_the_path_alone_has_the_same_figures() -> None:
    found = learning_analysis(*stages(0.1, 15e-3), ZeroPhase())
    response = dataclasses.replace(found.response, worst_radius=(118.0 * TURN, 0.9), worst_norm=(118.0 * TURN, 0.9))
    one, *_ = dataclasses.replace(found, response=response, design=None, lifted=LiftedLearning(1.02, 1.1)).findings
    assert (one.code, dict(one.values)) == ("CL314", pytest.approx({"growth": 0.02, "doubling": math.log(2.0) / math.log(1.02)}))


@pytest.mark.slow
def test_convergence_is_reported() -> None:
    reference = uniform(contour("circle", radius=0.02), 1.0, 1, 1e-3)
    found = learning_analysis(*stages(0.1, 0.0), PType(gain=5.0, bandwidth=TURN * 1.5, order=4), reference)
    assert found.converges
    assert found.monotone
    assert not list(found.findings)
    assert found.lifted is not None
    assert found.lifted.radius <= 1.0


def test_nothing_is_learned_on_an_unstable_axis() -> None:
    with pytest.raises(ComponentError, match=r"\bx\b.*unstable"):
        learning_analysis(*stages(5e-3, 15e-3), ZeroPhase())
