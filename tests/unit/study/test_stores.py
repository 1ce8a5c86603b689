"""What every store of finished work promises, asked of each form: checkpoints of arrays, and the store of a sweep."""

from __future__ import annotations

import errno
import os
import shutil
from pathlib import Path

import numpy as np
import pytest

from contourlab.errors import OutputError
from contourlab.features.sweep.chunk import Chunk
from contourlab.features.sweep.store import SCHEMA, Manifest, SavedStructure, Store, read_store
from contourlab.result.record import write_record
from contourlab.study.checkpoint import Checkpoint, Parts

KEYS = (0, 1, 2)
SIZE = 8


class OfArrays:
    """A checkpoint; its pieces are read when they are asked for."""

    def open(self, folder: Path, study: str) -> Parts:
        return Checkpoint(folder, study)

    def put(self, store: Parts, key: int, values: np.ndarray) -> None:
        assert isinstance(store, Checkpoint)
        store.store(store.path(b"%d" % key), {"values": values})

    def get(self, store: Parts, key: int) -> np.ndarray | None:
        assert isinstance(store, Checkpoint)
        arrays = store.load(store.path(b"%d" % key))
        return None if arrays is None else arrays["values"]


class OfSweep:
    """A store of a sweep; all its parts are checked when it is opened."""

    def open(self, folder: Path, study: str) -> Parts:
        identity = dict.fromkeys(("program", "scenario", "study"), study)
        units = ({}, {"a": "m"}, {"f": "m"})
        made = Manifest(SCHEMA, identity, 0, "random", 3 * SIZE, SIZE, None, 1, *units, [], "", [SavedStructure({}, "")])
        write_record(folder / "manifest.json", made)
        return read_store(folder, repair=True)

    def put(self, store: Parts, key: int, values: np.ndarray) -> None:
        assert isinstance(store, Store)
        none = dict.fromkeys(("f", "failed_at"), np.full(SIZE, np.nan))
        store.write(Chunk(key, {"a": values, **none, "status": np.zeros(SIZE, int), "unsure": np.zeros(SIZE)}, {}, 0.0, 0.0))

    def get(self, store: Parts, key: int) -> np.ndarray | None:
        import pyarrow.parquet

        assert isinstance(store, Store)
        parts = read_store(store.home, repair=True).parts
        return pyarrow.parquet.read_table(parts[key])["a"].to_numpy() if key in parts else None


@pytest.fixture(params=[OfArrays, OfSweep])
def form(request: pytest.FixtureRequest) -> OfArrays | OfSweep:
    made: OfArrays | OfSweep = request.param()
    return made


def values(key: int) -> np.ndarray:
    """Return the content of a part."""
    return np.random.default_rng(key).standard_normal(SIZE)


class TestStore:
    """The contract."""

    @pytest.fixture
    def store(self, form: OfArrays | OfSweep, tmp_path: Path) -> Parts:
        return form.open(tmp_path / "one", "one")

    @pytest.fixture
    def full(self, form: OfArrays | OfSweep, store: Parts) -> Parts:
        for key in KEYS:
            form.put(store, key, values(key))
        return store

    def held(self, form: OfArrays | OfSweep, store: Parts) -> list[int]:
        """Return the keys of the parts that are there, and check each."""
        found = {key: form.get(store, key) for key in KEYS}
        for key, content in found.items():
            assert content is None or content.tobytes() == values(key).tobytes()
        return [key for key in KEYS if found[key] is not None]

    def test_a_part_is_read_back_bit_by_bit_also_by_the_next_process(self, form: OfArrays | OfSweep, store: Parts, tmp_path: Path) -> None:
        assert self.held(form, store) == []
        for key in KEYS:
            form.put(store, key, values(key))
            assert self.held(form, store) == list(range(key + 1))
        assert self.held(form, form.open(tmp_path / "one", "one")) == [*KEYS]

    def test_equal_work_gives_equal_files(self, form: OfArrays | OfSweep, full: Parts, tmp_path: Path) -> None:
        again = form.open(tmp_path / "again", "one")
        for key in reversed(KEYS):
            form.put(again, key, values(key))
        assert [file.name for file in again.files()] == [file.name for file in full.files()]
        assert len(full.files()) == len(KEYS)

    def test_no_flipped_bit_and_no_cut_is_accepted_and_the_part_is_written_again(self, form: OfArrays | OfSweep, full: Parts) -> None:
        name = next(file for file in full.files() if self._key(form, full, file) == 1)
        whole = name.read_bytes()
        flipped = (self._flipped(whole, bit) for bit in range(0, 8 * len(whole), 7))
        for damaged in (*flipped, b"", whole[:10], whole[:-1], whole + b" "):
            name.write_bytes(damaged)
            assert full.content(name) is None
        assert self.held(form, full) == [0, 2]
        form.put(full, 1, values(1))
        assert self.held(form, full) == [*KEYS] and name.read_bytes() == whole

    def _flipped(self, whole: bytes, bit: int) -> bytes:
        data = bytearray(whole)
        data[bit // 8] ^= 1 << bit % 8
        return bytes(data)

    def _key(self, form: OfArrays | OfSweep, store: Parts, file: Path) -> int:
        hidden = file.with_name("hidden")
        file.replace(hidden)
        (key,) = set(KEYS) - set(self.held(form, store))
        hidden.replace(file)
        return key

    def test_a_part_of_another_key_or_study_is_not_used(self, form: OfArrays | OfSweep, full: Parts, tmp_path: Path) -> None:
        other = form.open(tmp_path / "two", "two")
        form.put(other, 1, values(1))
        (stranger,) = other.files()
        first, second = (next(file for file in full.files() if self._key(form, full, file) == key) for key in (0, 1))
        second.unlink()
        shutil.copy(stranger, full.home / stranger.name)
        assert self.held(form, full) == [0, 2]
        shutil.copy(first, full.home / first.name.replace(first.name.split("-")[1], second.name.split("-")[1]))
        assert self.held(form, full) == [0, 2]
        form.put(full, 1, values(1))
        assert self.held(form, full) == [*KEYS] and len(full.files()) == len(KEYS)

    def test_a_full_disk_leaves_what_is_finished_and_nothing_else(
        self, form: OfArrays | OfSweep, store: Parts, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        form.put(store, 0, values(0))
        before, write = sorted(store.home.iterdir()), Path.write_bytes

        def fails(path: Path, data: bytes) -> int:
            write(path, data[: len(data) // 2])
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

        with monkeypatch.context() as patch, pytest.raises(OutputError):
            patch.setattr(Path, "write_bytes", fails)
            form.put(store, 1, values(1))
        assert sorted(store.home.iterdir()) == before and self.held(form, store) == [0]

    def test_stores_merge_by_copying(self, form: OfArrays | OfSweep, full: Parts, tmp_path: Path) -> None:
        half, rest, both = (form.open(tmp_path / name, "one") for name in ("half", "rest", "both"))
        for part, keys in ((half, KEYS[:2]), (rest, KEYS[1:])):
            for key in keys:
                form.put(part, key, values(key))
            both.home.mkdir(exist_ok=True, parents=True)
            for file in part.files():
                shutil.copy(file, both.home)
        assert self.held(form, both) == [*KEYS] and len(both.files()) == len(full.files())
