"""``contourlab export`` as a user types it."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import pytest
from typed_commands import invoke

from contourlab.app.results import SAFETY
from contourlab.features.export.command import export
from contourlab.features.export.options import LANGUAGES

SCENARIO = """
name = "circle"
machine = "builtin:xyz"
[controller]
file = "builtin:xyz-controller"
coupling = "none"
[contour]
name = "circle"
radius = "20 mm"
[feed]
feedrate = "2 m/min"
"""


@pytest.fixture
def scenario(tmp_path: Path) -> Path:
    file = tmp_path / "circle.toml"
    file.write_text(SCENARIO)
    return file


def test_files_and_json(tmp_path: Path, scenario: Path) -> None:
    said = invoke(tmp_path, "export", scenario, "--to", "c99", "--axis", "y", "--out", "code", "--json")
    made = json.loads(said.out)
    assert said.code == 0
    assert {Path(name).name for name in made["files"]} == {path.name for path in (tmp_path / "code").glob("*[!.]*") if path.name[0] != "."}
    assert [field["name"] for field in made["axes"]["y"]["outputs"]] == ["command"]
    assert {field["name"]: field["value"] for field in made["axes"]["y"]["parameters"]}["drive_limit"] == 10.0
    assert {finding["code"] for finding in made["findings"]} == {"CL952", "CL954"}
    assert all(made["hash"] in (tmp_path / "code" / name).read_text() for name in ("axis_y.c", "axis_y.h", "export-c99.json"))
    assert len((tmp_path / "code" / "axis_y_run.csv").read_text().splitlines()) == 2001


@pytest.mark.parametrize("to", sorted(LANGUAGES))
def test_every_exported_controller_says_that_it_is_no_safety_function(tmp_path: Path, scenario: Path, to: str) -> None:
    exported = export(scenario, to=to, axis="y").save(tmp_path / "code")
    texts = {}
    for file in exported.files:
        if file.suffix == ".fmu":
            with zipfile.ZipFile(file) as unit:
                texts |= {name: unit.read(name).decode() for name in unit.namelist() if name.endswith(("modelDescription.xml", ".c", ".h"))}
        elif file.suffix not in (".csv", ".json", "") and "bench" not in file.name:
            texts[file.name] = file.read_text()
    assert texts and all(SAFETY in " ".join(text.split()) for text in texts.values()), texts.keys()


def test_a_controller_takes_its_machine(tmp_path: Path) -> None:
    words = ("export", "builtin:ghaffari/calibrated", "--to", "c99", "--out", "code")
    assert invoke(tmp_path, *words).code == 2
    refused = invoke(tmp_path, *words, "--machine", "builtin:ghaffari/a3a1")
    assert refused.code == 2
    assert "controller.coupling" in refused.err
    assert not (tmp_path / "code").exists()


@pytest.mark.parametrize("words", [("--to", "cobol"), ("--to", "c99", "--axis", "w"), ("--to", "c99", "--scheme", "none")])
def test_wrong_words_are_refused(tmp_path: Path, scenario: Path, words: tuple[str, ...]) -> None:
    assert invoke(tmp_path, "export", scenario, *words, "--out", "code").code == 2
    assert not (tmp_path / "code").exists()


@pytest.mark.slow
def test_files_of_others_stay(tmp_path: Path, scenario: Path) -> None:
    own = tmp_path / "code" / "axis_x.c"
    own.parent.mkdir()
    own.write_text("mine")
    assert invoke(tmp_path, "export", scenario, "--to", "c99", "--out", "code").code == 2
    assert own.read_text() == "mine"
    own.unlink()
    assert invoke(tmp_path, "export", scenario, "--to", "c99", "--out", "code").code == 0
    assert invoke(tmp_path, "export", scenario, "--to", "c99", "--out", "code", "--axis", "x").code == 0
    assert not (tmp_path / "code" / "axis_y.c").exists()
