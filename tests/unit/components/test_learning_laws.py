"""Learning laws against closed forms, dense matrices and other programs."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from contourlab.components.conformance import check_component, check_learning
from contourlab.components.learning.law import InputModel, LearningLaw, LearningProblem, TrialRecord, advanced, moving_average, q_filter
from contourlab.components.registry import component, components
from contourlab.errors import ComponentError, ParameterError

Array = NDArray[np.float64]
PERIOD = 1e-3


def law(kind: str, **parameters: Any) -> Any:
    return component("learning", kind)(**parameters)


def problem_of(impulse: Array, n: int, tangent: Array | None = None) -> LearningProblem:
    along = np.zeros((n, impulse.shape[1])) if tangent is None else tangent
    if tangent is None:
        along[:, 0] = 1.0
    velocity = 0.01 * np.sin(0.03 * np.arange(n)[:, None] + np.arange(impulse.shape[1]))
    return LearningProblem(PERIOD, along, lambda: impulse, lambda: (velocity, np.asarray(np.gradient(velocity, PERIOD, axis=0))))


def trial_of(error: Array, feedback: Array | None = None, excess: Array | None = None, contour: Array | None = None) -> TrialRecord:
    none = np.zeros_like(error)
    return TrialRecord(error, none if feedback is None else feedback, none if excess is None else excess, contour)


def dense(impulse: Array, n: int) -> Array:
    """Return the lower-triangular matrix of an impulse response."""
    g = np.concatenate([impulse, np.zeros(max(n - len(impulse), 0))])
    return np.array([[g[i - j] if i >= j else 0.0 for j in range(n)] for i in range(n)])


def settling(n: int, *decays: float) -> Array:
    return np.column_stack([np.concatenate([[0.0], (1.0 - a) * a ** np.arange(n - 1)]) for a in decays])


# --- filters -------------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("frequency", [2.0, 21.7, 90.0, 180.0])
@pytest.mark.parametrize("passes", [1, 2])
def test_the_average_has_the_response_of_eq_9(frequency: float, passes: int) -> None:
    m, w = 11, 2.0 * np.pi * frequency
    t = np.arange(600)[:, None] * PERIOD
    wave = np.sin(w * t + 0.3)
    expected = (np.sin((2 * m + 1) * w * PERIOD / 2) / ((2 * m + 1) * np.sin(w * PERIOD / 2))) ** passes
    inner = slice(2 * m, -2 * m)
    assert moving_average(wave, m, passes)[inner] == pytest.approx(expected * wave[inner], abs=1e-12)


@pytest.mark.parametrize("order", [1, 2, 4])
def test_the_q_filter_is_a_butterworth_run_both_ways(order: int) -> None:
    """Against SciPy's, in the time domain, over a long mirror image."""
    from scipy.signal import butter, sosfiltfilt

    signal = np.random.default_rng(5).normal(size=(4000, 2)).cumsum(axis=0)
    whole = np.pad(signal, ((4000, 4000), (0, 0)), mode="symmetric")
    for hertz in (4.0, 120.0, 420.0):
        ours = q_filter(signal, 2.0 * np.pi * hertz, order, PERIOD)
        theirs = sosfiltfilt(butter(order, hertz, fs=1.0 / PERIOD, output="sos"), whole, axis=0)[4000:8000]
        np.testing.assert_allclose(ours, theirs, rtol=0.0, atol=1e-8 * np.abs(theirs).max())


@given(st.integers(2, 300), st.floats(1.0, 4000.0), st.integers(1, 4), st.integers(0, 40), st.integers(0, 2**31))
@settings(max_examples=60)
def test_the_filters_keep_a_constant_and_amplify_nothing(n: int, bandwidth: float, order: int, half_width: int, seed: int) -> None:
    """They are symmetric too. All of this keeps the ends of a trial bounded while the rest converges."""
    rng = np.random.default_rng(seed)
    x, y = rng.normal(size=(2, n, 1))
    for filtered in (lambda s: q_filter(s, bandwidth, order, PERIOD), lambda s: moving_average(s, half_width)):
        assert filtered(np.full((n, 1), 3.0)) == pytest.approx(np.full((n, 1), 3.0), rel=1e-12)
        assert np.linalg.norm(filtered(x)) <= np.linalg.norm(x) * (1.0 + 1e-12)
        assert float(np.vdot(y, filtered(x))) == pytest.approx(float(np.vdot(filtered(y), x)), abs=1e-10 * n)


def test_an_advanced_signal_is_zero_beyond_the_end() -> None:
    signal = np.arange(1.0, 7.0)[:, None]
    assert advanced(signal, 2)[:, 0].tolist() == [3.0, 4.0, 5.0, 6.0, 0.0, 0.0]
    assert advanced(signal, 0) is signal
    assert advanced(signal, 99)[:, 0].tolist() == [0.0] * 6


# --- the model -----------------------------------------------------------------------------------------------------------------------


@given(st.integers(3, 200), st.integers(1, 60), st.integers(1, 3), st.integers(0, 2**31))
@settings(max_examples=40)
def test_the_model_convolves_and_its_adjoint_is_the_transpose(n: int, m: int, n_axis: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    impulse = rng.normal(size=(m, n_axis))
    model = InputModel(impulse, n)
    u, e = rng.normal(size=(2, n, n_axis))
    for j in range(n_axis):
        assert model.forward(u)[:, j] == pytest.approx(np.convolve(u[:, j], impulse[:n, j])[:n], abs=1e-10)
        assert model.adjoint(e)[:, j] == pytest.approx(dense(impulse[:, j], n).T @ e[:, j], abs=1e-10)


# --- laws ----------------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", components("learning"), ids=lambda kind: kind.kind)
def test_every_law_keeps_the_contract(kind: type[LearningLaw]) -> None:
    check_component(kind)


def test_p_pd_and_cross_coupled_laws_add_the_stated_terms() -> None:
    rng = np.random.default_rng(3)
    error, contour, table = rng.normal(size=(3, 50, 2))
    nothing = problem_of(np.zeros((2, 2)), 50)
    trial = trial_of(error, contour=contour)
    rate = np.gradient(error, PERIOD, axis=0)
    assert law("p-type", gain=4.0).update(table, trial, nothing) == pytest.approx(table + 4.0 * error)
    assert law("pd-type", gain=4.0, derivative_gain=0.1).update(table, trial, nothing) == pytest.approx(table + 4.0 * error + 0.1 * rate)
    assert law("cross-coupled", gain=4.0, contour_gain=3.0).update(table, trial, nothing) == pytest.approx(
        table + 4.0 * error + 3.0 * contour
    )
    shifted = law("p-type", gain=4.0, target="reference", stiffness=8.0, lead=3e-3).update(table, trial, nothing)
    assert shifted[:-3] == pytest.approx(table[:-3] + 0.5 * error[3:])


def test_in_the_plane_the_vector_form_equals_the_scalar_form_of_barton_and_alleyne() -> None:
    """u_x + L e_x - C_x L_c eps and u_y + L e_y + C_y L_c eps with eps = -C_x e_x + C_y e_y, C_x = sin, C_y = cos."""
    rng = np.random.default_rng(4)
    angle = rng.uniform(0.0, 6.0, 80)
    tangent = np.column_stack([np.cos(angle), np.sin(angle)])
    error = rng.normal(size=(80, 2))
    eps = -np.sin(angle) * error[:, 0] + np.cos(angle) * error[:, 1]
    problem = problem_of(np.zeros((2, 2)), 80, tangent)
    found = law("cross-coupled", gain=2.0, contour_gain=5.0).update(
        np.zeros((80, 2)), trial_of(error, contour=problem.across(error)), problem
    )
    assert found[:, 0] == pytest.approx(2.0 * error[:, 0] - np.sin(angle) * 5.0 * eps)
    assert found[:, 1] == pytest.approx(2.0 * error[:, 1] + np.cos(angle) * 5.0 * eps)


def test_the_inverse_of_an_exact_model_removes_the_error_in_one_trial() -> None:
    n, impulse = 400, settling(300, 0.9, 0.8)
    model = InputModel(impulse, n)
    wanted = np.zeros((n, 2))
    wanted[50:250] = np.hanning(200)[:, None] * (1.0, -2.0)
    error = model.forward(wanted)
    found = law("plant-inversion", regularisation=1e-12).update(np.zeros((n, 2)), trial_of(error), problem_of(impulse, n))
    assert found == pytest.approx(wanted, abs=1e-5)
    half = law("plant-inversion", regularisation=1e-12, gain=0.5).update(np.zeros((n, 2)), trial_of(error), problem_of(impulse, n))
    assert half == pytest.approx(0.5 * wanted, abs=1e-5)


@pytest.mark.parametrize("contour", [0.0, 3.0])
def test_norm_optimal_solves_the_dense_equation(contour: float) -> None:
    """u+ = (G'QG + S + R)^-1 ((G'QG + R) u + G'Q e), Q = q I + Gamma' q_c Gamma, with full matrices."""
    n, rng = 40, np.random.default_rng(8)
    angle = np.linspace(0.0, 3.0, n)
    tangent = np.column_stack([np.cos(angle), np.sin(angle)])
    impulse = settling(30, 0.7, 0.5)
    problem = problem_of(impulse, n, tangent)
    error, table = rng.normal(size=(2, n, 2))
    given = {"tracking_weight": 1.5, "contour_weight": contour, "input_weight": 0.05, "change_weight": 0.2}
    found = law("norm-optimal", **given, tolerance=1e-13).update(table, trial_of(error), problem)

    g = np.zeros((2 * n, 2 * n))
    g[0::2, 0::2], g[1::2, 1::2] = dense(impulse[:, 0], n), dense(impulse[:, 1], n)
    q = 1.5 * np.eye(2 * n)
    for k in range(n):
        normal = np.array([-tangent[k, 1], tangent[k, 0]])
        q[2 * k : 2 * k + 2, 2 * k : 2 * k + 2] += contour * np.outer(normal, normal)
    peak = np.tile((np.abs(problem.model.response) ** 2).max(axis=0), n)
    s, r = np.diag(0.05 * peak), np.diag(0.2 * peak)
    left = g.T @ q @ g + s + r
    expected = np.linalg.solve(left, (g.T @ q @ g + r) @ table.ravel() + g.T @ q @ error.ravel())
    assert found.ravel() == pytest.approx(expected, abs=1e-9)


def test_norm_optimal_lowers_the_weighted_error_in_every_trial() -> None:
    n, rng = 300, np.random.default_rng(9)
    impulse = settling(200, 0.95, 0.9)
    angle = np.linspace(0.0, 5.0, n)
    problem = problem_of(impulse, n, np.column_stack([np.cos(angle), np.sin(angle)]))
    wanted, table = moving_average(rng.normal(size=(n, 2)), 4), np.zeros((n, 2))
    optimal, sizes = law("norm-optimal", contour_weight=2.0, change_weight=0.05), []
    for _ in range(12):
        error = wanted - problem.model.forward(table)
        across = problem.across(error)
        sizes.append(float((error**2).sum() + 2.0 * (across**2).sum()))
        table = optimal.update(table, trial_of(error), problem)
    assert all(b < a for a, b in pairwise(sizes))
    assert sizes[-1] < 0.05 * sizes[0]


@pytest.mark.parametrize(("gain", "modelled"), [(1.0, 1.0), (0.6, 1.0), (1.0, 1.25), (1.0, 0.75)])
def test_basis_functions_leave_a_fixed_share_of_the_error_in_each_trial(gain: float, modelled: float) -> None:
    """1 - alpha/g, for an axis whose inverse the functions span and a model of g times its gain; nothing with both 1."""
    n, impulse = 500, settling(300, 0.9, 0.8)
    problem, true = problem_of(modelled * impulse, n), InputModel(impulse, n)
    learner = law("basis-functions", gain=gain, smoothing_velocity=2e-3)
    wanted = np.array([[25.0, -4.0], [0.4, 0.1], [0.05, -0.2]])
    needed = sum(row * function for row, function in zip(wanted, learner.functions(problem), strict=True))
    table = np.zeros((n, 2))
    for i in range(1, 5):
        table = learner.update(table, trial_of(true.forward(needed - table)), problem)
        left = (1.0 - gain / modelled) ** i
        assert table == pytest.approx((1.0 - left) * needed, abs=1e-9)
    found = learner.gains(table, problem)
    for j in range(2):
        kept = [found[j][name] for name in ("velocity_gain", "acceleration_gain", "friction")]
        assert kept == pytest.approx((1.0 - left) * wanted[:, j], abs=1e-9)
        assert found[j]["smoothing_velocity"] == 2e-3


def test_an_axis_that_rests_learns_nothing_and_one_at_constant_speed_the_smallest_gains() -> None:
    n, speed = 200, 0.02
    velocity = np.tile((0.0, speed), (n, 1))
    problem = LearningProblem(PERIOD, np.tile((0.0, 1.0), (n, 1)), lambda: settling(50, 0.5, 0.5), lambda: (velocity, np.zeros((n, 2))))
    found = law("basis-functions").gains(np.tile((0.3, 0.3), (n, 1)), problem)
    assert set(found[0].values()) == {0.0, 3e-4}
    # Friction and speed cannot be told apart: either takes half.
    assert found[1]["velocity_gain"] * speed == pytest.approx(0.15)
    assert found[1]["friction"] == pytest.approx(0.15)


def test_zero_phase_uses_the_feedback_or_for_a_reference_table_the_error() -> None:
    rng = np.random.default_rng(6)
    feedback, error, table = rng.normal(size=(3, 200, 2))
    nothing = problem_of(np.zeros((2, 2)), 200)
    trial = trial_of(error, feedback)
    kernel = np.full(7, 0.2 / 7)
    for target, signal in (("command", feedback), ("reference", error)):
        found = law("zero-phase", gain=0.2, half_width=3, target=target).update(table, trial, nothing)
        for j in range(2):
            assert found[3:-3, j] == pytest.approx(table[3:-3, j] + np.convolve(signal[:, j], kernel, "valid"), abs=1e-12)


@pytest.mark.parametrize("kind", [kind.kind for kind in components("learning")])
def test_the_table_does_not_grow_where_the_drive_saturates(kind: str) -> None:
    """A hundred trials of a machine at its limit: the table there stays constant."""
    n = 300
    one = component("learning", kind)
    problem = problem_of(settling(100, 0.9, 0.8), n)
    excess = np.zeros((n, 2))
    excess[100:200, 0] = 0.3
    trial = trial_of(np.full((n, 2), 1e-3), np.full((n, 2), 0.1), excess, np.full((n, 2), 1e-3))
    table = np.zeros((n, 2))
    for _ in range(100):
        table = one(**one.example).update(table, trial, problem)
    assert table[100:200, 0].max() <= 1e-12
    assert np.abs(table[:, 1]).max() > 0.0


# --- the check of laws ---------------------------------------------------------------------------------------------------------------


class _Sound(LearningLaw):
    """Adds the error."""

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        return table + (1.0 if self.target == "command" else 2.0) * trial.tracking_error


def test_a_correct_law_passes_the_check() -> None:
    check_learning(_Sound())


def _faulty(body: Any) -> LearningLaw:
    class Faulty(_Sound):
        def update(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
            return np.asarray(body(self, table, trial, problem))

    return Faulty()


def _in_place(self: Any, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
    table += trial.tracking_error
    return table


FAULTS = {
    "shape": lambda self, table, trial, problem: table[:-1],
    "not finite": lambda self, table, trial, problem: table / 0.0 if table.any() else table * 1.0,
    "writes into": _in_place,
    "differ": lambda self, table, trial, problem: table + np.random.default_rng().normal() * trial.tracking_error,
    "without errors": lambda self, table, trial, problem: table + trial.tracking_error + 1.0,
    "into its limit": lambda self, table, trial, problem: self.revised(table, trial, problem) + trial.excess,
    "target has no effect": lambda self, table, trial, problem: LearningLaw.update(self.replace(target="command"), table, trial, problem),
}


@pytest.mark.parametrize("said", FAULTS)
@pytest.mark.filterwarnings("ignore:divide by zero", "ignore:invalid value")
def test_a_planted_fault_is_found(said: str) -> None:
    with pytest.raises(ComponentError, match=said):
        check_learning(_faulty(FAULTS[said]))


def test_bounds_are_respected() -> None:
    with pytest.raises(ParameterError, match="gain"):
        law("zero-phase", gain=-0.1)
    with pytest.raises(ParameterError, match="whole"):
        law("zero-phase", half_width=2.5)
    with pytest.raises(ParameterError, match="bandwidth"):
        law("p-type", gain=1.0, bandwidth=0.0)
    with pytest.raises(ComponentError, match="no learning"):
        component("learning", "by-heart")
