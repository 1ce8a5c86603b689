"""Position loops from commanded and actual position: parameters are those of loops simulated by other means, within their deviations."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from reference_data import reference_file
from scipy.signal import cont2discrete, lfilter

import contourlab as cl
from contourlab.errors import ResultError
from contourlab.features.identify.options import Identify
from contourlab.features.identify.position_loop import LoopModel, fit_loop, fit_terms, identify_position_loop, reverses
from contourlab.features.identify.records import AxisRecord

Array = NDArray[np.float64]
PERIOD = 1e-3
NOISE = 1e-6
"""Far above the 6 nm by which a simulation in steps differs from the exact one."""
TO_AND_FRO = (0.05, -0.02, 0.03, -0.06)
CASES: dict[str, dict[str, float]] = {
    "no feedforward": {"Kv": 25.0, "delay": 0.0033},
    "lag": {"Kv": 25.0, "delay": 0.0033, "lag": 0.002},
    "feedforward and lag": {"Kv": 30.0, "delay": 0.0054, "velocity_feedforward": 0.8, "lag": 0.004},
    "feedforward and resonance": {
        "Kv": 30.0,
        "delay": 0.0054,
        "velocity_feedforward": 0.9,
        "resonance": 35.0,
        "resonance_damping": 0.25,
    },
}
TERMS = {
    "no feedforward": (),
    "lag": ("lag",),
    "feedforward and lag": ("feedforward", "lag"),
    "feedforward and resonance": ("feedforward", "resonance"),
}


def moves(ways: tuple[float, ...] = TO_AND_FRO, seconds: tuple[float, ...] = (0.4, 0.25, 0.6, 0.35)) -> Array:
    """Return moves of least jerk one after another, with rests between them."""
    parts = [np.zeros(100)]
    for way, time in zip(ways, seconds, strict=False):
        u = np.linspace(0.0, 1.0, round(time / PERIOD))
        parts += [parts[-1][-1] + way * (10.0 * u**3 - 15.0 * u**4 + 6.0 * u**5)]
        parts += [np.full(150, parts[-1][-1])]
    return np.concatenate(parts)


def followed(reference: Array, x: dict[str, float], seed: int = 0, noise: float = NOISE) -> Array:
    """Return measured positions: transfer functions for ramps between the samples, and the delay by interpolation."""

    def through(above: list[float], below: list[float], u: Array) -> Array:
        (b,), a, _ = cont2discrete((np.trim_zeros(above, "f"), below), PERIOD, "foh")
        return np.asarray(lfilter(b, a, u - u[0]) + u[0])

    # The fastest velocity loop that the model has.
    y = through([x.get("velocity_feedforward", 0.0), x["Kv"]], [x.get("lag", 0.25 * PERIOD), 1.0, x["Kv"]], reference)
    if "resonance" in x:
        w = 2.0 * math.pi * x["resonance"]
        y = through([w * w], [1.0, 2.0 * x["resonance_damping"] * w, w * w], y)
    sample = np.arange(y.size, dtype=float)
    return np.interp(sample - x["delay"] / PERIOD, sample, y, left=y[0]) + noise * np.random.default_rng(seed).standard_normal(y.size)


def record(reference: Array, position: Array, axis: str = "x") -> AxisRecord:
    return AxisRecord("log", axis, PERIOD, position, None, "", reference, None)


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_parameters_are_found_within_their_deviations(case: str) -> None:
    """Of normal errors 68 % are within one deviation and 95 % within two; deviations are the largest of several: at least so many are."""
    true, reference, away = CASES[case], moves(), []
    for seed in range(30):
        rung = fit_terms(LoopModel(record(reference, followed(reference, true, seed)), TERMS[case]))
        away += [(value - true[name]) / deviation for name, value, deviation in rung.known]
    shares = np.abs(away)
    assert np.mean(shares < 1.0) >= 0.6 and np.mean(shares < 2.0) >= 0.9
    assert np.sqrt(np.mean(shares**2)) > 0.4  # nor are they so wide that they say nothing


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_the_terms_are_found(case: str) -> None:
    for seed in range(3):
        best, _ = fit_loop(record(moves(), followed(moves(), CASES[case], seed)))
        assert set(best.model.terms) == set(TERMS[case])


@pytest.mark.slow
def test_friction_is_seen_at_reversals() -> None:
    true = {"Kv": 40.0, "delay": 0.0035, "velocity_feedforward": 0.9, "friction_offset": 4e-6}
    reference = moves()
    exact = LoopModel(record(reference, reference), ("feedforward", "friction")).positions([true])[0]
    noise = 2e-7 * np.random.default_rng(1).standard_normal(reference.size)
    best, _ = fit_loop(record(reference, exact + noise))
    assert "friction" in best.model.terms
    for name, value, deviation in best.known:
        assert abs(value - true[name]) < 3.0 * deviation < 0.3 * true[name]


@pytest.mark.parametrize("delay", [pytest.param(PERIOD, marks=pytest.mark.slow), 0.0033])
def test_full_feedforward_is_seen(delay: float) -> None:
    """It is at the bound of the search, where it has no deviation."""
    true = {"Kv": 30.0, "delay": delay, "velocity_feedforward": 1.0, "lag": 0.002}
    best, _ = fit_loop(record(moves(), followed(moves(), true)))
    assert best.model.terms == ("feedforward", "lag") and best.left_out < 0.01
    assert best.fit.parameters == pytest.approx(true, rel=0.01)


@pytest.mark.slow
def test_without_a_reversal_there_is_no_friction_but_a_finding() -> None:
    one_way = moves((0.05, 0.02, 0.03))
    assert not reverses(record(one_way, one_way))
    answer = identify_position_loop([record(one_way, followed(one_way, CASES["no feedforward"]))], Identify())
    assert answer.usable
    assert "CL593" in {doubt.code for doubt in answer.findings}
    assert "friction_offset" not in answer.parameters


def test_one_speed_determines_nothing() -> None:
    steady = 0.02 * PERIOD * np.arange(1500)
    late = steady - 0.02 * 0.04 + NOISE * np.random.default_rng(0).standard_normal(1500)
    answer = identify_position_loop([record(steady, late)], Identify())
    assert not answer.usable and not answer.tables
    assert "CL591" in {doubt.code for doubt in answer.findings}


def test_a_position_of_the_wrong_sign_is_refused() -> None:
    reference = moves()
    with pytest.raises(ResultError, match="does not follow"):
        identify_position_loop([record(reference, -followed(reference, CASES["lag"]))], Identify())


def test_a_constant_of_the_encoder_changes_nothing() -> None:
    reference = moves()
    position = followed(reference, CASES["lag"])
    plain, shifted = (fit_terms(LoopModel(record(reference, position + by), ("lag",))).fit.parameters for by in (0.0, 2e-3))
    assert shifted == pytest.approx(plain, rel=1e-6)


def test_much_noise_widens_the_deviations_only() -> None:
    reference, true = moves(), CASES["no feedforward"]
    quiet, loud = (fit_terms(LoopModel(record(reference, followed(reference, true, noise=noise)))) for noise in (1e-6, 3e-5))
    for rung in (quiet, loud):
        assert all(abs(value - true[name]) < 4.0 * deviation for name, value, deviation in rung.known)
    assert dict(zip(loud.fit.names, loud.fit.robust_deviations, strict=True))["Kv"] > 5.0 * quiet.fit.deviation("Kv")


def test_a_position_that_is_the_reference_shows_no_loop() -> None:
    with pytest.raises(ResultError):
        identify_position_loop([record(moves(), moves())], Identify())


def test_a_validation_at_rest_is_refused() -> None:
    reference = moves()
    rest = np.zeros(500)
    with pytest.raises(ResultError):
        identify_position_loop([record(reference, followed(reference, CASES["lag"])), record(rest, rest)], Identify())


def test_a_loop_sampled_slowly() -> None:
    """The gain where a search begins is within its bounds, and can be simulated."""
    reference, period = moves(), 0.25
    asked = AxisRecord("log", "x", period, reference, None, "", reference, None)
    true = {"Kv": 0.8, "delay": 0.4}
    exact = LoopModel(asked).positions([true])[0]
    noise = NOISE * np.random.default_rng(0).standard_normal(exact.size)
    answer = identify_position_loop([replace(asked, position=exact + noise)], Identify())
    assert {name: part.value for name, part in answer.parameters.items()} == pytest.approx(true, rel=0.02)


@pytest.mark.slow
def test_what_stays_in_a_prediction_is_told() -> None:
    """The fit leaves a constant to the encoder; the prediction does not."""
    reference = moves()
    shifted = followed(reference, CASES["no feedforward"]) + 0.01
    answer = identify_position_loop([record(reference, shifted)], Identify())
    assert answer.usable and "CL594" in {doubt.code for doubt in answer.findings}


@pytest.mark.slow
def test_a_term_that_predicts_better_is_not_said_to_be_absent() -> None:
    """A loop without delay: its best feedforward has a lag at its bound, and is left out."""
    time = PERIOD * np.arange(3000)
    reference = 0.05 * np.cos(math.pi * time)
    share = math.exp(-PERIOD / 0.021)
    position = reference[0] + lfilter([0.0, 1.0 - share], [1.0, -share], reference - reference[0])
    answer = identify_position_loop([record(reference, np.asarray(position))], Identify())
    told = [doubt.values for doubt in answer.findings if doubt.code == "CL592"]
    assert told and all(one["left"] >= one["without"] for one in told)


STRETCHES = {"first": "0..1493", "second": "1494.."}
MOST = {"Y1": (0.005, 0.005), "SP1": (0.04, 0.04), "X1": (0.04, 0.08)}
"""Share of the following error that may stay on the other stretch, by the stretch that is fitted."""


@pytest.mark.slow
@pytest.mark.parametrize("stretch", STRETCHES)
@pytest.mark.parametrize("axis", MOST)
def test_a_loop_of_a_production_machine_predicts_another_stretch(axis: str, stretch: str) -> None:
    file, other = reference_file("data/sinumerik/capture-840d.json"), "second" if stretch == "first" else "first"
    answer = cl.identify(file, axis=axis, validation=file, window=[STRETCHES[stretch], STRETCHES[other]])
    assert answer.model == "position-loop" and answer.usable
    assert answer.details["runs"][1]["axes"][axis]["stays"] < 0.5 * MOST[axis][list(STRETCHES).index(stretch)]
