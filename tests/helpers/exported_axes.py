"""Axes with one controller each, for the tests of exported code."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np

from contourlab.components.contract import Component, Port, ports
from contourlab.components.registry import component, components
from contourlab.features.export.command import AxisControl, Recorded, axis_control, replayed
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.primitives import copysign, fabs

SLOTS = ("controller", "observer", "predictor", "feedforward", "compensation", "gap_observer", "velocity", "filter", "supervisor")
CASES = [f"{slot}/{kind.kind}" for slot in SLOTS for kind in components(slot)] + ["drive/delayed-saturation", "drive/unlimited"]
REFUSED = {"feedforward/zpetc", "supervisor/pre-routed", "controller/steps"}
"""They need the reference ahead, the arc length, and a plant that takes positions."""


class FlankOfTheMotion(Component):
    """A gap observer of a few lines beside a supervisor: the real one, of 2,000, has a case of its own."""

    family, kind = "gap_observer", "flank-of-the-motion"
    inputs = (Port("motor_position"), Port("applied"))
    outputs = ports("gap_state", "gap", "gap_deviation", "confidence", "load_position", "load_velocity")
    states = (Port("last_position"),)
    example: dict[str, Any] = {}

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        moved = inp.motor_position - x.last_position
        side, sure = 0.0, 0.5
        if fabs(moved) > 2e-5:
            side, sure = copysign(1.0, moved), 0.99
        return (inp.motor_position,), (side, 1e-5, 1e-6, sure, inp.motor_position - 5e-6 * side, 1e3 * moved)


def example(family: str, kind: str, **values: Any) -> Component:
    made = component(family, kind)
    return made(**{**made.example, **values})


@cache
def exported(case: str) -> AxisControl:
    """Return the controller of an axis that has this component beside a position loop."""
    slot, _, kind = case.partition("/")
    plant = example("plant", "two-inertia" if slot in ("gap_observer", "compensation", "supervisor") else "rigid-axis")
    drive = example("drive", "delayed-saturation" if slot in ("drive", "predictor") else "saturation")
    drive = drive.replace(limit={"unlimited": math.inf, "delayed-saturation": 100.0}.get(kind, 1e9))  # the examples' own limit hides all
    parts: dict[str, Any] = {"controller": example("controller", "position"), "velocity": example("velocity", "filtered-difference")}
    if slot == "filter":
        given = {"frequency": 150.0} if "frequency" in component(slot, kind).parameters else {}
        parts["filters"] = (("smooth", example("filter", kind, **given)),)
    elif slot != "drive":
        parts[slot] = example(slot, kind)
    if slot == "supervisor":
        n = getattr(parts[slot], "n_controller", 1)
        parts["others"] = tuple((f"other{k}", example("controller", "pid")) for k in range(1, n))
        parts["gap_observer"] = FlankOfTheMotion()
    axis = Axis("x", plant, drive=drive, substeps=50)
    return axis_control(Machine("stage", (axis,), 1e-3), Controller({"x": AxisController(**parts)}), "x")


def excited(found: AxisControl, n_sample: int = 400) -> Recorded:
    """Run a controller alone on smooth inputs with reversals, about 10 mm and 0.1 m/s."""
    t = 1e-3 * np.arange(n_sample)[:, None]
    scale = np.array([{"m": 0.01, "m/s": 0.1, "m/s^2": 1.0}[_unit(port.name)] for port in found.schedule.externals])
    phase = np.arange(len(scale))
    inputs = scale * (np.sin((23.0 + phase) * t + 0.1 * phase) + 0.3 * np.sin((91.0 + 7.0 * phase) * t))
    return replayed(found, inputs, np.zeros(n_sample))


def _unit(port: str) -> str:
    return {"velocity": "m/s", "acceleration": "m/s^2"}.get(port.rpartition("_")[2], "m")
