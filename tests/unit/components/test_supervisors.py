"""Supervisors alone: when they switch, when they do not, and the reasons they give."""

from __future__ import annotations

import numpy as np
import pytest
from component_rig import PERIOD, make, run_alone
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.errors import ParameterError


def test_motor_minus_load_decides_between_gap_and_contact() -> None:
    apart = np.array([0.0, 5.0, 9.9, 10.1, 12.0, 9.0, -9.0, -11.0]) * 1e-6
    out = run_alone(make("supervisor", "performance", thresholds=(10e-6,)), {"motor_position": apart})
    assert out["active"].tolist() == [1, 1, 1, 0, 0, 1, 1, 0]
    assert out["reason"].tolist() == [2, 0, 0, 1, 0, 2, 0, 1]


def test_a_threshold_has_a_hysteresis_either_way() -> None:
    rising = np.linspace(0.0, 20e-6, 201)
    course = np.concatenate([rising, rising[::-1]])
    part = make("supervisor", "performance", thresholds=(10e-6,), hysteresis=2e-6, order="rising")
    active = run_alone(part, {"motor_position": course})["active"]
    up, down = np.flatnonzero(np.diff(active))
    assert course[up + 1] == pytest.approx(12.1e-6) and course[down + 1] == pytest.approx(8.0e-6, abs=1.1e-7)


@given(st.lists(st.floats(-3e-5, 3e-5), min_size=30, max_size=120), st.integers(1, 12))
@settings(max_examples=40, deadline=None)
def test_two_switches_are_never_closer_than_the_dwell_time(course: list[float], ticks: int) -> None:
    part = make("supervisor", "performance", thresholds=(10e-6, 20e-6), dwell_time=(ticks - 0.5) * PERIOD)
    out = run_alone(part, {"motor_position": course})
    at = np.flatnonzero(out["reason"])
    assert (np.diff(at) >= ticks).all()
    changed = np.flatnonzero(np.diff(np.concatenate([[0.0], out["active"]])))
    assert changed.tolist() == at.tolist()
    assert set(out["active"]) <= {0.0, 1.0, 2.0}


def test_an_averaged_error_is_its_root_mean_square() -> None:
    part = make("supervisor", "performance", measure="tracking-error", thresholds=(6.5e-6,), order="rising", averaging_time=5e-3)
    wave = 10e-6 * np.sin(2.0 * np.pi * 100.0 * PERIOD * np.arange(400))  # 7.07 um rms
    active = run_alone(part, {"reference": wave})["active"]
    assert active[-100:].mean() > 0.5
    assert not run_alone(part, {"reference": 0.8 * wave})["active"].any()


def test_variants_with_and_without_an_average_share_the_step() -> None:
    with_average, without = (make("supervisor", "performance", thresholds=(1e-5,), averaging_time=time) for time in (5e-3, 0.0))
    assert with_average.make_step() == without.make_step()


def test_places_in_the_program_and_the_controller_before_the_first() -> None:
    part = make("supervisor", "pre-routed", places=(0.1, 0.2, 0.4), numbers=(2.0, 0.0, 1.0))
    out = run_alone(part, {"arc_length": np.array([0.0, 0.1, 0.15, 0.2, 0.39, 0.4, 9.0])})
    assert out["active"].tolist() == [0, 2, 2, 0, 0, 1, 1]
    part = make("supervisor", "pre-routed", by="line", lines=(12.0, 30.0), numbers=(1.0, 0.0))
    out = run_alone(part, {"source_line": np.array([0.0, 11.0, 12.0, 29.0, 30.0, 99.0, 13.0])})
    assert out["active"].tolist() == [0, 0, 1, 1, 0, 0, 1]


def test_an_uncertain_observer_keeps_the_controller_for_contact() -> None:
    fed = {"gap_state": np.array([1.0, 0.0, 0.0, 0.0, -1.0]), "confidence": np.array([0.9, 0.9, 0.3, 0.9, 0.9])}
    out = run_alone(make("supervisor", "estimator-based", confidence=0.5), fed)
    assert out["active"].tolist() == [0, 1, 0, 1, 0]
    assert out["reason"].tolist() == [0, 1, 3, 1, 2]


@pytest.mark.parametrize(
    ("kind", "parameters", "name"),
    [
        ("performance", {"thresholds": (2e-6, 1e-6)}, "thresholds"),
        ("pre-routed", {"places": (0.2, 0.1), "numbers": (1.0, 0.0)}, "places"),
        ("pre-routed", {"places": (0.1,), "numbers": (1.0, 0.0)}, "numbers"),
        ("pre-routed", {"places": (0.1,), "numbers": (0.5,)}, "numbers"),
    ],
)
def test_invalid_settings_are_refused_by_name(kind: str, parameters: dict[str, object], name: str) -> None:
    with pytest.raises(ParameterError) as caught:
        make("supervisor", kind, **parameters)
    assert caught.value.name == name
