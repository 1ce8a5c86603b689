"""The frequency at which a closed loop is a quarter turn off, where its response is pieced together from several axes."""

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
    """The one with more lag at each frequency; a single frequency does not tell how often its phase has been round."""
    answers = np.stack([quick(w), slow(w)], axis=1)
    phase = np.unwrap(np.angle(answers), axis=0)
    return np.asarray(answers[np.arange(w.size), np.argmin(phase, axis=1)])


@pytest.mark.parametrize("lead", [0.0, 0.005, 0.012, 0.014])
def test_an_axis_that_is_quicker_everywhere_changes_nothing(lead: float) -> None:
    assert quarter_turn(furthest_back, PERIOD, lead) == pytest.approx(quarter_turn(slow, PERIOD, lead), rel=1e-9)


def test_the_delay_of_the_lead_is_taken_off() -> None:
    # A delay of 15 ms with a lead of 10 leaves one of 5 ms, which turns by a quarter at pi/(2 * 5 ms).
    assert quarter_turn(lambda w: np.asarray(np.exp(-0.015j * w)), PERIOD, 0.010) == pytest.approx(np.pi / (2.0 * 0.005), rel=1e-9)
