"""The report as its reader sees it: one file from a simulated result, opened by a browser without a network."""

from __future__ import annotations

import html
import json
import re
import shutil
import subprocess
import time
from pathlib import Path

import pytest
import synthetic

from contourlab.rendering.comparison import compare
from contourlab.rendering.html import write_html
from contourlab.rendering.path_picture import path_charts
from contourlab.result import Result

BROWSER = next((found for name in ("chromium", "chromium-browser", "google-chrome") if (found := shutil.which(name))), None)
QUIET = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
    "--hide-scrollbars",
    "--enable-logging=stderr",
    "--host-resolver-rules=MAP * ~NOTFOUND",
    "--run-all-compositor-stages-before-draw",  # else pictures in view may stay undrawn
    "--virtual-time-budget=20000",
    "--window-size=1440,12000",
)


@pytest.fixture(scope="module")
def data():
    return synthetic.report()


@pytest.fixture(scope="module")
def page(data, tmp_path_factory) -> Path:
    return write_html(data, tmp_path_factory.mktemp("report") / "page.html")


def browse(page: Path, *options: str) -> subprocess.CompletedProcess[str]:
    """Open a page and return the browser's output."""
    command = [BROWSER, *QUIET, f"--user-data-dir={page.parent / 'profile'}", *options, page.as_uri()]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=True)


def drawn(document: str) -> set[str]:
    """Return the pictures that the browser drew."""
    return set(re.findall(r'<div class="plot[^"]*" id="([^"]+)"[^>]*data-drawn="1"', document))


def acted(page: Path, script: str, wanted: set[str], *options: str) -> str:
    """Open a copy of a page, run a script once it has a picture, and return the document, if possible with the pictures wanted."""
    text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", page.read_text(encoding="utf-8"))
    copy = page.with_name("acted.html")
    ready = "document.querySelector('.plot[data-drawn] .main-svg')"
    later = f"const waiting = setInterval(function () {{ if ({ready}) {{ clearInterval(waiting); {script} }} }}, 300);"
    copy.write_text(text.replace("</body>", f"<script>{later}</script></body>"), encoding="utf-8")
    for _ in range(4):  # the browser's clock does not wait for its painting: on a busy machine it closes the page too early
        seen = browse(copy, "--dump-dom", *options)
        assert [line for line in seen.stderr.splitlines() if "CONSOLE" in line and re.search("Uncaught|rror|WARN", line)] == []
        if wanted <= drawn(seen.stdout):
            break
    return seen.stdout


OPEN = "document.querySelectorAll('.fold').forEach(function (fold) { fold.open = true; });"


@pytest.mark.skipif(BROWSER is None, reason="no Chromium on this machine")
@pytest.mark.slow
def test_a_page_opens_without_complaint_and_with_its_path(page):
    seen = browse(page, "--dump-dom")
    assert [line for line in seen.stderr.splitlines() if "CONSOLE" in line] == []
    assert "path-0" in drawn(seen.stdout) and "main-svg" in seen.stdout
    assert 'id="path-space"' in seen.stdout and "path-space" not in drawn(seen.stdout)


CLICKS = """
document.querySelector('#lines tr[data-line="4"]').click();
const shown = document.getElementById('path-0'), last = shown.data[shown.data.length - 1];
const chosen = Math.max(...last.x), row = document.querySelector('#lines .picked').dataset.line;
shown.emit('plotly_click', {points: [{curveNumber: 0, pointNumber: 5}]});
const found = document.getElementById('picked').textContent;
document.querySelectorAll('#lines th button')[1].click();
const order = Array.from(document.querySelectorAll('#lines tbody tr')).map(function (r) { return r.dataset.line; }).join();
document.querySelector('[data-step="1"]').click();
document.querySelector('[data-view="path-space"]').click();
document.title = JSON.stringify([row, Number.isFinite(chosen), found, order, document.getElementById('magnification').textContent]);
"""


@pytest.mark.skipif(BROWSER is None, reason="no Chromium on this machine")
@pytest.mark.parametrize("width", [1280, 400])
@pytest.mark.slow
def test_clicks_lead_from_a_line_to_its_path_and_back(data, page, width):
    before = path_charts(data, 100)[0].magnification
    document = acted(page, CLICKS, {"path-space"}, f"--window-size={width},3000", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
    row, shown, found, order, scale = json.loads(html.unescape(re.search("<title>(.*?)</title>", document)[1]))
    assert (row, shown) == ("4", True) and found == "Line 3: G21 G90 F3770"
    assert sorted(order.split(",")) == ["3", "4"]
    assert float(scale.split()[-1].replace("\u2009", "")) > before
    assert "path-space" in drawn(document)


@pytest.mark.skipif(BROWSER is None, reason="no Chromium on this machine")
@pytest.mark.slow
def test_every_picture_is_drawn_once_its_fold_is_open(data, page):
    wanted = {"path-0", "circle-0", "error-time", "error-arc", "axis-0", "axis-1", "bode-0", "bode-1"}
    document = acted(page, OPEN, wanted)
    assert drawn(document) == wanted
    assert document.count('class="main-svg"') >= len(wanted)
    assert re.search(r'<output id="magnification">error × \d', document)


@pytest.mark.skipif(BROWSER is None, reason="no Chromium on this machine")
@pytest.mark.slow
def test_a_browser_paints_the_curves_in_their_colours(page, tmp_path):
    from PIL import Image

    # On a busy machine the browser may take the picture before it has painted the curves.
    for turn in range(3):
        browse(page, f"--screenshot={tmp_path / f'page-{turn}.png'}")
        with Image.open(tmp_path / f"page-{turn}.png") as picture:
            colours = {colour: count for count, colour in picture.convert("RGB").getcolors(1 << 24)}
        painted = [colours.get(wanted, 0) for wanted in ((0xD5, 0x5E, 0x00), (0x00, 0x72, 0xB2))]
        if min(painted) > 600:
            break
    assert min(painted) > 600


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
    assert file.stat().st_size < 3e6


def test_the_page_and_the_table_show_the_same_figures(data, page):
    text = page.read_text(encoding="utf-8")
    for row in compare(data).rows[:12]:
        for cell in (row.label, row.unit, *(cell.text for cell in row.cells)):
            assert f">{cell}<" in text or cell in ("", "-"), cell
