"""Axes in a machine: swapped, stacked, and away from where their encoders say they are."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from stages import PERIOD, control, make, stage, with_axis

import contourlab as cl
from contourlab.loop import simulate_blocks


def lump(name: str, mass: float, **changes: object) -> cl.Axis:
    """Return an axis of a plain mass in N and kg."""
    plant = make("plant", "mass-damper", mass=mass, damping=40.0, force_constant=50.0)
    return replace(cl.Axis(name, plant), **changes)  # type: ignore[arg-type]


def loops(names: str = "xy") -> cl.Controller:
    part = cl.AxisController(make("controller", "position", velocity_gain=60.0, position_gain=2000.0, integral_gain=5.0))
    return cl.Controller(dict.fromkeys(names, part))


def test_a_swapped_module_runs_as_one_that_was_always_there(circle: cl.Reference, controller: cl.Controller) -> None:
    machine = stage()
    other = replace(machine.axis("y"), name="spare", plant=machine.axis("y").plant.replace(gain=0.9))
    built = with_axis(machine, "x", plant=other.plant, friction=other.friction)
    swapped = machine.swapped("x", other)
    runs = [cl.simulate(one, controller, circle)["axis_position"] for one in (built, swapped)]
    assert np.array_equal(runs[0], runs[1])
    assert not np.array_equal(runs[0], cl.simulate(machine, controller, circle)["axis_position"])


def test_a_carried_module_adds_its_mass(circle: cl.Reference) -> None:
    stacked = cl.Machine("stack", (lump("x", 12.0), lump("y", 8.0, mounted_on="x", stage_mass=20.0)), PERIOD)
    apart = cl.Machine("apart", (lump("x", 32.0), lump("y", 8.0)), PERIOD)
    runs = [cl.simulate(one, loops(), circle)["axis_position"] for one in (stacked, apart)]
    assert stacked.carried_mass("x") == 20.0 and stacked.carried_mass("y") == 0.0
    assert np.array_equal(runs[0], runs[1])


def test_parallel_axes_push_back() -> None:
    """A rider on a free carrier: without damping and with the carrier's drive idle, what the one gains in momentum the other loses."""
    quiet = make("plant", "mass-damper", mass=5.0, damping=0.0, force_constant=50.0)
    rider = cl.Axis("y", quiet, mounted_on="x", alignment=1.0, stage_mass=0.0)
    carrier = cl.Axis("x", quiet.replace(mass=20.0), limits=cl.Limits(following_error=1.0))
    machine = cl.Machine("stack", (carrier, rider), 1e-4)
    idle = cl.AxisController(make("controller", "position"))
    controller = cl.Controller({"x": idle, "y": loops().axes["y"]})
    path = cl.Path([_line((0.0, 0.0), (0.0, 0.02))])
    reference = cl.plan(cl.route_from_path(path, 0.05), cl.AxisLimits(0.1, 1.0, 20.0), 1e-4)
    result = cl.simulate(machine, controller, reference)
    v = result["axis_velocity"]
    assert np.max(np.abs(v[:, 1])) > 0.03
    # The reaction is one tick late, hence the tolerance of a tick's acceleration.
    assert np.allclose(20.0 * v[:, 0], -5.0 * v[:, 1], atol=5.0 * 2.0 * 1e-4)


def _line(a: tuple[float, float], b: tuple[float, float]) -> object:
    from contourlab.geometry import Line

    return Line(a, b)


def test_mounting_in_a_circle_is_refused() -> None:
    with pytest.raises(cl.ContourlabError, match="circle"):
        cl.Machine("knot", (lump("x", 1.0, mounted_on="y"), lump("y", 1.0, mounted_on="x")), PERIOD)
    with pytest.raises(cl.ContourlabError, match="mounted_on"):
        cl.Machine("nowhere", (lump("x", 1.0, mounted_on="z"),), PERIOD)


def test_the_tool_is_where_lead_error_and_squareness_put_it(circle: cl.Reference, controller: cl.Controller) -> None:
    table = cl.AxisError(np.array([-0.01, 0.0, 0.01]), np.array([-3e-6, 0.0, 5e-6]))
    machine = replace(with_axis(stage(), "x", error=table), squareness={("y", "x"): 2e-4})
    result, plain = (cl.simulate(one, controller, circle) for one in (machine, stage()))
    x, y = result["axis_position"].T
    # The controller sees its encoders: nothing changes but the tool.
    assert np.array_equal(result["axis_position"], plain["axis_position"])
    assert result["tool_position"][:, 0] == pytest.approx(x + np.where(x < 0.0, 3e-4 * x, 5e-4 * x), abs=1e-15)
    assert result["tool_position"][:, 1] == pytest.approx(y + 2e-4 * x, abs=1e-15)
    radial = np.hypot(*result["tool_position"].T) - 5e-3
    assert np.abs(cl.judge(result, circle)["part_error"]) == pytest.approx(np.abs(radial), abs=1e-12)


def test_repeatability_is_a_new_offset_at_each_reversal(controller: cl.Controller) -> None:
    reference = cl.uniform(cl.contour("circle", radius=5e-3), 2.0, 40, PERIOD)
    machine = with_axis(stage(friction=make("friction", "none")), "x", error=cl.AxisError(repeatability=4e-6))
    result = cl.simulate(machine, controller, reference)
    offset = np.round((result["tool_position"] - result["axis_position"])[:, 0], 15)
    levels = offset[np.concatenate([[True], np.abs(np.diff(offset)) > 1e-12])]
    assert 75 <= levels.size <= 90  # two reversals a lap
    assert np.std(levels) == pytest.approx(1e-6, rel=0.25)
    again = [cl.simulate(machine, controller, reference, seed=seed)["tool_position"] for seed in (0, 1)]
    assert np.array_equal(again[0], result["tool_position"]) and not np.array_equal(again[1], again[0])


def test_memory_is_flat_when_a_run_is_streamed(machine: cl.Machine, controller: cl.Controller) -> None:
    """Ten times the laps, the same peak."""
    import tracemalloc

    peaks = []
    for laps in (20, 200):
        reference = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, laps, PERIOD)
        tracemalloc.start()
        for _ in simulate_blocks(machine, controller, reference, signals=("tool_position",), block=4096):
            pass
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 1.3 * peaks[0]


def test_values_out_of_range_are_refused() -> None:
    for bad in (0.0, -1.0, math.nan):
        with pytest.raises(cl.ContourlabError, match=r"limits\.velocity"):
            cl.Limits(velocity=bad)
        with pytest.raises(cl.ContourlabError, match="servo_period"):
            cl.Machine("m", (lump("x", 1.0),), bad)
    with pytest.raises(cl.ContourlabError, match="travel"):
        cl.Limits(travel=(1.0, 1.0))
    with pytest.raises(cl.ContourlabError, match="name of its own"):
        cl.Machine("m", (lump("x", 1.0), lump("x", 1.0)), PERIOD)
    with pytest.raises(cl.ContourlabError, match="squareness"):
        cl.Machine("m", (lump("x", 1.0), lump("y", 1.0)), PERIOD, {("x", "z"): 1e-5})
    with pytest.raises(cl.ContourlabError, match="estimator"):
        cl.Controller({}, None, control().coupling)
    with pytest.raises(cl.ContourlabError, match=r"error\.position"):
        cl.AxisError(np.array([0.0, 0.0]), np.zeros(2))
    with pytest.raises(cl.ContourlabError, match="repeatability"):
        cl.AxisError(repeatability=-1.0)
