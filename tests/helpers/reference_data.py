"""Reference data in a folder `shared` beside the clone. Any folder may have that name: a test asks for each of its files."""

from __future__ import annotations

from pathlib import Path

import pytest

SHARED = Path(__file__).parents[2].parent / "shared"


def reference_file(*names: str) -> Path:
    """Return a file or folder of the reference data; skip the test that lacks it."""
    found = SHARED.joinpath(*names)
    if not found.exists():
        pytest.skip(f"{'/'.join(names)} is not among the reference data in {SHARED.name}, beside the clone")
    return found


def part_programs() -> list[Path]:
    """Return the real part programs of the reference data, each named ``OWNER__PLACE``; none if they are absent."""
    return sorted(file for file in (SHARED / "gcode").glob("*__*") if file.suffix in {".ngc", ".nc", ".gcode"})
