"""Numbered and named parameters of a part program: #1, #<name>, and the few that the interpreter itself keeps."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from contourlab.program.fault import BlockError

__all__ = ["LARGEST_PARAMETER", "Key", "Parameters"]

LARGEST_PARAMETER = 5601
_FIRST_OF_THE_SYSTEM = 5061
_SELECTED_SYSTEM = 5220
_POSITION = (5420, 5421, 5422)

Key: TypeAlias = int | str
"""Number of a parameter, or its name in small letters without blanks."""


class Parameters:
    """The values that a program has set. Numbered ones are 0 until then, named ones are not there.

    Parameters
    ----------
    position : callable
        Returns the programmed point in the units in force, for #5420 to #5422.
    """

    def __init__(self, position: Callable[[], tuple[float, float, float]] = lambda: (0.0, 0.0, 0.0)) -> None:
        self._position = position
        self._numbered: dict[int, float] = {}
        self._named: dict[str, float] = {}

    def read(self, key: Key, column: int) -> float:
        """Return a parameter's value.

        Raises
        ------
        BlockError
            If there is no such number, or nothing was ever given this name.
        """
        if isinstance(key, str):
            if key not in self._named:
                raise BlockError(f"#<{key}> has no value yet: write #<{key}> = ... on a line before", column)
            return self._named[key]
        _check_number(key, column)
        if key in _POSITION:
            return self._position()[key - _POSITION[0]]
        # The work offsets are all zero, and the first of them is in force.
        return self._numbered.get(key, 1.0 if key == _SELECTED_SYSTEM else 0.0)

    def exists(self, name: str) -> bool:
        """Tell whether a named parameter has a value."""
        return name in self._named

    def check(self, key: Key, column: int) -> None:
        """Refuse what a program cannot set.

        Raises
        ------
        BlockError
            If there is no such number, or if it stands for offsets and tools.
        """
        if isinstance(key, str):
            return
        _check_number(key, column)
        if key >= _FIRST_OF_THE_SYSTEM:
            raise BlockError(f"#{key} is one of the interpreter's own (offsets, tools, position): setting it is not supported yet", column)

    def write(self, key: Key, value: float) -> None:
        """Set a parameter that `check` has let pass."""
        if isinstance(key, str):
            self._named[key] = value
        else:
            self._numbered[key] = value


def _check_number(number: int, column: int) -> None:
    if not 1 <= number <= LARGEST_PARAMETER:
        raise BlockError(f"there is no parameter #{number}: they go from #1 to #{LARGEST_PARAMETER}", column)
