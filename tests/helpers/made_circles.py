"""Circles with known errors, in closed form."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from contourlab.arrays import Array
from contourlab.features.circle.runs import CircleRun, find_circle, runs_of

RADIUS, FEED, PERIOD = 0.05, 0.05, 2e-3


def positions(clockwise: bool, start: float = 0.3, noise: float = 2e-8, turns: float = 1.0, **size: float) -> tuple[Array, Array]:
    """Return command and position (n, 2) [m] of a circle.

    Sizes: `x`, `y` backlash [m]; `play` lateral play of x [m]; `square` [rad]; `scale`; `lag` of x [s]; `cyclic` amplitude [m] of x at
    10 mm; `shake` amplitude [m] of y at 60 Hz; `spike` height [m] of x.
    """
    sense = -1.0 if clockwise else 1.0
    t = np.arange(0.0, turns * 2.0 * math.pi * RADIUS / FEED, PERIOD)
    phi = start + sense * FEED / RADIUS * t
    x, y = RADIUS * np.cos(phi), RADIUS * np.sin(phi)
    vx, vy = -sense * FEED * np.sin(phi), sense * FEED * np.cos(phi)
    get = dict.fromkeys(("x", "y", "play", "square", "scale", "lag", "cyclic", "shake", "spike"), 0.0) | size
    gone = np.mod(sense * phi, math.pi) / 0.03
    ex = 0.5 * get["scale"] * x + get["square"] * y - get["lag"] * vx - 0.5 * get["x"] * np.sign(vx)
    ex += get["cyclic"] * np.cos(2.0 * math.pi * x / 0.01) + get["spike"] * np.sign(x) * gone * np.exp(1.0 - gone)
    ey = -0.5 * get["scale"] * y - 0.5 * get["y"] * np.sign(vy) - 0.5 * get["play"] * np.sign(vx)
    ey += get["shake"] * np.cos(2.0 * math.pi * 60.0 * t)
    command = np.column_stack([x, y])
    return command, command + np.column_stack([ex, ey]) + noise * np.random.default_rng(int(clockwise)).standard_normal(command.shape)


def behind(motor: Array, gap: float, held: float = math.inf, period: float = 1e-3) -> Array:
    """Return the position of a load (n,) that its motor carries with the flanks of a gap; friction slows it by `held` [m/s^2]."""
    load, at, speed, before = list[float](), float(motor[0]), 0.0, float(motor[0])
    for x in motor.tolist():  # floats of Python are faster here, with the same bits
        speed -= min(max(speed, -held * period), held * period)
        free = at + speed * period
        at = min(max(free, x - 0.5 * gap), x + 0.5 * gap)
        if at != free:
            speed = (x - before) / period  # an impact without a bounce
        load.append(at)
        before = x
    return np.array(load)


def runs_behind(gaps: tuple[float, float], noise: float = 2e-7, held: float = math.inf, **size: float) -> list[CircleRun]:
    """Return runs of both senses, measured at loads behind play, of motors with known errors."""
    made: list[CircleRun] = []
    for clockwise in (False, True):
        command, motor = positions(clockwise, 0.3, 0.0, 1.6, **size)
        load = np.column_stack([behind(column, gap, held, PERIOD) for column, gap in zip(motor.T, gaps, strict=True)])
        load += noise * np.random.default_rng(int(clockwise)).standard_normal(load.shape)
        made += runs_of("made", load, PERIOD, find_circle(command), command)
    return [CircleRun(r.name, r.clockwise, RADIUS, r.turned, r.deviation, FEED, r.lag) for r in made]


def runs(start: float = 0.3, senses: tuple[bool, ...] = (False, True), noise: float = 2e-8, **size: float) -> list[CircleRun]:
    """Return runs of circles with known errors."""
    made: list[CircleRun] = []
    for clockwise in senses:
        command, position = positions(clockwise, start, noise, **size)
        made += runs_of("made", position, PERIOD, find_circle(command), command)
    return [CircleRun(r.name, r.clockwise, RADIUS, r.turned, r.deviation, FEED, r.lag) for r in made]


def write_log(file: Path, senses: tuple[bool, ...] = (False, True), **size: float) -> Path:
    """Write a log of circles in mm, with rest and a line to each circle."""
    rows = []
    for clockwise in senses:
        command, position = positions(clockwise, **size)
        lead = np.linspace([0.0, 0.0], command[0], 1000)
        rows += [np.hstack([lead, lead]), np.hstack([command, position]), np.repeat(np.hstack([command, position])[-1:], 200, axis=0)]
    table = np.concatenate(rows)
    head = "time [s],reference.x [mm],reference.y [mm],position.x [mm],position.y [mm]"
    time = PERIOD * np.arange(len(table))
    np.savetxt(file, np.column_stack([time, 1e3 * table]), fmt="%.6f", delimiter=",", header=head, comments="")
    return file
