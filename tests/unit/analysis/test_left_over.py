"""Energy that a fit leaves at one frequency: found where there is a resonance, not where there is none; and the band searched."""

import numpy as np
import pytest
from scipy.signal import cont2discrete, lfilter

from contourlab.analysis.identification.left_over import left_over, left_over_findings

PERIOD, SAMPLES = 1e-3, 20000


def responses(frequency: float, seed: int = 0, size: float = 0.3) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return force, rigid velocity, and what a model without the resonance leaves, with noise of an encoder."""
    generator = np.random.default_rng(seed)
    force = lfilter([0.05], [1.0, -0.95], generator.standard_normal(SAMPLES))
    rigid = PERIOD * np.cumsum(force - force.mean())
    noise = 2e-5 * np.diff(generator.standard_normal(SAMPLES + 1))
    if not size:
        return force, rigid, noise
    w = 2.0 * np.pi * frequency
    (above,), below, _ = cont2discrete(([size, 0.0], [1.0, 0.06 * w, w * w]), PERIOD)
    return force, rigid, lfilter(above, below, force) + noise


@pytest.mark.parametrize("frequency", [20.0, 45.0, 150.0])
def test_a_resonance_that_is_left_is_found(frequency: float) -> None:
    force, rigid, rest = responses(frequency)
    left = left_over(rest, force, rigid, PERIOD)
    assert left.frequency == pytest.approx(frequency, rel=0.06)
    assert left.clear > 10.0
    (finding,) = left_over_findings("axis x", rest, force, rigid, PERIOD)
    assert (finding.code, finding.values["frequency"]) == ("CL597", left.frequency)


def test_none_is_found_without_one() -> None:
    for seed in range(30):
        force, rigid, rest = responses(45.0, seed, 0.0)
        left = left_over(rest, force, rigid, PERIOD)
        assert left.clear < 5.0
        assert [doubt.code for doubt in left_over_findings("axis x", rest, force, rigid, PERIOD)] == ["CL598"]


def test_the_band_is_where_the_log_excites() -> None:
    """The force is slow: the band ends where noise drowns the motion."""
    force, _, rest = responses(150.0, 3, 0.0)
    slow = force
    for _ in range(8):
        slow = lfilter([0.2], [1.0, -0.8], slow)
    rigid = PERIOD * np.cumsum(slow - slow.mean())
    (finding,) = left_over_findings("axis x", rest, slow, rigid, PERIOD)
    assert finding.code == "CL598"
    assert finding.values["low"] == pytest.approx(8.0, abs=1.0)
    assert 30.0 < finding.values["high"] < 150.0


def test_a_short_log_tells_nothing() -> None:
    force, rigid, rest = (signal[:2000] for signal in responses(45.0))
    assert [finding.code for finding in left_over_findings("axis x", rest, force, rigid, PERIOD)] == ["CL599"]
