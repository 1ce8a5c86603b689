"""The command line as a user types it, and two runs for several tests."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from typed_commands import CIRCLE, ON_XYZ, PART, SCHEMES, AsJson, Finished, Refused, Run, Said, invoke

from contourlab.cli.main import main


@pytest.fixture
def contourlab(tmp_path: Path) -> Run:
    """Run the command in an empty folder, as typed."""

    def run(*words: str | Path, **how: object) -> Said:
        return invoke(tmp_path, *words, **how)  # type: ignore[arg-type]

    return run


@pytest.fixture
def as_json(capsys: pytest.CaptureFixture[str]) -> AsJson:
    """Run the command with ``--json`` in the present folder, check its exit code, and return what it prints."""

    def run(*words: str | Path, code: int | tuple[int, ...] = 0) -> Any:
        capsys.readouterr()
        assert main([*map(str, words), "--json"]) in (code if isinstance(code, tuple) else (code,))
        found = json.loads(capsys.readouterr().out)
        if isinstance(found, dict):  # not one that refuses
            assert found.pop("made_by", "made by contourlab").startswith("made by contourlab")
        return found

    return run


@pytest.fixture
def refused(capsys: pytest.CaptureFixture[str]) -> Refused:
    """Run the command in the present folder; it must refuse with exit code 2 and one line, or `lines`, which are returned."""

    def run(*words: str | Path, lines: int = 1) -> str:
        capsys.readouterr()
        assert main([*map(str, words)]) == 2
        said = capsys.readouterr().err
        assert said.count("\n") == lines, said
        return said

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


@pytest.fixture
def old_results(circle: Finished, tmp_path: Path) -> Path:
    """A folder with the results of an older run."""
    folder = tmp_path / "results"
    shutil.copytree(circle.folder, folder)
    return folder
