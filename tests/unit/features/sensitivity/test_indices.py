"""Global indices against closed forms: the functions of Ishigami and of Sobol."""

from __future__ import annotations

import math

import numpy as np
import pytest
from modelled import Modelled

from contourlab.errors import ParameterError
from contourlab.features.sensitivity.options import Plan
from contourlab.features.sensitivity.study import Drawn, Study, distributions, sample, sensitivity_study, verdict
from contourlab.study import DesignVariable, Space
from contourlab.study.design import morris_points, saltelli_points
from contourlab.study.runner import Columns
from contourlab.study.statistics import morris_indices, sobol_indices

A, B = 7.0, 0.1
PI = Space(tuple(DesignVariable(f"controller.axes.{name}.controller.p", 1.0, -math.pi, math.pi, logarithmic=False) for name in "xyz"))


def ishigami(columns: Columns) -> dict[str, np.ndarray]:
    """Return the function of Ishigami as a model."""
    x, y, z = columns.values()
    value = np.sin(x) + A * np.sin(y) ** 2 + B * z**4 * np.sin(x)
    return {"contour_error_integral": value}


def shares() -> tuple[np.ndarray, np.ndarray, float]:
    """Return first and total indices of Ishigami's function, and its deviation, in closed form."""
    one = 0.5 * (1.0 + B * math.pi**4 / 5.0) ** 2
    two, both = A**2 / 8.0, B**2 * math.pi**8 * 8.0 / 225.0
    total = one + two + both
    return np.array([one, two, 0.0]) / total, np.array([one + both, two, both]) / total, math.sqrt(total)


def studied(base: int, second: bool = False) -> Study:
    plan = Plan(parts=("morris", "sobol"), base=base, second_order=second, transform="none")
    return sensitivity_study(PI, Modelled(ishigami), plan, distributions(PI), math.inf)


def test_sobol_indices_of_ishigami_lie_in_their_intervals() -> None:
    """Through a whole study: sampling, distributions, model, outcome, estimator."""
    found = studied(4096, second=True)
    first, total, deviation = shares()
    s = found.sobol
    assert s is not None and s.second is not None and s.second_interval is not None
    assert (np.abs(s.first - first) <= s.first_interval).all() and (np.abs(s.total - total) <= s.total_interval).all()
    assert s.total_interval.max() < 0.06
    assert s.deviation == pytest.approx(deviation, rel=0.02)
    assert abs(s.second[0, 2] - (total[2] - first[2])) <= s.second_interval[0, 2]
    assert abs(s.second[0, 1]) <= s.second_interval[0, 1] and np.isnan(s.second[1, 0])
    conclusions = {(one.code, one.place) for one in verdict(found)}
    assert conclusions >= {("CL661", ""), ("CL662", "x.p and z.p")}


def test_sobol_indices_of_the_g_function() -> None:
    a = np.array([0.0, 0.5, 3.0, 9.0, 99.0])
    points = saltelli_points(5, 2048, seed=3)
    values = np.prod((np.abs(4.0 * points - 2.0) + a) / (1.0 + a), axis=1)
    part = 1.0 / (3.0 * (1.0 + a) ** 2)
    variance = np.prod(1.0 + part) - 1.0
    found = sobol_indices(values, 5, seed=3)
    total = part * np.prod(1.0 + part) / (1.0 + part) / variance
    assert (np.abs(found.first - part / variance) <= found.first_interval + 1e-3).all()
    assert (np.abs(found.total - total) <= found.total_interval + 1e-3).all()
    assert list(np.argsort(-found.total)) == [0, 1, 2, 3, 4]


def test_elementary_effects_of_a_plane_are_its_slopes() -> None:
    slopes = np.array([3.0, -2.0, 0.0])
    points = morris_points(3, 8, seed=1)
    found = morris_indices(points, 5.0 + points @ slopes, seed=1)
    np.testing.assert_allclose(found.mu_star, np.abs(slopes), atol=1e-12)
    np.testing.assert_allclose(found.mu, slopes, atol=1e-12)
    np.testing.assert_allclose(found.sigma, 0.0, atol=1e-12)


def test_a_larger_sample_begins_with_the_smaller_one() -> None:
    """Runs of a smaller base are therefore reused."""
    np.testing.assert_array_equal(saltelli_points(4, 128, seed=5)[: 64 * 6], saltelli_points(4, 64, seed=5))


def test_a_constant_model_has_no_indices() -> None:
    found = sobol_indices(np.full(16 * 5, 2.0), 3)
    assert not found.total.any() and found.deviation == 0.0


@pytest.mark.parametrize(("base", "said"), [(500, "256 or 512"), (8, "16"), (0, "16")])
def test_a_base_must_be_a_power_of_two(base: int, said: str) -> None:
    with pytest.raises(ParameterError, match=said):
        Plan(base=base)


def test_too_small_a_sample_is_refused() -> None:
    with pytest.raises(ParameterError, match="two"):
        Plan().work(1)
    with pytest.raises(ParameterError, match="--trajectories"):
        Plan(trajectories=2)
    with pytest.raises(ParameterError, match="curves"):
        Plan(parts=("all",))


NUMBER = DesignVariable("controller.axes.x.controller.gain", 3.0, 1.0, 9.0)


def test_samples_follow_their_distribution() -> None:
    places = (np.arange(20000) + 0.5) / 20000
    flat, log, normal = Drawn(NUMBER), Drawn(NUMBER, "log-uniform"), Drawn(NUMBER, "normal", 0.3)
    assert flat.values(places).mean() == pytest.approx(5.0)
    assert np.log(log.values(places)).mean() == pytest.approx(math.log(3.0))
    assert (normal.values(places).mean(), normal.values(places).std()) == (pytest.approx(3.0), pytest.approx(0.3, rel=1e-3))
    for one in (flat, log, Drawn(NUMBER, "normal", 5.0)):
        ends = one.values(np.array([0.0, 1.0]))
        np.testing.assert_allclose(ends, [1.0, 9.0])


def test_the_truncated_normal_distribution_equals_scipys() -> None:
    from scipy.stats import truncnorm

    places = np.linspace(0.01, 0.99, 23)
    known = truncnorm((1.0 - 3.0) / 2.0, (9.0 - 3.0) / 2.0, loc=3.0, scale=2.0).ppf(places)
    np.testing.assert_allclose(Drawn(NUMBER, "normal", 2.0).values(places), known, rtol=1e-10)


SPACE = Space((NUMBER, DesignVariable("controller.axes.y.controller.rate", 2.0, 1.0, 4.0, "1/s", "1/s")))


def test_deviations_are_read_by_name_or_for_all() -> None:
    both = distributions(SPACE, deviations=["10 %"])
    assert [one.deviation for one in both] == [pytest.approx(0.3), pytest.approx(0.2)]
    one, other = distributions(SPACE, "log-uniform", ["y.rate=0.5 1/s"])
    assert (one.kind, other.kind, other.deviation) == ("log-uniform", "normal", 0.5)


@pytest.mark.parametrize(
    ("kind", "deviation", "said"),
    [
        ("round", (), "uniform, log-uniform, normal"),
        ("normal", (), "--deviation"),
        ("uniform", ("z.rate=1 %",), "x.gain"),
        ("uniform", ("y.rate=1 mm",), "1/s"),
        ("uniform", ("y.rate=much",), "5 %"),
        ("uniform", ("y.rate=0 %",), "--deviation"),
    ],
)
def test_invalid_distributions_are_refused(kind: str, deviation: tuple[str, ...], said: str) -> None:
    with pytest.raises(ParameterError) as caught:
        distributions(SPACE, kind, deviation)
    assert said in str(caught.value)


def test_failed_runs_count_as_the_failure_limit_and_are_reported() -> None:
    figures = np.array([1e-3, np.nan, 1e-2, 5.0, 1e-3, 1e-3, 1e-3, 1e-3])
    points = np.full((8, 2), 0.5)
    found = sample(figures, 0.1, True, SPACE, points)
    np.testing.assert_allclose(found.values, [-3, -1, -2, -1, -3, -3, -3, -3])
    assert (found.failed, found.runs, found.cap) == (1, 8, 0.1)
    assert sample(figures, math.inf, False, SPACE, points).values[1] == 50.0


def test_too_many_failures_are_refused_and_the_culprit_is_named() -> None:
    points = np.random.default_rng(0).random((100, 2))
    figures = np.where(points[:, 1] > 0.6, np.nan, 1.0)
    with pytest.raises(ParameterError, match=r"[34]\d %") as caught:
        sample(figures, 1.0, True, SPACE, points)
    assert "y.rate" in str(caught.value)


def test_a_logarithm_of_zero_is_refused() -> None:
    with pytest.raises(ParameterError, match="--transform none"):
        sample(np.array([1.0, 0.0]), 1.0, True, SPACE, np.zeros((2, 2)))
