"""Finished work stays: the contract of stores, checkpoints by which the same command continues, and records that are read back."""

from __future__ import annotations

import hashlib
import io
import json
import re
import zipfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager, suppress
from dataclasses import asdict, dataclass, field, is_dataclass
from functools import cache
from importlib.metadata import version
from pathlib import Path
from types import UnionType
from typing import Any, TypeVar, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import ResultError, error_text
from contourlab.findings import Finding, finding
from contourlab.result.atomic import write_bytes_atomic, write_text_atomic

RecordT = TypeVar("RecordT")
_ROOMS = ("native", "primitives", "geometry", "feed", "engine", "components", "metrics", "loop")
"""Rooms whose source affects the figures of a run."""


def digest(*parts: bytes) -> str:
    """Return a digest; only the last part may have line ends."""
    return hashlib.sha256(b"\n".join(parts)).hexdigest()[:16]


class Parts:
    """Finished work in a folder, in parts that are written once: what every store promises.

    A part appears whole or not at all, and its file is the only record of it. The name of the file holds the key of the part, and a
    digest of the study, the key and the bytes. So a damaged file, a part of another study and one under another key are found without an
    index, and stores merge by copying.

    Attributes
    ----------
    home : Path
        The folder; created with the first part.
    """

    home: Path

    def seal(self, key: str, data: bytes) -> str:
        """Return the digest of study, key and bytes in the name of a file; by default the folder is named by its study."""
        return digest(self.home.name.encode(), key.encode(), data)

    def files(self, kind: str = "*", key: str = "*") -> list[Path]:
        """Return the files of a kind and of a key; by default all."""
        return sorted(file for file in self.home.glob(f"{kind}-{key}-*") if _NAME.fullmatch(file.name))

    def content(self, file: Path) -> bytes | None:
        """Return the bytes of a part; None if they are damaged, or those of another study or key."""
        _, key, seal = file.stem.split("-")
        with suppress(OSError):
            data = file.read_bytes()
            if self.seal(key, data) == seal:
                return data
        return None

    def put(self, key: str, data: bytes, ending: str, kind: str = "part") -> Path:
        """Write a part, whole or not at all, in place of damaged ones; return its file.

        Raises
        ------
        OutputError
            If the folder cannot be written, or the disk is full.
        """
        file = self.home / f"{kind}-{key}-{self.seal(key, data)}.{ending}"
        write_bytes_atomic(file, data, durable=True)
        for other in self.files(kind, key):
            if other != file:
                other.unlink(missing_ok=True)
        return file


_NAME = re.compile(r"[a-z]+-[0-9a-f]{6,32}-[0-9a-f]{16}\.[a-z]+")


@dataclass(eq=False)
class Checkpoint(Parts):
    """Arrays of finished pieces, in one sub-folder per study.

    Parameters
    ----------
    folder : Path
    study : str
        Everything that affects the pieces, except the key of each piece. Pieces of another study are never used.
    reused, damaged : int
        Number of pieces read from disk, and of damaged files, whose pieces are computed again.
    """

    folder: Path
    study: str
    reused: int = field(default=0, init=False)
    damaged: int = field(default=0, init=False)

    def __post_init__(self) -> None:
        self.home = self.folder / hashlib.sha256(self.study.encode()).hexdigest()[:16]

    @property
    def others(self) -> int:
        """Number of other studies with pieces in the folder."""
        return sum(path != self.home and path.is_dir() for path in self.folder.glob("?" * 16))

    def once(self, path: Path, make: Callable[[], Mapping[str, ArrayLike]]) -> tuple[dict[str, NDArray[Any]], bool]:
        """Return the arrays of a piece, made and stored if they are not there yet, and whether they were there."""
        if (arrays := self.load(path)) is not None:
            return arrays, True
        arrays = {name: np.asarray(values) for name, values in make().items()}
        self.store(path, arrays)
        return arrays, False

    def path(self, *key: bytes) -> Path:
        """Return the path of a piece, without the digest of its bytes."""
        return self.home / f"part-{hashlib.sha256(b''.join(key)).hexdigest()[:32]}"

    def load(self, path: Path) -> dict[str, NDArray[Any]] | None:
        """Return the arrays of a piece; None if there is no file, or it is damaged or another piece."""
        for file in self.files(*path.name.split("-")):
            # From a damaged file NumPy may return wrong values: it does not check all that it reads.
            if (data := self.content(file)) is not None:
                with suppress(ValueError, OSError, EOFError, zipfile.BadZipFile):  # not written by us, with a digest nonetheless
                    with np.load(io.BytesIO(data), allow_pickle=False) as held:
                        arrays = dict(held)
                    self.reused += 1
                    return arrays
            self.damaged += 1
        return None

    def store(self, path: Path, arrays: Mapping[str, ArrayLike]) -> Path:
        """Write the arrays of a piece, completely or not at all; return their file."""
        buffer = io.BytesIO()
        np.savez(buffer, allow_pickle=False, **{name: np.asarray(values) for name, values in arrays.items()})
        return self.put(path.name.partition("-")[2], buffer.getvalue(), "npz")

    def findings(self, pieces: str, reused: int | None = None) -> tuple[Finding, ...]:
        """Return the findings on reused, damaged and other studies' pieces; `reused` replaces the number of files read."""
        count = self.reused if reused is None else reused
        found = [finding("CL900", pieces=pieces, count=count, folder=str(self.home))] if count else []
        found += [finding("CL901", pieces=pieces, folder=str(self.folder))] if self.others else []
        found += [finding("CL902", pieces=pieces, count=self.damaged)] if self.damaged else []
        return tuple(found)


# --- records: JSON files that are read back ---------------------------------------------------------------------------------------------


def covered(fields: Mapping[str, Any]) -> bytes:
    """Return the bytes that the digest of a record covers."""
    return json.dumps(fields, sort_keys=True).encode()


def write_record(file: Path, record: Any) -> None:
    """Write the fields of a dataclass and a digest of them; its field ``schema`` holds form and version.

    Raises
    ------
    OutputError
        If the file cannot be written.
    """
    fields = asdict(record)
    write_text_atomic(file, json.dumps({**fields, "digest": digest(covered(fields))}, indent=1, allow_nan=False) + "\n")


def read_record(file: Path, kind: type[RecordT], cure: str, older: str = "") -> RecordT:
    """Read what `write_record` wrote; check the digest and the type of each value. The form `older` has no digest.

    Raises
    ------
    ResultError
        If the file is not there, damaged or edited; gives file and key.
    """
    try:
        fields = json.loads(file.read_bytes(), parse_constant=_refused)
        seal = fields.pop("digest", None) if isinstance(fields, dict) else None
        record: RecordT = typed(fields, kind)
        if fields["schema"] != older and seal != digest(covered(fields)):
            raise ValueError("was edited or is damaged")
    except (OSError, ValueError, ArithmeticError, RecursionError) as error:
        raise ResultError(f"{file}: {error_text(error)}: {cure}") from error
    return record


def _refused(word: str) -> None:
    raise ValueError(f"{word} is not a number of JSON")


def typed(value: Any, kind: Any, place: str = "") -> Any:
    """Return a value of JSON as one of a type: a dataclass, a dict, a list, or plain types.

    Raises
    ------
    ValueError
        If it is not of this type; gives the key.
    """
    origin, inner = get_origin(kind), get_args(kind)
    plain = inner if origin is UnionType else (kind,)
    if isinstance(kind, type) and is_dataclass(kind):
        hints = get_type_hints(kind)
        if type(value) is dict:
            if wrong := sorted(value.keys() ^ hints.keys()):
                raise ValueError(f"{place}{', '.join(wrong)}: is missing or unknown")
            return kind(**{name: typed(value[name], hint, f"{place}{name}: ") for name, hint in hints.items()})
    elif origin is dict and type(value) is dict:
        return {key: typed(item, inner[1], f"{place}{key}: ") for key, item in value.items()}
    elif origin in (list, tuple) and type(value) is list:
        return origin(typed(item, inner[0], place) for item in value)
    elif type(value) in plain:
        return value
    elif type(value) is int and float in plain:
        return float(value)
    raise ValueError(f"{place}is not what was written")


# --- interrupts ------------------------------------------------------------------------------------------------------------------------


@contextmanager
def noted(note: Callable[[], str]) -> Iterator[None]:
    """If the block is interrupted, add a note, if there is one, to the interrupt."""
    try:
        yield
    except KeyboardInterrupt as stop:
        if text := note():
            stop.add_note(text)
        raise


def said_if_interrupted(results: Callable[[], str]) -> AbstractContextManager[None]:
    """If the block is interrupted, add the text of the results so far, if any, to the interrupt."""
    return noted(lambda: f"Finished before; no file is written:\n\n{text}" if (text := results()) else "")


def resumable(folder: Path, pieces: str) -> AbstractContextManager[None]:
    """If the block is interrupted and `folder` has pieces, add a note to the interrupt: the same command continues."""
    kept = f"The finished {pieces} are kept in {folder}. Run the same command again to continue."
    return noted(lambda: kept if any(folder.glob("*/*.npz")) else "")


def program_text(*rooms: str) -> str:
    """Return `program_identity` and the version of scipy as one line."""
    return "; ".join([*program_identity(rooms), f"scipy {version('scipy')}"])


@cache
def program_identity(rooms: tuple[str, ...]) -> list[str]:
    """Return the versions of contourlab, cma and numpy, and a digest of the source of a run's rooms and of further ones."""
    import contourlab

    root, digest = Path(contourlab.__file__).parent, hashlib.sha256()
    for room in (*_ROOMS, *rooms):
        single = root / f"{room}.py"
        for file in [single] if single.exists() else sorted((root / room).rglob("*.py")):
            digest.update(file.relative_to(root).as_posix().encode() + b"\0" + file.read_bytes())
    return [f"contourlab {contourlab.__version__} {digest.hexdigest()}", *(f"{name} {version(name)}" for name in ("cma", "numpy"))]
