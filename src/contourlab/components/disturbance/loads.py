"""Forces over time or position."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import Component, param, text_param
from contourlab.errors import ParameterError
from contourlab.primitives import clip, floor, lookup, sin


class Disturbance(Component):
    """Base: a force on an axis that is not friction."""

    family = "disturbance"


class ConstantLoad(Disturbance):
    """A constant force from a given time on: gravity on a vertical axis, a steady cutting force."""

    kind = "constant"
    reference = "constant load from a given time"
    example = {"force": 2.0, "start": 0.05}
    unbounded = ("force",)

    force: float = param(unit="{force}", doc="force along the axis")
    start: float = param(default=0.0, unit="s", minimum=0.0, doc="time from which it acts")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.force if clock.t >= par.start else 0.0,)


class SineLoad(Disturbance):
    """A force A sin(2 pi f t + phase): an unbalanced spindle, a tooth-passing force."""

    kind = "sine"
    reference = "harmonic load"
    example = {"amplitude": 2.0, "frequency": 12.0, "phase": 0.3}
    unbounded = ("phase",)
    derived = ("angular_frequency",)

    amplitude: float = param(unit="{force}", minimum=0.0, doc="amplitude, A")
    frequency: float = param(unit="Hz", minimum=0.0, doc="frequency, f")
    phase: float = param(default=0.0, unit="rad", doc="phase at time 0")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (2.0 * math.pi * par.frequency,)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.amplitude * sin(par.angular_frequency * clock.t + par.phase),)


class TableLoad(Disturbance):
    """A force given at evenly spaced times or positions, linear between them: measured cutting forces, force ripple, cogging.

    With ``beyond = "hold"`` the first and last values hold outside the table. With ``"repeat"`` the table repeats; its last point is the
    first of the next period.
    """

    kind = "table"
    reference = "linear interpolation of a table"
    example = {
        "over": "position",
        "beyond": "hold",
        "start_position": -0.3,
        "position_step": 0.2,
        "time_step": 0.01,
        "forces": (0.0, 1.0, -0.5, 2.0),
    }
    without_effect = ("start_time", "time_step")  # in the example, which is over position
    unbounded = ("start_time", "start_position", "forces")
    tables = ("values_table",)
    derived = ("origin", "inverse_step", "intervals")

    over: str = text_param(default="time", choices=("time", "position"), doc="abscissa of the table")
    beyond: str = text_param(default="hold", choices=("hold", "repeat"), doc="behaviour outside the table")
    start_time: float = param(default=0.0, unit="s", doc="time of the first value")
    time_step: float = param(default=math.inf, unit="s", minimum=0.0, exclusive=True, doc="time between two values; required over time")
    start_position: float = param(default=0.0, unit="m", display="mm", doc="position of the first value")
    position_step: float = param(
        default=math.inf,
        unit="m",
        minimum=0.0,
        exclusive=True,
        display="mm",
        doc='distance between two values; required with over = "position"',
    )
    forces: tuple[float, ...] = param(unit="{force}", vector=True, doc="forces, at least two")

    def check_values(self) -> None:
        if len(self.forces) < 2:
            raise ParameterError("forces", f"{list(self.forces)}", "a list of at least two numbers", "force")
        if getattr(self, f"{self.over}_step") == math.inf:
            raise ParameterError(f"{self.over}_step", "not given", f'given with over = "{self.over}", > 0')

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, over: str, beyond: str) -> Any:
        where = clock.t if over == "time" else inp.position
        u = (where - par.origin) * par.inverse_step
        u = u - par.intervals * floor(u / par.intervals) if beyond == "repeat" else clip(u, 0.0, par.intervals)
        i = clip(floor(u), 0.0, par.intervals - 1.0)
        low = lookup(par.values_table, i)
        return (), (low + (u - i) * (lookup(par.values_table, i + 1.0) - low),)

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        origin, step = (par.start_time, par.time_step) if self.over == "time" else (par.start_position, par.position_step)
        return origin, 1.0 / step, float(len(self.forces) - 1)

    def table_values(self) -> dict[str, Array]:
        return {"values_table": np.array(self.forces)}
