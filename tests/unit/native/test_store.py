"""The cache of machine code: what is filed comes back, and nothing that another user or a fault wrote is loaded."""

from __future__ import annotations

import logging
import os
import random
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from contourlab.native import store

PARTS = [b"symbol", b"", bytes(range(256)) * 20]
PLAN = "import contourlab as cl; case = cl.load_scenario('builtin:ghaffari/demo-stage').cases()[0]; print(case.reference().n_sample)"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A cache folder of its own, chosen as a user chooses it."""
    monkeypatch.setenv("CONTOURLAB_CACHE", str(tmp_path / "cache"))
    store.folder.cache_clear()
    store._warn.cache_clear()
    yield tmp_path / "cache"
    store.folder.cache_clear()


def warnings_of(caplog: pytest.LogCaptureFixture) -> int:
    return sum(record.levelno == logging.WARNING for record in caplog.records)


def test_parts_come_back_under_their_key_only(folder: Path) -> None:
    store.write("one", PARTS)
    assert store.read("one") == PARTS
    assert store.read("two") is None
    (folder / "one.code").replace(folder / "two.code")
    assert store.read("two") is None


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no owners on this system")
def test_the_folder_is_for_the_user_alone(folder: Path) -> None:
    store.write("one", PARTS)
    assert store.folder() == folder and folder.stat().st_mode & 0o777 == 0o700
    assert (folder / "one.code").stat().st_mode & 0o077 == 0


def test_a_thousand_flipped_bits_are_noticed(folder: Path, caplog: pytest.LogCaptureFixture) -> None:
    store.write("one", PARTS)
    good = (folder / "one.code").read_bytes()
    chance = random.Random(5)
    for place in chance.sample(range(8 * len(good)), 1000):
        damaged = bytearray(good)
        damaged[place // 8] ^= 1 << place % 8
        (folder / "one.code").write_bytes(damaged)
        assert store.read("one") is None
    assert warnings_of(caplog) == 1


@pytest.mark.parametrize("length", [0, 1, 26, 57, 58, 100, -1])
def test_a_truncated_file_is_noticed(folder: Path, length: int) -> None:
    store.write("one", PARTS)
    file = folder / "one.code"
    file.write_bytes(file.read_bytes()[:length])
    assert store.read("one") is None
    store.write("one", PARTS)
    assert store.read("one") == PARTS


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no owners on this system")
@pytest.mark.parametrize("fault", ["world-writable", "link", "foreign", "file"])
def test_an_unsafe_folder_gives_way_to_a_private_one(
    folder: Path, fault: str, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    if fault == "link":
        (folder.parent / "elsewhere").mkdir()
        folder.symlink_to(folder.parent / "elsewhere")
    elif fault == "file":
        folder.write_bytes(b"")
    else:
        folder.mkdir()
        folder.chmod(0o777 if fault == "world-writable" else 0o700)
    if fault == "foreign":
        monkeypatch.setattr(os, "geteuid", lambda: folder.stat().st_uid + 1)
    private = store.folder()
    assert private != folder and private.stat().st_mode & 0o777 == 0o700
    assert warnings_of(caplog) == 1
    private.rmdir()


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no owners on this system")
@pytest.mark.parametrize("fault", ["world-writable", "link", "pipe"])
def test_an_unsafe_file_is_not_read(folder: Path, fault: str) -> None:
    store.write("one", PARTS)
    file = folder / "one.code"
    if fault == "world-writable":
        file.chmod(0o666)
    else:
        file.replace(folder / "copy")
        file.symlink_to(folder / "copy") if fault == "link" else os.mkfifo(file)
    assert store.read("one") is None
    store.write("one", PARTS)
    assert store.read("one") == PARTS


@pytest.mark.slow
def test_two_processes_fill_an_empty_cache_at_once(folder: Path) -> None:
    environment = {**os.environ, "CONTOURLAB_CACHE": str(folder)}
    both = [subprocess.Popen([sys.executable, "-c", PLAN], env=environment, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    first, second = (process.communicate(timeout=300)[0] for process in both)
    assert first == second and int(first) > 0
    assert [process.returncode for process in both] == [0, 0]
    files = {file.name: file.read_bytes() for file in folder.iterdir()}
    assert files and all(name.endswith(".code") for name in files)
    # Damage all of it: a third process compiles again and ends alike.
    for name, content in files.items():
        (folder / name).write_bytes(content[:-1] + bytes([content[-1] ^ 1]))
    third = subprocess.run([sys.executable, "-c", PLAN], env=environment, capture_output=True, text=True, check=True)
    assert third.stdout == first and third.stderr.count("\n") == 1
