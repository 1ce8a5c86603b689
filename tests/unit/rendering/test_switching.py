"""Switches, reversals and backlash in print and in pictures."""

from __future__ import annotations

import math
import re
from dataclasses import replace

import numpy as np
import pytest

from contourlab.analysis.linear.margins import Margins
from contourlab.loop.switches import Switches, SwitchKind
from contourlab.metrics.reversals import Spike
from contourlab.rendering.comparison import compare
from contourlab.rendering.data import ReportData
from contourlab.rendering.html import render_html
from contourlab.rendering.page_tables import reversal_table, reversal_text
from contourlab.rendering.plots import write_plots
from contourlab.rendering.run_pictures import bode_charts, hysteresis_charts, polar_charts
from contourlab.rendering.switching import LISTED, strip_charts, switch_lines, switch_tables
from contourlab.result import Signal

FELL, ROSE = "the measure fell below a threshold", "the measure rose past a threshold"
INTO, BACK = SwitchKind("x", "controller", "gap", FELL), SwitchKind("x", "gap", "controller", ROSE)
PERIOD = 1e-3


def switched(samples: list[int], n: int, axes: tuple[str, ...] = ("x", "y")) -> Switches:
    """Return switches of x back and forth; y keeps its first controller."""
    kind = np.arange(len(samples)) % 2
    ends = np.array([0, *samples, n])
    held = np.diff(ends)
    active = {"x": {"controller": int(held[::2].sum()), "gap": int(held[1::2].sum())}, "y": {"controller": n}}
    along = np.array(samples) * 1e-5
    first = dict.fromkeys(axes, "controller")
    return Switches(axes, PERIOD, (INTO, BACK), kind, np.array(samples, dtype=np.int64), along, np.full(len(samples), 7), active, first)


def with_switches(data: ReportData, samples: list[int]) -> ReportData:
    n = data.schemes[1].result.n_sample
    return replace(data, schemes=(data.schemes[0], replace(data.schemes[1], switches=switched(samples, n))))


@pytest.fixture(scope="module")
def backlash(circle: ReportData) -> ReportData:
    """Return the circle with a motor that leads its load of x by 10 um one way and trails it by 12 um the other."""
    schemes = []
    for scheme in circle.schemes:
        result = scheme.result
        load = result["tool_position"]
        motor = load + np.where(result["reference_velocity"] > 0.0, 10e-6, -12e-6)
        more = {name: Signal(data, ("sample", "axis"), "m") for name, data in (("axis_position", load), ("motor_position", motor))}
        gaps = {"x": (np.array([-0.01, 0.01]), np.array([16e-6, 20e-6]))}
        schemes.append(replace(scheme, result=result.with_signals(**more), gaps=gaps))
    return replace(circle, schemes=tuple(schemes))


def test_a_line_of_text_gives_count_and_reasons(circle: ReportData) -> None:
    lines = switch_lines(with_switches(circle, [100, 200, 300]))
    name = circle.schemes[1].name
    x, y = lines
    assert x.startswith(f"{name}: x: 3 ") and x.endswith(f": controller -> gap 2 ({FELL}); gap -> controller 1 ({ROSE})")
    assert y.startswith(f"{name}: y: ") and "controller" in y and "->" not in y
    assert switch_lines(circle) == [] and switch_tables(circle) == () and strip_charts(circle) == ()


def test_many_kinds_are_shortened_but_counted(circle: ReportData) -> None:
    kinds = tuple(SwitchKind("x", "controller", f"c{i}", "by the way") for i in range(9))
    kind = np.repeat(np.arange(9), [9, 8, 7, 6, 5, 4, 3, 2, 1])
    some = np.arange(len(kind))
    found = Switches(("x",), PERIOD, kinds, kind, some, some * 1e-5, some * 0, {"x": {"controller": 45}}, {"x": "controller"})
    data = replace(circle, schemes=(replace(circle.schemes[0], switches=found),))
    (line,) = switch_lines(data)
    assert "x: 45 switches" in line and line.endswith("; others 6") and "c5 4 (" in line and "c6" not in line


def test_the_table_counts_shares_and_lists(circle: ReportData) -> None:
    n = circle.schemes[1].result.n_sample
    samples = list(range(10, 10 + 2 * LISTED + 20))
    (table,) = switch_tables(with_switches(circle, samples))
    assert (table.count, len(table.listed), table.left_out) == (2 * LISTED + 20, LISTED, LISTED + 20)
    into, back, still = table.rows
    share = 100.0 * (LISTED + 10) / n
    assert into == ("x", "controller → gap", FELL, str(LISTED + 10), f"{share:.1f} %", "0.01 s", "7")
    assert back[4] == f"{100.0 - share:.1f} %" and back[5] == "0.011 s"
    assert still[0] == "y" and still[1].startswith("controller ") and still[2:4] == ("", "0")
    assert table.listed[1] == ("0.011 s", "11", "x", "gap → controller", ROSE, "0.11 mm", "7")


def bars(curve: object) -> list[tuple[float, float]]:
    """Return the segments of a broken line."""
    x = curve.x  # type: ignore[attr-defined]
    parts = np.split(x, np.flatnonzero(np.isnan(x)))
    return [(float(p[~np.isnan(p)][0]), float(p[~np.isnan(p)][-1])) for p in parts]


def test_the_strip_shows_each_controller_where_it_was_active(circle: ReportData) -> None:
    n = circle.schemes[1].result.n_sample
    over_time, along = strip_charts(with_switches(circle, [1000, 2000, 3000]))
    (panel,) = over_time.panels
    lanes = {(curve.name, round(float(np.nanmin(curve.y)))): bars(curve) for curve in panel.curves}
    assert lanes["controller", 0] == [(0.0, pytest.approx(1.0)), (pytest.approx(2.0), pytest.approx(3.0))]
    assert lanes["gap", 0] == [(pytest.approx(1.0), pytest.approx(2.0)), (pytest.approx(3.0), pytest.approx(n * PERIOD))]
    assert lanes["controller", -1] == [(0.0, pytest.approx(n * PERIOD))]
    assert panel.y_ticks == ((0.0, "x"), (-1.0, "y"))
    assert bars(next(c for c in along.panels[0].curves if c.name == "gap"))[0] == (pytest.approx(10.0), pytest.approx(20.0))


def test_the_strip_of_a_chattering_axis_stays_small_and_hides_nothing(circle: ReportData) -> None:
    """A switch at every sample, and one single sample in the gap: both are visible, with a bounded number of points."""
    n = circle.schemes[1].result.n_sample
    chattering = strip_charts(with_switches(circle, list(range(1, n))))[0].panels[0]
    assert {curve.name for curve in chattering.curves} == {"controller", "gap"}
    assert all(curve.x.size < 5000 for curve in chattering.curves)
    single = strip_charts(with_switches(circle, [2000, 2001]))[0].panels[0]
    ((start, stop),) = bars(next(curve for curve in single.curves if curve.name == "gap"))
    assert start == pytest.approx(2.0) and 1e-3 <= stop - start < n * PERIOD / 1000.0


def test_the_page_holds_tables_and_pictures_of_switches_and_backlash(backlash: ReportData) -> None:
    page = render_html(with_switches(backlash, [100, 200, 300]))
    for words in ('id="switches"', 'id="active-time"', 'id="active-arc"', 'id="backlash-0"', 'id="reversals"', FELL, "controller → gap"):
        assert words in page, words
    assert 'id="backlash-1"' not in page
    spoilt = replace(INTO, after="<script>alert(1)</script>")
    found = replace(switched([100], 4000), kinds=(spoilt, BACK))
    page = render_html(replace(backlash, schemes=(backlash.schemes[0], replace(backlash.schemes[1], switches=found))))
    assert "<script>alert(1)" not in page


def test_the_whole_loop_is_drawn_between_the_flanks_of_its_gap(backlash: ReportData) -> None:
    (chart,) = hysteresis_charts(backlash, 500)
    assert len(chart.panels) == 2 and chart.loops
    for panel in chart.panels:
        loop, upper, lower = panel.curves
        load = backlash.schemes[0].result["axis_position"][:, 0] * 1e3
        assert (loop.x.min(), loop.x.max()) == pytest.approx((load.min(), load.max()), abs=2e-2)
        assert (loop.y.min(), loop.y.max()) == pytest.approx((-12.0, 10.0))
        # The gap widens from 16 to 20 um over the middle 20 mm and is constant beyond.
        assert np.interp([-20.0, -10.0, 0.0, 10.0, 20.0], upper.x, upper.y) == pytest.approx([8.0, 8.0, 9.0, 10.0, 10.0])
        np.testing.assert_array_equal(lower.y, -upper.y)
        assert panel.y_range == pytest.approx((-1.15 * 12.0, 1.15 * 12.0))
    assert re.findall(r"([\d.]+) um", chart.caption.replace("4.00", "4"))[-3:] == ["16", "20", "4"]


@pytest.mark.slow
def test_pictures_for_papers_are_written_too(backlash: ReportData, tmp_path: object) -> None:
    files = {file.name for file in write_plots(with_switches(backlash, [100, 200]), tmp_path)}  # type: ignore[arg-type]
    assert {"backlash-0.png", "active-time.png", "active-arc.png"} <= files


def spikes(factor: float) -> tuple[Spike, ...]:
    """Return spikes in the four quadrants of a circle (x turns twice at 0 degrees), and one of z at a corner."""
    turns = (("x", -1, 0.0), ("y", -1, 90.0), ("x", 1, 180.0), ("y", 1, 270.0), ("x", -1, 0.0))
    found = [
        Spike(axis, 0.1 * i, 100 * i, 0, factor * (i + 1) * 1e-6, 0.1 * i, 0.02, way, math.radians(angle))
        for i, (axis, way, angle) in enumerate(turns)
    ]
    return tuple(found)


def test_reversals_are_listed_side_by_side_by_quadrant(circle: ReportData) -> None:
    data = replace(circle, schemes=tuple(replace(s, spikes=spikes(f)) for s, f in zip(circle.schemes, (1.0, -0.5), strict=True)))
    table = reversal_table(data)
    assert table is not None and table.heads == tuple(s.name for s in circle.schemes)
    assert [row[:2] for row in table.rows] == [("x at 0 deg", "2"), ("y at 90 deg", "1"), ("x at 180 deg", "1"), ("y at 270 deg", "1")]
    assert table.rows[0][2] == (("3", "5", "20"), ("1.5", "2.5", "20"))
    text = reversal_text(data)
    assert text.isascii()
    assert [line.partition(" (")[0] for line in text.splitlines()[3:]] == ["x at 0 deg", "y at 90 deg", "x at 180 deg", "y at 270 deg"]
    assert text.splitlines()[3].split()[-6:] == ["3", "/", "5", "1.5", "/", "2.5"]


def test_the_page_separates_reversals_on_arcs_and_elsewhere_and_the_text_combines_them(circle: ReportData) -> None:
    corner = Spike("x", 0.9, 900, 0, 9e-6, 0.9, 0.05, -1, math.nan)
    data = replace(circle, schemes=(replace(circle.schemes[0], spikes=(*spikes(1.0), corner)), replace(circle.schemes[1], spikes=())))
    table = reversal_table(data)
    assert table is not None
    assert table.rows[0][0].startswith("x at 0 deg") and table.rows[-1][:2] == ("x, + to -, not on arcs", "1")
    assert table.rows[-1][2] == (("9", "9", "50"), ("-", "-", "-"))
    assert "x, + to - (3)" in reversal_text(data) and "arcs" not in reversal_text(data)


def test_without_reversals_there_is_no_table(circle: ReportData) -> None:
    data = replace(circle, schemes=tuple(replace(scheme, spikes=()) for scheme in circle.schemes))
    assert reversal_table(data) is None and reversal_text(data) == "" and 'id="reversals"' not in render_html(data)


def test_spikes_are_ringed_on_the_polar_picture(circle: ReportData) -> None:
    run = circle.schemes[0].circles[0]
    top = int(np.argmax(run.deviation))
    first, second = (replace(scheme, spikes=()) for scheme in circle.schemes)
    at = PERIOD * float(run.samples[top])
    spike = Spike("x", at, run.samples[top], 0, 1e-6, at, 0.02, 1, float(run.angle[top]))
    (chart,) = polar_charts(replace(circle, schemes=(replace(first, spikes=(spike,)), second)), 100)
    (mark,) = chart.marks
    assert mark.y[0] == pytest.approx(run.deviation.max() * 1e6) and mark.x[0] == pytest.approx(math.degrees(run.angle[top]))
    assert polar_charts(replace(circle, schemes=(first, second)), 100)[0].marks == ()


def test_an_unstable_loop_of_a_supervised_axis_is_called_unstable(circle: ReportData) -> None:
    first, second = circle.schemes
    meant = "first controller, in contact"
    unstable = Margins(*[math.nan] * 4, stable=False)
    shaky = {axis: replace(loop, margins=unstable, meant=meant) for axis, loop in second.bode.items()}
    data = replace(circle, schemes=(first, replace(second, bode=shaky)))
    (row,) = (row for row in compare(data).rows if row.label == "servo loops")
    assert [cell.text for cell in row.cells] == ["stable", f"unstable: x ({meant}), y ({meant})"]
    assert f"{second.name}: {meant}, " in bode_charts(data, 100)[0].caption
