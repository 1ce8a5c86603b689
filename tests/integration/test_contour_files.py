"""`contourlab run` along drawings and points: from a drawing file to signals on the drawn contour."""

from __future__ import annotations

import json
from pathlib import Path

import ezdxf
import numpy as np
from typed_commands import Run

from contourlab.result import Result

SLOT = """\
name = "slot"
machine = "builtin:ghaffari/a3a1"
controller = "builtin:ghaffari/calibrated"
[contour]
file = "drawings/slot.dxf"
layer = "cut"
[feed]
law = "uniform"
frequency = "0.5 Hz"
laps = 2
[run]
tolerance = "1 mm"
"""


def draw_slot(folder: Path) -> None:
    """Draw a slot of 40 by 20 mm around the origin as loose lines and arcs, and a text on another layer."""
    document = ezdxf.new()  # type: ignore[attr-defined]
    document.header["$INSUNITS"] = 4
    space, cut = document.modelspace(), {"layer": "cut"}
    space.add_line((-10, -10), (10, -10), dxfattribs=cut)
    space.add_line((-10, 10), (10, 10), dxfattribs=cut)
    space.add_arc((10, 0), 10, 270, 90, dxfattribs=cut)
    space.add_arc((-10, 0), 10, 90, 270, dxfattribs=cut)
    space.add_text("slot", dxfattribs={"layer": "words"})
    folder.mkdir()
    document.saveas(folder / "slot.dxf")


def from_slot(points: np.ndarray) -> np.ndarray:
    """Return the distance of points from the slot's edge: the distance from its middle line minus its radius."""
    inner = np.column_stack([np.clip(points[:, 0], -0.01, 0.01), np.zeros(len(points))])
    return np.abs(np.linalg.norm(points - inner, axis=1) - 0.01)


def test_the_tool_follows_a_drawing(contourlab: Run, tmp_path: Path) -> None:
    draw_slot(tmp_path / "drawings")
    (tmp_path / "slot.toml").write_text(SLOT, encoding="utf-8")
    said = contourlab("run", "slot.toml", "--out", "results")
    assert said.code == 0, said.err
    assert (tmp_path / "results" / "report.html").is_file()
    (file,) = (tmp_path / "results" / "signals").glob("*.nc")
    result = Result.load(file)
    reference, tool = np.asarray(result["reference"]), np.asarray(result["tool_position"])
    assert from_slot(reference).max() < 1e-12
    # The judge measures the part error from the path; here it is measured from the drawing.
    np.testing.assert_allclose(np.abs(np.asarray(result["part_error"])), from_slot(tool), rtol=0, atol=1e-9)
    figures = json.loads((tmp_path / "results" / "summary.json").read_text(encoding="utf-8"))
    assert figures["schemes"]


def test_the_tool_follows_points_from_rest_to_rest(contourlab: Run, tmp_path: Path) -> None:
    rows = "\n".join(f"{x},{x * x / 20},0" for x in np.linspace(0.0, 10.0, 21))
    (tmp_path / "points.csv").write_text(f"x [mm],y [mm],z [mm]\n{rows}\n", encoding="utf-8")
    text = 'machine = "builtin:xyz"\ncontroller = "builtin:xyz-controller"\ncontour = "points.csv"\n[feed]\nfeedrate = "1 m/min"\n'
    (tmp_path / "points.toml").write_text(text, encoding="utf-8")
    said = contourlab("run", "points.toml", "--out", "results")
    assert said.code == 0, said.err
    (file,) = (tmp_path / "results" / "signals").glob("*.nc")
    reference = np.asarray(Result.load(file)["reference"])
    np.testing.assert_allclose(reference[:, 1], reference[:, 0] ** 2 / 0.02, rtol=0, atol=1e-8)
    np.testing.assert_allclose(reference[[0, -1]], [(0, 0, 0), (0.01, 0.005, 0)], rtol=0, atol=1e-9)


def test_a_drawing_of_several_parts_is_refused_with_a_list(contourlab: Run, tmp_path: Path) -> None:
    draw_slot(tmp_path / "drawings")
    document = ezdxf.readfile(tmp_path / "drawings" / "slot.dxf")  # type: ignore[attr-defined]
    document.modelspace().add_circle((0, 0), 3, dxfattribs={"layer": "cut"})
    document.saveas(tmp_path / "drawings" / "slot.dxf")
    (tmp_path / "slot.toml").write_text(SLOT, encoding="utf-8")
    said = contourlab("run", "slot.toml", "--check")
    assert said.code == 2
    assert "Traceback" not in said.err
    words = " ".join(said.err.split())
    assert "contour.file" in words
    assert "102.832 mm" in words
    assert "18.8496 mm" in words and "(3, 0) mm" in words
