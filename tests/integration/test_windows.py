"""``--window`` on commands that take logs: a part of a log is a log of its own."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from reference_data import reference_file
from test_identify import written
from typed_commands import AsJson, Refused

import contourlab as cl


def parts(folder: Path) -> tuple[Path, Path, Path]:
    """Return a log of an axis, and its halves as logs of their own."""
    log = written(folder, seconds=8.0)
    head, *rows = log.read_text().splitlines()
    halves = folder / "first.csv", folder / "second.csv"
    for half, lines in zip(halves, (rows[:4000], rows[4000:]), strict=True):
        half.write_text("\n".join([head, *lines, ""]))
    log.write_text("\n".join([head, *rows, ""]))
    return log, *halves


def test_one_window_for_all_logs_or_one_for_each(tmp_path: Path, as_json: AsJson, refused: Refused) -> None:
    log, first, second = parts(tmp_path)
    force = ("--column", "force.x=push")
    alone = as_json("identify", first, *force, "--validation", second)
    again = as_json("identify", log, *force, "--validation", log, "--window", "..3999", "--window", "4000..")
    assert again["parameters"] == alone["parameters"]
    assert again["details"]["validation"] == pytest.approx(alone["details"]["validation"])
    both = as_json("identify", log, *force, "--window", "4 s..")
    assert both["parameters"] == as_json("identify", second, *force)["parameters"]
    assert "one for each" in refused("identify", log, *force, *(3 * ["--window", "0..99"]))
    assert "given once" in refused("identify", log, log, *force, "--model", "friction", "--window", "0..3999")


def test_limits_of_a_part_have_its_lines(as_json: AsJson) -> None:
    log = reference_file("data/sinumerik/capture-840d.json")
    found = as_json("limits", log, "--axes", "X1,Y1", "--window", "0..1493", "--velocity", "1 m/s")
    assert {row["line"] for row in found["lines"]} == {435, 453, 460, 511}


def test_a_log_that_is_read_already(tmp_path: Path) -> None:
    """In Python: a window of the question counts from the whole log, and stands in for that of the log."""
    angle = np.arange(3000) * 2e-3
    arrays = {"time [s]": angle / 2.0, "reference.x [mm]": 20.0 * np.cos(angle), "reference.y [mm]": 20.0 * np.sin(angle)}
    arrays |= {f"position.{axis} [mm]": 1.0001 * arrays[f"reference.{axis} [mm]"] for axis in "xy"}
    part = cl.load_log({name: values[1000:2000] for name, values in arrays.items()})
    wanted = cl.measure(part).runs[0].metrics.contour_error
    for log, window in (
        (cl.load_log(arrays), "1000..1999"),
        (cl.load_log(arrays), "1 s..1.999 s"),
        (cl.load_log(arrays, window="1000..1999"), ()),
        (cl.load_log(arrays, window="..99"), "1000..1999"),
    ):
        found = cl.measure(log, window=window).runs[0].metrics.contour_error
        assert (found.rms, found.max) == (pytest.approx(wanted.rms, rel=1e-9), pytest.approx(wanted.max, rel=1e-9))


def test_a_file_of_angles_has_no_window(tmp_path: Path, refused: Refused) -> None:
    angle = np.linspace(0.0, 360.0, 400)
    file = tmp_path / "ball-bar.csv"
    np.savetxt(file, np.column_stack([angle, 50.0 + 0.001 * np.sin(angle)]), delimiter=",", header="angle [deg],radius [mm]", comments="")
    assert "--window" in refused("circle", file, "--radius", "50 mm", "--window", "0..99")
