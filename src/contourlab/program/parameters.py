"""Numbered and named parameters of a part program: #1, #<name>, and those that the interpreter itself keeps."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TypeAlias

from contourlab.program.vocabulary import BlockError

LARGEST_PARAMETER = 5601
SELECTED_SYSTEM = 5220
LOCAL = range(1, 31)
"""Each call of a subprogram has its own of these."""
_POSITION = (5420, 5421, 5422)
_READ_ONLY = frozenset((*range(5400, 5414), *range(5420, 5429)))

Key: TypeAlias = int | str
"""Number of a parameter, or its name in small letters without blanks."""


class Parameters:
    """The values that a program has set. Numbered ones are 0 until then, named ones are not there.

    Parameters
    ----------
    position : callable
        Returns the programmed point in the units in force, for #5420 to #5422.
    own : mapping, optional
        Names that the interpreter keeps, with what returns their values.

    Attributes
    ----------
    returned : float or None
        What the last subprogram returned.
    changes : int
        How often anything was set.
    """

    def __init__(
        self,
        position: Callable[[], tuple[float, float, float]] = lambda: (0.0, 0.0, 0.0),
        own: Mapping[str, Callable[[], float]] | None = None,
    ) -> None:
        self.position = position
        self.own = own or {}
        self._numbered: dict[int, float] = {SELECTED_SYSTEM: 1.0}
        self._global: dict[str, float] = {}
        self._local: dict[str, float] = {}
        self._callers: list[tuple[dict[str, float], dict[int, float] | None]] = []
        self.returned: float | None = None
        self.changes = 0

    @property
    def depth(self) -> int:
        """How many calls one is in."""
        return len(self._callers)

    def read(self, key: Key, column: int) -> float:
        """Return a parameter's value.

        Raises
        ------
        BlockError
            If there is no such number, or nothing was ever given this name.
        """
        if isinstance(key, str):
            if key in self.own:
                return self.own[key]()
            names = self._names(key)
            if key not in names:
                raise BlockError(f"#<{key}> has no value yet: write #<{key}> = ... on a line before", column)
            return names[key]
        _check_number(key, column)
        return self.number(key)

    def number(self, key: int) -> float:
        """Return the value of a numbered parameter that is known to exist."""
        if key in _POSITION:
            return self.position()[key - _POSITION[0]]
        return self._numbered.get(key, 0.0)

    def exists(self, name: str) -> bool:
        """Tell whether a named parameter has a value."""
        return name in self.own or name in self._names(name)

    def check(self, key: Key, column: int) -> None:
        """Refuse what a program cannot set.

        Raises
        ------
        BlockError
            If there is no such number, or if it stands for the tool or the position.
        """
        if isinstance(key, str):
            if key in self.own:
                raise BlockError(f"#<{key}> is the interpreter's own, a program cannot set it: choose another name", column)
            return
        _check_number(key, column)
        if key in _READ_ONLY:
            raise BlockError(f"#{key} is the interpreter's own (tool, position), a program cannot set it: choose another number", column)

    def give_back(self, value: float | None) -> None:
        """Keep what a subprogram returns."""
        self.returned, self.changes = value, self.changes + 1

    def write(self, key: Key, value: float) -> None:
        """Set a parameter that `check` has let pass."""
        self.changes += 1
        if isinstance(key, str):
            self._names(key)[key] = value
        else:
            self._numbered[key] = value

    def point(self, first: int) -> tuple[float, float, float]:
        """Return the lengths [m] in three parameters in mm."""
        x, y, z = (self.number(first + axis) / 1000.0 for axis in range(3))
        return (x, y, z)

    def write_point(self, first: int, point: tuple[float, float, float]) -> None:
        """Set three parameters in mm to lengths [m]."""
        for axis in range(3):
            self.write(first + axis, point[axis] * 1000.0)

    def _names(self, key: str) -> dict[str, float]:
        return self._global if key.startswith("_") else self._local

    def enter(self, arguments: list[float] | None) -> None:
        """Enter a subprogram: names of its own, and #1 to #30 with the arguments in front (None: those of the caller, as M98 has it)."""
        numbers = None
        if arguments is not None:
            numbers = {number: self._numbered.get(number, 0.0) for number in LOCAL}
            for number in LOCAL:
                self._numbered[number] = arguments[number - 1] if number <= len(arguments) else 0.0
        self._callers.append((self._local, numbers))
        self._local = {}

    def leave(self) -> None:
        """Return to the caller's."""
        self._local, numbers = self._callers.pop()
        if numbers is not None:
            self._numbered |= numbers


def _check_number(number: int, column: int) -> None:
    if not 1 <= number <= LARGEST_PARAMETER:
        raise BlockError(f"there is no parameter #{number}: they go from #1 to #{LARGEST_PARAMETER}", column)
