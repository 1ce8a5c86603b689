"""The comparison is the same on a terminal, in a pipe and in Markdown."""

from __future__ import annotations

from dataclasses import replace

import pytest
import synthetic

from contourlab.feed import AxisLimits, plan, route_from_path
from contourlab.feed.reference import Judged
from contourlab.geometry import Line, Path
from contourlab.rendering.comparison import compare, comparison_text
from contourlab.result import Status


def cells(data, label):
    return next(row for row in compare(data).rows if row.label == label)


def test_figures_are_the_metrics_in_print_units(circle):
    row = cells(circle, "contour error, largest")
    assert row.unit == "um" and row.strong
    for cell, scheme in zip(row.cells, circle.schemes, strict=True):
        assert float(cell.text) == pytest.approx(scheme.metrics.contour_error.max * 1e6, rel=6e-3)
    feed = cells(circle, "feedrate, mean")
    assert feed.unit == "mm/min" and float(feed.cells[0].text) == pytest.approx(3770, rel=1e-3)


def test_change_compares_the_last_with_the_first(circle):
    row = cells(circle, "contour error, rms")
    assert row.change.text == "-75 %" and row.change.mood == "good"


def test_pass_and_fail_are_written_as_words(circle):
    row = cells(circle, "tolerance 5 um")
    assert [cell.text for cell in row.cells] == ["fail", "pass"]


def test_without_a_verdict_the_largest_part_error_decides(circle):
    bare = tuple(replace(scheme, verdict=None) for scheme in circle.schemes)
    largest = circle.schemes[0].metrics.part_error.max
    row = cells(replace(circle, schemes=bare, tolerance=largest), f"tolerance {largest * 1e6:.6g} um")
    assert [cell.mood for cell in row.cells] == ["good", "good"]
    row = next(iter(compare(replace(circle, schemes=bare, tolerance=0.999 * largest)).rows))
    assert [cell.mood for cell in row.cells] == ["poor", "good"]


def test_a_run_that_stopped_early_never_passes(circle):
    second = circle.schemes[1]
    stopped = replace(second, result=replace(second.result, status=Status(False, 9, "x", "position left its range")))
    table = compare(replace(circle, schemes=(circle.schemes[0], stopped)))
    assert table.rows[0].cells[1].mood == "poor"
    assert f"{second.name} " in table.note and "position left" in table.note


def test_an_error_in_space_has_no_signed_mean(single):
    path = Path([Line((0.0, 0.0, 0.0), (0.01, 0.02, 0.03))])
    data = synthetic.around(single, path, plan(route_from_path(path, 0.02), AxisLimits([0.1] * 3, 2.0, 50.0), 1e-3))
    labels = [row.label for row in compare(data).rows]
    assert "contour error, signed mean" not in labels and "contour error, mean" in labels


def test_without_a_tolerance_there_is_no_verdict(square):
    assert not any("tolerance" in row.label for row in compare(square).rows)


def test_the_text_is_plain_ascii_and_fits_the_page(circle):
    text = comparison_text(circle, 80)
    assert text.isascii()
    assert max(map(len, text.splitlines())) <= 80
    assert "um s" in text
    assert "-75 %" in text


def test_runs_with_different_judged_parts_name_them(circle):
    first, second = circle.schemes
    assert "2 s to 4 s." in compare(circle).note
    other = replace(second, metrics=replace(second.metrics, judged=Judged(((100, 900),), "window")))
    note = compare(replace(circle, schemes=(first, other))).note
    assert f"2 s to 4 s ({first.name})" in note
    assert f"0.1 s to 0.9 s ({second.name})" in note


def test_markup_in_names_is_printed_literally(circle):
    odd = replace(circle, schemes=(replace(circle.schemes[0], name="[bold]a|b[/bold]"),))
    assert "[bold]a|b[/bold]" in comparison_text(odd)


def test_a_measured_run_names_the_limits_of_its_encoders(circle):
    assert "encoders" not in compare(circle).note
    assert "encoders" in compare(replace(circle, is_measured=True)).note


def test_notes_are_printed_unchanged_below_the_table(circle):
    noted = replace(circle, notes=("one: two?", "three *four*"))
    assert comparison_text(noted).splitlines()[-2:] == ["one: two?", "three *four*"]
