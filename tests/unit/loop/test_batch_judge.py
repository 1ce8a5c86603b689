"""The judge of a batch gives the figures of the exact judge at corners that the tool cuts, in loops that follow well and badly."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from stages import control, make, stage

import contourlab as cl
from contourlab.loop import batch, judging
from contourlab.loop.machine import AxisError
from contourlab.loop.parameters import with_values
from contourlab.metrics.judge import check_follows
from contourlab.result import Signal

MACHINE = """\
[machine]
name = "zigzag"
servo_period = "0.5 ms"
axes = ["x", "y"]
[axes."*".plant]
kind = "rigid-axis"
gain = "1.8 m/s^2/full_scale"
damping = "8 1/s"
[axes."*".friction]
kind = "coulomb"
coulomb = "0.05 full_scale"
[axes."*".drive]
kind = "delayed-saturation"
delay = "1 ms"
[axes."*".limits]
velocity = "12 m/min"
acceleration = "5 m/s^2"
jerk = "400 m/s^3"
"""
CONTROLLER = """\
[controller.axes."*"]
velocity = {kind = "filtered-difference", bandwidth = "2000 rad/s"}
[controller.axes."*".controller]
kind = "position"
velocity_gain = "%g full_scale*s/m"
position_gain = "%g full_scale/m"
integral_gain = "10 1/s"
model_gain = "1.7 m/s^2/full_scale"
model_damping = "9 1/s"
"""
SCENARIO = 'machine = "machine.toml"\ncontroller = "controller.toml"\nprogram = "part.ngc"\n'
GAIN = "axes.x.plant.gain"
FACTORS = (1.0, 1.1)


def zigzag(folder: Path, mode: str, turn: float, leg: float, position_gain: float, velocity_gain: float) -> cl.Scenario:
    """Return the scenario of ten legs [mm] that turn by an angle [deg] to both sides."""
    way = 0.3 + np.cumsum([0.0] + [np.radians(turn) * (1 if i % 2 else -1) for i in range(9)])
    places = np.cumsum(leg * np.column_stack([np.cos(way), np.sin(way)]), axis=0)
    lines = [f"G1 X{x:.9f} Y{y:.9f}" for x, y in places]
    (folder / "part.ngc").write_text("\n".join(["G17 G21 G90 G94", mode, "F3000", *lines, "M2", ""]))
    (folder / "machine.toml").write_text(MACHINE)
    (folder / "controller.toml").write_text(CONTROLLER % (velocity_gain, position_gain))
    (folder / "scenario.toml").write_text(SCENARIO)
    return cl.load_scenario(folder / "scenario.toml")


def exact(case: cl.Case, reference: cl.Reference, factor: float) -> cl.Metrics:
    x = case.machine.axis("x")
    plant = x.plant.replace(gain=x.plant.values()["gain"] * factor)
    machine = replace(case.machine, axes=tuple(replace(axis, plant=plant) if axis is x else axis for axis in case.machine.axes))
    return cl.summarise(cl.judge(cl.simulate(machine, case.controller, reference), reference), reference)


HARD_AND_SOFT = [(8000.0, 90.0), (100.0, 10.0)]


@pytest.mark.parametrize("mode", ["G61", "G64 P0.05"])
@pytest.mark.parametrize(("turn", "leg"), [(45.0, 6.0), (90.0, 6.0), (120.0, 6.0), (90.0, 1.0), (150.0, 1.5)])
@pytest.mark.parametrize("gains", [(2000.0, 40.0), *(pytest.param(pair, marks=pytest.mark.slow) for pair in HARD_AND_SOFT)])
def test_corners(tmp_path: Path, mode: str, turn: float, leg: float, gains: tuple[float, float]) -> None:
    case = zigzag(tmp_path, mode, turn, leg, *gains).base
    reference = case.reference()
    nominal = case.machine.axis("x").plant.values()["gain"]
    batch = cl.simulate_batch(case.machine, case.controller, reference, {GAIN: [nominal * factor for factor in FACTORS]}, part=True)
    assert not batch.unsure.any() and (batch.failed_at < 0).all()
    for i, factor in enumerate(FACTORS):
        found = exact(case, reference, factor)
        for name in ("rms", "mean", "max", "signed_mean", "integral"):
            of_batch, value = batch.figures[f"contour_error_{name}"][i], getattr(found.contour_error, name)
            assert of_batch == pytest.approx(value, rel=1e-7, abs=1e-12), (name, factor)
        for name in ("rms", "max"):
            assert batch.figures[f"part_error_{name}"][i] == pytest.approx(getattr(found.part_error, name), rel=1e-7, abs=1e-12)


def test_doubtful_variants_do_not_depend_on_their_neighbours() -> None:
    """Bits are the same in any order, grouping and number of threads, though some variants are judged twice and some fail."""
    machine = stage(sensor=make("sensor", "ideal"))
    reference = cl.uniform(cl.contour("butterfly"), 2.0, 1, machine.servo_period)
    name, gains = "controller.axes.*.controller.position_gain", np.geomspace(1.0, 3000.0, 40)
    machine = replace(machine, axes=tuple(replace(axis, limits=cl.Limits(following_error=0.038)) for axis in machine.axes))
    first = cl.simulate_batch(machine, control(coupled=False), reference, {name: gains}, threads=1)
    assert 0 < np.count_nonzero(first.failed_at >= 0) < 40
    assert not first.unsure[first.failed_at < 0].any() and first.unsure[first.failed_at >= 0].any()
    shuffle = np.random.default_rng(3).permutation(40)
    second = cl.simulate_batch(machine, control(coupled=False), reference, {name: gains[shuffle]}, threads=2)
    alone = cl.simulate_batch(machine, control(coupled=False), reference, {name: gains[30:31]})
    for figure, values in first.figures.items():
        assert np.array_equal(values[shuffle], second.figures[figure], equal_nan=True), figure
        assert np.array_equal(values[30:31], alone.figures[figure], equal_nan=True), figure


CHANGED: dict[str, dict[str, float]] = {"": {}, "cuts": {"CUT": 64}, "waiting": {"CUT": 64, "MOST_WAITING": 0}, "lag": {"LAG": 1e-9}}


@pytest.mark.parametrize(("changed", "again"), list(zip(CHANGED.values(), (0, 0, 1, 1), strict=True)), ids=CHANGED)
def test_samples_are_judged_at_once_at_the_end_or_in_a_second_run(
    changed: dict[str, float], again: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where a path passes near itself, the largest tracking error of the whole run decides which place may be the nearest."""
    machine, name = stage(sensor=make("sensor", "ideal")), "controller.axes.x.controller.position_gain"
    reference, controller = cl.uniform(cl.contour("butterfly"), 2.0, 1, machine.servo_period), control(coupled=False)
    gains, runs = np.geomspace(3.0, 100.0, 4), []
    monkeypatch.setattr(batch, "wider", lambda *given: (runs.append(given), judging.wider(*given))[1])
    for constant, value in ({"LAG": 1.0} | changed).items():
        for module in (judging, batch):
            monkeypatch.setattr(module, constant, value, raising=module is judging)
    found = cl.simulate_batch(machine, controller, reference, {name: gains})
    assert len(runs) == again and not found.unsure.any()
    for i, gain in enumerate(gains):
        run = cl.simulate(*with_values(machine, controller, {name: gain}), reference)
        errors = cl.summarise(cl.judge(run, reference), reference).contour_error
        for figure in ("rms", "mean", "max", "integral"):
            assert found.figures[f"contour_error_{figure}"][i] == pytest.approx(getattr(errors, figure), rel=1e-7, abs=1e-12), (figure, i)


def test_a_tool_far_behind_on_a_hatch_has_the_nearest_place_in_its_window() -> None:
    """The nearest line of a hatch is often at the end of the window, where rounding decides whether a place lies in it."""
    turns = [(x, 1e-4 * i) for i in range(60) for x in ((0.0, 2e-3) if i % 2 == 0 else (2e-3, 0.0))]
    corners = [*turns, (-1e-3, turns[-1][1]), (-1e-3, 0.0), (0.0, 0.0)]
    path = cl.Path([cl.Line(a, b) for a, b in pairwise(corners)], closed=True)
    machine, controller = stage(sensor=make("sensor", "ideal")), control(coupled=False)
    reference, head = cl.uniform(path, 0.1, 1, machine.servo_period), "controller.axes.y.controller."
    values = {"position_gain": 14.0, "integral_gain": 0.0, "model_gain": 1e6}
    named = {head + name: value for name, value in values.items()}
    found = cl.simulate_batch(machine, controller, reference, {name: [value] for name, value in named.items()})
    run = cl.simulate(*with_values(machine, controller, named), reference)
    errors = cl.summarise(cl.judge(run, reference), reference).contour_error
    assert found.figures["contour_error_max"][0] == pytest.approx(errors.max, rel=1e-7)
    assert found.figures["contour_error_rms"][0] == pytest.approx(errors.rms, rel=1e-7)


def test_a_contour_that_ends_where_it_starts_is_judged_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Start and end coincide, far apart along the path: a variant that follows well runs once."""
    case = zigzag(tmp_path, "G61", 90.0, 6.0, 8000.0, 90.0).base
    (tmp_path / "part.ngc").write_text("G17 G21 G90 G94 G61\nF3000\nG1 X20 Y5\nG1 X15 Y30\nG1 X-10 Y20\nG1 X0 Y0\nM2\n")
    monkeypatch.setattr("contourlab.loop.batch.wider", None)
    found = cl.simulate_batch(case.machine, case.controller, case.reference(), {GAIN: [1.8]}, part=True)
    assert found.figures["part_error_max"][0] == pytest.approx(exact(case, case.reference(), 1.0).part_error.max, rel=1e-7)


def test_a_tool_that_stands_still_has_no_figures() -> None:
    """It stands on the path, where its contour error is 0: a search would take gains that do nothing for the best."""
    machine = stage()
    machine = replace(machine, axes=tuple(replace(axis, limits=cl.Limits(following_error=0.1)) for axis in machine.axes))
    ring = cl.uniform(cl.contour("circle", radius=5e-3), 4.0, 2, machine.servo_period)
    variants = {"axes.*.plant.gain": machine.axes[0].plant.gain * np.array([1.0, 0.8, 1e-9])}
    found = cl.simulate_batch(machine, control(coupled=False), ring, variants)
    assert found.failed_at.tolist() == [-1, -1, ring.n_sample - 1]
    assert np.isnan(found.figures["contour_error_max"]).tolist() == [False, False, True]
    stuck = replace(machine, axes=tuple(replace(axis, plant=axis.plant.replace(gain=1e-9)) for axis in machine.axes))
    judged = cl.judge(cl.simulate(stuck, control(coupled=False), ring), ring)
    assert np.abs(judged["contour_error"]).max() < 1e-9
    with pytest.raises(cl.DivergenceError):
        check_follows(judged)


ARCS = [f"G{2 + i % 2} X{14 * i + 14} Y0 I7" for i in range(4)]


@pytest.mark.parametrize("gap", [0.0, 20e-6])
def test_the_same_positions_have_the_same_figures_on_arcs(tmp_path: Path, gap: float) -> None:
    """1 pm or 1e-6 of the exact judge, whichever is more, of a loop that follows within a micrometre; with play behind the encoder too."""
    zigzag(tmp_path, "G61", 45.0, 6.0, 40000.0, 300.0)
    (tmp_path / "part.ngc").write_text("\n".join(["G17 G21 G90 G94 F600", "G0 X0 Y0", *ARCS, "M2", ""]))
    case = cl.load_scenario(tmp_path / "scenario.toml").base
    reference = case.reference()
    machine = replace(case.machine, axes=tuple(replace(axis, error=AxisError(backlash=gap)) for axis in case.machine.axes))
    batch = cl.simulate_batch(machine, case.controller, reference, {"axes.x.plant.gain": [1.8, 1.9]}, keep=["axis_position"], part=True)
    run = cl.simulate(machine, case.controller, reference)
    for i in range(2):
        kept = Signal(batch.signals["axis_position"][:, :, i], ("sample", "axis"), "m")
        judged = cl.judge(run.with_signals(tool_position=kept, axis_position=kept), reference)
        known = cl.summarise(judged, reference)
        for source in ("contour_error", "part_error"):
            for name in ("rms", "max"):
                value = getattr(getattr(known, source), name)
                assert batch.figures[f"{source}_{name}"][i] == pytest.approx(value, rel=1e-6, abs=1e-12), (source, name, value)
