"""Independent work on all processors."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

Item = TypeVar("Item")
Found = TypeVar("Found")
MOST = 8  # each item in work has its own memory


def in_threads(work: Callable[[Item], Found], items: Iterable[Item], threads: int | None = None) -> list[Found]:
    """Return ``work(item)`` of each item in order; by default up to `MOST` at once, but no more than there are processors.

    Threads help where the work is done by NumPy or in machine code.
    """
    items = list(items)
    workers = min(len(items), threads or min(os.cpu_count() or 1, MOST))
    if workers < 2:
        return list(map(work, items))
    with ThreadPoolExecutor(workers) as pool:
        return list(pool.map(work, items))
