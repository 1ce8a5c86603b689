"""Fixtures of the golden tests."""

from __future__ import annotations

import json
from typing import Any

import pytest

Rows = dict[tuple[str, str], dict[str, Any]]


@pytest.fixture(scope="session")
def rows(reproduction: tuple[int, str, str]) -> Rows:
    """Every row of the reproduction of Ghaffari & Ulsoy by name and case, as ``--json`` prints them."""
    found = json.loads(reproduction[1])
    by_name = {(row["name"], row["case"]): row for row in found}
    assert len(by_name) == len(found), "two rows share name and case"
    return by_name
