"""A run that is written as it is made."""

from __future__ import annotations

import tracemalloc
from pathlib import Path

import numpy as np
import pytest

import contourlab as cl
from contourlab.components.registry import component

PERIOD = 1e-3


def rig(velocity_gain: float = 60.0) -> tuple[cl.Machine, cl.Controller]:
    """Return two plain axes under position loops."""
    plant = component("plant", "mass-damper")(mass=10.0, damping=40.0, force_constant=50.0)
    part = component("controller", "position")(velocity_gain=velocity_gain, position_gain=2000.0)
    axes = tuple(cl.Axis(name, plant, limits=cl.Limits(following_error=1e-3)) for name in "xy")
    return cl.Machine("rig", axes, PERIOD), cl.Controller(dict.fromkeys("xy", cl.AxisController(part)))


def reference(laps: int) -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=2e-3), 1.0, laps, PERIOD)


def test_the_file_holds_what_a_run_in_memory_gives(tmp_path: Path) -> None:
    machine, controller = rig()
    whole = cl.judge(cl.simulate(machine, controller, reference(3)), reference(3))
    told: list[int] = []
    cl.simulate_to_file(machine, controller, reference(3), tmp_path / "run.nc", block=700, progress=told.append)
    read = cl.Result.load(tmp_path / "run.nc")
    assert told[-1] == whole.n_sample and len(told) == 5
    assert read.signals.keys() == whole.signals.keys()
    for name in whole.signals:
        # The judge's window follows the block's largest tracking error; where the foot lies does not.
        assert np.max(np.abs(read[name] - whole[name])) <= (1e-15 if name in ("foot_arc_length", "contour_error", "part_error") else 0.0)


def test_chosen_signals_only(tmp_path: Path) -> None:
    machine, controller = rig()
    cl.simulate_to_file(machine, controller, reference(1), tmp_path / "run.nc", signals=("command",))
    names = set(cl.Result.load(tmp_path / "run.nc").signals)
    assert {"command", "tool_position", "contour_error"} <= names and "axis_velocity" not in names


def test_a_run_that_fails_leaves_no_file(tmp_path: Path) -> None:
    machine, controller = rig(velocity_gain=1e5)
    (tmp_path / "run.nc").write_bytes(b"older")
    with pytest.raises(cl.DivergenceError):
        cl.simulate_to_file(machine, controller, reference(1), tmp_path / "run.nc", block=10)
    assert (tmp_path / "run.nc").read_bytes() == b"older" and len(list(tmp_path.iterdir())) == 1


@pytest.mark.slow
def test_memory_does_not_grow_with_the_run(tmp_path: Path) -> None:
    machine, controller = rig()
    cl.simulate_to_file(machine, controller, reference(1), tmp_path / "run.nc")
    peaks = []
    for laps in (40, 400):  # the first is long enough to fill what is kept of the reference
        tracemalloc.start()
        cl.simulate_to_file(machine, controller, reference(laps), tmp_path / "run.nc", block=4096)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 1.3 * peaks[0]
