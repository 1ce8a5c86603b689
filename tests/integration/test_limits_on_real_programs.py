"""Motions of real part programs, checked against the machine's limits by the independent verifier."""

from __future__ import annotations

from typing import Any

import pytest
from reference_data import part_programs

from contourlab.feed.verify import limit_report
from contourlab.scenario import scenario_from_parts

QUICK = ("circle.gcode", "compass_text.ngc", "hole-circle.ngc", "polar.ngc", "3dtest.ngc", "g17-g98-g81.ngc")
LONGER = ("heart.ngc", "8x_gear_test.nc", "HSM_test.nc", "3D_Chips.ngc", "arcspiral.ngc", "cds.ngc", "flowsnake.ngc", "G5_butterfly-xy.ngc")
ALSO = ("vcarve.ngc", "spiral.ngc", "tort.ngc", "arc-xz-plane.gcode", "circle-inch.gcode")
FEEDS: tuple[dict[str, Any], ...] = ({}, {"path_control": "blend", "corner_tolerance": "10 um"})


@pytest.mark.parametrize("feed", FEEDS, ids=["as programmed", "blend"])
@pytest.mark.parametrize("name", [*QUICK, *(pytest.param(name, marks=pytest.mark.slow) for name in (*LONGER, *ALSO))])
def test_no_limit_is_passed_by_more_than_half_a_percent(name: str, feed: dict[str, Any]) -> None:
    found = [file for file in part_programs() if file.name.endswith(f"_{name}")]
    if not found:
        pytest.skip("the part program is not among the reference data beside the clone")
    options = {"fit": True, "require_end": False}
    (case,) = scenario_from_parts(str(found[0]), "builtin:xyz", "xyz-controller", options=options, feed=feed).cases()
    report = limit_report(case.reference(), case.machine.planner_limits())
    assert report.ok(0.005), max(report.all(), key=lambda worst: worst.ratio)
    # A motion far below its limits would pass as well.
    assert max(worst.ratio for worst in report.jerk) > 0.99
