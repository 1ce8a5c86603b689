"""The benchmark's work in other people's tools, written as their users would; see README.md.

Both get the whole servo tick as one function, which is the fastest way to use them: wiring the loop from blocks costs several times more.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

__all__ = ["Work", "python_control", "scipy_ivp"]

PER_AXIS = 6
"""States of an axis: position, velocity, filtered velocity, disturbance estimate, integral, applied command."""


class AxisNumbers(NamedTuple):
    """Numbers of one axis, in mm and parts of full scale, in the order of reference.c."""

    gain: float
    damping: float
    coulomb: float
    breakaway: float
    stribeck: float
    smoothing: float
    limit: float
    bandwidth: float
    filter: float
    model_gain: float
    model_damping: float
    kv: float
    kp: float
    ki: float
    forward_gain: float
    forward_damping: float


def acceleration(a: AxisNumbers, velocity: float, command: float) -> float:
    """Return the acceleration of an axis against Stribeck friction [mm/s^2]."""
    ratio = velocity / a.stribeck
    level = a.coulomb + (a.breakaway - a.coulomb) * math.exp(max(-ratio * ratio, -700.0))
    return a.gain * (command - level * math.tanh(velocity / a.smoothing)) - a.damping * velocity


def moved(a: AxisNumbers, p: float, v: float, u: float, dt: float) -> tuple[float, float]:
    """Return position and velocity one classical Runge-Kutta step later, the command held."""
    k1 = acceleration(a, v, u)
    v2 = v + 0.5 * dt * k1
    k2 = acceleration(a, v2, u)
    v3 = v + 0.5 * dt * k2
    k3 = acceleration(a, v3, u)
    v4 = v + dt * k3
    k4 = acceleration(a, v4, u)
    return p + dt / 6.0 * (v + 2.0 * (v2 + v3) + v4), v + dt / 6.0 * (k1 + 2.0 * (k2 + k3) + k4)


def controlled(a: AxisNumbers, x: Sequence[float], target: float, rv: float, ra: float, dt: float) -> tuple[float, float, float, float]:
    """Return filtered velocity, disturbance estimate, integral and command after a servo tick."""
    p, v, filtered, estimate, integral, applied = x
    wz = a.filter * dt / (1.0 + a.filter * dt)
    wd = a.bandwidth * dt / (1.0 + a.bandwidth * dt)
    filtered += wz * (v - filtered)
    slope = a.filter * (v - filtered)
    estimate += wd * ((slope + a.model_damping * v) / a.model_gain - applied - estimate)
    error = target - p
    integral += dt * error
    feedforward = (ra + a.forward_damping * rv) / a.forward_gain
    u = a.kv * (rv - v) + a.kp * error + a.kp * a.ki * integral + feedforward - estimate
    return filtered, estimate, integral, min(max(u, -a.limit), a.limit)


class Work:
    """The servo tick: contour error by one Newton iteration, modified reference, observer, position loop."""

    def __init__(self, axes: Sequence[Sequence[float]], radius: float, frequency: float, weight: float, period: float) -> None:
        self.axes = [AxisNumbers(*numbers) for numbers in axes]
        self.radius, self.rate, self.weight, self.period = radius, 2.0 * math.pi * frequency, weight, period

    def start(self) -> list[float]:
        """Return the state at rest: two axes, then the foot point's angle."""
        return [self.radius, *(0.0,) * (2 * PER_AXIS - 1), 0.0]

    def contour(self, x: Sequence[float]) -> tuple[float, float, float, float]:
        """Return the foot point's angle, the foot point and the signed contour error."""
        radius, foot, px, py = self.radius, x[-1], x[0], x[PER_AXIS]
        s, c = math.sin(foot), math.cos(foot)
        ex, ey = radius * c - px, radius * s - py
        foot -= radius * (c * ey - s * ex) / (radius * radius - radius * (c * ex + s * ey))
        s, c = math.sin(foot), math.cos(foot)
        qx, qy = radius * c, radius * s
        error = (-qy * (py - qy) - qx * (px - qx)) / math.hypot(qx, qy)
        return foot, qx, qy, error

    def tick(self, t: float, x: Sequence[float]) -> list[float]:
        """Return the state after the controllers have run at time t; positions and velocities stay."""
        radius, rate, weight = self.radius, self.rate, self.weight
        s, c = math.sin(rate * t), math.cos(rate * t)
        foot, qx, qy, _ = self.contour(x)
        r, q = (radius * c, radius * s), (qx, qy)
        rv, ra = (-rate * r[1], rate * r[0]), (-rate * rate * r[0], -rate * rate * r[1])
        found: list[float] = []
        for j, a in enumerate(self.axes):
            own = x[j * PER_AXIS : (j + 1) * PER_AXIS]
            target = (1.0 - weight) * r[j] + weight * q[j]
            found += [own[0], own[1], *controlled(a, own, target, rv[j], ra[j], self.period)]
        return [*found, foot]

    def next(self, t: float, x: Sequence[float]) -> list[float]:
        """Return the state at the next tick."""
        found = self.tick(t, x)
        for j, a in enumerate(self.axes):
            i = j * PER_AXIS
            found[i], found[i + 1] = moved(a, found[i], found[i + 1], found[i + 5], self.period)
        return found


def rms_of_second_lap(errors: Sequence[float]) -> float:
    """Return the root mean square of the later half of a record [mm]."""
    return float(np.sqrt(np.mean(np.square(errors[len(errors) // 2 :]))))


def timed(work: Callable[[], Sequence[float]]) -> tuple[float, float]:
    """Return processor time [s] and the rms contour error over the second lap [mm]."""
    start = time.process_time()
    errors = work()
    return time.process_time() - start, rms_of_second_lap(errors)


def python_control(work: Work, n: int) -> tuple[float, float]:
    """Run n ticks as one discrete nonlinear system of python-control; return seconds and rms [mm]."""
    import control

    states = len(work.start())
    system = control.nlsys(
        lambda t, x, u, p: work.next(t, x.tolist()),
        lambda t, x, u, p: [x[0], x[PER_AXIS], *work.tick(t, x.tolist())[5 : 2 * PER_AXIS : PER_AXIS], work.contour(x.tolist())[3]],
        inputs=0,
        outputs=5,
        states=states,
        dt=work.period,
    )
    times = np.arange(n) * work.period
    return timed(lambda: control.input_output_response(system, times, 0.0, work.start()).outputs[4])


def scipy_ivp(work: Work, n: int) -> tuple[float, float]:
    """Run n ticks with one `scipy.integrate.solve_ivp` each, the command held; return seconds and rms [mm]."""
    from scipy.integrate import solve_ivp

    a, b = work.axes

    def derivative(t: float, z: np.ndarray, u: float, v: float) -> list[float]:
        return [z[1], acceleration(a, z[1], u), z[3], acceleration(b, z[3], v)]

    def run() -> list[float]:
        x, errors = work.start(), []
        for k in range(n):
            t = k * work.period
            errors.append(work.contour(x)[3])
            x = work.tick(t, x)
            plants = [x[0], x[1], x[PER_AXIS], x[PER_AXIS + 1]]
            held = (x[5], x[PER_AXIS + 5])
            z = solve_ivp(derivative, (t, t + work.period), plants, args=held, rtol=1e-8, atol=1e-11).y[:, -1].tolist()
            x[0], x[1], x[PER_AXIS], x[PER_AXIS + 1] = z
        return errors

    return timed(run)
