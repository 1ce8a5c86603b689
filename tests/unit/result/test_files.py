"""Results on disk: they read back to the last bit, or raise a clear error."""

from __future__ import annotations

import tempfile
from itertools import pairwise
from pathlib import Path
from signal import SIGINT, default_int_handler, getsignal, raise_signal
from typing import Any

import h5py
import numpy as np
import pytest
import xarray
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from contourlab.errors import ResultError
from contourlab.result import Result, ResultWriter, Signal, Status
from contourlab.result.netcdf import Spool

# No control characters or surrogates: HDF5 stores text as zero-terminated UTF-8.
TEXT = st.text(st.characters(min_codepoint=32, exclude_categories=["Cs"]), max_size=12)
NAME = st.from_regex(r"[a-z][a-z_0-9]{0,11}", fullmatch=True).filter(lambda name: name not in ("axis", "time", "sample"))
FLOAT = st.floats(width=64, allow_nan=True, allow_infinity=True, allow_subnormal=True)


@st.composite
def results(draw: st.DrawFn) -> Result:
    n_sample, n_axis = draw(st.integers(0, 12)), draw(st.integers(1, 4))
    axes = tuple(draw(st.lists(NAME, min_size=n_axis, max_size=n_axis, unique=True)))
    signals = {}
    for name in draw(st.lists(NAME, min_size=1, max_size=4, unique=True)):
        shape = draw(st.sampled_from([(n_sample,), (n_sample, n_axis)]))
        dims = ("sample", "axis")[: len(shape)]
        signals[name] = Signal(
            draw(arrays(np.float64, shape, elements=FLOAT)), dims, draw(st.sampled_from(["m", "m/s^2", "full_scale", ""]))
        )
    status = Status(draw(st.booleans()), draw(st.integers(-1, 2**62)), draw(TEXT), draw(TEXT))
    value = st.one_of(TEXT, st.integers(-(2**63), 2**63 - 1), st.floats(allow_nan=False), st.booleans())
    attributes = draw(st.dictionaries(NAME, value, max_size=4))
    period = draw(st.floats(1e-7, 1.0))
    return Result(draw(TEXT), axes, period, signals, status, attributes, draw(st.integers(0, 2**40)))


def assert_identical(one: Result, other: Result) -> None:
    head = ("scheme", "axes", "servo_period", "status", "start")
    assert [getattr(one, name) for name in head] == [getattr(other, name) for name in head]
    assert dict(one.attributes) == dict(other.attributes)
    assert set(one.signals) == set(other.signals)
    for name, signal in one.signals.items():
        twin = other.signals[name]
        assert (signal.dims, signal.unit, signal.data.shape) == (twin.dims, twin.unit, twin.data.shape)
        # Compare bytes, so that -0 is not 0 and each NaN keeps its bits.
        assert np.ascontiguousarray(signal.data).tobytes() == np.ascontiguousarray(twin.data).tobytes()


@settings(max_examples=60, deadline=None)
@given(result=results())
@pytest.mark.slow
def test_round_trip(result: Result) -> None:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "run.nc"
        result.save(file)
        assert_identical(result, Result.load(file))


@settings(max_examples=30, deadline=None)
@given(result=results(), data=st.data())
@pytest.mark.slow
def test_blocks_make_one_file(result: Result, data: st.DataObject) -> None:
    """Written in any cuts, empty ones included, a result equals the one written at once."""
    cuts = [0, *sorted(data.draw(st.lists(st.integers(0, result.n_sample), max_size=4))), result.n_sample]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "run.nc"
        with ResultWriter(file, result.header(), result.axes) as writer:
            for start, stop in pairwise(cuts):
                writer.append(result.window(start, stop).signals)
        assert_identical(result, Result.load(file))


def plain(n: int = 5, **attributes: str | int | float) -> Result:
    position = Signal(np.arange(2.0 * n).reshape(n, 2), ("sample", "axis"), "m")
    return Result("base", ("x", "y"), 1e-3, {"position": position}, attributes=attributes)


def test_longer_than_a_chunk(tmp_path: Path) -> None:
    """The blocks do not divide the chunks of the file and span several of them."""
    n = 50_001
    signal = Signal(np.random.default_rng(1).normal(size=(n, 3)), ("sample", "axis"), "m")
    result = Result("long", ("x", "y", "z"), 1e-4, {"position": signal})
    file = tmp_path / "run.nc"
    with ResultWriter(file, result.header(), result.axes) as writer:
        for start in range(0, n, 7_001):
            writer.append(result.window(start, min(start + 7_001, n)).signals)
    assert_identical(result, Result.load(file))
    with h5py.File(file) as raw:
        assert np.array_equal(raw["time"], result.time)


def test_other_programs_read_it(tmp_path: Path) -> None:
    """Plain NetCDF-4: xarray finds the signals with units, and time as index times period from the start of the run."""
    file, result = tmp_path / "run.nc", plain(seed=3).window(2, 5)
    result.save(file)
    with xarray.open_dataset(file, engine="h5netcdf") as data:
        assert data["position"].dims == ("sample", "axis")
        assert data["position"].attrs["units"] == "m"
        assert np.array_equal(data["position"], result["position"])
        assert data["time"].dtype.kind in "fm"
        assert data.attrs["attribute_seed"] == 3
    with h5py.File(file) as raw:
        assert raw["time"][:].tolist() == result.time.tolist()


def test_a_folder_is_made(tmp_path: Path) -> None:
    file = tmp_path / "a" / "b" / "run.nc"
    plain().save(file)
    assert [p.name for p in file.parent.iterdir()] == ["run.nc"]


# --- content that cannot be stored ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("value", [2**64, -(2**70), "text\0with a zero"])
def test_attributes_that_no_file_can_keep(tmp_path: Path, value: str | int) -> None:
    with pytest.raises(ResultError, match="64 bits"):
        plain(seed=value).save(tmp_path / "run.nc")
    assert list(tmp_path.iterdir()) == []


def test_blocks_with_other_signals(tmp_path: Path) -> None:
    """A signal that appears later, or disappears, would have holes."""
    result = plain()
    extra = {**result.signals, "feedrate": Signal(np.zeros(5), ("sample",), "m/s")}
    for first, second in ((result.signals, extra), (extra, result.signals)):
        with (
            pytest.raises(ResultError, match="feedrate"),
            ResultWriter(tmp_path / "r.nc", result.header(), result.axes) as writer,
        ):
            writer.append(first)
            writer.append(second)
    assert list(tmp_path.iterdir()) == []


# --- files that are not results -------------------------------------------------------------------------------------------------


def test_no_such_file(tmp_path: Path) -> None:
    with pytest.raises(ResultError, match=r"none\.nc: "):
        Result.load(tmp_path / "none.nc")


@pytest.mark.parametrize("content", [b"", b"position,velocity\n0,1\n", b"\x89HDF\r\n\x1a\n", b"\x89HDF\r\n\x1a\n" + bytes(4096)])
def test_files_of_another_kind(tmp_path: Path, content: bytes) -> None:
    file = tmp_path / "run.nc"
    file.write_bytes(content)
    with pytest.raises(ResultError, match=r"run\.nc: "):
        Result.load(file)


def test_a_folder_is_no_file(tmp_path: Path) -> None:
    with pytest.raises(ResultError):
        Result.load(tmp_path)


def test_netcdf_of_another_program(tmp_path: Path) -> None:
    file = tmp_path / "sea.nc"
    xarray.Dataset({"temperature": ("time", [1.0, 2.0])}).to_netcdf(file, engine="h5netcdf")
    with pytest.raises(ResultError, match=r"sea\.nc: "):
        Result.load(file)


def test_a_format_of_the_future(tmp_path: Path) -> None:
    file = tmp_path / "run.nc"
    whole = plain()
    with ResultWriter(file, {**whole.header(), "format": "contourlab-result/3"}, whole.axes) as writer:
        writer.append(whole.signals)
    with pytest.raises(ResultError, match="contourlab-result/3"):
        Result.load(file)


def test_every_flipped_bit_is_found(tmp_path: Path) -> None:
    file = tmp_path / "run.nc"
    plain(40).save(file)
    content, draw = file.read_bytes(), np.random.default_rng(1)
    for at in draw.integers(0, 8 * len(content), 400).tolist():
        damaged = bytearray(content)
        damaged[at // 8] ^= 1 << at % 8
        file.write_bytes(damaged)
        with pytest.raises(ResultError):
            Result.load(file)


def test_a_file_that_another_program_changed_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "run.nc"
    plain().save(file)
    with h5py.File(file, "a") as raw:
        raw["position"][0] = 1.0 + raw["position"][0]
    with pytest.raises(ResultError):
        Result.load(file)


def test_truncated_anywhere(tmp_path: Path) -> None:
    """A copy that ends at any byte gives an error of ours, never a result and never a foreign exception."""
    whole = tmp_path / "run.nc"
    plain(200).save(whole)
    content = whole.read_bytes()
    file = tmp_path / "part.nc"
    for size in np.unique(np.linspace(0, len(content) - 1, 60).astype(int)):
        file.write_bytes(content[:size])
        with pytest.raises(ResultError, match=r"part\.nc"):
            Result.load(file)


def test_a_byte_turned_over_in_the_head(tmp_path: Path) -> None:
    """Damage in the head of the file gives our error and does not affect the next file."""
    whole, file = tmp_path / "run.nc", tmp_path / "bad.nc"
    plain(20).save(whole)
    content = whole.read_bytes()
    refused = 0
    # Up to the text of the attributes: beyond them HDF5 keeps no checksums.
    for place in range(0, content.index(b"GCOL"), 9):
        damaged = bytearray(content)
        damaged[place] ^= 0xFF
        file.write_bytes(damaged)
        try:
            Result.load(file)
        except ResultError as error:
            assert "bad.nc" in str(error)
            refused += 1
    assert refused > 0
    file.write_bytes(content)
    assert_identical(Result.load(file), plain(20))


@pytest.mark.parametrize("blocks", [1, 3])
def test_a_file_of_fixed_length_needs_exactly_that_many_samples(tmp_path: Path, blocks: int) -> None:
    result = Result("base", ("x",), 1e-3, {"position": Signal(np.arange(4.0)[:, None], ("sample", "axis"), "m")})
    with (
        pytest.raises(ResultError, match=rf"^{4 * blocks} .*\b8$"),
        ResultWriter(tmp_path / "r.nc", result.header(), ("x",), 8) as writer,
    ):
        for _ in range(blocks):
            writer.append(result.signals)
    assert list(tmp_path.iterdir()) == []
    with ResultWriter(tmp_path / "r.nc", result.header(), ("x",), 8) as writer:
        writer.append(result.signals)
        writer.append(result.signals)
    assert Result.load(tmp_path / "r.nc")["position"][:, 0].tolist() == [0.0, 1.0, 2.0, 3.0] * 2


@pytest.mark.parametrize("number", [1, 3, 6])
def test_ctrl_c_while_hdf5_writes_ends_the_writing_and_leaves_no_file(number: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """HDF5 calls back into Python to write; an interrupt raised there would be lost."""
    write, result = Spool.write, Result("base", ("x",), 1e-3, {"position": Signal(np.zeros((4, 1)), ("sample", "axis"), "m")})
    done: list[int] = []

    def interrupted(spool: Spool, data: Any) -> int:
        done.append(1)
        if len(done) == number:
            raise_signal(SIGINT)
        return write(spool, data)

    monkeypatch.setattr(Spool, "write", interrupted)
    with pytest.raises(KeyboardInterrupt):
        result.save(tmp_path / "run.nc")
    assert len(done) >= number and not list(tmp_path.iterdir()) and getsignal(SIGINT) is default_int_handler
