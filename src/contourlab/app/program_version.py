"""The program that runs, in so far as it decides figures: what is kept of another one is not used."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from pathlib import Path

DECIDES_RUNS = ("native", "primitives", "geometry", "feed", "engine", "components", "metrics", "loop")
"""Rooms that decide the figures of a run."""


def program_version(rooms: Iterable[str]) -> str:
    """Return the version of contourlab and a digest of some of its rooms, such as ``"loop"`` or ``"features/swap"``."""
    import contourlab

    root = Path(contourlab.__file__).parent
    text = hashlib.sha256()
    for room in rooms:
        single = root / f"{room}.py"
        for file in [single] if single.exists() else sorted((root / room).rglob("*.py")):
            text.update(file.relative_to(root).as_posix().encode() + b"\0" + file.read_bytes())
    return f"contourlab {contourlab.__version__} {text.hexdigest()}"
