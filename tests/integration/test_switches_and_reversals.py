"""Backlash in the results: switches with their reasons, reversal spikes by quadrant, the loop of motor and load."""

from __future__ import annotations

import csv
import json
import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browsing import Browsing
from test_report_page import check_pictures, in_file
from typed_commands import Finished, contents, invoke

from contourlab.result import Result

SCENARIO = """\
name = "Circle with backlash"
machine = "builtin:backlash/xyz-twin"
[contour]
name = "circle"
radius = "20 mm"
[feed]
law = "uniform"
frequency = "0.5 Hz"
laps = 2
[controller.axes."*"]
feedback = "motor"
velocity = {kind = "filtered-difference", bandwidth = "600 rad/s"}
controller = {kind = "cascade", gains = {bandwidth = "100 rad/s", damping = 0.9, position_gain = "25 1/s"}}
[schemes."PI cascade"]
[schemes."by the gap".controller.axes.x]
supervisor = {kind = "performance", measure = "motor-load-difference", thresholds = ["10 um"], hysteresis = "1 um"}
others.gap = {kind = "cascade", gains = {bandwidth = "100 rad/s", damping = 0.9, position_gain = "20 1/s"}}
[schemes."by the place".controller.axes."*"]
supervisor = {kind = "pre-routed", places = ["30 mm"], numbers = [1]}
others.level = {kind = "cascade", gains = {bandwidth = "100 rad/s", damping = 0.9, position_gain = "15 1/s"}}
"""
LAP, PERIOD = 2000, 1e-3


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> Finished:
    place = tmp_path_factory.mktemp("backlash")
    (place / "circle.toml").write_text(SCENARIO, encoding="utf-8")
    return Finished(place / "results", invoke(place, "run", "circle.toml", "--out", "results"))


@pytest.fixture(scope="module")
def schemes(found: Finished) -> dict[str, Any]:
    values = json.loads((found.folder / "summary.json").read_text(encoding="utf-8"))["schemes"]
    assert isinstance(values, dict)
    return values


def rows(found: Finished, name: str) -> list[dict[str, str]]:
    with (found.folder / "switches" / f"{name}.csv").open(encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


@pytest.mark.slow
def test_each_scheme_with_several_controllers_leaves_a_table_of_its_switches(found: Finished) -> None:
    assert (found.said.code, found.said.err) == (0, "")
    assert {name for name in contents(found.folder) if name.startswith("switches/")} == {
        "switches/by-the-gap.csv",
        "switches/by-the-place.csv",
    }
    signals = Result.load(found.folder / "signals" / "by-the-gap.nc")
    active = np.vstack([np.zeros(3), signals["active_controller"]])  # a run begins with the first controller
    listed = rows(found, "by-the-gap")
    changed = np.argwhere(np.diff(active, axis=0) != 0.0)
    assert [(int(row["sample"]), row["axis"]) for row in listed] == [(k, signals.axes[j]) for k, j in changed.tolist()]
    assert {row["axis"] for row in listed} == {"x"} and len(listed) > 4
    for row in listed:
        k = int(row["sample"])
        names = tuple("gap" if number == 1.0 else "controller" for number in active[k : k + 2, 0])
        assert (row["from"], row["to"]) == names
        assert ("fell" if names[1] == "gap" else "rose") in row["reason"]
        assert float(row["arc_length_m"]) == pytest.approx(signals["arc_length"][k], rel=1e-9)


def test_a_pre_routed_switch_is_at_its_place(found: Finished) -> None:
    listed = rows(found, "by-the-place")
    assert [(row["axis"], row["from"], row["to"]) for row in listed] == [(axis, "controller", "level") for axis in "xyz"]
    for row in listed:
        assert 0.03 <= float(row["arc_length_m"]) < 0.03 + 0.02 * np.pi * PERIOD * 1.001


def test_the_summary_counts_what_the_table_lists(found: Finished, schemes: dict[str, Any]) -> None:
    assert schemes["PI cascade"]["switches"] is None
    summary, listed = schemes["by the gap"]["switches"], rows(found, "by-the-gap")
    assert set(summary) == {"axes", "listed", "left_out"} and set(summary["axes"]) == {"x"}
    x = summary["axes"]["x"]
    assert x["count"] == len(listed) == sum(kind["count"] for kind in x["kinds"]) == len(summary["listed"]) + summary["left_out"]
    assert x["first"] == "controller" and sum(x["active"].values()) == pytest.approx(2 * LAP * PERIOD)
    for one, row in zip(summary["listed"], listed, strict=False):
        assert [str(one[key]) for key in ("sample", "axis", "from", "to", "reason")] == [
            row[key] for key in ("sample", "axis", "from", "to", "reason")
        ]
    assert {axis: one["count"] for axis, one in schemes["by the place"]["switches"]["axes"].items()} == dict.fromkeys("xyz", 1)


def test_the_printed_text_has_a_line_for_each_axis(found: Finished, schemes: dict[str, Any]) -> None:
    count = schemes["by the gap"]["switches"]["axes"]["x"]["count"]
    into = (count + 1) // 2
    assert re.search(rf"^by the gap: x: {count} \w+: controller -> gap {into} \(", found.said.out, re.MULTILINE)
    assert re.search(r"^by the place: y: 1 \w+: controller -> level 1 \(", found.said.out, re.MULTILINE)
    assert "PI cascade: x:" not in found.said.out


def test_reversals_are_listed_by_quadrant(found: Finished, schemes: dict[str, Any]) -> None:
    """In the last lap x reverses at 0 and 180 degrees and y at 90 and 270, once each."""
    for scheme in schemes.values():
        figures = {round(np.degrees(one["angle"])): one for one in scheme["reversal_figures"]}
        assert {degrees: (one["axis"], one["direction"], one["count"]) for degrees, one in figures.items()} == {
            0: ("x", -1, 1),
            90: ("y", -1, 1),
            180: ("x", 1, 1),
            270: ("y", 1, 1),
        }
        spikes = {round(np.degrees(one["angle"])): one for one in scheme["reversals"]}
        for degrees, one in figures.items():
            assert one["largest"] == one["mean"] == pytest.approx(abs(spikes[degrees]["height"]))
        # The tool swings through its whole radial deviation, about once per quadrant.
        (circle,) = scheme["circles"]
        swing = circle["radial deviation F_max"] - circle["radial deviation F_min"]
        assert 0.5 * swing < max(one["largest"] for one in figures.values()) <= swing
    table = [line for line in found.said.out.splitlines() if re.match(r"[xy] at \d+ deg \(1\)", line)]
    assert [line.partition(" (")[0] for line in table] == ["x at 0 deg", "y at 90 deg", "x at 180 deg", "y at 270 deg"]
    assert all(line.count("/") == 3 for line in table)


def test_the_page_shows_switches_reversals_and_backlash(found: Finished) -> None:
    page = (found.folder / "report.html").read_text(encoding="utf-8")
    for key in ("switches", "reversals", "backlash", "active-time", "active-arc", "backlash-0", "backlash-1"):
        assert f'id="{key}"' in page, key
    for words in ("controller → gap", "controller → level", "x at 180 deg", "backlash gap 20 um"):
        assert words in page, words


@pytest.mark.slow
def test_a_browser_draws_every_picture(found: Finished, browsing: Browsing) -> None:
    page = found.folder / "report.html"
    assert {"active-time", "active-arc", "backlash-0", "backlash-1", "backlash-2", "circle-0"} <= set(in_file(page))
    check_pictures(browsing, page)


def test_the_linear_loop_of_a_supervised_axis_is_labelled(found: Finished) -> None:
    page = (found.folder / "report.html").read_text(encoding="utf-8")
    assert all(re.search(rf"{scheme}: [^<]*contact", page) for scheme in ("PI cascade", "by the gap"))


def test_a_later_run_removes_the_tables_of_an_older_one(found: Finished, tmp_path: Path) -> None:
    results = tmp_path / "results"
    shutil.copytree(found.folder, results)
    assert (results / "switches").exists()
    plain = SCENARIO.partition('[schemes."by the gap"')[0]
    (tmp_path / "plain.toml").write_text(plain, encoding="utf-8")
    said = invoke(tmp_path, "run", "plain.toml", "--out", "results")
    assert said.code == 0 and not (results / "switches").exists()
