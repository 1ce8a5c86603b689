"""The causes named by the verdict, on machines with a known answer."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import pytest
from component_rig import make

import contourlab as cl
from contourlab.features.run.causes import causes
from contourlab.features.run.record import simulate_stored
from contourlab.features.run.verdict import verdict
from contourlab.feed import AxisLimits, Reference, plan, route_from_path
from contourlab.geometry import Line, Path

PERIOD = 1e-3
MASS, FORCE = 10.0, 50.0


def axis(name: str, **slots: Any) -> cl.Axis:
    plant = make("plant", "mass-damper", mass=MASS, damping=0.0, force_constant=FORCE)
    return replace(cl.Axis(name, plant, limits=cl.Limits(following_error=0.1)), **slots)


def loop(velocity_gain: float = 40.0, position_gain: float = 2000.0, model_gain: float | None = None) -> cl.AxisController:
    own = {"model_gain": model_gain} if model_gain else {}
    return cl.AxisController(make("controller", "position", velocity_gain=velocity_gain, position_gain=position_gain, **own))


def followed(*axes: cl.Axis, loops: dict[str, cl.AxisController] | None = None, reference: Reference | None = None) -> Any:
    """Run, judge, and split the error at the worst place: (contributions, causes that cannot be separated, error)."""
    machine = cl.Machine("made", axes, PERIOD)
    controller = cl.Controller(loops or dict.fromkeys(machine.axis_names, loop(model_gain=FORCE / MASS)))
    reference = reference or cl.uniform(cl.contour("circle", radius=0.02), 0.5, 2, PERIOD)
    judged = cl.judge(cl.simulate(machine, controller, reference), reference)
    start, stop = reference.laps[-1]
    sample = start + int(np.argmax(np.abs(judged["part_error"][start:stop])))
    found, untold = causes(machine, controller, reference, judged, sample)
    error = float(abs(judged["part_error"][sample]))
    assert sum(cause.contribution for cause in found) == pytest.approx(error, abs=1e-15)
    assert sum(cause.share for cause in found) == pytest.approx(1.0) and all(0.0 <= cause.share <= 1.0 for cause in found)
    assert [cause.share for cause in found] == sorted((cause.share for cause in found), reverse=True)
    return {cause.name: cause.contribution for cause in found}, untold, error


def only(found: dict[str, float], name: str, of: float) -> None:
    """Check that one cause explains the error to a hundredth."""
    assert found[name] == pytest.approx(of, rel=0.01)
    assert all(abs(value) < 0.01 * of for other, value in found.items() if other != name)


def test_an_error_map_is_geometry() -> None:
    bent = cl.AxisError(np.array([-0.02, 0.02]), np.array([0.0, 50e-6]))
    found, untold, error = followed(axis("x", error=bent), axis("y"))
    assert error > 40e-6 and untold == ()
    only(found, "geometry", error)


def test_coarse_encoders_are_quantisation() -> None:
    coarse = make("sensor", "encoder", resolution=100e-6)
    found, _, error = followed(axis("x", sensor=coarse), axis("y", sensor=coarse))
    assert 10e-6 < error < 300e-6
    assert found["quantisation"] > 0.95 * error


def test_an_external_load_is_a_disturbance_and_not_friction() -> None:
    """A proportional loop yields by load / stiffness: 100 N against 2000 A/m * 50 N/A is a millimetre."""
    pushed = axis("x", disturbance=make("disturbance", "constant", force=100.0))
    found, _, error = followed(pushed, axis("y"))
    assert error == pytest.approx(1e-3, rel=0.03)
    assert found["disturbance"] == pytest.approx(error, rel=0.03)
    assert found["friction"] == 0.0


def test_friction_is_a_cause() -> None:
    rubbing = axis("x", friction=make("friction", "coulomb", coulomb=100.0, breakaway=100.0, stribeck_velocity=1e-3))
    found, _, error = followed(rubbing, axis("y"))
    assert error == pytest.approx(1e-3, rel=0.05)
    (name,) = set(found) & {"friction", "reversal", "breakaway"}
    assert found[name] == pytest.approx(error, rel=0.03)
    assert found["disturbance"] == 0.0


def test_friction_that_is_fed_forward_is_no_larger_cause_than_the_error() -> None:
    """Without the friction its feedforward would push the axis off; both are taken away together."""
    rubbing = axis("x", friction=make("friction", "coulomb", coulomb=100.0, breakaway=100.0, stribeck_velocity=1e-3))
    fed = make("feedforward", "friction", coulomb=90.0, breakaway=90.0, smoothing_velocity=1e-3, force_constant=FORCE)
    own = loop(model_gain=FORCE / MASS)
    found, _, error = followed(rubbing, axis("y"), loops={"x": replace(own, feedforward=fed), "y": own})
    assert error > 10e-6
    assert all(abs(value) <= 1.05 * error for value in found.values())


@pytest.mark.parametrize(("turns", "name"), [(True, "reversal"), (False, "breakaway")])
def test_friction_after_a_reversal_differs_from_a_start_from_rest(turns: bool, name: str) -> None:
    """A stiff loop shows friction right after the motion of an axis begins: y moves along x, then starts or turns."""
    points = [(0.0, 0.0), (0.02, 0.02), (0.04, 0.0)] if turns else [(0.0, 0.0), (0.02, 0.0), (0.04, 0.02)]
    path = Path(Line.many(np.array(points[:-1]), np.array(points[1:])))
    limits = AxisLimits([0.2, 0.2], [2.0, 2.0], [50.0, 50.0])
    reference = plan(route_from_path(path, 0.05), limits, PERIOD)
    rubbing = axis("y", friction=make("friction", "coulomb", coulomb=100.0, breakaway=100.0, stribeck_velocity=1e-3))
    machine = cl.Machine("made", (axis("x"), rubbing), PERIOD)
    controller = cl.Controller(dict.fromkeys("xy", loop(200.0, 40_000.0, model_gain=FORCE / MASS)))
    judged = cl.judge(cl.simulate(machine, controller, reference), reference)
    corner = int(np.searchsorted(judged["arc_length"], path.breaks[1] + 1e-9))
    found = {cause.name: cause.contribution for cause in causes(machine, controller, reference, judged, corner + 20)[0]}
    assert found[name] > 0.9 * float(abs(judged["part_error"][corner + 20])) > 1e-6


def test_a_drive_at_its_limit_is_saturation() -> None:
    """The circle needs 4.93 m/s^2 at 2.5 Hz from a drive that gives 4.5."""
    weak = make("drive", "saturation", limit=0.9)
    fast = cl.uniform(cl.contour("circle", radius=0.02), 2.5, 3, PERIOD)
    found, _, error = followed(axis("x", drive=weak), axis("y", drive=weak), reference=fast)
    free = followed(axis("x"), axis("y"), reference=fast)
    assert error > 100e-6 > free[2]
    assert found["saturation"] > 0.9 * error and free[0]["saturation"] == 0.0


def lag_gain(velocity_gain: float, position_gain: float) -> float:
    """Return |position / reference| at 0.5 Hz of x'' = a (K_P (r - x) + K_V (r' - x')): no feedforward of the acceleration."""
    s = 1j * math.pi
    loop = FORCE / MASS * (velocity_gain * s + position_gain)
    return abs(loop / (s * s + loop))


def test_equal_loops_without_feedforward_only_lag() -> None:
    """Both axes overshoot equally: the circle grows by |G| - 1."""
    found, _, error = followed(axis("x"), axis("y"), loops=dict.fromkeys("xy", loop(40.0, 300.0)))
    grown = 0.02 * (lag_gain(40.0, 300.0) - 1.0)
    assert error == pytest.approx(grown, rel=0.02) and grown > 50e-6
    only(found, "lag", error)


def test_a_run_that_starts_in_motion_is_repeated_in_motion() -> None:
    """Started from rest instead, the transient would count as a mismatch of two equal axes."""
    machine = cl.Machine("made", (axis("x"), axis("y")), PERIOD)
    controller = cl.Controller(dict.fromkeys("xy", loop()))
    reference = cl.uniform(cl.contour("circle", radius=0.02), 0.5, 2, PERIOD)
    rerun = partial(simulate_stored, moving=True)
    found, _ = causes(machine, controller, reference, cl.judge(rerun(machine, controller, reference), reference), 20, rerun)
    assert {cause.name: cause.contribution for cause in found}["servo mismatch"] == pytest.approx(0.0, abs=1e-12)


def test_a_load_on_a_spring_is_compliance() -> None:
    """Under feedback from the motors the circle of the loads grows by (w/w_a)^2, with w_a^2 = k/m_l = (1 - 0.6) w_r^2."""
    spring = make("plant", "two-mass", mass=MASS, force_constant=FORCE, resonance=30.0, damping_ratio=0.05, load_share=0.6)
    parts = {name: replace(loop(model_gain=FORCE / MASS), feedback="motor") for name in "xy"}
    found, untold, error = followed(axis("x", plant=spring), axis("y", plant=spring), loops=parts)
    assert not untold and error == pytest.approx(0.02 * (0.5 / 30.0) ** 2 / 0.4, rel=0.03)
    assert found["compliance"] == pytest.approx(error, rel=0.02)


def test_unequal_loops_are_a_mismatch() -> None:
    """At the worst place one axis causes the error; a machine of equal axes has the mean of both there."""
    loops = {"x": loop(40.0, 300.0), "y": loop(40.0, 900.0)}
    found, _, error = followed(axis("x"), axis("y"), loops=loops)
    assert abs(found["servo mismatch"]) > 0.3 * error
    assert found["geometry"] == found["quantisation"] == found["friction"] == found["saturation"] == 0.0


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_planned_path_off_the_programmed_one_is_planning(side: float) -> None:
    """The planner drives a circle of another radius than programmed, and a stiff loop follows: inside or outside, it counts as positive."""
    programmed = cl.contour("circle", radius=0.02)
    planned = cl.contour("circle", radius=0.02 + side * 100e-6)
    reference = replace(cl.uniform(planned, 0.5, 2, PERIOD), programmed=programmed)
    found, _, error = followed(axis("x"), axis("y"), reference=reference)
    assert error == pytest.approx(100e-6, rel=0.05)
    assert found["planning"] == pytest.approx(100e-6, rel=0.01)


def test_a_cause_whose_removal_diverges_is_named_and_the_sum_still_holds() -> None:
    """Only viscous friction stabilises this loop: without it the poles leave the unit circle."""
    held = make("friction", "coulomb", coulomb=1.0, breakaway=1.0, stribeck_velocity=1e-3, viscous=900.0)
    wild = cl.AxisController(make("controller", "position", velocity_gain=1e-3, position_gain=2000.0, integral_gain=20.0, structure="ipv"))
    found, untold, error = followed(axis("x", friction=held), axis("y", friction=held), loops=dict.fromkeys("xy", wild))
    assert "friction" in untold and not set(found) & {"friction", "reversal", "breakaway"}
    assert all(math.isfinite(value) for value in found.values())
    assert error > 0.0


def test_a_passed_verdict_names_no_cause_unless_asked() -> None:
    machine = cl.Machine("made", (axis("x"), axis("y")), PERIOD)
    controller = cl.Controller(dict.fromkeys("xy", loop(40.0, 300.0)))
    reference = cl.uniform(cl.contour("circle", radius=0.02), 0.5, 2, PERIOD)
    judged = cl.judge(cl.simulate(machine, controller, reference), reference)
    error = float(np.abs(judged["part_error"][slice(*reference.laps[-1])]).max())
    short = verdict(machine, controller, reference, judged, 1.01 * error, explain=False)
    long = verdict(machine, controller, reference, judged, 0.99 * error)
    assert (short.passed, short.causes, short.findings) == (True, (), ())
    assert not long.passed and long.causes and long.findings
    assert short.worst.value == long.worst.value == error
