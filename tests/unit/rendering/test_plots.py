"""Single files for papers and slides."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from contourlab.errors import OutputError, ParameterError
from contourlab.rendering.charts import Chart, Curve, Panel
from contourlab.rendering.plots import write_charts, write_plots

MAGIC = {"png": b"\x89PNG\r\n", "svg": b"<?xml", "pdf": b"%PDF-"}


@pytest.mark.slow
def test_every_picture_in_every_format_and_the_same_bytes_again(square, tmp_path):
    files = write_plots(square, tmp_path / "new", ("png", "svg", "pdf"))
    names = {file.stem for file in files}
    assert names == {"path-0", "error-time", "error-arc", "spectrum", "axis-0", "axis-1"} and len(files) == 18
    for file in files:
        assert file.read_bytes().startswith(MAGIC[file.suffix[1:]])
    again = write_plots(square, tmp_path / "again", ("png", "svg", "pdf"))
    assert [file.read_bytes() for file in again] == [file.read_bytes() for file in files]


@pytest.mark.slow
def test_circle_and_bode_are_drawn(single, tmp_path):
    names = {file.stem for file in write_plots(single, tmp_path)}
    assert {"circle-0", "bode-0", "bode-1"} <= names


@pytest.mark.slow
def test_names_with_formula_characters_are_printed_literally(square, tmp_path):
    odd = replace(square, title="cost $1 and $2", schemes=(replace(square.schemes[0], name="_kept $x_"),))
    svg = {file.stem: file.read_text() for file in write_plots(odd, tmp_path, ("svg",))}
    assert "_kept $x_" in svg["error-time"]


@pytest.mark.slow
def test_gaps_in_a_signal_are_gaps_in_the_picture(square, tmp_path):
    result = square.schemes[0].result
    error = np.array(result["contour_error"])
    error[100:200] = np.nan
    holed = result.with_signals(contour_error=replace(result.signals["contour_error"], data=error))
    data = replace(square, schemes=(replace(square.schemes[0], result=holed),))
    assert write_plots(data, tmp_path)


def test_unknown_format_names_the_known_ones(square, tmp_path):
    with pytest.raises(ParameterError, match=r"png.*\bpdf"):
        write_plots(square, tmp_path, ("gif",))


def test_a_folder_that_is_a_file(square, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(OutputError, match="file"):
        write_plots(square, tmp_path / "file")


def test_points_with_bars_are_points(tmp_path):
    """Measured points have one mark each and no line between them."""
    x, y = np.array([1.0, 2.0, 4.0]), np.array([3.0, 1.0, 2.0])
    points = Curve(x, y, "measured", "#000000", half=np.full(3, 0.5))
    chart = Chart("seen", "Points", "", (Panel("x", "y", (points, Curve(x, y, "model", "#ff0000"))),))
    (file,) = write_charts([chart], tmp_path, ("svg",))
    assert file.read_text().count("<use ") >= 3
