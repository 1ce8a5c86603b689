"""Setup of Ghaffari & Ulsoy: axes and gains of the modular stage, as printed and as read.

The paper leaves open the bandwidths of the observer, the servo period, the velocity measurement, the discretisation of filters, and the
unit of stiction. Default reading: u as a share of full scale; Coulomb friction of 5.5, 8.8 and 7.7 % of it with true sticking; servo period
1 ms; w_d = 200 rad/s, w_z = 2000 rad/s; velocity from encoder counts by a filtered (800 rad/s) difference; low-passes discretised by pole
matching; lambda = 0.75.
"""

from __future__ import annotations

from dataclasses import dataclass

from contourlab.components.controller.position import PositionController
from contourlab.components.coupling.laws import ModifiedReference
from contourlab.components.drive.saturation import Saturation
from contourlab.components.estimator.newton import Newton
from contourlab.components.friction.laws import Coulomb
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.plant import RigidAxis
from contourlab.components.sensor.encoder import Encoder
from contourlab.components.velocity.filtered_difference import FilteredDifference
from contourlab.feed import Reference, uniform
from contourlab.geometry import contour
from contourlab.loop.machine import Axis, AxisController, Controller, Limits, Machine


@dataclass(frozen=True)
class Identified:
    """Open-loop identification and stiction of an axis (section III): a [mm/s^2], b [1/s], stiction as a share of full scale."""

    gain: float
    damping: float
    stiction: float


@dataclass(frozen=True)
class Gains:
    """One line of Tables II and III: a_hat, b_hat, K_V, K_P, K_I, a', b' with lengths in mm."""

    observer_gain: float
    observer_damping: float
    velocity_gain: float
    position_gain: float
    integral_gain: float
    model_gain: float
    model_damping: float


@dataclass(frozen=True)
class Reading:
    """Choices that the paper leaves open."""

    servo_period: float = 1e-3
    bandwidth: float = 200.0
    filter_bandwidth: float = 2000.0
    velocity_bandwidth: float = 800.0
    weight: float = 0.75
    resolution: float = 0.125e-6
    discretisation: str = "pole-matched"
    observer: bool = True
    coupling: bool = True


READING = (
    "servo period 1 ms; w_d 200, w_z 2000 and velocity filter 800 rad/s, discretised by pole matching; u and stiction as shares of full "
    "scale; the integral of the contour error's magnitude over one period of 2 s; no noise"
)
"""`Reading` in words."""

FITTED = Reading(bandwidth=328.0, filter_bandwidth=2041.0, velocity_bandwidth=606.0)
"""Filters fitted to the two printed integrals: three numbers to two."""

AXES = {1: Identified(1695.0, 10.1, 0.055), 2: Identified(648.0, 6.5, 0.088), 3: Identified(1116.0, 5.8, 0.077)}
TABLE_2 = {
    1: Gains(1695.0, 10.1, 0.057, 2.12, 11.82, 873.0, 19.7),
    2: Gains(648.0, 6.5, 0.060, 2.45, 11.82, 754.0, 24.7),
    3: Gains(1116.0, 5.8, 0.062, 2.31, 11.82, 801.0, 19.9),
}
TABLE_3 = {
    1: Gains(600.0, 20.0, 0.1, 4.0, 11.8, 900.0, 30.0),
    2: Gains(600.0, 20.0, 0.1, 4.0, 11.8, 900.0, 30.0),
    3: Gains(1000.0, 25.0, 0.1, 4.0, 11.8, 900.0, 25.0),
}
PLACED_POLES = {"natural_frequency": 25.0, "damping": 0.7, "pole": 35.0}
"""Section IV: w_n [rad/s], zeta, alpha [rad/s]."""

_MM = 1e-3


def axis(number: int, reading: Reading, sticking: bool = True) -> Axis:
    """Return an axis of the stage."""
    identified = AXES[number]
    return Axis(
        name=str(number),
        plant=RigidAxis(gain=identified.gain * _MM, damping=identified.damping),
        friction=Coulomb(coulomb=identified.stiction if sticking else 0.0),
        drive=Saturation(limit=1.0),
        sensor=Encoder(resolution=reading.resolution),
        limits=Limits(velocity=0.15),
    )


def axis_controller(gains: Gains, reading: Reading) -> AxisController:
    """Return the controller of an axis from a line of a table."""
    position = PositionController(
        velocity_gain=gains.velocity_gain / _MM,
        position_gain=gains.position_gain / _MM,
        integral_gain=gains.integral_gain,
        model_gain=gains.model_gain * _MM,
        model_damping=gains.model_damping,
    )
    observer = DisturbanceObserver(
        bandwidth=reading.bandwidth,
        filter_bandwidth=reading.filter_bandwidth,
        discretisation=reading.discretisation,
        model_gain=gains.observer_gain * _MM,
        model_damping=gains.observer_damping,
    )
    velocity = FilteredDifference(bandwidth=reading.velocity_bandwidth, discretisation=reading.discretisation)
    return AxisController(position, velocity, observer if reading.observer else None)


def machine(first: int, reading: Reading) -> Machine:
    """Return configuration A3-A1 (first = 1) or A3-A2 (first = 2); the first axis moves x of the circle, axis 3 moves y."""
    return Machine(f"A3-A{first}", (axis(first, reading), axis(3, reading)), reading.servo_period)


def controller(first: int, table: dict[int, Gains], reading: Reading) -> Controller:
    """Return the controller of a configuration."""
    axes = {str(n): axis_controller(table[n], reading) for n in (first, 3)}
    if not reading.coupling:
        return Controller(axes)
    return Controller(axes, Newton(), ModifiedReference(weight=reading.weight))


def circle(reading: Reading) -> Reference:
    """Return two laps of the 20 mm circle at 0.5 Hz, as in Fig 9."""
    return uniform(contour("circle", radius=0.02), 0.5, 2, reading.servo_period)
