"""Sliders of a report: the reader drags a gain, and the page runs the loop again."""

from __future__ import annotations

import json
import re
import shlex
import tomllib
from pathlib import Path
from typing import Any

import pytest
from browsing import drawn, painted

import contourlab as cl
from contourlab.cli.main import main

BOUND = 0.25
"""Half an encoder count of the machine [um]: where a last digit decides between two counts, figures differ by a part of one."""
PROGRAM = "G21 G90 G94 G17 G64 P0.002\nG0 X10 Y0\nG1 X14 F1200\nG3 X14 Y8 I0 J4\nG1 X5\nY2\nX8\nM2\n"
OPTIONS = ("--machine", "xyz", "--tolerance", "15 um", "--no-interval")
STANDS = """name = "stands"
machine = "builtin:xyz"
controller = "builtin:xyz-controller"
program = "part.ngc"
run.tolerance = "15 um"
[schemes.loop]
controller.axes."*".controller.gains = {natural_frequency = "120 rad/s", damping = 0.8, pole = "120 rad/s"}
controller.axes."*".observer = "none"
controller.estimator = "none"
controller.coupling = "none"
"""
BANDWIDTH, GAIN = "observer bandwidth", "controller position gain"
NOW = "#d55e00"
DRAG = "(slider, value) => { slider.value = value; ['input', 'change'].forEach(kind => slider.dispatchEvent(new Event(kind))); }"
WATCH = """() => { window.told = []; const said = document.querySelector(".live-said");
  new MutationObserver(() => told.push(said.textContent)).observe(said, {childList: true}); }"""


@pytest.fixture(scope="module")
def part(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("part")
    (folder / "part.ngc").write_text(PROGRAM)
    return folder / "part.ngc"


@pytest.fixture(scope="module")
def report(part) -> Path:
    assert main(["run", str(part), *OPTIONS, "--controller", "xyz-controller", "--out", str(part.parent / "out")]) in (
        0,
        1,
    )
    return part.parent / "out" / "report.html"


@pytest.fixture
def page(browsing, report) -> Any:
    opened = browsing.open(report)
    drawn(opened, "path-space")
    drawn(opened, "live").hover()
    opened.locator("#live tbody").wait_for()
    return opened


def drag(page: Any, name: str, value: float) -> None:
    """Drag a slider to a power of ten of the report's value, and wait for the pictures."""
    page.get_by_role("slider", name=name, exact=True).evaluate(DRAG, value)
    rests(page)


def save(page: Any, folder: Path) -> Path:
    """Save the controller file."""
    with page.expect_download() as saved:
        page.get_by_role("button", name="Save as controller file").click()
    saved.value.save_as(folder / saved.value.suggested_filename)
    return folder / saved.value.suggested_filename


def rests(page: Any, shows: str = "whole") -> str:
    """Wait until the panel shows something for the values that it has, and return what it says."""
    page.locator(f'#live[data-shows="{shows}"]').wait_for()
    said: str = page.locator(".live-said").inner_text()
    return said


def figures(page: Any, column: str) -> dict[str, str]:
    """Return a column of the table."""
    heads = page.locator("#live thead th").all_inner_texts()
    rows = page.locator("#live tbody tr").all()
    return {row.locator("th").inner_text(): row.locator("td").nth(heads.index(column) - 1).inner_text() for row in rows}


def largest(page: Any, column: str) -> float:
    return float(figures(page, column)["largest part error [um]"])


def test_a_gain_is_dragged(page, part):
    """Path, curves and figures follow; the figures are those of a machine with the gain; one step back they are the first ones again."""
    base, before = figures(page, "report"), painted(page, "path-space", NOW)
    page.evaluate(WATCH)
    drag(page, BANDWIDTH, -0.4)
    assert [text.split()[0] for text in page.evaluate("told")] == ["Short", "Whole"]
    value = float(re.search(r"x.observer.bandwidth=(\S+) rad/s", page.locator("#live code").inner_text())[1])
    assert value == pytest.approx(300.0 * 10**-0.4, rel=1e-2)
    case = cl.run(part, machine="xyz", controller="xyz-controller", interval=False).outcomes[0].case
    names = [f"controller.axes.{axis}.observer.bandwidth" for axis in "xyz"]
    batch = cl.simulate_batch(case.machine, case.controller, case.reference(), {name: [value] for name in names}, part=True)
    assert largest(page, "now") == pytest.approx(1e6 * batch.figures["part_error_max"][0], abs=BOUND)
    assert largest(page, "report") + 4.0 * BOUND < largest(page, "now")
    assert figures(page, "now")["tolerance 15 um"] == "FAIL"
    assert before == [0] and painted(page, "path-space", NOW)[0] > 100 and painted(page, "live", NOW)[0] > 100
    drag(page, BANDWIDTH, -0.5)
    assert largest(page, "before") == pytest.approx(1e6 * batch.figures["part_error_max"][0], abs=BOUND)
    for _ in range(2):
        page.get_by_role("slider", name=BANDWIDTH).press("Control+z")
        rests(page)
    assert figures(page, "now") == base == figures(page, "report")
    assert page.get_by_role("button", name="Undo").is_disabled()
    page.get_by_role("button", name="Redo").click()
    rests(page)
    assert largest(page, "now") == pytest.approx(1e6 * batch.figures["part_error_max"][0], abs=BOUND)


def test_where_the_path_turns_back_the_judge_of_the_report_decides(browsing, tmp_path):
    """At a turn the judge of the module doubts which branch is meant; the nearest one lies beyond the window of the exact judge."""
    (tmp_path / "part.ngc").write_text(
        "G21 G90 G94 G17 G61\nG0 X10 Y0\nG1 X30 F4000\nX10 Y0.004\nX30 Y0.008\nX10 Y0.1\nX30 Y2\nX10 Y0.2\nM2\n"
    )
    runs = cl.run(tmp_path / "part.ngc", machine="xyz", controller="xyz-controller", interval=False)
    runs.save(tmp_path / "out")
    page = browsing.open(tmp_path / "out" / "report.html")
    drawn(page, "live").hover()
    page.locator("#live tbody").wait_for()
    exact = runs.outcomes[0].metrics.part_error
    assert largest(page, "report") == pytest.approx(1e6 * exact.max, abs=BOUND)
    assert float(figures(page, "report")["part error, rms [um]"]) == pytest.approx(1e6 * exact.rms, abs=4e-3)


def test_a_movement_of_the_hand_is_one_step(page):
    slider = page.get_by_role("slider", name=GAIN)
    slider.scroll_into_view_if_needed()
    box, found = slider.bounding_box(), []
    page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    page.mouse.down()
    for share in (0.55, 0.6):
        page.mouse.move(box["x"] + share * box["width"], box["y"] + 0.5 * box["height"])
        rests(page)
        found.append(largest(page, "now"))
    page.mouse.up()
    slider.press("ArrowRight")
    rests(page)
    assert len({largest(page, "report"), *found, largest(page, "now")}) == 4 and largest(page, "before") == found[1]
    for wanted in (found[1], largest(page, "report")):
        page.get_by_role("button", name="Undo").click()
        rests(page)
        assert largest(page, "now") == wanted


def test_what_was_found_leaves_the_page(page, part, tmp_path):
    """The command line names the values; the file of the controller has them, and a run with it has the figures of the page."""
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.get_by_label(f"Axes of {BANDWIDTH}").select_option("x")
    drag(page, BANDWIDTH, -0.3)
    command = page.locator("#live code").inner_text()
    assert command.endswith('--set "controller.axes.x.observer.bandwidth=150 rad/s"') and command.startswith(f"contourlab run {part}")
    page.get_by_role("button", name="Copy the command line").click()
    page.get_by_role("button", name="Copied").wait_for()
    assert page.evaluate("navigator.clipboard.readText()") == command
    file = save(page, tmp_path)
    out = tmp_path / "out"
    assert main(["run", str(part), *OPTIONS, "--controller", str(file), "--out", str(out)]) in (0, 1)
    verdict = json.loads((out / "summary.json").read_text())["schemes"]["base"]["verdict"]
    assert largest(page, "now") == pytest.approx(verdict["worst"]["value"] * 1e6, abs=BOUND)
    slower = shlex.split(page.locator("#plan code").inner_text())
    assert main([*slower[1:], "--out", str(out)]) in (0, 1)
    planned = json.loads((out / "summary.json").read_text())["schemes"]["base"]["n_sample"]
    assert planned > 1.1 * cl.run(part, machine="xyz", controller="xyz-controller", interval=False).outcomes[0].result.n_sample
    page.get_by_label(f"Axes of {GAIN}").select_option("x")
    drag(page, GAIN, 0.1)
    axes = tomllib.loads(save(page, tmp_path).read_text())["controller"]["axes"]
    gains = [axes[axis]["controller"]["position_gain"] for axis in "xy"]
    assert isinstance(gains[0], str) and gains[1]["source"] == "design"  # where a value came from does not hold for another one


def test_a_short_run_knows_where_an_axis_stands(browsing, tmp_path):
    """Y stands for a second before it reverses: with another gain it stands elsewhere."""
    (tmp_path / "part.ngc").write_text("G21 G90 G94 G17 G61\nG0 X0 Y0\nG1 X25 F1500\nX0\nY10\nX40\nG2 X45 Y5 I0 J-5\nG1 Y0\nM2\n")
    (tmp_path / "stands.toml").write_text(STANDS)
    assert main(["run", str(tmp_path / "stands.toml"), "--no-interval", "--out", str(tmp_path / "out")]) == 1
    page = browsing.open(tmp_path / "out" / "report.html")
    drawn(page, "live").hover()
    page.locator("#live tbody").wait_for()
    page.evaluate(WATCH)
    drag(page, GAIN, 0.05)
    begun, short, base = map(
        float, re.search(r"at (\S+) s: largest part error (\S+) um, with the report's values (\S+) um", page.evaluate("told")[0]).groups()
    )
    assert begun > 1.0 and largest(page, "now") + 2.0 < base == largest(page, "report")
    assert short == pytest.approx(largest(page, "now"), abs=BOUND)


def test_values_that_are_not_possible(page):
    """A value beyond its bounds is named, a loop that runs away says so; figures and curves stay, and one step back holds again."""
    drag(page, GAIN, 0.1)
    kept = figures(page, "now")
    field = page.get_by_label(f"{BANDWIDTH}, value")
    field.fill("-5")
    field.press("Enter")
    assert "observer bandwidth of x = -5 rad/s must be more than 0 rad/s" in rests(page, "none")
    assert figures(page, "now") == kept
    page.get_by_role("button", name="Undo").click()
    rests(page)
    assert figures(page, "now") == kept and field.input_value() == "300"
    field = page.get_by_label("friction coulomb, value")
    field.fill("1000")
    field.press("Enter")
    assert "an axis leaves its limit of following error" in rests(page, "none")
    assert figures(page, "now") == kept


def test_more_parameters_and_another_axis(page):
    page.get_by_label("More parameters").select_option(label="plant mass")
    field = page.get_by_label("plant mass, value")
    page.get_by_label("Axes of plant mass").select_option("y")
    mass = float(field.input_value())
    field.fill(str(2.0 * mass))
    field.press("Enter")
    rests(page)
    assert f'--set "axes.y.plant.mass={2.0 * mass:g} kg"' in page.locator("#live code").inner_text()
    assert "lacks the values of the machine" in page.locator("#live").inner_text()
    assert largest(page, "now") != largest(page, "report")


def test_a_stepper_has_sliders(browsing, tmp_path):
    """It has no gains and no friction; its planner has no jerk limit, and then makes more spans along an arc than there are samples."""
    settings = [f"$10{i}={steps}\n$11{i}=5000\n$12{i}=250\n$13{i}=400\n" for i, steps in enumerate((250, 250, 400))]
    (tmp_path / "grbl.txt").write_text("$0=10\n" + "".join(settings))
    part, machine, out = tmp_path / "part.ngc", tmp_path / "grbl.txt", tmp_path / "out"
    part.write_text(PROGRAM.replace("G64 P0.002", ""))
    assert main(["run", str(part), "--machine", str(machine), "--no-interval", "--out", str(out)]) == 0
    page = browsing.open(out / "report.html")
    drawn(page, "live").hover()
    page.locator("#live tbody").wait_for()
    drag(page, "plant natural frequency", -0.5)
    assert largest(page, "now") != largest(page, "report")


@pytest.mark.parametrize("lacks", ["WebAssembly", "Worker"])
def test_a_page_without_sliders_is_a_page(browsing, report, lacks):
    opened = browsing.open(report, 400, first=f"delete globalThis.{lacks};")
    assert "need WebAssembly" in drawn(opened, "live").inner_text()
    assert opened.locator("#live input").count() == 0
    assert sum(painted(opened, "path-space")) > 100
    assert opened.evaluate("document.documentElement.scrollWidth") == 400
