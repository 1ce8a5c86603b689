"""Pictures of the learning analysis show its figures, and both views contain them."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from contourlab.analysis.learning.learning_analysis import learning_analysis
from contourlab.analysis.linear.contour_transfer import contour_transfer
from contourlab.components.controller.position import PositionController
from contourlab.components.coupling.laws import CrossCoupled
from contourlab.components.estimator.local import Tangent
from contourlab.components.learning.law import ZeroPhase
from contourlab.components.plant.plant import RigidAxis
from contourlab.features.analyse.command import contour_transfer_charts
from contourlab.loop.machine import Axis, AxisController, Controller, Machine
from contourlab.rendering.learning_pictures import learning_charts, singular_value_chart
from contourlab.rendering.matplotlib_view import drawing


@pytest.fixture(scope="module")
def coupled() -> Any:
    axes = tuple(Axis(name, RigidAxis(gain=0.9, damping=damping)) for name, damping in (("x", 10.0), ("y", 20.0)))
    made = AxisController(PositionController(position_gain=300.0, velocity_gain=20.0))
    controller = Controller({"x": made, "y": made}, Tangent(), CrossCoupled(gain=300.0))
    return SimpleNamespace(machine=Machine("pair", axes, 1e-3), controller=controller)


def test_the_coupling_is_drawn_with_its_margin(coupled: Any) -> None:
    transfer = contour_transfer(coupled.machine, coupled.controller)
    nyquist, modulus, error = contour_transfer_charts(transfer)
    margin = transfer.margins().modulus
    assert modulus.panels[0].levels[0].value == margin
    lowest = min(float(np.nanmin(np.hypot(curve.x + 1.0, curve.y))) for curve in nyquist.panels[0].curves if curve.name != "−1")
    assert lowest == pytest.approx(margin, rel=1e-2)
    first = error.panels[0].curves[0]
    drawn = 20.0 * np.log10(np.abs(1.0 / (1.0 + transfer.loop_gain(first.x * 2.0 * np.pi, (1.0, 0.0)))))
    np.testing.assert_allclose(first.y, drawn, atol=1e-9)
    for chart in (nyquist, modulus, error):
        drawing(chart).canvas.draw()  # type: ignore[attr-defined]


@pytest.mark.slow
def test_learning_is_drawn_with_the_line_at_one_and_the_first_zero(coupled: Any) -> None:
    found = {f"M = {m}": learning_analysis(coupled.machine, coupled.controller, ZeroPhase(half_width=m)) for m in (11, 40)}
    (chart,) = learning_charts(found)
    assert chart.panels[0].levels[0].value == 1.0
    assert [tick.x for tick in chart.panels[1].ticks] == pytest.approx([1000.0 / 23.0, 1000.0 / 81.0])
    grown = max(float(curve.y.max()) for curve in chart.panels[1].curves)
    assert grown == pytest.approx(100.0 * (max(a.worst_factor for a in found.values()) - 1.0), rel=0.02, abs=1e-3)
    drawing(chart).canvas.draw()  # type: ignore[attr-defined]


def test_singular_values_fall() -> None:
    chart = singular_value_chart({"ilc": np.array([0.2, 1.1, 0.5])})
    np.testing.assert_array_equal(chart.panels[0].curves[0].y, [1.1, 0.5, 0.2])
