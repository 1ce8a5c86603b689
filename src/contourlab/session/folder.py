"""The folder of the results: newer ones replace older ones together, or not at all."""

from __future__ import annotations

import shutil
import signal
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from contourlab.errors import OutputError

__all__ = ["staged"]

KEPT = "learned/*.nc"
"""What is no report but a product: each replaces an older one of its own name only."""
_PLOTS = ("plots/*.png", "plots/*.svg", "plots/*.pdf")
OURS = ("report.html", "signals/*.nc", "switches/*.csv", KEPT, "controllers/*.toml", *_PLOTS, "swap.json", "summary.json")
"""What a run writes; the summary comes last, so that where it is the rest is complete."""


@contextmanager
def staged(out: str | Path) -> Iterator[Path]:
    """Give a folder to write results into; when the block ends well they take the place of older ones in `out`.

    Files that no run writes are left alone. After an error or an interrupt `out` is as it was.

    Raises
    ------
    OutputError
        If the folder cannot be made or written to; found before the block begins.
    """
    folder = Path(out)
    made = [path for path in (folder, *folder.parents) if not path.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        stage = Path(tempfile.mkdtemp(dir=folder, prefix=".contourlab-"))
    except OSError as error:
        raise OutputError(f"{folder}: cannot be written: {error.strerror or error}; choose another folder with --out") from error
    try:
        yield stage
        with _undisturbed():
            _exchange(stage, folder)
    finally:
        shutil.rmtree(stage, ignore_errors=True)
        for path in made:
            with suppress(OSError):
                path.rmdir()  # goes only where it is empty


def _exchange(stage: Path, folder: Path) -> None:
    """Move older results into the stage, which is thrown away, and newer ones out of it: renames on one disk, a matter of milliseconds."""
    new = [path for pattern in OURS for path in sorted(stage.glob(pattern))]
    old = [path for pattern in OURS if pattern != KEPT for path in sorted(folder.glob(pattern))]
    try:
        for number, path in enumerate(old):
            path.replace(stage / f"old-{number}")
        for path in new:
            target = folder / path.relative_to(stage)
            target.parent.mkdir(exist_ok=True)
            path.replace(target)
    except OSError as error:
        raise OutputError(f"{folder}: cannot be written: {error.strerror or error}") from error
    for name in ("signals", "switches", "learned", "controllers", "plots"):
        with suppress(OSError):
            (folder / name).rmdir()


@contextmanager
def _undisturbed() -> Iterator[None]:
    """Hold an interrupt back until the block has ended."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    held: list[Any] = []
    before = signal.signal(signal.SIGINT, lambda *told: held.append(told))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
    if held:
        raise KeyboardInterrupt
