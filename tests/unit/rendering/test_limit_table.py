"""The table of the planned motion against the axis limits."""

from __future__ import annotations

import math
import re
from dataclasses import replace

from contourlab.feed import LimitReport
from contourlab.feed.verify import Worst
from contourlab.rendering.data import ReportData
from contourlab.rendering.html import render_html
from contourlab.rendering.page_tables import LIMIT_TITLE as TITLE

CURVATURE = "curvature step"
REPORT = LimitReport(
    # The second axis is slower but nearer to its limit.
    velocity=(Worst(0, 0.1, 0.4, 0.0, 10, 0.01, (0.0, 0.0), 3), Worst(1, 0.05, 0.1, 0.0, 20, 1.25, (0.0, 0.0), 7)),
    acceleration=(Worst(0, 2.004, 2.0, 0.0, 30, 0.03, (0.0, 0.0), 4), Worst(1, 1.0, 2.0, 0.0, 5, 0.005, (0.0, 0.0), 4)),
    jerk=(Worst(0, 30.0, math.inf, 0.0, 6, 0.006), Worst(1, 90.0, math.inf, 0.0, 7, 0.007)),
    curvature_step=(Worst(0, 0.5, 2.0, 0.3, 8, 0.008, (0.0, 0.0), 5), Worst(1, 0.0, 2.0, 0.3, 8, 0.008, (0.0, 0.0), 5)),
    kink=(Worst(0, 0.0, 0.002), Worst(1, 0.0, 0.002)),
)


def tables(data: ReportData) -> dict[str, list[list[str]]]:
    """Return the cells of each such table of the page, by caption."""
    found = re.findall(rf"<caption>({TITLE}[^<]*)</caption>(.*?)</table>", render_html(data), flags=re.S)
    return {title: [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row) for row in re.findall(r"<tr>.*?</tr>", body)] for title, body in found}


def with_limits(data: ReportData, *limits: LimitReport | None) -> ReportData:
    schemes = [replace(scheme, limits=one) for scheme, one in zip(data.schemes, limits, strict=True)]
    return replace(data, schemes=schemes)


def test_each_row_names_the_axis_nearest_to_its_limit(single: ReportData) -> None:
    ((title, rows),) = tables(with_limits(single, REPORT)).items()
    assert title == TITLE and len(rows[0]) == 7
    assert rows[1:] == [
        ["velocity", "y", "3000 mm/min", "6000 mm/min", "50.0 %", "1.25 s", "7"],
        ["acceleration", "x", "2.004 m/s^2", "2 m/s^2", "100.2 %", "0.03 s", "4"],
        ["jerk", "y", "90 m/s^3", "none", "-", "0.007 s", "-"],
        [CURVATURE, "x", "0.5 m/s^2", "2 m/s^2", "10.0 %", "0.008 s", "5"],
        ["kink", "-", "-", "-", "-", "-", "-"],
    ]


def test_schemes_that_share_a_motion_share_a_table(circle: ReportData) -> None:
    other = replace(REPORT, n_kink=1)
    names = [scheme.name for scheme in circle.schemes]
    assert list(tables(with_limits(circle, REPORT, replace(REPORT)))) == [TITLE]
    assert list(tables(with_limits(circle, REPORT, other))) == [f"{TITLE}: {name}" for name in names]
    assert list(tables(with_limits(circle, None, REPORT))) == [f"{TITLE}: {names[1]}"]


def test_without_a_planned_motion_there_is_no_table(circle: ReportData) -> None:
    page = render_html(circle)
    assert TITLE not in page
