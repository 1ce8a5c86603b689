"""Feedforward from the reference: friction, inverse dynamics, and the zero-phase filter as a component."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, make, run_alone
from scipy.signal import lfilter

import contourlab as cl
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.pid import PID
from contourlab.components.feedforward.laws import ZPETC, FrictionFeedforward, InverseDynamics
from contourlab.errors import ParameterError
from contourlab.papers.ghaffari.axis_response import axis_response

STRIBECK = {"coulomb": 3.0, "breakaway": 5.0, "stribeck_velocity": 0.01, "viscous": 20.0, "smoothing_velocity": 1e-4}


def command(part: Any, velocity: Any) -> Any:
    return run_alone(part, {"reference_velocity": velocity})["command"]


def test_limits_of_the_friction_curve() -> None:
    """F_s after a change of sign with the full Stribeck effect, F_c + c v far beyond it, F_s v/v_e through zero; in commands."""
    part = FrictionFeedforward(**STRIBECK, force_constant=4.0)
    near, far, least = command(part, [4e-4, 0.1, 1e-9])
    assert near == pytest.approx((5.0 - 2.0 * (4e-4 / 0.01) ** 2 + 20.0 * 4e-4) / 4.0, rel=1e-3)
    assert far == pytest.approx((3.0 + 20.0 * 0.1) / 4.0, rel=1e-12)
    assert least == pytest.approx(5.0 * 1e-9 / 1e-4 / 4.0, rel=1e-3)


def test_friction_is_odd() -> None:
    v = np.linspace(0.0, 0.05, 200)
    part = FrictionFeedforward(**STRIBECK)
    assert command(part, -v) == pytest.approx(-command(part, v), abs=0.0)


def test_known_friction_leaves_a_small_error() -> None:
    """The same law in axis and feedforward: the rest at the reversals comes from the lag between reference and axis."""
    errors = []
    for part in (None, FrictionFeedforward(**STRIBECK, force_constant=60.0)):
        friction = make("friction", "smooth-coulomb", **STRIBECK)
        plant = make("plant", "mass-damper", mass=20.0, force_constant=60.0)
        axes = tuple(cl.Axis(name, plant, friction, substeps=4) for name in "xy")
        servo = cl.AxisController(Cascade(**Cascade.tune(300.0, 1.0, 3.0)), feedforward=part)
        reference = cl.uniform(cl.contour("circle", radius=0.02), 0.5, 2, PERIOD)
        result = cl.simulate(cl.Machine("rubbing", axes, PERIOD), cl.Controller(dict.fromkeys("xy", servo)), reference)
        half = result.n_sample // 2
        errors.append(np.sqrt(np.mean((result["axis_position"] - result["reference"])[half:] ** 2)))
    assert errors[1] < 0.2 * errors[0]


def test_an_axis_with_its_inverse_as_feedforward_follows_with_any_controller() -> None:
    """v' = a u - b v with k_a = 1/a, k_v = b/a."""
    w = np.geomspace(0.5, 1000.0, 30)
    axis = cl.Axis("x", make("plant", "rigid-axis", gain=1.8, damping=20.0))
    ahead = InverseDynamics(velocity_gain=20.0 / 1.8, acceleration_gain=1.0 / 1.8)
    # A PID derivative on the error adds nothing at zero error.
    servo = cl.AxisController(PID(proportional_gain=900.0, derivative_gain=30.0), feedforward=ahead)
    assert axis_response(axis, servo, w).closed_loop == pytest.approx(np.ones(w.size), abs=1e-10)
    gaps = [np.abs(sampled_loop(axis, servo, period).response(w[w < 300.0]).closed_loop - 1.0).max() for period in (1e-3, 5e-4, 2.5e-4)]
    assert np.log2(np.array(gaps[:-1]) / gaps[1:]) == pytest.approx([1.0, 1.0], abs=0.15)


def test_its_friction_changes_sign_with_the_reference() -> None:
    part = InverseDynamics(velocity_gain=3.0, acceleration_gain=0.5, friction=0.2, smoothing_velocity=1e-3)
    v = np.array([-0.05, -1e-3, 0.0, 2e-3, 0.05])
    found = run_alone(part, {"reference_velocity": v, "reference_acceleration": 4.0 * v})["command"]
    assert found == pytest.approx(5.0 * v + 0.2 * np.tanh(1e3 * v), rel=1e-12)
    assert part.linearize() is None
    assert part.replace(friction=0.0).linearize() is not None


# --- the zero-phase filter in operation ------------------------------------------------------------------------------------------------

FILTERS = [
    pytest.param((3.0, -2.2), (1.0, -0.2), 0, id="no-lead"),
    pytest.param((0.4, 2.0, -2.6, 0.9), (1.0, -0.5, 0.2), 2, id="lead-2"),
    pytest.param((2.0, -1.0), (1.0,), 7, id="lead-beyond-the-taps"),
    pytest.param((1.0, 0.5, -0.9), (2.0, -1.0, 0.1, -0.5), 1, id="scaled"),
]


@pytest.mark.parametrize(("numerator", "denominator", "lead"), FILTERS)
def test_the_shift_equals_the_filter_of_another_library(numerator: tuple[float, ...], denominator: tuple[float, ...], lead: int) -> None:
    """F r - r once the filter's memory is full and the fading complete; the reference rests for a while before it moves."""
    n, still = 400, 80
    r = 0.3 + np.concatenate([np.zeros(still), np.cumsum(np.cumsum(np.random.default_rng(1).normal(size=n - still))) * 1e-4])
    ahead = np.concatenate([r[lead:], np.full(lead, r[-1])])
    wanted = 0.3 + lfilter(numerator, denominator, ahead - 0.3) - r
    part = ZPETC(numerator=numerator, denominator=denominator, lead=float(lead))
    assert part.ahead(PERIOD) == lead
    found = run_alone(part, {"reference_ahead": ahead})["reference_shift"]
    assert not found[: still - lead].any()
    assert found == pytest.approx(wanted, abs=1e-12 * np.abs(wanted).max())


def test_the_shift_fades_in_if_the_reference_moves_at_once() -> None:
    """A steady speed from the first tick: zero until the memory is full, then a rise to the steady shift, never beyond it."""
    part = ZPETC(numerator=(11.0, -10.0), denominator=(1.0,), lead=4.0)
    shift = run_alone(part, {"reference_ahead": 1e-3 * (4.0 + np.arange(40))})["reference_shift"]
    memory = part.taps.size
    # F r of a ramp: r + (lead + 10) ticks of it.
    assert not shift[: memory - 1].any()
    assert (np.diff(shift) >= -1e-15).all()
    assert shift[2 * memory :] == pytest.approx(np.full(40 - 2 * memory, 14e-3), rel=1e-9)


def test_a_machine_at_rest_is_not_shifted() -> None:
    part = ZPETC(numerator=(3e6, -5.9e6, 2.900001e6), denominator=(1.0,), lead=1.0)
    assert not run_alone(part, {"reference_ahead": np.full(50, 0.4321)})["reference_shift"].any()


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"numerator": (2.0, -0.9)}, "numerator = .*sum 1.1"),
        ({"denominator": (1.0, -1.5, 1.5)}, "denominator"),
        ({"denominator": (0.0, 1.0)}, "d_0"),
        ({"denominator": (1.0, *(0.0,) * 9)}, "of order 8 or less"),
        ({"lead": 1.5}, "lead = 1.5: .*whole"),
        ({"numerator": ()}, "list"),
    ],
)
def test_an_invalid_filter_is_refused(changed: dict[str, Any], said: str) -> None:
    with pytest.raises(ParameterError, match=said):
        ZPETC(**{"numerator": (2.0, -1.0), "denominator": (1.0,), "lead": 1.0, **changed})


def test_the_filter_receives_its_look_ahead() -> None:
    """A pure lead of five ticks: the controllers receive the reference five ticks early, so the axis moves five ticks early."""
    axes = tuple(cl.Axis(name, make("plant", "rigid-axis", gain=1.8, damping=20.0)) for name in "xy")
    reference = cl.uniform(cl.contour("circle", radius=0.02), 1.0, 3, PERIOD)
    runs = []
    for part in (None, ZPETC(numerator=(1.0,), denominator=(1.0,), lead=5.0)):
        servo = cl.AxisController(PID(proportional_gain=900.0, derivative_gain=30.0), feedforward=part)
        runs.append(cl.simulate(cl.Machine("led", axes, PERIOD), cl.Controller(dict.fromkeys("xy", servo)), reference)["axis_position"])
    last = slice(2 * reference.n_sample // 3, reference.n_sample - 20)
    assert runs[1][last] == pytest.approx(runs[0][last.start + 5 : last.stop + 5], abs=1e-9)
    assert math.dist(runs[1][-400], runs[0][-400]) > 1e-4
