"""``contourlab reproduce emps`` as typed, with synthetic logs."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from typed_commands import Run

PERIOD = 1e-3


@pytest.fixture
def held() -> dict[str, object]:
    """The contents of a log: an axis of 80 kg on two sines, its force in volts."""
    t = PERIOD * np.arange(9000)
    w, slow = 2.0 * np.pi * 0.9, 2.0 * np.pi * 0.3
    q = 0.02 * np.sin(w * t) + 0.03 * np.sin(slow * t)
    v = 0.02 * w * np.cos(w * t) + 0.03 * slow * np.cos(slow * t)
    a = -0.02 * w * w * np.sin(w * t) - 0.03 * slow * slow * np.sin(slow * t)
    force = 80.0 * a + 150.0 * v + 15.0 * np.sign(v) + 2.0
    return {"t": t, "qm": q, "qg": q + 1e-4 * v, "vir": force / 35.0, "kp": 160.0, "kv": 240.0, "gtau": 35.0}


def save(file: Path, held: dict[str, object]) -> Path:
    from scipy.io import savemat

    savemat(file, held)
    return file


def test_without_a_log_the_error_names_the_file_and_its_source(contourlab: Run) -> None:
    said = contourlab("reproduce", "emps").refusal
    assert said.startswith("contourlab: --log: ") and said.count("\n") == 1
    assert "DATA_EMPS.mat" in said


def test_bad_input_is_refused_before_anything_is_written(contourlab: Run, tmp_path: Path, held: dict[str, object]) -> None:
    whole = save(tmp_path / "whole.mat", held)
    save(tmp_path / "still.mat", held | {"qm": np.zeros(9000)})
    for words, message in (
        (("--log", "nowhere.mat"), "nowhere.mat: cannot be read: No such file or directory; give DATA_EMPS.mat"),
        (("--log", "still.mat"), "a record in which the axis moves"),
        (("--log", whole, "--validation", "nowhere.mat"), "nowhere.mat: cannot be read"),
        (("--log", whole, "--plots", "bmp"), "bmp"),
    ):
        said = contourlab("reproduce", "emps", *words).refusal
        assert message in said and "Traceback" not in said
    assert {file.name for file in tmp_path.iterdir()} == {"whole.mat", "still.mat"}


@pytest.mark.parametrize(("paper", "option"), [("ghaffari", "--log"), ("gecer-ulu", "--validation"), ("shahin", "--log")])
def test_the_papers_without_a_log_take_none(contourlab: Run, paper: str, option: str) -> None:
    assert option in contourlab("reproduce", paper, option, "log.mat").refusal


@pytest.mark.slow
def test_another_axis_is_identified_and_fails_against_the_paper(contourlab: Run, tmp_path: Path, held: dict[str, object]) -> None:
    """The figures of another log differ from the paper's and fail."""
    file = save(tmp_path / "mine.mat", held)
    said = contourlab("reproduce", "emps", "--log", file, "--validation", file, "--json")
    assert (said.code, said.err) == (1, "")
    rows = {(row["name"], row["case"]): row for row in json.loads(said.out)}
    for name, true in {"M": 80.0, "Fv": 150.0, "Fc": 15.0, "offset": 2.0}.items():
        row = rows[name, "friction alike in both directions"]
        assert row["here"] == pytest.approx(true, rel=5e-3, abs=0.1) and row["pass"] is False
    assert [path.name for path in tmp_path.iterdir()] == ["mine.mat"]
