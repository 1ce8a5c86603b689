"""An axis with a closed-form force is identified with valid deviations; unidentifiable parameters are reported."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from refusals import refuses

from contourlab.analysis.identification.inverse_dynamics import (
    InverseDynamicsFit,
    InverseDynamicsSettings,
    cross_validate,
    identify_inverse_dynamics,
)
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
PERIOD = 1e-3
SETTINGS = InverseDynamicsSettings(cutoff=60.0)
AXIS = {"M": 95.0, "Fv": 200.0, "Fc": 20.0, "offset": -3.0}
SLOW, QUICK = ((0.05, 0.31), (0.02, 1.3)), ((0.04, 0.43), (0.01, 2.1))
"""Motions as sums of sines: amplitude [m] and frequency [Hz]."""


def motion(sines: tuple[tuple[float, float], ...] = SLOW, n: int = 12_000) -> tuple[Array, Array, Array, Array]:
    """Return time, position, velocity and acceleration."""
    t = PERIOD * np.arange(n, dtype=np.float64)
    q, v, a = np.zeros((3, n))
    for amplitude, frequency in sines:
        w = 2.0 * math.pi * frequency
        q += amplitude * np.sin(w * t)
        v += amplitude * w * np.cos(w * t)
        a -= amplitude * w * w * np.sin(w * t)
    return t, q, v, a


def force_of(v: Array, a: Array, *, M: float, Fv: float, Fc: float, offset: float) -> Array:
    return M * a + Fv * v + Fc * np.sign(v) + offset


def found(noise: float = 0.0, settings: InverseDynamicsSettings = SETTINGS, **changed: float) -> InverseDynamicsFit:
    t, q, v, a = motion()
    force = force_of(v, a, **(AXIS | changed)) + noise * np.random.default_rng(3).normal(size=t.size)
    return identify_inverse_dynamics(t, q, force, settings)


def test_an_axis_is_identified() -> None:
    fit = found()
    assert fit.names == ("M", "Fv", "Fc", "offset")
    # Differences miss (w T)^2/3 of the acceleration at 1.3 Hz, 2e-5; sign(v) is wrong for part of a sample at the reversals.
    assert fit.parameters == pytest.approx(AXIS, rel=1e-3)
    assert fit["M"] == fit.values[0]
    assert fit.relative_error < 0.5 and fit.fit > 99.5 and fit.usable
    np.testing.assert_allclose(fit.force - fit.predicted, 0.0, atol=2.0 * AXIS["Fc"])


def test_friction_by_direction_is_identified() -> None:
    t, q, v, a = motion()
    forward = v > 0.0
    force = 95.0 * a + np.where(forward, 166.0 * v + 21.0, 240.0 * v - 19.0)
    fit = identify_inverse_dynamics(t, q, force, replace(SETTINGS, friction="asymmetric"))
    assert fit.parameters == pytest.approx({"M": 95.0, "Fv+": 166.0, "Fc+": 21.0, "Fv-": 240.0, "Fc-": 19.0}, rel=1e-3)
    alike = identify_inverse_dynamics(t, q, force, SETTINGS)
    assert alike.residual_norm > 5.0 * fit.residual_norm


def test_an_offset_appears_in_both_coulomb_forces() -> None:
    fit = found(settings=replace(SETTINGS, friction="asymmetric"))
    assert (fit["Fc+"] - fit["Fc-"]) / 2.0 == pytest.approx(AXIS["offset"], rel=2e-3)
    assert (fit["Fc+"] + fit["Fc-"]) / 2.0 == pytest.approx(AXIS["Fc"], rel=2e-3)


def test_figures_of_merit_match_their_definitions() -> None:
    fit = found(noise=4.0)
    left = fit.force - fit.predicted
    assert fit.residual_norm == pytest.approx(math.sqrt(float(left @ left)))
    assert fit.relative_error == pytest.approx(100.0 * fit.residual_norm / float(np.linalg.norm(fit.force)))
    assert fit.fit == pytest.approx(100.0 * (1.0 - fit.residual_norm / float(np.linalg.norm(fit.force - fit.force.mean()))))
    assert fit.relative_deviations == pytest.approx(100.0 * fit.deviations / np.abs(fit.values))
    assert np.diag(fit.correlation) == pytest.approx(1.0)
    assert fit.residual_deviation == pytest.approx(float(np.std(left, ddof=1)))
    published = found(noise=4.0, settings=replace(SETTINGS, lost_degrees=1))
    n = left.size
    assert published.deviations == pytest.approx(fit.deviations * math.sqrt((n - 4) / (n - 1)))


@pytest.mark.slow
def test_deviations_hold_over_two_hundred_noisy_records() -> None:
    """95 % of the true values lie within 1.96 deviations; with 800 counts this share has a deviation of 0.8 %."""
    t, q, v, a = motion(n=4000)
    clean = force_of(v, a, **AXIS)
    truth = np.array(list(AXIS.values()))
    inside = {"white": np.zeros(4), "robust": np.zeros(4)}
    noise = np.random.default_rng(11)
    for _ in range(200):
        # Without decimation the residual is as white as the noise; with it the plain deviations are too small.
        force = clean + 20.0 * noise.normal(size=t.size)
        white = identify_inverse_dynamics(t, q, force, replace(SETTINGS, decimation=1))
        robust = identify_inverse_dynamics(t, q, force, SETTINGS)
        inside["white"] += np.abs(white.values - truth) < 1.96 * white.deviations
        inside["robust"] += np.abs(robust.values - truth) < 1.96 * robust.robust_deviations
    for count in inside.values():
        assert 0.925 < count.mean() / 200.0 < 0.975
        assert (count / 200.0 > 0.89).all()


def test_an_unused_record_is_explained_too() -> None:
    fit = found(noise=2.0)
    t, q, v, a = motion(QUICK, n=9000)
    told = cross_validate(fit, t, q, force_of(v, a, **AXIS))
    assert told.relative_error < 1.0 and told.fit > 99.0
    assert told.force.size == told.predicted.size == told.time.size == 890
    heavier = cross_validate(fit, t, q, force_of(v, a, **(AXIS | {"M": 120.0})))
    left = 25.0 * a[50:-50]
    assert heavier.relative_error == pytest.approx(100.0 * np.linalg.norm(left) / np.linalg.norm(force_of(v, a, **AXIS)), rel=0.3)
    assert heavier.relative_error > 10.0 * told.relative_error


def test_encoder_counts_bias_the_mass_towards_zero_unless_filtered() -> None:
    t, q, v, a = motion()
    counted = 5e-6 * np.round(q / 5e-6)
    force = force_of(v, a, **AXIS)
    filtered, raw = (identify_inverse_dynamics(t, counted, force, replace(SETTINGS, cutoff=cutoff)) for cutoff in (40.0, 400.0))
    assert filtered["M"] == pytest.approx(AXIS["M"], rel=5e-3)
    one_by_one = identify_inverse_dynamics(t, counted, force, replace(SETTINGS, cutoff=400.0, decimation=1))
    assert one_by_one["M"] < 0.8 * AXIS["M"]
    assert one_by_one["M"] < raw["M"] < 1.01 * AXIS["M"]  # the filter before decimation preserves most of it


def test_the_unit_of_the_force_carries_through() -> None:
    """A force in volts gives parameters in volts."""
    t, q, v, a = motion()
    force = force_of(v, a, **AXIS)
    volts, newtons = (identify_inverse_dynamics(t, q, force / scale, SETTINGS) for scale in (35.15, 1.0))
    assert volts.values * 35.15 == pytest.approx(newtons.values, rel=1e-9)
    assert volts.relative_error == pytest.approx(newtons.relative_error, rel=1e-9)


@pytest.mark.parametrize(
    ("changed", "word"),
    [
        ({"time": PERIOD * np.arange(900)}, "position = shape"),
        ({"force": np.zeros(7)}, "force = shape"),
        ({"position": np.r_[np.nan, np.zeros(11_999)]}, "position = nan.* 0: "),
        ({"force": np.r_[np.zeros(11_999), np.inf]}, "force = inf.* 11999"),
        ({"time": (PERIOD * np.arange(12_000)) ** 2}, "evenly spaced"),
        ({"time": -PERIOD * np.arange(12_000)}, "rising"),
        ({"position": np.zeros(12_000)}, "moves"),
        ({"position": 0.1 * PERIOD * np.arange(12_000)}, "backwards"),
        ({"position": -0.1 * PERIOD * np.arange(12_000)}, "never forwards"),
        ({"force": np.full(12_000, 5.0)}, "drive"),
        ({"time": np.zeros((2, 3))}, "one record"),
    ],
)
def test_an_invalid_record_is_refused(changed: dict[str, Array], word: str) -> None:
    t, q, v, a = motion()
    record = {"time": t, "position": q, "force": force_of(v, a, **AXIS)} | changed
    with pytest.raises(ParameterError, match=word):
        identify_inverse_dynamics(**record, settings=SETTINGS)


def test_too_short_a_record_names_the_required_length() -> None:
    """A record of that length is accepted, even if the axis moves one way only."""
    t, q, v, a = motion()
    force = force_of(v, a, **AXIS)
    for n, word in ((290, "290 .*291"), (291, "backwards")):
        with pytest.raises(ParameterError, match=word):
            identify_inverse_dynamics(t[:n], q[:n], force[:n], SETTINGS)


@pytest.mark.parametrize(
    ("options", "word"),
    [
        ({"cutoff": 500.0}, "Nyquist"),
        ({"decimation": 0}, "decimation"),
    ],
)
def test_settings_out_of_range_are_refused(options: dict[str, object], word: str) -> None:
    with pytest.raises(ParameterError, match=word):
        found(settings=replace(SETTINGS, **options))  # type: ignore[arg-type]


def test_a_negative_mass_or_friction_is_never_returned() -> None:
    t, q, v, a = motion()
    force = force_of(v, a, **AXIS)
    with refuses(ParameterError, name="M", value="-95 kg"):
        identify_inverse_dynamics(t, q, -force, SETTINGS)
    with refuses(ParameterError, name="Fc", value="-8 N"):
        found(Fc=-8.0)
    with refuses(ParameterError, name="Fc", value="-8 N"):
        found(Fc=-8.0, settings=replace(SETTINGS, friction="asymmetric"))


def test_an_optional_friction_below_zero_is_marked_unusable() -> None:
    fits = [found(noise=30.0, Fc=fc) for fc in np.linspace(-0.6, 0.6, 9)]
    below = [fit for fit in fits if fit["Fc"] < 0.0]
    assert below and len(below) < len(fits)
    for fit in below:
        assert not fit.usable and "CL530" in {one.code for one in fit.findings}


def test_gravity_is_not_identified_as_negative_friction() -> None:
    fit = found(offset=100.0, settings=replace(SETTINGS, friction="asymmetric"))
    assert fit["Fc-"] == pytest.approx(-80.0, rel=1e-2)
    assert fit.usable and "CL531" in {one.code for one in fit.findings}


def test_friction_that_falls_with_speed_is_marked_unusable() -> None:
    fit = found(Fv=-30.0)
    assert not fit.usable and "CL530" in {one.code for one in fit.findings}


@pytest.mark.parametrize("seed", range(6))
def test_a_poorly_excited_mass_is_refused_or_marked(seed: int) -> None:
    """One speed there and back under a low cut-off: the rest of the acceleration drowns in the force noise."""
    t = PERIOD * np.arange(12_000)
    way = np.where((t // 1.5) % 2 == 0, 1.0, -1.0)
    force = 24.0 * way + 60.0 * np.random.default_rng(seed).normal(size=t.size)
    try:
        fit = identify_inverse_dynamics(t, 0.02 * PERIOD * np.cumsum(way), force, replace(SETTINGS, cutoff=5.0))
    except ParameterError as error:
        assert error.name == "M" and str(error.value).startswith("-") and "hardly" in error.bound
    else:
        assert not fit.usable
        assert ("CL526", "M") in {(one.code, one.place) for one in fit.findings}


def test_parameters_that_one_speed_cannot_separate_are_named() -> None:
    """Without the rows at the reversals only one speed remains, so v and sign(v) are one column."""
    t = PERIOD * np.arange(4000)
    way = np.where((t // 0.5) % 2 == 0, 1.0, -1.0)
    whole = InverseDynamicsSettings(cutoff=499.99999, order=1, decimation=1, dropped=(0, 0), slowest=0.049)
    with pytest.raises(ParameterError, match=r"\bFv\b.*\bFc\b"):
        identify_inverse_dynamics(t, 0.05 * PERIOD * np.cumsum(way), 20.0 * way + 3.0, whole)


def test_rest_is_reported_and_left_out_on_request() -> None:
    t, q, v, a = motion()
    stop = int(np.flatnonzero(np.diff(np.sign(v[7000:])))[0]) + 7000
    q, v, a = (np.where(t > t[stop], held, values) for held, values in ((q[stop], q), (0.0, v), (0.0, a)))
    q += 1e-8 * np.random.default_rng(2).normal(size=t.size)
    force = np.where(t > t[stop], 11.0, force_of(v, a, **AXIS))  # any force up to Coulomb friction holds
    whole = identify_inverse_dynamics(t, q, force, SETTINGS)
    assert "CL536" in {one.code for one in whole.findings}
    moving = identify_inverse_dynamics(t, q, force, replace(SETTINGS, slowest=5e-3))
    assert "CL536" not in {one.code for one in moving.findings}
    assert moving["offset"] == pytest.approx(AXIS["offset"], abs=0.2)
    assert abs(whole["offset"] - AXIS["offset"]) > 1.0


def test_a_force_of_another_quantity_is_reported() -> None:
    t, q, v, a = motion()
    ripple = 150.0 * np.sin(2.0 * math.pi * q / 4e-3)
    fit = identify_inverse_dynamics(t, q, force_of(v, a, **AXIS) + ripple, SETTINGS)
    assert "CL533" in {one.code for one in fit.findings}


def test_a_coloured_residual_widens_the_robust_deviations() -> None:
    t, q, v, a = motion()
    slow = 3.0 * np.sin(2.0 * math.pi * 0.17 * t + 0.4)
    fit = identify_inverse_dynamics(t, q, force_of(v, a, **AXIS) + slow, SETTINGS)
    assert "CL535" in {one.code for one in fit.findings}
    assert fit.robust_deviations.max() > fit.deviations.max()
    assert (np.abs(fit.values - list(AXIS.values())) < 4.0 * fit.robust_deviations + 1e-3 * np.abs(fit.values)).all()
