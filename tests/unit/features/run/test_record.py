"""A run written to a file while it runs."""

from __future__ import annotations

import csv
import tracemalloc
from dataclasses import replace
from itertools import pairwise, starmap
from pathlib import Path

import numpy as np
import pytest

import contourlab as cl
from contourlab.components.registry import component
from contourlab.features.run.record import switch_file
from contourlab.feed import route_from_path
from contourlab.geometry.line_and_arc import Line
from contourlab.loop import Change
from contourlab.loop.switches import Switches, SwitchKind

PERIOD = 1e-3


def rig(velocity_gain: float = 60.0, position_gain: float = 2000.0) -> tuple[cl.Machine, cl.Controller]:
    """Return two plain axes under position loops."""
    plant = component("plant", "mass-damper")(mass=10.0, damping=40.0, force_constant=50.0)
    part = component("controller", "position")(velocity_gain=velocity_gain, position_gain=position_gain)
    axes = tuple(cl.Axis(name, plant, limits=cl.Limits(following_error=1e-3)) for name in "xy")
    return cl.Machine("rig", axes, PERIOD), cl.Controller(dict.fromkeys("xy", cl.AxisController(part)))


def reference(laps: int) -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=2e-3), 1.0, laps, PERIOD)


def test_the_file_holds_the_same_as_a_run_in_memory(tmp_path: Path) -> None:
    machine, controller = rig()
    whole = cl.judge(cl.simulate(machine, controller, reference(3)), reference(3))
    told: list[int] = []
    cl.simulate_to_file(machine, controller, reference(3), tmp_path / "run.nc", block=700, progress=told.append)
    read = cl.Result.load(tmp_path / "run.nc")
    assert told[-1] == whole.n_sample and len(told) == 5
    assert read.signals.keys() == whole.signals.keys()
    for name in whole.signals:
        assert np.max(np.abs(read[name] - whole[name])) <= (1e-15 if name in ("foot_arc_length", "contour_error", "part_error") else 0.0)


def test_blocks_are_judged_as_the_whole_run_at_corners(tmp_path: Path) -> None:
    """A block in which the tool follows closely still looks as far for the nearest leg as the whole run."""
    machine, controller = rig(velocity_gain=20.0, position_gain=300.0)
    limits = cl.Limits(velocity=0.2, acceleration=5.0, jerk=200.0, following_error=20e-3)
    machine = replace(machine, axes=tuple(replace(axis, limits=limits) for axis in machine.axes))
    corners = [(3.9e-3, 5e-3), (1.8e-3, 8.2e-3), (3.4e-3, 6.9e-3), (2.2e-3, 3.5e-3), (3.8e-3, 2.4e-3), (0.3e-3, 7.7e-3), (9.5e-3, 2.3e-3)]
    asked = cl.plan(route_from_path(cl.Path(list(starmap(Line, pairwise(corners)))), 0.2), machine.planner_limits(), PERIOD)
    whole = cl.judge(cl.simulate(machine, controller, asked), asked)
    for block in (17, 97):
        cl.simulate_to_file(machine, controller, asked, tmp_path / "run.nc", block=block)
        read = cl.Result.load(tmp_path / "run.nc")
        for name in ("contour_error", "part_error"):
            assert np.max(np.abs(read[name] - whole[name])) <= 1e-15


def test_chosen_signals_only(tmp_path: Path) -> None:
    machine, controller = rig()
    cl.simulate_to_file(machine, controller, reference(1), tmp_path / "run.nc", signals=("command",))
    names = set(cl.Result.load(tmp_path / "run.nc").signals)
    assert {"command", "tool_position", "contour_error"} <= names and "axis_velocity" not in names


def test_a_failed_run_leaves_no_file(tmp_path: Path) -> None:
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
    for laps in (40, 200):  # the first is long enough to fill the buffer of the reference
        tracemalloc.start()
        cl.simulate_to_file(machine, controller, reference(laps), tmp_path / "run.nc", block=4096)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 1.3 * peaks[0]


def supervised() -> cl.Controller:
    """Return a controller that is replaced by a slower copy of itself at two places of each axis's path."""
    part = component("controller", "position")
    fast, slow = part(velocity_gain=60.0, position_gain=2000.0), part(velocity_gain=60.0, position_gain=1500.0)
    supervisor = component("supervisor", "pre-routed")(places=(0.003, 0.009, 0.02), numbers=(1.0, 0.0, 1.0))
    return cl.Controller(dict.fromkeys("xy", cl.AxisController(fast, supervisor=supervisor, others=(("slow", slow),))))


@pytest.mark.parametrize("signals", [(), ("command",)])
@pytest.mark.slow
def test_every_switch_is_written_for_any_block_size(tmp_path: Path, signals: tuple[str, ...]) -> None:
    machine, _ = rig()
    texts = []
    for block in (31, 1 << 15):
        given = {"signals": signals, "block": block, "switches": tmp_path / f"{block}.csv"}
        cl.simulate_to_file(machine, supervised(), reference(2), tmp_path / "run.nc", **given)
        texts.append((tmp_path / f"{block}.csv").read_text(encoding="utf-8"))
    assert texts[0] == texts[1]
    rows = list(csv.DictReader(texts[0].splitlines()))
    assert [(row["axis"], row["from"], row["to"]) for row in rows] == [
        (axis, before, after) for before, after in (("controller", "slow"), ("slow", "controller"), ("controller", "slow")) for axis in "xy"
    ]
    for row, place in zip(rows, (0.003, 0.003, 0.009, 0.009, 0.02, 0.02), strict=True):
        # One lap is 4 pi mm in 1000 samples.
        assert float(row["arc_length_m"]) == pytest.approx(place, abs=4e-3 * np.pi / 1000.0)
        assert float(row["time_s"]) == pytest.approx(int(row["sample"]) * PERIOD)
        assert "place" in row["reason"] and row["line"] == ""


def test_a_controller_that_takes_over_is_written_with_the_switches(tmp_path: Path) -> None:
    machine, controller = rig()
    changes = (Change(0.3, rig(velocity_gain=50.0)[1], file="calm.toml"),)
    cl.simulate_to_file(machine, controller, reference(1), tmp_path / "run.nc", changes=changes, switches=tmp_path / "switches.csv")
    rows = list(csv.DictReader((tmp_path / "switches.csv").read_text(encoding="utf-8").splitlines()))
    assert [(row["sample"], row["axis"], row["from"], row["to"]) for row in rows] == [("300", axis, "controller", "calm") for axis in "xy"]
    whole = cl.simulate(machine, controller, reference(1), changes=changes)
    np.testing.assert_array_equal(cl.Result.load(tmp_path / "run.nc")["axis_position"], whole["axis_position"])


def test_names_with_spreadsheet_separators_survive_a_round_trip(tmp_path: Path) -> None:
    kinds = (SwitchKind("x", 'a, "b"', "line\nbreak", "because; of"),)
    one = np.zeros(1, dtype=np.int64)
    found = Switches(("x",), PERIOD, kinds, one, one + 3, np.array([np.nan]), one + 12, {}, {})
    with switch_file(tmp_path / "switches.csv") as listed:
        listed(found)
    with (tmp_path / "switches.csv").open(encoding="utf-8", newline="") as stream:
        (row,) = csv.DictReader(stream)
    assert (row["from"], row["to"], row["reason"]) == ('a, "b"', "line\nbreak", "because; of")
    assert (row["time_s"], row["sample"], row["arc_length_m"], row["line"]) == ("0.003", "3", "", "12")
