"""Stated deviations against the errors of random machines whose friction, damping and play the model divides otherwise or lacks."""

from pathlib import Path

import made_commission as bench
import numpy as np
import pytest
from made_two_masses import drawn

from contourlab.features.commission.identification import IdentifiedAxis, identify_axis
from contourlab.features.commission.loop import GAINS, Law
from contourlab.features.commission.records import AxisLog, moving

SEEDS = range(30, 40)


@pytest.mark.slow
def test_deviations_cover_the_errors(tmp_path: Path) -> None:
    made = bench.made(tmp_path)
    axis, command = made.setup.axes[0], 1e-3 * made.rows["x_cmd [mm]"]
    present = np.array([axis.gains[name] / made.setup.unit for name in GAINS])
    off, resonances = list[float](), list[float]()
    for seed in SEEDS:
        plant, largest = drawn(seed)
        noise = np.random.default_rng([25, seed]).uniform(-largest, largest, command.size)
        position, output = plant.measured(command, axis.gains, bench.PERIOD, noise)
        log = AxisLog("log.csv", "x", bench.PERIOD, command, np.round(position, 9), np.round(output, 6))
        found = identify_axis([moving(log)], present, Law(bench.PERIOD))
        assert isinstance(found, IdentifiedAxis)
        off.append(abs(found.model.gain - plant.gain) / found.deviations["gain"])
        if found.model.share:
            resonances.append(found.model.resonance / plant.frequency)
    # Nine of ten are expected.
    assert np.count_nonzero(np.array(off) < 2.0) >= 8
    assert 0.3 < np.median(off) < 1.5
    assert len(resonances) >= 5
    assert np.median(np.abs(np.array(resonances) - 1.0)) < 0.01
