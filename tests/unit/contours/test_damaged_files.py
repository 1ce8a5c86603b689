"""Truncated files and numbers out of range raise one error with advice."""

from __future__ import annotations

import math
from pathlib import Path as File
from typing import Any

import numpy as np
import pytest
from drawings import MM, dxf, svg

from contourlab.contours import read_contour
from contourlab.contours.dxf import read_dxf
from contourlab.errors import ContourlabError, GeometryError


def draw(m: Any) -> None:
    block = m.doc.blocks.new("PART")
    block.add_circle((1, 0), 1)
    m.add_blockref("PART", (10, 0))
    m.add_line((0, 0), (10, 0))
    m.add_lwpolyline([(20, 0, 0.5), (30, 0, 0)], format="xyb")
    m.add_open_spline([(0, 0, 0), (10, 20, 0), (20, -15, 0), (30, 10, 0)], degree=3)


def test_a_drawing_truncated_anywhere_is_refused(tmp_path: File) -> None:
    whole = dxf(tmp_path, draw).read_bytes()
    entities = whole.index(b"ENTITIES")
    rng = np.random.default_rng(3)
    places = [*rng.integers(0, len(whole) - 12, 25), *rng.integers(entities, len(whole) - 12, 45)]
    file = tmp_path / "cut.dxf"
    for place in map(int, places):
        file.write_bytes(whole[:place])
        with pytest.raises(ContourlabError) as caught:
            read_dxf(file, unit="mm")
        assert str(file) in str(caught.value)
    file.write_bytes(whole.rstrip())
    assert len(read_dxf(file).chains) == 3  # the line and the spline start together


def test_a_drawing_with_wrong_bytes_is_read_or_refused(tmp_path: File) -> None:
    whole = dxf(tmp_path, draw).read_bytes()
    entities = whole.index(b"ENTITIES")
    rng = np.random.default_rng(4)
    file = tmp_path / "hurt.dxf"
    for _ in range(40):
        data = bytearray(whole)
        for place in rng.integers(entities, len(whole), 3):
            data[int(place)] = int(rng.integers(32, 127))
        file.write_bytes(data)
        try:
            read_dxf(file, unit="mm")
        except ContourlabError as error:
            assert str(file) in str(error)


@pytest.mark.parametrize(
    "wrong",
    [
        lambda m: m.add_circle((0, 0), math.nan),
        lambda m: m.add_circle((0, 0), math.inf),
        lambda m: m.add_circle((math.nan, 0), 3),
        lambda m: m.add_arc((0, 0), 3, math.nan, 20),
        lambda m: m.add_line((0, 0), (math.inf, 1)),
        lambda m: m.add_lwpolyline([(0, 0, math.nan), (1, 1, 0)], format="xyb"),
        lambda m: m.add_open_spline([(0, 0, 0), (10, math.nan, 0), (20, -15, 0), (30, 10, 0)], degree=3),
        lambda m: m.add_line((0, 0), (1e300, 1)),
    ],
)
def test_non_finite_numbers_are_refused_with_their_entity(tmp_path: File, wrong: Any) -> None:
    file = dxf(tmp_path, lambda m: (m.add_line((0, 0), (1, 0)), wrong(m)))
    with pytest.raises(GeometryError, match=r"part\.dxf: [A-Z]+ #\w+ on layer 0: .*(finite|unit)"):
        read_contour(file)


def test_distant_svg_coordinates_are_refused(tmp_path: File) -> None:
    with pytest.raises(GeometryError, match=r"line 'far': reaches 1e\+27 m"):
        read_contour(svg(tmp_path, '<line id="far" x1="0" x2="1e30"/>'))


@pytest.mark.parametrize(("row", "unit"), [("1e308,0", "mm"), ("0,-1e10", "mm"), ("1000001,0", "m")])
def test_distant_points_are_refused_with_their_line(tmp_path: File, row: str, unit: str) -> None:
    file = tmp_path / "part.csv"
    file.write_text(f"x,y\n0,0\n1,0\n{row}\n", encoding="utf-8")
    with pytest.raises(GeometryError, match=r"part\.csv:4: .* 1e\+06 m"):
        read_contour(file, unit=unit)
    file.write_text("x,y\n0,0\n1000000,0\n", encoding="utf-8")
    assert read_contour(file, unit="m").length == pytest.approx(1e6)


@pytest.mark.parametrize("text", ['"x [mm]","y [mm]"\n"0","0"\n"3", "4"\n', '"0";"0"\n"3,0";"4,0"\n', '"0" "0"\n3 "4"\n'])
def test_quoted_cells_are_numbers(tmp_path: File, text: str) -> None:
    file = tmp_path / "part.csv"
    file.write_text(text, encoding="utf-8")
    assert read_contour(file, unit=None if "mm" in text else "mm").length == pytest.approx(5 * MM)


def test_a_column_of_time_is_named(tmp_path: File) -> None:
    file = tmp_path / "part.csv"
    file.write_text("t [s],x [mm],y [mm]\n0,0,0\n1,3,4\n", encoding="utf-8")
    with pytest.raises(GeometryError, match=r"part\.csv:1: column t\b.* s,"):
        read_contour(file)


@pytest.mark.parametrize(
    ("choice", "message"),
    [
        ({"chain": 1.5}, "chain = 1.5: "),
        ({"chain": True}, "chain = True: "),
        ({"chain": "1"}, "chain = '1': "),
        ({"ignore": "TEXT"}, r'ignore = "TEXT": .*\["TEXT"\]'),
        ({"ignore": 3}, "ignore = 3: .*list"),
        ({"ignore": [3]}, r"ignore = \[3\]: .*list"),
    ],
)
def test_options_of_the_wrong_kind(tmp_path: File, choice: dict[str, Any], message: str) -> None:
    with pytest.raises(GeometryError, match=message):
        read_contour(dxf(tmp_path, draw), **choice)
    assert read_contour(dxf(tmp_path, draw), chain=np.int64(3)).length > 0.0  # type: ignore[arg-type]
