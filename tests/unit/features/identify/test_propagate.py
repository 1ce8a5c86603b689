"""The covariance of a fit's parameters, propagated to the numbers of an axis file."""

import math

import numpy as np
import pytest

from contourlab.analysis.identification.least_squares import Estimate
from contourlab.features.identify.result import propagate


def estimate(values: list[float], deviations: list[float], correlation: np.ndarray) -> Estimate:
    return Estimate(("a", "b"), np.array(values), np.array(deviations), np.array(deviations), correlation)


def test_mass_and_damping_from_a_and_b() -> None:
    """For m = 1/a and c = b/a: var c = (b/a^2)^2 var a + var b/a^2 - 2 b/a^3 cov, cov(m, c) = b/a^4 var a - cov/a^3."""
    a, b, da, db, r = 2.0, 6.0, 0.02, 0.3, 0.6
    found = propagate(
        lambda x: {"plant.mass": 1.0 / x["a"], "plant.damping": x["b"] / x["a"]},
        estimate([a, b], [da, db], np.array([[1.0, r], [r, 1.0]])),
    )
    both = r * da * db
    mass, damping = da / a**2, math.sqrt((b * da / a**2) ** 2 + (db / a) ** 2 - 2.0 * b / a**3 * both)
    assert found.deviations["plant.mass"] == pytest.approx(mass, rel=1e-4)
    assert found.deviations["plant.damping"] == pytest.approx(damping, rel=1e-4)
    ((one, other, value),) = found.correlations
    assert (one, other) == ("plant.mass", "plant.damping")
    assert value == pytest.approx((b / a**4 * da**2 - both / a**3) / (mass * damping), abs=2e-4)


def test_a_parameter_without_deviation_adds_no_variance_or_correlation() -> None:
    found = propagate(lambda x: {"p": x["a"], "q": x["b"]}, estimate([1.0, 0.0], [0.1, 0.0], np.eye(2)))
    assert found.deviations == {"p": pytest.approx(0.1), "q": 0.0} and found.correlations == ()
