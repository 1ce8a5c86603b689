"""Data that cannot be reported are refused with a reason."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from contourlab.errors import ParameterError
from contourlab.rendering.run_data import AxisBounds, FrequencyResponse


def test_no_scheme(circle):
    with pytest.raises(ParameterError, match="schemes"):
        replace(circle, schemes=())


def test_two_schemes_of_one_name(circle):
    with pytest.raises(ParameterError, match="unique names"):
        replace(circle, schemes=(circle.schemes[0], circle.schemes[0]))


def test_schemes_of_different_axes(circle):
    second = circle.schemes[1]
    other = replace(second, result=replace(second.result, axes=("u", "v")))
    with pytest.raises(ParameterError, match="axes"):
        replace(circle, schemes=(circle.schemes[0], other))


@pytest.mark.parametrize("tolerance", [0.0, -1e-6, float("inf"), float("nan")])
def test_tolerance_out_of_range(circle, tolerance):
    with pytest.raises(ParameterError, match="finite and > 0 m"):
        replace(circle, tolerance=tolerance)


def test_limits_must_be_positive():
    with pytest.raises(ParameterError, match=r"velocity = \[0.1, 0.0\] m/s"):
        AxisBounds(np.array([0.1, 0.0]), np.ones(2), np.ones(2), np.ones(2))


def test_one_limit_applies_to_all_axes():
    bounds = AxisBounds(np.array([0.1]), np.array([1.0, 2.0]), np.array([np.inf]), np.ones(1))
    assert bounds.of("velocity", 1) == 0.1 and bounds.of("acceleration", 1) == 2.0


@pytest.mark.parametrize("frequency", [[1.0, 1.0], [0.0, 1.0], [2.0, 1.0]])
def test_frequencies_must_rise_from_above_zero(frequency):
    with pytest.raises(ParameterError, match="> 0 and ascending"):
        FrequencyResponse(np.array(frequency), np.ones(2))


def test_one_response_for_each_frequency():
    with pytest.raises(ParameterError, match="frequency"):
        FrequencyResponse(np.array([1.0, 2.0]), np.ones(3))
