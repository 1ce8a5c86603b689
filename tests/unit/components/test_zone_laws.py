"""The laws for contact and gap against eqs (10) and (12)-(16) of Shahin, ElMaraghy & ElBeheiry, written out by hand."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, make, run_alone
from hypothesis import given, settings
from hypothesis import strategies as st

J_M, LEAD, GAP = 5.2e-3, 0.016, 25e-6
TURN = 2.0 * math.pi / LEAD
COMMON = {"motor_inertia": J_M, "lead": LEAD, "backlash_gap": GAP}
BETA = 0.5 * GAP * TURN
NAMES = ("reference", "reference_velocity", "reference_acceleration", "motor_position", "motor_velocity", "load_position", "load_velocity")
SIZES = (1e-2, 0.1, 1.0, 1e-2, 0.1, 1e-2, 0.1)
SIGNALS = st.tuples(*(st.floats(-size, size) for size in SIZES))


def once(kind: str, signals: tuple[float, ...], **parameters: Any) -> float:
    """Return the command of the first tick."""
    part = make("controller", kind, **COMMON, **parameters)
    return float(run_alone(part, {name: [value] for name, value in zip(NAMES, signals, strict=True)})["command"][0])


def flank(apart: float) -> float:
    return math.copysign(1.0, apart) if apart else 0.0


@given(SIGNALS)
@settings(max_examples=60, deadline=None)
def test_types_one_and_two_are_eqs_10_and_12(signals: tuple[float, ...]) -> None:
    r, v, a, pm, vm, pl, _ = signals
    rate, off = TURN * (vm - v), TURN * (pm - r) - flank(pm - pl) * BETA
    one = J_M * (TURN * a - 1e4 * rate - 2e3 * off)
    two = J_M * TURN * a - 1000.0 * rate - 200.0 * off
    assert once("contact-zone-1", signals, rate_gain=1e4, position_gain=2e3) == pytest.approx(one, rel=1e-12, abs=1e-9)
    for kind in ("contact-zone-2", "gap-zone-2"):
        assert once(kind, signals, rate_gain=1000.0, position_gain=200.0) == pytest.approx(two, rel=1e-12, abs=1e-9)


@given(SIGNALS)
@settings(max_examples=60, deadline=None)
def test_gap_law_one_follows_the_load_as_printed_or_the_reference_as_intended(signals: tuple[float, ...]) -> None:
    r, v, a, pm, vm, pl, vl = signals
    half = flank(pm - pl) * BETA
    # The load's acceleration is the difference of its velocity, zero before the first tick.
    load = J_M * (TURN * vl / PERIOD - 1e4 * TURN * (vm - vl) - 2e3 * (TURN * (pm - pl) - half))
    meant = J_M * (TURN * a - 1e4 * TURN * (vm - v) - 2e3 * (TURN * (pm - r) - half))
    gains = {"rate_gain": 1e4, "position_gain": 2e3}
    assert once("gap-zone-1", signals, **gains, target="load") == pytest.approx(load, rel=1e-12, abs=1e-9)
    assert once("gap-zone-1", signals, **gains) == pytest.approx(meant, rel=1e-12, abs=1e-9)


def test_as_printed_the_half_gap_is_in_the_rate_term_too() -> None:
    signals = (0.0, 0.0, 0.0, 1e-3, 0.0, 0.0, 0.0)
    gains = {"rate_gain": 1000.0, "position_gain": 200.0}
    apart = once("contact-zone-2", signals, **gains, reading="literal") - once("contact-zone-2", signals, **gains)
    assert apart == pytest.approx(1000.0 * BETA)


@pytest.mark.parametrize("kind", ["contact-zone-3", "gap-zone-3"])
def test_type_three_integrates_the_distance_from_the_reference_or_from_the_flank(kind: str) -> None:
    gains = {"rate_gain": 0.0, "position_gain": 0.0, "integral_gain": 25.0, "anti_windup": "none"}
    n = 40
    fed = {"reference": np.full(n, 2e-4), "motor_position": np.full(n, 5e-4)}
    for where, distance in (("reference", TURN * 3e-4), ("flank", TURN * 3e-4 - BETA)):
        command = run_alone(make("controller", kind, **COMMON, **gains, integral_of=where), fed)["command"]
        assert command == pytest.approx(-25.0 * distance * PERIOD * np.arange(1, n + 1), rel=1e-9)


def test_an_inactive_integral_tracks_the_accepted_command() -> None:
    gains = {"rate_gain": 0.0, "position_gain": 0.0, "integral_gain": 25.0, "tracking_time": 0.01}
    n = 200
    fed = {"reference": np.full(n, 1e-3), "accepted": np.full(n, 0.7)}
    command = run_alone(make("controller", "contact-zone-3", **COMMON, **gains), fed)["command"]
    # It settles where the tracking per tick equals the rise of the integral.
    rest = 25.0 * TURN * 1e-3 * PERIOD / -math.expm1(-PERIOD / 0.01)
    assert command[-1] == pytest.approx(0.7 + rest, rel=1e-3)


def test_the_reference_selects_the_flank_and_zero_keeps_it() -> None:
    gains = {"rate_gain": 0.0, "position_gain": 200.0}
    told = np.array([0.0, 1.0, 0.0, -2.0, 0.0, 0.0])
    for direction, port in (("velocity", "reference_velocity"), ("acceleration", "reference_acceleration")):
        part = make("controller", "contact-zone-2", **COMMON, **gains, direction=direction)
        command = run_alone(part, {port: told})["command"]
        forward = J_M * TURN * told if port == "reference_acceleration" else 0.0
        assert command - forward == pytest.approx(200.0 * BETA * np.array([0.0, 1.0, 1.0, -1.0, -1.0, -1.0]))


def test_an_observed_gap_overrides_the_parameter() -> None:
    gains = {"rate_gain": 0.0, "position_gain": 200.0}
    fed = {"motor_position": np.full(3, 1e-9), "gap_estimate": np.array([0.0, 40e-6, 0.0])}
    command = run_alone(make("controller", "contact-zone-2", **COMMON, **gains), fed)["command"]
    assert command == pytest.approx(100.0 * TURN * np.array([GAP, 40e-6, GAP]), rel=1e-3)


def test_design_specifications_place_the_poles_of_a_rigid_drive() -> None:
    wishes = {"inertia": 9.6e-3, "natural_frequency": 80.0, "damping": 0.9, "pole": 20.0}
    gains = make("controller", "contact-zone-3", **COMMON, rate_gain=1.0, position_gain=1.0, integral_gain=1.0).designed(wishes, 1.0, 0.0)
    poles = np.roots([9.6e-3, gains["rate_gain"], gains["position_gain"], gains["integral_gain"]])
    wanted = np.roots(np.polymul([1.0, 2.0 * 0.9 * 80.0, 80.0**2], [1.0, 20.0]))
    assert np.sort_complex(poles) == pytest.approx(np.sort_complex(wanted))
