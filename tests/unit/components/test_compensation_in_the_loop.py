"""Compensation on running drives: the rest of a gap at the load, and of friction at the quadrants."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from component_rig import PERIOD, make
from scipy.signal import lti

import contourlab as cl
from contourlab.components.controller.cascade import Cascade
from contourlab.metrics.circles import backlash_from_circle
from contourlab.metrics.lost_motion import lost_motion_from_pair
from contourlab.metrics.reversals import reversal_spikes

GAP, LEAD, STIFFNESS, RUB = 20e-6, 0.016, 950.0, 250.0
TURN = 2.0 * math.pi / LEAD
LOST = GAP + 2.0 * RUB / (STIFFNESS * TURN**2)
"""Gap of the drive plus its windup by friction, 3.4 um."""

COMPENSATIONS = [
    pytest.param("backlash-inverse", {"backlash_gap": LOST, "jump_velocity": 5e-3}, 0.15e-6, id="inverse"),
    pytest.param("backlash-offset", {"backlash_gap": LOST, "backlash_velocity": 5e-3}, 0.15e-6, id="offset"),
    # It learns last while the axis brakes: the windup is smaller by at most 0.7 um on either side.
    pytest.param("adaptive-backlash-inverse", {"largest_gap": 1e-4, "adaptation_time": 0.2, "jump_velocity": 5e-3}, 1.4e-6, id="adaptive"),
]


def circle_of(kind: str, values: dict[str, float]) -> tuple[Any, Any]:
    """Run a drive around a circle under motor feedback, with a free load and encoders of 0.1 um."""
    plant = make(
        "plant",
        "two-inertia",
        motor_inertia=5.2e-3,
        load_inertia=4.4e-3,
        lead=LEAD,
        stiffness=STIFFNESS,
        shaft_damping=0.2,
        motor_damping=1e-2,
        backlash_gap=GAP,
    )
    friction = make("friction", "smooth-coulomb", coulomb=RUB, breakaway=RUB, smoothing_velocity=2e-4)
    encoder = make("sensor", "encoder", resolution=1e-7)
    axes = tuple(cl.Axis(name, plant, friction, sensor=encoder, motor_sensor=encoder, substeps=20) for name in "xy")
    tuned = Cascade(**Cascade.tune(150.0, 0.7, 1.0 / (9.6e-3 * TURN), 1e-2 / 9.6e-3, 40.0))
    servo = cl.AxisController(
        tuned, feedback="motor", velocity_feedback="motor", compensation=make("compensation", kind, **values) if kind else None
    )
    reference = cl.uniform(cl.contour("circle", radius=0.025), 0.4, 6, PERIOD)
    return cl.simulate(cl.Machine("geared", axes, PERIOD), cl.Controller(dict.fromkeys("xy", servo)), reference), reference


def last_lap(result: Any, reference: Any) -> Any:
    start, stop = reference.laps[-1]
    centre = reference.block(start, stop).position.mean(axis=0)
    return backlash_from_circle(result["axis_position"][start:stop], centre, 0.025, after=math.radians(20.0))


def test_three_ways_to_measure_the_gap_of_a_drive() -> None:
    """From the load's circle; from motor and load; and, with the stiffness, the gap without windup."""
    result, reference = circle_of("", {})
    found = last_lap(result, reference)
    assert found.backlash == pytest.approx((LOST, LOST), abs=0.15e-6)
    assert max(found.deviation) < 0.1e-6
    motor, load = result["motor_position"][:, 0], result["axis_position"][:, 0]
    assert lost_motion_from_pair(motor, load).lost_motion == pytest.approx(LOST, abs=0.05e-6)
    alone = lost_motion_from_pair(motor, load, force=result["shaft_force"][:, 0], stiffness=STIFFNESS * TURN**2)
    assert alone.gap == pytest.approx(GAP, abs=0.05e-6)


@pytest.mark.parametrize(("kind", "values", "left"), COMPENSATIONS)
def test_compensation_removes_the_effect_of_the_gap(kind: str, values: dict[str, float], left: float) -> None:
    assert last_lap(*circle_of(kind, values)).backlash == pytest.approx((0.0, 0.0), abs=left)


def heights(pulses: Any) -> list[float]:
    plant = make("plant", "mass-damper", mass=200.0, force_constant=1.0)
    friction = make("friction", "smooth-coulomb", coulomb=100.0, breakaway=100.0, smoothing_velocity=1e-4)
    axes = tuple(cl.Axis(name, plant, friction, substeps=4) for name in "xy")
    servo = cl.AxisController(Cascade(**Cascade.tune(200.0, 0.7, 1.0 / 200.0, 0.0, 60.0)), compensation=pulses)
    reference = cl.uniform(cl.contour("circle", radius=0.05), 0.4, 3, PERIOD)
    result = cl.judge(cl.simulate(cl.Machine("rubbing", axes, PERIOD), cl.Controller(dict.fromkeys("xy", servo)), reference), reference)
    return [abs(spike.height) for spike in reversal_spikes(result, (result.n_sample // 2, result.n_sample))]


def predicted(lasting: float) -> float:
    """Return the peak error of the axis after friction of 2 F_c reverses, less a pulse of 2 F_c exp(-t/T).

    The loop: e (m s^3 + K s^2 + (K/T_i + K K_v) s + K K_v/T_i) = s F.
    """
    gains = Cascade.tune(200.0, 0.7, 1.0 / 200.0, 0.0, 60.0)
    k, ti, kv = gains["velocity_gain"], gains["integral_time"], gains["position_gain"]
    t = np.linspace(0.0, 1.0, 20_001)
    loop = [200.0, k, k / ti + k * kv, k * kv / ti]
    # 2 F_c (1/s - 1/(s + 1/T)) times s is 2 F_c/(T s + 1).
    return float(np.abs(lti([200.0], np.polymul(loop, [lasting, 1.0])).impulse(T=t)[1]).max())


def test_pulses_reduce_the_effect_of_friction_at_the_quadrants() -> None:
    """As the linear loop predicts, up to the half millisecond in which friction changes sign and the servo period."""
    bare = heights(None)
    assert len(bare) >= 4
    assert bare == pytest.approx([predicted(1e-9)] * len(bare), rel=0.06)
    for lasting in (0.03, 0.12):
        pulsed = heights(make("compensation", "quadrant-pulses", first_amplitude=200.0, first_width=lasting, shape="decay"))
        assert pulsed == pytest.approx([predicted(lasting)] * len(bare), rel=0.06)
    assert max(pulsed) < 0.2 * min(bare)
