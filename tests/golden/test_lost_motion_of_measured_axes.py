"""Lost motion of two real drives with motor encoders: there is no gap, but friction deflects their controllers."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from reference_data import reference_file
from scipy.io import loadmat

from contourlab.metrics.circles import backlash_from_circle
from contourlab.metrics.lost_motion import lost_motion_from_pair


def test_a_position_controller_is_a_spring_without_a_gap() -> None:
    """EMPS: force = g_tau k_v (k_p (q_r - q) - q'): q is pushed by q_r - q'/k_p with the stiffness g_tau k_v k_p and no free travel.

    Friction winds it up by 59 um there and back; only the force shows that this is not a gap.
    """
    data = loadmat(reference_file("data/emps/DATA_EMPS.mat"), simplify_cells=True)
    q, reference, voltage, kp, kv, gain = (
        np.asarray(data[name], dtype=float).squeeze() for name in ("qm", "qg", "vir", "kp", "kv", "gtau")
    )
    # The controller's own velocity: backward difference of the mean of two samples, at 1 kHz.
    velocity = np.diff(0.5 * (q[1:] + q[:-1])) / 1e-3
    pushing = reference[2:] - velocity / kp
    found = lost_motion_from_pair(pushing, q[2:], force=gain * voltage[2:])
    assert found.stiffness == pytest.approx(float(gain * kv * kp), rel=1e-3)
    assert found.gap == pytest.approx(0.0, abs=0.05e-6)
    assert found.windup == pytest.approx(59e-6, abs=3e-6)
    # The same from the published friction, 20.39 N, and 203.5 N s/m at speeds up to 0.1 m/s.
    stiffness = float(gain * kv * kp)
    assert 2.0 * 20.39 / stiffness < found.lost_motion < 2.0 * (20.39 + 203.5 * 0.12) / stiffness
    known = lost_motion_from_pair(pushing, q[2:], force=gain * voltage[2:], stiffness=stiffness)
    assert known.gap == pytest.approx(0.0, abs=0.05e-6)


def test_on_a_circle_friction_without_integral_action_looks_like_backlash() -> None:
    """The table with state feedback at 20 and 21 Hz: Coulomb friction of 0.2 to 0.3 N m on J w^2 looks like backlash of twice its angle.

    A pitch of 10 mm converts radians to metres. The circle is run once, in one direction, from rest to rest: the deviations are large.
    """
    data: Any = loadmat(reference_file("data/ubc-xy-table/line_circle_pp.mat"), simplify_cells=True)["pp"]
    signals = [1e-3 * np.asarray(signal["Data"], dtype=float) for signal in data["Y"]]
    position, reference = np.column_stack(signals[:2]), np.column_stack(signals[2:4])
    centre, radius = np.array([0.09, 0.03]), 0.03
    moving = np.append(np.linalg.norm(np.diff(reference, axis=0), axis=1) > 0.0, False)
    on = np.flatnonzero((np.abs(np.linalg.norm(reference - centre, axis=1) - radius) < 1e-6) & moving)
    circle = max(np.split(on, np.flatnonzero(np.diff(on) > 1) + 1), key=len)
    assert backlash_from_circle(reference[circle], centre, radius).backlash == pytest.approx((0.0, 0.0), abs=1e-10)
    found = backlash_from_circle(position[circle], centre, radius)
    assert found.residual < 10e-6
    for lost, deviation, inertia, hertz in zip(found.backlash, found.deviation, (4.36e-4, 3.0e-4), (20.0, 21.4), strict=True):
        low, high = (2.0 * friction / (inertia * (2.0 * math.pi * hertz) ** 2) * 10e-3 / (2.0 * math.pi) for friction in (0.2, 0.3))
        assert low - 2.0 * deviation < lost < high + 2.0 * deviation
        assert lost > 5.0 * deviation
