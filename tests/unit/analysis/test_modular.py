"""Linear base and local controllers: the paper's axes, and a closed-form case."""

from __future__ import annotations

import numpy as np
import pytest
from refusals import refuses

from contourlab.analysis.linear.modular_design import (
    GAINS,
    LinearAxis,
    LqWeights,
    blind_swaps,
    cost,
    direct_design,
    lmi_design,
    optimum,
    three_step_design,
)
from contourlab.errors import ParameterError

RAW = [LinearAxis(1695.0, 10.1), LinearAxis(648.0, 6.5), LinearAxis(1116.0, 5.8)]
BEHIND = [LinearAxis(873.0, 19.7), LinearAxis(754.0, 24.7), LinearAxis(801.0, 19.9)]
"""a, b and a', b' of the stage's axes, section III and Table II."""


def test_the_riccati_solution_is_the_minimum_cost() -> None:
    weights = LqWeights()
    gains, best = optimum(RAW[0], weights)
    assert cost(RAW[0], gains, weights) == pytest.approx(best, rel=1e-9)
    generator = np.random.default_rng(0)
    for _ in range(20):
        assert cost(RAW[0], gains * generator.uniform(0.8, 1.25, 3), weights) >= best
    assert cost(RAW[0], -gains, weights) == np.inf


def test_the_observer_reduces_the_loss_of_a_swap() -> None:
    # Figures of the technical brief, with unknown weights: 1.147 against 1.006 for blind swaps, losses cut 10 to 25 times.
    weights = LqWeights()
    raw, behind = (blind_swaps(axes, weights).max() for axes in (RAW, BEHIND))
    assert raw == pytest.approx(1.147, abs=0.01) and behind == pytest.approx(1.006, abs=0.001)
    for design in (lambda axes: direct_design(axes), lambda axes: three_step_design(axes), lambda axes: lmi_design(axes)[0]):
        losing, kept = design(RAW), design(BEHIND)
        assert losing.loss > 5.0 * kept.loss and kept.loss < 0.015
        assert (losing.ratio >= 1.0 - 1e-9).all()


def test_all_gains_local_lose_nothing() -> None:
    for design in (direct_design, three_step_design):
        assert design(RAW, GAINS).ratio == pytest.approx(np.ones(3), abs=1e-6)


@pytest.mark.slow
def test_more_local_gains_never_lose_more_in_total() -> None:
    totals = [direct_design(RAW, local).ratio.sum() for local in ((), ("velocity",), ("velocity", "position"), GAINS)]
    # From the second set on nothing is lost: the integral gain is the root of q over r for all of them.
    assert (np.diff(totals) <= 1e-9).all() and totals[2] == pytest.approx(3.0, abs=1e-6) and totals[0] > 3.05


def test_every_method_finds_the_optimum_of_a_single_axis() -> None:
    weights = LqWeights()
    for found in (direct_design(RAW[:1]), three_step_design(RAW[:1]), lmi_design(RAW[:1])[0]):
        assert found.ratio == pytest.approx([1.0], abs=1e-4)
        assert found.gains[0] == pytest.approx(optimum(RAW[0], weights)[0], rel=2e-2)


def test_the_bounds_of_the_lmi_hold() -> None:
    found, bounds = lmi_design(RAW)
    assert (found.ratio <= bounds * (1.0 + 1e-6)).all()


def test_an_unknown_gain_is_refused() -> None:
    with refuses(ParameterError, name="local", value="'acceleration'"):
        direct_design(RAW, ("acceleration",))
