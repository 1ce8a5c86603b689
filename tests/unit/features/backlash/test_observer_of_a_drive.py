"""The observer that the backlash study sets up for a drive, and the gap that it is compared with."""

from __future__ import annotations

import numpy as np
import pytest

import contourlab as cl
from contourlab.components.registry import component
from contourlab.features.backlash.command import _gap_where_it_turns, observer_of

DRIVE = {"motor_inertia": 2e-4, "mass": 33.0, "lead": 0.01, "stiffness": 253.0}


def axis(disturbance: dict[str, float] | None = None, viscous: float = 0.0, **values: object) -> cl.Axis:
    plant = component("plant", "two-inertia")(**{**DRIVE, "backlash_gap": 40e-6, **values})
    friction = component("friction", "coulomb")(coulomb=60.0, viscous=viscous)
    force = None if disturbance is None else component("disturbance", "constant")(**disturbance)
    return cl.Axis("x", plant, friction, disturbance=force)


def test_a_known_force_counts_in_full_as_unmodelled() -> None:
    assert observer_of(axis(), 1e-3).unmodelled_force == 1.0
    assert observer_of(axis({"force": -100.0}), 1e-3).unmodelled_force == 100.0


def test_viscous_friction_of_the_guides_belongs_to_the_load() -> None:
    assert observer_of(axis(viscous=200.0), 1e-3).load_damping == pytest.approx(200.0 * (0.01 / (2.0 * np.pi)) ** 2)


def test_guesses_extend_beyond_the_widest_gap_and_are_dense() -> None:
    for gap in (10e-6, 100e-6, 900e-6):
        seen = observer_of(axis(backlash_gap=gap), 1e-3)
        assert seen.largest_gap > 1.4 * gap
        assert (seen.largest_gap / seen.smallest_gap) ** (1.0 / (seen.hypotheses - 1.0)) < 1.15
    varying = axis(gap_profile=(2.0, 1.0, 2.0), profile_start=-0.02, profile_step=0.02)
    assert varying.plant.widest_gap == pytest.approx(80e-6)  # type: ignore[attr-defined]


def test_a_varying_gap_is_taken_where_the_axis_turns() -> None:
    plant = axis(gap_profile=(2.0, 0.0, 2.0), profile_start=-0.02, profile_step=0.02).plant
    time = np.linspace(0.0, 4.0 * np.pi, 4001)
    assert _gap_where_it_turns(plant, -np.sin(time), 0.01 * np.cos(time)) == pytest.approx(40e-6, rel=1e-4)  # type: ignore[arg-type]
    assert _gap_where_it_turns(plant, np.ones(5), np.linspace(0.0, 0.001, 5)) == pytest.approx(80e-6)  # type: ignore[arg-type]
