"""Independent work on all processors."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

Item = TypeVar("Item")
Found = TypeVar("Found")
MOST = 8  # each item in work has its own memory


def in_threads(work: Callable[[Item], Found], items: Iterable[Item], threads: int | None = None) -> Iterator[Found]:
    """Yield ``work(item)`` of each item in order; by default up to `MOST` at once, but no more than there are processors.

    Threads help where the work is done by NumPy or in machine code.
    """
    items = list(items)
    workers = min(len(items), threads or min(os.cpu_count() or 1, MOST))
    if workers < 2:
        yield from map(work, items)
        return
    with ThreadPoolExecutor(workers) as pool:
        yield from pool.map(work, items)
