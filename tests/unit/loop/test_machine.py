"""Axes in a machine: swapped, stacked, and with errors between encoder and tool."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from refusals import refuses
from stages import PERIOD, control, make, stage, with_axis

import contourlab as cl
from contourlab.errors import FeedError, ParameterError
from contourlab.loop import simulate_blocks


def lump(name: str, mass: float, **changes: object) -> cl.Axis:
    """Return an axis with a plain mass, in N and kg."""
    plant = make("plant", "mass-damper", mass=mass, damping=40.0, force_constant=50.0)
    return replace(cl.Axis(name, plant), **changes)  # type: ignore[arg-type]


def loops(names: str = "xy") -> cl.Controller:
    part = cl.AxisController(make("controller", "position", velocity_gain=60.0, position_gain=2000.0, integral_gain=5.0))
    return cl.Controller(dict.fromkeys(names, part))


def test_a_swapped_module_runs_like_an_original_one(circle: cl.Reference, controller: cl.Controller) -> None:
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


def test_a_batch_of_carried_masses_keeps_the_module_on_top(circle: cl.Reference) -> None:
    machine = cl.Machine("stack", (lump("x", 12.0), lump("y", 8.0, mounted_on="x", stage_mass=20.0)), PERIOD)
    work_pieces = np.array([0.0, 1.0, 30.0])
    found = cl.simulate_batch(machine, loops(), circle, {"axes.x.plant.carried_mass": work_pieces}, keep=("axis_position",))
    for i, mass in enumerate(work_pieces):
        alone = cl.simulate(with_axis(machine, "x", plant=machine.axis("x").plant.replace(carried_mass=mass)), loops(), circle)
        assert np.abs(found.signals["axis_position"][:, :, i] - alone["axis_position"]).max() < 1e-9
    assert np.ptp(found.signals["axis_position"], axis=2).max() > 1e-5


SCREW = {"lead": 0.01, "torque_constant": 0.5, "efficiency": 1.0, "damping": 0.0}


def pushed(rider: object, *, carried: float = 0.0, alignment: float = 1.0, idle: str = "x") -> tuple[np.ndarray, np.ndarray]:
    """Return the velocities of an 80 kg carrier and a rider; one is driven, the other is free."""
    carrier = make("plant", "mass-damper", mass=80.0, damping=0.0, force_constant=500.0)
    wide = cl.Limits(following_error=10.0)
    axes = [cl.Axis("x", carrier, limits=wide), cl.Axis("y", rider, mounted_on="x", alignment=alignment, stage_mass=45.0, limits=wide)]  # type: ignore[arg-type]
    if carried:
        axes.append(lump("z", 1.0, mounted_on="y", stage_mass=carried))
    part = loops().axes["x"]
    controllers = dict.fromkeys("xyz"[: len(axes)], part) | {idle: cl.AxisController(make("controller", "position"))}
    ends = np.zeros((2, len(axes)))
    ends[1, 1 if idle == "x" else 0] = 0.02
    reference = cl.plan(cl.route_from_path(cl.Path([_line(*ends)]), 0.05), cl.AxisLimits(0.1, 1.0, 20.0), 1e-4)
    velocity = cl.simulate(cl.Machine("stack", tuple(axes), 1e-4), cl.Controller(controllers), reference)["axis_velocity"]
    return velocity[:, 0], velocity[:, 1]


@pytest.mark.parametrize("alignment", [1.0, -1.0, 0.3])
@pytest.mark.parametrize("carried", [0.0, 12.0])
@pytest.mark.parametrize("inertia", [0.0, 4.8e-4])
def test_the_reaction_of_the_rider_acts_on_its_carrier(inertia: float, carried: float, alignment: float) -> None:
    """Rotating inertia (189 kg at the screw of a 20 kg rider) does not push the carrier."""
    rider = make("plant", "ball-screw", mass=20.0, inertia=inertia, **SCREW)
    carrier_v, rider_v = pushed(rider, carried=carried, alignment=alignment)
    assert np.abs(rider_v).max() > 0.03
    # The 45 kg on the carrier include the 20 kg; a reaction is one tick late, hence a tolerance of one tick's acceleration.
    total = 80.0 + 45.0 + carried
    expected = -alignment * (20.0 + carried) / total * rider_v
    assert np.abs(carrier_v - expected).max() < 2.0 * 1e-4 * (1.0 + np.abs(np.gradient(rider_v, 1e-4)).max())
    assert np.abs(carrier_v).max() > 2e-3


def test_a_free_rider_stays_behind_when_its_carrier_moves_off() -> None:
    rider = make("plant", "ball-screw", mass=20.0, inertia=4.8e-4, **SCREW)
    seen = 20.0 + 4.8e-4 * (2.0 * math.pi / 0.01) ** 2
    carrier_v, rider_v = pushed(rider, idle="y")
    assert np.abs(carrier_v).max() > 0.03
    assert np.abs(rider_v + 20.0 / seen * carrier_v).max() < 2.0 * 1e-4 * np.abs(np.gradient(carrier_v, 1e-4)).max()


def test_perpendicular_axes_do_not_affect_each_other() -> None:
    carrier_v, rider_v = pushed(make("plant", "mass-damper", mass=5.0, force_constant=50.0), alignment=0.0)
    assert np.abs(rider_v).max() > 0.03 and not carrier_v.any()


def test_a_plant_identified_by_its_response_accepts_no_extra_mass() -> None:
    response = make("plant", "rigid-axis", gain=1.7, damping=10.0)
    with refuses(ParameterError, "3 kg", name="axes.x.plant", value='"rigid-axis"'):
        cl.Machine("stack", (cl.Axis("x", response), lump("y", 2.0, mounted_on="x", stage_mass=3.0)), PERIOD)
    for below, above in ((cl.Axis("x", response), lump("y", 2.0)), (lump("x", 2.0), cl.Axis("y", response))):
        with refuses(ParameterError, "must be 0 ", name="axes.y.alignment", value="0.5"):
            cl.Machine("stack", (below, replace(above, mounted_on="x", alignment=0.5)), PERIOD)
    cl.Machine("stack", (cl.Axis("x", response), cl.Axis("y", response, mounted_on="x")), PERIOD)


def _line(a: tuple[float, float], b: tuple[float, float]) -> object:
    from contourlab.geometry import Line

    return Line(a, b)


def test_mounting_in_a_circle_is_refused() -> None:
    with pytest.raises(cl.ContourlabError, match="cycle"):
        cl.Machine("knot", (lump("x", 1.0, mounted_on="y"), lump("y", 1.0, mounted_on="x")), PERIOD)
    with pytest.raises(cl.ContourlabError, match="mounted_on"):
        cl.Machine("nowhere", (lump("x", 1.0, mounted_on="z"),), PERIOD)


def test_the_tool_has_its_lead_and_squareness_error(circle: cl.Reference, controller: cl.Controller) -> None:
    table = cl.AxisError(np.array([-0.01, 0.0, 0.01]), np.array([-3e-6, 0.0, 5e-6]))
    machine = replace(with_axis(stage(), "x", error=table), squareness={("y", "x"): 2e-4})
    result, plain = (cl.simulate(one, controller, circle) for one in (machine, stage()))
    x, y = result["axis_position"].T
    # The controller sees its encoders, so only the tool changes.
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
    assert 75 <= levels.size <= 90  # two reversals per lap
    assert np.std(levels) == pytest.approx(1e-6, rel=0.25)
    again = [cl.simulate(machine, controller, reference, seed=seed)["tool_position"] for seed in (0, 1)]
    assert np.array_equal(again[0], result["tool_position"]) and not np.array_equal(again[1], again[0])


def test_memory_does_not_grow_when_a_run_is_streamed(machine: cl.Machine, controller: cl.Controller) -> None:
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


def test_machines_are_equal_by_their_values() -> None:
    """Tables of errors are arrays, whose own comparison has no truth value."""

    def with_error(end: float) -> cl.Machine:
        return with_axis(stage(), "x", error=cl.AxisError(np.array([0.0, 0.1]), np.array([0.0, end])))

    assert with_error(1e-6) == with_error(1e-6) != with_error(2e-6)


def test_values_out_of_range_are_refused() -> None:
    for bad in (0.0, -1.0, math.nan):
        with pytest.raises(cl.ContourlabError, match=r"limits\.velocity"):
            cl.Limits(velocity=bad)
        with pytest.raises(cl.ContourlabError, match="servo_period"):
            cl.Machine("m", (lump("x", 1.0),), bad)
    with pytest.raises(cl.ContourlabError, match="travel"):
        cl.Limits(travel=(1.0, 1.0))
    with refuses(ParameterError, name="axes", value="x, x"):
        cl.Machine("m", (lump("x", 1.0), lump("x", 1.0)), PERIOD)
    with pytest.raises(cl.ContourlabError, match="squareness"):
        cl.Machine("m", (lump("x", 1.0), lump("y", 1.0)), PERIOD, {("x", "z"): 1e-5})
    with pytest.raises(cl.ContourlabError, match="estimator"):
        cl.Controller({}, None, control().coupling)
    with pytest.raises(cl.ContourlabError, match=r"error\.position"):
        cl.AxisError(np.array([0.0, 0.0]), np.zeros(2))
    with pytest.raises(cl.ContourlabError, match="repeatability"):
        cl.AxisError(repeatability=-1.0)


@pytest.mark.parametrize(
    ("limits", "wanted"),
    [
        (cl.Limits(acceleration=1.0), " y .*velocity"),
        (cl.Limits(velocity=0.5), " y .*jerk"),
    ],
)
def test_limits_unsuitable_for_planning_name_the_axis(limits: cl.Limits, wanted: str) -> None:
    plant = make("plant", "rigid-axis", gain=1.0)
    whole = cl.Axis("x", plant, limits=cl.Limits(velocity=0.5, jerk=40.0))
    with pytest.raises(FeedError, match=wanted):
        cl.Machine("m", (whole, cl.Axis("y", plant, limits=limits)), 1e-3).planner_limits()


def test_filters_have_names() -> None:
    low = make("filter", "low-pass", frequency=100.0)
    assert cl.AxisController(filters={"low": low}) == cl.AxisController(filters=(("low", low),))
    for wrong in ((low,), low, 3):
        with refuses(ParameterError, name="filters"):
            cl.AxisController(filters=wrong)
