"""Breakaway of simulated axes with known friction, through encoder counts and noise."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from axis_bench import driven
from numpy.typing import NDArray
from refusals import refuses

from contourlab.analysis.identification.friction import breakaways
from contourlab.components.friction.laws import Coulomb, LuGre
from contourlab.components.plant.plant import MassDamper
from contourlab.components.sensor.encoder import Encoder
from contourlab.errors import ParameterError

Array = NDArray[np.float64]
PERIOD, RAMP, REST = 1e-3, 2000, 600
PLANT = MassDamper(mass=20.0, damping=100.0, force_constant=1.0)


def ramps(top: float, count: int = 2) -> Array:
    one = np.r_[np.linspace(0.0, top, RAMP), np.zeros(REST)]
    return np.r_[np.zeros(50), np.tile(np.r_[one, -one], count)]


def record(friction: Any, top: float, resolution: float, noise: float = 0.0, count: int = 2) -> tuple[Array, Array, Array]:
    u = ramps(top, count)
    place = driven(PLANT, u, PERIOD, friction=friction, sensor=Encoder(resolution=resolution, noise=noise))
    return PERIOD * np.arange(u.size), u, place


@pytest.mark.parametrize(("resolution", "noise"), [(1e-7, 0.0), (1e-6, 0.0), (1e-7, 5e-7)])
def test_the_breakaway_level_is_found_through_counts_and_noise(resolution: float, noise: float) -> None:
    found, said = breakaways(*record(Coulomb(coulomb=15.0, breakaway=20.0), 40.0, resolution, noise))
    assert len(found) == 4 and not said
    assert [one.direction for one in found] == [1, -1, 1, -1]
    for one in found:
        assert abs(one.level) == pytest.approx(20.0, rel=0.02)
        assert one.level * one.direction > 0.0 and one.fit > 90.0
        assert one.rate == pytest.approx(one.direction * 20.0, rel=0.01)


def test_without_a_stribeck_drop_the_slow_departure_is_traced_back() -> None:
    found, _ = breakaways(*record(Coulomb(coulomb=20.0), 40.0, 1e-6))
    assert [abs(one.level) for one in found] == pytest.approx([20.0] * 4, rel=0.02)


def test_bristles_bend_before_they_slip() -> None:
    friction = LuGre(coulomb=15.0, breakaway=20.0, stiffness=2e6, bristle_damping=2e3, stribeck_velocity=2e-3)
    found, _ = breakaways(*record(friction, 40.0, 1e-7))
    assert [abs(one.level) for one in found] == pytest.approx([20.0] * 4, rel=0.03)


def test_a_ramp_without_motion_is_reported() -> None:
    friction = Coulomb(coulomb=50.0)
    with pytest.raises(ParameterError, match="breakaway"):
        time, u, place = record(friction, 40.0, 1e-7)
        breakaways(time, u, place + 1e-7 * (np.arange(u.size) % 2))
    time, u, place = record(Coulomb(coulomb=20.0), 40.0, 1e-7)
    weak = np.where(u < 0.0, 0.4 * u, u)
    place = driven(PLANT, weak, PERIOD, friction=Coulomb(coulomb=20.0), sensor=Encoder(resolution=1e-7))
    found, said = breakaways(time, weak, place)
    assert [one.direction for one in found] == [1, 1]
    assert len(said) == 2 and all("breakaway" in note.text for note in said)


def test_an_invalid_ramp_is_refused() -> None:
    time, u, place = record(Coulomb(coulomb=20.0), 40.0, 1e-7)
    with refuses(ParameterError, "slow ramps", name="command"):
        breakaways(time, 40.0 * np.sign(u), place)
    with refuses(ParameterError, "slow ramps", name="command"):
        breakaways(time, np.zeros_like(u), place)
    with refuses(ParameterError, "against", name="position"):
        breakaways(time, u, -place)
    with refuses(ParameterError, "finite", name="position", value="nan at sample 2001"):
        breakaways(time, u, np.where(time > 2.0, np.nan, place))
