"""The printed page, and the page that leads to several reports."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest
import synthetic

from contourlab.rendering.one_page import write_overview, write_page


@pytest.mark.parametrize("amplitudes", [(8e-6,), (8e-6, 2e-6), (8e-6, 6e-6, 4e-6, 2e-6, 1e-6)])
@pytest.mark.slow
def test_the_report_fits_on_one_page(amplitudes: tuple[float, ...], tmp_path: Path) -> None:
    data = replace(synthetic.report(amplitudes), title="100 $ of _parts_ {x}")
    content = write_page(data, tmp_path / "report.pdf").read_bytes()
    assert content.startswith(b"%PDF") and len(re.findall(rb"/Type\s*/Page\b", content)) == 1
    assert write_page(data, tmp_path / "again.pdf").read_bytes() == content


def test_the_overview_leads_to_every_report(tmp_path: Path) -> None:
    data = replace(synthetic.report(), title="<script>alert(1)</script>")
    reports = {"a/report.html": data, "b/report.html": data}
    text = write_overview(tmp_path / "page.html", "All hold.", reports, "contourlab demo").read_text(encoding="utf-8")
    assert [text.count(f'href="{name}/report.html"') for name in "ab"] == [1, 1]
    assert text.count('class="verdict good"') == 2 and text.count('class="verdict poor"') == 2
    assert text.count("data:image/svg+xml") == 2 and "<script" not in text and "All hold." in text and "contourlab demo" in text
