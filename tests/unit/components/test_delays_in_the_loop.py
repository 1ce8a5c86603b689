"""A delayed drive inside a loop: other readers of its command, and batches that vary the delay."""

from __future__ import annotations

import numpy as np
import pytest
from component_rig import PERIOD, make

import contourlab as cl


def stage(delay: float, anti_windup: str = "none") -> tuple[cl.Machine, cl.Controller]:
    """Return two ideal axes with delayed, unlimited drives."""
    plant = make("plant", "rigid-axis", gain=1.0, damping=6.0)
    axes = tuple(cl.Axis(name, plant, drive=make("drive", "delayed-saturation", delay=delay)) for name in "xy")
    gains = {"velocity_gain": 70.0, "position_gain": 2800.0, "integral_gain": 12.0}
    servo = cl.AxisController(make("controller", "position", **gains, anti_windup=anti_windup), make("velocity", "true"))
    return cl.Machine("stage", axes, PERIOD), cl.Controller(dict.fromkeys("xy", servo))


@pytest.fixture(scope="module")
def circle() -> cl.Reference:
    return cl.uniform(cl.contour("circle", radius=0.02), 1.0, 1, PERIOD)


def test_without_a_limit_anti_windup_does_nothing(circle: cl.Reference) -> None:
    runs = [cl.simulate(*stage(1.5e-3, kind), circle)["axis_position"] for kind in ("hold", "none")]
    assert np.abs(runs[0] - runs[1]).max() < 1e-12  # they are compiled separately, so rounding may differ


@pytest.mark.parametrize("shorter", [0.5e-3, 1e-3])
def test_a_batch_may_shorten_a_delay(shorter: float, circle: cl.Reference) -> None:
    compare_with_single(3e-3, shorter, circle)


@pytest.mark.parametrize("longer", [2e-3, 3.3e-3])
def test_a_batch_may_lengthen_a_delay(longer: float, circle: cl.Reference) -> None:
    compare_with_single(0.5e-3, longer, circle)


def compare_with_single(base: float, delay: float, circle: cl.Reference) -> None:
    single = cl.simulate(*stage(delay), circle)["axis_position"]
    varied = {f"axes.{name}.drive.delay": [delay] for name in "xy"}
    batch = cl.simulate_batch(*stage(base), circle, varied, keep=("axis_position",))
    assert np.abs(batch.signals["axis_position"][:, :, 0] - single).max() < 1e-9
