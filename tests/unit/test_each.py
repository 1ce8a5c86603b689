"""Cases that share a test."""

from __future__ import annotations

import inspect

import pytest
from each import each


@pytest.mark.slow
@each("a, b", [(1, 1), (1, 2), (3, 3), (3, 4)])
def equal(tmp_path: object, a: int, b: int) -> None:
    assert a == b


def test_each_failing_case_is_named_and_none_hides_another() -> None:
    with pytest.raises(ExceptionGroup) as caught:
        equal(tmp_path=None)
    assert [failure.__notes__ for failure in caught.value.exceptions] == [["in the case 1, 2"], ["in the case 3, 4"]]


def test_fixtures_and_marks_stay_those_of_the_test() -> None:
    assert list(inspect.signature(equal).parameters) == ["tmp_path"]
    assert [mark.name for mark in equal.pytestmark] == ["slow"]  # type: ignore[attr-defined]


def test_a_test_without_cases_is_refused() -> None:
    with pytest.raises(AssertionError):
        each("a", [])
