"""The contour error transfer function, its margins over all directions, and stability where the path turns."""

from __future__ import annotations

import numpy as np
import pytest
from coupled_axes import alike, circle, stages, unlike
from hypothesis import given
from hypothesis import strategies as st

from contourlab.analysis.linear.contour_transfer import contour_margins, contour_transfer, internal_stability
from contourlab.analysis.linear.coupled_loop import TrialMap, coupled_loop, coupling_model, normal_basis, normal_frames
from contourlab.analysis.linear.margins import hull_modulus
from contourlab.components.coupling.laws import CrossCoupled, CrossCoupledFilter, ModifiedError, ModifiedReference
from contourlab.components.estimator.local import Tangent
from contourlab.errors import ComponentError
from contourlab.feed import uniform
from contourlab.geometry import Line, Path, contour
from contourlab.loop import Controller, Learned, simulate

PID = {"gain": 2500.0, "integral_rate": 20.0, "derivative_time": 0.02, "derivative_filter": 4e-3}


@pytest.mark.parametrize("n_axis", [2, 3])
def test_with_equal_axes_the_sampled_loop_gain_is_kappa_t(n_axis: int) -> None:
    kappa, kp = 1.7, 300.0
    transfer = contour_transfer(*alike(n_axis, kp, CrossCoupled(gain=kappa * kp)))
    w = transfer.loop.frequencies(60)
    closed = transfer.loop.axes[0].loop.response(w).closed_loop
    for direction in np.random.default_rng(0).normal(size=(5, n_axis)):
        np.testing.assert_allclose(1.0 + transfer.loop_gain(w, direction), 1.0 + kappa * closed, rtol=1e-10)


@pytest.mark.parametrize("n_axis", [2, 3])
@pytest.mark.parametrize("coupling", [None, CrossCoupled(gain=900.0, integral_rate=20.0), ModifiedReference(weight=0.5)])
def test_a_table_changes_a_run_as_the_trial_map_predicts(n_axis: int, coupling: CrossCoupled | None) -> None:
    # The tangent at the reference does not depend on the tool, so the run is linear: only rounding is left.
    machine, controller = unlike(n_axis, coupling)
    path = contour("circle", radius=0.02)
    if n_axis == 3:
        path = Path([Line((0.0, 0.0, 0.0), (0.02, 0.01, 0.0)), Line((0.02, 0.01, 0.0), (0.0, 0.02, 0.01))])
        path = Path([*path.curves, Line((0.0, 0.02, 0.01), (0.0, 0.0, 0.0))], closed=True)
    reference = uniform(path, 0.4, 1, 1e-3)
    table = 1e-3 * np.cumsum(np.random.default_rng(3).normal(size=(reference.n_sample, n_axis)), axis=0)
    plain, moved = (simulate(machine, controller, reference, learned=learned) for learned in (None, Learned(command=table)))
    tangents = reference.path.tangent(reference.block(0, reference.n_sample).arc_length)
    error, feedback = TrialMap(coupled_loop(machine, controller), tangents).forward(table)
    np.testing.assert_allclose(plain["position"] - moved["position"], error, atol=1e-7 * np.abs(error).max())
    np.testing.assert_allclose(moved["command"] - plain["command"] - table, feedback, atol=1e-7 * np.abs(feedback).max())


@pytest.mark.slow
@pytest.mark.parametrize("coupling", [CrossCoupled(**PID), CrossCoupled(gain=1500.0), ModifiedReference(weight=0.75)])
def test_margins_are_those_of_the_worst_of_many_directions(coupling: CrossCoupled) -> None:
    transfer = contour_transfer(*unlike(2, coupling))
    found = transfer.margins()
    w = np.unique(np.concatenate([transfer.grid, np.geomspace(1.0, transfer.loop.nyquist, 20000)]))
    share = np.linspace(0.0, 1.0, 101)
    ends = transfer.vertices(w)
    gain = ends[:, :1] * (1.0 - share) + ends[:, 1:] * share
    assert found.stable
    assert found.modulus == pytest.approx(np.abs(1.0 + gain).min(), rel=1e-5)
    crossed = (np.abs(gain[1:]) > 1.0) != (np.abs(gain[:-1]) > 1.0)
    assert abs(found.phase) == pytest.approx(np.abs(np.angle(-gain[:-1][crossed])).min(), rel=3e-3)
    worst = transfer.loop_gain([found.modulus_frequency], found.modulus_direction)
    assert abs(1.0 + worst[0]) == pytest.approx(found.modulus, rel=1e-6)


@pytest.mark.parametrize("n_axis", [2, 3])
def test_at_the_gain_margin_a_pole_leaves_the_circle(n_axis: int) -> None:
    margins = contour_margins(*unlike(n_axis, CrossCoupled(gain=1500.0)))
    for factor, stable in ((0.999, True), (1.001, False)):
        machine, controller = unlike(n_axis, CrossCoupled(gain=1500.0 * margins.gain * factor))
        assert contour_transfer(machine, controller).stable is stable
        poles = coupled_loop(machine, controller).poles(np.array(margins.gain_direction)[:, None])
        assert bool(np.abs(poles).max() < 1.0) is stable


def test_the_polygon_bounds_how_near_the_matrix_of_a_normal_plane_is_to_singular() -> None:
    transfer = contour_transfer(*unlike(3, CrossCoupled(gain=1500.0)))
    w = transfer.loop.frequencies(80)
    bound, ends = transfer.distance(w), transfer.vertices(w)
    for tangent in np.random.default_rng(2).normal(size=(10, 3)):
        basis = normal_basis(tangent)
        loop = basis.T @ (ends[:, :, None] * basis)
        assert (np.linalg.svd(np.eye(2) + loop)[1][:, -1] >= bound - 1e-12).all()


@given(st.lists(st.complex_numbers(max_magnitude=4.0), min_size=2, max_size=5))
def test_the_distance_from_a_polygon_is_that_of_its_nearest_mean(points: list[complex]) -> None:
    from scipy.optimize import nnls

    ends = np.array(points)
    rows = np.vstack([ends.real + 1.0, ends.imag, np.full(ends.size, 1e5)])
    weights, _ = nnls(rows, np.array([0.0, 0.0, 1e5]))
    nearest = abs(weights @ (ends + 1.0) / weights.sum())
    assert hull_modulus(ends[None, :])[0] == pytest.approx(nearest, abs=1e-5)


def test_the_model_samples_the_coupling_as_it_runs() -> None:
    part = CrossCoupledFilter(gain=2.0, numerator=[2e-3, 0.5, 4.0], denominator=[1e-3, 0.3, 2.0])
    w = np.geomspace(1.0, 3000.0, 50)
    warped = 2j / 1e-3 * np.tan(0.5e-3 * w)  # the trapezoidal rule is exact at the warped frequency
    wanted = 2.0 * np.polyval(part.numerator, warped) / np.polyval(part.denominator, warped)
    np.testing.assert_allclose(coupling_model(part, 1e-3)(w), wanted, rtol=1e-8)


def test_modified_reference_and_modified_error_have_the_same_weight_along_the_path() -> None:
    for part in (ModifiedReference(weight=0.6), ModifiedError(weight=0.6)):
        model = coupling_model(part, 1e-3)
        assert (model.weight, model.d, len(model.f)) == (pytest.approx(0.6), 0.0, 0)


@pytest.mark.slow
def test_the_strength_of_variable_gains_divides_the_gain_margin() -> None:
    machine, controller = unlike(2, CrossCoupled(gain=1500.0))
    one, more = contour_margins(machine, controller), contour_margins(machine, controller, strength=1.2)
    assert more.gain == pytest.approx(one.gain / 1.2, rel=1e-6)


def test_an_integral_parallel_to_those_of_the_axes_is_not_unstable() -> None:
    machine, controller = unlike(2, CrossCoupled(**PID))
    assert internal_stability(machine, controller).stable


def test_the_monodromy_of_a_lap_is_the_product_of_its_ticks() -> None:
    for n_axis in (2, 3):
        loop = coupled_loop(*unlike(n_axis, CrossCoupled(gain=1500.0)))
        tangents = circle(150, n_axis)
        frames, product = normal_frames(tangents), np.eye(sum(len(axis.a) for axis in loop.axes))
        for frame in frames:
            product = loop.matrix(frame) @ product
        np.testing.assert_allclose(TrialMap(loop, tangents).monodromy(), product, rtol=0.0, atol=1e-9 * np.abs(product).max())


def test_a_turning_normal_may_be_unstable_where_every_fixed_one_is_stable() -> None:
    machine, controller = unlike(2, CrossCoupled(gain=4000.0))
    assert contour_transfer(machine, controller).stable
    # A lap of 120 ms pumps the axes, whose stiffness across the path changes twice per lap; a slow lap does not.
    loop = coupled_loop(machine, controller)
    fast, slow = (np.abs(np.linalg.eigvals(TrialMap(loop, circle(n)).monodromy())).max() for n in (120, 800))
    assert fast > 1.5
    assert slow < 0.01
    reference = uniform(contour("circle", radius=0.02), 1.0 / 0.12, 2, 1e-3)
    found = internal_stability(machine, controller, reference)
    assert not found.stable
    assert found.lap == pytest.approx(fast, rel=1e-6)
    (one,) = found.findings
    assert one.code == "CL207"


def test_an_unstable_coupling_is_a_finding() -> None:
    reference = uniform(contour("circle", radius=0.02), 1.0, 2, 1e-3)
    found = internal_stability(*stages(0.1, 15e-3, coupling=CrossCoupled(gain=5.0)), reference)
    assert found.stable
    assert 0.0 < found.lap < 1e-3
    assert not found.findings
    bad = internal_stability(*stages(0.1, 15e-3, coupling=CrossCoupled(gain=500.0)), reference)
    assert not bad.stable
    assert [one.code for one in bad.findings] == ["CL206"]
    machine, controller = stages(5e-3, 15e-3)
    assert not all(internal_stability(machine, controller).axes.values())


@pytest.mark.parametrize("gain", [80.0, 500.0])
def test_an_unstable_coupling_doubles_an_error_in_the_time_it_states(gain: float) -> None:
    machine, controller = stages(0.1, 15e-3, coupling=CrossCoupled(gain=gain))
    found = contour_margins(machine, controller)
    assert not found.stable
    normal = np.array(found.modulus_direction)
    along = np.tile([-normal[1], normal[0]], (400, 1))
    growth = np.abs(np.linalg.eigvals(TrialMap(coupled_loop(machine, controller), along).monodromy())).max()
    assert growth == pytest.approx(2.0 ** (400 * machine.servo_period / found.doubling), rel=1e-3)
    (one,) = internal_stability(machine, controller).findings
    assert (one.code, one.values["doubling"]) == ("CL206", found.doubling)


def test_growth_per_lap_has_its_doubling() -> None:
    machine, controller = unlike(2, CrossCoupled(gain=4000.0))
    lap = internal_stability(machine, controller, uniform(contour("circle", radius=0.02), 1.0 / 0.12, 2, 1e-3))
    (one,) = lap.findings
    assert (one.code, one.values["growth"]) == ("CL207", lap.lap - 1.0)
    assert lap.lap ** one.values["doubling"] == pytest.approx(2.0)


def test_without_a_coupling_there_is_no_transfer_function() -> None:
    machine, controller = stages(0.1, 0.0)
    with pytest.raises(ComponentError, match="no coupling"):
        contour_margins(machine, Controller(controller.axes, Tangent()))
