"""One page on results made in Python."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from messages import message_in, pictures
from refusals import refuses

import contourlab as cl
from contourlab.errors import OutputError, ParameterError, ResultError


@pytest.fixture(scope="module")
def run():
    case = cl.load_scenario("builtin:ghaffari/demo-stage").base
    reference = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
    return case, reference, cl.simulate(case.machine, case.controller, reference)


def headings(page: str) -> list[str]:
    return re.findall(r"<h3><span[^>]*></span>([^:]+): (within|out of)", page)


def test_a_result_is_judged_and_reported_in_one_line(run, tmp_path):
    file = cl.report(run[2], tmp_path / "page.html")
    page = file.read_text(encoding="utf-8")
    assert file == tmp_path / "page.html"
    largest = np.abs(cl.judge(run[2], run[1])["part_error"]).max()
    assert f"{1e6 * largest:.3g}" in page
    assert 'id="verdict"' not in page
    assert any(key.startswith("path") for key in pictures(message_in(page)))
    assert not list(tmp_path.glob("*tmp*")) and len(list(tmp_path.iterdir())) == 1


def test_a_pdf_is_one_page(run, tmp_path):
    page = cl.report(run[2], tmp_path / "page.pdf", tolerance=1e-3).read_bytes()
    assert page.startswith(b"%PDF-") and page.count(b"/Type /Page ") == 1


def test_runs_are_compared_and_a_tolerance_gives_verdicts(run, tmp_path):
    case, reference, first = run
    largest = float(np.abs(cl.judge(first, reference)["part_error"]).max())
    softer = replace(case.machine, axes=tuple(replace(axis, plant=axis.plant.replace(gain=0.9)) for axis in case.machine.axes))
    second = cl.judge(cl.simulate(softer, case.controller, reference, scheme="90 % gain"), reference)
    assert np.abs(second["part_error"]).max() != largest
    between = 0.5 * (largest + float(np.abs(second["part_error"]).max()))
    page = cl.report([first, second], tmp_path / "page.html", tolerance=between).read_text(encoding="utf-8")
    assert sorted(word for _, word in headings(page)) == ["out of", "within"]
    assert [name for name, _ in headings(page)] == ["base", "90 % gain"]


def test_equal_names_are_numbered_and_a_mapping_names(run, tmp_path):
    result, tolerance = run[2], 1e-3
    page = cl.report([result, result], tmp_path / "page.html", tolerance=tolerance).read_text(encoding="utf-8")
    assert [name for name, _ in headings(page)] == ["base", "base 2"]
    page = cl.report({"before": result, "after": result}, tmp_path / "page.html", tolerance=tolerance).read_text(encoding="utf-8")
    assert [name for name, _ in headings(page)] == ["before", "after"]


def test_a_program_shows_the_error_of_its_lines(run, tmp_path):
    case = run[0]
    program = cl.parse_program("G21 G90 G17\nG1 X5 F600\nG1 Y5\nM2")
    limits = cl.AxisLimits([0.5, 0.5], [2.0, 2.0], [100.0, 100.0])
    reference = cl.plan(cl.route_from_program(program, ("x", "y")), limits, case.machine.servo_period)
    result = cl.simulate(case.machine, case.controller, reference)
    page = cl.report(result, tmp_path / "page.html", program=program).read_text(encoding="utf-8")
    assert re.findall(r'<tr data-line="(\d)">', page) == ["2", "3"]


def test_a_loaded_result_needs_its_reference(run, tmp_path):
    _, reference, result = run
    result.save(tmp_path / "run.nc")
    loaded = cl.Result.load(tmp_path / "run.nc")
    with refuses(ParameterError, name="reference"):
        cl.report(loaded, tmp_path / "page.html")
    assert cl.report(loaded, tmp_path / "page.html", reference=reference).exists()
    assert cl.report([loaded, loaded], tmp_path / "page.html", reference=[reference, reference]).exists()


def test_what_cannot_be_reported_is_refused_and_nothing_is_written(run, tmp_path):
    case, reference, result = run
    file = tmp_path / "page.html"
    other = cl.uniform(cl.contour("circle", radius=4e-3), 1.0, 1, case.machine.servo_period)
    smaller = cl.simulate(case.machine, case.controller, other)
    with refuses(ParameterError, name="path of 'base 2'"):
        cl.report([result, smaller], file)
    with refuses(ParameterError, name="reference"):
        cl.report([result, result], file, reference=[reference])
    for nothing in ([], {}, ["run.nc"]):
        with refuses(ParameterError, name="results"):
            cl.report(nothing, file)
    for tolerance in (0.0, -1e-6, float("nan"), float("inf")):
        with refuses(ParameterError, name="tolerance"):
            cl.report(result, file, tolerance=tolerance)
    with pytest.raises(ResultError):
        cl.report(smaller, file, reference=reference)
    with pytest.raises(ResultError):
        cl.report(cl.simulate(case.machine, case.controller, reference, signals=["command"]), file)
    assert not file.exists()
    file.write_text("mine", encoding="utf-8")
    with pytest.raises(OutputError):
        cl.report(result, file / "below.html")
    assert file.read_text(encoding="utf-8") == "mine"
