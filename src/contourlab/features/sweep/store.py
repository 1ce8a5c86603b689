"""The store of a study: a folder with a manifest and one write-once Parquet file for each finished chunk.

The name of a file holds the number of its chunk and a digest of its bytes, so it is found, checked and copied without an index.
"""

from __future__ import annotations

import hashlib
import io
import json
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from contourlab.app.results import lock
from contourlab.errors import OutputError, ResultError
from contourlab.extras import extra_module
from contourlab.features.sweep.chunk import STATUSES, Chunk
from contourlab.features.sweep.study import MOST, UNITS, Study
from contourlab.result import write_text_atomic
from contourlab.result.atomic import replacing, write_bytes_atomic
from contourlab.threads import in_threads

MANIFEST = "manifest.json"
SCHEMA, OLDER = "contourlab-sweep/2", "contourlab-sweep/1"
"""Form of a store, and the one before: its manifest had no digest, and the names of its files had the digest of their bytes alone."""
Count = Annotated[int, Field(ge=1, le=MOST)]


class _Strict(BaseModel):
    model_config = ConfigDict(strict=True, extra="forbid", allow_inf_nan=False)


class _Structure(_Strict):
    choices: dict[str, str | float]
    scenario: str


class _Manifest(_Strict):
    """Keys of a manifest, and their types."""

    form: Annotated[Literal["contourlab-sweep/1", "contourlab-sweep/2"], Field(alias="schema")]
    identity: Annotated[dict[Literal["program", "scenario", "study"], str], Field(min_length=3)]
    seed: int
    design: Literal["random", "sobol", "latin-hypercube", "saltelli", "grid", "list", "search"]
    variants: Count
    chunk: Count
    tolerance: float | None
    group: Count
    modules: dict[str, Count]
    columns: dict[str, str]
    figures: Annotated[dict[str, str], Field(min_length=1)]
    signals: list[str]
    study: str
    structures: Annotated[list[_Structure], Field(min_length=1)]
    digest: str | None = None


def digest(*parts: bytes) -> str:
    """Return a digest; only the last part may have line ends."""
    return hashlib.sha256(b"\n".join(parts)).hexdigest()[:16]


def content_of(fields: Mapping[str, Any]) -> bytes:
    """Return the bytes that a digest covers."""
    return json.dumps({key: value for key, value in fields.items() if key != "digest"}, sort_keys=True).encode()


def write_manifest(folder: Path, fields: Mapping[str, Any]) -> None:
    """Write a manifest with its digest.

    Raises
    ------
    OutputError
        If the folder cannot be written.
    """
    text = json.dumps({**fields, "digest": digest(content_of(fields))}, indent=1, allow_nan=False)
    write_text_atomic(folder / MANIFEST, text + "\n")


def read_manifest(folder: Path) -> dict[str, Any]:
    """Read a manifest; check its digest and the type of each value.

    Raises
    ------
    ResultError
        If there is none, or it is damaged or edited; gives file and key.
    """
    file, cure = folder / MANIFEST, "restore the file, or run the study into another folder"
    try:
        data = file.read_bytes()
        _Manifest.model_validate_json(data)
    except OSError as error:
        raise ResultError(f"{folder}: not a store of contourlab sweep: {MANIFEST} cannot be read") from error
    except ValidationError as error:
        fault = error.errors(include_url=False)[0]
        place = ".".join(map(str, fault["loc"]))
        raise ResultError(f"{file}: {place + ': ' if place else ''}{fault['msg']}: {cure}") from error
    fields: dict[str, Any] = json.loads(data)
    if fields["schema"] == SCHEMA and fields.get("digest") != digest(content_of(fields)):
        raise ResultError(f"{file}: was edited or is damaged: {cure}")
    return fields


TIMES, LOCK = "times.jsonl", ".lock"
_PART = re.compile(r"(part|signals)-(\d{6,})-([0-9a-f]{16})\.(parquet|nc)\Z")
DIFFERENT = {
    "program": "another version of contourlab or its libraries",
    "scenario": "another machine, controller or motion",
    "study": "other distributions, design, seed or figures",
}
"""What differs between two stores, by the key of their identities."""


@dataclass(eq=False)
class Store:
    """A folder with the results of a study.

    Attributes
    ----------
    folder : Path
    manifest : mapping
        ``schema``, ``study`` (text), ``identity``, ``variants``, ``chunk``, ``columns`` and ``figures`` with their units, ``signals``,
        ``tolerance``, ``modules`` with the number of each kind, ``group``, the number of successive variants that share a draw, and
        ``structures`` with the scenario of each.
    parts : dict of int to Path
        File of each finished chunk.
    damaged : tuple of Path
        Files that are not those of this study and chunk as they were written.
    """

    folder: Path
    manifest: Mapping[str, Any]
    parts: dict[int, Path] = field(default_factory=dict)
    damaged: tuple[Path, ...] = ()

    @property
    def variants(self) -> int:
        """Variants of the study."""
        return int(self.manifest["variants"])

    @property
    def chunks(self) -> int:
        """Chunks of the study."""
        return -(-self.variants // int(self.manifest["chunk"]))

    @property
    def done(self) -> int:
        """Variants in the store."""
        return sum(len(self.numbers(chunk)) for chunk in self.parts)

    def numbers(self, chunk: int) -> range:
        """Return the numbers of the variants of a chunk."""
        size = int(self.manifest["chunk"])
        return range(chunk * size, min((chunk + 1) * size, self.variants))

    @property
    def tolerance(self) -> float | None:
        """Tolerance [m] of the yield; None without one, and of a search, which has no yield."""
        return None if self.manifest["design"] == "search" else self.manifest["tolerance"]

    @property
    def figures(self) -> dict[str, str]:
        """SI unit of each figure."""
        return dict(self.manifest["figures"])

    @property
    def columns(self) -> dict[str, str]:
        """SI unit of each choice and parameter that varies."""
        return dict(self.manifest["columns"])

    @property
    def modules(self) -> dict[str, int]:
        """Number of modules of each kind, by the column of their numbers."""
        return dict(self.manifest["modules"])

    @cached_property
    def schema(self) -> Any:
        """Arrow schema of the rows."""
        arrow = extra_module("pyarrow")
        texts = {key for structure in self.manifest["structures"] for key, label in structure["choices"].items() if isinstance(label, str)}
        fields = [arrow.field(name, arrow.int64()) for name in ("variant", *self.modules)]
        for name, unit in {**self.columns, **self.figures}.items():
            fields.append(arrow.field(name, arrow.string() if name in texts else arrow.float64(), metadata={"unit": unit}))
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
        columns = {**chunk.columns, "variant": np.array(self.numbers(chunk.number))}
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
        parquet, buffer = extra_module("pyarrow.parquet"), io.BytesIO()
        try:
            if chunk.signals:
                self._write_signals(chunk)
            parquet.write_table(self.table(chunk), buffer, compression="zstd")
            file = self.folder / f"part-{chunk.number:06d}-{self.digest(chunk.number, buffer.getvalue())}.parquet"
            write_bytes_atomic(file, buffer.getvalue(), durable=True)
        except OutputError as error:
            error.add_note(f"{len(self.parts)} finished chunks are kept. Repeat the command with --resume to continue.")
            raise
        self.parts[chunk.number] = file
        for other in [*self.folder.glob(f"part-{chunk.number:06d}-*.parquet")]:
            if other != file:
                other.unlink()  # damaged

    def digest(self, number: int, data: bytes) -> str:
        """Return the digest in the name of a file: over study, number of the chunk and bytes."""
        is_older = self.manifest["schema"] == OLDER
        return digest(data) if is_older else digest(content_of(self.manifest["identity"]), b"%d" % number, data)

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
        wanted = self.numbers(number)
        return bool(wanted) and np.array_equal(held, wanted)

    def _write_signals(self, chunk: Chunk) -> None:
        import xarray

        for other in self.folder.glob(f"signals-{chunk.number:06d}-*.nc"):
            other.unlink()
        dims = ("variant", "sample", "axis")
        arrays = {name: (dims if values.shape[2] > 1 else dims[:2], np.squeeze(values, 2) if values.shape[2] == 1 else values)
                  for name, values in chunk.signals.items()}  # fmt: skip
        data = xarray.Dataset(arrays, {"variant": np.array(self.numbers(chunk.number))})
        with replacing(self.folder / f"signals-{chunk.number:06d}", durable=True) as temporary:
            data.to_netcdf(temporary, engine="h5netcdf", encoding={key: {"zlib": True, "complevel": 1} for key in arrays})
            name = f"signals-{chunk.number:06d}-{self.digest(chunk.number, temporary.read_bytes())}.nc"
        (self.folder / f"signals-{chunk.number:06d}").replace(self.folder / name)

    def log(self, chunk: Chunk, elapsed: float) -> None:
        """Add the time of a chunk to the list of times, which no result depends on."""
        size = len(chunk.columns["status"])
        line = {"chunk": chunk.number, "variants": size, "elapsed": elapsed, "seconds": chunk.seconds, "cpu_seconds": chunk.cpu_seconds}
        with (self.folder / TIMES).open("a", encoding="utf-8") as stream:
            stream.write(json.dumps(line) + "\n")

    def times(self) -> dict[str, float]:
        """Return the variants, elapsed time and processor time [s] of all lines of the list of times."""
        sums = dict.fromkeys(("variants", "elapsed", "cpu_seconds"), 0.0)
        try:
            lines = (self.folder / TIMES).read_text(encoding="utf-8").splitlines()
        except OSError:
            return sums
        for line in lines:
            try:
                entry = json.loads(line)
                sums = {name: value + float(entry[name]) for name, value in sums.items()}
            except (ValueError, KeyError, TypeError):  # cut off by a kill
                continue
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
    store.parts, store.damaged = _checked(store, repair)
    return store


def _checked(store: Store, repair: bool) -> tuple[dict[int, Path], tuple[Path, ...]]:
    """Return the intact parts by chunk, and the damaged files."""
    named = {path: match for path in store.folder.iterdir() if (match := _PART.match(path.name))}
    faults = dict(zip(named, in_threads(lambda path: _fault(store, path, named[path]), named), strict=True))
    damaged = tuple(sorted(path for path, fault in faults.items() if fault))
    mend = "run the study into another folder" if store.manifest["schema"] == OLDER else "repeat the study with --resume"
    if damaged and not repair:
        raise ResultError(f"{damaged[0]}: {faults[damaged[0]]}: {mend}")
    kept = {int(match[2]) for path, match in named.items() if match[1] == "signals" and not faults[path]}
    parts: dict[int, Path] = {}
    for path in sorted(path for path, match in named.items() if match[1] == "part" and not faults[path]):
        number = int(named[path][2])
        if number in parts:
            raise ResultError(f"{path}: chunk {number} is there twice, with different bytes: delete the file that is wrong")
        if not store.manifest["signals"] or number in kept:
            parts[number] = path
        elif not repair:
            raise ResultError(f"{path}: the signals of this chunk are missing: {mend}")
    return parts, damaged


def _fault(store: Store, path: Path, name: re.Match[str]) -> str:
    """Return what is wrong with a file; empty if nothing is."""
    data, number = path.read_bytes(), int(name[2])
    if store.digest(number, data) != name[3]:
        return "is damaged, or belongs to another chunk or study"
    return "" if name[1] == "signals" or store.fits(number, data) else "does not hold the variants and columns of its chunk"


@contextmanager
def writing(folder: str | Path, study: Study, structures: Callable[[], Sequence[Mapping[str, Any]]], *, resume: bool) -> Iterator[Store]:
    """Open or create a store, for one writer at a time.

    Parameters
    ----------
    folder : str or Path
        Created if missing.
    study : Study
    structures : callable
        Returns choices and scenario of each structure.
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
        if (path / MANIFEST).exists():
            store = read_store(path, repair=True)
            what, cure = f"{path}: is the store of another study", "Name another folder with --out."
            same_study(store.manifest["identity"], study.identity, what, cure)
        else:
            store = Store(path, {})
        store.manifest = manifest_of(study, structures())  # comments and the tolerance may have changed
        write_manifest(path, store.manifest)
        yield store


def check_folder(folder: str | Path, *, resume: bool) -> None:
    """Raise `OutputError` or `ResultError` if a folder cannot be that of a new store, or with `resume` of one to continue."""
    path = Path(folder)
    if path.exists() and not path.is_dir():
        raise OutputError(f"{path}: is a file; name a folder with --out")
    held = (MANIFEST, TIMES, LOCK)
    others = [other.name for other in path.iterdir() if other.name not in held and not other.name.startswith(".")] if path.is_dir() else []
    if not (path / MANIFEST).exists() and others:
        raise OutputError(f"{path}: has other files, such as {sorted(others)[0]}: name an empty or new folder with --out")
    if (path / MANIFEST).exists() and not resume:
        raise OutputError(f"{path}: has a store: add --resume to continue it, or name another folder with --out")
    if (path / MANIFEST).exists() and read_manifest(path)["schema"] != SCHEMA:
        raise ResultError(f"{path}: is a store of an older version, which is only read: name another folder with --out")


def numbers_in(folder: str | Path) -> set[int]:
    """Return the numbers of the chunks in a folder by their files, unchecked."""
    path = Path(folder)
    return {int(match[2]) for file in (path.iterdir() if path.is_dir() else ()) if (match := _PART.match(file.name)) and match[1] == "part"}


def manifest_of(study: Study, structures: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Return the manifest of a new store."""
    return {
        "schema": SCHEMA,
        "identity": dict(study.identity),
        "seed": study.design.seed,
        "design": study.design.kind,
        "variants": study.design.variants,
        "chunk": study.design.chunk,
        "tolerance": study.tolerance,
        "group": study.design.group,
        "modules": {one.column: one.count for one in study.design.modules},
        "columns": dict(study.columns),
        "figures": {name: UNITS[name] for name in study.figures},
        "signals": list(study.signals),
        "study": study.text,
        "structures": list(structures),
    }


def same_study(mine: Mapping[str, str], other: Mapping[str, str], what: str, cure: str) -> None:
    """Raise `ResultError` if two identities differ; say in what."""
    for key, words in DIFFERENT.items():
        if mine.get(key) != other.get(key):
            raise ResultError(f"{what}: {words}. {cure}")


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
        same_study(first.manifest["identity"], store.manifest["identity"], f"{store.folder}: differs from {first.folder}", cure)
        if store.manifest["tolerance"] != first.manifest["tolerance"]:
            raise ResultError(f"{store.folder}: has another tolerance than {first.folder}: repeat its study with that one and --resume")
        if store.manifest["schema"] != first.manifest["schema"]:
            raise ResultError(f"{store.folder}: comes from another version than {first.folder}: repeat the study of the older one")
        for number in sorted(store.parts.keys() & first.parts.keys()):
            if store.parts[number].name != first.parts[number].name:
                raise ResultError(f"{store.parts[number]}: differs from {first.parts[number]}: one of them is wrong")
        first.parts.update({number: file for number, file in store.parts.items() if number not in first.parts})
    if path.exists() and (not path.is_dir() or any(path.iterdir())):
        raise OutputError(f"{path}: is not empty: name a new folder with --out")
    with locked(path):
        for number, file in first.parts.items():
            for source in (*file.parent.glob(f"signals-{number:06d}-*.nc"), file):
                write_bytes_atomic(path / source.name, source.read_bytes(), durable=True)
        for store in stores:
            if (store.folder / TIMES).exists():
                with (path / TIMES).open("a", encoding="utf-8") as stream:
                    stream.write((store.folder / TIMES).read_text(encoding="utf-8"))
        write_manifest(path, first.manifest)
    return read_store(path)
