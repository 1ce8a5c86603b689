"""A drive with backlash around a circle, and what an observer at its motor says of the gap.

Radius 25 mm from rest to rest at a stated feed; motor and load of the paper (J_m 5.2e-3, J_l 4.4e-3 kg m^2, k_s 950 N m/rad, lead 16 mm),
guides that rub with 40 N, a P-PI cascade on the motor's side (velocity loop 150 rad/s, K_v 30 1/s), motor encoder of 0.125 um. The y axis
turns round twice, the x axis once, besides where it starts and stops.
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
"""What the observer may have wrong."""


def observer(**values: Any) -> Any:
    return make("gap_observer", "multiple-model", **{**DRIVE, "coulomb": RUB, "resolution": RESOLUTION, **values})


def scene(feed: float, period: float, gap: float = 50e-6, watching: Any = None) -> tuple[cl.Machine, cl.Controller, Any]:
    """Return machine, controller and reference of a circle at `feed` [mm/min]."""
    plant, friction = make("plant", "two-inertia", **DRIVE, backlash_gap=gap), make("friction", "coulomb", coulomb=RUB)
    encoder = make("sensor", "encoder", resolution=RESOLUTION)
    axes = tuple(cl.Axis(name, plant, friction, motor_sensor=encoder, substeps=max(1, round(period / 1.25e-4))) for name in "xy")
    servo = cl.AxisController(
        make("controller", "cascade", **Cascade.tune(150.0, 0.7, 1.0 / (9.6e-3 * TURN), 0.0, 30.0)),
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


def recorded(feed: float, period: float, gap: float) -> dict[str, Array]:
    """Return what a run without an observer was like, of the y axis: what an observer would be fed, and the truth."""
    result = cl.simulate(*scene(feed, period, gap))
    applied = result["applied_command"][:, 1]
    return {
        "motor_position": RESOLUTION * np.rint(result["motor_position"][:, 1] / RESOLUTION),
        "applied": np.append(0.0, applied[:-1]),
        "load_position": result["axis_position"][:, 1],
        "load_velocity": result["axis_velocity"][:, 1],
        "gap_state": result["gap_state"][:, 1],
    }
