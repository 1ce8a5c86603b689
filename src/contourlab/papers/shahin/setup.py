"""Setup of Shahin, ElMaraghy & ElBeheiry: drives, switching schemes, baselines, reference."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from contourlab.components.controller.cascade import Cascade
from contourlab.components.controller.zone_law import ContactZone1, ContactZone2, ContactZone3, GapZone1, GapZone2, GapZone3
from contourlab.components.coupling.laws import CrossCoupled
from contourlab.components.estimator.local import OsculatingCircle
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.components.supervisor.switching import Performance
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
"""Nominal; a lap is a whole number of periods. With Table 2 as printed, K_1'/J_m = 1.92e5 1/s needs less than 10.4 us."""

SCHEMES = ("I", "II", "III")
COUPLED = {name: f"{name} with cross-coupling" for name in SCHEMES}
INTEGRAL_RATE = 20.0
"""Of the cross-coupling [1/s]."""
PRINTED_PI = 946.3e-6
VELOCITY_LOOP = 300.0
"""Natural frequency of the baseline's velocity loop [rad/s], below the shaft's 464.7 rad/s with the motor held."""

_GAINS: dict[str, dict[str, float]] = {
    "I": {"rate_gain": 1e4, "position_gain": 2e3},
    "II": {"rate_gain": 1e3, "position_gain": 200.0},
    "III": {"rate_gain": 1e3, "position_gain": 200.0, "integral_gain": 25.0},
}
"""Table 2: K_1 = K_4, K_2 = K_5, K_3 = K_6 (contact and gap)."""
_ZONES: dict[str, tuple[Any, Any]] = {"I": (ContactZone1, GapZone1), "II": (ContactZone2, GapZone2), "III": (ContactZone3, GapZone3)}


@dataclass(frozen=True)
class Setting:
    """Choices that the paper leaves open; by default the stated reading, with the sign of beta and its rate word for word.

    Attributes
    ----------
    gap : float [m]
        Total free travel.
    start_in_gap : float
        1: the motors start on the forward flanks; 0: in mid-gap.
    direction, shift, reading : str
        Parameters of the zone laws.
    exchanged : bool
        Exchange the columns of rate and position gains in Table 2.
    follows_load : bool
        Let the gap controller of scheme I follow the load, as printed.
    shaft_damping : float [N m s/rad]
        The paper has none.
    """

    gap: float = 25e-6
    start_in_gap: float = 1.0
    direction: str = "difference"
    shift: str = "from-flank"
    reading: str = "literal"
    exchanged: bool = True
    follows_load: bool = False
    shaft_damping: float = 0.0


TO_FLANK = Setting(shift="to-flank", reading="corrected", exchanged=False)
"""Another reading: the target at the flank that the motor presses on, and Table 2 as printed."""


def servo_period(feed: float = FEED) -> float:
    """Return the servo period [s] nearest to 2 us that divides a lap."""
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
    """Return switching scheme I, II or III with the gains of Table 2; the measured motor-load difference switches."""
    common: dict[str, Any] = {"motor_inertia": MOTOR_INERTIA, "lead": LEAD, "backlash_gap": setting.gap}
    common |= {"direction": setting.direction, "shift": setting.shift} | ({} if name == "III" else {"reading": setting.reading})
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


def coupled(name: str, setting: Setting) -> Controller:
    """Return a scheme with PI control of the loads' contour error, half as stiff as the scheme's own position loops."""
    alone = scheme(name, setting)
    law: Any = alone.axes["x"].controller
    own = law.position_gain * (MOTOR_INERTIA if law.per_inertia else 1.0) * 2.0 * math.pi / LEAD
    return replace(alone, estimator=OsculatingCircle(), coupling=CrossCoupled(gain=0.5 * own, integral_rate=INTEGRAL_RATE))


def baseline(*, forward: bool = False, feedback: str = "motor") -> Controller:
    """Return the P-PI cascade with K_v = v/946.3 um, from the printed error; its velocity loop has damping 0.7 on J_m + J_l.

    Parameters
    ----------
    forward : bool
        Feed velocity and acceleration forward.
    feedback : {"motor", "load"}
    """
    turn = 2.0 * math.pi / LEAD
    gains = Cascade.tune(VELOCITY_LOOP, 0.7, 1.0 / ((MOTOR_INERTIA + LOAD_INERTIA) * turn), 0.0, FEED / PRINTED_PI)
    if not forward:
        gains |= {"velocity_feedforward": 0.0, "acceleration_feedforward": 0.0}
    cascade: Any = Cascade
    return Controller(dict.fromkeys(AXES, AxisController(controller=cascade(**gains), feedback=feedback)))


def free_flight(gap: float) -> float:
    """Return the impact speed [m/s] of a frictionless load that is released where its axis is fastest.

    To first order the reference lags uniform motion by v w^2 t^3/6. The impact is when this equals the gap; the speed difference is then
    v w^2 t^2/2.
    """
    jerk = FEED * (FEED / RADIUS) ** 2
    time = float(np.cbrt(6.0 * gap / jerk))
    return 0.5 * jerk * time * time


def circle(laps: int, period: float, feed: float = FEED) -> Reference:
    """Return laps of the 25 mm circle at a constant feedrate, eq (19)."""
    return uniform(contour("circle", radius=RADIUS), 1.0 / (round(2.0 * math.pi * RADIUS / feed / period) * period), laps, period)
