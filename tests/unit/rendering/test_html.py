"""The page: one self-contained file, safe with any text, small for any run."""

from __future__ import annotations

import base64
import gzip
import hashlib
import re
import subprocess
import sys
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest
import synthetic
from messages import pictures

from contourlab.errors import OutputError
from contourlab.findings import finding
from contourlab.rendering.html import MOST_POINTS, SCENE_POINTS, TOTAL_POINTS, render_html, write_html
from contourlab.rendering.judgement import Cause
from contourlab.result import Signal

VOID = {"meta", "br", "hr", "img", "input", "link", "col"}
EVIL = "</script><script>alert(1)</script><img src=x onerror=alert(2)> \"quoted\" & 'single' <!--"


class Page(HTMLParser):
    """Collects elements and texts, and fails if elements are not closed in order."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.open: list[str] = []
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.scripts: list[str] = []
        self.words: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, f"</{tag}> does not close the element that is open"

    def handle_data(self, data):
        if self.open and self.open[-1] == "script":
            self.scripts.append(data)
        elif self.open and self.open[-1] != "style":
            self.words.append(data)

    @property
    def text(self) -> str:
        """The text that a reader sees without the pictures."""
        return " ".join(" ".join(self.words).split())

    @property
    def figures(self) -> dict:
        """The data of the pictures."""
        return pictures(base64.b64decode(self.scripts[0]))


def arrays(value) -> list[np.ndarray]:
    """Return the arrays of a picture."""
    if isinstance(value, np.ndarray):
        return [value]
    items = value.values() if isinstance(value, dict) else value if isinstance(value, list) else []
    return [array for item in items for array in arrays(item)]


@pytest.fixture(scope="module")
def html(circle) -> str:
    return render_html(circle)


@pytest.fixture(scope="module")
def page(html) -> Page:
    return Page(html)


def test_every_element_is_closed(page):
    assert page.open == []


def test_nothing_is_fetched(page, html):
    for tag, attributes in page.elements:
        assert tag not in {"link", "iframe", "img", "object", "embed", "base"}
        for name in ("src", "href", "srcset", "action", "data", "poster"):
            assert (attributes.get(name) or "#").startswith("#"), (tag, attributes)
    style = re.search(r"<style>(.*?)</style>", html, flags=re.S).group(1)
    assert len(style) > 1000 and "url(" not in style and "@import" not in style


def test_the_browser_may_run_our_scripts_only(page):
    policy = next(a["content"] for t, a in page.elements if t == "meta" and a.get("http-equiv"))
    assert policy.startswith("default-src 'none'; script-src 'sha256-")
    library = gzip.decompress(base64.b64decode(page.scripts[1]))
    for script in (library, page.scripts[2].encode()):
        digest = base64.b64encode(hashlib.sha256(script).digest()).decode()
        assert f"'sha256-{digest}'" in policy
    assert len(page.scripts) == 3 and "unsafe-inline" not in policy.partition("style-src")[0]


def test_contents_lead_to_sections_that_exist(page):
    ids = {attributes.get("id") for _, attributes in page.elements}
    targets = [a["href"][1:] for t, a in page.elements if t == "a" and "data-pick" not in a]
    assert targets == ["verdict", "path", "lines", "findings", "comparison", "circles", "errors", "reversals", "axes", "bode", "again"]
    assert set(targets) <= ids


def test_every_picture_has_its_place(page):
    places = {a["id"] for t, a in page.elements if a.get("class") == "plot"}
    assert places == set(page.figures)


def test_verdict_table_and_scenario_are_readable_without_pictures(page, circle):
    for words in (
        "independent axes: out of tolerance",
        "modified reference: within tolerance",
        "8 um -> 2.1 um",
        "line 4",
        "contour error, integral um s",
        "contourlab report circle.toml --seed 1",
        "SHA-256",
    ):
        assert words in page.text, words
    assert " ".join(circle.provenance.scenario.split()) in page.text


def test_every_axis_title_has_a_unit(page):
    charts = [picture for picture in page.figures.values() if picture["kind"] == "Chart"]
    labels = [panel[key] for chart in charts for panel in chart["panels"] for key in ("x_label", "y_label")]
    assert len(labels) > 10 and all(re.search(r"\[[^\]]+\]$", label) for label in labels)


def test_every_row_of_figures_has_a_unit(page, html):
    table = html[html.index('<table class="figures">') : html.index("</table>", html.index('<table class="figures">'))]
    rows = re.findall(r"<tr.*?</tr>", table, flags=re.S)[1:]
    assert len(rows) >= 12
    for row in rows:
        unit = re.search(r'class="unit">(.*?)</td>', row, flags=re.S).group(1)
        assert unit or "tolerance 5 um" in row


def test_drawn_numbers_equal_the_signal(page, circle):
    curve = page.figures["error-time"]["panels"][0]["curves"][0]
    time, error = curve["x"], curve["y"]
    signal = circle.schemes[0].result["contour_error"] * 1e6
    np.testing.assert_allclose(error, signal[np.round(time / 1e-3).astype(int)], rtol=1e-6, atol=1e-6)
    assert np.abs(error).max() == pytest.approx(np.abs(signal).max(), rel=1e-6)


def test_markup_in_foreign_text_is_escaped(circle):
    first = circle.schemes[0]
    verdict = synthetic.judgement(first.result, 5e-6, EVIL)
    verdict = replace(verdict, causes=(Cause(EVIL, 1e-6, 1.0),))
    source = replace(circle.provenance, scenario=EVIL, command=EVIL, run_again=EVIL, platform=EVIL, version=EVIL)
    scheme = replace(first, name=EVIL, verdict=verdict, findings=(finding("CL228", number=EVIL),))
    data = replace(circle, title=EVIL, schemes=(scheme,), provenance=source, program=(EVIL, f"({EVIL})"))
    page = Page(render_html(data))
    tags = [tag for tag, _ in page.elements]
    assert page.open == [] and tags.count("script") == 3 and "img" not in tags
    assert not any(name.startswith("on") for _, attributes in page.elements for name in attributes)
    assert page.text.count("alert(1)") >= 9
    assert page.figures["error-time"]["panels"][0]["curves"][0]["name"] == EVIL  # as text: the viewer writes no markup


def test_drawing_libraries_are_imported_only_when_used():
    modules = "contourlab.rendering.html, contourlab.rendering.plots, contourlab.rendering.learning_pictures"
    code = f"import sys, {modules}; print(sorted({{'matplotlib', 'jinja2', 'rich'}} & set(sys.modules)))"
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert told.stdout.strip() == "[]"


def test_the_same_data_give_the_same_page(circle, html):
    assert render_html(circle) == html


def test_six_hundred_thousand_samples_stay_small(single, tmp_path):
    n = 600_000
    result = single.schemes[0].result
    rng = np.random.default_rng(3)
    signals = {
        name: Signal(np.resize(s.data, (n, *s.data.shape[1:])) + 1e-7 * rng.standard_normal((n, *s.data.shape[1:])), s.dims, s.unit)
        for name, s in result.signals.items()
    }
    spike = np.array(signals["contour_error"].data)
    spike[432_101] = 77e-6
    signals["contour_error"] = Signal(spike, ("sample",), "m")
    long = replace(result, signals=signals, servo_period=1e-4)
    names = [f"scheme {i}" for i in range(5)]
    data = replace(single, schemes=tuple(replace(single.schemes[0], name=name, result=long) for name in names))
    file = write_html(data, tmp_path / "new" / "long.html")
    assert file.stat().st_size < 1.5e6
    figures = Page(file.read_text(encoding="utf-8")).figures
    error = figures["error-time"]["panels"][0]["curves"][0]["y"]
    assert error.max() == pytest.approx(77.0) and error.size <= MOST_POINTS
    assert sum(array.size for array in arrays(figures)) <= 3 * TOTAL_POINTS + 11 * SCENE_POINTS  # columns


def test_of_a_long_program_the_judged_lines_are_shown(circle):
    lines = tuple(f"N{i} G1 X{i % 97}.125 Y{i % 89}.5" for i in range(60_000))
    worst = replace(circle.schemes[0].verdict.worst, line=40_000)
    scheme = replace(circle.schemes[0], verdict=replace(circle.schemes[0].verdict, worst=worst))
    text = render_html(replace(circle, program=lines, schemes=(scheme,)))
    assert len(text) < 1_500_000
    page = Page(text)
    assert lines[39_999] in page.text and lines[20_000] not in page.text
    assert hashlib.sha256("\n".join(lines).encode()).hexdigest()[:16] in page.text


def test_a_long_scenario_is_cut_with_a_note(circle):
    scenario = "# a table\n" + "0.001, 0.002\n" * 60_000
    page = Page(render_html(replace(circle, provenance=replace(circle.provenance, scenario=scenario))))
    assert hashlib.sha256(scenario.encode()).hexdigest() in page.text


def test_gaps_and_infinities_do_not_spoil_the_page(single):
    result = single.schemes[0].result
    error, command = np.array(result["contour_error"]), np.array(result["command"])
    error[10:20], command[30:40] = np.nan, np.inf
    spoilt = result.with_signals(contour_error=Signal(error, ("sample",), "m"), command=Signal(command, synthetic.BOTH, "full_scale"))
    page = Page(render_html(synthetic.with_result(single, spoilt)))
    assert np.isnan(page.figures["error-time"]["panels"][0]["curves"][0]["y"]).any()


def test_a_bare_run_has_a_page(square):
    page = Page(render_html(square))
    targets = [a["href"][1:] for t, a in page.elements if t == "a"]
    assert targets == ["path", "comparison", "errors", "axes", "again"]


def test_a_file_that_cannot_be_written(square, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(OutputError, match="file"):
        write_html(square, tmp_path / "file" / "page.html")


def test_a_failed_report_leaves_the_old_one(single, tmp_path):
    file = tmp_path / "page.html"
    file.write_text("old")
    result = single.schemes[0].result
    bare = replace(result, signals={"reference": result.signals["reference"]})
    with pytest.raises(Exception, match="judge"):
        write_html(synthetic.with_result(single, bare), file)
    assert file.read_text() == "old" and [p.name for p in tmp_path.iterdir()] == ["page.html"]
