"""Energy that a fit leaves at one frequency: found where there is a resonance, not where there is none; and the band searched."""

from pathlib import Path

import made_commission as bench
import numpy as np
import pytest
from made_two_masses import TwoMasses
from scipy.signal import cont2discrete, lfilter

import contourlab as cl
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


@pytest.mark.parametrize(("samples", "period"), [(2000, PERIOD), (20000, 1.0)], ids=["short", "slow"])
def test_a_short_or_slow_log_tells_nothing(samples: int, period: float) -> None:
    force, rigid, rest = (signal[:samples] for signal in responses(45.0))
    assert [finding.code for finding in left_over_findings("axis x", rest, force, rigid, period)] == ["CL599"]


@pytest.mark.slow
def test_a_shaft_of_45_hz_is_said_by_a_model_without_it(tmp_path: Path) -> None:
    """Two masses under LinuxCNC's pid, fitted as one: the issue's axis, and the same one with a stiff shaft."""
    made = bench.made(tmp_path)
    command, noise = 1e-3 * made.rows["x_cmd [mm]"], 2e-7
    for frequency, code in ((45.0, "CL597"), (2000.0, "CL598")):
        drawn = np.random.default_rng(1).uniform(-noise, noise, command.size)
        position, output = TwoMasses(frequency=frequency).measured(command, made.setup.axes[0].gains, bench.PERIOD, drawn)
        heads, file = "time [s],position.x [mm],command.x [V]", tmp_path / f"{frequency:g}.csv"
        columns = np.column_stack([bench.PERIOD * np.arange(command.size), 1e3 * position, output])
        np.savetxt(file, columns, delimiter=",", header=heads, comments="", fmt="%.7f")
        (left,) = (doubt for doubt in cl.identify(file, model="first-order").findings if "CL597" <= doubt.code <= "CL599")
        assert left.code == code
        assert code == "CL598" or left.values["frequency"] == pytest.approx(45.0, abs=1.5)
