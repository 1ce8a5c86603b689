"""What the golden tests share: the reproduction is computed once."""

from __future__ import annotations

from typing import Any

import pytest

from contourlab.studies.reproduce.ghaffari import reproduce

Rows = dict[tuple[str, str], dict[str, Any]]


@pytest.fixture(scope="session")
def rows() -> Rows:
    """Every row of the reproduction of Ghaffari & Ulsoy by name and case."""
    found = reproduce()
    by_name = {(row["name"], row["case"]): row for row in found}
    assert len(by_name) == len(found), "two rows share name and case"
    return by_name
