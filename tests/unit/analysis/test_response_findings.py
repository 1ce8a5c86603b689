"""Implausible frequency responses of an axis."""

from __future__ import annotations

import numpy as np
import pytest

from contourlab.analysis.identification.drive_fit import held_response, linear_motor, two_inertia
from contourlab.analysis.identification.frequency_response import MeasuredResponse, response_findings

PERIOD = 1e-3
TWO = {"motor_mass": 4.0, "load_mass": 3.0, "stiffness": 2.4e5, "shaft_damping": 60.0, "damping": 40.0, "delay": 1e-3}


def codes(f: np.ndarray, h: np.ndarray, coherence: float = 1.0) -> list[str]:
    even = np.full(f.size, coherence)
    measured = MeasuredResponse(f, h, 0.01 * np.ones(f.size), even, "made", PERIOD, np.full(f.size, np.nan))
    return [one.code for one in response_findings(measured)]


AXES = {
    "mass": lambda s: linear_motor({"M": 7.0, "B": 0.0, "delay": 5e-4}, s),
    "mass with damping": lambda s: linear_motor({"M": 7.0, "B": 400.0}, s),
    "damping": lambda s: linear_motor({"M": 1e-3, "B": 400.0, "delay": 2e-3}, s),
    "two inertias": lambda s: two_inertia(TWO, s),
    "a spring holds it": lambda s: 1.0 / (7.0 * s * s + 40.0 * s + 7.0 * (2.0 * np.pi * 40.0) ** 2),
}


@pytest.mark.parametrize("f", [np.geomspace(1.0, 200.0, 60), np.linspace(2.0, 30.0, 15), np.array([4.0, 10.0, 30.0]), np.array([4.0])])
@pytest.mark.parametrize("axis", AXES)
def test_axes_are_distinguished_from_those_with_reversed_sign(axis: str, f: np.ndarray) -> None:
    if axis == "a spring holds it" and f.size < 4:
        return  # a few points do not distinguish a spring from a mass of reversed sign
    h = held_response(AXES[axis], f, PERIOD) * (1.0 + 0.02 * np.random.default_rng(f.size).standard_normal(f.size))
    assert codes(f, h) == []
    assert codes(f, -h) == ["CL509"]
    assert codes(f, -h, coherence=0.3) == []


@pytest.mark.parametrize("axis", ["mass", "mass with damping", "two inertias"])
def test_swapped_command_and_position(axis: str) -> None:
    f = np.geomspace(1.0, 200.0, 60)
    assert codes(f, 1.0 / held_response(AXES[axis], f, PERIOD)) == ["CL508"]
