"""Small studies for the tests of `sweep`: two seconds of motion, chunks of 32 variants."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from typed_commands import SCHEMES

from contourlab.cli.main import main
from contourlab.features.sweep.store import MANIFEST, read_manifest
from contourlab.result.record import write_record

SCENARIO = (
    """\
machine = "builtin:ghaffari/a3a1"
controller = "builtin:ghaffari/calibrated"
[contour]
name = "circle"
radius = "20 mm"
[feed]
law = "uniform"
frequency = "0.5 Hz"
[run]
tolerance = "27.8 um"
start = "moving"
"""
    + SCHEMES
)
STUDY = """\
scenario = "scenario.toml"
scheme = "all of it"
variants = 100
chunk = 32
seed = 3
[vary]
"axes.*.friction.coulomb" = { normal = ["100 %", "20 %"] }
"axes.1.plant.gain" = { uniform = ["90 %", "110 %"] }
"""


def made_study(folder: Path, text: str = STUDY, name: str = "study.toml") -> Path:
    """Write a study and its scenario; return the study."""
    (folder / "scenario.toml").write_text(SCENARIO, encoding="utf-8")
    (folder / name).write_text(text, encoding="utf-8")
    return folder / name


def asked(capsys: pytest.CaptureFixture[str], *words: str, code: int = 0) -> Any:
    """Run ``contourlab sweep`` with ``--json`` and return what it prints."""
    capsys.readouterr()
    assert main(["sweep", *words, "--json"]) == code
    return json.loads(capsys.readouterr().out)


def as_older(store: Path) -> None:
    """Turn a store into one of the form before: digests cover the bytes of each file alone, and the manifest has none."""
    manifest = json.loads((store / "manifest.json").read_text())
    del manifest["digest"]
    (store / "manifest.json").write_text(json.dumps({**manifest, "schema": "contourlab-sweep/1"}))
    for file in store.glob("part-*"):
        file.rename(file.with_name(f"{file.name[:12]}{hashlib.sha256(file.read_bytes()).hexdigest()[:16]}.parquet"))


def forged(store: Path, change: Callable[[str], str]) -> None:
    """Change the scenario in the manifest of a store, as one who knows its digest."""
    manifest = read_manifest(store)
    structures = [replace(one, scenario=change(one.scenario)) for one in manifest.structures]
    write_record(store / MANIFEST, replace(manifest, structures=structures))


def exported(store: Path) -> bytes:
    """Return the rows of a store as CSV."""
    file = store.with_suffix(".csv")
    assert main(["sweep", "export", str(store), "--to", str(file)]) == 0
    return file.read_bytes()
