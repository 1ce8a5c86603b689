"""Stages that learn: linear ones to reason about, and one with all the parts of a real machine."""

from __future__ import annotations

from typing import Any

import numpy as np
from component_rig import make
from numpy.typing import NDArray

import contourlab as cl
from contourlab.feed import Reference
from contourlab.geometry import Line, Path

Array = NDArray[np.float64]
PERIOD = 1e-3
TIME_CONSTANT = 0.1
PLANT = {"dc_gain": 0.05, "damping_ratio": 1.1, "natural_frequency": 150.0}
NAMES = ("x", "y", "z", "a", "b")


def stage(n_axis: int = 2, period: float = PERIOD, **parts: Any) -> cl.Machine:
    """Return a machine of equal linear motor stages (eq 4 of Gecer Ulu et al.)."""
    return cl.Machine(
        "stage", tuple(cl.Axis(name, make("plant", "second-order-integrator", **PLANT), **parts) for name in NAMES[:n_axis]), period
    )


def control(n_axis: int = 2, time_constant: float = TIME_CONSTANT, coupled: float = 0.0) -> cl.Controller:
    """Return the pole-cancelling PID of each axis; `coupled` is the gain of cross-coupling over that of the axes."""
    axes = {name: cl.AxisController(make("controller", "speed-pid", **PLANT, time_constant=time_constant)) for name in NAMES[:n_axis]}
    if not coupled:
        return cl.Controller(axes)
    gain = coupled / (PLANT["dc_gain"] * time_constant)
    return cl.Controller(axes, make("estimator", "tangent"), make("coupling", "cross-coupled", gain=gain))


def proportional(n_axis: int = 2, time_constant: float = TIME_CONSTANT) -> cl.Controller:
    """Return position gains that give the loop 1/(T_a s) at low frequency."""
    gain = 1.0 / (PLANT["dc_gain"] * time_constant)
    return cl.Controller(
        {name: cl.AxisController(make("controller", "position", position_gain=gain, anti_windup="none")) for name in NAMES[:n_axis]}
    )


def there_and_rest(period: float = PERIOD, move: float = 2.0, rest: float = 3.0, distance: float = 0.02) -> Reference:
    """Return a smooth move along a line, with rest before and after it, of one axis."""
    t = np.arange(0.0, rest + move + rest, period)
    u = np.clip((t - rest) / move, 0.0, 1.0)
    s = u**4 * (35.0 - 84.0 * u + 70.0 * u**2 - 20.0 * u**3)
    return Reference.from_samples(distance * s[:, None], period, Path([Line((0.0,), (distance,))]))


def rough(period: float = PERIOD, n_axis: int = 1, seconds: float = 4.0, rest: float = 2.0, top: float = 30.0) -> Reference:
    """Return a move back and forth that holds all frequencies up to `top` [Hz], with rest before and after it."""
    n, pad = round(seconds / period), round(rest / period)
    rng = np.random.default_rng(12)
    f = np.fft.rfftfreq(n, period)
    rows = []
    for _ in range(n_axis):
        phase = np.exp(2j * np.pi * rng.uniform(size=f.size))
        wave = np.fft.irfft(np.where((f > 0.0) & (f < top), phase / np.maximum(f, 1.0), 0.0), n)
        wave *= np.sin(np.pi * np.arange(n) / n) ** 4
        rows.append(np.concatenate([np.zeros(pad), wave / np.abs(wave).max(), np.zeros(pad)]))
    position = 5e-3 + 4e-3 * np.column_stack(rows)
    return Reference.from_samples(position, period, Path([Line((0.0,) * n_axis, (1e-2,) * n_axis)]), arc_length=position[:, 0])


def eased(seconds: float = 6.0) -> Reference:
    """Return an ellipse, run through once from rest to rest."""
    path = cl.contour("ellipse")
    t = np.arange(0.0, seconds + 2.0, PERIOD)
    u = np.clip((t - 1.0) / seconds, 0.0, 1.0)
    s = path.length * u**4 * (35.0 - 84.0 * u + 70.0 * u**2 - 20.0 * u**3)
    return Reference.from_samples(path.position(s), PERIOD, path, arc_length=s)


def full_stage() -> tuple[cl.Machine, cl.Controller]:
    """Return a stage with noise, friction, delay, observers, filtered velocity and coupling."""

    def axis(name: str, gain: float, coulomb: float) -> cl.Axis:
        return cl.Axis(
            name,
            make("plant", "rigid-axis", gain=gain, damping=6.0),
            friction=make("friction", "coulomb", coulomb=coulomb),
            drive=make("drive", "delayed-saturation", limit=0.6, delay=1.5e-3),
            sensor=make("sensor", "encoder", resolution=125e-9, noise=5e-8),
        )

    def loop(gain: float) -> cl.AxisController:
        return cl.AxisController(
            make(
                "controller", "position", velocity_gain=70.0, position_gain=2800.0, integral_gain=12.0, model_gain=gain, model_damping=25.0
            ),
            make("velocity", "filtered-difference", bandwidth=800.0),
            make("observer", "disturbance-observer", bandwidth=100.0, filter_bandwidth=2000.0, model_gain=gain, model_damping=25.0),
        )

    machine = cl.Machine("full", (axis("x", 1.1, 0.055), axis("y", 0.65, 0.088)), PERIOD)
    coupling = make("estimator", "newton", iterations=2), make("coupling", "modified-reference", weight=0.5)
    return machine, cl.Controller({"x": loop(1.0), "y": loop(0.6)}, *coupling)
