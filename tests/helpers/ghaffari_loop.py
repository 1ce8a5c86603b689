"""The loop of Ghaffari & Ulsoy written a second time from the paper's equations and tables; it shares no code with contourlab.

Differences: between ticks the plant moves by the closed-form exponential, with reversals from the logarithm; the foot point is iterated to
convergence in the curve's own parameter. Lengths in mm, as the paper prints them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Axis(NamedTuple):
    """Section III: a [mm/s^2], b [1/s], stiction in parts of full scale."""

    a: float
    b: float
    stiction: float


class Line(NamedTuple):
    """A line of Tables II and III."""

    ah: float
    bh: float
    kv: float
    kp: float
    ki: float
    a: float
    b: float


AXES = {1: Axis(1695.0, 10.1, 0.055), 2: Axis(648.0, 6.5, 0.088), 3: Axis(1116.0, 5.8, 0.077)}
TABLE_2 = {
    1: Line(1695.0, 10.1, 0.057, 2.12, 11.82, 873.0, 19.7),
    2: Line(648.0, 6.5, 0.060, 2.45, 11.82, 754.0, 24.7),
    3: Line(1116.0, 5.8, 0.062, 2.31, 11.82, 801.0, 19.9),
}
TABLE_3 = {
    1: Line(600.0, 20.0, 0.1, 4.0, 11.8, 900.0, 30.0),
    2: Line(600.0, 20.0, 0.1, 4.0, 11.8, 900.0, 30.0),
    3: Line(1000.0, 25.0, 0.1, 4.0, 11.8, 900.0, 25.0),
}
COUNT = 0.125e-3
"""Table I: the encoder's count [mm]."""


@dataclass(frozen=True)
class Open:
    """Values that the paper leaves open, as in contourlab's reproduction."""

    period: float = 1e-3
    wd: float = 200.0
    wz: float = 2000.0
    wv: float = 800.0
    weight: float = 0.75
    euler: bool = False
    observer: bool = True


class Shape(NamedTuple):
    """A closed curve: position, first and second derivative at a parameter 0 .. 2 pi."""

    at: Callable[[float], tuple[tuple[float, float], tuple[float, float], tuple[float, float]]]


def ellipse(a: float, b: float) -> Shape:
    """x = a cos u, y = b sin u."""

    def at(u: float) -> tuple[tuple[float, float], tuple[float, float], tuple[float, float]]:
        c, s = math.cos(u), math.sin(u)
        return (a * c, b * s), (-a * s, b * c), (-a * c, -b * s)

    return Shape(at)


def lemniscate(a: float) -> Shape:
    """x = a sin u, y = a sin u cos u."""

    def at(u: float) -> tuple[tuple[float, float], tuple[float, float], tuple[float, float]]:
        c, s, c2, s2 = math.cos(u), math.sin(u), math.cos(2.0 * u), math.sin(2.0 * u)
        return (a * s, 0.5 * a * s2), (a * c, a * c2), (-a * s, -2.0 * a * s2)

    return Shape(at)


class Reference(NamedTuple):
    """A lap at one speed, tick by tick: the curve's parameter, position, velocity and acceleration."""

    u: Array
    position: Array
    velocity: Array
    acceleration: Array
    speed: float


def lap(shape: Shape, frequency: float, period: float) -> Reference:
    """Return one lap: the parameter at equal steps of arc length, which Simpson's rule gives."""
    grid = np.linspace(0.0, 2.0 * math.pi, 8193)
    pace = np.array([math.hypot(*shape.at(u)[1]) for u in grid])
    middle = np.array([math.hypot(*shape.at(u)[1]) for u in 0.5 * (grid[1:] + grid[:-1])])
    arc = np.concatenate([[0.0], np.cumsum((pace[:-1] + 4.0 * middle + pace[1:]) / 6.0 * np.diff(grid))])
    ticks = round(1.0 / (frequency * period))
    u = np.interp(np.arange(ticks) / ticks * arc[-1], arc, grid)
    speed = float(arc[-1] * frequency)
    rows = [shape.at(value) for value in u]
    first, second = np.array([row[1] for row in rows]), np.array([row[2] for row in rows])
    square = (first**2).sum(axis=1, keepdims=True)
    bend = (second - first * (first * second).sum(axis=1, keepdims=True) / square) / square
    return Reference(u, np.array([row[0] for row in rows]), speed * first / np.sqrt(square), speed**2 * bend, speed)


def low_pass(bandwidth: float, reading: Open) -> float:
    """Return the weight of the newest sample."""
    turn = bandwidth * reading.period
    return turn / (1.0 + turn) if reading.euler else 1.0 - math.exp(-turn)


def move(axis: Axis, p: float, v: float, u: float, t: float) -> tuple[float, float]:
    """Return position and velocity after a time under a held command: sliding, turning and sticking, eqs (1) and (2)."""
    while t > 0.0:
        way = math.copysign(1.0, v) if v else math.copysign(1.0, u) if abs(u) > axis.stiction else 0.0
        if way == 0.0:
            return p, 0.0
        end = axis.a * (u - way * axis.stiction) / axis.b
        turn = math.log1p(-v / end) / axis.b if v * end < 0.0 else math.inf
        step = min(t, turn)
        fade = -math.expm1(-axis.b * step)
        p, v = p + end * step + (v - end) * fade / axis.b, 0.0 if turn <= t else v + (end - v) * fade
        t -= step
    return p, v


@dataclass
class Servo:
    """One axis under its controller: eqs (6)-(9) as the observer that gives (10)-(13), and eq (15)."""

    axis: Axis
    line: Line
    reading: Open
    position: float = 0.0
    speed: float = 0.0
    seen: float = 0.0
    slope: float = 0.0
    smooth: float = 0.0
    estimate: float = 0.0
    integral: float = 0.0
    asked: float = 0.0
    command: float = 0.0
    ideal: bool = False

    def measure(self) -> float:
        """Count the position and compute the velocity."""
        now = COUNT * round(self.position / COUNT) if not self.ideal else self.position
        self.slope += low_pass(self.reading.wv, self.reading) * ((now - self.seen) / self.reading.period - self.slope)
        self.seen = now
        return now

    def act(self, wanted: float, velocity: float, acceleration: float) -> None:
        """Give a command and hold it for a period; the integral is frozen while the drive is saturated and the error pushes further."""
        g, r = self.line, self.reading
        self.smooth += low_pass(r.wz, r) * (self.slope - self.smooth)
        residual = (r.wz * (self.slope - self.smooth) + g.bh * self.slope) / g.ah - self.command
        self.estimate += low_pass(r.wd, r) * (residual - self.estimate)
        error = wanted - self.seen
        if (self.asked - self.command) * error <= 0.0:
            self.integral += r.period * error
        loop = g.kv * (velocity - self.slope) + g.kp * (error + g.ki * self.integral) + (acceleration + g.b * velocity) / g.a
        self.asked = loop - (self.estimate if r.observer else 0.0)
        if self.ideal:
            self.command, axis = self.asked, self.axis._replace(stiction=0.0)
        else:
            self.command, axis = min(max(self.asked, -1.0), 1.0), self.axis
        self.position, self.speed = move(axis, self.position, self.speed, self.command, r.period)


class Figures(NamedTuple):
    """Of the second lap: the signed contour error and the tracking error [um], tick by tick, and its period [s]."""

    contour: Array
    tracking: Array
    period: float

    @property
    def integral(self) -> float:
        """Of the magnitude over the lap [um s]."""
        return float(np.abs(self.contour).sum() * self.period)

    @property
    def without_mean(self) -> float:
        """The same with the signed mean taken out [um s]."""
        return float(np.abs(self.contour - self.contour.mean()).sum() * self.period)


def run(first: int, table: dict[int, Line], shape: Shape, frequency: float, reading: Open, laps: int = 2) -> Figures:
    """Drive two axes around a closed curve; the first one has its x, axis 3 its y."""
    asked = lap(shape, frequency, reading.period)
    servos = [Servo(AXES[n], table[n], reading) for n in (first, 3)]
    for j, servo in enumerate(servos):
        servo.position = servo.seen = float(asked.position[0, j])
    ticks, foot, exact = len(asked.u), float(asked.u[0]), float(asked.u[0])
    error, behind = np.empty(ticks), np.empty((ticks, 2))
    ahead, position, velocity, acceleration = (array.tolist() for array in asked[:4])
    for k in range(laps * ticks):
        i = k % ticks
        true = (servos[0].position, servos[1].position)
        exact = nearest(shape, exact if i else exact - 2.0 * math.pi * (k > 0), true)
        at = (servos[0].measure(), servos[1].measure())
        foot = nearest(shape, ahead[i], at)
        on = shape.at(foot)[0]
        for j, servo in enumerate(servos):
            wanted = (1.0 - reading.weight) * position[i][j] + reading.weight * on[j]
            servo.act(wanted, velocity[i][j], acceleration[i][j])
        if k >= (laps - 1) * ticks:
            (qx, qy), (tx, ty), _ = shape.at(exact)
            error[i] = (tx * (true[1] - qy) - ty * (true[0] - qx)) / math.hypot(tx, ty)
            behind[i] = position[i][0] - true[0], position[i][1] - true[1]
    return Figures(1e3 * error, 1e3 * np.hypot(*behind.T), reading.period)


def nearest(shape: Shape, u: float, point: tuple[float, float]) -> float:
    """Return the parameter of the foot point by Newton's iteration to convergence."""
    for _ in range(20):
        (x, y), (dx, dy), (ddx, ddy) = shape.at(u)
        gx, gy = x - point[0], y - point[1]
        step = (dx * gx + dy * gy) / (dx * dx + dy * dy + ddx * gx + ddy * gy)
        u -= step
        if abs(step) < 1e-10:
            break
    return u


def sampled_poles(n: int, line: Line, reading: Open) -> NDArray[np.complex128]:
    """Return the poles of one sampled axis loop, from its response to a unit of each state; no reference, friction or encoder counts."""
    names = ("position", "speed", "seen", "slope", "smooth", "estimate", "integral", "command")
    columns = []
    for name in names:
        servo = Servo(AXES[n], line, reading, ideal=True)
        setattr(servo, name, 1.0)
        servo.measure()
        servo.act(0.0, 0.0, 0.0)
        columns.append([getattr(servo, state) for state in names])
    return np.linalg.eigvals(np.array(columns).T).astype(complex)
