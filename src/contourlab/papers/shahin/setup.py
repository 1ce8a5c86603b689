"""The system of Shahin, ElMaraghy & ElBeheiry as it is run here: drive, schemes, baselines, references."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.zone_law import ContactZone1, ContactZone2, ContactZone3, GapZone1, GapZone2, GapZone3
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.components.supervisor.performance import Performance
from contourlab.feed import Reference, uniform
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Limits, Machine

AXES = ("x", "y")
MOTOR_INERTIA, LOAD_INERTIA, STIFFNESS, LEAD = 5.2e-3, 4.4e-3, 950.0, 0.016
"""Table 1."""
RADIUS = 0.025
FEED = 8.0 / 60.0
"""8000 mm/min."""
SERVO_PERIOD = 2e-6
"""About; a lap is made a whole number of periods. K_1'/J_m = 1.92e5 1/s wants less than 10.4 us."""

SCHEMES = ("I", "II", "III")
PRINTED_PI = 946.3e-6
VELOCITY_LOOP = 300.0
"""Natural frequency of the baseline's velocity loop [rad/s]: below the shaft's 464.7 rad/s with the motor held."""

_GAINS: dict[str, dict[str, float]] = {
    "I": {"rate_gain": 1e4, "position_gain": 2e3},
    "II": {"rate_gain": 1e3, "position_gain": 200.0},
    "III": {"rate_gain": 1e3, "position_gain": 200.0, "integral_gain": 25.0},
}
"""Table 2: K_1 and K_4, K_2 and K_5, K_3 and K_6, those of both zones being equal."""
_ZONES: dict[str, tuple[Any, Any]] = {"I": (ContactZone1, GapZone1), "II": (ContactZone2, GapZone2), "III": (ContactZone3, GapZone3)}


@dataclass(frozen=True)
class Setting:
    """What the paper leaves open.

    Attributes
    ----------
    gap : float [m]
        Free travel in all.
    start_in_gap : float
        1: the motors start on the forward flanks; 0: midway.
    direction : str
        What tells the flank, as of the zone laws.
    exchanged : bool
        Whether the two columns of Table 2's gains, rate and position, are exchanged.
    follows_load : bool
        Whether the gap controller of type I follows the load, as printed.
    shaft_damping : float [N m s/rad]
        The paper has none.
    """

    gap: float = 25e-6
    start_in_gap: float = 1.0
    direction: str = "difference"
    exchanged: bool = False
    follows_load: bool = False
    shaft_damping: float = 0.0


def servo_period(feed: float = FEED) -> float:
    """Return the servo period [s] nearest to 2 us that a lap is a whole number of."""
    lap = 2.0 * math.pi * RADIUS / feed
    return lap / round(lap / SERVO_PERIOD)


def machine(setting: Setting, period: float) -> Machine:
    """Return the two equal drives of Table 1, without friction and damping."""
    plant = TwoInertia(
        motor_inertia=MOTOR_INERTIA,
        load_inertia=LOAD_INERTIA,
        stiffness=STIFFNESS,
        shaft_damping=setting.shaft_damping,
        lead=LEAD,
        backlash_gap=setting.gap,
        start_in_gap=setting.start_in_gap,
    )
    fewest, _ = plant.fewest_substeps(period)
    return Machine("Shahin's feed drives", tuple(Axis(name, plant, limits=Limits(), substeps=fewest) for name in AXES), period)


def scheme(name: str, setting: Setting) -> Controller:
    """Return switching scheme I, II or III with the gains of Table 2, switched by the measured difference of motor and load."""
    common = {"motor_inertia": MOTOR_INERTIA, "lead": LEAD, "backlash_gap": setting.gap, "direction": setting.direction}
    gains = dict(_GAINS[name])
    if setting.exchanged:
        gains |= {"rate_gain": gains["position_gain"], "position_gain": gains["rate_gain"]}
    contact, gap = _ZONES[name]
    of_gap = {"target": "load"} if setting.follows_load and name == "I" else {}
    made = AxisController(
        controller=contact(**common, **gains),
        others=(("gap", gap(**common, **gains, **of_gap)),),
        supervisor=Performance(thresholds=(0.5 * setting.gap,), handover_time=0.0),
    )
    return Controller(dict.fromkeys(AXES, made))


def baseline(*, forward: bool = False, feedback: str = "motor") -> Controller:
    """Return the P-PI cascade whose K_v is that of the printed error, v/946.3 um, with or without feedforward of velocity and acceleration.

    The velocity loop has the damping 0.7 on J_m + J_l.
    """
    turn = 2.0 * math.pi / LEAD
    gains = Cascade.tune(VELOCITY_LOOP, 0.7, 1.0 / ((MOTOR_INERTIA + LOAD_INERTIA) * turn), 0.0, FEED / PRINTED_PI)
    if not forward:
        gains |= {"velocity_feedforward": 0.0, "acceleration_feedforward": 0.0}
    cascade: Any = Cascade
    return Controller(dict.fromkeys(AXES, AxisController(controller=cascade(**gains), feedback=feedback)))


def free_flight(gap: float, feed: float = FEED) -> float:
    """Return the speed [m/s] at which a load without friction is caught that was left free where its axis is fastest.

    The reference falls behind the straight motion by v w^2 t^3/6, to first order; that is the gap where the load is caught, and the speeds
    differ by v w^2 t^2/2 there.
    """
    jerk = feed * (feed / RADIUS) ** 2
    time = float(np.cbrt(6.0 * gap / jerk))
    return 0.5 * jerk * time * time


def circle(laps: int, period: float, feed: float = FEED) -> Reference:
    """Return laps of the circle of 25 mm at one feedrate, eq (19)."""
    return uniform(contour("circle", radius=RADIUS), 1.0 / (round(2.0 * math.pi * RADIUS / feed / period) * period), laps, period)
