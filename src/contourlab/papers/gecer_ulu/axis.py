"""Gecer Ulu et al., one axis: the loop of eq (8), its lag, and Fig 4."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain
from typing import Any

import numpy as np

from contourlab.analysis.linear.coupled_loop import coupled_loop
from contourlab.components.sensor.encoder import Encoder
from contourlab.feed import plan, route_from_path
from contourlab.geometry import Line, Path
from contourlab.loop import Controller, Machine, simulate
from contourlab.papers.gecer_ulu.setup import SIMULATION, controller_of, machine_of
from contourlab.papers.rows import COMPUTED, INPUT, Row, derived, ours, printed

FIG_4 = {25e-9: 121.53, 1e-6: 312.14}
"""Rms of the tracking error [nm] by the encoder's resolution [m], as printed."""
TRAVEL, FEED = 30e-6, 0.1214e-6
"""Travel [m], a stretch of the 7 mm of Fig 4, and feedrate [m/s], chosen to reproduce the printed figure of the finer encoder."""
COUNTS = {25e-9: "25 nm", 1e-6: "1 um"}
PERIOD, LAG = 0.03, 1.0
"""Servo period and T_a [s]."""


def axis_rows() -> Iterator[Row]:
    """Yield the rows of one axis."""
    return chain(_loop(), _fig_4())


def _loop() -> Iterator[Row]:
    """Yield rows for eq (8) on the speed error and on the position error."""
    machine, controller = machine_of(SIMULATION), controller_of(SIMULATION, 0.0)
    notes = {
        "speed": "u = K_I e + K_P e' + K_D e'': L = 1/(T_a s), with the pole at -1/T_a",
        "position": "u = K_P e + K_I int e + K_D e': L = 1/(T_a s^2) has no damping, and the hold makes it unstable",
    }
    for structure, note in notes.items():
        axes = {name: replace(part, controller=part.controller.replace(structure=structure)) for name, part in controller.axes.items()}
        loop = coupled_loop(machine, replace(controller, axes=axes)).axes[0].loop
        yield ours("largest pole of the sampled loop", f"eq (8) on the {structure} error", float(np.abs(loop.poles).max()), "", note)
    lag = tracking(TRAVEL, FEED, None)[1] / (1e9 * FEED)
    note = "tracking error over speed, including the ends of the move"
    yield derived("lag over speed", "T_a 1 s", 1e3 * LAG, 1e3 * lag, "ms", 50.0, note)


def tracking(travel: float, feed: float, resolution: float | None) -> tuple[float, float]:
    """Drive a stage along an S-curve [m, m/s]; return the rms tracking error [nm] seen by the encoder, and the true one.

    A `resolution` [m] of None means no encoder.
    """
    x = machine_of(SIMULATION).axis("x")
    changed: dict[str, Any] = {} if resolution is None else {"sensor": Encoder(resolution=resolution)}
    machine = Machine("stage", (replace(x, **changed),), PERIOD)
    controller = Controller({"x": controller_of(SIMULATION, 0.0).axes["x"]})
    reference = plan(route_from_path(Path([Line((0.0,), (travel,))]), feed), machine.planner_limits(), PERIOD)
    run = simulate(machine, controller, reference)
    seen, true = (run["reference"][:, 0] - run[name][:, 0] for name in ("position", "axis_position"))
    return 1e9 * float(np.sqrt(np.mean(seen**2))), 1e9 * float(np.sqrt(np.mean(true**2)))


def _fig_4() -> Iterator[Row]:
    fine, coarse = FIG_4.values()
    for resolution, paper in FIG_4.items():
        seen, true = tracking(TRAVEL, FEED, resolution)
        note = f"true error {true:.4g} nm; " + (
            "the feed is chosen for this figure" if paper == fine else "the axis also chatters at the edge of a count"
        )
        kind = INPUT if paper == fine else COMPUTED
        yield printed("Fig 4 tracking rms", f"{COUNTS[resolution]} encoder", paper, seen, "nm", 0.2 * paper, note, kind=kind)
    counted = math.sqrt(fine**2 + (1000.0**2 - 25.0**2) / 12.0)
    note = "variance q^2/12 of 1 um instead of 25 nm: counting alone explains the printed difference"
    yield derived("Fig 4 tracking rms", "1 um encoder, from the printed 121.53 nm", coarse, counted, "nm", 0.01 * coarse, note)
