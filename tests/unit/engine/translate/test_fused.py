"""The fused loop of a whole composition beside the loop that calls one step after another."""

from __future__ import annotations

import sys

import numpy as np
import pytest
from tests.helpers.fused_group import FusedGroup

import contourlab as cl


def test_a_run_is_the_same_to_rounding(monkeypatch: pytest.MonkeyPatch) -> None:
    case = cl.load_scenario("builtin:ghaffari/demo-stage").cases()[-1]
    reference = case.reference()
    before = cl.simulate(case.machine, case.controller, reference)
    monkeypatch.setattr(sys.modules["contourlab.loop.simulate"], "make_group", lambda s, width, lanes, jit: FusedGroup(s, width, lanes))
    fused = cl.simulate(case.machine, case.controller, reference)
    for name in ("tool_position", "command", "contour_error_estimate"):
        scale = float(np.abs(before[name]).max())
        np.testing.assert_allclose(fused[name], before[name], rtol=0.0, atol=1e-9 * scale)


def test_a_batch_is_the_same_to_rounding(monkeypatch: pytest.MonkeyPatch) -> None:
    case = cl.load_scenario("builtin:ghaffari/demo-stage").cases()[-1]
    reference = case.reference()
    gains = {"controller.axes.1.controller.position_gain": np.linspace(2000.0, 2400.0, 40)}
    before = cl.simulate_batch(case.machine, case.controller, reference, gains).figures["contour_error_rms"]
    monkeypatch.setattr(sys.modules["contourlab.loop.batch"], "make_group", lambda s, width, lanes, jit: FusedGroup(s, width, lanes))
    fused = cl.simulate_batch(case.machine, case.controller, reference, gains).figures["contour_error_rms"]
    np.testing.assert_allclose(fused, before, rtol=1e-6)  # a rounding may shift an encoder count
