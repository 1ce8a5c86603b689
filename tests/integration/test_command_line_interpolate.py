"""``contourlab interpolate`` as typed: files of signals in; constants, counts and a picture out; faults with their line."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path

import numpy as np
import pytest
from typed_commands import Run, contents

TURN = 2.0 * math.pi
PITCH = 20e-6
OFFSETS, RATIO, PHASE = (0.03, -0.02), 1.08, 0.06


def motion(n: int = 8000) -> np.ndarray:
    """Move to and fro over some 60 pitches."""
    return 30.0 * PITCH * np.sin(np.linspace(0.0, 2.3 * math.pi, n))


def signals(x: np.ndarray, noise: float = 0.0, size: float = 0.5) -> tuple[np.ndarray, np.ndarray]:
    """Return the signals of the model, written independently [V]."""
    rng = np.random.default_rng(8)
    phase = TURN * x / PITCH
    u1 = size * np.cos(phase) + OFFSETS[0] + noise * rng.normal(size=x.size)
    u2 = size * np.sin(phase - PHASE) / RATIO + OFFSETS[1] + noise * rng.normal(size=x.size)
    return u1, u2


def write(file: Path, head: str, *columns: np.ndarray) -> Path:
    np.savetxt(file, np.column_stack(columns), delimiter=",", header=head, comments="", fmt="%.12g")
    return file


@pytest.fixture
def record(tmp_path: Path) -> Path:
    x = motion()
    return write(tmp_path / "signals.csv", "t [s],u1 [V],u2 [V],reference [um]", 1e-4 * np.arange(x.size), *signals(x), 1e6 * x)


def test_constants_errors_and_counts(contourlab: Run, record: Path, tmp_path: Path) -> None:
    said = contourlab("interpolate", "signals.csv", "--pitch", "20um", "--resolution", "25nm", "--out", "found", "--json").answer
    found = json.loads(said)
    constants = found["constants"]
    assert [constants["offset_1"], constants["offset_2"]] == pytest.approx(OFFSETS, abs=1e-10)
    assert (constants["ratio"], constants["phase_error"], constants["amplitude"]) == pytest.approx((RATIO, PHASE, 0.5), abs=1e-10)
    assert (constants["unit"], found["order"], found["missed"]["n_sample"]) == ("V", 200, 0)
    errors = found["subdivisional_error"]
    assert errors["against"] == "reference"
    assert errors["before"]["orders"][0] == pytest.approx(math.hypot(*OFFSETS) / 0.5 * PITCH / TURN, rel=0.1)
    assert errors["before"]["peak"] > 300e-9
    assert errors["after"]["peak"] < 0.2 * 25e-9
    written = json.loads((tmp_path / "found" / "interpolation.json").read_text(encoding="utf-8"))
    assert written == found
    table = np.loadtxt(tmp_path / "found" / "interpolated.csv", delimiter=",", skiprows=3)
    x = motion()
    exact = x / 25e-9
    sure = np.abs(exact - np.floor(exact) - 0.5) > 1e-3
    assert np.array_equal(table[sure, 1], np.rint(exact[sure]))
    np.testing.assert_allclose(table[:, 2], 25e-9 * table[:, 1], rtol=1e-11)
    np.testing.assert_allclose(table[:, 0], 1e-4 * np.arange(x.size), rtol=1e-6, atol=1e-12)
    assert (tmp_path / "found" / "interpolation.png").read_bytes().startswith(b"\x89PNG")
    assert sorted(path.name for path in (tmp_path / "found").iterdir()) == ["interpolated.csv", "interpolation.json", "interpolation.png"]


def test_words_for_people_and_nothing_written_without_out(contourlab: Run, record: Path, tmp_path: Path) -> None:
    before = contents(tmp_path)
    said = contourlab("interpolate", "signals.csv", "--pitch", "20 um", "--resolution", "25 nm").answer
    assert re.search(r"offsets\s+0\.03 and -0\.02 V", said)
    assert re.search(r"error before\s+36\d\.?\d* nm peak", said)
    assert "CL450" not in said
    assert contents(tmp_path) == before


def test_the_recursive_fit_under_noise_without_a_reference(contourlab: Run, tmp_path: Path) -> None:
    x = 400.0 * PITCH * np.sin(np.linspace(0.0, 2.3 * math.pi, 40_000))
    write(tmp_path / "signals.csv", "sin,cos", *signals(x, 0.002)[::-1])
    found = json.loads(contourlab("interpolate", "signals.csv", "--forgetting", "0.998", "--json").answer)
    assert found["columns"] == ["cos", "sin"]
    assert found["method"] == "recursive" and found["updates"] > 1000
    constants = found["constants"]
    # Noise leaves its size times sqrt(1 - lambda); allow four times that.
    assert [constants["offset_1"], constants["offset_2"]] == pytest.approx(OFFSETS, abs=4.0 * 0.002 * math.sqrt(1.0 - 0.998))
    errors = found["subdivisional_error"]
    assert errors["against"] == "shape"
    assert errors["before"]["peak"] > 300e-9 > 50.0 * errors["after"]["peak"]
    assert {one["code"] for one in found["findings"]} == {"CL453", "CL454"}


@pytest.mark.parametrize(
    ("text", "options"),
    [
        ("{0:.9f};{1:.9f}", []),
        ("{0:.9f} {1:.9f}", []),
        ('"{0:.9f}","{1:.9f}"', []),
        ("{2}\t{1:.9f}\t{0:.9f}", ["--columns", "3,2"]),
    ],
    ids=["decimal commas", "blanks", "quoted", "columns by number"],
)
def test_files_come_in_many_forms(contourlab: Run, tmp_path: Path, text: str, options: list[str]) -> None:
    rows = [text.format(a, b, i) for i, (a, b) in enumerate(zip(*signals(motion(2000)), strict=True))]
    if ";" in text:
        rows = [row.replace(".", ",") for row in rows]
    (tmp_path / "signals.csv").write_text("# recorded on the bench\n\n" + "\r\n".join(rows) + "\n", encoding="utf-8")
    constants = json.loads(contourlab("interpolate", "signals.csv", *options, "--json").answer)["constants"]
    assert (constants["offset_1"], constants["ratio"]) == pytest.approx((OFFSETS[0], RATIO), abs=1e-7)


def test_missed_periods_are_reported_with_exit_code_1(contourlab: Run, tmp_path: Path) -> None:
    speed = np.concatenate([np.linspace(0.0, 0.7, 500), np.linspace(0.7, 0.0, 500)])
    x = PITCH * np.cumsum(speed)
    write(tmp_path / "signals.csv", "u1,u2", *signals(x))
    said = contourlab("interpolate", "signals.csv")
    assert (said.code, said.err) == (1, "")
    line = int(re.search(r"CL450 .*line\s+(\d+)", said.out)[1])  # type: ignore[index]
    # Sample i is in line i + 2, below the header.
    assert 0.49 < speed[line - 2] < 0.52
    write(tmp_path / "signals.csv", "u1,u2,reference [m]", *signals(x), x)
    found = json.loads(contourlab("interpolate", "signals.csv", "--json").out)
    assert found["missed"]["first_line"] == line
    assert found["missed"]["n_sample"] > 200  # the reference reveals every one of them


GOOD = [f"{a:.9f},{b:.9f}" for a, b in zip(*signals(motion(300)), strict=True)]
STILL = [f"{0.3 + 0.001 * math.sin(1.7 * i * i):.6f},{-0.2 + 0.001 * math.cos(2.3 * i * i):.6f}" for i in range(300)]
ARC = [f"{math.cos(0.005 * i):.9f},{math.sin(0.005 * i):.9f}" for i in range(300)]

FAULTS = {
    "no number": ("u1,u2\n" + "\n".join([*GOOD[:40], "0.1,0.2x", *GOOD[40:]]), r"bad\.csv:42: '0\.2x' in column 'u2'"),
    "nan": ("u1,u2\n\n" + "\n".join([*GOOD[:5], "nan,0.2", *GOOD[5:]]), r"bad\.csv:8: .*column u1"),
    "infinite": ("\n".join([*GOOD[:5], "0.1,inf"]), r"bad\.csv:6: .*2"),
    "short row": ("u1,u2\n" + "\n".join([*GOOD[:7], "0.1", *GOOD[7:]]), r"bad\.csv:9: .*columns"),
    "few": ("u1,u2\n" + "\n".join(GOOD[:10]), r"bad\.csv: signals = .*at least 16 samples"),
    "empty": ("", r"bad\.csv: is an empty file"),
    "header only": ("u1,u2\n", r"bad\.csv:1: .*rows"),
    "still": ("u1,u2\n" + "0.3,0.2\n" * 300, r"bad\.csv: u1 = 0\.3 throughout: .*stands still"),
    "still with noise": ("u1,u2\n" + "\n".join(STILL), r"bad\.csv: scatter .*no ellipse"),
    "arc": ("u1,u2\n" + "\n".join(ARC), r"bad\.csv: signals = .*move a pitch"),
    "one column": ("u1\n1\n2\n", r"bad\.csv: unknown signal columns"),
    "three unnamed": ("1,2,3\n4,5,6\n", r"bad\.csv: unknown signal columns.*--columns.*there are: 1, 2, 3"),
    "twice": ("u1,u1\n1,2\n", r"bad\.csv: .*"),
    "units differ": ("u1 [V],u2 [mV]\n" + "\n".join(GOOD), r"bad\.csv: u1 is in V, u2 in mV"),
    "reference without unit": ("u1,u2,reference\n" + "\n".join(row + ",1" for row in GOOD), r"bad\.csv: column reference has no unit"),
    "reference in volts": (
        "u1,u2,reference [V]\n" + "\n".join(row + ",1" for row in GOOD),
        r"bad\.csv: column reference: .*cannot be conv",
    ),
}


@pytest.mark.parametrize("name", FAULTS)
def test_a_bad_file_is_2_with_its_place(contourlab: Run, tmp_path: Path, name: str) -> None:
    text, words = FAULTS[name]
    (tmp_path / "bad.csv").write_text(text, encoding="utf-8")
    said = contourlab("interpolate", "bad.csv", "--out", "found").refusal
    assert re.fullmatch(rf"contourlab: .*{words}.*\n", said), said
    assert [path.name for path in tmp_path.iterdir()] == ["bad.csv"]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--resolution", "30nm"], "four times a whole number, such as 2.99"),
        (["--pitch", "20"], "--pitch = '20': must be a length with its unit, such as \"20 um\""),
        (["--resolution", "20 kg"], 'such as "25 nm"'),
        (["--columns", "u1"], "two names"),
        (["--columns", "u1,u1"], "given twice"),
        (["--columns", "u1,u7"], "no column 'u7'; there are: t, u1, u2, reference"),
        (["--forgetting", "1.5"], "forgetting = 1.5: must be from 0.9 to 1"),
        (["--columns", "u2,u1"], "wrong order: give --columns u1,u2"),
        (["--pitch", "40um"], "a pitch of 20 um would fit, not 40 um"),
        (["--out", "signals.csv/x"], "signals.csv/x"),
    ],
)
def test_wrong_options_are_2_and_nothing_is_written(contourlab: Run, record: Path, tmp_path: Path, options: list[str], words: str) -> None:
    before = contents(tmp_path)
    assert words in contourlab("interpolate", "signals.csv", "--out", "found", *options).refusal
    assert contents(tmp_path) == before


def test_a_file_that_is_not_there(contourlab: Run) -> None:
    said = contourlab("interpolate", "none.csv").refusal
    assert said.startswith("contourlab: none.csv: ") and said.count("\n") == 1


@pytest.mark.slow
def test_a_million_samples(contourlab: Run, tmp_path: Path) -> None:
    x = motion(1_000_000)
    write(tmp_path / "signals.csv", "u1,u2", *signals(x, 0.002))
    said = contourlab("interpolate", "signals.csv", "--forgetting", "0.9995", "--out", "found", "--json").answer
    assert json.loads(said)["n_sample"] == 1_000_000
