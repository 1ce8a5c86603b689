"""A run written to a file while it runs."""

from __future__ import annotations

import copy
import csv
import errno
import pickle
import subprocess
import sys
from collections.abc import Mapping
from contextlib import nullcontext
from dataclasses import fields, is_dataclass, replace
from itertools import pairwise, starmap
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import h5py
import numpy as np
import pytest

import contourlab as cl
from contourlab import thinning
from contourlab.components.registry import component
from contourlab.errors import OutputError, ResultError
from contourlab.features.run.outcome import judged_spikes
from contourlab.features.run.record import simulate_stored, write_switches
from contourlab.features.run.verdict import unexplained
from contourlab.feed import route_from_path
from contourlab.feed.reference import Judged
from contourlab.geometry.line_and_arc import Line
from contourlab.loop import Change
from contourlab.loop.switches import Switches, SwitchKind
from contourlab.metrics import figures, reversals
from contourlab.metrics.run_figures import figures_of_run
from contourlab.rendering.data import JudgedRun, Provenance, ReportData
from contourlab.rendering.lead import program_lines
from contourlab.rendering.path_picture import path_scene
from contourlab.rendering.run_pictures import axis_charts, error_charts
from contourlab.rendering.spectrum import spectrum_charts
from contourlab.result import result as result_module
from contourlab.result.stored import Stored

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


@pytest.mark.parametrize("block", [pytest.param(1, marks=pytest.mark.slow), 97, 1 << 20])
def test_a_run_in_blocks_gives_the_same_as_one_in_memory(block: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Signals, figures, spikes, verdict, lines and pictures; also where parts of the run are not judged."""
    machine, controller = rig(velocity_gain=20.0, position_gain=300.0)
    limits = cl.Limits(velocity=0.2, acceleration=5.0, jerk=200.0, following_error=20e-3)
    machine = replace(machine, axes=tuple(replace(axis, limits=limits) for axis in machine.axes))
    corners = [(0.0, 0.0), (9e-3, 1e-3), (8e-3, 7e-3), (1e-3, 8e-3), (2e-3, 2e-3)]
    route = route_from_path(cl.Path(list(starmap(Line, pairwise(corners)))), 0.05)
    asked = cl.plan(route, machine.planner_limits(), PERIOD)
    parts = Judged(((3, 201), (203, 204), (230, asked.n_sample - 2)), "lines")
    whole = cl.judge(cl.simulate(machine, controller, asked), asked)
    for module in (result_module, figures, reversals, thinning):
        monkeypatch.setattr(module, "BLOCK", block)
    run = cl.judge(simulate_stored(machine, controller, asked, block=block), asked)
    assert isinstance(run.signals, Stored) and run.signals.keys() == whole.signals.keys() and run.n_sample == whole.n_sample > 600
    for name in whole.signals:
        np.testing.assert_allclose(run[name], whole[name], rtol=0.0, atol=1e-15)
        np.testing.assert_array_equal(run.at(name, np.array([5, 299, 0])), run[name][[5, 299, 0]])

    lined = replace(asked, source_lines=np.arange(1, asked.source_lines.size + 1))

    def seen(result: cl.Result) -> list[Any]:
        """Return what the command says of a run, and the pictures of its page."""
        metrics = cl.summarise(result, asked, parts)
        outcome = JudgedRun("base", lined, result, metrics, spikes=judged_spikes(result, asked))
        data = ReportData("run", [outcome], Provenance())
        pictures = [*error_charts(data, 100), *axis_charts(data, 100), *spectrum_charts(data, 100), path_scene(data, 64)]
        left = [unexplained(asked, result, 1e-3), figures_of_run(result, parts), program_lines(replace(data, program=["a", "b"]))]
        return [metrics, outcome.spikes, *left, *pictures]

    in_blocks = seen(run)
    monkeypatch.undo()
    assert numbers(in_blocks) == pytest.approx(numbers(seen(whole)), rel=1e-9, abs=1e-12)


def numbers(value: Any) -> list[float]:
    """Return all numbers in a value, in order."""
    if isinstance(value, bool | int | float | np.number):
        return [float(np.nan_to_num(value))]
    if isinstance(value, np.ndarray):
        return list(np.nan_to_num(value.astype(float)).ravel())
    if is_dataclass(value):
        value = [getattr(value, part.name) for part in fields(value)]
    members = value.values() if isinstance(value, Mapping) else value if isinstance(value, list | tuple) else ()
    return [number for member in members for number in numbers(member)]


def test_signals_in_a_file_can_be_cut_and_outlive_their_run() -> None:
    machine, controller = rig()
    run = simulate_stored(machine, controller, reference(1), block=300)
    part = run.window(250, 900).window(100, 10_000).only(["position", "arc_length"])
    assert (part.start, part.n_sample, set(part.signals)) == (350, 550, {"position", "arc_length"})
    whole = cl.simulate(machine, controller, reference(1))["position"]
    with pytest.raises(ResultError):
        run.only(["position", "contour_error"])
    kept = part["position"]
    del run, part
    np.testing.assert_array_equal(kept, whole[350:900])


def test_copies_of_signals_in_a_file_are_in_memory() -> None:
    run = cl.judge(simulate_stored(*rig(), reference(1)), reference(1))
    for copied in (copy.deepcopy(run.window(100, 300)), pickle.loads(pickle.dumps(run.window(100, 300)))):
        assert set(copied.signals) == set(run.signals) and copied.start == 100
        np.testing.assert_array_equal(copied["part_error"], run["part_error"][100:300])


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a full disk")
def test_a_full_disk_is_one_clear_error(monkeypatch: pytest.MonkeyPatch) -> None:
    def opened(**_: Any) -> Any:
        return Path("/dev/full").open("w+b", buffering=0)

    monkeypatch.setattr("tempfile.TemporaryFile", opened)
    with pytest.raises(OutputError) as refused:
        simulate_stored(*rig(), reference(1))
    assert isinstance(refused.value.__cause__, OSError) and refused.value.__cause__.errno == errno.ENOSPC


@pytest.mark.parametrize("lacking", [0, 1])
def test_room_for_a_run_and_its_errors_is_looked_for_beforehand(lacking: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (machine, controller), asked, told = rig(), reference(1), list[int]()
    signals = cl.judge(simulate_stored(machine, controller, asked), asked).signals
    assert isinstance(signals, Stored)
    monkeypatch.setattr("shutil.disk_usage", lambda _: SimpleNamespace(free=signals.file.end - lacking))
    with pytest.raises(OutputError) if lacking else nullcontext():
        cl.simulate_to_file(machine, controller, asked, tmp_path / "run.nc", progress=told.append)
    assert bool(told) == (tmp_path / "run.nc").exists() == (not lacking)


@pytest.mark.slow
def test_memory_does_not_grow_with_the_motion(tmp_path: Path) -> None:
    """The same lines at a tenth of the feed: ten times the samples, simulated, judged, written and drawn."""
    lines = [f"G1 X{0.2 * (i + 1):.4f} Y{5.0 + 3.0 * np.sin(0.05 * i):.4f} Z{-0.5 + 0.3 * np.cos(0.09 * i):.4f}" for i in range(150)]
    peaks = []
    for feed in (15.0, 1.5):
        text = "\n".join(["G21 G90 G64 P0.005", f"F{feed}", *lines, "M2", ""])
        (tmp_path / "part.ngc").write_text(text, encoding="utf-8")
        words = ["run", "part.ngc", "--machine", "xyz", "--controller", "builtin:xyz-controller", "--out", "out"]
        used = "resource.getrusage(resource.RUSAGE_SELF).ru_maxrss"
        code = f"import resource; from contourlab.cli.main import main; main({words!r}); print({used})"
        said = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True, cwd=tmp_path)
        peaks.append(int(said.stdout.split()[-1]))
    with h5py.File(tmp_path / "out" / "signals" / "base.nc") as written:
        n_sample = len(written["time"])
    assert n_sample > 2_500_000 and peaks[1] < 1.2 * peaks[0]


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
    write_switches(tmp_path / "switches.csv", found)
    with (tmp_path / "switches.csv").open(encoding="utf-8", newline="") as stream:
        (row,) = csv.DictReader(stream)
    assert (row["from"], row["to"], row["reason"]) == ('a, "b"', "line\nbreak", "because; of")
    assert (row["time_s"], row["sample"], row["arc_length_m"], row["line"]) == ("0.003", "3", "", "12")
