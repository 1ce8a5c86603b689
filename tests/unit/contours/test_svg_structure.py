"""The structure of SVG drawings: percentages, symbols and uses, nested drawings, and hidden elements."""

from __future__ import annotations

from pathlib import Path as File

import numpy as np
import pytest
from drawings import MM, svg
from refusals import mentions

from contourlab.contours import read_contour
from contourlab.contours.drawing import Drawing
from contourlab.contours.svg import read_svg
from contourlab.errors import GeometryError

HEIGHT = 80.0
"""Height of the drawing, in its user units; it is 100 wide."""


def box(drawing: Drawing, chain: int = 1) -> list[float]:
    """Return left, upper, right and lower edge of a chain in user units."""
    path = drawing.chains[chain - 1].path
    places = np.concatenate([path.position(np.linspace(0.0, path.length, 2001)), path.position(path.breaks)]) / MM
    (left, low), (right, high) = places.min(axis=0), places.max(axis=0)
    return [left, HEIGHT - high, right, HEIGHT - low]


DIAGONAL = float(np.sqrt((100**2 + 80**2) / 2))


@pytest.mark.parametrize(
    ("body", "edges"),
    [
        ('<circle cx="50%" cy="50%" r="10%"/>', [50 - DIAGONAL / 10, 40 - DIAGONAL / 10, 50 + DIAGONAL / 10, 40 + DIAGONAL / 10]),
        ('<circle style="cx:50%;cy:50%;r:10mm"/>', [50 - 960 / 25.4, 40 - 960 / 25.4, 50 + 960 / 25.4, 40 + 960 / 25.4]),
        ('<ellipse cx="50%" cy="25%" rx="5%" ry="5%"/>', [45, 16, 55, 24]),
        ('<rect x="10%" y="10%" width="20%" height="20%"/>', [10, 8, 30, 24]),
        ('<line x1="10%" y1="10%" x2="90%" y2="90%"/>', [10, 8, 90, 72]),
        ('<defs><rect id="a" width="3" height="4"/></defs><use href="#a" x="50%" y="50%"/>', [50, 40, 53, 44]),
        # A nested drawing: 50 by 20 user units at (10, 8). Its 10 by 10 own units are twice as large and centred in it.
        (
            '<svg x="10%" y="10%" width="50%" height="25%" viewBox="0 0 10 10"><rect width="50%" height="100%"/></svg>',
            [10 + 15, 8, 10 + 15 + 10, 28],
        ),
        ('<svg x="10" y="5"><rect width="50%" height="50%"/></svg>', [10, 5, 60, 45]),
        ('<svg x="10" y="5" width="50"><rect x="1" width="50%" height="7"/></svg>', [11, 5, 36, 12]),
        # After a nested drawing the outer viewport applies again.
        ('<svg width="10" height="10" viewBox="0 0 1 1"/><rect width="10%" height="10%"/>', [0, 0, 10, 8]),
    ],
)
def test_percentages_refer_to_width_height_and_diagonal(tmp_path: File, body: str, edges: list[float]) -> None:
    drawing = read_svg(svg(tmp_path, body))
    assert len(drawing.chains) == 1
    # 2001 samples of a circle miss its edges by less than r (pi / 2000)^2 / 2.
    np.testing.assert_allclose(box(drawing), edges, atol=1e-4)


def test_percentages_without_a_size_are_refused(tmp_path: File) -> None:
    with pytest.raises(GeometryError, match=r"circle 'c': r = \"10%\""):
        read_svg(svg(tmp_path, '<circle id="c" r="10%"/>', ""))


def test_a_rectangle_inherits_no_geometry(tmp_path: File) -> None:
    """It inherits neither the size of the drawing nor the place of a nested one."""
    drawing = read_svg(svg(tmp_path, '<rect id="r" height="5"/><rect width="2" height="1"/>'))
    assert len(drawing.chains) == 1
    assert [note.split(": ")[0] for note in drawing.notes] == ["rect 'r'"]


SYMBOL = '<symbol id="s"><rect width="3" height="4"/></symbol>'


@pytest.mark.parametrize(
    ("body", "edges"),
    [
        (SYMBOL, []),
        (SYMBOL + '<use href="#s" x="5" y="6"/>', [[5, 6, 8, 10]]),
        ('<use href="#s" x="5" y="6"/>' + SYMBOL, [[5, 6, 8, 10]]),
        (SYMBOL + '<use href="#s"/><use href="#s" x="10" transform="scale(2)"/>', [[0, 0, 3, 4], [20, 0, 26, 8]]),
        # Its viewBox is fitted into the size of the use: 10 units into 20 by 40, centred in the remaining space.
        (
            '<symbol id="s" viewBox="0 0 10 10"><rect width="3" height="4"/></symbol><use href="#s" x="5" width="20" height="40"/>',
            [[5, 10, 11, 18]],
        ),
        (
            '<symbol id="s" viewBox="1 1 10 10" width="20" height="20"><rect x="1" y="1" width="3" height="4"/></symbol><use href="#s"/>',
            [[0, 0, 6, 8]],
        ),
        # A use inside a symbol, a symbol in a symbol's place, and a part of a symbol by its own name.
        (SYMBOL + '<symbol id="t"><use href="#s" x="1"/></symbol><use href="#t" y="2"/>', [[1, 2, 4, 6]]),
        ('<symbol><rect id="in" width="3" height="4"/></symbol><use href="#in" x="9"/>', [[9, 0, 12, 4]]),
        # A hidden group still provides its symbols.
        (f'<svg style="display:none">{SYMBOL}</svg><use href="#s" x="1"/>', [[1, 0, 4, 4]]),
        (f'<defs>{SYMBOL}</defs><use href="#s" x="1"/>', [[1, 0, 4, 4]]),
    ],
)  # fmt: skip
def test_symbols_are_drawn_where_they_are_used(tmp_path: File, body: str, edges: list[list[float]]) -> None:
    drawing = read_svg(svg(tmp_path, body))
    assert len(drawing.chains) == len(edges)
    for number, edge in enumerate(edges, 1):
        np.testing.assert_allclose(box(drawing, number), edge, atol=1e-9)
    assert drawing.left_out == ()
    assert drawing.notes == ()


def test_a_used_path_keeps_its_own_path_data(tmp_path: File) -> None:
    body = (
        '<defs><path id="p" d="M0 0 h3 v4" transform="scale(2)"/></defs><use href="#p" x="10"/><use href="#p" y="20"/><path d="M50 50h7"/>'
    )
    drawing = read_svg(svg(tmp_path, body))
    found = [box(drawing, number) for number in (1, 2, 3)]
    np.testing.assert_allclose(found, [[10, 0, 16, 8], [0, 20, 6, 28], [50, 50, 57, 50]], atol=1e-9)


def test_uses_of_missing_elements_are_noted(tmp_path: File) -> None:
    drawing = read_svg(svg(tmp_path, '<use href="#gone"/><use href="other.svg#a"/><use/><rect width="1" height="1"/>'))
    assert len(drawing.chains) == 1
    for note, word in zip(drawing.notes, ("'#gone'", "'other.svg#a'", "nothing"), strict=True):
        assert note.startswith("use: ") and word in note


@pytest.mark.parametrize("body", ['<g id="a"><use href="#a"/></g>', '<symbol id="a"><use href="#a"/></symbol><use href="#a"/>'])
def test_a_use_that_draws_itself_is_refused(tmp_path: File, body: str) -> None:
    with pytest.raises(GeometryError, match="itself"):
        read_svg(svg(tmp_path, body))


@pytest.mark.parametrize("depth", [300, 3000, 100_000])
def test_deep_nesting_is_refused(tmp_path: File, depth: int) -> None:
    with pytest.raises(GeometryError, match="200 deep"):
        read_contour(svg(tmp_path, "<g>" * depth + '<circle r="3"/>' + "</g>" * depth))
    assert read_contour(svg(tmp_path, "<g>" * 190 + '<circle r="3"/>' + "</g>" * 190)).closed


@pytest.mark.parametrize(
    ("style", "shape", "is_seen"),
    [
        ("", 'visibility="hidden"', False),
        ("", 'visibility="collapse"', False),
        ("", 'style="visibility: hidden"', False),
        ("", 'display="none"', False),
        ("", 'style="display:none !important"', False),
        ("", 'display="none" style="display:inline"', True),
        (".h{display:none}", 'class="h"', False),
        (".h{display:none}", 'class="a h"', False),
        (".h{display:none}", 'class="hh"', True),
        ("/* .k{display:none} */ .h , .k { stroke: red; visibility:hidden; }", 'class="k"', False),
        ("rect{display:none}", "", False),
        ("circle{display:none}", "", True),
        ("*{visibility:hidden}", 'style="visibility:visible"', True),
        ("#a{display:inline} .h{display:none}", 'id="a" class="h"', True),
        (".h{display:none!important} #a{display:inline}", 'id="a" class="h" style="display:inline"', False),
        ("rect.h#a{visibility:hidden}", 'id="a" class="h"', False),
    ],
)
def test_hidden_elements_are_left_out_and_counted(tmp_path: File, style: str, shape: str, is_seen: bool) -> None:
    for sheet, before in ((f"<style>{style}</style>", True), (f"<style>{style}</style>", False)):
        body = f'<rect {shape} width="3" height="4"/>'
        drawing = read_svg(svg(tmp_path, sheet + body if before else body + sheet))
        assert len(drawing.chains) == is_seen
        assert [(item.kind, item.why) for item in drawing.left_out] == ([] if is_seen else [("hidden", "rect")])
        assert drawing.notes == ()


@pytest.mark.parametrize(
    ("body", "seen", "hidden"),
    [
        # A child can be visible again inside an invisible element, but not inside one that is not displayed.
        ('<g visibility="hidden"><rect width="1" height="1" visibility="visible"/><circle r="2"/></g>', 1, ["circle"]),
        (
            '<g display="none"><rect width="1" height="1" display="inline"/><line x2="2"/><text>a</text></g>',
            0,
            ["rect", "simpleline", "text"],
        ),
        ('<g visibility="hidden"><rect width="1" height="1" style="visibility:inherit"/></g>', 0, ["rect"]),
        # A use passes its own on.
        ('<defs><rect id="a" width="1" height="1"/></defs><use href="#a" visibility="hidden"/><use href="#a"/>', 1, ["rect"]),
        ('<defs><rect id="a" width="1" height="1" display="none"/></defs><use href="#a"/>', 0, ["rect"]),
        ('<defs style="display:none"><rect id="a" width="1" height="1"/></defs><use href="#a"/>', 1, []),
    ],
)
def test_hiding_is_inherited(tmp_path: File, body: str, seen: int, hidden: list[str]) -> None:
    drawing = read_svg(svg(tmp_path, body))
    assert len(drawing.chains) == seen
    assert [item.why.replace("line", "simpleline") for item in drawing.left_out] == hidden


def test_unknown_style_rules_are_noted(tmp_path: File) -> None:
    sheet = "<style>g &gt; rect {display:none} @media print { rect {visibility:hidden} } a:hover{fill:red}</style>"
    drawing = read_svg(svg(tmp_path, sheet + '<g><rect width="3" height="4"/></g>'))
    assert len(drawing.chains) == 1
    for note, words in zip(sorted(drawing.notes), (["'@media print'"], ["display", "'g > rect'"]), strict=True):
        assert mentions([note], *words)
