"""A damaged or hostile log costs little and ends in one clear error."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest
from refusals import refuses
from scipy.io import savemat

from contourlab.errors import LogError, ParameterError
from contourlab.logs import formats, read_record, reading


@pytest.fixture
def mat(tmp_path: Path) -> Path:
    savemat(tmp_path / "a.mat", {"t": np.arange(5.0), "x": np.zeros(10_000)}, do_compression=True)
    return tmp_path / "a.mat"


@pytest.mark.parametrize("code", ["import os; os.abort()", "import sys; sys.exit(3)", "pass", "print('{', end='')"])
def test_a_crash_of_a_library_is_an_error_of_the_file(mat: Path, monkeypatch: pytest.MonkeyPatch, code: str) -> None:
    monkeypatch.setattr(formats, "_CODE", code)
    with refuses(LogError, "matlab", file=mat):
        read_record(mat)


def test_a_library_that_does_not_end_is_stopped(mat: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(formats, "_CODE", "import time; time.sleep(60)")
    monkeypatch.setenv(reading.SETTING, "0.005")
    with refuses(LogError, f"0.3 s.*{reading.SETTING}=1", file=mat):
        read_record(mat)


@pytest.mark.slow
def test_memory_is_limited(tmp_path: Path) -> None:
    """A file of 100 kB with 800 MB of zeros."""
    savemat(tmp_path / "a.mat", {"x": np.zeros(100_000_000, dtype=np.int8)}, do_compression=True)
    with refuses(LogError, f"{reading.SETTING}=2", file=tmp_path / "a.mat"):
        read_record(tmp_path / "a.mat")


def test_numbers_are_counted_before_they_are_read(tmp_path: Path) -> None:
    """An HDF5 dataset and a column of Parquet may be larger than any memory."""
    with h5py.File(tmp_path / "a.mat", "w") as stored:
        stored.create_dataset("t", shape=(2_000_000_000,), chunks=(1_000_000,), dtype="f8")
    with refuses(LogError, f"2000000000.*{reading.SETTING}=40", file=tmp_path / "a.mat"):
        read_record(tmp_path / "a.mat")


def test_numbers_of_parquet_are_counted(tmp_path: Path) -> None:
    arrow = pytest.importorskip("pyarrow")
    from pyarrow import parquet

    parquet.write_table(arrow.table({"on": np.zeros(60_000_000, dtype=bool)}), tmp_path / "a.parquet")
    with refuses(LogError, f"60000000.*{reading.SETTING}=2", file=tmp_path / "a.parquet"):
        read_record(tmp_path / "a.parquet")


@pytest.mark.parametrize("value", ["0", "-1", "nan", "inf", "many"])
def test_the_setting_is_a_positive_factor(mat: Path, monkeypatch: pytest.MonkeyPatch, value: str) -> None:
    monkeypatch.setenv(reading.SETTING, value)
    with refuses(ParameterError, "factor", name=reading.SETTING, value=repr(value)):
        read_record(mat)


def test_version_7_3_reads_no_other_file(tmp_path: Path) -> None:
    (tmp_path / "secret").write_bytes(bytes(range(100)))
    with h5py.File(tmp_path / "other.h5", "w") as other:
        other["x"] = np.arange(9.0)
    layout = h5py.VirtualLayout((9,), "f8")
    layout[:] = h5py.VirtualSource(tmp_path / "other.h5", "x", (9,))
    with h5py.File(tmp_path / "a.mat", "w") as stored:
        stored["t"] = np.arange(3.0)
        stored["linked"] = h5py.ExternalLink(tmp_path / "other.h5", "/x")
        stored.create_dataset("raw", (100,), dtype="u1", external=[(tmp_path / "secret", 0, 100)])
        stored.create_virtual_dataset("virtual", layout)
    assert read_record(tmp_path / "a.mat").names == ["t"]


@pytest.mark.slow
def test_items_that_contain_themselves(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "group.mat", "w") as stored:
        group = stored.create_group("a")
        group["self"] = group
    with h5py.File(tmp_path / "reference.mat", "w") as stored:
        cell = stored.create_dataset("r", (1,), dtype=h5py.ref_dtype)
        cell[0] = cell.ref
    for name in ("group", "reference"):
        with refuses(LogError, "itself", file=tmp_path / f"{name}.mat"):
            read_record(tmp_path / f"{name}.mat")


@pytest.mark.slow
def test_a_matrix_of_many_columns(tmp_path: Path) -> None:
    savemat(tmp_path / "a.mat", {"x": np.zeros((20_000, 20_000), dtype=bool)}, do_compression=True)
    with refuses(LogError, f"columns.*{reading.SETTING}=2", file=tmp_path / "a.mat"):
        read_record(tmp_path / "a.mat")


def test_a_folder_beside_the_log_runs_no_code(mat: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(mat.parent)
    Path("scipy.py").write_text("raise SystemExit(9)\n")
    assert read_record(Path("a.mat")).names == ["t", "x"]


def trace(folder: Path, inside: str, head: str = "") -> Path:
    file = folder / "a.xml"
    signal = '<frameHeader/><dataSignal id="s" name="q" interval="0.000001"/>'
    file.write_text(f'<?xml version="1.0"?>{head}<traceSession><dataFrame>{signal}{inside}</dataFrame></traceSession>')
    return file


def test_held_samples_of_a_trace_are_counted(tmp_path: Path) -> None:
    """3 MB of changes that stand for 90 million samples."""
    file = trace(tmp_path, "".join(f'<rec time="{k * 900e-6:.6f}" s="{k}"/>' for k in range(100_000)))
    with refuses(LogError, f"{reading.SETTING}=4", file=file):
        read_record(file)


@pytest.mark.parametrize("entity", ['"lol"', 'SYSTEM "file:///etc/passwd"'])
def test_a_trace_declares_no_entities(tmp_path: Path, entity: str) -> None:
    file = trace(tmp_path, '<rec time="0" s="1"/>&x;', f"<!DOCTYPE l [<!ENTITY x {entity}>]>")
    with refuses(LogError, "DOCTYPE", file=file):
        read_record(file)


@pytest.mark.parametrize(("kind", "head"), [("csv", "t,x\n"), ("halsampler", ""), ("halscope", "# Sampling period is 1000 ns\na\n")])
def test_a_line_has_a_limit(tmp_path: Path, kind: str, head: str) -> None:
    (tmp_path / "a.csv").write_text(head + "1," * 3_000_000 + "\n")
    with refuses(LogError, f"{reading.SETTING}=6", file=tmp_path / "a.csv", line=head.count("\n") + 1):
        read_record(tmp_path / "a.csv", kind)


def test_a_text_has_a_limit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a.csv").write_text("t [s],x [mm]\n0,1\n1,2\n")
    monkeypatch.setattr(reading, "TEXT", 21)
    assert read_record(tmp_path / "a.csv").names == ["t", "x"]
    monkeypatch.setattr(reading, "TEXT", 20)
    with refuses(LogError, f"set {reading.SETTING}=2", file=tmp_path / "a.csv"):
        read_record(tmp_path / "a.csv")


def test_columns_have_a_limit(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("1,2\n" + ("1," * 25_000 + "1\n") * 3)
    with refuses(LogError, f"25001.*{reading.SETTING}=3", file=tmp_path / "a.csv", line=2):
        read_record(tmp_path / "a.csv")


def test_a_damaged_item_is_not_left_out(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "a.mat", "w") as stored:
        stored["t"], stored["x"] = np.arange(3.0), np.arange(3.0)
        place = h5py.h5o.get_info(stored["x"].id).addr
    with (tmp_path / "a.mat").open("r+b") as stream:
        stream.seek(place)
        stream.write(b"\xff" * 16)
    with refuses(LogError, "matlab", file=tmp_path / "a.mat"):
        read_record(tmp_path / "a.mat")


def test_a_trace_with_many_attributes(tmp_path: Path) -> None:
    file = trace(tmp_path, '<rec time="0" ' + " ".join(f'a{k}="1"' for k in range(20_000)) + "/>")
    with refuses(LogError, f"{reading.SETTING}=3", file=file, line=1):
        read_record(file)
