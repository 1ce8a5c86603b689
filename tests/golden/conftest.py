"""Fixtures of the golden tests."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from typing import Any

import pytest
from once import once

from contourlab.papers.rows import Part, Row, read_bands
from contourlab.papers.run import run_parts

Rows = dict[tuple[str, str], dict[str, Any]]


Computed = Callable[[str, Iterable[Part]], list[Row]]


@pytest.fixture(scope="session")
def computed(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Computed:
    """Compute the rows of a paper's parts, once for all workers."""

    def rows_of(paper: str, parts: Iterable[Part]) -> list[Row]:
        rows: list[Row] = once(tmp_path_factory, worker_id, f"rows of {paper}", lambda: run_parts(parts, read_bands(paper)))
        assert len({(row.name, row.case) for row in rows}) == len(rows), "two rows share name and case"
        return rows

    return rows_of


@pytest.fixture(scope="session")
def rows(reproduction: tuple[int, str, str]) -> Rows:
    """Every row of the reproduction of Ghaffari & Ulsoy by name and case, as ``--json`` prints them."""
    found = json.loads(reproduction[1])
    by_name = {(row["name"], row["case"]): row for row in found}
    assert len(by_name) == len(found), "two rows share name and case"
    return by_name
