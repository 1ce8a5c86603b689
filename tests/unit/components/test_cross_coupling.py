"""Cross-coupled control: the scalar controller in the plane, parallel transport in space, limits, linear models."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, Array, make, run_alone
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import null_space
from scipy.signal import cont2discrete, lfilter, tf2ss

from contourlab.components.coupling.laws import carried, turning
from contourlab.errors import ParameterError

PID = {"gain": 7.0, "integral_rate": 40.0, "derivative_time": 4e-3, "derivative_filter": 1.5e-3}
FILTERS: list[tuple[list[float], list[float]]] = [
    ([2.5], [0.5]),
    ([0.3, 1.0], [0.02, 1.0]),
    ([4.0, 30.0], [1.0, 0.0]),
    ([1.0, 20.0, 900.0], [1.0, 60.0, 0.0]),
    ([5.0], [1e-4, 2e-2, 1.5, 40.0]),
    ([1.0, 2.0, 3.0, 4.0, 5.0], [1.0, 12.0, 60.0, 150.0, 180.0]),
]


def corrections(part: Any, error: Array, tangent: Array, **options: Any) -> Array:
    """Return the corrections (n_tick, n_axis)."""
    return run_alone(part, {"error_vector": error, "tangent": tangent}, **options)["correction"]


def wandering_plane(n: int = 400, seed: int = 1) -> tuple[Array, Array, Array]:
    """Return contour errors (n,), tangents and left normals (n, 2) of a path that turns by up to 2.8 rad a tick, either way."""
    rng = np.random.default_rng(seed)
    angle = np.cumsum(rng.uniform(-2.8, 2.8, n))
    tangent = np.column_stack([np.cos(angle), np.sin(angle)])
    return rng.standard_normal(n) * 1e-5, tangent, np.column_stack([-tangent[:, 1], tangent[:, 0]])


def scalar_pid(eps: Array, parts: dict[str, float], period: float = PERIOD) -> Array:
    """Return K (1 + k_i T z/(z - 1) + T_d/(T_f + T) (z - 1)/(z - T_f/(T_f + T))) applied to a record."""
    keep = parts["derivative_filter"] / (parts["derivative_filter"] + period)
    integral = lfilter([parts["integral_rate"] * period], [1.0, -1.0], eps)
    slope = lfilter(np.array([1.0, -1.0]) * parts["derivative_time"] / (parts["derivative_filter"] + period), [1.0, -keep], eps)
    return np.asarray(parts["gain"] * (eps + integral + slope))


def tustin(numerator: list[float], denominator: list[float], eps: Array) -> Array:
    """Return the record through SciPy's Tustin filter in state space: its polynomials in z lose digits."""
    a, b, c, d, _ = cont2discrete(tf2ss(numerator, denominator), PERIOD, "bilinear")
    x, found = np.zeros((len(a), 1)), []
    for value in eps:
        found.append((c @ x + d * value).item())
        x = a @ x + b * value
    return np.array(found)


# --- in the plane --------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("off", [(), ("integral_rate",), ("derivative_time",), ("integral_rate", "derivative_time")])
def test_in_the_plane_it_is_the_scalar_controller_along_the_normal(off: tuple[str, ...]) -> None:
    parts = PID | dict.fromkeys(off, 0.0)
    eps, tangent, normal = wandering_plane()
    found = corrections(make("coupling", "cross-coupled", **parts), eps[:, None] * normal, tangent)
    assert found == pytest.approx(scalar_pid(eps, parts)[:, None] * normal, abs=1e-15)


@pytest.mark.parametrize(("numerator", "denominator"), FILTERS)
def test_in_the_plane_the_filter_is_tustins_along_the_normal(numerator: list[float], denominator: list[float]) -> None:
    eps, tangent, normal = wandering_plane(seed=2)
    part = make("coupling", "cross-coupled-filter", gain=3.0, numerator=numerator, denominator=denominator)
    expected = 3.0 * tustin(numerator, denominator, eps)
    found = corrections(part, eps[:, None] * normal, tangent)
    assert found == pytest.approx(expected[:, None] * normal, abs=1e-11 * np.abs(expected).max())


def test_on_a_line_in_five_axes_each_row_is_filtered_by_itself() -> None:
    rng = np.random.default_rng(4)
    along = rng.standard_normal(5)
    along /= np.linalg.norm(along)
    across = null_space(along[None]) @ rng.standard_normal((4, 200)) * 1e-5
    tangent = np.tile(along, (200, 1))
    found = corrections(make("coupling", "cross-coupled", **PID), across.T, tangent)
    assert found == pytest.approx(np.column_stack([scalar_pid(row, PID) for row in across]), abs=1e-15)


def test_leading_zeros_and_a_common_factor_change_nothing() -> None:
    eps, tangent, normal = wandering_plane(50)
    one, other = (
        corrections(make("coupling", "cross-coupled-filter", numerator=num, denominator=den), eps[:, None] * normal, tangent)
        for num, den in (([0.3, 1.0], [0.02, 1.0]), ([0.0, 0.0, -0.6, -2.0], [0.0, -0.04, -2.0]))
    )
    assert one == pytest.approx(other, abs=1e-18)


def test_four_slow_poles_keep_their_digits_at_a_short_period() -> None:
    """Step response of 1/(s + 1)^4 against its closed form, to Tustin's T^2/12; a filter in powers of 1/z is off by 0.07 here."""
    period, n = 1e-4, 20_000
    part = make("coupling", "cross-coupled-filter", numerator=[1.0], denominator=[1.0, 4.0, 6.0, 4.0, 1.0])
    # The trapezoidal rule carries samples of a ramp exactly: its response has no error from the hold.
    t = np.arange(n) * period
    error, tangent = np.column_stack([np.zeros(n), t]), np.tile([1.0, 0.0], (n, 1))
    found = corrections(part, error, tangent, period=period, jit=True)[:, 1]
    # Ramp response of 1/(s + 1)^4: t - 4 + e^-t (4 + 3 t + t^2 + t^3/6).
    expected = t - 4.0 + np.exp(-t) * (4.0 + 3.0 * t + t**2 + t**3 / 6.0)
    assert np.abs(found - expected).max() < period**2


# --- in space ------------------------------------------------------------------------------------------------------------------------


def unit(vector: Array) -> Array:
    return vector / np.linalg.norm(vector)


VECTORS = st.lists(st.floats(-1.0, 1.0), min_size=3, max_size=6).filter(lambda v: sum(x * x for x in v) > 1e-2)


@given(first=VECTORS, seed=st.integers(0, 1000), turn=st.floats(0.0, math.pi))
def test_the_least_rotation_keeps_length_angle_and_the_normal_plane(first: list[float], seed: int, turn: float) -> None:
    """It rotates only the plane of both tangents, through any angle up to a reversal."""
    t0 = unit(np.array(first))
    plane = null_space(t0[None]) @ np.linalg.qr(np.random.default_rng(seed).standard_normal((len(first) - 1, 2)))[0]
    inward, vector = plane.T
    t1 = math.cos(turn) * t0 + math.sin(turn) * inward
    way = turning(tuple(t0.tolist()), tuple(t1.tolist()))
    seen = np.array(carried(tuple((2.0 * inward + 3.0 * vector).tolist()), tuple(t1.tolist()), way))
    sharp = 1.0 + math.cos(turn) < 1e-5
    if not sharp:
        assert seen == pytest.approx(2.0 * (math.cos(turn) * inward - math.sin(turn) * t0) + 3.0 * vector, abs=1e-9)
    assert np.linalg.norm(seen) == pytest.approx(math.sqrt(13.0), abs=1e-2 if sharp else 1e-9)
    assert seen @ t1 == pytest.approx(0.0, abs=1e-2 if sharp else 1e-9)


def test_where_the_path_turns_back_on_itself_the_states_stay() -> None:
    error = np.zeros((2, 3))
    error[0] = [0.0, 1e-3, 2e-3]
    tangent = np.array([[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]])
    found = corrections(make("coupling", "cross-coupled", gain=1.0, integral_rate=1.0), error, tangent)
    assert found[1] == pytest.approx([0.0, 1e-6, 2e-6], abs=1e-18)


@pytest.mark.parametrize("kind", ["cross-coupled", "cross-coupled-filter"])
def test_around_a_cone_of_tangents_the_integral_turns_by_the_solid_angle(kind: str) -> None:
    """Tangents go once around a cone of half angle a: the normal plane returns turned by 2 pi (1 - cos a)."""
    half, gaps = 0.7, []
    for n in (400, 800):
        angle = np.concatenate([[0.0], np.linspace(0.0, 2.0 * math.pi, n + 1)])
        side = np.full(n + 2, math.sin(half))
        tangent = np.column_stack([side * np.cos(angle), side * np.sin(angle), np.full(n + 2, math.cos(half))])
        first = np.array([math.cos(half), 0.0, -math.sin(half)])
        error = np.vstack([first, np.zeros((n + 1, 3))])
        shared = {"gain": 1.0} if kind == "cross-coupled-filter" else {"gain": 1.0, "integral_rate": 1.0}
        given = shared | ({"numerator": [1.0], "denominator": [1.0, 0.0]} if kind == "cross-coupled-filter" else {})
        last = corrections(make("coupling", kind, **given), error, tangent)[-1]
        second = np.array([0.0, 1.0, 0.0])
        turned = math.atan2(last @ second, last @ first)
        expected = 2.0 * math.pi * (1.0 - math.cos(half))
        gaps.append(abs(math.remainder(turned - expected, 2.0 * math.pi)))
        assert np.linalg.norm(last) == pytest.approx(PERIOD, rel=1e-12)
    assert gaps[0] < 1e-3
    assert gaps[0] / gaps[1] == pytest.approx(4.0, rel=0.02)


def test_the_integral_does_not_decay_in_three_hundred_thousand_ticks() -> None:
    n = 300_000
    angle = np.linspace(0.0, 600.0 * math.pi, n + 1)
    tangent = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(n + 1)])
    error = np.zeros((n + 1, 3))
    error[0] = [0.0, 1e-3, 2e-3]
    last = corrections(make("coupling", "cross-coupled", gain=1.0, integral_rate=1.0), error, tangent, jit=True)[-1]
    assert last == pytest.approx([0.0, 1e-6, 2e-6], abs=1e-15)


# --- limit ---------------------------------------------------------------------------------------------------------------------------


@given(seed=st.integers(0, 10_000), limit=st.floats(1e-6, 1e-2), gain=st.floats(0.0, 1e3))
def test_the_correction_keeps_its_limit_and_its_direction(seed: int, limit: float, gain: float) -> None:
    rng = np.random.default_rng(seed)
    error = rng.standard_normal((40, 3)) * 1e-4
    tangent = np.tile([0.0, 0.0, 1.0], (40, 1))
    error[:, 2] = 0.0
    found = corrections(make("coupling", "cross-coupled", gain=gain, integral_rate=30.0, limit=limit), error, tangent)
    assert np.linalg.norm(found, axis=1).max() <= limit * (1.0 + 1e-15)
    assert found[:, 2] == pytest.approx(0.0, abs=1e-18)


def test_a_held_integral_releases_at_once() -> None:
    """After one second at twice the limit a free integral needs as long to come down; a held one turns with the error."""
    n = 1000
    eps = np.concatenate([np.full(n, 2.0), np.full(n, -0.1)])
    error, tangent = np.column_stack([np.zeros(2 * n), eps]), np.tile([1.0, 0.0], (2 * n, 1))
    held = corrections(make("coupling", "cross-coupled", gain=1.0, integral_rate=5.0, limit=1.0), error, tangent)[:, 1]
    free = corrections(make("coupling", "cross-coupled", gain=1.0, integral_rate=5.0), error, tangent)[:, 1]
    assert (held[:n] == 1.0).all()
    assert held[n] == pytest.approx(-0.1 - 5.0 * PERIOD * 0.1, rel=1e-12)
    assert free[n] > 9.0


# --- linear models and refusals ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("numerator", "denominator"), FILTERS)
def test_the_model_of_the_filter_is_its_polynomials(numerator: list[float], denominator: list[float]) -> None:
    model = make("coupling", "cross-coupled-filter", gain=3.0, numerator=numerator, denominator=denominator).linear_controller()
    assert model.inputs == ("contour_error",) and model.outputs == ("correction",)
    for w in (0.3, 7.0, 900.0):
        s = 1j * w
        said = (model.c @ np.linalg.solve(s * np.eye(len(model.a)) - model.a, model.b.astype(complex)) + model.d)[0, 0]
        assert said == pytest.approx(3.0 * np.polyval(numerator, s) / np.polyval(denominator, s), rel=1e-10)


@pytest.mark.parametrize("off", [(), ("integral_rate",), ("derivative_time",), ("integral_rate", "derivative_time")])
def test_the_model_of_the_pid_is_the_limit_of_its_step(off: tuple[str, ...]) -> None:
    """Backward Euler is of first order: the difference halves with the period."""
    parts = PID | dict.fromkeys(off, 0.0)
    part = make("coupling", "cross-coupled", **parts)
    model = part.linear_controller()
    assert len(model.a) == 2 - len(off)
    w, gaps = 200.0, []
    for period in (1e-4, 5e-5):
        t = np.arange(round(0.4 / period)) * period
        found = corrections(
            part, np.column_stack([np.zeros(t.size), np.sin(w * t)]), np.tile([1.0, 0.0], (t.size, 1)), period=period, jit=True
        )
        # After the filter's transient: the response at w plus the constant from the start of the integral.
        late = t > 0.1
        basis = np.column_stack([np.sin(w * t), np.cos(w * t), np.ones(t.size)])[late]
        (real, imaginary, _), *_ = np.linalg.lstsq(basis, found[late, 1], rcond=None)
        said = (model.c @ np.linalg.solve(1j * w * np.eye(len(model.a)) - model.a, model.b.astype(complex)) + model.d)[0, 0]
        gaps.append(abs(complex(real, imaginary) - said) / abs(said))
    assert gaps[1] < 5e-3
    if len(off) < 2:
        assert gaps[0] / gaps[1] == pytest.approx(2.0, rel=0.1)
    else:
        assert max(gaps) < 1e-12


@pytest.mark.parametrize(
    ("numerator", "denominator", "words"),
    [
        ([1.0, 0.0, 0.0], [1.0, 2.0], "improper"),
        ([1.0], [0.0, 0.0], "than 0"),
        ([1.0], [1.0] * 6, "order 4"),
        ([1.0], [1.0, -3.0], "imaginary"),
        ([1.0], [1.0, 1.0, 1.0, 50.0], "imaginary"),
        ([1.0], [1e-300, 1.0, 1e300], "nearly 0"),
    ],
)
def test_invalid_settings_are_refused(numerator: list[float], denominator: list[float], words: str) -> None:
    with pytest.raises(ParameterError, match=words):
        make("coupling", "cross-coupled-filter", numerator=numerator, denominator=denominator)


def test_poles_on_the_imaginary_axis_are_accepted() -> None:
    """Integrators and undamped resonances: repetitive and resonant control need them."""
    for den in ([1.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 400.0], [1.0, 0.0, 800.0, 0.0, 160_000.0]):
        make("coupling", "cross-coupled-filter", numerator=[1.0], denominator=den)
