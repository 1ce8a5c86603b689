"""A page of the documentation with a viewer, opened from its file."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from browsing import Browsing, drawn, painted

import contourlab as cl

DOCS = Path(__file__).parents[2] / "docs"
CONF = f"""
import sys
sys.path[:0] = [{str(DOCS)!r}, {str(DOCS.parent / "src")!r}]
extensions = ["myst_parser", "live"]
myst_enable_extensions = ["colon_fence"]
html_static_path = [{str(DOCS / "_static")!r}]
"""
PART = """# A part

:::{viewer} part live path-space error-time
A picture.
:::
"""
PAGE = """# A circle

:::{viewer} circle causes
A picture for readers without JavaScript.
:::
"""


def largest_error(factor: float) -> float:
    """Return the part error [m] of the demonstration part with other velocity gains, as in the page rounded to three digits."""
    case = cl.load_scenario("builtin:demo-part").case("position loop")
    gains = {axis: each.controller.velocity_gain for axis, each in case.controller.axes.items()}
    named = {f"controller.axes.{axis}.controller.velocity_gain": gain for axis, gain in gains.items()}
    changed = {name: float(f"{gain * factor:.3g}") for name, gain in named.items() if factor != 1.0}
    reference = case.reference()
    result = cl.judge(cl.simulate(case.machine, case.controller, reference, changed), reference)
    return cl.summarise(result, reference).part_error.max


def built(browsing: Browsing, folder: Path, page: str) -> Any:
    """Build a site of one page, and open it."""
    pytest.importorskip("myst_parser", reason="no Sphinx and MyST in this environment")
    (folder / "conf.py").write_text(CONF, encoding="utf-8")
    (folder / "index.md").write_text(page, encoding="utf-8")
    subprocess.run([sys.executable, "-m", "sphinx", "-W", "-q", str(folder), str(folder / "out")], check=True)
    return browsing.open(folder / "out" / "index.html")


@pytest.mark.slow
def test_a_gain_is_dragged_on_a_page(browsing, tmp_path):
    opened = built(browsing, tmp_path, PART)
    live = drawn(opened, "live")
    worst = live.locator("tr", has_text="largest part error").locator("td")
    live.locator("input[type=range]").first.fill("-0.3")  # half the gain
    live.locator(".live-said", has_text="Whole part").wait_for()
    shown = [float(worst.nth(k).inner_text()) for k in (0, -1)]
    assert shown == pytest.approx([1e6 * largest_error(1.0), 1e6 * largest_error(10**-0.3)], abs=0.1)
    assert painted(opened, "path-space")[0] > 1000


@pytest.mark.slow
def test_a_page_shows_a_viewer_in_place_of_its_picture(browsing, tmp_path):
    opened = built(browsing, tmp_path, PAGE)
    assert "A picture for readers without JavaScript." in (tmp_path / "out" / "index.html").read_text(encoding="utf-8")
    (circle,) = painted(opened, "causes")
    assert circle > 1000 and opened.get_by_text("A picture for readers").count() == 0
    output = opened.locator(".viewer output").first
    before = float(output.inner_text().split()[0])
    opened.locator(".cl-slider", has_text="backlash x").locator("input").fill("0")
    assert float(output.inner_text().split()[0]) < before
