"""What a long run is busy with, on a terminal: a bar where the end is known, a clock where it is not."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import Progress, TaskID


class Stages:
    """One stage of a run after another; says nothing where nobody looks.

    Parameters
    ----------
    bar : rich.progress.Progress, optional
        Where stages are shown; by default nowhere.
    """

    def __init__(self, bar: Progress | None = None) -> None:
        self._bar = bar
        self._task: TaskID | None = None

    def begin(self, words: str) -> None:
        """End the stage before, if any, and show this one with the time it takes."""
        if self._bar is None:
            return
        if self._task is not None:
            self._bar.remove_task(self._task)
        # A stage without a total is shown as busy, not as empty.
        self._task = self._bar.add_task(words, total=None)

    def advance(self, done: int, total: int) -> None:
        """Show how much of the stage is done."""
        if self._bar is not None and self._task is not None:
            self._bar.update(self._task, completed=done, total=total)


@contextmanager
def shown(wanted: bool, console: Console | None = None) -> Iterator[Stages]:
    """Show stages on standard error while the block runs, and leave nothing behind.

    Parameters
    ----------
    wanted : bool
        Whether anybody looks.
    console : rich.console.Console, optional
        Instead of standard error.
    """
    if not wanted:
        yield Stages()
        return
    from rich.console import Console as Terminal
    from rich.progress import BarColumn, Progress, SpinnerColumn, TaskProgressColumn, TextColumn, TimeElapsedColumn

    # Names of schemes are shown as they are, not as markup.
    columns = (SpinnerColumn(), TextColumn("{task.description}", markup=False), BarColumn(), TaskProgressColumn(), TimeElapsedColumn())
    with Progress(*columns, console=console or Terminal(stderr=True), transient=True) as bar:
        yield Stages(bar)
