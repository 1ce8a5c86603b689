"""Fixtures for the servo loop tests."""

from __future__ import annotations

import pytest
from stages import PERIOD, control, stage

import contourlab as cl


@pytest.fixture(scope="module")
def circle() -> cl.Reference:
    """Return two quick laps of a small circle."""
    return cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 2, PERIOD)


@pytest.fixture
def machine() -> cl.Machine:
    return stage()


@pytest.fixture
def controller() -> cl.Controller:
    return control()
