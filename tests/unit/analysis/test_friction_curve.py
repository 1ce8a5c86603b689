"""Segments of constant speed are found, and friction models are selected from them correctly."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from refusals import refuses

from contourlab.analysis.identification.friction import constant_speed_stretches, fit_friction
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
SPEEDS = np.array([1, 2, 4, 8, 15, 30, 60, 100, 150, 200]) * 1e-3
BOTH = np.r_[SPEEDS, -SPEEDS]
SPREAD = 0.003


def noisy(u: Array, seed: int = 0) -> Array:
    return u + SPREAD * np.random.default_rng(seed).normal(size=u.size)


def stribeck(v: Array, drop: float = 0.25, vs: float = 0.01) -> Array:
    return np.sign(v) * (0.3 + drop * np.exp(-((v / vs) ** 2))) + 2.0 * v - 0.02


def test_there_and_back_gives_two_segments() -> None:
    """A triangle wave with settling and ripple: one segment each way, with known speed and mean."""
    period = 1e-3
    t = period * np.arange(6000)
    reference = np.interp(t, [0.0, 0.5, 2.5, 4.5, 6.0], [0.0, 0.0, 0.1, 0.0, 0.0])
    position = reference + 2e-4 * np.exp(-10.0 * np.abs(t - 2.5)) + 1e-4 * np.sin(2 * np.pi * reference / 0.01)
    command = 0.4 * np.sign(np.gradient(reference)) + 0.05 * np.sin(2 * np.pi * reference / 0.01)
    for asked in (reference, None):
        found = sorted(constant_speed_stretches(period, position, command, asked, source="log"), key=lambda s: s.speed)
        assert [round(s.speed, 4) for s in found] == pytest.approx([-0.05, 0.05], rel=0.02)
        assert [s.command for s in found] == pytest.approx([-0.4, 0.4], abs=0.012)
        assert all(s.scatter == pytest.approx(0.05 / np.sqrt(2.0), rel=0.1) and s.source == "log" for s in found)
        assert all(s.count > 1000 for s in found)


def test_a_motion_without_constant_speed_has_no_segment() -> None:
    t = 1e-3 * np.arange(4000)
    place = 0.05 * np.sin(2.0 * np.pi * 0.5 * t)
    assert constant_speed_stretches(1e-3, place, place, place) == []
    assert constant_speed_stretches(1e-3, np.zeros(4000), place) == []
    with refuses(ParameterError, "finite", name="position", value="nan at sample 1001"):
        constant_speed_stretches(1e-3, np.where(t > 1.0, np.nan, place), place)


@pytest.mark.parametrize(
    ("law", "name", "true"),
    [
        (lambda v: 0.3 * np.sign(v) + 0.05, "Coulomb", {"Fc": 0.3, "offset": 0.05}),
        (lambda v: 0.3 * np.sign(v) + 2.0 * v, "Coulomb and viscous", {"Fc": 0.3, "Fv": 2.0, "offset": 0.0}),
        (
            lambda v: np.where(v > 0.0, 0.3 + 2.0 * v, -0.4 + 3.0 * v),
            "Coulomb and viscous by direction",
            {"Fc+": 0.3, "Fv+": 2.0, "Fc-": 0.4, "Fv-": 3.0},
        ),
        (stribeck, "Coulomb, viscous and Stribeck", {"Fc": 0.3, "Fv": 2.0, "drop": 0.25, "offset": -0.02, "vs": 0.01}),
    ],
)
def test_the_friction_model_is_recognised(law, name, true) -> None:  # type: ignore[no-untyped-def]
    fit = fit_friction(BOTH, noisy(law(BOTH)), np.full(BOTH.size, SPREAD))
    assert fit.chosen.model.name == name and fit.usable
    for parameter, value in true.items():
        assert abs(fit.chosen[parameter] - value) < 4.0 * fit.chosen.deviation(parameter), parameter
    assert fit.chosen.fit > 95.0 and fit.findings[0].values["model"] == name
    np.testing.assert_allclose(fit.chosen.at(BOTH), fit.chosen.predicted, atol=1e-12)


@pytest.mark.slow
def test_viscous_friction_gives_no_coulomb_friction() -> None:
    """AICc accepts a superfluous parameter with a probability of about one in ten."""
    fits = [fit_friction(BOTH, noisy(4.0 * BOTH + 0.05, seed), np.full(BOTH.size, SPREAD)) for seed in range(20)]
    plain = [fit for fit in fits if fit.chosen.model.name == "viscous"]
    assert len(plain) >= 15
    for fit in plain:
        assert fit.usable and "CL528" in {one.code for one in fit.findings}
        assert abs(fit.chosen["Fv"] - 4.0) < 4.0 * fit.chosen.deviation("Fv") and "Fc" not in fit.chosen.names


@pytest.mark.parametrize("speeds", [[50, 100, 200], [50, 100, 150, 200], [-50, -100, -200]])
def test_three_speeds_in_one_direction_give_a_line(speeds: list[float]) -> None:
    v = 1e-3 * np.array(speeds)
    fit = fit_friction(v, noisy(0.3 * np.sign(v) + 2.0 * v), np.full(v.size, SPREAD))
    assert fit.chosen.model.name == "Coulomb and viscous" and fit.usable and fit.chosen.fit > 90.0
    assert abs(fit.chosen["Fv"] - 2.0) < 5.0 * fit.chosen.deviation("Fv")
    assert not any("nan" in one.text or "inf" in one.text for one in fit.findings)


def test_without_slow_runs_there_is_no_stribeck_claim() -> None:
    """The dip lies below 20 mm/s: runs above 60 mm/s make no claim about it, and the lowest speed is reported."""
    fast = BOTH[np.abs(BOTH) >= 0.06]
    fast = np.r_[fast, 0.9 * fast]
    fit = fit_friction(fast, noisy(stribeck(fast)), np.full(fast.size, SPREAD))
    assert not fit.chosen.model.stribeck
    (slowest,) = (one.values["speed"] for one in fit.findings if one.code == "CL548")
    assert slowest == pytest.approx(0.054)


def test_a_concave_curve_is_reported_as_concave() -> None:
    fit = fit_friction(BOTH, noisy(stribeck(BOTH, -0.15, 0.05)), np.full(BOTH.size, SPREAD))
    assert fit.chosen["drop"] == pytest.approx(-0.15, abs=0.03)
    assert "CL546" in {one.code for one in fit.findings}


def test_scatter_between_runs_is_separated_from_scatter_within() -> None:
    u = 0.3 * np.sign(BOTH) + 2.0 * BOTH + 0.02 * np.random.default_rng(3).normal(size=BOTH.size)
    fit = fit_friction(BOTH, u, np.full(BOTH.size, 1e-4))
    assert 0.01 < fit.chosen.scatter < 0.03
    assert abs(fit.chosen["Fc"] - 0.3) < 4.0 * fit.chosen.deviation("Fc")


@pytest.mark.slow
def test_deviations_are_correct_over_many_sets_of_runs() -> None:
    inside = 0
    for seed in range(30):
        v = BOTH[::2]
        u = 0.3 * np.sign(v) + 2.0 * v + 0.02 * np.random.default_rng(seed).normal(size=v.size)
        curve = next(c for c in fit_friction(v, u, np.full(v.size, 1e-4)).tried if c.model.name == "Coulomb and viscous")
        inside += abs(curve["Fv"] - 2.0) < 2.0 * curve.deviation("Fv")
    assert 24 <= inside <= 30


def test_invalid_friction_data_are_refused() -> None:
    u = 0.3 * np.sign(BOTH) + 2.0 * BOTH
    spread = np.full(BOTH.size, SPREAD)
    with refuses(ParameterError, "against", name="command"):
        fit_friction(BOTH, -u, spread)
    with refuses(ParameterError, r"\b3\b", name="speed"):
        fit_friction(BOTH[:2], u[:2], spread[:2])
    with refuses(ParameterError, "finite", name="speed"):
        fit_friction(BOTH, np.where(BOTH > 0.1, np.nan, u), spread)
    one_way = fit_friction(SPEEDS, noisy(0.3 + 2.0 * SPEEDS), spread[: SPEEDS.size])
    assert "CL544" in {one.code for one in one_way.findings}
