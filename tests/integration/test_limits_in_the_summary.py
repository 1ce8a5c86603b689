"""`limits` of summary.json: the verifier's report on a motion with peaks known in closed form."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from typed_commands import PART, Finished

from contourlab.features.run import outcome
from contourlab.feed import verify
from contourlab.scenario import load_scenario

FEED, RADIUS, JERK, ACCELERATION = 1.0 / 60.0, 5e-3, 40.0, 1.5  # F1000 in m/s, the arc, and the limits of the machine


def limits(finished: Finished, scheme: str) -> Any:
    text = (finished.folder / "summary.json").read_text(encoding="utf-8")
    return json.loads(text)["schemes"][scheme]["limits"]


def test_the_peaks_of_a_line_and_half_a_circle(part: Finished) -> None:
    """The feed is below A^2 / J of the axes: it rises in a triangle of acceleration, sqrt(v J) high, along the line in x."""
    found = limits(part, "base")
    assert list(found) == ["velocity", "acceleration", "jerk", "curvature_step", "kink"]
    for kind in ("velocity", "acceleration", "jerk", "curvature_step"):
        assert set(found[kind]) == {"axis", "value", "limit", "ratio", "time", "line"}
    velocity, acceleration, jerk, step = (found[kind] for kind in ("velocity", "acceleration", "jerk", "curvature_step"))
    assert (velocity["value"], velocity["limit"]) == pytest.approx((FEED, 0.2), rel=1e-6)
    assert velocity["ratio"] == pytest.approx(FEED / 0.2, rel=1e-6)
    # A sample sees the tip of the triangle within a period of jerk.
    top = (FEED * JERK) ** 0.5
    assert top - 1e-3 * JERK < acceleration["value"] < top
    assert (acceleration["axis"], acceleration["limit"]) == ("x", ACCELERATION)
    assert (jerk["value"], jerk["limit"], jerk["ratio"]) == pytest.approx((JERK, JERK, 1.0), rel=1e-6)
    line = PART.splitlines().index("G1 X5 F1000") + 1
    assert (acceleration["line"], jerk["line"]) == (line, line)
    # The line is tangent to the arc: only the centripetal acceleration, along y, jumps.
    assert (step["axis"], step["limit"]) == ("y", ACCELERATION)
    assert step["value"] == pytest.approx(FEED**2 / RADIUS, rel=1e-6)
    assert step["ratio"] == pytest.approx(FEED**2 / RADIUS / ACCELERATION, rel=1e-6)
    # Five millimetres, and half a rise of 2 sqrt(v / J), during which the mean speed is half of the feed.
    assert step["time"] == pytest.approx(5e-3 / FEED + (FEED / JERK) ** 0.5, abs=1e-3)
    assert found["kink"] is None


def test_a_motion_that_was_not_planned_has_none(circle: Finished) -> None:
    assert limits(circle, "all of it") is None


def test_schemes_along_one_motion_share_one_report(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "part.ngc").write_text(PART, encoding="utf-8")
    (tmp_path / "part.toml").write_text(
        'program = "part.ngc"\nmachine = "builtin:xyz"\ncontroller = "builtin:xyz-controller"\n[schemes.a]\n[schemes.b]\n'
        '[schemes.tight]\naxes.z.limits.velocity = "5 m/min"\n',
        encoding="utf-8",
    )
    looked: list[float] = []

    def counted(*given: Any) -> verify.LimitReport:
        looked.append(float(given[1].velocity[2]))
        return verify.limit_report(*given)

    monkeypatch.setattr(outcome, "limit_report", counted)
    monkeypatch.setattr(outcome, "_REPORTS", {})
    cases = load_scenario(tmp_path / "part.toml").cases()
    a, b, tight = (outcome.limits_of(case, case.reference()) for case in cases)
    assert a is b
    assert looked == pytest.approx([0.1, 5.0 / 60.0])
    assert a is not None and tight is not None
    assert tight.velocity[2].limit == pytest.approx(5.0 / 60.0)
