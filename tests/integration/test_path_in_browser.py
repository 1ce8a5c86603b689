"""The path in space as its reader sees it: the picture alone, in a real browser without a graphics card."""

from __future__ import annotations

import base64
import json
import math
import re
import subprocess
from dataclasses import fields, is_dataclass, replace
from itertools import pairwise
from pathlib import Path as File
from typing import Any

import numpy as np
import pytest
import synthetic

import contourlab as cl
from contourlab.feed import uniform
from contourlab.geometry import Line, Path
from contourlab.metrics.figures import summarise
from contourlab.rendering.data import JudgedRun, Provenance, ReportData
from contourlab.rendering.path_picture import path_scene

SOURCES = File(__file__).parents[2] / "page"
ESBUILD = SOURCES / "node_modules" / ".bin" / "esbuild"
pytestmark = pytest.mark.slow

PAGE = """<!doctype html><meta charset="utf-8"><div id="host"></div><script>{spy}</script><script>{bundle}</script><script>
const numbers = ({{dtype, shape, data}}) => {{
  const buffer = Uint8Array.from(atob(data), c => c.charCodeAt(0)).buffer;
  return {{shape, values: dtype === "i4" ? new Int32Array(buffer) : new Float32Array(buffer)}};
}};
const filled = value => Array.isArray(value) ? value.map(filled) : !value || typeof value !== "object" ? value
  : value.dtype ? numbers(value) : Object.fromEntries(Object.entries(value).map(([key, item]) => [key, filled(item)]));
const picks = [], scene = filled({scene});
const drawing = picture.drawPath(document.getElementById("host"), scene, {{pick: line => picks.push(line)}});
</script>"""
SPY = """
const spy = {buffers: 0, draws: 0, uniforms: []}, names = new Map(), gl = WebGL2RenderingContext.prototype, wrap = (name, note) => {
  const own = gl[name];
  gl[name] = function (...values) { const made = own.apply(this, values); note(made, ...values); return made; };
};
for (const name of ["bufferData", "bufferSubData"]) wrap(name, () => { spy.buffers += 1; });
wrap("drawElementsInstanced", () => { spy.draws += 1; });
wrap("getUniformLocation", (place, program, name) => names.set(place, name));
const plain = values => JSON.stringify(values.map(one => one?.length ? [...one] : one));
for (const name of Object.getOwnPropertyNames(gl).filter(one => /^uniform(\\d|Matrix)/.test(one)))
  wrap(name, (_, place, ...values) => spy.uniforms.push(names.get(place) + plain(values)));
"""
FAST = "const ask = gl.getExtension; gl.getExtension = function (name) { return name.includes('debug') ? null : ask.call(this, name); };"
"""Hides that the processor draws: lines then have the same width in every frame."""
PIXELS = """colour => { const shown = document.querySelector("canvas"), flat = document.createElement("canvas"), found = [];
  [flat.width, flat.height] = [shown.width, shown.height];
  const pen = flat.getContext("2d"); pen.drawImage(shown, 0, 0);
  const data = pen.getImageData(0, 0, flat.width, flat.height).data;
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] && (!colour || colour.every((part, k) => Math.abs(part - data[i + k]) < 3)))
    found.push([(i / 4) % flat.width - flat.width / 2, flat.height / 2 - Math.floor(i / 4 / flat.width)]);
  return found; }"""
FRAME = "() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
MAGNIFY = (
    "value => { const slider = document.querySelector('[type=range]'); slider.value = value; slider.dispatchEvent(new Event('input')); }"
)
TAKE = "() => { const taken = {...spy}; Object.assign(spy, {buffers: 0, draws: 0, uniforms: []}); return taken; }"
PICKED, BAND = (240, 162, 2), (140, 195, 179)


def packed(value: Any) -> Any:
    """Return a picture for JSON, with its arrays in base64."""
    if isinstance(value, np.ndarray):
        dtype = "i4" if value.dtype.kind in "bi" else "f4"
        return {"dtype": dtype, "shape": value.shape, "data": base64.b64encode(value.astype(f"<{dtype}").tobytes()).decode()}
    if is_dataclass(value):
        return {field.name: packed(getattr(value, field.name)) for field in fields(value)}
    return [packed(item) for item in value] if isinstance(value, tuple) else value


@pytest.fixture(scope="module")
def bundle(tmp_path_factory) -> str:
    if not ESBUILD.exists():
        pytest.skip("no `npm ci` in page")
    target = tmp_path_factory.mktemp("bundle") / "path.js"
    options = ("--bundle", "--format=iife", "--global-name=picture", "--loader:.css=text", "--log-level=error", f"--outfile={target}")
    subprocess.run([ESBUILD, "src/path.ts", *options], cwd=SOURCES, check=True)
    return target.read_text(encoding="utf-8").replace("</script", "<\\/script")


@pytest.fixture
def opened(browsing, bundle, tmp_path):
    """Return a function that draws a report's path on a page of its own."""

    def opened(data: ReportData, spy: str = SPY):
        file = tmp_path / "page.html"
        scene = json.dumps(packed(path_scene(data, 20_000)), allow_nan=False)
        file.write_text(PAGE.format(spy=spy, bundle=bundle, scene=scene), encoding="utf-8")
        page = browsing.open(file, 1000, 800)
        page.evaluate(FRAME)
        return page

    return opened


@pytest.fixture(scope="module")
def circle() -> ReportData:
    return synthetic.report()


@pytest.fixture(scope="module")
def part() -> ReportData:
    """Return one run of the demonstration part."""
    case = cl.load_scenario("builtin:demo-part").base
    reference = case.reference()
    result = cl.judge(cl.simulate(case.machine, case.controller, reference), reference)
    run = JudgedRun("base", reference, result, summarise(result, reference))
    return ReportData("part", (run,), Provenance(), case.lines, case.tolerance)


def place(page, x: float, y: float) -> tuple[float, float]:
    """Return the pixel of a point [mm] of a picture seen from above, about its middle."""
    width, text = page.locator(".path-bar").evaluate("bar => [bar.firstChild.getBoundingClientRect().width, bar.innerText]")
    scale = width / float(text.split()[0])
    stage = page.locator(".path-stage").bounding_box()
    return stage["x"] + stage["width"] / 2 + scale * x, stage["y"] + stage["height"] / 2 - scale * y


def test_the_circle_is_drawn_where_it_is(opened, circle):
    page = opened(circle)
    (x, y), middle = place(page, synthetic.RADIUS * 1e3, 0.0), place(page, 0.0, 0.0)
    assert y == middle[1]
    radii = [math.hypot(*at) for at in page.evaluate(PIXELS, None)]
    assert len(radii) > 1000 and np.median(radii) == pytest.approx(x - middle[0], rel=0.02)
    labels = page.locator(".path-worst text").all_text_contents()
    assert labels[0] == f"{np.abs(circle.schemes[0].result['part_error'][1000:]).max() * 1e6:.3g} um, line 4"


def test_the_tolerance_follows_short_moves(opened, circle):
    turns = np.linspace(0.0, 2.0 * np.pi, 1001)
    corners = list(map(tuple, synthetic.RADIUS * np.column_stack([np.cos(turns), np.sin(turns)])))
    path = Path([Line(*ends) for ends in pairwise(corners)], closed=True)
    moved = synthetic.around(circle, path, uniform(path, 0.5, 1, 1e-3))
    page = opened(replace(moved, tolerance=20e-6))
    page.evaluate(MAGNIFY, math.log10(200.0))  # 4 mm
    page.evaluate(FRAME)
    scale = place(page, 1.0, 0.0)[0] - place(page, 0.0, 0.0)[0]
    radii = np.array([math.hypot(*at) for at in page.evaluate(PIXELS, BAND)]) / scale
    assert len(radii) > 1000 and np.all(np.minimum(abs(radii - 16.0), abs(radii - 24.0)) < 3.0 / scale)


def test_a_magnification_is_one_uniform(opened, part):
    page = opened(part, spy=SPY + FAST)
    frames = []
    for value in (2.0, 2.5, 3.0):
        page.evaluate(MAGNIFY, value)
        page.evaluate(FRAME)
        frames.append(page.evaluate(TAKE))
    assert [frame["buffers"] for frame in frames[1:]] == [0, 0] and frames[1]["draws"] > 0 and frames[2]["draws"] > 0
    changed = {re.match(r"\w+", one)[0] for one in set(frames[1]["uniforms"]) ^ set(frames[2]["uniforms"])}
    assert changed == {"magnification"}
    assert page.locator(".path-times").inner_text() == "error × 1,000"
    page.wait_for_timeout(400)
    page.evaluate(TAKE)
    page.wait_for_timeout(300)
    assert page.evaluate(TAKE)["draws"] == 0


@pytest.mark.parametrize(("degrees", "line"), [(45.0, 3), (225.0, 4)])
def test_a_click_tells_line_time_and_error(opened, circle, degrees, line):
    page = opened(circle)
    page.get_by_label(circle.schemes[1].name).uncheck()
    radius = synthetic.RADIUS * 1e3
    page.mouse.click(*place(page, radius * math.cos(math.radians(degrees)), radius * math.sin(math.radians(degrees))))
    assert page.evaluate("picks") == [line]
    said = page.locator(".path-said").inner_text()
    found, time, error, feed = re.match(r"Line (\d+), t = ([\d.]+) s, error ([\d.]+) um, (\d+) mm/min", said).groups()
    assert int(found) == line and float(time) == pytest.approx(2.0 + degrees / 360.0 * 2.0, abs=0.01)
    run = circle.schemes[0]
    assert float(error) == pytest.approx(abs(run.result["part_error"][round(float(time) * 1e3)]) * 1e6, rel=0.02)
    assert float(feed) == pytest.approx(synthetic.RADIUS * math.pi * 6e4, rel=5e-3)


def test_a_line_of_the_part_is_marked_where_it_is(opened, circle):
    page = opened(circle)
    assert page.evaluate(PIXELS, PICKED) == []
    page.evaluate("drawing.highlight(4)")
    page.evaluate(FRAME)
    heights = [y for _, y in page.evaluate(PIXELS, PICKED)]
    assert len(heights) > 100 and max(heights) < 6  # the lower half
    page.evaluate("drawing.highlight(null)")
    page.evaluate(FRAME)
    assert page.evaluate(PIXELS, PICKED) == []


def test_playback_moves_the_tool_and_draws_no_line_again(opened, circle):
    page = opened(circle)
    page.wait_for_timeout(300)
    page.evaluate(TAKE)
    tool, seen = page.locator(".path-tool").first, []
    page.get_by_role("button", name="Play").click()
    for _ in range(2):
        page.wait_for_timeout(200)
        seen.append((float(page.get_by_role("slider", name="Time").input_value()), tool.get_attribute("cx")))
    page.get_by_role("button", name="Pause").click()
    assert 2.0 < seen[0][0] < seen[1][0] and seen[0][1] != seen[1][1] and page.evaluate(TAKE)["draws"] == 0
    page.evaluate("const at = document.querySelector('[aria-label=Time]'); at.value = 3.0; at.dispatchEvent(new Event('input'));")
    x, y = place(page, -synthetic.RADIUS * 1e3, 0.0)
    at, stage = (float(tool.get_attribute(name)) for name in ("cx", "cy")), page.locator(".path-stage").bounding_box()
    np.testing.assert_allclose(list(at), (x - stage["x"], y - stage["y"]), atol=25)
    assert page.locator("output", has_text="line 4").count()


def test_keys_and_views_change_what_is_seen(opened, part):
    page = opened(part)
    before, scale = page.evaluate(PIXELS, None), page.locator(".path-bar").inner_text()
    page.locator(".path-stage").focus()
    page.keyboard.press("ArrowLeft")
    page.evaluate(FRAME)
    assert page.evaluate(PIXELS, None) != before
    for _ in range(8):
        page.keyboard.press("+")
    page.evaluate(FRAME)
    assert page.locator(".path-bar").inner_text() != scale
    page.get_by_role("button", name="XZ").click()
    page.evaluate(FRAME)
    heights = [y for _, y in page.evaluate(PIXELS, None)]
    wide = [x for x, _ in page.evaluate(PIXELS, None)]
    assert heights and max(heights) - min(heights) < 0.4 * (max(wide) - min(wide))


def test_runs_can_be_switched_and_have_their_colours(opened, circle):
    page = opened(circle)
    blue = (0, 114, 178)
    assert len(page.evaluate(PIXELS, blue)) > 100  # before and after: both
    page.get_by_label(circle.schemes[1].name).uncheck()
    page.evaluate(FRAME)
    assert page.evaluate(PIXELS, blue) == []


def test_an_old_browser_gets_a_line_of_text(opened, circle):
    page = opened(circle, spy="HTMLCanvasElement.prototype.getContext = OffscreenCanvas.prototype.getContext = () => null;")
    assert "WebGL 2" in page.locator("#host").inner_text() and page.locator("canvas").count() == 0
