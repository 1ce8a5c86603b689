"""A page of the documentation with a viewer, opened from its file."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from browsing import painted

DOCS = Path(__file__).parents[2] / "docs"
CONF = f"""
import sys
sys.path.insert(0, {str(DOCS)!r})
extensions = ["myst_parser", "live"]
myst_enable_extensions = ["colon_fence"]
html_static_path = [{str(DOCS / "_static")!r}]
"""
PAGE = """# A circle

:::{viewer} circle causes
A picture for readers without JavaScript.
:::
"""


@pytest.mark.slow
def test_a_page_shows_a_viewer_in_place_of_its_picture(browsing, tmp_path):
    pytest.importorskip("myst_parser", reason="no Sphinx and MyST in this environment")
    (tmp_path / "conf.py").write_text(CONF, encoding="utf-8")
    (tmp_path / "index.md").write_text(PAGE, encoding="utf-8")
    subprocess.run([sys.executable, "-m", "sphinx", "-W", "-q", str(tmp_path), str(tmp_path / "out")], check=True)
    page = tmp_path / "out" / "index.html"
    assert "A picture for readers without JavaScript." in page.read_text(encoding="utf-8")
    opened = browsing.open(page)
    (circle,) = painted(opened, "causes")
    assert circle > 1000 and opened.get_by_text("A picture for readers").count() == 0
    output = opened.locator(".viewer output").first
    before = float(output.inner_text().split()[0])
    opened.locator(".cl-slider", has_text="backlash x").locator("input").fill("0")
    assert float(output.inner_text().split()[0]) < before
