"""Pages as their reader sees them: one file, opened by a browser without a network."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import made_circles
import numpy as np
import page_contract
import pytest
import synthetic
from browsing import OPEN, Browsing, drawn, painted
from jsonschema import Draft202012Validator
from made_studies import made_study
from messages import header_and_numbers, message_in, pictures
from reference_data import reference_file

from contourlab.cli.main import main
from contourlab.rendering.comparison import compare
from contourlab.rendering.html import VIEWER, write_html
from contourlab.result import Result


@pytest.fixture(scope="module")
def data():
    return synthetic.report()


@pytest.fixture(scope="module")
def page(data, tmp_path_factory) -> Path:
    return write_html(data, tmp_path_factory.mktemp("report") / "page.html")


def in_file(page: Path) -> dict[str, Any]:
    """Return the pictures of a page by key."""
    return pictures(message_in(page.read_text(encoding="utf-8")))


def extends(curve: dict[str, Any]) -> bool:
    """Tell whether a curve is more than a point."""
    good = np.isfinite(curve["y"])
    return bool(good.any()) and bool(np.ptp(curve["x"][good]) > 0.0 or np.ptp(curve["y"][good]) > 0.0)


def check_pictures(browsing: Browsing, page: Path, width: int = 1280) -> Any:
    """Open a page; each picture that is shown must be painted in its own colours, each panel of curves in those of its curves."""
    opened = browsing.open(page, width)
    assert opened.evaluate("document.documentElement.scrollWidth") <= width
    for key, picture in in_file(page).items():
        if opened.locator(f'[id="{key}"]').evaluate("place => place.closest('[hidden]') !== null"):
            continue
        if picture["kind"] == "Chart":
            colours = [{curve["colour"] for curve in panel["curves"] if extends(curve)} for panel in picture["panels"]]
        elif picture["kind"] in ("PolarChart", "CircleCauses"):
            colours = [{curve["colour"] for curve in picture.get("runs", picture.get("curves"))}]
        else:
            colours = [{""}]  # any
        counts = painted(opened, key, *set().union(*colours) - {""})
        assert len(counts) == len(colours), key
        assert all(count > 100 for count, wanted in zip(counts, colours, strict=True) if wanted), (key, counts)
    return opened


def test_a_page_draws_every_picture_and_shows_the_values_under_the_pointer(browsing, data, page):
    opened = check_pictures(browsing, page)
    curves = in_file(page)["error-time"]["panels"][0]["curves"]
    frame = drawn(opened, "error-time").locator(".u-over")
    box = frame.bounding_box()
    frame.hover(position={"x": 0.37 * box["width"], "y": 20})
    shown = opened.locator("#error-time .cl-tip div").all_inner_texts()
    time_shown = float(shown[0].split()[0])
    assert len(shown) == 3
    for curve, line in zip(curves, shown[1:], strict=True):
        nearest = int(np.argmin(np.abs(curve["x"] - time_shown)))
        assert float(line.split()[-2]) == pytest.approx(curve["y"][nearest], rel=1e-3)
        signal = next(scheme for scheme in data.schemes if scheme.name == curve["name"]).result["contour_error"]
        assert curve["y"][nearest] == pytest.approx(1e6 * signal[round(curve["x"][nearest] / 1e-3)], rel=1e-6)


def test_clicks_and_keys_lead_from_a_line_to_its_path(browsing, page):
    opened = browsing.open(page)
    (key, *_) = (key for key in in_file(page) if key.startswith("path"))
    drawn(opened, key)
    shown = f"document.querySelector('#{key} canvas').toDataURL()"
    before = opened.evaluate(shown)
    opened.locator('#lines tr[data-line="4"]').click()
    assert opened.locator("#lines .picked").get_attribute("data-line") == "4"
    assert opened.locator("#picked").inner_text().startswith("Line 4: ")
    opened.wait_for_function(f"before => {shown} !== before", arg=before)
    opened.locator("#lines .lines").focus()
    opened.keyboard.press("ArrowUp")
    assert opened.locator("#lines .picked").get_attribute("data-line") == "3"
    opened.locator("#lines th button").nth(1).click()
    rows = opened.locator("#lines tbody tr")
    errors = [float(text) for text in rows.locator("td:nth-child(3)").all_inner_texts()]
    assert errors == sorted(errors, reverse=True)
    opened.locator("a[data-pick]").first.click()
    assert opened.locator("#lines .picked").get_attribute("data-line") == opened.locator("a[data-pick]").first.get_attribute("data-pick")


@pytest.mark.slow
def test_panels_zoom_together_and_the_legend_hides_a_curve(browsing, page):
    opened = browsing.open(page)
    place = drawn(opened, "axis-0")
    frames = place.locator(".u-over")
    frames.first.hover(position={"x": 200, "y": 30})
    assert place.locator(".cl-tip:not([hidden])").count() == frames.count() > 1
    whole = place.locator(".cl-tip").last.inner_text()
    opened.mouse.down()
    opened.mouse.move(frames.first.bounding_box()["x"] + 300, frames.first.bounding_box()["y"] + 30)
    opened.mouse.up()
    frames.first.hover(position={"x": 200, "y": 30})
    assert place.locator(".cl-tip").last.inner_text() != whole  # another time is below the pointer
    button = place.locator(".cl-legend button").first
    name, lines = button.inner_text().strip(), place.locator(".cl-tip").first.inner_text()
    button.click()
    frames.first.hover(position={"x": 201, "y": 30})
    assert name in lines and name not in place.locator(".cl-tip").first.inner_text()
    assert button.get_attribute("aria-pressed") == "false"


@pytest.mark.slow
def test_ticks_have_their_digits_in_every_language(browsing, page):
    opened = browsing.open(page)
    opened.add_init_script(
        "Object.defineProperty(navigator, 'language', {value: 'de'}); const pen = CanvasRenderingContext2D.prototype, own = pen.fillText;"
        "globalThis.texts = []; pen.fillText = function (text, ...at) { texts.push(text); return own.call(this, text, ...at); };"
    )
    opened.reload()
    opened.evaluate(OPEN)
    drawn(opened, "error-time").focus()
    for _ in range(12):
        opened.keyboard.press("+")
    opened.evaluate("texts.length = 0")
    opened.keyboard.press("+")
    opened.wait_for_function("texts.includes('time [s]')")
    texts = opened.evaluate("texts")
    times = [float(text) for text in texts if text not in ("time [s]", *"▲◆●▼")]
    times = times[: int(np.argmax(np.diff(times) < 0.0)) + 1]  # those of the y axis follow
    assert len(times) > 3 and np.ptp(times) < 1e-2
    np.testing.assert_allclose(np.diff(times), times[1] - times[0], rtol=1e-6)


@pytest.mark.slow
def test_paper_is_light_and_has_every_picture(browsing, page):
    opened = browsing.open(page, height=100, dark=True)  # so low that nothing is drawn yet
    opened.wait_for_selector("#cl-style", state="attached")  # the viewer has begun
    assert opened.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(20, 25, 30)"
    opened.evaluate(OPEN.replace("true", "false"))
    opened.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert opened.evaluate("getComputedStyle(document.querySelector('.plot')).backgroundColor") == "rgb(255, 255, 255)"
    path = "getComputedStyle(document.querySelector('.cl-path')).getPropertyValue('--p-path')"
    assert opened.evaluate(path) == "#7d8791"
    assert opened.locator(".plot:not([data-drawn])").count() == 0
    assert "" not in opened.locator(".path-stage").evaluate_all("all => all.map(stage => stage.style.width)")  # sized for paper
    assert opened.pdf(format="A4").startswith(b"%PDF")
    opened.evaluate("dispatchEvent(new Event('afterprint'))")
    assert opened.locator("details.fold[open]").count() == 0 and opened.evaluate(path) == "#8d98a4"
    opened.evaluate(OPEN)
    assert drawn(opened, "axis-0").locator("canvas").first.evaluate("canvas => canvas.clientWidth") > 640


@pytest.mark.slow
@pytest.mark.parametrize("width", [1280, 400])
def test_the_page_of_the_demonstration_part_is_small_and_whole(browsing, tmp_path, monkeypatch, width):
    monkeypatch.chdir(tmp_path)
    assert main(["run", "builtin:demo-part", "--out", "out"]) in (0, 1)
    page = tmp_path / "out" / "report.html"
    assert page.stat().st_size < 1.2e6
    check_pictures(browsing, page, width)


@pytest.mark.slow
def test_the_sliders_of_a_circle_take_its_causes_away(browsing, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    made_circles.write_log(tmp_path / "log.csv", x=8e-6)
    assert main(["circle", "log.csv"]) == 0
    opened = check_pictures(browsing, tmp_path / "results" / "report.html")
    output = opened.locator("#causes output").first
    measured = float(output.inner_text().split()[0])
    opened.locator(".cl-slider", has_text="backlash x").locator("input").fill("0")
    test = in_file(tmp_path / "results" / "report.html")["causes"]
    angle = np.radians(np.concatenate([run["angle"] for run in test["runs"]]))
    left = np.concatenate([run["deviation"] - run["curves"][test["causes"].index("backlash x")] for run in test["runs"]])
    design = np.column_stack([np.ones(angle.size), np.cos(angle), np.sin(angle)])
    left -= design @ np.linalg.lstsq(design, left, rcond=None)[0]
    shown = float(output.inner_text().split()[0])
    assert shown == pytest.approx(np.ptp(left), rel=5e-3) and shown < 0.6 * measured
    opened.get_by_text("As measured", exact=True).click()
    assert float(output.inner_text().split()[0]) == measured


SHOW = """async () => {
  const data = Uint8Array.from(atob(document.getElementById('message').textContent), c => c.charCodeAt(0));
  const root = document.createElement('div');
  root.id = 'notebook';
  document.body.replaceChildren(root);
  globalThis.end = contourlab.show(root, await contourlab.unpacked(data));
}"""


@pytest.mark.slow
def test_the_viewer_draws_a_message_in_any_element(browsing, page):
    opened = browsing.open(page)
    opened.locator(".plot[data-drawn]").first.wait_for()
    opened.evaluate(SHOW)
    assert opened.locator("#notebook .plot").count() == len(in_file(page))
    titles = opened.locator("#notebook summary")
    assert titles.all_inner_texts() == [picture["title"] for picture in in_file(page).values()]
    assert opened.locator("#notebook details[open]").count() == 2
    titles.last.click()
    opened.locator("#notebook .plot").last.scroll_into_view_if_needed()
    opened.locator("#notebook .plot[data-drawn] canvas").last.wait_for()
    opened.evaluate("end()")
    assert opened.locator("#notebook *").count() == 0


MODULES = """
scenario = "scenario.toml"
chunk = 64
figures = ["part_error_max", "cycle_time", "command_energy"]
[vary]
"axes.*.friction.coulomb" = { uniform = ["70 %", "130 %"] }
"axes.*.plant.gain" = { uniform = ["90 %", "110 %"] }
scheme = { values = ["position loop", "all of it"] }
[modules]
axes.1 = 12
axes.3 = 10
"""


@pytest.mark.slow
def test_the_page_of_a_sweep_shows_distribution_compromises_and_pairings(browsing, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    made_study(tmp_path, MODULES)
    assert main(["sweep", "study.toml", "--out", "store"]) == 0 and main(["sweep", "report", "store"]) == 0
    page = tmp_path / "store" / "report.html"
    drawings = in_file(page)
    assert sum(picture["kind"] == "Heat" for picture in drawings.values()) == 3 and "distribution" in drawings
    opened = check_pictures(browsing, page)
    (key, grid), *_ = ((key, picture) for key, picture in drawings.items() if picture["kind"] == "Heat")
    box = drawn(opened, key).locator("canvas").bounding_box()
    opened.mouse.move(box["x"] + 0.4 * box["width"], box["y"] + 0.4 * box["height"])
    column, row, value = (line.split() for line in opened.locator(f'[id="{key}"] .cl-tip div').all_inner_texts())
    cell = grid["values"][grid["y_names"].index(row[-1]), grid["x_names"].index(column[-1])]
    assert float(value[0]) == pytest.approx(cell, rel=1e-3)


@pytest.mark.slow
def test_the_page_of_a_measured_log(browsing, tmp_path, monkeypatch):
    log = reference_file("data/ubc-xy-table/line_circle_lli.mat")
    monkeypatch.chdir(tmp_path)
    assert main(["measure", str(log), "--out", "out"]) in (0, 1)
    check_pictures(browsing, tmp_path / "out" / "report.html", 400)


def test_the_message_keeps_its_contract(page):
    header, numbers = header_and_numbers(message_in(page.read_text(encoding="utf-8")))
    assert list(Draft202012Validator(page_contract.contract()).iter_errors(header)) == []
    assert {picture["kind"] for picture in header["pictures"]} >= {"Chart", "PolarChart"} and len(numbers) > 1000
    for file, text in page_contract.texts().items():
        assert file.read_text(encoding="utf-8") == text, f"{file}: run tools/page_contract.py"
    assert VIEWER.with_name("LICENSES").read_text(encoding="utf-8").count("MIT License") >= 1


def test_a_result_saved_and_loaded_gives_the_same_page(data, page, tmp_path):
    from dataclasses import replace

    schemes = []
    for index, scheme in enumerate(data.schemes):
        scheme.result.save(tmp_path / f"{index}.nc")
        schemes.append(replace(scheme, result=Result.load(tmp_path / f"{index}.nc")))
    again = write_html(replace(data, schemes=tuple(schemes)), tmp_path / "again.html")
    assert again.read_bytes() == page.read_bytes()


@pytest.mark.slow
def test_the_report_of_a_minute_at_ten_kilohertz_is_quick_and_small(tmp_path):
    data = synthetic.report((8e-6, 4e-6, 2e-6), laps=30, servo_period=1e-4)
    assert data.schemes[0].result.n_sample >= 600_000
    start = time.perf_counter()
    file = write_html(data, tmp_path / "long.html")
    assert time.perf_counter() - start < 3.0
    assert file.stat().st_size < 1.5e6


def test_the_page_and_the_table_show_the_same_figures(data, page):
    text = page.read_text(encoding="utf-8")
    for row in compare(data).rows[:12]:
        for cell in (row.label, row.unit, *(cell.text for cell in row.cells)):
            assert f">{cell}<" in text or cell in ("", "-"), cell
