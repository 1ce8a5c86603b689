"""Cross-coupled control and learning in three and five axes, as typed; a real part program; a report for a single axis."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from reference_data import reference_file
from typed_commands import Run

MASSES = (20.0, 30.0, 24.0, 12.0, 16.0)
HELIX = 'name = "helix"\nradius = "10 mm"\nturns = 3\n[feed]\nfeedrate = "3 m/min"\n'
LISSAJOUS = 'name = "lissajous"\naxes = {n}\namplitude = "5 mm"\n[feed]\nlaw = "uniform"\nfrequency = "0.3125 Hz"\nlaps = 2\n'
SCHEMES = ("fb", "ccc", "mr", "ilc", "ccc+ilc")
STAGE = """\
[machine]
name = "{n} axes"
servo_period = "1 ms"
axes = [{names}]
[axes]
{plants}
[axes."*"]
friction = {{kind = "smooth-coulomb", coulomb = "20 N", breakaway = "25 N", smoothing_velocity = "2 mm/s"}}
drive = {{kind = "delayed-saturation", limit = "20 A", delay = "1 ms"}}
sensor = {{kind = "encoder", resolution = "0.1 um"}}
limits = {{velocity = "300 mm/s", acceleration = "15 m/s^2", jerk = "200 m/s^3"}}
[controller]
estimator = "newton"
coupling = {{kind = "cross-coupled", gain = "5 A/mm"}}
[controller.axes."*"]
velocity = {{kind = "filtered-difference", bandwidth = "2000 rad/s"}}
[controller.axes."*".controller]
kind = "position"
gains = {{natural_frequency = "80 rad/s", damping = 0.8, pole = "10 rad/s"}}
[learning]
law = {{kind = "zero-phase", gain = 0.4, half_width = 3, passes = 2, lead = "5 ms"}}
trials = 10
[contour]
"""
REAL_PART = """\
name = "three axes, cross-coupled and learning"
machine = "builtin:{machine}"
[program]
file = "{program}"
fit = true
require_end = false
[feed]
path_control = "blend"
corner_tolerance = "5 um"
[controller]
file = "builtin:xyz-controller"
estimator = "newton"
coupling = {{kind = "cross-coupled", gain = "5 A/mm"}}
[learning]
law = {{kind = "zero-phase", gain = 0.68, half_width = 3, passes = 2, lead = "2.5 ms"}}
trials = 10
"""


def write(folder: Path, n: int, contour: str) -> str:
    names = "xyzuv"[:n]
    plant = '{}.plant = {{kind = "mass-damper", mass = "{} kg", damping = "100 N*s/m", force_constant = "60 N/A"}}'
    plants = "\n".join(plant.format(axis, mass) for axis, mass in zip(names, MASSES, strict=False))
    text = STAGE.format(n=n, names=", ".join(f'"{axis}"' for axis in names), plants=plants) + contour.replace("{n}", str(n))
    (folder / "s.toml").write_text(text, encoding="utf-8")
    return "s.toml"


def schemes_of(said: Any) -> dict[str, Any]:
    assert said.code == 0, said.err
    found: dict[str, Any] = json.loads(said.out)["schemes"]
    return found


@pytest.mark.parametrize(
    ("n", "contour"),
    [
        pytest.param(3, HELIX, id="helix", marks=pytest.mark.slow),
        pytest.param(5, LISSAJOUS, id="lissajous-5", marks=pytest.mark.slow),
    ],
)
def test_every_scheme_runs_in_more_axes(contourlab: Run, tmp_path: Path, n: int, contour: str) -> None:
    said = contourlab("compare", write(tmp_path, n, contour), "--schemes", ",".join(SCHEMES), "--signals", "position", "--json")
    found = schemes_of(said)
    assert list(found) == list(SCHEMES)
    assert all(scheme["axes"] == list("xyzuv"[:n]) for scheme in found.values())
    rms = {name: scheme["metrics"]["contour_error"]["rms"] for name, scheme in found.items()}
    # With full feedforward only the friction error is left: coupling nearly halves it, learning removes all but a few per cent.
    assert rms["ccc"] < 0.75 * rms["fb"]
    assert rms["mr"] < 1.2 * rms["fb"]
    assert rms["ilc"] < 0.05 * rms["fb"]
    assert rms["ccc+ilc"] < 0.75 * rms["ilc"]
    for name in ("ilc", "ccc+ilc"):
        trials = [trial["contour_rms"] for trial in found[name]["learning"]["trials"]]
        assert all(later < earlier for earlier, later in pairwise(trials))
        # With gain = 0.4 each trial removes about 40 % of the error, down to the encoder's 0.1 um.
        assert trials[1] / trials[0] == pytest.approx(0.6, abs=0.03)
    assert all(scheme["tick"] > 0.0 for scheme in found.values())  # how long depends on what else the processor does


@pytest.mark.slow
@pytest.mark.parametrize(("n", "contour"), [(5, LISSAJOUS)])
def test_more_axes_are_analysed(contourlab: Run, tmp_path: Path, n: int, contour: str) -> None:
    said = contourlab("analyse", write(tmp_path, n, contour), "--schemes", "ccc+ilc", "--json")
    found = json.loads(said.out)["schemes"]["ccc+ilc"]
    assert list(found["margins"]) == list("xyzuv") and all(margins["stable"] for margins in found["margins"].values())
    assert found["coupling"]["stable"]
    codes = [finding["code"] for finding in found["findings"]]
    assert "CL350" not in codes
    # Above the average's first zero, at 143 Hz, a loop with a delay cannot learn with the right sign everywhere.
    learning = found["learning"]
    assert 143.0 < learning["worst_frequency"] < 500.0 and 1.0 < learning["worst_factor"] < 1.002
    assert "CL312" in codes


@pytest.mark.slow
@pytest.mark.parametrize(("machine", "left"), [("xyz-with-errors", 0.55)])
def test_a_part_program_of_three_axes_is_learned(contourlab: Run, tmp_path: Path, machine: str, left: float) -> None:
    program = reference_file("gcode/linuxcnc__nc_files_3dtest.ngc")
    (tmp_path / "part.toml").write_text(REAL_PART.format(machine=machine, program=program.as_posix()), encoding="utf-8")
    found = schemes_of(contourlab("learn", "part.toml", "--signals", "part_error", "--json"))
    before, after = (found[name]["metrics"] for name in ("before learning", "after learning"))
    assert after["part_error"]["max"] < left * before["part_error"]["max"]
    # Learning does not remove the planner's deviation at rounded corners.
    assert after["planning_deviation"]["max"] == before["planning_deviation"]["max"]
    assert (tmp_path / "results" / "learned").is_dir() and (tmp_path / "results" / "report.html").stat().st_size > 100_000


@pytest.mark.slow
def test_a_single_axis_has_a_report_without_a_picture_of_its_path(contourlab: Run, tmp_path: Path) -> None:
    done = contourlab("run", "builtin:emps/there-and-back", "--no-interval", "--out", "out", "--plots", "png")
    assert done.code == 0, done.err
    names = {file.stem for file in (tmp_path / "out" / "plots").iterdir()}
    assert {"error-time", "axis-0"} <= names
    assert not any(name.startswith("path") for name in names)
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert 'id="errors"' in page
    assert 'id="path"' not in page
    assert 'href="#path"' not in page
