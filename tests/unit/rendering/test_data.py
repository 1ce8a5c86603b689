"""Data that cannot be reported are refused with a reason."""

from __future__ import annotations

from dataclasses import replace

import pytest

from contourlab.errors import ParameterError


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
