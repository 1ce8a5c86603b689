"""The command line as a user types it, and two runs for several tests."""

from __future__ import annotations

from pathlib import Path

import pytest
from typed_commands import CIRCLE, ON_XYZ, PART, SCHEMES, Finished, Run, Said, invoke


@pytest.fixture
def contourlab(tmp_path: Path) -> Run:
    """Run the command in an empty folder, as typed."""

    def run(*words: str | Path, **how: object) -> Said:
        return invoke(tmp_path, *words, **how)  # type: ignore[arg-type]

    return run


@pytest.fixture(scope="session")
def circle(tmp_path_factory: pytest.TempPathFactory) -> Finished:
    """The circle under two schemes, one of which fails its tolerance, with ``--json``."""
    place = tmp_path_factory.mktemp("circle")
    (place / "circle.toml").write_text(CIRCLE + SCHEMES, encoding="utf-8")
    return Finished(place / "results", invoke(place, "run", "circle.toml", "--out", "results", "--json"))


@pytest.fixture(scope="session")
def part(tmp_path_factory: pytest.TempPathFactory) -> Finished:
    """A part program on the three-axis machine."""
    place = tmp_path_factory.mktemp("part")
    (place / "part.ngc").write_text(PART, encoding="utf-8")
    return Finished(place / "results", invoke(place, "run", "part.ngc", *ON_XYZ, "--out", "results"))
