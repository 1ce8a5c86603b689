"""Couplings: their effect on tracking and contour error, and when they have none."""

from __future__ import annotations

import numpy as np
import pytest
from component_rig import PERIOD, Array, make, run_alone
from hypothesis import given
from hypothesis import strategies as st

import contourlab as cl

KINDS = ["modified-reference", "modified-error"]
NUMBERS = st.floats(-1.0, 1.0)
WEIGHTS = st.floats(0.0, 0.99)


def coupled(kind: str, weight: float, reference: Array, position: Array, foot: Array, error: Array) -> Array:
    """Return the modified reference of one tick."""
    fed = {"reference": reference, "position": position, "foot_position": foot, "error_vector": error}
    out = run_alone(make("coupling", kind, weight=weight), {name: np.atleast_2d(values) for name, values in fed.items()})
    return out["modified_reference"][0]


@given(kind=st.sampled_from(KINDS), weight=WEIGHTS, lag=NUMBERS, error=NUMBERS, turn=st.floats(-4.0, 4.0), at=st.tuples(NUMBERS, NUMBERS))
def test_the_gain_is_one_across_the_path_and_less_along_it(
    kind: str, weight: float, lag: float, error: float, turn: float, at: tuple[float, float]
) -> None:
    """On a straight path: r' - p is the whole contour error and 1 - lambda of the lag."""
    tangent, normal = np.array([np.cos(turn), np.sin(turn)]), np.array([-np.sin(turn), np.cos(turn)])
    foot = np.array(at)
    position, reference = foot + error * normal, foot + lag * tangent
    seen = coupled(kind, weight, reference, position, foot, foot - position) - position
    assert seen @ normal == pytest.approx(-error, abs=1e-14)
    assert seen @ tangent == pytest.approx((1.0 - weight) * lag, abs=1e-14)


@given(weight=WEIGHTS, numbers=st.lists(NUMBERS, min_size=9, max_size=9))
def test_with_a_converged_foot_point_both_couplings_agree(weight: float, numbers: list[float]) -> None:
    """In space too, on any path: the error vector then points to the foot point."""
    reference, position, foot = np.reshape(numbers, (3, 3))
    one, other = (coupled(kind, weight, reference, position, foot, foot - position) for kind in KINDS)
    assert one == pytest.approx(other, abs=1e-14)


@given(kind=st.sampled_from(KINDS), numbers=st.lists(NUMBERS, min_size=8, max_size=8))
def test_zero_weight_is_no_coupling(kind: str, numbers: list[float]) -> None:
    reference, position, foot, error = np.reshape(numbers, (4, 2))
    assert coupled(kind, 0.0, reference, position, foot, error) == pytest.approx(reference, abs=1e-15)


@pytest.mark.parametrize("kind", KINDS)
def test_on_the_reference_the_correction_is_zero(kind: str) -> None:
    here = np.array([0.3, -0.2])
    assert coupled(kind, 0.75, here, here, here, np.zeros(2)) == pytest.approx(here, abs=1e-16)


def stage(coupling: object | None, laps: int = 1) -> cl.Result:
    """Run an ellipse with unlike axes and sticking friction."""
    axes = []
    for name, gain, coulomb in (("x", 1.1, 0.055), ("y", 0.65, 0.088)):
        plant = make("plant", "rigid-axis", gain=gain, damping=6.0)
        axes.append(cl.Axis(name, plant, friction=make("friction", "coulomb", coulomb=coulomb)))
    part = make("controller", "position", velocity_gain=70.0, position_gain=2800.0, integral_gain=12.0, model_gain=0.9, model_damping=6.0)
    servo = dict.fromkeys("xy", cl.AxisController(part, make("velocity", "true")))
    estimator = None if coupling is None else make("estimator", "newton")
    controller = cl.Controller(servo, estimator, coupling)  # type: ignore[arg-type]
    reference = cl.uniform(cl.contour("ellipse"), 0.5, laps, PERIOD)
    return cl.simulate(cl.Machine("stage", tuple(axes), PERIOD), controller, reference)


def test_in_the_loop_both_couplings_agree_with_a_converged_estimator() -> None:
    one, other = (stage(make("coupling", kind, weight=0.75))["axis_position"] for kind in KINDS)
    assert np.abs(one - other).max() < 1e-9
    assert np.abs(one - stage(None)["axis_position"]).max() > 1e-5
