"""A file is whole or unchanged, even if writing it fails."""

from __future__ import annotations

import errno
import os
import stat
import subprocess
import sys
import textwrap
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from contourlab.app.results import check_file
from contourlab.errors import OutputError
from contourlab.result import Result, ResultWriter, Signal, write_bytes_atomic, write_text_atomic
from contourlab.result.netcdf import Spool


def a_result(n: int = 100) -> Result:
    return Result("base", ("x",), 1e-3, {"position": Signal(np.zeros((n, 1)), ("sample", "axis"), "m")})


def full(*args: Any, **kwargs: Any) -> None:
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def only(folder: Path, name: str, content: bytes) -> None:
    """Check that a folder holds one file with its old content."""
    assert [p.name for p in folder.iterdir()] == [name]
    assert (folder / name).read_bytes() == content


def test_text_and_bytes_replace(tmp_path: Path) -> None:
    write_text_atomic(tmp_path / "a.txt", "µm\n")
    write_bytes_atomic(tmp_path / "a.txt", b"new")
    only(tmp_path, "a.txt", b"new")


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such files")
def test_a_device_is_not_replaced(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for write in (lambda file: write_text_atomic(file, "new"), check_file):
        with pytest.raises(OutputError):
            write(tmp_path / "pipe")
    assert (tmp_path / "pipe").is_fifo() and len(list(tmp_path.iterdir())) == 1


def test_line_ends_are_not_touched(tmp_path: Path) -> None:
    write_text_atomic(tmp_path / "a.txt", "é\nb\r\n")
    assert (tmp_path / "a.txt").read_bytes() == b"\xc3\xa9\nb\r\n"


@pytest.mark.skipif(os.name != "posix", reason="modes are those of POSIX")
def test_new_files_have_the_usual_permissions(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        write_bytes_atomic(tmp_path / "a", b"")
        a_result().save(tmp_path / "b.nc")
    finally:
        os.umask(before)
    for name in ("a", "b.nc"):
        assert stat.S_IMODE((tmp_path / name).stat().st_mode) == 0o640


def test_full_disk_while_bytes_are_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a").write_bytes(b"old")
    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(OutputError, match=r"a: .*No space"):
        write_bytes_atomic(tmp_path / "a", b"new")
    only(tmp_path, "a", b"old")


def test_target_that_cannot_be_replaced(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The final rename may fail too: on Windows another program may hold the file open."""
    (tmp_path / "a").write_bytes(b"old")
    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(OutputError):
        write_bytes_atomic(tmp_path / "a", b"new")
    only(tmp_path, "a", b"old")


def test_a_folder_in_the_way(tmp_path: Path) -> None:
    (tmp_path / "run.nc").mkdir()
    with pytest.raises(OutputError, match=r"run\.nc: "):
        a_result().save(tmp_path / "run.nc")
    assert [p.name for p in tmp_path.iterdir()] == ["run.nc"]


def test_a_file_in_place_of_the_folder(tmp_path: Path) -> None:
    (tmp_path / "out").write_bytes(b"")
    with pytest.raises(OutputError, match=r"out/run\.nc"):
        a_result().save(tmp_path / "out" / "run.nc")


@pytest.mark.parametrize("stop", [KeyboardInterrupt, RuntimeError, MemoryError])
def test_an_interrupted_run(tmp_path: Path, stop: type[BaseException]) -> None:
    file, result = tmp_path / "run.nc", a_result()
    file.write_bytes(b"old")
    with pytest.raises(stop), ResultWriter(file, result.header(), result.axes) as writer:
        writer.append(result.signals)
        raise stop("enough")
    only(tmp_path, "run.nc", b"old")


@pytest.mark.parametrize("after", [0, 1, 3, 8, 20])
def test_full_disk_after_some_writes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, after: int) -> None:
    """From the n-th write on the system refuses: the writer raises, the old file stays, and no part of the new one remains."""
    file, result = tmp_path / "run.nc", a_result(40_000)
    file.write_bytes(b"old")
    count = 0
    plain_write = Spool.write

    def write(self: Spool, data: Any) -> int:
        nonlocal count
        count += 1
        if count > after and self.failure is None:
            self.failure = OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return plain_write(self, data)

    monkeypatch.setattr(Spool, "write", write)
    with pytest.raises(OutputError, match=r"run\.nc: .*No space"):
        result.save(file)
    assert count > after
    only(tmp_path, "run.nc", b"old")


def test_spool_reads_back_what_the_disk_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """After a failure the file still reads as whole, part from disk and part from memory; beyond its end there are zeros."""
    with Spool(tmp_path / "s", "w+") as spool:
        spool.write(b"abcdef")
        spool.check()
        spool.failure = OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        spool.seek(4)
        assert spool.write(b"EFGH") == 4
        assert spool.tell() == 8
        spool.seek(6)
        spool.write(b"g")
        buffer = bytearray(b"?" * 10)
        spool.seek(2)
        assert spool.readinto(buffer) == 10
        assert bytes(buffer) == b"cdEFgH" + bytes(4)
        with pytest.raises(OSError) as caught:
            spool.check()
        assert caught.value.errno == errno.ENOSPC
    assert (tmp_path / "s").read_bytes() == b"abcdef"


LIMITED = """
    import resource, sys
    from pathlib import Path
    import numpy as np
    from contourlab.errors import OutputError
    from contourlab.result import Result, ResultWriter, Signal

    folder = Path(sys.argv[1])
    file = folder / "run.nc"
    signal = Signal(np.random.default_rng(0).normal(size=(6000, 2)), ("sample", "axis"), "m")
    result = Result("base", ("x", "y"), 1e-3, {"position": signal, "velocity": signal})
    result.save(file)
    whole, size = file.read_bytes(), file.stat().st_size
    for limit in [0, 1, 100, 5000, *np.linspace(10000, size - 1, 25).astype(int).tolist()]:
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY))
        try:
            with ResultWriter(file, result.header(), result.axes, 6000) as writer:
                for start in range(0, 6000, 1000):
                    writer.append(result.window(start, start + 1000).signals)
        except OutputError as error:
            assert "run.nc: cannot be written: File too large" in str(error), error
        else:
            raise SystemExit(f"no error at a limit of {limit} bytes")
        assert [p.name for p in folder.iterdir()] == ["run.nc"]
        assert file.read_bytes() == whole
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))
    result.save(file)
    assert file.read_bytes() == whole
"""


@pytest.mark.skipif(sys.platform == "win32", reason="the system limits no file sizes")
@pytest.mark.slow
def test_the_system_refuses_to_write(tmp_path: Path) -> None:
    """A real limit on file sizes, at many places, in a process of its own that must survive to its end."""
    code = textwrap.dedent(LIMITED)
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path)], capture_output=True, text=True, timeout=60, check=False)
    assert (done.returncode, done.stderr) == (0, "")
