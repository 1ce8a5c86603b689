"""Pictures of studies: their content, and their files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from contourlab.features.sensitivity.command import curve_tile, indices_chart, interactions_chart
from contourlab.features.sensitivity.curves import Curve, Interval, Minimum
from contourlab.rendering.charts import Multiples, traces_chart
from contourlab.rendering.data import ReportData
from contourlab.rendering.matplotlib_view import draw_chart, drawing
from contourlab.rendering.plots import write_charts
from contourlab.rendering.run_pictures import polar_charts
from contourlab.study import DesignVariable

X = np.geomspace(1.0, 4.0, 9)
Y = np.where(X > 3.0, np.nan, 1.0 + (X - 2.0) ** 2)
NUMBER = DesignVariable("controller.axes.x.controller.gain", 2.5, 1.0, 4.0, "1/s", "1/s")
CURVE = curve_tile(Curve(NUMBER, X, 1e-6 * Y, Minimum(2.0, 1e-6, 0.1, ""), None, (Interval(3.1, 4.0, False, True),)), 1e6)
NAMES = ("a", "b_", "$c")


def test_small_multiples_share_one_scale_and_shade_failures() -> None:
    figure = drawing(Multiples("curves", "curves", "", "error [um]", (CURVE,) * 4))
    places = [place for place in figure.axes if place.get_visible()]
    assert len(places) == 4 and len({place.get_ylim() for place in places}) == 1
    assert places[0].get_xscale() == "log" and places[0].get_yscale() == "log"
    shaded = places[0].patches[0].get_extents().transformed(places[0].transData.inverted())  # type: ignore[attr-defined]
    assert (shaded.x0, shaded.x1) == (pytest.approx(3.1), pytest.approx(4.0))
    assert {text.get_text() for text in figure.legends[0].get_texts()} >= {"runs fail", "minimum", "present value"}


def test_bars_are_in_the_order_of_the_last_series_with_their_intervals() -> None:
    first, total, half = np.array([0.1, 0.2, 0.0]), np.array([0.3, 0.9, 0.5]), np.array([0.01, 0.02, 0.03])
    figure = drawing(indices_chart("sobol", "indices", "share", NAMES, [("first", first, half), ("total", total, half)]))
    place = figure.axes[0]
    assert [text.get_text() for text in place.get_yticklabels()] == ["b_", "\\$c", "a"]
    assert [bar.get_width() for bar in place.patches] == [0.2, 0.0, 0.1, 0.9, 0.5, 0.3]  # type: ignore[attr-defined]


def test_a_matrix_leaves_its_diagonal_and_unknown_values_blank() -> None:
    values = np.array([[9.0, 2.0, np.nan], [2.0, 9.0, -1.0], [np.nan, -1.0, 9.0]])
    sure = np.zeros((3, 3), dtype=bool)
    figure = drawing(interactions_chart("interactions", NAMES, values, sure))
    texts = sorted(text.get_text() for text in figure.axes[0].texts)
    assert texts == ["-1", "-1", "2", "2"] and values[0, 0] == 9.0
    assert drawing(interactions_chart("nothing", NAMES, np.full((3, 3), np.nan), sure)).axes
    chart = interactions_chart("interactions", NAMES, values, np.abs(values) == 1.0)
    assert sorted(text.get_text() for text in drawing(chart).axes[0].texts) == ["-1?", "-1?", "2", "2"]
    assert "?" in chart.label


def test_every_kind_of_chart_can_be_drawn_on_given_axes(circle: ReportData) -> None:
    from matplotlib.figure import Figure

    sure = np.zeros((3, 3), dtype=bool)
    bars = indices_chart("sobol", "indices", "share", NAMES, [("first", np.ones(3), np.zeros(3)), ("total", np.ones(3), np.zeros(3))])
    tiles = Multiples("curves", "curves", "", "error [um]", (CURVE,) * 4)
    charts = [bars, interactions_chart("interactions", NAMES, np.ones((3, 3)), sure), *polar_charts(circle, 100), tiles]
    figure = Figure()
    plain, matrix, ring, free = *figure.subplots(1, 3), figure.add_axes((0.1, 0.1, 0.3, 0.2))
    assert draw_chart(charts, "", plain) is plain and len(plain.patches) == 6
    assert draw_chart(charts, "interactions", matrix) is matrix and len(matrix.images) == 1
    polar = draw_chart(charts, "circle-0", ring)
    assert polar.name == "polar" and ring not in figure.axes and polar.get_subplotspec() == ring.get_subplotspec()
    assert draw_chart(charts, "circle-0", polar) is polar
    others = len(figure.axes)
    first = draw_chart(charts, "curves", free)
    assert first.get_ylabel() == "error [um]" and free not in figure.axes and len(figure.axes) == others - 1 + 6
    assert first.get_position().x0 == pytest.approx(0.1) and first.get_position().y1 == pytest.approx(0.3)


def test_a_span_of_x_is_shaded_and_named_in_print() -> None:
    trace = {"error": (np.linspace(0.0, 4.0, 9), np.linspace(-1.0, 1.0, 9))}
    chart = traces_chart("t", "t", ("time [s]", "error [um]"), trace, span=(1.0, 2.0), span_label="fitted")
    place = drawing(chart).axes[0]
    shaded = place.patches[0].get_extents().transformed(place.transData.inverted())  # type: ignore[attr-defined]
    assert (shaded.x0, shaded.x1) == (pytest.approx(1.0), pytest.approx(2.0)) and place.get_xlim() == (0.0, 4.0)
    assert "fitted" in {text.get_text() for text in place.texts}


def test_each_chart_becomes_a_file(tmp_path: Path) -> None:
    charts = [Multiples("curves", "t", "", "y", (CURVE,)), interactions_chart("t", NAMES, np.eye(3), np.eye(3) > 2.0)]
    assert [file.name for file in write_charts(charts, tmp_path, ("png", "svg"))] == [
        "curves.png",
        "curves.svg",
        "interactions.png",
        "interactions.svg",
    ]
