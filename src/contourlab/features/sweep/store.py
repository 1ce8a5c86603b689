"""The store of a study: a folder with a manifest and one write-once Parquet file for each finished chunk.

The name of a file holds the number of its chunk and a digest of its bytes, so it is found, checked and copied without an index.
"""

from __future__ import annotations

import io
import json
import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from contourlab.app.results import lock
from contourlab.errors import OutputError, ResultError, refuse
from contourlab.extras import extra_module
from contourlab.features.sweep.chunk import STATUSES, Chunk
from contourlab.features.sweep.study import MOST, UNITS, Study
from contourlab.result.atomic import write_bytes_atomic
from contourlab.result.record import covered, digest, read_record, write_record
from contourlab.study.checkpoint import Parts, noted
from contourlab.study.design import DRAWN, FIXED, Chunked
from contourlab.threads import in_threads

AGAIN = "Repeat the command with --resume to continue"
MANIFEST, TIMES, LOCK = "manifest.json", "times.jsonl", ".lock"
SCHEMA, OLDER = "contourlab-sweep/2", "contourlab-sweep/1"
"""Form of a store, and the one before: its manifest had no digest, and the names of its files had the digest of their bytes alone."""
DIFFERENT = {
    "program": "another version of contourlab or its libraries",
    "scenario": "another machine, controller or motion",
    "study": "other distributions, design, seed or figures",
}
"""What differs between two stores, by the key of their identities."""


@dataclass(frozen=True)
class SavedStructure:
    """The choices of a structure by key, and its scenario as a file."""

    choices: dict[str, str | float]
    scenario: str


@dataclass(frozen=True)
class Manifest(Chunked):
    """What a store says of its study.

    Attributes
    ----------
    schema : str
        `SCHEMA` or `OLDER`.
    identity : dict of str to str
        A digest for each key of `DIFFERENT`.
    seed : int
    design : str
    variants, chunk, group : int
        Variants of the study, of a chunk, and number of successive variants that share a draw.
    tolerance : float [m] or None
    modules : dict of str to int
        Number of modules of each kind, by the column of their numbers.
    columns, figures : dict of str to str
        SI unit of each choice and parameter that varies, and of each figure.
    signals : list of str
    study : str
        The study file.
    structures : list of SavedStructure
    """

    schema: str
    identity: dict[str, str]
    seed: int
    design: str
    variants: int
    chunk: int
    tolerance: float | None
    group: int
    modules: dict[str, int]
    columns: dict[str, str]
    figures: dict[str, str]
    signals: list[str]
    study: str
    structures: list[SavedStructure]

    def __post_init__(self) -> None:
        counts = {"variants": self.variants, "chunk": self.chunk, "group": self.group, **self.modules}
        wrong = [name for name, count in counts.items() if not 1 <= count <= MOST]
        wrong += [name for name in ("figures", "structures") if not getattr(self, name)]
        wrong += [] if self.identity.keys() == DIFFERENT.keys() else ["identity"]
        wrong += [] if self.schema in (SCHEMA, OLDER) else ["schema"]
        wrong += [] if self.design in (*DRAWN, *FIXED, "search") else ["design"]
        refuse(wrong, ValueError, f"{', '.join(wrong)}: is not what was written")


def read_manifest(folder: Path) -> Manifest:
    """Read a manifest; check its digest and the type of each value.

    Raises
    ------
    ResultError
        If there is none, or it is damaged or edited; gives file and key.
    """
    file = folder / MANIFEST
    refuse(not file.is_file(), ResultError, f"{folder}: not a store of contourlab sweep: {MANIFEST} cannot be read")
    return read_record(file, Manifest, "restore the file, or run the study into another folder", OLDER)


@dataclass(eq=False)
class Store(Parts):
    """A folder with the results of a study: one Parquet file for each finished chunk, and perhaps one of signals.

    Attributes
    ----------
    home : Path
    manifest : Manifest
    parts : dict of int to Path
        File of each finished chunk.
    damaged : tuple of Path
        Files that are not those of this study and chunk as they were written.
    """

    home: Path
    manifest: Manifest
    parts: dict[int, Path] = field(default_factory=dict)
    damaged: tuple[Path, ...] = ()

    @property
    def done(self) -> int:
        """Variants in the store."""
        return sum(len(self.manifest.numbers(chunk)) for chunk in self.parts)

    @property
    def tolerance(self) -> float | None:
        """Tolerance [m] of the yield; None without one, and of a search, which has no yield."""
        return None if self.manifest.design == "search" else self.manifest.tolerance

    @cached_property
    def schema(self) -> Any:
        """Arrow schema of the rows."""
        arrow = extra_module("pyarrow")
        texts = {key for one in self.manifest.structures for key, label in one.choices.items() if isinstance(label, str)}
        fields = [arrow.field(name, arrow.int64()) for name in ("variant", *self.manifest.modules)]
        fields += [
            arrow.field(name, arrow.string() if name in texts else arrow.float64(), metadata={"unit": unit})
            for name, unit in {**self.manifest.columns, **self.manifest.figures}.items()
        ]
        ends = [("status", arrow.string(), ""), ("failed_at", arrow.float64(), "s"), ("unsure", arrow.int32(), "")]
        return arrow.schema([*fields, *(arrow.field(name, kind, metadata={"unit": unit}) for name, kind, unit in ends)])

    @property
    def dataset(self) -> Any:
        """The rows of all finished chunks as an Arrow dataset, in their order."""
        files = [str(self.parts[number]) for number in sorted(self.parts)]
        return extra_module("pyarrow.dataset").dataset(files, schema=self.schema, format="parquet")

    def table(self, chunk: Chunk) -> Any:
        """Return the rows of a chunk as an Arrow table; nan becomes null."""
        arrow = extra_module("pyarrow")
        columns = {**chunk.columns, "variant": np.array(self.manifest.numbers(chunk.number))}
        columns["status"] = np.array(STATUSES, dtype=object)[chunk.columns["status"]]
        arrays = [arrow.array(columns[field.name], from_pandas=True).cast(field.type) for field in self.schema]
        return arrow.Table.from_arrays(arrays, schema=self.schema)

    def write(self, chunk: Chunk) -> None:
        """Write a finished chunk, whole or not at all; its rows last, so that they mark it as finished.

        Raises
        ------
        OutputError
            If the folder cannot be written, or the disk is full.
        """
        parquet, buffer, key = extra_module("pyarrow.parquet"), io.BytesIO(), f"{chunk.number:06d}"
        try:
            if chunk.signals:
                self.put(key, self._signals(chunk), "nc", "signals")
            parquet.write_table(self.table(chunk), buffer, compression="zstd")
            self.parts[chunk.number] = self.put(key, buffer.getvalue(), "parquet")
        except OutputError as error:
            error.add_note(f"{len(self.parts)} finished chunks are kept. {AGAIN}.")
            raise

    def seal(self, key: str, data: bytes) -> str:
        """Return the digest in the name of a file: over study, number of the chunk and bytes."""
        return digest(data) if self.manifest.schema == OLDER else digest(covered(self.manifest.identity), str(int(key)).encode(), data)

    def fits(self, number: int, data: bytes) -> bool:
        """Return whether the bytes of a part hold the variants of a chunk, with the columns and units of the study."""
        arrow, parquet = extra_module("pyarrow"), extra_module("pyarrow.parquet")
        try:
            file = parquet.ParquetFile(arrow.BufferReader(data))
            if not file.schema_arrow.equals(self.schema, check_metadata=True):
                return False
            held = file.read(["variant"])["variant"].to_numpy()
        except (arrow.ArrowException, OSError):
            return False
        wanted = self.manifest.numbers(number)
        return bool(wanted) and np.array_equal(held, wanted)

    def _signals(self, chunk: Chunk) -> bytes:
        import xarray

        dims = ("variant", "sample", "axis")
        arrays = {name: (dims if values.shape[2] > 1 else dims[:2], np.squeeze(values, 2) if values.shape[2] == 1 else values)
                  for name, values in chunk.signals.items()}  # fmt: skip
        data = xarray.Dataset(arrays, {"variant": np.array(self.manifest.numbers(chunk.number))})
        try:
            with TemporaryDirectory() as folder:
                file = Path(folder) / "signals.nc"
                data.to_netcdf(file, engine="h5netcdf", encoding={key: {"zlib": True, "complevel": 1} for key in arrays})
                return file.read_bytes()
        except OSError as error:
            raise OutputError(f"{self.home}: the signals of a chunk cannot be written: {error.strerror or error}") from error

    def log(self, chunk: Chunk, elapsed: float) -> None:
        """Add the time of a chunk to the list of times, which no result depends on."""
        size = len(chunk.columns["status"])
        line = {"chunk": chunk.number, "variants": size, "elapsed": elapsed, "seconds": chunk.seconds, "cpu_seconds": chunk.cpu_seconds}
        with (self.home / TIMES).open("a", encoding="utf-8") as stream:
            stream.write(json.dumps(line) + "\n")

    def times(self) -> dict[str, float]:
        """Return the variants, elapsed time and processor time [s] of all lines of the list of times."""
        sums, lines = dict.fromkeys(("variants", "elapsed", "cpu_seconds"), 0.0), list[str]()
        with suppress(OSError):
            lines = (self.home / TIMES).read_text(encoding="utf-8").splitlines()
        for line in lines:
            with suppress(ValueError, KeyError, TypeError):  # cut off by a kill
                entry = json.loads(line)
                sums = {name: value + float(entry[name]) for name, value in sums.items()}
        return sums


# --- opening ---------------------------------------------------------------------------------------------------------------------------


def read_store(folder: str | Path, *, repair: bool = False) -> Store:
    """Open a store and check the bytes of all its files.

    Parameters
    ----------
    folder : str or Path
    repair : bool
        Whether damaged files count as not there, to be computed again.

    Raises
    ------
    ResultError
        If it is no store, a file is damaged, or a chunk has two files.
    """
    store = Store(Path(folder), read_manifest(Path(folder)))
    named = _numbered(store.home)
    faults = dict(zip(named, in_threads(lambda file: _fault(store, file, named[file]), named), strict=True))
    store.damaged = tuple(file for file, fault in faults.items() if fault)
    mend = "run the study into another folder" if store.manifest.schema == OLDER else "repeat the study with --resume"
    if store.damaged and not repair:
        raise ResultError(f"{store.damaged[0]}: {faults[store.damaged[0]]}: {mend}")
    kept = {number for file, number in named.items() if file.suffix == ".nc" and not faults[file]}
    for file, number in named.items():
        if faults[file] or file.suffix == ".nc":
            continue
        if number in store.parts:
            raise ResultError(f"{file}: chunk {number} is there twice, with different bytes: delete the file that is wrong")
        if not store.manifest.signals or number in kept:
            store.parts[number] = file
        elif not repair:
            raise ResultError(f"{file}: the signals of this chunk are missing: {mend}")
    return store


_NAME = re.compile(r"(?:part-(\d{6,})-[0-9a-f]{16}\.parquet|signals-(\d{6,})-[0-9a-f]{16}\.nc)\Z")


def _numbered(folder: Path) -> dict[Path, int]:
    """Return the files of a store in order, each with the number of its chunk, unchecked."""
    return {file: int(match[1] or match[2]) for file in sorted(folder.iterdir()) if (match := _NAME.match(file.name))}


def _fault(store: Store, file: Path, number: int) -> str:
    """Return what is wrong with a file; empty if nothing is."""
    if (data := store.content(file)) is None:
        return "is damaged, or belongs to another chunk or study"
    return "" if file.suffix == ".nc" or store.fits(number, data) else "does not hold the variants and columns of its chunk"


@contextmanager
def writing(folder: str | Path, study: Study, *, resume: bool) -> Iterator[Store]:
    """Open or create a store, for one writer at a time; an interrupt says what is kept.

    Parameters
    ----------
    folder : str or Path
        Created if missing.
    study : Study
    resume : bool
        Whether a store that is there goes on.

    Raises
    ------
    OutputError
        If the folder holds something else, another writer is at work, or it is there and `resume` is not set.
    ResultError
        If it is the store of another study.
    """
    path = Path(folder)
    check_folder(path, resume=resume)
    with locked(path):
        for left in path.glob(".*.part"):  # of a killed writer
            left.unlink(missing_ok=True)
        store = None
        if (path / MANIFEST).exists():
            store = read_store(path, repair=True)
            what, cure = f"{path}: is the store of another study", "Name another folder with --out."
            same_study(store.manifest.identity, study.identity, what, cure)
        manifest = manifest_of(study)  # comments and the tolerance may have changed
        write_record(path / MANIFEST, manifest)
        store = Store(path, manifest) if store is None else replace(store, manifest=manifest)
        with noted(lambda: f"{len(store.parts)} of {manifest.chunks} chunks are kept in {path}. {AGAIN}."):
            yield store


def check_folder(folder: str | Path, *, resume: bool) -> None:
    """Raise `OutputError` or `ResultError` if a folder cannot be that of a new store, or with `resume` of one to continue."""
    path = Path(folder)
    refuse(path.exists() and not path.is_dir(), OutputError, f"{path}: is a file; name a folder with --out")
    names = sorted(other.name for other in path.iterdir()) if path.is_dir() else []
    if MANIFEST not in names:
        if others := [name for name in names if name != TIMES and not name.startswith(".")]:
            raise OutputError(f"{path}: has other files, such as {others[0]}: name an empty or new folder with --out")
    elif not resume:
        raise OutputError(f"{path}: has a store: add --resume to continue it, or name another folder with --out")
    elif read_manifest(path).schema != SCHEMA:
        raise ResultError(f"{path}: is a store of an older version, which is only read: name another folder with --out")


def numbers_in(folder: str | Path) -> set[int]:
    """Return the numbers of the chunks in a folder by their files, unchecked."""
    path = Path(folder)
    return {number for file, number in _numbered(path).items() if file.suffix == ".parquet"} if path.is_dir() else set()


def manifest_of(study: Study) -> Manifest:
    """Return the manifest of a new store."""
    design, figures = study.design, {name: UNITS[name] for name in study.figures}
    modules = {one.column: one.count for one in design.modules}
    sizes = (design.variants, design.chunk, study.tolerance, design.group, modules)
    names = (dict(study.columns), figures, list(study.signals), study.text)
    structures = [SavedStructure(study.labels(combo), study.scenario(combo)) for combo in study.structures]
    return Manifest(SCHEMA, dict(study.identity), design.seed, design.kind, *sizes, *names, structures)


def same_study(mine: Mapping[str, str], other: Mapping[str, str], what: str, cure: str) -> None:
    """Raise `ResultError` if two identities differ; say in what."""
    for key, words in DIFFERENT.items():
        refuse(mine.get(key) != other.get(key), ResultError, f"{what}: {words}. {cure}")


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Hold the lock of a store while the block runs; create the folder if missing.

    Raises
    ------
    OutputError
        If another process holds it, or the folder cannot be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        stream = (folder / LOCK).open("ab")
    except OSError as error:
        raise OutputError(f"{folder}: cannot be written: {error.strerror or error}; choose another folder with --out") from error
    with stream:
        try:
            lock(stream)
        except BlockingIOError:
            raise OutputError(f"{folder}: another process writes into this store: wait for its end, or name another folder") from None
        except OSError:  # a file system without locks
            pass
        yield


def merge(folders: Iterable[str | Path], out: str | Path) -> Store:
    """Copy the chunks of several stores of one study into a new or the same store.

    Raises
    ------
    ResultError
        If a folder is no store or damaged, or the stores are not of one study, or disagree on a chunk
        or the tolerance.
    OutputError
        If the folder cannot be written, or holds something else.
    """
    stores = [read_store(folder) for folder in folders]
    first, path = stores[0], Path(out)
    for store in stores[1:]:
        cure = "Only stores of one study can be merged."
        same_study(first.manifest.identity, store.manifest.identity, f"{store.home}: differs from {first.home}", cure)
        if store.manifest.tolerance != first.manifest.tolerance:
            raise ResultError(f"{store.home}: has another tolerance than {first.home}: repeat its study with that one and --resume")
        if store.manifest.schema != first.manifest.schema:
            raise ResultError(f"{store.home}: comes from another version than {first.home}: repeat the study of the older one")
        for number in sorted(store.parts.keys() & first.parts.keys()):
            if store.parts[number].name != first.parts[number].name:
                raise ResultError(f"{store.parts[number]}: differs from {first.parts[number]}: one of them is wrong")
        first.parts = {**store.parts, **first.parts}
    refuse(path.exists() and (not path.is_dir() or any(path.iterdir())), OutputError, f"{path}: is not empty: name a new folder with --out")
    with locked(path):
        for number, file in first.parts.items():
            for source in (*file.parent.glob(f"signals-{number:06d}-*.nc"), file):
                write_bytes_atomic(path / source.name, source.read_bytes(), durable=True)
        for store in stores:
            if (store.home / TIMES).exists():
                with (path / TIMES).open("a", encoding="utf-8") as stream:
                    stream.write((store.home / TIMES).read_text(encoding="utf-8"))
        write_record(path / MANIFEST, first.manifest)
    return read_store(path)
