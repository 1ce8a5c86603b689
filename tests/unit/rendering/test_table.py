"""The one table renderer: it fits the page and keeps names whole."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from contourlab.rendering.table import Column, Table, page_width

NAME = "controller.axes.x.controller.position_gain"
CELLS = st.text("abcdefghij.0123456789", min_size=1, max_size=12)


def wide(*cells: str) -> Table:
    columns = [Column("step", left=True), Column("parameter", left=True), *(Column(f"variant {i} [um]") for i in range(9))]
    return Table(columns, keys=2, rows=[cells or ("1", NAME, *["12.34"] * 9)])


@pytest.mark.parametrize("width", [60, 80, 100, 200])
def test_a_wide_table_becomes_panels_that_fit_and_repeat_the_names(width: int) -> None:
    panels = wide().text(width).split("\n\n")
    assert all(len(line) <= width for panel in panels for line in panel.splitlines())
    assert all(NAME in panel for panel in panels)
    assert sum(panel.count("12.34") for panel in panels) == 9


def test_prose_wraps_and_names_do_not() -> None:
    table = Table([Column("parameter", left=True), Column("remark", prose=True)], rows=[(NAME, "words " * 20)])
    lines = table.text(72).splitlines()
    assert NAME in lines[2]
    assert len(lines) > 3
    assert max(map(len, lines)) <= 72


PROSE = st.lists(CELLS, max_size=8).map(" ".join)


@given(st.lists(st.tuples(CELLS, CELLS, PROSE, PROSE), min_size=1, max_size=5), st.integers(20, 120))
def test_every_word_is_printed_whole(rows: list[tuple[str, str, str, str]], width: int) -> None:
    table = Table([Column("a", left=True), Column("b"), Column("c", prose=True), Column("d", prose=True)], rows=rows)
    printed = table.text(width).split()
    assert all(word in printed for row in rows for cell in row for word in cell.split())


def test_a_row_with_too_few_cells_is_refused() -> None:
    with pytest.raises(ValueError):
        wide("1")


def test_the_page_is_as_wide_as_columns_says_and_80_without_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "57")
    assert page_width() == 57
    monkeypatch.delenv("COLUMNS")
    assert page_width() == 80


def test_a_word_in_a_column_of_prose_is_never_cut_but_a_head_may_take_lines() -> None:
    columns = [Column("a", left=True), Column("with observer and modified reference"), Column("c", prose=True)]
    table = Table(columns, rows=[("x", "1.5", "controller_acceleration_feedforward and more words")])
    lines = table.text(60).splitlines()
    assert any("controller_acceleration_feedforward" in line for line in lines)
    assert any("observer" in line and "reference" not in line for line in lines) and max(map(len, lines)) <= 60
