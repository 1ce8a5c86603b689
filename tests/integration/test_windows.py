"""``--window`` on commands that take logs: a part of a log is a log of its own."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from reference_data import reference_file
from test_identify import written
from typed_commands import AsJson, Refused


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


def test_a_file_of_angles_has_no_window(tmp_path: Path, refused: Refused) -> None:
    angle = np.linspace(0.0, 360.0, 400)
    file = tmp_path / "ball-bar.csv"
    np.savetxt(file, np.column_stack([angle, 50.0 + 0.001 * np.sin(angle)]), delimiter=",", header="angle [deg],radius [mm]", comments="")
    assert "--window" in refused("circle", file, "--radius", "50 mm", "--window", "0..99")
