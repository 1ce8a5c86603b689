"""A drive with backlash around a circle, and the gap estimates of an observer at its motor.

Radius 25 mm from rest to rest at a stated feed; motor and load of the paper (J_m 5.2e-3, J_l 4.4e-3 kg m^2, k_s 950 N m/rad, lead 16 mm),
guides that rub with 40 N, a P-PI cascade on the motor's side (velocity loop 150 rad/s, K_v 30 1/s), motor encoder of 0.125 um. The y axis
reverses twice, the x axis once, not counting start and stop.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from component_rig import Array, make

import contourlab as cl
from contourlab.components.controller.cascade import Cascade

LEAD, RESOLUTION, RUB = 0.016, 0.125e-6, 40.0
TURN = 2.0 * math.pi / LEAD
DRIVE = {
    "motor_inertia": 5.2e-3,
    "load_inertia": 4.4e-3,
    "lead": LEAD,
    "stiffness": 950.0,
    "shaft_damping": 0.05,
    "motor_damping": 3e-4,
    "load_damping": 7e-4,
}
OFF = {"load_inertia": 4.4e-3, "coulomb": RUB, "load_damping": 7e-4, "torque_gain": 1.0}
"""Parameters that the observer may have wrong."""


LIGHT = {"motor_inertia": 2e-4, "mass": 33.0, "lead": 0.01, "stiffness": 253.0, "shaft_damping": 0.008, "load_damping": 4.13e-3}
"""A drive whose guides, at 40 N and more, hold the load before its inertia has thrown it across the gap."""


def observer(drive: dict[str, float] = DRIVE, **values: Any) -> Any:
    return make("gap_observer", "multiple-model", **{**drive, "coulomb": RUB, "resolution": RESOLUTION, **values})


def scene(
    feed: float, period: float, gap: float = 50e-6, watching: Any = None, drive: dict[str, float] = DRIVE, rub: float = RUB
) -> tuple[cl.Machine, cl.Controller, Any]:
    """Return machine, controller and reference of a circle at `feed` [mm/min]."""
    plant, friction = make("plant", "two-inertia", **drive, backlash_gap=gap), make("friction", "coulomb", coulomb=rub)
    encoder = make("sensor", "encoder", resolution=RESOLUTION)
    axes = tuple(cl.Axis(name, plant, friction, motor_sensor=encoder, substeps=max(1, round(period / 1.25e-4))) for name in "xy")
    turn = 2.0 * math.pi / drive["lead"]
    inertia = drive["motor_inertia"] + drive.get("load_inertia", 0.0) + drive.get("mass", 0.0) / turn**2
    servo = cl.AxisController(
        make("controller", "cascade", **Cascade.tune(150.0, 0.7, 1.0 / (inertia * turn), 0.0, 30.0)),
        velocity=make("velocity", "filtered-difference", bandwidth=3000.0),
        feedback="motor",
        velocity_feedback="motor",
        gap_observer=watching,
    )
    route = cl.route_from_path(cl.contour("circle", radius=0.025), feed / 60e3, dwell=0.1)
    limits = cl.AxisLimits(np.full(2, 0.5), np.full(2, 3.0), np.full(2, 60.0))
    return cl.Machine("geared", axes, period), cl.Controller(dict.fromkeys("xy", servo)), cl.plan(route, limits, period)


def estimates(feed: float, period: float, gaps: Array, part: float, seeds: int) -> tuple[Array, Array]:
    """Return gap and deviation after the circle, (axis, gap, 1 + seeds): first with exact parameters, then off by up to `part` each."""
    random = np.random.default_rng(20260)
    factors = 1.0 + part * random.uniform(-1.0, 1.0, (len(OFF), seeds))
    variants: dict[str, Array] = {}
    for axis in "xy":
        variants[f"axes.{axis}.plant.backlash_gap"] = np.repeat(gaps, 1 + seeds)
        for (name, value), factor in zip(OFF.items(), factors, strict=True):
            variants[f"controller.axes.{axis}.gap_observer.{name}"] = np.tile(value * np.append(1.0, factor), len(gaps))
    batch = cl.simulate_batch(*scene(feed, period, watching=observer()), variants, keep=("gap_estimate", "gap_deviation"), judge=False)
    shape = (2, len(gaps), 1 + seeds)
    return batch.signals["gap_estimate"][-1].reshape(shape), batch.signals["gap_deviation"][-1].reshape(shape)


def drawn(random: np.random.Generator) -> tuple[dict[str, float], float, float, float]:
    """Return a drive, its guides' friction [N], its gap [m] and a feed [mm/min], drawn from the ranges of feed drives."""
    lead = random.choice([5e-3, 10e-3, 16e-3, 20e-3])
    turn = 2.0 * math.pi / lead
    rotor = 10.0 ** random.uniform(-4.0, -2.2) * turn**2
    mass, pole = rotor * 10.0 ** random.uniform(-1.0, 0.7), random.uniform(600.0, 1900.0)
    reduced = rotor * mass / (rotor + mass)
    shaft = {"stiffness": pole**2 * reduced / turn**2, "shaft_damping": 0.04 * pole * reduced / turn**2}
    drive = {"motor_inertia": rotor / turn**2, "mass": mass, "lead": lead, **shaft, "motor_damping": 1e-4, "load_damping": 1e-4}
    gap, feed = math.exp(random.uniform(math.log(8e-6), math.log(120e-6))), random.choice([1000.0, 2000.0, 4000.0, 8000.0])
    return drive, mass * 10.0 ** random.uniform(-1.5, 0.6), gap, feed


def recorded(feed: float, period: float, gap: float, drive: dict[str, float] = DRIVE, rub: float = RUB) -> dict[str, Array]:
    """Return signals of the y axis from a run without an observer: the inputs of an observer, and the true values."""
    result = cl.simulate(*scene(feed, period, gap, None, drive, rub))
    applied = result["applied_command"][:, 1]
    return {
        "motor_position": RESOLUTION * np.rint(result["motor_position"][:, 1] / RESOLUTION),
        "applied": np.append(0.0, applied[:-1]),
        "load_position": result["axis_position"][:, 1],
        "load_velocity": result["axis_velocity"][:, 1],
        "gap_state": result["gap_state"][:, 1],
    }
