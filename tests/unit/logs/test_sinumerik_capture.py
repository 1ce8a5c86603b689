"""Captures of a Sinumerik: positions by axis, blocks of the program, axes that turn without end; and files that are none."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from reference_data import reference_file
from refusals import refuses

from contourlab.errors import LogError
from contourlab.findings import finding
from contourlab.logs import load_log, read_record
from contourlab.logs.formats import format_of

N = 200


def capture(**changes: Any) -> dict[str, Any]:
    """Return a capture of two linear axes, an axis that turns on and on, and one whose position jumps back at each turn."""
    k = np.arange(N)
    columns = {
        ("CYCLE", "Cycle"): 7000 + k,
        ("DES_POS|1", "X1"): 0.1 * k,
        ("ENC_POS|1", "X1"): 0.1 * k - 0.01,
        ("CONT_DEV|1", "X1"): 0.0 * k,
        ("DES_POS|2", "S"): 30.0 * np.sin(0.1 * k),
        ("ENC_POS|2", "S"): 30.0 * np.sin(0.1 * k) - 0.02,
        ("ENC_POS|3", "Z1"): 90.0 * k,
        ("ENC_POS|4", "C"): (9.0 * k) % 360.0,
    }
    rows = np.column_stack(list(columns.values())).tolist()
    block = [{"HFProbeCounter": 7000 + at, "SeekOffset": line, "GCode": "", "IpoGC": kind} for at, line, kind in BLOCKS]
    payload = [{"HFData": rows[:50]}, {"HFBlockEvent": block[0]}, {"HFCallEvent": {"Path": "/PART", "SeekOffset": 1}}]
    payload += [{"HFBlockEvent": one} for one in block[1:]] + [{"HFTimestamp": {}}, {"HFData": rows[50:]}]
    header = {"CycleTimeMs": 2, "SignalListHFData": [{"Name": name, "Axis": axis} for name, axis in columns]}
    return {"Header": header | changes, "Payload": payload}


BLOCKS = ((0, 39, "G0"), (40, 10, "G0"), (80, 11, "G1"), (150, 12, "G0"))


def written(folder: Path, content: object) -> Path:
    file = folder / "capture.json"
    file.write_text(json.dumps(content, indent=1), encoding="utf-8")
    return file


def test_positions_blocks_and_what_turns(tmp_path: Path) -> None:
    file = written(tmp_path, capture())
    assert format_of(file).name == "sinumerik-capture"
    log = load_log(file)
    assert log.result.axes == ("S", "X1")
    assert set(log.result.signals) == {"position", "reference"}
    assert log.result.servo_period == pytest.approx(2e-3)
    assert log.result["position"][:, 1] == pytest.approx(1e-4 * np.arange(N) - 1e-5)
    assert finding("CL439", axes=["C", "Z1"]) in log.findings
    assert finding("CL438", unit="mm") in log.findings
    assert log.lines is not None and log.blocks is not None
    assert log.lines.tolist() == [39] * 40 + [10] * 40 + [11] * 70 + [12] * 50
    assert log.blocks.program == ("", "/PART", "/PART", "/PART")
    assert load_log(file, unit="inch").result["position"] == pytest.approx(25.4 * log.result["position"])


def test_a_sample_of_the_gap_belongs_to_no_stretch() -> None:
    """The recording has 3,818 samples in two stretches, 7.7 s apart."""
    file = reference_file("data/sinumerik/capture-840d.json")
    record = read_record(file)
    assert {channel.values.size for channel in record.channels} == {3818}
    with refuses(LogError, r'"0\.\.1493" or --window "1494\.\.3817"', file=file):
        load_log(file)
    late = load_log(file, window="10.706 s..14 s")
    assert late.start == pytest.approx(10.706) and late.result.n_sample == 1648
    assert late.lines is not None and late.lines[:3].tolist() == [511, 511, 511]
    assert {"position.X1", "position.SP1", "reference.C1"} <= {column.target for column in late.columns}
    assert finding("CL439", axes=["B1", "Z1"]) in late.findings
    # Line 22 is one of three programs; the lines of the part begin with 453.
    with refuses(LogError, "_CYCLE714", file=file):
        load_log(file, window="line 20..line 22")
    rapid = load_log(file, window="line 453..line 460")
    assert rapid.lines is not None and set(rapid.lines.tolist()) == {453, 460}


@pytest.mark.parametrize(
    "content",
    [
        {},
        {"Header": {"SignalListHFData": []}, "Payload": []},
        capture(SignalListHFData="CYCLE"),
        capture(CycleTimeMs=None),
        capture(CycleTimeMs=0),
        capture() | {"Payload": [{"HFData": [[1, 2], [3]]}]},
        capture() | {"Payload": [{"HFData": [["one"] * 8]}]},
        capture() | {"Payload": []},
        capture() | {"Payload": [*capture()["Payload"], {"HFBlockEvent": {}}]},
        [1, 2],
    ],
)
def test_a_file_that_is_no_capture(tmp_path: Path, content: object) -> None:
    file = written(tmp_path, content)
    with refuses(LogError, file=file):
        read_record(file, "sinumerik-capture")


def test_a_capture_that_ends_too_early(tmp_path: Path) -> None:
    file = written(tmp_path, capture())
    text = file.read_text(encoding="utf-8")
    file.write_text(text[: len(text) // 2], encoding="utf-8")
    with refuses(LogError, "complete", file=file, line=text.count("\n", 0, len(text) // 2) + 1):
        read_record(file)
    file.write_text('{"SignalListHFData": ' + "[" * 100_000, encoding="utf-8")
    with refuses(LogError, file=file):
        read_record(file)
