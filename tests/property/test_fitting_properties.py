"""Curves behind chopped lines: random routes, each planned and checked by code of its own."""

from __future__ import annotations

import pytest
from chopped import check
from each import each


@each("seed", range(20))
def test_plans_keep_to_tolerance_order_and_limits(seed: int) -> None:
    check(seed)


@pytest.mark.slow
@pytest.mark.parametrize("first", range(20, 320, 30))
def test_many_plans_keep_to_tolerance_order_and_limits(first: int) -> None:
    for seed in range(first, first + 30):
        check(seed)
