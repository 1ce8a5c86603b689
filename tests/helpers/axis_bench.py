"""Drive a plant of known parameters tick by tick in open loop: records for identification."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.components.controller.position import PositionController
from contourlab.engine.runner import make_group
from contourlab.geometry import Line, Path
from contourlab.loop.machine import Axis, AxisController, Controller, Limits, Machine
from contourlab.loop.simulate import jit_enabled
from contourlab.loop.template import build

Array = NDArray[np.float64]


def driven(plant: Any, command: Array, period: float, signal: str = "position", **parts: Any) -> Array:
    """Return a signal of an axis under a held command; parts are its friction, sensor, drive."""
    axis = Axis(name="x", plant=plant, limits=Limits(following_error=math.inf), **parts)
    # The signal fed as reference acceleration becomes the command.
    controller = Controller({"x": AxisController(PositionController(model_gain=1.0))})
    loop = build(Machine("bench", (axis,), period), controller, Path([Line(np.zeros(1), np.ones(1))]), np.zeros(1))
    fed = np.zeros((command.size, 5))
    fed[:, 2] = command
    log = make_group(loop.schedule, 1, slice(0, 1), jit_enabled()).run(fed, [loop.schedule.row(s) for s in loop.signals[signal]])
    return np.asarray(log[:, 0, 0])
