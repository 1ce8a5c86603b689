"""The frequency at which a closed loop lags by a quarter turn, with a response assembled from several axes."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from contourlab.analysis.learning.learning_analysis import quarter_turn

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
PERIOD = 1e-3


def quick(w: Array) -> Complex:
    return np.asarray(1.0 / (1.0 + 0.01j * w))


def slow(w: Array) -> Complex:
    return np.asarray(np.exp(-0.015j * w) / (1.0 + 0.02j * w))


def furthest_back(w: Array) -> Complex:
    """Return the response with more lag at each frequency; a single frequency does not show how many turns the phase has made."""
    answers = np.stack([quick(w), slow(w)], axis=1)
    phase = np.unwrap(np.angle(answers), axis=0)
    return np.asarray(answers[np.arange(w.size), np.argmin(phase, axis=1)])


@pytest.mark.parametrize("lead", [0.0, 0.005, 0.012, 0.014])
def test_a_faster_axis_changes_nothing(lead: float) -> None:
    assert quarter_turn(furthest_back, PERIOD, lead) == pytest.approx(quarter_turn(slow, PERIOD, lead), rel=1e-9)


def test_the_delay_is_reduced_by_the_lead() -> None:
    # A delay of 15 ms with a lead of 10 ms leaves 5 ms, which gives a quarter turn at pi/(2 * 5 ms).
    assert quarter_turn(lambda w: np.asarray(np.exp(-0.015j * w)), PERIOD, 0.010) == pytest.approx(np.pi / (2.0 * 0.005), rel=1e-9)
