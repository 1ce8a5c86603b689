"""A page in a real browser, opened from its file: Debian's Chromium, driven by Playwright; one browser for all tests of a process."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

BROWSER = next((found for name in ("chromium", "chromium-browser", "google-chrome") if (found := shutil.which(name))), None)
OPTIONS = ("--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-accelerated-2d-canvas")
OPEN = "document.querySelectorAll('.fold').forEach(fold => { fold.open = true; })"
PLACE = ':is([id="{0}"], [data-key="{0}"])'
PAINTED = """([place, colours]) => [...document.querySelector(place).querySelectorAll('canvas:not([hidden])')].map(canvas => {
  const copy = new OffscreenCanvas(canvas.width, canvas.height), pen = copy.getContext('2d');
  pen.drawImage(canvas, 0, 0);
  const {data} = pen.getImageData(0, 0, canvas.width, canvas.height);
  const wanted = colours.map(colour => [1, 3, 5].map(i => parseInt(colour.slice(i, i + 2), 16)));
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] > 0 && (!wanted.length || wanted.some(rgb => rgb.every((value, k) => Math.abs(value - data[i + k]) < 8)))) count += 1;
  }
  return count;
})"""


class Browsing:
    """Opens pages, and collects what their scripts complain about."""

    def __init__(self, browser: Any) -> None:
        self.browser = browser
        self.contexts: list[Any] = []
        self.complaints: list[str] = []

    def open(self, page: Path, width: int = 1280, height: int = 720, *, dark: bool = False, first: str = "") -> Any:
        """Open a page in a window of a size [px], and all its folds; before all others, run the script `first`."""
        look = {"viewport": {"width": width, "height": height}, "color_scheme": "dark" if dark else "light", "offline": True}
        context = self.browser.new_context(**look)
        self.contexts.append(context)
        context.add_init_script(first)
        opened = context.new_page()
        opened.on("pageerror", lambda error: self.complaints.append(str(error)))
        opened.on("console", lambda said: self.complaints.append(said.text) if said.type in ("error", "warning") else None)
        opened.goto(page.as_uri())
        opened.evaluate(OPEN)
        return opened

    def close(self) -> None:
        """Close all pages."""
        while self.contexts:
            self.contexts.pop().close()
        self.complaints.clear()


def drawn(page: Any, key: str) -> Any:
    """Bring a picture into view, wait until it is drawn, and return it."""
    place = page.locator(PLACE.format(key)).first
    place.scroll_into_view_if_needed()
    page.locator(PLACE.format(key) + "[data-drawn]").first.wait_for(timeout=20_000)
    return place


def painted(page: Any, key: str, *colours: str) -> list[int]:
    """Return for each canvas of a picture the number of pixels in some colours, or without these in any."""
    drawn(page, key)
    counts: list[int] = page.evaluate(PAINTED, [PLACE.format(key), list(colours)])
    return counts


@pytest.fixture(scope="session")
def chromium() -> Iterator[Any]:
    """A browser, or a skipped test."""
    if BROWSER is None:
        pytest.skip("no Chromium on this machine")
    playwright = pytest.importorskip("playwright.sync_api", reason="no Playwright in this environment")
    with playwright.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=BROWSER, args=OPTIONS)
        yield browser
        browser.close()


@pytest.fixture
def browsing(chromium: Any) -> Iterator[Browsing]:
    """Open pages whose scripts must not complain."""
    browsing = Browsing(chromium)
    yield browsing
    complaints = list(browsing.complaints)
    browsing.close()
    assert complaints == []
