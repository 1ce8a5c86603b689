"""A jerk above its limit is never shown without its reason: table and picture of a motion from a line into an arc."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import synthetic

from contourlab.feed import AxisLimits, limit_report, plan, route_from_path
from contourlab.geometry import Arc, Line, Path
from contourlab.loop.machine import Limits
from contourlab.rendering.charts import Panel
from contourlab.rendering.data import ReportData
from contourlab.rendering.html import render_html
from contourlab.rendering.page_tables import limit_tables
from contourlab.rendering.run_pictures import axis_charts

FEED, RADIUS, PERIOD, JERK = 0.05, 0.01, 1e-3, 40.0  # a step of v^2/R = 0.25 m/s^2, 250 m/s^3 over a servo period
LIMITS = AxisLimits([0.25, 0.25], [3.0, 3.0], [JERK, JERK])


def report(single: ReportData, jerk: float = JERK) -> ReportData:
    arc = Arc(np.array([0.05, RADIUS]), RADIUS, -0.5 * np.pi, np.pi)
    path = Path([Line((0.0, 0.0), (0.05, 0.0)), arc, Line((0.05, 0.02), (0.0, 0.02))])
    limits = replace(LIMITS, jerk=np.full(2, jerk))
    reference = plan(route_from_path(path, FEED), limits, PERIOD)
    data = synthetic.around(single, path, reference)
    machine = synthetic.machine(("x", "y"), Limits(velocity=0.25, acceleration=3.0, jerk=jerk))
    (scheme,) = data.schemes
    return replace(data, schemes=(replace(scheme, machine=machine, limits=limit_report(reference, limits)),))


def jerk_panel(data: ReportData, axis: int) -> Panel:
    return next(panel for panel in axis_charts(data, 100_000)[axis].panels if panel.y_label.startswith("jerk"))


@pytest.mark.slow
def test_every_peak_above_the_limit_is_marked_with_its_step(single: ReportData) -> None:
    data = report(single)
    panel = jerk_panel(data, 1)
    (curve,) = panel.curves
    above = curve.x[np.abs(curve.y) > JERK * (1.0 + 1e-6)]
    assert above.size == 2
    assert [tick.x for tick in panel.ticks] == pytest.approx(above.tolist(), abs=1e-9)
    assert {tick.mark for tick in panel.ticks} == {"curvature step"}
    # Six times the limit is cut off, and the label of the limit gives the peak.
    assert panel.y_range is not None and panel.y_range[1] < np.abs(curve.y).max()
    assert "250 m/s^3" in panel.levels[0].label
    assert jerk_panel(data, 0).ticks == ()


def test_the_table_says_what_its_jerk_leaves_out(single: ReportData) -> None:
    data = report(single)
    (table,) = limit_tables(data)
    rows = dict(table.rows)
    assert "jerk" not in rows
    jerk, step = rows["jerk between curvature steps"], rows["curvature step"]
    assert jerk[1:4] == ("40 m/s^3", "40 m/s^3", "100.0 %")
    assert step[:4] == ("y", "0.25 m/s^2", "3 m/s^2", "8.3 %")
    assert all(text in table.note for text in (": 2.", "0.25 m/s^2", "250 m/s^3", "1 ms"))
    assert table.note in render_html(data)


def test_without_such_steps_the_jerk_is_that_of_all_samples(single: ReportData) -> None:
    data = report(single, 300.0)
    (table,) = limit_tables(data)
    assert "jerk" in dict(table.rows) and table.note == ""
    for axis in (0, 1):
        panel = jerk_panel(data, axis)
        assert panel.ticks == () and max(np.abs(curve.y).max() for curve in panel.curves) <= 300.0 * (1.0 + 1e-6)
