"""The error that the inner parts of the reader raise: they know the column; file and line are added further out."""

from __future__ import annotations


class BlockError(Exception):
    """What is wrong in the block at hand, and its column (from 1; 0 = the block as a whole)."""

    def __init__(self, message: str, column: int = 0) -> None:
        self.message, self.column = message, column
        super().__init__(message)
