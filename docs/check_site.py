"""Check the built site: every internal link and anchor holds, nothing is loaded from elsewhere, and the search knows the subject."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

SITE = Path(__file__).resolve().parent / "_build" / "html"
LOADED = {"script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src"}


class Page(HTMLParser):
    """Anchors and links of a page, and what it loads."""

    def __init__(self, file: Path) -> None:
        super().__init__()
        self.anchors: set[str] = set()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        values = {name: value or "" for name, value in attrs}
        self.anchors.update(values[name] for name in ("id", "name") if name in values)
        if tag == "a" and "href" in values:
            self.links.append(values["href"])
        if LOADED.get(tag) in values:
            self.loaded.append(values[LOADED[tag]])


def faults() -> Iterator[str]:
    """Yield all faults, with their page."""
    pages = {file: Page(file) for file in SITE.rglob("*.html") if "_static" not in file.parts}
    for file, page in pages.items():
        place = file.relative_to(SITE)
        yield from (f"{place}: loads {url}" for url in page.loaded if urlsplit(url).netloc)
        for link in (*page.links, *page.loaded):
            url = urlsplit(link)
            if url.scheme or url.netloc:
                continue
            goal = (file.parent / unquote(url.path)).resolve() if url.path else file
            if not goal.exists():
                yield f"{place}: link to {link}: no such file"
            elif url.fragment and goal in pages and unquote(url.fragment) not in pages[goal].anchors:
                yield f"{place}: link to {link}: no such anchor"
    if '"backlash":' not in (SITE / "searchindex.js").read_text(encoding="utf-8"):
        yield "the search does not find backlash"


if __name__ == "__main__":
    found = list(faults())
    print(*found, f"site: {len(found)} faults", sep="\n")
    sys.exit(bool(found))
