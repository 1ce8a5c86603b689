"""Contours from files in scenarios: reading, writing, and refusals with their key."""

from __future__ import annotations

import math
from pathlib import Path as File

import numpy as np
import pytest
from drawings import dxf

import contourlab as cl
from contourlab.errors import ScenarioError
from contourlab.scenario import dump, parse_scenario
from contourlab.scenario.values import Contour

TWO_AXES = 'machine = "builtin:ghaffari/a3a1"\ncontroller = "builtin:ghaffari/calibrated"\n'
THREE_AXES = 'machine = "builtin:xyz"\ncontroller = "builtin:xyz-controller"\n'
FEED = '\n[feed]\nfeedrate = "1000 mm/min"\n'


def scenario(folder: File, contour: str, head: str = TWO_AXES) -> File:
    """Write a scenario next to a drawing of a circle of 10 mm and a text."""
    dxf(folder, lambda m: (m.add_circle((0, 0), 10), m.add_text("note", dxfattribs={"layer": "words"})))
    file = folder / "scenario.toml"
    file.write_text(f"{head}[contour]\n{contour}{FEED}", encoding="utf-8")
    return file


def test_a_scenario_survives_a_round_trip(tmp_path: File, monkeypatch: pytest.MonkeyPatch) -> None:
    keys = 'file = "part.dxf"\nunit = "inch"\ntolerance = "2 um"\nlayer = "0"\nchain = 1\n'
    keys += 'scale = 0.5\naxes = 2\nignore = ["TEXT"]\nreverse = true\n'
    monkeypatch.chdir(tmp_path)
    found = cl.load_scenario(scenario(tmp_path, keys).name)
    motion = found.motion
    assert isinstance(motion, Contour)
    assert motion.path.length == pytest.approx(0.5 * 0.0254 * 20 * math.pi, rel=1e-14)
    assert motion.options["tolerance"] == 2e-6
    # The copy contains the full path of the file, so it is valid in any folder.
    monkeypatch.chdir(tmp_path.parent)
    again = parse_scenario(dump(found))
    assert dump(again) == dump(found)
    assert again.motion.path.digest == motion.path.digest  # type: ignore[union-attr]
    assert again.motion.options == motion.options  # type: ignore[union-attr]


def test_points_in_a_scenario(tmp_path: File) -> None:
    u = np.linspace(0.0, 2.0 * math.pi, 30)
    rows = "\n".join(f"{math.cos(x)!r} {math.sin(x)!r}" for x in u)
    (tmp_path / "points.txt").write_text(rows, encoding="utf-8")
    text = 'file = "points.txt"\nunit = "cm"\ntolerance = "5 um"\ncorner_angle = "50 deg"\n'
    found = cl.load_scenario(scenario(tmp_path, text))
    assert found.motion.options["corner_angle"] == pytest.approx(math.radians(50.0))  # type: ignore[union-attr]
    assert "30 points" in dump(found)
    assert dump(parse_scenario(dump(found))) == dump(found)


def test_the_file_name_alone_is_enough(tmp_path: File) -> None:
    file = scenario(tmp_path, 'name = "circle"')
    dxf(tmp_path, lambda m: m.add_circle((0, 0), 10))
    file.write_text(f'contour = "part.dxf"\n{TWO_AXES}{FEED}', encoding="utf-8")
    assert cl.load_scenario(file).motion.path.length == pytest.approx(0.02 * math.pi)  # type: ignore[union-attr]


def test_a_third_axis_is_constant_or_takes_its_coordinate(tmp_path: File) -> None:
    plane = cl.load_scenario(scenario(tmp_path, 'file = "part.dxf"\nignore = ["TEXT"]', THREE_AXES)).base
    reference = plane.reference()
    assert reference.n_axis == 3
    assert not reference.block(0, reference.n_sample).position[:, 2].any()
    assert any("still" in note for note in plane.motion.notes)
    space = cl.load_scenario(scenario(tmp_path, 'file = "part.dxf"\nignore = ["TEXT"]\naxes = 3', THREE_AXES)).base
    assert space.reference().n_axis == 3
    assert not any("still" in note for note in space.motion.notes)


@pytest.mark.parametrize(
    ("text", "key", "message"),
    [
        ('file = "part.dxf"', "contour.file", r'1 TEXT.*words.*ignore = \["TEXT"\]'),
        ('file = "other.dxf"', "contour.file", "no file .*other.dxf"),
        ('file = "part.dxf"\nlayers = "0"', "contour.layers", "'layer'"),
        ('file = "part.dxf"\nunit = "kg"', "contour.unit", "kg"),
        ('file = "part.dxf"\ntolerance = 2', "contour.tolerance", "no unit"),
        ('file = "part.dxf"\nchain = 0', "contour.chain", "equal to 1"),
        ('file = "part.dxf"\naxes = 4', "contour.axes", "2 or 3"),
        ('file = "part.dxf"\nscale = -1', "contour.scale", "range"),
        ('file = "part.dxf"\nlayer = "cut"', "contour.file", "'cut' .* 0, words"),
        ('file = "part.dxf"\nname = "circle"', "contour.name", "both given"),
        ('file = "part.dxf"\ncorner_angle = "200 deg"', "contour.corner_angle", "range"),
        ('file = "part.dxf"\ncorner_angle = "20 deg"', "contour.file", "corner_angle"),
        ('file = "part.step"', "contour.file", r"\.dxf, \.svg"),
        ("file = 3", "contour.file", "quotes"),
        ("", "contour", "name.*file"),
    ],
)
def test_errors_name_file_and_key(tmp_path: File, text: str, key: str, message: str) -> None:
    file = scenario(tmp_path, text)
    with pytest.raises(ScenarioError, match=message) as met:
        cl.load_scenario(file)
    assert met.value.file == str(file)
    assert met.value.key == key
